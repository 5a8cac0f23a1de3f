"""Surfaces of a GLB file: triangles, and materials with maps as JPEG and lacquer as an extension.

Glass is blended by its opacity, which every reader supports. Readers without `KHR_materials_transmission`
would draw it opaque; for others it costs a second pass over the scene and hides glass behind glass.
"""

import numpy as np

from artgen._arrays import Array
from artgen.asset import Mesh, Surface
from artgen.asset.surface import texture_coordinates
from artgen.export.glb.buffer import Buffer, Json
from artgen.materials import Material
from artgen.materials.textures import Kind, encoded, kinds, map_name

CLEARCOAT = "KHR_materials_clearcoat"

_LINEAR, _LINEAR_MIPMAP_LINEAR, _REPEAT = 9729, 9987, 10497
_SAMPLER = {"magFilter": _LINEAR, "minFilter": _LINEAR_MIPMAP_LINEAR, "wrapS": _REPEAT, "wrapT": _REPEAT}
_MAPS: tuple[Kind, ...] = ("albedo", "orm", "normal")
_NO_DIRECTION = 1e-9  # a tangent shorter than this share of the longest one has no direction


class Surfaces:
    """The surfaces of a file, with their materials and images, each once."""

    def __init__(self, buffer: Buffer, size: int) -> None:
        self._buffer = buffer
        self._size = size
        self._materials: dict[Material, tuple[int, Json]] = {}
        self._images: dict[str, Json] = {}

    def primitive(self, surface: Surface, origin: Array, *, directions: bool = True) -> Json:
        """Add a surface.

        Args:
            surface: The surface, in asset coordinates.
            origin: Origin of the link's frame in asset coordinates, shape (3,) [m].
            directions: Whether to write tangents for a normal map.

        Returns:
            The primitive as JSON data.
        """
        mesh, material, array = surface.mesh, surface.material, self._buffer.array
        attributes = {
            "POSITION": array("positions", mesh.vertices - origin),
            "NORMAL": array("normals", mesh.normals),
        }
        maps = self._maps(material)
        if maps:
            coordinates = texture_coordinates(mesh, material)
            # the origin of images is at the top: v points down
            attributes["TEXCOORD_0"] = array("texcoords", coordinates * (1.0, -1.0) + (0.0, 1.0))
            if "normal" in maps and directions:
                attributes["TANGENT"] = array("tangents", tangents(mesh, coordinates))
        indices = self._buffer.triangles(mesh.triangles, len(mesh.vertices))
        if material not in self._materials:
            self._materials[material] = len(self._materials), self._material(material)
        return {
            "attributes": attributes,
            "indices": indices,
            "extras": {"name": surface.name, "label": surface.label},
            "material": self._materials[material][0],
        }

    def to_data(self) -> Json:
        """Return the materials and images of the file."""
        materials = [material for _, material in self._materials.values()]
        data: Json = {"materials": materials}
        if any("extensions" in material for material in materials):
            data["extensionsUsed"] = [CLEARCOAT]
        if self._images:
            data["images"] = list(self._images.values())
            data["textures"] = [{"sampler": 0, "source": number} for number in range(len(self._images))]
            data["samplers"] = [_SAMPLER]
        return data

    def _maps(self, material: Material) -> list[Kind]:
        found = kinds(material) if self._size else ()
        return [kind for kind in _MAPS if kind in found]

    def _material(self, material: Material) -> Json:
        """Return a material as JSON data; maps are absolute, so their factor is 1."""
        textures = {kind: self._texture(material, kind) for kind in self._maps(material)}
        color = (1.0, 1.0, 1.0) if "albedo" in textures else material.base_color
        mapped = "orm" in textures
        pbr: Json = {
            "baseColorFactor": [*color, material.opacity],
            "metallicFactor": 1.0 if mapped else material.base_metalness,
            "roughnessFactor": 1.0 if mapped else material.specular_roughness,
        }
        result: Json = {"name": material.name, "pbrMetallicRoughness": pbr}
        if "albedo" in textures:
            pbr["baseColorTexture"] = textures["albedo"]
        if mapped:
            pbr["metallicRoughnessTexture"] = textures["orm"]
        if "normal" in textures:
            result["normalTexture"] = textures["normal"]
        if any(material.emission):
            result["emissiveFactor"] = list(material.emission)
        if material.opacity < 1.0:
            result["alphaMode"] = "BLEND"
        if material.coat_weight > 0.0:
            factors = {
                "clearcoatFactor": material.coat_weight,
                "clearcoatRoughnessFactor": material.coat_roughness,
            }
            result["extensions"] = {CLEARCOAT: factors}
        return result

    def _texture(self, material: Material, kind: Kind) -> Json:
        name = map_name(material, kind)
        if name not in self._images:
            view = self._buffer.image(encoded(material, kind, self._size, "jpg"))
            self._images[name] = {"bufferView": view, "mimeType": "image/jpeg", "name": name}
        return {"index": list(self._images).index(name)}


def tangents(mesh: Mesh, coordinates: Array) -> Array:
    """Return for each vertex the direction of growing u, and whether v grows to its left.

    Readers would compute different tangents; given tangents make all readers draw the same.
    """
    sides = _sides(mesh.vertices[mesh.triangles])
    (du, dv), (eu, ev) = (side.T for side in _sides(coordinates[mesh.triangles]))
    way = np.sign(du * ev - eu * dv)
    along_u = _summed(mesh, (sides[0] * ev[:, None] - sides[1] * dv[:, None]) * way[:, None])
    along_v = _summed(mesh, (sides[1] * du[:, None] - sides[0] * eu[:, None]) * way[:, None])
    normals = mesh.normals
    along_u -= normals * (normals * along_u).sum(axis=1, keepdims=True)
    length = np.sqrt((along_u**2).sum(axis=1))
    lost = length <= _NO_DIRECTION * length.max(initial=0.0)
    along_u[lost] = _perpendicular(normals[lost])
    length[lost] = 1.0
    along_u /= length[:, None]
    left = (np.cross(normals, along_u) * along_v).sum(axis=1) >= 0.0
    return np.column_stack([along_u, np.where(left, 1.0, -1.0)])


def _sides(corners: Array) -> tuple[Array, Array]:
    """Return two sides of triangles with corners of shape (m, 3, k), each of shape (m, k)."""
    return corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]


def _summed(mesh: Mesh, values: Array) -> Array:
    """Return for each vertex the sum of the values of its triangles, shape (n, 3)."""
    corners, count = mesh.triangles.ravel(), len(mesh.vertices)
    sums = [np.bincount(corners, np.repeat(column, 3), count) for column in values.T]
    return np.column_stack(sums)


def _perpendicular(normals: Array) -> Array:
    """Return unit vectors perpendicular to given vectors, shape (n, 3)."""
    least = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
    result = np.cross(normals, least)
    return np.asarray(result / np.sqrt((result**2).sum(axis=1, keepdims=True)))
