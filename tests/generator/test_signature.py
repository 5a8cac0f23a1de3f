"""Signatures are checked when they are decorated."""

import inspect
from typing import Literal

import numpy as np
import pytest

from artgen.errors import BuildError, ParameterError
from artgen.generator import CATEGORIES, Generator, category, generator, one_of
from artgen.generator.signature import RESERVED
from artgen.graph import evaluate
from artgen.materials import MATERIALS, Material, material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Bool, Float, Solid, Vector
from artgen.nodes.primitive import box
from artgen.nodes.vector import Z
from artgen.sampling import Fixed, by, choice, count, fixed, given, uniform
from support.generators import OAK, block, door, knob, lever


def body(**inputs) -> Body:
    return block()


def declared(annotation, default=inspect.Parameter.empty, name="x", **others):
    """Return a function with one parameter (and structural others)."""

    def made(**inputs):
        return block()

    parameters = {name: (annotation, default), **others}
    made.__signature__ = inspect.Signature(
        [
            inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=value)
            for key, (_, value) in parameters.items()
        ]
    )
    made.__annotations__ = {key: kind for key, (kind, _) in parameters.items() if kind is not None}
    return made


MISMATCHED = {
    "no annotation": (declared(None, 1.0), r"made\(x: ...\) has no annotation; annotate it Float, int, str"),
    "uniform for int": (
        declared(int, uniform(1, 4)),
        r"annotated int, but uniform\(1, 4\) is drawn from numbers: ann",
    ),
    "uniform for Bool": (
        declared(Bool, uniform(0, 1)),
        r"annotated Bool, but uniform\(0, 1\) is drawn from numbers",
    ),
    "words for Float": (
        declared(Float, choice("a", "b")),
        r"but choice\('a', 'b'\) has values that are not a number",
    ),
    "words for int": (declared(int, choice(1, "b")), "has values that are not a whole number"),
    "fractions for int": (
        declared(int, 2.5),
        r"annotated int, but 2\.5 has values that are not a whole number",
    ),
    "truth for int": (declared(int, True), "annotated int, but True has values that are not a whole number"),
    "truth for Float": (declared(Float, choice(True, False)), "has values that are not a number"),
    "numbers for str": (declared(str, count(1, 3)), "annotated str, but .* has values that are not a string"),
    "another option": (
        declared(Literal["a", "b"], choice("a", "c")),
        "has values that are not one of 'a', 'b'",
    ),
    "1 for True": (declared(Literal[True], 1), "has values that are not one of True"),
    "unknown material": (
        declared(Material, "oka"),
        "annotated Material, but 'oka' has values that are not a material",
    ),
    "a string for a generator": (declared(Generator, "knob"), "annotated Generator, but 'knob'"),
    "two numbers for Vector": (declared(Vector, (1.0, 2.0)), "has values that are not three numbers"),
    "a plain float": (
        declared(float, uniform(0, 1)),
        r"annotated float, but .*annotate it Float, Bool, Vector, int",
    ),
    "a Solid": (declared(Solid, uniform(0, 1)), "annotated Solid, but .* cannot give that type"),
    "a list": (declared(list[int], choice(1)), r"annotated list.*cannot give that type"),
    "a handle of another type": (declared(Float, Z), "annotated Float, but its default is a Vector"),
    "one case wrong": (
        declared(Float, by("k", a=uniform(0, 1), b="x"), k=(str, choice("a", "b"))),
        "has values that are not a number",
    ),
    "by of nothing": (
        declared(Float, by("k", a=1.0)),
        r"by\('k', ...\) needs a structural parameter .*; 'k' is none",
    ),
    "by of a socket": (declared(Float, by("k", a=1.0), k=(Float, 1.0)), "needs a structural parameter"),
    "by of an input": (
        declared(Float, by("k", a=1.0), k=(str, inspect.Parameter.empty)),
        "needs a structural parameter",
    ),
    "by with a case missing": (
        declared(Float, by("k", a=1.0), k=(Literal["a", "b"], choice("a"))),
        r"by\('k', ...\) has no case for 'b'; give one for each value, or otherwise=... Cases: a",
    ),
    "by with a case that is no option": (
        declared(Float, by("k", a=1.0, bb=2.0, otherwise=3.0), k=(Literal["a", "b"], choice("a"))),
        r"by\('k', bb=...\) never applies: k is Literal\['a', 'b'\]\. Did you mean 'b'\?",
    ),
    "by with a case that is no truth value": (
        declared(Float, by("k", yes=1.0, otherwise=3.0), k=(bool, choice(True, False))),
        r"by\('k', yes=...\) never applies: k is bool",
    ),
    "by of a generator with a case missing": (
        declared(Float, by("k", lever=1.0), k=(Generator, one_of(lever, knob))),
        "has no case for 'knob'",
    ),
    "by in a circle": (
        declared(int, by("k", otherwise=1), k=(int, by("x", otherwise=1))),
        "the parameters x, k depend on each other",
    ),
    "reserved": (
        declared(Float, 1.0, name="seed"),
        r"'seed' is reserved for generate\(\); choose another name",
    ),
    "double underscore": (
        declared(Float, 1.0, name="a__b"),
        "the double underscore means a dot; choose another name",
    ),
    "variadic": (body, r"body\(inputs: ...\) cannot be given by keyword; name every parameter"),
}


def test_all_options_of_generate_are_reserved():
    _, *options, overrides = inspect.signature(Generator.generate).parameters
    assert {*options, overrides} == set(RESERVED)


@pytest.mark.parametrize("name", MISMATCHED)
def test_a_signature_that_cannot_be_drawn_is_refused_at_import(name):
    function, message = MISMATCHED[name]
    with pytest.raises(BuildError, match=message) as caught:
        generator(function)
    assert f"\n  at {__file__}:" in str(caught.value)


def test_by_may_depend_on_a_generator():
    made = generator(declared(Float, by("k", lever=1.0, knob=2.0), k=(Generator, one_of(lever, knob))))
    assert made.sample(0, overrides={"k": "knob"})["x"] == 2.0
    assert made.sample(0, overrides={"k": lever})["x"] == 1.0


def test_plain_defaults_are_fixed_until_overridden():
    made = generator(declared(Material, "oak"))
    assert made.sample(0)["x"] is MATERIALS["oak"]
    assert made.sample(0, overrides={"x": "pine"})["x"] is MATERIALS["pine"]
    assert isinstance(made.parameters()["x"].distribution, Fixed)


def test_parameters_are_listed_with_those_of_sub_generators():
    listed = door.parameters()
    assert list(listed)[:2] == ["width", "height"]
    assert "handle.lever.grip.square_grip.width" in listed
    assert listed["handle.lever.length"].distribution.unit == "m"
    assert listed["panels"].structural
    assert listed["handle"].structural
    assert not listed["offset"].structural


def test_a_generator_keeps_the_functions_name_and_words():
    @generator
    def toy() -> Body:
        """Make a toy."""
        return block()

    assert (toy.name, toy.__name__, toy.__doc__) == ("toy", "toy", "Make a toy.")
    assert repr(toy).startswith("<generator toy at ")


def test_one_of_takes_generators_of_different_names():
    with pytest.raises(ParameterError, match="one_of chooses between generators; 'lever' is none"):
        one_of(lever, "lever")
    with pytest.raises(ParameterError, match="two generators are named 'lever'; rename one"):
        one_of(lever, generator(lever.function))
    with pytest.raises(ParameterError, match="at least one option"):
        one_of()


@pytest.fixture
def catalog():
    before = dict(CATEGORIES)
    yield CATEGORIES
    CATEGORIES.clear()
    CATEGORIES.update(before)


def test_a_category_enters_the_catalog(catalog):
    @category(labels=("block",))
    def bench(*, size: Float = uniform(0.1, 0.2)) -> Body:
        return part(box(size, size, size), "block", OAK)

    assert catalog["bench"] is bench
    assert bench.labels == ("block",)
    assert bench.generate(1).labels == ("block",)


def test_a_category_needs_no_inputs_and_returns_a_body(catalog):
    with pytest.raises(BuildError, match=r"made\(x: ...\): a category has no inputs; give it a distribution"):
        category(labels=())(declared(Float))

    def solid() -> Solid:
        return box(1.0, 1.0, 1.0)

    with pytest.raises(BuildError, match="solid returns Solid; a category returns a Body"):
        category(labels=())(solid)
    assert not {"made", "solid"} & set(catalog)


def test_two_modules_cannot_define_one_category(catalog):
    def bench() -> Body:
        return block()

    def other() -> Body:
        return block()

    other.__name__, other.__module__ = "bench", "elsewhere"
    first = category(labels=("block",))(bench)
    with pytest.raises(
        BuildError, match=r"the category 'bench' is defined twice, at .*test_signature.py:\d+ and"
    ):
        category(labels=("block",))(other)
    assert catalog["bench"] is first
    again = category(labels=("block",))(bench)
    assert catalog["bench"] is again


def test_the_names_of_artgens_categories_are_taken_before_they_are_imported(catalog):
    def drawer() -> Body:
        return block()

    with pytest.raises(
        BuildError, match=r"'drawer' is a category of artgen; rename the category\n  at .*test_signature"
    ):
        category(labels="block")(drawer)
    assert not catalog.get("drawer") or catalog["drawer"].function is not drawer


def test_a_category_has_a_name_for_files(catalog):
    def tin() -> Body:
        return block()

    tin.__name__ = "büchse"
    with pytest.raises(
        BuildError, match=r"'büchse' cannot name a category; use ASCII letters.*\n  at .*test_signature"
    ):
        category(labels="block")(tin)


@pytest.mark.parametrize("value", [None, "handle", lever])
def test_a_generator_is_made_of_a_function(value: object) -> None:
    with pytest.raises(
        BuildError, match=r"made of a function, not of .*: write @generator before it\n  at .*"
    ):
        generator(value)  # type: ignore[arg-type]


def test_an_input_with_a_default_is_no_parameter():
    @generator
    def block(size: Float = given(0.2), height: Float = fixed(0.1, "m", within=(0.05, 0.5))) -> Body:
        return part(box(size, size, height), "block", material("oak"))

    assert list(block.parameters()) == ["height"]
    assert block.generate(0).parameters == {"height": 0.1}
    with pytest.raises(ParameterError, match="block has no parameter 'size'"):
        block.generate(0, size=0.3)
    larger = block.build({"height": 0.1}, size=0.3)
    assert np.ptp(evaluate(larger, {"height": 0.1}).value.link.bounds(), axis=0)[0] == pytest.approx(0.3)
    with pytest.raises(ParameterError, match=r"height = 0\.6 is out of range: 0\.05 to 0\.5 m"):
        block.generate(0, height=0.6)


def test_an_error_names_the_whole_numbers_that_are_never_drawn():
    @generator
    def stairs(steps: int = choice(3, 2), rails: int = count(1, 12)) -> Body:
        return part(box(0.2, 0.2, {2: 0.3, 3: 0.5}[steps] + 0.6 / rails), "block", material("oak"))

    assert stairs.generate(0, rails=13, certify=False).parameters["rails"] == 13
    for given_values, told in (
        ({"steps": 4}, r"KeyError: 4; steps = 4 is not one of its options: 2, 3\n  at .*test_signature"),
        ({"rails": 0}, r"zero; rails = 0 is not one of its options: 1, 2, 3, 4, 5, 6, 7, 8 to 12\n"),
    ):
        with pytest.raises(BuildError, match=told):
            stairs.generate(0, **given_values)
