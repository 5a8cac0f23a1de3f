import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType
from trimesh.triangles import closest_point

import artgen
from artgen.asset.collision import link_parts
from artgen.asset.shells import TriangleSet, winding_number
from artgen.catalog import find
from artgen.colliders import Convex
from artgen.graph.kernel import DETAILS
from artgen.validate.colliders import FACETS, fidelity


def placed(*center):
    pose = np.eye(4)
    pose[:3, 3] = center
    return pose


def tray():
    """An open box of 100 x 100 x 50 mm with walls of 5 mm, and the five boxes that it is made of."""
    floor = [((0.1, 0.1, 0.005), (0, 0, 0.0025))]
    sides = [((0.005, 0.1, 0.05), (x, 0, 0.025)) for x in (0.0475, -0.0475)]
    ends = [((0.1, 0.005, 0.05), (0, y, 0.025)) for y in (0.0475, -0.0475)]
    inside = Manifold.cube((0.09, 0.09, 0.05), center=True).translate((0, 0, 0.03))
    solid = Manifold.cube((0.1, 0.1, 0.05), center=True).translate((0, 0, 0.025)) - inside
    return solid, [Convex.box(size, placed(*center)) for size, center in (*floor, *sides, *ends)]


def test_exact_pieces_are_faithful():
    solid, pieces = tray()
    found = fidelity(solid, pieces)
    assert found.volume_error == pytest.approx(0.0, abs=1e-9)
    assert found.surface_error == pytest.approx(0.0, abs=1e-8)
    assert found.interior_kept == pytest.approx(1.0)
    assert (found.pieces, found.vertices) == (5, 40)


def test_a_lid_over_a_hollow_is_seen():
    solid, _ = tray()
    found = fidelity(solid, [Convex.box((0.1, 0.1, 0.05), placed(0, 0, 0.025))])
    assert found.interior_kept == pytest.approx(0.0, abs=1e-9)
    assert found.volume_error == pytest.approx(0.09 * 0.09 * 0.045 / solid.volume())
    assert found.added == found.volume_error
    assert found.sticks_out == 0.0
    # the middle of the lid is 45 mm from the walls, as from the floor
    assert 0.041 < found.surface_error <= 0.045


def test_a_filled_hollow_without_an_opening_is_seen():
    wall = Manifold.cube((0.1, 0.1, 0.1), center=True) - Manifold.cube((0.08, 0.08, 0.08), center=True)
    found = fidelity(wall, [Convex.box((0.1, 0.1, 0.1))])
    assert found.interior_kept == pytest.approx(0.0, abs=1e-9)


def test_no_part_of_a_hollow_is_lost_where_pieces_meet_the_hull():
    link = find("fan").generate(248, certify=False).link("blades")
    solid = Manifold.compose([part.solid for part in link_parts(link)])
    found = fidelity(solid, [each.convex for each in link.colliders])
    assert found.interior_kept > 0.99


def test_a_missing_piece_is_measured_where_it_is():
    solid, pieces = tray()
    found = fidelity(solid, pieces[:1] + pieces[2:])
    # the middle of its upper edge is 45 mm from the floor and from the walls beside it
    assert 0.041 < found.sticks_out <= 0.045
    assert found.surface_error == found.sticks_out
    assert found.interior_kept == pytest.approx(1.0)
    assert found.place[0] >= 0.045
    assert found.place == pytest.approx((0.0475, 0.0, 0.05), abs=0.004)
    assert found.volume_error == pytest.approx(0.005 * 0.09 * 0.045 / solid.volume())
    assert found.added == pytest.approx(0.0, abs=1e-9)


def test_round_pieces_are_compared_as_round():
    radius, length = 0.02, 0.1
    solid = Manifold.cylinder(length, radius, circular_segments=256, center=True)
    found = fidelity(solid, [Convex.cylinder(radius, length)])
    assert found.vertices == 0
    assert 0.0 < found.volume_error < 2e-3
    assert found.surface_error < 3e-5
    bumped = fidelity(solid, [Convex.cylinder(radius + 0.001, length)])
    assert bumped.surface_error == pytest.approx(0.001, rel=0.05)


def test_facets_are_those_of_the_levels_of_detail():
    assert {name: level.chord for name, level in DETAILS.items()} == FACETS


def test_what_is_empty_between_facets_and_a_round_surface_is_no_hollow():
    # a disc with a lip beside it, at low detail: nearly all that the hull adds is before its facets
    radius, height = 0.016, 0.008
    disc = Manifold.cylinder(height, radius, circular_segments=12, center=True)
    lip = Manifold.cube((0.008, 0.012, 0.004), center=True).translate((radius, 0, 0))
    pieces = [Convex.cylinder(radius, height), Convex.box((0.008, 0.012, 0.004), placed(radius, 0, 0))]
    assert fidelity(disc + lip, pieces).interior_kept < 0.8
    assert fidelity(disc + lip, pieces, facets=0.0008).interior_kept > 0.99
    # a slot in it that a collider fills is one still
    slot = Manifold.cube((0.02, 0.003, 0.02), center=True)
    assert fidelity((disc - slot) + lip, pieces, facets=0.0008).interior_kept < 0.8


def test_films_between_pieces_that_touch_are_nothing():
    solid = Manifold.cube((0.1, 0.1, 0.1), center=True)
    halves = [Convex.box((0.05 - 1e-10, 0.1, 0.1), placed(x, 0, 0)) for x in (-0.025, 0.025)]
    found = fidelity(solid, halves)
    assert found.sticks_out < 1e-9
    assert found.surface_error < 1e-8


def test_films_of_pieces_in_the_solid_stand_off_nothing():
    # rounding leaves them where two solids share a face: thin, with surfaces deep within the union of both
    film = Manifold.cube((1e-12, 0.05, 0.05), center=True)
    solid = Manifold.cube((0.1, 0.1, 0.1), center=True)
    assert TriangleSet.of(solid).farthest(TriangleSet.of(film).spread(300), outside=True)[0] == 0.0
    assert TriangleSet.of(solid).farthest(TriangleSet.of(film).spread(300))[0] > 0.045
    hollow = solid - Manifold.cube((0.08, 0.08, 0.08), center=True)
    assert TriangleSet.of(hollow).farthest(np.zeros((1, 3)), outside=True)[0] == pytest.approx(0.04)


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=30, deadline=None)
def test_points_are_within_a_solid_where_it_says(seed):
    draw = np.random.default_rng(seed)
    solid = Manifold.cube((0.2, 0.1, 0.1), center=True) - Manifold.cube((0.1, 0.05, 0.2), center=True)
    faces = TriangleSet.of(solid)
    for point in draw.uniform(-0.12, 0.12, size=(20, 3)):
        block = (np.abs(point) < (0.1, 0.05, 0.05)).all()
        assert (winding_number(faces.corners, point) > 0.5) == (
            block and not (np.abs(point[:2]) < (0.05, 0.025)).all()
        )


def test_a_box_with_a_bevel_has_no_hollow():
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * 0.05
    solid = Manifold.hull_points(np.concatenate([corners * s for s in ((1, 1, 0.99), (0.99, 1, 1))]))
    assert fidelity(solid, [Convex.box((0.1, 0.1, 0.1))]).interior_kept == 1.0


@settings(max_examples=25, deadline=None)
@given(
    st.lists(st.tuples(*[st.floats(-0.2, 0.2)] * 3), min_size=1, max_size=40),
    st.tuples(*[st.floats(0.01, 0.2)] * 3),
)
def test_the_farthest_point_from_a_box_is_as_far_as_geometry_says(points, size):
    solid = Manifold.cube(size, center=True)
    points = np.array(points)
    outside = np.maximum(np.abs(points) - np.array(size) / 2, 0.0)
    inside = np.maximum((np.abs(points) - np.array(size) / 2).max(axis=1), -1.0)
    expected = np.where(inside > 0.0, np.linalg.norm(outside, axis=1), -inside)
    distance, place = TriangleSet.of(solid).farthest(points)
    assert distance == pytest.approx(expected.max(), abs=2e-8)
    assert np.abs(points - place).sum(axis=1).min() < 1e-7


def test_spread_points_lie_on_the_surface_and_cover_it():
    faces = TriangleSet.of(Manifold.cube((0.2, 0.1, 0.05), center=True))
    points = faces.spread(400)
    assert faces.farthest(points)[0] < 1e-9
    # as many on a side as its area says: each of 0.2 x 0.1 has 2/7 of the whole
    top = np.isclose(points[36:, 2], 0.025).mean()
    assert top == pytest.approx(2 / 7, abs=0.02)
    assert np.array_equal(points, faces.spread(400))


@given(st.integers(0, 2**32 - 1), st.integers(1, 40))
@settings(max_examples=30, deadline=None)
def test_the_farthest_point_is_that_of_all_triangles(seed, count):
    draw = np.random.default_rng(seed)
    # long and short triangles, so that the nearest one is often not that of the nearest corner
    corners = draw.normal(size=(count, 3, 3)) * draw.choice([0.1, 1.0, 10.0], size=(count, 1, 1))
    points = draw.normal(size=(300, 3)) * 3.0
    away, place = TriangleSet(corners).farthest(points)
    each = [
        np.linalg.norm(closest_point(corners, np.tile(point, (count, 1))) - point, axis=1).min()
        for point in np.round(points, 8)
    ]
    assert away == pytest.approx(max(each), rel=1e-9)
    assert np.abs(points[int(np.argmax(each))] - place).max() < 1e-7


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=50, deadline=None)
def test_what_sticks_out_does_not_depend_on_the_other_pieces(seed):
    draw = np.random.default_rng(seed)
    solid = Manifold.cube((0.1, 0.1, 0.1), center=True)
    # a piece short of the solid's top, among long and thin ones below it
    short = float(draw.uniform(0.001, 0.05))
    pieces = [Convex.box((0.1, 0.1, 0.1 - short), placed(0.0, 0.0, -short / 2))]
    for _ in range(6):
        center = draw.normal(size=3) * 0.2
        center[2] = -0.3 - abs(center[2])
        size = draw.choice([0.01, 0.1, 0.4], size=3)
        pieces.append(Convex.box(tuple(size), placed(*center)))
    draw.shuffle(pieces)
    found = fidelity(solid, pieces)
    assert found.sticks_out == pytest.approx(short, abs=1e-7)
    assert found.place[2] == pytest.approx(0.05)


@pytest.mark.parametrize(("category", "seed"), [("soap_dispenser", 244), ("pepper_grinder", 183)])
def test_shells_turned_inside_out_are_no_part_of_a_difference(category, seed) -> None:
    """manifold3d adds what is in neither solid to the difference of these."""
    link = artgen.generate(category, seed=seed, certify=False).links[0]
    solid = Manifold.batch_boolean([p.shape.manifold for p in link.pieces if not p.visual], OpType.Add)
    found = fidelity(solid, [collider.convex for collider in link.colliders])
    assert found.sticks_out < 2e-5
