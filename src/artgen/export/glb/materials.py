"""Materials of a GLB file: metallic-roughness with maps as JPEG, lacquer as an extension.

Glass is blended by its opacity, which every reader supports. Readers without `KHR_materials_transmission`
would draw it opaque; for others it costs a second pass over the scene and hides glass behind glass.
"""

from artgen.export.glb.buffer import Buffer, Json
from artgen.materials import Material
from artgen.materials.textures import Kind, encoded, kinds, map_name

CLEARCOAT = "KHR_materials_clearcoat"

_LINEAR, _LINEAR_MIPMAP_LINEAR, _REPEAT = 9729, 9987, 10497
_MAPS: tuple[Kind, ...] = ("albedo", "orm", "normal")


class Looks:
    """The materials and images of a file, each once, with their numbers.

    Attributes:
        materials: Materials as JSON data.
    """

    def __init__(self, buffer: Buffer, size: int) -> None:
        self.materials: list[Json] = []
        self._buffer = buffer
        self._size = size
        self._numbers: dict[Material, int] = {}
        self._images: dict[str, Json] = {}

    def maps(self, material: Material) -> tuple[Kind, ...]:
        """Return the maps of a material."""
        if not self._size:
            return ()
        found = kinds(material)
        return tuple(kind for kind in _MAPS if kind in found)

    def number(self, material: Material) -> int:
        """Return the number of a material; a new material is added."""
        if material not in self._numbers:
            self._numbers[material] = len(self.materials)
            self.materials.append(self._material(material))
        return self._numbers[material]

    def to_data(self) -> Json:
        """Return the materials and images of the file."""
        data: Json = {"materials": self.materials}
        if any("extensions" in material for material in self.materials):
            data["extensionsUsed"] = [CLEARCOAT]
        if self._images:
            data["images"] = list(self._images.values())
            data["textures"] = [{"sampler": 0, "source": number} for number in range(len(self._images))]
            data["samplers"] = [
                {
                    "magFilter": _LINEAR,
                    "minFilter": _LINEAR_MIPMAP_LINEAR,
                    "wrapS": _REPEAT,
                    "wrapT": _REPEAT,
                }
            ]
        return data

    def _material(self, material: Material) -> Json:
        """Return a material as JSON data; maps are absolute, so their factor is 1."""
        maps = self.maps(material)
        color = (1.0, 1.0, 1.0) if "albedo" in maps else material.base_color
        mapped = "orm" in maps
        pbr: Json = {
            "baseColorFactor": [*color, material.opacity],
            "metallicFactor": 1.0 if mapped else material.base_metalness,
            "roughnessFactor": 1.0 if mapped else material.specular_roughness,
        }
        result: Json = {"name": material.name, "pbrMetallicRoughness": pbr}
        if "albedo" in maps:
            pbr["baseColorTexture"] = self._texture(material, "albedo")
        if mapped:
            pbr["metallicRoughnessTexture"] = self._texture(material, "orm")
        if "normal" in maps:
            result["normalTexture"] = self._texture(material, "normal")
        if any(material.emission):
            result["emissiveFactor"] = list(material.emission)
        if material.opacity < 1.0:
            result["alphaMode"] = "BLEND"
        if material.coat_weight > 0.0:
            coat = {
                "clearcoatFactor": material.coat_weight,
                "clearcoatRoughnessFactor": material.coat_roughness,
            }
            result["extensions"] = {CLEARCOAT: coat}
        return result

    def _texture(self, material: Material, kind: Kind) -> Json:
        name = map_name(material, kind)
        if name not in self._images:
            view = self._buffer.image(encoded(material, kind, self._size, "jpg"))
            self._images[name] = {"bufferView": view, "mimeType": "image/jpeg", "name": name}
        return {"index": list(self._images).index(name)}
