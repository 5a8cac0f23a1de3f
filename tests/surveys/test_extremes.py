"""Samples at the ends of ranges: draws, and commands that reproduce them."""

import math
import shlex
import typing
from pathlib import Path
from typing import Any, Literal

import pytest
from surveys.extremes import Extreme, category_of, draw_extreme, ends

from artgen.catalog import categories, find
from artgen.generator import Parameter
from artgen.generator.corners import in_use
from artgen.generator.draw import Overrides
from artgen.generator.overrides import parse_overrides
from artgen.materials import Material
from artgen.nodes.handles import Bool, Float
from artgen.sampling import by, choice, count, fixed, uniform
from support.cases import some

NAMES = categories()


def options(command: str) -> dict[str, list[str]]:
    """Return the options of a command as a shell splits it, by name."""
    words = shlex.split(command)
    found: dict[str, list[str]] = {}
    for option, value in zip(words[3::2], words[4::2], strict=True):
        found.setdefault(option, []).append(value)
    return found


def test_a_sample_depends_on_seed_and_number() -> None:
    drawn = [draw_extreme(3, number) for number in range(6)]
    assert drawn == [draw_extreme(3, number) for number in range(6)]
    others = [draw_extreme(4, number) for number in range(6)]
    assert all(one.overrides != other.overrides for one, other in zip(drawn, others, strict=True))
    assert len({each.seed for each in drawn}) == 6


def test_categories_are_sampled_in_turn() -> None:
    assert [category_of(number) for number in range(2 * len(NAMES))] == [*NAMES, *NAMES]
    assert draw_extreme(0, len(NAMES) + 1).category == NAMES[1]


@pytest.mark.parametrize(
    ("kind", "distribution", "values"),
    [
        (Float, uniform(0.1, 0.2), [0.1, 0.2]),
        (Float, uniform(0.1, 0.2, within=(0.05, 0.3)), [0.1, 0.2, 0.05, 0.3]),
        (Float, uniform(0.1, 0.2, within=(0.1, 0.3)), [0.1, 0.2, 0.3]),
        (Float, fixed(0.4), [0.4]),
        (Float, choice(0.6, 0.9, within=(0.5, 1.0)), [0.6, 0.9, 0.5, 1.0]),
        (int, count(2, 4, within=(1.5, 6.5)), [2, 3, 4, 6]),
        (bool, by("layout", french=False, single=True), [False, True]),
        (Bool, fixed(value=False), [False, True]),
        (Literal["left", "right", "both"], choice("left", "right"), ["left", "right", "both"]),
        (str, by("layout", french="", single=choice("3", "12")), ["", "3", "12"]),
        (Material, choice("oak", "walnut"), ["oak", "walnut"]),
    ],
)
def test_ends_are_those_of_ranges_and_hard_limits(kind: Any, distribution: Any, values: list[Any]) -> None:
    found = ends(Parameter("thing", kind, distribution), distribution)
    assert found == values
    assert [type(value) for value in found] == [type(value) for value in values]


def test_a_number_has_the_ends_of_the_option_that_was_chosen() -> None:
    swing = by("layout", french=uniform(1.0, 1.25), single=uniform(1.5, 1.75), within=(0.5, 2.0))
    case = swing.case("single")
    assert case is not None
    assert ends(Parameter("swing", Float, swing), case) == [1.5, 1.75, 0.5, 2.0]


@pytest.mark.parametrize("name", some(NAMES, 3))
def test_overrides_are_used_as_drawn(name: str) -> None:
    """Only parameters in use are drawn, so that each has an effect, and each is at an end."""
    category = find(name)
    shares = []
    for number in range(NAMES.index(name), 24 * len(NAMES), len(NAMES)):
        extreme = draw_extreme(1, number)
        values = category.sample(extreme.seed, overrides=extreme.overrides)
        given = {each: getattr(values[each], "name", values[each]) for each in extreme.overrides}
        assert given == dict(extreme.overrides)
        shares.append(len(given) / len(values))
        plain = Overrides(category, {})
        for short, parameter, _ in in_use(category.own, values, plain):
            if short in given and parameter.kind is Float:
                leaves = parameter.distribution.leaves()
                allowed = {end for leaf in leaves for end in leaf.support()}
                assert given[short] in allowed | set(parameter.distribution.within or ())
    assert min(shares) < 0.25 < max(shares)


def test_ends_beyond_the_distributions_are_sampled() -> None:
    """Hard limits are wider than distributions; ordinary draws never reach them."""
    number = NAMES.index("plier")
    lengths = {draw_extreme(0, number + turn * len(NAMES)).overrides.get("length") for turn in range(60)}
    assert {0.12, 0.26} <= lengths


@pytest.mark.parametrize("name", some(NAMES, 3))
def test_commands_give_the_same_overrides(name: str) -> None:
    """For every kind of parameter: text that looks like a number, empty text, names, whole numbers."""
    for number in range(NAMES.index(name), 24 * len(NAMES), len(NAMES)):
        extreme = draw_extreme(2, number)
        found = options(extreme.command(Path("out/it's here"), on_collision="fail"))
        read = parse_overrides(found.get("--set", []))
        assert read == dict(extreme.overrides)
        assert {key: type(value) for key, value in read.items()} == {
            key: type(value) for key, value in extreme.overrides.items()
        }
        assert found["--seed"] == [str(extreme.seed)]
        assert found["--out"] == ["out/it's here"]
        assert found["--on-collision"] == ["fail"]


@pytest.mark.parametrize("name", some(NAMES, 3))
def test_every_end_of_every_parameter_can_be_given_by_a_command(name: str) -> None:
    for parameter in find(name).parameters().values():
        for leaf in parameter.distribution.leaves():
            for value in ends(parameter, leaf):
                command = Extreme(0, 0, name, 0, {parameter.name: value}).command(
                    Path("out"), on_collision="keep"
                )
                read = parse_overrides(options(command)["--set"])[parameter.name]
                assert read == value
                assert type(read) is type(value)
                parameter.check_override(read, parameter.name)


def test_whole_numbers_stay_within_their_limits() -> None:
    parameters = [each for name in NAMES for each in find(name).parameters().values() if each.kind is int]
    limited = [each for each in parameters if each.distribution.within is not None]
    assert limited
    for parameter in limited:
        low, high = typing.cast("tuple[float, float]", parameter.distribution.within)
        found = ends(parameter, parameter.distribution.leaves()[0])
        assert min(found) == math.ceil(low)
        assert max(found) == math.floor(high)
