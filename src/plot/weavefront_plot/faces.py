"""Coloured faces in space, and the picture of them in which the nearer ones hide the others."""
from dataclasses import dataclass

import numpy as np

from .raster import Raster

FINER = 2  # pixels of the raster along one of the picture, for smooth edges


@dataclass
class Faces:
    """Quads in space [f, 4, 3], their colours [f, 3] and whether the open quarter cuts into them [f]."""

    corners: np.ndarray
    colours: np.ndarray
    cut: np.ndarray

    @staticmethod
    def whole(corners, colours):
        """Faces that no quarter cuts into."""
        return Faces(corners, colours, np.zeros(len(corners), dtype=bool))

    @staticmethod
    def join(groups):
        """All faces of several groups."""
        return Faces(
            *(
                np.concatenate([getattr(group, name) for group in groups])
                for name in ("corners", "colours", "cut")
            )
        )


@dataclass(frozen=True)
class Frame:
    """The part of the picture's plane that is drawn, and its size in pixels."""

    low: np.ndarray
    high: np.ndarray
    width: int
    height: int


def image(faces, view, frame, opening):
    """Colours [height, width, 3] of the faces in parallel projection, white where there is none."""
    pixel = FINER * frame.width / (frame.high - frame.low)[0]
    seen = view.project(faces.corners)
    column, row = (seen[..., 0] - frame.low[0]) * pixel - 0.5, (frame.high[1] - seen[..., 1]) * pixel - 0.5
    seen = np.stack([column, row, seen[..., 2] * pixel], axis=-1)
    raster = Raster(FINER * frame.width, FINER * frame.height)
    axes = np.array(view.axes())

    def kept(x, y, depth):
        """Which pixels lie outside the open quarter."""
        right, up = (x + 0.5) / pixel + frame.low[0], frame.high[1] - (y + 0.5) / pixel
        return ~opening.holds(np.stack([right, up, depth / pixel], axis=-1) @ axes[:, :2])

    for chosen, test in ((~faces.cut, None), (faces.cut, kept)):
        numbers = np.flatnonzero(chosen)
        if len(numbers):
            halves = np.concatenate([seen[numbers][:, [0, 1, 2]], seen[numbers][:, [0, 2, 3]]])
            raster.draw(halves, np.tile(numbers, 2), test)
    colours = np.concatenate([faces.colours, [[1.0, 1.0, 1.0]]])[raster.face]
    return np.clip(colours.reshape(frame.height, FINER, frame.width, FINER, 3).mean(axis=(1, 3)), 0, 1)
