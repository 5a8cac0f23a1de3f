"""Extrusion of a profile, revolution about an axis, and half sections for it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array, affine, successors
from artgen.asset.shape import Contour, Curve, Outline, Shape
from artgen.graph import FULL, detail_level, records
from artgen.nodes import validators as check
from artgen.nodes.contours import (
    chords,
    coarse,
    estimated,
    faceted,
    is_disjoint,
    moved_outline,
    refined,
    side_normals,
    without_repeats,
)
from artgen.nodes.handles import Array3, Path, Profile, Scalar, Solid, VectorLike
from artgen.nodes.primitive_colliders import around_extrusion, around_lathe, moved
from artgen.nodes.surfaces import DeferredSkin, extrusion, lathe, lathe_steps, mitres

_AT_AXIS = 1e-7  # points of a profile nearer to the axis than this lie on it [m]
_FEWEST, _MOST = 3, 128  # sides of a full turn


def _revolve(profile: Outline, angle: float, axis: Array3, sides: int = 0) -> Shape:
    check.between("angle", angle, 0.001, math.tau + 1e-9, "rad")
    if sides != 0 and not _FEWEST <= sides <= _MOST:
        raise ValueError(
            f"a lathe makes {_FEWEST} to {_MOST} sides, or 0 for a number that looks round; got {sides}"
        )
    profile = coarse(profile)
    least = min(float(contour.points[:, 0].min()) for contour in profile.contours)
    if least < -_AT_AXIS:
        raise ValueError(
            f"the profile reaches x = {least:g} m; all of it must be at x >= 0, which is the radius "
            "(profile.at(x, y) moves it)"
        )
    contours = [
        Contour(_on_axis(each.points, _AT_AXIS), each.normals_in, each.normals_out)
        for each in profile.contours
    ]
    if sides and detail_level() is not FULL:
        sides = min(sides, lathe_steps(contours, math.tau, None)[0])
    turn = check.frame(axis)
    pieces = around_lathe(contours, angle, sides or None)
    skin = DeferredSkin(lambda: lathe(contours, angle=angle, sides=sides or None).turned(turn))
    return skin.shape(moved(pieces, affine(turn)))


@records(_revolve)
def revolve(
    profile: Profile, *, angle: Scalar = math.tau, axis: VectorLike = (0.0, 0.0, 1.0), sides: int = 0
) -> Solid:
    """Revolve a profile about an axis through the origin: its x is the radius, its y runs along the axis.

    Args:
        profile: The profile, at x >= 0.
        angle: Angle [rad], right-handed about the axis, starting at X (at Y for an axis along X).
        axis: Direction of the axis.
        sides: Number of facets of the full circle; 0 chooses a number that looks round. A hollow solid
            collides as one piece for each facet and each bend of the profile, so a thin shell should have
            few.

    Examples:
        >>> revolve(rectangle(0.04, 0.1, radius=0.01).at(0.08), angle=4.5)
    """


_TWIST_STEP = math.pi / 32.0


def _extrude(
    profile: Outline, length: float, axis: Array3, bevel: float, taper: float, twist: float
) -> Shape:
    check.positive("length", length)
    bevel = check.rounding("bevel", bevel, length / 2.0 * 0.999)
    check.between("taper", taper, -10.0, 0.99, "")
    check.between("twist", twist, -100.0, 100.0, "rad")
    turn, profile = check.frame(axis), coarse(profile)
    if check.frame_is_mirrored(turn):
        profile = moved_outline(profile, np.diag([1.0, -1.0]), np.zeros(2))
    if bevel > 0.0:
        _check_bevel(profile.contours, bevel)
    stations = max(1, math.ceil(abs(twist) / _TWIST_STEP - 1e-9))
    warp = _warp(length, taper, twist) if taper != 0.0 or twist != 0.0 else None
    # long sides get more vertices for bending; the hulls of the original vertices bound the pieces
    contours = refined(profile, 2.0 * length / stations).contours if twist != 0.0 else profile.contours
    scales = (1.0, 1.0 - taper)
    skin = DeferredSkin(
        lambda: extrusion(contours, length, bevel=bevel, stations=stations, warp=warp, scales=scales).turned(
            turn
        )
    )
    pieces = around_extrusion(profile, length, bevel=bevel, taper=taper, twist=twist, stations=stations)
    return skin.shape(moved(pieces, affine(turn)))


@records(_extrude)
def extrude(
    profile: Profile,
    length: Scalar,
    *,
    axis: VectorLike = (0.0, 0.0, 1.0),
    bevel: Scalar = 0.0,
    taper: Scalar = 0.0,
    twist: Scalar = 0.0,
) -> Solid:
    """Extrude a profile, centered; along Z it lies in (X, Y), along Y in (X, Z), along X in (Y, Z).

    The profile's x and y run along the two other asset axes, in the order X, Y, Z. Reversing the axis, as in
    -Y for the front, does not mirror the profile; it swaps the ends, which matters for taper and twist.

    Args:
        length: Length along the axis [m].
        axis: Direction of the axis.
        bevel: Radius of the rounded edges at both ends [m].
        taper: Share by which the profile shrinks towards the end of the axis (-1 doubles it).
        twist: Rotation of the end about the axis, right-handed [rad].

    Examples:
        >>> extrude(regular_polygon(6, 0.05), 0.15, bevel=0.004, taper=0.3, twist=0.5)
    """


def _check_bevel(contours: Sequence[Contour], bevel: float) -> None:
    """Check that borders moved inward by the bevel neither fold nor meet."""
    allowed = math.inf
    rings = []
    for contour in contours:
        inward = mitres(contour)
        sides = successors(contour.points) - contour.points
        shortening = ((successors(inward) - inward) * sides).sum(axis=1)
        squared = (sides * sides).sum(axis=1)
        shrinking = shortening > 1e-12
        if shrinking.any():
            allowed = min(allowed, float((squared[shrinking] / shortening[shrinking]).min()))
        rings.append(contour.points - bevel * inward)
    if bevel >= allowed:
        raise ValueError(
            f"bevel {bevel * 1e3:.3g} mm is too large for the profile, whose sharpest curve or shortest "
            f"side allows less than {allowed * 1e3:.3g} mm"
        )
    if not is_disjoint(rings):
        raise ValueError(
            f"bevel {bevel * 1e3:.3g} mm is too large for the profile: the rounded edges of a thin part "
            "of it would meet; a bevel must stay below half of the thinnest part"
        )


def _warp(length: float, taper: float, twist: float) -> Callable[[Array, Array], tuple[Array, Array]]:
    """Return the map of a straight extrusion along z to a tapered and twisted one."""

    def warp(vertices: Array, normals: Array) -> tuple[Array, Array]:
        x, y, z = vertices.T
        along = z / length + 0.5
        scale, angle = 1.0 - taper * along, twist * along
        cosine, sine = _portable.cos(angle), _portable.sin(angle)
        moved_vertices = np.column_stack(
            [scale * (cosine * x - sine * y), scale * (sine * x + cosine * y), z]
        )
        # normals are multiplied by the inverse transpose of the map's derivative, here times the scale
        nx, ny, nz = normals.T
        rise = scale * nz + taper / length * (x * nx + y * ny) - twist / length * scale * (x * ny - y * nx)
        turned = np.column_stack([cosine * nx - sine * ny, sine * nx + cosine * ny, rise])
        return moved_vertices, turned / np.linalg.norm(turned, axis=1, keepdims=True)

    return warp


_ON_AXIS = 1e-6  # points of a line nearer to the axis than this lie on it [m]
_FLAT = 0.01  # largest deviation of a line from the plane of a half section [m]


def _half_section(
    path: Curve | tuple[Curve, ...], wall: float | None, inset: float, bore: float, within: float
) -> Outline:
    path = path if isinstance(path, Curve) else _joined(path)
    if path.closed:
        raise ValueError("the line of a half section must be open: from its lower end to its upper one")
    if np.abs(path.points[:, 1]).max() > _FLAT * max(1.0, float(np.abs(path.points).max())):
        raise ValueError("the line of a half section must lie in the plane y = 0: x is the radius")
    line = path.points[:, [0, 2]]
    if line[:, 0].min() < -_ON_AXIS:
        raise ValueError(f"the line reaches x = {line[:, 0].min():g} m; x is the radius, so it starts at 0")
    if check.between("within", within, 0.0, 0.01) > 0.0:
        low, high = line[:, 1].min(), line[:, 1].max()
        apart = np.append(True, np.linalg.norm(np.diff(line, axis=0), axis=1) > _ON_AXIS)
        line = line[apart]
        line = line[chords(line, 0.5 * within)]
        path = Curve(np.column_stack([line[:, 0], np.zeros(len(line)), line[:, 1]]))
        inset = inset + 0.5 * within
    outward, corners = _normals(path, line)
    outer = _on_axis(line - check.finite("inset", inset) * corners)
    if within > 0.0:  # slanted ends move along their normals, off the heights at which the line ends
        outer[:, 1] = np.clip(outer[:, 1], low, high)
        ends = [end for end in (0, -1) if outer[end, 0] > 0.0]
        outer[ends, 1] = line[ends, 1]
    if wall is None:
        made = _solid(outer, outward, check.between("bore", bore, 0.0, float(outer[:, 0].max())))
    else:
        inner = _on_axis(line - (inset + check.positive("wall", wall)) * corners)
        made = _shell(outer, inner, outward, smooth=path.tangents is not None)
    made = without_repeats(made if within == 0.0 else faceted(made.points))
    if not is_disjoint([made.points]):
        raise ValueError("the half section crosses itself: bend its line less, or make its wall thinner")
    return Outline((made,))


@records(_half_section)
def half_section(
    path: Path | Sequence[Path],
    *,
    wall: Scalar | None = None,
    inset: Scalar = 0.0,
    bore: Scalar = 0.0,
    within: Scalar = 0.0,
) -> Profile:
    """Make the profile for `revolve` from the line of its outside.

    Args:
        path: The outside from the lower end to the upper end, in the plane y = 0: x is the radius, z becomes
            the profile's y. A spline makes a smooth outside; several paths meet at sharp edges, or at steps
            where they are apart.
        wall: Thickness of a shell inside the line, open at both ends; a solid by default [m].
        inset: Distance by which the outside moves inward [m].
        bore: Radius of the hole along the axis of a solid without wall [m].
        within: Largest depth below the line at which straight segments replace it; 0 follows the line [m].
            They never lie outside the line: a core with few facets fits inside a smooth skin.

    Examples:
        >>> outside = spline([(0.03, 0, 0), (0.05, 0, 0.05), (0.02, 0, 0.1), (0.03, 0, 0.14)])
        >>> revolve(half_section(outside, wall=0.003))
    """


def _joined(paths: Sequence[Curve]) -> Curve:
    """Return paths as one from end to end; points at which they meet appear twice."""
    points: list[Array] = []
    tangents: list[Array] = []
    for path in paths:
        if path.tangents is None:
            raise ValueError("a half section of several paths takes lines, arcs and splines, no polylines")
        if points:
            gap = path.points[0] - points[-1][-1]
            length = _portable.norm(gap)
            if length > _ON_AXIS:
                points.append(np.stack([points[-1][-1], path.points[0]]))
                tangents.append(np.stack([gap / length] * 2))
        points.append(path.points)
        tangents.append(path.tangents)
    return Curve(np.concatenate(points), False, np.concatenate(tangents))


def _normals(path: Curve, line: Array) -> tuple[Array, Array]:
    """Return the unit normals of the outside, and the motion of its points per metre of inset."""
    if path.tangents is not None:
        along = path.tangents[:, [0, 2]]
        outward = np.column_stack([along[:, 1], -along[:, 0]])
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        for end in (0, -1):
            if line[end, 0] <= _ON_AXIS:  # a pole has a normal along the axis
                outward[end] = (0.0, np.sign(outward[end, 1]) or 1.0)
        return outward, outward
    sides = side_normals(line)[:-1]
    before, after = np.vstack([sides[:1], sides]), np.vstack([sides, sides[-1:]])
    # the corner between two sides moves along their bisector, farther than the sides
    mitred = (before + after) / (1.0 + np.einsum("ij,ij->i", before, after))[:, None]
    return mitred / np.linalg.norm(mitred, axis=1, keepdims=True), mitred


def _on_axis(points: Array, near: float = _ON_AXIS) -> Array:
    points = points.copy()
    points[points[:, 0] < near, 0] = 0.0
    return points


def _solid(outer: Array, outward: Array, bore: float = 0.0) -> Contour:
    first = [] if outer[0, 0] <= bore else [[bore, outer[0, 1]]]
    last = [] if outer[-1, 0] <= bore else [[bore, outer[-1, 1]]]
    points = np.concatenate([np.array(part, float).reshape(-1, 2) for part in (first, outer, last)])
    return _with_normals(points, outward, len(first))


def _shell(outer: Array, inner: Array, outward: Array, *, smooth: bool) -> Contour:
    points = np.concatenate([outer, inner[::-1]])
    made = _with_normals(points, outward, 0)
    return _with_normals(points, -outward[::-1], len(outer), made) if smooth else estimated(points)


def _with_normals(points: Array, outward: Array, start: int, rest: Contour | None = None) -> Contour:
    """Return a contour with given normals for the points from `start` on; the others are estimated."""
    known = rest or estimated(points)
    arriving, leaving = known.normals_in.copy(), known.normals_out.copy()
    end = start + len(outward)
    arriving[start + 1 : end], leaving[start : end - 1] = outward[1:], outward[:-1]
    return Contour(points, arriving, leaving)
