"""What robosuite and RoboCasa read in the layout `robocasa`, by the rules of their code, and how it moves."""

import json
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pytest
from manifold3d import Manifold, OpType
from numpy.typing import NDArray

import artgen
from artgen import box, material, part
from artgen.asset import Asset
from artgen.errors import ExportError
from artgen.export import export
from artgen.export.frames import seen_box
from artgen.export.layouts.robocasa import write_robocasa
from artgen.export.layouts.robocasa.regions import interiors
from artgen.validate import validate
from support.proof_fridges import evaluated, french_fridge, fridge
from support.readers import silence
from support.textured import recipes, textured

Array = NDArray[np.float64]

SITES = ("bottom_site", "top_site", "horizontal_radius_site")


@pytest.fixture(scope="module")
def root(cabinet: Asset) -> ET.Element:
    return ET.fromstring(write_robocasa(cabinet, "mjcf", 0).files["model.xml"])


def load(asset: Asset, folder: Path, textures: int = 0) -> mujoco.MjModel:
    """Return what MuJoCo makes of an asset in the layout."""
    directory = export(asset, folder / asset.name, layout="robocasa", textures=textures)
    with silence():
        return mujoco.MjModel.from_xml_path(str(directory / "model.xml"))


def regions(root: ET.Element) -> dict[str, Array]:
    """Return the regions as RoboCasa reads them: corners of a box, shape (2, 3), by name."""
    found = {}
    for geom in root.iterfind("worldbody//geom"):
        name = geom.get("name", "")
        if name.startswith("reg_"):
            middle, half = (np.array(geom.attrib[key].split(), float) for key in ("pos", "size"))
            found[name[4:]] = np.array([middle - half, middle + half])
    return found


def numbers(element: ET.Element | None, key: str = "pos") -> Array:
    assert element is not None
    return np.array(element.attrib[key].split(), float)


def test_object_is_where_robosuite_looks(root: ET.Element, cabinet: Asset) -> None:
    assert len(root.findall("worldbody/body")) == 1
    assert len(root.findall("worldbody/body/body[@name='object']")) == 1
    assert {site.get("name") for site in root.iterfind("worldbody/body/site")} == set(SITES)
    names = {body.get("name") for body in root.iterfind("worldbody/body/body//body")}
    assert names == {link.name for link in cabinet.links}


def test_defaults_are_of_one_level_and_complete(root: ET.Element) -> None:
    """Robosuite puts the attributes of the class of an element into it, and knows no other inheritance."""
    classes = {
        each.get("class"): {child.tag: child.attrib for child in each} for each in root.iterfind("default/*")
    }
    assert set(classes) == {"visual", "collision", "region"}
    assert not root.findall("default/default/default")
    for element in root.iterfind("worldbody//*"):
        assert "childclass" not in element.attrib
        if element.tag == "geom":
            group = classes[element.attrib["class"]]["geom"]["group"]
            assert group == ("0" if "collider" in element.attrib["name"] else "1")
        elif element.tag == "joint":
            assert {"solreflimit", "solreffriction", "solimpfriction"} <= set(element.attrib)


def test_every_size_can_be_scaled(root: ET.Element) -> None:
    """RoboCasa takes two or three numbers for the size of a geom, also of a sphere."""
    sizes = {geom.get("type"): numbers(geom, "size") for geom in root.iterfind("worldbody//geom[@size]")}
    assert {"box", "cylinder", "capsule", "sphere"} <= set(sizes)
    assert all(len(size) in (2, 3) for size in sizes.values())
    np.testing.assert_array_equal(sizes["sphere"], [0.02] * 3)


def test_files_are_relative_to_the_model(tmp_path: Path) -> None:
    with recipes():
        directory = export(textured(), tmp_path / "it", layout="robocasa", textures=256)
    root = ET.parse(directory / "model.xml").getroot()
    assert not {"meshdir", "texturedir", "assetdir"} & set(root.find("compiler").attrib)  # type: ignore[union-attr]
    files = [element.attrib["file"] for element in root.iterfind("asset/*[@file]")]
    assert any(file.endswith(".png") for file in files)
    assert all((directory / file).is_file() for file in files)


@pytest.mark.parametrize("fixture", ["cabinet", "nested"])
def test_model_is_the_one_of_the_flat_layout(
    fixture: str, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    asset: Asset = request.getfixturevalue(fixture)
    model = load(asset, tmp_path / "robocasa")
    directory = export(asset, tmp_path / "flat", formats=("mjcf",), textures=0)
    flat = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.xml"))
    for link in asset.links:
        one, other = model.body(link.name), flat.body(link.name)
        np.testing.assert_array_equal(one.inertia, other.inertia)
        assert one.mass[0] == other.mass[0]
    assert model.body("object").mass[0] == 0.0
    fields = ("range", "stiffness", "damping", "frictionloss", "armature", "solref", "solimp", "axis")
    assert model.njnt == flat.njnt
    for number in range(flat.njnt):
        one, other = model.joint(flat.joint(number).name), flat.joint(number)
        for field in fields:
            np.testing.assert_array_equal(getattr(one, field), getattr(other, field), err_msg=field)
    np.testing.assert_array_equal(model.jnt_actfrcrange, flat.jnt_actfrcrange)
    np.testing.assert_array_equal(model.eq_data, flat.eq_data)
    for number in range(flat.ngeom):
        one, other = model.geom(flat.geom(number).name), flat.geom(number)
        for field in (
            "type",
            "contype",
            "conaffinity",
            "friction",
            "solref",
            "solimp",
            "rbound",
            "pos",
            "quat",
        ):
            np.testing.assert_array_equal(getattr(one, field), getattr(other, field), err_msg=field)
    data, other_data = mujoco.MjData(model), mujoco.MjData(flat)
    mujoco.mj_step(model, data, nstep=200)
    mujoco.mj_step(flat, other_data, nstep=200)
    np.testing.assert_allclose(data.qpos, other_data.qpos, atol=1e-9)


def test_sites_tell_the_size_as_the_origin_sees_it(root: ET.Element, cabinet: Asset) -> None:
    low, high = seen_box(cabinet)
    outer = root.find("worldbody/body")
    assert outer is not None
    bottom, top, radius = (numbers(outer.find(f"site[@name='{name}']")) for name in SITES)
    assert (bottom[2], top[2]) == (pytest.approx(low[2]), pytest.approx(high[2]))
    np.testing.assert_allclose(radius[:2], np.maximum(-low, high)[:2], atol=1e-6)
    half = radius - bottom  # robosuite's half size of the bounding box
    assert (bottom + [0, 0, half[2]] - half <= low + 1e-6).all()
    assert (bottom + [0, 0, half[2]] + half >= high - 1e-6).all()


def test_main_region_is_the_box_of_what_is_seen(root: ET.Element, cabinet: Asset) -> None:
    found = regions(root)
    for name in ("main", "bbox"):
        np.testing.assert_allclose(found[name], seen_box(cabinet), atol=1e-6)
    for geom in root.iterfind("worldbody//geom[@class='region']"):
        assert {"pos", "size"} <= set(geom.attrib)
        assert "quat" not in geom.attrib
    low, high = seen_box(cabinet)
    for corner, wanted in {"p0": low, "px": (high[0], *low[1:]), "pz": (*low[:2], high[2])}.items():
        np.testing.assert_allclose(numbers(root.find(f".//site[@name='ext_{corner}']")), wanted, atol=1e-6)


def test_box_of_a_link_moves_with_it(cabinet: Asset, tmp_path: Path) -> None:
    model = load(cabinet, tmp_path)
    data = mujoco.MjData(model)
    for name, position in cabinet.positions({"lid_hinge": 0.0}).items():
        if not cabinet.joint(name).locked:
            data.qpos[model.joint(name).qposadr[0]] = position if name != "tray_slide" else 0.0
    mujoco.mj_kinematics(model, data)
    for name in ("lid", "tray", "body"):
        site, bounds = model.site(f"reg_{name}"), cabinet.link(name).bounds()
        np.testing.assert_allclose(site.size, (bounds[1] - bounds[0]) / 2, atol=1e-6)
        np.testing.assert_allclose(data.site(f"reg_{name}").xpos, bounds.mean(axis=0), atol=1e-6)


@pytest.mark.parametrize("make", [fridge, french_fridge])
def test_rooms_of_a_fridge_are_free_and_large(make: Callable[[], Asset]) -> None:
    asset = make()
    rooms = interiors(asset)
    assert len(rooms) >= 2
    pieces = [piece.shape.manifold for link in asset.links for piece in link.pieces]
    solids = Manifold.batch_boolean(pieces, OpType.Add)
    outer = asset.link("body").bounds()
    volumes = []
    for room in rooms:
        size = room[1] - room[0]
        assert size.min() >= 0.08
        assert (room[0] > outer[0] - 0.2).all()
        assert (room[1] < outer[1] + 1e-6).all()
        solid = Manifold.cube(size.tolist()).translate(room[0].tolist())
        assert (solids ^ solid).volume() < 1e-9
        volumes.append(size.prod())
    assert volumes == sorted(volumes, reverse=True)
    for number, room in enumerate(rooms):
        for other in rooms[number + 1 :]:
            assert (np.minimum(room[1], other[1]) - np.maximum(room[0], other[0])).min() <= 1e-6
    found = regions(ET.fromstring(write_robocasa(asset, "mjcf", 0).files["model.xml"]))
    np.testing.assert_allclose(found["int"], rooms[0], atol=1e-6)
    assert len(found) == len(rooms) + 2


def test_room_is_found_where_something_can_be_put() -> None:
    steel = material("steel")
    walls = box(0.5, 0.5, 0.4) - box(0.46, 0.46, 0.36)
    tub = evaluated(part(walls - box(0.46, 0.46, 0.1).at(z=0.2), "tub", steel), "tub")
    (room,) = interiors(tub)
    np.testing.assert_allclose(room[:, :2], [[-0.23, -0.23], [0.23, 0.23]], atol=0.02)
    assert interiors(evaluated(part(walls, "tank", steel), "tank")) == [], "nothing opens it"
    assert interiors(evaluated(part(box(0.5, 0.5, 0.4), "block", steel), "block")) == []


@pytest.mark.parametrize("category", ["door", "handle"])
def test_nothing_is_put_into_doors_and_handles(category: str) -> None:
    for seed in range(2):
        assert interiors(artgen.generate(category, seed=seed, certify=False)) == []


def test_free_object_is_free_in_mujoco_and_where_readers_add_a_joint(
    free_cabinet: Asset, tmp_path: Path
) -> None:
    model = load(free_cabinet, tmp_path)
    assert model.nq == 7 + 7
    root = ET.parse(tmp_path / free_cabinet.name / "model.xml").getroot()
    assert root.find("worldbody/body/freejoint") is not None
    assert root.find("worldbody/body/body//freejoint") is None
    world, inner = root.find("worldbody"), root.find("worldbody/body/body")
    assert world is not None
    assert inner is not None
    world.remove(world[0])  # robosuite takes the object out of its wrapping
    world.append(inner)
    inner.append(ET.Element("joint", type="free", name="joint0"))
    path = tmp_path / free_cabinet.name / "joined.xml"
    path.write_bytes(ET.tostring(root))
    joined = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(joined)
    mujoco.mj_step(joined, data, nstep=100)
    assert data.qvel[2] == pytest.approx(-0.2 * 9.81, rel=0.05), "it falls as a whole"


@pytest.mark.parametrize("name", ["object", "main", "reg_lid"])
def test_names_of_the_readers_are_refused(name: str) -> None:
    asset = evaluated(part(box(0.1, 0.1, 0.1), "cube", material("oak"), name=name), "cube")
    with pytest.raises(ExportError, match=rf"cannot hold a link named '{name}'.*give the part another label"):
        write_robocasa(asset, "mjcf", 0)


def test_couplings_that_robosuite_leaves_behind_are_listed(cabinet: Asset) -> None:
    (loss,) = [
        loss
        for loss in write_robocasa(cabinet, "mjcf", 0).losses
        if loss.feature == "joint coupling in robosuite"
    ]
    assert loss.where == "bolt_slide"
    assert "append" in loss.instead


def test_layout_is_recorded_and_holds_mjcf_alone(cabinet: Asset, tmp_path: Path) -> None:
    directory = export(cabinet, tmp_path / "it", layout="robocasa", textures=0)
    assert artgen.asset.files.main_files(directory) == {"mjcf": directory / "model.xml"}
    with pytest.raises(ExportError, match=r"the layout 'robocasa' has no 'urdf'; it holds mjcf"):
        export(cabinet, tmp_path / "other", layout="robocasa", formats=("urdf",))


def test_same_asset_gives_same_bytes(make_asset: Callable[[str], Asset]) -> None:
    assert write_robocasa(make_asset("cabinet"), "mjcf", 0) == write_robocasa(
        make_asset("cabinet"), "mjcf", 0
    )
    assert write_robocasa(fridge(), "mjcf", 0).files == write_robocasa(fridge(), "mjcf", 0).files


def paths(root: ET.Element, steps: str) -> set[str]:
    """Return the names at a path below the body that robosuite takes."""
    return {each.get("name", "") for each in root.iterfind(f"worldbody/body/body/{steps}")}


def joints(root: ET.Element) -> set[str]:
    return {each.get("name", "") for each in root.iterfind("worldbody//joint")}


def seen(category: str, seed: int) -> ET.Element:
    asset = artgen.generate(category, seed=seed, certify=False, detail="low")
    return ET.fromstring(write_robocasa(asset, "mjcf", 0).files["model.xml"])


@pytest.mark.parametrize(
    ("category", "seed", "named", "boxes"),
    [
        ("refrigerator", 2, {"fridge_door0_joint", "freezer_door0_joint"}, {"fridge0", "freezer0"}),
        ("dishwasher", 2, {"door_joint", "rack0_joint", "rack1_joint"}, {"rack0", "rack1"}),
        ("oven", 2, {"door_joint", "rack0_joint", "knob_temp_joint", "knob_time_joint"}, {"rack0"}),
        ("microwave", 2, {"microjoint"}, {"tray"}),
        ("toaster", 2, {"lever0_joint", "knob_doneness0_joint"}, {"slotL", "slotR"}),
        ("kettle", 3, {"switch_joint"}, set()),
        ("faucet", 1, {"handle_joint", "handle_temp_joint", "spout_joint"}, set()),
        ("cabinet", 1, {"doorhinge"}, set()),
        ("toaster_oven", 0, {"door_joint", "rack0_joint", "knob_function_joint"}, {"rack0"}),
        ("toaster_oven", 1, {"knob_temp_joint", "knob_time_joint"}, set()),
        ("stand_mixer", 0, {"knob_speed_joint"}, {"bowl"}),
        ("sink", 0, {"handle_joint", "handle_temp_joint", "spout_joint"}, {"basin_left", "basin_right"}),
        ("sink", 4, {"spout_joint"}, {"basin"}),
    ],
)
def test_fixtures_have_the_joints_and_regions_of_their_classes(
    category: str, seed: int, named: set[str], boxes: set[str]
) -> None:
    root = seen(category, seed)
    assert named <= joints(root)
    assert boxes <= set(regions(root))


def test_racks_are_bodies_and_regions_above_their_floors() -> None:
    asset = artgen.generate("oven", seed=2, certify=False, detail="low")
    root = ET.fromstring(write_robocasa(asset, "mjcf", 0).files["model.xml"])
    assert "rack0" in paths(root, "/body")
    low, high = regions(root)["rack0"]
    rack, cavity = asset.link("rack_0").bounds(), asset.bounds()
    assert rack[0, 2] <= low[2] <= rack[1, 2] < high[2] < cavity[1, 2]
    assert (rack[0, :2] < low[:2]).all()
    assert (high[:2] < rack[1, :2]).all()


def test_dials_and_burners_of_a_stove_are_named_by_place() -> None:
    """RoboCasa looks for dials one step below the object, and for burners in the object itself."""
    root = seen("cooktop", 2)
    places = {f"{row}_{side}" for row in ("front", "rear") for side in ("left", "right")}
    assert {f"knob_{place}_joint" for place in places} <= paths(root, "body/joint")
    sites = {each.get("name", ""): numbers(each) for each in root.iterfind("worldbody/body/body/site")}
    assert {f"burner_on_{place}" for place in places} <= set(sites)
    assert sites["burner_on_front_left"][0] < 0.0 < sites["burner_on_rear_right"][0]
    assert sites["burner_on_front_left"][1] < sites["burner_on_rear_left"][1]


def test_start_and_stop_of_a_microwave_are_geoms_on_two_keys() -> None:
    asset = artgen.generate("microwave", seed=2, certify=False, detail="low")
    root = ET.fromstring(write_robocasa(asset, "mjcf", 0).files["model.xml"])
    owners = {
        geom.get("name"): body.get("name") for body in root.iter("body") for geom in body.iterfind("geom")
    }
    keys = [link.name for link in asset.links if link.name.startswith("key_")]
    assert owners["start_button"] == keys[-1]
    assert owners["stop_button"] in keys[:-1]


def test_water_falls_from_the_spout_into_the_basin() -> None:
    root = seen("faucet", 1)
    water = root.find("worldbody/body/body/body/site[@name='water']")
    assert water is not None
    assert numbers(water, "size")[1] > 0.05


@pytest.mark.parametrize("seed", [0, 1, 6])
def test_a_cup_stands_below_the_coffee(seed: int) -> None:
    root = seen("coffee_machine", seed)
    sites = {each.get("name", ""): each for each in root.iterfind("worldbody/body/body/site")}
    cup, stream = numbers(sites["receptacle_place_site"]), sites["coffee_liquid"]
    assert numbers(stream)[:2] == pytest.approx(cup[:2])
    assert numbers(stream)[2] - numbers(stream, "size")[1] == pytest.approx(cup[2], abs=1e-6)
    assert 0.0 < cup[2] < 0.2
    assert root.find("worldbody//geom[@name='start_button']") is not None


def test_names_of_the_asset_are_beside_the_file(tmp_path: Path) -> None:
    asset = artgen.generate("oven", seed=2, certify=False, detail="low")
    directory = asset.export(tmp_path / "oven", layout="robocasa", textures=0)
    names = json.loads((directory / "artgen_names.json").read_text())
    model = mujoco.MjModel.from_xml_path(str(directory / "model.xml"))
    assert names["joints"]["rack0_joint"] == {"name": "rack_slide_0", "sign": 1}
    assert names["links"]["rack0"] == "rack_0"
    assert {model.joint(number).name for number in range(model.njnt)} <= set(names["joints"])


@pytest.mark.parametrize(("category", "seed"), [("oven", 1), ("faucet", 1), ("dishwasher", 2)])
def test_files_with_names_of_fixtures_are_read_back_in_those_of_the_asset(
    category: str, seed: int, tmp_path: Path
) -> None:
    asset = artgen.generate(category, seed=seed, certify=False, detail="low")
    directory = asset.export(tmp_path / category, layout="robocasa", textures=0)
    report = validate(directory, checks=["files", "mjcf"])
    assert not [str(finding) for result in report.results for finding in result.findings]
