"""The convex pieces on which joint ranges are proven, and how far a link's solids stick out of them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from manifold3d import Manifold, OpType
from numpy.typing import NDArray

from artgen.asset import Link
from artgen.asset.link import MovedLink
from artgen.check.stored_solids import link_parts
from artgen.colliders import Convex

Array = NDArray[np.float64]

FINE = 2e-5
"""How far the polytopes around round pieces may stand off them [m]."""

_ALLOWANCES = (
    2e-6,
    2e-5,
    1e-4,
)  # what solids may stick out of the pieces; films of 1 micrometre are usual [m]
_ALONG_AXES = np.concatenate((np.eye(3), -np.eye(3)))
_FILE_DECIMALS = 5e-8  # half the last digit of a mesh file [m]
_SINGLE = 2.0**-24  # relative error of single precision, in which USD keeps points
_DUST = 1e-15  # [m^3]
_MOST_WHOLE = 2  # pieces that are tried alone before all of them together

_EXCESS: "WeakKeyDictionary[Link, float | None]" = WeakKeyDictionary()


@dataclass(frozen=True, eq=False)
class Cover:
    """Convex pieces whose union contains the solids of a link.

    Attributes:
        points: Vertices of each piece in asset coordinates at rest, each shape (n, 3) [m].
        labels: Semantic label of each.
        excess: How far the solids, as they are written to files, may stick out; None if farther than 0.1 mm
            [m].
        colliders: Whether the pieces are the link's colliders.
    """

    points: tuple[Array, ...]
    labels: tuple[str, ...]
    excess: float | None
    colliders: bool = True


def collider_cover(link: Link) -> Cover:
    """Return the colliders of a link as polytopes, round ones with facets outside."""
    colliders = link.colliders
    points = tuple(polytope(collider.convex) for collider in colliders)
    labels = tuple(collider.label for collider in colliders)
    source: Link = link
    while isinstance(source, MovedLink):
        source = source.source
    if source not in _EXCESS:
        around = points if source is link else tuple(polytope(each.convex) for each in source.colliders)
        _EXCESS[source] = _excess(source, around, labels)
    return Cover(points, labels, _with_rounding(_EXCESS[source], points))


def fine_cover(link: Link) -> Cover:
    """Return pieces that follow the solids closely, however many; for a proof, not for a simulator."""
    points: list[Array] = []
    labels: list[str] = []
    for piece in link.pieces:
        if not piece.visual:
            outer = piece.shape.pieces.outer(FINE)
            points += [polytope(convex) for convex in outer]
            labels += [piece.label] * len(outer)
    return Cover(
        tuple(points), tuple(labels), _with_rounding(_excess(link, points, labels), points), colliders=False
    )


def stored_cover(link: Link, stored: Mapping[str, Any]) -> Cover:
    """Return pieces that were stored with a proof; they must contain the solids to 0.1 mm.

    What the solids stick out by is what was stored: meshes that were read from files show it less exactly,
    and do not tell what has neither mass nor collider.
    """
    if stored["points"] is None:
        cover = collider_cover(link)
        points, labels, excess = cover.points, cover.labels, cover.excess
    else:
        points, labels = tuple(np.array(each, float) for each in stored["points"]), tuple(stored["labels"])
        excess = _with_rounding(_excess(link, points, labels), points)
    if excess is not None:
        excess = max(float(stored["excess"]), excess if link.pieces else 0.0)
    return Cover(points, labels, excess, colliders=stored["points"] is None)


def polytope(convex: Convex) -> Array:
    """Return the vertices of a polytope around a convex piece, shape (n, 3) [m]."""
    return convex.points if convex.kind == "hull" else convex.outer_points(FINE)


def _with_rounding(excess: float | None, points: Sequence[Array]) -> float | None:
    """Add what writing numbers to files may move a point by."""
    if excess is None:
        return None
    farthest = max(float(np.abs(each).max()) for each in points)
    return excess + _FILE_DECIMALS + _SINGLE * farthest


def _excess(link: Link, points: Sequence[Array], labels: Sequence[str]) -> float | None:
    """Return a length by which the pieces have to grow to contain the link's solids [m]."""
    parts = [(part.label, part.solid) for part in link_parts(link)]
    around = _Boxed.of(points, labels)
    for allowance in _ALLOWANCES:
        parts = [(label, solid) for label, solid in parts if not around.contains(label, solid, allowance)]
        if not parts:
            return allowance
    return None


@dataclass(frozen=True, eq=False)
class _Boxed:
    """Pieces with their boxes, so that few of them are looked at for a solid.

    Attributes:
        points: Vertices of each piece [m].
        labels: Label of each, shape (n,).
        low: Lowest corner of its box, shape (n, 3) [m].
        high: Highest corner, shape (n, 3) [m].
    """

    points: Sequence[Array]
    labels: NDArray[np.str_]
    low: Array
    high: Array

    @staticmethod
    def of(points: Sequence[Array], labels: Sequence[str]) -> "_Boxed":
        low, high = (np.array([end(each, axis=0) for each in points]) for end in (np.min, np.max))
        return _Boxed(points, np.array(labels), low, high)

    def contains(self, label: str, solid: Manifold, allowance: float) -> bool:
        """Tell whether the pieces, grown by an allowance [m] along the axes, contain a solid."""
        least, most = np.array(solid.bounding_box()).reshape(2, 3)
        whole = (self.low <= least + allowance).all(axis=1) & (self.high >= most - allowance).all(axis=1)
        for index in np.flatnonzero(whole)[:_MOST_WHOLE]:
            if self._covered(solid, [int(index)], allowance):
                return True
        near = (self.low < most + allowance).all(axis=1) & (self.high > least - allowance).all(axis=1)
        own = near & (self.labels == label)  # mostly these will do
        choices = (own, near) if own.any() and (own != near).any() else (near,)
        return any(self._covered(solid, np.flatnonzero(chosen).tolist(), allowance) for chosen in choices)

    def _covered(self, solid: Manifold, chosen: Sequence[int], allowance: float) -> bool:
        """Tell whether nothing is left of a solid without some of the pieces."""
        grown = [
            Manifold.hull_points((self.points[index][:, None] + allowance * _ALONG_AXES).reshape(-1, 3))
            for index in chosen
        ]
        rest = Manifold.batch_boolean([solid, *grown], OpType.Subtract)
        return bool(rest.is_empty() or rest.volume() < _DUST)
