"""Numbers for the repair of a design: safe joint limits, and clearances at one pose."""

import itertools
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fnmatch import filter as filter_names
from functools import partial
from typing import Any, get_args

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen._names import ByName
from artgen.asset import Asset, AssetCondition, AssetDependency, AssetJoint, Link
from artgen.asset.affordance import head
from artgen.asset.asset import Limits, remember, with_followed_limits
from artgen.asset.collision import link_parts
from artgen.asset.joint import joints_above
from artgen.asset.manifolds import box_of
from artgen.errors import AssetError, ParameterError, nearest
from artgen.proof.certify import Known, are_apart, certify, doubtful_colliders, doubtful_pairs
from artgen.proof.overlap import link_overlap
from artgen.proof.paths import JointPath, Space

_BISECTIONS = 9
_MARGIN = 1e-6  # half the range in which a joint at rest is proven [rad or m]
_AJAR = 0.02  # share of its range in which a joint counts as all but closed
_FARTHEST = 10.0  # largest measured clearance [m]

Range = tuple[float, float]
Selection = Callable[[JointPath], bool]


def safe_limits(asset: Asset) -> dict[str, tuple[float, float]]:
    """Return for each free joint the largest range around rest in which no pair that it moves collides.

    The other joints have their whole ranges. If no range is safe then, they are at rest, so that a joint
    that causes no collision keeps its limits. Ends are found by bisection and proven, to 1/512 of the range.

    Returns:
        Lowest and highest position of each free joint [rad or m]; both at rest if the links overlap there.
    """
    ranges = Space(asset).ranges
    result = {}
    for joint in asset.free_joints:
        limits, rest = ranges[joint.name], joint.closed
        if _is_safe(asset, joint.name, limits):
            result[joint.name] = limits
            continue
        others = asset
        if not _is_safe(asset, joint.name, (rest, rest)):
            free = [other for other in asset.free_joints if other is not joint]
            others = _narrowed(asset, {other.name: (other.closed, other.closed) for other in free})
        if others is not asset and not _is_safe(others, joint.name, (rest, rest)):
            result[joint.name] = (rest, rest)
            continue
        low, high = (_end(partial(_is_safe, others, joint.name), rest, end) for end in limits)
        result[joint.name] = (low, high)
    return result


def narrowed_limits(
    asset: Asset, counts: Callable[[JointPath], bool], *, overlap: float, seconds: float
) -> dict[str, tuple[float, float]]:
    """Return limits of some joints with which no counted pair collides.

    Each joint is first narrowed as if the others were at rest, and then, one joint after another, with the
    ranges that the others have by then, so that all new limits hold together. A joint that is not even safe
    at rest is locked there.

    Args:
        asset: The asset.
        counts: Selects the pairs that may not collide.
        overlap: Overlap that is permitted everywhere [m].
        seconds: Time limit for the proof of the pairs that a joint moves [s].

    Returns:
        Lowest and highest position of each narrowed joint [rad or m].

    Raises:
        AssetError: Links overlap at rest, or are not proven apart with all joints at rest.
    """
    check = partial(certify, overlap=overlap, seconds=seconds)

    def proven(asset: Asset, only: Selection) -> bool:
        return check(asset, only=only).proven

    at_rest = {joint.name: (joint.closed, joint.closed) for joint in asset.free_joints}
    full = Space(asset).ranges
    ranges = dict(full)
    for others_rest in (True, False):
        for name, (rest, _) in at_rest.items():
            others = at_rest if others_rest else ranges
            around = _narrowed(asset, {other: ends for other, ends in others.items() if other != name})
            safe = partial(_is_safe, around, name, counts=counts, proven=proven)
            ranges[name] = _largest(safe, rest, ranges[name])
    found = {name: ends for name, ends in ranges.items() if ends != full[name]}
    nearly = {
        name: (low - _MARGIN, high + _MARGIN) if low == high else (low, high)
        for name, (low, high) in found.items()
    }
    failed = check(_narrowed(asset, nearly), only=counts).failures
    if failed:
        raise AssetError(f"no joint limits mend asset {asset.name!r}: with those that are left, {failed[0]}")
    return found


def separated(asset: Asset, counts: Callable[[JointPath], bool], known: Known) -> Asset:
    """Return an asset in whose valid states no counted pair collides, by narrower limits and dependencies.

    A joint that collides while the others are all but closed is narrowed. Of two joints that collide with
    each other, the one that moves less mass then depends on the other one: it stays near its closed position
    unless the other one is near it as well. A joint that has a dependency already does not get another.

    Args:
        asset: The asset; the other pairs are not examined.
        counts: Selects the pairs that may not collide, such as those of links of two assets in a scene.
        known: Takes the searches of pairs, for a proof of the returned asset.

    Raises:
        AssetError: The joints of a pair have dependencies already, or the pair collides at rest.
    """
    failed = doubtful_pairs(asset, counts, known)
    names = {name for links in failed for name in links}
    parts = replace(asset, links=ByName(link for link in asset.links if link.name in names))
    paths = Space(parts).joint_paths(lambda path: path.links in failed)
    limits: dict[str, Range] = {}
    for name in dict.fromkeys(name for path in paths for name in path.variables):
        others = {each.name: _ajar(each) for each in asset.free_joints if each.name != name}
        pairs = {path.links for path in paths if name in path.variables}
        found = _free(_narrowed(parts, others), name, pairs, known)
        if found != asset.joint(name).limits:
            limits[name] = found
    asset, parts = _narrowed(asset, limits), _narrowed(parts, limits)
    doubtful = doubtful_colliders(parts, 0.0, lambda path: path.links in failed)
    still = [{link for link, _ in group} for group in doubtful]
    paths = [path for path in paths if {*path.links} in still]
    needs: dict[str, AssetDependency] = {}
    while paths:
        mended, name, dependency = _dependency(parts, paths, known)
        needs[name] = _both(needs[name], dependency) if name in needs else dependency
        paths = [path for path in paths if path.links not in mended]
    joints = [replace(each, needs=needs.get(each.name, each.needs)) for each in asset.joints]
    return replace(asset, joints=ByName(joints))


def _ajar(joint: AssetJoint) -> Range:
    """Return a small range around the closed position [rad or m]."""
    low, high = joint.limits or (-np.pi, np.pi)
    slack = _AJAR * (high - low)
    return max(low, joint.closed - slack), min(high, joint.closed + slack)


def _dependency(
    asset: Asset, paths: Sequence[JointPath], known: Known
) -> tuple[set[tuple[str, str]], str, AssetDependency]:
    """Return the pairs that a dependency keeps apart, with the first one, its joint, and the dependency."""

    def heavier(names: tuple[str, str]) -> bool:
        return _moved_mass(asset, names[0]) > _moved_mass(asset, names[1])

    links, variables = paths[0].links, paths[0].variables
    for first, second in sorted(itertools.permutations(variables, 2), key=heavier):
        if asset.joint(first).needs is None:
            pairs = {path.links for path in paths if {first, second} <= {*path.variables}}
            near, room = (_free(asset, name, pairs, known) for name in (first, second))
            if near[0] < near[1] and room[0] < room[1]:
                return pairs, first, _needs(asset, first, near, second, room)
    raise AssetError(
        f"asset {asset.name!r}: {links[0]!r} and {links[1]!r} collide, and no limits or dependencies of "
        f"{' and '.join(variables)} prevent it; place them farther apart"
    )


def _needs(asset: Asset, first: str, near: Range, second: str, room: Range) -> AssetDependency:
    """Return the dependency that keeps a joint in a range unless the other one is in its range."""
    full = asset.joint(second).limits or (-np.inf, np.inf)
    terms = []
    if room[0] > full[0]:
        terms.append(AssetCondition("above", second, room[0]))
    if room[1] < full[1]:
        terms.append(AssetCondition("below", second, room[1]))
    low, high = asset.joint(first).limits or (-np.inf, np.inf)
    ends = [abs(end) for end, limit in zip(near, (low, high), strict=True) if end != limit]
    condition = terms[0] if len(terms) == 1 else AssetCondition("all", terms=tuple(terms))
    return AssetDependency(condition, beyond=min(ends))


def _both(one: AssetDependency, other: AssetDependency) -> AssetDependency:
    """Return the dependency with the conditions of two; it begins where the first of them begins."""
    beyond = min(one.beyond or 0.0, other.beyond or 0.0)
    return AssetDependency(AssetCondition("all", terms=(one.condition, other.condition)), beyond=beyond)


def _free(asset: Asset, joint: str, pairs: set[tuple[str, str]], known: Known) -> Range:
    """Return the range of a joint around its closed position in which given pairs are apart."""
    proven = partial(are_apart, known=known)
    safe = partial(_is_safe, asset, joint, counts=lambda path: path.links in pairs, proven=proven)
    return _largest(safe, asset.joint(joint).closed, Space(asset).ranges[joint])


def _largest(safe: Callable[[Range], bool], rest: float, limits: Range) -> Range:
    """Return the largest safe range of a joint around rest; both ends at rest if nothing is safe."""
    if safe(limits):
        return limits
    if not safe((rest, rest)):
        return (rest, rest)
    low, high = (_end(safe, rest, end) for end in limits)
    return (low, high)


def _end(safe: Callable[[Range], bool], rest: float, end: float) -> float:
    """Return the safe position nearest to an end of a joint's range."""
    if safe((min(rest, end), max(rest, end))):
        return end
    near, far = rest, end
    for _ in range(_BISECTIONS):
        middle = (near + far) / 2.0
        if safe((min(rest, middle), max(rest, middle))):
            near = middle
        else:
            far = middle
    return near


def _is_safe(
    asset: Asset,
    joint: str,
    limits: Range,
    counts: Selection = lambda joint_path: True,
    proven: Callable[[Asset, Selection], bool] = lambda asset, only: certify(asset, only=only).proven,
) -> bool:
    """Tell whether the pairs that a joint moves are proven apart within limits."""
    led = {other.name for other in asset.joints if joint in (other.name, head(other, asset).name)}
    low, high = limits
    if low == high:
        low, high = low - _MARGIN, high + _MARGIN  # a locked joint moves no pair

    def moved(joint_path: JointPath) -> bool:
        return not led.isdisjoint(step.name for step in joint_path.steps) and counts(joint_path)

    return proven(_narrowed(asset, {joint: (low, high)}), moved)


def _narrowed(asset: Asset, limits: Mapping[str, tuple[float, float]]) -> Asset:
    """Return an asset with limits of some joints, and of those that follow them."""
    joints = {
        joint.name: replace(joint, limits=limits.get(joint.name, joint.limits)) for joint in asset.joints
    }
    return replace(asset, joints=ByName(with_followed_limits(joint, joints) for joint in joints.values()))


_SMALL = 0.05  # share of its range in which a joint that is held open is locked
_MOST = 0.8  # share of its range at which a joint gives way to its dependency in any case


def with_limits(asset: Asset, limits: Limits, keep: str | Iterable[str] = ()) -> Asset:
    """Return an asset with joint ranges in which every state is free, proven as such.

    For each dependency, either the dependent joint is narrowed to positions that are free without the
    condition (a rack stays in its oven), or the joints of the condition are narrowed until it holds (the
    handle of a window stays turned). The dependent joint gives way if four fifths of its range are left then,
    or if it moves less mass than the joints of the condition. A joint that would be held open within a
    twentieth of its range is locked at the open end.

    Args:
        asset: An asset with full ranges.
        limits: `independent`; `full` changes nothing.
        keep: Names of joints, or patterns such as `rack_*`, that keep their range where possible.

    Returns:
        The asset without dependencies, with a certificate if it had one.

    Raises:
        AssetError: The ranges are narrowed already, a pattern fits no joint, or there are no such limits.
        ParameterError: `keep` has something else than texts.
    """
    if limits not in get_args(Limits):
        raise AssetError(f"limits = {limits!r} is not allowed: it must be 'full' or 'independent'")
    if limits == asset.limits:
        return asset
    if asset.limits != "full":
        raise AssetError(f"asset {asset.name!r} has {asset.limits} limits; narrow the original asset instead")
    names = [joint.name for joint in asset.joints]
    given: Any = keep
    patterns = list(given) if isinstance(given, Iterable) and not isinstance(given, str) else [given]
    for pattern in patterns:
        if not isinstance(pattern, str):
            raise ParameterError(f"keep = {keep!r} is not allowed: give names of joints, such as ['rack_*']")
        if not filter_names(names, pattern):
            raise AssetError(f"keep={pattern!r} fits no joint of {asset.name!r}.{nearest(pattern, names)}")
    kept = {name for pattern in patterns for name in filter_names(names, pattern)}
    ranges: dict[str, Range] = {}  # of the narrowed joints
    for joint in asset.joints:
        if joint.needs is not None:
            _resolve(asset, joint, joint.needs, kept, ranges)
    ranges = {name: _locked_open(asset.joint(name), left) for name, left in ranges.items()}
    free = ByName(replace(joint, needs=None) for joint in asset.joints)
    narrowed = replace(_narrowed(replace(asset, joints=free), ranges), limits=limits)
    if asset.certificate is not None:
        remember(narrowed, certify(narrowed, asset.certificate.tolerance))
    return narrowed


def _locked_open(joint: AssetJoint, left: Range) -> Range:
    """Return a range, or only its open end if it is small and without the closed position."""
    # at its other end, a spring would press the joint back against what it has cleared
    low, high = joint.limits or (-np.inf, np.inf)
    if left[0] <= joint.closed <= left[1] or not 0.0 < left[1] - left[0] < _SMALL * (high - low) < np.inf:
        return left
    end = max(left, key=lambda end: abs(end - joint.closed))
    return end, end


def _resolve(
    asset: Asset, joint: AssetJoint, needs: AssetDependency, kept: set[str], ranges: dict[str, Range]
) -> None:
    """Narrow a joint with a dependency, or the joints of its condition."""
    low, high = ranges.get(joint.name, joint.limits or (-np.inf, np.inf))
    near, far = needs.beyond or 0.0, needs.until or np.inf
    parts = [(max(low, -near), min(high, near)), (max(low, far), high), (low, min(high, -far))]
    free = max(parts, key=lambda part: part[1] - part[0])
    others = needs.condition.joints()
    yields = free[1] - free[0] >= _MOST * (high - low) or any(
        _moved_mass(asset, name) > _moved_mass(asset, joint.name) for name in others
    )
    if joint.name in kept or not kept.isdisjoint(others):
        yields = joint.name not in kept
    if not yields:
        trial = dict(ranges)
        if _hold(asset, needs.condition, trial):
            ranges.update(trial)
            return
    _narrow(asset, joint.name, free, ranges)


def _moved_mass(asset: Asset, joint: str) -> float:
    """Return the mass of all links that a joint moves [kg]."""
    return sum(
        link.mass_properties.mass
        for link in asset.links
        if joint in {above.name for above in joints_above(asset.joints, link.name)}
    )


def _narrow(asset: Asset, name: str, to: Range, ranges: dict[str, Range]) -> bool:
    """Narrow the range of a joint or of its leader to a range [rad or m]; tell whether any is left."""
    joint = asset.joint(name)
    if joint.follows is not None:
        ends = sorted((end - joint.follows.offset) / joint.follows.ratio for end in to)
        return _narrow(asset, joint.follows.leader, (ends[0], ends[1]), ranges)
    low, high = ranges.get(name, joint.limits or (-np.inf, np.inf))
    low, high = max(low, to[0]), min(high, to[1])
    ranges[name] = (low, high)
    return low <= high


def _hold(asset: Asset, condition: AssetCondition, ranges: dict[str, Range]) -> bool:
    """Narrow the ranges of the joints in a condition until it always holds; tell whether that worked."""
    if condition.kind in ("above", "below"):
        strictly = _MARGIN * max(1.0, abs(condition.value))
        above, below = (condition.value + strictly, np.inf), (-np.inf, condition.value - strictly)
        return _narrow(asset, condition.joint, above if condition.kind == "above" else below, ranges)
    if condition.kind == "all":
        return all(_hold(asset, term, ranges) for term in condition.terms)
    for term in condition.terms:  # one of them suffices
        trial = dict(ranges)
        if _hold(asset, term, trial):
            ranges.update(trial)
            return True
    return False


def clearance(asset: Asset, q: Mapping[str, float] | None = None) -> dict[tuple[str, str], float]:
    """Return the distance between the solids of each pair of links at one pose.

    Args:
        asset: The asset.
        q: Positions by joint name, completed as in `Asset.positions` [rad or m].

    Returns:
        The distance by the names of the two links, for links that can move against each other, without pieces
        that may touch [m]. For two links that overlap, minus the cube root of the common volume.

    Raises:
        AssetError: A joint is unknown, coupled to another, or beyond its limits.
    """
    poses, positions = asset.pose(q), asset.positions(q)
    result: dict[tuple[str, str], float] = {}
    for joint_path in Space(asset).joint_paths():
        at = np.array([positions[name] for name in joint_path.variables])
        a, b = joint_path.links
        if overlap := link_overlap(asset, joint_path, at):
            result[a, b] = -(overlap.volume ** (1.0 / 3.0))
        else:
            result[a, b] = _distance(asset.link(a), asset.link(b), _portable.inverse(poses[a]) @ poses[b])
    return result


def _distance(first: Link, second: Link, matrix: Array) -> float:
    """Return the distance between the solids of two links, the second link moved [m]."""
    at_rest = [part.solid for part in link_parts(first)]
    moved = [part.solid.transform(matrix[:3]) for part in link_parts(second)]
    boxes = [np.array([box_of(solid) for solid in solids]) for solids in (at_rest, moved)]
    low = np.maximum(boxes[0][:, None, 0] - boxes[1][None, :, 1], 0.0)
    high = np.maximum(boxes[1][None, :, 0] - boxes[0][:, None, 1], 0.0)
    apart = np.sqrt(np.sum((low + high) ** 2, axis=2))
    best = _FARTHEST
    for flat in np.argsort(apart, axis=None, kind="stable"):  # nearest boxes first
        a, b = np.unravel_index(flat, apart.shape)
        if apart[a, b] >= best:
            break
        best = min(best, at_rest[a].min_gap(moved[b], best))
    return best
