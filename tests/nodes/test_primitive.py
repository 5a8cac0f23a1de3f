import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen._arrays import affine
from artgen.errors import EvaluationError
from artgen.graph import evaluate
from artgen.nodes import primitive
from artgen.nodes.primitive import cylinder_between
from artgen.nodes.region import Region
from support.shapes import X, Y, Z, check_metric, check_shape, relative_volume, same_bytes

LENGTHS = st.floats(0.002, 2.0)
AXES = st.sampled_from([X, Y, Z, -X, -Y, -Z, np.array([1.0, 2.0, 3.0])])
few = settings(max_examples=10)


def extent(shape):
    return np.ptp(shape.bounds(), axis=0)


@few
@given(LENGTHS, LENGTHS, LENGTHS, st.floats(0.0, 1.0))
def test_a_box_fills_its_lengths(x, y, z, share):
    bevel = share * min(x, y, z) / 2.0
    shape = primitive._box(x, y, z, bevel)
    check_shape(shape)
    np.testing.assert_allclose(extent(shape), [x, y, z], rtol=1e-9)
    core = [length - 2 * bevel for length in (x, y, z)]
    faces = 2 * bevel * (core[0] * core[1] + core[1] * core[2] + core[2] * core[0])
    exact = math.prod(core) + faces + math.pi * bevel**2 * sum(core) + 4 / 3 * math.pi * bevel**3
    assert 0.8 < relative_volume(shape, exact) <= 1.0 + 2e-3


def test_a_sharp_box_is_exact_and_its_own_collider():
    shape = primitive._box(0.1, 0.2, 0.3, 0.0)
    assert shape.mesh.vertices.shape == (24, 3)
    assert relative_volume(shape, 0.006) == pytest.approx(1.0, abs=1e-12)
    (piece,) = shape.pieces.outer(1e-6)
    assert (piece.kind, piece.size) == ("box", (0.1, 0.2, 0.3))
    check_metric(shape)


def test_a_board_lies_between_its_planes_as_a_box_between_their_corners_does():
    span = Region((-0.2, 0.3), (0.1, 0.12), (0.0, 0.7)).box(bevel=0.002)
    shape = evaluate(span).value
    np.testing.assert_allclose(shape.bounds(), [[-0.2, 0.1, 0.0], [0.3, 0.12, 0.7]], atol=1e-12)
    corners = Region.between((-0.2, 0.1, 0.0), (0.3, 0.12, 0.7)).box(bevel=0.002)
    assert span.node.key == corners.node.key


def test_a_board_whose_planes_are_swapped_names_the_axis():
    with pytest.raises(EvaluationError, match=r"-0\.2 m long along y: the lowest coordinate comes first"):
        evaluate(Region((0.0, 1.0), (0.3, 0.1), (0.0, 1.0)).box())


@few
@given(LENGTHS, AXES, st.floats(0.0, 0.9))
def test_a_cylinder_between_two_points_is_one_along_their_line(length, axis, share):
    radius, start = 0.01, np.array([0.3, -0.2, 0.1])
    end = start + length * axis / np.linalg.norm(axis)
    bevel = share * min(radius, length / 2.0)
    shape = primitive._cylinder_between(start, end, radius, bevel)
    check_shape(shape)
    same = primitive._cylinder(radius, length, end - start, bevel).transformed(
        affine(np.eye(3), (start + end) / 2.0)
    )
    same_bytes(shape, same)


def test_a_cylinder_from_a_point_to_itself_is_refused():
    with pytest.raises(EvaluationError, match="start and end are the same point"):
        evaluate(cylinder_between((0.1, 0.2, 0.3), (0.1, 0.2, 0.3), 0.01))


@pytest.mark.parametrize("size", [(0.1, 0.2, 0.9), (0.9, 0.1, 0.2), (0.2, 0.9, 0.1)])
def test_texture_runs_along_the_longest_side_of_a_box(size):
    mesh = primitive._box(*size, 0.01).mesh
    check_metric(primitive._box(*size, 0.01))
    longest = int(np.argmax(size))
    side = np.abs(mesh.normals[:, longest]) < 0.1
    np.testing.assert_allclose(mesh.uvs[side, 1], mesh.vertices[side, longest])


@few
@given(LENGTHS, LENGTHS, AXES, st.floats(0.0, 0.9))
def test_a_cylinder_is_inscribed(radius, length, axis, share):
    bevel = share * min(radius, length / 2.0)
    shape = primitive._cylinder(radius, length, axis, bevel)
    check_shape(shape)
    along = axis / np.linalg.norm(axis)
    height = shape.mesh.vertices @ along
    across = np.linalg.norm(shape.mesh.vertices - height[:, None] * along, axis=1)
    assert across.max() == pytest.approx(radius)
    assert np.ptp(height) == pytest.approx(length)
    kinds = [piece.kind for piece in shape.pieces.outer(0.001)]
    assert kinds[0] == "cylinder" or (kinds == ["hull"] and radius <= 0.03)
    if bevel == 0.0:
        assert 0.95 < relative_volume(shape, math.pi * radius**2 * length) < 1.0


@few
@given(st.floats(0.001, 0.5))
def test_a_shaft_fits_a_bore_and_not_a_cylinder(radius):
    block = primitive._box(4 * radius, 4 * radius, radius, 0.0)
    shaft = primitive._cylinder(radius, radius, Z, 0.0)
    wide = block.manifold - primitive._bore(radius, 2 * radius, Z).manifold
    assert (wide ^ shaft.manifold).volume() < 1e-9 * radius**3
    bore = primitive._bore(radius, 2 * radius, Z)
    check_shape(bore)
    across = np.linalg.norm(bore.mesh.vertices[:, :2], axis=1)
    assert across[across > 1e-9].min() > radius


@few
@given(LENGTHS, LENGTHS, LENGTHS, AXES)
def test_a_frustum_has_its_radii(bottom, top, length, axis):
    shape = primitive._frustum(bottom, top, length, axis, 0.0)
    check_shape(shape)
    exact = math.pi * length / 3.0 * (bottom**2 + bottom * top + top**2)
    assert 0.95 < relative_volume(shape, exact) < 1.0


def test_a_cone_ends_in_a_point():
    shape = primitive._frustum(0.1, 0.0, 0.2, Z, 0.01)
    check_shape(shape)
    top = shape.mesh.vertices[shape.mesh.vertices[:, 2] > 0.0999]
    np.testing.assert_allclose(top, np.broadcast_to([0, 0, 0.1], top.shape), atol=1e-12)


@few
@given(LENGTHS)
def test_a_sphere_is_inscribed(radius):
    shape = primitive._sphere(radius)
    check_shape(shape)
    np.testing.assert_allclose(np.linalg.norm(shape.mesh.vertices, axis=1), radius)
    np.testing.assert_allclose(shape.mesh.normals, shape.mesh.vertices / radius, atol=1e-9)
    assert shape.pieces.outer(0.001)[0].kind == "sphere"
    assert 0.9 < relative_volume(shape, 4 / 3 * math.pi * radius**3) < 1.0


@few
@given(st.floats(0.01, 0.1), st.floats(0.01, 0.1), st.floats(0.01, 0.1))
@pytest.mark.long
def test_an_ellipsoid_fills_its_axes(x, y, z):
    shape = primitive._ellipsoid(x, y, z)
    check_shape(shape, least_agreement=0.5)
    np.testing.assert_allclose(extent(shape), [2 * x, 2 * y, 2 * z], rtol=1e-9)
    assert 0.9 < relative_volume(shape, 4 / 3 * math.pi * x * y * z) < 1.0


@few
@given(st.floats(0.01, 0.5), st.floats(0.3, 1.0), AXES)
def test_a_dome_stands_on_the_origin(radius, share, axis):
    shape = primitive._dome(radius, share * radius, axis)
    check_shape(shape)
    height = shape.mesh.vertices @ (axis / np.linalg.norm(axis))
    assert height.min() == pytest.approx(0.0, abs=1e-12)
    assert height.max() == pytest.approx(share * radius)
    assert 0.9 < relative_volume(shape, 2 / 3 * math.pi * radius**3 * share) < 1.0


@few
@given(st.floats(0.002, 0.5), st.floats(1.01, 5.0), AXES)
def test_a_capsule_has_its_overall_length(radius, share, axis):
    length = 2.0 * radius * share
    shape = primitive._capsule(radius, length, axis)
    check_shape(shape)
    assert np.ptp(shape.mesh.vertices @ (axis / np.linalg.norm(axis))) == pytest.approx(length)
    exact = math.pi * radius**2 * (length - 2 * radius) + 4 / 3 * math.pi * radius**3
    assert 0.9 < relative_volume(shape, exact) < 1.0


@settings(max_examples=4)
@given(st.floats(0.01, 0.5), st.floats(0.1, 0.9), AXES)
@pytest.mark.long
def test_a_torus_has_a_hole(major, share, axis):
    shape = primitive._torus(major, share * major, axis)
    check_shape(shape)
    assert shape.manifold.genus() == 1
    assert 0.9 < relative_volume(shape, 2 * math.pi**2 * major**3 * share**2) < 1.0


@few
@given(st.floats(0.01, 0.5), st.floats(0.2, 0.9), LENGTHS, AXES, st.sampled_from([0.0, 0.3]))
def test_a_tube_is_open(outer, share, length, axis, round_share):
    inner = outer * share
    shape = primitive._tube(outer, inner, length, axis, round_share * min(outer - inner, length) / 2)
    check_shape(shape)
    assert shape.manifold.genus() == 1
    if round_share == 0.0:
        assert 0.9 < relative_volume(shape, math.pi * (outer**2 - inner**2) * length) < 1.0


def test_a_wedge_rises_to_the_back():
    shape = primitive._wedge(0.1, 0.2, 0.3)
    check_shape(shape)
    check_metric(shape)
    assert relative_volume(shape, 0.003) == pytest.approx(1.0)
    np.testing.assert_allclose(shape.bounds(), [[-0.05, -0.1, -0.15], [0.05, 0.1, 0.15]])
    top = shape.mesh.vertices[shape.mesh.vertices[:, 2] > 0.0]
    assert (top[:, 1] > 0.0).all()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: primitive._box(-0.1, 1, 1, 0), "size x must be positive, got -0.1 m"),
        (lambda: primitive._box(1, 1, math.inf, 0), "size z must be positive, got inf m"),
        (lambda: primitive._box(1, 1, 0.1, 0.06), "bevel must be within 0 and 0.05 m, got 0.06 m"),
        (lambda: primitive._cylinder(0, 1, Z, 0), "radius must be positive, got 0 m"),
        (lambda: primitive._cylinder(1, 1, 0 * Z, 0), "axis must have a direction"),
        (lambda: primitive._bore(1, math.nan, Z), "length must be positive, got nan m"),
        (lambda: primitive._frustum(0, 0, 1, Z, 0), "the larger radius must be positive"),
        (lambda: primitive._frustum(0.1, 0.05, 0.1, Z, 0.09), "use a smaller radius"),
        (lambda: primitive._capsule(0.1, 0.1, Z), "length must be within 0.2"),
        (lambda: primitive._torus(0.1, 0.2, Z), "minor radius must be within"),
        (lambda: primitive._tube(0.1, 0.2, 1, Z, 0), "outer radius 0.1 m must exceed the inner radius 0.2 m"),
        (lambda: primitive._ellipsoid(1, -1, 1), "radius y must be positive, got -1 m"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_constructors_record_what_kernels_make():
    solids = {
        "box": primitive.box(0.1, 0.2, 0.3, bevel=0.01),
        "cylinder": primitive.cylinder(0.1, 0.2, axis=(0, 1, 0)),
        "bore": primitive.bore(0.1, 0.2),
        "frustum": primitive.frustum(0.1, 0.05, 0.2),
        "sphere": primitive.sphere(0.1),
        "ellipsoid": primitive.ellipsoid(0.1, 0.2, 0.3),
        "dome": primitive.dome(0.1),
        "capsule": primitive.capsule(0.1, 0.4),
        "torus": primitive.torus(0.1, 0.02),
        "tube": primitive.tube(0.1, 0.08, 0.2),
        "wedge": primitive.wedge(0.1, 0.2, 0.3),
    }
    for name, solid in solids.items():
        assert solid.node.op == name
        first, second = evaluate(solid).value, evaluate(solid).value
        assert same_bytes(first, second)


SIDES = st.floats(0.05, 0.6)


@settings(max_examples=10, deadline=None)
@given(SIDES, SIDES, st.floats(0.02, 0.15), st.floats(0.0, 0.9), st.floats(0.05, 1.0))
def test_a_crowned_box_is_a_convex_cushion_of_its_size(x, y, z, share, height):
    bevel = share * min(x, y, z) / 2.0
    crown = height * (z - 2.0 * bevel)
    shape = primitive._box(x, y, z, bevel, crown)
    np.testing.assert_allclose(shape.bounds(), np.array([[-x, -y, -z], [x, y, z]]) / 2.0, atol=1e-9)
    volume = shape.manifold.volume()
    assert volume == pytest.approx(shape.manifold.hull().volume(), rel=1e-6)
    assert volume < primitive._box(x, y, z, bevel, 0.0).manifold.volume()


def test_the_corners_of_a_crowned_box_are_lower_by_the_crown():
    vertices = primitive._box(0.4, 0.3, 0.1, 0.0, 0.03).mesh.vertices
    corner = (np.abs(vertices[:, 0]) > 0.199) & (np.abs(vertices[:, 1]) > 0.149)
    assert vertices[corner, 2].max() == pytest.approx(0.05 - 0.03)


def test_a_crown_leaves_room_for_the_bevels():
    with pytest.raises(ValueError, match=r"crown must be within 0 and 0\.04 m, got 0\.05 m"):
        primitive._box(0.3, 0.3, 0.1, 0.03, 0.05)
