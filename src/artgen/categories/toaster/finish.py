"""Materials of toasters: sleeves and ends by the style of the body, grips, dials and inks."""

from typing import Any

import artgen as ag
from artgen.materials import COLORS

_HEAVY = 2000.0  # density above which a material is a metal [kg/m3]
_SHEET = 1900.0  # density for 0.6 mm of steel, modeled 2.5 mm thick [kg/m3]
_LINED = 1.45  # mass of a plastic wall with its ribs and a tin liner, as a share of solid plastic
_HOLLOW = 560.0  # density of molded or pressed ends with the parts behind them, modeled as solids [kg/m3]

_STEELS = (
    ag.material("stainless"),
    ag.material("stainless_across"),
    ag.material("stainless").with_(name="black_stainless", base_color=(0.105, 0.105, 0.110)),
    ag.material("copper").with_(name="brushed_copper", specular_roughness=0.34, texture="brushed"),
)
_MATTE = tuple(
    ag.colored("abs", color) for color in ("white", "black", "graphite", "sage", "sand", "light_grey", "navy")
)
_GLOSSY = tuple(
    ag.colored("glossy_plastic", color)
    for color in ("white", "black", "cream", "red", "silver", "burgundy", "teal")
)
_ENAMELS = tuple(
    ag.colored("enamel", color)
    for color in ("cream", "mint", "sky", "blush", "red", "black", "white", "sage", "mustard", "navy")
)
_SLEEVES = tuple(
    ag.colored("enamel", color)
    for color in ("white", "black", "cream", "red", "slate", "forest", "blue", "orange")
)
_DARK_ENDS = (ag.material("black_abs"), ag.colored("abs", "graphite"), ag.colored("glossy_plastic", "black"))
_LIGHT_ENDS = (
    ag.colored("abs", "white"),
    ag.colored("abs", "light_grey"),
    ag.colored("glossy_plastic", "cream"),
)


SLEEVES: Any = ag.by(
    "style",
    box=ag.shades(*_MATTE, *_STEELS[:1], weights=(2.0, 2.2, 1.2, 1.0, 0.8, 1.0, 0.6, 1.6), color=0.05),
    rounded=ag.shades(*_GLOSSY, *_STEELS[:1], weights=(2.0, 1.7, 1.4, 1.2, 0.8, 0.8, 0.9, 1.3), color=0.05),
    retro=ag.shades(*_ENAMELS, weights=(1.6, 1.5, 1.4, 1.1, 1.2, 0.9, 1.0, 0.8, 0.6, 0.6), color=0.05),
    steel=ag.shades(*_STEELS, weights=(2.6, 1.6, 1.2, 0.7), color=0.03),
    classic=ag.shades(
        *_SLEEVES, *_STEELS[:1], weights=(1.2, 1.2, 1.2, 1.1, 0.8, 0.7, 0.7, 0.6, 2.0), color=0.05
    ),
    doc="finish of the sleeve, or of a one-piece body",
)
"""Finish of the sleeve, by the parameter `style`."""


ENDS: Any = ag.by(
    "style",
    steel=ag.shades(*_DARK_ENDS, *_LIGHT_ENDS, weights=(3.0, 1.2, 1.2, 0.8, 0.8, 0.5), color=0.04),
    otherwise=ag.shades("brushed_aluminium", "stainless", "chrome", weights=(1.5, 1.5, 0.6), color=0.03),
    doc="finish of the ends of a steel or classic body",
)
"""Finish of ends with another material than the sleeve, by the parameter `style`."""


METALS: Any = ag.by(
    "style",
    retro=ag.shades("chrome", "satin_brass", weights=(0.85, 0.15), color=0.03),
    classic=ag.shades("stainless", "chrome", color=0.03),
    otherwise=ag.shades("stainless", "chrome", "powder_coat_black", weights=(0.5, 0.3, 0.2), color=0.03),
    doc="metal of the trim around the slots and of caps",
)
"""Metal of trim, caps and inlays, by the parameter `style`."""


GRIPS: Any = ag.by(
    "style",
    retro=ag.shades(
        "chrome", "glossy_plastic_black", ag.colored("glossy_plastic", "cream"), weights=(0.6, 0.25, 0.15)
    ),
    classic=ag.shades("black_abs", "glossy_plastic_black", weights=(0.7, 0.3)),
    otherwise=ag.shades(
        "black_abs",
        "glossy_plastic_black",
        ag.colored("abs", "grey"),
        "stainless",
        ag.colored("abs", "white"),
        weights=(3.0, 1.5, 0.8, 1.2, 0.7),
    ),
    doc="material of levers and dials",
)
"""Material of levers and dials, by the parameter `style`."""


KEYS: Any = ag.shades(
    "black_abs",
    "stainless",
    ag.colored("abs", "light_grey"),
    "glossy_plastic_white",
    doc="material of the buttons",
)
"""Material of buttons."""


def sheet(finish: ag.Material, share: float = 1.0) -> ag.Material:
    """Return a finish with the density for the real, thinner wall."""
    density = share * (_SHEET if finish.density > _HEAVY else _LINED * finish.density)
    return finish.with_(name=f"{finish.name}_sheet", density=density)


def hollow(finish: ag.Material) -> ag.Material:
    """Return a finish with the density of a hollow molding or pressing."""
    return finish.with_(name=f"{finish.name}_hollow", density=_HOLLOW)


def is_dark(finish: ag.Material) -> bool:
    """Return whether light print has more contrast on a finish."""
    red, green, blue = finish.base_color
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue < 0.22


def ink_on(finish: ag.Material) -> ag.Material:
    """Return the ink with good contrast on a finish."""
    dark = is_dark(finish)
    color = COLORS["cool_white" if dark else "anthracite"]
    return ag.material("abs").with_(name=f"ink_{'light' if dark else 'dark'}", base_color=color, texture="")
