"""A changed parameter recomputes only what depends on it, counted in kernels."""

import pathlib
from functools import partial

import pytest

from artgen.catalog import find, load_file
from artgen.graph import OPERATIONS, Cache, Handle
from artgen.nodes.handles import Path, Profile, Solid

SEED = 3
FIXED = {"opener": "lever", "handle.style": "wave", "layout": "single", "stock": "made_to_measure"}
GEOMETRY = {
    name
    for name, operation in OPERATIONS.items()
    if Handle.HANDLES.get(operation.result) in {Solid, Profile, Path}
}


@pytest.fixture(scope="module")
def door() -> tuple[Cache, dict[str, float], int]:
    """A cache that has seen one latched door, its parameters, and how many kernels that took."""
    cache = Cache()
    asset, evaluation = find("door").evaluate(SEED, cache=cache, overrides=FIXED, keep_graph=True)
    return cache, dict(asset.parameters), sum(evaluation.runs.values())


def again(door: tuple[Cache, dict[str, float], int], **changed: float) -> dict[str, int]:
    overrides = {**FIXED, **changed}
    return dict(find("door").evaluate(SEED, cache=door[0], overrides=overrides, keep_graph=True)[1].runs)


def test_a_limit_runs_no_geometry_kernel(door: tuple[Cache, dict[str, float], int]) -> None:
    runs = again(door, swing=1.77)
    assert runs, "something must have changed"
    assert not GEOMETRY & set(runs), runs
    assert sum(runs.values()) <= 8, runs


def test_a_width_runs_only_what_depends_on_it(door: tuple[Cache, dict[str, float], int]) -> None:
    runs = again(door, width=door[1]["width"] + 0.01)
    assert GEOMETRY & set(runs), "a wider door has other solids"
    assert sum(runs.values()) < 0.6 * door[2], (sum(runs.values()), door[2])
    # the lever, its spindle and the latch do not know how wide the leaf is
    assert not {"spline", "ellipse", "dome", "coupling"} & set(runs), runs


def test_nothing_runs_when_nothing_changes(door: tuple[Cache, dict[str, float], int]) -> None:
    assert again(door) == {}


def test_only_a_structural_value_builds_the_graph_again(monkeypatch: pytest.MonkeyPatch) -> None:
    crate = load_file(pathlib.Path(__file__).parent / "support" / "crate.py")
    calls = []
    evaluate = partial(crate.evaluate, 1, cache=Cache(), certify=False, keep_graph=True)
    function = crate.function
    monkeypatch.setattr(crate, "function", lambda **given: calls.append(given) or function(**given))
    plain = {"handle": "bar", "finish": "plain"}
    first = evaluate(overrides=plain)[0]
    for overrides in ({"width": 0.31}, {"swing": 1.1}, {"handle.length": 0.09}):
        asset = evaluate(overrides=plain | overrides)[0]
        assert asset.parameters != first.parameters
    assert len(calls) == 1
    raised = evaluate(overrides=plain | {"finish": "raised"})[0]
    assert len(calls) == 2
    assert raised.link("lid").bounds()[1, 2] >= first.link("lid").bounds()[1, 2]
    assert raised.mass > first.mass
