"""What is special to a microwave oven: its latch, the door that springs open, the turntable."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("microwave").generate(seed, certify=False, **given)


def between(asset: Asset, q: dict[str, float], first: str, second: str) -> float:
    apart = asset.clearance(q)
    return apart.get((first, second), apart.get((second, first), math.inf))


@pytest.mark.parametrize("seed", [0, 3, 7])
def test_the_door_opens_only_while_the_button_is_pressed(seed: int) -> None:
    asset = made(seed, handle="none")
    pressed = asset.joint("button_slide").limits[1]  # type: ignore[index]
    hinge = asset.joint("door_hinge")
    assert hinge.needs is not None
    assert hinge.needs.until is not None
    at_pawls = 0.5 * hinge.needs.until
    assert asset.blocked({"door_hinge": at_pawls}) == ("door_hinge",)
    assert asset.blocked({"door_hinge": at_pawls, "button_slide": 0.5 * pressed}) == ("door_hinge",)
    assert asset.blocked({"door_hinge": at_pawls, "button_slide": pressed}) == ()
    assert asset.blocked({"door_hinge": 1.0}) == (), "open, it is free of the button"


@pytest.mark.long
def test_the_pawls_stand_in_the_way_of_the_hooks_until_they_are_lifted() -> None:
    asset = made(3, handle="none")
    pressed = asset.joint("button_slide").limits[1]  # type: ignore[index]
    assert 0.0002 < between(asset, {}, "door", "latch") < 0.001
    assert between(asset, {"door_hinge": 0.01}, "door", "latch") < 0.0, "a barb strikes its pawl"
    for angle in np.linspace(0.0, 0.06, 7):
        assert between(asset, {"door_hinge": angle, "button_slide": pressed}, "door", "latch") > 0.0003


def test_the_latch_rises_with_the_button() -> None:
    asset = made(3, handle="none")
    slide = asset.joint("latch_slide")
    assert slide.follows is not None
    assert slide.follows.leader == "button_slide"
    np.testing.assert_allclose(slide.axis, (0.0, 0.0, 1.0))
    assert 0.004 < slide.follows.ratio * 0.0045 < 0.007


def test_a_spring_throws_the_door_open_and_friction_holds_it_from_there() -> None:
    hinge = made(3, handle="none").joint("door_hinge")
    assert hinge.limits is not None

    def spring(angle: float) -> float:
        return hinge.stiffness * (hinge.rest - angle)

    assert spring(0.0) > 1.2 * hinge.friction
    starts = hinge.rest - hinge.friction / hinge.stiffness
    assert 0.2 < starts < 0.4
    for angle in np.linspace(starts, hinge.limits[1], 8):
        assert abs(spring(angle)) <= hinge.friction * 1.0001


@pytest.mark.parametrize("handle", ["bar", "pocket"])
def test_a_handle_needs_neither_button_nor_latch(handle: str) -> None:
    asset = made(2, handle=handle)
    assert {link.name for link in asset.links}.isdisjoint({"button", "latch"})
    hinge = asset.joint("door_hinge")
    assert hinge.needs is None
    assert hinge.stiffness == 0.0
    grasp = next(each for each in asset.link("door").grasps if each.name.startswith("handle"))
    lever = np.linalg.norm((grasp.frame[:3, 3] - hinge.pivot)[:2])
    assert 9.0 <= hinge.friction / lever <= 25.0


@pytest.mark.parametrize("seed", [1, 4])
def test_the_door_hangs_at_its_left(seed: int) -> None:
    asset = made(seed, handle="bar")
    hinge = asset.joint("door_hinge")
    low, high = asset.link("door").bounds()
    assert hinge.pivot[0] - low[0] < 0.01
    moved = asset.pose({"door_hinge": 1.5})["door"] @ np.append(high, 1.0)
    assert moved[1] < low[1] - 0.1, "its free edge comes to the front"


@pytest.mark.parametrize("seed", [0, 5])
def test_the_ring_of_rollers_turns_half_as_fast_as_the_plate(seed: int) -> None:
    asset = made(seed)
    spin, ring = asset.joint("plate_spin"), asset.joint("ring_spin")
    assert spin.limits is None
    assert ring.follows is not None
    assert ring.follows.ratio == pytest.approx(0.5)
    for turn in (0.0, 1.0, 2.5):
        assert 0.0002 < between(asset, {"plate_spin": turn}, "plate", "roller_ring") < 0.001
    plate = asset.link("plate").bounds()
    assert 0.23 <= plate[1, 0] - plate[0, 0] <= 0.36


@pytest.mark.parametrize(
    ("controls", "keys", "dials"), [("keypad", 12, 0), ("keypad", 6, 0), ("mixed", 3, 1), ("dials", 0, 3)]
)
def test_as_many_keys_and_dials_as_asked_for(controls: str, keys: int, dials: int) -> None:
    asset = made(6, controls=controls, keys=keys, dials=dials)
    names = [link.name for link in asset.links]
    assert sum(name.startswith("key_") for name in names) == keys
    turned = [joint for joint in asset.joints if joint.name.startswith("dial_turn")]
    assert len(turned) == dials
    assert {joint.limits for joint in turned} <= {None}
    for joint in asset.joints:
        if joint.name.startswith("key_slide"):
            assert joint.limits is not None
            assert joint.limits[1] <= 0.0015
            assert joint.rest < 0.0


@pytest.mark.parametrize(
    "given",
    [
        {"width": 0.44, "height": 0.25, "depth": 0.33, "panel": 0.098, "keys": 12, "handle": "none"},
        {"width": 0.60, "height": 0.34, "depth": 0.45, "handle": "bar", "face": "banded"},
        {"height": 0.25, "controls": "dials", "dials": 3, "handle": "none", "face": "banded"},
        {"handle": "pocket", "width": 0.44, "panel": 0.128},
    ],
)
def test_the_ends_of_its_sizes_are_proven_free_of_collisions(given: dict[str, Any]) -> None:
    asset = find("microwave").generate(4, on_collision="fail", **given)
    assert asset.certificate is not None
    assert asset.certificate.proven
