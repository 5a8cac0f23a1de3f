"""Hands come where hands would come: what is pulled, pushed, turned and pressed on doors and handles."""

from itertools import product

import numpy as np
import pytest

import artgen
from artgen.asset import Asset
from artgen.validate.hands import check_grasps

LEAVES = ("flush_leaf", "panel_leaf", "louver_leaf", "plank_leaf", "glazed_leaf", "half_lite_leaf")
OPENERS = ("lever", "knob", "push_bar", "pull", "none")


def door(**fixed: object) -> Asset:
    return artgen.generate("door", 4, certify=False, **fixed)


def holds(asset: Asset) -> dict[str, tuple[str, ...]]:
    return {each.name: each.joints for each in asset.affordances}


@pytest.mark.parametrize(("number", "opener"), list(enumerate(OPENERS)))
@pytest.mark.parametrize("layout", ["single", "double"])
def test_every_door_is_opened_by_hands(number: int, opener: str, layout: str) -> None:
    opens = ("towards", "away")[number % 2]
    asset = door(leaf=LEAVES[number], opener=opener, layout=layout, opens=opens, hand="right")
    assert not check_grasps(asset).faults
    moved = {name for joints in holds(asset).values() for name in joints}
    assert moved == {joint.name for joint in asset.free_joints}


@pytest.mark.parametrize("opens", ["towards", "away"])
def test_a_leaf_is_pushed_on_the_face_from_which_it_opens_away(opens: str) -> None:
    asset = door(opens=opens, layout="single")
    push = next(each for each in asset.affordances if each.name == "door_push_point")
    assert push.joints == ("door_hinge",)
    np.testing.assert_allclose(push.frame[:3, 2], [0, -1 if opens == "towards" else 1, 0], atol=1e-9)
    hinge = asset.joint("door_hinge")
    lever = np.cross(hinge.axis, push.frame[:3, 3] - hinge.pivot)
    assert lever @ push.frame[:3, 2] > 0.7 * asset.parameters["width"]  # far from the hinges, the right way


@pytest.mark.parametrize(
    ("opener", "names"),
    [
        ("lever", {"handle_grasp_0", "handle_grasp_1", "lock_grasp", "door_push_point"}),
        ("push_bar", {"handle_push_point", "handle_front_grasp", "door_push_point"}),
        ("pull", {"handle_front_grasp", "handle_back_push_point", "lock_grasp", "door_push_point"}),
        ("none", {"door_push_point"}),
    ],
)
def test_what_hands_do_is_what_the_hardware_is_for(opener: str, names: set[str]) -> None:
    bolted = opener in ("lever", "pull")
    assert set(holds(door(opener=opener, bolted=bolted, layout="single"))) == names


LEVERS = list(product(("straight", "bent", "wave"), ("turn", "push"), ("round", "plate")))


@pytest.mark.parametrize(("style", "lock", "rose"), LEVERS)
def test_a_hand_reaches_the_lock_below_the_thickest_lever(style: str, lock: str, rose: str) -> None:
    sizes = {
        "handle.style": style,
        "handle.girth": 0.0105,
        "handle.projection": 0.046,
        "handle.length": 0.115,
    }
    asset = artgen.generate("handle", 1, certify=False, kind="lever", lock=lock, rose_style=rose, **sizes)
    result = check_grasps(asset)
    assert not result.faults, "\n".join(map(str, result.faults))
    assert ("lock_grasp" if lock == "turn" else "lock_push_point") in holds(asset)


@pytest.mark.parametrize("style", ["ball", "flat", "tulip", "egg"])
@pytest.mark.parametrize("radius", [0.025, 0.0285])
def test_a_gripper_goes_around_a_knob(style: str, radius: float) -> None:
    sizes = {"handle.style": style, "handle.radius": radius}
    asset = artgen.generate("handle", 2, certify=False, kind="knob", lock="turn", **sizes)
    assert not check_grasps(asset).faults
    widths = {grasp.width for grasp in asset.link("handle").grasps}
    round_one = 2 * radius + 0.010
    assert max(widths) == pytest.approx(0.85 * 2 * radius + 0.010 if style == "egg" else round_one, abs=0.005)


def test_a_thumb_piece_is_pressed_and_its_grip_held() -> None:
    asset = artgen.generate("handle", 5, certify=False, kind="grip_set", inside="lever")
    found = holds(asset)
    assert found["thumb_latch_push_point"] == ("handle_turn",)
    assert found["grip_grasp"] == ()  # it is fixed
