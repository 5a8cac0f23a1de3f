"""What MolmoSpaces reads in the layout `molmospaces`, by the rules of its documentation and code."""

import json
from pathlib import Path

import mujoco
import numpy as np
import pytest

import artgen
from artgen.asset import Asset
from artgen.dataset import Plan, generate_many
from artgen.export import export


@pytest.fixture(scope="module")
def fridge() -> Asset:
    return artgen.generate("refrigerator", 0, certify=False)


@pytest.fixture(scope="module")
def folder(fridge: Asset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return export(fridge, tmp_path_factory.mktemp("library"), layout="molmospaces", textures=0)


def read(path: Path) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))


def grasps_of(folder: Path, name: str) -> dict[str, np.ndarray]:
    index = read(folder / "grasps_index.json")
    paths = index["articulated_grasp_paths"]["droid"][name]
    return {joint: np.load(folder / path)["transforms"] for joint, path in paths.items()}


def test_the_index_leads_to_object_and_metadata(fridge: Asset, folder: Path) -> None:
    (entry,) = read(folder / "assets_index.json").values()
    assert set(entry) == {"uid", "object_path", "metadata_path", "metadata_npz_path"}
    assert Path(entry["object_path"]).stem == entry["uid"] == fridge.name
    data = read(folder / entry["metadata_path"])
    assert data["assetId"] == fridge.name
    assert data["synset"] == "refrigerator.n.01"
    assert data["mass"] == pytest.approx(fridge.mass, rel=1e-6)
    low, high = fridge.bounds()
    assert all(data["boundingBox"][axis] >= (high - low)[i] - 1e-6 for i, axis in enumerate("xyz"))
    assert set(data["description_short"]) == {"one_word", "two_words", "three_words"}
    assert data["description_long"].startswith("A silver refrigerator. Its moving parts: ")


def test_the_object_is_attached_as_the_samplers_do_it(fridge: Asset, folder: Path) -> None:
    (entry,) = read(folder / "assets_index.json").values()
    spec = mujoco.MjSpec.from_file(str(folder / entry["object_path"]))
    (body,) = spec.worldbody.bodies
    scene = mujoco.MjSpec()
    scene.worldbody.add_frame(pos=(1.0, 0.0, 0.0)).attach_body(body, "added/", "")
    model = scene.compile()
    assert {model.joint(number).name for number in range(model.njnt)} == {
        f"added/{joint.name}" for joint in fridge.joints if not joint.locked
    }


def test_grasps_of_a_joint_stay_on_its_body_and_open_along_y(fridge: Asset, folder: Path) -> None:
    (entry,) = read(folder / "assets_index.json").values()
    model = mujoco.MjModel.from_xml_path(str(folder / entry["object_path"]))
    data = mujoco.MjData(model)
    found = grasps_of(folder, fridge.name)
    q = {joint.name: 0.3 * joint.limits[1] for joint in fridge.free_joints if joint.name in found}
    assert q
    for name, position in q.items():
        data.joint(name).qpos[:] = position
    mujoco.mj_kinematics(model, data)
    poses = fridge.pose(q)
    checked = 0
    for joint, frames in found.items():
        body = model.joint(joint).bodyid[0]
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = data.xmat[body].reshape(3, 3), data.xpos[body]
        wanted = [
            poses[each.link] @ each.frame
            for each in fridge.affordances
            if each.kind == "grasp" and each.joints[:1] == (joint,)
        ]
        for frame in pose @ frames:
            near = [each for each in wanted if np.abs(each[:3, 3] - frame[:3, 3]).max() < 1e-5]
            assert any(
                np.abs(each[:3, 0] - frame[:3, 1]).max() < 1e-5  # the fingers open along y
                and np.abs(each[:3, 2] - frame[:3, 2]).max() < 1e-5
                for each in near
            )
            assert np.linalg.det(frame[:3, :3]) == pytest.approx(1.0)
            checked += 1
    assert checked >= len(q)


def test_a_dataset_is_one_library(tmp_path: Path) -> None:
    plan = Plan(("drawer", "lamp"), 2, layout="molmospaces", textures="none", certify=False)
    generate_many(plan, tmp_path / "set", jobs=1)
    index = read(tmp_path / "set" / "assets_index.json")
    assert set(index) == {"drawer_0", "lamp_0"}
    for entry in index.values():
        assert (tmp_path / "set" / entry["object_path"]).is_file()
        assert (tmp_path / "set" / entry["metadata_path"]).is_file()
    for name, joints in read(tmp_path / "set" / "grasps_index.json")["articulated_grasp_paths"][
        "droid"
    ].items():
        assert joints.keys() == grasps_of(tmp_path / "set", name).keys()
    assert grasps_of(tmp_path / "set", "drawer_0")
