"""Materials as USD prims: a preview surface with its maps for cameras, friction for contacts."""

from collections.abc import Mapping

from pxr import Gf, Sdf

from artgen.export.maps import TEXTURE_DIRECTORY
from artgen.export.usd_layer import TYPES, connect, define, vec3, write
from artgen.materials import Material
from artgen.materials.textures import Kind

_INPUTS: dict[Kind, str] = {
    "albedo": "diffuseColor", "roughness": "roughness", "metalness": "metallic", "normal": "normal",
}  # fmt: skip


def write_material(scope: Sdf.PrimSpec, material: Material, maps: Mapping[Kind, str]) -> None:
    """Add a material.

    Args:
        scope: The prim that it belongs to.
        material: The material.
        maps: File name of each of its maps.
    """
    prim = define(scope, material.name, "Material", ["PhysicsMaterialAPI"])
    friction = material.friction
    write(
        prim,
        TYPES.Float,
        {"physics:dynamicFriction": friction, "physics:restitution": 0.0, "physics:staticFriction": friction},
    )
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
    """Add the readers of the maps, and of the texture coordinates, and connect the surface to them."""
    coordinates = define(prim, "coordinates", "Shader")
    write(coordinates, TYPES.Token, {"info:id": "UsdPrimvarReader_float2"}, uniform=True)
    write(coordinates, TYPES.String, {"inputs:varname": "st"})
    st = Sdf.AttributeSpec(coordinates, "outputs:result", TYPES.Float2)
    for kind, name in maps.items():
        reader = define(prim, kind, "Shader")
        write(reader, TYPES.Token, {"info:id": "UsdUVTexture"}, uniform=True)
        write(reader, TYPES.Asset, {"inputs:file": Sdf.AssetPath(f"./{TEXTURE_DIRECTORY}/{name}")})
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
    """Return what a renderer shows that cannot read the map; it scales and biases no fallback."""
    if kind == "albedo":
        return Gf.Vec4f(*material.base_color, 1.0)
    if kind == "normal":
        return Gf.Vec4f(0.0, 0.0, 1.0, 1.0)
    value = material.specular_roughness if kind == "roughness" else material.base_metalness
    return Gf.Vec4f(value, value, value, 1.0)
