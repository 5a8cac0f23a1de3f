"""What is special to USB sticks: plugs of the standard, covered at 0, and what clicks, slides or unscrews."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released

STYLES = ("swivel", "slider", "dual", "cap", "rugged")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("usb_stick").generate(seed, certify=False, **given)


def shell(asset: Asset) -> np.ndarray:
    """Return the bounds of the shell of the plug of type A [m]."""
    name = "plug" if asset.parameters["style"] in ("slider", "dual") else "body"
    shells = [
        each.shape.bounds() for each in asset.link(name).pieces if each.label == "plug" and not each.visual
    ]
    return max(shells, key=lambda bounds: bounds[1][1] - bounds[0][1])


@pytest.mark.parametrize("style", STYLES)
def test_a_plug_has_the_section_of_the_standard(style: str) -> None:
    low, high = shell(made(1, style=style))
    assert high[1] - low[1] == pytest.approx(0.0120, abs=1e-5)
    assert high[2] - low[2] == pytest.approx(0.0045, abs=1e-5)


@pytest.mark.parametrize(
    ("style", "over"),
    [("swivel", "cover"), ("slider", "body"), ("dual", "body"), ("cap", "cap"), ("rugged", "cap")],
)
def test_a_plug_is_covered_at_0(style: str, over: str) -> None:
    asset = made(2, style=style)
    plug, cover = shell(asset), asset.link(over).bounds()
    assert plug[1][0] < cover[1][0]
    assert (plug[:, 1:] > cover[0][1:]).all()
    assert (plug[:, 1:] < cover[1][1:]).all()


def test_a_stick_clicks_at_each_quarter_of_a_turn() -> None:
    asset = made(3, style="swivel")
    for share in (0.9, 1.1):
        assert released(asset, "body_turn", share * math.pi / 2) == pytest.approx(math.pi / 2, abs=0.25)
    pose = asset.pose({"body_turn": math.pi})["body"]
    tip = pose @ np.array([*shell(asset)[1], 1.0])
    assert tip[0] < asset.link("cover").bounds()[0][0] - 0.018, "the plug is free at half a turn"


@pytest.mark.parametrize(("style", "end"), [("slider", 1), ("dual", 1)])
def test_a_plug_that_slides_out_stands_out_by_its_length(style: str, end: int) -> None:
    asset = made(4, style=style)
    travel = (asset.joint("plug_slide").limits or (0.0, 0.0))[end]
    out = shell(asset)[1][0] + travel - asset.link("body").bounds()[1][0]
    assert out == pytest.approx(0.0120, abs=0.001)


def test_two_plugs_come_out_at_both_ends_of_one_slider() -> None:
    asset = made(5, style="dual")
    (back, _) = asset.joint("plug_slide").limits or (0.0, 0.0)
    left = asset.link("plug").bounds()[0][0] + back
    assert asset.link("body").bounds()[0][0] - left == pytest.approx(0.0060, abs=0.001)
    assert released(asset, "plug_slide", 0.3 * back) == pytest.approx(0.0, abs=1e-3)
    assert released(asset, "plug_slide", 0.7 * back) == pytest.approx(back, abs=1e-3)


def test_a_slider_snaps_to_both_ends() -> None:
    asset = made(6, style="slider", force=6.0)
    (_, end) = asset.joint("plug_slide").limits or (0.0, 0.0)
    assert released(asset, "plug_slide", 0.3 * end) == pytest.approx(0.0, abs=1e-3)
    assert released(asset, "plug_slide", 0.7 * end) == pytest.approx(end, abs=1e-3)


def test_friction_holds_a_cap_that_is_drawn_off_all_the_way() -> None:
    asset = made(7, style="cap", force=6.0)
    assert released(asset, "cap_slide", 0.0, pull=4.0) == pytest.approx(0.0, abs=5e-4)
    (_, end) = asset.joint("cap_slide").limits or (0.0, 0.0)
    assert asset.link("cap").bounds()[0][0] + end > shell(asset)[1][0] + 0.01


def test_the_tube_of_a_rugged_stick_rises_along_its_thread() -> None:
    asset = made(8, style="rugged")
    (_, end) = asset.joint("cap_turn").limits or (0.0, 0.0)
    assert asset.positions({"cap_turn": end})["cap_turn_rise"] == pytest.approx(0.006, abs=1e-6)


@pytest.mark.parametrize(
    ("style", "least", "most"),
    [("swivel", 0.009, 0.021), ("slider", 0.007, 0.015), ("dual", 0.007, 0.015), ("cap", 0.007, 0.024),
     ("rugged", 0.03, 0.065)],
)  # fmt: skip
def test_masses_are_those_of_catalogs(style: str, least: float, most: float) -> None:
    assert least < made(9, style=style).mass < most
