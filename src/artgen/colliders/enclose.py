"""Polytopes with few vertices around convex solids with many."""

from dataclasses import dataclass
from typing import Self

import numpy as np
from manifold3d import Manifold, Mesh64
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, cached, cached_property
from artgen.colliders.convex import TOLERANCE, Convex
from artgen.colliders.polytope import SNAP
from artgen.colliders.triangles import across, cross, hull_of, planes_of, triangles_of

_FLAT = 1e-8  # least ratio of area to squared longest side of a dual triangle that is not degenerate
_APART = 1e8  # corners nearer than the inverse of this are one [1/m]
_WORTHWHILE = 0.5  # corners with at least this share of the largest excess are cut off in the same round
_NEAR = 0.0006  # largest distance of a polytope with fewer vertices [m]
_FAR = 0.001  # largest distance if it adds little volume [m]
_ADDED = 0.02  # share of volume that counts as little
_MOST_HALVINGS = 3


@dataclass(frozen=True, eq=False)
class Facets:
    """A convex solid as triangles, several of which may lie in one plane.

    Fast to build for a thousand vertices, unlike a `Polytope`, which stores the faces of each vertex.

    Attributes:
        solid: The solid as a convex manifold.
    """

    solid: Manifold

    @classmethod
    def hull(cls, points: Array) -> Self:
        """Make the convex hull of points, shape (n, 3) [m]."""
        return cls(hull_of(points))

    @cached_property
    def points(self) -> Array:
        """The vertices, shape (n, 3) [m]."""
        points: Array = np.array(self._mesh.vert_properties)[:, :3]
        return points

    @cached_property
    def planes(self) -> Array:
        """The planes of the triangles as (nx, ny, nz, d), inside is `n.x <= d`, shape (m, 4)."""
        normals, area, corners = self._across
        planes = planes_of(corners, normals, area)
        # hulls may have needles whose normal points inwards
        return planes[planes[:, 3] > _portable.product(planes[:, :3], self.center)]

    @cached_property
    def center(self) -> Array:
        """The centroid of the surface, shape (3,) [m]: well inside even if most vertices are at one end."""
        _, area, corners = self._across
        return np.asarray(_portable.product(area, corners.mean(axis=1)) / area.sum(), np.float64)

    @cached_property
    def volume(self) -> float:
        """The volume [m^3]."""
        return float(self.solid.volume())

    def halves(self) -> "list[Facets]":
        """Return the parts on both sides of the center of the longest side of the bounding box."""
        lower, upper = self.points.min(axis=0), self.points.max(axis=0)
        axis = int(np.argmax(upper - lower))
        middle = (lower[axis] + upper[axis]) / 2.0
        height = self.points[:, axis] - middle
        triangles = self._triangles
        start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
        crossing = (height[start] < 0.0) & (height[end] > 0.0)  # each edge once: it ascends in one triangle
        start, end = start[crossing], end[crossing]
        share = height[start] / (height[start] - height[end])
        cut = self.points[start] + share[:, None] * (self.points[end] - self.points[start])
        cut[:, axis] = middle
        sides = (self.points[height <= 0.0], self.points[height >= 0.0])
        return [Facets.hull(np.concatenate((side, cut))) for side in sides]

    @cached_property
    def _mesh(self) -> Mesh64:
        return self.solid.to_mesh64()

    @cached_property
    def _triangles(self) -> NDArray[np.int64]:
        return triangles_of(self._mesh)

    @cached_property
    def _across(self) -> tuple[Array, Array, Array]:
        """Normals with twice the area as length, these areas, and the corners of the triangles."""
        corners = self.points[self._triangles]
        return *across(corners), corners


def enclosing(solid: Facets, most_vertices: int, tolerance: float) -> tuple[Array, float]:
    """Return the corners of a polytope around a convex solid, shape (n, 3) [m], and its largest distance [m].

    Its faces are faces of the solid and of its bounding box. At each corner the face that cuts off most is
    added, the farthest corners first, until all corners are within the tolerance [m] or the number of
    vertices reaches the limit.
    """
    chosen = _bounding_planes(solid.points)
    corners = _corners(chosen, solid.center)
    waiting = solid.planes
    # workspace for heights of planes at corners
    room = np.empty(len(waiting) * max(most_vertices, len(corners)))
    most_added = most_vertices
    while True:
        heights = room[: len(waiting) * len(corners)].reshape(len(waiting), -1)
        np.einsum("ij,kj->ik", waiting[:, :3], corners, out=heights)
        highest = heights.max(axis=1)
        corner = (heights >= highest[:, None] - SNAP).argmax(axis=1)  # the first of equal ones
        reach = highest - waiting[:, 3]
        excess = max(float(reach.max()), 0.0)
        spare = min((most_vertices - len(corners)) // 2, most_added)
        if excess <= max(tolerance, SNAP) or spare < 1:
            return corners, excess
        cutting = reach > tolerance  # the others stay inside, as the polytope only shrinks
        worst = np.flatnonzero(cutting & (reach >= excess * _WORTHWHILE))
        worst = worst[np.argsort(-np.rint(reach[worst] / SNAP), kind="stable")]
        _, first = np.unique(corner[worst], return_index=True)
        taken = worst[np.sort(first)[:spare]]
        more = np.concatenate((chosen, waiting[taken]))
        fresh = _corners(more, solid.center)
        if len(fresh) > most_vertices:  # a corner of many edges was cut off
            most_added = spare // 2
        else:
            chosen, corners, cutting[taken] = more, fresh, False
        waiting = waiting[cutting]
        if not len(waiting):
            return corners, 0.0


def _bounding_planes(points: Array) -> Array:
    """Return the planes of the bounding box, shape (6, 4) [m]."""
    planes = np.zeros((6, 4))
    planes[:3, :3], planes[3:, :3] = np.eye(3), -np.eye(3)
    planes[:3, 3], planes[3:, 3] = points.max(axis=0), -points.min(axis=0)
    return planes


def _corners(planes: Array, center: Array) -> Array:
    """Return the corners of the polytope behind planes around an inner point, shape (n, 3) [m]."""
    # a face n.x <= d about the inner point becomes the point n / d; each face of their hull is a corner
    depth = planes[:, 3] - _portable.product(planes[:, :3], center)
    dual = hull_of(planes[:, :3] / depth[:, None]).to_mesh64()
    ends = np.array(dual.vert_properties)[:, :3][triangles_of(dual)]
    first, second = ends[:, 1] - ends[:, 0], ends[:, 2] - ends[:, 0]
    poles = cross(first, second)
    longest = np.maximum(np.einsum("ij,ij->i", first, first), np.einsum("ij,ij->i", second, second))
    sound = np.einsum("ij,ij->i", poles, poles) > (_FLAT * longest) ** 2  # of equal corners one remains
    corners = poles[sound] / np.einsum("ij,ij->i", poles[sound], ends[sound, 0])[:, None]
    near = np.rint(corners * _APART)
    order = np.lexsort(near.T)
    fresh = np.ones(len(order), dtype=bool)
    fresh[1:] = (near[order[1:]] != near[order[:-1]]).any(axis=1)
    around: Array = corners[order[fresh]] + center
    return around


def few_vertices(piece: Convex, most_vertices: int, tolerance: float) -> list[Convex]:
    """Return pieces around a piece, each with at most a number of vertices.

    One piece if it stays within 0.6 mm of the given one, or within 1 mm and adds little volume; else two,
    four or eight pieces, but at most four for a coarse tolerance [m].
    """
    if piece.kind != "hull" or len(piece.points) <= most_vertices:
        return [piece]
    if piece.origin is None:
        return list(_few_vertices(piece, most_vertices, tolerance))
    source, matrix = piece.origin
    return [found.transformed(matrix) for found in _few_vertices(source, most_vertices, tolerance)]


@cached(32)
def _few_vertices(piece: Convex, most_vertices: int, tolerance: float) -> tuple[Convex, ...]:
    """Return pieces around a piece, cached: solids often repeat."""
    halvings = _MOST_HALVINGS - (tolerance > TOLERANCE)
    return tuple(_enclosed(Facets.hull(piece.points), most_vertices, tolerance, halvings))


def _enclosed(solid: Facets, most_vertices: int, tolerance: float, halvings: int) -> list[Convex]:
    """Return polytopes around a solid, halved up to a number of times."""
    if len(solid.points) <= most_vertices:
        return [Convex.hull(solid.points)]
    around, excess = enclosing(solid, most_vertices, tolerance)
    piece = Convex.hull(around)
    if excess <= tolerance or halvings == 0:
        return [piece]
    # halving a smooth solid halves all of these
    times = max(excess / max(_FAR, tolerance), (piece.volume / solid.volume - 1.0) / _ADDED)
    times = min(times, excess / max(_NEAR, tolerance))
    if times <= 1.0:
        return [piece]
    parts = [solid]
    while times > 1.0 and halvings > 0:
        parts = [half for part in parts for half in part.halves()]
        times, halvings = times / 2.0, halvings - 1
    return [made for part in parts for made in _enclosed(part, most_vertices, tolerance, halvings)]
