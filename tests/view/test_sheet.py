"""Contact sheets, open positions, and the commands that draw."""

from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from PIL import Image

from artgen.asset import Asset
from artgen.errors import ExportError, ParameterError
from artgen.generator import generator
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box
from artgen.nodes.vector import X, Y, Z
from artgen.view import opened
from artgen.view import sheet as sheets
from artgen.view.sheet import features, save_sheet, sheet, shots

OAK = material("oak")
DRAW = {"textures": 0, "size": 48}


@generator
def locked_door(*, swing: Float = 1.8, push: bool = False) -> Body:
    """A door that opens once its lever is turned."""
    door = part(box(0.8, 0.04, 2.0), "door", OAK)
    turn = Revolute("lever_turn", axis=Y, limits=(0, 0.7))
    lever = part(box(0.12, 0.02, 0.02).at(0.3, -0.08), "handle", OAK)
    needs = (turn > 0.5).until(0.05) if not push else turn > 0.5
    hinge = Revolute("door_hinge", pivot=(-0.4, 0, 0), axis=-Z, limits=(0, swing), needs=needs)
    frame = part(box(0.1, 0.1, 2.1).at(-0.5), "frame", OAK)
    return frame.attach(door.attach(lever, turn), hinge)


@generator
def lone_lever() -> Body:
    turn = Revolute("turn", axis=X, limits=(-0.6, 0.2))
    return part(box(0.1, 0.1, 0.1), "base", OAK).attach(
        part(box(0.1, 0.02, 0.02).at(0, -0.1), "lever", OAK), turn
    )


@generator
def drawer_and_wheel() -> Body:
    base = part(box(0.2, 0.2, 0.2), "base", OAK)
    base = base.attach(
        part(box(0.1, 0.02, 0.05).at(0, -0.12), "drawer", OAK), Prismatic("slide", axis=-Y, limits=(0, 0.1))
    )
    return base.attach(
        part(box(0.02, 0.1, 0.1).at(0.12), "wheel", OAK), Revolute("spin", axis=X, limits=None)
    )


@generator
def fridge(*, swing: Float = 2.2, needs: Float = 1.3, hand: Literal["left", "right"] = "left") -> Body:
    """A door before two drawers and a freezer drawer; the drawers need the door open."""
    side = -1.0 if hand == "left" else 1.0
    hinge = Revolute("door_hinge", pivot=(0.4 * side, -0.35, 0), axis=side * Z, limits=(0, swing))
    body = part(box(0.8, 0.6, 1.8).at(z=0.9), "body", OAK)
    body = body.attach(part(box(0.8, 0.05, 1.4).at(0, -0.35, 1.0), "door", OAK), hinge)
    for number, height in enumerate((0.5, 0.8)):
        slide = Prismatic(f"drawer_slide_{number}", axis=-Y, limits=(0, 0.3), needs=hinge > needs)
        drawer = part(box(0.7, 0.5, 0.2).at(z=height), f"drawer_{number}", OAK)
        body = body.attach(drawer, slide)
    slide = Prismatic("freezer_slide", axis=-Y, limits=(0, 0.4))
    return body.attach(part(box(0.7, 0.6, 0.2).at(0, -0.05, 0.15), "freezer", OAK), slide)


def test_a_door_opens_two_thirds_and_its_lever_rests() -> None:
    assert opened(locked_door.generate()) == pytest.approx({"door_hinge": 0.45 * 1.8})
    assert opened(locked_door.generate(swing=1.0)) == pytest.approx({"door_hinge": 1.0})


def test_what_a_joint_needs_is_held_where_it_could_not_stand_open_otherwise() -> None:
    asset = locked_door.generate(push=True)
    q = opened(asset)
    assert q == pytest.approx({"door_hinge": 0.45 * 1.8, "lever_turn": 0.7})
    assert not asset.blocked(q)


def test_a_lever_alone_turns_to_its_farther_end() -> None:
    assert opened(lone_lever.generate()) == pytest.approx({"turn": -0.6})
    assert opened(lone_lever.generate(), 0.5) == pytest.approx({"turn": -0.3})


def test_every_share_is_allowed_by_dependencies() -> None:
    for asset in (locked_door.generate(), locked_door.generate(push=True), drawer_and_wheel.generate()):
        assert opened(asset, 0.0) == {}
        for share in np.linspace(0, 1, 21):
            assert not asset.blocked(opened(asset, float(share)))
    assert opened(drawer_and_wheel.generate()) == pytest.approx({"slide": 0.1, "spin": 0.8})


def test_a_door_stands_open_as_far_as_what_is_behind_it_needs() -> None:
    asset = fridge.generate(certify=False)
    q = opened(asset)
    assert q["door_hinge"] == pytest.approx((1.3 + 2.2) / 2.0)
    assert set(q) == {"door_hinge", "drawer_slide_0", "drawer_slide_1", "freezer_slide"}
    assert not asset.blocked(q)
    # a door of which less is asked opens as doors do
    assert opened(fridge.generate(certify=False, needs=0.8))["door_hinge"] == pytest.approx(0.45 * 2.2)


def test_drawers_above_each_other_come_out_like_stairs() -> None:
    q = opened(fridge.generate(certify=False))
    assert q["freezer_slide"] == pytest.approx(0.4)
    assert q["drawer_slide_0"] == pytest.approx(0.7 * 0.3)
    assert q["drawer_slide_1"] == pytest.approx(0.4 * 0.3)


def test_what_is_lifted_goes_up_by_half() -> None:
    @generator
    def lift() -> Body:
        up, down = Prismatic("up", axis=Z, limits=(0, 0.3)), Prismatic("down", axis=-Z, limits=(0, 0.3))
        base = part(box(0.2, 0.2, 0.2).at(z=1.0), "base", OAK)
        base = base.attach(part(box(0.2, 0.2, 0.2).at(z=1.3), "bucket", OAK), up)
        return base.attach(part(box(0.2, 0.2, 0.2).at(z=0.7), "blind", OAK), down)

    assert opened(lift.generate(certify=False)) == pytest.approx({"up": 0.15, "down": 0.3})


def test_what_is_behind_a_door_stays_in_until_the_door_is_open() -> None:
    asset = fridge.generate(certify=False)
    half = opened(asset, 0.5)
    assert half == pytest.approx({"door_hinge": 0.5 * (1.3 + 2.2) / 2.0, "freezer_slide": 0.2})
    for share in np.linspace(0, 1, 21):
        assert not asset.blocked(opened(asset, float(share)))


def test_a_door_that_cannot_open_far_enough_leaves_the_drawers_in() -> None:
    asset = fridge.generate(certify=False, swing=1.1)
    assert set(opened(asset)) == {"door_hinge", "freezer_slide"}


@pytest.mark.parametrize(("hand", "side"), [("left", 1.0), ("right", -1.0)])
def test_one_looks_past_the_edge_of_a_door(hand, side) -> None:
    closed, open_, behind = shots(fridge.generate(certify=False, hand=hand))
    assert closed[0] == behind[0] == {}
    assert open_[0]
    assert closed[1] == open_[1]
    assert np.sign(closed[1].azimuth) == side
    assert behind[1].azimuth == pytest.approx(closed[1].azimuth + np.pi)


def test_one_looks_between_doors_from_nearer_the_middle() -> None:
    @generator
    def pair() -> Body:
        body = part(box(0.8, 0.6, 1.8).at(z=0.9), "body", OAK)
        for side, name in ((-1.0, "left"), (1.0, "right")):
            hinge = Revolute(f"hinge_{name}", pivot=(0.4 * side, -0.35, 0), axis=side * Z, limits=(0, 2.0))
            leaf = box(0.39, 0.05, 1.6).at(0.2 * side, -0.35, 0.9)
            body = body.attach(part(leaf, f"door_{name}", OAK), hinge)
        return body

    alone = abs(shots(fridge.generate(certify=False))[0][1].azimuth)
    assert abs(shots(pair.generate(certify=False))[0][1].azimuth) == pytest.approx(alone / 2.0)


def test_one_looks_down_on_what_is_small() -> None:
    heights = [shots(asset)[0][1].elevation for asset in (lone_lever.generate(), locked_door.generate())]
    assert heights[0] > heights[1] + 0.1


def test_pictures_are_as_wide_as_what_they_show() -> None:
    assert sheets._aspect(locked_door.generate()) < 0.7
    assert sheets._aspect(drawer_and_wheel.generate()) > 0.8


@pytest.mark.parametrize("share", [-0.1, 1.5, float("nan")])
def test_other_shares_are_refused(share) -> None:
    with pytest.raises(ParameterError, match=r"open .* must be in 0\.\.1"):
        opened(lone_lever.generate(), share)


class TestSheet:
    def test_it_has_a_cell_for_each_asset_with_all_poses_and_sides(self, red_cabinet) -> None:
        seen = []
        page = sheet([lambda: red_cabinet] * 3, columns=2, progress=lambda *each: seen.append(each), **DRAW)
        assert seen == [(1, 3), (2, 3), (3, 3)]
        one = sheet([lambda: red_cabinet], views=1, **DRAW)
        assert page.shape[0] > 2 * 48
        assert page.shape[1] > 1.5 * one.shape[1]
        assert (page[0] == 255).all()
        assert (page[:, -1] == 255).all()
        # one of four cells is free
        assert (page[page.shape[0] // 2 + 10 :, page.shape[1] // 2 + 10 :] == 255).all()
        # the captions are dark on white
        caption = one[60:80]
        assert (caption.min(axis=2) < 80).any()

    def test_open_differs_from_closed(self, red_cabinet) -> None:
        page = sheet([lambda: red_cabinet], views=1, **DRAW).astype(int)
        body = page[12:60, 12:-12]
        half = body.shape[1] // 2
        assert np.abs(body[:, :half] - body[:, half : 2 * half]).mean() > 3.0

    @pytest.mark.parametrize("arguments", [{"assets": []}, {"views": 0}, {"views": 3}, {"columns": 0}])
    def test_wrong_numbers_are_refused(self, red_cabinet, arguments) -> None:
        assets = arguments.pop("assets", [lambda: red_cabinet])
        with pytest.raises(
            ParameterError, match="a sheet needs at least 1 asset and 1 column, and 1 or 2 views"
        ):
            sheet(assets, **arguments)


def test_words_tell_size_and_structure() -> None:
    parameters = {
        "style": "flat_panel",
        "width": 0.3,
        "metal": "none",
        "wood": "oak_09af3c",
        "hand": "left",
        "handle.style": "bar",
    }
    asset = replace(lone_lever.generate(), parameters=parameters)
    low, high = asset.bounds()
    size = " x ".join(f"{100 * length:.0f}" for length in high - low)
    assert features(asset) == f"{size} cm, flat panel, oak, left"


def test_a_caption_that_is_too_long_says_so() -> None:
    lines = sheets._wrapped("oak, " * 60, 300)
    assert len(lines) == 2
    assert lines[1].endswith("oak ...")
    assert sheets._wrapped("oak, brass", 300) == ["oak, brass"]


def test_a_jpeg_sheet_is_small_and_as_good_as_can_be(tmp_path, monkeypatch) -> None:
    pixels = np.random.default_rng(0).integers(0, 256, (400, 600, 3)).astype(np.uint8)
    path = save_sheet(pixels, tmp_path / "noise.jpg")
    assert 100_000 < path.stat().st_size <= 250_000
    monkeypatch.setattr(sheets, "_BYTES", 60_000)
    assert save_sheet(pixels, tmp_path / "less.jpg").stat().st_size < path.stat().st_size
    with Image.open(save_sheet(pixels, tmp_path / "noise.png")) as image:
        np.testing.assert_array_equal(np.asarray(image), pixels)
    with pytest.raises(ExportError, match=r"a picture's name ends in \.png"):
        save_sheet(pixels, tmp_path / "noise.bmp")


@pytest.fixture
def exported(red_cabinet, tmp_path) -> Asset:
    return red_cabinet.export(tmp_path / "cabinet", formats=("urdf",))


FAST = ("--texture-size", "0", "--size", "64x48")


class TestCommands:
    def test_render_draws_an_export(self, artgen_command, exported) -> None:
        closed = artgen_command("render", str(exported), *FAST)
        assert (closed.code, closed.out, closed.err) == (0, "cabinet_0.png\n", "")
        before = np.asarray(Image.open("cabinet_0.png"))
        assert before.shape == (48, 64, 3)
        for more in (
            ("--open", "1"),
            ("--joint", "door_hinge=1.0", "--joint", "drawer_slide=0.1"),
            ("--view", "back"),
        ):
            assert artgen_command("render", str(exported), *FAST, *more, "--out", "b.jpg").out == "b.jpg\n"
            after = np.asarray(Image.open("b.jpg")).astype(int)
            assert np.abs(after - before).mean() > 3.0, more

    @pytest.mark.parametrize("show", ["links", "labels", "depth", "normals"])
    def test_render_shows_what_pixels_tell(self, artgen_command, exported, show) -> None:
        assert artgen_command("render", str(exported), *FAST, "--show", show, "--out", "m.png").code == 0
        pixels = np.asarray(Image.open("m.png"))
        assert len(np.unique(pixels.reshape(-1, 3), axis=0)) >= 4
        assert (pixels[0, 0] == pixels[-1, -1]).all()

    def test_render_draws_a_category(self, artgen_command) -> None:
        command = ("render", "handle", "--seed", "3", *FAST, "--out")
        done = artgen_command(*command, "h.png")
        assert (done.code, done.out) == (0, "h.png\n")
        assert Path("h.png").stat().st_size > 500
        assert artgen_command(*command, "low.png", "--detail", "low").out == "low.png\n"
        assert Path("low.png").read_bytes() != Path("h.png").read_bytes()

    def test_sheet_draws_samples(self, artgen_command) -> None:
        done = artgen_command("sheet", "handle", "--seeds", "2", "--first-seed", "5", "--size", "64")
        assert (done.code, done.out, done.err) == (0, "handle.jpg\n", "")
        assert Path("handle.jpg").stat().st_size <= 250_000


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("render", "handel"), "handel"),
        (("render", "handle", "--view", "frond"), "there is no view 'frond'"),
        (("render", "handle", "--size", "big"), "--size 'big' must be a number of pixels"),
        (("render", "handle", "--size", "1x2x3"), "--size '1x2x3' must be a number of pixels"),
        (("render", "handle", "--size", "5"), "16..4096"),
        (("render", "handle", "--joint", "turn"), "--joint 'turn' must be JOINT=NUMBER"),
        (("render", "handle", "--joint", "nothing=1"), "has no joint 'nothing'"),
        (("render", "handle", "--open", "2"), "open 2.0 must be in 0..1"),
        (("render", "handle", "--out", "a.gif"), "a picture's name ends in .png"),
        (("render", "handle", "--studio", "garden"), "garden"),
        (("render", "."), "asset.json"),
        (("sheet", "handle", "--seeds", "0"), "--seeds 0 must be at least 1"),
        (("sheet", "handle", "--views", "3"), "1 or 2 views"),
        (("sheet", "handle", "--out", "none/a.jpg"), "give a file in a directory that exists"),
        (("sheet", "handle", "--out", "a.gif"), "a picture's name ends in .png"),
        (("sheet", "handel"), "handel"),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(artgen_command, arguments, message) -> None:
    done = artgen_command(*arguments)
    assert done.code == 2
    assert done.out == ""
    assert done.err.startswith("error: ")
    assert done.err.count("\n") == 1
    assert message in done.err


def test_parameters_are_for_categories(artgen_command, exported) -> None:
    done = artgen_command("render", str(exported), "--set", "width=1")
    assert (done.code, done.err.count("\n")) == (2, 1)
    assert "--set is for categories" in done.err


@pytest.mark.parametrize(
    ("command", "option"),
    [
        ("render", "--seed 5"),
        ("view", "--seed 5"),
        ("view", "--no-certify"),
        ("view", "--detail low"),
        ("render", "--detail low"),
        ("check", "--seed 5"),
        ("colliders", "--budgets 3"),
        ("colliders", "--seed 4"),
    ],
)
def test_options_of_categories_do_nothing_for_an_export(artgen_command, exported, command, option) -> None:
    done = artgen_command(command, str(exported), *option.split())
    words = f"error: {option.split()[0]} does nothing for an exported asset; leave it out\n"
    assert (done.code, done.out, done.err) == (2, "", words)
