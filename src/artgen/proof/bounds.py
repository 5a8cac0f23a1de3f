"""Closed-form bounds on the distance of convex pieces while joints move through intervals.

Everything is batched: N items, each with V vertices, joints of one kind per step and an interval `center -
half .. center + half` for each joint. The path from link A to link B is a product of joint motions in asset
coordinates at rest, `E_1(q_1) ... E_m(q_m)`, which takes B's points into A's frame; a joint that is crossed
against its direction has a reversed axis. Frame k lies behind the first k joints.

The gap along a unit normal in frame k is exact in the joints next to frame k (their support is maximised in
closed form) and over-estimated to second order in the others, whose arcs are replaced by the polygon of their
ends and the crossing of their tangents. A bound above zero therefore proves that the pieces stay apart.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from artgen import _portable
from artgen._arrays import Array, Indices
from artgen.asset.joint import JointKind
from artgen.colliders.triangles import cross

WIDEST = 1.2  # half interval up to which the ends and the crossing of the tangents enclose an arc [rad]
_OCTAGON = 8


@dataclass(frozen=True, eq=False)
class Motion:
    """One joint of a path and its interval, for each of N items."""

    kind: JointKind  # `revolute` or `prismatic`
    origin: Array  # a point on the axis, shape (N, 3) [m]
    axis: Array  # unit axis, shape (N, 3)
    center: Array  # middle of the interval, shape (N,) [rad or m]
    half: Array  # half the length of the interval, not negative, shape (N,) [rad or m]

    def __getitem__(self, rows: Indices) -> "Motion":
        origin, axis = self.origin[rows], self.axis[rows]
        return Motion(self.kind, origin, axis, self.center[rows], self.half[rows])

    def reversed(self) -> "Motion":
        """Return the motion seen from the other side."""
        return Motion(self.kind, self.origin, -self.axis, self.center, self.half)


def _across(axis: Array, vectors: Array) -> tuple[Array, Array, Array]:
    """Return the parts of vectors along and across a unit axis, and their cross products with the axis."""
    along = np.matmul(vectors, axis[:, :, None]) * axis[:, None, :]
    return along, vectors - along, cross(axis[:, None, :], vectors)


def enclosing_points(motion: Motion, points: Array) -> Array:
    """Return points whose convex hull contains points, shape (N, V, 3) [m], throughout the motion.

    Their shape is (N, 2 V, 3) for a slide and (N, 3 V, 3) for a rotation; (N, 8 V, 3) for a half interval
    above `WIDEST`, whose tangents do not cross on the outside; and (N, V, 3) if no item moves, as in a room,
    where locked joints hold the assets.
    """
    half, still = motion.half[:, None, None], not motion.half.any()
    if motion.kind == "prismatic":
        middle = points + (motion.center[:, None] * motion.axis)[:, None, :]
        step = half * motion.axis[:, None, :]
        return middle if still else np.concatenate((middle - step, middle + step), axis=1)
    center, half = motion.center[:, None], motion.half[:, None]
    angles, scales = center, np.ones_like(center)
    if not still:
        # the ends of the arc, and the crossing of its tangents
        wide = half > WIDEST
        angles = np.concatenate((center - half, center + half, center), axis=1)
        crossing = 1.0 / np.where(wide, 1.0, _portable.cos(half))
        scales = np.concatenate((scales, scales, crossing), axis=1)
        if wide.any():  # each item separately
            turns = np.arange(_OCTAGON) * (2.0 * np.pi / _OCTAGON)
            rest = np.minimum(np.arange(_OCTAGON), 2)
            angles = np.where(wide, center + turns, angles[:, rest])
            scales = np.where(wide, 1.0 / _portable.cos(np.pi / _OCTAGON), scales[:, rest])
    cosine, sine = (scales[..., None, None] * each[..., None, None] for each in _portable.cos_sin(angles))
    along, arm, across = _across(motion.axis, np.broadcast_to(np.eye(3), (len(half), 3, 3)))
    turned = along[:, None] + cosine * arm[:, None] + sine * across[:, None]
    rows, origin = np.moveaxis(turned, 1, 2).reshape(len(half), 3, -1), motion.origin[:, None, :]
    return np.asarray(np.matmul(points - origin, rows).reshape(len(points), -1, 3) + origin)


def growth(motion: Motion) -> int:
    """Return the number by which `enclosing_points` multiplies the points."""
    if motion.kind == "prismatic":
        return 2
    return _OCTAGON if bool((motion.half > WIDEST).any()) else 3


def support(motion: Motion, points: Array, normals: Array) -> Array:
    """Return the exact largest `normal . x` over points and over the whole motion, shape (N, C) [m].

    The points have shape (N, V, 3) [m], the normals (N, C, 3).
    """
    if motion.kind == "prismatic":
        along = np.matmul(normals, motion.axis[:, :, None])[:, :, 0]
        moved = along * motion.center[:, None] + np.abs(along) * motion.half[:, None]
        return np.asarray(np.matmul(normals, points.transpose(0, 2, 1)).max(axis=2) + moved)
    cosine, sine = _portable.cos_sin(motion.center[:, None, None])
    along, arm, across = _across(motion.axis, normals)
    # the normals turn against the motion; of the last part, only the size counts
    turned = along, cosine * arm - sine * across, cosine * across + sine * arm
    relative = points - motion.origin[:, None, :]
    reached = np.matmul(np.concatenate(turned, axis=1), relative.transpose(0, 2, 1))
    level, towards, sideways = np.split(reached, 3, axis=1)
    level += np.matmul(normals, motion.origin[:, :, None])
    np.abs(sideways, out=sideways)
    half = motion.half[:, None, None]
    cosine, sine = _portable.cos_sin(half)
    # the circle `towards cos t + sideways sin t` has its maximum at an end of the interval or within it
    end, slope = towards * cosine + sideways * sine, sideways * cosine - towards * sine
    within = (slope < 0.0) | (half >= np.pi)
    swing = np.where(within, np.sqrt(end * end + slope * slope), end)
    return np.asarray((level + swing).max(axis=2))


def gap(first: Array, second: Array, path: Sequence[Motion], frame: int, normals: Array) -> Array:
    """Return a lower bound of the gap between two pieces along normals, over all joint positions.

    Args:
        first: Vertices of the pieces on link A at rest, shape (N, V, 3) [m].
        second: Vertices of the pieces on link B at rest, shape (N, W, 3) [m].
        path: The joints from A to B.
        frame: Number of joints between A and the frame of the normals.
        normals: Directions from A to B, shape (N, C, 3).

    Returns:
        A lower bound of `min normal . b - max normal . a`, shape (N, C) [m].
    """
    for motion in path[: max(frame - 1, 0)]:
        first = enclosing_points(motion.reversed(), first)
    for motion in path[:frame:-1]:
        second = enclosing_points(motion, second)
    if frame == 0:
        highest = np.matmul(normals, first.transpose(0, 2, 1)).max(axis=2)
    else:
        highest = support(path[frame - 1].reversed(), first, normals)
    if frame == len(path):
        lowest = np.matmul(normals, second.transpose(0, 2, 1)).min(axis=2)
    else:
        lowest = -support(path[frame], second, -normals)
    return np.asarray(lowest - highest)


def around_axis(points: Array, origin: Array, axis: Array) -> Array:
    """Return heights and distances of convex pieces about an axis, which rotation about it does not change.

    The vertices have shape (N, V, 3); the axis is a unit vector through `origin`. The columns of the result,
    shape (N, 4), are the lowest and highest coordinate along the axis, the smallest distance from the axis
    (never above it, below it only by rounding) and the largest one [m].
    """
    axis = np.broadcast_to(axis, (len(points), 3))
    relative = points - origin
    height = np.matmul(relative, axis[:, :, None])[:, :, 0]
    arm = relative - height[:, :, None] * axis[:, None, :]
    radius = np.sqrt(np.sum(arm * arm, axis=2))
    return np.column_stack((height.min(axis=1), height.max(axis=1), _nearest(arm), radius.max(axis=1)))


def _nearest(arm: Array) -> Array:
    """Return the distance of convex pieces from an axis, less at most rounding."""
    # Gilbert, Johnson and Keerthi 1988: the smallest projection on a direction is a lower bound
    rows = np.arange(len(arm))
    point = arm[rows, np.sum(arm * arm, axis=2).argmin(axis=1)]
    ends = np.stack((point, point), axis=1)  # (N, 2, 3)
    best, distance, nearer = np.zeros(len(arm)), np.full(len(arm), np.inf), np.ones(len(arm), np.bool_)
    while nearer.any():
        length = np.sqrt(np.sum(point * point, axis=1))
        nearer = length < distance
        distance = np.minimum(distance, length)
        direction = point / np.where(length > 1e-12, length, np.inf)[:, None]
        projected = np.matmul(arm, direction[:, :, None])[:, :, 0]
        foot = projected.argmin(axis=1)
        best = np.maximum(best, projected[rows, foot])
        corner = arm[rows, foot][:, None]
        side = ends - corner
        square = np.sum(side * side, axis=2, keepdims=True)
        share = -np.sum(side * corner, axis=2, keepdims=True) / np.where(square > 0.0, square, 1.0)
        points = corner + np.clip(share, 0.0, 1.0) * side
        chosen = np.sum(points * points, axis=2).argmin(axis=1)
        point = points[rows, chosen]
        ends = np.stack((corner[:, 0], ends[rows, chosen]), axis=1)
    return best


def axis_gap(first: Array, second: Array, shift: Array, half: Array) -> Array:
    """Return a lower bound of the gap between pieces that rotate about one axis and slide along it [m].

    The pieces on link A and link B are described by results of `around_axis`, shape (N, 4). Link B slides
    along the axis by an interval with the center `shift` and half the length `half`, shape (N,) [m].
    """
    gaps = (
        first[:, 2] - second[:, 3],
        second[:, 2] - first[:, 3],
        first[:, 0] - second[:, 1] - shift - half,
        second[:, 0] + shift - half - first[:, 1],
    )
    return np.asarray(np.max(gaps, axis=0))
