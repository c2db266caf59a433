"""The shipped scenes and what the documents say about them: check.py WEAVEFRONT WEAVEFRONT_PLOT MPIEXEC"""

import csv
import json
import math
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

MPIEXEC, PLOT, WEAVEFRONT = sys.argv.pop(), sys.argv.pop(), sys.argv.pop()
ROOT = Path(__file__).resolve().parents[2]
SCENES = sorted((ROOT / "examples").glob("*/*.yaml"))
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "examples").rglob("README.md"))]


def call(*command, status=0):
    """Runs a command; AssertionError unless it leaves with `status`. Returns its standard output."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    assert (
        done.returncode == status
    ), f"{command}: status {done.returncode}, expected {status}\n{done.stdout}{done.stderr}"
    return done.stdout


def code_blocks(text, language):
    """The fenced blocks of one language."""
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def commands(text):
    """Lines of the shell blocks without comments, continued lines joined."""
    lines = "".join(code_blocks(text, "sh")).replace("\\\n", " ").splitlines()
    return [line.split("#")[0].split() for line in lines if line.split("#")[0].strip()]


class Scenes(unittest.TestCase):
    def test_each_is_accepted(self):
        self.assertGreaterEqual(len(SCENES), 5)
        for scene in SCENES:
            with self.subTest(scene=scene.relative_to(ROOT)):
                # Scenes of a fabric alone have no impact to check.
                if "\ntarget:" not in scene.read_text():
                    with tempfile.TemporaryDirectory() as folder:
                        call(WEAVEFRONT, "yarn", scene, "--rates", "1", "--out", Path(folder) / "curve.csv")
                    continue
                warnings = [
                    line
                    for line in call(WEAVEFRONT, "check", scene).splitlines()
                    if line.startswith("warning: ")
                ]
                # The paper's crimp stands for slip in the clamps, too. A strip is hit at a constant speed: by
                # a projectile of no material.
                expected = (
                    ["warning: fabric kevlar129: wit"] if "thickness: 0.820 mm" in scene.read_text() else []
                )
                is_strip = scene.parent.name == "yarn_impact" or scene.name == "strip.yaml"
                expected += ["warning: the projectile weighs"] if is_strip else []
                self.assertEqual([line[:30] for line in warnings], expected)

    def test_a_wrong_one_is_refused(self):
        call(WEAVEFRONT, "check", SCENES[0], "--set", "target.mesh.centre=1 mm", status=2)

    def test_the_scene_in_the_readme_is_accepted(self):
        blocks = [
            block for block in code_blocks((ROOT / "README.md").read_text(), "yaml") if "fabrics:" in block
        ]
        self.assertEqual(len(blocks), 1)
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.yaml"
            scene.write_text(blocks[0])
            self.assertNotIn("warning", call(WEAVEFRONT, "check", scene))


class Documents(unittest.TestCase):
    def test_links_and_pictures_exist(self):
        for document in DOCUMENTS:
            for target in re.findall(r"\]\(([^)#]+)[^)]*\)", document.read_text()):
                with self.subTest(document=document.relative_to(ROOT), target=target):
                    self.assertTrue("://" in target or (document.parent / target).exists())

    def test_commands_exist(self):
        usage = call(WEAVEFRONT, "--help")
        for document in DOCUMENTS:
            for words in commands(document.read_text()):
                with self.subTest(document=document.relative_to(ROOT), command=" ".join(words)):
                    self.check_command(words, usage)

    def check_command(self, words, usage):
        """The program's subcommand and options, the files of the checkout, and what bootstrap.sh is asked
        for."""
        names = [Path(word).name for word in words]
        if "weavefront" in names:
            subcommand = words[names.index("weavefront") + 1]
            self.assertRegex(usage, rf"\n  {subcommand} ")
            self.check_options(words, call(WEAVEFRONT, subcommand, "--help"))
        if "weavefront-plot" in names:
            self.check_options(words, call(PLOT, "--help"))
        if "cmake/bootstrap.sh" in words:
            self.assertIn(f"\n  {words[-1]} ", call("bash", ROOT / "cmake/bootstrap.sh", "--help"))
        for word in words:
            if word.startswith(("examples/", "cmake/")):
                self.assertTrue((ROOT / word).exists(), word)

    def check_options(self, words, usage):
        for option in (word.split("=")[0] for word in words if word.startswith("--")):
            self.assertRegex(usage, rf"{option}\b")


class Collections(unittest.TestCase):
    """The scripts that collect variants skip those in their tables, and say so."""

    def test_say_when_nothing_is_left_to_compute(self):
        for script, table in (("limit.py", "limit.csv"), ("sensitivity.py", "sensitivity.csv")):
            with self.subTest(script=script):
                folder = ROOT / "examples/kevlar129_8ply"
                with open(folder / table, newline="") as file:
                    count = len(list(csv.DictReader(file)))
                # No program is there to compute with.
                said = call(sys.executable, "-B", folder / script, "--weavefront", "/nonexistent")
                self.assertEqual(
                    said,
                    f"{count} of {count} variants are in {folder / table}; to compute one anew, take its line out, "
                    "or give another file with --csv\n",
                )
                call(
                    sys.executable,
                    "-B",
                    folder / script,
                    "--weavefront",
                    "/nonexistent",
                    "--only",
                    "nothing of this name",
                    status=1,
                )


class FiredShots(unittest.TestCase):
    def test_a_limit_is_that_of_the_table(self):
        folder = ROOT / "examples/fired_shots"
        case = ["D", "1 ply, ball 0.70 g", "as stated"]
        with tempfile.TemporaryDirectory() as scratch:
            found = Path(scratch) / "limits.csv"
            options = ["--csv", found, "--output", Path(scratch) / "runs", "--only", " | ".join(case)]
            call(sys.executable, "-B", folder / "compare.py", "--weavefront", WEAVEFRONT, *options)
            with open(found, newline="") as computed, open(folder / "limits.csv", newline="") as stated:
                rows = [row for row in csv.reader(stated) if row[:3] == case]
                self.assertEqual(list(csv.reader(computed))[1:], rows)

    def test_measured_values_of_the_table_are_those_of_its_source(self):
        """Cunniff's regression, with areal density, presented area and mass of the scenes."""
        shots = tomllib.loads((ROOT / "examples/fired_shots/shots.toml").read_text())
        grain, steel, ball = 64.79891e-6, 7850, (5.55625e-3, 0.7005e-3)
        for name, case in shots["C"]["cases"].items():
            plies, projectile = re.fullmatch(r"(\d+) plies, (.*)", name).groups()
            diameter, mass = ball
            if projectile.endswith("gr"):
                mass = int(projectile.split()[0]) * grain
                diameter = (4 * mass / (math.pi * steel)) ** (1 / 3)
            ratio = int(plies) * 0.180 * math.pi * diameter**2 / 4 / mass
            speed = 125.82 * math.exp(2.7104 * ratio**0.2728)
            self.assertEqual(case["measured"], round(speed), name)


class CoarseImpact(unittest.TestCase):
    """The demo: the 428 m/s example on a mesh of 2 mm by two ranks."""

    def test_runs_to_its_end_and_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "run"
            scene = ROOT / "examples/kevlar129_8ply/impact_428.yaml"
            call(
                MPIEXEC,
                "-n",
                "2",
                WEAVEFRONT,
                "run",
                scene,
                "--set",
                "target.mesh.center=2 mm",
                "--output",
                output,
            )
            self.check_files(output)
            pictures = call(PLOT, output).split()
            for name in ("history", "energies", "section"):
                picture = output / "plots" / f"{name}.png"
                self.assertIn(str(picture), pictures)
                self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def check_files(self, output):
        summary = json.loads((output / "summary.json").read_text())
        self.assertEqual((summary["status"], summary["ranks"]), ("finished", 2))
        self.assertGreaterEqual(summary["time"], 120e-6)
        with open(output / "history.csv", newline="") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        self.assertGreater(len(rows), 200)  # every 0.5 us
        self.assertTrue(all(math.isfinite(value) for row in rows for value in row.values()))
        # What the documents promise of all shipped impacts, and by how much energy can be lost before
        # outcomes are in doubt.
        self.assertLess(max(abs(row["energy_error"]) for row in rows), 0.01)
        self.assertGreater(rows[-1]["broken_yarns"], 0)
        self.assertLess(rows[-1]["kinetic_projectile"], rows[0]["kinetic_projectile"])


unittest.main()
