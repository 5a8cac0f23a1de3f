"""What is special to a remote: keys spring back, covers stay, the blade of a key snaps to its ends, sizes."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released

STYLES = ("tv", "stick", "air", "car", "gate")


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("remote").generate(seed, certify=False, **given)


def pressed(asset: Asset) -> list[str]:
    return [joint.name for joint in asset.joints if joint.name.startswith("key_press")]


@pytest.mark.parametrize("style", STYLES)
def test_keys_spring_back(style: str) -> None:
    asset = made(1, style=style)
    travel = asset.parameters["travel"]
    for name in (pressed(asset)[0], pressed(asset)[-1]):
        assert asset.joint(name).limits == pytest.approx((0.0, travel))
        assert released(asset, name, travel) == pytest.approx(0.0, abs=1e-4)


def test_digits_and_rows_are_as_many_as_given() -> None:
    few, many = (made(2, style="tv", digits=digits, extra=0) for digits in (False, True))
    assert (len(pressed(few)), len(pressed(many))) == (17, 29)
    assert len(pressed(made(2, style="tv", digits=True, extra=5))) == 45
    assert len(pressed(made(2, style="gate", extra=3))) == 3


def test_cells_lie_over_the_cover_that_slides_off_the_near_end() -> None:
    asset = made(3, style="stick")
    cells = [piece.shape.bounds() for piece in asset.link("body").pieces if piece.label == "battery"]
    cover = asset.link("battery_cover").bounds()
    for low, high in cells:
        assert high[1] - low[1] == pytest.approx(0.0440, abs=1e-6)
        assert low[2] > 0.0015, "above the plate of the cover"
        assert low[1] > cover[0][1] + 0.016
    assert released(asset, "battery_slide", 0.03) == pytest.approx(0.03, abs=1e-3)
    end = (asset.joint("battery_slide").limits or (0.0, 0.0))[1]
    moved = asset.pose({"battery_slide": end})["battery_cover"] @ np.append(cover[1], 1.0)
    assert moved[1] < asset.link("body").bounds()[0][1] + 0.01, "the cover is off"


def test_the_front_cover_uncovers_the_lower_keys() -> None:
    asset = made(4, style="air", extra=3)
    cover = asset.link("front_cover").bounds()
    low, high = (asset.link(name).bounds() for name in (pressed(asset)[-1].replace("_press", ""), "key_6"))
    assert cover[0][1] < low[0][1] < high[1][1] < cover[1][1], "closed, it lies over them"
    assert low[1][2] < cover[0][2]
    opened = cover[1][1] - (asset.joint("front_slide").limits or (0.0, 0.0))[1]
    assert opened < low[0][1] - 0.006, "a finger reaches the last row"


def test_the_blade_of_a_car_snaps_to_its_ends() -> None:
    asset = made(5, style="car")
    for share, expected in ((0.4, 0.0), (0.6, math.pi)):
        assert released(asset, "blade_turn", share * math.pi) == pytest.approx(expected, abs=0.05)
    blade, body = asset.link("blade").bounds(), asset.link("body").bounds()
    assert blade[0][0] > body[0][0]
    assert blade[0][1] > body[0][1], "folded, it lies inside of the outline of the body"


@pytest.mark.parametrize(
    ("style", "length", "mass"),
    [
        ("tv", (0.15, 0.26), (0.07, 0.16)),
        ("stick", (0.115, 0.17), (0.04, 0.08)),
        ("air", (0.16, 0.21), (0.10, 0.17)),
        ("car", (0.10, 0.13), (0.03, 0.06)),
        ("gate", (0.08, 0.11), (0.015, 0.05)),
    ],
)
def test_sizes_and_masses_are_those_of_shops(
    style: str, length: tuple[float, float], mass: tuple[float, float]
) -> None:
    for seed in range(3):
        asset = made(seed, style=style)
        low, high = asset.bounds()
        assert length[0] < high[1] - low[1] < length[1]
        assert mass[0] < asset.mass < mass[1]
