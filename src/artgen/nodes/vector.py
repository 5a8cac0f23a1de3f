"""Vectors in space: components, products, rotation."""

import numpy as np

from artgen.asset import rotation
from artgen.graph import kernel
from artgen.nodes.handles import Array3, Float, Scalar, Vector, VectorLike


@kernel
def _vector(x: float, y: float, z: float) -> Array3:
    return np.array([x, y, z])


def vector(x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Vector:
    """Make a vector from its components.

    Examples:
        >>> box(0.3, 0.2, 0.02) | box(0.1, 0.1, 0.1).at(vector(0.1, 0.0, 0.05))
    """
    return Vector.record(_vector, x=x, y=y, z=z)


X = vector(1.0, 0.0, 0.0)
"""Unit vector to the right."""
Y = vector(0.0, 1.0, 0.0)
"""Unit vector to the back; the front of an asset faces -Y."""
Z = vector(0.0, 0.0, 1.0)
"""Unit vector upward."""


@kernel
def _component(vector: Array3, index: int) -> float:
    if index not in (0, 1, 2):
        raise ValueError(f"a vector has the components 0, 1 and 2, not {index}")
    return float(vector[index])


def component(vector: VectorLike, index: int) -> Float:
    """Return the component of a vector along x (0), y (1) or z (2)."""
    return Float.record(_component, vector=vector, index=index)


@kernel(spelling="({a} + {b})")
def _vector_add(a: Array3, b: Array3) -> Array3:
    return a + b


def vector_add(a: VectorLike, b: VectorLike) -> Vector:
    """Add two vectors."""
    return Vector.record(_vector_add, a=a, b=b)


@kernel(spelling="({a} - {b})")
def _vector_subtract(a: Array3, b: Array3) -> Array3:
    return a - b


def vector_subtract(a: VectorLike, b: VectorLike) -> Vector:
    """Subtract the second vector from the first."""
    return Vector.record(_vector_subtract, a=a, b=b)


@kernel(spelling="({vector} * {factor})")
def _vector_scale(vector: Array3, factor: float) -> Array3:
    return vector * factor


def vector_scale(vector: VectorLike, factor: Scalar) -> Vector:
    """Multiply a vector by a number."""
    return Vector.record(_vector_scale, vector=vector, factor=factor)


@kernel
def _dot(a: Array3, b: Array3) -> float:
    return float(a @ b)


def dot(a: VectorLike, b: VectorLike) -> Float:
    """Return the scalar product; also written `a.dot(b)`."""
    return Float.record(_dot, a=a, b=b)


@kernel
def _cross(a: Array3, b: Array3) -> Array3:
    return np.cross(a, b)


def cross(a: VectorLike, b: VectorLike) -> Vector:
    """Return the vector product; also written `a.cross(b)`."""
    return Vector.record(_cross, a=a, b=b)


@kernel
def _norm(vector: Array3) -> float:
    return float(np.linalg.norm(vector))


def norm(vector: VectorLike) -> Float:
    """Return the length; also written `vector.norm()`."""
    return Float.record(_norm, vector=vector)


def unit(vector: Array3) -> Array3:
    """Return the direction of a vector as a value."""
    length = float(np.linalg.norm(vector))
    if length < 1e-12:
        raise ValueError("a vector of length zero has no direction")
    return vector / length


@kernel
def _normalize(vector: Array3) -> Array3:
    return unit(vector)


def normalize(vector: VectorLike) -> Vector:
    """Return the direction, a vector of length one; also written `vector.normalized()`."""
    return Vector.record(_normalize, vector=vector)


@kernel
def _vector_rotate(vector: Array3, axis: Array3, angle: float) -> Array3:
    return rotation(unit(axis), angle) @ vector


def vector_rotate(vector: VectorLike, axis: VectorLike, angle: Scalar) -> Vector:
    """Turn a vector about an axis through the origin by an angle [rad]."""
    return Vector.record(_vector_rotate, vector=vector, axis=axis, angle=angle)
