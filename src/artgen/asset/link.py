"""Links: rigid bodies made of named pieces of one material each."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from manifold3d import Manifold, OpType
from numpy.typing import NDArray

from artgen.asset.mass import MassProperties, Moments, polyhedron_moments, total
from artgen.asset.shape import Mesh, Shape
from artgen.colliders import Convex, budgeted_together
from artgen.errors import AssetError
from artgen.materials import Material

Array = NDArray[np.float64]

MOST_COLLIDERS = 64
"""Convex pieces that one link may carry; the budget of GPU simulators."""


@dataclass(frozen=True, eq=False)
class Grasp:
    """A frame at which a hand takes hold.

    Attributes:
        name: Identifier, unique on the asset.
        frame: Pose in asset coordinates at rest: z along the approach, x along the closing direction of
            a parallel gripper, shape (4, 4) [m].
        width: Opening that the fingers need [m].
    """

    name: str
    frame: Array
    width: float = 0.08

    def moved(self, matrix: Array) -> "Grasp":
        """Return the grasp carried along by a rigid motion or a reflection, shape (4, 4)."""
        frame = matrix @ self.frame
        if np.linalg.det(frame[:3, :3]) < 0.0:
            frame[:3, 1] = -frame[:3, 1]
        return replace(self, frame=frame)


@dataclass(frozen=True, eq=False)
class Piece:
    """A solid of one material with a name of its own.

    Attributes:
        label: Semantic label.
        material: Material of the solid.
        shape: The solid, in asset coordinates at rest.
        visual: Whether the piece is only seen: it has neither mass nor collider.
    """

    label: str
    material: Material
    shape: Shape
    visual: bool = False


@dataclass(frozen=True, eq=False)
class Collider:
    """A convex piece of a link with what a contact needs to know.

    Attributes:
        convex: The piece, in asset coordinates at rest.
        label: Semantic label of the solid that it covers.
        material: Material of that solid.
    """

    convex: Convex
    label: str
    material: Material


@dataclass(frozen=True, eq=False)
class Surface:
    """The visible faces of a link that share a label and a material.

    Attributes:
        name: Identifier, unique on the link.
        label: Semantic label.
        material: Material of the faces.
        mesh: The faces, in asset coordinates at rest.
    """

    name: str
    label: str
    material: Material
    mesh: Mesh


@dataclass(frozen=True, eq=False)
class Link:
    """A rigid body.

    Attributes:
        name: Identifier, unique in the asset.
        label: Semantic label of the link as a whole.
        pieces: Its solids; empty on an asset read from files, which has surfaces and colliders only.
        grasps: Frames at which a hand takes hold of the link.
    """

    name: str
    label: str
    pieces: tuple[Piece, ...] = ()
    grasps: tuple[Grasp, ...] = field(default=())

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """The semantic labels on the link, its own first."""
        return tuple(dict.fromkeys((self.label, *(piece.label for piece in self.pieces))))

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass, centre and inertia of the solids; where welded solids overlap, the first one counts."""
        moments: list[Moments] = []
        done: list[tuple[Manifold, Array]] = []
        for piece in self._solid_pieces():
            manifold, bounds = piece.shape.manifold, piece.shape.bounds()
            near = [other for other, box in done if _overlap(box, bounds)]
            done.append((manifold, bounds))
            if near:
                manifold = manifold - (near[0] if len(near) == 1 else Manifold.batch_boolean(near, OpType.Add))
                if manifold.is_empty():
                    continue
            mesh = manifold.to_mesh64()
            vertices = np.asarray(mesh.vert_properties)[:, :3]
            triangles = np.asarray(mesh.tri_verts).astype(np.int64)
            moments.append(polyhedron_moments(vertices, triangles).scaled(piece.material.density))
        return total(moments)

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """Convex pieces that contain the solids, at most `MOST_COLLIDERS`."""
        pieces = self._solid_pieces()
        if len(pieces) > MOST_COLLIDERS:
            raise AssetError(
                f"link {self.name!r} is made of {len(pieces)} solids; a link may carry at most "
                f"{MOST_COLLIDERS} colliders: join small solids or make them details"
            )
        try:
            found = budgeted_together([piece.shape.pieces for piece in pieces], most_pieces=MOST_COLLIDERS)
        except ValueError as error:
            raise AssetError(f"link {self.name!r}: {error}") from None
        return tuple(
            Collider(convex, piece.label, piece.material)
            for piece, convexes in zip(pieces, found, strict=True)
            for convex in convexes
        )

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The visible faces, one surface for each label and material."""
        groups: dict[tuple[str, Material], list[Mesh]] = {}
        for piece in self.pieces:
            for material, mesh in _by_material(piece):
                groups.setdefault((piece.label, material), []).append(mesh)
        return tuple(
            Surface(f"{label}_{material.name}", label, material, _joined(meshes))
            for (label, material), meshes in groups.items()
        )

    def bounds(self) -> Array:
        """Return the corners of the bounding box at rest, shape (2, 3) [m]."""
        corners = [surface.mesh.vertices for surface in self.surfaces]
        points = np.concatenate(corners)
        return np.array([points.min(axis=0), points.max(axis=0)])

    def moved(self, matrix: Array) -> "Link":
        """Return the link carried along by a rigid motion or a reflection, shape (4, 4)."""
        pieces = tuple(replace(piece, shape=piece.shape.transformed(matrix)) for piece in self.pieces)
        return replace(self, pieces=pieces, grasps=tuple(grasp.moved(matrix) for grasp in self.grasps))

    def renamed(self, suffix: str) -> "Link":
        """Return the link with a suffix on its name and on its grasps' names."""
        grasps = tuple(replace(grasp, name=grasp.name + suffix) for grasp in self.grasps)
        return replace(self, name=self.name + suffix, grasps=grasps)

    def to_data(self) -> dict[str, Any]:
        """Return everything but the triangles as JSON data."""
        return {
            "name": self.name,
            "label": self.label,
            "labels": list(self.labels),
            **self.mass_properties.to_data(),
            "grasps": [
                {"name": grasp.name, "frame": grasp.frame.tolist(), "width": grasp.width}
                for grasp in self.grasps
            ],
            "colliders": [
                {
                    "kind": collider.convex.kind,
                    "pose": collider.convex.pose.tolist(),
                    "size": list(collider.convex.size),
                    "points": collider.convex.points.tolist() if collider.convex.kind == "hull" else [],
                    "label": collider.label,
                    "material": collider.material.name,
                }
                for collider in self.colliders
            ],
            "surfaces": [
                {
                    "name": surface.name,
                    "label": surface.label,
                    "material": surface.material.name,
                    "triangles": len(surface.mesh.triangles),
                }
                for surface in self.surfaces
            ],
        }

    def _solid_pieces(self) -> list[Piece]:
        if not self.pieces:
            raise AssetError(
                f"link {self.name!r} was read from files and has no exact solids; generate the asset again"
            )
        return [piece for piece in self.pieces if not piece.visual]


def _overlap(a: Array, b: Array) -> bool:
    return bool((a[0] < b[1]).all() and (b[0] < a[1]).all())


def _by_material(piece: Piece) -> list[tuple[Material, Mesh]]:
    """Split the faces of a piece by their paint."""
    mesh = piece.shape.mesh
    paint = mesh.paints[mesh.triangles[:, 0]]
    result = []
    for number in np.unique(paint):
        chosen = mesh.triangles[paint == number]
        material = piece.material if number == 0 else piece.shape.paints[int(number)]
        result.append((material, _compacted(mesh, chosen)))
    return result


def _compacted(mesh: Mesh, triangles: NDArray[np.int64]) -> Mesh:
    used, renumbered = np.unique(triangles, return_inverse=True)
    return Mesh(
        mesh.vertices[used],
        mesh.normals[used],
        mesh.uvs[used],
        mesh.paints[used],
        renumbered.reshape(-1, 3),
    )


def _joined(meshes: list[Mesh]) -> Mesh:
    """Concatenate meshes, and put vertices and triangles in an order that only their values decide."""
    offsets = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
    rows = np.concatenate(
        [np.concatenate([mesh.vertices, mesh.normals, mesh.uvs], axis=1) for mesh in meshes]
    )
    triangles = np.concatenate(
        [mesh.triangles + offset for mesh, offset in zip(meshes, offsets, strict=True)]
    )
    quantised = np.rint(rows * 1e7).astype(np.int64)
    order = np.lexsort(quantised.T[::-1])
    ordered = quantised[order]
    new = np.ones(len(order), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    number = np.empty(len(order), np.int64)
    number[order] = np.cumsum(new) - 1
    rows = rows[order[new]]
    corners = number[triangles]
    proper = (
        (corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2]) & (corners[:, 2] != corners[:, 0])
    )
    corners = corners[proper]
    turned = np.argmin(corners, axis=1)[:, None] + np.arange(3)
    corners = np.take_along_axis(corners, turned % 3, axis=1)
    corners = corners[np.lexsort(corners.T[::-1])]
    return Mesh(
        rows[:, :3], rows[:, 3:6], rows[:, 6:8], np.zeros(len(rows), np.int64), corners
    )
