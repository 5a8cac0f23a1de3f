"""Combination of solids: union, difference, intersection, hull, split and shell, and paint.

Surfaces keep their normals, texture coordinates and paint; a cut face has those of the cutting solid.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from manifold3d import Manifold, OpType

from artgen import _portable, colliders
from artgen._arrays import Array, affine, distinct_rows
from artgen.asset import rotation
from artgen.asset.manifolds import box_of, manifold_of
from artgen.asset.shape import ComposedShape, DeferredShape, Shape, UnitedShape
from artgen.asset.surface import corner_normals
from artgen.colliders import Convex, Exact, Pieces
from artgen.colliders.convex import TOLERANCE
from artgen.colliders.pieces import Cover
from artgen.colliders.triangles import cross, hull_of, triangles_of
from artgen.graph import kernel, records
from artgen.materials import Material
from artgen.nodes import validators as check
from artgen.nodes.contours import CREASE
from artgen.nodes.handles import Array3, ArrayN3, PointsLike, Scalar, Solid, VectorLike
from artgen.nodes.primitive_colliders import around_hull
from artgen.nodes.surfaces import rounded_box
from artgen.nodes.unwrap import boxed_uvs
from artgen.nodes.validators import between
from artgen.nodes.vector import unit

MOST = 0.001
"""Largest distance between coarse colliders and their solid, equal to that of the checks [m]."""


class _Coarse(Pieces):
    """Pieces that follow a solid up to a distance."""

    def __init__(self, base: Pieces, least: float) -> None:
        super().__init__(lambda tolerance: base.outer(max(tolerance, least)), base.inner, base.declared)
        self._base, self._least = base, least

    def simplified(self, tolerance: float, most_vertices: int = 64) -> Cover:
        return self._base.simplified(max(tolerance, self._least), most_vertices)


def _simplified_collider(solid: Shape, within: float) -> Shape:
    between("within", within, 0.0, MOST)
    if within == 0.0:
        return solid
    return Shape(solid.manifold, _Coarse(solid.pieces, within), solid.paints)


@records(_simplified_collider)
def simplified_collider(solid: Solid, within: Scalar = MOST) -> Solid:
    """Simplify the colliders of a round solid; appearance and mass stay the same.

    A thin round shell, such as the wall of a bin, collides as one piece per facet; with a tolerance of 1 mm
    it needs less than half as many. The certificate holds for the coarser pieces.

    A coarser piece joins two or more facets of a circle. Where the tolerance does not permit two, as for a
    ring of more than about 0.2 m radius and 1 mm, the pieces stay as they are.

    Args:
        solid: A solid before anything is cut out of it.
        within: Largest distance of its colliders from the solid, at most 1 mm [m].

    Examples:
        >>> simplified_collider(tube(0.1, 0.098, 0.2))
    """


def faceted_shape(solid: Manifold, pieces: Pieces) -> Shape:
    """Return the shape of a plain manifold: normals split at creases, texture projected along them."""
    if solid.is_empty():
        raise ValueError("the result is empty")
    raw = solid.to_mesh64()
    places = np.array(raw.vert_properties)[:, :3]
    triangles = np.asarray(raw.tri_verts).astype(np.int64)
    corners = places[triangles]
    across = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(across, axis=1)
    flat = across / np.maximum(size, 1e-300)[:, None]
    normals = corner_normals(triangles, corners, CREASE)
    vertices = corners.reshape(-1, 3)
    uvs, side = boxed_uvs(vertices, np.repeat(flat, 3, axis=0), np.ptp(places, axis=0))
    table = np.column_stack([vertices, normals, uvs])
    _, first, group = distinct_rows(
        np.column_stack([triangles.ravel(), side, np.rint(normals * 1e6).astype(np.int64)])
    )
    kept = table[first]
    origin = triangles.ravel()[first]
    target = np.full(len(places), -1)
    target[origin[::-1]] = np.arange(len(first))[::-1]
    return Shape.from_mesh(
        kept[:, :3], kept[:, 3:6], kept[:, 6:8], group.reshape(-1, 3), pieces, targets=target[origin]
    )


_PAINT = 8  # column of the paint number in the vertex table
_PLANE_DECIMALS = 9  # decimals of normals and distances [m]
_FULL = 0.999  # least share of its hull that a convex solid fills
_ROUNDING = 1e-9  # tolerance of vertices on the faces of a cover [m]
_FILM = 1e-6  # thickness below which the part of a solid outside its covers is due to rounding [m]


def _paints(shapes: Sequence[Shape]) -> Mapping[int, Material]:
    """Return the paints of several shapes."""
    merged: dict[int, Material] = {}
    for shape in shapes:
        for number, material in shape.paints.items():
            if merged.setdefault(number, material) != material:
                raise ValueError(f"two different materials are both named {material.name!r}; rename one")
    return merged


def _combined(manifold: Manifold, pieces: colliders.Pieces, shapes: Sequence[Shape], empty: str) -> Shape:
    """Return a checked result; `empty` is the message for an empty result."""
    if manifold.is_empty():
        raise ValueError(empty)
    return Shape(manifold, pieces, _paints(shapes)).checked()


def united(shapes: Sequence[Shape]) -> Shape:
    """Return the union of shapes."""
    if not shapes:
        raise ValueError("a union needs at least one solid, got none")
    if len(shapes) == 1:
        return shapes[0]
    pieces = colliders.union(*(shape.pieces for shape in shapes))
    return UnitedShape(shapes, pieces, _paints(shapes))


def _union(solids: tuple[Shape, ...]) -> Shape:
    return united(solids)


@records(_union)
def union(*solids: Solid) -> Solid:
    """Unite solids; also written `a | b`. Overlaps count once.

    Examples:
        >>> union(box(0.3, 0.02, 0.02), box(0.02, 0.3, 0.02), sphere(0.04))
    """


def subtracted(a: Shape, b: Shape) -> Shape | None:
    """Return a shape without another; None if nothing is left."""
    rest = a.manifold - b.manifold
    if rest.is_empty():
        return None
    return Shape(rest, colliders.difference(a.pieces, b.pieces), _paints((a, b))).checked()


@kernel(spelling="({a} - {b})")
def _difference(a: Shape, b: Shape) -> Shape:
    rest = subtracted(a, b)
    if rest is None:
        raise ValueError("the difference is empty: the second solid contains the first")
    return rest


@kernel(spelling="({a} & {b})")
def _intersection(a: Shape, b: Shape) -> Shape:
    return _combined(
        a.manifold ^ b.manifold,
        colliders.intersection(a.pieces, b.pieces),
        (a, b),
        "the intersection is empty: the solids do not overlap",
    )


def _hull(solids: tuple[Shape, ...]) -> Shape:
    if not solids:
        raise ValueError("a hull needs at least one solid, got none")
    # those of united solids, whose union takes longer and has the same hull
    vertices = np.concatenate([member.vertices for shape in solids for member in shape.members])
    solid, pieces = hull_of(vertices), around_hull(lambda: vertices)
    if solid.is_empty():
        raise ValueError("the result is empty")
    return DeferredShape(lambda: faceted_shape(solid, pieces), pieces)  # many hulls are only colliders


@records(_hull)
def hull(*solids: Solid) -> Solid:
    """Return the convex hull of solids.

    Examples:
        >>> hull(cylinder(0.05, 0.03), cylinder(0.02, 0.03).at(0.15))
    """


def half_space(shape: Shape, point: Array, normal: Array) -> Shape:
    """Return a box that covers the part of a shape behind a plane; its top face lies on the plane."""
    low, high = shape.bounds()
    middle = 0.5 * (low + high)
    reach = 1.1 * _portable.norm(high - low) + abs(_portable.dot(middle - point, normal))
    turn = check.frame(normal)
    size = np.array([2.0 * reach, 2.0 * reach, reach])
    foot = middle - normal * _portable.dot(middle - point, normal)
    matrix = affine(turn, foot - normal * (reach / 2.0))
    box = rounded_box(size, 0.0, 0).shape(Exact((Convex.box(size),)))
    return box.transformed(matrix)


@kernel(spelling="{solid}.split(point={point}, normal={normal})")
def _split(solid: Shape, point: Array3, normal: Array3) -> Shape:
    across = check.direction("normal", normal)
    place = check.vector("point", point)
    behind = half_space(solid, place, -across)
    return _combined(
        solid.manifold ^ behind.manifold,
        colliders.intersection(solid.pieces, behind.pieces),
        (solid,),
        "nothing is left: the whole solid lies behind the plane",
    )


def _shell(solid: Shape, thickness: float, open: Array3 | None) -> Shape:
    check.positive("thickness", thickness)
    around = solid.manifold.hull()
    filled = solid.manifold.volume() / around.volume()
    if filled < _FULL:
        raise ValueError(
            f"shell needs a convex solid, this one fills only {100.0 * filled:.0f} % of its hull; "
            "subtract a smaller solid from it instead"
        )
    inner = _inset(around, thickness)
    if open is not None:
        out = check.direction("open", open)
        # far enough that rounded edges of the cavity end outside the solid
        inner = np.concatenate(
            [inner, inner + out * (thickness + float(np.ptp(_portable.product(solid.mesh.vertices, out))))]
        )
    cavity = faceted_shape(hull_of(inner), around_hull(lambda: inner))
    return _combined(
        solid.manifold - cavity.manifold,
        colliders.difference(solid.pieces, cavity.pieces),
        (solid,),
        "nothing is left of the shell",
    )


def _inset(solid: Manifold, distance: float) -> Array:
    """Return the corners of a convex solid with all faces moved inward, shape (n, 3) [m]."""
    # a face n.x <= d about an inner point becomes the point n / d; their hull has a face for each corner
    mesh = solid.to_mesh64()
    corners = np.array(mesh.vert_properties)[:, :3][triangles_of(mesh)]
    across = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(across, axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    sound = size > 1e-6 * longest**2
    normals = across[sound] / size[sound, None]
    reach = np.einsum("ij,ij->i", normals, corners[sound, 0]) - distance
    # triangles of one face share a plane: nearly equal planes would make slivers
    planes = np.unique(np.round(np.column_stack([normals, reach]), _PLANE_DECIMALS), axis=0)
    normals, reach = planes[:, :3], planes[:, 3]
    center = corners.reshape(-1, 3).mean(axis=0)
    if (reach - _portable.product(normals, center)).min() <= 1e-6:
        center = _deepest(normals, reach)
    depth = reach - _portable.product(normals, center)
    if depth.min() <= 1e-6:
        raise ValueError(
            f"thickness {distance:g} m leaves no cavity: the solid is only about "
            f"{2.0 * (distance + float(depth.min())):.3g} m thick"
        )
    dual = hull_of(normals / depth[:, None]).to_mesh64()
    faces = np.array(dual.vert_properties)[:, :3][triangles_of(dual)]
    poles = cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
    height = np.einsum("ij,ij->i", poles, faces[:, 0])
    area = np.linalg.norm(poles, axis=1)
    proper = area > 1e-12 * area.max()
    inside = center + poles[proper] / height[proper, None]
    _, first = np.unique(np.rint(inside * 1e6).astype(np.int64), axis=0, return_index=True)
    return np.ascontiguousarray(inside[np.sort(first)])


def _deepest(normals: Array, reach: Array) -> Array:
    """Return a point far from all planes n.x <= d, by steps away from the nearest planes, shape (3,)."""
    point: Array = _portable.product(
        _portable.inverse(_portable.product(normals.T, normals)), _portable.product(reach, normals)
    )
    step = float(np.abs(reach - _portable.product(normals, point)).max())
    best, best_depth = point, float((reach - _portable.product(normals, point)).min())
    for _ in range(200):
        depth = reach - _portable.product(normals, point)
        nearest = int(np.argmin(depth))
        if depth[nearest] > best_depth:
            best, best_depth = point, float(depth[nearest])
        point = point - normals[nearest] * step
        step *= 0.93
    return best


@records(_shell)
def shell(solid: Solid, thickness: Scalar, *, open: VectorLike | None = None) -> Solid:
    """Hollow a convex solid, leaving walls.

    Args:
        solid: A convex solid.
        thickness: Thickness of the walls [m].
        open: Direction of the side without a wall; by default all sides have walls.

    Examples:
        >>> shell(box(0.3, 0.2, 0.1, bevel=0.01), 0.008, open=Z)
    """


@kernel(spelling="{solid}.paint({material})")
def _paint(solid: Shape, material: Material) -> Shape:
    raw = solid.manifold.to_mesh64()
    table = np.array(raw.vert_properties)  # x y z and the channels of each vertex, shape (n, 9)
    table[:, _PAINT] = material.number
    painted = manifold_of(table, raw.tri_verts, raw.merge_from_vert, raw.merge_to_vert)
    return Shape(painted, solid.pieces, {material.number: material}).checked()


def _bounding_collider(solid: Shape, covers: tuple[Shape, ...] = ()) -> Shape:
    if not covers:
        around = around_hull(lambda: np.ascontiguousarray(solid.mesh.vertices))
        return Shape(solid.manifold, Pieces(around.outer, solid.pieces.inner), solid.paints)
    outer = colliders.union(*(cover.pieces for cover in covers)).outer
    declared = outer(TOLERANCE)
    if not all(any(_encloses(cover, member) for cover in declared) for member in solid.members):
        _check_contained(solid.manifold, declared)
    return Shape(solid.manifold, Pieces(outer, solid.pieces.inner, lambda: declared), solid.paints)


def _encloses(cover: Convex, solid: Shape) -> bool:
    """Tell whether a cover contains the bounding box and all vertices of a solid, and so the solid."""
    (low, high), (least, most) = cover.bounds(), solid.bounds()
    inside = (least >= low - _ROUNDING).all() and (most <= high + _ROUNDING).all()
    return bool(inside) and cover.outer_polytope(_FILM).contains(solid.vertices, _ROUNDING)


def _check_contained(solid: Manifold, covers: Sequence[Convex]) -> None:
    """Raise ValueError if a part of a solid lies outside its covers."""
    missing = Manifold.batch_boolean([solid, *(cover.manifold(_FILM) for cover in covers)], OpType.Subtract)
    # rounding leaves films along common faces; the thickness of a part is about twice its volume by its area
    parts = [part for part in missing.decompose() if 2.0 * part.volume() > _FILM * part.surface_area()]
    if not parts:
        return
    low, high = box_of(max(parts, key=lambda part: part.volume()))
    place = ", ".join(f"{value:.4g}" for value in (low + high) / 2.0)
    size = " x ".join(f"{1e3 * value:.3g}" for value in high - low)
    raise ValueError(
        f"the covers do not contain the solid: a part of {size} mm at ({place}) m lies outside; "
        "enlarge a cover there or add one"
    )


@records(_bounding_collider)
def bounding_collider(solid: Solid, *covers: Solid) -> Solid:
    """Use the convex hull of a solid, or coarse covers, as its colliders; appearance and mass stay the same.

    The hull suits fine structure, such as slats, grilles and knurls: it must be close to the solid. Covers
    may stand off from it at any distance, and `bounding_collider(solid, hull(solid))` declares that for the
    hull. The certificate holds for the covers, which are proven to contain the solid. Solids that are united
    with it later have their own colliders.

    Args:
        solid: The solid.
        *covers: Solids, such as boxes, that contain it together.

    Examples:
        >>> slats = array(box(0.01, 0.1, 0.02), at=row((0, 0, 0), (0.02, 0, 0), 10))
        >>> bounding_collider(slats | box(0.2, 0.005, 0.02).at(0.09))
        >>> bounding_collider(torus(0.1, 0.01), box(0.22, 0.22, 0.02))
    """


def poses(at: ArrayN3, around: Array3 | None) -> list[Array]:
    """Return the pose of each copy: at a point, and turned about an axis through the middle of the points."""
    places = check.points("at", at, 3, 1)
    if around is None:
        return [affine(np.eye(3), place) for place in places]
    axis = unit(around)
    spokes = places - places.mean(axis=0)
    spokes -= np.outer(_portable.product(spokes, axis), axis)
    short = np.flatnonzero(np.linalg.norm(spokes, axis=1) < 1e-9)
    if len(short):
        raise ValueError(
            f"point {short[0]} of at= lies on the axis around= through the middle of the points, so a copy "
            "has no direction there; leave around= out"
        )
    sines, cosines = (
        _portable.product(*each) for each in ((np.cross(spokes[0], spokes), axis), (spokes, spokes[0]))
    )
    turns = map(math.atan2, sines.tolist(), cosines.tolist())
    return [affine(rotation(axis, turn), place) for turn, place in zip(turns, places, strict=True)]


def _array(solid: Shape, at: ArrayN3, around: Array3 | None = None) -> Shape:
    copies = [solid.transformed(pose) for pose in poses(at, around)]
    if len(copies) == 1:
        return copies[0].checked()
    low, high = solid.bounds()
    if around is not None or not _are_apart(at, high - low):
        return united(copies)
    return ComposedShape(copies)


def _are_apart(places: Array, size: Array) -> bool:
    """Tell whether boxes of one size at several places are disjoint."""
    gap = np.abs(places[:, None, :] - places[None, :, :]) - size
    apart = gap.max(axis=2) > 1e-9
    np.fill_diagonal(apart, True)
    return bool(apart.all())


@records(_array)
def array(solid: Solid, *, at: PointsLike, around: VectorLike | None = None) -> Solid:
    """Copy a solid to several places as one solid; touching and overlapping copies are united.

    Args:
        at: Offset of each copy [m].
        around: Axis through the middle of the points about which the copies are turned like the points: the
            first one is not turned. By default none is turned.

    Examples:
        >>> array(box(0.02, 0.1, 0.05), at=row((0, 0, 0), (0.04, 0, 0), 5))
    """
