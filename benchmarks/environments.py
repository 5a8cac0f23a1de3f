"""Measure actions per second of the manipulation tasks, and the setup times of their assets.

    python benchmarks/environments.py --assets 3 --actions 200

One process acts at random. Times are processor times, so that other work on the machine matters little; but
a busy machine is slower because its caches are shared.
"""

import argparse
import time

import numpy as np

from artgen.envs import TASKS, ManipulationEnv


def measured(task: str, assets: int, actions: int) -> tuple[float, float, float]:
    """Return the times of the first reset with an asset, of another reset, and of an action [s]."""
    env = ManipulationEnv(task, range(assets), shuffle=False)
    begin = time.process_time()
    for _ in range(assets):
        env.reset()
    ready = time.process_time()
    for _ in range(10 * assets):
        env.reset()
    again = time.process_time()
    rng = np.random.default_rng(0)
    spent = 0.0
    for _ in range(assets):
        env.reset()
        for action in rng.uniform(-1.0, 1.0, (actions, 7)):
            before = time.process_time()
            _, _, terminated, truncated, _ = env.step(action)
            spent += time.process_time() - before
            if terminated or truncated:
                env.reset()
    env.close()
    return (ready - begin) / assets, (again - ready) / (10 * assets), spent / (assets * actions)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("tasks", nargs="*", default=list(TASKS), metavar="TASK")
    parser.add_argument("--assets", type=int, default=3)
    parser.add_argument("--actions", type=int, default=200, help="for each asset")
    options = parser.parse_args()
    print("| task | actions per second and core | an asset is ready after | another reset |")  # noqa: T201
    print("| --- | --- | --- | --- |")  # noqa: T201
    for task in options.tasks:
        ready, again, action = measured(task, options.assets, options.actions)
        print(f"| `{task}` | {1.0 / action:.0f} | {ready:.1f} s | {1e3 * again:.0f} ms |", flush=True)  # noqa: T201


if __name__ == "__main__":
    main()
