"""Where the shot meets the target: pictures cut, measure and leave out there."""
from dataclasses import dataclass

import numpy as np

OBLIQUE = 0.01  # of the speed, from which the horizontal part of the velocity counts


@dataclass(frozen=True)
class Impact:
    """The point in m, and the horizontal direction of the shot, along x for one that has none."""

    x: float = 0.0
    y: float = 0.0
    along: tuple = (1.0, 0.0)

    @property
    def centred(self):
        """Whether it is the middle of the coordinates."""
        return self.x == 0 and self.y == 0

    def distance(self, points):
        """Horizontal position along the direction [...]: x or y where it is one of these, else from the
        impact."""
        origin = 0.0 if 0.0 in self.along else self.x * self.along[0] + self.y * self.along[1]
        return points[..., 0] * self.along[0] + points[..., 1] * self.along[1] - origin


def impact_of(run):
    """Where the nose of the projectile, on its first straight way, meets the first ply."""
    results = run.results
    surface = results.projectile(0)
    if surface is None:
        return Impact()
    nose = surface.points[surface.points[:, 2] > surface.points[:, 2].max() - 1e-9].mean(axis=0)
    velocity = shot(run)
    speed = np.linalg.norm(velocity)
    plane = results.reference[results.parts[0][results.ply == results.ply.min()], 2].mean()
    if velocity[2] > OBLIQUE * speed:
        nose = nose + velocity * max(plane - nose[2], 0.0) / velocity[2]
    low, high = results.reference[:, :2].min(axis=0), results.reference[:, :2].max(axis=0)
    x, y = (
        0.0 if results.symmetry[axis] else float(np.clip(nose[axis], low[axis], high[axis]))
        for axis in (0, 1)
    )
    return Impact(snapped(x), snapped(y), direction(velocity[:2], speed))


def snapped(length):
    """The length without what rounding has added to it."""
    return round(length, 12) + 0.0


def shot(run):
    """The projectile's first velocity: that of the history, or its way between the first frames in m."""
    rows = run.history if run.has_history else {}
    if {"projectile_vx", "projectile_vy"} <= set(rows):
        return np.array([rows[name][0] for name in ("projectile_vx", "projectile_vy", "projectile_vz")])
    frames = (0, min(1, len(run.results.times) - 1))
    first, second = (run.results.projectile(step).points.mean(axis=0) for step in frames)
    return second - first


def direction(horizontal, speed):
    """Unit vector of the horizontal part of a velocity.

    It is x or y where it nearly is, and x where the horizontal part is small.
    """
    length = np.hypot(*horizontal)
    if length <= OBLIQUE * speed:
        return (1.0, 0.0)
    unit = horizontal / length
    for axis in (0, 1):
        if abs(unit[1 - axis]) < 1e-6:
            return (1.0, 0.0) if axis == 0 else (0.0, 1.0)
    return (float(unit[0]), float(unit[1]))
