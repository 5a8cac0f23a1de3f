"""Boxes for the extent and the interior of an asset: the regions of RoboCasa.

The interior is found on a grid from the colliders alone. A cell is inside if solids surround it on all six
sides, except above, while every joint is closed. It is usable if some of it is open when every joint is at
the end of its range.
"""

from collections.abc import Mapping, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import Asset
from artgen.export.frames import seen_box

Cells = NDArray[np.bool_]

_CELLS = 128  # cells along the longest side
_STEP = (0.008, 0.02)  # smallest and largest side of a cell, wider than the gap around a closed door [m]
_LEAST = 0.08  # least side of a region; smaller ones are spaces behind handles [m]
_MOST = 8  # most regions
_OFFSET = 1.37  # margin of the grid around the asset, in cells: rounding would decide about faces on the grid
_DECIMALS = 6


def interiors(asset: Asset, above: float = -np.inf) -> list[Array]:
    """Return boxes of free space in a closed asset above a height, largest first, shape (2, 3) each [m]."""
    grid = Grid(seen_box(asset))
    occupied = grid.occupied(asset, {})
    free = ~occupied & _surrounded(occupied)
    heights = grid.origin[2] + grid.step * np.arange(grid.shape[2])
    free[:, :, heights < above] = False
    if not free.any():
        return []
    opened = {joint.name: joint.opened for joint in asset.free_joints}
    open_to_air = ~_surrounded(grid.occupied(asset, opened), top=True)
    found: list[Array] = []
    for _ in range(_MOST):
        box = _grown(free)
        size = grid.step * (box[1] - box[0])
        if size.min() < _LEAST:
            break
        cells = _cells(box)
        free[cells] = False
        if open_to_air[cells].any():
            found.append(np.round(grid.origin + grid.step * box, _DECIMALS) + 0.0)
    return sorted(found, key=lambda box: -round(float(np.prod(box[1] - box[0])), _DECIMALS))


class Grid:
    """Cubic cells around a box."""

    def __init__(self, box: Array) -> None:
        longest = float((box[1] - box[0]).max())
        self.step = min(max(longest / _CELLS, _STEP[0]), _STEP[1])
        self.origin = box[0] - _OFFSET * self.step
        self.shape = tuple(int(count) for count in np.ceil((box[1] - self.origin) / self.step) + 1)

    def occupied(self, asset: Asset, q: Mapping[str, float], links: Sequence[str] | None = None) -> Cells:
        """Return the cells that a collider of some or all links may reach at positions of free joints."""
        result = np.zeros(self.shape, dtype=bool)
        pose = asset.pose(q)
        for link in asset.links.names if links is None else links:
            matrix = pose[link]
            for collider in asset.link(link).colliders:
                polytope = collider.convex.faces
                normals = polytope.planes[:, :3] @ matrix[:3, :3].T
                distances = polytope.planes[:, 3] + _portable.product(normals, matrix[:3, 3])
                points = polytope.points @ matrix[:3, :3].T + matrix[:3, 3]
                self._fill(result, points, normals, distances)
        return result

    def _fill(self, cells: Cells, points: Array, normals: Array, distances: Array) -> None:
        """Mark the cells that a convex piece may reach, and a few more at its edges."""
        box = np.floor((np.array([points.min(axis=0), points.max(axis=0)]) - self.origin) / self.step)
        first, last = box = np.clip(box.astype(int) + [[0], [1]], 0, self.shape)
        if (first >= last).any():
            return
        part = cells[_cells(box)]
        axes = [
            self.origin[axis] + self.step * (np.arange(first[axis], last[axis]) + 0.5) for axis in range(3)
        ]
        reached = ~part
        for normal, distance in zip(normals, distances, strict=True):
            reach = distance + np.abs(normal).sum() * self.step / 2.0
            x, y, z = (normal[axis] * axes[axis] for axis in range(3))
            reached &= x[:, None, None] + y[:, None] + z <= reach
        part |= reached


def _surrounded(occupied: Cells, *, top: bool = False) -> Cells:
    """Return the cells with occupied cells on all six sides, or on five sides if the top may be open."""
    result = np.ones_like(occupied)
    for axis, above in product(range(3), (False, True)):
        if top or (axis, above) != (2, True):
            view = np.flip(occupied, axis) if above else occupied
            seen = np.logical_or.accumulate(view, axis=axis)
            result &= np.flip(seen, axis) if above else seen
    return result


def _grown(free: Cells) -> NDArray[np.int64]:
    """Return a maximal box around the freest cell as first and last + 1, shape (2, 3)."""
    from scipy.ndimage import distance_transform_cdt

    seed = np.unravel_index(int(np.argmax(distance_transform_cdt(free, "chessboard"))), free.shape)
    box = np.array([seed, np.add(seed, 1)], dtype=np.int64)
    growing = bool(free[seed])
    while growing:
        growing = False
        for axis, (end, sign) in product(range(3), ((0, -1), (1, 1))):
            slab = box.copy()
            slab[1 - end, axis] = box[end, axis]
            slab[end, axis] += sign
            if free[_cells(slab)].all():
                box[end, axis] += sign
                growing = True
    return box if free[seed] else np.zeros((2, 3), dtype=np.int64)


def _cells(box: NDArray[np.int64]) -> tuple[slice, ...]:
    return tuple(slice(low, high) for low, high in box.T)
