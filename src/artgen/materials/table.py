"""Materials of the categories, with densities and dry friction of common stock."""

from typing import Any

from artgen.errors import ParameterError, nearest
from artgen.materials.material import Material

Color = tuple[float, float, float]

COLORS: dict[str, Color] = {
    # linear RGB of paints, enamels and plastics of products
    "white": (0.80, 0.79, 0.76),
    "cool_white": (0.78, 0.80, 0.82),
    "ivory": (0.74, 0.69, 0.58),
    "cream": (0.77, 0.69, 0.50),
    "sand": (0.52, 0.43, 0.31),
    "taupe": (0.26, 0.22, 0.18),
    "brown": (0.085, 0.048, 0.030),
    "silver": (0.52, 0.53, 0.54),
    "light_grey": (0.50, 0.50, 0.49),
    "grey": (0.30, 0.31, 0.31),
    "slate": (0.11, 0.13, 0.15),
    "graphite": (0.055, 0.058, 0.062),
    "anthracite": (0.034, 0.036, 0.039),
    "black": (0.022, 0.022, 0.023),
    "sage": (0.30, 0.36, 0.27),
    "olive": (0.14, 0.145, 0.055),
    "forest": (0.030, 0.085, 0.045),
    "mint": (0.46, 0.68, 0.56),
    "teal": (0.025, 0.19, 0.20),
    "sky": (0.33, 0.52, 0.66),
    "blue": (0.035, 0.12, 0.38),
    "navy": (0.030, 0.055, 0.12),
    "lavender": (0.42, 0.37, 0.58),
    "blush": (0.70, 0.43, 0.38),
    "pink": (0.74, 0.36, 0.40),
    "coral": (0.70, 0.20, 0.13),
    "red": (0.38, 0.028, 0.024),
    "burgundy": (0.12, 0.022, 0.028),
    "orange": (0.74, 0.20, 0.025),
    "mustard": (0.55, 0.32, 0.045),
    "yellow": (0.80, 0.52, 0.045),
}
"""Colors of products, linear RGB, by name."""

_LACQUER: dict[str, Any] = {"coat_weight": 0.3, "coat_roughness": 0.28}  # satin
_HARD: dict[str, Any] = {"specular_roughness": 0.42, "density": 700.0, "friction": 0.5, **_LACQUER}
_SOFT: dict[str, Any] = {"specular_roughness": 0.46, "density": 500.0, "friction": 0.5, **_LACQUER}
_STEEL: dict[str, Any] = {"base_metalness": 1.0, "density": 7850.0, "friction": 0.6}
_STAINLESS: dict[str, Any] = {"base_metalness": 1.0, "density": 7900.0, "friction": 0.5}
_BRASS: dict[str, Any] = {"base_metalness": 1.0, "density": 8500.0, "friction": 0.45}
_ALUMINIUM: dict[str, Any] = {"base_metalness": 1.0, "density": 2700.0, "friction": 0.5}
_ZINC: dict[str, Any] = {"base_metalness": 1.0, "density": 6600.0, "friction": 0.5}
_COAT: dict[str, Any] = {"density": 7850.0, "friction": 0.5}
_ABS: dict[str, Any] = {"density": 1050.0, "friction": 0.35}
_CLEAR: dict[str, Any] = {"density": 2500.0, "friction": 0.4}
_STONE: dict[str, Any] = {"density": 2700.0, "friction": 0.6}
_CLOTH: dict[str, Any] = {"density": 300.0, "friction": 0.6}
_LIGHT: dict[str, Any] = {"specular_roughness": 0.3, "density": 1200.0, "friction": 0.35}
_BRUSHED_GREY = (0.62, 0.61, 0.60)
_PAINT_WHITE = COLORS["white"]


def _woods() -> list[Material]:
    """Return each species with straight grain and flat-sawn."""
    stock = {
        "oak": ((0.44, 0.27, 0.13), _HARD),
        "walnut": ((0.16, 0.085, 0.045), _HARD),
        "beech": ((0.60, 0.40, 0.24), _HARD),
        "pine": ((0.66, 0.45, 0.24), _SOFT),
        "mahogany": ((0.22, 0.075, 0.035), _HARD),
        "maple": ((0.68, 0.52, 0.35), _HARD),
        "ash": ((0.60, 0.46, 0.31), _HARD),
    }
    return [
        Material(name + cut, color, texture=name + cut, **physics)
        for name, (color, physics) in stock.items()
        for cut in ("", "_flat_sawn")
    ]


def _boards() -> list[Material]:
    plywood: dict[str, Any] = {"density": 600.0, "friction": 0.5}
    mdf: dict[str, Any] = {"density": 750.0, "friction": 0.5}
    paint: dict[str, Any] = {"specular_roughness": 0.38, "texture": "brushed_paint", "friction": 0.5}
    paper: dict[str, Any] = {"specular_roughness": 0.85, "density": 180.0, "friction": 0.45}
    return [
        Material("plywood", (0.62, 0.45, 0.28), specular_roughness=0.55, texture="plywood", **plywood),
        Material(
            "plywood_edge", (0.62, 0.45, 0.28), specular_roughness=0.62, texture="plywood_edge", **plywood
        ),
        Material("mdf", (0.42, 0.31, 0.21), specular_roughness=0.7, texture="mdf", **mdf),
        Material("painted_wood", _PAINT_WHITE, density=700.0, **paint),
        Material("hollow_core", _PAINT_WHITE, density=330.0, **paint),
        Material("lacquered_mdf", _PAINT_WHITE, specular_roughness=0.22, texture="sprayed_paint", **mdf),
        Material("cardboard", (0.48, 0.33, 0.19), texture="cardboard", **paper),
        Material("cardboard_edge", (0.23, 0.155, 0.088), texture="cardboard_edge", **paper),
    ]


def _metals() -> list[Material]:
    brushed: dict[str, Any] = {"specular_roughness": 0.32, "texture": "brushed"}
    return [
        Material("steel", (0.55, 0.55, 0.56), specular_roughness=0.4, texture="satin", **_STEEL),
        Material("black_steel", (0.025, 0.025, 0.027), specular_roughness=0.45, texture="rolled", **_COAT),
        Material(
            "cast_iron",
            (0.04, 0.04, 0.042),
            specular_roughness=0.65,
            base_metalness=0.3,
            texture="cast",
            density=7200.0,
            friction=0.6,
        ),
        Material("stainless", _BRUSHED_GREY, **brushed, **_STAINLESS),
        Material("stainless_across", _BRUSHED_GREY, turned=True, **brushed, **_STAINLESS),
        Material(
            "stainless_blasted", _BRUSHED_GREY, specular_roughness=0.42, texture="blasted", **_STAINLESS
        ),
        Material("stainless_knurled", _BRUSHED_GREY, specular_roughness=0.3, texture="knurl", **_STAINLESS),
        Material("chrome", (0.78, 0.78, 0.79), specular_roughness=0.08, texture="polished", **_STEEL),
        Material("satin_nickel", (0.64, 0.60, 0.55), specular_roughness=0.34, texture="satin", **_STEEL),
        Material("zinc", (0.60, 0.60, 0.61), specular_roughness=0.35, texture="blasted", **_ZINC),
        Material("brass", (0.80, 0.58, 0.25), specular_roughness=0.2, texture="polished", **_BRASS),
        Material("satin_brass", (0.74, 0.54, 0.26), specular_roughness=0.36, texture="satin", **_BRASS),
        Material("copper", (0.90, 0.55, 0.42), specular_roughness=0.25, texture="polished", **_BRASS),
        Material(
            "aged_bronze",
            (0.090, 0.063, 0.045),
            specular_roughness=0.38,
            texture="aged_bronze",
            **{**_BRASS, "base_metalness": 0.8},
        ),
        Material(
            "hammered_bronze",
            (0.20, 0.13, 0.075),
            specular_roughness=0.38,
            texture="hammered",
            **{**_BRASS, "base_metalness": 0.88},
        ),
        Material("aluminium", (0.75, 0.76, 0.77), specular_roughness=0.35, texture="anodised", **_ALUMINIUM),
        Material("brushed_aluminium", (0.77, 0.78, 0.79), **brushed, **_ALUMINIUM),
        Material(
            "black_anodised",
            (0.028, 0.028, 0.030),
            specular_roughness=0.38,
            texture="anodised",
            **{**_ALUMINIUM, "base_metalness": 0.0},
        ),
        Material(
            "perforated_steel", (0.03, 0.03, 0.031), specular_roughness=0.5, texture="perforated", **_COAT
        ),
    ]


def _coats() -> list[Material]:
    powder: dict[str, Any] = {"specular_roughness": 0.42, "texture": "powder_coat", **_COAT}
    enamel: dict[str, Any] = {"specular_roughness": 0.12, "texture": "enamel", **_COAT}
    return [
        Material("powder_coat", COLORS["light_grey"], **powder),
        Material("powder_coat_white", COLORS["white"], **powder),
        Material("powder_coat_black", COLORS["black"], **powder),
        Material("powder_coat_graphite", COLORS["graphite"], **powder),
        Material("enamel", COLORS["white"], **enamel),
        Material("enamel_white", COLORS["white"], **enamel),
        Material("enamel_cream", COLORS["cream"], **enamel),
        Material("enamel_black", COLORS["black"], **enamel),
    ]


def _plastics() -> list[Material]:
    fine: dict[str, Any] = {"texture": "fine_grain", **_ABS}
    coarse: dict[str, Any] = {"texture": "coarse_grain", **_ABS}
    gloss: dict[str, Any] = {"texture": "glossy", **_ABS}
    rubber: dict[str, Any] = {"texture": "rubber", "density": 1150.0, "friction": 0.9}
    return [
        Material("abs", (0.70, 0.70, 0.69), specular_roughness=0.4, **fine),
        Material("black_abs", (0.025, 0.025, 0.026), specular_roughness=0.45, **fine),
        Material("leather_grain_abs", (0.055, 0.055, 0.057), specular_roughness=0.5, **coarse),
        Material("glossy_plastic", (0.78, 0.78, 0.77), specular_roughness=0.14, **gloss),
        Material("glossy_plastic_white", (0.78, 0.78, 0.77), specular_roughness=0.14, **gloss),
        Material("glossy_plastic_black", (0.022, 0.022, 0.023), specular_roughness=0.12, **gloss),
        Material(
            "polypropylene",
            (0.75, 0.75, 0.74),
            specular_roughness=0.45,
            texture="fine_grain",
            density=905.0,
            friction=0.3,
        ),
        Material(
            "polycarbonate",
            (0.85, 0.88, 0.90),
            specular_roughness=0.1,
            transmission_weight=0.9,
            opacity=0.35,
            texture="glossy",
            density=1200.0,
            friction=0.35,
        ),
        Material("rubber", (0.03, 0.03, 0.03), specular_roughness=0.8, **rubber),
        Material("silicone", (0.32, 0.32, 0.31), specular_roughness=0.6, **rubber),
        Material(
            "foam", (0.80, 0.78, 0.70), specular_roughness=0.9, texture="foam", density=35.0, friction=0.6
        ),
    ]


def _glass_and_stone() -> list[Material]:
    clear: dict[str, Any] = {"specular_roughness": 0.04, "transmission_weight": 1.0, "texture": "clear_glass"}
    return [
        Material("glass", (0.97, 0.985, 0.98), opacity=0.18, **clear, **_CLEAR),
        Material("tinted_glass", (0.28, 0.31, 0.31), opacity=0.55, **clear, **_CLEAR),
        Material("amber_glass", (0.52, 0.25, 0.06), opacity=0.5, **clear, **_CLEAR),
        Material(
            "frosted_glass",
            (0.95, 0.97, 0.97),
            specular_roughness=0.4,
            transmission_weight=1.0,
            opacity=0.6,
            texture="frosted_glass",
            **_CLEAR,
        ),
        Material(
            "black_glass", (0.021, 0.021, 0.022), specular_roughness=0.05, texture="clear_glass", **_CLEAR
        ),
        Material(
            "ceramic",
            (0.85, 0.84, 0.81),
            specular_roughness=0.15,
            texture="glaze",
            density=2400.0,
            friction=0.45,
        ),
        Material("granite", (0.25, 0.24, 0.24), specular_roughness=0.25, texture="granite", **_STONE),
        Material(
            "black_granite", (0.032, 0.032, 0.034), specular_roughness=0.18, texture="black_granite", **_STONE
        ),
        Material("marble", (0.74, 0.73, 0.71), specular_roughness=0.16, texture="marble", **_STONE),
        Material(
            "green_marble", (0.045, 0.085, 0.06), specular_roughness=0.16, texture="green_marble", **_STONE
        ),
    ]


def _cloth_and_lights() -> list[Material]:
    woven: dict[str, Any] = {"density": 350.0, "friction": 0.5}
    return [
        Material("fabric", (0.75, 0.71, 0.64), specular_roughness=0.9, texture="linen", **_CLOTH),
        Material("linen", (0.66, 0.58, 0.45), specular_roughness=0.9, texture="linen", **_CLOTH),
        Material("canvas", (0.30, 0.31, 0.33), specular_roughness=0.9, texture="canvas", **_CLOTH),
        Material("wicker", (0.36, 0.23, 0.12), specular_roughness=0.55, texture="wicker", **woven),
        Material(
            "plastic_wicker", (0.060, 0.045, 0.036), specular_roughness=0.4, texture="plastic_wicker", **woven
        ),
        Material("led_white", (0.80, 0.80, 0.80), emission=(1.0, 0.96, 0.88), **_LIGHT),
        Material("led_red", (0.30, 0.025, 0.022), emission=(1.0, 0.06, 0.03), **_LIGHT),
        Material("led_green", (0.030, 0.28, 0.05), emission=(0.10, 1.0, 0.22), **_LIGHT),
        Material("led_blue", (0.030, 0.09, 0.32), emission=(0.08, 0.35, 1.0), **_LIGHT),
        Material("led_amber", (0.34, 0.16, 0.022), emission=(1.0, 0.45, 0.04), **_LIGHT),
        Material("display", (0.030, 0.12, 0.15), emission=(0.28, 0.86, 1.0), **_LIGHT),
        Material("bulb", (0.82, 0.80, 0.74), emission=(1.0, 0.82, 0.55), **_LIGHT),
    ]


MATERIALS: dict[str, Material] = {
    made.name: made
    for made in (
        *_woods(),
        *_boards(),
        *_metals(),
        *_coats(),
        *_plastics(),
        *_glass_and_stone(),
        *_cloth_and_lights(),
    )
}
"""The materials by name."""


def material(name: str) -> Material:
    """Return a material of the table by name.

    Raises:
        ParameterError: The table has no such material; the message suggests the nearest name.
    """
    if name not in MATERIALS:
        raise ParameterError(f"there is no material {name!r}.{nearest(name, MATERIALS)}")
    return MATERIALS[name]


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
