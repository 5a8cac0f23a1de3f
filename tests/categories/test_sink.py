"""What is special to a sink: baskets and plugs that lift off, a knob that lifts one, sizes and masses."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError


@lru_cache(maxsize=8)
def made(seed: int, **given: Any) -> Asset:
    return find("sink").generate(seed, on_collision="fail", **given)


def bowl_floor(asset: Asset) -> float:
    """Return the height of the floor of the first bowl [m]."""
    return float(asset.parameters["rim"] - asset.parameters["hollow"])


def test_a_basket_rests_in_its_drain_and_lifts_off() -> None:
    asset = made(1, style="inset", plug="basket", bowls="single", stand="none")
    low = asset.link("strainer").bounds()[0, 2]
    assert low == pytest.approx(bowl_floor(asset) + 0.0025 - 0.0375, abs=1e-3)
    assert asset.joint("strainer_lift").limits == pytest.approx((0.0, 0.12))
    assert not asset.blocked({"strainer_lift": 0.12})


def test_a_quarter_turn_of_the_knob_lifts_the_basket() -> None:
    asset = made(2, style="apron", plug="knob", bowls="double")
    follower = asset.joint("strainer_slide").follows
    assert follower is not None
    assert follower.leader == "knob_turn"
    _, high = asset.joint("knob_turn").limits or (0.0, 0.0)
    assert follower.ratio * high == pytest.approx(0.012, abs=1e-6)
    assert asset.joint("strainer_lift_right").follows is None, "a hand lifts the second basket out"


def test_a_lifted_rod_lowers_the_plug_of_a_washbasin() -> None:
    asset = made(3, style="pedestal", plug="rod")
    q = asset.pose({"lift_rod_slide": 0.028})["plug"][2, 3] - asset.pose({})["plug"][2, 3]
    assert q == pytest.approx(-0.0065, abs=3e-4)
    assert asset.clearance({"lift_rod_slide": 0.028})["sink", "plug"] > 0.0001


@pytest.mark.parametrize("style", ["inset", "undermount", "apron", "vessel"])
def test_two_doors_close_the_cabinet_below_the_bowl(style: str) -> None:
    asset = made(5, style=style, stand="cabinet", bowls="single", doors=2)
    closed = asset.clearance({})
    for side in ("left", "right"):
        assert 0.001 < closed["sink", f"door_{side}"] < 0.004
        hinge = asset.joint(f"door_hinge_{side}")
        assert hinge.limits == pytest.approx((0.0, asset.parameters["swing"]))
        tip = asset.pose({hinge.name: 1.5})[f"door_{side}"] @ np.append(
            asset.link(f"door_{side}").bounds().mean(0), 1
        )
        assert tip[1] < asset.link("sink").bounds()[0, 1], "an open door stands in front of the cabinet"
    assert made(5, style=style, stand="cabinet", bowls="single", doors=0).certificate.proven
    with pytest.raises(InfeasibleError, match="doors are for stand=cabinet"):
        made(5, style=style, stand="legs", doors=2)


@pytest.mark.parametrize(("style", "width", "depth", "mass"), [
    ("undermount", (0.5, 1.1), (0.5, 0.65), (35.0, 110.0)),
    ("hung", (0.79, 0.81), (0.5, 0.7), (75.0, 125.0)),
    ("vessel", (0.55, 0.9), (0.45, 0.65), (20.0, 110.0)),
])  # fmt: skip
def test_sizes_and_masses_are_those_of_shops(
    style: str, width: tuple[float, float], depth: tuple[float, float], mass: tuple[float, float]
) -> None:
    asset = made(4, style=style)
    low, high = asset.bounds()
    assert low[2] == pytest.approx(0.0, abs=1e-6)
    assert width[0] < high[0] - low[0] < width[1]
    assert depth[0] < high[1] - low[1] < depth[1]
    assert mass[0] < asset.mass < mass[1]


def test_nothing_is_open_between_a_bowl_and_its_rim_at_low_detail() -> None:
    given: dict[str, Any] = {"style": "inset", "bowls": "single", "stand": "none", "drainer": "none"}
    asset = made(1, **given, detail="low")
    solids = [each for each in asset.links[0].colliders if each.label == "bowl"]
    rim = max(each.convex.bounds()[1, 2] for each in solids) - 0.0008
    half, deep = asset.parameters["width"] / 2, asset.parameters["deep"] / 2
    for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        corner = np.array([0.98 * x * half, -0.045 - deep + 0.98 * y * deep, rim])
        planes = [each.convex.faces.planes for each in solids]
        assert any((each[:, :3] @ corner <= each[:, 3]).all() for each in planes)
