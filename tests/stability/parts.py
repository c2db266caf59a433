#!/usr/bin/env python3
"""Prints how many more time steps runs take without each part of the tight bound on the time step.

parts.py [--work FOLDER]

Each part is left out of a build of its own (-DWEAVEFRONT_BOUND_WITHOUT=part), below FOLDER, by default
build. Every build runs the shipped scenes and the cases of `stability` on one rank. The table has all
scenes, and the cases in which a part saves or costs 3 % of the steps or more."""

import argparse
import csv
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PARTS = ("flat_contact", "free_crossovers", "coupling")
KEVLAR = "examples/kevlar129_8ply"
SCENES = {
    "impact_267": (f"{KEVLAR}/impact_267.yaml", []),
    "impact_267_frame": (f"{KEVLAR}/impact_267_frame.yaml", []),
    "impact_428": (f"{KEVLAR}/impact_428.yaml", []),
    "impact_550": (f"{KEVLAR}/impact_550.yaml", []),
    "yarn_impact": ("examples/yarn_impact/scene.yaml", []),
    "large_panel, 60 mm wide, to 60 us": (
        "examples/large_panel/scene.yaml",
        ["target.size=[60 mm, 60 mm]", "target.symmetry=[x, y]", "time.end=60 us"],
    ),
}
NOTABLE = 3  # per cent of the steps


def run(command, folder, accepted=(0,)):
    """Ends the program at a status that is not accepted."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "parts.log", "a") as log:
        done = subprocess.run(list(map(str, command)), stdout=log, stderr=subprocess.STDOUT)
    if done.returncode not in accepted:
        sys.exit(f"{' '.join(map(str, command))}: status {done.returncode}, see {folder / 'parts.log'}")


def build(folder, part):
    configure = ["cmake", "-S", SOURCE, "-B", folder, "-G", "Ninja", f"-DWEAVEFRONT_BOUND_WITHOUT={part}"]
    run([*configure, "-DCMAKE_BUILD_TYPE=Release"], folder)
    targets = ["weavefront", "stability"]
    run(["cmake", "--build", folder, "--parallel", os.cpu_count(), "--target", *targets], folder)


def steps_of_scene(folder, name):
    scene, overrides = SCENES[name]
    out = folder / "runs" / name.split(",")[0]
    settings = [word for override in [*overrides, "output.interval=0"] for word in ("--set", override)]
    program = folder / "src/app/weavefront"
    run([program, "run", SOURCE / scene, "--output", out, "--overwrite", *settings], folder)
    return {name: json.loads((out / "summary.json").read_text())["steps"]}


def steps_of_cases(folder):
    """Those that the guard stops are left out: they end early in any case."""
    table = folder / "stability.csv"
    command = [folder / "tests/stability/stability", "--formulation", "consistent", "--csv", table]
    run(command, folder, (0, 1))  # 1: a case is not as expected without the part
    with open(table, newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["outcome"].startswith("finished")]
    return {row["case"]: int(row["steps"]) for row in rows}


def counts_of(builds):
    """Steps of every scene and case, by build."""
    counts = {part: {} for part in builds}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [(part, pool.submit(steps_of_scene, builds[part], name)) for name in SCENES for part in builds]
        jobs += [(part, pool.submit(steps_of_cases, builds[part])) for part in builds]
        for part, job in jobs:
            counts[part] |= job.result()
    return counts


def main():
    raw = argparse.RawDescriptionHelpFormatter
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    arguments.add_argument("--work", type=Path, default=SOURCE / "build")
    work = arguments.parse_args().work.resolve()
    builds = {part: work / f"bound_without_{part}" for part in ("nothing", *PARTS)}
    for part, folder in builds.items():
        build(folder, part)
    counts = counts_of(builds)
    print(f"| | steps | {' | '.join(part.replace('_', ' ') for part in PARTS)} |")
    print(f"|---|---:|{'---:|' * len(PARTS)}")
    for name, whole in counts["nothing"].items():
        if any(name not in counts[part] for part in PARTS):
            continue
        saved = [100 * (counts[part][name] / whole - 1) for part in PARTS]
        if name in SCENES or any(abs(value) >= NOTABLE for value in saved):
            print(f"| `{name}` | {whole} | {' | '.join(f'{value:.1f}' for value in saved)} |")


if __name__ == "__main__":
    main()
