"""Convex pieces of solids by construction: round solids, prisms, chains and hulls."""

import math
from collections.abc import Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array, successors
from artgen.colliders.convex import Convex
from artgen.colliders.enclose import Facets, enclosing
from artgen.colliders.pieces import Cover, Exact, Pieces
from artgen.colliders.polygon import convex_hull, decompose_polygon
from artgen.colliders.polytope import SLIVER, Polytope

_IDENTITY = np.eye(4)
_MOST_PRISM_VERTICES = 64
_MOST_INSCRIBED = 256  # most vertices of a thinned convex mesh
_STRAIGHT = 1e-9  # rings whose points deviate less from straight lines form one prism [m]


def hull_pieces(points: Array) -> Pieces:
    """Return the cover of a convex solid with the given mesh vertices, shape (n, 3) [m].

    Raises:
        ValueError: The points are fewer than four, not finite, or lie in one plane.
    """
    solid = Convex.hull(points)
    if solid.kind == "box" or len(solid.points) <= 16:
        return Exact([solid])
    return Pieces(lambda _: (solid,), lambda tolerance: _thinned_hull(solid, tolerance))


def round_pieces(primitive: Convex, points: Array) -> Pieces:
    """Return the cover of a convex mesh whose vertices, shape (n, 3) [m], lie on or in a round primitive.

    The primitive contains the mesh; the mesh contains the hull of some of its vertices.
    """
    solid = Convex.hull(points)
    return Pieces(lambda _: (primitive,), lambda tolerance: _thinned_hull(solid, tolerance))


def _thinned_hull(solid: Convex, tolerance: float) -> Cover:
    return (Convex.hull(_inscribed_points(solid.points, tolerance)),)


def _inscribed_points(points: Array, tolerance: float) -> Array:
    """Return vertices of a convex mesh, shape (n, 3), whose hull is smaller by at most the tolerance [m]."""
    # adds the vertices farthest outside, at most one per face and round, until all are near enough
    extreme = np.concatenate((points.argmin(axis=0), points.argmax(axis=0)))
    chosen = sorted(set(extreme.tolist()))
    while len(chosen) < min(len(points), _MOST_INSCRIBED):
        try:
            inside = Polytope.hull(points[chosen])
        except ValueError:
            chosen = _off_plane(points, chosen)
            continue
        heights = _portable.product(inside.planes[:, :3], points.T) - inside.planes[:, 3:]
        outside, face = heights.max(axis=0), heights.argmax(axis=0)
        limit = max(tolerance, SLIVER, float(outside.max()) / 2.0)
        if outside.max() <= max(tolerance, SLIVER):
            break
        order = np.argsort(-outside, kind="stable")
        order = order[outside[order] >= limit]
        _, first = np.unique(face[order], return_index=True)
        chosen.extend(order[np.sort(first)].tolist()[: _MOST_INSCRIBED - len(chosen)])
    thin: Array = points[np.sort(chosen)]
    return thin


def _off_plane(points: Array, chosen: list[int]) -> list[int]:
    """Add the point farthest from the plane of the chosen points."""
    centered = points[chosen] - points[chosen].mean(axis=0)
    normal = _portable.eigenvectors(_portable.product(centered.T, centered))[1][:, 0]
    distance = np.abs(_portable.product(points - points[chosen].mean(axis=0), normal))
    distance[chosen] = -1.0
    return [*chosen, int(np.argmax(distance))]


def cylinder_pieces(radius: float, length: float, pose: Array = _IDENTITY, mesh_sides: int = 32) -> Pieces:
    """Return the cover of a cylinder along z of its pose, centered [m].

    Args:
        radius: Radius of the mesh vertices [m].
        length: Length along z [m].
        pose: Rigid transform, shape (4, 4).
        mesh_sides: Number of sides of the mesh; its first vertex is at angle 0.

    Raises:
        ValueError: A length is not positive or the mesh has fewer than three sides.
    """
    if mesh_sides < 3:
        raise ValueError(f"a cylinder needs at least 3 sides, got {mesh_sides}")
    cylinder = Convex.cylinder(radius, length, pose)
    angle = np.arange(mesh_sides) * (2.0 * np.pi / mesh_sides)
    rim = radius * np.column_stack((_portable.cos(angle), _portable.sin(angle)))

    def inner(tolerance: float) -> Cover:
        polygon = rim[:: _mesh_step(radius, mesh_sides, tolerance)]
        prism = Polytope.prism(polygon, -length / 2.0, length / 2.0)
        return (Convex.of(prism.transformed(cylinder.pose)),)

    return Pieces(lambda _: (cylinder,), inner)


def _mesh_step(radius: float, mesh_sides: int, tolerance: float) -> int:
    """Return the number of mesh sides that one chord may replace, a divisor of the number of sides."""
    for step in range(mesh_sides // 4, 1, -1):
        if mesh_sides % step == 0 and radius * (1.0 - math.cos(math.pi * step / mesh_sides)) <= tolerance:
            return step
    return 1


def prism_pieces(
    contours: Sequence[Array],
    bottom: float,
    top: float,
    pose: Array = _IDENTITY,
    *,
    convex: Sequence[Array] | None = None,
) -> Pieces:
    """Return the cover of an extruded profile.

    Args:
        contours: Outer borders counter-clockwise and holes clockwise, each shape (n, 2) [m].
        bottom: Lower end along z of the pose [m].
        top: Upper end along z of the pose [m].
        pose: Rigid transform, shape (4, 4).
        convex: Convex counter-clockwise polygons, each shape (k, 2), whose union is the region; computed if
            they are missing.

    Raises:
        ValueError: The ends are not in ascending order, or a contour is not finite.
    """
    if not bottom < top:
        raise ValueError(f"a prism needs its bottom below its top, got {bottom} m and {top} m")
    known = None if convex is None else [convex_hull(np.asarray(polygon)) for polygon in convex]

    def cover(tolerance: float, *, inner: bool) -> Cover:
        polygons = known
        if polygons is None:
            polygons = decompose_polygon(contours, tolerance, inner=inner)
        elif inner and len(polygons) == 1:  # thinned neighbors would separate at common sides
            polygons = decompose_polygon(polygons, tolerance, inner=True)
        prisms = (Polytope.prism(polygon, bottom, top) for polygon in polygons)
        return tuple(
            Convex.of((prism if inner else _fewer_sides(prism, tolerance)).transformed(pose))
            for prism in prisms
            if prism.width >= SLIVER
        )

    return Pieces(
        lambda tolerance: cover(tolerance, inner=False), lambda tolerance: cover(tolerance, inner=True)
    )


def _fewer_sides(prism: Polytope, tolerance: float) -> Polytope:
    """Return a prism with fewer sides around a prism with too many, if the tolerance allows."""
    if len(prism.points) <= _MOST_PRISM_VERTICES:
        return prism
    around, excess = enclosing(Facets.hull(prism.points), _MOST_PRISM_VERTICES, tolerance)
    return Polytope.hull(around) if excess <= tolerance else prism


def chain_pieces(rings: Sequence[Array], *, closed: bool = False) -> Pieces:
    """Return the cover of a sweep or loft: hulls of neighboring rings, few along straight parts.

    Args:
        rings: Cross-sections along the chain with corresponding points, each convex, shape (k, 3) [m]. Sweep
            a profile that is not convex as several chains.
        closed: Whether the last ring joins the first.

    Raises:
        ValueError: There are too few rings, or they differ in their number of points.
    """
    table = [np.asarray(ring, np.float64) for ring in rings]
    if len(table) < (3 if closed else 2) or len({ring.shape for ring in table}) != 1:
        raise ValueError(
            f"a chain needs at least {3 if closed else 2} rings with equally many points, "
            f"got {[len(ring) for ring in table]}"
        )
    stack = np.stack([*table, table[0]] if closed else table)
    if not np.isfinite(stack).all():
        raise ValueError("a chain needs finite rings, got NaN or infinity")

    def outer(tolerance: float) -> Cover:
        ends = _ring_planes(stack)
        runs = _straight_runs(stack, tolerance)
        return tuple(_link(stack[start : end + 1], ends[start], ends[end]) for start, end in runs)

    def inner(_: float) -> Cover:
        links = (_inner_link(stack[start], stack[end]) for start, end in _straight_runs(stack, _STRAIGHT))
        return tuple(Convex.of(link) for link in links if link is not None)

    return Pieces(outer, inner)


def _ring_planes(stack: Array) -> Array:
    """Return the planes of rings as (nx, ny, nz, d), shape (n, 4) [m]; zero for a ring that is not flat."""
    middle = stack.mean(axis=1)
    around = stack - middle[:, None]
    normals = np.cross(around, np.roll(around, -1, axis=1)).sum(axis=1)
    normals /= np.maximum(np.sqrt(np.sum(normals * normals, axis=1)), 1e-30)[:, None]
    off = np.abs(np.einsum("rki,ri->rk", around, normals)).max(axis=1)
    planes = np.column_stack((normals, np.sum(normals * middle, axis=1)))
    planes[off > _STRAIGHT] = 0.0
    return planes


def _link(rings: Array, first: Array, last: Array) -> Convex:
    """Return the hull of consecutive rings."""
    # if both end rings are flat and faces of the hull, all points are corners; only tight bends violate this
    count = rings.shape[1]
    if len(rings) == 2 and 4 < count <= _MOST_PRISM_VERTICES // 2:
        ahead, behind = (
            _portable.product(ring, plane[:3]) - plane[3]
            for ring, plane in ((rings[1], first), (rings[0], last))
        )
        if min(ahead.min(), -behind.max()) > SLIVER or min(-ahead.max(), behind.min()) > SLIVER:
            return Convex("hull", _IDENTITY, (), rings.reshape(-1, 3))
    return Convex.hull(rings.reshape(-1, 3))


def _straight_runs(stack: Array, tolerance: float) -> list[tuple[int, int]]:
    """Return spans of rings in which all points stay within the tolerance of straight lines."""
    runs: list[tuple[int, int]] = []
    start = 0
    while start < len(stack) - 1:
        end = start + 1
        while end + 1 < len(stack) and _is_straight(stack[start : end + 2], tolerance):
            end += 1
        runs.append((start, end))
        start = end
    return runs


def _is_straight(rings: Array, tolerance: float) -> bool:
    """Tell whether the points of rings stay near the lines between the first and the last ring."""
    line = rings[-1] - rings[0]
    square = np.maximum(np.sum(line * line, axis=1), 1e-30)
    middle = rings[1:-1] - rings[0]
    share = np.clip(np.sum(middle * line, axis=2) / square, 0.0, 1.0)
    off = middle - share[..., None] * line
    return bool(np.sqrt(np.sum(off * off, axis=2)).max() <= tolerance)


def _inner_link(first: Array, last: Array) -> Polytope | None:
    """Return a polytope inside the mesh between two rings."""
    # smaller by the dip of sides that are not flat, but not at its ends: no walls between consecutive links
    hull = Polytope.hull(np.concatenate((first, last)))
    near, far = successors(first), successors(last)
    across = np.cross(near - first, last - first)
    across /= np.maximum(np.sqrt(np.sum(across * across, axis=1)), 1e-30)[:, None]
    dip = float(np.abs(np.sum((far - first) * across, axis=1)).max())
    if dip <= _STRAIGHT:
        return hull
    planes = hull.planes.copy()
    is_end = np.zeros(len(planes), dtype=bool)
    for ring in (first, last):
        is_end |= np.abs(_portable.product(planes[:, :3], ring.T) - planes[:, 3:]).max(axis=1) <= _STRAIGHT
    planes[~is_end, 3] -= dip
    return hull.clipped(planes)
