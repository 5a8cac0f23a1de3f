"""The curated surface: what `import artgen` offers, and that it is whole."""

import builtins
import importlib
import inspect
import math
import re
import sys

import artgen
from artgen import feel
from artgen.graph import OPERATIONS

BY_METHOD = {"component", "joint", "points"}
"""Constructors that authors spell as properties of a handle or as classes."""


def test_all_is_sorted_without_doubles_and_exists() -> None:
    assert len(set(artgen.__all__)) == len(artgen.__all__)
    for name in artgen.__all__:
        assert hasattr(artgen, name), name


def test_all_names_every_public_object() -> None:
    public = {
        name
        for name, value in vars(artgen).items()
        if not name.startswith("_") and not inspect.ismodule(value)
    }
    assert public - set(artgen.__all__) == set()


def test_the_surface_is_small_and_hides_no_builtin() -> None:
    assert len(artgen.__all__) <= 110
    assert not set(artgen.__all__) & {*vars(builtins), *vars(math)} - {"atan2", "cos", "sin", "sqrt", "tan"}


def test_every_constructor_is_on_the_surface_or_a_method() -> None:
    recorded = {
        known.constructor
        for known in OPERATIONS.values()
        if re.fullmatch(r"artgen\.nodes\.\w+", known.module)  # without details
        if hasattr(sys.modules[known.module], known.constructor)
    }
    assert recorded - {*artgen.__all__, *feel.__all__} == BY_METHOD


def test_every_public_function_and_type_has_a_docstring() -> None:
    for name in artgen.__all__:
        value = getattr(artgen, name)
        if inspect.isfunction(value) or inspect.isclass(value):  # no aliases of types
            assert inspect.getdoc(value), name


def test_help_names_the_types_of_arguments_by_their_short_names() -> None:
    for name in artgen.__all__:
        value = getattr(artgen, name)
        if inspect.isfunction(value):
            shown = str(inspect.signature(value))
            assert not re.search(r"\bUnion\[|ForwardRef|artgen\.|numpy\.|collections\.", shown), (
                f"{name}{shown}: begin {value.__module__} with `from __future__ import annotations`"
            )
    assert "bevel: 'Scalar'" in str(inspect.signature(artgen.box))
    assert "at: 'VectorLike'" in str(inspect.signature(artgen.Body.attach))


def test_version_is_the_one_that_assets_carry() -> None:
    @artgen.generator
    def cube() -> artgen.Body:
        return artgen.part(artgen.box(0.1, 0.1, 0.1), "cube", artgen.material("oak"))

    assert cube.generate().version == artgen.__version__


def test_importing_the_categories_hides_no_function() -> None:
    importlib.import_module("artgen.categories")
    assert callable(artgen.generator)
    assert callable(artgen.catalog.categories)
    assert inspect.ismodule(artgen.categories)
