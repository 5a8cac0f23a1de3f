"""Materials as USD prims: preview and OpenPBR surfaces, friction for contacts, labels for other sensors."""

from collections.abc import Mapping

from pxr import Gf, Sdf, Vt

from artgen.export.usd.layer import TYPES, Layers, apply, connect, define, vec3, write
from artgen.materials import Material
from artgen.materials.substance import coating_of, substance_of
from artgen.materials.textures import Kind

_OPENPBR_INPUTS: dict[Kind, tuple[str, str, Sdf.ValueTypeName]] = {
    "albedo": ("base_color", "ND_image_color3", TYPES.Color3f),
    "roughness": ("specular_roughness", "ND_image_float", TYPES.Float),
    "metalness": ("base_metalness", "ND_image_float", TYPES.Float),
    "normal": ("geometry_normal", "ND_image_vector3", TYPES.Float3),
}


def write_openpbr(material_prim: Sdf.PrimSpec, material: Material, maps: Mapping[Kind, str]) -> None:
    """Add an OpenPBR surface to the prim of a material."""
    shader = define(material_prim, "openpbr", "Shader")
    write(shader, TYPES.Token, {"info:id": "ND_open_pbr_surface_surfaceshader"}, uniform=True)
    mapped = {_OPENPBR_INPUTS[kind][0] for kind in maps}
    clear = material.transmission_weight > 0.0
    shares = {
        "base_metalness": material.base_metalness,
        "coat_roughness": material.coat_roughness,
        "coat_weight": material.coat_weight,
        # a preview surface shows thin glass, because it cannot refract
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
        _write_openpbr_maps(material_prim, shader, maps)
    Sdf.AttributeSpec(shader, "outputs:out", TYPES.Token)
    connect(material_prim, "outputs:mtlx:surface", shader.path.AppendProperty("outputs:out"))


def _write_openpbr_maps(prim: Sdf.PrimSpec, surface: Sdf.PrimSpec, maps: Mapping[Kind, str]) -> None:
    coordinates = define(prim, "openpbr_coordinates", "Shader")
    write(coordinates, TYPES.Token, {"info:id": "ND_geompropvalue_vector2"}, uniform=True)
    write(coordinates, TYPES.String, {"inputs:geomprop": "st"})
    st = Sdf.AttributeSpec(coordinates, "outputs:out", TYPES.Float2)
    for kind, file in maps.items():
        name, node, type_name = _OPENPBR_INPUTS[kind]
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
    """Add the node that transforms a map's normal, in 0..1, to the surface's frame; return its output."""
    turned = define(prim, "openpbr_normal_map", "Shader")
    write(turned, TYPES.Token, {"info:id": "ND_normalmap_float"}, uniform=True)
    connect(turned, "inputs:in", texel.path, TYPES.Float3)
    return Sdf.AttributeSpec(turned, "outputs:out", TYPES.Float3)


_INPUTS: dict[Kind, str] = {
    "albedo": "diffuseColor", "roughness": "roughness", "metalness": "metallic", "normal": "normal",
}  # fmt: skip


def write_material(
    layers: Layers, scope: Sdf.PrimSpec, material: Material, maps: Mapping[Kind, str], *, seen: bool
) -> None:
    """Add a material.

    Args:
        layers: Layers for its physics, and location of its maps.
        scope: The parent prim.
        material: The material.
        maps: File name of each of its maps.
        seen: Whether it is on a surface, not only on colliders.
    """
    prim = define(scope, material.name, "Material", ["SemanticsLabelsAPI:material"])
    substance = substance_of(material)
    write(
        prim, TYPES.TokenArray, {"semantics:labels:material": Vt.TokenArray([substance.name, substance.code])}
    )
    physics = layers.physical(prim)
    apply(physics, "PhysicsMaterialAPI")
    friction = material.friction
    write(
        physics,
        TYPES.Float,
        {"physics:dynamicFriction": friction, "physics:restitution": 0.0, "physics:staticFriction": friction},
    )
    if seen:
        _sensed(prim, material)
    files = {kind: f"{layers.maps}/{name}" for kind, name in maps.items()}
    _preview(prim, material, files)
    if layers.openpbr:
        write_openpbr(prim, material, files)


def _sensed(prim: Sdf.PrimSpec, material: Material) -> None:
    """Write SimReady's attributes for models of lidar, radar and sonar."""
    attributes = ["emissive"] if any(material.emission) else []
    if material.transmission_weight >= 0.5 or material.opacity < 0.9:
        attributes.append("visually_transparent")
    prefix = "omni:simready:nonvisual:"
    write(prim, TYPES.TokenArray, {prefix + "attributes": Vt.TokenArray(attributes or ["none"])})
    write(
        prim,
        TYPES.Token,
        {prefix + "base": substance_of(material).sensed, prefix + "coating": coating_of(material)},
    )


def _preview(prim: Sdf.PrimSpec, material: Material, maps: Mapping[Kind, str]) -> None:
    """Add the preview surface, which every reader of USD supports."""
    shader = define(prim, "surface", "Shader")
    write(shader, TYPES.Token, {"info:id": "UsdPreviewSurface"}, uniform=True)
    colors = {"diffuseColor": material.base_color, "emissiveColor": material.emission}
    shares = {
        "clearcoat": material.coat_weight,
        "clearcoatRoughness": material.coat_roughness,
        "ior": 1.5,
        "metallic": material.base_metalness,
        "opacity": material.opacity,
        "roughness": material.specular_roughness,
    }
    mapped = {_INPUTS[kind] for kind in maps}
    for name, color in colors.items():
        if name not in mapped:
            write(shader, TYPES.Color3f, {f"inputs:{name}": vec3(color)})
    write(
        shader,
        TYPES.Float,
        {f"inputs:{name}": share for name, share in shares.items() if name not in mapped},
    )
    if maps:
        _write_maps(prim, shader, material, maps)
    Sdf.AttributeSpec(shader, "outputs:surface", TYPES.Token)
    connect(prim, "outputs:surface", shader.path.AppendProperty("outputs:surface"))


def _write_maps(
    prim: Sdf.PrimSpec, shader: Sdf.PrimSpec, material: Material, maps: Mapping[Kind, str]
) -> None:
    """Add readers of the maps and of the texture coordinates, and connect the surface to them."""
    coordinates = define(prim, "coordinates", "Shader")
    write(coordinates, TYPES.Token, {"info:id": "UsdPrimvarReader_float2"}, uniform=True)
    write(coordinates, TYPES.String, {"inputs:varname": "st"})
    st = Sdf.AttributeSpec(coordinates, "outputs:result", TYPES.Float2)
    for kind, file in maps.items():
        reader = define(prim, kind, "Shader")
        write(reader, TYPES.Token, {"info:id": "UsdUVTexture"}, uniform=True)
        write(reader, TYPES.Asset, {"inputs:file": Sdf.AssetPath(file)})
        connect(reader, "inputs:st", st.path, TYPES.Float2)
        space = "sRGB" if kind == "albedo" else "raw"
        write(
            reader,
            TYPES.Token,
            {"inputs:sourceColorSpace": space, "inputs:wrapS": "repeat", "inputs:wrapT": "repeat"},
        )
        write(reader, TYPES.Float4, {"inputs:fallback": _fallback(kind, material)})
        if kind == "normal":
            # from 0..1 to -1..1
            scale, bias = Gf.Vec4f(2.0, 2.0, 2.0, 1.0), Gf.Vec4f(-1.0, -1.0, -1.0, 0.0)
            write(reader, TYPES.Float4, {"inputs:bias": bias, "inputs:scale": scale})
        single = kind in ("roughness", "metalness")
        output = "outputs:r" if single else "outputs:rgb"
        Sdf.AttributeSpec(reader, output, TYPES.Float if single else TYPES.Float3)
        types = {"albedo": TYPES.Color3f, "normal": TYPES.Normal3f}
        connect(
            shader,
            f"inputs:{_INPUTS[kind]}",
            reader.path.AppendProperty(output),
            types.get(kind, TYPES.Float),
        )


def _fallback(kind: Kind, material: Material) -> Gf.Vec4f:
    """Return the fallback of a renderer that cannot read the map, which is not scaled or biased."""
    if kind == "albedo":
        return Gf.Vec4f(*material.base_color, 1.0)
    if kind == "normal":
        return Gf.Vec4f(0.0, 0.0, 1.0, 1.0)
    value = material.specular_roughness if kind == "roughness" else material.base_metalness
    return Gf.Vec4f(value, value, value, 1.0)
