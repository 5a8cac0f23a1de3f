"""Texture coordinates in metres: seen from outside, u points right and v up, along the grain.

The grain runs along the long side of a part. No face is mirrored, so that print stays readable.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Indices, successors
from artgen.asset.shape import Contour


@dataclass(frozen=True, eq=False)
class Rail(FrozenArrays):
    """Columns of a grid along a contour: two at each corner and at the seam (its first vertex)."""

    vertex: Indices  # contour vertex of each column, shape (c,)
    normals: Array  # outward unit normal in the plane of the contour, shape (c, 2)
    distance: Array  # length along the contour, shape (c,) [m]
    start: Indices  # column in which each side of the contour starts, shape (n,)
    end: Indices  # column in which it ends, shape (n,)

    @staticmethod
    def along(contour: Contour, breaks: NDArray[np.bool_] | None = None) -> "Rail":
        """Return the columns of a contour; `breaks` requests two columns at further vertices, shape (n,)."""
        count = len(contour.points)
        corner = np.einsum("ij,ij->i", contour.normals_in, contour.normals_out) < 1.0 - 1e-9
        if breaks is not None:
            corner |= breaks
        arrive = np.empty(count, np.int64)
        leave = np.empty(count, np.int64)
        width = 1 + corner[1:]
        arrive[1:] = np.cumsum(width) - width + 1
        leave[1:] = arrive[1:] + corner[1:]
        leave[0], arrive[0] = 0, 1 + width.sum()
        columns = int(arrive[0]) + 1
        vertex = np.empty(columns, np.int64)
        normals = np.empty((columns, 2))
        distance = np.empty(columns)
        sides = successors(contour.points) - contour.points
        total = np.cumsum(np.hypot(sides[:, 0], sides[:, 1]))
        travelled = np.concatenate([[0.0], total[:-1]])
        for column, normal in ((arrive, contour.normals_in), (leave, contour.normals_out)):
            vertex[column] = np.arange(count)
            normals[column] = normal
            distance[column] = travelled
        distance[arrive[0]] = total[-1]
        return Rail(vertex, normals, distance, leave, successors(arrive))


_LONGER = 1.0 + 1e-6  # lengths closer than this are equal: rounding must not rotate the grain


def runs_across(size: Array) -> bool:
    """Tell whether the grain of a flat face of a size, shape (2,) [m], runs along x instead of y."""
    return bool(size[0] > size[1] * _LONGER)


def lies_flat(size: Array, length: float) -> bool:
    """Tell whether a profile of a size, shape (2,) [m], is longer than its extrusion [m]."""
    return bool(size.max() > length * _LONGER)


def cap_uvs(flat: Array, side: float, *, across: bool) -> Array:
    """Return texture coordinates of a flat face perpendicular to z."""
    x, y = flat[..., 0], flat[..., 1]
    return np.stack([-side * y, x] if across else [side * x, y], axis=-1)


def wall_uvs(around: Array, along: Array, *, lying: bool) -> Array:
    """Return texture coordinates of the side walls of an extruded contour."""
    around, along = np.broadcast_arrays(around, along)
    return np.stack([0.0 - along, around] if lying else [around, along], axis=-1)


def tapered_around(rail: Rail, around: Array, even: Array) -> Array:
    """Return lengths around a contour that grows or shrinks from row to row, shape (r, c) [m].

    Flat sides keep their lengths, so that the grain of a tapered leg stays straight; curved sides get mean
    lengths.
    """
    breaks = np.flatnonzero(rail.vertex[1:] == rail.vertex[:-1]) + 1
    first, last = np.append(0, breaks), np.append(breaks - 1, len(rail.vertex) - 1)
    run = np.repeat(np.arange(len(first)), last - first + 1)
    bend = np.abs(rail.normals - rail.normals[first][run]).max(axis=1)
    flat = np.maximum.reduceat(bend, first) < 1e-9
    begin, end = first.copy(), last.copy()
    # a flat side that the seam cuts counts as one
    if np.abs(rail.normals[0] - rail.normals[-1]).max() < 1e-9:
        end[0], begin[-1] = begin[0], end[-1]
    shift = 0.5 * ((even - around)[:, begin] + (even - around)[:, end])
    return np.where(flat[run], around + shift[:, run], even)


def ring_lengths(rail: Rail, rings: Array) -> Array:
    """Return lengths along closed rings of points, shape (r, n, 2) [m], at a rail's columns, shape (r, c)."""
    sides = np.roll(rings, -1, axis=1) - rings
    lengths = np.cumsum(np.hypot(sides[..., 0], sides[..., 1]), axis=1)
    travelled = np.concatenate([np.zeros((len(rings), 1)), lengths], axis=1)
    return np.asarray(travelled[:, np.append(rail.vertex[:-1], rings.shape[1])])


def turned_uvs(
    contour: Contour, rail: Rail, vertices: Array, turn: NDArray[np.floating[Any]], level: NDArray[np.bool_]
) -> Array:
    """Return texture coordinates of a lathe of a contour in (r, z): around it, or flat on discs."""
    smooth = _portable.dot(contour.normals_in[0], contour.normals_out[0]) > 1.0 - 1e-9
    joined = bool(smooth and not level[0] and not level[-1])
    radius, along = _even_runs(rail, contour.points[:, 0], joined=joined)
    uvs = wall_uvs(turn[:, None] * radius, along, lying=False)
    flat = np.zeros(len(rail.vertex), bool)
    flat[rail.start[level]] = flat[rail.end[level]] = True
    for side in (-1.0, 1.0):
        disc = flat & (rail.normals[:, 1] * side > 0.0)
        uvs[:, disc] = cap_uvs(vertices[:, disc, :2], side, across=False)
    return uvs


def _even_runs(rail: Rail, radius: Array, *, joined: bool) -> tuple[Array, Array]:
    """Return the radius at which columns of a revolved contour measure lengths around the axis."""
    # columns without a break between them share the median over the surface, for the least distortion
    distance = rail.distance
    run = np.concatenate([[0], np.cumsum(rail.vertex[1:] == rail.vertex[:-1])])
    if joined and run[-1] > 0:
        distance = np.where(run == 0, distance + distance[-1], distance)
        run = np.where(run == 0, run[-1], run)
    middle = 0.5 * (radius + successors(radius))
    area = middle * (distance[rail.end] - distance[rail.start])
    of_side = run[rail.start]
    order = np.lexsort((middle, of_side))
    total = np.concatenate([[0.0], np.cumsum(area[order])])
    ends = np.searchsorted(of_side[order], np.arange(run[-1] + 2))
    half = 0.5 * (total[ends[:-1]] + total[ends[1:]])
    found = np.searchsorted(total, half) - 1
    found = np.minimum(np.maximum(found, ends[:-1]), np.maximum(ends[1:], 1) - 1)
    shared = middle[order[found]]
    return shared[run], distance


def boxed_uvs(vertices: Array, normals: Array, size: Array) -> tuple[Array, Indices]:
    """Project faces onto the sides of a box."""
    axis = np.argmax(np.abs(normals), axis=-1)
    side = np.sign(np.take_along_axis(normals, axis[..., None], axis=-1)[..., 0])
    grain = np.array([grain_of(size, but=each) for each in range(3)])[axis]
    # seen from outside, u points right and v up: u = v x n
    third = 3 - axis - grain
    turn = np.where((axis - grain) % 3 == 1, 1.0, -1.0)
    u = np.take_along_axis(vertices, third[..., None], axis=-1)[..., 0] * (side * turn)
    v = np.take_along_axis(vertices, grain[..., None], axis=-1)[..., 0]
    return np.stack([u, v], axis=-1), 2 * axis + (side > 0.0)


def grain_of(size: Array, *, but: int = -1) -> int:
    """Return the axis of the grain of a box: the longest one, of equal ones Z or else X."""
    best = -1
    for axis in (2, 0, 1):
        if axis != but and (best < 0 or size[axis] > size[best] * _LONGER):
            best = axis
    return best
