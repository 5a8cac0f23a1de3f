"""Coarse colliders of thin round shells."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from artgen.nodes import csg, primitive

Array = NDArray[np.float64]
UP = np.array([0.0, 0.0, 1.0])


def test_a_coarse_tube_collides_as_fewer_pieces_that_still_contain_it() -> None:
    tube = primitive._tube(0.15, 0.147, 0.5, UP, 0.0)
    shape = csg._simplified_collider(tube, 0.001)
    fine, few = tube.pieces.simplified(0.00025), shape.pieces.simplified(0.00025)
    assert len(few) < 0.6 * len(fine)
    assert shape.manifold.volume() == pytest.approx(tube.manifold.volume())
    corners = np.asarray(tube.manifold.to_mesh64().vert_properties)[:, :3]
    outside = np.min([_distance(piece.points, corners) for piece in few], axis=0)
    assert outside.max() < 1e-6
    assert len(shape.pieces.inner(0.001)) == len(tube.pieces.inner(0.001))


def test_moved_coarse_pieces_stay_coarse() -> None:
    shape = csg._simplified_collider(primitive._tube(0.1, 0.097, 0.2, UP, 0.0), 0.001)
    moved = shape.transformed(np.array([[1.0, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]))
    assert len(moved.pieces.simplified(0.00025)) == len(shape.pieces.simplified(0.00025))


def test_colliders_may_not_stand_off_farther_than_checks_allow() -> None:
    tube = primitive._tube(0.1, 0.097, 0.2, UP, 0.0)
    assert csg._simplified_collider(tube, 0.0) is tube
    with pytest.raises(ValueError, match=r"within must be within 0 and 0.001 m, got 0.002 m"):
        csg._simplified_collider(tube, 0.002)


@pytest.mark.parametrize(("radius", "share"), [(0.1, 0.5), (0.3, 1.0)])
def test_a_wide_ring_keeps_its_pieces(radius: float, share: float) -> None:
    """Two facets together stand off by more than 1 mm from a wide ring."""
    ring = primitive._torus(radius, 0.01, UP)
    before, after = (
        len(shape.pieces.simplified(0.00025)) for shape in (ring, csg._simplified_collider(ring, 0.001))
    )
    assert after == share * before


def _distance(corners: Array, points: Array) -> Array:
    """Return how far points stick out of the hull of corners, along its planes [m]."""
    planes = ConvexHull(corners).equations
    height: Array = (planes[:, :3] @ points.T + planes[:, 3:]).max(axis=0)
    return height
