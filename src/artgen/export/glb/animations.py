"""Animations of a GLB file: each free joint opens and closes, after the joints that it depends on."""

import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import Asset, AssetCoupling, AssetJoint
from artgen.export.frames import BORDER, POINT, Region, Segment, coupling, leader_of, regions
from artgen.export.glb.buffer import Buffer, Json

Stop = Mapping[str, float]
"""Positions of all free joints [rad or m]."""

_TRAVEL = {"revolute": math.tau, "prismatic": 0.2}  # range of joints without limits [rad or m]
_CHECKS = 8  # checked positions between two stops
_OPENS = 1.0  # duration of the opening of a joint [s]
_PREPARES = 0.5  # duration of the motion of a joint that it depends on [s]
_PAUSES = 0.2  # pause between two motions [s]
_FASTEST = math.pi  # mean speed of a rotation [rad/s]
_FEWEST_STEPS = 8  # keys of a motion; readers interpolate linearly between them
_WIDEST_STEP = math.radians(25.0)


class _NoWayError(Exception):
    """A dependency cannot be satisfied."""


def animations(
    asset: Asset, segments: Sequence[Segment], nodes: Mapping[str, int], buffer: Buffer
) -> tuple[list[Json], list[str]]:
    """Add an animation for each free joint, with its name.

    Args:
        asset: The asset.
        segments: Its joints with their frames.
        nodes: Number of each frame's node by name.
        buffer: Buffer for the keys.

    Returns:
        The animations as JSON data, and the joints that dependencies keep at rest.
    """
    laws = [
        (each, coupling(asset, each.joint) or AssetCoupling(each.joint.name, 1.0))
        for each in segments
        if not each.joint.locked
    ]
    result: list[Json] = []
    held = []
    for joint in asset.free_joints:
        stops = opening(asset, joint)
        if stops is None:
            held.append(joint.name)
            continue
        moved = {name for name in stops[0] if len({stop[name] for stop in stops}) > 1}
        moving = [each for each in laws if each[1].leader in moved]
        turns: dict[str, float] = {}  # largest rotation of any joint per motion of each free joint
        for segment, law in moving:
            if segment.joint.kind == "revolute":
                turns[law.leader] = max(turns.get(law.leader, 0.0), law.steepest)
        keys, positions = _keys(joint.name, stops, turns)
        times = buffer.array("times", keys)
        channels: list[Json] = []
        samplers: list[Json] = []
        for segment, law in moving:
            moves, rotations = local_motion(segment, law.positions(positions[law.leader]))
            slides = segment.joint.kind == "prismatic"
            output = buffer.array("moves", moves) if slides else buffer.array("rotations", rotations)
            target = {"node": nodes[segment.child.name], "path": "translation" if slides else "rotation"}
            channels.append({"sampler": len(samplers), "target": target})
            samplers.append({"input": times, "output": output})
        result.append({"name": joint.name, "channels": channels, "samplers": samplers})
    return result, held


def local_motion(segment: Segment, positions: Array) -> tuple[Array, Array]:
    """Return the pose of a segment's child in its parent's frame at positions of the joint, shape (k,).

    Returns:
        Translations, shape (k, 3) [m], and rotations as quaternions (x, y, z, w), shape (k, 4), without sign
        changes.
    """
    joint, origin = segment.joint, segment.origin[:3, 3]
    if joint.kind == "prismatic":
        still = np.tile([0.0, 0.0, 0.0, 1.0], (len(positions), 1))
        return origin + positions[:, None] * joint.axis, still
    half = positions[:, None] / 2.0
    return np.tile(origin, (len(positions), 1)), np.hstack(
        [_portable.sin(half) * joint.axis, _portable.cos(half)]
    )


def _keys(joint: str, stops: Sequence[Stop], turns: Mapping[str, float]) -> tuple[Array, dict[str, Array]]:
    """Return times, shape (k,) [s], and the positions of the free joints at these times."""
    times, shares, legs = [np.zeros(1)], [np.zeros(1)], [0]
    for number, (start, end) in enumerate(itertools.pairwise(stops)):
        turned = max(abs(end[name] - start[name]) * turns.get(name, 0.0) for name in start)
        # with this easing, the peak speed is pi / 2 times the mean speed
        steps = max(_FEWEST_STEPS, math.ceil(turned * math.pi / 2.0 / _WIDEST_STEP))
        share = np.arange(steps + 1) / steps
        begins = times[-1][-1] + (_PAUSES if number else 0.0)
        own = start[joint] != end[joint]
        leg = begins + share * max(_OPENS if own else _PREPARES, turned / _FASTEST)
        times.append(leg if number else leg[1:])
        shares.append((0.5 - 0.5 * _portable.cos(math.pi * share))[0 if number else 1 :])
        legs += [number] * len(times[-1])
    first, share = np.array(legs), np.concatenate(shares)
    table = {name: np.array([stop[name] for stop in stops]) for name in stops[0]}
    positions = {
        name: column[first] + share * (column[first + 1] - column[first]) for name, column in table.items()
    }
    return np.concatenate(times), positions


def opening(asset: Asset, joint: AssetJoint) -> tuple[Stop, ...] | None:
    """Return stops of a free joint from rest to its limits and back to rest.

    Between two stops one joint moves with its followers. First move the joints that others depend on, then
    the joint itself to its upper and to its lower limit, unless it rests there; then all joints return. A
    joint without limits makes a full turn.
    """
    stops: list[Stop] = [{each.name: each.closed for each in asset.free_joints}]
    try:
        stops = _cleared(asset, joint.name, stops)
    except _NoWayError:
        return None
    prepared = stops[:-1]
    for end in _ends(joint):
        stops = _moved(stops, joint.name, end)
    if prepared or not _comes_round(asset, joint):
        stops = [*_moved(stops, joint.name, joint.closed), *reversed(prepared)]
    return tuple(stops) if _allowed(asset, stops) else None


def _ends(joint: AssetJoint) -> list[float]:
    if joint.limits is None:
        return [joint.closed + _TRAVEL[joint.kind]]
    return [end for end in reversed(joint.limits) if abs(end - joint.closed) > BORDER]


def _comes_round(asset: Asset, joint: AssetJoint) -> bool:
    """Tell whether everything that a joint moves returns after a full turn."""
    laws = [(each, coupling(asset, each)) for each in asset.joints]
    moved = [(each, law) for each, law in laws if law is not None and law.leader == joint.name]
    return (
        joint.limits is None
        and joint.kind == "revolute"
        and all(law.comes_round(each.kind) for each, law in moved)
    )


def _allowed(asset: Asset, stops: Iterable[Stop]) -> bool:
    """Tell whether dependencies hold on the whole path, except for those that do not hold at rest."""
    resting = set(asset.blocked())
    shares = [number / _CHECKS for number in range(1, _CHECKS + 1)]
    return all(
        resting.issuperset(asset.blocked({name: a[name] + share * (b[name] - a[name]) for name in a}))
        for a, b in itertools.pairwise(stops)
        for share in shares
    )


def _cleared(asset: Asset, name: str, stops: list[Stop], waiting: tuple[str, ...] = ()) -> list[Stop]:
    """Return stops with the moves of other joints after which a joint and its followers may move."""
    if name in waiting:
        raise _NoWayError
    for joint in asset.joints:
        if joint.needs is not None and leader_of(asset, joint)[0] == name:
            for region in regions(asset, joint.needs.condition):
                with suppress(_NoWayError):
                    stops = _inside(asset, region, stops, (*waiting, name))
                    break
            else:
                raise _NoWayError
    return stops


def _inside(asset: Asset, region: Region, stops: list[Stop], waiting: tuple[str, ...]) -> list[Stop]:
    """Return stops with the moves of joints into a region."""
    for name, (low, high) in region.items():
        if not low < stops[-1][name] < high:
            position = _within(asset.joint(name), low, high)
            stops = _moved(_cleared(asset, name, stops, waiting), name, position)
    return stops


def _moved(stops: list[Stop], name: str, position: float) -> list[Stop]:
    return [*stops, {**stops[-1], name: position}]


def _within(joint: AssetJoint, low: float, high: float) -> float:
    """Return the position of a joint in an open interval, at a limit if possible."""
    ends = joint.limits or (-math.inf, math.inf)
    for end in reversed(ends):
        if low < end < high and math.isfinite(end):
            return end
    low, high = max(low, ends[0]), min(high, ends[1])
    if high - low <= POINT:
        raise _NoWayError
    if math.isfinite(low) and math.isfinite(high):
        return (low + high) / 2.0
    return low + _TRAVEL[joint.kind] if math.isfinite(low) else high - _TRAVEL[joint.kind]
