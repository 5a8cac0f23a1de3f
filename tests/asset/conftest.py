"""Small links made by hand, without the graph."""

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from artgen.asset import Link, Piece, Shape
from artgen.colliders import Convex, Exact
from artgen.materials import Material

Array = NDArray[np.float64]
BoxShape = Callable[..., Shape]
BoxLink = Callable[..., Link]

WATER = Material("water", density=1000.0)

_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_TRIANGLES = np.array(
    [
        [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
        [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
    ]
)  # fmt: skip


@pytest.fixture(scope="session")
def box_shape() -> BoxShape:
    """Return a function that makes a box of a size, centered on a point."""

    def make(size: tuple[float, ...] = (1.0, 1.0, 1.0), center: tuple[float, ...] = (0.0, 0.0, 0.0)) -> Shape:
        vertices = _CORNERS * np.array(size) + np.array(center)
        pose = np.eye(4)
        pose[:3, 3] = center
        pieces = Exact((Convex("box", pose, tuple(map(float, size)), np.zeros((0, 3))),))
        return Shape.from_mesh(vertices, 2.0 * _CORNERS, vertices[:, :2], _TRIANGLES, pieces)

    return make


@pytest.fixture(scope="session")
def box_link(box_shape: BoxShape) -> BoxLink:
    """Return a function that makes a link that is one box of water."""

    def make(
        name: str, size: tuple[float, ...] = (0.1, 0.1, 0.1), center: tuple[float, ...] = (0, 0, 0)
    ) -> Link:
        return Link(name, name, (Piece(name, WATER, box_shape(size, center)),))

    return make
