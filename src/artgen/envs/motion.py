"""What a task asks of one asset: the joints to move, where hands do it, and where the robot stands."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from artgen._arrays import Array
from artgen.asset import rotation
from artgen.asset.affordance import Affordance
from artgen.asset.gripper import GRIPPER

OPEN = GRIPPER.stroke
"""Widest opening of the hand [m]."""

BACK, FAR_BACK = 0.10, 0.16
"""How far away the hand begins its approach: as a rule, and where chance would do the task too often [m]."""


@dataclass(frozen=True, eq=False)
class Contact:
    """Where a hand touches a link, and how it comes there.

    Attributes:
        kind: `grasp`, closing on the link; `push`, with the closed fingers.
        link: Name of the link.
        frame: Pose of the tip, the middle between the pads, at the link's rest pose: z out of the hand, x
            along which the fingers close, shape (4, 4) [m].
        width: Opening with which the hand comes [m].
        back: How far away along the approach the hand starts, and to where it goes back afterwards [m].
        through: Poses of the tip, in asset coordinates, that lead to the start of the approach.
    """

    kind: Literal["grasp", "push"]
    link: str
    frame: Array
    width: float = 0.0
    back: float = BACK
    through: tuple[Array, ...] = ()


@dataclass(frozen=True, eq=False)
class Move:
    """One motion of the hand with a link, for the scripted policy.

    Attributes:
        joint: Name of the joint that it moves.
        until: Where the joint is let go [rad or m].
        contact: Where the hand touches; None to keep what it holds.
    """

    joint: str
    until: float
    contact: Contact | None


@dataclass(frozen=True, eq=False)
class Stage:
    """One joint to move.

    Attributes:
        joint: Name of a free joint.
        start: Where it stands at reset [rad or m].
        goal: Position from which on the stage is reached, in the direction from `start` [rad or m].
        affordance: Where a hand can move it.
        moves: How the scripted policy does it.
        holds: Whether the joint must still be there when later stages are reached; a lever need not.
    """

    joint: str
    start: float
    goal: float
    affordance: Affordance
    moves: tuple[Move, ...] = ()
    holds: bool = False

    def progress(self, position: float) -> float:
        """Return the share of the way to the goal, 0-1."""
        return float(np.clip((position - self.start) / (self.goal - self.start), 0.0, 1.0))

    def reached(self, position: float) -> bool:
        """Tell whether a position is the goal or beyond it."""
        return position >= self.goal if self.goal > self.start else position <= self.goal


@dataclass(frozen=True, eq=False)
class Target:
    """What a task means on one asset.

    Attributes:
        stages: The joints to move, in order.
        start: Positions of free joints at reset; the others stand at rest [rad or m].
        base: Pose of the robot's base in asset coordinates, turned about z only, shape (4, 4) [m].
        arm: Angles of the arm's joints at reset, shape (7,) [rad].
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
    """Return the pose of the tip that acts at an affordance, shape (4, 4) [m].

    The ends of the fingers, which push, reach past the tip.
    """
    return lifted(affordance.frame, -GRIPPER.tip if affordance.kind == "push" else 0.0)


def lifted(pose: Array, along: float) -> Array:
    """Return a pose moved along its own z, shape (4, 4) [m]."""
    result = pose.copy()
    result[:3, 3] += along * pose[:3, 2]
    return result


def turned(pose: Array, axis: int, angle: float) -> Array:
    """Return a pose turned in place about one of its own axes, shape (4, 4)."""
    result = pose.copy()
    result[:3, :3] = rotation(pose[:3, axis], angle) @ pose[:3, :3]
    return result


def between(first: Array, second: Array, shift: float, turn: float) -> list[Array]:
    """Return poses on the straight way from one to another, so near each other; both are left out.

    Args:
        first: Where it begins, shape (4, 4).
        second: Where it ends, shape (4, 4).
        shift: Most by which the place changes from one pose to the next [m].
        turn: Most by which they turn against each other [rad].
    """
    vector = rotation_vector(second[:3, :3] @ first[:3, :3].T)
    angle = float(np.linalg.norm(vector))
    apart = second[:3, 3] - first[:3, 3]
    count = int(np.ceil(max(float(np.linalg.norm(apart)) / shift, angle / turn)))
    result = []
    for share in np.arange(1, count) / max(count, 1):
        pose = first.copy()
        pose[:3, :3] = rotation(vector / max(angle, 1e-9), share * angle) @ first[:3, :3]
        pose[:3, 3] += share * apart
        result.append(pose)
    return result


def rotation_vector(matrix: Array) -> Array:
    """Return the axis of a rotation times its angle, shape (3,) [rad]."""
    vector = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]])
    sine = float(np.linalg.norm(vector))
    angle = float(np.arctan2(sine, np.trace(matrix) - 1.0))
    if sine > 1e-6:
        return np.asarray(vector * (angle / sine))
    if angle < 1.0:
        return np.zeros(3)
    axis = np.sqrt(np.maximum(np.diag(matrix) + 1.0, 0.0) / 2.0)  # half a turn
    largest = int(np.argmax(axis))
    axis *= np.where(matrix[largest] + matrix[:, largest] < 0.0, -1.0, 1.0)
    return np.asarray(angle * axis / np.linalg.norm(axis))


def contact_of(affordance: Affordance, back: float = BACK) -> Contact:
    """Return the contact that an affordance describes."""
    return Contact(affordance.kind, affordance.link, tip_of(affordance), affordance.width, back)
