"""What the documentation shows is true: Python runs, commands exist, pages and links are whole."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import category_pages
import cheat_sheet
import pytest
import reference_pages
import typer
import yaml
from node_examples import nodes
from node_pages import placed

import artgen
from artgen import by, choice, count, fixed, loguniform, truncated_normal, uniform
from artgen.cli import command_line
from artgen.generator import CATEGORIES

ROOT = Path(__file__).parent.parent
PAGES = {path.name: path.read_text(encoding="utf-8") for path in sorted((ROOT / "docs").glob("*.md"))}
PYTHON = {name: re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL) for name, text in PAGES.items()}
COMMANDS = sorted(
    {
        line.removeprefix("$ ")
        for text in PAGES.values()
        for block in re.findall(r"```console\n(.*?)```", text, flags=re.DOTALL)
        for line in block.splitlines()
        if line.startswith("$ artgen")
    }
)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.long if name == "scenes.md" else ())  # which makes kitchens
        for name, blocks in PYTHON.items()
        if blocks
    ],
)
def test_python_of_a_page_runs_block_after_block(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if ".render(" in PAGES[name]:
        pytest.importorskip("embreex", reason="needs Embree: artgen[sim]")
    monkeypatch.chdir(tmp_path)
    page = tmp_path / f"{Path(name).stem}.py"
    page.write_text("\n\n".join(PYTHON[name]), encoding="utf-8")
    try:
        exec(compile(page.read_text(), str(page), "exec"), {"__name__": page.stem})  # noqa: S102 - our own pages
    finally:
        for category in [each for each, made in CATEGORIES.items() if made.function.__module__ == page.stem]:
            del CATEGORIES[category]


def test_there_is_something_to_run() -> None:
    assert sum(map(len, PYTHON.values())) > 30
    assert len(COMMANDS) > 10


@pytest.mark.parametrize("command", COMMANDS)
def test_command_is_one_that_artgen_understands(command: str) -> None:
    _, name, *arguments = shlex.split(command, comments=True)
    known = typer.main.get_command(command_line())
    assert name in known.commands, f"artgen has no command {name!r}"
    known.commands[name].make_context(name, arguments)  # reads the arguments, and runs nothing


def anchors(text: str) -> set[str]:
    """Return the anchors of the headings of a page."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL), re.MULTILINE)
    return {re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", each).strip().lower()) for each in headings}


def dead_links(page: Path, text: str) -> list[str]:
    """Return the links of a page to files that a clone does not have, or to headings that a page does not."""
    prose = re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)
    targets = re.findall(r"\]\(([^)\s]+)", prose) + re.findall(r"(?:src|href)=\"([^\"]+)", prose)
    dead = []
    for target in targets:
        path, _, anchor = target.partition("#")
        file = page.parent / path if path else page
        if "://" in target or not (path or anchor):
            continue
        if not file.exists():
            dead.append(path)
        elif anchor and file.suffix == ".md":
            known = text if file == page else file.read_text(encoding="utf-8")
            dead += [target] * (anchor not in anchors(known))
    return dead


@pytest.mark.parametrize("page", ["README.md", *(f"docs/{name}" for name in PAGES)])
def test_links_lead_to_files_of_a_clone(page: str) -> None:
    assert dead_links(ROOT / page, (ROOT / page).read_text(encoding="utf-8")) == [], "say `after make docs`"


def test_a_dead_link_is_found() -> None:
    text = "[a](nodes/index.md#box) ![b](door.jpg) [c](https://a.b/c) `[d](e)`\n```\n[f](g)\n```\n"
    assert dead_links(ROOT / "docs" / "index.md", text) == ["nodes/index.md"]
    text = "## A *new* part, 2\n[a](#a-new-part-2) [b](#part) [c](batches.md#mjlab) [d](batches.md#none)"
    assert dead_links(ROOT / "docs" / "index.md", text) == ["#part", "batches.md#none"]


def test_the_cheat_sheet_is_that_of_the_code() -> None:
    assert PAGES["cheat_sheet.md"] == cheat_sheet.drawn(), "run python scripts/docs/cheat_sheet.py"


def test_the_cheat_sheet_shows_calls_as_authors_write_them() -> None:
    assert cheat_sheet.signature("tube", artgen.tube) == "tube(outer, inner, length, *, axis=Z, bevel=0)"
    assert cheat_sheet.signature("Solid.at", artgen.Solid.at) == "Solid.at(x=0, y=0, z=0)"
    assert cheat_sheet.signature("shades", artgen.shades).startswith("shades(*materials, weights=None, ")
    assert cheat_sheet.signature("Float", artgen.Float) == ""


def test_a_node_without_a_section_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(cheat_sheet.SECTIONS, "Numbers")
    with pytest.raises(LookupError, match="no section of the cheat sheet has numbers/atan2; add a pattern"):
        cheat_sheet.by_section()


def test_the_categories_are_those_that_exist() -> None:
    rows = re.findall(
        r"^\| `(\w+)` \|.*\| \[sheet\]\((\w+)\.jpg\) \|$", PAGES["categories.md"], flags=re.MULTILINE
    )
    assert rows == [(name, name) for name in artgen.catalog.categories()]


def test_every_written_page_is_in_the_navigation() -> None:
    nav = yaml.safe_load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"))["nav"]
    assert set(PAGES) | {"gallery.md"} == {each for each in entries(nav) if each.endswith(".md")}
    assert {each for each in entries(nav) if each.endswith("/")} == {"categories/", "nodes/", "reference/"}


def entries(nav: object) -> list[str]:
    """Every page or folder that a navigation names."""
    if isinstance(nav, str):
        return [nav]
    items = nav.values() if isinstance(nav, dict) else nav
    return [entry for item in items for entry in entries(item)]


def test_everything_public_has_an_entry() -> None:
    shown = {name for _, names in reference_pages.PAGES.values() for name in names}
    shown |= {name.rpartition(".")[2] for name in shown} | {name for name, _ in nodes()}
    assert set(artgen.__all__) - shown == {"catalog", "details"}


@pytest.mark.parametrize("name", artgen.catalog.categories())
def test_a_category_says_what_it_is_and_where_its_sizes_are_from(name: str) -> None:
    first, about, sources = category_pages.paragraphs(name)
    assert first.endswith(".")
    assert any(paragraph.startswith("Links:") or "Links:" in paragraph for paragraph in about)
    assert sources, f"no paragraph of {name} begins with `Sizes are those of ...`"
    assert (ROOT / "docs" / f"{name}.jpg").exists(), f"run scripts/sheets.py {name}"


@pytest.mark.parametrize(
    ("distribution", "words"),
    [
        (uniform(0.1, 0.2, "m"), "0.1 to 0.2"),
        (loguniform(1.0, 8.0), "1 to 8, even in ratio"),
        (truncated_normal(1.0, 0.2, 0.5, 1.5), "0.5 to 1.5, around 1 ± 0.2"),
        (choice("oak", "ash", weights=(3, 1)), "oak 75%, ash 25%"),
        (choice(False, True), "False, True"),
        (count(2, 6), "2, 3 ... 6"),
        (fixed(0.02), "always 0.02"),
        (
            by("style", round=uniform(1.0, 2.0), otherwise=3.0),
            "by `style`<ul><li>`round`: 1 to 2</li><li>otherwise: always 3.0</li></ul>",
        ),
    ],
)
def test_distributions_are_told_in_words(distribution: object, words: str) -> None:
    assert category_pages.described(distribution) == words


def test_joints_are_counted_and_their_numbers_left_out() -> None:
    rows = category_pages.rows("plier", 2, "test")
    assert rows["jaw_hinge"].kind == "revolute"
    assert rows["jaw_hinge"].seeds == 2
    assert rows["jaw_hinge"].low == 0.0
    assert 0.1 < rows["jaw_hinge"].high < 1.5
    assert category_pages.rows("plier", 2, "test") == rows  # as they were kept
    drawers = category_pages.rows("drawer", 1, "test")
    assert list(drawers) == ["drawer_slide_<n>"]
    assert drawers["drawer_slide_<n>"].most == len(artgen.generate("drawer", certify=False).joints)


@pytest.mark.long
def test_the_site_builds_without_a_warning(tmp_path: Path) -> None:
    """Links, anchors, navigation and docstrings; `quick` leaves pictures and viewers out."""
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "mkdocs",
            "build",
            "--strict",
            "--quiet",
            "--site-dir",
            str(tmp_path / "site"),
        ],
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
        env={**os.environ, "ARTGEN_DOCS": "quick", "NO_MKDOCS_2_WARNING": "1"},
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    site = tmp_path / "site"
    for name in artgen.catalog.categories():
        page = (site / "categories" / f"{name}.html").read_text(encoding="utf-8")
        assert all(f"<code>{label}</code>" in page for label in artgen.catalog.find(name).labels)
        assert f'href="../viewers/{name}.html"' in page
        assert f'href="viewers/{name}.html"' in (site / "gallery.html").read_text(encoding="utf-8")
    for page, shown in placed().items():
        text = (site / "nodes" / f"{page}.html").read_text(encoding="utf-8")
        for example in shown:
            assert f'id="{example.address}"' in text, example.name
            assert f'src="pictures/{example.name}.webp"' in text
