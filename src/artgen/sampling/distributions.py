"""Distributions of parameters, and the random stream of each name."""

import hashlib
import math
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from artgen.errors import ParameterError

if TYPE_CHECKING:
    from statistics import NormalDist


def stream(seed: int, path: str, attempt: int = 0) -> np.random.Generator:
    """Return the random stream of one parameter of one asset.

    Args:
        seed: Seed of the asset, not negative.
        path: Category and parameter, such as `door/handle.lever_handle.length`.
        attempt: Number of infeasible draws before this one.
    """
    name = int.from_bytes(hashlib.blake2b(path.encode(), digest_size=8).digest(), "little")
    # the words of [seed, attempt, name]: numpy takes many times as long to make them
    words = np.array([word for number in (seed, attempt, name) for word in _words(number)], np.uint32)
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence(words)))


def _words(number: int) -> list[int]:
    """Return the words of 32 bits of a whole number that is not negative, the lowest first."""
    return [number & 0xFFFFFFFF, *(_words(number >> 32) if number >> 32 else ())]


Within = tuple[float, float] | None


@dataclass(frozen=True)
class Distribution(ABC):
    """Distribution of a parameter.

    Attributes:
        unit: Unit of the value, such as `m`; empty for none.
        doc: Description of the parameter.
        within: Hard limits of overrides. The support of the distribution is not a limit.
    """

    unit: str = ""
    doc: str = ""
    within: Within = None

    def __post_init__(self) -> None:
        """Check the unit."""
        if not isinstance(self.unit, str):
            raise ParameterError(f"unit = {self.unit!r} is not allowed: it is text, such as 'm' or 'rad'")
        for base, units in UNITS.items():
            if self.unit != base and self.unit in units:
                raise ParameterError(
                    f"unit = {self.unit!r} is not allowed: lengths are in m, angles in rad and masses in kg; "
                    f"1 {self.unit} is {units[self.unit]:.4g} {base}"
                )

    @abstractmethod
    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw a value; `given` has the parameters drawn before."""

    @abstractmethod
    def support(self) -> tuple[Any, ...]:
        """Return the lowest and highest value, or the options."""

    @property
    def discrete(self) -> bool:
        """Whether `support` lists every value."""
        return False

    def shares(self) -> tuple[tuple[Any, float], ...]:
        """Return each value with its probability, if `discrete`.

        Raises:
            NotImplementedError: The distribution does not know them.
        """
        raise NotImplementedError

    def share_below(self, value: float) -> float:
        """Return the probability of a draw below a value, if not `discrete`.

        Raises:
            NotImplementedError: The distribution does not know it.
        """
        raise NotImplementedError

    @property
    def numeric(self) -> bool:
        """Whether every value is a number."""
        return all(leaf._numeric_leaf() for leaf in self.leaves())

    def _numeric_leaf(self) -> bool:
        return not self.discrete or all(is_number(value) for value in self.support())

    def leaves(self) -> tuple["Distribution", ...]:
        """Return the distributions between which the draw chooses; without a choice, only this one."""
        return (self,)

    def needs(self) -> tuple[str, ...]:
        """Return the names of the parameters that the draw depends on."""
        return ()

    def check(self, name: str, value: Any) -> None:
        """Check a value, or every value of a distribution, of an override against the hard limits.

        Raises:
            ParameterError: It lies outside the hard limits.
        """
        if self.within is None:
            return
        low, high = self.within
        for item in value.support() if isinstance(value, Distribution) else (value,):
            if is_number(item) and not low <= item <= high:
                raise ParameterError(
                    f"{name} = {value!r} is out of range: "
                    f"{low:.6g} to {high:.6g}{_unit(self.unit)} is allowed{_converted(value, self)}"
                )


UNITS = {
    "m": {"mm": 1e-3, "cm": 1e-2, "in": 0.0254, "m": 1.0},
    "rad": {"degrees": math.pi / 180.0, "deg": math.pi / 180.0, "rad": 1.0},
    "kg": {"g": 1e-3, "kg": 1.0},
}
"""Units that users mean instead of the units of parameters, with their sizes."""


def _converted(value: Any, distribution: Distribution) -> str:
    """Return a question about the unit of a number that is out of range."""
    low, high = distribution.within or (0.0, 0.0)
    for unit, size in UNITS.get(distribution.unit, {}).items():
        if is_number(value) and low <= size * value <= high:
            return f"; {value:g} {unit} are {size * value:.4g} {distribution.unit}"
    return ""


def is_number(value: Any) -> bool:
    """Tell whether a value is a finite number; booleans do not count."""
    kinds = float | int | np.floating | np.integer
    return isinstance(value, kinds) and not isinstance(value, bool) and math.isfinite(value)


def _unit(unit: str) -> str:
    return f" {unit}" if unit else ""


def as_number(value: Any, what: str) -> float:
    """Return a finite number as a Python float."""
    if not is_number(value):
        raise ParameterError(f"{what} must be a finite number, got {value!r}")
    return float(value)


def limited(distribution: Distribution, within: Any) -> Any:
    """Return the distribution with hard limits."""
    if within is None:
        return distribution
    if not isinstance(within, Sequence) or len(within) != 2:
        raise ParameterError(
            f"{distribution!r}: within must be a pair of numbers (low, high), got {within!r}"
        )
    low, high = (as_number(end, f"{distribution!r}: within") for end in within)
    if low > high:
        raise ParameterError(
            f"{distribution!r}: within=({low:.6g}, {high:.6g}) has low above high; swap them"
        )
    if not distribution.numeric:
        raise ParameterError(f"{distribution!r}: within limits numbers, and not all of these are")
    result = replace(distribution, within=(low, high))
    for value in result.support():
        if not low <= value <= high:
            raise ParameterError(
                f"{distribution!r} may give {value!r}, outside within=({low:.6g}, {high:.6g})"
            )
    return result


@dataclass(frozen=True)
class Fixed(Distribution):
    """A constant value unless it is overridden."""

    value: Any = None

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Return the value."""
        return self.value

    def support(self) -> tuple[Any, ...]:
        """Return the value."""
        return (self.value,)

    @property
    def discrete(self) -> bool:
        """Whether `support` lists every value."""
        return True

    def shares(self) -> tuple[tuple[Any, float], ...]:
        """Return the value, which is certain."""
        return ((self.value, 1.0),)

    def __repr__(self) -> str:
        return shown(self.value)


def fixed(value: Any, unit: str = "", *, doc: str = "", within: Within = None) -> Any:
    """Make a parameter with a constant value that overrides may change.

    Raises:
        ParameterError: The value lies outside `within`.
    """
    return limited(Fixed(unit, doc, None, value), within)


@dataclass(frozen=True)
class Given:
    """Value of an input that the caller omits.

    Attributes:
        value: The value.
    """

    value: Any


def given(value: Any) -> Any:
    """Make an input with a default, which is not a parameter: it is neither drawn nor overridden."""
    return Given(value)


def shown(option: Any) -> str:
    """Format a value for authors: generators and materials by name."""
    name = getattr(option, "name", None)
    return name if isinstance(name, str) else repr(option)


@dataclass(frozen=True)
class Uniform(Distribution):
    """Uniform distribution between `low` and `high`."""

    low: float = 0.0
    high: float = 1.0

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> float:
        """Draw a number."""
        return _between(self.low + (self.high - self.low) * generator.random(), self.low, self.high)

    def support(self) -> tuple[float, float]:
        """Return the lowest and highest value."""
        return self.low, self.high

    def share_below(self, value: float) -> float:
        """Return the probability of a draw below a value."""
        return _share(value, self.low, self.high)

    def __repr__(self) -> str:
        return f"uniform({self.low:g}, {self.high:g})"


def _between(value: float, low: float, high: float) -> float:
    """Clip a draw that rounding may carry beyond the ends."""
    return float(min(max(value, low), high))


def _share(value: float, low: float, high: float) -> float:
    """Return the share of an interval below a value; all of an interval of one point."""
    return min(max((value - low) / (high - low), 0.0), 1.0) if high > low else float(value >= low)


def uniform(low: float, high: float, unit: str = "", *, doc: str = "", within: Within = None) -> Any:
    """Draw a number between `low` and `high` with equal probability.

    Raises:
        ParameterError: A bound is not a finite number, `low` exceeds `high`, or they lie outside `within`.
    """
    low, high = as_number(low, "uniform: low"), as_number(high, "uniform: high")
    if low > high:
        raise ParameterError(f"uniform({low:g}, {high:g}): low exceeds high; swap them")
    return limited(Uniform(unit, doc, None, low, high), within)


@dataclass(frozen=True)
class Normal(Distribution):
    """Normal distribution truncated to `low` and `high`."""

    mean: float = 0.0
    deviation: float = 1.0
    low: float = -1.0
    high: float = 1.0

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> float:
        """Draw a number by inverse transform sampling of the truncated distribution."""
        curve = self._curve()
        below, above = curve.cdf(self.low), curve.cdf(self.high)
        share = below + (above - below) * float(generator.random())
        if not 0.0 < share < 1.0:
            return self.low if share <= 0.0 else self.high
        return _between(curve.inv_cdf(share), self.low, self.high)

    def support(self) -> tuple[float, float]:
        """Return the lowest and highest value."""
        return self.low, self.high

    def share_below(self, value: float) -> float:
        """Return the probability of a draw below a value."""
        curve = self._curve()
        inside = min(max(value, self.low), self.high)
        return _share(curve.cdf(inside), curve.cdf(self.low), curve.cdf(self.high))

    def _curve(self) -> "NormalDist":
        from statistics import NormalDist  # rarely used, and slow to import

        return NormalDist(self.mean, self.deviation)

    def __repr__(self) -> str:
        return f"truncated_normal({self.mean:g}, {self.deviation:g}, {self.low:g}, {self.high:g})"


def truncated_normal(
    mean: float,
    deviation: float,
    low: float,
    high: float,
    unit: str = "",
    *,
    doc: str = "",
    within: Within = None,
) -> Any:
    """Draw a number from a normal distribution truncated to `low` and `high`.

    Raises:
        ParameterError: A number is not finite, the deviation is not positive, the mean is not between `low`
            and `high`, or they lie outside `within`.
    """
    mean, deviation = (
        as_number(mean, "truncated_normal: mean"),
        as_number(deviation, "truncated_normal: deviation"),
    )
    low, high = as_number(low, "truncated_normal: low"), as_number(high, "truncated_normal: high")
    if deviation <= 0.0:
        raise ParameterError(f"truncated_normal: deviation must be positive, got {deviation:g}")
    if not low <= mean <= high:
        raise ParameterError(
            f"truncated_normal: the mean {mean:g} must lie between low {low:g} and high {high:g}"
        )
    return limited(Normal(unit, doc, None, mean, deviation, low, high), within)


@dataclass(frozen=True)
class LogUniform(Distribution):
    """Log-uniform distribution between `low` and `high`."""

    low: float = 1.0
    high: float = 10.0

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> float:
        """Draw a number."""
        return _between(self.low * (self.high / self.low) ** generator.random(), self.low, self.high)

    def support(self) -> tuple[float, float]:
        """Return the lowest and highest value."""
        return self.low, self.high

    def share_below(self, value: float) -> float:
        """Return the probability of a draw below a value."""
        return _share(math.log(max(value, self.low)), math.log(self.low), math.log(self.high))

    def __repr__(self) -> str:
        return f"loguniform({self.low:g}, {self.high:g})"


def loguniform(low: float, high: float, unit: str = "", *, doc: str = "", within: Within = None) -> Any:
    """Draw a positive number between `low` and `high`, uniform in its logarithm.

    Raises:
        ParameterError: A bound is not positive and finite, `low` exceeds `high`, or they lie outside
            `within`.
    """
    low, high = as_number(low, "loguniform: low"), as_number(high, "loguniform: high")
    if not 0.0 < low <= high:
        raise ParameterError(f"loguniform({low:g}, {high:g}): needs 0 < low <= high")
    return limited(LogUniform(unit, doc, None, low, high), within)
