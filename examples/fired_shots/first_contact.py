#!/usr/bin/python3
"""Finds the striking velocity at which yarns break at first contact: before a wave has come back from an edge of the target.

Targets are a strip of straight yarns, one ply of S706 and eight plies. One input changes at a time. Collects one row a variant in
first_contact.csv, as a share of the critical velocity of J. C. Smith (1958); --picture FILE draws the rows of the strip, --table prints the
others as markdown.
"""

import argparse
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
FIELDS = ["target", "variant", "whole_m_s", "broken_m_s", "share_of_smith"]
WIDTH = 5  # m/s, of the last bracket
STIFFNESSES = (1.4e12, 5.6e12, 2.24e13, 8.96e13)
UNLOADINGS = (1, 3, 10, 100)


def smith(modulus, strain, density=1440):
    """Striking velocity at which a straight yarn has this strain behind the longitudinal front, m/s."""
    return math.sqrt(modulus / density) * math.sqrt(
        2 * strain * math.sqrt(strain * (1 + strain)) - strain**2
    )


def contact(stiffness, unloading):
    """Values of the contact of projectile and plies."""
    values = {}
    for kind, factor in (("projectile", 1), ("plies", 2)):
        values[f"contact.{kind}.stiffness"] = f"{factor * stiffness:g} N/m^3"
        values[f"contact.{kind}.unloading"] = f"{unloading:g}"
    return values


SPHERE = "{shape: sphere, diameter: 5.38 mm, mass: 10 kg, velocity: [0, 0, 600 m/s]}"
OF_STRIP = {
    f"k {stiffness:g}, unloading {unloading}": {
        name: value for name, value in contact(stiffness, unloading).items() if "plies" not in name
    }
    for stiffness in STIFFNESSES
    for unloading in UNLOADINGS
}
OF_STRIP |= {
    "h = 0.0625 mm, unloading 100": {
        "target.mesh": "{center: 0.0625 mm}",
        "target.size": "[100 mm, 0.25 mm]",
        "time.end": "5 us",
        "contact.projectile.unloading": "100",
    },
    "sphere, unloading 1": {"projectile": SPHERE, "contact.projectile.unloading": "1"},
    "sphere, unloading 100": {"projectile": SPHERE, "contact.projectile.unloading": "100"},
}
OF_FABRIC = {
    "as stated": {},
    "h = s/2": {"target.mesh.center": "0.3735 mm"},
    "h = s/4": {"target.mesh.center": "0.18675 mm"},
    "k x 4": contact(2.24e13, 10),
    "k / 4": contact(1.4e12, 10),
    "unloading 1": contact(5.6e12, 1),
    "unloading 100": contact(5.6e12, 100),
    "edge 0.1 mm": {"projectile.edge_radius": "0.1 mm"},
    "edge 0.5 mm": {"projectile.edge_radius": "0.5 mm"},
    "ball 0.70 g": {"projectile": "{standard: sphere_7_32in, velocity: [0, 0, 400 m/s]}"},
    "t = 0.20 mm": {"fabrics.s706.thickness": "0.20 mm"},
}
AIR = {"air 0.1 mm": {"target.plies.gap": "0.1 mm"}}


class Target:
    """What is struck: a scene, values for all its variants, and the critical velocity of its yarn, m/s."""

    def __init__(self, scene, values, variants, critical):
        self.scene, self.values, self.variants, self.critical = HERE / scene, values, variants, critical


S706 = smith(82.6e9, 0.0355)
SHORT = {"target.size": "[100 mm, 100 mm]", "time.end": "5 us", "output.history": "0.1 us"}
TARGETS = {
    "strip": Target("strip.yaml", {}, OF_STRIP, smith(99.1e9, 0.0325)),
    "1 ply": Target("km2_packs.yaml", SHORT | {"target.plies.count": "1"}, OF_FABRIC, S706),
    "8 plies": Target("km2_packs.yaml", SHORT, OF_FABRIC | AIR, S706),
}


def breaks(program, target, values, speed):
    """Whether a yarn breaks within the time of the scene."""
    with tempfile.TemporaryDirectory() as folder:
        values = target.values | values
        command = [program, "run", target.scene, "--output", Path(folder) / "run"]
        command += [f"--set={path}={value}" for path, value in values.items()]
        command += [f"--set=projectile.velocity=[0, 0, {speed:g} m/s]"]
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{target.scene.name}, {values}, {speed:g} m/s: {done.stderr}")
        with open(Path(folder) / "run/history.csv", newline="") as file:
            return any(float(row["broken_yarns"]) > 0 for row in csv.DictReader(file))


def bracket(program, target, values):
    """The velocities between which yarns begin to break, m/s."""
    low, high = 0.1 * target.critical, 1.2 * target.critical
    while high - low > WIDTH:
        speed = (low + high) / 2
        low, high = (low, speed) if breaks(program, target, values, speed) else (speed, high)
    return low, high


def rows_of(path):
    """Rows that were collected."""
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def collect(options):
    """Computes what is missing and appends each row when it is there."""
    done = {(row["target"], row["variant"]) for row in rows_of(options.csv)}
    if not done:
        options.csv.write_text(",".join(FIELDS) + "\n")
    for name, target in TARGETS.items():
        for variant, values in target.variants.items():
            if (name, variant) in done:
                continue
            low, high = bracket(options.weavefront, target, values)
            row = [name, variant, f"{low:.1f}", f"{high:.1f}", f"{(low + high) / 2 / target.critical:.3f}"]
            with open(options.csv, "a", newline="") as file:
                csv.writer(file, lineterminator="\n").writerow(row)
            print(f"{name} | {variant}: {low:.0f} to {high:.0f} m/s, {row[-1]} of Smith's", flush=True)


def print_table(rows):
    """Rows of the fabric as markdown, and of the strip without its grid of contacts."""
    shares = {(row["target"], row["variant"]): row["share_of_smith"] for row in rows}
    print("| | 1 ply | 8 plies |\n|---|---:|---:|")
    for variant in TARGETS["8 plies"].variants:
        print(
            f"| {variant} | {shares.get(('1 ply', variant), '')} | {shares.get(('8 plies', variant), '')} |"
        )
    print()
    for variant in OF_STRIP:
        print(f"| {variant} | {shares.get(('strip', variant), '')} |")


def draw(rows, path):
    """Share of Smith's critical velocity over the stiffness of contact, for the strip."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    shares = {row["variant"]: float(row["share_of_smith"]) for row in rows if row["target"] == "strip"}
    figure, axes = plt.subplots(figsize=(6.4, 4))
    axes.axhspan(0.6, 0.9, color="tab:orange", alpha=0.25, label="measured yarns: 10 to 40 % below Smith")
    axes.axhline(2**-0.75, color="0.4", linestyle="--", linewidth=0.8, label="waves meet under a flat face")
    for unloading in UNLOADINGS:
        values = [shares[f"k {stiffness:g}, unloading {unloading}"] for stiffness in STIFFNESSES]
        axes.semilogx(STIFFNESSES, values, "o-", label=f"unloading {unloading}")
    critical = TARGETS["strip"].critical
    axes.set(xlabel="contact stiffness, N/m³", ylabel=f"critical velocity over Smith's {critical:.0f} m/s")
    axes.set_ylim(0, 1.05)
    axes.legend(loc="lower left", ncols=2, frameon=False, fontsize=9)
    figure.savefig(path, dpi=150, bbox_inches="tight")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    program = HERE.parents[1] / "build/release/src/app/weavefront"
    parser.add_argument("--weavefront", type=Path, default=program, help="the program")
    parser.add_argument(
        "--csv", type=Path, default=HERE / "first_contact.csv", help="where the rows are collected"
    )
    parser.add_argument("--table", action="store_true", help="print the rows instead of computing")
    parser.add_argument("--picture", type=Path, metavar="FILE", help="draw the rows instead of computing")
    options = parser.parse_args()
    if options.table:
        return print_table(rows_of(options.csv))
    if options.picture:
        return draw(rows_of(options.csv), options.picture)
    return collect(options)


if __name__ == "__main__":
    sys.exit(main())
