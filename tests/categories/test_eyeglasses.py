"""What is special to eyeglasses: temples that fold one over the other, stay, snap, and stand on tips."""

import math
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find

RIGHT, LEFT = "temple_hinge_right", "temple_hinge_left"


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("eyeglasses").generate(seed, certify=False, **given)


def opened(asset: Asset) -> dict[str, float]:
    """Return the position in which glasses are worn."""
    beyond = 0.15 if asset.parameters["hinge"] == "spring" else 0.0
    return {joint.name: (joint.limits or (0.0, 0.0))[1] - beyond for joint in asset.free_joints}


def released(asset: Asset, start: dict[str, float], seconds: float = 1.5) -> dict[str, float]:
    """Return where the temples are some time after they were let go."""
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    for name, position in start.items():
        data.joint(name).qpos = position
    mujoco.mj_step(model, data, nstep=round(seconds / model.opt.timestep))
    return {name: float(data.joint(name).qpos[0]) for name in start}


@pytest.mark.parametrize("style", ["acetate", "metal", "half_rim", "rimless"])
def test_the_right_temple_lies_on_the_left_one(style: str) -> None:
    asset = made(3, use="optical", style=style)
    apart = asset.clearance({})
    assert 0.0 < apart["temple_right", "temple_left"] < 0.0025
    assert LEFT in asset.blocked({LEFT: 0.3})
    assert not asset.blocked({RIGHT: opened(asset)[RIGHT], LEFT: 0.3})


@pytest.mark.parametrize("style", ["acetate", "rimless"])
def test_open_temples_are_parallel_to_each_other_and_across_the_front(style: str) -> None:
    asset = made(5, use="optical", style=style)
    poses = asset.pose(opened(asset))
    turns = [math.atan2(poses[name][1, 0], poses[name][0, 0]) for name in ("temple_left", "temple_right")]
    assert turns[0] == pytest.approx(math.pi / 2, abs=1e-6)
    assert turns[1] == pytest.approx(-opened(asset)[RIGHT], abs=1e-6)
    low, high = asset.link("temple_left").bounds()  # folded along the front
    assert 0.13 < high[0] - low[0] < 0.155


def test_tips_and_rims_stand_on_the_table() -> None:
    for seed in range(4):
        asset = made(seed)
        lowest = [
            min(piece.shape.bounds()[0][2] for piece in asset.link(name).pieces if not piece.visual)
            for name in ("frame", "temple_right", "temple_left")
        ]
        frames = [asset.pose({})[name][2, 3] for name in ("frame", "temple_right", "temple_left")]
        np.testing.assert_allclose(np.add(lowest, frames), 0.0, atol=4e-4)


def test_friction_holds_temples_at_any_angle() -> None:
    asset = made(1, hinge="plain")
    start = {RIGHT: 0.8, LEFT: 0.0}
    assert released(asset, start) == pytest.approx(start, abs=0.02)


def test_spring_hinges_snap_open_and_come_back_from_beyond() -> None:
    asset = made(2, hinge="spring", friction=0.006)
    worn = opened(asset)
    assert released(asset, {RIGHT: worn[RIGHT] + 0.15})[RIGHT] < worn[RIGHT] + 0.13
    assert released(asset, {RIGHT: 0.72 * worn[RIGHT]})[RIGHT] > 0.85 * worn[RIGHT]


@pytest.mark.parametrize(("lens", "bridge", "temple"), [(46, 18, 140), (58, 16, 145)])
def test_glasses_have_the_sizes_that_are_printed_in_them(lens: int, bridge: int, temple: int) -> None:
    asset = made(4, use="sun", style="metal", lens_width=lens, bridge=bridge, temple_length=temple)
    low, high = np.array(
        [each.shape.bounds() for each in asset.link("frame").pieces if each.label == "lens"]
    ).reshape(2, 3)
    assert high[0] - low[0] == pytest.approx((2 * lens + bridge) / 1000, abs=0.0015)
    assert 0.012 < asset.mass < 0.040


def test_colliders_of_a_thin_lens_are_found() -> None:
    asset = made(13)
    assert 1 <= len(asset.link("frame").colliders) <= 64, (
        "the hull of this lens has a needle that points inwards"
    )
