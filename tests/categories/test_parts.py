"""Door hardware: what moves keeps clear of what stands, and couplings put bolts where they belong."""

from itertools import combinations

import numpy as np
import pytest
from manifold3d import Manifold, OpType

from artgen import Body, Revolute, Z, box, material, part, weld
from artgen.asset import Asset
from artgen.categories.door.fittings import pull_handle, push_bar, push_bar_case, push_slide
from artgen.categories.handle.grip_set import THUMB_RANGE, grip, thumb_piece, thumb_press
from artgen.categories.shared.door_handles import knob_handle, lever_handle, spring_turn
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf, hinge_offset
from artgen.categories.shared.locks import (
    LATCH,
    QUARTER,
    THROW,
    clear_angle,
    deadbolt,
    deadbolt_cover,
    deadbolt_hole,
    deadbolt_pocket,
    deadbolt_slide,
    faceplate,
    latch_bolt,
    latch_pocket,
    latch_slide,
    rose,
    spindle_hole,
    strike_plate,
    strike_pocket,
    thumb_turn,
    thumb_turn_joint,
)
from support.bodies import asset_of

NICKEL = material("satin_nickel")
OAK = material("oak")
THICK, DEPTH, BACKSET, GAP, SLIDE = 0.040, 0.009, 0.06, 0.003, 0.011


def manifold(asset: Asset, link: str) -> Manifold:
    pieces = [piece.shape.manifold for piece in asset.link(link).pieces if not piece.visual]
    return Manifold.batch_boolean(pieces, OpType.Add)


def overlaps(asset: Asset, q: dict[str, float]) -> list[tuple[str, str]]:
    """Return the pairs of links whose solids overlap at a pose."""
    pose = asset.pose(q)
    placed = {
        link.name: manifold(asset, link.name).transform(np.asarray(pose[link.name])[:3, :4])
        for link in asset.links
    }
    return [(a, b) for a, b in combinations(placed, 2) if (placed[a] ^ placed[b]).volume() > 1e-13]


def leaf(*cuts: object) -> Body:
    """Make a piece of leaf about the spindle, its lock edge at x = BACKSET."""
    board = box(0.3, THICK, 0.4).at(BACKSET - 0.15, 0.0, 0.0)
    for cut in cuts:
        board = board - cut  # type: ignore[operator]
    return part(board, "door", OAK)


LEVERS = [(style, section) for style in ("straight", "bent", "wave") for section in ("round", "flat")]


def lever(style: str, section: str) -> Body:
    return lever_handle(
        thickness=THICK,
        rose_depth=DEPTH,
        finish=NICKEL,
        style=style,
        section=section,
        length=0.13,
        projection=0.05,
        girth=0.0095,
    )


@pytest.mark.parametrize(("style", "section"), LEVERS)
def test_a_lever_turns_freely_and_its_free_end_goes_down(style: str, section: str) -> None:
    roses = rose(thickness=THICK, depth=DEPTH, across=0.056, finish=NICKEL)
    door = weld(leaf(spindle_hole(THICK)), roses).attach(lever(style, section), spring_turn(limit=0.9))
    asset = asset_of(door)
    for angle in (0.0, 0.45, 0.9):
        assert overlaps(asset, {"handle_turn": angle}) == []
    lowest = asset.link("handle").bounds()[0, 2]
    turned = manifold(asset, "handle").transform(asset.pose({"handle_turn": 0.9})["handle"][:3, :4])
    assert turned.bounding_box()[2] < lowest - 0.07
    assert asset.link("handle").bounds()[0, 0] == pytest.approx(-0.13, abs=0.001)


@pytest.mark.parametrize(("style", "section"), LEVERS)
def test_a_lever_is_one_solid_and_real_in_weight(style: str, section: str) -> None:
    link = asset_of(lever(style, section)).links[0]
    (piece,) = link.pieces
    assert len(piece.shape.manifold.decompose()) == 1
    assert 0.4 < link.mass_properties.mass < 1.1
    assert len(link.grasps) == 2
    assert len(link.colliders) <= 40


@pytest.mark.parametrize("style", ["ball", "flat", "tulip", "egg"])
@pytest.mark.parametrize("lock", ["none", "turn", "push"])
def test_a_knob_turns_freely_with_its_lock(style: str, lock: str) -> None:
    knob = knob_handle(
        thickness=THICK,
        rose_depth=DEPTH,
        finish=NICKEL,
        lock=lock,
        style=style,
        radius=0.027,
        projection=0.064,
    )
    roses = rose(thickness=THICK, depth=DEPTH, across=0.056, finish=NICKEL)
    asset = asset_of(weld(leaf(spindle_hole(THICK)), roses).attach(knob, spring_turn(limit=0.8)))
    assert len(manifold(asset, "handle").decompose()) == 1
    names = [joint.name for joint in asset.free_joints]
    assert names == ["handle_turn"] + ([] if lock == "none" else [f"lock_{lock}"])
    for ends in (0, 1):
        q = {joint.name: joint.limits[ends] for joint in asset.free_joints if joint.limits}
        assert overlaps(asset, q) == []


def test_a_spring_is_preloaded_at_rest_and_gives_its_torque_at_the_limit() -> None:
    asset = asset_of(leaf(spindle_hole(THICK)).attach(lever("bent", "round"), spring_turn(limit=0.8)))
    joint = asset.joint("handle_turn")
    assert joint.stiffness * (0.0 - joint.rest) == pytest.approx(0.7)
    assert joint.stiffness * (0.8 - joint.rest) == pytest.approx(1.3)


def latched() -> Body:
    """Make a leaf with lever and latch, and the jamb with the strike as a second link on a hinge."""
    turn = spring_turn(limit=0.9)
    door = weld(
        leaf(spindle_hole(THICK), latch_pocket(backset=BACKSET, throw=SLIDE)),
        faceplate(backset=BACKSET, finish=NICKEL),
    )
    door = door.attach(lever("straight", "round"), turn)
    bolt = latch_bolt(backset=BACKSET, throw=SLIDE, finish=NICKEL)
    door = door.attach(bolt, latch_slide(turn, throw=SLIDE, release=0.75))
    jamb = box(0.03, 0.1, 0.4).at(BACKSET + GAP + 0.015, 0.05 - THICK / 2, 0.0)
    jamb = jamb - strike_pocket(backset=BACKSET, gap=GAP, throw=SLIDE)
    strike = strike_plate(backset=BACKSET, gap=GAP, throw=SLIDE, thickness=THICK, finish=NICKEL)
    frame = weld(part(jamb, "frame", OAK), strike)
    hinge = Revolute(
        "door_hinge", axis=-1.0 * Z, pivot=(BACKSET - 0.8, -THICK / 2 - 0.0065, 0.0), limits=(0.0, 1.6)
    )
    return frame.attach(door, hinge)


def test_the_latch_holds_the_leaf_until_the_handle_is_turned() -> None:
    asset = asset_of(latched())
    assert overlaps(asset, {}) == []
    assert ("frame", "latch") in overlaps(asset, {"door_hinge": 0.004})
    for opened in (0.0, 0.004, 0.02, 0.2):
        assert overlaps(asset, {"door_hinge": opened, "handle_turn": 0.75}) == []
        assert overlaps(asset, {"door_hinge": opened, "handle_turn": 0.9}) == []


def test_the_thrown_latch_is_clear_of_the_strike_beyond_the_clear_angle() -> None:
    asset = asset_of(latched())
    clear = clear_angle(thickness=THICK, reach=0.8)
    assert isinstance(clear, float)
    for opened in np.linspace(clear, 1.6, 6):
        assert overlaps(asset, {"door_hinge": float(opened)}) == []
    assert overlaps(asset, {"door_hinge": 0.5 * clear}) != []


def test_the_latch_is_flush_at_release_and_slanted_on_the_closing_side() -> None:
    asset = asset_of(latched())
    drawn = manifold(asset, "latch").transform(asset.pose({"handle_turn": 0.75})["latch"][:3, :4])
    assert drawn.bounding_box()[3] == pytest.approx(BACKSET, abs=1e-6)
    vertices = asset.link("latch").surfaces[0].mesh.vertices
    assert vertices[vertices[:, 1] < 0.0][:, 0].max() == pytest.approx(BACKSET + SLIDE, abs=1e-6)
    assert vertices[vertices[:, 1] > LATCH.width / 2 - 1e-4][:, 0].max() < BACKSET + 0.002


def test_a_deadbolt_is_inside_until_its_turn_throws_it() -> None:
    turn = thumb_turn_joint()
    door = weld(
        leaf(deadbolt_hole(THICK), deadbolt_pocket(backset=BACKSET)),
        faceplate(backset=BACKSET, finish=NICKEL, bolt="deadbolt"),
        deadbolt_cover(thickness=THICK, finish=NICKEL),
    )
    door = door.attach(thumb_turn(thickness=THICK, finish=NICKEL), turn)
    door = door.attach(deadbolt(backset=BACKSET, finish=NICKEL), deadbolt_slide(turn))
    asset = asset_of(door)
    for angle in (0.0, 0.5, 1.0, QUARTER):
        assert overlaps(asset, {"lock_turn": angle}) == []
    assert asset.link("deadbolt").bounds()[1, 0] < BACKSET
    assert asset.pose({"lock_turn": QUARTER})["deadbolt"][0, 3] == pytest.approx(THROW)


@pytest.mark.parametrize("knuckles", [3, 5])
def test_hinge_halves_stay_clear_of_each_other_and_of_the_wood(knuckles: int) -> None:
    sizes = {"height": 0.09, "radius": 0.0055, "depth": 0.03}
    offset = hinge_offset(0.0055)
    wood = box(0.2, THICK, 0.2)
    jamb = part(wood.align((-GAP / 2, offset, 0.0), x=1.0, y=-1.0), "frame", OAK)
    door = part(wood.align((GAP / 2, offset, 0.0), x=-1.0, y=-1.0), "door", OAK)
    frame = weld(jamb, hinge_frame(**sizes, finish=NICKEL, knuckles=knuckles))
    turned = weld(door, hinge_leaf(**sizes, finish=NICKEL, knuckles=knuckles))
    asset = asset_of(frame.attach(turned, Revolute("door_hinge", axis=-1.0 * Z, limits=(0.0, 3.0))))
    for angle in (0.0, 0.01, 0.3, 1.0, 1.6, 2.2, 3.0):
        assert overlaps(asset, {"door_hinge": angle}) == []


@pytest.mark.parametrize("side", [-1, 1])
def test_a_push_bar_slides_in_its_rail(side: int) -> None:
    case = push_bar_case(thickness=THICK, length=0.6, finish=NICKEL, side=side)
    bar = push_bar(thickness=THICK, length=0.6, travel=0.016, finish=NICKEL, side=side)
    asset = asset_of(weld(leaf(), case).attach(bar, push_slide(travel=0.016, side=side)))
    for push in (0.0, 0.008, 0.016):
        assert overlaps(asset, {"handle_push": push}) == []
    # pressed fully, the bar still stands out of the rail on its face of the leaf
    reach = np.abs(asset.link("handle").bounds()[:, 1]).max()
    assert np.sign(asset.link("handle").bounds()[0, 1]) == side
    assert reach - 0.016 > THICK / 2 + 0.028


@pytest.mark.parametrize("style", ["U", "T", "Z"])
@pytest.mark.parametrize(("faces", "grasps", "pushes"), [("both", 1, 1), ("front", 1, 0), ("back", 0, 1)])
def test_pulls_stand_on_their_faces_with_room_for_a_hand(
    style: str, faces: str, grasps: int, pushes: int
) -> None:
    pull = pull_handle(
        thickness=THICK, finish=NICKEL, faces=faces, style=style, length=0.3, projection=0.05, girth=0.011
    )
    link = asset_of(weld(leaf(), pull)).links[0]
    assert (len(link.grasps), len(link.pushes)) == (grasps, pushes)  # pulled in front, pushed at the back
    assert len(link.colliders) <= 40
    for hold in (*link.grasps, *link.pushes):
        assert abs(hold.frame[1, 3]) - THICK / 2 - 0.011 >= 0.035
        towards = hold.frame[:3, 2]
        assert towards @ np.array([0.0, hold.frame[1, 3], 0.0]) < 0.0


def test_a_thumb_piece_goes_down_between_its_ears_with_the_handle() -> None:
    turn = spring_turn(limit=0.8)
    plate = grip(thickness=THICK, depth=DEPTH, finish=NICKEL, length=0.23, projection=0.055)
    door = weld(leaf(spindle_hole(THICK)), plate)
    knob = knob_handle(
        thickness=THICK,
        rose_depth=DEPTH,
        finish=NICKEL,
        faces="back",
        style="ball",
        radius=0.026,
        projection=0.06,
    )
    door = door.attach(knob, turn).attach(
        thumb_piece(thickness=THICK, depth=DEPTH, finish=NICKEL),
        thumb_press(turn, limit=0.8, thickness=THICK, depth=DEPTH),
    )
    asset = asset_of(door)
    for angle in (0.0, 0.4, 0.8):
        assert overlaps(asset, {"handle_turn": angle}) == []
    assert asset.positions({"handle_turn": 0.8})["thumb_press"] == pytest.approx(THUMB_RANGE)
    thumb = asset.link("thumb_latch").pushes[0].frame[:3, 3]
    pose = asset.pose({"handle_turn": 0.8})["thumb_latch"]
    assert (pose[:3, :3] @ thumb + pose[:3, 3])[2] < thumb[2] - 0.008


@pytest.mark.parametrize("style", ["round", "square", "plate"])
def test_roses_cover_their_hole_and_show_no_gap_to_the_leaf(style: str) -> None:
    body = weld(
        leaf(spindle_hole(THICK)),
        rose(thickness=THICK, depth=DEPTH, across=0.06, finish=NICKEL, style=style, pin=True),
    )
    link = asset_of(body).links[0]
    low, high = link.bounds()
    assert low[1] == pytest.approx(-THICK / 2 - DEPTH, abs=0.001)
    assert high[1] == pytest.approx(THICK / 2 + DEPTH, abs=0.001)
    assert len(link.colliders) <= 32
