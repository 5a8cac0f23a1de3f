"""The maps of an asset's materials as image files, which its formats share."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from artgen._caching import cached
from artgen.asset import Asset
from artgen.asset.files import MESH_DIRECTORY
from artgen.materials import Material
from artgen.materials.textures import Kind, encoded, kinds, map_name

TEXTURE_DIRECTORY = f"{MESH_DIRECTORY}/textures"
"""Where the maps lie in an export: below the meshes, since some readers take none that is reached by `..`."""

# one channel each, as MTL and MuJoCo read them, so that all formats share the same files
_KINDS: tuple[Kind, ...] = ("albedo", "roughness", "metalness", "normal")


@dataclass(frozen=True)
class MapFiles:
    """The image files of an asset's maps.

    Attributes:
        files: Content by path relative to the asset's directory.
        names: File name of each map, by name of the material and kind.
    """

    files: Mapping[str, bytes] = field(default_factory=dict)
    names: Mapping[str, Mapping[Kind, str]] = field(default_factory=dict)

    def of(self, material: Material) -> Mapping[Kind, str]:
        """Return the file name of each map of a material; none where it has none or is on no surface."""
        return self.names.get(material.name, {})


@cached(1)  # several formats are written of one asset after another
def map_files(asset: Asset, size: int) -> MapFiles:
    """Return the maps of the materials that are seen.

    Args:
        asset: The asset.
        size: Texels on a side, of `artgen.materials.textures.SIZES`; 0 for no maps.
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
