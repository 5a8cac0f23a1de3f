"""Materials and colors of lamps."""

import artgen as ag
from artgen.categories.shared.finish import casting, known, weighing

_COATS = {
    "black": 3.0,
    "white": 2.6,
    "graphite": 1.6,
    "cream": 0.8,
    "red": 1.0,
    "teal": 0.8,
    "mustard": 0.8,
    "sage": 0.9,
    "navy": 0.8,
    "sky": 0.6,
    "orange": 0.6,
    "blush": 0.5,
    "light_grey": 0.9,
}
_METALS = {"chrome": 1.2, "satin_nickel": 1.2, "satin_brass": 1.2, "copper": 0.5}

COATS = (*(ag.colored("powder_coat", color) for color in _COATS), *known(*_METALS))
"""Finishes of lamps with arms: powder coats and metals."""

COAT_WEIGHTS = (*_COATS.values(), *_METALS.values())
"""Weights of `COATS` in a random choice."""

_FITTINGS = {
    "satin_brass": 2.0,
    "brass": 1.2,
    "satin_nickel": 1.6,
    "chrome": 1.0,
    "powder_coat_black": 2.0,
    "aged_bronze": 1.4,
    "copper": 0.5,
}

FITTINGS = known(*_FITTINGS)
"""Metals of poles, necks and harps."""

FITTING_WEIGHTS = tuple(_FITTINGS[each.name] for each in FITTINGS)
"""Weights of `FITTINGS` in a random choice."""

_CLOTHS = {
    "white": 2.5,
    "ivory": 2.0,
    "sand": 1.2,
    "taupe": 0.7,
    "light_grey": 1.0,
    "black": 0.9,
    "navy": 0.8,
    "sage": 0.8,
    "blush": 0.6,
    "mustard": 0.6,
    "burgundy": 0.4,
    "teal": 0.5,
}

CLOTHS = (*(ag.colored("fabric", color) for color in _CLOTHS), ag.material("linen"), ag.material("wicker"))
"""Materials of cloth shades."""

CLOTH_WEIGHTS = (*_CLOTHS.values(), 2.5, 0.8)
"""Weights of `CLOTHS` in a random choice."""

_GLAZES = (
    "white",
    "cream",
    "sage",
    "teal",
    "navy",
    "blue",
    "black",
    "mint",
    "coral",
    "blush",
    "mustard",
    "taupe",
)

BODIES = (
    *weighing([ag.colored("ceramic", color) for color in _GLAZES], 430.0, "thrown"),  # walls of 7 mm
    *weighing(known("oak", "walnut", "beech", "mahogany"), 420.0, "turned"),
    *weighing(known("glass", "amber_glass", "tinted_glass"), 450.0, "blown"),
    *weighing(known("marble", "green_marble"), 800.0, "bored"),
    *weighing(known("brass", "satin_nickel", "aged_bronze", "hammered_bronze"), 450.0, "spun_sheet"),
)
"""Materials of the bodies of table lamps, with the density of the hollow body."""

BODY_WEIGHTS = (*(0.9,) * len(_GLAZES), *(1.0,) * 4, *(0.9,) * 3, *(0.8,) * 2, *(0.8,) * 4)
"""Weights of `BODIES` in a random choice."""

LEGS = (
    *known("oak", "walnut", "beech", "ash", "mahogany"),
    *weighing(known("powder_coat_black"), 2200.0, "drawn"),  # tubes
)
"""Materials of the legs of tripods."""

STONES = known("marble", "green_marble", "black_granite", "granite")
"""Materials of the stones under arc lamps."""

OPAL = ag.material("frosted_glass").with_(
    name="opal_glass",
    base_color=(0.93, 0.91, 0.86),
    opacity=1.0,
    transmission_weight=0.0,
    specular_roughness=0.12,
    texture="",
    emission=(0.10, 0.09, 0.075),
)
"""Opal glass for globes."""


def plastic(color: str) -> tuple[ag.Material, ag.Material]:
    """Return the plastic of switches and cords, and the print on it: white on black, or gray on white."""
    if color == "black":
        return ag.material("black_abs"), ag.material("powder_coat_white")
    return ag.material("glossy_plastic_white"), ag.colored("abs", "graphite")


def hollow(finish: ag.Material) -> ag.Material:
    """Return the material of a tube; a wall of 1.5 mm at a radius of 10 mm is 28 % of the solid."""
    return casting(finish, 0.28)


def spun(finish: ag.Material) -> ag.Material:
    """Return a finish on spun aluminum, the material of light metal shades."""
    return finish.with_(name=f"{finish.name}_spun", density=2700.0)


def weighted(finish: ag.Material, density: float = 4600.0) -> ag.Material:
    """Return the material of a base: a pressed cover over cast iron or cement."""
    return finish.with_(name=f"{finish.name}_{density:.0f}", density=density)
