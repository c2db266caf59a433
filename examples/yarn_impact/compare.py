#!/usr/bin/python3
"""Compares a run of scene.yaml with J. C. Smith's transverse impact on a yarn (1958): compare.py
RUN_DIRECTORY [--picture FILE]

Leaves with status 1 when the strain behind the front or the speed of a wave is off by more than 3 %, or the
strain scatters by more.
"""

import argparse
import csv
import re
import sys
from pathlib import Path

import h5py
import numpy as np

TOLERANCE = 0.03


def wave_speed(scene):
    """Longitudinal wave speed sqrt(E1 S/(s areal density)), m/s, from the text of the scene (SI)."""

    def number(key):
        return float(re.search(rf"\b{key}: ([-+.\deE]+)", scene).group(1))

    return np.sqrt(number("static_modulus") * number("area") / number("span") / number("areal_density"))


def smith(speed, c):
    """Strain behind the longitudinal front and laboratory speed of the transverse wave, m/s, at an impact
    speed."""
    low, high = 0.0, 1.0
    for _ in range(200):  # V = c sqrt(2 e sqrt(e (1 + e)) - e^2) grows with e
        e = (low + high) / 2
        low, high = (e, high) if c * np.sqrt(2 * e * np.sqrt(e * (1 + e)) - e * e) < speed else (low, e)
    return e, c * (np.sqrt(e * (1 + e)) - e)


class Strip:
    """The line y = 0 of the strip over the frames of a run."""

    def __init__(self, path):
        with h5py.File(path) as file:
            self.scene = file["scene"][:].tobytes().decode()
            grid = file["VTKHDF"]
            nodes, elements = int(grid["NumberOfPoints"][0]), int(grid["NumberOfCells"][0])
            steps = grid["Steps"]
            frames = range(int(steps.attrs["NSteps"]))
            self.times = steps["Values"][: len(frames)]
            points = [grid["Points"][row : row + nodes] for row in steps["PointOffsets"][: len(frames)]]
            strain = [
                grid["CellData/strain_fill"][row : row + elements]
                for row in steps["CellDataOffsets/strain_fill"][: len(frames)]
            ]
            quads = grid["Connectivity"][: 4 * elements].reshape(-1, 4)
        line = points[0][:, 1] == 0
        self.x, self.z = [p[line, 0] for p in points], [p[line, 2] for p in points]
        # All elements across the strip see the same waves: their mean.
        self.centre, column = np.unique(points[0][quads, 0].mean(axis=1).round(9), return_inverse=True)
        self.strain = [np.bincount(column, s) / np.bincount(column) for s in strain]


def kink(x, z):
    """Where the straight flank between 20 % and 80 % of the height meets the plane of the strip, m."""
    flank = (z > 0.2 * z.max()) & (z < 0.8 * z.max())
    slope, height = np.polyfit(x[flank], z[flank], 1)
    return -height / slope


def front(centre, strain, plateau):
    """Where the strain falls through half its plateau, m."""
    last = np.flatnonzero(strain > plateau / 2)[-1]
    share = (strain[last] - plateau / 2) / (strain[last] - strain[last + 1])
    return centre[last] + share * (centre[last + 1] - centre[last])


def measure(strip, expected):
    """Strain behind the front and its scatter, laboratory speed of the kink, speed of the longitudinal front
    (m/s)."""
    # The first quarter of the run is left to the length of strip under the face of the projectile.
    frames = [k for k, t in enumerate(strip.times) if t >= strip.times[-1] / 4]
    times = strip.times[frames]
    kinks = np.array([kink(strip.x[k], strip.z[k]) for k in frames])
    fronts = np.array([front(strip.centre, strip.strain[k], expected) for k in frames])
    between = (strip.centre > 1.3 * kinks[-1]) & (strip.centre < 0.9 * fronts[-1])
    plateau = strip.strain[-1][between]
    return {
        "strain": plateau.mean(),
        "scatter": plateau.std(),
        "kink": np.polyfit(times, kinks, 1)[0],
        "front": np.polyfit(times, fronts, 1)[0],
    }


def draw(path, strip, speed, c, e, U):
    """Shape and strain of the strip at four times, over Smith's."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (shape, strain) = pyplot.subplots(2, 1, figsize=(9, 7), constrained_layout=True)
    for k in np.linspace(0, len(strip.times) - 1, 5).round().astype(int)[1:]:
        t = strip.times[k]
        (drawn,) = shape.plot(1e3 * strip.x[k], 1e3 * strip.z[k], label=f"{1e6 * t:.0f} us")
        shape.plot([0, 1e3 * U * t], [1e3 * speed * t, 0], "k:", lw=1)
        strain.plot(1e3 * strip.centre, 1e2 * strip.strain[k], color=drawn.get_color(), lw=1)
        strain.plot([0, 1e3 * c * t, 1e3 * c * t], [1e2 * e, 1e2 * e, 0], "k:", lw=1)
    shape.set(
        xlim=(0, 1.5e3 * U * strip.times[-1]),
        xlabel="x, mm",
        ylabel="deflection, mm",
        title=f"Transverse impact at {speed:.0f} m/s on a strip of straight yarns; dotted: Smith (1958)",
    )
    shape.legend()
    strain.set(xlabel="initial x, mm", ylabel="yarn strain, %", xlim=(0, 1e3 * strip.centre[-1]))
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path, help="folder with history.csv and results.vtkhdf")
    parser.add_argument("--picture", type=Path, help="file to draw into")
    arguments = parser.parse_args()
    strip = Strip(arguments.run / "results.vtkhdf")
    with open(arguments.run / "history.csv", newline="") as file:
        speed = float(list(csv.DictReader(file))[-1]["projectile_vz"])
    c = wave_speed(strip.scene)
    e, U = smith(speed, c)
    found = measure(strip, e)
    off = []
    for name, value, exact in [
        ("strain behind the front", found["strain"], e),
        ("transverse wave speed, m/s", found["kink"], U),
        ("longitudinal wave speed, m/s", found["front"], c),
    ]:
        off.append(abs(value / exact - 1))
        print(f"{name:30} {value:10.6g}   Smith {exact:10.6g}   off by {100 * (value / exact - 1):+.2f} %")
    off.append(found["scatter"] / e)
    print(f"{'scatter of the strain':30} {found['scatter']:10.6g}   {100 * off[-1]:.2f} % of Smith's strain")
    if arguments.picture:
        draw(arguments.picture, strip, speed, c, e, U)
    return int(max(off) > TOLERANCE)


if __name__ == "__main__":
    sys.exit(main())
