"""The look that all pictures share, and how they are written."""
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.colors import LinearSegmentedColormap

from .failure import FileError

INK = "#222222"
FAINT = "#8a8a8a"
BLUE, ORANGE, GREEN, RED = "#2a6fb0", "#d9730d", "#2f8f5b", "#b3312c"
PURPLE, BROWN, PINK, CYAN = "#7b57a8", "#8a5a3c", "#c65b9b", "#12b5cb"


def colours(name, low, high):
    """The part of a named colour map between the fractions `low` and `high`."""
    source = matplotlib.colormaps[name]
    return LinearSegmentedColormap.from_list(f"{name}_part", [source(low + (high - low) * i / 255) for i in range(256)])


FIELD = colours("magma_r", 0.0, 0.92)
PLIES = colours("viridis", 0.0, 0.9)


def apply():
    """Sets matplotlib's defaults."""
    plt.rcParams.update({
        "font.family": "sans-serif", "font.size": 9, "axes.labelsize": 9, "axes.titlesize": 9.5, "legend.fontsize": 8.5,
        "xtick.labelsize": 8.5, "ytick.labelsize": 8.5, "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK,
        "xtick.color": INK, "ytick.color": INK, "axes.linewidth": 0.7, "xtick.major.width": 0.7, "ytick.major.width": 0.7,
        "xtick.direction": "in", "ytick.direction": "in", "axes.spines.top": False, "axes.spines.right": False,
        "lines.linewidth": 1.5, "lines.solid_capstyle": "round", "legend.frameon": False, "figure.facecolor": "white",
        "savefig.facecolor": "white", "svg.fonttype": "none", "pdf.fonttype": 42, "svg.hashsalt": "weavefront",
    })


def write(path, save):
    """Calls save(temporary path) and renames its result to `path`, so that no half-written file is ever seen."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        save(temporary)
        os.replace(temporary, path)
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    finally:
        temporary.unlink(missing_ok=True)
    print(path)


def save_figure(figure, path, tight=True):
    """Writes the figure in the format that the name's ending says, and closes it."""
    box = {"bbox_inches": "tight", "pad_inches": 0.06} if tight else {}
    write(path, lambda temporary: figure.savefig(temporary, format=path.suffix[1:], dpi=220, **box))
    plt.close(figure)
