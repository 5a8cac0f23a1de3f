"""Triangles of hull colliders, shared by all formats."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, FrozenArrays, Indices, cached
from artgen.asset import Asset
from artgen.asset.record import DECIMALS
from artgen.colliders import Convex
from artgen.colliders.triangles import hull_of

Surface = tuple[Array, Indices]
"""Vertices, shape (n, 3) [m], and triangles, shape (m, 3)."""

HULL_DECIMALS = 9
"""Decimals of a hull's vertices [m]; rounding comes first, so the written hull is convex."""


_FLAT = 1e-9  # height below which a triangle has no area [m]
_MIDDLE_DECIMALS = 6  # decimals of the position of a hull in its link's frame [m]


@dataclass(frozen=True, eq=False)
class Hull(FrozenArrays):
    """The surface of a convex piece about its own center.

    PhysX computes hulls in single precision: for small pieces with vertices far from the origin it finds
    contacts that are centimetres deep.
    """

    middle: Array  # position of its frame in the link's frame, shape (3,) [m]
    vertices: Array  # vertices in its frame, shape (n, 3) [m]
    triangles: Indices  # counter-clockwise seen from outside, shape (m, 3)
    normals: Array  # unit outward normal of each triangle, shape (m, 3)

    @staticmethod
    def of(pieces: Sequence[tuple[Convex, Array]]) -> "tuple[Hull, ...]":
        """Make the surfaces of hull colliders, moved from asset coordinates to the frame at an origin."""
        middles, found = [], []
        for convex, origin in pieces:
            # round like asset.json first, so that a loaded asset gives the same hulls
            points = np.round(convex.points, DECIMALS) - np.round(origin, DECIMALS)
            middles.append(np.round(0.5 * (points.min(axis=0) + points.max(axis=0)), _MIDDLE_DECIMALS))
            found.append(_surface(np.round(points - middles[-1], HULL_DECIMALS)))
        normals = _normals(found)
        for number, of_hull in enumerate(normals):
            if not of_hull.any(axis=1).all():
                found[number] = _with_areas(*found[number])
                (normals[number],) = _normals(found[number : number + 1])
        return tuple(
            Hull(middle, *surface, of_hull)
            for middle, surface, of_hull in zip(middles, found, normals, strict=True)
        )

    @property
    def placed(self) -> Array:
        """The vertices in the frame of its link, shape (n, 3) [m]."""
        return self.vertices + self.middle


def _surface(points: Array) -> Surface:
    mesh = hull_of(points).to_mesh64()
    return np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts).astype(np.int64)


def _with_areas(vertices: Array, triangles: Indices) -> Surface:
    """Remove points on the edges of a hull, which rounding may keep as corners."""
    while not (has_area := _normals([(vertices, triangles)])[0].any(axis=1)).all():
        a, b, c = vertices[triangles[~has_area].T]
        opposite = np.sum(np.square([c - b, a - c, b - a]), axis=2)  # squared side lengths
        between = np.take_along_axis(triangles[~has_area], opposite.argmax(axis=0)[:, None], axis=1)
        vertices, triangles = _surface(np.delete(vertices, np.unique(between), axis=0))
    return vertices, triangles


@cached(1)  # several formats of one asset are written in sequence
def hulls(asset: Asset, *, in_links: bool = True) -> Mapping[str, Mapping[int, Hull]]:
    """Return the hulls among the colliders of each link by number, in the frame of the link or the asset."""
    pieces = [
        (link.name, number, item.convex, asset.origin(link.name) if in_links else np.zeros(3))
        for link in asset.links
        for number, item in enumerate(link.colliders)
        if item.convex.kind == "hull"
    ]
    result: dict[str, dict[int, Hull]] = {link.name: {} for link in asset.links}
    made = Hull.of([piece[2:] for piece in pieces])
    for (link, number, *_), hull in zip(pieces, made, strict=True):
        result[link][number] = hull
    return result


def _normals(surfaces: Sequence[Surface]) -> list[Array]:
    """Return the normals of the triangles of many meshes; zero for triangles without area."""
    # one call for all meshes, because there are many with few triangles
    if not surfaces:
        return []
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in surfaces)])
    corners = np.concatenate([faces + start for (_, faces), start in zip(surfaces, starts[:-1], strict=True)])
    a, b, c = np.concatenate([vertices for vertices, _ in surfaces])[corners.T]
    normals = np.cross(b - a, c - a)
    length = np.sqrt(np.sum(normals * normals, axis=1, keepdims=True))
    sides = np.square([b - a, c - b, a - c]).sum(axis=2)
    flat = length < _FLAT * np.sqrt(sides.max(axis=0))[:, None]
    normals = np.where(flat, 0.0, normals / np.where(flat, 1.0, length))
    return np.split(normals, np.cumsum([len(faces) for _, faces in surfaces])[:-1])
