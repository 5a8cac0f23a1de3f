"""What is special to a kettle: a jug that lifts off, a lid beside a folded handle, sizes and masses."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find

STYLES = ("spout", "gooseneck", "stove")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("kettle").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize("style", ["spout", "gooseneck"])
def test_a_jug_turns_on_its_base_and_lifts_off(style: str) -> None:
    asset = made(1, style=style)
    assert asset.joint("jug_turn").limits is None
    for lift, turn in ((0.0, 2.0), (0.15, -1.0)):
        gap = asset.clearance({"jug_lift": lift, "jug_turn": turn})["base", "jug"]
        assert gap == pytest.approx(lift + 0.0006, abs=2e-4)


def test_a_lid_lifts_off_only_beside_the_folded_handle() -> None:
    asset = made(2, style="stove")
    assert asset.blocked({"lid_lift": 0.06})
    assert not asset.blocked({"lid_lift": 0.06, "bail_turn": 1.05})
    assert not asset.blocked({"bail_turn": -1.05})
    assert asset.joint("bail_turn").limits == pytest.approx((-1.1, 1.1))


@pytest.mark.parametrize("style", STYLES)
def test_sizes_and_masses_are_those_of_half_full_kettles(style: str) -> None:
    asset = made(4, style=style)
    low, high = asset.bounds()
    assert 0.15 < high[2] - low[2] < 0.30
    assert 1.0 < asset.mass < 2.6


@pytest.mark.parametrize("seed", [3, 2737])
def test_the_handle_of_a_dome_bends_as_far_as_there_is_room(seed: int) -> None:
    assert find("kettle").generate(seed, form="dome").certificate.proven
