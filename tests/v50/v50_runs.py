"""A small scene with a limit velocity, and commands of v50 on it."""

import csv
import json
import os
import subprocess
from pathlib import Path

SCENE = """
title: Small
fabrics:
  a:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.9 mm, area: 0.06 mm^2, width: 0.3 mm}
    thickness: 0.2 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    failure: {static_strain: 3.3 %, hooke_strain: 2.7 %}
    transverse_shear: 2.5 GPa
target:
  size: [24 mm, 24 mm]
  plies: {count: 2, fabric: a, spacing: 0.25 mm}
  mesh: {center: 1.5 mm, edge: 3 mm}
  symmetry: [x, y]
projectile: {shape: sphere, diameter: 6 mm, mass: 0.3 g, velocity: [0, 0, 200 m/s]}
contact: {projectile: {}, plies: {}}
time: {end: 60 us}
output: {interval: 5 us, history: 0.5 us}
"""


class Limits:
    """The program, the mpirun that starts it and a folder with the scene."""

    def __init__(self, weavefront, mpiexec, folder):
        self.weavefront, self.mpiexec, self.folder = weavefront, mpiexec, Path(folder)
        (self.folder / "scene.yaml").write_text(SCENE)

    def command(self, output, *options, ranks=1, picture=False):
        launcher = [self.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        words = [
            *launcher,
            self.weavefront,
            "v50",
            self.folder / "scene.yaml",
            "--output",
            self.folder / output,
        ]
        return [str(word) for word in (*words, *options, *([] if picture else ["--no-picture"]))]

    def v50(self, output, *options, ranks=1, status=0, picture=False, environment=None):
        """Runs to the end; AssertionError unless it leaves with `status`. Returns what it printed."""
        done = subprocess.run(
            self.command(output, *options, ranks=ranks, picture=picture),
            capture_output=True,
            text=True,
            timeout=250,
            env={**os.environ, **(environment or {})},
        )
        assert done.returncode == status, (done.args, done.returncode, done.stdout, done.stderr)
        return done.stdout + done.stderr

    def profile(self):
        """Options for a flat-nosed projectile whose outline stands in a file."""
        (self.folder / "outline.csv").write_text("0,4\n2.5,4\n2.5,0\n0,0\n")
        outline = f"file: {self.folder / 'outline.csv'}"
        return "--set", f"projectile={{shape: profile, {outline}, mass: 0.3 g, velocity: [0, 0, 200 m/s]}}"

    def rows(self, output):
        with open(self.folder / output / "v50.csv", newline="") as file:
            return list(csv.DictReader(file))

    def found(self, output):
        return json.loads((self.folder / output / "v50.json").read_text())
