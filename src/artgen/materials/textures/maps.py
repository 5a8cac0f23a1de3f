"""Maps: a recipe's pattern in the colour and roughness of one material, as pixels and as image files."""

import io
import zlib
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from artgen.errors import ParameterError, nearest
from artgen.materials.material import Material
from artgen.materials.textures.recipe import RECIPES, Recipe

Pixels = NDArray[np.uint8]

Kind = Literal["albedo", "orm", "roughness", "metalness", "normal"]
"""`orm` has occlusion, roughness and metalness in its channels, as glTF and MuJoCo read them."""

Form = Literal["png", "jpg"]

KINDS: tuple[Kind, ...] = ("albedo", "orm", "roughness", "metalness", "normal")

SIZES = (256, 512, 1024, 2048)
"""Texels on a side that maps may have."""


@dataclass(frozen=True, eq=False)
class Maps:
    """The maps of a material; row 0 is the top.

    Attributes:
        albedo: sRGB, shape (n, n, 3); None where it is the material's `base_color` everywhere.
        roughness: 0..255 for 0..1, shape (n, n).
        metalness: 0..255 for 0..1, shape (n, n); None where it is the material's everywhere.
        normal: Tangent space, y towards greater v (OpenGL), shape (n, n, 3); None where the surface is even.
    """

    albedo: Pixels | None
    roughness: Pixels
    metalness: Pixels | None
    normal: Pixels | None


def check_size(size: int) -> None:
    """Raise a ParameterError unless maps may have that many texels on a side."""
    if size not in SIZES:
        raise ParameterError(f"textures have {', '.join(map(str, SIZES))} texels on a side, not {size!r}")


def recipe_of(material: Material) -> Recipe:
    """Return the recipe of a material's maps.

    Raises:
        ParameterError: It has none, or there is no such recipe.
    """
    if material.texture not in RECIPES:
        raise ParameterError(
            f"material {material.name!r}: there is no texture {material.texture!r}."
            f"{nearest(material.texture, RECIPES)}"
        )
    return RECIPES[material.texture]


def kinds(material: Material) -> tuple[Kind, ...]:
    """Return which maps a material has, of `KINDS`; none where it has no texture."""
    if not material.texture:
        return ()
    found = maps(material, SIZES[0])
    return tuple(
        kind
        for kind in KINDS
        if kind in ("orm", "roughness") or getattr(found, kind) is not None
    )


@lru_cache(maxsize=64)
def maps(material: Material, size: int) -> Maps:
    """Return the maps of a material.

    Args:
        material: One with a texture.
        size: Texels on a side, of `SIZES`.

    Raises:
        ParameterError: The material has no texture, or the size is not allowed.
    """
    check_size(size)
    recipe = recipe_of(material)
    found = baked(recipe.name, material.variant % recipe.variants, size)
    albedo = None if found.albedo is None else _tinted(found.albedo, _tint(material, recipe))
    mean = round(255 * material.specular_roughness)
    roughness = np.clip(found.roughness.astype(np.int16) - 128 + mean, 0, 255).astype(np.uint8)
    return Maps(albedo, roughness, found.metalness, found.normal)


def tile_of(material: Material) -> tuple[float, float]:
    """Return the size of one repeat of a material's maps, across and along the grain [m]."""
    return material.tile or recipe_of(material).tile


@lru_cache(maxsize=32)
def baked(name: str, variant: int, size: int) -> Maps:
    """Return a recipe's maps as baked: in its own colour, roughness as deviation about 128."""
    recipe = RECIPES[name]
    stream = np.random.default_rng(np.random.SeedSequence([zlib.crc32(name.encode()), variant]))
    pattern = recipe.make(stream, size)
    albedo = None if pattern.albedo is None else _bytes(_displayed(pattern.albedo))
    roughness = _bytes(pattern.roughness + 128 / 255)
    metalness = None if pattern.metalness is None else _bytes(pattern.metalness)
    normal = None if pattern.height is None else _normals(pattern.height, recipe.tile)
    return Maps(albedo, roughness, metalness, normal)


def _bytes(values: NDArray[np.float64]) -> Pixels:
    return np.rint(np.clip(values, 0.0, 1.0) * 255.0).astype(np.uint8)


def _displayed(linear: NDArray[np.float64]) -> NDArray[np.float64]:
    """Encode linear values as sRGB."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def _normals(height: NDArray[np.float64], tile: tuple[float, float]) -> Pixels:
    """Return the tangent-space normals of a relief [m] over a tile of that size [m]."""
    size = len(height)
    along_u = (np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)) * (size / (2.0 * tile[0]))
    along_v = (np.roll(height, 1, axis=0) - np.roll(height, -1, axis=0)) * (size / (2.0 * tile[1]))
    normals = np.stack([-along_u, -along_v, np.ones_like(height)], axis=-1)
    normals /= np.sqrt((normals**2).sum(axis=-1, keepdims=True))
    return _bytes((normals * 127.0 + 128.0) / 255.0)


def _tint(material: Material, recipe: Recipe) -> tuple[float, float, float]:
    """Return what each linear channel of the albedo is multiplied by."""
    red, green, blue = (
        wanted / own for wanted, own in zip(material.base_color, recipe.base_color, strict=True)
    )
    return red, green, blue


def _tinted(albedo: Pixels, tint: tuple[float, float, float]) -> Pixels:
    if tint == (1.0, 1.0, 1.0):
        return albedo
    code = np.arange(256) / 255.0
    linear = np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
    result = np.empty_like(albedo)
    for channel, factor in enumerate(tint):
        result[..., channel] = _bytes(_displayed(linear * factor))[albedo[..., channel]]
    return result


@lru_cache(maxsize=256)
def encoded(material: Material, kind: Kind, size: int, form: Form) -> bytes:
    """Return a map of a material as an image file.

    Args:
        material: One with such a map, see `kinds`.
        kind: Which map.
        size: Texels on a side, of `SIZES`.
        form: PNG, or JPEG as GLB takes it.

    Raises:
        ParameterError: The material has no such map, or the size is not allowed.
    """
    from PIL import Image

    found = maps(material, size)
    if kind == "orm":
        metalness = found.metalness
        if metalness is None:
            metalness = np.full_like(found.roughness, round(255 * material.base_metalness))
        pixels = np.stack([np.full_like(found.roughness, 255), found.roughness, metalness], axis=-1)
    else:
        pixels = getattr(found, kind)
    file = io.BytesIO()
    if form == "png":
        Image.fromarray(pixels).save(file, "PNG", compress_level=1)
    else:
        Image.fromarray(pixels).save(file, "JPEG", quality=90)
    return file.getvalue()


def map_name(material: Material, kind: Kind) -> str:
    """Return the name of a map's file without its suffix: equal for two materials only if the pixels are."""
    recipe = recipe_of(material)
    name = f"{recipe.name}_{material.variant % recipe.variants}_{kind}"
    if kind == "albedo" and material.base_color != recipe.base_color:
        name += f"_{zlib.crc32(repr(material.base_color).encode()):08x}"
    if kind in ("roughness", "orm"):
        name += f"_r{round(255 * material.specular_roughness):02x}"
    if kind == "orm":
        name += f"_m{round(255 * material.base_metalness):02x}"
    return name
