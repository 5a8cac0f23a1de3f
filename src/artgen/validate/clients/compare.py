"""Comparison of an asset with the values that a client read."""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.asset.report import Finding
from artgen.export.frames import coupling
from artgen.validate.clients.client import Client
from artgen.validate.clients.exported import ClientExport
from artgen.validate.readback.reading import expected_frames, expected_limits, spelled_limits

_OF_LINKS = ("mass", "center", "inertia")
_OF_JOINTS = ("kind", "limits")


def silences(client: Client, exported: ClientExport, response: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield the values missing in a client's answer, in total or for a link or joint.

    A key of `Client.tells` such as `joints.damping` is a quantity of each joint. A client that tells of
    links has to tell masses, centers and inertias, one that tells of joints their kinds and limits.
    """
    whole = [key for key in client.tells if "." not in key]
    missing = [key for key in whole if key not in response]
    if missing:
        yield Finding(client.name, f"it tells nothing of {', '.join(missing)}")
    required = {"links": [*_OF_LINKS], "joints": [*_OF_JOINTS]}
    for part, _, quantity in (key.partition(".") for key in client.tells if "." in key):
        required[part].append(quantity)
    for part, quantities in required.items():
        for name, read in response.get(part, {}).items() if part in whole else ():
            lost = [
                quantity
                for quantity in quantities
                if quantity not in read and f"{part}.{quantity}" not in client.withholds
            ]
            if lost:
                where = {"link" if part == "links" else "joint": name}
                yield Finding(client.name, f"it does not tell its {', '.join(lost)}", **where)
    if "moved" in client.tells and "moved" in response:
        yield from _unmoved(client, exported, response["moved"])
    if "steps" in client.tells and not response.get("steps", 1) > 0:
        yield Finding(client.name, "it simulated no steps")


def _unmoved(client: Client, exported: ClientExport, moved: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield the joints that were not driven, but for those that others keep where they are."""
    for joint in exported.asset.free_joints:
        if joint.name not in moved and not exported.is_blocked(joint):
            yield Finding(client.name, "it was not driven in simulation", joint=joint.name)


_GAINS = ("damping", "stiffness", "friction", "armature")
_LEAST_MOTION = 0.1  # share of its range that a driven joint has to move
_MOST_BEYOND = 0.1  # share of its range by which it may yield beyond an end, and:
_SOFT = 0.02  # [rad or m]
_UNLIMITED = 1.0  # how far an unlimited joint is driven [rad or m]


def differences(client: Client, exported: ClientExport, response: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield the differences between a client's answer and the asset."""
    asset = exported.asset
    yield from silences(client, exported, response)
    if "links" in response:
        yield from _links(client, asset, response["links"])
    if "joints" in response:
        yield from _joints(client, asset, response["joints"])
    if "couplings" in response:
        yield from _couplings(client, asset, response["couplings"])
    if "poses" in response:
        yield from _poses(client, exported, response["poses"])
    if not response.get("finite", True):
        yield _finding(client, "positions become infinite or no number in simulation")
    for name, span in response.get("moved", {}).items():
        yield from _motion(client, asset.joint(name), span)


def _finding(client: Client, message: str, **where: Any) -> Finding:
    return Finding(client.name, message, **where)


def _links(client: Client, asset: Asset, found: Mapping[str, Any]) -> Iterator[Finding]:
    yield from _untold(client, asset, found, "mass")
    relative = client.relative_tolerance
    for name, read in found.items():
        wanted = asset.link(name).mass_properties
        mass = float(read["mass"])
        if not abs(mass - wanted.mass) <= relative * wanted.mass:
            message = f"its mass is {mass:.7g} kg, not {wanted.mass:.7g} kg"
            yield _finding(client, message, link=name, value=mass, unit="kg")
        if "center" in read:
            center = wanted.center - asset.origin(name)
            away = float(np.abs(_array(read["center"], 3) - center).max())
            if not away <= client.length_tolerance:
                message = f"its center of mass is {1e3 * away:.4g} mm away"
                yield _finding(client, message, link=name, value=away, unit="m")
        if "inertia" in read:
            scale = float(np.abs(wanted.inertia).max())
            error = float(np.abs(_array(read["inertia"], 3, 3) - wanted.inertia).max()) / scale
            if not error <= 2.0 * relative:
                yield _finding(
                    client, f"its inertia differs by {100.0 * error:.4g} %", link=name, value=error
                )


def _untold(client: Client, asset: Asset, found: Collection[str], what: str) -> Iterator[Finding]:
    """Yield the links of which a client has to know something: those that a joint moves on its own."""
    for _, child, joints in asset.pairs():
        if child not in found and not joints[-1].locked:
            yield _finding(client, f"it knows no {what} of it", link=child)


def _joints(client: Client, asset: Asset, found: Mapping[str, Any]) -> Iterator[Finding]:
    moving = {joint.name: joint for joint in asset.joints if not joint.locked}
    for name in found:
        if name not in moving:
            yield _finding(client, "it can move, but is no moving joint of the asset", joint=name)
    for name, joint in moving.items():
        if name not in found:
            yield _finding(client, "it knows no such joint that can move", joint=name)
            continue
        read = found[name]
        if read.get("kind", joint.kind) != joint.kind:
            yield _finding(client, f"it is {read['kind']}, not {joint.kind}", joint=name)
        if "limits" in read:
            yield from _limits(client, joint, read["limits"])
        yield from _gains(client, joint, read)


def _limits(client: Client, joint: AssetJoint, found: Any) -> Iterator[Finding]:
    wanted = expected_limits(client.format, joint)
    if found is None or wanted is None:
        same, error = found is None and wanted is None, None
    else:
        error = float(np.abs(_array(found, 2) - wanted).max())
        same = error <= client.length_tolerance * max(1.0, *map(abs, wanted))
    if not same:
        unit = "rad" if joint.kind == "revolute" else "m"
        message = f"its limits are {spelled_limits(found, unit)}, not {spelled_limits(wanted, unit)}"
        yield _finding(client, message, joint=joint.name, value=error, unit=unit)


def _gains(client: Client, joint: AssetJoint, read: Mapping[str, Any]) -> Iterator[Finding]:
    for gain in _GAINS:
        if gain not in read:
            continue
        wanted, found = float(getattr(joint, gain)), float(read[gain])
        if not abs(found - wanted) <= client.relative_tolerance * abs(wanted) + 1e-9:
            yield _finding(
                client, f"its {gain} is {found:.7g}, not {wanted:.7g}", joint=joint.name, value=found
            )
    if "rest" in read and joint.stiffness:
        wanted, found = joint.rest, float(read["rest"])
        if not abs(found - wanted) <= client.length_tolerance * max(1.0, abs(wanted)):
            message = f"its spring rests at {found:.7g}, not {wanted:.7g}"
            yield _finding(client, message, joint=joint.name, value=found)


def _couplings(client: Client, asset: Asset, found: Mapping[str, Any]) -> Iterator[Finding]:
    wanted = {
        joint.name: law
        for joint in asset.joints
        if not joint.locked and (law := coupling(asset, joint)) is not None
    }
    for name in sorted(set(wanted) ^ set(found)):
        message = "it does not follow another joint" if name in wanted else "it follows another joint"
        yield _finding(client, message, joint=name)
    for name in sorted(set(wanted) & set(found)):
        law, (leader, ratio, offset) = wanted[name], found[name]
        same = np.allclose(
            (ratio, offset),
            (law.ratio, law.offset),
            rtol=client.relative_tolerance,
            atol=client.length_tolerance,
        )
        if leader != law.leader or not same:
            message = (
                f"it is {ratio:.7g} * {leader} + {offset:.7g}, "
                f"not {law.ratio:.7g} * {law.leader} + {law.offset:.7g}"
            )
            yield _finding(client, message, joint=name, value=float(ratio))


def _poses(client: Client, exported: ClientExport, found: Any) -> Iterator[Finding]:
    """Yield the links whose frames are elsewhere, each at the pose where it is worst."""
    asset, asked = exported.asset, exported.poses()
    if len(found) != len(asked):
        yield _finding(client, f"it tells {len(found)} poses of {len(asked)}")
    free = {joint.name for joint in asset.free_joints}
    misplaced = moved_by_several(asset) if client.misplaces else frozenset()
    worst: dict[str, tuple[float, dict[str, float]]] = {}
    for positions, frames in zip(asked, found, strict=False):
        q = {name: position for name, position in positions.items() if name in free}
        yield from _untold(client, asset, frames, "frame")
        wanted = expected_frames(asset, q)
        for name, frame in frames.items():
            if name in misplaced:
                continue
            error = float(np.abs(_array(frame, 4, 4) - wanted[name]).max())
            if not error <= worst.get(name, (client.length_tolerance, {}))[0]:
                worst[name] = (error, q)
    for name, (error, q) in worst.items():
        yield _finding(
            client, f"its frame is off by {error:.4g} (m or radians)", link=name, value=error, pose=q
        )


def moved_by_several(asset: Asset) -> frozenset[str]:
    """Return the links with several joints, and their descendants."""
    joints = [joint for joint in asset.joints if not joint.locked]
    found = {name for name, count in Counter(joint.child for joint in joints).items() if count > 1}
    for joint in asset.joints:  # parents come before children
        if joint.parent in found:
            found.add(joint.child)
    return frozenset(found)


def _motion(client: Client, joint: AssetJoint, span: Any) -> Iterator[Finding]:
    least, most = (float(end) for end in span)
    low, high = joint.limits or (-_UNLIMITED, _UNLIMITED)
    if not most - least >= _LEAST_MOTION * (high - low):
        message = f"driven by {joint.effort:g} {_force(joint)} it moves only from {least:.4g} to {most:.4g}"
        yield _finding(client, message, joint=joint.name, value=most - least)
    slack = _SOFT + _MOST_BEYOND * (high - low)
    if joint.limits is not None and not (low - slack <= least and most <= high + slack):
        message = f"it leaves its limits of {low:.4g} to {high:.4g}: it moves from {least:.4g} to {most:.4g}"
        yield _finding(client, message, joint=joint.name, value=max(low - least, most - high))


def _force(joint: AssetJoint) -> str:
    return "N m" if joint.kind == "revolute" else "N"


def _array(value: Any, *shape: int) -> Array:
    """Return numbers of a shape."""
    result = np.array(value, float)
    if result.shape != shape:
        raise ValueError(f"an array of shape {result.shape} stands where one of shape {shape} belongs")
    return result
