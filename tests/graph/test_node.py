"""Nodes: immutable, keyed by content, and aware of the author's line."""

import copy
import pickle
from dataclasses import FrozenInstanceError

import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.graph import Node, topological
from artgen.nodes.handles import Float
from artgen.nodes.primitive import box
from artgen.nodes.vector import X
from support.lines import place_of

LITERALS = st.one_of(st.booleans(), st.integers(), st.floats(allow_nan=False), st.text(), st.none())
VALUES = st.recursive(LITERALS, lambda inner: st.lists(inner, max_size=3), max_leaves=8)


def test_a_node_cannot_be_changed():
    node = box(1.0, 2.0, 3.0).node
    with pytest.raises(FrozenInstanceError):
        node.op = "cylinder"
    with pytest.raises(TypeError):
        node.inputs["x"] = 5.0


def test_lists_that_a_node_is_given_are_copied():
    corners = [1.0, 2.0]
    node = Node("made", {"corners": corners})
    key = node.key
    corners.append(3.0)
    assert node.inputs["corners"] == (1.0, 2.0)
    assert Node("made", {"corners": (1.0, 2.0)}).key == key


@given(a=VALUES, b=VALUES)
def test_keys_are_equal_exactly_when_the_content_is(a, b):
    same = repr(Node("made", {"x": a}).inputs) == repr(Node("made", {"x": b}).inputs)
    assert (Node("made", {"x": a}, "here").key == Node("made", {"x": b}, "there").key) == same


@pytest.mark.parametrize(
    "other",
    [
        Node("other", {"x": 1.0, "y": "a"}),
        Node("made", {"x": 1, "y": "a"}),
        Node("made", {"x": True, "y": "a"}),
        Node("made", {"x": 1.0, "y": ("a",)}),
        Node("made", {"x": 1.0, "y": Node("a", {})}),
        Node("made", {"x": 1.0, "z": "a"}),
        Node("made", {"x": 1.0, "y": {"$material": "a"}}),
    ],
)
def test_each_difference_gives_another_key(other):
    assert Node("made", {"x": 1.0, "y": "a"}).key != other.key


def test_literal_text_cannot_be_taken_for_structure():
    child = Node("child", {})
    assert Node("made", {"x": f"${child.key}"}).key != Node("made", {"x": child}).key
    assert Node("made", {"x": "[", "y": "]"}).key != Node("made", {"x": ("\0y", "]")}).key


def test_equal_subgraphs_have_equal_keys_wherever_they_were_written():
    a = box(0.1, 0.2, 0.3)
    b = box(0.1, 0.2, 0.3)
    assert a.node is not b.node
    assert a.node.where != b.node.where
    assert a.node.key == b.node.key


def test_children_come_in_order_and_with_repeats():
    a, b = Node("a", {}), Node("b", {})
    node = Node("made", {"x": a, "y": [b, [a, 1.0]], "z": "a"})
    assert [child.op for child in node.children] == ["a", "b", "a"]


def test_a_node_varies_when_a_parameter_is_below_it():
    assert not box(1.0, 1.0, 1.0).node.varies
    assert box(Float.parameter("width"), 1.0, 1.0).at(1.0).node.varies


def test_topological_order_lists_each_node_once_after_its_inputs():
    side = Float.parameter("side")
    solid = box(side, side * 2.0, side) - box(side, side * 2.0, side).at(1.0)
    order = topological(solid.node)
    position = {node.key: index for index, node in enumerate(order)}
    assert len(position) == len(order)
    assert all(position[child.key] < position[node.key] for node in order for child in node.children)


def test_the_authors_line_is_recorded():
    solid = box(1.0, 1.0, 1.0)  # marker: plain
    moved = solid.at(1.0, 2.0, 3.0)  # marker: method
    number = Float.parameter("x") + 1.0  # marker: operator
    assert solid.node.where == place_of(__file__, "marker: plain")
    assert moved.node.where == place_of(__file__, "marker: method")
    assert number.node.where == place_of(__file__, "marker: operator")


def test_constants_of_the_language_are_its_own():
    assert "artgen/nodes/vector.py:" in X.node.where


def test_repr_is_short_however_much_lies_below():
    number = Float.parameter("x")
    for _ in range(50):
        number = number + number
    assert len(repr(number.node)) < 300
    assert "add" in repr(number.node)


def test_nodes_can_be_copied_and_pickled():
    node = (box(Float.parameter("width"), 1.0, 1.0) - box(0.1, 0.1, 2.0)).node
    for other in (copy.deepcopy(node), pickle.loads(pickle.dumps(node))):  # noqa: S301 - made just here
        assert other.key == node.key
        assert other.where == node.where
