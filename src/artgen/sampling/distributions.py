"""Distributions: values that say how a parameter is drawn, checked when they are made."""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen.errors import ParameterError, nearest

Within = tuple[float, float] | None


@dataclass(frozen=True)
class Distribution(ABC):
    """How a parameter is drawn.

    Attributes:
        unit: Unit of the value, such as `m`; empty for none.
        doc: What the parameter is.
        within: Hard limits; an override outside them is refused. The support of the distribution is no limit.
    """

    unit: str = ""
    doc: str = ""
    within: Within = None

    @abstractmethod
    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw a value; `given` has the structural parameters drawn before."""

    @abstractmethod
    def support(self) -> tuple[Any, ...]:
        """Return the lowest and highest value, or the options."""

    @property
    def numeric(self) -> bool:
        """Whether every value is a number."""
        return True

    def check(self, name: str, value: Any) -> None:
        """Check an overriding value against the hard limits.

        Raises:
            ParameterError: It lies outside them.
        """
        if self.within is None or isinstance(value, bool | str):
            return
        low, high = self.within
        if not low <= value <= high:
            raise ParameterError(
                f"{name} = {value!r} is out of range: {low:.6g} to {high:.6g}{_unit(self.unit)} is allowed"
            )

    def needs(self) -> tuple[str, ...]:
        """Return the names of the parameters that the draw depends on."""
        return ()


def _unit(unit: str) -> str:
    return f" {unit}" if unit else ""


def _number(value: Any, what: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ParameterError(f"{what} must be a finite number, got {value!r}")
    return float(value)


def _check_within(within: Within, what: str) -> Within:
    if within is None:
        return None
    low, high = (_number(end, f"{what}: within") for end in within)
    if low > high:
        raise ParameterError(f"{what}: within=({low:.6g}, {high:.6g}) has its lower end above its upper end")
    return low, high


@dataclass(frozen=True)
class Uniform(Distribution):
    """Every value between `low` and `high` is equally likely."""

    low: float = 0.0
    high: float = 1.0

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> float:
        """Draw a number."""
        return float(self.low + (self.high - self.low) * generator.random())

    def support(self) -> tuple[float, float]:
        """Return the lowest and highest value."""
        return self.low, self.high

    def __repr__(self) -> str:
        return f"uniform({self.low:g}, {self.high:g})"


def uniform(low: float, high: float, unit: str = "", *, doc: str = "", within: Within = None) -> Any:
    """Draw a number between `low` and `high`, all equally likely.

    Raises:
        ParameterError: A bound is no finite number, or `low` exceeds `high`.
    """
    low, high = _number(low, "uniform: low"), _number(high, "uniform: high")
    if low > high:
        raise ParameterError(f"uniform({low:g}, {high:g}): low exceeds high; swap them")
    return Uniform(unit, doc, _check_within(within, f"uniform({low:g}, {high:g})"), low, high)


@dataclass(frozen=True)
class Normal(Distribution):
    """A bell curve cut off at `low` and `high`."""

    mean: float = 0.0
    deviation: float = 1.0
    low: float = -math.inf
    high: float = math.inf

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> float:
        """Draw a number; values beyond the cut are drawn again."""
        for _ in range(1000):
            value = self.mean + self.deviation * float(generator.standard_normal())
            if self.low <= value <= self.high:
                return value
        return min(max(self.mean, self.low), self.high)

    def support(self) -> tuple[float, float]:
        """Return the lowest and highest value."""
        return self.low, self.high

    def __repr__(self) -> str:
        return f"normal({self.mean:g}, {self.deviation:g}, {self.low:g}, {self.high:g})"


def normal(
    mean: float,
    deviation: float,
    low: float,
    high: float,
    unit: str = "",
    *,
    doc: str = "",
    within: Within = None,
) -> Any:
    """Draw a number from a bell curve that is cut off at `low` and `high`.

    Raises:
        ParameterError: A number is not finite, the deviation is not positive, or `low` exceeds `high`.
    """
    mean, deviation = _number(mean, "normal: mean"), _number(deviation, "normal: deviation")
    low, high = _number(low, "normal: low"), _number(high, "normal: high")
    if deviation <= 0.0:
        raise ParameterError(f"normal: deviation must be positive, got {deviation:g}")
    if not low <= mean <= high:
        raise ParameterError(f"normal: the mean {mean:g} must lie between low {low:g} and high {high:g}")
    return Normal(unit, doc, _check_within(within, "normal"), mean, deviation, low, high)


@dataclass(frozen=True)
class LogUniform(Distribution):
    """Every ratio between `low` and `high` is equally likely."""

    low: float = 1.0
    high: float = 10.0

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> float:
        """Draw a number."""
        return float(self.low * (self.high / self.low) ** generator.random())

    def support(self) -> tuple[float, float]:
        """Return the lowest and highest value."""
        return self.low, self.high

    def __repr__(self) -> str:
        return f"loguniform({self.low:g}, {self.high:g})"


def loguniform(low: float, high: float, unit: str = "", *, doc: str = "", within: Within = None) -> Any:
    """Draw a positive number between `low` and `high`, all ratios equally likely.

    Raises:
        ParameterError: A bound is not positive and finite, or `low` exceeds `high`.
    """
    low, high = _number(low, "loguniform: low"), _number(high, "loguniform: high")
    if not 0.0 < low <= high:
        raise ParameterError(f"loguniform({low:g}, {high:g}): needs 0 < low <= high")
    return LogUniform(unit, doc, _check_within(within, "loguniform"), low, high)


@dataclass(frozen=True)
class Choice(Distribution):
    """One of some options."""

    options: tuple[Any, ...] = ()
    weights: tuple[float, ...] | None = None

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw an option."""
        weights = np.ones(len(self.options)) if self.weights is None else np.array(self.weights)
        edges = np.cumsum(weights / weights.sum())
        return self.options[min(int(np.searchsorted(edges, generator.random(), "right")), len(edges) - 1)]

    def support(self) -> tuple[Any, ...]:
        """Return the options."""
        return self.options

    @property
    def numeric(self) -> bool:
        """Whether every option is a number."""
        return all(isinstance(item, int | float) and not isinstance(item, bool) for item in self.options)

    def __repr__(self) -> str:
        shown = ", ".join(getattr(option, "name", None) or repr(option) for option in self.options)
        return f"choice({shown})"


def choice(
    *options: Any, weights: tuple[float, ...] | None = None, unit: str = "", doc: str = "", within: Within = None
) -> Any:
    """Draw one of the options, with equal chances unless weights are given.

    Raises:
        ParameterError: There are no options, or the weights do not match them.
    """
    if not options:
        raise ParameterError("choice needs at least one option")
    if weights is not None:
        bad = len(weights) != len(options) or min(weights) < 0.0 or sum(weights) <= 0.0
        if bad:
            raise ParameterError(
                f"choice: {len(options)} options need as many weights, none negative and not all 0; "
                f"got {tuple(weights)}"
            )
        weights = tuple(float(weight) for weight in weights)
    return Choice(unit, doc, _check_within(within, "choice"), tuple(options), weights)


def count(
    low: int, high: int, *, weights: tuple[float, ...] | None = None, doc: str = "", within: Within = None
) -> Any:
    """Draw a whole number from `low` to `high`, both included.

    Raises:
        ParameterError: A bound is no whole number, or `low` exceeds `high`.
    """
    for bound in (low, high):
        if isinstance(bound, bool) or not isinstance(bound, int):
            raise ParameterError(f"count: bounds must be whole numbers, got {bound!r}")
    if low > high:
        raise ParameterError(f"count({low}, {high}): low exceeds high; swap them")
    return choice(*range(low, high + 1), weights=weights, doc=doc, within=within)


@dataclass(frozen=True)
class By(Distribution):
    """A distribution for each value of a structural parameter."""

    parameter: str = ""
    cases: tuple[tuple[Any, Any], ...] = ()

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw from the case that the structural parameter chose."""
        chosen = given[self.parameter]
        for key, case in self.cases:
            if key == chosen or (key == "otherwise"):
                return case.draw(generator, given) if isinstance(case, Distribution) else case
        raise ParameterError(
            f"by({self.parameter!r}, ...) has no case for {chosen!r}."
            + nearest(str(chosen), [str(key) for key, _ in self.cases])
        )

    def support(self) -> tuple[Any, ...]:
        """Return the lowest and highest value, or the options, over all cases."""
        ends: list[Any] = []
        for _, case in self.cases:
            ends.extend(case.support() if isinstance(case, Distribution) else (case,))
        if self.numeric and all(not isinstance(case, Choice) for _, case in self.cases):
            return min(ends), max(ends)
        return tuple(dict.fromkeys(ends))

    @property
    def numeric(self) -> bool:
        """Whether every value of every case is a number."""
        return all(
            case.numeric
            if isinstance(case, Distribution)
            else isinstance(case, int | float) and not isinstance(case, bool)
            for _, case in self.cases
        )

    def needs(self) -> tuple[str, ...]:
        """Return the names of the parameters that the draw depends on."""
        inner = [name for _, case in self.cases if isinstance(case, Distribution) for name in case.needs()]
        return (self.parameter, *dict.fromkeys(inner))

    def __repr__(self) -> str:
        return f"by({self.parameter!r}, {', '.join(f'{key}={case!r}' for key, case in self.cases)})"


def by(
    parameter: str,
    cases: Mapping[Any, Any] | None = None,
    *,
    unit: str = "",
    doc: str = "",
    within: Within = None,
    **named: Any,
) -> Any:
    """Draw from a distribution that depends on a structural parameter.

    Args:
        parameter: Name of the structural parameter, of the same generator.
        cases: Distribution or value for each of its values that is no identifier.
        unit: Unit of the value.
        doc: What the parameter is.
        within: Hard limits for overrides.
        **named: Distribution or value for each of its values; `otherwise` for the remaining ones.

    Raises:
        ParameterError: There are no cases.
    """
    together = {**(cases or {}), **named}
    if not together:
        raise ParameterError(f"by({parameter!r}) needs a distribution for each value of {parameter!r}")
    # "otherwise" matches everything, so it comes last
    ordered = sorted(together.items(), key=lambda item: item[0] == "otherwise")
    return By(unit, doc, _check_within(within, f"by({parameter!r})"), parameter, tuple(ordered))
