"""New surfaces for old solids: other normals, texture coordinates or paint on the same triangles."""

from collections.abc import Callable

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array
from artgen.asset.creases import corner_normals
from artgen.asset.manifolds import manifold_of
from artgen.asset.shape import Shape
from artgen.colliders import Pieces
from artgen.colliders.triangles import cross
from artgen.nodes.contours import CREASE
from artgen.nodes.unwrap import boxed_uvs


def with_properties(manifold: Manifold, change: Callable[[Array], None]) -> Manifold:
    """Return the manifold after `change` wrote into its vertices: x y z and the channels, shape (n, 9)."""
    raw = manifold.to_mesh64()
    table = np.array(raw.vert_properties)
    change(table)
    return manifold_of(table, raw.tri_verts, raw.merge_from_vert, raw.merge_to_vert)


def faceted_shape(solid: Manifold, pieces: Pieces) -> Shape:
    """Return the shape of a bare manifold: normals split at creases, texture projected along them."""
    if solid.is_empty():
        raise ValueError("the result is empty")
    raw = solid.to_mesh64()
    places = np.array(raw.vert_properties)[:, :3]
    triangles = np.asarray(raw.tri_verts).astype(np.int64)
    corners = places[triangles]
    across = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(across, axis=1)
    flat = across / np.maximum(size, 1e-300)[:, None]
    normals = corner_normals(triangles, corners, CREASE)
    vertices = corners.reshape(-1, 3)
    uvs, side = boxed_uvs(vertices, np.repeat(flat, 3, axis=0), np.ptp(places, axis=0))
    table = np.column_stack([vertices, normals, uvs])
    _, first, group = np.unique(
        np.column_stack([triangles.ravel(), side, np.rint(normals * 1e6).astype(np.int64)]),
        axis=0,
        return_index=True,
        return_inverse=True,
    )
    group = group.ravel()
    kept = table[first]
    origin = triangles.ravel()[first]
    target = np.full(len(places), -1)
    target[origin[::-1]] = np.arange(len(first))[::-1]
    return Shape.from_mesh(
        kept[:, :3],
        kept[:, 3:6],
        kept[:, 6:8],
        group.reshape(-1, 3),
        pieces,
        targets=target[origin],
    )
