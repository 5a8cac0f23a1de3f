"""The JSON of an asset: any data comes back, and a person can read it."""

import json

from hypothesis import given
from hypothesis import strategies as st

from artgen.asset.record import json_text, rounded, rounded_link, significant

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


@given(st.lists(st.lists(st.floats(-100.0, 100.0), min_size=3, max_size=3), max_size=5), st.floats(0.0, 1e6))
def test_link_is_rounded_to_what_no_machine_disputes(points: list[list[float]], mass: float) -> None:
    link = {
        "name": "lid",
        "mass": mass,
        "colliders": [{"kind": "hull", "pose": [], "size": [mass], "points": points}],
    }
    found = rounded_link(link)
    assert rounded_link(found) == found
    assert found["mass"] == float(f"{mass:.12g}")
    (collider,) = found["colliders"]
    assert collider["kind"] == "hull"
    assert collider["size"] == [found["mass"]]
    for row, before in zip(collider["points"], points, strict=True):
        assert all(abs(a - b) <= 5.3e-13 for a, b in zip(row, before, strict=True))
        assert all(a == round(a, 12) for a in row)
    assert not any(str(number) == "-0.0" for row in collider["points"] for number in row)


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
