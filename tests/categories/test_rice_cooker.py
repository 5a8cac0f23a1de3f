"""What is special to a rice cooker: a latch that holds its lid, pots that lift out, levers and keys."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released

MASSES = {
    "hinged": (2.9, 4.7),
    "upright": (3.9, 7.0),
    "lever": (1.2, 3.2),
    "pressure": (4.8, 7.2),
    "slow": (3.6, 7.0),
}


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("rice_cooker").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", MASSES)
def test_a_cooker_weighs_as_it_is_sold(style: str) -> None:
    low, high = MASSES[style]
    for seed in range(4):
        assert low < made(seed, style=style).mass < high


@pytest.mark.parametrize(
    ("style", "control", "free"), [("hinged", "open_slide", 0.0049), ("upright", "lock_turn", 1.56)]
)
def test_the_latch_holds_the_lid_until_it_is_drawn(style: str, control: str, free: float) -> None:
    asset = made(1, style=style)
    collides = [asset.clearance({"lid_hinge": angle, control: 0.0})["body", "latch"] for angle in (0.0, 0.01)]
    assert collides[0] > 0 > collides[1]
    assert asset.clearance({"lid_hinge": 0.01, control: free})["body", "latch"] > 0
    assert asset.blocked({"lid_hinge": 0.03})
    assert not asset.blocked({"lid_hinge": 0.03, control: free})
    assert asset.blocked({"pot_lift": 0.05})
    assert not asset.blocked({"lid_hinge": 1.6, "pot_lift": 0.15})


def test_an_open_lid_stays_and_its_button_springs_back() -> None:
    asset = made(1, style="hinged")
    assert released(asset, "lid_hinge", 0.8) == pytest.approx(0.8, abs=0.02)
    assert released(asset, "open_slide", 0.005) == pytest.approx(0.0, abs=2e-4)


def test_a_lever_snaps_to_both_ends() -> None:
    asset = made(1, style="lever")
    assert released(asset, "lever_slide", 0.0) == pytest.approx(0.0, abs=3e-4)
    assert released(asset, "lever_slide", 0.009) == pytest.approx(0.009, abs=3e-4)
    assert released(asset, "lever_slide", 0.009, pull=-15.0) == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("style", ["lever", "slow"])
def test_a_loose_lid_rides_on_its_pot(style: str) -> None:
    asset = made(1, style=style)
    assert asset.joint("lid_lift").parent == "pot"
    assert asset.clearance({})["pot", "lid"] == pytest.approx(0.0006, abs=4e-4)


def test_a_pressure_cooker_turns_before_it_lifts() -> None:
    asset = made(1, style="pressure")
    assert asset.blocked({"lid_lift": 0.05})
    assert asset.blocked({"lid_lift": 0.05, "lid_turn": 0.2})
    assert not asset.blocked({"lid_lift": 0.05, "lid_turn": 0.52})
    assert asset.clearance({"lid_lift": 0.02, "lid_turn": 0.52})["body", "lid"] > 0


def test_sizes_that_are_not_sold_are_refused() -> None:
    for style, width in (("hinged", 0.40), ("slow", 0.25), ("pressure", 0.25)):
        with pytest.raises(InfeasibleError, match=f"width of a {style} cooker must be"):
            made(1, style=style, width=width)
