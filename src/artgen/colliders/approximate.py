"""Polytopes around and inside round solids, with few faces and a known error."""

import math

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array, cached
from artgen.colliders.polytope import SLIVER, Polytope

MOST_SIDES = 64
"""Most sides of a faceted circle."""

_MOST_FREQUENCY = 8  # most divisions of an icosahedron's edge
_MOST_INSCRIBED = 256  # most vertices of a thinned convex mesh


def circle_sides(radius: float, tolerance: float) -> int:
    """Return the number of sides, a multiple of 4, of a polygon around a circle within the tolerance [m]."""
    ratio = radius / (radius + max(tolerance, 0.0))
    angle = math.acos(min(ratio, 1.0))
    sides = 4 * math.ceil(math.pi / max(angle, 1e-3) / 4.0 - 1e-9)
    return min(max(sides, 8), MOST_SIDES)


def circumscribed_circle(radius: float, sides: int) -> Array:
    """Return a polygon around a circle with sides perpendicular to the axes, shape (sides, 2) [m]."""
    angle = (np.arange(sides) + 0.5) * (2.0 * np.pi / sides)
    return np.column_stack((np.cos(angle), np.sin(angle))) * (radius / math.cos(math.pi / sides))


def inscribed_circle(radius: float, sides: int) -> Array:
    """Return a polygon with its vertices on a circle, the first at angle 0, shape (sides, 2) [m]."""
    angle = np.arange(sides) * (2.0 * np.pi / sides)
    return np.column_stack((np.cos(angle), np.sin(angle))) * radius


@cached(_MOST_FREQUENCY)
def _geodesic(frequency: int) -> tuple[Array, float]:
    """Return points of a subdivided icosahedron on the unit sphere and the distance of its nearest face."""
    golden = (1.0 + math.sqrt(5.0)) / 2.0
    corners = np.array([(0.0, s, t * golden) for s in (-1.0, 1.0) for t in (-1.0, 1.0)], dtype=np.float64)
    corners = np.concatenate([np.roll(corners, shift, axis=1) for shift in range(3)])
    mesh = Manifold.hull_points(corners).to_mesh64()
    corners = np.array(mesh.vert_properties)[:, :3]
    weights = np.array(
        [(i, j, frequency - i - j) for i in range(frequency + 1) for j in range(frequency + 1 - i)],
        dtype=np.float64,
    )
    points = (weights @ corners[np.asarray(mesh.tri_verts).astype(np.int64)]).reshape(-1, 3)
    points /= np.sqrt(np.sum(points * points, axis=1))[:, None]
    _, first = np.unique(np.rint(points * 1e9).astype(np.int64), axis=0, return_index=True)
    points = points[np.sort(first)]
    return points, float(Polytope.hull(points).planes[:, 3].min())


def sphere_points(radius: float, tolerance: float, *, inscribed: bool = False) -> Array:
    """Return vertices of a polytope around (or inside) a sphere at the origin, shape (n, 3) [m].

    The error stays below the tolerance [m], except where this would need more than a thousand faces.
    """
    for frequency in range(1, _MOST_FREQUENCY + 1):
        points, nearest = _geodesic(frequency)
        error = radius * ((1.0 - nearest) if inscribed else (1.0 / nearest - 1.0))
        if error <= tolerance:
            break
    return points * (radius if inscribed else radius / nearest)


def inscribed_points(points: Array, tolerance: float) -> Array:
    """Return vertices of a convex mesh, shape (n, 3), whose hull is smaller by at most the tolerance [m].

    Adds the vertices farthest outside, at most one per face and round, until all are near enough.
    """
    extreme = np.concatenate((points.argmin(axis=0), points.argmax(axis=0)))
    chosen = sorted(set(extreme.tolist()))
    while len(chosen) < min(len(points), _MOST_INSCRIBED):
        try:
            inside = Polytope.hull(points[chosen])
        except ValueError:
            chosen = _off_plane(points, chosen)
            continue
        heights = inside.planes[:, :3] @ points.T - inside.planes[:, 3:]
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
    normal = np.linalg.svd(centered)[2][-1]
    distance = np.abs((points - points[chosen].mean(axis=0)) @ normal)
    distance[chosen] = -1.0
    return [*chosen, int(np.argmax(distance))]
