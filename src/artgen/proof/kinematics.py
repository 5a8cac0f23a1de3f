"""Joints between links as batches of motions, and the frames along a path."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, Indices, Mask
from artgen.asset.joint import JointKind
from artgen.colliders.triangles import cross
from artgen.proof.bounds import Motion
from artgen.proof.items import NONE, Items
from artgen.proof.paths import JointPath

BEYOND = 1e-9
"""Distance by which the proof extends beyond each end of a range, for rounded limits [rad or m]."""

_WIDEST_START = 1.6  # widest starting cell where arcs have to be enclosed [rad]
_ROUNDING = 1e-9  # tolerance of points on an axis [m]


@dataclass(eq=False)
class JointTable:
    """Joint paths with the same kinds of joints from A to B."""

    kinds: tuple[JointKind, ...]  # kind of each joint
    origin: Array  # pivots, shape (paths, m, 3) [m]
    axis: Array  # axes, reversed for joints that are crossed towards the root, shape (paths, m, 3)
    away: Mask  # whether the joint leads away from the root, shape (paths, m)
    variable: Indices  # number of the variable, shape (paths, m); -1 for a joint that stands still
    ratio: Array  # ratio of position to variable, shape (paths, m)
    offset: Array  # position while the variable is 0, shape (paths, m) [rad or m]

    @staticmethod
    def of(kinds: tuple[JointKind, ...], joint_paths: Sequence[JointPath]) -> "JointTable":
        """Collect the numbers of several joint paths."""
        signs = np.array([joint_path.signs for joint_path in joint_paths], float)
        numbers = [
            [
                joint_path.variables.index(each.variable) if each.variable else NONE
                for each in joint_path.followers
            ]
            for joint_path in joint_paths
        ]
        return JointTable(
            kinds,
            np.array([[joint.pivot for joint in joint_path.steps] for joint_path in joint_paths]),
            np.array([[joint.axis for joint in joint_path.steps] for joint_path in joint_paths])
            * signs[:, :, None],
            signs > 0.0,
            np.array(numbers),
            np.array([[each.ratio for each in joint_path.followers] for joint_path in joint_paths]),
            np.array([[each.offset for each in joint_path.followers] for joint_path in joint_paths]),
        )

    def path(self, joint_paths: Indices, low: Array, high: Array) -> list[Motion]:
        """Return the motions of items in their cells."""
        middle, half = (low + high) / 2.0, (high - low) / 2.0
        rows = np.arange(len(joint_paths))
        result = []
        for step, kind in enumerate(self.kinds):
            variable, ratio = self.variable[joint_paths, step], self.ratio[joint_paths, step]
            center = ratio * middle[rows, variable] + self.offset[joint_paths, step]
            width = np.abs(ratio) * half[rows, variable]
            result.append(
                Motion(kind, self.origin[joint_paths, step], self.axis[joint_paths, step], center, width)
            )
        return result

    def motion(
        self, joint_paths: Indices, items: Items, first: tuple[Array, Array], second: tuple[Array, Array]
    ) -> Array:
        """Return the largest motion of nodes with centers and radii by each variable, shape (N, v) [m]."""
        result = np.zeros_like(items.low)
        half = (items.high - items.low) / 2.0
        rows = np.arange(len(joint_paths))
        for step, kind in enumerate(self.kinds):
            variable = self.variable[joint_paths, step]
            width = np.abs(self.ratio[joint_paths, step]) * half[rows, variable]
            if kind == "revolute":
                away = self.away[joint_paths, step]
                center = np.where(away[:, None], second[0], first[0])
                radius = np.where(away, second[1], first[1])
                axis = self.axis[joint_paths, step]
                arm = cross(axis, center - self.origin[joint_paths, step])
                reach = np.sqrt(np.sum(arm * arm, axis=1)) + radius
                width = 2.0 * np.sin(np.minimum(width, np.pi) / 2.0) * reach
            result[rows, variable] += width
        return result


@dataclass(eq=False)
class Frames:
    """Frames along a path at the center of the cells."""

    rotations: list[Array]  # rotations from each frame to frame 0: m + 1 arrays of shape (N, 3, 3)
    offset: Array  # offset of the last frame, shape (N, 3) [m]

    def moved(self, points: Array) -> Array:
        """Return points of link B in link A's frame, shape (N, 3) [m]."""
        result: Array = np.matmul(self.rotations[-1], points[:, :, None])[:, :, 0] + self.offset
        return result

    def seen(self, directions: Array, frame: int, rows: Indices | None = None) -> Array:
        """Return directions of frame 0 in another frame, shape (n, 3)."""
        if frame == 0:
            return directions
        rotation = self.rotations[frame] if rows is None else self.rotations[frame][rows]
        result: Array = np.matmul(directions[:, None, :], rotation)[:, 0, :]
        return result


def frames(path: Sequence[Motion]) -> Frames:
    """Compose the motions of a path at the center of the cells."""
    count = len(path[0].center)
    rotation = np.broadcast_to(np.eye(3), (count, 3, 3))
    rotations, offset = [rotation], np.zeros((count, 3))
    for motion in path:
        if motion.kind == "prismatic":
            shift, turned = motion.axis * motion.center[:, None], rotation
        else:
            turn = _rotations(motion.axis, motion.center)
            shift = motion.origin - np.matmul(turn, motion.origin[:, :, None])[:, :, 0]
            turned = np.matmul(rotation, turn)
        offset = offset + np.matmul(rotation, shift[:, :, None])[:, :, 0]
        rotation = turned
        rotations.append(rotation)
    return Frames(rotations, offset)


def _rotations(axis: Array, angle: Array) -> Array:
    """Return rotations about unit axes, shape (N, 3, 3) (Rodrigues' formula)."""
    x, y, z = axis.T
    matrix = np.zeros((len(axis), 3, 3))
    matrix[:, 0, 1], matrix[:, 0, 2], matrix[:, 1, 2] = -z, y, -x
    matrix -= matrix.transpose(0, 2, 1).copy()
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    result: Array = np.eye(3) + sine * matrix + (1.0 - cosine) * np.matmul(matrix, matrix)
    return result


def is_coaxial(joint_path: JointPath) -> bool:
    """Tell whether all joints of a path rotate about, or slide along, one axis."""
    first = joint_path.steps[0]
    turning = [joint for joint in joint_path.steps if joint.kind == "revolute"]
    if first.kind != "revolute" or not turning:
        return False
    for joint in joint_path.steps:
        if np.abs(np.cross(joint.axis, first.axis)).max() > _ROUNDING:
            return False
        away = joint.pivot - first.pivot
        if joint.kind == "revolute" and np.abs(np.cross(away, first.axis)).max() > _ROUNDING:
            return False
    return True


def nearest_zero(box: Array) -> Array:
    """Return the point of a box, shape (v, 2), nearest to 0, shape (v,)."""
    nearest: Array = np.clip(0.0, box[:, 0], box[:, 1])
    return nearest


def starting_cells(joint_path: JointPath) -> list[tuple[int, tuple[Array, Array]]]:
    """Return the starting cells of the search for a joint path, with the number of their box."""
    result = []
    for index, box in enumerate(joint_path.boxes):
        parts = np.ones(len(box), np.int64)
        if len(joint_path.steps) > 2:
            for joint, follower in zip(joint_path.steps, joint_path.followers, strict=True):
                if joint.kind == "revolute" and follower.variable:
                    number = joint_path.variables.index(follower.variable)
                    width = abs(follower.ratio) * (box[number, 1] - box[number, 0])
                    parts[number] = max(parts[number], int(np.ceil(width / _WIDEST_START)))
        grown = box + (-BEYOND, BEYOND)
        edges = [np.linspace(low, high, part + 1) for (low, high), part in zip(grown, parts, strict=True)]
        for cell in np.ndindex(*parts):
            low = np.array([edge[at] for edge, at in zip(edges, cell, strict=True)])
            high = np.array([edge[at + 1] for edge, at in zip(edges, cell, strict=True)])
            result.append((index, (low, high)))
    return result
