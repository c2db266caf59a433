"""Parallel projection and light: what a picture of surfaces in space needs."""
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class View:
    """Seen from the horizontal `azimuth` and from `elevation` above the plane, both in degrees."""

    azimuth: float
    elevation: float

    def axes(self):
        """Unit vectors to the right, upwards and towards the viewer."""
        a, e = np.radians([self.azimuth, self.elevation])
        towards = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        return right, np.cross(towards, right), towards

    def project(self, points):
        """Coordinates to the right, upwards and towards the viewer [..., 3]."""
        return points @ np.array(self.axes()).T

    def lit(self, faces, colours, contrast):
        """Colours [f, 3] of faces [f, 4, 3] lit from the left on both sides; a horizontal one keeps its
        colour."""
        right, up, towards = self.axes()
        normals = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        normals *= np.where(normals @ towards < 0, -1.0, 1.0)[:, None]
        side = 1 if towards[2] >= 0 else -1  # the lamp is on the viewer's side of the target
        lamp = -0.55 * right + side * 0.55 * up + 0.63 * towards
        change = contrast * (np.clip(normals @ lamp, 0, 1) - side * lamp[2])[:, None]
        return np.where(change > 0, colours + (1 - colours) * change, colours * (1 + change))
