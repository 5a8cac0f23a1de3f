"""Values of an asset as JSON: plain data, rounded numbers, and readable text."""

import json
import types
from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass, replace
from functools import partial
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    NotRequired,
    Self,
    Union,
    get_args,
    get_origin,
    get_type_hints,
    is_typeddict,
)

import numpy as np

from artgen._arrays import Array, cached
from artgen.errors import ArtgenError, AssetError

DECIMALS = 12  # decimals of coordinates of colliders [m]; other numbers have as many significant digits
_EXPANDED = 3  # levels that always have a line per item; the next level has if items are not plain values
_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False)


@dataclass(frozen=True, eq=False)
class Record:
    """Base of dataclasses that are stored as JSON.

    Fields are words, numbers, arrays, records, and tuples and mappings of these.
    """

    OPTIONAL: ClassVar[frozenset[str]] = frozenset()  # fields that may be missing in data, and are if None
    FIRST: ClassVar[tuple[str, ...]] = ()  # fields that come first in data

    def to_data(self) -> dict[str, Any]:
        """Return the fields as JSON data."""
        names = dict.fromkeys((*self.FIRST, *(field.name for field in fields(self))))
        values = {name: plain(getattr(self, name)) for name in names}
        return {name: each for name, each in values.items() if each is not None or name not in self.OPTIONAL}

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """Return the object of data from `to_data`.

        Raises:
            AssetError: A value is missing or of the wrong kind; the message has its place.
        """
        found: Self = read(cls, data)
        return found


Reader = Callable[[Any, str], Any]
_PLAIN: Mapping[Any, tuple[tuple[type, ...], str]] = {
    int: ((int,), "a whole number"),
    str: ((str,), "text"),
    bool: ((bool,), "true or false"),
}
"""Types of JSON values that are read as they are, and their names in messages."""

_LONGEST = 60  # most characters of a value in a message
_LARGEST = 1e30  # largest number: its square, and its value in 32 bits, are finite


def read(kind: Any, data: Any, place: str = "") -> Any:
    """Return JSON data as a value of a type: a record, a `TypedDict`, or what their fields may be.

    Arrays have the shape of their annotation, or any; numbers are finite, and at most 1e30.

    Args:
        kind: The type.
        data: JSON data.
        place: Place of the data in its file, such as `links[0].center`.

    Raises:
        AssetError: A value is missing or of the wrong kind; the message has its place, and what is allowed.
    """
    return _reader(kind)(data, place)


def refused(data: Any, place: str, allowed: str) -> AssetError:
    """Return the error for a value at a place in a file."""
    text = repr(data)
    text = text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."
    return AssetError(f"{place or 'it'} is {text}, but it must be {allowed}")


@cached(None)
def _reader(kind: Any) -> Reader:
    """Return the function that converts JSON data at a place to a type."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin in _GENERIC:
        return _GENERIC[origin](inner)
    if is_typeddict(kind) or is_dataclass(kind):
        return partial(_fields, kind)
    if kind is float:
        return _number
    return partial(_plain_value, *_PLAIN[kind]) if kind in _PLAIN else _json


def _optional(inner: tuple[Any, ...]) -> Reader:
    reads = _reader(inner[0])
    return lambda data, place: None if data is None else reads(data, place)


def _sequence(inner: tuple[Any, ...]) -> Reader:
    if inner[-1] is Ellipsis:
        return partial(_row, _reader(inner[0]))
    return partial(_columns, [_reader(each) for each in inner])


_GENERIC: Mapping[Any, Callable[[tuple[Any, ...]], Reader]] = {
    NotRequired: lambda inner: _reader(inner[0]),
    Annotated: lambda inner: partial(_array, inner[1]),  # with a shape
    get_origin(Array): lambda _: partial(_array, None),  # NDArray itself from NumPy 2.5 on
    Literal: lambda inner: partial(_choice, inner),
    Union: _optional,
    types.UnionType: _optional,
    tuple: _sequence,
    Mapping: lambda inner: partial(_mapping, _reader(inner[1])),
}
"""Readers of generic types, from their arguments; a union is of a type and None."""


@cached(None)
def _form(kind: Any) -> tuple[dict[str, Reader], frozenset[str]]:
    """Return the readers of the fields of a type by name, and the names of those that may be missing."""
    hints = get_type_hints(kind, include_extras=True)
    if is_typeddict(kind):
        return {name: _reader(hint) for name, hint in hints.items()}, kind.__optional_keys__
    readers = {each.name: _reader(hints[each.name]) for each in fields(kind)}
    if issubclass(kind, Record):
        return readers, kind.OPTIONAL
    return readers, frozenset(each.name for each in fields(kind) if each.default is not MISSING)


def _fields(kind: Any, data: Any, place: str) -> Any:
    readers, optional = _form(kind)
    if not isinstance(data, Mapping):
        raise refused(data, place, f"an object with {', '.join(name for name in readers)}")
    start = f"{place}." if place else ""
    for name in readers:
        if name not in data and name not in optional:
            raise AssetError(f"{start}{name} is missing")
    values = {name: reads(data[name], start + name) for name, reads in readers.items() if name in data}
    if is_typeddict(kind):
        return values
    try:
        return kind(**values)
    except ArtgenError as error:
        raise AssetError(f"{place}: {error}") from error


def _row(reads: Reader, data: Any, place: str) -> tuple[Any, ...]:
    if not isinstance(data, list | tuple):
        raise refused(data, place, "a list")
    return tuple(reads(item, f"{place}[{index}]") for index, item in enumerate(data))


def _columns(readers: Sequence[Reader], data: Any, place: str) -> tuple[Any, ...]:
    if not isinstance(data, list | tuple) or len(data) != len(readers):
        raise refused(data, place, f"a list of {len(readers)} values")
    return tuple(
        reads(item, f"{place}[{at}]") for at, (reads, item) in enumerate(zip(readers, data, strict=True))
    )


def _mapping(reads: Reader, data: Any, place: str) -> dict[str, Any]:
    if not isinstance(data, Mapping):
        raise refused(data, place, "an object")
    return {key: reads(item, f"{place}[{key!r:.{_LONGEST}}]") for key, item in data.items()}


def _array(shape: tuple[int, ...] | None, data: Any, place: str) -> Any:
    """Return an array; its first length may be any where the shape has 0."""
    try:
        found = np.array(data) if isinstance(data, list | tuple | np.ndarray) else np.empty((), object)
    except (ValueError, OverflowError):  # rows of unequal lengths
        found = np.empty((), object)
    if found.size == 0 and shape is not None and shape[0] == 0:
        found = np.empty(shape)
    fits = shape is None or (
        found.ndim == len(shape) and all(n in (m, 0) for m, n in zip(found.shape, shape, strict=True))
    )
    if not fits or found.dtype.kind not in "if" or not (np.abs(found) <= _LARGEST).all():
        lengths = () if shape is None else tuple(str(each) for each in shape if each)
        rows = "lists" if shape is not None and len(shape) > 1 else "a list"
        raise refused(data, place, f"{rows} of {' x '.join(lengths)} numbers".replace("  ", " "))
    return found.astype(float)


def _choice(allowed: tuple[str, ...], data: Any, place: str) -> Any:
    if data not in allowed:
        raise refused(data, place, f"one of {', '.join(map(repr, allowed))}")
    return data


def _number(data: Any, place: str) -> Any:
    if type(data) is bool or not isinstance(data, float | int) or not abs(data) <= _LARGEST:
        raise refused(data, place, f"a number of at most {_LARGEST:g}")
    return data


def _plain_value(kinds: tuple[type, ...], allowed: str, data: Any, place: str) -> Any:
    if not isinstance(data, kinds) or (type(data) is bool and bool not in kinds):
        raise refused(data, place, allowed)
    return data


def _json(data: Any, place: str) -> Any:
    """Return data of any kind, whose numbers are finite."""
    if isinstance(data, Mapping):
        return _mapping(_json, data, place)
    if isinstance(data, list | tuple):
        return [_json(item, f"{place}[{index}]") for index, item in enumerate(data)]
    return _number(data, place) if isinstance(data, float) else data


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
