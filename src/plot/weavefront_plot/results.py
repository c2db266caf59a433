"""results.vtkhdf, read frame by frame: part 0 is the fabric, part 1 the projectiles' surfaces."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .failure import InputError
from .hdf5_reader import INTEGER, NUMBER, Hdf5Reader
from .scene_text import symmetry_of

HIDDEN = 32  # bit of vtkGhostType on eroded cells
FARTHEST = 1e6  # m, of a point
LATEST = 1e6  # s
PARTS, MOST = 1000, 1 << 40  # parts of the grid; rows of a part
NOT_SHOWN = ("vtkGhostType", "projectile")


@dataclass
class Mesh:
    """Points in m [n, 3] and the quads between them [c, 4]."""

    points: np.ndarray
    quads: np.ndarray


class Results:
    """An open results file. Only complete frames count, so a killed or running run can be read."""

    def __init__(self, path):
        self.path = path
        self.file = Hdf5Reader(path)
        self.times = self._times()
        self.points_of_part = self._counts("NumberOfPoints")
        self.cells_of_part = self._counts("NumberOfCells")
        self.parts = [self._quads(part) for part in range(len(self.cells_of_part))]
        if len(self.parts[0]) == 0:
            raise InputError(f"{path}: no fabric in it")
        self.reference = self.points(0) - self.displacement(0)
        self.ply = self._cells("ply", 0, INTEGER)
        self.symmetry = symmetry_of(self.file.text("scene")) or self._symmetry_of_mesh()

    def _times(self):
        if not self.file.has("VTKHDF"):
            raise InputError(f"{self.path}: not results of weavefront: no VTKHDF")
        frames = self.file.count("VTKHDF/Steps", "NSteps")
        if frames <= 0:
            raise InputError(f"{self.path}: no complete frame yet")
        if frames > self.file.dataset("VTKHDF/Steps/Values").size:
            raise InputError(f"{self.path}: fewer times than frames")
        times = self.file.rows("VTKHDF/Steps/Values", 0, frames, largest=LATEST)
        if np.any(np.diff(times) <= 0):
            raise InputError(f"{self.path}: VTKHDF/Steps/Values does not ascend")
        return times

    def _counts(self, name):
        counts = self.file.all(f"VTKHDF/{name}", INTEGER, PARTS)
        if len(counts) == 0 or np.any((counts < 0) | (counts > MOST)):
            raise InputError(
                f"{self.path}: VTKHDF/{name} is {counts.tolist()}, expected one count for each part"
            )
        return counts

    def _quads(self, part):
        cells, ids = self.cells_of_part, self._counts("NumberOfConnectivityIds")
        if not len(cells) == len(ids) == len(self.points_of_part):
            raise InputError(
                f"{self.path}: NumberOfPoints, NumberOfCells and NumberOfConnectivityIds differ in length"
            )
        nodes = self.file.rows("VTKHDF/Connectivity", ids[:part].sum(), ids[part], INTEGER)
        offsets = self.file.rows("VTKHDF/Offsets", cells[:part].sum() + part, cells[part] + 1, INTEGER)
        corners = np.diff(offsets)
        if np.any((corners != 3) & (corners != 4)):
            raise InputError(f"{self.path}: part {part} has cells that are neither quads nor triangles")
        if offsets[0] < 0 or offsets[-1] > len(nodes):
            raise InputError(f"{self.path}: VTKHDF/Offsets leads outside Connectivity in part {part}")
        if np.any((nodes < 0) | (nodes >= self.points_of_part[part])):
            raise InputError(f"{self.path}: VTKHDF/Connectivity names points that part {part} has not got")
        return nodes[
            offsets[:-1, None] + np.minimum(np.arange(4), corners[:, None] - 1)
        ]  # a triangle repeats its last node

    def _symmetry_of_mesh(self):
        """Whether only x >= 0, y >= 0 is modelled."""
        lowest, highest = self.reference.min(axis=0), self.reference.max(axis=0)
        return tuple(bool(lowest[axis] > -1e-6 * highest[axis]) for axis in (0, 1))

    def points(self, step, part=0):
        """Positions in m [n, 3]."""
        start = self.file.number("VTKHDF/Steps/PointOffsets", step) + self.points_of_part[:part].sum()
        return self.file.rows("VTKHDF/Points", start, self.points_of_part[part], width=3, largest=FARTHEST)

    def displacement(self, step):
        """Displacement of the fabric's nodes in m [n, 3]."""
        if not self.file.has("VTKHDF/PointData/displacement"):
            return self.points(step) - self.points(0)
        start = self.file.number("VTKHDF/Steps/PointDataOffsets/displacement", step)
        return self.file.rows(
            "VTKHDF/PointData/displacement", start, self.points_of_part[0], width=3, largest=FARTHEST
        )

    def _cells(self, name, step, kinds=NUMBER, part=0):
        array, offsets, start = f"VTKHDF/CellData/{name}", f"VTKHDF/Steps/CellDataOffsets/{name}", 0
        constant = self.file.dataset(array).shape[:1] == (self.cells_of_part.sum(),)
        if self.file.has(offsets) or not constant:
            start = self.file.number(offsets, step)
        return self.file.rows(array, start + self.cells_of_part[:part].sum(), self.cells_of_part[part], kinds)

    def arrays(self):
        """Names of the cell arrays that can be shown."""
        return [name for name in self.file.arrays("VTKHDF/CellData") if name not in NOT_SHOWN]

    def alive(self, step):
        """Which elements are not eroded [c]."""
        if not self.file.has("VTKHDF/CellData/vtkGhostType"):
            return np.ones(self.cells_of_part[0], dtype=bool)
        return (self._cells("vtkGhostType", step, INTEGER) & HIDDEN) == 0

    def joined(self, step):
        """Which elements are not eroded and joined to a support by unbroken yarns [c].

        Where the file does not say, all that are not eroded.
        """
        alive = self.alive(step)
        return alive & (self._cells("joined", step, INTEGER) != 0) if self.knows_debris else alive

    @cached_property
    def knows_debris(self):
        """Whether the file says what is joined to a support, and something is at the start."""
        return "joined" in self.arrays() and bool(np.any(self._cells("joined", 0, INTEGER)))

    @cached_property
    def _quads_of_projectiles(self):
        """The quads of each projectile's surface."""
        if len(self.parts) < 2 or len(self.parts[1]) == 0:
            return []
        quads = self.parts[1]
        if not self.file.has("VTKHDF/CellData/projectile"):
            return [quads]
        number = self._cells("projectile", 0, part=1)
        return [quads[number == each] for each in np.unique(number)]

    def projectiles(self, step):
        """The surface of each projectile."""
        if not self._quads_of_projectiles:
            return []
        points = self.points(step, 1)
        surfaces = []
        for quads in self._quads_of_projectiles:
            own, renumbered = np.unique(quads, return_inverse=True)
            surfaces.append(Mesh(points[own], renumbered.reshape(quads.shape)))
        return surfaces

    def projectile(self, step):
        """The surface of the first projectile, or None."""
        return next(iter(self.projectiles(step)), None)

    def field(self, name, step):
        """A cell array; `stress` and `strain` are the greater of fill and warp, `height` the deflection."""
        if name == "height":
            return self.displacement(step)[self.parts[0], 2].mean(axis=1)
        names = [name]
        if name in ("stress", "strain") and name not in self.arrays():
            names = [f"{name}_fill", f"{name}_warp"]
        for wanted in names:
            if wanted not in self.arrays():
                raise InputError(f"{self.path}: no cell array '{wanted}'; it has {', '.join(self.arrays())}")
        return np.max([self._cells(wanted, step) for wanted in names], axis=0)

    def default_field(self):
        """Yarn stress, or what comes closest among the arrays that the scene asked for."""
        for name in ("stress", "strain"):
            if {f"{name}_fill", f"{name}_warp"} <= set(self.arrays()):
                return name
        return "height"
