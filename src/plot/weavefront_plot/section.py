"""section: the plies cut at y = 0 at several times, one line per ply."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from .deformed import caption, window_of
from .geometry import cut, mirrored, spacing
from .style import PLIES, save_figure

WIDTH = 6.0  # of a strip, inches


def ply_lines(results, step):
    """Segments in the x-z plane in mm [k, 2, 2] and the ply of each, mirrored to the whole width."""
    alive = np.flatnonzero(results.alive(step))
    segments, cells = cut(results.points(step) * 1e3, results.parts[0][alive], (0, 1))
    ply = results.ply[alive[cells]]
    sides = [mirrored(segments, (sign, 1))[..., [0, 2]] for sign in ((1, -1) if results.symmetry[0] else (1,))]
    return np.concatenate(sides), np.tile(ply, len(sides))


def outline(results, step):
    """The projectile's section in mm [k, 2] as a closed convex line, or None."""
    surface = results.projectile(step)
    if surface is None:
        return None
    segments, _ = cut(surface.points * 1e3, surface.quads, (0, 1))
    points = segments.reshape(-1, 3)[:, [0, 2]]
    if len(points) < 3:
        return None
    if results.symmetry[0]:
        points = np.concatenate([points, points * [-1, 1]])
    around = points - points.mean(axis=0)
    return points[np.argsort(np.arctan2(around[:, 1], around[:, 0]))]


def draw_section(run, path, frames, window=None):
    """One strip per frame, equal scales, the shot going upwards."""
    results = run.results
    window = 1e3 * (window or window_of(results, frames))
    strips = [(ply_lines(results, step), outline(results, step)) for step in frames]
    width = float(np.clip(0.55 * WIDTH * 72 * 1e3 * spacing(results.reference, results.parts[0], results.ply) / (2 * window), 0.5, 1.6))
    numbers = np.unique(results.ply)
    tint = {number: PLIES(i / max(len(numbers) - 1, 1)) for i, number in enumerate(numbers)}
    spans = [heights(lines, body, window) for (lines, _), body in strips]
    figure, axes = plt.subplots(len(frames), 1, figsize=(WIDTH + 1, 1), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": [high - low for low, high in spans], "hspace": 0.06})
    figure.set_size_inches(WIDTH + 1, 0.8 * WIDTH * sum(high - low for low, high in spans) / (2 * window) + 0.4)
    for panel, step, ((lines, ply), body), span in zip(axes[:, 0], frames, strips, spans):
        if body is not None:
            panel.fill(*body.T, facecolor="#d7d9dc", edgecolor="#6d7278", lw=0.8, zorder=1)
        panel.add_collection(LineCollection(lines, colors=[tint[number] for number in ply], linewidths=width, capstyle="round", zorder=2))
        panel.set(xlim=(-window, window), ylim=span, ylabel="z, mm")
        panel.set_aspect("equal")
        panel.text(0.015, 0.96, caption(run, step), transform=panel.transAxes, va="top", fontsize=8.5)
    figure.align_ylabels(axes)
    axes[-1, 0].set_xlabel("x, mm")
    keys = [Line2D([], [], color=tint[number], lw=2, label=f"{number}") for number in numbers]
    axes[0, 0].legend(handles=keys[::-1], title="Ply", title_fontsize=8.5, loc="upper left", bbox_to_anchor=(1.005, 1.0),
                      handlelength=1.0, borderaxespad=0)
    save_figure(figure, path)


def heights(lines, body, window):
    """The range of z that a strip shows: the plies, the projectile as far as it is near them, and a margin."""
    inside = lines[np.abs(lines[..., 0]).max(axis=1) <= window, :, 1] if len(lines) else lines[..., 1]
    low, high = float(inside.min(initial=0.0)), float(inside.max(initial=0.0))
    if body is not None and body[:, 1].min() < high + 0.25 * window:
        low, high = min(low, body[:, 1].min()), max(high, body[:, 1].max())
    margin = 0.05 * window
    return low - margin, high + 2.5 * margin
