"""Meshes of a GLB file: one per link, with a primitive for each surface."""

import numpy as np

from artgen._arrays import Array
from artgen.asset import Mesh, Surface
from artgen.asset.surface import texture_coordinates
from artgen.export.glb.buffer import Buffer, Json
from artgen.materials.textures import Kind

_NO_DIRECTION = 1e-9  # a tangent shorter than this share of the longest one has no direction


def primitive(buffer: Buffer, surface: Surface, origin: Array, maps: tuple[Kind, ...]) -> Json:
    """Add a surface to a buffer.

    Args:
        buffer: Buffer for the arrays.
        surface: The surface, in asset coordinates.
        origin: Origin of the link's frame in asset coordinates, shape (3,) [m].
        maps: Maps of its material; without maps it needs no texture coordinates, without normal maps no
            tangents.

    Returns:
        The primitive as JSON data without its material.
    """
    mesh = surface.mesh
    attributes = {
        "POSITION": buffer.array("positions", mesh.vertices - origin),
        "NORMAL": buffer.array("normals", mesh.normals),
    }
    if maps:
        coordinates = texture_coordinates(mesh, surface.material)
        # the origin of images is at the top: v points down
        attributes["TEXCOORD_0"] = buffer.array("texcoords", coordinates * (1.0, -1.0) + (0.0, 1.0))
        if "normal" in maps:
            attributes["TANGENT"] = buffer.array("tangents", tangents(mesh, coordinates))
    return {
        "attributes": attributes,
        "indices": buffer.triangles(mesh.triangles, len(mesh.vertices)),
        "extras": {"name": surface.name, "label": surface.label},
    }


def tangents(mesh: Mesh, coordinates: Array) -> Array:
    """Return for each vertex the direction of growing u, and whether v grows to its left.

    Readers would compute different tangents; given tangents make all readers draw the same.
    """
    sides = _sides(mesh.vertices[mesh.triangles])
    (du, dv), (eu, ev) = (side.T for side in _sides(coordinates[mesh.triangles]))
    way = np.sign(du * ev - eu * dv)
    along_u = _summed(mesh, (sides[0] * ev[:, None] - sides[1] * dv[:, None]) * way[:, None])
    along_v = _summed(mesh, (sides[1] * du[:, None] - sides[0] * eu[:, None]) * way[:, None])
    normals = mesh.normals
    along_u -= normals * (normals * along_u).sum(axis=1, keepdims=True)
    length = np.sqrt((along_u**2).sum(axis=1))
    lost = length <= _NO_DIRECTION * length.max(initial=0.0)
    along_u[lost] = _perpendicular(normals[lost])
    length[lost] = 1.0
    along_u /= length[:, None]
    left = (np.cross(normals, along_u) * along_v).sum(axis=1) >= 0.0
    return np.column_stack([along_u, np.where(left, 1.0, -1.0)])


def _sides(corners: Array) -> tuple[Array, Array]:
    """Return two sides of triangles with corners of shape (m, 3, k), each of shape (m, k)."""
    return corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]


def _summed(mesh: Mesh, values: Array) -> Array:
    """Return for each vertex the sum of the values of its triangles, shape (n, 3)."""
    corners, count = mesh.triangles.ravel(), len(mesh.vertices)
    sums = [np.bincount(corners, np.repeat(column, 3), count) for column in values.T]
    return np.column_stack(sums)


def _perpendicular(normals: Array) -> Array:
    """Return unit vectors perpendicular to given vectors, shape (n, 3)."""
    least = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
    result = np.cross(normals, least)
    return np.asarray(result / np.sqrt((result**2).sum(axis=1, keepdims=True)))
