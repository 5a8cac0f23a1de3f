"""What is special to syringes: bore and stroke make the volume, plungers hold, threads, a button."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released


@lru_cache(maxsize=24)
def made(seed: int, **given: Any) -> Asset:
    return find("syringe").generate(seed, certify=False, **given)


def end_of(asset: Asset, name: str) -> float:
    limits = asset.joint(name).limits
    assert limits is not None
    return limits[1]


@pytest.mark.parametrize("volume", ["1", "2.5", "5", "10", "20", "60"])
@pytest.mark.parametrize("style", ["luer", "oral"])
def test_the_stroke_draws_the_volume(style: str, volume: str) -> None:
    asset = made(1, style=style, volume=volume)
    stopper = next(piece.shape.bounds() for piece in asset.link("plunger").pieces if piece.label == "stopper")
    radius = np.ptp(stopper[:, 1]) / 2 + 0.0003  # it has few sides, and some play in the bore
    drawn = math.pi * radius**2 * end_of(asset, "plunger_slide")
    assert 1e6 * drawn == pytest.approx(float(volume), rel=0.065)


@pytest.mark.parametrize("style", ["luer", "glass", "oral", "icing"])
def test_friction_holds_a_plunger_until_a_thumb_moves_it(style: str) -> None:
    asset = made(2, style=style)
    force, half = asset.joint("plunger_slide").friction, 0.5 * end_of(asset, "plunger_slide")
    assert released(asset, "plunger_slide", half) == pytest.approx(half, abs=1e-3)
    assert released(asset, "plunger_slide", half, pull=-0.8 * force) == pytest.approx(half, abs=2e-3)
    assert released(asset, "plunger_slide", half, pull=-2.0 * force - 2.0) < 0.3 * half


@pytest.mark.parametrize("style", ["luer", "glass", "icing"])
def test_a_drawn_plunger_stays_in_its_barrel(style: str) -> None:
    asset = made(3, style=style)
    end = end_of(asset, "plunger_slide")
    barrel, plunger = asset.link("barrel").bounds(), asset.link("plunger").bounds()
    assert plunger[0, 0] + end < barrel[1, 0] - 0.004
    assert plunger[1, 0] > barrel[1, 0] + 0.006, "a thumb finds its end"


def test_a_cap_is_drawn_off_its_tip() -> None:
    for given in ({"style": "luer", "lock": True, "capped": True}, {"style": "oral", "capped": True}):
        asset = made(4, **given)
        cap, barrel = asset.link("cap").bounds(), asset.link("barrel").bounds()
        assert cap[0, 0] < barrel[0, 0] < cap[1, 0]
        assert cap[1, 0] - end_of(asset, "cap_slide") < barrel[0, 0]
        assert 2.0 <= asset.joint("cap_slide").friction <= 6.0


def test_the_dial_of_a_pen_rises_with_its_turns_and_a_spring_returns_its_button() -> None:
    asset = made(5, style="pen")
    turns = end_of(asset, "dial_turn") / math.tau
    risen = asset.pose({"dial_turn": end_of(asset, "dial_turn")})["dial"][0, 3]
    assert turns == pytest.approx(2.5)
    assert risen == pytest.approx(0.0096 * turns, abs=1e-6)
    assert released(asset, "button_slide", 0.002) == pytest.approx(0.0, abs=2e-4)
    assert released(asset, "dial_turn", 5.0) == pytest.approx(5.0, abs=0.05)


def test_a_nozzle_for_icing_is_turned_off_to_the_left() -> None:
    asset = made(6, style="icing")
    moved = asset.pose({"nozzle_turn": end_of(asset, "nozzle_turn")})["nozzle"][0, 3]
    assert moved == pytest.approx(-0.0075, abs=1e-6)


@pytest.mark.parametrize(
    ("given", "least", "most"),
    [({"style": "luer", "volume": "1"}, 0.0012, 0.003), ({"style": "luer", "volume": "10"}, 0.005, 0.011),
     ({"style": "luer", "volume": "60"}, 0.024, 0.038), ({"style": "glass", "volume": "10"}, 0.025, 0.045),
     ({"style": "oral", "volume": "5"}, 0.003, 0.008), ({"style": "pen"}, 0.02, 0.045),
     ({"style": "icing"}, 0.07, 0.35)],
)  # fmt: skip
def test_masses_are_those_of_products(given: dict[str, str], least: float, most: float) -> None:
    assert least < made(7, **given).mass < most


def test_a_pen_too_short_for_its_cartridge_is_refused() -> None:
    with pytest.raises(InfeasibleError, match="length of a pen must be >="):
        find("syringe").generate(0, style="pen", length=0.142)
