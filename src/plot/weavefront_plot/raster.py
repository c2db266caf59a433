"""Triangles on a grid of pixels, where the one nearest to the viewer hides the others (depth buffer)."""
import numpy as np

CHUNK = 1 << 17  # pixels looked at together: a dozen arrays of this length stay in the cache of a processor


class Raster:
    """The face seen in each pixel [height * width], -1 where there is none, and its depth."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.face = np.full(width * height, -1, dtype=np.int32)
        self.depth = np.full(width * height, -np.inf, dtype=np.float32)

    def draw(self, corners, faces, kept=None):
        """Adds triangles.

        `corners` [t, 3, 3]: pixels to the right, pixels downwards, and depth towards the viewer in pixels.
        `faces` [t]: what a pixel remembers of each. `kept(x, y, depth)`: which pixels are drawn, by default
        all.
        """
        corners, faces = facing(corners, faces)
        for begin, end in chunks(pixels_of_box(corners)):
            self._draw_chunk(corners[begin:end], faces[begin:end], kept)

    def _draw_chunk(self, corners, faces, kept):
        triangle, row, first, count = self._spans(corners)
        triangle, row = np.repeat(triangle, count), np.repeat(row, count)
        column = np.arange(len(row)) - np.repeat(np.cumsum(count) - count - first, count)
        along_x, along_y, constant = planes(corners)
        depth = (along_x[triangle] * column + along_y[triangle] * row + constant[triangle]).astype(np.float32)
        pixel = row * self.width + column
        nearer = depth > self.depth[pixel]
        if kept is not None:
            nearer &= kept(column, row, depth)
        pixel, depth, face = pixel[nearer], depth[nearer], faces[triangle[nearer]]
        while len(pixel):  # of several on one pixel the last is written; nearer ones follow
            self.depth[pixel], self.face[pixel] = depth, face
            again = depth > self.depth[pixel]
            pixel, depth, face = pixel[again], depth[again], face[again]

    def _spans(self, corners):
        """Triangle, row, first column and number of columns of every row of pixels in a triangle."""
        top = np.maximum(np.ceil(corners[:, :, 1].min(axis=1)), 0).astype(np.int64)
        bottom = np.minimum(np.floor(corners[:, :, 1].max(axis=1)), self.height - 1).astype(np.int64)
        rows = np.maximum(bottom - top + 1, 0)
        triangle = np.repeat(np.arange(len(corners)), rows)
        row = np.arange(len(triangle)) - np.repeat(np.cumsum(rows) - rows - top, rows)
        left, right = np.full(len(row), 0.0), np.full(len(row), self.width - 1.0)
        for i in range(3):  # inside is to the same side of each edge
            a, b = corners[:, i], corners[:, (i + 1) % 3]
            rise = b[:, 1] - a[:, 1]
            with np.errstate(divide="ignore", invalid="ignore"):
                slope = np.where(rise != 0, (b[:, 0] - a[:, 0]) / rise, 0.0)
            crossing = a[triangle, 0] + slope[triangle] * (row - a[triangle, 1])
            bounds_left, bounds_right = (rise > 0)[triangle], (rise < 0)[triangle]
            left = np.where(bounds_left, np.maximum(left, crossing), left)
            right = np.where(bounds_right, np.minimum(right, crossing), right)
        first = np.ceil(left).astype(np.int64)
        count = np.maximum(np.floor(right).astype(np.int64) - first + 1, 0)
        return triangle, row, first, count


def facing(corners, faces):
    """The triangles that cover an area, their corners in the same turn, nearest first."""
    twice_area = doubled_areas(corners)
    turned = corners[:, [0, 2, 1]]
    corners = np.where((twice_area > 0)[:, None, None], turned, corners)
    order = np.argsort(-corners[:, :, 2].max(axis=1), kind="stable")
    order = order[np.abs(twice_area[order]) > 1e-9]
    return corners[order], faces[order]


def doubled_areas(corners):
    """Twice the signed area on the picture [t]."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def planes(corners):
    """Coefficients of depth = along_x x + along_y y + constant on each triangle."""
    a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    twice_area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    along_x = (u[:, 2] * v[:, 1] - v[:, 2] * u[:, 1]) / twice_area
    along_y = (v[:, 2] * u[:, 0] - u[:, 2] * v[:, 0]) / twice_area
    return along_x, along_y, a[:, 2] - along_x * a[:, 0] - along_y * a[:, 1]


def pixels_of_box(corners):
    """Half the pixels of the rectangle about each triangle: about as many as it covers."""
    return 0.5 * np.prod(np.ptp(corners[:, :, :2], axis=1) + 1, axis=1)


def chunks(sizes):
    """Ranges [begin, end) whose sizes add up to about CHUNK."""
    number = (np.cumsum(sizes) // CHUNK).astype(np.int64)
    edges = np.concatenate([[0], np.flatnonzero(np.diff(number)) + 1, [len(sizes)]])
    return [(begin, end) for begin, end in zip(edges[:-1], edges[1:]) if end > begin]
