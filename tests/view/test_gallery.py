"""The gallery: a page of many assets, in a real Chromium, and what it writes."""

import base64
import json
import shutil
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

import artgen
from artgen.asset.files import exports_in
from artgen.errors import RenderError
from artgen.view import gallery as gallery_module
from artgen.view.gallery import write_gallery
from support.browser import Browser, Tab, started


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two cabinets and a plier, as folders in folders."""
    base = tmp_path_factory.mktemp("some") / "assets of mine"
    for name, seed in (("cabinet", 0), ("cabinet", 2), ("plier", 0)):
        asset = artgen.generate(name, seed=seed, certify=name == "plier")
        asset.export(base / name / asset.name, formats=("mjcf",), textures=0)
    return base


@pytest.fixture(scope="module")
def written(folder: Path) -> Path:
    path, failed = write_gallery(exports_in([folder]), folder, folder.with_name("made"), textures=0)
    assert failed == []
    return path


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with started() as browser:
        yield browser


@pytest.fixture
def tab(browser: Browser, written: Path) -> Iterator[Tab]:
    with browser.tab(800, 600, offline=True) as tab:
        tab.open(written).page.wait_for_selector(".card")
        yield tab
        assert tab.problems == []


def shown(tab: Tab) -> list[str]:
    return tab.page.eval_on_selector_all(".card", "cards => cards.map((card) => card.dataset.name)")


def test_every_asset_has_a_card_with_its_picture(tab: Tab) -> None:
    assert shown(tab) == ["cabinet_0", "cabinet_2", "plier_0"]
    assert tab.page.inner_text("h1") == "assets of mine 3 assets"
    tab.page.wait_for_function("[...document.images].every((image) => image.naturalWidth > 200)")
    assert tab.page.locator(".card[href='assets/plier/plier_0.html'] i").get_attribute("title") == "proven"
    assert tab.page.locator(".card[data-name=cabinet_0] i").get_attribute("title") == "not certified"


def test_filters_leave_what_is_like_that(tab: Tab) -> None:
    tab.page.select_option("#category", "cabinet")
    assert shown(tab) == ["cabinet_0", "cabinet_2"]
    tab.page.select_option("#category", "")
    tab.page.select_option("#joint", "prismatic")
    assert shown(tab) == ["plier_0"]
    tab.page.click("#clear")
    assert len(shown(tab)) == 3
    tab.page.fill("#search", "plier slip")
    assert shown(tab) == ["plier_0"]
    tab.page.fill("#search", "no such thing")
    assert shown(tab) == []
    assert tab.page.inner_text("#none") == "No asset matches these filters."
    assert tab.page.inner_text("#count") == "0 of 3 assets"


def test_parameters_are_filtered_by_range_or_by_value(tab: Tab, folder: Path) -> None:
    parameters = {
        path.name: json.loads((path / "asset.json").read_text())["parameters"]
        for path in exports_in([folder])
    }
    widths = {name: each["width"] for name, each in parameters.items() if name.startswith("cabinet")}
    narrow, wide = sorted(widths, key=widths.get)
    tab.page.select_option("#parameter", "width")
    assert "plier_0" not in shown(tab)
    tab.page.fill("#from", str((widths[narrow] + widths[wide]) / 2))
    assert shown(tab) == [wide]
    tab.page.fill("#from", "")
    tab.page.fill("#to", str((widths[narrow] + widths[wide]) / 2))
    assert shown(tab) == [narrow]
    kind = next(name for name, value in parameters["plier_0"].items() if isinstance(value, str))
    tab.page.select_option("#parameter", kind)
    tab.page.select_option("#value", parameters["plier_0"][kind])
    assert shown(tab) == ["plier_0"]


def test_the_order_is_by_mass(tab: Tab) -> None:
    tab.page.select_option("#order", "mass")
    assert shown(tab)[0] == "plier_0"


def test_a_card_leads_to_the_viewer(tab: Tab) -> None:
    tab.page.click(".card[data-name=plier_0]")
    tab.page.wait_for_function("window.artgen", timeout=60_000)
    assert tab.page.inner_text("h1") == "plier_0"
    assert tab.page.evaluate("artgen.model.links.size") > 1


@pytest.fixture
def no_renderer(monkeypatch: pytest.MonkeyPatch) -> None:
    def render(*_: Any, **__: Any) -> None:
        raise RenderError("no Embree here")

    monkeypatch.setattr(gallery_module, "render", render)


@pytest.mark.usefixtures("no_renderer")
def test_where_nothing_can_draw_the_pictures_are_plain(folder: Path, tmp_path: Path) -> None:
    path, failed = write_gallery([folder / "plier" / "plier_0"], folder, tmp_path / "made", textures=0)
    assert failed == []
    with Image.open(tmp_path / "made" / "assets" / "plier" / "plier_0.jpg") as picture:
        assert picture.size == (256, 256)
    assert not list(tmp_path.rglob("*_open.jpg"))
    data = path.read_text(encoding="utf-8").partition('id="data">')[2].partition("</script>")[0]
    entries = json.loads(zlib.decompress(base64.b64decode(data)))
    assert [entry.get("open") for entry in entries] == [None]


@pytest.mark.usefixtures("no_renderer")
def test_the_command_writes_beside_the_folder_and_leaves_out_what_is_damaged(
    artgen_command: Any, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("webbrowser.open", lambda address: True)
    shutil.copytree(folder / "plier", tmp_path / "many")
    shutil.copytree(folder / "cabinet" / "cabinet_0", tmp_path / "many" / "cabinet_0")
    shutil.rmtree(tmp_path / "many" / "cabinet_0" / "meshes")
    done = artgen_command("gallery", "many", "--texture-size", "0")
    assert done.code == 0
    assert done.out == f"{tmp_path / 'many_gallery' / 'index.html'}\n"
    assert done.err.startswith(f"warning: {tmp_path / 'many' / 'cabinet_0'} is left out: there is no ")
    written = {
        path.relative_to(tmp_path / "many_gallery").as_posix()
        for path in tmp_path.glob("many_gallery/**/*.*")
    }
    assert {"index.html", "assets/plier_0.html", "assets/plier_0.jpg"} <= written
    assert not any("cabinet" in name for name in written)
    again = artgen_command("gallery", "many", "--texture-size", "0", "--no-open")
    assert again.code == 0, again.err


def test_wrong_arguments_give_one_clear_error(artgen_command: Any, folder: Path, tmp_path: Path) -> None:
    def error(*arguments: str) -> str:
        done = artgen_command("gallery", *arguments, "--no-open")
        assert (done.code, done.out) == (2, "")
        return done.err

    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    nothing = error("mine")
    assert nothing.startswith(f"error: '{tmp_path / 'mine'}' holds no exported asset; `artgen generate ")
    assert error(str(folder), "--out", "mine") == (
        "error: mine holds files other than a gallery; choose another --out\n"
    )
    assert error(str(folder), "--texture-size", "7").startswith("error: textures have 256, ")
    assert [path.name for path in (tmp_path / "mine").iterdir()] == ["letter.txt"]
