"""A Franka Panda with its hand from the files of robosuite: its model, kinematics and controller.

The tip is the point in the middle of the fingers' pads: z points out of the hand, the fingers close along x.
A hand whose tip is at the frame of a grasp can close on it; the fingers end `GRIPPER.tip` farther out.

The controller follows relative changes of the pose of the tip. Its control law and the scale of its actions
are those of `OSC_POSE` of robosuite; the tests compare both. The controller of robosuite 1.5.0 uses an
interface that MuJoCo 4 lacks, and is slower than the physics.
"""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from scipy.linalg.lapack import dposv

from artgen._arrays import Array
from artgen.asset import rotation
from artgen.asset.affordance import GRIPPER
from artgen.errors import EnvError

PREFIX = "robot_"  # of all names of the robot in a scene
HAND = "hand_"  # of the names of the hand, after `PREFIX`
# initial posture of robosuite: the hand in front, pointing down, shape (7,) [rad]
HOME = np.array([0.0, np.pi / 16, 0.0, -5 * np.pi / 6, 0.0, np.pi - 0.2, np.pi / 4])
_LOW = [-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973]
_HIGH = [2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973]
LIMITS = np.column_stack((_LOW, _HIGH))  # of the joints of the arm, shape (7, 2) [rad]
OPENING = 0.04  # travel of each finger from the middle [m]
ROBOT_BIT, ASSET_BIT = 2, 1  # bits of MuJoCo's `contype`: an asset is exported with the first bit alone
POSITION, ROTATION = 0.05, 0.5  # translation [m] and rotation [rad] of the tip for an action of 1
STIFFNESS = 300.0  # maximum of robosuite; with its default of 150, seals keep doors shut [1/s^2]
DAMPING = 2.0 * np.sqrt(STIFFNESS)  # critical damping [1/s]
POSTURE = 10.0  # stiffness of the posture in the null space of the tip [1/s^2]
POSTURE_DAMPING = 2.0 * np.sqrt(POSTURE)  # [1/s]

_PEDESTAL = (0.11, 0.11)  # half of its width and depth [m]
_PEDESTAL_MIDDLE = -0.04  # x of the pedestal, under the foot of the arm [m]
_INSTALL = "pip install 'artgen[envs]'"
_SQUEEZE = 40.0  # largest force of a finger [N]; with robosuite's 20 N, heavy doors slip
_FINGER_STIFFNESS = 4000.0  # [N/m]

# from each joint to the next at angle 0, as in robosuite's model: a translation and quarter turns about x
_QUARTERS = (0, -1, 1, 1, -1, 1, 1)
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
# balls that fill the arm from elbow to flange
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
)  # index of the joint, center in its frame, radius [m]
BALL_JOINTS, BALL_PLACES, BALL_RADII = _BALLS[:, 0].astype(int), _BALLS[:, 1:4], _BALLS[:, 4]

_MIDDLE = LIMITS.mean(axis=1)
_DAMPING = 0.03
_MARGIN = 0.05  # distance from the limits [rad]
_LONGEST = 0.35  # largest change of an angle per step [rad]


def files() -> Path:
    """Return the directory of robosuite's models, without importing robosuite, which takes seconds."""
    found = find_spec("robosuite")
    if found is None or not found.submodule_search_locations:
        raise EnvError(f"the Panda of the manipulation tasks comes with robosuite: {_INSTALL}")
    return Path(found.submodule_search_locations[0]) / "models" / "assets"


def panda(*, visual: bool) -> Any:
    """Return the specification of the robot at the origin; its parts do not collide with each other."""
    mujoco = simulator()
    arm = mujoco.MjSpec.from_file(str(files() / "robots" / "panda" / "robot.xml"))
    hand = mujoco.MjSpec.from_file(str(files() / "grippers" / "panda_gripper.xml"))
    arm.attach(hand, frame=arm.body("right_hand").add_frame(), prefix=HAND)
    for finger in arm.actuators:
        if finger.name.startswith(HAND):  # the force of a Panda, and a control range beyond contact
            finger.gainprm[0], finger.biasprm[1] = _FINGER_STIFFNESS, -_FINGER_STIFFNESS
            finger.forcerange, finger.ctrlrange = (-_SQUEEZE, _SQUEEZE), (-OPENING, OPENING)
    half = np.array([GRIPPER.wide, GRIPPER.thick, GRIPPER.long]) / 2.0
    for number, side in ((1, 1.0), (2, -1.0)):  # the hull of their meshes is up to three times as thick
        finger = arm.geom(f"{HAND}finger{number}_collision")
        finger.type, finger.meshname, finger.size = mujoco.mjtGeom.mjGEOM_BOX, "", half
        finger.pos, finger.quat = (0.0, side * half[1], half[2]), (1.0, 0.0, 0.0, 0.0)
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


def simulator() -> Any:
    """Return the module `mujoco`; raise an EnvError if it is not installed."""
    try:
        import mujoco
    except ImportError as error:
        raise EnvError(f"manipulation tasks run in MuJoCo: {_INSTALL}") from error
    return mujoco


def _chain(angles: Array) -> Array:
    """Return the columns x, y, z and the places of joints and tip, shape (8, 4, 3, n)."""
    sines, cosines = np.sin(angles.T), np.cos(angles.T)
    result = np.empty((8, 4, 3, len(angles)))
    x, y, z = np.repeat(np.eye(3)[:, :, None], len(angles), axis=2)
    place = np.zeros_like(x)
    for index, (quarter, shift) in enumerate(zip(_QUARTERS, _SHIFTS, strict=True)):
        for column, along in zip((x, y, z), shift, strict=True):
            if along:
                place = place + along * column
        if quarter:
            y, z = quarter * z, -quarter * y
        x, y = cosines[index] * x + sines[index] * y, cosines[index] * y - sines[index] * x
        result[index] = x, y, z, place
    sine, cosine = np.sin(_TIP_TURN), np.cos(_TIP_TURN)
    result[7] = cosine * x + sine * y, cosine * y - sine * x, z, place + _TIP * z
    return result


def frames(angles: Array) -> Array:
    """Return the poses of the seven joints, with z along their axes, and of the tip, shape (n, 8, 4, 4).

    They are in the frame of the base, for postures of shape (n, 7) [rad].
    """
    result = np.zeros((len(angles), 8, 4, 4))
    result[:, :, :3] = _chain(angles).transpose(3, 0, 2, 1)
    result[:, :, 3, 3] = 1.0
    return result


def reach(angles: Array, tips: Array, steps: int) -> tuple[Array, Array]:
    """Solve inverse kinematics by several steps of damped least squares within the limits of the joints.

    From initial postures, shape (n, 7) [rad], to poses of the tips in the frame of the base, shape (n, 4, 4).
    Returns the postures and the errors of the tips: meters plus a tenth of the radians, shape (n,).
    """
    low, high = LIMITS[:, :1] + _MARGIN, LIMITS[:, 1:] - _MARGIN
    wanted = np.ascontiguousarray(tips[:, :3].transpose(2, 1, 0))  # columns first, as in a chain
    angles = np.clip(angles.T, low, high)
    jacobian = np.empty((6, 7, angles.shape[1]))
    for _ in range(steps):
        chain = _chain(angles.T)
        error = _error(chain[7], wanted)
        jacobian[3:] = axes = chain[:7, 2].transpose(1, 0, 2)
        jacobian[:3] = _cross(axes, (chain[7, 3] - chain[:7, 3]).transpose(1, 0, 2))
        square = np.einsum("ijn,kjn->ikn", jacobian, jacobian)
        square[range(6), range(6)] += _DAMPING**2
        # a pull towards the centers of the ranges that does not move the tip
        pull = 0.02 * (_MIDDLE[:, None] - angles)
        solved = _solved(square, error - np.einsum("ijn,jn->in", jacobian, pull))
        step = pull + np.einsum("ijn,in->jn", jacobian, solved)
        longest = np.abs(step).max(axis=0)
        angles = np.clip(angles + step * np.minimum(1.0, _LONGEST / np.maximum(longest, 1e-9)), low, high)
    error = _error(_chain(angles.T)[7], wanted)
    miss = np.sqrt((error[:3] ** 2).sum(axis=0)) + 0.1 * np.sqrt((error[3:] ** 2).sum(axis=0))
    return np.ascontiguousarray(angles.T), miss


def _cross(one: Array, other: Array) -> Array:
    """Return the products of vectors along the first axis."""
    (a, b, c), (d, e, f) = one, other
    return np.array([b * f - c * e, c * d - a * f, a * e - b * d])


def _solved(square: Array, right: Array) -> Array:
    """Solve positive definite systems, shape (6, 6, n), for right sides, shape (6, n), by Cholesky."""
    count = len(right)
    lower, result = square.copy(), right.copy()
    for column in range(count):
        lower[column:, column] /= np.sqrt(lower[column, column])
        result[column] /= lower[column, column]
        for row in range(column + 1, count):
            lower[row:, row] -= lower[row:, column] * lower[row, column]
            result[row] -= lower[row, column] * result[column]
    for column in reversed(range(count)):
        result[column] /= lower[column, column]
        result[:column] -= lower[column, :column] * result[column]
    return result


def _error(poses: Array, tips: Array) -> Array:
    """Return the translations and rotations from poses to desired tips, shape (6, n) [m, rad].

    Both are columns and places, shape (4, 3, n).
    """
    # the turn is the sum of products of the columns
    vector = np.sum([_cross(one, other) for one, other in zip(poses[:3], tips[:3], strict=True)], axis=0)
    trace = (poses[:3] * tips[:3]).sum(axis=(0, 1))
    sine = np.sqrt((vector**2).sum(axis=0))  # twice the sine
    angle = np.arctan2(sine, trace - 1.0)
    return np.concatenate([tips[3] - poses[3], vector * (angle / np.maximum(sine, 1e-9))])


class Control:
    """The controller of the arm, for the model of a scene and its state."""

    def __init__(self, model: Any, data: Any) -> None:
        mujoco = simulator()
        self._model, self._data = model, data
        self._jacobian_of, self._inertia_of = mujoco.mj_jacSite, mujoco.mj_fullM
        self.tip = int(model.site(f"{PREFIX}{HAND}grip_site").id)
        joint, motor = model.joint(f"{PREFIX}joint1"), model.actuator(f"{PREFIX}torq_j1")
        # the seven joints are consecutive; slices are faster than lists of indices
        self.at, self.dofs, self.actuators = (  # in `qpos`, `qvel` and `ctrl`
            slice(int(first), int(first) + 7) for first in (joint.qposadr[0], joint.dofadr[0], motor.id)
        )
        # permanent views: creating one takes as long as reading it
        whole, inertia = np.zeros((6, model.nv)), np.zeros((model.nv, model.nv))
        self._into, self._jacobian = (whole[:3], whole[3:]), whole[:, self.dofs]
        self._whole_inertia, self._inertia = inertia, inertia[self.dofs, self.dofs]
        self._angles, self._speeds = data.qpos[self.at], data.qvel[self.dofs]
        self._bias, self._torques = data.qfrc_bias[self.dofs], data.ctrl[self.actuators]
        self._place, self._turn = data.site_xpos[self.tip], data.site_xmat[self.tip].reshape(3, 3)
        self._posture = np.zeros(7)
        self._goal, self._goal_turn = np.zeros(3), np.eye(3)

    def begin(self) -> None:
        """Use the current posture as the null-space goal, and the current pose of the tip as its goal."""
        self._posture = self._angles.copy()
        self._goal, self._goal_turn = self._place.copy(), self._turn.copy()

    def velocity(self) -> Array:
        """Return the velocity of the tip, shape (6,) [m/s, rad/s]."""
        self._jacobian_of(self._model, self._data, *self._into, self.tip)
        return np.asarray(self._jacobian @ self._speeds)

    def aim(self, action: Array) -> None:
        """Set the goal to a translation and rotation of the tip, in units of `POSITION` and `ROTATION`."""
        self._goal = self._place + POSITION * action[:3]
        angle = float(np.linalg.norm(ROTATION * action[3:]))
        turn = rotation(ROTATION * action[3:] / angle, angle) if angle > 1e-9 else np.eye(3)
        self._goal_turn = turn @ self._turn

    def run(self) -> None:
        """Set the torques for the current state, after the first half of a step of MuJoCo."""
        self._jacobian_of(self._model, self._data, *self._into, self.tip)
        self._inertia_of(self._model, self._data, self._whole_inertia)
        jacobian, inertia, speeds = self._jacobian, self._inertia, self._speeds
        wanted = -DAMPING * (jacobian @ speeds)
        wanted[:3] += STIFFNESS * (self._goal - self._place)
        turn = self._goal_turn @ self._turn.T
        sines = [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
        wanted[3:] += STIFFNESS * (0.5 * np.array(sines))
        yields = jacobian @ _solve(inertia, jacobian.T)  # acceleration of the tip per force at the tip
        keep = POSTURE * (self._posture - self._angles) - POSTURE_DAMPING * speeds
        wrench = -_solve(yields, jacobian @ keep)  # cancels the effect of the posture on the tip
        # forces and torques are decoupled
        wrench[:3] += _solve(yields[:3, :3], wanted[:3])
        wrench[3:] += _solve(yields[3:, 3:], wanted[3:])
        self._torques[:] = jacobian.T @ wrench + inertia @ keep + self._bias


def _solve(matrix: Array, right: Array) -> Array:
    """Solve a system with a symmetric positive definite matrix, twice as fast as NumPy."""
    return np.asarray(dposv(matrix, right)[1])
