"""Floors and walls: boards of wood, and ceramic tiles with grout."""

from dataclasses import replace
from functools import partial

import numpy as np

from artgen._arrays import Array
from artgen.materials.textures.fields import SEEN, Color, Pattern, Tile, recipe
from artgen.materials.textures.wood import SPECIES, Species, straight, wood

_BOARDS = 8  # boards across a tile
_FLOOR = (1.12, 2.40)  # size of a tile of boards [m]
_STEPS = 256  # possible places of a board in the wood, in each direction
_JOINT = 0.0016  # width of the gap between two boards [m]
_WAVE = 1.2e-3  # deviation of the relief of ceramic tiles, relative to their side
_SHADES = 0.085  # deviation of the lightness of boards


def _boards(species: Species, tile: Tile) -> Pattern:
    """Draw a floor: boards from several places of the wood, with two ends in each row."""
    across = species.rings * tile.extent[0] / 0.256  # rings of a usual board are counted on 0.256 m
    whole = wood(replace(species, rings=round(across), pores=0.0, flecks=0.0), straight, tile)
    ends = (
        tile.stream.random(_BOARDS)[:, None] + np.array([0.0, 0.42]) + 0.16 * tile.stream.random((_BOARDS, 2))
    )
    place = tile.u[0] * (_BOARDS / tile.extent[0]) + 0.5  # the border of the tile lies in a board
    row = np.floor(place).astype(np.int64) % _BOARDS
    along = tile.v / tile.extent[1]
    after = (along[:, :, None] - ends[row][None, :, :]) % 1.0
    second = (after[..., 0] > after[..., 1]).astype(np.int64)
    board = 2 * row[None, :] + second
    shifts = tile.stream.integers(_STEPS, size=(2, 2 * _BOARDS)) * (tile.size // _STEPS)
    numbers = np.arange(tile.size)
    rows = (numbers[:, None] + shifts[0][board]) % tile.size
    columns = (numbers[None, :] + shifts[1][board]) % tile.size
    aside = np.abs(place - np.rint(place)) * (tile.extent[0] / _BOARDS)
    beyond = np.minimum(after, 1.0 - after).min(axis=2) * tile.extent[1]
    gap = np.maximum(
        _line(aside[None, :], _JOINT, tile.extent[0] / tile.size),
        _line(beyond, _JOINT, tile.extent[1] / tile.size),
    )
    shade = 1.0 + _SHADES * tile.stream.standard_normal(2 * _BOARDS).clip(-1.8, 1.8)
    warm = 0.02 * tile.stream.standard_normal(2 * _BOARDS)
    tint = np.stack([shade * (1.0 + warm * share) for share in (-0.6, 0.0, 1.0)], axis=-1)
    assert whole.albedo is not None
    assert whole.height is not None
    albedo = whole.albedo[rows, columns] * tint[board] * (1.0 - 0.75 * gap)[..., None]
    return Pattern(
        albedo, whole.roughness[rows, columns] + 0.15 * gap, height=whole.height[rows, columns] - 4e-4 * gap
    )


def _line(distance: Array, width: float, texel: float) -> Array:
    """Return the share of each texel that a line of a width covers, at distances from its middle [m]."""
    low, high = (
        np.maximum(distance - texel / 2.0, -width / 2.0),
        np.minimum(distance + texel / 2.0, width / 2.0),
    )
    return np.asarray(np.maximum(high - low, 0.0) / texel)


for _name in ("oak", "walnut", "ash"):
    recipe(f"{_name}_boards", _FLOOR, SPECIES[_name].mean, variants=2, varying=SEEN)(
        partial(_boards, SPECIES[_name])
    )


def _tiles(
    name: str, mean: Color, side: float, count: int, grout: tuple[float, float], mottle: float
) -> None:
    """Register square tiles of a side [m], `count` a row, and grout of a width [m] and relative lightness."""

    @recipe(name, (count * side, count * side), mean, varying=SEEN)
    def drawn(tile: Tile) -> Pattern:
        # the border of the pattern lies in the middle of a tile
        u, v = (place * (1.0 / side) + 0.5 for place in (tile.u, tile.v))
        number = np.floor(v).astype(np.int64) % count * count + np.floor(u).astype(np.int64) % count
        texel = count * side / tile.size
        aside, beyond = (np.abs(place - np.rint(place)) * side for place in (u, v))
        joint = np.maximum(_line(aside, grout[0], texel), _line(beyond, grout[0], texel))
        shade = 1.0 + 0.35 * mottle * tile.stream.standard_normal(count * count)[number]
        shade = shade * (1.0 + mottle * (0.5 * tile.cloud(0.25, 1.6) + 0.25 * tile.band(0.012, 0.6)))
        across, along = tile.stream.standard_normal((2, count * count))[:, number]  # no face is quite flat
        wave = _WAVE * side * (across * np.sin(2.0 * np.pi * u) + along * np.sin(2.0 * np.pi * v))
        albedo = (shade * (1.0 - joint) + grout[1] * joint)[..., None] * np.array(mean)
        rough = 0.35 * joint + 0.02 * tile.smudges(0.3)
        return Pattern(albedo, rough, height=wave - 6e-4 * joint)


_tiles("floor_tiles", (0.34, 0.33, 0.31), 0.30, 4, (0.0035, 0.55), 0.07)
_tiles("wall_tiles", (0.80, 0.80, 0.78), 0.15, 8, (0.0025, 0.72), 0.012)
