"""v50.json as checked values."""
from dataclasses import dataclass

from .json_document import read_document

RESULTS = ("complete", "partial", "none")


@dataclass(frozen=True)
class Shot:
    """One shot at the scene as it stands, or of a range."""

    speed: float
    result: str
    of_range: bool
    residual: float | None
    absorbed_energy: float | None


@dataclass(frozen=True)
class Curve:
    """A fitted S-curve: speed of each probability with its interval; None: open."""

    v50: float
    quantiles: list


@dataclass(frozen=True)
class ResidualCurve:
    """Vr = a (Vs^p - V50^p)^(1/p)."""

    v50: float
    a: float
    p: float

    def residual(self, speed):
        """Of one striking velocity."""
        if speed <= self.v50:
            return 0.0
        return self.a * speed * (1 - (self.v50 / speed) ** self.p) ** (1 / self.p)


@dataclass(frozen=True)
class V50:
    """The whole document."""

    title: str
    unit: str
    si: float
    mass: float
    low: float | None
    high: float | None
    mixed: tuple | None
    mean: float | None
    confidence: float
    normal: Curve | None
    logistic: Curve | None
    recht_ipson: ResidualCurve | None
    lambert_jonas: ResidualCurve | None
    shots: list


def read_v50(folder):
    """v50.json of the folder."""
    root = read_document(folder / "v50.json", "v50")
    limits = root["limits"].each()
    if not limits:
        raise root["limits"].wrong("at least one limit")
    si = root["unit"]["si"].as_a(float)
    if not si > 0:
        raise root["unit"]["si"].wrong("a number above 0")
    shots = [
        shot_of(node) for node in root["shots"].each() if node["variant"].as_a(str) in ("scene", "range")
    ]
    if not shots:
        raise root["shots"].wrong("at least one shot at the scene as it stands")
    mean, mixed = root["mil_std_662f"], root["mixed_results"]
    return V50(
        title=root["title"].as_a(str),
        unit=root["unit"]["name"].as_a(str),
        si=si,
        mass=root["projectile_mass"].as_a(float),
        low=limits[0]["partial"].optional(float),
        high=limits[0]["complete"].optional(float),
        mixed=(
            None
            if mixed.value is None
            else tuple(mixed[key].as_a(float) for key in ("lowest_complete", "highest_partial"))
        ),
        mean=None if mean.value is None else mean["v50"].as_a(float),
        confidence=root["confidence"].as_a(float),
        normal=curve_of(root["normal"]),
        logistic=curve_of(root["logistic"]),
        recht_ipson=residual_curve_of(root["recht_ipson"]),
        lambert_jonas=residual_curve_of(root["lambert_jonas"]),
        shots=shots,
    )


def shot_of(node):
    """One shot."""
    result = node["result"].as_a(str)
    if result not in RESULTS:
        raise node["result"].wrong(", ".join(RESULTS))
    return Shot(
        speed=node["speed"].as_a(float),
        result=result,
        of_range=node["variant"].value == "range",
        residual=node["residual"].optional(float),
        absorbed_energy=node["absorbed_energy"].optional(float),
    )


def curve_of(node):
    """A fitted curve; None where the fit was refused."""
    if node["refused"].optional(str) is not None:
        return None
    quantiles = [
        (
            part["probability"].as_a(float),
            part["value"].as_a(float),
            part["lower"].optional(float),
            part["upper"].optional(float),
        )
        for part in node["quantiles"].each()
    ]
    return Curve(v50=node["v50"]["value"].as_a(float), quantiles=quantiles)


def residual_curve_of(node):
    """A curve of residual velocities; None where there was none."""
    if node.value is None:
        return None
    curve = ResidualCurve(*(node[key].as_a(float) for key in ("v50", "a", "p")))
    if not curve.p > 0:
        raise node["p"].wrong("a number above 0")
    if curve.v50 < 0:
        raise node["v50"].wrong("a number of at least 0")
    return curve
