"""What pepper mills are made of."""

from artgen import coloured, material
from artgen.categories.shared.finish import known, weighing

_EBONY = material("walnut").with_(name="ebonised_beech", base_color=(0.034, 0.026, 0.021), density=720.0)
_OLIVE = material("ash_flat_sawn").with_(name="olive_wood", base_color=(0.46, 0.28, 0.11), density=920.0)

_CHERRY = material("maple").with_(name="cherry", base_color=(0.40, 0.17, 0.075), density=630.0)

WOODS = (*known("beech", "walnut", "oak", "mahogany"), _CHERRY, *known("maple"), _EBONY, _OLIVE)
"""Woods that are turned."""

WOOD_WEIGHTS = (1.8, 2.2, 1.2, 1.4, 0.8, 0.9, 1.4, 1.0)
"""How often."""

_COLORS = {
    "black": 2.6,
    "white": 2.2,
    "red": 1.5,
    "burgundy": 0.7,
    "graphite": 1.0,
    "navy": 0.8,
    "sage": 0.7,
    "mustard": 0.6,
    "cream": 0.7,
    "teal": 0.6,
    "orange": 0.5,
}

LACQUERS = weighing([coloured("lacquered_mdf", color) for color in _COLORS], 690.0, "beech")
"""Lacquers on beech."""

LACQUER_WEIGHTS = tuple(_COLORS.values())
"""How often."""

STEELS = (
    *weighing(known("stainless", "brushed_aluminium", "copper", "satin_brass"), 760.0, "drawn"),
    *weighing(known("powder_coat_black", "powder_coat_graphite"), 760.0, "drawn"),
)
"""Drawn shells of 0.7 mm around a liner: what the whole weighs is spread over it."""

STEEL_WEIGHTS = (3.0, 1.0, 0.7, 0.5, 1.0, 0.6)
"""How often."""

CLEAR = (
    material("polycarbonate").with_(name="acrylic", base_color=(0.93, 0.95, 0.95), opacity=0.22),
    material("polycarbonate").with_(name="smoked_acrylic", base_color=(0.30, 0.30, 0.31), opacity=0.45),
)
"""Clear plastics."""

METALS = known("stainless", "chrome", "satin_brass", "copper", "black_steel")
"""Of nuts, rings and cranks."""

METAL_WEIGHTS = (3.0, 1.6, 1.4, 0.4, 0.6)
"""How often."""
