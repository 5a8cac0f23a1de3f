"""Fewer triangles for a surface, within a given distance of it."""

import math

import numpy as np

from artgen._arrays import Array
from artgen.asset.manifolds import coincident
from artgen.asset.shape import Mesh, Shape
from artgen.asset.surface import corner_normals

_CREASE = math.radians(62.0)  # the fewer facets a round thing has, the more they turn

_SHARES = (1.0, 0.8, 0.6, 0.3, 0.1, 0.03)  # of the precision that are tried
_KEPT = 0.9  # of the area, or things have gone
_POINT = 1e-9  # radius of a ball that stands for a point [m]


def coarser(shape: Shape, precision: float) -> Mesh:
    """Return a surface of fewer triangles: no point of it lies farther than that from the shape's.

    Vertices that are left keep their texture coordinates and paint. Normals are new: those of a rounded
    edge that is gone would shade the faces beside it. What is thinner than the precision, as print is, is
    kept to a part of it.
    """
    mesh = shape.mesh  # in an order of its own, which decides what goes
    same = Shape.from_mesh(
        mesh.vertices, mesh.normals, mesh.uvs, mesh.triangles, shape.pieces, paints=mesh.paints
    )
    area, paints = same.manifold.surface_area(), set(mesh.paints.tolist())
    for share in _SHARES:
        solid = same.manifold.simplify(share * precision)
        fewer = Shape(solid, shape.pieces).mesh
        if solid.surface_area() <= _KEPT * area or set(fewer.paints.tolist()) != paints:
            continue
        if lies_within(precision, mesh.vertices, fewer):  # steps add up along a curve
            break
    else:
        return mesh
    corners = fewer.triangles.ravel()
    places = coincident(fewer.vertices)
    normals = corner_normals(places[fewer.triangles], fewer.vertices[fewer.triangles], _CREASE, by="area")
    return Mesh(
        fewer.vertices[corners],
        normals,
        fewer.uvs[corners],
        fewer.paints[corners],
        np.arange(len(corners)).reshape(-1, 3),
    )


def lies_within(distance: float, points: Array, mesh: Mesh) -> bool:
    """Tell whether no point, of shape (n, 3), is farther than a distance from a surface [m]."""
    import fcl
    from scipy.spatial import cKDTree

    near = cKDTree(mesh.vertices).query(points, distance_upper_bound=distance)[0]
    far = np.unique(points[near > distance], axis=0)
    if not len(far):
        return True
    faces = fcl.BVHModel()
    faces.beginModel(len(mesh.vertices), len(mesh.triangles))
    faces.addSubModel(mesh.vertices, mesh.triangles)
    faces.endModel()
    surface, ball = fcl.CollisionObject(faces), fcl.Sphere(_POINT)
    return all(
        fcl.distance(fcl.CollisionObject(ball, fcl.Transform(point)), surface) <= distance for point in far
    )
