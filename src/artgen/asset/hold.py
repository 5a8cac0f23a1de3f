"""Where hands act on a link: grasps, which a gripper closes on, and pushes, for a finger."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from artgen._arrays import Array
from artgen._caching import FrozenArrays


@dataclass(frozen=True, eq=False)
class Hold(FrozenArrays):
    """A frame at which a hand acts.

    Attributes:
        name: Identifier, unique on the asset.
        frame: Pose in asset coordinates at rest, z along the direction in which the hand comes, shape (4, 4)
            [m].
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
    """A frame at which a hand takes hold: x is the direction along which a parallel gripper closes.

    Attributes:
        width: Opening that the fingers need [m].
    """

    width: float = 0.08


@dataclass(frozen=True, eq=False)
class Push(Hold):
    """A frame at which a finger pushes: its origin is on the surface, and z is the way of the push."""
