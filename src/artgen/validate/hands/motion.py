"""How far a hand that holds or pushes a link can move a joint before it strikes something."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.affordance import Affordance
from artgen.asset.gripper import GRIPPER
from artgen.validate.hands.space import HandSpace, Touch
from artgen.validate.hands.states import Opened, standing

_STEPS = 16  # positions from rest to either end of a range at which the hand is tried
_TURN = math.pi  # how far a joint without limits is moved either way [rad or m]
_STEP = 1e-3  # share of the range over which the way of a point is looked at
_BACK = 0.100  # length of the finger that pushes [m]


@dataclass(frozen=True)
class Reach:
    """How far a hand moves a joint.

    Attributes:
        share: Share of the range through which the hand moves it, 0-1.
        part: What of the hand strikes something: a finger or the hand behind it.
        touch: What it strikes.
        pose: Joint positions at which it does [rad or m].
    """

    share: float
    part: str = ""
    touch: Touch | None = None
    pose: Mapping[str, float] = field(default_factory=dict)


def reach_of(space: HandSpace, affordance: Affordance, joint: str, opened: Opened) -> Reach:
    """Return how far a hand moves a joint, its other joints held where it is free to move.

    Args:
        space: The solids.
        affordance: What the hand does; it moves along with the link.
        joint: Name of a free joint.
        opened: What was opened for the hand to come.
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
    """Return the cosine between a push and the way that its point goes as a joint leaves its closed position.

    The better of both ways counts, where the joint can go both ways.
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
    """Return the corners of the boxes of a gripper that has closed on its link; none for a finger."""
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
