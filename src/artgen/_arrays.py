"""Types of arrays, and the neighbors of rows in a ring such as a contour."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

Kind = TypeVar("Kind", bound=np.generic)


def successors(ring: NDArray[Kind]) -> NDArray[Kind]:
    """Return in place of each row the next one, cyclically; like `np.roll`, at a fifth of its time."""
    return np.concatenate((ring[1:], ring[:1]))


def predecessors(ring: NDArray[Kind]) -> NDArray[Kind]:
    """Return in place of each row the previous one, cyclically."""
    return np.concatenate((ring[-1:], ring[:-1]))
