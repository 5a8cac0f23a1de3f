"""Maps: a recipe's pattern in the color and roughness of one material, as pixels and as image files."""

import io
import struct
import zlib
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import cached
from artgen.errors import ParameterError, nearest
from artgen.materials.material import MATERIALS, Material
from artgen.materials.textures.bake import MEMORY, Maps, Pixels, as_bytes, bake, baked, displayed, read, write
from artgen.materials.textures.fields import RECIPES, Color, Recipe

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_GREY, _COLOR = 0, 2
_UP = 2  # each texel as the difference from the one above: patterns run along v


def png(pixels: NDArray[np.uint8]) -> bytes:
    """Return a PNG file of grey texels, shape (n, m), or of RGB, shape (n, m, 3)."""
    height, width = pixels.shape[:2]
    lines = pixels.reshape(height, -1)
    rows = np.empty((height, lines.shape[1] + 1), np.uint8)
    rows[:, 0] = _UP
    rows[0, 1:] = lines[0]
    np.subtract(lines[1:], lines[:-1], out=rows[1:, 1:])
    packer = zlib.compressobj(1, zlib.DEFLATED, 15, 9, zlib.Z_RLE)
    data = packer.compress(rows.tobytes()) + packer.flush()
    head = struct.pack(">IIBBBBB", width, height, 8, _GREY if pixels.ndim == 2 else _COLOR, 0, 0, 0)
    return _SIGNATURE + _chunk(b"IHDR", head) + _chunk(b"IDAT", data) + _chunk(b"IEND", b"")


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


Kind = Literal["albedo", "orm", "roughness", "metalness", "normal"]
"""`orm` has occlusion, roughness and metalness in its channels, for glTF and MuJoCo."""

Form = Literal["png", "jpg"]

KINDS: tuple[Kind, ...] = ("albedo", "orm", "roughness", "metalness", "normal")

SIZES = (256, 512, 1024, 2048)
"""Allowed texels per side of maps."""

_QUALITY: dict[Kind, int] = {"normal": 92}


def check_size(size: int, *, plain: bool = False) -> None:
    """Raise a ParameterError for a number of texels per side that is not allowed; with `plain`, 0 is."""
    if plain and size == 0:
        return
    if type(size) is not int or size not in SIZES:
        colors = "; 0 gives plain colors" if plain else ""
        raise ParameterError(
            f"textures have {', '.join(map(str, SIZES))} texels on a side, not {size!r}{colors}"
        )


def recipe_of(material: Material) -> Recipe:
    """Return the recipe of a material's maps."""
    if not material.texture:
        raise ParameterError(
            f"material {material.name!r} has no texture; give it one: with_(texture='fine_grain')"
        )
    if material.texture not in RECIPES:
        raise ParameterError(
            f"material {material.name!r}: there is no texture {material.texture!r}."
            f"{nearest(material.texture, RECIPES)}"
        )
    return RECIPES[material.texture]


def kinds(material: Material) -> tuple[Kind, ...]:
    """Return the maps of a material, a subset of `KINDS`; empty without a texture."""
    if not material.texture:
        return ()
    varying = _varying(recipe_of(material))
    return tuple(kind for kind in KINDS if kind in ("orm", "roughness") or kind in varying)


@cached(64)
def _varying(recipe: Recipe) -> tuple[str, ...]:
    if recipe.varying is not None:
        return recipe.varying
    found = bake(recipe, 0, SIZES[0])
    return tuple(kind for kind in ("albedo", "metalness", "normal") if getattr(found, kind) is not None)


def maps(material: Material, size: int) -> Maps:
    """Return the maps of a material; they are shared and read-only.

    Args:
        material: A material with a texture.
        size: Texels per side, one of `SIZES`.

    Raises:
        ParameterError: The material has no texture, or the size is not allowed.
        ExportError: They cannot be stored on disk.
    """
    check_size(size)
    recipe = recipe_of(material)
    found = baked(recipe, material.variant % recipe.variants, size)
    albedo = None if found.albedo is None else _tinted(found.albedo, material.base_color, recipe.base_color)
    mean = round(255 * material.specular_roughness)
    roughness = np.clip(found.roughness.astype(np.int16) - 128 + mean, 0, 255).astype(np.uint8)
    return Maps(albedo, roughness, found.metalness, found.normal)


def tile_of(material: Material) -> tuple[float, float]:
    """Return the size of one repeat of a material's maps, across and along the grain [m]."""
    return material.tile or recipe_of(material).tile


def shifts_of(material: Material) -> tuple[bool, bool]:
    """Return whether the pattern of a part may begin anywhere across and along the grain."""
    return recipe_of(material).shifts


def _tinted(albedo: Pixels, color: Color, recipe_color: Color) -> Pixels:
    """Return an albedo in another color; its channels are scaled as linear values."""
    if color == recipe_color:
        return albedo
    code = np.arange(256) / 255.0
    linear = np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
    result = np.empty_like(albedo)
    for channel, (wanted, own) in enumerate(zip(color, recipe_color, strict=True)):
        result[..., channel] = as_bytes(displayed(linear * (wanted / own)))[albedo[..., channel]]
    return result


def encoded(material: Material, kind: Kind, size: int, form: Form) -> bytes:
    """Return a map of a material as an image file; grey for roughness and metalness.

    Args:
        material: A material with such a map, see `kinds`.
        kind: Which map.
        size: Texels per side, one of `SIZES`.
        form: PNG, or JPEG for GLB.

    Raises:
        ParameterError: The material has no such map, or the size is not allowed.
        ExportError: The file cannot be stored on disk.
    """
    check_size(size)
    recipe = recipe_of(material)
    if kind not in kinds(material):
        raise ParameterError(
            f"material {material.name!r} has no map {kind!r}.{nearest(kind, kinds(material))}"
        )
    name = f"{map_name(material, kind)}_{size}"

    def make() -> bytes:
        on_disk = _is_cached(material, kind)
        content = read(name, form) if on_disk else None
        if content is None:
            content = _file(_pixels(material, kind, size), kind, form)
            if on_disk:
                write(name, form, content)
        return content

    return MEMORY.get((recipe, name, form), make, len)


def _is_cached(material: Material, kind: Kind) -> bool:
    """Tell whether a file is cached on disk; maps in a color of one asset are not."""
    recipe = recipe_of(material)
    if kind != "albedo" or not recipe.cached:
        return recipe.cached
    return material.base_color in _lasting_colors(recipe)


@cached(64)
def _lasting_colors(recipe: Recipe) -> frozenset[Color]:
    listed = {made.base_color for made in MATERIALS.values() if made.texture == recipe.name}
    return frozenset({recipe.base_color, *listed})


def _pixels(material: Material, kind: Kind, size: int) -> Pixels:
    found = maps(material, size)
    if kind != "orm":
        pixels: Pixels = getattr(found, kind)
        return pixels
    metalness = found.metalness
    if metalness is None:
        metalness = np.full_like(found.roughness, round(255 * material.base_metalness))
    return np.stack([np.full_like(found.roughness, 255), found.roughness, metalness], axis=-1)


def _file(pixels: Pixels, kind: Kind, form: Form) -> bytes:
    if form == "png":
        return png(pixels)
    from PIL import Image

    file = io.BytesIO()
    # only colors may be subsampled: other channels are independent numbers
    subsampling = "4:2:0" if kind == "albedo" else "4:4:4"
    Image.fromarray(pixels).save(file, "JPEG", quality=_QUALITY.get(kind, 90), subsampling=subsampling)
    return file.getvalue()


def map_name(material: Material, kind: Kind) -> str:
    """Return the name of a map's file without its suffix, unique for its pixels."""
    recipe = recipe_of(material)
    name = f"{recipe.name}_{material.variant % recipe.variants}_{kind}"
    if kind == "albedo" and material.base_color != recipe.base_color:
        name += f"_{zlib.crc32(repr(material.base_color).encode()):08x}"
    if kind in ("roughness", "orm"):
        name += f"_r{round(255 * material.specular_roughness):02x}"
    if kind == "orm" and "metalness" not in kinds(material):
        name += f"_m{round(255 * material.base_metalness):02x}"
    return name
