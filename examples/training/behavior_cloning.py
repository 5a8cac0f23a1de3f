"""Imitate the scripted policy of a task, and see how it does with assets that it has never met.

    pip install "artgen[demos,train]"
    artgen demos OpenDrawer -n 150 --noise 0.1 --out demos
    python examples/training/behavior_cloning.py demos/demo.hdf5

A small network learns from `mask/train` which actions follow an observation: eight of them, which it does
before it looks again. The assets that it is tried on are in no file that is made of seeds below a million.
"""

import argparse
import itertools
import json
import multiprocessing
import os
import time
from functools import partial
from pathlib import Path
from typing import Any

import gymnasium
import h5py
import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

import artgen.envs  # noqa: F401 - registers the tasks

Array = NDArray[Any]

HELD_OUT = 1_000_000  # seeds from here on are not trained on
AHEAD = 8  # actions that are told from one observation and done before the next look; fewer hesitate


class Policy(nn.Module):
    """Tells the next actions from an observation."""

    def __init__(self, observations: int, actions: int, width: int = 512) -> None:
        super().__init__()
        self.mean: Tensor
        self.spread: Tensor
        self.register_buffer("mean", torch.zeros(observations))
        self.register_buffer("spread", torch.ones(observations))
        self.actions = actions
        sizes = (observations, width, width, width)
        layers = [
            nn.Sequential(nn.Linear(a, b), nn.LayerNorm(b), nn.ReLU()) for a, b in itertools.pairwise(sizes)
        ]
        self.layers = nn.Sequential(*layers, nn.Linear(width, AHEAD * actions))

    def forward(self, observations: Tensor) -> Tensor:
        """Return the next actions, shape (n, AHEAD, actions)."""
        told = self.layers(((observations - self.mean) / self.spread).clamp(-5.0, 5.0))
        return told.view(-1, AHEAD, self.actions)


def examples(file: Path, mask: str) -> tuple[Tensor, Tensor]:
    """Return the observations of demonstrations, and the actions that follow each; the last is repeated."""
    seen, done = [], []
    with h5py.File(file, "r") as data:
        for name in data["mask"][mask][:]:
            demo = data["data"][name.decode()]
            actions = demo["actions"][:]
            following = np.minimum(np.arange(len(actions))[:, None] + np.arange(AHEAD), len(actions) - 1)
            seen.append(demo["obs"]["state"][:])
            done.append(actions[following])
    if not seen:
        raise SystemExit(f"error: {file} has nothing in mask/{mask}; make at least 10 demonstrations")
    return tuple(torch.tensor(np.concatenate(each), dtype=torch.float32) for each in (seen, done))


def train(policy: Policy, file: Path, steps: int, batch: int, seed: int) -> None:
    """Learn from the demonstrations to train on, and print how far off those to validate with are."""
    observations, actions = examples(file, "train")
    others = examples(file, "valid")
    policy.mean.copy_(observations.mean(0))
    policy.spread.copy_(observations.std(0).clamp(min=1e-3))
    optimizer = torch.optim.AdamW(policy.parameters(), 1e-3, weight_decay=1e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, 1e-3, total_steps=steps)
    rng = torch.Generator().manual_seed(seed)
    for step in range(1, steps + 1):
        chosen = torch.randint(len(observations), (batch,), generator=rng)
        loss = functional.l1_loss(policy(observations[chosen]), actions[chosen])
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        schedule.step()
        if step % max(1, steps // 5) == 0:
            with torch.inference_mode():
                off = functional.l1_loss(policy(others[0]), others[1])
            print(
                f"step {step}/{steps}: {loss.item():.3f} off in training, {off.item():.3f} in validation",
                flush=True,
            )


def succeeds(number: int, environment: str, file: Path | None) -> bool:
    """Tell whether a policy does a task with a held-out asset; without a file, it acts at random."""
    torch.set_num_threads(1)
    env = gymnasium.make(environment, assets=range(HELD_OUT, 2 * HELD_OUT), shuffle=False)
    observation, _ = env.reset(seed=number)  # an asset that the task cannot be done with is passed over
    policy = None
    if file is not None:
        policy = Policy(len(observation), env.action_space.shape[0])
        policy.load_state_dict(torch.load(file))
    rng = np.random.default_rng(number)
    while True:
        for action in told(policy, observation, rng):
            observation, _, terminated, truncated, info = env.step(action)
            if terminated or truncated:
                env.close()
                return bool(info["success"])


def told(policy: Policy | None, observation: Array, rng: np.random.Generator) -> Array:
    """Return the actions to do before the next look."""
    if policy is None:
        return rng.uniform(-1.0, 1.0, (AHEAD, 7)).astype(np.float32)
    with torch.inference_mode():
        actions = policy(torch.as_tensor(observation, dtype=torch.float32)[None])[0]
    return actions.clamp(-1.0, 1.0).numpy()


def main() -> None:
    """Learn, try and save."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("demos", type=Path, help="demo.hdf5, which `artgen demos` wrote")
    parser.add_argument("--steps", type=int, default=4000, help="batches to learn from")
    parser.add_argument("--batch", type=int, default=256)
    parser.add_argument("--episodes", type=int, default=50, help="held-out assets to try it on")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("policy.pt"))
    options = parser.parse_args()
    if not options.demos.is_file():
        raise SystemExit(
            f"error: there is no {options.demos}; make it with: artgen demos OpenDrawer --out demos"
        )
    torch.manual_seed(options.seed)
    with h5py.File(options.demos, "r") as file:
        environment = json.loads(file["data"].attrs["env_args"])["env_name"]
        first = file["data"]["demo_0"]
        policy = Policy(first["obs"]["state"].shape[1], first["actions"].shape[1])
        print(f"{environment}: {len(file['data'])} demonstrations, {file['data'].attrs['total']} steps")
    start = time.monotonic()
    train(policy, options.demos, options.steps, options.batch, options.seed)
    print(f"learnt in {time.monotonic() - start:.0f} s")
    torch.save(policy.state_dict(), options.out)
    numbers = range(options.episodes)
    with multiprocessing.get_context("spawn").Pool(options.jobs) as pool:
        for name, file in (("cloned", options.out), ("random", None)):
            start = time.monotonic()
            share = np.mean(
                pool.map(partial(succeeds, environment=environment, file=file), numbers, chunksize=1)
            )
            print(
                f"{name}: {share:.0%} of {len(numbers)} held-out assets, in {time.monotonic() - start:.0f} s"
            )


if __name__ == "__main__":
    main()
