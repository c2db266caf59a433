#!/usr/bin/env python3
"""Runs variants of the four scenes one after another and collects what changes.

Variants that stand in sensitivity.csv already are skipped, so that a stopped study goes on where it was; take
lines out to repeat them. Without arguments it uses the program of `bash cmake/bootstrap.sh build`. --table
prints the collected rows as the tables of README.md.
"""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD = HERE.parents[1] / "build" / "release"
PLIES = 8

K = "fabrics.kevlar129."
AT_NODES = {"contact.spacing": "nodes", "contact.projectile.unloading": "1", "contact.plies.unloading": "1"}
STIFFNESS_HALF = {"contact.projectile.stiffness": "2.8e12 N/m^3", "contact.plies.stiffness": "5.5e12 N/m^3"}
STIFFNESS_TWICE = {"contact.projectile.stiffness": "1.12e13 N/m^3", "contact.plies.stiffness": "2.2e13 N/m^3"}
INTEGRATED = {
    "contact.spacing": "0.25 mm",
    "contact.projectile.unloading": "10",
    "contact.plies.unloading": "10",
}


@dataclass(frozen=True)
class Study:
    """One shot that is varied: its scene and what is set in all of its variants."""

    scene: str
    overrides: dict
    heading: str


STUDIES = {
    "267": Study(
        "impact_267.yaml",
        {"target.mesh.center": "2 mm", "time.end": "120 us"},
        "267 m/s on a mesh of 2 mm, to 120 us",
    ),
    "428": Study("impact_428.yaml", {}, "428 m/s, elastic contact at the nodes"),
    "428i": Study("impact_428.yaml", INTEGRATED, "428 m/s, integrated hysteretic contact"),
    "550": Study("impact_550.yaml", {}, "550 m/s"),
    "267 fine": Study("impact_267.yaml", {}, "267 m/s, to 200 us"),
    "267 frame": Study(
        "impact_267_frame.yaml", {}, "267 m/s, clamps 101.6 mm apart, the other edges on a frame, to 220 us"
    ),
    "428 frame": Study(
        "impact_267_frame.yaml",
        {"projectile.velocity": "[0, 0, 428 m/s]"},
        "428 m/s, supported in the same way",
    ),
}

# By importance: a study that is cut short has done what matters most. A variant is run in the studies that it
# names.
BOTH, ALL, FRAMED = ("267", "428"), ("267", "428", "428i"), ("267 frame", "428 frame")
# A net of straight yarns that neither press on nor rub each other and resist no shear, in a panel too large
# for its edges to matter.
NET = {
    K + "thickness": "0.02 mm",
    K + "friction": "0",
    K + "lateral": "",
    K + "transverse_shear": "0",
    K + "hourglass": "0.005",
    K + "failure": "",
    "target.size": "[304.8 mm, 304.8 mm]",
}
VARIANTS = {
    "as shipped": ({}, (*ALL, "267 fine", "550", *FRAMED)),
    "y edges sliding": ({"target.edges.y": "sliding"}, (*ALL, "267 fine")),
    "y edges free": ({"target.edges.y": "free"}, (*BOTH, "267 fine")),
    "y edges on a frame": (
        {"target.edges.y": "frame", "target.frame": "{opening: {y: 190.5 mm}}"},
        (*ALL, "267 fine"),
    ),
    "independent yarns": (NET, ("267",)),
    "thickness t = 0.4 mm": ({K + "thickness": "0.4 mm"}, (*ALL, *FRAMED)),
    "formulation paper": ({K + "formulation": "paper"}, BOTH),
    "mesh 2 mm": ({"target.mesh.center": "2 mm"}, ("428", "428i")),
    "mesh 0.75 mm": ({"target.mesh.center": "0.75 mm"}, ("428",)),
    "mesh 0.5 mm": ({"target.mesh.center": "0.5 mm"}, ("428", "267 fine", "267 frame")),
    "contact stiffness / 4": (
        {"contact.projectile.stiffness": "1.4e12 N/m^3", "contact.plies.stiffness": "2.8e12 N/m^3"},
        ALL,
    ),
    "contact stiffness x 4": (
        {"contact.projectile.stiffness": "2.24e13 N/m^3", "contact.plies.stiffness": "4.4e13 N/m^3"},
        BOTH,
    ),
    "contact spacing 0.5 mm": ({"contact.spacing": "0.5 mm"}, ("267",)),
    "contact at the nodes": ({"contact.spacing": "nodes"}, ("267",)),
    "unloading ratio 1": (
        {"contact.projectile.unloading": "1", "contact.plies.unloading": "1"},
        ("267", "428i"),
    ),
    "unloading ratio 10": ({"contact.projectile.unloading": "10", "contact.plies.unloading": "10"}, ("428",)),
    "panel 152.4 mm": ({"target.size": "[152.4 mm, 152.4 mm]"}, BOTH),
    "panel 304.8 mm": ({"target.size": "[304.8 mm, 304.8 mm]"}, BOTH),
    "diameter 7.49 mm": ({"projectile.diameter": "7.49 mm"}, BOTH),
    "edge radius 0.1 mm": ({"projectile.edge_radius": "0.1 mm"}, BOTH),
    "edge radius 1 mm": ({"projectile.edge_radius": "1 mm"}, BOTH),
    "ply spacing 0.5 mm": ({"target.plies.spacing": "0.5 mm"}, BOTH),
    "w = 0.45 mm": ({K + "yarn.width": "0.45 mm"}, BOTH),
    "locking angle 25 deg": ({K + "lateral.locking_angle": "25 deg"}, BOTH),
    "transition 6 deg": ({K + "lateral.transition": "6 deg"}, BOTH),
    "yarn friction 0": ({K + "friction": "0"}, BOTH),
    "damping 1000 1/s": ({"damping": "1000 1/s"}, BOTH),
    "hourglass 0.2": ({K + "hourglass": "0.2"}, BOTH),
    "time.safety 0.45": ({"time.safety": "0.45"}, ALL),
    "ply spacing 0.2 mm": ({"target.plies.spacing": "0.2 mm"}, BOTH),
    "thickness t = 0.6 mm": ({K + "thickness": "0.6 mm"}, BOTH),
    "w = 0.2 mm": ({K + "yarn.width": "0.2 mm"}, BOTH),
    "yarn friction 0.3": ({K + "friction": "0.3"}, BOTH),
    "hourglass 0.01": ({K + "hourglass": "0.01"}, (*BOTH, "267 frame")),
    "contact spacing 0.125 mm": ({"contact.spacing": "0.125 mm"}, ("267", "428i")),
    "frame opening 114.3 mm": ({"target.frame.opening.y": "114.3 mm"}, ("267 frame",)),
    "frame edge radius 3 mm": ({"target.frame.edge_radius": "3 mm"}, ("267 frame",)),
    "clamps 114.3 mm apart": ({"target.size": "[114.3 mm, 127 mm]"}, ("267 frame",)),
    "contact at the nodes, elastic": (AT_NODES, ("428 frame",)),
    "stiffness of contact / 2": (STIFFNESS_HALF, ("550",)),
    "stiffness of contact x 2": (STIFFNESS_TWICE, ("550",)),
    "unloading ratio 5": ({"contact.projectile.unloading": "5", "contact.plies.unloading": "5"}, ("550",)),
    "unloading ratio 20": ({"contact.projectile.unloading": "20", "contact.plies.unloading": "20"}, ("550",)),
    "hourglass 0.02": ({K + "hourglass": "0.02"}, ("550",)),
    "hourglass 0.1": ({K + "hourglass": "0.1"}, ("550",)),
    "time.safety 0.6": ({"time.safety": "0.6"}, ("550",)),
    "mesh 1 mm": ({"target.mesh.center": "1 mm"}, ("550",)),
    "mesh 0.35 mm": ({"target.mesh.center": "0.35 mm"}, ("550",)),
    "mesh s = 0.909 mm": ({"target.mesh.center": "0.909 mm"}, ("550",)),
    "mesh s/2": ({"target.mesh.center": "0.4545 mm"}, ("550",)),
    "mesh s/4": ({"target.mesh.center": "0.22725 mm"}, ("550",)),
    "mesh growth 1.25": ({"target.mesh.growth": "1.25"}, ("267 fine", "550")),
}

FIELDS = [
    "study",
    "variant",
    "status",
    "final_velocity",
    "rebound_time",
    "deepest",
    "largest_displacement",
    "velocity_spread_last_fifth",
    *(f"first_break_{ply}" for ply in range(1, PLIES + 1)),
    "broken_yarns",
    "eroded_elements",
    "energy_error",
    "hourglass_share",
    "absorbed",
    "pyramid_ratio",
    "steps",
    "wall_seconds",
    "overrides",
]


def planned():
    """Pairs of study and variant, in the order in which they are run."""
    return [(study, variant) for variant, (_, studies) in VARIANTS.items() for study in studies]


def history(folder):
    """Columns of history.csv."""
    with open(folder / "history.csv", newline="") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    return {name: [row[name] for row in rows] for name in rows[0]}


def rebound_time(columns):
    """First time at which the projectile moves back, s, between the rows by straight line; None without a
    rebound."""
    times, speeds = columns["time"], columns["projectile_vz"]
    for i in range(1, len(times)):
        if speeds[i] <= 0:
            return times[i - 1] + (times[i] - times[i - 1]) * speeds[i - 1] / (speeds[i - 1] - speeds[i])
    return None


def collect(folder):
    """What is compared of a run, in SI."""
    columns, summary = history(folder), json.loads((folder / "summary.json").read_text())
    energy = columns["kinetic_projectile"]
    last = [v for t, v in zip(columns["time"], columns["projectile_vz"]) if t >= 0.8 * columns["time"][-1]]
    row = {
        "status": summary["status"],
        "final_velocity": summary["residual_velocity"],
        "rebound_time": rebound_time(columns),
        "deepest": max(columns["projectile_z"]),
        "largest_displacement": max(columns["max_displacement"]),
        "velocity_spread_last_fifth": max(last) - min(last),
        "broken_yarns": summary["broken_yarns"],
        "eroded_elements": summary["eroded_elements"],
        "energy_error": max(map(abs, columns["energy_error"])),
        "hourglass_share": max(columns["hourglass"]) / energy[0],
        "absorbed": energy[0] - energy[-1],
        "steps": summary["steps"],
    }
    for ply, first in enumerate(summary["first_break"], start=1):
        row[f"first_break_{ply}"] = first
    pyramid = folder / "plots" / "pyramid.json"
    row["pyramid_ratio"] = json.loads(pyramid.read_text())["ratio"] if pyramid.is_file() else None
    return row


def compute(options, study, variant):
    """One run, collected."""
    overrides = STUDIES[study].overrides | VARIANTS[variant][0]
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        command = [options.weavefront, "run", HERE / STUDIES[study].scene, "--output", folder]
        command += [f"--set={path}={value}" for path, value in overrides.items()]
        start = time.monotonic()
        done = subprocess.run(command, capture_output=True, text=True)
        wall = time.monotonic() - start
        if done.returncode not in (0, 1):
            sys.exit(f"{study}, {variant}: {done.stderr}")
        row = collect_with_pyramid(options, study, folder)
    row |= {
        "study": study,
        "variant": variant,
        "wall_seconds": f"{wall:.0f}",
        "overrides": " ".join(f"{p}={v}" for p, v in overrides.items()),
    }
    return {
        field: ""
        if row[field] is None
        else f"{row[field]:.6g}"
        if isinstance(row[field], float)
        else row[field]
        for field in FIELDS
    }


def collect_with_pyramid(options, study, folder):
    """The rebound's shape is of interest where nothing breaks."""
    if study.startswith("267"):
        subprocess.run([options.plot, folder, "--only", "contour"], check=True, capture_output=True)
    return collect(folder)


def known(path):
    """Rows collected before."""
    if not path.is_file():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def report_done(path, chosen, missing):
    """Says what is computed, and how to compute again what is not."""
    if not chosen:
        sys.exit("--only chooses no variant")
    print(
        f"{chosen - missing} of {chosen} variants are in {path}"
        + (
            f", {missing} to compute"
            if missing
            else "; to compute one anew, take its line out, or give another file with --csv"
        ),
        flush=True,
    )


def study(options):
    """Runs what is missing and appends each row when it is there."""
    done = {(row["study"], row["variant"]) for row in known(options.csv)}
    if not done:
        options.csv.write_text(",".join(FIELDS) + "\n")
    chosen = [pair for pair in planned() if not options.only or pair[0] in options.only.split(",")]
    missing = [pair for pair in chosen if pair not in done]
    report_done(options.csv, len(chosen), len(missing))
    start = time.monotonic()
    for pair in missing:
        if options.minutes and time.monotonic() - start > 60 * options.minutes:
            break
        row = compute(options, *pair)
        with open(options.csv, "a", newline="") as file:
            csv.DictWriter(file, FIELDS, lineterminator="\n").writerow(row)
        print(f"{pair[0]}, {pair[1]}: {row['final_velocity']} m/s in {row['wall_seconds']} s", flush=True)


def number(text, scale=1.0, digits=1):
    """A value of the csv as text of the table; a dash where there is none."""
    return f"{scale * float(text):.{digits}f}" if text else "-"


def breaks(row):
    """First breaks of the plies, us."""
    times = [row[f"first_break_{ply}"] for ply in range(1, PLIES + 1)]
    return " ".join(number(time, 1e6) for time in times) if any(times) else "none"


COLUMNS = {
    "velocity at the end, m/s": lambda r: number(r["final_velocity"]),
    "rebound, us": lambda r: number(r["rebound_time"], 1e6),
    "deepest, mm": lambda r: number(r["deepest"], 1e3, 2),
    "pyramid": lambda r: number(r["pyramid_ratio"], 1, 2),
    "absorbed, J": lambda r: number(r["absorbed"]),
    "first breaks, plies 1 to 8, us": breaks,
    "broken": lambda r: r["broken_yarns"],
    "eroded": lambda r: r["eroded_elements"],
    "energy error, %": lambda r: number(r["energy_error"], 100, 4),
    "hourglass, %": lambda r: number(r["hourglass_share"], 100, 1),
}
ONLY_OF_267, NOT_OF_267 = ("rebound, us", "pyramid"), ("first breaks, plies 1 to 8, us", "eroded")


def tables(path):
    """The rows as markdown."""
    rows = known(path)
    for name, about in STUDIES.items():
        chosen = [row for row in rows if row["study"] == name]
        if not chosen:
            continue
        skipped = NOT_OF_267 if name.startswith("267") else ONLY_OF_267
        columns = {heading: value for heading, value in COLUMNS.items() if heading not in skipped}
        print(
            f"\n{about.heading}:\n\n| variant | " + " | ".join(columns) + " |\n|---|" + "---:|" * len(columns)
        )
        for row in sorted(chosen, key=lambda r: list(VARIANTS).index(r["variant"])):
            stopped = "" if row["status"] == "finished" else " (stopped by the guard)"
            print(
                f"| {row['variant']}{stopped} | "
                + " | ".join(value(row) for value in columns.values())
                + " |"
            )


def main():
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--weavefront", type=Path, default=BUILD / "src/app/weavefront", help="the program")
    options.add_argument("--plot", type=Path, default=BUILD / "bin/weavefront-plot", help="weavefront-plot")
    options.add_argument(
        "--csv", type=Path, default=HERE / "sensitivity.csv", help="where the rows are collected"
    )
    options.add_argument("--only", metavar="STUDIES", help=f"from {','.join(STUDIES)}")
    options.add_argument("--minutes", type=float, help="start no run after this time")
    options.add_argument("--table", action="store_true", help="print the tables instead of computing")
    options = options.parse_args()
    tables(options.csv) if options.table else study(options)


if __name__ == "__main__":
    main()
