"""What `check`, `cell` and `yarn` say and take, without MPI, also under its launcher: check.py WEAVEFRONT
SCENE MPIEXEC"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

WEAVEFRONT, SCENE, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)


class Check(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)

    def call(self, *arguments, status=0, launcher=(), variables=None):
        environment = dict(os.environ, **(variables or {}))
        done = subprocess.run(
            [*launcher, WEAVEFRONT, *map(str, arguments)],
            capture_output=True,
            text=True,
            cwd=self.folder,
            env=environment,
            timeout=60,
        )
        self.assertTrue(
            done.returncode == status or (status is None and done.returncode != 0), done.stdout + done.stderr
        )
        return done.stdout + done.stderr

    def check(self, *overrides):
        return self.call("check", SCENE, *(word for override in overrides for word in ("--set", override)))

    def line(self, key, *overrides):
        return next(line for line in self.check(*overrides).splitlines() if line.startswith(f"  {key} "))

    def test_says_where_the_contact_thickness_comes_from_and_how_much_air_is_between_plies(self):
        self.assertEqual(
            self.line("fabric", "fabrics.kevlar129.contact_thickness=0.2 mm"),
            "  fabric     kevlar129: plies touch at 0.2 mm (contact_thickness)",
        )
        self.assertRegex(self.line("fabric"), r"kevlar129: plies touch at [0-9.]+ mm \([^)]+\)$")
        touching = "fabrics.kevlar129.contact_thickness=0.2 mm"
        self.assertEqual(self.line("air", touching), "  air        0.05 mm between the plies")
        self.assertEqual(
            self.line("air", touching, "target.plies.spacing=", "target.plies.gap=0"),
            "  air        0 mm between the plies",
        )
        plies = "target.plies=[{fabric: kevlar129}, {fabric: kevlar129, gap: 0.1 mm}, {fabric: kevlar129, gap: 1 mm}]"
        self.assertEqual(self.line("air", touching, plies), "  air        0.1 mm to 1 mm between the plies")
        self.assertNotIn("  air ", self.check("target.plies.count=1"))

    def test_says_which_failure_criterion_decides_without_viscosity(self):
        self.assertNotIn("without viscosity", self.check())
        without = "fabrics.kevlar129.elastic.viscosity=0"
        # 192/96 x 2.7 % = 5.4 %, above the static strain of 3.3 %
        self.assertTrue(
            self.line("fabric", without).endswith(
                "; without viscosity yarns break at 3.3 %, by static_strain"
            )
        )
        self.assertTrue(
            self.line("fabric", without, "fabrics.kevlar129.failure.hooke_strain=1.5 %").endswith(
                "; without viscosity yarns break at 3 %, by hooke_strain"
            )
        )

    def test_says_what_limits_the_time_step(self):
        self.assertRegex(
            self.line("time step"), r"ns, limited by the contact of plies; elements alone allow [0-9.]+ ns$"
        )
        self.assertRegex(
            self.line("time step", "target.plies.count=1"),
            r"limited by the contact of the projectile; elements alone allow",
        )
        alone = (
            "target.plies.count=1",
            "projectile=",
            "contact=",
            "target.edges.y=frame",
            "target.frame={opening: {y: 180 mm}}",
        )
        self.assertRegex(
            self.line("time step", *alone), r"limited by the contact of the frame; elements alone allow"
        )
        self.assertRegex(
            self.line("time step", "contact.plies=", "contact.projectile.stiffness=1e9 N/m^3"),
            r"ns, limited by the elements, whose shortest edge is [0-9.]+ mm$",
        )

    def test_estimates_the_run_time_for_the_machine_of_the_cost_model(self):
        self.assertRegex(
            self.line("run time"),
            r"about [0-9.]+ s on one rank without set-up and output, estimated for one core of: .+",
        )
        self.assertRegex(self.line("run time", "time.safety=0.009"), r"about \d+ min")

    def test_tells_a_vanishing_step_before_it_finds_nothing_to_object_to(self):
        text = self.call("check", SCENE, "--set", "contact.projectile.stiffness=1e308 N/m^3", status=1)
        self.assertIn("the time step vanishes", text)
        self.assertNotIn("nothing to object to", text)

    def test_needs_seconds_at_most_for_any_grading(self):
        self.assertIn(
            "2 plies of", self.check("target.plies.count=2", "target.mesh={center: 0.001 um, edge: 3 mm}")
        )

    def test_works_where_mpi_cannot_start(self):
        broken = {"OMPI_MCA_pml": "no_such_component"}
        (self.folder / "path.csv").write_text("time,F11,F12,F21,F22\n0,1,0,0,1\n1e-6,1.001,0,0,1\n")
        self.call("run", SCENE, "--set", "time.end=1 us", status=None, variables=broken)  # it does break MPI
        self.call("check", SCENE, variables=broken)
        self.call("yarn", SCENE, "--rates", "1", "--out", "yarn.csv", variables=broken)
        self.call("cell", SCENE, "--path", "path.csv", "--out", "cell.csv", variables=broken)

    def test_copies_under_a_launcher_print_and_write_once(self):
        launcher = (MPIEXEC, "-n", "3")
        self.assertEqual(self.call("check", SCENE, launcher=launcher).count("title"), 1)
        self.call("yarn", SCENE, "--rates", "1", "--out", "yarn.csv", launcher=launcher)
        self.assertGreater(len((self.folder / "yarn.csv").read_text().splitlines()), 100)
        self.assertEqual(
            self.call("check", "none.yaml", status=2, launcher=launcher).count("none.yaml: cannot be read"), 1
        )

    def test_cell_and_yarn_take_overrides(self):
        (self.folder / "path.csv").write_text("time,F11,F12,F21,F22\n0,1,0,0,1\n1e-6,1.001,0,0,1\n")
        for command in (("yarn", SCENE, "--rates", "1"), ("cell", SCENE, "--path", "path.csv")):
            self.call(*command, "--out", "a.csv")
            self.call(*command, "--out", "b.csv", "--set", "fabrics.kevlar129.elastic.static_modulus=90 GPa")
            self.assertNotEqual((self.folder / "a.csv").read_text(), (self.folder / "b.csv").read_text())
            self.assertIn(
                "did you mean 'friction'?",
                self.call(*command, "--out", "c.csv", "--set", "fabrics.kevlar129.fricton=1", status=2),
            )

    def test_texts_that_are_not_utf8_are_refused_before_anything_runs(self):
        scene, study, path = self.folder / "scene.yaml", self.folder / "study.yaml", self.folder / "path.csv"
        text = Path(SCENE).read_text()
        scene.write_bytes(b"title: Sto\xdf auf Gewebe\n" + text[text.index("fabrics:") :].encode())
        where = "scene.yaml:1:11: found the byte 0xDF ('ß' in Latin-1), allowed text in UTF-8"
        for command in (
            ("check", scene),
            ("run", scene),
            ("yarn", scene, "--rates", "1", "--out", "y.csv"),
            ("partition", scene, "--ranks", "2"),
        ):
            self.assertIn(where, self.call(*command, status=2))
        study.write_bytes(b"# Zw\xf6lf Lagen\nscene: x.yaml\n")
        self.assertIn("study.yaml:1:5: found the byte 0xF6", self.call("study", study, status=2))
        study.write_text(
            f"scene: {SCENE}\nvariants:\n  - {{damping: [1 1/s]}}\nreference: {{file: m.csv}}\nquantities: [residual_velocity]\n"
        )
        (self.folder / "m.csv").write_bytes(b"residual_velocity\n# \xb5s\n1\n")
        self.assertIn("m.csv:2:3: found the byte 0xB5", self.call("study", study, "--output", "o", status=2))
        (self.folder / "table.csv").write_bytes(b"variant\n\xb5\n")
        study.write_text(study.read_text().replace("reference: {file: m.csv}\n", ""))
        self.assertIn(
            "table.csv:2:1: found the byte 0xB5",
            self.call("study", study, "--output", "o", "--check", "table.csv", status=2),
        )
        path.write_bytes(b"time,F11,F12,F21,F22\n0,1,0,0,1\xa0\n")
        self.assertIn(
            "path.csv:2:10: found the byte 0xA0",
            self.call("cell", SCENE, "--path", path, "--out", "c.csv", status=2),
        )
        (self.folder / "machine.json").write_bytes(b'{"machine": "Zw\xf6lf"}')
        self.assertIn(
            "machine.json:1:16: found the byte 0xF6",
            self.call("partition", SCENE, "--ranks", "2", "--machine", "machine.json", status=2),
        )
        self.assertIn(
            "--set title=Sto<0xDF>: found the byte 0xDF",
            self.call("check", SCENE, "--set", "title=Sto\udcdf", status=2),
        )
        self.assertEqual(
            {file.name for file in self.folder.iterdir()},
            {"scene.yaml", "study.yaml", "m.csv", "table.csv", "path.csv", "machine.json"},
        )

    def test_files_without_end_are_refused(self):
        os.mkfifo(self.folder / "pipe")
        for endless in ("/dev/zero", "pipe"):
            for command in (
                ("check", endless),
                ("run", endless),
                ("study", endless),
                ("cell", SCENE, "--path", endless, "--out", "c.csv"),
                ("partition", SCENE, "--ranks", "2", "--machine", endless),
            ):
                self.assertIn(
                    f"{endless}: cannot be read: it is a pipe, a socket or a device",
                    self.call(*command, status=2),
                )

    def test_many_faults_are_counted_not_shown(self):
        scene = self.folder / "scene.yaml"
        scene.write_text(Path(SCENE).read_text() + "".join(f"key{i}: 1\n" for i in range(60_000)))
        lines = self.call("check", scene, status=2).splitlines()
        self.assertEqual((len(lines), lines[-1]), (21, "weavefront: error: and 59980 more"))
        scene.write_text("x" * 5_000_000)
        self.assertIn("found a file of more than 4000000 bytes", self.call("check", scene, status=2))


unittest.main()
