"""study: error against cost of the variants of a study."""
import json
import re

import matplotlib.pyplot as plt
from matplotlib.ticker import LogFormatterSciNotation, LogLocator, NullFormatter

from .failure import FileError, InputError
from .style import BLUE, BROWN, CYAN, FAINT, GREEN, INK, ORANGE, PINK, PURPLE, RED, save_figure

COLOURS = (BLUE, ORANGE, GREEN, RED, PURPLE, BROWN, PINK, CYAN)
MARKERS = "os^Dv<>p"
FLOOR = 1e-16  # errors below, zero among them, are drawn here: it is the rounding of a double


def read_study(folder):
    """study.json of the folder."""
    path = folder / "study.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    except ValueError:
        raise InputError(f"{path}: not JSON") from None


def costs_of(study):
    """Label, key in the table of Pareto fronts, and cost of each variant by its name."""
    rows = study["variants"]
    seconds = {row["variant"]: row["wall_seconds"] * row["ranks"] for row in rows}
    steps = {row["variant"]: row["element_steps"] for row in rows}
    costs = [("Wall seconds x ranks", "core_seconds", seconds), ("Element-steps", "element_steps", steps)]
    if "evaluations" in rows[0]["values"]:
        costs.append(("Evaluations a step", "evaluations", {row["variant"]: row["values"]["evaluations"] for row in rows}))
    return costs


def errors_of(study, name):
    """Error of each finished variant that has one, by its name."""
    rows = (row for row in study["variants"] if row["outcome"] == "finished" and not row["reference_only"])
    return {row["variant"]: max(row["errors"][name], FLOOR) for row in rows if row["errors"][name] is not None}


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
    axes = [axis["name"] for axis in study["axes"] if axis["name"] != study["order_along"]]
    shared = ", ".join(map(value_label, axes, series["labels"])) or "all"
    return shared if series["order"] is None else f"{shared}: order {series['order']:.1f}"


def draw_front(panel, study, quantity, key, costs, errors):
    """Rings around the variants that none with the same reference beats in cost and error at once, joined by steps."""
    fronts = {}
    for row, best in zip(study["variants"], quantity["pareto"][key]):
        if best and row["variant"] in errors:
            fronts.setdefault(row["compared_with"], []).append((costs[row["variant"]], errors[row["variant"]]))
    for i, front in enumerate(fronts.values()):
        x, y = zip(*sorted(front))
        panel.step(x, y, where="post", color=FAINT, lw=0.8, zorder=1)
        panel.plot(x, y, "o", ms=9, mfc="none", mec=INK, mew=0.8, zorder=3, label="_" if i else "Pareto front")


def draw_panel(panel, study, quantity, label, key, costs):
    """One quantity over one cost."""
    errors = errors_of(study, quantity["name"])
    for i, series in enumerate(quantity["series"]):
        names = [name for name in series["variants"] if name in errors]
        line = "none" if study["order_along"] is None else "-"
        panel.plot([costs[name] for name in names], [errors[name] for name in names], color=COLOURS[i % len(COLOURS)], lw=1,
                   ls=line, marker=MARKERS[i // len(COLOURS) % len(MARKERS)], ms=4, label=series_label(study, series))
    draw_front(panel, study, quantity, key, costs, errors)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlabel(label)
    for axis, values in ((panel.xaxis, costs.values()), (panel.yaxis, errors.values())):
        if max(values) < 30 * min(values):  # too short for decades alone
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(LogFormatterSciNotation(labelOnlyBase=False, minor_thresholds=(10, 10)))
            axis.set_minor_formatter(NullFormatter())


def draw_study(folder, path):
    """A row of panels for each quantity that has errors."""
    study = read_study(folder)
    quantities = [quantity for quantity in study["quantities"] if errors_of(study, quantity["name"])]
    if not quantities:
        raise InputError(f"{folder / 'study.json'}: no variant has an error to draw; the study needs a reference")
    costs = costs_of(study)
    figure, axes = plt.subplots(len(quantities), len(costs), figsize=(1 + 4 * len(costs), 0.6 + 2.2 * len(quantities)), squeeze=False, sharey="row",
                                constrained_layout=True)
    for row, quantity in zip(axes, quantities):
        for panel, (label, key, values) in zip(row, costs):
            draw_panel(panel, study, quantity, label, key, values)
        row[0].set_ylabel(f"Error of {quantity['name']}", fontsize=8)
        row[-1].legend(loc="center left", bbox_to_anchor=(1.02, 0.5), fontsize=7)
    figure.suptitle(study["title"], x=0.01, ha="left", fontsize=9.5, color=INK)
    save_figure(figure, path)
