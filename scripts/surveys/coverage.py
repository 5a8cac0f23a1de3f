"""Coverage of the options and ranges of a category by its draws."""

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
"""Equal parts of a range; one draw reaches a part."""

LEAST_BINS = 9
"""Parts that enough draws have to reach: the last part of a bell curve's tail may stay free."""

MOST_OPTIONS = 20
"""Whole numbers with more options, such as the number of a model, count as ranges."""

LEAST_MATERIALS = 0.9
"""Least share of the materials of a parameter that has to be drawn: rare colors may be missing."""

_LUCK = 1e-4  # probability that uniform draws reach fewer parts than demanded


@dataclass
class Options:
    """The number of draws of each option of a parameter."""

    name: str  # full name of the parameter
    kind: Any  # annotation of the parameter: `int`, `Material`, a literal
    # number of draws of each option, by its name in the source
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
    """The distribution of draws in the range of a number."""

    name: str  # full name of the parameter
    branch: str  # values of structural parameters for this range; empty if there is only one
    unit: str  # unit of the number
    low: float  # lower end of the range
    high: float  # upper end of the range
    # number of draws in each of `BINS` equal parts
    bins: list[int] = field(default_factory=lambda: [0] * BINS)
    least: float = math.inf  # the lowest draw; infinite if there is none
    most: float = -math.inf  # the highest draw

    def add(self, value: float) -> None:
        """Count a draw."""
        share = (value - self.low) / (self.high - self.low)
        self.bins[min(int(share * BINS), BINS - 1)] += 1
        self.least, self.most = min(self.least, value), max(self.most, value)

    @property
    def drawn(self) -> int:
        """Number of draws."""
        return sum(self.bins)

    @property
    def hit(self) -> int:
        """Number of parts that were reached."""
        return sum(count > 0 for count in self.bins)

    @property
    def filled(self) -> bool:
        """Whether enough parts were reached."""
        return self.hit >= demanded(self.drawn)


@dataclass
class Coverage:
    """The draws of a category."""

    category: str  # name of the category
    seeds: int  # number of seeds
    # parameters with options, in the order of the signature
    options: dict[str, Options] = field(default_factory=dict)
    spreads: dict[tuple[str, str], Spread] = field(default_factory=dict)  # ranges of numbers

    @property
    def missing(self) -> tuple[str, ...]:
        """The options that were never drawn, as `parameter = option`."""
        return tuple(f"{each.name} = {option}" for each in self.options.values() for option in each.missing)

    @property
    def faults(self) -> tuple[str, ...]:
        """The missing options and ranges."""
        lacking = [each for each in self.options.values() if not each.occurs]
        return (*(f"{each.name} is never {', '.join(each.missing)}" for each in lacking), *self.unfilled)

    @property
    def unfilled(self) -> tuple[str, ...]:
        """The ranges that draws do not fill, with the range of the draws."""
        return tuple(
            f"{each.name}{f' ({each.branch})' if each.branch else ''}: {each.hit} of {BINS} parts of "
            f"{each.low:g} to {each.high:g} in {each.drawn} draws"
            for each in self.spreads.values()
            if not each.filled
        )


def coverage(category: Generator, seeds: int = 500, *, first: int = 0) -> Coverage:
    """Draw the parameters of many seeds, and count them.

    These are the first draws of the seeds: nothing is built, and requirements rule nothing out.
    """
    result = Coverage(category.name, seeds)
    for parameter in category.parameters().values():
        _enter(result, parameter)
    for seed in range(first, first + seeds):
        _count(result, category.own, category.sample(seed), "", "")
    return result


def demanded(drawn: int) -> int:
    """Return the number of parts of a range that a number of draws have to reach.

    It is at most `LEAST_BINS`, and a number that uniform draws miss with the probability `_LUCK` only.
    """
    chances = [1.0] + [0.0] * BINS  # probability of each number of reached parts
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
    """Yield the distributions between which structural parameters choose, with the condition of each."""
    if not isinstance(distribution, By):
        yield ", ".join(path), distribution
        return
    for key, case in distribution.cases:
        yield from branches(case, (*path, f"{distribution.parameter}={key}"))


def _enter(result: Coverage, parameter: Parameter) -> None:
    """Enter a parameter with its options and ranges."""
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
    """Return the options of a distribution; nothing for numbers in a range."""
    if not leaf.discrete or (leaf.numeric and len(leaf.support()) > MOST_OPTIONS):
        return ()
    weights = leaf.weights if isinstance(leaf, Choice) else None
    pairs = zip(leaf.support(), weights or (1.0,) * len(leaf.support()), strict=True)
    return tuple(option for option, weight in pairs if weight > 0.0)


def _count(
    result: Coverage, own: Mapping[str, Parameter], values: Mapping[str, Any], short: str, full: str
) -> None:
    """Count the parameters of a generator and of the generators that it chose."""
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
    """Return the distribution that the structural parameters chose, with its condition."""
    path: list[str] = []
    while isinstance(distribution, By):
        case = distribution.case(given[distribution.parameter])
        assert case is not None
        key = next(key for key, other in distribution.cases if other is case)
        path.append(f"{distribution.parameter}={key}")
        distribution = case
    return ", ".join(path), distribution


def _spelled(leaf: Distribution, value: Any) -> str:
    """Return the name of an option: of a shade, the material; of a number, a short form."""
    if isinstance(leaf, Shades):
        names = [option.name for option in leaf.options]
        name = str(value.name)
        return name if name in names else name.rpartition("_")[0]
    if is_number(value) and not isinstance(value, int):
        return f"{value:g}"
    return value if isinstance(value, str) and value else shown(value)
