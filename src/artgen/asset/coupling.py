"""Laws of joints that follow others: a ratio and an offset, or the curve of a closed chain."""

import math
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from artgen._arrays import Array, FrozenArrays, Indices, Triple, cached_property
from artgen.asset.record import Record
from artgen.asset.valid_states import curve_at


@dataclass(frozen=True)
class AssetCurve(Record):
    """Positions of a joint of a closed chain at equal steps of the input, with a cubic between two of them.

    Attributes:
        start: Position of the input at the first sample [rad or m].
        step: Distance of two samples [rad or m].
        positions: Position of the joint at each sample [rad or m].
        slopes: Its speed there, per speed of the input.
        turns: Whether the input turns without limits; the samples then cover one turn.
    """

    start: float
    step: float
    positions: tuple[float, ...]
    slopes: tuple[float, ...]
    turns: bool = False

    @property
    def end(self) -> float:
        """Position of the input at the last sample [rad or m]."""
        return self.start + self.step * (len(self.positions) - 1)

    @property
    def gain(self) -> float:
        """Difference of the last and the first position [rad or m]."""
        return self.positions[-1] - self.positions[0]

    @cached_property
    def _data(self) -> dict[str, Any]:
        arrays = {"positions": np.array(self.positions), "slopes": np.array(self.slopes)}
        return {"start": self.start, "step": self.step, "turns": self.turns, **arrays}

    def at(self, position: ArrayLike, *, slope: bool = False) -> Array:
        """Return the positions of the joint, or its slopes, at positions of the input, of the same shape."""
        return np.asarray(curve_at(self._data, position, slope=slope))

    @cached_property
    def _steepest(self) -> list[Array]:
        """Bounds of the speed: row k has the largest of the 2^k steps from each step on."""
        rise = np.diff(self.positions) / self.step
        first, last = np.array(self.slopes[:-1]), np.array(self.slopes[1:])
        # the slope of a cubic lies between the control points of its slope
        bound = np.max(np.abs([first, 3.0 * rise - first - last, last]), axis=0)
        rows = [bound]
        while (width := 1 << len(rows)) <= len(bound):
            half = rows[-1]
            rows.append(np.maximum(half[: len(bound) - width + 1], half[width // 2 : len(half)]))
        return rows

    @property
    def fastest(self) -> float:
        """A bound of the speed of the joint per speed of the input."""
        return float(self._steepest[0].max())

    def steepest(self, low: Array, high: Array) -> Array:
        """Return a bound of the speed per speed of the input in intervals of the input, of the same shape."""
        first, last = (self._step(end) for end in (low, high))
        widths = 1 << np.arange(len(self._steepest))
        level = np.searchsorted(widths, last - first + 1, side="right") - 1
        result = np.zeros(np.shape(level))
        for number, row in enumerate(self._steepest):
            ends = np.stack([row[np.clip(end, 0, len(row) - 1)] for end in (first, last + 1 - (1 << number))])
            result = np.where(level == number, ends.max(axis=0), result)
        return result

    def _step(self, position: Array) -> Indices:
        place = np.floor((position - self.start) / self.step).astype(np.int64)
        return np.clip(place, 0, len(self.positions) - 2)

    def turning_points(self) -> list[float]:
        """Return the positions of the input, in rising order, at which the joint turns back."""
        found = []
        for number, (first, last) in enumerate(zip(self.slopes, self.slopes[1:], strict=False)):
            rise = (self.positions[number + 1] - self.positions[number]) / self.step
            a, b = first + last - 2.0 * rise, 3.0 * rise - 2.0 * first - last
            # roots of first + 2 b t + 3 a t^2
            root = b * b - 3.0 * a * first
            if root < 0.0:
                continue
            q = -(b + math.copysign(math.sqrt(root), b))
            shares = [top / bottom for top, bottom in ((q, 3.0 * a), (first, q)) if bottom]
            found += [self.start + (number + t) * self.step for t in sorted(shares) if 0.0 <= t <= 1.0]
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
        return self.ratio * (1.0 if self.curve is None else float(self.curve.at(position, slope=True)))

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

    def to_data(self) -> dict[str, Any]:
        """Return the coupling as JSON data; the curve is left out if there is none."""
        return {name: value for name, value in super().to_data().items() if (name, value) != ("curve", None)}


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

    def renamed(self, links: dict[str, str], joints: dict[str, str]) -> "AssetLoop":
        """Return the loop with renamed links and joints; names not in the mappings stay."""
        first, second = (links.get(name, name) for name in self.links)
        return replace(self, links=(first, second), joint=joints.get(self.joint, self.joint))
