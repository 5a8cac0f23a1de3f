"""Closed chains in files: a pin in MJCF and USD, free joints in URDF, laws as data everywhere."""

import json

import mujoco
import numpy as np
import pytest
import yourdfpy
from pxr import Usd, UsdPhysics

from artgen.asset import Asset
from artgen.asset.valid_states import ValidStates
from artgen.batch import specs
from artgen.validate.readback import check_formats
from support.linkages import four_bar, gap, made

LIMITS = (-1.2, 1.2)
NAMES = ("crank_turn", "rod_turn", "rocker_turn")


@pytest.fixture(scope="module")
def linkage():
    return made(four_bar(limits=LIMITS, friction=0.002, damping=0.001, effort=0.3))


@pytest.fixture(scope="module")
def folder(linkage, tmp_path_factory):
    path = tmp_path_factory.mktemp("loop") / "made"
    linkage.export(path, formats=("urdf", "mjcf", "usd", "glb"), textures=0)
    return path


def test_an_export_keeps_the_chain(linkage, folder):
    back = Asset.load(folder)
    assert back.to_data()["loops"] == linkage.rounded().to_data()["loops"]
    assert back.joints["rod_turn"].follows == linkage.rounded().joints["rod_turn"].follows
    assert gap(back, {"crank_turn": 0.9}) < 1e-9
    wanted = linkage.valid_states.positions([[0.4], [-1.0]])
    for name in ("made.urdf", "made.xml", "made.usda", "made.glb", "asset.json"):
        np.testing.assert_allclose(
            ValidStates.read(folder / name).positions([[0.4], [-1.0]]), wanted, atol=1e-9
        )
    for check in check_formats(back, folder):
        assert not check.faults, check


def test_each_format_says_what_it_cannot(folder):
    formats = json.loads((folder / "asset.json").read_text())["formats"]
    found = {
        name: [loss["instead"] for loss in form["losses"] if loss["feature"] == "closed chain"]
        for name, form in formats.items()
    }
    assert {name: len(instead) for name, instead in found.items()} == {
        "urdf": 1,
        "mjcf": 0,
        "usd": 1,
        "glb": 0,
    }
    assert "artgen_states" in found["urdf"][0]


def test_mujoco_moves_the_chain_as_its_law_says(linkage, folder):
    model = mujoco.MjModel.from_xml_path(str(folder / "made.xml"))
    data = mujoco.MjData(model)
    at = {name: model.joint(name).qposadr[0] for name in NAMES}
    dof = model.joint("crank_turn").dofadr[0]
    reached, worst = [], dict.fromkeys(NAMES[1:], 0.0)
    for step in range(600):
        data.qfrc_applied[dof] = 0.01 * np.sin(2 * np.pi * step / 250)
        mujoco.mj_step(model, data)
        reached.append(float(data.qpos[at["crank_turn"]]))
        wanted = {name: linkage.joints[name].follows.at(reached[-1]) for name in worst}
        for name in worst:
            worst[name] = max(worst[name], abs(float(data.qpos[at[name]]) - wanted[name]))
    assert np.ptp(reached) > 1.2  # half of its range, at up to 13 rad/s
    for name, error in worst.items():
        low, high = linkage.joints[name].limits
        assert error < 0.01 * (high - low)


def test_usd_has_a_pin_outside_the_articulation(linkage, folder):
    stage = Usd.Stage.Open(str(folder / "made.usda"))
    pins = [
        UsdPhysics.RevoluteJoint(prim)
        for prim in stage.Traverse()
        if prim.IsA(UsdPhysics.Joint) and UsdPhysics.Joint(prim).GetExcludeFromArticulationAttr().Get()
    ]
    (pin,) = pins
    bodies = [relation.GetTargets()[0].name for relation in (pin.GetBody0Rel(), pin.GetBody1Rel())]
    assert tuple(bodies) == linkage.loops[0].links
    for name, attribute in zip(bodies, (pin.GetLocalPos0Attr(), pin.GetLocalPos1Attr()), strict=True):
        place = linkage.origin(name) + np.array(attribute.Get())
        np.testing.assert_allclose(place, linkage.loops[0].point, atol=1e-7)
    mimics = [prim.GetName() for prim in stage.Traverse() if "Mimic" in str(prim.GetMetadata("apiSchemas"))]
    assert mimics == []


def test_urdf_leaves_the_joints_of_the_chain_free(linkage, folder):
    robot = yourdfpy.URDF.load(str(folder / "made.urdf"), load_meshes=False, build_scene_graph=True)
    assert sorted(robot.actuated_joint_names) == sorted(NAMES)
    positions = linkage.positions({"crank_turn": 0.8})
    robot.update_cfg({name: positions[name] for name in NAMES})
    frames = dict(zip(linkage.links.names, linkage.fk([0.8]), strict=True))
    for name in ("rod", "rocker"):
        np.testing.assert_allclose(robot.get_transform(name, "ground"), frames[name], atol=1e-9)
    states = ValidStates.read(folder / "made.urdf")
    assert states.dofs == ("crank_turn",)


def test_a_missing_pin_is_found(folder, tmp_path):
    back = Asset.load(folder)
    for file in folder.rglob("*"):
        if file.is_file():
            target = tmp_path / file.relative_to(folder)
            target.parent.mkdir(exist_ok=True, parents=True)
            text = file.read_bytes()
            if file.suffix == ".xml":
                text = text.replace(b'<connect body1="rod"', b'<connect body1="crank"')
            if file.suffix == ".usda":
                text = text.replace(b"excludeFromArticulation = 1", b"excludeFromArticulation = 0")
                text = text.replace(b"excludeFromArticulation = true", b"excludeFromArticulation = false")
            target.write_bytes(text)
    failed = {each.check: str(each.faults) for each in check_formats(back, tmp_path) if each.faults}
    assert set(failed) == {"mjcf", "usd"}
    assert "connects links otherwise than the 1 closed chains" in failed["mjcf"]
    assert "no pin closes their chain" in failed["usd"]


def test_models_of_a_batch_keep_the_pin(linkage):
    (spec,) = specs([linkage])
    model = spec.compile()
    assert [int(kind) for kind in model.eq_type] == [int(mujoco.mjtEq.mjEQ_CONNECT)]
