from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen import Prismatic, Revolute, X, Y, Z, box, part, weld
from artgen.asset import Asset, Grasp
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetDependency as Dependency
from artgen.asset.mass import MassProperties
from artgen.validate.tree import check_tree
from support.blocks import STEEL, block, with_shapes
from support.proof_fridges import evaluated

NEVER = "which its joints never reach"
NO_BODY = "kg m^2 are impossible for a rigid body"


@artgen.generator
def cabinet() -> artgen.Body:
    """A box with a door that turns, a handle on it, and a tray that slides and drives a flap."""
    handle = part(box(0.02, 0.02, 0.1).at(0.2, -0.2, 0), "handle", STEEL)
    turn = Revolute("turn", axis=Y, pivot=(0.2, -0.2, 0), limits=(0, 0.8), stiffness=1.0, rest=0.0)
    hinge = Revolute("hinge", axis=Z, pivot=(-0.25, -0.17, 0), limits=(0, 1.5), needs=(turn > 0.6).until(0.1))
    door = part(box(0.5, 0.02, 0.4).at(0, -0.17, 0), "door", STEEL).attach(handle, turn)
    slide = Prismatic("slide", axis=X, limits=(0, 0.3), needs=hinge > 1.2)
    flap = Revolute("flap", axis=Y, pivot=(0, 0, 0.1), follows=2.0 * slide)
    tray = part(box(0.2, 0.1, 0.05), "tray", STEEL).attach(part(box(0.1, 0.01, 0.1), "flap", STEEL), flap)
    return part(box(0.5, 0.3, 0.4), "body", STEEL).attach(door, hinge).attach(tray, slide)


@artgen.generator
def crate() -> artgen.Body:
    return part(box(0.1, 0.1, 0.1) - box(0.05, 0.05, 0.05), "crate", STEEL)


@pytest.fixture(scope="module")
def asset():
    return cabinet.generate(certify=False)


def changed(asset, name, **fields):
    """The asset with one joint changed."""
    joints = tuple(replace(joint, **fields) if joint.name == name else joint for joint in asset.joints)
    return replace(asset, joints=joints)


def the_fault(asset):
    (finding,) = check_tree(asset).faults
    return finding


def test_a_sound_asset_has_no_findings(asset):
    result = check_tree(asset)
    assert not result.findings
    assert result.detail == "5 links, 4 joints"


@pytest.mark.parametrize(("category", "seed"), [("door", 2), ("door", 5), ("handle", 5)])
def test_categories_hang_together_in_memory_and_read_back(category, seed, tmp_path):
    made = artgen.generate(category, seed, certify=False)
    assert not check_tree(made).faults
    read = check_tree(Asset.load(made.export(tmp_path / "out", formats=("urdf",))))
    assert not read.faults
    assert not [finding for finding in read.findings if "cannot be judged" in finding.message]


def test_two_roots_and_a_cycle_are_found(asset):
    rootless = replace(asset, joints=tuple(joint for joint in asset.joints if joint.name != "turn"))
    rootless = changed(rootless, "hinge", needs=None)
    found = the_fault(rootless)
    assert (found.link, found.message) == (
        "handle", "no joint joins it to the others: the asset has more than one root"
    )  # fmt: skip
    around = changed(asset, "hinge", parent="handle")
    found = the_fault(around)
    assert (found.link, found.joint) == ("door", "hinge")
    assert "its parent 'handle' does not come before it" in found.message


def test_a_joint_to_nowhere_and_a_second_parent_are_found(asset):
    found = [finding.message for finding in check_tree(changed(asset, "turn", child="handel")).faults]
    assert found[0] == "it joins 'handel', which is not a link. Did you mean 'handle'?"
    again = replace(asset.joint("flap"), name="flap_again", parent="body", follows=None)
    found = [finding.message for finding in check_tree(replace(asset, joints=(*asset.joints, again))).faults]
    assert found == ["its parents are 'tray' and 'body'; a link has one parent"]


def test_names_used_twice_or_no_identifiers_are_found(asset):
    base, *others = asset.links
    twice = replace(asset, links=(base, *others, replace(others[-1])))
    assert "2 links are named 'flap'" in [finding.message for finding in check_tree(twice).faults]
    found = the_fault(replace(asset, joints=tuple(
        replace(joint, name="the turn") if joint.name == "turn" else
        replace(joint, needs=None) if joint.name == "hinge" else joint for joint in asset.joints
    )))  # fmt: skip
    assert (found.joint, found.message) == ("the turn", "the joint name 'the turn' is not an identifier")


def test_labels_that_are_not_declared_are_found(asset):
    labels = ("body", "door", "handle", "tray", "flaps")
    found = the_fault(replace(asset, category="cabinet", labels=labels))
    assert found.link == "flap"
    assert found.message == "its label 'flap' is not declared by category 'cabinet'"
    assert "Did you mean 'flaps'?" in found.hint


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"axis": np.array([0.0, 0.0, 2.0])}, "its axis has length 2"),
        ({"pivot": np.array([0.0, np.nan, 0.0])}, "its pivot is not finite"),
        ({"limits": (1.0, 0.5)}, "its limits are 1 to 0.5 rad: the lower limit comes first"),
        ({"limits": (0.0, np.inf)}, "its limits are 0 to inf rad, which is not finite"),
        ({"limits": (0.0, 1e-8)}, "its limits are 0 to 1e-08 rad: it cannot move, but is not locked"),
        ({"damping": -1.0}, "its damping is -1"),
        ({"friction": np.nan}, "its friction is nan"),
        ({"effort": 0.0}, "its effort is 0"),
        ({"velocity": -2.0}, "its velocity is -2"),
        ({"pivot": np.array([5.0, 0.0, 0.0])}, "its axis passes 'door' and 'body' at a distance of 4.646 m"),
    ],
)
def test_impossible_numbers_of_joints_are_found(asset, fields, message):
    found = [
        finding
        for finding in check_tree(changed(asset, "hinge", **fields)).faults
        if finding.joint == "hinge"
    ]
    assert found[0].message.startswith(message)


def test_limits_that_look_like_degrees_are_a_note(asset):
    (note,) = check_tree(changed(asset, "hinge", limits=(0.0, 90.0))).findings
    assert (note.severity, note.joint) == ("note", "hinge")
    assert str(note).endswith("its limits are 0 to 90 rad, 14 turns; degrees? use math.radians(90)")
    assert not check_tree(changed(asset, "hinge", limits=(0.0, 2.0 * np.pi))).findings


@pytest.mark.parametrize(("height", "told"), [(0.3, False), (0.6, True)])
def test_a_link_that_nothing_carries_is_a_note(height, told):
    """A lid with a knob, far above its case; its hinge is at the case, and the knob goes with the lid."""

    @artgen.generator
    def chest() -> artgen.Body:
        lid = part(box(0.3, 0.3, 0.01).at(z=height), "lid", STEEL)
        knob = part(box(0.02, 0.02, 0.02).at(z=height + 0.016), "knob", STEEL)
        lid = lid.attach(knob, Revolute("knob_turn", axis=Z, limits=(0, 1)))
        hinge = Revolute("hinge", axis=-X, pivot=(0, 0.15, 0.25), limits=(0, 1.5))
        return part(box(0.3, 0.3, 0.5), "case", STEEL).attach(lid, hinge)

    found = [str(each) for each in check_tree(chest.generate(certify=False)).findings]
    note = "joint hinge: nothing carries 'lid', which is 345 mm from all other links at rest"
    assert [each.startswith(note) for each in found] == [True] * told, found


def test_a_size_that_looks_like_millimetres_is_a_note():
    @artgen.generator
    def stool() -> artgen.Body:
        return part(box(450.0, 9.0, 9.0), "seat", STEEL)

    (note,) = check_tree(stool.generate(certify=False)).findings
    assert note.severity == "note"
    assert str(note) == (
        "the asset is 450 m wide: are these millimetres? lengths are in metres; write 0.45 for 450 mm"
    )


def test_a_spring_beyond_its_limits_is_a_note_unless_it_beats_the_effort(asset):
    (note,) = check_tree(changed(asset, "turn", rest=-1.0)).findings
    assert note.severity == "note"
    assert note.message == (
        "its spring rests at -1 rad, beyond its limits 0 to 0.8: 1 N m hold it at that end"
    )
    fault = the_fault(changed(asset, "turn", rest=-1.0, effort=0.5))
    assert fault.message.endswith("1 N m hold it at that end, more than its effort of 0.5 N m")
    assert fault.value == pytest.approx(1.0)


def test_a_coupled_range_that_its_leader_does_not_give_is_found(asset):
    found = the_fault(changed(asset, "flap", limits=(0.0, 0.5)))
    assert found.joint == "flap"
    assert found.message == ("its limits 0 to 0.5 are not those to which 'slide' takes it, 0 to 0.6")
    circle = changed(asset, "slide", follows=replace(asset.joint("flap").follows, leader="flap"))
    assert {f.message for f in check_tree(circle).faults} >= {"its couplings form a circle"}


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        (Condition("below", "turn", -0.6), f"it needs turn < -0.6, {NEVER}: turn is 0 to 0.8"),
        (Condition("above", "turn", 0.8), f"it needs turn > 0.8, {NEVER}: turn is 0 to 0.8"),
        (Condition("below", "turn", 0.9), "it needs turn < 0.9, which holds everywhere: turn is 0 to 0.8"),
        (Condition("above", "knob", 0.5), "it needs 'knob', which is not another joint of the asset"),
        (Condition("above", "hinge", 0.5), "it needs 'hinge', which is not another joint of the asset"),
        (
            Condition("all", terms=(Condition("above", "turn", 0.6), Condition("below", "turn", 0.4))),
            "it needs (turn > 0.6) & (turn < 0.4), which its joints never reach: turn is 0 to 0.8",
        ),
        (
            Condition("all", terms=(Condition("above", "slide", 0.2), Condition("below", "flap", 0.3))),
            (
                "it needs (slide > 0.2) & (flap < 0.3), which its joints never reach: "
                "slide is 0 to 0.3, flap is 0 to 0.6"
            ),
        ),
    ],
)
def test_dependencies_that_cannot_be_or_forbid_nothing_are_found(asset, condition, message):
    asset = changed(asset, "slide", needs=None)
    assert the_fault(changed(asset, "hinge", needs=Dependency(condition))).message == message


@pytest.mark.parametrize(
    "condition",
    [
        Condition("below", "turn", 0.2),
        Condition("any", terms=(Condition("above", "turn", 0.9), Condition("above", "turn", 0.5))),
        Condition("all", terms=(Condition("above", "slide", 0.2), Condition("above", "flap", 0.5))),
    ],
)
def test_dependencies_that_can_be_are_sound(asset, condition):
    asset = changed(asset, "slide", needs=None)
    assert not check_tree(changed(asset, "hinge", needs=Dependency(condition))).faults


def test_dependencies_are_followed_through_couplings(asset):
    slide, flap = asset.joint("slide"), asset.joint("flap")
    base = changed(asset, "slide", needs=None)
    down = changed(base, "flap", follows=replace(flap.follows, ratio=-2.0, offset=0.6))
    together = [Condition("above", "slide", 0.2), Condition("above", "flap", 0.3)]
    needs = Dependency(Condition("all", terms=tuple(together)))
    assert "which its joints never reach" in the_fault(changed(down, "hinge", needs=needs)).message
    shifted = changed(base, "flap", follows=replace(flap.follows, offset=0.5), limits=(0.5, 1.1))
    led = replace(flap.follows, leader="flap", ratio=3.0, offset=0.1)
    tail = replace(flap, name="tail", follows=led, limits=(1.6, 3.4))
    chained = replace(shifted, joints=(*shifted.joints, tail))  # tail = 6 * slide + 1.6
    for least, possible in ((2.1, True), (2.3, False)):
        terms = (Condition("above", "tail", least), Condition("below", "slide", 0.1))
        needs = Dependency(Condition("all", terms=terms))
        assert bool(check_tree(changed(chained, "hinge", needs=needs)).faults) != possible
    assert slide.limits == (0.0, 0.3)


def test_joints_that_wait_for_each_other_are_found(asset):
    stuck = changed(asset, "turn", needs=Dependency(Condition("above", "hinge", 0.3)))
    messages = {finding.joint: finding.message for finding in check_tree(stuck).faults}
    assert set(messages) == {"turn", "hinge", "slide"}
    assert messages["turn"] == ("it needs hinge > 0.3, but those joints depend on it as well: all stay at 0")


@pytest.mark.parametrize("visual", [False, True])
@pytest.mark.parametrize("gap", [0.0004, 0.0006, 0.05])
def test_a_part_that_floats_is_found_with_its_gap(asset, gap, visual):
    extra = block((0.1, 0.1, 0.1), (0.25 + 0.05 + gap, 0.0, 0.0))
    found = check_tree(with_shapes(asset, extra, visual=visual)).faults
    if gap < 0.0005:
        assert not found
        return
    (finding,) = found
    assert finding.link == "body"
    assert finding.value == pytest.approx(gap, abs=1e-9)
    x = f"{1e3 * (0.3 + gap):.1f}"
    assert finding.message == (
        f"solid 'extra' at ({x}, 0.0, 0.0) mm floats {1e3 * gap:.3g} mm away from 'body'"
    )


def test_parts_hang_together_over_others_and_groups_are_named_once(asset):
    far = [block((0.1, 0.1, 0.1), (0.4 + 0.1 * number, 0.0, 0.0)) for number in range(3)]
    (finding,) = check_tree(with_shapes(asset, *far)).faults
    assert "with 2 more solids floats 100 mm away from 'body'" in finding.message
    bridge = block((0.12, 0.05, 0.05), (0.3, 0.0, 0.0))
    assert not check_tree(with_shapes(asset, *far, bridge)).faults


def test_parts_that_are_declared_as_separate_are_noted_with_the_reason(tmp_path):
    ends = part(box(0.1, 0.1, 0.1), "end", STEEL, separate="a hidden cable joins them")
    both = weld(ends, part(box(0.1, 0.1, 0.1).at(0.3), "end", STEEL, name="other"))
    lid = part(box(0.1, 0.1, 0.1).at(z=0.2), "lid", STEEL)
    made = evaluated(both.attach(lid, Prismatic("lift", axis=Z, limits=(0, 0.1))), "pair")
    for asset in (made, Asset.load(made.export(tmp_path / "pair", formats=("urdf",)))):
        result = check_tree(asset)
        assert not result.faults
        (note,) = (finding for finding in result.findings if finding.link == "end")
        assert "floats 200 mm away from 'end'" in note.message
        assert note.hint == "a hidden cable joins them"


@pytest.mark.parametrize(("side", "floats"), [(0.0488, True), (0.0492, False)])
def test_a_part_in_a_hollow_floats(side, floats):
    faults = check_tree(with_shapes(crate.generate(certify=False), block((side,) * 3))).faults
    assert [finding.message for finding in faults] == (
        ["solid 'extra' at (0.0, 0.0, 0.0) mm floats 0.6 mm away from 'crate'"] if floats else []
    )


def test_a_part_inside_another_does_not_float(asset):
    assert not check_tree(with_shapes(asset, block((0.01, 0.01, 0.01)))).faults


def heavy(asset, **fields):
    """The asset with other mass properties on its base."""
    base, *others = asset.links
    base = replace(base)
    known = base.mass_properties
    vars(base)["mass_properties"] = MassProperties(
        **({"mass": known.mass, "center": known.center, "inertia": known.inertia} | fields)
    )
    return replace(asset, links=(base, *others))


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"mass": -1.0}, "its mass is -1 kg, or its center or inertia is not finite"),
        ({"mass": 6000.0}, "its mass of 6000 kg makes a density of 1e+05 kg/m^3 of its solids"),
        (
            {"center": np.array([0.0, 0.0, 0.9])},
            "its center of mass (0, 0, 0.9) m lies outside its bounding box",
        ),
        ({"inertia": np.diag([1.0, 1.0, 3.0])}, f"its principal moments 1, 1, 3 {NO_BODY}"),
        ({"inertia": np.diag([0.0, 1.0, 1.0])}, f"its principal moments 0, 1, 1 {NO_BODY}"),
        ({"inertia": np.diag([900.0] * 3)}, "its moment 900 kg m^2 exceeds what its mass and size allow, "),
    ],
)
def test_masses_that_cannot_be_are_found(asset, fields, message):
    assert the_fault(heavy(asset, **fields)).message.startswith(message)


def test_a_light_link_is_found(asset):
    light = heavy(asset, mass=0.1, inertia=1e-5 * np.eye(3))
    assert the_fault(light).message == "its mass of 0.1 kg makes a density of 1.667 kg/m^3 of its solids"


def test_grasps_that_are_no_frames_are_found(asset):
    base, *others = asset.links
    grasp = Grasp("edge", np.diag([1.0, 1.0, -1.0, 1.0]), 0.0)
    found = check_tree(replace(asset, links=(replace(base, grasps=(grasp,)), *others))).faults
    assert [finding.message for finding in found] == [
        "the axes of grasp 'edge' are not a rotation: they are off by 0",
        "grasp 'edge' has width 0 m",
    ]
