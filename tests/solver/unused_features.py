"""A feature that never acts leaves the same history as one that the scene does not ask for:
unused_features.py WEAVEFRONT SCENE"""

import sys
import tempfile
from pathlib import Path

import runs

FABRIC = "fabrics.kevlar129"
# A short shot at a part of the scene that nothing breaks.
BASE = [
    f"{FABRIC}.failure=",
    "projectile.velocity=[40 m/s, 0, 200 m/s]",
    "time.end=15 us",
    "output.interval=5 us",
]
SAME = {
    "friction of zero": ([f"{FABRIC}.friction="], [f"{FABRIC}.friction=0"]),
    "viscosity of zero": (
        [f"{FABRIC}.elastic={{static_modulus: 96 GPa, hooke_modulus: 192 GPa}}"],
        [f"{FABRIC}.elastic.viscosity=0"],
    ),
    "damping of zero": (["damping="], ["damping=0"]),
    "failure strains never reached": (
        [f"{FABRIC}.failure="],
        [f"{FABRIC}.failure={{static_strain: 1, hooke_strain: 1}}"],
    ),
    "limit never reached": ([], ["limits.energy_error=90 %"]),
    "frames and fields": ([], ["output.interval=0", "output.fields=[crimp]"]),
    "contact friction of zero": (
        [],
        ["contact.projectile.friction=0", "contact.plies.friction={static: 0, stiffness_ratio: 2}"],
    ),
    "yarns that never pack": ([f"{FABRIC}.lateral="], []),
}
# And each of these does act, so that the comparison could fail.
DIFFERENT = [
    f"{FABRIC}.friction=",
    f"{FABRIC}.lateral.locking_angle=3.1 deg",
    f"{FABRIC}.elastic.viscosity=0",
    "damping=",
    "contact.plies=",
    "contact.plies.friction=0.2",
    "contact.projectile.friction=0.2",
]


def main():
    program, scene = runs.Program(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:

        def history(name, overrides):
            output = Path(folder) / name
            program.run(scene, output, [*BASE, *overrides])
            return runs.history_bytes(output)

        for name, (without, unused) in SAME.items():
            assert history("without", without) == history("unused", unused), f"{name}: history.csv differs"
        complete = history("complete", [])
        for override in DIFFERENT:
            assert history("without", [override]) != complete, f"{override} changes nothing"


main()
