"""Polished stone: granite and marble."""

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.materials.textures.fields import Color, Pattern, Tile, blend, in_strips, recipe, smoothstep


def _granite(
    name: str, mean: Color, minerals: tuple[tuple[Color, float, float], ...], mica_color: Color, flecks: float
) -> None:
    """Register polished granite: a place has the mineral with the largest noise, so that grains interlock."""
    # a mineral has a color, a size of grains [m] and a frequency; mica lies above `flecks` deviations

    @recipe(name, (0.20, 0.20), mean, variants=2, varying=("albedo",))
    def drawn(tile: Tile) -> Pattern:
        strength = [
            0.75 * tile.band(grain, 0.5) + 0.40 * tile.band(0.4 * grain, 0.5) + common
            for _, grain, common in minerals
        ]
        # crystals have straight sides: within one, the order of the minerals is constant
        cells = tile.cells(0.0021)
        push = tile.stream.standard_normal((len(minerals), cells.total))

        def mixed(number: NDArray[np.int64], *strength: Array) -> Array:
            total, mixture = np.zeros(number.shape), np.zeros((*number.shape, 3))
            for (color, _, _), field, pushed in zip(minerals, strength, push, strict=True):
                weight = np.exp(9.0 * (field + 0.75 * pushed[number]))
                total += weight
                mixture += weight[..., None] * np.array(color)
            return np.asarray(mixture / total[..., None])

        albedo = in_strips(mixed, cells.number, *strength)
        veil = tile.cloud(0.005, 1.0)
        tone = 1.0 + 0.10 * tile.stream.standard_normal(cells.total)
        clumps = tile.band(0.010, 0.7)
        mica = smoothstep(0.0, 0.25, tile.band(0.0016, 0.5) + 0.55 * clumps - flecks)
        broad = tile.cloud(0.12, 1.8)

        def shaded(albedo: Array, number: Array, veil: Array, mica: Array, broad: Array) -> Array:
            light = np.clip(tone[number] * (1.0 + 0.09 * veil), 0.4, 1.6)[..., None]
            body = albedo * light
            return np.asarray(
                (body + mica[..., None] * (np.array(mica_color) - body)) * (1.0 + 0.03 * broad)[..., None]
            )

        albedo = in_strips(shaded, albedo, cells.number, veil, mica, broad)
        roughness = 0.05 * mica + 0.012 * veil + 0.018 * tile.smudges(0.15)
        return Pattern(albedo, roughness)


_granite(
    "granite",
    (0.25, 0.24, 0.24),
    (
        ((0.46, 0.44, 0.42), 0.0044, 0.25),
        ((0.22, 0.215, 0.22), 0.0032, 0.15),
        ((0.36, 0.32, 0.29), 0.0054, -0.25),
        ((0.10, 0.10, 0.105), 0.0030, -0.35),
    ),
    (0.030, 0.030, 0.032),
    1.15,
)
_granite(
    "black_granite",
    (0.032, 0.032, 0.034),
    (
        ((0.022, 0.022, 0.023), 0.0036, 0.5),
        ((0.040, 0.040, 0.043), 0.0030, 0.0),
        ((0.075, 0.078, 0.085), 0.0026, -1.05),
    ),
    (0.021, 0.021, 0.021),
    1.0,
)


def _marble(name: str, mean: Color, colors: tuple[Color, Color, Color], variants: int) -> None:
    """Register polished marble: clouds, and veins where a slope crosses levels, bent by noise."""
    # the colors, linear RGB, are those of its body, its clouds and its veins

    @recipe(name, (0.90, 0.90), mean, variants=variants, varying=("albedo",))
    def drawn(tile: Tile) -> Pattern:
        across, along = tile.cloud(0.55, 2.4), tile.cloud(0.55, 2.4)
        # levels of an oblique slope over the tile: their lines cross it like faults in rock
        slope = tile.u / tile.extent[0] + 2.0 * tile.v / tile.extent[1]
        folds = tile.cloud(0.8, 2.2)
        strong = _veins(tile, np.sin(2.0 * np.pi * slope + 0.9 * folds), 0.045 * across, 0.045 * along, 0.045)
        branches = np.sin(2.0 * np.pi * (2.0 * slope + 0.13) - 1.6 * folds + 1.5 * tile.cloud(0.3, 2.1))
        thin = _veins(tile, branches, 0.030 * along, 0.030 * across, 0.055)
        mist = _veins(
            tile, np.sin(2.0 * np.pi * slope + 1.6 * along + 0.5), 0.07 * along, 0.07 * across, 0.40
        )
        where = tile.cloud(0.7, 2.4)
        clouds = tile.cloud(0.45, 1.9)
        grain = tile.band(0.0035, 0.6)
        cloud = np.clip(0.32 + 0.17 * clouds + 0.34 * mist * smoothstep(-0.8, 1.2, where), 0.0, 1.0)
        # continuous veins look alike everywhere: a single vein would show the repeat of the tile
        faint = 0.55 + 0.45 * smoothstep(-1.3, 0.9, where)
        vein = 0.46 * strong * faint + 0.32 * thin * (0.30 + 0.70 * smoothstep(-1.0, 1.0, -across))
        vein = np.clip(vein * (0.85 + 0.12 * clouds), 0.0, 0.55)
        albedo = blend(cloud, ((0.0, colors[0]), (1.0, colors[1])))
        albedo += vein[..., None] * (np.array(colors[2]) - albedo)
        albedo *= (1.0 + 0.008 * grain)[..., None]
        roughness = 0.04 * vein + 0.02 * tile.smudges(0.3) + 0.004 * grain
        return Pattern(albedo, roughness)


def _veins(tile: Tile, level: Array, across: Array, along: Array, width: float) -> Array:
    """Return 1 where noise, bent by other noise [m], is 0, and less near it up to a width [deviations]."""
    beside = np.abs(tile.moved(level, across, along)) / width
    return np.asarray(1.0 / (1.0 + beside**2) ** 1.5)


_marble(
    "marble", (0.74, 0.73, 0.71), ((0.82, 0.815, 0.80), (0.62, 0.62, 0.62), (0.27, 0.28, 0.30)), variants=3
)
_marble(
    "green_marble",
    (0.045, 0.085, 0.060),
    ((0.030, 0.065, 0.043), (0.06, 0.115, 0.08), (0.38, 0.45, 0.40)),
    variants=2,
)
