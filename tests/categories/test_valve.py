"""What is special to a valve: a quarter turn between stops, stems on threads, sizes of standards."""

import math
from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("valve").generate(seed, certify=False, **given)


def test_a_lever_turns_a_quarter_between_its_stops_and_stays() -> None:
    asset = made(1, style="ball", dn=25)
    assert asset.joint("lever_turn").limits == pytest.approx((0.0, math.pi / 2))
    for end in (0.0, math.pi / 2):
        assert min(asset.clearance({"lever_turn": end}).values()) < 0.001, "a stop is beside the lever"
    assert released(asset, "lever_turn", 0.7) == pytest.approx(0.7, abs=0.01)


@pytest.mark.parametrize(("style", "dn"), [("needle", 15), ("gate", 15), ("globe", 65), ("ball", 8)])
def test_a_style_has_the_sizes_of_its_table(style: str, dn: int) -> None:
    with pytest.raises(InfeasibleError, match=rf"style={style} is made for dn=\d+ or .*: set dn or style"):
        find("valve").generate(0, style=style, dn=dn)


def test_a_wheel_draws_the_stem_of_a_gate_by_its_size() -> None:
    asset = made(2, style="gate", dn=50)
    (_, end) = asset.joint("wheel_turn").limits or (0.0, 0.0)
    closed, opened = (asset.pose({"wheel_turn": at})["stem"][2, 3] for at in (0.0, end))
    assert opened - closed == pytest.approx(0.050, abs=1e-4)


def test_the_wheel_of_a_globe_valve_rises_with_its_stem() -> None:
    asset = made(3, style="globe", dn=40)
    closed, turned = (asset.pose({"wheel_turn": at})["wheel"][2, 3] for at in (0.0, math.tau))
    assert turned - closed == pytest.approx(0.004, abs=1e-6), "the pitch of its thread"


@pytest.mark.parametrize(
    ("style", "dn", "long", "across"), [("gate", 80, 0.180, 0.200), ("globe", 25, 0.160, 0.115)]
)
def test_flanges_have_the_sizes_of_standards(style: str, dn: int, long: float, across: float) -> None:
    flanges = [
        each.shape.bounds()
        for each in made(4, style=style, dn=dn).link("body").pieces
        if each.label == "flange"
    ]
    assert max(b[1][0] for b in flanges) - min(b[0][0] for b in flanges) == pytest.approx(long, abs=1e-4)
    assert max(b[1][2] for b in flanges) - min(b[0][2] for b in flanges) == pytest.approx(across, abs=1e-3)
