"""Instructions an element-step of named cases against the committed baseline: instructions.py BUILD
[--update]

BUILD is a release build of -DWEAVEFRONT_ARCH=x86-64-v3 with the target benchmark_step. Instructions do not
depend on how busy a machine is, so a slower step is seen at once. Exit status 1 when a case takes over 5 %
more than baseline.json says, or when plies that touch take over 1.3 times those with air between them; 77
when BUILD is of another compiler, whose instructions say nothing about ours. --update writes
baseline.json."""

import argparse
import json
import sys
from pathlib import Path

import callgrind
from programs import architecture, compiler, settings

HERE = Path(__file__).parent
SCENE, BASELINE = HERE / "scene.yaml", HERE / "baseline.json"
STEPS, ALLOWED, SKIPPED = 50, 0.05, 77
TOUCHING_STEPS, TOUCHING_ALLOWED = 800, 1.3

FABRIC = "fabrics.kevlar129"
FULL = [
    f"{FABRIC}.thickness=0.82 mm",
    f"{FABRIC}.elastic.viscosity=35 MPa s",
    f"{FABRIC}.failure={{static_strain: 3.3 %, hooke_strain: 2.7 %}}",
    f"{FABRIC}.lateral={{modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}}",
    f"{FABRIC}.friction=0.11",
    f"{FABRIC}.hourglass=0.05",
    f"{FABRIC}.transverse_shear=2.5 GPa",
]
SPHERE = "projectile={shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 300 m/s]}"
CASES = {
    "bare": [],
    "full fabric": FULL,
    "full fabric, ply contact": [*FULL, "contact={plies: {}}"],
    "full fabric, ply and projectile contact": [*FULL, SPHERE, "contact={plies: {}, projectile: {}}"],
    "paper formulation": [*FULL, f"{FABRIC}.formulation=paper"],
    "breaking yarns": [
        *FULL,
        f"{FABRIC}.thickness=0.2 mm",
        f"{FABRIC}.failure={{static_strain: 0.005 %, hooke_strain: 0.005 %}}",
    ],
}
# A quarter of a stack of six plies under a fragment, for as long as it dishes.
STACK = [
    *FULL,
    f"{FABRIC}.thickness=0.23 mm",
    "target.size=[60 mm, 60 mm]",
    "target.edges={}",
    "target.symmetry=[x, y]",
    "target.mesh.center=1.5 mm",
    "projectile={shape: cylinder, diameter: 5.46 mm, edge_radius: 0.3 mm, mass: 1.1 g, velocity: [0, 0, 340 m/s]}",
    "contact={plies: {}, projectile: {}}",
]


def instructions(build, overrides, *options):
    """An element-step's."""
    command = [build / "tests/benchmark/benchmark_step", SCENE, *settings(overrides), *map(str, options)]
    (counts,), printed = callgrind.count(command, within="measured_steps")
    cost = json.loads(printed)
    return counts.total() / (cost["elements"] * cost["steps"])


def touching(build):
    """How many times the instructions of plies 0.1 mm apart those of plies that touch are."""
    counts = [
        instructions(
            build,
            [*STACK, f"target.plies={{count: 6, fabric: kevlar129, gap: {gap}}}"],
            "--steps",
            TOUCHING_STEPS,
            "--speed",
            0,
        )
        for gap in ("0", "0.1 mm")
    ]
    return counts[0] / counts[1]


def require_countable(build):
    """Ends the program for a build whose instructions cannot be counted."""
    callgrind.require()
    if architecture(build) != "x86-64-v3":
        sys.exit(
            f"{build} is built for {architecture(build)}: configure with -DWEAVEFRONT_ARCH=x86-64-v3, since valgrind knows no AVX-512"
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("--update", action="store_true", help="write baseline.json")
    options = parser.parse_args()
    require_countable(options.build)
    built_by = compiler(options.build)
    baseline = {} if options.update else json.loads(BASELINE.read_text())
    if not options.update and baseline["compiler"] != built_by:
        print(
            f"{BASELINE.name} counts {baseline['compiler']}, {options.build} is built by {built_by}: not compared"
        )
        return SKIPPED
    now = {
        case: round(instructions(options.build, overrides, "--steps", STEPS), 1)
        for case, overrides in CASES.items()
    }
    if options.update:
        BASELINE.write_text(json.dumps({"compiler": built_by, "instructions": now}, indent=2) + "\n")
        print(BASELINE.read_text())
        return 0
    before = baseline["instructions"]
    print(f"{'instructions an element-step':42}{'baseline':>10}{'now':>10}{'change':>9}")
    defects = []
    for case, count in now.items():
        if case not in before:
            defects.append(f"{case}: not in {BASELINE.name}; add it with --update")
            continue
        change = count / before[case] - 1
        print(f"{case:42}{before[case]:10.1f}{count:10.1f}{change:+9.1%}")
        if change > ALLOWED:
            defects.append(f"{case}: {change:+.1%} instructions, allowed {ALLOWED:+.0%}")
        elif change < -ALLOWED:
            print(f"{case}: {change:+.1%} instructions; keep the gain, lower the baseline with --update")
    ratio = touching(options.build)
    print(f"{'plies that touch, of plies 0.1 mm apart':42}{'':20}{ratio:8.2f}x")
    if ratio > TOUCHING_ALLOWED:
        defects.append(
            f"plies that touch take {ratio:.2f} times the instructions of plies 0.1 mm apart, allowed {TOUCHING_ALLOWED}"
        )
    print("\n".join(defects))
    return 1 if defects else 0


if __name__ == "__main__":
    sys.exit(main())
