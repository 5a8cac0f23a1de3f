"""Symbols over an asset in the studio: colliders, joints, grasp frames, centers of mass."""

from collections.abc import Callable, Mapping
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.export.frames import quaternion
from artgen.view.overlays import ColliderFaces, Overlays, axis_poses, overlays

Sign = Literal["colliders", "joints", "grasps", "masses"]
SIGNS: tuple[Sign, ...] = get_args(Sign)
"""Kinds of symbols."""

_AXIS, _RANGE, _HAND, _PUSH, _COLLIDER = (
    (213, 94, 0),
    (230, 159, 0),
    (0, 114, 178),
    (204, 121, 167),
    (0, 158, 115),
)
_WIDTH = 3.0  # width of lines on the screen [pixels]
_APART = 0.0007  # distance of colliders outside their solids, as a share of the asset's size
_SMOOTH = 0.985  # cosine of the angle between faces below which their common edge is drawn
_FRAME = 0.04  # length of the axes of a grasp frame, as a share of the asset's size


class Signs:
    """Overlays in the scene of a viser server; each kind is created on first use.

    Attributes:
        kinds: The enabled kinds.
    """

    def __init__(self, server: Any) -> None:
        self._scene = server.scene
        self.kinds: set[Sign] = set()
        self._asset: Asset | None = None
        self._found: Overlays | None = None
        self._nodes: dict[Sign, list[Any]] = {}
        self._hands: dict[str, tuple[Any, Any]] = {}  # frames of the axis and of the hand of each joint

    def clear(self) -> None:
        """Remove everything; the display options stay."""
        for kind in list(self._nodes):
            self._remove(kind)
        self._found = None

    def show(self, asset: Asset, q: Mapping[str, float]) -> None:
        """Draw the enabled kinds over an asset whose links are in the scene."""
        if asset is not self._asset:
            self.clear()
            self._asset = asset
        makers: Mapping[Sign, Callable[[Overlays], list[Any]]] = {
            "colliders": self._colliders,
            "joints": self._joints,
            "grasps": self._grasps,
            "masses": self._masses,
        }
        for kind in SIGNS:
            if kind not in self.kinds:
                self._remove(kind)
            elif kind not in self._nodes:
                self._found = self._found or overlays(asset)
                self._nodes[kind] = makers[kind](self._found)
        self.pose(q)

    def pose(self, q: Mapping[str, float]) -> None:
        """Move the axes of joints to joint positions; other symbols move with the links."""
        if not self._hands or self._asset is None:
            return
        positions, axes = self._asset.positions(q), axis_poses(self._asset, q)
        for name, (axis, hand) in self._hands.items():
            _place(axis, axes[name])
            _place(hand, axes[name] @ self._asset.joint(name).motion(positions[name]))

    def _remove(self, kind: Sign) -> None:
        for node in self._nodes.pop(kind, []):
            node.remove()
        if kind == "joints":
            self._hands.clear()

    def _colliders(self, found: Overlays) -> list[Any]:
        nodes = []
        for name, link in found.links.items():
            if not link.colliders:
                continue
            meshes = [_apart(faces, _APART * found.size) for faces in link.colliders]
            first = np.cumsum([0, *(len(vertices) for vertices, _ in meshes[:-1])])
            nodes.append(
                self._scene.add_mesh_simple(
                    f"/asset/{name}/colliders",
                    np.concatenate([vertices for vertices, _ in meshes]).astype(np.float32),
                    np.concatenate([faces + at for (_, faces), at in zip(meshes, first, strict=True)]).astype(
                        np.uint32
                    ),
                    color=_COLLIDER,
                    opacity=0.25,
                    flat_shading=True,
                    cast_shadow=False,
                    receive_shadow=False,
                )
            )
            edges = np.concatenate([_edges(vertices, faces) for vertices, faces in meshes])
            nodes.append(self._lines(f"/asset/{name}/collider_edges", edges, _COLLIDER, 1.5))
        return nodes

    def _joints(self, found: Overlays) -> list[Any]:
        nodes: list[Any] = []
        for name, joint in found.joints.items():
            axis = self._scene.add_frame(f"/joints/{name}", show_axes=False)
            hand = self._scene.add_frame(f"/hands/{name}", show_axes=False)
            self._hands[name] = (axis, hand)
            ways = np.stack([joint.range[:-1], joint.range[1:]], axis=1)
            nodes += [
                self._lines(f"/joints/{name}/axis", joint.axis[None], _AXIS, _WIDTH),
                self._lines(f"/joints/{name}/range", ways, _RANGE, _WIDTH),
                self._scene.add_label(
                    f"/joints/{name}/name", name, position=joint.axis[1], font_screen_scale=0.9
                ),
                self._lines(f"/hands/{name}/hand", joint.hand[None], _HAND, _WIDTH),
                axis,
                hand,
            ]
        return nodes

    def _grasps(self, found: Overlays) -> list[Any]:
        length = _FRAME * found.size
        return [
            self._scene.add_frame(
                f"/asset/{name}/hold_{hold.name}",
                axes_length=length,
                axes_radius=length / 16.0,
                origin_color=_PUSH if hold.kind == "push" else _HAND,
                wxyz=quaternion(hold.frame),
                position=hold.frame[:3, 3],
            )
            for name, link in found.links.items()
            for hold in link.holds
        ]

    def _masses(self, found: Overlays) -> list[Any]:
        # solids hide objects inside, but not labels
        return [
            self._scene.add_label(
                f"/asset/{name}/mass",
                f"\N{BLACK CIRCLE} {name} {link.mass:.3g} kg",
                position=link.center,
                anchor="center-left",
                font_screen_scale=0.9,
            )
            for name, link in found.links.items()
        ]

    def _lines(self, name: str, segments: Array, color: tuple[int, int, int], width: float) -> Any:
        return self._scene.add_line_segments(
            name, segments.astype(np.float32), color, thickness=width, thickness_units="screen"
        )


def _place(node: Any, matrix: Array) -> None:
    node.wxyz, node.position = quaternion(matrix), matrix[:3, 3]


def _apart(faces: ColliderFaces, distance: float) -> tuple[Array, NDArray[np.int64]]:
    """Return a slightly enlarged collider, which does not flicker against its solid."""
    middle = (faces.vertices.min(axis=0) + faces.vertices.max(axis=0)) / 2.0
    offsets = faces.vertices - middle
    length = np.linalg.norm(offsets, axis=1, keepdims=True)
    return middle + offsets * (1.0 + distance / np.maximum(length, distance)), faces.triangles


def _edges(vertices: Array, triangles: NDArray[np.int64]) -> Array:
    """Return the sharp edges of a convex piece, shape (k, 2, 3)."""
    import trimesh

    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    pairs = mesh.face_adjacency
    across = np.einsum("ij,ij->i", mesh.face_normals[pairs[:, 0]], mesh.face_normals[pairs[:, 1]])
    return np.asarray(vertices[mesh.face_adjacency_edges[across < _SMOOTH]])
