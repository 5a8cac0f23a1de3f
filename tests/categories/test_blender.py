"""What is special to a blender: a jug behind its bayonet, a lid in its seal, clicks, masses."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find

MASSES = {"jug": (2.6, 6.0), "retro": (4.0, 6.2), "personal": (1.0, 1.9)}


@lru_cache(maxsize=4)
def made(seed: int, **given: Any) -> Asset:
    return find("blender").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize("style", MASSES)
def test_a_jug_lifts_off_only_after_its_turn(style: str) -> None:
    asset = made(1, style=style)
    low, high = MASSES[style]
    assert low < asset.mass < high
    turn = asset.joint("jug_turn").limits
    assert turn is not None
    assert asset.blocked({"jug_lift": 0.05})
    assert asset.blocked({"jug_turn": turn[1] / 2, "jug_lift": 0.05})
    assert not asset.blocked({"jug_turn": turn[1], "jug_lift": 0.05})
    assert asset.clearance({"jug_turn": turn[1], "jug_lift": 0.1})["base", "jug"] > 0.05


def test_a_lid_takes_its_cap_along_and_its_seal_holds_its_weight() -> None:
    asset = made(1, style="retro")
    weight = 9.81 * sum(asset.link(name).mass_properties.mass for name in ("lid", "cap"))
    assert asset.parameters["seal"] == asset.joint("lid_lift").friction
    assert asset.joint("lid_lift").friction < 9.81 * asset.link("jug").mass_properties.mass + weight
    rest, up = (asset.pose({"lid_lift": q})["cap"] for q in (0.0, 0.08))
    assert up[2, 3] - rest[2, 3] == pytest.approx(0.08)


def test_a_dial_clicks_at_each_of_its_speeds() -> None:
    asset = made(1, style="retro")
    dial = asset.joint("dial_turn")
    assert dial.detents is not None
    assert len(dial.detents.positions) == asset.parameters["speeds"]
    assert dial.limits is not None
    assert (dial.detents.positions[0], dial.detents.positions[-1]) == pytest.approx(dial.limits)


@pytest.mark.parametrize("style", MASSES)
def test_one_collider_of_the_base_carries_the_jug(style: str) -> None:
    asset = made(1, style=style)
    rim = [0.03 * np.array([math.cos(turn), math.sin(turn)]) for turn in np.linspace(0.0, math.tau, 12)]
    points = np.array([(*each, asset.parameters["high"] - 0.001) for each in rim])
    under = [
        each.convex.outer_polytope(1e-5).planes for each in asset.links[0].colliders if each.label == "base"
    ]
    inside = np.array([(points @ each[:, :3].T < each[:, 3]).all(axis=1) for each in under])
    assert inside.all(axis=1).sum() == 1
    assert inside.any(axis=1).sum() == 1
