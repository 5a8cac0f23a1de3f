"""Graphs for the eye."""

from artgen.graph import Graph
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Float
from artgen.nodes.joint import Revolute
from artgen.nodes.primitive import box
from artgen.nodes.vector import Z


def graph():
    width = Float.parameter("door.width")
    leaf = part(box(width, width, 2.0), "leaf", material("oak"))
    post = part(box(0.1, 0.1, 2.0).at(1.0), "post", material("oak"))
    return Graph(post.attach(leaf, Revolute("hinge", axis=Z, limits=(0.0, 1.5))))


def test_mermaid_shows_every_node_and_edge():
    assert graph().to_mermaid() == (
        "flowchart TD\n"
        '  n0["box"]\n'
        '  n1["translate"]\n'
        '  n2[["part post"]]\n'
        '  n3("door.width")\n'
        '  n4["box"]\n'
        '  n5[["part leaf"]]\n'
        '  n6("vector")\n'
        '  n7{{"joint hinge"}}\n'
        '  n8[["attach"]]\n'
        "  n0 -- solid --> n1\n"
        "  n1 -- solid --> n2\n"
        "  n3 -- x --> n4\n"
        "  n3 -- y --> n4\n"
        "  n4 -- solid --> n5\n"
        "  n6 -- axis --> n7\n"
        "  n2 -- parent --> n8\n"
        "  n5 -- child --> n8\n"
        "  n7 -- joints --> n8\n"
    )


def test_quotes_in_names_cannot_end_a_title():
    quoted = Graph(Float.parameter('a"]; b') + 1.0).to_mermaid()
    assert '("a\']; b")' in quoted


def test_the_table_lists_nodes_with_uses_and_places():
    rows = graph().table().splitlines()
    assert rows[0].split() == ["node", "type", "operation", "uses", "inputs", "where"]
    assert len(rows) == 10
    width = next(row.split() for row in rows if " parameter " in row)
    assert width[:4] == ["3", "Float", "parameter", "2"]
    assert any("x=#3, y=#3, z=2" in row and "test_draw.py:" in row for row in rows)


def test_the_table_adds_the_costs_of_an_evaluation():
    made = graph()
    text = made.table(made.evaluate({"door.width": 0.9}))
    costs = {line.split()[0]: line.split()[1] for line in text.splitlines()[11:]}
    assert costs["operation"] == "runs"
    assert costs["box"] == "2"
    assert costs["attach"] == "1"
