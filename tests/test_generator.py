"""Generators: signatures are checked when decorated, draws do not disturb each other, overrides are understood."""

import functools
import inspect
import os
import subprocess
import sys
from typing import Literal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import ArtgenError, AssetError, BuildError, EvaluationError, InfeasibleError, ParameterError
from artgen.generator import CATEGORIES, Generator, category, generator, one_of
from artgen.graph import Cache
from artgen.materials import MATERIALS, Material, material
from artgen.nodes.body import detail, part
from artgen.nodes.choose import require
from artgen.nodes.handles import Body, Bool, Float, Solid, Vector
from artgen.nodes.joint import Revolute
from artgen.nodes.primitive import box, sphere
from artgen.nodes.vector import X, Z
from artgen.sampling import Fixed, by, choice, count, loguniform, normal, uniform
from support.lines import place_of

OAK, STEEL = material("oak"), material("steel")


@generator
def round_grip(*, radius: Float = uniform(0.01, 0.02, "m")) -> Solid:
    return sphere(radius)


@generator
def square_grip(*, width: Float = uniform(0.01, 0.02, "m"), radius: Float = uniform(0.001, 0.002)) -> Solid:
    return box(width, width, width, bevel=radius)


@generator
def lever(
    *,
    thickness: Float,
    toward: int = 1,
    length: Float = uniform(0.10, 0.14, "m", within=(0.05, 0.4)),
    grip: Generator = one_of(round_grip, square_grip),
    axis: Vector = X,
) -> Body:
    return part(box(length, thickness, 0.02) | grip().at(axis * (toward * length / 2)), "handle", STEEL)


@generator
def knob(*, thickness: Float, radius: Float = uniform(0.02, 0.03, "m"), grip: Solid | None = None) -> Body:
    solid = sphere(radius).at(0, thickness) if grip is None else grip
    return part(solid, "handle", STEEL)


@generator
def door(
    *,
    width: Float = uniform(0.75, 1.05, "m", doc="of the leaf", within=(0.3, 2.0)),
    height: Float = normal(2.0, 0.1, 1.9, 2.2, "m"),
    ratio: Float = loguniform(0.5, 2.0),
    layout: Literal["french", "single"] = choice("french", "single"),
    swing: Float = by("layout", french=uniform(1.4, 1.6), single=uniform(1.8, 2.0), unit="rad"),
    panels: int = count(1, 4),
    glazed: bool = choice(True, False),
    shiny: Bool = choice(True, False),
    wood: Material = choice("oak", "walnut"),
    offset: Vector = (0.0, 0.0, 0.5),
    note: str = "plain",
    handle: Generator = one_of(lever, knob),
) -> Body:
    leaf = part(box(width, 0.04 * ratio, height).at(offset), "door", wood)
    return leaf.attach(handle(thickness=width / 20), Revolute("turn", axis=X, limits=(0.0, swing)))


NAMES = list(door.sample(0))


# --- what is drawn ---------------------------------------------------------------------------------------------


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


@given(fixed=st.lists(st.sampled_from(["width", "height", "ratio", "handle.length"]), unique=True), seed=st.integers(0, 99))
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


# --- overrides -------------------------------------------------------------------------------------------------


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


@pytest.mark.parametrize("name", ["handle.length", "handle__length", "handle.lever.length", "handle__lever__length"])
def test_sub_parameters_have_dotted_names(name):
    values = door.sample(0, overrides={"handle": "lever", name: 0.3})
    assert values["handle.length"] == 0.3
    asset = door.generate(0, **{"handle": "lever", name.replace(".", "__"): 0.3})
    assert asset.parameters["handle.length"] == 0.3
    assert np.ptp(asset.link("handle").bounds(), axis=0)[0] >= 0.3


@pytest.mark.parametrize(
    "name",
    ["handle.grip.width", "handle.lever.grip.width", "handle.grip.square_grip.width", "handle.lever.grip.square_grip.width"],
)
def test_each_generator_on_the_way_may_be_left_out(name):
    values = door.sample(0, overrides={"handle": "lever", "handle.grip": "square_grip", name: 0.05})
    assert values["handle.grip.width"] == 0.05


def test_the_more_exact_name_counts():
    overrides = {"handle.grip.radius": 0.5, "handle.grip.round_grip.radius": 0.7, "handle": "lever"}
    for given_ in (overrides, dict(reversed(overrides.items()))):
        assert door.sample(0, overrides=given_ | {"handle.grip": "round_grip"})["handle.grip.radius"] == 0.7
        assert door.sample(0, overrides=given_ | {"handle.grip": "square_grip"})["handle.grip.radius"] == 0.5


def test_a_short_name_means_every_generator_that_has_it():
    for grip in ("round_grip", "square_grip"):
        overrides = {"handle": "lever", "handle.grip": grip, "handle.grip.radius": 0.005}
        assert door.sample(1, overrides=overrides)["handle.grip.radius"] == 0.005


def test_a_generator_of_ones_own_brings_its_parameters():
    @generator
    def pull(*, thickness: Float, reach: Float = uniform(0.1, 0.2), grip: Generator = one_of(round_grip)) -> Body:
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
    "unknown inner": ({"handle.lenght": 1.0}, r"door has no parameter 'handle\.lenght'\. Did you mean 'handle\.length'"),
    "inner of no generator": ({"width.x": 1.0}, r"door has no parameter 'width\.x'"),
    "inner of another generator": ({"handle": "knob", "handle.length": 0.2}, r"door has no parameter 'handle\.length'"),
    "empty": ({"": 1.0}, "door has no parameter ''"),
    "twice": ({"handle.length": 0.1, "handle__length": 0.2}, "the parameter 'handle.length' is given twice"),
    "beyond the limits": ({"width": 2.5}, r"width = 2\.5 is out of range: 0\.3 to 2 m is allowed"),
    "inner beyond the limits": ({"handle__length": 1.0}, r"handle\.length = 1\.0 is out of range: 0\.05 to 0\.4 m"),
    "distribution beyond the limits": ({"width": uniform(1, 3)}, r"width = uniform\(1, 3\) is out of range: 0\.3 to 2 m"),
    "by beyond the limits": ({"width": by("layout", otherwise=9.0)}, "is out of range: 0.3 to 2 m"),
    "text for a number": ({"width": "wide"}, "width = 'wide' is not allowed: it must be a number"),
    "truth for a number": ({"width": True}, "width = True is not allowed: it must be a number"),
    "nan": ({"width": float("nan")}, "width = nan is not allowed: it must be a number"),
    "None": ({"width": None}, "width = None is not allowed: it must be a number"),
    "a handle": ({"width": Float.parameter("x")}, "is not allowed: it must be a number"),
    "choice for a number": ({"width": choice("a", "b")}, r"width = choice\('a', 'b'\) is not allowed: it must be a number"),
    "number for a whole number": ({"panels": 2.5}, r"panels = 2\.5 is not allowed: it must be a whole number \(it is struct"),
    "distribution for structural": ({"panels": uniform(1, 4)}, r"panels = uniform\(1, 4\) is not allowed: .*structural"),
    "distribution for truth": ({"shiny": uniform(0, 1)}, r"shiny = uniform\(0, 1\) is not allowed: it must be True or False"),
    "no option": ({"layout": "double"}, "layout = 'double' is not allowed: it must be one of 'french', 'single'"),
    "choice with no option": ({"layout": choice("french", "x")}, "is not allowed: it must be one of 'french', 'single'"),
    "one for truth": ({"glazed": 1}, "glazed = 1 is not allowed: it must be True or False"),
    "unknown material": ({"wood": "oka"}, "wood = 'oka' is not allowed: it must be a material or the name of one"),
    "number for a material": ({"wood": 5}, "wood = 5 is not allowed: it must be a material"),
    "unknown generator": ({"handle": "knop"}, "handle = 'knop' is not allowed: it must be one of lever, knob"),
    "number for a generator": ({"handle": 5}, "handle = 5 is not allowed: it must be one of lever, knob"),
    "function for a generator": ({"handle": lever.function}, "it must be one of lever, knob"),
    "number for a string": ({"note": 5}, "note = 5 is not allowed: it must be a string"),
    "number for a vector": ({"offset": 5}, "offset = 5 is not allowed: it must be three numbers"),
    "two numbers for a vector": ({"offset": (1, 2)}, r"offset = \(1, 2\) is not allowed: it must be three numbers"),
    "by of nothing": ({"width": by("layuot", otherwise=1.0)}, "needs a structural parameter 'layuot' of the same generator"),
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


# --- the asset -------------------------------------------------------------------------------------------------


def test_an_asset_knows_what_it_was_made_of():
    asset = door.generate(4, handle="lever", wood="pine", base="free", name="mine")
    assert (asset.name, asset.category, asset.seed, asset.attempt, asset.base) == ("mine", "door", 4, 0, "free")
    assert asset.parameters["wood"] == "pine"
    assert asset.parameters["handle"] == "lever"
    assert asset.parameters["offset"] == [0.0, 0.0, 0.5]
    assert asset.joint("turn").limits == (0.0, asset.parameters["swing"])
    assert door.generate(4).name == "door_4"


def test_the_same_seed_gives_the_same_asset_with_any_cache():
    shared, fresh, small = door.generate(5), door.generate(5, cache=Cache()), door.generate(5, cache=Cache(3))
    assert shared.to_json() == fresh.to_json() == small.to_json()


def test_a_second_asset_computes_only_what_changed():
    cache = Cache()
    door.evaluate(0, cache=cache, overrides={"handle": "lever"})
    _, again = door.evaluate(0, cache=cache, overrides={"handle": "lever"})
    assert not again.runs
    _, changed = door.evaluate(0, cache=cache, overrides={"handle": "lever", "swing": 0.25})
    assert set(changed.runs) == {"joint", "attach"}


def test_the_hash_seed_of_python_changes_no_byte(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        "import hashlib, test_generator\n"
        "for seed in range(3):\n"
        "    asset = test_generator.door.generate(seed)\n"
        "    surfaces = [s.mesh for link in asset.links for s in link.surfaces]\n"
        "    data = b''.join(a.tobytes() for m in surfaces for a in (m.vertices, m.normals, m.uvs, m.triangles))\n"
        "    print(hashlib.sha256(asset.to_json().encode() + data).hexdigest())\n"
    )
    paths = [os.path.dirname(__file__), *sys.path]
    outputs = {
        subprocess.run(
            [sys.executable, str(script)],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(paths)},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        for seed in ("0", "4242")
    }
    assert len(outputs) == 1
    assert len(next(iter(outputs)).split()) == 3


# --- infeasible draws ------------------------------------------------------------------------------------------


@generator
def picky(*, size: Float = uniform(0.0, 1.0), panes: int = count(1, 4), least: Float = 0.5) -> Body:
    require(panes != 2, "two panes look odd")
    return part(box(1.0, 1.0, size + 0.1), "block", OAK).require(size > least, "too small")


def test_infeasible_draws_are_drawn_again_and_counted():
    attempts = set()
    for seed in range(20):
        asset = picky.generate(seed)
        assert asset.parameters["size"] > 0.5
        assert asset.parameters["panes"] != 2
        attempts.add(asset.attempt)
        values = picky.sample(seed, attempt=asset.attempt)
        assert values["size"] == asset.parameters["size"]
        for earlier in range(asset.attempt):
            values = picky.sample(seed, attempt=earlier)
            assert values["size"] <= 0.5 or values["panes"] == 2
    assert len(attempts) > 2


def test_a_category_that_is_never_feasible_says_why():
    with pytest.raises(
        InfeasibleError, match=r"picky: none of 7 draws for seed 3 is feasible; the last: (too small|two panes)"
    ) as caught:
        picky.generate(3, attempts=7, least=2.0)
    assert f"\n  at {__file__}:" in str(caught.value)


def test_overrides_hold_through_every_attempt():
    assert picky.generate(11, panes=3).parameters["panes"] == 3
    with pytest.raises(InfeasibleError, match="two panes look odd"):
        picky.generate(11, panes=2)


# --- errors name the author's line -----------------------------------------------------------------------------


def raises_at(marker, error, message, function, **overrides):
    with pytest.raises(error, match=message) as caught:
        generator(function).generate(0, **overrides)
    assert place_of(__file__, marker) in str(caught.value)
    return caught.value


def block(name="block"):
    return part(box(0.1, 0.1, 0.1), name, OAK)


def test_a_kernel_error_comes_with_the_seed():
    def leaf(*, width: Float = uniform(-2.0, -1.0)) -> Body:
        return part(box(width, 1.0, 1.0), "leaf", OAK)  # marker: kernel

    error = raises_at("marker: kernel", EvaluationError, "box failed", leaf)
    assert error.__notes__ == ["while generating leaf from seed 0, attempt 0"]


def test_an_unknown_leader_names_the_line_of_the_joint():
    def lid(*, ratio: Float = uniform(1.0, 2.0)) -> Body:
        pedal = Revolute("pedal", axis=X)
        turn = Revolute("lid", axis=X, follows=ratio * pedal)  # marker: leader
        return block("base").attach(block("lid"), turn)

    raises_at("marker: leader", AssetError, "joint 'lid' follows 'pedal', which is no joint of this asset", lid)


def test_an_unknown_leader_of_a_copy_names_the_line_of_the_joint():
    def lid() -> Body:
        pedal = Revolute("pedal", axis=X)
        turn = Revolute("lid", axis=X, needs=pedal > 0.5)  # marker: copy
        return block("base").repeat(block("lid"), turn, at=[(0, 0, 0)]).suffixed("_left")

    raises_at("marker: copy", AssetError, "joint 'lid_0_left' needs 'pedal'", lid)


def test_a_circle_of_couplings_names_a_line():
    def lid() -> Body:
        a, b = Revolute("a", axis=X), Revolute("b", axis=X)
        body = block("base").attach(block("x"), Revolute("a", axis=X, follows=b))  # marker: circle
        return body.attach(block("y"), Revolute("b", axis=X, follows=a))

    raises_at("marker: circle", AssetError, "the couplings of joints a, b form a circle", lid)


def test_a_link_without_mass_names_the_line_of_the_detail():
    def toy() -> Body:
        label = detail(box(1.0, 1.0, 1.0), "print", OAK)  # marker: detail
        return block("base").attach(label, Revolute("t", axis=X))

    raises_at("marker: detail", AssetError, "link 'print' is made of details only", toy)


def test_a_label_that_is_not_declared_names_the_line_of_the_part():
    def toy() -> Body:
        return block("dore")  # marker: label

    def block(label):
        return part(box(1.0, 1.0, 1.0), label, OAK)  # marker: made

    with pytest.raises(AssetError, match="carries the label 'dore', which toy does not declare. Did you mean 'door'"):
        Generator(toy, labels=("door",)).generate(0)
    with pytest.raises(AssetError) as caught:
        Generator(toy, labels=("door",)).generate(0)
    assert place_of(__file__, "marker: made") in str(caught.value)


def test_a_parameter_node_belongs_to_its_generator():
    (node,) = [node for node in round_grip.graph(0).nodes if node.op == "parameter"]
    assert node.where == round_grip.where


def test_a_result_that_is_no_body_is_refused():
    with pytest.raises(BuildError, match=r"round_grip returns a Solid; an asset needs a Body\n  at .*test_generator"):
        round_grip.generate(0)

    def nothing() -> Body:
        return None

    with pytest.raises(BuildError, match=r"nothing returned None; it must return a handle such as a Body"):
        generator(nothing).generate(0)


def test_a_structural_parameter_is_known_and_a_socket_is_not():
    def toy(*, panes: int = count(2, 2), size: Float = uniform(0.1, 0.2)) -> Body:
        if size > 0.15:  # marker: socket
            return block("a")
        return block("b")

    error = raises_at("marker: socket", BuildError, "a handle used as a condition", toy)
    assert "annotate it int, str, bool or Literal" in str(error)


# --- calling generators from generators ------------------------------------------------------------------------


def test_a_chosen_generator_can_be_asked_for_and_compared():
    seen = []

    @generator
    def toy(*, handle: Generator = one_of(lever, knob)) -> Body:
        seen.append((handle.name, handle == lever, handle == knob, handle != knob, handle in {lever}))
        return handle(thickness=0.1)

    toy.generate(0, handle="knob")
    assert seen == [("knob", False, True, False, False)]


def test_a_direct_call_hides_no_draw():
    with pytest.raises(BuildError) as caught:
        knob(thickness=0.1)
    assert "knob(...) draws 'radius', which nothing gives it here" in str(caught.value)
    assert "make the generator a parameter: knob: Generator = one_of(knob)" in str(caught.value)
    assert isinstance(knob(thickness=0.1, radius=0.02), Body)


def test_inputs_are_checked():
    with pytest.raises(BuildError, match=r"knob has no input 'thicknes'\. Did you mean 'thickness'\?"):
        knob(thicknes=0.1, radius=0.02)
    with pytest.raises(BuildError, match=r"knob needs the input 'thickness'\n  defined at .*test_generator.py:"):
        knob(radius=0.02)
    with pytest.raises(BuildError, match=r"lever needs the input 'thickness'"):
        lever.generate(0)


def test_defaults_that_are_handles_or_none_are_inputs():
    assert "axis" not in lever.parameters()
    assert "grip" not in knob.parameters()
    direct = knob(thickness=0.1, radius=0.02, grip=sphere(0.5))
    assert any(node.op == "sphere" and node.inputs["radius"] == 0.5 for node in [*direct.node.children()])


def test_a_caller_may_give_what_would_be_drawn():
    @generator
    def toy(*, handle: Generator = one_of(knob)) -> Body:
        return handle(thickness=0.1, radius=0.25)

    assert toy.graph(0).parameters == ()


def test_input_names_may_be_any():
    @generator
    def toy(*, values: Float, prefix: Float, self: Float, seed: Float) -> Solid:  # noqa: PLW0211 - on purpose
        return box(values, prefix, self + seed)

    @generator
    def whole(*, made: Generator = one_of(toy)) -> Body:
        return part(made(values=0.1, prefix=0.2, self=0.1, seed=0.2), "block", OAK)

    assert whole.generate(0).mass == pytest.approx(0.1 * 0.2 * 0.3 * OAK.density)


# --- the decorator ---------------------------------------------------------------------------------------------


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
    "uniform for int": (declared(int, uniform(1, 4)), r"annotated int, but uniform\(1, 4\) is drawn from numbers: ann"),
    "uniform for Bool": (declared(Bool, uniform(0, 1)), r"annotated Bool, but uniform\(0, 1\) is drawn from numbers"),
    "words for Float": (declared(Float, choice("a", "b")), r"but choice\('a', 'b'\) has values that are not a number"),
    "words for int": (declared(int, choice(1, "b")), "has values that are not a whole number"),
    "fractions for int": (declared(int, 2.5), r"annotated int, but 2\.5 has values that are not a whole number"),
    "truth for int": (declared(int, True), "annotated int, but True has values that are not a whole number"),
    "truth for Float": (declared(Float, choice(True, False)), "has values that are not a number"),
    "numbers for str": (declared(str, count(1, 3)), "annotated str, but .* has values that are not a string"),
    "another option": (declared(Literal["a", "b"], choice("a", "c")), "has values that are not one of 'a', 'b'"),
    "1 for True": (declared(Literal[True], 1), "has values that are not one of True"),
    "unknown material": (declared(Material, "oka"), "annotated Material, but 'oka' has values that are not a material"),
    "a string for a generator": (declared(Generator, "knob"), "annotated Generator, but 'knob'"),
    "two numbers for Vector": (declared(Vector, (1.0, 2.0)), "has values that are not three numbers"),
    "a plain float": (declared(float, uniform(0, 1)), r"annotated float, but .*annotate it Float, Bool, Vector, int"),
    "a Solid": (declared(Solid, uniform(0, 1)), "annotated Solid, but .* cannot give that type"),
    "a list": (declared(list[int], choice(1)), r"annotated list.*cannot give that type"),
    "a handle of another type": (declared(Float, Z), "annotated Float, but its default is a Vector"),
    "one case wrong": (
        declared(Float, by("k", a=uniform(0, 1), b="x"), k=(str, choice("a", "b"))),
        "has values that are not a number",
    ),
    "by of nothing": (declared(Float, by("k", a=1.0)), r"by\('k', ...\) needs a structural parameter .*; 'k' is none"),
    "by of a socket": (declared(Float, by("k", a=1.0), k=(Float, 1.0)), "needs a structural parameter"),
    "by of an input": (declared(Float, by("k", a=1.0), k=(str, inspect.Parameter.empty)), "needs a structural parameter"),
    "by with a case missing": (
        declared(Float, by("k", a=1.0), k=(Literal["a", "b"], choice("a"))),
        r"by\('k', ...\) has no case for 'b'; give one for each value, or otherwise=... Cases: a",
    ),
    "by of a generator with a case missing": (
        declared(Float, by("k", lever=1.0), k=(Generator, one_of(lever, knob))),
        "has no case for 'knob'",
    ),
    "by in a circle": (
        declared(int, by("k", otherwise=1), k=(int, by("x", otherwise=1))),
        "the parameters x, k depend on each other",
    ),
    "reserved": (declared(Float, 1.0, name="seed"), r"'seed' is reserved for generate\(\); choose another name"),
    "double underscore": (declared(Float, 1.0, name="a__b"), "the double underscore means a dot; choose another name"),
    "variadic": (body, r"body\(inputs: ...\) cannot be given by keyword; name every parameter"),
}


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


# --- categories ------------------------------------------------------------------------------------------------


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
    with pytest.raises(BuildError, match=r"made\(x: ...\): nobody gives a category its inputs; give it a distribution"):
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
    with pytest.raises(BuildError, match=r"the category 'bench' is defined twice, at .*test_generator.py:\d+ and"):
        category(labels=("block",))(other)
    assert catalog["bench"] is first
    again = category(labels=("block",))(bench)
    assert catalog["bench"] is again


def test_every_error_is_an_artgen_error():
    for make in (
        functools.partial(door.sample, -1),
        functools.partial(door.sample, 0, overrides={"x": 1}),
        functools.partial(knob, radius=1.0),
        functools.partial(picky.generate, 0, least=5.0),
    ):
        with pytest.raises(ArtgenError):
            make()
