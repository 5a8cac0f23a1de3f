"""Joint positions for the approach of a hand, with covers of its target open."""

from collections.abc import Iterator, Mapping

from artgen.asset import Asset, AssetCondition
from artgen.asset.affordance import Affordance, moved_joints
from artgen.export.frames import leader_of
from artgen.validate.behavior.conditions import state_for

_WIDE = 0.98  # share of its range from which a joint counts as open

Opened = Mapping[str, AssetCondition]
"""Regions in which joints are open that were opened for the approach of a hand."""


def standing(asset: Asset, joint: str, opened: Opened) -> dict[str, float] | None:
    """Return positions of the other joints at which a hand can move a joint; None if there are none.

    Args:
        asset: The asset.
        joint: Name of a free joint; empty for none.
        opened: Regions that have to be open in addition to the joint's own dependencies.
    """
    conditions = [
        each.needs.condition
        for each in asset.joints
        if each.needs is not None and leader_of(asset, each)[0] == joint
    ]
    conditions += [condition for name, condition in opened.items() if name != joint]
    found = state_for(asset, conditions, ignore=joint, extreme=[each.name for each in asset.joints])
    return None if found is None else {name: at for name, at in found.items() if name != joint}


def openable(asset: Asset, affordance: Affordance, struck: str) -> Iterator[tuple[str, AssetCondition]]:
    """Yield joints whose opening may clear the path of a hand, with the regions in which they are open.

    These are the joints that move the obstacle, and the joints behind the joint itself, such as the door of a
    flap in its inner side. Joints that depend on the joint of the hand are excluded: they can be opened only
    afterwards.

    Args:
        asset: The asset.
        affordance: The grasp or push.
        struck: The link that the hand strikes.
    """
    own, *others = affordance.joints or ("",)
    for name in dict.fromkeys((*moved_joints(asset, struck), *others)):
        joint = asset.joint(name)
        if name == own or joint.driven or joint.limits is None or own in _awaited(asset, name):
            continue
        low, high = joint.limits
        upward = high - joint.closed >= joint.closed - low
        far = high if upward else low
        place = joint.closed + _WIDE * (far - joint.closed)
        yield name, AssetCondition("above" if upward else "below", name, place)


def _awaited(asset: Asset, joint: str) -> set[str]:
    """Return the free joints that a joint depends on, recursively."""
    found: set[str] = set()
    todo = [joint]
    while todo:
        waiting = todo.pop()
        for each in asset.joints:
            if each.needs is not None and leader_of(asset, each)[0] == waiting:
                named = {leader_of(asset, asset.joint(name))[0] for name in each.needs.condition.joints()}
                todo += sorted(named - found)
                found |= named
    return found
