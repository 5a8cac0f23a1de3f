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
from artgen.graph import DETAILS, FULL, Detail
from artgen.nodes.contours import arc_points, signed_area
from artgen.nodes.surfaces import arc_steps, bevel_steps, lathe_steps, mitres, sides_of

_SOFT_EDGE = 0.012  # larger bevels show in the collider of a box; with smaller bevels it is a plain box [m]
_MOST_VERTICES = 64  # of a hull
_SIMPLER = 0.001  # how far a hull reaches beyond one with too many vertices, at most [m]
_ROUND = 5e-5  # what the facets of a round collider add in comparisons [m]

_LIMITS = ((FULL, 0.001, 0.025, 0.0039), (DETAILS["medium"], 0.0029, 0.029, 0.0049))
"""Limits of colliders at two levels of detail; they hold for both at once, so that levels share topologies.

Each has the largest distance from the solid [m], and for colliders that add little volume, the largest share
of the solid's volume that is added and the largest distance [m].
"""

_SHARP = _LIMITS[0][1] / (math.sqrt(3.0) - 1.0)  # bevels up to this are near the corner of a box [m]

_CHAMFERS = ((1, 16), (1, 24), (2, 24), (3, 24), (3, 32), (5, 32))
"""Numbers of chamfers around the rounded rims of a cylinder, and of their sides; the first makes one hull."""

_THIN = 0.03  # radius of cylinders that may be one hull [m]


def near(measured: Callable[[Detail], tuple[float, float]], *, thick: bool = True) -> bool:
    """Tell whether colliders are near, from the largest distance and the share of volume added at a level.

    For a solid that is not `thick`, only the distance counts: most of its volume may be cut away.
    """
    for level, far, little, farthest in _LIMITS:
        distance, added = measured(level)
        if distance > far and (not thick or distance > farthest or added > little):
            return False
    return True


def moved(pieces: Pieces, matrix: Array) -> Pieces:
    """Return pieces moved by an affine matrix, shape (4, 4)."""
    return pieces if np.array_equal(matrix, np.eye(4)) else pieces.transformed(matrix)


def around_rounded_box(
    size: Array, bevel: float, vertices: Callable[[], Array], *, chamfered: bool = False
) -> Pieces:
    """Return the pieces of a box about the origin with edges rounded by `bevel`, and its vertices [m].

    A box with single chamfers, which touch these edges from outside, is a piece itself.
    """

    def outer(tolerance: float) -> tuple[Convex, ...]:
        whole = Convex.box(size)
        if bevel <= _SOFT_EDGE and _follows(whole.faces, size, bevel, whole=True):
            return (whole,)
        single = _chamfered(size, bevel * math.tan(math.pi / 8.0), bevel)
        if chamfered or _follows(single.faces, size, bevel):
            return (single,)
        banded = _banded(size, bevel)
        return (Convex.of(banded),) if _follows(banded, size, bevel) else _octants(vertices())

    def close(tolerance: float) -> tuple[Convex, ...]:
        found = _chamfered(size, bevel * math.tan(math.pi / 8.0), bevel).faces
        for bands in (1, 2):
            if _follows(found, size, bevel, thick=False):
                break
            found = _banded(size, bevel, bands)
        return (Convex.of(found),)

    def inner(tolerance: float) -> tuple[Convex, ...]:
        inset = bevel * (1.0 - 1.0 / math.sqrt(3.0))
        if inset <= tolerance:
            return (Convex.box(size - 2.0 * inset),)
        return (_chamfered(size, 0.0, bevel),)

    closer = Pieces(close, inner) if not chamfered and bevel > _SHARP else None
    return Pieces(outer, inner, closer=closer)


def _follows(cover: Polytope, size: Array, bevel: float, *, whole: bool = False, thick: bool = True) -> bool:
    """Tell whether a polytope, or the whole box, follows a rounded box closely."""
    core = size / 2.0 - bevel
    beyond = float(np.linalg.norm(np.maximum(np.abs(cover.points) - core, 0.0), axis=1).max())
    a, b, c = 2.0 * core
    faces, edges = 2.0 * (a * b + b * c + c * a), a + b + c

    def measured(level: Detail) -> tuple[float, float]:
        steps = max(1, bevel_steps(bevel, level) // 2)  # facets on each eighth of a circle
        flat = 1.0 if whole else math.cos(math.pi / (8.0 * steps))  # vertices are below the corners of a box
        circle = 4.0 * steps * math.sin(math.pi / (4.0 * steps))  # area of the inscribed polygon
        corners = 4.0 / 3.0 * circle**2 / math.pi
        volume = a * b * c + faces * bevel + circle * edges * bevel**2 + corners * bevel**3
        return beyond - bevel * flat**2, cover.volume / volume - 1.0  # corners have chords both ways

    return near(measured, thick=thick)


def _banded(size: Array, bevel: float, bands: int = 1) -> Polytope:
    """Return the planes around a rounded box that touch its faces, and edges and corners in several bands."""
    across = _portable.tan(np.linspace(-math.pi / 4.0, math.pi / 4.0, 2 * bands + 1))
    signs = np.stack(np.meshgrid(across, across, across), axis=-1).reshape(-1, 3)
    normals = signs[np.abs(signs).max(axis=1) > 1.0 - 1e-9]
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
    half = length / 2.0

    def stacked(corners: Array) -> float:
        return _stacked(bevel, half, corners, lambda inset: (radius - inset) ** 2)

    def follows(chamfers: Array, around: int) -> bool:
        circle, insets = math.pi / around, _levels(bevel, half, chamfers)[:, 0]
        across = float(((radius - insets) * chamfers[:, 0]).max()) / math.hypot(*chamfers[0])
        cover = around * math.tan(circle) * stacked(chamfers)

        def measured(level: Detail) -> tuple[float, float]:
            facets, angle = _facets(arc_steps(bevel, 0.5 * math.pi, level)), math.pi / sides_of(radius, level)
            far = _beyond(bevel, chamfers, facets) + across * (1.0 / math.cos(circle) - math.cos(angle))
            solid = math.pi / angle * math.sin(angle) * math.cos(angle) * stacked(facets)
            return far + _ROUND, cover / solid - 1.0

        return near(measured)

    def outer(tolerance: float) -> tuple[Convex, ...]:
        if follows(_chamfers(0), 1_000):  # a cylinder, whose sides do not count
            return whole.outer(tolerance)
        for count, around in _CHAMFERS[radius > _THIN :]:
            if follows(_chamfers(count), around):
                break
        return _rims(radius, _levels(bevel, half, _chamfers(count)), around, matrix)

    inner = colliders.union(shorter, thinner).inner
    closer = Pieces(lambda _: (_cuttable(radius, length, bevel, matrix),), inner) if bevel > _SHARP else None
    return Pieces(outer, inner, closer=closer)


def _cuttable(radius: float, length: float, bevel: float, matrix: Array) -> Convex:
    """Return one hull around a cylinder along local z with rounded ends."""
    levels = _levels(bevel, length / 2.0, _chamfers(1))
    around = len(Convex.cylinder(radius, length).faces.planes) - 2
    return Convex.hull(np.concatenate(_rings(radius, levels, around))).transformed(matrix)


def _chamfers(count: int) -> Array:
    """Return the corners of chamfers that touch a quarter of a circle of radius 1, shape (count + 1, 2)."""
    # they touch it at angles that divide it evenly; without any, the corner is that of a square
    half = math.pi / 4.0 / (count + 1)
    angle = half * (2.0 * np.arange(count + 1) + 1.0)
    return np.column_stack((_portable.cos(angle), _portable.sin(angle))) / math.cos(half)


def _facets(steps: int) -> Array:
    """Return the corners of chords in a quarter of a circle of radius 1, shape (steps + 1, 2)."""
    return arc_points(np.zeros(2), 1.0, 0.0, 0.5 * math.pi, steps)[1]


def _beyond(bevel: float, chamfers: Array, facets: Array, mitre: float = 1.0) -> float:
    """Return how far chamfers are from facets at most, where mitres make the inset longer [m]."""
    share = np.linspace(0.0, len(facets) - 1.0, 8 * len(facets) - 7)
    points = np.column_stack([np.interp(share, np.arange(len(facets)), across) for across in facets.T])
    apart = (chamfers[:, None] - points) * (mitre, 1.0)
    return bevel * float(np.sqrt(np.sum(apart * apart, axis=2)).min(axis=1).max())


def _levels(bevel: float, half: float, corners: Array) -> Array:
    """Return inset and height above the middle of the corners of a rounded end [m]."""
    return np.column_stack((bevel * (1.0 - corners[:, 0]), half - bevel + bevel * corners[:, 1]))


def _stacked(bevel: float, half: float, corners: Array, area: Callable[[float], float]) -> float:
    """Return the volume of half a solid with rounded ends, from the area of its section at an inset [m^3]."""
    insets, heights = _levels(bevel, half, corners).T
    sections = [(area(low), area((low + high) / 2.0), area(high)) for low, high in pairwise(insets.tolist())]
    layers = np.array(sections).reshape(-1, 3) @ (1.0, 4.0, 1.0) / 6.0  # exact: areas are quadratic
    return area(float(insets[0])) * float(heights[0]) + float(layers @ np.diff(heights))


def _rims(radius: float, levels: Array, sides: int, matrix: Array) -> tuple[Convex, ...]:
    """Return the pieces of a cylinder along local z with chamfered ends; between them, it is a cylinder."""
    pieces = [hull.transformed(matrix) for hull in _hulls(_rings(radius, levels, sides))]
    if len(pieces) == 1:
        return tuple(pieces)
    del pieces[len(pieces) // 2]
    return (Convex.cylinder(radius, 2.0 * float(levels[0, 1]), matrix), *pieces)


def _rings(radius: float, levels: Array, sides: int) -> list[Array]:
    """Return rings around a cylinder along z with rounded ends, shape (sides, 3) [m]."""
    angle = np.arange(sides) * (math.tau / sides)
    circle = np.column_stack((_portable.cos(angle), _portable.sin(angle))) / math.cos(math.pi / sides)
    return _mirrored([(radius - inset) * circle for inset in levels[:, 0]], levels[:, 1])


def _mirrored(rings: Sequence[Array], heights: Array) -> list[Array]:
    """Return rings of shape (k, 2) at heights below z = 0 and above it, from below, shape (k, 3) [m]."""
    upper = [np.insert(ring, 2, height, axis=1) for ring, height in zip(rings, heights, strict=True)]
    return [ring * (1.0, 1.0, -1.0) for ring in upper[::-1]] + upper


def _hulls(rings: Sequence[Array]) -> tuple[Convex, ...]:
    """Return the hull of convex rings one above the other, shape (k, 3); with many corners, of each two."""
    if sum(map(len, rings)) <= _MOST_VERTICES:
        return (Convex.hull(np.concatenate(rings)),)
    return tuple(Convex.hull(np.concatenate(pair)) for pair in pairwise(rings))


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
    return lazily(lambda: colliders.revolve_pieces(borders, turn, steps))


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
        simple = _is_simple(profile)

        def outer(tolerance: float) -> tuple[Convex, ...]:
            rings = _bevelled(profile.contours[0], half, bevel) if simple else ()
            return _hulls(rings) if len(rings) > 2 else whole.outer(tolerance)

        def close(tolerance: float) -> tuple[Convex, ...]:
            return (Convex.hull(np.concatenate(_bevelled(profile.contours[0], half, bevel, thick=False))),)

        inner = colliders.union(shorter, thinner).inner
        return Pieces(outer, inner, closer=Pieces(close, inner) if simple and bevel > _SHARP else None)

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


def _is_simple(profile: Outline) -> bool:
    """Tell whether a profile is one convex polygon."""
    return len(profile.contours) == 1 and profile.convex is not None and len(profile.convex) == 1


def _bevelled(contour: Contour, half: float, bevel: float, *, thick: bool = True) -> list[Array]:
    """Return rings around a convex prism along z with rounded ends: two for a small bevel, shape (k, 3)."""
    outward = mitres(contour)
    mitre = math.sqrt(float(np.sum(outward * outward, axis=1).max()))
    simpler = _SIMPLER if 2 * len(outward) > _MOST_VERTICES else 0.0

    def ring(inset: float) -> Array:
        return np.asarray(contour.points - inset * outward)

    def volume(corners: Array) -> float:
        return _stacked(bevel, half, corners, lambda inset: signed_area(ring(inset)))

    def measured(level: Detail) -> tuple[float, float]:
        facets = _facets(bevel_steps(bevel, level))
        return _beyond(bevel, chamfers, facets, mitre) + simpler, cover / volume(facets) - 1.0

    for count in range(5):
        chamfers = _chamfers(count)
        cover = volume(chamfers)
        if near(measured, thick=thick):
            break
    levels = _levels(bevel, half, chamfers)
    return _mirrored([ring(inset) for inset in levels[:, 0]], levels[:, 1])


def around_sweep(profile: Outline, place: Callable[[Array], list[Array]], closed: bool) -> Pieces:
    """Return the pieces of a profile drawn through stations."""
    borders = [contour.points for contour in profile.contours]
    simple = _is_simple(profile)

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
