"""Tasks in a kitchen: the robot stands in the room, and the scripted policy does what they ask for."""

from itertools import islice

import fcl
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.asset.affordance import GRIPPER
from artgen.asset.manifolds import mesh_of
from artgen.colliders.polytope import Polytope
from artgen.envs import KITCHEN_TASKS, ManipulationEnv
from artgen.envs.placing import Obstacles
from artgen.envs.policy import ScriptedPolicy
from artgen.envs.reach import _across, _before, _beside, _leaning, _spun, hand_joints, stands
from artgen.envs.robot import BALL_JOINTS, BALL_PLACES, BALL_RADII, frames
from artgen.errors import EnvError
from artgen.export.frames import apart
from artgen.scene import Scene

DRAWERS = {"kind": "kitchen", "rows": 4, "columns": 1, "height": 0.86, "grip": "bar", "width": 0.5}


@pytest.fixture(scope="module")
def kitchen() -> Asset:
    """A refrigerator, a base unit with drawers, and a mill on the unit."""
    room = Scene("small", seed=3, width=2.6, depth=2.2, detail="low")
    cold = {"layout": "single", "width": 0.6, "crispers": 0, "ice_box": False, "swing": 1.6, "hand": "left"}
    _, unit = room.run("back", ("refrigerator", cold), ("drawer", DRAWERS), at=0.5, gap=0.05)
    room.on(unit, "pepper_grinder", deep=0.3, free=True)
    room.inside(unit, "drawer_0", "plier", at=0.3, turn=0.2)
    return room.build(category="kitchen")


@pytest.mark.parametrize(
    ("name", "joints"),
    [
        ("OpenKitchenDrawer", ["drawer_drawer_slide_2"]),
        ("OpenAndCloseFridge", ["refrigerator_door_hinge", "refrigerator_door_hinge"]),
    ],
)
def test_the_scripted_policy_does_it_from_a_place_in_the_room(
    kitchen: Asset, name: str, joints: list[str]
) -> None:
    env = ManipulationEnv(name, [kitchen])
    env.reset(seed=0)
    assert [stage.joint for stage in env.target.stages] == joints
    x, y, z = env.target.base[:3, 3]
    assert abs(x) < 1.3
    assert -2.2 < y < 0.0
    assert z >= 0.0
    policy, ended = ScriptedPolicy(env), False
    while not ended:
        _, _, success, ended, info = env.step(policy.action())
        ended |= success
    assert info["success"], info
    if name == "OpenAndCloseFridge":
        assert env.q("refrigerator_door_hinge") < 0.03
    env.close()


def test_free_bodies_of_a_room_can_touch_all(kitchen: Asset) -> None:
    pairs = apart(kitchen)
    assert pairs
    mill = [[name.startswith("pepper_grinder") for name in pair] for pair in pairs]
    assert not any(first != second for first, second in mill)


def test_the_floor_of_a_room_is_no_obstacle_and_its_walls_are(kitchen: Asset) -> None:
    obstacles = Obstacles(kitchen)
    assert obstacles.floor == pytest.approx(0.0, abs=1e-6)
    in_floor, in_wall = obstacles.depth(np.array([[0.9, -1.5, -0.04], [1.36, -1.0, 1.0]]), kitchen.pose())
    assert in_floor < 0.0 < in_wall


def test_every_joint_that_a_hand_moves_has_a_stand_or_a_reason(kitchen: Asset) -> None:
    names = [joint.name for joint in hand_joints(kitchen)]
    found = list(stands(kitchen))
    assert [each.joint for each in found] == names
    assert all((each.base is None) == bool(each.reason) for each in found)
    for each in found:
        data = each.to_data()
        assert ("reason" in data) != ("position" in data)
    assert sum(each.base is not None for each in found) >= len(found) / 2
    slide = next(each for each in found if each.joint == "drawer_drawer_slide_2")
    assert slide.way == 1.0
    # an arm reaches a thing in a drawer after it has opened the drawer
    jaw = next(each for each in found if each.joint == "plier_jaw_hinge")
    assert jaw.way == 1.0, jaw.reason
    assert jaw.start is not None
    assert jaw.start["drawer_drawer_slide_0"] > 0.1


def test_grasps_across_a_plate_close_on_its_thickness_from_its_edges() -> None:
    half = np.array([0.1, 0.08, 0.005])
    poses, openings = _across([Polytope.box(-half, half)])
    assert len(poses) >= 4
    assert openings == pytest.approx(GRIPPER.opening(0.01))
    assert np.abs(poses[:, 2, 0]) == pytest.approx(1.0)
    assert (np.abs(poses[:, :3, 3]) < half).all()
    assert ((poses[:, :3, 2] * poses[:, :3, 3]).sum(axis=1) < 0.0).all()


def test_a_leaning_finger_keeps_its_end() -> None:
    tips = _leaning(np.eye(4))
    ends = tips[:, :3, 3] + GRIPPER.tip * tips[:, :3, 2]
    assert ends == pytest.approx(np.tile([0.0, 0.0, GRIPPER.tip], (len(tips), 1)))
    assert tips[:, 2, 2].min() == pytest.approx(0.5)


def test_no_corner_of_a_leaning_finger_is_past_the_face_that_it_pushes() -> None:
    tips = _before(_leaning(np.eye(4)), np.array([0.0, 0.0, 1.0]))
    corners = [[x * GRIPPER.thick, y * GRIPPER.wide / 2.0, GRIPPER.tip] for x in (-1, 1) for y in (-1, 1)]
    ends = np.einsum("nij,kj->nki", tips[:, :3, :3], corners) + tips[:, None, :3, 3]
    assert ends[..., 2].max(axis=1) == pytest.approx(GRIPPER.tip)
    # the middle of the foremost edge, or the foremost corner, is at the end of an upright finger
    foremost = ends[..., 2:] > GRIPPER.tip - 1e-9
    middles = (ends * foremost).sum(axis=1) / foremost.sum(axis=1)
    assert middles[:, :2] == pytest.approx(0.0, abs=1e-9)


def test_the_side_of_a_finger_touches_the_edge_that_it_hooks() -> None:
    local = np.linalg.inv(_beside(np.eye(4)))[:, :3, 3]  # the edge, seen from each tip
    aside = np.abs(local[:, :2]) / (GRIPPER.thick, GRIPPER.wide / 2.0)
    assert aside.max(axis=1) == pytest.approx(1.0)
    assert aside.min(axis=1) == pytest.approx(0.0)
    assert (local[:, 2] < GRIPPER.tip).all()


def test_a_hand_that_turns_on_a_part_keeps_its_contact() -> None:
    about, turns = np.array([0.1, 0.2, 0.3]), np.array([[0.0, 0.0, 0.0], [0.0, 0.7, 0.0]])
    tips = _leaning(np.eye(4))
    spun = _spun(tips, about, turns)
    assert spun[:, 0] == pytest.approx(tips)
    seen = [np.linalg.inv(poses) @ [*about, 1.0] for poses in (spun[:, 0], spun[:, 1])]
    assert seen[1] == pytest.approx(seen[0])
    assert (spun[:, 1, :3, :3] @ np.swapaxes(tips[:, :3, :3], 1, 2))[:, 0, 0] == pytest.approx(np.cos(0.7))


def test_a_room_without_the_part_is_refused() -> None:
    room = Scene("bare", seed=1, width=1.6, depth=1.4, detail="low")
    room.against("back", "drawer", at=0.5, kind="bedside", rows=1, width=0.45, depth=0.42)
    bare = room.build(category="kitchen")
    for task in KITCHEN_TASKS.values():
        with pytest.raises(EnvError, match="that a hand can grasp; take another seed"):
            next(iter(task.choose(bare, np.random.default_rng(0))))


def test_the_arm_of_a_stand_strikes_nothing_and_follows_the_part(kitchen: Asset) -> None:
    """Distances by FCL, and poses of the tip by the kinematics, at the stored angles."""
    index = next(n for n, joint in enumerate(hand_joints(kitchen)) if joint.name == "refrigerator_door_hinge")
    first = next(islice(stands(kitchen), index, None))
    assert first.way == 1.0
    for each in (first, *first.then):
        assert each.base is not None
        assert each.at is not None
        assert each.path is not None
        assert each.tip is not None
        assert len(each.at) == len(each.path)
        for number, (at, angles) in enumerate(zip(each.at, each.path, strict=True)):
            pose = kitchen.pose({**(each.start or {}), each.joint: at})
            arm = each.base @ frames(angles[None])[0]
            if number > 1:  # after the approach
                assert np.allclose(arm[7], pose[each.link] @ each.tip, atol=5e-3)
            balls = [
                fcl.CollisionObject(
                    fcl.Sphere(radius), fcl.Transform(arm[joint, :3, :3] @ place + arm[joint, :3, 3])
                )
                for joint, place, radius in zip(BALL_JOINTS, BALL_PLACES, BALL_RADII, strict=True)
            ]
            for link in kitchen.links:
                for collider in link.colliders:
                    if collider.label == "floor":
                        continue
                    points, triangles = mesh_of(collider.convex.transformed(pose[link.name]).manifold())
                    faces = np.insert(triangles, 0, 3, axis=1).ravel()
                    solid = fcl.CollisionObject(
                        fcl.Convex(np.ascontiguousarray(points), len(triangles), faces)
                    )
                    assert not any(fcl.collide(ball, solid) for ball in balls), collider.label
