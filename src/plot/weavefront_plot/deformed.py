"""deformed_<time>: the plies in space with one quarter taken out, coloured by a cell array (figures 12 to
14)."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from .failure import InputError
from .faces import Frame, image
from .opening import facing_quarter
from .quantity import shown_as
from .space import Space
from .style import DPI, FIELD, INK, save_figure
from .text import literal
from .view import View

WIDTH, BAR = 6.2, 0.95  # inches of the picture and of the colour bar beside it
LOWEST, HIGHEST = 0.34, 1.5  # height of the picture over its width
FROM_ZERO = ("stress", "strain", "stress_fill", "stress_warp")
OWN_RANGE = ("braid_angle", "crimp_height")  # far from zero, with little change


class Deformed:
    """Pictures of several frames, all in the same scale and colours."""

    def __init__(self, run, fabric, frames, look, dpi=DPI):
        self.run, self.view, self.dpi = run, View(*look.view), dpi
        self.field = look.field or run.results.default_field()
        self.opening = facing_quarter(run.impact, self.view)
        window = look.window or fabric.window(run.impact, frames)
        self.space = Space(run, fabric, window, self.view, self.opening, look.debris)
        self.norm = self._colour_range(fabric, frames)
        self.frame = self._frame(frames, 1e3 * window)
        self.space.draw_with((self.frame.high - self.frame.low)[0] / self.frame.width)

    def _values(self, step):
        return self.run.results.field(self.field, step) * shown_as(self.field).factor

    def _colour_range(self, fabric, frames):
        """One range for all frames, from zero where the values allow it."""
        low = high = 0.0
        least = np.inf
        for step in frames:
            values = self._values(step)[fabric.joined(step)]
            low, high, least = (
                min(low, values.min(initial=0.0)),
                max(high, values.max(initial=0.0)),
                min(least, values.min(initial=np.inf)),
            )
        if self.field in FROM_ZERO:
            low = 0.0
        elif low >= 0 and self.field in OWN_RANGE and np.isfinite(least):
            low = least
        return Normalize(low, high if high > low else low + 1.0, clip=True)

    def _frame(self, frames, window):
        """Holds what all frames show, with room for the scale below and the caption above."""
        extents = [extent for extent in map(self.space.extent, frames) if extent is not None]
        if not extents:
            raise InputError(
                f"{self.run.results.path}: no fabric within {window:g} mm of the impact in these frames"
            )
        low, high = np.min([e[0] for e in extents], axis=0), np.max([e[1] for e in extents], axis=0)
        margin = 0.03 * max((high - low)[0], (high - low)[1] / HIGHEST, 1e-6)
        low, high = low - margin * np.array([1.0, 2.5]), high + margin * np.array([1.0, 2.0])
        size = high - low
        wanted = np.array([max(size[0], size[1] / HIGHEST), max(size[1], LOWEST * size[0])])
        low, high = low - (wanted - size) / 2, high + (wanted - size) / 2
        width = round(WIDTH * self.dpi)
        height = int(np.ceil(width * wanted[1] / wanted[0]))
        return Frame(np.array([low[0], high[1] - height / width * wanted[0]]), high, width, height)

    def image(self, step):
        """The colours [height, width, 3] of one frame."""
        return image(
            self.space.faces(step, self._values(step), self.norm), self.view, self.frame, self.opening
        )

    def figure(self, step):
        """Picture, colour bar, scale and caption of one frame; with it the two artists that change."""
        width, height = WIDTH + BAR, self.frame.height / self.dpi
        figure = plt.figure(figsize=(width, height), dpi=self.dpi)
        axes = figure.add_axes([0, 0, WIDTH / width, 1])
        (left, bottom), (right, top) = self.frame.low, self.frame.high
        shown = axes.imshow(self.image(step), extent=(left, right, bottom, top), interpolation="none")
        axes.set_axis_off()
        draw_scale(axes, self.frame.low, right - left)
        strip = figure.add_axes([(WIDTH + 0.05) / width, 0.2, 0.13 / width, 0.6])
        figure.colorbar(ScalarMappable(self.norm, FIELD), cax=strip).outline.set_linewidth(0.5)
        strip.set_ylabel("", labelpad=5)
        literal(strip.yaxis.label, shown_as(self.field).label, 40)
        strip.tick_params(length=2.5)
        caption = figure.text(
            0.02, 1 - 0.1 / height, self.run.caption(step), ha="left", va="top", fontsize=10
        )
        return figure, shown, caption


def draw_deformed(run, fabric, frames, look, path_of):
    """One picture for each frame, in the file that `path_of` says."""
    pictures = Deformed(run, fabric, frames, look)
    for step in frames:
        save_figure(pictures.figure(step)[0], path_of(step), tight=False)


def draw_scale(axes, corner, width):
    """A bar of a round length above the lower left `corner` of a picture `width` mm wide.

    Lengths across the view are true to it.
    """
    length = 10.0 ** np.floor(np.log10(0.17 * width))
    length *= max(factor for factor in (1, 2, 5) if factor * length <= 0.17 * width * (1 + 1e-9))
    x, y = corner + 0.028 * width
    axes.plot([x, x + length], [y, y], color=INK, lw=1.6, solid_capstyle="butt")
    axes.text(x + length / 2, y + 0.01 * width, f"{length:g} mm", ha="center", va="bottom", fontsize=8.5)
