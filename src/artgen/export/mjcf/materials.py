"""Materials of MJCF for both renderers of MuJoCo: the classic Phong renderer and the physically based one."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable

from artgen.asset import Asset
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, highlight
from artgen.export.meshes import display_color
from artgen.materials import Material
from artgen.materials.textures import Kind

_ROLES: dict[Kind, str] = {
    "albedo": "rgb", "normal": "normal", "roughness": "roughness", "metalness": "metallic",
}  # fmt: skip
_GREATEST = 128.0  # exponent of the classic renderer at shininess 1


def add_materials(parent: ET.Element, asset: Asset, maps: MapFiles) -> None:
    """Add the materials of an asset to `<asset>`, with their maps as layers.

    Their names and those of the maps begin with the asset's name, because assets in one scene may share
    materials.

    The classic renderer shows the color map unchanged only if MuJoCo chooses its color space: it decodes
    sRGB, but does not encode again.
    """
    added: set[str] = set()
    for material in asset.materials:
        names = maps.of(material)
        layers = {
            role: f"{asset.name}_{_stem(names[kind])}" for kind, role in _ROLES.items() if kind in names
        }
        for name in (names[kind] for kind in _ROLES if kind in names):
            if name not in added:
                file = f"{TEXTURE_DIRECTORY}/{name}"
                ET.SubElement(parent, "texture", type="2d", name=f"{asset.name}_{_stem(name)}", file=file)
                added.add(name)
        if any(material.emission):
            layers["emissive"] = _add_emission(parent, asset, material)
        element = ET.SubElement(parent, "material", _attributes(asset, material, layers))
        for role, texture in layers.items():
            ET.SubElement(element, "layer", role=role, texture=texture)


def material_name(asset: Asset, material: Material) -> str:
    """Return the name of a material of an asset."""
    return f"{asset.name}_{material.name}"


def _attributes(asset: Asset, material: Material, layers: Iterable[str]) -> dict[str, str]:
    """Return the numbers of a material; MuJoCo multiplies them with its maps."""
    color = (1.0, 1.0, 1.0) if "rgb" in layers else material.base_color
    specular, exponent = highlight(material, _GREATEST)
    attributes = {
        "name": material_name(asset, material),
        "rgba": numbers([*display_color(color), material.opacity]),
        "specular": numbers([round(specular, 6)]),
        "shininess": numbers([round(exponent / _GREATEST, 6)]),
        "roughness": numbers([1.0 if "roughness" in layers else material.specular_roughness]),
        "metallic": numbers([1.0 if "metallic" in layers else material.base_metalness]),
    }
    if any(material.emission):
        attributes["emission"] = numbers([_emission(material)])
    return attributes


def _emission(material: Material) -> float:
    """Return the emission as a factor of the color, for MuJoCo's classic renderer."""
    return max(material.emission) / max(*material.base_color, 1e-3)


def _add_emission(parent: ET.Element, asset: Asset, material: Material) -> str:
    """Add the color of the light as a map of one texel, which the other renderer needs."""
    name = f"{material_name(asset, material)}_emission"
    color = [channel / _emission(material) for channel in material.emission]
    ET.SubElement(
        parent, "texture", type="2d", name=name, builtin="flat", rgb1=numbers(color), width="1", height="1"
    )
    return name


def numbers(values: Iterable[float]) -> str:
    """Format numbers with the digits in which all machines agree."""
    return " ".join(f"{float(value) + 0.0:.12g}" for value in values)


def _stem(file: str) -> str:
    return file.removesuffix(".png")
