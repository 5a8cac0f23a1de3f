"""One demonstration: observations and actions of the scripted policy in a task, with one asset."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.errors import EnvError, ParameterError, nearest

Array = NDArray[Any]

_AFTERWARDS = 40  # most steps after success, in which the hand releases


@dataclass(frozen=True, eq=False)
class Demo:
    """An episode of n steps.

    Attributes:
        seed: Seed of the asset and of all random numbers.
        asset: Name of the asset.
        success: Whether the task succeeded.
        observations: Observations by name, before the first step and after each, shape (n + 1, ...).
        actions: Action of the policy in each step, shape (n, 7), in [-1, 1].
        applied: The actions with noise, shape (n, 7), in [-1, 1].
        rewards: Reward of each step, shape (n,).
        dones: 1 in the last step, else 0, shape (n,).
        states: Time, positions and velocities of MuJoCo before each step, shape (n, m).
    """

    seed: int
    asset: str
    success: bool
    observations: dict[str, Array]
    actions: Array
    applied: Array
    rewards: Array
    dones: Array
    states: Array

    def __len__(self) -> int:
        return len(self.actions)


def check_task(task: str) -> None:
    """Check that a task exists and the environments are installed."""
    try:
        from artgen.envs import TASKS
    except ImportError as error:
        raise EnvError(f"tasks need the package {error.name}: pip install 'artgen[envs]'") from error
    if task not in TASKS:
        raise ParameterError(f"there is no task {task!r}.{nearest(task, TASKS)}")


def record(task: str, seed: int, *, image: int = 0, noise: float = 0.0) -> Demo:
    """Record one attempt of the scripted policy at a task.

    Args:
        task: Name of the task.
        seed: Seed of the asset and of all random numbers.
        image: Pixels per side of the pictures in the observations; 0 for none.
        noise: Standard deviation of the noise on the motion of the arm.

    Raises:
        ParameterError: There is no such task.
        EnvError: The environment cannot be made.
    """
    check_task(task)
    import gymnasium

    from artgen.envs.policy import ScriptedPolicy

    env = gymnasium.make(
        f"artgen/{task}-v0",
        terminate_on_success=False,
        render_mode="rgb_array" if image else None,
    )
    try:
        return _episode(env, ScriptedPolicy(env.unwrapped), seed, image, noise)
    finally:
        env.close()


def _episode(env: Any, policy: Any, seed: int, image: int, noise: float) -> Demo:
    """Step through an episode, with some more steps after success."""
    env.reset(seed=seed, options={"asset": seed})
    scene, rng = env.unwrapped, np.random.default_rng((seed, 1))
    states, seen = [_state(scene)], [_observations(scene, image)]
    wanted, applied, rewards = [], [], []
    success, over, left = False, False, _AFTERWARDS
    while not over and left > 0 and not (success and policy.done):
        action = np.clip(policy.action(), -1.0, 1.0).astype(np.float32)
        done = action.copy()
        # no noise on the fingers
        done[:6] = np.clip(done[:6] + noise * rng.standard_normal(6), -1.0, 1.0)
        _, reward, ended, truncated, info = env.step(done)
        states.append(_state(scene))
        seen.append(_observations(scene, image))
        wanted.append(action)
        applied.append(done)
        rewards.append(float(reward))
        success, over = success or bool(info["success"]), ended or truncated
        left -= success
    dones = np.zeros(len(wanted), np.int64)
    dones[-1] = 1
    return Demo(
        seed,
        scene.asset.name,
        success,
        {key: np.stack([each[key] for each in seen]) for key in seen[0]},
        np.stack(wanted),
        np.stack(applied),
        np.array(rewards),
        dones,
        np.stack(states[:-1]),
    )


def _state(scene: Any) -> Array:
    """Return the state of the simulation in the order of robosuite."""
    return np.concatenate(([scene.data.time], scene.data.qpos, scene.data.qvel))


def _observations(scene: Any, image: int) -> dict[str, Array]:
    """Return the observations of the current state."""
    found: dict[str, Array] = {"state": scene.state()}
    if image:
        found["image"] = scene.picture(image, camera="front")
        found["hand_image"] = scene.picture(image, camera="hand")
    return found
