"""Materials of furniture: veneers, lacquer, melamine and printed decors on board, tops and hardware.

A category first draws a look; the finish of fronts and carcass depends on it:

    look: BoardLook = choice("wood", "lacquer", "melamine", "decor", weights=(...))
    finish: Material = boards()
"""

from typing import Any, Literal

import artgen as ag
from artgen.categories.shared.finish import known, weighing

BoardLook = Literal["wood", "lacquer", "melamine", "decor"]
"""Veneered or solid wood; sprayed MDF; board with a plain foil, or with a printed wood grain."""

CaseLook = Literal["wood", "lacquer", "melamine", "decor", "steel"]
"""The same looks, or folded sheet steel."""

_WOODS: dict[str, float] = {
    "oak": 2.0,
    "oak_flat_sawn": 1.2,
    "walnut": 1.4,
    "walnut_flat_sawn": 0.8,
    "beech": 0.9,
    "maple": 0.6,
    "ash": 0.8,
    "pine_flat_sawn": 0.9,
    "mahogany": 0.7,
}
# density of wood between pine and oak, glued up or on board [kg/m3]
WOODS = weighing(known(*_WOODS), 650.0, "furniture")
"""Woods of furniture."""

_LACQUERS: dict[str, float] = {
    "white": 2.2,
    "ivory": 1.0,
    "sage": 1.2,
    "navy": 1.0,
    "graphite": 1.0,
    "taupe": 0.6,
    "forest": 0.7,
    "light_grey": 0.9,
    "sky": 0.5,
    "blush": 0.5,
    "black": 0.6,
    "mustard": 0.3,
    "burgundy": 0.3,
}
LACQUERS = tuple(ag.colored("lacquered_mdf", color) for color in _LACQUERS)
"""Sprayed MDF, 750 kg/m3."""

# foil on chipboard
_FOIL: dict[str, Any] = {"specular_roughness": 0.42, "coat_weight": 0.0, "density": 660.0}
_MELAMINES: dict[str, float] = {"cool_white": 2.4, "light_grey": 1.0, "sand": 0.7, "graphite": 0.8}
MELAMINES = tuple(
    ag.colored("lacquered_mdf", color).with_(name=f"melamine_{color}", **_FOIL) for color in _MELAMINES
)
"""Chipboard with a foil of one color."""

_DECORS: dict[str, float] = {"oak": 1.4, "walnut": 0.8, "ash": 1.0, "beech": 0.6}
DECORS = tuple(
    ag.material(name).with_(name=f"decor_{name}", **_FOIL | {"specular_roughness": 0.5}) for name in _DECORS
)
"""Chipboard with a foil with a printed wood grain."""

_STEELS: dict[str, float] = {
    "light_grey": 2.0,
    "white": 1.4,
    "graphite": 1.2,
    "black": 1.2,
    "sand": 0.8,
    "sage": 0.5,
    "red": 0.4,
    "mustard": 0.3,
    "navy": 0.4,
}
# walls are two sheets of 0.8 mm with air between them: 1.6 of some 14 mm are steel, and less in single walls
STEELS = weighing([ag.colored("powder_coat", color) for color in _STEELS], 620.0, "sheet")
"""Folded sheet steel, painted."""

WHITE_BOARD = ag.colored("lacquered_mdf", "cool_white").with_(name="melamine_inside", **_FOIL)
"""White melamine for the insides of kitchen cabinets."""

PLY = ag.material("plywood").with_(name="birch_ply", base_color=(0.70, 0.55, 0.37))
"""Birch plywood: backs, and the bottoms and sides of drawers."""

HARDBOARD = ag.colored("lacquered_mdf", "cool_white").with_(name="hardboard_white", density=850.0)
"""Hardboard with a white face: thin backs and bottoms."""

ZINC = ag.material("zinc").with_(name="zinc_plated", base_color=(0.66, 0.67, 0.69), density=7850.0)
"""Zinc-plated steel of runners, hinges and pins."""

GREY_STEEL = ag.colored("powder_coat", "light_grey").with_(name="grey_steel_walls", density=700.0)
"""Hollow sides of drawers of folded sheet steel."""

CREAM_STEEL = ag.colored("powder_coat", "ivory").with_(name="cream_steel")
"""Epoxy-coated steel of roller runners."""

CLEAR_RUBBER = ag.material("polycarbonate").with_(name="clear_rubber", density=1150.0, friction=0.9)
"""Bumpers behind doors."""

_STONES = {"granite": 1.0, "black_granite": 1.0, "marble": 0.8}
_TOPS = (
    *weighing(known("oak", "beech", "walnut"), 680.0, "butcher_block"),
    *(
        ag.colored("lacquered_mdf", color).with_(name=f"laminate_{color}", **_FOIL)
        for color in ("graphite", "white", "sand")
    ),
    *known(*_STONES),
)
_TOP_WEIGHTS = (1.6, 1.2, 0.7, 0.9, 0.8, 0.4, *_STONES.values())

HARDWARE: dict[str, float] = {
    "satin_nickel": 1.8,
    "stainless": 1.4,
    "chrome": 0.9,
    "satin_brass": 1.6,
    "brass": 0.6,
    "aged_bronze": 0.8,
    "powder_coat_black": 1.6,
    "black_steel": 0.5,
}
"""Metals of furniture handles, with their weights in a random choice."""


def boards(*looks: CaseLook, color: float = 0.05) -> Any:
    """Draw the material of fronts and carcass by the parameter `look`."""
    stock: dict[CaseLook, tuple[tuple[ag.Material, ...], tuple[float, ...]]] = {
        "wood": (WOODS, tuple(_WOODS.values())),
        "lacquer": (LACQUERS, tuple(_LACQUERS.values())),
        "melamine": (MELAMINES, tuple(_MELAMINES.values())),
        "decor": (DECORS, tuple(_DECORS.values())),
        "steel": (STEELS, tuple(_STEELS.values())),
    }
    cases = {
        look: ag.shades(*stock[look][0], weights=stock[look][1], color=color, roughness=0.04)
        for look in looks
    }
    return ag.by("look", cases, doc="finish of fronts and carcass")


def accents() -> Any:
    """Draw the material of fronts with another finish than the carcass, by the parameter `fronts`."""
    return ag.by(
        "fronts",
        wood=ag.shades(*WOODS[:5], weights=tuple(_WOODS.values())[:5], color=0.05, roughness=0.04),
        otherwise=ag.shades(*LACQUERS, weights=tuple(_LACQUERS.values()), color=0.05, roughness=0.04),
        doc="finish of fronts that differ from the carcass",
    )


def worktops() -> Any:
    """Draw the material of a worktop: glued wood, laminate or stone."""
    return ag.shades(*_TOPS, weights=_TOP_WEIGHTS, color=0.05, roughness=0.03, doc="material of the worktop")


def hardware() -> Any:
    """Draw the metal of handles."""
    return ag.shades(
        *HARDWARE, weights=tuple(HARDWARE.values()), color=0.03, roughness=0.03, doc="metal of handles"
    )


def leg_finishes() -> Any:
    """Draw the material of legs by the parameter `leg`: wood, or the metal of a tube."""
    metals = ("powder_coat_black", "satin_brass", "stainless")
    return ag.by(
        "leg",
        metal=ag.shades(*metals, weights=(3.0, 1.0, 1.0), color=0.03),
        otherwise=ag.shades(
            *WOODS[:4], *known("powder_coat_black"), weights=(2.0, 1.0, 2.0, 1.0, 1.0), color=0.05
        ),
        doc="material of legs",
    )
