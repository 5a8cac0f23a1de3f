"""Content of the page for each node: the author's line, value and inputs as text, and geometry."""

import ast
import linecache
import textwrap
from collections.abc import Mapping
from pathlib import PurePath
from typing import Any

import numpy as np

from artgen.asset.joint import AssetJoint
from artgen.asset.shape import Curve, Mesh, MovedShape, Outline, Shape
from artgen.asset.tree import Tree
from artgen.graph.node import PARAMETER, Node

PARAMETERS = "parameters"
"""Group of the nodes of parameters."""

_LINES = 12  # most lines of a statement that are shown


class _Source:
    """Functions and statements of a file, or of a notebook cell."""

    def __init__(self, file: str) -> None:
        linecache.checkcache(file)
        self._lines = linecache.getlines(file)
        try:
            tree = ast.parse("".join(self._lines))
        except (SyntaxError, ValueError):  # edited since it was executed
            tree = ast.Module([], [])
        nodes = list(ast.walk(tree))
        self._functions = [node for node in nodes if isinstance(node, ast.FunctionDef)]
        # first and last line of each statement without inner statements
        self._statements = [
            (node.lineno, node.end_lineno or node.lineno)
            for node in nodes
            if isinstance(node, ast.stmt) and not hasattr(node, "body")
        ]

    def function(self, line: int) -> ast.FunctionDef | None:
        """Return the innermost function at a line, including its decorators."""
        inside = [each for each in self._functions if _first(each) <= line <= (each.end_lineno or 0)]
        return max(inside, key=_first, default=None)

    def statement(self, line: int) -> str:
        """Return the text of the statement at a line."""
        inside = [span for span in self._statements if span[0] <= line <= span[1]]
        return self.text(*min(inside, key=lambda span: span[1] - span[0], default=(line, line)))

    def text(self, first: int, last: int) -> str:
        """Return lines without their common indentation."""
        lines = self._lines[first - 1 : min(last, first + _LINES - 1)]
        return textwrap.dedent("".join(lines)).rstrip()


def _first(function: ast.FunctionDef) -> int:
    return min([function.lineno, *(each.lineno for each in function.decorator_list)])


class Authors:
    """Finds the author's function and line of a node; reads each file once."""

    def __init__(self) -> None:
        self._sources: dict[str, _Source] = {}

    def describe(self, node: Node) -> dict[str, str]:
        """Return the function of a node, such as `doors.shelf`, its line, and its statement."""
        file, _, number = node.where.rpartition(":")
        line = int(number) if number.isdecimal() else 0
        path = PurePath(file)
        source = self._sources.get(file) or self._sources.setdefault(file, _Source(file))
        function, text = source.function(line), source.statement(line)
        if node.op == PARAMETER:
            group, name = PARAMETERS, node.inputs["name"].rpartition(".")[2]
            for declared in [] if function is None else [*function.args.args, *function.args.kwonlyargs]:
                if declared.arg == name:
                    line, text = declared.lineno, source.text(declared.lineno, declared.lineno)
        else:
            module = path.parent.name if path.stem == "__init__" else path.stem
            group = module if function is None else f"{module}.{function.name}"
        return {"group": group, "where": f"{path.name}:{line}", "source": text}


_NAMES = 4  # most names in a text
_LONGEST = 60  # most characters of a literal


def value_text(value: Any) -> str:
    """Describe the value of a node."""
    if isinstance(value, bool | np.bool_):
        return str(bool(value))
    if isinstance(value, float | int | np.number):
        return _number(value)
    if isinstance(value, np.ndarray):
        return _array(value)
    if isinstance(value, Shape):
        size = np.ptp(value.bounds(), axis=0)
        return f"solid, {' x '.join(f'{each:.3g}' for each in size)} m, {len(value.mesh.triangles)} triangles"
    if isinstance(value, Tree):
        links, joints = [link.name for link in value.links()], [joint.name for joint in value.joints()]
        return _listed("link", links) + (f"; {_listed('joint', joints)}" if joints else "")
    if isinstance(value, AssetJoint):
        unit = "rad" if value.kind == "revolute" else "m"
        limits = "unlimited"
        if value.limits is not None:
            limits = f"{_number(value.limits[0])} to {_number(value.limits[1])} {unit}"
        return f"{value.kind} {value.name}, {limits}"
    if isinstance(value, Outline):
        points = sum(len(contour.points) for contour in value.contours)
        return f"profile, {_count(len(value.contours), 'contour')}, {_count(points, 'point')}"
    if isinstance(value, Curve):
        return f"{'closed path' if value.closed else 'path'}, {_count(len(value.points), 'point')}"
    return _cut(str(value))


def input_text(value: Any, number: Mapping[str, int]) -> list[str | int]:
    """Describe an input; numbers in the result refer to nodes."""
    if isinstance(value, Node):
        return [number[value.key]]
    if isinstance(value, tuple):
        parts: list[str | int] = ["("]
        for index, item in enumerate(value):
            parts += [", "] * (index > 0) + input_text(item, number)
        return [*parts, ")"]
    if isinstance(value, Mapping):  # JSON data of an object: {"$material": {"name": ...}}
        tag, data = next(iter(value.items()), ("", ""))
        named = data.get("name") if isinstance(data, Mapping) else data
        return [_cut(f"{str(tag).removeprefix('$')} {named}")]
    return [_number(value) if isinstance(value, float) else _cut(repr(value))]


def _array(value: np.ndarray[Any, Any]) -> str:
    if value.shape == (4, 4):
        return f"frame at {_row(value[:3, 3])}"
    if value.ndim == 1 and len(value) <= _NAMES:
        return _row(value)
    if value.ndim == 2 and len(value):
        return f"{_count(len(value), 'point')}, first {_row(value[0])}"
    return "empty"


def _row(values: Any) -> str:
    return f"({', '.join(_number(each) for each in values)})"


def _number(value: Any) -> str:
    return f"{float(value) + 0.0:.5g}"


def _listed(noun: str, names: list[str]) -> str:
    more = ", ..." if len(names) > _NAMES else ""
    return f"{_count(len(names), noun)}: {', '.join(names[:_NAMES])}{more}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


_BLANK = (0.72, 0.74, 0.76)  # linear color of a solid without a material
_MOST_POINTS = 400  # most points of a cloud
_STEPS = 65535  # positions along one side of a mesh: a hundredth of a millimetre on a door
_DIGITS = 6  # tolerance of positions [m]


class Geometry:
    """Collects the geometry of the nodes of a graph: each mesh once, with its places.

    Attributes:
        meshes: Number of vertices and triangles and bounding box of each mesh; the numbers themselves are in
            `blob`, one mesh after the other.
        items: Meshes in their places, lines, points and axes.
        blob: Positions (16 bits, within the bounding box), normals (8 bits) and triangles of all meshes.
    """

    def __init__(self) -> None:
        self.meshes: list[dict[str, Any]] = []
        self.items: list[dict[str, Any]] = []
        self.blob = bytearray()
        self._numbers: dict[Shape, int] = {}
        self._placed: dict[Any, int] = {}

    def add(self, value: Any) -> list[int]:
        """Add the value of a node and return the numbers of its items; empty for a number."""
        if isinstance(value, Shape):
            return [self._shape(value, _BLANK)]
        if isinstance(value, Tree):
            pieces = [piece for link in value.links() for piece in link.pieces]
            found = [self._shape(piece.shape, piece.material.base_color) for piece in pieces]
            return found + [self._item(item) for joint in value.joints() for item in _drawn(joint)]
        return [self._item(item) for item in _drawn(value)]

    def _item(self, item: dict[str, Any]) -> int:
        self.items.append(item)
        return len(self.items) - 1

    def _shape(self, shape: Shape, color: tuple[float, ...]) -> int:
        matrix = np.eye(4)
        while isinstance(shape, MovedShape):
            matrix, shape = matrix @ shape.matrix, shape.source
        if shape not in self._numbers:
            self._numbers[shape] = len(self.meshes)
            self._add_mesh(shape.mesh)
        mesh = self._numbers[shape]
        key = (mesh, matrix.tobytes(), color)
        if key not in self._placed:
            item = {"mesh": mesh, "color": [round(part, 3) for part in color]}
            if not np.array_equal(matrix, np.eye(4)):
                item["matrix"] = np.round(matrix.T.ravel(), _DIGITS).tolist()  # by columns, for WebGL
            self._placed[key] = self._item(item)
        return self._placed[key]

    def _add_mesh(self, mesh: Mesh) -> None:
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        size = np.maximum(high - low, 1e-9)
        wide = len(mesh.vertices) > _STEPS
        for numbers in (
            np.rint((mesh.vertices - low) / size * _STEPS).astype("<u2"),
            np.rint(mesh.normals * 127.0).astype("i1"),
            mesh.triangles.astype("<u4" if wide else "<u2"),
        ):
            self.blob += numbers.tobytes()
            self.blob += bytes(-len(self.blob) % 4)  # the next numbers begin at a multiple of 4
        self.meshes.append(
            {
                "vertices": len(mesh.vertices),
                "triangles": len(mesh.triangles),
                "low": np.round(low, _DIGITS).tolist(),
                "size": np.round(size, _DIGITS + 3).tolist(),
            }
        )


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
