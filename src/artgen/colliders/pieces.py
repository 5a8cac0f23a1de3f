"""Lazily evaluated convex covers of solids, combined like the solids."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence

import numpy as np

from artgen._arrays import Array, frozen
from artgen.colliders.convex import Convex
from artgen.colliders.enclose import few_vertices
from artgen.colliders.merge import joined
from artgen.colliders.polytope import is_rigid
from artgen.colliders.split import Facetted, intersect, subtract

Cover = tuple[Convex, ...]

_MANY = 10**9  # more than the vertices of any piece


class Pieces(ABC):
    """A convex cover of one solid, computed on first access and cached for each tolerance."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, float, int], Cover] = {}

    def outer(self, tolerance: float) -> Cover:
        """Return pieces whose union contains the solid.

        Args:
            tolerance: Largest distance of the pieces from round solids [m].

        Raises:
            ValueError: The tolerance is not positive.
        """
        return self._remembered(("outer", tolerance, 0), self._outer)

    def inner(self, tolerance: float) -> Cover:
        """Return pieces inside the solid.

        Args:
            tolerance: Largest distance of the pieces from round solids [m].

        Raises:
            ValueError: The tolerance is not positive.
        """
        return self._remembered(("inner", tolerance, 0), self._inner)

    def simplified(self, tolerance: float, most_vertices: int = 64) -> Cover:
        """Return the outer pieces, joined where that adds no volume, with a limit of vertices."""
        return self._remembered(
            ("simplified", tolerance, most_vertices), lambda limit: self._simplified(limit, most_vertices)
        )

    def transformed(self, matrix: Array) -> "Pieces":
        """Return the cover moved by an affine matrix, shape (4, 4)."""
        matrix = np.asarray(matrix, np.float64)
        if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
            raise ValueError(f"a transform must be a finite matrix of shape (4, 4), got {matrix.tolist()}")
        return _Transformed(self, matrix)

    @abstractmethod
    def _outer(self, tolerance: float) -> Cover:
        """Compute the pieces that contain the solid."""

    @abstractmethod
    def _inner(self, tolerance: float) -> Cover:
        """Compute the pieces inside the solid."""

    def _remembered(self, key: tuple[str, float, int], compute: Callable[[float], Cover]) -> Cover:
        tolerance = key[1]
        if not 0.0 < tolerance < float("inf"):
            raise ValueError(f"the tolerance of convex pieces must be positive, got {tolerance} m")
        if key not in self._known:
            self._known[key] = compute(tolerance)
        return self._known[key]

    def _simplified(self, tolerance: float, most_vertices: int) -> Cover:
        pieces = joined(self.outer(tolerance), most_vertices)
        return tuple(small for piece in pieces for small in few_vertices(piece, most_vertices, tolerance))


class Exact(Pieces):
    """Pieces that equal the solid.

    Args:
        convexes: The pieces.
    """

    def __init__(self, convexes: Sequence[Convex]) -> None:
        super().__init__()
        self._convexes = tuple(convexes)

    def _outer(self, tolerance: float) -> Cover:
        return self._convexes

    def _inner(self, tolerance: float) -> Cover:
        return self._convexes


class Bounded(Pieces):
    """Pieces computed by two functions of the tolerance.

    Args:
        outer: Function for the pieces that contain the solid, such as the `outer` of other pieces.
        inner: Function for the pieces inside the solid.
    """

    def __init__(self, outer: Callable[[float], Cover], inner: Callable[[float], Cover]) -> None:
        super().__init__()
        self._compute_outer = outer
        self._compute_inner = inner

    def _outer(self, tolerance: float) -> Cover:
        return tuple(self._compute_outer(tolerance))

    def _inner(self, tolerance: float) -> Cover:
        return tuple(self._compute_inner(tolerance))


class _Transformed(Pieces):
    def __init__(self, base: Pieces, matrix: Array) -> None:
        super().__init__()
        self._base = base
        self._matrix = frozen(matrix)
        linear = matrix[:3, :3]
        self._scale = 1.0
        if not is_rigid(linear):
            self._scale = float(np.linalg.norm(linear, 2))
        if not self._scale > 0.0:
            raise ValueError(f"pieces cannot be moved by a matrix that flattens them: {matrix.tolist()}")

    def transformed(self, matrix: Array) -> Pieces:
        return self._base.transformed(matrix @ self._matrix)

    def _outer(self, tolerance: float) -> Cover:
        fine = tolerance / self._scale
        return tuple(piece.transformed(self._matrix, fine) for piece in self._base.outer(fine))

    def _inner(self, tolerance: float) -> Cover:
        fine = tolerance / self._scale
        return tuple(piece.transformed(self._matrix, fine, inner=True) for piece in self._base.inner(fine))


class _Union(Pieces):
    def __init__(self, parts: Sequence[Pieces]) -> None:
        super().__init__()
        self._parts = tuple(parts)

    def _outer(self, tolerance: float) -> Cover:
        return tuple(piece for part in self._parts for piece in part.outer(tolerance))

    def _inner(self, tolerance: float) -> Cover:
        return tuple(piece for part in self._parts for piece in part.inner(tolerance))


class _Difference(Pieces):
    def __init__(self, solid: Pieces, cutter: Pieces) -> None:
        super().__init__()
        self._solid, self._cutter = solid, cutter

    def _outer(self, tolerance: float) -> Cover:
        around = [Facetted.around(piece, tolerance) for piece in self._solid.outer(tolerance)]
        return _cut(around, [Facetted.within(piece, tolerance) for piece in self._cutter.inner(tolerance)])

    def _inner(self, tolerance: float) -> Cover:
        within = [Facetted.within(piece, tolerance) for piece in self._solid.inner(tolerance)]
        return _cut(within, [Facetted.around(piece, tolerance) for piece in self._cutter.outer(tolerance)])


class _Intersection(Pieces):
    def __init__(self, first: Pieces, second: Pieces) -> None:
        super().__init__()
        self._first, self._second = first, second

    def _outer(self, tolerance: float) -> Cover:
        first, second = (
            [Facetted.around(piece, tolerance) for piece in pieces.outer(tolerance)]
            for pieces in (self._first, self._second)
        )
        return tuple(part.convex() for part in intersect(first, second))

    def _inner(self, tolerance: float) -> Cover:
        first, second = (
            [Facetted.within(piece, tolerance) for piece in pieces.inner(tolerance)]
            for pieces in (self._first, self._second)
        )
        return tuple(part.convex() for part in intersect(first, second))


def _cut(pieces: Sequence[Facetted], cutters: Sequence[Facetted]) -> Cover:
    """Subtract the cutters; fragments that form a convex piece are joined again."""
    rest = [part.convex() for part in subtract(pieces, cutters)]
    if len(cutters) > 1 and len(rest) > len(pieces):
        rest = joined(rest, _MANY)
    return tuple(rest)


def union(*pieces: Pieces) -> Pieces:
    """Return the cover of the union."""
    return pieces[0] if len(pieces) == 1 else _Union(pieces)


def difference(solid: Pieces, cutter: Pieces) -> Pieces:
    """Return the cover of a solid without a cutter; exact if the cutter's pieces are."""
    return _Difference(solid, cutter)


def intersection(first: Pieces, second: Pieces) -> Pieces:
    """Return the cover of the intersection of two solids."""
    return _Intersection(first, second)
