"""Distributions over options, and distributions that depend on an option."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from artgen._arrays import cached_property
from artgen.errors import ParameterError, nearest
from artgen.sampling.distributions import Distribution, Fixed, Within, as_number, limited, shown


@dataclass(frozen=True)
class Choice(Distribution):
    """One of several options."""

    options: tuple[Any, ...] = ()
    weights: tuple[float, ...] | None = None

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw an option."""
        return self.options[bisect_right(self._edges, generator.random())]

    @cached_property
    def _edges(self) -> list[float]:
        """The probability of an option or one before it, for each option."""
        edges = np.cumsum(np.ones(len(self.options)) if self.weights is None else self.weights)
        listed: list[float] = (edges / edges[-1]).tolist()
        return listed

    def support(self) -> tuple[Any, ...]:
        """Return the options."""
        return self.options

    @property
    def discrete(self) -> bool:
        """Whether `support` lists every value."""
        return True

    def shares(self) -> tuple[tuple[Any, float], ...]:
        """Return each option with its probability."""
        weights = self.weights or (1.0,) * len(self.options)
        return tuple(
            (item, weight / sum(weights)) for item, weight in zip(self.options, weights, strict=True)
        )

    def __repr__(self) -> str:
        return f"choice({', '.join(map(shown, self.options))})"


def choice(
    *options: Any,
    weights: Sequence[float] | None = None,
    unit: str = "",
    doc: str = "",
    within: Within = None,
) -> Any:
    """Draw one of the options: `choice("lever", "knob")`, or by weight `choice({"lever": 0.7, "knob": 0.3})`.

    Args:
        *options: The options, or one mapping from options to their weights.
        weights: Weights of the options; equally likely without weights.
        unit: Unit of the value.
        doc: Description of the parameter.
        within: Hard limits for overrides.

    Raises:
        ParameterError: There are no options, an option is a distribution, or the weights do not match them.
    """
    if len(options) == 1 and isinstance(options[0], Mapping):
        if weights is not None:
            raise ParameterError("choice takes the weights from its mapping, or as weights=..., not both")
        options, weights = tuple(options[0]), tuple(options[0].values())
    if not options:
        raise ParameterError("choice needs at least one option")
    for option in options:
        if isinstance(option, Distribution):
            raise ParameterError(
                f"choice: the option {option!r} is a distribution; choose by a structural parameter: by(...)"
            )
    made = Choice(unit, doc, None, options)
    if weights is not None:
        listed: Any = weights
        listed = tuple(listed) if isinstance(listed, Iterable) else (listed,)
        numbers = tuple(as_number(weight, f"{made!r}: a weight") for weight in listed)
        if len(numbers) != len(options) or min(numbers) < 0.0 or sum(numbers) <= 0.0:
            raise ParameterError(
                f"{made!r}: {len(options)} options need as many weights, none negative and not all 0; "
                f"got {listed}"
            )
        made = replace(made, weights=numbers)
    return limited(made, within)


def count(
    low: int,
    high: int,
    *,
    weights: Sequence[float] | None = None,
    unit: str = "",
    doc: str = "",
    within: Within = None,
) -> Any:
    """Draw a whole number from `low` to `high`, both included.

    Raises:
        ParameterError: A bound is not a whole number, or `low` exceeds `high`.
    """
    for bound in (low, high):
        if isinstance(bound, bool) or not isinstance(bound, int):
            raise ParameterError(f"count: bounds must be whole numbers, got {bound!r}")
    if low > high:
        raise ParameterError(f"count({low}, {high}): low exceeds high; swap them")
    return choice(*range(low, high + 1), weights=weights, unit=unit, doc=doc, within=within)


OTHERWISE = "otherwise"
"""Case of `by` for all values without their own case."""


@dataclass(frozen=True)
class By(Distribution):
    """A distribution for each value of a structural parameter."""

    parameter: str = ""
    cases: tuple[tuple[Any, Distribution], ...] = ()

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw from the case of the structural parameter."""
        case = self.case(given[self.parameter])
        if case is None:
            chosen = case_key(given[self.parameter])
            raise ParameterError(
                f"by({self.parameter!r}, ...) has no case for {chosen!r}."
                + nearest(str(chosen), [str(key) for key, _ in self.cases])
            )
        return case.draw(generator, given)

    def case(self, value: Any) -> Distribution | None:
        """Return the distribution for a value of the structural parameter; None if there is none."""
        wanted = case_key(value)
        for key, case in self.cases:
            if (key == wanted and isinstance(key, bool) == isinstance(wanted, bool)) or key == OTHERWISE:
                return case
        return None

    def support(self) -> tuple[Any, ...]:
        """Return the lowest and highest value, or the options, over all cases."""
        ends = [value for leaf in self.leaves() for value in leaf.support()]
        if not any(leaf.discrete for leaf in self.leaves()):
            return min(ends), max(ends)
        return tuple(value for index, value in enumerate(ends) if value not in ends[:index])

    def leaves(self) -> tuple[Distribution, ...]:
        """Return the distributions of all cases."""
        return tuple(leaf for _, case in self.cases for leaf in case.leaves())

    def needs(self) -> tuple[str, ...]:
        """Return the names of the parameters that the draw depends on."""
        return self._needs

    @cached_property
    def _needs(self) -> tuple[str, ...]:
        return (self.parameter, *dict.fromkeys(name for _, case in self.cases for name in case.needs()))

    def __repr__(self) -> str:
        return f"by({self.parameter!r}, {', '.join(f'{key}={case!r}' for key, case in self.cases)})"


def case_key(value: Any) -> Any:
    """Return the key of a value in the cases of `by`: generators and materials by name."""
    return getattr(value, "name", value)


def by(
    parameter: str,
    cases: Mapping[Any, Any] | None = None,
    /,
    *,
    unit: str = "",
    doc: str = "",
    within: Within = None,
    **named: Any,
) -> Any:
    """Draw from a distribution that depends on a structural parameter.

    Args:
        parameter: Name of a structural parameter of the same generator.
        cases: Distribution or value for each of its values that is not an identifier. In place of a
            distribution, a mapping is the weights of a choice.
        unit: Unit of the value.
        doc: Description of the parameter.
        within: Hard limits for overrides.
        **named: Distribution or value for each of its values; `otherwise` for the remaining values.

    Raises:
        ParameterError: There are no cases, or a case has its own hard limits.
    """
    if not isinstance(cases, Mapping | None):
        raise ParameterError(f"by({parameter!r}): the cases must be a mapping from its values, got {cases!r}")
    together = {case_key(key): case for key, case in {**(cases or {}), **named}.items()}
    if not together:
        raise ParameterError(f"by({parameter!r}) needs a distribution for each value of {parameter!r}")
    # "otherwise" matches everything, so it comes last
    ordered = tuple(
        (key, _distribution(case))
        for key, case in sorted(together.items(), key=lambda item: item[0] == OTHERWISE)
    )
    for key, case in ordered:
        if case.within is not None:
            raise ParameterError(
                f"by({parameter!r}, {key}=...): hard limits hold for all cases; give within=... to by itself"
            )
    return limited(By(unit, doc, None, parameter, ordered), within)


def _distribution(case: Any) -> Distribution:
    """Return the distribution of a case: a distribution, weights by option, or a fixed value."""
    if isinstance(case, Mapping):
        case = choice(case)
    return case if isinstance(case, Distribution) else Fixed(value=case)
