"""Materials that vary between assets, like batches of paint and boards of one species."""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen.errors import ParameterError
from artgen.materials import Material, material
from artgen.materials.textures import RECIPES
from artgen.sampling import choice
from artgen.sampling.choices import Choice
from artgen.sampling.distributions import as_number, shown

_DIGITS = 4  # largest changes of a color and a roughness
_WARMTH = 0.25  # change of hue relative to the change of lightness
_BRIGHTEST = 0.9  # largest reflectance of paints


@dataclass(frozen=True)
class Shades(Choice):
    """A shade of one of several materials; `support` lists the materials themselves."""

    color: float = 0.0
    roughness: float = 0.0

    def draw(self, generator: np.random.Generator, given: Mapping[str, Any]) -> Any:
        """Draw a material and its shade."""
        chosen: Material = super().draw(generator, given)
        light, warm, rough = generator.uniform(-1.0, 1.0, 3)
        pattern = int(generator.integers(0, 2**16))
        hue = 1.0 + self.color * _WARMTH * warm * np.array([1.0, 0.2, -1.0])
        shade = np.array(chosen.base_color) * (1.0 + self.color * light) * hue
        base_color = np.minimum(shade, max(_BRIGHTEST, *chosen.base_color)).round(_DIGITS)
        specular_roughness = round(
            min(max(chosen.specular_roughness + self.roughness * rough, 0.02), 1.0), _DIGITS
        )
        variant = pattern % RECIPES[chosen.texture].variants if chosen.texture in RECIPES else 0
        if self.color == 0.0:
            base_color = np.array(chosen.base_color)
        tag = zlib.crc32(repr((base_color.tolist(), specular_roughness, variant)).encode()) & 0xFFFFFF
        return chosen.with_(
            name=f"{chosen.name}_{tag:06x}",
            base_color=tuple(base_color.tolist()),
            specular_roughness=specular_roughness,
            variant=variant,
        )

    def __repr__(self) -> str:
        names = ", ".join(map(shown, self.options))
        return f"shades({names}, color={self.color:g}, roughness={self.roughness:g})"


def shades(
    *materials: Material | str | Mapping[Any, float],
    weights: Sequence[float] | None = None,
    color: float = 0.08,
    roughness: float = 0.03,
    doc: str = "",
) -> Any:
    """Draw one of several materials in an own shade: lighter or darker, warmer or cooler, more or less rough.

    The texture pattern is drawn as well. The name of the drawn material ends in a tag, such as `oak_3fa2c1`,
    so that an asset can have several shades of one material.

    Args:
        *materials: Materials, or names in the table of materials; or one mapping from them to their weights.
        weights: Their weights; equal by default.
        color: Largest relative change of the base color.
        roughness: Largest change of the roughness.
        doc: Description of the parameter.

    Raises:
        ParameterError: There are no materials, a material is unknown, or a spread is not in 0..1.
    """
    options: Any = materials
    if len(materials) == 1 and isinstance(materials[0], Mapping):
        if weights is not None:
            raise ParameterError("shades takes the weights from its mapping, or as weights=..., not both")
        options, weights = tuple(materials[0]), tuple(materials[0].values())
    found = (each if isinstance(each, Material) else material(each) for each in options)
    plain = choice(*found, weights=weights, doc=doc)
    for name, spread in (("color", color), ("roughness", roughness)):
        if not 0.0 <= as_number(spread, f"shades: {name}") <= 1.0:
            raise ParameterError(f"shades: {name} = {spread!r} must be in 0..1")
    return Shades("", doc, None, plain.options, plain.weights, float(color), float(roughness))
