import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.graph import evaluate
from artgen.nodes import csg, primitive, solid_methods
from artgen.nodes.handles import Solid
from artgen.nodes.primitive import box
from support.shapes import X, Y, Z, agreement, check_metric, check_shape

PART = csg._difference(primitive._box(0.1, 0.2, 0.3, 0.004), primitive._cylinder(0.02, 1.0, Y, 0.0))
VECTORS = st.tuples(*[st.floats(-2, 2)] * 3).map(np.array)
DIRECTIONS = VECTORS.filter(lambda v: np.linalg.norm(v) > 0.1)


@settings(max_examples=15)
@given(DIRECTIONS, st.floats(-7, 7), VECTORS)
def test_a_turn_moves_vertices_and_normals_together(axis, angle, about):
    shape = solid_methods._rotate(PART, axis, angle, about)
    check_shape(shape)
    check_metric(shape)
    assert shape.manifold.volume() == pytest.approx(PART.manifold.volume())
    back = solid_methods._rotate(shape, axis, -angle, about)
    np.testing.assert_allclose(back.bounds(), PART.bounds(), atol=1e-9)


def test_quarter_turns_are_exact():
    shape = solid_methods._rotate(primitive._box(0.1, 0.2, 0.3, 0.0), Z, math.pi / 2, np.zeros(3))
    np.testing.assert_allclose(np.ptp(shape.bounds(), axis=0), [0.2, 0.1, 0.3], rtol=1e-11)
    assert shape.pieces.outer(0.001)[0].kind == "box"


def test_a_turn_is_right_handed():
    np.testing.assert_allclose(solid_methods.rotation_about(Z, math.pi / 2) @ X, Y, atol=1e-15)
    shape = solid_methods._rotate(primitive._box(0.1, 0.1, 0.1, 0.0), Z, math.pi, X)
    np.testing.assert_allclose(shape.bounds().mean(axis=0), 2 * X, atol=1e-12)


@settings(max_examples=15)
@given(st.tuples(*[st.floats(0.5, 2)] * 3).map(np.array))
def test_scaling_keeps_normals_true(factors):
    shape = solid_methods._scale(PART, factors)
    # normals stretch by the inverse factors; an angle grows most about the direction that stretches least
    apart = math.acos(agreement(PART))
    apart = 2.0 * math.atan(factors.max() / factors.min() * math.tan(0.5 * apart))
    check_shape(shape, least_agreement=math.cos(apart) - 1e-9)
    assert shape.manifold.volume() == pytest.approx(PART.manifold.volume() * np.prod(factors))
    np.testing.assert_allclose(shape.bounds(), PART.bounds() * factors, atol=1e-12)


def test_texture_grows_with_its_solid():
    check_metric(solid_methods._scale(primitive._box(0.1, 0.2, 0.3, 0.0), np.array([2.0, 2.0, 2.0])))


@settings(max_examples=15)
@given(DIRECTIONS)
def test_a_mirror_image_is_no_inside_out(normal):
    shape = solid_methods._mirror(PART, normal)
    check_shape(shape)
    twice = solid_methods._mirror(shape, normal)
    np.testing.assert_allclose(twice.bounds(), PART.bounds(), atol=1e-9)


@settings(max_examples=15)
@given(VECTORS, *[st.floats(-1, 1)] * 3)
def test_an_anchor_comes_to_its_point(to, x, y, z):
    shape = solid_methods._align(PART, to, x, y, z)
    np.testing.assert_allclose(solid_methods._anchor(shape, x, y, z), to, atol=1e-9)


@pytest.mark.parametrize("place", [(2.0, 0.0, 0.0), (0.0, 0.0, -3.0)])
def test_an_anchor_outside_the_bounding_box_is_refused(place):
    with pytest.raises(
        ValueError, match=r"the anchor \(.*\) is not in the bounding box: each share is from -1"
    ):
        solid_methods._align(PART, np.zeros(3), *place)


def test_methods_record_the_operations():
    solid = box(0.1, 0.2, 0.3)
    turn = {"axis": (0, 0, 1), "angle": 0.5, "about": (0, 0, 0)}
    for made, plain in (
        (solid.at(1, 2, 3), Solid.record("translate", solid=solid, offset=(1, 2, 3))),
        (solid.at((1, 2, 3)), Solid.record("translate", solid=solid, offset=(1, 2, 3))),
        (solid.rotate((0, 0, 1), 0.5), Solid.record("rotate", solid=solid, **turn)),
        (solid.scale(2), Solid.record("scale", solid=solid, factors=(2, 2, 2))),
        (solid.mirror((1, 0, 0)), Solid.record("mirror", solid=solid, normal=(1, 0, 0))),
        (solid.align((0, 0, 1), z=-1), Solid.record("align", solid=solid, to=(0, 0, 1), x=0, y=0, z=-1)),
    ):
        assert made.node.key == plain.node.key
        check_shape(evaluate(made).value)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: solid_methods._translate(PART, X * math.nan), "offset must be finite"),
        (lambda: solid_methods._rotate(PART, 0 * X, 1.0, X), "axis must have a direction"),
        (lambda: solid_methods._rotate(PART, X, math.inf, X), "angle must be a finite number, got inf rad"),
        (
            lambda: solid_methods._scale(PART, np.array([1.0, -1.0, 1.0])),
            r"must be positive, got \(1, -1, 1\); mirror",
        ),
        (lambda: solid_methods._mirror(PART, 0 * X), "normal must have a direction"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_a_reflected_solid_stays_smooth():
    ball = primitive._sphere(0.03)
    reflected = ball.transformed(np.diag([-1.0, 1.0, 1.0, 1.0])).mesh
    outward = reflected.vertices / np.linalg.norm(reflected.vertices, axis=1, keepdims=True)
    np.testing.assert_allclose(reflected.normals, outward, atol=1e-6)
