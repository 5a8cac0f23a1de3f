"""Triangles and convex hulls of manifold3d's meshes, and their planes."""

import numpy as np
from manifold3d import Manifold, Mesh64

from artgen._arrays import Array, Indices

_NEXT, _AFTER = np.array([1, 2, 0]), np.array([2, 0, 1])

_NEEDLE = 1e-7  # height below which a triangle is degenerate [m]
_MANY = 2000  # number of triangles below which manifold3d uses one thread


def triangles_of(mesh: Mesh64) -> Indices:
    """Return the triangles of a convex hull as vertex indices, shape (m, 3), in a fixed order.

    manifold3d makes the triangles of large hulls in several threads, in a varying order.
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
    """Return normals with twice the area as length, and these areas, of corners, shape (m, 3, 3)."""
    normals = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals, np.sqrt(np.sum(normals * normals, axis=1))


def planes_of(corners: Array, normals: Array, area: Array) -> Array:
    """Return the planes of non-degenerate triangles as (nx, ny, nz, d), inside is `n.x <= d`, shape (k, 4).

    Args:
        corners: Corners of the triangles, shape (m, 3, 3) [m].
        normals: Normals from `across`.
        area: Areas from `across`.
    """
    sides = corners - np.roll(corners, 1, axis=1)
    longest = np.sqrt(np.sum(sides * sides, axis=2)).max(axis=1)
    sound = area > _NEEDLE * longest  # degenerate triangles have no valid normal
    planes = np.empty((np.count_nonzero(sound), 4))
    planes[:, :3] = normals[sound] / area[sound, None]
    planes[:, 3] = np.sum(planes[:, :3] * corners[sound, 0], axis=1)
    return planes


_ZOOMS = (7.0, 1000.0, 0.3)
"""Scales at which points are tried again."""

_LOST = 1e-6  # a point farther outside the hull than this was lost [m]
_MANY_HEIGHTS = 4_000_000  # most heights above triangles for a search of lost points


def hull_of(points: Array) -> Manifold:
    """Return the convex hull of points, shape (n, 3) [m]; empty if they lie in one plane."""
    points = np.ascontiguousarray(points, np.float64)
    solid = Manifold.hull_points(points)
    if _is_around(solid, points):
        return solid
    for zoom in _ZOOMS:
        again = Manifold.hull_points(points * zoom).scale((1.0 / zoom,) * 3)
        if _is_around(again, points):
            return again
    return solid


def _is_around(solid: Manifold, points: Array) -> bool:
    """Tell whether no point is outside the plane of a triangle; lost points and corners of dents are."""
    if solid.num_tri() * len(points) > _MANY_HEIGHTS:
        return True
    mesh = solid.to_mesh64()
    vertices, triangles = np.asarray(mesh.vert_properties)[:, :3], triangles_of(mesh)
    corner, one, other = vertices[triangles.T]
    one, other = one - corner, other - corner
    normals = cross(one, other)
    squares = (np.einsum("ij,ij->i", each, each) for each in (normals, one, other))
    area, first, second = map(np.sqrt, squares)
    sound = area > _NEEDLE * np.maximum(first, second)  # degenerate triangles have no valid normal
    # BLAS is three times as fast, and the last digits decide nothing here
    heights = (normals @ points.T).max(axis=1) - np.einsum("ij,ij->i", normals, corner)
    return bool((heights <= _LOST * area)[sound].all())
