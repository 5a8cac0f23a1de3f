"""Operational-space control of the Panda: the tip follows relative changes of its pose.

The control law and the scale of actions are those of `OSC_POSE` of robosuite; the tests compare both. The
controller of robosuite 1.5.0 uses an interface that MuJoCo 4 lacks, and is slower than the physics.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.linalg.lapack import dposv

from artgen._arrays import Array
from artgen.asset import rotation
from artgen.envs.robot import HAND, PREFIX, simulator

POSITION, ROTATION = 0.05, 0.5
"""Translation and rotation of the tip for an action of 1 [m], [rad]."""

STIFFNESS = 300.0  # maximum of robosuite; with its default of 150, seals keep doors shut [1/s^2]
DAMPING = 2.0 * np.sqrt(STIFFNESS)  # critical damping [1/s]
POSTURE = 10.0  # stiffness of the posture in the null space of the tip [1/s^2]
POSTURE_DAMPING = 2.0 * np.sqrt(POSTURE)


class Control:
    """The controller of the arm, for the model of a scene and its state.

    Attributes:
        tip: Index of the site at the tip.
        at: Slice of the seven positions of the arm in `qpos`.
        dofs: Slice of its speeds in `qvel`.
        actuators: Slice of its torques in `ctrl`.
    """

    def __init__(self, model: Any, data: Any) -> None:
        mujoco = simulator()
        self._model, self._data = model, data
        self._jacobian_of, self._inertia_of = mujoco.mj_jacSite, mujoco.mj_fullM
        self.tip = int(model.site(f"{PREFIX}{HAND}grip_site").id)
        joints = [model.joint(f"{PREFIX}joint{number}") for number in range(1, 8)]
        # the seven joints are consecutive; slices are faster than lists of indices
        self.at = _slice([joint.qposadr[0] for joint in joints])
        self.dofs = _slice([joint.dofadr[0] for joint in joints])
        self.actuators = _slice([model.actuator(f"{PREFIX}torq_j{number}").id for number in range(1, 8)])
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
        self._goal_turn = _rotation(ROTATION * action[3:]) @ self._turn

    def run(self) -> None:
        """Set the torques for the current state, after the first half of a step of MuJoCo."""
        self._jacobian_of(self._model, self._data, *self._into, self.tip)
        self._inertia_of(self._model, self._data, self._whole_inertia)
        jacobian, inertia, speeds = self._jacobian, self._inertia, self._speeds
        wanted = -DAMPING * (jacobian @ speeds)
        wanted[:3] += STIFFNESS * (self._goal - self._place)
        wanted[3:] += STIFFNESS * _turn_between(self._turn, self._goal_turn)
        yields = jacobian @ self._solve(inertia, jacobian.T)  # acceleration of the tip per force at the tip
        keep = POSTURE * (self._posture - self._angles) - POSTURE_DAMPING * speeds
        wrench = -self._solve(yields, jacobian @ keep)  # cancels the effect of the posture on the tip
        # forces and torques are decoupled
        wrench[:3] += self._solve(yields[:3, :3], wanted[:3])
        wrench[3:] += self._solve(yields[3:, 3:], wanted[3:])
        self._torques[:] = jacobian.T @ wrench + inertia @ keep + self._bias

    @staticmethod
    def _solve(matrix: Array, right: Array) -> Array:
        """Solve a system with a symmetric positive definite matrix, twice as fast as NumPy."""
        return np.asarray(dposv(matrix, right)[1])


def _slice(indices: Sequence[int]) -> slice:
    return slice(int(indices[0]), int(indices[-1]) + 1)


def _turn_between(of: Array, to: Array) -> Array:
    """Return the rotation between two frames as an axis times the sine of the angle, shape (3,)."""
    turn = to @ of.T
    return 0.5 * np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])


def _rotation(vector: Array) -> Array:
    """Return the matrix of a rotation vector, shape (3, 3) [rad]."""
    angle = float(np.linalg.norm(vector))
    return rotation(vector / angle, angle) if angle > 1e-9 else np.eye(3)
