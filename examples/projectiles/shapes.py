#!/usr/bin/python3
"""Draws every projectile of the library and every shape that a scene can state, at one scale.

The surfaces are those of results.vtkhdf, one short run of scene.yaml each.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "src/plot"))

VELOCITY = "velocity: [0, 0, 1 m/s]"
SHAPES = {
    "sphere": "diameter: 9 mm, mass: 3 g",
    "cylinder": "diameter: 9 mm, edge_radius: 1 mm, length: 14 mm, mass: 7 g",
    "hemisphere": "diameter: 9 mm, length: 14 mm, mass: 6 g",
    "cone": "diameter: 9 mm, length: 18 mm, apex_angle: 60 deg, mass: 7 g",
    "truncated_cone": "diameter: 9 mm, length: 14 mm, tip_diameter: 4 mm, nose_length: 5 mm, mass: 6 g",
    "ogive": "diameter: 9 mm, length: 24 mm, caliber_radius_head: 2.5, mass: 9 g",
    "profile": "points: [[0, 0 mm], [2 mm, -3 mm], [4.5 mm, -5 mm], [4.5 mm, -12 mm], [3 mm, -15 mm], [0, -15 mm]], mass: 6 g",
    "fsp": "diameter: 9 mm, length: 12 mm, flat_width: 4 mm, mass: 5 g",
    "box": "size: [9 mm, 6 mm, 12 mm], mass: 5 g",
    "ring_segment": "outer_radius: 30 mm, thickness: 3 mm, width: 10 mm, sector: 40 deg, mass: 5 g",
    "mesh": "points: [[5 mm, 0, 0], [-5 mm, 0, 0], [0, 5 mm, 0], [0, -5 mm, 0], [0, 0, 8 mm], [0, 0, -8 mm]],"
    " triangles: [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], mass: 3 g",
}


def projectiles(program):
    """Names under the pictures, and what a scene says of each projectile."""
    listed = subprocess.run([program, "projectiles"], capture_output=True, text=True, check=True).stdout
    found = {
        name: f"{{standard: {name}, {VELOCITY}}}" for name in re.findall(r"^(\w+):", listed, re.MULTILINE)
    }
    return found | {
        f"shape: {shape}": f"{{shape: {shape}, {keys}, {VELOCITY}}}" for shape, keys in SHAPES.items()
    }


def surface(program, projectile):
    """Corners of the triangles of a projectile at the start, mm [n, 4, 3]."""
    from weavefront_plot.results import Results

    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "run"
        command = [program, "run", HERE / "scene.yaml", "--output", output, f"--set=projectile={projectile}"]
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{projectile}: {done.stderr}")
        mesh = Results(output / "results.vtkhdf").projectile(0)
    return 1e3 * mesh.points[mesh.quads]


def shades(corners):
    """Grey of each face: bright where it is turned to a light above the viewer's left shoulder."""
    import numpy as np

    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    if np.sum(normals * corners.mean(axis=1)) < 0:  # the volume: faces may be wound either way
        normals = -normals
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    light = np.array([0.2, -0.75, 0.63])
    grey = 0.45 + 0.45 * np.clip((normals / np.maximum(lengths, 1e-300)) @ light, -0.6, 1)
    return np.repeat(grey[:, None], 3, axis=1)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--weavefront", type=Path, default=ROOT / "build/release/src/app/weavefront", help="the program"
    )
    parser.add_argument(
        "file", type=Path, nargs="?", default=HERE / "shapes.png", help="picture (default: shapes.png here)"
    )
    options = parser.parse_args()

    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    chosen = projectiles(options.weavefront)
    columns, half = 6, 15  # mm
    rows = -(-len(chosen) // columns)
    figure = plt.figure(figsize=(2 * columns, 2.2 * rows))
    for place, (name, projectile) in enumerate(chosen.items(), 1):
        corners = surface(options.weavefront, projectile)
        middle = (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1))) / 2
        axes = figure.add_subplot(rows, columns, place, projection="3d")
        greys = shades(corners - middle)
        axes.add_collection3d(
            Poly3DCollection(corners - middle, facecolors=greys, edgecolors=greys, linewidth=0.4)
        )
        axes.set(xlim=(-half, half), ylim=(-half, half), zlim=(-half, half))
        axes.set_box_aspect((1, 1, 1), zoom=1.5)
        axes.view_init(elev=25, azim=-60)
        axes.set_axis_off()
        axes.set_title(name, fontsize=9, y=0.92)
    figure.subplots_adjust(0, 0, 1, 0.96, wspace=0, hspace=0.1)
    figure.savefig(options.file, dpi=110)


if __name__ == "__main__":
    main()
