"""Graphs as Python source: readable, and it builds the same graph."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import GraphError
from artgen.graph import Graph
from artgen.materials import material
from artgen.nodes.body import part, weld
from artgen.nodes.handles import Bool, Float
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box, cylinder
from artgen.nodes.scalar import min_, switch
from artgen.nodes.vector import X, Y, Z, grid


def built(source, name="build"):
    namespace: dict = {}
    exec(compile(source, "<source>", "exec"), namespace)  # noqa: S102 - the source is what is tested
    return namespace[name]()


def test_source_reads_as_an_author_would_write_it():
    width = Float.parameter("width")
    leaf = box(width, 0.04, width * 2.0 + 0.1)
    assert Graph(leaf - cylinder(0.01, 0.2, axis=(0, 1, 0)).at(leaf.anchor(x=-1))).to_python("leaf") == (
        "from artgen.nodes.handles import Solid\n"
        "from artgen.nodes.primitive import box, cylinder\n"
        "from artgen.nodes.scalar_handles import Float\n"
        "\n"
        "\n"
        "def leaf() -> Solid:\n"
        "    width_1 = Float.parameter('width')\n"
        "    box_1 = box(width_1, 0.04, ((width_1 * 2.0) + 0.1))\n"
        "    return (box_1 - cylinder(0.01, 0.2, axis=(0.0, 1.0, 0.0))"
        ".at(box_1.anchor(x=-1.0, y=0.0, z=0.0)))\n"
    )


def cabinet():
    width, open_ = Float.parameter("width"), Float.parameter("open")
    side = switch(width > 0.5, X, -1.0 * Y)
    knob = part(cylinder(0.01, 0.02).at(side), "knob", material("brass"))
    drawer = part(box(width, 0.4, 0.1), "class", material("oak"))
    slide = Prismatic(
        "slide", axis=-Y, limits=(0.0, open_), needs=(Revolute("lock", axis=Z) > 0.5) & (knob_turn() < 3)
    )
    drawer = drawer.attach(knob, knob_turn())
    body = part(box(width, 0.5, 1.0).at(0, 1), "body", material("oak"))
    lock = part(box(0.01, 0.01, 0.01), "lock", material("brass"))
    dial = part(box(0.02, 0.01, 0.01), "dial", material("brass"))
    body = body.attach(lock, Revolute("lock", axis=Z, limits=(0.0, 1.0)))
    body = body.attach(dial, Revolute("dial", axis=Z, follows=0.5 - 2 * knob_turn() / width))
    at = grid((0, 0, 0), X, (0, 0, 0.2), columns=1, rows=3)
    return weld(body.repeat(drawer, slide, at=at).mirror(X).rotate(Z, 0.1), body.suffixed("_b")).require(
        width < 2.0, 'not "wide"\n'
    )


def knob_turn():
    return Revolute("knob", axis=Y)


def test_a_whole_asset_round_trips():
    graph = Graph(cabinet())
    again = built(graph.to_python())
    assert again.node.key == graph.key
    assert Graph(again).to_python() == graph.to_python()


NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
FLOATS = st.recursive(
    st.sampled_from(["a", "b"]).map(Float.parameter) | NUMBERS,
    lambda inner: (
        st.tuples(
            st.sampled_from(["add", "subtract", "multiply", "divide", "power", "modulo"]), inner, inner
        ).map(lambda made: Float.record(made[0], a=made[1], b=made[2]))
        | inner.map(lambda value: Float.record("negate", a=value))
        | inner.map(lambda value: Float.record("absolute", a=value))
    ),
    max_leaves=12,
)


@given(FLOATS, FLOATS, st.sampled_from(["less", "greater", "at_most", "at_least"]))
def test_any_arithmetic_round_trips(a, b, comparison):
    graph = Graph(Bool.record(comparison, a=a, b=b))
    assert built(graph.to_python()).node.key == graph.key


def test_joints_leave_out_what_is_usual():
    turn = Revolute("turn", axis=Z, limits=(0.0, 1.5), damping=0.1)
    assert (
        "joint('turn', 'revolute', axis=vector(z=1.0), limits=(0.0, 1.5), damping=0.1, velocity=10.0)"
        in Graph(turn).to_python()
    )


def test_a_negative_base_keeps_its_sign():
    graph = Graph(Float.record("power", a=-2.0, b=Float.parameter("a")))
    assert "(-2.0) ** " in graph.to_python()
    assert built(graph.to_python()).node.key == graph.key


def test_a_negative_zero_is_kept():
    graph = Graph(box(Float.parameter("a"), 1.0, 1.0, bevel=-0.0))
    assert built(graph.to_python()).node.key == graph.key


def test_shared_nodes_get_one_variable_and_lines_stay_short():
    root = Float.parameter("a")
    for _ in range(40):
        root = min_(root + 1.0, root * 2.0)
    source = Graph(root).to_python()
    assert built(source).node.key == root.node.key
    assert source.count("min_(") == 40
    assert max(map(len, source.splitlines())) < 200


def test_labels_that_are_keywords_or_alike_make_legal_variables():
    oak = material("oak")
    block = box(1.0, 1.0, 1.0)
    bodies = [part(block, label, oak) for label in ("class", "x", "x_1", "x", "box", "é")]
    graph = Graph(weld(*bodies, *bodies))
    assert built(graph.to_python()).node.key == graph.key


def test_parameters_of_sub_generators_keep_their_dots():
    graph = Graph(Float.parameter("handle.length") * 2.0)
    assert "Float.parameter('handle.length')" in graph.to_python()
    assert built(graph.to_python()).node.key == graph.key


@pytest.mark.parametrize("name", ["my door", "class", "", "1a"])
def test_the_function_needs_a_legal_name(name):
    with pytest.raises(GraphError, match="is not a name for a Python function"):
        Graph(Float.parameter("a")).to_python(name)
