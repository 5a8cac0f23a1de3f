"""Convex pieces of solids for simulators and proofs.

Pieces follow from the construction of a solid, not from its mesh: primitives are their own piece, a union
concatenates pieces, a difference splits them by the faces of the cutter's pieces.
"""

from artgen.colliders.budget import budgeted
from artgen.colliders.convex import TOLERANCE, Convex, Kind
from artgen.colliders.makers import chain_pieces, cylinder_pieces, hull_pieces, prism_pieces, round_pieces
from artgen.colliders.pieces import Exact, Pieces, difference, intersection, union
from artgen.colliders.polygon import decompose_polygon
from artgen.colliders.revolve import revolve_pieces

__all__ = [
    "TOLERANCE", "Convex", "Exact", "Kind", "Pieces", "budgeted", "chain_pieces", "cylinder_pieces",
    "decompose_polygon", "difference", "hull_pieces", "intersection", "prism_pieces", "revolve_pieces",
    "round_pieces", "union",
]  # fmt: skip
