"""Frames found on solids: where fingers close, how deep they come, where one pushes, how far they open."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen import (
    Prismatic,
    Spring,
    X,
    Y,
    Z,
    box,
    cylinder,
    dome,
    grasp_on,
    material,
    part,
    push_on,
    sphere,
    torus,
)
from artgen.asset import Asset, Tree
from artgen.asset.affordance import GRIPPER
from artgen.errors import EvaluationError
from artgen.graph import evaluate
from artgen.validate.hands import check_grasps

STEEL = material("steel")


def frame_of(handle) -> np.ndarray:
    return np.asarray(evaluate(handle).value)


def link_of(body):
    tree = evaluate(body).value
    assert isinstance(tree, Tree)
    return tree.link


def test_a_bar_is_held_in_its_middle():
    pose = frame_of(grasp_on(cylinder(0.01, 0.3, axis=X).at(0.1, -0.2, 0.7)))
    np.testing.assert_allclose(pose[:3, 3], [0.1, -0.2, 0.7], atol=1e-4)
    np.testing.assert_allclose(pose[:3, 2], [0, 1, 0], atol=1e-12)
    np.testing.assert_allclose(pose[:3, 0], [0, 0, 1], atol=1e-12)


def test_it_is_held_at_a_given_point_and_centered_there():
    bar = cylinder(0.01, 0.3, axis=X).rotate(Y, 0.1)
    pose = frame_of(grasp_on(bar, at=(0.1, 0, 0)))
    assert pose[0, 3] == pytest.approx(0.1, abs=1e-6)
    assert pose[2, 3] == pytest.approx(-0.1 * np.tan(0.1), abs=2e-4)


@given(out=st.floats(0.005, 0.025), deep=st.floats(0.003, 0.03))
def test_tips_come_as_deep_as_asked(out, deep):
    knob = cylinder(0.02, out, axis=Y)
    pose = frame_of(grasp_on(knob, closing=X, depth=deep))
    assert pose[1, 3] + GRIPPER.tip == pytest.approx(-out / 2 + deep, abs=1e-5)


def test_tips_come_9_mm_past_the_middle_and_at_most_30_mm_into_a_deep_thing():
    thin, deep = box(0.05, 0.02, 0.03), box(0.05, 0.4, 0.03)
    assert frame_of(grasp_on(thin))[1, 3] == pytest.approx(0.0, abs=1e-6)
    assert frame_of(grasp_on(deep))[1, 3] + GRIPPER.tip == pytest.approx(-0.2 + 0.030, abs=1e-6)


def test_a_push_is_on_the_first_surface_that_its_finger_meets():
    button = cylinder(0.01, 0.02, axis=Y)
    np.testing.assert_allclose(frame_of(push_on(button))[:3, 3], [0, -0.01, 0], atol=1e-6)
    np.testing.assert_allclose(frame_of(push_on(button, direction=-Y))[:3, 2], [0, -1, 0], atol=1e-12)
    cap = dome(0.03, height=0.01)
    assert frame_of(push_on(cap, direction=-Z))[2, 3] == pytest.approx(cap_top(cap), abs=1e-4)


def cap_top(solid) -> float:
    return float(evaluate(solid).value.bounds()[1, 2])


@pytest.mark.parametrize("make", [grasp_on, push_on])
def test_a_point_beside_the_solid_is_refused(make):
    with pytest.raises(
        EvaluationError, match=r"no part of the solid at \(1, 0, 0\) m; give another point: at="
    ):
        frame_of(make(sphere(0.02), at=(1, 0, 0)))


def test_fingers_that_do_not_reach_are_refused():
    with pytest.raises(EvaluationError, match=r"reach -5 mm deep touch nothing; make depth= larger"):
        frame_of(grasp_on(sphere(0.02), depth=-0.005))


@pytest.mark.parametrize("closing", [Y, -2 * Y, 0 * X])
def test_fingers_that_would_close_along_the_approach_are_refused(closing):
    with pytest.raises(EvaluationError, match=r"closing \(.*\) must lie across the approach \(0, 1, 0\)"):
        frame_of(grasp_on(sphere(0.02), closing=closing))


@given(radius=st.floats(0.004, 0.040))
def test_the_opening_is_measured_unless_it_is_given(radius):
    bar = cylinder(radius, 0.3, axis=X)
    (grasp,) = link_of(part(bar, "bar", STEEL, grasp=grasp_on(bar))).grasps
    assert grasp.width <= GRIPPER.stroke
    if radius < 0.034:
        assert 1.98 * radius + 0.0098 <= grasp.width <= 2 * radius + 0.0108
    (given_,) = link_of(part(bar, "bar", STEEL, grasp=grasp_on(bar), grasp_width=0.07)).grasps
    assert given_.width == 0.07


def test_around_a_thing_too_thick_the_opening_is_more_than_a_gripper_has():
    block = box(0.3, 0.05, 0.1)
    (grasp,) = link_of(part(block, "block", STEEL, grasp=grasp_on(block))).grasps
    assert grasp.width == pytest.approx(0.11)


def test_grasps_of_one_part_have_their_own_openings():
    stick = box(0.4, 0.02, 0.02) | box(0.1, 0.05, 0.05).at(0.2, 0, 0)
    holds = [grasp_on(stick, at=(-0.1, 0, 0)), grasp_on(stick, at=(0.2, 0, 0))]
    first, second = link_of(part(stick, "stick", STEEL, grasp=holds)).grasps
    assert (first.width, second.width) == pytest.approx((0.03, 0.06))


def test_a_push_point_is_named_after_its_part():
    button = box(0.02, 0.01, 0.02)
    link = link_of(part(button, "button", STEEL, push=[push_on(button), push_on(button, direction=-Y)]))
    assert [push.name for push in link.pushes] == ["button_push_point_0", "button_push_point_1"]


@pytest.mark.parametrize("radius", [0.05, 0.2])
def test_a_ring_has_nothing_at_its_middle(radius):
    ring = torus(radius, 0.006, axis=Y)
    message = r"there is nothing at the middle of the solid, \(.*\) m; give a point on it: at="
    with pytest.raises(EvaluationError, match=message):
        evaluate(grasp_on(ring, approach=Y, closing=Z))
    pose = evaluate(grasp_on(ring, approach=-Z, closing=Y, at=(0, 0, radius))).value
    np.testing.assert_allclose(pose[:2, 3], 0, atol=1e-6)


def test_a_push_on_a_hollow_stops_at_its_rim():
    cap = cylinder(0.012, 0.006) - sphere(0.016).at(z=0.016)
    pose = evaluate(push_on(cap, direction=-Z)).value
    assert pose[2, 3] == pytest.approx(0.016 - np.sqrt(0.016**2 - 0.009**2), abs=3e-4)
    key = part(cap, "key", material("abs"), push=push_on(cap, direction=-Z))
    press = Prismatic("press", axis=-Z, limits=(0, 0.002), spring=Spring(preload=0.3, force=1.0))
    base = part(box(0.1, 0.1, 0.01).at(z=-0.02), "base", material("oak"))
    assert not check_grasps(Asset.from_tree(evaluate(base.attach(key, press)).value, "pad", "pad")).faults


def test_a_push_on_a_shallow_hollow_stays_on_its_surface():
    cap = cylinder(0.012, 0.006) - sphere(0.06).at(z=0.0625)
    assert evaluate(push_on(cap, direction=-Z)).value[2, 3] == pytest.approx(0.0026, abs=2e-4)
