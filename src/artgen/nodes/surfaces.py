"""Meshes of solids from their curves: numpy arrays with analytic normals and texture coordinates in metres.

A side surface is a grid: columns run along a contour (a `Rail`), rows across it. Vertices are doubled at
discontinuities of normals or texture coordinates; `targets` names the vertices at the same point.
"""

import math
from collections.abc import Callable, Sequence
from contextvars import copy_context
from dataclasses import dataclass
from itertools import product

import numpy as np
from manifold3d import triangulate
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Indices, cached, predecessors, successors
from artgen.asset.shape import GRAIN, Contour, DeferredShape, Shape
from artgen.colliders import Pieces
from artgen.colliders.triangles import cross
from artgen.graph import FULL, Detail, detail_level
from artgen.nodes import validators as check
from artgen.nodes.unwrap import (
    Rail,
    boxed_uvs,
    cap_uvs,
    grain_of,
    lies_flat,
    ring_lengths,
    runs_across,
    tapered_around,
    turned_uvs,
    wall_uvs,
)


def sides_of(radius: float, level: Detail | None = None) -> int:
    """Return the number of facets of a circle with a radius [m]: a multiple of 4, 12 to 64 at full detail."""
    level = level or detail_level()
    if radius <= level.chord:
        return level.sides[0]
    needed = math.pi / math.acos(1.0 - level.chord / radius)
    least = level.sides[radius >= 0.002]
    return min(64, max(least, 4 * math.ceil(needed / 4.0 - 1e-9)))


def hole_radius(inner: float, outer: float, sides: int) -> tuple[float, int]:
    """Return the radius of the corners of a hole in a round wall, and the number of sides of both.

    At lower detail the sides of the hole do not reach into it, as far as half of the wall allows.
    """
    if detail_level() is FULL:
        return inner, sides
    while sides < 64 and inner / math.cos(math.pi / sides) > 0.5 * (inner + outer):
        sides += 4
    return min(inner / math.cos(math.pi / sides), 0.5 * (inner + outer)), sides


def arc_steps(radius: float, sweep: float, level: Detail | None = None) -> int:
    """Return the number of chords of an arc with a radius [m] and a sweep [rad]."""
    return max(1, math.ceil(sides_of(radius, level) * abs(sweep) / math.tau - 1e-9))


def bevel_steps(bevel: float, level: Detail | None = None) -> int:
    """Return the number of chords of the quarter circle of a bevelled edge."""
    level = level or detail_level()
    if bevel <= 0.0:
        return 0
    if level is not FULL:
        return arc_steps(bevel, 0.5 * math.pi, level)
    return 2 if bevel < 0.002 else 4 if bevel <= 0.01 else 6


@dataclass(frozen=True, eq=False)
class Skin(FrozenArrays):
    """The closed surface of a solid."""

    vertices: Array  # positions, shape (n, 3) [m]
    normals: Array  # unit normals, shape (n, 3)
    uvs: Array  # texture coordinates, shape (n, 2) [m]
    triangles: Indices  # vertex indices, counter-clockwise seen from outside, shape (m, 3)
    targets: Indices  # for each vertex, the first vertex at the same point of the surface, shape (n,)

    def turned(self, rotation: Array) -> "Skin":
        """Return the surface rotated by a rotation of `validators.frame`, shape (3, 3).

        If that turns the profile's y downward, the texture is rotated to stay upright.
        """
        if np.array_equal(rotation, np.eye(3)):
            return self
        uvs = 0.0 - self.uvs if check.frame_is_mirrored(rotation) else self.uvs
        return Skin(self.vertices @ rotation.T, self.normals @ rotation.T, uvs, self.triangles, self.targets)

    def shape(self, pieces: Pieces) -> Shape:
        """Return the solid of this surface and of the convex pieces that cover it."""
        return Shape.from_mesh(
            self.vertices, self.normals, self.uvs, self.triangles, pieces, targets=self.targets
        )


class DeferredSkin:
    """The surface of a solid that is closed by construction, made at the level of detail of the kernel.

    Many solids are never looked at: they have colliders, or the asset is not written.
    """

    def __init__(self, make: Callable[[], Skin]) -> None:
        self._make, self._context = make, copy_context()

    def __call__(self) -> Skin:
        """Make the surface."""
        return self._context.copy().run(self._make)

    def shape(self, pieces: Pieces) -> Shape:
        """Return the solid of this surface and of the convex pieces that cover it."""
        return DeferredShape(lambda: self().shape(pieces), pieces)

    def vertices(self) -> Array:
        """Return the vertices, shape (n, 3) [m]."""
        return self().vertices


class Sheets:
    """A surface under construction: grids and caps, joined at equal places."""

    def __init__(self) -> None:
        self._patches: list[tuple[Array, Array, Array, Indices, Indices]] = []
        self._count = 0

    def grid(
        self,
        rail: Rail,
        vertices: Array,
        normals: Array,
        uvs: Array,
        *,
        strips: Indices | None = None,
        places: Indices | None = None,
        poles: NDArray[np.bool_] | None = None,
        flipped: bool = False,
    ) -> Indices:
        """Add the side surface of a contour, between each row in `strips` and the next; by default all."""
        rows, columns = vertices.shape[:2]
        index = np.arange(rows) if places is None else places
        # at the seam and at corners, the leaving column represents both
        place: Indices = index[:, None] * columns + rail.start
        if poles is not None:
            place = np.where(poles, rail.start, place)
        place += self._count
        lower = np.arange(rows - 1) if strips is None else strips
        low, high = (self._count + row[:, None] * columns for row in (lower, lower + 1))
        corner = [low + rail.start, low + rail.end, high + rail.end, high + rail.start]
        if flipped:
            corner = [corner[0], corner[3], corner[2], corner[1]]
        quads = np.stack([corner[at] for at in (0, 1, 2, 0, 2, 3)], axis=-1).reshape(-1, 3)
        self._add(vertices, normals, uvs, quads, place[:, rail.vertex].ravel())
        return place

    def cap(self, places: Indices, vertices: Array, normal: Array, uvs: Array, triangles: Indices) -> None:
        """Add a flat face over contours."""
        normals = np.broadcast_to(normal, (len(vertices), 3))
        self._add(vertices, normals, uvs, triangles + self._count, places)

    def _add(self, vertices: Array, normals: Array, uvs: Array, triangles: Indices, targets: Indices) -> None:
        flat = vertices.reshape(-1, 3)
        self._patches.append((flat, normals.reshape(-1, 3), uvs.reshape(-1, 2), triangles, targets))
        self._count += len(flat)

    def skin(self) -> Skin:
        """Return the added patches as one surface."""
        return Skin(*(np.concatenate(parts) for parts in zip(*self._patches, strict=True)))


def triangulated(rings: Sequence[Array]) -> Indices:
    """Return triangles over plane rings (outer ones counter-clockwise, holes clockwise), shape (m, 3)."""
    even = [np.rint(ring * GRAIN) / GRAIN for ring in rings]  # otherwise the last digits decide ties
    return np.asarray(triangulate(even), np.int64).reshape(-1, 3)


def extrusion(
    contours: Sequence[Contour],
    length: float,
    *,
    bevel: float = 0.0,
    stations: int = 1,
    warp: Callable[[Array, Array], tuple[Array, Array]] | None = None,
    scales: tuple[float, float] = (1.0, 1.0),
) -> Skin:
    """Extrude contours along z, centered on z = 0, with rounded edges at both ends."""
    inset, level, lean, rise = _end_rows(length, bevel, stations)
    rows = len(level)
    sheets = Sheets()
    places: list[Indices] = []
    rings: list[Array] = []
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(inset), np.diff(level)))]) - length / 2.0
    size = np.ptp(np.concatenate([contour.points for contour in contours]), axis=0)
    lying, across = lies_flat(size, length), runs_across(size)
    share = np.interp(level, (-length / 2.0, length / 2.0), scales)
    uneven = bevel > 0.0 or scales[0] != scales[1]
    for contour in contours:
        rail = Rail.along(contour)
        tight = mitres(contour)
        columns = len(rail.vertex)
        vertices = np.empty((rows, columns, 3))
        plan = contour.points - inset[:, None, None] * tight
        vertices[..., :2] = plan[:, rail.vertex]
        vertices[..., 2] = level[:, None]
        normals = np.empty((rows, columns, 3))
        normals[..., :2] = lean[:, None, None] * rail.normals
        normals[..., 2] = rise[:, None]
        around = rail.distance * (0.5 * sum(scales))
        if uneven and columns > len(contour.points) + 1:  # sides between corners may be flat
            around = tapered_around(rail, ring_lengths(rail, plan) * share[:, None], around)
        uvs = wall_uvs(around, along[:, None], lying=lying)
        places.append(sheets.grid(rail, vertices, normals, uvs))
        rings.append(plan[0])
    flat = np.concatenate(rings)
    triangles = triangulated(rings)
    ends = np.concatenate([place[[0, -1]] for place in places], axis=1)
    for row, side, faces in ((0, -1.0, triangles[:, ::-1]), (1, 1.0, triangles)):
        lid = np.column_stack([flat, np.full(len(flat), side * length / 2.0)])
        uvs = cap_uvs(flat * scales[row], side, across=across)
        sheets.cap(ends[row], lid, np.array([0.0, 0.0, side]), uvs, faces)
    skin = sheets.skin()
    if warp is None:
        return skin
    vertices, normals = warp(skin.vertices, skin.normals)
    return Skin(vertices, normals, skin.uvs, skin.triangles, skin.targets)


def _end_rows(length: float, bevel: float, stations: int) -> tuple[Array, Array, Array, Array]:
    """Return inset [m], height z [m], and the shares of the side's normal and of z in the normal, per row."""
    half = length / 2.0
    middle = np.linspace(-1.0, 1.0, stations + 1)
    steps = bevel_steps(bevel)
    if steps == 0:
        return np.zeros(stations + 1), middle * half, np.ones(stations + 1), np.zeros(stations + 1)
    turn = np.linspace(0.5 * np.pi, 0.0, steps + 1)
    inset = bevel * (1.0 - _portable.cos(turn))
    level = -half + bevel * (1.0 - _portable.sin(turn))
    lean, rise = _portable.cos(turn), -_portable.sin(turn)
    lean[0], inset[-1], rise[-1], lean[-1] = 0.0, 0.0, 0.0, 1.0
    inner = middle[1:-1] * (half - bevel)
    zeros = np.zeros(len(inner))
    return (
        np.concatenate([inset, zeros, inset[::-1]]),
        np.concatenate([level, inner, -level[::-1]]),
        np.concatenate([lean, zeros + 1.0, lean[::-1]]),
        np.concatenate([rise, zeros, -rise[::-1]]),
    )


def mitres(contour: Contour) -> Array:
    """Return the outward motion of each vertex if all sides move outward by one metre, shape (n, 2)."""
    both = contour.normals_in + contour.normals_out
    scale = 1.0 + np.einsum("ij,ij->i", contour.normals_in, contour.normals_out)
    return np.asarray(both / np.maximum(scale, 1e-6)[:, None])


def lathe(contours: Sequence[Contour], *, angle: float = math.tau, sides: int | None = None) -> Skin:
    """Revolve contours in the (r, z) plane about z, starting at the x axis."""
    steps, span = lathe_steps(contours, angle, sides)
    full = span == math.tau
    cosine, sine = _turns(steps, span)
    rows = np.arange(steps + 1)
    turn = rows * (span / steps)
    seam = np.where(rows == steps, 0, rows) if full else None
    sheets = Sheets()
    places: list[Indices] = []
    for contour in contours:
        level = _level_sides(contour)
        rail = Rail.along(contour, level != predecessors(level))
        vertices = _turned(contour.points[rail.vertex], cosine, sine)
        normals = _turned(rail.normals, cosine, sine)
        uvs = turned_uvs(contour, rail, vertices, turn, level)
        poles = contour.points[:, 0] == 0.0
        places.append(sheets.grid(rail, vertices, normals, uvs, places=seam, poles=poles, flipped=True))
    if not full:
        rings = [contour.points for contour in contours]
        flat_points = np.concatenate(rings)
        triangles = triangulated(rings)
        ends = np.concatenate([place[[0, -1]] for place in places], axis=1)
        section = _turned(flat_points, cosine[[0, -1]], sine[[0, -1]])
        for row, faces in ((0, triangles), (1, triangles[:, ::-1])):
            sign, at = (-1.0, 0) if row == 0 else (1.0, -1)
            normal = np.array([-sine[at] * sign, cosine[at] * sign, 0.0])
            sheets.cap(ends[row], section[row], normal, cap_uvs(flat_points, -sign, across=False), faces)
    return sheets.skin()


def lathe_steps(contours: Sequence[Contour], angle: float, sides: int | None = None) -> tuple[int, float]:
    """Return the steps and the angle of a lathe; exactly 2 pi if it closes."""
    facets = sides or sides_of(max(float(contour.points[:, 0].max()) for contour in contours))
    if angle >= math.tau - 1e-9:
        return facets, math.tau
    return max(3, math.ceil(facets * angle / math.tau - 1e-9)), angle


def _level_sides(contour: Contour) -> NDArray[np.bool_]:
    """Return whether each side of a contour in (r, z) is a flat disc or ring, shape (n,)."""
    following = successors(contour.normals_in)
    return (np.abs(contour.normals_out[:, 1]) > 1.0 - 1e-12) & (np.abs(following[:, 1]) > 1.0 - 1e-12)


def _turned(plane: Array, cosine: Array, sine: Array) -> Array:
    """Return (r, z) points turned about z, shape (rows, points, 3)."""
    out = np.empty((len(cosine), len(plane), 3))
    out[..., 0] = cosine[:, None] * plane[:, 0]
    out[..., 1] = sine[:, None] * plane[:, 0]
    out[..., 2] = plane[:, 1]
    return out


@cached(64)
def _turns(steps: int, angle: float) -> tuple[Array, Array]:
    """Return cosines and sines of the rows of a lathe, exact in the quarters of a full turn."""
    turn = np.arange(steps + 1) * (angle / steps)
    cosine, sine = _portable.cos(turn), _portable.sin(turn)
    for values in (cosine, sine):
        values[np.abs(values) < 1e-15] = 0.0
    return cosine, sine


@cached(16)
def _unit_box(steps: int) -> tuple[Array, Array, Array, Indices, Indices]:
    """Return directions, signs and arcs (n, 3) of a box with rounded edges, its triangles and its targets."""
    # an arc is the distance from the flat part of a face along the rounded edge, in radii of the edge
    quarter = _portable.tan(np.linspace(0.0, np.pi / 4.0, steps + 1)) if steps else np.zeros(1)
    across = np.concatenate([-quarter[::-1], quarter])
    side = np.concatenate([-np.ones(steps + 1), np.ones(steps + 1)])
    count = len(across)
    directions = np.zeros((6, count, count, 3))
    signs = np.zeros((6, count, count, 3))
    arcs = np.zeros((6, count, count, 3))
    for face in range(6):
        axis, sign = face // 2, 1.0 - 2.0 * (face % 2)
        u, v = (axis + 1) % 3, (axis + 2) % 3
        directions[face, ..., axis] = signs[face, ..., axis] = sign
        directions[face, ..., u] = across[:, None] * sign
        directions[face, ..., v] = across[None, :]
        signs[face, ..., u] = side[:, None] * sign
        signs[face, ..., v] = side[None, :]
        arcs[face, ..., u] = _portable.arctan(across)[:, None] * sign
        arcs[face, ..., v] = _portable.arctan(across)[None, :]
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    cell = np.arange(count - 1)
    corner = cell[:, None] * count + cell[None, :]
    quads = np.stack(
        [corner, corner + count, corner + count + 1, corner, corner + count + 1, corner + 1], axis=-1
    ).reshape(-1, 3)
    triangles = np.concatenate([quads + face * count * count for face in range(6)])
    flat_directions, flat_signs, flat_arcs = (each.reshape(-1, 3) for each in (directions, signs, arcs))
    # a vertex on the border of a face is also on its neighbor: same direction and, unless the box is sharp
    # (then the direction is the face's), same corner
    where = flat_signs if steps == 0 else np.concatenate([flat_directions, flat_signs], axis=1)
    _, first, group = np.unique(np.rint(where * 1e6), axis=0, return_index=True, return_inverse=True)
    targets = first[group.ravel()]
    return flat_directions, flat_signs, flat_arcs, triangles, targets


def rounded_box(size: Array, bevel: float, steps: int) -> Skin:
    """Make a box about the origin with rounded edges and corners."""
    directions, signs, arcs, triangles, targets = _unit_box(steps)
    half = size / 2.0
    radius = min(bevel, 0.999 * float(half.min())) if steps else 0.0
    inner = signs * (half - radius)
    vertices = inner + directions * radius
    u, v, sense = _layout(len(vertices), tuple(grain_of(size, but=axis) for axis in range(3)))
    laid = inner + arcs * radius
    row = np.arange(len(vertices))
    uvs = np.stack([laid[row, u] * sense, laid[row, v]], axis=-1)
    return Skin(vertices, directions, uvs, triangles, targets)


@cached(1)
def _unit_chamfers() -> tuple[Array, Indices, Array, Indices, Indices]:
    """Return signs (n, 3), face axes (n,), normals (n, 3), triangles and targets of a box with chamfers."""
    signs: list[Array] = []
    axes: list[Indices] = []
    normals: list[Array] = []
    triangles: list[Indices] = []
    for normal in product((-1, 0, 1), repeat=3):
        across = [axis for axis in range(3) if normal[axis]]
        free = [axis for axis in range(3) if not normal[axis]]
        if not across:
            continue
        corners = [(axis, ends) for axis in across for ends in product((-1, 1), repeat=len(free))]
        sign = np.array([normal] * len(corners), float)
        sign[:, free] = np.array([ends for _, ends in corners]).reshape(len(corners), len(free))
        axis = np.array([axis for axis, _ in corners])
        places = np.where(np.arange(3) == axis[:, None], 1.0, 0.5) * sign  # as in a unit box
        out = np.array(normal) / math.sqrt(len(across))
        right = cross(places[1] - places[0], out)
        around = places - places.mean(axis=0)
        order = np.argsort(
            _portable.arctan2(_portable.product(around, cross(out, right)), _portable.product(around, right))
        )
        start = sum(len(each) for each in axes)
        triangles += [start + order[[0, each, each + 1]] for each in range(1, len(order) - 1)]
        signs.append(sign)
        axes.append(axis)
        normals.append(np.broadcast_to(out, sign.shape))
    table = np.column_stack([np.concatenate(signs), np.concatenate(axes)])
    _, first, group = np.unique(table, axis=0, return_index=True, return_inverse=True)
    made = (table[:, :3], table[:, 3].astype(np.int64), np.concatenate(normals), np.array(triangles))
    return *made, first[group.ravel()]


def chamfered_box(size: Array, bevel: float) -> Skin:
    """Make a box about the origin with single chamfers around edges rounded by a bevel."""
    signs, axes, normals, triangles, targets = _unit_chamfers()
    inset = bevel * (1.0 - math.tan(math.pi / 8.0))
    vertices = signs * np.where(np.arange(3) == axes[:, None], size / 2.0, size / 2.0 - inset)
    return Skin(vertices, normals, boxed_uvs(vertices, normals, size)[0], triangles, targets)


@cached(128)
def _layout(count: int, grains: tuple[int, ...]) -> tuple[Indices, Indices, Array]:
    """Return the coordinates that are u and v of each vertex, and the sign of u, each shape (count,)."""
    sides = [
        (3 - axis - grain, grain, side if (axis - grain) % 3 == 1 else -side)  # u is v x normal
        for axis, grain in enumerate(grains)
        for side in (1, -1)
    ]
    u, v, sense = np.repeat(np.array(sides), count // 6, axis=0).T
    return u, v, sense.astype(float)
