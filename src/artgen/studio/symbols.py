"""Symbols over an asset in the studio: colliders, joints, grasp frames, centers of mass."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset import Asset
from artgen.export.frames import quaternion
from artgen.view.overlays import axis_poses, collider_mesh, joint_symbol

Color = tuple[int, int, int]

SYMBOLS = {
    "colliders": "colliders",
    "joints": "joint axes and limits",
    "grasps": "grasp frames",
    "masses": "centers of mass",
}
"""Titles of the kinds of symbols."""

_AXIS, _RANGE, _HAND = (213, 94, 0), (230, 159, 0), (0, 114, 178)
_PUSH, _COLLIDER = (204, 121, 167), (0, 158, 115)
_WIDTH = 3.0  # width of lines on the screen [pixels]
_APART = 0.0007  # distance of colliders outside their solids, as a share of the asset's size
_SMOOTH = 0.1734  # largest angle between faces whose common edge is not drawn [rad]
_FRAME = 0.04  # length of the axes of a grasp frame, as a share of the asset's size


class Symbols:
    """Symbols over an asset: colliders, joints, grasp frames, centers of mass."""

    def __init__(self, scene: Any) -> None:
        self._scene = scene
        self._asset: Asset | None = None
        self._q: Mapping[str, float] = {}
        self._kinds: set[str] = set()
        self._nodes: dict[str, list[Any]] = {}
        self._hands: dict[str, tuple[Any, Any]] = {}  # frames of the axis and of the hand of each joint

    def clear(self) -> None:
        """Remove all symbols; the display options stay."""
        for kind in SYMBOLS:
            self._remove(kind)

    def show(self, asset: Asset, q: Mapping[str, float]) -> None:
        """Draw the enabled kinds over an asset whose links are in the scene."""
        self._asset, self._q = asset, q
        for kind in self._kinds:
            self._draw(asset, kind)

    def switch(self, kind: str, shown: bool) -> None:  # noqa: FBT001 - a checkbox says so
        """Show or hide a kind."""
        (self._kinds.add if shown else self._kinds.discard)(kind)
        self._remove(kind)
        if shown and self._asset is not None:
            self._draw(self._asset, kind)

    def pose(self, q: Mapping[str, float]) -> None:
        """Move the axes of joints to joint positions; other symbols move with the links."""
        self._q = q
        if not self._hands or self._asset is None:
            return
        positions, axes = self._asset.positions(q), axis_poses(self._asset, q)
        for name, (axis, hand) in self._hands.items():
            place(axis, axes[name])
            place(hand, axes[name] @ self._asset.joint(name).motion(positions[name]))

    def _draw(self, asset: Asset, kind: str) -> None:
        size = float(np.linalg.norm(np.ptp(asset.bounds(), axis=0)))
        self._nodes[kind] = getattr(self, f"_{kind}")(asset, size)
        self.pose(self._q)

    def _remove(self, kind: str) -> None:
        for node in self._nodes.pop(kind, []):
            node.remove()
        if kind == "joints":
            self._hands.clear()

    def _colliders(self, asset: Asset, size: float) -> list[Any]:
        import trimesh

        nodes = []
        for link in asset.links:
            if not link.colliders:
                continue
            meshes = [_enlarged(*collider_mesh(each.convex), _APART * size) for each in link.colliders]
            mesh: Any = trimesh.util.concatenate([trimesh.Trimesh(*each, process=False) for each in meshes])
            nodes.append(
                self._scene.add_mesh_simple(
                    f"/asset/{link.name}/colliders",
                    mesh.vertices.astype(np.float32),
                    mesh.faces.astype(np.uint32),
                    color=_COLLIDER,
                    opacity=0.25,
                    flat_shading=True,
                    cast_shadow=False,
                    receive_shadow=False,
                )
            )
            edges = mesh.face_adjacency_edges[mesh.face_adjacency_angles > _SMOOTH]
            name = f"/asset/{link.name}/collider_edges"
            nodes.append(self._lines(name, np.asarray(mesh.vertices[edges]), _COLLIDER, 1.5))
        return nodes

    def _joints(self, asset: Asset, size: float) -> list[Any]:
        nodes: list[Any] = []
        for joint in asset.joints:
            if joint.locked:
                continue
            name, symbol = joint.name, joint_symbol(asset, joint)
            axis = self._scene.add_frame(f"/joints/{name}", show_axes=False)
            hand = self._scene.add_frame(f"/hands/{name}", show_axes=False)
            self._hands[name] = (axis, hand)
            path = np.stack([symbol.range[:-1], symbol.range[1:]], axis=1)
            nodes += [
                self._lines(f"/joints/{name}/axis", symbol.axis[None], _AXIS, _WIDTH),
                self._lines(f"/joints/{name}/range", path, _RANGE, _WIDTH),
                self._scene.add_label(
                    f"/joints/{name}/name", name, position=symbol.axis[1], font_screen_scale=0.9
                ),
                self._lines(f"/hands/{name}/hand", symbol.hand[None], _HAND, _WIDTH),
                axis,
                hand,
            ]
        return nodes

    def _grasps(self, asset: Asset, size: float) -> list[Any]:
        return [
            self._scene.add_frame(
                f"/asset/{hold.link}/hold_{hold.name}",
                axes_length=_FRAME * size,
                axes_radius=_FRAME * size / 16.0,
                origin_color=_PUSH if hold.kind == "push" else _HAND,
                wxyz=quaternion(hold.frame),
                position=hold.frame[:3, 3],
            )
            for hold in asset.affordances
        ]

    def _masses(self, asset: Asset, size: float) -> list[Any]:
        # solids hide objects inside, but not labels
        return [
            self._scene.add_label(
                f"/asset/{link.name}/mass",
                f"\N{BLACK CIRCLE} {link.name} {link.mass_properties.mass:.3g} kg",
                position=link.mass_properties.center,
                anchor="center-left",
                font_screen_scale=0.9,
            )
            for link in asset.links
        ]

    def _lines(self, name: str, segments: Array, color: Color, width: float) -> Any:
        return self._scene.add_line_segments(
            name, segments.astype(np.float32), color, thickness=width, thickness_units="screen"
        )


def place(node: Any, matrix: Array) -> None:
    """Set the pose of a node, shape (4, 4)."""
    node.wxyz, node.position = quaternion(matrix), matrix[:3, 3]


def _enlarged(vertices: Array, triangles: Indices, distance: float) -> tuple[Array, Indices]:
    """Return a slightly enlarged collider, which does not flicker against its solid."""
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2.0
    offsets = vertices - middle
    length = np.linalg.norm(offsets, axis=1, keepdims=True)
    return middle + offsets * (1.0 + distance / np.maximum(length, distance)), triangles
