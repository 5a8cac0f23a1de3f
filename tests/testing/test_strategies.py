"""Strategies: every override is valid, everything is reached, and examples shrink to the plainest."""

import math
from typing import Literal

import pytest
from hypothesis import Phase, find, given, settings
from hypothesis import strategies as st

from artgen import catalog
from artgen.errors import ParameterError
from artgen.generator import generator
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.primitive import box
from artgen.nodes.scalar import require
from artgen.sampling import by, choice, count, fixed, loguniform, truncated_normal, uniform
from artgen.testing.strategies import assets, parameters
from support.cases import some
from support.generators import door

QUICK = settings(max_examples=30)


def plainest(strategy, condition=lambda value: True):
    """Return what an example shrinks to."""
    return find(strategy, condition, settings=settings(max_examples=30))


def every(strategy, count=60):
    """Return examples of a strategy."""
    found = []

    @settings(max_examples=count)
    @given(strategy)
    def collect(value):
        found.append(value)

    collect()
    return found


@QUICK
@given(values=parameters(door), seed=st.integers(0, 99))
def test_overrides_are_valid_and_taken(values, seed):
    sample = door.sample(seed, overrides=values)
    for name, value in values.items():
        short = ".".join(name.split(".")[::2])
        taken = sample[short]
        assert getattr(taken, "name", taken) == value, name
    assert "offset" not in values
    assert "note" not in values
    # what is drawn leaves nothing to the seed
    assert sample == door.sample(seed + 1, overrides=values)


@QUICK
@given(values=parameters(door))
def test_values_lie_in_the_declared_ranges(values):
    assert 0.75 <= values["width"] <= 1.05
    assert 1.9 <= values["height"] <= 2.2
    assert 0.5 <= values["ratio"] <= 2.0
    assert type(values["panels"]) is int
    assert 1 <= values["panels"] <= 4
    assert values["wood"] in ("oak", "walnut")
    low, high = (1.4, 1.6) if values["layout"] == "french" else (1.8, 2.0)
    assert low <= values["swing"] <= high
    assert ("handle.lever.length" in values) == (values["handle"] == "lever")
    assert ("handle.lever.grip.square_grip.width" in values) == (
        values.get("handle.lever.grip") == "square_grip"
    )


@pytest.mark.parametrize("name", some(catalog.categories(), 4, 1))
def test_every_category_takes_them(name):
    category = catalog.find(name)
    seen = every(parameters(category), 25) + every(parameters(category, structural=False), 10)
    for values in seen:
        category.sample(0, overrides=values)
    assert {name for values in seen for name in values} <= set(category.parameters())


def test_everything_is_reached():
    seen = every(parameters(door), 150)
    assert {values["handle"] for values in seen} == {"lever", "knob"}
    assert {values["layout"] for values in seen} == {"french", "single"}
    assert {values["panels"] for values in seen} == {1, 2, 3, 4}
    assert {values["glazed"] for values in seen} == {True, False}
    assert {0.75, 1.05} <= {values["width"] for values in seen}, "the ends are included"


def test_examples_shrink_to_the_middle_and_the_first_option():
    plain = plainest(parameters(door))
    assert plain["width"] == pytest.approx(0.9)
    assert plain["height"] == 2.0  # the mean
    assert plain["ratio"] == pytest.approx(1.0)  # the geometric mean of 0.5 and 2
    assert (plain["layout"], plain["panels"], plain["wood"]) == ("french", 1, "oak")
    assert plain["glazed"] is True
    assert plain["handle"] == "lever"
    assert plain["handle.lever.grip"] == "round_grip"
    wide = plainest(parameters(door), lambda values: values["width"] > 0.9)
    assert {name: wide[name] for name in wide if name != "width"} == {
        name: plain[name] for name in plain if name != "width"
    }


def test_without_structural_ones_the_seed_decides_them():
    for values in every(parameters(door, structural=False), 20):
        assert {"width", "height", "handle.lever.length", "handle.knob.radius"} <= set(values)
        assert not {"layout", "swing", "panels", "glazed", "wood", "handle"} & set(values)
        for seed in range(4):
            free, given_ = door.sample(seed), door.sample(seed, overrides=values)
            assert all(given_[name] == free[name] for name in ("layout", "swing", "panels", "handle"))
            assert given_["width"] == values["width"]


def test_hard_limits_are_wider_and_hold():
    @generator
    def sized(
        *,
        width: Float = uniform(0.5, 0.6, within=(0.1, 1.0)),
        depth: Float = fixed(0.5, within=(0.2, 0.6)),
        height: Float = truncated_normal(0.5, 0.1, 0.4, 0.9),
        scale: Float = loguniform(1.0, 4.0, within=(1.0, 100.0)),
        shelves: int = count(1, 3, within=(1, 9)),
    ) -> Body:
        return part(box(width, depth, height * scale), "box", material("oak"))

    seen = every(parameters(sized, hard_limits=True), 80)
    widths = [values["width"] for values in seen]
    assert min(widths) == 0.1
    assert max(widths) == 1.0
    assert min(values["depth"] for values in seen) == 0.2
    assert all(0.4 <= values["height"] <= 0.9 for values in seen)
    assert {values["shelves"] for values in seen} == {1, 2, 3}
    plain = plainest(parameters(sized, hard_limits=True))
    assert plain["depth"] == 0.5
    assert math.isclose(plain["scale"], 10.0)
    assert all("depth" not in values for values in every(parameters(sized), 10))
    narrow = {"width": uniform(0.7, 0.8, within=(0.2, 0.9)), "depth": 0.3}
    for values in every(parameters(sized, hard_limits=True, overrides=narrow), 20):
        assert 0.7 <= values["width"] <= 0.8, "an override is taken as it is"
        assert values["depth"] == 0.3


def test_options_that_are_never_drawn_are_left_out():
    @generator
    def tinted(*, tint: str = choice("red", "green", "blue", weights=(1, 0, 1))) -> Body:
        return part(box(0.1, 0.1, 0.1), "box", material("oak"))

    assert {values["tint"] for values in every(parameters(tinted))} == {"red", "blue"}


def test_overrides_are_kept_and_what_depends_on_them_suits_them():
    given_ = {"handle": "knob", "layout": "single", "width": uniform(1.5, 1.6), "handle__radius": 0.024}
    for values in every(parameters(door, overrides=given_), 30):
        assert (values["handle"], values["layout"], values["handle.radius"]) == ("knob", "single", 0.024)
        assert "handle.lever.length" not in values
        assert "handle.knob.radius" not in values
        assert 1.5 <= values["width"] <= 1.6
        assert 1.8 <= values["swing"] <= 2.0
        assert door.sample(3, overrides=values)["handle.radius"] == 0.024


def test_materials_of_ones_own_stay_materials():
    mine = material("oak").with_(name="driftwood")

    @generator
    def raft(*, wood: type(mine) = choice(mine, material("oak"))) -> Body:
        return part(box(0.1, 0.1, 0.1), "box", wood)

    assert {repr(values["wood"]) for values in every(parameters(raft))} == {repr(mine), repr("oak")}


def test_assets_are_generated_and_infeasible_ones_rejected():
    @generator
    def crate(*, width: Float = uniform(0.1, 0.5, "m"), grip: Float = uniform(0.01, 0.02)) -> Body:
        return part(box(require(width, width > 0.2, "too narrow"), 0.1, grip), "crate", material("oak"))

    widths = [asset.parameters["width"] for asset in every(assets(crate), 40)]
    assert min(widths) > 0.2
    assert len(set(widths)) > 5
    assert plainest(assets(crate, overrides={"grip": 0.5})).parameters["grip"] == 0.5


def test_without_structural_ones_assets_come_from_several_seeds():
    assert len({asset.parameters["layout"] for asset in every(assets(door, structural=False), 30)}) == 2


@pytest.mark.parametrize("make", [parameters, assets])
@pytest.mark.parametrize(
    ("wrong", "options", "message"),
    [
        ("dor", {}, r"there is no category 'dor'\. Did you mean 'door'\?"),
        (max, {}, "a generator or the name of a category is needed, got <built-in function max>"),
        (door, {"overrides": {"widht": 1}}, "door has no parameter 'widht'. Did you mean 'width'"),
        (door, {"overrides": {"width": 9.0}}, "width = 9.0 is out of range: 0.3 to 2 m is allowed"),
    ],
)
def test_wrong_use_is_told_at_once(make, wrong, options, message):
    with pytest.raises(ParameterError, match=message):
        make(wrong, **options)


def test_a_choice_beside_a_range_is_drawn_to_suit_its_case():
    @generator
    def shelf(
        *,
        kind: Literal["plain", "fixed", "stepped"] = choice("plain", "fixed", "stepped"),
        depth: Float = by("kind", plain=uniform(0.2, 0.3), fixed=0.25, stepped=choice(0.1, 0.2, 0.4)),
        edge: str = by("kind", plain=choice("a", "b"), fixed="c", stepped=choice("a", "b", "c", "d")),
    ) -> Body:
        return part(box(depth, 0.1, 0.1), "shelf", material("oak"))

    seen = every(parameters(shelf), 120)
    depths = {
        kind: {v.get("depth") for v in seen if v["kind"] == kind} for kind in ("plain", "fixed", "stepped")
    }
    assert depths["fixed"] == {None}, "a fixed value is no override"
    assert depths["stepped"] == {0.1, 0.2, 0.4}
    assert all(0.2 <= depth <= 0.3 for depth in depths["plain"])
    assert {v["edge"] for v in seen if v["kind"] == "plain"} == {"a", "b"}
    assert {v["edge"] for v in seen if v["kind"] == "stepped"} == {"a", "b", "c", "d"}


@pytest.mark.parametrize("fails", ["always", "on knobs"])
def test_a_failing_test_shows_the_plainest_example(fails):
    @settings(max_examples=30, phases=[Phase.generate, Phase.shrink])
    @given(values=parameters(door))
    def judged(values):
        assert fails != "always"
        assert values["handle"] != "knob", values

    with pytest.raises(AssertionError) as failed:
        judged()
    shown = "\n".join(failed.value.__notes__)
    assert "'panels': 1" in shown
    assert "'wood': 'oak'" in shown
    assert f"'handle': '{'lever' if fails == 'always' else 'knob'}'" in shown
