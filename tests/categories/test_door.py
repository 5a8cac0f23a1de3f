"""Doors: what they are made of, what holds them shut, and how they behave when simulated."""

import math
from functools import cache
from itertools import combinations, product
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen import InfeasibleError, ParameterError, material
from artgen.asset import Asset, Link, Piece
from artgen.asset.surface import shifted
from artgen.categories.door import door
from support.poses import free_poses

LEAVES = ("flush_leaf", "plank_leaf", "panel_leaf", "glazed_leaf", "half_lite_leaf", "louver_leaf")
PLAIN: dict[str, Any] = {  # a small door that is quick to make
    "layout": "single",
    "frame": "full",
    "leaf": "flush_leaf",
    "hand": "left",
    "opens": "towards",
    "opener": "lever",
    "bolted": False,
    "hinges": 2,
    "width": 0.8,
    "height": 2.0,
    "thickness": 0.04,
    "floor_gap": 0.012,
    "side_gap": 0.003,
    "leaf.inlays": 0,
}


@cache
def _made(items: tuple[tuple[str, Any], ...]) -> Asset:
    return door.generate(3, **dict(items))


def made(**changes: Any) -> Asset:
    """Generate the plain door with some parameters changed; dots are spelt `__`."""
    options = PLAIN | {name.replace("__", "."): value for name, value in changes.items()}
    if options["leaf"] != "flush_leaf":
        del options["leaf.inlays"]
    return _made(tuple(sorted(options.items())))


def leaves(asset: Asset) -> list[Link]:
    return [link for link in asset.links if link.label == "door"]


def wood(link: Link) -> np.ndarray:
    """Return the bounds of the leaf proper, without its hardware, shape (2, 3)."""
    boxes = [piece.shape.bounds() for piece in link.pieces if piece.label == "door" and not piece.visual]
    return np.array([np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]])


def overlaps(asset: Asset, q: dict[str, float]) -> list[tuple[str, str, str, str]]:
    """Return which solids of different links overlap at a pose."""
    pose = asset.pose(q)
    placed = [
        (link.name, piece.label, piece.shape.manifold.transform(np.asarray(pose[link.name])[:3]))
        for link in asset.links
        for piece in link.pieces
        if not piece.visual
    ]
    boxes = [np.reshape(solid.bounding_box(), (2, 3)) for _, _, solid in placed]
    found = []
    for i, j in combinations(range(len(placed)), 2):
        (link_a, label_a, a), (link_b, label_b, b) = placed[i], placed[j]
        near = (boxes[i][0] < boxes[j][1]).all() and (boxes[j][0] < boxes[i][1]).all()
        if link_a != link_b and near and (a ^ b).volume() > 1e-12:
            found.append((link_a, label_a, link_b, label_b))
    return found


@pytest.mark.parametrize("seed", range(6))
def test_every_door_stands_on_the_floor_and_weighs_what_doors_weigh(seed: int) -> None:
    asset = door.generate(seed)
    low, high = asset.bounds()
    assert low[2] == pytest.approx(0.0, abs=1e-9)
    frame = asset.links[0].bounds()
    assert frame[0, 0] == pytest.approx(-frame[1, 0], abs=1e-9)
    assert high[2] > 2.0
    assert {label for link in asset.links for label in link.labels} <= set(asset.labels)
    for leaf in leaves(asset):
        assert 12.0 < leaf.mass_properties.mass < 60.0
        # a door weighs 8 to 35 kg for each square metre
        size = np.ptp(wood(leaf), axis=0)
        assert 8.0 < leaf.mass_properties.mass / (size[0] * size[2]) < 35.0
    for link in asset.links:
        assert len(link.colliders) <= 64
    assert not asset.blocked({})


def test_sizes_are_those_that_were_asked_for() -> None:
    asset = made(width=0.9, height=2.1, thickness=0.038, floor_gap=0.015)
    low, high = wood(asset.link("door"))
    assert high - low == pytest.approx([0.9, 0.038, 2.1], abs=1e-9)
    assert low[2] == pytest.approx(0.015)


@pytest.mark.parametrize("side_gap", [0.003, 0.0045])
def test_the_leaf_hangs_in_its_gap(side_gap: float) -> None:
    frame = made(side_gap=side_gap).link("frame")
    boxes = [piece.shape.bounds() for piece in frame.pieces if piece.label == "frame"]
    beside = [box for box in boxes if box[0, 1] < 0.01 and box[1, 1] > 0.0 and box[1, 0] < 0.0]
    assert max(box[1, 0] for box in beside) == pytest.approx(-0.4 - side_gap)


@pytest.mark.parametrize("leaf", LEAVES)
@pytest.mark.parametrize("frame", ["full", "arched"])
def test_leaves_of_every_style_fill_their_doorway(leaf: str, frame: str) -> None:
    link = made(leaf=leaf, frame=frame).link("door")
    low, high = wood(link)
    assert high - low == pytest.approx([0.8, 0.04, 2.0], abs=2e-4)
    assert ("glass" in link.labels) == (leaf in ("glazed_leaf", "half_lite_leaf"))
    glass = [piece for piece in link.pieces if piece.label == "glass"]
    for piece in glass:
        assert 0.004 <= np.ptp(piece.shape.bounds()[:, 1]) <= 0.006
        assert piece.material.opacity < 1.0


@pytest.mark.parametrize("panels", range(1, 9))
def test_a_panel_leaf_has_as_many_panels_as_asked(panels: int) -> None:
    link = made(leaf="panel_leaf", leaf__panels=panels, leaf__relief="recessed").link("door")
    solids = [piece.shape for piece in link.pieces if piece.label == "door" and not piece.visual]
    thin = [shape for shape in solids if np.ptp(shape.bounds()[:, 1]) < 0.012]
    assert sum(len(shape.manifold.decompose()) for shape in thin) == panels


def test_louvres_hide_what_is_behind_them() -> None:
    link = made(leaf="louver_leaf", leaf__slats=24, leaf__below="louver", certify=False).link("door")
    slats = [
        np.reshape(slat.bounding_box(), (2, 3))[:, 2]
        for piece in link.pieces
        if not piece.visual and len(piece.shape.manifold.decompose()) == 8  # every third of a section
        for slat in piece.shape.manifold.decompose()
    ]
    bounds = np.array(sorted(slats, key=lambda each: each[0]))
    assert len(bounds) == 48
    for section in (bounds[:24], bounds[24:]):
        assert (section[1:, 0] - section[:-1, 1]).max() < 0.002
        assert (section[1:, 0] - section[:-1, 1]).min() > 0.0


@pytest.mark.parametrize("leaf", ["panel_leaf", "plank_leaf", "louver_leaf"])
def test_no_two_boards_have_the_same_grain(leaf: str) -> None:
    link = made(leaf=leaf, finish=material("oak")).link("door")
    boards = [piece for piece in link.pieces if piece.label == "door" and not piece.visual]
    starts = {
        tuple(np.round(mesh.uvs[0] - piece.shape.mesh.uvs[0], 6))
        for index, piece in enumerate(link.pieces)
        if piece in boards
        for mesh in [shifted(piece.shape.mesh, piece.material, f"door/{index}")]
    }
    assert len(starts) >= 0.9 * len(boards) > 4


def details(link: Link, label: str) -> list[Piece]:
    return [piece for piece in link.pieces if piece.visual and piece.label == label]


ENTRANCE: dict[str, Any] = {
    "use": "exterior",
    "leaf": "half_lite_leaf",
    "letter_plate": False,
    "number": "",
    "viewer": False,
    "kick_plate": False,
    "sweep": False,
}


def test_the_number_of_a_house_can_be_read_from_outside_whatever_the_hand() -> None:
    seen = []
    for hand, opens in product(("left", "right"), ("towards", "away")):
        link = made(**ENTRANCE | {"number": "27"}, hand=hand, opens=opens).link("door")
        (figures,) = details(link, "plate")
        outward = 1.0 if opens == "towards" else -1.0  # it opens inwards
        points = figures.shape.mesh.vertices
        assert (points[:, 1] * outward).max() == pytest.approx(0.02 + 0.004)
        reading = points[:, [0, 2]] * [-outward, 1.0]
        seen.append(reading[np.lexsort(reading.T)])
    for other in seen[1:]:
        np.testing.assert_allclose(other, seen[0], atol=1e-9)


@pytest.mark.parametrize("fitting", ["letter_plate", "viewer", "kick_plate", "sweep"])
def test_an_entrance_has_what_was_asked_for(fitting: str) -> None:
    options = ENTRANCE | {"leaf": "plank_leaf"}
    bare, fitted = (made(**each).link("door") for each in (options, options | {fitting: True}))
    more = [piece.label for piece in fitted.pieces][len(bare.pieces) :]
    assert len(more) == len(fitted.pieces) - len(bare.pieces) >= 3
    assert fitted.mass_properties.mass - bare.mass_properties.mass == pytest.approx(
        0.6 if fitting == "letter_plate" else 0.0, abs=0.4 if fitting == "letter_plate" else 1e-9
    )


def test_only_the_leaf_that_is_entered_by_has_a_letter_plate() -> None:
    asset = made(**ENTRANCE | {"letter_plate": True, "number": "8", "layout": "double", "frame": "jambs"})
    assert len(details(asset.link("door_left"), "plate")) >= 5
    assert details(asset.link("door_right"), "plate") == []


@pytest.mark.parametrize("fixing", ["hidden", "slot", "phillips"])
def test_roses_show_screws_or_hide_them(fixing: str) -> None:
    asset = made(rose="round", fixing=fixing, rose_depth=0.009)
    faces = [
        piece
        for piece in details(asset.link("door"), "screw")
        if np.abs(piece.shape.bounds()[:, 1]).max() > 0.02 + 0.009
    ]
    assert bool(faces) == (fixing != "hidden")


def test_shades_of_one_seed_are_one_material_each() -> None:
    asset = door.generate(4)
    materials = {piece.material for link in asset.links for piece in link.pieces}
    assert len({each.name for each in materials}) == len(materials)


@pytest.mark.parametrize(
    ("changes", "links", "joints"),
    [
        ({}, ["handle", "latch"], ["handle_turn", "latch_slide"]),
        ({"opener": "knob"}, ["handle", "latch"], ["handle_turn", "latch_slide"]),
        ({"opener": "push_bar"}, ["handle", "latch"], ["handle_push", "latch_slide"]),
        ({"opener": "pull"}, [], []),
        ({"opener": "none"}, [], []),
        (
            {"bolted": True},
            ["handle", "latch", "lock", "deadbolt"],
            ["handle_turn", "latch_slide", "lock_turn", "deadbolt_slide"],
        ),
    ],
)
def test_the_opener_decides_which_links_there_are(
    changes: dict[str, Any], links: list[str], joints: list[str]
) -> None:
    asset = made(**changes)
    assert [link.name for link in asset.links] == ["frame", "door", *links]
    assert [joint.name for joint in asset.joints] == ["door_hinge", *joints]
    assert ("handle" in {label for link in asset.links for label in link.labels}) == (
        asset.parameters["opener"] != "none"
    )


@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_double_door_has_an_active_leaf_and_one_with_a_flush_bolt(hand: str) -> None:
    other = "right" if hand == "left" else "left"
    asset = made(layout="double", frame="jambs", hand=hand)
    assert [link.name for link in leaves(asset)] == [f"door_{hand}", f"door_{other}"]
    assert asset.joint("handle_turn").parent == f"door_{hand}"
    assert asset.joint("flush_bolt_slide").parent == f"door_{other}"
    assert asset.link("door_left").bounds()[1, 0] < 0.1
    assert asset.link("door_right").bounds()[0, 0] > -0.1


@pytest.mark.parametrize("opener", ["lever", "knob", "push_bar"])
def test_the_handle_draws_the_latch_into_the_leaf(opener: str) -> None:
    asset = made(opener=opener)
    handle = asset.joint("handle_push" if opener == "push_bar" else "handle_turn")
    edge = wood(asset.link("door"))[1, 0]
    tip = asset.link("latch").bounds()[1, 0]
    throw = asset.parameters["throw"]
    assert tip - edge == pytest.approx(throw, abs=1e-6)
    assert handle.limits is not None
    release = 0.85 * handle.limits[1]
    assert asset.pose({handle.name: release})["latch"][0, 3] == pytest.approx(-throw, abs=1e-9)
    # a door that is level with its frame has hardly more room than this
    assert -asset.pose({handle.name: handle.limits[1]})["latch"][0, 3] > throw


def test_the_latch_holds_the_closed_door_until_the_handle_is_turned() -> None:
    asset = made()
    limit = asset.joint("handle_turn").limits[1]
    assert asset.blocked({"door_hinge": 0.02}) == ("door_hinge",)
    assert asset.blocked({"door_hinge": 0.02, "handle_turn": 0.8 * limit}) == ("door_hinge",)
    assert asset.blocked({"door_hinge": 0.02, "handle_turn": 0.9 * limit}) == ()
    assert asset.blocked({"door_hinge": 0.2}) == ()
    # it is no mere declaration: the bolt stands in the way
    assert overlaps(asset, {"door_hinge": 0.02}) == [
        ("frame", "frame", "latch", "latch"),
        ("frame", "strike", "latch", "latch"),
    ]


def test_the_deadbolt_holds_the_door_even_when_the_handle_is_turned() -> None:
    asset = made(bolted=True)
    turned = {"handle_turn": asset.joint("handle_turn").limits[1]}
    assert asset.blocked({"door_hinge": 0.02, **turned}) == ()
    assert asset.blocked({"door_hinge": 0.02, "lock_turn": 1.57, **turned}) == ("door_hinge",)
    assert asset.blocked({"door_hinge": 0.3, "lock_turn": 1.57, **turned}) == ()
    assert overlaps(asset, {"lock_turn": 1.57}) == []


def test_the_inactive_leaf_waits_for_its_bolt_and_for_the_active_one() -> None:
    asset = made(layout="double", frame="jambs")
    drawn = asset.joint("flush_bolt_slide").limits[1]
    assert asset.blocked({"door_hinge_right": 0.1, "door_hinge_left": 0.5}) == ("door_hinge_right",)
    assert asset.blocked({"door_hinge_right": 0.1, "flush_bolt_slide": drawn}) == ("door_hinge_right",)
    ready = {"door_hinge_left": 0.5, "flush_bolt_slide": drawn}
    assert asset.blocked({"door_hinge_right": 0.1, **ready}) == ()


@pytest.mark.parametrize(
    "changes",
    [
        {"bolted": True, "swing": 2.0},
        {"opener": "push_bar", "opens": "away", "leaf": "panel_leaf", "swing": 2.0},
        {"opener": "knob", "frame": "arched", "leaf": "louver_leaf", "hand": "right"},
        {"opener": "pull", "thickness": 0.045, "width": 0.61, "leaf": "glazed_leaf", "side_gap": 0.0036},
        {"layout": "double", "frame": "full", "hand": "right", "swing": 2.0, "bolted": True},
    ],
)
def test_nothing_collides_where_no_dependency_forbids_it(changes: dict[str, Any]) -> None:
    asset = made(**changes)
    for pose in free_poses(asset):
        assert overlaps(asset, pose) == [], pose


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("opens", ["towards", "away"])
def test_hands_and_directions(hand: str, opens: str) -> None:
    asset = made(hand=hand, opens=opens)
    hinge = asset.joint("door_hinge")
    side = -1.0 if hand == "left" else 1.0
    assert hinge.pivot[0] * side == pytest.approx(0.4 + 0.0015)
    edge = np.array([-side * 0.4, 0.0, 1.0, 1.0])
    moved = np.asarray(asset.pose({"door_hinge": 1.0, "handle_turn": 0.0})["door"]) @ edge
    assert (moved[1] < -0.3) == (opens == "towards")
    assert (moved[1] > 0.3) == (opens == "away")
    # levers point away from the lock edge, and their free end goes down
    grasp = asset.link("handle").grasps[0].frame[:, 3]
    assert (grasp[0] - edge[0]) * side > 0.1
    assert (np.asarray(asset.pose({"handle_turn": 0.5})["handle"]) @ grasp)[2] < grasp[2] - 0.02


def test_a_leaf_that_cannot_turn_in_its_gap_is_infeasible() -> None:
    with pytest.raises(InfeasibleError, match="the far corner of the leaf would strike the jamb"):
        door.generate(0, **PLAIN | {"thickness": 0.06, "width": 0.61, "side_gap": 0.0028}, attempts=2)


@pytest.mark.parametrize(("floor_gap", "bevel"), [(0.008, 0.0016), (0.010, 0.0022)])
def test_the_edges_of_a_threshold_are_eased_less_where_it_is_thin(floor_gap: float, bevel: float) -> None:
    asset = door.generate(0, **PLAIN | {"floor_gap": floor_gap}, certify=False)
    plate = max(
        (piece for piece in asset.link("frame").pieces if piece.label == "threshold"),
        key=lambda piece: piece.shape.manifold.volume(),
    )
    points = plate.shape.mesh.vertices
    low, high = plate.shape.bounds()
    assert high[2] - low[2] == pytest.approx(floor_gap - 0.004)
    upper = points[np.isclose(points[:, 2], high[2])]
    assert high[1] - upper[:, 1].max() == pytest.approx(bevel)


@pytest.mark.parametrize(
    ("bolted", "fits", "too_long"), [(False, 1.79, 1.8), (True, 0.53, 0.55)], ids=["leaf", "deadbolt"]
)
def test_a_pull_stays_on_its_leaf_and_below_a_deadbolt(*, bolted: bool, fits: float, too_long: float) -> None:
    given = PLAIN | {"opener": "pull", "bolted": bolted, "handle_height": 0.95, "handle.style": "U"}
    asset = door.generate(0, **given, on_collision="fail", **{"handle.length": fits})
    assert asset.certificate is not None
    assert asset.certificate.proven
    low = given | {"height": 1.8} if not bolted else given
    with pytest.raises(InfeasibleError, match="the pull is longer than the free part of the leaf"):
        door.generate(0, **low, attempts=1, **{"handle.length": too_long})


def test_sizes_that_no_door_has_are_refused() -> None:
    with pytest.raises(ParameterError, match="width"):
        door.generate(0, width=3.0)


def test_one_seed_makes_one_door() -> None:
    assert door.generate(11).to_json() == door.generate(11).to_json()


def _joint(model: mujoco.MjModel, name: str) -> int:
    return int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name))


class Simulated:
    """A door in MuJoCo."""

    def __init__(self, asset: Asset, folder: Path, **q: float) -> None:
        asset.export(folder / "door", formats=("mjcf",))
        (path,) = (folder / "door").rglob("*.xml")
        self.model = mujoco.MjModel.from_xml_path(str(path))
        self.data = mujoco.MjData(self.model)
        for name, position in asset.positions(q).items():
            self.data.qpos[self.model.jnt_qposadr[_joint(self.model, name)]] = position
        mujoco.mj_forward(self.model, self.data)

    def __getitem__(self, name: str) -> float:
        return float(self.data.qpos[self.model.jnt_qposadr[_joint(self.model, name)]])

    def run(self, seconds: float, **forces: float) -> None:
        for name, force in forces.items():
            self.data.qfrc_applied[self.model.jnt_dofadr[_joint(self.model, name)]] = force
        for _ in range(round(seconds / self.model.opt.timestep)):
            mujoco.mj_step(self.model, self.data)
        assert self.data.warning.number.sum() == 0


def _arm(asset: Asset) -> float:
    """Return the distance of the spindle from the hinge [m]."""
    return float(asset.parameters["width"] - asset.parameters["backset"])


@pytest.mark.parametrize(("opener", "effort"), [("lever", 2.5), ("knob", 2.5), ("push_bar", 80.0)])
def test_the_latch_holds_50_newtons_and_lets_go_when_the_handle_is_turned(
    opener: str, effort: float, tmp_path: Path
) -> None:
    asset = made(opener=opener)
    handle = "handle_push" if opener == "push_bar" else "handle_turn"
    arm = _arm(asset)
    simulated = Simulated(asset, tmp_path)
    simulated.run(0.5, door_hinge=50.0 * arm)
    assert abs(simulated["door_hinge"]) < 0.005
    simulated.run(0.3, **{"door_hinge": 0.0, handle: effort})
    simulated.run(1.0, **{"door_hinge": 20.0 * arm, handle: effort})
    assert simulated["door_hinge"] > 0.3


@pytest.mark.parametrize("opener", ["lever", "push_bar"])
def test_the_handle_springs_back(opener: str, tmp_path: Path) -> None:
    asset = made(opener=opener)
    name = "handle_push" if opener == "push_bar" else "handle_turn"
    limit = asset.joint(name).limits[1]
    simulated = Simulated(asset, tmp_path, **{name: limit})
    simulated.run(0.4)
    assert abs(simulated[name]) < 0.02 * limit
    simulated.run(0.2)
    assert abs(simulated[name]) < 0.01 * limit
    assert abs(simulated["latch_slide"]) < 0.0003


@pytest.mark.parametrize(
    "changes",
    [
        {"layout": "double", "leaf": "panel_leaf", "leaf__panels": 8, "bolted": True, "hinges": 3},
        {"frame": "arched", "leaf": "glazed_leaf", "opener": "pull", "bolted": True, "hinges": 3},
    ],
)
def test_doors_with_most_colliders_touch_nothing_at_rest(changes: dict[str, Any], tmp_path: Path) -> None:
    simulated = Simulated(made(**changes), tmp_path)
    assert simulated.data.ncon == 0


def test_an_open_door_stays_where_it_is_left(tmp_path: Path) -> None:
    simulated = Simulated(made(), tmp_path, door_hinge=0.8)
    simulated.run(2.0)
    assert simulated["door_hinge"] == pytest.approx(0.8, abs=math.radians(0.5))


def test_the_flush_bolt_stays_up_and_holds_the_inactive_leaf(tmp_path: Path) -> None:
    asset = made(layout="double", frame="jambs")
    simulated = Simulated(asset, tmp_path, door_hinge_left=1.0)
    simulated.run(0.5, door_hinge_right=20.0)
    assert abs(simulated["flush_bolt_slide"]) < 0.0005
    assert abs(simulated["door_hinge_right"]) < 0.02
