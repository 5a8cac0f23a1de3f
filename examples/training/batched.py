"""Learn a task in many worlds that MuJoCo Warp steps at once, on a graphics card or on the processor.

    pip install "artgen[train]" mujoco-warp
    python examples/training/batched.py PushToasterLever --assets 4 --worlds 64 --steps 200

prints the number of actions per second, beside that of `ManipulationEnv`. `--learn 1000000` trains PPO in
these worlds, with the settings of `ppo.py`. Each world keeps its asset. Worlds whose assets share structure
are stepped together, the others one group after the other. The assets have the fixed topology of their
category, which makes them one group. On a processor this is slower than `ManipulationEnv`. It is meant for
graphics cards, where the steps between two changes of the torques are one CUDA graph; it was not run on one
yet.
"""

import argparse
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from batched_maths import rewarded
from batched_worlds import Worlds, color, structured
from numpy.typing import NDArray
from ppo import SETTINGS, Progress
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import VecEnv, VecMonitor, VecNormalize

from artgen import Asset, generate
from artgen.batch import Common, groups
from artgen.dataset.plan import check_whole
from artgen.envs import TASKS, ManipulationEnv, Task
from artgen.envs.env import BONUS, JITTER, PROPRIOCEPTION, RATE, STATE
from artgen.envs.motion import Target
from artgen.envs.scene import TaskScene, compiled
from artgen.envs.task import Assets, Source, compiled_asset
from artgen.errors import EnvError, ParameterError


class BatchedTask(VecEnv):
    """Many worlds of a task, with the actions, observations and rewards of `ManipulationEnv`.

    Args:
        task: Name of a task, or a task.
        assets: As for `ManipulationEnv`; the worlds get the first suitable ones in turn.
        worlds: Number of worlds.
        seed: Seed of the first postures of the arms.
        spread: Whether the first episodes end one after another: else the short rollouts of learning are all
            of the same part of an episode.
        pictures: Pixels on a side of pictures; 0: observations are the state. With pictures, which show
            colliders, observations have the keys of those of `ManipulationEnv` with `obs="rgb"`.

    Raises:
        EnvError: No asset is suitable for the task.
        ParameterError: There are no worlds.

    Attributes:
        task: The task.
        steps: Number of actions of an episode.
        groups: The worlds that are stepped together, each with their numbers among all.
        names: Name of the asset in each world.
    """

    def __init__(
        self,
        task: str | Task,
        assets: Source = None,
        worlds: int = 64,
        *,
        seed: int | None = None,
        spread: bool = False,
        pictures: int = 0,
    ) -> None:
        check_whole("worlds", worlds, 1, 10**6)
        self.task = TASKS[task] if isinstance(task, str) else task
        self.steps = round(self.task.seconds * RATE)
        one = ManipulationEnv(self.task, assets, **_pictured(pictures))
        scenes, targets = _fit(self.task, assets, worlds)
        self.groups = _groups(scenes, targets, worlds)
        self.names = [scenes[number % len(scenes)].asset.name for number in range(worlds)]
        self.render_mode = None
        self.pictures = pictures
        super().__init__(worlds, one.observation_space, one.action_space)
        self._actions = np.zeros((worlds, 7))
        self._ages = np.zeros(worlds, int)
        self._first_ages = np.arange(worlds) * self.steps // worlds * spread
        self._rngs = [
            np.random.default_rng(None if seed is None else [seed, number]) for number in range(worlds)
        ]

    def reset(self) -> Any:
        """Begin an episode in every world; return the observations, shape (worlds, 47) without pictures."""
        for number, seed in enumerate(self._seeds):
            if seed is not None:
                self._rngs[number] = np.random.default_rng(seed)
        self._reset_seeds()
        result = np.zeros((self.num_envs, STATE), np.float32)
        everywhere = np.ones(self.num_envs, bool)
        for worlds, numbers in self.groups:
            self.begin(worlds, numbers, everywhere)
            result[numbers] = worlds.goals.observe(worlds.seen())[0].cpu().numpy()
        self._ages[:] = self._first_ages
        return self._observations(result)

    def begin(
        self, worlds: Worlds, numbers: NDArray[np.int64], ended: NDArray[np.bool_], arms: Any = None
    ) -> None:
        """Begin episodes in those worlds of a group that ended.

        Args:
            worlds: The group.
            numbers: Numbers of its worlds.
            ended: Whether each world of all ended.
            arms: Angles of the arms of the worlds that ended, shape (n, 7) [rad]; None for random ones.
        """
        within = np.flatnonzero(ended[numbers])
        if arms is None:
            turns = [self._rngs[number].uniform(-1.0, 1.0, 7) for number in numbers[within]]
            arms = worlds.goals.arm[within] + JITTER * torch.as_tensor(np.array(turns)).to(worlds.goals.arm)
        worlds.begin(
            torch.as_tensor(within).to(worlds.goals.worlds), torch.as_tensor(arms).to(worlds.goals.arm)
        )
        self._ages[numbers[within]] = 0

    def step_async(self, actions: NDArray[np.float32]) -> None:
        """Set the next actions, shape (worlds, 7)."""
        if np.shape(actions) != (self.num_envs, 7) or not np.isfinite(actions).all():
            raise ParameterError(f"actions of {self.num_envs} worlds are finite, shape ({self.num_envs}, 7)")
        self._actions = np.clip(np.asarray(actions, float), -1.0, 1.0)

    def step_wait(self) -> tuple[Any, NDArray[np.float32], NDArray[np.bool_], list[dict[str, Any]]]:
        """Simulate the actions; return observations, rewards, whether each world ended, and infos.

        A world that ended has begun again: its last observation is the `terminal_observation` of its info.
        """
        observations = np.zeros((self.num_envs, STATE), np.float32)
        gained, success = np.zeros(self.num_envs, np.float32), np.zeros(self.num_envs, bool)
        infos: list[dict[str, Any]] = [{"asset": name} for name in self.names]
        self._ages += 1
        for worlds, numbers in self.groups:
            goals = worlds.goals
            actions = torch.as_tensor(self._actions[numbers]).to(goals.arm)
            worlds.act(actions)
            observed, progress, distance = goals.observe(worlds.seen())
            observations[numbers] = observed.cpu().numpy()
            stage, done = goals.stage, goals.done.all(dim=1)
            current = progress[goals.worlds, stage]
            gained[numbers] = rewarded(
                stage, goals.count, current, distance, actions, self.steps, done=done
            ).cpu()
            success[numbers] = done.cpu()
            for number, of_stages, count in zip(
                numbers, progress.tolist(), goals.count.tolist(), strict=True
            ):
                infos[number]["progress"] = of_stages[:count]
        gained[success] += BONUS
        broken = ~np.isfinite(observations).all(axis=1)  # unstable simulations
        observations[broken] = gained[broken] = 0.0
        late = self._ages >= self.steps
        ended = success | late | broken
        last = self._observations(observations.copy()) if ended.any() else observations
        for number, info in enumerate(infos):
            info["success"] = bool(success[number])
            if ended[number]:
                info["terminal_observation"] = (
                    {name: each[number] for name, each in last.items()} if self.pictures else last[number]
                )
                info["TimeLimit.truncated"] = bool(late[number] and not success[number])
        for worlds, numbers in self.groups:
            if ended[numbers].any():
                self.begin(worlds, numbers, ended)
                fresh = ended[numbers]
                begun = worlds.goals.observe(worlds.seen())[0].cpu().numpy()
                observations[numbers[fresh]] = begun[fresh]
        return self._observations(observations), gained, ended, infos

    def _observations(self, states: NDArray[np.float32]) -> Any:
        """Return the observations of all worlds in a state, shape (worlds, 47)."""
        if not self.pictures:
            return states
        shape = (self.num_envs, self.pictures, self.pictures, 3)
        result: dict[str, Any] = {"robot": states[:, :PROPRIOCEPTION]}
        result |= {key: np.zeros(shape, np.uint8) for key in ("rgb", "hand_rgb")}
        for worlds, numbers in self.groups:
            drawn = worlds.pictures(self.pictures)
            for key, camera in (("rgb", "front"), ("hand_rgb", "hand")):
                result[key][numbers] = (255.0 * drawn[camera].clamp(0.0, 1.0)).byte().cpu().numpy()
        return result

    def close(self) -> None:
        """Free the models."""
        self.groups = []

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Return an attribute for worlds; all have the same."""
        return [getattr(self, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Refuse: worlds have no attributes of their own."""
        raise EnvError(f"worlds that are stepped together have no {attr_name!r} of their own")

    def env_method(self, method_name: str, *args: Any, indices: Any = None, **kwargs: Any) -> list[Any]:
        """Refuse: worlds have no methods of their own."""
        raise EnvError(f"worlds that are stepped together have no {method_name!r} of their own")

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        """Tell that no world is wrapped."""
        return [False] * len(list(self._get_indices(indices)))


def _pictured(pictures: int) -> dict[str, Any]:
    """Return the options of `ManipulationEnv` with the same observations."""
    return {"obs": "rgb", "size": pictures} if pictures else {}


def _fit(task: Task, source: Source, most: int) -> tuple[list[TaskScene], list[Target]]:
    """Return placed scenes of the first suitable assets, and the stages of the task in them."""
    assets = Assets(task, source)
    found: list[tuple[Asset, Target]] = []
    reason = ""
    for key in assets.keys[: 10 * most]:
        asset = compiled_asset(assets, key, visual=False, textures=0, most=most)
        try:
            found.append((asset.asset, asset.target(0)))
        except EnvError as error:
            reason = str(error)
        if len(found) == most:
            break
    if not found:
        raise EnvError(f"{task.name} found no suitable asset; the last one: {reason}")
    common: dict[int, Common] = {}
    for alike in groups([asset for asset, _ in found], "mjlab"):
        common |= dict.fromkeys(map(id, alike), Common.of(alike))
    scenes = [TaskScene(asset, compiled(asset, common=common[id(asset)])) for asset, _ in found]
    targets = [target for _, target in found]
    for scene, target in zip(scenes, targets, strict=True):
        color(scene)
        scene.place(target, target.arm)
    return scenes, targets


def _groups(
    scenes: Sequence[TaskScene], targets: Sequence[Target], worlds: int
) -> list[tuple[Worlds, NDArray[np.int64]]]:
    """Return worlds by the structure of their assets, with their numbers."""
    kinds: dict[Any, list[tuple[int, Any]]] = {}
    for number, scene in enumerate(scenes):
        kind, model = structured(scene)
        kinds.setdefault(kind, []).append((number, model))
    result = []
    for found in kinds.values():
        mine = [number for number, _ in found]
        numbers = np.array([number for number in range(worlds) if number % len(scenes) in mine])
        of = [mine.index(int(number) % len(scenes)) for number in numbers]
        group = Worlds(
            [scenes[number] for number in mine],
            [model for _, model in found],
            [targets[number] for number in mine],
            of,
        )
        result.append((group, numbers))
    return result


def learn(batch: BatchedTask, steps: int, seed: int, out: Path) -> None:
    """Train with PPO; write the policy and the normalization of observations."""
    policy, numbers = ("MultiInputPolicy", ["robot"]) if batch.pictures else ("MlpPolicy", None)
    training = VecNormalize(VecMonitor(batch, info_keywords=("success",)), gamma=0.99, norm_obs_keys=numbers)
    n_steps = max(4096 // batch.num_envs, 16)
    model = PPO(policy, training, n_steps=n_steps, **SETTINGS, seed=seed, device="cpu")
    model.learn(steps, callback=Progress())
    out.mkdir(parents=True, exist_ok=True)
    model.save(out / "policy")
    training.save(str(out / "normalization.pkl"))


def speeds(batch: BatchedTask, seeds: range, steps: int) -> tuple[float, float]:
    """Return the random actions per second of all worlds together, and of one `ManipulationEnv`.

    Args:
        batch: The worlds.
        seeds: Seeds of the assets of `ManipulationEnv`.
        steps: Number of actions of each world, and of `ManipulationEnv`.
    """
    rng = np.random.default_rng(0)
    batch.reset()
    batch.step(rng.uniform(-1.0, 1.0, (batch.num_envs, 7)))  # compiles the kernels
    start = time.perf_counter()
    for _ in range(steps):
        batch.step(rng.uniform(-1.0, 1.0, (batch.num_envs, 7)))
    together = batch.num_envs * steps / (time.perf_counter() - start)
    env = ManipulationEnv(batch.task, seeds, shuffle=False, **_pictured(batch.pictures))
    for _ in seeds:
        env.reset()  # makes the models
    start = time.perf_counter()
    for _ in range(steps):
        _, _, terminated, truncated, _ = env.step(rng.uniform(-1.0, 1.0, 7))
        if terminated or truncated:
            env.reset()
    return together, steps / (time.perf_counter() - start)


def main() -> None:
    """Measure, and train on request."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("task", choices=sorted(TASKS))
    parser.add_argument("--assets", type=int, default=4, help="number of assets, of seeds from 0 on")
    parser.add_argument("--worlds", type=int, default=64)
    parser.add_argument("--steps", type=int, default=200, help="timed actions of each world; 0 for none")
    parser.add_argument("--learn", type=int, default=0, help="steps of the training, of all worlds together")
    parser.add_argument("--pictures", type=int, default=0, help="pixels on a side of observed pictures")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("batched"))
    options = parser.parse_args()
    check_whole("steps", options.steps, 0, 10**9)
    seeds, task = range(options.assets), TASKS[options.task]
    assets = [
        generate(task.category, seed, topology="fixed", certify="later", **task.overrides) for seed in seeds
    ]
    batch = BatchedTask(
        options.task,
        assets,
        options.worlds,
        seed=options.seed,
        spread=options.learn > 0,
        pictures=options.pictures,
    )
    print(
        f"{options.worlds} worlds of {len(set(batch.names))} assets in {len(batch.groups)} groups", flush=True
    )
    if options.steps:
        together, alone = speeds(batch, seeds, options.steps)
        print(f"batched: {together:,.0f} actions/s; ManipulationEnv: {alone:,.0f} actions/s")
        print(f"ratio: {together / alone:.2f}")
    if options.learn:
        learn(batch, options.learn, options.seed, options.out / options.task)


if __name__ == "__main__":
    main()
