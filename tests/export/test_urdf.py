"""What the URDF says, and what it admits not to say."""

import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy

from artgen.asset import Asset, Branch, Link, Piece, Push, Tree
from artgen.asset import AssetCoupling as Coupling
from artgen.asset import AssetJoint as Joint
from artgen.export import Written, export, write_urdf
from artgen.export.meshes import display_color
from support.readers import silence
from support.textured import BOARD, LAMP, PLATE, TURNED, recipes, textured


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


@pytest.fixture(scope="module")
def written(cabinet: Asset) -> Written:
    return write_urdf(cabinet)


@pytest.fixture(scope="module")
def root(written: Written) -> ET.Element:
    return ET.fromstring(written.files["cabinet_7.urdf"])


def joint(root: ET.Element, name: str) -> ET.Element:
    found = root.find(f"joint[@name='{name}']")
    assert found is not None
    return found


def test_root_is_the_base_link_with_an_inertial_on_every_link(root: ET.Element, cabinet: Asset) -> None:
    children = {element.get("link") for element in root.iterfind("joint/child")}
    links = [element.get("name") for element in root.iterfind("link")]
    assert [name for name in links if name not in children] == [cabinet.links[0].name]
    assert all(len(element.findall("inertial")) == 1 for element in root.iterfind("link"))


def test_names_are_unique(root: ET.Element) -> None:
    for tag in ("link", "joint", "link/visual", "link/collision", "material"):
        names = [element.get("name") for element in root.iterfind(tag)]
        assert len(names) == len(set(names)), tag


def test_colliders_are_primitives_where_they_can_be(root: ET.Element) -> None:
    def kinds(link: str) -> list[str]:
        return [element[0].tag for element in root.iterfind(f"link[@name='{link}']/collision/geometry")]

    assert kinds("body") == ["box"] * 6
    assert kinds("lid") == ["mesh"]
    assert kinds("dial") == ["cylinder"]
    assert kinds("knob") == ["sphere"]
    assert kinds("bolt") == ["cylinder", "sphere", "sphere"]


def test_capsule_ends_lie_where_the_capsule_has_them(root: ET.Element) -> None:
    origins = [
        np.array(element.get("xyz", "").split(), float)
        for element in root.iterfind("link[@name='bolt']/collision/origin")
    ]
    np.testing.assert_allclose(sorted(origin[0] for origin in origins[1:]), [-0.03, 0.03], atol=1e-12)
    np.testing.assert_allclose(origins[0], np.zeros(3), atol=1e-12)


def test_unlimited_is_continuous_and_locked_is_fixed(root: ET.Element) -> None:
    assert joint(root, "dial_turn").get("type") == "continuous"
    limit = joint(root, "dial_turn").find("limit")
    assert limit is not None
    assert limit.get("lower") is None
    assert joint(root, "foot_lock").get("type") == "fixed"


def test_coupled_joint_mimics_its_leader(root: ET.Element) -> None:
    mimic = joint(root, "bolt_slide").find("mimic")
    assert mimic is not None
    assert mimic.attrib == {"joint": "lever_turn", "multiplier": "-0.02", "offset": "0.005"}


def test_spring_is_gazebos(root: ET.Element) -> None:
    spring = root.find("gazebo[@reference='lid_hinge']")
    assert spring is not None
    assert (spring.findtext("springStiffness"), spring.findtext("springReference")) == ("1.5", "-0.3")


def test_grasp_is_a_link_fixed_at_its_frame(root: ET.Element, cabinet: Asset) -> None:
    mount = joint(root, "grasp_lid_edge_mount")
    origin = mount.find("origin")
    assert origin is not None
    frame = cabinet.link("lid").grasps[0].frame
    xyz = np.array(origin.get("xyz", "").split(), float) + cabinet.origin("lid")
    np.testing.assert_allclose(xyz, frame[:3, 3], atol=1e-9)
    assert mount.get("type") == "fixed"


def pushed(cabinet: Asset) -> Asset:
    """Return the cabinet with a button on its lid, named as its grasp is."""
    frame = cabinet.link("lid").grasps[0].frame.copy()
    frame[:3, 3] += 0.01
    lid = replace(cabinet.link("lid"), pushes=(Push("lid_edge_", frame), Push("grasp", frame)))
    return replace(cabinet, links=tuple(lid if link.name == "lid" else link for link in cabinet.links))


def test_every_affordance_is_a_link_fixed_at_its_frame(cabinet: Asset) -> None:
    asset = pushed(cabinet)
    root = ET.fromstring(write_urdf(asset).files["cabinet_7.urdf"])
    marks = [link.get("name") for link in root.iterfind("link")][-3:]
    assert marks == ["grasp_lid_edge", "push_lid_edge_", "push_grasp"]
    for mark, affordance in zip(marks, asset.affordances, strict=True):
        mount = joint(root, f"{mark}_mount")
        parent, child, origin = mount.find("parent"), mount.find("child"), mount.find("origin")
        assert parent is not None
        assert child is not None
        assert origin is not None
        assert (parent.get("link"), child.get("link")) == (affordance.link, mark)
        xyz = np.array(origin.get("xyz", "").split(), float) + asset.origin(affordance.link)
        np.testing.assert_allclose(xyz, affordance.frame[:3, 3], atol=1e-9)
        rpy = np.array(origin.get("rpy", "").split(), float)
        turn = trimesh.transformations.euler_matrix(*rpy, axes="sxyz")[:3, :3]
        np.testing.assert_allclose(turn, affordance.frame[:3, :3], atol=1e-9)
    losses = {loss.feature: loss.where for loss in write_urdf(asset).losses}
    assert (losses["grasp frame"], losses["push frame"]) == ("lid_edge", "lid_edge_, grasp")


def test_marks_weigh_too_little_to_be_measured_but_enough_for_clients(root: ET.Element) -> None:
    """Newton takes moments below 1e-10 kg m^2 for errors, SAPIEN and PyBullet make up what is 0 or absent."""
    inertial = root.find("link[@name='grasp_lid_edge']/inertial")
    assert inertial is not None
    mass, inertia = inertial.find("mass"), inertial.find("inertia")
    assert mass is not None
    assert inertia is not None
    assert 0.0 < float(mass.get("value", "")) <= 1e-9
    assert all(1e-10 < float(inertia.get(axis, "")) < 1e-9 for axis in ("ixx", "iyy", "izz"))


@pytest.mark.parametrize(
    ("feature", "where"),
    [
        ("joint spring", "lid_hinge, lever_turn"),
        ("joint armature", "lid_hinge"),
        ("joint dependency", "lid_hinge"),
        ("grasp frame", "lid_edge"),
        ("several joints between two links", "knob_knob_slide"),
        ("contact friction", "body"),
        ("semantic labels", "body"),
    ],
)
def test_what_urdf_cannot_say_is_listed(written: Written, feature: str, where: str) -> None:
    found = [loss for loss in written.losses if loss.feature == feature]
    assert len(found) == 1
    assert set(where.split(", ")) <= set(found[0].where.split(", "))
    assert found[0].instead


def test_chain_of_couplings_names_the_joint_at_its_head(nested: Asset) -> None:
    spin = nested.joint("spin")
    third = Joint(
        "third", "revolute", spin.axis, spin.pivot, None, follows=Coupling("spin", -3.0, 0.5),
        parent="wheel", child="cap",
    )  # fmt: skip
    cap = replace(nested.link("wheel"), name="cap")
    longer = replace(nested, links=(*nested.links, cap), joints=(*nested.joints, third))
    root = ET.fromstring(write_urdf(longer).files["arm_1.urdf"])
    mimic = joint(root, "third").find("mimic")
    assert mimic is not None
    assert mimic.attrib == {"joint": "wrist", "multiplier": "-6", "offset": "0.2"}


def test_unlimited_slide_gets_far_limits_and_a_loss(nested: Asset) -> None:
    endless = replace(nested.joint("reach"), limits=None)
    joints = tuple(endless if each.name == "reach" else each for each in nested.joints)
    written = write_urdf(replace(nested, joints=joints))
    limit = joint(ET.fromstring(written.files["arm_1.urdf"]), "reach").find("limit")
    assert limit is not None
    assert (limit.get("lower"), limit.get("upper")) == ("-1000", "1000")
    assert [loss.where for loss in written.losses if loss.feature == "unlimited slide"] == ["reach"]


def test_links_stand_in_the_order_of_the_joints_that_end_in_them(nested: Asset) -> None:
    """Genesis takes shapes from links in the order of the file, and bodies in the order of joints."""
    root = ET.fromstring(write_urdf(nested).files["arm_1.urdf"])
    links = [element.get("name") for element in root.iterfind("link")]
    children = [element.get("link") for element in root.iterfind("joint/child")]
    assert links == [nested.links[0].name, *children]


def test_intermediate_link_never_takes_the_name_of_another(nested: Asset) -> None:
    root = ET.fromstring(write_urdf(nested).files["arm_1.urdf"])
    names = [element.get("name") for element in root.iterfind("link")]
    assert {"arm_reach", "arm_reach_", "arm_set"} <= set(names)
    assert len(names) == len(set(names))


@pytest.mark.parametrize("fixture", ["cabinet", "nested"])
def test_same_asset_gives_same_bytes(
    fixture: str, request: pytest.FixtureRequest, make_asset: Callable[[str], Asset]
) -> None:
    assert write_urdf(request.getfixturevalue(fixture)).files == write_urdf(make_asset(fixture)).files


def test_surfaces_of_one_link_and_material_of_another_are_told_apart(nested: Asset) -> None:
    """`a` with surface `b_c` and `a_b` with surface `c` would both be `a_b_c.obj`."""
    piece = nested.links[0].pieces[0]
    pieces = {
        "a": Piece("b_oak", piece.material, piece.shape),
        "a_b": Piece("oak", piece.material, piece.shape),
    }
    first, second = (Link(name, name, (piece,)) for name, piece in pieces.items())
    slide = Joint("slide", "prismatic", np.array([1.0, 0, 0]), np.zeros(3), (0.0, 0.1))
    asset = Asset.from_tree(Tree(first, (Branch((slide,), Tree(second)),)), "twins", "twins")
    files = [path for path in write_urdf(asset).files if path.endswith(".obj")]
    assert files == ["meshes/a_b_oak_oak.obj", "meshes/a_b_oak_oak_.obj"]


def materials_of_visuals(root: ET.Element) -> dict[str, str | None]:
    """Return the name of the material of each link's visual; None where it has none."""
    found = {}
    for element in root.iterfind("link/visual/.."):
        reference = element.find("visual/material")
        found[element.get("name", "")] = None if reference is None else reference.get("name")
    return found


def test_no_color_stands_beside_a_color_map() -> None:
    """PyBullet multiplies the map with it, SAPIEN shows it alone."""
    asset = textured()
    plain = ET.fromstring(write_urdf(asset).files["textured.urdf"])
    assert materials_of_visuals(plain)["board"] == "board"
    written = write_urdf(asset, 256)
    root = ET.fromstring(written.files["textured.urdf"])
    assert materials_of_visuals(root) == {
        "board": None, "plank": None, "plate": "plate", "pane": "pane", "lamp": "lamp",
    }  # fmt: skip
    assert {element.get("name") for element in root.iterfind("material")} == {"plate", "pane", "lamp"}
    losses = {loss.feature: loss.where for loss in written.losses}
    assert set(losses["color beside a color map"].split(", ")) == {"board", "turned"}
    assert losses["transmission"] == "pane"
    assert "texture" not in losses


def test_without_maps_the_texture_is_lost() -> None:
    losses = {loss.feature: loss for loss in write_urdf(textured()).losses}
    assert set(losses["texture"].where.split(", ")) == {"board", "plate", "turned", "pane"}
    assert "maps were not asked for" in losses["texture"].instead
    assert "color beside a color map" not in losses


@pytest.mark.parametrize("size", [0, 256])
def test_yourdfpy_shows_each_link_in_its_color_or_map(size: int, tmp_path: Path) -> None:
    directory = export(textured(), tmp_path / "it", formats=("urdf",), textures=size)
    with silence():
        robot = yourdfpy.URDF.load(str(directory / "textured.urdf"))
    shown = {name.removesuffix(".obj"): mesh.visual for name, mesh in robot.scene.geometry.items()}
    assert len(shown) == 5
    for name, stuff in (("board", BOARD), ("plank", TURNED), ("plate", PLATE), ("lamp", LAMP)):
        visual = shown[f"{name}_{name}_{stuff.name}"]
        mapped = bool(size) and stuff in (BOARD, TURNED)
        assert (visual.material.image is not None) == mapped, name
        if mapped:
            assert visual.material.image.size == (size, size)
        wanted = (1.0, 1.0, 1.0) if mapped else display_color(stuff.base_color)
        np.testing.assert_allclose(visual.material.diffuse[:3] / 255.0, wanted, atol=0.003)
        assert isinstance(visual, trimesh.visual.TextureVisuals)
