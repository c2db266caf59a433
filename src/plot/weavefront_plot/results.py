"""results.vtkhdf, read frame by frame: part 0 is the fabric, part 1 the projectile's surface."""
import re
from dataclasses import dataclass

import h5py
import numpy as np

from .failure import FileError, InputError

HIDDEN = 32  # bit of vtkGhostType on eroded cells


@dataclass
class Mesh:
    """Points in m [n, 3] and the quads between them [c, 4]."""

    points: np.ndarray
    quads: np.ndarray


class Results:
    """An open results file. Only complete frames count, so a killed or running run can be read."""

    def __init__(self, path):
        self.path = path
        if not path.is_file():
            raise FileError(f"{path}: no such file")
        try:
            self.file = h5py.File(path, "r")
            self.root = self.file["VTKHDF"]
            self.steps = self.root["Steps"]
            self.times = self.steps["Values"][: int(self.steps.attrs["NSteps"])]
            self.points_of_part = self.root["NumberOfPoints"][:].astype(int)
            self.cells_of_part = self.root["NumberOfCells"][:].astype(int)
            self.parts = [self._quads(part) for part in range(len(self.cells_of_part))]
        except OSError:
            raise FileError(f"{path}: not a readable HDF5 file") from None
        except KeyError as error:
            raise InputError(f"{path}: not results of weavefront: {error.args[0]}") from None
        if len(self.times) == 0:
            raise InputError(f"{path}: no complete frame yet")
        if len(self.times) < int(self.steps.attrs["NSteps"]):
            raise InputError(f"{path}: fewer times than frames")
        self.scene = self._scene()
        self.reference = self.points(0) - self.displacement(0)
        self.ply = self.cells("ply", 0).astype(int)
        self.symmetry = self._symmetry()

    def _quads(self, part):
        cells = self.cells_of_part
        ids = self.root["NumberOfConnectivityIds"][:].astype(int)
        nodes = self.root["Connectivity"][ids[:part].sum() :][: ids[part]].astype(int)
        offsets = self.root["Offsets"][cells[:part].sum() + part :][: cells[part] + 1].astype(int)
        corners = np.diff(offsets)
        if np.any((corners != 3) & (corners != 4)):
            raise InputError(f"{self.path}: part {part} has cells that are neither quads nor triangles")
        return nodes[offsets[:-1, None] + np.minimum(np.arange(4), corners[:, None] - 1)]  # a triangle repeats its last node

    def _scene(self):
        if "scene" not in self.file:
            return ""
        value = self.file["scene"][()]
        return (value if isinstance(value, bytes) else np.asarray(value).tobytes()).decode("utf-8", "replace")

    def _symmetry(self):
        """Whether only x >= 0, y >= 0 is modelled."""
        match = re.search(r"^\s*symmetry:[ \t]*(.*(?:\n\s*- *[xy]\b)*)", self.scene, re.MULTILINE)
        if match:
            names = re.findall(r"\b[xy]\b", match[1].split("#")[0])
            return ("x" in names, "y" in names)
        lowest, highest = self.reference.min(axis=0), self.reference.max(axis=0)
        return tuple(bool(lowest[axis] > -1e-6 * highest[axis]) for axis in (0, 1))

    def _read(self, dataset, start, counts, part):
        first = start + counts[:part].sum()
        values = dataset[first : first + counts[part]]
        if len(values) != counts[part]:
            raise InputError(f"{self.path}: {dataset.name} ends before its last frame")
        return values

    def points(self, step, part=0):
        """Positions in m [n, 3]."""
        return self._read(self.root["Points"], int(self.steps["PointOffsets"][step]), self.points_of_part, part)

    def displacement(self, step):
        """Displacement of the fabric's nodes in m [n, 3]."""
        if "displacement" in self.root["PointData"]:
            start = int(self.steps["PointDataOffsets/displacement"][step])
            return self._read(self.root["PointData/displacement"], start, self.points_of_part, 0)
        return self.points(step) - self.points(0)

    def cells(self, name, step):
        """One array of the fabric's cells [c]."""
        if name not in self.arrays():
            raise InputError(f"{self.path}: no cell array '{name}'; it has {', '.join(self.arrays())}")
        offsets = self.steps["CellDataOffsets"]
        start = int(offsets[name][step]) if name in offsets else 0
        return self._read(self.root["CellData"][name], start, self.cells_of_part, 0)

    def arrays(self):
        """Names of the cell arrays that can be shown."""
        return sorted(name for name in self.root.get("CellData", {}) if name != "vtkGhostType")

    def alive(self, step):
        """Which elements are not eroded [c]."""
        if "vtkGhostType" not in self.root["CellData"]:
            return np.ones(self.cells_of_part[0], dtype=bool)
        start = int(self.steps["CellDataOffsets/vtkGhostType"][step])
        return (self._read(self.root["CellData/vtkGhostType"], start, self.cells_of_part, 0) & HIDDEN) == 0

    def projectile(self, step):
        """The projectile's surface, or None."""
        if len(self.parts) < 2 or len(self.parts[1]) == 0:
            return None
        return Mesh(self.points(step, 1), self.parts[1])

    def field(self, name, step):
        """A cell array; `stress` and `strain` are the greater of fill and warp, `height` the deflection."""
        if name == "height":
            return self.displacement(step)[self.parts[0], 2].mean(axis=1)
        if name in ("stress", "strain") and name not in self.arrays():
            return np.maximum(self.cells(f"{name}_fill", step), self.cells(f"{name}_warp", step))
        values = self.cells(name, step)
        if values.ndim != 1:
            raise InputError(f"--field: '{name}' has {values.shape[1]} components, one can be shown")
        return values

    def default_field(self):
        """Yarn stress, or what comes closest among the arrays that the scene asked for."""
        for name in ("stress", "strain"):
            if {f"{name}_fill", f"{name}_warp"} <= set(self.arrays()):
                return name
        return "height"
