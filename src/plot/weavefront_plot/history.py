"""history: displacement of the projectile's nose, its velocity, and the broken yarns."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from .failure import InputError
from .style import BLUE, FAINT, INK, ORANGE, RED, save_figure
from .tables import read_columns


def read_measured(path):
    """Measured points: `time` and at least one of `displacement`, `velocity`, in SI."""
    columns = read_columns(path, ("time",))
    if not {"displacement", "velocity"} & set(columns):
        raise InputError(f"{path}: neither a column 'displacement' nor 'velocity'")
    return columns


def draw_history(run, path, measured=None):
    """Three panels over time in microseconds."""
    rows = run.history
    time = rows["time"] * 1e6
    broken = rows["broken_yarns"]
    figure, axes = plt.subplots(3, 1, figsize=(5.2, 5.6), sharex=True, gridspec_kw={"height_ratios": [3, 3, 1.1], "hspace": 0.12})
    axes[0].plot(time, (rows["projectile_z"] - rows["projectile_z"][0]) * 1e3, color=BLUE, label="computed")
    axes[1].plot(time, rows["projectile_vz"], color=ORANGE, label="computed")
    axes[0].set_ylabel("Displacement\nof the nose, mm")
    axes[1].set_ylabel("Velocity of the\nprojectile, m/s")
    for panel, name, factor in ((axes[0], "displacement", 1e3), (axes[1], "velocity", 1.0)):
        if measured is not None and name in measured:
            panel.plot(measured["time"] * 1e6, measured[name] * factor, "o", ms=4.2, mfc="white", mec=INK, mew=0.9, label="measured")
            panel.legend(loc="best")
    if run.has_projectile:
        mark_outcome(axes, time, rows)
    else:
        axes[0].text(0.5, 0.6, "no projectile", transform=axes[0].transAxes, ha="center", color=FAINT)
    if np.any(broken):
        axes[2].fill_between(time, broken, step="post", color=RED, alpha=0.25, lw=0)
        axes[2].step(time, broken, where="post", color=RED, lw=1.1)
        axes[2].yaxis.set_major_locator(MaxNLocator(3, integer=True))
        axes[2].set_ylim(bottom=0)
    else:
        axes[2].text(0.5, 0.5, "none", transform=axes[2].transAxes, ha="center", va="center", color=FAINT)
        axes[2].set_yticks([])
    axes[2].set_ylabel("Broken\nyarns")
    axes[2].set_xlabel("Time, µs")
    axes[2].set_xlim(time[0], time[-1] if time[-1] > time[0] else time[0] + 1)
    figure.align_ylabels(axes)
    axes[0].set_title(run.title, loc="left", color=INK)
    save_figure(figure, path)


def mark_outcome(axes, time, rows):
    """The largest displacement of the nose when the projectile turns back, else its last velocity."""
    displacement, velocity = (rows["projectile_z"] - rows["projectile_z"][0]) * 1e3, rows["projectile_vz"]
    if velocity.min() < 0:
        axes[1].axhline(0, color=FAINT, lw=0.6, zorder=0)
        i = int(np.argmax(displacement))
        axes[0].text(0.98, 0.06, f"largest: {displacement[i]:.1f} mm at {time[i]:.0f} µs", transform=axes[0].transAxes, ha="right",
                     fontsize=8.5)
    else:
        axes[1].set_ylim(bottom=0)
        axes[1].text(0.98, 0.94, f"last: {velocity[-1]:.0f} m/s", transform=axes[1].transAxes, ha="right", va="top", fontsize=8.5)
