"""The look that all pictures share, and how they are written."""
import io
import warnings

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.colors import LinearSegmentedColormap

from .picture_file import write

DPI = 220  # of pictures that are made of pixels
INK = "#222222"
FAINT = "#8a8a8a"
BLUE, ORANGE, GREEN, RED = "#2a6fb0", "#d9730d", "#2f8f5b", "#b3312c"
PURPLE, BROWN, PINK, CYAN = "#7b57a8", "#8a5a3c", "#c65b9b", "#12b5cb"


def colours(name, low, high):
    """The part of a named colour map between the fractions `low` and `high`."""
    source = matplotlib.colormaps[name]
    return LinearSegmentedColormap.from_list(
        f"{name}_part", [source(low + (high - low) * i / 255) for i in range(256)]
    )


FIELD = colours("magma_r", 0.0, 0.92)
PLIES = colours("viridis", 0.0, 0.9)


def apply():
    """Sets matplotlib's defaults, whatever the user's own are."""
    matplotlib.rcdefaults()
    warnings.filterwarnings(
        "ignore", message="Glyph .* missing"
    )  # a title in letters that the font has not got
    plt.rcParams.update(
        {
            "font.family": "sans-serif",
            "font.size": 9,
            "axes.labelsize": 9,
            "axes.titlesize": 9.5,
            "legend.fontsize": 8.5,
            "xtick.labelsize": 8.5,
            "ytick.labelsize": 8.5,
            "axes.edgecolor": INK,
            "axes.labelcolor": INK,
            "text.color": INK,
            "xtick.color": INK,
            "ytick.color": INK,
            "axes.linewidth": 0.7,
            "xtick.major.width": 0.7,
            "ytick.major.width": 0.7,
            "xtick.direction": "in",
            "ytick.direction": "in",
            "axes.spines.top": False,
            "axes.spines.right": False,
            "lines.linewidth": 1.5,
            "lines.solid_capstyle": "round",
            "legend.frameon": False,
            "figure.facecolor": "white",
            "savefig.facecolor": "white",
            "svg.fonttype": "none",
            "pdf.fonttype": 42,
            "svg.hashsalt": "weavefront",
        }
    )


def save_figure(figure, path, tight=True):
    """Writes the figure in the format that the name's ending says, and closes it."""
    box = {"bbox_inches": "tight", "pad_inches": 0.06} if tight else {}
    picture = io.BytesIO()  # matplotlib's writers do not all survive a full disk
    figure.savefig(picture, format=path.suffix[1:], dpi=DPI, **box)
    plt.close(figure)
    write(path, lambda temporary: temporary.write_bytes(picture.getbuffer()))
