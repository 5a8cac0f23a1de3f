"""A small task for the tests of environments: pull a drawer, with the robot in front of it."""

from dataclasses import dataclass

import numpy as np

from artgen.asset import Asset
from artgen.envs.motion import Stage, Target, lifted, tip_of, turned
from artgen.envs.robot import HOME, reach
from artgen.envs.task import Task
from artgen.errors import EnvError

SHARE = 0.5  # of the way of the drawer


def _nothing(asset, rng):
    yield from ()


@dataclass(frozen=True, eq=False)
class Pull(Task):
    """Pull the first drawer open by half its way; the hand begins 8 cm in front of the handle."""

    name: str = "Pull"
    category: str = "drawer"
    seconds: float = 4.0
    doc: str = "Pull the first drawer open."
    choose: object = _nothing

    def generate(self, seed: int) -> Asset:
        from artgen import generate

        return generate("drawer", seed, certify=False, rows=1, columns=1, handle="knob_pull", kind="bedside")

    def target(self, asset: Asset, rng: np.random.Generator) -> Target:
        grasps = [each for each in asset.affordances if each.kind == "grasp" and each.joints]
        if not grasps:
            raise EnvError(f"asset {asset.name!r} has no drawer with a handle")
        grasp = grasps[0]
        low, high = asset.joint(grasp.joints[0]).limits
        stage = Stage(grasp.joints[0], low, low + SHARE * (high - low), grasp)
        hand = lifted(tip_of(grasp), -0.08)
        base = np.eye(4)
        base[:3, :3] = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        base[:3, 3] = hand[:3, 3] + [0.03 * rng.uniform(-1.0, 1.0), -0.5, -0.5]
        tips = np.stack([np.linalg.solve(base, turned(hand, 2, angle)) for angle in (0.0, np.pi)])
        arms, misses = reach(np.tile(HOME, (2, 1)), tips, 100)
        assert misses.min() < 1e-3, misses
        return Target((stage,), {}, base, arms[misses.argmin()], hand)


PULL = Pull()


def pull(env):
    """Yield the actions that grasp the handle and pull, from the current pose of the hand."""
    for number in range(200):
        ahead = env.unwrapped.target.stages[0].affordance.frame
        way = env.unwrapped._handle[:3, 3] - env.tip()[:3, 3]
        action = np.zeros(7, np.float32)
        if number < 25:
            action[:3], action[6] = np.clip(way / 0.05, -1.0, 1.0), -1.0
        elif number < 32:
            action[6] = 1.0
        else:
            action[:3], action[6] = -ahead[:3, 2], 1.0
        yield action
