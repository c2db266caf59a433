"""What each optional feature costs, off and on, and what the step pays for features that a scene leaves out:
pay_for_use.py BUILD

BUILD is a build folder of -DWEAVEFRONT_ARCH=x86-64-v3 with the targets weavefront and benchmark_step. Writes
pay_for_use.md beside this script; exit status 1 when a feature that is off costs more than 0.5 % or
allocates."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import callgrind
from programs import architecture, processor, run, settings

HERE = Path(__file__).parent
SCENE = HERE / "scene.yaml"
STEPS, REPEATS, ALLOWED = 100, 7, 0.005
OF_MPI = (
    "libmpi",
    "libopen",
    "mca_",
    "libevent",
    "libpmix",
    "libhwloc",
    "ld-linux",
    "libc.so",
    "libpthread",
    "vdso",
)

FABRIC = "fabrics.kevlar129"
CRIMP = [f"{FABRIC}.thickness=0.82 mm"]
FAILURE = [f"{FABRIC}.failure={{static_strain: 3.3 %, hooke_strain: 2.7 %}}"]
BREAKING = [f"{FABRIC}.failure={{static_strain: 0.02 %, hooke_strain: 0.02 %, erode: any_yarn}}"]
LATERAL = [
    f"{FABRIC}.lateral={{modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 3.2 deg, transition: 3 deg}}"
]
FRAME = ["target.edges={x: free, y: frame}", "target.frame={opening: {y: 16 mm}}"]
SPHERE = "projectile={shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 300 m/s]}"

# feature: what else the scene has, what switches it on
STEP_FEATURES = {
    "crimp": ([], CRIMP),
    "viscosity": ([], [f"{FABRIC}.elastic.viscosity=35 MPa s"]),
    "lateral packing": ([], LATERAL),
    "yarn friction": (CRIMP, [f"{FABRIC}.friction=0.11"]),
    "failure": ([], FAILURE),
    "erosion": (FAILURE, BREAKING),
    "supports": ([], ["target.edges={x: fixed, y: fixed}"]),
    "damping": ([], ["damping=100 1/s"]),
    "ply contact": ([], ["contact={plies: {}}"]),
    "projectile contact": ([], [SPHERE, "contact={projectile: {}}"]),
    "frame": ([], FRAME),
}
ALL_FIELDS = "output.fields=[displacement, velocity, strain, stress, braid_angle, crimp, broken]"


class Steps:
    """Costs of the step of a scene, each measured once."""

    def __init__(self, build):
        self.program = build / "tests/benchmark/benchmark_step"
        self.known = {}

    def cost(self, overrides, textbook=False):
        """instructions and nanoseconds an element-step, bytes an element, allocations"""
        key = (*overrides, textbook)
        if key not in self.known:
            command = [
                self.program,
                SCENE,
                *settings(overrides),
                "--steps",
                str(STEPS),
                *(["--textbook"] if textbook else []),
            ]
            (counts,), printed = callgrind.count(command, within="measured_steps")
            cost = json.loads(printed)
            cost["instructions"] = counts.total() / (cost["elements"] * cost["steps"])
            if counts.calls_the_heap():
                cost["allocations"] = max(1, cost["allocations"])
            cost["nanoseconds"] = min(json.loads(run(command))["nanoseconds"] for _ in range(REPEATS))
            self.known[key] = cost
        return self.known[key]

    def leave_the_same_bits(self, overrides):
        """Whether the product's step and the one without its optional features do."""
        return (
            subprocess.run(
                [self.program, SCENE, *settings(overrides), "--check"], capture_output=True
            ).returncode
            == 0
        )


def step_rows(steps):
    """Rows of the table and what is over the allowance."""
    rows, defects = [], []
    for feature, (others, switch) in STEP_FEATURES.items():
        off, on, without = (
            steps.cost(others),
            steps.cost([*others, *switch]),
            steps.cost(others, textbook=True),
        )
        excess = off["instructions"] / without["instructions"] - 1
        rows.append(
            f"| {feature} | {without['instructions']:.1f} | {off['instructions']:.1f} | {excess:+.2%} | {on['instructions']:.1f} "
            f"| {off['bytes']:.0f} | {on['bytes']:.0f} | {off['nanoseconds']:.1f} | {on['nanoseconds']:.1f} "
            f"| {off['allocations']} | {on['allocations']} |"
        )
        if excess > ALLOWED:
            defects.append(
                f"{feature}: off costs {excess:.2%} more than a step without it, allowed {ALLOWED:.1%}"
            )
        if off["allocations"]:
            defects.append(f"{feature}: off allocates")
        if not steps.leave_the_same_bits(others):
            defects.append(f"{feature}: off leaves other bits than a step without it")
    return rows, defects


def halo_row(steps):
    """One rank against two, instructions of our own code and of MPI, whose waiting counts too."""
    command = [steps.program, SCENE, "--steps", str(STEPS)]
    one = steps.cost([])
    counts, printed = callgrind.count(command, launcher=["mpirun", "-n", "2"], within="measured_steps")
    element_steps = one["elements"] * STEPS
    own = sum(c.total(OF_MPI) for c in counts) / element_steps
    return f"On one rank {one['instructions']:.1f} instructions an element-step, no message and no buffer; on two {own:.1f} outside of MPI."


def program_costs(build, overrides):
    """Instructions of a whole run by part: the steps, a row of the history, a frame; all an element, steps an
    element-step."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            build / "src/app/weavefront",
            "run",
            SCENE,
            "--output",
            folder,
            *settings([SPHERE, "contact={projectile: {}}", *overrides]),
        ]
        (counts,), _ = callgrind.count(command)
        summary = json.loads((Path(folder) / "summary.json").read_text())
        rows = len((Path(folder) / "history.csv").read_text().splitlines()) - 1
    elements, steps = summary["elements"], summary["steps"]
    solver = "weavefront::solver::Simulation::"
    return {
        "step": (counts.of(f"{solver}advance_forces") + counts.of(f"{solver}integrate")) / (elements * steps),
        "row": counts.of(f"{solver}balance") / (elements * rows),
        "rows": rows,
        "frames": (counts.of("weavefront::app::frame_of") + counts.of("weavefront::io::Results::write"))
        / elements,
    }


def output_rows(build):
    least = ["time.end=10 us", "output.interval=0", "output.history=10 us", "output.fields=[]"]
    off = program_costs(build, least)
    rows = program_costs(build, [*least, "output.history=0.5 us"])
    frames = program_costs(build, [*least, "output.interval=1 us"])
    fields = program_costs(build, [*least, "output.interval=1 us", ALL_FIELDS])
    return [
        f"| first and last row and frame only | {off['step']:.1f} | {off['row']:.0f} | {off['frames'] / 2:.0f} |",
        f"| history of {rows['rows']} rows | {rows['step']:.1f} | {rows['row']:.0f} | {rows['frames'] / 2:.0f} |",
        f"| 11 frames, no field | {frames['step']:.1f} | {frames['row']:.0f} | {frames['frames'] / 11:.0f} |",
        f"| 11 frames, all fields | {fields['step']:.1f} | {fields['row']:.0f} | {fields['frames'] / 11:.0f} |",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--output", type=Path, default=HERE / "pay_for_use.md")
    options = parser.parse_args()
    callgrind.require()
    if architecture(options.build) != "x86-64-v3":
        sys.exit(
            f"{options.build} is built for {architecture(options.build)}: configure with -DWEAVEFRONT_ARCH=x86-64-v3"
        )
    steps = Steps(options.build)
    rows, defects = step_rows(steps)
    template = (HERE / "pay_for_use.md.in").read_text()
    options.output.write_text(
        template.format(
            steps="\n".join(rows),
            halo=halo_row(steps),
            output="\n".join(output_rows(options.build)),
            count=STEPS,
            repeats=REPEATS,
            elements=steps.cost([])["elements"],
            processor=processor(),
            cores=os.cpu_count(),
            allowed=f"{ALLOWED:.1%}",
        )
    )
    print(options.output.read_text())
    for defect in defects:
        print(defect)
    return 1 if defects else 0


if __name__ == "__main__":
    sys.exit(main())
