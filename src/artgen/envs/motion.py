"""The target of a task on one asset: joints to move, contacts of the hand, and the place of the robot."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.spatial.transform import Rotation

from artgen._arrays import Array
from artgen.asset import rotation
from artgen.asset.affordance import GRIPPER, Affordance

OPEN = GRIPPER.stroke  # largest opening of the hand [m]
ON = 0.3  # value from which an output is on
BACK, FAR_BACK = 0.10, 0.16  # start of the approach: usually, and if random motion would do the task [m]


@dataclass(frozen=True, eq=False)
class Contact:
    """A contact of the hand with a link, and its approach."""

    kind: Literal["grasp", "push"]  # a push is with closed fingers
    link: str  # name of the link
    frame: Array  # pose of the tip for the link at rest: z out of the hand, fingers close along x, (4, 4) [m]
    width: float = 0.0  # opening of the hand in the approach [m]
    back: float = BACK  # distance at which the approach begins, and to which the hand retreats [m]
    through: tuple[Array, ...] = ()  # poses of the tip, in asset coordinates, before the approach


@dataclass(frozen=True, eq=False)
class Move:
    """One motion of the hand with a link, for the scripted policy."""

    joint: str  # name of the joint that it moves
    until: float  # position at which the joint is released [rad or m]
    contact: Contact | None  # None keeps the last contact


@dataclass(frozen=True, eq=False)
class Stage:
    """One joint to move.

    Attributes:
        joint: Name of a free joint.
        start: Position at reset [rad or m].
        goal: Position at which the stage is reached, or beyond it in the direction from `start` [rad or m].
        affordance: Grasp or push that moves it.
        moves: Motions of the scripted policy.
        holds: Whether the joint must stay at the goal in later stages, unlike a lever.
        output: Name of the output that the joint switches on at the goal, if any.
    """

    joint: str
    start: float
    goal: float
    affordance: Affordance
    moves: tuple[Move, ...] = ()
    holds: bool = False
    output: str | None = None

    def progress(self, position: float) -> float:
        """Return the progress to the goal, 0-1."""
        return float(np.clip((position - self.start) / (self.goal - self.start), 0.0, 1.0))

    def reached(self, position: float) -> bool:
        """Tell whether a position is at the goal or beyond it."""
        return position >= self.goal if self.goal > self.start else position <= self.goal


@dataclass(frozen=True, eq=False)
class Target:
    """The stages of a task on one asset, and the place of the robot.

    Attributes:
        stages: The joints to move, in order.
        start: Positions of free joints at reset; others are at rest [rad or m].
        base: Pose of the base of the robot in asset coordinates, rotated about z only, shape (4, 4) [m].
        arm: Angles of the arm at reset, shape (7,) [rad].
        hand: Pose of the tip at reset in asset coordinates, shape (4, 4) [m].
    """

    stages: tuple[Stage, ...]
    start: dict[str, float]
    base: Array
    arm: Array
    hand: Array

    @property
    def moves(self) -> tuple[Move, ...]:
        """The motions of all stages, in order."""
        return tuple(move for stage in self.stages for move in stage.moves)


def tip_of(affordance: Affordance) -> Array:
    """Return the pose of the tip at an affordance, shape (4, 4) [m]; fingers push with their ends."""
    return lifted(affordance.frame, -GRIPPER.tip if affordance.kind == "push" else 0.0)


def lifted(pose: Array, along: float) -> Array:
    """Return a pose moved along its own z, shape (4, 4) [m]."""
    result = pose.copy()
    result[:3, 3] += along * pose[:3, 2]
    return result


def turned(pose: Array, axis: int, angle: float) -> Array:
    """Return a pose rotated in place about one of its own axes, shape (4, 4)."""
    result = pose.copy()
    result[:3, :3] = rotation(pose[:3, axis], angle) @ pose[:3, :3]
    return result


def between(first: Array, second: Array, shift: float, turn: float) -> list[Array]:
    """Return poses between two, without both, at most a distance [m] and an angle [rad] apart."""
    vector = rotation_vector(second[:3, :3] @ first[:3, :3].T)
    apart = second[:3, 3] - first[:3, 3]
    count = int(np.ceil(max(float(np.linalg.norm(apart)) / shift, float(np.linalg.norm(vector)) / turn)))
    shares = np.arange(1, count)[:, None] / max(count, 1)
    result = np.tile(first, (len(shares), 1, 1))
    result[:, :3, :3] = Rotation.from_rotvec(shares * vector).as_matrix() @ first[:3, :3]
    result[:, :3, 3] += shares * apart
    return list(result)


def rotation_vector(matrix: Array) -> Array:
    """Return the axis of a rotation times its angle, shape (3,) [rad]."""
    return np.asarray(Rotation.from_matrix(matrix, assume_valid=True).as_rotvec())


def contact_of(affordance: Affordance, back: float = BACK) -> Contact:
    """Return the contact of an affordance."""
    return Contact(affordance.kind, affordance.link, tip_of(affordance), affordance.width, back)
