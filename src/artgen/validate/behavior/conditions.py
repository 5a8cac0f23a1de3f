"""Search for joint positions in which conditions of dependencies hold, or in which one part of them fails."""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import product
from typing import Literal

from artgen.asset import Asset, AssetCondition, AssetJoint
from artgen.export.frames import BORDER, intersection, leader_of, regions

_OPEN_TRAVEL = 0.5  # distance of a chosen position from the border of an unbounded region [rad or m]


def state_for(
    asset: Asset, conditions: Iterable[AssetCondition], *, ignore: str = "", extreme: Collection[str] = ()
) -> dict[str, float] | None:
    """Find positions of free joints in which conditions hold and no other joint is blocked."""
    wanted = list(conditions)
    far = {leader_of(asset, asset.joint(name))[0] for name in extreme}
    for _ in range(len(asset.joints) + 1):
        found = next(_states(asset, wanted, ignore, far), None)
        if found is None:
            return None
        blocked = [name for name in asset.blocked(found) if leader_of(asset, asset.joint(name))[0] != ignore]
        needed = [joint.needs.condition for joint in map(asset.joint, blocked) if joint.needs is not None]
        if not needed:
            return found
        wanted += needed
    return None


def isolated(condition: AssetCondition) -> Iterator[tuple[AssetCondition, AssetCondition]]:
    """Yield each comparison in a condition, with the region in which only this comparison fails."""
    if condition.kind in ("above", "below"):
        yield condition, negation(condition)
        return
    for number, term in enumerate(condition.terms):
        others = [other for index, other in enumerate(condition.terms) if index != number]
        if condition.kind == "any":
            others = [negation(other) for other in others]
        for comparison, region in isolated(term):
            yield comparison, AssetCondition("all", terms=(region, *others))


def negation(condition: AssetCondition) -> AssetCondition:
    """Return the region in which a condition does not hold, including its border."""
    kinds: Mapping[str, Literal["above", "below", "all", "any"]] = {
        "above": "below",
        "below": "above",
        "all": "any",
        "any": "all",
    }
    terms = tuple(negation(term) for term in condition.terms)
    border = {"above": BORDER, "below": -BORDER}.get(condition.kind, 0.0)
    return AssetCondition(kinds[condition.kind], condition.joint, condition.value + border, terms)


def _states(
    asset: Asset, conditions: list[AssetCondition], ignore: str, extreme: Collection[str]
) -> Iterator[dict[str, float]]:
    for boxes in product(*(regions(asset, condition) for condition in conditions)):
        region = intersection(boxes)
        region.pop(ignore, None)
        chosen = {
            name: _choose(asset.joint(name), interval, extreme=name in extreme)
            for name, interval in region.items()
        }
        if all(position is not None for position in chosen.values()):
            yield {name: position for name, position in chosen.items() if position is not None}


def _choose(joint: AssetJoint, interval: tuple[float, float], *, extreme: bool) -> float | None:
    """Choose the position of a joint: closed if possible, else the center or the far end."""
    if interval[0] < joint.closed < interval[1]:
        return joint.closed
    low, high = joint.limits or (-math.inf, math.inf)
    low, high = max(low, interval[0]), min(high, interval[1])
    if high - low <= 2.0 * BORDER:
        return None
    if not math.isfinite(low) or not math.isfinite(high):
        return low + _OPEN_TRAVEL if math.isfinite(low) else high - _OPEN_TRAVEL
    if not extreme:
        return (low + high) / 2.0
    end, inside = (high, -1.0) if low >= joint.closed else (low, 1.0)
    return end + inside * 2.0 * BORDER if end in interval else end
