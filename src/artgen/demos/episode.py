"""One demonstration: what the scripted policy sees and does in a task, with one asset."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.errors import EnvError, ParameterError, nearest

Array = NDArray[Any]

_AFTERWARDS = 40  # most steps that are recorded once the task is done, in which the hand lets go


@dataclass(frozen=True, eq=False)
class Demo:
    """An episode of n steps.

    Attributes:
        seed: Of the asset, and of all that is drawn.
        asset: Its name.
        success: Whether the task was done.
        observations: By name, before the first step and after each, shape (n + 1, ...).
        actions: What the policy wanted in each step, shape (n, 7), in [-1, 1].
        applied: What was done, with the noise.
        rewards: Shape (n,).
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
    """Refuse a task that there is not, or that cannot be done here."""
    try:
        from artgen.envs import TASKS
    except ImportError as error:
        raise EnvError(f"tasks need the package {error.name}: pip install 'artgen[envs]'") from error
    if task not in TASKS:
        raise ParameterError(f"there is no task {task!r}.{nearest(task, TASKS)}")


def record(task: str, seed: int, *, image: int = 0, noise: float = 0.0) -> Demo:
    """Let the scripted policy do a task once.

    Args:
        task: Its name.
        seed: Of the asset, and of all that is drawn.
        image: Pixels on a side of the pictures among the observations; 0 for none.
        noise: Spread of what is added at random to the motion of the arm.

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
    """Step through an episode, and a little on after the task is done."""
    env.reset(seed=seed, options={"asset": seed})
    scene, rng = env.unwrapped, np.random.default_rng((seed, 1))
    states, seen = [_state(scene)], [_observations(scene, image)]
    wanted, applied, rewards = [], [], []
    success, over, left = False, False, _AFTERWARDS
    while not over and left > 0 and not (success and policy.done):
        action = np.clip(policy.action(), -1.0, 1.0).astype(np.float32)
        done = action.copy()
        done[:6] = np.clip(
            done[:6] + noise * rng.standard_normal(6), -1.0, 1.0
        )  # the fingers do as they should
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
    """Return the state of the simulation as robosuite flattens it."""
    return np.concatenate(([scene.data.time], scene.data.qpos, scene.data.qvel))


def _observations(scene: Any, image: int) -> dict[str, Array]:
    """Return what is seen now."""
    found: dict[str, Array] = {"state": scene.state()}
    if image:
        found["image"] = scene.picture(image, camera="front")
        found["hand_image"] = scene.picture(image, camera="hand")
    return found
