"""Lazily evaluated convex covers of solids, combined as the solids are."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence

from artgen.colliders.convex import Array, Convex


class Pieces(ABC):
    """A convex cover of one solid."""

    @abstractmethod
    def outer(self, tolerance: float) -> tuple[Convex, ...]:
        """Return pieces whose union contains the solid."""

    @abstractmethod
    def inner(self, tolerance: float) -> tuple[Convex, ...]:
        """Return pieces whose union the solid contains."""

    def transformed(self, matrix: Array) -> "Pieces":
        """Return the cover moved by an affine matrix, shape (4, 4)."""
        raise NotImplementedError


class Exact(Pieces):
    """Pieces that are the very solid."""

    def __init__(self, convexes: Sequence[Convex]) -> None:
        self.convexes = tuple(convexes)

    def outer(self, tolerance: float) -> tuple[Convex, ...]:
        """Return the pieces."""
        return self.convexes

    def inner(self, tolerance: float) -> tuple[Convex, ...]:
        """Return the pieces."""
        return self.convexes


class Bounded(Pieces):
    """Pieces computed by two functions of the tolerance."""

    def __init__(
        self,
        outer: Callable[[float], tuple[Convex, ...]],
        inner: Callable[[float], tuple[Convex, ...]],
    ) -> None:
        self._outer = outer
        self._inner = inner

    def outer(self, tolerance: float) -> tuple[Convex, ...]:
        """Return pieces whose union contains the solid."""
        return self._outer(tolerance)

    def inner(self, tolerance: float) -> tuple[Convex, ...]:
        """Return pieces whose union the solid contains."""
        return self._inner(tolerance)


def union(*pieces: Pieces) -> Pieces:
    """Return the cover of the union."""
    return Bounded(
        lambda t: sum((p.outer(t) for p in pieces), ()), lambda t: sum((p.inner(t) for p in pieces), ())
    )


def difference(a: Pieces, b: Pieces) -> Pieces:
    """Return the cover of `a - b`."""
    raise NotImplementedError


def intersection(a: Pieces, b: Pieces) -> Pieces:
    """Return the cover of `a & b`."""
    raise NotImplementedError


def budgeted(
    pieces: Pieces, *, most_pieces: int = 64, most_vertices: int = 64, tolerance: float = 0.00025
) -> tuple[Convex, ...]:
    """Return the collider set that a simulator carries."""
    return pieces.outer(tolerance)
