"""Trigonometric functions of arrays: the same values as those of the C library, on every processor."""

import itertools
import math
from collections.abc import Callable
from typing import Any

import hypothesis
import hypothesis.extra.numpy
import hypothesis.strategies as st
import numpy as np
import pytest

from artgen import _trig
from artgen._arrays import Array
from artgen.catalog import find
from artgen.proof.hierarchy import Hierarchy

ANGLES = st.floats(-1e4, 1e4)
SHARES = st.floats(-1.0, 1.0)


def _arrays(values: st.SearchStrategy[float]) -> st.SearchStrategy[Array]:
    return hypothesis.extra.numpy.arrays(np.float64, st.integers(0, 20), elements=values)


@pytest.mark.parametrize(
    ("function", "exact", "values"),
    [
        (_trig.sin, math.sin, ANGLES),
        (_trig.cos, math.cos, ANGLES),
        (_trig.tan, math.tan, ANGLES),
        (_trig.arctan, math.atan, ANGLES),
        (_trig.arccos, math.acos, SHARES),
    ],
)
@hypothesis.given(data=st.data())
def test_values_are_those_of_the_c_library(
    function: Callable[[Array], Array],
    exact: Callable[[float], float],
    values: st.SearchStrategy[float],
    data: st.DataObject,
) -> None:
    array = data.draw(_arrays(values))
    found = function(array)
    assert (found.shape, found.dtype) == (array.shape, np.dtype(np.float64))
    assert found.tolist() == [exact(value) for value in array.tolist()]


@hypothesis.given(ANGLES, _arrays(ANGLES))
def test_angles_of_points_are_those_of_the_c_library(y: float, x: Array) -> None:
    found = _trig.arctan2(y * np.ones(len(x)), x)
    assert found.tolist() == [math.atan2(y, each) if y or each else 0.0 for each in x.tolist()]
    assert _trig.arctan2(y, 2.0) == math.atan2(y, 2.0)


def test_rounding_does_not_decide_where_a_clearance_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The lid of this trashcan swings both ways: its clearance is the same at two positions."""
    asset = find("trashcan").generate(0, certify=False)
    measured, calls = Hierarchy.distance, itertools.count()
    found = [asset.certify().to_data()]
    for drift in (-1e-15, 1e-15):  # of two equal distances the later or the earlier one is smaller

        def drifting(self: Hierarchy, *pose: Any, drift: float = drift) -> tuple[float, Array]:
            distance, normal = measured(self, *pose)
            return distance * (1.0 + drift * next(calls)), normal

        monkeypatch.setattr(Hierarchy, "distance", drifting)
        found.append(asset.certify().to_data())
    assert any("lid_hinge" in pair["found_at"] for pair in found[0]["pairs"])
    assert found.count(found[0]) == len(found)
