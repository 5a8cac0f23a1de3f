import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.graph import OPERATIONS, evaluate
from artgen.nodes import csg, primitive, solid_methods
from artgen.nodes.primitive import box, sphere
from support.shapes import X, Z


@settings(max_examples=15)
@given(*[st.floats(0.01, 2)] * 3, st.tuples(*[st.floats(-100, 100)] * 3).map(np.array))
def test_a_box_measures_what_it_is(x, y, z, place):
    shape = solid_methods._translate(primitive._box(x, y, z, 0.0), place)
    assert OPERATIONS["volume"].kernel(shape) == pytest.approx(x * y * z)
    assert OPERATIONS["area"].kernel(shape) == pytest.approx(2 * (x * y + y * z + z * x))
    np.testing.assert_allclose(OPERATIONS["size"].kernel(shape), [x, y, z], atol=1e-12)
    np.testing.assert_allclose(solid_methods._centroid(shape), place, atol=1e-9)
    np.testing.assert_allclose(
        solid_methods._anchor(shape, -1.0, 0.0, 1.0), place + np.array([-x / 2, 0, z / 2]), atol=1e-12
    )
    np.testing.assert_allclose(OPERATIONS["bounds"].kernel(shape).mean(axis=0), place, atol=1e-12)


def test_the_centroid_of_a_drilled_block_moves_away_from_the_hole():
    hole = solid_methods._translate(primitive._cylinder(0.1, 2.0, Z, 0.0), 0.3 * X)
    shape = csg._difference(primitive._box(1.0, 1.0, 1.0, 0.0), hole)
    drilled = hole.manifold.volume() / 2.0
    np.testing.assert_allclose(
        solid_methods._centroid(shape), [-0.3 * drilled / (1.0 - drilled), 0.0, 0.0], atol=1e-12
    )


def test_a_sphere_is_a_little_small():
    shape = primitive._sphere(0.1)
    assert OPERATIONS["area"].kernel(shape) == pytest.approx(4 * math.pi * 0.01, rel=0.02)


def test_measures_feed_the_graph():
    ball = sphere(0.1)
    stand = box(0.05, 0.05, 0.2).align(ball.anchor(z=-1), z=1)
    np.testing.assert_allclose(evaluate(stand).value.bounds()[1, 2], -0.1)
    assert evaluate(ball.volume()).value == pytest.approx(0.00419, rel=0.05)
    assert evaluate(ball.size().x).value == pytest.approx(0.2)
    assert evaluate(ball.area()).value == pytest.approx(OPERATIONS["area"].kernel(evaluate(ball).value))
    np.testing.assert_allclose(evaluate(ball.centroid()).value, 0.0, atol=1e-12)
    assert evaluate(ball.bounds()).value.shape == (2, 3)
