"""Operations on visible meshes: textures, split by paint, join, needles, rounding, simplification."""

import math
import zlib
from collections import deque
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, Indices
from artgen.asset.manifolds import coincident
from artgen.asset.shape import Mesh, Shape
from artgen.colliders.triangles import across
from artgen.materials import Material
from artgen.materials.textures import shifts_of, tile_of

Corners = NDArray[np.int64]
"""Corner indices of triangles, shape (3, m): NumPy sums and compares rows much faster than columns."""

POSITION_DECIMALS = 7  # decimals of vertices in files, in the frame of their link: 0.1 micrometre
NORMAL_DECIMALS = 5  # decimals of the normals of surfaces in files
UV_DECIMALS = 6  # decimals of the texture coordinates of surfaces in files, in repeats of the maps
_SAME = 1e-6  # tolerance of position [m], normal and texture coordinates [m] of equal vertices
_ROUNDS = 8  # tries for each needle: its neighbors may have to be removed first
_SHIFTS = 64  # possible texture offsets in a tile, in each direction
_APART = 1e-5  # difference of texture coordinates that keeps two vertices separate [m]
_STEPS = 1e7  # rounding steps per metre, and per unit of a normal
_MOST_PACKED = 2**21  # most vertices for which three indices fit into 64 bits
_CREASE = math.radians(62.0)  # smooth below: a round surface with few facets has large angles between them
_SHARES = (1.0, 0.8, 0.6, 0.3, 0.1, 0.03)  # shares of the precision to try
_KEPT = 0.9  # least share of the area; below it, parts have vanished
_POINT = 1e-9  # radius of a ball that represents a point [m]


def needles(positions: Indices, corners: Indices) -> NDArray[np.bool_]:
    """Tell which triangles have a height of less than one rounding step, shape (m,)."""
    a, b, c = np.take(positions.astype(float), corners, axis=1).transpose(1, 0, 2)
    first, second, third = b - a, c - b, a - c
    x, y, z = (first[i] * second[j] - first[j] * second[i] for i, j in ((1, 2), (2, 0), (0, 1)))
    longest = np.maximum.reduce([np.einsum("ij,ij->j", side, side) for side in (first, second, third)])
    return np.asarray(x * x + y * y + z * z < longest)


def without_needles(
    rows: Array, place: Indices, corners: Indices, flat: NDArray[np.bool_]
) -> tuple[Array, Indices]:
    """Remove degenerate triangles (needles) without leaving T-junctions.

    The neighbor across the long side of a needle is divided at the needle's middle corner. A needle at the
    border of a surface has no such neighbor and is dropped.
    """
    vertices, places = list(rows), place.tolist()
    triangles: list[list[int]] = corners.T.tolist()
    sides = {
        (places[one], places[other]): number
        for number, (a, b, c) in enumerate(triangles)
        for one, other in ((a, b), (b, c), (c, a))
    }
    waiting = deque(np.flatnonzero(flat).tolist())
    gone = set(waiting)
    for _ in range(_ROUNDS * len(waiting)):
        if not waiting:
            break
        number = waiting.popleft()
        middle, start, end = _from_middle(triangles[number], vertices)
        beyond = sides.get((places[end], places[start]))
        if beyond is None:
            continue
        if beyond in gone:
            if beyond in waiting:
                waiting.append(number)
                _turn_shared_side(triangles, vertices, places, sides, number, beyond)
            continue
        facing = [places[corner] for corner in triangles[beyond]].index(places[end])
        one, other, apex = _from(triangles[beyond], facing)
        if (one, other) != (end, start):  # another face, with its own vertices
            middle = _vertex_between(vertices, places, middle, one, other)
        triangles[beyond] = [one, middle, apex]
        triangles.append([middle, other, apex])
        sides[places[one], places[middle]] = sides[places[middle], places[apex]] = beyond
        for first, second in ((middle, other), (other, apex), (apex, middle)):
            sides[places[first], places[second]] = len(triangles) - 1
    left = [triangle for number, triangle in enumerate(triangles) if number not in gone]
    return np.array(vertices), np.ascontiguousarray(np.array(left, np.int64).reshape(-1, 3).T)


def _turn_shared_side(
    triangles: list[list[int]], vertices: list[Array], places: list[int], sides: dict[tuple[int, int], int],
    number: int, beyond: int,
) -> None:  # fmt: skip
    """Join the middle corners of two needles that share their long sides, which neither can divide."""
    middle, start, end = _from_middle(triangles[number], vertices)
    other, first, last = _from_middle(triangles[beyond], vertices)
    shared = (places[first], places[last]) == (places[end], places[start])
    if not shared or places[middle] == places[other]:
        return
    triangles[number], triangles[beyond] = [middle, start, other], [middle, other, end]
    del sides[places[start], places[end]], sides[places[end], places[start]]
    for changed in (number, beyond):
        a, b, c = (places[corner] for corner in triangles[changed])
        sides[a, b] = sides[b, c] = sides[c, a] = changed


def _from_middle(triangle: list[int], vertices: list[Array]) -> tuple[int, int, int]:
    """Return the corners of a needle in order, the middle one first."""
    at = np.array([vertices[corner][:3] for corner in triangle])
    opposite = np.square(at[[2, 0, 1]] - at[[1, 2, 0]]).sum(axis=1)
    return _from(triangle, int(opposite.argmax()))


def _from(triangle: list[int], number: int) -> tuple[int, int, int]:
    """Return the corners of a triangle in order, the one with a number first."""
    return triangle[number], triangle[number - 2], triangle[number - 1]


def _vertex_between(vertices: list[Array], places: list[int], at: int, one: int, other: int) -> int:
    """Return the vertex at the place of `at` on the side from `one` to `other`; append a missing one."""
    start, end, position = vertices[one], vertices[other], vertices[at][:3]
    along = end[:3] - start[:3]
    share = _portable.dot(position - start[:3], along) / _portable.dot(along, along)
    row = (1.0 - share) * start + share * end
    row[:3] = position
    row[3:6] /= _portable.norm(row[3:6])
    for number, place in enumerate(places):
        if place == places[at] and np.abs(vertices[number] - row).max() < _SAME:
            return number
    vertices.append(row)
    places.append(places[at])
    return len(vertices) - 1


def corner_normals(
    triangles: NDArray[np.int64], corners: Array, crease: float, *, by: Literal["angle", "area"] = "angle"
) -> Array:
    """Return a normal for each corner of each triangle, shape (3 m, 3), smooth below a crease angle."""
    count = len(triangles)
    products, areas = across(corners)  # twice the areas
    flat = products / np.maximum(areas, 1e-300)[:, None]
    following, before = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    cosine = np.einsum("ijk,ijk->ij", following, before)
    angle = _portable.arctan2(np.broadcast_to(areas[:, None], cosine.shape), cosine).ravel()
    share = angle * np.repeat(areas, 3) if by == "area" else angle
    vertex = triangles.ravel()
    face = np.repeat(np.arange(count), 3)
    order = np.argsort(vertex, kind="stable")
    start = np.searchsorted(vertex[order], np.arange(vertex.max() + 2))
    fans = np.diff(start)
    normals = np.zeros((3 * count, 3))
    for size in np.unique(fans[fans > 0]).tolist():
        heads = start[:-1][fans == size]
        corner = order[heads[:, None] + np.arange(size)]
        turned = flat[face[corner]]
        near = np.einsum("vik,vjk->vij", turned, turned) > math.cos(crease)
        weight = near * share[corner][:, None, :]
        normals[corner.ravel()] = np.einsum("vij,vjk->vik", weight, turned).reshape(-1, 3)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.where(length > 1e-12, normals / np.maximum(length, 1e-300), np.repeat(flat, 3, axis=0))


def shifted(mesh: Mesh, material: Material, key: str) -> Mesh:
    """Return a mesh with a texture offset derived from a key, so that no two boards look alike."""
    if not material.texture:
        return mesh
    number = zlib.crc32(key.encode())
    steps = np.array([number % _SHIFTS, number // _SHIFTS % _SHIFTS]) / _SHIFTS
    free = np.array(tile_of(material)) * shifts_of(material)
    return replace(mesh, uvs=mesh.uvs + steps * (free[::-1] if material.turned else free))


def texture_coordinates(mesh: Mesh, material: Material) -> Array:
    """Return the texture coordinates of a mesh in repeats of its material's maps, shape (n, 2).

    u points right and v up in the map; without maps, both are in metres.
    """
    if not material.texture:
        return mesh.uvs
    uvs = np.column_stack([mesh.uvs[:, 1], -mesh.uvs[:, 0]]) if material.turned else mesh.uvs
    return np.asarray(uvs / np.array(tile_of(material)))


def metric_coordinates(coordinates: Array, material: Material) -> Array:
    """Return texture coordinates in repeats of a material's maps in metres, shape (n, 2)."""
    if not material.texture:
        return coordinates
    uvs = coordinates * np.array(tile_of(material))
    return np.column_stack([-uvs[:, 1], uvs[:, 0]]) if material.turned else uvs


def by_paint(mesh: Mesh) -> list[tuple[int, Mesh]]:
    """Split a mesh by paint; return the number of each paint with its faces."""
    paint = mesh.paints[mesh.triangles[:, 0]]
    numbers = [int(number) for number in np.unique(paint)]
    if len(numbers) == 1:
        return [(numbers[0], mesh)]
    parts = []
    for number in numbers:
        used, triangles = np.unique(mesh.triangles[paint == number], return_inverse=True)
        parts.append((number, mesh.selected(used, triangles.reshape(-1, 3))))
    return parts


def joined(meshes: list[Mesh]) -> Mesh:
    """Concatenate meshes; the order of vertices and triangles depends on their values only.

    Equal corners become one vertex, except where faces touch in a single point: one vertex would not be
    manifold there. Such vertices differ a little, because checkers merge equal vertices again.
    """
    whole = Mesh.concatenated(meshes)
    rows = np.concatenate([whole.vertices, whole.normals, whole.uvs], axis=1)
    corners = np.ascontiguousarray(whole.triangles.T)
    quantised = _quantised(rows)
    order = np.lexsort(quantised[::-1])
    ordered = quantised[:, order]
    steps = ordered[:, 1:] != ordered[:, :-1]
    new, elsewhere = (np.append(True, each.any(axis=0)) for each in (steps, steps[:3]))
    number = np.empty(len(order), np.int64)
    number[order] = np.cumsum(new) - 1
    rows, place = rows[order[new]], np.cumsum(elsewhere)[new]
    corners = number[corners]
    # triangles with two corners at one place have no area, even if normals or textures differ
    a, b, c = place[corners]
    corners = corners[:, (a != b) & (b != c) & (c != a)]
    flat = needles(ordered[:3, new], corners)
    if flat.any():
        rows, corners = _sorted(*without_needles(rows, place, corners, flat))
    used = np.zeros(len(rows), bool)
    used[corners] = True
    rows, corners = rows[used], (np.cumsum(used) - 1)[corners]
    corners, copied = _fanned(_ordered(corners, len(rows)), len(rows))
    if copied:
        copies = rows[copied]
        copies[:, 6] += _APART * (1 + np.arange(len(copied)) - np.searchsorted(copied, copied))
        rows, corners = _sorted(np.concatenate([rows, copies]), corners)
        corners = _ordered(corners, len(rows))
    triangles = np.ascontiguousarray(corners.T)
    return Mesh(rows[:, :3], rows[:, 3:6], rows[:, 6:8], np.zeros(len(rows), np.int64), triangles)


def _sorted(rows: Array, corners: Corners) -> tuple[Array, Corners]:
    """Return vertices sorted by value, and the triangles with the new indices."""
    order = np.lexsort(_quantised(rows)[::-1])
    return rows[order], np.argsort(order)[corners]


def _quantised(rows: Array) -> Corners:
    """Return the columns of rows in whole rounding steps."""
    return np.rint(np.ascontiguousarray(rows.T) * _STEPS).astype(np.int64)


def _ordered(corners: Corners, count: int) -> Corners:
    """Return sorted triangles of `count` vertices, each with its smallest corner first."""
    a, b, c = corners
    if count >= _MOST_PACKED:
        turned = np.where((a < b) & (a < c), (a, b, c), np.where((b < c) & (b < a), (b, c, a), (c, a, b)))
        return turned[:, np.lexsort(turned[::-1])]
    # one number for each rotation of a triangle: the smallest begins with the smallest corner
    turns = ((a, b, c), (b, c, a), (c, a, b))
    least = np.minimum.reduce([(one * count + two) * count + three for one, two, three in turns])
    ahead, last = np.divmod(np.sort(least), count)
    return np.stack([*np.divmod(ahead, count), last])


def _fanned(corners: Corners, count: int) -> tuple[Corners, list[int]]:
    """Give separate vertices to open fans of triangles that touch in one point."""
    following = corners[[1, 2, 0]]
    keys = np.sort((np.minimum(corners, following) * count + np.maximum(corners, following)).ravel())
    sides = keys[np.append(True, keys[1:] != keys[:-1])]
    neighbors = np.bincount(sides // count, minlength=count) + np.bincount(sides % count, minlength=count)
    # an open fan has one more neighbor than triangles, a closed fan has equal numbers
    fans = neighbors - np.bincount(corners.ravel(), minlength=count)
    copied: list[int] = []
    for vertex in np.flatnonzero(fans > 1).tolist():
        numbers, places = np.nonzero(np.equal(corners.T, vertex))
        ahead, behind = corners[(places + 1) % 3, numbers].tolist(), corners[places - 1, numbers].tolist()
        after = {corner: number for number, corner in enumerate(ahead)}
        starts = [number for number, corner in enumerate(ahead) if corner not in behind]
        for start in starts[1:]:
            number: int | None = start
            while number is not None:
                corners[places[number], numbers[number]] = count + len(copied)
                number = after.pop(behind[number], None)
            copied.append(vertex)
    return corners, copied


def as_written(mesh: Mesh, origin: Array, material: Material) -> Mesh:
    """Return a mesh rounded in the frame at `origin` [m], in the order of its file."""
    # also sorted there: from elsewhere, all vertices may lie in the middle of two rounding steps
    mesh = rounded_mesh(replace(mesh, vertices=mesh.vertices - origin), np.zeros(3), material)
    if not _stays_joined(mesh):
        mesh = joined([mesh])  # which may move texture coordinates
        mesh = replace(mesh, uvs=_rounded_uvs(mesh, material))
    mesh = _in_order(mesh, material)
    return replace(mesh, vertices=mesh.vertices + origin)


def _stays_joined(mesh: Mesh) -> bool:
    """Tell whether `joined` would return the same mesh again, if it joined this one before its rounding."""
    quantised = _quantised(np.concatenate([mesh.vertices, mesh.normals, mesh.uvs], axis=1))
    steps = quantised[:, 1:] - quantised[:, :-1]
    ahead = steps[-1] > 0
    for step in steps[-2::-1]:
        ahead = (step > 0) | (step == 0) & ahead
    corners = mesh.triangles.T
    if not ahead.all() or not np.array_equal(_ordered(corners, len(mesh.vertices)), corners):
        return False
    place = np.append(0, np.cumsum(steps[:3].any(axis=0)))
    a, b, c = place[corners]
    return bool(((a != b) & (b != c) & (c != a)).all() and not needles(quantised[:3], corners).any())


def _in_order(mesh: Mesh, material: Material) -> Mesh:
    """Return a mesh with its vertices in the order of a mesh file."""
    # `joined` sorts by metric texture coordinates; on turned maps the written ones have another order
    if not (material.texture and material.turned):
        return mesh
    coordinates = texture_coordinates(mesh, material)
    steps = [each[1:] - each[:-1] for each in (mesh.vertices, mesh.normals)]
    alike = ~np.any([each.any(axis=1) for each in steps], axis=0)
    written = np.rint(coordinates * 10.0**UV_DECIMALS)
    u, v = (written[1:] - written[:-1])[alike].T
    if not ((u < 0.0) | (u == 0.0) & (v < 0.0)).any():
        return mesh
    columns = (
        (coordinates, UV_DECIMALS),
        (mesh.normals, NORMAL_DECIMALS),
        (mesh.vertices, POSITION_DECIMALS),  # lexsort: the last keys decide first
    )
    keys = [np.rint(each[:, ::-1].T * 10.0**decimals) for each, decimals in columns]
    order = np.lexsort(np.concatenate(keys))
    return mesh.selected(order, np.argsort(order)[mesh.triangles])


def rounded_mesh(
    mesh: Mesh,
    origin: Array,
    material: Material,
    *,
    positions: int = POSITION_DECIMALS,
    normals: int = NORMAL_DECIMALS,
    uvs: int = UV_DECIMALS,
) -> Mesh:
    """Return a mesh rounded to numbers of decimals in the frame of a link at `origin`, shape (3,) [m]."""
    return replace(
        mesh,
        vertices=np.round(mesh.vertices - origin, positions) + 0.0 + origin,
        normals=np.round(mesh.normals, normals) + 0.0,
        uvs=_rounded_uvs(mesh, material, uvs),
    )


def _rounded_uvs(mesh: Mesh, material: Material, decimals: int = UV_DECIMALS) -> Array:
    written = np.round(texture_coordinates(mesh, material), decimals) + 0.0
    return metric_coordinates(written, material)


def coarser(shape: Shape, precision: float) -> Mesh:
    """Return a surface with fewer triangles, within a precision of the shape's surface [m].

    Remaining vertices keep their texture coordinates and paint. Normals are computed again: normals of a
    removed round edge would shade the faces next to it. Features thinner than the precision, such as print,
    keep to a share of it.
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
    separate = fewer.selected(corners, np.arange(len(corners)).reshape(-1, 3))
    return replace(separate, normals=normals)


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
    balls = (fcl.CollisionObject(ball, fcl.Transform(point)) for point in far)
    return all(fcl.distance(each, surface) <= distance for each in balls)
