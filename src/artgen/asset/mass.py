"""Exact mass, center of mass and inertia of polyhedra.

The integrals over a polyhedron are sums over the tetrahedra that its triangles span with a reference
point; see B. Mirtich, Fast and accurate computation of polyhedral mass properties, 1996.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Matrix, Triple
from artgen.asset.record import Record
from artgen.errors import AssetError

_DIGITS = 12  # significant digits of mass properties; the digits beyond depend on the order of additions
_ROWS, _COLUMNS = np.triu_indices(3)


@dataclass(frozen=True, eq=False)
class Moments(FrozenArrays):
    """Integrals over a solid about the origin: 1, x, and x x^T, each times density."""

    zeroth: float  # mass [kg], or volume [m^3] at density 1
    first: Array  # first moment, shape (3,) [kg m]
    second: Array  # second moment, shape (3, 3) [kg m^2]

    def scaled(self, factor: float) -> "Moments":
        """Return the moments multiplied by a density."""
        return Moments(self.zeroth * factor, self.first * factor, self.second * factor)


@dataclass(frozen=True, eq=False)
class MassProperties(FrozenArrays, Record):
    """Mass, center of mass and inertia of a rigid body."""

    mass: float  # mass [kg]
    center: Triple  # center of mass in asset coordinates at rest, shape (3,) [m]
    inertia: Matrix  # about the center of mass, along the asset's axes, shape (3, 3) [kg m^2]

    def principal(self) -> tuple[Array, Array]:
        """Return the principal moments, shape (3,), and the rotation to the principal axes, shape (3, 3).

        The rotation's columns are the axes in asset coordinates; its determinant is +1 and its signs
        do not depend on the linear-algebra library.
        """
        moments, axes = _portable.eigenvectors(self.inertia)
        for column in (0, 1):
            if axes[np.argmax(np.abs(axes[:, column]) > 0.5), column] < 0.0:
                axes[:, column] = -axes[:, column]
        axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
        return moments, axes

    def moved(self, matrix: Array) -> "MassProperties":
        """Return the properties after a rigid motion or a reflection, shape (4, 4)."""
        rotation = matrix[:3, :3]
        center = rotation @ self.center + matrix[:3, 3]
        return MassProperties(self.mass, center, rotation @ self.inertia @ rotation.T)

    def moments(self) -> Moments:
        """Return the moments about the asset's origin."""
        about_center = 0.5 * np.trace(self.inertia) * np.eye(3) - self.inertia
        second = about_center + self.mass * np.outer(self.center, self.center)
        return Moments(self.mass, self.mass * self.center, second)


def polyhedron_moments(vertices: Array, triangles: NDArray[np.int64]) -> Moments:
    """Integrate over a closed polyhedron of density 1.

    Its vertices have shape (n, 3) [m], its triangles, counter-clockwise seen from outside, shape (m, 3).
    """
    reference = 0.5 * (vertices.min(axis=0) + vertices.max(axis=0))
    # by coordinate, corner and triangle: NumPy adds and sorts rows fastest
    corners = np.empty((3, 4, len(triangles)))
    np.take((vertices - reference).T, triangles.T, axis=1, out=corners[:, :3])
    corners[:, 3] = corners[:, :3].sum(axis=1)
    (ax, bx, cx, _), (ay, by, cy, _), (az, bz, cz, _) = corners
    six_volumes = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    volume = float(np.sort(six_volumes).sum()) / 6.0
    products = (corners[_ROWS] * corners[_COLUMNS]).sum(axis=1)
    terms = np.sort(six_volumes * np.concatenate([corners[:, 3], products]), axis=1)
    # sorted, and added in their order: the order of triangles does not change the sum
    sums = np.ascontiguousarray(terms.T).sum(axis=0)
    first, second = sums[:3] / 24.0, np.empty((3, 3))
    second[_ROWS, _COLUMNS] = second[_COLUMNS, _ROWS] = sums[3:]
    # about the asset's origin
    crossed = np.outer(first, reference)
    second = second / 120.0 + crossed + crossed.T + volume * np.outer(reference, reference)
    return Moments(volume, first + volume * reference, second)


def total(moments: Iterable[Moments]) -> MassProperties:
    """Add up solids and express the sum as a rigid body's mass properties."""
    parts = list(moments)
    mass = float(sum(part.zeroth for part in parts))
    if not mass > 0.0:
        raise AssetError(f"a link of mass {mass:.3g} kg cannot move; give it a solid with a density")
    center = np.sum([part.first for part in parts], axis=0) / mass
    second = np.sum([part.second for part in parts], axis=0) - mass * np.outer(center, center)
    second = 0.5 * (second + second.T)
    inertia = np.trace(second) * np.eye(3) - second
    # rounding noise, such as the product of inertia of a symmetric solid, becomes exactly 0
    grain = 10.0 ** math.ceil(math.log10(np.trace(inertia)) - _DIGITS)
    return MassProperties(
        float(f"{mass:.{_DIGITS}g}"), np.round(center, _DIGITS) + 0.0, np.rint(inertia / grain) * grain + 0.0
    )
