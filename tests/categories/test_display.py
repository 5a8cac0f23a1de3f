"""What is special to a display: a spring carries it, friction holds it, keys are pressed from below."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=32)
def made(seed: int, **given: Any) -> Asset:
    return find("display").generate(seed, certify=False, **given)


@pytest.mark.parametrize("inches", [22, 27])
def test_a_monitor_stays_at_its_height_and_angle(inches: int) -> None:
    asset = made(1, style="rising", inches=inches)
    (low, high) = asset.joint("height_slide").limits or (0.0, 0.0)
    for height in (low, (low + high) / 2, high):
        assert released(asset, "height_slide", height) == pytest.approx(height, abs=0.002)
    for angle in (-0.05, 0.15, 0.3):
        assert released(asset, "screen_tilt", angle) == pytest.approx(angle, abs=0.01)


def test_a_hand_lifts_a_monitor_with_a_fraction_of_its_weight() -> None:
    asset = made(2, style="rising", inches=27)
    weight = 9.81 * sum(asset.link(name).mass for name in ("carriage", "screen"))
    assert released(asset, "height_slide", 0.0, pull=0.15 * weight) == pytest.approx(0.0, abs=0.002)
    assert released(asset, "height_slide", 0.0, pull=0.40 * weight) > 0.02


@pytest.mark.parametrize("inches", [22, 24, 27, 32, 40, 43])
def test_the_picture_has_its_diagonal(inches: int) -> None:
    style = "television" if inches > 27 else "rising"
    asset = made(3, style=style, inches=inches, picture="sea", margin=0.006)
    panel = next(p.shape.bounds() for p in asset.link("screen").pieces if p.label == "screen")
    wide, tall = (panel[1] - panel[0])[[0, 2]] - 0.012
    assert (wide**2 + tall**2) ** 0.5 == pytest.approx(0.0254 * inches, rel=0.005)
    assert wide / tall == pytest.approx(16 / 9, rel=0.01)


def test_keys_are_pressed_upwards() -> None:
    asset = made(4, style="tilting", keys=3)
    for number in range(3):
        joint = asset.joint(f"button_slide_{number}")
        assert tuple(joint.axis) == pytest.approx((0, 0, 1), abs=1e-9)
        assert released(asset, joint.name, 0.0015) == pytest.approx(0.0, abs=2e-4)
