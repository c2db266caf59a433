#!/usr/bin/python3
"""Computes the limit velocities of shots.toml by `weavefront v50` and compares them with measured ones.

Collects one row a limit in limits.csv; limits that stand there are skipped, and an interrupted search goes on. Without arguments it uses the
program of `bash cmake/bootstrap.sh build`. --table prints the rows as markdown, --picture FILE draws them.
"""

import argparse
import csv
import json
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FIELDS = ["experiment", "case", "variant", "partial", "complete", "shots", "measured_low", "measured_high"]
AS_STATED = "as stated"


class Limit:
    """A limit velocity to compute: one case of an experiment, as stated or as a variant."""

    def __init__(self, letter, experiment, case, variant):
        stated = experiment["cases"][case]
        self.key = (letter, case, variant)
        self.scene = HERE / experiment["scene"]
        self.set = stated.get("set", {}) | ({} if variant == AS_STATED else experiment["variants"][variant])
        self.measured = measured_range(experiment, stated)

    @property
    def folder(self):
        """Name of its folder."""
        return re.sub(r"[^\w.]+", "_", "_".join(self.key)).strip("_")

    def expected(self, rows):
        """Speeds between which the limit is looked for first, m/s; none: from the velocity of the scene outwards."""
        letter, case, variant = self.key
        stated = rows.get((letter, case, AS_STATED))
        if variant != AS_STATED and stated is not None:
            return 0.85 * middle(stated), 1.15 * middle(stated)
        return (0.7 * self.measured[0], 1.6 * self.measured[1]) if self.measured else None


def measured_range(experiment, stated):
    """Lowest and highest speed between which the measured limit lies, m/s; none where no limit was measured."""
    measured = stated.get("measured")
    if measured is None:
        return None
    if isinstance(measured, list):
        return tuple(measured)
    scatter = experiment.get("plus_minus", 0)
    return (measured - scatter, measured + scatter)


def limits_of(experiments):
    """All limits of the file: first those as stated, then the variants."""
    found = []
    for letter, experiment in experiments.items():
        for case, stated in experiment["cases"].items():
            for variant in [AS_STATED, *stated.get("variants", [])]:
                found.append(Limit(letter, experiment, case, variant))
    return sorted(found, key=lambda limit: limit.key[2] != AS_STATED)


def rows_of(path):
    """Rows that were collected, by experiment, case and variant."""
    if not path.exists():
        return {}
    with open(path, newline="") as file:
        return {(row["experiment"], row["case"], row["variant"]): row for row in csv.DictReader(file)}


def v50(limit, ends, options):
    """Runs `weavefront v50` in the folder of the limit, on from where it was. Returns the finished process."""
    folder = options.output / limit.folder
    launch = [options.mpiexec, "-n", str(options.ranks)] if options.ranks > 1 else []
    command = [*launch, options.weavefront, "v50", limit.scene, "--output", folder, "--no-picture"]
    command += ["--width", options.width]
    if (folder / "v50.csv").exists():
        command += ["--restart", "auto"]
    if ends:
        command += ["--from", f"{ends[0]:g} m/s", "--to", f"{ends[1]:g} m/s"]
    command += [f"--set={path}={value}" for path, value in limit.set.items()]
    return subprocess.run([str(part) for part in command], capture_output=True, text=True)


def search(limit, rows, options):
    """Finds a limit and returns its row; none where the search has failed."""
    ends = limit.expected(rows)
    done = v50(limit, ends, options)
    if done.returncode == 2 and ends:  # the limit lies outside
        shutil.rmtree(options.output / limit.folder, ignore_errors=True)
        done = v50(limit, None, options)
    if done.returncode != 0:
        print(
            f"{' | '.join(limit.key)}: status {done.returncode}\n{done.stderr}", file=sys.stderr, flush=True
        )
        return None
    found = json.loads((options.output / limit.folder / "v50.json").read_text())["limits"][0]
    low, high = limit.measured or ("", "")
    values = [f"{found['partial']:.6g}", f"{found['complete']:.6g}", found["shots"], low, high]
    return dict(zip(FIELDS, [*limit.key, *values]))


def collect(limits, options):
    """Computes what is missing and appends each row when it is there."""
    done = rows_of(options.csv)
    missing = [limit for limit in limits if limit.key not in done]
    print(f"{options.csv}: {len(limits) - len(missing)} of {len(limits)} limits are there", flush=True)
    if not options.csv.exists():
        options.csv.write_text(",".join(FIELDS) + "\n")
    failed = 0
    for number, limit in enumerate(missing, 1):
        row = search(limit, rows_of(options.csv), options)
        if row is None:
            failed += 1
            continue
        with open(options.csv, "a", newline="") as file:
            csv.DictWriter(file, FIELDS, lineterminator="\n").writerow(row)
        print(
            f"{number}/{len(missing)} {' | '.join(limit.key)}: {row['partial']} to {row['complete']} m/s",
            flush=True,
        )
    return 1 if failed else 0


def middle(row):
    """Middle of the bracket, m/s."""
    return (float(row["partial"]) + float(row["complete"])) / 2


class Comparison:
    """Computed over measured: of the case as stated, its range over all variants, and the range of the measurement."""

    def __init__(self, label, ratio, of_variants, of_measurement):
        self.label, self.ratio = label, ratio
        self.of_variants, self.of_measurement = of_variants, of_measurement


def compared(experiments, rows):
    """All comparisons for which there are rows."""
    found = []
    for letter, experiment in experiments.items():
        for case, stated in experiment["cases"].items():
            row, measured = rows.get((letter, case, AS_STATED)), measured_range(experiment, stated)
            if row is None or measured is None:
                continue
            centre = sum(measured) / 2
            ends = [float(row["partial"]), float(row["complete"])]
            for variant in stated.get("variants", []):
                if (letter, case, variant) in rows:
                    ends.append(middle(rows[letter, case, variant]))
            found.append(
                Comparison(
                    f"{letter} {case}",
                    middle(row) / centre,
                    (min(ends) / centre, max(ends) / centre),
                    (measured[0] / centre, measured[1] / centre),
                )
            )
        for name, ratio in experiment.get("ratios", {}).items():
            found += ratio_compared(letter, name, ratio, experiment, rows)
    return found


def ratio_compared(letter, name, ratio, experiment, rows):
    """The comparison of a ratio of two cases; its range is that over the variants that both cases have."""

    def value(variant):
        pair = [rows.get((letter, ratio[part], variant)) for part in ("of", "over")]
        return None if None in pair else (middle(pair[0]) / middle(pair[1])) ** ratio["power"]

    stated = value(AS_STATED)
    if stated is None:
        return []
    both = [experiment["cases"][ratio[part]].get("variants", []) for part in ("of", "over")]
    values = [value(variant) for variant in both[0] if variant in both[1]]
    values = [each / ratio["measured"] for each in [stated, *values] if each is not None]
    return [Comparison(f"{letter} {name}", values[0], (min(values), max(values)), (1, 1))]


def limit_text(row):
    """The bracket of a row as its middle and half of its width, m/s."""
    half = (float(row["complete"]) - float(row["partial"])) / 2
    return f"{middle(row):.0f} ± {half:.0f}"


def print_table(experiments, rows):
    """Two tables as markdown: comparisons, and the limits of all variants."""
    compared_by_label = {each.label: each for each in compared(experiments, rows)}
    print("| case | computed, m/s | measured, m/s | computed over measured | over all variants |")
    print("|---|---:|---:|---:|---:|")
    for label, each in compared_by_label.items():
        row = rows.get((label[0], label[2:], AS_STATED))
        computed = limit_text(row) if row else ""
        measured = f"{float(row['measured_low']):g} to {float(row['measured_high']):g}" if row else ""
        low, high = each.of_variants
        print(f"| {label} | {computed} | {measured} | {each.ratio:.2f} | {low:.2f} to {high:.2f} |")
    print("\n| case | variant | computed, m/s | over the case as stated |\n|---|---|---:|---:|")
    for limit in limits_of(experiments):
        letter, case, variant = limit.key
        row, stated = rows.get(limit.key), rows.get((letter, case, AS_STATED))
        if variant == AS_STATED or row is None or stated is None:
            continue
        print(f"| {letter} {case} | {variant} | {limit_text(row)} | {middle(row) / middle(stated):.2f} |")


def draw(experiments, rows, path):
    """One picture of all: computed over measured, with the ranges of both and a band of ten percent."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    found = compared(experiments, rows)[::-1]
    figure, axes = plt.subplots(figsize=(8, 0.3 * len(found) + 1.4))
    axes.axvspan(0.9, 1.1, color="0.92", label="± 10 %")
    axes.axvline(1, color="0.6", linewidth=0.8)
    for place, each in enumerate(found):
        first = place == 0
        axes.hlines(
            place,
            *each.of_measurement,
            color="tab:orange",
            linewidth=7,
            alpha=0.45,
            label="measurement, its range" if first else None,
        )
        axes.hlines(
            place,
            *each.of_variants,
            color="tab:blue",
            linewidth=2,
            label="model, range over its variants" if first else None,
        )
        axes.plot(each.ratio, place, "o", color="tab:blue", markersize=5, label="model" if first else None)
    axes.set_yticks(range(len(found)), [each.label for each in found])
    axes.set(xlabel="computed over measured", ylim=(-0.7, len(found) - 0.3))
    axes.set_xscale("log")
    ticks = [0.2, 0.3, 0.5, 0.7, 0.9, 1, 1.1, 1.5, 2, 3]
    low, high = axes.get_xlim()
    shown = [tick for tick in ticks if low <= tick <= high]
    axes.set_xticks(shown, [f"{tick:g}" for tick in shown])
    axes.set_xticks([], minor=True)
    axes.legend(loc="upper center", bbox_to_anchor=(0.4, -0.09), ncols=4, frameon=False, fontsize=9)
    figure.savefig(path, dpi=150, bbox_inches="tight")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--weavefront", type=Path, default=ROOT / "build/release/src/app/weavefront", help="the program"
    )
    parser.add_argument("--mpiexec", default="mpirun")
    parser.add_argument("--ranks", type=int, default=1, help="of a shot (default: 1)")
    parser.add_argument("--width", default="10 m/s", help="of the last bracket (default: 10 m/s)")
    parser.add_argument("--csv", type=Path, default=HERE / "limits.csv", help="where the rows are collected")
    parser.add_argument("--output", type=Path, default=Path("runs/fired_shots"), help="folder of the runs")
    parser.add_argument(
        "--only",
        metavar="TEXT",
        help="limits whose name, such as 'C | 8 plies, 2 gr | h = s/2', holds this text",
    )
    parser.add_argument("--table", action="store_true", help="print the rows instead of computing")
    parser.add_argument("--picture", type=Path, metavar="FILE", help="draw the rows instead of computing")
    options = parser.parse_args()
    experiments = tomllib.loads((HERE / "shots.toml").read_text())
    if options.table:
        return print_table(experiments, rows_of(options.csv))
    if options.picture:
        return draw(experiments, rows_of(options.csv), options.picture)
    chosen = [
        limit for limit in limits_of(experiments) if not options.only or options.only in " | ".join(limit.key)
    ]
    return collect(chosen, options)


if __name__ == "__main__":
    sys.exit(main())
