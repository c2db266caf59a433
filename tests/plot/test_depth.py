#!/usr/bin/python3
"""Which face a picture in space shows where: test_depth.py PATH/TO/weavefront-plot."""
import unittest
from unittest.mock import patch

import numpy as np

import plotter  # makes the package known
from weavefront_plot import raster
from weavefront_plot.faces import Faces, Frame, image
from weavefront_plot.opening import OpenQuarter
from weavefront_plot.view import View

RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def nearest_by_hand(corners, width, height):
    """The nearest triangle and its depth at each pixel, one after another."""
    face, depth = np.full((height, width), -1), np.full((height, width), -np.inf)
    y, x = np.mgrid[:height, :width]
    for number, triangle in enumerate(corners):
        parts = np.linalg.solve(
            np.vstack([triangle[:, :2].T, np.ones(3)]), np.stack([x.ravel(), y.ravel(), np.ones(x.size)])
        )
        here = np.all(parts >= -1e-9, axis=0).reshape(x.shape)
        value = (triangle[:, 2] @ parts).reshape(x.shape)
        nearer = here & (value > depth)
        face[nearer], depth[nearer] = number, value[nearer]
    return face, depth


def sheet(height, count, slope, colour):
    """A square of 20 mm about the origin as count x count quads, rising along x from `height`."""
    line = np.linspace(-10, 10, count + 1)
    x, y = np.meshgrid(line, line, indexing="ij")
    points = np.stack([x, y, height + slope * x], axis=-1)
    corners = np.stack([points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]], axis=2).reshape(
        -1, 4, 3
    )
    return Faces.whole(corners, np.tile(colour, (len(corners), 1)))


class Depth(unittest.TestCase):
    def test_each_pixel_shows_the_nearest_of_random_triangles(self):
        random = np.random.default_rng(1)
        large, small = random.uniform(-10, 50, (60, 3, 3)), random.uniform(
            0, 40, (60, 1, 3)
        ) + random.uniform(-3, 3, (60, 3, 3))
        corners = np.concatenate([large, small])
        face, depth = nearest_by_hand(corners, 40, 30)
        for chunk in (raster.CHUNK, 100):  # pixels looked at together
            with self.subTest(chunk=chunk), patch.object(raster, "CHUNK", chunk):
                picture = raster.Raster(40, 30)
                picture.draw(corners, np.arange(len(corners)))
                self.assertLess(
                    np.count_nonzero(picture.face.reshape(30, 40) != face), 3
                )  # where an edge meets the pixel
                shown = picture.depth.reshape(30, 40)
                np.testing.assert_allclose(shown[face >= 0], depth[face >= 0], atol=1e-4)  # of float32

    def test_a_ply_never_shows_through_one_above_it(self):
        # 0.25 mm apart, large elements above small ones: by the depth of their middles most of the small ones
        # would be nearer.
        for slope in (0.0, 0.2, -0.5):
            for above, below in ((2, 40), (40, 2)):
                faces = Faces.join([sheet(0.25, above, slope, RED), sheet(0.0, below, slope, BLUE)])
                frame = Frame(np.array([-4.0, -1.0]), np.array([4.0, 1.0]), 160, 40)
                picture = image(faces, View(-52.0, 24.0), frame, None)
                self.assertTrue((picture == RED).all(), (slope, above, below))

    def test_open_quarter_is_cut_within_elements(self):
        faces = sheet(0.0, 2, 0.0, RED)
        faces.cut[:] = True
        view, frame = View(-90.0, 90.0), Frame(np.array([-9.0, -9.0]), np.array([9.0, 9.0]), 180, 180)
        picture = image(faces, view, frame, OpenQuarter(3.0, -4.0, 1, -1))  # seen from above, x to the right
        gone = (picture == 1.0).all(axis=2)
        self.assertTrue(gone[130:, 120:].all())  # x > 3 mm, y < -4 mm at 10 pixels a mm
        self.assertEqual(gone.sum(), 50 * 60)


if __name__ == "__main__":
    unittest.main()
