"""What is special to clips: springs that close jaws with a force, arms that turn over, teeth, pads."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released

STYLES = ("wood", "plastic", "bag", "binder", "bulldog", "claw", "clamp")


@lru_cache(maxsize=24)
def made(seed: int, **given: Any) -> Asset:
    return find("clothespin").generate(seed, certify=False, **given)


def opened(asset: Asset) -> float:
    limits = asset.joint("jaw_hinge").limits
    assert limits is not None
    return limits[1]


def torque(asset: Asset, angle: float) -> float:
    """Return the torque of the spring that closes the jaws [N m]."""
    hinge = asset.joint("jaw_hinge")
    return hinge.stiffness * (angle - hinge.rest)


@pytest.mark.parametrize("style", STYLES)
def test_a_spring_closes_the_jaws_and_a_finger_opens_them(style: str) -> None:
    asset = made(1, style=style)
    end = opened(asset)
    assert released(asset, "jaw_hinge", end) == pytest.approx(0.0, abs=0.01)
    assert released(asset, "jaw_hinge", 0.0, pull=0.9 * torque(asset, 0.0)) == pytest.approx(0.0, abs=0.005)
    assert released(asset, "jaw_hinge", 0.0, pull=1.06 * torque(asset, end)) == pytest.approx(end, abs=0.02)


@pytest.mark.parametrize(
    ("style", "force", "least"),
    [("wood", 8.0, 0.006), ("plastic", 6.0, 0.011), ("bulldog", 20.0, 0.012), ("clamp", 30.0, 0.024)],
)
def test_jaws_hold_with_their_force_and_open_wide(style: str, force: float, least: float) -> None:
    asset = made(2, style=style, force=force)
    low, high = asset.link("pad_1" if style == "clamp" else "lever").bounds()
    tip = np.array([(low[0] + high[0]) / 2 if style == "clamp" else low[0], 0.0, low[2], 1.0])
    moved = asset.pose({"jaw_hinge": 0.01})["lever"] @ tip - tip
    reach = moved[2] / np.sin(0.01)
    assert torque(asset, 0.0) / reach == pytest.approx(force, rel=0.06)
    assert reach * np.sin(opened(asset)) > least


@pytest.mark.parametrize("size", [0.019, 0.032, 0.051])
def test_arms_of_a_binder_clip_lie_back_and_turn_over_to_the_front(size: float) -> None:
    asset = made(3, style="binder", size=size)
    body = asset.link("body").bounds()
    assert body[1, 1] - body[0, 1] == pytest.approx(size, abs=1e-4)
    for index in (0, 1):
        arm = asset.link(f"arm_{index}").bounds()
        assert arm[1, 0] > body[1, 0], "behind the back"
        pose = asset.pose({f"arm_turn_{index}": 2.5})[f"arm_{index}"]
        tip = pose @ np.array([arm[1, 0], 0.0, arm[1, 2] if index else arm[:, 2].mean(), 1.0])
        assert tip[0] < body[0, 0] - 0.3 * size, "before the mouth"
    assert 0.0 < asset.clearance({})["body", "lever"] < 0.0006


def test_teeth_of_a_hair_claw_cross_between_each_other() -> None:
    for teeth in (4, 6):
        asset = made(4, style="claw", teeth=teeth)
        body, lever = (asset.link(name).bounds() for name in ("body", "lever"))
        assert body[1, 0] > lever[0, 0] + 0.004
        assert asset.clearance({})["body", "lever"] > 0.0002
        assert body[0, 2] == pytest.approx(0.0, abs=1e-6), "it stands on its teeth"


def test_pads_of_a_clamp_turn_without_meeting() -> None:
    asset = made(5, style="clamp")
    assert asset.clearance({})["pad_0", "pad_1"] == pytest.approx(
        0.0024 * asset.parameters["size"] / 0.15, rel=0.02
    )
    for turn in (-0.18, 0.18):
        assert asset.clearance({"pad_turn_0": turn, "pad_turn_1": -turn})["pad_0", "pad_1"] > 0.0


@pytest.mark.parametrize(
    ("style", "size", "least", "most"),
    [("wood", 0.072, 0.005, 0.009), ("plastic", 0.08, 0.006, 0.011), ("bag", 0.08, 0.018, 0.035),
     ("binder", 0.019, 0.002, 0.0045), ("binder", 0.051, 0.026, 0.046), ("bulldog", 0.05, 0.025, 0.045),
     ("claw", 0.085, 0.02, 0.04), ("clamp", 0.15, 0.045, 0.08)],
)  # fmt: skip
def test_masses_are_those_of_products(style: str, size: float, least: float, most: float) -> None:
    assert least < made(6, style=style, size=size).mass < most


def test_a_clip_of_an_impossible_size_is_refused() -> None:
    with pytest.raises(InfeasibleError, match="width of a binder clip must be <="):
        find("clothespin").generate(0, style="binder", size=0.08)
