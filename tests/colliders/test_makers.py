"""Pieces of the solids that constructors make."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import CrossSection, Manifold
from numpy.typing import NDArray

from artgen.asset.shells import TriangleSet
from artgen.colliders import (
    Convex,
    Pieces,
    chain_pieces,
    cylinder_pieces,
    hull_pieces,
    prism_pieces,
    revolve_pieces,
    round_pieces,
)
from colliders.covering import drum, excess, joined_manifold, moved, pose, uncovered, vertices

Array = NDArray[np.float64]
TOLERANCE = 0.00025
FILM = 1e-8
RIG = pose(0.1, 0.2, 0.3, turn=(0.3, 0.2, 0.1))


def circle(radius: float, sides: int = 64) -> Array:
    angle = np.arange(sides) * 2.0 * np.pi / sides
    return radius * np.column_stack((np.cos(angle), np.sin(angle)))


def assert_bracketed(solid: Manifold, pieces: Pieces, tolerance: float = TOLERANCE) -> None:
    outer, inner = pieces.outer(tolerance), pieces.inner(tolerance)
    assert uncovered(solid, outer) < FILM
    assert excess(solid, inner) < FILM
    assert excess(solid, outer) < tolerance
    assert uncovered(solid, inner) < tolerance


@given(st.floats(0.002, 0.2), st.floats(0.005, 0.5), st.sampled_from([12, 16, 20, 24, 32, 48, 64]))
@settings(max_examples=30, deadline=None)
def test_cylinder_is_bracketed(radius: float, length: float, sides: int) -> None:
    pieces = cylinder_pieces(radius, length, RIG, sides)
    mesh = drum(radius, length, sides, RIG)
    inner = pieces.inner(TOLERANCE)
    assert pieces.outer(TOLERANCE)[0].kind == "cylinder"
    assert pieces.outer(TOLERANCE)[0].size == (radius, length)
    assert excess(mesh, inner) < FILM
    assert uncovered(mesh, inner) < TOLERANCE


def test_prism_of_a_profile_with_holes_is_bracketed() -> None:
    contours = [circle(0.1), circle(0.01, 32)[::-1] - (-0.04, 0.0), circle(0.02, 32)[::-1] - (0.04, 0.0)]
    solid = moved(Manifold.extrude(CrossSection(contours), 0.03).translate((0, 0, -0.01)), RIG)
    assert_bracketed(solid, prism_pieces(contours, -0.01, 0.02, RIG))


@pytest.mark.parametrize("sides", [64, 128])
def test_prism_of_many_sides_has_few(sides: int) -> None:
    pieces = prism_pieces([circle(0.02, sides)], 0.0, 0.1)
    solid = Manifold.extrude(CrossSection([circle(0.02, sides)]), 0.1)
    (outer,) = pieces.outer(TOLERANCE)
    (inner,) = pieces.inner(TOLERANCE)
    assert len(outer.points) <= 64
    assert len(inner.points) <= 64
    assert_bracketed(solid, pieces)


def test_prism_of_a_rectangle_is_a_box() -> None:
    contour = np.array([(0.0, 0.0), (0.1, 0.0), (0.1, 0.2), (0.0, 0.2)])
    (piece,) = prism_pieces([contour], 0.0, 0.3).outer(TOLERANCE)
    assert piece.kind == "box"
    assert piece.size == pytest.approx((0.1, 0.2, 0.3))


def test_prism_of_known_polygons_has_one_piece_each() -> None:
    contour = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]) * 0.1
    parts = [
        np.array([(0, 0), (2, 0), (2, 1), (0, 1)]) * 0.1,
        np.array([(0, 1), (1, 1), (1, 2), (0, 2)]) * 0.1,
    ]
    pieces = prism_pieces([contour], 0.0, 0.1, convex=parts)
    assert [piece.kind for piece in pieces.outer(TOLERANCE)] == ["box", "box"]
    assert_bracketed(Manifold.extrude(CrossSection([contour]), 0.1), pieces)


def test_hull_of_a_frustum_is_bracketed() -> None:
    solid = Manifold.cylinder(0.1, 0.05, 0.03, 48)
    assert_bracketed(solid, hull_pieces(vertices(solid)))


def test_sphere_mesh_is_bracketed() -> None:
    solid = Manifold.sphere(0.02, 48)
    pieces = round_pieces(Convex.sphere(0.02), vertices(solid))
    (inner,) = pieces.inner(TOLERANCE)
    assert pieces.outer(TOLERANCE)[0].kind == "sphere"
    assert excess(solid, [inner]) < FILM
    assert uncovered(solid, [inner]) < TOLERANCE
    assert len(inner.points) <= 256


def helix(count: int) -> list[Array]:
    turn = np.linspace(0.0, 2.0 * np.pi, count)
    rings = []
    for angle in turn:
        x = np.array([np.cos(angle), np.sin(angle), 0.0])
        ring = circle(0.005, 12)
        rings.append(0.05 * x + ring[:, :1] * x + ring[:, 1:] * np.array([0.0, 0.0, 1.0]))
    return rings


def ring_mesh(rings: list[Array]) -> Manifold:
    """Return the closed mesh of rings that come back to the first one."""
    return Manifold.revolve(CrossSection([circle(0.005, 12) - (-0.05, 0.0)]), len(rings))


def test_closed_chain_is_bracketed() -> None:
    rings = helix(65)[:-1]
    pieces = chain_pieces(rings, closed=True)
    assert_bracketed(ring_mesh(rings), pieces)
    assert_bracketed(ring_mesh(rings), pieces, 0.001)
    assert len(pieces.outer(0.001)) <= 22


def test_straight_chain_is_one_piece() -> None:
    rings = [np.column_stack((circle(0.01, 12), np.full(12, z))) for z in np.linspace(0.0, 1.0, 9)]
    assert len(chain_pieces(rings).outer(TOLERANCE)) == 1
    assert len(chain_pieces(rings).inner(TOLERANCE)) == 1


@given(st.floats(-1.2, 1.2), st.floats(0.001, 0.05), st.integers(5, 32))
@settings(max_examples=40, deadline=None)
def test_a_link_of_a_chain_is_the_hull_of_its_rings(angle: float, step: float, count: int) -> None:
    ring = np.column_stack((circle(0.01, count), np.zeros(count)))
    turn = np.array([(1, 0, 0), (0, np.cos(angle), -np.sin(angle)), (0, np.sin(angle), np.cos(angle))])
    rings = [ring, ring @ turn.T + (0.0, 0.0, step)]  # the second one may go through the first
    (piece,) = chain_pieces(rings).outer(TOLERANCE)
    hull = Convex.hull(np.concatenate(rings))
    assert piece.volume == pytest.approx(hull.volume, rel=1e-9)
    assert len(piece.points) == len(hull.points)


def test_bent_chain_keeps_its_straight_parts_whole() -> None:
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * 0.005
    low = [np.column_stack((square, np.full(4, z))) for z in (0.0, 0.1, 0.2)]
    high = [
        np.column_stack((square[:, 0] + 0.1 * step, square[:, 1], np.full(4, 0.2 + 0.1 * step)))
        for step in (1, 2)
    ]
    assert len(chain_pieces(low + high).outer(TOLERANCE)) == 2


def test_inner_pieces_of_a_twisted_chain_shrink_from_its_sides_only() -> None:
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * 0.01
    angle = 0.2
    turned = square @ np.array([(np.cos(angle), np.sin(angle)), (-np.sin(angle), np.cos(angle))])
    rings = [np.column_stack((square, np.zeros(4))), np.column_stack((turned, np.full(4, 0.05)))]
    points = np.concatenate(rings)
    sides = [(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i) for i in range(4)]
    outer, inner = chain_pieces(rings).outer(TOLERANCE), chain_pieces(rings).inner(TOLERANCE)
    assert len(outer) == len(inner) == 1
    assert inner[0].bounds()[:, 2] == pytest.approx([0.0, 0.05])
    for a, b, c, d in sides:  # either diagonal of the mesh stays outside
        for middle in ((points[a] + points[c]) / 2.0, (points[b] + points[d]) / 2.0):
            assert inner[0].faces.heights(inner[0].faces.planes).max() < 1e-9
            gap = (inner[0].faces.planes[:, :3] @ middle - inner[0].faces.planes[:, 3]).max()
            assert gap > -1e-9


PROFILES = {
    "ring": [(0.03, 0.0), (0.05, 0.0), (0.05, 0.02), (0.03, 0.02)],
    "knob": [(0.0, 0.0), (0.01, 0.0), (0.01, 0.02), (0.025, 0.025), (0.025, 0.04), (0.0, 0.045)],
    "bowl": [(0.0, 0.0), (0.05, 0.0), (0.1, 0.06), (0.097, 0.06), (0.048, 0.003), (0.0, 0.003)],
    "funnel": [(0.0, 0.0), (0.05, 0.05), (0.05, 0.06)],
    "barrel": [(0.0, 0.0), (0.02, 0.0), (0.025, 0.02), (0.02, 0.04), (0.0, 0.04)],
    "double": [
        (0.0, 0.0),
        (0.04, 0.0),
        (0.04, 0.05),
        (0.03, 0.05),
        (0.03, 0.01),
        (0.02, 0.01),
        (0.02, 0.03),
        (0.0, 0.03),
    ],
}


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("degrees", [360.0, 120.0, 270.0])
def test_turned_solid_is_bracketed(name: str, degrees: float) -> None:
    profile = np.array(PROFILES[name])
    solid = Manifold.revolve(CrossSection([profile]), 32, degrees)
    around = np.arctan2(vertices(solid)[:, 1], vertices(solid)[:, 0])[
        np.hypot(*vertices(solid)[:, :2].T) > 1e-6
    ]
    count = len(np.unique(np.round(around, 6)))
    segments = count if degrees == 360.0 else count - 1
    pieces = revolve_pieces([profile], np.radians(degrees), segments, RIG)
    assert_bracketed(moved(solid, RIG), pieces, 0.0005)


def test_turned_ring_leaves_its_bore_open() -> None:
    pieces = revolve_pieces([np.array(PROFILES["ring"])], mesh_segments=64).outer(TOLERANCE)
    shaft = Manifold.cylinder(0.1, 0.03 - 2.0 * TOLERANCE, circular_segments=64, center=True)
    assert (joined_manifold(pieces) ^ shaft).volume() < 1e-12
    assert len(pieces) <= 32


@given(
    st.floats(0.0001, 0.0012),
    st.floats(0.0, 0.08),
    st.floats(0.05, 0.3),
    st.floats(-0.04, 0.04),
    st.integers(2, 24),
    st.sampled_from([0.00025, 0.0005, 0.001]),
)
@settings(max_examples=20, deadline=None)
@pytest.mark.long
def test_thin_turned_wall_keeps_its_hollow(
    wall: float, neck: float, high: float, swell: float, steps: int, tolerance: float
) -> None:
    share = np.linspace(0.0, 1.0, steps + 1)
    outside = np.column_stack((neck + 0.05 + swell * np.sin(np.pi * share) + 0.03 * share, high * share))
    profile = np.concatenate((outside, outside[::-1] - (wall, 0.0)))
    solid = Manifold.revolve(CrossSection([profile]), 48)
    pieces = revolve_pieces([profile], mesh_segments=48)
    assert uncovered(solid, pieces.outer(tolerance)) < FILM
    beyond = TriangleSet.of(joined_manifold(pieces.outer(tolerance)) - solid)
    assert TriangleSet.of(solid).farthest(beyond.spread(500), outside=True)[0] < 2.0 * tolerance


@pytest.mark.parametrize("wall", [0.0003, 0.0009])
@pytest.mark.parametrize("tolerance", [0.00025, 0.001])
def test_thin_turned_bowl_keeps_its_hollow(wall: float, tolerance: float) -> None:
    turn = np.linspace(0.0, np.pi / 2.0, 16)
    outer = 0.1 * np.column_stack((np.sin(turn), -np.cos(turn)))
    profile = np.concatenate((outer, outer[::-1] * (1.0 - wall / 0.1)))
    pieces = revolve_pieces([profile], mesh_segments=48).outer(tolerance)
    ball = Manifold.sphere(0.1 - wall - 2.0 * tolerance - 0.0005, 48)
    assert (joined_manifold(pieces) ^ ball).volume() < 1e-12


def test_turned_disc_with_a_thin_rim_is_not_filled_to_a_cone() -> None:
    profile = np.array([(0.0, 0.0), (0.05, 0.0), (0.05, 0.0002), (0.01, 0.0004), (0.01, 0.1), (0.0, 0.1)])
    solid = Manifold.revolve(CrossSection([profile]), 48)
    assert_bracketed(solid, revolve_pieces([profile], mesh_segments=48))
    beyond = TriangleSet.of(joined_manifold(revolve_pieces([profile], mesh_segments=48).outer(0.001)) - solid)
    assert TriangleSet.of(solid).farthest(beyond.spread(500), outside=True)[0] < 0.0012


def test_turned_rectangle_is_a_cylinder() -> None:
    profile = np.array([(0.0, 0.1), (0.05, 0.1), (0.05, 0.3), (0.0, 0.3)])
    (piece,) = revolve_pieces([profile], pose=RIG).outer(TOLERANCE)
    assert piece.kind == "cylinder"
    assert piece.size == pytest.approx((0.05, 0.2))
    assert piece.pose[:3, 3] == pytest.approx(RIG[:3, 3] + 0.2 * RIG[:3, 2])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: cylinder_pieces(1.0, 1.0, mesh_sides=2), "at least 3 sides, got 2"),
        (lambda: cylinder_pieces(-1.0, 1.0), "a cylinder needs 2 positive lengths"),
        (lambda: prism_pieces([circle(1.0)], 1.0, 1.0), "bottom below its top, got 1.0 m and 1.0 m"),
        (lambda: chain_pieces([np.zeros((4, 3))]), r"at least 2 rings with equally many points, got \[4\]"),
        (lambda: chain_pieces([np.zeros((4, 3)), np.zeros((5, 3))]), r"equally many points, got \[4, 5\]"),
        (lambda: chain_pieces([np.full((4, 3), np.nan)] * 2), "finite rings"),
        (lambda: revolve_pieces([circle(1.0)]), "must not cross the axis, it reaches r = -1.0 m"),
        (lambda: revolve_pieces([circle(1.0) + 2.0], angle=7.0), "angle within 0 and 2 pi"),
        (lambda: revolve_pieces([]), "finite contours"),
        (lambda: hull_pieces(np.zeros((8, 3))), "lie in one plane"),
    ],
)
def test_impossible_solids_are_refused(make: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make()  # type: ignore[operator]
