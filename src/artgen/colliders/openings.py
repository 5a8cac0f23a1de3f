"""Openings of a link: the space outside its pieces, as far as a ball from outside reaches it."""

from collections.abc import Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.colliders.polytope import Polytope

BALL = 0.024
"""Default diameter of the balls that measure openings [m]."""

_CORE = 0.55  # share of the radius of a ball around whose center all places stay free
_DISTANCE = 0.15  # share of the radius that pieces keep from such places
_FINEST = 0.004  # least distance of points in the grid [m]
_COARSE = 0.7  # largest distance of points in the grid, as a share of the radius
_POINTS = 200_000  # number of points in the grid, about, if that is not too coarse
_MOST_POINTS = 8_000_000  # number of points in the grid, at most; a coarser grid refuses more pieces
_FEW = 4  # one of so many points along each axis is examined first


class Openings:
    """Places around the pieces of a link that have to stay free.

    Wherever a ball fits beside the pieces, and can be moved there from outside, its inner part has to stay
    free. Its outer part, about a third of the radius, may be filled: flat recesses, corners, and gaps
    narrower than two thirds of the ball.

    Args:
        pieces: Pieces of one link.
        ball: Diameter of the balls [m].
    """

    def __init__(self, pieces: Sequence[Polytope], ball: float = BALL) -> None:
        from scipy import ndimage

        bounds, far = np.array([piece.bounds for piece in pieces]), 0.6 * ball
        low, high = bounds[:, 0].min(axis=0) - far, bounds[:, 1].max(axis=0) + far
        few, most = (float(np.prod(high - low) / count) ** (1.0 / 3.0) for count in (_POINTS, _MOST_POINTS))
        step = max(_FINEST, most, min(few, _COARSE * ball / 2.0))
        self._axes = [np.arange(start, end + step, step) for start, end in zip(low, high, strict=True)]
        distance = np.full([len(axis) for axis in self._axes], far)
        for piece in pieces:
            near = self._near(piece.bounds, far)
            x, y, z = (axis[part] for axis, part in zip(self._axes, near, strict=True))
            height = np.full((len(x), len(y), len(z)), -np.inf)
            for a, b, c, d in piece.planes.tolist():
                np.maximum(height, (a * x - d)[:, None, None] + (b * y)[:, None] + c * z, out=height)
            np.minimum(distance[near], height, out=distance[near])
        radius = max(ball / 2.0 - step / 2.0, ball / 4.0)  # points are up to half a step beside a center
        parts, _ = ndimage.label(distance >= radius)
        centers = parts == parts[0, 0, 0]  # a ball gets there from outside
        self._kept = ndimage.distance_transform_edt(~centers, sampling=step) <= _CORE * radius
        self._margin = max(_DISTANCE * radius, step / 2.0)  # no thin piece passes between the points

    def closed_by(self, piece: Polytope) -> bool:
        """Tell whether a piece takes a place that has to stay free."""
        near = self._near(piece.bounds, self._margin)
        axes = [axis[part] for axis, part in zip(self._axes, near, strict=True)]
        for step in (_FEW, 1):
            places = np.nonzero(self._kept[near][::step, ::step, ::step])
            inside = np.column_stack([axis[::step][at] for axis, at in zip(axes, places, strict=True)])
            for plane in piece.planes:
                inside = inside[_portable.product(inside, plane[:3]) < plane[3] + self._margin]
            if len(inside):
                return True
        return False

    def _near(self, bounds: Array, margin: float) -> tuple[slice, ...]:
        """Return the part of the grid in a box, shape (2, 3), with a margin, and one point beyond [m]."""
        return tuple(
            slice(
                max(int(np.searchsorted(axis, start - margin)) - 1, 0),
                int(np.searchsorted(axis, end + margin)) + 1,
            )
            for axis, start, end in zip(self._axes, *bounds, strict=True)
        )
