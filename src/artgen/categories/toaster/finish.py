"""Materials of toasters with their weights in a random choice, and materials derived from a finish."""

from typing import Any

import artgen as ag
from artgen.categories.shared.finish import colored_weights
from artgen.materials import COLORS

_HEAVY = 2000.0  # density above which a material is a metal [kg/m3]
_SHEET = 1900.0  # density for 0.6 mm of steel, modeled 2.5 mm thick [kg/m3]
_LINED = 1.45  # mass of a plastic wall with its ribs and a tin liner, as a share of solid plastic
_HOLLOW = 560.0  # density of molded or pressed ends with the parts behind them, modeled as solids [kg/m3]
_DARK = 0.22  # luminance below which light print has more contrast

_STEEL = ag.material("stainless")
_BLACK_STEEL = _STEEL.with_(name="black_stainless", base_color=(0.105, 0.105, 0.110))
_COPPER = ag.material("copper").with_(name="brushed_copper", specular_roughness=0.34, texture="brushed")
_MATTE = {"white": 2.0, "black": 2.2, "graphite": 1.2, "sage": 1.0, "sand": 0.8, "light_grey": 1.0,
          "navy": 0.6}  # fmt: skip
_GLOSSY = {"white": 2.0, "black": 1.7, "cream": 1.4, "red": 1.2, "silver": 0.8, "burgundy": 0.8,
           "teal": 0.9}  # fmt: skip
_ENAMEL = {"cream": 1.6, "mint": 1.5, "sky": 1.4, "blush": 1.1, "red": 1.2, "black": 0.9, "white": 1.0,
           "sage": 0.8, "mustard": 0.6, "navy": 0.6}  # fmt: skip
_CAFE = {"white": 1.2, "black": 1.2, "cream": 1.2, "red": 1.1, "slate": 0.8, "forest": 0.7, "blue": 0.7,
         "orange": 0.6}  # fmt: skip

SLEEVES: Any = ag.by(
    "style",
    box=ag.shades({**colored_weights("abs", _MATTE), _STEEL: 1.6}, color=0.05),
    rounded=ag.shades({**colored_weights("glossy_plastic", _GLOSSY), _STEEL: 1.3}, color=0.05),
    retro=ag.shades(colored_weights("enamel", _ENAMEL), color=0.05),
    steel=ag.shades({_STEEL: 2.6, "stainless_across": 1.6, _BLACK_STEEL: 1.2, _COPPER: 0.7}, color=0.03),
    classic=ag.shades({**colored_weights("enamel", _CAFE), _STEEL: 2.0}, color=0.05),
    doc="finish of the sleeve, or of a one-piece body",
)

_MOLDED = {"black_abs": 3.0, ag.colored("abs", "graphite"): 1.2, ag.colored("glossy_plastic", "black"): 1.2,
           ag.colored("abs", "white"): 0.8, ag.colored("abs", "light_grey"): 0.8,
           ag.colored("glossy_plastic", "cream"): 0.5}  # fmt: skip
ENDS: Any = ag.by(
    "style",
    steel=ag.shades(_MOLDED, color=0.04),
    otherwise=ag.shades({"brushed_aluminium": 1.5, "stainless": 1.5, "chrome": 0.6}, color=0.03),
    doc="finish of the ends of a steel or classic body",
)

METALS: Any = ag.by(
    "style",
    retro=ag.shades({"chrome": 0.85, "satin_brass": 0.15}, color=0.03),
    classic=ag.shades("stainless", "chrome", color=0.03),
    otherwise=ag.shades({"stainless": 0.5, "chrome": 0.3, "powder_coat_black": 0.2}, color=0.03),
    doc="metal of the trim around the slots and of caps",
)

_GRIPS = {"black_abs": 3.0, "glossy_plastic_black": 1.5, ag.colored("abs", "grey"): 0.8, "stainless": 1.2,
          ag.colored("abs", "white"): 0.7}  # fmt: skip
GRIPS: Any = ag.by(
    "style",
    retro=ag.shades(
        {"chrome": 0.6, "glossy_plastic_black": 0.25, ag.colored("glossy_plastic", "cream"): 0.15}
    ),
    classic=ag.shades({"black_abs": 0.7, "glossy_plastic_black": 0.3}),
    otherwise=ag.shades(_GRIPS),
    doc="material of levers and dials",
)

_KEYS = ("black_abs", "stainless", ag.colored("abs", "light_grey"), "glossy_plastic_white")
KEYS: Any = ag.shades(*_KEYS, doc="material of the buttons")


def sheet(finish: ag.Material, share: float) -> ag.Material:
    """Return a finish with the density of the real wall, a share of the modeled one."""
    density = share * (_SHEET if finish.density > _HEAVY else _LINED * finish.density)
    return finish.with_(name=f"{finish.name}_sheet", density=density)


def hollow(finish: ag.Material) -> ag.Material:
    """Return a finish with the density of a hollow molding or pressing."""
    return finish.with_(name=f"{finish.name}_hollow", density=_HOLLOW)


def ink_on(finish: ag.Material) -> ag.Material:
    """Return the ink with good contrast on a finish."""
    red, green, blue = finish.base_color
    is_dark = 0.2126 * red + 0.7152 * green + 0.0722 * blue < _DARK
    tone, color = ("light", "cool_white") if is_dark else ("dark", "anthracite")
    return ag.material("abs").with_(name=f"ink_{tone}", base_color=COLORS[color], texture="")
