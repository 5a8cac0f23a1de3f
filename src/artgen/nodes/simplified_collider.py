"""Coarse colliders: thin round shells would need many pieces to be followed closely."""

from artgen.asset.shape import Shape
from artgen.colliders import Pieces
from artgen.colliders.pieces import Cover
from artgen.graph import kernel
from artgen.nodes.handles import Scalar, Solid
from artgen.nodes.validators import between

MOST = 0.001
"""How far coarse colliders may stand off a solid [m]: what checks allow."""


class _Coarse(Pieces):
    """Pieces that follow a solid no closer than to a distance."""

    def __init__(self, base: Pieces, least: float) -> None:
        super().__init__()
        self._base, self._least = base, least

    def _outer(self, tolerance: float) -> Cover:
        return self._base.outer(max(tolerance, self._least))

    def _inner(self, tolerance: float) -> Cover:
        return self._base.inner(tolerance)

    def _simplified(self, tolerance: float, most_vertices: int) -> Cover:
        return self._base.simplified(max(tolerance, self._least), most_vertices)


@kernel
def _coarse(solid: Shape, within: float) -> Shape:
    between("within", within, 0.0, MOST)
    if within == 0.0:
        return solid
    return Shape(solid.manifold, _Coarse(solid.pieces, within), solid.paints)


def coarse(solid: Solid, within: Scalar = MOST) -> Solid:
    """Let the colliders of a round solid stand off it; it looks and weighs what it did.

    A thin round shell, such as the wall of a bin, collides as one piece for each of its facets; with 1 mm to
    spare it needs less than half as many. What is proven of it holds for the coarser pieces.

    Args:
        solid: What collides coarsely, before anything is cut out of it.
        within: How far its colliders may stand off, at most 1 mm [m].

    Examples:
        >>> coarse(tube(0.1, 0.098, 0.2))
    """
    return Solid.record(_coarse, solid=solid, within=within)
