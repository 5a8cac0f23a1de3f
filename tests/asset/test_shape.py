import functools
import operator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen import Y, cylinder_between, vector
from artgen.asset.manifolds import part_boxes
from artgen.asset.shape import ComposedShape, Shape
from artgen.graph import evaluate
from artgen.nodes import csg, primitive, solid_methods, sweep
from artgen.nodes.path import _polyline
from artgen.nodes.profile import _circle
from support.shapes import X, Z

LENGTHS = st.floats(0.01, 0.3)


def volume_of(mesh):
    a, b, c = np.moveaxis(mesh.vertices[mesh.triangles], 1, 0)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0


def assert_mesh_is_the_manifold(shape):
    assert volume_of(shape.mesh) == pytest.approx(shape.manifold.volume(), rel=1e-9)
    np.testing.assert_allclose(
        shape.bounds(), np.reshape(shape.manifold.bounding_box(), (2, 3)), rtol=0, atol=1e-11
    )
    assert len(shape.mesh.triangles) == shape.manifold.num_tri()
    assert set(shape.mesh.triangles.ravel()) == set(range(len(shape.mesh.vertices)))
    np.testing.assert_array_equal(shape.vertices, shape.mesh.vertices)


@settings(max_examples=20, deadline=None)
@given(LENGTHS, LENGTHS, LENGTHS, st.sampled_from([0.0, 0.0005, 0.004]))
def test_a_solid_is_the_same_with_and_without_its_manifold(x, y, z, bevel):
    corners = tuple(np.array([[0.0, 0.0, 0.0], [x, 0.0, 0.0], [x, 0.0, z + 0.05]]))
    wire = sweep._sweep(_circle(0.003), _polyline(corners, 0.004, closed=False))
    for solid in (primitive._box(x, y, z, bevel), primitive._cylinder(x, z, Z, bevel / 4.0), wire):
        assert_mesh_is_the_manifold(solid)
        assert_mesh_is_the_manifold(solid_methods._rotate(solid, X, 0.4, np.zeros(3)))


def test_solids_that_are_apart_are_one_solid_with_all_their_parts():
    pin = primitive._cylinder(0.02, 0.2, Z, 0.001)
    row = csg._array(pin, np.array([[0.05 * place, 0.0, 0.0] for place in range(4)]))
    assert isinstance(row, ComposedShape)
    assert_mesh_is_the_manifold(row)
    pins = np.array([pin.bounds() + place * 0.05 * X for place in range(4)])
    moved = solid_methods._translate(row, X)
    np.testing.assert_allclose(moved.bounds(), row.bounds() + X)
    mesh = row.mesh
    one = Shape.from_mesh(mesh.vertices, mesh.normals, mesh.uvs, mesh.triangles, row.pieces)
    united = Shape(row.manifold, row.pieces)
    for solid, offset in ((row, 0.0), (one, 0.0), (united, 0.0), (moved, X)):
        boxes, first = part_boxes(solid.vertices, solid.faces)
        order = np.argsort(boxes[:, 0, 0])
        np.testing.assert_allclose(boxes[order], pins + offset, rtol=0, atol=1e-12)
        np.testing.assert_allclose(
            solid.vertices[first][order, 0], boxes[order].mean(axis=1)[:, 0], atol=0.021
        )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda triangles: triangles[1:], "not a closed manifold: an edge belongs to one face only"),
        (lambda triangles: triangles[:, ::-1], r"the volume is -1e-06 m\^3; a solid must have"),
        (lambda triangles: triangles[:0], "the result is empty"),
        (lambda triangles: triangles * 0, "the result is empty"),
    ],
    ids=["open", "inside out", "nothing", "points"],
)
def test_a_surface_that_is_no_solid_is_refused(change, message):
    box = primitive._box(0.01, 0.01, 0.01, 0.0)
    mesh = box.mesh
    with pytest.raises(ValueError, match=message):
        Shape.from_mesh(mesh.vertices, mesh.normals, mesh.uvs, change(mesh.triangles), box.pieces)


def test_coordinates_must_be_finite():
    box = primitive._box(0.01, 0.01, 0.01, 0.0)
    mesh = box.mesh
    vertices = np.where(mesh.vertices == mesh.vertices.max(), np.nan, mesh.vertices)
    targets = np.array([np.flatnonzero((mesh.vertices == each).all(axis=1))[0] for each in mesh.vertices])
    with pytest.raises(ValueError, match="coordinates that are not finite"):
        Shape.from_mesh(vertices, mesh.normals, mesh.uvs, mesh.triangles, box.pieces, targets=targets)


def test_triangles_without_height_are_cut_another_way():
    ring = np.array([[0.0, 0.0], [0.1, 0.0], [0.2, 0.0], [0.2, 0.1], [0.0, 0.1]])
    vertices = np.vstack([np.column_stack([ring, np.full(5, z)]) for z in (0.0, 0.05)])
    cap = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4]])  # the first one's corners lie in a row
    sides = [[[a, b, b + 5], [a, b + 5, a + 5]] for a, b in zip(range(5), [1, 2, 3, 4, 0], strict=True)]
    triangles = np.vstack([cap[:, ::-1], cap + 5, np.reshape(sides, (-1, 3))])
    zeros = np.zeros((10, 3))
    shape = Shape.from_mesh(vertices, zeros, zeros[:, :2], triangles, primitive._box(1, 1, 1, 0.0).pieces)
    corners = shape.mesh.vertices[shape.mesh.triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    assert areas.min() > 1e-4
    assert shape.manifold.volume() == pytest.approx(0.2 * 0.1 * 0.05)


@pytest.mark.parametrize(("length", "turn"), [(0.1, 0.4 * np.pi), (0.15, 1.257), (0.2, 0.7)])
def test_rods_that_meet_in_a_point_have_normals_everywhere(length, turn):
    """manifold3d leaves some of the corners there without any."""
    rods = [
        cylinder_between((0, 0, 0), vector(0, 0, length).rotate(Y, turn * number), 0.01)
        for number in range(5)
    ]
    star = evaluate(functools.reduce(operator.or_, rods)).value
    mesh = star.mesh
    for values in (mesh.vertices, mesh.normals, mesh.uvs):
        assert np.isfinite(values).all()
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, rtol=0, atol=1e-9)
    assert not mesh.paints.any()
