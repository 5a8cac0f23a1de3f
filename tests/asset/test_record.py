"""The JSON of an asset: any data comes back, and a person can read it."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen._arrays import Array
from artgen.asset.record import Record, json_text, rounded, rounded_coordinates, significant
from artgen.errors import AssetError

numbers = st.floats(allow_nan=False, allow_infinity=False)
data = st.recursive(
    st.none() | st.booleans() | st.integers() | numbers | st.text(),
    lambda children: st.lists(children, max_size=4) | st.dictionaries(st.text(), children, max_size=4),
    max_leaves=40,
)


@given(data)
def test_any_data_is_read_back(value: object) -> None:
    assert json.loads(json_text(value)) == value


@given(st.lists(st.lists(numbers)) | st.dictionaries(st.text(), numbers))
def test_rounded_twice_is_rounded_once(value: object) -> None:
    assert rounded(rounded(value)) == rounded(value)


def test_significant_digits_are_kept_and_no_zero_is_negative() -> None:
    assert significant(1234.5678, 6) == 1234.57
    assert significant(-1.23456789e-9, 3) == -1.23e-9
    assert str(significant(-0.0, 6)) == "0.0"


@given(st.lists(st.lists(st.floats(-100.0, 100.0), min_size=3, max_size=3), min_size=1, max_size=5))
def test_coordinates_are_rounded_to_what_no_machine_disputes(points: list[list[float]]) -> None:
    found = rounded_coordinates(np.array(points)).tolist()
    assert rounded_coordinates(np.array(found)).tolist() == found
    for row, before in zip(found, points, strict=True):
        assert all(abs(a - b) <= 5.3e-13 for a, b in zip(row, before, strict=True))
        assert all(a == round(a, 12) for a in row)
    assert not any(str(number) == "-0.0" for row in found for number in row)


@dataclass(frozen=True)
class Leg(Record):
    """A record in a record."""

    OPTIONAL: ClassVar = frozenset({"note"})

    length: float
    tip: Array
    note: str | None = None


@dataclass(frozen=True)
class Stool(Record):
    """A record with every kind of field."""

    legs: tuple[Leg, ...]
    size: tuple[float, int]
    spans: Mapping[str, tuple[float, float]]
    first: Leg | None = None


def test_a_record_is_read_back_from_its_data() -> None:
    leg = Leg(0.4, np.array([1.0, 2.0, 1.0 / 3.0]))
    stool = Stool((leg, replace(leg, note="bent")), (0.5, 2), {"x": (0.0, 1.0)}, leg)
    data = json.loads(json.dumps(stool.to_data()))
    assert data["spans"] == {"x": [0.0, 1.0]}
    found = Stool.from_data(data)
    assert found.to_data() == stool.to_data()
    assert isinstance(found.legs[0].tip, np.ndarray)
    assert (found.size, found.spans) == (stool.size, stool.spans)
    assert rounded(stool).first.tip[2] == 0.333333333333
    assert "note" not in data["legs"][0]
    assert found.legs[0].note is None
    data["legs"][0]["note"] = None
    assert Stool.from_data(data).legs[0].note is None
    del data["legs"][0]["length"]
    with pytest.raises(AssetError, match=r"legs\[0\].length is missing"):
        Stool.from_data(data)


def test_a_field_a_collider_and_a_file_list_have_a_line_each() -> None:
    colliders = [{"kind": "box", "pose": [[1, 0], [0, 1]]}, {"kind": "hull", "points": []}]
    links = [{"name": "lid", "center": [0.5, 1.0], "colliders": colliders, "grasps": []}]
    assert json_text({"name": "chest", "links": links, "formats": {"urdf": {"files": ["a", "b"]}}}) == (
        """{
 "name": "chest",
 "links": [
  {
   "name": "lid",
   "center": [0.5, 1.0],
   "colliders": [
    {"kind": "box", "pose": [[1, 0], [0, 1]]},
    {"kind": "hull", "points": []}
   ],
   "grasps": []
  }
 ],
 "formats": {
  "urdf": {
   "files": ["a", "b"]
  }
 }
}
"""
    )
