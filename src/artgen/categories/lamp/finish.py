"""Materials and colors of lamps."""

import artgen as ag
from artgen.categories.shared.finish import casting, colored_weights, known, weighing

_COATS = {"black": 3.0, "white": 2.6, "graphite": 1.6, "cream": 0.8, "red": 1.0, "teal": 0.8, "mustard": 0.8,
          "sage": 0.9, "navy": 0.8, "sky": 0.6, "orange": 0.6, "blush": 0.5, "light_grey": 0.9}  # fmt: skip
_METALS = {"chrome": 1.2, "satin_nickel": 1.2, "satin_brass": 1.2, "copper": 0.5}
COATS = ag.shades({**colored_weights("powder_coat", _COATS), **_METALS}, color=0.05)

_FITTINGS = {"satin_brass": 2.0, "brass": 1.2, "satin_nickel": 1.6, "chrome": 1.0, "powder_coat_black": 2.0,
             "aged_bronze": 1.4, "copper": 0.5}  # fmt: skip
FITTINGS = ag.shades(_FITTINGS, color=0.03)

_CLOTHS = {"white": 2.5, "ivory": 2.0, "sand": 1.2, "taupe": 0.7, "light_grey": 1.0, "black": 0.9,
           "navy": 0.8, "sage": 0.8, "blush": 0.6, "mustard": 0.6, "burgundy": 0.4, "teal": 0.5}  # fmt: skip
CLOTHS = ag.shades({**colored_weights("fabric", _CLOTHS), "linen": 2.5, "wicker": 0.8}, color=0.06)

CLOTH_LININGS = ag.shades("fabric", color=0.02)
LININGS = ag.shades("enamel_white", "satin_brass", weights=(0.85, 0.15), color=0.02)

_GLAZES = ("white", "cream", "sage", "teal", "navy", "blue", "black", "mint", "coral", "blush", "mustard",
           "taupe")  # fmt: skip
# materials of the bodies of table lamps: weight of each, density of the hollow body [kg/m3], prefix
_BODIES = (
    (0.9, 430.0, "thrown", [ag.colored("ceramic", color) for color in _GLAZES]),  # walls of 7 mm
    (1.0, 420.0, "turned", known("oak", "walnut", "beech", "mahogany")),
    (0.9, 450.0, "blown", known("glass", "amber_glass", "tinted_glass")),
    (0.8, 800.0, "bored", known("marble", "green_marble")),
    (0.8, 450.0, "spun_sheet", known("brass", "satin_nickel", "aged_bronze", "hammered_bronze")),
)
BODIES = ag.shades(
    {each: weight for weight, density, prefix, group in _BODIES for each in weighing(group, density, prefix)},
    color=0.06,
)
LEGS = ag.shades(
    *known("oak", "walnut", "beech", "ash", "mahogany"),
    *weighing(known("powder_coat_black"), 2200.0, "drawn"),  # tubes
    color=0.06,
)
STONES = ag.shades("marble", "green_marble", "black_granite", "granite", color=0.05)

GLOBE = ag.material("frosted_glass").with_(
    name="opal_glass_globe",
    base_color=(0.93, 0.91, 0.86),
    opacity=1.0,
    transmission_weight=0.0,
    specular_roughness=0.12,
    texture="",
    emission=(0.10, 0.09, 0.075),
    density=230.0,  # 3 mm of glass of 2500 kg/m3 at a radius of 0.1 m
)


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
