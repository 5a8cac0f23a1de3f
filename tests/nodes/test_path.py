import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.graph import FULL
from artgen.nodes import path
from support.shapes import X, Y, Z

CORNERS = (np.zeros(3), np.array([0, 0, 0.1]), np.array([0.2, 0, 0.1]), np.array([0.2, 0.1, 0.0]))


def length(curve):
    points = np.concatenate([curve.points, curve.points[:1]]) if curve.closed else curve.points
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def check_tangents(curve):
    """Assert that tangents are unit and point along the chords beside them."""
    np.testing.assert_allclose(np.linalg.norm(curve.tangents, axis=1), 1.0, atol=1e-9)
    chords = np.diff(curve.points, axis=0)
    chords /= np.linalg.norm(chords, axis=1, keepdims=True)
    for side in (curve.tangents[:-1], curve.tangents[1:]):
        assert np.einsum("ij,ij->i", chords, side).min() > 0.9


def test_a_line_has_its_ends():
    curve = path._line(np.zeros(3), np.array([0, 0, 2.0]))
    assert length(curve) == 2.0
    assert curve.tangents.tolist() == [[0, 0, 1], [0, 0, 1]]


@given(st.floats(0.001, 0.03))
def test_fillets_shorten_a_polyline_and_are_tangent(fillet):
    sharp, rounded = path._polyline(CORNERS, 0.0, False), path._polyline(CORNERS, fillet, False)
    assert sharp.tangents is None
    check_tangents(rounded)
    np.testing.assert_allclose(rounded.points[[0, -1]], sharp.points[[0, -1]])
    turns = [math.acos(0.0), math.acos(0.0)]
    saved = sum(2 * fillet * math.tan(turn / 2) - fillet * turn for turn in turns)
    assert length(rounded) == pytest.approx(length(sharp) - saved, abs=4 * FULL.chord)


def test_a_closed_polyline_has_fillets_at_all_corners():
    square = (np.zeros(3), X, X + Y, Y)
    curve = path._polyline(tuple(0.1 * p for p in square), 0.02, True)
    assert curve.closed
    assert length(curve) == pytest.approx(0.4 - 8 * 0.02 + math.tau * 0.02, rel=1e-2)
    assert np.linalg.norm(curve.points - [0.05, 0.05, 0], axis=1).max() < 0.0707


@given(st.floats(0.01, 1.0), st.floats(-6.2, 6.2).filter(lambda s: abs(s) > 0.01))
def test_an_arc_lies_on_its_circle(radius, sweep):
    center = np.array([0.1, 0.2, 0.3])
    curve = path._arc(center, radius, 0.4, sweep, Y)
    np.testing.assert_allclose(np.linalg.norm(curve.points - center, axis=1), radius)
    np.testing.assert_allclose(curve.points[:, 1], 0.2, atol=1e-12)
    assert length(curve) == pytest.approx(radius * abs(sweep), rel=0.02)
    check_tangents(curve)


def test_a_full_arc_closes():
    curve = path._arc(np.zeros(3), 0.1, 0.0, math.tau, Z)
    assert curve.closed
    assert np.linalg.norm(curve.points[0] - curve.points[-1]) > 1e-3
    np.testing.assert_allclose(curve.points[0], [0.1, 0, 0])


def test_a_bezier_curve_runs_from_end_to_end():
    curve = path._bezier(CORNERS)
    np.testing.assert_allclose(curve.points[[0, -1]], np.array(CORNERS)[[0, -1]], atol=1e-15)
    np.testing.assert_allclose(curve.tangents[0], Z, atol=1e-12)
    check_tangents(curve)


@pytest.mark.parametrize("closed", [False, True])
def test_a_spline_passes_through_its_points_smoothly(closed):
    curve = path._spline(CORNERS, closed)
    for corner in CORNERS:
        assert np.linalg.norm(curve.points - corner, axis=1).min() < 1e-12
    check_tangents(curve)
    assert curve.closed == closed


def test_a_helix_climbs_by_its_pitch():
    curve = path._helix(0.03, 0.01, 3.0, X)
    np.testing.assert_allclose(np.linalg.norm(curve.points[:, 1:], axis=1), 0.03)
    assert np.ptp(curve.points[:, 0]) == pytest.approx(0.03)
    check_tangents(curve)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: path._line(X, X), "needs two different points"),
        (lambda: path._line(X, X * math.nan), "end must be finite"),
        (
            lambda: path._polyline(CORNERS, 0.2, False),
            "fillets at points 0 and 1 .* use a smaller fillet than 0.2 m",
        ),
        (lambda: path._polyline((X, Y, Y), 0.0, False), "points 1 and 2 of the polyline are the same point"),
        (lambda: path._polyline((Z * 0, X, Z * 0), 0.01, False), "turns back on itself at point 1"),
        (lambda: path._arc(X, 0.1, 0.0, 9.0, Z), "sweep must be within 0.001 and 2 pi"),
        (lambda: path._arc(X, 0.1, 0.0, 1.0, Z * 0), "axis must have a direction"),
        (lambda: path._bezier((X, Y)), "at least 3 points, got 2"),
        (lambda: path._spline((X,), False), "at least 2 points, got 1"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
