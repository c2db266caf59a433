"""What 'weavefront partition' does with whole scenes: command.py WEAVEFRONT MPIEXEC"""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

WEAVEFRONT, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)

# 2 plies of 20 x 20 columns.
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
  plies: {count: 2, fabric: a, spacing: 0.2 mm}
  mesh: {center: 2 mm, edge: 2 mm}
projectile: {shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 400 m/s]}
contact: {projectile: {}, plies: {}}
time: {end: 40 us}
output: {interval: 0, history: 1 us}
"""
MACHINE = {
    "machine": "by hand",
    "ranks": 1,
    "reference_ns": 50,
    "crowding": 1,
    "element_ns": 100,
    "node_ns": 20,
    "watch_ns": 0,
    "touch_ns": 0,
    "press_ns": 0,
    "decay": 0,
    "search_ns": 0,
    "searches_per_step": 0,
    "latency_us": 0,
    "bandwidth_GB_per_s": 1e9,
    "reduction_us": 0,
}


class Partition(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)
        (self.folder / "scene.yaml").write_text(SCENE)

    def call(self, *options, processes=1, status=0):
        command = [MPIEXEC, "-n", str(processes)] if processes > 1 else []
        done = subprocess.run(
            [*command, WEAVEFRONT, "partition", "scene.yaml", *options],
            cwd=self.folder,
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def refusal(self, *options, status=2, **more):
        message = self.call(*options, status=status, **more).stderr
        self.assertEqual(message.count("weavefront: error:"), 1, message)
        return next(line for line in message.splitlines() if line.startswith("weavefront: error:"))

    def machine(self, **changes):
        (self.folder / "machine.json").write_text(json.dumps(MACHINE | changes))

    def test_table(self):
        done = self.call("--ranks", "1,2,7,400", "--out", "table.csv")
        rows = self.rows("table.csv")
        self.assertEqual(
            list(rows[0]),
            [
                "ranks",
                "elements",
                "columns",
                "element_imbalance",
                "cost_imbalance",
                "cut_edges",
                "most_neighbours",
                "most_halo_bytes",
                "halo_bytes",
                "step_seconds",
                "efficiency",
                "measured_seconds",
                "measured_slowdown",
            ],
        )
        self.assertEqual([row["ranks"] for row in rows], ["1", "2", "7", "400"])
        self.assertTrue(
            all(
                row["elements"] == "800" and row["columns"] == "400" and row["measured_seconds"] == ""
                for row in rows
            )
        )
        self.assertEqual((rows[0]["efficiency"], rows[0]["halo_bytes"]), ("1", "0"))
        # One column a rank: all 760 inner faces are cut, and a column in the middle has eight around it.
        self.assertEqual(
            (rows[3]["cut_edges"], rows[3]["most_neighbours"], rows[3]["element_imbalance"]),
            ("760", "8", "1"),
        )
        self.assertEqual(len(done.stdout.splitlines()), 2 + 2 + 4)

    def test_same_bytes_on_any_number_of_processes(self):
        for processes in (1, 2, 3):
            self.call("--ranks", "1,5,64", "--out", f"{processes}.csv", processes=processes)
        files = [(self.folder / f"{processes}.csv").read_bytes() for processes in (1, 2, 3)]
        self.assertEqual(files, [files[0]] * 3)

    def test_machine_and_weak_scaling(self):
        self.machine()
        self.call("--ranks", "1,4", "--machine", "machine.json", "--out", "strong.csv")
        self.assertAlmostEqual(
            float(self.rows("strong.csv")[0]["step_seconds"]), 800 * 100e-9 + 882 * 20e-9, delta=1e-15
        )
        self.call("--ranks", "1,4", "--weak", "--machine", "machine.json", "--out", "weak.csv")
        weak = self.rows("weak.csv")
        self.assertEqual([row["elements"] for row in weak], ["800", "3200"])
        # With nothing but elements and nodes to pay for, only nodes on the cuts and the balance of columns
        # are lost.
        self.assertGreater(float(weak[1]["efficiency"]), 0.9)

    def test_calibrates_and_measures(self):
        finer = ("--set", "target.mesh={center: 1 mm}", "--set", "time.end=60 us", "--repetitions", "1")
        self.call("--calibrate", "here.json", *finer, processes=2)
        machine = json.loads((self.folder / "here.json").read_text())
        self.assertEqual(set(machine), set(MACHINE))
        self.assertEqual(machine["ranks"], 2)
        self.assertTrue(
            all(
                machine[key] > 0
                for key in (
                    "element_ns",
                    "node_ns",
                    "touch_ns",
                    "press_ns",
                    "latency_us",
                    "bandwidth_GB_per_s",
                    "reduction_us",
                )
            )
        )
        self.call(
            "--ranks",
            "1,2,4",
            "--measure",
            *finer,
            "--machine",
            "here.json",
            "--out",
            "table.csv",
            processes=2,
        )
        measured = [row["measured_seconds"] for row in self.rows("table.csv")]
        self.assertEqual([seconds != "" for seconds in measured], [True, True, False])
        # The same steps that the constants were fitted to, in processor time and at the speed of the
        # processor.
        alone = self.rows("table.csv")[0]
        self.assertLess(
            abs(float(alone["step_seconds"]) * float(alone["measured_slowdown"]) / float(measured[0]) - 1),
            0.5,
        )

    def test_a_guard_stop_of_measured_steps_ends_all_processes(self):
        stiff = ("--set", "contact.projectile={stiffness: 1e308 N/m^3}")
        for options in (
            ("--ranks", "1", "--measure"),
            ("--ranks", "1,2", "--measure"),
            ("--calibrate", "here.json"),
        ):
            self.assertIn(
                "the time step vanished", self.refusal(*options, *stiff, processes=2, status=1), options
            )

    def test_refusals(self):
        for ranks in ("0", "-3", "2.5", "many", "100001", "0x10"):
            self.assertIn(
                f"--ranks: found '{ranks}', allowed a whole number from 1 to 100000",
                self.refusal(f"--ranks={ranks}"),
            )
        self.assertIn("--ranks: found '', allowed a whole number", self.refusal("--ranks", "1,,2"))
        self.assertIn(
            "--ranks: found 401, allowed at most 400, the columns", self.refusal("--ranks", "2,401")
        )
        self.assertIn("one of --ranks LIST and --calibrate FILE", self.refusal())
        self.assertIn(
            "one of --ranks LIST and --calibrate FILE", self.refusal("--ranks", "2", "--calibrate", "m.json")
        )
        self.assertIn("--repetitions: found 0", self.refusal("--ranks", "2", "--repetitions", "0"))
        self.assertIn("option '--rank': unknown", self.refusal("--rank", "2"))
        self.assertIn("none.json: cannot be read", self.refusal("--ranks", "2", "--machine", "none.json"))
        self.assertIn(
            "--calibrate: found 1 rank, allowed are 2 or more", self.refusal("--calibrate", "m.json")
        )
        self.assertIn(
            "--calibrate: allowed is a scene with a projectile and contact between plies",
            self.refusal("--calibrate", "m.json", "--set", "target.plies.count=1", processes=2),
        )
        self.assertIn(
            "allowed are at least",
            self.refusal("--calibrate", "m.json", "--set", "time.end=1 us", processes=2),
        )
        self.assertFalse((self.folder / "m.json").exists())

    def test_refused_machines(self):
        for changes, message in (
            ({"elment_ns": 1}, ":1:274: elment_ns: found an unknown key"),
            (
                {"element_ns": "fast"},
                ':1:71: element_ns: found "fast", allowed a number of at least 0 and at most 1000000000',
            ),
            ({"element_ns": [1, {"element_ns": 2}]}, ":1:71: element_ns: found [], allowed a number"),
            ({"crowding": 0.5}, ":1:56: crowding: found 0.5, allowed a number of at least 1"),
            ({"ranks": 0}, ":1:24: ranks: found 0, allowed a whole number from 1 to 1000000"),
            (
                {"element_ns": 1e308},
                ":1:71: element_ns: found 1e+308, allowed a number of at least 0 and at most 1000000000",
            ),
            ({"element_ns": float("nan")}, ":1:85: not JSON: syntax error"),
            ({"element_ns": float("inf")}, ":1:85: not JSON: syntax error"),
        ):
            self.machine(**changes)
            self.assertIn("machine.json" + message, self.refusal("--ranks", "2", "--machine", "machine.json"))
        text = json.dumps(MACHINE, indent=1)
        for wrong, messages in (
            (
                text.replace('"node_ns": 20', '"node_ns": 20,\n "node_ns": 21'),
                [":8:2: node_ns: found the key again, first at machine.json:7:2, allowed once"],
            ),
            (
                text.replace('"node_ns": 20,', '"node_ns": 20'),
                [":8:11: not JSON: syntax error while parsing object"],
            ),
            (
                text.replace('"node_ns": 20', '"node_ns": -1').replace('"decay": 0', '"deacy": 0'),
                [
                    ":1:1: decay: found nothing",
                    ":7:2: node_ns: found -1",
                    ":11:2: deacy: found an unknown key",
                ],
            ),
            ("machine: x", [":1:1: not JSON: syntax error while parsing value"]),
            ("[1]", [":1:1: found no object"]),
            ("{}", [f":1:1: {key}: found nothing, allowed are all of machine, ranks, " for key in MACHINE]),
        ):
            (self.folder / "machine.json").write_text(wrong)
            lines = self.call("--ranks", "2", "--machine", "machine.json", status=2).stderr.splitlines()
            self.assertEqual(len(lines), len(messages), lines)
            for line, message in zip(sorted(lines), sorted(messages)):
                self.assertIn("machine.json" + message, line)

    def test_metis_prints_nothing_into_the_table(self):
        # Seven columns a rank, some far dearer than others: METIS complains of graphs without vertices while
        # it bisects them.
        fabric = (
            "{areal_density: 204 g/m^2, density: 1440 kg/m^3, yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}, thickness: 0.82 mm, "
            "elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}}"
        )
        changes = (
            f"fabrics.a={fabric}",
            "target.size=[100 mm, 100 mm]",
            "target.plies.spacing=0.25 mm",
            "target.mesh={center: 1 mm, edge: 3 mm}",
            "target.symmetry=[x, y]",
            "projectile.velocity.2=200 m/s",
            "time.end=60 us",
        )
        ranks = [78, 80, 90]
        done = self.call(
            "--ranks", ",".join(map(str, ranks)), *(word for change in changes for word in ("--set", change))
        )
        self.assertEqual(len(done.stdout.splitlines()), 2 + 2 + len(ranks), done.stdout)
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    unittest.main()
