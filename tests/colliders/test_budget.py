"""The collider set that a simulator carries: few, small, and never over a cavity."""

import numpy as np
import pytest
from manifold3d import CrossSection, Manifold, OpType

from artgen.colliders import (
    Convex,
    Exact,
    Pieces,
    budgeted,
    cylinder_pieces,
    difference,
    hull_pieces,
    revolve_pieces,
    union,
)
from colliders.covering import block, drum, excess, joined_manifold, pose, uncovered, vertices

FILM = 2e-6
Y_UP = (np.pi / 2.0, 0.0, 0.0)


def box(size: tuple[float, float, float], matrix: np.ndarray | None = None) -> Pieces:
    return Exact([Convex.box(size, pose() if matrix is None else matrix)])


def plain_door() -> Pieces:
    """Return a leaf with three bores, four pockets and nine blocks on it."""
    leaf = box((0.9, 0.04, 2.0), pose(z=1.0))
    for x, z in ((0.38, 1.0), (0.38, 1.1), (0.0, 1.5)):
        leaf = difference(leaf, cylinder_pieces(0.008, 0.1, pose(x, 0.0, z, turn=Y_UP), 16))
    for step in range(4):
        leaf = difference(leaf, box((0.02, 0.01, 0.1), pose(-0.44, 0.02, 0.2 + 0.4 * step)))
    blocks = [box((0.02, 0.05, 0.1), pose(0.3 * (i % 3) - 0.25, 0.04, 0.1 + 0.2 * i)) for i in range(9)]
    return union(leaf, *blocks)


def bored_plate(rows: int, columns: int, radius: float, sides: int = 16) -> tuple[Manifold, Pieces]:
    """Return a plate with a grid of bores 40 mm apart."""
    size = (0.04 * columns + 0.02, 0.04 * rows + 0.02, 0.01)
    places = [
        pose(0.04 * (i - (columns - 1) / 2.0), 0.04 * (j - (rows - 1) / 2.0))
        for i in range(columns)
        for j in range(rows)
    ]
    cutters = Manifold.batch_boolean([drum(radius, 0.1, sides, place) for place in places], OpType.Add)
    solid = block(size, pose()) - cutters
    return solid, difference(
        box(size), union(*(cylinder_pieces(radius, 0.1, place, sides) for place in places))
    )


def one(solid: Pieces, **budget: int) -> tuple[Convex, ...]:
    """Return the pieces of one solid within a budget."""
    (found,) = budgeted([solid], **budget)
    return found


def assert_carried(pieces: tuple[Convex, ...], most_pieces: int = 64, most_vertices: int = 64) -> None:
    assert len(pieces) <= most_pieces
    for piece in pieces:
        if piece.kind == "hull":
            assert 4 <= len(piece.points) <= most_vertices
            assert piece.faces.heights(piece.faces.planes).max() < 1e-7
        assert piece.volume > 0.0


def test_a_door_keeps_its_boxes_and_bores() -> None:
    pieces = one(plain_door())
    assert_carried(pieces)
    assert sum(piece.kind == "box" for piece in pieces) >= 15
    for x, z in ((0.38, 1.0), (0.38, 1.1), (0.0, 1.5)):
        shaft = drum(0.0077, 0.1, 32, pose(x, 0.0, z, turn=Y_UP))
        assert (joined_manifold(pieces) ^ shaft).volume() < 1e-12


def test_over_budget_coarser_bores_are_taken() -> None:
    solid, pieces = bored_plate(2, 3, 0.008)
    assert len(pieces.outer(0.00025)) > 90
    found = one(pieces)
    assert_carried(found)
    assert uncovered(solid, found) < FILM
    shaft = drum(0.007, 0.1, 32, pose(0.0, 0.02))
    assert (joined_manifold(found) ^ shaft).volume() < 1e-12


def test_the_solids_of_most_pieces_become_coarser_first() -> None:
    _, wide = bored_plate(1, 1, 0.02, 64)
    _, narrow = bored_plate(1, 1, 0.005, 64)
    fine = len(narrow.simplified(0.00025))
    assert fine > len(narrow.simplified(0.0005))
    most = len(wide.simplified(0.00025)) + fine - 1
    found = budgeted([narrow, wide], most_pieces=most)
    assert [len(pieces) for pieces in found] == [fine, len(wide.simplified(0.0005))]


def test_a_budget_that_would_seal_holes_is_refused() -> None:
    _, pieces = bored_plate(4, 5, 0.008)
    message = r"needs \d+ convex pieces, \d+ after joining those that seal no cavity; at most 64 are allowed"
    with pytest.raises(ValueError, match=message):
        one(pieces)


def test_a_comb_of_teeth_is_not_closed() -> None:
    teeth = union(*(box((0.002, 0.01, 0.05), pose(0.01 * i)) for i in range(20)))
    with pytest.raises(ValueError, match="at most 8 are allowed"):
        one(teeth, most_pieces=8)


def test_steps_within_a_millimetre_are_joined() -> None:
    stairs = union(*(box((0.01, 0.02, 0.02 + 0.0004 * i), pose(0.01 * i)) for i in range(12)))
    solid = Manifold.batch_boolean(
        [block((0.01, 0.02, 0.02 + 0.0004 * i), pose(0.01 * i)) for i in range(12)], OpType.Add
    )
    found = one(stairs, most_pieces=4)
    assert_carried(found, most_pieces=4)
    assert uncovered(solid, found) < FILM
    assert excess(solid, found) < 0.001


def test_cuts_that_fit_are_joined_and_pieces_within_others_dropped() -> None:
    halves = [box((0.1, 0.1, 0.1), pose(x, y)) for x in (0.0, 0.1) for y in (0.0, 0.1)]
    (found,) = one(union(*halves, box((0.02, 0.02, 0.02))))
    assert found.kind == "box"
    assert found.size == pytest.approx((0.2, 0.2, 0.1))


def test_round_pieces_stay_round() -> None:
    pieces = union(
        cylinder_pieces(0.1, 0.2), Exact([Convex.sphere(0.1, pose(1.0)), Convex.capsule(0.1, 0.2, pose(2.0))])
    )
    assert [piece.kind for piece in one(pieces)] == ["cylinder", "sphere", "capsule"]


@pytest.mark.parametrize("sides", [48, 96, 160])
def test_hulls_of_many_vertices_get_fewer(sides: int) -> None:
    solid = Manifold.cylinder(0.05, 0.1, 0.08, sides)
    found = one(hull_pieces(vertices(solid)))
    assert_carried(found)
    assert uncovered(solid, found) < FILM
    assert excess(solid, found) < 0.0006


def test_a_ball_of_facets_is_enclosed() -> None:
    solid = Manifold.sphere(0.05, 48)
    found = one(hull_pieces(vertices(solid)))
    assert_carried(found)
    assert uncovered(solid, found) < FILM
    assert excess(solid, found) < 0.0015


def test_a_bowl_stays_open() -> None:
    profile = np.array([(0.0, 0.0), (0.05, 0.0), (0.1, 0.06), (0.097, 0.06), (0.048, 0.003), (0.0, 0.003)])
    solid = Manifold.revolve(CrossSection([profile]), 48)
    found = one(revolve_pieces([profile], mesh_segments=48))
    assert_carried(found)
    assert uncovered(solid, found) < FILM
    content = Manifold.cylinder(0.05, 0.046, 0.085, 32).translate((0.0, 0.0, 0.006))
    assert (joined_manifold(found) ^ content).volume() < 1e-12


def test_solids_share_a_budget() -> None:
    _, plate = bored_plate(1, 3, 0.008)
    together = budgeted([plate, plate.transformed(pose(z=1.0)), box((0.1, 0.1, 0.1))])
    assert [len(found) for found in together][2] == 1
    assert sum(map(len, together)) <= 64
    assert 40 <= len(one(plate)) <= 48


def test_the_same_solid_has_the_same_bytes() -> None:
    first, second = one(bored_plate(2, 3, 0.008)[1]), one(bored_plate(2, 3, 0.008)[1])
    assert [piece.points.tobytes() for piece in first] == [piece.points.tobytes() for piece in second]
    assert [piece.pose.tobytes() for piece in first] == [piece.pose.tobytes() for piece in second]


def test_an_impossible_budget_is_refused() -> None:
    with pytest.raises(ValueError, match="at least 1 piece and 8 vertices, got 0 and 64"):
        one(box((1.0, 1.0, 1.0)), most_pieces=0)
    with pytest.raises(ValueError, match="got 64 and 6"):
        one(box((1.0, 1.0, 1.0)), most_vertices=6)
