"""The arm: robosuite's law of control, and hands that go where they are message to."""

import logging
import os
import subprocess
import sys
import warnings
from types import SimpleNamespace

import mujoco
import numba
import numpy as np
import pytest

import artgen
from artgen.asset import rotation
from artgen.envs import TASKS, ManipulationEnv, robot
from artgen.envs.robot import HAND, HOME, OPENING, PREFIX, Control, panda
from artgen.errors import EnvError

ALONE = "ARTGEN_TEST_ALONE"
"""Tells a test that the process is its own."""


@pytest.fixture(scope="module")
def arm():
    spec = mujoco.MjSpec()
    spec.option.timestep = 0.0025
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.attach(panda(visual=False), frame=spec.worldbody.add_frame(), prefix=PREFIX)
    model = spec.compile()
    return model, mujoco.MjData(model)


def at_home(arm, speeds=None):
    model, data = arm
    mujoco.mj_resetData(model, data)
    data.qpos[:7] = HOME
    if speeds is not None:
        data.qvel[:7] = speeds
    mujoco.mj_forward(model, data)
    control = Control(model, data)
    control.begin()
    return control


def theirs(model, data):
    """Return the controller of robosuite; its way to read the state is adapted to MuJoCo 4."""
    logging.disable(logging.WARNING)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            from robosuite.controllers.parts.arm.osc import OperationalSpaceController
    finally:
        logging.disable(logging.NOTSET)

    class Controller(OperationalSpaceController):
        def update(self, force=False):  # noqa: FBT002 - robosuite's signature
            whole, full = np.zeros((6, model.nv)), np.zeros((model.nv, model.nv))
            site = model.site(self.ref_name).id
            mujoco.mj_jacSite(model, data, whole[:3], whole[3:], site)
            mujoco.mj_fullM(model, data, full)
            self.J_full, self.mass_matrix = whole[:, :7], full[:7, :7]
            self.J_pos, self.J_ori = self.J_full[:3], self.J_full[3:]
            self.joint_pos, self.joint_vel = data.qpos[:7].copy(), data.qvel[:7].copy()
            self.ref_pos, self.ref_ori_mat = data.site_xpos[site], data.site_xmat[site].reshape(3, 3)
            self.ref_pos_vel = self.J_pos @ self.joint_vel
            self.ref_ori_vel = self.J_ori @ self.joint_vel

    still = np.zeros(3)
    state = SimpleNamespace(
        qfrc_bias=data.qfrc_bias, get_site_xvelp=lambda name: still, get_site_xvelr=lambda name: still
    )
    names = SimpleNamespace(joint_id2name=lambda number: model.joint(number).name)
    result = Controller(
        SimpleNamespace(model=names, data=state, forward=lambda: None),
        ref_name=f"{PREFIX}{HAND}grip_site",
        joint_indexes={"joints": range(7), "qpos": range(7), "qvel": range(7)},
        actuator_range=(-np.ones(7), np.ones(7)),
        input_ref_frame="world",
        kp=300,
        part_name="right",
        naming_prefix=PREFIX,
    )
    result.update()
    result.reset_goal()
    return result


@pytest.mark.long
def test_the_torques_are_those_of_robosuite(arm, monkeypatch):
    if ALONE not in os.environ:  # what robosuite imports, and how, depends on what is there already
        itself = f"{__file__}::test_the_torques_are_those_of_robosuite"
        clean = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
        done = subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", itself],
            capture_output=True,
            text=True,
            check=False,
            env={**clean, ALONE: "1"},
        )
        assert done.returncode == 0, done.stdout
        assert "1 passed" in done.stdout
        return
    monkeypatch.setenv("MUJOCO_GL", "disabled")  # robosuite chooses OpenGL for everybody where nobody has
    monkeypatch.setattr(numba, "jit", lambda **_: lambda function: function)  # compiles for half a minute
    rng = np.random.default_rng(3)
    for _ in range(5):
        speeds = 0.3 * rng.normal(size=7)
        ours = at_home(arm, speeds)
        other = theirs(*arm)
        action = rng.uniform(-1.0, 1.0, 6)
        ours.aim(action)
        other.set_goal(action)
        arm[1].qpos[:7] += 0.05 * rng.normal(size=7)  # the arm has gone on since
        mujoco.mj_forward(*arm)
        ours.run()
        other.new_update = True
        expected = other.run_controller()
        assert np.abs(expected).max() > 1.0
        np.testing.assert_allclose(arm[1].ctrl[:7], expected, atol=1e-4)


def go(arm, control, action, steps):
    model, data = arm
    for _ in range(steps):
        control.aim(np.array(action, float))
        for _ in range(5):
            control.run()
            mujoco.mj_step(model, data, nstep=4)
            mujoco.mj_forward(model, data)


def test_the_arm_does_not_move_without_an_action(arm):
    control = at_home(arm)
    before = arm[1].site_xpos[control.tip].copy()
    go(arm, control, np.zeros(6), 40)
    assert np.abs(arm[1].site_xpos[control.tip] - before).max() < 1e-4
    assert np.abs(arm[1].qpos[:7] - HOME).max() < 1e-3


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_tip_moves_along_the_axes_of_the_world(arm, axis):
    control = at_home(arm)
    before = arm[1].site_xpos[control.tip].copy()
    go(arm, control, np.eye(6)[axis], 10)
    moved = arm[1].site_xpos[control.tip] - before
    assert 0.08 < moved[axis] < 0.2
    assert np.abs(np.delete(moved, axis)).max() < 0.1 * moved[axis]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_tip_turns_about_the_axes_of_the_world(arm, axis):
    control = at_home(arm)
    before = arm[1].site_xmat[control.tip].reshape(3, 3).copy()
    go(arm, control, 0.3 * np.eye(6)[3 + axis], 10)
    turn = arm[1].site_xmat[control.tip].reshape(3, 3) @ before.T
    angle = np.arccos((np.trace(turn) - 1.0) / 2.0)
    assert 0.15 < angle < 0.6
    np.testing.assert_allclose(turn, rotation(np.eye(3)[axis], angle), atol=0.08)


def test_the_parts_of_the_arm_do_not_collide_with_each_other(arm):
    model, data = arm
    at_home(arm)
    data.qpos[:7] = [0.0, -1.7, 0.0, -3.0, 0.0, 0.0, 0.0]  # folded into itself
    mujoco.mj_forward(model, data)
    assert data.ncon == 0


def test_it_is_a_panda_of_seven_joints_and_two_fingers_without_pictures(arm):
    model, _ = arm
    assert model.nv == 9
    np.testing.assert_allclose(model.jnt_range[:7], robot.LIMITS)
    assert model.jnt_range[7, 1] == pytest.approx(OPENING)
    assert {model.geom(number).contype[0] for number in range(model.ngeom)} == {robot.ROBOT_BIT}
    assert panda(visual=True).compile().ngeom > model.ngeom


def test_missing_robosuite_is_one_clear_error(monkeypatch):
    monkeypatch.setattr(robot, "find_spec", lambda name: None)
    with pytest.raises(EnvError, match=r"comes with robosuite: pip install 'artgen\[envs\]'"):
        panda(visual=False)


@pytest.mark.parametrize("name", ["OpenLaptop", "OpenDrawer"])
def test_the_hand_stops_at_the_floor_below_a_table_and_without_one(name):
    env = ManipulationEnv(name, range(4, 5))
    env.reset(seed=0)
    floor = float(env.model.geom("scene_floor").pos[2])
    assert (floor < 0.0) == env.task.raised
    for _ in range(120):
        env.step(np.array([0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0]))
    assert floor - 0.002 < env.tip()[2, 3] < floor + 0.03
    env.close()


@pytest.mark.parametrize("name", ["OpenDrawer", "OpenLaptop"])
def test_a_free_asset_stands_on_the_floor_or_its_table(name):
    task = TASKS[name]
    asset = artgen.generate(task.category, 4, base="free", certify=False, **task.overrides)
    env = ManipulationEnv(name, [asset])
    env.reset(seed=0)
    for _ in range(20):
        env.step(np.zeros(7))
    assert abs(env.scene.pose(asset.links[0].name)[2, 3]) < 0.002
    assert not env.reached()[0]
    env.close()
