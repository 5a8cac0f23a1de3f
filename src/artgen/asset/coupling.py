"""Laws of joints that follow others: a ratio and an offset, or the curve of a closed chain."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike

from artgen._arrays import Array, FrozenArrays, Triple, cached_property
from artgen.asset.record import Record
from artgen.asset.valid_states import curve_at

_STEPS = 1024  # of the range of a curve, for bounds of its speed
_WIDER = 1e-6  # share of a step by which intervals are widened, for rounding
_BISECTIONS = 50


@dataclass(frozen=True)
class AssetCurve(Record):
    """Position of a joint of a closed chain as a Chebyshev series in the position of the input.

    Attributes:
        range: Positions of the input between which the series holds [rad or m].
        terms: Coefficients of the series [rad or m].
        turns: Whether the input turns without limits; the range is then one turn.
    """

    range: tuple[float, float]
    terms: tuple[float, ...]
    turns: bool = False

    @property
    def gain(self) -> float:
        """Motion of the joint from one end of the range to the other [rad or m]."""
        return 2.0 * sum(self.terms[1::2])

    @cached_property
    def _series(self) -> tuple[dict[str, Any], ...]:
        """The series and its first and second derivative, as data."""
        series, (low, high) = [np.array(self.terms)], self.range
        for _ in range(2):
            series.append(chebyshev.chebder(series[-1]) * (2.0 / (high - low)))
        return tuple({"range": self.range, "terms": each, "turns": self.turns} for each in series)

    def at(self, position: ArrayLike) -> Array:
        """Return the positions of the joint at positions of the input, of the same shape."""
        return np.asarray(curve_at(self._series[0], np.asarray(position, float)))

    def slope(self, position: ArrayLike) -> Array:
        """Return the speeds of the joint per speed of the input at positions of it, of the same shape."""
        return np.asarray(curve_at(self._series[1], np.asarray(position, float)))

    @cached_property
    def _edges(self) -> Array:
        return np.linspace(*self.range, _STEPS + 1)

    @cached_property
    def _steepest(self) -> list[Array]:
        """Bounds of the speed: row k has the largest of the 2^k steps from each step on."""
        half = (self.range[1] - self.range[0]) / (2.0 * _STEPS)
        # no Chebyshev polynomial exceeds 1, which bounds the second derivative
        bend = float(np.abs(self._series[2]["terms"]).sum())
        rows = [np.abs(self.slope(self._edges[:-1] + half)) + half * bend]
        while (width := 1 << len(rows)) <= _STEPS:
            before = rows[-1]
            rows.append(np.maximum(before[: _STEPS - width + 1], before[width // 2 : len(before)]))
        return rows

    @property
    def fastest(self) -> float:
        """A bound of the speed of the joint per speed of the input."""
        return float(self._steepest[0].max())

    def steepest(self, low: Array, high: Array) -> Array:
        """Return a bound of the speed per speed of the input in intervals of the input, of the same shape."""
        step = (self.range[1] - self.range[0]) / _STEPS
        first, last = (
            np.clip(np.floor((end - self.range[0]) / step).astype(np.int64), 0, _STEPS - 1)
            for end in (low - _WIDER * step, high + _WIDER * step)
        )
        widths = 1 << np.arange(len(self._steepest))
        level = np.searchsorted(widths, last - first + 1, side="right") - 1
        result = np.zeros(np.shape(level))
        for number, row in enumerate(self._steepest):
            starts = (first, last + 1 - (1 << number))
            ends = np.stack([row[np.clip(end, 0, len(row) - 1)] for end in starts])
            result = np.where(level == number, ends.max(axis=0), result)
        return result

    def turning_points(self) -> list[float]:
        """Return the positions of the input, in rising order, at which the joint turns back."""
        slopes, found = self.slope(self._edges), []
        for number in np.flatnonzero(slopes[:-1] * slopes[1:] <= 0.0).tolist():
            low, high = self._edges[number : number + 2].tolist()
            for _ in range(_BISECTIONS):
                middle = (low + high) / 2.0
                rises = float(self.slope(middle)) * float(slopes[number]) > 0.0
                low, high = (middle, high) if rises else (low, middle)
            found.append(low)
        return found


@dataclass(frozen=True)
class AssetCoupling(Record):
    """A joint that follows another: position = ratio * leader + offset.

    A joint of a closed chain has a curve: position = ratio * curve(leader) + offset.
    """

    OPTIONAL: ClassVar = frozenset({"curve"})

    leader: str  # name of the joint that leads
    ratio: float  # transmission ratio [rad/rad, m/rad, rad/m or m/m]
    offset: float = 0.0  # position while the leader is at 0 [rad or m]
    curve: AssetCurve | None = None  # law of a closed chain, whose leader is a free joint

    def at(self, position: float) -> float:
        """Return the position of the joint while the leader is at a position [rad or m]."""
        if self.curve is not None:
            position = float(self.curve.at(position))
        return self.ratio * position + self.offset

    def positions(self, leader: Array) -> Array:
        """Return the positions of the joint while the leader is at several, of the same shape [rad or m]."""
        return self.ratio * (leader if self.curve is None else self.curve.at(leader)) + self.offset

    def slope(self, position: float) -> float:
        """Return the speed of the joint per speed of the leader, which is at a position [rad or m]."""
        return self.ratio * (1.0 if self.curve is None else float(self.curve.slope(position)))

    @property
    def steepest(self) -> float:
        """A bound of the speed of the joint per speed of its leader."""
        return abs(self.ratio) * (1.0 if self.curve is None else self.curve.fastest)

    def interval(self, low: Array, high: Array) -> tuple[Array, Array]:
        """Return middle and half length of intervals that contain the joint while its leader is in others."""
        middle, half = (low + high) / 2.0, abs(self.ratio) * ((high - low) / 2.0)
        if self.curve is not None:
            middle, half = self.curve.at(middle), half * self.curve.steepest(low, high)
        return self.ratio * middle + self.offset, half

    def span(self, low: float, high: float) -> tuple[float, float]:
        """Return the lowest and the highest position while the leader is in an interval [rad or m]."""
        points = [low, high]
        if self.curve is not None:
            points += [point for point in self.curve.turning_points() if low < point < high]
        found = [self.at(point) for point in points]
        return min(found), max(found)

    def then(self, ratio: float, offset: float) -> "AssetCoupling":
        """Return the law of a joint that follows this one with a ratio and an offset."""
        return replace(self, ratio=ratio * self.ratio, offset=ratio * self.offset + offset)

    @property
    def gain(self) -> float:
        """Motion of the joint in a whole turn of its leader [rad or m]."""
        return self.ratio * (math.tau if self.curve is None else self.curve.gain)

    def comes_round(self, kind: str) -> bool:
        """Tell whether a joint of a kind is back after each turn of its leader."""
        turns = self.gain / math.tau
        if self.curve is None:
            return kind == "revolute" and self.ratio == round(self.ratio)
        return self.curve.turns and abs(turns - (round(turns) if kind == "revolute" else 0)) < 1e-9


@dataclass(frozen=True, eq=False)
class AssetLoop(FrozenArrays, Record):
    """A pin that closes a chain of links: a point of two links that stays one point.

    Attributes:
        links: Names of the two links.
        point: The point in asset coordinates at rest, shape (3,) [m].
        axis: Direction of the pin there, a unit vector, shape (3,).
        joint: Name of the joint that moves the chain, its input.
    """

    links: tuple[str, str]
    point: Triple
    axis: Triple
    joint: str

    def moved(self, matrix: Array) -> "AssetLoop":
        """Return the loop carried along by a rigid motion or a reflection, shape (4, 4)."""
        turn = matrix[:3, :3]
        return replace(self, point=turn @ self.point + matrix[:3, 3], axis=turn @ self.axis)

    def renamed(self, links: Mapping[str, str], joints: Mapping[str, str]) -> "AssetLoop":
        """Return the loop with renamed links and joints; names not in the mappings stay."""
        first, second = (links.get(name, name) for name in self.links)
        return replace(self, links=(first, second), joint=joints.get(self.joint, self.joint))
