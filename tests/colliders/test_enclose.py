"""Polytopes of few vertices around solids of many."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold
from numpy.typing import NDArray

from artgen.colliders import TOLERANCE, Convex, Exact, cylinder_pieces, difference, hull_pieces, union
from artgen.colliders.enclose import Facets, enclosing, few_vertices
from colliders.covering import drum, excess, joined_manifold, moved, pose, uncovered, vertices

Array = NDArray[np.float64]
FILM = 1e-7
TURNED = pose(0.1, 0.2, 0.3, turn=(0.3, 0.2, 0.1))


def _cloud(seed: int, count: int, roundness: float) -> Array:
    """Return points on an ellipsoid, or nearer to the faces of its bounding box."""
    generator = np.random.default_rng(seed)
    points = generator.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    points = np.sign(points) * np.abs(points) ** roundness
    return points * generator.uniform(0.01, 0.2, 3)


def _egg(size: tuple[float, float, float], sides: int = 40) -> Manifold:
    return Manifold.sphere(1.0, sides).scale(size)


@given(st.integers(0, 10**6), st.integers(20, 400), st.floats(0.2, 1.0), st.sampled_from([16, 32, 64]))
@settings(max_examples=60, deadline=None)
def test_few_faces_contain_all_points(seed: int, count: int, roundness: float, most: int) -> None:
    solid = Facets.hull(_cloud(seed, count, roundness))
    corners, farthest = enclosing(solid, most, TOLERANCE)
    around = Facets.hull(corners)
    assert 8 <= len(corners) <= most
    inside = around.planes[:, :3] @ solid.points.T - around.planes[:, 3:]
    assert inside.max() < FILM
    outside = solid.planes[:, :3] @ corners.T - solid.planes[:, 3:]
    assert outside.max() <= max(farthest, TOLERANCE) + FILM


def test_a_box_of_many_triangles_is_a_box() -> None:
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, 5)] * 3), axis=-1).reshape(-1, 3)
    corners, farthest = enclosing(Facets.hull(grid), 64, TOLERANCE)
    assert len(corners) == 8
    assert farthest < FILM


def test_a_pyramid_of_many_sides_keeps_within_its_vertices() -> None:
    solid = Manifold.cylinder(0.05, 0.04, 0.0, 200)
    corners, _ = enclosing(Facets.hull(vertices(solid)), 64, TOLERANCE)
    assert len(corners) <= 64
    assert uncovered(solid, [Convex.hull(corners)]) < FILM


@given(st.integers(0, 10**6), st.floats(0.2, 1.0))
@settings(max_examples=30, deadline=None)
def test_halves_make_up_the_whole(seed: int, roundness: float) -> None:
    solid = Facets.hull(_cloud(seed, 200, roundness))
    one, two = solid.halves()
    assert one.volume + two.volume == pytest.approx(solid.volume, rel=1e-9)
    assert (one.solid ^ two.solid).volume() < 1e-9 * solid.volume


@pytest.mark.parametrize("size", [(0.008, 0.01, 0.006), (0.02, 0.03, 0.015), (0.033, 0.021, 0.024)])
def test_eggs_of_facets_are_followed(size: tuple[float, float, float]) -> None:
    solid = _egg(size)
    found = few_vertices(Convex.hull(vertices(solid)), 64, TOLERANCE)
    assert len(found) <= 8
    assert all(len(piece.points) <= 64 for piece in found)
    assert uncovered(solid, found) < FILM
    planes = Facets(solid).planes
    farthest = max(float((planes[:, :3] @ piece.points.T - planes[:, 3:]).max()) for piece in found)
    added = joined_manifold(found).volume() / solid.volume() - 1.0
    assert farthest < 0.0007 or (farthest < 0.00125 and added < 0.03)


@pytest.mark.parametrize("flip", [1.0, -1.0])
def test_a_moved_solid_has_the_pieces_of_the_solid(flip: float) -> None:
    matrix = TURNED @ np.diag([flip, 1.0, 1.0, 1.0])
    solid = _egg((0.03, 0.02, 0.025))
    pieces = hull_pieces(vertices(solid))
    found = pieces.transformed(matrix).simplified(TOLERANCE)
    expected = pieces.simplified(TOLERANCE)
    assert len(found) == len(expected) > 1
    for piece, still in zip(found, expected, strict=True):
        np.testing.assert_allclose(piece.points, still.points @ matrix[:3, :3].T + matrix[:3, 3], atol=1e-12)
    assert uncovered(moved(solid, matrix), found) < FILM


def test_a_drilled_egg_of_facets_is_open() -> None:
    solid = _egg((0.03, 0.02, 0.025))
    place = pose(0.004)
    found = difference(hull_pieces(vertices(solid)), cylinder_pieces(0.006, 0.1, place, 32)).simplified(
        TOLERANCE
    )
    assert all(len(piece.points) <= 64 for piece in found)
    assert uncovered(solid - drum(0.006, 0.1, 32, place), found) < FILM
    assert (joined_manifold(found) ^ drum(0.006 - 2.0 * TOLERANCE, 0.1, 64, place)).volume() < 1e-12
    assert excess(solid - drum(0.006, 0.1, 32, place), found) < 0.001


def test_what_a_tool_does_not_reach_stays_whole() -> None:
    egg = vertices(_egg((0.03, 0.02, 0.025)))
    both = union(hull_pieces(egg), hull_pieces(egg + (1.0, 0.0, 0.0)))
    drilled = difference(both, Exact([Convex.box((0.01, 0.01, 0.1), pose(1.0))])).outer(TOLERANCE)
    assert len(drilled[0].points) == len(egg)
    assert all(len(piece.points) <= 64 for piece in drilled[1:])


def test_needles_that_point_inwards_do_not_count_as_faces() -> None:
    rng = np.random.default_rng(0)
    points = rng.normal(size=(300, 3))
    points *= 0.1 / np.linalg.norm(points, axis=1)[:, None]
    solid, sound = Facets.hull(points), Facets.hull(points).planes
    normals, area, corners = solid._across
    turned = (-normals[:1], area[:1], corners[:1, ::-1])
    vars(solid)["_across"] = tuple(map(np.concatenate, zip((normals, area, corners), turned, strict=True)))
    np.testing.assert_array_equal(solid.planes, sound)
    around, farthest = enclosing(solid, 64, 1e-4)
    assert farthest < 0.02
    faces = Facets.hull(around).planes
    assert (points @ faces[:, :3].T <= faces[:, 3] + 1e-9).all(), "the polytope contains the solid"
