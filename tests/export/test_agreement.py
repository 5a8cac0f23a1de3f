"""Three independent readers agree with the asset: yourdfpy, pinocchio and MuJoCo."""

import logging
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pinocchio
import pytest
import yourdfpy
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.export import export

Array = NDArray[np.float64]
Draw = Callable[[Asset, int], dict[str, float]]

SEEDS = range(20)


@pytest.fixture(scope="module")
def directory(asset: Asset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return export(asset, tmp_path_factory.mktemp("agreement") / asset.name, formats=("urdf", "mjcf"))


@pytest.fixture(scope="module")
def urdf(asset: Asset, directory: Path) -> yourdfpy.URDF:
    return yourdfpy.URDF.load(str(directory / f"{asset.name}.urdf"), load_collision_meshes=True)


@pytest.fixture(scope="module")
def pin(asset: Asset, directory: Path) -> pinocchio.Model:
    return pinocchio.buildModelFromUrdf(str(directory / f"{asset.name}.urdf"))


@pytest.fixture(scope="module", params=["xml", "urdf"])
def model(asset: Asset, directory: Path, request: pytest.FixtureRequest) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.{request.param}"))


def frames(asset: Asset, q: dict[str, float]) -> dict[str, Array]:
    """Return where each link's frame is, from the asset's pose alone."""
    result = {}
    for name, displacement in asset.pose(q).items():
        result[name] = displacement.copy()
        result[name][:3, 3] += displacement[:3, :3] @ asset.origin(name)
    return result


def pinocchio_configuration(pin: pinocchio.Model, positions: dict[str, float]) -> Array:
    q = pinocchio.neutral(pin)
    for name, index, length in zip(pin.names[1:], pin.idx_qs[1:], pin.nqs[1:], strict=True):
        value = positions[name]
        q[index : index + length] = [value] if length == 1 else [np.cos(value), np.sin(value)]
    return q


def mujoco_state(model: mujoco.MjModel, positions: dict[str, float]) -> mujoco.MjData:
    data = mujoco.MjData(model)
    for index in range(model.njnt):
        if model.jnt_type[index] != mujoco.mjtJoint.mjJNT_FREE:
            data.qpos[model.jnt_qposadr[index]] = positions[model.joint(index).name]
    mujoco.mj_kinematics(model, data)
    return data


@pytest.mark.parametrize("seed", SEEDS)
def test_yourdfpy_puts_every_link_where_the_asset_has_it(
    asset: Asset, urdf: yourdfpy.URDF, draw_positions: Draw, seed: int
) -> None:
    q = draw_positions(asset, seed)
    urdf.update_cfg({name: asset.positions(q)[name] for name in urdf.actuated_joint_names})
    for name, expected in frames(asset, q).items():
        np.testing.assert_allclose(urdf.get_transform(name), expected, atol=1e-6)


@pytest.mark.parametrize("seed", SEEDS)
def test_pinocchio_puts_every_link_where_the_asset_has_it(
    asset: Asset, pin: pinocchio.Model, draw_positions: Draw, seed: int
) -> None:
    q = draw_positions(asset, seed)
    data = pin.createData()
    pinocchio.framesForwardKinematics(pin, data, pinocchio_configuration(pin, asset.positions(q)))
    for name, expected in frames(asset, q).items():
        found = data.oMf[pin.getFrameId(name, pinocchio.FrameType.BODY)].homogeneous
        np.testing.assert_allclose(found, expected, atol=1e-6)


@pytest.mark.parametrize("seed", SEEDS)
def test_mujoco_puts_every_link_where_the_asset_has_it(
    asset: Asset, model: mujoco.MjModel, draw_positions: Draw, seed: int
) -> None:
    q = draw_positions(asset, seed)
    data = mujoco_state(model, asset.positions(q))
    names = {model.body(index).name for index in range(model.nbody)}
    found = {name: expected for name, expected in frames(asset, q).items() if name in names}
    # MuJoCo joins links that are fixed to one another when it reads URDF
    assert len(found) >= len(asset.links) - 2
    for name, expected in found.items():
        np.testing.assert_allclose(data.body(name).xpos, expected[:3, 3], atol=1e-6)
        np.testing.assert_allclose(data.body(name).xmat.reshape(3, 3), expected[:3, :3], atol=1e-6)


def test_masses_and_inertias_agree(asset: Asset, directory: Path, urdf: yourdfpy.URDF) -> None:
    model = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.xml"))
    for link in asset.links:
        expected = link.mass_properties
        center = expected.center - asset.origin(link.name)
        inertial = urdf.link_map[link.name].inertial
        assert inertial.mass == pytest.approx(expected.mass, rel=1e-9)
        np.testing.assert_allclose(inertial.origin[:3, 3], center, atol=1e-9)
        np.testing.assert_allclose(inertial.inertia, expected.inertia, rtol=1e-9, atol=1e-12)
        body = model.body(link.name)
        assert body.mass[0] == pytest.approx(expected.mass, rel=1e-9)
        np.testing.assert_allclose(body.ipos, center, atol=1e-9)
        axes = np.empty(9)
        mujoco.mju_quat2Mat(axes, body.iquat)
        axes = axes.reshape(3, 3)
        np.testing.assert_allclose(
            axes @ np.diag(body.inertia) @ axes.T, expected.inertia, rtol=1e-6, atol=1e-9
        )


def test_pinocchio_sees_the_asset_weigh_what_it_weighs(asset: Asset, directory: Path) -> None:
    """The base counts only where it may move; bodies between joints and grasp marks add a millionth."""
    path = str(directory / f"{asset.name}.urdf")
    pin = pinocchio.buildModelFromUrdf(path, pinocchio.JointModelFreeFlyer())
    data = pin.createData()
    positions = asset.positions()
    q = pinocchio.neutral(pin)
    for name, index, length in zip(pin.names[2:], pin.idx_qs[2:], pin.nqs[2:], strict=True):
        q[index : index + length] = (
            [positions[name]] if length == 1 else [np.cos(positions[name]), np.sin(positions[name])]
        )
    center = pinocchio.centerOfMass(pin, data, q)
    moved = dict(asset.pose().items())
    mass = sum(link.mass_properties.mass for link in asset.links)
    expected = (
        sum(
            link.mass_properties.mass
            * (moved[link.name][:3, :3] @ link.mass_properties.center + moved[link.name][:3, 3])
            for link in asset.links
        )
        / mass
    )
    assert data.mass[0] == pytest.approx(mass, abs=1e-5)
    np.testing.assert_allclose(center, expected, atol=1e-6)


def test_limits_and_axes_agree(asset: Asset, directory: Path, urdf: yourdfpy.URDF) -> None:
    model = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.xml"))
    for joint in asset.joints:
        read = urdf.joint_map[joint.name]
        if joint.locked:
            assert read.type == "fixed"
            continue
        np.testing.assert_allclose(read.axis, joint.axis, atol=1e-9)
        assert (read.limit.effort, read.limit.velocity) == (joint.effort, joint.velocity)
        seen = model.joint(joint.name)
        assert bool(model.jnt_limited[seen.id]) == (joint.limits is not None)
        if joint.limits is None:
            assert read.type == "continuous"
        else:
            np.testing.assert_allclose((read.limit.lower, read.limit.upper), joint.limits, atol=1e-9)
            np.testing.assert_allclose(seen.range, joint.limits, atol=1e-9)


# yourdfpy calls trimesh in a way that trimesh is about to drop, whatever the file
@pytest.mark.filterwarnings("ignore:.*Scene.dump:DeprecationWarning")
def test_every_reader_is_silent(
    asset: Asset,
    directory: Path,
    capfd: pytest.CaptureFixture[str],
    caplog: pytest.LogCaptureFixture,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    """No warning, no log entry and nothing on the standard streams; pytest makes errors of warnings."""
    monkeypatch.chdir(tmp_path)  # where MuJoCo would write its log
    with caplog.at_level(logging.INFO):
        path = str(directory / f"{asset.name}.urdf")
        robot = yourdfpy.URDF.load(path, load_collision_meshes=True, build_collision_scene_graph=True)
        assert robot.validate()
        pinocchio.buildModelsFromUrdf(path, [str(directory)])
        for suffix in ("urdf", "xml"):
            model = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.{suffix}"))
            mujoco.mj_step(model, mujoco.MjData(model))
    captured = capfd.readouterr()
    assert captured.out == ""
    assert captured.err == ""
    assert [record.getMessage() for record in caplog.records] == []
    assert list(tmp_path.iterdir()) == []
