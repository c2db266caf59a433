"""contour_<time> and pyramid.json: the shape of the last ply in plan view at rebound."""
import json

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from .deformed import window_of
from .geometry import extent, images, mirrored
from .style import CYAN, FIELD, INK, save_figure, write


def last_ply(results, step):
    """The quads of the last ply that are not eroded."""
    return results.parts[0][(results.ply == results.ply.max()) & results.alive(step)]


def pyramid(run, step):
    """The half-height contour of the last ply: its extents in m along x, y and the diagonal, and along x over along the diagonal."""
    results = run.results
    quads, points, height = last_ply(results, step), results.points(step), results.displacement(step)[:, 2]
    top = float(height[quads].max(initial=0.0))

    def mean(directions):
        reached = [extent(points, quads, height, top / 2, d) for d in directions if top > 0]
        reached = [r for r in reached if r is not None]
        return float(np.mean(reached)) if reached else None

    x, y = ([1] if results.symmetry[0] else [1, -1]), ([1] if results.symmetry[1] else [1, -1])
    along_x, along_y = mean([(a, 0) for a in x]), mean([(0, b) for b in y])
    diagonal = mean([(a, b) for a in x for b in y])
    ratio = along_x / diagonal if along_x and diagonal else None
    return {"time": float(results.times[step]), "ply": int(results.ply.max()), "height": top, "extent_x": along_x, "extent_y": along_y,
            "extent_diagonal": diagonal, "ratio": ratio}


def triangles(results, step):
    """The last ply as triangles over the whole plan: each quad split at its middle, x, y and height in mm."""
    quads = last_ply(results, step)
    points, height = results.points(step) * 1e3, results.displacement(step)[:, 2] * 1e3
    nodes, quads = np.unique(quads, return_inverse=True)
    quads = quads.reshape(-1, 4)
    plan = np.column_stack([points[nodes, :2], height[nodes]])
    plan = np.concatenate([plan, plan[quads].mean(axis=1)])
    middle = len(nodes) + np.arange(len(quads))
    corner = np.concatenate([np.column_stack([quads[:, i], quads[:, (i + 1) % 4], middle]) for i in range(4)])
    plans = [plan * [sx, sy, 1] for sx, sy in images(results.symmetry)]
    return np.concatenate(plans), np.concatenate([corner + i * len(plan) for i in range(len(plans))])


def draw_contour(run, path, step, window=None):
    """Contour lines of the deflection and the half-height contour with its measured extents."""
    results, shape = run.results, pyramid(run, step)
    write(path.with_name("pyramid.json"), lambda temporary: temporary.write_text(json.dumps(shape, indent=2) + "\n", encoding="utf-8"))
    window = 1e3 * (window or window_of(results, [step]))
    plan, corner = triangles(results, step)
    if len(corner) == 0 or shape["height"] <= 0:
        return
    figure, axes = plt.subplots(figsize=(4.9, 4.4))
    mesh = Triangulation(plan[:, 0], plan[:, 1], corner)
    levels = MaxNLocator(10).tick_values(0, 1e3 * shape["height"])[1:]  # what is below the first stays white
    filled = axes.tricontourf(mesh, plan[:, 2], levels=levels, cmap=FIELD)
    axes.tricontour(mesh, plan[:, 2], levels=levels, colors=INK, linewidths=0.35)
    axes.tricontour(mesh, plan[:, 2], levels=[500 * shape["height"]], colors=CYAN, linewidths=1.8)
    if shape["ratio"]:
        draw_extents(axes, shape)
    axes.set(xlim=(-window, window), ylim=(-window, window), xlabel="x, mm", ylabel="y, mm")
    axes.set_aspect("equal")
    axes.set_title(f"Ply {shape['ply']} at {shape['time'] * 1e6:.3g} µs", loc="left")
    bar = figure.colorbar(filled, ax=axes, fraction=0.045, pad=0.03)
    bar.set_label("Deflection, mm")
    bar.outline.set_linewidth(0.5)
    save_figure(figure, path)


def draw_extents(axes, shape):
    """The two measured lengths as arrows from the axis, and their ratio."""
    along, across = 1e3 * shape["extent_x"], 1e3 * shape["extent_diagonal"]
    for x, y in ((along, 0.0), (across / np.sqrt(2), across / np.sqrt(2))):
        axes.annotate("", (x, y), (0, 0), arrowprops={"arrowstyle": "-|>", "color": "white", "lw": 1.2, "shrinkA": 0, "shrinkB": 0})
    label = f"half height: {along:.1f} mm along x,\n{across:.1f} mm diagonally, ratio {shape['ratio']:.2f}"
    axes.plot([], [], color=CYAN, lw=1.8, label=label)
    axes.legend(loc="lower right", bbox_to_anchor=(1.02, 1.0), borderaxespad=0.1, handlelength=1.3, fontsize=8)
    print(f"half-height contour of ply {shape['ply']} at {shape['time'] * 1e6:.3g} us: {along:.2f} mm along x, "
          f"{across:.2f} mm along the diagonal, ratio {shape['ratio']:.3f}")
