"""Distances to surfaces of triangles, points spread over them, and unique rows of tables."""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from trimesh.triangles import closest_point

from artgen._arrays import Array, FrozenArrays, Indices, cached_property

Number = TypeVar("Number", np.float64, np.int64)


def distinct_rows(rows: NDArray[Number]) -> tuple[NDArray[Number], Indices, Indices]:
    """Return the distinct rows in order, like `numpy.unique` but five times as fast."""
    order = np.lexsort(rows.T[::-1])
    ordered = rows[order]
    new = np.ones(len(rows), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    number = np.empty(len(rows), np.int64)
    number[order] = np.cumsum(new) - 1
    return ordered[new], order[new], number


_CHUNK = 128  # points compared with all triangles at once
_TRIED = 8  # nearest samples whose triangles are tried first: a corner has about six
_ON = 1e-6  # distance within which a point lies on the surface [m]


@dataclass(frozen=True, eq=False)
class TriangleSet(FrozenArrays):
    """Triangles of a surface."""

    corners: Array  # the corners of each triangle, shape (m, 3, 3) [m]

    @staticmethod
    def of(solid: Manifold) -> "TriangleSet":
        """Return the triangles of a solid's surface."""
        mesh = solid.to_mesh64()
        return TriangleSet(
            np.asarray(mesh.vert_properties)[:, :3][np.asarray(mesh.tri_verts).astype(np.int64)]
        )

    @cached_property
    def areas(self) -> Array:
        """Area of each triangle, shape (m,) [m^2]."""
        a, b, c = self.corners[:, 0], self.corners[:, 1], self.corners[:, 2]
        return np.asarray(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1))

    def spread(self, count: int) -> Array:
        """Return the corners and about `count` points spread evenly over the area, shape (n, 3) [m].

        The same triangles give the same points.
        """
        return self._sampled(count)[0]

    def _sampled(self, count: int) -> tuple[Array, Indices]:
        """Return the points of `spread`, and the triangle of each point, shape (n,)."""
        corners, owners = self.corners.reshape(-1, 3), np.repeat(np.arange(len(self.corners)), 3)
        ends = np.cumsum(self.areas)
        if not len(ends) or ends[-1] <= 0.0:
            return corners, owners
        step = ends[-1] / count
        at = (np.arange(count) + 0.5) * step
        index = np.minimum(np.searchsorted(ends, at), len(ends) - 1)
        # multiples of the plastic ratio fill every triangle evenly
        u, v = (np.arange(1, count + 1) * ratio % 1.0 for ratio in (0.7548776662466927, 0.5698402909980532))
        u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
        a, b, c = (self.corners[index, corner] for corner in range(3))
        inner = a + u[:, None] * (b - a) + v[:, None] * (c - a)
        return np.concatenate([corners, inner]), np.concatenate([owners, index])

    @cached_property
    def _tree(self) -> tuple[cKDTree, Indices]:
        points, owners = self._sampled(2000)
        return cKDTree(points), owners

    def farthest(self, points: Array, *, outside: bool = False) -> tuple[float, Array]:
        """Return the largest distance of points to the surface [m], and the point."""
        points, _, _ = distinct_rows(np.round(points, 8))
        bound = self._near(points)
        order = np.argsort(-bound, kind="stable")
        points, bound = points[order], bound[order]
        best, place = -1.0, points[0]
        for start in range(0, len(points), _CHUNK):
            if bound[start] <= best:
                break  # the bound of every later point is smaller
            distances = self._distances(points[start : start + _CHUNK], bound[start : start + _CHUNK])
            for number in np.argsort(-distances, kind="stable").tolist():
                if distances[number] <= best:
                    break
                point = points[start + number]
                if not outside or distances[number] < _ON or not self.surround(point):
                    best, place = float(distances[number]), point
                    break
        return max(best, 0.0), place

    def surround(self, point: Array) -> bool:
        """Tell whether a point, shape (3,), that is not on the surface is inside.

        The solid angles of the triangles (van Oosterom and Strackee) add up to 4 pi for points inside.
        """
        edges = self.corners - point
        a, b, c = edges[:, 0], edges[:, 1], edges[:, 2]
        long = np.linalg.norm(edges, axis=2)
        volume = np.sum(a * np.cross(b, c), axis=1)
        spread = long.prod(axis=1) + sum(
            np.sum(edges[:, one] * edges[:, two], axis=1) * long[:, other]
            for one, two, other in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        )
        return bool(np.sum(np.arctan2(volume, spread)) > np.pi)

    def _near(self, points: Array) -> Array:
        """Return an upper bound of the distance of each point, mostly tight, shape (n,) [m]."""
        tree, owners = self._tree
        samples = tree.query(points, k=np.arange(1, min(_TRIED, tree.n) + 1))[1].T
        distances = [
            np.linalg.norm(_closest(self.corners[owners[each]], points) - points, axis=1) for each in samples
        ]
        return np.asarray(np.min(distances, axis=0))

    def _distances(self, points: Array, bound: Array) -> Array:
        """Return the distance of each point to the surface, shape (n,) [m]; `bound` is never exceeded."""
        low, high = self._boxes
        lower = np.zeros((len(points), len(self.corners)))
        for axis in range(3):
            column = points[:, axis, None]
            outside = np.maximum(np.maximum(low[:, axis] - column, column - high[:, axis]), 0.0)
            lower += outside * outside
        nearest = np.argmin(lower, axis=1)
        found = _closest(self.corners[nearest], points)
        bound = np.minimum(bound, np.linalg.norm(found - points, axis=1))
        rows, columns = np.nonzero(lower <= (bound * bound)[:, None] + 1e-18)
        found = _closest(self.corners[columns], points[rows])
        result = bound.copy()
        np.minimum.at(result, rows, np.linalg.norm(found - points[rows], axis=1))
        return result

    @cached_property
    def _boxes(self) -> tuple[Array, Array]:
        return self.corners.min(axis=1), self.corners.max(axis=1)


def _closest(corners: Array, points: Array) -> Array:
    return np.asarray(closest_point(corners, points))  # type: ignore[no-untyped-call]
