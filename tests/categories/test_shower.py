"""What is special to showers: magnets that draw doors shut, panels that fold, pass and follow, the way in."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released


@lru_cache(maxsize=24)
def made(seed: int, **given: Any) -> Asset:
    return find("shower").generate(seed, certify=False, **given)


def end_of(asset: Asset, name: str) -> float:
    limits = asset.joint(name).limits
    assert limits is not None
    return limits[1]


@pytest.mark.parametrize("style", ["hinged", "pivot"])
def test_magnets_draw_a_door_shut_and_friction_holds_it_open(style: str) -> None:
    asset = made(1, style=style)
    assert released(asset, "door_hinge", 0.015) == pytest.approx(0.0, abs=0.012)
    assert released(asset, "door_hinge", 0.8) == pytest.approx(0.8, abs=0.01)
    reach = np.ptp(asset.link("door").bounds()[:, 0]) - 0.1
    assert released(asset, "door_hinge", 0.0, pull=3.0 * reach) < 0.025, "3 N do not open it"
    assert released(asset, "door_hinge", 0.0, pull=25.0 * reach) > 0.3


def test_a_pivot_door_opens_to_both_sides_of_its_axis() -> None:
    asset = made(2, style="pivot")
    low, high = asset.link("door").bounds()
    pose = asset.pose({"door_hinge": 1.2})["door"]
    corners = [pose @ np.array([x, 0.5 * (low[1] + high[1]), low[2], 1.0]) for x in (low[0], high[0])]
    inside, outside = sorted((corner[1] for corner in corners), reverse=True)
    assert inside > high[1] + 0.05
    assert outside < low[1] - 0.4


def test_a_bifold_door_folds_within_its_niche_and_ends_on_the_rail() -> None:
    asset = made(3, style="bifold", hand="left")
    far = asset.link("door_1").bounds()
    guide = np.array([far[1, 0] - 0.012, asset.link("door_0").bounds()[:, 1].mean(), far[0, 2], 1.0])
    plane = [(asset.pose({"door_hinge": angle})["door_1"] @ guide) for angle in (0.0, 0.5, 0.9)]
    assert np.ptp([point[1] for point in plane]) < 0.012, "along the rail"
    assert plane[0][0] - plane[2][0] > 0.2
    assert asset.joint("fold_hinge").follows is not None


@pytest.mark.parametrize(
    ("panels", "least"), [("one", 0.38), ("both", 0.40), ("three", 0.55)], ids=["one", "both", "three"]
)
def test_sliding_doors_leave_a_way_in(panels: str, least: float) -> None:
    asset = made(4, style="sliding", panels=panels, width=1.3)
    name = "door_slide" if panels == "one" else "door_slide_0"
    assert least < end_of(asset, name) / 1.3 < least + 0.12
    if panels != "three":
        assert released(asset, name, 0.2) == pytest.approx(0.2, abs=0.003), "friction holds a door"
    else:
        follows = asset.positions({name: 0.6})["door_slide_1"]
        assert follows == pytest.approx(0.3)
        first, second = (asset.link(f"door_{number}").bounds() for number in (0, 1))
        moved = end_of(asset, name) * (1 if asset.joint(name).axis[0] > 0 else -1)
        assert first[:, 0].mean() + moved == pytest.approx(second[:, 0].mean() + moved / 2, abs=0.01)


@pytest.mark.parametrize("style", ["corner", "quadrant"])
def test_two_doors_part_at_the_corner(style: str) -> None:
    asset = made(5, style=style)
    name = "door_slide" if style == "corner" else "door_roll"
    shut = asset.clearance({})["door_0", "door_1"]
    ends = {f"{name}_{number}": end_of(asset, f"{name}_{number}") for number in (0, 1)}
    assert shut < 0.02
    assert asset.clearance(ends)["door_0", "door_1"] > 0.34


def test_both_leaves_of_a_screen_turn_over_the_rim_of_the_bath() -> None:
    asset = made(6, style="screen")
    rim = asset.link("bath").pieces[0].shape.bounds()[1, 2]
    for name in ("door_0", "door_1"):
        assert asset.link(name).bounds()[0, 2] > rim + 0.002
    folded = asset.clearance({"fold_hinge": end_of(asset, "fold_hinge")})["door_0", "door_1"]
    assert 0.0 < folded < 0.02
    assert end_of(asset, "fold_hinge") > 2.9


@pytest.mark.parametrize("thickness", ["six", "eight"])
@pytest.mark.parametrize("style", ["pivot", "sliding", "bifold", "corner"])
def test_a_door_weighs_as_its_glass_and_profiles(style: str, thickness: str) -> None:
    asset = made(7, style=style, thickness=thickness)
    door = next(link for link in asset.links if link.name.startswith("door"))
    wide, _, tall = np.ptp(door.bounds(), axis=0)
    wide = max(wide, np.ptp(door.bounds(), axis=0)[1])
    glass = 2500.0 * (0.006 if thickness == "six" else 0.008)
    assert 0.9 * glass < door.mass / (wide * tall) < 1.35 * glass


def test_a_niche_narrower_than_its_doors_is_refused() -> None:
    with pytest.raises(InfeasibleError, match="width of a sliding shower must be >= 1 m"):
        find("shower").generate(0, style="sliding", width=0.9)
