"""v50: S-curve with its band and shots, residual velocity and absorbed energy over striking velocity."""
import math

import matplotlib.pyplot as plt
import numpy as np

from .picture_file import check_place
from .style import BLUE, FAINT, GREEN, INK, ORANGE, RED, save_figure
from .text import cleaned, literal
from .v50_table import read_v50

LONGEST = 90  # letters of a title
MARGIN = 0.06  # of the range of speeds, on both sides of the shots
POINTS = 400  # of a curve
NAMES = ("response", "residual", "energy")
LEVELS = {"complete": 1.0, "partial": 0.0, "none": 0.5}
SPREAD = 0.025  # between shots of one result that lie over each other


def draw_v50(folder, path, make_folder):
    """The three pictures. `path`: place of a picture by its name."""
    v50 = read_v50(folder)
    make_folder()
    for name in NAMES:
        check_place(path(name))
    for name, figure_of in zip(NAMES, (response_figure, residual_figure, energy_figure)):
        save_figure(figure_of(v50), path(name))


def window_of(v50):
    """The speeds that the pictures show, in the unit of the results."""
    speeds = [shot.speed / v50.si for shot in v50.shots]
    width = max(max(speeds) - min(speeds), 0.02 * max(speeds))
    return max(0.0, min(speeds) - MARGIN * width), max(speeds) + MARGIN * width


def new_figure(v50, label):
    """Axes over the striking velocity."""
    figure, axes = plt.subplots(figsize=(5.2, 4.0))
    axes.set(xlabel=f"Striking velocity, {v50.unit}", ylabel=label, xlim=window_of(v50))
    literal(axes.set_title("", loc="left"), v50.title, LONGEST)
    return figure, axes


def draw_bracket(axes, v50):
    """The zone of mixed results, or else the bracket of the limit."""
    low, high, name = (*v50.mixed, "mixed results") if v50.mixed else (v50.low, v50.high, "bracket")
    if low is None or high is None:
        return
    low, high = low / v50.si, high / v50.si
    label = f"{name}, {low:.1f} to {high:.1f} {cleaned(v50.unit, 12)}"
    axes.axvspan(low, high, color=FAINT, alpha=0.35, lw=0, zorder=0, label=label)


def draw_points(axes, v50, chosen, value, **look):
    """Shots that `chosen` takes."""
    shots = [shot for shot in v50.shots if chosen(shot)]
    axes.plot(
        [shot.speed / v50.si for shot in shots], [value(shot) for shot in shots], ls="", clip_on=False, **look
    )


def legend(axes):
    """Beside the axes. Words of a file are drawn as they stand."""
    place = {"loc": "upper left", "bbox_to_anchor": (1.02, 1.0), "borderaxespad": 0, "handlelength": 1.8}
    for text in axes.legend(**place).get_texts():
        text.set_parse_math(False)


def piled(v50):
    """Height of each shot in the S-curve: shots at the same place lie over each other."""
    left, right = window_of(v50)
    taken, heights = {}, {}
    for i, shot in enumerate(v50.shots):
        place = shot.result, round(100 * (shot.speed / v50.si - left) / (right - left))
        step = taken.get(place, 0)
        taken[place] = step + 1
        heights[i] = LEVELS[shot.result] + (-SPREAD if shot.result == "complete" else SPREAD) * step
    return heights


def draw_band(axes, v50, curve):
    """The interval of the speed of each probability; open ends reach the edge of the picture."""
    left, right = window_of(v50)
    probabilities = [quantile[0] for quantile in curve.quantiles]
    lower = [left if quantile[2] is None else quantile[2] / v50.si for quantile in curve.quantiles]
    upper = [right if quantile[3] is None else quantile[3] / v50.si for quantile in curve.quantiles]
    axes.fill_betweenx(
        probabilities,
        lower,
        upper,
        color=BLUE,
        alpha=0.18,
        lw=0,
        label=f"{100 * v50.confidence:g} % interval",
    )


def response_figure(v50):
    """Probability of a complete penetration with the shots; without a fit the shots and the bracket."""
    figure, axes = new_figure(v50, "Probability of a complete penetration")
    if v50.normal is None:
        draw_bracket(axes, v50)
    else:
        draw_band(axes, v50, v50.normal)
        for curve, label, colour, style in (
            (v50.normal, "normal", BLUE, "-"),
            (v50.logistic, "logistic", GREEN, (0, (4, 3))),
        ):
            if curve is None:
                continue
            axes.plot(
                [quantile[1] / v50.si for quantile in curve.quantiles],
                [quantile[0] for quantile in curve.quantiles],
                color=colour,
                ls=style,
                label=f"{label}, V50 {curve.v50 / v50.si:.1f} {cleaned(v50.unit, 12)}",
            )
    if v50.mean is not None:
        label = f"MIL-STD-662F, {v50.mean / v50.si:.1f} {cleaned(v50.unit, 12)}"
        axes.axvline(v50.mean / v50.si, color=ORANGE, lw=1.1, label=label)
    heights = piled(v50)
    for of_range, fill, words in ((False, INK, "computed shots"), (True, "white", "shots of the range")):
        chosen = [
            i for i, shot in enumerate(v50.shots) if shot.of_range == of_range and shot.result != "none"
        ]
        if chosen:
            axes.plot(
                [v50.shots[i].speed / v50.si for i in chosen],
                [heights[i] for i in chosen],
                ls="",
                marker="o",
                ms=5,
                mfc=fill,
                mec=INK,
                clip_on=False,
                label=words,
                zorder=3,
            )
    chosen = [i for i, shot in enumerate(v50.shots) if shot.result == "none"]
    if chosen:
        speeds = [v50.shots[i].speed / v50.si for i in chosen]
        axes.plot(speeds, [heights[i] for i in chosen], ls="", marker="x", color=RED, label="no result")
    axes.set_ylim(-0.02, 1.02)
    legend(axes)
    return figure


def residual_figure(v50):
    """Residual velocity; partial penetrations lie on zero."""
    figure, axes = new_figure(v50, f"Residual velocity, {v50.unit}")
    draw_bracket(axes, v50)
    left, right = window_of(v50)
    for curve, label, colour, style in (
        (v50.recht_ipson, "Recht-Ipson", BLUE, "-"),
        (v50.lambert_jonas, "Lambert-Jonas", ORANGE, (0, (4, 3))),
    ):
        if curve is None:
            continue
        # The curves rise steeply from their limit velocity.
        speeds = np.unique(
            np.append(np.linspace(left, right, POINTS), curve.v50 / v50.si * (1 + np.logspace(-9, -1, 60)))
        )
        speeds = speeds[(speeds >= max(left, curve.v50 / v50.si)) & (speeds <= right)]
        words = f"{label}, V50 {curve.v50 / v50.si:.1f} {cleaned(v50.unit, 12)}"
        if not math.isclose(curve.p, 2) or not math.isclose(curve.a, 1):
            words += f",\na = {curve.a:.3f}, p = {curve.p:.2f}"
        values = [curve.residual(speed * v50.si) / v50.si for speed in speeds]
        axes.plot(speeds, values, color=colour, ls=style, label=words)
    draw_points(
        axes,
        v50,
        lambda shot: shot.result == "complete" and shot.residual is not None,
        lambda shot: shot.residual / v50.si,
        marker="o",
        ms=5,
        color=INK,
        zorder=3,
        label="complete penetrations",
    )
    draw_points(
        axes,
        v50,
        lambda shot: shot.result == "partial" and not shot.of_range,
        lambda shot: 0.0,
        marker="o",
        ms=5,
        mfc="white",
        mec=INK,
        zorder=3,
        label="partial penetrations",
    )
    # A projectile that has passed all plies may be held by their flaps.
    lowest = min(
        (shot.residual for shot in v50.shots if shot.result == "complete" and shot.residual is not None),
        default=0,
    )
    axes.set_ylim(bottom=min(0, 1.2 * lowest / v50.si))
    legend(axes)
    return figure


def energy_figure(v50):
    """Energy that the projectile has lost, below the energy that it came with."""
    figure, axes = new_figure(v50, "Energy, J")
    draw_bracket(axes, v50)
    speeds = np.linspace(*window_of(v50), POINTS)
    axes.plot(speeds, 0.5 * v50.mass * (speeds * v50.si) ** 2, color=FAINT, label="striking energy")
    for result, fill, words in (
        ("complete", INK, "complete penetrations"),
        ("partial", "white", "partial penetrations"),
    ):
        draw_points(
            axes,
            v50,
            lambda shot: shot.result == result and shot.absorbed_energy is not None,
            lambda shot: shot.absorbed_energy,
            marker="o",
            ms=5,
            mfc=fill,
            mec=INK,
            zorder=3,
            label=f"absorbed, {words}",
        )
    axes.set_ylim(bottom=0)
    legend(axes)
    return figure
