"""Woven, knitted and perforated sheets: crossing threads, pile, rows of holes; and leather."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from artgen._arrays import Array
from artgen.materials.textures.fields import SEEN, Color, Pattern, Tile, recipe, smoothstep


@dataclass(frozen=True)
class Weave:
    """A plain weave."""

    mean: Color  # linear RGB mean of its albedo
    tile: tuple[float, float]  # the size of one repeat [m]
    threads: int  # number of threads side by side across the tile and along it, even
    width: float  # share of the pitch that a thread fills
    depth: float  # height of a thread above the one it crosses [m]
    unevenness: float  # variation of lightness between threads
    slubs: float  # variation of thickness along threads
    twist: float  # visibility of the strands of a thread
    gap: float  # darkness between threads, relative to them
    split: bool = False  # whether threads are split canes with lines along them instead of twisted strands


_WEAVES = {
    "linen": Weave((0.75, 0.71, 0.64), (0.060, 0.060), 72, 0.90, 90e-6, 0.05, 0.14, 0.06, 0.62),
    "canvas": Weave((0.30, 0.31, 0.33), (0.072, 0.072), 60, 0.96, 160e-6, 0.08, 0.07, 0.10, 0.45),
    "wicker": Weave((0.36, 0.23, 0.12), (0.128, 0.128), 24, 0.96, 0.9e-3, 0.09, 0.05, 0.09, 0.20, split=True),
    "plastic_wicker": Weave((0.060, 0.045, 0.036), (0.112, 0.112), 16, 0.95, 1.1e-3, 0.05, 0.02, 0.0, 0.35),
}


def _weave(kind: Weave, tile: Tile) -> Pattern:
    """Draw a plain weave."""
    pitch = tile.extent[0] / kind.threads
    # the border of the tile lies at the center of a thread
    warp = _Threads(tile, kind, tile.u, tile.v, tile.streaks(0.3 * pitch, 6.0 * pitch))
    weft = _Threads(tile, kind, tile.v, tile.u, tile.streaks(6.0 * pitch, 0.3 * pitch))
    if kind.split:
        warp.strand = tile.streaks(0.07 * pitch, 4.0 * pitch)
        weft.strand = tile.streaks(4.0 * pitch, 0.07 * pitch)
    sign = np.where((warp.number + weft.number) % 2 == 0, 1.0, -1.0)
    warp_height = warp.round * (0.62 + 0.38 * sign * np.cos(np.pi * weft.offset))
    weft_height = weft.round * (0.62 - 0.38 * sign * np.cos(np.pi * warp.offset))
    on_top = warp_height > weft_height
    height = np.maximum(warp_height, weft_height)
    strand = np.where(on_top, warp.strand, weft.strand)
    hair = tile.cloud(1.5 * pitch, 0.9)
    light = kind.gap + (1.0 - kind.gap) * smoothstep(0.05, 0.75, height)
    light *= np.where(on_top, warp.tone, weft.tone) * (1.0 + kind.twist * strand + 0.035 * hair)
    light *= 1.0 + 0.015 * tile.cloud(0.5 * tile.extent[0], 1.5)
    albedo = np.clip(light, 0.03, 1.6)[..., None] ** np.array([0.92, 1.0, 1.1]) * np.array(kind.mean)
    relief = kind.depth * (height + 0.25 * kind.twist * strand * height + 0.02 * hair)
    roughness = 0.02 * hair - 0.05 * height
    return Pattern(albedo, roughness, height=relief)


class _Threads:
    """One of the two sets of threads of a weave."""

    def __init__(self, tile: Tile, kind: Weave, across: Array, along: Array, wander: Array) -> None:
        pitch = tile.extent[0] / kind.threads
        place = across / pitch + 0.5 + 0.06 * kind.slubs / 0.14 * wander
        # number of the nearest thread
        self.number = np.floor(place).astype(np.int64) % kind.threads
        # position across it, -1..1 over its pitch
        self.offset = 2.0 * (place - np.floor(place)) - 1.0
        # its lightness, about 1
        tone = tile.stream.standard_normal(kind.threads)[self.number]
        self.tone = 1.0 + kind.unevenness * (tone + 0.5 * wander) / 1.1
        width = kind.width * np.clip(1.0 + kind.slubs * wander, 0.6, 1.0 / kind.width)
        # height of its section, 0 at its sides and 1 at its center
        self.round = np.sqrt(np.clip(1.0 - (self.offset / width) ** 2, 0.0, 1.0))
        turns = along * (1.5 * kind.threads / tile.extent[0])
        # strands of its twist, -1..1, or the lines of a split cane
        self.strand = np.sin(2.0 * np.pi * (turns + 0.6 * self.offset))


for _name, _kind in _WEAVES.items():
    recipe(_name, _kind.tile, _kind.mean, varying=SEEN)(partial(_weave, _kind))

_PERFORATED: Color = (0.030, 0.030, 0.031)
_HOLES = (12, 14)


@recipe("perforated", (0.0240, 0.02425), _PERFORATED, varying=SEEN)  # rows of hexagons, 2 mm apart
def _perforated(tile: Tile) -> Pattern:
    """Draw the screen of a microwave oven's door: round holes in staggered rows as dark dots."""
    across, along = tile.u / tile.extent[0] * _HOLES[0], tile.v / tile.extent[1] * _HOLES[1]
    row = np.floor(along)
    shifted = across + 0.5 * (row % 2.0) + 0.25  # no hole lies on the border of the tile
    pitch = tile.extent[0] / _HOLES[0], tile.extent[1] / _HOLES[1]
    distance = np.hypot((shifted - np.floor(shifted) - 0.5) * pitch[0], (along - row - 0.5) * pitch[1])
    texel = tile.extent[0] / tile.size
    metal = smoothstep(0.00062 - texel, 0.00062 + texel, distance)
    albedo = (0.40 + 0.60 * metal)[..., None] * np.ones(3)
    return Pattern(albedo, -0.25 * metal, height=60e-6 * metal)


@recipe("knitted_mesh", (0.0480, 0.0520), (0.050, 0.050, 0.053), varying=SEEN)
def _knitted_mesh(tile: Tile) -> Pattern:
    """Draw the knitted mesh of office chairs: staggered oval openings, dark, between bundles of yarn."""
    across, along = tile.u / tile.extent[0] * 16, tile.v / tile.extent[1] * 10
    row = np.floor(along)
    shifted = across + 0.5 * (row % 2.0) + 0.25  # no opening lies on the border of the tile
    offset = (2.0 * (shifted - np.floor(shifted)) - 1.0, 2.0 * (along - row) - 1.0)
    yarn = smoothstep(0.62, 0.92, np.hypot(*offset))
    crown = yarn * (1.0 - 0.35 * smoothstep(0.9, 1.4, np.hypot(*offset)))
    stitch = 0.5 + 0.5 * np.cos(2.0 * np.pi * (4.0 * along + 0.5 * np.abs(offset[0])))
    light = 0.30 + 0.70 * crown * (0.86 + 0.14 * stitch) + 0.02 * tile.cloud(0.003, 1.2)
    albedo = np.maximum(light, 0.27)[..., None] * np.ones(3)
    return Pattern(albedo, 0.06 * (1.0 - yarn), height=350e-6 * crown + 40e-6 * yarn * stitch)


@recipe("pile", (0.24, 0.24), (0.030, 0.105, 0.095), varying=SEEN)
def _pile(tile: Tile) -> Pattern:
    """Draw velvet: short pile with a nap, light where it is brushed up and dark where it lies down."""
    nap = tile.cloud(0.09, 2.4, 0.6)
    tufts = tile.band(0.0016, 0.5)
    strands = tile.streaks(0.0009, 0.003)
    light = 1.0 + 0.06 * np.tanh(nap) + 0.10 * strands + 0.06 * tufts
    albedo = np.clip(light, 0.5, 1.8)[..., None] ** np.array([1.1, 1.0, 1.0])
    return Pattern(albedo, 0.02 * nap - 0.02 * strands, height=45e-6 * tufts + 35e-6 * strands + 60e-6 * nap)


@dataclass(frozen=True)
class Hide:
    """A leather."""

    mean: Color  # linear RGB mean of its albedo
    pebble: float  # distance between the pebbles of its grain [m]
    depth: float  # height of the pebbles [m]
    mottle: float  # variation of the dye


_HIDES = {
    "saddle_hide": Hide((0.175, 0.072, 0.032), 0.0021, 90e-6, 0.045),
    "black_hide": Hide((0.032, 0.031, 0.031), 0.0026, 110e-6, 0.03),
    "cream_hide": Hide((0.58, 0.50, 0.38), 0.0017, 60e-6, 0.03),
}


def _hide(kind: Hide, tile: Tile) -> Pattern:
    """Draw leather: round pebbles with valleys between, folds, pores, and an uneven dye."""
    cells = tile.cells(kind.pebble, 1.0)
    dome = smoothstep(0.0, 0.42 * kind.pebble, cells.second - cells.nearest)
    tone = tile.stream.standard_normal(cells.total)[cells.number]
    fold = smoothstep(1.1, 2.4, np.abs(tile.cloud(0.03, 1.6, 0.5)))
    pores = smoothstep(1.6, 2.8, tile.band(0.0006, 0.4))
    dye = tile.cloud(0.03, 1.6)
    high = dome * (1.0 + 0.12 * np.clip(tone, -2.0, 2.0))
    light = 0.78 + 0.22 * dome + kind.mottle * np.tanh(dye) + 0.03 * np.clip(tone, -2.0, 2.0) - 0.12 * pores
    albedo = np.clip(light - 0.08 * fold, 0.45, 1.6)[..., None] ** np.array([0.95, 1.0, 1.05])
    roughness = 0.10 * (1.0 - dome) + 0.02 * dye + 0.04 * pores
    relief = kind.depth * (high - 0.35 * fold - 0.12 * pores) + 60e-6 * tile.cloud(0.02, 2.0)
    return Pattern(albedo * np.array(kind.mean), roughness, height=relief)


for _name, _leather in _HIDES.items():
    recipe(_name, (0.12, 0.12), _leather.mean, varying=SEEN)(partial(_hide, _leather))
