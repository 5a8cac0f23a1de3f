"""What is special to a clock: what its hands show, knobs that set them, doors, pendulums, keys."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=32)
def made(seed: int, **given: Any) -> Asset:
    return find("clock").generate(seed, certify=False, **given)


def pointing(asset: Asset, hand: str, **q: float) -> float:
    """Return the angle of a hand, clockwise from the top and seen from the front [turns]."""
    link = asset.link(hand)
    reach = max((piece.shape.bounds()[1] - piece.shape.bounds()[0]).max() for piece in link.pieces)
    vertices = np.concatenate([surface.mesh.vertices for surface in link.surfaces])
    joint = next(joint for joint in asset.joints if joint.child == hand)
    pose = asset.pose(q)[hand]
    spread = (vertices - joint.pivot)[:, [0, 2]]
    tip = vertices[np.linalg.norm(spread, axis=1).argmax()]
    assert np.linalg.norm(spread, axis=1).max() > 0.6 * reach
    x, _, z = pose[:3, :3] @ (tip - joint.pivot)
    return float(round(math.atan2(x, z) / math.tau, 9) % 1.0)


@pytest.mark.parametrize(
    ("style", "time"), [("wall", 3.125), ("mantel", 10.25), ("longcase", 7.5), ("bells", 1.75)]
)
def test_hands_show_the_time(style: str, time: float) -> None:
    asset = made(1, style=style, time=time)
    assert pointing(asset, "hour_hand") == pytest.approx(time / 12, abs=0.01)
    assert pointing(asset, "minute_hand") == pytest.approx(time % 1.0, abs=0.01)


@pytest.mark.parametrize(("style", "lead"), [("wall", "minute_turn"), ("bells", "set_turn")])
def test_an_hour_later_the_hour_hand_is_a_twelfth_further(style: str, lead: str) -> None:
    asset = made(2, style=style, time=4.0)
    later = {lead: math.tau * 1.5}
    assert pointing(asset, "hour_hand", **later) == pytest.approx(5.5 / 12, abs=0.01)
    assert pointing(asset, "minute_hand", **later) == pytest.approx(0.5, abs=0.01)


def test_a_knob_turns_the_hand_of_the_alarm_alone() -> None:
    asset = made(3, style="bells")
    before = [pointing(asset, hand) for hand in ("alarm_hand", "hour_hand")]
    after = [pointing(asset, hand, alarm_turn=math.pi / 2) for hand in ("alarm_hand", "hour_hand")]
    assert (after[0] - before[0]) % 1.0 == pytest.approx(0.25, abs=0.01)
    assert after[1] == pytest.approx(before[1], abs=1e-6)


@pytest.mark.parametrize("style", ["mantel", "regulator", "longcase"])
def test_a_pendulum_swings_from_side_to_side_through_its_middle(style: str) -> None:
    asset = made(4, style=style)
    _, high = asset.joint("pendulum_swing").limits or (0.0, 0.0)
    angles = [released(asset, "pendulum_swing", 0.8 * high, seconds=0.1 * step) for step in range(1, 25)]
    assert min(angles) < -0.5 * high
    assert max(angles) > 0.5 * high


def test_doors_stay_where_they_are_left() -> None:
    asset = made(5, style="longcase")
    for joint in ("trunk_door_hinge", "hood_door_hinge"):
        for angle in (0.4, 1.2):
            assert released(asset, joint, angle) == pytest.approx(angle, abs=0.02)


def test_the_keys_of_a_digital_clock_spring_back() -> None:
    asset = made(6, style="digital", keys=3)
    joints = ["snooze_slide", *(f"button_slide_{number}" for number in range(3))]
    assert [released(asset, joint, 0.0015) for joint in joints] == pytest.approx([0.0] * 4, abs=2e-4)
