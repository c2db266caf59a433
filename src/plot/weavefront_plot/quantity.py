"""How the arrays of a run are shown."""
from dataclasses import dataclass


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
    "joined": Shown("Joined to a support"),
    "ply": Shown("Ply"),
    "height": Shown("Deflection, mm", 1e3),
}


def shown_as(field):
    """Label and factor of an array."""
    return ARRAYS.get(field, Shown(field))
