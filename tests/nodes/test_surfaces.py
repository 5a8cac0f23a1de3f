import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.asset.shape import Contour
from artgen.colliders import Exact
from artgen.graph import FULL
from artgen.nodes import validators as inputs
from artgen.nodes.contours import circle_contour, faceted, reversed_contour, rounded_polygon
from artgen.nodes.surfaces import Rail, bevel_steps, extrusion, lathe, mitres, rounded_box, sides_of

SQUARE = np.array([[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]])


@given(st.floats(1e-4, 3.0))
def test_facets_of_a_circle_stay_near_it_within_their_limits(radius):
    sides = sides_of(radius)
    assert 12 <= sides <= 64
    assert sides % 4 == 0
    error = radius * (1.0 - math.cos(math.pi / sides))
    assert error <= FULL.chord + 1e-12 or sides == 64


def test_small_round_things_have_few_facets():
    assert sides_of(0.0005) == 12
    assert sides_of(0.005) == 16
    assert sides_of(1.0) == 64
    assert [bevel_steps(bevel) for bevel in (0.0, 0.001, 0.005, 0.02)] == [0, 2, 4, 6]


def test_a_rail_doubles_corners_and_the_seam_only():
    corners = Rail.along(faceted(SQUARE))
    assert corners.vertex.tolist() == [0, 1, 1, 2, 2, 3, 3, 0]
    assert corners.distance[[0, -1]].tolist() == pytest.approx([0.0, 0.8])
    smooth = Rail.along(circle_contour(0.1, 12))
    assert smooth.vertex.tolist() == [*range(12), 0]


@pytest.mark.parametrize("steps", [0, 1, 2, 3])
def test_the_table_of_a_box_joins_exactly_the_vertices_at_one_place(steps):
    skin = rounded_box(np.array([0.3, 0.5, 0.7]), 0.02 if steps else 0.0, steps)
    places, group = np.unique(np.round(skin.vertices, 9), axis=0, return_inverse=True)
    assert len(np.unique(skin.targets)) == len(places)
    np.testing.assert_array_equal(group.ravel(), group.ravel()[skin.targets])
    np.testing.assert_array_equal(skin.targets[skin.targets], skin.targets)


@pytest.mark.parametrize(
    "skin",
    [
        extrusion([faceted(SQUARE)], 0.1, bevel=0.01),
        extrusion([circle_contour(0.1), reversed_contour(circle_contour(0.05))], 0.1, bevel=0.005),
        lathe([faceted(np.array([[0.0, -0.1], [0.1, -0.1], [0.0, 0.1]]))]),
        lathe([faceted(SQUARE + np.array([0.2, 0.0]))], angle=2.0),
    ],
)
def test_targets_are_the_places(skin):
    _, group = np.unique(np.round(skin.vertices, 9), axis=0, return_inverse=True)
    used = np.unique(skin.triangles)
    np.testing.assert_array_equal(group.ravel()[used], group.ravel()[skin.targets[used]])
    shape = skin.shape(Exact(()))
    assert shape.manifold.num_vert() == len(np.unique(group.ravel()[used]))


def test_a_mitre_moves_sides_by_one():
    contour = faceted(SQUARE)
    np.testing.assert_allclose(contour.points + 0.01 * mitres(contour), SQUARE * 1.1, atol=1e-12)


def test_rounded_corners_are_tangent_to_the_sides():
    contour = rounded_polygon(SQUARE, [0.02, 0.0, 0.03, 0.01])
    np.testing.assert_allclose(np.linalg.norm(contour.normals_in, axis=1), 1.0)
    sides = np.roll(contour.points, -1, axis=0) - contour.points
    long_sides = np.linalg.norm(sides, axis=1) > 0.05
    along = sides[long_sides] / np.linalg.norm(sides[long_sides], axis=1, keepdims=True)
    np.testing.assert_allclose(np.einsum("ij,ij->i", along, contour.normals_out[long_sides]), 0.0, atol=1e-9)


def test_a_concave_corner_is_rounded_towards_its_outside():
    points = np.array([[0, 0], [3, 0], [3, 2], [1.5, 2], [1.5, 1], [0, 1]], float)
    contour = rounded_polygon(points, [0, 0, 0, 0, 0.2, 0])
    arc = contour.points[4:-1]
    center = np.array([1.3, 1.2])
    np.testing.assert_allclose(np.linalg.norm(arc - center, axis=1), 0.2, atol=1e-12)
    np.testing.assert_allclose(contour.normals_in[4:-1], (center - arc) / 0.2, atol=1e-12)


@given(st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 1e-3))
def test_a_frame_is_a_rotation_whose_z_is_the_axis(axis):
    turn = inputs.frame(axis)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    np.testing.assert_allclose(turn[:, 2], np.array(axis) / np.linalg.norm(axis), atol=1e-12)


def test_the_frame_of_z_is_the_identity():
    assert inputs.frame((0.0, 0.0, 2.0)).tolist() == np.eye(3).tolist()


def test_a_grid_with_a_gap_is_no_solid():
    skin = extrusion([faceted(SQUARE)], 0.1)
    broken = type(skin)(skin.vertices, skin.normals, skin.uvs, skin.triangles[1:], skin.targets)
    with pytest.raises(ValueError, match="not a closed manifold"):
        broken.shape(Exact(()))


def test_estimated_normals_keep_a_long_side_flat():
    from artgen.nodes.contours import estimated

    contour = estimated(rounded_polygon(np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]]), [0.05] * 4).points)
    assert isinstance(contour, Contour)
    bottom = np.flatnonzero(np.abs(contour.points[:, 1]) < 1e-12)
    assert (contour.normals_out[bottom] @ np.array([0.0, -1.0]) > 0.999).all()
