"""Graphs as JSON: data only, and each malformed file is refused in words."""

import contextlib
import json
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import EvaluationError, GraphError
from artgen.graph import Graph
from artgen.materials import Material, material
from artgen.nodes.body import part
from artgen.nodes.handles import Float
from artgen.nodes.joint import Revolute
from artgen.nodes.primitive import box
from artgen.nodes.scalar import min_, sqrt
from artgen.nodes.vector import Z, points
from support.lines import place_of


def door():
    width = Float.parameter("width")
    leaf = part(box(width, 0.04, 2.0), "leaf", material("oak").with_(name="stained", density=640))
    frame = part(box(width, 0.1, 0.1).at(0.0, 0.0, -2.0), "frame", material("oak"))
    handle = part(box(0.1, 0.02, 0.02), "handle", material("steel"))
    turn = Revolute("turn", axis=-Z, limits=(0.0, width), stiffness=1.2)
    hinge = Revolute("hinge", axis=Z, limits=(0.0, 1.5), needs=(turn > 0.5).until(0.06).beyond(0.01))
    return Graph(frame.attach(leaf.repeat(handle, turn, at=points((0, 0, 0))).suffixed("_a"), hinge))


def test_a_graph_survives_the_round_trip():
    graph = door()
    again = Graph.from_json(graph.to_json())
    assert again.key == graph.key
    assert again.parameters == ("width",)
    a, b = (g.evaluate({"width": 0.9}).value for g in (graph, again))
    assert [link.name for link in a.links()] == [link.name for link in b.links()]
    assert b.branches[0].tree.link.pieces[0].material == Material(
        **{**material("oak").to_data(), "name": "stained", "density": 640.0}
    )


NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
EXPRESSIONS = st.recursive(
    st.sampled_from(["a", "b"]).map(Float.parameter) | NUMBERS,
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda pair: Float.record("add", a=pair[0], b=pair[1])),
        st.tuples(inner, inner).map(lambda pair: min_(*pair)),
        inner.map(sqrt),
        inner.map(lambda value: Float.record("negate", a=value)),
    ),
    max_leaves=12,
)


@given(EXPRESSIONS)
def test_any_expression_survives_the_round_trip(value):
    graph = Graph(min_(value, 1.0))
    assert Graph.from_json(graph.to_json()).key == graph.key


@given(st.text())
def test_any_text_in_a_node_survives(text):
    width = Float.parameter("width")
    graph = Graph(width.require(width > 0.0, text))
    assert Graph.from_json(graph.to_json()).key == graph.key


def test_the_file_is_data_with_one_node_a_line():
    data = json.loads(door().to_json())
    assert data["artgen_graph"] == 1
    assert {"op", "inputs"} == set(data["nodes"][0])
    assert len(door().to_json().splitlines()) == len(data["nodes"]) + 3


def wrap(*nodes, version=1):
    return json.dumps({"artgen_graph": version, "nodes": list(nodes)})


def node(op, **inputs):
    return {"op": op, "inputs": inputs}


MALFORMED = {
    "nothing": (None, r"this is not a graph file: give the text that to_json\(\) returns, not None"),
    "not JSON": ("import os", "this is not a graph file: Expecting value"),
    "cut off": ('{"artgen_graph": 1, "nodes": [', "this is not a graph file"),
    "not an object": ("[1, 2]", "it has no list of nodes"),
    "no nodes": (wrap(), "it has no list of nodes"),
    "another version": (wrap(node("volume"), version=7), "has version 7; this artgen reads version 1"),
    "no version": ('{"nodes": [{}]}', "has version None"),
    "a node that is no object": (wrap("box"), "node 0 of the graph file must have an op and inputs"),
    "an op that is no name": (wrap({"op": ["box"], "inputs": {}}), "must have an op and inputs"),
    "inputs that are a list": (wrap({"op": "box", "inputs": [1]}), "must have an op and inputs"),
    "an unknown operation": (wrap(node("bax", x=1)), r"node 0 .*no operation 'bax'\. Did you mean 'box'\?"),
    "an input too many": (
        wrap(node("sphere", radius=1.0, radios=2.0)),
        r"node 0 .*: sphere has no input 'radios'\. Did you mean 'radius'\?",
    ),
    "an input too few": (wrap(node("sphere")), "sphere needs the input 'radius'"),
    "the wrong type": (wrap(node("sphere", radius="big")), r"radius=\.\.\.\) needs a Float, got 'big'"),
    "a truth value for a number": (wrap(node("sphere", radius=True)), "needs a Float, got True"),
    "a node of the wrong type": (
        wrap(node("sphere", radius=1.0), node("sphere", radius={"$": 0})),
        "node 1 .*needs a Float, got a Solid handle",
    ),
    "not a number": (
        '{"artgen_graph": 1, "nodes": [{"op": "sphere", "inputs": {"radius": NaN}}]}',
        "not a finite number",
    ),
    "a node that refers to itself": (wrap(node("sqrt", a={"$": 0})), "the graph has a cycle"),
    "a cycle": (
        wrap(node("sqrt", a={"$": 1}), node("sqrt", a={"$": 0})),
        "node 0 .* refers to node 1, .* cycle",
    ),
    "a reference to nothing": (
        wrap(node("sqrt", a={"$": -1})),
        "refers to -1, which is not the number of a node",
    ),
    "a reference by name": (
        wrap(node("sqrt", a={"$": "x"})),
        "refers to 'x', which is not the number of a node",
    ),
    "an unknown literal": (wrap(node("sqrt", a={"$code": "1+1"})), "has the unknown literal"),
    "a bad material": (
        wrap(
            node("sphere", radius=1.0), node("paint", solid={"$": 0}, material={"$material": {"name": "A B"}})
        ),
        "no valid Material: material name 'A B'",
    ),
    "a material that is a list": (
        wrap(node("sphere", radius=1.0), node("paint", solid={"$": 0}, material={"$material": [1]})),
        "no valid Material",
    ),
    "a material with another field": (
        wrap(
            node("sphere", radius=1.0),
            node("paint", solid={"$": 0}, material={"$material": {"name": "a", "b": 1}}),
        ),
        "no valid Material",
    ),
    "a parameter without a kind": (
        wrap(node("parameter", name="a")),
        "a parameter needs a name and a kind, one of",
    ),
    "a parameter of no kind": (
        wrap(node("parameter", name="a", kind="os")),
        "a parameter needs a name and a kind",
    ),
    "a list nested too deeply": (
        '{"artgen_graph": 1, "nodes": [{"op": "sqrt", "inputs": {"a": ' + "[" * 5000 + "]" * 5000 + "}}]}",
        "nested too deeply",
    ),
}


@pytest.mark.parametrize("name", MALFORMED)
def test_malformed_files_are_refused(name):
    text, message = MALFORMED[name]
    with pytest.raises(GraphError) as caught:
        Graph.from_json(text)
    assert re.search(message, str(caught.value)), str(caught.value)


def test_reading_and_running_runs_no_code(tmp_path):
    trap = tmp_path / "trap"
    code = f"__import__('pathlib').Path({str(trap)!r}).touch()"
    for text in (
        wrap(node(code)),
        wrap(node("parameter", name=code, kind="Float"), node("sqrt", a={"$": 0})),
        wrap(node("sqrt", a={"$python": code})),
        wrap(node("sphere", radius=1.0), node("part", solid={"$": 0}, label=code, material=code)),
    ):
        with contextlib.suppress(GraphError):
            Graph.from_json(text).evaluate({code: 4.0})
    assert not trap.exists()


def test_errors_of_a_graph_from_a_file_name_the_node():
    text = wrap(node("parameter", name="a", kind="Float"), node("sqrt", a={"$": 0}))
    graph = Graph.from_json(text)  # marker: read
    with pytest.raises(EvaluationError) as caught:
        graph.evaluate({"a": -1.0})
    place = place_of(__file__, "marker: read")
    assert str(caught.value) == f"sqrt failed: square root of -1\n  at {place} (node 1 of the graph file)"
