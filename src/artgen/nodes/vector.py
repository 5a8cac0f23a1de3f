"""Vectors and lists of points: components, products, rotation, rows, grids and rings."""

from __future__ import annotations

import numpy as np

from artgen import _portable
from artgen.asset import Curve, rotation
from artgen.graph import define, kernel, records
from artgen.nodes.handles import Array3, ArrayN3, Float, Points, Scalar, Vector, VectorLike


def _vector(x: float, y: float, z: float) -> Array3:
    return np.array([x, y, z])


@records(_vector)
def vector(x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Vector:
    """Make a vector from its components.

    Examples:
        >>> box(0.3, 0.2, 0.02) | box(0.1, 0.1, 0.1).at(vector(0.1, 0.0, 0.05))
    """


X = vector(1.0, 0.0, 0.0)
"""Unit vector to the right."""
Y = vector(0.0, 1.0, 0.0)
"""Unit vector to the back; the front of an asset faces -Y."""
Z = vector(0.0, 0.0, 1.0)
"""Unit vector upward."""


def _component(vector: Array3, index: int) -> float:
    if index not in (0, 1, 2):
        raise ValueError(f"a vector has the components 0, 1 and 2, not {index}")
    return float(vector[index])


@records(_component)
def component(vector: VectorLike, index: int) -> Float:
    """Return the component of a vector along x (0), y (1) or z (2)."""


define("vector_add", lambda a, b: a + b, "({a} + {b})", Array3, a=Array3, b=Array3)
define("vector_subtract", lambda a, b: a - b, "({a} - {b})", Array3, a=Array3, b=Array3)
define("dot", _portable.dot, "{a}.dot({b})", float, a=Array3, b=Array3)
define("cross", np.cross, "{a}.cross({b})", Array3, a=Array3, b=Array3)
define("norm", _portable.norm, "{vector}.norm()", float, vector=Array3)


@kernel(spelling="({vector} * {factor})")
def _vector_scale(vector: Array3, factor: float) -> Array3:
    return vector * factor


@kernel(name="normalize", spelling="{vector}.normalized()")
def unit(vector: Array3) -> Array3:
    """Return the direction of a vector as a value."""
    length = _portable.norm(vector)
    if length < 1e-12:
        raise ValueError("a vector of length zero has no direction")
    return vector / length


@kernel(spelling="{vector}.rotate({axis}, {angle})")
def _vector_rotate(vector: Array3, axis: Array3, angle: float) -> Array3:
    return rotation(unit(axis), angle) @ vector


def _check_count(count: int, what: str) -> None:
    if count < 1:
        raise ValueError(f"{what} must be at least 1, got {count}")


def _points(vectors: tuple[Array3, ...]) -> ArrayN3:
    return np.array(vectors, float).reshape(-1, 3)


@records(_points)
def points(*vectors: VectorLike) -> Points:
    """Make a list of points [m]; wherever points are expected, a list of vectors does as well."""


def _row(start: Array3, step: Array3, count: int) -> ArrayN3:
    _check_count(count, "the count of points in a row")
    return start + np.arange(count)[:, None] * step


@records(_row)
def row(start: VectorLike, step: VectorLike, count: int) -> Points:
    """Make `count` points that begin at `start` and are a `step` apart [m].

    Examples:
        >>> array(cylinder(0.01, 0.1), at=row((0, 0, 0), (0.04, 0, 0), 6))
    """


def _grid(center: Array3, u: Array3, v: Array3, columns: int, rows: int) -> ArrayN3:
    _check_count(columns, "the columns of a grid")
    _check_count(rows, "the rows of a grid")
    across = np.arange(columns) - (columns - 1) / 2
    up = np.arange(rows) - (rows - 1) / 2
    return np.asarray((center + up[:, None, None] * v + across[None, :, None] * u).reshape(-1, 3))


@records(_grid)
def grid(center: VectorLike, u: VectorLike, v: VectorLike, *, columns: int, rows: int) -> Points:
    """Make a centered grid of points: neighbors differ by `u` in a row and by `v` between rows [m].

    Examples:
        >>> holes = grid((0, 0, 0), 0.03 * X, 0.03 * Z, columns=6, rows=3)
        >>> box(0.2, 0.02, 0.12) - array(bore(0.008, 0.05, axis=Y), at=holes)
    """


def _ring_points(center: Array3, radius: float, axis: Array3, count: int, start: float) -> ArrayN3:
    _check_count(count, "the count of points in a ring")
    if radius <= 0.0:
        raise ValueError(f"radius must be positive, got {radius:.6g} m")
    u, v = plane_of(unit(axis))
    angles = start + 2.0 * np.pi * np.arange(count) / count
    return np.asarray(
        center + radius * (_portable.cos(angles)[:, None] * u + _portable.sin(angles)[:, None] * v)
    )


@records(_ring_points)
def ring_points(
    center: VectorLike, radius: Scalar, *, count: int, axis: VectorLike = (0.0, 0.0, 1.0), start: Scalar = 0.0
) -> Points:
    """Make evenly spaced points on a circle about an axis [m].

    The angle `start` [rad] is counter-clockwise from X (from Y for the axis X).

    Examples:
        >>> cylinder(0.1, 0.02) - array(bore(0.01, 0.05), at=ring_points((0, 0, 0), 0.07, count=8))
    """


def plane_of(axis: Array3) -> tuple[Array3, Array3]:
    """Return two unit vectors that form a right-handed frame with a unit axis."""
    # the axes x, y, z give (y, z), (x, -z) and (x, y), so that rings start at the expected side
    helper = np.array([0.0, 1.0, 0.0]) if abs(axis[0]) > 0.9 else np.array([1.0, 0.0, 0.0])
    u = unit(helper - axis * _portable.dot(helper, axis))
    return u, np.cross(axis, u)


@kernel(spelling="{path}.points({count})")
def _along(path: Curve, count: int) -> ArrayN3:
    _check_count(count, "the count of points along a path")
    samples = np.vstack([path.points, path.points[:1]]) if path.closed else path.points
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(samples, axis=0), axis=1))])
    if count == 1:
        wanted = lengths[-1:] / 2
    elif path.closed:
        wanted = lengths[-1] * np.arange(count) / count
    else:
        wanted = np.linspace(0.0, lengths[-1], count)
    return np.stack([np.interp(wanted, lengths, samples[:, axis]) for axis in range(3)], axis=1)


@kernel(spelling="({points} + {offset})")
def _points_move(points: ArrayN3, offset: Array3) -> ArrayN3:
    return points + offset


@kernel(spelling="({points} * {factor})")
def _points_scale(points: ArrayN3, factor: float) -> ArrayN3:
    return points * factor
