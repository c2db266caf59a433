#!/usr/bin/env python3
"""Predicts strong and weak scaling of the scene beside this file; writes strong.csv, weak.csv and
scaling.png.

Without arguments it uses the program of `bash cmake/bootstrap.sh build`. --machine FILE: the constants of
another machine, from `weavefront partition SCENE --calibrate FILE`.
"""

import argparse
import csv
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build/release"

STRONG = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192]
WEAK = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024]
COARSE = ["--set", "target.mesh={center: 4 mm}"]  # 20,000 elements on the first rank


def table(options, name, ranks, *more):
    """Has the program write a table and returns its columns as numbers."""
    path = HERE / f"{name}.csv"
    command = [
        options.weavefront,
        "partition",
        HERE / "scene.yaml",
        "--ranks",
        ",".join(map(str, ranks)),
        "--out",
        path,
        *more,
    ]
    if options.machine:
        command += ["--machine", options.machine]
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE)
    if done.returncode != 0:
        sys.exit(done.returncode)
    print(done.stdout)
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {key: [float(row[key]) for row in rows] for key in rows[0] if not key.startswith("measured")}


def draw(strong, weak, path):
    """Time of a step and efficiency over the ranks."""
    sys.path.insert(0, str(ROOT / "src/plot"))
    from weavefront_plot import style

    style.apply()
    figure, (times, efficiencies) = style.plt.subplots(1, 2, figsize=(9, 3.4), constrained_layout=True)
    for columns, colour, label in (
        (strong, style.BLUE, "strong: 1.28 M elements"),
        (weak, style.ORANGE, "weak: 20,000 elements a rank"),
    ):
        times.loglog(
            columns["ranks"],
            [1e3 * seconds for seconds in columns["step_seconds"]],
            "o-",
            ms=3,
            color=colour,
            label=label,
        )
        efficiencies.semilogx(
            columns["ranks"], [100 * share for share in columns["efficiency"]], "o-", ms=3, color=colour
        )
    ideal = [1e3 * strong["step_seconds"][0] / ranks for ranks in strong["ranks"]]
    times.loglog(strong["ranks"], ideal, color=style.FAINT, lw=0.8, label="ideal")
    times.set_ylabel("Time of a step, ms")
    efficiencies.set_ylabel("Efficiency, %")
    efficiencies.set_ylim(0, 105)
    for panel in (times, efficiencies):
        panel.set_xlabel("Ranks")
    times.legend()
    style.save_figure(figure, path)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--weavefront", default=BUILD / "src/app/weavefront", type=Path, help="the program")
    options.add_argument(
        "--machine", type=Path, help="constants of a machine (default: those of the program)"
    )
    options = options.parse_args()
    strong = table(options, "strong", STRONG)
    weak = table(options, "weak", WEAK, "--weak", *COARSE)
    draw(strong, weak, HERE / "scaling.png")


main()
