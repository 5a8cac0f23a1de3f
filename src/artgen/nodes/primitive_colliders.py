"""Convex pieces of solids made by kernels."""

import functools
import math
from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from artgen import _portable, colliders
from artgen._arrays import Array
from artgen.asset.shape import Contour, Outline
from artgen.colliders import Convex, Pieces
from artgen.colliders.polytope import Polytope
from artgen.nodes.surfaces import lathe_steps, mitres

_SOFT_EDGE = 0.012  # larger bevels show in the collider of a box; with smaller bevels it is a plain box [m]
_FAR = 0.001  # largest distance of a collider from a rounded edge, unless it adds little volume [m]
_LITTLE = 0.025  # share of a solid's volume that colliders of rounded edges may add within _FARTHEST
_FARTHEST = 0.0039  # largest distance of a collider from a rounded edge [m]
_SIDES = 24  # sides of the chamfers around the rounded rims of a cylinder
_FACETS = 0.02  # distance between a rounded edge and the facets of the solid, as a share of the bevel

_CHAMFERED = 0.0007
"""Largest distance of a single chamfer from a rounded rim; beyond, there are two chamfers [m]."""


def moved(pieces: Pieces, matrix: Array) -> Pieces:
    """Return pieces moved by an affine matrix, shape (4, 4)."""
    return pieces if np.array_equal(matrix, np.eye(4)) else pieces.transformed(matrix)


def around_rounded_box(
    size: Array, bevel: float, vertices: Callable[[], Array], *, chamfered: bool = False
) -> Pieces:
    """Return the pieces of a box about the origin with edges rounded by `bevel`, and its vertices [m].

    A box with single chamfers, which touch these edges from outside, is a piece itself.
    """
    added = (4.0 - math.pi) * bevel**2 * float(size.sum() / size.prod())
    reach = bevel * (math.sqrt(3.0) - 1.0)

    def outer(tolerance: float) -> tuple[Convex, ...]:
        if bevel <= _SOFT_EDGE and (reach <= _FAR or (added <= _LITTLE and reach <= _FARTHEST)):
            return (Convex.box(size),)
        single = _chamfered(size, bevel * math.tan(math.pi / 8.0), bevel)
        if chamfered or _follows(single.faces, size, bevel):
            return (single,)
        closer = _banded(size, bevel)
        return (Convex.of(closer),) if _follows(closer, size, bevel) else _octants(vertices())

    def inner(tolerance: float) -> tuple[Convex, ...]:
        inset = bevel * (1.0 - 1.0 / math.sqrt(3.0))
        if inset <= tolerance:
            return (Convex.box(size - 2.0 * inset),)
        return (_chamfered(size, 0.0, bevel),)

    return Pieces(outer, inner)


def _follows(cover: Polytope, size: Array, bevel: float) -> bool:
    """Tell whether a polytope follows a rounded box closely: near, and nearer if it adds much volume."""
    core = size / 2.0 - bevel
    beyond = np.linalg.norm(np.maximum(np.abs(cover.points) - core, 0.0), axis=1).max()
    far = float(beyond) - bevel + _FACETS * bevel
    a, b, c = 2.0 * core
    faces, edges = 2.0 * (a * b + b * c + c * a), a + b + c
    volume = a * b * c + faces * bevel + math.pi * edges * bevel**2 + 4.0 / 3.0 * math.pi * bevel**3
    return far <= _FAR or (far <= _FARTHEST and cover.volume <= (1.0 + _LITTLE) * volume)


def _banded(size: Array, bevel: float) -> Polytope:
    """Return the planes around a rounded box that touch its faces, edges and corners in the middle."""
    signs = np.stack(np.meshgrid(*[(-1.0, 0.0, 1.0)] * 3), axis=-1).reshape(-1, 3)
    normals = signs[np.any(signs != 0.0, axis=1)]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    supports = _portable.product(np.abs(normals), size / 2.0 - bevel) + bevel
    cover = Polytope.box(-size / 2.0, size / 2.0).clipped(np.column_stack((normals, supports)))
    assert cover is not None, "the planes touch the box from outside"
    return cover


def _octants(vertices: Array) -> tuple[Convex, ...]:
    """Return the eight parts of a convex solid that is symmetric about the origin along each axis."""
    part = vertices[(vertices > 0.0).all(axis=1)]
    shown = np.stack(np.meshgrid(*[(0.0, 1.0)] * 3), axis=-1).reshape(-1, 1, 3)
    corners = Polytope.hull((shown * part).reshape(-1, 3)).points
    signs = np.stack(np.meshgrid(*[(-1.0, 1.0)] * 3), axis=-1).reshape(-1, 3)
    return tuple(Convex.hull(corners * sign) for sign in signs)


def _chamfered(size: Array, reach: float, bevel: float) -> Convex:
    """Return the hull of a box's faces without the `bevel` at their borders, except for `reach` of it [m]."""
    signs = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    half, core = size / 2.0, np.maximum(size / 2.0 - bevel + reach, 1e-6 * size)
    faces = [np.where(np.arange(3) == axis, half, core) for axis in range(3)]
    return Convex.hull(np.concatenate([signs * face for face in faces]))


def around_cylinder(radius: float, length: float, sides: int, matrix: Array, bevel: float = 0.0) -> Pieces:
    """Return the pieces of a cylinder along local z whose mesh has its vertices on the radius."""
    whole = colliders.cylinder_pieces(radius, length, matrix, sides)
    if bevel == 0.0:
        return whole
    shorter = colliders.cylinder_pieces(radius, length - 2.0 * bevel, matrix, sides)
    thinner = colliders.cylinder_pieces(radius - bevel, length, matrix, sides)
    added = (4.0 - math.pi) * bevel**2 / (radius * length)
    reach = bevel * (math.sqrt(2.0) - 1.0)

    def outer(tolerance: float) -> tuple[Convex, ...]:
        if reach <= _FAR or (added <= _LITTLE and reach <= _FARTHEST):
            return whole.outer(tolerance)
        return tuple(_rims(radius, length, matrix, bevel))

    return Pieces(outer, lambda tolerance: shorter.inner(tolerance) + thinner.inner(tolerance))


def _rims(radius: float, length: float, matrix: Array, bevel: float) -> list[Convex]:
    """Return the ends of a chamfered cylinder along local z around rounded ends, and the part between.

    The chamfers touch the quarter of a circle at angles that divide it evenly.
    """
    count = 1 if bevel * (1.0 / math.cos(math.pi / 8.0) - 1.0) <= _CHAMFERED else 2
    half = math.pi / 4.0 / (count + 1)
    corner = half * (2.0 * np.arange(count + 1) + 1.0)
    radii = radius - bevel + bevel * _portable.cos(corner) / math.cos(half)
    heights = length / 2.0 - bevel + bevel * _portable.sin(corner) / math.cos(half)
    angle = np.arange(_SIDES) * (math.tau / _SIDES)
    circle = np.column_stack((_portable.cos(angle), _portable.sin(angle))) / math.cos(math.pi / _SIDES)
    pieces = [Convex.cylinder(radius, 2.0 * float(heights[0]), matrix)]
    for side in (-1.0, 1.0):
        rings = [
            np.column_stack((circle * ring, np.full(_SIDES, side * height)))
            for ring, height in zip(radii, heights, strict=True)
        ]
        placed = [ring @ matrix[:3, :3].T + matrix[:3, 3] for ring in rings]
        pieces += [Convex.hull(np.concatenate(pair)) for pair in pairwise(placed)]
    return pieces


def lazily(make: Callable[[], Pieces]) -> Pieces:
    """Return pieces that are computed on first access: many solids only serve to cut others."""
    made = functools.cache(make)
    return Pieces(lambda tolerance: made().outer(tolerance), lambda tolerance: made().inner(tolerance))


def around_hull(vertices: Callable[[], Array]) -> Pieces:
    """Return the pieces of a convex solid, from a function that returns its corners, shape (n, 3) [m]."""
    return lazily(lambda: colliders.hull_pieces(vertices()))


def around_round(primitive: Convex, vertices: Callable[[], Array]) -> Pieces:
    """Return the pieces of a convex mesh whose vertices, shape (n, 3) [m], lie on a round primitive."""
    return lazily(lambda: colliders.round_pieces(primitive, vertices()))


def around_lathe(contours: Sequence[Contour], angle: float = math.tau, sides: int | None = None) -> Pieces:
    """Return the pieces of a lathe solid about z."""
    borders = [contour.points for contour in contours]
    steps, turn = lathe_steps(contours, angle, sides)
    return lazily(lambda: colliders.revolve_pieces(borders, 0.0, turn, steps))


def around_extrusion(
    profile: Outline, length: float, *, bevel: float, taper: float, twist: float, stations: int
) -> Pieces:
    """Return the pieces of an extrusion along z, centered on z = 0."""
    half = length / 2.0
    borders = [contour.points for contour in profile.contours]
    if taper == 0.0 and twist == 0.0:
        whole = colliders.prism_pieces(borders, -half, half, convex=profile.convex)
        if bevel == 0.0:
            return whole
        inset = [contour.points - bevel * mitres(contour) for contour in profile.contours]
        shorter = colliders.prism_pieces(borders, bevel - half, half - bevel, convex=profile.convex)
        thinner = colliders.prism_pieces(inset, -half, half)
        return Pieces(whole.outer, lambda tolerance: shorter.inner(tolerance) + thinner.inner(tolerance))

    def rings(low: float, high: float) -> Callable[[Array], list[Array]]:
        def place(polygon: Array) -> list[Array]:
            made = []
            for level in np.linspace(low, high, stations + 1):
                along = level / length + 0.5
                scale, angle = 1.0 - taper * along, twist * along
                cosine, sine = scale * math.cos(angle), scale * math.sin(angle)
                flat = polygon @ np.array([[cosine, sine], [-sine, cosine]])
                made.append(np.column_stack([flat, np.full(len(flat), level)]))
            return made

        return place

    whole = around_sweep(profile, rings(-half, half), closed=False)
    if bevel == 0.0:
        return whole
    shorter = around_sweep(profile, rings(bevel - half, half - bevel), closed=False)
    return Pieces(whole.outer, shorter.inner)


def around_sweep(profile: Outline, place: Callable[[Array], list[Array]], closed: bool) -> Pieces:
    """Return the pieces of a profile drawn through stations."""
    borders = [contour.points for contour in profile.contours]
    simple = len(borders) == 1 and profile.convex is not None and len(profile.convex) == 1

    def chains(parts: Sequence[Array]) -> list[Pieces]:
        return [around_chain(place(part), closed) for part in parts]

    def outer(tolerance: float) -> tuple[Convex, ...]:
        parts = [borders[0]] if simple else colliders.decompose_polygon(borders, tolerance)
        return tuple(piece for chain in chains(parts) for piece in chain.outer(tolerance))

    def inner(tolerance: float) -> tuple[Convex, ...]:
        parts = [borders[0]] if simple else colliders.decompose_polygon(borders, tolerance, inner=True)
        return tuple(piece for chain in chains(parts) for piece in chain.inner(tolerance))

    return Pieces(outer, inner)


def around_chain(rings: Sequence[Array], closed: bool = False) -> Pieces:
    """Return the pieces of convex rings joined one to the next, each shape (k, 3) [m]."""
    table = list(rings[:-1] if closed else rings)
    return lazily(lambda: colliders.chain_pieces(table, closed=closed))
