"""What a GLB file holds, read by a reader that shares nothing with the writer."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
import pytest

from artgen.asset import Asset, Link, Mesh, Piece, Tree
from artgen.asset import AssetDependency as Dependency
from artgen.asset.surface import texture_coordinates
from artgen.catalog import find
from artgen.errors import ParameterError
from artgen.export import write_glb
from artgen.export.glb.surfaces import tangents
from artgen.materials import Material, material
from artgen.materials.textures import encoded
from support.blocks import block
from support.gltf import Gltf
from support.textured import recipes, textured

Draw = Callable[[Asset, int], dict[str, float]]

SIZE = 256
CATEGORIES = ("door", "handle")


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


@pytest.fixture(scope="module")
def dressed() -> Asset:
    """An asset with maps of every kind."""
    return textured()


def read(asset: Asset, textures: int = 0) -> Gltf:
    return Gltf(write_glb(asset, textures).files[f"{asset.name}.glb"])


def check_meshes(asset: Asset, model: Gltf, placed: dict[str, np.ndarray], poses: dict) -> None:
    """Assert that every surface is seen where the asset has it, at poses of its links."""
    for link in asset.links:
        shown = list(model.primitives(link.name))
        assert [primitive["extras"]["name"] for primitive, *_ in shown] == [s.name for s in link.surfaces]
        node, pose = placed[link.name], poses[link.name]
        for (_, arrays, triangles, stuff), surface in zip(shown, link.surfaces, strict=True):
            mesh = surface.mesh
            seen = arrays["POSITION"] @ node[:3, :3].T + node[:3, 3]
            np.testing.assert_allclose(seen, mesh.vertices @ pose[:3, :3].T + pose[:3, 3], atol=1e-6)
            seen = arrays["NORMAL"] @ node[:3, :3].T
            np.testing.assert_allclose(seen, mesh.normals @ pose[:3, :3].T, atol=1e-5)
            np.testing.assert_array_equal(triangles, mesh.triangles)
            assert stuff["name"] == surface.material.name


def test_every_vertex_stands_where_the_asset_has_it_at_any_pose(asset: Asset, draw_positions: Draw) -> None:
    model = read(asset)
    check_meshes(asset, model, model.placed(), asset.pose())
    for seed in range(5):
        q = draw_positions(asset, seed)
        check_meshes(asset, model, model.placed(model.moved(q)), asset.pose(q))


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("seed", range(4))
def test_generated_assets_stand_in_the_file_as_they_are(
    category: str, seed: int, draw_positions: Draw
) -> None:
    asset = find(category).generate(seed)
    model = read(asset)
    q = draw_positions(asset, seed)
    check_meshes(asset, model, model.placed(model.moved(q)), asset.pose(q))


def test_root_turns_z_up_to_y_up(cabinet: Asset) -> None:
    root = read(cabinet).root
    assert root["name"] == cabinet.name
    assert root["rotation"] == pytest.approx([-np.sqrt(0.5), 0, 0, np.sqrt(0.5)])


def test_nodes_are_the_tree_of_links_with_one_more_for_each_joint_of_a_pair(asset: Asset) -> None:
    model = read(asset)
    parents = {
        model.data["nodes"][number]["name"]: node["name"]
        for node in model.data["nodes"]
        for number in node.get("children", [])
    }
    assert parents[asset.links[0].name] == model.root["name"]
    for joint in model.joints.values():
        name = parents[joint["node"]]
        while "mesh" not in model.nodes[name]:
            name = parents[name]
        assert name == joint["parent"]
    assert len(model.nodes) == len(asset.joints) + 2  # the root and the base


def test_names_of_meshes_are_no_names_of_nodes(asset: Asset) -> None:
    model = read(asset)
    names = [mesh["name"] for mesh in model.data["meshes"]]
    assert len({*names, *model.nodes}) == len(names) + len(model.nodes)


def test_root_says_what_the_asset_is_and_how_its_joints_move(asset: Asset) -> None:
    model = read(asset)
    data = model.root["extras"]["artgen"]
    expected = (asset.name, asset.category, asset.seed, asset.version, asset.base)
    assert tuple(data[key] for key in ("name", "category", "seed", "version", "base")) == expected
    assert list(model.joints) == [joint.name for joint in asset.joints]
    for joint in asset.joints:
        found = model.joints[joint.name]
        assert (found["parent"], found["child"]) == (joint.parent, joint.child)
        assert (found["lower"], found["upper"]) == pytest.approx(joint.limits or (None, None))
        assert found["axis"] == pytest.approx(joint.axis.tolist())
        needs = None if found["needs"] is None else Dependency.from_data(found["needs"])
        assert needs == joint.needs


def test_types_of_joints_are_the_words_of_urdf(cabinet: Asset, nested: Asset) -> None:
    types = {name: joint["type"] for name, joint in (read(cabinet).joints | read(nested).joints).items()}
    assert types == {
        "lid_hinge": "revolute", "dial_turn": "continuous", "knob_slide": "prismatic",
        "knob_turn": "revolute", "lever_turn": "revolute", "bolt_slide": "prismatic",
        "foot_lock": "fixed", "tray_slide": "prismatic", "reach": "prismatic", "set": "fixed",
        "swing": "revolute", "wrist": "continuous", "spin": "continuous",
    }  # fmt: skip


def test_labels_stand_on_the_nodes_and_surfaces(cabinet: Asset) -> None:
    model = read(cabinet)
    for link in cabinet.links:
        assert model.nodes[link.name]["extras"] == {"label": link.label, "labels": list(link.labels)}
        labels = [primitive["extras"]["label"] for primitive, *_ in model.primitives(link.name)]
        assert labels == [surface.label for surface in link.surfaces]


def base_of(stuff: Material) -> Asset:
    link = Link("lump", "lump", (Piece("lump", stuff, block((0.1, 0.1, 0.1))),))
    return Asset.from_tree(Tree(link), "lump", "lump")


def test_material_without_maps_is_its_numbers() -> None:
    stuff = Material(
        "stuff", (0.1, 0.2, 0.3), base_metalness=0.4, specular_roughness=0.6, coat_weight=0.7,
        coat_roughness=0.05, opacity=0.8, emission=(0.0, 0.5, 1.0),
    )  # fmt: skip
    data = read(base_of(stuff), SIZE).data
    assert data["materials"] == [
        {
            "name": "stuff",
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.1, 0.2, 0.3, 0.8],
                "metallicFactor": 0.4,
                "roughnessFactor": 0.6,
            },
            "emissiveFactor": [0.0, 0.5, 1.0],
            "alphaMode": "BLEND",
            "extensions": {
                "KHR_materials_clearcoat": {"clearcoatFactor": 0.7, "clearcoatRoughnessFactor": 0.05}
            },
        }
    ]
    assert data["extensionsUsed"] == ["KHR_materials_clearcoat"]
    assert "images" not in data


def test_opaque_material_says_no_more_than_it_has_to() -> None:
    (found,) = read(base_of(material("steel"))).data["materials"]
    assert set(found) == {"name", "pbrMetallicRoughness"}  # neither blended nor seen from behind


def test_maps_are_jpeg_files_with_white_factors(dressed: Asset) -> None:
    model = read(dressed, SIZE)
    images = {image["name"]: image for image in model.data["images"]}
    assert len(images) == len(model.data["images"])
    assert model.data["samplers"] == [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}]
    stuff = {each["name"]: each for each in model.data["materials"]}
    board = next(each for each in dressed.materials if each.name == "board")
    pbr = stuff["board"]["pbrMetallicRoughness"]
    assert pbr["baseColorFactor"] == [1.0, 1.0, 1.0, 1.0]
    assert (pbr["metallicFactor"], pbr["roughnessFactor"]) == (1.0, 1.0)
    kinds = {
        "albedo": pbr["baseColorTexture"],
        "orm": pbr["metallicRoughnessTexture"],
        "normal": stuff["board"]["normalTexture"],
    }
    for kind, texture in kinds.items():
        image = model.data["images"][model.data["textures"][texture["index"]]["source"]]
        assert image["mimeType"] == "image/jpeg"
        assert model.view(image["bufferView"]) == encoded(board, kind, SIZE, "jpg")


def test_color_stays_where_a_material_has_no_map_of_it(dressed: Asset) -> None:
    (plate,) = [each for each in read(dressed, SIZE).data["materials"] if each["name"] == "plate"]
    steel = material("steel")
    assert plate["pbrMetallicRoughness"]["baseColorFactor"] == [*steel.base_color, 1.0]
    assert "baseColorTexture" not in plate["pbrMetallicRoughness"]
    assert "normalTexture" not in plate


def test_texture_coordinates_run_downwards_and_tangents_along_u(dressed: Asset) -> None:
    model = read(dressed, SIZE)
    for link in dressed.links:
        for (_, arrays, _, stuff), surface in zip(model.primitives(link.name), link.surfaces, strict=True):
            if not surface.material.texture:
                assert set(arrays) == {"POSITION", "NORMAL"}
                continue
            expected = texture_coordinates(surface.mesh, surface.material)
            np.testing.assert_allclose(arrays["TEXCOORD_0"], expected * (1, -1) + (0, 1), atol=1e-5)
            assert ("TANGENT" in arrays) == ("normalTexture" in stuff)


def test_without_textures_there_are_no_maps(dressed: Asset) -> None:
    model = read(dressed, 0)
    assert not {"images", "textures", "samplers"} & set(model.data)
    attributes = [set(arrays) for link in dressed.links for _, arrays, *_ in model.primitives(link.name)]
    assert attributes == [{"POSITION", "NORMAL"}] * len(attributes)


def test_maps_of_no_such_size_are_refused(dressed: Asset) -> None:
    with pytest.raises(ParameterError, match="textures have 256, 512, 1024, 2048 texels on a side, not 100"):
        write_glb(dressed, 100)


def patch(turn: float, *, mirrored: bool) -> tuple[Mesh, np.ndarray, np.ndarray, np.ndarray]:
    """A dented square of triangles with texture coordinates turned on it, and the directions of u and v."""
    grid = np.stack(np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij"), axis=-1).reshape(-1, 2)
    u = np.array([np.cos(turn), np.sin(turn)])
    v = np.array([-u[1], u[0]]) * (-1 if mirrored else 1)
    corner = (np.arange(5)[:, None] * 6 + np.arange(5)).ravel()
    triangles = np.concatenate(
        [np.stack([corner, corner + 6, corner + 7], 1), np.stack([corner, corner + 7, corner + 1], 1)]
    )
    vertices = np.column_stack([grid, np.zeros(36)])
    uvs = np.column_stack([grid @ u, grid @ v])
    mesh = Mesh(vertices, np.tile([0.0, 0, 1], (36, 1)), uvs, np.zeros(36, int), triangles)
    return mesh, uvs, np.array([*u, 0.0]), np.array([*v, 0.0])


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("turn", [0.0, 0.7, 2.0, -1.5])
def test_tangents_point_to_greater_u_and_their_sign_to_greater_v(turn: float, *, mirrored: bool) -> None:
    mesh, uvs, u, v = patch(turn, mirrored=mirrored)
    found = tangents(mesh, uvs)
    np.testing.assert_allclose(found[:, :3], np.tile(u, (36, 1)), atol=1e-12)
    np.testing.assert_allclose(
        np.cross(mesh.normals, found[:, :3]) * found[:, 3:], np.tile(v, (36, 1)), atol=1e-12
    )


def test_tangents_are_unit_vectors_where_texture_coordinates_say_nothing() -> None:
    mesh, uvs, *_ = patch(0.0, mirrored=False)
    found = tangents(mesh, np.zeros_like(uvs))
    np.testing.assert_allclose(np.linalg.norm(found[:, :3], axis=1), 1.0)
    np.testing.assert_allclose((found[:, :3] * mesh.normals).sum(axis=1), 0.0, atol=1e-12)
    assert set(found[:, 3]) <= {1.0, -1.0}


@pytest.mark.parametrize(("count", "component"), [(65535, 5123), (65536, 5125)])
def test_many_vertices_take_long_indices(count: int, component: int) -> None:
    """Number 65535 of short indices is no vertex: it begins a new strip."""
    from artgen.export.glb.buffer import Buffer

    buffer = Buffer()
    corners = np.array([[0, 1, count - 1]])
    accessor = buffer.accessors[buffer.triangles(corners, count)]
    assert accessor["componentType"] == component
    assert accessor["count"] == 3


@pytest.mark.parametrize("fixture", ["cabinet", "nested"])
def test_same_asset_gives_same_bytes(
    fixture: str, request: pytest.FixtureRequest, make_asset: Callable[[str], Asset]
) -> None:
    assert write_glb(request.getfixturevalue(fixture)).files == write_glb(make_asset(fixture)).files


def test_same_maps_give_same_bytes(dressed: Asset) -> None:
    assert write_glb(dressed, SIZE).files == write_glb(textured(), SIZE).files


def test_what_glb_cannot_say_is_listed(cabinet: Asset, dressed: Asset) -> None:
    of_cabinet, of_dressed = (
        {loss.feature: loss.where.split(", ") for loss in write_glb(asset).losses}
        for asset in (cabinet, dressed)
    )
    physics = {"mass and inertia", "colliders", "joints", "joint dynamics", "grasp frame"}
    assert physics <= set(of_cabinet)
    assert of_cabinet["grasp frame"] == ["lid_edge"]
    assert {"lid_hinge", "knob_slide", "knob_turn"} <= set(of_cabinet["joint dynamics"])
    assert of_dressed["transmission"] == ["pane"]
    assert {"board", "plate"} <= set(of_dressed["texture"])


def test_root_named_like_a_link_takes_another_name(cabinet: Asset) -> None:
    model = read(replace(cabinet, name="lid"))
    assert model.root["name"] == "lid_"
    assert "mesh" in model.nodes["lid"]


def test_asset_without_joints_has_no_animations() -> None:
    model = read(base_of(material("oak")))
    assert "animations" not in model.data
    assert model.joints == {}


def test_root_says_where_joints_stand(nested: Asset) -> None:
    joints = read(nested).joints
    assert {name: joint["position"] for name, joint in joints.items()} == pytest.approx(nested.positions())
