"""Convex hulls that have all corners of their points: manifold3d leaves one out at some sizes."""

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array
from artgen.colliders.triangles import across, planes_of, triangles_of

_ZOOMS = (7.0, 1000.0, 0.3)
"""At how many times their size points are tried again."""

_LOST = 1e-6  # [m]: a point farther out of the hull than this was lost
_MANY = 4_000_000  # heights above triangles beyond which it costs too much to look for lost points


def hull_of(points: Array) -> Manifold:
    """Return the convex hull of points, shape (n, 3) [m]; it is empty if they lie in one plane."""
    points = np.ascontiguousarray(points, np.float64)
    solid = Manifold.hull_points(points)
    if _has_all(solid, points):
        return solid
    for zoom in _ZOOMS:
        again = Manifold.hull_points(points * zoom).scale((1.0 / zoom,) * 3)
        if _has_all(again, points):
            return again
    return solid


def _has_all(solid: Manifold, points: Array) -> bool:
    if solid.num_vert() == len(points) or solid.num_tri() * len(points) > _MANY:
        return True
    mesh = solid.to_mesh64()
    corners = np.asarray(mesh.vert_properties)[:, :3][triangles_of(mesh)]
    planes = planes_of(corners, *across(corners))
    return bool(((planes[:, :3] @ points.T).max(axis=1) <= planes[:, 3] + _LOST).all())
