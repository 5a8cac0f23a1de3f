"""Fidelity of convex pieces as a representation of a solid."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold, OpType

from artgen._arrays import Array
from artgen.asset.shells import TriangleSet, distinct_rows
from artgen.colliders import Convex
from artgen.colliders.polytope import Polytope
from artgen.colliders.triangles import hull_of

_FINE = 2.0e-5  # tolerance of the facets of round pieces [m]
_SPREAD = 300  # points on the surfaces of a difference, in addition to its corners
_DOUBTED = 1.0e-5  # tolerance of points of a difference on the solids [m]
_EMPTY = 0.03  # share of a hull's volume; smaller differences are rounded edges, not empty space


@dataclass(frozen=True)
class Fidelity:
    """Differences between convex pieces and their solid."""

    volume_error: float  # volume that only one of them has, as a share of the solid's
    # largest distance between the surfaces of pieces and solid, measured at corners and at several hundred
    # points between them [m]
    surface_error: float
    # share of the empty volume inside the solid's convex hull that the pieces leave empty
    interior_kept: float
    pieces: int  # number of pieces
    vertices: int  # number of their corners; a round piece has none
    added: float = 0.0  # volume that the pieces add, as a share of the solid's
    sticks_out: float = 0.0  # largest distance of the solid outside the pieces [m]
    place: tuple[float, float, float] = (0.0, 0.0, 0.0)  # place of that distance, shape (3,) [m]
    # place of the largest difference of the surfaces, shape (3,) [m]
    surface_place: tuple[float, float, float] = (0.0, 0.0, 0.0)


def fidelity(solid: Manifold, convexes: Sequence[Convex]) -> Fidelity:
    """Compare convex pieces with their solid."""
    polytopes = [convex.outer_polytope(_FINE) for convex in convexes]
    cover = Manifold.batch_boolean([hull_of(polytope.points) for polytope in polytopes], OpType.Add)
    excess, missing = cover - solid, solid - cover
    volume, hull, faces = solid.volume(), solid.hull(), TriangleSet.of(solid)
    outside, place = _sticking_out(missing, polytopes, faces)
    error, surface_place = outside, place
    if not excess.is_empty():
        # films along shared faces exceed the solid by rounding only
        points = TriangleSet.of(excess).spread(_SPREAD)
        points = points[_outside(polytopes, points) < _DOUBTED]
        apart, at = faces.farthest(points, outside=True) if len(points) else (0.0, place)
        if apart > error:
            error, surface_place = apart, at
    empty = hull.volume() - volume
    kept = (hull - cover).volume() - missing.volume()
    return Fidelity(
        volume_error=(excess.volume() + missing.volume()) / volume,
        surface_error=error,
        interior_kept=min(max(kept / empty, 0.0), 1.0) if empty > _EMPTY * hull.volume() else 1.0,
        pieces=len(convexes),
        vertices=sum(len(convex.faces.points) for convex in convexes if convex.kind in {"box", "hull"}),
        added=excess.volume() / volume,
        sticks_out=outside,
        place=_triple(place),
        surface_place=_triple(surface_place),
    )


def _sticking_out(
    missing: Manifold, polytopes: Sequence[Polytope], faces: TriangleSet
) -> tuple[float, Array]:
    """Return the largest distance of a solid outside its pieces, and its place.

    Distances are measured along face normals; films between pieces with a common face do not count.
    """
    if missing.is_empty():
        return 0.0, np.zeros(3)
    points, _, _ = distinct_rows(np.round(TriangleSet.of(missing).spread(_SPREAD), 8))
    outside = _outside(polytopes, points)
    worst = int(np.argmax(outside))
    # where many faces coincide, manifold3d may add volume to a difference that is in neither solid
    while outside[worst] > _DOUBTED and faces.farthest(points[[worst]], outside=True)[0] > _DOUBTED:
        outside[worst] = 0.0
        worst = int(np.argmax(outside))
    return max(float(outside[worst]), 0.0), points[worst]


def _outside(polytopes: Sequence[Polytope], points: Array) -> Array:
    """Return the height of points above the faces of the nearest polytope, shape (n,) [m]."""
    outside = np.full(len(points), np.inf)
    for polytope in polytopes:
        near = np.flatnonzero(_least_height(polytope, points) < outside)
        if len(near):
            height = (polytope.planes[:, :3] @ points[near].T - polytope.planes[:, 3:]).max(axis=0)
            outside[near] = np.minimum(outside[near], height)
    return outside


def _least_height(polytope: Polytope, points: Array) -> Array:
    """Return a lower bound of the height above faces for points outside a polytope, shape (n,) [m].

    A ray from the center to a point leaves the polytope within the circumscribed ball, through a face that is
    no nearer to the center than the inscribed ball. The bound is at most 0 for points inside.
    """
    middle = polytope.points.mean(axis=0)
    within = (polytope.planes[:, 3] - polytope.planes[:, :3] @ middle).min()
    around = np.linalg.norm(polytope.points - middle, axis=1).max()
    return np.asarray(within * (np.linalg.norm(points - middle, axis=1) / around - 1.0))


def _triple(point: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in point)
    return x, y, z
