"""What the options of weavefront-plot may say; nothing here reads a file."""
import math
import re

from .failure import InputError

PICTURES = ("history", "energies", "deformed", "section", "contour")
FORMATS = ("png", "svg", "pdf")
ANIMATIONS = ("gif", "mp4")
TIME = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "ns": 1e-9}
LENGTH = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6}
WINDOW = (1e-6, 1e3)  # m
VIEWS = {
    "back-face": (-52.0, 24.0),
    "strike-face": (-52.0, -24.0),
    "side": (-90.0, 0.0),
    "top": (-90.0, 90.0),
    "bottom": (-90.0, -90.0),
}


def short(text):
    """The text, or its beginning."""
    return text if len(text) <= 60 else text[:59] + "…"


def items(text, option):
    """The parts of a list with commas; an empty one is refused."""
    parts = [part.strip() for part in text.split(",")]
    if not all(parts):
        raise InputError(f"{option}: '{short(text)}' has an empty item" if any(parts) else f"{option}: empty")
    return parts


def quantity(text, units, option):
    """The value of `text` in SI, such as 30e-6 for "30us"."""
    match = re.fullmatch(r"\s*([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([a-zµ]+)\s*", text)
    try:
        value = float(match[1]) * units[match[2]]
    except (TypeError, KeyError, ValueError):
        value = math.inf
    if not math.isfinite(value):
        raise InputError(
            f"{option}: '{short(text)}' is not a number with one of the units {', '.join(units)}"
        )
    return value


def times(text):
    """The times of "30us,60us" in s."""
    return [quantity(item, TIME, "--times") for item in items(text, "--times")]


def window(text):
    """A length in m."""
    length = quantity(text, LENGTH, "--window")
    if length <= 0:
        raise InputError(f"--window: '{short(text)}' must be greater than zero")
    if not WINDOW[0] <= length <= WINDOW[1]:
        raise InputError(f"--window: '{short(text)}' is not from {WINDOW[0] * 1e6:g} um to {WINDOW[1]:g} m")
    return length


def pictures(text):
    """The names in --only."""
    names = items(text, "--only")
    for name in names:
        if name not in PICTURES:
            raise InputError(f"--only: '{short(name)}' is none of {', '.join(PICTURES)}")
    return names


def plies(text):
    """The numbers of "1,3-5", ascending."""
    numbers = set()
    for item in items(text, "--plies"):
        match = re.fullmatch(r"([0-9]{1,6})(?:\s*-\s*([0-9]{1,6}))?", item)
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (0, 0)
        if not 1 <= first <= last:
            raise InputError(
                f"--plies: '{short(item)}' is no ply, such as 3, and no range of plies, such as 3-5"
            )
        numbers.update(range(first, last + 1))
    return sorted(numbers)


def view(text):
    """Azimuth and elevation in degrees of a name in VIEWS or of "30,45"."""
    if text in VIEWS:
        return VIEWS[text]
    try:
        azimuth, elevation = map(float, text.split(","))
    except ValueError:
        azimuth = elevation = math.nan
    if not (abs(azimuth) <= 360 and abs(elevation) <= 90):
        raise InputError(
            f"--view: '{short(text)}' is none of {', '.join(VIEWS)}, and not an azimuth (-360 to 360) and an elevation "
            "(-90 to 90) in degrees, such as -52,24"
        )
    return azimuth, elevation
