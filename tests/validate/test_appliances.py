"""Appliances whose inner parts need their door open: certificate, hands, forces and behavior of mocks."""

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen import Body, Prismatic, Revolute, X, Y, Z, box, grasp_on, material, part, push_on
from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.asset.report import Finding
from artgen.proof.certify import certify
from artgen.proof.recheck import recheck
from artgen.validate.behavior import check_behavior
from artgen.validate.behavior.drive import Servo
from artgen.validate.behavior.model import JointMotion, Simulation, fixed_model
from artgen.validate.behavior.settle import start_poses
from artgen.validate.hands import check_grasps
from artgen.validate.hands.motion import MOST_FORCE, hand_forces
from artgen.validate.tree import check_tree
from support.appliances import fridge, washer
from support.proof_fridges import evaluated

STEEL = material("steel")


def changed(asset: Asset, name: str, **fields: object) -> Asset:
    """Return the asset with one joint changed."""
    joints = tuple(
        replace(joint, **fields) if joint.name == name else joint  # type: ignore[arg-type]
        for joint in asset.joints
    )
    return replace(asset, joints=joints)


@pytest.fixture(scope="module")
def cold() -> Asset:
    return evaluated(fridge(), "fridge")


@pytest.fixture(scope="module")
def wet() -> Asset:
    return evaluated(washer(), "washer")


def found(findings: tuple[Finding, ...], joint: str) -> list[str]:
    return [finding.message for finding in findings if finding.joint == joint]


# certificate


def test_drawers_are_free_up_to_their_slack_and_beyond_it_over_an_open_door(cold: Asset) -> None:
    certificate = certify(cold)
    assert certificate.proven
    assert not recheck(cold, certificate)
    assert not check_tree(cold).findings
    assert not cold.blocked({"drawer_slide_0": 0.03})
    assert cold.blocked({"drawer_slide_0": 0.031}) == ("drawer_slide_0",)
    assert not cold.blocked({"drawer_slide_0": 0.3, "door_hinge": 1.8})


@settings(max_examples=12, deadline=None)
@given(st.floats(0.002, 0.06))
def test_a_slack_is_proven_exactly_if_the_drawer_does_not_reach_the_door(slack: float) -> None:
    asset = evaluated(fridge(slack=slack), "fridge")
    failures = certify(asset).failures
    assert bool(failures) == (slack > 0.035 - 1e-6)  # the closed door is 35 mm away
    assert {pair.links for pair in failures} <= {("door", f"inner_drawer_{n}") for n in (0, 1)}


def test_a_drawer_that_strikes_the_door_within_its_slack_is_refuted_with_a_witness() -> None:
    certificate = certify(evaluated(fridge(slack=0.05), "fridge"))
    (pair, _) = certificate.failures
    assert pair.verdict == "collision"
    assert pair.witness is not None
    assert 0.035 <= pair.witness.pose["drawer_slide_0"] <= 0.05
    assert "door and inner_drawer_0" in str(certificate)


def test_a_follower_has_slack_as_well() -> None:
    """A bolt that follows a knob may come out by 8 mm; beyond that the flap has to be up."""

    def lock(slack: float) -> Asset:
        flap = Revolute("flap", axis=X, pivot=(0, 0, 0.1), limits=(0, 1.5))
        knob = Revolute("knob", axis=Z, pivot=(0.3, 0, 0), limits=(0, 1))
        bolt = Prismatic("bolt", axis=Y, follows=0.05 * knob, needs=(flap > 1.2).beyond(slack))
        body = part(box(0.02, 0.3, 0.02).at(-0.2, 0, 0), "base", STEEL)
        body = body.attach(part(box(0.05, 0.01, 0.1).at(0, 0, 0.05), "flap", STEEL), flap)
        body = body.attach(part(box(0.02, 0.02, 0.02).at(0.3, 0, 0), "knob", STEEL), knob)
        return evaluated(
            body.attach(part(box(0.02, 0.02, 0.02).at(0, -0.025, 0.02), "bolt", STEEL), bolt), "l"
        )

    assert certify(lock(0.008)).proven
    assert {pair.links for pair in certify(lock(0.012)).failures} == {("flap", "bolt")}


@pytest.mark.parametrize(
    ("needs", "message"),
    [
        ({"beyond": 0.5}, "it needs door_hinge > 1.7 beyond 0.5 and until inf m, which it never reaches"),
        ({"beyond": -0.1}, "beyond -0.1 and until inf m, which is empty"),
        ({"beyond": 0.1, "until": 0.05}, "beyond 0.1 and until 0.05 m, which is empty"),
    ],
)
def test_positions_that_make_no_sense_in_a_file_are_found(
    cold: Asset, needs: dict[str, float], message: str
) -> None:
    before = cold.joint("drawer_slide_0").needs
    assert before is not None
    wrong = changed(cold, "drawer_slide_0", needs=replace(before, **{"beyond": None, **needs}))
    assert any(message in fault.message for fault in check_tree(wrong).faults)


def test_parts_that_free_each_other_within_their_slack_are_not_stuck(cold: Asset) -> None:
    first, second = (cold.joint(f"drawer_slide_{number}") for number in (0, 1))
    assert first.needs is not None
    for slack, stuck in ((0.03, False), (None, True)):
        asset = cold
        for joint, other in ((first, second), (second, first)):
            condition = replace(first.needs.condition, joint=other.name, value=0.02)
            asset = changed(asset, joint.name, needs=replace(first.needs, condition=condition, beyond=slack))
        assert any("all stay at 0" in fault.message for fault in check_tree(asset).faults) == stuck


# behavior


def test_a_refrigerator_behaves(cold: Asset) -> None:
    result = check_behavior(cold)
    assert not result.findings
    assert result.detail == "released in 4 poses; 3 joints driven; 2 pushed while blocked"


def test_a_drawer_that_nothing_stops_beyond_its_slack_is_a_fault() -> None:
    faults = check_behavior(evaluated(fridge(ghost=True), "fridge")).faults
    (message,) = found(faults, "drawer_slide_0")
    assert message.startswith("moves from 0.03 m on by 320 mm under 50 N with all closed, though it needs ")
    assert "(door_hinge > 1.7).beyond(0.03); nothing touches it" in message
    assert not found(faults, "drawer_slide_1")


def test_a_slack_far_short_of_the_door_is_a_fault() -> None:
    faults = check_behavior(evaluated(fridge(slack=0.02), "fridge")).faults
    (message,) = found(faults, "drawer_slide_1")
    assert "moves from 0.02 m on by 15" in message  # it stands 15 mm before the door there


def test_a_door_that_is_pushed_open_from_inside_is_a_note() -> None:
    (note, other) = check_behavior(evaluated(fridge(friction=2.0), "fridge")).findings
    assert note.severity == other.severity == "note"
    assert "is blocked only while a hand holds door_hinge: moves from 0.03 m on by" in note.message


def test_a_dishwasher_behaves_and_a_balanced_door_does_not_hold_its_racks(wet: Asset) -> None:
    result = check_behavior(wet)
    assert not result.faults
    notes = {finding.joint: finding.message for finding in result.findings}
    # the spring balances the door, and neither shuts it nor keeps it shut as that of a latch would
    assert set(notes) == {"rack_slide_1", "rack_slide_2"}
    assert "is blocked only while a hand holds door_hinge" in notes["rack_slide_2"]


def test_racks_are_also_let_go_halfway_out_over_the_open_door(wet: Asset) -> None:
    poses = list(start_poses(wet, _motions(wet)))
    out = [q for q in poses if q["rack_slide_0"] > 0.0]
    assert [round(q["rack_slide_0"], 3) for q in out] == [0.21, 0.42]
    assert all(q["door_hinge"] > 1.45 for q in out)
    assert not any(wet.blocked(q) for q in poses)


def _motions(asset: Asset) -> Mapping[str, JointMotion]:
    with TemporaryDirectory() as folder:
        path = main_files(asset.export(Path(folder) / "toy", formats=("mjcf",)))["mjcf"]
        return Simulation(asset, fixed_model(path), []).motions


def rocker(**options: float) -> Body:
    """Return a wall switch: a plate and a rocker of a gram."""
    plate = part(box(0.08, 0.01, 0.08).at(0, 0.005, 0.3), "plate", STEEL)
    solid = box(0.02, 0.006, 0.04).at(0, -0.008, 0.3)
    turn = {"friction": 0.02, "damping": 0.001} | options
    joint = Revolute("rock", axis=X, pivot=(0, -0.004, 0.3), limits=(-0.05, 0.05), **turn)  # type: ignore[arg-type]
    return plate.attach(part(solid, "rocker", STEEL, push=push_on(solid)), joint)


@pytest.mark.parametrize("effort", [100.0, 1.0, 0.2])
@pytest.mark.parametrize("stiffness", [0.0, 0.5])
def test_a_light_switch_is_driven_gently_whatever_its_effort(effort: float, stiffness: float) -> None:
    assert not check_behavior(evaluated(rocker(effort=effort, stiffness=stiffness), "switch")).findings


def test_a_part_that_flies_through_its_limit_is_told_to_have_less_effort(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def shove(servo: Servo, speed: float) -> None:
        servo.force = math.copysign(servo.bound, speed)
        servo._simulation.data.qfrc_applied[servo.motion.speeds[0]] = servo.force

    monkeypatch.setattr(Servo, "move", shove)
    fault = check_behavior(evaluated(rocker(effort=100.0), "switch")).faults[0]
    assert "driven with 100 N m from 0 rad to -0.05 rad, it flies through that limit to -" in fault.message
    assert fault.joint == "rock"
    assert fault.hint.startswith("give it a smaller effort=, about 60 N times the lever arm of a hand")


# hands


def test_hands_take_what_lies_behind_a_door_when_that_is_open(cold: Asset, wet: Asset) -> None:
    assert not check_grasps(cold).findings
    assert check_grasps(cold).detail == "3 grasps, 0 pushes; with at most 54.1 N, at door_hinge"
    assert not check_grasps(wet).findings


def test_what_is_hidden_without_a_dependency_is_taken_after_opening_the_door() -> None:
    notes = check_grasps(evaluated(fridge(needs=False), "fridge")).findings
    assert {note.severity for note in notes} == {"note"}
    assert notes[0].message == ("grasp inner_drawer_0_grasp: a hand reaches it only where door_hinge > 1.96")


def test_a_door_that_needs_the_hidden_thing_does_not_open_for_the_hand() -> None:
    asset = evaluated(fridge(needs=False), "fridge")
    needs = evaluated(fridge(), "fridge").joint("drawer_slide_0").needs
    assert needs is not None
    condition = replace(needs.condition, joint="drawer_slide_0", value=0.02)
    asset = changed(asset, "door_hinge", needs=replace(needs, condition=condition, until=0.3, beyond=None))
    faults = [fault.message for fault in check_grasps(asset).faults]
    assert "grasp inner_drawer_0_grasp: on its way to the grasp the finger strikes door/door" in faults
    assert not any("inner_drawer_1_grasp" in fault for fault in faults)


# forces


def drawer(height: float = 0.0, **options: float) -> Asset:
    """Return a bar of about 1.5 kg that slides upwards, or forwards."""
    solid = box(0.2, 0.02, 0.05)
    joint = Prismatic("slide", axis=Z if height else -Y, limits=(0.0, 0.2), **options)  # type: ignore[arg-type]
    wall = part(box(0.4, 0.02, 0.4).at(0, 0.1, 0), "wall", STEEL)
    return evaluated(wall.attach(part(solid, "bar", STEEL, grasp=grasp_on(solid)), joint), "bar")


def test_a_hand_works_against_friction_springs_and_weight() -> None:
    weight = 9.81 * drawer().link("bar").mass_properties.mass
    assert hand_forces(drawer(friction=7.0)) == {"slide": pytest.approx(7.0)}
    assert hand_forces(drawer(friction=7.0, stiffness=100.0)) == {"slide": pytest.approx(27.0, abs=0.01)}
    assert hand_forces(drawer(1.0)) == {"slide": pytest.approx(weight, rel=1e-4)}
    # the spring carries it: what is left of its weight pulls it down at the top, and holds it at the bottom
    balanced = hand_forces(drawer(1.0, stiffness=weight / 0.2, rest=0.3, friction=1.0))
    assert balanced == {"slide": pytest.approx(1.0 + 0.5 * weight, abs=0.01)}


@settings(max_examples=20, deadline=None)
@given(st.floats(0.1, 1.5), st.floats(0.5, 40.0))
def test_a_longer_lever_needs_less_force(arm: float, friction: float) -> None:
    post = part(box(0.05, 0.05, 0.9).at(0, 0, 0.45), "post", STEEL)
    leaf = box(arm + 0.02, 0.03, 0.8).at(0.04 + arm / 2, 0, 0.45)
    turn = Revolute("turn", axis=Z, limits=(0.0, 1.0), friction=friction)
    hold = push_on(leaf, at=(arm, 0.0, 0.45))
    forces = hand_forces(evaluated(post.attach(part(leaf, "leaf", STEEL, push=hold), turn), "gate"))
    # it is pushed on its face, half its thickness beside the axis, which moves the point askew but no slower
    assert forces == {"turn": pytest.approx(friction / arm, rel=1e-3)}


def test_a_joint_too_heavy_for_a_hand_is_a_fault_with_its_force() -> None:
    assert not check_grasps(drawer(friction=MOST_FORCE - 0.1)).faults
    (fault,) = check_grasps(drawer(friction=80.0)).faults
    assert (fault.joint, fault.value, fault.unit) == ("slide", pytest.approx(80.0), "N")
    assert fault.message == (
        "a hand needs 80 N to move it against friction, springs and weight, more than 60 N"
    )
    assert "balance the weight with a spring" in fault.hint


def test_what_water_or_a_motor_moves_needs_neither_hand_nor_force(wet: Asset) -> None:
    forces = hand_forces(wet)
    assert set(forces) == {
        "door_hinge", *(f"button_press_{n}" for n in range(8)), *(f"rack_slide_{n}" for n in range(3))
    }  # fmt: skip
    assert forces["button_press_0"] == pytest.approx(800.0 * 0.004, rel=0.01)
    assert math.isclose(forces["rack_slide_1"], 5.0, rel_tol=1e-6)
