"""Convex pieces: what they contain, how they move, what is refused."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.colliders import TOLERANCE, Convex
from colliders.covering import pose

LENGTH = st.floats(0.001, 2.0)
ANGLE = st.floats(-3.2, 3.2)
ROUND = [Convex.cylinder(0.02, 0.1), Convex.sphere(0.03), Convex.capsule(0.01, 0.08)]


def _surface(piece: Convex, count: int = 4000) -> np.ndarray:
    """Sample the surface of a round piece, shape (n, 3)."""
    rng = np.random.default_rng(0)
    ball = rng.normal(size=(count, 3))
    ball /= np.linalg.norm(ball, axis=1)[:, None]
    radius = piece.size[0]
    if piece.kind == "sphere":
        points = radius * ball
    elif piece.kind == "capsule":
        points = radius * ball
        points[:, 2] += np.copysign(piece.size[1] / 2.0, ball[:, 2])
    else:
        ball[:, :2] /= np.linalg.norm(ball[:, :2], axis=1)[:, None]
        points = np.column_stack((radius * ball[:, :2], piece.size[1] / 2.0 * np.sign(ball[:, 2])))
    return points @ piece.pose[:3, :3].T + piece.pose[:3, 3]


@pytest.mark.parametrize("piece", ROUND, ids=lambda piece: piece.kind)
@pytest.mark.parametrize("tolerance", [0.0001, 0.00025, 0.001])
def test_outer_polytope_contains_a_round_piece_within_the_tolerance(piece: Convex, tolerance: float) -> None:
    moved = piece.transformed(pose(0.1, 0.2, 0.3, turn=(0.3, 0.5, 0.7)))
    surface = _surface(moved)
    outer = moved.outer_polytope(tolerance)
    assert outer.contains(surface, 1e-12)
    axis_height = np.abs((outer.points - moved.pose[:3, 3]) @ moved.pose[:3, 2])
    assert (
        axis_height.max() <= np.abs((surface - moved.pose[:3, 3]) @ moved.pose[:3, 2]).max() + 1.5 * tolerance
    )
    directions = surface - moved.pose[:3, 3]
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    gap = (outer.points @ directions.T).max(axis=0) - (surface @ directions.T).max(axis=0)
    assert gap.max() <= 1.5 * tolerance


@pytest.mark.parametrize("piece", ROUND, ids=lambda piece: piece.kind)
def test_inner_points_lie_on_or_in_a_round_piece(piece: Convex) -> None:
    points = piece.inner_polytope(0.0002).points
    outside = piece.outer_polytope(1e-5)
    assert outside.contains(points, 1e-12)
    assert Convex.hull(points).volume > 0.93 * piece.volume


def test_circles_have_at_least_eight_sides() -> None:
    assert len(Convex.cylinder(0.001, 1.0).outer_points(0.1)) == 16


@given(LENGTH, LENGTH, LENGTH, ANGLE, ANGLE, ANGLE)
@settings(max_examples=50, deadline=None)
def test_a_block_of_points_is_a_box(x: float, y: float, z: float, a: float, b: float, c: float) -> None:
    box = Convex.box((x, y, z), pose(1.0, -2.0, 0.5, turn=(a, b, c)))
    found = Convex.hull(box.outer_points())
    assert found.kind == "box"
    assert found.volume == pytest.approx(x * y * z)
    assert found.bounds() == pytest.approx(box.bounds(), abs=1e-9)
    corners = np.sort(np.round(found.outer_points(), 9), axis=0)
    assert corners == pytest.approx(np.sort(np.round(box.outer_points(), 9), axis=0), abs=1e-8)
    assert np.linalg.det(found.pose[:3, :3]) == pytest.approx(1.0)


def test_a_box_that_was_not_turned_has_the_frame_of_the_asset() -> None:
    found = Convex.hull(Convex.box((0.1, 0.2, 0.3), pose(1.0, 2.0, 3.0)).outer_points())
    assert (found.pose[:3, :3] == np.eye(3)).all()
    assert found.size == pytest.approx((0.1, 0.2, 0.3))


def test_a_sheared_block_is_a_hull() -> None:
    matrix = np.eye(4)
    matrix[0, 2] = 0.01
    assert Convex.box((1.0, 1.0, 1.0)).transformed(matrix).kind == "hull"


@pytest.mark.parametrize("piece", [Convex.box((0.1, 0.2, 0.3)), *ROUND], ids=lambda piece: piece.kind)
def test_volume_and_bounds_are_those_of_the_solid(piece: Convex) -> None:
    moved = piece.transformed(pose(0.1, 0.2, 0.3, turn=(0.3, 0.5, 0.7)))
    fine = moved.outer_polytope(1e-6)
    assert moved.volume == pytest.approx(fine.volume, rel=0.015)
    assert moved.bounds() == pytest.approx(fine.bounds, abs=0.0006)
    assert (moved.bounds()[0] >= fine.bounds[0] - 1e-12).all()


@pytest.mark.parametrize("piece", [Convex.box((0.1, 0.2, 0.3)), *ROUND], ids=lambda piece: piece.kind)
def test_rigid_motion_mirror_and_even_scale_keep_the_kind(piece: Convex) -> None:
    matrix = 2.0 * pose(turn=(0.3, -0.2, 1.0)) @ np.diag([1.0, -1.0, 1.0, 1.0])
    matrix[:, 3] = (1.0, 2.0, 3.0, 1.0)
    moved = piece.transformed(matrix)
    assert moved.kind == piece.kind
    assert moved.size == pytest.approx([2.0 * length for length in piece.size])
    assert moved.volume == pytest.approx(8.0 * piece.volume)
    assert np.linalg.det(moved.pose[:3, :3]) == pytest.approx(1.0)
    inside = piece.inner_polytope(TOLERANCE).points @ matrix[:3, :3].T + matrix[:3, 3]
    assert moved.outer_polytope(1e-5).contains(inside, 1e-9)


def test_a_cylinder_stretched_along_its_axis_stays_one() -> None:
    moved = Convex.cylinder(0.1, 0.3).transformed(np.diag([2.0, 2.0, 3.0, 1.0]))
    assert moved.kind == "cylinder"
    assert moved.size == pytest.approx((0.2, 0.9))


def test_a_flattened_cylinder_becomes_a_hull_around_or_within_it() -> None:
    matrix = np.diag([1.0, 2.0, 1.0, 1.0])
    outer = Convex.cylinder(0.1, 0.3).transformed(matrix)
    inner = Convex.cylinder(0.1, 0.3).transformed(matrix, inner=True)
    exact = math.pi * 0.1 * 0.2 * 0.3
    assert outer.kind == inner.kind == "hull"
    assert inner.volume < exact < outer.volume


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Convex.box((1.0, 0.0, 1.0)), r"a box needs 3 positive lengths \[m\], got \(1.0, 0.0, 1.0\)"),
        (lambda: Convex.cylinder(math.nan, 1.0), "a cylinder needs 2 positive lengths"),
        (lambda: Convex.sphere(-1.0), "a sphere needs 1 positive lengths"),
        (lambda: Convex.capsule(1.0, math.inf), "a capsule needs 2 positive lengths"),
        (lambda: Convex.sphere(1.0, np.diag([2.0, 1.0, 1.0, 1.0])), "needs a rigid pose"),
        (lambda: Convex.sphere(1.0).transformed(np.diag([1.0, 1.0, 0.0, 1.0])), "determinant 0"),
    ],
)
def test_impossible_pieces_are_refused(make: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make()  # type: ignore[operator]
