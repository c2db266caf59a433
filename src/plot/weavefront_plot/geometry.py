"""Cuts, mirror images and extents of quad meshes."""
import numpy as np


def crossings(points, quads, side, values):
    """Where the quads cross the surface side = 0, linearly between nodes.

    `side` [n] is a signed distance, `values` [n, m] what is wanted on the cut. Returns segments [k, 2, m] and
    the quad of each [k].
    """
    positive = side[quads] >= 0
    following = np.roll(quads, -1, axis=1)
    crossed = positive != np.roll(positive, -1, axis=1)
    cells = np.flatnonzero(crossed.sum(axis=1) == 2)
    if len(cells) == 0:
        return np.empty((0, 2, values.shape[1])), cells
    mask = crossed[cells]
    a, b = quads[cells][mask].reshape(-1, 2), following[cells][mask].reshape(-1, 2)
    part = (side[a] / (side[a] - side[b]))[..., None]
    return values[a] + part * (values[b] - values[a]), cells


def beside(points, normal, through):
    """Distance [n] of the points from the vertical plane with this horizontal normal through a point.

    The plane stands a hair inside, so that the edge of a half or quarter model that lies on it is found.
    """
    return (points[:, :2] - through) @ np.asarray(normal, dtype=float) - 1e-6 * np.abs(points[:, :2]).max(
        initial=1e-9
    )


def cut(points, quads, normal, through):
    """Segments [k, 2, 3] of the quads on the plane of `beside`, and the quad of each."""
    return crossings(points, quads, beside(points, normal, through), points)


def images(symmetry):
    """The mirror images, as signs of x and y, that make the whole of what is modelled."""
    return [(x, y) for x in ((1, -1) if symmetry[0] else (1,)) for y in ((1, -1) if symmetry[1] else (1,))]


def mirrored(points, sign):
    """The points with x and y multiplied by `sign`."""
    return points * np.array([sign[0], sign[1], 1.0])


def spacing(reference, quads, ply):
    """The smallest distance between plies in m; 0.2 mm for a single ply."""
    heights = np.unique([reference[quads[ply == number], 2].mean() for number in np.unique(ply)])
    return float(np.diff(heights).min()) if len(heights) > 1 else 0.2e-3


def extent(points, quads, height, level, origin, direction):
    """Distance from `origin` of the outermost point in the horizontal `direction` where height [n] is
    `level`.

    None where there is no such point.
    """
    unit = np.asarray(direction, dtype=float) / np.hypot(*direction)
    normal = np.array([-unit[1], unit[0]])
    if normal.sum() < 0:
        normal = -normal
    radius = (points[:, :2] - origin) @ unit
    segments, _ = crossings(points, quads, beside(points, normal, origin), np.column_stack([radius, height]))
    radius, value = segments[..., 0], segments[..., 1] - level
    across = (value[:, 0] * value[:, 1] <= 0) & (value[:, 0] != value[:, 1])
    radius, value = radius[across], value[across]
    part = value[:, 0] / (value[:, 0] - value[:, 1])
    reached = radius[:, 0] + part * (radius[:, 1] - radius[:, 0])
    reached = reached[reached > 0]
    return float(reached.max()) if len(reached) else None
