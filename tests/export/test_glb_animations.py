"""Animations of GLB files, and the order in which joints move in them."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetCoupling as Coupling
from artgen.asset import AssetDependency as Dependency
from artgen.catalog import find
from artgen.export import write_glb
from artgen.export.frames import translation
from artgen.export.glb.animations import opening
from support.gltf import Gltf, turned

WIDEST = np.radians(30.0)


def above(joint: str, value: float) -> Condition:
    return Condition("above", joint, value)


def below(joint: str, value: float) -> Condition:
    return Condition("below", joint, value)


def read(asset: Asset) -> Gltf:
    return Gltf(write_glb(asset).files[f"{asset.name}.glb"])


def changed(asset: Asset, **joints: dict) -> Asset:
    """The asset with fields of some joints changed."""
    return replace(
        asset, joints=tuple(replace(joint, **joints.get(joint.name, {})) for joint in asset.joints)
    )


def order(asset: Asset, joint: str) -> list[str]:
    """Names of the joints in the order in which they move to open one."""
    stops = opening(asset, asset.joint(joint))
    assert stops is not None
    return [next(name for name in a if a[name] != b[name]) for a, b in pairwise(stops)]


def positions(asset: Asset, model: Gltf, name: str, time: float) -> dict[str, float]:
    """Where all joints stand at a time of an animation, found from the nodes; turns up to full ones."""
    changes = model.at(name, time)
    return {
        joint["name"]: model.position(joint, changes)
        for joint in model.joints.values()
        if joint["type"] != "fixed"
    }


def check_animation(asset: Asset, model: Gltf, name: str) -> None:
    """Assert that an animation opens its joint fully, begins and ends at rest and forbids nothing."""
    keys = model.keys(name)
    assert keys[0] == 0.0
    assert 1.5 < keys[-1] < 6.0
    joint = asset.joint(name)
    rest = asset.positions()
    reached = []
    for time in np.sort(np.concatenate([keys, (keys[1:] + keys[:-1]) / 2])):
        found = positions(asset, model, name, time)
        if joint.limits is None:
            continue
        reached.append(found[name])
        free = {each.name: found[each.name] for each in asset.free_joints}
        slack = {
            each: float(np.clip(at, *asset.joint(each).limits)) if asset.joint(each).limits else at
            for each, at in free.items()
        }
        assert free == pytest.approx(slack, abs=1e-5)
        cleaned = {each: 0.0 if abs(at) < 1e-6 else at for each, at in slack.items()}
        assert set(asset.blocked(cleaned)) <= set(asset.blocked()), (name, time)
        followed = asset.positions(cleaned)
        assert {each: followed[each] for each in found} == pytest.approx(found, abs=1e-5)
    for time in (keys[0], keys[-1]):
        placed = model.placed(model.at(name, time))
        for link in asset.links:
            np.testing.assert_allclose(placed[link.name], model.placed()[link.name], atol=1e-6)
    if joint.limits is not None:
        assert min(reached) == pytest.approx(min(joint.limits[0], rest[name]), abs=1e-5)
        assert max(reached) == pytest.approx(joint.limits[1], abs=1e-5)


@pytest.mark.parametrize("category", ["door", "handle"])
@pytest.mark.parametrize("seed", range(8))
def test_every_free_joint_opens_and_closes_where_its_dependencies_allow(category: str, seed: int) -> None:
    asset = find(category).generate(seed)
    model = read(asset)
    names = [animation["name"] for animation in model.data.get("animations", [])]
    assert names == [joint.name for joint in asset.free_joints]
    for name in names:
        check_animation(asset, model, name)


def test_hand_made_assets_open_and_close(asset: Asset) -> None:
    model = read(asset)
    assert [each["name"] for each in model.data["animations"]] == [joint.name for joint in asset.free_joints]
    for animation in model.data["animations"]:
        check_animation(asset, model, animation["name"])


def test_open_end_is_the_pose_at_the_upper_limit(asset: Asset) -> None:
    model = read(asset)
    for joint in asset.free_joints:
        if joint.limits is None:
            continue
        stops = opening(asset, joint)
        assert stops is not None
        wanted = next(stop for stop in stops if stop[joint.name] == joint.limits[1])
        poses = asset.pose(wanted)
        found = [model.placed(model.at(joint.name, time)) for time in model.keys(joint.name)]
        expected = {
            link.name: poses[link.name] @ translation(asset.origin(link.name)) for link in asset.links
        }
        errors = [
            max(np.abs(placed[link.name] - expected[link.name]).max() for link in asset.links)
            for placed in found
        ]
        assert min(errors) < 1e-6


def test_quaternions_are_near_enough_that_readers_turn_the_right_way(asset: Asset) -> None:
    model = read(asset)
    for animation in model.data["animations"]:
        for channel in animation["channels"]:
            if channel["target"]["path"] != "rotation":
                continue
            values = model.array(animation["samplers"][channel["sampler"]]["output"]).astype(float)
            steps = [np.trace(turned(a).T @ turned(b)) for a, b in pairwise(values)]
            assert np.arccos(np.clip((min(steps) - 1) / 2, -1, 1)) <= WIDEST


def test_times_grow(asset: Asset) -> None:
    model = read(asset)
    for animation in model.data["animations"]:
        assert (np.diff(model.keys(animation["name"])) > 0.0).all()


def test_movement_is_eased(cabinet: Asset) -> None:
    model = read(cabinet)
    times = np.linspace(0.0, 1.0, 11)
    reach = np.array([positions(cabinet, model, "lever_turn", time)["lever_turn"] for time in times])
    speeds = np.diff(reach)
    assert speeds[0] < 0.3 * speeds[5]
    assert speeds[-1] < 0.3 * speeds[5]


def test_joint_that_others_wait_for_comes_first_and_goes_back_last(cabinet: Asset) -> None:
    assert order(cabinet, "lid_hinge") == ["lever_turn", "lid_hinge", "lid_hinge", "lever_turn"]
    assert order(cabinet, "tray_slide") == ["tray_slide", "tray_slide"]


def test_what_waits_for_what_waits_comes_last(cabinet: Asset) -> None:
    asset = changed(cabinet, tray_slide={"needs": Dependency(above("lid_hinge", 1.0)), "limits": (0.0, 0.2)})
    assert order(asset, "tray_slide") == [
        "lever_turn", "lid_hinge", "tray_slide", "tray_slide", "lid_hinge", "lever_turn",
    ]  # fmt: skip


def test_follower_that_waits_holds_its_leader(cabinet: Asset) -> None:
    asset = changed(cabinet, bolt_slide={"needs": Dependency(above("tray_slide", 0.1))})
    # the bolt stands off 0 at rest, so that it is blocked there already; what is blocked at rest may move
    assert order(asset, "lever_turn")[0] == "tray_slide"


def test_condition_on_a_follower_moves_its_leader(cabinet: Asset) -> None:
    asset = changed(cabinet, knob_slide={"needs": Dependency(below("bolt_slide", -0.005))})
    assert order(asset, "knob_slide") == ["lever_turn", "knob_slide", "knob_slide", "lever_turn"]


def test_joint_that_must_stand_between_is_put_there(cabinet: Asset) -> None:
    between = Condition("all", terms=(above("lever_turn", 0.3), below("lever_turn", 0.5)))
    asset = changed(cabinet, lid_hinge={"needs": Dependency(between)})
    stops = opening(asset, asset.joint("lid_hinge"))
    assert stops is not None
    assert stops[1]["lever_turn"] == pytest.approx(0.4)


def test_second_way_is_taken_where_the_first_is_barred(cabinet: Asset) -> None:
    either = Condition("any", terms=(above("lever_turn", 5.0), above("tray_slide", 0.1)))
    asset = changed(cabinet, lid_hinge={"needs": Dependency(either)})
    assert order(asset, "lid_hinge") == ["tray_slide", "lid_hinge", "lid_hinge", "tray_slide"]


@pytest.mark.parametrize(
    "needs",
    [
        {"lid_hinge": above("tray_slide", 0.1), "tray_slide": above("lid_hinge", 0.1)},
        {"lid_hinge": above("lever_turn", 3.0)},
        {"lid_hinge": above("foot_lock", 1.0)},
        {"lid_hinge": Condition("all", terms=(above("lever_turn", 0.5), below("lever_turn", 0.4)))},
    ],
    ids=["each other", "beyond its limit", "locked", "nowhere"],
)
def test_joint_that_cannot_move_has_no_animation_but_a_loss(cabinet: Asset, needs: dict) -> None:
    asset = changed(cabinet, **{name: {"needs": Dependency(what)} for name, what in needs.items()})
    written = write_glb(asset)
    names = [each["name"] for each in Gltf(written.files["cabinet_7.glb"]).data["animations"]]
    (loss,) = [loss for loss in written.losses if loss.feature == "animation"]
    assert loss.where.split(", ") == [joint.name for joint in asset.free_joints if joint.name not in names]
    assert "lid_hinge" in loss.where
    assert "dependencies" in loss.instead


def test_locked_condition_that_holds_asks_for_nothing(cabinet: Asset) -> None:
    asset = changed(cabinet, lid_hinge={"needs": Dependency(above("foot_lock", 0.1))})
    assert order(asset, "lid_hinge") == ["lid_hinge", "lid_hinge"]


def test_unlimited_joint_turns_once_round(cabinet: Asset) -> None:
    stops = opening(cabinet, cabinet.joint("dial_turn"))
    assert stops is not None
    assert [stop["dial_turn"] for stop in stops] == pytest.approx([0.0, 2 * np.pi])


@pytest.mark.parametrize(("ratio", "ends"), [(2.0, 2 * np.pi), (0.5, 0.0)])
def test_turn_goes_back_where_a_follower_has_not_come_round(nested: Asset, ratio: float, ends: float) -> None:
    asset = changed(nested, spin={"follows": Coupling("wrist", ratio, 0.1)})
    stops = opening(asset, asset.joint("wrist"))
    assert stops is not None
    assert stops[-1]["wrist"] == pytest.approx(ends)


def test_joint_that_rests_between_its_limits_goes_to_both(nested: Asset) -> None:
    stops = opening(nested, nested.joint("reach"))
    assert stops is not None
    assert [stop["reach"] for stop in stops] == [0.0, 0.3, -0.1, 0.0]


def test_unlimited_slide_goes_a_little_way_and_back(nested: Asset) -> None:
    asset = changed(nested, reach={"limits": None})
    stops = opening(asset, asset.joint("reach"))
    assert stops is not None
    assert [stop["reach"] for stop in stops] == [0.0, 0.2, 0.0]
