"""Corners of the parameter ranges of a category: every number at its lowest or highest value."""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from artgen.generator import Generator, Parameter
from artgen.generator.draw import Overrides
from artgen.generator.parameter import Variant
from artgen.sampling import Distribution, stream
from artgen.sampling.choices import By
from artgen.sampling.distributions import shown

MOST_CORNERS = 256
_MOST_EXACT = 8  # most varying numbers for which all combinations of their ends are corners
_DRAWS = 64  # seeds whose options are used

Pattern = Mapping[str, int]
"""0 for the low end and 1 for the high end of the range, by parameter name."""


@dataclass(frozen=True)
class _Options:
    """One draw of the options of a category."""

    values: Mapping[str, Any]  # all drawn parameters
    # lowest and highest value of each number that varies with these options
    ranges: Mapping[str, tuple[float, float]]


def corners(category: Generator, seed: int, overrides: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the parameters of the corners of a category, at most about `MOST_CORNERS`.

    With up to 8 varying numbers, the corners are all combinations of their ends. With more numbers, they are
    each number alone at either end with the others as drawn, and combinations from a fixed random stream.
    Options, such as a layout or a sub-generator, are drawn from `seed` and the following seeds.
    """
    options = _drawn_options(category, seed, overrides)
    names = sorted({name for each in options for name in each.ranges})
    patterns = _patterns(names, category.name) if names else []
    rounds = min(len(options), max(1, MOST_CORNERS // max(1, len(patterns))))
    found: dict[tuple[str, ...], dict[str, Any]] = {}
    for turn in range(rounds):
        for number, pattern in enumerate(patterns):
            chosen = next(_with_one_of(pattern, options, turn + number))
            ends = {name: chosen.ranges[name][end] for name, end in pattern.items() if name in chosen.ranges}
            values = {**chosen.values, **ends}
            found.setdefault(tuple(f"{name}={shown(value)}" for name, value in values.items()), values)
    return list(found.values())


def _drawn_options(category: Generator, seed: int, overrides: Mapping[str, Any]) -> list[_Options]:
    """Return the different draws of options of several seeds, in order."""
    given = Overrides(category, overrides)
    found: dict[tuple[str, ...], _Options] = {}
    for number in range(seed, seed + _DRAWS):
        values = category.sample(number, overrides=overrides)
        ranges = dict(_ranges(category.own, values, given))
        fixed = tuple(f"{name}={shown(value)}" for name, value in values.items() if name not in ranges)
        found.setdefault(fixed, _Options(values, ranges))
    return list(found.values())


def in_use(
    own: Mapping[str, Parameter], values: Mapping[str, Any], given: Overrides, short: str = "", full: str = ""
) -> Iterator[tuple[str, Parameter, Distribution]]:
    """Yield each used parameter with its name in `values` and its distribution for the drawn options."""
    for name, declared in own.items():
        value = values[short + name]
        parameter = Parameter(full + name, declared.kind, declared.distribution)
        distribution = given.distribution(parameter)
        while isinstance(distribution, By):
            case = distribution.case(values[short + distribution.parameter])
            assert case is not None, "the draw would have failed"
            distribution = case
        yield short + name, parameter, distribution
        if isinstance(value, Variant):
            yield from in_use(value.own, values, given, f"{short}{name}.", f"{full}{name}.{value.name}.")


def _ranges(
    own: Mapping[str, Parameter], values: Mapping[str, Any], given: Overrides
) -> Iterator[tuple[str, tuple[float, float]]]:
    """Yield the range of each number that varies, for the drawn options."""
    for name, _, distribution in in_use(own, values, given):
        if not distribution.discrete:
            low, high = distribution.support()
            if low < high:
                yield name, (low, high)


def _patterns(names: Sequence[str], category: str) -> list[Pattern]:
    """Return the end of each number by pattern; numbers without an end stay as drawn."""
    if len(names) <= _MOST_EXACT:
        ends = itertools.product((0, 1), repeat=len(names))
        return [dict(zip(names, each, strict=True)) for each in ends]
    patterns: list[Pattern] = [dict.fromkeys(names, end) for end in (0, 1)]
    patterns += [{name: end} for name in names for end in (0, 1)]
    random = stream(0, f"{category}/corners")
    while len(patterns) < MOST_CORNERS:
        patterns.append(dict(zip(names, random.integers(0, 2, len(names)).tolist(), strict=True)))
    return patterns[:MOST_CORNERS]


def _with_one_of(pattern: Pattern, options: Sequence[_Options], first: int) -> Iterator[_Options]:
    """Yield the options in which a number of the pattern varies, starting with one of them."""
    for index in range(len(options)):
        each = options[(first + index) % len(options)]
        if any(name in each.ranges for name in pattern):
            yield each
