"""The triangles of manifold3d's meshes, and their planes."""

import numpy as np
from manifold3d import Mesh64

from artgen._arrays import Array, Indices

_NEXT, _AFTER = np.array([1, 2, 0]), np.array([2, 0, 1])

_NEEDLE = 1e-7  # [m]: height of a triangle below which it is a needle
_MANY = 2000  # triangles below which manifold3d works in one thread


def triangles_of(mesh: Mesh64) -> Indices:
    """Return the triangles of a convex hull as vertex indices, shape (m, 3), always in one order.

    Of large hulls it makes the triangles in several threads, one of which may be ahead of another.
    """
    triangles = np.asarray(mesh.tri_verts).astype(np.int64)
    if len(triangles) < _MANY:
        return triangles
    first = triangles.argmin(axis=1)[:, None]
    turned = np.take_along_axis(triangles, (first + np.arange(3)) % 3, axis=1)
    return turned[np.lexsort(turned.T[::-1])]


def cross(first: Array, second: Array) -> Array:
    """Return the cross products of vectors, shape (..., 3)."""
    product: Array = first[..., _NEXT] * second[..., _AFTER] - first[..., _AFTER] * second[..., _NEXT]
    return product


def across(corners: Array) -> tuple[Array, Array]:
    """Return normals as long as triangles' doubled areas, and these, of corners, shape (m, 3, 3)."""
    normals = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals, np.sqrt(np.sum(normals * normals, axis=1))


def planes_of(corners: Array, normals: Array, area: Array) -> Array:
    """Return the planes of triangles but needles as (nx, ny, nz, d), inside is `n.x <= d`, shape (k, 4).

    Args:
        corners: Of the triangles, shape (m, 3, 3) [m].
        normals: As `across` returns them.
        area: The same.
    """
    sides = corners - np.roll(corners, 1, axis=1)
    longest = np.sqrt(np.sum(sides * sides, axis=2)).max(axis=1)
    sound = area > _NEEDLE * longest  # the normal of a needle means nothing
    planes = np.empty((np.count_nonzero(sound), 4))
    planes[:, :3] = normals[sound] / area[sound, None]
    planes[:, 3] = np.sum(planes[:, :3] * corners[sound, 0], axis=1)
    return planes
