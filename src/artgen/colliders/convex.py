"""One convex piece: a primitive of simulators, or the hull of its points."""

import math
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from manifold3d import Manifold

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, affine, cached, cached_property
from artgen.colliders.polytope import Polytope, hull_triangles, is_rigid

Kind = Literal["box", "cylinder", "sphere", "capsule", "hull"]

TOLERANCE = 0.00025
"""Default distance of facets from a round piece [m]."""

_SQUARE = 1e-9  # relative error of angles and lengths within which a piece keeps its kind
_MANY = 128  # above this number of vertices, faces of a hull are computed on first access
_MOST_SIDES = 64  # most sides of a faceted circle
_MOST_FREQUENCY = 8  # most divisions of an icosahedron's edge
_NO_POINTS = np.empty((0, 3))
_IDENTITY = np.eye(4)
_NO_POINTS.setflags(write=False)
_IDENTITY.setflags(write=False)


@dataclass(frozen=True, eq=False)
class Convex(FrozenArrays):
    """A convex piece of a solid, in asset coordinates.

    Attributes:
        kind: `box`, `cylinder`, `sphere`, `capsule` (round ones along local z) or `hull`.
        pose: Rigid transform from the piece's frame to the asset's, shape (4, 4) [m]; identity for hulls.
        size: box: full lengths (x, y, z); cylinder: (radius, length); sphere: (radius,);
            capsule: (radius, length between the centers of its ends); hull: () [m].
        points: Hull vertices in asset coordinates, shape (n, 3) [m]; empty for the other kinds.
        polytope: Faces of a hull, if they are known.
        origin: The original piece of a moved hull with many vertices, and the motion.
    """

    kind: Kind
    pose: Array
    size: tuple[float, ...] = ()
    points: Array = field(default_factory=lambda: _NO_POINTS)
    polytope: Polytope | None = field(default=None, repr=False)
    origin: tuple["Convex", Array] | None = field(default=None, repr=False)

    @classmethod
    def box(cls, size: tuple[float, float, float] | Array, pose: Array = _IDENTITY) -> "Convex":
        """Make a box of full lengths (x, y, z) [m] centered on its frame."""
        return cls("box", *_checked("box", pose, size, 3))

    @classmethod
    def cylinder(cls, radius: float, length: float, pose: Array = _IDENTITY) -> "Convex":
        """Make a cylinder along z of its frame, centered [m]."""
        return cls("cylinder", *_checked("cylinder", pose, (radius, length), 2))

    @classmethod
    def sphere(cls, radius: float, pose: Array = _IDENTITY) -> "Convex":
        """Make a sphere centered on its frame [m]."""
        return cls("sphere", *_checked("sphere", pose, (radius,), 1))

    @classmethod
    def capsule(cls, radius: float, length: float, pose: Array = _IDENTITY) -> "Convex":
        """Make a capsule along z of its frame; the length [m] is between the centers of its round ends."""
        return cls("capsule", *_checked("capsule", pose, (radius, length), 2))

    @classmethod
    def hull(cls, points: Array) -> "Convex":
        """Make the convex hull of points, shape (n, 3) [m]; a rectangular block becomes a box.

        Raises:
            ValueError: The points are fewer than four, not finite, or lie in one plane.
        """
        vertices, triangles, center = hull_triangles(np.asarray(points, np.float64))
        if len(vertices) > _MANY:
            return cls("hull", _IDENTITY, (), vertices + center)
        return cls.of(Polytope.of_triangles(vertices, triangles, center))

    @classmethod
    def of(cls, polytope: Polytope) -> "Convex":
        """Make the piece of a polytope: a box if possible, else a hull."""
        return _as_box(polytope) or cls("hull", _IDENTITY, (), polytope.points, polytope)

    @cached_property
    def faces(self) -> Polytope:
        """The polytope of a box or hull; for round kinds, the polytope around it at the default tolerance."""
        if self.polytope is not None:
            return self.polytope
        if self.kind == "hull":
            return Polytope.hull(self.points)
        if self.kind == "box":
            half = np.array(self.size) / 2.0
            return Polytope.box(-half, half).transformed(self.pose)
        return self.outer_polytope(TOLERANCE)

    def outer_polytope(self, tolerance: float) -> Polytope:
        """Return a polytope that contains the piece and exceeds it by at most the tolerance [m]."""
        return self._faceted(tolerance, inscribed=False)

    def inner_polytope(self, tolerance: float) -> Polytope:
        """Return a polytope inside the piece, smaller by at most the tolerance [m]."""
        return self._faceted(tolerance, inscribed=True)

    def _faceted(self, tolerance: float, *, inscribed: bool) -> Polytope:
        if self.kind in ("box", "hull"):
            return self.faces
        radius, length = self.size[0], self.size[-1] if len(self.size) > 1 else 0.0
        if self.kind == "cylinder":
            polygon = _circle(radius, _sides(radius, tolerance), inscribed=inscribed)
            return Polytope.prism(polygon, -length / 2.0, length / 2.0).transformed(self.pose)
        return _ball(radius, length, tolerance, inscribed=inscribed).transformed(self.pose)

    def outer_points(self, tolerance: float = TOLERANCE) -> Array:
        """Return vertices of a polytope around the piece that exceeds it by at most the tolerance [m]."""
        return self.outer_polytope(tolerance).points

    def manifold(self, tolerance: float = TOLERANCE) -> Manifold:
        """Return the piece as a manifold; for a round piece, the polytope around it."""
        return self.outer_polytope(tolerance).manifold()

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        return self._bounds

    @cached_property
    def _bounds(self) -> Array:
        if self.kind == "hull":
            return np.array((self.points.min(axis=0), self.points.max(axis=0)))
        turn, center = self.pose[:3, :3], self.pose[:3, 3]
        axis = np.abs(turn[:, 2])
        if self.kind == "box":
            half = np.abs(turn) @ (np.array(self.size) / 2.0)
        elif self.kind == "sphere":
            half = np.full(3, self.size[0])
        elif self.kind == "capsule":
            half = axis * (self.size[1] / 2.0) + self.size[0]
        else:
            rim = np.sqrt(np.maximum(1.0 - axis * axis, 0.0))
            half = axis * (self.size[1] / 2.0) + rim * self.size[0]
        return np.array((center - half, center + half))

    @cached_property
    def volume(self) -> float:
        """The volume [m^3]."""
        if self.kind == "hull":
            return self.faces.volume
        if self.kind == "box":
            return math.prod(self.size)
        disc = math.pi * self.size[0] ** 2
        ball = 4.0 / 3.0 * disc * self.size[0]
        if self.kind == "sphere":
            return ball
        return disc * self.size[1] + (ball if self.kind == "capsule" else 0.0)

    def transformed(self, matrix: Array, tolerance: float = TOLERANCE, *, inner: bool = False) -> "Convex":
        """Return the piece moved by an affine matrix, shape (4, 4).

        A round piece that loses its shape becomes a hull around it (inside it for `inner`), faceted to the
        tolerance [m] before the motion.

        Raises:
            ValueError: The matrix is not finite or flattens the piece.
        """
        linear = matrix[:3, :3]
        if is_rigid(linear) and np.isfinite(matrix[:3, 3]).all():
            return self._carried(matrix)
        determinant = np.linalg.det(linear)
        if not abs(determinant) > 0.0 or not np.isfinite(matrix).all():
            raise ValueError(
                f"a piece cannot be moved by a matrix of determinant {determinant:.3g}: it must be invertible"
            )
        if self.kind == "hull":
            return Convex.of(self.faces.transformed(matrix))
        columns = linear @ self.pose[:3, :3]
        scale = np.sqrt(np.sum(columns * columns, axis=0))
        gram = (columns / scale).T @ (columns / scale)
        square = bool(np.abs(gram - np.eye(3)).max() <= _SQUARE)
        even = abs(scale[0] - scale[1]) <= _SQUARE * scale[0]
        same = even and abs(scale[0] - scale[2]) <= _SQUARE * scale[0]
        if square and (self.kind == "box" or (self.kind == "cylinder" and even) or same):
            pose = affine(columns / scale, linear @ self.pose[:3, 3] + matrix[:3, 3])
            if determinant < 0.0:
                pose[:3, 0] *= -1.0  # all primitives equal their mirror image
            factors = scale if self.kind == "box" else scale[[0, 2]]
            size = tuple(float(s * f) for s, f in zip(self.size, factors, strict=False))
            return Convex(self.kind, pose, size)
        shape = self.inner_polytope(tolerance) if inner else self.outer_polytope(tolerance)
        return Convex.of(shape.transformed(matrix))

    def _carried(self, matrix: Array) -> "Convex":
        """Return the piece after a rigid motion or a reflection."""
        if self.kind == "hull" and self.polytope is not None:
            moved = self.polytope.transformed(matrix)
            return Convex("hull", _IDENTITY, (), moved.points, moved)
        if self.kind == "hull":
            source, before = self.origin or (self, _IDENTITY)
            points = self.points @ matrix[:3, :3].T + matrix[:3, 3]
            return Convex("hull", _IDENTITY, (), points, origin=(source, matrix @ before))
        pose = matrix @ self.pose
        if _mirrors(matrix):
            pose[:3, 0] *= -1.0  # all primitives equal their mirror image
        return Convex(self.kind, pose, self.size)


def _sides(radius: float, tolerance: float) -> int:
    """Return the number of sides, a multiple of 4, of a polygon around a circle within the tolerance [m]."""
    ratio = radius / (radius + max(tolerance, 0.0))
    angle = math.acos(min(ratio, 1.0))
    sides = 4 * math.ceil(math.pi / max(angle, 1e-3) / 4.0 - 1e-9)
    return min(max(sides, 8), _MOST_SIDES)


def _circle(radius: float, sides: int, *, inscribed: bool) -> Array:
    """Return a polygon inside a circle with a vertex at angle 0, or around it, shape (sides, 2) [m]."""
    angle = (np.arange(sides) + (0.0 if inscribed else 0.5)) * (2.0 * np.pi / sides)
    reach = radius if inscribed else radius / math.cos(math.pi / sides)
    return np.column_stack((_portable.cos(angle), _portable.sin(angle))) * reach


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


def _sphere(radius: float, tolerance: float, *, inscribed: bool) -> Array:
    """Return vertices of a polytope around (or inside) a sphere at the origin, shape (n, 3) [m]."""
    # the error is below the tolerance [m], except where this would need more than a thousand faces
    for frequency in range(1, _MOST_FREQUENCY + 1):
        points, nearest = _geodesic(frequency)
        error = radius * ((1.0 - nearest) if inscribed else (1.0 / nearest - 1.0))
        if error <= tolerance:
            break
    return points * (radius if inscribed else radius / nearest)


@cached(64)  # knobs and screws of an asset are often equal
def _ball(radius: float, length: float, tolerance: float, *, inscribed: bool) -> Polytope:
    """Return a polytope around or inside a ball at the origin, extended along z by a length [m]."""
    points = _sphere(radius, tolerance, inscribed=inscribed)
    if length:
        end = np.array([0.0, 0.0, length / 2.0])
        points = np.concatenate((points + end, points - end))
    return Polytope.hull(points)


def _mirrors(matrix: Array) -> bool:
    """Tell whether a motion, shape (4, 4), is a reflection."""
    (a, b, c), (d, e, f), (g, h, i) = matrix[:3, :3].tolist()  # numpy's determinant takes ten times as long
    return bool(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0.0)


def _checked(
    kind: str, pose: Array, size: tuple[float, ...] | Array, count: int
) -> tuple[Array, tuple[float, ...]]:
    """Return checked pose and size of a primitive; raise ValueError for bad ones."""
    lengths = tuple(float(length) for length in size)
    if len(lengths) != count or not all(math.isfinite(length) and length > 0.0 for length in lengths):
        raise ValueError(f"a {kind} needs {count} positive lengths [m], got {lengths}")
    pose = np.asarray(pose, np.float64)
    turn = pose[:3, :3]
    if pose.shape != (4, 4) or not np.isfinite(pose).all() or np.abs(turn.T @ turn - np.eye(3)).max() > 1e-6:
        raise ValueError(f"a {kind} needs a rigid pose of shape (4, 4), got {pose.tolist()}")
    return pose, lengths


def _as_box(polytope: Polytope) -> Convex | None:
    """Return a polytope as a box if it is a rectangular block."""
    if len(polytope.points) != 8 or len(polytope.planes) != 6:
        return None
    normals = polytope.planes[:, :3]
    if (np.abs(normals).max(axis=1) >= 1.0).all():  # along the axes
        lower, upper = polytope.bounds
        pose, length = affine(np.eye(3), (lower + upper) / 2.0), (upper - lower).tolist()
        return Convex("box", pose, (length[0], length[1], length[2]), polytope=polytope)
    cosine = _portable.product(normals, normals.T)
    opposite = np.argmin(cosine, axis=1)
    square = np.abs(np.abs(cosine) - np.rint(np.abs(cosine))).max() <= _SQUARE
    if not square or (np.rint(cosine).sum(axis=1) != 0.0).any():
        return None
    axes = [j for j in range(6) if j < opposite[j]]
    if len(axes) != 3:
        return None
    # choose the frame nearest to the asset's: a box that was never rotated gets the identity
    turn = np.empty((3, 3))
    size = np.empty(3)
    free = list(axes)
    for column in range(3):
        face = max(free, key=lambda j: abs(normals[j, column]))
        free.remove(face)
        turn[:, column] = np.copysign(1.0, normals[face, column]) * normals[face]
        size[column] = polytope.planes[face, 3] + polytope.planes[opposite[face], 3]
    if np.linalg.det(turn) < 0.0:
        turn[:, 2] *= -1.0
    if np.abs(turn - np.eye(3)).max() <= 1e-12:
        turn = np.eye(3)
    lower, upper = polytope.points.min(axis=0), polytope.points.max(axis=0)
    pose = affine(turn, (lower + upper) / 2.0)
    return Convex("box", pose, (float(size[0]), float(size[1]), float(size[2])), polytope=polytope)
