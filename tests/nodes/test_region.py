"""Regions: extents, division, anchors and the box of planned space."""

import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import BuildError, EvaluationError
from artgen.graph import evaluate
from artgen.nodes.handles import Float
from artgen.nodes.region import Region

CASE = Region((-0.2, 0.2), (0.0, 0.3), (0.0, 0.5))
LENGTHS = st.floats(0.01, 0.2)


def spans(region):
    return np.array([region.x, region.y, region.z])


def assert_spans(region, *expected):
    assert spans(region) == pytest.approx(np.array(expected))


def test_a_region_has_sizes_a_center_and_anchors():
    assert CASE.size == pytest.approx((0.4, 0.3, 0.5))
    assert CASE.center == pytest.approx((0.0, 0.15, 0.25))
    assert CASE.anchor(y=-1) == pytest.approx((0.0, 0.0, 0.25))
    assert CASE.anchor(x=1, z=0.5) == pytest.approx((0.2, 0.15, 0.375))
    assert_spans(Region.centered(0.4, 0.2, 0.1), (-0.2, 0.2), (-0.1, 0.1), (-0.05, 0.05))
    assert_spans(Region.between((0, 1, 2), (3, 4, 5)), (0, 3), (1, 4), (2, 5))


def test_sides_move_by_all_by_axis_and_by_name():
    assert_spans(CASE.shrink(0.01), (-0.19, 0.19), (0.01, 0.29), (0.01, 0.49))
    assert_spans(CASE.shrink(0.01, x=0.0, top=0.1), (-0.2, 0.2), (0.01, 0.29), (0.01, 0.4))
    assert_spans(CASE.grow(left=0.1, back=0.2), (-0.3, 0.2), (0.0, 0.5), (0.0, 0.5))
    assert_spans(CASE.shrink(0.01).grow(0.01), *spans(CASE))


def test_a_region_moves_and_has_an_image():
    assert_spans(CASE.at(0.1, z=-0.1), (-0.1, 0.3), (0.0, 0.3), (-0.1, 0.4))
    assert_spans(CASE.at(0.3).mirror(), (-0.5, -0.1), (0.0, 0.3), (0.0, 0.5))


@given(st.integers(1, 6), st.integers(1, 6), st.floats(0.0, 0.02))
def test_cells_of_a_grid_are_equal_apart_by_the_gap_and_in_reading_order(columns, rows, gap):
    cells = CASE.grid(columns, rows, gap)
    assert len(cells) == columns * rows
    for cell in cells:
        assert cell.size == pytest.approx(cells[0].size)
    assert cells[0].x.low == pytest.approx(CASE.x.low)
    assert cells[0].z.high == pytest.approx(CASE.z.high)
    assert cells[-1].x.high == pytest.approx(CASE.x.high)
    assert cells[-1].z.low == pytest.approx(CASE.z.low)
    if columns > 1:
        assert cells[1].x.low - cells[0].x.high == pytest.approx(gap)
    if rows > 1:
        assert cells[0].z.low - cells[columns].z.high == pytest.approx(gap)


@given(LENGTHS, LENGTHS, st.floats(0.0, 0.02))
def test_one_part_of_a_division_takes_the_rest(first, last, gap):
    left, rest, right = CASE.with_(x=(-0.3, 0.3)).across(first, None, last, gap=gap)
    assert left.x.size == pytest.approx(first)
    assert right.x.size == pytest.approx(last)
    assert rest.x.size == pytest.approx(0.6 - first - last - 2 * gap)
    assert (left.x.low, right.x.high) == pytest.approx((-0.3, 0.3))


def test_a_stack_starts_at_the_top_and_depths_at_the_front():
    top, rest = CASE.stack(0.1, None)
    assert_spans(top, CASE.x, CASE.y, (0.4, 0.5))
    assert_spans(rest, CASE.x, CASE.y, (0.0, 0.4))
    front, _ = CASE.deep(0.05, None)
    assert_spans(front, CASE.x, (0.0, 0.05), CASE.z)
    assert [row.z.low for row in CASE.rows(2)] == pytest.approx([0.0, 0.25])
    assert [layer.y.low for layer in CASE.layers(3)] == pytest.approx([0.0, 0.1, 0.2])


@given(st.floats(0.0, 0.002))
def test_regions_around_a_hole_cover_the_region_without_it(lap):
    hole = Region((-0.1, 0.05), (0.0, 0.3), (0.2, 0.3))
    parts = CASE.around(hole, lap=lap)
    solid = evaluate(parts[0].box() | parts[1].box() | parts[2].box() | parts[3].box()).value
    whole = (0.4 * 0.5 - 0.15 * 0.1) * 0.3
    assert solid.manifold.volume() == pytest.approx(whole, abs=lap * 0.3 + 1e-9)


def test_the_outlines_lie_in_place():
    for outline, sizes in ((CASE.front(), (0.4, 0.5)), (CASE.plan(radius=0.01), (0.4, 0.3))):
        points = np.concatenate([ring.points for ring in evaluate(outline).value.contours])
        assert np.ptp(points, axis=0) == pytest.approx(sizes)


def test_a_region_of_handles_is_computed_at_evaluation():
    width = Float.parameter("width")
    box = Region((0, width), (0, width / 2), (0, 0.1)).columns(2)[1].box()
    bounds = evaluate(box, {"width": 0.4}).value.bounds()
    assert bounds == pytest.approx(np.array([[0.2, 0.0, 0.0], [0.4, 0.2, 0.1]]))


def test_the_box_of_an_inverted_region_is_refused():
    with pytest.raises(EvaluationError, match=r"-0\.1 m long along y: the lowest coordinate comes first"):
        evaluate(Region((0, 1), (0.1, 0), (0, 1)).box())


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (
            lambda: CASE.across(None, None),
            "one length of a region may be None and takes the rest, got 2 None",
        ),
        (lambda: CASE.deep(None, 0.1, None), "got 2 None in (None, 0.1, None); give the others as numbers"),
        (lambda: CASE.stack(None, None), "one length of a region may be None"),
        (
            lambda: CASE.across(2, None, gap=0.1),
            "the lengths (2, None) with gaps of 0.1 m are 1.7 m longer than the region, 0.4 m; make them",
        ),
        (lambda: CASE.deep(0.2, 0.2), "are 0.1 m longer than the region, 0.3 m; make them shorter"),
        (lambda: CASE.across("0.1", None), "a length of a region needs a Float, got '0.1'"),
        (lambda: CASE.across(0.1, None, gap="a"), "gap needs a Float, got 'a'"),
        (lambda: CASE.columns(0), "divided into a whole number of parts from 1 on, got 0"),
        (lambda: CASE.grid(0, 2), "divided into a whole number of parts from 1 on, got 0"),
        (lambda: CASE.rows(-1), "divided into a whole number of parts from 1 on, got -1"),
        (lambda: CASE.columns("2"), "divided into a whole number of parts from 1 on, got '2'"),
        (lambda: CASE.layers(2.5), "divided into a whole number of parts from 1 on, got 2.5"),
        (lambda: CASE.columns(Float.parameter("n")), "a handle used as a plain number"),
        (lambda: CASE.shrink("a"), "a distance of shrink needs a Float, got 'a'"),
        (lambda: CASE.shrink(left=math.nan), "a distance of shrink: nan is not a finite number"),
        (lambda: CASE.grow(top="a"), "grow(..., top=...) needs a Float, got 'a'"),
        (lambda: CASE.at("a"), "at(...) of a region needs a Float, got 'a'"),
        (lambda: CASE.with_(x=(0, "a")), "Region(..., x=...) needs a Float, got 'a'"),
        (lambda: CASE.around(3), "around(...) needs the Region of a hole, got 3"),
        (lambda: CASE.anchor(x=2), "anchor(x=2, y=0.0, z=0.0) is not in the region: each share is from -1"),
        (lambda: CASE.anchor(z="top"), "a share of anchor needs a Float, got 'top'"),
    ],
)
def test_a_division_that_is_impossible_is_refused(make, words):
    with pytest.raises(BuildError, match=re.escape(words)) as caught:
        make()
    assert "test_region.py:" in str(caught.value)


def test_lengths_that_vary_are_divided_and_sums_are_rounded():
    width = Float.parameter("width")
    assert len(CASE.across(width, None)) == 2
    assert len(Region((0, 0.3), (0, 1), (0, 1)).across(0.1, 0.1, 0.1)) == 3
