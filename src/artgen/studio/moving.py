"""Joints moved by a person: each goes as far as what it and the others wait for lets it."""

from collections.abc import Iterator, Mapping

from artgen.asset import Asset, Condition
from artgen.export.regions import leader_of

_NUDGE = 1e-9  # beyond a place where a dependency begins or ends [rad or m]


def moved(
    asset: Asset, q: Mapping[str, float], joint: str, wanted: float
) -> tuple[dict[str, float], tuple[str, ...]]:
    """Move a free joint from where it stands towards a position, until a dependency stops it."""
    start = asset.positions(q)[joint]
    limits = asset.joint(joint).limits
    end = wanted if limits is None else min(max(wanted, limits[0]), limits[1])
    reached = start
    for place in _places(asset, joint, start, end):
        # what holds in the middle holds up to the next place where a dependency begins or ends
        blocked = asset.blocked({**q, joint: (reached + place) / 2.0})
        if blocked:
            return {**q, joint: reached}, blocked
        back = 0.0 if not asset.blocked({**q, joint: place}) else _NUDGE if end > start else -_NUDGE
        reached = place - back
    blocked = asset.blocked({**q, joint: end})
    return {**q, joint: reached if blocked else end}, blocked


def settled(asset: Asset, q: Mapping[str, float]) -> dict[str, float]:
    """Return positions that an asset allows, as near to others as can be told without a search."""
    result = {}
    for joint in asset.free_joints:
        if joint.name in q:
            low, high = joint.limits or (q[joint.name], q[joint.name])
            result[joint.name] = min(max(q[joint.name], low), high)
    for _ in asset.joints:  # closing one may block another
        blocked = asset.blocked(result)
        if not blocked:
            break
        result |= {name: asset.joint(name).closed for name in _leaders(asset, blocked)}
    return result


def _leaders(asset: Asset, joints: tuple[str, ...]) -> set[str]:
    names = {leader_of(asset, asset.joint(name))[0] for name in joints}
    return {name for name in names if not asset.joint(name).locked}


def _places(asset: Asset, joint: str, start: float, end: float) -> Iterator[float]:
    """Yield in order where on the way of a joint dependencies begin or end, and the end of the way."""
    found = {end}
    for other in asset.joints:
        if other.needs is None:
            continue
        leader, ratio, offset = leader_of(asset, other)
        if leader == joint and ratio:
            bounds = (0.0, other.needs.until, other.needs.beyond)
            values = [value for bound in bounds if bound is not None for value in (bound, -bound)]
            found.update((value - offset) / ratio for value in values)
        for name, value in _thresholds(other.needs.condition):
            leader, ratio, offset = leader_of(asset, asset.joint(name))
            if leader == joint and ratio:
                found.add((value - offset) / ratio)
    low, high = min(start, end), max(start, end)
    yield from sorted((place for place in found if low <= place <= high), reverse=end < start)


def _thresholds(condition: Condition) -> Iterator[tuple[str, float]]:
    if condition.joint:
        yield condition.joint, condition.value
    for term in condition.terms:
        yield from _thresholds(term)
