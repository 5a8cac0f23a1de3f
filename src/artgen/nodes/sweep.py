"""Sweeps of a profile along a path."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array, successors
from artgen.asset.shape import Contour, Curve, Outline, Shape
from artgen.colliders.triangles import cross
from artgen.graph import FULL, detail_level, records
from artgen.nodes.contours import CREASE, chords, coarse
from artgen.nodes.handles import Path, Profile, Solid
from artgen.nodes.primitive_colliders import around_sweep
from artgen.nodes.surfaces import DeferredSkin, Sheets, Skin, triangulated
from artgen.nodes.unwrap import Rail, cap_uvs, runs_across, wall_uvs

Row = tuple[float, float, float]

_SHARPEST = math.radians(150.0)


class _Stations:
    """Stations of a sweep: one per path vertex, with the frame of the profile's plane."""

    def __init__(self, path: Curve) -> None:
        closed = path.closed
        segments = successors(path.points) - path.points
        if not closed:
            segments = segments[:-1]
        length = np.linalg.norm(segments, axis=1)
        directions = segments / length[:, None]
        arriving = np.concatenate([directions[-1:] if closed else directions[:1], directions])
        leaving = np.concatenate([directions, directions[:1] if closed else directions[-1:]])
        # path vertices, shape (n, 3) [m]; a closed path repeats the first vertex
        self.points = np.concatenate([path.points, path.points[:1]]) if closed else path.points
        self.distance = np.concatenate([[0.0], np.cumsum(length)])
        cosine = np.clip(np.einsum("ij,ij->i", arriving, leaving), -1.0, 1.0)
        turn = _portable.arccos(cosine)
        if turn.max() > _SHARPEST:
            at = int(np.argmax(turn))
            raise ValueError(
                f"the path turns back by {math.degrees(turn[at]):.0f} degrees at {_place(self.points[at])}; "
                "a sweep allows 150; give it a fillet or another point"
            )
        tangents = arriving + leaving
        if path.tangents is not None:
            known = path.tangents
            tangents = np.concatenate([known, known[:1]]) if closed else known
        tangents = tangents / np.linalg.norm(tangents, axis=1, keepdims=True)
        # whether the vertex is a corner, shape (n,)
        self.sharp = turn > CREASE
        # columns x, y and tangent of each plane, shape (n, 3, 3)
        self.frames = _transported(tangents, directions, self.distance, closed)
        self.before = _turns_between(tangents, arriving)
        self.after = _turns_between(tangents, leaving)
        # matrices that widen the profile at corners of the path (mitres), shape (n, 3, 3); before, after:
        # rotations from the plane to the directions of the adjacent segments, shape (n, 3, 3)
        self.stretch = _mitres(arriving, leaving, cosine, path.tangents is not None)


def _place(point: Array) -> str:
    return f"({point[0]:.4g}, {point[1]:.4g}, {point[2]:.4g}) m"


def _mitres(arriving: Array, leaving: Array, cosine: Array, is_curve: bool) -> Array:
    """Return the matrices, shape (n, 3, 3), that widen a section across each corner."""
    stretch = np.broadcast_to(np.eye(3), (len(cosine), 3, 3)).copy()
    if is_curve:  # the path's vertices sample a curve whose plane sections are the profile itself
        return stretch
    bend = leaving - arriving
    size = np.linalg.norm(bend, axis=1)
    bent = size > 1e-9
    across = bend[bent] / size[bent, None]
    widening = 1.0 / np.sqrt((1.0 + cosine[bent]) / 2.0) - 1.0
    stretch[bent] += widening[:, None, None] * across[:, :, None] * across[:, None, :]
    return stretch


def _turns_between(source: Array, target: Array) -> Array:
    """Return the smallest rotations, shape (n, 3, 3), that take unit vectors (n, 3) to others."""
    axis = cross(source, target)
    cosine = np.einsum("ij,ij->i", source, target)
    skew = np.zeros((len(source), 3, 3))
    skew[:, 0, 1], skew[:, 0, 2], skew[:, 1, 2] = -axis[:, 2], axis[:, 1], -axis[:, 0]
    skew -= skew.transpose(0, 2, 1)
    return np.asarray(np.eye(3) + skew + skew @ skew / (1.0 + cosine)[:, None, None])


def _transported(tangents: Array, directions: Array, distance: Array, closed: bool) -> Array:
    """Return frames that follow the tangents without rotation about the path, shape (n, 3, 3)."""
    # y starts upward, or along Y on a vertical path; a closed path spreads the remaining rotation
    start = tangents[0]
    up = np.array([0.0, 0.0, 1.0]) if abs(start[2]) < 0.999 else np.array([0.0, 1.0, 0.0])
    first = up - start * _portable.dot(start, up)
    first /= _portable.norm(first)
    # by way of the directions of the segments, without rotation about them
    course = np.empty((2 * len(tangents) - 1, 3))
    course[0::2], course[1::2] = tangents, directions
    ups = np.array(_carried(first, course)[0::2])
    if closed:
        axis = cross(ups[0], ups[-1])
        missing = math.atan2(_portable.dot(axis, start), _portable.dot(ups[0], ups[-1]))
        angle = -missing * distance / distance[-1]
        side = cross(tangents, ups)
        ups = _portable.cos(angle)[:, None] * ups + _portable.sin(angle)[:, None] * side
        ups[-1] = ups[0]
    return np.stack([cross(ups, tangents), ups, tangents], axis=-1)


def _carried(first: Array, tangents: Array) -> list[Row]:
    """Carry a normal along tangents by the smallest rotations; plain floats, for speed."""
    ax, ay, az = first.tolist()
    rows: list[Row] = [(ax, ay, az)]
    px, py, pz = tangents[0].tolist()
    for qx, qy, qz in tangents[1:].tolist():
        # the rotation from p to q adds -(a.q) / (1 + p.q) (p + q) to a normal a of p
        share = (ax * qx + ay * qy + az * qz) / (1.0 + px * qx + py * qy + pz * qz)
        ax, ay, az = ax - share * (px + qx), ay - share * (py + qy), az - share * (pz + qz)
        size = math.sqrt(ax * ax + ay * ay + az * az)
        ax, ay, az = ax / size, ay / size, az / size
        rows.append((ax, ay, az))
        px, py, pz = qx, qy, qz
    return rows


def _spread(stations: _Stations, plane: Array) -> Array:
    """Return points of the profile's plane at all stations, shape (stations, points, 3)."""
    axes = stations.stretch @ stations.frames[:, :, :2]
    return np.asarray(stations.points[:, None, :] + np.einsum("sij,pj->spi", axes, plane))


def _coarse(path: Curve) -> Curve:
    """Return a path with as few vertices as the level of detail allows."""
    if detail_level() is FULL:
        return path
    ends = np.concatenate([path.points, path.points[:1]]) if path.closed else path.points
    far = int(np.argmax(np.linalg.norm(ends - ends[0], axis=1)))
    off = 0.4 * detail_level().chord
    kept = np.concatenate([chords(ends[: far + 1], off)[:-1], far + chords(ends[far:], off)])
    kept = kept[:-1] if path.closed else kept
    if len(kept) < 3 and path.closed:
        return path
    return Curve(path.points[kept], path.closed, None if path.tangents is None else path.tangents[kept])


def _sweep(profile: Outline, path: Curve) -> Shape:
    profile, path = coarse(profile), _coarse(path)
    stations = _Stations(path)
    for contour in profile.contours:
        rings = _spread(stations, contour.points)
        along = stations.frames[:, :, 2]
        advance = np.einsum("spi,si->sp", np.diff(rings, axis=0), along[:-1] + along[1:])
        if advance.min() <= 0.0:
            at = stations.points[int(np.argmin(advance.min(axis=1)))]
            raise ValueError(
                f"the path bends too tightly for the profile near {_place(at)}: the inside of the bend "
                "folds; use a larger radius or a thinner profile"
            )
    pieces = around_sweep(profile, lambda polygon: list(_spread(stations, polygon)), path.closed)
    return DeferredSkin(lambda: _swept_skin(profile.contours, stations, path.closed)).shape(pieces)


def swept_skin(profile: Outline, path: Curve) -> Skin:
    """Return the surface of a profile along a path that does not bend too tightly for it."""
    return _swept_skin(profile.contours, _Stations(_coarse(path)), path.closed)


@records(_sweep)
def sweep(profile: Profile, path: Path) -> Solid:
    """Sweep a profile along a path; corners of the path are mitred.

    Seen against the direction of travel, the profile's x points right and its y starts as far upward as
    possible (for a path that starts upward: x along X and y along Y). The profile never rotates about the
    path.

    Args:
        profile: The cross-section; the path runs through its origin.
        path: The path; a closed path makes a closed ring.

    Examples:
        >>> bail = polyline([(0, 0, 0), (0, -0.05, 0), (0.2, -0.05, 0), (0.2, 0, 0)], fillet=0.02)
        >>> sweep(rectangle(0.02, 0.01), bail)
    """


def _swept_skin(contours: Sequence[Contour], stations: _Stations, closed: bool) -> Skin:
    count = len(stations.points)
    # a corner of the path has two rows, one for each side of its crease
    doubled = stations.sharp.copy()
    doubled[[0, -1]] = False
    station = np.repeat(np.arange(count), 1 + doubled)
    second = np.concatenate([[False], station[1:] == station[:-1]])
    first_row = np.searchsorted(station, station)
    if closed:
        first_row[-1] = 0
    strips = np.flatnonzero(~second[1:])
    turn = np.where(second[:, None, None], stations.after[station], stations.before[station])
    turn[~stations.sharp[station]] = np.eye(3)
    if closed and stations.sharp[0]:
        turn[0], turn[-1] = stations.after[0], stations.before[0]
    turned = turn @ stations.frames[station]
    axes, ahead = turned[:, :, :2], turned[:, :, 2]
    sheets = Sheets()
    places = []
    for contour in contours:
        rail = Rail.along(contour)
        vertices = _spread(stations, contour.points)[station][:, rail.vertex]
        normals = np.einsum("sij,cj->sci", axes, rail.normals)
        # at a mitre, the outside extends farther along its segment than the path, the inside less far
        beyond = np.einsum("sci,si->sc", vertices - stations.points[station][:, None], ahead)
        uvs = wall_uvs(rail.distance, stations.distance[station][:, None] + beyond, lying=False)
        places.append(sheets.grid(rail, vertices, normals, uvs, strips=strips, places=first_row))
    if not closed:
        rings = [contour.points for contour in contours]
        flat = np.concatenate(rings)
        triangles = triangulated(rings)
        ends = np.concatenate([place[[0, -1]] for place in places], axis=1)
        section = _spread(stations, flat)[[0, -1]]
        tangents = stations.frames[[0, -1], :, 2]
        across = runs_across(np.ptp(flat, axis=0))
        for row, side, faces in ((0, -1.0, triangles[:, ::-1]), (1, 1.0, triangles)):
            uvs = cap_uvs(flat, side, across=across)
            sheets.cap(ends[row], section[row], side * tangents[row], uvs, faces)
    return sheets.skin()
