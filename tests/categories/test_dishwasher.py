"""What is special to a dishwasher: racks behind the door, the sprung flap, the balanced door, its sizes."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError, ParameterError
from artgen.feel import GRAVITY
from artgen.validate.colliders import check_colliders


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("dishwasher").generate(seed, certify=False, **given)


def weight_torque(asset: Asset, angle: float) -> float:
    """Return the torque by which gravity opens the door at an angle [N m]."""
    hinge = asset.joint("door_hinge")
    turning = [
        link
        for link in asset.links
        if link.name == "door" or link.name.startswith(("button", "knob", "deter"))
    ]
    torque = 0.0
    for link in turning:
        mass = link.mass_properties
        y, z = (mass.center - hinge.pivot)[1:]
        torque += GRAVITY * mass.mass * (z * math.sin(angle) - y * math.cos(angle))
    return torque


@pytest.mark.parametrize("seed", [0, 5, 9])
def test_racks_roll_out_only_over_the_open_door(seed: int) -> None:
    asset = made(seed)
    opened = asset.joint("door_hinge").limits[1]  # type: ignore[index]
    racks = [joint for joint in asset.joints if joint.name.startswith("rack_slide")]
    assert len(racks) == asset.parameters["racks"]
    for joint in racks:
        assert joint.limits is not None
        out = joint.limits[1]
        assert asset.blocked({joint.name: out}) == (joint.name,)
        assert asset.blocked({joint.name: out, "door_hinge": opened}) == ()
        assert asset.blocked({joint.name: 0.004}) == (), "the play up to the closed door is free"
    assert asset.blocked({"door_hinge": 1.2, "rack_slide_0": 0.3}) == ("rack_slide_0",)


def test_the_higher_a_rack_the_sooner_it_comes_out() -> None:
    asset = made(5)
    angles = [asset.joint(f"rack_slide_{number}").needs.condition.value for number in range(3)]  # type: ignore[union-attr]
    assert angles[0] > angles[1] > angles[2]
    assert angles[0] > 1.4, "the lower rack rolls over the door when it is all but level"


@pytest.mark.parametrize("seed", [0, 5])
def test_the_lower_rack_clears_the_open_door_by_two_to_three_millimetres(seed: int) -> None:
    asset = made(seed)
    hinge, slide = asset.joint("door_hinge"), asset.joint("rack_slide_0")
    assert hinge.limits is not None
    assert slide.limits is not None
    apart = asset.clearance({"door_hinge": hinge.limits[1], "rack_slide_0": slide.limits[1]})
    found = apart.get(("door", "rack_0"), apart.get(("rack_0", "door")))
    assert found is not None
    assert 0.002 <= found <= 0.005


def test_behind_the_closed_door_a_rack_would_strike_it() -> None:
    asset = made(5)
    apart = asset.clearance({"rack_slide_1": 0.2})
    found = apart.get(("door", "rack_1"), apart.get(("rack_1", "door")))
    assert found is not None
    assert found < 0.0


@pytest.mark.parametrize("seed", [0, 3, 5, 9])
def test_springs_carry_the_door_and_friction_holds_the_rest(seed: int) -> None:
    asset = made(seed)
    hinge = asset.joint("door_hinge")
    assert hinge.limits is not None
    for angle in np.linspace(0.0, hinge.limits[1], 12):
        left = weight_torque(asset, angle) - hinge.stiffness * angle
        assert abs(left) < hinge.friction, f"the door would move by itself at {angle:.2f} rad"
    mass = asset.link("door").mass_properties.mass
    assert 3.8 <= mass <= 7.4


@pytest.mark.parametrize("seed", [0, 3, 5, 9])
def test_a_hand_opens_the_door_by_fifteen_to_forty_newtons(seed: int) -> None:
    asset = made(seed)
    hinge = asset.joint("door_hinge")
    grasp = next(grasp for grasp in asset.link("door").grasps if grasp.name.startswith("handle"))
    lever = float(np.linalg.norm(grasp.frame[1:3, 3] - hinge.pivot[1:]))
    torque = max(
        hinge.friction + hinge.stiffness * angle - weight_torque(asset, angle)
        for angle in np.linspace(0.0, 1.5, 16)
    )
    assert 15.0 <= torque / lever <= 40.0


def test_the_flap_is_sprung_and_waits_for_the_open_door() -> None:
    flap = made(0).joint("detergent_flap_slide")
    assert flap.stiffness > 0.0
    assert flap.rest < 0.0, "its spring holds it shut"
    assert made(0).blocked({"detergent_flap_slide": 0.03}) == ("detergent_flap_slide",)
    assert made(0).blocked({"detergent_flap_slide": 0.03, "door_hinge": 1.4}) == ()


def test_spray_arms_spin_without_end_and_by_water() -> None:
    asset = made(5)
    arms = [joint for joint in asset.joints if joint.name.startswith("spray_arm")]
    assert [joint.limits for joint in arms] == [None, None]
    assert {joint.driven for joint in arms} == {"water"}
    assert asset.joint("spray_arm_spin_1").parent == "rack_1"


@pytest.mark.parametrize(
    ("size", "wide", "kilograms"),
    [("full", (0.59, 0.605), (35.0, 55.5)), ("slim", (0.44, 0.455), (30.0, 45.0))],
)
def test_sizes_and_mass_by_width(
    size: str, wide: tuple[float, float], kilograms: tuple[float, float]
) -> None:
    for seed in range(3):
        asset = made(seed, size=size)
        low, high = asset.bounds()
        assert wide[0] <= high[0] - low[0] <= wide[1]
        assert 0.56 <= high[1] - low[1] <= 0.63
        assert 0.82 <= high[2] - low[2] <= 0.88
        assert kilograms[0] <= asset.mass <= kilograms[1]


def test_slim_racks_have_fewer_wires() -> None:
    full, slim = made(1, size="full", racks=2), made(1, size="slim", racks=2)
    assert len(slim.link("rack_1").colliders) <= len(full.link("rack_1").colliders)


@pytest.mark.parametrize("buttons", [0, 3])
def test_as_many_buttons_as_asked_for(buttons: int) -> None:
    asset = made(2, buttons=buttons)
    found = [link for link in asset.links if link.label == "button"]
    assert len(found) == buttons


@pytest.mark.parametrize(
    "given",
    [
        {"handle": "pocket", "build": "freestanding"},
        {"controls": "top", "build": "freestanding"},
        {"controls": "top", "dial": "fluted"},
        {"handle": "recessed", "size": "slim", "buttons": 8},
        {"look": "panel", "controls": "front"},
    ],
)
def test_styles_go_together_however_they_are_set(given: dict[str, Any]) -> None:
    asset = find("dishwasher").generate(4, on_collision="fail", **given)
    assert asset.certificate is not None
    assert asset.certificate.proven


def test_a_wrong_style_is_refused_with_the_allowed_ones() -> None:
    with pytest.raises(ParameterError, match=r"bar.*pocket.*recessed"):
        made(0, handle="knob")


def test_colliders_of_racks_are_close_at_medium_detail() -> None:
    assert not check_colliders(made(0, detail="medium")).findings


def test_a_dishwasher_with_a_bar_needs_depth() -> None:
    assert find("dishwasher").generate(1, handle="bar", depth=0.58, travel=0.92).certificate.proven
    with pytest.raises(InfeasibleError, match=r"a bar stands out: depth must be >= 0\.58 m"):
        find("dishwasher").generate(1, handle="bar", depth=0.57)
