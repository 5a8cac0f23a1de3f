"""Check of the tree of links: connected solids, names, masses, and joints with their dependencies."""

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from contextlib import suppress
from functools import partial

import numpy as np

from artgen._names import is_identifier
from artgen.asset import Asset, AssetJoint, Grasp, Link
from artgen.asset.asset import followed_limits
from artgen.asset.collision import mesh_precision
from artgen.asset.joint import DYNAMICS
from artgen.asset.manifolds import box_gaps
from artgen.asset.report import CheckResult, Finding
from artgen.errors import ArtgenError, nearest
from artgen.export.frames import leader_of
from artgen.validate.joints import is_possible, negation, place, unit
from artgen.validate.solids import floating_findings

CHECK = "tree"

LARGEST = 10.0
"""Largest plausible length of an asset; a longer one may have been given in millimetres [m]."""

LIGHTEST, HEAVIEST = 5.0, 20000.0
"""Range of plausible mean densities of a link: foam to tungsten [kg/m^3]."""

_ROUNDING = 1e-9  # relative tolerance of moments of inertia
_EXACT = 1e-6  # tolerance of axes and coupled ranges
_FREE = 0.05  # distance of a link from all others beyond which nothing carries it [m]
_LEAST_RANGE = 1e-6  # smaller ranges count as locked joints that are not declared so [rad or m]

Interval = tuple[float, float]

_fault = partial(Finding, CHECK)


def check_tree(asset: Asset) -> CheckResult:
    """Check the tree of an asset: names, labels, joints, masses, and floating parts."""
    if not asset.links:
        return CheckResult(CHECK, (_fault("the asset has no links", hint="generate it again"),))
    findings = [*_structure_findings(asset), *_name_findings(asset), *_label_findings(asset)]
    findings += _joint_findings(asset)
    findings += _size_findings(asset)
    for link in asset.links:
        findings += _grasp_findings(link, {joint.name for joint in asset.joints})
        try:
            findings += () if mesh_precision(link) else floating_findings(link)
            findings += _mass_findings(link)
        except ArtgenError as error:
            # the check of solids reports missing files
            message = f"its connection and mass cannot be judged: {error}"
            findings.append(_fault(message, link.name, severity="note"))
    return CheckResult(CHECK, tuple(findings), f"{len(asset.links)} links, {len(asset.joints)} joints")


def _size_findings(asset: Asset) -> Iterator[Finding]:
    """Yield a note about an asset that is larger than furniture and appliances are."""
    try:
        low, high = asset.bounds()
    except ArtgenError:
        return  # other findings report missing files
    size = float((high - low).max())
    if size > LARGEST:
        axis = ("wide", "deep", "high")[int(np.argmax(high - low))]
        message = f"the asset is {size:.4g} m {axis}: are these millimetres? lengths are in metres"
        hint = f"write {size / 1000.0:.4g} for {size:.4g} mm"
        yield _fault(message, value=size, unit="m", hint=hint, severity="note")


def _structure_findings(asset: Asset) -> Iterator[Finding]:
    """Yield the faults of the tree of links, whose root is the first link."""
    names = [link.name for link in asset.links]
    parents: dict[str, str] = {}
    for joint in asset.joints:
        parent, child = joint.parent, joint.child
        ends = [end for end in (parent, child) if end not in names]
        for end in ends:
            message = f"it joins {end!r}, which is not a link.{nearest(end, names)}"
            yield _fault(message, joint=joint.name, hint="name a link of the asset")
        if ends:
            continue
        if parents.setdefault(child, parent) != parent:
            message = f"its parents are {parents[child]!r} and {parent!r}; a link has one parent"
            yield _fault(message, child, joint.name, hint="attach it once")
        elif names.index(parent) >= names.index(child):
            message = (
                f"its parent {parent!r} does not come before it: links form a circle or are out of order"
            )
            yield _fault(message, child, joint.name, hint="list parents before their children")
    root, *others = names
    if root in parents:
        hint = "list the link without a parent first"
        yield _fault(f"the base has the parent {parents[root]!r}", root, hint=hint)
    for name in others:
        if name not in parents:
            message = "no joint joins it to the others: the asset has more than one root"
            yield _fault(message, name, hint="attach it to a parent, or weld it")


def _name_findings(asset: Asset) -> Iterator[Finding]:
    names = [("link", link.name) for link in asset.links] + [("joint", joint.name) for joint in asset.joints]
    names += [("grasp", hold.name) for link in asset.links for hold in (*link.grasps, *link.pushes)]
    for (kind, name), count in Counter(names).items():
        link, joint = (name if kind == each else "" for each in ("link", "joint"))
        if count > 1:
            message = f"{count} {kind}s are named {name!r}"
            yield _fault(message, link, joint, float(count), hint="give each a name of its own")
        if not is_identifier(name):
            message = f"the {kind} name {name!r} is not an identifier"
            yield _fault(message, link, joint, hint="use letters, digits and _")


def _label_findings(asset: Asset) -> Iterator[Finding]:
    for link in asset.links if asset.labels else ():
        for label in link.labels:
            if label not in asset.labels:
                message = f"its label {label!r} is not declared by category {asset.category!r}"
                hint = f"declare it in @category(labels=...).{nearest(label, asset.labels)}"
                yield _fault(message, link.name, hint=hint)


def _grasp_findings(link: Link, joints: Collection[str]) -> Iterator[Finding]:
    for grasp in (*link.grasps, *link.pushes):
        for name in grasp.when.joints() if grasp.when is not None else ():
            if name not in joints:
                message = f"grasp {grasp.name!r} is reached when {grasp.when}, and there is no joint {name!r}"
                yield _fault(message, link.name, hint="name a joint of the asset")
        turn = grasp.frame[:3, :3]
        error = float(np.abs(turn.T @ turn - np.eye(3)).max())
        if not (error <= _EXACT and np.linalg.det(turn) > 0.0 and np.isfinite(grasp.frame).all()):
            message = f"the axes of grasp {grasp.name!r} are not a rotation: they are off by {error:.3g}"
            hint = "make the frame of unit axes at right angles"
            yield _fault(message, link.name, value=error, hint=hint)
        if isinstance(grasp, Grasp) and not grasp.width > 0.0:
            message = f"grasp {grasp.name!r} has width {grasp.width:.4g} m"
            hint = "give the opening of the fingers"
            yield _fault(message, link.name, value=grasp.width, unit="m", hint=hint)


def _mass_findings(link: Link) -> Iterator[Finding]:
    """Yield impossible mass, center or inertia for the bounds of a link."""
    properties = link.mass_properties
    mass, inertia = properties.mass, properties.inertia
    finite = np.isfinite([mass, *properties.center, *inertia.ravel()]).all()
    if not (finite and mass > 0.0):
        message = f"its mass is {mass:.4g} kg, or its center or inertia is not finite"
        yield _fault(message, link.name, value=mass, unit="kg", hint="give it a solid with a density")
        return
    low, high = link.bounds()
    if link.absent:
        return  # it has the least mass and inertia that simulators accept
    yield from _density_findings(link, mass, float(np.prod(high - low)))
    slack = 1e-6 * float(np.linalg.norm(high - low))
    if (properties.center < low - slack).any() or (properties.center > high + slack).any():
        center = ", ".join(f"{value:.4g}" for value in properties.center)
        message = f"its center of mass ({center}) m lies outside its bounding box"
        yield _fault(message, link.name, hint="derive it from the solids")
    moments = [float(moment) for moment in np.linalg.eigvalsh(inertia)]
    if moments[0] <= 0.0 or moments[0] + moments[1] < moments[2] * (1.0 - _ROUNDING):
        text = ", ".join(f"{moment:.4g}" for moment in moments)
        message = f"its principal moments {text} kg m^2 are impossible for a rigid body"
        hint = "each must be positive and no larger than the sum of the others"
        yield _fault(message, link.name, value=moments[0], unit="kg m^2", hint=hint)
    largest = mass * float(np.sum((high - low) ** 2))
    if moments[2] > largest:
        message = f"its moment {moments[2]:.4g} kg m^2 exceeds what its mass and size allow, {largest:.4g}"
        yield _fault(message, link.name, value=moments[2], unit="kg m^2", hint="derive it from the solids")


def _density_findings(link: Link, mass: float, box: float) -> Iterator[Finding]:
    """Yield implausible mean densities; of the bounding box if the solids are unknown."""
    volume = sum(piece.shape.manifold.volume() for piece in link.pieces if not piece.visual)
    name, size, least = ("solids", volume, LIGHTEST) if volume > 0.0 else ("bounding box", box, 0.0)
    density = mass / size if size > 0.0 else np.inf
    # overlapping solids count twice in the volume, which makes the density too low by at most half
    if not 0.5 * least <= density <= HEAVIEST:
        message = f"its mass of {mass:.4g} kg makes a density of {density:.4g} kg/m^3 of its {name}"
        hint = f"between {LIGHTEST:g} and {HEAVIEST:g} is plausible; check material and measures"
        yield _fault(message, link.name, value=float(density), unit="kg/m^3", hint=hint)


def _joint_findings(asset: Asset) -> Iterator[Finding]:
    """Yield the faults of joints: numbers, springs, pivots, couplings and dependencies."""
    joints = {joint.name: joint for joint in asset.joints}
    leaders = {joint.follows.leader for joint in asset.joints if joint.follows is not None}
    for joint in asset.joints:
        yield from _number_findings(joint, leads=joint.name in leaders)
        yield from _spring_findings(joint)
        yield from _pivot_findings(asset, joint)
    wrong = [finding for joint in asset.joints for finding in _leader_findings(joint, joints)]
    yield from wrong
    if not wrong:  # otherwise nothing is known about the positions of followers
        for joint in asset.joints:
            yield from _coupling_findings(joint, joints)
        yield from _dependency_findings(asset)


def _number_findings(joint: AssetJoint, *, leads: bool) -> Iterator[Finding]:
    """Yield wrong numbers of a joint; a joint that leads others, such as a screw, may make several turns."""
    fault = partial(_fault, joint=joint.name)
    size = float(np.linalg.norm(joint.axis))
    if not abs(size - 1.0) <= _EXACT:
        yield fault(f"its axis has length {size:.6g}", value=size, hint="give a unit vector")
    if not np.isfinite(joint.pivot).all():
        yield fault("its pivot is not finite", hint="look for a division by 0 in its place")
    for name in DYNAMICS:
        value = getattr(joint, name)
        positive = name in ("effort", "velocity")
        if not math.isfinite(value) or (name != "rest" and value < 0.0) or (positive and value == 0.0):
            hint = "positive number; simulators refuse 0" if positive else "number that is not negative"
            yield fault(f"its {name} is {value:.6g}", value=value, hint=f"give a {hint}")
    if joint.limits is None:
        return
    low, high = joint.limits
    span = f"its limits are {_limits(joint)} {unit(joint)}"
    in_range = partial(fault, value=high - low, unit=unit(joint))
    if not (math.isfinite(low) and math.isfinite(high)):
        yield fault(f"{span}, which is not finite", hint="leave limits out (None) where there are none")
    elif low > high:
        hint = "swap them, or turn the axis"
        yield in_range(f"{span}: the lower limit comes first", hint=hint)
    elif low < high and high - low < _LEAST_RANGE:
        hint = "lock it with equal limits, or give it a range"
        yield in_range(f"{span}: it cannot move, but is not locked", hint=hint)
    farthest = max(abs(low), abs(high))
    turns_freely = joint.kind == "revolute" and joint.follows is None and not leads
    if turns_freely and farthest > 2.0 * math.pi * (1.0 + _EXACT):
        turns = (high - low) / (2.0 * math.pi)
        hint = f"degrees? use math.radians({farthest:.4g})"
        yield in_range(f"{span}, {turns:.2g} turns", hint=hint, severity="note")


def _spring_findings(joint: AssetJoint) -> Iterator[Finding]:
    """Yield springs under tension in the whole range; a spring stronger than the effort is a fault."""
    if joint.stiffness <= 0.0 or joint.limits is None or joint.locked:
        return
    low, high = joint.limits
    tension = joint.stiffness * max(low - joint.rest, joint.rest - high)
    if not tension > 0.0:
        return
    of_force = unit(joint, "effort")
    message = (
        f"its spring rests at {place(joint, joint.rest)}, beyond its limits {low:.4g} to {high:.4g}: "
        f"{tension:.4g} {of_force} hold it at that end"
    )
    finding = partial(_fault, joint=joint.name, value=tension, unit=of_force)
    if tension > joint.effort:
        message += f", more than its effort of {joint.effort:.4g} {of_force}"
        yield finding(message, hint="bring the rest nearer to the limits, or raise the effort")
    else:
        yield finding(message, severity="note")


def _pivot_findings(asset: Asset, joint: AssetJoint) -> Iterator[Finding]:
    """Yield axes farther from both links than the size of the links, and links that nothing carries."""
    if joint.kind != "revolute" or not np.isfinite(joint.pivot).all():
        return
    try:
        boxes = [asset.link(name).bounds() for name in (joint.parent, joint.child)]
    except ArtgenError:
        return  # other findings report unknown links and missing files
    sizes = [float(np.linalg.norm(high - low)) for low, high in boxes]
    gaps = [
        float(np.linalg.norm(np.cross((low + high) / 2.0 - joint.pivot, joint.axis))) - size / 2.0
        for (low, high), size in zip(boxes, sizes, strict=True)
    ]
    if all(gap > size for gap, size in zip(gaps, sizes, strict=True)):
        message = f"its axis passes {joint.child!r} and {joint.parent!r} at a distance of {min(gaps):.4g} m"
        hint = "take the pivot from the geometry: solid.anchor(...)"
        yield _fault(message, joint=joint.name, value=min(gaps), unit="m", hint=hint)
    elif box_gaps(np.array(boxes[:1]), np.array(boxes[1:])).min() > _FREE:
        below, child = _below(asset, joint.child), boxes.pop()
        with suppress(ArtgenError):
            boxes += [link.bounds() for link in asset.links if link.name not in below]
        apart = float(box_gaps(np.array(boxes), child[None]).min())
        if apart > _FREE:
            message = (
                f"nothing carries {joint.child!r}, which is {1e3 * apart:.4g} mm from all other links at rest"
            )
            hint = "move it to its place: solid.at(...)"
            yield _fault(message, joint=joint.name, value=apart, unit="m", hint=hint, severity="note")


def _below(asset: Asset, link: str) -> set[str]:
    """Return the names of a link and of all links that it carries."""
    found, count = {link}, 0
    while len(found) > count:  # an edited file may have its joints in any order
        count = len(found)
        found |= {joint.child for joint in asset.joints if joint.parent in found}
    return found


def _leader_findings(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> Iterator[Finding]:
    """Yield unknown leaders, and couplings in a circle."""
    follower, seen = joint, {joint.name}
    while follower.follows is not None:
        leader = joints.get(follower.follows.leader)
        if leader is None or leader is follower:
            if follower is joint:
                name = follower.follows.leader
                message = f"it follows {name!r}, which is not another joint of the asset"
                hint = f"attach that joint as well.{nearest(name, joints.keys() - {joint.name})}"
                yield _fault(message, joint=joint.name, hint=hint)
            return
        if leader.name in seen:
            yield _fault("its couplings form a circle", joint=joint.name, hint="let one joint lead")
            return
        follower = leader
        seen.add(leader.name)


def _coupling_findings(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> Iterator[Finding]:
    """Yield limits that differ from the range to which the leader takes a joint."""
    if joint.follows is None:
        return
    leader = joints[joint.follows.leader]
    expected = followed_limits(joint.follows, leader)
    found, wanted = (limits or (-math.inf, math.inf) for limits in (joint.limits, expected))
    if not np.allclose(found, wanted, rtol=0.0, atol=_EXACT):
        span = f"{expected[0]:.6g} to {expected[1]:.6g}" if expected else "none"
        message = f"its limits {_limits(joint)} are not those to which {leader.name!r} takes it, {span}"
        yield _fault(message, joint=joint.name, unit=unit(joint), hint="leave its limits to the coupling")


def _limits(joint: AssetJoint) -> str:
    return "none" if joint.limits is None else f"{joint.limits[0]:.6g} to {joint.limits[1]:.6g}"


def _range(joint: AssetJoint) -> str:
    return f"{joint.name} is {'unlimited' if joint.limits is None else _limits(joint)}"


def _dependency_findings(asset: Asset) -> Iterator[Finding]:
    """Yield dependencies that cannot be satisfied, and those that forbid nothing."""
    ranges = {joint.name: joint.limits or (-math.inf, math.inf) for joint in asset.joints}
    waiting: list[AssetJoint] = []
    for joint in asset.joints:
        if joint.needs is None:
            continue
        fault, condition = partial(_fault, joint=joint.name), joint.needs.condition
        others = [name for name in ranges if name != joint.name]
        unknown = [name for name in condition.joints() if name not in others]
        for name in unknown:
            message = f"it needs {name!r}, which is not another joint of the asset"
            yield fault(message, hint=f"name another joint.{nearest(name, others)}")
        if unknown:
            continue
        where = ", ".join(_range(asset.joint(name)) for name in condition.joints())
        yield from _slack_findings(joint, ranges[joint.name])
        if not is_possible(asset, condition, ranges):
            message = f"it needs {condition}, which its joints never reach: {where}"
            yield fault(message, hint="reverse the comparison, or move the threshold into the limits")
        elif not is_possible(asset, negation(condition, 0.0), ranges):
            message = f"it needs {condition}, which holds everywhere: {where}"
            yield fault(message, hint="reverse the comparison, or leave needs out")
        else:
            waiting.append(joint)
    for joint in _stuck(asset, waiting, ranges):
        message = f"it needs {joint.needs}, but those joints depend on it as well: all stay at 0"
        yield _fault(message, joint=joint.name, hint="let one of them move freely")


def _slack_findings(joint: AssetJoint, limits: Interval) -> Iterator[Finding]:
    """Yield impossible ranges of a dependency."""
    assert joint.needs is not None
    low, high = joint.needs.beyond, joint.needs.until
    first, last = low or 0.0, math.inf if high is None else high
    bounds = f"it needs {joint.needs.condition} beyond {first:.6g} and until {last:.6g} {unit(joint)}"
    if (low is not None and not low > 0.0) or not first < last:
        hint = "give positive positions, beyond below until, or leave them out"
        yield _fault(f"{bounds}, which is empty", joint=joint.name, hint=hint)
    elif low is not None and low >= max(map(abs, limits)):
        hint = "leave needs out, or take a position within the limits"
        yield _fault(f"{bounds}, which it never reaches: {_range(joint)}", joint=joint.name, hint=hint)


def _stuck(asset: Asset, joints: list[AssetJoint], ranges: Mapping[str, Interval]) -> list[AssetJoint]:
    """Return the joints that can never leave their closed position or slack, from all joints closed."""
    waiting = joints
    while True:
        held: dict[str, Interval] = {}
        for joint in waiting:
            head, low, high = _slack(asset, joint)
            before = held.get(head, ranges[head])
            held[head] = (max(low, before[0]), min(high, before[1]))
        stuck = [
            joint
            for joint in waiting
            if joint.needs is not None and not is_possible(asset, joint.needs.condition, {**ranges, **held})
        ]
        if stuck == waiting:
            return waiting
        waiting = stuck


def _slack(asset: Asset, joint: AssetJoint) -> tuple[str, float, float]:
    """Return the leader of a joint, and its range without the dependency."""
    head, ratio, offset = leader_of(asset, joint)
    closed = asset.joint(head).closed
    if joint.needs is None or joint.needs.beyond is None or not ratio:
        return head, closed, closed
    ends = [(side * joint.needs.beyond - offset) / ratio for side in (-1.0, 1.0)]
    return head, min(*ends, closed), max(*ends, closed)
