"""Stress over strain of one yarn at several rates, from `weavefront yarn` (figure 10 of Ivanov and Tabiei
2004)."""
import matplotlib.pyplot as plt
import numpy as np

from .failure import InputError
from .style import INK, colours, save_figure
from .tables import read_columns

MARKERS = {19: ("o", "primary bonds fail (19)"), 20: ("s", "secondary bonds fail (20)")}
MOST = 60  # rates


def marker(failure, colour):
    """The marker that ends a curve: filled for primary, open for secondary bonds."""
    return {
        "ls": "",
        "marker": MARKERS[failure][0],
        "ms": 5.5,
        "mfc": "white" if failure == 20 else colour,
        "mec": colour,
        "mew": 1.3,
    }


def draw_yarn(source, path):
    """One curve per rate, ended by the marker of the failure that was met."""
    rows = read_columns(source, ("rate", "strain", "stress", "failure"))
    unknown = set(np.unique(rows["failure"])) - {0, *MARKERS}
    if unknown:
        raise InputError(f"{source}: failure {min(unknown):g} is none of 0, 19, 20")
    rates = np.unique(rows["rate"])
    if len(rates) > MOST:
        raise InputError(f"{source}: {len(rates)} rates; one picture has room for {MOST}")
    shades = colours("viridis", 0.0, 0.88)
    figure, axes = plt.subplots(figsize=(5.4, 4.1))
    met = set()
    for i, rate in enumerate(rates):
        chosen = rows["rate"] == rate
        strain, stress = 100 * rows["strain"][chosen], 1e-9 * rows["stress"][chosen]
        colour = shades(i / max(len(rates) - 1, 1))
        axes.plot(strain, stress, color=colour, lw=1.4, label=f"{rate:g}")
        failure = int(rows["failure"][chosen].max())
        if failure in MARKERS:
            met.add(failure)
            axes.plot(strain[-1], stress[-1], zorder=3, **marker(failure, colour))
    axes.set(xlabel="Strain, %", ylabel="Stress, GPa")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    rate_legend = axes.legend(
        title="Strain rate, 1/s",
        loc="upper left",
        bbox_to_anchor=(1.02, 1.0),
        borderaxespad=0,
        handlelength=1.6,
    )
    rate_legend.get_title().set_fontsize(8.5)
    axes.add_artist(rate_legend)
    ends = [plt.Line2D([], [], label=MARKERS[failure][1], **marker(failure, INK)) for failure in sorted(met)]
    if ends:
        axes.legend(handles=ends, loc="upper left", handletextpad=0.2)
    save_figure(figure, path)
