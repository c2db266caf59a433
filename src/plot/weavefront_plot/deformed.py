"""deformed_<time>: the plies in space with one quarter taken out, coloured by a cell array (figures 12 to 14)."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_rgb

from .geometry import cut, images, mirrored, spacing
from .quantity import ARRAYS, Shown
from .style import FIELD, INK, save_figure
from .view import Faces, View

VIEW = View(azimuth=-52.0, elevation=24.0)
GREY = np.array(to_rgb("#a9adb2"))
FINE = 0.4  # mm, longest edge of faces near the projectile
SECTION_LIFT = 0.4  # mm towards the viewer, to lie on the faces that it bounds


def open_quarter(points):
    """Which horizontal positions are in the quarter that faces the viewer."""
    return (points[..., 0] > 0) & (points[..., 1] < 0)


def window_of(results, frames):
    """A window that holds the deflected area: where the last frames deflect by 2 % of the most, and a margin."""
    reach = 0.0
    for step in frames:
        height = np.abs(results.displacement(step)[:, 2])
        moved = results.reference[height > 0.02 * max(height.max(), 1e-12), :2]
        reach = max(reach, np.abs(moved).max(initial=0.0))
    return float(min(1.1 * reach, np.abs(results.reference[:, :2]).max())) or float(np.abs(results.reference[:, :2]).max())


def fabric(results, step, window, field, norm):
    """The plies' faces in mm: all mirror images but the open quarter, within the window, eroded ones left out."""
    quads, points = results.parts[0], results.points(step) * 1e3
    centre = results.reference[quads].mean(axis=1)
    shown = results.alive(step) & np.all(np.abs(centre[:, :2]) <= window, axis=1)
    colours = FIELD(norm(results.field(field, step) * shown_as(field).factor))[:, :3]
    groups = []
    for sign in images(results.symmetry):
        kept = shown & ~open_quarter(mirrored(centre, sign))
        corners = mirrored(points, sign)[quads[kept]]
        groups.append(Faces(corners, VIEW.lit(corners, colours[kept], 0.5), np.zeros(len(corners))))
        groups.append(section(mirrored(points, sign), quads[kept], colours[kept], 0.55e3 * spacing(results.reference, quads, results.ply)))
    return Faces.join(groups)


def section(points, quads, colours, thickness):
    """The cut edges of the plies beside the open quarter, as dark bands of the given thickness in mm."""
    bands, tints = [], []
    for normal, beside in (((0, 1), lambda middle: middle[:, 0] > 0), ((-1, 0), lambda middle: middle[:, 1] < 0)):
        segments, cells = cut(points, quads, normal)
        on_edge = beside(segments.mean(axis=1))
        segments, cells = segments[on_edge], cells[on_edge]
        raised = segments[:, ::-1] + np.array([0.0, 0.0, thickness])
        bands.append(np.concatenate([segments, raised], axis=1))
        tints.append(0.42 * colours[cells])
    corners = np.concatenate(bands)
    return Faces(corners, np.concatenate(tints), np.full(len(corners), SECTION_LIFT))


def projectile(results, step, top):
    """The projectile's faces in mm, or none when it has left the picture (all of it above `top`)."""
    surface = results.projectile(step)
    if surface is None or surface.points[:, 2].min() > top:
        return Faces(np.empty((0, 4, 3)), np.empty((0, 3)), np.empty(0))
    corners = surface.points[surface.quads] * 1e3
    return Faces(corners, VIEW.lit(corners, GREY, 0.85), np.full(len(corners), -FINE))


def together(plies, shot):
    """Plies and projectile; where they meet their faces are divided, as the fabric lies on the nose."""
    if len(shot.corners) == 0:
        return plies
    near = plies.near_axis(2 * np.hypot(*shot.corners.reshape(-1, 3)[:, :2].T).max())
    return Faces.join([plies.where(~near), plies.where(near).split(FINE), shot.split(FINE)])


def shown_as(field):
    """Label and factor of an array."""
    return ARRAYS.get(field, Shown(field))


def colour_range(results, frames, field):
    """One range for all frames, from zero where the values allow it."""
    values = [results.field(field, step)[results.alive(step)] for step in frames]
    values = np.concatenate(values) * shown_as(field).factor
    low, high = float(values.min(initial=0.0)), float(values.max(initial=0.0))
    if field in ("stress", "strain", "stress_fill", "stress_warp"):
        low = 0.0
    elif low >= 0 and field in ("braid_angle", "crimp_height"):
        low = float(values.min())
    return Normalize(low, high if high > low else low + 1.0, clip=True)


def draw_deformed(run, paths, frames, window=None, field=None):
    """One picture per frame, all in the same scale and colours."""
    results = run.results
    field = field or results.default_field()
    norm = colour_range(results, frames, field)
    window = window or window_of(results, frames)
    scenes = []
    for step in frames:
        faces = fabric(results, step, window, field, norm)
        top = max(faces.corners[..., 2].max(initial=0.0) * 1e-3, 0.0) + 0.25 * window
        scenes.append(together(faces, projectile(results, step, top)).ordered(VIEW))
    seen = [polygons for polygons, _ in scenes if len(polygons)] or [1e3 * window * np.array([[[-1, -0.3], [1, 0.3]]])]
    limits = np.array([[polygons.min(axis=(0, 1)), polygons.max(axis=(0, 1))] for polygons in seen])
    low, high = limits[:, 0].min(axis=0), limits[:, 1].max(axis=0)
    for step, path, (polygons, colours) in zip(frames, paths, scenes):
        save_figure(picture(run, step, polygons, colours, (low, high), norm, field), path, tight=False)


def picture(run, step, polygons, colours, limits, norm, field):
    """The figure of one frame: polygons, colour bar, scale and time."""
    margin = 0.03 * (limits[1] - limits[0])[0]
    low, high = limits[0] - margin * np.array([1.0, 2.5]), limits[1] + margin * np.array([1.0, 2.0])  # room for scale and caption
    size = high - low
    width, bar = 6.2, 0.95
    height = width * size[1] / size[0]
    figure = plt.figure(figsize=(width + bar, height))
    axes = figure.add_axes([0, 0, width / (width + bar), 1])
    axes.add_collection(PolyCollection(polygons, facecolors=colours, edgecolors=colours, linewidths=0.25, rasterized=len(polygons) > 3000))
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.set_axis_off()
    draw_scale(axes, low + margin, high[0] - low[0])
    strip = figure.add_axes([(width + 0.05) / (width + bar), 0.2, 0.13 / (width + bar), 0.6])
    figure.colorbar(ScalarMappable(norm, FIELD), cax=strip).outline.set_linewidth(0.5)
    strip.set_ylabel(shown_as(field).label, labelpad=5)
    strip.tick_params(length=2.5)
    figure.text(0.02, 1 - 0.1 / height, caption(run, step), ha="left", va="top", fontsize=10)
    return figure


def caption(run, step):
    """Time and projectile velocity of the frame."""
    time = run.results.times[step]
    velocity = run.velocity(time)
    if velocity is None:
        return f"{time * 1e6:.3g} µs"
    return f"{time * 1e6:.3g} µs,  projectile at {'−' if round(velocity) < 0 else ''}{abs(velocity):.0f} m/s"


def draw_scale(axes, corner, width):
    """A bar of a round length in the lower left corner of a picture `width` mm wide; lengths across the view are true to it."""
    length = max(step for step in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500) if step <= max(0.17 * width, 0.1))
    x, y = corner
    axes.plot([x, x + length], [y, y], color=INK, lw=1.6, solid_capstyle="butt")
    axes.text(x + length / 2, y + 0.01 * width, f"{length:g} mm", ha="center", va="bottom", fontsize=8.5)
