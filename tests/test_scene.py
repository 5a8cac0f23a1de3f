"""Scenes: assets at places that follow from relations, and a proof over the joints of all of them."""

import json
import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from pxr import Usd, UsdPhysics
from scipy.spatial.transform import Rotation

import artgen
from artgen import Body, Region, union
from artgen._names import ByName
from artgen.asset import Asset
from artgen.asset.placed import certificate_digest
from artgen.catalog import categories
from artgen.dataset import Dataset, Plan, generate_many
from artgen.errors import AssetError, InfeasibleError, ParameterError
from artgen.export.frames import translation
from artgen.graph import evaluate
from artgen.materials import colored, material
from artgen.proof.certify import Known, certify
from artgen.scene import ROOMS, Room, Scene, hall, kitchen
from artgen.scene.furnish import Furnisher
from artgen.scene.kitchens import _beside, _Item
from artgen.scene.room import GAP, STANDING
from artgen.scene.rooms import _tub
from artgen.validate import Examination
from artgen.validate.behavior import check_behavior, neighborhoods
from artgen.validate.behavior.model import room_model
from artgen.validate.clients.registry import CLIENTS
from artgen.validate.clients.run import run_clients
from artgen.validate.colliders import check_colliders
from artgen.validate.hands import check_grasps
from artgen.validate.room import motions_at_rest, overlaps
from artgen.view.camera import camera_of
from support.cases import some

SMALL = {"kind": "bedside", "rows": 1, "width": 0.45, "depth": 0.42}
ONE_DOOR = {"kind": "base", "doors": 1, "width": 0.5, "depth": 0.5}


@pytest.fixture(scope="module")
def corner() -> Asset:
    """Two cabinets whose doors open towards each other, and a lamp on one of them."""
    room = Scene("corner", seed=2, width=2.0, depth=1.6)
    hands = [("cabinet", {**ONE_DOOR, "hand": hand}) for hand in ("right", "left")]
    first, _ = room.run("back", *hands, at=0.4, gap=0.01)
    room.on(first, "pepper_grinder")
    return room.build()


def test_a_run_stands_on_the_floor_along_its_wall() -> None:
    room = Scene("run", width=3.0, depth=2.4)
    back = room.run("back", ("drawer", SMALL), ("drawer", SMALL), at=0.2)
    (left,) = room.run("left", ("drawer", SMALL), at=0.1)
    (right,) = room.run("right", ("drawer", SMALL), at=0.3)
    low, high = back[0].bounds
    assert np.allclose([low[0], high[1], low[2]], [-1.3, -GAP, STANDING], atol=1e-9)
    assert math.isclose(back[1].bounds[0][0] - high[0], GAP, abs_tol=1e-9)
    # seen from the room, the left end of the left wall is at the front, that of the right wall at the back
    assert np.allclose([left.bounds[0][0], left.bounds[0][1]], [-1.5 + GAP, -2.4 + 0.1], atol=1e-9)
    assert np.allclose([right.bounds[1][0], right.bounds[1][1]], [1.5 - GAP, -0.3], atol=1e-9)


@pytest.mark.long
def test_a_scene_is_an_asset_whose_joints_are_those_of_all(corner: Asset) -> None:
    assert corner.certificate is not None
    assert corner.certificate.proven
    assert corner.links[0].name == "room"
    assert {"cabinet_door", "cabinet_1_door", "pepper_grinder_body"} <= {link.name for link in corner.links}
    model = corner.to_mjspec(textures=0).compile()
    assert model.nv == len(corner.free_joints)
    assert math.isclose(sum(model.body_mass), corner.mass, rel_tol=1e-3)


def test_a_joint_that_follows_a_narrower_one_is_narrowed() -> None:
    room = Scene("desk", seed=3, width=1.6, depth=1.4, detail="low")
    chest = room.against("back", "drawer", at=0.5, **SMALL | {"depth": 0.6})
    room.on(chest, "laptop", deep=0.9, style="convertible")
    asset = room.build()
    lid, base = (asset.joint(f"laptop_{name}_hinge") for name in ("screen", "base"))
    assert base.follows is not None
    assert lid.limits is not None
    assert lid.limits[1] < 2.0  # it would turn by half a turn without the chest below it
    assert base.limits == lid.limits


def test_of_two_doors_that_meet_one_depends_on_the_other(corner: Asset) -> None:
    doors = {"cabinet_door_hinge", "cabinet_1_door_hinge"}
    (dependent,) = [joint for joint in corner.joints if joint.name in doors and joint.needs is not None]
    assert dependent.needs is not None
    assert {dependent.name, *dependent.needs.condition.joints()} == doors
    wide_open = {name: corner.joint(name).limits[1] for name in doors}  # type: ignore[index]
    assert not dependent.needs.allows(wide_open[dependent.name], wide_open)
    free = dict.fromkeys(doors, 0.0) | {dependent.name: wide_open[dependent.name]}
    assert dependent.needs.allows(wide_open[dependent.name], free)
    without = (replace(joint, needs=None) for joint in corner.joints)
    assert not certify(replace(corner, joints=ByName(without))).proven


def test_searches_of_the_separation_change_nothing_in_the_proof(corner: Asset) -> None:
    again = certify(corner)
    assert corner.certificate is not None
    assert again == corner.certificate
    assert again.leaves == corner.certificate.leaves


def test_a_search_is_not_used_for_other_limits_of_a_joint(corner: Asset) -> None:
    known = Known()
    narrow = [
        each if each.locked or each.limits is None else replace(each, limits=(0.0, 0.01), needs=None)
        for each in corner.joints
    ]
    assert certify(replace(corner, joints=ByName(narrow)), known=known).proven
    wide = ByName(replace(joint, needs=None) for joint in corner.joints)
    assert not certify(replace(corner, joints=wide), known=known).proven


def test_a_scene_rests_in_simulation(corner: Asset) -> None:
    model = corner.to_mjspec(textures=0).compile()
    data = mujoco.MjData(model)
    for _ in range(int(0.5 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert data.ncon == 0
    assert np.abs(data.qpos).max() < 0.01


def test_an_opening_is_cut_to_the_size_of_its_window() -> None:
    room = Scene("view", width=2.4, depth=2.0)
    window = room.inset("back", "window", at=0.5, z=0.9, shutters="none")
    middle = window.bounds.mean(axis=0)
    asset = room.build()
    wall = [each for each in asset.links[0].colliders if each.label == "wall"]
    assert wall
    assert not any(each.convex.faces.contains(middle[None]) for each in wall)
    assert asset.joints["window_place"].locked


@pytest.mark.parametrize(("turn", "inside"), [(0.0, False), (math.pi, True)])
def test_a_window_is_turned_with_its_handles_into_the_room(turn: float, *, inside: bool) -> None:
    room = Scene("view", seed=2, width=2.4, depth=2.0, detail="low")
    sliding = {"style": "sliding", "layout": "pair", "shutters": "none", "width": 0.9, "height": 0.85}
    window = room.inset("back", "window", at=0.5, z=0.9, turn=turn, **sliding)
    left, right = window.bounds[:, 0]
    assert left == pytest.approx(-0.7, abs=1e-6)
    assert right - left == pytest.approx(np.ptp(window.asset.bounds()[:, 0]), abs=1e-6)
    ways = [(window.pose @ each.frame)[1, 2] for each in window.asset.affordances if each.kind == "grasp"]
    assert max(np.abs(ways)) > 0.9  # hands come along the depth of the wall
    assert all(way > -1e-6 if inside else way < 1e-6 for way in ways)


def test_solids_that_overlap_in_a_state_are_found(corner: Asset) -> None:
    assert not list(overlaps(corner, 50))
    free = replace(corner, joints=ByName(replace(joint, needs=None) for joint in corner.joints))
    found = [each for each in overlaps(free, 50) if each.link == "cabinet_door, cabinet_1_door"]
    assert len(found) == 1
    assert found[0].value is not None
    assert found[0].value > 1e-9
    assert {"cabinet_door_hinge", "cabinet_1_door_hinge"} == {*found[0].pose}


def test_what_moves_by_itself_in_a_room_is_found(loose: Asset) -> None:
    assert not list(motions_at_rest(loose))
    # a mill that hangs in the air falls, and a drawer with a spring opens
    mill = loose.joints["pepper_grinder_place"]
    high = loose.links["pepper_grinder_body"].moved(translation(np.array([0.0, 0.0, 0.4])))
    slide = replace(
        loose.joints["drawer_drawer_slide_0"], stiffness=40.0, rest=0.3, friction=0.0, damping=60.0
    )
    joints = ByName({**loose.joints.by_name, slide.name: slide}.values())
    links = ByName({**loose.links.by_name, high.name: high}.values())
    found = {each.joint or each.link for each in motions_at_rest(replace(loose, joints=joints, links=links))}
    assert slide.name in found
    assert mill.child not in found  # it falls while the room settles


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (
            lambda room: room.against("front", "lamp", at=0.0),
            "wall = 'front' is not allowed: it must be one of",
        ),
        (lambda room: room.against("back", "drawer", at=1.9, **SMALL), "m are missing"),
        (lambda room: room.on(room.against("back", "lamp", at=0.1), "oven"), "of width are missing"),
        (lambda room: [room.against("back", "lamp", at=0.1, name="a") for _ in "ab"], "give another name"),
        (lambda room: room.against("back", "lampp", at=0.1), "lamp"),
        (lambda room: Scene("hall", width=90.0, depth=2.0), "the width of a room is 0.5 to 30 m, not 90.0"),
        (lambda room: Scene("hall", width="3", depth=2.0), "the width of a room is 0.5 to 30 m, not '3'"),
        (lambda room: Scene("my hall", width=3.0, depth=2.0), "name = 'my hall' is no identifier"),
        (lambda room: Scene("world", width=3.0, depth=2.0), "name = 'world' has a meaning of its own"),
        (
            lambda room: Scene("hall", seed=-1, width=3.0, depth=2.0),
            "seed must be a whole number that is not",
        ),
        (lambda room: hall(seed=1.5), "seed must be a whole number that is not negative, got 1.5"),
        (lambda room: kitchen(0, width=math.nan), "width is 0.5 to 30 m, not nan"),
        (lambda room: kitchen(0, depth=0), "depth is 0.5 to 30 m, not 0"),
        (lambda room: kitchen(0, depth=0.6), "a door takes 1.08 m of a wall; 0.480 m are missing"),
        (lambda room: room.on("drawer", "bottle"), "below = 'drawer' is not in scene 'room'; give a"),
        (
            lambda room: room.inside(
                Scene("hall", width=2.0, depth=1.6).against("back", "drawer", at=0.1, **SMALL),
                "body",
                "bottle",
            ),
            "container = 'drawer' of another scene is not in scene 'room'; give a placement that `against`",
        ),
        (lambda room: room.against("back", "lamp", at=0.1, name="a/b"), "name = 'a/b' is no identifier"),
        (lambda room: room.against("back", "lamp", at=-0.1), "from the left end, is at least 0 m, not -0.1"),
        (lambda room: room.against("back", "lamp", at=0.1, z=-1), "above the floor, is at least 0 m, not -1"),
        (
            lambda room: room.against(((0, 0), (0, 0)), "lamp", at=0),
            "the length of the line ((0, 0), (0, 0))",
        ),
        (lambda room: room.inset("back", "door", at=0.1, z=1.5), "high: "),
        (
            lambda room: room.on(room.against("back", "drawer", at=0.1, **SMALL), "bottle", at=1.2),
            "at must be a share of 0 to 1, got 1.2",
        ),
        (
            lambda room: kitchen(0, width=2.2),
            "is too narrow: with a refrigerator, a dishwasher and an oven, ",
        ),
    ],
)
def test_what_does_not_fit_is_refused_with_what_is_missing(
    wrong: Callable[[Scene], object], message: str
) -> None:
    with pytest.raises(ParameterError) as error:
        wrong(Scene("room", width=2.0, depth=1.6))
    assert message in str(error.value)


def test_a_rounded_zero_is_a_place() -> None:
    room = Scene("room", width=2.0, depth=1.6)
    assert room.against("back", "lamp", at=-1e-16).bounds[0, 0] == pytest.approx(-1.0)


def test_what_stands_on_another_asset_is_on_a_surface() -> None:
    room = Scene("room", width=2.0, depth=1.6, detail="low")
    low = room.fixture(
        "board",
        lambda: artgen.part(Region.between((-0.3, -0.3, 0), (0.3, 0, 0.4)).box(), "b", material("oak")),
    )
    assert room.on(low, "bottle").bounds[0, 2] == pytest.approx(0.4 + STANDING, abs=1e-6)

    def frame() -> Body:
        boards = [((-0.9, -1, 0), (-0.5, -0.6, 0.4)), ((-0.9, -1, 0), (-0.86, -0.6, 0.8))]
        return artgen.part(
            union(*(Region.between(*corners).box() for corners in boards)), "b", material("oak")
        )

    step = room.fixture("step", frame)
    assert room.on(step, "bottle", at=1.0, name="beside").bounds[0, 2] == pytest.approx(
        0.4 + STANDING, abs=1e-6
    )
    with pytest.raises(ParameterError, match="'half' would stand on nothing: 'step' has no level surface"):
        room.on(step, "bottle", at=0.06, name="half")


def test_a_category_from_a_file_has_the_name_of_its_function(tmp_path: Path) -> None:
    file = tmp_path / "tins.py"
    file.write_text(
        "import artgen as ag\n@ag.category(labels='tin')\n"
        "def tin(*, size: ag.Float = ag.uniform(0.1, 0.2, 'm')) -> ag.Body:\n"
        "    return ag.part(ag.box(size, size, size), 'tin', ag.material('steel'))\n"
    )
    room = Scene("room", width=2.0, depth=1.6)
    assert [room.against("back", str(file), at=at).name for at in (0.1, 0.5)] == ["tin", "tin_1"]


def test_a_drawer_without_space_is_refused() -> None:
    room = Scene("tight", width=2.0, depth=1.6)
    room.against("back", "drawer", at=0.01, **SMALL)
    room.against("left", "drawer", at=0.66, **SMALL)
    with pytest.raises(
        AssetError, match=r"of the range of joint 'drawer\w*_slide_0' is free; leave more space"
    ):
        room.build()


@pytest.mark.long
def test_the_same_seed_gives_the_same_scene() -> None:
    def mill(seed: int) -> Asset:
        room = Scene("mill", seed=seed, width=2.0, depth=1.6)
        room.on(room.against("back", "drawer", at=0.3, **SMALL), "pepper_grinder")
        return room.build()

    assert mill(3).to_json() == mill(3).to_json()
    assert mill(3).to_json() != mill(4).to_json()


def test_a_kitchen_is_proven() -> None:
    room = ROOMS["kitchen"].generate(2, width=3.0, depth=2.4, detail="low")
    assert room.certificate is not None
    assert room.certificate.proven
    assert (room.name, room.category, room.seed, room.detail) == ("kitchen_2", "kitchen", 2, "low")
    assert {"refrigerator_body", "oven_body", "dishwasher_body", "window_frame", "door_frame"} <= {
        link.name for link in room.links
    }
    # the rim of the sink is on the worktop, and its bowls are in the unit below
    sink, unit = (
        next(each for each in room.placed if each.name == name).pose[:2, 3] for name in ("sink", "cabinet")
    )
    bowls = np.array(
        [each.convex.bounds() for each in room.link("sink_sink").colliders if each.label == "bowl"]
    )
    top = room.link("worktop_worktop").bounds()[1, 2]
    assert top < bowls[:, 1, 2].max() < top + 0.004
    assert bowls[:, 0, 2].min() < top - 0.15
    assert room.joints["sink_spout_swivel"].limits is not None
    assert np.linalg.norm(sink - unit) < 0.5


@pytest.mark.parametrize(
    ("kind", "furniture"),
    some(
        [
            ("bathroom", {"bathtub_basin", "sink_spout", "washing_machine_body", "soap_dispenser_body"}),
            ("office", {"drawer_body", "lamp_base", "sideboard_body", "window_frame"}),
            (
                "living_room",
                {"recliner_0_back", "table_drawer_0", "cabinet_1_body", "fan_base", "screen_screen"},
            ),
            ("workshop", {"drawer_body", "cabinet_body", "trashcan_body", "box_lid"}),
            ("hall", {"door_frame", "door_1_frame", "door_2_frame", "drawer_body", "mirror_mirror"}),
        ],
        5,
        1,
    ),
)
def test_each_room_is_proven(kind: str, furniture: set[str]) -> None:
    room = ROOMS[kind].generate(3, detail="low")
    assert room.certificate is not None
    assert room.certificate.proven
    assert (room.name, room.category, room.attempt) == (f"{kind}_3", kind, 0)
    assert {each.category for each in room.placed} & {*categories()} <= {*ROOMS[kind].contents}
    assert {label for link in room.links for label in link.labels} <= {*ROOMS[kind].labels}
    assert furniture <= {link.name for link in room.links}
    assert room.loose
    with pytest.raises(ParameterError, match=rf"{kind} 3: it is at least \S+ m wide; \S+ m are missing"):
        ROOMS[kind].generate(3, width=1.85)


def test_rooms_are_made_by_name_like_categories(tmp_path: Path) -> None:
    entrance = artgen.generate("hall", 5, name="entrance", detail="low", width=2.2)
    assert (entrance.name, entrance.category, entrance.parameters["width"]) == ("entrance", "hall", 2.2)
    assert entrance.certificate is not None
    assert entrance.certificate.proven
    narrow = artgen.uniform(2.0, 2.2)
    first = next(iter(artgen.stream(("hall", "switch"), seed=5, detail="low")))
    assert first.to_json() == hall(5, detail="low").to_json()
    plan = Plan(("switch", "hall"), 4, 5, ("hall:width=uniform(2.0, 2.2)",), detail="low", formats=("mjcf",))
    assert generate_many(plan, tmp_path / "set", jobs=1).failed == ()
    rows = Dataset(tmp_path / "set").filter(category="hall")
    widths = [row.parameters["width"] for row in rows]
    assert widths == pytest.approx(
        [ROOMS["hall"].sample(seed, overrides={"width": narrow})["width"] for seed in (5, 6)]
    )
    assert len(set(widths)) == 2
    assert all(2.0 < width < 2.2 for width in widths)


def test_a_stream_leaves_out_rooms_without_a_draw(caplog: pytest.LogCaptureFixture) -> None:
    def cellar(seed: int = 0, *, detail: str = "full") -> Asset:
        if not seed:
            raise AssetError("cellar 0: 8 draws failed; the last: door and wall collide")
        return hall(seed, detail="low")

    room = Room(cellar, (), ())
    with pytest.raises(InfeasibleError, match="cellar 0: 8 draws failed; the last: door and wall collide"):
        room.generate(0)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("artgen.scene.ROOMS", {"cellar": room})
        assert next(iter(artgen.stream("cellar"))).name == "hall_1"
    assert "cellar 0 is left out: cellar 0: 8 draws failed" in caplog.text


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"base": "free"}, "base = 'free' is not allowed: hall is a room, which is fixed to the world"),
        ({"topology": "fixed"}, "topology = 'fixed' is not allowed: hall is a room"),
        ({"height": 2.0}, r"hall has no parameter 'height'\. Allowed: depth, width"),
        ({"width": "wide"}, "width = 'wide' is not allowed: it must be a number"),
        ({"name": "a b"}, "name = 'a b' is no identifier; use letters, digits and _"),
        ({"detail": "high"}, "detail = 'high' is not allowed: it must be one of 'full', 'medium', 'low'"),
        ({"certify": "no"}, "certify = 'no' is not allowed"),
        ({"seed": -1}, "seed must be a whole number that is not negative, got -1"),
    ],
)
def test_wrong_options_of_rooms_are_told(given: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        artgen.generate("hall", **given)


def test_a_room_is_no_category() -> None:
    with pytest.raises(
        ParameterError, match=r"no category 'hall'\. hall is a room, which `artgen scene hall` and"
    ):
        artgen.catalog.find("hall")
    with pytest.raises(ParameterError, match=r"Did you mean 'kitchen'\?"):
        artgen.generate("kitchn")
    with pytest.raises(ParameterError, match="hall is a room, which is fixed to the world and"):
        Plan(("hall",), 1, tolerance=1e-3)


def test_colliders_follow_a_bathtub() -> None:
    tub = _tub(artgen.Region((0.0, 1.6), (0.0, 0.7), (0.0, 0.56)), colored("abs", "white"))
    assert not check_colliders(Asset.from_tree(evaluate(tub).value, "tub", "tub")).faults


@pytest.fixture(scope="module")
def loose() -> Asset:
    """A chest with a mill on it and pliers in its drawer, both free bodies."""
    room = Scene("loose", seed=5, width=1.6, depth=1.4, detail="low")
    chest = room.against("back", "drawer", at=0.5, **SMALL)
    room.on(chest, "pepper_grinder", deep=0.5, turn=0.3, free=True)
    room.inside(chest, "drawer_0", "plier", turn=0.2)
    return room.build()


def test_a_free_body_stands_still_and_moves_with_its_drawer(loose: Asset) -> None:
    assert loose.loose == ("pepper_grinder_body", "plier_body")
    assert loose.joints["plier_place"].parent == "drawer_drawer_0"
    spec = loose.to_mjspec(textures=0)
    model = spec.compile()
    data = mujoco.MjData(model)
    assert model.nq == len(loose.free_joints) + 2 * 7

    def place(name: str) -> np.ndarray:
        return data.body(name).xpos.copy()

    mujoco.mj_forward(model, data)
    before = {name: place(name) for name in loose.loose}
    for _ in range(int(1.0 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert all(np.abs(place(name) - start).max() < 0.005 for name, start in before.items())
    slide = loose.joints["drawer_drawer_slide_0"]
    number = model.joint(slide.name).dofadr[0]
    for _ in range(int(1.5 / model.opt.timestep)):
        data.qfrc_applied[number] = 20.0 if data.joint(slide.name).qpos[0] < 0.12 else 0.0
        mujoco.mj_step(model, data)
    moved = place("plier_body") - before["plier_body"]
    assert moved[1] < -0.08, "the pliers stay behind when the drawer opens"
    assert abs(moved[2]) < 0.01


def test_a_hand_reaches_a_free_body_in_its_open_drawer(loose: Asset) -> None:
    moved = {each.link: each.joints for each in loose.affordances if each.link.startswith("plier")}
    assert moved == {"plier_body": (), "plier_jaw": ("plier_jaw_hinge",)}
    found = [each for each in check_grasps(loose).findings if each.link in moved]
    assert {each.link for each in found} == set(moved)
    assert all("reaches it only where drawer_drawer_slide_0 > " in each.message for each in found)


def test_joints_of_a_room_are_driven_with_what_they_carry(loose: Asset, tmp_path: Path) -> None:
    directory = loose.export(tmp_path / "loose", formats=("mjcf",), textures=0)
    model = room_model(directory / "loose.xml", loose)
    assert model.body("plier_body").parentid == model.body("drawer_drawer_0").id
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert np.allclose(data.body("plier_body").xpos, loose.fk(np.zeros(model.nq))[-2, :3, 3], atol=1e-9)
    result = check_behavior(loose, directory)
    assert not result.findings, [str(each) for each in result.findings]
    # the drawer is stopped by what stands in its way, though it is another asset
    post = loose.links["pepper_grinder_body"]
    reach = loose.links["drawer_body"].bounds()[0, 1] - 0.05 - post.bounds()[0, 1]
    before = post.moved(translation(np.array([0.0, reach, -0.25])))
    links = ByName({**loose.links.by_name, before.name: before}.values())
    blocked = check_behavior(replace(loose, links=links))
    assert any(
        "contact holds it" in each.message and "pepper_grinder" in each.message for each in blocked.findings
    )


def test_doors_of_two_assets_that_meet_stop_each_other(corner: Asset, tmp_path: Path) -> None:
    directory = corner.export(tmp_path / "corner", formats=("mjcf",), textures=0)
    result = check_behavior(corner, directory)
    assert not [each for each in result.findings if each.severity == "fault"], result.findings
    assert "1 pushed while blocked" in result.detail
    path = directory / "corner.xml"
    text = path.read_text()
    (hard,) = set(re.findall(r'_collision">\s*<geom [^>]*solref="([^"]+)"', text))
    path.write_text(text.replace(f'solref="{hard}"', 'solref="0.5 1"'))
    doors = {"cabinet_door_hinge", "cabinet_1_door_hinge"}
    soft = [each for each in check_behavior(corner, directory).findings if each.joint in doors]
    assert any("though it needs" in each.message and each.severity == "fault" for each in soft)


def test_an_asset_of_a_room_is_simulated_with_all_that_it_may_touch() -> None:
    room = Scene("three", seed=3, width=3.0, depth=1.6, detail="low")
    door = ("cabinet", {**ONE_DOOR, "hand": "right"})
    room.run("back", ("drawer", SMALL), door, at=0.1)
    room.against("back", "drawer", at=2.4, **SMALL)
    whole = room.build()
    parts = [({*names}, part) for names, part in neighborhoods(whole)]
    assert set[str]().union(*(names for names, _ in parts)) == {each.name for each in whole.free_joints}
    links = [{*part.links.by_name} for _, part in parts]
    assert [len({"drawer_body", "cabinet_body", "drawer_1_body"} & each) for each in links] == [2, 2, 1]
    # what is left out never comes near, in random states
    poses = dict(zip(whole.links.by_name, np.moveaxis(whole.fk(whole.sample_states(50)), 1, 0), strict=True))
    rest = dict(zip(whole.links.by_name, whole.fk(np.zeros(len(whole.dof_names))), strict=True))

    def spans(name: str) -> tuple[np.ndarray, np.ndarray]:
        moved = poses[name] @ np.linalg.inv(rest[name])
        corners = np.array(np.meshgrid(*whole.link(name).bounds().T)).reshape(3, -1)
        points = moved[:, :3, :3] @ corners + moved[:, :3, 3:]
        return points.min(axis=2), points.max(axis=2)

    for names, part in parts:
        for own in {whole.joint(name).child for name in names}:
            low, high = spans(own)
            for other in {*whole.links.by_name} - {*part.links.by_name}:
                least, most = spans(other)
                assert not ((low < most) & (high > least)).all(axis=1).any(), (own, other)


def test_the_file_of_a_room_has_lights_and_hides_its_tendons(loose: Asset, tmp_path: Path) -> None:
    folder = loose.export(tmp_path / "loose", formats=("mjcf",), textures=0)
    model = mujoco.MjModel.from_xml_path(str(folder / f"{loose.name}.xml"))
    assert [model.light(number).name for number in range(model.nlight)] == [
        f"loose_light_{number}" for number in range(3)
    ]
    fan = artgen.generate("fan", 0, certify=False).export(tmp_path / "fan", formats=("mjcf",), textures=0)
    model = mujoco.MjModel.from_xml_path(str(fan / "fan_0.xml"))
    assert (model.nlight, set(model.tendon_group.tolist())) == (0, {4})


def test_free_bodies_are_stored_and_are_bodies_of_their_own_in_usd(loose: Asset, tmp_path: Path) -> None:
    directory = loose.export(tmp_path / "loose", formats=("mjcf", "usd", "urdf"), textures=0)
    report = Examination(directory).report(("solids", "tree", "mjcf", "usd", "urdf", "room"))
    assert report.passed, str(report)
    assert Asset.load(directory).loose == loose.loose
    stage = Usd.Stage.Open(str(directory / "loose.usda"))
    moved = {
        str(path)
        for prim in stage.Traverse()
        if prim.IsA(UsdPhysics.Joint)
        for path in UsdPhysics.Joint(prim).GetBody1Rel().GetTargets()
    }
    assert "/loose/drawer_drawer_0" in moved
    assert not {"/loose/pepper_grinder_body", "/loose/plier_body"} & moved
    for name in loose.loose:
        assert stage.GetPrimAtPath(f"/loose/{name}").HasAPI(UsdPhysics.RigidBodyAPI)
    assert not stage.GetPrimAtPath("/loose").HasAPI(UsdPhysics.ArticulationRootAPI)
    root = ET.parse(directory / "loose.urdf").getroot()
    assert root.find("joint[@name='plier_place']").get("type") == "fixed"  # type: ignore[union-attr]


def test_a_single_door_in_a_corner_has_its_hinges_there() -> None:
    size = (3.0, 2.4)
    here = Furnisher("kitchen", 1, 0, size, ((3.0, 4.0), (2.0, 3.0)), "low")
    for wall, at, hand in (("back", 0.05, "left"), ("back", 2.5, "right"), ("left", 1.9, "right")):
        assert here.hang(wall, at, 0.45).asset.parameters["hand"] == hand
    assert here.hang("back", 1.2, 0.45, "right").asset.parameters["hand"] == "right"


def test_neighbors_of_a_kind_are_found_beside_an_item_of_a_row() -> None:
    row = [_Item(kind, 0.6) for kind in ("refrigerator", "unit", "refrigerator", "sink")]
    found = [_beside(row, number, "refrigerator") for number in range(len(row))]
    assert found == [[], ["left", "right"], [], ["left"]]


def test_the_entrance_opens_into_the_hall_and_is_locked_from_there() -> None:
    room = next(
        each
        for each in (ROOMS["hall"].generate(seed, detail="low") for seed in range(5, 9))
        if "door_lock" in each.links.by_name
    )
    (turn,) = room.link("door_lock").grasps
    assert turn.frame[1, 3] < room.link("door_door").bounds()[:, 1].mean()
    open_door = room.pose({"door_door_hinge": 1.0})["door_door"]
    corners = room.link("door_door").bounds()
    assert (open_door[:3, :3] @ corners.T)[1].min() + open_door[1, 3] < -0.3
    assert not [name for name in room.links.by_name if name.endswith("_lock") and name != "door_lock"]


def test_a_client_reads_a_room_with_its_free_bodies(loose: Asset, tmp_path: Path) -> None:
    folder = loose.export(tmp_path / "room", formats=("mjcf",), textures=0)
    (outcome,) = run_clients(folder, [CLIENTS["mujoco"]], by_name=True)
    assert (outcome.state, outcome.findings) == ("passed", ())


def test_each_asset_of_a_room_is_written_alone_with_its_place(loose: Asset, tmp_path: Path) -> None:
    directory = loose.export(tmp_path / "loose", layout="parts", textures=0)
    table = json.loads((directory / "layout.json").read_text())
    shell, chest, mill, pliers = table["assets"]
    assert [each["category"] for each in table["assets"]] == ["room", "drawer", "pepper_grinder", "plier"]
    assert (pliers["carrier"], pliers["free"], mill["carrier"]) == ("drawer_drawer_0", True, "drawer_body")
    alone = artgen.generate("drawer", chest["seed"], detail="low", **SMALL)
    assert certificate_digest(alone.certificate) == chest["certificate"]
    (slide,) = chest["joints"]
    assert slide["in_room"] == f"drawer_{slide['name']}"
    assert slide["limits"] == pytest.approx(loose.joint(slide["in_room"]).limits)
    mass = 0.0
    for row in (shell, chest, mill, pliers):
        robot = ET.parse(directory / row["folder"] / f"{row['name']}.urdf").getroot()
        bodies = {str(each.get("name")): each for each in robot.iterfind("link/inertial/..")}
        mass += sum(float(each.find("inertial/mass").get("value")) for each in bodies.values())  # type: ignore[union-attr, arg-type]
        # the center of mass of its first link, at its place in the room
        name = loose.links[0].name if row is shell else f"{row['name']}_{next(iter(bodies))}"
        center = np.array(next(iter(bodies.values())).find("inertial/origin").get("xyz").split(), float)  # type: ignore[union-attr]
        turn = Rotation.from_quat(row["quaternion"], scalar_first=True).as_matrix()
        found = turn @ center + row["position"]
        assert np.allclose(found, loose.link(name).mass_properties.center, atol=1e-9)
    assert math.isclose(mass, loose.mass, rel_tol=1e-6)
    report = Examination(directory).report()
    assert report.passed, str(report)


def test_a_room_is_seen_over_its_open_side(loose: Asset) -> None:
    points = {link.name: link.bounds() for link in loose.links}
    front = camera_of(None, loose, points, 1.0)
    assert abs(front.azimuth()) < 0.2
    left = camera_of("three_quarter", loose, points, 1.0)
    assert left.azimuth() < -0.5  # behind the left wall


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("kitchen", "--set", "layout=round"), "must be one of 'one_wall', 'galley', 'l', 'u', 'island'"),
        (("office", "--set", "layout=l"), "office has no parameter 'layout'. Allowed: depth, width."),
        (("hall", "--set", "width=2.4m"), "it must be a number. Write the number alone, in m: 2.4"),
        (("hall", "--width", "2", "--set", "width=2"), "width is set twice"),
        (("hall", "--layout", "round"), "there is no layout 'round'. Allowed: flat"),
        (
            ("sauna",),
            "there is no room 'sauna'; choose from bathroom, hall, kitchen, living_room, office, workshop",
        ),
    ],
)
def test_wrong_options_of_a_scene_are_one_line(
    artgen_command: Any, arguments: tuple[str, ...], message: str
) -> None:
    done = artgen_command("scene", *arguments)
    assert done.code != 0
    assert message in done.err
    assert len(done.err.strip().splitlines()) == 1


def test_what_would_tip_over_or_does_not_fit_is_refused() -> None:
    room = Scene("full", seed=1, width=1.6, depth=1.4, detail="low")
    chest = room.against("back", "drawer", at=0.5, **SMALL)
    with pytest.raises(ParameterError, match=r"does not fit into 'drawer_0' of 'drawer'"):
        room.inside(chest, "drawer_0", "toaster")
    room.against("left", "drawer", at=0.2, **SMALL)
    room.slab("board", (-0.3, -0.4, 0.2), (0.3, 0.0, 0.25), colored("painted_wood", "white"))
    with pytest.raises(AssetError, match="overlap; place them farther apart"):
        room.build()


@pytest.mark.parametrize(
    ("layout", "size", "message"),
    some(
        [
            ("galley", {"width": 2.0}, "is too narrow for layout=galley: between its rows, 0."),
            ("island", {"depth": 2.6}, "is too shallow for an island: 0."),
            ("l", {"depth": 2.0}, "is too small for layout=l: beside "),
            (
                "round",
                {},
                "layout = 'round' is not allowed: it must be one of one_wall, galley, l, u, island",
            ),
        ],
        2,
        start=1,
    ),
)
def test_a_layout_that_does_not_fit_says_what_is_missing(
    layout: Any, size: dict[str, float], message: str
) -> None:
    with pytest.raises(ParameterError) as error:
        kitchen(0, layout=layout, detail="low", **size)
    assert message in str(error.value)


@pytest.mark.long
def test_a_kitchen_with_a_corner_is_free_at_the_first_draw() -> None:
    made = kitchen(1, layout="l", detail="low")
    assert made.certificate is not None
    assert made.certificate.proven
    assert made.attempt == 0
    (name,) = (
        each for each in made.joints.by_name if each.startswith("corner_unit") and "door_hinge" in each
    )
    low, high = made.joint(name).limits or (0.0, 0.0)
    assert high - low == pytest.approx(1.35, abs=0.01)
