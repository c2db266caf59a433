#!/usr/bin/env python3
"""Finds the ballistic limit of the eight plies by bisection, for the paper's parameters and for what the
paper leaves open.

A limit is the bracket between two speeds: five shots at the lower one are stopped, five at the upper one
perforate.

Collects one row a variant in limit.csv; variants that stand there are skipped. Without arguments it uses the
program of `bash cmake/bootstrap.sh build`. --table prints the rows as markdown, --picture FILE draws them.
"""

import argparse
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

from sensitivity import BUILD, HERE, K, history, known, report_done

BRACKET = (200, 800)  # m/s; the lower one is stopped in all variants, the upper one in none
WIDTH = 10  # m/s, of the last bracket
# A perforation amplifies the smallest difference. Both ends of the bracket are shot again, a little faster, a
# little slower and in smaller steps.
FASTER = (0.01, -0.01)  # m/s
SAFETIES = ("0.8", "0.7")

NEAR_CLAMPS = {
    "target.size": "[101.6 mm, 127 mm]",
    "target.edges.y": "frame",
    "target.frame": "{opening: {y: 101.6 mm}}",
    "time.end": "240 us",
}
MESH = "target.mesh.center"
VARIANTS = {
    "as shipped, h = 1 mm": {},
    "h = s = 0.909 mm": {MESH: "0.909 mm"},
    "h = s/2": {MESH: "0.4545 mm"},
    "h = s/4": {MESH: "0.22725 mm"},
    "t = 0.6 mm": {K + "thickness": "0.6 mm"},
    "t = 0.4 mm": {K + "thickness": "0.4 mm"},
    "clamps 101.6 mm apart, y edges on a frame": NEAR_CLAMPS,
    "edge radius 0.1 mm": {"projectile.edge_radius": "0.1 mm"},
    "edge radius 1 mm": {"projectile.edge_radius": "1 mm"},
    "diameter 7.49 mm": {"projectile.diameter": "7.49 mm"},
    "erode any_yarn": {K + "failure.erode": "any_yarn"},
    "breaking strains x 0.9": {K + "failure.static_strain": "2.97 %", K + "failure.hooke_strain": "2.43 %"},
    "breaking strains x 0.8": {K + "failure.static_strain": "2.64 %", K + "failure.hooke_strain": "2.16 %"},
    "contact at the nodes, elastic": {
        "contact.spacing": "nodes",
        "contact.projectile.unloading": "1",
        "contact.plies.unloading": "1",
    },
}
SHIPPED = {MESH: "1 mm", "time.end": "150 us", "output.interval": "0"}
FIELDS = ["variant", "stopped", "perforated", "absorbed_least", "absorbed_most", "overrides"]


def shot(options, overrides, speed):
    """Computes one impact. Returns whether the projectile still moves on at the end, and the energy that it
    has lost, J."""
    with tempfile.TemporaryDirectory() as folder:
        command = [options.weavefront, "run", HERE / "impact_550.yaml", "--output", folder]
        command += [f"--set={path}={value}" for path, value in (SHIPPED | overrides).items()]
        done = subprocess.run(
            [*command, f"--set=projectile.velocity=[0, 0, {speed:g} m/s]"], capture_output=True, text=True
        )
        if done.returncode != 0:
            sys.exit(f"{speed:g} m/s: {done.stderr}")
        columns = history(Path(folder))
    energy, velocity = columns["kinetic_projectile"], columns["projectile_vz"][-1]
    return velocity > 0, energy[0] - energy[-1]


def shots(options, overrides, speed):
    """Outcomes of five shots at this speed that should come out alike: whether each perforates, and the
    energy that it absorbs, J."""
    return [
        shot(options, overrides, speed),
        *(shot(options, overrides, speed + difference) for difference in FASTER),
        *(shot(options, overrides | {"time.safety": safety}, speed) for safety in SAFETIES),
    ]


def bracket(options, variant):
    """The speeds between which the outcome changes, by bisection."""
    low, high = BRACKET
    while high - low > WIDTH:
        speed = (low + high) / 2
        perforates, _ = shot(options, VARIANTS[variant], speed)
        low, high = (low, speed) if perforates else (speed, high)
        print(f"{variant}: {speed:g} m/s {'perforates' if perforates else 'is stopped'}", flush=True)
    return low, high


def limit(options, variant):
    """The row of a variant: the bracket, as wide as the scatter makes it, and the energies absorbed at its
    upper end."""
    low, high = bracket(options, variant)
    step = high - low
    while any(perforates for perforates, _ in shots(options, VARIANTS[variant], low)):
        print(f"{variant}: {low:g} m/s is not always stopped", flush=True)
        low -= step
    above = shots(options, VARIANTS[variant], high)
    while not all(perforates for perforates, _ in above):
        print(f"{variant}: {high:g} m/s does not always perforate", flush=True)
        high += step
        above = shots(options, VARIANTS[variant], high)
    absorbed = [energy for _, energy in above]
    text = " ".join(f"{path}={value}" for path, value in VARIANTS[variant].items())
    return {
        "variant": variant,
        "stopped": f"{low:.6g}",
        "perforated": f"{high:.6g}",
        "absorbed_least": f"{min(absorbed):.6g}",
        "absorbed_most": f"{max(absorbed):.6g}",
        "overrides": text,
    }


def collect(options):
    """Computes what is missing and appends each row when it is there."""
    done = {row["variant"] for row in known(options.csv)}
    if not done:
        options.csv.write_text(",".join(FIELDS) + "\n")
    chosen = [
        variant
        for variant in VARIANTS
        if not options.only or any(part in variant for part in options.only.split(","))
    ]
    missing = [variant for variant in chosen if variant not in done]
    report_done(options.csv, len(chosen), len(missing))
    for variant in missing:
        row = limit(options, variant)
        with open(options.csv, "a", newline="") as file:
            csv.DictWriter(file, FIELDS, lineterminator="\n").writerow(row)


def middle(row):
    return (float(row["stopped"]) + float(row["perforated"])) / 2


def ordered(path):
    return sorted(known(path), key=lambda row: list(VARIANTS).index(row["variant"]))


def table(path):
    """The rows as markdown."""
    print(
        "| variant | limit, m/s | energy absorbed just above it, J, least to most of five shots |\n|---|---:|---:|"
    )
    for row in ordered(path):
        half = (float(row["perforated"]) - float(row["stopped"])) / 2
        print(
            f"| {row['variant']} | {middle(row):.0f} +- {half:.0f} | {float(row['absorbed_least']):.0f} to {float(row['absorbed_most']):.0f} |"
        )


def picture(path, file):
    """Limits of the variants beside the bracket of the experiments."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = ordered(path)[::-1]
    figure, axes = plt.subplots(figsize=(8, 0.36 * len(rows) + 1.2))
    axes.axvspan(267, 428, color="0.9", label="experiments: 267 m/s stopped, 428 m/s perforated")
    axes.barh([row["variant"] for row in rows], [middle(row) for row in rows], height=0.55, color="tab:blue")
    halves = [(float(row["perforated"]) - float(row["stopped"])) / 2 for row in rows]
    axes.errorbar(
        [middle(row) for row in rows], range(len(rows)), xerr=halves, fmt="none", color="k", capsize=2
    )
    axes.set(xlabel="ballistic limit, m/s", xlim=(0, None))
    axes.legend(loc="upper center", bbox_to_anchor=(0.4, -0.12), frameon=False)
    figure.savefig(file, dpi=150, bbox_inches="tight")


def main():
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--weavefront", type=Path, default=BUILD / "src/app/weavefront", help="the program")
    options.add_argument("--csv", type=Path, default=HERE / "limit.csv", help="where the rows are collected")
    options.add_argument(
        "--only", metavar="TEXTS", help="variants whose name holds one of these, separated by commas"
    )
    options.add_argument("--table", action="store_true", help="print the rows instead of computing")
    options.add_argument("--picture", type=Path, metavar="FILE", help="draw the rows instead of computing")
    options = options.parse_args()
    if options.table:
        table(options.csv)
    elif options.picture:
        picture(options.csv, options.picture)
    else:
        collect(options)


if __name__ == "__main__":
    main()
