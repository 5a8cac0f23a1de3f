"""What a policy observes: numbers about the robot and about what it has to move, along the world's axes."""

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.envs.motion import Stage, tip_of
from artgen.envs.robot import OPENING
from artgen.envs.scene import Scene

PROPRIOCEPTION = 30
"""Numbers that `proprioception` returns."""

STATE = PROPRIOCEPTION + 17
"""Numbers that `state` returns."""

_SPEED = 0.5  # what speeds are multiplied by, so that most numbers are within 1


def handle(scene: Scene, stage: Stage) -> Array:
    """Return where the tip should be to move the joint of a stage, as it stands now, shape (4, 4) [m]."""
    affordance = stage.affordance
    return np.asarray(scene.pose(affordance.link) @ tip_of(affordance))


def proprioception(scene: Scene, base: Array) -> NDArray[np.float32]:
    """Return what a robot knows of itself, shape (30,).

    In order: angles of the arm (7) [rad], half their speeds (7) [rad/s], place of the tip from the robot's
    base (3) [m], its x and z axes (6), half its velocity (3) [m/s] and half its turning (3) [rad/s], and how
    far the hand is open (1), 0-1.

    Args:
        scene: The scene.
        base: Pose of the robot's base, shape (4, 4).
    """
    control, tip = scene.control, scene.tip()
    speeds = scene.speeds[control.dofs]
    return np.concatenate(
        [
            scene.data.qpos[control.at],
            _SPEED * speeds,
            tip[:3, 3] - base[:3, 3],
            tip[:3, 0],
            tip[:3, 2],
            _SPEED * control.velocity(),
            [scene.opening() / (2.0 * OPENING)],
        ],
        dtype=np.float32,
    )


def state(scene: Scene, base: Array, stage: Stage, pose: Array, share: float) -> NDArray[np.float32]:
    """Return what the robot knows of itself and all that matters of the asset, shape (47,).

    After `proprioception`: the way from the tip to the handle (3) [m], the handle's x and z axes (6), along
    which fingers close on it and the hand comes, where it goes as its joint moves to the goal (3), how far
    the joint is, 0-1, how far it has to go [rad or m] and how fast it goes there [rad/s or m/s], whether
    fingers take hold of it, and which share of the task's stages is done.

    Args:
        scene: The scene.
        base: Pose of the robot's base, shape (4, 4).
        stage: What the robot is at.
        pose: The stage's `handle`, shape (4, 4).
        share: Of the stages that are done, 0-1.
    """
    toward = np.sign(stage.goal - stage.start)
    way = toward * scene.motion(stage.joint, pose[:3, 3])
    position = scene.q(stage.joint)
    of_asset = np.concatenate(
        [
            pose[:3, 3] - scene.tip()[:3, 3],
            pose[:3, 0],
            pose[:3, 2],
            way / max(float(np.linalg.norm(way)), 1e-9),
            [
                stage.progress(position),
                toward * (stage.goal - position),
                toward * scene.speed(stage.joint),
            ],
            [float(stage.affordance.kind == "grasp"), share],
        ],
        dtype=np.float32,
    )
    return np.concatenate([proprioception(scene, base), of_asset])
