"""Order in which free joints open: a joint follows those that it depends on."""

import itertools
import math
from collections.abc import Iterable, Mapping

from artgen.asset import Asset, AssetCondition, AssetJoint
from artgen.export.frames import BORDER, Region, coupling, leader_of, regions

Stop = Mapping[str, float]
"""Positions of all free joints [rad or m]."""

_TRAVEL = {"revolute": math.tau, "prismatic": 0.2}  # range of joints without limits [rad or m]
_CHECKS = 8  # checked positions between two stops


class _NoWayError(Exception):
    """A dependency cannot be satisfied."""


def opening(asset: Asset, joint: AssetJoint) -> tuple[Stop, ...] | None:
    """Return stops of a free joint from rest to its limits and back to rest.

    Between two stops one joint moves with its followers. First move the joints that others depend on, then
    the joint itself to its upper and to its lower limit, unless it rests there; then all joints return. A
    joint without limits makes a full turn.
    """
    planner = _Planner(asset)
    try:
        planner.allow(joint.name)
        before = len(planner.stops)
        for end in _ends(joint):
            planner.move(joint.name, end)
    except _NoWayError:
        return None
    stops = planner.stops
    if before > 1 or not _comes_round(asset, joint):
        planner.move(joint.name, joint.closed)
        stops += reversed(stops[: before - 1])
    return tuple(stops) if _allowed(asset, stops) else None


def _ends(joint: AssetJoint) -> list[float]:
    if joint.limits is None:
        return [joint.closed + _TRAVEL[joint.kind]]
    return [end for end in reversed(joint.limits) if abs(end - joint.closed) > BORDER]


def _comes_round(asset: Asset, joint: AssetJoint) -> bool:
    """Tell whether everything that a joint moves returns after a full turn."""
    laws = [(each, coupling(asset, each)) for each in asset.joints]
    moved = [(each, law.ratio) for each, law in laws if law is not None and law.leader == joint.name]
    return joint.limits is None and all(
        each.kind == "revolute" and ratio.is_integer() for each, ratio in [(joint, 1.0), *moved]
    )


def _allowed(asset: Asset, stops: Iterable[Stop]) -> bool:
    """Tell whether dependencies hold on the whole path, except for those that do not hold at rest."""
    resting = set(asset.blocked())
    shares = [number / _CHECKS for number in range(1, _CHECKS + 1)]
    return all(
        resting.issuperset(asset.blocked({name: a[name] + share * (b[name] - a[name]) for name in a}))
        for a, b in itertools.pairwise(stops)
        for share in shares
    )


class _Planner:
    """Moves free joints one after another."""

    def __init__(self, asset: Asset) -> None:
        # positions after each move, starting at rest
        self.stops: list[Stop] = [{joint.name: joint.closed for joint in asset.free_joints}]
        self._asset = asset
        self._waiting: list[str] = []

    def move(self, name: str, position: float) -> None:
        """Move a joint with satisfied dependencies."""
        self.stops.append({**self.stops[-1], name: position})

    def allow(self, name: str) -> None:
        """Move other joints until a joint and its followers may move."""
        if name in self._waiting:
            raise _NoWayError
        self._waiting.append(name)
        for joint in self._asset.joints:
            if joint.needs is not None and leader_of(self._asset, joint)[0] == name:
                self._meet(joint.needs.condition)
        self._waiting.pop()

    def _meet(self, condition: AssetCondition) -> None:
        start = len(self.stops)
        waiting = list(self._waiting)
        for region in regions(self._asset, condition):
            try:
                self._enter(region)
            except _NoWayError:
                del self.stops[start:]
                self._waiting = list(waiting)
            else:
                return
        raise _NoWayError

    def _enter(self, region: Region) -> None:
        for name, (low, high) in region.items():
            if not low < self.stops[-1][name] < high:
                position = _within(self._asset.joint(name), low, high)
                self.allow(name)
                self.move(name, position)


def _within(joint: AssetJoint, low: float, high: float) -> float:
    """Return the position of a joint in an open interval, at a limit if possible."""
    ends = joint.limits or (-math.inf, math.inf)
    for end in reversed(ends):
        if low < end < high and math.isfinite(end):
            return end
    low, high = max(low, ends[0]), min(high, ends[1])
    if high - low <= 2.0 * BORDER:
        raise _NoWayError
    if math.isfinite(low) and math.isfinite(high):
        return (low + high) / 2.0
    return low + _TRAVEL[joint.kind] if math.isfinite(low) else high - _TRAVEL[joint.kind]
