"""Watertight surfaces in manifold3d: construction from triangles, repair and motion."""

from collections.abc import Sequence

import numpy as np
from manifold3d import Manifold, Mesh64
from numpy.typing import ArrayLike

from artgen import _portable
from artgen._arrays import Array, Indices, cached, distinct_rows
from artgen.colliders.triangles import cross

PROPERTIES = 6  # vertex property channels of every manifold: nx ny nz u v paint
TURNED_OVER = np.array([-1.0, 1.0])  # factors of texture coordinates in a reflection: maps stay unmirrored
_COINCIDENT = 1e-9  # vertices closer than this are one point of the surface [m]
_SMALL = 600  # most triangles of a surface whose connectivity is cached
_HAS_NORMALS = 2  # bit of a mesh run: the first three channels are normals, which turn with the solid


def box_of(solid: Manifold) -> Array:
    """Return the corners of the bounding box of a solid, shape (2, 3) [m]."""
    return np.array(solid.bounding_box()).reshape(2, 3)


def mesh_of(solid: Manifold) -> tuple[Array, Indices]:
    """Return the vertices of a solid, shape (n, 3) [m], and its triangles, shape (m, 3)."""
    mesh = solid.to_mesh64()
    return np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts).astype(np.int64)


def moved_manifold(manifold: Manifold, matrix: Array) -> Manifold:
    """Return a manifold moved by an affine matrix, shape (4, 4)."""
    if np.linalg.det(matrix[:3, :3]) >= 0.0:
        return manifold.transform(np.ascontiguousarray(matrix[:3]))
    # for a reflection, manifold3d flips the triangles but not the order of the normals at their corners
    raw = manifold.to_mesh64()
    properties = mended(np.array(raw.vert_properties), np.asarray(raw.tri_verts).astype(np.int64))
    properties[:, :3] = properties[:, :3] @ matrix[:3, :3].T + matrix[:3, 3]
    normals = properties[:, 3:6] @ _portable.inverse(matrix[:3, :3])
    properties[:, 3:6] = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    properties[:, 6:8] *= TURNED_OVER
    return manifold_of(properties, raw.tri_verts[:, ::-1], raw.merge_from_vert, raw.merge_to_vert)


def manifold_of(table: Array, triangles: ArrayLike, merged: ArrayLike, target: ArrayLike) -> Manifold:
    """Return a manifold with unchecked status from vertices with the channels of `PROPERTIES`."""
    corners = np.array(triangles, np.uint64, order="C").reshape(-1, 3)
    mesh = Mesh64(
        np.array(table),  # manifold3d takes no read-only arrays
        corners,
        *(np.array(numbers, np.uint64) for numbers in (merged, target)),
        run_index=np.array([0, corners.size], np.uint64),
        run_original_id=np.array([Manifold.reserve_ids(1)], np.uint32),
        run_flags=np.array([_HAS_NORMALS], np.uint8),
    )
    return Manifold(mesh)


def mended(table: Array, triangles: Indices) -> Array:
    """Return the vertices of a manifold with the missing properties filled in.

    Where many solids meet in a point, booleans of manifold3d create corners without normal, texture
    coordinates or paint. They get the values of their largest face.
    """
    whole = np.logical_and(np.isfinite(table).all(axis=1), table[:, 3:6].any(axis=1))
    if whole.all():
        return table
    table = table.copy()
    a, b, c = table[:, :3][triangles.T]
    across = cross(b - a, c - a)
    area = np.linalg.norm(across, axis=1)
    for vertex in np.flatnonzero(~whole):
        faces = np.flatnonzero((triangles == vertex).any(axis=1))
        face = faces[np.argmax(area[faces])]
        others = [corner for corner in triangles[face] if whole[corner]]
        table[vertex, 6:] = table[others[0], 6:] if others else 0.0
        table[vertex, 3:6] = across[face] / area[face] if area[face] > 0.0 else (0.0, 0.0, 1.0)
    return table


def coincident(vertices: Array) -> Indices:
    """Return for each vertex the first vertex at the same position."""
    quantised = np.rint(vertices / _COINCIDENT).astype(np.int64)
    _, first, group = distinct_rows(quantised)
    return first[group]


def is_closed(faces: Indices) -> bool:
    """Tell whether each edge of triangles, shape (m, 3), is a reversed edge of another triangle."""
    start, end = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    count = int(faces.max()) + 1
    return np.array_equal(np.sort(start * count + end), np.sort(end * count + start))


def part_boxes(points: Array, faces: Indices) -> tuple[Array, Indices]:
    """Return the bounding box of each connected part of triangles, and its first point.

    Args:
        points: Positions, shape (n, 3) [m].
        faces: Triangles of closed surfaces, which number the points, shape (m, 3).

    Returns:
        Boxes, shape (k, 2, 3) [m], and numbers of points, shape (k,).
    """
    part = np.arange(len(points))  # the lowest known point that each one is connected to
    while True:
        of = part[faces]
        least = of.min(axis=1)
        if (of == least[:, None]).all():
            break
        np.minimum.at(part, of.ravel(), np.repeat(least, 3))
        while (part != part[part]).any():
            part = part[part]
    used = np.unique(faces)
    ordered = used[np.argsort(part[used], kind="stable")]
    starts = np.flatnonzero(np.diff(part[ordered], prepend=-1))
    corners = [each.reduceat(points[ordered], starts) for each in (np.minimum, np.maximum)]
    return np.stack(corners, axis=1), ordered[starts]


JOINED = 0.5e-3
"""Largest gap between connected solids of a link [m]."""


def box_gaps(first: Array, second: Array) -> Array:
    """Return the distances between boxes, shapes (n, 2, 3) and (m, 2, 3), as an array of shape (n, m) [m]."""
    apart = np.maximum(first[:, None, 0] - second[None, :, 1], second[None, :, 0] - first[:, None, 1])
    return np.asarray(np.linalg.norm(np.maximum(apart, 0.0), axis=2))


def touching(solids: Sequence[Manifold], boxes: Array, ranks: Array | None = None) -> list[tuple[int, int]]:
    """Return pairs of solids at most `JOINED` apart that connect all solids that hang together.

    They form a forest: without a pair, its solids do not hang together any more.

    Args:
        solids: The solids.
        boxes: Their bounding boxes, shape (n, 2, 3) [m].
        ranks: Rank of each solid, shape (n,): pairs of low ranks come first, by default those of near boxes.
    """
    apart = box_gaps(boxes, boxes)
    first, second = np.nonzero(np.triu(apart <= JOINED, 1))
    # most boxes that overlap belong to solids that do, and pairs that are already connected cost nothing
    keys = [apart[first, second]]
    if ranks is not None:
        pair = np.sort(np.column_stack([ranks[first], ranks[second]]), axis=1)
        keys += [pair[:, 0], pair[:, 1]]
    group = np.arange(len(solids))  # number of the group of each solid
    found = []
    for a, b in np.column_stack([first, second])[np.lexsort(keys)].tolist():
        if group[a] != group[b] and solids[a].min_gap(solids[b], 2.0 * JOINED) <= JOINED:
            group[group == group[b]] = group[a]
            found.append((a, b))
    return found


def connected(triangles: Indices, targets: Indices) -> tuple[Indices, Indices, Indices]:
    """Return the connectivity of a surface; small surfaces, which often repeat, are cached."""
    if len(triangles) > _SMALL:
        return _connect(triangles, targets)
    return _remembered(*(np.asarray(each, np.int64).tobytes() for each in (triangles, targets)))


@cached(512)
def _remembered(triangles: bytes, targets: bytes) -> tuple[Indices, Indices, Indices]:
    return _connect(np.frombuffer(triangles, np.int64).reshape(-1, 3), np.frombuffer(targets, np.int64))


def _connect(triangles: Indices, targets: Indices) -> tuple[Indices, Indices, Indices]:
    faces = targets[triangles]
    proper = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    if not proper.any():
        raise ValueError("the result is empty")
    faces, triangles = faces[proper], triangles[proper]
    if not is_closed(faces):
        raise ValueError("the surface is not a closed manifold: an edge belongs to one face only")
    used = np.zeros(len(targets), bool)
    used[triangles] = True
    rows, number = np.flatnonzero(used), np.cumsum(used) - 1
    _, first, group = np.unique(targets[rows], return_index=True, return_inverse=True)
    return rows, number[triangles], first[group.ravel()]
