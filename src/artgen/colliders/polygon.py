"""Convex decomposition of regions of the plane."""

from collections.abc import Sequence

import numpy as np
from manifold3d import CrossSection, FillRule, triangulate
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, predecessors, successors
from artgen.colliders.polytope import SNAP

_DIGITS = 12  # tolerance of ties, which the last digits must not decide [m]

_LEAST_SIDES = 4  # least sides of a thinned hole, which must not vanish
_FLAT = 1e-9  # relative turn below which a corner is straight


def decompose_polygon(contours: Sequence[Array], tolerance: float, *, inner: bool = False) -> list[Array]:
    """Cover a plane region by few convex polygons.

    The polygons contain the region and exceed it by at most the tolerance, where fewer sides follow concave
    arcs. With `inner`, they lie inside the region, and fewer sides follow convex arcs.

    Args:
        contours: Outer borders counter-clockwise and holes clockwise, each shape (n, 2) [m].
        tolerance: Largest distance between the polygons and the region [m].
        inner: Whether the region must contain the polygons, instead of the reverse.

    Returns:
        Counter-clockwise polygons, each shape (k, 2) [m].

    Raises:
        ValueError: The region is empty or not finite.
    """
    cleaned = [_cleaned(np.asarray(contour, np.float64)) for contour in contours]
    sign = 1.0 if inner else -1.0
    thinned = [_thinned(contour, tolerance, sign) for contour in cleaned if len(contour) >= 3]
    if not thinned or sum(map(signed_area, thinned)) <= 0.0:
        raise ValueError("the region is empty: outer borders must run counter-clockwise, holes clockwise")
    if len(thinned) == 1 and is_convex(thinned[0]):
        return thinned
    if len(thinned) == 2:
        border, hole = sorted(thinned, key=signed_area, reverse=True)
        if is_convex(border) and is_convex(hole[::-1]) and _inside(border, hole):
            return _ring_sectors(border, hole[::-1])
    # chords may have crossed another contour; the fill rule resolves this
    region = CrossSection(thinned, FillRule.Positive).to_polygons()
    return _merged_triangles([np.asarray(loop, np.float64) for loop in region]) if region else []


def signed_area(contour: Array) -> float:
    """Return the area of a contour, shape (n, 2) [m]: positive if it runs counter-clockwise [m^2]."""
    following = successors(contour)
    return float(np.sum(contour[:, 0] * following[:, 1] - contour[:, 1] * following[:, 0]) / 2.0)


def is_convex(contour: Array) -> bool:
    """Tell whether a contour, shape (n, 2), is counter-clockwise and convex."""
    sides = successors(contour) - contour
    length = np.hypot(sides[:, 0], sides[:, 1])
    if (_turns(contour) < -_FLAT * length * predecessors(length)).any():
        return False
    angle = _portable.arctan2(sides[:, 1], sides[:, 0])
    turn = np.mod(np.diff(angle, append=angle[:1]) + np.pi, 2.0 * np.pi) - np.pi
    return bool(abs(turn.sum() - 2.0 * np.pi) < 1.0)  # turns once


def convex_hull(points: Array) -> Array:
    """Return the corners of the convex hull of points, shape (n, 2) [m], counter-clockwise."""
    rows = sorted(set(map(tuple, points.tolist())))
    halves = []
    for line in (rows, rows[::-1]):
        chain: list[tuple[float, float]] = []
        for x, y in line:
            while len(chain) >= 2:
                (x0, y0), (x1, y1) = chain[-2], chain[-1]
                ahead = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)
                if ahead > 1e-12 * (abs(x - x0) + abs(y - y0)) * (abs(x1 - x0) + abs(y1 - y0)):
                    break
                chain.pop()
            chain.append((x, y))
        halves.append(chain[:-1])
    return np.array(halves[0] + halves[1])


def _turns(contour: Array) -> Array:
    """Return twice the area of the triangle at each vertex, positive at convex corners, shape (n,) [m^2]."""
    before = contour - predecessors(contour)
    after = successors(contour) - contour
    turns: Array = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    return turns


def _cleaned(contour: Array) -> Array:
    """Drop repeated and straight vertices."""
    if contour.ndim != 2 or contour.shape[1] != 2 or not np.isfinite(contour).all():
        raise ValueError(f"a contour needs finite points of shape (n, 2), got shape {contour.shape}")
    step = successors(contour) - contour
    contour = contour[np.hypot(step[:, 0], step[:, 1]) > SNAP]
    while len(contour) >= 3:
        before = contour - predecessors(contour)
        after = successors(contour) - contour
        length = np.hypot(before[:, 0], before[:, 1]) * np.hypot(after[:, 0], after[:, 1])
        straight = np.abs(_turns(contour)) <= _FLAT * length
        straight &= ~predecessors(straight)  # not two in a row: they are examined again
        if not straight.any():
            break
        contour = contour[~straight]
    return contour


def _thinned(contour: Array, tolerance: float, sign: float) -> Array:
    """Drop vertices that turn by `sign` if the chord stays within the tolerance of the contour."""
    turning = sign * _turns(contour) > 0.0
    if not turning.any():
        return contour
    count = len(contour)
    start = 0 if turning.all() else int(np.argmin(turning))
    order = ((np.arange(count + 1) + start) % count).astype(np.int64)
    if turning.all():
        even = _even_steps(contour, order, tolerance)
        if even is not None:
            return even
    chosen = [0]
    while chosen[-1] < count:
        here = end = chosen[-1]
        end += 1
        while end < count and turning[order[end]] and _near_chord(contour[order[here : end + 2]], tolerance):
            end += 1
        chosen.append(end)
    thin = contour[order[chosen[:-1]]]
    return thin if len(thin) >= _LEAST_SIDES or len(thin) == count else contour


def _even_steps(contour: Array, order: NDArray[np.int64], tolerance: float) -> Array | None:
    """Return every k-th vertex of a contour that turns in one direction only, if that divides evenly."""
    count = len(contour)
    step = 1
    while step < count // _LEAST_SIDES and _near_chord(contour[order[: step + 2]], tolerance):
        step += 1
    sides = -(-count // step)
    corners = np.rint(np.arange(sides + 1) * (count / sides)).astype(np.int64)
    chords = zip(corners[:-1].tolist(), corners[1:].tolist(), strict=True)
    if all(_near_chord(contour[order[here : end + 1]], tolerance) for here, end in chords):
        thin: Array = contour[order[corners[:-1]]]
        return thin
    return None


def _near_chord(run: Array, tolerance: float) -> bool:
    """Tell whether consecutive vertices stay within the tolerance of the chord between the ends."""
    if len(run) <= 2:
        return True
    chord = run[-1] - run[0]
    length = float(np.hypot(chord[0], chord[1]))
    if length <= SNAP:
        return False
    middle = run[1:-1] - run[0]
    along = _portable.product(middle, chord) / length
    across = np.abs(middle[:, 0] * chord[1] - middle[:, 1] * chord[0]) / length
    return bool(across.max() <= tolerance and along.min() >= 0.0 and along.max() <= length)


def _inside(border: Array, hole: Array) -> bool:
    """Tell whether all vertices of a hole lie inside a convex border."""
    sides = successors(border) - border
    offset = hole[None, :, :] - border[:, None, :]
    return bool((sides[:, None, 0] * offset[..., 1] - sides[:, None, 1] * offset[..., 0]).min() > 0.0)


def _ring_sectors(border: Array, hole: Array) -> list[Array]:
    """Cut the region between a convex border and a convex hole into one sector per side of the hole."""
    center = hole.mean(axis=0)
    sectors: list[Array] = []
    for start, end in zip(hole, successors(hole), strict=True):
        sector = _clipped(border, start, end - start, right=True)
        for point, direction, right in ((start, start - center, False), (end, end - center, True)):
            sector = _clipped(sector, point, direction, right=right)
        sectors.append(_cleaned(sector))
    return sectors


def _clipped(polygon: Array, point: Array, direction: Array, *, right: bool) -> Array:
    """Return the part of a convex polygon on one side of a line."""
    normal = np.array((direction[1], -direction[0])) / np.hypot(direction[0], direction[1])
    height = _portable.product(polygon - point, normal if right else -normal)
    following, next_height = successors(polygon), successors(height)
    rows: list[Array] = []
    for here, there, low, high in zip(polygon, following, height, next_height, strict=True):
        if low >= -SNAP:
            rows.append(here)
        if (low > SNAP and high < -SNAP) or (low < -SNAP and high > SNAP):
            rows.append(here + (there - here) * (low / (low - high)))
    return np.array(rows).reshape(-1, 2)


def _merged_triangles(contours: Sequence[Array]) -> list[Array]:
    """Triangulate a region and join triangles across diagonals, longest first, while they stay convex."""
    contours = [np.round(contour, _DIGITS) for contour in contours]
    points = np.concatenate(contours)
    triangles = np.asarray(triangulate(contours)).astype(np.int64)
    parts: dict[int, list[int]] = dict(enumerate(triangles.tolist()))
    owner = list(range(len(parts)))
    sides: dict[tuple[int, int], int] = {}
    diagonals: list[tuple[float, int, int]] = []
    for number, loop in parts.items():
        for start, end in zip(loop, (*loop[1:], loop[0]), strict=True):
            sides[start, end] = number
            if (end, start) in sides:
                length = round(float(np.hypot(*(points[end] - points[start]))), _DIGITS)
                diagonals.append((-length, start, end))

    def find(number: int) -> int:
        while owner[number] != number:
            number = owner[number]
        return number

    for _, start, end in sorted(diagonals):
        first, second = find(sides[start, end]), find(sides[end, start])
        if first == second:
            continue
        loop = _spliced(parts[first], parts[second], start, end)
        if is_convex(points[loop]):
            parts[first] = loop
            owner[second] = first
            del parts[second]
    cleaned = (_cleaned(points[loop]) for loop in parts.values())
    return [polygon for polygon in cleaned if len(polygon) >= 3 and signed_area(polygon) > 0.0]


def _spliced(first: list[int], second: list[int], start: int, end: int) -> list[int]:
    """Join two loops at the side that runs from start to end in the first and in reverse in the second."""
    at = first.index(end)
    turned = first[at:] + first[:at]  # end ... start
    at = second.index(start)
    back = second[at:] + second[:at]  # start ... end
    return turned + back[1:-1]
