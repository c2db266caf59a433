#!/usr/bin/python3
"""weavefront-plot on small synthetic runs: test_plot.py PATH/TO/weavefront-plot."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from synthetic_run import write_run

PLOT = Path(sys.argv.pop(1)).resolve()
for package in (PLOT.parent, PLOT.parent.parent / "share" / "weavefront" / "plot"):
    sys.path.insert(0, str(package))

from weavefront_plot import deformed
from weavefront_plot.results import Results
from weavefront_plot.run import Run
from weavefront_plot.study import series_label

YARN = "rate,time,strain,stress,failure\n1,0,0,0,0\n1,0.03,0.03,3e9,20\n200,0,0,0,0\n200,2e-4,0.04,5.2e9,{failure}\n"


def plot(*arguments):
    """Runs the program."""
    environment = {name: value for name, value in os.environ.items() if name != "HDF5_USE_FILE_LOCKING"}
    return subprocess.run([PLOT, *map(str, arguments)], capture_output=True, text=True, env=environment, check=False)


class OnRuns(unittest.TestCase):
    """Shared synthetic runs: `soft` turns back at 140 us, `hard` is perforated; each has a frame every 25 us."""

    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.keep.name)
        cls.soft, cls.hard = cls.folder / "soft", cls.folder / "hard"
        write_run(cls.soft)
        write_run(cls.hard, count=16, perforate=True)

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def drawn(self, *arguments):
        """The names of the files that a successful call leaves in an empty folder."""
        with tempfile.TemporaryDirectory(dir=self.folder) as output:
            result = plot(*arguments, "--output", output)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            for path in Path(output).iterdir():
                self.assertGreater(path.stat().st_size, 100)
            return sorted(path.name for path in Path(output).iterdir())

    def refused(self, status, part, *arguments):
        """The call ends with this status and one line that holds `part`."""
        result = plot(*arguments)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("weavefront-plot: "), result.stderr)
        self.assertIn(part, result.stderr)


class Pictures(OnRuns):
    def test_default_draws_everything_with_the_rebound_among_the_frames(self):
        # quarters of the run are 50, 100, 150, 200 us; the frame nearest to the rebound at 140 us is 150 us
        deformed_pictures = ["deformed_100us.png", "deformed_150us.png", "deformed_200us.png", "deformed_50us.png"]
        others = ["energies.png", "history.png", "pyramid.json", "section.png"]
        self.assertEqual(self.drawn(self.soft), ["contour_150us.png", *deformed_pictures, *others])

    def test_perforated_run(self):
        self.assertEqual(self.drawn(self.hard, "--only", "deformed,section", "--times", "25us,0.05ms", "--window", "3cm"),
                         ["deformed_25us.png", "deformed_50us.png", "section.png"])

    def test_early_perforation_draws_the_frames_around_it(self):
        # the last ply is deflected most at 25 or 50 us: a third, two thirds and twice that are within 100 us
        late = [name for name in self.drawn(self.hard, "--only", "deformed") if name in ("deformed_150us.png", "deformed_200us.png")]
        self.assertEqual(late, [])

    def test_run_without_a_projectile(self):
        still = self.folder / "still"
        write_run(still, count=4, plies=1, projectile=False)
        # a flat ply has no contour
        self.assertEqual(self.drawn(still, "--times", "50us"), ["deformed_50us.png", "energies.png", "history.png", "pyramid.json", "section.png"])
        plot(still, "--only", "history,deformed", "--times", "50us", "--format", "svg")
        self.assertIn("no projectile", (still / "plots/history.svg").read_text(encoding="utf-8"))
        self.assertNotIn("m/s<", (still / "plots/deformed_50us.svg").read_text(encoding="utf-8"))

    def test_formats(self):
        self.assertEqual(self.drawn(self.soft, "--only", "deformed", "--times", "50us", "--format", "pdf"), ["deformed_50us.pdf"])
        self.assertEqual(self.drawn(self.soft, "--only", "energies", "--format", "svg"), ["energies.svg"])

    def test_frames_that_are_not_complete_are_not_drawn(self):
        self.assertEqual(self.drawn(self.soft, "--only", "deformed", "--times", "1s"), ["deformed_200us.png"])

    def test_measured_points_and_field(self):
        measured = self.folder / "measured.csv"
        measured.write_text("# gel, 1998\ntime,velocity\n0,267\n1e-4,60\n", encoding="utf-8")
        self.assertEqual(self.drawn(self.soft, "--only", "history", "--measured", measured), ["history.png"])
        self.assertEqual(self.drawn(self.soft, "--only", "deformed", "--times", "50us", "--field", "strain_warp"), ["deformed_50us.png"])

    def test_history_of_a_killed_run_may_end_within_a_line(self):
        killed = self.folder / "killed"
        killed.mkdir()
        text = (self.soft / "history.csv").read_text(encoding="utf-8")
        (killed / "history.csv").write_text(text[: len(text) // 2].rsplit(",", 1)[0], encoding="utf-8")
        self.assertEqual(self.drawn(killed, "--only", "history,energies"), ["energies.png", "history.png"])

    def test_results_can_be_read_while_they_are_written(self):
        with h5py.File(self.soft / "results.vtkhdf", "r+"):
            self.assertEqual(self.drawn(self.soft, "--only", "contour"), ["contour_150us.png", "pyramid.json"])

    def test_yarn_curves(self):
        curves, picture = self.folder / "curves.csv", self.folder / "fig10.svg"
        curves.write_text(YARN.format(failure=19), encoding="utf-8")
        self.assertEqual(plot("--yarn", curves, "--output", picture).returncode, 0)
        text = picture.read_text(encoding="utf-8")
        self.assertIn("primary bonds fail", text)
        self.assertIn("secondary bonds fail", text)


class Studies(unittest.TestCase):
    def test_bare_numbers_in_the_legend_say_of_what(self):
        study = {"axes": [{"name": "a.formulation"}, {"name": "cell.refinement"}, {"name": "projectile.velocity.2"}, {"name": "h"}], "order_along": "h"}
        series = {"labels": ["paper", "10", "5 %"], "order": 1.0}
        self.assertEqual(series_label(study, series).replace("\u2009", " "), "paper, refinement 10, velocity.2 5 %: order 1.0")


class Measures(OnRuns):
    def test_extents_of_a_pyramid_are_exact(self):
        for symmetry in ("xy", "y", ""):
            with self.subTest(symmetry=symmetry):
                run = self.folder / f"model_{symmetry}"
                write_run(run, plies=2, symmetry=symmetry)
                self.drawn(run, "--only", "contour")
                plot(run, "--only", "contour")
                shape = json.loads((run / "plots" / "pyramid.json").read_text(encoding="utf-8"))
                # At 150 us the foot is at 8 + 380 * 0.15 = 65 mm and the top at 1.5 * 2.69 = 4.035 mm. Linear interpolation is exact there;
                # the rays stand 1e-6 of the size beside the nodes.
                self.assertAlmostEqual(shape["time"], 150e-6, delta=1e-12)
                self.assertAlmostEqual(shape["extent_x"], 0.5 * (65e-3 + 4.035e-3), delta=1e-6)
                self.assertAlmostEqual(shape["ratio"], np.sqrt(2), delta=1e-4)

    def test_front_quarter_is_open_and_the_rest_is_whole_whatever_is_modelled(self):
        counts = set()
        for symmetry in ("xy", "x", "y", ""):
            folder = self.folder / f"open_{symmetry}"
            write_run(folder, count=6, plies=2, frames=2, symmetry=symmetry)
            results = Results(folder / "results.vtkhdf")
            faces = deformed.fabric(results, 1, 1.0, "stress", lambda values: 0 * values).corners
            self.assertFalse(deformed.open_quarter(faces.mean(axis=1) + [-1e-3, 1e-3, 0]).any())
            counts.add(len(faces))
        # three quarters of 2 plies of 6 x 6 elements, and the cut edges of 2 x 6 elements on each of two planes
        self.assertEqual(counts, {3 * 2 * 36 + 2 * 2 * 6})

    def test_eroded_elements_are_not_drawn(self):
        results = Run(self.hard).results
        whole, holed = (len(deformed.fabric(results, step, 1.0, "stress", lambda values: 0 * values).corners) for step in (0, 4))
        gone = np.count_nonzero(~results.alive(4))
        self.assertGreater(gone, 0)
        self.assertLessEqual(holed, whole - 3 * gone)

    def test_only_complete_frames_count(self):
        self.assertEqual(len(Run(self.soft).results.times), 9)


class Refusals(OnRuns):
    def test_usage(self):
        self.refused(2, "give the folder of a run")
        self.refused(2, "--colour", self.soft, "--colour", "red")
        self.refused(2, "--only: 'histroy' is none of history,", self.soft, "--only", "histroy")
        self.refused(2, "'30' is not a number with one of the units", self.soft, "--times", "30")
        self.refused(2, "must be greater than zero", self.soft, "--window", "0mm")
        self.refused(2, "not both", self.soft, "--yarn", self.soft / "history.csv")
        self.refused(2, "give one of RUN, --yarn and --study", self.soft, "--study", self.soft)

    def test_missing_files(self):
        self.refused(3, "no such folder", self.folder / "nowhere")
        empty = self.folder / "empty"
        empty.mkdir()
        self.refused(3, "history.csv: No such file", empty)
        self.refused(3, "results.vtkhdf: no such file", empty, "--only", "section")
        self.refused(3, "none.csv: No such file", self.soft, "--measured", self.folder / "none.csv")
        self.refused(3, "none.csv: No such file", "--yarn", self.folder / "none.csv")
        self.refused(3, "study.json: No such file", "--study", empty)

    def test_wrong_content(self):
        bad = self.folder / "bad"
        bad.mkdir()
        (bad / "results.vtkhdf").write_text("no HDF5", encoding="utf-8")
        self.refused(3, "not a readable HDF5 file", bad, "--only", "deformed")
        (bad / "history.csv").write_text("time,velocity\n0,1\n", encoding="utf-8")
        self.refused(2, "no column 'projectile_z'; it has time, velocity", bad, "--only", "history")
        measured = self.folder / "bad.csv"
        measured.write_text("time,velocity\n0,fast\n", encoding="utf-8")
        self.refused(2, "'fast' is not a number", self.soft, "--measured", measured)
        measured.write_text(YARN.format(failure=21), encoding="utf-8")
        self.refused(2, "failure 21 is none of", "--yarn", measured, "--output", self.folder / "y.png")
        self.assertFalse((self.folder / "y.png").exists())
        (bad / "study.json").write_text("no JSON", encoding="utf-8")
        self.refused(2, "study.json: not JSON", "--study", bad)

    def test_results_without_what_is_asked_for(self):
        self.refused(2, "no cell array 'spin'; it has ply, strain_fill", self.soft, "--field", "spin")
        early = self.folder / "early"
        write_run(early, count=4, plies=1, frames=2)
        with h5py.File(early / "results.vtkhdf", "r+") as file:
            file["VTKHDF/Steps"].attrs["NSteps"] = 0
        self.refused(2, "no complete frame yet", early, "--only", "section")


if __name__ == "__main__":
    unittest.main()
