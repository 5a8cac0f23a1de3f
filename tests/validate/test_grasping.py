"""Grasps and pushes that hands can take pass; each one that is moved, turned or mis-sized is refused."""

import time
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import artgen
from artgen import (
    Body,
    Prismatic,
    Revolute,
    Spring,
    X,
    Y,
    Z,
    box,
    cylinder,
    frame,
    grasp_on,
    material,
    part,
    push_on,
)
from artgen.asset import Asset, rotation
from artgen.asset.affordance import Grasp, Push
from artgen.asset.report import CheckResult
from artgen.graph import evaluate
from artgen.validate import validate
from artgen.validate.hands import check_grasps
from support.cases import some

STEEL = material("steel")
SEEDS = range(8)


@cache
def door(opener: str) -> Asset:
    bolted = opener in ("pull", "lever")
    return artgen.generate(
        "door", 4, certify=False, opener=opener, bolted=bolted, layout="single", opens="towards", hand="left"
    )


@cache
def bathroom(kind: str, lock: str) -> Asset:
    return artgen.generate("handle", 1, certify=False, kind=kind, lock=lock)


def faults(asset: Asset) -> list[str]:
    return [str(fault) for fault in check_grasps(asset).faults]


def changed(asset: Asset, name: str, matrix: np.ndarray | None = None, width: float = 0.0) -> Asset:
    """Return the asset with one hold moved by a motion in its own frame, or a grasp made wider."""

    def change(hold):
        if hold.name != name:
            return hold
        moved = replace(hold, frame=hold.frame @ (np.eye(4) if matrix is None else matrix))
        return replace(moved, width=moved.width + width) if width else moved

    links = [
        replace(link, grasps=tuple(map(change, link.grasps)), pushes=tuple(map(change, link.pushes)))
        for link in asset.links
    ]
    assert any(name == each.name for each in asset.affordances)
    return replace(asset, links=tuple(links))


def shift(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, 3] = (x, y, z)
    return matrix


def turned(axis, angle: float) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3] = rotation(np.array(axis, float), angle)
    return matrix


@pytest.mark.parametrize("category", ["door", "handle"])
@pytest.mark.parametrize("seed", SEEDS)
def test_hands_can_do_what_the_categories_promise(category: str, seed: int) -> None:
    asset = artgen.generate(category, seed, certify=False)
    start = time.process_time()
    result = check_grasps(asset)
    assert time.process_time() - start < 2.0  # 0.1 s on a quiet machine
    assert not result.faults, "\n".join(map(str, result.faults))
    moved = {name for each in asset.affordances for name in each.joints}
    assert moved == {joint.name for joint in asset.free_joints}


@pytest.mark.parametrize(("category", "seed"), [("door", 2), ("handle", 13)])
def test_an_asset_read_back_is_judged_as_in_memory(category: str, seed: int, tmp_path: Path) -> None:
    asset = artgen.generate(category, seed, certify=False).with_base("free")
    read = Asset.load(asset.export(tmp_path / "out", formats=("urdf",), textures=0))
    fresh, stored = check_grasps(asset), check_grasps(read)
    assert fresh.findings
    assert [finding.message for finding in fresh.findings] == [finding.message for finding in stored.findings]


GRASPS = [
    ("lever", "handle_grasp_0"),
    ("lever", "handle_grasp_1"),
    ("lever", "lock_grasp"),
    ("knob", "handle_grasp_0"),
    ("knob", "handle_grasp_1"),
    ("pull", "handle_front_grasp"),
]
WRONG = {
    "30 mm up the closing direction": shift(x=0.03),
    "30 mm down the closing direction": shift(x=-0.03),
    "30 mm too deep": shift(z=0.03),
    "30 mm too far out": shift(z=-0.03),
    "approach reversed": turned((1, 0, 0), np.pi),
}


@pytest.mark.parametrize(("opener", "name"), GRASPS)
@pytest.mark.parametrize("wrong", some(WRONG, 2))
def test_a_wrong_grasp_is_refused(opener: str, name: str, wrong: str) -> None:
    asset = door(opener)
    assert faults(asset) == []
    found = faults(changed(asset, name, WRONG[wrong]))[0]
    assert f"grasp {name}: " in found
    assert any(remedy in found for remedy in ("move", "put", "make"))


@pytest.mark.parametrize(
    ("opener", "name"), [each for each in GRASPS if each[0] != "knob"]
)  # a knob may be held so and so
def test_a_grasp_along_a_bar_is_refused(opener: str, name: str) -> None:
    (found,) = faults(changed(door(opener), name, turned((0, 0, 1), np.pi / 2)))
    assert "on its way to the grasp the " in found


@pytest.mark.parametrize(("opener", "name"), GRASPS)
@pytest.mark.parametrize("more", some([-0.005, 0.012], 2))
def test_a_width_that_the_fingers_do_not_need_is_refused(opener: str, name: str, more: float) -> None:
    (found,) = faults(changed(door(opener), name, width=more))
    assert "leaves each finger" in found or "opens to 80 mm" in found
    assert f"grasp {name}: its width" in found


PUSHES = [
    (lambda: door("pull"), "handle_back_push_point"),
    (lambda: door("pull"), "door_push_point"),
    (lambda: door("push_bar"), "handle_push_point"),
    (lambda: bathroom("lever", "push"), "lock_push_point"),
    (lambda: bathroom("grip_set", "none"), "thumb_latch_push_point"),
]


@pytest.mark.parametrize(("asset", "name"), PUSHES, ids=[name for _, name in PUSHES])
@pytest.mark.parametrize("wrong", [shift(z=0.03), shift(z=-0.03), turned((1, 0, 0), np.pi)])
def test_a_push_off_the_surface_or_from_behind_is_refused(asset, name: str, wrong: np.ndarray) -> None:
    assert faults(asset()) == []
    found = faults(changed(asset(), name, wrong))
    assert any(f"push {name}: " in fault for fault in found), found


@pytest.mark.parametrize("name", ["lock_push_point", "thumb_latch_push_point"])
@pytest.mark.parametrize("wrong", [shift(x=0.03), shift(y=0.03)])
def test_a_push_beside_a_small_button_is_refused(name: str, wrong: np.ndarray) -> None:
    asset = bathroom("lever", "push") if name.startswith("lock") else bathroom("grip_set", "none")
    assert any(f"push {name}: " in fault for fault in faults(changed(asset, name, wrong)))


def slider(
    *,
    limits: tuple[float, float] = (0.0, 0.2),
    axis=-Y,
    grasp=None,
    push=None,
    post: Body | None = None,
    thick: float = 0.02,
) -> Asset:
    """A drawer's bar at the origin, in front of a wall, that slides; and something else that may be there."""

    @artgen.generator
    def made() -> Body:
        bar = box(0.2, 0.02, thick)
        hold = [grasp_on(bar)] if grasp is None and push is None else [] if grasp is None else [grasp]
        wall = part(box(0.4, 0.02, 0.4).at(0, 0.1, 0), "wall", STEEL)
        moving = part(bar, "bar", STEEL, grasp=hold, push=() if push is None else push)
        body = wall.attach(moving, Prismatic("slide", axis=axis, limits=limits))
        return body if post is None else body.attach(post, Prismatic("aside", axis=X, limits=(0, 0)))

    return made.generate(certify=False)


def test_hands_of_independent_limits_are_notes() -> None:
    """The flaps of this box stand open, beyond the points at which they are pushed."""
    closed = artgen.generate("box", 343425, detail="medium")
    assert not check_grasps(closed).faults
    findings = check_grasps(closed.with_limits("independent")).findings
    assert any("pushes against the limit of the joint" in each.message for each in findings)
    assert {each.severity for each in findings} == {"note"}


def test_a_plain_handle_bar_passes() -> None:
    assert check_grasps(slider()) == CheckResult("grasps", (), "1 grasps, 0 pushes")


def test_a_thing_on_the_way_is_named() -> None:
    post = part(box(0.01, 0.01, 0.01).at(0, -0.15, 0), "post", STEEL)
    (found,) = faults(slider(post=post))
    assert found == (
        "link bar: grasp bar_grasp: on its way to the grasp the hand strikes post/post; move the frame, come "
        "from another direction, or make the width that of the object"
    )


def test_a_thing_that_fingers_touch_first_is_named() -> None:
    post = part(box(0.01, 0.006, 0.002).at(0, 0, 0.0125), "post", STEEL)
    (found,) = faults(slider(post=post))
    assert found.startswith(
        "link bar: grasp bar_grasp: a closing finger touches post/post 3.5 mm before the "
    )


def test_a_thing_too_thick_is_refused_with_its_thickness() -> None:
    found = faults(slider(thick=0.076))
    assert found[0].startswith(
        "link bar: grasp bar_grasp: the held object is 76 mm thick; the gripper opens to 80 mm; grip it "
        "where it is thinner"
    )
    assert "its width is 110 mm, and the gripper opens to 80 mm" in faults(slider(thick=0.1))[0]


def test_fingers_that_close_on_nothing_are_refused() -> None:
    (found,) = faults(slider(grasp=frame((0, -0.15, 0))))
    assert "the fingers close on nothing of link bar; put its origin into the middle" in found


def test_a_thing_held_by_the_last_bit_of_the_pads_is_refused() -> None:
    (found,) = faults(slider(grasp=frame((0, -0.018, 0))))
    assert "only 1 mm by 20 mm of a pad touch the link; move the frame along the approach or across" in found


def test_faces_that_do_not_look_at_each_other_are_refused() -> None:
    @artgen.generator
    def skew() -> Body:
        upper, lower = (
            box(0.008, 0.02, 0.003).at(-0.006, 0, 0.0015),
            box(0.008, 0.02, 0.003).at(0.006, 0, -0.0015),
        )
        solid = upper | lower | box(0.014, 0.02, 0.002)
        moving = part(solid, "bar", STEEL, grasp=frame((0, 0, 0)))
        wall = part(box(0.4, 0.02, 0.4).at(0, 0.1, 0), "wall", STEEL)
        return wall.attach(moving, Prismatic("slide", axis=-Y, limits=(0, 0.1)))

    (found,) = faults(skew.generate(certify=False))
    assert "apart sideways: it rotates out of the grasp; close on faces that are opposite each other" in found


def test_a_hand_that_is_stopped_on_its_way_is_told_and_one_that_cannot_move_is_refused() -> None:
    far = part(box(0.3, 0.01, 0.3).at(0, -0.25, 0), "post", STEEL)
    (note,) = check_grasps(slider(post=far)).findings
    assert note.severity == "note"
    assert 0.5 < (note.value or 0.0) < 0.8
    assert note.message.startswith("grasp bar_grasp: the hand moves the joint through ")
    assert note.message.endswith(" % of its range, then the hand strikes post/post")
    near = part(box(0.3, 0.01, 0.3).at(0, -0.135, 0) - box(0.21, 0.1, 0.07).at(0, -0.13, 0), "post", STEEL)
    found = faults(slider(post=near))
    assert "on its way to the grasp the hand strikes post/post" in found[0]


def test_a_hand_that_can_hardly_move_is_a_fault_with_the_share_and_the_joint() -> None:
    rail = part(box(0.4, 0.4, 0.02).at(0, -0.2, -0.13), "post", STEEL)
    found = faults(slider(post=rail, axis=-Z, limits=(0.0, 0.2)))
    assert found[0].startswith(
        "link bar, joint slide: grasp bar_grasp: the hand moves the joint through 6 % of its range, then the "
        "hand strikes post/post (at slide=0.025); turn or move the frame"
    )
    assert found[1].startswith(
        "joint slide: no hand at bar_grasp moves it through 20 % of its range; correct one"
    )


def push_at(y: float = -0.01, **options):
    return frame((0, y, 0), approach=options.get("approach", (0, 1, 0)), closing=X)


def test_a_push_moves_a_joint_only_where_that_can_go() -> None:
    assert faults(slider(push=push_at(), axis=Y, limits=(0, 0.05))) == []
    assert faults(slider(push=push_at(), limits=(-0.05, 0.05))) == []
    (found,) = (each for each in faults(slider(push=push_at())) if "push bar" in each)
    assert (
        "joint slide: push bar_push_point: it pushes against the limit of the joint; turn the push" in found
    )
    slanting = faults(slider(push=push_at(), axis=(1.0, 0.3, 0.0), limits=(0, 0.05)))
    assert "only 0.29 of its force moves the joint" in slanting[0]


def test_a_finger_that_meets_something_else_first_says_by_how_much() -> None:
    post = part(box(0.004, 0.01, 0.004).at(0, -0.03, 0), "post", STEEL)
    found = faults(slider(push=push_at(), axis=Y, limits=(0, 0.05), post=post))
    assert (
        "push bar_push_point: the finger touches post 25 mm before link bar; move the point away" in found[0]
    )


def test_a_point_off_the_surface_says_by_how_much() -> None:
    found = faults(slider(push=push_at(-0.013), axis=Y, limits=(0, 0.05)))
    assert "the surface is 3 mm behind its point; put its origin on the surface" in found[0]
    found = faults(slider(push=push_at(-0.007), axis=Y, limits=(0, 0.05)))
    assert "the surface is 3 mm before its point" in found[0]
    far = frame((0, -0.01, 0.1), approach=Y, closing=X)
    assert "touches nothing of link bar there" in faults(slider(push=far, axis=Y, limits=(0, 0.05)))[0]
    edge = frame((0, -0.01, 0.015), approach=Y, closing=X)
    assert (
        "beside its point, 5 mm off or at an edge" in faults(slider(push=edge, axis=Y, limits=(0, 0.05)))[0]
    )


def test_a_joint_that_no_hand_moves_is_a_fault_unless_the_asset_has_no_hands_at_all() -> None:
    @artgen.generator
    def two(*, held: bool = True, driven: str = "") -> Body:
        bar, lid = box(0.2, 0.02, 0.02), box(0.2, 0.2, 0.01).at(0, 0.3, 0.3)
        wall = part(box(0.4, 0.02, 0.4).at(0, 0.1, 0), "wall", STEEL)
        moving = part(bar, "bar", STEEL, grasp=grasp_on(bar) if held else ())
        body = wall.attach(moving, Prismatic("slide", axis=-Y, limits=(0, 0.1)))
        return body.attach(part(lid, "lid", STEEL), Revolute("hinge", axis=X, limits=(0, 1), driven=driven))

    (found,) = faults(two.generate(certify=False))
    assert found == (
        "joint hinge: no grasp or push moves it; "
        "give lid or a link behind it a grasp or a push, or name its actuator: driven=..."
    )
    by_motor = two.generate(driven="a motor", certify=False)
    assert not faults(by_motor)
    assert by_motor.joint("hinge").driven == "a motor"
    assert by_motor.to_data()["joints"][1]["driven"] == "a motor"
    (note,) = check_grasps(two.generate(held=False, certify=False)).findings
    assert (note.severity, note.message) == ("note", "no grasp or push moves slide, hinge")
    assert "grasp=grasp_on(...)" in note.hint


def test_a_hand_may_not_hold_another_link_than_its_own() -> None:
    asset = door("lever")
    links = [
        replace(link, grasps=()) if link.grasps else replace(link, grasps=asset.link("handle").grasps)
        for link in asset.links
    ]
    stolen = [each for each in faults(replace(asset, links=tuple(links))) if "nothing of link" in each]
    assert stolen


def test_validate_runs_the_check_on_the_files(tmp_path: Path) -> None:
    asset = changed(slider(), "bar_grasp", shift(x=0.004))
    (result,) = validate(asset.export(tmp_path / "bar", formats=("mjcf",)), checks=["grasps"]).results
    (fault,) = result.faults
    assert (fault.check, fault.link) == ("grasps", "bar")
    assert fault.message == "grasp bar_grasp: the held object is 4 mm off the middle between the fingers"
    (skipped,) = validate(asset.export(tmp_path / "usd", formats=("usd",)), checks=["grasps"]).results
    assert skipped.skipped


@pytest.mark.parametrize("radius", [0.02, 0.035, 0.037])
def test_round_knobs_up_to_74_mm_are_held(radius: float) -> None:
    @artgen.generator
    def dial() -> Body:
        knob = cylinder(radius, 0.022, axis=Y).at(0, -0.0215, 0)
        wall = part(box(0.4, 0.02, 0.4), "wall", STEEL)
        turning = part(knob, "knob", STEEL, grasp=grasp_on(knob, depth=0.02))
        return wall.attach(turning, Revolute("turn", axis=Y))

    assert faults(dial.generate(certify=False)) == []


def test_the_frames_of_holds_are_those_of_the_asset() -> None:
    found = {each.name: each for each in door("push_bar").affordances}
    holds = [hold for link in door("push_bar").links for hold in (*link.grasps, *link.pushes)]
    assert {hold.name: type(hold) for hold in holds} == {
        name: Grasp if each.kind == "grasp" else Push for name, each in found.items()
    }


@pytest.mark.parametrize(("height", "says"), [(0.1, ["the hand reaches 52 mm below"]), (0.3, [])])
def test_a_hand_that_reaches_below_the_ground_is_noted(height: float, says: list[str]) -> None:
    @artgen.generator
    def low() -> Body:
        wall = part(box(0.4, 0.02, height).at(0, 0.1, 0), "wall", STEEL)
        bar = box(0.2, 0.02, 0.02)
        moving = part(bar, "bar", STEEL, grasp=grasp_on(bar))
        return wall.attach(moving, Prismatic("slide", axis=-Y, limits=(0.0, 0.2)))

    result = check_grasps(low.generate(certify=False))
    assert not result.faults
    assert [each.message.split(": ")[1].split(" the lowest")[0] for each in result.findings] == says


def laptop(*, keys_when: bool, driven: str = "a hand at its edge", swing: float = 2.0) -> Asset:
    """Return a base with a key under a closed lid that no gripper holds."""
    turn = Revolute(
        "lid_hinge", axis=-X, pivot=(0, 0.1, 0.021), limits=(0, swing), friction=2.0, driven=driven
    )
    lid = part(box(0.3, 0.2, 0.006).at(z=0.024), "lid", STEEL)
    cap = cylinder(0.010, 0.006).at(z=0.014)
    pushed = push_on(cap, direction=-Z)
    key = (
        part(cap, "key", STEEL, push=pushed, when=turn > 1.0)
        if keys_when
        else part(cap, "key", STEEL, push=pushed)
    )
    press = Prismatic("press", axis=-Z, limits=(0, 0.002), spring=Spring(preload=0.3, force=1.0))
    base = part(box(0.3, 0.2, 0.02).at(z=0.01) - cylinder(0.0106, 0.03).at(z=0.022), "base", STEEL)
    return Asset.from_tree(
        evaluate(base.attach(lid, turn).repeat(key, press, at=[(0, 0, 0)])).value, "pad", "pad"
    )


def test_keys_under_a_driven_lid_are_reached_after_it_opened() -> None:
    result = check_grasps(laptop(keys_when=False))
    assert not result.faults
    assert [str(note) for note in result.findings if "reaches it only where lid_hinge > 1.96" in str(note)]


def test_a_declared_condition_opens_the_lid_and_is_recorded() -> None:
    asset = laptop(keys_when=True)
    assert not check_grasps(asset).findings
    (data,) = asset.to_data()["affordances"]
    assert data["when"] == {"kind": "above", "joint": "lid_hinge", "value": 1.0}
    assert str(asset.affordances[0].when) == "lid_hinge > 1"
    assert "when" not in laptop(keys_when=False).to_data()["affordances"][0]


def test_a_condition_survives_files(tmp_path: Path) -> None:
    back = artgen.load(laptop(keys_when=True).export(tmp_path / "pad", formats=("mjcf",)))
    assert str(back.affordances[0].when) == "lid_hinge > 1"


def test_a_condition_out_of_reach_or_of_no_joint_is_a_fault() -> None:
    (fault, *_) = faults(laptop(keys_when=True, swing=0.9))
    assert "push key_push_point_0: lid_hinge > 1 cannot be" in fault
    cap = cylinder(0.010, 0.006)
    turn = Revolute("lid_hinge", axis=X, limits=(0, 2))
    alone = part(cap, "key", STEEL, push=push_on(cap, direction=-Z), when=turn > 1.0)
    with pytest.raises(
        artgen.ArtgenError, match="'lid_hinge' is not a joint of this asset; attach 'lid_hinge'"
    ):
        Asset.from_tree(evaluate(alone).value, "key", "key")
    with pytest.raises(artgen.ArtgenError, match=r"when=lid_hinge > 1 .* give grasp= or push= as well"):
        evaluate(part(cap, "key", STEEL, when=turn > 1.0))


def test_the_joints_of_a_condition_are_renamed_with_their_body() -> None:
    turn = Revolute("flap", axis=X, pivot=(0, 0.2, 0), limits=(0, 2))
    cap = cylinder(0.010, 0.006)
    key = part(cap, "key", STEEL, push=push_on(cap, direction=-Z), when=turn > 1.0)
    both = part(box(0.1, 0.1, 0.1).at(z=-0.1), "base", STEEL).attach(
        key, Prismatic("press", axis=-Z, limits=(0, 0.001))
    )
    both = both.attach(part(box(0.1, 0.1, 0.01).at(0, 0.3, 0), "flap", STEEL), turn).suffixed("_a")
    (affordance,) = Asset.from_tree(evaluate(both).value, "pad", "pad").affordances
    assert (affordance.name, str(affordance.when)) == ("key_push_point_a", "flap_a > 1")
