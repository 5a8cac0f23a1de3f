"""Evaluation: once for equal subgraphs, again only for what a parameter changes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import EvaluationError, GraphError, InfeasibleError
from artgen.graph import OPERATIONS, Cache, Graph, evaluate, kernel
from artgen.nodes.handles import Float, Points, Vector
from artgen.nodes.primitive import box
from artgen.nodes.scalar import max_, sqrt, switch
from artgen.nodes.vector import points, vector
from support.lines import place_of


def test_equal_subgraphs_are_computed_once():
    width = Float.parameter("width")
    a = box(width, 1.0, 1.0).at(1.0)
    b = box(width, 1.0, 1.0).at(2.0)
    result = evaluate(a | b, {"width": 0.5})
    assert result.runs["box"] == 1
    assert result.runs["translate"] == 2


def test_a_changed_parameter_recomputes_only_what_depends_on_it():
    width, depth = Float.parameter("width"), Float.parameter("depth")
    root = (box(width, 1.0, 1.0) | box(depth, 1.0, 1.0).at(2.0)).volume()
    cache = Cache()
    first = evaluate(root, {"width": 0.5, "depth": 0.25}, cache)
    assert first.hits == 0
    again = evaluate(root, {"width": 0.5, "depth": 0.25}, cache)
    assert not again.runs
    assert again.value == first.value
    changed = evaluate(root, {"width": 0.7, "depth": 0.25}, cache)
    assert changed.runs == {"box": 1, "union": 1, "volume": 1}
    assert changed.value == pytest.approx(0.95)


def test_the_cache_serves_graphs_that_share_parts():
    cache = Cache()
    evaluate(box(1.0, 1.0, 1.0).volume(), cache=cache)
    assert evaluate(box(1.0, 1.0, 1.0).at(1.0), cache=cache).runs == {"translate": 1}


def test_a_parameter_and_a_literal_of_one_value_share_nothing_wrong():
    cache = Cache()
    a = evaluate(Float.parameter("a") + 1.0, {"a": 2.0}, cache).value
    b = evaluate(Float.parameter("a") + 1.0, {"a": 3.0}, cache).value
    assert (a, b) == (3.0, 4.0)


@pytest.mark.parametrize(
    ("width", "expected"), [(0.5, {"sphere": 0, "box": 1}), (2.0, {"sphere": 1, "box": 0})]
)
def test_switch_computes_the_chosen_branch_only(width, expected):
    from artgen.nodes.primitive import sphere

    number = Float.parameter("width")
    root = switch(number > 1.0, sphere(0.3), box(0.3, 0.3, number)).volume()
    runs = evaluate(root, {"width": width}).runs
    assert {name: runs[name] for name in expected} == expected


def test_the_branch_that_is_not_chosen_may_be_impossible():
    number = Float.parameter("a")
    root = switch(number < 0.0, 0.0, sqrt(number))
    assert evaluate(root, {"a": -4.0}).value == 0.0
    assert evaluate(root, {"a": 4.0}).value == 2.0


def test_a_kernels_error_names_operation_reason_and_line():
    root = sqrt(Float.parameter("a") - 5.0)  # marker: sqrt
    with pytest.raises(EvaluationError) as caught:
        evaluate(root + 1.0, {"a": 1.0})
    assert str(caught.value) == f"sqrt failed: square root of -4\n  at {place_of(__file__, 'marker: sqrt')}"
    assert isinstance(caught.value.__cause__, ValueError)


def test_a_geometry_kernels_error_names_the_line():
    root = box(1.0, 1.0, 1.0).at(1.0) | box(Float.parameter("a"), 1.0, 1.0)  # marker: box
    with pytest.raises(EvaluationError, match=r"box failed: .*-1") as caught:
        evaluate(root, {"a": -1.0})
    assert place_of(__file__, "marker: box") in str(caught.value)


def test_a_result_that_is_not_finite_is_an_error():
    big = Float.parameter("a") * 1e300  # marker: overflow
    with pytest.raises(EvaluationError, match="multiply gives inf, which is not a finite number") as caught:
        evaluate(big, {"a": 1e300})
    assert place_of(__file__, "marker: overflow") in str(caught.value)
    far = vector(1e300) * Float.parameter("a")
    with (
        np.errstate(over="ignore"),
        pytest.raises(EvaluationError, match=r"vector_scale gives .* not finite"),
    ):
        evaluate(far, {"a": 1e300})


def test_a_requirement_that_fails_names_message_and_line():
    number = Float.parameter("a")
    root = number.require(number > 1.0, "too small")  # marker: require
    with pytest.raises(InfeasibleError) as caught:
        evaluate(root, {"a": 0.5})
    assert str(caught.value) == f"too small\n  at {place_of(__file__, 'marker: require')}"
    assert evaluate(root, {"a": 1.5}).value == 1.5


def test_a_missing_parameter_is_named():
    root = Float.parameter("width") + 1.0  # marker: missing
    with pytest.raises(EvaluationError, match="parameter 'width' has no value") as caught:
        evaluate(root)
    assert place_of(__file__, "marker: missing") in str(caught.value)


@pytest.mark.parametrize(
    ("handle", "value"),
    [
        (Float.parameter("a"), "wide"),
        (Float.parameter("a"), True),
        (Float.parameter("a"), None),
        (Float.parameter("a"), Float.parameter("b")),
        (Vector.parameter("a"), (1.0, 2.0)),
        (Vector.parameter("a"), 1.0),
        (Points.parameter("a"), ()),
    ],
)
def test_a_parameter_of_the_wrong_type_is_refused(handle, value):
    with pytest.raises(
        EvaluationError, match=f"parameter 'a' needs the value of a {type(handle).__name__}, got"
    ):
        evaluate(handle, {"a": value})


def test_a_parameter_that_is_not_finite_is_refused():
    with pytest.raises(EvaluationError, match="parameter 'a' needs the value of a Float, got nan"):
        evaluate(Float.parameter("a"), {"a": float("nan")})


def test_vector_and_points_parameters_reach_kernels_as_arrays():
    root = Vector.parameter("v") + (1, 0, 0)
    assert evaluate(root, {"v": (1, 2, 3)}).value.tolist() == [2.0, 2.0, 3.0]
    many = np.arange(6000.0).reshape(-1, 3)
    cache = Cache()
    moved = Points.parameter("p") + (1, 0, 0)
    assert evaluate(moved, {"p": many}, cache).value[1500, 1] == many[1500, 1]
    many[1500, 1] = -1.0
    assert evaluate(moved, {"p": many}, cache).value[1500, 1] == -1.0


def test_values_that_nodes_share_cannot_be_written():
    value = evaluate(points((0, 0, 0), (1, 0, 0))).value
    with pytest.raises(ValueError, match="read-only"):
        value[0, 0] = 5.0


def test_the_cache_forgets_the_least_recently_used():
    cache = Cache(capacity=2)
    cache.put("a", 1)
    cache.put("b", 2)
    assert cache.get("a") == 1
    cache.put("c", 3)
    assert "b" not in cache
    assert cache.get("b", "gone") == "gone"
    assert [cache.get("a"), cache.get("c"), len(cache)] == [1, 3, 2]


def test_a_small_cache_changes_no_result():
    root = Float.parameter("a")
    for step in range(30):
        root = max_(root * 0.5, root - float(step))
    big = evaluate(root, {"a": 1.5}, Cache(1000))
    small = evaluate(root, {"a": 1.5}, Cache(1))
    none = evaluate(root, {"a": 1.5}, Cache(0))
    assert big.value == small.value == none.value
    assert big.runs == small.runs == none.runs


@pytest.mark.parametrize("length", [5000])
def test_deep_chains_do_not_recurse(length):
    root = Float.parameter("a")
    for _ in range(length):
        root = root + 1.0
    graph = Graph(root)
    assert graph.evaluate({"a": 0.5}).value == length + 0.5
    assert Graph.from_json(graph.to_json()).key == graph.key
    namespace: dict = {}
    exec(graph.to_python(), namespace)  # noqa: S102 - the source is what is tested
    assert namespace["build"]().node.key == graph.key
    assert graph.to_mermaid().count("-->") == length
    assert "add" in graph.table()


@given(a=st.floats(-1e6, 1e6), b=st.floats(-1e6, 1e6))
def test_evaluation_agrees_with_python(a, b):
    x, y = Float.parameter("x"), Float.parameter("y")
    root = max_(x + y, x * y) - abs(y) + 2.0 * x
    assert evaluate(root, {"x": a, "y": b}).value == max(a + b, a * b) - abs(b) + 2.0 * a


def test_costs_are_reported():
    result = evaluate(box(1.0, 1.0, 1.0).at(1.0) | box(1.0, 2.0, 1.0))
    assert set(result.seconds) == {"box", "translate", "union"}
    assert all(seconds >= 0.0 for seconds in result.seconds.values())
    assert len(result.node_seconds) == sum(result.runs.values())
    assert sum(result.node_seconds.values()) == pytest.approx(sum(result.seconds.values()))


def test_two_kernels_of_one_name_are_refused():
    def _add(a: float, b: float) -> float:
        return a + b

    with pytest.raises(
        GraphError, match=r"the operation 'add' is defined twice, in artgen\.nodes\.scalar and"
    ):
        kernel(_add)


def test_a_kernel_must_annotate_everything():
    def _unfinished(a, b: float) -> float:
        return b

    with pytest.raises(GraphError, match=r"the kernel 'unfinished' must annotate \['a'\]"):
        kernel(_unfinished)
    assert "unfinished" not in OPERATIONS
