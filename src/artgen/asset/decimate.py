"""Simplification of a surface within a given distance."""

import math

import numpy as np

from artgen._arrays import Array
from artgen.asset.manifolds import coincident
from artgen.asset.shape import Mesh, Shape
from artgen.asset.surface import corner_normals

_CREASE = math.radians(62.0)  # smooth below: a round surface with few facets has large angles between them

_SHARES = (1.0, 0.8, 0.6, 0.3, 0.1, 0.03)  # shares of the precision to try
_KEPT = 0.9  # least share of the area; below it, parts have vanished
_POINT = 1e-9  # radius of a ball that represents a point [m]


def coarser(shape: Shape, precision: float) -> Mesh:
    """Return a surface with fewer triangles, within a precision of the shape's surface [m].

    Remaining vertices keep their texture coordinates and paint. Normals are computed again: normals of a
    removed round edge would shade the faces next to it. Features thinner than the precision, such as print,
    are kept to a share of it.
    """
    mesh = shape.mesh  # its order decides which vertices are removed
    same = Shape.from_mesh(
        mesh.vertices, mesh.normals, mesh.uvs, mesh.triangles, shape.pieces, paints=mesh.paints
    )
    area, paints = same.manifold.surface_area(), set(mesh.paints.tolist())
    for share in _SHARES:
        solid = same.manifold.simplify(share * precision)
        fewer = Shape(solid, shape.pieces).mesh
        if solid.surface_area() <= _KEPT * area or set(fewer.paints.tolist()) != paints:
            continue
        if lies_within(precision, mesh.vertices, fewer):  # along a curve, steps add up
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
    """Tell whether all points, shape (n, 3), lie within a distance of a surface [m]."""
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
