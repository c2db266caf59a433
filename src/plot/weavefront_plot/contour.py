"""contour_<time>: the shape of the last ply in plan view at rebound."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from .geometry import images
from .picture_file import announce
from .pyramid import pyramid, write_pyramid
from .run import microseconds
from .style import CYAN, FIELD, INK, save_figure

FLAT = 1e-9  # m, below which nothing is deflected


def triangles(results, quads, step):
    """The quads as triangles over the whole plan: each split at its middle, x, y and height in mm."""
    points, height = results.points(step) * 1e3, results.displacement(step)[:, 2] * 1e3
    nodes, quads = np.unique(quads, return_inverse=True)
    quads = quads.reshape(-1, 4)
    plan = np.column_stack([points[nodes, :2], height[nodes]])
    plan = np.concatenate([plan, plan[quads].mean(axis=1)])
    middle = len(nodes) + np.arange(len(quads))
    corner = np.concatenate([np.column_stack([quads[:, i], quads[:, (i + 1) % 4], middle]) for i in range(4)])
    plans = [plan * [sx, sy, 1] for sx, sy in images(results.symmetry)]
    return np.concatenate(plans), np.concatenate([corner + i * len(plan) for i in range(len(plans))])


def draw_contour(run, fabric, path, step, window=None):
    """Contour lines of the deflection and the half-height contour with its measured extents."""
    results, shape = run.results, pyramid(run, fabric, step)
    write_pyramid(shape, path.with_name("pyramid.json"))
    if shape["height"] < FLAT:
        return
    low, high = 1e3 * fabric.limits(run.impact, window or fabric.window(run.impact, [step]))
    plan, corner = triangles(results, fabric.last_ply(step), step)
    figure, axes = plt.subplots(figsize=(4.9, 4.4))
    mesh = Triangulation(plan[:, 0], plan[:, 1], corner)
    levels = MaxNLocator(10).tick_values(0, 1e3 * shape["height"])[1:]  # what is below the first stays white
    filled = axes.tricontourf(mesh, plan[:, 2], levels=levels, cmap=FIELD)
    axes.tricontour(mesh, plan[:, 2], levels=levels, colors=INK, linewidths=0.35)
    axes.tricontour(mesh, plan[:, 2], levels=[500 * shape["height"]], colors=CYAN, linewidths=1.8)
    x, y = 1e3 * run.impact.x, 1e3 * run.impact.y
    if shape["ratio"]:
        draw_extents(axes, shape, x, y)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x, mm", ylabel="y, mm")
    axes.set_aspect("equal")
    axes.set_title(
        f"Ply {shape['ply']} at {microseconds(shape['time'])}", loc="left", pad=32 if shape["ratio"] else None
    )
    bar = figure.colorbar(filled, ax=axes, fraction=0.045, pad=0.03)
    bar.set_label("Deflection, mm")
    bar.outline.set_linewidth(0.5)
    save_figure(figure, path)


def draw_extents(axes, shape, x, y):
    """The two measured lengths as arrows from the impact in mm, and their ratio."""
    along, across = 1e3 * shape["extent_x"], 1e3 * shape["extent_diagonal"]
    for right, up in ((along, 0.0), (across / np.sqrt(2), across / np.sqrt(2))):
        arrow = axes.annotate(
            "",
            (x + right, y + up),
            (x, y),
            arrowprops={"arrowstyle": "-|>", "color": "white", "lw": 1.2, "shrinkA": 0, "shrinkB": 0},
        )
        arrow.arrow_patch.set_path_effects([withStroke(linewidth=2.4, foreground=INK)])  # seen on white, too
    label = f"half height: {along:.1f} mm along x,\n{across:.1f} mm diagonally, ratio {shape['ratio']:.2f}"
    axes.plot([], [], color=CYAN, lw=1.8, label=label)
    axes.legend(
        loc="lower left", bbox_to_anchor=(-0.02, 1.0), borderaxespad=0.1, handlelength=1.3, fontsize=8
    )
    announce(
        f"half-height contour of ply {shape['ply']} at {shape['time'] * 1e6:.3g} us: {along:.2f} mm along x, "
        f"{across:.2f} mm along the diagonal, ratio {shape['ratio']:.3f}"
    )
