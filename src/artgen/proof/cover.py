"""The convex pieces on which joint ranges are proven, and how far a link's solids stick out of them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen._caching import FrozenArrays, cached_per_object
from artgen.asset import Link
from artgen.asset.link import MovedLink
from artgen.colliders import Convex
from artgen.colliders.polytope import Polytope
from artgen.proof.containment import excess

FINE = 2e-5
"""How far the polytopes around round pieces may stand off them [m]."""

_FILE_DECIMALS = 5e-8  # half the last digit of a mesh file [m]
_SINGLE = 2.0**-24  # relative error of single precision, in which USD keeps points


@dataclass(frozen=True, eq=False)
class Cover(FrozenArrays):
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
    return Cover(points, labels, _with_rounding(_collider_excess(source), points))


@cached_per_object
def _collider_excess(link: Link) -> float | None:
    """Return how far the solids stick out of the colliders; None if farther than 0.1 mm [m]."""
    pieces = [each.convex.outer_polytope(FINE) for each in link.colliders]
    return excess(link, pieces, tuple(each.label for each in link.colliders))


def fine_cover(link: Link) -> Cover:
    """Return pieces that follow the solids closely, however many; for a proof, not for a simulator."""
    pieces: list[Polytope] = []
    labels: list[str] = []
    for piece in link.pieces:
        if not piece.visual:
            outer = piece.shape.pieces.outer(FINE)
            pieces += [convex.outer_polytope(FINE) for convex in outer]
            labels += [piece.label] * len(outer)
    return _of_pieces(link, pieces, labels)


def stored_cover(link: Link, stored: Mapping[str, Any]) -> Cover:
    """Return pieces that were stored with a proof; they must contain the solids to 0.1 mm.

    What the solids stick out by is what was stored: meshes that were read from files show it less exactly.
    """
    if stored["points"] is None:
        cover = collider_cover(link)
    else:
        pieces = [Polytope.hull(np.array(each, float)) for each in stored["points"]]
        cover = _of_pieces(link, pieces, stored["labels"])
    if cover.excess is None:
        return cover
    known = cover.excess if link.pieces else 0.0
    return replace(cover, excess=max(float(stored["excess"]), known))


def _of_pieces(link: Link, pieces: Sequence[Polytope], labels: Sequence[str]) -> Cover:
    points = tuple(piece.points for piece in pieces)
    sticks_out = _with_rounding(excess(link, pieces, labels), points)
    return Cover(points, tuple(labels), sticks_out, colliders=False)


def polytope(convex: Convex) -> Array:
    """Return the vertices of a polytope around a convex piece, shape (n, 3) [m]."""
    return convex.points if convex.kind == "hull" else convex.outer_points(FINE)


def _with_rounding(sticks_out: float | None, points: Sequence[Array]) -> float | None:
    """Add what writing numbers to files may move a point by."""
    if sticks_out is None:
        return None
    farthest = max(float(np.abs(each).max()) for each in points)
    return sticks_out + _FILE_DECIMALS + _SINGLE * farthest
