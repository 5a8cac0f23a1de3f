"""Every node's docstring has an example that gives something to look at, and a page that shows it."""

import pytest
from node_examples import examples, nodes
from node_pages import PAGES, index, placed, written

from artgen.asset import Curve, Outline, Shape, Tree
from artgen.graph.evaluation import evaluate
from artgen.nodes.handles import Body, Path, Profile, Solid

EXAMPLES = examples()  # raises where a node has none


def test_nodes_are_the_functions_joints_and_methods_that_authors_use() -> None:
    names = {name for name, _ in nodes()}
    assert set(EXAMPLES) == names
    assert {
        "box",
        "Revolute",
        "details.icon",
        "Solid.at",
        "Body.attach",
        "Float",
        "Condition.until",
        "switch",
    } <= names
    assert len(names) > 130


@pytest.mark.parametrize("name", EXAMPLES)
def test_example_gives_what_a_picture_can_show(name: str) -> None:
    made = EXAMPLES[name].run()
    assert isinstance(made, Solid | Profile | Path | Body), f"{name} gives a {type(made).__name__}"
    value = evaluate(made).value
    if isinstance(value, Shape):
        assert value.manifold.volume() > 0.0
    elif isinstance(value, Outline):
        assert value.contours
    elif isinstance(value, Curve):
        assert len(value.points) >= 2
    else:
        assert isinstance(value, Tree)
        assert value.link.pieces


@pytest.mark.parametrize("name", EXAMPLES)
def test_example_uses_the_node_that_it_explains(name: str) -> None:
    """An operator's example shows operators: classes are exempt."""
    last = name.rpartition(".")[2]
    used = "\n".join(EXAMPLES[name].source)
    assert f"{last}(" in used or last[0].isupper()


def test_every_node_is_on_one_page() -> None:
    pages = placed()
    listed = index(pages)
    shown = [example.name for found in pages.values() for example in found]
    assert sorted(shown) == sorted(EXAMPLES)
    for page in PAGES:
        text = written(page, pages[page.name])
        for example in pages[page.name]:
            assert f"::: {example.address}\n" in text
            assert f"pictures/{example.name}.webp" in text
            assert f"[`{example.name}`]({page.name}.md#{example.address})" in listed
