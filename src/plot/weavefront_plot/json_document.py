"""A JSON document as checked values: a field that is missing or of another kind is named with its place."""
import json

from .failure import InputError
from .option_values import short
from .tables import LARGEST, read_text

KINDS = {str: "text", bool: "true or false", float: "a number", list: "a list", dict: "a map"}


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


def read_document(path, kind):
    """The document of a file. `kind`: of what it is, for messages."""
    try:
        return Node(path, "", json.loads(read_text(path)))
    except json.JSONDecodeError as error:
        raise InputError(f"{path}:{error.lineno}:{error.colno}: not JSON: {error.msg}") from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path}: not JSON of a {kind}: {error}") from None
