"""Geometry of nodes: each mesh once, with its places in the values of nodes."""

from typing import Any

import numpy as np

from artgen.asset.joint import AssetJoint
from artgen.asset.shape import Curve, MovedShape, Outline, Shape
from artgen.asset.tree import Tree

_BLANK = (0.72, 0.74, 0.76)  # linear color of a solid without a material
_MOST_POINTS = 400  # most points of a cloud
_STEPS = 65535  # positions along one side of a mesh: a hundredth of a millimetre on a door
_DIGITS = 6  # tolerance of positions [m]


class Gallery:
    """Collects the geometry of the nodes of a graph.

    Attributes:
        meshes: Number of vertices and triangles and bounding box of each mesh; the numbers themselves are in
            `blob`, one mesh after the other.
        items: Meshes in their places, lines, points and axes.
    """

    def __init__(self) -> None:
        self.meshes: list[dict[str, Any]] = []
        self.items: list[dict[str, Any]] = []
        self._content: list[bytes] = []
        self._size = 0
        self._numbers: dict[int, int] = {}
        self._placed: dict[Any, int] = {}
        self._kept: list[Shape] = []  # kept, so that no other shape gets the same identity

    @property
    def blob(self) -> bytes:
        """Positions (16 bits, within the bounding box), normals (8 bits) and triangles of all meshes."""
        return b"".join(self._content)

    def add(self, value: Any) -> list[int]:
        """Add the value of a node and return the numbers of its items; empty for a number."""
        if isinstance(value, Shape):
            return [self._shape(value, _BLANK)]
        if isinstance(value, Tree):
            return [*self._tree(value)]
        return [self._item(item) for item in _drawn(value)]

    def _tree(self, tree: Tree) -> list[int]:
        found = [
            self._shape(piece.shape, piece.material.base_color)
            for link in tree.links()
            for piece in link.pieces
        ]
        return found + [self._item(item) for joint in tree.joints() for item in _drawn(joint)]

    def _item(self, item: dict[str, Any]) -> int:
        self.items.append(item)
        return len(self.items) - 1

    def _shape(self, shape: Shape, color: tuple[float, ...]) -> int:
        matrix = np.eye(4)
        while isinstance(shape, MovedShape):
            matrix, shape = matrix @ shape.matrix, shape.source
        mesh = self._mesh(shape)
        key = (mesh, matrix.tobytes(), color)
        if key not in self._placed:
            item = {"mesh": mesh, "color": [round(part, 3) for part in color]}
            if not np.array_equal(matrix, np.eye(4)):
                item["matrix"] = np.round(matrix.T.ravel(), _DIGITS).tolist()  # by columns, for WebGL
            self._placed[key] = self._item(item)
        return self._placed[key]

    def _mesh(self, shape: Shape) -> int:
        if id(shape) in self._numbers:
            return self._numbers[id(shape)]
        mesh = shape.mesh
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        size = np.maximum(high - low, 1e-9)
        wide = len(mesh.vertices) > _STEPS
        for numbers in (
            np.rint((mesh.vertices - low) / size * _STEPS).astype("<u2"),
            np.rint(mesh.normals * 127.0).astype("i1"),
            mesh.triangles.astype("<u4" if wide else "<u2"),
        ):
            content = numbers.tobytes()
            # the next mesh begins at a multiple of 4
            self._content.append(content + bytes(-len(content) % 4))
        self.meshes.append(
            {
                "vertices": len(mesh.vertices),
                "triangles": len(mesh.triangles),
                "low": np.round(low, _DIGITS).tolist(),
                "size": np.round(size, _DIGITS + 3).tolist(),
            }
        )
        self._kept.append(shape)
        self._numbers[id(shape)] = len(self.meshes) - 1
        return len(self.meshes) - 1


def _drawn(value: Any) -> list[dict[str, Any]]:
    """Return the lines, points and axes of a value that is neither a solid nor a body."""
    if isinstance(value, AssetJoint):
        return [{"axis": value.kind, "at": _rows(value.pivot), "along": _rows(value.axis)}]
    if isinstance(value, Outline):
        flat = [np.pad(contour.points, ((0, 0), (0, 1))) for contour in value.contours]
        return [{"line": _rows(points), "closed": True} for points in flat]
    if isinstance(value, Curve):
        return [{"line": _rows(value.points), "closed": value.closed}]
    if isinstance(value, np.ndarray) and value.shape == (4, 4):
        return [{"frame": _rows(value.T.ravel())}]
    if isinstance(value, np.ndarray) and value.shape == (3,):
        return [{"points": [_rows(value)]}]
    if isinstance(value, np.ndarray) and value.ndim == 2 and value.shape[1] == 3:
        return [{"points": _rows(value[:_MOST_POINTS])}]
    return []


def _rows(values: Any) -> Any:
    return np.round(np.asarray(values, float), _DIGITS).tolist()
