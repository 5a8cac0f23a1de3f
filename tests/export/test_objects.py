"""Assets as objects of other libraries hold what the exported files hold."""

import sys
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh
from pxr import Usd, UsdShade

import artgen
from artgen import Asset
from artgen.errors import AssetError, ExportError

PATHS = ("_sizes", "mesh_pathadr", "tex_pathadr")  # depend on the length of file names


def test_the_spec_compiles_to_the_model_of_the_exported_file(cabinet: Asset, tmp_path: Path) -> None:
    model = cabinet.to_mjspec(textures=256).compile()
    cabinet.export(tmp_path / "out", formats=("mjcf",), textures=256)
    read = mujoco.MjModel.from_xml_path(str(tmp_path / "out" / f"{cabinet.name}.xml"))
    assert model.ntex == read.ntex > 0
    assert model.names == read.names
    for name in dir(read):
        value = getattr(read, name)
        if isinstance(value, np.ndarray) and name not in PATHS:
            np.testing.assert_array_equal(getattr(model, name), value, err_msg=name)


def test_a_spec_without_mujoco_names_what_to_install(cabinet: Asset, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(ExportError, match=r'needs MuJoCo.*: pip install "artgen\[sim\]"'):
        cabinet.to_mjspec()


def test_the_scene_has_a_node_for_each_link_at_its_pose(cabinet: Asset) -> None:
    q = {cabinet.free_joints[0].name: 0.1}
    scene = cabinet.to_trimesh(q, textures=0)
    pose = cabinet.pose(q)
    for link in cabinet.links:
        origin = np.append(cabinet.origin(link.name), 1.0)
        np.testing.assert_allclose(scene.graph[link.name][0][:, 3], pose[link.name] @ origin, atol=1e-9)
    low, high = (np.inf * sign for sign in (np.ones(3), -np.ones(3)))
    for link in cabinet.links:
        for surface in link.surfaces:
            points = surface.mesh.vertices @ pose[link.name][:3, :3].T + pose[link.name][:3, 3]
            low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    np.testing.assert_allclose(scene.bounds, [low, high], atol=1e-6)
    parents = {child: parent for parent, child, _ in cabinet.pairs()}
    found = scene.graph.transforms.parents
    assert {link.name: found[link.name] for link in cabinet.links[1:]} == parents


def test_the_surfaces_of_a_scene_have_names_and_materials(cabinet: Asset) -> None:
    scene = cabinet.to_trimesh(textures=256)
    surfaces = {f"{link.name}/{each.name}": each for link in cabinet.links for each in link.surfaces}
    assert set(scene.geometry) == set(surfaces)
    for name, surface in surfaces.items():
        made = scene.geometry[name]
        assert len(made.faces) == len(surface.mesh.triangles)
        assert made.visual.material.name == surface.material.name
    assert any(made.visual.material.baseColorTexture for made in scene.geometry.values())


def test_a_scene_of_colliders_has_convex_pieces_only(cabinet: Asset) -> None:
    scene = cabinet.to_trimesh(colliders=True)
    assert len(scene.geometry) == sum(len(link.colliders) for link in cabinet.links)
    assert all(isinstance(each, trimesh.Trimesh) and each.is_watertight for each in scene.geometry.values())
    boxes = np.array([each.convex.bounds() for link in cabinet.links for each in link.colliders])
    low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
    np.testing.assert_allclose(scene.bounds, [low, high], atol=2e-3)  # round ones have facets


def content(stage: Usd.Stage) -> dict[str, dict[str, str]]:
    """Return the properties of all prims as text, without the folder of a map."""
    return {
        str(prim.GetPath()): {
            each.GetName(): str(each.Get()).rpartition("/")[2]
            if isinstance(each, Usd.Attribute)
            else str(each.GetTargets())
            for each in prim.GetProperties()
        }
        for prim in stage.Traverse()
    }


def test_the_stage_has_the_content_of_the_exported_one(cabinet: Asset, tmp_path: Path) -> None:
    stage = cabinet.to_usd(textures=256)
    cabinet.export(tmp_path / "out", formats=("usd",), textures=256)
    assert content(stage) == content(Usd.Stage.Open(str(tmp_path / "out" / f"{cabinet.name}.usda")))
    shaders = [UsdShade.Shader(prim) for prim in stage.Traverse() if prim.IsA(UsdShade.Shader)]
    maps = [found.Get() for shader in shaders if (found := shader.GetInput("file"))]
    assert maps
    assert all(Path(each.resolvedPath).is_file() for each in maps)


def test_a_stage_without_maps_needs_no_file(cabinet: Asset) -> None:
    stage = cabinet.to_usd(textures=0)
    layers = stage.GetUsedLayers()
    assert len(layers) >= 2
    assert all(layer.identifier.startswith("anon:") for layer in layers)


def test_a_wrong_size_of_maps_is_refused(cabinet: Asset) -> None:
    for make in (cabinet.to_mjspec, cabinet.to_trimesh, cabinet.to_usd):
        with pytest.raises(artgen.ParameterError, match=r"333"):
            make(textures=333)


def test_an_unknown_joint_of_a_pose_is_refused(cabinet: Asset) -> None:
    with pytest.raises(AssetError, match=r"has no joint 'nothing'"):
        cabinet.to_trimesh({"nothing": 0.1})
