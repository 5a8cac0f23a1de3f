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
class Facetted:
    """A piece with the polytope that replaces it in cuts, computed on first access.

    Attributes:
        kept: The original piece, if it is known.
        known: The polytope, if it is known.
        tolerance: Largest distance of the polytope from a round piece [m].
        inside: Whether the polytope is inside the piece instead of around it.
    """

    kept: Convex | None = None
    known: Polytope | None = None
    tolerance: float = 0.0
    inside: bool = False

    @cached_property
    def shape(self) -> Polytope:
        """The polytope."""
        if self.known is not None:
            return self.known
        assert self.kept is not None, "a piece needs a polytope or the solid for which it stands in"
        if self.inside:
            return self.kept.inner_polytope(self.tolerance)
        return self.kept.outer_polytope(self.tolerance)

    @cached_property
    def bounds(self) -> Array:
        """Corners of the bounding box, shape (2, 3) [m]."""
        return self.shape.bounds if self.kept is None else self.kept.bounds()

    @property
    def is_large(self) -> bool:
        """Whether a cut of the piece takes long; simpler pieces around it may replace it."""
        return self.kept is not None and not self.inside and len(self.kept.points) > _MANY

    def simpler(self) -> list["Facetted"]:
        """Return pieces with few vertices around the piece."""
        assert self.kept is not None
        few = few_vertices(self.kept, _FEW, self.tolerance)
        return [Facetted(piece, tolerance=self.tolerance) for piece in few]

    def convex(self) -> Convex:
        """Return the piece."""
        return self.kept or Convex.of(self.shape)


def subtract(pieces: Sequence[Facetted], cutters: Iterable[Facetted]) -> list[Facetted]:
    """Return the pieces without the cutters: cut pieces as few convex parts, the others unchanged."""
    rest = list(pieces)
    for cutter in cutters:
        touched = _near(rest, cutter.bounds)
        if not any(touched):
            continue
        kept: list[Facetted] = []
        for near, piece in zip(touched, rest, strict=True):
            if not near:
                kept.append(piece)
            elif piece.is_large:
                kept.extend(subtract(piece.simpler(), [cutter]))
            else:
                parts = _without(piece, cutter.shape)
                kept.extend([piece] if parts is None else parts)
        rest = kept
    return rest


def intersect(pieces: Sequence[Facetted], others: Sequence[Facetted]) -> list[Facetted]:
    """Return the intersections of each piece with each of the others."""
    shared: list[Facetted] = []
    for other in others:
        for near, piece in zip(_near(pieces, other.bounds), pieces, strict=True):
            if near:
                common = _common(piece, other)
                if common is not None:
                    shared.append(common)
    return shared


def _near(pieces: Sequence[Facetted], bounds: Array) -> list[bool]:
    """Tell which pieces have a bounding box that overlaps a given one."""
    if not pieces:
        return []
    boxes = np.array([piece.bounds for piece in pieces])
    reach = (boxes[:, 1] > bounds[0] + SNAP) & (boxes[:, 0] < bounds[1] - SNAP)
    found: list[bool] = reach.all(axis=1).tolist()
    return found


def _without(piece: Facetted, cutter: Polytope) -> list[Facetted] | None:
    """Return the parts of a piece outside a cutter, or None if they have no common volume.

    The plane with the largest remaining part cuts first: large parts are separated whole, and only the
    neighborhood of the cutter is cut into small ones.
    """
    if (cutter.heights(piece.shape.planes).min(axis=1) >= -SLIVER).any():
        return None
    parts: list[Facetted] = []
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


def _common(piece: Facetted, other: Facetted) -> Facetted | None:
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


def _split(piece: Facetted, plane: Array) -> tuple[Facetted | None, Facetted | None]:
    """Split a piece by a plane; a cut perpendicular to a cylinder's axis gives cylinders."""
    inside, outside = piece.shape.split(plane)
    if inside is piece.shape:
        return piece, None
    if outside is piece.shape:
        return None, piece
    cylinder = piece.kept
    if cylinder is not None and cylinder.kind == "cylinder" and inside is not None and outside is not None:
        cosine = float(cylinder.pose[:3, 2] @ plane[:3])
        if 1.0 - abs(cosine) <= _PARALLEL:
            return _shortened(cylinder, inside), _shortened(cylinder, outside)
    return (
        None if inside is None else Facetted(known=inside),
        None if outside is None else Facetted(known=outside),
    )


def _shortened(cylinder: Convex, shape: Polytope) -> Facetted:
    """Return the part of a cylinder between the ends of its faceted part."""
    axis = cylinder.pose[:3, 2]
    along = (shape.points - cylinder.pose[:3, 3]) @ axis
    lower, upper = float(along.min()), float(along.max())
    pose = cylinder.pose.copy()
    pose[:3, 3] += axis * (lower + upper) / 2.0
    return Facetted(Convex("cylinder", pose, (cylinder.size[0], upper - lower)), shape)
