"""Random positions of joints in which an asset can stand: limits, couplings and dependencies are met."""

import math
from collections.abc import Mapping

import numpy as np

from artgen.asset import Asset, Joint
from artgen.export.regions import Region, leader_of, regions

_MOVED = 0.7  # share of the joints that are away from where they rest
_FREED = 0.7  # how often what holds a joint is moved out of its way, rather than the joint put back
_ROUNDS = 8  # of moving things out of each other's way


def random_positions(asset: Asset, draw: np.random.Generator) -> dict[str, float]:
    """Return positions of the free joints at which no dependency forbids any joint to stand [rad or m].

    Most joints stand anywhere between their limits, some at rest. Where one may not, what holds it is moved
    (the door, so that the rack comes out), or it is put back. A certified asset has no collision there.
    """
    free = {joint.name: joint for joint in asset.free_joints}
    q = {name: _anywhere(joint, draw) for name, joint in free.items()}
    q |= {name: free[name].closed for name in free if draw.random() > _MOVED}
    freed = {joint.name: draw.random() < _FREED for joint in asset.joints}
    for _ in range(_ROUNDS):
        for name in asset.blocked(q):
            joint = asset.joint(name)
            q |= _freeing(asset, joint, free, draw) if freed[name] else _back(asset, joint, free)
    # what still may not stand there goes back; the rest may depend on it, so again until nothing changes
    while blocked := [name for name in asset.blocked(q) if _is_away(asset, name, q, free)]:
        for name in blocked:
            q |= _back(asset, asset.joint(name), free)
    return q if not asset.blocked(q) else {name: joint.closed for name, joint in free.items()}


def _anywhere(joint: Joint, draw: np.random.Generator) -> float:
    low, high = joint.limits or (-math.pi, math.pi)
    return float(draw.uniform(low, high))


def _back(asset: Asset, joint: Joint, free: Mapping[str, Joint]) -> dict[str, float]:
    leader = leader_of(asset, joint)[0]
    return {leader: free[leader].closed} if leader in free else {}


def _is_away(asset: Asset, name: str, q: Mapping[str, float], free: Mapping[str, Joint]) -> bool:
    leader = leader_of(asset, asset.joint(name))[0]
    return leader in free and q[leader] != free[leader].closed


def _freeing(
    asset: Asset, joint: Joint, free: Mapping[str, Joint], draw: np.random.Generator
) -> dict[str, float]:
    """Return positions of other joints that let a joint move; back to rest with it if there are none."""
    assert joint.needs is not None
    boxes = [
        box
        for region in regions(asset, joint.needs.condition)
        if (box := _within_limits(region, free)) is not None
    ]
    if not boxes:
        return _back(asset, joint, free)
    box = boxes[int(draw.integers(len(boxes)))]
    return {name: float(draw.uniform(low, high)) for name, (low, high) in box.items()}


def _within_limits(region: Region, free: Mapping[str, Joint]) -> Region | None:
    """Return what of a region joints can reach; None if that is nothing."""
    found = {}
    for name, (low, high) in region.items():
        if name not in free:
            return None
        least, most = free[name].limits or (-math.pi, math.pi)
        if max(low, least) >= min(high, most):
            return None
        found[name] = (max(low, least), min(high, most))
    return found
