"""The layout of the PartNet-Mobility dataset, read back as its loaders do, and by the real ones."""

import json
import math
import os
import re
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh

import artgen
from artgen.asset import Asset
from artgen.asset import AssetCoupling as Coupling
from artgen.asset.joint import JointKind
from artgen.errors import ExportError
from artgen.export import export
from artgen.export.files import encode
from artgen.export.layouts.partnet.names import semantic
from artgen.validate.clients.exported import read_exported
from artgen.validate.clients.install import interpreters
from artgen.validate.clients.registry import CLIENTS, Client
from artgen.validate.clients.run import run_client
from support.exports import edit_text
from support.partnet import TO_BASE, TO_MESH, pose_errors, robot, table
from support.textured import recipes, textured

LAYOUT = "partnet-mobility"
REAL = (("door", 0), ("door", 2), ("door", 7), ("handle", 1), ("handle", 5))
MOTIONS = {"slider", "free", "hinge", "heavy", "static", "slider+"}  # that the dataset knows
OPEN_CABINET = Path(__file__).parents[1] / "support" / "partnet_open_cabinet.py"


@pytest.fixture(scope="module")
def directory(asset: Asset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return export(asset, tmp_path_factory.mktemp("partnet") / asset.name, layout=LAYOUT, textures=0)


@pytest.fixture(scope="module", params=REAL)
def real(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Asset, Path]:
    category, seed = request.param
    asset = artgen.generate(category, seed=seed, certify=False).with_base("free" if seed == 2 else "fixed")
    return asset, asset.export(tmp_path_factory.mktemp("real") / asset.name, layout=LAYOUT, textures=0)


def turned_round(asset: Asset, *names: str) -> Asset:
    """Return an asset with some joints about the opposite axis, which close at their upper limit then."""
    joints = []
    for joint in asset.joints:
        sign = -1.0 if joint.name in names else 1.0
        follows = joint.follows
        if follows is not None:
            leader = -1.0 if follows.leader in names else 1.0
            follows = Coupling(follows.leader, sign * leader * follows.ratio, sign * follows.offset)
        limits = joint.limits
        if sign < 0 and limits is not None:
            limits = (-limits[1], -limits[0])
        changed = {"axis": sign * joint.axis, "limits": limits, "rest": sign * joint.rest, "follows": follows}
        joints.append(replace(joint, **changed))
    return replace(asset, joints=tuple(joints))


def losses_of(directory: Path) -> dict[str, dict[str, str]]:
    losses = table(directory, "asset.json")["formats"]["urdf"]["losses"]
    return {item["feature"]: item for item in losses}


def attributes(directory: Path, path: str, key: str) -> list[str]:
    return [element.attrib[key] for element in robot(directory).iterfind(path)]


def test_bodies_are_numbered_below_a_base_that_turns_them_upright(asset: Asset, directory: Path) -> None:
    links = attributes(directory, "link", "name")
    assert [name for name in links if "helper" not in name] == [
        "base",
        *(f"link_{number}" for number in range(len(asset.links))),
    ]
    root = f"link_{len(asset.links) - 1}"
    assert table(directory, "artgen_names.json")["links"][root] == asset.links[0].name
    upright = next(
        item for item in robot(directory).iterfind("joint") if item.find("parent").get("link") == "base"
    )
    assert upright.get("type") == "fixed"
    assert upright.find("child").get("link") == root
    angles = [float(angle) for angle in upright.find("origin").get("rpy").split()]
    assert angles == pytest.approx([math.pi / 2, 0.0, -math.pi / 2], abs=1e-15)
    for joint in robot(directory).iterfind("joint"):
        child = joint.find("child").get("link")
        if "helper" not in child:
            assert joint.get("name") == child.replace("link", "joint")


def test_the_pieces_between_several_joints_are_helpers_as_in_the_dataset(
    nested: Asset, tmp_path: Path
) -> None:
    export(nested, tmp_path / "a", layout=LAYOUT, textures=0)
    links = attributes(tmp_path / "a", "link", "name")
    assert len(links) == len(set(links))
    assert [name for name in links if "helper" in name] == ["link_0_helper", "link_0_helper_"]
    joints = attributes(tmp_path / "a", "joint", "name")
    assert len(joints) == len(set(joints)) == len(nested.joints) + 1
    assert "slider+" in (tmp_path / "a" / "semantics.txt").read_text()


def test_every_body_is_where_the_asset_has_it_at_random_positions(
    asset: Asset, directory: Path, draw_positions: Callable[[Asset, int], dict[str, float]]
) -> None:
    for seed in range(5):
        q = draw_positions(asset, seed)
        assert max(pose_errors(asset, directory, q).values()) < 1e-9, (seed, q)


BETWEEN = {"knob_turn", "bolt_slide"}  # of the cabinet: closed in the middle of their limits


@pytest.mark.parametrize("seed", range(3))
def test_joints_that_close_at_their_upper_limit_are_turned_round(
    cabinet: Asset, seed: int, tmp_path: Path, draw_positions: Callable[[Asset, int], dict[str, float]]
) -> None:
    names = [joint.name for joint in cabinet.joints if joint.limits is not None and not joint.locked]
    chosen = {name for number, name in enumerate(names) if (number + seed) % 3}
    asset = turned_round(cabinet, *chosen)
    directory = export(asset, tmp_path / "turned", layout=LAYOUT, textures=0)
    where = losses_of(directory)["direction of a joint"]["where"].split(", ")
    assert set(where) == chosen - BETWEEN
    named = table(directory, "artgen_names.json")
    written = {item.get("name"): item for item in robot(directory).iterfind("joint")}
    by_name = {item["name"]: written[number] for number, item in named["joints"].items()}
    for name in set(names) - BETWEEN:
        joint, element = cabinet.joint(name), by_name[name]
        limits = [float(element.find("limit").get(key)) for key in ("lower", "upper")]
        assert limits == pytest.approx(joint.limits), name
        assert limits[0] == pytest.approx(joint.closed), name
        axis = [float(word) for word in element.find("axis").get("xyz").split()]
        assert axis == pytest.approx(list(TO_MESH @ joint.axis)), name
    assert max(pose_errors(asset, directory, draw_positions(asset, seed)).values()) < 1e-9
    original = export(cabinet, tmp_path / "original", layout=LAYOUT, textures=0)
    ((leader, ratio, offset),) = table(original, "artgen_names.json")["couplings"].values()
    sign = -1.0 if "bolt_slide" in chosen else 1.0
    assert list(named["couplings"].values()) == [[leader, sign * ratio, sign * offset]]
    springs = [
        {item.get("reference"): item.findtext("springReference") for item in robot(folder).iterfind("gazebo")}
        for folder in (directory, original)
    ]
    kept = next(number for number, item in named["joints"].items() if item["name"] == "lid_hinge")
    assert springs[0][kept] == springs[1][kept]


def test_a_joint_that_closes_between_its_limits_keeps_them_and_says_so(
    cabinet: Asset, tmp_path: Path
) -> None:
    export(cabinet, tmp_path / "a", layout=LAYOUT, textures=0)
    assert set(losses_of(tmp_path / "a")["closed position"]["where"].split(", ")) == BETWEEN


def test_lower_limit_is_closed_wherever_a_joint_closes_at_an_end(real: tuple[Asset, Path]) -> None:
    asset, directory = real
    named = table(directory, "artgen_names.json")["joints"]
    between = losses_of(directory).get("closed position", {"where": ""})["where"].split(", ")
    for element in robot(directory).iterfind("joint"):
        limit = element.find("limit")
        if limit is None or limit.get("lower") is None:
            continue
        joint = asset.joint(named[element.get("name")]["name"])
        closed = named[element.get("name")]["sign"] * joint.closed
        if joint.name in between:
            assert joint.limits[0] < joint.closed < joint.limits[1]
        else:
            assert float(limit.get("lower")) == pytest.approx(closed, abs=1e-9), joint.name


def test_masses_are_the_assets_and_the_base_adds_a_microgram(asset: Asset, directory: Path) -> None:
    named = table(directory, "artgen_names.json")["links"]
    total = 0.0
    for element in robot(directory).iterfind("link"):
        mass = float(element.find("inertial/mass").get("value"))
        total += mass
        if element.get("name") not in named:
            assert mass <= 1e-6
            continue
        properties = asset.link(named[element.get("name")]).mass_properties
        assert mass == pytest.approx(properties.mass, rel=1e-11)
        values = element.find("inertial/inertia").attrib
        found = np.array([[float(values["i" + "".join(sorted(a + b))]) for b in "xyz"] for a in "xyz"])
        wanted = TO_MESH @ properties.inertia @ TO_MESH.T
        assert np.allclose(found, wanted, rtol=1e-10, atol=1e-11 * np.trace(wanted))
    helpers = sum("helper" in name for name in attributes(directory, "link", "name"))
    assert total == pytest.approx(asset.mass + helpers * 1e-6, abs=1e-8)


def test_colliders_are_one_convex_piece_each_and_the_twin_has_the_same(real: tuple[Asset, Path]) -> None:
    asset, directory = real
    assert (directory / "mobility.urdf").read_bytes() == (directory / "mobility_cvx.urdf").read_bytes()
    pieces = [
        element
        for element in robot(directory).iterfind("link/collision")
        if "_end_" not in element.get("name")
    ]
    assert len(pieces) == sum(len(link.colliders) for link in asset.links)
    meshes = [element.find("geometry/mesh") for element in pieces]
    for mesh in [mesh for mesh in meshes if mesh is not None]:
        solid = trimesh.load(directory / mesh.get("filename"), force="mesh")
        assert solid.is_watertight, mesh.get("filename")
        assert solid.convex_hull.volume == pytest.approx(solid.volume, rel=1e-6), mesh.get("filename")
        assert len(solid.split()) == 1, mesh.get("filename")


def test_colliders_and_what_is_seen_fill_the_same_box(real: tuple[Asset, Path]) -> None:
    """Each mesh is in coordinates of the object, and its origin takes it to its body."""
    asset, directory = real
    named = table(directory, "artgen_names.json")["links"]
    for element in robot(directory).iterfind("link"):
        if element.get("name") not in named:
            continue
        link = asset.link(named[element.get("name")])
        seen = element.find("visual/origin").get("xyz").split()
        assert [float(word) for word in seen] == pytest.approx(
            list(-TO_MESH @ asset.origin(link.name)), abs=1e-9
        )
        files = [item.get("filename") for item in element.iterfind("visual/geometry/mesh")]
        corners = np.concatenate([trimesh.load(directory / file, force="mesh").bounds for file in files])
        wanted = link.bounds() @ TO_MESH.T
        assert np.allclose(corners.min(axis=0), wanted.min(axis=0), atol=1e-6)
        assert np.allclose(corners.max(axis=0), wanted.max(axis=0), atol=1e-6)


def test_what_is_seen_is_all_of_textured_objs(real: tuple[Asset, Path]) -> None:
    _, directory = real
    seen = set(attributes(directory, "link/visual/geometry/mesh", "filename"))
    assert seen == {f"textured_objs/{path.name}" for path in (directory / "textured_objs").glob("*.obj")}
    assert all(".." not in file and (directory / file).is_file() for file in seen)
    listed = [stem for leaf in table(directory, "result.json")[0]["children"] for stem in leaf["objs"]]
    assert sorted(f"textured_objs/{stem}.obj" for stem in listed) == sorted(seen)


def test_trimesh_finds_the_maps(tmp_path: Path) -> None:
    with recipes():
        export(textured(), tmp_path / "textured", layout=LAYOUT, textures=256)
    (board,) = (tmp_path / "textured" / "textured_objs").glob("*_board_board.obj")
    image = trimesh.load(board, force="mesh").visual.material.image
    assert image is not None
    assert image.size == (256, 256)


def test_links_that_a_hand_takes_hold_of_have_a_visual_called_handle(real: tuple[Asset, Path]) -> None:
    asset, directory = real
    named = table(directory, "artgen_names.json")["links"]
    moved = {joint.child for joint in asset.joints if not joint.locked}
    opened = {
        asset.joint(name).child for item in asset.affordances if item.kind == "grasp" for name in item.joints
    }
    for element in robot(directory).iterfind("link"):
        name = named.get(element.get("name"))
        visuals = [visual.get("name") for visual in element.iterfind("visual")]
        if name in moved and (asset.link(name).grasps or name in opened):
            assert any("handle" in visual for visual in visuals), (name, visuals)
        if name in {"frame", "latch", "deadbolt"}:
            assert not any("handle" in visual for visual in visuals), (name, visuals)


def test_the_handle_of_a_link_is_where_its_grasps_are() -> None:
    asset = artgen.generate("handle", seed=5, certify=False)  # a grip, a lever and a thumb latch
    files = encode(asset, layout=LAYOUT, textures=0)
    names = [leaf["name"] for leaf in json.loads(files["result.json"])[0]["children"]]
    assert {"handle", "handle_grip"} <= set(names)
    assert not {"handle_rose", "handle_stand", "handle_door"} & set(names)


@pytest.mark.parametrize("seed", [3, 5, 14])
def test_the_handle_of_a_leaf_is_the_rose_of_its_lever_and_no_pane_of_glass(seed: int) -> None:
    asset = artgen.generate("door", seed=seed, certify=False)
    files = encode(asset, layout=LAYOUT, textures=0)
    names = [leaf["name"] for leaf in json.loads(files["result.json"])[0]["children"]]
    assert "handle_rose" in names
    assert "handle_glass" not in names


def test_tables_speak_of_the_same_links(asset: Asset, directory: Path) -> None:
    rows = [line.split(" ") for line in (directory / "semantics.txt").read_text().splitlines()]
    assert [row[0] for row in rows] == [f"link_{number}" for number in range(len(asset.links))]
    assert {row[1] for row in rows} <= MOTIONS
    assert rows[-1][1] == ("static" if asset.base == "fixed" else "free")
    mobility = table(directory, "mobility_v2.json")
    assert [item["id"] for item in mobility] == list(range(len(asset.links)))
    assert [item["name"] for item in mobility] == [row[2] for row in rows]
    parents = {
        joint.find("child").get("link"): joint.find("parent").get("link")
        for joint in robot(directory).iterfind("joint")
    }
    leaves = {leaf["id"]: leaf["name"] for leaf in table(directory, "result.json")[0]["children"]}
    visuals = set(attributes(directory, "link/visual", "name"))
    for item in mobility:
        parent = parents[f"link_{item['id']}"]
        while "helper" in parent:
            parent = parents[parent]
        assert parent == ("base" if item["parent"] < 0 else f"link_{item['parent']}")
        for part in item["parts"]:
            assert leaves.pop(part["id"]) == part["name"]
            assert f"{part['name']}-{part['id']}" in visuals
    assert not leaves


def test_hinges_are_in_degrees_and_slides_in_metres(directory: Path) -> None:
    joints = {item.get("name"): item for item in robot(directory).iterfind("joint")}
    for item in table(directory, "mobility_v2.json"):
        limit, element = item["jointData"].get("limit"), joints[f"joint_{item['id']}"]
        if limit is None or limit["rotates"]:
            continue
        assert item["joint"] == ("slider" if element.get("type") == "prismatic" else "hinge")
        assert limit["noLimit"] == (element.get("type") == "continuous")
        if not limit["noLimit"]:
            scale = 1.0 if item["joint"] == "slider" else math.radians(1.0)
            found = [float(element.find("limit").get(key)) for key in ("lower", "upper")]
            assert found == pytest.approx([scale * limit["a"], scale * limit["b"]], abs=1e-9)
        direction = [float(word) for word in element.find("axis").get("xyz").split()]
        assert item["jointData"]["axis"]["direction"] == pytest.approx(direction, abs=1e-9)


def test_boxes_hold_the_asset(asset: Asset, directory: Path) -> None:
    def corners(box: dict[str, list[float]]) -> list[float]:
        return [*box["min"], *box["max"]]

    for box, turn in (
        (table(directory, "bounding_box.json"), TO_MESH),
        (table(directory, "maniskill.json")["bbox"], TO_BASE),
    ):
        wanted = asset.bounds() @ turn.T
        assert corners(box) == pytest.approx([*wanted.min(axis=0), *wanted.max(axis=0)], abs=1e-6)
    assert table(directory, "maniskill.json")["scale"] == 1.0


def test_losses_tell_every_name_and_what_is_left_out(cabinet: Asset, tmp_path: Path) -> None:
    export(cabinet, tmp_path / "a", layout=LAYOUT, textures=0)
    losses = losses_of(tmp_path / "a")
    where = losses["names of links and joints"]["where"].split(", ")
    assert {text.split(" = ")[0] for text in where} == {
        *(link.name for link in cabinet.links),
        *(joint.name for joint in cabinet.joints),
    }
    assert losses["joint coupling"]["where"] == "bolt_slide"
    assert not robot(tmp_path / "a").findall("joint/mimic")
    assert losses["grasp frame"]["where"] == "lid_edge"
    assert "joint dependency" in losses


def test_a_follower_on_its_leaders_link_has_a_mimic(nested: Asset, tmp_path: Path) -> None:
    chain = replace(
        nested,
        joints=tuple(
            replace(joint, parent="arm_reach") if joint.name == "spin" else joint for joint in nested.joints
        ),
    )
    export(chain, tmp_path / "a", layout=LAYOUT, textures=0)
    (mimic,) = robot(tmp_path / "a").findall("joint/mimic")
    assert (float(mimic.get("multiplier")), float(mimic.get("offset"))) == (2.0, 0.1)


def test_the_same_asset_gives_the_same_bytes(make_asset: Callable[[str], Asset]) -> None:
    one, other = (encode(make_asset("nested"), layout=LAYOUT, textures=0) for _ in range(2))
    assert one == other


def test_the_layout_has_urdf_only(cabinet: Asset) -> None:
    with pytest.raises(ExportError, match="the layout 'partnet-mobility' has no 'usd'; it holds urdf"):
        encode(cabinet, ["usd"], layout=LAYOUT)


@pytest.fixture(scope="module", params=("sapien", "mani_skill"))
def client(request: pytest.FixtureRequest) -> Client:
    result = CLIENTS[request.param]
    if not interpreters(result):
        pytest.skip(f"{result.name} is not installed: artgen clients --install {result.name}")
    return result


def test_sapien_reads_what_the_asset_is(client: Client, tmp_path: Path) -> None:
    assets = [artgen.generate(category, seed=seed, certify=False) for category, seed in REAL]
    assets[1] = assets[1].with_base("free")
    exports = [asset.export(tmp_path / asset.name, layout=LAYOUT, textures=0) for asset in assets]
    outcomes = run_client(client, [read_exported(directory) for directory in exports])
    for asset, outcome in zip(assets, outcomes, strict=True):
        assert outcome.state == "passed", (asset.name, outcome.findings)
        count = sum(len(link.colliders) for link in asset.links)
        assert outcome.note.startswith(f"{count} colliders, {asset.mass:.6g} kg"), asset.name


def test_sapien_finds_a_wrong_mass_a_wrong_limit_and_a_wrong_axis(client: Client, tmp_path: Path) -> None:
    asset = artgen.generate("handle", seed=7, certify=False)
    mass = f"{asset.link('handle').mass_properties.mass:.12g}"
    upper = f"{asset.joint('handle_turn').limits[1]:.12g}"
    damages = (
        (f'mass value="{mass}"', 'mass value="0.5"', r"its mass is 0\.5 kg"),
        (f'upper="{upper}"', 'upper="0.5"', r"its limits are 0 to 0\.5 rad"),
        ('axis xyz="0 0', 'axis xyz="0 1', r"its frame is off by"),
    )
    exports = []
    for number, (old, new, _) in enumerate(damages):
        exports.append(asset.export(tmp_path / str(number), layout=LAYOUT, textures=0))
        for name in ("mobility.urdf", "mobility_cvx.urdf"):
            edit_text(exports[-1] / name, old, new)
    outcomes = run_client(client, [read_exported(directory) for directory in exports])
    for (_, new, message), outcome in zip(damages, outcomes, strict=True):
        messages = [finding.message for finding in outcome.findings]
        assert outcome.state == "failed", new
        assert any(re.search(message, text) for text in messages), (new, messages)


@pytest.mark.parametrize(("seed", "openings"), [(1, 1), (7, 2)])
def test_mani_skill_opens_a_door_as_a_cabinet(seed: int, openings: int, tmp_path: Path) -> None:
    """Its own code finds the twin in its asset folder, the handle by name, and closed at the lower limit."""
    programs = interpreters(CLIENTS["mani_skill"])
    if not programs:
        pytest.skip("mani_skill is not installed: artgen clients --install mani_skill")
    asset = artgen.generate("door", seed=seed, certify=False)
    models = tmp_path / "data" / "partnet_mobility" / "dataset"
    models.mkdir(parents=True)
    directory = asset.export(models / "1000", layout=LAYOUT, textures=0)
    result = tmp_path / "result.json"
    subprocess.run(
        [programs[0], OPEN_CABINET, directory, result],
        check=True,
        env=os.environ | {"MS_ASSET_DIR": str(tmp_path)},
        capture_output=True,
        timeout=300,
    )
    found = json.loads(result.read_text())
    assert found["file"] == str(directory / "mobility_cvx.urdf")
    assert len(found["runs"]) == openings
    for run in found["runs"]:
        assert run["height"] == pytest.approx([0.0], abs=1e-5)  # the collision mesh stands on the ground
        assert np.allclose(run["start"], 0.0)
        assert (run["closed"], run["opened"]) == ([False], [True])
        grasps = [item.frame[:3, 3] for item in asset.affordances if item.kind == "grasp"]
        near = min(np.linalg.norm(TO_BASE @ grasp - run["handle"][0]) for grasp in grasps)
        assert near < 0.15, run["link"]


@pytest.mark.parametrize(
    ("category", "label", "kind", "word"),
    [
        ("door", "door", "revolute", "rotation_door"),
        ("door", "door", "prismatic", "translation_door"),
        ("refrigerator", "door", "revolute", "door"),
        ("refrigerator", "freezer_door", "revolute", "door"),
        ("refrigerator", "outer_drawer", "prismatic", "drawer"),
        ("toaster", "lever", "prismatic", "slider"),
        ("toaster", "button", "prismatic", "button"),
        ("lamp", "lever", "revolute", "lever"),
        ("trashcan", "lid", "revolute", "lid"),
        ("trashcan", "pedal", "revolute", "foot_pad"),
        ("cabinet", "door", "revolute", "rotation_door"),
        ("window", "pane", "revolute", "rotation_window"),
        ("window", "pane", "prismatic", "translation_window"),
        ("microwave", "plate", "revolute", "rotation_tray"),
        ("faucet", "handle", "revolute", "switch"),
    ],
)
def test_links_are_called_what_the_dataset_calls_them(
    nested: Asset, category: str, label: str, kind: JointKind, word: str
) -> None:
    asset, link = replace(nested, category=category), replace(nested.links[1], label=label)
    assert semantic(asset, link, [replace(nested.joints[0], kind=kind)]) == word


@pytest.mark.parametrize(
    ("category", "label", "word"),
    [("cabinet", "body", "furniture_body"), ("window", "frame", "window_frame"), ("box", "box", "box_body")],
)
def test_bases_are_called_what_the_dataset_calls_them(
    nested: Asset, category: str, label: str, word: str
) -> None:
    asset, link = replace(nested, category=category), replace(nested.links[0], label=label)
    assert semantic(asset, link, []) == word


@pytest.mark.parametrize(
    ("category", "name"),
    [("trashcan", "TrashCan"), ("dishwasher", "Dishwasher"), ("toaster", "Toaster"), ("plier", "Pliers")],
)
def test_the_dataset_has_categories_of_its_own(nested: Asset, category: str, name: str) -> None:
    files = encode(replace(nested, category=category), layout=LAYOUT, textures=0)
    assert json.loads(files["meta.json"])["model_cat"] == name


@pytest.mark.parametrize(("style", "name"), [("folding", "FoldingChair"), ("office", "Chair")])
def test_a_style_may_be_a_category_of_the_dataset(nested: Asset, style: str, name: str) -> None:
    chair = replace(nested, category="chair", parameters={"style": style})
    files = encode(chair, layout=LAYOUT, textures=0)
    assert json.loads(files["meta.json"])["model_cat"] == name
