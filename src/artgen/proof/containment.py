"""How far solids stick out of the convex pieces around them, by booleans with pieces grown a little."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from artgen._arrays import Array, Indices
from artgen.asset import Link
from artgen.asset.shape import Shape
from artgen.asset.stored_solids import link_parts
from artgen.colliders import Exact
from artgen.colliders.hull import hull_of
from artgen.colliders.polytope import Polytope

_ROUNDING = 1e-9  # of the vertices of a solid and the faces of its piece [m]
_EXACT = 1e-6  # what sticks out of a piece then at most, at edges of a tenth of a degree [m]
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
    around = _Pieces.of(pieces, labels)
    parts = [(label, solid) for label, solid in _parts(link) if not around.enclose(label, solid)]
    if not parts:
        return _EXACT
    ways = ((_with_moved_faces, _FILM), *((_with_margin, margin) for margin in _MORE))
    for grow, length in ways:
        grown = _Grown(around, grow, length)
        parts = [(label, solid) for label, solid in parts if not grown.contain(label, solid)]
        if not parts:
            return grown.farthest
    return None


def _parts(link: Link) -> Iterator[tuple[str, Shape]]:
    """Yield label and shape of solids whose union is the link, as small as they are known."""
    if not link.pieces:
        yield from ((part.label, Shape(part.solid, Exact(()))) for part in link_parts(link))
    for piece in link.pieces:
        if not piece.visual:
            yield from ((piece.label, member) for member in piece.shape.members)


@dataclass(frozen=True, eq=False)
class _Pieces:
    """Convex pieces with their boxes, so that few of them are looked at for a solid."""

    pieces: Sequence[Polytope]  # the pieces
    labels: NDArray[np.str_]  # label of each, shape (n,)
    low: Array  # lowest corner of each one's box, shape (n, 3) [m]
    high: Array  # highest corner, shape (n, 3) [m]

    @staticmethod
    def of(pieces: Sequence[Polytope], labels: Sequence[str]) -> "_Pieces":
        """Collect pieces."""
        low, high = (np.array([end(each.points, axis=0) for each in pieces]) for end in (np.min, np.max))
        return _Pieces(pieces, np.array(labels), low, high)

    def enclose(self, label: str, solid: Shape) -> bool:
        """Tell whether all vertices of a solid lie in one piece, which then contains it."""
        around = self.around(label, solid, _ROUNDING)
        if not len(around):
            return False
        points = solid.vertices
        return any(
            float((points @ planes[:, :3].T - planes[:, 3]).max()) <= _ROUNDING
            for planes in (self.pieces[index].planes for index in around)
        )

    def around(self, label: str, solid: Shape, length: float) -> Indices:
        """Return the pieces of a label whose boxes, grown by a length [m], contain that of a solid."""
        least, most = solid.bounds()
        # a piece of another label may be allowed to touch what this must not
        inside = (self.low - length <= least).all(axis=1) & (self.high + length >= most).all(axis=1)
        return np.flatnonzero((self.labels == label) & inside)

    def near(self, label: str, solid: Shape, length: float) -> Indices:
        """Return the pieces of a label whose boxes, grown by a length [m], meet that of a solid."""
        least, most = solid.bounds()
        meets = (self.low - length < most).all(axis=1) & (self.high + length > least).all(axis=1)
        return np.flatnonzero((self.labels == label) & meets)


class _Grown:
    """Pieces that are grown when they are needed.

    Attributes:
        farthest: How far a vertex was moved at most so far [m].
    """

    def __init__(
        self, around: _Pieces, grow: Callable[[Polytope, float], tuple[Array, float]], length: float
    ) -> None:
        self.farthest = 0.0
        self._around, self._grow, self._length = around, grow, length
        self._solids: dict[int, Manifold] = {}

    def contain(self, label: str, solid: Shape) -> bool:
        """Tell whether the pieces contain a solid."""
        whole = self._around.around(label, solid, self._length)
        if any(self._cover(solid.manifold, [int(index)]) for index in whole[:_MOST_WHOLE]):
            return True
        return self._cover(solid.manifold, self._around.near(label, solid, _FARTHEST * self._length).tolist())

    def _cover(self, solid: Manifold, chosen: Sequence[int]) -> bool:
        """Tell whether nothing is left of a solid without some of the pieces."""
        rest = solid
        for group in self._apart(chosen):
            # pieces that are apart need no boolean among themselves
            rest -= Manifold.compose([self._solid(index) for index in group])
            if rest.is_empty() or rest.volume() < _DUST:
                return True
        return False

    def _solid(self, index: int) -> Manifold:
        if index not in self._solids:
            points, moved = self._grow(self._around.pieces[index], self._length)
            self._solids[index] = hull_of(points)
            self.farthest = max(self.farthest, moved)
        return self._solids[index]

    def _apart(self, chosen: Sequence[int]) -> Iterator[list[int]]:
        """Yield groups of pieces whose boxes do not meet."""
        margin = _FARTHEST * self._length
        low, high = self._around.low[chosen] - margin, self._around.high[chosen] + margin
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
