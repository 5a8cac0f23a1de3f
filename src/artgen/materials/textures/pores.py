"""Pores of wood: vessels that a cut opened, as grooves along the grain that are finer than most texels."""

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.materials.textures.fields import Tile

_SPREAD = 0.45  # of the logarithm of lengths
_AT_ONCE = 1 << 14  # pores drawn at once: more are many pages of memory


def pores(tile: Tile, chance: Array, density: float, length: float, width: float) -> Array:
    """Strew pores over a tile, and return how much of each texel they take, shape (n, n).

    A texel that is wider than a pore is darkened by its share, so that small maps are large ones, averaged.
    """
    count = round(density * tile.extent[0] * tile.extent[1])
    drawn = tile.stream.random((4, count))
    lengths = length * np.exp(_SPREAD * np.clip(tile.stream.standard_normal(count), -2.0, 2.0))
    column, row = drawn[0] * tile.size, drawn[1] * tile.size
    there = chance[row.astype(np.int64), column.astype(np.int64)] > drawn[2]
    across = width * (0.6 + 0.8 * drawn[3, there]) * (tile.size / tile.extent[0])
    along = lengths[there] * (tile.size / tile.extent[1])
    placed = np.stack([column[there], row[there], across, along])
    covered = np.zeros(tile.size**2)
    order = np.argsort(along, kind="stable")  # those of one length take equally many texels
    for start in range(0, len(order), _AT_ONCE):
        where, share = _covered(tile.size, *placed[:, order[start : start + _AT_ONCE]])
        covered += np.bincount(where, share, tile.size**2)
    return np.minimum(covered, 1.0).reshape(tile.size, tile.size)


def _covered(
    size: int, column: Array, row: Array, across: Array, along: Array
) -> tuple[NDArray[np.int64], Array]:
    """Return which texels grooves lie in and how much of each they take; lengths are in texels."""
    left, top = column - 0.5 * across, row - 0.5 * along
    columns = np.floor(left)[:, None] + np.arange(int(across.max()) + 2)
    rows = np.floor(top)[:, None] + np.arange(int(along.max()) + 2)
    share_across = np.clip(
        np.minimum(columns + 1.0, (left + across)[:, None]) - np.maximum(columns, left[:, None]), 0.0, 1.0
    )
    # A groove is deepest at its middle and runs out at its ends
    edges = np.concatenate([rows, rows[:, -1:] + 1.0], axis=1)
    part = np.clip((edges - row[:, None]) * (2.0 / along)[:, None], -1.0, 1.0)
    depth = part - part**3 / 3.0
    share_along = (0.5 * along)[:, None] * np.diff(depth, axis=1)
    texels = (rows.astype(np.int64) % size)[:, :, None] * size + (columns.astype(np.int64) % size)[:, None, :]
    return texels.ravel(), (share_along[:, :, None] * share_across[:, None, :]).ravel()
