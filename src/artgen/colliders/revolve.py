"""Convex pieces of revolved solids."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from artgen import _portable
from artgen._arrays import Array, successors
from artgen.colliders.convex import TOLERANCE, Convex
from artgen.colliders.pieces import Cover, Pieces
from artgen.colliders.polygon import convex_hull, signed_area
from artgen.colliders.polytope import SLIVER, SNAP

_IDENTITY = np.eye(4)
_EXACT = 1e-9  # tolerance of parts that must lie inside the solid [m]
_FAR = 0.001  # least limit of the distance of pieces towards the axis [m]
_LEVEL = 1e-9  # slope above which a side of a profile faces the axis, or away from it
_WIDEST = np.pi / 2.0  # largest angle of a hollow sector [rad]

Span = tuple[float, float]
Slab = tuple[Span, Span, Span]  # z, then r at the lower and at the upper end


def revolve_pieces(
    contours: Sequence[Array], angle: float = 2.0 * np.pi, mesh_segments: int = 32, pose: Array = _IDENTITY
) -> Pieces:
    """Return the cover of a profile revolved about z.

    The mesh has its vertices at `r (cos a, sin a)` for `mesh_segments` equal steps of a from 0.

    Args:
        contours: Profile in (r, z), r >= 0: outer borders counter-clockwise, holes clockwise, each
            shape (n, 2) [m].
        angle: Angle of the revolution, 0 to 2 pi [rad].
        mesh_segments: Number of facets of the mesh around the axis.
        pose: Rigid transform, shape (4, 4).

    Raises:
        ValueError: The profile is empty, not finite or crosses the axis, or the angle is out of range.
    """
    loops = [np.asarray(contour, np.float64) for contour in contours]
    if not loops or not all(np.isfinite(loop).all() for loop in loops):
        raise ValueError("a turned profile needs finite contours")
    least = min(float(loop[:, 0].min()) for loop in loops)
    if least < -SNAP:
        raise ValueError(f"a turned profile must not cross the axis, it reaches r = {least} m")
    if not 0.0 < angle <= 2.0 * np.pi + 1e-9 or mesh_segments < 3:
        raise ValueError(
            f"a turn needs an angle within 0 and 2 pi and at least 3 segments, "
            f"got {angle} rad and {mesh_segments} segments"
        )
    lathe = _Lathe(loops, min(angle, 2.0 * np.pi), mesh_segments, pose)
    return Pieces(lathe.outer, lathe.inner)


class _Lathe:
    """A revolved profile."""

    def __init__(self, loops: list[Array], angle: float, segments: int, pose: Array) -> None:
        self._slabs = _slabs(loops)
        self._full = angle >= 2.0 * np.pi - 1e-9
        self._angle = angle
        self._segments = segments
        self._angles: Array = np.linspace(0.0, angle, segments + 1)
        self._pose = np.asarray(pose, np.float64)

    def outer(self, tolerance: float) -> Cover:
        """Return pieces that contain the mesh; profile and chords share 1 mm, or a larger tolerance."""
        shares = (tolerance, tolerance / 2.0, TOLERANCE) if 2.0 * tolerance > _FAR else (tolerance,)
        return min((self._outer(share, tolerance) for share in shares), key=len)

    def _outer(self, inward: float, tolerance: float) -> Cover:
        return tuple(
            piece
            for part, bulge in _profile_parts(self._slabs, inward, tolerance)
            for piece in self._turned(part, min(tolerance, max(tolerance, _FAR) - bulge))
        )

    def inner(self, tolerance: float) -> Cover:
        """Return pieces inside the mesh."""
        pieces: list[Convex] = []
        for part, _ in _profile_parts(self._slabs, _EXACT, _EXACT):
            if self._full and _is_solid(part):
                step = self._step(float(part[:, 0].max()), tolerance)
                pieces.append(self._hull(part, self._angles[:-1:step]))
            elif _is_solid(part) and self._angle <= np.pi:
                pieces.append(self._hull(part, self._angles))
            else:
                pieces.extend(
                    self._hull(part, self._angles[index : index + 2]) for index in range(self._segments)
                )
        return tuple(pieces)

    def _turned(self, part: Array, tolerance: float) -> list[Convex]:
        """Return pieces around a revolved convex part of the profile."""
        solid = _is_solid(part)
        if solid and self._full:
            return [self._cylinder(part) or self._hull(part, self._angles[:-1])]
        if solid and self._angle <= np.pi:
            return [self._hull(part, self._angles)]
        bore = 0.0 if solid else _bore_radius(part)
        step = self._step(bore, tolerance)
        count = -(-self._segments // step)
        ends = np.rint(np.arange(count + 1) * (self._segments / count)).astype(np.int64).tolist()
        return [self._hull(part, self._angles[here : there + 1]) for here, there in pairwise(ends)]

    def _step(self, radius: float, tolerance: float) -> int:
        """Return the number of facets that a chord at a radius may replace."""
        half = self._angle / self._segments / 2.0
        step = 1
        while (step + 1) * 2.0 * half <= _WIDEST and radius * (
            1.0 - _portable.cos((step + 1) * half)
        ) <= tolerance:
            step += 1
        if not self._full:
            return step
        return max(divisor for divisor in range(1, step + 1) if self._segments % divisor == 0)

    def _hull(self, part: Array, angles: Array) -> Convex:
        turn = np.column_stack((_portable.cos(angles), _portable.sin(angles)))
        points = np.empty((len(angles), len(part), 3))
        points[..., :2] = turn[:, None, :] * part[None, :, :1]
        points[..., 2] = part[:, 1]
        return Convex.hull(points.reshape(-1, 3) @ self._pose[:3, :3].T + self._pose[:3, 3])

    def _cylinder(self, part: Array) -> Convex | None:
        """Return a part as a cylinder if possible."""
        radius = float(part[:, 0].max())
        bottom, top = float(part[:, 1].min()), float(part[:, 1].max())
        area = radius * (top - bottom)
        if len(part) != 4 or abs(signed_area(part) - area) > 1e-9 * area:
            return None
        pose = self._pose.copy()
        pose[:3, 3] += pose[:3, 2] * (bottom + top) / 2.0
        return Convex.cylinder(radius, top - bottom, pose)


def _is_solid(part: Array) -> bool:
    """Tell whether the full revolution of a convex part is convex."""
    if part[:, 0].min() > SNAP:
        return False
    both = convex_hull(np.concatenate((part, part * (-1.0, 1.0))))
    area = signed_area(part)
    return abs(signed_area(both) - 2.0 * area) <= 1e-9 * area


def _bore_radius(part: Array) -> float:
    """Return the largest radius of the side of a convex part that faces the axis [m]."""
    low, high = part[:, 1].min(), part[:, 1].max()
    ends = [float(part[np.abs(part[:, 1] - level) <= SNAP, 0].min()) for level in (low, high)]
    return max(ends)


def _slabs(loops: Sequence[Array]) -> list[list[Slab]]:
    """Cut a profile at the heights of its vertices into trapezoids of each slab, from the axis outward."""
    edges = [(loop[i - 1], loop[i]) for loop in loops for i in range(len(loop))]
    levels: list[float] = []
    for level in sorted({float(z) for loop in loops for z in loop[:, 1]}):
        if not levels or level - levels[-1] > SNAP:
            levels.append(level)
    slabs: list[list[Slab]] = []
    for bottom, top in pairwise(levels):
        middle = (bottom + top) / 2.0
        crossing: list[tuple[float, float, float]] = []
        for one, two in edges:
            if (one[1] - middle) * (two[1] - middle) < 0.0:
                slope = (two[0] - one[0]) / (two[1] - one[1])
                at = [max(float(one[0] + slope * (z - one[1])), 0.0) for z in (middle, bottom, top)]
                crossing.append((at[0], at[1], at[2]))
        crossing.sort()
        slabs.append(
            [
                ((bottom, top), (left[1], right[1]), (left[2], right[2]))
                for left, right in zip(crossing[0::2], crossing[1::2], strict=True)
            ]
        )
    return slabs


def _profile_parts(
    slabs: Sequence[Sequence[Slab]], inward: float, outward: float
) -> list[tuple[Array, float]]:
    """Join stacked trapezoids while their hull exceeds them by little; return how far it does inward [m]."""
    stacks: list[list[Slab]] = []
    growing: list[list[Slab]] = []
    for slab in slabs:
        fresh: list[list[Slab]] = []
        for trapezoid in slab:
            below = next((stack for stack in growing if _continues(stack[-1], trapezoid)), None)
            if below is not None and (_bulges([*below, trapezoid]) <= (inward, outward)).all():
                below.append(trapezoid)
            else:
                below = [trapezoid]
                stacks.append(below)
            fresh.append(below)
        growing = fresh
    parts = [(convex_hull(_corners(stack)), float(_bulges(stack)[0])) for stack in stacks]
    return [each for each in parts if len(each[0]) >= 3 and np.ptp(each[0], axis=0).min() > SLIVER]


def _continues(below: Slab, above: Slab) -> bool:
    """Tell whether a trapezoid covers the whole upper end of another one."""
    return (
        abs(below[0][1] - above[0][0]) <= SNAP
        and abs(below[2][0] - above[1][0]) <= SNAP
        and abs(below[2][1] - above[1][1]) <= SNAP
    )


def _bulges(stack: Sequence[Slab]) -> Array:
    """Return how far the hull of stacked trapezoids exceeds them inward and outward, shape (2,) [m]."""
    # sides are compared in one direction: a thin wall is near to all sides of the hull, even across a hollow
    hollow = any(radius > SNAP for _, *ends in stack for radius, _ in ends)
    corners = _corners(stack)
    hull = convex_hull(corners if hollow else np.concatenate((corners, corners * (-1.0, 1.0))))
    outer = corners[1::2]
    if not hollow:
        outer = outer[outer[:, 0] > SNAP]
        return np.array((0.0, _stands_off(hull, outer, 1.0) if len(outer) else 0.0))
    inner = corners[0::2]
    return np.array((_stands_off(hull, inner, -1.0), _stands_off(hull, outer, 1.0)))


def _stands_off(hull: Array, chain: Array, facing: float) -> float:
    """Return the distance of a convex polygon's sides in one direction of r from points inside [m]."""
    sides = successors(hull) - hull
    normals = np.column_stack((sides[:, 1], -sides[:, 0])) / np.hypot(sides[:, 0], sides[:, 1])[:, None]
    towards = normals[:, 0] * facing > _LEVEL
    normals, hull = normals[towards], hull[towards]
    away = np.sum(normals * hull, axis=1) - _portable.product(chain, normals.T)
    across = np.argmin(away / np.abs(normals[:, 0]), axis=1)  # side at the height of the point
    return float(away[np.arange(len(chain)), across].max())


def _corners(stack: Sequence[Slab]) -> Array:
    """Return the corners of stacked trapezoids, shape (n, 2) [m]."""
    return np.array(
        [(r, z) for heights, *ends in stack for z, end in zip(heights, ends, strict=True) for r in end]
    )
