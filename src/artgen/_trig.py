"""Trigonometric functions of arrays whose last digit does not depend on the processor.

On processors with AVX-512, NumPy has kernels of its own for sines, cosines and their inverses; on others it
calls the C library. The results differ in the last digit. One digit can change the order of the vertices of a
hull and so the bytes of an asset. NumPy's complex functions and those of `math` always call the C library.
"""

import math
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array

Floats = NDArray[np.floating[Any]]

_tan, _arctan, _arccos = (np.frompyfunc(each, 1, 1) for each in (math.tan, math.atan, math.acos))


@overload
def sin(angle: float) -> float: ...
@overload
def sin(angle: Floats) -> Array: ...
def sin(angle: Floats | float) -> Array | float:
    """Return the sine of each angle [rad], of any shape."""
    return np.exp(1j * angle).imag


@overload
def cos(angle: float) -> float: ...
@overload
def cos(angle: Floats) -> Array: ...
def cos(angle: Floats | float) -> Array | float:
    """Return the cosine of each angle [rad], of any shape."""
    return np.exp(1j * angle).real


def cos_sin(angle: Floats) -> tuple[Array, Array]:
    """Return the cosine and the sine of each angle [rad], of any shape."""
    turn = np.exp(1j * angle)
    return turn.real, turn.imag


@overload
def arctan2(y: float, x: float) -> float: ...
@overload
def arctan2(y: Floats, x: Floats) -> Array: ...
def arctan2(y: Floats | float, x: Floats | float) -> Array | float:
    """Return the angle of each point (x, y), -pi to pi [rad]; 0 for the origin."""
    y, x = np.broadcast_arrays(y, x)
    point = np.empty(x.shape, np.complex128)
    point.real, point.imag = np.where((x == 0.0) & (y == 0.0), 1.0, x), y
    return np.log(point).imag[()]


def tan(angle: Floats) -> Array:
    """Return the tangent of each angle [rad], of any shape."""
    return np.asarray(_tan(angle), np.float64)


def arctan(slope: Floats) -> Array:
    """Return the angle of each slope, -pi/2 to pi/2 [rad], of any shape."""
    return np.asarray(_arctan(slope), np.float64)


def arccos(cosine: Floats) -> Array:
    """Return the angle of each cosine in -1..1, 0 to pi [rad], of any shape."""
    return np.asarray(_arccos(cosine), np.float64)
