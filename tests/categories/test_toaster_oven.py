"""What is special to a toaster oven: a door that stays, a rack over it, a basket that lifts out, clicks."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.validate.hands import check_grasps


@lru_cache(maxsize=2)
def made(seed: int, **given: Any) -> Asset:
    return find("toaster_oven").generate(seed, certify=False, **given)


def test_a_rack_slides_out_over_the_open_door_only() -> None:
    asset = made(0, style="oven")
    _, far = asset.joint("rack_slide").limits or (0.0, 0.0)
    assert far > 0.1
    assert asset.blocked({"rack_slide": far})
    out = {"rack_slide": far, "door_hinge": 1.46}
    assert not asset.blocked(out)
    assert asset.clearance(out)["door", "rack"] > 0.02


def test_a_spring_and_friction_hold_the_door_at_any_angle() -> None:
    asset = made(0, style="oven")
    hinge, door = asset.joint("door_hinge"), asset.links["door"].mass_properties
    _, y, z = door.center - hinge.pivot
    assert z > 0.05
    for angle in np.linspace(0.0, (hinge.limits or (0.0, 0.0))[1], 8):
        weight = 9.81 * door.mass * (z * np.sin(angle) - y * np.cos(angle))
        assert abs(weight - hinge.stiffness * (angle - hinge.rest)) < hinge.friction


def test_a_basket_lifts_out_of_a_drawer_that_is_out() -> None:
    asset = made(1, style="fryer")
    _, far = asset.joint("drawer_slide").limits or (0.0, 0.0)
    _, up = asset.joint("basket_lift").limits or (0.0, 0.0)
    assert asset.blocked({"drawer_slide": 0.1, "basket_lift": up})
    assert not asset.blocked({"drawer_slide": far, "basket_lift": up})
    assert asset.clearance({"drawer_slide": far, "basket_lift": up})["body", "basket"] > 0.01


def test_two_drawers_slide_past_each_other_and_each_has_a_basket() -> None:
    asset = made(2, style="dual")
    _, far = asset.joint("drawer_slide_left").limits or (0.0, 0.0)
    for side, other in (("left", "right"), ("right", "left")):
        assert asset.blocked({f"drawer_slide_{other}": far, f"basket_lift_{side}": 0.1})
        assert not asset.blocked({f"drawer_slide_{side}": far, f"basket_lift_{side}": 0.1})
    assert asset.clearance({"drawer_slide_left": far})["drawer_left", "drawer_right"] > 0.003


def test_the_front_of_a_round_air_fryer_follows_its_case() -> None:
    asset = made(3, style="fryer", form="round")
    colliders = [each.convex for each in asset.links["drawer"].colliders if each.label == "drawer"]
    front = np.vstack([each.points for each in colliders])
    ends = front[np.abs(front[:, 0]) > np.abs(front[:, 0]).max() - 0.01]
    assert ends[:, 1].min() > front[:, 1].min() + 0.02, "its ends bend back"
    assert asset.clearance({})["body", "drawer"] == pytest.approx(0.0012, abs=0.0004)


@pytest.mark.parametrize("given", [{"style": "fryer", "form": "round"}, {"style": "dual"}])
def test_a_hand_turns_each_dial_and_draws_each_drawer(given: dict[str, str]) -> None:
    found = check_grasps(made(4, **given))
    assert not found.faults, found.faults


@pytest.mark.parametrize(("style", "seed"), [("oven", 0), ("fryer", 1)])
def test_dials_click_at_off_and_at_each_position(style: str, seed: int) -> None:
    joint = made(seed, style=style).joint("dial_turn_0")
    assert joint.detents is not None
    assert joint.detents.positions[0] == 0.0
    assert 0.02 <= joint.detents.torque <= 0.05


def test_a_hand_turns_the_dial_beside_the_handle_of_the_door() -> None:
    asset = find("toaster_oven").generate(248, certify=False)
    found = check_grasps(asset)
    assert asset.parameters["dials"] == 4  # the first one is as high as the handle
    assert not found.faults, found.faults
