"""Solids as meshes in which each point is there once, and their connected parts."""

import numpy as np
from manifold3d import Manifold, Mesh64
from numpy.typing import NDArray

from artgen._arrays import Array

_DUST = 1e-15  # [m^3]: a part of less volume, that of a cube of 0.01 mm, is a crumb of a boolean


def closed_mesh(solid: Manifold) -> tuple[Array, NDArray[np.int64]]:
    """Return the vertices of a solid, each point once, shape (n, 3) [m], and its triangles, shape (m, 3)."""
    mesh = solid.to_mesh64()
    vertices = np.array(mesh.vert_properties)[:, :3]
    target = np.arange(len(vertices))
    merged, first, corners = (
        np.asarray(numbers).astype(np.int64)
        for numbers in (mesh.merge_from_vert, mesh.merge_to_vert, mesh.tri_verts)
    )
    target[merged] = first
    used, triangles = np.unique(target[corners], return_inverse=True)
    return vertices[used], triangles.reshape(-1, 3)


def connected_parts(solid: Manifold) -> list[Manifold]:
    """Return the connected parts of a solid with their closed hollows, the smallest first, without crumbs."""
    shells = sorted(solid.decompose(), key=_rank)
    parts = [shell for shell in shells if shell.volume() > _DUST]
    for wall in (shell for shell in shells if shell.volume() < -_DUST):  # of a hollow, turned inside out
        around = next((number for number, part in enumerate(parts) if _inside(wall, part)), None)
        if around is not None:
            vertices, triangles = closed_mesh(wall)
            hollow = Manifold(Mesh64(np.array(vertices), triangles[:, ::-1].astype(np.uint64)))
            parts[around] -= hollow
    return parts


def _rank(shell: Manifold) -> tuple[float, ...]:
    return (round(shell.volume(), 15), *(round(number, 9) for number in shell.bounding_box()))


def _inside(inner: Manifold, outer: Manifold) -> bool:
    first, second = (np.array(solid.bounding_box()).reshape(2, 3) for solid in (inner, outer))
    return bool((first[0] >= second[0]).all() and (first[1] <= second[1]).all())
