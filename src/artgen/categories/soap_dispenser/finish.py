"""Materials of soap dispensers and soaps.

Opaque bottles have the mean density of the filled bottle: soap in four fifths of the space, and walls of 5 mm
of ceramic, 1.5 mm of plastic or 0.6 mm of steel.
"""

import artgen as ag
from artgen.categories.shared.finish import known, weighing
from artgen.materials import COLORS

GLASSES = known("glass", "amber_glass", "frosted_glass", "tinted_glass")
"""Clear bottles."""

GLASS_WEIGHTS = (0.42, 0.30, 0.18, 0.10)
"""Weights of `GLASSES` in a random choice."""

_GLAZES = {
    "white": 3.0,
    "cream": 1.4,
    "sand": 1.0,
    "sage": 1.2,
    "teal": 0.8,
    "navy": 0.8,
    "black": 1.2,
    "blush": 0.8,
    "mint": 0.6,
    "taupe": 0.9,
    "light_grey": 1.0,
    "coral": 0.4,
    "blue": 0.6,
}

CERAMICS = (
    *weighing([ag.colored("ceramic", color) for color in _GLAZES], 1150.0, "thrown"),
    *weighing(known("marble", "green_marble", "black_granite", "granite"), 1250.0, "bored"),
)
"""Ceramic glazes, and stone."""

CERAMIC_WEIGHTS = (*_GLAZES.values(), 1.2, 0.5, 0.6, 0.5)
"""Weights of `CERAMICS` in a random choice."""

_DYES = (
    "white",
    "black",
    "light_grey",
    "cream",
    "sage",
    "sky",
    "blush",
    "graphite",
    "yellow",
    "mint",
    "lavender",
)

PLASTICS = weighing([ag.colored("glossy_plastic", color) for color in _DYES], 940.0, "filled")
"""Plastics of opaque bottles."""

PLASTIC_WEIGHTS = (3.0, 1.6, 1.0, 0.8, 0.8, 0.8, 0.8, 0.8, 0.6, 0.6, 0.5)
"""Weights of `PLASTICS` in a random choice."""

STEELS = (
    *weighing(known("stainless", "brushed_aluminium", "copper", "satin_brass"), 1000.0, "filled"),
    *weighing(
        [ag.colored("powder_coat", color) for color in ("black", "white", "graphite", "sage")],
        1000.0,
        "filled",
    ),
)
"""Drawn shells of metal."""

STEEL_WEIGHTS = (3.0, 1.0, 0.6, 0.6, 1.6, 0.9, 0.8, 0.5)
"""Weights of `STEELS` in a random choice."""

METALS = weighing(
    known("stainless", "chrome", "satin_brass", "copper", "powder_coat_black", "aged_bronze"),
    3600.0,
    "plated",
)
"""Metal pumps with a plastic inside."""

METAL_WEIGHTS = (2.4, 1.8, 1.6, 0.5, 1.8, 0.5)
"""Weights of `METALS` in a random choice."""

PUMPS = tuple(ag.colored("abs", color) for color in ("white", "black", "light_grey", "graphite"))
"""Plastics of pumps."""

PUMP_WEIGHTS = (2.4, 2.0, 0.6, 0.6)
"""Weights of `PUMPS` in a random choice."""

_SOAPS = {
    "clear": (0.80, 0.84, 0.86),
    "sky": COLORS["sky"],
    "mint": COLORS["mint"],
    "rose": (0.80, 0.42, 0.46),
    "honey": (0.80, 0.46, 0.10),
    "lavender": COLORS["lavender"],
    "lime": (0.50, 0.68, 0.14),
    "milk": (0.86, 0.84, 0.78),
}

SOAPS = tuple(
    ag.material("polycarbonate").with_(
        name=f"soap_{name}",
        base_color=color,
        specular_roughness=0.15,
        transmission_weight=0.0 if name == "milk" else 0.55,
        opacity=1.0 if name == "milk" else 0.72,
        texture="",
        density=1025.0,
    )
    for name, color in _SOAPS.items()
)
"""Liquid soaps and lotions."""

TILES = (
    *weighing(
        [ag.colored("ceramic", color) for color in ("white", "cool_white", "sage", "navy", "light_grey")],
        2300.0,
        "fired",
    ),
    *known("marble", "granite"),
)
"""Tiles behind wall dispensers."""

_LIGHT = 0.30


def ink_on(finish: ag.Material) -> ag.Material:
    """Return the material of print on a finish."""
    mean = sum(finish.base_color) / 3.0
    if finish.transmission_weight > 0.5:
        return ag.colored("abs", "white" if mean < 0.6 else "anthracite")
    return ag.colored("abs", "anthracite" if mean > _LIGHT else "white")
