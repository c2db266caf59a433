"""pyramid.json: the half-height contour of the last ply about the impact."""
import json

import numpy as np

from .geometry import extent
from .picture_file import write


def pyramid(run, fabric, step):
    """Extents in m from the impact along x, y and the diagonal, and the ratio of the first to the last."""
    results, impact = run.results, run.impact
    quads, points, height = fabric.last_ply(step), results.points(step), results.displacement(step)[:, 2]
    top = float(height[quads].max(initial=0.0))

    def mean(directions):
        reached = [
            extent(points, quads, height, top / 2, (impact.x, impact.y), d) for d in directions if top > 0
        ]
        reached = [r for r in reached if r is not None]
        return float(np.mean(reached)) if reached else None

    x, y = ([1] if results.symmetry[0] else [1, -1]), ([1] if results.symmetry[1] else [1, -1])
    along_x, along_y = mean([(a, 0) for a in x]), mean([(0, b) for b in y])
    diagonal = mean([(a, b) for a in x for b in y])
    ratio = along_x / diagonal if along_x and diagonal else None
    return {
        "time": float(results.times[step]),
        "ply": int(fabric.plies[-1]),
        "impact_x": impact.x,
        "impact_y": impact.y,
        "height": top,
        "extent_x": along_x,
        "extent_y": along_y,
        "extent_diagonal": diagonal,
        "ratio": ratio,
    }


def write_pyramid(shape, path):
    """The measures as JSON."""
    write(path, lambda temporary: temporary.write_text(json.dumps(shape, indent=2) + "\n", encoding="utf-8"))
