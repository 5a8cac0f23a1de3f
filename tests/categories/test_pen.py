"""What is special to pens: points that come out, springs and snaps, caps that are drawn or screwed off."""

import math
from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released

CAPPED = ("hexagonal", "marker", "highlighter")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("pen").generate(seed, certify=False, **given)


@pytest.mark.parametrize(
    ("style", "key", "carrier"), [("click", "button_slide", "button"), ("twist", "top_turn", "refill")]
)
def test_a_point_is_inside_at_0_and_outside_at_the_end(style: str, key: str, carrier: str) -> None:
    asset = made(1, style=style)
    (_, end) = asset.joint(key).limits or (0.0, 0.0)
    front = asset.link("barrel").bounds()[1][0]
    point = asset.link(carrier).bounds()[1][0]
    moved = asset.pose({key: end})[carrier][0, 3]
    assert point < front
    assert moved == pytest.approx(0.0055, abs=1e-6)
    assert 0.003 < point + moved - front < 0.006


def test_a_spring_returns_the_button() -> None:
    asset = made(2, style="click", force=6.0)
    assert released(asset, "button_slide", 0.0055) == pytest.approx(0.0, abs=5e-4)
    assert released(asset, "button_slide", 0.0, pull=1.5) == pytest.approx(0.0, abs=5e-4)
    assert released(asset, "button_slide", 0.0, pull=8.0) == pytest.approx(0.0055, abs=5e-4)


def test_a_twist_pen_snaps_to_both_ends() -> None:
    asset = made(3, style="twist")
    for share, end in ((0.3, 0.0), (0.75, 2.1)):
        assert released(asset, "top_turn", share * 2.1) == pytest.approx(end, abs=0.03)


@pytest.mark.parametrize("style", CAPPED)
def test_a_cap_is_held_by_friction_and_drawn_off_all_the_way(style: str) -> None:
    asset = made(4, style=style, force=8.0)
    assert released(asset, "cap_slide", 0.0, pull=5.0) == pytest.approx(0.0, abs=5e-4)
    (_, end) = asset.joint("cap_slide").limits or (0.0, 0.0)
    assert asset.link("cap").bounds()[0][0] + end > asset.link("barrel").bounds()[1][0]


@pytest.mark.parametrize("style", CAPPED)
def test_a_closed_cap_covers_the_point(style: str) -> None:
    asset = made(5, style=style)
    cap, barrel = asset.link("cap").bounds(), asset.link("barrel").bounds()
    assert cap[0][0] < barrel[1][0] < cap[1][0]
    assert min(asset.clearance({}).values()) > 0.0


def test_the_cap_of_a_fountain_pen_rises_along_its_thread() -> None:
    asset = made(6, style="fountain", thread=True)
    (_, end) = asset.joint("cap_turn").limits or (0.0, 0.0)
    assert end == pytest.approx(1.5 * math.tau)
    assert asset.positions({"cap_turn": end})["cap_turn_rise"] == pytest.approx(0.0036, abs=1e-6)


def test_a_fountain_pen_without_a_thread_shows_its_nib() -> None:
    asset = made(7, style="fountain", thread=False)
    (_, end) = asset.joint("cap_slide").limits or (0.0, 0.0)
    nibs = [piece.shape.bounds() for piece in asset.link("barrel").pieces if piece.label == "nib"]
    assert asset.link("cap").bounds()[0][0] + end > max(high[0] for _, high in nibs)


@pytest.mark.parametrize(
    ("style", "least", "most"),
    [("click", 0.006, 0.03), ("twist", 0.018, 0.04), ("hexagonal", 0.005, 0.0075), ("marker", 0.012, 0.026),
     ("highlighter", 0.017, 0.03), ("fountain", 0.011, 0.03)],
)  # fmt: skip
def test_masses_are_those_of_catalogs(style: str, least: float, most: float) -> None:
    assert least < made(8, style=style).mass < most
