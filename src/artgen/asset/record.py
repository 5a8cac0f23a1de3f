"""Values of an asset as JSON: plain data, rounded numbers, and readable text."""

import json
import types
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import partial
from typing import Any, ClassVar, Self, Union, get_args, get_origin, get_type_hints

import numpy as np

from artgen._arrays import cached

DECIMALS = 12  # decimals of coordinates of colliders [m]; other numbers have as many significant digits
_EXPANDED = 3  # levels that always have a line per item; the next level has if items are not plain values
_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False)


@dataclass(frozen=True, eq=False)
class Record:
    """Base of dataclasses that are stored as JSON.

    Fields are words, numbers, arrays, records, and tuples and mappings of these.
    """

    OPTIONAL: ClassVar[frozenset[str]] = frozenset()  # fields that may be missing in data
    FIRST: ClassVar[tuple[str, ...]] = ()  # fields that come first in data

    def to_data(self) -> dict[str, Any]:
        """Return the fields as JSON data."""
        names = dict.fromkeys((*self.FIRST, *(field.name for field in fields(self))))
        return {name: plain(getattr(self, name)) for name in names}

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """Return the object of data from `to_data`.

        Raises:
            KeyError: The data lack a field.
        """
        readers = _readers(cls)
        given = {name: data[name] for name in readers if name in data or name not in cls.OPTIONAL}
        return cls(**{name: readers[name](value) for name, value in given.items()})


Reader = Callable[[Any], Any]
_PLAIN: Mapping[Any, type | tuple[type, ...]] = {float: (float, int), int: int, str: str, bool: bool}
"""Types of JSON values that are read as they are; others are not checked."""


@cached(None)
def _readers(cls: type[Record]) -> dict[str, Reader]:
    """Return for each field of a record the function that converts its JSON data."""
    hints = get_type_hints(cls)
    return {field.name: _reader(hints[field.name]) for field in fields(cls)}


def _reader(kind: Any) -> Reader:
    """Return the function that converts JSON data to a type."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is np.ndarray:
        return _array
    if isinstance(kind, type) and issubclass(kind, Record):
        return kind.from_data
    if origin in (Union, types.UnionType):  # a type or None
        read = _reader(inner[0])
        return lambda data: None if data is None else read(data)
    if origin is tuple and inner[-1] is Ellipsis:
        read = _reader(inner[0])
        return lambda data: tuple(map(read, data))
    if origin is tuple:
        readers = [_reader(each) for each in inner]
        return lambda data: tuple(read(item) for read, item in zip(readers, data, strict=True))
    if origin is Mapping:
        read = _reader(inner[1])
        return lambda data: {key: read(item) for key, item in data.items()}
    return partial(_plain_value, _PLAIN.get(kind, object))


def _array(data: Any) -> Any:
    found = np.array(data, float)
    if not isinstance(data, list) or not np.isfinite(found).all():
        raise TypeError(f"{data!r:.40} is no list of numbers")
    return found


def _plain_value(kinds: type | tuple[type, ...], data: Any) -> Any:
    if not isinstance(data, kinds):
        raise TypeError(f"{data!r:.40} is of the wrong type")
    return data


def plain(value: Any) -> Any:
    """Return a value as JSON data: arrays and tuples become lists, records become objects."""
    if isinstance(value, Record):
        return value.to_data()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    return [plain(item) for item in value] if isinstance(value, list | tuple) else value


def rounded(value: Any, digits: int = DECIMALS) -> Any:
    """Round every number in a record or in JSON data to significant digits.

    Digits beyond 12 depend on the math library of the machine.
    """
    if isinstance(value, float):
        return significant(value, digits)
    if isinstance(value, np.ndarray):
        return np.array([significant(each, digits) for each in value.flat]).reshape(value.shape)
    if is_dataclass(value) and not isinstance(value, type):
        values = {each.name: rounded(getattr(value, each.name), digits) for each in fields(value)}
        return replace(value, **values)
    if isinstance(value, dict):
        return {key: rounded(item, digits) for key, item in value.items()}
    return type(value)(rounded(each, digits) for each in value) if isinstance(value, list | tuple) else value


def rounded_coordinates(rows: Any) -> Any:
    """Round coordinates to a millionth of a micrometre."""
    return np.round(rows, DECIMALS) + 0.0


def significant(number: float, digits: int) -> float:
    """Round a number to significant digits; zero is never negative."""
    return float(f"{number:.{digits}g}") + 0.0


def json_text(data: Any) -> str:
    """Return JSON text with one line per field, link part or collider."""
    return _spread(data, 0) + "\n"


def _spread(data: Any, level: int) -> str:
    """Return data as JSON text with one line per item on the outer levels."""
    if not isinstance(data, dict | list | tuple) or not data or level > _EXPANDED:
        return _ENCODER.encode(data)
    values = data.values() if isinstance(data, dict) else data
    if level == _EXPANDED and not any(isinstance(value, dict | list | tuple) for value in values):
        return _ENCODER.encode(data)
    indent = "\n" + " " * (level + 1)
    texts = [_spread(value, level + 1) for value in values]
    if isinstance(data, dict):
        texts = [f"{_ENCODER.encode(key)}: {text}" for key, text in zip(data, texts, strict=True)]
        opening, closing = "{}"
    else:
        opening, closing = "[]"
    return opening + indent + f",{indent}".join(texts) + indent[:-1] + closing
