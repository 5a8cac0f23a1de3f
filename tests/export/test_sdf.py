"""What the SDFormat says: read back with a reader of its own, and Drake where it is installed as a client."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from artgen._arrays import Array
from artgen._names import ByName
from artgen.asset import Asset
from artgen.asset.joint import rotation
from artgen.export import Written, write_sdf
from artgen.scene import Scene


@pytest.fixture(scope="module")
def written(cabinet: Asset) -> Written:
    return write_sdf(cabinet)


@pytest.fixture(scope="module")
def model(written: Written) -> ET.Element:
    found = ET.fromstring(written.files["cabinet_7.sdf"]).find("model")
    assert found is not None
    return found


def said(element: ET.Element, path: str) -> list[float]:
    text = element.findtext(path)
    assert text is not None, path
    return [float(word) for word in text.split()]


def pose_of(element: ET.Element) -> Array:
    x, y, z, *angles = said(element, "pose")
    pose = np.eye(4)
    pose[:3, :3] = Rotation.from_euler("xyz", angles).as_matrix()
    pose[:3, 3] = x, y, z
    return pose


def placed(model: ET.Element, positions: Mapping[str, float]) -> dict[str, Array]:
    """Return the frame of each link of a model at joint positions, from what the model says alone."""
    joints = {joint.findtext("child"): joint for joint in model.iterfind("joint")}
    result: dict[str, Array] = {}
    for link in model.iterfind("link"):
        joint, pose = joints.get(link.get("name")), pose_of(model)
        if joint is not None and joint.findtext("parent") != "world":
            parent = str(joint.findtext("parent"))
            assert link.find("pose").get("relative_to") == parent  # type: ignore[union-attr]
            motion = np.eye(4)
            if joint.get("type") != "fixed":
                axis, q = np.array(said(joint, "axis/xyz")), positions[str(joint.get("name"))]
                if joint.get("type") == "prismatic":
                    motion[:3, 3] = q * axis
                else:
                    motion[:3, :3] = rotation(axis, q)
            pose = result[parent] @ pose_of(link) @ motion
        result[str(link.get("name"))] = pose
    return result


def test_links_stand_where_those_of_the_asset_do(model: ET.Element, cabinet: Asset) -> None:
    rows = np.vstack([np.zeros(len(cabinet.dof_names)), cabinet.sample_states(5)])
    for row, frames in zip(cabinet.project(rows), cabinet.fk(cabinet.project(rows)), strict=True):
        q = cabinet.positions(dict(zip(cabinet.dof_names, row.tolist(), strict=True)))
        found = placed(model, q)
        for link, frame in zip(cabinet.links, frames, strict=True):
            np.testing.assert_allclose(found[link.name], frame, atol=1e-9)


def test_masses_and_joints_are_those_of_the_asset(model: ET.Element, cabinet: Asset) -> None:
    for link in cabinet.links:
        element = model.find(f"link[@name='{link.name}']")
        assert element is not None
        assert said(element, "inertial/mass") == pytest.approx([link.mass_properties.mass], rel=1e-9)
        center = link.mass_properties.center - cabinet.origin(link.name)
        assert said(element, "inertial/pose") == pytest.approx([*center, 0.0, 0.0, 0.0], abs=1e-9)
        assert said(element, "inertial/inertia/iyy")[0] == pytest.approx(
            link.mass_properties.inertia[1, 1], rel=1e-9
        )
        assert len(element.findall("collision")) == len(link.colliders)
    for joint in (each for each in cabinet.joints if not each.locked):
        axis = model.find(f"joint[@name='{joint.name}']/axis")
        assert axis is not None
        ends = {"lower": joint.limits[0], "upper": joint.limits[1]} if joint.limits is not None else {}
        for word, value in (ends | {"effort": joint.effort, "velocity": joint.velocity}).items():
            assert said(axis, f"limit/{word}") == pytest.approx([value], rel=1e-9)
        assert (axis.find("limit/upper") is None) == (joint.limits is None)
        assert said(axis, "dynamics/friction") == pytest.approx([joint.friction], rel=1e-9)
        mimic = axis.find("mimic")
        assert (mimic is None) == (joint.follows is None)
        if joint.follows is not None:
            assert mimic is not None
            assert mimic.get("joint") == joint.follows.leader
            assert said(mimic, "multiplier") == pytest.approx([joint.follows.ratio], rel=1e-9)


def test_a_fixed_base_is_joined_to_the_world(cabinet: Asset, model: ET.Element) -> None:
    assert [each.findtext("child") for each in model.iterfind("joint[parent='world']")] == ["body"]
    free = ET.fromstring(write_sdf(replace(cabinet, base="free")).files["cabinet_7.sdf"])
    assert free.find("model/joint[parent='world']") is None


def test_frames_joints_and_links_have_names_of_their_own(cabinet: Asset) -> None:
    joints = [replace(each, name="knob") if each.name == "knob_turn" else each for each in cabinet.joints]
    model = ET.fromstring(write_sdf(replace(cabinet, joints=ByName(joints))).files["cabinet_7.sdf"]).find(
        "model"
    )
    assert model is not None
    names = [each.get("name") for tag in ("link", "joint", "frame") for each in model.iterfind(tag)]
    assert len(names) == len(set(names))


def test_meshes_that_it_names_are_written(written: Written, model: ET.Element) -> None:
    named = {uri.text for uri in model.iter("uri")}
    assert named
    assert named <= set(written.files)


def test_a_room_is_a_world_whose_free_bodies_are_models() -> None:
    room = Scene("corner", seed=5, width=1.6, depth=1.4, detail="low")
    chest = room.against("back", "drawer", at=0.5, kind="bedside", rows=1, width=0.45, depth=0.42)
    room.on(chest, "pepper_grinder", deep=0.5, turn=0.3, free=True)
    asset = room.build()
    world = ET.fromstring(write_sdf(asset).files["corner.sdf"]).find("world")
    assert world is not None
    shell, mill = world.findall("model")
    assert (shell.get("name"), mill.get("name")) == ("corner", "pepper_grinder_body")
    closed = asset.positions()
    found = placed(shell, closed) | placed(mill, closed)
    frames = asset.fk(np.array([closed[name] for name in asset.dof_names]))
    for link, frame in zip(asset.links, frames, strict=True):
        np.testing.assert_allclose(found[link.name], frame, atol=1e-9)
