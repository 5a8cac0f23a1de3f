"""Boxes to put on the links of assets, so that checks have something to find."""

from dataclasses import replace

import numpy as np
from manifold3d import Manifold

from artgen.asset import Piece, Shape
from artgen.asset.manifolds import manifold_of
from artgen.colliders import Convex, Exact
from artgen.materials import material

STEEL = material("steel")


def block(size, center=(0.0, 0.0, 0.0), *, inward=False):
    """A box as a solid, or as one that is turned inside out."""
    cube = Manifold.cube(size, center=True).translate(center).to_mesh64()
    corners = np.asarray(cube.vert_properties)[np.asarray(cube.tri_verts).astype(int)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.repeat(normals / np.linalg.norm(normals, axis=1, keepdims=True), 3, axis=0)
    vertices, triangles = corners.reshape(-1, 3), np.arange(36).reshape(-1, 3)
    pose = np.eye(4)
    pose[:3, 3] = center
    pieces = Exact((Convex.box(size, pose),))
    shape = Shape.from_mesh(vertices, normals, np.zeros((36, 2)), triangles, pieces)
    if not inward:
        return shape
    raw = shape.manifold.to_mesh64()
    table = np.array(raw.vert_properties) * ([1.0] * 3 + [-1.0] * 3 + [1.0] * 3)
    return Shape(manifold_of(table, raw.tri_verts[:, ::-1], raw.merge_from_vert, raw.merge_to_vert), pieces)


def with_shapes(asset, *shapes, visual=False):
    """The asset with more solids, or details, on its base."""
    base, *others = asset.links
    pieces = (*base.pieces, *(Piece("extra", STEEL, shape, visual) for shape in shapes))
    return replace(asset, links=(replace(base, pieces=pieces), *others))
