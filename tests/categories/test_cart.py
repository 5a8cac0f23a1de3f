"""What is special to a cart: it stands on its wheels and rolls, its handle and its toe fold."""

import itertools
import math
from functools import lru_cache
from typing import Any

import mujoco
import pytest

from artgen.asset import Asset
from artgen.catalog import find

STYLES = ("service", "drinks", "tool", "platform", "truck")


@lru_cache(maxsize=32)
def made(seed: int, **given: Any) -> Asset:
    return find("cart").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", STYLES)
def test_all_wheels_stand_on_the_floor(style: str) -> None:
    asset = made(1, style=style)
    wheels = [link for link in asset.links if link.label == "wheel"]
    assert len(wheels) == (2 if style == "truck" else 4)
    for wheel in wheels:
        low = min(piece.shape.bounds()[0][2] for piece in wheel.pieces if not piece.visual)
        assert low == pytest.approx(0.0, abs=2e-4), wheel.name


@pytest.mark.parametrize(("style", "force"), [("service", 4.0), ("tool", 8.0)])
def test_a_cart_rolls_to_where_it_is_pushed(style: str, force: float) -> None:
    asset = made(2, style=style).with_base("free")
    spec = asset.to_mjspec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 0.1])
    model = spec.compile()
    data = mujoco.MjData(model)
    body = model.body("body").id
    for _ in range(round(2.0 / model.opt.timestep)):
        data.xfrc_applied[body, 0] = -force * asset.mass / 10
        mujoco.mj_step(model, data)
    assert data.xpos[body, 0] < -0.1
    assert abs(data.xquat[body, 0]) > 0.99, "upright, and not turned over"


def test_the_handle_of_a_platform_folds_down_onto_it() -> None:
    asset = made(3, style="platform")
    assert asset.joint("handle_fold").limits == pytest.approx((0.0, math.pi / 2))
    upright, folded = (asset.pose({"handle_fold": at})["handle"] for at in (0.0, math.pi / 2))
    center = [*asset.link("handle").mass_properties.center, 1.0]
    bed = max(piece.shape.bounds()[1][2] for piece in asset.link("body").pieces if piece.label == "body")
    assert bed < (folded @ center)[2] < bed + 0.05 < (upright @ center)[2]
    assert 0.0 < asset.clearance({"handle_fold": math.pi / 2})[("body", "handle")] < 0.01


def test_drawers_lie_one_below_the_other_and_the_last_is_the_highest() -> None:
    asset = made(4, style="tool", rows=4)
    tall = []
    for number in range(4):
        fronts = [p.shape.bounds() for p in asset.link(f"drawer_{number}").pieces if p.label == "front"]
        tall.append((fronts[0][0][2], fronts[0][1][2]))
    assert all(upper[0] > lower[1] for upper, lower in itertools.pairwise(tall))
    assert tall[-1][1] - tall[-1][0] > 1.5 * (tall[0][1] - tall[0][0])
