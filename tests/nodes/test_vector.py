"""Vectors: what the graph computes is what linear algebra says."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from artgen.errors import EvaluationError
from artgen.graph import evaluate
from artgen.nodes.handles import Float, Vector
from artgen.nodes.vector import X, Y, Z, component, vector

NUMBERS = st.floats(-100, 100, allow_nan=False).map(lambda value: round(value, 3))
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS)


def value(handle, **parameters):
    return evaluate(handle, parameters).value


def test_the_axes():
    assert [value(axis).tolist() for axis in (X, Y, Z)] == np.eye(3).tolist()


@given(a=VECTORS, b=VECTORS, factor=NUMBERS)
def test_arithmetic(a, b, factor):
    u, v = vector(*a), vector(*b)
    a, b = np.array(a), np.array(b)
    for made in (u + v, u + tuple(b), tuple(a) + v, a + v):
        assert value(made).tolist() == (a + b).tolist()
    for made in (u - v, u - tuple(b), tuple(a) - v, a - v):
        assert value(made).tolist() == (a - b).tolist()
    assert value(u * factor).tolist() == value(factor * u).tolist() == (a * factor).tolist()
    assert value(-u).tolist() == (-a).tolist()


@given(a=VECTORS, divisor=st.floats(0.1, 10))
def test_division(a, divisor):
    assert value(vector(*a) / divisor) == pytest.approx(np.array(a) / divisor)
    assert value(vector(*a) / Float.parameter("d"), d=divisor) == pytest.approx(np.array(a) / divisor)


def test_division_by_zero_is_an_error_of_the_graph():
    with pytest.raises(EvaluationError, match="division of 1 by zero"):
        value(X / 0)


@given(a=VECTORS)
def test_components(a):
    made = vector(*a)
    assert (value(made.x), value(made.y), value(made.z)) == a
    assert value(component(a, 1)) == a[1]


def test_there_are_three_components():
    with pytest.raises(EvaluationError, match="components 0, 1 and 2, not 3"):
        value(component(X, 3))


@given(a=VECTORS, b=VECTORS)
def test_products(a, b):
    assert value(vector(*a).dot(b)) == pytest.approx(float(np.dot(a, b)))
    assert value(vector(*a).cross(b)) == pytest.approx(np.cross(a, b))
    assert value(vector(*a).norm()) == pytest.approx(float(np.linalg.norm(a)))


@given(a=VECTORS)
def test_normalize_keeps_the_direction(a):
    length = float(np.linalg.norm(a))
    assume(length > 1e-2)
    assert value(vector(*a).normalized()) * length == pytest.approx(np.array(a))
    assert np.linalg.norm(value(vector(*a).normalized())) == pytest.approx(1.0)


def test_no_length_no_direction():
    with pytest.raises(EvaluationError, match="a vector of length zero has no direction"):
        value(vector().normalized())


@given(a=VECTORS, axis=VECTORS, angle=st.floats(-7, 7))
def test_rotation_keeps_length_and_axis_and_undoes_itself(a, axis, angle):
    assume(np.linalg.norm(axis) > 1e-2)
    turned = vector(*a).rotate(axis, angle)
    assert np.linalg.norm(value(turned)) == pytest.approx(np.linalg.norm(a))
    assert value(vector(*axis).rotate(axis, angle)) == pytest.approx(np.array(axis))
    assert value(turned.rotate(axis, -angle)) == pytest.approx(np.array(a), abs=1e-9)
    assert (
        turned.node.key == Vector.record("vector_rotate", vector=vector(*a), axis=axis, angle=angle).node.key
    )


def test_rotation_is_right_handed():
    assert value(X.rotate(Z, np.pi / 2)) == pytest.approx([0, 1, 0])
    assert value(Y.rotate(X, np.pi / 2)) == pytest.approx([0, 0, 1])


def test_sockets_in_tuples():
    assert value(Z + (Float.parameter("a"), 1, 2), a=5.0).tolist() == [5.0, 1.0, 3.0]
