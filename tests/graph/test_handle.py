"""Handles: they refuse rather than lie, and lift what authors write."""

import math
import operator

import numpy as np
import pytest

from artgen.errors import BuildError
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Bool, Float, Points, Profile, Solid, Vector
from artgen.nodes.joint import Joint, Revolute
from artgen.nodes.primitive import box, cylinder
from artgen.nodes.profile import circle
from artgen.nodes.scalar import switch
from artgen.nodes.vector import Z, points, row, vector
from support.lines import place_of


def handles():
    number = Float.parameter("width")
    solid = box(number, 1.0, 1.0)
    return {
        "Float": number,
        "Bool": number > 1.0,
        "Vector": solid.size(),
        "Points": solid.bounds(),
        "Profile": circle(number),
        "Solid": solid,
        "Body": part(solid, "block", material("oak")),
        "Revolute": Revolute("turn", axis=Z),
    }


REFUSED = {
    "bool()": bool,
    "not": operator.not_,
    "if": lambda handle: 1 if handle else 2,
    "and": lambda handle: handle and handle,
    "==": lambda handle: handle == handle,
    "== number": lambda handle: handle == 1.0,
    "!=": lambda handle: handle != handle,
    "in": lambda handle: 1.0 in [handle, handle],
    "len()": len,
    "float()": float,
    "int()": int,
    "range()": range,
    "round()": round,
    "math.floor": math.floor,
    "math.ceil": math.ceil,
    "math.sin": math.sin,
    "iteration": list,
    "unpacking": lambda handle: [*handle],
    "contains": lambda handle: 1.0 in handle,
    "hash()": hash,
    "dict key": lambda handle: {handle: 1},
    "set": lambda handle: {handle},
    "numpy float": lambda handle: np.array([handle], float),
}


@pytest.mark.parametrize("name", handles())
@pytest.mark.parametrize("what", REFUSED)
def test_refusals_say_where_and_what_to_do(what, name):
    handle = handles()[name]
    if isinstance(handle, Float) and what in ("round()", "math.floor"):
        assert isinstance(REFUSED[what](handle), Float)
        return
    with pytest.raises(BuildError) as caught:
        REFUSED[what](handle)
    message = str(caught.value)
    assert f"a {name} has no value while the graph is being built" in message
    assert f"  at {__file__}:" in message
    assert f"made at {handle.node.where}" in message
    assert "switch(" in message
    assert "make the parameter that it comes from structural" in message


def test_a_refusal_names_the_line_of_the_mistake_and_of_the_handle():
    width = Float.parameter("width") * 2.0  # marker: made
    with pytest.raises(BuildError) as caught:
        _ = 1 if width > 1.0 else 2  # marker: mistake
    assert f"at {place_of(__file__, 'marker: mistake')}, made at" in str(caught.value)
    with pytest.raises(BuildError) as caught:
        float(width)
    assert f"made at {place_of(__file__, 'marker: made')}\n" in str(caught.value)


def test_chained_comparison_is_refused():
    width = Float.parameter("width")
    with pytest.raises(BuildError, match=r"\(a < b\) & \(b < c\) instead of a < b < c"):
        assert 0.0 < width < 1.0


def test_max_of_python_is_refused_with_the_remedy():
    with pytest.raises(BuildError, match="min_ and max_ instead of min and max"):
        max(Float.parameter("a"), Float.parameter("b"))


def test_is_and_none_still_work():
    handle = Float.parameter("a")
    assert handle is not None
    assert handle in {"a": handle}.values()  # Python looks for the same object first


@pytest.mark.parametrize(
    ("made", "kind"),
    [
        (Float.parameter("a") + 1, Float),
        (1 + Float.parameter("a"), Float),
        (np.float64(1.0) * Float.parameter("a"), Float),
        (np.int64(2) - Float.parameter("a"), Float),
        (Float.parameter("a") < 2, Bool),
        (np.float32(2.0) < Float.parameter("a"), Bool),
        ((0, 0, 1) + vector(1.0), Vector),
        (np.array([0, 0, 1]) + vector(1.0), Vector),
        (2 * Z, Vector),
        (Float.parameter("a") * Z, Vector),
        (points((0, 0, 0)) + (1, 2, 3), Points),
        (box(1.0, 1.0, 1.0) | box(1.0, 1.0, 1.0), Solid),
        (circle(1.0) - circle(0.5), Profile),
    ],
)
def test_python_values_are_lifted(made, kind):
    assert type(made) is kind


def test_a_tuple_with_a_handle_becomes_a_vector():
    width = Float.parameter("width")
    direct = box(1.0, 1.0, 1.0).at(vector(width, 0.0, 1.0))
    assert box(1.0, 1.0, 1.0).at((width, 0, 1)).node.key == direct.node.key
    assert box(1.0, 1.0, 1.0).at(width, 0, 1).node.key == direct.node.key


def test_numpy_points_equal_written_ones():
    block = part(box(1.0, 1.0, 1.0), "block", material("oak"))
    base = part(box(1.0, 1.0, 1.0), "base", material("oak"))
    turn = Revolute("turn", axis=Z)
    a = base.repeat(block, turn, at=np.array([[0, 0, 0], [1, 0, 0]]))
    b = base.repeat(block, turn, at=[(0, 0, 0), (1.0, 0, 0)])
    assert a.node.key == b.node.key


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: box("wide", 1.0, 1.0), r"box\(\.\.\., x=\.\.\.\) needs a Float, got 'wide'"),
        (lambda: box(True, 1.0, 1.0), r"needs a Float, got True"),
        (lambda: box(Z, 1.0, 1.0), r"needs a Float, got a Vector handle"),
        (lambda: box(1.0, 1.0, 1.0).at((1.0, 2.0)), r"translate\(\.\.\., offset=\.\.\.\) needs a Vector"),
        (lambda: box(math.nan, 1.0, 1.0), r"box\(\.\.\., x=\.\.\.\): nan is not a finite number; give a"),
        (lambda: box(1.0, math.inf, 1.0), r"box\(\.\.\., y=\.\.\.\): inf is not a finite number"),
        (lambda: box(1.0, 1.0, 1.0).at(y=math.nan), r"translate\(\.\.\., offset=\.\.\.\): nan is not a"),
        (
            lambda: row((0, 0, 0), np.array([0, math.inf, 0]), 3),
            r"row\(\.\.\., \w+=\.\.\.\): inf is not a finite number",
        ),
        (
            lambda: Float.parameter("a") * math.nan,
            r"multiply\(\.\.\., b=\.\.\.\): nan is not a finite number",
        ),
        (
            lambda: Revolute("a", axis=Z, limits=(0.0, math.nan)),
            r"joint\(\.\.\., limits=\.\.\.\): nan is not a finite number",
        ),
        (lambda: Revolute("a", axis=Z, effort=math.inf), r"joint\(\.\.\., effort=\.\.\.\): inf is not a"),
        (
            lambda: box(1.0, 1.0, 1.0) - circle(1.0),
            r"difference\(\.\.\., b=\.\.\.\) needs a Solid, got a Profile",
        ),
        (
            lambda: row((0, 0, 0), (1, 0, 0), Float.parameter("n")),
            r"needs an int, got a Float handle; it must be",
        ),
        (lambda: row((0, 0, 0), (1, 0, 0), 2.5), r"needs an int, got 2\.5"),
        (
            lambda: part(box(1.0, 1.0, 1.0), 7, material("oak")),
            r"part\(\.\.\., label=\.\.\.\) needs a str, got 7",
        ),
        (lambda: part(box(1.0, 1.0, 1.0), "a", "oak"), r"material=\.\.\.\) needs a Material, got 'oak'"),
        (lambda: Revolute("a", axis=Z, limits=(0.0,)), r"needs 2 values of Float or None, got \(0\.0,\)"),
        (lambda: Float.record("add", a=1.0), r"add needs the input 'b'"),
        (lambda: Float.record("add", a=1.0, b=1.0, c=1.0), r"add has no input 'c'"),
        (lambda: Float.parameter("a") + "b", r"unsupported operand"),
    ],
)
def test_wrong_values_are_refused_when_they_are_written(make, message):
    with pytest.raises((BuildError, TypeError), match=message) as caught:
        make()
    if isinstance(caught.value, BuildError):
        assert f"\n  at {__file__}:" in str(caught.value)


def test_a_structural_input_says_how_to_make_a_parameter_structural():
    with pytest.raises(BuildError, match="annotate the parameter int, str, bool or Literal"):
        row((0, 0, 0), (1, 0, 0), Float.parameter("count"))


def test_at_does_not_drop_numbers_after_a_vector():
    with pytest.raises(BuildError, match=r"a vector or three numbers.*\n.*\n.*vector \+ \(x, y, z\)"):
        box(1.0, 1.0, 1.0).at(Z, 1.0)
    with pytest.raises(BuildError, match="a vector or three numbers"):
        box(1.0, 1.0, 1.0).at((0, 0, 1), z=Float.parameter("a"))


def test_repr_names_type_operation_and_place():
    cut = box(1.0, 1.0, 1.0) - cylinder(0.1, 2.0)  # marker: repr
    assert repr(cut) == f"<Solid difference at {place_of(__file__, 'marker: repr')}>"


def test_handles_share_no_graph():
    a, b = Float.parameter("a"), Float.parameter("b")
    assert (a + 1.0).node.inputs["a"] is a.node
    assert list(b.node.children) == []


def test_a_joint_cannot_carry_a_requirement():
    with pytest.raises(BuildError, match=r"a Revolute cannot carry a requirement"):
        Revolute("a", axis=Z).require(Float.parameter("a") > 1.0, "no")


def test_every_handle_keeps_its_own_type_through_switch():
    condition = Float.parameter("a") > 1.0
    for name, handle in handles().items():
        if not isinstance(handle, Joint):
            assert type(switch(condition, handle, handle)).__name__ == name


def test_body_and_profile_are_not_interchangeable():
    with pytest.raises(BuildError, match=r"attach\(\.\.\., child=\.\.\.\) needs a Body, got a Solid handle"):
        part(box(1.0, 1.0, 1.0), "a", material("oak")).attach(box(1.0, 1.0, 1.0), Revolute("t", axis=Z))
    assert Body.value_type is not Profile.value_type
