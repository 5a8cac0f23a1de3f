"""Affordances: frames at which a hand grasps or pushes an asset, and the joints that this moves."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, Self

import numpy as np

from artgen._arrays import Array, FrozenArrays
from artgen.asset.record import Record

if TYPE_CHECKING:
    from artgen.asset.asset import Asset
    from artgen.asset.joint import AssetJoint


@dataclass(frozen=True, eq=False)
class Hold(FrozenArrays, Record):
    """A frame at which a hand acts.

    Attributes:
        name: Identifier, unique on the asset.
        frame: Pose in asset coordinates at rest, z along the approach of the hand, shape (4, 4) [m].
    """

    name: str
    frame: Array

    def moved(self, matrix: Array) -> Self:
        """Return the frame carried along by a rigid motion or a reflection, shape (4, 4)."""
        frame = matrix @ self.frame
        if np.linalg.det(frame[:3, :3]) < 0.0:
            frame[:3, 1] = -frame[:3, 1]
        return replace(self, frame=frame)


@dataclass(frozen=True, eq=False)
class Grasp(Hold):
    """A frame at which a hand grasps: a parallel gripper closes along x.

    Attributes:
        width: Opening of the fingers [m].
    """

    width: float = 0.08


@dataclass(frozen=True, eq=False)
class Push(Hold):
    """A frame at which a finger pushes: the origin lies on the surface, z is the direction of the push."""


@dataclass(frozen=True, eq=False)
class Affordance(FrozenArrays, Record):
    """One action of a hand on an asset.

    Attributes:
        name: Identifier, unique on the asset.
        kind: `grasp`, closing a parallel gripper, or `push`, with a finger.
        link: Name of the touched link.
        frame: Pose in asset coordinates at rest: z along the approach, x along the closing direction,
            shape (4, 4) [m].
        width: Opening of the fingers; 0 for a push [m].
        joints: Names of the free joints that the action moves, the nearest to the link first.
    """

    name: str
    kind: Literal["grasp", "push"]
    link: str
    frame: Array
    width: float
    joints: tuple[str, ...]


def affordances(asset: "Asset") -> tuple[Affordance, ...]:
    """Return the affordances of an asset, in the order of its links."""
    result = []
    for link in asset.links:
        joints = moved_joints(asset, link.name)
        for hold in (*link.grasps, *link.pushes):
            width = hold.width if isinstance(hold, Grasp) else 0.0
            kind: Literal["grasp", "push"] = "grasp" if isinstance(hold, Grasp) else "push"
            result.append(Affordance(hold.name, kind, link.name, hold.frame, width, joints))
    return tuple(result)


def moved_joints(asset: "Asset", link: str) -> tuple[str, ...]:
    """Return the free joints that move a link, the nearest first; a coupled joint stands for its leader."""
    above = {child: (parent, joints) for parent, child, joints in asset.pairs()}
    found: list[str] = []
    while link in above:
        link, joints = above[link]
        found += [head(asset.joint(joint.name), asset).name for joint in reversed(joints) if not joint.locked]
    free = {joint.name for joint in asset.free_joints}
    return tuple(name for name in dict.fromkeys(found) if name in free)


def head(joint: "AssetJoint", asset: "Asset") -> "AssetJoint":
    """Return the leader at the head of a chain of couplings; the joint itself if it follows no other."""
    while joint.follows is not None:
        joint = asset.joint(joint.follows.leader)
    return joint


def affordance_data(affordance: Affordance, asset: "Asset") -> dict[str, Any]:
    """Return an affordance as JSON data, with the motion that its first joint makes."""
    motion = None
    if affordance.joints:
        data = asset.joint(affordance.joints[0]).to_data()
        motion = {"joint": data["name"], **{name: data[name] for name in ("kind", "axis", "pivot", "limits")}}
    return {**affordance.to_data(), "motion": motion}
