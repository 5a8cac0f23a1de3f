"""Print stays readable on mirrored products."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen import Graph, X, Y, Z, box, detail, extrude, material, part, polygon, weld

_FLAG = [(0.0, 0.0), (0.03, 0.0), (0.03, 0.01), (0.01, 0.01), (0.01, 0.05), (0.0, 0.05)]


def _sign(reads):
    """A board with an L on its front, right of the middle."""
    letter = extrude(polygon(_FLAG), 0.002, axis=-Y).at(0.2, -0.02, 0.5)
    return weld(
        part(box(0.6, 0.04, 1.0).at(z=0.5), "board", material("oak")),
        detail(letter, "print", material("brass"), reads=reads),
    )


def _print(body):
    (surface,) = [
        surface for surface in Graph(body).evaluate({}).value.link.surfaces if surface.label == "print"
    ]
    return surface.mesh.vertices


def _turning(points):
    """Which way round the L is: the sign of its third moment about the reading direction and upwards."""
    x, z = (points - 0.5 * (points.min(axis=0) + points.max(axis=0)))[:, [0, 2]].T
    return np.sign((x * z).mean())


@pytest.mark.parametrize("normal", [X, Y])
def test_print_stays_readable_in_the_mirrored_place(normal):
    before, after = _print(_sign(X)), _print(_sign(X).mirror(normal))
    plain = _print(_sign(None).mirror(normal))
    assert np.allclose(after.min(axis=0), plain.min(axis=0), atol=1e-12)
    assert np.allclose(after.max(axis=0), plain.max(axis=0), atol=1e-12)
    if normal is X:  # seen from the front, as before
        assert _turning(after) == _turning(before)
        assert _turning(plain) == -_turning(before)
    else:  # on the back now, where the reader's right is the other way
        assert _turning(after) == -_turning(before)
        assert _turning(plain) == _turning(before)


def test_twice_mirrored_print_is_as_it_was():
    before, after = _print(_sign(X)), _print(_sign(X).mirror(X).mirror(X))
    order = [np.lexsort(np.round(points, 9).T) for points in (before, after)]
    assert np.allclose(before[order[0]], after[order[1]], atol=1e-12)


@given(st.floats(-3.0, 3.0), st.sampled_from("XYZ"))
def test_rotations_carry_print_along(angle, name):
    axis, sense = {"X": (X, 1.0), "Y": (Y, -1.0), "Z": (Z, -1.0)}[name]
    turned = _print(_sign(X).rotate(axis, angle).mirror(X))
    again = _print(_sign(X).mirror(X).rotate(axis, sense * angle))
    order = [np.lexsort(np.round(points, 7).T) for points in (turned, again)]
    assert np.allclose(turned[order[0]], again[order[1]], atol=1e-6)
