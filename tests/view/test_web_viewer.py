"""The web viewer in a real Chromium: what is seen and what moves is what Python says, without an error."""

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

import artgen
from artgen import (
    Body,
    Float,
    Prismatic,
    Revolute,
    Y,
    Z,
    box,
    choice,
    cylinder,
    generator,
    grasp_on,
    material,
    part,
    uniform,
)
from artgen.asset import Asset
from artgen.scene import Scene
from artgen.view import page, page_of
from artgen.view.viewer import exploded, viewer_data
from support.browser import Browser, Tab, started
from support.cases import some

CLOSE = 1e-9


@generator
def locker(
    *, width: Float = uniform(0.39, 0.41, "m"), finish: Literal["oak", "walnut"] = choice("oak", "walnut")
) -> Body:
    """A locker: behind its door is a drawer, and a dial on its top turns as the door does."""
    case = box(width, 0.4, 0.5).at(z=0.25) - box(width - 0.04, 0.4, 0.46).at(0, -0.02, 0.25)
    inside = box(width - 0.06, 0.3, 0.2).at(0, -0.02, 0.2)
    tray = inside - box(width - 0.09, 0.27, 0.2).at(0, -0.02, 0.22)
    grip = box(0.1, 0.02, 0.02).at(0, -0.18, 0.2)
    leaf = box(width, 0.02, 0.5).at(0, -0.212, 0.25)
    dial = cylinder(0.05, 0.02).at(z=0.512)
    turn = Revolute("door_hinge", pivot=leaf.anchor(x=-1, y=-1), axis=-Z, limits=(0.0, 2.0))
    slide = Prismatic("drawer_slide", axis=-Y, limits=(0.0, 0.25), needs=(turn > 1.7).beyond(0.01))
    spin = Revolute("dial_spin", pivot=dial.anchor(), axis=Z, follows=0.5 * turn)
    drawer = part(tray | grip, "drawer", material("steel"), grasp=grasp_on(grip))
    body = part(case, "case", material(finish)).attach(part(leaf, "door", material("glass")), turn)
    return body.attach(drawer, slide).attach(part(dial, "dial", material("brass")), spin)


@generator
def clash() -> Body:
    """A flap that swings into a wall."""
    flap = box(0.2, 0.02, 0.2).at(0, -0.05, 0.1)
    turn = Revolute("flap_hinge", pivot=flap.anchor(x=-1), axis=Z, limits=(0.0, 1.2))
    wall = box(0.4, 0.02, 0.3).at(0, 0.05, 0.15)
    return part(wall, "wall", material("steel")).attach(part(flap, "flap", material("oak")), turn)


@pytest.fixture(scope="module")
def asset() -> Asset:
    return locker.generate(seed=1)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with started() as browser:
        yield browser


@pytest.fixture(scope="module")
def shared(browser: Browser, asset: Asset, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tab]:
    path = asset.show(textures=256).save(tmp_path_factory.mktemp("page") / "locker.html")
    with browser.tab(640, 420, offline=True) as tab:
        yield ready(tab.open(path))


@pytest.fixture
def tab(shared: Tab) -> Iterator[Tab]:
    """The locker, closed and seen as at first; at the end nothing went wrong."""
    shared.page.click("#closed")
    shared.page.click("#home")
    yield shared
    assert shared.problems == []


def ready(tab: Tab) -> Tab:
    tab.page.wait_for_function("window.artgen", timeout=60_000)
    return tab


def drag(tab: Tab, joint: str, share: float) -> None:
    """Move a joint's slider to a share of its way with the mouse, from where its thumb is."""
    slider = tab.page.locator(f"[data-joint={joint}]")
    slider.scroll_into_view_if_needed()
    box = slider.bounding_box()
    low, high, value = (
        float(slider.evaluate(f"each => each.{name}")) for name in ("min", "max", "valueAsNumber")
    )
    thumb = 16
    now, wanted = (
        box["x"] + thumb / 2 + part * (box["width"] - thumb) for part in ((value - low) / (high - low), share)
    )
    middle = box["y"] + box["height"] / 2
    tab.page.mouse.move(now, middle)
    tab.page.mouse.down()
    tab.page.mouse.move(wanted, middle, steps=2)
    tab.page.mouse.up()


def positions(tab: Tab) -> dict[str, float]:
    return tab.page.evaluate("artgen.kinematics.positions(artgen.q)")


def word(tab: Tab, joint: str) -> str:
    return tab.page.inner_text(f"[data-row={joint}] .blocked")


def world(tab: Tab, link: str) -> np.ndarray:
    """Where the scene graph has a link, in asset coordinates as displaced from rest."""
    script = f"""() => {{
        const {{ node, place }} = artgen.model.links.get({link!r});
        const up = artgen.model.root.matrixWorld.clone().invert();
        return up.multiply(node.matrixWorld).multiply(place.clone().invert()).elements;
    }}"""
    return np.array(tab.page.evaluate(script)).reshape(4, 4).T


def stage(tab: Tab) -> np.ndarray:
    """What is seen of the asset, after it is drawn."""
    tab.page.wait_for_function("artgen.studio.sharp", timeout=60_000)
    return tab.picture("#canvas").astype(int)[:-60]  # below are buttons


def changed(before: np.ndarray, after: np.ndarray) -> float:
    """Share of the picture that is not as before."""
    return float((np.abs(before - after).max(axis=2) > 8).mean())


def test_a_slider_opens_the_door_in_the_scene_and_in_the_picture(tab: Tab, asset: Asset) -> None:
    closed = stage(tab)
    drag(tab, "door_hinge", 1.0)
    q = positions(tab)
    assert q["door_hinge"] == pytest.approx(2.0)
    assert np.abs(world(tab, "door") - asset.pose({"door_hinge": q["door_hinge"]})["door"]).max() < CLOSE
    assert tab.page.inner_text("[data-row=door_hinge] output") == "114.6°"
    assert changed(closed, stage(tab)) > 0.05
    tab.page.click("#closed")
    assert changed(closed, stage(tab)) < 0.0001


def test_what_follows_moves_along(tab: Tab, asset: Asset) -> None:
    drag(tab, "door_hinge", 0.6)
    q = positions(tab)
    assert q["dial_spin"] == pytest.approx(0.5 * q["door_hinge"], abs=1e-12)
    assert 1.0 < q["door_hinge"] < 1.4
    assert np.abs(world(tab, "dial") - asset.pose({"door_hinge": q["door_hinge"]})["dial"]).max() < CLOSE
    assert tab.page.locator("[data-joint=dial_spin]").count() == 0
    assert "follows 0.5 \u00d7 door_hinge" in tab.page.inner_text("[data-row=dial_spin]")


def test_a_joint_that_may_not_move_yet_is_held_and_says_why(tab: Tab) -> None:
    drag(tab, "drawer_slide", 0.8)
    assert positions(tab)["drawer_slide"] == pytest.approx(0.01, abs=1e-6)
    assert word(tab, "drawer_slide") == "blocked: needs door_hinge > 97.4° beyond 10.0 mm; door_hinge at 0.0°"
    assert float(tab.page.locator("[data-joint=drawer_slide]").input_value()) == pytest.approx(0.01, abs=1e-6)
    drag(tab, "door_hinge", 1.0)
    assert word(tab, "drawer_slide") == ""
    drag(tab, "drawer_slide", 1.0)
    assert positions(tab)["drawer_slide"] == pytest.approx(0.25)
    drag(tab, "door_hinge", 0.0)
    assert positions(tab)["door_hinge"] == pytest.approx(1.7, abs=1e-6)
    assert word(tab, "door_hinge").startswith("blocked: drawer_slide needs door_hinge > 97.4°")


def test_playing_a_joint_opens_first_what_it_waits_for(tab: Tab) -> None:
    tab.page.evaluate(
        """() => { window.seen = []; const before = artgen.update.bind(artgen);
        artgen.update = (stop) => { seen.push(artgen.kinematics.positions(artgen.q)); before(stop); }; }"""
    )
    tab.page.click("[data-row=drawer_slide] .play")
    tab.page.wait_for_function("seen.some((q) => q.drawer_slide === 0.25)", timeout=60_000)
    seen = tab.page.evaluate("seen")
    assert all(q["door_hinge"] > 1.7 for q in seen if q["drawer_slide"] > 0.01)
    tab.page.evaluate("delete artgen.update")
    tab.page.click("#closed")
    assert positions(tab)["drawer_slide"] == 0.0


@pytest.mark.parametrize("symbol", some(["colliders", "joints", "grasps", "masses", "labels"], 3))
def test_an_overlay_is_shown_and_hidden_again(tab: Tab, symbol: str) -> None:
    tab.page.click("#open")
    before = stage(tab)
    tab.page.check(f"[data-symbol={symbol}]")
    assert changed(before, stage(tab)) > 0.0002
    if symbol == "labels":
        assert tab.page.inner_text("#legend").split() == ["case", "dial", "door", "drawer"]
    else:
        assert tab.page.evaluate(f"artgen.symbols.groups.{symbol}.visible")
    tab.page.uncheck(f"[data-symbol={symbol}]")
    assert changed(before, stage(tab)) < 0.0001
    assert tab.page.is_hidden("#legend")


def test_signs_stand_where_the_asset_stands(tab: Tab, asset: Asset) -> None:
    for symbol in ("colliders", "joints", "masses"):
        tab.page.check(f"[data-symbol={symbol}]")
    drag(tab, "door_hinge", 0.9)
    q = {"door_hinge": positions(tab)["door_hinge"]}
    script = """(what) => artgen.symbols.groups[what.group].children
        .find(({ userData }) => what.link ? userData.link === what.link
            : userData.joint.name === what.joint && Boolean(userData.turns) === what.turns).matrix.elements"""
    pose = asset.pose(q)["door"]
    for what in (
        {"group": "colliders", "link": "door"},
        {"group": "joints", "joint": "door_hinge", "turns": True},
    ):
        assert np.abs(np.array(tab.page.evaluate(script, what)).reshape(4, 4).T - pose).max() < CLOSE
    still = tab.page.evaluate(script, {"group": "joints", "joint": "door_hinge", "turns": False})
    assert np.abs(np.array(still).reshape(4, 4).T - np.eye(4)).max() < CLOSE
    center = tab.page.evaluate("artgen.symbols.center().toArray()")
    moved = asset.pose(q)
    masses = [
        (link.mass_properties.mass, link.mass_properties.center, moved[link.name]) for link in asset.links
    ]
    expected = sum(mass * (pose[:3, :3] @ at + pose[:3, 3]) for mass, at, pose in masses) / asset.mass
    assert np.abs(np.array(center) - expected).max() < 1e-4
    for symbol in ("colliders", "joints", "masses"):
        tab.page.uncheck(f"[data-symbol={symbol}]")


@pytest.mark.long
def test_the_exploded_view_moves_links_apart_and_back(tab: Tab, asset: Asset) -> None:
    slider = tab.page.locator("#apart")
    slider.press("End")
    for name, shift in exploded(asset).items():
        assert np.abs(world(tab, name)[:3, 3] - shift).max() < 1e-4, name
    assert changed(stage(tab), stage(tab)) == 0.0
    slider.press("Home")
    assert np.abs(world(tab, "drawer") - np.eye(4)).max() < CLOSE


def test_the_certificate_shows_its_narrowest_pose_by_one_click(tab: Tab, asset: Asset) -> None:
    certificate = asset.certify(measure=True)
    assert "proven" in tab.page.inner_text("#verdict")
    assert f"{len(certificate.pairs)} pairs of links never collide" in tab.page.inner_text("#verdict")
    tab.page.click("#worst")
    worst = certificate.clearance
    assert worst is not None
    assert tab.page.evaluate("artgen.q") == pytest.approx(dict(worst.found_at))
    assert tab.page.evaluate("artgen.highlighted") == list(worst.links)
    assert tab.page.inner_text("#tip") == str(worst)
    tab.page.click("#closed")
    assert tab.page.is_hidden("#tip")


def test_poses_of_the_certificate_are_such_as_dependencies_allow() -> None:
    """A pair's pose says nothing of the joints of others, which its own may need."""
    fridge = artgen.generate("refrigerator", seed=3)
    certificate = fridge.certify(measure=True)
    assert any(fridge.blocked(pair.found_at) for pair in certificate.pairs)
    pairs = viewer_data(fridge)["certificate"]["pairs"]
    assert len(pairs) == len(certificate.pairs)
    for pair in pairs:
        assert fridge.blocked(pair["pose"]) == (), pair["links"]
        (proven,) = [each for each in certificate.pairs if list(each.links) == pair["links"]]
        assert {name: pair["pose"][name] for name in proven.found_at} == dict(proven.found_at)


def test_a_click_tells_of_the_part(tab: Tab) -> None:
    box = tab.page.locator("#canvas").bounding_box()
    tab.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    link, label, *_ = tab.page.inner_text("#tip").split(" · ")
    assert link == label == "door"
    assert tab.page.evaluate("artgen.highlighted") == ["door"]


def test_dragging_turns_the_camera_and_reset_brings_it_back(tab: Tab) -> None:
    before = stage(tab)
    box = tab.page.locator("#canvas").bounding_box()
    tab.page.mouse.move(box["x"] + 200, box["y"] + 100)
    tab.page.mouse.down()
    tab.page.mouse.move(box["x"] + 320, box["y"] + 130, steps=2)
    tab.page.mouse.up()
    tab.page.mouse.wheel(0, 400)
    assert changed(before, stage(tab)) > 0.05
    assert tab.page.is_hidden("#tip")
    tab.page.click("#home")
    assert changed(before, stage(tab)) < 0.0001


def test_keys_walk_through_a_room_at_eye_height(browser: Browser, tmp_path: Path) -> None:
    room = Scene("room", seed=1, width=3.0, depth=2.4, detail="low")
    room.run("back", "drawer", at=0.4)
    path = room.build().show(textures=0).save(tmp_path / "room.html")
    with browser.tab(640, 420, offline=True) as tab:
        page = ready(tab.open(path)).page
        eye = "[...artgen.studio.camera.position.toArray(), artgen.studio.camera.fov]"
        outside = np.array(page.evaluate(eye))
        way = []
        for key in ("ArrowRight", "w", "a", "s", "d"):
            page.keyboard.press(key)
            way.append(page.evaluate(eye))
        steps = np.diff(way, axis=0)
        assert np.allclose(np.linalg.norm(steps, axis=1), 0.12, atol=1e-6)
        assert np.allclose(steps[:2] + steps[2:], 0.0, atol=1e-6)  # back by the same way
        assert abs(steps[0] @ steps[1]) < 1e-6
        floor = page.evaluate("artgen.orbit.box.min.y")
        assert np.allclose(np.array(way)[:, 1], floor + 1.6, atol=1e-6)
        for _ in range(40):
            page.keyboard.press("w")
        assert page.evaluate("artgen.orbit.box.containsPoint(artgen.orbit.target)")
        page.click("#home")
        assert np.allclose(page.evaluate(eye), outside, atol=1e-6)
        assert tab.problems == []


def test_the_panel_tells_of_parameters_and_masses(tab: Tab, asset: Asset) -> None:
    text = tab.page.text_content("#panel")
    assert f"{asset.parameters['width']:.5g}" in text
    assert asset.parameters["finish"] in text
    assert "locker · seed 1" in text
    assert f"{asset.link('case').mass_properties.mass:.4g} kg" in text


@pytest.mark.parametrize("name", ["box", "microwave", "plier"])
def test_positions_poses_and_what_is_blocked_are_those_of_python(tab: Tab, name: str) -> None:
    other = artgen.generate(name, seed=3, certify=False)
    data = viewer_data(other)
    draw = np.random.default_rng(0)
    poses = [
        {
            joint.name: float(draw.uniform(*(joint.limits or (-math.pi, math.pi))))
            * float(draw.random() < 0.6)
            for joint in other.free_joints
            if joint.limits is None or joint.limits[0] <= 0.0 <= joint.limits[1]
        }
        for _ in range(40)
    ]
    found = tab.page.evaluate(
        """([data, poses]) => {
            const kinematics = new artgen.kinematics.constructor(data);
            return poses.map((q) => ({
                positions: kinematics.positions(q),
                blocked: kinematics.blocked(q).map((joint) => joint.name),
                poses: Object.fromEntries(Object.entries(kinematics.poses(q).links)
                    .map(([link, matrix]) => [link, matrix.elements])),
            }));
        }""",
        [json.loads(json.dumps(data)), poses],
    )
    assert any(each["blocked"] for each in found) or not any(joint.needs for joint in other.joints)
    for q, each in zip(poses, found, strict=True):
        assert each["positions"] == pytest.approx(other.positions(q), abs=1e-12)
        assert tuple(each["blocked"]) == other.blocked(q)
        for link, pose in other.pose(q).items():
            assert np.abs(np.array(each["poses"][link]).reshape(4, 4).T - pose).max() < CLOSE


@pytest.mark.parametrize("name", ["microwave", "coffee_machine", "lamp", "range_hood"])
def test_outputs_over_time_are_those_of_python(tab: Tab, name: str) -> None:
    other = artgen.generate(name, seed=3, certify=False)
    outputs = viewer_data(other)["outputs"]
    ends = [(joint.closed, joint.opened) for joint in map(other.joint, other.dof_names)]
    rows = np.array([np.random.default_rng(number).choice(each, 300) for number, each in enumerate(ends)]).T
    poses = [other.positions(dict(zip(other.dof_names, row.tolist(), strict=True))) for row in rows]
    found = tab.page.evaluate(
        """([outputs, poses]) => {
            const controller = new artgen.controller.constructor(outputs);
            return poses.map((positions) => controller.step(positions, 0.7));
        }""",
        [json.loads(json.dumps(outputs)), poses],
    )
    controller = other.controller()
    seen = [{key: float(value[0]) for key, value in controller.step(row, 0.7).items()} for row in rows]
    assert {key for each in seen for key, value in each.items() if value > 0.5} == set(seen[0])
    for expected, each in zip(seen, found, strict=True):
        assert each == pytest.approx(expected, abs=1e-12)


def test_a_pressed_switch_lights_the_lamp(browser: Browser, tmp_path: Path) -> None:
    path = artgen.generate("lamp", seed=9).show(textures=0).save(tmp_path / "lamp.html")
    with browser.tab(640, 420, offline=True) as tab:
        ready(tab.open(path))
        value = tab.page.locator("[data-output=light]")
        bulb = """() => [...artgen.model.meshes()].map((mesh) => mesh.material)
            .find((material) => material.name === "bulb").emissive.toArray()"""
        assert (value.text_content(), tab.page.evaluate(bulb)) == ("off", [0, 0, 0])
        tab.page.evaluate("() => artgen.move('switch_slide', 0.003)")
        assert (value.text_content(), tab.page.evaluate(bulb)) == ("on", pytest.approx([1.0, 0.84, 0.62]))
        tab.page.evaluate("() => artgen.move('switch_slide', 0)")
        assert value.text_content() == "on", "it is toggled"
        tab.page.evaluate("() => artgen.move('switch_slide', 0.003)")
        assert (value.text_content(), tab.page.evaluate(bulb)) == ("off", [0, 0, 0])
        assert tab.problems == []


def test_a_collision_is_shown_where_it_is(browser: Browser, tmp_path: Path) -> None:
    # named like one of its links, which must not confuse the reader of the GLB
    bad, _ = clash.evaluate(0, name="flap", on_collision="keep")
    (pair,) = bad.certificate.failures
    with browser.tab(640, 420, offline=True) as tab:
        ready(tab.open(bad.show(textures=0).save(tmp_path / "clash.html")))
        assert tab.page.inner_text("#verdict .badge") == "not proven"
        tab.page.click("#worst")
        assert tab.page.evaluate("artgen.q") == pytest.approx(dict(pair.witness.pose))
        assert tab.page.evaluate("artgen.symbols.place.position.toArray()") == pytest.approx(
            list(pair.witness.place)
        )
        assert tab.page.inner_text("#tip") == str(pair)
        assert tab.problems == []


def test_a_notebook_shows_it(browser: Browser, tmp_path: Path) -> None:
    shown = clash.generate(seed=0, certify=False).show(textures=0, height=400)
    cell = tmp_path / "notebook.html"
    cell.write_text(f"<!doctype html><title>cell</title><link rel=icon href=data:,>{shown._repr_html_()}")
    with browser.tab(640, 420, offline=True) as tab:
        tab.open(cell)
        frame = tab.page.frames[1]
        frame.wait_for_function("window.artgen", timeout=60_000)
        assert tab.page.locator("iframe").bounding_box()["height"] == 400
        assert frame.inner_text("#panel .badge") == "not certified"
        assert tab.problems == []
    assert repr(shown).startswith("<Page of clash_0: ")


def test_a_browser_without_webgl_is_told_so(browser: Browser, tmp_path: Path) -> None:
    path = clash.generate(seed=0, certify=False).show(textures=0).save(tmp_path / "clash.html")
    with browser.tab(640, 420, offline=True) as tab:
        tab.page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
        tab.open(path)
        tab.page.wait_for_selector("#message.fault")
        text = tab.page.inner_text("#message")
        assert text.startswith("This page cannot be shown: ")
        assert "needs a browser with WebGL" in text


def test_a_textured_refrigerator_is_small() -> None:
    fridge = artgen.generate("refrigerator", seed=1, certify=False)
    assert any(each.texture for each in fridge.materials)
    assert len(page_of(fridge).html.encode()) < 3_000_000


@pytest.mark.parametrize("name", ["refrigerator", "door", "drawer"])
def test_boxes_of_what_hangs_together_do_not_overlap_when_exploded(name: str) -> None:
    asset = artgen.generate(name, seed=2, certify=False)
    shifts = exploded(asset)
    assert set(shifts) == {link.name for link in asset.links}
    for parent, child, _ in asset.pairs():
        (low, high), (other_low, other_high) = (
            asset.link(each).bounds() + shifts[each] for each in (parent, child)
        )
        assert ((low >= other_high - CLOSE) | (high <= other_low + CLOSE)).any(), child


def test_the_command_writes_a_page_and_opens_it(
    artgen_command: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    asked: list[str] = []
    monkeypatch.setattr("webbrowser.open", lambda address: asked.append(address) or True)
    done = artgen_command("view", "plier", "--seed", "2", "--texture-size", "0")
    assert (done.code, done.out, done.err) == (0, "plier_2.html\n", "")
    assert asked == [(tmp_path / "plier_2.html").as_uri()]
    assert '<script type="text/plain" id="three">' in (tmp_path / "plier_2.html").read_text(encoding="utf-8")
    artgen.generate("plier", seed=2).export(tmp_path / "stored", formats=("mjcf",), textures=0)
    monkeypatch.setattr("webbrowser.open", lambda address: False)
    done = artgen_command("view", "stored", "--out", "other.html")
    assert done.code == 0
    assert done.err == "note: there is no browser here; open other.html in one\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("plier", "--out", "x.png"), "error: cannot write x.png: give a file whose name ends in .html\n"),
        (
            ("plier", "--out", "no/x.html"),
            "error: cannot write no/x.html: give a file in a directory that exists\n",
        ),
        (
            ("plierr",),
            (
                "error: there is no category 'plierr' and no folder of that name; give a folder that artgen "
                "exported, the Python file of a category, such as stapler.py, or a category or room that "
                "`artgen list` shows. Did you mean 'plier'?\n"
            ),
        ),
        (
            ("plier", "--texture-size", "3"),
            "error: textures have 256, 512, 1024, 2048 texels on a side, not 3; 0 gives plain colors\n",
        ),
        (
            (".", "--set", "length=1"),
            "error: --set is for categories, but . is an exported asset; leave --set out\n",
        ),
    ],
)
def test_wrong_arguments_give_one_clear_error(artgen_command: Any, arguments: Any, message: str) -> None:
    done = artgen_command("view", *arguments, "--no-open")
    assert (done.code, done.out, done.err) == (2, "", message)
    assert list(Path().iterdir()) == []


def test_another_trimesh_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page, "_OWN_VIEWER", "something else")
    page.three_js.cache_clear()
    with pytest.raises(artgen.ArtgenError, match=r"the viewer needs the three\.js that comes with trimesh"):
        page.three_js()
    page.three_js.cache_clear()
