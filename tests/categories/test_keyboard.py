"""What is special to a keyboard: keys in their pitch spring back, a knob clicks, feet snap, sizes."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released

STYLES = {"macro": 12, "numeric": 17, "small": 61, "compact": 87, "full": 104}
PITCH = 0.01905


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("keyboard").generate(seed, certify=False, **given)


@pytest.mark.parametrize(("style", "count"), STYLES.items())
def test_it_has_the_keys_of_its_kind(style: str, count: int) -> None:
    assert sum(joint.name.startswith("key_press") for joint in made(1, style=style).joints) == count


@pytest.mark.parametrize("caps", ["tall", "flat"])
def test_keys_spring_back_after_their_travel(caps: str) -> None:
    asset = made(2, style="numeric", caps=caps)
    travel = {"tall": 0.004, "flat": 0.002}[caps]
    for name in ("key_press_0", "key_press_16"):
        assert asset.joint(name).limits == pytest.approx((0.0, travel))
        assert released(asset, name, travel) == pytest.approx(0.0, abs=1e-4)


def test_keys_stand_in_their_pitch() -> None:
    asset = made(3, style="full")
    keys = [link.bounds() for link in asset.links if link.name.startswith("key_")]
    middles = np.array([box.mean(axis=0) for box in keys])
    number = middles[17:26, 0]  # 1 to 9 in the row of digits
    assert np.diff(number) == pytest.approx([PITCH] * 8, abs=1e-6)
    wide = [(box[1] - box[0])[0] for box in keys]
    assert max(wide) == pytest.approx(6.25 * PITCH - 0.001, abs=1e-6), "the space bar"
    case = asset.link("case").bounds()
    assert (np.array(keys)[:, 0, :2] > case[0, :2]).all()
    assert (np.array(keys)[:, 1, :2] < case[1, :2]).all()


def test_the_knob_clicks_and_is_endless() -> None:
    asset = made(4, style="macro")
    step = math.tau / 24
    assert asset.joint("knob_turn").limits is None
    for share in (3.3, 3.7):
        assert released(asset, "knob_turn", share * step) == pytest.approx(
            round(share) * step, abs=0.2 * step
        )


def test_feet_snap_into_the_underside_and_out_of_it() -> None:
    asset = made(5, style="compact", caps="tall")
    foot = asset.link("foot_0").bounds()
    assert foot[0][2] > 0.0, "folded, they are above the table"
    for share, expected in ((0.3, 0.0), (0.7, 1.75)):
        assert released(asset, "foot_hinge_0", share * 1.75) == pytest.approx(expected, abs=0.06)
    pose = asset.pose({"foot_hinge_0": 1.75})["foot_0"]
    assert (pose @ np.array([*foot[0], 1.0]))[2] < -0.008


@pytest.mark.parametrize(
    ("style", "wide", "mass"),
    [
        ("macro", (0.083, 0.097), (0.12, 0.21)),
        ("numeric", (0.083, 0.097), (0.06, 0.20)),
        ("small", (0.292, 0.308), (0.22, 0.56)),
        ("compact", (0.355, 0.371), (0.32, 0.96)),
        ("full", (0.434, 0.452), (0.39, 1.1)),
    ],
)
def test_sizes_and_masses_are_those_of_data_sheets(
    style: str, wide: tuple[float, float], mass: tuple[float, float]
) -> None:
    for caps in ("tall",) if style == "macro" else ("tall", "flat"):
        asset = made(6, style=style, caps=caps)
        low, high = asset.bounds()
        assert wide[0] < high[0] - low[0] < wide[1]
        assert mass[0] < asset.mass < mass[1]
