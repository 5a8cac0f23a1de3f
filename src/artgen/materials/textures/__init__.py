"""Procedural textures: tileable maps in metric scale, baked once per recipe and cached on disk."""

from artgen.materials.textures import finishes, floors, stone, wood, woven  # noqa: F401 - they register recipes
from artgen.materials.textures.bake import Maps, as_bytes, displayed
from artgen.materials.textures.fields import RECIPES, Pattern, Recipe
from artgen.materials.textures.maps import (
    KINDS,
    SIZES,
    Form,
    Kind,
    check_size,
    encoded,
    kinds,
    map_name,
    maps,
    shifts_of,
    tile_of,
)

__all__ = [
    "KINDS", "RECIPES", "SIZES", "Form", "Kind", "Maps", "Pattern", "Recipe", "as_bytes", "check_size",
    "displayed", "encoded", "kinds", "map_name", "maps", "shifts_of", "tile_of",
]  # fmt: skip
