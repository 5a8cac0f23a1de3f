"""Joints in checks: positions and forces as text, and joint positions in which conditions hold."""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import product
from typing import Literal

from artgen.asset import Asset, AssetCondition, AssetCoupling, AssetJoint
from artgen.export.frames import BORDER, POINT, coupling, intersection, leader_of, regions

_OPEN_TRAVEL = 0.5  # distance of a chosen position from the border of an unbounded region [rad or m]


# of a revolute and of a prismatic joint
_UNITS = {
    "position": ("rad", "m"),
    "stiffness": ("N m/rad", "N/m"),
    "damping": ("N m s/rad", "N s/m"),
    "friction": ("N m", "N"),
    "rest": ("rad", "m"),
    "armature": ("kg m^2", "kg"),
    "effort": ("N m", "N"),
    "velocity": ("rad/s", "m/s"),
}


def unit(joint: AssetJoint, quantity: str = "position") -> str:
    """Return the unit of a joint's positions, or of a number in `artgen.asset.joint.DYNAMICS`."""
    return _UNITS[quantity][joint.kind == "prismatic"]


def length(joint: AssetJoint, distance: float) -> str:
    """Format a distance along a joint in degrees or millimetres."""
    if joint.kind == "revolute":
        return f"{math.degrees(distance):.3g} degrees"
    return f"{1e3 * distance:.3g} mm"


def place(joint: AssetJoint, position: float) -> str:
    """Format a position of a joint in radians or metres."""
    return f"{position + 0.0:.4g} {unit(joint)}"


def force(joint: AssetJoint, amount: float) -> str:
    """Format a torque or a force at a joint."""
    return f"{amount + 0.0:.3g} {unit(joint, 'effort')}"


def needed_conditions(asset: Asset, joint: str) -> list[AssetCondition]:
    """Return the conditions for the motion of a free joint and its followers."""
    return [
        each.needs.condition
        for each in asset.joints
        if each.needs is not None and leader_of(asset, each)[0] == joint
    ]


def led_by(asset: Asset, joint: AssetJoint) -> list[tuple[AssetJoint, AssetCoupling]]:
    """Return a free joint and those that follow it, each with its law."""
    laws = ((each, coupling(asset, each)) for each in asset.joints)
    followers = ((each, law) for each, law in laws if law is not None and law.leader == joint.name)
    return [(joint, AssetCoupling(joint.name, 1.0)), *followers]


def is_possible(asset: Asset, condition: AssetCondition, ranges: Mapping[str, tuple[float, float]]) -> bool:
    """Tell whether a condition holds somewhere inside the ranges of the joints [rad or m]."""
    return any(
        all(
            low < high and low < ranges[name][1] and ranges[name][0] < high
            for name, (low, high) in region.items()
        )
        for region in regions(asset, condition)
    )


def state_for(
    asset: Asset, conditions: Iterable[AssetCondition], *, ignore: str = "", extreme: Collection[str] = ()
) -> dict[str, float] | None:
    """Find positions of free joints in which conditions hold and no other joint is blocked.

    The joint `ignore` may stand anywhere. Joints in `extreme` stand at the far end of a region, others in its
    center.

    Returns:
        Positions of the joints that the conditions concern [rad or m]; None if there are none.
    """
    wanted = list(conditions)
    far = {leader_of(asset, asset.joint(name))[0] for name in extreme}
    for _ in range(len(asset.joints) + 1):
        found = next(_states(asset, wanted, ignore, far), None)
        if found is None:
            return None
        blocked = map(asset.joint, asset.blocked(found))
        needed = [
            joint.needs.condition
            for joint in blocked
            if joint.needs is not None and leader_of(asset, joint)[0] != ignore
        ]
        if not needed:
            return found
        wanted += needed
    return None


def _states(
    asset: Asset, conditions: list[AssetCondition], ignore: str, extreme: Collection[str]
) -> Iterator[dict[str, float]]:
    for boxes in product(*(regions(asset, condition) for condition in conditions)):
        region = intersection(boxes)
        region.pop(ignore, None)
        chosen = {}
        for name, interval in region.items():
            position = _choose(asset.joint(name), interval, extreme=name in extreme)
            if position is None:
                break
            chosen[name] = position
        else:
            yield chosen


def _choose(joint: AssetJoint, interval: tuple[float, float], *, extreme: bool) -> float | None:
    """Choose the position of a joint: closed if possible, else the center or the far end."""
    if interval[0] < joint.closed < interval[1]:
        return joint.closed
    low, high = joint.limits or (-math.inf, math.inf)
    low, high = max(low, interval[0]), min(high, interval[1])
    if high - low <= POINT:
        return None
    if not math.isfinite(low) or not math.isfinite(high):
        return low + _OPEN_TRAVEL if math.isfinite(low) else high - _OPEN_TRAVEL
    if not extreme:
        return (low + high) / 2.0
    end, inside = (high, -1.0) if low >= joint.closed else (low, 1.0)
    return end + inside * POINT if end in interval else end  # beyond the border of a follower too


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


_OPPOSITES: Mapping[str, Literal["above", "below", "all", "any"]] = {
    "above": "below", "below": "above", "all": "any", "any": "all"
}  # fmt: skip


def negation(condition: AssetCondition, border: float = BORDER) -> AssetCondition:
    """Return the region in which a condition does not hold, with a border of a width [rad or m]."""
    shift = {"above": border, "below": -border}.get(condition.kind, 0.0)
    terms = tuple(negation(term, border) for term in condition.terms)
    return AssetCondition(_OPPOSITES[condition.kind], condition.joint, condition.value + shift, terms)
