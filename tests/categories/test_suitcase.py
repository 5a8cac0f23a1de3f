"""What is special to a suitcase: latches that hold the lid, a pull held by friction, sizes."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError

STYLES = ("trolley", "tool_case", "attache")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("suitcase").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", STYLES)
def test_two_latches_hold_the_lid(style: str) -> None:
    asset = made(1, style=style)
    closed = {"lid_hinge": 0.02}
    assert asset.blocked(closed)
    assert asset.blocked({**closed, "latch_turn_left": 1.9})
    assert not asset.blocked({**closed, "latch_turn_left": 1.9, "latch_turn_right": 1.9})


def test_a_hook_leaves_less_play_than_a_millimeter() -> None:
    gaps = made(1, style="attache").clearance()
    for side in ("left", "right"):
        assert gaps[f"latch_{side}", "lid"] == pytest.approx(0.0008, abs=1e-4)


def test_a_pull_slides_under_a_hand_and_stays_where_it_is_left() -> None:
    asset = made(1, style="trolley")
    pull = asset.joint("pull_slide")
    low, high = pull.limits
    assert low == 0.0
    assert not asset.blocked({"pull_slide": high / 2})
    moving = asset.links["pull"].mass + asset.links["button"].mass
    assert 2 * 9.81 * moving < pull.friction < 50.0
    grip = asset.pose({"pull_slide": high})["pull"][:3, 3] - asset.pose({})["pull"][:3, 3]
    assert grip == pytest.approx([0, 0, high], abs=1e-9), "it is drawn upward"


@pytest.mark.parametrize("style", STYLES)
def test_sizes_and_masses_are_those_of_shops(style: str) -> None:
    asset = made(4, style=style)
    low, high = asset.bounds()
    assert low[2] == pytest.approx(0.0, abs=1e-6), "it stands on the floor"
    assert 0.1 < high[2] - low[2] < 0.85
    assert 1.2 < asset.mass < 6.0


def test_a_trolley_that_is_too_thin_for_its_wheels_is_refused() -> None:
    flat = find("suitcase").generate(1088, style="trolley", rolling="wheels", high=0.11, opens=3.0)
    assert flat.certificate.proven
    with pytest.raises(InfeasibleError, match=r"high of a trolley must be >= 0\.11 m"):
        made(1, style="trolley", high=0.1)
