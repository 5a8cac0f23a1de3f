"""What is special to a globe: its axis leans as that of the earth, it spins on, a meridian stays."""

import math
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find

STYLES = ("half", "full", "floor", "lit")


@lru_cache(maxsize=8)
def made(seed: int, **given: Any) -> Asset:
    return find("globe").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", STYLES)
def test_the_axis_leans_by_that_of_the_earth(style: str) -> None:
    spin = made(1, style=style).joint("ball_spin")
    assert spin.limits is None
    assert math.degrees(math.acos(spin.axis[2])) == pytest.approx(23.4, abs=0.01)
    np.testing.assert_allclose(spin.axis[1], 0.0, atol=1e-9)


@pytest.mark.parametrize("style", ["half", "floor"])
def test_a_ball_spins_on_and_comes_to_rest(style: str) -> None:
    model = made(2, style=style).to_mjspec().compile()
    data = mujoco.MjData(model)
    data.joint("ball_spin").qvel = 6.0
    speeds = []
    for _ in range(2):
        mujoco.mj_step(model, data, nstep=round(1.0 / model.opt.timestep))
        speeds.append(float(data.joint("ball_spin").qvel[0]))
    assert 6.0 > speeds[0] > speeds[1] > 1.0


def test_a_full_meridian_turns_from_an_upright_axis_to_one_that_lies() -> None:
    asset = made(3, style="full")
    low, high = asset.joint("meridian_turn").limits or (0.0, 0.0)
    axis = asset.joint("ball_spin").axis
    ends = [asset.pose({"meridian_turn": at})["meridian"][:3, :3] @ axis for at in (low, high)]
    assert ends[0] == pytest.approx((0.0, 0.0, 1.0), abs=1e-6)
    assert ends[1] == pytest.approx((1.0, 0.0, 0.0), abs=1e-6)


@pytest.mark.parametrize("diameter", [0.16, 0.28])
def test_a_ball_is_as_light_as_a_shell(diameter: float) -> None:
    ball = made(4, style="half", diameter=diameter).link("ball")
    shell = math.pi * diameter**2 * 0.0022 * 1050.0
    assert 0.5 * shell < ball.mass_properties.mass < 1.5 * shell
