"""A reader of GLB files, by glTF's specification and sharing no code with the writer."""

import io
import json
import struct
from collections.abc import Iterator
from typing import Any

import numpy as np
from PIL import Image
from scipy.spatial.transform import Rotation

from support.looks import Array, Channel, Look, constant, displayed, mapped

_TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_TRIANGLES, _REPEAT = 4, 10497

Mesh = tuple[Array, Array, Array]


def read_gltf(content: bytes) -> Iterator[tuple[list[str], Array, Mesh, Look]]:
    """Yield the primitives of the scene of a GLB file.

    Yields:
        The names of the nodes from the root on; the transform to the scene, shape (4, 4); corners (m, 3, 3),
        texture coordinates with v upwards (m, 3, 2) and normals (m, 3, 3); the material.
    """
    return _File(content).primitives()


class _File:
    def __init__(self, content: bytes) -> None:
        magic, version, length = struct.unpack_from("<4sII", content)
        assert (magic, version, length) == (b"glTF", 2, len(content))
        chunks, at = {}, 12
        while at < length:
            size, kind = struct.unpack_from("<I4s", content, at)
            chunks[kind] = content[at + 8 : at + 8 + size]
            at += 8 + size
        self._data = json.loads(chunks[b"JSON"])
        self._binary = chunks[b"BIN\0"]

    def primitives(self) -> Iterator[tuple[list[str], Array, Mesh, Look]]:
        """Yield the primitives below the nodes of the scene."""
        scene = self._data["scenes"][self._data["scene"]]
        stack: list[tuple[int, list[str], Array]] = [(node, [], np.eye(4)) for node in scene["nodes"]]
        while stack:
            number, names, above = stack.pop()
            node = self._data["nodes"][number]
            path, matrix = [*names, node["name"]], above @ _placement(node)
            stack += [(child, path, matrix) for child in node.get("children", [])]
            if "mesh" in node:
                for primitive in self._data["meshes"][node["mesh"]]["primitives"]:
                    yield path, matrix, self._corners(primitive), self._look(primitive)

    def _corners(self, primitive: dict[str, Any]) -> Mesh:
        assert primitive.get("mode", _TRIANGLES) == _TRIANGLES
        attributes = primitive["attributes"]
        faces = self._array(primitive["indices"]).reshape(-1, 3).astype(np.int64)
        points, normals = (self._array(attributes[name]).astype(float) for name in ("POSITION", "NORMAL"))
        uvs = np.zeros((len(points), 2))
        if "TEXCOORD_0" in attributes:
            uvs = self._array(attributes["TEXCOORD_0"]) * [1.0, -1.0] + [0.0, 1.0]  # rows begin at the top
        if "TANGENT" in attributes:
            _check_tangents(points, normals, uvs, self._array(attributes["TANGENT"]).astype(float), faces)
        return points[faces], uvs[faces], normals[faces]

    def _array(self, number: int) -> Array:
        accessor = self._data["accessors"][number]
        view = self._data["bufferViews"][accessor["bufferView"]]
        width, kind = _WIDTHS[accessor["type"]], np.dtype(_TYPES[accessor["componentType"]])
        assert view.get("byteStride", width * kind.itemsize) == width * kind.itemsize
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = np.frombuffer(self._binary, kind, accessor["count"] * width, start)
        return flat.reshape(-1, width) if width > 1 else flat

    def _look(self, primitive: dict[str, Any]) -> Look:
        material = self._data["materials"][primitive["material"]]
        pbr = material["pbrMetallicRoughness"]
        factor = np.array(pbr.get("baseColorFactor", [1.0] * 4))
        color = displayed(factor[:3])
        albedo, orm = (self._image(pbr.get(key)) for key in ("baseColorTexture", "metallicRoughnessTexture"))
        rough, metal = pbr.get("roughnessFactor", 1.0), pbr.get("metallicFactor", 1.0)
        normal = self._image(material.get("normalTexture"))
        if factor[3] < 1.0:
            assert material["alphaMode"] == "BLEND", "the glass would be opaque"
        return Look(
            constant(*color) if albedo is None else mapped(albedo, *color),
            constant(rough) if orm is None else mapped(orm[..., 1], rough),
            constant(metal) if orm is None else mapped(orm[..., 2], metal),
            constant(factor[3]),
            constant(*material.get("emissiveFactor", [0.0] * 3)),
            Channel(np.array([128 / 255, 128 / 255, 1.0])) if normal is None else mapped(normal),
        )

    def _image(self, info: dict[str, Any] | None) -> Any:
        if info is None:
            return None
        assert info.get("texCoord", 0) == 0
        texture = self._data["textures"][info["index"]]
        sampler = self._data["samplers"][texture["sampler"]]
        assert sampler.get("wrapS", _REPEAT) == sampler.get("wrapT", _REPEAT) == _REPEAT
        view = self._data["bufferViews"][self._data["images"][texture["source"]]["bufferView"]]
        start = view.get("byteOffset", 0)
        return np.asarray(
            Image.open(io.BytesIO(self._binary[start : start + view["byteLength"]])).convert("RGB")
        )


def _placement(node: dict[str, Any]) -> Array:
    assert "matrix" not in node
    assert "scale" not in node
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_quat(node.get("rotation", [0.0, 0.0, 0.0, 1.0])).as_matrix()
    matrix[:3, 3] = node.get("translation", [0.0, 0.0, 0.0])
    return matrix


def _check_tangents(points: Array, normals: Array, uvs: Array, tangents: Array, faces: Array) -> None:
    """Assert that tangents point to greater u, and their bitangents to greater v, on all but a few faces."""
    corners, laid = points[faces], uvs[faces]
    sides, change = corners[:, 1:] - corners[:, :1], laid[:, 1:] - laid[:, :1]
    determinant = np.linalg.det(change)
    sound = np.abs(determinant) > 1e-9
    if not sound.any():
        return
    gradient = np.linalg.inv(change[sound]) @ sides[sound]
    middle = tangents[faces[sound]].mean(axis=1)
    bitangents = np.cross(normals, tangents[:, :3]) * tangents[:, 3:]
    upward = bitangents[faces[sound]].mean(axis=1)
    right = (middle[:, :3] * gradient[:, 0]).sum(axis=1) > 0.0
    up = (upward * gradient[:, 1]).sum(axis=1) > 0.0
    area = np.linalg.norm(np.cross(sides[sound][:, 0], sides[sound][:, 1]), axis=1)
    share = area[right & up].sum() / area.sum()
    assert share > 0.98, f"tangents fit the texture on {share:.0%} of the surface"
