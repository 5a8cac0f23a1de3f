"""Overlays of viewers: colliders, symbols of joints, and colors of labels.

All overlays are in asset coordinates at rest [m]. A viewer moves those of a link by `asset.pose(q)[link]`,
and those of a joint by `axis_poses(asset, q)[joint]`.
"""

import math
import zlib
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset import Asset, AssetJoint, rotation
from artgen.colliders import Convex
from artgen.view.camera import box_corners

Rgb = tuple[float, ...]
"""A color in sRGB: red, green and blue from 0 to 1."""

_FACETS = 0.001  # largest distance of facets from round colliders [m]
_MARGIN = 0.06  # share of a link's size by which the axis of its joint extends beyond both ends
_SHORTEST = 0.02  # least length of an axis or arm, and of a slide without limits [m]
_STEP = math.radians(5.0)  # angle between the points of an arc
_ON_AXIS = 1e-6  # points nearer to an axis have no direction from it [m]

# colors of Okabe and Ito, which people with any color vision can distinguish, with grey instead of black;
# then darker, lighter and intermediate versions for categories with many labels
_HUES: tuple[Rgb, ...] = (
    (0.902, 0.624, 0.000), (0.337, 0.706, 0.914), (0.000, 0.620, 0.451), (0.941, 0.894, 0.259),
    (0.000, 0.447, 0.698), (0.835, 0.369, 0.000), (0.800, 0.475, 0.655), (0.600, 0.600, 0.600),
)  # fmt: skip
_SHADES = ((0.0, 1.0), (0.0, 0.55), (1.0, 0.45), (0.0, 0.78))  # grey, and the remaining share of the color
PALETTE: tuple[Rgb, ...] = tuple(
    tuple(round(keep * part + (1.0 - keep) * grey, 4) for part in hue)
    for grey, keep in _SHADES
    for hue in _HUES
)
"""Colors of labels, the most distinct first."""


@dataclass(frozen=True, eq=False)
class JointSymbol:
    """Axis, range and hand of a joint.

    `axis` and `range` stay with the joint (`axis_poses`); `hand` moves like the hand of a clock, by
    `axis_poses(asset, q)[joint] @ asset.joint(joint).motion(position)`: its end then lies on `range`.
    """

    axis: Array  # ends of a segment on the axis, in its direction, shape (2, 3) [m]
    # path of the end of `hand`, from the lowest position to the highest: an arc, or the two ends of a line; a
    # full circle for an unlimited rotation, shape (k, 3) [m]
    range: Array
    hand: Array  # segment from the axis to the path at position 0, shape (2, 3) [m]


def axis_poses(asset: Asset, q: Mapping[str, float] | None = None) -> dict[str, Array]:
    """Return the displacement of the axis of each joint from rest, shape (4, 4).

    Of several joints between two links, each is moved by those before it.
    """
    positions, poses, result = asset.positions(q), asset.pose(q), {}
    for parent, _, joints in asset.pairs():
        transform = poses[parent]
        for joint in joints:
            result[joint.name] = transform
            transform = transform @ joint.motion(positions[joint.name])
    return result


def label_colors(asset: Asset) -> dict[str, Rgb]:
    """Return a color for each label, equal in all assets of a category, and usually in others.

    The first labels that a category names have the most distinct colors.
    """
    used = {label for link in asset.links for label in link.labels}
    used |= {surface.label for link in asset.links for surface in link.surfaces}
    labels = [*asset.labels, *sorted(used.difference(asset.labels))]
    result: dict[str, Rgb] = {}
    for number, label in enumerate(dict.fromkeys(labels)):
        if number % len(_HUES) == 0:
            free = list(range(len(_HUES)))  # colors of a shade are assigned one after another
        first = zlib.crc32(label.encode()) % len(_HUES)
        hue = min(free, key=lambda index: (index - first) % len(_HUES))
        free.remove(hue)
        result[label] = PALETTE[(number - number % len(_HUES) + hue) % len(PALETTE)]
    return result


def collider_mesh(convex: Convex) -> tuple[Array, Indices]:
    """Return a collider as triangles, counter-clockwise seen from outside: vertices (n, 3) [m] and (m, 3)."""
    mesh = convex.manifold(_FACETS).to_mesh64()
    return np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts).astype(np.int64)


def joint_symbol(asset: Asset, joint: AssetJoint) -> JointSymbol:
    """Return the symbol of a joint."""
    bounds = asset.link(joint.child).bounds()
    corners, middle = box_corners(bounds, np.eye(4)), bounds.mean(axis=0)
    if joint.kind == "revolute":
        along = (corners - joint.pivot) @ joint.axis
        foot = joint.pivot + joint.axis * (along.min() + along.max()) / 2.0
    else:
        along = (corners - middle) @ joint.axis
        foot = middle
    half = max((along.max() - along.min()) * (0.5 + _MARGIN), _SHORTEST / 2.0)
    if joint.kind == "revolute":
        hand, path = _turn(joint, foot, corners)
    else:
        first, last = joint.limits or (-half, half)
        hand = np.array([foot, foot])  # a point
        path = np.array([foot + first * joint.axis, foot + last * joint.axis])
    return JointSymbol(np.array([foot - half * joint.axis, foot + half * joint.axis]), path, hand)


def _turn(joint: AssetJoint, foot: Array, corners: Array) -> tuple[Array, Array]:
    """Return the hand of a revolute joint, to the farthest of several corners, and the arc of its end."""
    across = [offset - (offset @ joint.axis) * joint.axis for offset in corners - foot]
    arm = max(across, key=lambda offset: round(float(np.linalg.norm(offset)), 9))
    # a part that rotates about its own center has corners all around: any of them is suitable
    length = float(np.linalg.norm(arm))
    if length < _ON_AXIS:
        arm = np.cross(joint.axis, np.eye(3)[np.argmin(np.abs(joint.axis))])
        length = float(np.linalg.norm(arm))
        arm = arm / length * _SHORTEST
    elif length < _SHORTEST:
        arm = arm / length * _SHORTEST
    first, last = joint.limits or (-math.pi, math.pi)
    angles = np.linspace(first, last, max(2, math.ceil((last - first) / _STEP) + 1))
    path = np.array([foot + rotation(joint.axis, float(angle)) @ arm for angle in angles])
    return np.array([foot, foot + arm]), path
