"""Joint positions for the approach of a hand: covers of its target are open."""

from collections.abc import Iterator, Mapping

from artgen.asset import Asset, AssetCondition
from artgen.asset.affordance import Affordance, moved_joints
from artgen.export.frames import leader_of
from artgen.validate.behavior.conditions import state_for

_WIDE = 0.98  # share of its way from which a joint is open

Opened = Mapping[str, AssetCondition]
"""For each joint that was opened so that a hand can come, the region in which it is open."""


def standing(asset: Asset, joint: str, opened: Opened) -> dict[str, float] | None:
    """Return where the other joints stand for a hand to move a joint; None if there is no such place.

    Args:
        asset: The asset.
        joint: Name of a free joint; empty for none.
        opened: What has to be open besides what the joint itself needs.
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
    """Yield joints whose opening may clear the way of a hand, with the regions in which they are open.

    These are the joints that move what the hand struck, and those that move the thing itself after its own
    joint, such as the door in whose inner side a flap sits. A joint that needs the one which the hand is to
    move can be opened only afterwards.

    Args:
        asset: The asset.
        affordance: What the hand does.
        struck: The link that it strikes.
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
    """Return the free joints that a joint waits for, those that they wait for in turn, and so on."""
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
