"""The tree of errors, and the nearest name."""

import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen import errors
from artgen.errors import ArtgenError, AssetError, nearest

TREE = {
    "BuildError": ValueError,
    "GraphError": ValueError,
    "ParameterError": ValueError,
    "EvaluationError": RuntimeError,
    "InfeasibleError": RuntimeError,
    "AssetError": ValueError,
    "CheckError": RuntimeError,
    "ExportError": OSError,
    "ClientError": RuntimeError,
    "EnvError": RuntimeError,
    "RenderError": RuntimeError,
}


@pytest.mark.parametrize("name", TREE)
def test_each_error_is_also_the_natural_builtin(name):
    kind = getattr(errors, name)
    assert issubclass(kind, ArtgenError)
    assert issubclass(kind, TREE[name])
    assert f"── {name}" in errors.__doc__, "the tree is drawn in the module's docstring"


def test_the_tree_is_complete():
    found = {
        name
        for name, kind in vars(errors).items()
        if isinstance(kind, type) and issubclass(kind, ArtgenError)
    }
    assert found == {"ArtgenError", *TREE}


def test_a_graph_error_is_a_build_error():
    assert issubclass(errors.GraphError, errors.BuildError)


def test_an_asset_error_tells_what_it_is_about():
    error = AssetError("no", joint="hinge")
    assert (str(error), error.joint, error.link) == ("no", "hinge", "")
    again = pickle.loads(pickle.dumps(error))  # noqa: S301 - made just here
    assert (str(again), again.joint) == ("no", "hinge")


@pytest.mark.parametrize(
    ("name", "allowed", "expected"),
    [
        ("widht", ["width", "height"], " Did you mean 'width'?"),
        ("zzz", ["b", "a"], " Allowed: a, b."),
        ("zzz", [], ""),
        (
            "zzz",
            [f"name{index:02}" for index in range(14)],
            " Allowed: " + ", ".join(f"name{i:02}" for i in range(12)) + ", ....",
        ),
    ],
)
def test_the_nearest_name(name, allowed, expected):
    assert nearest(name, allowed) == expected


@given(st.sets(st.text(min_size=1), min_size=1, max_size=5))
def test_the_nearest_name_does_not_depend_on_order(names):
    ordered = sorted(names)
    assert nearest("width", ordered) == nearest("width", ordered[::-1]) == nearest("width", names)
