"""Fewer triangles for a surface, within a given distance of it."""

import math

import numpy as np
from numpy.typing import NDArray

from artgen.asset.creases import corner_normals
from artgen.asset.manifolds import coincident
from artgen.asset.shape import Mesh, Shape

Array = NDArray[np.float64]

_CREASE = math.radians(62.0)  # the fewer facets a round thing has, the more they turn

_SHARES = (1.0, 0.6, 0.3, 0.1, 0.03)  # of the precision that are tried
_KEPT = 0.9  # of the area, or things have gone


def coarser(shape: Shape, precision: float) -> Mesh:
    """Return a surface of fewer triangles: no point of it lies farther than that from the shape's.

    Vertices that are left keep their texture coordinates and paint. Normals are made anew: those of a rounded
    edge that is gone would shade the faces beside it. What is thinner than the precision, as print is, is
    kept to a part of it.

    Args:
        shape: The solid.
        precision: How far [m].
    """
    mesh = shape.mesh  # in an order of its own, which decides what goes
    same = Shape.from_mesh(
        mesh.vertices, mesh.normals, mesh.uvs, mesh.triangles, shape.pieces, paints=mesh.paints
    )
    area, paints = same.manifold.surface_area(), set(mesh.paints.tolist())
    for share in _SHARES:
        solid = same.manifold.simplify(share * precision)
        fewer = Shape(solid, shape.pieces).mesh
        if solid.surface_area() > _KEPT * area and set(fewer.paints.tolist()) == paints:
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
