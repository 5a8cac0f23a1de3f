"""Exact differences and intersections of convex pieces."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, cached_property
from artgen.colliders.convex import Convex
from artgen.colliders.enclose import few_vertices
from artgen.colliders.polytope import SLIVER, SNAP, Polytope

_MANY = 128  # pieces with more vertices are enclosed in simpler ones before a cut
_FEW = 64  # vertices of these simpler pieces
_PARALLEL = 1e-12  # 1 - cosine below which a plane is perpendicular to a cylinder's axis


@dataclass(frozen=True, eq=False)
class Faceted:
    """A piece with the polytope that replaces it in cuts, computed on first access.

    Attributes:
        source: The original piece, if it is known.
        polytope: The polytope, if it is known.
        tolerance: Largest distance of the polytope from a round piece [m].
        inside: Whether the polytope is inside the piece instead of around it.
    """

    source: Convex | None = None
    polytope: Polytope | None = None
    tolerance: float = 0.0
    inside: bool = False

    @cached_property
    def shape(self) -> Polytope:
        """The polytope."""
        if self.polytope is not None:
            return self.polytope
        assert self.source is not None, "either the original piece or the polytope is given"
        if self.inside:
            return self.source.inner_polytope(self.tolerance)
        return self.source.outer_polytope(self.tolerance)

    @cached_property
    def bounds(self) -> Array:
        """Corners of the bounding box, shape (2, 3) [m]."""
        return self.shape.bounds if self.source is None else self.source.bounds()

    @property
    def is_large(self) -> bool:
        """Whether a cut of the piece takes long; simpler pieces around it may replace it."""
        return self.source is not None and not self.inside and len(self.source.points) > _MANY

    def simpler(self) -> list["Faceted"]:
        """Return pieces with few vertices around the piece."""
        assert self.source is not None
        few = few_vertices(self.source, _FEW, self.tolerance)
        return [Faceted(piece, tolerance=self.tolerance) for piece in few]

    def convex(self) -> Convex:
        """Return the piece."""
        return self.source or Convex.of(self.shape)


def subtract(pieces: Sequence[Faceted], cutters: Iterable[Faceted]) -> list[Faceted]:
    """Return the pieces without the cutters: cut pieces as few convex parts, the others unchanged."""
    rest = list(pieces)
    for cutter in cutters:
        touched = _near(rest, cutter.bounds)
        if not any(touched):
            continue
        remaining: list[Faceted] = []
        for near, piece in zip(touched, rest, strict=True):
            if not near:
                remaining.append(piece)
            elif piece.is_large:
                remaining.extend(subtract(piece.simpler(), [cutter]))
            else:
                parts = _without(piece, cutter.shape)
                remaining.extend([piece] if parts is None else parts)
        rest = remaining
    return rest


def intersect(pieces: Sequence[Faceted], others: Sequence[Faceted]) -> list[Faceted]:
    """Return the intersections of each piece with each of the others."""
    shared: list[Faceted] = []
    for other in others:
        for near, piece in zip(_near(pieces, other.bounds), pieces, strict=True):
            if near:
                common = _common(piece, other)
                if common is not None:
                    shared.append(common)
    return shared


def _near(pieces: Sequence[Faceted], bounds: Array) -> list[bool]:
    """Tell which pieces have a bounding box that overlaps a given one."""
    if not pieces:
        return []
    boxes = np.array([piece.bounds for piece in pieces])
    reach = (boxes[:, 1] > bounds[0] + SNAP) & (boxes[:, 0] < bounds[1] - SNAP)
    found: list[bool] = reach.all(axis=1).tolist()
    return found


def _without(piece: Faceted, cutter: Polytope) -> list[Faceted] | None:
    """Return the parts of a piece outside a cutter, or None if they have no common volume.

    The plane with the largest remaining part cuts first: large parts are separated whole, and only the
    neighborhood of the cutter is cut into small ones.
    """
    if (cutter.heights(piece.shape.planes).min(axis=1) >= -SLIVER).any():
        return None
    parts: list[Faceted] = []
    rest, planes = piece, cutter.planes
    while len(planes):
        heights = rest.shape.heights(planes)
        if (heights.min(axis=1) >= -SLIVER).any():
            return None
        reach = heights.max(axis=1)
        far = int(np.argmax(reach))
        if reach[far] <= SLIVER:
            break
        inside, outside = _split(rest, planes[far])
        if inside is None:
            return None
        if outside is not None and outside.shape.width >= SLIVER:
            parts.append(outside)
        rest = inside
        planes = np.delete(planes, far, axis=0)
    return parts if rest.shape.width >= SLIVER else None


def _common(piece: Faceted, other: Faceted) -> Faceted | None:
    """Return the intersection of two pieces; a piece inside the other is returned unchanged."""
    heights = piece.shape.heights(other.shape.planes)
    if (heights.min(axis=1) >= -SLIVER).any():
        return None
    if heights.max() <= SNAP:
        return piece
    if other.shape.heights(piece.shape.planes).max() <= SNAP:
        return other
    rest = piece
    for plane in other.shape.planes[heights.max(axis=1) > SNAP]:
        inside = _split(rest, plane)[0]
        if inside is None:
            return None
        rest = inside
    return rest if rest.shape.width >= SLIVER else None


def _split(piece: Faceted, plane: Array) -> tuple[Faceted | None, Faceted | None]:
    """Split a piece by a plane; a cut perpendicular to a cylinder's axis gives cylinders."""
    inside, outside = piece.shape.split(plane)
    if inside is piece.shape:
        return piece, None
    if outside is piece.shape:
        return None, piece
    cylinder = piece.source
    if cylinder is not None and cylinder.kind == "cylinder" and inside is not None and outside is not None:
        cosine = float(cylinder.pose[:3, 2] @ plane[:3])
        if 1.0 - abs(cosine) <= _PARALLEL:
            return _shortened(cylinder, inside), _shortened(cylinder, outside)
    return (
        None if inside is None else Faceted(polytope=inside),
        None if outside is None else Faceted(polytope=outside),
    )


def _shortened(cylinder: Convex, shape: Polytope) -> Faceted:
    """Return the part of a cylinder between the ends of its faceted part."""
    axis = cylinder.pose[:3, 2]
    along = (shape.points - cylinder.pose[:3, 3]) @ axis
    lower, upper = float(along.min()), float(along.max())
    pose = cylinder.pose.copy()
    pose[:3, 3] += axis * (lower + upper) / 2.0
    return Faceted(Convex("cylinder", pose, (cylinder.size[0], upper - lower)), shape)
