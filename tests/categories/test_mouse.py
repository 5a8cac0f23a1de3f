"""What is special to a mouse: buttons spring back, its wheel clicks, an upright one stands, sizes."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released

STYLES = ("plain", "travel", "game", "right", "upright")


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("mouse").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", STYLES)
def test_buttons_and_wheel_spring_back(style: str) -> None:
    asset = made(1, style=style)
    for name in ("button_left_press", "button_right_press", "axle_press"):
        end = (asset.joint(name).limits or (0.0, 0.0))[1]
        assert released(asset, name, end) == pytest.approx(0.0, abs=0.12 * end)


@pytest.mark.parametrize("style", STYLES)
def test_the_front_of_a_button_moves_by_its_travel(style: str) -> None:
    asset = made(2, style=style)
    joint = asset.joint("button_left_press")
    end = (joint.limits or (0.0, 0.0))[1]
    lever = asset.parameters["length"] * (0.5 - 0.03)
    assert end * lever == pytest.approx(0.0006, rel=1e-6)
    spring = joint.stiffness * (end - joint.rest)
    assert spring / lever == pytest.approx(asset.parameters["force"], rel=1e-3)


@pytest.mark.parametrize("steps", [18, 24])
def test_a_wheel_clicks_to_the_nearest_step(steps: int) -> None:
    step = math.tau / steps
    for share in (2.3, 2.7):
        assert released(made(3, style="plain", steps=steps), "wheel_turn", share * step) == pytest.approx(
            round(share) * step, abs=0.2 * step
        )


def test_a_wheel_stands_out_between_the_buttons() -> None:
    asset = made(4, style="game")
    left, right, wheel = (asset.link(name).bounds() for name in ("button_left", "button_right", "wheel"))
    assert left[1][0] < wheel[0][0] < wheel[1][0] < right[0][0]
    middle = wheel.mean(axis=0)
    assert left[0][1] < middle[1] < left[1][1]


def test_an_upright_mouse_stands_on_its_side() -> None:
    asset = made(5, style="upright")
    turned = asset.joint("axle_press").axis
    assert turned[0] < -0.7, "its buttons face to the right"
    low, high = asset.bounds()
    assert low[2] == pytest.approx(0.0, abs=1e-6)
    assert high[2] - low[2] > 0.060
    for name in ("plain", "game"):
        assert made(5, style=name).joint("axle_press").axis == pytest.approx([0, 0, -1])


def test_only_mice_for_the_right_hand_are_tilted() -> None:
    with pytest.raises(InfeasibleError, match="only mice for the right hand are tilted"):
        find("mouse").generate(1, style="plain", tilt=0.3)


@pytest.mark.parametrize(
    ("style", "size", "mass"),
    [
        ("plain", (0.107, 0.119), (0.068, 0.092)),
        ("travel", (0.093, 0.103), (0.052, 0.070)),
        ("game", (0.117, 0.128), (0.080, 0.108)),
        ("right", (0.111, 0.122), (0.092, 0.122)),
        ("upright", (0.111, 0.122), (0.120, 0.165)),
    ],
)
def test_sizes_and_masses_are_those_of_data_sheets(
    style: str, size: tuple[float, float], mass: tuple[float, float]
) -> None:
    for seed in range(4):
        asset = made(seed, style=style, **({"wired": False} if style in ("plain", "game") else {}))
        low, high = asset.link("body").bounds()
        assert size[0] < high[1] - low[1] < size[1]
        assert mass[0] < asset.mass < mass[1]
        assert np.all(high - low > 0.03)
