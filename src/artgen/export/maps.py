"""Maps of an asset's materials as image files for all formats, and the Phong model of older renderers."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from artgen._arrays import cached
from artgen.asset import Asset
from artgen.asset.files import MESH_DIRECTORY
from artgen.materials import Material
from artgen.materials.textures import Kind, encoded, kinds, map_name

_DIELECTRIC = 0.04  # reflectance of plastic, wood and lacquer at normal incidence
_MOST = 1000.0  # largest exponent of MTL


def phong_exponent(roughness: float) -> float:
    """Return the Phong exponent with a highlight as wide as that of a GGX roughness in 0..1."""
    return min(max(2.0 / max(roughness, 1e-2) ** 4 - 2.0, 1.0), _MOST)


def specular_color(material: Material) -> tuple[float, float, float]:
    """Return the reflectance at normal incidence, linear RGB."""
    metal = material.base_metalness
    red, green, blue = (metal * channel + (1.0 - metal) * _DIELECTRIC for channel in material.base_color)
    return red, green, blue


def highlight(material: Material, greatest: float) -> tuple[float, float]:
    """Return strength in 0..1 and exponent of the highlight of a material, or of its stronger lacquer.

    The strength belongs to the normalized model, in which narrower highlights are brighter.
    """
    layers = (
        (max(specular_color(material)), material.specular_roughness),
        (material.coat_weight * _DIELECTRIC, material.coat_roughness),
    )
    exponents = [min(phong_exponent(roughness), greatest) for _, roughness in layers]
    peaks = [(exponent + 2.0) / 8.0 * share for exponent, (share, _) in zip(exponents, layers, strict=True)]
    strength, exponent = max(zip(peaks, exponents, strict=True))
    return min(strength, 1.0), exponent


TEXTURE_DIRECTORY = f"{MESH_DIRECTORY}/textures"
"""Directory of the maps in an export: below the meshes, because some readers do not follow `..`."""

# one channel each, for MTL and MuJoCo, so that all formats share the same files
_KINDS: tuple[Kind, ...] = ("albedo", "roughness", "metalness", "normal")


@dataclass(frozen=True)
class MapFiles:
    """The image files of an asset's maps."""

    files: Mapping[str, bytes] = field(default_factory=dict)  # content by path in the asset's directory
    # file name of each map, by name of the material and kind
    names: Mapping[str, Mapping[Kind, str]] = field(default_factory=dict)

    def of(self, material: Material) -> Mapping[Kind, str]:
        """Return the file name of each map of a material; empty if it has none or is on no surface."""
        return self.names.get(material.name, {})


@cached(1)  # several formats of one asset are written in sequence
def map_files(asset: Asset, size: int) -> MapFiles:
    """Return the maps of the visible materials.

    Args:
        asset: The asset.
        size: Texels per side, one of `artgen.materials.textures.SIZES`; 0 for no maps.
    """
    files: dict[str, bytes] = {}
    names: dict[str, dict[Kind, str]] = {}
    if not size:
        return MapFiles()
    for material in dict.fromkeys(surface.material for link in asset.links for surface in link.surfaces):
        found = [kind for kind in kinds(material) if kind in _KINDS]
        names[material.name] = {kind: f"{map_name(material, kind)}.png" for kind in found}
        for kind, name in names[material.name].items():
            path = f"{TEXTURE_DIRECTORY}/{name}"
            if path not in files:
                files[path] = encoded(material, kind, size, "png")
    return MapFiles(files, names)
