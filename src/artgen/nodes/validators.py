"""Checks of kernel inputs; messages name the value and its unit."""

import math
from typing import Any

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.colliders.triangles import cross
from artgen.graph import detail_level


def positive(name: str, value: float, unit: str = "m") -> float:
    """Return a value that is finite and above zero."""
    if not (math.isfinite(value) and value > 0.0):
        raise ValueError(f"{name} must be positive, got {value:g} {unit}")
    return float(value)


def sizes(name: str, *values: float) -> Array:
    """Return the sizes along x, y and z, each finite and above zero, shape (3,) [m]."""
    return np.array([positive(f"{name} {axis}", value) for axis, value in zip("xyz", values, strict=True)])


def between(name: str, value: float, low: float, high: float, unit: str = "m") -> float:
    """Return a value within `low` and `high`, both allowed."""
    if not low <= value <= high:
        raise ValueError(f"{name} must be within {low:g} and {high:g} {unit}, got {value:g} {unit}")
    return float(value)


def rounding(name: str, value: float, most: float) -> float:
    """Return a bevel radius between 0 and `most` [m]; below a micrometre, or more at low detail, it is 0."""
    radius = between(name, value, 0.0, most)
    return radius if radius >= detail_level().sharp else 0.0


def finite(name: str, value: float, unit: str = "m") -> float:
    """Return a value that is a finite number."""
    if not math.isfinite(value):
        raise ValueError(f"{name} must be a finite number, got {value:g} {unit}")
    return float(value)


def vector(name: str, value: Any) -> Array:
    """Return three finite numbers, shape (3,)."""
    array = np.asarray(value, float)
    if array.shape != (3,):
        raise ValueError(f"{name} must have 3 components, got shape {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite, got ({', '.join(f'{x:g}' for x in array)})")
    return array


def points(name: str, value: Any, dimension: int, least: int) -> Array:
    """Return at least `least` finite points, shape (n, dimension)."""
    array = np.asarray(value, float)
    if array.ndim != 2 or array.shape[1] != dimension:
        raise ValueError(f"{name} must be points of shape (n, {dimension}), got shape {array.shape}")
    if len(array) < least:
        raise ValueError(f"{name} needs at least {least} points, got {len(array)}")
    if not np.isfinite(array).all():
        bad = int(np.flatnonzero(~np.isfinite(array).all(axis=1))[0])
        raise ValueError(f"{name} must be finite; point {bad} is {tuple(array[bad].tolist())}")
    return array


def direction(name: str, value: Any) -> Array:
    """Return the unit vector along a direction, shape (3,)."""
    array = vector(name, value)
    length = _portable.norm(array)
    if length < 1e-12:
        raise ValueError(f"{name} must have a direction, got a vector of length {length:g}")
    return array / length


def frame(axis: Any, name: str = "axis") -> Array:
    """Return the rotation, shape (3, 3), with local x, y and z as columns, for a solid made along z.

    Local z is `axis`. Local x is the first asset axis, in the order X, Y, Z, that is not nearest to `axis`,
    made perpendicular to it. Z gives the identity.
    """
    along = direction(name, axis)
    near = int(np.argmax(np.abs(along)))
    first = np.zeros(3)
    first[0 if near else 1] = 1.0
    across = first - along * _portable.dot(first, along)
    across /= _portable.norm(across)
    return np.column_stack([across, cross(along, across), along]) + 0.0


def frame_is_mirrored(rotation: Array) -> bool:
    """Tell whether local y of a `frame` points against the last of the asset's two other axes."""
    near = int(np.argmax(np.abs(rotation[:, 2])))
    return bool(rotation[1 if near == 2 else 2, 1] < 0.0)
