"""The binary part of a GLB file: accessors and images in one buffer, and the container."""

import json
import struct
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Json = dict[str, Any]
Content = Literal[
    "indices", "long_indices", "positions", "normals", "tangents", "texcoords", "times", "rotations", "moves"
]

_FLOAT, _SHORT, _LONG = 5126, 5123, 5125  # component types
_VERTICES, _INDICES = 34962, 34963  # targets of buffer views
_MOST_SHORT = 65535  # the largest short index restarts a strip

_LAYOUT: dict[Content, tuple[str, int, str, int]] = {
    "indices": ("SCALAR", _SHORT, "<u2", _INDICES),
    "long_indices": ("SCALAR", _LONG, "<u4", _INDICES),
    "positions": ("VEC3", _FLOAT, "<f4", _VERTICES),
    "normals": ("VEC3", _FLOAT, "<f4", _VERTICES),
    "tangents": ("VEC4", _FLOAT, "<f4", _VERTICES),
    "texcoords": ("VEC2", _FLOAT, "<f4", _VERTICES),
    "times": ("SCALAR", _FLOAT, "<f4", 0),
    "rotations": ("VEC4", _FLOAT, "<f4", 0),
    "moves": ("VEC3", _FLOAT, "<f4", 0),
}
"""Type, component type, number format and target of each kind of content; each kind has a buffer view."""

_BOUNDED = ("positions", "times")  # readers need their smallest and largest value
_DECIMALS = 7  # 0.1 micrometre: machines differ in the digits beyond


class Buffer:
    """The buffer of a GLB file."""

    def __init__(self) -> None:
        self.accessors: list[Json] = []  # descriptions of the arrays in the JSON part
        self._views: list[Json] = []
        self._chunks: list[list[bytes]] = []
        self._numbers: dict[Content, int] = {}

    def array(self, content: Content, values: ArrayLike) -> int:
        """Add an array, shape (n,) or (n, k); return the number of its accessor."""
        type_, component, form, _ = _LAYOUT[content]
        numbers = np.asarray(values)
        if component == _FLOAT:
            numbers = np.round(numbers, _DECIMALS) + 0.0
        numbers = numbers.astype(form)
        view = self._view(content)
        accessor: Json = {
            "bufferView": view,
            "byteOffset": self._views[view]["byteLength"],
            "componentType": component,
            "count": len(numbers),
            "type": type_,
        }
        if content in _BOUNDED:
            accessor["min"] = np.atleast_1d(numbers.min(axis=0)).tolist()
            accessor["max"] = np.atleast_1d(numbers.max(axis=0)).tolist()
        self._append(view, numbers.tobytes())
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def triangles(self, corners: NDArray[np.int64], vertices: int) -> int:
        """Add corners of triangles among a number of vertices, shape (m, 3); return the accessor."""
        return self.array("indices" if vertices <= _MOST_SHORT else "long_indices", corners.ravel())

    def image(self, content: bytes) -> int:
        """Add an image file; return the number of its buffer view."""
        return self._append(self._new_view(), content)

    def _view(self, content: Content) -> int:
        if content not in self._numbers:
            type_, _, _, target = _LAYOUT[content]
            # views with several accessors must have the length of a row
            stride = {"byteStride": 4 * int(type_.removeprefix("VEC"))} if target == _VERTICES else {}
            self._numbers[content] = self._new_view(**stride, **({"target": target} if target else {}))
        return self._numbers[content]

    def _new_view(self, **properties: int) -> int:
        self._views.append({"buffer": 0, "byteOffset": 0, "byteLength": 0, **properties})
        self._chunks.append([])
        return len(self._views) - 1

    def _append(self, view: int, content: bytes) -> int:
        self._chunks[view].append(content)
        self._views[view]["byteLength"] += len(content)
        return view

    def glb(self, scene: Json) -> bytes:
        """Return the GLB file of this buffer and of a scene without the data about the buffer."""
        length, chunks = 0, []
        for view, of_view in zip(self._views, self._chunks, strict=True):
            view["byteOffset"] = length
            padding = -view["byteLength"] % 4
            chunks += [*of_view, b"\0" * padding]
            length += view["byteLength"] + padding
        binary = {
            "accessors": self.accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": length}],
        }
        text = json.dumps({**scene, **binary}, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        header = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + length)
        heads = struct.pack("<I4s", len(text), b"JSON"), struct.pack("<I4s", length, b"BIN\0")
        return b"".join((header, heads[0], text, heads[1], *chunks))
