"""How far solids stick out of the convex pieces around them, by booleans with pieces grown a little."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from artgen.asset import Link
from artgen.check.stored_solids import link_parts
from artgen.colliders.polytope import Polytope

Array = NDArray[np.float64]

_FILM = 2e-6  # pieces are grown by this at first; films of 1 micrometre between them are usual [m]
_MORE = (2e-6, 2e-5, 1e-4)  # and then all around by these, which makes more faces and takes longer [m]
_FARTHEST = 3.0  # corners of sharp edges move no farther than that many growths
_SLACK = 0.2  # a corner of many faces goes at most that much less far than they do
_AROUND = np.concatenate((np.eye(3), -np.eye(3)))
_DUST = 1e-15  # volume that rounding leaves of a solid [m^3]
_MOST_WHOLE = 2  # pieces that are tried alone before all of them together


def excess(link: Link, pieces: Sequence[Polytope], labels: Sequence[str]) -> float | None:
    """Return a distance within which of some pieces all of a link's solids are; None beyond 0.1 mm [m].

    Args:
        link: The link.
        pieces: Convex pieces, at rest in asset coordinates.
        labels: Label of each: the solids of that label are most likely in it.
    """
    parts = list(_parts(link))
    ways = ((_with_moved_faces, _FILM), *((_with_margin, margin) for margin in _MORE))
    for grow, length in ways:
        around = _Grown.of([grow(piece, length) for piece in pieces], labels)
        parts = [(label, solid) for label, solid in parts if not around.contain(label, solid)]
        if not parts:
            return around.farthest
    return None


def _parts(link: Link) -> Iterator[tuple[str, Manifold]]:
    """Yield label and surface of solids whose union is the link, as small as they are known."""
    if not link.pieces:
        yield from ((part.label, part.solid) for part in link_parts(link))
    for piece in link.pieces:
        if not piece.visual:
            yield from ((piece.label, member.manifold) for member in piece.shape.members)


@dataclass(frozen=True, eq=False)
class _Grown:
    """Pieces that are grown, with their boxes, so that few of them are looked at for a solid.

    Attributes:
        points: Vertices of each piece [m].
        labels: Label of each, shape (n,).
        low: Lowest corner of each one's box, shape (n, 3) [m].
        high: Highest corner, shape (n, 3) [m].
        farthest: How far a vertex was moved at most [m].
    """

    points: Sequence[Array]
    labels: NDArray[np.str_]
    low: Array
    high: Array
    farthest: float

    @staticmethod
    def of(pieces: Sequence[tuple[Array, float]], labels: Sequence[str]) -> "_Grown":
        """Collect pieces and how far their vertices were moved."""
        points, moved = zip(*pieces, strict=True)
        low, high = (np.array([end(each, axis=0) for each in points]) for end in (np.min, np.max))
        return _Grown(points, np.array(labels), low, high, max(moved))

    def contain(self, label: str, solid: Manifold) -> bool:
        """Tell whether the pieces contain a solid."""
        least, most = np.array(solid.bounding_box()).reshape(2, 3)
        own = self.labels == label  # a piece of another label may be allowed to touch what this must not
        whole = own & (self.low <= least).all(axis=1) & (self.high >= most).all(axis=1)
        if any(self._cover(solid, [int(index)]) for index in np.flatnonzero(whole)[:_MOST_WHOLE]):
            return True
        near = own & (self.low < most).all(axis=1) & (self.high > least).all(axis=1)
        return self._cover(solid, np.flatnonzero(near).tolist())

    def _cover(self, solid: Manifold, chosen: Sequence[int]) -> bool:
        """Tell whether nothing is left of a solid without some of the pieces."""
        rest = solid
        for group in self._apart(chosen):
            # pieces that are apart need no boolean among themselves
            rest -= Manifold.compose([Manifold.hull_points(self.points[index]) for index in group])
            if rest.is_empty() or rest.volume() < _DUST:
                return True
        return False

    def _apart(self, chosen: Sequence[int]) -> Iterator[list[int]]:
        """Yield groups of pieces whose boxes do not meet."""
        low, high = self.low[chosen], self.high[chosen]
        meets: NDArray[np.bool_] = np.all((low[:, None] <= high[None]) & (low[None] <= high[:, None]), axis=2)
        left = list(range(len(chosen)))
        while left:
            group: list[int] = []
            for index in left:
                if not meets[index, group].any():
                    group.append(index)
            left = [index for index in left if index not in group]
            yield [chosen[index] for index in group]


def _with_moved_faces(piece: Polytope, growth: float) -> tuple[Array, float]:
    """Return the vertices of a piece whose faces moved outwards, shape (n, 3), and their longest way [m].

    Each vertex goes where its faces meet anew, in the sense of least squares where they are more than three.
    """
    normals = piece.planes[:, :3]
    touching = piece.contact.astype(np.float64)
    products = (normals[:, :, None] * normals[:, None, :]).reshape(-1, 9)
    way = np.linalg.solve((touching @ products).reshape(-1, 3, 3), (touching @ normals)[:, :, None])[:, :, 0]
    least = np.where(piece.contact, way @ normals.T, np.inf).min(axis=1)
    length = np.sqrt(np.sum(way * way, axis=1))
    step = np.minimum(growth / np.maximum(least, _SLACK), _FARTHEST * growth / length)
    return piece.points + step[:, None] * way, float((step * length).max())


def _with_margin(piece: Polytope, margin: float) -> tuple[Array, float]:
    """Return the vertices of a piece with a margin along each axis, shape (6 n, 3), and the margin [m]."""
    return (piece.points[:, None] + margin * _AROUND).reshape(-1, 3), margin
