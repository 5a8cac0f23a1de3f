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

from artgen import _portable
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
        (_portable.sin, math.sin, ANGLES),
        (_portable.cos, math.cos, ANGLES),
        (_portable.tan, math.tan, ANGLES),
        (_portable.arctan, math.atan, ANGLES),
        (_portable.arccos, math.acos, SHARES),
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
    found = _portable.arctan2(y * np.ones(len(x)), x)
    assert found.tolist() == [math.atan2(y, each) if y or each else 0.0 for each in x.tolist()]
    assert _portable.arctan2(y, 2.0) == math.atan2(y, 2.0)


def test_rounding_does_not_decide_where_a_clearance_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The lift rod of this faucet has the same clearance near both ends of its way."""
    asset = find("faucet").generate(2, certify=False)
    measured, calls = Hierarchy.distance, itertools.count()
    found = [asset.certify().to_data()]
    for drift in (-1e-15, 1e-15):  # of two equal distances the later or the earlier one is smaller

        def drifting(self: Hierarchy, *pose: Any, drift: float = drift) -> tuple[float, Array]:
            distance, normal = measured(self, *pose)
            return distance * (1.0 + drift * next(calls)), normal

        monkeypatch.setattr(Hierarchy, "distance", drifting)
        found.append(asset.certify().to_data())
    assert any("lift_rod_slide" in pair["found_at"] for pair in found[0]["pairs"])
    assert found.count(found[0]) == len(found)


MATRICES = hypothesis.extra.numpy.arrays(np.float64, (5, 4, 4), elements=st.floats(-3.0, 3.0))


@hypothesis.given(MATRICES)
def test_products_inverses_and_eigenvectors_are_those_of_linear_algebra(matrices: Array) -> None:
    first, second = matrices[0], matrices[1]
    for a, b in ((first, second), (first[0], second), (first, second[0])):
        assert np.allclose(_portable.product(a, b), a @ b, rtol=0.0, atol=1e-12)
    assert math.isclose(_portable.dot(first[0], second[0]), float(first[0] @ second[0]), abs_tol=1e-12)
    assert math.isclose(_portable.norm(first[0]), float(np.linalg.norm(first[0])), abs_tol=1e-12)
    affine = matrices.copy()
    affine[:, :3, :3] += 10.0 * np.eye(3)  # diagonals outweigh the rest, so an inverse exists
    affine[:, 3] = 0.0, 0.0, 0.0, 1.0
    for each in (affine, affine[:, :3, :3], affine[:, :2, :2]):
        assert np.allclose(_portable.inverse(each), np.linalg.inv(each), rtol=0.0, atol=1e-11)
    symmetric = first[:3, :3] + first[:3, :3].T
    values, vectors = _portable.eigenvectors(symmetric)
    assert np.allclose(values, np.linalg.eigvalsh(symmetric), rtol=0.0, atol=1e-12)
    assert np.allclose(vectors * values @ vectors.T, symmetric, rtol=0.0, atol=1e-12)
    assert np.allclose(vectors.T @ vectors, np.eye(3), rtol=0.0, atol=1e-12)
