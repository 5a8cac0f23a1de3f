"""Woods: grain along v, growth rings, rays and pores.

A board shows the growth rings of its trunk. Cut through the pith (straight grain), they are slowly wandering
lines; cut beside it (flat-sawn), they are stacked arches with lines at their sides. Within a ring the wood
darkens slowly and ends sharply. Pores are fine dark grooves, in ring-porous woods dense at the start of a
ring.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.materials.textures.fields import SEEN, Color, Pattern, Tile, blend, centered, recipe, smoothstep

_SPREAD = 0.45  # deviation of the logarithm of lengths
_AT_ONCE = 1 << 14  # pores drawn at once: more would need many pages of memory


def pores(tile: Tile, chance: Array, density: float, length: float, width: float) -> Array:
    """Place random pores on a tile, and return their share of each texel, shape (n, n).

    A texel wider than a pore is darkened by the pore's share, so that small maps are averages of large ones.
    """
    count = round(density * tile.extent[0] * tile.extent[1])
    drawn = tile.stream.random((4, count))
    lengths = length * np.exp(_SPREAD * np.clip(tile.stream.standard_normal(count), -2.0, 2.0))
    column, row = drawn[0] * tile.size, drawn[1] * tile.size
    there = chance[row.astype(np.int64), column.astype(np.int64)] > drawn[2]
    across = width * (0.6 + 0.8 * drawn[3, there]) * (tile.size / tile.extent[0])
    along = lengths[there] * (tile.size / tile.extent[1])
    placed = np.stack([column[there], row[there], across, along])
    covered = np.zeros(tile.size**2)
    order = np.argsort(along, kind="stable")  # pores of one length cover equally many texels
    for start in range(0, len(order), _AT_ONCE):
        where, share = _covered(tile.size, *placed[:, order[start : start + _AT_ONCE]])
        covered += np.bincount(where, share, tile.size**2)
    return np.minimum(covered, 1.0).reshape(tile.size, tile.size)


def _covered(
    size: int, column: Array, row: Array, across: Array, along: Array
) -> tuple[NDArray[np.int64], Array]:
    """Return the texels of grooves and their shares; lengths are in texels."""
    left, top = column - 0.5 * across, row - 0.5 * along
    columns = np.floor(left)[:, None] + np.arange(int(across.max()) + 2)
    rows = np.floor(top)[:, None] + np.arange(int(along.max()) + 2)
    share_across = np.clip(
        np.minimum(columns + 1.0, (left + across)[:, None]) - np.maximum(columns, left[:, None]), 0.0, 1.0
    )
    # a groove is deepest at its center and shallow at its ends
    edges = np.concatenate([rows, rows[:, -1:] + 1.0], axis=1)
    part = np.clip((edges - row[:, None]) * (2.0 / along)[:, None], -1.0, 1.0)
    depth = part - part**3 / 3.0
    share_along = (0.5 * along)[:, None] * np.diff(depth, axis=1)
    texels = (rows.astype(np.int64) % size)[:, :, None] * size + (columns.astype(np.int64) % size)[:, None, :]
    return texels.ravel(), (share_along[:, :, None] * share_across[:, None, :]).ravel()


Cut = Callable[[Tile, "Species"], tuple[Array, int, float]]

_TILE = (0.256, 1.024)  # tile size: features are long along the grain, and a door has few repeats [m]

_PORE_DEPTH = 90e-6  # [m]
_EARLY = (0.12, 0.42)  # ring phase up to which pores are dense, and from which they are rare


@dataclass(frozen=True)
class Species:
    """The characteristics of a species of wood."""

    mean: Color  # linear RGB mean of its albedo
    early: Color  # color at the start of a ring, relative to the mean
    late: Color  # color at the end of a ring, relative to the mean
    rings: int  # number of rings across a tile with straight grain
    contrast: float  # range of a ring between early and late wood
    sharpness: float = 2.2  # exponent of the transition within a ring: 1 is even, 4 is dark only at its end
    pores: float = 0.0  # darkness of a pore
    # share of the pores at the start of rings only: 1 is ring-porous, 0 diffuse-porous
    porous: float = 0.0
    density: float = 0.0  # largest density of pores [1/m^2]
    length: float = 0.004  # median length of a pore [m]
    width: float = 0.00015  # mean width of a pore [m]
    flecks: float = 0.0  # darkness of the short flecks of rays
    stripes: float = 0.3  # variation of broad ribbons and colored streaks
    fibre: float = 0.26  # variation of fine fibres
    curl: float = 0.0  # strength of figure across the grain


SPECIES = {
    "oak": Species(
        (0.44, 0.27, 0.13), (1.12, 1.13, 1.16), (0.70, 0.64, 0.55), 62, 0.65, 1.6,
        pores=0.52, porous=0.96, density=6.0e5, length=0.0042, width=0.00020, flecks=0.05,
    ),
    "walnut": Species(
        (0.16, 0.085, 0.045), (1.30, 1.32, 1.34), (0.50, 0.47, 0.48), 38, 0.50, 1.7,
        pores=0.52, porous=0.60, density=2.2e5, length=0.0055, width=0.00018, stripes=0.75,
    ),
    "beech": Species(
        (0.60, 0.40, 0.24), (1.06, 1.07, 1.08), (0.86, 0.83, 0.80), 56, 0.5, 2.6,
        pores=0.16, density=5.0e5, length=0.0018, width=0.00010, flecks=0.22, stripes=0.25,
    ),
    "pine": Species(
        (0.66, 0.45, 0.24), (1.08, 1.10, 1.14), (0.76, 0.62, 0.46), 54, 0.95, 3.2,
        stripes=0.3,
    ),
    "mahogany": Species(
        (0.22, 0.075, 0.035), (1.24, 1.26, 1.26), (0.66, 0.62, 0.62), 36, 0.25, 1.2,
        pores=0.52, porous=0.15, density=1.8e5, length=0.0050, width=0.00017, stripes=0.85, curl=0.35,
    ),
    "maple": Species(
        (0.68, 0.52, 0.35), (1.04, 1.05, 1.06), (0.88, 0.84, 0.79), 50, 0.45, 3.0,
        flecks=0.07, stripes=0.3, curl=0.35,
    ),
    "ash": Species(
        (0.60, 0.46, 0.31), (1.09, 1.10, 1.12), (0.75, 0.71, 0.64), 52, 0.62, 1.6,
        pores=0.42, porous=0.96, density=6.0e5, length=0.0050, width=0.00020,
    ),
}  # fmt: skip
"""Species of wood by name."""


def _strengths(tile: Tile, count: int, spread: float) -> Array:
    """Return the strength of each ring, about 1, shape (count,); good years are clustered."""
    drawn = tile.stream.standard_normal(count)
    runs = 0.6 * drawn + 0.5 * np.roll(drawn, 1) + 0.5 * np.roll(drawn, -1)
    return np.asarray(np.exp(spread * (runs - runs.mean())))


def _profile(strengths: Array, sharpness: float, width: float) -> Array:
    """Return the lateness of the wood along the rings, blurred by a texel's width in rings, shape (m,)."""
    steps = 512
    within = (np.arange(steps) + 0.5) / steps
    rise = within**sharpness * (1.0 - smoothstep(0.94, 1.0, within))
    table = (strengths[:, None] * rise[None, :]).ravel()
    window = max(1, round(width * steps))
    total = np.cumsum(np.concatenate([table[-window:], table, table[:window]]))
    blurred = (total[2 * window :] - total[: -2 * window])[: len(table)] / (2 * window)
    return np.asarray(blurred)


def _along_rings(table: Array, count: int, rings: Array) -> Array:
    """Return the values of a table over rings at positions counted in rings."""
    steps = len(table) // count
    return np.asarray(table[np.floor(rings * steps).astype(np.int64) % len(table)])


def straight(tile: Tile, species: Species) -> tuple[Array, int, float]:
    """Return the ring at each texel, the number of rings, and the rings per texel."""
    share = tile.u / tile.extent[0]
    spacing = tile.streaks(0.06, 50.0)  # wider and narrower years, constant along a board
    wander = tile.streaks(0.14, 1.1)
    waves = tile.streaks(0.03, 0.35)
    fibres = tile.streaks(0.004, 0.09)
    rings = species.rings * share + 0.9 * spacing + 1.3 * wander + 0.20 * waves + 0.05 * fibres
    return rings, species.rings, species.rings / tile.size


def _flat_sawn(tile: Tile, species: Species) -> tuple[Array, int, float]:
    """Return the ring at each texel, the number of rings, and the rings per texel."""
    arches = max(6, round(species.rings / 10))
    wander = tile.streaks(0.30, 0.9)
    across = (tile.u / tile.extent[0] + 0.018 * wander + tile.stream.random()) % 1.0 - 0.5
    heart = 0.13  # distance of the cut from the pith, in widths of the tile
    distance = np.sqrt(across**2 + heart**2) - heart
    slow = tile.streaks(0.10, 0.60)
    waves = tile.streaks(0.030, 0.25)
    teeth = tile.streaks(0.006, 0.08)
    rings = 0.52 * species.rings * distance + arches * tile.v / tile.extent[1]
    rings = rings + 0.50 * slow + 0.14 * waves + 0.05 * teeth
    return rings, arches, 0.4 * species.rings / tile.size


def wood(species: Species, cut: Cut, tile: Tile) -> Pattern:
    """Draw a board."""
    rings, count, width = cut(tile, species)
    late = _along_rings(_profile(_strengths(tile, count, 0.17), species.sharpness, width), count, rings)
    fine = tile.fibres(0.20, 0.25)
    short = tile.fibres(0.03, 0.3)
    broad = tile.streaks(0.035, 0.9)
    value = 0.30 + species.contrast * centered(late) + species.stripes * 0.12 * broad
    value += species.fibre * (0.6 * fine + 0.4 * short)
    if species.curl:
        value += species.curl * 0.05 * tile.streaks(0.10, 0.010)
    groove = (
        _grooves(tile, species, rings, short, broad) if species.pores else np.zeros((tile.size, tile.size))
    )
    shade = 1.0 - species.pores * groove
    if species.flecks:
        fleck = smoothstep(1.1, 2.4, tile.streaks(0.0010, 0.0045))
        shade = shade * (1.0 - species.flecks * fleck)
    colors = ((0.0, species.early), (1.0, species.late))
    albedo = blend(value, [(at, _scaled(color, species.mean)) for at, color in colors])
    hue = tile.cloud(0.4, 2.2, 4.0)
    for channel, share in enumerate((0.6, 1.0, 1.5)):
        albedo[..., channel] *= shade * (1.0 + 0.025 * share * hue)
    roughness = 0.10 * groove - 0.06 * centered(late) + 0.008 * fine + 0.018 * tile.smudges(0.2)
    height = -_PORE_DEPTH * groove + 12e-6 * fine + 4e-6 * short - 15e-6 * late
    return Pattern(albedo, roughness, height=height)


def _grooves(tile: Tile, species: Species, rings: Array, short: Array, broad: Array) -> Array:
    """Return the share of pores in each texel: dense in some years and along some fibres."""
    within = rings - np.floor(rings)
    early = smoothstep(_EARLY[1], _EARLY[0], within)
    crowded = np.clip(0.55 + 0.20 * short + 0.15 * broad, 0.08, 1.0)
    chance = (1.0 - species.porous * (1.0 - early)) * crowded
    return pores(tile, chance, species.density, species.length, species.width)


def _scaled(color: Color, mean: Color) -> Color:
    red, green, blue = (relative * value for relative, value in zip(color, mean, strict=True))
    return red, green, blue


for _name, _species in SPECIES.items():
    for _suffix, _cut in (("", straight), ("_flat_sawn", _flat_sawn)):
        recipe(_name + _suffix, _TILE, _species.mean, variants=4, varying=SEEN)(partial(wood, _species, _cut))


_PLYWOOD: Color = (0.62, 0.45, 0.28)
_PLIES = 24  # plies of 1.4 mm each
_MDF: Color = (0.42, 0.31, 0.21)
_CARDBOARD: Color = (0.48, 0.33, 0.19)
_CARDBOARD_EDGE: Color = (0.23, 0.155, 0.088)  # mostly hollow
_FLUTE = 0.008  # wavelength of the standard C flute [m]


@recipe("plywood", (0.60, 1.20), _PLYWOOD, variants=2, varying=SEEN)
def _plywood(tile: Tile) -> Pattern:
    """Draw the face of birch plywood: peeled around the trunk, with a broad vague figure."""
    level = 3.2 * tile.cloud(0.45, 2.0, 3.5) + 0.12 * tile.streaks(0.012, 0.10)
    rings = smoothstep(0.35, 1.0, np.sin(2.0 * np.pi * level)) * 0.5 + 0.5 * level / 6.0
    fine = tile.fibres(0.12, 0.25)
    short = tile.fibres(0.02, 0.3)
    fleck = smoothstep(1.9, 3.0, tile.streaks(0.0022, 0.020))
    light = 1.0 - 0.060 * rings + 0.020 * fine + 0.022 * short + 0.02 * tile.streaks(0.09, 0.8)
    albedo = (light * (1.0 - 0.16 * fleck))[..., None] ** np.array([0.8, 1.0, 1.3]) * _PLYWOOD
    roughness = 0.03 * fleck + 0.012 * short + 0.015 * tile.smudges(0.3)
    return Pattern(albedo, roughness, height=20e-6 * short + 10e-6 * fine - 30e-6 * fleck)


@recipe("plywood_edge", (0.0336, 0.30), _PLYWOOD, variants=2, varying=SEEN)
def _plywood_edge(tile: Tile) -> Pattern:
    """Draw the edge of plywood: plies with alternating long grain and end grain, and glue."""
    wander = 0.05 * tile.streaks(0.02, 0.15)
    # the border of the tile lies at the center of a ply
    place = tile.u * (_PLIES / tile.extent[0]) + 0.5 + wander
    ply = np.floor(place).astype(np.int64) % _PLIES
    within = place - np.floor(place)
    end_grain = ply % 2
    tone = (1.0 + 0.07 * tile.stream.standard_normal(_PLIES))[ply]
    texel = _PLIES / tile.size
    glue = 1.0 - smoothstep(0.03, 0.05 + texel, np.minimum(within, 1.0 - within))
    lines = tile.fibres(0.06, 0.2)
    dots = tile.streaks(0.00018, 0.0005) + 0.7 * tile.streaks(0.0006, 0.004)
    light = tone * np.where(end_grain == 1, 0.74 + 0.075 * dots, 1.05 + 0.055 * lines)
    light = np.clip(light * (1.0 - 0.38 * glue), 0.1, 1.35)
    albedo = light[..., None] ** np.array([0.85, 1.0, 1.3]) * _PLYWOOD
    height = np.where(end_grain == 1, 6e-6 * dots - 12e-6, 2e-6 * lines) - 15e-6 * glue
    roughness = 0.08 * end_grain + 0.02 * dots
    return Pattern(albedo, roughness, height=height)


@recipe("mdf", (0.25, 0.25), _MDF, varying=SEEN)
def _mdf(tile: Tile) -> Pattern:
    """Draw MDF: pressed fibres, some darker, in all directions."""
    felt = tile.band(0.0016, 0.7)
    fine = tile.cloud(0.004, 0.8)
    dark = smoothstep(1.5, 2.8, tile.streaks(0.0012, 0.0035)) + smoothstep(
        1.5, 2.8, tile.streaks(0.0035, 0.0012)
    )
    light = 1.0 + 0.035 * felt + 0.03 * fine + 0.025 * tile.cloud(0.12, 1.6) - 0.20 * dark
    albedo = np.maximum(light, 0.3)[..., None] ** np.array([0.9, 1.0, 1.15]) * _MDF
    roughness = 0.03 * felt + 0.02 * tile.cloud(0.1, 2.0)
    return Pattern(albedo, roughness, height=8e-6 * fine + 6e-6 * felt)


@recipe("cardboard", (0.20, 0.256), _CARDBOARD, variants=2, varying=SEEN)
def _cardboard(tile: Tile) -> Pattern:
    """Draw the face of corrugated board: kraft paper with long fibres over transverse flutes."""
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
    return Pattern(albedo, 0.02 * wash - 0.03 * pale, height=height)


# the liners are the board's faces
@recipe("cardboard_edge", (0.004, 0.064), _CARDBOARD_EDGE, varying=SEEN, shifts=(False, True))
def _cardboard_edge(tile: Tile) -> Pattern:
    """Draw the cut edge of corrugated board: a liner at either face, and the wave of the flutes between."""
    place = tile.u / tile.extent[0] + 0.5  # the border of the tile lies in the liners
    place = place - np.floor(place) - 0.5
    texel = 1.0 / tile.size
    wave = 0.40 * np.sin(2.0 * np.pi * tile.v / _FLUTE + 0.35 * tile.streaks(5.0, 0.02))
    slope = 0.40 * 2.0 * np.pi / _FLUTE * np.cos(2.0 * np.pi * tile.v / _FLUTE)  # in widths per metre
    tilt = np.sqrt(1.0 + (slope * tile.extent[0]) ** 2)
    paper = _sheet(
        np.abs(place - wave) / tilt, 0.045, np.hypot(texel, slope * tile.extent[1] / tile.size) / tilt
    )
    liner = _sheet(np.abs(np.abs(place) - 0.5), 0.060, texel)
    solid = np.maximum(paper, liner)
    rag = tile.cloud(0.0015, 0.9)
    depth = 0.30 + 0.70 * solid * (1.0 + 0.09 * rag)
    albedo = np.clip(depth, 0.05, 1.3)[..., None] ** np.array([0.9, 1.0, 1.1]) * _CARDBOARD_EDGE
    height = 60e-6 * solid + 5e-6 * rag * solid
    return Pattern(albedo, 0.03 * rag, height=height)


def _sheet(distance: Array, half: float, texel: Array | float) -> Array:
    """Return 1 in a sheet of a half thickness and 0 outside, with a soft edge of one texel."""
    return 0.5 - 0.5 * np.tanh((distance - half) / (0.6 * texel))
