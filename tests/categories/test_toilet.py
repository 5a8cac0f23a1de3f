"""What is special to a toilet: the order of lid and seat, how they fall, keys, sizes and masses."""

import math
from functools import lru_cache
from typing import Any

import mujoco
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.validate.behavior import check_behavior
from artgen.validate.colliders import check_colliders

STYLES = ("coupled", "one_piece", "hung")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("toilet").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize("style", STYLES)
def test_the_seat_rises_only_under_an_open_lid(style: str) -> None:
    asset = made(1, style=style)
    lid, seat = ((asset.joint(f"{name}_hinge").limits or (0, 0))[1] for name in ("lid", "seat"))
    assert asset.blocked({"lid_hinge": 0.5 * lid, "seat_hinge": 0.2})
    assert not asset.blocked({"lid_hinge": lid, "seat_hinge": seat})
    assert asset.clearance({"lid_hinge": lid, "seat_hinge": seat})["bowl", "lid"] > 0.0003


@pytest.mark.parametrize(("slow", "low", "high"), [(True, 1.5, 8.0), (False, 0.2, 1.0)])
def test_a_lid_past_upright_stays_and_a_lid_before_it_falls(*, slow: bool, low: float, high: float) -> None:
    asset = made(2, style="coupled", slow=slow)
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    hinge = model.joint("lid_hinge").qposadr[0]
    _, top = asset.joint("lid_hinge").limits or (0.0, 0.0)
    data.qpos[hinge] = top
    mujoco.mj_step(model, data, nstep=round(3.0 / model.opt.timestep))
    assert data.qpos[hinge] == pytest.approx(top, abs=0.02), "an open lid leans on its stop"
    mujoco.mj_resetData(model, data)
    data.qpos[hinge] = 0.9
    while data.qpos[hinge] > 0.05 and data.time < 20.0:
        mujoco.mj_step(model, data)
    assert low < data.time < high


@pytest.mark.parametrize(("style", "flush", "keys"), [
    ("coupled", "button", {"flush_slide"}),
    ("one_piece", "keys", {"flush_slide_half", "flush_slide_full"}),
    ("coupled", "lever", {"flush_turn"}),
])  # fmt: skip
def test_springs_return_the_flush(style: str, flush: str, keys: set[str]) -> None:
    asset = made(3, style=style, flush=flush, certify=False)
    found = {joint.name for joint in asset.joints if joint.stiffness > 0.0}
    assert found == keys
    for name in keys:
        joint = asset.joint(name)
        assert -joint.rest * joint.stiffness > joint.friction, "its preload overcomes its friction"


@pytest.mark.parametrize("style", STYLES)
def test_sizes_and_masses_are_those_of_shops(style: str) -> None:
    asset = made(4, style=style, certify=False)
    low, high = asset.bounds()
    assert 0.5 <= high[1] - low[1] <= 0.75
    assert 0.7 <= asset.link("seat").mass_properties.mass <= 3.0
    bowl = asset.link("bowl").mass_properties.mass
    assert 28.0 <= bowl <= (90.0 if style == "hung" else 50.0)
    assert math.isclose(low[2], 0.0, abs_tol=1e-6)


def test_a_wooden_seat_closes_as_softly_as_a_heavy_one_and_in_time() -> None:
    asset = made(96, seat="oak", slow=True)
    assert asset.link("seat").mass_properties.mass < 1.0, "it is light"
    assert check_behavior(asset).faults == ()


def test_colliders_follow_the_foot_of_a_coupled_bowl() -> None:
    assert check_colliders(made(140, style="coupled")).faults == ()
