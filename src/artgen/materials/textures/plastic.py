"""Plastics, rubber and baked coatings: even colors, different grain and gloss."""

import numpy as np

from artgen.materials.textures.fields import (
    Pattern,
    Recipe,
    Tile,
    Varying,
    centered,
    hairlines,
    smoothstep,
    with_mean,
)

_GREY = (0.5, 0.5, 0.5)
_FINE_TILE = (0.08, 0.08)
_COARSE_TILE = (0.12, 0.12)
_GLOSSY_TILE = (0.25, 0.25)
_RUBBER_TILE = (0.10, 0.10)
_POWDER_TILE = (0.12, 0.12)
_ENAMEL_TILE = (0.30, 0.30)
_FOAM = (0.80, 0.78, 0.70)
_FOAM_TILE = (0.08, 0.08)


def _fine(stream: np.random.Generator, size: int) -> Pattern:
    """Make moulded plastic with the fine grain of a spark-eroded mould."""
    tile = Tile(stream, size, _FINE_TILE)
    grain = tile.band(0.0008, 0.6)
    return Pattern(None, centered(0.020 * grain + 0.022 * tile.smudges(0.06)), height=4.0e-6 * grain)


def _coarse(stream: np.random.Generator, size: int) -> Pattern:
    """Make moulded plastic with an etched leather grain: islands with narrow valleys between."""
    tile = Tile(stream, size, _COARSE_TILE)
    cells = tile.cells(0.0017, 0.9)
    island = smoothstep(0.0, 0.0006, cells.second - cells.nearest)
    fine = tile.band(0.0007, 0.6)
    roughness = -0.05 * island + 0.015 * fine + 0.02 * tile.smudges(0.08)
    return Pattern(None, centered(roughness), height=22e-6 * island + 2.5e-6 * fine)


def _glossy(stream: np.random.Generator, size: int) -> Pattern:
    """Make polished plastic: finger marks and hairlines of wiping."""
    tile = Tile(stream, size, _GLOSSY_TILE)
    hairs = hairlines(tile, 0.0010, 0.03, 2.2)
    return Pattern(None, centered(0.022 * tile.smudges(0.12) + 0.025 * hairs))


def _rubber(stream: np.random.Generator, size: int) -> Pattern:
    """Make rubber: matt, with blotches of bloom and dust."""
    tile = Tile(stream, size, _RUBBER_TILE)
    grain = tile.cloud(0.003, 1.1)
    bloom = tile.cloud(0.05, 1.8)
    return Pattern(None, centered(0.03 * grain + 0.035 * bloom), height=5e-6 * grain)


def _powder(stream: np.random.Generator, size: int) -> Pattern:
    """Make powder coat: orange peel with a fine grain on it."""
    tile = Tile(stream, size, _POWDER_TILE)
    peel = tile.band(0.0024, 0.45)
    grain = tile.band(0.0008, 0.5)
    roughness = 0.012 * peel + 0.016 * grain + 0.02 * tile.smudges(0.10)
    return Pattern(None, centered(roughness), height=6.0e-6 * peel + 1.2e-6 * grain)


def _enamel(stream: np.random.Generator, size: int) -> Pattern:
    """Make vitreous or stoved enamel: glossy; its waves are flatter than the levels of a normal map."""
    tile = Tile(stream, size, _ENAMEL_TILE)
    hairs = smoothstep(2.5, 3.6, tile.streaks(0.0012, 0.04))
    return Pattern(None, centered(0.020 * tile.smudges(0.15) + 0.006 * tile.band(0.009, 0.5) + 0.02 * hairs))


def _foam(stream: np.random.Generator, size: int) -> Pattern:
    """Make cut foam: open cells."""
    tile = Tile(stream, size, _FOAM_TILE)
    cells = tile.cells(0.0014)
    hollow = smoothstep(0.0008, 0.0001, cells.nearest)
    shade = tile.cloud(0.02, 1.5)
    light = 1.0 - 0.22 * hollow + 0.02 * shade
    albedo = np.maximum(light, 0.2)[..., None] * np.array(_FOAM)
    return Pattern(with_mean(albedo, _FOAM), centered(0.02 * shade), height=-90e-6 * hollow)


def recipes() -> list[Recipe]:
    """Return the recipes of plastics, rubber and coats."""
    relief: tuple[Varying, ...] = ("normal",)
    return [
        Recipe("fine_grain", _GREY, _fine, _FINE_TILE, 1, relief),
        Recipe("coarse_grain", _GREY, _coarse, _COARSE_TILE, 1, relief),
        Recipe("glossy", _GREY, _glossy, _GLOSSY_TILE, 2, ()),
        Recipe("rubber", _GREY, _rubber, _RUBBER_TILE, 1, relief),
        Recipe("powder_coat", _GREY, _powder, _POWDER_TILE, 1, relief),
        Recipe("enamel", _GREY, _enamel, _ENAMEL_TILE, 1, ()),
        Recipe("foam", _FOAM, _foam, _FOAM_TILE, 1, ("albedo", "normal")),
    ]
