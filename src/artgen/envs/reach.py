"""Stands of a mobile Panda in a room: for each joint a place from which its hand follows the whole way.

The base of the arm is level and has any height above the floor of the room; its footprint is free of all
assets and walls, also along the way. The other joints are closed, or where the joint needs them.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array, FrozenArrays
from artgen.asset import Asset, AssetJoint
from artgen.asset.record import json_text
from artgen.envs.motion import Move, Stage, contact_of
from artgen.envs.placing import Obstacles, hand_fits, place
from artgen.export.files import replaced
from artgen.export.frames import quaternion

FORMAT = "artgen-reach-1"
"""Format of the file of stands."""

WAYS = (1.0, 0.5)
"""Shares of the range of a joint, of which the first one is followed that can be."""

_DIGITS = 6  # decimals of stored numbers: inverse kinematics differs between machines


@dataclass(frozen=True, eq=False)
class Stand(FrozenArrays):
    """A place of a Panda for one joint, or the reason why there is none.

    Attributes:
        joint: Name of the joint.
        hold: Name of the grasp or push by which the hand moves it; empty if there is no place.
        way: Share of the range of the joint that the hand follows, 0-1.
        base: Pose of the base of the arm in the room, shape (4, 4) [m].
        arm: Angles of the arm at the start, shape (7,) [rad].
        start: Positions of other joints that the joint needs [rad or m].
        reason: Why there is no place; empty if there is one.
    """

    joint: str
    hold: str = ""
    way: float = 0.0
    base: Array | None = None
    arm: Array | None = None
    start: Mapping[str, float] | None = None
    reason: str = ""

    def to_data(self) -> dict[str, Any]:
        """Return the stand as JSON data."""
        if self.base is None or self.arm is None:
            return {"joint": self.joint, "reason": self.reason}
        return {
            "joint": self.joint,
            "hold": self.hold,
            "way": self.way,
            "position": np.round(self.base[:3, 3], _DIGITS).tolist(),
            "quaternion": np.round(quaternion(self.base), _DIGITS).tolist(),  # w, x, y, z
            "arm": np.round(self.arm, _DIGITS).tolist(),
            "start": dict(self.start or {}),
        }


def hand_joints(asset: Asset) -> list[AssetJoint]:
    """Return the joints that a hand moves: free, without a motor, and with a grasp or a push."""
    held = {name for each in asset.affordances for name in each.joints}
    return [joint for joint in asset.free_joints if joint.name in held and not joint.driven]


def stands(asset: Asset, seed: int = 0) -> Iterator[Stand]:
    """Yield a stand for each joint that a hand moves.

    Args:
        asset: A room, or another asset on the floor.
        seed: Seed of the search; the result depends on it and on the asset.
    """
    obstacles = Obstacles(asset)
    for number, joint in enumerate(hand_joints(asset)):
        yield _stand(obstacles, joint, np.random.default_rng((seed, number)))


def write_stands(asset: Asset, found: Sequence[Stand], path: Path) -> Path:
    """Write the stands of an asset to a JSON file, and return its path."""
    data = {
        "format": FORMAT,
        "asset": asset.name,
        "robot": "Franka Panda with its hand; the base of the arm is at `position`, z up, x ahead",
        "stands": [each.to_data() for each in found],
    }
    with replaced(path) as partial:
        partial.write_text(json_text(data), encoding="utf-8")
    return path


def _stand(obstacles: Obstacles, joint: AssetJoint, rng: np.random.Generator) -> Stand:
    asset, start = obstacles.asset, _start(obstacles.asset, joint)
    if start is None:
        return Stand(joint.name, reason=f"other joints have to move before it: {joint.needs}")
    low, high = joint.limits or (-math.pi, math.pi)
    far = high if high - joint.closed >= joint.closed - low else low
    holds = [each for each in asset.affordances if joint.name in each.joints]
    holds.sort(key=lambda each: each.joints.index(joint.name))
    fits = False
    for way in WAYS:
        goal = joint.closed + way * (far - joint.closed)
        for each in holds:
            move = Move(joint.name, goal, contact_of(each))
            stage = Stage(joint.name, joint.closed, goal, each, (move,))
            found = place(asset, (stage,), rng, start=start, obstacles=obstacles)
            if found is not None:
                return Stand(joint.name, each.name, way, found.base, found.arm, start)
            fits = fits or hand_fits(obstacles, stage, start)
    why = "from no place that was tried, the arm follows half of its way"
    return Stand(joint.name, reason=why if fits else "the hand would touch what is around the part")


def _start(asset: Asset, joint: AssetJoint) -> dict[str, float] | None:
    """Return positions of other joints at which a joint is free to move; None if they are not found."""
    rest = asset.positions()
    if joint.needs is None or joint.needs.condition.holds(rest):
        return {}
    result: dict[str, float] = {}
    for term in joint.needs.condition.comparisons():
        other = asset.joint(term.joint)
        if other.follows is None and other.limits is not None:
            result[other.name] = other.limits[1] if term.kind == "above" else other.limits[0]
    free = joint.needs.condition.holds(asset.positions(result)) and not asset.blocked(result)
    return result if free else None
