"""Joints: motion, couplings, dependencies and what becomes of them in mirrors and files."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetCoupling as Coupling
from artgen.asset import AssetDependency as Dependency
from artgen.asset import AssetJoint as Joint
from artgen.asset import rotation
from artgen.asset.joint import JointKind

directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1)
points = st.tuples(*[st.floats(-2.0, 2.0)] * 3)
angles = st.floats(-6.0, 6.0)


def unit(vector: tuple[float, ...]) -> np.ndarray:
    return np.array(vector) / np.linalg.norm(vector)


def joint(kind: JointKind, axis: tuple[float, ...], pivot: tuple[float, ...], **fields: object) -> Joint:
    return Joint("j", kind, unit(axis), np.array(pivot), **fields)  # type: ignore[arg-type]


@given(directions, angles)
def test_rotation_turns_about_its_axis_by_its_angle(axis: tuple[float, ...], angle: float) -> None:
    turn = rotation(unit(axis), angle)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(turn @ unit(axis), unit(axis), atol=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    assert np.trace(turn) == pytest.approx(1.0 + 2.0 * np.cos(angle))


def test_rotation_is_right_handed() -> None:
    np.testing.assert_allclose(rotation(np.array([0, 0, 1.0]), np.pi / 2) @ [1, 0, 0], [0, 1, 0], atol=1e-15)


@given(st.sampled_from(["revolute", "prismatic"]), directions, points, angles, angles)
def test_positions_add_up_and_zero_is_rest(
    kind: JointKind, axis: tuple[float, ...], pivot: tuple[float, ...], a: float, b: float
) -> None:
    moved = joint(kind, axis, pivot)
    np.testing.assert_allclose(moved.motion(a) @ moved.motion(b), moved.motion(a + b), atol=1e-9)
    np.testing.assert_array_equal(moved.motion(0.0), np.eye(4))


@given(directions, points, angles)
def test_revolute_joint_leaves_its_axis_in_place(
    axis: tuple[float, ...], pivot: tuple[float, ...], angle: float
) -> None:
    moved = joint("revolute", axis, pivot)
    for along in (-1.0, 0.0, 2.0):
        point = np.append(np.array(pivot) + along * unit(axis), 1.0)
        np.testing.assert_allclose(moved.motion(angle) @ point, point, atol=1e-9)


@given(
    st.sampled_from(["revolute", "prismatic"]),
    directions,
    points,
    angles,
    directions,
    angles,
    st.sampled_from([1.0, -1.0]),
)
def test_joint_moves_its_child_alike_wherever_it_is_carried(
    kind: JointKind,
    axis: tuple[float, ...],
    pivot: tuple[float, ...],
    position: float,
    about: tuple[float, ...],
    angle: float,
    handedness: float,
) -> None:
    """Carrying then moving is moving then carrying, in a mirror too."""
    matrix = np.eye(4)
    matrix[:3, :3] = rotation(unit(about), angle) @ np.diag([handedness, 1.0, 1.0])
    matrix[:3, 3] = [1.0, -2.0, 0.5]
    original = joint(kind, axis, pivot)
    np.testing.assert_allclose(
        original.moved(matrix).motion(position) @ matrix, matrix @ original.motion(position), atol=1e-9
    )


@pytest.mark.parametrize(
    ("limits", "closed", "locked"),
    [
        (None, 0.0, False),
        ((-1.0, 2.0), 0.0, False),
        ((0.5, 2.0), 0.5, False),
        ((-2.0, -0.5), -0.5, False),
        ((0.3, 0.3), 0.3, True),
    ],
)
def test_closed_is_the_position_nearest_to_zero(
    limits: tuple[float, float] | None, closed: float, *, locked: bool
) -> None:
    found = joint("revolute", (0, 0, 1), (0, 0, 0), limits=limits)
    assert found.closed == closed
    assert found.locked is locked


DOOR_OPEN = Condition("above", "door", value=1.2)
DRAWER_IN = Condition("below", "drawer", value=0.01)


@pytest.mark.parametrize(
    ("condition", "q", "holds"),
    [
        (DOOR_OPEN, {"door": 1.3}, True),
        (DOOR_OPEN, {"door": 1.2}, False),
        (DRAWER_IN, {"drawer": 0.0}, True),
        (Condition("all", terms=(DOOR_OPEN, DRAWER_IN)), {"door": 1.3, "drawer": 0.2}, False),
        (Condition("any", terms=(DOOR_OPEN, DRAWER_IN)), {"door": 1.3, "drawer": 0.2}, True),
    ],
)
def test_condition_holds_in_its_region(condition: Condition, q: dict[str, float], *, holds: bool) -> None:
    assert condition.holds(q) is holds
    assert Condition.from_data(json.loads(json.dumps(condition.to_data()))) == condition


def test_condition_reads_as_its_author_wrote_it() -> None:
    both = Condition("all", terms=(DOOR_OPEN, DRAWER_IN))
    assert str(both) == "(door > 1.2) & (drawer < 0.01)"
    assert both.joints() == ("door", "drawer")
    assert str(both.renamed({"door": "door_1"})) == "(door_1 > 1.2) & (drawer < 0.01)"


def test_dependency_binds_only_between_closed_and_its_end() -> None:
    latch = Dependency(DOOR_OPEN, until=0.1)
    shut = {"door": 0.0}
    assert latch.allows(0.0, shut)
    assert not latch.allows(0.05, shut)
    assert latch.allows(0.05, {"door": 1.3})
    assert latch.allows(0.1, shut)
    assert latch.allows(-0.2, shut)
    assert not Dependency(DOOR_OPEN).allows(0.5, shut)


def test_dependency_binds_only_beyond_its_slack() -> None:
    slack = Dependency(DOOR_OPEN, beyond=0.03)
    shut, open_ = {"door": 0.0}, {"door": 1.3}
    assert slack.allows(0.03, shut)
    assert slack.allows(-0.03, shut)
    assert not slack.allows(0.031, shut)
    assert not slack.allows(-0.031, shut)
    assert slack.allows(0.3, open_)
    between = Dependency(DOOR_OPEN, until=0.1, beyond=0.03)
    assert [between.allows(at, shut) for at in (0.02, 0.05, 0.1)] == [True, False, True]
    assert str(slack) == "(door > 1.2).beyond(0.03)"
    assert str(between) == "(door > 1.2).beyond(0.03).until(0.1)"


POSITIVE = st.none() | st.floats(1e-6, 10.0)


@given(st.floats(-2.0, 2.0), st.floats(0.0, 2.0), POSITIVE, POSITIVE)
def test_dependency_allows_the_same_after_a_round_trip_and_on_both_sides(
    position: float, door: float, until: float | None, beyond: float | None
) -> None:
    needs = Dependency(DOOR_OPEN, until, beyond)
    read = Dependency.from_data(json.loads(json.dumps(needs.to_data())))
    assert read == needs
    allowed = needs.allows(position, {"door": door})
    assert allowed == needs.allows(-position, {"door": door})
    # slack and end only add positions to those that the condition alone allows
    assert allowed >= Dependency(DOOR_OPEN).allows(position, {"door": door})
    if door <= 1.2 and abs(position) > 1e-9:
        within = beyond is not None and abs(position) <= beyond
        after = until is not None and abs(position) >= until
        assert allowed == (within or after)


def test_dependency_without_slack_is_read_from_files_that_know_none() -> None:
    data = Dependency(DOOR_OPEN, 0.1).to_data()
    assert data == {"condition": {"kind": "above", "joint": "door", "value": 1.2}, "until": 0.1}
    assert Dependency.from_data(data) == Dependency(DOOR_OPEN, 0.1)


def test_joint_survives_its_data() -> None:
    original = Joint(
        "bolt", "prismatic", unit((1, 2, 3)), np.array([0.1, 0.2, 0.3]), (-0.1, 0.2),
        stiffness=1.0, damping=0.1, friction=0.2, rest=0.05, armature=0.01, effort=5.0, velocity=2.0,
        follows=Coupling("handle", 0.02, 0.001), needs=Dependency(DOOR_OPEN, 0.1, 0.02),
        parent="door", child="bolt",
    )  # fmt: skip
    data = json.loads(json.dumps(original.to_data()))
    copy = Joint.from_data(data)
    assert copy.to_data() == original.to_data()
    np.testing.assert_array_equal(copy.motion(0.1), original.motion(0.1))


def test_renaming_reaches_leaders_and_conditions() -> None:
    original = joint(
        "revolute", (0, 0, 1), (0, 0, 0), follows=Coupling("pedal", 4.0), needs=Dependency(DOOR_OPEN)
    )
    renamed = original.renamed({"j": "j_0", "pedal": "pedal_0", "door": "door_0"})
    assert renamed.name == "j_0"
    assert renamed.follows == Coupling("pedal_0", 4.0)
    assert renamed.needs is not None
    assert renamed.needs.condition.joints() == ("door_0",)
