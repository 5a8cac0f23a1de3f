"""Outline of a drawing from the strokes, fills and cuts of a pen."""

import math
from collections.abc import Iterable
from itertools import pairwise

import numpy as np
from manifold3d import CrossSection, FillRule

from artgen._arrays import Array, predecessors
from artgen.asset.shape import Outline
from artgen.nodes.contours import arc_points, outline_of, side_normals, signed_area
from artgen.nodes.details.pen import Mark, steps_of

_SHARP = math.radians(32.0)  # larger turns of a line are corners


def drawing(marks: Iterable[Mark], weight: float, what: str) -> Outline:
    """Return the drawing of marks, in units."""
    region = CrossSection()
    rings: list[Array] = []
    for mark in marks:
        touched = _touched(mark, weight * mark.weight)
        if mark.kind in ("stroke", "fill"):
            rings += touched
            continue
        region += CrossSection(rings, FillRule.Positive)
        rings = []
        region -= CrossSection(touched, FillRule.Positive)
    region += CrossSection(rings, FillRule.Positive)
    return outline_of(region.simplify(0.008), what)


def _touched(mark: Mark, width: float) -> list[Array]:
    """Return the rings of the area of a mark."""
    points = mark.points
    if mark.kind in ("fill", "cut"):
        return [points if signed_area(points) > 0.0 else points[::-1]]
    turn = _turns(points)
    if not mark.closed:
        turn[[0, -1]] = math.inf
    corners = np.flatnonzero(np.abs(turn) > _SHARP)
    if not len(corners):
        return _band(points, width)
    if mark.closed:
        points = np.roll(points, -corners[0], axis=0)
        points = np.concatenate([points, points[:1]])
        corners = np.append(corners - corners[0], len(points) - 1)
    return [_ribbon(points[first : last + 1], width) for first, last in pairwise(corners)]


def _turns(points: Array) -> Array:
    leaving = side_normals(points)
    arriving = predecessors(leaving)
    cross = arriving[:, 0] * leaving[:, 1] - arriving[:, 1] * leaving[:, 0]
    return np.asarray(np.arctan2(cross, np.einsum("ij,ij->i", arriving, leaving)))


def _across(arriving: Array, leaving: Array) -> Array:
    """Return the displacement of each vertex to the right if both its sides move by one unit."""
    scale = 1.0 + np.einsum("ij,ij->i", arriving, leaving)
    return np.asarray((arriving + leaving) / scale[:, None])


def _band(points: Array, width: float) -> list[Array]:
    """Return the two borders of a stroke along a closed smooth line."""
    if signed_area(points) < 0.0:
        points = points[::-1]
    normals = side_normals(points)
    outward = _across(predecessors(normals), normals) * (width / 2.0)
    return [points + outward, (points - outward)[::-1]]


def _ribbon(points: Array, width: float) -> Array:
    """Return the border of a stroke with round ends along a smooth open line."""
    normals = side_normals(points)[:-1]
    half = width / 2.0
    right = _across(np.concatenate([normals[:1], normals]), np.concatenate([normals, normals[-1:]])) * half
    steps = max(4, steps_of(half, math.pi))
    ends = []
    for place, normal in ((points[-1], normals[-1]), (points[0], -normals[0])):
        start = math.atan2(normal[1], normal[0])
        ends.append(arc_points(place, half, start, math.pi, steps)[0][1:-1])
    return np.concatenate([points + right, ends[0], (points - right)[::-1], ends[1]])
