"""The graph of one sample has no nodes for known numbers; assets and errors are those of other graphs."""

import gc
import math
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.errors import ArtgenError, BuildError, EvaluationError, InfeasibleError, ParameterError
from artgen.export.files import encode
from artgen.generator import generator
from artgen.graph import Cache, Graph
from artgen.graph.handle import folding
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float, Vector
from artgen.nodes.primitive import box
from artgen.nodes.scalar import max_, require, sqrt, switch
from artgen.nodes.vector import points, row, vector
from artgen.sampling import uniform
from support.cases import some
from support.lines import place_of

NUMBERS = st.floats(-1e6, 1e6) | st.sampled_from([0.0, -0.0, 1.0, 0.5])


@pytest.mark.parametrize("category", some(categories(), 8))
@pytest.mark.parametrize("seed", [3])
def test_folding_changes_no_byte_of_an_asset(category, seed):
    evaluate = partial(find(category).evaluate, seed)
    folded, symbolic = (evaluate(cache=Cache(), keep_graph=keep)[0] for keep in (False, True))
    assert encode(folded, ("urdf",), textures=0) == encode(symbolic, ("urdf",), textures=0)
    assert folded.certificate == symbolic.certificate


def scalars(a, b):
    """Return expressions of two numbers of all kinds that fold."""
    arrow = vector(a, b, 1.0)
    return {
        "sum": (a + b) * 0.3 - a / 7.0,
        "choice": switch(a < b, a % 3.0, max_(a, -b)),
        "condition": (a <= b) & ~(a > 2.0 * b),
        "vector": arrow.normalized().cross((a, 1.0, b)) * b - arrow,
        "length": (arrow - (b, 0.0, 0.0)).norm() + arrow.dot(arrow),
        "component": arrow.rotate((0.0, 0.0, 1.0), a).y,
        "points": row(arrow, (0.1, b, 0.0), 3) * a + arrow,
        "list": points(arrow, (a, a, a)),
    }


@given(NUMBERS, NUMBERS)
def test_folded_values_are_the_evaluated_ones(a, b):
    with folding():
        folded = scalars(Float.socket("a", "", a), Float.socket("b", "", b))
    for name, handle in scalars(Float.parameter("a"), Float.parameter("b")).items():
        value = Graph(handle).evaluate({"a": a, "b": b}).value
        assert not hasattr(folded[name].node, "op"), name
        kind = type(handle)
        assert repr(kind.decode(folded[name].node)) == repr(value), name


def outcome(function, *, keep_graph):
    """Return the error of a generator, with its notes."""
    with pytest.raises(ArtgenError) as caught:
        generator(function).evaluate(0, cache=Cache(), attempts=1, keep_graph=keep_graph)
    return (
        type(caught.value),
        str(caught.value),
        caught.value.__notes__ if caught.type != InfeasibleError else [],
    )


def wrong(size):
    """Return a number that has no value: its operation fails."""
    return sqrt(-size)  # marker: fails


def block(size):
    return part(box(size, 1.0, 1.0), "block", material("oak"))


USES = {
    "number": (lambda size: block(float(size)), BuildError),
    "condition": (lambda size: block(1.0 if size > 0.1 else 2.0), BuildError),
    "equal": (lambda size: block(1.0 if size + 1.0 == 2.0 else 2.0), BuildError),
    "length": (lambda size: block(len(vector(size, 1.0, 1.0))), BuildError),
    "key": (lambda size: block({size: 1.0}[size]), BuildError),
    "body": (lambda size: size + 1.0, BuildError),
    "failure": (lambda size: block(2.0 + wrong(size)), EvaluationError),
    "infinite": (lambda size: block((size * 1e300) ** 3.0 * 1e300), EvaluationError),
    "required": (lambda size: block(require(size, size > 1.0, "too small") + 1.0), InfeasibleError),
    "type": (lambda size: block("wide"), BuildError),
}


@pytest.mark.parametrize("use", USES)
def test_errors_are_the_same(use):
    made, kind = USES[use]

    def toy(*, size: Float = uniform(0.1, 0.2)) -> Body:
        return made(size)

    folded, symbolic = (outcome(toy, keep_graph=keep) for keep in (False, True))
    assert folded == symbolic
    assert folded[0] is kind
    if use == "failure":
        assert place_of(__file__, "marker: fails") in folded[1]


def test_a_folded_handle_refuses_like_any_other():
    with folding():
        number = Float.socket("size", "", 0.5) * 2.0
        arrow = Vector.socket("arrow", "", (1.0, 2.0, 3.0))
    for use in (bool, float, int, hash, list, math.sin, lambda handle: handle == 1.0):
        for handle in (number, arrow):
            with pytest.raises(BuildError, match="has no value while the graph is being built"):
                use(handle)
    assert (repr(number), repr(arrow)) == ("<Float 1.0>", "<Vector (1.0, 2.0, 3.0)>")


def test_a_branch_that_is_not_chosen_is_not_evaluated():
    def toy(*, size: Float = uniform(0.1, 0.2)) -> Body:
        chosen = switch(size > 0.0, size, require(wrong(size), size > 1.0, "never"))
        return switch(size < 1.0, block(chosen), block(wrong(size)))

    assert generator(toy).generate(0).links[0].bounds()[1][0] > 0.05


def test_only_the_graph_of_a_single_sample_is_folded():
    door = find("door")
    with folding():
        folded = Graph(door.build(door.sample(3)))
    assert not folded.parameters
    assert len(folded.nodes) < 0.6 * len(door.graph(3).nodes)
    assert door.graph(3).parameters


def test_the_garbage_collector_is_paused_only_during_an_evaluation_or_an_export(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    during: list[bool] = []
    rounded = Asset.rounded

    def watched(asset: Asset) -> Asset:
        during.append(gc.isenabled())
        return rounded(asset)

    monkeypatch.setattr(Asset, "rounded", watched)

    @generator
    def probe() -> Body:
        """Make a block."""
        during.append(gc.isenabled())
        return part(box(0.1, 0.1, 0.1), "block", material("oak"))

    try:
        for enabled in (True, False):
            (gc.enable if enabled else gc.disable)()
            asset = probe.generate(0)
            assert gc.isenabled() is enabled
            encode(asset, ("urdf",), textures=0)
            assert gc.isenabled() is enabled
            with pytest.raises(ParameterError):
                probe.generate(-1)
            assert gc.isenabled() is enabled
    finally:
        gc.enable()
    assert during
    assert not any(during)
