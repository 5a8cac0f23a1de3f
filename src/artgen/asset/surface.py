"""Meshes of visible surfaces: split by paint, joined, moved, and laid on the maps of their materials."""

import zlib
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from artgen.asset.shape import Mesh
from artgen.materials import Material
from artgen.materials.textures import shifts_of, tile_of

Array = NDArray[np.float64]

_SHIFTS = 64  # places in a tile, in each direction, at which the pattern of a part may begin
_APART = 1e-5  # by how much texture coordinates of vertices differ that have to stay two [m]


def shifted(mesh: Mesh, material: Material, key: str) -> Mesh:
    """Return a mesh whose texture begins at a place that a key decides, so that no two boards match."""
    if not material.texture:
        return mesh
    number = zlib.crc32(key.encode())
    steps = np.array([number % _SHIFTS, number // _SHIFTS % _SHIFTS]) / _SHIFTS
    free = np.array(tile_of(material)) * shifts_of(material)
    return replace(mesh, uvs=mesh.uvs + steps * (free[::-1] if material.turned else free))


def texture_coordinates(mesh: Mesh, material: Material) -> Array:
    """Return the texture coordinates of a mesh in repeats of its material's maps, shape (n, 2).

    u grows to the right of the map and v upwards; both are in metres where there are no maps.
    """
    if not material.texture:
        return mesh.uvs
    uvs = np.column_stack([mesh.uvs[:, 1], -mesh.uvs[:, 0]]) if material.turned else mesh.uvs
    return np.asarray(uvs / np.array(tile_of(material)))


def metric_coordinates(coordinates: Array, material: Material) -> Array:
    """Return in metres, shape (n, 2), what `texture_coordinates` gave in repeats of a material's maps."""
    if not material.texture:
        return coordinates
    uvs = coordinates * np.array(tile_of(material))
    return np.column_stack([-uvs[:, 1], uvs[:, 0]]) if material.turned else uvs


def by_paint(mesh: Mesh) -> list[tuple[int, Mesh]]:
    """Split a mesh by the paint of its faces; return each paint's number with its faces."""
    paint = mesh.paints[mesh.triangles[:, 0]]
    numbers = [int(number) for number in np.unique(paint)]
    if len(numbers) == 1:
        return [(numbers[0], mesh)]
    return [(number, _compacted(mesh, mesh.triangles[paint == number])) for number in numbers]


def _compacted(mesh: Mesh, triangles: NDArray[np.int64]) -> Mesh:
    used, renumbered = np.unique(triangles, return_inverse=True)
    return Mesh(
        mesh.vertices[used],
        mesh.normals[used],
        mesh.uvs[used],
        mesh.paints[used],
        renumbered.reshape(-1, 3),
    )


def joined(meshes: list[Mesh]) -> Mesh:
    """Concatenate meshes, and put vertices and triangles in an order that only their values decide.

    Corners of equal values are one vertex, unless faces touch there in that point alone: such a vertex is no
    manifold. Checkers would merge vertices of equal values again, so that these differ a little.
    """
    offsets = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
    rows = np.concatenate(
        [np.concatenate([mesh.vertices, mesh.normals, mesh.uvs], axis=1) for mesh in meshes]
    )
    triangles = np.concatenate(
        [mesh.triangles + offset for mesh, offset in zip(meshes, offsets, strict=True)]
    )
    quantised = np.rint(rows * 1e7).astype(np.int64)
    order = np.lexsort(quantised.T[::-1])
    ordered = quantised[order]
    new = np.ones(len(order), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    number = np.empty(len(order), np.int64)
    number[order] = np.cumsum(new) - 1
    rows = rows[order[new]]
    corners = number[triangles]
    # a triangle between corners at one place has no area, though their normals or textures may differ
    places = ordered[new][:, :3][corners]
    corners = corners[(places != np.roll(places, 1, axis=1)).any(axis=2).all(axis=1)]
    used = np.zeros(len(rows), bool)
    used[corners] = True
    rows, corners = rows[used], (np.cumsum(used) - 1)[corners]
    corners, copied = _fanned(_ordered(corners), len(rows))
    if copied:
        copies = rows[copied]
        copies[:, 6] += _APART * (1 + np.arange(len(copied)) - np.searchsorted(copied, copied))
        rows = np.concatenate([rows, copies])
        order = np.lexsort(np.rint(rows * 1e7).astype(np.int64).T[::-1])
        rows, corners = rows[order], _ordered(np.argsort(order)[corners])
    return Mesh(rows[:, :3], rows[:, 3:6], rows[:, 6:8], np.zeros(len(rows), np.int64), corners)


def _ordered(corners: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return triangles in order, each with its least corner first."""
    turned = np.argmin(corners, axis=1)[:, None] + np.arange(3)
    corners = np.take_along_axis(corners, turned % 3, axis=1)
    return corners[np.lexsort(corners.T[::-1])]


def _fanned(corners: NDArray[np.int64], count: int) -> tuple[NDArray[np.int64], list[int]]:
    """Give open fans of triangles vertices of their own where they touch in one point.

    Args:
        corners: Triangles among `count` vertices, shape (m, 3).
        count: How many vertices there are.

    Returns:
        The triangles, and of which vertices those from `count` on are copies.
    """
    following = np.roll(corners, -1, axis=1)
    keys = np.sort((np.minimum(corners, following) * count + np.maximum(corners, following)).ravel())
    sides = keys[np.append(True, keys[1:] != keys[:-1])]
    neighbours = np.bincount(sides // count, minlength=count) + np.bincount(sides % count, minlength=count)
    # an open fan has one neighbour more than triangles, a closed one as many
    fans = neighbours - np.bincount(corners.ravel(), minlength=count)
    copied: list[int] = []
    for vertex in np.flatnonzero(fans > 1).tolist():
        rows, places = np.nonzero(corners == vertex)
        ahead, behind = corners[rows, (places + 1) % 3].tolist(), corners[rows, places - 1].tolist()
        after = {corner: number for number, corner in enumerate(ahead)}
        starts = [number for number, corner in enumerate(ahead) if corner not in behind]
        for start in starts[1:]:
            number: int | None = start
            while number is not None:
                corners[rows[number], places[number]] = count + len(copied)
                number = after.pop(behind[number], None)
            copied.append(vertex)
    return corners, copied
