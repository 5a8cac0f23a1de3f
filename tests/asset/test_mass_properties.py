"""Mass properties against closed forms and against their own invariances."""

import json
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.asset import Shape, rotation
from artgen.asset.mass import MassProperties, polyhedron_moments, total
from artgen.errors import AssetError

BoxShape = Callable[..., Shape]
lengths = st.floats(0.01, 2.0)
offsets = st.floats(-5.0, 5.0)


def box(
    shape: BoxShape, size: tuple[float, ...], center: tuple[float, ...], density: float
) -> MassProperties:
    mesh = shape(size, center).mesh
    return total([polyhedron_moments(mesh.vertices, mesh.triangles).scaled(density)])


@given(st.tuples(lengths, lengths, lengths), st.tuples(offsets, offsets, offsets), st.floats(20.0, 9000.0))
def test_box_weighs_and_turns_as_the_textbook_says(
    box_shape: BoxShape, size: tuple[float, ...], center: tuple[float, ...], density: float
) -> None:
    found = box(box_shape, size, center, density)
    mass = density * np.prod(size)
    squares = np.square(size)
    assert found.mass == pytest.approx(mass, rel=1e-9)
    np.testing.assert_allclose(found.center, center, atol=1e-8)
    expected = np.diag(mass / 12 * (squares.sum() - squares))
    np.testing.assert_allclose(found.inertia, expected, atol=1e-8 * max(1.0, mass * squares.sum()))


def test_tetrahedron_weighs_as_the_textbook_says() -> None:
    """The corner tetrahedron of the unit cube: volume 1/6, centroid 1/4, moments 1/60 and products 1/120."""
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    triangles = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    moments = polyhedron_moments(vertices, triangles)
    assert moments.zeroth == pytest.approx(1 / 6)
    np.testing.assert_allclose(moments.first, np.full(3, 1 / 24))
    np.testing.assert_allclose(moments.second, np.full((3, 3), 1 / 120) + np.eye(3) / 120)


def test_parts_of_a_whole_add_up_to_it(box_shape: BoxShape) -> None:
    whole = box(box_shape, (1.0, 2.0, 3.0), (0.5, 0.0, 0.0), 700.0)
    halves = [box(box_shape, (0.5, 2.0, 3.0), (x, 0.0, 0.0), 700.0) for x in (0.25, 0.75)]
    joined = total(half.moments() for half in halves)
    assert joined.mass == pytest.approx(whole.mass)
    np.testing.assert_allclose(joined.center, whole.center, atol=1e-12)
    np.testing.assert_allclose(joined.inertia, whole.inertia, rtol=1e-9, atol=1e-6)


@given(st.floats(-3.0, 3.0), st.tuples(lengths, lengths, lengths))
def test_principal_axes_rebuild_the_inertia(angle: float, size: tuple[float, ...]) -> None:
    turn = rotation(np.array([2.0, -1.0, 2.0]) / 3.0, angle)
    squares = np.square(size)
    inertia = turn @ np.diag(squares.sum() - squares) @ turn.T
    moments, axes = MassProperties(1.0, np.zeros(3), inertia).principal()
    np.testing.assert_allclose(axes @ np.diag(moments) @ axes.T, inertia, atol=1e-9)
    assert np.linalg.det(axes) == pytest.approx(1.0)
    assert moments[0] + moments[1] >= moments[2] * (1.0 - 1e-9)


def test_nothing_weighs_nothing_and_cannot_be_a_body() -> None:
    with pytest.raises(AssetError, match="mass 0 kg cannot move; give it a solid with a density"):
        total([])


def test_mass_properties_survive_their_data(box_shape: BoxShape) -> None:
    original = box(box_shape, (0.1, 0.2, 0.3), (1.0, 2.0, 3.0), 700.0)
    copy = MassProperties.from_data(json.loads(json.dumps(original.to_data())))
    assert copy.mass == original.mass
    np.testing.assert_array_equal(copy.center, original.center)
    np.testing.assert_array_equal(copy.inertia, original.inertia)
