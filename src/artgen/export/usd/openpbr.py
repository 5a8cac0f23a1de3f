"""Materials as OpenPBR surfaces: networks of MaterialX nodes, for renderers that know coats and glass."""

from collections.abc import Mapping

from pxr import Sdf

from artgen.export.usd.layer import TYPES, connect, define, vec3, write
from artgen.materials import Material
from artgen.materials.textures import Kind

_INPUTS: dict[Kind, tuple[str, str, Sdf.ValueTypeName]] = {
    "albedo": ("base_color", "ND_image_color3", TYPES.Color3f),
    "roughness": ("specular_roughness", "ND_image_float", TYPES.Float),
    "metalness": ("base_metalness", "ND_image_float", TYPES.Float),
    "normal": ("geometry_normal", "ND_image_vector3", TYPES.Float3),
}


def write_openpbr(material_prim: Sdf.PrimSpec, material: Material, maps: Mapping[Kind, str]) -> None:
    """Add an OpenPBR surface to the prim of a material."""
    shader = define(material_prim, "openpbr", "Shader")
    write(shader, TYPES.Token, {"info:id": "ND_open_pbr_surface_surfaceshader"}, uniform=True)
    mapped = {_INPUTS[kind][0] for kind in maps}
    clear = material.transmission_weight > 0.0
    shares = {
        "base_metalness": material.base_metalness,
        "coat_roughness": material.coat_roughness,
        "coat_weight": material.coat_weight,
        # a preview surface thins glass, since it cannot refract
        "geometry_opacity": 1.0 if clear else material.opacity,
        "specular_ior": 1.5,
        "specular_roughness": material.specular_roughness,
        "transmission_weight": material.transmission_weight,
    }
    colors = {"base_color": material.base_color}
    if clear:
        colors["transmission_color"] = material.base_color
    if any(material.emission):
        colors["emission_color"] = material.emission
        shares["emission_luminance"] = 1.0
    for kind, values in (
        (TYPES.Color3f, {name: vec3(color) for name, color in colors.items()}),
        (TYPES.Float, shares),
    ):
        write(shader, kind, {f"inputs:{n}": value for n, value in sorted(values.items()) if n not in mapped})
    if maps:
        _write_maps(material_prim, shader, maps)
    Sdf.AttributeSpec(shader, "outputs:out", TYPES.Token)
    connect(material_prim, "outputs:mtlx:surface", shader.path.AppendProperty("outputs:out"))


def _write_maps(prim: Sdf.PrimSpec, surface: Sdf.PrimSpec, maps: Mapping[Kind, str]) -> None:
    coordinates = define(prim, "openpbr_coordinates", "Shader")
    write(coordinates, TYPES.Token, {"info:id": "ND_geompropvalue_vector2"}, uniform=True)
    write(coordinates, TYPES.String, {"inputs:geomprop": "st"})
    st = Sdf.AttributeSpec(coordinates, "outputs:out", TYPES.Float2)
    for kind, file in maps.items():
        name, node, type_name = _INPUTS[kind]
        reader = define(prim, f"openpbr_{kind}", "Shader")
        write(reader, TYPES.Token, {"info:id": node}, uniform=True)
        image = Sdf.AttributeSpec(reader, "inputs:file", TYPES.Asset)
        image.default = Sdf.AssetPath(file)
        image.SetInfo("colorSpace", "srgb_texture" if kind == "albedo" else "none")
        connect(reader, "inputs:texcoord", st.path, TYPES.Float2)
        source = Sdf.AttributeSpec(reader, "outputs:out", type_name)
        if kind == "normal":
            source = _turned_to_surface(prim, source)
        connect(surface, f"inputs:{name}", source.path, type_name)


def _turned_to_surface(prim: Sdf.PrimSpec, texel: Sdf.AttributeSpec) -> Sdf.AttributeSpec:
    """Add the node that takes a map's normal, in 0..1, to the surface's frame; return its output."""
    turned = define(prim, "openpbr_normal_map", "Shader")
    write(turned, TYPES.Token, {"info:id": "ND_normalmap_float"}, uniform=True)
    connect(turned, "inputs:in", texel.path, TYPES.Float3)
    return Sdf.AttributeSpec(turned, "outputs:out", TYPES.Float3)
