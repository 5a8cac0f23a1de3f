"""Convex polytopes with faces; plane cuts need no new hull.

A polytope keeps its vertices, its face planes and the faces of each vertex. Two vertices with two common
faces are the ends of an edge, so a cut needs no search for topology: new vertices lie on the crossing edges
and inherit the faces of their edge. Face planes are inherited and never fitted again, so a long sequence of
cuts does not drift.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Indices, Mask, cached_property, successors
from artgen.colliders.triangles import cross, hull_of, triangles_of

SNAP = 1e-9
"""A vertex nearer to a cutting plane than this lies on it [m]."""

SLIVER = 1e-6
"""Pieces thinner than this are dropped [m]."""

_COPLANAR = 1e-8  # hull points nearer to a face than this lie on it [m]

_MOST_EDGES = 100  # edges that a plane cuts before they are examined
_RIGID = 1e-12  # tolerance of lengths in a rigid motion
_BOX_SIGNS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_BOX_NORMALS = np.array(
    [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64
)
_BOX_CONTACT = _BOX_SIGNS @ _BOX_NORMALS.T == 0.5


@dataclass(frozen=True, eq=False)
class Polytope(FrozenArrays):
    """A convex solid bounded by planes.

    Attributes:
        points: Vertices, shape (n, 3) [m].
        planes: Faces as (nx, ny, nz, d) with unit outward normals, inside is `n.x <= d`, shape (k, 4).
        contact: Whether vertex i lies on face j, shape (n, k).
    """

    points: Array
    planes: Array
    contact: Mask

    @classmethod
    def box(cls, lower: Array, upper: Array) -> Self:
        """Make an axis-aligned box from its corners, each shape (3,) [m]."""
        center, size = (lower + upper) / 2.0, upper - lower
        planes = np.empty((6, 4))
        planes[:, :3] = _BOX_NORMALS
        planes[0::2, 3] = upper
        planes[1::2, 3] = -lower
        return cls(center + _BOX_SIGNS * size, planes, _BOX_CONTACT)

    @classmethod
    def prism(cls, polygon: Array, bottom: float, top: float) -> Self:
        """Make a prism along z of a strictly convex counter-clockwise polygon, shape (k, 2) [m]."""
        count = len(polygon)
        points = np.empty((2 * count, 3))
        points[:count, :2] = points[count:, :2] = polygon
        points[:count, 2] = bottom
        points[count:, 2] = top
        side = successors(polygon) - polygon
        planes = np.zeros((count + 2, 4))
        planes[:count, 0] = side[:, 1]
        planes[:count, 1] = -side[:, 0]
        planes[:count] /= np.hypot(side[:, 0], side[:, 1])[:, None]
        planes[:count, 3] = np.sum(planes[:count, :2] * polygon, axis=1)
        planes[count] = (0.0, 0.0, -1.0, -bottom)
        planes[count + 1] = (0.0, 0.0, 1.0, top)
        corner = np.eye(count, dtype=bool) | np.eye(count, k=-1, dtype=bool)
        corner[0, -1] = True
        contact = np.zeros((2 * count, count + 2), dtype=bool)
        contact[:count, :count] = contact[count:, :count] = corner
        contact[:count, count] = contact[count:, count + 1] = True
        return cls(points, planes, contact)

    @classmethod
    def hull(cls, points: Array) -> Self:
        """Make the convex hull of points, shape (n, 3) [m], without redundant points.

        Raises:
            ValueError: The points are fewer than four, not finite, or lie in one plane.
        """
        return cls.of_triangles(*hull_triangles(points))

    @classmethod
    def of_triangles(cls, vertices: Array, triangles: Indices, center: Array) -> Self:
        """Make the polytope of a result of `hull_triangles`.

        Raises:
            ValueError: The vertices lie in one plane.
        """
        planes, contact = _faces(vertices, triangles)
        while True:
            corner = np.add.reduce(contact, axis=1, dtype=np.int64) >= 3
            face = np.add.reduce(contact[corner], axis=0, dtype=np.int64) >= 3
            if corner.all() and face.all():
                break
            contact = contact[corner][:, face]
            vertices, planes = vertices[corner], planes[face]
        if len(vertices) < 4 or len(planes) < 4:
            raise ValueError(f"the {len(vertices)} points lie in one plane to 1e-8 m; a hull needs a volume")
        planes[:, 3] += _portable.product(planes[:, :3], center)
        return cls(vertices + center, planes, contact)

    @cached_property
    def volume(self) -> float:
        """The volume [m^3]."""
        return float(self.manifold().volume())

    @cached_property
    def bounds(self) -> Array:
        """Corners of the bounding box, shape (2, 3) [m]."""
        return np.array((self.points.min(axis=0), self.points.max(axis=0)))

    @cached_property
    def face_means(self) -> Array:
        """Mean of the vertices of each face, shape (k, 3) [m]."""
        on = self.contact.T.astype(np.float64)
        means: Array = _portable.product(on, self.points) / on.sum(axis=1, keepdims=True)
        return means

    @cached_property
    def face_spreads(self) -> Array:
        """Mean square distance of the vertices of each face from their mean, shape (k,) [m^2]."""
        on = self.contact.T.astype(np.float64)
        around = self.points - self.points.mean(axis=0)
        square = _portable.product(on, np.sum(around * around, axis=1)) / on.sum(axis=1)
        mean = self.face_means - self.points.mean(axis=0)
        spreads: Array = square - np.sum(mean * mean, axis=1)
        return spreads

    @cached_property
    def width(self) -> float:
        """The least thickness perpendicular to a face [m]."""
        reach = _portable.product(self.planes[:, :3], self.points.T)
        return float((self.planes[:, 3] - reach.min(axis=1)).min())

    @cached_property
    def _shares(self) -> NDArray[np.float32]:
        """The contacts as numbers: products count the common faces of two vertices."""
        return self.contact.astype(np.float32)

    def manifold(self) -> Manifold:
        """Return the solid as a manifold."""
        return hull_of(self.points)

    def heights(self, planes: Array) -> Array:
        """Return the height of each vertex above each plane, shape (k, n) [m]."""
        distances: Array = _portable.product(planes[:, :3], self.points.T) - planes[:, 3:]
        return distances

    def spans(self, columns: Array) -> tuple[Array, Array]:
        """Return the lowest and highest point on vertical lines, shape (n, 2) [m]; inf and -inf beside it."""
        slope, rest = self.planes[:, 2], self.planes[:, 3] - columns @ self.planes[:, :2].T
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = rest / slope
        top = np.where(slope > 1e-9, ends, np.inf).min(axis=1)
        bottom = np.where(slope < -1e-9, ends, -np.inf).max(axis=1)
        missed = (top <= bottom) | ((abs(slope) <= 1e-9) & (rest < 0.0)).any(axis=1)
        return np.where(missed, np.inf, bottom), np.where(missed, -np.inf, top)

    def transformed(self, matrix: Array) -> "Polytope":
        """Return the polytope moved by an invertible affine matrix, shape (4, 4)."""
        linear, shift = matrix[:3, :3], matrix[:3, 3]
        planes = np.empty_like(self.planes)
        if is_rigid(linear):
            planes[:, :3] = self.planes[:, :3] @ linear.T
            planes[:, 3] = self.planes[:, 3] + _portable.product(planes[:, :3], shift)
            return Polytope(self.points @ linear.T + shift, planes, self.contact)
        normals = self.planes[:, :3] @ _portable.inverse(linear)
        length = np.sqrt(np.sum(normals * normals, axis=1))
        planes[:, :3] = normals / length[:, None]
        planes[:, 3] = self.planes[:, 3] / length + _portable.product(planes[:, :3], shift)
        return Polytope(self.points @ linear.T + shift, planes, self.contact)

    def split(self, plane: Array) -> tuple["Polytope | None", "Polytope | None"]:
        """Return the parts behind and in front of a plane (nx, ny, nz, d); None for a part without volume."""
        height = _portable.product(self.points, plane[:3]) - plane[3]
        if height.max() <= SNAP:
            return self, None
        if height.min() >= -SNAP:
            return None, self
        below, above = np.flatnonzero(height < -SNAP), np.flatnonzero(height > SNAP)
        on = np.abs(height) <= SNAP
        shares = self._shares
        lower, upper = np.nonzero(shares[below] @ shares[above].T > 1.5)
        lower, upper = below[lower], above[upper]
        share = height[lower] / (height[lower] - height[upper])
        start = self.points[lower]
        fresh = start + share[:, None] * (self.points[upper] - start)
        fresh_contact = self.contact[lower] & self.contact[upper]
        if len(fresh) > _MOST_EDGES:
            kept = _ends(fresh, fresh_contact)
            fresh, fresh_contact = fresh[kept], fresh_contact[kept]
        return (
            self._part(height <= SNAP, on, fresh, fresh_contact, plane),
            self._part(height >= -SNAP, on, fresh, fresh_contact, -plane),
        )

    def _part(self, kept: Mask, on: Mask, fresh: Array, fresh_contact: Mask, plane: Array) -> "Polytope":
        """Assemble one side of a cut from the remaining and the new vertices."""
        old = self.contact[kept]
        count = len(old)
        contact = np.ones((count + len(fresh), len(self.planes) + 1), dtype=bool)
        contact[:count, :-1] = old
        contact[count:, :-1] = fresh_contact
        contact[:count, -1] = on[kept]
        face = np.add.reduce(contact, axis=0, dtype=np.int64) >= 3
        face[-1] = True
        planes = np.concatenate((self.planes, plane[None]))
        return Polytope(np.concatenate((self.points[kept], fresh)), planes[face], contact[:, face])

    def clipped(self, planes: Array) -> "Polytope | None":
        """Return the part behind all planes, shape (k, 4), or None if it is thinner than a sliver."""
        part = self
        for plane in planes[(self.heights(planes) > SNAP).any(axis=1)]:
            inside = part.split(plane)[0]
            if inside is None:
                return None
            part = inside
        return part if part is self or part.width >= SLIVER else None

    def inflated(self, margin: float) -> "Polytope":
        """Return a polytope that contains all points within about `margin` [m] of this one.

        Each face moves outward by the margin; a plane at each vertex and at each sharp edge prevents spikes.
        """
        touching = self.contact.astype(np.float64)
        normals = self.planes[:, :3]
        sharp = (touching.T @ touching > 1.5) & (_portable.product(normals, normals.T) < 0.0)
        first, second = np.nonzero(np.triu(sharp))
        mean = np.concatenate((_portable.product(touching, normals), normals[first] + normals[second]))
        length = np.sqrt(np.sum(mean * mean, axis=1))
        mean = mean[length > _COPLANAR] / length[length > _COPLANAR, None]
        reach = _portable.product(mean, self.points.T).max(axis=1)
        planes = np.concatenate((self.planes, np.column_stack((mean, reach))))
        planes[:, 3] += margin
        lower, upper = self.bounds
        around = Polytope.box(lower - margin, upper + margin)
        return around.clipped(planes) or around

    def contains(self, points: Array, margin: float = 0.0) -> bool:
        """Tell whether all points, shape (n, 3), are inside or at most `margin` [m] outside the faces."""
        return bool((_portable.product(self.planes[:, :3], points.T) - self.planes[:, 3:]).max() <= margin)


def hull_triangles(points: Array) -> tuple[Array, Indices, Array]:
    """Return the convex hull of points, shape (n, 3) [m], as a mesh.

    Returns:
        Vertices relative to the center of the bounding box, shape (k, 3) [m]; vertex indices of the
        triangles, shape (m, 3); the center, shape (3,) [m].

    Raises:
        ValueError: The points are fewer than four, not finite, or lie in one plane.
    """
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 4:
        raise ValueError(f"a hull needs at least 4 points of shape (n, 3), got shape {points.shape}")
    if not np.isfinite(points).all():
        raise ValueError("a hull needs finite points, got NaN or infinity")
    center = (points.min(axis=0) + points.max(axis=0)) / 2.0
    solid = hull_of(points - center)
    if solid.is_empty():
        raise ValueError(f"the {len(points)} points lie in one plane; a hull needs a volume")
    mesh = solid.to_mesh64()
    return np.array(mesh.vert_properties)[:, :3], triangles_of(mesh), center


def _ends(points: Array, contact: Mask) -> Indices:
    """Return the ends of the lines on which points with the same faces lie."""
    # on two faces in almost one plane, each two vertices seem to share an edge, and cuts would multiply them
    _, line = np.unique(np.packbits(contact, axis=1), axis=0, return_inverse=True)
    kept: list[int] = []
    for members in (np.flatnonzero(line == number) for number in range(int(line.max()) + 1)):
        along = points[members, np.ptp(points[members], axis=0).argmax()]
        kept += {int(members[along.argmin()]), int(members[along.argmax()])}
    return np.sort(np.array(kept))


def is_rigid(linear: Array) -> bool:
    """Tell whether a linear map, shape (3, 3), is a rotation or a reflection."""
    (a, b, c), (d, e, f), (g, h, i) = linear.tolist()  # numpy takes five times as long
    rigid: bool = (  # also False for NaN
        abs(a * a + d * d + g * g - 1.0) <= _RIGID
        and abs(b * b + e * e + h * h - 1.0) <= _RIGID
        and abs(c * c + f * f + i * i - 1.0) <= _RIGID
        and abs(a * b + d * e + g * h) <= _RIGID
        and abs(a * c + d * f + g * i) <= _RIGID
        and abs(b * c + e * f + h * i) <= _RIGID
    )
    return rigid


def _faces(vertices: Array, triangles: Indices) -> tuple[Array, Mask]:
    """Join coplanar triangles of a hull to faces: their planes and vertex contacts."""
    corners = vertices[triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = cross(first, second)
    area = np.einsum("ij,ij->i", normals, normals)
    longest = np.maximum(np.einsum("ij,ij->i", first, first), np.einsum("ij,ij->i", second, second))
    order = np.argsort(-area, kind="stable")
    order = order[area[order] > _COPLANAR**2 * longest[order]]  # degenerate triangles have no valid normal
    normals = normals[order] / np.sqrt(area[order])[:, None]
    reach = _portable.product(normals, vertices.T)
    offset = reach.max(axis=1)
    touching = reach >= offset[:, None] - _COPLANAR
    # one row per face: the plane of the largest triangle, with all vertices of the face
    fresh: dict[bytes, int] = {}
    for row, packed in enumerate(np.packbits(touching, axis=1)):
        fresh.setdefault(packed.tobytes(), row)
    rows = np.fromiter(fresh.values(), np.int64)
    on = touching[rows].astype(np.float32)
    count = on.sum(axis=1)
    large = count > 3.0
    within = (on @ on[large].T == count[:, None]) & (count[large] > count[:, None])
    rows = rows[~within.any(axis=1)]
    normals, offset, touching = normals[rows], offset[rows], touching[rows]
    return np.column_stack((normals, offset)), touching.T
