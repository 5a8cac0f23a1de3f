"""Materials of soap dispensers and soaps, with their weights in a random choice.

Opaque bottles have the mean density of the filled bottle: soap in four fifths of the space, and walls of 5 mm
of ceramic, 1.5 mm of plastic or 0.6 mm of steel.
"""

from collections.abc import Mapping

import artgen as ag
from artgen.categories.shared.finish import colored_weights
from artgen.materials import COLORS

Weights = Mapping[ag.Material, float]


def _weighing(density: float, prefix: str, weights: Mapping[str, float], base: str = "") -> Weights:
    """Return library materials, or `base` in these colors, with another density [kg/m3]."""
    plain = colored_weights(base, weights) if base else {ag.material(name): weights[name] for name in weights}
    return {
        each.with_(name=f"{prefix}_{each.name}", density=density): weight for each, weight in plain.items()
    }


_GLASSES = {"glass": 0.42, "amber_glass": 0.30, "frosted_glass": 0.18, "tinted_glass": 0.10}
GLASSES = ag.shades(_GLASSES, color=0.03, roughness=0.0)

_GLAZES = {"white": 3, "cream": 1.4, "sand": 1, "sage": 1.2, "teal": 0.8, "navy": 0.8, "black": 1.2,
           "blush": 0.8, "mint": 0.6, "taupe": 0.9, "light_grey": 1, "coral": 0.4, "blue": 0.6}  # fmt: skip
_STONES = {"marble": 1.2, "green_marble": 0.5, "black_granite": 0.6, "granite": 0.5}
_CERAMICS = {**_weighing(1150.0, "thrown", _GLAZES, "ceramic"), **_weighing(1250.0, "bored", _STONES)}
CERAMICS = ag.shades(_CERAMICS, color=0.05)

_DYES = {"white": 3, "black": 1.6, "light_grey": 1, "cream": 0.8, "sage": 0.8, "sky": 0.8, "blush": 0.8,
         "graphite": 0.8, "yellow": 0.6, "mint": 0.6, "lavender": 0.5}  # fmt: skip
PLASTICS = ag.shades(_weighing(940.0, "filled", _DYES, "glossy_plastic"), color=0.04)

_SHELLS = {"stainless": 3, "brushed_aluminium": 1, "copper": 0.6, "satin_brass": 0.6}
_COATS = {"black": 1.6, "white": 0.9, "graphite": 0.8, "sage": 0.5}
_STEELS = {**_weighing(1000.0, "filled", _SHELLS), **_weighing(1000.0, "filled", _COATS, "powder_coat")}
STEELS = ag.shades(_STEELS, color=0.03)

_PLATINGS = {"stainless": 2.4, "chrome": 1.8, "satin_brass": 1.6, "copper": 0.5, "powder_coat_black": 1.8,
             "aged_bronze": 0.5}  # fmt: skip
_PLATED = _weighing(3600.0, "plated", _PLATINGS)  # pumps with a plastic inside
_DYED = {"white": 2.4, "black": 2, "light_grey": 0.6, "graphite": 0.6}
_MOLDED = colored_weights("abs", _DYED)
MOLDED_PUMPS = ag.shades(_MOLDED, color=0.04)
PLATED_PUMPS = ag.shades(_PLATED, color=0.03)
PUMPS = ag.shades({**_PLATED, **{each: 1.2 * weight for each, weight in _MOLDED.items()}}, color=0.03)

_LIQUIDS = {
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
    for name, color in _LIQUIDS.items()
)

_FIRED = dict.fromkeys(("white", "cool_white", "sage", "navy", "light_grey"), 1.0)
_TILES = _weighing(2300.0, "fired", _FIRED, "ceramic")
TILES = ag.shades(*_TILES, "marble", "granite", color=0.03, doc="tile behind a wall dispenser")


def ink_on(finish: ag.Material) -> ag.Material:
    """Return the material of print on a finish: dark on light, light on dark."""
    dark = 0.6 if finish.transmission_weight > 0.5 else 0.30
    return ag.colored("abs", "anthracite" if sum(finish.base_color) / 3 > dark else "white")
