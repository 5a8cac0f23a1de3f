"""A z-buffer: which triangle is seen at each pixel of a parallel projection.

Corners are rounded to a grid, so that coverage is decided by integers and does not depend on the machine.
"""

from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, Indices

_GRID = 16
"""Places within a pixel, in each direction, on which corners lie."""

NOTHING = -1
"""In the place of a triangle where none is seen."""


@dataclass(frozen=True, eq=False)
class Seen:
    """What is seen at each pixel."""

    owner: Indices  # number of the triangle, `NOTHING` where there is none, shape (size, size)
    depth: Array  # how far it is along the view, infinity where there is none, shape (size, size) [m]


def rasterize(corners: Array, size: int) -> Seen:
    """Find the nearest triangle that faces the viewer at each pixel."""
    grid = np.rint(corners[:, :, :2] * _GRID).astype(np.int64)
    facing = np.flatnonzero(_doubled_area(grid) > 0)
    number, row = _rows(grid[facing], size)
    first, last = _spans(grid[facing][number], row, size)
    kept = last >= first
    number, row, first, last = number[kept], row[kept], first[kept], last[kept]
    count = last - first + 1
    column = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)
    number, row = np.repeat(number, count), np.repeat(row, count)
    depth = _depths(corners[facing], grid[facing], number, column, row)
    pixel = row * size + column
    nearest = np.full(size * size, np.inf)
    np.minimum.at(nearest, pixel, depth)
    front = depth == nearest[pixel]
    owner = np.full(size * size, len(corners), np.int64)
    np.minimum.at(owner, pixel[front], facing[number[front]])
    owner[owner == len(corners)] = NOTHING
    return Seen(owner.reshape(size, size), nearest.reshape(size, size))


def weights(corners: Array, column: Array, row: Array) -> Array:
    """Return how much each corner of a triangle counts at the middle of a pixel, shape (n, 3)."""
    x, y = corners[:, :, 0], corners[:, :, 1]
    px, py = (column + 0.5)[:, None], (row + 0.5)[:, None]
    ahead, behind = np.roll(np.arange(3), -1), np.roll(np.arange(3), 1)
    areas = (x[:, ahead] - px) * (y[:, behind] - py) - (x[:, behind] - px) * (y[:, ahead] - py)
    areas = np.maximum(areas, 0.0)
    total = areas.sum(axis=1, keepdims=True)
    return np.where(total > 0.0, areas / np.where(total > 0.0, total, 1.0), 1.0 / 3.0)


def _doubled_area(grid: Indices) -> Indices:
    one, other = grid[:, 1] - grid[:, 0], grid[:, 2] - grid[:, 0]
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


def _rows(grid: Indices, size: int) -> tuple[Indices, Indices]:
    """Return each row that each triangle reaches, as the triangle's number and the row's."""
    half = _GRID // 2
    low = np.maximum(-((half - grid[:, :, 1].min(axis=1)) // _GRID), 0)
    high = np.minimum((grid[:, :, 1].max(axis=1) - half) // _GRID, size - 1)
    count = np.maximum(high - low + 1, 0)
    number = np.repeat(np.arange(len(grid)), count)
    row = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(low, count)
    return number, row


def _spans(grid: Indices, row: Indices, size: int) -> tuple[Indices, Indices]:
    """Return the first and last pixel whose middle is in each triangle, in one row of each."""
    half = _GRID // 2
    y = row * _GRID + half
    first, last = np.zeros(len(row), np.int64), np.full(len(row), size - 1)
    for corner in range(3):
        start, end = grid[:, corner], grid[:, (corner + 1) % 3]
        run, rise = end[:, 0] - start[:, 0], end[:, 1] - start[:, 1]
        # a pixel is inside where its cross product with each side is not negative
        bound = run * (y - start[:, 1]) + rise * start[:, 0] - rise * half
        step = rise * _GRID
        up, down = rise > 0, rise < 0
        last[up] = np.minimum(last[up], bound[up] // step[up])
        first[down] = np.maximum(first[down], -(bound[down] // -step[down]))
        last[(rise == 0) & (bound < 0)] = -1
    return first, last


def _depths(corners: Array, grid: Indices, number: Indices, column: Indices, row: Indices) -> Array:
    """Return the depth of each triangle's plane at the middle of pixels."""
    points = grid / _GRID
    one, other = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    area = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    rise_one, rise_other = (corners[:, index, 2] - corners[:, 0, 2] for index in (1, 2))
    to_right = (rise_one * other[:, 1] - rise_other * one[:, 1]) / area
    upwards = (rise_other * one[:, 0] - rise_one * other[:, 0]) / area
    right, up = column + 0.5 - points[number, 0, 0], row + 0.5 - points[number, 0, 1]
    plane: Array = corners[number, 0, 2] + to_right[number] * right + upwards[number] * up
    # slivers have steep planes: no triangle is nearer or farther than its corners
    nearest, farthest = corners[:, :, 2].min(axis=1), corners[:, :, 2].max(axis=1)
    return np.clip(plane, nearest[number], farthest[number])
