"""One convex piece around each solid, whatever it closes; what most tools make of a mesh."""

from collections.abc import Sequence

import numpy as np

from artgen._arrays import Array
from artgen.colliders.convex import TOLERANCE, Convex
from artgen.colliders.enclose import Facets, enclosing


def single_hull(points: Array, most_vertices: int = 64) -> Convex:
    """Return the convex hull of points, shape (n, 3) [m], or a polytope of fewer vertices around it.

    The order of the points does not show.

    Raises:
        ValueError: The points are fewer than four, not finite, or lie in one plane.
    """
    piece = Convex.hull(points)
    if piece.kind != "hull" or len(piece.points) <= most_vertices:
        return piece
    return Convex.hull(enclosing(Facets.hull(piece.points), most_vertices, TOLERANCE)[0])


def fewest(
    pieces: Sequence[Convex], most_pieces: int, most_vertices: int = 64
) -> list[tuple[Convex, tuple[int, ...]]]:
    """Join pieces until they are few enough, those first whose common bounding box adds least.

    Args:
        pieces: The pieces; with few enough vertices each.
        most_pieces: How many there may be, at least 1.
        most_vertices: How many vertices a joined piece may have.

    Returns:
        Each piece with the numbers of those that it stands for.
    """
    groups: list[tuple[int, ...]] = [(number,) for number in range(len(pieces))]
    boxes = np.array([piece.bounds() for piece in pieces]).reshape(-1, 2, 3)
    while len(groups) > most_pieces:
        lower = np.minimum(boxes[:, None, 0], boxes[None, :, 0])
        upper = np.maximum(boxes[:, None, 1], boxes[None, :, 1])
        volume = np.prod(boxes[:, 1] - boxes[:, 0], axis=1)
        added = np.prod(upper - lower, axis=2) - volume[:, None] - volume
        added[np.tril_indices(len(groups))] = np.inf
        first, second = divmod(int(np.argmin(added)), len(groups))
        groups[first] += groups.pop(second)
        boxes[first] = (lower[first, second], upper[first, second])
        boxes = np.delete(boxes, second, axis=0)
    return [(_around([pieces[number] for number in group], most_vertices), group) for group in groups]


def _around(pieces: Sequence[Convex], most_vertices: int) -> Convex:
    if len(pieces) == 1:
        return pieces[0]
    return single_hull(np.concatenate([piece.outer_points() for piece in pieces]), most_vertices)
