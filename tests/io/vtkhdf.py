"""Reads a VTKHDF 2.0 time series of an unstructured grid by the arithmetic of VTK's own reader, part by
part."""

import h5py
import numpy as np


class Reader:
    """An open file. Nothing of it is known but the format: all offsets come from the file."""

    def __init__(self, path):
        self.file = h5py.File(path, "r")
        self.root = self.file["VTKHDF"]
        self.step_data = self.root["Steps"]
        assert list(self.root.attrs["Version"]) == [2, 0]
        kind = self.root.attrs.get_id("Type").get_type()
        assert (
            isinstance(kind, h5py.h5t.TypeStringID) and not kind.is_variable_str()
        ), "older readers need a string of fixed length"
        assert self.root.attrs["Type"] == b"UnstructuredGrid"
        self.steps = int(self.step_data.attrs["NSteps"])
        # VTK copies all of Values into memory for NSteps numbers, if there are several.
        self.surplus_times = max(len(self.step_data["Values"]) - max(self.steps, 1), 0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()

    def frame(self, step):
        """(time, parts) of a step; a part is a dictionary of points, quads, point_data and cell_data."""
        steps = self.step_data
        first_part = int(steps["PartOffsets"][step])
        starts = [
            int(np.ravel(steps[name][step])[0])
            for name in ("PointOffsets", "CellOffsets", "ConnectivityIdOffsets")
        ]
        counts = range(first_part, first_part + int(steps["NumberOfParts"][step]))
        points, cells, ids = (
            self.root[name][counts.start : counts.stop]
            for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds")
        )
        parts = []
        for part in range(len(counts)):
            before = [int(sum(values[:part])) for values in (points, cells, ids)]
            # Each part before this one has one entry of Offsets more than it has cells.
            offset_row = starts[1] + first_part + part + before[1]
            parts.append(
                {
                    "points": self.rows("Points", starts[0] + before[0], points[part]),
                    "quads": self.quads(
                        offset_row, cells[part], starts[2] + before[2], ids[part], starts[1] + before[1]
                    ),
                    "point_data": self.arrays("Point", step, before[0], points[part]),
                    "cell_data": self.arrays("Cell", step, before[1], cells[part]),
                }
            )
        return float(steps["Values"][step]), parts

    def rows(self, name, first, count):
        """Rows of a dataset; a hole at its end is an error, as it is for VTK."""
        values = self.root[name][first : first + count]
        assert len(values) == count, f"{name} ends before row {first + count}"
        return values

    def quads(self, offset_row, cells, id_row, ids, type_row):
        """Corner indices of a part's cells, within the part."""
        offsets = self.rows("Offsets", offset_row, cells + 1)
        connectivity = self.rows("Connectivity", id_row, ids)
        assert np.all(self.rows("Types", type_row, cells) == 9)
        assert offsets[0] == 0 and offsets[-1] == ids and np.all(np.diff(offsets) == 4)
        return connectivity.reshape(-1, 4)

    def arrays(self, kind, step, before, count):
        """All arrays of one kind: their own offset of the step, then past the parts before."""
        group = self.root[f"{kind}Data"]
        offsets = self.step_data[f"{kind}DataOffsets"]
        assert set(group) == set(offsets), "arrays without offsets crash ParaView"
        return {
            name: self.rows(f"{kind}Data/{name}", int(offsets[name][step]) + before, count) for name in group
        }
