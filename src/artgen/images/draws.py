"""Random poses, cameras, lights and surroundings of pictures.

A camera's axes are those of OpenCV: x to the right of the picture, y down, z forward. A pixel at column i and
row j spans i..i+1 and j..j+1, so its center lies at (i + 0.5, j + 0.5), as for the boxes of COCO.
"""

import colorsys
import math
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, affine
from artgen.asset import Asset
from artgen.asset.placed import owners_of
from artgen.export.frames import Region, intersection, leader_of, regions
from artgen.view.camera import VIEWS, Camera, View, box_corners

if TYPE_CHECKING:
    from artgen.images.plan import ImagePlan

Color = tuple[float, float, float]  # red, green and blue, 0-1
Surroundings = Mapping[str, tuple[str, ...]]  # materials of the floors and walls for the pictures of an asset

# materials of random floors and walls
FLOORS = (
    "oak_boards", "walnut_boards", "pine", "marble", "floor_tiles", "black_granite", "linen", "canvas", "mdf",
)  # fmt: skip
WALLS = ("linen", "marble", "plywood", "cardboard", "fabric", "beech", "mdf", "wall_tiles")

_HIGH = 1.0  # least elevation of the lamp of a room: it shines over the walls [rad]
_SCATTERED, _DIRECT = 1.3, 0.75  # factors of ambient light and of the lamp in a room
CLEAR = 0.1  # between a camera in a room and all assets [m]
_PLAIN_SKY = (0.80, 0.80, 0.80)

_ASIDE = 0.7  # largest shift of the asset off the center, over the free width beside it
_MOVED = 0.7  # share of the joints that are away from rest
_FREED = 0.7  # probability that a blocking joint is moved instead of the blocked joint
_ROUNDS = 8  # rounds of freeing blocked joints

_VIEWS = 200  # tries of a camera that stands free in a room
_LOOKED, _SEEN = 60, 0.6  # points of an asset that are looked at, and least share that is not hidden
_AROUND = 2.0  # largest distance of other assets in a picture from the middle of that in its center [m]
# from the corners of a room to its cameras, which also stand before its open side [m]
_AIR = np.array([[0.3, -1.5, 0.3], [-0.3, -0.3, -0.1]])


def random_positions(asset: Asset, draw: np.random.Generator) -> dict[str, float]:
    """Return positions of the free joints that satisfy all dependencies [rad or m].

    Most joints stand anywhere between their limits, some at rest. For a blocked joint, either the blocking
    joint is moved (the door for a rack), or the joint is put back. A certified asset has no collision there.
    """
    closed = {joint.name: joint.closed for joint in asset.free_joints}
    limits = {joint.name: joint.limits or (-math.pi, math.pi) for joint in asset.free_joints}
    leaders = {joint.name: leader_of(asset, joint)[0] for joint in asset.joints}
    q = {name: float(draw.uniform(low, high)) for name, (low, high) in limits.items()}
    moved = _MOVED * (float(draw.random()) if asset.placed else 1.0)  # few rooms have everything open
    q |= {name: closed[name] for name in closed if draw.random() > moved}
    freed = {joint.name: draw.random() < _FREED for joint in asset.joints}

    def back(name: str) -> dict[str, float]:
        return {leader: closed[leader] for leader in (leaders[name],) if leader in closed}

    for _ in range(_ROUNDS):
        for name in asset.blocked(q):
            q |= (_freeing(asset, name, limits, draw) if freed[name] else {}) or back(name)
    # joints that are still blocked go back, which may block others: repeat until nothing changes
    while blocked := [name for name in asset.blocked(q) if not back(name).items() <= q.items()]:
        for name in blocked:
            q |= back(name)
    return closed if asset.blocked(q) else q


def _freeing(asset: Asset, name: str, limits: Region, draw: np.random.Generator) -> dict[str, float]:
    """Return positions of other joints that free a joint; empty if there are none within the limits."""
    needs = asset.joint(name).needs
    assert needs is not None
    boxes = [
        intersection([region, {each: limits[each] for each in region}])
        for region in regions(asset, needs.condition)
        if region.keys() <= limits.keys()
    ]
    boxes = [box for box in boxes if all(low < high for low, high in box.values())]
    if not boxes:
        return {}
    box = boxes[int(draw.integers(len(boxes)))]
    return {each: float(draw.uniform(low, high)) for each, (low, high) in box.items()}


def random_camera(points: Array, plan: "ImagePlan", draw: np.random.Generator) -> Camera:
    """Return a camera with all points in its square picture, slightly off center."""
    low, high = (math.sin(angle) for angle in plan.elevation)
    elevation = math.asin(draw.uniform(low, high))
    azimuth = float(draw.uniform(-plan.azimuth, plan.azimuth))
    camera = View(
        azimuth, elevation, float(draw.uniform(*plan.field_of_view)), float(draw.uniform(*plan.margin))
    ).camera(points)
    seen = camera.pixels(points, (1, 1))  # in fractions of the picture
    free = np.clip(np.minimum(seen.min(axis=0), 1.0 - seen.max(axis=0)), 0.0, 1.0)
    across, up = draw.uniform(-_ASIDE, _ASIDE, 2) * free
    right, above, forward = camera.axes()
    depth = float(((points - camera.position) @ forward).min())  # the nearest points move farthest
    move = 2.0 * depth * math.tan(camera.field_of_view / 2.0) * (across * right + up * above)
    if camera.position[2] + move[2] < float(points[:, 2].min()) + 0.02 * depth:
        move[2] = 0.0  # never below the floor
    return replace(
        camera, position=tuple(camera.position + move), target=tuple(np.array(camera.target) + move)
    )


def camera_in(
    asset: Asset,
    poses: Mapping[str, Array],
    points: Mapping[str, Array],
    plan: "ImagePlan",
    draw: np.random.Generator,
) -> Camera:
    """Return a random camera for an asset; `points` has the vertices of each link at its pose.

    A room is seen from its inside or from before its open side. The camera looks at an asset that nothing
    hides, large ones more often, and at those around it; its angles are relative to the front of this asset.
    """
    everything = np.concatenate(list(points.values()))
    if not asset.placed:
        return random_camera(everything, plan, draw)
    owners = owners_of(asset)
    boxes = {name: (each.min(axis=0), each.max(axis=0)) for name, each in points.items()}
    solids = [
        (owners[link.name], box_corners(each.convex.bounds(), poses[link.name]))
        for link in asset.links
        for each in link.colliders
    ]
    corners, of_solids = np.array([each for _, each in solids]), np.array([owner for owner, _ in solids])
    lows, highs = corners.min(axis=1), corners.max(axis=1)
    low, high = asset.links[0].bounds() + _AIR
    of_placed = [
        np.concatenate([each for name, each in points.items() if owners[name] == placed.name])
        for placed in asset.placed
    ]
    sizes = np.array([np.linalg.norm(np.ptp(each, axis=0)) for each in of_placed])
    for _ in range(_VIEWS):
        number = int(draw.choice(len(sizes), p=sizes / sizes.sum()))
        chosen, own = asset.placed[number], of_placed[number]
        middle, reach = (own.min(axis=0) + own.max(axis=0)) / 2.0, _AROUND * float(draw.random())
        near = [
            points[name]
            for name, box in boxes.items()
            if owners[name] and np.linalg.norm(np.clip(middle, *box) - middle) < reach
        ]
        turn = affine(chosen.pose[:3, :3])
        camera = random_camera(np.concatenate([own, *near]) @ turn[:3, :3], plan, draw).moved(turn)
        at, others = np.array(camera.position), of_solids != chosen.name
        free = ((at < lows - CLEAR) | (at > highs + CLEAR)).any(axis=1)
        if not (free.all() and (low < at).all() and (at < high).all()):
            continue
        seen = _unhidden(at, own[:: max(1, len(own) // _LOOKED)], lows[others], highs[others])
        if seen.mean() > _SEEN:
            return camera
    return VIEWS["room"].camera(everything)


def _unhidden(at: Array, points: Array, lows: Array, highs: Array) -> NDArray[np.bool_]:
    """Tell for each point whether no box hides it from a place."""
    way = points - at
    way = np.where(abs(way) < 1e-9, 1e-9, way)[:, None]
    ends = np.sort([(lows - at) / way, (highs - at) / way], axis=0)
    enters, leaves = ends[0].max(axis=2), ends[1].min(axis=2)
    hidden: NDArray[np.bool_] = ((enters < leaves) & (leaves > 0.0) & (enters < 0.99)).any(axis=1)
    return ~hidden


def intrinsics(camera: Camera, size: int) -> Array:
    """Return the camera matrix, from camera coordinates to pixels, shape (3, 3)."""
    focal = size / (2.0 * math.tan(camera.field_of_view / 2.0))
    return np.array([[focal, 0.0, size / 2.0], [0.0, focal, size / 2.0], [0.0, 0.0, 1.0]])


def extrinsics(camera: Camera) -> Array:
    """Return the transform from asset to camera coordinates, shape (4, 4) [m]."""
    right, up, forward = camera.axes()
    turn = np.array([right, -up, forward])
    return affine(turn, -turn @ np.array(camera.position))


@dataclass(frozen=True)
class Light:
    """Light of one picture: ambient light, and a distant lamp that casts shadows."""

    azimuth: float = -0.6  # direction to the lamp: 0 is the camera, a quarter turn its right side [rad]
    elevation: float = 0.9  # angle of the lamp above the horizon [rad]
    directional: float = 0.55  # strength of the lamp
    ambient: float = 0.45  # strength of the ambient light
    color: Color = (1.0, 1.0, 1.0)  # color of the lamp
    spread: float = 0.05  # angular width of the lamp, which blurs its shadows [rad]

    def direction(self, aside: tuple[float, float] = (0.0, 0.0)) -> Array:
        """Return the unit direction to a point of the lamp, in coordinates that turn with the camera."""
        turn = self.azimuth + 2.0 * self.spread * (aside[0] - 0.5)
        high = self.elevation + 2.0 * self.spread * (aside[1] - 0.5)
        level = math.cos(high)
        return np.array([level * math.sin(turn), -level * math.cos(turn), math.sin(high)])

    def to_data(self) -> dict[str, Any]:
        """Return the light as JSON data."""
        data = asdict(self) | {"color": list(self.color)}
        del data["spread"]
        return data


@dataclass(frozen=True)
class Setting:
    """Light and surroundings of one picture."""

    light: Light
    horizon: Color  # color of the sky at the horizon and below
    zenith: Color  # color of the sky at the zenith
    floor: int  # index of the floor; -1 for none
    floor_tint: Color  # factor of its colors
    floor_turn: float  # rotation about z [rad]
    wall: int  # index of the wall behind the asset; -1 for none
    wall_tint: Color  # factor of its colors
    wall_turn: float  # rotation about z [rad]
    wall_distance: float  # distance from the center of the asset, relative to its radius


def random_surroundings(random: Collection[str], draw: np.random.Generator) -> Surroundings:
    """Return the materials of three random floors and walls for an asset, as far as they vary."""
    floors = tuple(str(each) for each in draw.choice(FLOORS, 3, replace=False))
    walls = tuple(str(each) for each in draw.choice(WALLS, 3, replace=False))
    return {"floor": floors if "floor" in random else (), "wall": walls if "backdrop" in random else ()}


def random_setting(
    around: Surroundings, random: Collection[str], draw: np.random.Generator, *, room: bool = False
) -> Setting:
    """Return random light and surroundings of a picture; parts that do not vary are plain."""
    light = _random_light(draw) if "light" in random else Light()
    if room:
        elevation, direct = max(light.elevation, _HIGH), _DIRECT * light.directional
        light = replace(light, elevation=elevation, directional=direct, ambient=_SCATTERED * light.ambient)
    plain = "backdrop" not in random
    horizon, zenith = (_PLAIN_SKY,) * 2 if plain else (_random_color(draw), _random_color(draw))
    floors, walls = len(around["floor"]), len(around["wall"])
    wall = int(draw.integers(2 * walls)) if walls else -1  # half of the pictures have none
    return Setting(
        light,
        horizon,
        zenith,
        floor=int(draw.integers(floors)) if floors else -1,
        floor_tint=_random_tint(draw),
        floor_turn=float(draw.uniform(-math.pi, math.pi)),
        wall=wall if wall < walls else -1,
        wall_tint=_random_tint(draw),
        wall_turn=float(draw.uniform(-0.7, 0.7)),
        wall_distance=float(draw.uniform(1.3, 4.0)),
    )


def _random_light(draw: np.random.Generator) -> Light:
    directional = float(draw.uniform(0.25, 0.8))
    warmth = float(draw.uniform(-0.12, 0.12))
    return Light(
        azimuth=float(draw.uniform(-2.4, 2.4)),
        elevation=float(draw.uniform(0.45, 1.4)),
        directional=directional,
        ambient=float(draw.uniform(0.8, 1.05)) - 0.8 * directional,
        color=(1.0 + min(warmth, 0.0), 1.0 - 0.4 * abs(warmth), 1.0 - max(warmth, 0.0)),
        spread=float(draw.uniform(0.01, 0.05)),
    )


def _random_color(draw: np.random.Generator) -> Color:
    hue, saturation = draw.uniform(0.0, 1.0), 0.5 * draw.uniform(0.0, 1.0) ** 2
    return colorsys.hsv_to_rgb(hue, saturation, draw.uniform(0.25, 0.95))


def _random_tint(draw: np.random.Generator) -> Color:
    red, green, blue = draw.uniform(0.75, 1.0) * draw.uniform(0.85, 1.0, 3)
    return float(red), float(green), float(blue)
