"""Samples at the ends of ranges: combinations that ordinary draws never meet."""

import math
import shlex
import typing
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from artgen.catalog import categories, find
from artgen.errors import ParameterError
from artgen.generator import Generator, Parameter
from artgen.generator.corners import in_use
from artgen.generator.draw import Overrides
from artgen.generator.overrides import spelled
from artgen.materials import MATERIALS, Material
from artgen.nodes.handles import Bool
from artgen.sampling import Distribution, stream
from artgen.sampling.distributions import is_number

SHARES = (0.1, 0.3, 0.6)
"""Share of the parameters at an end: one alone, some, and most of them."""

_SEEDS = 10_000  # number of seeds of the other parameters


@dataclass(frozen=True)
class Extreme:
    """A sample at the ends of ranges."""

    run: int  # seed of the run
    number: int  # number of the sample in the run
    category: str  # name of the category
    seed: int  # seed of all other parameters
    overrides: Mapping[str, Any]  # values by name; generators and materials by their names

    def command(self, out: Path, *, on_collision: str) -> str:
        """Return the shell command that makes it."""
        command = ["artgen", "generate", self.category, "--seed", str(self.seed)]
        for each in spelled(self.overrides):
            command += ["--set", each]
        command += ["--textures", "none", "--on-collision", on_collision, "--out", str(out)]
        return shlex.join(command)


def category_of(number: int) -> str:
    """Return the category of a sample; categories are sampled in turn."""
    names = categories()
    return names[number % len(names)]


def draw_extreme(run: int, number: int) -> Extreme:
    """Draw the sample of a seed of the run and a number.

    Options are put at an end before what depends on them: first the category's own, then those of the
    generators that were chosen, then numbers.
    """
    category = find(category_of(number))
    random = stream(run, "extremes", number)
    seed, share = int(random.integers(_SEEDS)), SHARES[random.integers(len(SHARES))]
    overrides: dict[str, Any] = {}
    seen: set[str] = set()
    while True:
        found = _next_in_use(category, seed, overrides, seen)
        if not found:
            return Extreme(run, number, category.name, seed, overrides)
        for name, parameter, distribution in found:
            seen.add(name)
            own = stream(run, f"extremes/{category.name}/{parameter.name}", number)
            values = ends(parameter, distribution)
            if own.random() < share and len(values) > 1:
                more = {**overrides, name: values[own.integers(len(values))]}
                if not parameter.structural or _can_be_drawn(category, seed, more):
                    overrides = more


def _can_be_drawn(category: Generator, seed: int, overrides: Mapping[str, Any]) -> bool:
    """Tell whether a category has samples with these values: some options exclude others."""
    try:
        category.sample(seed, overrides=overrides)
    except ParameterError:
        return False
    return True


def _next_in_use(
    category: Generator, seed: int, overrides: Mapping[str, Any], seen: set[str]
) -> list[tuple[str, Parameter, Distribution]]:
    """Return the next parameters: the outermost new ones that depend on no unseen one."""
    values = category.sample(seed, overrides=overrides)
    given = Overrides(category, overrides)
    left = [each for each in in_use(category.own, values, given) if each[0] not in seen]
    names = {name for name, _, _ in left}
    ready = [each for each in left if not _needs(*each[:2]) & names]
    turns = [(not parameter.structural, name.count(".")) for name, parameter, _ in ready]
    return [each for each, turn in zip(ready, turns, strict=True) if turn == min(turns)]


def _needs(name: str, parameter: Parameter) -> set[str]:
    """Return the names of the options on which the range of a parameter depends."""
    owner = name.rpartition(".")[0]
    return {f"{owner}.{needed}" if owner else needed for needed in parameter.distribution.needs()}


def ends(parameter: Parameter, distribution: Distribution) -> list[Any]:
    """Return the extreme values of a parameter, as the command line names them.

    For a number, these are the ends of its distribution and of its hard limits; else all options.
    Materials without a name in the table of materials are omitted.
    """
    if parameter.kind in (bool, Bool):
        return [False, True]
    if typing.get_origin(parameter.kind) is Literal:
        return list(typing.get_args(parameter.kind))
    if distribution.numeric:
        return _ends_of_number(parameter, distribution)
    options = parameter.distribution.support()
    named = [each for each in options if not isinstance(each, Material) or each.name in MATERIALS]
    return list(dict.fromkeys(getattr(each, "name", each) for each in named))


def _ends_of_number(parameter: Parameter, distribution: Distribution) -> list[float]:
    """Return the ends of a distribution, or its options, and the ends of the hard limits."""
    values = [value for value in distribution.support() if is_number(value)]
    if parameter.distribution.within is not None:
        low, high = parameter.distribution.within
        values += [math.ceil(low), math.floor(high)] if parameter.kind is int else [low, high]
    return list(dict.fromkeys(values))
