#!/usr/bin/python3
"""Which pictures weavefront-plot draws of a run: test_pictures.py PATH/TO/weavefront-plot."""
import shutil
import unittest

import h5py
import matplotlib.image
from PIL import Image

from plotter import OnFolder, plot
from synthetic_run import write_run

YARN = "rate,time,strain,stress,failure\n1,0,0,0,0\n1,0.03,0.03,3e9,20\n200,0,0,0,0\n200,2e-4,0.04,5.2e9,19\n"


class OnRuns(OnFolder):
    """Shared synthetic runs: `soft` turns back at 140 us, `hard` is perforated; each has a frame every 25
    us."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.soft, cls.hard = cls.folder / "soft", cls.folder / "hard"
        write_run(cls.soft)
        write_run(cls.hard, count=16, perforate=True)


class Pictures(OnRuns):
    def test_default_draws_everything_with_the_rebound_among_the_frames(self):
        # quarters of the run are 50, 100, 150, 200 us; the frame nearest to the rebound at 140 us is 150 us
        deformed_pictures = [
            "deformed_100us.png",
            "deformed_150us.png",
            "deformed_200us.png",
            "deformed_50us.png",
        ]
        others = ["energies.png", "history.png", "pyramid.json", "section.png"]
        self.assertEqual(self.drawn(self.soft), ["contour_150us.png", *deformed_pictures, *others])

    def test_rebound_takes_the_place_of_the_quarter_next_to_it(self):
        fine = self.folder / "fine"
        write_run(fine, count=4, plies=1, frames=21)
        self.assertEqual(
            self.drawn(fine, "--only", "deformed"),
            ["deformed_100us.png", "deformed_140us.png", "deformed_200us.png", "deformed_50us.png"],
        )

    def test_perforated_run(self):
        self.assertEqual(
            self.drawn(self.hard, "--only", "deformed,section", "--times", "25us,0.05ms", "--window", "3cm"),
            ["deformed_25us.png", "deformed_50us.png", "section.png"],
        )

    def test_early_perforation_draws_the_frames_around_it(self):
        # the last ply is deflected most at 25 or 50 us: a third, two thirds and twice that are within 100 us
        late = [
            name
            for name in self.drawn(self.hard, "--only", "deformed")
            if name in ("deformed_150us.png", "deformed_200us.png")
        ]
        self.assertEqual(late, [])

    def test_run_without_a_projectile(self):
        still = self.folder / "still"
        write_run(still, count=4, plies=1, projectile=False)
        # a flat ply has no contour
        self.assertEqual(
            self.drawn(still, "--times", "50us"),
            ["deformed_50us.png", "energies.png", "history.png", "pyramid.json", "section.png"],
        )
        self.assertIn("no projectile", self.text_of(still, "history"))
        self.assertNotIn("m/s", self.text_of(still, "deformed_50us", "--times", "50us"))

    def test_formats(self):
        self.assertEqual(
            self.drawn(self.soft, "--only", "deformed", "--times", "50us", "--format", "pdf"),
            ["deformed_50us.pdf"],
        )
        self.assertEqual(self.drawn(self.soft, "--only", "energies", "--format", "svg"), ["energies.svg"])

    def test_frames_that_are_not_complete_are_not_drawn(self):
        self.assertEqual(self.drawn(self.soft, "--only", "deformed", "--times", "1s"), ["deformed_200us.png"])

    def test_frames_closer_than_a_name_can_say_have_pictures_of_their_own(self):
        close = self.folder / "close"
        write_run(close, count=4, plies=1, frames=3, end=1e-19)
        self.assertEqual(
            self.drawn(close, "--only", "deformed"),
            ["deformed_0us_0.png", "deformed_0us_1.png", "deformed_0us_2.png"],
        )

    def test_measured_points_and_field(self):
        measured = self.folder / "measured.csv"
        measured.write_text(
            "\ufeff# gel, 1998\ntime,note,velocity\n0,first,267\n1e-4,,60\n", encoding="utf-8"
        )
        self.assertEqual(self.drawn(self.soft, "--only", "history", "--measured", measured), ["history.png"])
        self.assertEqual(
            self.drawn(self.soft, "--only", "deformed", "--times", "50us", "--field", "strain_warp"),
            ["deformed_50us.png"],
        )

    def test_history_of_a_killed_run_may_end_within_a_line(self):
        killed = self.folder / "killed"
        killed.mkdir()
        text = (self.soft / "history.csv").read_text(encoding="utf-8")
        cut_in_a_number = text[: text.rindex("\n", 0, len(text) // 2) - 3]
        for end in (cut_in_a_number, cut_in_a_number.rsplit(",", 1)[0]):
            (killed / "history.csv").write_text(end, encoding="utf-8")
            self.assertEqual(
                self.drawn(killed, "--only", "history,energies"), ["energies.png", "history.png"]
            )

    def test_results_can_be_read_while_they_are_written(self):
        with h5py.File(self.soft / "results.vtkhdf", "r+"):
            self.assertEqual(
                self.drawn(self.soft, "--only", "contour"), ["contour_150us.png", "pyramid.json"]
            )

    def test_yarn_curves(self):
        curves, picture = self.folder / "curves.csv", self.folder / "fig10.svg"
        curves.write_text(YARN, encoding="utf-8")
        self.assertEqual(plot("--yarn", curves, "--output", picture).returncode, 0)
        text = picture.read_text(encoding="utf-8")
        self.assertIn("primary bonds fail", text)
        self.assertIn("secondary bonds fail", text)


class History(OnRuns):
    def test_says_what_it_shows(self):
        text = self.text_of(self.soft, "history")
        for words in (
            "back face of the target",
            "force, kN",
            "Velocity vz of the",
            "farthest 9.52 mm at 140 µs",
        ):
            self.assertIn(words, text)
        self.assertNotIn("speed", text)

    def test_an_oblique_shot_has_a_speed(self):
        oblique = self.folder / "oblique"
        write_run(oblique, count=4, plies=1, symmetry="", shot=(60, 0))
        self.assertIn("speed", self.text_of(oblique, "history"))
        # at 100 us vz is 0.4 267 cos(pi/2 100/140) + 0.6 267 (1 - 100/140)^3 = 50.1 m/s, the speed hypot(60,
        # 50.1)
        self.assertIn("vz 50 m/s,  speed 78 m/s", self.text_of(oblique, "deformed_100us", "--times", "100us"))

    def test_columns_that_it_does_not_know_may_hold_anything(self):
        later = self.folder / "later"
        write_run(later, count=4, plies=1)
        lines = (later / "history.csv").read_text(encoding="utf-8").splitlines()
        more = [f"{lines[0]},penetration,outcome", *(f"{line},nan,not yet" for line in lines[1:])]
        (later / "history.csv").write_text("\n".join(more) + "\n", encoding="utf-8")
        self.assertEqual(self.drawn(later, "--only", "history,energies"), ["energies.png", "history.png"])

    def test_older_histories_are_drawn(self):
        older = self.folder / "older"
        older.mkdir()
        keep = (
            "time",
            "projectile_z",
            "projectile_vz",
            "kinetic_fabric",
            "kinetic_projectile",
            "internal",
            "energy_error",
            "broken_yarns",
        )
        lines = [
            line.split(",") for line in (self.soft / "history.csv").read_text(encoding="utf-8").splitlines()
        ]
        places = [lines[0].index(name) for name in keep]
        (older / "history.csv").write_text(
            "".join(",".join(line[i] for i in places) + "\n" for line in lines), encoding="utf-8"
        )
        self.assertEqual(self.drawn(older, "--only", "history,energies"), ["energies.png", "history.png"])


class Options(OnRuns):
    def pixels(self, *arguments):
        """The picture `deformed` of `soft` at 150 us."""
        result = plot(self.soft, "--only", "deformed", "--times", "150us", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return matplotlib.image.imread(result.stdout.strip())

    def test_views_by_name_and_by_angles(self):
        self.assertTrue((self.pixels() == self.pixels("--view", "-52,24")).all())
        self.assertTrue((self.pixels("--view", "strike-face") == self.pixels("--view=-52,-24")).all())
        self.assertFalse(self.pixels("--view", "top").shape == self.pixels("--view", "side").shape)

    def test_plies(self):
        self.assertIn("Ply 2 at", self.text_of(self.soft, "contour_150us", "--plies", "1-2"))
        self.refused(
            2, "results.vtkhdf: no ply 9, which --plies asks for; it has 1, 2, 3", self.soft, "--plies", "3,9"
        )

    def test_animation(self):
        self.assertEqual(self.drawn(self.soft, "--only", "deformed", "--animate", "gif"), ["deformed.gif"])
        result = plot(
            self.soft,
            "--only",
            "deformed",
            "--animate",
            "gif",
            "--times",
            "25us,100us,200us",
            "--output",
            self.folder,
        )
        with Image.open(result.stdout.strip()) as picture:
            self.assertEqual((picture.format, picture.n_frames), ("GIF", 3))

    def test_animation_as_mp4(self):
        if shutil.which("ffmpeg") is None:
            self.refused(3, "--animate: mp4 needs the program ffmpeg", self.soft, "--animate", "mp4")
        else:
            self.assertEqual(
                self.drawn(self.soft, "--only", "deformed", "--animate", "mp4"), ["deformed.mp4"]
            )


if __name__ == "__main__":
    unittest.main()
