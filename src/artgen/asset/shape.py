"""The value of a solid: a watertight manifold, the paint of its faces and its convex pieces, in step."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from manifold3d import Error, Manifold, Mesh64
from numpy.typing import ArrayLike, NDArray

from artgen.colliders import Pieces
from artgen.materials import Material

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

PROPERTIES = 6
"""Vertex property channels of every manifold: nx ny nz u v paint."""

_COINCIDENT = 1e-9  # [m]: vertices closer than this are one point of the surface
_GRAIN = 1e12  # steps per metre: hides the last digit, in which the sines of different machines differ
_RIGID = 1e-12  # what a rotation may miss orthogonality by
_TURNED_OVER = np.array([-1.0, 1.0])  # turns texture coordinates, so that a reflection mirrors no map
_HAS_NORMALS = 2  # bit of a mesh run: the first three channels are normals, to be turned with the solid


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with normals, texture coordinates and paint.

    Attributes:
        vertices: Positions, shape (n, 3) [m].
        normals: Unit normals, shape (n, 3).
        uvs: Texture coordinates, shape (n, 2) [m].
        paints: Paint number of each vertex, 0 for the material of the part, shape (n,).
        triangles: Vertex indices, counter-clockwise seen from outside, shape (m, 3).
    """

    vertices: Array
    normals: Array
    uvs: Array
    paints: Indices
    triangles: Indices

    def moved(self, matrix: Array) -> "Mesh":
        """Return the mesh after a rigid motion or a reflection, shape (4, 4); print stays readable."""
        rotation = matrix[:3, :3]
        reflected = np.linalg.det(rotation) < 0.0
        return Mesh(
            self.vertices @ rotation.T + matrix[:3, 3],
            self.normals @ rotation.T,
            self.uvs * _TURNED_OVER if reflected else self.uvs,
            self.paints,
            self.triangles[:, ::-1] if reflected else self.triangles,
        )


@dataclass(frozen=True, eq=False)
class Shape:
    """A solid.

    Attributes:
        manifold: The watertight surface, with the channels of `PROPERTIES`.
        pieces: Convex pieces that cover the solid, found from how it was made.
        paints: The materials of painted faces by paint number; faces numbered 0 take the part's material.
        united: The shapes whose union it is, where it was made as one.
    """

    manifold: Manifold
    pieces: Pieces
    paints: Mapping[int, Material] = field(default_factory=dict)
    united: tuple["Shape", ...] = ()

    @property
    def members(self) -> tuple["Shape", ...]:
        """The shapes whose union it is; itself alone if it was made otherwise."""
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

        Args:
            vertices: Positions, shape (n, 3) [m].
            normals: Unit normals, shape (n, 3).
            uvs: Texture coordinates, shape (n, 2) [m].
            triangles: Vertex indices, counter-clockwise seen from outside, shape (m, 3).
            pieces: Convex pieces that cover the solid.
            targets: For each vertex, the first vertex at the same point of the surface, shape (n,); found
                by position when the maker does not know.
            paints: Paint number of each vertex, shape (n,); all 0 by default.
            paint_materials: Material of each paint number.

        Raises:
            ValueError: The triangles do not close to a solid of positive volume.
        """
        target = _coincident(vertices) if targets is None else targets
        faces = target[triangles]
        proper = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
        duplicate = np.flatnonzero(target != np.arange(len(vertices)))
        properties = np.zeros((len(vertices), 3 + PROPERTIES))
        properties[:, :3] = vertices[target]
        properties[:, 3:6] = normals
        properties[:, 6:8] = uvs
        np.rint(properties * _GRAIN, out=properties)
        properties /= _GRAIN
        if paints is not None:
            properties[:, 8] = paints
        manifold = manifold_of(properties, triangles[proper], duplicate, target[duplicate])
        return Shape(manifold, pieces, paint_materials or {}).checked()

    def checked(self) -> "Shape":
        """Force the manifold and return the shape if it is a solid.

        Raises:
            ValueError: It is empty, not a closed manifold, not finite, or turned inside out.
        """
        status = self.manifold.status()
        if status != Error.NoError:
            raise ValueError(f"the surface is not a closed manifold ({status.name})")
        if self.manifold.is_empty():
            raise ValueError("the result is empty")
        volume = self.manifold.volume()
        if not np.isfinite(volume):
            raise ValueError("the surface has coordinates that are not finite")
        if volume <= 0.0:
            raise ValueError(f"the volume is {volume:.3g} m^3; a solid must have a positive one")
        return self

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        return np.array(self.manifold.bounding_box(), float).reshape(2, 3)

    @cached_property
    def mesh(self) -> Mesh:
        """The triangles of the surface, in one order for one shape however it was cached."""
        raw = self.manifold.to_mesh64()
        properties = np.asarray(raw.vert_properties)
        triangles = np.asarray(raw.tri_verts).astype(np.int64)
        normals = properties[:, 3:6]
        length = np.linalg.norm(normals, axis=1, keepdims=True)
        return Mesh(
            np.ascontiguousarray(properties[:, :3]),
            normals / np.where(length > 0.0, length, 1.0),
            np.ascontiguousarray(properties[:, 6:8]),
            np.rint(properties[:, 8]).astype(np.int64),
            triangles,
        )

    @cached_property
    def parts(self) -> tuple[Array, ...]:
        """The vertices of each connected part of the surface, shape (n, 3) [m]."""
        return tuple(
            np.asarray(part.to_mesh64().vert_properties)[:, :3] for part in self.manifold.decompose()
        )

    def transformed(self, matrix: Array) -> "Shape":
        """Return the shape moved by an affine matrix, shape (4, 4)."""
        linear = matrix[:3, :3]
        if np.abs(linear @ linear.T - np.eye(3)).max() < _RIGID:
            return MovedShape(self, matrix)
        return Shape(_moved(self.manifold, matrix), self.pieces.transformed(matrix), self.paints).checked()


class MovedShape(Shape):
    """A shape after a rigid motion or a reflection; its manifold is moved when it is asked for.

    Attributes:
        source: The shape before.
        matrix: The motion, shape (4, 4).
    """

    source: Shape
    matrix: Array

    def __init__(self, source: Shape, matrix: Array) -> None:
        if isinstance(source, MovedShape):
            matrix = matrix @ source.matrix
            source = source.source
        if not np.isfinite(matrix).all():
            raise ValueError("the motion has numbers that are not finite")
        vars(self).update(
            source=source,
            matrix=matrix,
            pieces=source.pieces.transformed(matrix),
            paints=source.paints,
            united=(),
        )

    @cached_property
    def manifold(self) -> Manifold:
        """The watertight surface, with the channels of `PROPERTIES`."""
        return _moved(self.source.manifold, self.matrix)

    def checked(self) -> "Shape":
        """Return the shape: a solid stays one when it is moved."""
        return self

    def bounds(self) -> Array:
        """Return the corners of the bounding box, shape (2, 3) [m]."""
        linear = self.matrix[:3, :3]
        if np.count_nonzero(linear) == 3:  # boxes stay boxes under quarter turns
            corners = self.source.bounds() @ linear.T + self.matrix[:3, 3]
        else:
            corners = self.mesh.vertices
        return np.array([corners.min(axis=0), corners.max(axis=0)])

    @property
    def members(self) -> tuple[Shape, ...]:
        """The shapes whose union it is, those of the source moved."""
        return tuple(MovedShape(member, self.matrix) for member in self.source.members)

    @cached_property
    def mesh(self) -> Mesh:
        """The triangles of the source, moved."""
        return self.source.mesh.moved(self.matrix)

    @cached_property
    def parts(self) -> tuple[Array, ...]:
        """The vertices of each connected part of the source, moved."""
        rotation, offset = self.matrix[:3, :3], self.matrix[:3, 3]
        return tuple(points @ rotation.T + offset for points in self.source.parts)


def _moved(manifold: Manifold, matrix: Array) -> Manifold:
    if np.linalg.det(matrix[:3, :3]) < 0.0:
        return _reflected(manifold, matrix)
    return manifold.transform(np.ascontiguousarray(matrix[:3]))


def _reflected(manifold: Manifold, matrix: Array) -> Manifold:
    """Return a manifold moved by a matrix that turns it over, shape (4, 4).

    Manifold's own transform turns the triangles but leaves their corners' normals in the old order.
    """
    raw = manifold.to_mesh64()
    properties = np.array(raw.vert_properties)
    properties[:, :3] = properties[:, :3] @ matrix[:3, :3].T + matrix[:3, 3]
    normals = properties[:, 3:6] @ np.linalg.inv(matrix[:3, :3])
    properties[:, 3:6] = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    properties[:, 6:8] *= _TURNED_OVER
    return manifold_of(properties, raw.tri_verts[:, ::-1], raw.merge_from_vert, raw.merge_to_vert)


def manifold_of(table: Array, triangles: ArrayLike, merged: ArrayLike, target: ArrayLike) -> Manifold:
    """Make a manifold, whose status is not checked, of vertices with the channels of `PROPERTIES`.

    Args:
        table: x y z and the channels of each vertex, shape (n, 3 + PROPERTIES).
        triangles: Vertex indices, shape (m, 3).
        merged: Vertices that lie where another one does, shape (k,).
        target: The other one of each of them, shape (k,).
    """
    corners = np.array(triangles, np.uint64, order="C").reshape(-1, 3)
    return Manifold(
        Mesh64(
            table,
            corners,
            np.array(merged, np.uint64),
            np.array(target, np.uint64),
            run_index=np.array([0, corners.size], np.uint64),
            run_original_id=np.array([Manifold.reserve_ids(1)], np.uint32),
            run_flags=np.array([_HAS_NORMALS], np.uint8),
        )
    )


def _coincident(vertices: Array) -> Indices:
    """Return for each vertex the first vertex at its place."""
    quantised = np.rint(vertices / _COINCIDENT).astype(np.int64)
    _, first, group = np.unique(quantised, axis=0, return_index=True, return_inverse=True)
    return first[group.ravel()]
