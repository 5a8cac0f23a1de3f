"""Joining of convex pieces: always if it adds no volume, and with little volume to meet a budget."""

import heapq
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.colliders.convex import Convex
from artgen.colliders.polytope import Polytope
from artgen.colliders.split import Faceted, subtract

_SAME = 1e-7  # faces nearer than this are one face seen from both sides [m]
_DIRECTION = np.array([0.5364, 0.6312, 0.5603])  # a direction that no construction prefers


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
            hull = _hull(rest[first].faces, rest[second].faces, most_vertices)
            if hull is not None:
                taken.update((first, second))
                fresh.append(Convex.of(hull))
        if not fresh:
            return rest
        rest = [piece for index, piece in enumerate(rest) if index not in taken] + fresh


def _hull(first: Polytope, second: Polytope, most_vertices: int) -> Polytope | None:
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
    within: NDArray[np.bool_] = np.logical_and(above, below)
    np.fill_diagonal(within, False)
    dropped: set[int] = set()
    for small, large in np.argwhere(within).tolist():
        if small in dropped or large in dropped or pieces[large].kind not in ("box", "hull"):
            continue
        if pieces[large].faces.contains(pieces[small].outer_points(), _SAME):
            dropped.add(small)
    return [piece for index, piece in enumerate(pieces) if index not in dropped]


def _meeting(pieces: Sequence[Convex], most_vertices: int) -> list[tuple[int, int]]:
    """Return the pairs that join without added volume, those with the largest common face first.

    Hulls without known faces have far more vertices than a joined piece may have.
    """
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
    along = means @ _DIRECTION
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


class Condenser:
    """Pieces of several groups that are joined step by step, smallest added volume first.

    A pair of one group is joined only if its hull is within about `margin` [m] of the group's pieces: wider
    cavities stay open.
    """

    def __init__(self, groups: Sequence[Sequence[Convex]], most_vertices: int, margin: float) -> None:
        self._most_vertices = most_vertices
        self._margin = margin
        self._solid = [[piece.faces for piece in group] for group in groups]
        self._inflated: dict[tuple[int, int], Polytope] = {}
        self._alive: dict[int, tuple[int, Convex]] = {}
        self._queue: list[tuple[float, int, int, Polytope]] = []
        self._next = 0
        for number, group in enumerate(groups):
            for piece in group:
                self._add(number, piece)

    def run(self, most_pieces: int) -> list[list[Convex]]:
        """Join pairs until all groups together meet the budget or no pair is left; return the groups."""
        while len(self._alive) > most_pieces and self._queue:
            _, first, second, hull = heapq.heappop(self._queue)
            if first not in self._alive or second not in self._alive:
                continue
            group = self._alive[first][0]
            if self._covered(group, hull):
                del self._alive[first], self._alive[second]
                self._add(group, Convex.of(hull))
        result: list[list[Convex]] = [[] for _ in self._solid]
        for group, piece in self._alive.values():
            result[group].append(piece)
        return result

    def _add(self, group: int, piece: Convex) -> None:
        """Add a piece, and the pairs with its neighbors to the queue."""
        number, self._next = self._next, self._next + 1
        box = piece.bounds()
        for other, (its_group, neighbor) in self._alive.items():
            if its_group != group or not _overlap(neighbor.bounds(), box, self._margin):
                continue
            hull = _hull(piece.faces, neighbor.faces, self._most_vertices)
            if hull is not None:
                added = hull.volume - piece.volume - neighbor.volume
                heapq.heappush(self._queue, (added, other, number, hull))
        self._alive[number] = (group, piece)

    def _covered(self, group: int, hull: Polytope) -> bool:
        """Tell whether a hull is within the margin of the group's solid."""
        left = [Faceted(polytope=hull)]
        for index, shape in enumerate(self._solid[group]):
            if not _overlap(shape.bounds, hull.bounds, self._margin):
                continue
            key = (group, index)
            if key not in self._inflated:
                self._inflated[key] = shape.inflated(self._margin)
            left = subtract(left, [Faceted(polytope=self._inflated[key])])
            if not left:
                return True
        return False


def _overlap(first: Array, second: Array, margin: float) -> bool:
    """Tell whether two bounding boxes are within the margin [m] of each other."""
    return bool((first[0] <= second[1] + margin).all() and (second[0] <= first[1] + margin).all())
