"""The plies that are drawn, and which of their elements are joined, torn off or eroded in a frame."""
import numpy as np

from .failure import InputError

MARGIN = 0.05  # of the window, shown beyond the edges of the target
MOVED = 0.02  # of the largest deflection, from which a node counts as deflected


class Fabric:
    """All plies of a run, or those of some numbers."""

    def __init__(self, results, numbers=None):
        self.results = results
        present = np.unique(results.ply)
        for number in numbers or ():
            if number not in present:
                raise InputError(
                    f"{results.path}: no ply {number}, which --plies asks for; it has {', '.join(map(str, present[:40]))}"
                )
        self.plies = np.array(numbers) if numbers else present
        self.chosen = np.isin(results.ply, self.plies)
        self.quads = results.parts[0]

    def joined(self, step):
        """Which elements are drawn, not eroded and joined to a support [c]."""
        return self.chosen & self.results.joined(step)

    def debris(self, step):
        """Which elements are drawn, not eroded, but no longer joined to a support [c]."""
        return self.chosen & self.results.alive(step) & ~self.results.joined(step)

    def last_ply(self, step):
        """Quads of the joined elements of the last ply."""
        return self.quads[self.joined(step) & (self.results.ply == self.plies[-1])]

    def deflection(self, step):
        """The largest deflection of the last ply in m, at least 0."""
        return float(self.results.displacement(step)[self.last_ply(step), 2].max(initial=0.0))

    def window(self, impact, frames):
        """How far about the impact fabric is deflected in these frames, along x and y, with a margin; in m.

        The window holds the projectile and the elements at the impact, and the whole target where none is
        deflected.
        """
        middle = [impact.x, impact.y]
        away = np.abs(self.results.reference[:, :2] - middle).max(axis=1)
        reach = max(away[nodes].max(initial=0.0) for nodes in map(self._moved, frames))
        if reach == 0:
            return float(away.max())
        surface = self.results.projectile(0)
        width = 0.0 if surface is None else np.ptp(surface.points[:, :2], axis=0).max()
        nearest = np.abs(self.results.reference[self.quads, :2].mean(axis=1) - middle).max(axis=1).min()
        return float(min(1.1 * max(reach, width, nearest), away.max()))

    def _moved(self, step):
        """Nodes of joined elements that are deflected."""
        height = np.abs(self.results.displacement(step)[:, 2])
        joined = np.zeros(len(height), dtype=bool)
        joined[self.quads[self.joined(step)]] = True
        return np.flatnonzero(joined & (height > MOVED * max(height[joined].max(initial=0.0), 1e-12)))

    def limits(self, impact, window):
        """Lowest and highest x and y of the target within the window, with a margin [2, 2]; in m."""
        points = self.results.reference[:, :2]
        whole = np.array([points.min(axis=0), points.max(axis=0)])
        whole[0] = np.where(self.results.symmetry, -whole[1], whole[0])
        middle, margin = np.array([impact.x, impact.y]), MARGIN * window
        return np.array(
            [np.maximum(whole[0] - margin, middle - window), np.minimum(whole[1] + margin, middle + window)]
        )
