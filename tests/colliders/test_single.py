"""One piece around each solid: few vertices, nothing left out, neighbors joined first."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.asset.collision import closed_mesh, connected_parts
from artgen.colliders import TOLERANCE, Convex
from artgen.colliders.coacd import fewest, single_hull
from artgen.colliders.polytope import hull_triangles
from colliders.covering import block, drum, pose
from support.trays import tray


def test_a_large_hull_is_the_same_each_time():
    points = np.random.default_rng(1293).normal(size=(4000, 3))
    points /= 10.0 * np.linalg.norm(points, axis=1, keepdims=True)
    hulls = [hull_triangles(points) for _ in range(25)]
    assert len({(vertices.tobytes(), triangles.tobytes()) for vertices, triangles, _ in hulls}) == 1
    assert len({single_hull(points).points.tobytes() for _ in range(5)}) == 1


@settings(max_examples=15)
@given(st.integers(0, 10_000), st.sampled_from([5, 60, 64, 65, 200, 2000]))
def test_a_hull_has_few_vertices_and_contains_the_points(seed, count):
    points = np.random.default_rng(seed).normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    piece = single_hull(0.1 * points)
    assert len(piece.points) <= 64
    assert piece.faces.contains(0.1 * points, 1e-9)
    assert single_hull(0.1 * points[::-1]).points.tobytes() == piece.points.tobytes()


def test_few_points_are_their_own_hull():
    corners = np.random.default_rng(0).normal(size=(40, 3))
    piece = single_hull(corners)
    assert {tuple(point) for point in np.round(piece.points, 9)} <= {
        tuple(point) for point in np.round(corners, 9)
    }
    with pytest.raises(ValueError, match="lie in one plane"):
        single_hull(corners * (1, 1, 0))


def boxes(*places):
    return [Convex.box((1, 1, 1), pose(*place)) for place in places]


def test_neighbors_are_joined_first():
    joined = fewest(boxes((0, 0, 0), (9, 0, 0), (1.1, 0, 0), (10.5, 0, 0)), 2)
    assert [group for _, group in joined] == [(0, 2), (1, 3)]
    assert [piece.volume for piece, _ in joined] == pytest.approx([2.1, 2.5])


def test_enough_are_left_alone():
    pieces = boxes((0, 0, 0), (0.5, 0, 0))
    assert [(piece is pieces[number], group) for number, (piece, group) in enumerate(fewest(pieces, 2))] == [
        (True, (0,)),
        (True, (1,)),
    ]
    assert fewest([], 3) == []


def test_all_become_one_around_round_pieces():
    ball = Convex.sphere(1.0, pose(5, 0, 0))
    ((piece, group),) = fewest([*boxes((0, 0, 0)), ball], 1)
    assert group == (0, 1)
    assert len(piece.points) <= 64
    assert piece.faces.contains(ball.inner_polytope(TOLERANCE).points, 1e-6)


def test_parts_that_do_not_touch_are_told_apart_with_their_hollows():
    crate = block((1, 1, 1), pose()) - block((0.5, 0.5, 0.5), pose())
    ring = drum(0.3, 0.2, 32, pose(3)) - drum(0.2, 0.3, 32, pose(3))
    crumb = block((5e-6, 5e-6, 5e-6), pose(5))
    small, large = connected_parts(crate + ring + crumb)
    assert small.volume() == pytest.approx(ring.volume())
    assert large.volume() == pytest.approx(1 - 0.125)
    assert small.genus() == 1


def test_a_closed_mesh_has_each_point_once():
    lid = tray.generate(certify=False).link("lid").pieces[0].shape.manifold
    assert lid.to_mesh64().vert_properties.shape[0] == 24  # for their normals
    vertices, triangles = closed_mesh(lid)
    assert vertices.shape == (8, 3)
    assert triangles.shape == (12, 3)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    assert (np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)[1] == 2).all()
