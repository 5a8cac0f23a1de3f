"""What is special to lighters: lids that snap, geared lids and snuffers, springs, a wheel that turns on."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("lighter").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", ["petrol", "arc"])
def test_a_lid_snaps_to_both_ends(style: str) -> None:
    asset = made(1, style=style)
    (_, end) = asset.joint("lid_hinge").limits or (0.0, 0.0)
    assert released(asset, "lid_hinge", 0.3 * end) == pytest.approx(0.0, abs=0.05)
    assert released(asset, "lid_hinge", 0.75 * end) == pytest.approx(end, abs=0.05)


@pytest.mark.parametrize(
    ("style", "name"),
    [("arc", "button_slide"), ("gas", "lever_press"), ("jet", "button_slide"), ("table", "lever_press"),
     ("stick", "trigger_slide")],
)  # fmt: skip
def test_a_spring_returns_what_a_thumb_pressed(style: str, name: str) -> None:
    asset = made(2, style=style)
    (_, end) = asset.joint(name).limits or (0.0, 0.0)
    assert released(asset, name, end) == pytest.approx(0.0, abs=0.08 * end)


@pytest.mark.parametrize(
    ("style", "key", "follower", "cover"),
    [("jet", "button_slide", "lid_hinge", "lid"), ("table", "lever_press", "snuffer_hinge", "snuffer")],
)
def test_what_is_pressed_opens_what_covers_the_flame(style: str, key: str, follower: str, cover: str) -> None:
    asset = made(3, style=style)
    (_, end) = asset.joint(key).limits or (0.0, 0.0)
    assert asset.positions({key: end})[follower] == pytest.approx(1.22, abs=0.05)
    low, high = asset.link(cover).bounds()
    corner = (
        np.array([high[0], 0.0, high[2], 1.0]) if style == "jet" else np.array([low[0], 0.0, high[2], 1.0])
    )
    assert (asset.pose({key: end})[cover] @ corner)[2] - corner[2] > 0.003


@pytest.mark.parametrize("style", ["petrol", "gas"])
def test_a_striking_wheel_turns_on_and_on_under_a_thumb(style: str) -> None:
    asset = made(4, style=style)
    wheel = asset.joint("wheel_turn")
    assert wheel.limits is None
    assert wheel.driven == "the friction of a thumb"
    assert min(asset.clearance({"wheel_turn": 1.0}).values()) > 0.0


def test_an_open_lid_is_beside_its_case_and_shows_the_insert() -> None:
    asset = made(5, style="petrol")
    case = asset.link("case").bounds()
    (_, end) = asset.joint("lid_hinge").limits or (0.0, 0.0)
    low, high = asset.link("lid").bounds()
    pose = asset.pose({"lid_hinge": end})["lid"]
    middle = pose @ np.array([*(low + high) / 2, 1.0])
    assert middle[0] < case[0][0], "at the left"
    assert low[2] < case[1][2] < high[2], "the closed lid covers the chimney"


def test_friction_holds_the_insert_in_its_base() -> None:
    asset = made(6, style="table")
    assert released(asset, "insert_lift", 0.0, pull=2.0) == pytest.approx(0.0, abs=1e-3)
    assert released(asset, "insert_lift", 0.02) == pytest.approx(0.02, abs=2e-3)


@pytest.mark.parametrize(
    ("style", "least", "most"),
    [("petrol", 0.05, 0.066), ("arc", 0.05, 0.08), ("gas", 0.013, 0.024), ("jet", 0.07, 0.13),
     ("table", 0.18, 1.4), ("stick", 0.045, 0.09)],
)  # fmt: skip
def test_masses_are_those_of_catalogs(style: str, least: float, most: float) -> None:
    assert least < made(7, style=style).mass < most
