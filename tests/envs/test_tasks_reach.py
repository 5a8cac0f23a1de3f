"""Placing of the robot: kinematics of the arm, and collisions."""

from itertools import pairwise

import mujoco
import numpy as np
import pytest

import artgen
from artgen import asset as of
from artgen.envs.motion import between, rotation_vector
from artgen.envs.placing import Obstacles
from artgen.envs.robot import BALL_JOINTS, LIMITS, PREFIX, frames, panda, reach


@pytest.fixture(scope="module")
def postures():
    return np.random.default_rng(3).uniform(LIMITS[:, 0] + 0.2, LIMITS[:, 1] - 0.2, (40, 7))


def test_kinematics_are_those_of_the_model(postures):
    model = panda(visual=False).compile()
    data = mujoco.MjData(model)
    poses = frames(postures)
    for angles, found in zip(postures[:5], poses, strict=False):
        data.qpos[:7] = angles
        mujoco.mj_forward(model, data)
        tip = data.site("hand_grip_site")
        assert np.allclose(found[7, :3, 3], tip.xpos, atol=1e-6)
        assert np.allclose(found[7, :3, :3], tip.xmat.reshape(3, 3), atol=1e-3)  # the file has three digits
        for number in range(7):
            body = data.body(f"link{number + 1}")
            assert np.allclose(found[number, :3, 3], body.xpos, atol=1e-6)
    assert PREFIX  # in a scene every name begins with it
    assert BALL_JOINTS.max() < 7


def test_inverse_kinematics_reach_nearby_poses_within_the_limits(postures):
    rng = np.random.default_rng(0)
    tips = frames(np.clip(postures + rng.uniform(-0.2, 0.2, postures.shape), *LIMITS.T))[:, 7]
    angles, miss = reach(postures, tips, 40)
    assert (miss < 2e-3).mean() > 0.9
    assert ((angles >= LIMITS[:, 0]) & (angles <= LIMITS[:, 1])).all()
    assert np.allclose(frames(angles[miss < 2e-3])[:, 7, :3, 3], tips[miss < 2e-3, :3, 3], atol=2e-3)


def test_the_path_between_poses_is_straight_and_even():
    first, second = np.eye(4), np.eye(4)
    second[:3, :3] = of.rotation(np.array([0.0, 0.6, 0.8]), 2.0)
    second[:3, 3] = [0.3, 0.0, 0.0]
    way = [first, *between(first, second, 0.1, 0.3), second]
    turns = [np.linalg.norm(rotation_vector(b[:3, :3] @ a[:3, :3].T)) for a, b in pairwise(way)]
    assert turns == pytest.approx([2.0 / 7.0] * 7)
    assert [pose[0, 3] for pose in way] == pytest.approx(np.linspace(0.0, 0.3, 8))


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.6, 0.0, -0.8)])
def test_the_vector_of_half_a_turn(axis):
    vector = rotation_vector(of.rotation(np.array(axis), np.pi))
    assert np.allclose(np.abs(vector), np.pi * np.abs(axis), atol=1e-6)


@pytest.fixture(scope="module")
def plank():
    @artgen.generator
    def plank() -> artgen.Body:
        """A thin plank along x."""
        return artgen.part(artgen.box(1.0, 0.01, 0.2).at(z=0.1), "plank", artgen.material("oak"))

    return Obstacles(plank.generate(0))


BOX = np.array([[-0.1, -0.02, -0.03], [0.1, 0.02, 0.03]])


def posed(x, y, z, turn=0.0):
    pose = np.eye(4)
    pose[:3, :3] = of.rotation(np.array([0.0, 0.0, 1.0]), turn)
    pose[:3, 3] = x, y, z
    return pose


@pytest.mark.parametrize(
    ("frame", "touches"),
    [
        (posed(0.0, 0.0, 0.1), True),  # through it, although no corner is inside
        (posed(0.0, 0.0, 0.1, np.pi / 2), True),
        (posed(0.0, 0.03, 0.1), False),
        (posed(0.0, 0.03, 0.1, np.pi / 2), True),  # it is 0.1 m long that way
        (posed(0.0, 0.0, 0.22), True),
        (posed(0.0, 0.0, 0.24), False),
        (posed(0.57, 0.08, 0.1, np.pi / 4), False),  # the boxes around both overlap, they do not
    ],
)
def test_overlap_of_a_box_with_the_asset(plank, frame, touches):
    assert plank.touch(BOX, frame, plank.asset.pose()) is touches


def test_depth_of_points(plank):
    points = np.array([[0.0, 0.0, 0.1], [0.0, 0.1, 0.1], [0.6, 0.0, 0.1]])
    assert plank.depth(points, plank.asset.pose()) == pytest.approx([0.005, -0.095, -0.1])


def test_a_table_is_an_obstacle_below_the_asset(plank):
    raised = Obstacles(plank.asset, raised=True)
    below, pose = np.array([[0.0, 0.0, -0.3]]), plank.asset.pose()
    assert raised.depth(below, pose)[0] > 0.0 > plank.depth(below, pose)[0]
    assert raised.floor < plank.floor == pytest.approx(0.0)
