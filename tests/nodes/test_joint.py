"""Joints, couplings and dependencies."""

import math
import operator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.asset import Asset
from artgen.asset import AssetDependency as Dependency
from artgen.errors import AssetError, BuildError, EvaluationError
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.fitting import Fitting
from artgen.nodes.handles import Float
from artgen.nodes.joint import Condition, Coupling, Joint, Prismatic, Revolute, Screw
from artgen.nodes.primitive import box
from artgen.nodes.vector import X, Z
from support.lines import place_of

STEEL = material("steel")
KNOB = Revolute("knob", axis=Z)


def block(name):
    return part(box(0.1, 0.1, 0.1), name, STEEL)


def value(handle, **parameters):
    return evaluate(handle, parameters).value


def asset(body, **parameters):
    return Asset.from_tree(value(body, **parameters), "made", "test")


def test_a_revolute_joint_says_what_it_was_given():
    joint = value(
        Revolute(
            "door",
            axis=(0, 0, 2),
            pivot=(1, 0, 0),
            limits=(0, Float.parameter("swing")),
            stiffness=1.5,
            damping=0.1,
            friction=0.2,
            rest=-0.3,
            armature=0.01,
            effort=5.0,
            velocity=2.0,
        ),
        swing=1.4,
    )
    assert (joint.name, joint.kind, joint.limits) == ("door", "revolute", (0.0, 1.4))
    assert joint.axis.tolist() == [0, 0, 1]
    assert joint.pivot.tolist() == [1, 0, 0]
    dynamics = ("stiffness", "damping", "friction", "rest", "armature", "effort", "velocity")
    assert [getattr(joint, name) for name in dynamics] == [1.5, 0.1, 0.2, -0.3, 0.01, 5.0, 2.0]


def test_limits_have_no_sentinels():
    assert value(Prismatic("slide", axis=X)).limits is None
    locked = value(Prismatic("slide", axis=X, limits=(0, 0)))
    assert locked.limits == (0.0, 0.0)
    assert locked.locked
    assert not value(Prismatic("slide", axis=X)).locked


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"limits": (1.0, 0.5)}, "joint 'turn' has limits 1 to 0.5: the lower one comes first"),
        ({"damping": -0.1}, "joint 'turn': damping -0.1 must not be negative"),
        ({"stiffness": -1.0}, "stiffness -1 must not be negative"),
        ({"friction": -1.0}, "friction -1 must not be negative"),
        ({"armature": -1.0}, "armature -1 must not be negative"),
        ({"effort": 0.0}, "effort 0 must be positive"),
        ({"velocity": -1.0}, "velocity -1 must be positive"),
        ({"axis": (0, 0, 0)}, "a vector of length zero has no direction"),
        ({"name": "my joint"}, "joint name 'my joint' is no identifier; use letters, digits and _"),
        ({"name": "töpf"}, "is no identifier"),
        (
            {"follows": Revolute("knob", axis=Z), "limits": (0.0, 1.0)},
            "joint 'turn' follows 'knob', which gives it its range; leave its limits out",
        ),
        (
            {"follows": 0.0 * Revolute("knob", axis=Z)},
            "a coupling to 'knob' with ratio 0 does not move the joint",
        ),
        ({"needs": (KNOB > 0.5).until(0.0)}, "until must be positive, got 0"),
        ({"needs": (KNOB > 0.5).beyond(0.0)}, "beyond must be positive, got 0: leave it out if"),
        ({"needs": (KNOB > 0.5).beyond(0.2).until(0.1)}, "beyond 0.2 must be below until 0.1"),
        ({"needs": (KNOB > 0.5).until(0.1).beyond(0.2)}, "beyond 0.2 must be below until 0.1"),
        ({"needs": (KNOB > 0.5).until(0.1).until(0.2)}, "until is given twice: 0.1 and 0.2"),
        ({"needs": (KNOB > 0.5).beyond(0.1).beyond(0.2)}, "beyond is given twice: 0.1 and 0.2"),
        (
            {"needs": (KNOB > 0.5).beyond(0.4), "limits": (-0.3, 0.4)},
            "joint 'turn' has limits -0.3 to 0.4: it never moves beyond 0.4",
        ),
    ],
)
def test_impossible_joints_are_refused(given, message):
    with pytest.raises(EvaluationError) as caught:
        value(Revolute(**{"name": "turn", "axis": Z} | given))
    assert message in str(caught.value)
    assert f"\n  at {__file__}:" in str(caught.value)


def test_the_error_names_the_line_of_the_joint():
    swing = Float.parameter("swing")
    hinge = Revolute("door", axis=Z, limits=(0.0, swing))  # marker: hinge
    body = block("frame").attach(block("door"), hinge)
    with pytest.raises(EvaluationError, match="has limits 0 to -1: the lower one comes first") as caught:
        value(body, swing=-1.0)
    assert place_of(__file__, "marker: hinge") in str(caught.value)


@pytest.mark.parametrize(
    ("make", "ratio", "offset"),
    [
        (lambda joint: joint * 1.0, 1.0, 0.0),
        (lambda joint: 4.0 * joint + 0.02, 4.0, 0.02),
        (lambda joint: joint / 4 - 0.5, 0.25, -0.5),
        (lambda joint: 0.5 - joint, -1.0, 0.5),
        (lambda joint: -joint, -1.0, 0.0),
        (lambda joint: 2 * (joint + 1) / 4, 0.5, 0.5),
        (lambda joint: -(2 * joint + 1), -2.0, -1.0),
        (lambda joint: 1 - 2 * joint, -2.0, 1.0),
        (lambda joint: joint * Float.parameter("a") + Float.parameter("a"), 3.0, 3.0),
    ],
)
def test_arithmetic_makes_couplings(make, ratio, offset):
    coupling = make(Revolute("pedal", axis=X))
    assert isinstance(coupling, Coupling)
    made = value(coupling, a=3.0)
    assert (made.leader, made.ratio, made.offset) == ("pedal", ratio, offset)


def test_a_joint_that_is_followed_alone_is_followed_one_to_one():
    pedal = Revolute("pedal", axis=X)
    direct, spelled = Revolute("lid", axis=X, follows=pedal), Revolute("lid", axis=X, follows=1.0 * pedal)
    assert direct.node.key == spelled.node.key


def test_comparisons_make_conditions():
    door, lock = Revolute("door", axis=Z), Revolute("lock", axis=Z)
    region = (door > 1.2) & ((lock < 0.5) | (lock > Float.parameter("a")))
    assert isinstance(region, Condition)
    made = value(region, a=2.0)
    assert made.joints() == ("door", "lock")
    assert str(made) == "(door > 1.2) & ((lock < 0.5) | (lock > 2))"
    assert made.holds({"door": 1.3, "lock": 0.4})
    assert made.holds({"door": 1.3, "lock": 2.1})
    assert not made.holds({"door": 1.3, "lock": 1.0})
    assert not made.holds({"door": 1.1, "lock": 0.4})


def test_a_condition_is_a_dependency_that_always_counts():
    handle = Revolute("handle", axis=Z)
    always = value(Revolute("door", axis=Z, needs=handle > 0.5)).needs
    latched = value(Revolute("door", axis=Z, needs=(handle > 0.5).until(0.06))).needs
    assert isinstance(always, Dependency)
    assert (always.until, latched.until) == (None, 0.06)
    assert not always.allows(0.1, {"handle": 0.0})
    assert latched.allows(0.1, {"handle": 0.0})
    assert not latched.allows(0.05, {"handle": 0.0})


def test_a_joint_may_need_a_condition_only_beyond_a_position():
    door = Revolute("door", axis=Z)
    slack = value(Prismatic("drawer", axis=X, needs=(door > 1.2).beyond(0.03), limits=(0.0, 0.4))).needs
    assert (slack.until, slack.beyond) == (None, 0.03)
    orders = [(door > 1.2).beyond(0.03).until(0.3), (door > 1.2).until(0.3).beyond(0.03)]
    first, second = (value(Prismatic("drawer", axis=X, needs=needs)).needs for needs in orders)
    assert first == second == Dependency(slack.condition, until=0.3, beyond=0.03)


def test_the_opposite_of_a_condition_is_written_as_one():
    with pytest.raises(
        BuildError, match=r"write the opposite comparison, such as \(turn < 0.5\) for ~\(turn > 0"
    ):
        operator.invert(KNOB > 0.5)


@pytest.mark.parametrize("kind", [Revolute, Prismatic])
def test_a_joint_without_an_axis_names_its_class(kind):
    with pytest.raises(
        TypeError, match=rf"{kind.__name__}\b.*\(\) missing 1 required keyword-only argument: 'axis'"
    ):
        kind("a")


def test_what_a_joint_depends_on_is_checked_while_building():
    with pytest.raises(BuildError, match=r"needs a Dependency or None, got a Bool handle"):
        Prismatic("rack", axis=X, needs=Float.parameter("door") > 1.2)
    with pytest.raises(BuildError, match=r"by=...\) needs a Float, got a Revolute handle"):
        Revolute("a", axis=X) + Revolute("b", axis=X)


def pair(follows=None, needs=None):
    body = block("base").attach(block("pedal"), Revolute("pedal", axis=X, limits=(0.0, 0.5)))
    return body.attach(block("lid"), Revolute("lid", axis=X, follows=follows, needs=needs))


def test_a_follower_takes_its_range_from_its_leader():
    made = asset(pair(follows=0.1 - 2 * Revolute("pedal", axis=X)))
    assert made.joint("lid").limits == (-0.9, 0.1)
    assert made.positions({"pedal": 0.25})["lid"] == pytest.approx(-0.4)


def test_an_unknown_leader_is_an_error():
    with pytest.raises(
        AssetError, match=r"joint 'lid' follows 'padel', which is not a joint.*Did you mean 'pedal'\?"
    ):
        asset(pair(follows=Revolute("padel", axis=X) * 2))
    with pytest.raises(
        AssetError, match=r"joint 'lid' needs 'padel', which is not a joint of this asset; attach"
    ):
        asset(pair(needs=Revolute("padel", axis=X) > 0.2))


def test_the_reference_that_is_wrong_is_named():
    pedal, other = Revolute("pedal", axis=X), Revolute("other", axis=X)
    with pytest.raises(AssetError, match=r"joint 'lid' needs 'other'"):
        asset(pair(follows=pedal * 2, needs=other > 0.2))


def test_a_joint_cannot_refer_to_itself():
    with pytest.raises(AssetError, match=r"joint 'lid' needs itself; name another joint"):
        asset(pair(needs=Revolute("lid", axis=X) > 0.2))
    with pytest.raises(AssetError, match=r"joint 'lid' follows itself"):
        asset(pair(follows=Revolute("lid", axis=X) * 2))


def test_a_circle_of_couplings_is_an_error():
    a, b = Revolute("a", axis=X), Revolute("b", axis=X)
    body = block("base").attach(block("one"), Revolute("a", axis=X, follows=b * 2))
    body = body.attach(block("two"), Revolute("b", axis=X, follows=a * 2))
    with pytest.raises(
        AssetError, match="the couplings of joints a, b form a circle; one must lead"
    ) as caught:
        asset(body)
    assert caught.value.joint in ("a", "b")


def test_followers_of_followers_add_up():
    first = Revolute("a", axis=X, limits=(0.0, 1.0))
    second = Revolute("b", axis=X, follows=2 * first + 0.1)
    third = Revolute("c", axis=X, follows=3 * second)
    body = block("base").attach(block("z"), third).attach(block("y"), second).attach(block("x"), first)
    made = asset(body)
    assert made.positions({"a": 0.5})["c"] == pytest.approx(3 * (2 * 0.5 + 0.1))
    assert made.joint("c").limits == pytest.approx((0.3, 6.3))


@pytest.mark.parametrize("kind", [Revolute, Prismatic])
def test_motion_moves_the_child_along_the_axis(kind):
    joint = value(kind("move", axis=Z, pivot=(1, 0, 0)))
    moved = joint.motion(0.5) @ np.array([2.0, 0.0, 0.0, 1.0])
    expected = [1 + math.cos(0.5), math.sin(0.5), 0] if kind is Revolute else [2, 0, 0.5]
    assert moved[:3] == pytest.approx(expected)


def test_the_kinds_of_joints_are_types():
    turn, slide = Revolute("turn", axis=Z), Prismatic("slide", axis=X)
    assert isinstance(turn, Revolute)
    assert isinstance(turn, Joint)
    assert not isinstance(turn, Prismatic)
    assert isinstance(slide, Prismatic)
    assert [evaluate(each).value.kind for each in (turn, slide)] == ["revolute", "prismatic"]


def screwed(**options):
    options = {"pitch": 0.02, "axis": Z, "limits": (0, 9.0), "pivot": (0.3, 0.1, 0)} | options
    return Screw("cap", **options)


@settings(max_examples=15, deadline=None)
@given(
    axis=st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda axis: np.linalg.norm(axis) > 0.1),
    pitch=st.floats(0.001, 0.1) | st.floats(-0.1, -0.001),
    angle=st.floats(0.0, 9.0),
)
def test_a_screw_moves_points_along_a_helix(axis, pitch, angle):
    made = asset(block("jar").attach(block("lid"), screwed(axis=axis, pitch=pitch)))
    direction, pivot = np.array(axis) / np.linalg.norm(axis), np.array([0.3, 0.1, 0.0])
    point = np.array([0.05, -0.02, 0.07, 1.0])
    moved = (made.pose({"cap": angle})["lid"] @ point)[:3] - pivot
    arm = point[:3] - pivot
    along = direction * (direction @ arm)
    turned = np.cos(angle) * (arm - along) + np.sin(angle) * np.cross(direction, arm)
    helix = along + turned + direction * pitch * angle / (2.0 * math.pi)
    np.testing.assert_allclose(moved, helix, atol=1e-12)


def test_a_screw_is_one_degree_of_freedom_wherever_it_is_attached():
    free = asset(block("jar").attach(block("lid"), screwed()))
    assert free.valid_states.dofs == ("cap",)
    assert free.joint("cap_rise").limits == pytest.approx((0.0, 0.02 * 9.0 / (2.0 * math.pi)))
    row = asset(block("jar").repeat(block("lid"), screwed(), at=[(0, 0, 0), (1, 0, 0)]))
    assert row.joint("cap_rise_1").follows.leader == "cap_1"
    fitted = asset(block("jar").install(Fitting.moving(block("lid"), screwed())))
    assert [joint.name for joint in fitted.joints] == ["cap", "cap_rise"]


def test_the_mirror_image_of_a_screw_has_a_left_hand_thread():
    pair = asset(block("jar").attach_pair(block("lid").at(0.3), screwed(), normal=X))
    poses = pair.pose({"cap_right": 1.0, "cap_left": 1.0})
    right, left = (poses[f"lid_{side}"] for side in ("right", "left"))
    flip = np.diag([-1.0, 1.0, 1.0, 1.0])
    np.testing.assert_allclose(left, flip @ right @ flip, atol=1e-12)
    assert left[2, 3] == right[2, 3] == pytest.approx(0.02 / (2.0 * math.pi))


def test_a_screw_without_pitch_or_limits_is_an_error():
    with pytest.raises(BuildError, match=r"Screw\('cap', pitch=0\) would not advance\n.*\n  Use Revolute"):
        screwed(pitch=0)
    with pytest.raises(EvaluationError, match="a coupling to 'cap' with ratio 0"):
        asset(block("jar").attach(block("lid"), screwed(pitch=Float.parameter("pitch"))), pitch=0.0)
    with pytest.raises(TypeError, match="limits"):
        Screw("cap", pitch=0.02, axis=Z)


def test_gears_mesh_in_opposite_senses_and_racks_slide_by_the_pitch_radius():
    shaft = Revolute("shaft", axis=Z, limits=(0, 1))
    outer, inner = value(shaft.gear(12 / 36)), value(shaft.gear(Float.parameter("a"), reverse=False), a=2.0)
    assert (outer.leader, outer.ratio, inner.ratio) == ("shaft", -12 / 36, 2.0)
    # teeth of a module of 1 mm pass the point of contact at one speed
    assert 0.036 / 2 * outer.ratio == pytest.approx(-0.012 / 2)
    body = block("case").attach(block("pinion"), shaft)
    made = asset(body.attach(block("bar"), Prismatic("bar", axis=X, follows=shaft.rack(radius=0.006))))
    assert made.joint("bar").limits == pytest.approx((0.0, 0.006))


@pytest.mark.parametrize("ratio", [0.0, -2.0])
def test_a_gear_needs_teeth(ratio):
    shaft = Revolute("shaft", axis=Z)
    with pytest.raises(EvaluationError, match=r"driven by 'shaft' has ratio .* must be positive"):
        value(shaft.gear(ratio))
    with pytest.raises(EvaluationError, match="driven by 'shaft' has radius 0"):
        value(shaft.rack(0.0))


def test_a_gear_drives_another_joint_that_turns_and_a_rack_one_that_slides():
    shaft, slide = Revolute("shaft", axis=Z), Prismatic("slide", axis=X)
    with pytest.raises(BuildError, match="'slide' slides, but a gear is driven by a joint that turns"):
        slide.gear(2.0)
    with pytest.raises(BuildError, match="joint 'bar' follows the wrong kind of law: a gear turns"):
        Prismatic("bar", axis=X, follows=shaft.gear(2.0))
    with pytest.raises(BuildError, match="a rack slides: use Prismatic"):
        Revolute("wheel", axis=X, follows=shaft.rack(0.01))
    with pytest.raises(AssetError, match="joint 'shaft' follows itself"):
        asset(block("base").attach(block("one"), Revolute("shaft", axis=Z, follows=shaft.gear(2.0))))
