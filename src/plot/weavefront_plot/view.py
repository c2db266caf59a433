"""Parallel projection, light and order of faces: what a picture of surfaces in space needs."""
from dataclasses import dataclass

import numpy as np


@dataclass
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
        """Coordinates on the picture [..., 2]."""
        right, up, _ = self.axes()
        return np.stack([points @ right, points @ up], axis=-1)

    def depth(self, points):
        """Distance towards the viewer [...]."""
        return points @ self.axes()[2]

    def lit(self, faces, colours, contrast):
        """Colours [f, 3] of faces [f, 4, 3] lit from the upper left, the same on both sides; a horizontal face keeps its colour."""
        right, up, towards = self.axes()
        normals = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        normals *= np.where(normals @ towards < 0, -1.0, 1.0)[:, None]
        lamp = -0.55 * right + 0.55 * up + 0.63 * towards
        change = contrast * (np.clip(normals @ lamp, 0, 1) - lamp[2])[:, None]
        return np.where(change > 0, colours + (1 - colours) * change, colours * (1 + change))


@dataclass
class Faces:
    """Quads in space [f, 4, 3], their colours [f, 3] and how far each is drawn before its true depth [f]."""

    corners: np.ndarray
    colours: np.ndarray
    lift: np.ndarray

    @staticmethod
    def join(groups):
        """All faces of several groups."""
        return Faces(*(np.concatenate([getattr(group, name) for group in groups]) for name in ("corners", "colours", "lift")))

    def split(self, longest):
        """The same with each face divided evenly so that no edge is longer than `longest`: small faces sort by depth more truly."""
        edges = np.linalg.norm(np.roll(self.corners, -1, axis=1) - self.corners, axis=2).max(axis=1, initial=0.0)
        parts = np.maximum(np.ceil(edges / longest), 1).astype(int)
        groups = [self.divided(parts == count, count) for count in np.unique(parts)]
        return Faces.join(groups) if groups else self

    def divided(self, chosen, count):
        """The chosen faces, each as count x count faces."""
        a, b, c, d = (corner[:, None, None] for corner in self.corners[chosen].transpose(1, 0, 2))
        u, v = (t[None, ..., None] for t in np.meshgrid(*2 * [np.linspace(0, 1, count + 1)], indexing="ij"))
        grid = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        corners = np.stack([grid[:, :-1, :-1], grid[:, 1:, :-1], grid[:, 1:, 1:], grid[:, :-1, 1:]], axis=3).reshape(-1, 4, 3)
        return Faces(corners, np.repeat(self.colours[chosen], count**2, axis=0), np.repeat(self.lift[chosen], count**2))

    def near_axis(self, radius):
        """Which faces lie within the horizontal distance `radius` of the axis."""
        return np.hypot(*self.corners.mean(axis=1)[:, :2].T) < radius

    def where(self, chosen):
        """The chosen faces."""
        return Faces(self.corners[chosen], self.colours[chosen], self.lift[chosen])

    def ordered(self, view):
        """Polygons on the picture and their colours, the farthest first."""
        order = np.argsort(view.depth(self.corners.mean(axis=1)) + self.lift, kind="stable")
        return view.project(self.corners[order]), self.colours[order]
