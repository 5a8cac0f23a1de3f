"""Primitive solids, centered on the origin unless stated otherwise."""

from __future__ import annotations

import math

import numpy as np

from artgen import _portable
from artgen._arrays import Array, affine
from artgen.asset.shape import Contour, Shape
from artgen.colliders import Convex, Exact
from artgen.colliders.triangles import hull_of
from artgen.graph import FULL, detail_level, kernel, records
from artgen.nodes import validators as check
from artgen.nodes.contours import arc_points, circle_contour, faceted, rounded_polygon
from artgen.nodes.csg import faceted_shape
from artgen.nodes.handles import Array3, Scalar, Solid, VectorLike
from artgen.nodes.primitive_colliders import (
    around_cylinder,
    around_hull,
    around_lathe,
    around_round,
    around_rounded_box,
    moved,
)
from artgen.nodes.surfaces import (
    DeferredSkin,
    bevel_steps,
    chamfered_box,
    extrusion,
    hole_radius,
    lathe,
    rounded_box,
    sides_of,
)


def axial(radius: float, half: float, bevel: float, top_radius: float | None = None) -> Contour:
    """Return the (r, z) half section of a cylinder or frustum with rounded rims."""
    top = radius if top_radius is None else top_radius
    corners = [(0.0, -half), (radius, -half), (top, half), (0.0, half)]
    points = np.array([corner for at, corner in enumerate(corners) if at in (0, 3) or corner[0] > 0.0])
    if bevel == 0.0:
        return faceted(points)
    return rounded_polygon(points, [bevel if point[0] > 0.0 else 0.0 for point in points])


def half_ellipse(radius: float, half: float, start: float, sides: int | None = None) -> Contour:
    """Return the (r, z) section of an ellipsoid from an angle [rad] to its upper pole."""
    sides = sides or sides_of(max(radius, half))
    steps = max(2, math.ceil(sides * (0.5 * math.pi - start) / math.tau - 1e-9))
    unit, _ = arc_points(np.zeros(2), 1.0, start, 0.5 * math.pi - start, steps)
    normals = unit / np.array([radius, half])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return onto_axis(unit * np.array([radius, half]), normals)


def onto_axis(points: Array, normals: Array) -> Contour:
    """Close a smooth (r, z) line along the axis (and along a flat base where it starts away from it)."""
    points, normals = points.copy(), normals.copy()
    points[-1, 0] = 0.0
    if points[0, 0] > 1e-9:
        points = np.concatenate([[[0.0, points[0, 1]]], points])
        base = np.array([[0.0, -1.0]])
        arriving = np.concatenate([[[-1.0, 0.0]], base, normals[1:]])
        leaving = np.concatenate([base, normals[:-1], [[-1.0, 0.0]]])
        return Contour(points, arriving, leaving)
    points[0, 0] = 0.0
    arriving, leaving = normals.copy(), normals.copy()
    arriving[0] = leaving[-1] = (-1.0, 0.0)
    return Contour(points, arriving, leaving)


UP = (0.0, 0.0, 1.0)


def _box(x: float, y: float, z: float, bevel: float, crown: float = 0.0) -> Shape:
    size = check.sizes("size", x, y, z)
    bevel = check.rounding("bevel", bevel, float(size.min()) / 2.0)
    check.between("crown", crown, 0.0, z - 2.0 * bevel + 1e-12)
    if crown > 0.0:
        vertices = _crowned(size, bevel, crown)
        return faceted_shape(hull_of(vertices), around_hull(lambda: vertices))
    if bevel == 0.0:
        return DeferredSkin(lambda: rounded_box(size, 0.0, 0)).shape(Exact((Convex.box(size),)))
    if detail_level() is not FULL and bevel <= _CHAMFERED:
        skin = DeferredSkin(lambda: chamfered_box(size, bevel))
        return skin.shape(around_rounded_box(size, bevel, skin.vertices, chamfered=True))
    steps = max(1, bevel_steps(bevel) // 2)
    skin = DeferredSkin(lambda: rounded_box(size, bevel, steps))
    return skin.shape(around_rounded_box(size, bevel, skin.vertices))


_CHAMFERED = (
    0.006  # largest bevel of a box that is a single chamfer at lower detail: 0.16 of it is exceeded [m]
)
_GRID = 9  # points of the crown of a box along each side


def _crowned(size: Array, bevel: float, crown: float) -> Array:
    """Return points whose hull is a rounded box with a crowned top, shape (n, 3) [m]."""
    half, steps = size / 2.0 - bevel, max(1, 2 * bevel_steps(bevel) // 3)
    along = np.linspace(-1.0, 1.0, _GRID)
    u, v = (each.ravel() for each in np.meshgrid(along, along))
    tops = np.column_stack((u * half[0], v * half[1], half[2] - crown * (u**2 + v**2) / 2.0))
    rim = np.maximum(np.abs(u), np.abs(v)) == 1.0
    corner = (np.abs(u) == 1.0) & (np.abs(v) == 1.0)
    bottoms = tops[corner] * (1.0, 1.0, 0.0) - (0.0, 0.0, half[2])
    rise = 0.5 * math.pi * np.arange(steps + 1) / steps
    around = math.tau * np.arange(4 * steps) / (4 * steps)
    level = _portable.cos(rise)[:, None]
    upper = np.stack(
        [
            level * _portable.cos(around),
            level * _portable.sin(around),
            np.repeat(_portable.sin(rise)[:, None], 4 * steps, 1),
        ],
        axis=-1,
    ).reshape(-1, 3)
    lower = upper * (1.0, 1.0, -1.0)
    points = [
        tops[:, None] + (0.0, 0.0, bevel),
        tops[rim][:, None] + bevel * upper,
        bottoms[:, None] + bevel * lower,
    ]
    return np.concatenate([each.reshape(-1, 3) for each in points])


@records(_box)
def box(x: Scalar, y: Scalar, z: Scalar, *, bevel: Scalar = 0.0, crown: Scalar = 0.0) -> Solid:
    """Make a box centered on the origin; with a crown, it is a cushion.

    Args:
        x: Length along X [m].
        y: Length along Y [m].
        z: Length along Z [m].
        bevel: Radius of all rounded edges and corners [m]; 0 leaves them sharp.
        crown: Height of the middle of the top above its corners, included in `z` [m]; at most z - 2 bevel.

    Examples:
        >>> box(0.3, 0.2, 0.1, bevel=0.01)
        >>> box(0.45, 0.42, 0.09, bevel=0.03, crown=0.025)
    """


@kernel
def _box_between(low: Array3, high: Array3, bevel: float) -> Shape:
    size = check.vector("high", high) - check.vector("low", low)
    for name, length in zip("xyz", size, strict=True):
        if length <= 0.0:
            raise ValueError(
                f"the region is {length:.6g} m long along {name}: the lowest coordinate comes first"
            )
    return _box(float(size[0]), float(size[1]), float(size[2]), bevel).transformed(
        affine(np.eye(3), 0.5 * (low + high))
    )


def _cylinder(radius: float, length: float, axis: Array3, bevel: float) -> Shape:
    check.positive("radius", radius)
    check.positive("length", length)
    bevel = check.rounding("bevel", bevel, min(radius, length / 2.0) * 0.999)
    turn = check.frame(axis)
    skin = DeferredSkin(lambda: lathe([axial(radius, length / 2.0, bevel)]).turned(turn))
    pieces = around_cylinder(radius, length, sides_of(radius), affine(turn), bevel)
    return skin.shape(pieces)


@records(_cylinder)
def cylinder(radius: Scalar, length: Scalar, *, axis: VectorLike = UP, bevel: Scalar = 0.0) -> Solid:
    """Make a cylinder centered on the origin.

    Args:
        radius: Radius [m]; the facets stay inside the cylinder.
        length: Length along the axis [m].
        axis: Direction of the axis.
        bevel: Radius of both rounded rims [m].

    Examples:
        >>> cylinder(0.05, 0.2, bevel=0.005)
    """


def _cylinder_between(start: Array3, end: Array3, radius: float, bevel: float) -> Shape:
    along = check.vector("end", end) - check.vector("start", start)
    length = math.hypot(*along)
    if length <= 0.0:
        raise ValueError("start and end are the same point; a cylinder needs two different points")
    made = _cylinder(radius, length, along, bevel)
    return made.transformed(affine(np.eye(3), 0.5 * (start + end)))


@records(_cylinder_between)
def cylinder_between(start: VectorLike, end: VectorLike, radius: Scalar, *, bevel: Scalar = 0.0) -> Solid:
    """Make a cylinder between two points: a pin, a post, a rod, a straight wire.

    Args:
        start: Center of one end [m].
        end: Center of the other end [m].
        radius: Radius [m]; the facets stay inside the cylinder.
        bevel: Radius of both rounded rims [m].

    Examples:
        >>> cylinder_between((0, 0, 0), (0.3, 0, 0.1), 0.01)
    """


def _bore(radius: float, length: float, axis: Array3) -> Shape:
    check.positive("radius", radius)
    check.positive("length", length)
    turn = check.frame(axis)
    sides = sides_of(radius)
    outside = radius / math.cos(math.pi / sides)
    skin = DeferredSkin(lambda: lathe([axial(outside, length / 2.0, 0.0)], sides=sides).turned(turn))
    return skin.shape(around_cylinder(outside, length, sides, affine(turn)))


@records(_bore)
def bore(radius: Scalar, length: Scalar, *, axis: VectorLike = UP) -> Solid:
    """Make a tool that drills a hole, centered on the origin: a smaller shaft turns in the hole.

    It is a cylinder with facets outside the radius, in contrast to `cylinder`. A shaft that turns or slides
    in the hole needs clearance: 0.05 mm on its radius is enough.

    Args:
        radius: Radius of the hole [m].
        length: Length along the axis [m].
        axis: Direction of the axis.

    Examples:
        >>> box(0.1, 0.1, 0.04) - bore(0.02, 0.1)
    """


def _frustum(bottom_radius: float, top_radius: float, length: float, axis: Array3, bevel: float) -> Shape:
    check.between("bottom radius", bottom_radius, 0.0, math.inf)
    check.between("top radius", top_radius, 0.0, math.inf)
    check.positive("the larger radius", max(bottom_radius, top_radius))
    check.positive("length", length)
    bevel = check.rounding("bevel", bevel, math.inf)
    turn = check.frame(axis)
    contour = axial(bottom_radius, length / 2.0, bevel, top_radius)
    skin = DeferredSkin(lambda: lathe([contour]).turned(turn))
    return skin.shape(moved(around_lathe([contour]), affine(turn)))


@records(_frustum)
def frustum(
    bottom_radius: Scalar, top_radius: Scalar, length: Scalar, *, axis: VectorLike = UP, bevel: Scalar = 0.0
) -> Solid:
    """Make a truncated cone centered on the origin; a radius of 0 gives a pointed end.

    Args:
        bottom_radius: Radius at the start of the axis [m].
        top_radius: Radius at the end of the axis [m].
        length: Length along the axis [m].
        axis: Direction from bottom to top.
        bevel: Radius of both rounded rims [m].

    Examples:
        >>> frustum(0.08, 0.04, 0.12, bevel=0.005)
    """


def _sphere(radius: float) -> Shape:
    check.positive("radius", radius)
    skin = DeferredSkin(lambda: lathe([half_ellipse(radius, radius, -0.5 * math.pi)]))
    return skin.shape(around_round(Convex.sphere(radius), skin.vertices))


@records(_sphere)
def sphere(radius: Scalar) -> Solid:
    """Make a sphere [m] about the origin.

    Examples:
        >>> sphere(0.05)
    """


def _ellipsoid(radius_x: float, radius_y: float, radius_z: float) -> Shape:
    radii = check.sizes("radius", radius_x, radius_y, radius_z)
    sides = sides_of(float(radii.max()))
    along = None if detail_level() is FULL else sides
    skin = lathe([half_ellipse(1.0, 1.0, -0.5 * math.pi, along)], sides=sides)
    vertices = skin.vertices * radii
    normals = skin.normals / radii
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    # texture coordinates of the unit sphere are angles; the two main half axes scale them to lengths
    uvs = skin.uvs * np.array([math.sqrt(radius_x * radius_y), radius_z])
    return Shape.from_mesh(
        vertices, normals, uvs, skin.triangles, around_hull(lambda: vertices), targets=skin.targets
    )


@records(_ellipsoid)
def ellipsoid(radius_x: Scalar, radius_y: Scalar, radius_z: Scalar) -> Solid:
    """Make an ellipsoid about the origin.

    Args:
        radius_x: Half axis along X [m].
        radius_y: Half axis along Y [m].
        radius_z: Half axis along Z [m].

    Examples:
        >>> ellipsoid(0.15, 0.1, 0.05)
    """


def _dome(radius: float, height: float | None, axis: Array3) -> Shape:
    check.positive("radius", radius)
    rise = radius if height is None else check.positive("height", height)
    turn = check.frame(axis)
    skin = DeferredSkin(lambda: lathe([half_ellipse(radius, rise, 0.0)]).turned(turn))
    return skin.shape(around_hull(skin.vertices))


@records(_dome)
def dome(radius: Scalar, *, height: Scalar | None = None, axis: VectorLike = UP) -> Solid:
    """Make half of a sphere or ellipsoid, the center of its flat base at the origin.

    Args:
        radius: Radius of the base [m].
        height: Height above the base [m]; the radius by default.
        axis: Direction from the base to the top.

    Examples:
        >>> dome(0.1, height=0.06)
    """


def _capsule(radius: float, length: float, axis: Array3) -> Shape:
    check.positive("radius", radius)
    check.between("length", length, 2.0 * radius, math.inf)
    half = length / 2.0 - radius
    if half < 1e-9:
        return _sphere(radius)
    turn = check.frame(axis)
    steps = max(2, sides_of(radius) // 4)
    low, low_out = arc_points(np.array([0.0, -half]), radius, -0.5 * math.pi, 0.5 * math.pi, steps)
    high, high_out = arc_points(np.array([0.0, half]), radius, 0.0, 0.5 * math.pi, steps)
    contour = onto_axis(np.concatenate([low, high]), np.concatenate([low_out, high_out]))
    skin = DeferredSkin(lambda: lathe([contour]).turned(turn))
    return skin.shape(around_round(Convex.capsule(radius, 2.0 * half, affine(turn)), skin.vertices))


@records(_capsule)
def capsule(radius: Scalar, length: Scalar, *, axis: VectorLike = UP) -> Solid:
    """Make a cylinder with half spheres at both ends, centered on the origin.

    Args:
        radius: Radius [m].
        length: Overall length along the axis [m], at least twice the radius.
        axis: Direction of the axis.

    Examples:
        >>> capsule(0.03, 0.2, axis=X)
    """


def _torus(major: float, minor: float, axis: Array3) -> Shape:
    check.positive("major radius", major)
    check.between("minor radius", minor, 1e-6, major * 0.999)
    turn = check.frame(axis)
    circle = circle_contour(minor)
    contour = Contour(circle.points + np.array([major, 0.0]), circle.normals_in, circle.normals_out)
    skin = DeferredSkin(lambda: lathe([contour]).turned(turn))
    return skin.shape(moved(around_lathe([contour]), affine(turn)))


@records(_torus)
def torus(major: Scalar, minor: Scalar, *, axis: VectorLike = UP) -> Solid:
    """Make a torus about the origin.

    Args:
        major: Radius of the circle of the tube's center [m].
        minor: Radius of the tube [m], less than the major radius.
        axis: Direction of the axis.

    Examples:
        >>> torus(0.1, 0.025)
    """


def _tube(outer: float, inner: float, length: float, axis: Array3, bevel: float) -> Shape:
    check.positive("inner radius", inner)
    if not outer > inner:
        raise ValueError(f"the outer radius {outer:g} m must exceed the inner radius {inner:g} m")
    check.positive("length", length)
    bevel = check.rounding("bevel", bevel, min(outer - inner, length) / 2.0 * 0.999)
    inner, sides = hole_radius(inner, outer, sides_of(outer))
    bevel = min(bevel, (outer - inner) / 2.0 * 0.999)
    turn = check.frame(axis)
    half = length / 2.0
    corners = np.array([[inner, -half], [outer, -half], [outer, half], [inner, half]])
    contour = rounded_polygon(corners, [bevel] * 4) if bevel > 0.0 else faceted(corners)
    pieces = moved(around_lathe([contour], sides=sides), affine(turn))
    return DeferredSkin(lambda: lathe([contour], sides=sides).turned(turn)).shape(pieces)


@records(_tube)
def tube(
    outer: Scalar, inner: Scalar, length: Scalar, *, axis: VectorLike = UP, bevel: Scalar = 0.0
) -> Solid:
    """Make a round tube centered on the origin.

    Args:
        outer: Outer radius [m].
        inner: Radius of the hole [m].
        length: Length along the axis [m].
        axis: Direction of the axis.
        bevel: Radius of the four rounded rims [m].

    Examples:
        >>> tube(0.05, 0.04, 0.12, bevel=0.002)
    """


def _wedge(x: float, y: float, z: float) -> Shape:
    half = check.sizes("size", x, y, z) / 2.0
    ramp = faceted(np.array([[-half[1], -half[2]], [half[1], -half[2]], [half[1], half[2]]]))
    skin = DeferredSkin(lambda: extrusion([ramp], x).turned(check.frame((1.0, 0.0, 0.0))))
    return skin.shape(around_hull(skin.vertices))


@records(_wedge)
def wedge(x: Scalar, y: Scalar, z: Scalar) -> Solid:
    """Make a ramp that rises from the front (-Y) to the back; its bounding box is centered on the origin.

    Args:
        x: Width along X [m].
        y: Depth along Y [m].
        z: Height at the back [m].

    Examples:
        >>> wedge(0.1, 0.2, 0.08)
    """
