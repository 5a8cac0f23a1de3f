"""What hands can do: the joints that they move, and the gripper that grasps are made for."""

import json
from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen import Body, Prismatic, Revolute, X, Y, Z, box, frame, grasp_on, material, part, push_on
from artgen.asset import Asset
from artgen.asset.affordance import GRIPPER, Grasp, Push, affordance_data, block, held

STEEL = material("steel")


@artgen.generator
def press() -> Body:
    """A pedal that a foot presses, a lid that follows it, a knob on the lid, and a slide that is locked."""
    pedal = Revolute("pedal", axis=X, limits=(0, 0.5))
    lid = Revolute("lid", axis=X, pivot=(0, 0.2, 0.5), follows=2.0 * pedal)
    turn = Revolute("turn", axis=Z, pivot=(0, 0, 0.53))
    locked = Prismatic("locked", axis=Z, limits=(0, 0))
    body = part(box(0.3, 0.3, 0.4).at(z=0.25), "body", STEEL)
    foot = box(0.1, 0.1, 0.01).at(0, -0.25, 0.02)
    knob = box(0.02, 0.02, 0.04).at(0, 0, 0.54)
    cover = part(box(0.3, 0.3, 0.01).at(z=0.5), "lid", STEEL)
    button = part(knob, "knob", STEEL, grasp=grasp_on(knob, approach=-Z, closing=X, depth=0.03))
    cover = cover.attach(button, turn, locked)
    treadle = part(foot, "pedal", STEEL, push=push_on(foot, direction=-Z))
    return body.attach(treadle, pedal).attach(cover, lid)


@pytest.fixture(scope="module")
def made() -> Asset:
    return press.generate(certify=False)


def test_a_hand_moves_leaders_and_free_joints_the_nearest_first(made: Asset) -> None:
    moved = {each.name: each.joints for each in made.affordances}
    assert moved == {"pedal_push_point": ("pedal",), "knob_grasp": ("turn", "pedal")}


def test_the_record_has_the_motion_of_the_nearest_joint(made: Asset) -> None:
    data = {each["name"]: each for each in json.loads(made.to_json())["affordances"]}
    assert data["knob_grasp"]["kind"] == "grasp"
    assert data["knob_grasp"]["width"] == pytest.approx(0.03)
    assert data["knob_grasp"]["motion"] == {
        "joint": "turn",
        "kind": "revolute",
        "axis": [0.0, 0.0, 1.0],
        "pivot": [0.0, 0.0, 0.53],
        "limits": None,
    }
    push = data["pedal_push_point"]
    assert (push["kind"], push["width"], push["motion"]["limits"]) == ("push", 0.0, [0.0, 0.5])
    np.testing.assert_allclose(np.array(push["frame"])[:3, 3], [0.0, -0.25, 0.025], atol=1e-9)


def test_a_hand_that_moves_nothing_has_no_motion(made: Asset) -> None:
    base = replace(made.links[0], grasps=(Grasp("edge", np.eye(4), 0.05),))
    found = replace(made, links=(base, *made.links[1:])).affordances[0]
    assert (found.name, found.joints) == ("edge", ())
    assert affordance_data(found, made)["motion"] is None


@pytest.mark.parametrize("kind", [Grasp("it", np.eye(4), 0.05), Push("it", np.eye(4))])
def test_a_mirrored_frame_keeps_its_approach_and_stays_a_rotation(kind: Grasp | Push) -> None:
    matrix = np.diag([-1.0, 1.0, 1.0, 1.0])
    moved = kind.moved(matrix).frame
    assert np.linalg.det(moved[:3, :3]) == pytest.approx(1.0)
    np.testing.assert_allclose(moved[:3, 2], [0.0, 0.0, 1.0])
    np.testing.assert_allclose(np.abs(moved[:3, 0]), [1.0, 0.0, 0.0])


@pytest.mark.parametrize(
    ("thickness", "opening"),
    [(0.020, 0.030), (0.02000005, 0.030), (0.02001, 0.0301), (0.075, 0.080), (0.080, 0.080), (0.1, 0.110)],
)
def test_the_opening_is_what_is_held_and_5_mm_at_each_side_up_to_the_stroke_if_it_fits(
    thickness: float, opening: float
) -> None:
    assert GRIPPER.opening(thickness) == pytest.approx(opening, abs=1e-12)


def test_the_hand_is_three_boxes_behind_the_tips_with_the_pads_inside() -> None:
    boxes = GRIPPER.blocks(-0.01, 0.02, 0.1)
    assert boxes["finger"][0, 0] == pytest.approx(0.02)
    assert boxes["other finger"][1, 0] == pytest.approx(-0.01)
    assert {round(float(boxes[name][1, 2]), 6) for name in ("finger", "other finger")} == {0.009}
    assert boxes["hand"][1, 2] == pytest.approx(0.009 - 0.054)
    assert boxes["hand"][0, 2] == pytest.approx(0.009 - 0.054 - 0.066 - 0.1)


def test_what_is_held_is_measured_between_the_fingers_only() -> None:
    pose = np.eye(4)
    solid = block(np.array([[-0.005, -0.1, -0.02], [0.007, 0.1, 0.0]]), pose)
    far = block(np.array([[-0.03, 0.05, -0.02], [0.03, 0.1, 0.0]]), pose)
    assert held([solid, far], pose) == pytest.approx((-0.005, 0.007))
    away = pose.copy()
    away[2, 3] = 0.3
    assert held([solid, far], away) is None


def test_frames_stay_with_their_product_when_it_is_turned(made: Asset) -> None:
    grip = box(0.02, 0.02, 0.2)
    turned = part(grip, "bar", STEEL, grasp=grasp_on(grip, approach=Y, closing=X)).rotate(Z, np.pi / 2)
    written = part(grip, "bar", STEEL, grasp=frame((0, 0, 0), approach=-X, closing=Y))
    frames = [
        artgen.Graph(body).evaluate({}, artgen.graph.Cache()).value.link.grasps[0].frame
        for body in (turned, written)
    ]
    np.testing.assert_allclose(frames[0], frames[1], atol=1e-12)
