"""How well draws cover what a category may draw: every option, and all of every range."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from artgen.generator import Generator
from artgen.generator.parameter import Parameter, Variant
from artgen.generator.shades import Shades
from artgen.materials import Material
from artgen.sampling import Distribution
from artgen.sampling.choices import By, Choice
from artgen.sampling.distributions import is_number, shown

BINS = 10
"""Equal parts of a range, each of which counts as reached by one draw in it."""

LEAST_BINS = 9
"""Parts that enough draws reach: one may stay free, as the last part of a bell curve's tail does."""

MOST_OPTIONS = 20
"""Whole numbers with more options than these, as the number of a model is one, are judged as ranges."""

LEAST_MATERIALS = 0.9
"""Share of the materials of a parameter that are drawn at least: a rare colour is no style of its own."""

_LUCK = 1e-4  # chance with which even draws may reach fewer parts than are asked of them


@dataclass
class Options:
    """A parameter that has some values, and how often each was drawn.

    Attributes:
        name: Its full name.
        kind: Its annotation: `int`, `Material`, a literal.
        counts: How often each option was drawn, by how authors know it, those included that never were.
    """

    name: str
    kind: Any
    counts: dict[str, int] = field(default_factory=dict)

    @property
    def missing(self) -> tuple[str, ...]:
        """The options that were never drawn."""
        return tuple(option for option, count in self.counts.items() if not count)

    @property
    def varies(self) -> bool:
        """Whether there is more than one option."""
        return len(self.counts) > 1

    @property
    def occurs(self) -> bool:
        """Whether every option was drawn; of materials, most of them."""
        least = LEAST_MATERIALS if self.kind is Material else 1.0
        return len(self.missing) <= (1.0 - least) * len(self.counts)


@dataclass
class Spread:
    """A range of a number, and where draws fell in it.

    Attributes:
        name: Full name of the parameter.
        branch: Values of structural parameters under which it has this range; empty if it has no other.
        unit: Its unit.
        low: Lower end of the range.
        high: Upper end.
        bins: How many draws fell into each of `BINS` equal parts.
        least: The lowest that was drawn; infinite if nothing was.
        most: The highest.
    """

    name: str
    branch: str
    unit: str
    low: float
    high: float
    bins: list[int] = field(default_factory=lambda: [0] * BINS)
    least: float = math.inf
    most: float = -math.inf

    def add(self, value: float) -> None:
        """Count a draw."""
        share = (value - self.low) / (self.high - self.low)
        self.bins[min(int(share * BINS), BINS - 1)] += 1
        self.least, self.most = min(self.least, value), max(self.most, value)

    @property
    def drawn(self) -> int:
        """How many draws there were."""
        return sum(self.bins)

    @property
    def hit(self) -> int:
        """How many parts of the range were reached."""
        return sum(count > 0 for count in self.bins)

    @property
    def filled(self) -> bool:
        """Whether as many parts were reached as have to be."""
        return self.hit >= demanded(self.drawn)


@dataclass
class Coverage:
    """What a category drew.

    Attributes:
        category: Its name.
        seeds: How many seeds were drawn.
        options: Its parameters with options, in the order of its signature.
        spreads: The ranges of its numbers.
    """

    category: str
    seeds: int
    options: dict[str, Options] = field(default_factory=dict)
    spreads: dict[tuple[str, str], Spread] = field(default_factory=dict)

    @property
    def missing(self) -> tuple[str, ...]:
        """The options that were never drawn, as `parameter = option`."""
        return tuple(f"{each.name} = {option}" for each in self.options.values() for option in each.missing)

    @property
    def faults(self) -> tuple[str, ...]:
        """What should have been drawn and was not."""
        lacking = [each for each in self.options.values() if not each.occurs]
        return (*(f"{each.name} is never {', '.join(each.missing)}" for each in lacking), *self.unfilled)

    @property
    def unfilled(self) -> tuple[str, ...]:
        """The ranges that draws leave too much of, with what they reach."""
        return tuple(
            f"{each.name}{f' ({each.branch})' if each.branch else ''}: {each.hit} of {BINS} parts of "
            f"{each.low:g} to {each.high:g} in {each.drawn} draws"
            for each in self.spreads.values()
            if not each.filled
        )


def coverage(category: Generator, seeds: int = 500, *, first: int = 0) -> Coverage:
    """Draw the parameters of many seeds, and count what they cover.

    Nothing is built, so that requirements rule nothing out: these are the first draws of the seeds.

    Args:
        category: The generator.
        seeds: How many seeds are drawn.
        first: The first of them.
    """
    result = Coverage(category.name, seeds)
    for parameter in category.parameters().values():
        _enter(result, parameter)
    for seed in range(first, first + seeds):
        _count(result, category.own, category.sample(seed), "", "")
    return result


def demanded(drawn: int) -> int:
    """Return how many parts of a range so many draws have to reach.

    It is `LEAST_BINS` for many draws, and for few of them what even draws reach but for the worst luck.
    """
    chances = [1.0] + [0.0] * BINS  # of each number of parts reached
    for _ in range(min(drawn, 200)):  # with more than these, all parts are reached
        chances = [
            chance * number / BINS + (chances[number - 1] * (BINS - number + 1) / BINS if number else 0.0)
            for number, chance in enumerate(chances)
        ]
    below = 0.0
    for number, chance in enumerate(chances):
        below += chance
        if below > _LUCK:
            return min(number, LEAST_BINS)
    return LEAST_BINS


def branches(distribution: Distribution, path: tuple[str, ...] = ()) -> Iterator[tuple[str, Distribution]]:
    """Yield the distributions between which structural parameters choose, each with when it is chosen."""
    if not isinstance(distribution, By):
        yield ", ".join(path), distribution
        return
    for key, case in distribution.cases:
        yield from branches(case, (*path, f"{distribution.parameter}={key}"))


def _enter(result: Coverage, parameter: Parameter) -> None:
    """Enter a parameter with all that it may be."""
    for branch, leaf in branches(parameter.distribution):
        options = _possible(leaf)
        if options:
            entered = result.options.setdefault(parameter.name, Options(parameter.name, parameter.kind))
            for option in options:
                entered.counts.setdefault(_spelled(leaf, option), 0)
        elif min(leaf.support()) < max(leaf.support()):
            unit = leaf.unit or parameter.distribution.unit
            low, high = float(min(leaf.support())), float(max(leaf.support()))
            result.spreads[parameter.name, branch] = Spread(parameter.name, branch, unit, low, high)


def _possible(leaf: Distribution) -> tuple[Any, ...]:
    """Return the options of a distribution; nothing if it is of numbers in a range."""
    if not leaf.discrete or (leaf.numeric and len(leaf.support()) > MOST_OPTIONS):
        return ()
    weights = leaf.weights if isinstance(leaf, Choice) else None
    pairs = zip(leaf.support(), weights or (1.0,) * len(leaf.support()), strict=True)
    return tuple(option for option, weight in pairs if weight > 0.0)


def _count(
    result: Coverage, own: Mapping[str, Parameter], values: Mapping[str, Any], short: str, full: str
) -> None:
    """Count the values of one generator's parameters, and of those of the generators that it chose.

    Args:
        result: Where they are counted.
        own: Its own parameters by name.
        values: What was drawn.
        short: What stands before their names in `values`.
        full: What stands before their names in full.
    """
    given = {name: values[short + name] for name in own}
    for name, parameter in own.items():
        value = given[name]
        branch, leaf = _chosen(parameter.distribution, given)
        if (full + name, branch) in result.spreads:
            result.spreads[full + name, branch].add(value)
        elif leaf.discrete:
            result.options[full + name].counts[_spelled(leaf, value)] += 1
        if isinstance(value, Variant):
            _count(result, value.own, values, f"{short}{name}.", f"{full}{name}.{value.name}.")


def _chosen(distribution: Distribution, given: Mapping[str, Any]) -> tuple[str, Distribution]:
    """Return which distribution the structural parameters chose, and when it is chosen."""
    path: list[str] = []
    while isinstance(distribution, By):
        case = distribution.case(given[distribution.parameter])
        assert case is not None
        key = next(key for key, other in distribution.cases if other is case)
        path.append(f"{distribution.parameter}={key}")
        distribution = case
    return ", ".join(path), distribution


def _spelled(leaf: Distribution, value: Any) -> str:
    """Spell an option: a shade by the name of its material, a number in short."""
    if isinstance(leaf, Shades):
        names = [option.name for option in leaf.options]
        name = str(value.name)
        return name if name in names else name.rpartition("_")[0]
    if is_number(value) and not isinstance(value, int):
        return f"{value:g}"
    return value if isinstance(value, str) and value else shown(value)
