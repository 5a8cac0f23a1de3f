"""The final collider set of solids: few pieces with few vertices."""

import heapq
from collections.abc import Sequence

import numpy as np

from artgen._arrays import Array, affine
from artgen.colliders.coacd import single_hull
from artgen.colliders.convex import TOLERANCE, Convex
from artgen.colliders.pieces import Cover, Pieces
from artgen.colliders.polytope import Polytope
from artgen.colliders.split import Faceted, hull_within, subtract

COARSEST = 0.0015  # largest tolerance for solids that need too many pieces [m]
_COARSER = (0.0005, 0.00075, 0.001, COARSEST)  # tolerances for solids that need too many pieces [m]
_MARGIN = 0.001  # largest distance of joined pieces from the solid [m]
_INWARD = (0.1, 0.5, 1.0)  # shares of the way from the faces of a hull to its middle
_SURE = 1e-5  # distance beyond which a point is certainly outside a piece [m]
_LITTLE = 1.05  # volume of a primitive around joined pieces, in volumes of their hull, at most
_GROWN = 1e-9  # distance by which a primitive exceeds the pieces, for rounding [m]
_MOST_FRAMES = 4  # most frames in which primitives are tried


def budgeted(solids: Sequence[Pieces], *, most_pieces: int = 64, most_vertices: int = 64) -> list[Cover]:
    """Return convex pieces around each of several solids, within the common budget of a simulator.

    Round pieces are faceted to 0.25 mm. Over the budget, the solids with the most pieces are faceted to
    0.5 mm, 0.75 mm, 1 mm, then 1.5 mm. Then pieces are joined as long as their hull stays within about 1 mm
    of the solid. Cavities are never closed.

    Args:
        solids: The solids.
        most_pieces: Largest number of pieces of all solids together.
        most_vertices: Largest number of vertices of a hull.

    Raises:
        ValueError: The solids need more pieces.
    """
    if most_pieces < 1 or most_vertices < 8:
        raise ValueError(
            f"a budget needs at least 1 piece and 8 vertices, got {most_pieces} and {most_vertices}"
        )
    covers = [solid.simplified(TOLERANCE, most_vertices) for solid in solids]
    fewest = sum(map(len, covers))
    for limit in _COARSER:
        for number in sorted(range(len(covers)), key=lambda number: (-len(covers[number]), number)):
            if fewest <= most_pieces:
                return covers
            coarser = solids[number].simplified(limit, most_vertices)
            if len(coarser) < len(covers[number]):
                fewest -= len(covers[number]) - len(coarser)
                covers[number] = coarser
    if fewest <= most_pieces:
        return covers
    merged = _Condenser(covers, most_vertices).run(most_pieces)
    count = sum(map(len, merged))
    if count > most_pieces:
        raise ValueError(
            f"the solid needs {fewest} convex pieces, {count} after joining those that seal no cavity; "
            f"at most {most_pieces} are allowed: cut fewer or simpler holes, or let fine solids collide "
            "coarsely by bounding_collider(solid, box(...))"
        )
    return [tuple(group) for group in merged]


class _Condenser:
    """Pieces of several groups that are joined step by step, smallest added volume first."""

    # joins a pair of one group only within about 1 mm of its pieces: wider cavities stay open

    def __init__(self, groups: Sequence[Sequence[Convex]], most_vertices: int) -> None:
        self._most_vertices = most_vertices
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
            if its_group != group or not _overlap(neighbor.bounds(), box):
                continue
            hull = hull_within(piece.faces, neighbor.faces, self._most_vertices)
            if hull is not None:
                added = hull.volume - piece.volume - neighbor.volume
                heapq.heappush(self._queue, (added, other, number, hull))
        self._alive[number] = (group, piece)

    def _covered(self, group: int, hull: Polytope) -> bool:
        """Tell whether a hull is within the margin of the group's solid."""
        near = []
        for index, shape in enumerate(self._solid[group]):
            if _overlap(shape.bounds, hull.bounds):
                key = (group, index)
                if key not in self._inflated:
                    self._inflated[key] = shape.inflated(_MARGIN)
                near.append(self._inflated[key])
        # points inside the hull: most hulls that close a cavity have one outside all pieces
        faces, middle = hull.face_means, hull.points.mean(axis=0)
        points = np.concatenate([faces + share * (middle - faces) for share in _INWARD])
        for shape in near:
            outside = (shape.planes[:, :3] @ points.T - shape.planes[:, 3:]).max(axis=0, initial=-np.inf)
            points = points[outside > _SURE]
        if len(points):
            return False
        left = [Faceted(polytope=hull)]
        for shape in sorted(near, key=lambda shape: -_common(shape.bounds, hull.bounds)):
            left = subtract(left, [Faceted(polytope=shape)])
            if not left:
                return True
        return False


def _common(first: Array, second: Array) -> float:
    """Return the volume that two bounding boxes share [m^3]; large shares leave few parts to examine."""
    return float(np.prod(np.minimum(first[1], second[1]) - np.maximum(first[0], second[0]), initial=1.0))


def _overlap(first: Array, second: Array) -> bool:
    """Tell whether two bounding boxes are within the margin of each other."""
    return bool((first[0] <= second[1] + _MARGIN).all() and (second[0] <= first[1] + _MARGIN).all())


def around(pieces: Sequence[Convex], most_vertices: int = 64) -> list[Convex]:
    """Return convex pieces that each contain several pieces: the hull last, before it a primitive.

    The primitive is the smallest of several boxes, cylinders and capsules along the axes of the asset and of
    the pieces. It is left out if it adds more than a twentieth to the volume of the hull.
    """
    points = np.concatenate([piece.outer_points() for piece in pieces])
    hull = single_hull(points, most_vertices)
    if hull.kind == "box":
        return [hull]
    frames: list[Array] = [np.eye(3)]
    for piece in sorted(pieces, key=lambda piece: -round(piece.volume, 12)):
        turn = piece.pose[:3, :3]
        if len(frames) < _MOST_FRAMES and all(np.abs(turn - frame).max() > _GROWN for frame in frames):
            frames.append(turn)
    found = [shape for frame in frames for shape in _primitives(points, frame)]
    least = min(found, key=lambda shape: round(shape.volume, 12))
    return [least, hull] if least.volume <= _LITTLE * hull.volume else [hull]


def _primitives(points: Array, turn: Array) -> list[Convex]:
    """Return a box around points, and a cylinder and a capsule along each axis of a frame."""
    local = points @ turn
    low, high = local.min(axis=0) - _GROWN, local.max(axis=0) + _GROWN
    middle, size = (low + high) / 2.0, high - low
    result = [Convex.box(size, affine(turn, turn @ middle))]
    for axis in range(3):
        order = [(axis + 1) % 3, (axis + 2) % 3, axis]
        x, y, z = (local - middle)[:, order].T
        away = np.hypot(x, y)
        radius = float(away.max()) + _GROWN
        pose = affine(turn[:, order], turn[:, order] @ middle[order])
        result.append(Convex.cylinder(radius, float(size[axis]), pose))
        half = float((np.abs(z) - np.sqrt(radius**2 - away**2)).max()) + _GROWN
        if half > 0.0:
            result.append(Convex.capsule(radius, 2.0 * half, pose))
    return result
