"""Lists of points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import EvaluationError
from artgen.graph import evaluate
from artgen.nodes.handles import Float
from artgen.nodes.path import arc, line, polyline
from artgen.nodes.vector import X, Y, Z, grid, points, ring_points, row

VECTORS = st.tuples(*[st.integers(-50, 50).map(float)] * 3)


def value(handle, **parameters):
    return evaluate(handle, parameters).value


def test_points_hold_what_they_are_given():
    made = points((0, 0, 0), (Float.parameter("a"), 1, 2), X)
    assert value(made, a=5.0).tolist() == [[0, 0, 0], [5, 1, 2], [1, 0, 0]]


@given(start=VECTORS, step=VECTORS, count=st.integers(1, 20))
def test_row_steps_from_its_start(start, step, count):
    made = value(row(start, step, count))
    assert made.shape == (count, 3)
    assert made[0].tolist() == list(start)
    assert made[-1].tolist() == [a + (count - 1) * b for a, b in zip(start, step, strict=True)]


@given(center=VECTORS, columns=st.integers(1, 6), rows=st.integers(1, 6))
def test_grid_lies_about_its_center_row_by_row(center, columns, rows):
    made = value(grid(center, (2, 0, 0), (0, 0, 3), columns=columns, rows=rows))
    assert made.shape == (columns * rows, 3)
    assert made.mean(axis=0) == pytest.approx(center)
    if columns > 1:
        assert (made[1] - made[0]).tolist() == [2, 0, 0]
    if rows > 1:
        assert (made[columns] - made[0]).tolist() == [0, 0, 3]


@given(center=VECTORS, radius=st.floats(0.1, 10), count=st.integers(2, 12), axis=VECTORS.filter(any))
def test_ring_points_lie_evenly_on_the_circle(center, radius, count, axis):
    made = value(ring_points(center, radius, count=count, axis=axis)) - center
    assert np.linalg.norm(made, axis=1) == pytest.approx(np.full(count, radius))
    assert made @ np.array(axis) == pytest.approx(np.zeros(count), abs=1e-9 * np.linalg.norm(axis))
    assert made.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9)


@pytest.mark.parametrize(("axis", "first", "second"), [(X, (0, 1, 0), (0, 0, 1)), (Z, (1, 0, 0), (0, 1, 0))])
def test_ring_points_run_counter_clockwise(axis, first, second):
    made = value(ring_points((0, 0, 0), 1.0, count=4, axis=axis))
    assert made[0] == pytest.approx(np.array(first, float))
    assert made[1] == pytest.approx(np.array(second, float), abs=1e-12)
    turned = value(ring_points((0, 0, 0), 1.0, count=4, axis=axis, start=np.pi / 2))
    assert turned[0] == pytest.approx(made[1], abs=1e-12)


def test_ring_points_about_y_start_on_x():
    made = value(ring_points((0, 0, 0), 1.0, count=4, axis=Y))
    assert made[0] == pytest.approx(np.array([1.0, 0.0, 0.0]))
    assert np.cross(made[0], made[1]) == pytest.approx(np.array([0.0, 1.0, 0.0]), abs=1e-12)


def test_along_spaces_points_by_length():
    made = value(polyline([(0, 0, 0), (1, 0, 0), (1, 3, 0)]).points(5))
    assert made.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 2, 0], [1, 3, 0]]


def test_a_single_point_lies_in_the_middle():
    assert value(line((0, 0, 0), (0, 0, 4)).points(1)).tolist() == [[0, 0, 2]]


def test_along_a_closed_path_no_point_comes_twice():
    square = polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], closed=True)
    assert value(square.points(4)).tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


def test_along_an_arc_keeps_the_radius():
    made = value(arc((0, 0, 0), 2.0, start=0.0, sweep=3.0).points(7))
    assert np.linalg.norm(made, axis=1) == pytest.approx(np.full(7, 2.0), rel=2e-3)


def test_points_move_and_grow():
    made = row((0, 0, 0), (1, 0, 0), 2)
    assert value(made + (0, 0, 1)).tolist() == [[0, 0, 1], [1, 0, 1]]
    assert value((0, 0, 1) + made).tolist() == [[0, 0, 1], [1, 0, 1]]
    assert value(made - Z).tolist() == [[0, 0, -1], [1, 0, -1]]
    assert value(2 * made).tolist() == value(made * 2).tolist() == [[0, 0, 0], [2, 0, 0]]


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (row(X, Y, 0), "the count of points in a row must be at least 1, got 0"),
        (grid(X, Y, Z, columns=0, rows=1), "the columns of a grid must be at least 1, got 0"),
        (grid(X, Y, Z, columns=1, rows=-1), "the rows of a grid must be at least 1, got -1"),
        (ring_points(X, 1.0, count=0), "the count of points in a ring must be at least 1"),
        (ring_points(X, -1.0, count=3), "radius must be positive, got -1 m"),
        (ring_points(X, 1.0, count=3, axis=(0, 0, 0)), "a vector of length zero has no direction"),
        (line(X, Y).points(0), "the count of points along a path must be at least 1"),
    ],
)
def test_impossible_points_are_refused(made, message):
    with pytest.raises(EvaluationError, match=message):
        value(made)
