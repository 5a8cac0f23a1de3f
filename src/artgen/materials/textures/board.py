"""Boards, and paint on them: plywood, MDF, corrugated board."""

import numpy as np

from artgen._arrays import Array
from artgen.materials.textures.fields import Pattern, Recipe, Tile, Varying, centered, smoothstep, with_mean

_PLYWOOD = (0.62, 0.45, 0.28)
_PLYWOOD_TILE = (0.60, 1.20)
_PLYWOOD_EDGE_TILE = (0.0336, 0.30)
_PLIES = 24  # of 1.4 mm each
_MDF = (0.42, 0.31, 0.21)
_MDF_TILE = (0.25, 0.25)
_PAINT_TILE = (0.30, 0.60)
_SPRAY_TILE = (0.20, 0.20)
_CARDBOARD = (0.48, 0.33, 0.19)
_CARDBOARD_TILE = (0.20, 0.256)
_FLUTE = 0.008  # wavelength of what is called C flute [m]
_CARDBOARD_EDGE = (0.23, 0.155, 0.088)  # mostly hollows
_CARDBOARD_EDGE_TILE = (0.004, 0.064)


def _plywood(stream: np.random.Generator, size: int) -> Pattern:
    """Make the face of birch plywood: peeled around the trunk, so with broad vague figure."""
    tile = Tile(stream, size, _PLYWOOD_TILE)
    level = 3.2 * tile.cloud(0.45, 2.0, 3.5) + 0.12 * tile.streaks(0.012, 0.10)
    rings = smoothstep(0.35, 1.0, np.sin(2.0 * np.pi * level)) * 0.5 + 0.5 * level / 6.0
    fine = tile.fibres(0.12, 0.25)
    short = tile.fibres(0.02, 0.3)
    fleck = smoothstep(1.9, 3.0, tile.streaks(0.0022, 0.020))
    light = 1.0 - 0.060 * rings + 0.020 * fine + 0.022 * short + 0.02 * tile.streaks(0.09, 0.8)
    albedo = (light * (1.0 - 0.16 * fleck))[..., None] ** np.array([0.8, 1.0, 1.3]) * _PLYWOOD
    roughness = centered(0.03 * fleck + 0.012 * short + 0.015 * tile.smudges(0.3))
    return Pattern(
        with_mean(albedo, _PLYWOOD), roughness, height=20e-6 * short + 10e-6 * fine - 30e-6 * fleck
    )


def _plywood_edge(stream: np.random.Generator, size: int) -> Pattern:
    """Make the edge of plywood: plies that show their long grain and their end grain in turn, and glue."""
    tile = Tile(stream, size, _PLYWOOD_EDGE_TILE)
    wander = 0.05 * tile.streaks(0.02, 0.15)
    # The border of the tile lies in the middle of a ply
    place = tile.u * (_PLIES / tile.extent[0]) + 0.5 + wander
    ply = np.floor(place).astype(np.int64) % _PLIES
    within = place - np.floor(place)
    end_grain = ply % 2
    tone = (1.0 + 0.07 * stream.standard_normal(_PLIES))[ply]
    texel = _PLIES / size
    glue = 1.0 - smoothstep(0.03, 0.05 + texel, np.minimum(within, 1.0 - within))
    lines = tile.fibres(0.06, 0.2)
    dots = tile.streaks(0.00018, 0.0005) + 0.7 * tile.streaks(0.0006, 0.004)
    light = tone * np.where(end_grain == 1, 0.74 + 0.075 * dots, 1.05 + 0.055 * lines)
    light = np.clip(light * (1.0 - 0.38 * glue), 0.1, 1.35)
    albedo = light[..., None] ** np.array([0.85, 1.0, 1.3]) * _PLYWOOD
    height = np.where(end_grain == 1, 6e-6 * dots - 12e-6, 2e-6 * lines) - 15e-6 * glue
    roughness = centered(0.08 * end_grain + 0.02 * dots)
    return Pattern(with_mean(albedo, _PLYWOOD), roughness, height=height)


def _mdf(stream: np.random.Generator, size: int) -> Pattern:
    """Make MDF: pressed fibres, some darker, in all directions."""
    tile = Tile(stream, size, _MDF_TILE)
    felt = tile.band(0.0016, 0.7)
    fine = tile.cloud(0.004, 0.8)
    dark = smoothstep(1.5, 2.8, tile.streaks(0.0012, 0.0035)) + smoothstep(
        1.5, 2.8, tile.streaks(0.0035, 0.0012)
    )
    light = 1.0 + 0.035 * felt + 0.03 * fine + 0.025 * tile.cloud(0.12, 1.6) - 0.20 * dark
    albedo = np.maximum(light, 0.3)[..., None] ** np.array([0.9, 1.0, 1.15]) * _MDF
    roughness = centered(0.03 * felt + 0.02 * tile.cloud(0.1, 2.0))
    return Pattern(with_mean(albedo, _MDF), roughness, height=8e-6 * fine + 6e-6 * felt)


def _brushed_paint(stream: np.random.Generator, size: int) -> Pattern:
    """Make paint that a brush laid off along the grain: faint ridges that it left as it levelled."""
    tile = Tile(stream, size, _PAINT_TILE)
    ridges = tile.fibres(0.35, 0.7)
    ends = tile.fibres(0.08, 0.4)
    height = 8e-6 * ridges + 3e-6 * ends + 8e-6 * tile.band(0.006, 0.5, 2.0)
    return Pattern(None, 0.012 * ridges + 0.025 * tile.smudges(0.25), height=height)


def _sprayed_paint(stream: np.random.Generator, size: int) -> Pattern:
    """Make paint that was sprayed or rolled: orange peel."""
    tile = Tile(stream, size, _SPRAY_TILE)
    peel = tile.band(0.0042, 0.45)
    return Pattern(None, 0.008 * peel + 0.025 * tile.smudges(0.15), height=11e-6 * peel)


def _cardboard(stream: np.random.Generator, size: int) -> Pattern:
    """Make the face of corrugated board: kraft paper of long fibres, over flutes that run across."""
    tile = Tile(stream, size, _CARDBOARD_TILE)
    flute = np.cos(2.0 * np.pi * (tile.v / _FLUTE + 0.03 * tile.cloud(0.15, 2.0)))
    wash = tile.cloud(0.02, 1.1)
    fibre = smoothstep(1.2, 2.6, tile.streaks(0.0007, 0.0030)) + smoothstep(
        1.2, 2.6, tile.streaks(0.0030, 0.0007)
    )
    pale = smoothstep(1.6, 2.8, tile.band(0.0018, 0.6))
    light = 1.0 + 0.035 * wash + 0.012 * flute + 0.02 * tile.cloud(0.15, 2.0)
    light = light - 0.11 * fibre + 0.08 * pale
    albedo = light[..., None] ** np.array([0.9, 1.0, 1.2]) * _CARDBOARD
    height = 22e-6 * flute + 9e-6 * wash + 9e-6 * fibre
    return Pattern(with_mean(albedo, _CARDBOARD), centered(0.02 * wash - 0.03 * pale), height=height)


def _cardboard_edge(stream: np.random.Generator, size: int) -> Pattern:
    """Make the cut edge of corrugated board: a liner at either face, and between them the flutes' wave."""
    tile = Tile(stream, size, _CARDBOARD_EDGE_TILE)
    place = tile.u / tile.extent[0] + 0.5  # the border of the tile lies in the liners
    place = place - np.floor(place) - 0.5
    texel = 1.0 / size
    wave = 0.40 * np.sin(2.0 * np.pi * tile.v / _FLUTE + 0.35 * tile.streaks(5.0, 0.02))
    slope = 0.40 * 2.0 * np.pi / _FLUTE * np.cos(2.0 * np.pi * tile.v / _FLUTE)  # in widths per metre
    tilt = np.sqrt(1.0 + (slope * tile.extent[0]) ** 2)
    paper = _sheet(np.abs(place - wave) / tilt, 0.045, np.hypot(texel, slope * tile.extent[1] / size) / tilt)
    liner = _sheet(np.abs(np.abs(place) - 0.5), 0.060, texel)
    solid = np.maximum(paper, liner)
    rag = tile.cloud(0.0015, 0.9)
    depth = 0.30 + 0.70 * solid * (1.0 + 0.09 * rag)
    albedo = np.clip(depth, 0.05, 1.3)[..., None] ** np.array([0.9, 1.0, 1.1]) * _CARDBOARD_EDGE
    height = 60e-6 * solid + 5e-6 * rag * solid
    return Pattern(with_mean(albedo, _CARDBOARD_EDGE), centered(0.03 * rag), height=height)


def _sheet(distance: Array, half: float, texel: Array | float) -> Array:
    """Return 1 in a sheet of some half thickness and 0 beside it, softly over a texel."""
    return 0.5 - 0.5 * np.tanh((distance - half) / (0.6 * texel))


def recipes() -> list[Recipe]:
    """Return the recipes of boards and of paint on them."""
    seen: tuple[Varying, ...] = ("albedo", "normal")
    grey = (0.5, 0.5, 0.5)
    return [
        Recipe("plywood", _PLYWOOD, _plywood, _PLYWOOD_TILE, 2, seen),
        Recipe("plywood_edge", _PLYWOOD, _plywood_edge, _PLYWOOD_EDGE_TILE, 2, seen),
        Recipe("mdf", _MDF, _mdf, _MDF_TILE, 1, seen),
        Recipe("brushed_paint", grey, _brushed_paint, _PAINT_TILE, 2, ("normal",)),
        Recipe("sprayed_paint", grey, _sprayed_paint, _SPRAY_TILE, 1, ("normal",)),
        Recipe("cardboard", _CARDBOARD, _cardboard, _CARDBOARD_TILE, 2, seen),
        Recipe(
            "cardboard_edge",
            _CARDBOARD_EDGE,
            _cardboard_edge,
            _CARDBOARD_EDGE_TILE,
            1,
            seen,
            shifts=(False, True),  # its liners are the board's faces
        ),
    ]
