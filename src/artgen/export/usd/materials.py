"""Materials as USD prims: preview and OpenPBR surfaces, friction for contacts, labels for other sensors."""

from collections.abc import Mapping
from typing import Any

from pxr import Sdf

from artgen.asset import Asset
from artgen.export.losses import seen_materials
from artgen.export.maps import MapFiles
from artgen.export.usd.layer import TYPES, Layers, apply, define, write
from artgen.materials import Material
from artgen.materials.substance import coating_of, substance_of
from artgen.materials.textures import Kind

Maps = Mapping[Kind, str]
"""Path of each map of a material."""

_PREVIEW_INPUTS: Maps = {
    "albedo": "diffuseColor", "roughness": "roughness", "metalness": "metallic", "normal": "normal",
}  # fmt: skip

_OPENPBR_INPUTS: Mapping[Kind, tuple[str, str, Sdf.ValueTypeName]] = {
    "albedo": ("base_color", "ND_image_color3", TYPES.Color3f),
    "roughness": ("specular_roughness", "ND_image_float", TYPES.Float),
    "metalness": ("base_metalness", "ND_image_float", TYPES.Float),
    "normal": ("geometry_normal", "ND_image_vector3", TYPES.Float3),
}
"""Input of the surface, node that reads its map, and type of both, by kind of map."""


def write_materials(layers: Layers, root: Sdf.PrimSpec, name: str, asset: Asset, maps: MapFiles) -> Sdf.Path:
    """Add the materials of an asset and return the path of their scope.

    Args:
        layers: Layers for their physics, and location of their maps.
        root: The parent prim of the scope.
        name: The name of the scope.
        asset: The asset.
        maps: The maps of its materials.
    """
    scope = define(root, name, "Scope")
    seen = seen_materials(asset)
    for material in asset.materials:
        substance = substance_of(material)
        labels = {"semantics:labels:material": [substance.name, substance.code]}
        prim = define(scope, material.name, "Material", labels, schemas=["SemanticsLabelsAPI:material"])
        physics = layers.physical(prim)
        apply(physics, "PhysicsMaterialAPI")
        values = {
            "physics:dynamicFriction": material.friction,
            "physics:restitution": 0.0,
            "physics:staticFriction": material.friction,
        }
        write(physics, values)
        if material in seen:
            write(prim, _sensed(material))
        files = {kind: f"{layers.maps}/{file}" for kind, file in maps.of(material).items()}
        _write_preview(prim, material, files)
        if layers.openpbr:
            _write_openpbr(prim, material, files)
    return scope.path


def _sensed(material: Material) -> dict[str, Any]:
    """Return SimReady's attributes for models of lidar, radar and sonar."""
    attributes = ["emissive"] if any(material.emission) else []
    if material.transmission_weight >= 0.5 or material.opacity < 0.9:
        attributes.append("visually_transparent")
    prefix = "omni:simready:nonvisual:"
    return {
        prefix + "attributes": attributes or ["none"],
        prefix + "base": substance_of(material).sensed,
        prefix + "coating": coating_of(material),
    }


def _shader(parent: Sdf.PrimSpec, name: str, identifier: str, inputs: Mapping[str, Any]) -> Sdf.PrimSpec:
    values = {f"inputs:{name}": value for name, value in inputs.items()}
    return define(parent, name, "Shader", {"info:id": identifier, **values})


def _output(shader: Sdf.PrimSpec, name: str, kind: Sdf.ValueTypeName) -> Sdf.Path:
    return Sdf.AttributeSpec(shader, f"outputs:{name}", kind).path


def _write_preview(prim: Sdf.PrimSpec, material: Material, maps: Maps) -> None:
    """Add the preview surface, which every reader of USD supports."""
    values = {
        "diffuseColor": material.base_color,
        "emissiveColor": material.emission,
        "clearcoat": material.coat_weight,
        "clearcoatRoughness": material.coat_roughness,
        "ior": 1.5,
        "metallic": material.base_metalness,
        "opacity": material.opacity,
        "roughness": material.specular_roughness,
    }
    mapped = {_PREVIEW_INPUTS[kind]: None for kind in maps}
    surface = _shader(prim, "surface", "UsdPreviewSurface", values | mapped)
    if maps:
        coordinates = _shader(prim, "coordinates", "UsdPrimvarReader_float2", {"varname": "st"})
        st = _output(coordinates, "result", TYPES.Float2)
    for kind, file in maps.items():
        inputs = {
            "file": file,
            "st": st,
            "sourceColorSpace": "sRGB" if kind == "albedo" else "raw",
            "wrapS": "repeat",
            "wrapT": "repeat",
            "fallback": _fallback(kind, material),
        }
        if kind == "normal":  # from 0..1 to -1..1
            inputs |= {"bias": (-1.0, -1.0, -1.0, 0.0), "scale": (2.0, 2.0, 2.0, 1.0)}
        reader = _shader(prim, kind, "UsdUVTexture", inputs)
        single = kind in ("roughness", "metalness")
        output = _output(reader, "r", TYPES.Float) if single else _output(reader, "rgb", TYPES.Float3)
        write(surface, {f"inputs:{_PREVIEW_INPUTS[kind]}": output})
    write(prim, {"outputs:surface": _output(surface, "surface", TYPES.Token)})


def _fallback(kind: Kind, material: Material) -> tuple[float, float, float, float]:
    """Return the fallback of a renderer that cannot read the map, which is not scaled or biased."""
    if kind == "albedo":
        return *material.base_color, 1.0
    if kind == "normal":
        return 0.0, 0.0, 1.0, 1.0
    value = material.specular_roughness if kind == "roughness" else material.base_metalness
    return value, value, value, 1.0


def _write_openpbr(prim: Sdf.PrimSpec, material: Material, maps: Maps) -> None:
    """Add an OpenPBR surface to the prim of a material."""
    clear, shines = material.transmission_weight > 0.0, any(material.emission)
    values = {
        "base_color": material.base_color,
        "emission_color": material.emission if shines else None,
        "transmission_color": material.base_color if clear else None,
        "base_metalness": material.base_metalness,
        "coat_roughness": material.coat_roughness,
        "coat_weight": material.coat_weight,
        "emission_luminance": 1.0 if shines else None,
        # a preview surface shows thin glass, because it cannot refract
        "geometry_opacity": 1.0 if clear else material.opacity,
        "specular_ior": 1.5,
        "specular_roughness": material.specular_roughness,
        "transmission_weight": material.transmission_weight,
    }
    mapped = {_OPENPBR_INPUTS[kind][0]: None for kind in maps}
    surface = _shader(prim, "openpbr", "ND_open_pbr_surface_surfaceshader", values | mapped)
    if maps:
        coordinates = _shader(prim, "openpbr_coordinates", "ND_geompropvalue_vector2", {"geomprop": "st"})
        st = _output(coordinates, "out", TYPES.Float2)
    for kind, file in maps.items():
        name, node, value_type = _OPENPBR_INPUTS[kind]
        reader = _shader(prim, f"openpbr_{kind}", node, {"file": file})
        space = "srgb_texture" if kind == "albedo" else "none"
        reader.attributes["inputs:file"].SetInfo("colorSpace", space)
        write(reader, {"inputs:texcoord": st})
        output = _output(reader, "out", value_type)
        if kind == "normal":  # from a texel, in 0..1, to the surface's frame
            turned = _shader(prim, "openpbr_normal_map", "ND_normalmap_float", {"in": output})
            output = _output(turned, "out", TYPES.Float3)
        write(surface, {f"inputs:{name}": output})
    write(prim, {"outputs:mtlx:surface": _output(surface, "out", TYPES.Token)})
