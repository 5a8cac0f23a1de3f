"""Operational-space control of the Panda: its tip follows changes of its pose.

The law and the scale of actions are those of robosuite's controller `OSC_POSE`, and the tests hold them
against it. It is written out here because the one that robosuite 1.5.0 ships calls MuJoCo in a way that
MuJoCo 4 no longer knows, and takes longer than the physics.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.linalg.lapack import dposv

from artgen._arrays import Array
from artgen.asset import rotation
from artgen.envs.robot import HAND, PREFIX, simulator

POSITION, ROTATION = 0.05, 0.5
"""How far the tip is asked to go by an action of 1 [m], [rad]."""

STIFFNESS = 300.0  # the most that robosuite allows; with its usual 150 seals of doors stay shut [1/s^2]
DAMPING = 2.0 * np.sqrt(STIFFNESS)  # critical [1/s]
POSTURE = 10.0  # how stiffly the arm keeps its posture, as far as the tip leaves it free [1/s^2]
POSTURE_DAMPING = 2.0 * np.sqrt(POSTURE)


class Control:
    """Finds the torques of the arm that bring the tip to its goal.

    Args:
        model: MuJoCo's model of a scene with the robot.
        data: Its state.

    Attributes:
        tip: Number of the site at the tip.
        at: Where the seven positions of the arm are in `qpos`.
        dofs: Where its speeds are in `qvel`.
        actuators: Where its torques are in `ctrl`.
    """

    def __init__(self, model: Any, data: Any) -> None:
        mujoco = simulator()
        self._model, self._data = model, data
        self._jacobian_of, self._inertia_of = mujoco.mj_jacSite, mujoco.mj_fullM
        self.tip = int(model.site(f"{PREFIX}{HAND}grip_site").id)
        joints = [model.joint(f"{PREFIX}joint{number}") for number in range(1, 8)]
        # the seven joints follow each other, so slices do for them, which are quicker than lists of indices
        self.at = _slice([joint.qposadr[0] for joint in joints])
        self.dofs = _slice([joint.dofadr[0] for joint in joints])
        self.actuators = _slice([model.actuator(f"{PREFIX}torq_j{number}").id for number in range(1, 8)])
        # views, which stay: asking for them takes as long as reading them
        whole, inertia = np.zeros((6, model.nv)), np.zeros((model.nv, model.nv))
        self._into, self._jacobian = (whole[:3], whole[3:]), whole[:, self.dofs]
        self._whole_inertia, self._inertia = inertia, inertia[self.dofs, self.dofs]
        self._angles, self._speeds = data.qpos[self.at], data.qvel[self.dofs]
        self._bias, self._torques = data.qfrc_bias[self.dofs], data.ctrl[self.actuators]
        self._place, self._turn = data.site_xpos[self.tip], data.site_xmat[self.tip].reshape(3, 3)
        self._posture = np.zeros(7)
        self._goal, self._goal_turn = np.zeros(3), np.eye(3)

    def begin(self) -> None:
        """Take the arm as it stands for the posture that it keeps, and the tip's pose for its goal."""
        self._posture = self._angles.copy()
        self._goal, self._goal_turn = self._place.copy(), self._turn.copy()

    def velocity(self) -> Array:
        """Return how fast the tip moves and turns, shape (6,) [m/s, rad/s]."""
        self._jacobian_of(self._model, self._data, *self._into, self.tip)
        return np.asarray(self._jacobian @ self._speeds)

    def aim(self, action: Array) -> None:
        """Set the goal: so far from where the tip is.

        Args:
            action: Shift and turn (about an axis, by its length) along the axes of the world, in shares of
                `POSITION` and `ROTATION`, shape (6,).
        """
        self._goal = self._place + POSITION * action[:3]
        self._goal_turn = _rotation(ROTATION * action[3:]) @ self._turn

    def run(self) -> None:
        """Set the motors for the state as it is; what follows from positions and speeds has been computed."""
        self._jacobian_of(self._model, self._data, *self._into, self.tip)
        self._inertia_of(self._model, self._data, self._whole_inertia)
        jacobian, inertia, speeds = self._jacobian, self._inertia, self._speeds
        wanted = -DAMPING * (jacobian @ speeds)
        wanted[:3] += STIFFNESS * (self._goal - self._place)
        wanted[3:] += STIFFNESS * _turn_between(self._turn, self._goal_turn)
        yields = jacobian @ self._solve(inertia, jacobian.T)  # acceleration of the tip by a force at it
        keep = POSTURE * (self._posture - self._angles) - POSTURE_DAMPING * speeds
        wrench = -self._solve(yields, jacobian @ keep)  # what keeping the posture would do to the tip
        # forces as if there were no torques, and torques as if there were no forces
        wrench[:3] += self._solve(yields[:3, :3], wanted[:3])
        wrench[3:] += self._solve(yields[3:, 3:], wanted[3:])
        self._torques[:] = jacobian.T @ wrench + inertia @ keep + self._bias

    @staticmethod
    def _solve(matrix: Array, right: Array) -> Array:
        """Solve a system whose matrix is symmetric and positive definite; NumPy's way takes twice as long."""
        return np.asarray(dposv(matrix, right)[1])


def _slice(indices: Sequence[int]) -> slice:
    return slice(int(indices[0]), int(indices[-1]) + 1)


def _turn_between(of: Array, to: Array) -> Array:
    """Return the turn from one frame to another as an axis times the sine of the angle, shape (3,)."""
    turn = to @ of.T
    return 0.5 * np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])


def _rotation(vector: Array) -> Array:
    """Return the matrix of a turn about a vector by its length, shape (3, 3) [rad]."""
    angle = float(np.linalg.norm(vector))
    return rotation(vector / angle, angle) if angle > 1e-9 else np.eye(3)
