"""Hypothesis strategies for the parameters and assets of any generator.

    from hypothesis import given
    from artgen.testing.strategies import parameters

    @given(overrides=parameters(nightstand))
    def test_the_drawer_fits(overrides):
        stand = nightstand.generate(**overrides)

Failing examples shrink towards the center of each range and the first option of each choice.
"""

import math
from collections.abc import Mapping
from typing import Any

from hypothesis import reject
from hypothesis import strategies as st

from artgen.asset import Asset
from artgen.errors import InfeasibleError
from artgen.generator import Generator, Parameter
from artgen.generator.draw import Overrides, drawing_order
from artgen.generator.parameter import Variant, is_variant
from artgen.materials import MATERIALS, Material
from artgen.sampling import Distribution, Fixed
from artgen.sampling.choices import By, Choice
from artgen.sampling.distributions import LogUniform, Normal
from artgen.testing.category import found_generator

__all__ = ["assets", "parameters"]


def parameters(
    generator: Generator | str,
    *,
    structural: bool = True,
    hard_limits: bool = False,
    overrides: Mapping[str, Any] | None = None,
) -> st.SearchStrategy[dict[str, Any]]:
    """Return a strategy of valid overrides for a generator: `generator.generate(**overrides)`.

    Numbers lie within the range of their distribution, ends included. Choices are options with a positive
    weight. Parameters that depend on others are drawn accordingly. Fixed parameters keep their value.

    Args:
        generator: A generator, or the name of a category.
        structural: Whether to choose structural parameters as well; otherwise they and everything that
            depends on them are left to the seed.
        hard_limits: Whether numbers, including fixed parameters, may lie anywhere within their hard limits,
            if they have such limits.
        overrides: Values or distributions by parameter name; part of each result.

    Raises:
        ParameterError: There is no category of that name, it is not a generator, or an override is unknown or
            not allowed.
    """
    chosen = found_generator(generator)
    given = {name.replace("__", "."): value for name, value in (overrides or {}).items()}
    checked = Overrides(chosen, given)

    @st.composite
    def drawn(draw: st.DrawFn) -> dict[str, Any]:
        drawing = _Drawing(draw, checked, structural=structural, hard_limits=hard_limits)
        drawing.add(chosen)
        return {**given, **drawing.result}

    return drawn()


def assets(
    generator: Generator | str, *, structural: bool = True, certify: bool = False, **options: Any
) -> st.SearchStrategy[Asset]:
    """Return a strategy of assets of a generator; infeasible samples are rejected.

    Args:
        generator: A generator, or the name of a category.
        structural: As for `parameters`.
        certify: Whether to certify each asset; an asset with colliding parts is kept, with a certificate that
            says so.
        options: Other options of `parameters`.

    Raises:
        ParameterError: As for `parameters`.
    """
    chosen = found_generator(generator)
    seeds = st.just(0) if structural else st.integers(0, 2**32 - 1)
    wanted = parameters(chosen, structural=structural, **options)

    def made(seed: int, values: dict[str, Any]) -> Asset:
        try:
            return chosen.generate(seed, attempts=1, certify=certify, on_collision="keep", **values)
        except InfeasibleError:
            reject()

    return st.builds(made, seeds, wanted)


class _Drawing:
    """One draw of overrides; those of unselected generators are discarded, so that examples shrink alike."""

    def __init__(self, draw: st.DrawFn, overrides: Overrides, *, structural: bool, hard_limits: bool) -> None:
        self._draw, self._overrides = draw, overrides
        self._structural, self._hard_limits = structural, hard_limits
        self.result: dict[str, Any] = {}  # drawn values by full name

    def add(self, variant: Variant, prefix: str = "", *, used: bool = True) -> None:
        """Draw the parameters of a generator and of the generators that it selects, in dependence order."""
        parameters = {
            name: Parameter(prefix + name, own.kind, own.distribution) for name, own in variant.own.items()
        }
        distributions = {name: self._overrides.distribution(each) for name, each in parameters.items()}
        known: dict[str, Any] = {}  # values that this draw decides
        for name in drawing_order(distributions, variant.name):
            parameter, distribution = parameters[name], distributions[name]
            self._add_own(parameter, name, distribution, known, used=used)
            if is_variant(parameter.kind):
                possible = [option for leaf in distribution.leaves() for option in leaf.support()]
                for option in dict.fromkeys(map(parameter.accept, possible)):
                    # the seed will choose: any generator may be used
                    chosen = known.get(name, option) is option
                    self.add(option, f"{parameter.name}.{option.name}.", used=used and chosen)

    def _add_own(
        self,
        parameter: Parameter,
        name: str,
        distribution: Distribution,
        known: dict[str, Any],
        *,
        used: bool,
    ) -> None:
        """Draw one parameter, unless it is fixed or left to the seed."""
        if parameter.structural and not self._structural:
            if isinstance(distribution, Fixed):
                known[name] = parameter.accept(distribution.value)
            return
        own = distribution is parameter.distribution
        within = distribution.within if own and self._hard_limits and not parameter.structural else None
        share = self._draw(_shares(distribution, within))
        while isinstance(distribution, By):
            case = known.get(distribution.parameter, _UNKNOWN)
            found = None if case is _UNKNOWN else distribution.case(case)
            if found is None:
                return  # the seed decides, or `generate` reports the error of the override
            distribution = found
        known[name] = value = parameter.accept(_placed(distribution, share, within))
        if used and not (isinstance(distribution, Fixed) and within is None):
            # a name is more readable than the value, if it is enough
            named = isinstance(value, Variant) or (
                isinstance(value, Material) and MATERIALS.get(value.name) == value
            )
            self.result[parameter.name] = value.name if named else value


_UNKNOWN = object()
_INSIDE = st.floats(-1.0, 1.0, allow_subnormal=False)
# a quarter of the values lies at the ends
_SHARES = st.one_of(_INSIDE, _INSIDE, _INSIDE, st.sampled_from([-1.0, 1.0]))


def _shares(distribution: Distribution, within: tuple[float, float] | None) -> st.SearchStrategy[float]:
    """Return a strategy of shares for `_placed`: 0 is the simplest value, -1 and 1 are the extremes."""
    leaves = distribution.leaves()
    if within is not None or not all(leaf.discrete for leaf in leaves):
        return _SHARES
    most = max(len(_options(leaf)) for leaf in leaves)
    return st.integers(0, most - 1).map(lambda index: index / most)


def _placed(distribution: Distribution, share: float, within: tuple[float, float] | None) -> Any:
    """Return the value at a share of the way from the center of a range to an end: -1 and 1 are the ends."""
    if distribution.discrete and not (within is not None and distribution.numeric):
        options = _options(distribution)
        # indices of `_shares` over as many options or more
        return options[min(int(abs(share) * len(options) + 1e-9), len(options) - 1)]
    low, high = within or distribution.support()
    if abs(share) == 1.0:
        return high if share > 0.0 else low  # exactly, without rounding
    middle = min(max(_middle(distribution, low, high), low), high)
    number = middle + share * ((high - middle) if share > 0.0 else (middle - low))
    return min(max(number, low), high)


def _options(distribution: Distribution) -> list[Any]:
    """Return the possible values of a discrete distribution."""
    if isinstance(distribution, Choice) and distribution.weights is not None:
        pairs = zip(distribution.options, distribution.weights, strict=True)
        return [option for option, weight in pairs if weight > 0.0]
    return list(distribution.support())


def _middle(distribution: Distribution, low: float, high: float) -> float:
    """Return the center of a distribution between two ends."""
    if isinstance(distribution, Normal):
        return distribution.mean
    if isinstance(distribution, Fixed):
        return float(distribution.value)
    if isinstance(distribution, LogUniform) and low > 0.0:
        return math.sqrt(low * high)
    return low + (high - low) / 2.0
