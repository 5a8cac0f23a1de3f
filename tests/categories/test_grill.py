"""What is special to a grill: lids that stay open, grates below them, a plate that floats, real masses."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released

MASSES = {"kettle": (7, 18), "gas": (40, 65), "egg": (36, 95), "portable": (8, 15), "press": (4, 8)}


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("grill").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", MASSES)
def test_a_grill_weighs_as_it_is_sold(style: str) -> None:
    low, high = MASSES[style]
    for seed in range(4):
        assert low < made(seed, style=style).mass < high


@pytest.mark.parametrize("style", MASSES)
def test_a_lid_stays_where_it_is_left(style: str) -> None:
    asset = made(1, style=style)
    limits = asset.joint("lid_hinge").limits
    assert limits is not None
    for angle in (0.5, 1.0, limits[1]):
        assert released(asset, "lid_hinge", angle) == pytest.approx(angle, abs=0.03)


@pytest.mark.parametrize("style", ["kettle", "gas", "egg", "portable"])
def test_a_grate_lifts_out_below_an_open_lid(style: str) -> None:
    asset = made(1, style=style)
    limits = asset.joint("lid_hinge").limits
    assert limits is not None
    assert asset.blocked({"grate_lift": 0.1})
    assert asset.clearance({"grate_lift": 0.1})["lid", "grate"] < 0
    assert not asset.blocked({"grate_lift": 0.2, "lid_hinge": limits[1]})
    assert asset.clearance({"grate_lift": 0.2, "lid_hinge": limits[1]})["lid", "grate"] > 0


def test_the_upper_plate_of_a_contact_grill_floats() -> None:
    asset = made(1, style="press")
    assert asset.clearance({})["body", "lid"] < 0.002
    assert asset.clearance({"lid_lift": 0.02})["body", "lid"] > 0
    assert released(asset, "lid_lift", 0.02, seconds=2.0) == pytest.approx(0.0, abs=2e-3)


def test_a_shelf_stays_level_until_it_is_pushed_down() -> None:
    asset = made(1, style="gas")
    assert released(asset, "shelf_hinge_right", 0.0) == pytest.approx(0.0, abs=0.02)
    assert released(asset, "shelf_hinge_right", 0.0, pull=20.0) > 1.2


def test_widths_that_are_not_sold_are_refused() -> None:
    for style, width in (("kettle", 0.75), ("press", 0.6)):
        with pytest.raises(InfeasibleError, match=f"width of a {style} grill must be"):
            made(1, style=style, width=width)
