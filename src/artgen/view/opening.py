"""How an asset stands open: what a person would open to show what is inside."""

from artgen.asset import Asset, Joint
from artgen.errors import ParameterError

_WIDE = 1.2  # a swing that is wider shows more from in front when it is not opened fully [rad]
_SHARE = 0.45  # of a wide swing about an upright axis: farther, a door is seen edge on
_LAID = 0.7  # a hinge whose axis leans less than this lets its part swing down, as an oven's door does
_TURN = 0.8  # of a joint without limits [rad or m]


def opened(asset: Asset, share: float = 1.0) -> dict[str, float]:
    """Return joint positions in which an asset is open [rad or m].

    Doors that swing wide are opened by half, other joints up to their limits. What only unlocks another
    joint, as a lever does, stays at rest unless the other one could not stand open otherwise.

    Args:
        asset: The asset.
        share: How far, from 0 for closed to 1.

    Raises:
        ParameterError: The share is not in 0..1.
    """
    if not 0.0 <= share <= 1.0:
        raise ParameterError(f"open {share!r} must be in 0..1")
    free = {joint.name: joint for joint in asset.free_joints}
    keys = {
        name for joint in asset.joints if joint.needs is not None for name in joint.needs.condition.joints()
    }
    leaders = {joint.name for joint in free.values() if joint.name not in keys} or set(free)
    q = {name: _target(joint, share if name in leaders else 0.0) for name, joint in free.items()}
    if asset.blocked(q):
        q |= {name: _target(free[name], 1.0) for name in keys if name in free}
    # what still may not stand there stays closed; the rest may depend on it, so again until nothing changes
    while blocked := [name for name in asset.blocked(q) if name in q and q[name] != free[name].closed]:
        q |= {name: free[name].closed for name in blocked}
    return {name: position for name, position in q.items() if position != free[name].closed}


def _target(joint: Joint, share: float) -> float:
    if joint.limits is None:
        return share * _TURN
    low, high = joint.limits
    end = high if high - joint.closed >= joint.closed - low else low
    way = end - joint.closed
    if joint.kind == "revolute" and abs(way) > _WIDE and abs(joint.axis[2]) > _LAID:
        way *= _SHARE
    return joint.closed + share * way
