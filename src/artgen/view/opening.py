"""Poses that show the inside of an asset: open doors, drawers and lids."""

from collections.abc import Iterable, Mapping
from collections.abc import Set as AbstractSet

import numpy as np

from artgen.asset import Asset, AssetCondition, AssetJoint
from artgen.errors import ParameterError
from artgen.export.frames import leader_of, regions

_WIDE = 1.2  # wider swings show more from the front if they are not fully open [rad]
_SHARE = 0.45  # opened share of a wide swing about an upright axis; beyond, a door shows only its edge
_UPRIGHT = 0.7  # vertical part of the axis above which a hinge belongs to a door, and a slide is a lift
_LIFT = (0.1, 0.5)  # smallest large lift, and its opened share [m, share]
_ROUND, _AJAR = 2.4, 0.3  # turn at each of two hinges that fold a lid behind its base, and its opened share
_TURN = 0.8  # opening of a joint without limits [rad or m]
# size of a part, relative to the parts that it unlocks, above which it is a door or lid instead of a lock
_DOOR = 0.4
_TOP = 0.4  # opening of the highest of stacked drawers, so that all are visible from above
_STACKED = 0.5  # share of the narrower of two drawers that lies above the other


def opened(asset: Asset, share: float = 1.0) -> dict[str, float]:
    """Return joint positions in which an asset is open [rad or m].

    Wide doors are opened by half, or as far as the parts behind them need; other joints are opened up to
    their limits, lifts by half, and upper drawers less than those below. Joints that only unlock others, such
    as levers, stay at rest unless the others could not be open otherwise.

    Args:
        asset: The asset.
        share: Opening, from 0 for closed to 1.

    Raises:
        ParameterError: The share is not in 0..1.
    """
    if not 0.0 <= share <= 1.0:
        raise ParameterError(f"open {share!r} must be in 0..1")
    free = {joint.name: joint for joint in asset.free_joints}
    moved = {name: _moved(asset, name) for name in free}
    locks = _locks(asset)
    doors = {name for name, dependent in locks.items() if _is_door(asset, moved, name, dependent)}
    leaders = {name for name in free if name not in locks or name in doors} or set(free)
    ends = {name: _end(asset, joint) for name, joint in free.items()}
    ends |= _wide_enough(asset, ends, doors)
    shares = _drawer_shares(asset, [joint for name, joint in free.items() if name in leaders])
    q = {
        name: joint.closed + share * shares.get(name, 1.0) * (ends[name] - joint.closed) * (name in leaders)
        for name, joint in free.items()
    }
    if asset.blocked(q):
        q |= {name: ends[name] for name in locks if name not in doors}
    # blocked joints stay closed; others may depend on them, so repeat until nothing changes
    while blocked := [name for name in asset.blocked(q) if name in q and q[name] != free[name].closed]:
        q |= {name: free[name].closed for name in blocked}
    return {name: position for name, position in q.items() if position != free[name].closed}


def _end(asset: Asset, joint: AssetJoint) -> float:
    """Return the open position of a joint, regardless of other joints."""
    if joint.limits is None:
        return _TURN
    low, high = joint.limits
    end = high if high - joint.closed >= joint.closed - low else low
    travel = end - joint.closed
    if joint.kind == "revolute" and abs(travel) > _WIDE and _upright(joint):
        travel *= _SHARE
    if (
        joint.kind == "revolute"
        and abs(travel) > _ROUND
        and any(
            each.child == joint.parent and leader_of(asset, each)[0] == joint.name for each in asset.joints
        )
    ):
        travel *= _AJAR
    if joint.kind == "prismatic" and travel * joint.axis[2] > _LIFT[0] * _UPRIGHT and _upright(joint):
        travel *= _LIFT[1]
    return joint.closed + travel


def _upright(joint: AssetJoint) -> bool:
    return bool(abs(joint.axis[2]) > _UPRIGHT)


def _locks(asset: Asset) -> dict[str, set[str]]:
    """Return the free joints in conditions, each with the free joints that depend on it."""
    found: dict[str, set[str]] = {}
    for joint in asset.joints:
        for name in joint.needs.condition.joints() if joint.needs is not None else ():
            lock = leader_of(asset, asset.joint(name))[0]
            if not asset.joint(lock).locked:
                found.setdefault(lock, set()).add(leader_of(asset, joint)[0])
    return found


def _moved(asset: Asset, name: str) -> set[str]:
    """Return the links that a free joint moves, including descendants and coupled links."""
    found = {joint.child for joint in asset.joints if leader_of(asset, joint)[0] == name}
    for parent, child, _ in asset.pairs():
        if parent in found:
            found.add(child)
    return found


def _is_door(
    asset: Asset, moved: Mapping[str, AbstractSet[str]], lock: str, dependent: Iterable[str]
) -> bool:
    """Tell whether a part that others depend on should be opened by itself, unlike a lock."""
    size = _size(asset, moved[lock])
    return any(size >= _DOOR * _size(asset, moved[other]) for other in dependent if moved.get(other))


def _size(asset: Asset, links: Iterable[str]) -> float:
    boxes = np.array([asset.link(name).bounds() for name in links])
    return float(np.linalg.norm(boxes[:, 1].max(axis=0) - boxes[:, 0].min(axis=0)))


def _wide_enough(asset: Asset, ends: Mapping[str, float], doors: AbstractSet[str]) -> dict[str, float]:
    """Return positions of doors that have to open farther for the parts behind them."""
    found: dict[str, float] = {}
    for joint in asset.joints:
        if joint.needs is not None and joint.needs.until is None:
            found |= _satisfying(asset, joint.needs.condition, {**ends, **found}, doors)
    return found


def _satisfying(
    asset: Asset, condition: AssetCondition, ends: Mapping[str, float], doors: AbstractSet[str]
) -> dict[str, float]:
    """Return positions of doors that satisfy a condition; empty if there are none."""
    for region in regions(asset, condition):
        found = {}
        for name, (low, high) in region.items():
            if name not in doors or low < ends[name] < high:
                continue
            limits = asset.joint(name).limits or (-np.inf, np.inf)
            least, most = max(low, limits[0]), min(high, limits[1])
            if not -np.inf < least < most < np.inf:
                break
            found[name] = (least + most) / 2.0
        else:
            return found
    return {}


def _drawer_shares(asset: Asset, joints: Iterable[AssetJoint]) -> dict[str, float]:
    """Return the share of their range by which drawers above other drawers are pulled."""
    slides = [joint for joint in joints if joint.kind == "prismatic" and not _upright(joint)]
    slides.sort(key=lambda joint: float(asset.link(joint.child).bounds()[:, 2].mean()))
    level: dict[str, int] = {}
    for number, joint in enumerate(slides):
        below = [level[other.name] for other in slides[:number] if _is_above(asset, joint, other)]
        level[joint.name] = max(below) + 1 if below else 0
    highest = max(level.values(), default=0)
    return {name: 1.0 - (1.0 - _TOP) * number / highest for name, number in level.items() if number}


def _is_above(asset: Asset, upper: AssetJoint, lower: AssetJoint) -> bool:
    """Tell whether an open drawer would cover another one of the same piece of furniture."""
    if upper.parent != lower.parent or upper.axis @ lower.axis < _UPRIGHT:
        return False
    above, below = asset.link(upper.child).bounds(), asset.link(lower.child).bounds()
    across = np.array([-upper.axis[1], upper.axis[0]])  # in plan, perpendicular to the pull
    spans = [np.sort((box[:, :2] * np.abs(across)).sum(axis=1)) for box in (above, below)]
    common = min(spans[0][1], spans[1][1]) - max(spans[0][0], spans[1][0])
    narrower = min(span[1] - span[0] for span in spans)
    return bool(above[0, 2] > below[:, 2].mean() and common > _STACKED * narrower)
