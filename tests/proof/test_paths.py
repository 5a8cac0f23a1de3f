"""The joint space of a pair: it holds every pose that the dependencies allow, and little more."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen import Prismatic, Revolute, X, Y, Z, box, material, part
from artgen.asset import Asset
from artgen.asset.joint import AssetCondition as Condition
from artgen.asset.joint import AssetCoupling as Coupling
from artgen.asset.joint import AssetDependency as Dependency
from artgen.proof.overlap import displacement
from artgen.proof.paths import FULL_SLIDE, FULL_TURN, Space
from support.proof_fridges import evaluated

STEEL = material("stainless")
NAMES = ("a", "b", "c", "d")


def star() -> Asset:
    """Four arms on a hub, each with a joint of its own; the last arm carries another one."""
    body = part(box(0.1, 0.1, 0.1), "hub", STEEL)
    axes = {"a": X, "b": Y, "c": Z}
    for name, axis in axes.items():
        arm = part(box(0.1, 0.1, 0.1), name, STEEL)
        if name == "c":
            tip = part(box(0.05, 0.05, 0.05), "d", STEEL)
            arm = arm.attach(tip, Prismatic("d", axis=X, limits=(0.0, 0.5)))
        body = body.attach(arm, Revolute(name, axis=axis, pivot=(0.1, 0.2, 0.3), limits=(-0.5, 1.5)))
    return evaluated(body, "star")


def changed(asset: Asset, **fields: dict[str, object]) -> Asset:
    joints = tuple(
        replace(joint, **fields.get(joint.name, {}))
        for joint in asset.joints  # type: ignore[arg-type]
    )
    return replace(asset, joints=joints)


def condition(draw: np.random.Generator, joints: list[str], depth: int = 2) -> Condition:
    if depth == 0 or draw.random() < 0.5:
        kind = "above" if draw.random() < 0.5 else "below"
        return Condition(kind, str(draw.choice(joints)), float(draw.uniform(-0.4, 1.4)))  # type: ignore[arg-type]
    terms = tuple(condition(draw, joints, depth - 1) for _ in range(2))
    return Condition("all" if draw.random() < 0.5 else "any", terms=terms)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10**6))
def test_no_allowed_pose_lies_outside_the_boxes(seed: int) -> None:
    draw = np.random.default_rng(seed)
    fields: dict[str, dict[str, object]] = {}
    for name in NAMES:
        if draw.random() < 0.6:
            others = [other for other in NAMES if other != name]
            until = float(draw.uniform(0.1, 0.4)) if draw.random() < 0.4 else None
            beyond = float(draw.uniform(0.01, 0.09)) if draw.random() < 0.4 else None
            fields[name] = {"needs": Dependency(condition(draw, others), until, beyond)}
    asset = changed(star(), **fields)
    try:
        space = Space(asset)
    except ValueError as error:
        assert "it could never move" in str(error)  # noqa: PT017 - drawn by chance
        return
    joint_paths = space.joint_paths()
    assert joint_paths
    for _ in range(150):
        q = {joint.name: float(draw.uniform(*(joint.limits or (0, 0)))) for joint in asset.joints}
        for name in NAMES:
            if draw.random() < 0.3:
                q[name] = 0.0
        if asset.blocked(q):
            continue
        for joint_path in joint_paths:
            at = np.array([q[name] for name in joint_path.variables])
            inside = [((box[:, 0] <= at) & (at <= box[:, 1])).all() for box in joint_path.boxes]
            assert any(inside), (joint_path.links, q)


def test_a_dependency_of_two_joints_on_a_way_cuts_off_what_it_forbids() -> None:
    asset = changed(star(), a={"needs": Dependency(Condition("above", "b", 1.0))})
    boxes = Space(asset).joint_path("a", "b").boxes
    total = sum(float(np.prod(box[:, 1] - box[:, 0])) for box in boxes)
    assert total == pytest.approx(2.0 * 0.5, rel=1e-6)  # a moves where b is within 1.0 to 1.5
    (whole,) = Space(asset).joint_path("hub", "a").boxes  # b does not move this pair: it may stand anywhere
    np.testing.assert_allclose(whole, [[-0.5, 1.5]])


def test_the_slack_of_a_dependency_adds_a_strip_in_which_the_other_may_stand_anywhere() -> None:
    asset = changed(star(), a={"needs": Dependency(Condition("above", "b", 1.0), beyond=0.1)})
    boxes = Space(asset).joint_path("a", "b").boxes
    q = {"a": np.linspace(-0.5, 1.5, 401), "b": np.linspace(-0.5, 1.5, 401)}
    found = np.zeros((401, 401), bool)
    for low, high in (each.T for each in boxes):
        inside = [(low[n] - 1e-9 <= q[name]) & (q[name] <= high[n] + 1e-9) for n, name in enumerate("ab")]
        found |= inside[0][:, None] & inside[1][None]
    wanted = (np.abs(q["a"]) <= 0.1 + 1e-9)[:, None] | (q["b"] >= 1.0 - 1e-9)[None]
    np.testing.assert_array_equal(found, wanted)


def test_coupled_joints_become_their_leader() -> None:
    follows = {
        "b": {"follows": Coupling("a", 2.0, 0.1), "limits": None},
        "d": {"follows": Coupling("b", -0.1)},
    }
    space = Space(changed(star(), **follows))
    joint_path = space.joint_path("b", "d")
    assert joint_path.variables == ("a", "c")
    assert [follower.leader for follower in joint_path.followers] == ["a", "c", "a"]
    assert joint_path.followers[2].ratio == pytest.approx(-0.2)
    assert joint_path.followers[2].offset == pytest.approx(-0.01)
    assert joint_path.signs == (-1, 1, 1)


def test_unlimited_joints_make_a_full_turn_and_what_follows_them_may_be_anywhere() -> None:
    endless = {"a": {"limits": None}, "b": {"follows": Coupling("a", 2.0), "limits": None}}
    space = Space(changed(star(), **endless))
    assert space.ranges["a"] == FULL_TURN
    assert space.followers["b"].leader == "a"  # two turns for one: nothing is lost
    odd = {"a": {"limits": None}, "b": {"follows": Coupling("a", 0.5), "limits": None}}
    space = Space(changed(star(), **odd))
    assert (space.followers["b"].leader, space.ranges["b"]) == ("b", FULL_TURN)
    sliding = {"a": {"limits": None}, "d": {"follows": Coupling("a", 0.01), "limits": None}}
    assert Space(changed(star(), **sliding)).ranges["d"] == FULL_SLIDE


def test_locked_joints_move_nothing() -> None:
    space = Space(changed(star(), a={"limits": (0.3, 0.3)}))
    assert {joint_path.links for joint_path in space.joint_paths()}.isdisjoint({("hub", "a")})
    assert space.joint_path("a", "b").variables == ("b",)


def test_a_way_takes_the_second_link_into_the_frame_of_the_first() -> None:
    asset = star()
    q = {"a": 0.7, "c": -0.3, "d": 0.2}
    pose = asset.pose(q)
    for joint_path in Space(asset).joint_paths():
        at = np.array([q.get(name, 0.0) for name in joint_path.variables])
        first, second = (pose[name] for name in joint_path.links)
        np.testing.assert_allclose(displacement(joint_path, at), np.linalg.inv(first) @ second, atol=1e-12)
