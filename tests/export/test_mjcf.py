"""What the MJCF says, and how the asset moves in MuJoCo."""

import json
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import mujoco
import numpy as np
import pytest
from PIL import Image

from artgen import Prismatic, Z, box, cylinder, material, part
from artgen.asset import Asset, Push
from artgen.asset.surface import texture_coordinates
from artgen.export import Written, export, write_mjcf
from artgen.export.meshes import display_color
from support.proof_fridges import evaluated
from support.readers import silence
from support.textured import BOARD, LAMP, PANE, PLATE, TURNED, recipes, textured


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


@pytest.fixture(scope="module")
def written(cabinet: Asset) -> Written:
    return write_mjcf(cabinet)


@pytest.fixture(scope="module")
def model(cabinet: Asset, tmp_path_factory: pytest.TempPathFactory) -> mujoco.MjModel:
    directory = export(cabinet, tmp_path_factory.mktemp("mjcf") / "cabinet", formats=("mjcf",))
    return mujoco.MjModel.from_xml_path(str(directory / "cabinet_7.xml"))


def test_dynamics_reach_the_model(model: mujoco.MjModel) -> None:
    hinge = model.joint("lid_hinge")
    assert hinge.stiffness[0] == 1.5
    assert model.qpos_spring[hinge.qposadr[0]] == -0.3
    assert hinge.damping[0] == 0.2
    assert hinge.frictionloss[0] == 0.1
    assert hinge.armature[0] == 0.002
    np.testing.assert_array_equal(model.jnt_actfrcrange[hinge.id], [-40.0, 40.0])


def test_joints_of_one_pair_share_a_body_in_order(model: mujoco.MjModel) -> None:
    body = model.body("knob")
    first = body.jntadr[0]
    assert body.jntnum[0] == 2
    assert [model.joint(first + index).name for index in range(2)] == ["knob_slide", "knob_turn"]


def test_locked_joint_is_no_joint(model: mujoco.MjModel) -> None:
    assert model.body("foot").jntnum[0] == 0
    assert "foot_lock" not in {model.joint(index).name for index in range(model.njnt)}


def test_visual_geoms_neither_touch_nor_weigh(model: mujoco.MjModel) -> None:
    visual = model.geom_group == 2
    assert visual.sum() == 9
    assert not model.geom_contype[visual].any()
    assert not model.geom_conaffinity[visual].any()
    assert model.nexclude == 0


def test_colliders_have_the_volume_of_their_pieces(cabinet: Asset) -> None:
    """The masses that MuJoCo gives to the colliders at density 1 are volumes, hulls included."""
    root = ET.fromstring(write_mjcf(cabinet).files["cabinet_7.xml"])
    for geom in root.iterfind("default/default/default/geom"):
        if geom.get("group") == "3":
            geom.attrib.pop("mass")
            geom.set("density", "1")
    for body in root.iter("body"):
        body.remove(body.find("inertial"))  # type: ignore[arg-type]
    files = {Path(path).name: text for path, text in write_mjcf(cabinet).files.items()}
    spec = mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"), assets=files)
    model = spec.compile()
    boxes = [0.02 * 0.4 * 0.6] * 2 + [0.56 * 0.02 * 0.6] + [0.56 * 0.38 * 0.02] * 2 + [0.2 * 0.01 * 0.2]
    radius, length = 0.01, 0.06
    expected = {
        "body": sum(boxes),
        "lid": 0.6 * 0.4 * 0.02,
        "dial": np.pi * 0.03**2 * 0.02,
        "knob": 4 / 3 * np.pi * 0.02**3,
        "bolt": np.pi * radius**2 * (length + 4 / 3 * radius),
    }
    for name, volume in expected.items():
        assert model.body(name).mass[0] == pytest.approx(volume, rel=1e-6), name


def test_each_collider_has_the_friction_of_its_material(model: mujoco.MjModel, cabinet: Asset) -> None:
    for link in cabinet.links:
        for number, collider in enumerate(link.colliders):
            geom = model.geom(f"{link.name}_collider_{number}")
            assert geom.friction[0] == pytest.approx(collider.material.friction)


def test_grasp_is_a_site_at_its_frame(model: mujoco.MjModel, cabinet: Asset) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    frame = cabinet.link("lid").grasps[0].frame
    np.testing.assert_allclose(data.site("lid_edge").xpos, frame[:3, 3], atol=1e-9)
    np.testing.assert_allclose(data.site("lid_edge").xmat.reshape(3, 3), frame[:3, :3], atol=1e-9)


def with_push(asset: Asset) -> Asset:
    """Return the asset with a push on its dial, which turns it by a coupling or not at all."""
    frame = np.eye(4)
    frame[:3, :3] = [[1, 0, 0], [0, 0, 1], [0, -1, 0]]
    frame[:3, 3] = (-0.2, -0.225, 0.5)
    links = (
        replace(link, pushes=(Push("dial_push", frame),)) if link.name == "dial" else link
        for link in asset.links
    )
    return replace(asset, links=tuple(links))


def texts(model: mujoco.MjModel) -> dict[str, str]:
    """Return every text of a model by its name."""
    starts = [*model.text_adr, model.ntextdata]
    return {
        mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_TEXT, number): model.text_data[start : end - 1].decode()
        for number, (start, end) in enumerate(pairwise(starts))
    }


def tuples(model: mujoco.MjModel) -> dict[str, list[tuple[str, float]]]:
    """Return every tuple of a model by its name: names of its elements, with their numbers."""
    found = {}
    for number, (start, size) in enumerate(zip(model.tuple_adr, model.tuple_size, strict=True)):
        rows = range(start, start + size)
        found[mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_TUPLE, number)] = [
            (mujoco.mj_id2name(model, int(model.tuple_objtype[row]), int(model.tuple_objid[row])),
             float(model.tuple_objprm[row]))
            for row in rows
        ]  # fmt: skip
    return found


def test_affordances_are_sites_and_tuples_with_the_joints_that_they_move(
    cabinet: Asset, tmp_path: Path
) -> None:
    asset = with_push(cabinet)
    directory = export(asset, tmp_path / "it", formats=("mjcf",), textures=0)
    with silence():
        model = mujoco.MjModel.from_xml_path(str(directory / "cabinet_7.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    assert len(asset.affordances) == 2
    assert set(tuples(model)) == {affordance.name for affordance in asset.affordances}
    for affordance in asset.affordances:
        site, *joints = tuples(model)[affordance.name]
        assert site == (affordance.name, pytest.approx(affordance.width))
        assert [name for name, _ in joints] == list(affordance.joints)
        assert model.site(affordance.name).user[0] == pytest.approx(affordance.width)
        np.testing.assert_allclose(data.site(affordance.name).xpos, affordance.frame[:3, 3], atol=1e-9)
        np.testing.assert_allclose(
            data.site(affordance.name).xmat.reshape(3, 3), affordance.frame[:3, :3], atol=1e-9
        )


def test_labels_of_links_are_texts(model: mujoco.MjModel, cabinet: Asset) -> None:
    labels = {f"{link.name}_labels": " ".join(link.labels) for link in cabinet.links}
    found = texts(model)
    assert json.loads(found.pop("cabinet_7_artgen_states")) == cabinet.states_data()
    assert found == labels


def test_base_is_free_only_when_the_asset_is(cabinet: Asset, free_cabinet: Asset) -> None:
    for asset, joints in ((cabinet, 0), (free_cabinet, 1)):
        root = ET.fromstring(write_mjcf(asset).files["cabinet_7.xml"])
        assert len(root.findall(".//freejoint")) == joints


def test_initial_state_is_within_limits(model: mujoco.MjModel, cabinet: Asset) -> None:
    positions = cabinet.positions()
    assert positions["tray_slide"] == 0.02
    for name, value in positions.items():
        if not cabinet.joint(name).locked:
            assert model.qpos0[model.joint(name).qposadr[0]] == pytest.approx(value)


def test_bolt_follows_its_lever_closely_while_it_is_driven(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    lever, bolt = model.joint("lever_turn"), model.joint("bolt_slide")
    worst = 0.0
    for step in range(1000):
        data.qfrc_applied[lever.dofadr[0]] = 1.2 * np.sin(step / 40.0)
        mujoco.mj_step(model, data)
        follows = -0.02 * data.qpos[lever.qposadr[0]] + 0.005
        worst = max(worst, abs(data.qpos[bolt.qposadr[0]] - follows))
    assert worst < 1e-4


def test_heavy_tray_stops_at_its_limit(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    tray = model.joint("tray_slide")
    data.qfrc_applied[tray.dofadr[0]] = 50.0
    for _ in range(1000):
        mujoco.mj_step(model, data)
    assert data.qpos[tray.qposadr[0]] == pytest.approx(0.2, abs=5e-4)


@pytest.fixture(scope="module")
def exported(cabinet: Asset, nested: Asset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two assets that share materials, and one with maps, in directories side by side."""
    folder = tmp_path_factory.mktemp("scene")
    for asset in (with_push(cabinet), nested):
        export(asset, folder / asset.name, formats=("mjcf",), textures=0)
    export(textured(), folder / "textured", formats=("mjcf",), textures=256)
    return folder


SCENE = ("cabinet_7", "arm_1", "cabinet_7", "textured", "textured")


def check_scene(model: mujoco.MjModel, exported: Path, prefixes: list[str]) -> None:
    """Check that everything of each file is in the scene, under its prefix."""
    alone = [mujoco.MjModel.from_xml_path(str(exported / name / f"{name}.xml")) for name in SCENE]
    for count in ("njnt", "neq", "nsite", "ngeom", "ntuple", "ntext", "nmesh", "nmat", "ntex"):
        assert getattr(model, count) == sum(getattr(each, count) for each in alone), count
    for prefix, each in zip(prefixes, alone, strict=True):
        for number in range(each.nsite):
            found = model.site(prefix + each.site(number).name)
            np.testing.assert_array_equal(found.user, each.site(number).user)
        mine = {name: text for name, text in texts(model).items() if name.startswith(prefix)}
        assert mine == {prefix + name: text for name, text in texts(each).items()}
        for name, rows in tuples(each).items():
            assert tuples(model)[prefix + name] == [(prefix + row, number) for row, number in rows]


def test_assets_attach_to_one_scene_twice_and_beside_others(exported: Path) -> None:
    scene, prefixes = mujoco.MjSpec(), []
    for number, name in enumerate(SCENE):
        child = mujoco.MjSpec.from_file(str(exported / name / f"{name}.xml"))
        prefixes.append(f"n{number}_")
        scene.attach(child, prefix=prefixes[-1], frame=scene.worldbody.add_frame(pos=[2.0 * number, 0, 0]))
    with silence():
        model = scene.compile()
    check_scene(model, exported, prefixes)


def test_assets_attach_to_one_scene_in_xml(exported: Path) -> None:
    files = "".join(f'<model name="{name}" file="{name}/{name}.xml"/>' for name in sorted(set(SCENE)))
    bases = {"cabinet_7": "body", "arm_1": "stand", "textured": textured().links[0].name}
    prefixes = [f"n{number}_" for number in range(len(SCENE))]
    attached = "".join(
        f'<frame pos="{number} 0 0"><attach model="{name}" body="{bases[name]}" prefix="n{number}_"/></frame>'
        for number, name in enumerate(SCENE)
    )
    path = exported / "scene.xml"
    path.write_text(f"<mujoco><asset>{files}</asset><worldbody>{attached}</worldbody></mujoco>")
    with silence():
        model = mujoco.MjModel.from_xml_path(str(path))
    check_scene(model, exported, prefixes)


def test_two_assets_of_the_same_materials_are_included_in_one_scene(exported: Path) -> None:
    path = exported / "included.xml"
    path.write_text(
        '<mujoco><include file="cabinet_7/cabinet_7.xml"/><include file="arm_1/arm_1.xml"/></mujoco>'
    )
    with silence():
        model = mujoco.MjModel.from_xml_path(str(path))
    assert model.njnt == 7 + 4
    assert model.neq == 2
    names = {model.material(number).name for number in range(model.nmat)}
    assert {"cabinet_7_oak", "arm_1_oak", "cabinet_7_rubber", "arm_1_rubber"} <= names
    for number in range(model.ngeom):
        if model.geom_group[number] == 3:
            assert model.geom_solref[number] == pytest.approx([0.005, 1.0])


@pytest.mark.parametrize(
    ("feature", "where"),
    [("joint velocity limit", "lid_hinge"), ("locked joint", "foot_lock"), ("joint dependency", "lid_hinge")],
)
def test_what_mjcf_cannot_say_is_listed(written: Written, feature: str, where: str) -> None:
    found = [loss for loss in written.losses if loss.feature == feature]
    assert len(found) == 1
    assert where in found[0].where.split(", ")


@pytest.mark.parametrize("fixture", ["cabinet", "free_cabinet", "nested"])
def test_same_asset_gives_same_bytes(
    fixture: str, request: pytest.FixtureRequest, make_asset: Callable[[str], Asset]
) -> None:
    assert write_mjcf(request.getfixturevalue(fixture)).files == write_mjcf(make_asset(fixture)).files


def test_dry_friction_holds_a_rod_that_hangs(tmp_path: Path) -> None:
    body = part(box(0.1, 0.1, 0.1).at(z=0.5), "body", material("steel"))
    rod = part(cylinder(0.01, 0.4).at(0.2, 0, 0.3), "rod", material("steel"))
    slide = Prismatic("slide", axis=-Z, limits=(0, 0.2), friction=30.0)  # the rod weighs 10 N
    asset = evaluated(body.attach(rod, slide), "hanger")
    directory = asset.export(tmp_path / "hanger", formats=("mjcf",))
    model = mujoco.MjModel.from_xml_path(str(directory / "hanger.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=round(5.0 / model.opt.timestep))
    assert abs(data.joint("slide").qpos[0]) < 1e-4


ROLES = mujoco.mjtTextureRole
LAYERS = ("rgb", "normal", "roughness", "metallic", "emissive")


def layers(model: mujoco.MjModel, name: str) -> dict[str, str]:
    """Return the file of each map of a material by role; the name where it has none."""
    textures = model.mat_texid[model.material(f"textured_{name}").id]
    roles = {role: getattr(ROLES, f"mjTEXROLE_{role.upper()}") for role in LAYERS}
    found = {role: int(textures[number.value]) for role, number in roles.items()}
    assert sum(number >= 0 for number in textures) == sum(number >= 0 for number in found.values())
    return {
        role: model.texture(number).name.removeprefix("textured_")
        for role, number in found.items()
        if number >= 0
    }


@pytest.mark.parametrize("size", [0, 256])
def test_materials_have_their_maps_by_role_and_load_in_silence(size: int, tmp_path: Path) -> None:
    directory = export(textured(), tmp_path / "it", formats=("mjcf",), textures=size)
    with silence():
        model = mujoco.MjModel.from_xml_path(str(directory / "textured.xml"))
    maps = {"board": {"rgb", "normal", "roughness"}, "turned": {"rgb", "normal", "roughness"},
            "plate": {"roughness", "metallic"}, "pane": {"roughness"}}  # fmt: skip
    for name, roles in maps.items():
        assert set(layers(model, name)) == (roles if size else set()), name
    assert layers(model, "lamp") == {"emissive": "lamp_emission"}
    assert len({model.texture(number).name for number in range(model.ntex)}) == model.ntex
    files = sorted((directory / "meshes/textures").glob("*.png")) if size else []
    names = {model.texture(number).name for number in range(model.ntex)}
    assert {f"textured_{path.stem}" for path in files} == names - {"textured_lamp_emission"}
    assert layers(model, "board").get("normal") == layers(model, "turned").get("normal"), "one file for both"
    for geom in range(model.ngeom):
        if model.geom_group[geom] == 2:
            link = model.body(model.geom_bodyid[geom]).name
            wanted = {"plank": "turned"}.get(link, link)
            assert model.material(model.geom_matid[geom]).name == f"textured_{wanted}"


def test_maps_are_absolute_so_that_numbers_beside_them_are_one(tmp_path: Path) -> None:
    directory = export(textured(), tmp_path / "it", formats=("mjcf",), textures=256)
    model = mujoco.MjModel.from_xml_path(str(directory / "textured.xml"))
    expected = {BOARD: (1.0, 0.0), TURNED: (1.0, 0.0), PLATE: (1.0, 1.0), PANE: (1.0, 0.0), LAMP: (0.5, 0.0)}
    for stuff, (roughness, metallic) in expected.items():
        found = model.material(f"textured_{stuff.name}")
        color = (1.0, 1.0, 1.0) if stuff in (BOARD, TURNED) else display_color(stuff.base_color)
        np.testing.assert_allclose(found.rgba, [*color, stuff.opacity], atol=1e-6)
        assert model.mat_roughness[found.id] == roughness, stuff.name
        assert model.mat_metallic[found.id] == metallic, stuff.name
        assert 0.0 < found.specular[0] <= 1.0
        assert 0.0 < found.shininess[0] <= 1.0


def test_light_of_a_lamp_has_its_color(tmp_path: Path) -> None:
    model = mujoco.MjModel.from_xml_path(
        str(export(textured(), tmp_path / "it", formats=("mjcf",), textures=0) / "textured.xml")
    )
    texture = model.texture("textured_lamp_emission")
    texel = model.tex_data[int(texture.adr[0]) :][:3] / 255.0
    np.testing.assert_allclose(texel * model.material("textured_lamp").emission[0], LAMP.emission, atol=0.02)


def test_picture_is_upright_in_mujoco(tmp_path: Path) -> None:
    """MuJoCo counts rows and v from the top, OBJ counts v from below: MuJoCo turns v as it loads a mesh."""
    asset = textured()
    directory = export(asset, tmp_path / "it", formats=("mjcf",), textures=256)
    model = mujoco.MjModel.from_xml_path(str(directory / "textured.xml"))
    name = layers(model, "board")["rgb"]
    mesh, texture = model.mesh("board_board_board"), model.texture(f"textured_{name}")
    start, count = model.mesh_texcoordadr[mesh.id], model.mesh_texcoordnum[mesh.id]
    found = model.mesh_texcoord[start : start + count]
    surface = asset.link("board").surfaces[0]
    wanted = texture_coordinates(surface.mesh, surface.material) * [1.0, -1.0] + [0.0, 1.0]
    assert np.abs(found[:, None] - wanted[None]).max(axis=2).min(axis=1).max() < 1e-5
    pixels = model.tex_data[int(texture.adr[0]) :][: 256 * 256 * 3].reshape(256, 256, 3)
    with Image.open(directory / "meshes/textures" / f"{name}.png") as image:
        np.testing.assert_array_equal(pixels, np.asarray(image))


def test_losses_name_coat_and_transmission() -> None:
    losses = {loss.feature: loss.where for loss in write_mjcf(textured(), 256).losses}
    assert "plate" in losses["coat"].split(", ")
    assert losses["transmission"] == "pane"
    assert "texture" not in losses
