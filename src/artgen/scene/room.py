"""A room in which assets are placed, and their union as one asset.

The room extends from its back wall, at y = 0, to -y; x runs to the right, z up, and the middle of the foot of
the back wall is the origin.
"""

import math
import zlib
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from operator import add
from typing import Any, Literal, get_args

import numpy as np

from artgen._arrays import Array, FrozenArrays, cached_property
from artgen._names import ByName
from artgen.asset import Asset, AssetJoint
from artgen.asset.asset import DetailName, remember
from artgen.asset.link import Collider, DerivedLink, Piece, Surface
from artgen.asset.shape import Mesh
from artgen.catalog import find
from artgen.errors import AssetError, ParameterError
from artgen.export.frames import translation
from artgen.generator import generator
from artgen.materials import Material, colored, material
from artgen.nodes.body import part, weld
from artgen.nodes.handles import Body
from artgen.nodes.region import Region
from artgen.proof.certify import certify
from artgen.proof.limits import separated
from artgen.proof.paths import JointPath
from artgen.view.camera import box_corners

Wall = Literal["back", "left", "right"]

GAP = 0.003  # between neighbors in a run, and between an asset and its wall [m]
STANDING = 0.0005  # below an asset that stands on a floor or on another asset [m]
WALL = 0.12  # thickness of walls [m]
_FLOOR = 0.08  # thickness of the floor [m]
_TURNS = {"back": 0, "left": 1, "right": -1}  # quarter turns about z, which let assets face the room
_LEAST = 0.4  # share of its range that a joint keeps at least where an asset beside it is in the way


@dataclass(frozen=True, eq=False)
class Placement(FrozenArrays):
    """An asset at its place in a room.

    Attributes:
        name: Prefix of the names of its links and joints in the scene.
        asset: The asset, in its own coordinates.
        pose: Its place in the room, shape (4, 4).
    """

    name: str
    asset: Asset
    pose: Array

    @cached_property
    def bounds(self) -> Array:
        """Corners of the bounding box in the room, with all joints at rest, shape (2, 3) [m]."""
        corners = box_corners(self.asset.bounds(), self.pose)
        return np.array([corners.min(axis=0), corners.max(axis=0)])


class Scene:
    """A room in which assets are placed one after another.

    Args:
        name: Name of the scene.
        seed: Seed of the assets: each has a seed of its own, of this one and of its name.
        width: Inner width of the room, along x [m].
        depth: Inner depth of the room, along y [m].
        height: Inner height of the room [m].
        floor: Material of the floor.
        paint: Material of the walls.
        detail: Level of detail of the assets.

    Examples:
        >>> from artgen.scene import Scene
        >>> room = Scene("corner", seed=1, width=2.4, depth=2.0)
        >>> chest, *_ = room.run("back", "drawer", "cabinet")
        >>> lamp = room.on(chest, "lamp", style="table")
        >>> asset = room.build()
        >>> asset.certificate.proven
        True
    """

    def __init__(
        self,
        name: str,
        *,
        seed: int = 0,
        width: float,
        depth: float,
        height: float = 2.5,
        floor: Material | None = None,
        paint: Material | None = None,
        detail: DetailName = "full",
    ) -> None:
        for what, length in (("width", width), ("depth", depth), ("height", height)):
            if not 0.5 <= length <= 30.0:
                raise ParameterError(f"the {what} of a room is 0.5 to 30 m, not {length!r}")
        self.name, self.seed, self.detail = name, seed, detail
        self.size = (width, depth, height)
        self.placed: list[Placement] = []
        self._floor, self._paint = floor or material("oak"), paint or colored("painted_wood", "white")
        self._holes: dict[Wall, list[Array]] = {wall: [] for wall in get_args(Wall)}
        self._slabs: list[tuple[str, Array, Material]] = []
        # the last asset of each name with its category and parameters: `draw` comes before a placement
        self._known: dict[str, tuple[str, dict[str, Any], Asset]] = {}

    def against(
        self, wall: Wall, category: str, *, at: float, z: float = 0.0, name: str = "", **overrides: Any
    ) -> Placement:
        """Place an asset with its back against a wall.

        Args:
            wall: The wall: `back`, `left` or `right`.
            category: Category of the asset.
            at: Distance of its left side from the left end of the wall, seen from the room [m].
            z: Height of its bottom above the floor; it hangs on the wall if that is not 0 [m].
            name: Name in the scene; by default the category and a number.
            overrides: Parameters of the asset.

        Raises:
            ParameterError: The room has no such wall or the asset does not fit; the message has the length
                that is missing.
        """
        return self._placed(wall, category, at, z, name, overrides)

    def _placed(
        self,
        wall: Wall,
        category: str,
        at: float,
        z: float,
        name: str,
        overrides: dict[str, Any],
        *,
        inset: bool = False,
    ) -> Placement:
        """Place an asset before a wall, or with the middle of its depth in the middle of the wall."""
        if wall not in _TURNS:
            raise ParameterError(f"wall = {wall!r} is not allowed: it must be one of {', '.join(_TURNS)}")
        name, asset = self._drawn(category, name, overrides)
        low, high = asset.bounds()
        length = self.size[0] if wall == "back" else self.size[1]
        if (missing := at + high[0] - low[0] - length) > 0.0:
            raise ParameterError(
                f"{name!r} does not fit at {at:.3f} m of the {wall} wall, which is {length:.3f} m long: "
                f"{missing:.3f} m are missing"
            )
        along = at - low[0] - length / 2.0  # from the middle of the wall
        out = (WALL - high[1] - low[1]) / 2.0 if inset else -GAP - high[1]
        pose = self._wall_frame(wall) @ translation(np.array([along, out, max(z, STANDING) - low[2]]))
        return self._keep(Placement(name, asset, pose))

    def run(
        self, wall: Wall, *items: str | tuple[str, dict[str, Any]], at: float = GAP, gap: float = GAP
    ) -> list[Placement]:
        """Place assets side by side along a wall, from the left.

        Args:
            wall: The wall.
            items: Categories, each alone or with parameters: `("drawer", {"kind": "kitchen"})`.
            at: Distance of the first one's left side from the left end of the wall [m].
            gap: Gap between neighbors [m].

        Raises:
            ParameterError: The wall is too short; the message has the length that is missing.
        """
        row: list[Placement] = []
        for item in items:
            category, overrides = (item, {}) if isinstance(item, str) else item
            row.append(self.against(wall, category, at=at, **overrides))
            low, high = row[-1].asset.bounds()
            at += high[0] - low[0] + gap
        return row

    def on(
        self, below: Placement, category: str, *, at: float = 0.5, name: str = "", **overrides: Any
    ) -> Placement:
        """Place an asset on top of another, its back above the back of that one; it is fixed to the room.

        Args:
            below: The asset that carries it.
            category: Category of the asset.
            at: Share of the free width to its left: 0 is flush on the left, 1 on the right.
            name: Name in the scene; by default the category and a number.
            overrides: Parameters of the asset.

        Raises:
            ParameterError: The asset is wider or deeper than the one below it.
        """
        name, asset = self._drawn(category, name, overrides)
        low, high = asset.bounds()
        under_low, under_high = below.asset.bounds()
        free = (under_high - under_low - (high - low))[:2]
        if (free < 0.0).any():
            side = "width" if free[0] < 0.0 else "depth"
            raise ParameterError(
                f"{name!r} does not fit on {below.name!r}: {-min(free):.3f} m of {side} are missing"
            )
        left, back, top = under_low[0] + at * free[0], under_high[1], under_high[2] + STANDING
        shift = translation(np.array([left - low[0], back - high[1], top - low[2]]))
        return self._keep(Placement(name, asset, below.pose @ shift))

    def inset(
        self, wall: Wall, category: str, *, at: float, z: float = 0.0, name: str = "", **overrides: Any
    ) -> Placement:
        """Place an asset in an opening of a wall that is cut to its size: a door or a window.

        Its front, on the outside of a door or window, faces the room. The arguments are those of `against`.
        """
        placed = self._placed(wall, category, at, z, name, overrides, inset=True)
        self._holes[wall].append(placed.bounds)
        return placed

    def slab(self, label: str, low: Sequence[float], high: Sequence[float], material: Material) -> None:
        """Add a board to the room, such as a worktop or a filler, between two corners [m]."""
        self._slabs.append((label, np.array([low, high], np.float64), material))

    def build(self, *, category: str = "scene", seed: int | None = None, attempt: int = 0) -> Asset:
        """Join all to one asset and prove that nothing collides in any state of all joints.

        A joint that meets another asset at rest is narrowed; of two joints that meet each other, one
        depends on the other one then, see `artgen.proof.limits.separated`.

        Args:
            category: Category of the scene.
            seed: Seed of the scene, if it is not that of its assets.
            attempt: Number of draws before this one.

        Raises:
            AssetError: No limits and dependencies prevent a collision, a joint would keep too little of its
                range, or the links of one asset are not proven apart.
        """
        whole = replace(
            _joined(self.name, category, self._room(), self.placed),
            seed=self.seed if seed is None else seed,
            attempt=attempt,
            detail=self.detail,
        )
        owners = {f"{each.name}_{link.name}": each.name for each in self.placed for link in each.asset.links}

        def apart(joint_path: JointPath) -> bool:
            """Tell whether the links belong to two assets, or to one and the room."""
            first, second = map(owners.get, joint_path.links)
            return first != second

        whole = _check_ranges(separated(whole, apart), whole)
        certificate = certify(whole)
        if not certificate.proven:
            raise AssetError(f"scene {self.name!r}: {certificate}")
        return remember(whole, certificate)

    def draw(self, category: str, *, name: str = "", **overrides: Any) -> Asset:
        """Return the asset that the next placement of a category has, without placing it.

        The arguments are those of `against`.
        """
        return self._drawn(category, name, overrides)[1]

    def _drawn(self, category: str, name: str, overrides: dict[str, Any]) -> tuple[str, Asset]:
        """Return the name of a new asset and the asset."""
        if not name:
            number = sum(each.asset.category == category for each in self.placed)
            name = f"{category}_{number}" if number else category
        if name in {each.name for each in self.placed}:
            raise ParameterError(f"the scene {self.name!r} has an asset {name!r} already; give another name")
        known = self._known.get(name)
        if known is None or known[:2] != (category, overrides):
            seed = zlib.crc32(f"{self.seed}/{name}".encode())
            asset = find(category).generate(seed, detail=self.detail, **overrides)
            known = self._known[name] = (category, overrides, asset)
        return name, known[2]

    def _wall_frame(self, wall: Wall) -> Array:
        """Return the pose of the middle of the foot of a wall, y out of the room, shape (4, 4)."""
        side = _TURNS[wall]
        pose = np.eye(4)
        if side:
            pose[:2, :2] = (0.0, -side), (side, 0.0)
            pose[:2, 3] = -side * self.size[0] / 2.0, -self.size[1] / 2.0
        return pose

    def _keep(self, placed: Placement) -> Placement:
        self.placed.append(placed)
        return placed

    def _room(self) -> Asset:
        """Return the room itself: floor, walls with their openings, and slabs."""
        width, depth, height = self.size
        x, y = (-width / 2.0, width / 2.0), (-depth, 0.0)
        walls: dict[Wall, Region] = {
            "back": Region((x[0] - WALL, x[1] + WALL), (0.0, WALL), (0.0, height)),
            "left": Region((x[0] - WALL, x[0]), y, (0.0, height)),
            "right": Region((x[1], x[1] + WALL), y, (0.0, height)),
        }

        @generator
        def room() -> Body:
            ground = Region((x[0] - WALL, x[1] + WALL), (y[0], WALL), (-_FLOOR, 0.0))
            bodies = [part(ground.box(), "floor", self._floor, name="room")]
            for wall, region in walls.items():
                solid = region.box()
                for low, high in self._holes[wall]:
                    hole = Region.between(low - STANDING, high + STANDING)
                    across = {"x" if wall != "back" else "y": 2.0 * WALL}
                    solid = solid - hole.grow(**across).box()
                bodies.append(part(solid, "wall", self._paint))
            for label, (low, high), made_of in self._slabs:
                bodies.append(part(Region.between(low, high).box(bevel=0.003), label, made_of))
            return weld(*bodies)

        return room.generate(certify=False)


def _check_ranges(asset: Asset, before: Asset) -> Asset:
    """Return an asset if its joints keep enough of the ranges that they had before."""
    for joint, full in zip(asset.joints, before.joints, strict=True):
        if joint.limits == full.limits or joint.limits is None:
            continue
        low, high = full.limits or (-math.pi, math.pi)
        share = (joint.limits[1] - joint.limits[0]) / (high - low)
        dependents = [
            abs(term.value) / (high - low)
            for each in asset.joints
            if each.needs is not None
            for term in each.needs.condition.comparisons()
            if term.joint == joint.name
        ]
        if share < max([_LEAST, *dependents]):
            raise AssetError(
                f"scene {asset.name!r}: only {share:.0%} of the range of joint {joint.name!r} is free; "
                "leave more space beside or before it"
            )
    return asset


@dataclass(frozen=True, eq=False)
class _Repainted(DerivedLink):
    """A link with renamed materials."""

    materials: Mapping[Material, Material] = field(kw_only=True)  # new materials by the old ones

    def _with(self, items: Iterable[Any]) -> tuple[Any, ...]:
        return tuple(
            replace(each, material=self.materials[each.material]) if each.material in self.materials else each
            for each in items
        )

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders of the source, with the new materials."""
        return self._with(self.source.colliders)

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of the source, with the new materials."""
        return self._with(self.source.surfaces)

    def surfaces_of(self, mesh_of: Callable[[Piece], Mesh]) -> tuple[Surface, ...]:
        """Return one surface for each label and material; `mesh_of` returns the mesh of a piece."""
        return self._with(self.source.surfaces_of(mesh_of))


def _distinct(placed: Placement, known: dict[str, Material]) -> dict[Material, Material]:
    """Return new materials for those whose names other materials of the scene have, and add all to these."""
    result = {}
    for each in placed.asset.materials:
        if known.setdefault(each.name, each) != each:
            result[each] = each.with_(name=f"{placed.name}_{each.name}")
    return result


def _joined(name: str, category: str, room: Asset, placed: Collection[Placement]) -> Asset:
    """Return one asset of a room and the assets in it, each fixed to the room by a locked joint."""
    links, joints, contacts = list(room.links), list(room.joints), list(room.contacts)
    base, materials = links[0].name, {each.name: each for each in room.materials}
    for each in placed:
        prefix = f"{each.name}_"
        of_links = {link.name: prefix + link.name for link in each.asset.links}
        of_joints = {joint.name: prefix + joint.name for joint in each.asset.joints}
        repaint = _distinct(each, materials)
        links += [
            _Repainted.of(link, materials=repaint).moved(each.pose).renamed(partial(add, prefix), of_joints)
            for link in each.asset.links
        ]
        up, root = np.array([0.0, 0.0, 1.0]), of_links[each.asset.links[0].name]
        joints.append(
            AssetJoint(
                f"{prefix}place", "prismatic", up, each.pose[:3, 3], (0.0, 0.0), parent=base, child=root
            )
        )
        for joint in each.asset.joints:
            moved = joint.moved(each.pose).renamed(of_joints)
            joints.append(replace(moved, parent=of_links[joint.parent], child=of_links[joint.child]))
        contacts += [contact.renamed(of_links, of_joints) for contact in each.asset.contacts]
    labels = {label for asset in (room, *(each.asset for each in placed)) for label in asset.labels}
    parameters = {each.name: each.asset.name for each in placed}
    return Asset(
        name,
        category,
        ByName(links),
        ByName(joints),
        parameters=parameters,
        version=room.version,
        labels=tuple(sorted(labels | {"floor", "wall"})),
        contacts=tuple(contacts),
    )
