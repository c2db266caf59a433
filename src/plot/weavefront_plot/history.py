"""history: projectile, back-face deflection, contact force and broken yarns over time."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from .failure import InputError
from .run import signed
from .style import BLUE, FAINT, GREEN, INK, ORANGE, PURPLE, RED, save_figure
from .tables import read_columns
from .text import literal

LONGEST = 70  # letters of a title
MOST_NAMED = 4  # projectiles in the legend


def read_measured(path):
    """Measured points: `time` and at least one of `displacement`, `velocity`, in SI."""
    columns = read_columns(path, ("time",), ("displacement", "velocity"))
    if not {"displacement", "velocity"} & set(columns):
        raise InputError(f"{path}: neither a column 'displacement' nor 'velocity'")
    return columns


def draw_history(run, path, measured=None):
    """Panels over time in microseconds; that of the force only where the history has it."""
    rows = run.history
    time = rows["time"] * 1e6
    force = contact_force(rows) if run.has_projectile else None
    ratios = [3, 3, 1.1] if force is None else [3, 3, 1.8, 1.1]
    figure, axes = plt.subplots(
        len(ratios),
        1,
        figsize=(5.2, 0.78 * sum(ratios)),
        sharex=True,
        gridspec_kw={"height_ratios": ratios, "hspace": 0.12},
    )
    draw_displacement(axes[0], run, time, measured)
    draw_velocity(axes[1], run, time, measured)
    if force is not None:
        axes[2].plot(time, force * 1e-3, color=PURPLE, lw=1.0)
        axes[2].set_ylabel(
            "Contact force\non the first, kN" if run.further_velocities else "Contact\nforce, kN"
        )
        axes[2].set_ylim(bottom=0)
    draw_broken(axes[-1], time, rows["broken_yarns"])
    axes[-1].set_xlabel("Time, µs")
    axes[-1].set_xlim(time[0], time[-1] if time[-1] > time[0] else time[0] + 1)
    figure.align_ylabels(axes)
    literal(axes[0].set_title("", loc="left"), run.title, LONGEST)
    save_figure(figure, path)


def contact_force(rows):
    """Magnitude of the force of the fabric on the projectile in N, or None where the history has none."""
    components = [rows[name] for name in ("contact_fx", "contact_fy", "contact_fz") if name in rows]
    return np.linalg.norm(components, axis=0) if len(components) == 3 else None


def draw_displacement(panel, run, time, measured):
    """The way of the nose along z and the deflection of the last ply."""
    rows = run.history
    displacement = (rows["projectile_z"] - rows["projectile_z"][0]) * 1e3
    farthest = int(np.argmax(displacement))
    turns = run.has_projectile and rows["projectile_vz"].min() < 0
    reached = f", farthest {displacement[farthest]:.3g} mm at {time[farthest]:.0f} µs" if turns else ""
    panel.plot(
        time,
        displacement,
        color=BLUE,
        label=f"nose of the {run.name_of_first}{reached}" if run.has_projectile else "no projectile",
    )
    if "back_face_deflection" in rows:
        deflection = rows["back_face_deflection"] * 1e3
        panel.plot(
            time,
            deflection,
            color=GREEN,
            lw=1.2,
            label=f"back face of the target, at most {deflection.max():.3g} mm",
        )
    panel.set_ylabel("Displacement\nalong z, mm")
    overlay(panel, measured, "displacement", 1e3)
    panel.legend(loc="best", fontsize=8)


def draw_velocity(panel, run, time, measured):
    """The projectile's velocity along z, and its speed where the shot is oblique."""
    velocity = run.history["projectile_vz"]
    first = "projectile 1: " if run.further_velocities else ""
    panel.plot(time, velocity, color=ORANGE, label=f"{first}vz, last {signed(velocity[-1])} m/s")
    for number, further in enumerate(run.further_velocities, start=2):
        label = f"projectile {number}: vz, last {signed(further[-1])} m/s" if number <= MOST_NAMED else None
        panel.plot(time, further, color=ORANGE, lw=1.0, alpha=0.55, label=label)
        velocity = np.minimum(velocity, further)
    panel.set_ylabel("Velocity vz of the\nprojectile, m/s")
    if run.speed is not None:
        panel.plot(time, run.speed, color=INK, lw=1.0, label=f"speed, last {signed(run.speed[-1])} m/s")
        panel.set_ylabel("Velocity of the\nprojectile, m/s")
    overlay(panel, measured, "velocity", 1.0)
    panel.legend(loc="best", fontsize=8)
    if velocity.min() < 0:
        panel.axhline(0, color=FAINT, lw=0.6, zorder=0)
    elif run.has_projectile:
        panel.set_ylim(bottom=0)


def overlay(panel, measured, name, factor):
    """Measured points, where there are some of this kind."""
    if measured is not None and name in measured:
        panel.plot(
            measured["time"] * 1e6,
            measured[name] * factor,
            "o",
            ms=4.2,
            mfc="white",
            mec=INK,
            mew=0.9,
            label="measured",
        )


def draw_broken(panel, time, broken):
    """How many yarns are broken."""
    if np.any(broken):
        panel.fill_between(time, broken, step="post", color=RED, alpha=0.25, lw=0)
        panel.step(time, broken, where="post", color=RED, lw=1.1)
        panel.yaxis.set_major_locator(MaxNLocator(3, integer=True))
        panel.set_ylim(bottom=0)
    else:
        panel.text(0.5, 0.5, "none", transform=panel.transAxes, ha="center", va="center", color=FAINT)
        panel.set_yticks([])
    panel.set_ylabel("Broken\nyarns")
