"""What is special to knives: blades that snap over, a ring and a screw that hold them, sliders that click."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("knife").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", ["folding", "hunter", "multi"])
def test_a_back_spring_snaps_a_blade_over_half_a_turn(style: str) -> None:
    asset = made(1, style=style, torque=0.2)
    for share, end in ((0.3, 0.0), (0.7, math.pi)):
        assert released(asset, "blade_hinge", share * math.pi) == pytest.approx(end, abs=0.03)


@pytest.mark.parametrize("style", ["folding", "hunter", "ring", "multi"])
def test_an_open_blade_points_away_from_the_handle(style: str) -> None:
    asset = made(2, style=style)
    low, high = asset.link("blade").bounds()
    handle = asset.link("handle").bounds()
    turned = asset.pose({"blade_hinge": math.pi})["blade"]
    tip = turned @ np.array([low[0], 0.0, (low[2] + high[2]) / 2, 1.0])
    assert low[0] > handle[0][0], "the folded blade is within the handle"
    assert tip[0] - handle[1][0] > 0.55 * (handle[1][0] - handle[0][0])


def test_friction_holds_a_blade_with_a_ring() -> None:
    assert released(made(1, style="ring"), "blade_hinge", 1.2) == pytest.approx(1.2, abs=0.02)


def test_the_ring_turns_at_both_ends_and_holds_the_blade_there() -> None:
    asset = made(3, style="ring")
    assert not asset.blocked({"blade_hinge": 0.0, "ring_turn": 0.6})
    assert not asset.blocked({"blade_hinge": math.pi, "ring_turn": 0.6})
    assert asset.blocked({"blade_hinge": 1.5, "ring_turn": 0.6})
    for position in (0.10, math.pi - 0.12):
        apart = asset.clearance({"blade_hinge": position, "ring_turn": 0.6})
        assert min(apart.values()) < 0.0, "steel stands in its way"


def test_openers_of_a_multi_tool_point_to_each_other_beside_the_blade() -> None:
    asset = made(4, style="multi")
    opener, lifter, blade = (asset.link(name).bounds() for name in ("opener", "lifter", "blade"))
    assert lifter[1][0] < opener[0][0], "fingers reach the blade between both"
    assert blade[1][1] < opener[0][1], "the blade has a layer of its own"
    assert not asset.blocked({"opener_hinge": 2.0, "lifter_hinge": 1.0, "blade_hinge": 3.0})


@pytest.mark.parametrize(("wide", "click"), [(9, 0.005), (18, 0.005)])
def test_a_cutter_clicks_into_the_nearest_step(wide: int, click: float) -> None:
    asset = made(5, style="cutter", wide=wide, lock="ratchet", click=9.0)
    assert released(asset, "blade_slide", 3.35 * click) == pytest.approx(3 * click, abs=0.0012)
    assert released(asset, "blade_slide", 3.65 * click) == pytest.approx(4 * click, abs=0.0012)


def test_friction_holds_the_blade_of_a_cutter_with_a_screw() -> None:
    asset = made(6, style="cutter", wide=18, lock="screw")
    assert released(asset, "blade_slide", 0.02, pull=6.0) == pytest.approx(0.02, abs=0.001)


@pytest.mark.parametrize("style", ["cutter", "utility"])
def test_a_blade_at_its_end_stands_out_and_at_0_does_not(style: str) -> None:
    asset = made(7, style=style, lock="ratchet")
    (_, end) = asset.joint("blade_slide").limits or (0.0, 0.0)
    out = asset.link("blade").bounds()[1][0] - asset.link("handle").bounds()[1][0]
    assert out < 0.0
    assert out + end > 0.018


@pytest.mark.parametrize(
    ("style", "least", "most"),
    [("folding", 0.10, 0.17), ("hunter", 0.16, 0.22), ("ring", 0.04, 0.075), ("multi", 0.05, 0.085),
     ("utility", 0.15, 0.21)],
)  # fmt: skip
def test_masses_are_those_of_catalogs(style: str, least: float, most: float) -> None:
    assert least < made(8, style=style).mass < most
