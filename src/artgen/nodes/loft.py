"""Lofts: straight sides between profiles at different heights; and concave fillets, which are lofts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from itertools import pairwise

import numpy as np
from manifold3d import CrossSection
from numpy.typing import NDArray

from artgen import _portable, colliders
from artgen._arrays import Array, affine, predecessors, successors
from artgen.asset.shape import Contour, Outline, Shape
from artgen.colliders import Pieces, union
from artgen.graph import FULL, detail_level, kernel, records
from artgen.nodes import validators as check
from artgen.nodes.contours import CREASE, chords, estimated, faceted, moved_outline, signed_area
from artgen.nodes.csg import united
from artgen.nodes.handles import Array3, Profile, Scalar, Solid, VectorLike
from artgen.nodes.primitive_colliders import around_chain, around_hull, near
from artgen.nodes.surfaces import Sheets, Skin, triangulated
from artgen.nodes.unwrap import Rail, cap_uvs, lies_flat, runs_across, tapered_around, wall_uvs

_SHARE = 1e-7  # share of a border's length within which positions are equal
_STEPS = 9  # rings of a fillet; each third one bounds a collider
_TURN = math.radians(12.0)  # largest turn between points of a fillet around a corner
_SLICES = (1, 5, 8, 12)  # numbers of colliders between two profiles; fewer than 5 fill hollow sides
_LEDGE = 2e-5  # width of a fillet at its top, where its points would be one [m]
_STRAIGHT = 0.02  # largest change of a section over the height of a fillet, as a share of its area


def _loft(profiles: tuple[Outline, ...], heights: tuple[float, ...], axis: Array3) -> Shape:
    if len(profiles) < 2 or len(profiles) != len(heights):
        raise ValueError(
            f"a loft needs at least 2 profiles and a height for each, got {len(profiles)} profiles and "
            f"{len(heights)} heights"
        )
    levels = np.array(heights)
    if not (np.isfinite(levels).all() and (np.diff(levels) > 1e-9).all()):
        raise ValueError(f"the heights of a loft must ascend, got {', '.join(f'{h:g}' for h in heights)} m")
    turn = check.frame(axis)
    if check.frame_is_mirrored(turn):
        profiles = tuple(moved_outline(each, np.diag([1.0, -1.0]), np.zeros(2)) for each in profiles)
    contours = _matched([_border(at, outline) for at, outline in enumerate(profiles)])
    rings = np.stack(
        [
            np.column_stack([contour.points, np.full(len(contour.points), level)])
            for contour, level in zip(contours, levels, strict=True)
        ]
    )
    contours, rings = _coarse(contours, rings)
    contours, chains = _sliced(contours, rings)
    rings = np.stack([chains[0][0], *(ring for chain in chains for ring in chain[1:])])
    pieces = (around_chain([ring @ turn.T for ring in chain]) for chain in chains)
    return _skin(contours, rings).turned(turn).shape(union(*pieces))


@records(_loft)
def loft(
    profiles: Sequence[Profile], heights: Sequence[Scalar], *, axis: VectorLike = (0.0, 0.0, 1.0)
) -> Solid:
    """Join profiles at heights along an axis by straight sides.

    Profiles lie as in `extrude`. Each border starts at the right, half way up; points at equal shares of the
    borders' lengths are joined.

    Args:
        profiles: At least two convex profiles without holes.
        heights: Height of each profile along the axis, ascending [m].
        axis: Direction of the axis.

    Examples:
        >>> loft([rectangle(0.2, 0.2), circle(0.08), circle(0.04)], [0.0, 0.1, 0.2])
    """


@kernel(spelling="{solid}.fillet(point={point}, normal={normal}, radius={radius})")
def _fillet(solid: Shape, point: Array3, normal: Array3, radius: float) -> Shape:
    check.positive("radius", radius)
    turn = check.frame(check.direction("normal", normal))
    foot = check.vector("point", point)
    upright = solid.manifold.transform(np.column_stack([turn.T, -turn.T @ foot]))
    section, low = upright.slice(radius), upright.slice(_STRAIGHT * radius)
    if section.is_empty() or low.is_empty():
        raise ValueError(f"the solid does not reach from the plane to {1e3 * radius:.4g} mm above it")
    change = ((section - low).area() + (low - section).area()) / section.area()
    if change > _STRAIGHT:
        raise ValueError(
            f"the section of the solid changes by {100.0 * change:.2g} % of its area over the radius of "
            f"{1e3 * radius:.4g} mm; a fillet needs straight sides there: take a smaller radius or a loft"
        )
    flares = [_flare(each, radius) for each in section.decompose()]
    return united([solid, *(flare.transformed(affine(turn, foot)) for flare in flares)])


def _flare(section: CrossSection, radius: float) -> Shape:
    """Return a solid on z = 0 around a convex section, with sides that are concave arcs of a radius [m]."""
    outline = section.simplify(1e-6)
    rings = outline.to_polygons()
    if len(rings) != 1 or outline.hull().area() > (1.0 + 1e-4) * outline.area():
        raise ValueError(
            "a fillet needs a convex section without holes; fillet the convex parts of the solid"
        )
    points, ways = _corners(faceted(np.array(rings[0], np.float64)))
    angle = 0.5 * math.pi * np.arange(_STEPS + 1) / _STEPS
    out, up = radius * (1.0 - _portable.sin(angle)), radius * (1.0 - _portable.cos(angle))
    levels = [
        np.column_stack([points + width * ways, np.full(len(points), height)])
        for width, height in zip(out, up, strict=True)
    ]
    bounds = levels[::3]
    levels[-1][:, :2] += _LEDGE * ways
    pieces = [around_hull(partial(np.concatenate, pair)) for pair in pairwise(bounds)]
    contours = [Contour(level[:, :2].copy(), ways, ways) for level in levels]
    cover = Pieces(colliders.union(*pieces).outer, around_chain(levels).inner)
    return _skin(contours, np.stack(levels)).shape(cover)


def _corners(contour: Contour) -> tuple[Array, Array]:
    """Return the vertices of a convex polygon and their ways out; a sharp one is repeated for each way."""
    points, ways = [], []
    for point, first, last in zip(contour.points, contour.normals_in, contour.normals_out, strict=True):
        turn = math.acos(min(_portable.dot(first, last), 1.0))
        for share in np.linspace(0.0, 1.0, math.ceil(turn / _TURN) + 1) if turn > CREASE else (0.5,):
            way = (1.0 - share) * first + share * last
            points.append(point)
            ways.append(way / _portable.norm(way))
    return np.array(points), np.array(ways)


def _sliced(contours: Sequence[Contour], rings: Array) -> tuple[list[Contour], list[list[Array]]]:
    """Return borders, and chains of rings: the hull of two neighbors follows the sides between them."""
    # sides between profiles of different shapes are hollow: further borders divide them
    borders, chains = [contours[0]], [[rings[0]]]
    for (first, last), (low, high) in zip(pairwise(contours), pairwise(rings), strict=True):
        for count in _SLICES:
            cut = low + np.linspace(0.0, 1.0, count + 1)[:, None, None] * (high - low)
            if all(_follows(*pair) for pair in pairwise(cut)):
                break
        borders += [*(_between(first, last, at / count) for at in range(1, count)), last]
        if count == 1:
            chains[-1].append(high)
        else:
            chains += [*map(list, pairwise(cut)), [high]]
    return borders, [chain for chain in chains if len(chain) > 1]


def _between(first: Contour, last: Contour, share: float) -> Contour:
    parts = [
        (1.0 - share) * getattr(first, name) + share * getattr(last, name)
        for name in ("points", "normals_in", "normals_out")
    ]
    return Contour(parts[0], *(part / np.linalg.norm(part, axis=1, keepdims=True) for part in parts[1:]))


def _follows(low: Array, high: Array) -> bool:
    """Tell whether the hull of two rings is near the straight sides between their points."""
    first, last = low[:, :2], high[:, :2]
    sides = [(successors(ring) - ring) @ ((0.0, -1.0), (1.0, 0.0)) for ring in (first, last)]  # outward
    lengths = [np.sqrt(np.sum(side * side, axis=1)) for side in sides]
    normals = np.concatenate(sides) / np.maximum(np.concatenate(lengths), 1e-30)[:, None]
    reach = [(ring @ normals.T).max(axis=0) for ring in (first, last)]
    far = float((0.5 * (reach[0] + reach[1]) - (0.5 * (first + last) @ normals.T).max(axis=0)).max())
    bottom, top, middle = (signed_area(ring) for ring in (first, last, 0.5 * (first + last)))
    mixed = 0.5 * float(lengths[1] @ reach[0][len(first) :])  # area of both: the hull has more in the middle
    added = 4.0 * (0.5 * mixed + 0.25 * (bottom + top) - middle) / (bottom + 4.0 * middle + top)
    # triangles of hollow sides are as far below them as the hull is above
    return near(lambda level: (2.0 * far, 2.0 * added))


def _coarse(contours: list[Contour], rings: Array) -> tuple[list[Contour], Array]:
    """Return the borders and their vertices, shape (n, k, 3), with as few as the level of detail allows."""
    if detail_level() is FULL:
        return contours, rings
    off, (count, width, _) = 0.4 * detail_level().chord, rings.shape
    rows = chords(rings.reshape(count, -1), off * math.sqrt(width))
    around = np.concatenate([rings[rows], rings[rows, :1]], axis=1).transpose(1, 0, 2).reshape(width + 1, -1)
    half = width // 2
    parts = (around[: half + 1], around[half:])
    columns, rest = (chords(part, off * math.sqrt(len(rows))) for part in parts)
    kept = np.concatenate([columns[:-1], half + rest[:-1]])
    if len(kept) < 3:
        kept = np.arange(width)
    return [estimated(contours[row].points[kept]) for row in rows], rings[rows][:, kept]


def _border(at: int, outline: Outline) -> Contour:
    """Return the only border of a profile, starting at the right, half way up."""
    if len(outline.contours) != 1:
        raise ValueError(
            f"profile {at} of the loft has {len(outline.contours)} borders; each must have one, without holes"
        )
    contour = outline.contours[0]
    points = contour.points
    side = successors(points) - points
    following = successors(side)
    turn = side[:, 0] * following[:, 1] - side[:, 1] * following[:, 0]
    if turn.min() < -1e-6 * float((side * side).sum(axis=1).max()):
        raise ValueError(f"profile {at} of the loft is not convex; loft its convex parts and unite them")
    level = 0.5 * (points[:, 1].min() + points[:, 1].max())
    height = points[:, 1] - level
    height[np.abs(height) < 1e-9] = 0.0
    rising = int(np.flatnonzero((height <= 0.0) & (successors(height) > 0.0))[0])
    share = height[rising] / (height[rising] - successors(height)[rising])
    parts = [np.roll(part, -rising - 1, axis=0) for part in (points, contour.normals_in, contour.normals_out)]
    if share == 0.0:
        return Contour(*(predecessors(part) for part in parts))
    start = points[rising] + share * side[rising]
    normal = (1.0 - share) * contour.normals_out[rising] + share * parts[1][0]
    normal /= _portable.norm(normal)
    return Contour(
        *(np.concatenate([[new], part]) for new, part in zip((start, normal, normal), parts, strict=True))
    )


def _shares(contour: Contour) -> Array:
    """Return the position of each vertex along the border as a share of its length, then 1."""
    sides = successors(contour.points) - contour.points
    total = np.concatenate([[0.0], np.cumsum(np.hypot(sides[:, 0], sides[:, 1]))])
    return np.asarray(total / total[-1])


def _matched(contours: Sequence[Contour]) -> list[Contour]:
    """Return the borders with vertices at the union of their shares of length."""
    shares = [_shares(contour) for contour in contours]
    every = np.sort(np.concatenate([share[:-1] for share in shares]))
    every = every[np.concatenate([[True], np.diff(every) > _SHARE])]
    every = every[every < 1.0 - _SHARE]
    return [_sampled(contour, share, every) for contour, share in zip(contours, shares, strict=True)]


def _sampled(contour: Contour, share: Array, wanted: Array) -> Contour:
    side = np.clip(np.searchsorted(share, wanted + 2.0 * _SHARE, side="right") - 1, 0, len(share) - 2)
    part = (wanted - share[side]) / (share[side + 1] - share[side])
    at_vertex = np.abs(wanted - share[side]) <= 2.0 * _SHARE
    part = np.where(at_vertex, 0.0, part)[:, None]
    following = (side + 1) % len(contour.points)
    points = (1.0 - part) * contour.points[side] + part * contour.points[following]
    between = (1.0 - part) * contour.normals_out[side] + part * contour.normals_in[following]
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    vertex = at_vertex[:, None]
    return Contour(
        points,
        np.where(vertex, contour.normals_in[side], between),
        np.where(vertex, contour.normals_out[side], between),
    )


def _skin(contours: Sequence[Contour], rings: Array) -> Skin:
    corner = np.any(
        [np.einsum("ij,ij->i", each.normals_in, each.normals_out) < 1.0 - 1e-9 for each in contours], axis=0
    )
    rails = [Rail.along(contour, corner) for contour in contours]
    plane = np.stack([rail.normals for rail in rails])
    places = rings[:, rails[0].vertex]
    slant = np.diff(places, axis=0)
    below = _tilted(plane[:-1], slant)
    above = _tilted(plane[1:], slant)
    # height along the sides, not along their slanted edges
    length = np.hypot((slant[..., :2] * plane[:-1]).sum(axis=2), slant[..., 2]).mean(axis=1)
    travelled = np.concatenate([[0.0], np.cumsum(length)])
    level, normals, strips = [0], [below[0]], []
    for at in range(1, len(rings)):
        strips.append(len(level) - 1)
        level.append(at)
        arriving = above[at - 1]
        if at == len(rings) - 1:
            normals.append(arriving)
        elif np.einsum("ij,ij->i", arriving, below[at]).min() > math.cos(CREASE):
            mean = arriving + below[at]
            normals.append(mean / np.linalg.norm(mean, axis=1, keepdims=True))
        else:
            level.append(at)
            normals += [arriving, below[at]]
    levels = np.array(level)
    first = np.searchsorted(levels, levels)
    around = np.stack([rail.distance for rail in rails])[levels]
    mean = _mean_around(around[:, -1], length, first)
    around = tapered_around(rails[0], around, around * (mean / around[:, -1:]))
    size = np.ptp(rings.reshape(-1, 3), axis=0)
    uvs = wall_uvs(around, travelled[levels, None], lying=lies_flat(size[:2], float(size[2])))
    sheets = Sheets()
    place = sheets.grid(
        rails[0], places[levels], np.stack(normals), uvs, strips=np.array(strips), places=first
    )
    for row, sign in ((0, -1.0), (-1, 1.0)):
        flat = contours[row].points
        triangles = triangulated([flat])
        sheets.cap(
            place[row],
            rings[row],
            np.array([0.0, 0.0, sign]),
            cap_uvs(flat, sign, across=runs_across(size[:2])),
            triangles if sign > 0 else triangles[:, ::-1],
        )
    return sheets.skin()


def _mean_around(border: Array, length: Array, first: NDArray[np.int64]) -> Array:
    """Return the mean length of the rings between the creases on both sides of each row, shape (r, 1) [m]."""
    run = np.cumsum(first != np.arange(len(first)))
    strip = np.flatnonzero(np.diff(run) == 0)
    both = np.zeros((2, run[-1] + 1))
    np.add.at(both[0], run[strip], length * 0.5 * (border[strip] + border[strip + 1]))
    np.add.at(both[1], run[strip], length)
    return np.asarray((both[0] / both[1])[run, None])


def _tilted(normals: Array, slant: Array) -> Array:
    """Return normals in the plane, shape (r, c, 2), tilted perpendicular to the sides, (r, c, 3)."""
    tilted = np.empty(slant.shape)
    tilted[..., :2] = normals * slant[..., 2:]
    tilted[..., 2] = -(normals * slant[..., :2]).sum(axis=-1)
    return np.asarray(tilted / np.linalg.norm(tilted, axis=-1, keepdims=True))
