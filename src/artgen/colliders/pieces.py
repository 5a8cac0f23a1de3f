"""Convex covers of solids, evaluated on first access and combined like the solids."""

from collections.abc import Callable, Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array, frozen
from artgen.colliders.convex import Convex
from artgen.colliders.enclose import few_vertices
from artgen.colliders.polytope import is_rigid
from artgen.colliders.split import Faceted, intersect, joined, subtract

Cover = tuple[Convex, ...]

_MANY = 10**9  # more than the vertices of any piece
_DEEPEST = 200  # operations of a chain; each takes four of Python's thousand nested calls
_LITTLE = 0.97  # share of the cover of a round solid below which a cut keeps the closer one
_ADDED = 1.015  # volume of a cover, in volumes of a closer one, above which a cut keeps the closer one


class Pieces:
    """A convex cover of one solid, computed on first access and cached for each tolerance.

    Args:
        outer: Function of the tolerance for the pieces that contain the solid.
        inner: Function of the tolerance for the pieces inside the solid.
        declared: Function that returns the pieces within which the outer ones may stand off from the solid.
        closer: Pieces with finer shapes for cuts that leave little of the solid, such as the walls of a cup.
        combined: Pieces that the functions use.

    Raises:
        ValueError: The solid is the last of a long chain of operations.
    """

    def __init__(
        self,
        outer: Callable[[float], Cover],
        inner: Callable[[float], Cover],
        declared: Callable[[], Cover] = tuple,
        closer: "Pieces | None" = None,
        combined: Sequence["Pieces"] = (),
    ) -> None:
        self._outer, self._inner, self.declared, self.closer = outer, inner, declared, closer
        self._depth: int = 1 + max((each._depth for each in combined), default=0)
        if self._depth > _DEEPEST:
            raise ValueError(
                f"it ends a chain of more than {_DEEPEST} operations, each on the result of the one before: "
                "take many solids at once, as in union(*solids) or solid - union(*cutters)"
            )
        self._known: dict[tuple[str, float, int], Cover] = {}

    def outer(self, tolerance: float) -> Cover:
        """Return pieces whose union contains the solid.

        Args:
            tolerance: Largest distance of the pieces from round solids [m].

        Raises:
            ValueError: The tolerance is not positive.
        """
        return self._cached(("outer", tolerance, 0), self._outer)

    def inner(self, tolerance: float) -> Cover:
        """Return pieces inside the solid.

        Args:
            tolerance: Largest distance of the pieces from round solids [m].

        Raises:
            ValueError: The tolerance is not positive.
        """
        return self._cached(("inner", tolerance, 0), self._inner)

    def simplified(self, tolerance: float, most_vertices: int = 64) -> Cover:
        """Return the outer pieces, joined where that adds no volume, with a limit of vertices."""

        def compute(tolerance: float) -> Cover:
            pieces = joined(self.outer(tolerance), most_vertices)
            return tuple(small for piece in pieces for small in few_vertices(piece, most_vertices, tolerance))

        return self._cached(("simplified", tolerance, most_vertices), compute)

    def transformed(self, matrix: Array) -> "Pieces":
        """Return the cover moved by an affine matrix, shape (4, 4)."""
        matrix = np.asarray(matrix, np.float64)
        if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
            raise ValueError(f"a transform must be a finite matrix of shape (4, 4), got {matrix.tolist()}")
        return _Transformed(self, matrix)

    def _cached(self, key: tuple[str, float, int], compute: Callable[[float], Cover]) -> Cover:
        tolerance = key[1]
        if not 0.0 < tolerance < float("inf"):
            raise ValueError(f"the tolerance of convex pieces must be positive, got {tolerance} m")
        if key not in self._known:
            self._known[key] = tuple(compute(tolerance))
        return self._known[key]


class Exact(Pieces):
    """Pieces that equal the solid.

    Args:
        convexes: The pieces.
    """

    def __init__(self, convexes: Sequence[Convex]) -> None:
        cover = tuple(convexes)
        super().__init__(lambda _: cover, lambda _: cover)


class _Transformed(Pieces):
    """Moved pieces; a further motion multiplies the matrices."""

    def __init__(self, base: Pieces, matrix: Array) -> None:
        linear = matrix[:3, :3]
        scale = 1.0 if is_rigid(linear) else _portable.eigenvectors(linear.T @ linear)[0][-1] ** 0.5
        if not scale > 0.0:
            raise ValueError(f"pieces cannot be moved by a matrix that flattens them: {matrix.tolist()}")
        self._base, self._matrix = base, frozen(matrix)

        def outer(tolerance: float) -> Cover:
            fine = tolerance / scale
            return tuple(piece.transformed(matrix, fine) for piece in base.outer(fine))

        def inner(tolerance: float) -> Cover:
            fine = tolerance / scale
            return tuple(piece.transformed(matrix, fine, inner=True) for piece in base.inner(fine))

        closer = base.closer and base.closer.transformed(matrix)
        super().__init__(
            outer,
            inner,
            lambda: tuple(piece.transformed(matrix) for piece in base.declared()),
            closer,
            [base],
        )

    def transformed(self, matrix: Array) -> Pieces:
        return self._base.transformed(matrix @ self._matrix)


class _United(Pieces):
    """The cover of a union; unions of unions have one level, so that long chains do not recurse."""

    def __init__(self, members: Sequence[Pieces]) -> None:
        closer = [part.closer or part for part in members] if any(part.closer for part in members) else ()
        super().__init__(
            lambda tolerance: tuple(piece for part in members for piece in part.outer(tolerance)),
            lambda tolerance: tuple(piece for part in members for piece in part.inner(tolerance)),
            lambda: tuple(piece for part in members for piece in part.declared()),
            union(*closer) if closer else None,
            members,
        )
        self.members = tuple(members)


def union(*pieces: Pieces) -> Pieces:
    """Return the cover of the union."""
    if len(pieces) == 1:
        return pieces[0]
    return _United([each for part in pieces for each in getattr(part, "members", (part,))])


def difference(solid: Pieces, cutter: Pieces) -> Pieces:
    """Return the cover of a solid without a cutter; exact if the cutter's pieces are."""
    closer = difference(solid.closer, cutter) if solid.closer else None
    return Pieces(
        lambda tolerance: _closer(
            _cut(_outside(solid, tolerance), _inside(cutter, tolerance)), closer, solid, tolerance
        ),
        lambda tolerance: _cut(_inside(solid, tolerance), _outside(cutter, tolerance)),
        solid.declared,
        closer,
        [solid, cutter],
    )


def intersection(first: Pieces, second: Pieces) -> Pieces:
    """Return the cover of the intersection of two solids."""

    def common(one: list[Faceted], two: list[Faceted]) -> Cover:
        return tuple(part.convex() for part in intersect(one, two))

    close = [each.closer or each for each in (first, second)]
    closer = intersection(*close) if first.closer or second.closer else None
    return Pieces(
        lambda tolerance: _closer(
            common(_outside(first, tolerance), _outside(second, tolerance)), closer, first, tolerance
        ),
        lambda tolerance: common(_inside(first, tolerance), _inside(second, tolerance)),
        lambda: first.declared() + second.declared(),
        closer,
        [first, second],
    )


def _closer(cover: Cover, closer: Pieces | None, solid: Pieces, tolerance: float) -> Cover:
    """Return the cover of a cut solid, or a closer one with less volume; round solids get it at once."""
    if closer is None:
        return cover
    other, whole = closer.outer(tolerance), solid.outer(tolerance)
    faceted = any(piece.kind not in ("box", "hull") for piece in whole)
    thin = faceted and _volume(cover) < _LITTLE * _volume(whole)
    return other if thin or _volume(cover) > _ADDED * _volume(other) else cover


def _volume(pieces: Cover) -> float:
    return sum(piece.volume for piece in pieces)


def _outside(pieces: Pieces, tolerance: float) -> list[Faceted]:
    """Return the outer pieces, faceted on the outside."""
    return [Faceted(piece, tolerance=tolerance) for piece in pieces.outer(tolerance)]


def _inside(pieces: Pieces, tolerance: float) -> list[Faceted]:
    """Return the inner pieces, faceted on the inside."""
    return [Faceted(piece, tolerance=tolerance, inside=True) for piece in pieces.inner(tolerance)]


def _cut(pieces: Sequence[Faceted], cutters: Sequence[Faceted]) -> Cover:
    """Subtract the cutters; fragments that form a convex piece are joined again."""
    rest = [part.convex() for part in subtract(pieces, cutters)]
    if len(cutters) > 1 and len(rest) > len(pieces):
        rest = joined(rest, _MANY)
    return tuple(rest)
