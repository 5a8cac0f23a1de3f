"""Check of joints: their numbers, couplings, dependencies and pivots."""

import itertools
import math
from collections.abc import Iterator, Mapping

import numpy as np

from artgen.asset import Asset, AssetCondition, AssetDependency, AssetJoint
from artgen.asset.report import Finding
from artgen.errors import ArtgenError, nearest

_LEAST_RANGE = 1e-6  # smaller ranges count as locked joints that are not declared so [rad or m]
_UNIT = 1e-6  # tolerance of an axis's length
_FOLLOWS = 1e-6  # relative tolerance of a coupled range
_MOST_TERMS = 256  # most examined alternatives of a condition
_NOT_NEGATIVE = ("stiffness", "damping", "friction", "armature")
_POSITIVE = ("effort", "velocity")

Interval = tuple[float, float]


def joint_findings(asset: Asset) -> Iterator[Finding]:
    """Yield the faults of the joints of an asset."""
    joints = {joint.name: joint for joint in asset.joints}
    for joint in asset.joints:
        yield from _number_findings(joint)
        yield from _spring_findings(joint)
        yield from _coupling_findings(joint, joints)
        yield from _pivot_findings(asset, joint)
    yield from _dependency_findings(joints)


def _fault(joint: AssetJoint, message: str, hint: str, value: float | None = None, unit: str = "") -> Finding:
    return Finding("tree", message, joint=joint.name, value=value, unit=unit, hint=hint)


def _unit(joint: AssetJoint) -> str:
    return "rad" if joint.kind == "revolute" else "m"


def _number_findings(joint: AssetJoint) -> Iterator[Finding]:
    length = float(np.linalg.norm(joint.axis))
    if not abs(length - 1.0) <= _UNIT:
        yield _fault(joint, f"its axis has length {length:.6g}", "give a unit vector", length)
    if not np.isfinite(joint.pivot).all():
        yield _fault(joint, "its pivot is not finite", "look for a division by 0 in its place")
    for name in (*_NOT_NEGATIVE, *_POSITIVE, "rest"):
        value = getattr(joint, name)
        if not math.isfinite(value) or (name in _NOT_NEGATIVE and value < 0.0):
            yield _fault(joint, f"its {name} is {value:.6g}", "give a number that is not negative", value)
        elif name in _POSITIVE and value <= 0.0:
            yield _fault(
                joint, f"its {name} is {value:.6g}", "give a positive number; simulators refuse 0", value
            )
    if joint.limits is None:
        return
    low, high = joint.limits
    span = f"its limits are {low:.6g} to {high:.6g} {_unit(joint)}"
    if not (math.isfinite(low) and math.isfinite(high)):
        yield _fault(joint, f"{span}, which is not finite", "leave limits out (None) where there are none")
    elif low > high:
        yield _fault(
            joint,
            f"{span}: the lower one comes first",
            "swap them, or turn the axis",
            high - low,
            _unit(joint),
        )
    elif low < high and high - low < _LEAST_RANGE:
        hint = "lock it with equal limits, or give it a range"
        yield _fault(joint, f"{span}: it cannot move, but is not locked", hint, high - low, _unit(joint))


def _spring_findings(joint: AssetJoint) -> Iterator[Finding]:
    """Yield springs under tension in the whole range; a spring stronger than the effort is a fault."""
    if joint.stiffness <= 0.0 or joint.limits is None or joint.locked:
        return
    low, high = joint.limits
    beyond = max(low - joint.rest, joint.rest - high)
    if not beyond > 0.0:
        return
    unit = "N m" if joint.kind == "revolute" else "N"
    tension = joint.stiffness * beyond
    message = (
        f"its spring rests at {joint.rest:.4g} {_unit(joint)}, beyond its limits {low:.4g} to {high:.4g}: "
        f"{tension:.4g} {unit} hold it at that end"
    )
    if tension > joint.effort:
        yield _fault(
            joint, f"{message}, more than its effort of {joint.effort:.4g} {unit}",
            "bring the rest nearer to the limits, or raise the effort", tension, unit,
        )  # fmt: skip
    else:
        yield Finding("tree", message, joint=joint.name, value=tension, unit=unit, severity="note")


def _coupling_findings(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> Iterator[Finding]:
    if joint.follows is None:
        return
    leader = joints.get(joint.follows.leader)
    if leader is None or leader is joint:
        message = f"it follows {joint.follows.leader!r}, which is no other joint of the asset"
        others = [name for name in joints if name != joint.name]
        yield _fault(joint, message, f"attach that joint as well.{nearest(joint.follows.leader, others)}")
        return
    if _goes_round(joint, joints):
        yield _fault(joint, "its couplings go round in a circle", "let one joint lead")
        return
    expected = None
    if leader.limits is not None:
        ends = sorted(joint.follows.ratio * end + joint.follows.offset for end in leader.limits)
        expected = (ends[0], ends[1])
    if (joint.limits is None) != (expected is None) or (
        joint.limits is not None
        and expected is not None
        and not np.allclose(joint.limits, expected, rtol=0.0, atol=_FOLLOWS * max(1.0, *map(abs, expected)))
    ):
        message = (
            f"its limits {_span(joint.limits)} are not those to which {leader.name!r} takes it, "
            f"{_span(expected)}"
        )
        yield _fault(joint, message, "leave its limits to the coupling", unit=_unit(joint))


def _goes_round(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> bool:
    seen = set()
    current: AssetJoint | None = joint
    while current is not None and current.follows is not None:
        if current.name in seen:
            return True
        seen.add(current.name)
        current = joints.get(current.follows.leader)
    return False


def _span(limits: Interval | None) -> str:
    return "none" if limits is None else f"{limits[0]:.6g} to {limits[1]:.6g}"


def _pivot_findings(asset: Asset, joint: AssetJoint) -> Iterator[Finding]:
    """Yield axes farther from both links than the size of the links."""
    if joint.kind != "revolute" or not np.isfinite(joint.pivot).all():
        return
    by_name = {link.name: link for link in asset.links}
    if joint.parent not in by_name or joint.child not in by_name:
        return
    try:
        boxes = [by_name[name].bounds() for name in (joint.parent, joint.child)]
    except ArtgenError:
        return  # the check of solids reports missing files
    gaps, sizes = [], []
    for low, high in boxes:
        center, size = (low + high) / 2.0, float(np.linalg.norm(high - low))
        gaps.append(float(np.linalg.norm(np.cross(center - joint.pivot, joint.axis))) - size / 2.0)
        sizes.append(size)
    if all(gap > size for gap, size in zip(gaps, sizes, strict=True)):
        yield _fault(
            joint,
            f"its axis passes {joint.child!r} and {joint.parent!r} at a distance of {min(gaps):.4g} m",
            "take the pivot from the geometry: solid.anchor(...)", min(gaps), "m",
        )  # fmt: skip


def _dependency_findings(joints: Mapping[str, AssetJoint]) -> Iterator[Finding]:
    """Yield dependencies that cannot be satisfied, and those that forbid nothing."""
    dependent = []
    for joint in joints.values():
        if joint.needs is None:
            continue
        named = joint.needs.condition.joints()
        unknown = [name for name in named if name not in joints or name == joint.name]
        for name in unknown:
            message = f"it needs {name!r}, which is no other joint of the asset"
            others = [other for other in joints if other != joint.name]
            yield _fault(joint, message, f"name another joint.{nearest(name, others)}")
        if not unknown:
            dependent.append(joint)
    ranges = {name: _range(joint) for name, joint in joints.items()}
    open_still: list[AssetJoint] = []
    for joint in dependent:
        assert joint.needs is not None
        condition = joint.needs.condition
        where = ", ".join(f"{name} {_limits(ranges[name])}" for name in condition.joints())
        yield from _slack_findings(joint, joint.needs, ranges[joint.name])
        if not _possible(condition, joints, ranges):
            message = f"it needs {condition}, which its joints never reach: {where}"
            yield _fault(joint, message, "turn the comparison round, or move the threshold into the limits")
        elif not _possible(_negated(condition), joints, ranges):
            message = f"it needs {condition}, which holds everywhere: {where}"
            yield _fault(joint, message, "turn the comparison round, or leave needs out")
        else:
            open_still.append(joint)
    for joint in _stuck(open_still, joints, ranges):
        message = f"it needs {joint.needs}, but those joints wait for it in turn: none can ever leave 0"
        yield _fault(joint, message, "let one of them move freely")


def _slack_findings(joint: AssetJoint, needs: AssetDependency, limits: Interval) -> Iterator[Finding]:
    """Yield impossible ranges of a dependency."""
    low, high = needs.beyond, needs.until
    first, last = 0.0 if low is None else low, math.inf if high is None else high
    bounds = f"it needs {needs.condition} beyond {first:.6g} and until {last:.6g} {_unit(joint)}"
    if (low is not None and not low > 0.0) or not first < last:
        hint = "give positive positions, beyond below until, or leave them out"
        yield _fault(joint, f"{bounds}, where nothing lies between", hint)
    elif low is not None and low >= max(abs(limits[0]), abs(limits[1])):
        message = f"{bounds}, which it never reaches: {joint.name} {_limits(limits)}"
        yield _fault(joint, message, "leave needs out, or take a position within the limits")


def _stuck(
    dependent: list[AssetJoint], joints: Mapping[str, AssetJoint], ranges: Mapping[str, Interval]
) -> list[AssetJoint]:
    """Return the joints that can never leave their closed position or slack, from all joints closed."""
    waiting = list(dependent)
    while True:
        held: dict[str, Interval] = {}
        for joint in waiting:
            head, low, high = _slack(joint, joints)
            before = held.get(head, ranges[head])
            held[head] = (max(low, before[0]), min(high, before[1]))
        released = [
            joint
            for joint in waiting
            if joint.needs is not None and _possible(joint.needs.condition, joints, {**ranges, **held})
        ]
        if not released:
            return waiting
        waiting = [joint for joint in waiting if joint not in released]


def _slack(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> tuple[str, float, float]:
    """Return the leader of a joint, and its range without the dependency."""
    head, ratio, offset = _led(joint.name, joints)
    closed = joints[head].closed
    if joint.needs is None or joint.needs.beyond is None or not ratio:
        return head, closed, closed
    ends = [(side * joint.needs.beyond - offset) / ratio for side in (-1.0, 1.0)]
    return head, min(*ends, closed), max(*ends, closed)


def _range(joint: AssetJoint) -> Interval:
    return (-math.inf, math.inf) if joint.limits is None else joint.limits


def _limits(interval: Interval) -> str:
    return "is unlimited" if math.isinf(interval[0]) else f"is {interval[0]:.6g} to {interval[1]:.6g}"


def _negated(condition: AssetCondition) -> AssetCondition:
    """Return the complement of a region, without its border."""
    other = {"above": "below", "below": "above", "all": "any", "any": "all"}
    return AssetCondition(
        other[condition.kind],  # type: ignore[arg-type]
        condition.joint,
        condition.value,
        tuple(_negated(term) for term in condition.terms),
    )


def _possible(
    condition: AssetCondition, joints: Mapping[str, AssetJoint], ranges: Mapping[str, Interval]
) -> bool:
    """Tell whether a region has an interior within joint limits and couplings."""
    for number, terms in enumerate(_alternatives(condition)):
        if number >= _MOST_TERMS or _fits(terms, joints, ranges):
            return True  # too many alternatives: assume that it is possible
    return False


def _alternatives(condition: AssetCondition) -> Iterator[tuple[AssetCondition, ...]]:
    """Yield the comparisons of each way to satisfy a condition."""
    if condition.kind in {"above", "below"}:
        yield (condition,)
    elif condition.kind == "any":
        for term in condition.terms:
            yield from _alternatives(term)
    else:
        for choice in itertools.product(*(tuple(_alternatives(term)) for term in condition.terms)):
            yield tuple(itertools.chain.from_iterable(choice))


def _fits(
    terms: tuple[AssetCondition, ...], joints: Mapping[str, AssetJoint], ranges: Mapping[str, Interval]
) -> bool:
    """Tell whether comparisons can hold together: each narrows the range of the leader."""
    left: dict[str, Interval] = {}
    for term in terms:
        name, ratio, offset = _led(term.joint, joints)
        if ratio == 0.0:
            if (offset > term.value) != (term.kind == "above"):
                return False
            continue
        bound = (term.value - offset) / ratio
        low, high = left.get(name, (-math.inf, math.inf))
        left[name] = (
            (max(low, bound), high) if (term.kind == "above") == (ratio > 0.0) else (low, min(high, bound))
        )
    return all(
        low < high and low < ranges[name][1] and ranges[name][0] < high for name, (low, high) in left.items()
    )


def _led(name: str, joints: Mapping[str, AssetJoint]) -> tuple[str, float, float]:
    """Return the leader at the head of a chain of couplings, with ratio and offset of its follower."""
    ratio, offset = 1.0, 0.0
    for _ in joints:
        follows = joints[name].follows
        if follows is None or follows.leader not in joints:
            break
        offset += ratio * follows.offset
        ratio *= follows.ratio
        name = follows.leader
    return name, ratio, offset
