"""Materials and marks of pepper mills."""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.pepper_grinder.forms import BodyForm, body_runs
from artgen.categories.shared.finish import known, weighing
from artgen.categories.shared.vessels import path_of

Mark = Literal["none", "letter", "word"]
"""Mark of the contents of a mill: none, a letter on its head, or a word around its body."""

_LIGHT = 0.22  # mean color value above which dark print has more contrast
_FOOT = {  # position of the maker's name: run of the body and height, over the radius
    "classic": (0, 0.15),
    "baluster": (0, 0.15),
    "hourglass": (1, 0.20),
    "tower": (0, 0.11),
    "cone": (1, 0.20),
    "barrel": (1, 0.30),
    "spool": (0, 0.15),
    "ripple": (0, 0.10),
    "cylinder": (1, 0.24),
}
_WORD = {  # position of the word: run of the body and share of the height
    "classic": (2, 0.40),
    "baluster": (2, 0.34),
    "hourglass": (1, 0.66),
    "tower": (2, 0.55),
    "cone": (1, 0.55),
    "barrel": (1, 0.50),
    "spool": (4, 0.72),
    "ripple": (2, 0.375),
    "cylinder": (3, 0.62),
}


def ink_on(finish: ag.Material) -> ag.Material:
    """Return the material of print on a finish: burnt into light wood, light on dark materials."""
    mean = sum(finish.base_color) / 3.0
    return ag.colored("abs", "anthracite" if mean > _LIGHT else "silver")


def maker_mark(
    maker: str, form: BodyForm, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material
) -> ag.Body:
    """Print the maker's name around the foot."""
    run, level = _FOOT[form]
    path = path_of(body_runs(form, radius, 0.0, height)[run])
    mark = details.lettering((maker.upper(),), 0.072 * radius, tracking=0.35, fineness="coarse")
    return details.wrapped(mark, path, level * radius, material=ink_on(finish))


def word_mark(
    word: str, form: BodyForm, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material
) -> ag.Body:
    """Print the contents of a mill around its body, or around its clear tube."""
    run, share = _WORD[form]
    path = path_of(body_runs(form, radius, 0.0, height)[run])
    mark = details.lettering((word.upper(),), 0.15 * radius, tracking=0.3)
    return details.wrapped(mark, path, share * height, material=ink_on(finish), proud=0.0003)


def letter_mark(word: str, radius: ag.Scalar, top: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Print the first letter of the contents on the flat head of a mill, in front of the nut."""
    letter = ag.text(word[0].upper(), 0.24 * radius)
    at = (0.0, -0.56 * radius, top)
    return details.printed(letter, at, material=ink_on(finish), facing=ag.Z, up=(0.0, 1.0, 0.0))


_EBONY = ag.material("walnut").with_(name="ebonised_beech", base_color=(0.034, 0.026, 0.021), density=720.0)
_OLIVE = ag.material("ash_flat_sawn").with_(name="olive_wood", base_color=(0.46, 0.28, 0.11), density=920.0)

_CHERRY = ag.material("maple").with_(name="cherry", base_color=(0.40, 0.17, 0.075), density=630.0)

WOODS = (*known("beech", "walnut", "oak", "mahogany"), _CHERRY, *known("maple"), _EBONY, _OLIVE)
"""Woods of turned mills."""

WOOD_WEIGHTS = (1.8, 2.2, 1.2, 1.4, 0.8, 0.9, 1.4, 1.0)
"""Weights of `WOODS` in a random choice."""

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

LACQUERS = weighing([ag.colored("lacquered_mdf", color) for color in _COLORS], 690.0, "beech")
"""Lacquers on beech."""

LACQUER_WEIGHTS = tuple(_COLORS.values())
"""Weights of `LACQUERS` in a random choice."""

STEELS = (
    *weighing(known("stainless", "brushed_aluminium", "copper", "satin_brass"), 760.0, "drawn"),
    *weighing(known("powder_coat_black", "powder_coat_graphite"), 760.0, "drawn"),
)
"""Drawn shells of 0.7 mm around a liner; the density of the shell includes the mass of the liner."""

STEEL_WEIGHTS = (3.0, 1.0, 0.7, 0.5, 1.0, 0.6)
"""Weights of `STEELS` in a random choice."""

CLEAR = (
    ag.material("polycarbonate").with_(name="acrylic", base_color=(0.93, 0.95, 0.95), opacity=0.22),
    ag.material("polycarbonate").with_(name="smoked_acrylic", base_color=(0.30, 0.30, 0.31), opacity=0.45),
)
"""Clear plastics."""

METALS = known("stainless", "chrome", "satin_brass", "copper", "black_steel")
"""Metals of nuts, rings and cranks."""

METAL_WEIGHTS = (3.0, 1.6, 1.4, 0.4, 0.6)
"""Weights of `METALS` in a random choice."""
