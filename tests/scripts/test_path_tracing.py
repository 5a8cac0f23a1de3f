"""Path-traced pictures: content, texture maps, and errors."""

import importlib.util
import math
import sys
from types import SimpleNamespace

import numpy as np
import path_tracing
import pytest
from path_tracing import load_mitsuba, render_mitsuba, usable_llvm
from path_tracing.film import denoised, displayed, tone_mapped

from artgen import Revolute, Z, box, material, part
from artgen.asset.surface import texture_coordinates
from artgen.errors import AssetError, ParameterError, RenderError
from artgen.view.camera import View
from support.proof_fridges import evaluated
from support.textured import BOARD, QUADRANTS, recipes

needs_mitsuba = pytest.mark.skipif(
    importlib.util.find_spec("mitsuba") is None,
    reason='the package mitsuba is not installed: pip install "artgen[render]"',
)
RED = material("abs").with_(name="red", base_color=(0.6, 0.03, 0.03))
CLEAR = material("glass").with_(name="clear", transmission_weight=1.0, base_color=(0.95, 0.95, 0.95))
WOOD = material("oak").with_(name="wood", texture="")
FRONT = View(0.0, 0.1)


@pytest.fixture(autouse=True)
def _scalar() -> None:
    """Draw without LLVM, whose compilation takes longer than small pictures."""
    if importlib.util.find_spec("mitsuba") is not None:
        import mitsuba

        mitsuba.set_variant("scalar_rgb")


def drawn(asset, q=None, *, camera=FRONT, size=64, samples=8, **options):
    return render_mitsuba(asset, q, camera=camera, size=size, samples=samples, **options).astype(int)


def redness(picture):
    return picture[..., 0] - picture[..., 1:].max(axis=-1)


def block():
    return evaluated(part(box(0.3, 0.3, 0.3).at(z=0.15), "block", RED), "block")


def behind(pane):
    """Return a red block 0.1 m behind a pane that covers it completely."""
    body = part(box(0.3, 0.1, 0.3).at(0.0, 0.3, 0.15), "block", RED)
    leaf = part(box(0.5, 0.01, 0.5).at(0.0, 0.0, 0.25), "pane", pane)
    return evaluated(
        body.attach(leaf, Revolute("swing", pivot=(-0.25, 0, 0), axis=Z, limits=(-2.0, 0.0))), "pane"
    )


@needs_mitsuba
def test_the_asset_is_in_the_middle_of_a_neutral_backdrop() -> None:
    picture = drawn(block(), size=(96, 64))
    assert picture.shape == (64, 96, 3)
    mask = redness(picture) > 40
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    assert rows[-1] - rows[0] >= 0.6 * 64
    assert abs((columns[0] + columns[-1]) / 2 - 47.5) < 3
    backdrop = picture[4:40, 2:12].reshape(-1, 3)
    assert (backdrop.max(axis=1) - backdrop.min(axis=1)).mean() < 14
    assert 100 < backdrop.mean() < 250


@needs_mitsuba
@pytest.mark.skipif(not usable_llvm(), reason="no LLVM library from version 16 on: apt install libllvm19")
def test_llvm_and_scalar_code_draw_the_same(monkeypatch) -> None:
    import mitsuba

    plain = drawn(block(), size=24)
    monkeypatch.setenv("DRJIT_LIBLLVM_PATH", usable_llvm())
    mitsuba.set_variant("llvm_ad_rgb")
    # each picture has noise of its own
    assert abs((drawn(block(), size=24) - plain).mean(axis=(0, 1))).max() < 10


@needs_mitsuba
def test_light_passes_glass_and_nothing_else() -> None:
    through = {pane.name: redness(drawn(behind(pane)))[28:40, 26:38].mean() for pane in (CLEAR, WOOD)}
    assert through["clear"] > 40
    assert through["wood"] < 0.8 * through["clear"]
    frosted = redness(drawn(behind(CLEAR.with_(name="frosted", specular_roughness=0.5))))
    assert frosted[28:40, 26:38].mean() > 10


@needs_mitsuba
def test_joint_positions_move_links() -> None:
    asset = behind(WOOD)
    closed, opened = (redness(drawn(asset, q, textures=0)) > 60 for q in (None, {"swing": -1.6}))
    assert opened.sum() > closed.sum() + 100


@needs_mitsuba
def test_emission_is_brighter_than_paper() -> None:
    lamp = RED.with_(name="lamp", base_color=(0.01, 0.01, 0.01), emission=(0.1, 1.0, 0.1))
    picture = drawn(evaluated(part(box(0.3, 0.3, 0.3).at(z=0.15), "lamp", lamp), "lamp"))
    assert picture[32, 32, 1] > 240


@needs_mitsuba
def test_maps_follow_the_texture_coordinates() -> None:
    with recipes():
        asset = evaluated(part(box(0.5, 0.05, 0.5).at(z=0.25), "board", BOARD), "board")
        (surface,) = asset.links[0].surfaces
        mesh, coordinates = surface.mesh, texture_coordinates(surface.mesh, BOARD)
        camera = View(0.0, 0.0).camera(mesh.vertices)
        picture = drawn(asset, camera=camera, size=128, samples=16, textures=256)
        corners = mesh.triangles[(mesh.normals[mesh.triangles][..., 1] < -0.999).all(axis=1)]
        stream = np.random.default_rng(0)
        checked = set()
        for weights in stream.dirichlet(np.ones(3), 300):
            vertices = corners[stream.integers(len(corners))]
            u, v = (weights @ coordinates[vertices]) % 1.0
            if (
                min(abs(u - edge) for edge in (0, 0.5, 1)) < 0.1
                or min(abs(v - edge) for edge in (0, 0.5, 1)) < 0.1
            ):
                continue
            row, column = int(v < 0.5), int(u >= 0.5)
            if (row, column) == (1, 1):  # grey
                continue
            ((x, y),) = camera.pixels(weights @ mesh.vertices[vertices][None], (128, 128))
            tinted = QUADRANTS[row, column] * BOARD.base_color
            assert picture[int(y), int(x)].argmax() == tinted.argmax(), (u, v)
            checked.add((row, column))
        assert checked == {(0, 0), (0, 1), (1, 0)}


@needs_mitsuba
@pytest.mark.parametrize("studio", ["room", "doorway"])
@pytest.mark.parametrize("azimuth", [0.5, math.pi - 0.5])
def test_rooms_have_a_wall_that_does_not_hide_the_asset(studio, azimuth) -> None:
    picture = drawn(behind(RED), camera=View(azimuth, 0.2), size=48, samples=4, studio=studio)
    assert (redness(picture) > 40).mean() > 0.15
    assert picture[:6].mean() > 60  # the wall, where a scene without one shows a dark sky


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"size": 0}, "0 x 0 pixels"),
        ({"size": (64, -1)}, "64 x -1 pixels"),
        ({"samples": 0}, "0 samples"),
        ({"studio": "studoi"}, "Did you mean 'studio'"),
        ({"textures": 300}, "not 300"),
    ],
)
def test_impossible_pictures_are_errors(options, message) -> None:
    with pytest.raises(ParameterError, match=message):
        render_mitsuba(block(), **options)


@needs_mitsuba
def test_unknown_joints_and_views_are_errors() -> None:
    with pytest.raises(AssetError, match="no joint 'swimg'"):
        render_mitsuba(behind(CLEAR), {"swimg": 0.0})
    with pytest.raises(ParameterError, match="no view 'frnt'"):
        render_mitsuba(block(), camera="frnt")


def test_the_error_for_a_missing_package_names_its_extra(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    with pytest.raises(RenderError, match=r'mitsuba, which is not installed; pip install "artgen\[render\]"'):
        render_mitsuba(block())
    with pytest.raises(RenderError):
        load_mitsuba()


def test_an_llvm_that_aborts_is_never_chosen(monkeypatch, tmp_path) -> None:
    for version, usable in ((14, False), (15, False), (16, True), (19, True)):
        library = tmp_path / f"libLLVM-{version}.so"
        library.touch()
        monkeypatch.setenv("DRJIT_LIBLLVM_PATH", str(library))
        assert usable_llvm() == (str(library) if usable else "")
    monkeypatch.delenv("DRJIT_LIBLLVM_PATH")
    assert "LLVM-15" not in usable_llvm()


def test_a_missing_llvm_is_named_before_it_costs_time(monkeypatch) -> None:
    chosen: list[str] = []
    plain = SimpleNamespace(variant=lambda: None, set_variant=chosen.append)
    monkeypatch.setitem(sys.modules, "mitsuba", plain)
    monkeypatch.setattr(path_tracing, "usable_llvm", lambda: "")
    with pytest.warns(UserWarning, match="many times as slow without it: apt install libllvm19"):
        load_mitsuba()
    assert chosen == ["scalar_rgb"]


def test_a_picture_without_the_denoiser_is_unchanged(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "oidn", None)
    pixels = np.random.default_rng(0).random((8, 8, 3)).astype(np.float32)
    assert denoised(pixels, pixels, pixels) is pixels


def test_tones_keep_their_order_and_ordinary_colors() -> None:
    grey = np.repeat(np.geomspace(1e-4, 100.0, 400)[None, :, None], 3, axis=2).astype(np.float32)
    mapped = tone_mapped(grey)
    assert (np.diff(mapped[0, :, 0]) > 0).all()
    assert mapped.min() >= 0.0
    assert mapped.max() <= 1.0
    ordinary = np.array([[[0.6, 0.3, 0.15], [0.5, 0.5, 0.5]]], np.float32)
    assert abs(tone_mapped(ordinary) - ordinary).max() < 0.03
    assert (tone_mapped(np.array([[[np.inf, np.nan, -1.0]]], np.float32)) == 0.0).all()


def test_middle_grey_is_displayed_as_srgb_encodes_it() -> None:
    assert displayed(np.array([0.0, 0.2140, 1.0, 7.0], np.float32)).tolist() == [0, 127, 255, 255]
