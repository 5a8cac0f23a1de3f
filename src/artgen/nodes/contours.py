"""Closed plane curves as points with analytic normals, and regions made of them."""

import math
from collections.abc import Sequence
from itertools import compress

import numpy as np
from manifold3d import CrossSection, FillRule

from artgen import _portable
from artgen._arrays import Array, Indices, cached_property, predecessors, successors
from artgen.asset.shape import Contour, Outline
from artgen.graph import FULL, detail_level
from artgen.nodes.surfaces import arc_steps, sides_of

CREASE = math.radians(35.0)
"""Smaller turns count as samples of a smooth curve."""

_SAME = 1e-7  # points of a contour closer than this are one [m]


def side_normals(points: Array) -> Array:
    """Return the unit normal to the right of each side of a closed polygon, shape (n, 2)."""
    sides = successors(points) - points
    length = np.hypot(sides[:, 0], sides[:, 1])
    return np.column_stack([sides[:, 1], -sides[:, 0]]) / np.maximum(length, 1e-300)[:, None]


def faceted(points: Array) -> Contour:
    """Return a contour with a corner at each of its points, shape (n, 2)."""
    normals = side_normals(points)
    return Contour(points, predecessors(normals), normals)


class _EstimatedContour(Contour):
    """A contour whose normals are estimated on first access: many outlines only serve to cut others."""

    def __init__(self, points: Array) -> None:
        points.setflags(write=False)
        vars(self)["points"] = points

    @cached_property
    def _normals(self) -> tuple[Array, Array]:
        """The normals of the sides that arrive at and leave each vertex, both shape (n, 2)."""
        leaving = side_normals(self.points)
        arriving = predecessors(leaving)
        sides = successors(self.points) - self.points
        length = np.hypot(sides[:, 0], sides[:, 1])[:, None]
        mean = leaving * length + arriving * predecessors(length)
        mean /= np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-300)
        curved = (np.einsum("ij,ij->i", leaving, arriving) > math.cos(CREASE))[:, None]
        return np.where(curved, mean, arriving), np.where(curved, mean, leaving)

    @property
    def normals_in(self) -> Array:
        """Outward unit normal at the end of the side that arrives at each vertex, shape (n, 2)."""
        return self._normals[0]

    @property
    def normals_out(self) -> Array:
        """Outward unit normal at the start of the side that leaves each vertex, shape (n, 2)."""
        return self._normals[1]


def estimated(points: Array) -> Contour:
    """Return a contour of points, shape (n, 2): turns below `CREASE` are smooth, larger turns are corners.

    A smooth vertex has the mean normal of its sides, weighted by length, so that a long straight side next to
    an arc stays flat.
    """
    return _EstimatedContour(points)


def reversed_contour(contour: Contour) -> Contour:
    """Return the reversed contour, which turns a border into a hole."""
    return Contour(
        np.ascontiguousarray(contour.points[::-1]),
        np.ascontiguousarray(-contour.normals_out[::-1]),
        np.ascontiguousarray(-contour.normals_in[::-1]),
    )


def arc_points(center: Array, radius: float, start: float, sweep: float, steps: int) -> tuple[Array, Array]:
    """Return points of an arc and their directions from the center, both shape (steps + 1, 2)."""
    angle = start + sweep * np.arange(steps + 1) / steps
    outward = np.column_stack([_portable.cos(angle), _portable.sin(angle)])
    outward[np.abs(outward) < 1e-15] = 0.0
    return center + radius * outward, outward


def circle_contour(radius: float, sides: int | None = None) -> Contour:
    """Return a circle about the origin, its points on the radius [m]."""
    points, outward = arc_points(np.zeros(2), radius, 0.0, math.tau, sides or sides_of(radius))
    return Contour(points[:-1], outward[:-1], outward[:-1])


def ellipse_contour(radius_x: float, radius_y: float) -> Contour:
    """Return an ellipse about the origin with its half axes [m] along x and y."""
    sides = sides_of(max(radius_x, radius_y))
    # half of the spacing follows the ellipse's parameter, half the turn of its normal: pointed ends get more
    # vertices than flat sides
    fine = math.tau * np.arange(16 * sides + 1) / (16 * sides)
    turn = np.unwrap(_portable.arctan2(_portable.sin(fine) / radius_y, _portable.cos(fine) / radius_x))
    angle = np.interp(math.tau * np.arange(sides) / sides, 0.5 * (fine + turn), fine)
    unit = np.column_stack([_portable.cos(angle), _portable.sin(angle)])
    unit[np.abs(unit) < 1e-15] = 0.0
    normals = unit / np.array([radius_x, radius_y])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Contour(unit * np.array([radius_x, radius_y]), normals, normals)


def rounded_polygon(corners: Array, radii: Sequence[float] | Array) -> Contour:
    """Return a counter-clockwise polygon whose corners are rounded by arcs tangent to its sides."""
    count = len(corners)
    normals = side_normals(corners)
    length = np.linalg.norm(successors(corners) - corners, axis=1)
    turns, reach = np.zeros(count), np.zeros(count)
    for i in range(count):
        before, after = normals[i - 1], normals[i]
        turns[i] = math.atan2(before[0] * after[1] - before[1] * after[0], _portable.dot(before, after))
        reach[i] = radii[i] * math.tan(abs(turns[i]) / 2.0)
    spare = length - reach - successors(reach)
    if spare.min() < -1e-9:
        side = int(np.argmin(spare))
        raise ValueError(
            f"the rounded corners at points {side} and {(side + 1) % count} need "
            f"{(length[side] - spare[side]) * 1e3:.3g} mm of a side {length[side] * 1e3:.3g} mm long; "
            "use a smaller radius"
        )
    points, arriving, leaving = [], [], []
    for i in range(count):
        before, after, turn = normals[i - 1], normals[i], turns[i]
        if radii[i] <= 0.0 or abs(turn) < 1e-6:
            points.append(corners[i : i + 1])
            arriving.append(before[None])
            leaving.append(after[None])
            continue
        sense = math.copysign(1.0, turn)
        along = np.array([-before[1], before[0]])
        center = corners[i] - along * reach[i] - sense * radii[i] * before
        start = math.atan2(sense * before[1], sense * before[0])
        arc, outward = arc_points(center, radii[i], start, turn, arc_steps(radii[i], turn))
        points.append(arc)
        arriving.append(sense * outward)
        leaving.append(sense * outward)
    return without_repeats(Contour(np.concatenate(points), np.concatenate(arriving), np.concatenate(leaving)))


def without_repeats(contour: Contour) -> Contour:
    """Return the contour with coincident neighboring points joined."""
    gap = np.linalg.norm(contour.points - predecessors(contour.points), axis=1)
    if gap.min() > _SAME:
        return contour
    kept = np.flatnonzero(gap > _SAME)  # each point absorbs the repeats that follow it
    last = successors(kept) - 1
    return Contour(contour.points[kept], contour.normals_in[kept], contour.normals_out[last])


def chords(line: Array, off: float) -> Indices:
    """Return the points of a line, shape (n, d), between which chords stay within a distance of it [m]."""
    kept = np.zeros(len(line), bool)
    kept[[0, -1]] = True
    spans = [(0, len(line) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        between, along = line[first + 1 : last] - line[first], line[last] - line[first]
        share = np.clip(_portable.product(between, along) / max(_portable.dot(along, along), 1e-24), 0.0, 1.0)
        apart = np.linalg.norm(between - share[:, None] * along, axis=1)
        if apart.max() > off:
            middle = first + 1 + int(np.argmax(apart))
            kept[middle] = True
            spans += [(first, middle), (middle, last)]
    return np.flatnonzero(kept)


def coarse(outline: Outline) -> Outline:
    """Return an outline with as few vertices as the level of detail allows."""
    if detail_level() is FULL:
        return outline
    contours = tuple(_coarse(contour) for contour in outline.contours)
    if not is_disjoint([contour.points for contour in contours]):
        return outline
    is_convex = len(contours) == 1 and outline.convex is not None and len(outline.convex) == 1
    return Outline(contours, (contours[0].points,) if is_convex else None)


def _coarse(contour: Contour) -> Contour:
    points = contour.points
    first = int(np.argmax(points[:, 0] + 0.618 * points[:, 1]))  # a corner
    ring = np.roll(points, -first, axis=0)
    far = int(np.argmax(np.linalg.norm(ring - ring[0], axis=1)))
    off = 0.4 * detail_level().chord
    ends = (ring[: far + 1], np.concatenate([ring[far:], ring[:1]]))
    kept = np.concatenate([chords(ends[0], off)[:-1], far + chords(ends[1], off)[:-1]])
    if len(kept) < 3 or abs(signed_area(ring[kept])) < _MOST_LOST * abs(signed_area(ring)):
        return contour
    return estimated(ring[kept])


_MOST_LOST = 0.7  # least share of the area of a contour that is left with fewer vertices


def signed_area(points: Array) -> float:
    """Return the area of a polygon [m^2], negative if clockwise."""
    following = successors(points)
    return float(0.5 * (points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0]).sum())


def _signed_areas(rings: Sequence[Array]) -> Array:
    """Return the areas of polygons [m^2]; one call for all, because there may be hundreds."""
    if not rings:
        return np.zeros(0)
    points, counts = np.concatenate(rings), np.array([len(ring) for ring in rings])
    starts, following = np.cumsum(counts) - counts, np.arange(1, len(points) + 1)
    following[starts + counts - 1] = starts
    (x, y), (after_x, after_y) = points.T, points[following].T
    return np.asarray(0.5 * np.add.reduceat(x * after_y - after_x * y, starts))


def section(contours: Sequence[Contour]) -> CrossSection:
    """Return the region as a manifold3d cross-section, with overlaps resolved."""
    return CrossSection([contour.points for contour in contours], FillRule.Positive)


_ROUNDED = 1e-8  # displacement of borders by rounding in booleans [m]


def is_disjoint(rings: Sequence[Array]) -> bool:
    """Tell whether rings neither cross each other nor themselves."""
    area = sum(signed_area(ring) for ring in rings)
    around = sum(float(np.linalg.norm(successors(ring) - ring, axis=1).sum()) for ring in rings)
    covered = CrossSection(list(rings), FillRule.Positive).area()
    # the union rounds every border by some nanometres
    return bool(area > 0.0 and abs(covered - area) <= 1e-6 * area + _ROUNDED * around)


def outline_of(region: CrossSection, what: str) -> Outline:
    """Return the outline of a region, with estimated normals."""
    polygons = [np.asarray(each, float) for each in region.simplify(_SAME).to_polygons() if len(each) >= 3]
    contours = tuple(map(estimated, compress(polygons, np.abs(_signed_areas(polygons)) > 1e-12)))
    if not contours:
        raise ValueError(f"{what} is empty")
    return Outline(contours)


def moved_outline(outline: Outline, matrix: Array, offset: Array) -> Outline:
    """Return the outline with each point p at matrix @ p + offset, shapes (2, 2) and (2,)."""
    scale = float(matrix[0, 0])
    if scale > 0.0 and matrix.tolist() == [[scale, 0.0], [0.0, scale]]:  # most outlines are not rotated
        return _placed(outline, scale, offset)
    determinant = float(np.linalg.det(matrix))
    if abs(determinant) < 1e-12:
        raise ValueError("the profile would be flattened: no scale may be 0")
    turn = _portable.inverse(matrix)

    def moved(contour: Contour) -> Contour:
        arriving, leaving = (normals @ turn for normals in (contour.normals_in, contour.normals_out))
        arriving /= np.linalg.norm(arriving, axis=1, keepdims=True)
        leaving /= np.linalg.norm(leaving, axis=1, keepdims=True)
        points = contour.points @ matrix.T + offset
        if determinant > 0.0:
            return Contour(points, arriving, leaving)
        # a mirrored contour is reversed, so that its outside stays on the right
        return Contour(*(np.ascontiguousarray(part[::-1]) for part in (points, leaving, arriving)))

    def moved_polygon(points: Array) -> Array:
        result = points @ matrix.T + offset
        return result if determinant > 0.0 else np.ascontiguousarray(result[::-1])

    convex = outline.convex and tuple(moved_polygon(polygon) for polygon in outline.convex)
    return Outline(tuple(moved(contour) for contour in outline.contours), convex)


def _placed(outline: Outline, scale: float, offset: Array) -> Outline:
    """Return the outline with each point p at scale * p + offset, without a change of normals."""
    contours = tuple(
        Contour(contour.points * scale + offset, contour.normals_in, contour.normals_out)
        for contour in outline.contours
    )
    convex = outline.convex and tuple(polygon * scale + offset for polygon in outline.convex)
    return Outline(contours, convex)


def refined(outline: Outline, longest: float) -> Outline:
    """Return the outline with extra vertices on sides longer than `longest` [m], so that they can bend."""
    return Outline(tuple(_refined(contour, longest) for contour in outline.contours), outline.convex)


def _refined(contour: Contour, longest: float) -> Contour:
    following = successors(contour.points)
    parts = np.maximum(np.ceil(np.hypot(*(following - contour.points).T) / longest), 1).astype(np.int64)
    side = np.repeat(np.arange(len(parts)), parts)
    step = np.arange(len(side)) - np.repeat(np.cumsum(parts) - parts, parts)
    share = (step / parts[side])[:, None]
    points = (1.0 - share) * contour.points[side] + share * following[side]
    between = (1.0 - share) * contour.normals_out[side] + share * successors(contour.normals_in)[side]
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    first = (step == 0)[:, None]
    return Contour(
        points,
        np.where(first, contour.normals_in[side], between),
        np.where(first, contour.normals_out[side], between),
    )
