"""Quantities with units on the command line, and how the result arrays are shown."""
import re
from dataclasses import dataclass

from .failure import InputError

TIME = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "ns": 1e-9}
LENGTH = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}


def parse(text, units, option):
    """The value of `text` in SI, such as 30e-6 for "30us"."""
    match = re.fullmatch(r"\s*([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([a-zµ]+)\s*", text)
    try:
        value = float(match[1]) * units[match[2]]
    except (TypeError, KeyError, ValueError):
        raise InputError(f"{option}: '{text}' is not a number with one of the units {', '.join(units)}") from None
    return value


def parse_times(text):
    """The times of "30us,60us" in s."""
    return [parse(item, TIME, "--times") for item in text.split(",") if item.strip()]


def parse_window(text):
    """A positive length in m."""
    length = parse(text, LENGTH, "--window")
    if length <= 0:
        raise InputError(f"--window: '{text}' must be greater than zero")
    return length


@dataclass(frozen=True)
class Shown:
    """An array's name on a colour bar, and the factor from SI to the unit given there."""

    label: str
    factor: float = 1.0


ARRAYS = {
    "stress": Shown("Yarn stress, GPa", 1e-9),
    "stress_fill": Shown("Stress of the fill yarns, GPa", 1e-9),
    "stress_warp": Shown("Stress of the warp yarns, GPa", 1e-9),
    "strain": Shown("Yarn strain, %", 100.0),
    "strain_fill": Shown("Strain of the fill yarns, %", 100.0),
    "strain_warp": Shown("Strain of the warp yarns, %", 100.0),
    "braid_angle": Shown("Braid angle, degrees", 57.29577951308232),
    "crimp_height": Shown("Crimp height, mm", 1e3),
    "broken_fill": Shown("Broken fill yarns"),
    "broken_warp": Shown("Broken warp yarns"),
    "ply": Shown("Ply"),
    "height": Shown("Deflection, mm", 1e3),
}
