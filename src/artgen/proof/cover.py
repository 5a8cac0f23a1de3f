"""Convex pieces on which joint ranges are proven, and their distance to the solids of a link."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from manifold3d import Manifold

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Indices, Mask, boxes_of, cached_per_object
from artgen.asset import Asset, Link
from artgen.asset.collision import link_parts
from artgen.asset.link import MovedLink, ReducedLink
from artgen.asset.shape import Shape
from artgen.colliders import TOLERANCE, Convex, Exact
from artgen.colliders.polytope import Polytope
from artgen.colliders.triangles import hull_of

_ROUNDING = 1e-9  # tolerance of vertices on faces of their piece [m]
_EXACT = 1e-6  # largest excess of such a solid at edges of a tenth of a degree [m]
_FILM = 2e-6  # first growth of pieces: films of 1 micrometre between pieces are common [m]
_MORE = (2e-6, 2e-5, 1e-4)  # later growths in all directions, which create more faces and take longer [m]
_FARTHEST = 3.0  # corners of sharp edges move at most this many growths
_SLACK = 0.2  # a corner of many faces moves at least this share of their growth
_AROUND = np.concatenate((np.eye(3), -np.eye(3)))
_HELD = 1e-5  # links in empty slots move by less, and spare colliders lie this deep in others [rad or m]
_DUST = 1e-15  # volume of a solid that rounding may leave uncovered [m^3]
_MOST_WHOLE = 2  # number of pieces that are tried one by one before all together


_Labels = Sequence[tuple[str, ...]]  # labels of the solids that each piece may contain


def _excess(link: Link, pieces: Sequence[Polytope], labels: _Labels) -> float | None:
    """Return a distance from labelled pieces that contains all solids of a link; None beyond 0.1 mm [m]."""
    around = _Pieces.of(pieces, labels)
    parts = [(label, solid) for label, solid in _parts(link) if not around.enclose(label, solid)]
    if not parts:
        return _EXACT
    for grow, length in ((_with_moved_faces, _FILM), *((_with_margin, margin) for margin in _MORE)):
        grown = _Grown(around, grow, length)
        parts = [(label, solid) for label, solid in parts if not grown.contain(label, solid)]
        if not parts:
            return grown.farthest
    return None


def _parts(link: Link) -> Iterator[tuple[str, Shape]]:
    """Yield label and shape of solids whose union is the link, the smallest known parts."""
    if not link.pieces:
        yield from ((part.label, Shape(part.solid, Exact(()))) for part in link_parts(link))
    for piece in link.solids:
        yield from ((piece.label, member) for member in piece.shape.members)


@dataclass(frozen=True, eq=False)
class _Pieces:
    """Convex pieces with their bounding boxes, which limit the pieces to examine for a solid."""

    pieces: Sequence[Polytope]  # the pieces
    labels: _Labels  # labels of each piece
    low: Array  # lowest corner of each box, shape (n, 3) [m]
    high: Array  # highest corner of each box, shape (n, 3) [m]

    @staticmethod
    def of(pieces: Sequence[Polytope], labels: _Labels) -> "_Pieces":
        """Collect pieces."""
        return _Pieces(pieces, labels, *boxes_of([each.points for each in pieces]))

    def enclose(self, label: str, solid: Shape) -> bool:
        """Tell whether all vertices of a solid lie in one piece, which then contains it."""
        around = self.around(label, solid, _ROUNDING).tolist()
        points = solid.vertices if around else np.empty((0, 3))
        return any(self.pieces[index].contains(points, _ROUNDING) for index in around)

    def around(self, label: str, solid: Shape, length: float) -> Indices:
        """Return the pieces of a label whose boxes, grown by a length [m], contain the box of a solid."""
        least, most = solid.bounds()
        # a piece with another label may have allowed contacts that this solid does not have
        inside = (self.low - length <= least).all(axis=1) & (self.high + length >= most).all(axis=1)
        return np.flatnonzero(self._labelled(label) & inside)

    def near(self, label: str, solid: Shape, length: float) -> Indices:
        """Return the pieces of a label whose boxes, grown by a length [m], overlap the box of a solid."""
        least, most = solid.bounds()
        meets = (self.low - length < most).all(axis=1) & (self.high + length > least).all(axis=1)
        return np.flatnonzero(self._labelled(label) & meets)

    def _labelled(self, label: str) -> Mask:
        return np.array([label in each for each in self.labels])


@dataclass(eq=False)
class _Grown:
    """Pieces that are grown on demand."""

    pieces: _Pieces  # the pieces before
    grow: Callable[[Polytope, float], tuple[Array, float]]  # returns vertices and largest displacement [m]
    length: float  # growth [m]
    farthest: float = 0.0  # largest displacement of a vertex so far [m]
    _solids: dict[int, Manifold] = field(default_factory=dict)

    def contain(self, label: str, solid: Shape) -> bool:
        """Tell whether the pieces contain a solid."""
        whole = self.pieces.around(label, solid, self.length)[:_MOST_WHOLE].tolist()
        if any(self._cover(solid.manifold, [index]) for index in whole):
            return True
        return self._cover(solid.manifold, self.pieces.near(label, solid, _FARTHEST * self.length).tolist())

    def _cover(self, solid: Manifold, chosen: Sequence[int]) -> bool:
        """Tell whether the pieces cover a solid, by subtracting them."""
        rest = solid.set_properties(0, lambda *_: None)  # normals and paint only take time
        for group in self._apart(chosen):
            # separate pieces need no boolean with each other
            rest -= Manifold.compose([self._solid(index) for index in group])
            if rest.is_empty() or rest.volume() < _DUST:
                return True
        return False

    def _solid(self, index: int) -> Manifold:
        if index not in self._solids:
            points, moved = self.grow(self.pieces.pieces[index], self.length)
            self._solids[index] = hull_of(points)
            self.farthest = max(self.farthest, moved)
        return self._solids[index]

    def _apart(self, chosen: Sequence[int]) -> Iterator[list[int]]:
        """Yield groups of pieces whose boxes do not overlap."""
        margin = _FARTHEST * self.length
        low, high = self.pieces.low[chosen] - margin, self.pieces.high[chosen] + margin
        meets = np.all((low[:, None] <= high[None]) & (low[None] <= high[:, None]), axis=2)
        left = list(range(len(chosen)))
        while left:
            group: list[int] = []
            for index in left:
                if not meets[index, group].any():
                    group.append(index)
            left = [index for index in left if index not in group]
            yield [chosen[index] for index in group]


def _with_moved_faces(piece: Polytope, growth: float) -> tuple[Array, float]:
    """Return the vertices of a piece with moved faces, shape (n, 3), and their longest displacement [m]."""
    # each vertex moves to the new meeting point of its faces; with more than three, by least squares
    normals = piece.planes[:, :3]
    touching = piece.contact.astype(np.float64)
    products = (normals[:, :, None] * normals[:, None, :]).reshape(-1, 9)
    shift = np.einsum(
        "nij,nj->ni",
        _portable.inverse(_portable.product(touching, products).reshape(-1, 3, 3)),
        _portable.product(touching, normals),
    )
    least = np.where(piece.contact, _portable.product(shift, normals.T), np.inf).min(axis=1)
    length = np.sqrt(np.sum(shift * shift, axis=1))
    step = np.minimum(growth / np.maximum(least, _SLACK), _FARTHEST * growth / length)
    return piece.points + step[:, None] * shift, float((step * length).max())


def _with_margin(piece: Polytope, margin: float) -> tuple[Array, float]:
    """Return the vertices of a piece with a margin along each axis, shape (6 n, 3), and the margin [m]."""
    return (piece.points[:, None] + margin * _AROUND).reshape(-1, 3), margin


FINE = 2e-5  # largest distance between a round piece and the polytope around it [m]
_FILE_DECIMALS = 5e-8  # half the last digit of a mesh file [m]
_SINGLE = 2.0**-24  # relative error of single precision, in which USD keeps points


@dataclass(frozen=True, eq=False)
class Cover(FrozenArrays):
    """Convex pieces whose union contains the solids of a link."""

    points: tuple[Array, ...]  # vertices of each piece in asset coordinates at rest, each shape (n, 3) [m]
    labels: tuple[str, ...]  # semantic label of each
    # largest distance of the solids, as written to files, outside the pieces; None above 0.1 mm [m]
    excess: float | None
    colliders: bool = True  # whether the pieces are the colliders of the link


@cached_per_object
def collider_cover(link: Link) -> Cover:
    """Return the colliders of a link as polytopes that contain them."""
    convexes = [collider.convex for collider in link.colliders]
    points = tuple(each.points if each.kind == "hull" else _around(each).points for each in convexes)
    source: Link = link
    while isinstance(source, MovedLink | ReducedLink):
        source = source.source
    # no contact names the labels of several solids: their common piece may touch nothing
    labels = tuple("+".join((collider.label, *collider.joined)) for collider in link.colliders)
    return Cover(points, labels, _with_rounding(_collider_excess(source), points))


@cached_per_object
def _around(convex: Convex) -> Polytope:
    """Return the polytope around a piece: searches and containment need the same one."""
    return convex.outer_polytope(FINE)


@cached_per_object
def _collider_excess(link: Link) -> float | None:
    """Return the largest distance of the solids outside the colliders; None above 0.1 mm [m]."""
    pieces = [_around(each.convex) for each in link.colliders]
    return _excess(link, pieces, [(each.label, *each.joined) for each in link.colliders])


@cached_per_object
def fine_cover(link: Link) -> Cover:
    """Return many pieces that follow the solids closely, for proofs rather than simulators."""
    pieces = [
        (convex.outer_polytope(FINE), piece.label)
        for piece in link.solids
        for convex in piece.shape.pieces.outer(FINE)
    ]
    return _of_pieces(link, [polytope for polytope, _ in pieces], [label for _, label in pieces])


def stored_cover(link: Link, stored: Mapping[str, Any]) -> Cover:
    """Return pieces that were stored with a proof; they must contain the solids to 0.1 mm.

    The stored excess is used: meshes from files represent the solids less exactly.
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
    excess = _with_rounding(_excess(link, pieces, [(label,) for label in labels]), points)
    return Cover(points, tuple(labels), excess, colliders=False)


def _with_rounding(excess: float | None, points: Sequence[Array]) -> float | None:
    """Add the largest displacement of a point by the rounding of files."""
    if excess is None:
        return None
    return excess + _FILE_DECIMALS + _SINGLE * max(float(np.abs(each).max()) for each in points)


def slot_hosts(asset: Asset) -> tuple[dict[str, str], list[tuple[str, str]]]:
    """Return where spare colliders lie: they touch nothing that the collider around them does not touch.

    Returns:
        For each link that fills an empty slot the nearest present link above it; and the link of each spare
        collider that is not proven to stay inside one collider of the present link, with the reason.
    """
    hosts: dict[str, str] = {}
    faults = []
    above = {child: (parent, joints) for parent, child, joints in asset.pairs()}
    for link in asset.links:
        host = link.name
        if link.absent:
            parent, joints = above[link.name]
            host = hosts[link.name] = hosts.get(parent, parent)
            loose = [each.name for each in joints if max(map(abs, each.limits or (np.inf,))) >= 0.1 * _HELD]
            faults += [(link.name, f"joint {name!r} of an empty slot moves") for name in loose]
        spares = [each.convex for each in link.colliders if each.spare]
        around = [each.convex for each in asset.link(host).colliders if spares and not each.spare]
        for number, spare in enumerate(spares):
            points = spare.outer_points()
            if not any(each.inner_polytope(TOLERANCE).contains(points, -_HELD) for each in around):
                faults.append((link.name, f"spare collider {number} is not inside a collider of {host!r}"))
    return hosts, faults
