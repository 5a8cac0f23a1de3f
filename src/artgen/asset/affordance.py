"""Affordances: frames at which a hand grasps or pushes an asset, the joints that this moves, and the hand."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array, FrozenArrays, Pose
from artgen.asset.joint import AssetCondition, AssetJoint, joints_above
from artgen.asset.manifolds import mesh_of
from artgen.asset.record import Record

if TYPE_CHECKING:
    from artgen.asset.asset import Asset


@dataclass(frozen=True, eq=False)
class Hold(FrozenArrays, Record):
    """A frame at which a hand acts."""

    OPTIONAL: ClassVar = frozenset({"when"})

    name: str  # identifier, unique on the asset
    frame: Pose  # pose in asset coordinates at rest, z along the approach of the hand, shape (4, 4) [m]
    # region of joint space in which a hand reaches it, such as an open lid; None: everywhere
    when: AssetCondition | None = field(default=None, kw_only=True)

    def renamed(self, rename: Callable[[str], str], joints: Mapping[str, str]) -> Self:
        """Return the frame with a new name, and with joints of its condition renamed."""
        when = None if self.when is None else self.when.renamed(joints)
        return replace(self, name=rename(self.name), when=when)

    def moved(self, matrix: Array) -> Self:
        """Return the frame carried along by a rigid motion or a reflection, shape (4, 4)."""
        frame = matrix @ self.frame
        if np.linalg.det(frame[:3, :3]) < 0.0:
            frame[:3, 1] = -frame[:3, 1]
        return replace(self, frame=frame)


@dataclass(frozen=True, eq=False)
class Grasp(Hold):
    """A frame at which a hand grasps: a parallel gripper closes along x."""

    width: float = 0.08  # opening of the fingers [m]


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
        when: Region of joint space in which a hand reaches the frame; None: everywhere.
    """

    OPTIONAL: ClassVar = frozenset({"when"})

    name: str
    kind: Literal["grasp", "push"]
    link: str
    frame: Pose
    width: float
    joints: tuple[str, ...]
    when: AssetCondition | None = None


def affordances(asset: "Asset") -> tuple[Affordance, ...]:
    """Return the affordances of an asset, in the order of its links."""
    result = []
    for link in asset.links:
        joints = moved_joints(asset, link.name, in_hand=True)
        for hold in (*link.grasps, *link.pushes):
            kind: Literal["grasp", "push"] = "grasp" if isinstance(hold, Grasp) else "push"
            width = hold.width if isinstance(hold, Grasp) else 0.0
            result.append(Affordance(hold.name, kind, link.name, hold.frame, width, joints, hold.when))
    return tuple(result)


def moved_joints(asset: "Asset", link: str, *, in_hand: bool = False) -> tuple[str, ...]:
    """Return the free joints that move a link, the nearest first; coupled joints count as their leaders.

    A hand takes a free body away: `in_hand` leaves out the joints that carry it, such as that of a drawer.
    """
    path = joints_above(asset.joints, link)
    ends = [number for number, joint in enumerate(path) if joint.child in asset.loose]
    above = (joint for joint in path[: min(ends) if in_hand and ends else None] if not joint.locked)
    found = dict.fromkeys(head(joint, asset).name for joint in above)
    free = {joint.name for joint in asset.free_joints}
    return tuple(name for name in found if name in free)


def head(joint: AssetJoint, asset: "Asset") -> AssetJoint:
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


@dataclass(frozen=True)
class Gripper:
    """A parallel gripper, and a finger that pushes; the sizes are those of a Franka hand.

    In the frame of a grasp, the fingers close along x, the hand approaches along z, and the origin is the
    center of the pads.
    """

    stroke: float = 0.08  # widest opening between the pads [m]
    thick: float = 0.009  # thickness of a finger along the closing direction [m]
    wide: float = 0.020  # width of a finger and of its pad [m]
    pad: float = 0.018  # length of a pad along the approach; it ends at the tip [m]
    long: float = 0.054  # length of a finger from the hand to the tip [m]
    # sizes of the hand behind the fingers: along the closing direction, across, and along the approach [m]
    hand: tuple[float, float, float] = (0.204, 0.063, 0.066)
    clearance: float = 0.005  # distance of each open finger from the object before it closes [m]
    finger: float = 0.018  # diameter of the pushing finger [m]

    @property
    def tip(self) -> float:
        """Distance of the finger tips beyond the origin of a grasp [m]."""
        return self.pad / 2.0

    def opening(self, thickness: float) -> float:
        """Return the opening of the fingers around an object of a thickness, in steps of 0.1 mm [m].

        For objects that are too thick it exceeds the stroke, so that checks can report the excess.
        """
        wanted = np.ceil(1e4 * (thickness + 2.0 * self.clearance) - 1e-3) / 1e4
        return float(wanted if thickness > self.stroke else min(wanted, self.stroke))

    def between(self, half: float) -> Array:
        """Return the corners of the space between open fingers, shape (2, 3) [m]."""
        return np.array([[-half, -self.wide / 2.0, self.tip - self.long], [half, self.wide / 2.0, self.tip]])

    def blocks(self, low: float, high: float, back: float = 0.0) -> dict[str, Array]:
        """Return the boxes of the hand by name, each as two corners, shape (2, 3) [m]."""
        root, across = self.tip - self.long, self.wide / 2.0
        x, y, z = self.hand
        return {
            "finger": np.array([[high, -across, root - back], [high + self.thick, across, self.tip]]),
            "other finger": np.array([[low - self.thick, -across, root - back], [low, across, self.tip]]),
            "hand": np.array([[-x / 2.0, -y / 2.0, root - z - back], [x / 2.0, y / 2.0, root]]),
        }


GRIPPER = Gripper()  # the gripper for which grasps are made


def block(corners: Array, frame: Array) -> Manifold:
    """Return a box as a solid."""
    return Manifold.cube(np.maximum(corners[1] - corners[0], 1e-9)).translate(corners[0]).transform(frame[:3])


def clipped(solids: Iterable[Manifold], region: Manifold, frame: Array) -> Array:
    """Return the corners of the intersection of solids with a convex region, in a frame, shape (n, 3) [m]."""
    # normals and paint only take time
    found = [mesh_of(solid.set_properties(0, lambda *_: None) ^ region)[0] for solid in solids]
    return np.asarray((np.concatenate([np.zeros((0, 3)), *found]) - frame[:3, 3]) @ frame[:3, :3])


def held(solids: Iterable[Manifold], frame: Array) -> tuple[float, float] | None:
    """Return the extent of solids along x between the fingers of a grasp; None without solids there [m]."""
    points = clipped(solids, block(GRIPPER.between(GRIPPER.stroke), frame), frame)
    return (float(points[:, 0].min()), float(points[:, 0].max())) if len(points) else None
