"""What 'weavefront study' does with whole studies: command.py WEAVEFRONT MPIEXEC"""

import csv
import json
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

WEAVEFRONT, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)

SCENE = """
fabrics:
  a:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.9 mm, area: 0.06 mm^2, width: 0.3 mm}
    thickness: 0.2 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    transverse_shear: 2.5 GPa
target:
  size: [40 mm, 40 mm]
  plies: {count: 1, fabric: a}
  mesh: {center: 2 mm, edge: 4 mm}
  symmetry: [x, y]
projectile: {shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 100 m/s]}
contact: {projectile: {}}
time: {end: 10 us}
output: {interval: 10 us, history: 1 us}
"""
STUDY = """
scene: scene.yaml
variants:
  - {target.mesh.center: [4 mm, 2.5 mm, 2 mm]}
  - {projectile.velocity.2: [100 m/s, 50 m/s]}
order: target.mesh.center
reference: {variant: {target.mesh.center: 1.5 mm}}
quantities: [residual_velocity, {history: projectile_vz, norm: l2}, {field: displacement, time: 10 us}]
tolerance: {residual_velocity: 1 %}
"""


class Study(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)
        (self.folder / "scene.yaml").write_text(SCENE)

    def run_study(self, text=STUDY, output="out", ranks=1, status=0, arguments=(), picture=False):
        """Runs the study; returns what it printed and wrote to standard error."""
        (self.folder / "study.yaml").write_text(text)
        command = [MPIEXEC, "-n", str(ranks)] if ranks > 1 else []
        command += [
            WEAVEFRONT,
            "study",
            self.folder / "study.yaml",
            "--output",
            self.folder / output,
            *arguments,
        ]
        command += [] if picture else ["--no-picture"]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def rows(self, output="out"):
        with open(self.folder / output / "study.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_writes_a_row_for_each_variant_and_reference(self):
        self.run_study(picture=True)
        rows = self.rows()
        self.assertEqual(
            [row["target.mesh.center"] for row in rows],
            ["4 mm", "4 mm", "2.5 mm", "2.5 mm", "2 mm", "2 mm", "1.5 mm", "1.5 mm"],
        )
        self.assertTrue(
            all(
                row["outcome"] == "finished"
                and int(row["element_steps"]) > 0
                and float(row["wall_seconds"]) > 0
                for row in rows
            )
        )
        self.assertTrue(all(float(row["displacement_field_error"]) > 0 for row in rows[:6]))
        self.assertEqual({row["residual_velocity_error"] for row in rows[6:]}, {"0"})
        study = json.loads((self.folder / "out/study.json").read_text())
        self.assertEqual(len(study["quantities"][0]["series"]), 2)
        self.assertTrue(any(study["quantities"][0]["pareto"]["element_steps"]))
        self.assertTrue((self.folder / "out/study.png").read_bytes().startswith(b"\x89PNG"))
        for row in rows:
            self.assertTrue(
                (self.folder / "out" / row["variant"] / "results.vtkhdf").exists(), row["variant"]
            )

    def test_peak_displacement_is_the_largest_of_the_whole_run(self):
        # Light enough to be thrown back well before the end.
        text = STUDY.replace("residual_velocity", "peak_displacement").replace(
            "order:", "set: {projectile.mass: 0.01 g, time.end: 60 us}\norder:"
        )
        self.run_study(text, ranks=2)
        for row in self.rows():
            with open(self.folder / "out" / row["variant"] / "history.csv", newline="") as file:
                displacements = [float(line["max_displacement"]) for line in csv.DictReader(file)]
            self.assertLess(displacements[-1], 0.9 * max(displacements))
            self.assertAlmostEqual(float(row["peak_displacement"]) / max(displacements), 1, places=8)

    def test_is_the_same_on_any_number_of_ranks(self):
        tables = []
        for ranks in (1, 2, 3):
            self.run_study(output=f"on{ranks}", ranks=ranks)
            tables.append(
                [
                    {k: v for k, v in row.items() if k not in ("wall_seconds", "ranks")}
                    for row in self.rows(f"on{ranks}")
                ]
            )
        self.assertEqual(tables[0], tables[1])
        self.assertEqual(tables[0], tables[2])

    def test_goes_on_where_it_was_interrupted(self):
        self.run_study()
        before = self.rows()
        kept, torn, gone = (self.folder / "out" / before[i]["variant"] for i in range(3))
        kept_at = (kept / "summary.json").stat().st_mtime_ns
        (torn / "summary.json").unlink()  # as after a kill in its middle
        for file in gone.iterdir():
            file.unlink()
        gone.rmdir()
        text = self.run_study()
        self.assertIn("8, of them 6 computed before", text)
        self.assertEqual((kept / "summary.json").stat().st_mtime_ns, kept_at)
        self.assertTrue((torn / "summary.json").exists() and (gone / "summary.json").exists())
        strip = [{k: v for k, v in row.items() if k != "wall_seconds"} for row in before]
        self.assertEqual(
            [{k: v for k, v in row.items() if k != "wall_seconds"} for row in self.rows()], strip
        )

    def test_repeats_variants_whose_summary_is_somebody_elses(self):
        self.run_study()
        for variant, summary in zip(self.rows(), ("[]", "{}", '{"scene_hash": 1, "versions": 2}', "3", "")):
            (self.folder / "out" / variant["variant"] / "summary.json").write_text(summary)
        self.assertIn("8, of them 3 computed before", self.run_study(ranks=2))

    def test_repeats_variants_whose_files_were_cut_or_changed(self):
        self.run_study()
        errors = [row["residual_velocity_error"] for row in self.rows()]
        folders = [self.folder / "out" / row["variant"] for row in self.rows()]
        for folder, change in zip(
            folders,
            (
                lambda text: text[: len(text) // 2],
                lambda text: text[: text.index(b"\n") + 1],
                lambda text: text.replace(b"1", b"2", 1),
            ),
        ):
            (folder / "history.csv").write_bytes(change((folder / "history.csv").read_bytes()))
        (folders[3] / "results.vtkhdf").write_bytes((folders[3] / "results.vtkhdf").read_bytes()[:-1000])
        (folders[4] / "history.csv").unlink()
        self.assertIn("8, of them 3 computed before", self.run_study())
        self.assertEqual([row["residual_velocity_error"] for row in self.rows()], errors)

    def test_goes_on_after_a_signal(self):
        text = STUDY.replace(
            "order:", "set: {time.end: 20 ms, output.interval: 0 us, output.history: 10 us}\norder:"
        ).replace(", {field: displacement, time: 10 us}", "")
        (self.folder / "study.yaml").write_text(text)
        process = subprocess.Popen(
            [
                MPIEXEC,
                "-n",
                "2",
                WEAVEFRONT,
                "study",
                self.folder / "study.yaml",
                "--output",
                self.folder / "out",
                "--no-picture",
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        while len(list(self.folder.glob("out/*/summary.json"))) < 2:
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        process.send_signal(signal.SIGUSR1)
        errors = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 4, errors)
        self.assertIn("SIGUSR1 received: computed variants are kept", errors)
        states = [json.loads(path.read_text())["status"] for path in self.folder.glob("out/*/summary.json")]
        self.assertTrue(2 <= states.count("finished") < 8, states)
        self.assertIn(f"8, of them {states.count('finished')} computed before", self.run_study(text))
        self.assertEqual({row["outcome"] for row in self.rows()}, {"finished"})

    def test_refuses_the_folder_of_a_run(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/history.csv").write_text("of a run")
        self.assertIn("out holds a run already (history.csv)", self.run_study(status=2))
        self.assertEqual((self.folder / "out/history.csv").read_text(), "of a run")

    def test_repeats_variants_whose_scene_has_changed(self):
        self.run_study()
        self.assertIn("8, of them 0 computed before", self.run_study(STUDY + "set: {damping: 1 1/s}\n"))

    def test_a_variant_stopped_by_the_guard_is_an_outcome(self):
        text = STUDY.replace("projectile.velocity.2: [100 m/s, 50 m/s]", "limits.energy_error: [1e-12, 5 %]")
        self.run_study(text, ranks=2)
        outcomes = {(row["limits.energy_error"], row["outcome"]) for row in self.rows()}
        self.assertEqual(outcomes, {("1e-12", "stopped"), ("5 %", "finished")})
        study = json.loads((self.folder / "out/study.json").read_text())
        self.assertTrue(any("energy balance" in row["reason"] for row in study["variants"]))

    def test_a_fault_of_one_variant_stops_it_before_anything_is_computed(self):
        text = self.run_study(STUDY.replace("2.5 mm", "25 mm"), status=2)
        self.assertIn("study.yaml:4:33: target.mesh.center: found '25 mm'", text)
        self.assertFalse((self.folder / "out").exists())

    def test_measured_values_are_a_reference(self):
        (self.folder / "measured.csv").write_text(
            "time,projectile_vz,residual_velocity\n0,100,90\n10e-6,100,\n"
        )
        text = STUDY.replace("{variant: {target.mesh.center: 1.5 mm}}", "{file: measured.csv}").replace(
            ", {field: displacement, time: 10 us}", ""
        )
        self.run_study(text)
        self.assertIn(
            "absent.csv: cannot be read",
            self.run_study(text.replace("measured.csv", "absent.csv"), "none", status=2),
        )
        self.assertFalse((self.folder / "none").exists())
        for row in self.rows():
            self.assertAlmostEqual(
                float(row["residual_velocity_error"]),
                abs(float(row["residual_velocity"]) - 90) / 90,
                places=8,
            )
            self.assertGreater(float(row["projectile_vz_l2_error"]), 0)

    def test_refuses_measured_values_that_are_compared_with_nothing(self):
        text = STUDY.replace("{variant: {target.mesh.center: 1.5 mm}}", "{file: measured.csv}").replace(
            ", {field: displacement, time: 10 us}", ""
        )
        for table, message in (
            (
                "time,projectile_vz,residual_velocty\n0,100,90\n",
                "measured.csv:1:20: found column 'residual_velocty'",
            ),
            ("residual_velocty\n90\n", "did you mean 'residual_velocity'?"),
            ("time,projectile_vz\n0,100\n0,90\n", "that ascends"),
            ("projectile_vz\n100\n", "that ascends"),
            (
                "time,projectile_vz\n0,abc\n",
                "measured.csv:2:3: projectile_vz: found 'abc', allowed a finite number",
            ),
            (
                "time,projectile_vz\n0,100\n1e-6,nan\n",
                "measured.csv:3:6: projectile_vz: found 'nan', allowed a finite number",
            ),
            (
                "time,projectile_vz\n0,100\ninf,90\n",
                "measured.csv:3:1: time: found 'inf', allowed a finite number",
            ),
            ("time,projectile_vz\n0,100\n1e-6", "measured.csv:3:1: found 1 cells, allowed 2"),
            (
                "time,projectile_vz\n0,100\n",
                "measured.csv:1:6: projectile_vz: found 1 value, allowed are two or more",
            ),
            (
                "time,projectile_vz\n20e-6,100\n30e-6,90\n",
                "measured.csv:1:6: projectile_vz: found values at 2e-05 to 3e-05 s, of which 0 at the times of "
                "center=4mm,velocity.2=100m_s, 0 to 1e-05 s; allowed are two or more of them",
            ),
            # us for s: all begin at 0
            (
                "time,projectile_vz\n0,100\n5,99\n10,98\n",
                "found values at 0 to 10 s, of which 1 at the times of ",
            ),
            (
                "residual_velocity,time,projectile_vz\n,0,100\n,10e-6,90\n",
                "measured.csv:1:1: residual_velocity: found nothing in the first row",
            ),
        ):
            (self.folder / "measured.csv").write_text(table)
            self.assertIn(message, self.run_study(text, "none", ranks=2, status=2))
            self.assertFalse((self.folder / "none").exists())
        (self.folder / "measured.csv").write_text(
            "\ufefftime,projectile_vz\n0,100\n10e-6,100\n", encoding="utf-8"
        )
        self.run_study(text)
        self.assertTrue(all(row["projectile_vz_l2_error"] for row in self.rows()))

    def test_says_which_ranges_and_units_it_compares(self):
        text = STUDY.replace("{variant: {target.mesh.center: 1.5 mm}}", "{file: measured.csv}").replace(
            ", {field: displacement, time: 10 us}", ""
        )
        (self.folder / "measured.csv").write_text(
            "time,projectile_vz,residual_velocity\n-1e-6,100,95\n5e-6,99,\n8e-6,98,\n"
        )
        said = self.run_study(text)
        self.assertIn(
            "  measured      projectile_vz: 3 values of 98 to 100 m/s at -1e-06 to 8e-06 s; 2 of them at the times of "
            "center=4mm,velocity.2=100m_s, 0 to 1e-05 s\n",
            said,
        )
        self.assertIn("  measured      residual_velocity: 95 m/s\n", said)
        self.assertRegex(
            said, r"  compared      projectile_vz: measured 98 to 100 m/s, computed \d\d\.\d+ to 100 m/s\n"
        )
        self.assertNotIn("warning: measured", said)
        self.assertNotIn("another unit", said)

    def test_warns_of_measured_values_in_other_units(self):
        text = STUDY.replace("{variant: {target.mesh.center: 1.5 mm}}", "{file: measured.csv}").replace(
            ", {field: displacement, time: 10 us}", ""
        )
        (self.folder / "measured.csv").write_text(
            "time,projectile_vz\n0,0.1\n1e-5,0.099\n0.01,0.098\n"
        )  # km/s, and far beyond the run
        said = self.run_study(text)
        self.assertIn(
            "warning: projectile_vz was measured over 1e+03 times the time of the run: another unit than s?",
            said,
        )
        self.assertIn(
            "warning: measured values of projectile_vz are 0.001 times the computed ones: another unit than m/s?",
            said,
        )

    def test_a_reference_may_be_a_named_variant(self):
        text = STUDY.replace(
            "{target.mesh.center: 1.5 mm}", "{target.mesh.center: 2 mm, speed: slow}"
        ).replace(
            "{projectile.velocity.2: [100 m/s, 50 m/s]}",
            "speed: {fast: {projectile.velocity.2: 100 m/s}, slow: {projectile.velocity.2: 50 m/s}}",
        )
        self.run_study(text)
        study = json.loads((self.folder / "out/study.json").read_text())
        self.assertEqual({row["compared_with"] for row in study["variants"]}, {"center=2mm,speed=slow"})
        self.assertEqual(len(study["variants"]), 6)  # the reference is one of them
        self.assertIn(
            "reference.variant.speed: found 'slwo', allowed one of fast, slow, did you mean 'slow'?",
            self.run_study(text.replace("speed: slow}", "speed: slwo}"), "none", status=2),
        )
        # A path that the scene lacks is told with the scene's keys.
        self.assertIn(
            "study.yaml:7:43: target.mesh.centre: found an unknown key, allowed center, edge, growth",
            self.run_study(
                text.replace("{target.mesh.center: 2 mm", "{target.mesh.centre: 2 mm"), "none", status=2
            ),
        )

    def test_check_finds_what_is_off_by_more_than_its_tolerance(self):
        self.run_study()
        table = self.folder / "before.csv"
        table.write_bytes((self.folder / "out/study.csv").read_bytes())
        self.run_study(arguments=("--check", table))
        value = self.rows()[0]["residual_velocity"]
        table.write_text(table.read_text().replace(value, str(float(value) * 1.02)))
        self.assertIn(
            f"residual_velocity is {value}, was", self.run_study(arguments=("--check", table), status=1)
        )
        table.write_text(table.read_text().replace("finished", "stopped"))
        self.assertIn(
            "outcome is finished, was stopped", self.run_study(arguments=("--check", table), status=1)
        )

    def test_check_refuses_a_table_that_cannot_be_compared_before_anything_is_computed(self):
        table = self.folder / "before.csv"
        self.assertIn(
            "before.csv: cannot be read", self.run_study(arguments=("--check", table), ranks=2, status=2)
        )
        table.write_text("variant,outcome,residual_velocity\ncenter=4mm,finished,fast\n")
        text = self.run_study(arguments=("--check", table), ranks=2, status=2)
        self.assertIn("before.csv:2: residual_velocity: found 'fast', allowed a number", text)
        self.assertIn("before.csv: no column residual_velocity_error", text)
        self.assertIn("before.csv: no row of center=4mm,velocity.2=100m_s", text)
        table.write_text("time,residual_velocity\n0,1\n")
        self.assertIn("found the first column 'time'", self.run_study(arguments=("--check", table), status=2))
        self.assertFalse((self.folder / "out").exists())


unittest.main()
