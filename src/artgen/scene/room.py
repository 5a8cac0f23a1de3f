"""A room in which assets are placed, and their union as one asset.

The room extends from its back wall, at y = 0, to -y; x runs to the right, z up, and the middle of the foot of
the back wall is the origin.
"""

import math
import zlib
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from operator import add, or_
from typing import Any, Literal, get_args

import numpy as np

from artgen._arrays import Array, FrozenArrays, affine, cached_property
from artgen._names import ByName, check_name, is_identifier
from artgen.asset import Asset, AssetJoint
from artgen.asset.asset import DetailName, remember
from artgen.asset.collision import link_parts
from artgen.asset.joint import is_number, rotation
from artgen.asset.link import RepaintedLink
from artgen.asset.manifolds import box_of
from artgen.asset.placed import PlacedAsset, certificate_digest, place_of
from artgen.catalog import find
from artgen.errors import AssetError, ParameterError
from artgen.export.frames import translation
from artgen.generator import generator
from artgen.generator.generator import checked_count
from artgen.materials import Material, colored, material
from artgen.nodes.body import part, weld
from artgen.nodes.handles import Body
from artgen.nodes.region import Region
from artgen.proof.certify import Known, certify
from artgen.proof.limits import separated
from artgen.proof.paths import JointPath
from artgen.view.camera import box_corners

Wall = Literal["back", "left", "right"]
Point = tuple[float, float]
Line = tuple[Point, Point]
"""Left and right end of a line on the floor, as seen by a person before what stands there [m]."""

GAP = 0.003  # between neighbors in a run, and between an asset and its wall [m]
STANDING = 0.0005  # below an asset that stands on a floor or on another asset [m]
SIZES = (0.5, 30.0)  # least and largest width, depth and height of a room [m]
WALL = 0.12  # thickness of walls [m]
_FLOOR = 0.08  # thickness of the floor [m]
_OVERLAP = 1e-9  # common volume of two fixed assets above which they count as overlapping [m3]
_SLACK = 1e-9  # by which a rounded length may be too short, or an asset longer than its wall [m]
_SOLE = 0.0015  # height above its lowest point up to which an asset may touch the ground [m]
_TILT = 0.08  # slope on which a free asset stands at least, as a tangent
_CELL = 0.01  # grid in which a place in a drawer is searched [m]
_FINE = 0.004  # grid in which a surface below an asset is searched [m]
_LEVEL = 2e-4  # difference of heights up to which two surfaces are level [m]
_CLEAR = 0.008  # space around what is placed in it [m]
_LEAST = 0.4  # share of its range that a joint keeps at least where an asset beside it is in the way


@dataclass(frozen=True, eq=False)
class Placement(FrozenArrays):
    """An asset at its place in a room.

    Attributes:
        name: Prefix of the names of its links and joints in the scene.
        asset: The asset, in its own coordinates.
        pose: Its place in the room, shape (4, 4).
        carrier: Name of the link of the scene that carries it; empty for the room.
        free: Whether it is a free body in simulation, or fixed to its carrier.
    """

    name: str
    asset: Asset
    pose: Array
    carrier: str = ""
    free: bool = False

    @cached_property
    def bounds(self) -> Array:
        """Corners of the bounding box in the room, with all joints at rest, shape (2, 3) [m]."""
        return _moved_box(self.asset, self.pose)

    def record(self) -> PlacedAsset:
        """Return what the room keeps of the placement."""
        digest = certificate_digest(self.asset.certificate)
        return PlacedAsset.of(self.asset, self.name, self.pose, self.carrier, free=self.free, digest=digest)


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
            check_length(f"the {what} of a room", length, *SIZES)
        check_name(name)
        checked_count("seed", seed)
        self.name, self.seed, self.detail = name, seed, detail
        self.size = (width, depth, height)
        self.placed: list[Placement] = []
        self._floor, self._paint = floor or material("oak"), paint or colored("painted_wood", "white")
        self._holes: dict[Wall, list[Array]] = {wall: [] for wall in get_args(Wall)}
        # the last asset of each name with its category and parameters: `draw` comes before a placement
        self._known: dict[str, tuple[str, dict[str, Any], Asset]] = {}

    def against(
        self, wall: Wall | Line, category: str, *, at: float, z: float = 0.0, name: str = "", **overrides: Any
    ) -> Placement:
        """Place an asset with its back against a wall or a line.

        Args:
            wall: The wall: `back`, `left` or `right`; or a line on the floor, for islands and corners.
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
        wall: Wall | Line,
        category: str,
        at: float,
        z: float,
        name: str,
        overrides: dict[str, Any],
        *,
        inset: bool = False,
        turn: float = 0.0,
    ) -> Placement:
        """Place an asset before a wall, or with the middle of its depth in the middle of the wall."""
        frame, length = self.frame(wall)
        check_length("at, the distance from the left end,", at, 0.0)
        check_length("z, the height above the floor,", z, 0.0)
        name, asset = self._drawn(category, name, overrides)
        spin = turned(turn)
        low, high = _moved_box(asset, spin)
        if inset and (missing := z + high[2] - low[2] - self.size[2]) > _SLACK:
            raise ParameterError(
                f"{name!r} does not fit {z:.3f} m above the floor into a wall that is "
                f"{self.size[2]:.3f} m high: {missing:.3f} m are missing"
            )
        if (missing := at + high[0] - low[0] - length) > _SLACK:
            called = f"the {wall} wall" if isinstance(wall, str) else "a line"
            raise ParameterError(
                f"{name!r} does not fit at {at:.3f} m of {called}, which is {length:.3f} m long: "
                f"{missing:.3f} m are missing"
            )
        out = (WALL - high[1] - low[1]) / 2.0 if inset else -GAP - high[1]
        pose = frame @ translation(np.array([at - low[0], out, max(z, STANDING) - low[2]]))
        return self._keep(Placement(name, asset, pose @ spin))

    def frame(self, wall: Wall | Line) -> tuple[Array, float]:
        """Return the frame of a wall or line, and its length [m].

        Returns:
            A pose of shape (4, 4), at the left end, x along the wall, y out of the room; and the length.

        Raises:
            ParameterError: The room has no such wall, or the line has no length.
        """
        width, depth, _ = self.size
        left, right = -width / 2.0, width / 2.0
        lines: dict[str, Line] = {
            "back": ((left, 0.0), (right, 0.0)),
            "left": ((left, -depth), (left, 0.0)),
            "right": ((right, 0.0), (right, -depth)),
        }
        if isinstance(wall, str) and wall not in lines:
            raise ParameterError(f"wall = {wall!r} is not allowed: it must be one of {', '.join(lines)}")
        start, end = lines[wall] if isinstance(wall, str) else wall
        x, y = end[0] - start[0], end[1] - start[1]
        length = math.sqrt(x * x + y * y)
        check_length(f"the length of the line {wall}", length, _CELL)
        pose = np.eye(4)
        pose[:2, :2] = np.array([[x, -y], [y, x]]) / length
        pose[:2, 3] = start
        return pose, length

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
        self,
        below: Placement,
        category: str,
        *,
        at: float = 0.5,
        deep: float = 0.0,
        turn: float = 0.0,
        free: bool = False,
        name: str = "",
        **overrides: Any,
    ) -> Placement:
        """Place an asset on top of another one or of a worktop.

        Args:
            below: The asset that carries it.
            category: Category of the asset.
            at: Share of the free width to its left: 0 is flush on the left, 1 on the right.
            deep: Share of the free depth behind it: 0 is flush at the back, 1 in front.
            turn: Angle about its vertical axis [rad].
            free: Whether it is a free body in simulation; otherwise it is fixed to what carries it.
            name: Name in the scene; by default the category and a number.
            overrides: Parameters of the asset.

        Raises:
            ParameterError: The asset is wider or deeper than the one below it, its center of mass is over no
                level surface, or it would tip over.
        """
        _check_shares(at, deep)
        self._check_here("below", below)
        name, asset = self._drawn(category, name, overrides)
        spin = turned(turn)
        low, high = _moved_box(asset, spin)
        under_low, under_high = below.asset.bounds()
        room = (under_high - under_low - (high - low))[:2]
        if (room < 0.0).any():
            side = "width" if room[0] < 0.0 else "depth"
            raise ParameterError(
                f"{name!r} does not fit on {below.name!r}: {-min(room):.3f} m of {side} are missing"
            )
        corner = np.array(
            [under_low[0] + at * room[0] - low[0], under_high[1] - deep * room[1] - high[1], 0.0]
        )
        middle = (spin @ [*asset.mass_properties().center, 1.0])[:2] + corner[:2]
        level = _level_under(below.asset, (np.array([low, high]) + corner)[:, :2], middle)
        if level is None:
            raise ParameterError(
                f"{name!r} would stand on nothing: {below.name!r} has no level surface around its center of "
                "mass there; choose another place by at and deep"
            )
        # the rounding of a level from planes does not move what stands on the highest surface
        top = under_high[2] if abs(level - under_high[2]) < _LEVEL else level
        shift = translation(corner + (0.0, 0.0, top + STANDING - low[2]))
        carrier = _base_of(below)
        if free:
            _check_standing(name, asset)
        return self._keep(Placement(name, asset, below.pose @ shift @ spin, carrier, free))

    def inside(
        self,
        container: Placement,
        link: str,
        category: str,
        *,
        at: float = 0.5,
        deep: float = 0.5,
        turn: float = 0.0,
        free: bool = True,
        name: str = "",
        **overrides: Any,
    ) -> Placement:
        """Place an asset in a drawer, a cabinet or a refrigerator; it moves along with the link below it.

        It stands on the lowest surface of the link on which there is enough space with all joints at rest.

        Args:
            container: The asset with the drawer or the shelf.
            link: Link of the container that carries it, such as `drawer_0`, or `body` for shelves.
            category: Category of the asset.
            at: Share of the possible places to its left.
            deep: Share of the possible places behind it.
            turn: Angle about its vertical axis [rad].
            free: Whether it is a free body in simulation.
            name: Name in the scene; by default the category and a number.
            overrides: Parameters of the asset.

        Raises:
            ParameterError: There is no such space, or the asset would tip over.
        """
        _check_shares(at, deep)
        self._check_here("container", container)
        name, asset = self._drawn(category, name, overrides)
        spin = turned(turn)
        low, high = _moved_box(asset, spin)
        place = _place_in(container.asset, link, high - low, (at, deep))
        if place is None:
            size = " x ".join(f"{length:.3f}" for length in high - low)
            raise ParameterError(f"{name!r} of {size} m does not fit into {link!r} of {container.name!r}")
        shift = translation(place + (0.0, 0.0, STANDING) - (*(low + high)[:2] / 2.0, low[2]))
        if free:
            _check_standing(name, asset)
        return self._keep(
            Placement(name, asset, container.pose @ shift @ spin, f"{container.name}_{link}", free)
        )

    def add(
        self, category: str, pose: Array, *, free: bool = False, name: str = "", **overrides: Any
    ) -> Placement:
        """Place an asset at a pose, shape (4, 4), such as a cooktop in a hole of a worktop.

        A free body in simulation stands on the floor there. The other arguments are those of `against`.
        """
        name, asset = self._drawn(category, name, overrides)
        if free:
            _check_standing(name, asset)
        return self._keep(Placement(name, asset, pose, free=free))

    def inset(
        self,
        wall: Wall,
        category: str,
        *,
        at: float,
        z: float = 0.0,
        turn: float = 0.0,
        name: str = "",
        **overrides: Any,
    ) -> Placement:
        """Place an asset in an opening of a wall that is cut to its size: a door or a window.

        Args:
            wall: The wall.
            category: Category of the asset.
            at: Distance of its left side from the left end of the wall, seen from the room [m].
            z: Height of its bottom above the floor [m].
            turn: Angle about its vertical axis: by 0 its front, on the outside of a door or window, faces the
                room; by pi its back with the handles of a window [rad].
            name: Name in the scene; by default the category and a number.
            overrides: Parameters of the asset.

        Raises:
            ParameterError: The asset does not fit; the message has the length that is missing.
        """
        placed = self._placed(wall, category, at, z, name, overrides, inset=True, turn=turn)
        self._holes[wall] += _openings(placed)
        return placed

    def slab(
        self,
        label: str,
        low: Sequence[float],
        high: Sequence[float],
        material: Material,
        *,
        wall: Wall | Line | None = None,
    ) -> Placement:
        """Add a board, such as a worktop or a filler, between two corners [m].

        The arguments are those of `fixture`.
        """
        bevel = min(0.003, *(0.1 * abs(end - start) for start, end in zip(low, high, strict=True)))
        return self.fixture(
            label, lambda: part(Region.between(low, high).box(bevel=bevel), label, material), wall=wall
        )

    def fixture(self, name: str, make: Callable[[], Body], *, wall: Wall | Line | None = None) -> Placement:
        """Add a body without joints that belongs to the room: a worktop, a sink, a hood.

        Args:
            name: Its name; a number is added if the scene has that name.
            make: Makes the body, in the coordinates of the room or of a wall, see `frame`.
            wall: The wall in whose coordinates the body is made.
        """
        unique = self._unused("", name)

        @generator
        def fixture() -> Body:
            return make()

        made = replace(fixture.generate(certify=False), name=unique, category=name, parameters={})
        pose = np.eye(4) if wall is None else self.frame(wall)[0]
        return self._keep(Placement(unique, made, pose))

    def build(
        self,
        *,
        category: str = "scene",
        seed: int | None = None,
        attempt: int = 0,
        parameters: Mapping[str, Any] | None = None,
    ) -> Asset:
        """Join all to one asset and prove that nothing collides in any state of all joints.

        A joint that meets another asset at rest is narrowed; of two joints that meet each other, one
        depends on the other one then, see `artgen.proof.limits.separated`.

        Args:
            category: Category of the scene.
            seed: Seed of the scene, if it is not that of its assets.
            attempt: Number of draws before this one.
            parameters: Parameters that the scene records; by default the names of its assets.

        Raises:
            AssetError: No limits and dependencies prevent a collision, a joint would keep too little of its
                range, or the links of one asset are not proven apart.
        """
        whole = replace(
            _joined(self.name, category, self._room(), self.placed),
            seed=self.seed if seed is None else seed,
            attempt=attempt,
            detail=self.detail,
            parameters=parameters or {each.name: each.asset.name for each in self.placed},
        )
        owners = {f"{each.name}_{link.name}": each.name for each in self.placed for link in each.asset.links}
        _check_rest(whole, owners)

        def apart(joint_path: JointPath) -> bool:
            """Tell whether the links belong to two assets, or to one and the room."""
            first, second = map(owners.get, joint_path.links)
            return first != second

        known = Known()
        whole = _check_ranges(separated(whole, apart, known), whole)
        certificate = certify(whole, known=known)
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
        name = self._unused(name, category)
        known = self._known.get(name)
        if known is None or known[:2] != (category, overrides):
            seed = zlib.crc32(f"{self.seed}/{name}".encode())
            asset = find(category).generate(seed, detail=self.detail, **overrides)
            known = self._known[name] = (category, overrides, asset)
        return name, known[2]

    def _unused(self, name: str, category: str) -> str:
        """Return a name that the scene does not have yet; by default the category and a number."""
        if not name:
            category = category if is_identifier(category) else find(category).name  # of a file
            number = sum(each.asset.category == category for each in self.placed)
            name = f"{category}_{number}" if number else category
        check_name(name)
        if name in {each.name for each in self.placed}:
            raise ParameterError(f"the scene {self.name!r} has an asset {name!r} already; give another name")
        return name

    def _check_here(self, what: str, placed: Any) -> None:
        """Check that something was placed in this scene."""
        if not any(each is placed for each in self.placed):
            given = f"{placed.name!r} of another scene" if isinstance(placed, Placement) else repr(placed)
            raise ParameterError(
                f"{what} = {given} is not in scene {self.name!r}; give a placement that `against` or another "
                "method of this scene returned"
            )

    def _keep(self, placed: Placement) -> Placement:
        self.placed.append(placed)
        return placed

    def _room(self) -> Asset:
        """Return the room itself: floor, and walls with their openings."""
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
            solids = []
            for wall, region in walls.items():
                solid = region.box()
                for low, high in self._holes[wall]:
                    hole = Region.between(low - STANDING, high + STANDING)
                    across = {"x" if wall != "back" else "y": 2.0 * WALL}
                    solid = solid - hole.grow(**across).box()
                solids.append(solid)
            # one solid: walls that touch would be read back from their mesh as other solids
            around = part(reduce(or_, solids), "wall", self._paint)
            return weld(part(ground.box(), "floor", self._floor, name="room"), around)

        return room.generate(certify=False)


def check_length(what: str, value: Any, least: float, most: float = math.inf) -> None:
    """Check that a value is a finite length in a range [m]."""
    if not (is_number(value) and math.isfinite(value) and least - _SLACK <= value <= most):
        limits = f"{least:g} to {most:g} m" if most < math.inf else f"at least {least:g} m"
        raise ParameterError(f"{what} is {limits}, not {value!r}")


def _check_shares(at: Any, deep: Any) -> None:
    for name, value in (("at", at), ("deep", deep)):
        if not (is_number(value) and 0.0 <= value <= 1.0):
            raise ParameterError(f"{name} must be a share of 0 to 1, got {value!r}")


def turned(angle: float) -> Array:
    """Return a turn about the vertical axis, shape (4, 4)."""
    return affine(rotation(np.array([0.0, 0.0, 1.0]), angle))


def _moved_box(asset: Asset, pose: Array) -> Array:
    """Return the corners of the box around the box of an asset at a pose, shape (2, 3) [m]."""
    corners = box_corners(asset.bounds(), pose)
    return np.array([corners.min(axis=0), corners.max(axis=0)])


def _base_of(placed: Placement) -> str:
    return f"{placed.name}_{placed.asset.links[0].name}"


def _check_standing(name: str, asset: Asset) -> None:
    """Check that the center of mass of an asset lies over the area on which it stands, with a margin."""
    from scipy.spatial import ConvexHull  # `artgen list` and wrong names import scenes and start without it

    points = np.concatenate([each.mesh.vertices for link in asset.links for each in link.surfaces])
    foot = np.unique(np.round(points[points[:, 2] < points[:, 2].min() + _SOLE][:, :2], 6), axis=0)
    middle = asset.mass_properties().center
    area = ConvexHull(foot).equations if len(foot) > 2 else np.zeros((1, 3))
    margin = -(area[:, :2] @ middle[:2] + area[:, 2]).max()
    if margin < _TILT * (middle[2] - points[:, 2].min()):
        raise ParameterError(
            f"{name!r} would tip over: its center of mass is {1e3 * margin:.1f} mm inside the area on which "
            f"it stands, and {1e3 * middle[2]:.0f} mm high; choose another seed, or free=False"
        )


def _place_in(asset: Asset, link: str, size: Array, shares: tuple[float, float]) -> Array | None:
    """Return the middle of a free place of a size on the lowest surface of a link that has one, if any."""
    carrier = asset.link(link)
    low, high = carrier.bounds()
    x, y = (np.arange(start + _CELL / 2.0, end, _CELL) for start, end in zip(low[:2], high[:2], strict=True))
    columns = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    need = [math.ceil((length + 2.0 * _CLEAR) / _CELL) for length in size[:2]]
    if need[0] > len(x) or need[1] > len(y):
        return None
    pieces = [(each is carrier, collider.convex) for each in asset.links for collider in each.colliders]
    own = np.array([of_carrier for of_carrier, _ in pieces])
    bottoms, tops = np.array([convex.faces.spans(columns) for _, convex in pieces]).swapaxes(0, 1)
    levels = np.unique(np.round(tops[own], 4))
    for level in levels[np.isfinite(levels)]:
        stands = (abs(tops[own] - level) < _LEVEL).any(axis=0)
        blocked = ((tops > level + _LEVEL) & (bottoms < level + size[2] + _CLEAR)).any(axis=0)
        free = (stands & ~blocked).reshape(len(x), len(y))
        windows = np.lib.stride_tricks.sliding_window_view(free, need).all(axis=(2, 3))
        places = np.argwhere(windows)
        if len(places):
            first, last = places.min(axis=0), places.max(axis=0)
            wish = first + np.array([shares[0], 1.0 - shares[1]]) * (last - first)
            i, j = places[abs(places - wish).sum(axis=1).argmin()]
            return np.array([x[i] + (need[0] - 1) * _CELL / 2.0, y[j] + (need[1] - 1) * _CELL / 2.0, level])
    return None


def _level_under(asset: Asset, box: Array, middle: Array) -> float | None:
    """Return the height of the highest surface under a box on all sides of a point, or None [m]."""
    x, y = (np.linspace(start, end, math.ceil((end - start) / _FINE) + 1) for start, end in box.T)
    columns = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    pieces = [each.convex for link in asset.links for each in link.colliders]
    tops = np.max([convex.faces.spans(columns)[1] for convex in pieces], axis=0)
    level = float(tops.max())
    held = columns[tops > level - _LEVEL] - middle
    around = [held[:, 0] <= 0.0, held[:, 0] >= 0.0, held[:, 1] <= 0.0, held[:, 1] >= 0.0]
    return level if math.isfinite(level) and all(each.any() for each in around) else None


def _openings(placed: Placement) -> list[Array]:
    """Return the boxes that a wall must leave free for an asset: a sill is wider than its window."""
    colliders = [
        each.convex.transformed(placed.pose) for link in placed.asset.links for each in link.colliders
    ]
    boxes = np.array([each.bounds() for each in colliders])
    low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
    upper = boxes[boxes.mean(axis=1)[:, 2] > low[2] + 0.2 * (high[2] - low[2])]
    least, most = upper[:, 0].min(axis=0), upper[:, 1].max(axis=0)
    wide = boxes[((boxes[:, 0] < least - _SLACK) | (boxes[:, 1] > most + _SLACK))[:, :2].any(axis=1)]
    if not len(wide):
        return [np.array([low, high])]
    top = wide[:, 1, 2].max()
    return [np.array([[*least[:2], low[2]], most]), np.array([low, [high[0], high[1], top]])]


def _check_rest(asset: Asset, owners: Mapping[str, str]) -> None:
    """Check that no two assets overlap at rest; the proof has no pairs of links that never move."""
    solids = [(owners.get(link.name), each.solid) for link in asset.links for each in link_parts(link)]
    boxes = np.array([box_of(solid) for _, solid in solids])
    for index, (owner, solid) in enumerate(solids):
        low, high = boxes[:index].swapaxes(0, 1)
        for other in np.flatnonzero(
            (low < boxes[index, 1]).all(axis=1) & (high > boxes[index, 0]).all(axis=1)
        ):
            if owner != solids[other][0] and (solid ^ solids[other][1]).volume() > _OVERLAP:
                names = " and ".join(repr(each or "room") for each in (solids[other][0], owner))
                raise AssetError(f"scene {asset.name!r}: {names} overlap; place them farther apart")


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


def _distinct(placed: Placement, known: dict[str, Material]) -> dict[Material, Material]:
    """Return new materials for those whose names others have, and that shine; add all to the known ones."""
    result = {}
    shining = {output.material for output in placed.asset.outputs}
    for each in placed.asset.materials:
        if known.setdefault(each.name, each) != each or each.name in shining:
            result[each] = each.with_(name=f"{placed.name}_{each.name}")
    return result


def _joined(name: str, category: str, room: Asset, placed: Collection[Placement]) -> Asset:
    """Return one asset of a room and the assets in it, each fixed to what carries it by a locked joint."""
    links, joints, contacts = list(room.links), list(room.joints), list(room.contacts)
    loops, outputs = list(room.loops), list(room.outputs)
    base, materials = links[0].name, {each.name: each for each in room.materials}
    for each in placed:
        prefix = f"{each.name}_"
        of_links = {link.name: prefix + link.name for link in each.asset.links}
        of_joints = {joint.name: prefix + joint.name for joint in each.asset.joints}
        repaint = _distinct(each, materials)
        links += [
            RepaintedLink.of(link, materials=repaint)
            .moved(each.pose)
            .renamed(partial(add, prefix), of_joints)
            for link in each.asset.links
        ]
        up, root = np.array([0.0, 0.0, 1.0]), of_links[each.asset.links[0].name]
        place = AssetJoint(place_of(each.name), "prismatic", up, each.pose[:3, 3], (0.0, 0.0), child=root)
        joints.append(replace(place, parent=each.carrier or base))
        for joint in each.asset.joints:
            moved = joint.moved(each.pose).renamed(of_joints)
            joints.append(replace(moved, parent=of_links[joint.parent], child=of_links[joint.child]))
        contacts += [contact.renamed(of_links, of_joints) for contact in each.asset.contacts]
        loops += [loop.moved(each.pose).renamed(of_links, of_joints) for loop in each.asset.loops]
        painted = {old.name: new.name for old, new in repaint.items()}
        outputs += [one.renamed(prefix + one.name, of_joints, painted) for one in each.asset.outputs]
    labels = {label for each in placed for label in each.asset.labels}
    labels |= {label for link in links for label in link.labels}
    return Asset(
        name,
        category,
        ByName(links),
        ByName(joints),
        version=room.version,
        labels=tuple(sorted(labels)),
        contacts=tuple(contacts),
        loops=tuple(loops),
        outputs=tuple(outputs),
        loose=tuple(_base_of(each) for each in placed if each.free),
        placed=tuple(each.record() for each in placed),
    )
