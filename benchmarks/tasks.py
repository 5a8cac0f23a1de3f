"""Measure the success rates of the scripted and of a random policy in the tasks, on unseen assets.

    python benchmarks/tasks.py --assets 100 --jobs 2
    python benchmarks/tasks.py OpenDrawer PushDoor --assets 20

Each asset has its own seed; an asset without a place for the robot counts as a failure.
"""

import argparse
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context

import numpy as np

from artgen.envs import TASKS, ManipulationEnv
from artgen.envs.policy import ScriptedPolicy
from artgen.errors import ArtgenError

FIRST = 100_000  # seed of the first asset; nothing is trained or tuned on those from here on


@dataclass(frozen=True)
class Outcome:
    """Result for one asset.

    Attributes:
        seed: Seed of the asset.
        scripted: Whether the scripted policy succeeded.
        drawn: Whether the random policy succeeded.
        seconds: Simulated time of the scripted policy [s].
        setting_up: Time to make the asset, its model and the place of the robot [s].
        failure: Reason for the failure of the scripted policy.
    """

    seed: int
    scripted: bool
    drawn: bool
    seconds: float
    setting_up: float
    failure: str = ""


def tried(name: str, seed: int, *, random: bool = True) -> Outcome:
    """Try both policies on one asset.

    Args:
        name: Name of the task.
        seed: Seed of the asset.
        random: Whether the random policy is tried as well.
    """
    env = ManipulationEnv(name, cache_size=1)
    begin = time.perf_counter()
    try:
        env.reset(seed=seed, options={"asset": seed})
    except ArtgenError as error:
        return Outcome(seed, False, False, 0.0, time.perf_counter() - begin, str(error))
    setting_up = time.perf_counter() - begin
    policy = ScriptedPolicy(env)
    scripted, seconds = played(env, policy.action)
    failure = "" if scripted else f"{dict(zip(_joints(env), env.reached(), strict=True))}"
    drawn = False
    if random:
        env.reset(seed=seed, options={"asset": seed})
        rng = np.random.default_rng(seed)
        drawn, _ = played(env, lambda _: rng.uniform(-1.0, 1.0, 7))
    env.close()
    return Outcome(seed, scripted, drawn, seconds, setting_up, failure)


def _joints(env: ManipulationEnv) -> list[str]:
    return [stage.joint for stage in env.target.stages]


def played(env: ManipulationEnv, act: Callable[[object], object]) -> tuple[bool, float]:
    """Run an episode; return its success and its duration [s]."""
    observation: object = None
    while True:
        observation, _, terminated, truncated, info = env.step(act(observation))
        if terminated or truncated:
            return info["success"], env.data.time


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("tasks", nargs="*", default=list(TASKS), metavar="TASK")
    parser.add_argument("--assets", type=int, default=100)
    parser.add_argument("--first", type=int, default=FIRST, help="seed of the first asset")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--no-random", action="store_true", help="leave the random policy out")
    options = parser.parse_args()
    seeds = range(options.first, options.first + options.assets)
    print("| task | scripted | random | the scripted policy takes | setting an asset up takes |")  # noqa: T201
    print("| --- | --- | --- | --- | --- |")  # noqa: T201
    failures = []
    with ProcessPoolExecutor(options.jobs, mp_context=get_context("spawn")) as pool:
        for name in options.tasks:
            trial = partial(tried, name, random=not options.no_random)
            found = list(pool.map(trial, seeds))
            print(row(name, found, random=not options.no_random), flush=True)  # noqa: T201
            failures += [f"- {name} {each.seed}: {each.failure}" for each in found if not each.scripted]
    print("\n".join(["", *failures]))  # noqa: T201


def row(name: str, found: list[Outcome], *, random: bool) -> str:
    """Return a line of the table."""
    count = len(found)
    scripted = sum(each.scripted for each in found)
    drawn = f"{sum(each.drawn for each in found)} of {count}" if random else ""
    took = [each.seconds for each in found if each.scripted]
    typical = f"{np.median(took):.1f} s" if took else ""
    setting_up = np.median([each.setting_up for each in found])
    return f"| {name} | {scripted} of {count} | {drawn} | {typical} | {setting_up:.1f} s |"


if __name__ == "__main__":
    main()
