"""Values of solids and 2-D outlines: a manifold with its paints and the convex pieces that cover it."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from operator import attrgetter
from typing import Any

import numpy as np
from manifold3d import Error, Manifold, OpType

from artgen._arrays import Array, FrozenArrays, Indices, boxes_of, cached_property, frozen
from artgen.asset import manifolds
from artgen.asset.manifolds import PROPERTIES, TURNED_OVER, box_of, mesh_of
from artgen.colliders import Pieces, union
from artgen.colliders.polytope import is_rigid
from artgen.colliders.triangles import cross
from artgen.materials import Material


@dataclass(frozen=True, eq=False)
class Contour(FrozenArrays):
    """A closed polygon with the normals of the curve that it samples."""

    points: Array  # vertices, counter-clockwise for outer borders and clockwise for holes, shape (n, 2) [m]
    normals_in: Array  # outward unit normal at the end of the side that arrives at each vertex, shape (n, 2)
    # outward unit normal at the start of the side that leaves each vertex, shape (n, 2). Equal to
    # `normals_in` where the curve is smooth, different at corners
    normals_out: Array


@dataclass(frozen=True, eq=False)
class Outline(FrozenArrays):
    """A region of the plane: the value of a `Profile`."""

    contours: tuple[Contour, ...]  # outer borders and holes
    # convex polygons (counter-clockwise, each shape (k, 2)) whose union is the region; None if they are not
    # known, and have to be found by a decomposition
    convex: tuple[Array, ...] | None = None

    @cached_property
    def boxes(self) -> tuple[Array, Array]:
        """The lowest and the highest coordinates of each contour, both shape (n, 2) [m]."""
        return boxes_of([contour.points for contour in self.contours])


@dataclass(frozen=True, eq=False)
class Curve(FrozenArrays):
    """A line in space: the value of a `Path`."""

    points: Array  # samples along the line, shape (n, 3) [m]
    closed: bool = False  # whether the last point joins the first (which is not repeated)
    tangents: Array | None = None  # unit tangents at the samples, shape (n, 3); None if they are not known


GRAIN = 1e12  # steps per metre to which coordinates are rounded: machines and versions of NumPy differ beyond
_NEEDLE = 1e-9  # height below which a triangle is degenerate [m]
_DEEP = 64  # nested unions after which the surface is computed at once


@dataclass(frozen=True, eq=False)
class Mesh(FrozenArrays):
    """Triangles with normals, texture coordinates and paint."""

    vertices: Array  # positions, shape (n, 3) [m]
    normals: Array  # unit normals, shape (n, 3)
    uvs: Array  # texture coordinates, shape (n, 2) [m]
    paints: Indices  # paint number of each vertex, 0 for the material of the part, shape (n,)
    triangles: Indices  # vertex indices, counter-clockwise seen from outside, shape (m, 3)

    @staticmethod
    def concatenated(meshes: Sequence["Mesh"]) -> "Mesh":
        """Return meshes as one, their vertices and triangles in the given order."""
        starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
        columns = zip(*((mesh.vertices, mesh.normals, mesh.uvs, mesh.paints) for mesh in meshes), strict=True)
        triangles = [mesh.triangles + start for mesh, start in zip(meshes, starts, strict=True)]
        return Mesh(*(np.concatenate(each) for each in (*columns, triangles)))

    def selected(self, rows: Indices, triangles: Indices) -> "Mesh":
        """Return a mesh of some vertices, with triangles that number them."""
        vertices, normals = self.vertices[rows], self.normals[rows]
        return Mesh(vertices, normals, self.uvs[rows], self.paints[rows], triangles)

    def moved(self, matrix: Array) -> "Mesh":
        """Return the mesh after a rigid motion or a reflection, shape (4, 4); print stays readable."""
        rotation = matrix[:3, :3]
        vertices, normals = self.vertices @ rotation.T + matrix[:3, 3], self.normals @ rotation.T
        if np.linalg.det(rotation) >= 0.0:
            return Mesh(vertices, normals, self.uvs, self.paints, self.triangles)
        return Mesh(vertices, normals, self.uvs * TURNED_OVER, self.paints, self.triangles[:, ::-1])


@dataclass(frozen=True, eq=False)
class Shape:
    """A solid."""

    manifold: Manifold  # the watertight surface, with the channels of `PROPERTIES`
    pieces: Pieces  # convex pieces that cover the solid, derived from its construction
    # materials of painted faces by paint number; faces numbered 0 take the part's material
    paints: Mapping[int, Material] = field(default_factory=dict)
    united: tuple["Shape", ...] = ()  # the shapes that were united to this one; empty for other operations

    @property
    def members(self) -> tuple["Shape", ...]:
        """The shapes that were united to this one; the shape alone if there are none."""
        return self.united or (self,)

    @staticmethod
    def from_mesh(
        vertices: Array,
        normals: Array,
        uvs: Array,
        triangles: Indices,
        pieces: Pieces,
        *,
        targets: Indices | None = None,
        paints: Indices | None = None,
        paint_materials: Mapping[int, Material] | None = None,
    ) -> "Shape":
        """Make a solid of triangles; vertices at one place are joined, whatever their normals.

        Vertices have positions, shape (n, 3) [m], unit normals, texture coordinates, shape (n, 2) [m], and
        paint numbers, shape (n,), all 0 by default. Triangles are counter-clockwise seen from outside, shape
        (m, 3). `targets` has the first vertex at the same point of the surface for each vertex, shape (n,);
        by default vertices at the same position are joined.

        Raises:
            ValueError: The triangles do not close to a solid of positive volume.
        """
        targets = manifolds.coincident(vertices) if targets is None else targets
        rows, faces, points = manifolds.connected(triangles, targets)
        table = np.zeros((len(rows), 3 + PROPERTIES))
        table[:, :3] = vertices[targets[rows]]
        table[:, 3:6] = normals[rows]
        table[:, 6:8] = uvs[rows]
        np.rint(table * GRAIN, out=table)
        table /= GRAIN
        if paints is not None:
            table[:, 8] = paints[rows]
        shape = _MeshShape(
            paint_materials or {}, pieces=pieces, _table=table, _triangles=faces, _targets=points
        )
        if not _has_needles(table[:, :3], faces):
            return shape
        # manifold3d flips the edges of degenerate triangles
        return Shape(shape.manifold, pieces, shape.paints)

    def checked(self) -> "Shape":
        """Compute the manifold and return the shape if it is a solid.

        Raises:
            ValueError: It is empty, not a closed manifold, not finite, or turned inside out.
        """
        status = self.manifold.status()
        if status != Error.NoError:
            raise ValueError(f"the surface is not a closed manifold ({status.name})")
        if self.manifold.is_empty():
            raise ValueError("the result is empty")
        _check_volume(self.manifold.volume())
        return self

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        return box_of(self.manifold)

    @cached_property
    def mesh(self) -> Mesh:
        """The triangles of the surface, in an order that does not depend on caches."""
        raw = self.manifold.to_mesh64()
        triangles = np.asarray(raw.tri_verts).astype(np.int64)
        return _mesh(manifolds.mended(np.asarray(raw.vert_properties), triangles), triangles)

    @property
    def vertices(self) -> Array:
        """The vertices of the surface, shape (n, 3) [m]."""
        return mesh_of(self.manifold)[0]

    @property
    def faces(self) -> Indices:
        """The triangles, with the same vertex for all corners at one point of the surface, shape (m, 3)."""
        raw = self.manifold.to_mesh64()
        points = np.arange(len(raw.vert_properties))
        points[np.array(raw.merge_from_vert, np.int64)] = raw.merge_to_vert
        return points[np.asarray(raw.tri_verts).astype(np.int64)]

    def transformed(self, matrix: Array) -> "Shape":
        """Return the shape moved by an affine matrix, shape (4, 4)."""
        if is_rigid(matrix[:3, :3]) and np.isfinite(matrix[:3, 3]).all():
            return MovedShape(self, matrix)
        moved = manifolds.moved_manifold(self.manifold, matrix)
        return Shape(moved, self.pieces.transformed(matrix), self.paints).checked()


class _LazyShape(Shape):
    """A shape that is a solid by construction; its manifold is computed on first access."""

    def __init__(self, paints: Mapping[int, Material], united: tuple[Shape, ...] = (), **values: Any) -> None:
        vars(self).update(paints=paints, united=united, **values)
        frozen(vars(self))

    def checked(self) -> Shape:
        return self


class DeferredShape(_LazyShape):
    """A shape that is a solid by construction; its surface is made on first access."""

    _make: Callable[[], Shape]

    def __init__(self, make: Callable[[], Shape], pieces: Pieces) -> None:
        super().__init__({}, pieces=pieces, _make=make)

    @cached_property
    def made(self) -> Shape:
        """The shape with its surface."""
        return self._make()

    manifold = property(attrgetter("made.manifold"))
    vertices = property(attrgetter("made.vertices"))
    mesh = property(attrgetter("made.mesh"))
    faces = property(attrgetter("made.faces"))

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        return self.made.bounds()


class LateShape(DeferredShape):
    """A shape that is made as a whole on first access."""

    def __init__(self, make: Callable[[], Shape]) -> None:
        vars(self).update(_make=make)

    pieces = property(attrgetter("made.pieces"))
    paints = property(attrgetter("made.paints"))
    united = property(attrgetter("made.united"))


class MovedShape(_LazyShape):
    """A shape after a rigid motion or a reflection."""

    source: Shape  # the shape before
    matrix: Array  # the motion, shape (4, 4)

    def __init__(self, source: Shape, matrix: Array) -> None:
        if isinstance(source, MovedShape):
            matrix, source = matrix @ source.matrix, source.source
        vars(self).update(source=source, matrix=matrix)
        frozen(vars(self))

    paints = cached_property(attrgetter("source.paints"))
    faces = property(attrgetter("source.faces"))

    @cached_property
    def pieces(self) -> Pieces:
        """The convex pieces of the source, moved."""
        return self.source.pieces.transformed(self.matrix)

    @cached_property
    def manifold(self) -> Manifold:
        """The watertight surface, with the channels of `PROPERTIES`."""
        return manifolds.moved_manifold(self.source.manifold, self.matrix)

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        linear = self.matrix[:3, :3]
        if np.count_nonzero(linear) == 3:  # boxes stay boxes under quarter turns
            corners = self.source.bounds() @ linear.T + self.matrix[:3, 3]
        else:
            corners = self.vertices
        return np.array([corners.min(axis=0), corners.max(axis=0)])

    @property
    def vertices(self) -> Array:
        """The vertices of the source, moved, shape (n, 3) [m]."""
        return self.source.vertices @ self.matrix[:3, :3].T + self.matrix[:3, 3]

    @property
    def members(self) -> tuple[Shape, ...]:
        """The shapes whose union it is, those of the source moved."""
        return tuple(MovedShape(member, self.matrix) for member in self.source.members)

    @cached_property
    def mesh(self) -> Mesh:
        """The triangles of the source, moved."""
        return self.source.mesh.moved(self.matrix)


class _MeshShape(_LazyShape):
    """A solid made of a closed triangle mesh."""

    _table: Array  # x y z and the channels of `PROPERTIES` of each vertex, shape (n, 3 + PROPERTIES)
    _triangles: Indices
    _targets: Indices  # for each vertex, the first one at the same point of the surface, shape (n,)

    @cached_property
    def manifold(self) -> Manifold:
        merged = np.flatnonzero(self._targets != np.arange(len(self._targets)))
        shape = Shape(
            manifolds.manifold_of(self._table, self._triangles, merged, self._targets[merged]), self.pieces
        )
        return shape.checked().manifold

    def bounds(self) -> Array:
        return self._bounds

    @cached_property
    def _bounds(self) -> Array:
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @property
    def vertices(self) -> Array:
        return self._table[:, :3]

    @cached_property
    def mesh(self) -> Mesh:
        return _mesh(self._table, self._triangles)

    @property
    def faces(self) -> Indices:
        return self._targets[self._triangles]


class ComposedShape(_LazyShape):
    """Disjoint solids as one shape."""

    shapes: tuple[Shape, ...]  # the solids; they share the paint numbers

    def __init__(self, shapes: Sequence[Shape]) -> None:
        paints = {number: paint for shape in shapes for number, paint in shape.paints.items()}
        united = tuple(member for shape in shapes for member in shape.members)
        super().__init__(paints, united, shapes=tuple(shapes))

    @cached_property
    def pieces(self) -> Pieces:
        """The convex pieces of all solids."""
        return union(*(shape.pieces for shape in self.shapes))

    @cached_property
    def manifold(self) -> Manifold:
        """The watertight surface, with the channels of `PROPERTIES`."""
        return Manifold.compose([shape.manifold for shape in self.shapes])

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        corners = np.concatenate([shape.bounds() for shape in self.shapes])
        return np.array([corners.min(axis=0), corners.max(axis=0)])

    @property
    def vertices(self) -> Array:
        """The vertices of all solids, shape (n, 3) [m]."""
        return np.concatenate([shape.vertices for shape in self.shapes])

    @cached_property
    def mesh(self) -> Mesh:
        """The triangles of all solids, in their order."""
        return Mesh.concatenated([shape.mesh for shape in self.shapes])

    @property
    def faces(self) -> Indices:
        """The triangles of all solids."""
        return joined_faces(self.shapes)


class UnitedShape(_LazyShape):
    """The union of solids, which is a solid; many unions are never looked at, as their parts collide."""

    shapes: tuple[Shape, ...]
    depth: int  # number of nested unions

    def __init__(self, shapes: Sequence[Shape], pieces: Pieces, paints: Mapping[int, Material]) -> None:
        members = tuple(member for shape in shapes for member in shape.members)
        depth = 1 + max((each.depth for each in shapes if isinstance(each, UnitedShape)), default=0)
        super().__init__(paints, members, shapes=tuple(shapes), pieces=pieces, depth=depth)
        if depth % _DEEP == 0:  # so that a chain of unions is not computed by one nested call for each
            _ = self.manifold, self._bounds

    @cached_property
    def manifold(self) -> Manifold:
        """The watertight surface, with the channels of `PROPERTIES`."""
        solids = [shape.manifold for shape in self.shapes]
        whole = solids[0] + solids[1] if len(solids) == 2 else Manifold.batch_boolean(solids, OpType.Add)
        # checked at once: manifold3d would join nested unions, with other triangles
        return Shape(whole, self.pieces).checked().manifold

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        return self._bounds

    @cached_property
    def _bounds(self) -> Array:
        corners = np.concatenate([shape.bounds() for shape in self.shapes])
        return np.array([corners.min(axis=0), corners.max(axis=0)])


def joined_faces(shapes: Sequence[Shape]) -> Indices:
    """Return the faces of several shapes, which number the vertices of all, shape (m, 3)."""
    starts = np.cumsum([0, *(len(shape.vertices) for shape in shapes[:-1])])
    return np.concatenate([shape.faces + start for shape, start in zip(shapes, starts, strict=True)])


def _mesh(table: Array, triangles: Indices) -> Mesh:
    """Return the mesh of vertices with the channels of `PROPERTIES`, shape (n, 3 + PROPERTIES)."""
    normals = table[:, 3:6]
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return Mesh(
        np.ascontiguousarray(table[:, :3]),
        normals / np.where(length > 0.0, length, 1.0),
        np.ascontiguousarray(table[:, 6:8]),
        np.rint(table[:, 8]).astype(np.int64),
        triangles,
    )


def _check_volume(volume: float) -> None:
    """Raise ValueError for a volume that is not finite or not positive [m^3]."""
    if not np.isfinite(volume):
        raise ValueError("the surface has coordinates that are not finite")
    if volume <= 0.0:
        raise ValueError(f"the volume is {volume:.3g} m^3; a solid must have a positive one")


def _has_needles(points: Array, triangles: Indices) -> bool:
    """Tell whether any triangle is degenerate: without height."""
    near = points - points[0]
    a, b, c = near.take(triangles.T, axis=0)
    across = cross(b - a, c - a)
    _check_volume(float(np.einsum("ij,ij", a, across)) / 6.0)
    area = np.einsum("ij,ij->i", across, across)
    if area.min() > _NEEDLE**2 * 12.0 * np.abs(near).max() ** 2:  # no side is longer than that
        return False
    sides = [np.einsum("ij,ij->i", each, each) for each in (b - a, c - a, c - b)]
    return bool((area <= _NEEDLE**2 * np.maximum.reduce(sides)).any())
