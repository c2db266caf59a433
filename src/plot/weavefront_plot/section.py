"""section: the plies cut through the impact, along the shot where it is oblique, at several times."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.ticker import FixedLocator, MaxNLocator

from .geometry import cut, images, mirrored, spacing
from .style import PLIES, save_figure

WIDTH, GAP, CAPTION = 4.6, 0.07, 0.22  # inches: of a strip, between strips, of the line of text in each
LOWEST, TALLEST = 0.14, 2.0  # height of a strip over its width
AWAY = 0.6  # how far from the fabric the projectile is shown, over the width of a strip
KEY, NUMBER = 2.4, 0.16  # inches: height of the bar of colours, of a number beside it


def cut_at_impact(results, impact, points, quads):
    """Segments in the plane of the section in mm [k, 2, 2] of all mirror images, and the quad of each."""
    normal = (-impact.along[1], impact.along[0])
    parts = [
        cut(mirrored(points, sign), quads, normal, (impact.x, impact.y)) for sign in images(results.symmetry)
    ]
    segments = np.concatenate([segments for segments, _ in parts])
    return 1e3 * np.stack([impact.distance(segments), segments[..., 2]], axis=-1), np.concatenate(
        [cells for _, cells in parts]
    )


def ply_lines(run, fabric, step):
    """Segments of what is joined to a support [k, 2, 2] and the ply of each."""
    joined = np.flatnonzero(fabric.joined(step))
    segments, cells = cut_at_impact(run.results, run.impact, run.results.points(step), fabric.quads[joined])
    return segments, run.results.ply[joined[cells]]


def outlines(run, step):
    """The sections of the projectiles that it cuts, each [k, 2] as a closed convex line."""
    lines = []
    for surface in run.results.projectiles(step):
        points = cut_at_impact(run.results, run.impact, surface.points, surface.quads)[0].reshape(-1, 2)
        if len(points) < 3:
            continue
        around = points - points.mean(axis=0)
        lines.append(points[np.argsort(np.arctan2(around[:, 1], around[:, 0]))])
    return lines


def plane_of(impact):
    """Label of the horizontal axis, and where the plane stands."""
    if impact.along == (1.0, 0.0):
        return "x, mm", f"at y = {length(impact.y)}"
    if impact.along == (0.0, 1.0):
        return "y, mm", f"at x = {length(impact.x)}"
    degrees = np.degrees(np.arctan2(impact.along[1], impact.along[0]))
    return (
        "Along the shot from the impact, mm",
        f"at {degrees:.0f}° to x through ({length(impact.x)}, {length(impact.y)})",
    )


def length(value):
    """A length in mm."""
    return f"{1e3 * value:.4g} mm".replace("-", "−")


def shown_range(fabric, impact, window):
    """Lowest and highest horizontal position of a strip in mm: the window, as far as the target reaches."""
    middle = float(impact.distance(np.array([impact.x, impact.y])))
    (left, bottom), (right, top) = fabric.limits(impact, window)
    corners = impact.distance(np.array([[left, bottom], [right, bottom], [right, top], [left, top]]))
    return 1e3 * max(middle - window, corners.min()), 1e3 * min(middle + window, corners.max())


def draw_section(run, fabric, path, frames, window=None):
    """One strip per frame, equal scales, the shot going upwards."""
    left, right = shown_range(fabric, run.impact, window or fabric.window(run.impact, frames))
    strips = [(ply_lines(run, fabric, step), outlines(run, step)) for step in frames]
    spans = [heights(lines, bodies, left, right) for (lines, _), bodies in strips]
    figure, panels = panels_of([high - low for low, high in spans], right - left)
    distance = 1e3 * spacing(run.results.reference, fabric.quads, run.results.ply)
    width = float(np.clip(0.55 * 72 * WIDTH * distance / (right - left), 0.5, 1.6))
    tint = dict(zip(fabric.plies, tints(len(fabric.plies))))
    label, place = plane_of(run.impact)
    for panel, step, ((lines, ply), bodies), span in zip(panels, frames, strips, spans):
        for body in bodies:
            panel.fill(*body.T, facecolor="#d7d9dc", edgecolor="#6d7278", lw=0.8, zorder=1)
        panel.add_collection(
            LineCollection(
                lines, colors=[tint[number] for number in ply], linewidths=width, capstyle="round", zorder=2
            )
        )
        panel.set(xlim=(left, right), ylim=span, ylabel="z, mm")
        panel.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10], prune="upper"))
        panel.tick_params(labelbottom=panel is panels[-1])
        panel.annotate(
            run.caption(step),
            (0, 1),
            (6, -3),
            xycoords="axes fraction",
            textcoords="offset points",
            va="top",
            fontsize=8.5,
        )
    figure.align_ylabels(panels)
    panels[-1].set_xlabel(label)
    panels[0].set_title(f"Section {place}", loc="left")
    if len(fabric.plies) > 1:
        draw_key(figure, panels, fabric.plies)
    save_figure(figure, path)


def panels_of(heights, width):
    """A figure with a strip for each height below one another, all `width` wide, in one scale."""
    inches = [WIDTH * height / width for height in heights]
    total = sum(inches) + GAP * (len(heights) - 1)
    figure = plt.figure(figsize=(WIDTH, total))
    tops = total - np.cumsum([0, *(height + GAP for height in inches[:-1])])
    return figure, [
        figure.add_axes([0, (top - height) / total, 1, height / total]) for top, height in zip(tops, inches)
    ]


def tints(count):
    """A colour for each ply."""
    return [PLIES(i / max(count - 1, 1)) for i in range(count)]


def draw_key(figure, panels, plies):
    """The plies' colours as a bar beside the strips, in which any number of plies has room."""
    steps = np.arange(len(plies) + 1)
    colours = ScalarMappable(BoundaryNorm(steps, len(plies)), ListedColormap(tints(len(plies))))
    total = figure.get_size_inches()[1]
    height = min(total, KEY, 2 * NUMBER * len(plies))
    bar = figure.colorbar(
        colours, cax=figure.add_axes([1.03, 1 - height / total, 0.022, height / total]), ticks=[]
    )
    bar.outline.set_linewidth(0.5)
    bar.minorticks_off()
    each = int(np.ceil(len(plies) / max(height // NUMBER, 1)))
    bar.ax.yaxis.set_major_locator(FixedLocator(steps[:-1:each] + 0.5))
    bar.ax.set_yticklabels([f"{number}" for number in plies[::each]])
    bar.ax.tick_params(length=0)
    bar.ax.set_title("Ply", fontsize=8.5)


def heights(lines, bodies, left, right):
    """The range of z in a strip: the plies, projectiles as far as they are near, and room for the caption."""
    width = right - left
    inside = lines[np.all((lines[..., 0] >= left) & (lines[..., 0] <= right), axis=1), :, 1]
    low, high = float(inside.min(initial=0.0)), float(inside.max(initial=0.0))
    high = min(high, low + TALLEST * width)
    fabric_low, fabric_high = low, high
    for body in bodies:
        if body[:, 1].min() < fabric_high + 0.125 * width:
            low = min(low, max(body[:, 1].min(), fabric_low - AWAY * width))
            high = max(high, min(body[:, 1].max(), fabric_high + AWAY * width))
    low, high = low - 0.025 * width, high + (0.01 + CAPTION / WIDTH) * width
    return low, max(high, low + LOWEST * width)
