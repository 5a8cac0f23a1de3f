"""What is special to a coffee machine: a jug under its basket, ears over ledges, a tank that lifts off."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate.hands import check_grasps

GIVEN = {"filter": {"basket": "lift"}}


@lru_cache(maxsize=4)
def made(seed: int, **given: Any) -> Asset:
    return find("coffee_machine").generate(seed, certify=False, **given)


def test_a_jug_lifts_off_only_in_front_of_the_basket() -> None:
    asset = made(1, style="filter", basket="swing")
    _, far = asset.joint("jug_slide").limits or (0.0, 0.0)
    assert asset.blocked({"jug_lift": 0.05})
    assert not asset.blocked({"jug_slide": far, "jug_lift": 0.12, "lid_hinge": 1.1})
    clear = asset.clearance({"jug_slide": far, "jug_lift": 0.12, "basket_turn": 1.0})
    assert clear["basket", "jug"] > 0.005
    assert asset.blocked({"lid_hinge": 0.5})


def test_a_basket_lifts_out_under_the_open_lid() -> None:
    asset = made(2, style="filter", basket="lift")
    assert asset.blocked({"basket_lift": 0.05})
    assert not asset.blocked({"basket_lift": 0.11, "tank_lid_hinge": 1.2})


def test_ledges_hold_a_portafilter_until_it_is_turned() -> None:
    asset = made(3, style="espresso")
    assert asset.blocked({"portafilter_lower": 0.01})
    assert asset.clearance({"portafilter_lower": 0.0})["body", "portafilter"] > 0.0003
    turned = {"portafilter_turn": 0.7}
    assert not asset.blocked(turned | {"portafilter_lower": 0.05})
    low = asset.clearance({"portafilter_lower": 0.01} | turned)["body", "portafilter"]
    assert low > 0.0003


def test_a_tank_lifts_off_with_its_lid() -> None:
    asset = made(4, style="capsule")
    gap = asset.clearance({"tank_lift": (asset.joint("tank_lift").limits or (0.0, 0.0))[1]})
    assert gap["body", "tank"] > 0.005
    assert asset.joint("tank_lid_hinge").parent == "tank"


@pytest.mark.parametrize(
    ("style", "mass"), [("filter", (2.2, 4.2)), ("capsule", (2.6, 4.6)), ("espresso", (5, 9))]
)
def test_masses_are_those_of_shops_with_water_and_coffee(style: str, mass: tuple[float, float]) -> None:
    asset = made({"filter": 2, "capsule": 4, "espresso": 3}[style], style=style, **GIVEN.get(style, {}))
    assert mass[0] < asset.mass < mass[1]


def test_a_hand_takes_the_basket_of_the_shallowest_machine_under_its_lid() -> None:
    asset = made(28, style="filter", basket="lift", opens=1.36, depth=0.236)
    assert check_grasps(asset).faults == ()


@pytest.mark.parametrize(("style", "least"), [("filter", 0.28), ("espresso", 0.32)])
def test_a_machine_that_is_too_low_is_refused(style: str, least: float) -> None:
    assert find("coffee_machine").generate(1, style=style, height=least).certificate.proven
    with pytest.raises(InfeasibleError, match=f"height of a machine for {style} must be >= {least:g} m"):
        find("coffee_machine").generate(1, style=style, height=least - 0.01)


def test_a_narrow_machine_for_espresso_is_refused() -> None:
    assert find("coffee_machine").generate(1, style="espresso", width=0.18).certificate.proven
    with pytest.raises(InfeasibleError, match=r"width of a machine for espresso must be >= 0\.18 m"):
        find("coffee_machine").generate(1, style="espresso", width=0.17)
