"""What is special to a laptop: a hinge that holds, a screen that turns over, keys under a lid."""

import math
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.view.opening import opened

STYLES = ("thin", "plain", "convertible")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("laptop").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize("style", STYLES)
def test_friction_holds_the_screen_where_it_is_left(style: str) -> None:
    asset = made(1, style=style)
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    hinge = model.joint("screen_hinge").qposadr[0]
    for angle in (0.5, 1.2, 1.8):
        mujoco.mj_resetData(model, data)
        for name, value in asset.positions({"screen_hinge": angle}).items():
            data.qpos[model.joint(name).qposadr[0]] = value
        mujoco.mj_step(model, data, nstep=round(2.0 / model.opt.timestep))
        assert data.qpos[hinge] == pytest.approx(angle, abs=0.03)


def test_an_open_convertible_shows_its_screen() -> None:
    asset = made(2, style="convertible")
    turn = asset.pose(opened(asset))["screen"] @ np.linalg.inv(asset.pose({})["screen"])
    assert math.acos((np.trace(turn[:3, :3]) - 1.0) / 2.0) == pytest.approx(0.6 * math.pi, abs=1e-6)


def test_the_screen_of_a_convertible_turns_over_onto_the_underside() -> None:
    asset = made(2, style="convertible")
    pose = asset.pose({"screen_hinge": math.pi})["screen"]
    low, high = asset.link("screen").bounds()
    outer = pose @ np.array([0.0, low[1], high[2], 1.0])
    assert outer[2] < 0.0, "the lid lies below the base"
    assert pose[:3, :3] @ [0, 0, 1] == pytest.approx([0, 0, 1], abs=1e-9)


def test_keys_are_reached_under_an_open_lid() -> None:
    asset = made(1, style="thin", keys="all")
    moved = [joint.name for joint in asset.joints if joint.name.startswith("key_press")]
    assert len(moved) == 63
    assert not asset.blocked(dict.fromkeys(moved, 0.001))
    assert "key_press_1_0" not in {joint.name for joint in made(1, style="thin").joints}


@pytest.mark.parametrize("style", STYLES)
def test_sizes_and_masses_are_those_of_shops(style: str) -> None:
    asset = made(3, style=style)
    low, high = asset.bounds()
    assert 0.30 < high[0] - low[0] < 0.39
    assert 0.20 < high[1] - low[1] < 0.30
    assert 0.9 < asset.mass < 2.6
    assert 0.25 < asset.link("screen").mass_properties.mass < 0.7


def test_a_thin_laptop_with_a_disc_tray_is_refused() -> None:
    assert find("laptop").generate(1, style="plain", thick=0.016).certificate.proven
    with pytest.raises(InfeasibleError, match=r"a disc tray needs room: thick must be >= 0\.016 m"):
        find("laptop").generate(1, style="plain", thick=0.015)
