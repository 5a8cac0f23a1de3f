"""Arithmetic whose last digit does not depend on the processor: trigonometry and products of matrices.

On processors with AVX-512, NumPy has kernels of its own for sines, cosines and their inverses; on others it
calls the C library. NumPy's complex functions and those of `math` always call the C library. BLAS and LAPACK
have other kernels for each kind of processor as well. The results differ in the last digit. One digit can
change the order of the vertices of a hull and so the bytes of an asset.
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


def product(first: Array, second: Array) -> Array:
    """Return the matrix product `first @ second` of arrays with at most two axes each.

    BLAS sums in an order that depends on the processor where a factor is a vector, a sum has many terms or
    the result has over 200 columns. Elsewhere `@` gives the same digits on all processors with FMA.
    """
    # einsum is up to eight times as slow with a transposed factor
    result: Array = np.einsum(_PRODUCTS[first.ndim, second.ndim], first, np.ascontiguousarray(second))
    return result


_PRODUCTS = {(1, 2): "i,ij->j", (2, 1): "ij,j->i", (2, 2): "ij,jk->ik"}


def dot(first: Array, second: Array) -> float:
    """Return the scalar product of two vectors, each shape (n,)."""
    return float(np.einsum("i,i", first, second))


def norm(vector: Array) -> float:
    """Return the length of a vector, shape (n,)."""
    return math.sqrt(np.einsum("i,i", vector, vector))


def inverse(matrix: Array) -> Array:
    """Return the inverse of each matrix, shape (..., 2, 2), (..., 3, 3), or (..., 4, 4) if it is affine.

    A matrix of determinant 0 gives numbers that are not finite.
    """
    result = np.empty_like(matrix)
    if matrix.shape[-1] == 2:
        (a, b), (c, d) = np.moveaxis(matrix, (-2, -1), (0, 1))
        result[..., 0, 0], result[..., 0, 1], result[..., 1, 0], result[..., 1, 1] = d, -b, -c, a
        return np.asarray(result / (a * d - b * c)[..., None, None])
    linear = matrix[..., :3, :3]
    rows = linear[..., [1, 2, 0], :], linear[..., [2, 0, 1], :]
    minors = (
        rows[0][..., [1, 2, 0]] * rows[1][..., [2, 0, 1]] - rows[0][..., [2, 0, 1]] * rows[1][..., [1, 2, 0]]
    )
    determinant = np.sum(linear[..., 0, :] * minors[..., 0, :], axis=-1)
    result[..., :3, :3] = np.swapaxes(minors, -1, -2) / determinant[..., None, None]
    if matrix.shape[-1] == 4:
        result[..., :3, 3] = -np.sum(result[..., :3, :3] * matrix[..., None, :3, 3], axis=-1)
        result[..., 3, :] = 0.0, 0.0, 0.0, 1.0
    return result


def eigenvectors(symmetric: Array) -> tuple[Array, Array]:
    """Return the eigenvalues in rising order, shape (3,), and the eigenvectors as columns, shape (3, 3).

    It turns pairs of axes until nothing is left beside the diagonal (the method of Jacobi).
    """
    a, axes = symmetric.tolist(), np.eye(3).tolist()
    for _ in range(_SWEEPS):
        for i, j in ((0, 1), (0, 2), (1, 2)):
            if abs(a[i][j]) <= _BESIDE * (abs(a[i][i]) + abs(a[j][j])):
                continue
            half = (a[j][j] - a[i][i]) / (2.0 * a[i][j])
            tangent = math.copysign(1.0, half) / (abs(half) + math.sqrt(half * half + 1.0))
            cosine = 1.0 / math.sqrt(tangent * tangent + 1.0)
            sine = tangent * cosine
            for row in (*a, *axes):
                row[i], row[j] = cosine * row[i] - sine * row[j], sine * row[i] + cosine * row[j]
            a[i], a[j] = (
                [cosine * x - sine * y for x, y in zip(a[i], a[j], strict=True)],
                [sine * x + cosine * y for x, y in zip(a[i], a[j], strict=True)],
            )
    order = sorted(range(3), key=lambda each: a[each][each])
    return np.array([a[each][each] for each in order]), np.array(axes)[:, order]


_SWEEPS = 12  # five are enough in practice
_BESIDE = 1e-17  # share of the diagonal that is zero
