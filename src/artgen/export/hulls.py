"""The triangles of hull colliders, which all formats share."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.asset.record import DECIMALS
from artgen.colliders import Convex
from artgen.colliders.hull import hull_of

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

HULL_DECIMALS = 9
"""Decimals of a hull's vertices [m]; the hull is of the rounded ones, so it is convex as it is written."""


@dataclass(frozen=True, eq=False)
class Hull:
    """The surface of a convex piece, in its link's frame.

    Attributes:
        vertices: Shape (n, 3) [m].
        triangles: Counter-clockwise seen from outside, shape (m, 3).
        normals: Unit outward normal of each triangle, shape (m, 3); zeros where it has no area.
    """

    vertices: Array
    triangles: Indices
    normals: Array

    @staticmethod
    def of(pieces: Sequence[tuple[Convex, Array]]) -> "tuple[Hull, ...]":
        """Make the surfaces of hull colliders, each taken from asset coordinates to a frame at an origin."""
        # first as asset.json has them, so that an asset which was read from files gives the same hulls
        meshes = [
            hull_of(
                np.round(np.round(convex.points, DECIMALS) - np.round(origin, DECIMALS), HULL_DECIMALS)
            ).to_mesh64()
            for convex, origin in pieces
        ]
        vertices = [np.asarray(mesh.vert_properties)[:, :3] for mesh in meshes]
        triangles = [np.asarray(mesh.tri_verts).astype(np.int64) for mesh in meshes]
        return tuple(map(Hull, vertices, triangles, _normals(vertices, triangles)))


@lru_cache(maxsize=1)  # several formats are written of one asset after another
def hulls(asset: Asset) -> Mapping[str, Mapping[int, Hull]]:
    """Return the hulls among the colliders of each link, by the collider's number."""
    numbers = {
        link.name: [number for number, item in enumerate(link.colliders) if item.convex.kind == "hull"]
        for link in asset.links
    }
    found = iter(
        Hull.of(
            [
                (asset.link(link).colliders[number].convex, asset.origin(link))
                for link, of_link in numbers.items()
                for number in of_link
            ]
        )
    )
    return {link: {number: next(found) for number in of_link} for link, of_link in numbers.items()}


def _normals(vertices: Sequence[Array], triangles: Sequence[Indices]) -> list[Array]:
    """Return the normals of the triangles of many meshes; at once, for there are many of a few triangles."""
    if not vertices:
        return []
    starts = np.cumsum([0, *map(len, vertices)])
    corners = np.concatenate([of_mesh + start for of_mesh, start in zip(triangles, starts[:-1], strict=True)])
    a, b, c = np.concatenate(vertices)[corners.T]
    normals = np.cross(b - a, c - a)
    length = np.sqrt(np.sum(normals * normals, axis=1, keepdims=True))
    normals /= np.where(length > 0.0, length, 1.0)
    return np.split(normals, np.cumsum([len(of_mesh) for of_mesh in triangles])[:-1])
