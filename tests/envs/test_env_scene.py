"""The scene: the exported asset, the place of the robot, and the allowed contacts."""

import mujoco
import numpy as np
import pytest

from artgen import generate
from artgen.asset.affordance import Affordance
from artgen.batch import Common
from artgen.envs.motion import Stage, Target
from artgen.envs.robot import HOME, LIMITS
from artgen.envs.scene import STEPS, TIME_STEP, TaskScene, compiled
from artgen.export.frames import apart
from support.manipulation import PULL
from support.proof_assets import bearing_door

STILL = np.zeros(7)


def aside(asset, joint, at=(0.0, -2.0, 0.0), start=None):
    """Return a target for a joint, with a robot too far away to touch anything."""
    frame = np.eye(4)
    base = np.eye(4)
    base[:3, 3] = at
    affordance = Affordance("there", "push", asset.joint(joint).child, frame, 0.0, (joint,))
    return Target((Stage(joint, 0.0, 0.5, affordance),), start or {}, base, HOME, np.eye(4))


@pytest.fixture(scope="module")
def drawer():
    return PULL.generate(0)


@pytest.fixture(scope="module")
def scene(drawer):
    return TaskScene(drawer, compiled(drawer))


@pytest.fixture(scope="module")
def door():
    asset = bearing_door()
    return TaskScene(asset, compiled(asset))


def test_the_asset_is_the_one_that_is_exported(drawer, scene, tmp_path):
    path = drawer.export(tmp_path, formats=("mjcf",), textures=0) / f"{drawer.name}.xml"
    exported = mujoco.MjModel.from_xml_path(str(path))
    for link in drawer.links:
        ours, theirs = scene.model.body(link.name), exported.body(link.name)
        for name in ("pos", "quat", "mass", "inertia", "ipos", "iquat"):
            np.testing.assert_allclose(getattr(ours, name), getattr(theirs, name), atol=1e-12, err_msg=name)
    for joint in drawer.joints:
        ours, theirs = scene.model.joint(joint.name), exported.joint(joint.name)
        for name in ("range", "axis", "pos", "stiffness", "solref", "solimp"):
            mine, other = (getattr(each, f"jnt_{name}") for each in (scene.model, exported))
            np.testing.assert_array_equal(mine[ours.id], other[theirs.id], err_msg=name)
        for name in ("damping", "frictionloss", "armature", "solref", "solimp"):
            mine, other = (getattr(each, f"dof_{name}") for each in (scene.model, exported))
            np.testing.assert_array_equal(mine[ours.dofadr[0]], other[theirs.dofadr[0]], err_msg=name)
    colliders = [number for number in range(exported.ngeom) if exported.geom_contype[number]]
    assert colliders
    for number in colliders:
        theirs = exported.geom(number)
        ours = scene.model.geom(theirs.name)
        for name in ("type", "size", "friction", "solref", "solimp"):
            np.testing.assert_allclose(getattr(ours, name), getattr(theirs, name), atol=1e-11, err_msg=name)


def test_visual_surfaces_do_not_change_the_physics(drawer, scene):
    seen = TaskScene(drawer, compiled(drawer, visual=True))
    assert seen.model.ngeom > scene.model.ngeom
    assert seen.model.nmesh > scene.model.nmesh
    target = PULL.target(drawer, np.random.default_rng(0))
    action = np.array([0.2, 0.5, -0.3, 0.1, 0.2, 0.3, 0.4])
    for each in (seen, scene):
        each.place(target, target.arm)
        for _ in range(10):
            each.act(action)
    np.testing.assert_array_equal(seen.data.qpos, scene.data.qpos)


def test_an_action_takes_a_twentieth_of_a_second(drawer, scene):
    target = PULL.target(drawer, np.random.default_rng(0))
    scene.place(target, target.arm)
    scene.act(STILL)
    assert scene.data.time == pytest.approx(0.05)
    assert pytest.approx(0.05) == STEPS * TIME_STEP


@pytest.mark.parametrize("height", [0.4, 0.0, -0.3])
def test_the_robot_is_on_the_floor_at_the_place_of_the_task(drawer, scene, height):
    target = aside(drawer, drawer.joints[0].name, (0.3, -2.0, height))
    scene.place(target, HOME)
    model, data = scene.model, scene.data
    np.testing.assert_allclose(data.body("robot_base").xpos, target.base[:3, 3])
    floor = data.geom("scene_floor").xpos[2]
    assert floor == min(0.0, height)
    pedestal = model.geom("robot_pedestal")
    low = data.geom("robot_pedestal").xpos[2] - pedestal.size[2]
    assert low == pytest.approx(floor, abs=0.03)
    np.testing.assert_allclose(data.qpos[scene.control.at], HOME)
    assert not data.ncon, "robot and furniture touch nothing"


def test_the_arm_begins_within_its_limits(drawer, scene):
    scene.place(aside(drawer, drawer.joints[0].name), LIMITS[:, 1] + 1.0)
    np.testing.assert_array_equal(scene.data.qpos[scene.control.at], LIMITS[:, 1])


def test_links_and_joints_agree_with_the_asset(door):
    asset = door.asset
    q = {"lever": 0.6, "hinge": 0.9}
    door.place(aside(asset, "hinge", start=q), HOME)
    assert {name: door.q(name) for name in q} == q
    assert door.q("bolt_slide") == pytest.approx(0.019 * 0.6), "followers are set with their leader"
    for link, pose in asset.pose(q).items():
        np.testing.assert_allclose(door.pose(link), pose, atol=1e-9, err_msg=link)
    point, step = np.array([0.7, 0.1, 1.0]), 1e-6
    moved = [
        asset.pose({**q, "hinge": q["hinge"] + shift})["leaf"]
        @ np.linalg.solve(asset.pose(q)["leaf"], np.append(point, 1.0))
        for shift in (0.0, step)
    ]
    np.testing.assert_allclose(door.motion("hinge", point), (moved[1] - moved[0])[:3] / step, atol=1e-5)


def test_only_links_that_hold_a_dependency_can_touch(door):
    free = {frozenset(pair) for pair in apart(door.asset)}
    assert frozenset(("frame", "bolt")) not in free, "the bolt holds the leaf"
    assert {frozenset(("frame", "leaf")), frozenset(("leaf", "handle")), frozenset(("leaf", "bolt"))} <= free
    assert len(apart(bearing_door(rule=False))) == 6, "without a dependency, all links are excluded"


def test_models_of_one_topology_have_the_same_constraints_and_exclusions():
    """Plain models of two doors differ in couplings, and in the links that can touch each other."""
    doors = [generate("door", seed, topology="fixed", certify=False) for seed in (0, 1)]
    apart_from_each_other = [compiled(each) for each in doors]
    together = [compiled(each, common=Common.of(doors)) for each in doors]
    for name in ("exclude_signature", "eq_type", "eq_obj1id", "eq_obj2id", "jnt_limited"):
        first, second = (getattr(model, name) for model in together)
        np.testing.assert_array_equal(first, second, err_msg=name)
    assert apart_from_each_other[0].neq != apart_from_each_other[1].neq, "the plain models differ"
    active = [model.eq_active0.sum() for model in together]
    assert active == [model.neq for model in apart_from_each_other], "each keeps its own couplings alone"


@pytest.mark.parametrize(("lever", "opens"), [(0.0, False), (0.3, False), (0.8, True)])
def test_the_latch_holds_until_the_lever_is_turned(door, lever, opens):
    door.place(aside(door.asset, "hinge", start={"lever": lever}), HOME)
    hinge, turn = (door.model.joint(name).dofadr[0] for name in ("hinge", "lever"))
    for _ in range(20):
        door.data.qfrc_applied[hinge], door.data.qfrc_applied[turn] = 20.0, 2.0 * lever
        door.act(STILL)
    assert (door.q("hinge") > 0.3) == opens, door.q("hinge")
    assert opens or door.q("hinge") < 0.02
