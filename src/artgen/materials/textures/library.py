"""The library of recipes."""

from dataclasses import replace

import numpy as np

from artgen.materials.textures import board, metal, plastic, stone, wood, woven
from artgen.materials.textures.fields import Tile
from artgen.materials.textures.recipe import Pattern, Recipe

_FLAT_TILE = (0.5, 0.5)


def _flat(stream: np.random.Generator, size: int) -> Pattern:
    """Make a surface that is even but for a breath of roughness."""
    return Pattern(None, 0.02 * Tile(stream, size, _FLAT_TILE).cloud(0.25, 1.8))


_FAMILIES = (wood, board, metal, plastic, stone, woven)

RECIPES: dict[str, Recipe] = {
    recipe.name: replace(recipe, kept=True)
    for recipe in (
        Recipe("flat", (0.5, 0.5, 0.5), _flat, _FLAT_TILE, varying=()),
        *(recipe for family in _FAMILIES for recipe in family.recipes()),
    )
}
"""The recipes by name."""
