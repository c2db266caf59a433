"""The quarter of the target that is left out, so that the struck place is seen cut open."""
from dataclasses import dataclass

import numpy as np

STEEP = 75.0  # degrees of elevation, from which a view shows nothing of a vertical cut


@dataclass(frozen=True)
class OpenQuarter:
    """What lies beyond the point (x, y) in the directions `sign_x` and `sign_y`."""

    x: float
    y: float
    sign_x: int
    sign_y: int

    def sides(self, points):
        """How far the points lie beyond either plane [..., 2]; both are positive in the quarter."""
        return (points[..., :2] - [self.x, self.y]) * [self.sign_x, self.sign_y]

    def holds(self, points):
        """Which points lie in the quarter."""
        return np.all(self.sides(points) > 0, axis=-1)

    def planes(self):
        """Each plane: its normal into the rest, and the axis along which it leads out of the corner."""
        return ((-self.sign_x, 0), 1), ((0, -self.sign_y), 0)


def facing_quarter(impact, view):
    """The quarter at the impact that faces the viewer, in mm; None for a steep view."""
    if abs(view.elevation) >= STEEP:
        return None
    towards = view.axes()[2]
    return OpenQuarter(
        1e3 * impact.x, 1e3 * impact.y, 1 if towards[0] > -1e-9 else -1, 1 if towards[1] > 1e-9 else -1
    )
