"""Range of a joint through which a hand that grasps or pushes a link can move before it strikes something."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.affordance import GRIPPER, Affordance
from artgen.validate.hands.space import HandSpace, Touch
from artgen.validate.hands.states import Opened, standing

_STEPS = 16  # positions from rest to either end of a range at which the hand is tested
_TURN = math.pi  # range of a joint without limits, in each direction [rad or m]
_STEP = 1e-3  # share of the range over which the motion of a point is measured
_BACK = 0.100  # length of the pushing finger [m]


@dataclass(frozen=True)
class Reach:
    """Range through which a hand moves a joint.

    Attributes:
        share: Share of the range, 0-1.
        part: Striking part of the hand: a finger or the hand behind it.
        touch: The obstacle.
        pose: Joint positions at the contact [rad or m].
    """

    share: float
    part: str = ""
    touch: Touch | None = None
    pose: Mapping[str, float] = field(default_factory=dict)


def reach_of(space: HandSpace, affordance: Affordance, joint: str, opened: Opened) -> Reach:
    """Return how far a hand moves a joint while the other joints stand where it is free to move.

    Args:
        space: The solids.
        affordance: The grasp or push; the hand moves with the link.
        joint: Name of a free joint.
        opened: Joints that were opened for the approach.
    """
    asset = space.asset
    held = standing(asset, joint, opened)
    if held is None:
        return Reach(0.0)
    boxes = _closed_hand(space, affordance)
    low, high = _range(asset, joint)
    closed = asset.joint(joint).closed
    free, struck = 0.0, Reach(1.0)
    for end in (low, high):
        if end == closed:
            continue
        for step in range(1, _STEPS + 1):
            q = {**held, joint: closed + (end - closed) * step / _STEPS}
            found = next(_touches(space, affordance, boxes, q), None)
            if found is not None:
                struck = Reach(0.0, *found, q)
                break
            free += abs(end - closed) / _STEPS
    return Reach(min(free / (high - low), 1.0), struck.part, struck.touch, struck.pose)


def tendency(asset: Asset, push: Affordance, joint: str) -> float:
    """Return the cosine between a push and the motion of its point when a joint leaves its closed position.

    If the joint can move in both directions, the better one counts.
    """
    closed = asset.joint(joint).closed
    low, high = _range(asset, joint)
    rest, best = _point(asset, push, {joint: closed}), -1.0
    for end in (low, high):
        way = _point(asset, push, {joint: closed + _STEP * (end - closed)}) - rest
        length = float(np.linalg.norm(way))
        if length > 0.0:
            best = max(best, float(way @ push.frame[:3, 2]) / length)
    return best


def _point(asset: Asset, push: Affordance, q: Mapping[str, float]) -> Array:
    pose = asset.pose(q)[push.link]
    return np.asarray(pose[:3, :3] @ push.frame[:3, 3] + pose[:3, 3])


def _range(asset: Asset, joint: str) -> tuple[float, float]:
    return asset.joint(joint).limits or (-_TURN, _TURN)


def _closed_hand(space: HandSpace, affordance: Affordance) -> dict[str, Array]:
    """Return the boxes of a gripper closed on its link as corners; none for a finger."""
    if affordance.kind == "push":
        return {}
    points = space.inside(GRIPPER.between(affordance.width / 2.0), affordance.frame, affordance.link)
    return GRIPPER.blocks(float(points[:, 0].min()), float(points[:, 0].max()))


def _touches(
    space: HandSpace, affordance: Affordance, boxes: Mapping[str, Array], q: Mapping[str, float]
) -> Iterator[tuple[str, Touch]]:
    pose = space.asset.pose(q)
    frame = pose[affordance.link] @ affordance.frame
    if not boxes:
        touch = space.finger_touch(_BACK, frame, pose, affordance.link)
        if touch is not None:
            yield "finger", touch
    for name, corners in boxes.items():
        touch = space.first_touch(corners, frame, pose, affordance.link)
        if touch is not None:
            yield name, touch
