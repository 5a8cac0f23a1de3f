"""What is special to a chair: what rises, tilts back and folds, what follows, sizes and masses."""

import math
from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find


@lru_cache(maxsize=8)
def made(seed: int, **given: Any) -> Asset:
    return find("chair").generate(seed, on_collision="fail", **given)


def test_a_seat_stays_at_its_height_and_turns_without_end() -> None:
    asset = made(1, style="bar")
    lift = asset.joint("seat_lift")
    carried = asset.link("seat").mass_properties.mass + asset.link("lever").mass_properties.mass
    assert lift.friction > 9.81 * carried, "the gas spring is locked"
    assert asset.joint("seat_swivel").limits is None


def test_rear_legs_follow_the_seat_until_they_lie_beside_the_front_ones() -> None:
    asset = made(2, style="folding")
    _, high = asset.joint("seat_fold").limits or (0.0, 0.0)
    follower = asset.joint("legs_fold").follows
    assert follower is not None
    assert follower.leader == "seat_fold"
    assert follower.ratio * high == pytest.approx(1.05, abs=1e-6)
    depths = []
    for turn in (0.0, high):
        pose = asset.pose({"seat_fold": turn})["legs"]
        foot = pose[:3, :3] @ (0.0, 0.235, 0.012) + pose[:3, 3]
        depths.append(foot[1])
    assert depths[0] > 0.2, "behind the seat"
    assert depths[1] < -0.15, "between the front legs"


def test_a_footrest_rises_with_the_reclined_back() -> None:
    asset = made(3, style="recliner")
    _, tilt = asset.joint("back_tilt").limits or (0.0, 0.0)
    follower = asset.joint("footrest_turn").follows
    assert follower is not None
    assert math.radians(55) < follower.ratio * tilt < math.radians(85)


def test_casters_of_an_office_chair_stand_on_the_floor() -> None:
    asset = made(4, style="office")
    wheels = [link for link in asset.links if link.name.startswith("caster_wheel")]
    assert len(wheels) == 5
    for wheel in wheels:
        assert wheel.bounds()[0, 2] == pytest.approx(0.0, abs=1e-4)
    assert 10.0 < asset.mass < 20.0
