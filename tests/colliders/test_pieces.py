"""Pieces of combined solids: outer ones contain the solid, inner ones lie within it, cavities stay open."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold

from artgen.colliders import Convex, Exact, Pieces, cylinder_pieces, difference, intersection, union
from colliders.covering import block, drum, excess, joined_manifold, moved, pose, uncovered

FILM = 2e-6
"""How thick a film may be left over by dropped slivers [m]."""

TOLERANCE = 0.00025
Y_UP = (np.pi / 2.0, 0.0, 0.0)


@dataclass
class Solid:
    """A manifold and its pieces, combined in step."""

    manifold: Manifold
    pieces: Pieces

    def __or__(self, other: "Solid") -> "Solid":
        return Solid(self.manifold + other.manifold, union(self.pieces, other.pieces))

    def __sub__(self, other: "Solid") -> "Solid":
        return Solid(self.manifold - other.manifold, difference(self.pieces, other.pieces))

    def __and__(self, other: "Solid") -> "Solid":
        return Solid(self.manifold ^ other.manifold, intersection(self.pieces, other.pieces))

    def transformed(self, matrix: np.ndarray) -> "Solid":
        return Solid(moved(self.manifold, matrix), self.pieces.transformed(matrix))


def box(size: tuple[float, float, float], matrix: np.ndarray | None = None) -> Solid:
    where = pose() if matrix is None else matrix
    return Solid(block(size, where), Exact([Convex.box(size, where)]))


def cylinder(radius: float, length: float, matrix: np.ndarray | None = None, sides: int = 16) -> Solid:
    where = pose() if matrix is None else matrix
    return Solid(drum(radius, length, sides, where), cylinder_pieces(radius, length, where, sides))


def assert_bracketed(solid: Solid, tolerance: float = TOLERANCE) -> None:
    """The solid lies between its inner and outer pieces, which are convex, closed and positive."""
    outer, inner = solid.pieces.outer(tolerance), solid.pieces.inner(tolerance)
    for piece in (*outer, *inner):
        shape = piece.faces
        assert shape.heights(shape.planes).max() < 1e-7
        assert shape.volume > 0.0
    if solid.manifold.is_empty():
        return
    assert uncovered(solid.manifold, outer) < FILM
    if inner:
        assert excess(solid.manifold, inner) < FILM


def test_a_bore_leaves_a_shaft_room() -> None:
    plate = box((0.2, 0.04, 0.3)) - cylinder(0.008, 0.1, pose(0.02, 0.0, 0.05, turn=Y_UP))
    assert_bracketed(plate)
    pieces = plate.pieces.outer(TOLERANCE)
    shaft = drum(0.008 - TOLERANCE, 0.1, 64, pose(0.02, 0.0, 0.05, turn=Y_UP))
    assert (joined_manifold(pieces) ^ shaft).volume() < 1e-12
    assert len(pieces) == 16
    assert excess(plate.manifold, pieces) < TOLERANCE


def test_a_window_leaves_four_boxes() -> None:
    frame = box((1.0, 0.05, 2.0)) - box((0.8, 0.1, 1.8))
    pieces = frame.pieces.outer(TOLERANCE)
    assert [piece.kind for piece in pieces] == ["box"] * 4
    assert sum(piece.volume for piece in pieces) == pytest.approx(frame.manifold.volume())
    assert all((piece.pose[:3, :3] == np.eye(3)).all() for piece in pieces)


def test_an_open_cabinet_is_five_boxes() -> None:
    cabinet = box((0.6, 0.5, 0.9)) - box((0.56, 0.5, 0.86), pose(0.0, -0.02, 0.0))
    pieces = cabinet.pieces.outer(TOLERANCE)
    assert [piece.kind for piece in pieces] == ["box"] * 5
    assert_bracketed(cabinet)


def test_a_pocket_cut_by_two_abutting_boxes_is_put_together() -> None:
    halves = box((0.1, 0.02, 0.1), pose(-0.05)) | box((0.1, 0.02, 0.1), pose(0.05))
    whole = box((0.2, 0.02, 0.1))
    body = box((0.4, 0.02, 0.4))
    assert len((body - halves).pieces.outer(TOLERANCE)) <= len((body - whole).pieces.outer(TOLERANCE)) + 1


def test_a_cylinder_cut_square_stays_cylinders() -> None:
    rod = cylinder(0.01, 0.2) - box((0.1, 0.1, 0.02), pose(0.0, 0.0, 0.03))
    pieces = rod.pieces.outer(TOLERANCE)
    assert [piece.kind for piece in pieces] == ["cylinder", "cylinder"]
    assert sum(piece.size[1] for piece in pieces) == pytest.approx(0.18)
    assert_bracketed(rod)


def test_a_cylinder_within_a_box_is_itself() -> None:
    kept = cylinder(0.01, 0.2) & box((1.0, 1.0, 1.0))
    shorter = cylinder(0.01, 0.2) & box((1.0, 1.0, 0.1))
    assert kept.pieces.outer(TOLERANCE)[0].size == (0.01, 0.2)
    assert shorter.pieces.outer(TOLERANCE)[0].kind == "cylinder"
    assert shorter.pieces.outer(TOLERANCE)[0].size == pytest.approx((0.01, 0.1))


def test_pieces_that_a_cutter_only_touches_are_kept() -> None:
    first = box((0.1, 0.1, 0.1))
    beside = box((0.1, 0.1, 0.1), pose(0.1))
    cut = (first - beside).pieces.outer(TOLERANCE)
    assert cut == first.pieces.outer(TOLERANCE)
    assert (first & beside).pieces.outer(TOLERANCE) == ()


def test_a_piece_that_a_cutter_swallows_is_gone() -> None:
    assert (box((0.1, 0.1, 0.1)) - box((0.1, 0.1, 0.1))).pieces.outer(TOLERANCE) == ()


def test_cutting_with_a_tube_leaves_its_core() -> None:
    tube = cylinder(0.03, 0.2) - cylinder(0.02, 0.3)
    groove = box((0.1, 0.1, 0.1)) - tube
    assert_bracketed(groove)
    core = drum(0.019, 0.1, 16, pose())
    assert (core - joined_manifold(groove.pieces.outer(TOLERANCE))).volume() < 1e-12
    assert excess(groove.manifold, groove.pieces.outer(TOLERANCE)) < TOLERANCE


def test_transforms_keep_primitives_and_containment() -> None:
    rig = pose(0.1, 0.2, 0.3, turn=(0.3, 0.2, 0.1))
    body = (box((0.1, 0.2, 0.3)) - cylinder(0.02, 0.5)) | cylinder(0.03, 0.1, pose(0.2))
    for matrix in (
        rig,
        2.0 * rig + np.diag([0, 0, 0, -1.0]),
        np.diag([-1.0, 1.0, 1.0, 1.0]),
        np.diag([1, 2, 3, 1.0]),
    ):
        changed = body.transformed(matrix)
        assert_bracketed(changed)
    assert body.transformed(rig).transformed(rig).pieces.outer(TOLERANCE)[-1].kind == "cylinder"


def test_scaled_pieces_are_finer_where_they_must_be() -> None:
    bored = box((0.2, 0.2, 0.2)) - cylinder(0.05, 1.0, sides=64)
    matrix = np.diag([4.0, 4.0, 4.0, 1.0])
    scaled = bored.transformed(matrix)
    assert excess(scaled.manifold, scaled.pieces.outer(0.001)) < 0.001
    assert len(scaled.pieces.outer(0.001)) > len(bored.pieces.outer(0.001))


LENGTHS = st.floats(0.02, 0.3)
PLACES = st.floats(-0.1, 0.1)
TURNS = st.sampled_from([0.0, 0.0, np.pi / 2.0, 0.4])


@st.composite
def primitives(draw: Callable[..., float]) -> Solid:
    where = pose(draw(PLACES), draw(PLACES), draw(PLACES), turn=(draw(TURNS), draw(TURNS), 0.0))
    if draw(st.booleans()):
        return cylinder(draw(LENGTHS) / 2.0, draw(LENGTHS), where, draw(st.sampled_from([12, 16, 24])))
    return box((draw(LENGTHS), draw(LENGTHS), draw(LENGTHS)), where)


TREES = st.recursive(
    primitives(),
    lambda inner: st.tuples(inner, inner, st.sampled_from("|-&")).map(
        lambda t: t[0] | t[1] if t[2] == "|" else t[0] - t[1] if t[2] == "-" else t[0] & t[1]
    ),
    max_leaves=4,
)


@given(TREES)
@settings(max_examples=40, deadline=None)
def test_random_trees_are_bracketed(solid: Solid) -> None:
    assert_bracketed(solid, 0.001)


@given(TREES)
@settings(max_examples=10, deadline=None)
def test_the_same_tree_has_the_same_bytes(solid: Solid) -> None:
    def data(pieces: tuple[Convex, ...]) -> list[tuple[str, bytes, tuple[float, ...], bytes]]:
        return [(piece.kind, piece.pose.tobytes(), piece.size, piece.points.tobytes()) for piece in pieces]

    again = union(solid.pieces.transformed(np.eye(4)))
    assert data(again.outer(0.001)) == data(solid.pieces.transformed(np.eye(4)).outer(0.001))


def test_results_are_computed_once_for_each_tolerance() -> None:
    asked: list[float] = []

    def outer(tolerance: float) -> tuple[Convex, ...]:
        asked.append(tolerance)
        return (Convex.sphere(0.1),)

    pieces = Pieces(outer, outer)
    assert pieces.outer(0.001) is pieces.outer(0.001)
    pieces.outer(0.002)
    assert asked == [0.001, 0.002]


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan"), float("inf")])
def test_a_tolerance_must_be_positive(tolerance: float) -> None:
    with pytest.raises(ValueError, match="tolerance of convex pieces must be positive, got"):
        Exact([Convex.sphere(1.0)]).outer(tolerance)


def test_a_transform_must_be_finite_and_keep_volume() -> None:
    pieces = Exact([Convex.sphere(1.0)])
    with pytest.raises(ValueError, match=r"finite matrix of shape \(4, 4\)"):
        pieces.transformed(np.full((4, 4), np.nan))
    with pytest.raises(ValueError, match="flattens"):
        pieces.transformed(np.diag([0.0, 0.0, 0.0, 1.0]))


@pytest.mark.parametrize("radius", [0.0038, 0.0052, 0.010])
def test_no_part_around_a_hole_is_thinner_than_half_a_millimetre(radius: float) -> None:
    plate = box((0.026, 0.008, 0.026)) - cylinder(radius, 0.02, pose(turn=Y_UP))
    assert_bracketed(plate)
    pieces = plate.pieces.outer(TOLERANCE)
    assert min(piece.faces.width for piece in pieces) >= 0.0005
    assert joined_manifold(pieces).volume() == pytest.approx(plate.manifold.volume(), rel=1e-3)


def test_a_thin_solid_keeps_its_thin_parts() -> None:
    sheet = box((0.05, 0.0003, 0.05)) - cylinder(0.01, 0.02, pose(turn=Y_UP))
    assert_bracketed(sheet)
    pieces = sheet.pieces.outer(TOLERANCE)
    assert sum(piece.volume for piece in pieces) == pytest.approx(joined_manifold(pieces).volume())
