"""Behavior in MuJoCo: toys that behave give no finding, and each fault gives its own."""

import math
import re
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from artgen import (
    Body,
    Prismatic,
    Revolute,
    Screw,
    Solid,
    X,
    Y,
    Z,
    box,
    cylinder,
    material,
    part,
    union,
    weld,
)
from artgen.asset import AllowedContact, Asset
from artgen.asset import AssetCondition as Condition
from artgen.asset.report import CheckResult, Finding
from artgen.graph import evaluate
from artgen.validate.behavior import check_behavior
from artgen.validate.behavior.model import Simulation, fixed_model
from artgen.validate.joints import isolated, negation, state_for

ABS, OAK, STEEL = material("abs"), material("oak"), material("steel")


def made(body: Body, **fields: Any) -> Asset:
    return Asset.from_tree(evaluate(body).value, "toy", "test", **fields)


def checked(body: Body, **fields: Any) -> CheckResult:
    return check_behavior(made(body, **fields))


def the_fault(result: CheckResult) -> Finding:
    assert len(result.findings) == 1, [str(finding) for finding in result.findings]
    assert result.findings[0].severity == "fault"
    return result.findings[0]


def shell(*more: Solid) -> Body:
    """A box 0.3 m wide and deep and 0.2 m high, open towards -y, and what stands in or before it."""
    body = box(0.34, 0.32, 0.24).at(0.0, 0.01, 0.12) - box(0.3, 0.32, 0.2).at(0.0, -0.01, 0.12)
    return part(union(body, *more) if more else body, "carcass", OAK)


def drawer(height: float = 0.17) -> Solid:
    return box(0.29, 0.29, height).at(0.0, -0.005, 0.025 + height / 2)


def slide(**options: Any) -> Prismatic:
    return Prismatic("slide", **{"axis": -Y, "limits": (0.0, 0.2), "friction": 4.0, "damping": 5.0} | options)


def flap(**options: Any) -> Body:
    """A lid that lies on a box and turns up about its back edge."""
    turn: dict[str, Any] = {"axis": -X, "pivot": (0.0, 0.15, 0.21), "limits": (0.0, 1.2), "damping": 0.4}
    base = part(box(0.3, 0.3, 0.2).at(0.0, 0.0, 0.1), "base", OAK)
    lid = part(box(0.3, 0.3, 0.01).at(0.0, 0.0, 0.2065), "lid", OAK)
    return base.attach(lid, Revolute("turn", **turn | options))


def door(**options: Any) -> Body:
    """A leaf that turns about an upright axis in its post."""
    turn: dict[str, Any] = {"axis": Z, "limits": (0.0, 1.0), "friction": 0.2, "damping": 0.2}
    leaf = part(box(0.5, 0.03, 0.8).at(0.31, 0.0, 0.45), "leaf", OAK)
    return part(post(), "post", OAK).attach(leaf, Revolute("turn", **turn | options))


def post() -> Solid:
    return box(0.05, 0.05, 0.9).at(0.0, 0.0, 0.45)


def bolted(*, blocks: bool = True, needs: Callable[..., Any] | None = None, **options: Any) -> Body:
    """A drawer with a bolt before it, which a lever lifts; or beside it, where it blocks nothing."""
    lever = Revolute(
        "lever",
        axis=-Y,
        pivot=(0.25, 0.0, 0.3),
        limits=(0.0, 0.8),
        stiffness=0.5,
        rest=-1.0,
        damping=0.2,
        armature=0.002,
    )
    lift = Prismatic("lift", axis=Z, follows=0.05 * lever)
    place = 0.0 if blocks else 0.25
    bolt = part(box(0.04, 0.01, 0.06).at(place, -0.157, 0.205), "bolt", STEEL)
    arm = part(box(0.1, 0.02, 0.02).at(0.22, 0.0, 0.3), "arm", STEEL)
    body = shell().attach(arm, lever).attach(bolt, lift)
    front = part(drawer(), "drawer", OAK)
    condition = lift > 0.03 if needs is None else needs(lever, lift)
    return body.attach(front, slide(needs=condition, **options))


# what behaves


def test_a_heavy_drum_without_stops_is_driven_both_ways() -> None:
    drum = part(cylinder(0.25, 0.1, axis=Y).at(0.0, -0.2, 0.45), "drum", STEEL)
    spin = Revolute("spin", axis=Y, pivot=(0.0, 0.0, 0.45), friction=0.2, damping=0.02, effort=40.0)
    assert checked(part(post(), "post", OAK).attach(drum, spin)).findings == ()


def test_a_drawer_that_runs_gives_no_finding():
    result = checked(shell().attach(part(drawer(), "drawer", OAK), slide()))
    assert result == CheckResult("behavior", (), "released in 3 poses; 1 joints driven")


def test_a_lid_with_a_spring_gives_no_finding():
    result = checked(flap(stiffness=3.0, rest=-0.5))
    assert not result.findings
    assert result.detail.endswith("1 sprung back; moved by gravity or springs: turn")


def test_a_lever_that_lifts_the_bolt_of_a_drawer_gives_no_finding():
    result = checked(bolted())
    assert [str(finding) for finding in result.findings] == []
    assert "2 joints driven; 1 sprung back; 1 pushed while blocked; 1 couplings watched" in result.detail


def test_what_gravity_moves_is_no_fault():
    result = checked(flap())
    assert not result.findings
    assert result.detail.endswith("moved by gravity or springs: turn")


def test_a_wheel_without_limits_makes_a_full_turn():
    wheel = cylinder(0.1, 0.04, axis=Y).at(0.0, -0.2, 0.12)
    body = shell().attach(part(wheel, "wheel", OAK), Revolute("spin", axis=Y, pivot=(0.0, 0.0, 0.12)))
    assert not checked(body).findings


def test_what_moves_carries_joints_along():
    """A tray tips by its weight, and then what lies on it slides down."""
    tip = Revolute("tip", axis=Y, pivot=(0.05, 0.0, 0.5), limits=(0.0, 1.0), damping=0.5)
    run = Prismatic("run", axis=X, limits=(-0.05, 0.2), friction=2.0, damping=1.0)
    tray = part(box(0.4, 0.1, 0.01).at(0.26, 0.0, 0.5), "tray", OAK)
    cube = part(box(0.05, 0.05, 0.05).at(0.15, 0.0, 0.531), "cube", STEEL)
    result = checked(part(post(), "post", OAK).attach(tray.attach(cube, run), tip))
    assert not result.findings
    assert result.detail.endswith("moved by gravity or springs: run, tip")


def test_a_base_that_stands_is_no_fault_and_one_that_tips_is():
    broad = checked(shell().attach(part(drawer(), "drawer", OAK), slide()), base="free")
    assert not broad.findings
    leaning = part(
        box(0.05, 0.05, 0.01).at(0, 0, 0.005)
        | box(0.3, 0.05, 0.3).at(0.1, 0, 0.16) - box(0.3, 0.1, 0.2).at(0.2, 0, 0.1),
        "pole",
        OAK,
    )
    fault = the_fault(checked(leaning, base="free"))
    assert fault.link == "pole"
    assert fault.unit == "rad"
    assert fault.value > 0.5
    assert "tips over: after" in fault.message


def test_a_base_that_tips_over_when_it_is_open_is_a_note():
    tower = part(box(0.1, 0.1, 0.2).at(0, 0, 0.1), "tower", OAK)
    block = part(box(0.1, 0.1, 0.1).at(0, 0, 0.2505), "block", STEEL)
    result = checked(tower.attach(block, slide(friction=60.0)), base="free")
    assert [(each.link, each.severity) for each in result.findings] == [("tower", "note")]
    assert "tips over: after" in result.findings[0].message
    assert result.findings[0].pose["slide"] > 0.05


def test_what_is_low_rolls_on_the_floor_and_does_not_tip_over():
    rod = box(0.2, 0.012, 0.012).rotate(X, 0.3).at(z=0.0077)
    result = checked(part(rod, "rod", OAK), base="free")
    assert [each.severity for each in result.findings] == ["note"]


def test_wheels_of_a_free_base_may_roll_on_the_floor():
    cart = part(box(0.4, 0.3, 0.02).at(0, 0, 0.09), "cart", OAK)
    weight = part(box(0.1, 0.1, 0.05).at(0, 0, 0.126), "weight", STEEL)
    pull = Prismatic("pull", axis=X, limits=(-0.1, 0.1), stiffness=60.0, rest=0.0, damping=8.0)
    cart = cart.attach(weight, pull)
    for number, (x, y) in enumerate([(-0.15, -0.1), (-0.15, 0.1), (0.15, -0.1), (0.15, 0.1)]):
        roll = Revolute(f"roll_{number}", axis=Y, pivot=(x, y, 0.035), limits=None, friction=0.001)
        wheel = part(cylinder(0.035, 0.02, axis=Y).at(x, y, 0.035), "wheel", ABS, name=f"wheel_{number}")
        cart = cart.attach(wheel, roll)
    result = checked(cart, base="free")
    assert {each.severity for each in result.findings} == {"note"}
    rolled = [each.message for each in result.findings if each.joint.startswith("roll_")]
    assert len(rolled) == 4
    assert all(re.match(r"moves by -?\S+ degrees on the floor, as the base does", each) for each in rolled)


def test_a_free_base_does_not_stand_while_a_part_is_folded_below_it():
    case = part(box(0.3, 0.3, 0.04).at(0, 0, 0.02), "case", OAK)
    foot = part(box(0.05, 0.1, 0.01).at(0.2, 0, 0.02), "foot", OAK)
    turn = Revolute("turn", axis=X, pivot=(0.2, 0.05, 0.02), limits=(0, 1.5), friction=1.0)
    result = checked(case.attach(foot, turn), base="free")
    assert not result.findings
    assert result.detail.startswith("released in 3 poses")


# settling


def pressed() -> Body:
    """A drawer that is 3 mm too long for its carcass."""
    return shell().attach(part(box(0.29, 0.298, 0.17).at(0.0, 0.004, 0.11), "drawer", OAK), slide())


def test_parts_that_overlap_press_each_other_out():
    result = checked(pressed())
    contact, drift, driven = result.findings
    assert contact.link == "carcass, drawer"
    assert contact.value == pytest.approx(0.003, rel=1e-3)
    assert contact.message == "carcass/carcass and drawer/drawer press 3 mm into each other after 0 s"
    assert contact.hint.startswith("make room between them, or declare the contact with allow_contact")
    assert drift.joint == "slide"
    assert 0.0005 < drift.value < 0.2
    assert "without a cause" in drift.message
    assert drift.hint == "carcass/carcass and drawer/drawer push each other apart: make room between them"
    assert "to 0 m, it stops at 0.003 m" in driven.message


@pytest.mark.parametrize(
    ("depth", "when", "found"),
    [
        (0.0026, None, False),
        (0.0024, None, True),
        (0.0026, Condition("below", "slide", 0.1), False),
        (0.0026, Condition("above", "slide", 0.1), True),
    ],
)
def test_contacts_by_design_may_be_deep(depth: float, when: Condition | None, *, found: bool):
    asset = made(pressed())
    allowed = AllowedContact(("drawer", "carcass"), ("drawer", "carcass"), depth, "it is a toy", when)
    result = check_behavior(replace(asset, contacts=(allowed,)))
    assert any("into each other" in finding.message for finding in result.findings) == found


def edited(asset: Asset, folder: Path, edit: Callable[[ET.Element], None]) -> Path:
    """Export an asset and change its MJCF."""
    directory = asset.export(folder / "toy", formats=("mjcf",))
    path = directory / "toy.xml"
    tree = ET.parse(path)
    edit(tree.getroot())
    tree.write(path)
    return directory


def of_joint(root: ET.Element, name: str) -> ET.Element:
    return next(joint for joint in root.iter("joint") if joint.get("name") == name)


def test_friction_that_creeps_is_a_fault(tmp_path: Path):
    rod = part(box(0.02, 0.02, 0.3).at(0.0, -0.2, 0.2), "rod", STEEL)
    asset = made(shell().attach(rod, Prismatic("slide", axis=Z, limits=(-0.02, 0.1), friction=20.0)))
    soft = {"solimpfriction": "0.5 0.5 0.001", "solreffriction": "0.02 1"}
    result = check_behavior(
        asset, edited(asset, tmp_path, lambda root: of_joint(root, "slide").attrib.update(soft))
    )
    fault = the_fault(result)
    assert fault.joint == "slide"
    assert -0.13 < fault.value < -0.0005
    assert "gravity and springs pull with -9.24 N against 20 N of friction" in fault.message
    assert fault.hint == "the file's friction creeps: write a harder solimpfriction and solreffriction"
    hard = {"solimpfriction": "0.9999 0.9999 0.001", "solreffriction": "0.005 1"}
    other = edited(asset, tmp_path, lambda root: of_joint(root, "slide").attrib.update(hard))
    assert not check_behavior(asset, other).findings


def test_a_joint_that_moves_against_gravity_is_a_fault(tmp_path: Path):
    """A lid that rests on a block under it, too thick: it should fall shut, and is lifted."""
    wedge = part(box(0.1, 0.1, 0.01).at(0.0, -0.05, 0.2), "wedge", OAK)
    lid = part(box(0.3, 0.3, 0.01).at(0.0, 0.0, 0.2065), "lid", OAK)
    turn = Revolute("turn", axis=-X, pivot=(0.0, 0.15, 0.21), limits=(0.0, 1.2), damping=0.4)
    body = part(box(0.3, 0.3, 0.18).at(0.0, 0.0, 0.09), "base", OAK)
    result = checked(weld(body, wedge).attach(lid, turn))
    fault = next(finding for finding in result.faults if "without a cause" in finding.message)
    assert fault.value > math.radians(0.5)
    assert "gravity and springs pull with -0.9" in fault.message


def test_warnings_of_mujoco_are_faults(tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch):
    monkeypatch.chdir(tmp_path)
    asset = made(shell().attach(part(drawer(), "drawer", OAK), slide(friction=0.0)))
    hard = {"stiffness": "1e14", "springref": "0.01", "damping": "0"}
    directory = edited(asset, tmp_path, lambda root: of_joint(root, "slide").attrib.update(hard))
    result = check_behavior(asset, directory)
    found = [finding for finding in result.faults if "MuJoCo warns while it settles: Nan" in finding.message]
    assert len(found) == 1
    assert found[0].pose == {"slide": 0.0}
    assert "QACC" in found[0].message
    assert capfd.readouterr() == ("", "")
    assert [path.name for path in tmp_path.iterdir()] == ["toy"]


# driving


def test_a_joint_that_geometry_stops_halfway_is_a_fault():
    stop = box(0.02, 0.02, 0.3).at(0.0, -0.25, 0.15)  # before the drawer, which reaches it after 90 mm
    result = checked(shell(stop).attach(part(drawer(), "drawer", OAK), slide()))
    fault = next(finding for finding in result.faults if "driven" in finding.message)
    assert (fault.link, fault.joint, fault.unit) == ("drawer", "slide", "m")
    assert fault.value == pytest.approx(0.09, abs=0.002)
    assert "driven with 100 N from 0 m to 0.2 m, it stops at 0.09" in fault.message
    assert "after 45" in fault.message
    assert "where contact holds it: carcass/carcass and drawer/drawer" in fault.message
    assert fault.pose == {"slide": fault.value}
    assert fault.hint == "make room between them, or say with needs= where other joints have to stand first"


def test_a_wheel_that_meets_something_makes_no_full_turn():
    spoke = union(cylinder(0.03, 0.04, axis=Y), box(0.02, 0.04, 0.08).at(0.0, 0.0, 0.04)).at(0.0, -0.2, 0.12)
    stop = box(0.3, 0.2, 0.02).at(0.2, -0.2, 0.1)
    spin = Revolute("spin", axis=Y, pivot=(0.0, 0.0, 0.12))
    result = checked(shell(stop).attach(part(spoke, "wheel", OAK), spin))
    found = [finding for finding in result.faults if "driven with" in finding.message]
    assert len(found) == 1
    assert 1.0 < found[0].value < 2.0


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"effort": 0.5}, "driven with 0.5 N m from 0 rad to 1.2 rad, it stops at -"),
        (
            {"stiffness": 40.0, "rest": -1.0, "effort": 42.0, "damping": 5.0},
            "of the way, where gravity, springs and damping pull with -",
        ),
    ],
)
def test_a_joint_too_weak_for_its_weight_or_friction_is_a_fault(options: dict[str, float], text: str):
    fault = the_fault(checked(flap(**options)))
    assert text in fault.message
    assert fault.hint == "give the joint more effort, or weaken its spring, friction or damping"


def test_a_free_base_is_fixed_while_joints_are_driven():
    fault = the_fault(checked(flap(effort=0.5), base="free"))
    assert fault.message.startswith("driven with 0.5 N m from")


def test_a_joint_that_has_an_offset_range_is_driven_to_both_ends():
    assert not checked(door(limits=(-0.7, -0.1))).findings


# springs


def test_a_spring_that_is_not_damped_swings():
    faults = checked(door(stiffness=4.0, rest=0.5, friction=0.0, damping=0.0)).findings
    assert [fault.message.split(" by ")[0] for fault in faults] == [
        f"released at {end} rad, it still moves" for end in (0, 1)
    ]
    assert {fault.hint for fault in faults} == {"give it more damping"}


def test_a_spring_that_something_stops_does_not_return():
    stop = box(0.02, 0.02, 0.5).at(0.3, 0.1, 0.25)  # the leaf meets it at 0.25 rad
    body = weld(part(post(), "post", OAK), part(stop, "stop", OAK))
    leaf = part(box(0.5, 0.03, 0.8).at(0.31, 0.0, 0.45), "leaf", OAK)
    turn = Revolute("turn", axis=Z, limits=(-0.8, 0.8), stiffness=4.0, rest=0.5, damping=1.0, effort=5.0)
    result = checked(body.attach(leaf, turn))
    found = [finding for finding in result.faults if "released at -0.8 rad" in finding.message]
    assert len(found) == 1
    assert (
        "after its spring should have taken it to 0.5 rad: post/stop and leaf/leaf hold it"
        in found[0].message
    )


def test_friction_may_keep_a_spring_from_its_rest_by_its_width():
    assert not checked(door(stiffness=4.0, rest=0.5, friction=1.0, damping=0.5)).findings


def test_friction_may_hold_at_one_end_against_a_spring_that_moves_a_joint_from_the_other():
    assert not checked(door(stiffness=1.4, rest=0.8, friction=1.0, damping=0.1)).findings


def test_friction_that_holds_against_a_spring_everywhere_is_told():
    faults = checked(door(stiffness=0.5, rest=0.5, friction=1.0, damping=0.5)).faults
    missed = "5 s after its spring should have taken it to 0.5 rad: "
    assert [missed in fault.message for fault in faults] == [True, True]
    assert "0.25 N m of the spring against 1 N m of friction" in faults[0].message
    assert {fault.hint for fault in faults} == {"make the spring stiffer, or lower friction or damping"}


def test_a_range_that_takes_minutes_is_told_at_once():
    faults = checked(door(velocity=0.01)).faults
    assert [fault.message for fault in faults] == ["takes 100 s over its range at its velocity limit of 0.01"]
    assert faults[0].hint == "give it a velocity= that takes 60 s at most"


def key(**options: Any) -> Body:
    """Return a key of 0.5 g with a preloaded spring."""
    press = Prismatic("press", axis=-Z, limits=(0.0, 0.0012), stiffness=400.0, effort=3.0, **options)
    return shell().attach(part(box(0.015, 0.015, 0.002).at(0.0, 0.0, 1.0), "key", ABS), press)


def test_a_part_too_light_for_its_spring_is_told_its_armature():
    result = checked(key(rest=-0.001))
    light = "is too light for its spring at 2 ms: armature >= 0.0011 kg"
    notes = [finding for finding in result.findings if finding.severity == "note"]
    assert [note.message for note in notes] == [light]
    driven = [fault for fault in result.faults if fault.message.startswith(("driven", "released"))]
    assert driven
    assert {fault.hint for fault in driven} == {f"it {light}"}


def test_a_spring_that_presses_a_part_into_its_soft_limit_has_returned():
    assert not checked(key(rest=-0.001, armature=0.005, damping=0.5)).findings


def test_a_spring_that_is_too_slow_does_not_return():
    faults = checked(door(stiffness=0.5, rest=0.5, friction=0.0, damping=2.0)).findings
    assert ["in half a second, 5 s after its release" in fault.message for fault in faults] == [True, True]
    assert {fault.hint for fault in faults} == {"make the spring stiffer, or damp it less"}
    faults = checked(door(stiffness=0.5, rest=0.5, friction=0.0, damping=20.0)).findings
    assert [fault.message.split(":")[0] for fault in faults] == [
        f"released at {end} rad, it stands at {at} rad 5 s after its spring should have taken it to 0.5 rad"
        for end, at in (("0", "0.05828"), ("1", "0.9417"))
    ]


def test_weight_against_a_spring_is_a_note():
    result = checked(flap(stiffness=0.4, rest=1.2))
    assert [finding.severity for finding in result.findings] == ["note"]
    assert "its weight pulls with -0.9" in result.findings[0].message
    assert "against 0.4" in result.findings[0].message
    assert result.findings[0].hint == "make the spring stiffer, if it is to lift the part"


# couplings


@pytest.mark.parametrize(("ratio", "percent"), [("0.0501", 0), ("0.0485", 3), ("0.045", 10)])
def test_a_coupling_that_is_off_is_a_fault(ratio: str, percent: int, tmp_path: Path):
    asset = made(bolted())

    def edit(root: ET.Element) -> None:
        root.find("equality/joint").set("polycoef", f"0 {ratio} 0 0 0")

    result = check_behavior(asset, edited(asset, tmp_path, edit))
    if not percent:
        assert not result.findings
        return
    fault = the_fault(result)
    assert (fault.link, fault.joint) == ("bolt", "lift")
    assert fault.value == pytest.approx(0.0004 * percent, rel=0.05)
    assert re.search(
        rf"or {percent}(\.\d)? % of its range off the position that lever gives it", fault.message
    )


def test_a_screw_raises_a_weight_by_its_law_in_mujoco():
    post = part(box(0.3, 0.3, 0.02).at(z=0.01), "post", STEEL)
    plate = part(box(0.2, 0.2, 0.02).at(z=0.04), "plate", STEEL)  # 6.3 kg
    turn = Screw("turn", pitch=0.008, axis=Z, limits=(0.0, 25.0), friction=0.2, damping=0.01, effort=3.0)
    result = checked(post.attach(plate, turn))  # compares the rise with the law at every step
    assert not result.findings
    assert "1 joints driven; 1 couplings watched" in result.detail


def test_a_light_lid_keeps_to_its_thread_without_an_armature():
    cup = part(box(0.07, 0.07, 0.1).at(z=0.05), "cup", STEEL)
    lid = part(box(0.07, 0.07, 0.003).at(z=0.102), "lid", STEEL)  # 0.12 kg, a rise of 6 mm
    result = checked(cup.attach(lid, Screw("turn", pitch=0.008, axis=Z, limits=(0.0, 4.7))))
    assert not result.findings
    assert "1 couplings watched" in result.detail


# dependencies


def test_a_dependency_that_nothing_blocks_is_a_fault():
    fault = the_fault(checked(bolted(blocks=False)))
    assert (fault.link, fault.joint) == ("drawer", "slide")
    assert fault.value == pytest.approx(0.2, abs=0.002)
    assert "moves by 200 mm under 50 N with all closed, though it needs lift > 0.03" in fault.message
    assert fault.hint == "no file format knows dependencies: a part, such as a latch, has to stand in its way"


def test_each_part_of_a_condition_has_to_block():
    """The bolt does block, but nothing does when the lever stands too high."""
    result = checked(bolted(needs=lambda lever, lift: (lift > 0.03) & (lever < 0.7)))
    fault = next(finding for finding in result.faults if finding.joint == "slide")
    assert "with lever at 0.8, though it needs (lift > 0.03) & (lever < 0.7)" in fault.message


def test_either_part_of_a_condition_may_free():
    pin = Prismatic("pin", axis=X, limits=(0.0, 0.05), friction=8.0)
    body = bolted(needs=lambda lever, lift: (lift > 0.03) | (pin > 0.01))
    rod = part(box(0.02, 0.02, 0.05).at(0.3, -0.1, 0.3), "rod", STEEL)
    result = checked(body.attach(rod, pin))
    # it is driven with the lever up, where it is free; that the pin alone frees it is not so, but none asks
    assert not result.findings


def test_a_blocked_joint_may_move_beyond_its_last_needed_position():
    body = bolted(needs=lambda lever, lift: (lift > 0.03).until(0.001))
    fault = the_fault(checked(body))
    assert "though it needs (lift > 0.03).until(0.001)" in fault.message
    assert "carcass" not in fault.message
    assert "bolt/bolt and drawer/drawer touch, and give way" in fault.message


def test_what_moves_along_with_what_it_needs_is_a_note():
    """Two doors that touch: the second one takes the first one along, which nothing but friction holds."""
    first = Revolute("first", axis=-Z, pivot=(-0.17, -0.165, 0), limits=(0, 1.5), friction=0.5, damping=0.3)
    needs = first > 1.3
    front = part(box(0.3, 0.01, 0.18).at(0.0, -0.157, 0.12), "front", OAK)
    body = shell().attach(front, first)
    result = checked(body.attach(part(drawer(), "drawer", OAK), slide(needs=needs, limits=(0.0, 0.08))))
    (note,) = result.findings
    assert note.severity == "note"
    assert note.joint == "slide"
    assert "is blocked only while a hand holds first: moves by" in note.message
    assert note.message.endswith("and takes first along")


def test_a_spring_at_ease_elsewhere_does_not_hold_what_blocks():
    """The door before a drawer springs half open, as a flap of a new box: closed, a hand holds it."""
    first = Revolute(
        "first",
        axis=-Z,
        pivot=(-0.17, -0.165, 0),
        limits=(0, 2.4),
        stiffness=0.5,
        rest=0.9,
        friction=0.1,
        damping=0.3,
    )
    front = part(box(0.3, 0.01, 0.18).at(0.0, -0.157, 0.12), "front", OAK)
    child = part(drawer(), "drawer", OAK)
    result = checked(shell().attach(front, first).attach(child, slide(needs=first > 1.3, limits=(0.0, 0.08))))
    assert [finding.message for finding in result.faults] == []
    assert any("is blocked only while a hand holds first" in finding.message for finding in result.findings)


def test_a_condition_that_never_holds_is_a_fault():
    fault = the_fault(checked(bolted(needs=lambda lever, lift: lift > 0.05)))
    assert fault.message == "can never move: no position of the other joints satisfies lift > 0.05"


def test_a_condition_that_always_holds_is_a_fault():
    fault = the_fault(checked(bolted(blocks=False, needs=lambda lever, lift: lever < 0.9)))
    assert fault.message == "needs lever < 0.9, which holds wherever the other joints stand"
    assert fault.hint == "leave the dependency out, or reverse its comparison"


def test_a_reversed_dependency_is_a_fault():
    result = checked(bolted(needs=lambda lever, lift: lift < 0.03))
    fault = next(finding for finding in result.faults if "driven" in finding.message)
    assert "driven with 100 N from 0 m to 0.2 m, it stops at 0.00" in fault.message
    assert "bolt/bolt and drawer/drawer" in fault.message


# conditions


def chain() -> Asset:
    """Blocks in a row: `slip` follows `turn` the other way round, and `slide` needs it."""
    turn = Revolute("turn", axis=Z, limits=(-0.2, 0.8))
    slip = Prismatic("slip", axis=X, follows=-0.5 * turn + 0.1)
    blocks = [part(box(0.1, 0.1, 0.1).at(0.2 * number, 0, 0), f"block_{number}", OAK) for number in range(4)]
    last = Prismatic("slide", axis=X, limits=(0.0, 0.2), needs=slip < 0.0)
    return made(blocks[0].attach(blocks[1], turn).attach(blocks[2], slip).attach(blocks[3], last))


def _leaves() -> st.SearchStrategy[Condition]:
    return st.builds(
        Condition,
        st.sampled_from(["above", "below"]),
        st.sampled_from(["turn", "slip", "slide"]),
        st.integers(-50, 450).map(lambda number: number / 500 + 1e-4),  # never on the grid
    )


def _trees() -> st.SearchStrategy[Condition]:
    return st.recursive(
        _leaves(),
        lambda terms: st.builds(
            lambda kind, pair: Condition(kind, terms=tuple(pair)),
            st.sampled_from(["all", "any"]),
            st.lists(terms, min_size=2, max_size=3),
        ),
        max_leaves=5,
    )


CHAIN = chain()
GRID = [
    CHAIN.positions({"turn": -0.2 + turn / 50, "slide": way / 250}) for turn in range(51) for way in range(51)
]
FREE = replace(CHAIN, joints=tuple(replace(joint, needs=None) for joint in CHAIN.joints))


def test_what_a_needed_joint_needs_is_needed_as_well():
    state = state_for(CHAIN, [Condition("above", "slide", 0.1)])
    assert state == pytest.approx({"slide": 0.15, "turn": 0.5})


def test_at_its_border_a_comparison_does_not_hold():
    ((_, region),) = isolated(Condition("above", "slide", 0.0))
    assert state_for(CHAIN, [region]) == {"slide": 0.0}


def test_what_is_moved_is_not_asked_for():
    assert state_for(CHAIN, [Condition("above", "slide", 0.1)], ignore="slide") == {}
    assert state_for(CHAIN, [Condition("above", "slide", 0.3)]) is None


@settings(max_examples=60)
@given(_trees())
def test_states_satisfy_their_condition_and_are_found_where_there_are_any(condition: Condition):
    state = state_for(FREE, [condition])
    if state is None:
        assert not any(condition.holds(q) for q in GRID)
    else:
        assert condition.holds(FREE.positions(state))


@settings(max_examples=60)
@given(_trees())
@example(Condition("all", terms=(Condition("above", "turn", 1e-4), Condition("below", "slip", 0.0041))))
def test_a_comparison_that_alone_breaks_a_condition_does(condition: Condition):
    for comparison, region in isolated(condition):
        state = state_for(FREE, [region], extreme=(comparison.joint,))
        if state is None:
            continue
        q = FREE.positions(state)
        assert not condition.holds(q)
        assert not comparison.holds(q)


@settings(max_examples=60)
@given(_trees())
def test_negation_is_the_other_side(condition: Condition):
    other = negation(condition)
    assert all(condition.holds(q) != other.holds(q) for q in GRID[::7])


# files


def test_it_reads_the_files_of_a_directory(tmp_path: Path):
    asset = made(shell().attach(part(drawer(), "drawer", OAK), slide()))
    directory = asset.export(tmp_path / "toy", formats=("mjcf",))
    loaded = Asset.load(directory)
    assert check_behavior(loaded, directory) == check_behavior(asset)


def test_without_its_mjcf_the_check_is_skipped(tmp_path: Path):
    asset = made(shell().attach(part(drawer(), "drawer", OAK), slide()))
    directory = asset.export(tmp_path / "toy", formats=("urdf",))
    result = check_behavior(asset, directory)
    assert result.skipped == "there is no MJCF; export with 'mjcf' among the formats"
    assert not result.findings


def test_without_mujoco_the_check_is_skipped(monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    assert check_behavior(made(shell())).skipped == "needs artgen[sim]"


@pytest.mark.parametrize(
    ("edit", "text"),
    [
        (lambda root: of_joint(root, "slide").set("name", "slid"), "slide"),
        (
            lambda root: of_joint(root, "slide").set("range", "0.3 0.1"),
            "has the range -inf to inf in the file, and 0 to 0.2",
        ),
        (lambda root: of_joint(root, "slide").set("range", "0 0.21"), "has the range 0 to 0.21 in the file"),
        (lambda root: root.find("worldbody/body").set("name", "base"), "carcass"),
    ],
)
def test_a_file_that_does_not_fit_is_a_fault(edit: Callable[[ET.Element], None], text: str, tmp_path: Path):
    asset = made(shell().attach(part(drawer(), "drawer", OAK), slide()))
    fault = the_fault(check_behavior(asset, edited(asset, tmp_path, edit)))
    assert fault.hint == "export it again"
    assert text in fault.message


def test_the_same_asset_gives_the_same_result():
    assert check_behavior(made(pressed())) == check_behavior(made(pressed()))


def test_an_asset_without_joints_is_only_loaded():
    assert checked(shell()) == CheckResult("behavior", (), "released in 1 poses; 0 joints driven")


@pytest.mark.parametrize("friction", [3.0, 8.0])
def test_what_a_spring_throws_is_pushed_though_the_blow_is_over(friction: float) -> None:
    """The ram stops where it strikes the puck, which glides on alone for more than a drift."""
    base = part(box(0.6, 0.1, 0.02).at(0.0, 0.0, 0.01), "base", OAK)
    ram = part(box(0.1, 0.08, 0.05).at(-0.1, 0.0, 0.046), "ram", STEEL)
    puck = part(box(0.05, 0.08, 0.05).at(0.0801, 0.0, 0.046), "puck", STEEL)
    drive = Prismatic("drive", axis=X, limits=(0.0, 0.1053), stiffness=300.0, rest=0.2, damping=1.0)
    glide = Prismatic("glide", axis=X, limits=(0.0, 0.05), friction=friction, damping=2.0)
    (finding,) = checked(base.attach(ram, drive).attach(puck, glide)).findings
    assert finding.severity == "note"
    assert finding.joint == "glide"
    assert "by what gravity or a spring moves: ram/ram and puck/puck touch" in finding.message


def test_warnings_of_an_earlier_motion_are_not_reported_again(tmp_path):
    asset = made(flap())
    folder = asset.export(tmp_path / "toy", formats=("mjcf",))
    warnings = ["WARNING: of the standing model"]
    simulation = Simulation(asset, fixed_model(folder / "toy.xml"), warnings)
    simulation.begin({}, "it is driven")
    simulation.step()
    assert not simulation.findings
    warnings.append("WARNING: Nan in QACC at DOF 0")
    simulation.step()
    (found,) = simulation.findings.values()
    assert found.message == "MuJoCo warns while it is driven: WARNING: Nan in QACC at DOF 0"
