"""Metals: even color, different finishes. Brushing runs along v."""

import numpy as np

from artgen._arrays import Array
from artgen.materials.textures.fields import (
    Pattern,
    Recipe,
    Tile,
    Varying,
    blend,
    centered,
    hairlines,
    smoothstep,
    with_mean,
)

_GREY = (0.5, 0.5, 0.5)
_BRUSHED_TILE = (0.15, 0.60)
_SATIN_TILE = (0.09, 0.36)
_POLISHED_TILE = (0.25, 0.25)
_ANODISED_TILE = (0.10, 0.10)
_CAST_TILE = (0.10, 0.10)
_BLASTED_TILE = (0.06, 0.06)
_ROLLED_TILE = (0.30, 0.30)
_BRONZE = (0.090, 0.063, 0.045)
_BRONZE_TILE = (0.16, 0.16)
_HAMMERED = (0.20, 0.13, 0.075)
_HAMMERED_TILE = (0.12, 0.12)
_KNURL_TILE = (0.0096, 0.0144)
_KNURL = (12, 6)  # grooves across a tile, and how far each runs on along it


def _strokes(tile: Tile, across: float, along: float) -> Array:
    """Return scratches of a belt: fine lines of some width and length [m], mean 0 and deviation 1."""
    long = tile.streaks(across, along)
    fine = tile.fibres(0.4 * along, 0.15)
    short = tile.streaks(1.5 * across, 0.15 * along)
    return np.asarray((0.45 * long + 0.65 * fine + 0.45 * short) / 0.91)


def _brushed(stream: np.random.Generator, size: int) -> Pattern:
    """Make sheet metal brushed along v, and touched since."""
    tile = Tile(stream, size, _BRUSHED_TILE)
    strokes = _strokes(tile, 0.0005, 0.10)
    bundles = tile.streaks(0.0030, 0.25)  # what the eye makes out from farther than it does strokes
    roughness = 0.030 * strokes + 0.014 * bundles + 0.030 * tile.smudges(0.15)
    return Pattern(None, centered(roughness), height=5e-6 * strokes)


def _satin(stream: np.random.Generator, size: int) -> Pattern:
    """Make small parts of finely brushed metal."""
    tile = Tile(stream, size, _SATIN_TILE)
    strokes = _strokes(tile, 0.0003, 0.03)
    bundles = tile.streaks(0.0018, 0.06)
    roughness = 0.022 * strokes + 0.010 * bundles + 0.026 * tile.smudges(0.08)
    return Pattern(None, centered(roughness), height=2e-6 * strokes)


def _polished(stream: np.random.Generator, size: int) -> Pattern:
    """Make polished metal: finger marks and hairlines alone tell it from a mirror."""
    tile = Tile(stream, size, _POLISHED_TILE)
    hairs = hairlines(tile, 0.0008, 0.02, 2.3)
    return Pattern(None, centered(0.020 * tile.smudges(0.08) + 0.030 * hairs))


def _anodised(stream: np.random.Generator, size: int) -> Pattern:
    """Make anodised aluminium: fine even grain."""
    tile = Tile(stream, size, _ANODISED_TILE)
    grain = tile.band(0.0006, 0.6)
    roughness = 0.018 * grain + 0.020 * tile.smudges(0.08)
    return Pattern(None, centered(roughness), height=3e-6 * grain)


def _cast(stream: np.random.Generator, size: int) -> Pattern:
    """Make metal cast in sand: lumps and pits of the sand's grains."""
    tile = Tile(stream, size, _CAST_TILE)
    lumps = tile.cloud(0.004, 1.5)
    sand = tile.band(0.0011, 0.6)
    pits = smoothstep(1.7, 3.0, tile.band(0.0022, 0.5))
    height = 28e-6 * lumps + 9e-6 * sand - 45e-6 * pits
    roughness = 0.035 * sand + 0.03 * tile.cloud(0.05, 2.0) + 0.08 * pits
    return Pattern(None, centered(roughness), height=height)


def _blasted(stream: np.random.Generator, size: int) -> Pattern:
    """Make metal blasted with beads, or a die-cast one: a fine grain."""
    tile = Tile(stream, size, _BLASTED_TILE)
    grain = tile.band(0.0007, 0.6)
    return Pattern(None, centered(0.025 * grain + 0.02 * tile.smudges(0.05)), height=4.5e-6 * grain)


def _rolled(stream: np.random.Generator, size: int) -> Pattern:
    """Make blackened or rolled steel: soft blotches of scale, fine lines of the rolls."""
    tile = Tile(stream, size, _ROLLED_TILE)
    blotches = tile.cloud(0.12, 1.7)
    lines = tile.fibres(0.15, 0.4)
    grain = tile.band(0.0016, 0.6)
    roughness = 0.040 * blotches + 0.015 * lines + 0.012 * grain
    return Pattern(None, centered(roughness), height=7e-6 * grain + 5e-6 * lines)


def _aged_bronze(stream: np.random.Generator, size: int) -> Pattern:
    """Make oil-rubbed bronze: a dark patina, and broad soft areas where hands wore it to the metal."""
    tile = Tile(stream, size, _BRONZE_TILE)
    mottle = tile.cloud(0.004, 1.0)
    worn = smoothstep(-0.7, 1.9, tile.cloud(0.09, 2.8))
    grain = tile.band(0.0010, 0.7)
    stops = ((0.0, (0.034, 0.025, 0.020)), (0.4, (0.088, 0.060, 0.041)), (1.0, (0.36, 0.235, 0.14)))
    albedo = blend(0.22 + 0.028 * mottle + 0.60 * worn, stops)
    metalness = np.clip(0.74 + 0.26 * worn - 0.02 * mottle, 0.0, 1.0)
    roughness = 0.015 * grain - 0.13 * worn + 0.022 * mottle + 0.02 * tile.smudges(0.06)
    return Pattern(with_mean(albedo, _BRONZE), centered(roughness), metalness, 3e-6 * grain)


def _hammered(stream: np.random.Generator, size: int) -> Pattern:
    """Make hammered bronze: dents beside dents, dark between them, bright on their ridges."""
    tile = Tile(stream, size, _HAMMERED_TILE)
    cells = tile.cells(0.0095, 0.8)
    sides = [(distance / 0.0062) ** 2 for distance in (cells.nearest, cells.second)]
    dent = sides[0] - 0.25 * np.log1p(np.exp((sides[0] - sides[1]) / 0.25))  # ridges that wear has rounded
    ridge = 1.0 - smoothstep(0.0, 0.0035, cells.second - cells.nearest)
    mottle = tile.cloud(0.02, 1.4)
    share = np.clip(0.40 + 0.10 * ridge + 0.12 * mottle, 0.0, 1.0)
    stops = ((0.0, (0.12, 0.080, 0.050)), (0.5, (0.24, 0.155, 0.09)), (1.0, (0.50, 0.33, 0.19)))
    height = 200e-6 * dent + 1.5e-6 * tile.band(0.001, 0.6)
    metalness = np.clip(0.88 + 0.05 * mottle, 0.0, 1.0)
    roughness = 0.035 * mottle + 0.01 * tile.smudges(0.06)
    return Pattern(with_mean(blend(share, stops), _HAMMERED), centered(roughness), metalness, height)


def _knurl(stream: np.random.Generator, size: int) -> Pattern:
    """Make a diamond knurl: two sets of grooves cross and leave blunt pyramids."""
    tile = Tile(stream, size, _KNURL_TILE)
    across, along = tile.u / tile.extent[0], tile.v / tile.extent[1]
    # Crests, not grooves, lie on the border of the tile
    sets = [
        0.5 + 0.5 * np.cos(2.0 * np.pi * (_KNURL[0] * across + sign * _KNURL[1] * along)) for sign in (1, -1)
    ]
    crests = np.minimum(*[np.arcsin(np.sqrt(each)) / (0.5 * np.pi) for each in sets])
    height = 220e-6 * np.minimum(crests, 0.78)
    wear = smoothstep(0.70, 0.80, crests)
    return Pattern(
        None, centered(0.06 * (1.0 - crests) - 0.05 * wear + 0.02 * tile.cloud(0.004, 1.5)), height=height
    )


def recipes() -> list[Recipe]:
    """Return the recipes of metals."""
    relief: tuple[Varying, ...] = ("normal",)
    all_maps: tuple[Varying, ...] = ("albedo", "metalness", "normal")
    return [
        Recipe("brushed", _GREY, _brushed, _BRUSHED_TILE, 2, relief),
        Recipe("satin", _GREY, _satin, _SATIN_TILE, 2, relief),
        Recipe("polished", _GREY, _polished, _POLISHED_TILE, 2, ()),
        Recipe("anodised", _GREY, _anodised, _ANODISED_TILE, 1, relief),
        Recipe("cast", _GREY, _cast, _CAST_TILE, 1, relief),
        Recipe("blasted", _GREY, _blasted, _BLASTED_TILE, 1, relief),
        Recipe("rolled", _GREY, _rolled, _ROLLED_TILE, 1, relief),
        Recipe("aged_bronze", _BRONZE, _aged_bronze, _BRONZE_TILE, 2, all_maps),
        Recipe("hammered", _HAMMERED, _hammered, _HAMMERED_TILE, 1, all_maps),
        Recipe("knurl", _GREY, _knurl, _KNURL_TILE, 1, relief),
    ]
