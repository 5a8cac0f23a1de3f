"""Rows of tables that are there several times, such as corners and edges of triangles."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Indices

Number = TypeVar("Number", np.float64, np.int64)


def distinct_rows(rows: NDArray[Number]) -> tuple[NDArray[Number], Indices, Indices]:
    """Return the distinct rows in order, as `numpy.unique` does in five times the time."""
    order = np.lexsort(rows.T[::-1])
    ordered = rows[order]
    new = np.ones(len(rows), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    number = np.empty(len(rows), np.int64)
    number[order] = np.cumsum(new) - 1
    return ordered[new], order[new], number
