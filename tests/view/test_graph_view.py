"""The page of a node graph: what it knows of each node, and what a person sees of it in a browser."""

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from artgen import Body, Float, Revolute, Z, box, cylinder, fixed, generator, material, part, switch, uniform
from artgen.catalog import find
from artgen.errors import ParameterError, RenderError
from artgen.generator import Generator
from artgen.graph_view import dagre_js, graph_page, graph_record
from support.browser import Browser, Tab, started


# fmt: off
# statements and signatures of several lines
def flag_solid(wide: Float, tall: Float):
    return box(
        wide,
        0.01,
        tall,
    )


@pytest.fixture
def signpost() -> Generator:
    @generator
    def signpost(
        *,
        height: Float = uniform(1.0, 2.0, "m"),
        wide: Float = fixed(0.4, "m"),
    ) -> Body:
        """A flag on a post."""
        pole = cylinder(0.02, height).at(z=height / 2)
        flag = flag_solid(switch(height > 5.0, 2.0 * wide, wide), 0.2).at(0.25, 0, height)
        post = part(pole, "post", material("oak"))
        return post.attach(part(flag, "flag", material("steel")), Revolute("turn", axis=Z, limits=(0, 1)))

    return signpost
# fmt: on


def by_op(data: dict, op: str) -> dict:
    (found,) = [node for node in data["nodes"] if node["op"] == op]
    return found


def test_a_node_has_value_time_place_and_geometry(signpost) -> None:
    data, blob = graph_record(signpost, 3, {"height": 1.5}, {})
    node = by_op(data, "box")
    assert node["value"] == "solid, 0.4 x 0.01 x 0.2 m, 12 triangles"
    assert (node["type"], node["state"], node["group"]) == ("Solid", "computed", "test_graph_view.flag_solid")
    assert node["source"] == "return box(\n    wide,\n    0.01,\n    tall,\n)"  # the whole statement
    assert node["where"].startswith("test_graph_view.py:")
    assert 0.0 < node["ms"] < 1000.0
    assert node["uses"] == 1
    (item,) = [data["items"][number] for number in node["shape"]]
    mesh = data["meshes"][item["mesh"]]
    assert mesh["triangles"] == 12
    assert np.allclose(mesh["size"], (0.4, 0.01, 0.2))
    assert len(blob) == sum(
        -(-count // 4) * 4
        for each in data["meshes"]
        for count in (6 * each["vertices"], 3 * each["vertices"], 6 * each["triangles"])
    )


def test_inputs_lead_to_nodes(signpost) -> None:
    data, _ = graph_record(signpost, 3, {}, {})
    numbers = {node["op"]: index for index, node in enumerate(data["nodes"])}
    attach = by_op(data, "attach")
    assert numbers["joint"] in attach["from"]
    parts = dict(attach["inputs"])["joints"]
    assert [part for part in parts if isinstance(part, int)] == [numbers["joint"]]
    assert by_op(data, "joint")["value"] == "revolute turn, 0 to 1 rad"
    assert by_op(data, "joint")["name"] == "turn"
    assert data["nodes"][-1]["value"] == "2 links: post, flag; 1 joint: turn"


def test_a_parameter_has_its_draw_and_its_line(signpost) -> None:
    data, _ = graph_record(signpost, 3, {}, {})
    height = next(node for node in data["nodes"] if node["name"] == "height")
    assert (height["state"], height["group"]) == ("given", "parameters")
    assert height["source"] == 'height: Float = uniform(1.0, 2.0, "m"),'
    assert height["inputs"] == [["drawn from", ["uniform(1, 2)"]]]
    assert float(height["value"]) == pytest.approx(signpost.sample(3)["height"], rel=1e-4)


def test_the_branch_that_is_not_taken_is_unused(signpost) -> None:
    data, _ = graph_record(signpost, 3, {}, {})
    unused = [node["source"] for node in data["nodes"] if node["state"] == "unused"]
    assert len(unused) == 1
    assert "2.0 * wide" in unused[0]


def test_a_change_shows_what_came_from_the_cache(signpost) -> None:
    data, _ = graph_record(signpost, 3, {"wide": 0.3}, {"wide": 0.35})
    states = {node["op"]: node["state"] for node in data["nodes"]}
    assert data["change"] == {"wide": "0.35"}
    assert states["cylinder"] == "cached"
    assert states["box"] == states["attach"] == "computed"


def test_sub_generators_name_their_draws() -> None:
    data, _ = graph_record(find("drawer"), 1, {}, {})
    drawn = [node for node in data["nodes"] if node["op"] == "parameter"]
    assert all(node["inputs"][0][1][0] for node in drawn)
    nested = [node["name"] for node in drawn if "." in node["name"]]
    assert nested, "a drawer draws the parameters of its pull"


def test_without_dagre_it_says_what_to_install(signpost, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "netron", None)
    dagre_js.cache_clear()
    with pytest.raises(RenderError, match=r"dagre, which comes with Netron: pip install 'artgen\[studio\]'"):
        graph_page(signpost)


def test_the_command_writes_a_page(artgen_command) -> None:
    made = artgen_command("graph", "plier", "--seed", "2", "--change", "width=0.05", "--no-open")
    assert made.code == 2
    assert "plier has no parameter 'width'" in made.err
    made = artgen_command("graph", "plier", "--seed", "2", "--no-open")
    assert (made.code, made.out, made.err) == (0, "plier_2_graph.html\n", "")
    assert Path("plier_2_graph.html").stat().st_size < 1.5e6
    assert "graph.txt" in artgen_command("graph", "plier", "--out", "graph.txt", "--no-open").err


def test_an_unknown_change_is_refused(signpost) -> None:
    with pytest.raises(ParameterError, match="signpost has no parameter 'hight'"):
        graph_page(signpost, change={"hight": 1.0})


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with started() as running:
        yield running


@pytest.fixture(scope="module")
def tab(browser, tmp_path_factory) -> Iterator[Tab]:
    path = graph_page(find("drawer"), 0).save(tmp_path_factory.mktemp("graph") / "drawer.html")
    with browser.tab(1300, 850, offline=True) as tab:
        tab.open(path)
        tab.page.wait_for_selector("body[data-drawn]", timeout=30_000)
        yield tab


def drawn(tab: Tab, action) -> int:
    """Do something that changes the drawing, and return how many boxes there are then."""
    tab.page.evaluate("delete document.body.dataset.drawn")
    action()
    tab.page.wait_for_selector("body[data-drawn]", timeout=30_000)
    return tab.page.locator("#graph .box").count()


def titles(tab: Tab) -> set[str]:
    return set(tab.page.locator("#graph .box text:first-of-type").all_text_contents())


def inked(tab: Tab) -> float:
    """How much of the view of the geometry is drawn over, from 0 to 1."""
    tab.page.wait_for_timeout(150)  # for the next frame
    pixels = tab.picture("#details canvas").astype(int)
    background = np.median(pixels, axis=1, keepdims=True)  # a gradient from top to bottom
    return float((np.abs(pixels - background).max(axis=2) > 12).mean())


def test_it_begins_with_the_functions_of_the_author(tab) -> None:
    page = tab.page
    assert page.inner_text("#title") == "drawer, seed 0"
    assert "nodes" in page.inner_text("#facts")
    assert {"drawer.drawer", "boxes.box"} <= titles(tab)
    assert page.locator("#graph path.edge").count() > 5
    assert page.inner_text("#details h2") == "Computing time"
    assert inked(tab) > 0.05  # the whole asset
    assert tab.problems == []


def test_a_function_opens_and_closes(tab) -> None:
    page = tab.page
    before = page.locator("#graph .box").count()
    box = page.locator('[data-id="gboxes.box"]')
    opened = drawn(tab, box.dblclick)
    assert opened > before + 5
    assert "boxes.box" not in titles(tab)
    assert page.locator("#graph .frame").count() == 1
    assert page.inner_text("#details h2") == "boxes.box"
    assert inked(tab) > 0.05
    assert drawn(tab, lambda: page.click("#closeall")) == before
    assert tab.problems == []


def test_a_node_is_found_and_shows_its_value_and_geometry(tab) -> None:
    page = tab.page
    page.fill("#search", "part drawer front")
    assert page.locator("#found li").count() >= 1
    page.fill("#search", "part handle")
    drawn(tab, lambda: page.press("#search", "Enter"))
    assert page.inner_text("#details h2").startswith("part")
    rows = dict(row.split("\t") for row in page.locator("#details tr").all_inner_texts() if "\t" in row)
    assert rows["type"] == "Body"
    assert rows["value"].startswith("1 link: ")
    assert rows["state"].startswith("computed in ")
    assert inked(tab) > 0.02
    alone = tab.picture("#details canvas")
    page.check("#ghosted")
    tab.page.wait_for_timeout(150)
    assert (alone != tab.picture("#details canvas")).mean() > 0.02  # smaller, within the asset
    page.uncheck("#ghosted")
    assert page.locator(".box.chosen").count() == 1
    assert tab.problems == []


def test_upstream_and_downstream_of_a_node(tab) -> None:
    page = tab.page
    page.fill("#search", "joint")
    drawn(tab, lambda: page.press("#search", "Enter"))
    joint = page.inner_text("#details h2")
    assert joint.startswith("joint ")
    up = drawn(tab, lambda: page.click("[data-scope=up]"))
    shown = titles(tab)
    assert joint in shown
    assert not any(title.startswith("attach") for title in shown)
    assert drawn(tab, lambda: page.select_option("#steps", "1")) < up
    drawn(tab, lambda: page.click("[data-scope=down]"))
    shown = titles(tab)
    assert any(title.startswith("attach") for title in shown)
    drawn(tab, lambda: page.click("[data-scope=all]"))
    assert tab.problems == []


def test_types_are_hidden_and_shown(tab) -> None:
    page = tab.page
    page.mouse.click(20, 800)  # beside all boxes: nothing is chosen then
    few = drawn(tab, lambda: page.uncheck("#grouped"))
    assert page.locator('[data-type="Float"]').get_attribute("aria-pressed") == "false"
    many = drawn(tab, lambda: page.click('[data-type="Float"]'))
    floats = int(page.inner_text('[data-type="Float"]').split()[1])
    assert many == few + floats
    drawn(tab, lambda: page.click('[data-type="Float"]'))
    assert drawn(tab, lambda: page.click('[data-type="Solid"]')) < few
    drawn(tab, lambda: page.click('[data-type="Solid"]'))
    drawn(tab, lambda: page.check("#grouped"))
    assert tab.problems == []


@pytest.mark.long
def test_a_box_is_dragged_nowhere_but_the_paper_is(tab) -> None:
    page = tab.page
    page.click("#fit")
    where = page.locator("#graph > g").get_attribute("transform")
    page.mouse.move(300, 700)
    page.mouse.down()
    page.mouse.move(380, 720, steps=3)
    page.mouse.up()
    moved = page.locator("#graph > g").get_attribute("transform")
    assert moved != where
    page.mouse.wheel(0, -300)
    page.wait_for_timeout(100)
    assert page.locator("#graph > g").get_attribute("transform") != moved
    assert tab.problems == []
