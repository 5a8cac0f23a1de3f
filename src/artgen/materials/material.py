"""Materials: OpenPBR names for appearance, SI units for physics; `materials.json` is their table."""

from __future__ import annotations

import json
import math
import re
import zlib
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from artgen.errors import ParameterError, nearest

_NAME = re.compile(r"[a-z][a-z0-9_]{0,99}\Z")
_SHARES = (
    "base_metalness", "specular_roughness", "coat_weight", "coat_roughness", "transmission_weight", "opacity",
)  # fmt: skip


@dataclass(frozen=True)
class Material:
    """A material: appearance of a surface, density and friction of a solid.

    Attributes:
        name: Identifier, unique among the materials of one asset.
        base_color: Linear RGB albedo, each in 0..1, shape (3,); with a texture, its mean.
        base_metalness: 0 for dielectrics, 1 for bare metal.
        specular_roughness: GGX roughness in 0..1; with a texture, its mean.
        coat_weight: Weight of a clear lacquer, 0..1.
        coat_roughness: GGX roughness of the lacquer in 0..1.
        transmission_weight: Share of refracted instead of scattered light, 1 for clear glass.
        opacity: 1 is opaque; lower values are for real-time renderers, which do not refract glass.
        emission: Linear RGB radiance factor, shape (3,).
        texture: Name of the recipe of its maps, see `artgen.materials.textures`; empty for a uniform surface.
        variant: Number of the recipe's pattern; boards of one species differ.
        tile: Size of one repeat of the maps, across and along the grain, shape (2,) [m]; None for the
            recipe's own size.
        turned: Whether the grain runs across the long side of a part instead of along it.
        density: Density of the solid [kg/m^3].
        friction: Coefficient of dry friction [-].
    """

    name: str
    base_color: tuple[float, float, float] = (0.5, 0.5, 0.5)
    base_metalness: float = 0.0
    specular_roughness: float = 0.5
    coat_weight: float = 0.0
    coat_roughness: float = 0.1
    transmission_weight: float = 0.0
    opacity: float = 1.0
    emission: tuple[float, float, float] = (0.0, 0.0, 0.0)
    texture: str = ""
    variant: int = 0
    tile: tuple[float, float] | None = None
    turned: bool = False
    density: float = 1000.0
    friction: float = 0.5

    def __post_init__(self) -> None:
        """Check every field; raise a ParameterError that names a bad one."""
        if not _NAME.fullmatch(str(self.name)):
            raise ParameterError(
                f"material name {self.name!r:.60} is not a lower-case identifier; use letters, digits and _"
            )
        for field in ("base_color", "emission"):
            value = tuple(self._number(field, channel) for channel in getattr(self, field))
            if len(value) != 3 or not all(0.0 <= channel <= 1.0 for channel in value):
                raise self._error(f"{field} {value} must be 3 numbers in 0..1")
            object.__setattr__(self, field, value)
        for field in (*_SHARES, "density", "friction"):
            number = self._number(field, getattr(self, field))
            if field in _SHARES and not 0.0 <= number <= 1.0:
                raise self._error(f"{field} {number} must be in 0..1")
            object.__setattr__(self, field, number)
        if self.density <= 0.0:
            raise self._error(f"density {self.density} must be positive [kg/m^3]")
        if self.friction < 0.0:
            raise self._error(f"friction {self.friction} must not be negative")
        self._check_texture()

    def _check_texture(self) -> None:
        if self.tile is not None:
            tile = tuple(self._number("tile", length) for length in self.tile)
            if len(tile) != 2 or min(tile) <= 0.0:
                raise self._error(f"tile {tile} must be 2 positive lengths [m]")
            object.__setattr__(self, "tile", tile)
        variant: Any = self.variant
        if isinstance(variant, bool) or not isinstance(variant, int) or variant < 0:
            raise self._error(f"variant {variant!r} must be a whole number, 0 or more")
        if self.turned not in (False, True):
            raise self._error(f"turned {self.turned!r} must be True or False")
        object.__setattr__(self, "turned", bool(self.turned))
        if self.texture and not _NAME.fullmatch(str(self.texture)):
            raise self._error(f"texture {self.texture!r:.60} is not the name of a recipe")

    def _error(self, message: str) -> ParameterError:
        return ParameterError(f"material {self.name!r}: {message}")

    def _number(self, field: str, value: Any) -> float:
        """Return a finite number as a Python float, so that equal materials have equal data."""
        try:
            number = float(value) + 0.0  # never -0.0
        except (TypeError, ValueError):
            number = math.nan
        if not math.isfinite(number):
            raise self._error(f"{field} {value!r} must be a finite number")
        return number

    @property
    def number(self) -> int:
        """A stable positive number for the name, which marks painted faces of a mesh."""
        return zlib.crc32(self.name.encode()) | 1

    def with_(self, **changes: Any) -> Material:
        """Return a copy with changed fields, e.g. a color drawn for one asset; change its name as well.

        Raises:
            ParameterError: There is no such field, or its value is not allowed.
        """
        known = [field.name for field in fields(self)]
        for name in changes:
            if name not in known:
                raise ParameterError(f"material {self.name!r} has no field {name!r}.{nearest(name, known)}")
        return replace(self, **changes)

    def to_data(self) -> dict[str, Any]:
        """Return the fields as JSON data."""
        # all values are plain: asdict copies them deeply and takes ten times as long
        values = {name: getattr(self, name) for name in _FIELDS}
        return {name: list(value) if isinstance(value, tuple) else value for name, value in values.items()}

    @staticmethod
    def from_data(data: dict[str, Any]) -> Material:
        """Return the object of data from `to_data`."""
        return Material(**data)


_FIELDS = tuple(field.name for field in fields(Material))

_TABLE: dict[str, dict[str, Any]] = json.loads(Path(__file__).with_name("materials.json").read_text("utf-8"))

COLORS: dict[str, tuple[float, float, float]] = {
    name: tuple(color) for name, color in _TABLE["colors"].items()
}
"""Colors of paints, enamels and plastics of products, linear RGB, by name."""

MATERIALS: dict[str, Material] = {
    name: Material(name, **row | {"base_color": COLORS.get(str(row["base_color"]), row["base_color"])})
    for name, row in _TABLE["materials"].items()
}
"""The materials by name."""


def material(name: str) -> Material:
    """Return a material of the table by name, or one of them in a color of products: see `colored`.

    Raises:
        ParameterError: There is no such material; the message suggests the nearest name.
    """
    found = named(name)
    if found is None:
        known = f"{nearest(name, MATERIALS)} artgen.MATERIALS has all {len(MATERIALS)}."
        raise ParameterError(f"there is no material {name!r}.{known}")
    return found


def named(name: str) -> Material | None:
    """Return the material that `material` returns, or None."""
    if name in MATERIALS:
        return MATERIALS[name]
    bases = {color: str(name).removesuffix(f"_{color}") for color in COLORS}
    return next((colored(base, color) for color, base in bases.items() if base in MATERIALS), None)


def colored(name: str, color: str) -> Material:
    """Return a material of the table in a color of products, named after both: `powder_coat_sage`.

    Args:
        name: A painted or dyed material, such as `powder_coat`, `enamel`, `abs` or `painted_wood`.
        color: A name of `COLORS`.

    Raises:
        ParameterError: There is no such material or color; the message suggests the nearest name.
    """
    made = material(name)
    if color not in COLORS:
        raise ParameterError(f"there is no color {color!r}.{nearest(color, COLORS)}")
    return made.with_(name=f"{name}_{color}", base_color=COLORS[color])
