"""Finishes: metals, plastics, coats, paint, glaze and glass. Brushing runs along v."""

import numpy as np

from artgen.materials.textures.fields import SEEN, Color, Pattern, Tile, blend, recipe, smoothstep

_BRONZE: Color = (0.090, 0.063, 0.045)
_HAMMERED: Color = (0.20, 0.13, 0.075)
_FOAM: Color = (0.80, 0.78, 0.70)
_TORTOISE: Color = (0.150, 0.058, 0.017)
_KNURL = (12, 6)  # grooves across a tile, and the length of each along it


def _grained(
    name: str,
    side: float,
    grain: tuple[float, float],
    roughness: float,
    smudges: tuple[float, float],
    height: float,
) -> None:
    """Register a fine uniform grain on a square tile [m]."""
    # wavelength [m] with its spread, deviation of roughness, height [m]; smudges: deviation, size [m]

    @recipe(name, (side, side))
    def drawn(tile: Tile) -> Pattern:
        field = tile.band(*grain)
        rough = roughness * field + smudges[0] * tile.smudges(smudges[1])
        return Pattern(None, rough, height=height * field)


_grained("anodised", 0.10, (0.0006, 0.6), 0.018, (0.020, 0.08), 3e-6)
_grained("blasted", 0.06, (0.0007, 0.6), 0.025, (0.020, 0.05), 4.5e-6)
_grained("fine_grain", 0.08, (0.0008, 0.6), 0.020, (0.022, 0.06), 4e-6)  # grain of a spark-eroded mold
_grained("sprayed_paint", 0.20, (0.0042, 0.45), 0.008, (0.025, 0.15), 11e-6)  # orange peel
_grained("frosted_glass", 0.06, (0.0007, 0.7), 0.025, (0.020, 0.06), 5e-6)


def _brushed(
    name: str,
    extent: tuple[float, float],
    stroke: tuple[float, float],
    bundle: tuple[float, float],
    roughness: tuple[float, float, float],
    smudge: float,
    height: float,
) -> None:
    """Register metal brushed along v by a belt."""
    # strokes and visible bundles of them: width, length [m]; roughness: of strokes, bundles and smudges

    @recipe(name, extent, variants=2)
    def drawn(tile: Tile) -> Pattern:
        width, length = stroke
        long = tile.streaks(width, length)
        fine = tile.fibres(0.4 * length, 0.15)
        short = tile.streaks(1.5 * width, 0.15 * length)
        strokes = (0.45 * long + 0.65 * fine + 0.45 * short) / 0.91
        fields = (strokes, tile.streaks(*bundle), tile.smudges(smudge))
        rough = roughness[0] * fields[0] + roughness[1] * fields[1] + roughness[2] * fields[2]
        return Pattern(None, rough, height=height * strokes)


_brushed("brushed", (0.15, 0.60), (0.0005, 0.10), (0.0030, 0.25), (0.030, 0.014, 0.030), 0.15, 5e-6)
_brushed("satin", (0.09, 0.36), (0.0003, 0.03), (0.0018, 0.06), (0.022, 0.010, 0.026), 0.08, 2e-6)


def _glossy(name: str, hair: tuple[float, float, float], hairs: float, smudges: tuple[float, float]) -> None:
    """Register a polished surface with hairlines and finger marks only."""

    @recipe(name, (0.25, 0.25), variants=2, varying=())
    def drawn(tile: Tile) -> Pattern:
        width, length, least = hair
        fine = [tile.streaks(*size) for size in ((width, length), (length, width))]
        scratches = smoothstep(least, 3.4, fine[0]) + smoothstep(least, 3.4, fine[1])
        return Pattern(None, smudges[0] * tile.smudges(smudges[1]) + hairs * scratches)


_glossy("polished", (0.0008, 0.02, 2.3), 0.030, (0.020, 0.08))
_glossy("glossy", (0.0010, 0.03, 2.2), 0.025, (0.022, 0.12))


@recipe("tortoise", (0.09, 0.09), _TORTOISE, variants=3, varying=("albedo",))
def _tortoise(tile: Tile) -> Pattern:
    """Draw acetate that looks like tortoise shell: dark brown clouds with soft edges in amber."""
    broad, fine = tile.cloud(0.022, 1.9), tile.cloud(0.008, 1.6)
    dark = smoothstep(-0.75, 0.75, broad + 0.22 * fine)
    stops = ((0.0, (0.48, 0.195, 0.050)), (0.4, (0.21, 0.074, 0.020)), (1.0, (0.020, 0.0135, 0.0125)))
    return Pattern(blend(dark, stops), 0.022 * tile.smudges(0.05) + 0.004 * fine)


@recipe("cast", (0.10, 0.10))
def _cast(tile: Tile) -> Pattern:
    """Draw metal cast in sand: lumps and pits of the sand's grains."""
    lumps = tile.cloud(0.004, 1.5)
    sand = tile.band(0.0011, 0.6)
    pits = smoothstep(1.7, 3.0, tile.band(0.0022, 0.5))
    height = 28e-6 * lumps + 9e-6 * sand - 45e-6 * pits
    roughness = 0.035 * sand + 0.03 * tile.cloud(0.05, 2.0) + 0.08 * pits
    return Pattern(None, roughness, height=height)


@recipe("rolled", (0.30, 0.30))
def _rolled(tile: Tile) -> Pattern:
    """Draw blackened or rolled steel: soft blotches of scale, fine lines of the rolls."""
    blotches = tile.cloud(0.12, 1.7)
    lines = tile.fibres(0.15, 0.4)
    grain = tile.band(0.0016, 0.6)
    roughness = 0.040 * blotches + 0.015 * lines + 0.012 * grain
    return Pattern(None, roughness, height=7e-6 * grain + 5e-6 * lines)


@recipe("aged_bronze", (0.16, 0.16), _BRONZE, variants=2, varying=("albedo", "metalness", "normal"))
def _aged_bronze(tile: Tile) -> Pattern:
    """Draw oil-rubbed bronze: a dark patina, a little lighter in broad soft areas that hands touch."""
    mottle = tile.cloud(0.004, 1.0)
    worn = smoothstep(-0.7, 1.9, tile.cloud(0.09, 2.8))
    grain = tile.band(0.0010, 0.7)
    stops = ((0.0, (0.034, 0.025, 0.020)), (0.4, (0.088, 0.060, 0.041)), (1.0, (0.36, 0.235, 0.14)))
    albedo = blend(0.36 + 0.016 * mottle + 0.10 * worn, stops)
    metalness = np.clip(0.82 + 0.06 * worn - 0.01 * mottle, 0.0, 1.0)
    roughness = 0.015 * grain - 0.06 * worn + 0.022 * mottle + 0.02 * tile.smudges(0.06)
    return Pattern(albedo, roughness, metalness, 3e-6 * grain)


@recipe("hammered", (0.12, 0.12), _HAMMERED, varying=("albedo", "metalness", "normal"))
def _hammered(tile: Tile) -> Pattern:
    """Draw hammered bronze: adjacent dents, dark between them, bright on their ridges."""
    cells = tile.cells(0.0095, 0.8)
    sides = [(distance / 0.0062) ** 2 for distance in (cells.nearest, cells.second)]
    dent = sides[0] - 0.25 * np.log1p(np.exp((sides[0] - sides[1]) / 0.25))  # ridges rounded by wear
    ridge = 1.0 - smoothstep(0.0, 0.0035, cells.second - cells.nearest)
    mottle = tile.cloud(0.02, 1.4)
    share = np.clip(0.40 + 0.10 * ridge + 0.12 * mottle, 0.0, 1.0)
    stops = ((0.0, (0.12, 0.080, 0.050)), (0.5, (0.24, 0.155, 0.09)), (1.0, (0.50, 0.33, 0.19)))
    height = 200e-6 * dent + 1.5e-6 * tile.band(0.001, 0.6)
    metalness = np.clip(0.88 + 0.05 * mottle, 0.0, 1.0)
    roughness = 0.035 * mottle + 0.01 * tile.smudges(0.06)
    return Pattern(blend(share, stops), roughness, metalness, height)


@recipe("knurl", (0.0096, 0.0144))
def _knurl(tile: Tile) -> Pattern:
    """Draw a diamond knurl: two crossing sets of grooves with blunt pyramids."""
    across, along = tile.u / tile.extent[0], tile.v / tile.extent[1]
    # crests, not grooves, lie on the border of the tile
    sets = [
        0.5 + 0.5 * np.cos(2.0 * np.pi * (_KNURL[0] * across + sign * _KNURL[1] * along)) for sign in (1, -1)
    ]
    crests = np.minimum(*[np.arcsin(np.sqrt(each)) / (0.5 * np.pi) for each in sets])
    wear = smoothstep(0.70, 0.80, crests)
    roughness = 0.06 * (1.0 - crests) - 0.05 * wear + 0.02 * tile.cloud(0.004, 1.5)
    return Pattern(None, roughness, height=220e-6 * np.minimum(crests, 0.78))


@recipe("coarse_grain", (0.12, 0.12))
def _coarse_grain(tile: Tile) -> Pattern:
    """Draw molded plastic with an etched leather grain: islands with narrow valleys between."""
    cells = tile.cells(0.0017, 0.9)
    island = smoothstep(0.0, 0.0006, cells.second - cells.nearest)
    fine = tile.band(0.0007, 0.6)
    roughness = -0.05 * island + 0.015 * fine + 0.02 * tile.smudges(0.08)
    return Pattern(None, roughness, height=22e-6 * island + 2.5e-6 * fine)


@recipe("rubber", (0.10, 0.10))
def _rubber(tile: Tile) -> Pattern:
    """Draw rubber: matt, with blotches of bloom and dust."""
    grain = tile.cloud(0.003, 1.1)
    bloom = tile.cloud(0.05, 1.8)
    return Pattern(None, 0.03 * grain + 0.035 * bloom, height=5e-6 * grain)


@recipe("foam", (0.08, 0.08), _FOAM, varying=SEEN)
def _foam(tile: Tile) -> Pattern:
    """Draw cut foam: open cells."""
    cells = tile.cells(0.0014)
    hollow = smoothstep(0.0008, 0.0001, cells.nearest)
    shade = tile.cloud(0.02, 1.5)
    light = 1.0 - 0.22 * hollow + 0.02 * shade
    albedo = np.maximum(light, 0.2)[..., None] * np.array(_FOAM)
    return Pattern(albedo, 0.02 * shade, height=-90e-6 * hollow)


@recipe("powder_coat", (0.12, 0.12))
def _powder_coat(tile: Tile) -> Pattern:
    """Draw powder coat: orange peel with a fine grain."""
    peel = tile.band(0.0024, 0.45)
    grain = tile.band(0.0008, 0.5)
    roughness = 0.012 * peel + 0.016 * grain + 0.02 * tile.smudges(0.10)
    return Pattern(None, roughness, height=6.0e-6 * peel + 1.2e-6 * grain)


@recipe("enamel", (0.30, 0.30), varying=())
def _enamel(tile: Tile) -> Pattern:
    """Draw vitreous or stoved enamel: glossy, with waves flatter than the levels of a normal map."""
    hairs = smoothstep(2.5, 3.6, tile.streaks(0.0012, 0.04))
    return Pattern(None, 0.020 * tile.smudges(0.15) + 0.006 * tile.band(0.009, 0.5) + 0.02 * hairs)


@recipe("brushed_paint", (0.30, 0.60), variants=2)
def _brushed_paint(tile: Tile) -> Pattern:
    """Draw paint brushed along the grain: faint ridges that remained after levelling."""
    ridges = tile.fibres(0.35, 0.7)
    ends = tile.fibres(0.08, 0.4)
    height = 8e-6 * ridges + 3e-6 * ends + 8e-6 * tile.band(0.006, 0.5, 2.0)
    return Pattern(None, 0.012 * ridges + 0.025 * tile.smudges(0.25), height=height)


@recipe("glaze", (0.30, 0.30), varying=())
def _glaze(tile: Tile) -> Pattern:
    """Draw glazed ceramic: a few pin holes, wiped, with waves flatter than the levels of a normal map."""
    holes = smoothstep(3.3, 3.9, tile.band(0.0028, 0.5))
    return Pattern(None, 0.018 * tile.smudges(0.15) + 0.10 * holes)


@recipe("clear_glass", (0.40, 0.40), variants=2, varying=())
def _clear_glass(tile: Tile) -> Pattern:
    """Draw clear glass: smudges and the streaks of wiping."""
    wiped = tile.smudges(0.20) + 0.25 * tile.streaks(0.004, 0.06)
    return Pattern(None, 0.014 * np.clip(wiped, -1.2, 4.0))


@recipe("flat", (0.5, 0.5), varying=())
def _flat(tile: Tile) -> Pattern:
    """Draw a uniform surface with a slight variation of roughness."""
    return Pattern(None, 0.02 * tile.cloud(0.25, 1.8))
