"""The folder of one run: its files, read when first needed, and its notable moments."""
import re
from functools import cached_property

import numpy as np

from .failure import Failure, FileError
from .results import Results
from .tables import read_columns


class Run:
    """results.vtkhdf and history.csv of one run."""

    def __init__(self, folder):
        if not folder.is_dir():
            raise FileError(f"{folder}: no such folder")
        self.folder = folder

    @cached_property
    def history(self):
        """Columns of history.csv in SI."""
        required = ("time", "projectile_z", "projectile_vz", "kinetic_fabric", "kinetic_projectile", "internal", "energy_error",
                    "broken_yarns")
        return read_columns(self.folder / "history.csv", required)

    @cached_property
    def results(self):
        """The frames."""
        return Results(self.folder / "results.vtkhdf")

    @cached_property
    def title(self):
        """The scene's title, or nothing."""
        try:
            scene = self.results.scene
        except Failure:
            return ""
        match = re.search(r"^title:[ \t]*(.+)$", scene, re.MULTILINE)
        return match[1].strip().strip("\"'") if match else ""

    @cached_property
    def has_projectile(self):
        """Whether something is shot: every projectile has mass and speed at the start."""
        return self.history["kinetic_projectile"][0] > 0

    def velocity(self, time):
        """The projectile's velocity along the shot in m/s, or None without a history or a projectile."""
        if not (self.folder / "history.csv").is_file() or not self.has_projectile:
            return None
        return float(np.interp(time, self.history["time"], self.history["projectile_vz"]))

    @cached_property
    def turning_frame(self):
        """The frame nearest to the rebound; without one, that in which the last ply is deflected most."""
        results = self.results
        if (self.folder / "history.csv").is_file():
            back = np.flatnonzero(self.history["projectile_vz"] <= 0)
            if len(back) and back[0] > 0:
                return int(np.argmin(np.abs(results.times - self.history["time"][back[0]])))
        last = results.ply == results.ply.max()
        return int(np.argmax([self._deflection(step, last) for step in range(len(results.times))]))

    def _deflection(self, step, cells):
        nodes = self.results.parts[0][cells & self.results.alive(step)]
        return self.results.displacement(step)[nodes, 2].max(initial=0.0)

    def frames(self, times):
        """The frames nearest to `times`, ascending; by default four with the turning frame among them.

        They are spread over the run, or around the turning frame where it comes early, as after a perforation.
        """
        known = self.results.times
        if times:
            return sorted({int(np.argmin(np.abs(known - time))) for time in times})
        turn = self.turning_frame
        early = 0 < known[turn] < 0.4 * known[-1]
        wanted = known[turn] * np.array([1 / 3, 2 / 3, 1, 2]) if early else known[-1] * np.array([0.25, 0.5, 0.75, 1])
        chosen = [int(np.argmin(np.abs(known - time))) for time in wanted]
        if turn not in chosen:
            chosen[min(range(3), key=lambda i: abs(chosen[i] - turn))] = turn
        return sorted(set(chosen))

    def label(self, step):
        """The frame's time as part of a file name, such as 30us."""
        micro = self.results.times * 1e6
        digits = next((d for d in range(4) if len(set(np.round(micro, d))) == len(micro)), 4)
        return f"{micro[step]:.{digits}f}us"
