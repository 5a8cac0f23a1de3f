"""Pictures: that they show what is there, and that every pixel's label, depth and normal is true."""

import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

import artgen
from artgen.asset import Asset
from artgen.errors import AssetError, ExportError, ParameterError
from artgen.generator import generator
from artgen.materials import material
from artgen.nodes.body import part, weld
from artgen.nodes.handles import Body
from artgen.nodes.primitive import box
from artgen.view import Camera, RenderError, View, gl, opened, shading
from artgen.view.picture import Picture
from artgen.view.tracing import cast

pytest.importorskip("embreex", reason="needs Embree: artgen[sim]")


def picture(asset: Asset, q=None, **arguments) -> Picture:
    return asset.render(q, **{"size": 128, "textures": 0} | arguments)


def mean(shown: Picture, mask) -> np.ndarray:
    inside = ndimage.binary_erosion(mask, iterations=2)
    assert inside.sum() > 20
    return shown.color[inside].mean(axis=0)


def test_the_asset_fills_the_picture_and_the_background_is_neutral(red_cabinet) -> None:
    shown = picture(red_cabinet, size=(160, 120))
    assert shown.color.shape == (120, 160, 3)
    seen = shown.links.ids > 0
    rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
    filled = (np.ptp(rows) + 1) / 120, (np.ptp(columns) + 1) / 160
    assert max(filled) >= 0.85
    assert not np.concatenate([seen[0], seen[-1], seen[:, 0], seen[:, -1]]).any()
    around = shown.color[~ndimage.binary_dilation(seen, iterations=8)].astype(int)
    assert np.ptp(around, axis=1).max() <= 10  # the red door lights the floor a little
    assert around.mean() > 180


def test_colors_are_those_of_the_materials(red_cabinet) -> None:
    shown = picture(red_cabinet, camera="front")
    red, green, blue = mean(shown, shown.labels.mask("door"))
    assert red > 2.0 * green
    assert red > 2.0 * blue
    red, green, blue = mean(shown, shown.labels.mask("drawer"))
    assert blue > 2.0 * red
    white = mean(shown, shown.labels.mask("body"))
    assert np.ptp(white) < 25
    assert white.mean() > 120


def test_glass_shows_what_is_behind(glass_cabinet, red_cabinet) -> None:
    shown = picture(glass_cabinet, camera="front")
    behind = ndimage.binary_erosion(shown.labels.mask("door"), iterations=20)
    red, _, blue = shown.color[behind].mean(axis=0)
    assert blue > red + 15  # the blue inside
    red, _, blue = picture(red_cabinet, camera="front").color[behind].mean(axis=0)
    assert red > blue + 25


def test_positions_move_pixels_and_open_what_they_say(red_cabinet) -> None:
    closed, open_ = (picture(red_cabinet, {"door_hinge": q}, camera="front") for q in (0.0, 1.2))
    assert not closed.labels.mask("inside").any()
    assert open_.labels.mask("inside").sum() > 50
    alike = (np.abs(closed.color.astype(int) - open_.color) < 4).all(axis=2).mean()
    assert alike < 0.9


def test_shadows_lie_on_the_floor_of_the_studio_only(red_cabinet) -> None:
    seen = ndimage.binary_dilation(picture(red_cabinet).links.ids > 0, iterations=3)
    studio, none = (picture(red_cabinet, studio=studio).color[~seen] for studio in ("studio", "none"))
    assert np.ptp(studio.mean(axis=1)) > 25
    assert none.min() >= 248


def test_a_room_has_a_wooden_floor_and_a_wall_behind_the_asset(red_cabinet) -> None:
    for view in ("three_quarter", "three_quarter_back"):
        color = picture(red_cabinet, studio="room", camera=view).color.astype(int)
        floor, wall = color[-4, 4], color[4, 4]
        assert floor[0] > floor[2] + 30
        assert np.ptp(wall) < 25


def test_the_same_picture_comes_again(red_cabinet) -> None:
    first = picture(red_cabinet).color
    picture(red_cabinet, {"door_hinge": 1.0}, camera="back")
    np.testing.assert_array_equal(picture(red_cabinet).color, first)


def test_chrome_mirrors_light_and_dark(red_cabinet) -> None:
    shown = picture(red_cabinet, camera=View(-0.5, 0.3, link="door", margin=0.0), size=256)
    knob = ndimage.binary_erosion(shown.labels.mask("knob"))
    light = shown.color[knob].mean(axis=1)
    assert np.ptp(np.percentile(light, (2, 98))) > 40


@generator
def board(*, lacquered: bool = False) -> Body:
    black = material("black_abs").with_(
        name="black", texture="", specular_roughness=0.9, coat_weight=float(lacquered), coat_roughness=0.02
    )
    return part(box(0.3, 0.3, 0.02), "board", black)


def test_a_clear_lacquer_mirrors_the_lamps() -> None:
    top = View(2.2, 0.75, margin=0.2)
    dull, glossy = (
        picture(board.generate(lacquered=each), camera=top).color.astype(float) for each in (False, True)
    )
    gain = (glossy - dull).max(axis=2)
    assert np.percentile(gain, 99) > 12
    assert gain.min() > -4


def test_a_wire_thinner_than_a_pixel_is_an_even_line() -> None:
    @generator
    def wire() -> Body:
        black = material("black_abs").with_(name="black", texture="", specular_roughness=0.9)
        glowing = material("led_white").with_(name="glowing", texture="", emission=(0.2, 0.2, 0.2))
        board = part(box(0.3, 0.3, 0.02), "board", black)
        return weld(board, part(box(0.28, 0.0008, 0.001).at(0, 0, 0.0105), "wire", glowing))

    shown = picture(wire.generate(), camera=View(0.3, 1.2))
    along = np.column_stack([np.linspace(-0.12, 0.12, 200), np.zeros(200), np.full(200, 0.011)])
    columns, rows = np.floor(shown.camera.pixels(along, (128, 128))).astype(int).T
    light = shown.color.mean(axis=2) - np.median(shown.color[shown.labels.mask("board")])
    seen = np.unique(np.column_stack([columns, rows]), axis=0)
    line = np.array([light[row - 2 : row + 3, column].sum() for column, row in seen])
    assert line.min() > 0.5 * np.median(line), "the line has gaps"
    assert line.std() < 0.25 * line.mean(), "the line has dots"


@pytest.mark.parametrize(
    ("bevel", "metal", "view"),
    [(0.0004, "steel", View(-0.6, 0.4)), (0.001, "brass", View(-0.6, 0.4)), (0.001, "brass", View(0.4, 0.3))],
)
def test_a_bevel_narrower_than_a_pixel_has_no_dots(bevel: float, metal: str, view: View) -> None:
    @generator
    def block() -> Body:
        return part(box(0.2, 0.2, 0.1, bevel=bevel), "block", material(metal).with_(texture=""))

    shown = picture(block.generate(), camera=view, size=192)
    edge = np.array([(x, -0.1, 0.05) for x in np.linspace(-0.09, 0.09, 400)])
    columns, rows = np.floor(shown.camera.pixels(edge, (192, 192))).astype(int).T
    light = shown.color.mean(axis=2)
    peaks = [light[row - 1 : row + 2, column].max() for column, row in zip(columns, rows, strict=True)]
    assert np.abs(np.diff(peaks)).max() < 30.0


def test_ledges_narrower_than_a_pixel_have_no_dots_in_the_shade() -> None:
    @generator
    def panel() -> Body:
        leaf = box(0.9, 0.04, 1.2) - box(0.6, 0.02, 0.9).at(0, -0.015, 0)
        jambs = box(0.05, 0.24, 1.2).at(-0.47, -0.1, 0) | box(0.05, 0.24, 1.2).at(0.47, -0.1, 0)
        return part(leaf | jambs, "panel", material("painted_wood").with_(texture=""))

    asset, view = panel.generate(), View(-0.6, 0.2)
    few, many = (picture(asset, camera=view, size=192, samples=samples) for samples in (8, 128))
    off = np.abs(few.color.astype(int) - many.color).mean(axis=2)[few.labels.mask("panel")]
    assert np.percentile(off, 99.9) < 8.5, "dots differ from the picture with more rays"


def test_the_floor_has_a_soft_shadow_without_speckles(red_cabinet) -> None:
    shown = picture(red_cabinet, size=256, camera=View(-0.5, 0.5, margin=0.3))
    seen = ndimage.binary_dilation(shown.links.ids > 0, iterations=4)
    light = shown.color.mean(axis=2)
    floor = np.zeros_like(seen)
    floor[100:] = ~seen[100:]
    assert np.ptp(light[floor]) > 50
    rough = np.abs(light - ndimage.median_filter(light, 5))[floor]
    assert np.percentile(rough, 99) < 3.0
    assert rough.max() < 14.0


def test_bands_join_without_a_seam(red_cabinet, monkeypatch) -> None:
    whole = picture(red_cabinet).color
    monkeypatch.setattr(shading, "_BAND", 48)
    np.testing.assert_array_equal(picture(red_cabinet).color, whole)


def test_more_samples_agree_with_few(red_cabinet) -> None:
    few, many = (picture(red_cabinet, samples=samples).color.astype(int) for samples in (8, 64))
    assert np.abs(few - many).mean() < 1.5


@pytest.mark.parametrize("share", [0.0, 1.0])
@pytest.mark.parametrize("size", [(160, 120), (90, 200)])
@pytest.mark.parametrize("view", [View(-0.6, 0.3), View(2.5, -0.2, 0.9), View(0.4, 1.2)])
def test_labels_depth_and_normals_agree_with_rays(red_cabinet, share, size, view) -> None:
    q = opened(red_cabinet, share)
    shown = picture(red_cabinet, q, camera=view, size=size)
    poses = red_cabinet.pose(q)
    surfaces = [(link, surface) for link in red_cabinet.links for surface in link.surfaces]
    meshes = [surface.mesh.moved(poses[link.name]) for link, surface in surfaces]
    stream = np.random.default_rng(0)
    row, column = stream.integers(0, size[1], 1000), stream.integers(0, size[0], 1000)
    hits = cast(meshes, np.array(shown.camera.position), shown.camera.rays(size)[row, column])
    links = np.array(["", *(link.name for link, _ in surfaces)])[hits.surfaces]
    labels = np.array(["", *(surface.label for _, surface in surfaces)])[hits.surfaces]
    # at a silhouette the center of a pixel may fall to either side
    edge = np.zeros(shown.depth.shape, bool)
    for ids in (shown.links.ids, shown.labels.ids):
        edge |= ndimage.maximum_filter(ids, 3) != ndimage.minimum_filter(ids, 3)
    sure = ~edge[row, column]
    assert sure.sum() > 500
    np.testing.assert_array_equal(
        np.array(shown.links.names)[shown.links.ids[row, column]][sure], links[sure]
    )
    np.testing.assert_array_equal(
        np.array(shown.labels.names)[shown.labels.ids[row, column]][sure], labels[sure]
    )
    depth, distance = shown.depth[row, column][sure], hits.distance[sure]
    seen = np.isfinite(distance)
    np.testing.assert_array_equal(np.isfinite(depth), seen)
    error = np.abs(depth[seen] - distance[seen])
    assert np.median(error) < 1e-4
    assert (error < 2e-3).mean() > 0.99  # an edge may lie within one label
    np.testing.assert_allclose(shown.normals[row, column], hits.normals, atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(shown.normals[row, column][sure][seen], axis=1), 1.0, atol=1e-6)


def test_normals_point_to_the_camera_and_turn_with_the_door(red_cabinet) -> None:
    angle = 0.7
    shown = picture(red_cabinet, {"door_hinge": angle}, camera="front")
    toward = (shown.normals * shown.camera.rays((128, 128))).sum(axis=2)
    assert toward[shown.links.ids > 0].max() < 1e-6
    front = np.array([-np.sin(angle), -np.cos(angle), 0.0])
    door = shown.normals[shown.labels.mask("door")]
    assert (np.linalg.norm(door - front, axis=1) < 1e-6).mean() > 0.6


def test_unknown_masks_are_named(red_cabinet) -> None:
    shown = picture(red_cabinet)
    with pytest.raises(AssetError, match=r"nothing in the picture is named 'dor'. Did you mean 'door'?"):
        shown.links.mask("dor")


def test_a_loaded_asset_looks_the_same(red_cabinet, tmp_path) -> None:
    loaded = artgen.Asset.load(red_cabinet.export(tmp_path / "cabinet", formats=("urdf",)))
    first, second = picture(red_cabinet), picture(loaded)
    assert np.abs(first.color.astype(int) - second.color).mean() < 1.0
    assert (first.labels.ids > 0).sum() == pytest.approx((second.labels.ids > 0).sum(), rel=0.01)


def test_pictures_are_saved(red_cabinet, tmp_path) -> None:
    shown = picture(red_cabinet, size=64, samples=np.int64(2))
    with Image.open(shown.save(tmp_path / "a.png")) as image:
        np.testing.assert_array_equal(np.asarray(image), shown.color)
    with Image.open(shown.save(tmp_path / "a.jpg")) as image:
        assert image.format == "JPEG"
    with pytest.raises(ExportError, match=r"a picture's name ends in .png, .jpg, .jpeg"):
        shown.save(tmp_path / "a.gif")
    with pytest.raises(ExportError, match=r"cannot write .*: No such file or directory"):
        shown.save(tmp_path / "none" / "a.png")
    with pytest.raises(ParameterError, match=r"path = None is not allowed: give a path, such as 'out/door'"):
        shown.save(None)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"size": 8}, "size 8 must be one or two whole numbers in 16..4096"),
        ({"size": (64, 64, 64)}, "must be one or two whole numbers"),
        ({"size": 64.5}, "must be one or two whole numbers"),
        ({"size": True}, "must be one or two whole numbers"),
        ({"studio": "studo"}, "there is no studio 'studo'. Did you mean 'studio'?"),
        ({"samples": 0}, "samples 0 must be a whole number of at least 1"),
        ({"samples": 4097}, "samples 4097 must be a whole number of at least 1 and at most 4096"),
        ({"textures": 100}, "textures have 256"),
        ({"textures": None}, "textures have 256.* not None"),
        ({"camera": 5}, "camera 5 must be a Camera, a View, or the name of a view"),
        ({"camera": "under"}, "there is no view 'under'"),
    ],
)
def test_wrong_arguments_are_refused(red_cabinet, arguments, message) -> None:
    with pytest.raises(ParameterError, match=message):
        red_cabinet.render(**arguments)


def test_an_unknown_joint_is_named(red_cabinet) -> None:
    with pytest.raises(AssetError, match=r"has no joint 'door_hing'. Did you mean 'door_hinge'?"):
        red_cabinet.render({"door_hing": 1.0})


def test_a_camera_of_ones_own_sees_from_where_it_stands(red_cabinet) -> None:
    shown = picture(red_cabinet, camera=Camera((0.0, -2.0, 0.1), (0.0, 0.0, 0.1), 0.6))
    assert shown.labels.names[shown.labels.ids[64, 64]] == "door"
    assert shown.depth[64, 64] == pytest.approx(2.0 - 0.225, abs=1e-4)


def test_missing_libraries_are_named(monkeypatch) -> None:
    monkeypatch.setattr(gl, "_library", lambda name: False)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delenv("MUJOCO_GL", raising=False)
    with pytest.raises(RenderError, match=r"libegl1 .*libosmesa6 .*MUJOCO_GL=osmesa"):
        gl.available()
    monkeypatch.setenv("MUJOCO_GL", "osmesa")
    with pytest.raises(RenderError, match="MUJOCO_GL=osmesa, but its library cannot be loaded"):
        gl.available()
    monkeypatch.setenv("MUJOCO_GL", "disabled")
    with pytest.raises(RenderError, match="disables pictures; unset it"):
        gl.available()


def test_missing_packages_are_named(red_cabinet, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "embreex.mesh_construction", None)
    with pytest.raises(RenderError, match=r'drawn with Embree, .*: pip install "artgen\[sim\]"'):
        picture(red_cabinet)


PROGRAM = """
from artgen import box, generator, material, part, Body
from artgen.materials import material

@generator
def cube() -> Body:
    return part(box(0.1, 0.1, 0.1), "cube", material("oak"))

shown = cube.generate().render(size=32, textures=0)
print(shown.links.mask("cube").sum() > 100)
"""


def test_a_program_that_draws_needs_no_opengl_and_ends_without_a_word(monkeypatch) -> None:
    monkeypatch.setenv("MUJOCO_GL", "disabled")
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", PROGRAM],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "True\n", "")
