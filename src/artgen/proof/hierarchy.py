"""Convex pieces of several links in one table, with a tree of boxes for each link."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import fcl
import numpy as np
from manifold3d import Manifold

from artgen import _portable
from artgen._arrays import Array, Indices, Mask, boxes_of
from artgen.asset.manifolds import mesh_of
from artgen.colliders.triangles import cross, hull_of

_FAN = 4  # most children of a box
_MANY = 12  # vertices used for a first look at a piece in a box
_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
_SQUARE = np.eye(3)
_NORMAL_DECIMALS = 9
_PARALLEL = 0.999  # cosine above which directions count as parallel
_REQUEST = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=False)
_NEAREST = 0.99  # least extent of the gap along the line of the nearest points, as a share of their distance
_TOUCHING = 1e-9  # nodes nearer than this have no direction between them [m]


@dataclass(frozen=True)
class _Node:
    """A box around a range of pieces, or one piece."""

    first: int  # first piece of the range, in the order of the link
    last: int  # end of the range
    vertices: Array  # vertices, shape (v, 3) [m]
    children: tuple[int, ...]  # numbers of the child nodes; none for a piece


class Hierarchy:
    """Trees of several links; nodes are numbered consecutively."""

    def __init__(self, links: Sequence[Sequence[Array]]) -> None:
        self._nodes: list[_Node] = []
        # for each link, its pieces in the order of the ranges of nodes
        self.orders: list[tuple[int, ...]] = []
        roots, sizes = [], []
        first_pieces: list[int] = []
        for pieces in links:
            low, high = boxes_of(pieces)
            order: list[int] = []
            roots.append(self._grow(pieces, np.arange(len(pieces)), low, high, order))
            self.orders.append(tuple(order))
            first_pieces += [order[node.first] for node in self._nodes[len(first_pieces) :]]
            sizes.append(len(self._nodes))
        nodes = self._nodes
        self.roots: Indices = np.array(roots)  # root of each link's tree, shape (links,)
        # first piece and end of each node's range in its link's order, shape (nodes,)
        self.first: Indices = np.array([node.first for node in nodes])
        self.last: Indices = np.array([node.last for node in nodes])
        self.first_piece: Indices = np.array(first_pieces)  # first piece of each range, shape (nodes,)
        # whether the node is a piece, shape (nodes,)
        self.leaf: Mask = np.array([not node.children for node in nodes])
        self.count: Indices = np.array([len(node.vertices) for node in nodes])  # vertices, shape (nodes,)
        # number of the link of each node, shape (nodes,)
        self.tree: Indices = np.searchsorted(sizes, np.arange(len(nodes)), side="right")
        self._points = np.concatenate([node.vertices for node in nodes])
        self._start = np.cumsum(self.count) - self.count
        low = np.minimum.reduceat(self._points, self._start)
        high = np.maximum.reduceat(self._points, self._start)
        # centers of the boxes, and half their lengths, shape (nodes, 3) [m]
        self.center: Array = (low + high) / 2.0
        self.half: Array = (high - low) / 2.0
        away = self._points - np.repeat(self.center, self.count, axis=0)
        # distance of the farthest vertex from the center, shape (nodes,) [m]
        self.radius: Array = np.sqrt(np.maximum.reduceat(np.sum(away * away, axis=1), self._start))
        self._child = np.full((len(nodes), _FAN), -1)
        for number, node in enumerate(nodes):
            self._child[number, : max(len(node.children), 1)] = node.children or number
        self._main: Array = np.tile(_SQUARE, (len(nodes), 1, 1))
        self._unknown = self.leaf.copy()  # whether the main axes of a node are yet to be computed
        # values of nodes that were needed so far
        self._hulls: dict[int, Manifold] = {}
        self._meshes: dict[int, tuple[Array, Indices]] = {}
        self._shapes: dict[int, Any] = {}
        self._fixed: dict[int, Any] = {}
        self._moving: dict[int, Any] = {}

    def _grow(
        self, pieces: Sequence[Array], chosen: Indices, low: Array, high: Array, order: list[int]
    ) -> int:
        """Add the tree of several pieces of a link and return the number of its root."""
        first = len(order)
        if len(chosen) == 1:
            piece = int(chosen[0])
            order.append(piece)
            self._nodes.append(_Node(first, first + 1, pieces[piece], ()))
            if len(pieces[piece]) > _MANY:  # usually the box of the children is good enough
                corners = low[piece] + _CORNERS * (high[piece] - low[piece])
                self._nodes.append(_Node(first, first + 1, corners, (len(self._nodes) - 1,)))
            return len(self._nodes) - 1
        groups = [part for half in _halves(chosen, low, high) for part in _halves(half, low, high)]
        children = tuple(self._grow(pieces, group, low, high, order) for group in groups)
        lowest, highest = low[chosen].min(axis=0), high[chosen].max(axis=0)
        corners = lowest + _CORNERS * (highest - lowest)
        self._nodes.append(_Node(first, len(order), corners, children))
        return len(self._nodes) - 1

    def pieces(self, node: int) -> tuple[int, ...]:
        """Return the numbers of the pieces of a node on its link."""
        order = self.orders[int(self.tree[node])]
        return order[int(self.first[node]) : int(self.last[node])]

    def points(self, nodes: Indices) -> Array:
        """Return the vertices of nodes, the last vertex repeated to equal counts, shape (N, V, 3) [m]."""
        count = self.count[nodes]
        offset = np.minimum(np.arange(count.max()), count[:, None] - 1)
        return np.asarray(self._points[self._start[nodes][:, None] + offset])

    def expanded(self, nodes: Indices, chosen: Mask) -> tuple[Indices, Indices]:
        """Replace chosen nodes by their children (a piece: itself); return the rows of the parents too."""
        table = np.where(chosen[:, None], self._child[nodes], -1)
        table[~chosen, 0] = nodes[~chosen]
        rows, columns = np.nonzero(table >= 0)
        return rows, table[rows, columns]

    def main_axes(self, nodes: Indices) -> Array:
        """Return three directions across faces of each node, shape (N, 3, 3)."""
        for node in np.unique(nodes[self._unknown[nodes]]).tolist():
            self._main[node] = _main_axes(*self._mesh(node))
            self._unknown[node] = False
        return np.asarray(self._main[nodes])

    def hull(self, node: int) -> Manifold:
        """Return the manifold of a piece."""
        if node not in self._hulls:
            self._hulls[node] = hull_of(self._nodes[node].vertices)
        return self._hulls[node]

    def _mesh(self, node: int) -> tuple[Array, Indices]:
        """Return vertices and triangles of a piece."""
        if node not in self._meshes:
            self._meshes[node] = mesh_of(self.hull(node))
        return self._meshes[node]

    def distance(self, first: int, second: int, rotation: Array, offset: Array) -> tuple[float, Array]:
        """Return FCL's distance of a node from a moved node, and the direction between them.

        Touching nodes have the distance -1 and the direction 0 [m].
        """
        answer = fcl.DistanceResult()
        moved = self._object(second, self._moving)
        if not self.leaf[second]:
            offset = offset + rotation @ self.center[second]
        moved.setTransform(fcl.Transform(rotation, offset))
        distance = fcl.distance(self._object(first, self._fixed), moved, _REQUEST, answer)
        if not distance > _TOUCHING:
            return -1.0, np.zeros(3)
        a, b = answer.nearest_points
        between = b - a
        return distance, between / max(_portable.norm(between), 1e-12)

    def checked(
        self, first: int, second: int, rotation: Array, offset: Array, distance: float, direction: Array
    ) -> float:
        """Return FCL's distance of two pieces, or the exact one if FCL's points are not the nearest [m]."""
        a, b = (self._nodes[node].vertices for node in (first, second))
        between = (b @ (rotation.T @ direction)).min() + offset @ direction - (a @ direction).max()
        if between > _NEAREST * distance:
            return distance
        moved = self.hull(second).transform(np.column_stack([rotation, offset]))
        return float(self.hull(first).min_gap(moved, distance))

    def _object(self, node: int, known: dict[int, Any]) -> Any:
        """Return a node at rest as an FCL object, from known ones if possible."""
        if node not in known:
            at = np.zeros(3) if self.leaf[node] else self.center[node]
            known[node] = fcl.CollisionObject(self._shape(node), fcl.Transform(at))
        return known[node]

    def _shape(self, node: int) -> Any:
        if node not in self._shapes:
            if self.leaf[node]:
                corners, triangles = self._mesh(node)
                faces = np.column_stack((np.full(len(triangles), 3), triangles)).astype(np.int32).ravel()
                self._shapes[node] = fcl.Convex(np.ascontiguousarray(corners), len(triangles), faces)
            else:
                self._shapes[node] = fcl.Box(*(2.0 * self.half[node]))
        return self._shapes[node]


def _halves(chosen: Indices, low: Array, high: Array) -> list[Indices]:
    """Split pieces at the center of the direction of their largest spread."""
    if len(chosen) == 1:
        return [chosen]
    middle = low[chosen] + high[chosen]
    direction = int(np.argmax(np.round(np.ptp(middle, axis=0), _NORMAL_DECIMALS)))
    sequence = np.argsort(np.round(middle[:, direction], _NORMAL_DECIMALS), kind="stable")
    half = len(chosen) // 2
    return [chosen[sequence[:half]], chosen[sequence[half:]]]


def _main_axes(corners: Array, triangles: Indices) -> Array:
    """Return the normals of the three largest faces that are not parallel, shape (3, 3)."""
    a, b, c = corners[triangles.T]
    areas = cross(b - a, c - a)
    size = np.sqrt(np.sum(areas * areas, axis=1))
    normals = np.round(areas / np.where(size > 0.0, size, 1.0)[:, None], _NORMAL_DECIMALS)
    chosen: list[int] = []
    left = np.where(size > 0.0, np.round(size, _NORMAL_DECIMALS), -1.0)
    while len(chosen) < 3 and left.max() >= 0.0:
        largest = int(np.argmax(left))
        chosen.append(largest)
        left[np.abs(_portable.product(normals, normals[largest])) > _PARALLEL] = -1.0
    return normals[(chosen * 3)[:3]]
