"""Learn a task with PPO on a few assets, and see how it does on assets that it has never met.

    pip install "artgen[train]"
    python examples/training/ppo.py PushToasterLever --assets 1 10 100 --steps 1000000

One policy is learnt for each number of training assets, all with the same number of steps, and tried on the
same held-out assets: the table at the end tells what the diversity of assets is worth. A big machine changes
nothing but `--steps` and `--processes`.
"""

import argparse
import json
import math
import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.monitor import Monitor
from stable_baselines3.common.vec_env import SubprocVecEnv, VecNormalize

import artgen.envs  # registers the tasks

HELD_OUT = 1_000_000  # seeds from here on are not trained on
SETTINGS: dict[str, Any] = {
    "batch_size": 512,
    "n_epochs": 8,
    "learning_rate": 3e-4,
    "gamma": 0.99,
    "ent_coef": 0.0,
    "target_kl": 0.05,
    "policy_kwargs": {"net_arch": [256, 256], "log_std_init": -0.7},
}
"""Of PPO, for tasks of some seconds."""


def made(task: str, seeds: range, **options: Any) -> Callable[[], gymnasium.Env[Any, Any]]:
    """Return what makes one environment, in a process of its own."""

    def make() -> gymnasium.Env[Any, Any]:
        torch.set_num_threads(1)
        return Monitor(
            gymnasium.make(f"artgen/{task}-v0", assets=seeds, **options), info_keywords=("success",)
        )

    return make


@contextmanager
def environments(task: str, seeds: range, processes: int, **normalized: Any) -> Iterator[VecNormalize]:
    """Yield environments in processes of their own, each with its share of the assets."""
    shares = [seeds[number::processes] or seeds for number in range(processes)]
    vector = SubprocVecEnv([made(task, share) for share in shares], start_method="spawn")
    try:
        yield VecNormalize(vector, gamma=0.99, **normalized)
    finally:
        vector.close()


class Progress(BaseCallback):
    """Prints the share of successes among the last episodes, and ends when the time is over."""

    def __init__(self, minutes: float = math.inf) -> None:
        super().__init__()
        self.end = time.monotonic() + 60.0 * minutes

    def _on_step(self) -> bool:
        return time.monotonic() < self.end

    def _on_rollout_end(self) -> None:
        episodes = self.model.ep_info_buffer or ()
        if episodes:
            success = np.mean([episode["success"] for episode in episodes])
            reward = np.mean([episode["r"] for episode in episodes])
            print(f"{self.num_timesteps:9,} steps: success {success:.2f}, return {reward:.1f}", flush=True)


def learn(task: str, seeds: range, options: argparse.Namespace, out: Path) -> dict[str, Any]:
    """Learn on the assets of some seeds; keep the policy and what the observations are divided by."""
    start = time.perf_counter()
    with environments(task, seeds, options.processes) as training:
        model = PPO(
            "MlpPolicy",
            training,
            n_steps=4096 // options.processes,
            **SETTINGS,
            seed=options.seed,
            device="cpu",
        )
        model.learn(options.steps, callback=Progress(options.minutes))
        model.save(out / "policy")
        training.save(str(out / "normalization.pkl"))
    return {"steps": model.num_timesteps, "minutes": (time.perf_counter() - start) / 60.0}


def tried(task: str, out: Path, episodes: int, processes: int, *, sampled: bool = False) -> float:
    """Return the share of successes of a policy on assets that it has not met, one episode each.

    Actions are the means of the policy, or sampled from it, as while it learned.
    """
    model = PPO.load(out / "policy", device="cpu")
    model.set_random_seed(0)
    seeds = range(HELD_OUT, HELD_OUT + episodes)
    shares = [seeds[number::processes] for number in range(processes)]
    vector = SubprocVecEnv([made(task, share, shuffle=False) for share in shares], start_method="spawn")
    try:
        trial = VecNormalize.load(str(out / "normalization.pkl"), vector)
        trial.training = trial.norm_reward = False
        observation = trial.reset()
        successes: list[list[bool]] = [[] for _ in shares]
        while any(len(mine) < len(share) for mine, share in zip(successes, shares, strict=True)):
            action, _ = model.predict(observation, deterministic=not sampled)
            observation, _, dones, infos = trial.step(action)
            for number in np.flatnonzero(dones):
                successes[number].append(bool(infos[number]["success"]))
    finally:
        vector.close()
    counted = [mine[: len(share)] for mine, share in zip(successes, shares, strict=True)]
    return float(np.mean(np.concatenate(counted)))


def main() -> None:
    """Learn once for each number of assets and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("task", choices=sorted(artgen.envs.TASKS))
    parser.add_argument(
        "--assets", type=int, nargs="+", default=[1, 10, 100], help="numbers of training assets"
    )
    parser.add_argument("--steps", type=int, default=1_000_000, help="steps of the environments for each")
    parser.add_argument(
        "--minutes", type=float, default=60.0, help="the most that the learning of each may take"
    )
    parser.add_argument("--processes", type=int, default=min(2 * (os.cpu_count() or 1), 128))
    parser.add_argument("--episodes", type=int, default=100, help="held-out assets")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("ppo"))
    options = parser.parse_args()
    rows = []
    for count in options.assets:
        out = options.out / f"{options.task}_{count}"
        out.mkdir(parents=True, exist_ok=True)
        row = {"assets": count, **learn(options.task, range(count), options, out)}
        for name, sampled in (("mean", False), ("sampled", True)):
            row[name] = tried(options.task, out, options.episodes, options.processes, sampled=sampled)
        rows.append(row)
        (options.out / f"{options.task}.json").write_text(json.dumps(rows, indent=1) + "\n")
    print("\nsuccess on held-out assets, with mean and with sampled actions")
    print("training assets |     steps | minutes | mean | sampled")
    for row in rows:
        numbers = f"{row['assets']:15} | {row['steps']:9,} | {row['minutes']:7.1f}"
        print(f"{numbers} | {row['mean']:.2f} | {row['sampled']:7.2f}")


if __name__ == "__main__":
    main()
