"""study.json as checked values: a field that is missing or of another kind is named with its place."""
import json
from dataclasses import dataclass

from .failure import InputError
from .option_values import short
from .tables import LARGEST, read_text

KINDS = {str: "text", bool: "true or false", float: "a number", list: "a list", dict: "a map"}


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


class Node:
    """A part of the document and its place in it."""

    def __init__(self, path, place, value):
        self.path, self.place, self.value = path, place, value

    def wrong(self, allowed):
        """The error that something else was expected here."""
        return InputError(
            f"{self.path}: {self.place or 'document'}: found {short(json.dumps(self.value))}, allowed {allowed}"
        )

    def as_a(self, kind):
        """The value, which must be of the kind; a number must be finite."""
        value = self.value
        if kind is float and isinstance(value, int) and not isinstance(value, bool) and abs(value) <= LARGEST:
            value = float(value)
        if not isinstance(value, kind) or (kind is float and not abs(value) <= LARGEST):
            raise self.wrong(KINDS[kind])
        return value

    def optional(self, kind):
        """The value, or None for null."""
        return None if self.value is None else self.as_a(kind)

    def __getitem__(self, key):
        if key not in self.as_a(dict):
            raise InputError(f"{self.path}: {self.place or 'document'}: no '{key}'")
        return Node(self.path, f"{self.place}.{key}" if self.place else key, self.value[key])

    def each(self):
        """The items of a list."""
        return [Node(self.path, f"{self.place}[{i}]", value) for i, value in enumerate(self.as_a(list))]

    def all_as(self, kind):
        """The items of a list, all of one kind."""
        return [item.as_a(kind) for item in self.each()]

    def numbers(self):
        """A map of numbers or null."""
        return {key: self[key].optional(float) for key in self.as_a(dict)}


def read_study(folder):
    """study.json of the folder."""
    path = folder / "study.json"
    text = read_text(path)
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise InputError(f"{path}:{error.lineno}:{error.colno}: not JSON: {error.msg}") from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path}: not JSON of a study: {error}") from None
    root = Node(path, "", document)
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
