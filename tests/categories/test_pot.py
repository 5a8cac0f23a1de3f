"""What is special to a pot: lids that lift off, a bayonet behind its lock, masses of real pots."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find

MASSES = {"saucepan": (0.7, 2.0), "casserole": (3.9, 7.5), "pan": (1.1, 2.8)}


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("pot").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize("style", MASSES)
def test_a_lid_lies_on_the_rim_and_lifts_off(style: str) -> None:
    asset = made(1, style=style)
    low, high = MASSES[style]
    assert low < asset.mass < high
    assert asset.clearance({"lid_lift": 0.0})["pot", "lid"] == pytest.approx(0.0006, abs=5e-4)
    assert asset.clearance({"lid_lift": 0.1, "lid_turn": 1.0})["pot", "lid"] > 0.05


def test_a_pressure_cooker_opens_in_its_order() -> None:
    asset = made(2, style="pressure")
    turn = asset.joint("lid_turn").limits
    assert turn is not None
    assert asset.blocked({"lid_lift": 0.05})
    assert asset.blocked({"lid_turn": turn[1]})
    assert asset.blocked({"lock_slide": 0.01, "lid_turn": 0.2, "lid_lift": 0.05})
    assert not asset.blocked({"lock_slide": 0.01, "lid_turn": turn[1], "lid_lift": 0.05})
    assert not asset.blocked({"valve_lift": 0.04})


def test_friction_holds_the_open_lid_of_a_chafing_dish() -> None:
    asset = made(2, style="chafer")
    lid = asset.link("lid").mass_properties.mass
    radius = asset.parameters["width"] / 2
    assert asset.joint("lid_hinge").friction > 9.81 * lid * radius


def test_side_handles_hang_and_swing_up() -> None:
    asset = made(2, style="stockpot", swings=True)
    rest, up = (asset.pose({"handle_swing_right": q})["handle_right"] for q in (0.0, 1.5))
    (grasp,) = asset.link("handle_right").grasps
    (x, _, z), (far, _, high) = ((pose @ np.append(grasp.frame[:3, 3], 1.0))[:3] for pose in (rest, up))
    assert far - x > 0.04
    assert high - z > 0.04
