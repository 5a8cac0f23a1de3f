"""The columns that a contour gives to a grid."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, Indices, successors
from artgen._caching import FrozenArrays
from artgen.asset.outline import Contour


@dataclass(frozen=True, eq=False)
class Rail(FrozenArrays):
    """The columns that a contour gives to a grid: two at each corner and at the seam (its first vertex)."""

    vertex: Indices  # contour vertex of each column, shape (c,)
    normals: Array  # outward unit normal in the plane of the contour, shape (c, 2)
    distance: Array  # length along the contour, shape (c,) [m]
    start: Indices  # column in which each side of the contour starts, shape (n,)
    end: Indices  # column in which it ends, shape (n,)

    @staticmethod
    def along(contour: Contour, breaks: NDArray[np.bool_] | None = None) -> "Rail":
        """Return the columns of a contour; `breaks` asks for two columns at more vertices, shape (n,)."""
        count = len(contour.points)
        corner = np.einsum("ij,ij->i", contour.normals_in, contour.normals_out) < 1.0 - 1e-9
        if breaks is not None:
            corner |= breaks
        arrive = np.empty(count, np.int64)
        leave = np.empty(count, np.int64)
        width = 1 + corner[1:]
        arrive[1:] = np.cumsum(width) - width + 1
        leave[1:] = arrive[1:] + corner[1:]
        leave[0], arrive[0] = 0, 1 + width.sum()
        columns = int(arrive[0]) + 1
        vertex = np.empty(columns, np.int64)
        normals = np.empty((columns, 2))
        distance = np.empty(columns)
        sides = successors(contour.points) - contour.points
        total = np.cumsum(np.hypot(sides[:, 0], sides[:, 1]))
        travelled = np.concatenate([[0.0], total[:-1]])
        for column, normal in ((arrive, contour.normals_in), (leave, contour.normals_out)):
            vertex[column] = np.arange(count)
            normals[column] = normal
            distance[column] = travelled
        distance[arrive[0]] = total[-1]
        return Rail(vertex, normals, distance, leave, successors(arrive))
