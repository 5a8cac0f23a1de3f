"""The triangles of manifold3d's meshes."""

import numpy as np
from manifold3d import Mesh64
from numpy.typing import NDArray

Indices = NDArray[np.int64]

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
