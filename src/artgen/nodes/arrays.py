"""Copies of one solid that stay part of one link."""

import numpy as np

from artgen._arrays import Array
from artgen.asset.shape import ComposedShape, Shape
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.csg import united
from artgen.nodes.handles import ArrayN3, PointsLike, Solid


@kernel
def _array(solid: Shape, at: ArrayN3) -> Shape:
    places = inputs.points("at", at, 3, 1)
    copies = [solid.transformed(inputs.pose(np.eye(3), place)) for place in places]
    if len(copies) == 1:
        return copies[0].checked()
    low, high = solid.bounds()
    if not _are_apart(places, high - low):
        return united(copies)
    return ComposedShape(copies)


def _are_apart(places: Array, size: Array) -> bool:
    """Tell whether boxes of one size at all places are free of each other."""
    gap = np.abs(places[:, None, :] - places[None, :, :]) - size
    apart = gap.max(axis=2) > 1e-9
    np.fill_diagonal(apart, True)
    return bool(apart.all())


def array(solid: Solid, *, at: PointsLike) -> Solid:
    """Make copies of a solid as one solid; copies that touch or overlap are united.

    Args:
        solid: What to copy.
        at: By how much each copy is moved [m].

    Examples:
        >>> array(box(0.02, 0.1, 0.05), at=row((0, 0, 0), (0.04, 0, 0), 5))
    """
    return Solid.record(_array, solid=solid, at=at)
