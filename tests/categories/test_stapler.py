"""What is special to a stapler: a spring lifts its arm, its anvil snaps, pins pass the paper, masses."""

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
    return find("stapler").generate(seed, certify=False, **given)


@pytest.mark.parametrize(
    ("style", "name"), [("half", "arm_hinge"), ("punch", "arm_hinge"), ("plier", "lever_hinge")]
)
def test_a_spring_returns_what_a_hand_pressed(style: str, name: str) -> None:
    asset = made(1, style=style)
    (_, end) = asset.joint(name).limits or (0.0, 0.0)
    assert released(asset, name, 0.9 * end) == pytest.approx(0.0, abs=0.02)


def test_an_anvil_snaps_to_its_two_grooves() -> None:
    asset = made(2, style="full")
    for share, groove in ((0.3, 0.0), (0.7, math.pi)):
        assert released(asset, "anvil_turn", share * math.pi) == pytest.approx(groove, abs=0.1)


def test_the_force_at_the_front_is_the_parameter() -> None:
    asset = made(3, style="full", lift=6.0)
    hinge = asset.joint("arm_hinge")
    (low, high) = hinge.limits or (0.0, 0.0)
    step = hinge.stiffness * (high - low)
    reach = hinge.pivot[1] - asset.link("base").bounds()[0, 1]
    assert step / reach == pytest.approx(3.0, rel=0.02), "half of the force is added on the way"


def test_pins_of_a_punch_enter_the_tray_at_80_mm() -> None:
    asset = made(4, style="punch")
    (_, end) = asset.joint("arm_hinge").limits or (0.0, 0.0)
    feet = [asset.link(f"pin_{n}").bounds() for n in range(2)]
    assert feet[1].mean(axis=0)[0] - feet[0].mean(axis=0)[0] == pytest.approx(0.080, abs=1e-6)
    pressed = asset.pose({"arm_hinge": end})["pin_0"] @ np.array([*feet[0][0], 1.0])
    slit = 0.024  # height of the tray [m]
    assert pressed[2] < slit < feet[0][0][2], "the sheet lies between tray and tower"


@pytest.mark.parametrize(
    ("style", "least", "most"), [("full", 0.25, 0.5), ("heavy", 1.3, 2.6), ("plier", 0.18, 0.45)]
)
def test_masses_are_those_of_catalogs(style: str, least: float, most: float) -> None:
    assert least < made(5, style=style).mass < most
