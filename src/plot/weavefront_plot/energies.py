"""energies: the ledger over time, and the closure error."""
import matplotlib.pyplot as plt
import numpy as np

from .style import BLUE, BROWN, FAINT, GREEN, INK, ORANGE, PINK, PURPLE, RED, save_figure
from .text import literal

LEDGER = (
    ("kinetic_projectile", "Kinetic, projectile", BLUE),
    ("kinetic_fabric", "Kinetic, fabric", ORANGE),
    ("internal", "Internal", GREEN),
    ("contact", "Contact", PURPLE),
    ("hourglass", "Hourglass", RED),
    ("friction", "Friction", BROWN),
    ("contact_friction", "Friction of contact", "#8a6d3b"),
    ("damping", "Damping", PINK),
    ("external", "External work", FAINT),
    ("eroded", "Hourglass, let go with broken\nyarns and eroded elements", "#4d9a9a"),
)
FLOOR, CEILING = 1e-3, 1e6  # percent; smaller shares are not worth a decade of the picture
LONGEST = 90  # letters of a title


def draw_energies(run, path):
    """Energies in J above; shares of the initial energy below, logarithmic, with the closure error."""
    rows = run.history
    time = rows["time"] * 1e6
    entries = [
        (rows[name], label, colour) for name, label, colour in LEDGER if name in rows and np.any(rows[name])
    ]
    initial = max(rows["kinetic_projectile"][0] + rows["kinetic_fabric"][0] + rows["internal"][0], 1e-100)
    figure, (energy, share) = plt.subplots(
        2, 1, figsize=(6.6, 5.2), sharex=True, gridspec_kw={"height_ratios": [2, 1], "hspace": 0.1}
    )
    for values, label, colour in entries:
        small = np.abs(values).max() < 0.1 * initial
        energy.plot(time, values, color=colour, label=label, lw=1.0 if small else 1.6)
        if small:
            share.semilogy(time, percent(values / initial), color=colour, lw=1.1)
    share.semilogy(time, percent(rows["energy_error"]), color=INK, lw=1.2)
    energy.plot(
        [],
        [],
        color=INK,
        lw=1.2,
        label=f"Closure error,\nat most {100 * np.abs(rows['energy_error']).max():.2g} %",
    )
    if min((values.min() for values, _, _ in entries), default=0) >= 0:
        energy.set_ylim(bottom=0)
    energy.set_ylabel("Energy, J")
    share.set_ylabel("Share of the\ninitial energy, %")
    share.set_ylim(FLOOR, 20)
    share.set_yticks([1e-3, 1e-2, 0.1, 1, 10], ["0.001", "0.01", "0.1", "1", "10"])
    share.minorticks_off()
    share.axhline(1, color=FAINT, lw=0.6, ls=(0, (4, 4)), zorder=0)
    share.set_xlabel("Time, µs")
    share.set_xlim(time[0], time[-1] if time[-1] > time[0] else time[0] + 1)
    energy.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0, handlelength=1.6)
    figure.align_ylabels([energy, share])
    literal(energy.set_title("", loc="left"), run.title, LONGEST)
    save_figure(figure, path)


def percent(share):
    """Absolute values in percent; those under the floor are drawn on it."""
    return np.clip(100 * np.abs(share), FLOOR, CEILING)
