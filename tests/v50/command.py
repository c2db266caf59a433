"""What 'weavefront v50' finds on a small scene: command.py WEAVEFRONT MPIEXEC"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

from v50_runs import Limits

WEAVEFRONT, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)
ENDS = ("--from", "50 m/s", "--to", "300 m/s", "--width", "16 m/s")


class V50(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.limits = Limits(WEAVEFRONT, MPIEXEC, cls.scratch.name)
        cls.folder = cls.limits.folder
        cls.text = cls.limits.v50("whole", *ENDS, picture=True)

    def limit(self, output, variant=0):
        limit = self.limits.found(output)["limits"][variant]
        self.assertIsNone(limit["failure"])
        return limit

    def test_brackets_the_limit_to_the_stated_width(self):
        limit, rows = self.limit("whole"), self.limits.rows("whole")
        self.assertLessEqual(limit["complete"] - limit["partial"], 16.02)  # two grains of the speeds
        for row in rows:
            complete = float(row["speed_m_s"]) >= limit["complete"]
            self.assertEqual(row["result"], "complete" if complete else "partial", row)
            self.assertEqual(row["outcome"], "perforated" if complete else "stopped")
            self.assertEqual(row["plies_perforated"] == "2", complete)
            self.assertAlmostEqual(float(row["speed_ft_s"]), float(row["speed_m_s"]) / 0.3048, delta=0.006)
            # Energy lost, from the residual velocity that the row states.
            if complete:
                lost = 0.5 * 0.3e-3 * (float(row["speed_m_s"]) ** 2 - float(row["residual_m_s"]) ** 2)
                self.assertAlmostEqual(float(row["absorbed_energy_J"]) / lost, 1, places=6)
        self.assertEqual(rows[0]["speed_m_s"], "175.00")

    def test_leaves_an_ordinary_run_of_each_shot(self):
        for row in self.limits.rows("whole"):
            folder = self.folder / "whole" / row["folder"]
            summary = json.loads((folder / "summary.json").read_text())
            self.assertEqual(summary["reason"], "the outcome is decided")
            self.assertTrue(
                (folder / "results.vtkhdf").stat().st_size and (folder / "history.csv").stat().st_size
            )
            self.assertIn(row["speed_m_s"], row["folder"])

    def test_refuses_to_fit_an_s_curve_without_mixed_results_and_fits_residual_velocities(self):
        found = self.limits.found("whole")
        self.assertIn("no zone of mixed results", found["normal"]["refused"])
        self.assertIn("no fit: no zone of mixed results", self.text)
        self.assertLess(abs(found["recht_ipson"]["v50"] - found["limits"][0]["middle"]), 60)

    def test_draws_its_pictures(self):
        for name in ("response", "residual", "energy"):
            picture = (self.folder / "whole/plots" / f"{name}.png").read_bytes()
            self.assertTrue(picture.startswith(b"\x89PNG"), name)

    def test_is_the_same_on_one_and_three_ranks(self):
        self.limits.v50("on three", *ENDS, ranks=3)
        for name in ("v50.csv", "v50.json"):
            one, three = ((self.folder / output / name).read_bytes() for output in ("whole", "on three"))
            self.assertEqual(one, three, name)

    def test_groups_cut_the_bracket_by_several_shots_at_a_time(self):
        self.limits.v50("groups", *ENDS, "--ranks-per-shot", "1", ranks=3)
        speeds = [float(row["speed_m_s"]) for row in self.limits.rows("groups")]
        self.assertEqual(speeds[:3], [112.5, 175, 237.5])
        whole, groups = self.limit("whole"), self.limit("groups")
        self.assertLess(max(whole["partial"], groups["partial"]), min(whole["complete"], groups["complete"]))

    def test_looks_for_the_bracket_from_the_velocity_of_the_scene(self):
        self.limits.v50("outwards", "--width", "16 m/s", "--set", "projectile.velocity=[0, 0, 100 m/s]")
        self.assertEqual(self.limits.rows("outwards")[0]["speed_m_s"], "100.00")
        whole, found = self.limit("whole"), self.limit("outwards")
        self.assertLess(max(whole["partial"], found["partial"]), min(whole["complete"], found["complete"]))

    def test_one_end_alone_bounds_the_search(self):
        for option, speed in (("--from", "160 m/s"), ("--to", "120 m/s")):
            text = self.limits.v50(f"only {option}", option, speed, "--width", "16 m/s", status=2)
            self.assertIn(
                "the limit lies below 160.00" if option == "--from" else "the limit lies above 120.00", text
            )
            speeds = [float(row["speed_m_s"]) for row in self.limits.rows(f"only {option}")]
            self.assertTrue(min(speeds) >= 160 if option == "--from" else max(speeds) <= 120, speeds)

    def test_takes_a_projectile_whose_outline_stands_in_a_file(self):
        self.limits.v50("shape", *ENDS[:4], "--width", "130 m/s", *self.limits.profile(), ranks=2)
        self.limit("shape")

    def test_speaks_in_the_unit_of_its_options(self):
        text = self.limits.v50("feet", "--from", "200 ft/s", "--to", "800 ft/s", "--width", "160 ft/s")
        self.assertRegex(text, r"limit +\d+\.\d\d to \d+\.\d\d ft/s \(\d+\.\d\d to \d+\.\d\d m/s\)")
        self.assertEqual(self.limits.found("feet")["unit"]["name"], "ft/s")

    def test_a_limit_beyond_the_ends_is_an_error_that_keeps_the_shots(self):
        text = self.limits.v50("beyond", "--from", "250 m/s", "--to", "300 m/s", status=2)
        self.assertIn("the limit lies below 250.00 m/s, the lowest speed allowed", text)
        self.assertEqual({row["result"] for row in self.limits.rows("beyond")}, {"complete"})

    def test_shots_that_the_guard_stops_are_rows_and_not_the_end_of_others(self):
        tight = "limits.energy_error=1e-9"
        text = self.limits.v50("guarded", *ENDS, "--set", tight, status=1)
        rows = self.limits.rows("guarded")
        self.assertEqual([row["outcome"] for row in rows], ["stopped"] * 3)
        self.assertEqual({row["result"] for row in rows}, {"none"})
        self.assertIn("3 shots inside the bracket gave no result", text)
        self.assertIn("stopped by the guard: ", text)

    def test_finds_the_limits_of_other_meshes_and_stiffnesses(self):
        self.limits.v50("variants", *ENDS, "--mesh", "1.5 mm, 2 mm", "--stiffness", "0.5")
        found = self.limits.found("variants")
        # The mesh of the scene itself is not computed twice.
        self.assertEqual(
            [limit["variant"] for limit in found["limits"]], ["scene", "mesh 2 mm", "stiffness x 0.5"]
        )
        middles = [self.limit("variants", i)["middle"] for i in range(3)]
        self.assertAlmostEqual(found["spread"], max(middles) - min(middles), places=9)
        self.assertEqual(middles[0], self.limit("whole")["middle"])
        # As shots of a range, those of other meshes are left out.
        text = self.limits.v50("of variants", *ENDS, "--shots", self.folder / "variants/v50.csv")
        self.assertIn(f"range         {found['limits'][0]['shots']} shots added to the fit", text)

    def test_any_ply_counts_where_it_is_asked_for(self):
        self.limits.v50("any ply", *ENDS, "--complete", "any-ply")
        for row in self.limits.rows("any ply"):
            self.assertEqual(row["result"], "partial" if row["plies_perforated"] == "0" else "complete")
        self.limits.v50("witness", *ENDS, "--complete", "witness 100 m/s")
        self.assertGreater(self.limit("witness")["partial"], self.limit("whole")["partial"])

    def test_scatter_gives_an_s_curve(self):
        scatter = "fabrics.a.failure.static_strain=normal(3.3 %, 0.8 %)"
        options = ("--from", "80 m/s", "--to", "220 m/s", "--count", "12", "--sigma", "15 m/s")
        self.limits.v50("scatter", *options, "--scatter", scatter)
        rows, found = self.limits.rows("scatter"), self.limits.found("scatter")
        self.assertEqual(len(rows), 12)
        strains = [float(row["fabrics.a.failure.static_strain"].split()[0]) for row in rows]
        self.assertEqual(len(set(strains)), 12)
        if found["normal"]["refused"] is None:
            self.assertTrue(found["normal"]["sigma"]["lower"] < found["normal"]["sigma"]["value"])
            self.assertTrue(60 < found["normal"]["v50"]["value"] < 300)
        else:
            self.assertIsNone(found["mixed_results"])

    def test_random_strength_is_drawn_anew_for_each_shot(self):
        strength = "fabrics.a.failure.scatter={weibull_modulus: 10, gauge_length: 50 mm}"
        options = ("--from", "80 m/s", "--to", "220 m/s", "--count", "3", "--seed", "5")
        self.limits.v50("strength", *options, "--set", strength, "--set", "target.symmetry=[]")
        seeds = [row["fabrics.a.failure.scatter.seed"] for row in self.limits.rows("strength")]
        self.assertEqual(seeds, ["6", "7", "8"])

    def test_shots_of_a_range_join_the_fit(self):
        limit = self.limit("whole")["middle"]
        (self.folder / "range.csv").write_text(
            "date,speed,result\n"
            f"1 May,{limit + 12} m/s,partial\n"
            f"1 May,{(limit - 14) / 0.3048} ft/s,complete\n"
        )
        text = self.limits.v50("with range", *ENDS, "--shots", self.folder / "range.csv")
        found = self.limits.found("with range")
        self.assertIsNone(found["normal"]["refused"], text)
        self.assertEqual(sum(shot["variant"] == "range" for shot in found["shots"]), 2)
        self.assertAlmostEqual(found["mixed_results"]["highest_partial"], limit + 12, places=9)
        # Our own table is one that the option takes.
        again = self.limits.v50("again", *ENDS, "--shots", self.folder / "with range/v50.csv")
        self.assertIn("range         ", again)

    def test_refuses_a_folder_that_holds_a_v50_unless_it_is_told_what_to_do(self):
        self.limits.v50("kept", "--from", "50 m/s", "--to", "300 m/s", "--width", "130 m/s")
        self.assertIn(
            "--restart auto goes on with it, --overwrite replaces it",
            self.limits.v50("kept", *ENDS, status=2),
        )
        self.limits.v50("kept", "--from", "100 m/s", "--to", "200 m/s", "--width", "50 m/s", "--overwrite")
        folders = {path.name for path in (self.folder / "kept").iterdir() if path.is_dir()}
        self.assertEqual(folders, {row["folder"] for row in self.limits.rows("kept")})


if __name__ == "__main__":
    unittest.main()
