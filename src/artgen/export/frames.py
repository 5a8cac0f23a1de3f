"""Frames of links and joints for all writers; only this module computes with pivots and origins.

A link's frame has its origin at `asset.origin(link)` and is parallel to the asset's axes when every joint
is at 0. At `asset.positions()`, every joint is as near to 0 as its limits allow. Formats with one joint
between two bodies get an intermediate body after each joint but the last of a pair.
"""

import math
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from itertools import combinations, product

import numpy as np

from artgen._arrays import Array, FrozenArrays
from artgen.asset import Asset, AssetCondition, AssetCoupling, AssetJoint, Link

_REST = np.eye(4)  # copied for each shift, because NumPy takes long to make it

FAR = 1000.0
"""Limit of an unlimited slide in formats that require limits [m]."""

INTERMEDIATE_MASS = 1e-6
"""Mass of a body between two joints [kg]; simulators refuse 0."""

INTERMEDIATE_INERTIA = 1e-9
"""Each principal moment of such a body [kg m^2]; equal moments satisfy the triangle inequality."""


@dataclass(frozen=True, eq=False)
class LinkFrame(FrozenArrays):
    """The frame of a body."""

    name: str  # name of the link, or of a body between two joints
    # origin with every joint at 0, in asset coordinates, shape (3,) [m]; its axes are then the asset's
    origin: Array
    placement: Array  # frame in asset coordinates at `asset.positions()`, shape (4, 4) [m]
    link: Link | None  # None for a body between two joints


@dataclass(frozen=True, eq=False)
class Segment(FrozenArrays):
    """One joint between two frames; the origin of the child frame is the joint's pivot."""

    parent: LinkFrame  # frame of the body nearer to the base
    child: LinkFrame  # frame of the moving body
    joint: AssetJoint  # its axis is the same in asset, parent and child coordinates
    # child frame in the parent's with the joint at 0, or at its position if it is locked, shape (4, 4) [m]
    origin: Array


@dataclass(frozen=True, eq=False)
class BodyJoint(FrozenArrays):
    """A joint in the frame of the body that it moves, for bodies with several joints."""

    joint: AssetJoint
    axis: Array  # unit vector in the body's frame, shape (3,)
    pivot: Array  # point on the axis in the body's frame, shape (3,) [m]
    position: float  # position of the joint in the written placement [rad or m]


@dataclass(frozen=True, eq=False)
class BodyFrame(FrozenArrays):
    """A body with all joints to its parent."""

    link: Link
    parent: str  # name of the parent link; empty for the base
    placement: Array  # frame in the parent's frame at `asset.positions()`, shape (4, 4) [m]
    joints: tuple[BodyJoint, ...]  # joints that can move, the first nearest to the parent


def translation(offset: Array) -> Array:
    """Return the shift by an offset, shape (3,), as a transform, shape (4, 4)."""
    result = _REST.copy()
    result[:3, 3] = offset
    return result


def local(asset: Asset, link: str, matrix: Array) -> Array:
    """Express a transform given in asset coordinates at rest in a link's frame, shape (4, 4)."""
    return translation(-asset.origin(link)) @ matrix


def chain(asset: Asset) -> tuple[Segment, ...]:
    """Return one segment per joint, parents before children, with intermediate frames if needed."""
    taken = {link.name for link in asset.links}
    taken |= {grasp.name for link in asset.links for grasp in link.grasps}
    positions = asset.positions()
    frames = {asset.links[0].name: base_frame(asset)}
    segments = []
    for parent_name, child_name, joints in asset.pairs():
        parent = frames[parent_name]
        displacement = parent.placement @ translation(-parent.origin)
        for joint in joints:
            last = joint is joints[-1]
            name = child_name if last else unused(f"{child_name}_{joint.name}", taken)
            taken.add(name)
            displacement = displacement @ joint.motion(positions[joint.name])
            origin = asset.origin(child_name) if last else joint.pivot
            child = LinkFrame(
                name, origin, displacement @ translation(origin), asset.link(name) if last else None
            )
            fixed = joint.motion(positions[joint.name]) if joint.locked else np.eye(4)
            segments.append(
                Segment(parent, child, joint, translation(-parent.origin) @ fixed @ translation(origin))
            )
            parent = child
        frames[child_name] = parent
    return tuple(segments)


def base_frame(asset: Asset) -> LinkFrame:
    """Return the frame of the base, which is the asset's frame."""
    base = asset.links[0]
    return LinkFrame(base.name, asset.origin(base.name), np.eye(4), base)


def bodies(asset: Asset) -> tuple[BodyFrame, ...]:
    """Return every body, parents before children, for formats that allow several joints per body."""
    positions = asset.positions()
    base = asset.links[0]
    result = [BodyFrame(base, "", np.eye(4), ())]
    for parent, child, joints in asset.pairs():
        origin = asset.origin(child)
        # the motion of later joints at the written positions lies between a joint and the body
        after = np.eye(4)
        seen: list[BodyJoint] = []
        for joint in reversed(joints):
            if not joint.locked:
                axis = after[:3, :3].T @ joint.axis
                pivot = after[:3, :3].T @ (joint.pivot - after[:3, 3]) - origin
                seen.append(BodyJoint(joint, axis, pivot, positions[joint.name]))
            after = joint.motion(positions[joint.name]) @ after
        placement = translation(-asset.origin(parent)) @ after @ translation(origin)
        result.append(BodyFrame(asset.link(child), parent, placement, tuple(reversed(seen))))
    return tuple(result)


def unused(name: str, taken: Collection[str]) -> str:
    """Return a name, with underscores at its end until it is unused."""
    while name in taken:
        name += "_"
    return name


def joint_type(joint: AssetJoint) -> str:
    """Return the type of a joint in URDF."""
    if joint.locked:
        return "fixed"
    return "continuous" if joint.kind == "revolute" and joint.limits is None else joint.kind


def quaternion(matrix: Array) -> Array:
    """Return the rotation of a transform as a unit quaternion (w, x, y, z) with w >= 0, shape (4,)."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = matrix[:3, :3].tolist()
    # four times each product of two components (Shepperd); the row of the largest component is well
    # conditioned
    products = (
        (1.0 + xx + yy + zz, zy - yz, xz - zx, yx - xy),
        (zy - yz, 1.0 + xx - yy - zz, yx + xy, xz + zx),
        (xz - zx, yx + xy, 1.0 - xx + yy - zz, zy + yz),
        (yx - xy, xz + zx, zy + yz, 1.0 - xx - yy + zz),
    )
    diagonal = [round(products[number][number], 9) for number in range(4)]
    row = products[diagonal.index(max(diagonal))]
    length = math.sqrt(sum(component * component for component in row))
    return np.array(row) / (-length if row[0] < 0.0 else length)


def coupling(asset: Asset, joint: AssetJoint) -> AssetCoupling | None:
    """Return the coupling of a joint to the free joint at the head of its chain of leaders, or None."""
    if joint.follows is None:
        return None
    leader = asset.joint(joint.follows.leader)
    above = coupling(asset, leader)
    if above is None:
        return joint.follows
    return above.then(joint.follows.ratio, joint.follows.offset)


def linear_coupling(asset: Asset, joint: AssetJoint) -> AssetCoupling | None:
    """Return the coupling as formats without curves write it.

    It leads to the free joint at the head of the chain of leaders, or to a joint of a closed chain before it;
    joints of closed chains themselves have none.
    """
    if joint.follows is None or joint.follows.curve is not None:
        return None
    above = linear_coupling(asset, asset.joint(joint.follows.leader))
    return joint.follows if above is None else above.then(joint.follows.ratio, joint.follows.offset)


def mass_in_frame(asset: Asset, link: Link) -> tuple[float, Array, Array]:
    """Return a link's mass [kg], center of mass and inertia about it, both in the link's frame.

    Rounding noise is set to 0, so that the written text does not depend on the machine.

    Returns:
        Mass, center of shape (3,) [m] and inertia of shape (3, 3) [kg m^2].
    """
    properties = link.mass_properties
    center = np.round(properties.center - asset.origin(link.name), 12) + 0.0
    inertia = properties.inertia
    real = np.abs(inertia) > 1e-12 * np.trace(inertia)
    return properties.mass, center, np.where(real, inertia, 0.0)


def seen_box(asset: Asset) -> Array:
    """Return the corners of the bounding box of the visible surfaces at rest, shape (2, 3) [m]."""
    boxes = []
    for link, matrix in asset.pose().items():
        for surface in asset.link(link).surfaces:
            points = surface.mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3]
            boxes.append((points.min(axis=0), points.max(axis=0)))
    corners = np.array(boxes)
    return np.round([corners[:, 0].min(axis=0), corners[:, 1].max(axis=0)], 6) + 0.0


BORDER = 1e-9
"""Regions are open; positions this far beyond a border lie on it [rad or m]."""

POINT = 1e-7
"""Intervals up to this width are points with their borders, also those of followers [rad or m]."""

Region = dict[str, tuple[float, float]]
"""A box of joint space: open intervals of free joints; other joints may stand anywhere."""


def leader_of(asset: Asset, joint: AssetJoint) -> tuple[str, float, float]:
    """Return the leading free joint of a joint, with ratio and offset."""
    law = coupling(asset, joint)
    return (joint.name, 1.0, 0.0) if law is None else (law.leader, law.ratio, law.offset)


def apart(asset: Asset) -> list[tuple[str, str]]:
    """Return the pairs of links of an asset that cannot collide.

    Links never collide as long as the dependencies of the asset hold, which contacts enforce, such as that of
    a bolt. So only pairs can collide that are separated by a joint and by another joint on which it depends,
    and pairs with allowed contacts. The other pairs would take most of the simulation time.
    """
    chains: dict[str, frozenset[str]] = {asset.links[0].name: frozenset()}
    bodies = {asset.links[0].name: ""}
    for parent, child, joints in asset.pairs():
        bodies[child] = child if child in asset.loose else bodies[parent]
        chains[child] = chains[parent] | {joint.name for joint in joints if not joint.locked}
    leaders = {joint.name: leader_of(asset, joint)[0] for joint in asset.joints}
    blocks = []
    for joint in asset.joints:
        if joint.needs is not None:
            others = {leaders[name] for name in joint.needs.condition.joints()}
            blocks.append((leaders[joint.name], others))
    by_design = {frozenset(contact.links) for contact in asset.contacts}
    result = []
    for first, second in combinations(chains, 2):
        if bodies[first] != bodies[second]:
            continue  # a free body of a room may be put anywhere
        between = {leaders[name] for name in chains[first] ^ chains[second]}
        held = any(name in between and others & between for name, others in blocks)
        if between and not held and frozenset((first, second)) not in by_design:
            result.append((first, second))
    return result


def regions(asset: Asset, condition: AssetCondition) -> list[Region]:
    """Return boxes whose union is the region of a condition."""
    if condition.kind == "any":
        return [region for term in condition.terms for region in regions(asset, term)]
    if condition.kind == "all":
        parts = product(*(regions(asset, term) for term in condition.terms))
        return [intersection(part) for part in parts]
    joint = asset.joint(condition.joint)
    if joint.locked:
        return [{}] if condition.holds({joint.name: joint.closed}) else []
    name, ratio, offset = leader_of(asset, joint)
    bound = (condition.value - offset) / ratio
    above = (condition.kind == "above") == (ratio > 0.0)
    return [{name: (bound, math.inf) if above else (-math.inf, bound)}]


def intersection(boxes: Iterable[Region]) -> Region:
    """Return the intersection of boxes; an empty interval has swapped ends."""
    result: Region = {}
    for box in boxes:
        for name, (low, high) in box.items():
            before = result.get(name, (-math.inf, math.inf))
            result[name] = (max(low, before[0]), min(high, before[1]))
    return result
