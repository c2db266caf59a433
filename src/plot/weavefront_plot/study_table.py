"""study.json as checked values: a field that is missing or of another kind is named with its place."""
from dataclasses import dataclass

from .json_document import read_document


@dataclass(frozen=True)
class Axis:
    """What the study varies, and the values in SI of the labels that have one."""

    name: str
    values: dict


@dataclass(frozen=True)
class Series:
    """Variants that differ along the axis of the order only."""

    labels: list
    variants: list
    order: float | None


@dataclass(frozen=True)
class Quantity:
    """What is compared, its series, and for each kind of cost which variants are on the Pareto front."""

    name: str
    series: list
    fronts: dict


@dataclass(frozen=True)
class Variant:
    """One row of the study."""

    name: str
    labels: list
    compared: bool
    compared_with: str | None
    values: dict
    errors: dict
    core_seconds: float
    element_steps: float


@dataclass(frozen=True)
class Study:
    """The whole table."""

    title: str
    axes: list
    order_along: str | None
    quantities: list
    variants: list


def read_study(folder):
    """study.json of the folder."""
    path = folder / "study.json"
    root = read_document(path, "study")
    variants = [variant_of(node) for node in root["variants"].each()]
    names = {variant.name for variant in variants}
    if not variants:
        raise root["variants"].wrong("at least one variant")
    axes = [
        Axis(
            axis["name"].as_a(str),
            {choice["label"].as_a(str): choice["value"].optional(float) for choice in axis["choices"].each()},
        )
        for axis in root["axes"].each()
    ]
    for node, variant in zip(root["variants"].each(), variants):
        if len(variant.labels) != len(axes):
            raise node["labels"].wrong(f"a list of {len(axes)}, one label an axis")
    quantities = [quantity_of(node, names, len(variants)) for node in root["quantities"].each()]
    return Study(root["title"].as_a(str), axes, root["order_along"].optional(str), quantities, variants)


def variant_of(node):
    """One row."""
    seconds, ranks = node["wall_seconds"].as_a(float), node["ranks"].as_a(float)
    compared = node["outcome"].as_a(str) == "finished" and not node["reference_only"].as_a(bool)
    return Variant(
        name=node["variant"].as_a(str),
        labels=node["labels"].all_as(str),
        compared=compared,
        compared_with=node["compared_with"].optional(str),
        values=node["values"].numbers(),
        errors=node["errors"].numbers(),
        core_seconds=seconds * ranks,
        element_steps=node["element_steps"].as_a(float),
    )


def quantity_of(node, names, count):
    """One quantity; its series name variants that there are."""
    series = []
    for part in node["series"].each():
        for name in part["variants"].each():
            if name.as_a(str) not in names:
                raise name.wrong("the name of a variant")
        series.append(
            Series(part["labels"].all_as(str), part["variants"].all_as(str), part["order"].optional(float))
        )
    fronts = {key: node["pareto"][key].all_as(bool) for key in node["pareto"].as_a(dict)}
    for key, front in fronts.items():
        if len(front) != count:
            raise node["pareto"][key].wrong(f"a list of {count}, one a variant")
    return Quantity(node["name"].as_a(str), series, fronts)
