"""Convex pieces of solids: how simulators and proofs see a part."""

from artgen.colliders.convex import Array, Convex, Kind
from artgen.colliders.pieces import Bounded, Exact, Pieces, budgeted, difference, intersection, union

__all__ = [
    "Array",
    "Bounded",
    "Convex",
    "Exact",
    "Kind",
    "Pieces",
    "budgeted",
    "difference",
    "intersection",
    "union",
]
