"""A Franka Panda with its hand from the files of robosuite, and the kinematics of its arm.

The tip is the point in the middle of the fingers' pads: z points out of the hand, the fingers close along x.
A hand whose tip is at the frame of a grasp can close on it; the fingers end `GRIPPER.tip` farther out.
"""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset.affordance import GRIPPER
from artgen.errors import EnvError

PREFIX = "robot_"
"""Prefix of all names of the robot in a scene."""

HAND = "hand_"
"""Prefix of the names of the hand, after that of the robot."""

HOME = np.array([0.0, np.pi / 16, 0.0, -5 * np.pi / 6, 0.0, np.pi - 0.2, np.pi / 4])
"""Initial posture of robosuite: the hand in front, pointing down, shape (7,) [rad]."""

LIMITS = np.column_stack(
    (
        [-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973],
        [2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973],
    )
)
"""Range of each joint of the arm, shape (7, 2) [rad]."""

OPENING = 0.04
"""Travel of each finger from the middle [m]."""

ROBOT_BIT, ASSET_BIT = 2, 1
"""Bits of MuJoCo's `contype` for contacts: an asset is exported with the first bit alone."""

_PEDESTAL = (0.11, 0.11)  # half of its width and depth [m]
_PEDESTAL_MIDDLE = -0.04  # x of the pedestal, under the foot of the arm [m]
_INSTALL = "pip install 'artgen[envs]'"
_SQUEEZE = 40.0  # largest force of a finger [N]; with robosuite's 20 N, heavy doors slip
_FINGER_STIFFNESS = 4000.0  # [N/m]

# from each joint to the next at angle 0, as in robosuite's model: a rotation about x and a translation
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
"""Balls that fill the arm from elbow to flange: indices of their joints, shape (n,), centers in the frames of
the joints, shape (n, 3), and radii, shape (n,) [m]."""

_MIDDLE = LIMITS.mean(axis=1)
_DAMPING = 0.03
_MARGIN = 0.05  # distance from the limits [rad]
_LONGEST = 0.35  # largest change of an angle per step [rad]


def files() -> Path:
    """Return the directory of robosuite's models, without importing robosuite, which takes seconds.

    Raises:
        EnvError: robosuite is not installed.
    """
    found = find_spec("robosuite")
    if found is None or not found.submodule_search_locations:
        raise EnvError(f"the Panda of the manipulation tasks comes with robosuite: {_INSTALL}")
    return Path(found.submodule_search_locations[0]) / "models" / "assets"


def panda(*, visual: bool) -> Any:
    """Return the specification of the arm with its hand at the origin, with or without visual surfaces.

    Parts of the robot do not collide with each other, which saves time.

    Raises:
        EnvError: robosuite or mujoco is not installed.
    """
    mujoco = simulator()
    arm = mujoco.MjSpec.from_file(str(files() / "robots" / "panda" / "robot.xml"))
    hand = mujoco.MjSpec.from_file(str(files() / "grippers" / "panda_gripper.xml"))
    arm.attach(hand, frame=arm.body("right_hand").add_frame(), prefix=HAND)
    _strengthen_fingers(arm)
    for number, side in ((1, 1.0), (2, -1.0)):
        _slim(arm.geom(f"{HAND}finger{number}_collision"), side, mujoco.mjtGeom.mjGEOM_BOX)
    _strip(arm, visual=visual)
    arm.body("base").add_geom(
        name="pedestal",
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=(*_PEDESTAL, 0.5),
        pos=(_PEDESTAL_MIDDLE, 0.0, -0.5),
        rgba=(0.35, 0.36, 0.38, 1.0),
        contype=ROBOT_BIT,
        conaffinity=ASSET_BIT,
        group=2,
    )
    return arm


def _strengthen_fingers(arm: Any) -> None:
    """Give the fingers the force of a Panda, and a control range beyond contact."""
    for finger in arm.actuators:
        if finger.name.startswith(HAND):
            finger.gainprm[0], finger.biasprm[1] = _FINGER_STIFFNESS, -_FINGER_STIFFNESS
            finger.forcerange = -_SQUEEZE, _SQUEEZE
            finger.ctrlrange = -OPENING, OPENING


def _strip(arm: Any, *, visual: bool) -> None:
    """Remove sensors and optionally visual surfaces; set the bits of contacts."""
    for sensor in list(arm.sensors):
        arm.delete(sensor)
    for geom in list(arm.geoms):
        if geom.contype or geom.conaffinity:
            geom.contype, geom.conaffinity, geom.group = ROBOT_BIT, ASSET_BIT, 3
        elif visual:
            geom.group = 2
        else:
            arm.delete(geom)
    for site in arm.sites:
        site.group = 4
    used = {geom.meshname for geom in arm.geoms}
    for mesh in list(arm.meshes):
        if mesh.name not in used:
            arm.delete(mesh)


def _slim(finger: Any, side: float, box: Any) -> None:
    """Replace a finger by the box of certified grasps; the hull of its mesh is up to three times as thick."""
    half = np.array([GRIPPER.wide, GRIPPER.thick, GRIPPER.long]) / 2.0
    finger.type, finger.meshname = box, ""
    finger.size, finger.pos = half, (0.0, side * half[1], half[2])
    finger.quat = (1.0, 0.0, 0.0, 0.0)


def simulator() -> Any:
    """Return the module `mujoco`; raise an EnvError if it is not installed."""
    try:
        import mujoco
    except ImportError as error:
        raise EnvError(f"manipulation tasks run in MuJoCo: {_INSTALL}") from error
    return mujoco


def _link(axis: int, turn: float, shift: Array) -> Array:
    """Return the pose of a translation and a rotation about one of its axes, shape (4, 4) [m, rad]."""
    result, first = np.eye(4), (axis + 1) % 3
    sine, cosine = np.sin(turn), np.cos(turn)
    result[first : first + 2, first : first + 2] = [[cosine, -sine], [sine, cosine]]  # axis 0 or 2
    result[:3, 3] = shift
    return result


_FIXED = np.array([_link(0, np.pi * turn, shift) for turn, shift in zip(_TURNS, _SHIFTS, strict=True)])
_FIXED[:, :3, :3] = _FIXED[:, :3, :3].round()  # right angles
_LAST = _link(2, _TIP_TURN, np.array([0.0, 0.0, _TIP]))


def frames(angles: Array) -> Array:
    """Return the poses of the seven joints, with z along their axes, and of the tip, shape (n, 8, 4, 4).

    They are in the frame of the base, for postures of shape (n, 7) [rad].
    """
    result = np.empty((len(angles), 8, 4, 4))
    pose = np.tile(np.eye(4), (len(angles), 1, 1))
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
    """Solve inverse kinematics by several steps of damped least squares within the limits of the joints.

    From initial postures, shape (n, 7) [rad], to poses of the tips in the frame of the base, shape (n, 4, 4).
    Returns the postures and the errors of the tips: meters plus a tenth of the radians, shape (n,).
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
        # a pull towards the centers of the ranges that does not move the tip
        pull = 0.02 * (_MIDDLE - angles)
        wanted = error - np.einsum("nji,nj->ni", jacobian, pull)
        step = pull + np.einsum("nij,nj->ni", jacobian, np.linalg.solve(square, wanted[..., None])[..., 0])
        longest = np.abs(step).max(axis=1, keepdims=True)
        angles = np.clip(angles + step * np.minimum(1.0, _LONGEST / np.maximum(longest, 1e-9)), low, high)
    error = _error(frames(angles)[:, 7], tips)
    return angles, np.linalg.norm(error[:, :3], axis=1) + 0.1 * np.linalg.norm(error[:, 3:], axis=1)


def _error(poses: Array, tips: Array) -> Array:
    """Return the translations and rotations from poses to desired tips, shape (n, 6) [m, rad]."""
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
