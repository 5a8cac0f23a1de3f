"""The final collider set of a solid: few pieces with few vertices."""

from collections.abc import Sequence

from artgen.colliders.convex import TOLERANCE, Convex
from artgen.colliders.merge import condensed
from artgen.colliders.pieces import Pieces

_COARSER = (0.0005, 0.001)  # tolerances for solids that need too many pieces [m]
_MARGIN = 0.001  # largest distance of joined pieces from the solid [m]


def budgeted(
    pieces: Pieces, *, most_pieces: int = 64, most_vertices: int = 64, tolerance: float = TOLERANCE
) -> tuple[Convex, ...]:
    """Return convex pieces around a solid within the budget of a simulator.

    Round pieces are faceted to the tolerance. Over the budget, the solids with the most pieces are faceted to
    0.5 mm, then 1 mm. Then pieces are joined as long as their hull stays within about 1 mm of the solid.
    Cavities are never closed.

    Args:
        pieces: The solid.
        most_pieces: Largest number of pieces.
        most_vertices: Largest number of vertices of a hull.
        tolerance: Largest distance of the pieces from round solids [m].

    Raises:
        ValueError: The solid needs more pieces.
    """
    return budgeted_together(
        [pieces], most_pieces=most_pieces, most_vertices=most_vertices, tolerance=tolerance
    )[0]


def budgeted_together(
    solids: Sequence[Pieces],
    *,
    most_pieces: int = 64,
    most_vertices: int = 64,
    tolerance: float = TOLERANCE,
) -> list[tuple[Convex, ...]]:
    """Return convex pieces around several solids with a common budget; otherwise like `budgeted`.

    Raises:
        ValueError: The solids need more pieces.
    """
    if most_pieces < 1 or most_vertices < 8:
        raise ValueError(
            f"a budget needs at least 1 piece and 8 vertices, got {most_pieces} and {most_vertices}"
        )
    covers = [solid.simplified(tolerance, most_vertices) for solid in solids]
    fewest = sum(map(len, covers))
    for limit in (coarse for coarse in _COARSER if coarse > tolerance):
        for number in sorted(range(len(covers)), key=lambda number: (-len(covers[number]), number)):
            if fewest <= most_pieces:
                return covers
            coarser = solids[number].simplified(limit, most_vertices)
            if len(coarser) < len(covers[number]):
                fewest -= len(covers[number]) - len(coarser)
                covers[number] = coarser
    if fewest <= most_pieces:
        return covers
    merged = condensed(covers, most_pieces, most_vertices, _MARGIN)
    count = sum(map(len, merged))
    if count > most_pieces:
        raise ValueError(
            f"the solid needs {fewest} convex pieces, {count} after joining those that seal no cavity; "
            f"at most {most_pieces} are allowed: cut fewer or simpler holes, or make it of several parts"
        )
    return [tuple(group) for group in merged]
