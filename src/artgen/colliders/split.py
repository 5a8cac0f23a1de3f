"""Exact differences and intersections of convex pieces, and joining of pieces that form a convex one."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from artgen import _portable
from artgen._arrays import Array, Mask, cached_property
from artgen.colliders.convex import Convex
from artgen.colliders.enclose import few_vertices
from artgen.colliders.polytope import SLIVER, SNAP, Polytope

THIN = 0.0005
"""Width below which contacts with a piece are unreliable in simulators [m]."""

_CUTS = 32  # parts behind so many cuts stay thin: finely faceted cutters leave hundreds of them
_MANY = 300  # pieces with more vertices are enclosed in simpler ones before a cut
_FEW = 64  # vertices of these simpler pieces
_SAME = 1e-7  # faces nearer than this are one face seen from both sides [m]
_DIRECTION = np.array([0.5364, 0.6312, 0.5603])  # a direction that no construction prefers
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
    """Return the parts of a piece outside a cutter, or None if they have no common volume."""
    # the plane with the largest rest cuts first; a part that would be thin overlaps the parts before it
    if (cutter.heights(piece.shape.planes).min(axis=1) >= -SLIVER).any():
        return None
    parts: list[Faceted] = []
    rest, planes, before = piece, cutter.planes, [piece]
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
            parts.append(_thicker(outside, planes[far], before))
        rest = inside
        before.append(rest)
        planes = np.delete(planes, far, axis=0)
    return parts if rest.shape.width >= SLIVER else None


def _thicker(part: Faceted, plane: Array, before: Sequence[Faceted]) -> Faceted:
    """Return a part outside a plane; a thin one is cut from what was left 1, 2, 4 and more cuts before."""
    if part.shape.width >= THIN or len(before) > _CUTS:
        return part
    steps = [*(1 << power for power in range(1, (len(before) - 1).bit_length())), len(before)]
    larger = (_split(before[-step], plane)[1] for step in steps)
    return next((each for each in larger if each is not None and each.shape.width >= THIN), part)


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
        cosine = _portable.dot(cylinder.pose[:3, 2], plane[:3])
        if 1.0 - abs(cosine) <= _PARALLEL:
            return _shortened(cylinder, inside), _shortened(cylinder, outside)
    return (
        None if inside is None else Faceted(polytope=inside),
        None if outside is None else Faceted(polytope=outside),
    )


def _shortened(cylinder: Convex, shape: Polytope) -> Faceted:
    """Return the part of a cylinder between the ends of its faceted part."""
    axis = cylinder.pose[:3, 2]
    along = _portable.product(shape.points - cylinder.pose[:3, 3], axis)
    lower, upper = float(along.min()), float(along.max())
    pose = cylinder.pose.copy()
    pose[:3, 3] += axis * (lower + upper) / 2.0
    return Faceted(Convex("cylinder", pose, (cylinder.size[0], upper - lower)), shape)


def joined(pieces: Sequence[Convex], most_vertices: int) -> list[Convex]:
    """Drop pieces inside others and join pairs whose hull adds no volume.

    Two pieces with one common whole face, each behind the other faces of the other, form one convex solid;
    the largest faces are tried first.
    """
    rest = _outermost(pieces)
    while True:
        taken: set[int] = set()
        fresh: list[Convex] = []
        for first, second in _meeting(rest, most_vertices):
            if first in taken or second in taken:
                continue
            hull = hull_within(rest[first].faces, rest[second].faces, most_vertices)
            if hull is not None:
                taken.update((first, second))
                fresh.append(Convex.of(hull))
        if not fresh:
            return rest
        rest = [piece for index, piece in enumerate(rest) if index not in taken] + fresh


def hull_within(first: Polytope, second: Polytope, most_vertices: int) -> Polytope | None:
    """Return the hull of two pieces if it has few enough vertices."""
    hull = Polytope.hull(np.concatenate((first.points, second.points)))
    return hull if len(hull.points) <= most_vertices else None


def _outermost(pieces: Sequence[Convex]) -> list[Convex]:
    """Return the pieces that do not lie inside another piece; of equal pieces the first."""
    if len(pieces) < 2:
        return list(pieces)
    boxes = np.array([piece.bounds() for piece in pieces])
    above = (boxes[:, None, 0] >= boxes[None, :, 0] - _SAME).all(axis=2)
    below = (boxes[:, None, 1] <= boxes[None, :, 1] + _SAME).all(axis=2)
    within: Mask = np.logical_and(above, below)
    np.fill_diagonal(within, False)
    dropped: set[int] = set()
    for small, large in np.argwhere(within).tolist():
        if small in dropped or large in dropped or pieces[large].kind not in ("box", "hull"):
            continue
        if pieces[large].faces.contains(pieces[small].outer_points(), _SAME):
            dropped.add(small)
    return [piece for index, piece in enumerate(pieces) if index not in dropped]


def _meeting(pieces: Sequence[Convex], most_vertices: int) -> list[tuple[int, int]]:
    """Return the pairs that join without added volume, those with the largest common face first."""
    # hulls without known faces have far more vertices than a joined piece may have
    flat = [
        index
        for index, piece in enumerate(pieces)
        if piece.kind == "box" or (piece.kind == "hull" and piece.polytope is not None)
    ]
    if len(flat) < 2:
        return []
    shapes = [pieces[index].faces for index in flat]
    sizes = [len(shape.planes) for shape in shapes]
    owner = np.repeat(np.arange(len(flat)), sizes)
    face = np.concatenate([np.arange(size) for size in sizes])
    means = np.concatenate([shape.face_means for shape in shapes])
    spreads = np.concatenate([shape.face_spreads for shape in shapes])
    normals = np.concatenate([shape.planes[:, :3] for shape in shapes])
    along = _portable.product(means, _DIRECTION)
    order = np.argsort(along, kind="stable")
    along = along[order]
    pairs: list[tuple[float, int, int]] = []
    for shift in range(1, len(order)):
        close = np.flatnonzero(along[shift:] - along[:-shift] <= _SAME)
        if not len(close):
            break
        left, right = order[close], order[close + shift]
        same = np.abs(means[left] - means[right]).max(axis=1) <= _SAME
        same &= np.sum(normals[left] * normals[right], axis=1) <= -1.0 + _SAME
        same &= np.abs(spreads[left] - spreads[right]) <= _SAME * (1.0 + spreads[left])
        for one, two in zip(left[same].tolist(), right[same].tolist(), strict=True):
            first, second = int(owner[one]), int(owner[two])
            corners = 2 * np.count_nonzero(shapes[first].contact[:, face[one]])
            if len(shapes[first].points) + len(shapes[second].points) - corners > most_vertices:
                continue  # only edges of the common face may vanish
            if _behind(shapes[first], shapes[second], face[one]) and _behind(
                shapes[second], shapes[first], face[two]
            ):
                pairs.append((-float(spreads[one]), flat[min(first, second)], flat[max(first, second)]))
    return [(first, second) for _, first, second in sorted(pairs)]


def _behind(shape: Polytope, other: Polytope, common: int) -> bool:
    """Tell whether another polytope lies behind all faces of a shape but the common one."""
    planes = np.delete(shape.planes, common, axis=0)
    return bool(other.heights(planes).max() <= _SAME)
