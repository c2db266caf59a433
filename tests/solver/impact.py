"""The example's impacts on a mesh of 2 mm come out as in the committed study of meshes: impact.py WEAVEFRONT
SCENE STUDY_CSV

Contact is integrated over facets, as users have it. At 267 and 428 m/s the projectile is thrown back and
nothing breaks."""

import csv
import sys
import tempfile
from pathlib import Path

import runs

# The study's own: what a compiler and its options may change.
TOLERANCE = 0.01


def expected(table, speed):
    with open(table, newline="") as file:
        (row,) = (
            row
            for row in csv.DictReader(file)
            if row["variant"] == f"velocity.2={speed}m_s,formulation=consistent,safety=0.9,center=2mm"
        )
    return {name: float(row[name]) for name in ("absorbed_energy", "peak_displacement")}


def main():
    program, scene, table = runs.Program(sys.argv[1]), *sys.argv[2:]
    for speed in (267, 428):
        with tempfile.TemporaryDirectory() as folder:
            program.run(
                scene,
                Path(folder),
                [
                    f"projectile.velocity.2={speed} m/s",
                    "time.end=120 us",
                    "output.interval=0",
                    "target.mesh.edge=4 mm",
                    "target.mesh.center=2 mm",
                ],
            )
            rows = runs.history(Path(folder))
        found = {
            "absorbed_energy": rows[0]["kinetic_projectile"] - rows[-1]["kinetic_projectile"],
            "peak_displacement": max(row["max_displacement"] for row in rows),
        }
        print(speed, found)
        assert rows[-1]["projectile_vz"] < 0 and rows[-1]["broken_yarns"] == 0
        for name, value in expected(table, speed).items():
            assert abs(found[name] / value - 1) < TOLERANCE, (speed, name, found[name], value)


main()
