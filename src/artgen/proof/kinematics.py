"""Cells of joint space in batches, the motions of joints in them, and the frames along a path."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from artgen import _portable
from artgen._arrays import Array, Indices, Mask
from artgen.asset.coupling import AssetCoupling
from artgen.asset.joint import JointKind
from artgen.colliders.triangles import cross
from artgen.proof.bounds import Motion
from artgen.proof.paths import JointPath

NONE = -1  # frame of a cell without a plane, and variable of a joint that never moves
BEYOND = 1e-9  # distance by which the proof extends beyond each end of a range, for rounded limits [rad or m]
_WIDEST_START = 1.6  # widest starting cell where arcs have to be enclosed [rad]
_MOST_STARTS = 4096  # most starting cells of a box; their number grows by a power with each joint
_ROUNDING = 1e-9  # tolerance of points on an axis [m]


@dataclass(eq=False)
class ProofCells:
    """Cells of joint space, one per row, each for a node of either link."""

    joint_path: Indices  # number of the joint path
    box: Indices  # number of the box in its joint space
    first: Indices  # node of link A
    second: Indices  # node of link B
    low: Array  # lowest positions of the cell; 0 in columns beyond the variables of the joint path [rad or m]
    high: Array  # highest positions [rad or m]
    normal: Array  # normal of the best plane before the last split
    frame: Indices  # frame of that plane; -1 if there is none

    def __len__(self) -> int:
        return len(self.joint_path)

    def __getitem__(self, rows: Indices | Mask | slice) -> "ProofCells":
        return ProofCells(*[column[rows] for column in vars(self).values()])

    @staticmethod
    def join(parts: "Sequence[ProofCells]") -> "ProofCells":
        """Return the cells of all parts in order."""
        columns = zip(*(vars(part).values() for part in parts), strict=True)
        return ProofCells(*[np.concatenate(column) for column in columns])

    def numbers(self, row: int) -> tuple[int, int, int, int]:
        """Return the joint path, the box and the nodes of a cell."""
        joint_path, box = int(self.joint_path[row]), int(self.box[row])
        return joint_path, box, int(self.first[row]), int(self.second[row])


@dataclass(eq=False)
class JointTable:
    """Joint paths with the same kinds of joints from A to B."""

    kinds: tuple[JointKind, ...]  # kind of each joint
    origin: Array  # pivots, shape (paths, m, 3) [m]
    axis: Array  # axes, reversed for joints that are crossed towards the root, shape (paths, m, 3)
    away: Mask  # whether the joint leads away from the root, shape (paths, m)
    variable: Indices  # number of the variable, shape (paths, m); -1 for a joint that never moves
    ratio: Array  # ratio of position to variable, shape (paths, m)
    offset: Array  # position while the variable is 0, shape (paths, m) [rad or m]
    curved: tuple[tuple[int, int, AssetCoupling], ...]  # path, step and law of each joint of a closed chain

    @staticmethod
    def of(joint_paths: Sequence[JointPath]) -> "JointTable":
        """Collect the numbers of several joint paths."""
        signs = np.array([path.signs for path in joint_paths], float)
        numbers = [
            [path.variables.index(each.leader) if each.leader else NONE for each in path.followers]
            for path in joint_paths
        ]
        return JointTable(
            tuple(joint.kind for joint in joint_paths[0].steps),
            np.array([[joint.pivot for joint in path.steps] for path in joint_paths]),
            np.array([[joint.axis for joint in path.steps] for path in joint_paths]) * signs[:, :, None],
            signs > 0.0,
            np.array(numbers),
            np.array([[each.ratio for each in path.followers] for path in joint_paths]),
            np.array([[each.offset for each in path.followers] for path in joint_paths]),
            tuple(
                (number, step, law)
                for number, path in enumerate(joint_paths)
                for step, law in enumerate(path.followers)
                if law.curve is not None
            ),
        )

    def motions(self, joint_paths: Indices, low: Array, high: Array) -> list[Motion]:
        """Return the motion of each joint in cells, whose joint paths are rows of this table."""
        middle, half = (low + high) / 2.0, (high - low) / 2.0
        rows = np.arange(len(joint_paths))
        result = []
        for step, kind in enumerate(self.kinds):
            variable, ratio = self.variable[joint_paths, step], self.ratio[joint_paths, step]
            center = ratio * middle[rows, variable] + self.offset[joint_paths, step]
            width = np.abs(ratio) * half[rows, variable]
            for path, _, law in (each for each in self.curved if each[1] == step):
                led = np.flatnonzero(joint_paths == path)
                ends = (side[led, variable[led]] for side in (low, high))
                center[led], width[led] = law.interval(*ends)
            axis = self.axis[joint_paths, step]
            result.append(Motion(kind, self.origin[joint_paths, step], axis, center, width))
        return result

    def reach(
        self, joint_paths: Indices, path: Sequence[Motion], center: Array, radius: Array, count: int
    ) -> Array:
        """Return how far each of `count` variables moves nodes, shape (N, v) [m].

        The nodes of both links have centers, shape (2, N, 3), and radii, shape (2, N) [m].
        """
        rows = np.arange(len(joint_paths))
        result = np.zeros((len(rows), count))
        for step, motion in enumerate(path):
            width = motion.half
            if motion.kind == "revolute":
                away = self.away[joint_paths, step]
                middle = np.where(away[:, None], center[1], center[0])
                arm = cross(motion.axis, middle - motion.origin)
                farthest = np.sqrt(np.sum(arm * arm, axis=1)) + np.where(away, radius[1], radius[0])
                width = 2.0 * _portable.sin(np.minimum(width, np.pi) / 2.0) * farthest
            result[rows, self.variable[joint_paths, step]] += width
        return result


@dataclass(eq=False)
class Frames:
    """Frames along a path at the center of the cells."""

    rotations: list[Array]  # rotations from each frame to frame 0: m + 1 arrays of shape (N, 3, 3)
    offset: Array  # offset of the last frame, shape (N, 3) [m]

    def directions(self, directions: Array, frame: int, rows: Indices | slice = slice(None)) -> Array:
        """Return directions of frame 0 in another frame, for some cells, shape (n, 3)."""
        if frame == 0:
            return directions
        return np.asarray(np.einsum("ni,nij->nj", directions, self.rotations[frame][rows]))


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
    cosine, sine = _portable.cos_sin(angle[:, None, None])
    return np.asarray(np.eye(3) + sine * matrix + (1.0 - cosine) * np.matmul(matrix, matrix))


def is_coaxial(joint_path: JointPath) -> bool:
    """Tell whether all joints of a path rotate about, or slide along, one axis."""
    first = joint_path.steps[0]
    if first.kind != "revolute":
        return False
    off = [joint.axis for joint in joint_path.steps]
    off += [joint.pivot - first.pivot for joint in joint_path.steps if joint.kind == "revolute"]
    return bool(np.abs(np.cross(off, first.axis)).max() <= _ROUNDING)


def starting_cells(joint_path: JointPath) -> list[tuple[int, Array]]:
    """Return the starting cells of the search, shape (v, 2), each with the number of its box."""
    result = []
    for index, box in enumerate(joint_path.boxes):
        parts = np.ones(len(box), np.int64)
        if len(joint_path.steps) > 2:
            for joint, follower in zip(joint_path.steps, joint_path.followers, strict=True):
                if joint.kind == "revolute" and follower.leader:
                    number = joint_path.variables.index(follower.leader)
                    width = 2.0 * float(follower.interval(*box[number])[1])
                    parts[number] = max(parts[number], int(np.ceil(width / _WIDEST_START)))
        while np.prod(parts.astype(float)) > _MOST_STARTS:  # wider cells are enclosed too, but less tightly
            parts[np.argmax(parts)] -= 1
        grown = box + (-BEYOND, BEYOND)
        if (parts == 1).all():
            result.append((index, grown))
            continue
        edges = [np.linspace(low, high, part + 1) for (low, high), part in zip(grown, parts, strict=True)]
        cells = itertools.product(*(itertools.pairwise(edge) for edge in edges))
        result += [(index, np.array(cell)) for cell in cells]
    return result
