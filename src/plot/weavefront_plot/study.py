"""study: error of the variants of a study against cost, and against element size where that varies."""
import re

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from .failure import InputError
from .study_table import read_study
from .style import BLUE, BROWN, CYAN, FAINT, GREEN, INK, ORANGE, PINK, PURPLE, RED, save_figure
from .text import cleaned, literal

COLOURS = (BLUE, ORANGE, GREEN, RED, PURPLE, BROWN, PINK, CYAN)
MARKERS = "os^Dv<>p"
FLOOR = 1e-16  # errors below, zero among them, are drawn here: it is the rounding of a double
LEAST_COST = 1e-12  # of anything that a cost is counted in
ELEMENT_SIZE = "target.mesh.center"
LINE, PANEL, TALLEST = 0.155, 2.3, 100  # inches: a line of the legend, the lowest panel, all panels
LONGEST, LONGEST_TITLE, LONGEST_NAME = 60, 110, 26  # letters of a label, of the title, of a quantity


def costs_of(study):
    """Label, key in the table of Pareto fronts or None, and value of each variant by its name."""
    costs = [
        (
            "Wall seconds x ranks",
            "core_seconds",
            {variant.name: variant.core_seconds for variant in study.variants},
        ),
        (
            "Element-steps",
            "element_steps",
            {variant.name: variant.element_steps for variant in study.variants},
        ),
    ]
    if all(variant.values.get("evaluations") is not None for variant in study.variants):
        costs.append(
            (
                "Evaluations a step",
                "evaluations",
                {variant.name: variant.values["evaluations"] for variant in study.variants},
            )
        )
    sizes = sizes_of(study)
    if sizes:
        costs.insert(0, ("Element size at the impact, mm", None, sizes))
    return [
        (label, key, {name: max(value, LEAST_COST) for name, value in values.items()})
        for label, key, values in costs
    ]


def sizes_of(study):
    """Element size at the impact in mm of each variant by its name; none where it does not vary."""
    places = [i for i, axis in enumerate(study.axes) if axis.name == ELEMENT_SIZE]
    if not places:
        return {}
    values = study.axes[places[0]].values
    sizes = {variant.name: values.get(variant.labels[places[0]]) for variant in study.variants}
    return {name: 1e3 * size for name, size in sizes.items() if size is not None}


def errors_of(study, name):
    """Error of each finished variant that has one, by its name."""
    compared = (
        variant for variant in study.variants if variant.compared and variant.errors.get(name) is not None
    )
    return {variant.name: max(variant.errors[name], FLOOR) for variant in compared}


def value_label(axis, label):
    """The value of an axis; a bare number says little without the last key of its path."""
    try:
        float(label.removesuffix("%"))
    except ValueError:
        return label.replace(" ", "\u2009")
    name = re.search(r"[^.]*(\.\d+)?$", axis)[0]
    return f"{name} {label}".replace(" ", "\u2009")


def series_label(study, series):
    """What the variants of a series share, and the order that they show."""
    axes = [axis.name for axis in study.axes if axis.name != study.order_along]
    shared = cleaned(", ".join(map(value_label, axes, series.labels)) or "all", LONGEST)
    return shared if series.order is None else f"{shared}: order {series.order:.1f}"


def draw_front(panel, study, quantity, key, costs, errors):
    """Rings around the variants that none with the same reference beats in cost and error at once, joined by
    steps."""
    fronts = {}
    for variant, best in zip(study.variants, quantity.fronts.get(key, ())):
        if best and variant.name in errors:
            fronts.setdefault(variant.compared_with, []).append((costs[variant.name], errors[variant.name]))
    for i, front in enumerate(fronts.values()):
        x, y = zip(*sorted(front))
        panel.step(x, y, where="post", color=FAINT, lw=0.8, zorder=1)
        panel.plot(
            x, y, "o", ms=9, mfc="none", mec=INK, mew=0.8, zorder=3, label="_" if i else "Pareto front"
        )


def draw_panel(panel, study, quantity, label, key, costs):
    """One quantity over one cost."""
    errors = {name: error for name, error in errors_of(study, quantity.name).items() if name in costs}
    for i, series in enumerate(quantity.series):
        names = [name for name in series.variants if name in errors]
        line = "none" if study.order_along is None else "-"
        panel.plot(
            [costs[name] for name in names],
            [errors[name] for name in names],
            color=COLOURS[i % len(COLOURS)],
            lw=1,
            ls=line,
            marker=MARKERS[i // len(COLOURS) % len(MARKERS)],
            ms=4,
            label=series_label(study, series),
        )
    if key is not None:
        draw_front(panel, study, quantity, key, costs, errors)
    panel.set(xlabel=label, xscale="log", yscale="log")
    for axis, values in ((panel.xaxis, [costs[name] for name in errors]), (panel.yaxis, errors.values())):
        scale(axis, min(values, default=1.0), max(values, default=1.0))


def scale(axis, low, high):
    """Labels of a logarithmic axis that have room, also between the powers of ten of a short one."""
    subdivided, powers = high < 30 * low, high > 1e4 * low
    # 1, 2 and 5 times a power of ten may leave less than two labels in such a short range.
    few = high < 2.5 * low
    axis.set_major_locator(
        MaxNLocator(3) if few else LogLocator(subs=(1, 2, 5) if subdivided else (1,), numticks=6)
    )
    axis.set_major_formatter(FuncFormatter(lambda value, _: number(value, powers)))
    axis.set_minor_formatter(NullFormatter())


def number(value, powers):
    """A round number as text: 0.02 or 500, or with a power of ten such as 2×10⁻⁷."""
    if 1e-3 <= value < 1e4 * (1 - 1e-9) and not powers:
        return f"{value:.6g}"
    factor, exponent = f"{value:.2e}".split("e")
    factor = factor.rstrip("0").rstrip(".")
    power = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{power}" if factor == "1" else f"{factor}×10{power}"


def row_height(quantities):
    """Inches in which the longest legend has room."""
    return max(PANEL, LINE * (max(len(quantity.series) for quantity in quantities) + 2))


def figure_of(study, quantities):
    """A row of panels for each quantity."""
    costs, height = costs_of(study), row_height(quantities)
    figure, axes = plt.subplots(
        len(quantities),
        len(costs),
        figsize=(1 + 3.4 * len(costs), 0.6 + height * len(quantities)),
        squeeze=False,
        sharey="row",
        constrained_layout={"w_pad": 0.12, "h_pad": 0.06},
    )
    for row, quantity in zip(axes, quantities):
        for panel, (label, key, values) in zip(row, costs):
            draw_panel(panel, study, quantity, label, key, values)
        row[0].set_ylabel(f"Error of\n{cleaned(quantity.name, LONGEST_NAME)}", fontsize=8).set_parse_math(
            False
        )
        for text in row[-1].legend(loc="center left", bbox_to_anchor=(1.02, 0.5), fontsize=7).get_texts():
            text.set_parse_math(False)
    literal(figure.suptitle("", x=0.01, ha="left", fontsize=9.5, color=INK), study.title, LONGEST_TITLE)
    return figure


def draw_study(folder, path):
    """A row of panels for each quantity that has errors."""
    study = read_study(folder)
    quantities = [quantity for quantity in study.quantities if errors_of(study, quantity.name)]
    if not quantities:
        raise InputError(
            f"{folder / 'study.json'}: no variant has an error to draw; the study needs a reference"
        )
    if len(quantities) * row_height(quantities) > TALLEST:
        series = max(len(quantity.series) for quantity in quantities)
        raise InputError(
            f"{folder / 'study.json'}: {len(quantities)} quantities of {series} series do not fit into one picture"
        )
    save_figure(figure_of(study, quantities), path)
