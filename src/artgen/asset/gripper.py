"""The hand for which grasps are made and checked: a parallel gripper, and a finger that pushes.

In the frame of a grasp, the fingers close along x, the hand approaches along z, and the origin is the center
of the pads. Sizes are those of a Franka hand.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array


@dataclass(frozen=True)
class Gripper:
    """A parallel gripper."""

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
        return np.array(
            [[-half, -self.wide / 2.0, self.tip - self.long], [half, self.wide / 2.0, self.tip]], float
        )

    def blocks(self, low: float, high: float, back: float = 0.0) -> dict[str, Array]:
        """Return the boxes of the hand by name, each as two corners, shape (2, 3) [m]."""
        root, across = self.tip - self.long, self.wide / 2.0
        x, y, z = self.hand
        return {
            "finger": np.array([[high, -across, root - back], [high + self.thick, across, self.tip]]),
            "other finger": np.array([[low - self.thick, -across, root - back], [low, across, self.tip]]),
            "hand": np.array([[-x / 2.0, -y / 2.0, root - z - back], [x / 2.0, y / 2.0, root]]),
        }


GRIPPER = Gripper()
"""The gripper for which grasps are made."""


def block(corners: Array, frame: Array) -> Manifold:
    """Return a box as a solid."""
    return Manifold.cube(np.maximum(corners[1] - corners[0], 1e-9)).translate(corners[0]).transform(frame[:3])


def clipped(solids: Iterable[Manifold], region: Manifold, frame: Array) -> Array:
    """Return the corners of the intersection of solids with a convex region, in a frame, shape (n, 3) [m]."""
    found = [np.zeros((0, 3))]
    for solid in solids:
        common = solid ^ region
        if not common.is_empty():
            found.append(np.asarray(common.to_mesh64().vert_properties)[:, :3])
    return np.asarray((np.concatenate(found) - frame[:3, 3]) @ frame[:3, :3])


def held(solids: Iterable[Manifold], frame: Array) -> tuple[float, float] | None:
    """Return the extent of solids along x between the fingers of a grasp; None without solids there [m]."""
    points = clipped(solids, block(GRIPPER.between(GRIPPER.stroke), frame), frame)
    return (float(points[:, 0].min()), float(points[:, 0].max())) if len(points) else None
