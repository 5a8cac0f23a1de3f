"""Numbers for the repair of a design: safe joint limits, and clearances at one pose."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.asset.affordance import head
from artgen.asset.collision import link_parts
from artgen.asset.manifolds import box_of
from artgen.proof.certify import certify
from artgen.proof.overlap import link_overlap
from artgen.proof.paths import JointPath, Space

_BISECTIONS = 9
_MARGIN = 1e-6  # half the range in which a joint at rest is proven [rad or m]
_FARTHEST = 10.0  # largest measured clearance [m]


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
        low, high = (_end(others, joint.name, rest, end) for end in limits)
        result[joint.name] = (low, high)
    return result


def _end(asset: Asset, joint: str, rest: float, end: float) -> float:
    """Return the safe position nearest to an end of a joint's range."""
    if _is_safe(asset, joint, (min(rest, end), max(rest, end))):
        return end
    safe, unsafe = rest, end
    for _ in range(_BISECTIONS):
        middle = (safe + unsafe) / 2.0
        if _is_safe(asset, joint, (min(rest, middle), max(rest, middle))):
            safe = middle
        else:
            unsafe = middle
    return safe


def _is_safe(asset: Asset, joint: str, limits: tuple[float, float]) -> bool:
    """Tell whether the pairs that a joint moves are proven apart within limits."""
    led = {other.name for other in asset.joints if joint in (other.name, head(other, asset).name)}
    low, high = limits
    if low == high:
        low, high = low - _MARGIN, high + _MARGIN  # a locked joint moves no pair

    def moved(joint_path: JointPath) -> bool:
        return not led.isdisjoint(step.name for step in joint_path.steps)

    return certify(_narrowed(asset, {joint: (low, high)}), only=moved).proven


def _narrowed(asset: Asset, limits: Mapping[str, tuple[float, float]]) -> Asset:
    joints = [replace(joint, limits=limits.get(joint.name, joint.limits)) for joint in asset.joints]
    return replace(asset, joints=tuple(joints))


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
            result[a, b] = -float(np.cbrt(overlap.volume))
        else:
            result[a, b] = _distance(asset.link(a), asset.link(b), np.linalg.inv(poses[a]) @ poses[b])
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
