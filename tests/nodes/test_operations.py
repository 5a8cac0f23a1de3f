"""Every registered operation: documented, spelled by a constructor, and kept by both round trips."""

import inspect
import sys

import numpy as np
import pytest

from artgen import signals
from artgen.asset import Curve, Outline, Shape, Tree
from artgen.graph import OPERATIONS, Graph
from artgen.nodes import joint as joints
from artgen.nodes.fitting import Fitting
from artgen.nodes.handles import Array3, ArrayN3, Body, Bool, Float, Path, Points, Profile, Solid, Vector
from artgen.nodes.joint import Condition, Dependency
from artgen.nodes.region import Region
from support.operations import OVERRIDES, PARAMETERS, sample

METHODS = {
    "absolute": Float.__abs__,
    "add": Float.__add__,
    "align": Solid.align,
    "allow_contact": Body.allow_contact,
    "along": Path.points,
    "copies": Body.repeat,
    "enclosed_by": Path.profile,
    "anchor": Solid.anchor,
    "and_": Bool.__and__,
    "area": Solid.area,
    "at_least": Float.__ge__,
    "at_most": Float.__le__,
    "attach": Body.attach,
    "attach_pair": Body.attach_pair,
    "box_between": Region.box,
    "cut": Body.cut,
    "mounted": Fitting.moving,
    "bounds": Solid.bounds,
    "center_of_mass": Body.center_of_mass,
    "centroid": Solid.centroid,
    "condition_all": Condition.__and__,
    "condition_any": Condition.__or__,
    "coupling": joints.Joint.__mul__,
    "coupling_scale": joints.Coupling.__mul__,
    "coupling_shift": joints.Coupling.__add__,
    "cross": Vector.cross,
    "dependency": Condition.until,
    "dependency_beyond": Dependency.beyond,
    "dependency_until": Dependency.until,
    "difference": Solid.__sub__,
    "divide": Float.__truediv__,
    "dot": Vector.dot,
    "floor": Float.__floor__,
    "gear": joints.Joint.gear,
    "greater": Float.__gt__,
    "intersection": Solid.__and__,
    "joint_above": joints.Joint.__gt__,
    "joint_below": joints.Joint.__lt__,
    "less": Float.__lt__,
    "loop": Body.loop,
    "mass": Body.mass,
    "mirror": Solid.mirror,
    "mirror_body": Body.mirror,
    "modulo": Float.__mod__,
    "multiply": Float.__mul__,
    "negate": Float.__neg__,
    "norm": Vector.norm,
    "normalize": Vector.normalized,
    "not_": Bool.__invert__,
    "offset": Profile.offset,
    "output": Body.output,
    "or_": Bool.__or__,
    "paint": Solid.paint,
    "points_move": Points.__add__,
    "points_scale": Points.__mul__,
    "power": Float.__pow__,
    "profile_difference": Profile.__sub__,
    "profile_intersection": Profile.__and__,
    "profile_mirror": Profile.mirror,
    "profile_rotate": Profile.rotate,
    "profile_scale": Profile.scale,
    "profile_translate": Profile.at,
    "profile_union": Profile.__or__,
    "rack": joints.Joint.rack,
    "repeat": Body.repeat,
    "rotate": Solid.rotate,
    "rotate_body": Body.rotate,
    "round_": Float.__round__,
    "scale": Solid.scale,
    "signal_all": signals.Signal.__and__,
    "signal_any": signals.Signal.__or__,
    "signal_not": signals.Signal.__invert__,
    "signal_scaled": signals.Signal.__mul__,
    "signal_where": signals.Signal.lift,
    "size": Solid.size,
    "split": Solid.split,
    "fillet": Solid.fillet,
    "subtract": Float.__sub__,
    "suffix": Body.suffixed,
    "translate": Solid.at,
    "translate_body": Body.at,
    "vector_add": Vector.__add__,
    "vector_rotate": Vector.rotate,
    "vector_scale": Vector.__mul__,
    "vector_subtract": Vector.__sub__,
    "volume": Solid.volume,
}
"""The handles' methods that record operations without a constructor of their own."""

TESTED = sorted(name for name, known in OPERATIONS.items() if known.module.startswith("artgen."))


def test_all_operations_are_here():
    assert len(TESTED) > 100
    assert set(OVERRIDES) <= set(TESTED), "OVERRIDES names operations that are no more"
    assert set(METHODS) <= set(TESTED), "METHODS names operations that are no more"


@pytest.mark.parametrize("name", TESTED)
def test_an_author_can_write_it_and_read_what_it_does(name):
    known = OPERATIONS[name]
    constructor = getattr(sys.modules[known.module], known.constructor, None)
    if constructor is None:
        assert name in METHODS, f"{name} has neither a constructor in {known.module} nor an entry in METHODS"
        constructor = METHODS[name]
    documentation = inspect.getdoc(constructor) or ""
    assert documentation, f"{constructor.__qualname__} needs a docstring"
    assert documentation.partition("\n")[0].rstrip().endswith("."), "the first line is a sentence"


@pytest.mark.parametrize("name", TESTED)
def test_constructors_take_the_inputs_by_their_names(name):
    known = OPERATIONS[name]
    constructor = getattr(sys.modules[known.module], known.constructor, None)
    if constructor is not None:
        taken = inspect.signature(constructor).parameters
        assert set(known.inputs) == set(taken)


@pytest.mark.parametrize("name", TESTED)
def test_json_keeps_the_key(name):
    graph = Graph(sample(name))
    again = Graph.from_json(graph.to_json())
    assert again.key == graph.key
    assert type(again.result) is type(graph.result)
    assert again.to_json() == graph.to_json()


@pytest.mark.parametrize("name", TESTED)
def test_python_source_keeps_the_key(name):
    graph = Graph(sample(name))
    source = graph.to_python()
    namespace: dict = {}
    exec(compile(source, "<source>", "exec"), namespace)  # noqa: S102 - the source is what is tested
    again = namespace["build"]()
    assert again.node.key == graph.key, source
    assert isinstance(again, type(graph.result))


@pytest.mark.parametrize("name", TESTED)
def test_it_can_be_drawn(name):
    graph = Graph(sample(name))
    assert f"n{len(graph.nodes) - 1}" in graph.to_mermaid()
    assert f" {name} " in graph.table()


VALUES = {
    float: float,
    bool: bool,
    Array3: np.ndarray,
    ArrayN3: np.ndarray,
    Shape: Shape,
    Outline: Outline,
    Curve: Curve,
    Tree: Tree,
}


@pytest.mark.parametrize("name", TESTED)
def test_its_value_is_of_the_type_that_it_declares(name):
    result = OPERATIONS[name].result
    value = Graph(sample(name)).evaluate(PARAMETERS).value
    assert isinstance(value, VALUES.get(result, result if isinstance(result, type) else np.ndarray))
    if result is Array3:
        assert value.shape == (3,)
    if result is ArrayN3:
        assert value.ndim == 2
        assert value.shape[1] == 3


def test_handles_of_one_type_spell_one_way():
    for handle, name in ((Body, "part"), (Vector, "vector"), (Points, "row")):
        assert type(sample(name)) is handle
