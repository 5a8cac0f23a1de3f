"""Scene in the browser: a frame for each link, moved by the joints, with the meshes below.

Unchanged data are not sent again: a joint only sets poses, and a link with the same surfaces stays.
"""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.asset.link import MovedLink
from artgen.asset.shape import ComposedShape, MovedShape, Shape
from artgen.export.glb.buffer import Buffer
from artgen.export.glb.surfaces import Surfaces
from artgen.studio.symbols import Color, Symbols, place
from artgen.view.overlays import Rgb, label_colors

Key = tuple[Any, ...]


@dataclass(frozen=True, eq=False)
class Placed:
    """Surfaces of a link and their place at rest."""

    link: Link  # the link, moved to the origin
    offset: Array  # its place, shape (3,) [m]
    key: Key  # equal keys mean equal surfaces


def placed(link: Link) -> Placed:
    """Return the surfaces of a link and their place.

    A key holds its solids by identity: evaluation returns the same objects for unchanged parts, so that
    neither triangles nor hashes have to be computed.
    """
    base, matrix = _unmoved(link)
    linear = matrix.copy()
    linear[:3, 3] = 0.0
    return Placed(base.moved(linear), matrix[:3, 3], (linear.tobytes(), *_link_key(base)))


def _unmoved(link: Link) -> tuple[Link, Array]:
    """Return the link before its motion, and the motion, shape (4, 4); a new name changes textures."""
    if isinstance(link, MovedLink) and link.name == link.source.name:
        base, matrix = _unmoved(link.source)
        return base, link.matrix @ matrix
    return link, np.eye(4)


def _link_key(link: Link) -> Key:
    if isinstance(link, MovedLink):
        return (link.name, link.matrix.tobytes(), *_link_key(link.source))
    pieces = tuple((piece.label, piece.material, _shape_key(piece.shape)) for piece in link.pieces)
    return (link.name, pieces)


def _shape_key(shape: Shape) -> Key:
    if isinstance(shape, MovedShape):
        return (shape.matrix.tobytes(), _shape_key(shape.source))
    if isinstance(shape, ComposedShape):
        return tuple(_shape_key(each) for each in shape.shapes)
    return (shape,)


def link_glb(link: Link, textures: int) -> bytes:
    """Return the visible surfaces of a link."""
    buffer = Buffer()
    surfaces = Surfaces(buffer, textures)
    # without tangents: their computation takes as long as the rest, and browsers do it themselves
    primitives = [surfaces.primitive(surface, np.zeros(3), directions=False) for surface in link.surfaces]
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": link.name, "mesh": 0}],
        "meshes": [{"primitives": primitives}],
        **surfaces.to_data(),
    }
    return buffer.glb(scene)


_OVERLAP = 0.25  # time that replaced objects stay, until browsers have read the new ones [s]
_REDS: tuple[Color, Color] = ((222, 36, 27), (255, 122, 92))  # colors of two colliding links
_FLOOR = (0.02, 0.1, 0.5)  # sizes of the cells of the floor [m]
_VIEW = (0.45, -0.82, 0.35)  # direction of the first view
_DISTANCE = 1.75  # distance of the first view, relative to the asset's size
_FIELD = 0.65  # vertical field of view [rad]


@dataclass
class _Shown:
    """A link in the scene."""

    frame: Any  # node for its pose
    appearance: tuple[Any, ...] = ()  # key of the materials and surfaces of the nodes
    nodes: list[Any] = field(default_factory=list)  # visible nodes
    pose: Array = field(default_factory=lambda: np.full((4, 4), np.nan))  # place of the frame


class Viewport:
    """The scene of a viser server.

    Attributes:
        symbols: Symbols over the asset.
        sent: Number of links sent since the server started; measures the cost of a change.
        by_label: Whether links are colored by their semantic labels.
        textures: Texels per side of the material maps; 0 for colors only.
        rich_light: Whether the scene has reflections and shadows.
    """

    def __init__(self, server: Any, *, rich_light: bool) -> None:
        self._server = server
        self._links: dict[str, _Shown] = {}
        self._replaced: list[tuple[float, str, Any]] = []
        self._asset: Asset | None = None
        self._placed: dict[str, Placed] = {}
        self.symbols = Symbols(server.scene)
        self.sent = 0
        self.by_label = False
        self.textures = 512
        self.light(rich=rich_light)

    def light(self, *, rich: bool) -> None:
        """Light the scene: with reflections and shadows, or fast without a GPU."""
        self.rich_light = rich
        scene = self._server.scene
        scene.configure_environment_map("studio" if rich else None, environment_intensity=0.35)
        scene.configure_default_lights(enabled=rich, cast_shadow=rich)
        scene.add_light_hemisphere("/lights/sky", intensity=1.6, visible=not rich)
        # from the front, above and to the left, like the first view
        scene.add_light_directional(
            "/lights/sun", intensity=1.8, position=(-1.0, -2.0, 2.0), visible=not rich
        )

    def show(self, asset: Asset, q: Mapping[str, float]) -> None:
        """Replace the shown asset; unchanged links stay."""
        first = self._asset is None
        self._asset = asset
        self._placed = {link.name: placed(link) for link in asset.links}
        self.symbols.clear()
        for name in self._links.keys() - self._placed.keys():
            self.remove_replaced(of_link=name)
            shown = self._links.pop(name)
            for node in (*shown.nodes, shown.frame):
                node.remove()
        self.update_materials()
        self.pose(q)
        self.symbols.show(asset, q)
        if first:
            self._frame_camera(asset)

    def update_materials(
        self, *, red: Sequence[str] = (), by_label: bool | None = None, textures: int | None = None
    ) -> None:
        """Update the materials of the links; `red` names up to two links that are shown in red."""
        self.by_label = self.by_label if by_label is None else by_label
        self.textures = self.textures if textures is None else textures
        if self._asset is None:
            return
        colors = label_colors(self._asset) if self.by_label else {}
        for link in self._asset.links:
            color = _REDS[red.index(link.name)] if link.name in red else None
            if link.name not in self._links:
                frame = self._server.scene.add_frame(f"/asset/{link.name}", show_axes=False)
                self._links[link.name] = _Shown(frame)
            shown, look = self._links[link.name], self._placed[link.name]
            plain = color is not None or self.by_label
            palette = tuple(colors.get(label) for label in link.labels)
            appearance = (look.key, color, palette, 0 if plain else self.textures)
            if appearance == shown.appearance:
                for node in shown.nodes:
                    if not np.array_equal(node.position, look.offset):
                        node.position = look.offset
                continue
            self.sent += 1
            name = f"/asset/{link.name}/appearance_{self.sent}"
            if plain:
                nodes = self._plain(name, look, colors, color)
            else:
                content = link_glb(look.link, self.textures)
                nodes = [self._server.scene.add_glb(name, content, position=look.offset)]
            end = time.monotonic() + _OVERLAP
            self._replaced += [(end, link.name, node) for node in shown.nodes]
            shown.appearance, shown.nodes = appearance, nodes

    def _plain(self, name: str, look: Placed, colors: Mapping[str, Rgb], color: Color | None) -> list[Any]:
        return [
            self._server.scene.add_mesh_simple(
                f"{name}_{number}",
                surface.mesh.vertices.astype(np.float32),
                surface.mesh.triangles.astype(np.uint32),
                color=color or colors[surface.label],
                opacity=None if surface.material.opacity == 1.0 else surface.material.opacity,
                position=look.offset,
            )
            for number, surface in enumerate(look.link.surfaces)
        ]

    def remove_replaced(self, *, of_link: str = "") -> None:
        """Remove objects that were replaced some time ago, and those of a removed link."""
        replaced, self._replaced = self._replaced, []
        for end, link, node in replaced:
            if end <= time.monotonic() or link == of_link:
                node.remove()
            else:
                self._replaced.append((end, link, node))

    def pose(self, q: Mapping[str, float]) -> None:
        """Move the links to joint positions."""
        if self._asset is None:
            return
        for name, matrix in self._asset.pose(q).items():
            shown = self._links[name]
            if not np.array_equal(shown.pose, matrix):
                shown.pose = matrix
                place(shown.frame, matrix)
        self.symbols.pose(q)

    def _frame_camera(self, asset: Asset) -> None:
        """Set the first view of new browsers to the whole asset from the front, and add the floor."""
        low, high = asset.bounds()
        size = float(np.linalg.norm(high - low))
        middle = (low + high) / 2.0
        camera = self._server.initial_camera
        camera.look_at = tuple(middle)
        camera.position = tuple(middle + _DISTANCE * size * np.array(_VIEW))
        camera.fov = _FIELD
        camera.near = size / 200.0
        cell = next((cell for cell in _FLOOR if size < 20 * cell), _FLOOR[-1])
        self._server.scene.add_grid(
            "/floor",
            width=6 * size,
            height=6 * size,
            cell_size=cell,
            section_size=10 * cell,
            cell_color=(225, 225, 225),
            section_color=(200, 200, 200),
            plane_opacity=1.0,
            plane_color=(250, 250, 250),
            shadow_opacity=0.2,
            position=(float(middle[0]), float(middle[1]), min(0.0, float(low[2])) - 0.0005),
        )
