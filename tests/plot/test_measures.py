#!/usr/bin/python3
"""What weavefront-plot measures, cuts and leaves out, and where: test_measures.py PATH/TO/weavefront-plot."""
import json
import shutil
import unittest
from types import SimpleNamespace

import h5py
import numpy as np

from plotter import OnFolder, plot
from synthetic_run import RADIUS, write_run
from weavefront_plot.deformed import Deformed
from weavefront_plot.fabric import Fabric
from weavefront_plot.option_values import VIEWS
from weavefront_plot.run import Run
from weavefront_plot.section import outlines, ply_lines, shown_range

TOP = 1.5 * RADIUS  # half the width of the pyramid's flat top
IMPACT = (20e-3, -30e-3)


def look(view="back-face", debris=True, window=None):
    """Options of `deformed`."""
    return SimpleNamespace(view=VIEWS[view], debris=debris, window=window, field=None)


class OnRun(OnFolder):
    def run_of(self, name, **keywords):
        """A run, written once."""
        if not (self.folder / name).exists():
            write_run(self.folder / name, **keywords)
        return Run(self.folder / name)

    def shape_of(self, name, **keywords):
        """pyramid.json of a run."""
        run = self.run_of(name, **keywords)
        self.assertEqual(plot(run.folder, "--only", "contour").stderr, "")
        return json.loads((run.folder / "plots" / "pyramid.json").read_text(encoding="utf-8"))


class Extents(OnRun):
    # At 150 us the foot is at 8 + 380 * 0.15 = 65 mm and the top at 1.5 * 2.69 = 4.035 mm. Linear
    # interpolation is exact there; the rays stand 1e-6 of the size beside the nodes.
    def test_of_a_pyramid_are_exact(self):
        for symmetry in ("xy", "y", ""):
            with self.subTest(symmetry=symmetry):
                shape = self.shape_of(f"model_{symmetry}", plies=2, symmetry=symmetry)
                self.assertAlmostEqual(shape["time"], 150e-6, delta=1e-12)
                self.assertAlmostEqual(shape["extent_x"], 0.5 * (65e-3 + TOP), delta=1e-6)
                self.assertAlmostEqual(shape["ratio"], np.sqrt(2), delta=1e-4)

    def test_are_measured_from_the_impact(self):
        # A node is at the impact, so the same holds there. In a half model y = 0 is the plane of symmetry.
        for symmetry, impact in (("", IMPACT), ("y", (IMPACT[0], 0.0))):
            with self.subTest(symmetry=symmetry):
                shape = self.shape_of(f"aside_{symmetry}", plies=2, symmetry=symmetry, impact=impact)
                self.assertAlmostEqual(shape["impact_x"], impact[0], delta=1e-9)
                self.assertAlmostEqual(shape["impact_y"], impact[1], delta=1e-9)
                self.assertAlmostEqual(shape["extent_x"], 0.5 * (65e-3 + TOP), delta=1e-6)
                self.assertAlmostEqual(shape["extent_y"], 0.5 * (65e-3 + TOP), delta=1e-6)
                self.assertAlmostEqual(shape["ratio"], np.sqrt(2), delta=1e-4)

    def test_debris_does_not_count(self):
        # At 150 us the nose is at 0.4 * 267 m/s / (pi / 280 us) * sin(150 / 280 pi) = 9.46 mm; debris flies
        # 40 mm ahead of it.
        shape = self.shape_of("debris", plies=2, debris=True, count=20)
        self.assertLess(shape["height"], 9.47e-3)
        self.assertGreater(shape["height"], 8e-3)


class Impacts(OnRun):
    def test_lie_where_the_nose_meets_the_first_ply(self):
        run = self.run_of("aside_shot", plies=2, symmetry="", impact=IMPACT, shot=(30.0, -40.0))
        self.assertAlmostEqual(run.impact.x, IMPACT[0], delta=1e-9)
        self.assertAlmostEqual(run.impact.y, IMPACT[1], delta=1e-9)
        np.testing.assert_allclose(run.impact.along, (0.6, -0.8), atol=1e-12)
        (run.folder / "history.csv").unlink()  # then from the first two frames
        np.testing.assert_allclose(Run(run.folder).impact.along, (0.6, -0.8), atol=1e-9)

    def test_section_goes_through_the_impact_with_the_projectile_in_it(self):
        run = self.run_of("aside", plies=2, symmetry="", impact=IMPACT)
        lines, ply = ply_lines(run, Fabric(run.results), 6)
        self.assertEqual(set(ply), {1, 2})
        nose = run.results.projectile(6).points[:, 2].max()
        # The top of the last ply: the nose and the distance between two plies. The plane stands 1e-6 of the
        # size, 1e-4 mm, aside.
        self.assertAlmostEqual(lines[..., 1].max(), 1e3 * (nose + 0.25e-3), delta=1e-4)
        (body,) = outlines(run, 6)
        np.testing.assert_allclose(body[:, 0].min(), 1e3 * (IMPACT[0] - RADIUS), atol=1e-3)
        np.testing.assert_allclose(body[:, 0].max(), 1e3 * (IMPACT[0] + RADIUS), atol=1e-3)
        left, right = shown_range(Fabric(run.results), run.impact, 50e-3)
        self.assertAlmostEqual((left + right) / 2, 1e3 * IMPACT[0], delta=1e-9)

    def test_section_cuts_each_projectile_by_itself(self):
        run = self.run_of("two", plies=2, symmetry="", impact=IMPACT)
        (whole,) = outlines(run, 6)
        quads, frames = run.results.parts[1], len(run.results.times)
        right = run.results.points(0, 1)[quads].mean(axis=1)[:, 0] > IMPACT[0]
        number = np.concatenate([np.zeros(run.results.cells_of_part[0]), 1.0 + right])
        parted = shutil.copytree(run.folder, run.folder.with_name("two_parts"))
        with h5py.File(parted / "results.vtkhdf", "r+") as file:
            file["VTKHDF/CellData/projectile"] = np.tile(number, frames + 1)
            file["VTKHDF/Steps/CellDataOffsets/projectile"] = np.arange(frames + 1) * len(number)
        run = Run(parted)
        self.assertNotIn("projectile", run.results.arrays())
        left, right = sorted(outlines(run, 6), key=lambda line: line[:, 0].min())
        self.assertLess(left[:, 0].max(), right[:, 0].min() + 1e-3)
        self.assertAlmostEqual(left[:, 0].min(), whole[:, 0].min())
        self.assertAlmostEqual(right[:, 0].max(), whole[:, 0].max())

    def test_section_of_an_oblique_shot_follows_the_projectile(self):
        run = self.run_of("oblique", plies=2, symmetry="", impact=IMPACT, shot=(30.0, -40.0))
        (body,) = outlines(run, 6)
        # 50 m/s over 150 us along the section, measured from the impact
        self.assertAlmostEqual(body[:, 0].mean(), 7.5, delta=0.2)
        self.assertAlmostEqual(
            np.ptp(body[:, 0]), 2e3 * RADIUS, delta=2e3 * RADIUS * (1 - np.cos(np.pi / 32))
        )  # of 32 sides


class Deformations(OnRun):
    def faces(self, run, step, **keywords):
        """What `deformed` shows of a frame."""
        pictures = Deformed(run, Fabric(run.results), [step], look(**keywords))
        return pictures, pictures.space.plies(step, pictures._values(step), pictures.norm)

    def test_front_quarter_is_open_and_the_rest_is_whole_whatever_is_modelled(self):
        counts = set()
        for symmetry in ("xy", "x", "y", ""):
            run = self.run_of(f"open_{symmetry}", count=6, plies=2, frames=2, symmetry=symmetry)
            pictures, faces = self.faces(run, 1, window=1.0)
            middles = faces.corners.mean(axis=1)
            self.assertFalse(pictures.opening.holds(middles + [-1e-3, 1e-3, 0]).any())
            counts.add(len(faces.corners))
        # three quarters of 2 plies of 6 x 6 elements, and the cut edges of 2 x 6 elements on each of two
        # planes
        self.assertEqual(counts, {3 * 2 * 36 + 2 * 2 * 6})

    def test_open_quarter_is_at_the_impact(self):
        run = self.run_of("aside", plies=2, symmetry="", impact=IMPACT)
        for view, sign_x, sign_y in (("back-face", 1, -1), ("side", 1, -1)):
            opening = self.faces(run, 6, view=view)[0].opening
            np.testing.assert_allclose((opening.x, opening.y), np.multiply(1e3, IMPACT), atol=1e-6)
            self.assertEqual((opening.sign_x, opening.sign_y), (sign_x, sign_y))
        self.assertIsNone(self.faces(run, 6, view="top")[0].opening)

    def test_eroded_elements_are_not_drawn(self):
        run = self.run_of("hard", count=16, perforate=True)
        whole, holed = (len(self.faces(run, step)[1].corners) for step in (0, 4))
        gone = np.count_nonzero(~run.results.alive(4))
        self.assertGreater(gone, 0)
        self.assertLessEqual(holed, whole - 3 * gone)

    def test_debris_is_drawn_lighter_or_left_out(self):
        run = self.run_of("debris", plies=2, debris=True, count=20)
        torn = 3 * np.count_nonzero(~run.results.joined(6))  # of four quarters one is open
        self.assertGreater(torn, 0)
        shown, left_out = (self.faces(run, 6, debris=debris)[1] for debris in (True, False))
        self.assertGreaterEqual(len(shown.corners) - len(left_out.corners), torn)
        self.assertLess(left_out.corners[..., 2].max(), 10)
        run.results.knows_debris = False  # as in a file without the array
        same = self.faces(run, 6)[1]
        flying, as_others = (faces.colours[faces.corners[..., 2].max(axis=1) > 40] for faces in (shown, same))
        self.assertEqual(len(flying), len(as_others))
        self.assertTrue((np.sort(flying, axis=0) > np.sort(as_others, axis=0)).all())

    def test_debris_does_not_set_the_scale(self):
        flying, still = self.run_of("debris", plies=2, debris=True, count=20), self.run_of(
            "whole", plies=2, count=20
        )
        frames = [Deformed(run, Fabric(run.results), [6], look()).frame for run in (flying, still)]
        np.testing.assert_allclose(
            frames[0].high, frames[1].high, atol=5
        )  # mm; with what flies it were 36 mm higher

    def test_only_complete_frames_count(self):
        self.assertEqual(len(self.run_of("whole", plies=2, count=20).results.times), 9)


if __name__ == "__main__":
    unittest.main()
