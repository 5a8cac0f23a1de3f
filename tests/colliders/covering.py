"""What the tests of convex pieces measure: how well pieces and a solid cover each other."""

from collections.abc import Iterable

import numpy as np
from manifold3d import Manifold, OpType
from numpy.typing import NDArray

from artgen.colliders import Convex

Array = NDArray[np.float64]


def pose(
    x: float = 0.0, y: float = 0.0, z: float = 0.0, *, turn: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> Array:
    """Return a rigid transform: turned about x, then y, then z [rad], then moved [m]."""
    matrix = np.eye(4)
    for axis, angle in enumerate(turn):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        step = np.eye(4)
        step[i, i] = step[j, j] = np.cos(angle)
        step[i, j], step[j, i] = -np.sin(angle), np.sin(angle)
        matrix = step @ matrix
    matrix[:3, 3] = (x, y, z)
    return matrix


def moved(solid: Manifold, matrix: Array) -> Manifold:
    """Return a manifold moved by an affine matrix, shape (4, 4)."""
    return solid.transform(np.ascontiguousarray(matrix[:3]))


def block(size: tuple[float, float, float], matrix: Array) -> Manifold:
    """Return a centered box as a manifold."""
    return moved(Manifold.cube(size, center=True), matrix)


def drum(radius: float, length: float, sides: int, matrix: Array) -> Manifold:
    """Return a centered cylinder along z with its vertices on the radius."""
    return moved(Manifold.cylinder(length, radius, radius, sides, center=True), matrix)


def joined_manifold(pieces: Iterable[Convex]) -> Manifold:
    """Return the union of the pieces."""
    return Manifold.batch_boolean([piece.manifold() for piece in pieces], OpType.Add)


def uncovered(solid: Manifold, pieces: Iterable[Convex]) -> float:
    """Return how thick a film of the solid is not covered by the pieces: volume by surface [m]."""
    rest = solid - joined_manifold(pieces)
    return float(rest.volume() / solid.surface_area())


def excess(solid: Manifold, pieces: Iterable[Convex]) -> float:
    """Return how thick a film the pieces lie outside the solid: volume by surface [m]."""
    return float((joined_manifold(pieces) - solid).volume() / solid.surface_area())


def vertices(solid: Manifold) -> Array:
    """Return the vertices of a manifold, shape (n, 3) [m]."""
    return np.array(solid.to_mesh64().vert_properties)[:, :3]
