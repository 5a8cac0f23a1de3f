"""The regions of joint space in which conditions of dependencies hold, as boxes of free joints."""

import math
from collections.abc import Iterable
from itertools import product

from artgen.asset import Asset, Condition, Joint
from artgen.export.frames import coupling

BORDER = 1e-9
"""Regions are open; what lies this far beyond a border is on it [rad or m]."""

Region = dict[str, tuple[float, float]]
"""A box of joint space: open intervals of free joints; those that are not named may stand anywhere."""


def leader_of(asset: Asset, joint: Joint) -> tuple[str, float, float]:
    """Return the free joint that decides where a joint stands, with ratio and offset."""
    law = coupling(asset, joint)
    return (joint.name, 1.0, 0.0) if law is None else (law.leader, law.ratio, law.offset)


def regions(asset: Asset, condition: Condition) -> list[Region]:
    """Return boxes that together are the region of a condition."""
    if condition.kind == "any":
        return [region for term in condition.terms for region in regions(asset, term)]
    if condition.kind == "all":
        parts = product(*(regions(asset, term) for term in condition.terms))
        return [intersection(part) for part in parts]
    joint = asset.joint(condition.joint)
    if joint.locked:
        return [{}] if condition.holds({joint.name: joint.closed}) else []
    name, ratio, offset = leader_of(asset, joint)
    bound = (condition.value - offset) / ratio
    above = (condition.kind == "above") == (ratio > 0.0)
    return [{name: (bound, math.inf) if above else (-math.inf, bound)}]


def intersection(boxes: Iterable[Region]) -> Region:
    """Return what boxes have in common; an interval that nothing is in has its ends the wrong way round."""
    result: Region = {}
    for box in boxes:
        for name, (low, high) in box.items():
            before = result.get(name, (-math.inf, math.inf))
            result[name] = (max(low, before[0]), min(high, before[1]))
    return result
