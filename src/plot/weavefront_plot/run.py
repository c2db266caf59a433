"""The folder of one run: its files, read when first needed, and its notable moments."""
from functools import cached_property

import numpy as np

from .fabric import Fabric
from .failure import Failure, FileError, InputError
from .hdf5_reader import Hdf5Reader
from .impact import OBLIQUE, impact_of
from .results import Results
from .scene_text import title_of
from .tables import read_columns

REQUIRED = (
    "time",
    "projectile_z",
    "projectile_vz",
    "kinetic_fabric",
    "kinetic_projectile",
    "internal",
    "energy_error",
    "broken_yarns",
)
OPTIONAL = (
    "projectile_vx",
    "projectile_vy",
    "contact_fx",
    "contact_fy",
    "contact_fz",
    "hourglass",
    "contact",
    "friction",
    "contact_friction",
    "damping",
    "external",
    "eroded",
    "back_face_deflection",
)
FURTHER = tuple(f"projectile{number}_vz" for number in range(2, 101))  # as many as a scene may have
DIGITS = 9  # at most, after the point of a time in a file's name


class Run:
    """results.vtkhdf and history.csv of one run."""

    def __init__(self, folder):
        if not folder.is_dir():
            raise FileError(f"{folder}: not a folder" if folder.exists() else f"{folder}: no such folder")
        self.folder = folder
        self.has_history = (folder / "history.csv").exists()

    @cached_property
    def history(self):
        """Columns of history.csv in SI; those that no picture needs are not read."""
        path = self.folder / "history.csv"
        if self.has_history and not path.is_file():
            raise FileError(f"{path}: not a file")
        columns = read_columns(path, REQUIRED, (*OPTIONAL, *FURTHER), growing=True)
        if np.any(np.diff(columns["time"]) < 0):
            raise InputError(f"{path}: the times do not ascend")
        return columns

    @cached_property
    def results(self):
        """The frames."""
        return Results(self.folder / "results.vtkhdf")

    @cached_property
    def impact(self):
        """Where the shot meets the target."""
        return impact_of(self)

    @cached_property
    def title(self):
        """The scene's title, or nothing."""
        try:
            return title_of(Hdf5Reader(self.folder / "results.vtkhdf").text("scene"))
        except Failure:
            return ""

    @cached_property
    def has_projectile(self):
        """Whether something is shot: every projectile has mass and speed at the start."""
        return self.history["kinetic_projectile"][0] > 0

    @cached_property
    def further_velocities(self):
        """Velocities along z of the second and further projectiles in m/s."""
        return [self.history[name] for name in FURTHER if name in self.history]

    @cached_property
    def speed(self):
        """The projectile's speed over the history in m/s where the shot is oblique, else None."""
        rows = self.history
        if not self.has_projectile or not {"projectile_vx", "projectile_vy"} <= set(rows):
            return None
        speed = np.linalg.norm([rows["projectile_vx"], rows["projectile_vy"], rows["projectile_vz"]], axis=0)
        return (
            speed
            if np.hypot(rows["projectile_vx"][0], rows["projectile_vy"][0]) > OBLIQUE * speed[0]
            else None
        )

    def caption(self, step):
        """Time and velocity of the projectile in a frame, as a line of text."""
        time = self.results.times[step]
        parts = [microseconds(time)]
        if self.has_history and self.has_projectile:
            shown = [("vz", self.history["projectile_vz"])] + (
                [] if self.speed is None else [("speed", self.speed)]
            )
            parts += [
                f"{name} {signed(np.interp(time, self.history['time'], values))} m/s"
                for name, values in shown
            ]
        return ",  ".join(parts).replace(",  vz", f",  {self.name_of_first}: vz")

    @property
    def name_of_first(self):
        """What to call the first projectile."""
        return "first projectile" if self.further_velocities else "projectile"

    @cached_property
    def turning_frame(self):
        """The frame nearest to the rebound; without one, that in which the last ply is deflected most."""
        times = self.results.times
        if self.has_history:
            back = np.flatnonzero(self.history["projectile_vz"] <= 0)
            if len(back) and back[0] > 0:
                return int(np.argmin(np.abs(times - self.history["time"][back[0]])))
        fabric = Fabric(self.results)
        return int(np.argmax([fabric.deflection(step) for step in range(len(times))]))

    def frames(self, times):
        """The frames nearest to `times`, ascending; by default four with the turning frame among them.

        They are spread over the run, or around the turning frame where it comes early, as after a
        perforation.
        """
        known = self.results.times
        if times:
            return sorted({int(np.argmin(np.abs(known - time))) for time in times})
        turn = self.turning_frame
        early = 0 < known[turn] < 0.4 * known[-1]
        wanted = (
            known[turn] * np.array([1 / 3, 2 / 3, 1, 2])
            if early
            else known[-1] * np.array([0.25, 0.5, 0.75, 1])
        )
        chosen = [int(np.argmin(np.abs(known - time))) for time in wanted]
        if turn not in chosen:
            chosen[min(range(3), key=lambda i: abs(chosen[i] - turn))] = turn
        return sorted(set(chosen))

    def label(self, step):
        """The frame's time as part of a file name, such as 30us; with its number where that is not enough."""
        micro = self.results.times * 1e6
        digits = next((d for d in range(DIGITS + 1) if len(set(np.round(micro, d))) == len(micro)), None)
        return f"{micro[step]:.{digits or 0}f}us" + (f"_{step}" if digits is None else "")


def microseconds(time):
    """A time in s with three digits, such as 90.1 µs or 1204 µs."""
    micro = abs(time) * 1e6
    digits = int(np.clip(2 - np.floor(np.log10(max(micro, 1e-3))), 0, 3))
    text = f"{time * 1e6:.{digits}f}"
    return (text.rstrip("0").rstrip(".") if digits else text) + " µs"


def signed(value):
    """A number without digits after the point, with a typographic minus."""
    return (
        f"{'−' if round(value) < 0 else ''}{f'{abs(value):.0f}' if abs(value) < 1e7 else f'{abs(value):.3g}'}"
    )
