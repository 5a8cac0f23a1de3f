"""Scene in the browser: a frame for each link, moved by the joints, with the meshes below.

Unchanged data are not sent again: a joint only sets poses, and a link with the same look stays.
"""

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.asset.link import MovedLink
from artgen.asset.shape import ComposedShape, MovedShape, Shape
from artgen.export.frames import quaternion
from artgen.export.glb.buffer import Buffer
from artgen.export.glb.materials import Looks
from artgen.export.glb.meshes import primitive
from artgen.materials.textures import Kind
from artgen.studio.signs import Signs
from artgen.view.overlays import Rgb, label_colors

Key = tuple[Any, ...]


@dataclass(frozen=True, eq=False)
class Placed:
    """Look of a link and its place at rest."""

    link: Link  # the link, moved to the origin
    offset: Array  # its place, shape (3,) [m]
    key: Key  # key of its look: equal keys have equal surfaces


def placed(link: Link) -> Placed:
    """Return the look of a link and its place.

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
    return (_Same(shape),)


class _Same:
    """Equal only to wrappers of the same object, which it keeps alive."""

    def __init__(self, held: Any) -> None:
        self._held = held

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and self._held is other._held

    def __hash__(self) -> int:
        return id(self._held)


def link_glb(link: Link, textures: int) -> bytes:
    """Return the visible surfaces of a link."""
    buffer = Buffer()
    looks = Looks(buffer, textures)
    primitives = []
    for surface in link.surfaces:
        # without tangents, which take as long as the rest: browsers compute them
        maps: tuple[Kind, ...] = ("albedo",) if looks.maps(surface.material) else ()
        shown = primitive(buffer, surface, np.zeros(3), maps)
        primitives.append({**shown, "material": looks.number(surface.material)})
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": link.name, "mesh": 0}],
        "meshes": [{"primitives": primitives}],
        **looks.to_data(),
    }
    return buffer.glb(scene)


Color = tuple[int, int, int]

_GHOST = 0.25  # delay before replaced objects are removed: browsers need time to read the new ones [s]
_REDS = ((222, 36, 27), (255, 122, 92))  # colors of the first and the second of two colliding links
_FLOOR = (0.02, 0.1, 0.5)  # sizes of the cells of the floor [m]
_VIEW = (0.45, -0.82, 0.35)  # direction of the first view
_DISTANCE = 1.75  # distance of the first view, relative to the asset's size
_FIELD = 0.65  # vertical field of view [rad]


@dataclass
class _Shown:
    """A link in the scene."""

    frame: Any  # node for its pose
    looks: tuple[Any, ...] = ()  # key that determines the fields below
    nodes: list[Any] = field(default_factory=list)  # visible nodes
    pose: Array = field(default_factory=lambda: np.full((4, 4), np.nan))  # place of the frame


class Viewport:
    """The scene of a viser server.

    Attributes:
        sent: Number of links sent since the server started; measures the cost of a change.
        by_label: Whether links are colored by their semantic labels.
        textures: Texels per side of the material maps; 0 for colors only.
    """

    def __init__(self, server: Any) -> None:
        self._server = server
        self._links: dict[str, _Shown] = {}
        self._ghosts: list[tuple[float, str, Any]] = []
        self._number = 0
        self._asset: Asset | None = None
        self._placed: dict[str, Placed] = {}
        self._red: tuple[str, ...] = ()
        self.signs = Signs(server)
        self.sent = 0
        self.by_label = False
        self.textures = 512

    def light(self, *, rich: bool) -> None:
        """Light the scene: with reflections and shadows, or fast without a GPU."""
        scene = self._server.scene
        scene.configure_environment_map("studio" if rich else None, environment_intensity=0.6)
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
        self._red = ()
        self._placed = {link.name: placed(link) for link in asset.links}
        self.signs.clear()
        for name in self._links.keys() - self._placed.keys():
            self._remove(name)
        self._dress()
        self.pose(q)
        self.signs.show(asset, q)
        if first:
            self.frame_camera()

    def frame(self, link: str) -> Any:
        """Return the node for the pose of a link."""
        return self._links[link].frame

    def dress(self, red: tuple[str, ...] = ()) -> None:
        """Update the materials of the links after a change of `by_label` or `textures`."""
        self._red = tuple(red)
        if self._asset is not None:
            self._dress()

    def _dress(self) -> None:
        assert self._asset is not None
        colors = label_colors(self._asset) if self.by_label else {}
        for link in self._asset.links:
            red = _REDS[self._red.index(link.name)] if link.name in self._red else None
            shown = self._links.get(link.name)
            if shown is None:
                frame = self._server.scene.add_frame(f"/asset/{link.name}", show_axes=False)
                shown = self._links[link.name] = _Shown(frame)
            palette = tuple(colors.get(label) for label in link.labels)
            plain = red is not None or self.by_label
            place = self._placed[link.name]
            looks = (place.key, red, palette, 0 if plain else self.textures)
            if looks == shown.looks:
                for node in shown.nodes:
                    _put(node, place.offset)
                continue
            made = self._plain(place, colors, red=red) if plain else [self._glb(place)]
            self._bury(link.name, shown.nodes)
            shown.looks, shown.nodes = looks, made
            self.sent += 1

    def _glb(self, place: Placed) -> Any:
        content = link_glb(place.link, self.textures)
        return self._server.scene.add_glb(self._name(place.link.name), content, position=place.offset)

    def _plain(self, place: Placed, colors: Mapping[str, Rgb], *, red: Color | None) -> list[Any]:
        made = []
        for surface in place.link.surfaces:
            opacity = surface.material.opacity
            node = self._server.scene.add_mesh_simple(
                self._name(place.link.name),
                surface.mesh.vertices.astype(np.float32),
                surface.mesh.triangles.astype(np.uint32),
                color=red or colors[surface.label],
                opacity=None if opacity == 1.0 else opacity,
                position=place.offset,
            )
            made.append(node)
        return made

    def _name(self, link: str) -> str:
        self._number += 1
        return f"/asset/{link}/looks_{self._number}"

    def _bury(self, link: str, nodes: list[Any]) -> None:
        end = time.monotonic() + _GHOST
        self._ghosts += [(end, link, node) for node in nodes]

    def tidy(self, *, gone: str = "") -> None:
        """Remove objects that were replaced a while ago, and replaced objects of removed links."""
        now = time.monotonic()
        kept = []
        for end, link, node in self._ghosts:
            if end <= now or link == gone:
                node.remove()
            else:
                kept.append((end, link, node))
        self._ghosts = kept

    def _remove(self, link: str) -> None:
        self.tidy(gone=link)
        shown = self._links.pop(link)
        for node in (*shown.nodes, shown.frame):
            node.remove()

    def pose(self, q: Mapping[str, float]) -> int:
        """Move the links to joint positions; return the number of moved links."""
        if self._asset is None:
            return 0
        moved = 0
        for name, matrix in self._asset.pose(q).items():
            shown = self._links[name]
            if np.array_equal(shown.pose, matrix):
                continue
            shown.pose = matrix
            shown.frame.wxyz = quaternion(matrix)
            shown.frame.position = matrix[:3, 3]
            moved += 1
        self.signs.pose(q)
        return moved

    def frame_camera(self) -> None:
        """Let new browsers start with the whole asset from the front, and set the floor."""
        assert self._asset is not None
        low, high = self._asset.bounds()
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


def _put(node: Any, position: Array) -> None:
    if not np.array_equal(node.position, position):
        node.position = position
