"""Kinematics of a Franka Panda for many postures at once: where it is, and how to follow a path."""

import numpy as np

from artgen._arrays import Array
from artgen.envs.robot import LIMITS

# as in robosuite's model of the arm: from each joint to the next, at angle 0, a turn about x and a shift
_TURNS = (0.0, -0.5, 0.5, 0.5, -0.5, 0.5, 0.5)  # [pi]
_SHIFTS = np.array(
    [
        [0.0, 0.0, 0.333],
        [0.0, 0.0, 0.0],
        [0.0, -0.316, 0.0],
        [0.0825, 0.0, 0.0],
        [-0.0825, 0.384, 0.0],
        [0.0, 0.0, 0.0],
        [0.088, 0.0, 0.0],
    ]
)  # [m]
_TIP = 0.1065 + 0.097  # from the last joint along its axis: the flange, then the middle of the pads [m]
_TIP_TURN = -0.75 * np.pi  # about that axis
_BALLS = np.array(
    [
        [2, 0.0, 0.0, -0.06, 0.060],
        [2, 0.08, 0.055, 0.0, 0.065],
        [3, 0.0, 0.0, 0.05, 0.065],
        [3, -0.08, 0.07, 0.0, 0.065],
        [3, -0.08, 0.12, 0.0, 0.060],
        [4, 0.0, 0.0, -0.20, 0.065],
        [4, 0.0, 0.045, -0.15, 0.065],
        [4, 0.0, 0.07, -0.08, 0.060],
        [4, 0.0, 0.07, 0.0, 0.060],
        [5, 0.0, 0.0, 0.0, 0.055],
        [5, 0.085, 0.02, 0.0, 0.060],
        [6, 0.0, 0.0, 0.07, 0.050],
        [6, 0.04, 0.04, 0.08, 0.045],
    ]
)  # number of the joint, place in its frame, radius [m]
BALL_JOINTS, BALL_PLACES, BALL_RADII = _BALLS[:, 0].astype(int), _BALLS[:, 1:4], _BALLS[:, 4]
"""Balls that fill the arm from elbow to flange: the joints that carry them, shape (n,), where they are in
the frames of these, shape (n, 3), and their radii, shape (n,) [m]."""

_MIDDLE = LIMITS.mean(axis=1)
_DAMPING = 0.03
_MARGIN = 0.05  # kept from the limits [rad]
_LONGEST = 0.35  # change of an angle in one step [rad]


def _fixed() -> Array:
    result = np.tile(np.eye(4), (7, 1, 1))
    for index, turn in enumerate(_TURNS):
        sine, cosine = round(np.sin(turn * np.pi)), round(np.cos(turn * np.pi))
        result[index, 1:3, 1:3] = [[cosine, -sine], [sine, cosine]]
        result[index, :3, 3] = _SHIFTS[index]
    return result


def _tip() -> Array:
    result = np.eye(4)
    sine, cosine = np.sin(_TIP_TURN), np.cos(_TIP_TURN)
    result[:2, :2] = [[cosine, -sine], [sine, cosine]]
    result[2, 3] = _TIP
    return result


_FIXED, _LAST = _fixed(), _tip()


def frames(angles: Array) -> Array:
    """Return the poses of the joints and of the tip, in the base's frame.

    Args:
        angles: shape (n, 7) [rad].

    Returns:
        Poses of the seven joints, with z along their axes, and of the tip, shape (n, 8, 4, 4).
    """
    count = len(angles)
    result = np.empty((count, 8, 4, 4))
    pose = np.tile(np.eye(4), (count, 1, 1))
    sines, cosines = np.sin(angles), np.cos(angles)
    for index in range(7):
        pose = pose @ _FIXED[index]
        sine, cosine = sines[:, index, None], cosines[:, index, None]
        x, y = pose[:, :, 0].copy(), pose[:, :, 1].copy()
        pose[:, :, 0], pose[:, :, 1] = cosine * x + sine * y, cosine * y - sine * x
        result[:, index] = pose
    result[:, 7] = pose @ _LAST
    return result


def reach(angles: Array, tips: Array, steps: int) -> tuple[Array, Array]:
    """Move postures so that their tips come to poses, by damped least squares within the limits.

    Args:
        angles: Postures to start from, shape (n, 7) [rad].
        tips: Poses of the tips in the base's frame, shape (n, 4, 4).
        steps: How many steps are made.

    Returns:
        The postures, shape (n, 7) [rad], and by how much the tips miss, in metres plus a tenth of the
        radians, shape (n,).
    """
    low, high = LIMITS[:, 0] + _MARGIN, LIMITS[:, 1] - _MARGIN
    angles = np.clip(angles, low, high)
    for _ in range(steps):
        poses = frames(angles)
        error = _error(poses[:, 7], tips)
        axes, places = poses[:, :7, :3, 2], poses[:, :7, :3, 3]
        lever = np.cross(axes, poses[:, None, 7, :3, 3] - places)
        jacobian = np.concatenate([lever, axes], axis=2)  # (n, 7, 6)
        square = np.einsum("nji,njk->nik", jacobian, jacobian) + _DAMPING**2 * np.eye(6)
        # a pull towards the middle of the ranges acts only where it does not move the tip
        pull = 0.02 * (_MIDDLE - angles)
        wanted = error - np.einsum("nji,nj->ni", jacobian, pull)
        step = pull + np.einsum("nij,nj->ni", jacobian, np.linalg.solve(square, wanted[..., None])[..., 0])
        longest = np.abs(step).max(axis=1, keepdims=True)
        angles = np.clip(angles + step * np.minimum(1.0, _LONGEST / np.maximum(longest, 1e-9)), low, high)
    error = _error(frames(angles)[:, 7], tips)
    return angles, np.linalg.norm(error[:, :3], axis=1) + 0.1 * np.linalg.norm(error[:, 3:], axis=1)


def _error(poses: Array, tips: Array) -> Array:
    """Return how tips would have to move and turn, shape (n, 6) [m, rad]."""
    result = np.empty((len(poses), 6))
    result[:, :3] = tips[:, :3, 3] - poses[:, :3, 3]
    turn = tips[:, :3, :3] @ poses[:, :3, :3].transpose(0, 2, 1)
    vector = np.stack(
        [turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0], turn[:, 1, 0] - turn[:, 0, 1]], axis=1
    )
    sine = np.linalg.norm(vector, axis=1)  # twice the sine
    angle = np.arctan2(sine, np.trace(turn, axis1=1, axis2=2) - 1.0)
    result[:, 3:] = vector * (angle / np.maximum(sine, 1e-9))[:, None]
    return result
