"""Numbers as text: fast tables for OBJ files, and XML elements."""

import json
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, Indices, cached
from artgen.asset import Asset

Bytes = NDArray[np.uint8]
Words = NDArray[np.uint32]  # four characters each

_GROUP = 10_000  # range of four digits


def rounded(values: Array, decimals: int) -> Indices:
    """Return numbers with a fixed number of decimals as integers."""
    return np.rint(values * 10.0**decimals).astype(np.int64)


def lines(heads: Sequence[str], scaled: Indices, decimals: int = 0) -> Bytes:
    """Return one line of text per row of numbers, as input of `text`, without trailing zeros."""
    magnitude = np.abs(scaled)
    whole = magnitude // 10**decimals
    words = _whole(whole)
    if decimals:
        words += _fraction(magnitude - whole * 10**decimals, decimals)
    first, signed = _words(*heads), _words(*(f"{head}-" for head in heads))
    rows, columns = scaled.shape
    cells = 1 + len(words)
    line = np.empty((rows, columns * cells + 1), np.uint32)
    line[:, :-1:cells] = np.where(scaled < 0, signed, first)
    for number, word in enumerate(words, start=1):
        line[:, number:-1:cells] = word
    line[:, -1] = _words("\n")
    return line.view(np.uint8)


def face_lines(corners: Indices, numbers: Indices) -> Bytes:
    """Return the `f` lines of an OBJ file, as input of `text`."""
    each = np.ascontiguousarray(lines((" ", "/", "/"), numbers)[:, :-4])  # without line ends
    row = np.empty((len(corners), 2 + 3 * each.shape[1]), np.uint8)
    row[:, 0] = ord("f")
    # taking items is many times faster than taking rows
    taken = np.take(each.view(f"V{each.shape[1]}").ravel(), corners)
    row[:, 1:-1] = taken.view(np.uint8).reshape(len(corners), -1)
    row[:, -1] = ord("\n")
    return row


def text(rows: Bytes) -> bytes:
    """Return the text of several lines."""
    return rows.tobytes().translate(None, b"\0")


@cached(64)
def _words(*characters: str) -> Words:
    """Return strings of at most four characters as one number each with the same bytes."""
    return np.frombuffer("".join(each.ljust(4, "\0") for each in characters).encode("ascii"), np.uint32)


def _whole(numbers: Indices) -> list[Words]:
    """Return the digits of integers, shape (...), without leading zeros."""
    higher = numbers // _GROUP
    group = numbers - higher * _GROUP
    words = [np.where(higher > 0, _DIGITS[group], _LEADING[group])]
    if higher.any():
        words = [np.where(higher > 0, word, 0).astype(np.uint32) for word in _whole(higher)] + words
    return words


def _fraction(numbers: Indices, decimals: int) -> list[Words]:
    """Return a point and the digits after it, without trailing zeros; empty if all are zero."""
    groups = max(0, -(-(decimals - 3) // 4))  # four digits, after a point and three digits
    rest = numbers * 10 ** (3 + 4 * groups - decimals)
    words: list[Words] = []
    shown = np.zeros(numbers.shape, bool)
    for _ in range(groups):
        higher = rest // _GROUP
        group = rest - higher * _GROUP
        words.insert(0, np.where(shown, _DIGITS[group], _TRAILING[group]))
        shown |= group > 0
        rest = higher
    return [np.where(shown, _POINT_DIGITS[rest], _POINT_TRAILING[rest]), *words]


_POWERS = np.array([1000, 100, 10, 1])
_NUMBERS = np.arange(_GROUP)[:, None]
_CHARACTERS = (_NUMBERS // _POWERS % 10 + ord("0")).astype(np.uint8)
_POINTED = np.where(_POWERS == 1000, np.uint8(ord(".")), _CHARACTERS)[:1000]  # a point and three digits
_ENDING = _NUMBERS % (10 * _POWERS) > 0  # whether a digit or a later one is not zero

_DIGITS = _CHARACTERS.view(np.uint32).ravel()
_LEADING = np.where((_NUMBERS >= _POWERS) | (_POWERS == 1), _CHARACTERS, 0).view(np.uint32).ravel()
_TRAILING = np.where(_ENDING, _CHARACTERS, 0).view(np.uint32).ravel()
_POINT_DIGITS = _POINTED.view(np.uint32).ravel()
_POINT_TRAILING = np.where(_ENDING[:1000], _POINTED, 0).view(np.uint32).ravel()


def digits(value: float) -> str:
    """Return a number as text with 12 significant digits, in which all machines agree."""
    return f"{value + 0.0:.12g}"


def numbers(values: Iterable[float] | Array) -> str:
    """Return numbers as text, separated by spaces."""
    return " ".join(digits(float(value)) for value in values)


Attribute = str | float | Iterable[float] | Array | None


def add(
    parent: ET.Element, tag: str, attributes: Mapping[str, Attribute] | None = None, /, **more: Attribute
) -> ET.Element:
    """Add an XML element; an attribute without a value, None, is omitted."""
    values = {**(attributes or {}), **more}
    return ET.SubElement(
        parent, tag, {name: _value(value) for name, value in values.items() if value is not None}
    )


def _value(value: str | float | Iterable[float] | Array) -> str:
    if isinstance(value, str):
        return value
    return digits(value) if isinstance(value, int | float) else numbers(value)


def document(root: ET.Element, space: str = " ", encoding: str = "utf-8") -> bytes:
    """Return the text of an XML file, indented."""
    ET.indent(root, space)
    content: bytes = ET.tostring(root, encoding, xml_declaration=True)
    return content + b"\n"


def states_text(asset: Asset) -> str:
    """Return limits, couplings and dependencies of the joints as JSON text of one line."""
    return json.dumps(asset.states_data(), separators=(",", ":"))
