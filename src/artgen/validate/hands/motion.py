"""Hands in motion: contact with solids, positions of other joints, range of a motion, and force.

Forces are computed without a simulator. A slow hand works against dry friction, springs and weight. Damping
and inertia depend on its speed and are left out.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array
from artgen.asset import Asset, AssetCondition, AssetJoint
from artgen.asset.affordance import GRIPPER, Affordance, block, clipped, moved_joints
from artgen.asset.collision import SolidPart, link_parts
from artgen.export.frames import leader_of
from artgen.proof.overlap import LEAST_VOLUME
from artgen.validate.joints import led_by, needed_conditions, state_for

MOST_FORCE = 60.0
"""Largest force of a hand, a finger or a foot [N].

Two rubber pads (friction 0.5) that a Franka hand closes with 70 N slip at about this force.
"""

Opened = Mapping[str, AssetCondition]
"""Regions in which joints are open that were opened for the approach of a hand."""

_BEHIND = 0.020  # search depth for the surface behind the point of a push [m]
_SEGMENTS = 32  # sides of the polygon around a finger
_SLACK = 1e-5  # tolerance of contact along the path of a hand [m]
_WIDE = 0.98  # share of its range from which a joint counts as open
_STEPS = 16  # number of parts of a range at whose ends a hand is tested
# range of a joint without limits, in each direction [rad or m]
_UNLIMITED = {"revolute": math.pi, "prismatic": 0.5}
_STEP = 1e-3  # share of the range over which the motion of a point is measured
_BACK = 0.100  # length of the pushing finger [m]

_GRAVITY = 9.81  # gravity [m/s^2]
_FORCE_STEP = 1e-5  # step by which a joint is moved to measure lever arms [rad or m]
_SHORTEST = 1e-4  # least lever arm of an effective hand [m/rad or m/m]


@dataclass(frozen=True)
class Touch:
    """Contact of a hand."""

    link: str  # name of the link
    label: str  # label of the solid

    def __str__(self) -> str:
        return f"{self.link}/{self.label}"


class HandSpace:
    """Solids of an asset as obstacles of hands, without visual details.

    Methods take a box as opposite corners in a frame, shape (2, 3) [m]; a frame in asset coordinates, shape
    (4, 4) [m]; and the displacement of each link from rest, shape (4, 4) each.
    """

    def __init__(self, asset: Asset) -> None:
        self.asset = asset
        self._parts = {link.name: link_parts(link) for link in asset.links}
        self._boxes = {
            name: np.array([part.solid.bounding_box() for part in parts]).reshape(-1, 2, 3)
            for name, parts in self._parts.items()
        }
        # center and radius of a sphere around the boxes of each link
        self._spheres: dict[str, tuple[Array, float]] = {}
        for name, boxes in self._boxes.items():
            if len(boxes):
                low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
                self._spheres[name] = (low + high) / 2.0, float(np.linalg.norm(high - low)) / 2.0

    @property
    def lowest(self) -> float:
        """Height of the lowest solid at rest [m]."""
        return min(float(boxes[:, 0, 2].min()) for boxes in self._boxes.values() if len(boxes))

    def first_touch(
        self,
        corners: Array,
        frame: Array,
        pose: Mapping[str, Array],
        ignore: str = "",
        *,
        finger: bool = False,
    ) -> Touch | None:
        """Return a solid, not of one link, that a box overlaps, or a finger that fills the box."""
        corners = np.array([corners[0] + _SLACK, corners[1] - _SLACK])
        (low, high), radius = corners[:, 2].tolist(), float(corners[1, 0])
        solid = _rod(low, high, radius)[0] if finger else block(corners, np.eye(4))
        for link, local, near in self._all_near(corners, frame, pose, ignore):
            moved = solid.transform(local[:3])
            for part in near:
                if (part.solid ^ moved).volume() > LEAST_VOLUME:
                    return Touch(link, part.label)
        return None

    def _all_near(
        self, corners: Array, frame: Array, pose: Mapping[str, Array], ignore: str = ""
    ) -> Iterator[tuple[str, Array, list[SolidPart]]]:
        """Yield each link near a box, with the frame in the link's coordinates and the parts near the box."""
        middle = frame[:3, :3] @ ((corners[0] + corners[1]) / 2.0) + frame[:3, 3]
        reach = float(np.linalg.norm(corners[1] - corners[0])) / 2.0
        for link, (center, radius) in self._spheres.items():
            away = pose[link][:3, :3] @ center + pose[link][:3, 3] - middle
            if link == ignore or away @ away > (reach + radius) ** 2:
                continue
            local = np.linalg.inv(pose[link]) @ frame
            if near := self._near(link, corners, local):
                yield link, local, near

    def _near(self, link: str, corners: Array, frame: Array) -> list[SolidPart]:
        """Return the parts of a link whose bounding boxes overlap a box, in both coordinate systems."""
        turn, half = frame[:3, :3], (corners[1] - corners[0]) / 2.0
        middle = turn @ ((corners[0] + corners[1]) / 2.0) + frame[:3, 3]
        boxes = self._boxes[link]
        apart, halves = (boxes[:, 0] + boxes[:, 1]) / 2.0 - middle, (boxes[:, 1] - boxes[:, 0]) / 2.0
        close = (np.abs(apart) < halves + np.abs(turn) @ half).all(axis=1)
        if not close.any():
            return []
        close &= (np.abs(apart @ turn) < halves @ np.abs(turn) + half).all(axis=1)
        return [self._parts[link][index] for index in np.flatnonzero(close)]

    def inside(self, corners: Array, frame: Array, link: str) -> Array:
        """Return the corners of a link's solids at rest inside a box, in the frame, shape (n, 3) [m]."""
        near = self._near(link, corners, frame)
        return clipped([part.solid for part in near], block(corners, frame), frame)

    def others_inside(
        self, corners: Array, frame: Array, pose: Mapping[str, Array], link: str
    ) -> Iterator[tuple[Touch, Array]]:
        """Yield for all links but one the corners of solids inside a box, in its frame, shape (n, 3) [m]."""
        for other, local, parts in self._all_near(corners, frame, pose, link):
            for part in parts:
                points = clipped([part.solid], block(corners, local), local)
                if len(points):
                    yield Touch(other, part.label), points

    def finger_depths(self, frame: Array, pose: Mapping[str, Array], back: float) -> dict[str, float]:
        """Return the depth at which a finger that comes along z first touches each link [m]."""
        rod, corners = _rod(-back, _BEHIND)
        found = {}
        for link, local, near in self._all_near(corners, frame, pose):
            points = clipped((part.solid for part in near), rod.transform(local[:3]), local)
            if len(points):
                found[link] = float(points[:, 2].min())
        return found

    def finger_patch(self, frame: Array, depth: float, gives: float, link: str) -> Array:
        """Return the bounding rectangle of the contact of a finger with a link, in x and y, shape (2, 2) [m].

        The finger gives way by `gives` around the depth of the first contact along z [m].
        """
        rod, corners = _rod(depth - gives, depth + gives)
        near = self._near(link, corners, frame)
        points = clipped((part.solid for part in near), rod.transform(frame[:3]), frame)[:, :2]
        return np.array([points.min(axis=0), points.max(axis=0)])


def _rod(low: float, high: float, radius: float = GRIPPER.finger / 2.0) -> tuple[Manifold, Array]:
    """Return a finger as a polygonal rod along z between two heights [m], and the corners of its box."""
    rod = Manifold.cylinder(high - low, radius, radius, _SEGMENTS).translate((0.0, 0.0, low))
    return rod, np.array([[-radius, -radius, low], [radius, radius, high]])


def positions_to_move(asset: Asset, joint: str, opened: Opened) -> dict[str, float] | None:
    """Return positions of the other joints at which a hand can move a free joint; None if there are none.

    The name of the joint may be empty. `opened` has to be open in addition to the joint's own
    dependencies; its key is empty for the author's condition of the hand.
    """
    conditions = needed_conditions(asset, joint)
    conditions += [condition for name, condition in opened.items() if not name or name != joint]
    return state_for(asset, conditions, ignore=joint, extreme=[each.name for each in asset.joints])


def openable(asset: Asset, affordance: Affordance, struck: str) -> Iterator[tuple[str, AssetCondition]]:
    """Yield joints whose opening may clear the path of a hand from a link, with the regions of open joints.

    These are the joints that move the obstacle, and the other joints that move the link of the hand, such as
    the door of a flap in its inner side or the drawer below a free object. Joints that depend on the joint of
    the hand are excluded: they can be opened only afterwards.
    """
    own = next(iter(affordance.joints), "")
    for name in dict.fromkeys((*moved_joints(asset, struck), *moved_joints(asset, affordance.link))):
        joint = asset.joint(name)
        if name == own or joint.limits is None or own in _awaited(asset, name):
            continue
        low, high = joint.limits
        upward = high - joint.closed >= joint.closed - low
        place = joint.closed + _WIDE * ((high if upward else low) - joint.closed)
        yield name, AssetCondition("above" if upward else "below", name, place)


def _awaited(asset: Asset, joint: str) -> set[str]:
    """Return the free joints that a joint depends on, recursively."""
    found: set[str] = set()
    waiting = [joint]
    while waiting:
        conditions = needed_conditions(asset, waiting.pop())
        names = {name for condition in conditions for name in condition.joints()}
        new = {leader_of(asset, asset.joint(name))[0] for name in names} - found
        waiting += sorted(new)
        found |= new
    return found


@dataclass(frozen=True)
class Reach:
    """Range through which a hand moves a joint."""

    share: float  # share of the range, 0-1
    part: str = ""  # striking part of the hand: a finger or the hand behind it
    touch: Touch | None = None  # the obstacle
    pose: Mapping[str, float] = field(default_factory=dict)  # joint positions at the contact [rad or m]


def reach_of(space: HandSpace, affordance: Affordance, joint: str, opened: Opened) -> Reach:
    """Return how far a hand moves a free joint while the other joints stand where it is free to move."""
    asset = space.asset
    held = positions_to_move(asset, joint, opened)
    if held is None:
        return Reach(0.0)
    boxes = {"finger": _rod(-_BACK, 0.0)[1]}
    if affordance.kind == "grasp":  # a gripper that is closed on its link
        points = space.inside(GRIPPER.between(affordance.width / 2.0), affordance.frame, affordance.link)
        boxes = GRIPPER.blocks(float(points[:, 0].min()), float(points[:, 0].max()))
    low, high = _range(asset.joint(joint))
    closed = asset.joint(joint).closed
    free, struck = 0.0, Reach(1.0)
    for end in (low, high):
        if end == closed:
            continue
        for step in range(1, _STEPS + 1):
            q = {**held, joint: closed + (end - closed) * step / _STEPS}
            pose = asset.pose(q)
            frame = pose[affordance.link] @ affordance.frame
            touches = (
                (name, space.first_touch(box, frame, pose, affordance.link, finger=affordance.kind == "push"))
                for name, box in boxes.items()
            )
            part, touch = next((each for each in touches if each[1] is not None), ("", None))
            if touch is not None:
                struck = Reach(0.0, part, touch, q)
                break
            free += abs(end - closed) / _STEPS
    return Reach(min(free / (high - low), 1.0), struck.part, struck.touch, struck.pose)


def tendency(asset: Asset, push: Affordance, joint: str) -> float:
    """Return the cosine between a push and the motion of its point when a joint leaves its closed position.

    If the joint can move in both directions, the better one counts.
    """
    closed = asset.joint(joint).closed
    positions = [closed, *(closed + _STEP * (end - closed) for end in _range(asset.joint(joint)))]
    rest, *moved = ((asset.pose({joint: at})[push.link] @ push.frame)[:3, 3] for at in positions)
    best = -1.0
    for way in (point - rest for point in moved):
        distance = float(np.linalg.norm(way))
        if distance > 0.0:
            best = max(best, float(way @ push.frame[:3, 2]) / distance)
    return best


def _range(joint: AssetJoint) -> tuple[float, float]:
    return joint.limits or (-_UNLIMITED[joint.kind], _UNLIMITED[joint.kind])


def hand_forces(asset: Asset) -> dict[str, float]:
    """Return the force with which a hand starts each joint and moves it from end to end [N].

    The grasp or push with the smallest force counts, separately for each direction. A direction in which no
    hand can move the joint, such as the return of a button, is left to its spring. At each position, the hand
    needs the force of friction, springs and weight divided by its lever arm.

    Args:
        asset: The asset, in memory or loaded.

    Returns:
        The force by name, for free joints that a grasp or push moves and no motor drives.
    """
    result = {}
    for joint in asset.free_joints:
        hands = [each for each in asset.affordances if joint.name in each.joints]
        if joint.driven or not hands:
            continue
        places = _places(asset, joint)
        forces = [
            min(max(_force(hand, place, way) for place in places) for hand in hands) for way in (1.0, -1.0)
        ]
        reached = [force for force in forces if math.isfinite(force)]
        if reached:
            result[joint.name] = max(reached)
    return result


@dataclass(frozen=True)
class _Place:
    """A joint at one position of its range."""

    load: float  # load of springs and weight towards larger positions [N m or N]
    friction: float  # dry friction of the joint and its followers [N m or N]
    before: Mapping[str, Array]  # displacements of links one step before the position
    behind: Mapping[str, Array]  # the same one step behind it
    apart: float  # motion of the joint between these poses [rad or m]


def _places(asset: Asset, joint: AssetJoint) -> Sequence[_Place]:
    """Return positions along the range of a joint; other joints stand where it may move."""
    held = positions_to_move(asset, joint.name, {}) or {}
    low, high = _range(joint)
    members = led_by(asset, joint)
    clicks = joint.detents.torque if joint.detents else 0.0
    step = min(_FORCE_STEP, 0.25 * (high - low))
    places = []
    for at in np.linspace(low + step, high - step, _STEPS + 1).tolist():
        before, behind = (asset.pose({**held, joint.name: at + side * step}) for side in (-1.0, 1.0))
        rise = (_potential(asset, behind) - _potential(asset, before)) / (2.0 * step)
        springs = sum(law.slope(at) * each.stiffness * (each.rest - law.at(at)) for each, law in members)
        springs += float(joint.closing_force(at))
        friction = clicks + sum(abs(law.slope(at)) * each.friction for each, law in members)
        places.append(_Place(springs - rise, friction, before, behind, 2.0 * step))
    return places


def _potential(asset: Asset, pose: Mapping[str, Array]) -> float:
    """Return the potential energy of the links [J]."""
    heights = (pose[link.name][2] @ [*link.mass_properties.center, 1.0] for link in asset.links)
    masses = (link.mass_properties.mass for link in asset.links)
    return _GRAVITY * float(sum(mass * height for mass, height in zip(masses, heights, strict=True)))


def _force(hand: Affordance, place: _Place, way: float) -> float:
    """Return the force that a hand needs; infinite if it cannot move the joint that way [N]."""
    # a finger pushes along its frame; a gripper pulls along the motion, or turns by opposite forces
    before, behind = (pose[hand.link] @ hand.frame for pose in (place.before, place.behind))
    moved = behind[:3, 3] - before[:3, 3]
    if hand.kind == "push":
        arm = way * float(moved @ before[:3, 2])
    else:
        width = max(hand.width - 2.0 * GRIPPER.clearance, 0.0)
        turned = behind[:3, 0] - before[:3, 0]  # cosine to the direction between the pads
        arm = max(float(np.linalg.norm(moved)), float(np.linalg.norm(turned)) * width)
    if arm < _SHORTEST * place.apart:
        return math.inf
    return max(place.friction - way * place.load, 0.0) * place.apart / arm
