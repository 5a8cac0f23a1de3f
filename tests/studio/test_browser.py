"""The studio in a real browser: joints and parameters are turned there, and seen to move."""

import re
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from support.browser import Browser, Tab, started

pytest.importorskip("viser", reason='viser is not installed: pip install "artgen[studio]"')

from artgen.studio import Session
from artgen.studio.app import Studio

CRATE = Path(__file__).parent.parent / "support" / "crate.py"
BOX = "input[@type='checkbox']"
PATIENCE = 30.0  # for a browser without a GPU on a busy machine [s]


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with started() as made:
        yield made


@pytest.fixture
def studio(tmp_path: Path) -> Iterator[Studio]:
    """A studio of a file that a test may edit, lit so that browsers without a GPU are quick."""
    file = shutil.copy(CRATE, tmp_path / "mine.py")
    made = Studio(Session(str(file), seed=1), port=0, rich_light=False)
    made.stage.textures = 0
    try:
        yield made
    finally:
        made.close()


def until(what: Callable[[], Any], why: str) -> Any:
    end = time.monotonic() + PATIENCE
    while not (found := what()):
        assert time.monotonic() < end, f"{why} within {PATIENCE:g} s"
        time.sleep(0.05)
    return found


def opened(tab: Tab, studio: Studio) -> Tab:
    tab.page.set_default_timeout(1e3 * PATIENCE)
    tab.open(studio.address)
    tab.page.get_by_role("tab", name="Parameters").wait_for()
    return tab


def control(tab: Tab, label: str, kind: str) -> Any:
    """The input of that kind beside a label, which has a dot before it where a person set the value."""
    words = tab.page.locator("label", has_text=re.compile(rf"^(\u2022 )?{re.escape(label)}$"))
    return words.locator(f"xpath=ancestor::*[.//{kind}][1]//{kind}")


def turn(tab: Tab, label: str, key: str) -> None:
    """Press a key on the slider of that label, as a person does who is at the end of its way."""
    control(tab, label, "*[@role='slider']").press(key)


def show(tab: Tab, name: str) -> None:
    tab.page.get_by_role("tab", name=name).click()


def scene(tab: Tab) -> np.ndarray:
    """The part of the page that the panel leaves free, once it hardly changes any more."""
    now = tab.picture("canvas").astype(int)
    for _ in range(8):
        before = now
        tab.page.wait_for_timeout(200)
        now = tab.picture("canvas").astype(int)
        if changed(before, now) < 1e-4:
            break
    return now


def changed(before: np.ndarray, after: np.ndarray) -> float:
    """The share of pixels that are seen to differ."""
    return float((np.abs(after - before).max(axis=2) > 12).mean())


def red(picture: np.ndarray) -> float:
    """The share of pixels that are red."""
    red, green, blue = np.moveaxis(picture, -1, 0)
    return float(((red > 90) & (red > 3 * green) & (red > 3 * blue)).mean())


def test_a_slider_moves_a_joint_and_boxes_draw_over_it(browser: Browser, studio: Studio) -> None:
    with browser.tab(680, 440) as tab:
        elsewhere: list[str] = []
        home = f"http://127.0.0.1:{studio.port}/"
        tab.page.on("request", lambda request: elsewhere.append(request.url))
        opened(tab, studio)
        show(tab, "Joints")
        closed = scene(tab)
        # the lid waits for the bolt, and says so
        turn(tab, "lid_hinge [rad]", "End")
        tab.page.get_by_text("lid_hinge is blocked: it needs bolt_slide > 0.03").wait_for()
        assert studio.session.q.get("lid_hinge", 0.0) == 0.0
        sent = studio.stage.sent
        turn(tab, "bolt_slide [m]", "End")
        until(lambda: studio.session.q.get("bolt_slide") == 0.04, "the bolt moves")
        turn(tab, "lid_hinge [rad]", "End")
        limit = studio.session.asset.joint("lid_hinge").limits[1]
        until(lambda: studio.session.q.get("lid_hinge") == limit, "the lid opens")
        until(
            lambda: abs(studio.stage._links["lid"].frame.wxyz[0] - np.cos(limit / 2)) < 1e-6,
            "its frame turns",
        )
        flag = studio.stage._links["flag"].frame  # frames move one after the other
        until(lambda: flag.position[0] == pytest.approx(0.02 * limit), "the flag on it moves along")
        assert studio.stage.sent == sent, "a joint sends no link"
        open_ = scene(tab)
        assert changed(closed, open_) > 0.01, "nothing is seen to move"

        show(tab, "View")
        before = open_
        for label in ("joint axes and limits", "centers of mass", "colliders"):
            control(tab, label, BOX).check()
            until(lambda before=before: changed(before, scene(tab)) > 1e-4, f"{label} are seen")
            before = scene(tab)
        control(tab, "semantic colors", BOX).check()
        until(lambda: studio.stage.by_label and studio.stage.sent > sent, "links get the colors of labels")
        assert not [problem for problem in tab.problems if problem.startswith("error")], tab.problems
        assert not [url for url in elsewhere if not url.startswith((home, "data:", "blob:"))]
    assert not studio.session.error


def test_a_parameter_rebuilds_it_and_what_cannot_be_is_told(browser: Browser, studio: Studio) -> None:
    with browser.tab(680, 440) as tab:
        opened(tab, studio)
        before = scene(tab)
        turn(tab, "width [m]", "Home")
        until(lambda: studio.session.asset.parameters["width"] == 0.2, "the width is taken")
        tab.page.get_by_text("width [m]", exact=False).first.wait_for()
        assert changed(before, scene(tab)) > 0.01
        turn(tab, "width [m]", "End")
        tab.page.get_by_text("no lid is that wide").wait_for()
        assert studio.session.asset.parameters["width"] == 0.2
        turn(tab, "width [m]", "Home")
        tab.page.get_by_text("no lid is that wide").wait_for(state="hidden")
        # another handle has other parameters
        chosen = studio.session.asset.parameters["handle"]
        other, parameter = ("bar", "length") if chosen == "knob" else ("knob", "across")
        control(tab, "handle", "input").first.click()
        tab.page.get_by_role("option", name=other).click()
        tab.page.locator("label", has_text=parameter).wait_for()
        # a fault in the file is told with its line, and gone when it is mended
        file = studio.session.path
        text = file.read_text()
        file.write_text(text.replace("plate = box(", "plate = bax("))
        number = 1 + next(index for index, line in enumerate(text.splitlines()) if "plate = box(" in line)
        tab.page.get_by_text(f"mine.py:{number}").wait_for()
        file.write_text(text)
        tab.page.get_by_text(f"mine.py:{number}").wait_for(state="hidden")
        assert not [problem for problem in tab.problems if problem.startswith("error")], tab.problems


@pytest.mark.long
def test_the_worst_pose_is_one_click_away_and_a_closed_browser_harms_nothing(
    browser: Browser, studio: Studio
) -> None:
    until(lambda: studio.session.shown, "there is an asset")
    studio.requests.add("wall", lambda: studio.session.set("wall", 0.05))
    studio.requests.add("swing", lambda: studio.session.set("swing", 2.0))
    with browser.tab(680, 440) as tab:
        opened(tab, studio)
        turn(tab, "swing [rad]", "ArrowLeft")  # and is closed before it can be told what came of it
    with browser.tab(680, 440) as tab:
        opened(tab, studio)
        show(tab, "Certificate")
        tab.page.get_by_role("button", name="worst pose").click()
        until(lambda: studio.session.q.get("lid_hinge", 0.0) > 1.0, "the lid goes to the worst pose")
        until(lambda: red(scene(tab)) > 0.005, "what collides is red")
        show(tab, "Joints")
        turn(tab, "lid_hinge [rad]", "Home")
        until(lambda: red(scene(tab)) < 0.001, "it is red no more")
        show(tab, "Export")
        tab.page.get_by_role("button", name="export", exact=True).wait_for()
        assert "on_collision" in tab.page.locator("pre", has_text="load_file").inner_text()
        assert not [problem for problem in tab.problems if problem.startswith("error")], tab.problems
