"""Choosing by a condition, and requirements."""

import numpy as np
import pytest

from artgen.errors import BuildError, InfeasibleError
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Bool, Float, Path, Points, Profile, Solid, Vector
from artgen.nodes.joint import Revolute
from artgen.nodes.path import line
from artgen.nodes.primitive import box, sphere
from artgen.nodes.profile import circle, rectangle
from artgen.nodes.scalar import require, switch
from artgen.nodes.vector import X, Z, points
from support.lines import place_of

A = Float.parameter("a")


def value(handle, a):
    return evaluate(handle, {"a": a}).value


@pytest.mark.parametrize(
    ("first", "second", "kind"),
    [
        (1.0, 2, Float),
        (A, 2.0, Float),
        (True, False, Bool),
        (A < 3.0, True, Bool),
        (X, (0, 0, 2), Vector),
        ((1, 0, 0), (0, 0, 2), Vector),
        ((A, 0, 0), (0, 0, 2), Vector),
        (np.eye(3)[0], (0, 0, 2), Vector),
        (points(X), [(0, 0, 1)], Points),
        ([(0, 0, 1), (1, 1, 1)], [(0, 0, 1)], Points),
        (circle(1.0), rectangle(1.0, 1.0), Profile),
        (line(X, Z), line(Z, X), Path),
        (box(1.0, 1.0, 1.0), sphere(1.0), Solid),
    ],
)
def test_any_kind_of_value_can_be_chosen(first, second, kind):
    chosen = switch(A > 1.0, first, second)
    assert type(chosen) is kind
    same = type(chosen).record(chosen.node.op, condition=A > 1.0, a=first, b=second)
    assert chosen.node.key == same.node.key


def test_the_condition_decides():
    assert value(switch(A > 1.0, 10.0, 20.0), 2.0) == 10.0
    assert value(switch(A > 1.0, 10.0, 20.0), 0.0) == 20.0
    assert value(switch(True, A, 20.0), 5.0) == 5.0
    assert value(switch(A > 1.0, X, (A, 1, 2)), 0.5).tolist() == [0.5, 1.0, 2.0]


def test_bodies_can_be_chosen():
    oak = material("oak")
    small, large = part(box(1.0, 1.0, 1.0), "small", oak), part(box(2.0, 1.0, 1.0), "large", oak)
    chosen = switch(A > 1.0, large.attach(small, Revolute("turn", axis=Z)), small)
    assert [link.name for link in value(chosen, 2.0).links()] == ["large", "small"]
    assert [link.name for link in value(chosen, 0.0).links()] == ["small"]


def test_the_two_must_be_of_one_type():
    with pytest.raises(BuildError, match=r"switch_solid\(..., b=...\) needs a Solid, got a Profile handle"):
        switch(A > 1.0, box(1.0, 1.0, 1.0), circle(1.0))
    with pytest.raises(BuildError, match=r"switch_float\(..., b=...\) needs a Float, got \(1, 2, 3\)"):
        switch(A > 1.0, A, (1, 2, 3))
    with pytest.raises(BuildError, match=r"needs a Float, got 'left'"):
        switch(A > 1.0, "left", "right")


def test_joints_cannot_be_chosen():
    turn = Revolute("turn", axis=Z)
    with pytest.raises(
        BuildError, match=r"switch chooses between values of Float, .*Body, not Revolute\n  at .*test_choose"
    ):
        switch(A > 1.0, turn, turn)


def test_the_condition_is_a_bool():
    with pytest.raises(BuildError, match=r"condition=...\) needs a Bool, got a Float handle"):
        switch(A, 1.0, 2.0)


def test_require_on_a_value():
    for made in (A.require(A > 1.0, "no"), require(A, A > 1.0, "no"), A + require(0.0, A > 1.0, "no")):
        assert value(made, 2.0) == 2.0
        with pytest.raises(InfeasibleError, match=r"no\n  at .*test_choose\.py:"):
            value(made, 0.5)


def test_require_keeps_the_type():
    solid = box(1.0, 1.0, 1.0)
    assert type(solid.require(A > 1.0, "no")) is Solid
    assert type(require((1, 2, 3), A > 1.0, "no")) is Vector
    assert type(require(solid, A > 1.0, "no")) is Solid


def test_require_on_what_is_known_while_building():
    assert require(True, "fine") is None
    assert require(np.True_, "fine") is None
    with pytest.raises(InfeasibleError) as caught:
        require(False, "one is not above two")  # marker: known
    assert str(caught.value) == f"one is not above two\n  at {place_of(__file__, 'marker: known')}"


def test_a_requirement_that_nothing_reaches_is_refused():
    with pytest.raises(
        BuildError, match=r"no value carries it\n  at .*\n  Attach it to a value: return body\.require"
    ):
        require(A > 1.0, "no")


def test_require_needs_a_condition():
    with pytest.raises(BuildError, match=r"require needs a condition, got 3"):
        require(3, "no")
