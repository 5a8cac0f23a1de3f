"""Recipes: what a texture is made of, as fields of numbers that repeat in both directions."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from artgen._arrays import Array
from artgen._caching import FrozenArrays

Varying = Literal["albedo", "metalness", "normal"]


@dataclass(frozen=True, eq=False)
class Pattern(FrozenArrays):
    """One tile of a surface; row 0 is its top (greatest v), column 0 its left (least u).

    Attributes:
        albedo: Linear RGB albedo whose mean is the recipe's `base_color`, shape (n, n, 3); None where it does
            not vary enough to be seen.
        roughness: Deviation of the GGX roughness from the material's, mean 0, shape (n, n).
        metalness: Share of bare metal, shape (n, n); None where it is the material's everywhere.
        height: Relief [m], shape (n, n); None where there is none to be seen.
    """

    albedo: Array | None
    roughness: Array
    metalness: Array | None = None
    height: Array | None = None


@dataclass(frozen=True)
class Recipe:
    """How a texture is made.

    Attributes:
        name: Identifier.
        base_color: Linear RGB mean of the albedo as baked; materials of other colours are tinted.
        make: Makes a pattern: `make(stream, size)` with a random stream of the recipe and variant, and how
            many texels the tile has on a side.
        tile: The size of one repeat, across and along the grain (u and v) [m].
        variants: How many different patterns there are.
        varying: Which maps it has besides roughness, of `albedo`, `metalness` and `normal`; None where that
            is to be found out by baking it small.
        shifts: Whether the pattern of a part may begin anywhere across and along the grain: not where it has
            to meet the part's edges.
        kept: Whether its maps are kept on disk, by a digest of this package's code: not where other code
            makes them.
    """

    name: str
    base_color: tuple[float, float, float]
    make: Callable[[np.random.Generator, int], Pattern]
    tile: tuple[float, float] = (0.5, 0.5)
    variants: int = 1
    varying: tuple[Varying, ...] | None = None
    shifts: tuple[bool, bool] = (True, True)
    kept: bool = False
