"""Drawing: no parameter disturbs another, and overrides are understood or refused."""

import inspect

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import ParameterError
from artgen.generator import Generator, generator, one_of
from artgen.materials import MATERIALS
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.joint import Revolute
from artgen.nodes.primitive import box
from artgen.nodes.vector import Z
from artgen.sampling import by, choice, uniform
from support.generators import OAK, STEEL, door, knob, lever, round_grip, square_grip


@given(seed=st.integers(0, 10**6))
def test_draws_are_of_the_annotated_types(seed):
    values = door.sample(seed)
    assert type(values["width"]) is type(values["swing"]) is float
    assert 0.75 <= values["width"] <= 1.05
    assert (1.4 <= values["swing"] <= 1.6) == (values["layout"] == "french")
    assert type(values["panels"]) is int
    assert type(values["glazed"]) is bool
    assert values["wood"] in (MATERIALS["oak"], MATERIALS["walnut"])
    assert values["offset"] == (0.0, 0.0, 0.5)
    assert values["handle"] in (lever, knob)
    assert ("handle.length" in values) == (values["handle"] is lever)
    if values["handle"] is lever:
        assert ("handle.grip.width" in values) == (values["handle.grip"] is square_grip)


def with_parameters(names, name="made"):
    """Make a generator with parameters of these names, in this order."""

    def function(**values):
        return sum(values.values(), Float.parameter("nothing"))

    made = [
        inspect.Parameter(each, inspect.Parameter.KEYWORD_ONLY, default=uniform(0.0, 1.0), annotation=Float)
        for each in names
    ]
    function.__name__ = name
    function.__signature__ = inspect.Signature(made)
    function.__annotations__ = dict.fromkeys(names, Float)
    return generator(function)


PARAMETER_NAMES = st.lists(st.sampled_from([f"p{index}" for index in range(12)]), min_size=1, unique=True)


@given(names=PARAMETER_NAMES, data=st.data(), seed=st.integers(0, 1000))
def test_adding_and_reordering_parameters_shifts_no_draw(names, data, seed):
    before = with_parameters(names).sample(seed)
    other = data.draw(st.permutations([*names, "added", "zzz"]))
    after = with_parameters(other).sample(seed)
    assert {name: after[name] for name in names} == before


@given(
    fixed=st.lists(st.sampled_from(["width", "height", "ratio", "handle.length"]), unique=True),
    seed=st.integers(0, 99),
)
def test_overriding_a_parameter_shifts_no_other(fixed, seed):
    free = door.sample(seed, overrides={"handle": "lever"})
    values = dict.fromkeys(fixed, 0.35) | {"handle": "lever"}
    given_ = door.sample(seed, overrides=values)
    assert {name: given_[name] for name in fixed} == dict.fromkeys(fixed, 0.35)
    assert {name: value for name, value in given_.items() if name not in fixed} == {
        name: value for name, value in free.items() if name not in fixed
    }


@given(seed=st.integers(0, 99))
def test_another_distribution_for_one_shifts_no_other(seed):
    free = door.sample(seed)
    wide = door.sample(seed, overrides={"width": uniform(0.3, 2.0)})
    assert {name: value for name, value in wide.items() if name != "width"} == {
        name: value for name, value in free.items() if name != "width"
    }
    # the same underlying draw, stretched
    assert (wide["width"] - 0.3) / 1.7 == pytest.approx((free["width"] - 0.75) / 0.3)


def test_generators_and_attempts_have_streams_of_their_own():
    a, b = with_parameters(["x"], "one"), with_parameters(["x"], "two")
    assert a.sample(3)["x"] != b.sample(3)["x"]
    assert a.sample(3)["x"] != a.sample(3, attempt=1)["x"]
    assert a.sample(3)["x"] != a.sample(4)["x"]


def test_one_sub_generator_in_two_places_draws_twice():
    @generator
    def pair(*, left: Generator = one_of(knob), right: Generator = one_of(knob)) -> Body:
        return left(thickness=0.1).attach(right(thickness=0.1).suffixed("_b"), Revolute("t", axis=Z))

    values = pair.sample(5)
    assert values["left.radius"] != values["right.radius"]
    assert pair.graph(5).parameters == ("left.radius", "right.radius")


@pytest.mark.parametrize(
    ("name", "value", "key", "expected"),
    [
        ("width", 0.9, "width", 0.9),
        ("width", 1, "width", 1.0),
        ("width", np.float32(0.5), "width", 0.5),
        ("panels", np.int64(9), "panels", 9),
        ("width", uniform(1.0, 1.0), "width", 1.0),
        ("layout", "single", "layout", "single"),
        ("layout", choice("single"), "layout", "single"),
        ("shiny", True, "shiny", True),
        ("wood", "pine", "wood", MATERIALS["pine"]),
        ("wood", choice("pine"), "wood", MATERIALS["pine"]),
        ("wood", OAK.with_(name="mine"), "wood", OAK.with_(name="mine")),
        ("offset", [1, 2, 3], "offset", (1.0, 2.0, 3.0)),
        ("offset", np.ones(3), "offset", (1.0, 1.0, 1.0)),
        ("handle", "knob", "handle", knob),
        ("handle", knob, "handle", knob),
        ("handle", choice("knob"), "handle", knob),
        ("handle", one_of(knob), "handle", knob),
        ("swing", uniform(3.0, 3.0), "swing", 3.0),
        ("swing", by("layout", french=5.0, single=5.0), "swing", 5.0),
        ("width", by("panels", otherwise=0.5), "width", 0.5),
    ],
)
def test_overrides_by_value_and_by_distribution(name, value, key, expected):
    assert door.sample(0, overrides={name: value})[key] == expected


@pytest.mark.parametrize(
    "name", ["handle.length", "handle__length", "handle.lever.length", "handle__lever__length"]
)
def test_sub_parameters_have_dotted_names(name):
    values = door.sample(0, overrides={"handle": "lever", name: 0.3})
    assert values["handle.length"] == 0.3
    asset = door.generate(0, **{"handle": "lever", name.replace(".", "__"): 0.3})
    assert asset.parameters["handle.length"] == 0.3
    assert np.ptp(asset.link("handle").bounds(), axis=0)[0] >= 0.3


@pytest.mark.parametrize(
    "name",
    [
        "handle.grip.width",
        "handle.lever.grip.width",
        "handle.grip.square_grip.width",
        "handle.lever.grip.square_grip.width",
    ],
)
def test_each_generator_on_the_way_may_be_left_out(name):
    values = door.sample(0, overrides={"handle": "lever", "handle.grip": "square_grip", name: 0.05})
    assert values["handle.grip.width"] == 0.05


def test_the_more_exact_name_counts():
    overrides = {"handle.grip.radius": 0.5, "handle.grip.round_grip.radius": 0.7, "handle": "lever"}
    for given_ in (overrides, dict(reversed(overrides.items()))):
        drawn = [door.sample(seed, overrides=given_) for seed in range(8)]
        assert {(values["handle.grip"].name, values["handle.grip.radius"]) for values in drawn} == {
            ("round_grip", 0.7),
            ("square_grip", 0.5),
        }


def test_a_short_name_means_every_generator_that_has_it():
    for grip in ("round_grip", "square_grip"):
        overrides = {"handle": "lever", "handle.grip": grip, "handle.grip.radius": 0.005}
        assert door.sample(1, overrides=overrides)["handle.grip.radius"] == 0.005


def test_a_generator_of_ones_own_brings_its_parameters():
    @generator
    def pull(
        *, thickness: Float, reach: Float = uniform(0.1, 0.2), grip: Generator = one_of(round_grip)
    ) -> Body:
        return part(box(reach, thickness, 0.02) | grip(), "handle", STEEL)

    values = door.sample(0, overrides={"handle": pull, "handle.reach": 0.15, "handle__grip__radius": 0.01})
    assert (values["handle.reach"], values["handle.grip.radius"]) == (0.15, 0.01)
    drawn = door.sample(0, overrides={"handle": one_of(pull, knob, weights=(1, 0)), "handle.reach": 0.15})
    assert drawn["handle.reach"] == 0.15
    assert door.generate(0, handle=pull).parameters["handle"] == "pull"


def test_the_support_of_a_default_is_no_limit():
    assert door.sample(0, overrides={"height": 50.0})["height"] == 50.0
    assert door.sample(0, overrides={"panels": 99})["panels"] == 99


REFUSED = {
    "unknown": ({"widht": 1.0}, r"door has no parameter 'widht'\. Did you mean 'width'\?"),
    "unknown inner": (
        {"handle.lenght": 1.0},
        r"door has no parameter 'handle\.lenght'\. Did you mean 'handle\.length'",
    ),
    "inner of no generator": ({"width.x": 1.0}, r"door has no parameter 'width\.x'"),
    "inner of another generator": (
        {"handle": "knob", "handle.length": 0.2},
        r"door has no parameter 'handle\.length' with the generators that are chosen",
    ),
    "empty": ({"": 1.0}, "door has no parameter ''"),
    "twice": ({"handle.length": 0.1, "handle__length": 0.2}, "the parameter 'handle.length' is given twice"),
    "beyond the limits": ({"width": 2.5}, r"width = 2\.5 is out of range: 0\.3 to 2 m is allowed"),
    "inner beyond the limits": (
        {"handle__length": 1.0},
        r"handle\.length = 1\.0 is out of range: 0\.05 to 0\.4 m",
    ),
    "distribution beyond the limits": (
        {"width": uniform(1, 3)},
        r"width = uniform\(1, 3\) is out of range: 0\.3 to 2 m",
    ),
    "by beyond the limits": ({"width": by("layout", otherwise=9.0)}, "is out of range: 0.3 to 2 m"),
    "text for a number": ({"width": "wide"}, "width = 'wide' is not allowed: it must be a number"),
    "truth for a number": ({"width": True}, "width = True is not allowed: it must be a number"),
    "a pair for a range": (
        {"width": (0.85, 0.92)},
        r"width = \(0\.85, 0\.92\) is not allowed: .* For a range, write uniform\(0\.85, 0\.92\)",
    ),
    "nan": ({"width": float("nan")}, "width = nan is not allowed: it must be a number"),
    "None": ({"width": None}, "width = None is not allowed: it must be a number"),
    "a handle": ({"width": Float.parameter("x")}, "is not allowed: it must be a number"),
    "choice for a number": (
        {"width": choice("a", "b")},
        r"width = choice\('a', 'b'\) is not allowed: it must be a number",
    ),
    "number for a whole number": (
        {"panels": 2.5},
        r"panels = 2\.5 is not allowed: it must be a whole number \(it is struct",
    ),
    "distribution for structural": (
        {"panels": uniform(1, 4)},
        r"panels = uniform\(1, 4\) is not allowed: .*structural",
    ),
    "distribution for truth": (
        {"shiny": uniform(0, 1)},
        r"shiny = uniform\(0, 1\) is not allowed: it must be True or False",
    ),
    "no option": (
        {"layout": "double"},
        "layout = 'double' is not allowed: it must be one of 'french', 'single'",
    ),
    "choice with no option": (
        {"layout": choice("french", "x")},
        "is not allowed: it must be one of 'french', 'single'",
    ),
    "one for truth": ({"glazed": 1}, "glazed = 1 is not allowed: it must be True or False"),
    "unknown material": (
        {"wood": "oka"},
        r"wood = 'oka' is not allowed: it must be a material or the name of one .*\. Did you mean 'oak'\?",
    ),
    "number for a material": ({"wood": 5}, "wood = 5 is not allowed: it must be a material"),
    "unknown generator": (
        {"handle": "knop"},
        "handle = 'knop' is not allowed: it must be one of lever, knob",
    ),
    "number for a generator": ({"handle": 5}, "handle = 5 is not allowed: it must be one of lever, knob"),
    "function for a generator": ({"handle": lever.function}, "it must be one of lever, knob"),
    "number for a string": ({"note": 5}, "note = 5 is not allowed: it must be a string"),
    "number for a vector": ({"offset": 5}, "offset = 5 is not allowed: it must be three numbers"),
    "two numbers for a vector": (
        {"offset": (1, 2)},
        r"offset = \(1, 2\) is not allowed: it must be three numbers",
    ),
    "by of nothing": (
        {"width": by("layuot", otherwise=1.0)},
        "needs a structural parameter 'layuot' of the same generator",
    ),
    "by of a socket": ({"width": by("height", otherwise=1.0)}, "needs a structural parameter 'height'"),
    "by in a circle": (
        {"panels": by("glazed", otherwise=1), "glazed": by("panels", otherwise=True)},
        "the parameters .*panels.* depend on each other",
    ),
    "by without the case": ({"width": by("layout", {"x": 1.0})}, "has no case for '(french|single)'"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_overrides_that_cannot_be_are_refused(name):
    overrides, message = REFUSED[name]
    with pytest.raises(ParameterError, match=message):
        door.sample(0, overrides=overrides)
    with pytest.raises(ValueError, match=message):
        door.evaluate(0, overrides=overrides)


def test_overrides_are_refused_whether_or_not_the_draw_uses_them():
    for seed in range(6):
        with pytest.raises(ParameterError, match="is out of range"):
            door.sample(seed, overrides={"handle.length": 9.0})


@pytest.mark.parametrize("seed", [-1, 1.5, "7", None, True])
def test_the_seed_is_a_whole_number_not_negative(seed):
    with pytest.raises(ParameterError, match=r"seed must be a whole number that is not negative, got"):
        door.generate(seed)
    with pytest.raises(ParameterError, match="seed must be"):
        door.sample(seed)


def test_numpy_seeds_are_seeds():
    assert door.generate(np.int64(3)).to_json() == door.generate(3).to_json()


@pytest.mark.parametrize(
    ("given_", "message"),
    [
        ({"name": "my door"}, "name = 'my door' is no identifier; use letters, digits and _"),
        ({"base": "floating"}, "base = 'floating' is not allowed: it must be 'fixed' or 'free'"),
        ({"attempts": 0}, "attempts must be at least 1, got 0"),
    ],
)
def test_the_other_arguments_are_checked(given_, message):
    with pytest.raises(ParameterError, match=message):
        door.generate(0, **given_)


def test_a_short_name_need_suit_only_the_generator_that_is_drawn():
    @generator
    def short(*, length: Float = uniform(0.1, 0.2, "m", within=(0.05, 0.3))) -> Body:
        return part(box(length, 0.1, 0.1), "grip", OAK)

    @generator
    def long(*, length: Float = uniform(1.0, 2.0, "m", within=(0.5, 3.0))) -> Body:
        return part(box(length, 0.1, 0.1), "grip", OAK)

    @generator
    def tool(*, grip: Generator = one_of(short, long)) -> Body:
        return grip()

    assert tool.sample(0, overrides={"grip": "long", "grip.length": 0.8})["grip.length"] == 0.8
    assert tool.sample(0, overrides={"grip": "short", "grip.length": 0.25})["grip.length"] == 0.25
    for seed in range(20):  # a shorter grip is drawn again
        values = tool.sample(seed, overrides={"grip.length": 0.8})
        assert (values["grip"], values["grip.length"]) == (long, 0.8)
    refused = {"grip": choice("short", "long"), "grip.length": 0.4}
    for overrides in ({"grip": "short", "grip.length": 0.8}, refused):
        with pytest.raises(
            ParameterError, match=r"grip\.length = 0\.[48] is out of range: 0\.\d+ to \d\.\d m"
        ):
            tool.sample(0, overrides=overrides)


def test_options_with_which_an_override_cannot_be_are_drawn_again():
    @generator
    def chest(
        *,
        style: str = choice("low", "high", "file"),
        rows: int = by("style", low=2, high={4: 1, 5: 1}, file={2: 1, 4: 1}),
        height: Float = by(
            "style",
            low=uniform(0.6, 0.7),
            high=by("rows", {4: uniform(0.9, 1.0), 5: uniform(1.1, 1.2)}),
            file=by("rows", {2: uniform(0.7, 0.8), 4: uniform(1.3, 1.4)}),
        ),
        depth: Float = uniform(0.4, 0.5),
    ) -> Body:
        return part(box(depth, 1.0, height), "body", OAK)

    redrawn = set()
    for seed in range(60):
        free, values = chest.sample(seed), chest.sample(seed, overrides={"rows": 5})
        assert values["rows"] == 5
        assert values["depth"] == free["depth"]
        assert chest.sample(seed, overrides={"rows": 5}) == values
        if free["style"] == "file":
            redrawn.add(values["style"])
        else:
            assert values["style"] == free["style"]
        assert chest.sample(seed, overrides={"rows": choice(4, 5)})["rows"] in (4, 5)
    assert redrawn == {"low", "high"}  # any number is possible in a low one
    excluding = (
        r"style = 'file' and rows = 5 cannot be drawn: for height, by\('rows', ...\) has no case for 5"
    )
    with pytest.raises(ParameterError, match=excluding):
        chest.sample(0, overrides={"style": "file", "rows": 5})
