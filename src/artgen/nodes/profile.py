"""Profiles: regions of the plane, x to the right and y up, for extrusions, lathes and sweeps.

Profiles are centered on the origin unless stated otherwise. `a | b`, `a - b` and `a & b` combine them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import compress
from typing import Literal

import numpy as np
from manifold3d import CrossSection, JoinType

from artgen import _portable
from artgen._arrays import Mask, successors
from artgen.asset.shape import Contour, Curve, Outline
from artgen.graph import kernel, records
from artgen.nodes import validators as check
from artgen.nodes.contours import (
    arc_points,
    circle_contour,
    ellipse_contour,
    faceted,
    is_disjoint,
    moved_outline,
    outline_of,
    reversed_contour,
    rounded_polygon,
    section,
    signed_area,
    without_repeats,
)
from artgen.nodes.handles import Profile, Scalar
from artgen.nodes.surfaces import arc_steps, hole_radius, sides_of


def _convex(contour: Contour) -> Outline:
    return Outline((contour,), (contour.points,))


def _rectangle(width: float, height: float, radius: float) -> Outline:
    check.positive("width", width)
    check.positive("height", height)
    radius = check.rounding("radius", radius, min(width, height) / 2.0)
    x, y = width / 2.0, height / 2.0
    corners = np.array([[-x, -y], [x, -y], [x, y], [-x, y]])
    return _convex(rounded_polygon(corners, [radius] * 4) if radius > 0.0 else faceted(corners))


@records(_rectangle)
def rectangle(width: Scalar, height: Scalar, *, radius: Scalar = 0.0) -> Profile:
    """Make a rectangle centered on the origin.

    Args:
        width: Length along x [m].
        height: Length along y [m].
        radius: Radius of the corners [m], at most half the shorter side.

    Examples:
        >>> rectangle(0.3, 0.2, radius=0.03)
    """


def _circle(radius: float) -> Outline:
    return _convex(circle_contour(check.positive("radius", radius)))


@records(_circle)
def circle(radius: Scalar) -> Profile:
    """Make a circle [m] about the origin.

    Examples:
        >>> circle(0.1)
    """


def _ellipse(radius_x: float, radius_y: float) -> Outline:
    check.positive("radius x", radius_x)
    check.positive("radius y", radius_y)
    return _convex(ellipse_contour(radius_x, radius_y))


@records(_ellipse)
def ellipse(radius_x: Scalar, radius_y: Scalar) -> Profile:
    """Make an ellipse about the origin.

    Args:
        radius_x: Half of the width [m].
        radius_y: Half of the height [m].

    Examples:
        >>> ellipse(0.15, 0.08)
    """


def _polygon(points: tuple[tuple[float, float], ...], radius: float) -> Outline:
    corners = check.points("the polygon", points or np.zeros((0, 2)), 2, 3)
    radius = check.rounding("radius", radius, math.inf)
    following = successors(corners)
    short = np.linalg.norm(following - corners, axis=1) < 1e-7
    if short.any():
        at = int(np.flatnonzero(short)[0])
        raise ValueError(f"points {at} and {(at + 1) % len(corners)} of the polygon are the same point")
    area = signed_area(corners)
    if np.linalg.svd(corners - corners.mean(axis=0), compute_uv=False)[1] < 1e-9:
        raise ValueError("the polygon has no area; its points lie on one line")
    if area < 0.0:
        corners = np.ascontiguousarray(corners[::-1])
    if abs(area) < 1e-12 or not is_disjoint([corners]):
        raise ValueError("the polygon crosses itself; give its points in order around it")
    contour = rounded_polygon(corners, [radius] * len(corners)) if radius > 0.0 else faceted(corners)
    sides = successors(corners) - corners
    after = successors(sides)
    is_convex = bool((sides[:, 0] * after[:, 1] - sides[:, 1] * after[:, 0] >= 0.0).all())
    return Outline((contour,), (contour.points,) if is_convex else None)


@kernel(spelling="{path}.profile()")
def _enclosed_by(path: Curve) -> Outline:
    if not path.closed:
        raise ValueError("the path of a profile is open; make it with closed=True")
    off = np.abs(path.points[:, 2])
    if off.max() > 1e-9:
        raise ValueError(
            f"the path of a profile must lie in the plane z = 0; point {int(off.argmax())} is "
            f"{off.max():.4g} m off it"
        )
    points = np.ascontiguousarray(path.points[:, :2])
    area = signed_area(points)
    if not is_disjoint([points if area > 0.0 else points[::-1]]):
        raise ValueError("the path of a profile crosses itself; give its points in order around it")
    if path.tangents is None or np.any(np.abs(path.tangents[:, 2]) > 1e-6):
        contour = faceted(points)
    else:
        normals = np.column_stack([path.tangents[:, 1], -path.tangents[:, 0]])
        contour = Contour(points, normals, normals)
    return Outline((contour if area > 0.0 else _turned(contour),))


def _turned(contour: Contour) -> Contour:
    """Return a contour in the other direction, with the same outside."""
    return Contour(contour.points[::-1], -contour.normals_out[::-1], -contour.normals_in[::-1])


@records(_polygon)
def polygon(points: Sequence[tuple[Scalar, Scalar]], *, radius: Scalar = 0.0) -> Profile:
    """Make a polygon from its corners in order, in either direction.

    Args:
        points: Corners (x, y) [m].
        radius: Radius to which every corner is rounded [m].

    Examples:
        >>> polygon([(0, 0), (0.3, 0), (0.3, 0.08), (0.08, 0.08), (0.08, 0.2), (0, 0.2)], radius=0.01)
    """


def _regular_polygon(sides: int, radius: float) -> Outline:
    if sides < 3:
        raise ValueError(f"a regular polygon has at least 3 sides, got {sides}")
    check.positive("radius", radius)
    angle = math.pi * (1.5 + (2.0 * np.arange(sides) + 1.0) / sides)
    return _convex(faceted(radius * np.column_stack([_portable.cos(angle), _portable.sin(angle)])))


@records(_regular_polygon)
def regular_polygon(sides: int, radius: Scalar) -> Profile:
    """Make a regular polygon about the origin, one side at the bottom.

    Args:
        sides: Number of sides.
        radius: Distance of the corners from the origin [m].

    Examples:
        >>> regular_polygon(6, 0.1)
    """


def _slot(length: float, width: float) -> Outline:
    check.positive("width", width)
    check.between("length", length, width, math.inf)
    half, radius = (length - width) / 2.0, width / 2.0
    steps = arc_steps(radius, math.pi)
    right, right_outward = arc_points(np.array([half, 0.0]), radius, -0.5 * math.pi, math.pi, steps)
    left, left_outward = arc_points(np.array([-half, 0.0]), radius, 0.5 * math.pi, math.pi, steps)
    normals = np.concatenate([right_outward, left_outward])
    return _convex(without_repeats(Contour(np.concatenate([right, left]), normals, normals)))


@records(_slot)
def slot(length: Scalar, width: Scalar) -> Profile:
    """Make a slot with round ends, centered on the origin.

    Args:
        length: Overall length along x [m], at least the width.
        width: Length along y, twice the radius of the ends [m].

    Examples:
        >>> slot(0.3, 0.08)
    """


def _ring(outer: float, inner: float) -> Outline:
    check.positive("inner radius", inner)
    if not outer > inner:
        raise ValueError(f"the outer radius {outer:g} m must exceed the inner radius {inner:g} m")
    inner, sides = hole_radius(inner, outer, sides_of(outer))
    hole = reversed_contour(circle_contour(inner, sides))
    return Outline((circle_contour(outer, sides), hole))


@records(_ring)
def ring(outer: Scalar, inner: Scalar) -> Profile:
    """Make a ring about the origin.

    Args:
        outer: Outer radius [m].
        inner: Radius of the hole [m].

    Examples:
        >>> ring(0.1, 0.07)
    """


def _bow(radius: float, width: float, start: float, sweep: float) -> Outline:
    check.positive("radius", radius)
    check.between("width", width, 1e-6, 2.0 * radius * (1.0 - 1e-6))
    check.finite("start", start, "rad")
    check.between("sweep", sweep, 1e-3, math.tau * 0.999, "rad")
    outer, inner = radius + width / 2.0, radius - width / 2.0
    steps = arc_steps(outer, sweep)
    there, outward = arc_points(np.zeros(2), outer, start, sweep, steps)
    back, inward = arc_points(np.zeros(2), inner, start + sweep, -sweep, steps)
    points = np.concatenate([there, back])
    arriving = np.concatenate([outward, -inward])
    leaving = arriving.copy()
    head = np.array([-outward[-1, 1], outward[-1, 0]])
    tail = np.array([outward[0, 1], -outward[0, 0]])
    leaving[steps] = arriving[steps + 1] = head
    leaving[-1] = arriving[0] = tail
    return Outline((Contour(points, arriving, leaving),))


@records(_bow)
def bow(radius: Scalar, width: Scalar, *, start: Scalar = 0.0, sweep: Scalar = math.pi) -> Profile:
    """Make a band bent along a circle about the origin, with flat ends.

    Args:
        radius: Radius of its center line [m].
        width: Width of the band across the line [m].
        start: Angle of the first end, from x towards y [rad].
        sweep: Angle from the first to the second end, counter-clockwise [rad].

    Examples:
        >>> bow(0.1, 0.03, start=0.3, sweep=2.5)
    """


@kernel(spelling="{profile}.offset({distance}, join={join})")
def _offset(profile: Outline, distance: float, join: Literal["round", "miter"]) -> Outline:
    check.finite("distance", distance)
    if abs(distance) < 1e-9:
        return profile
    kind = JoinType.Round if join == "round" else JoinType.Miter
    region = section(profile.contours).offset(distance, kind, 4.0, sides_of(abs(distance)))
    return outline_of(region, f"the profile after an offset of {distance * 1e3:g} mm")


def _near(a: Outline, b: Outline) -> tuple[Mask, Mask]:
    """Tell which contours of each outline have a bounding box that meets one of the other outline."""
    (low, high), (least, most) = a.boxes, b.boxes
    near = np.all((low[:, None] <= most) & (least <= high[:, None]), axis=2)
    return np.asarray(near.any(axis=1)), np.asarray(near.any(axis=0))


@kernel(spelling="({a} | {b})")
def _profile_union(a: Outline, b: Outline) -> Outline:
    first, second = _near(a, b)
    if not first.any():
        convex = a.convex + b.convex if a.convex is not None and b.convex is not None else None
        return Outline(a.contours + b.contours, convex)
    # print is united letter by letter: contours away from the others stay as they are
    one, two = (list(compress(each.contours, near)) for each, near in ((a, first), (b, second)))
    joined = outline_of(section(one) + section(two), "the union of the profiles")
    rest = (*compress(a.contours, ~first), *compress(b.contours, ~second))
    return Outline((*joined.contours, *rest))


@kernel(spelling="({a} - {b})")
def _profile_difference(a: Outline, b: Outline) -> Outline:
    if not _near(a, b)[0].any():
        return a
    kept = _pierced(a, b)
    if kept is not None:
        return kept
    return outline_of(section(a.contours) - section(b.contours), "the difference of the profiles")


def _pierced(a: Outline, b: Outline) -> Outline | None:
    """Return `a - b` with exact normals if all borders of b lie inside a; else None."""
    if any(signed_area(contour.points) < 0.0 for contour in b.contours):
        return None
    whole: CrossSection = section(a.contours)
    holes = section(b.contours)
    if (holes - whole).area() > 1e-12:
        return None
    contours = (*a.contours, *(reversed_contour(contour) for contour in b.contours))
    area = whole.area() - sum(signed_area(contour.points) for contour in b.contours)
    touches = (whole - holes).num_contour() != len(contours)
    return None if touches or area <= 1e-12 else Outline(contours)


@kernel(spelling="({a} & {b})")
def _profile_intersection(a: Outline, b: Outline) -> Outline:
    return outline_of(section(a.contours) ^ section(b.contours), "the intersection of the profiles")


@kernel(spelling="{profile}.at({x}, {y})")
def _profile_translate(profile: Outline, x: float, y: float) -> Outline:
    offset = np.array([check.finite("x", x), check.finite("y", y)])
    return moved_outline(profile, np.eye(2), offset)


@kernel(spelling="{profile}.rotate({angle})")
def _profile_rotate(profile: Outline, angle: float) -> Outline:
    cosine, sine = math.cos(check.finite("angle", angle, "rad")), math.sin(angle)
    return moved_outline(profile, np.array([[cosine, -sine], [sine, cosine]]), np.zeros(2))


@kernel(spelling="{profile}.scale({x}, {y})")
def _profile_scale(profile: Outline, x: float, y: float) -> Outline:
    scale = np.diag([check.finite("scale x", x, ""), check.finite("scale y", y, "")])
    return moved_outline(profile, scale, np.zeros(2))


@kernel(spelling="{profile}.mirror({x}, {y})")
def _profile_mirror(profile: Outline, x: float, y: float) -> Outline:
    normal = np.array([check.finite("x", x, ""), check.finite("y", y, "")])
    length = float(np.hypot(x, y))
    if length < 1e-12:
        raise ValueError("the normal of the mirror must have a direction, got (0, 0)")
    normal /= length
    return moved_outline(profile, np.eye(2) - 2.0 * np.outer(normal, normal), np.zeros(2))
