"""Materials of pepper mills with their weights in a random choice, and print on mills."""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.pepper_grinder.forms import BodyForm, body_runs
from artgen.categories.shared.finish import colored_weights
from artgen.categories.shared.vessels import path_of

Mark = Literal["none", "letter", "word"]
"""Mark of the contents of a mill: none, a letter on its head, or a word around its body."""

Weights = dict[ag.Material | str, float]

_CHERRY = ag.material("maple").with_(name="cherry", base_color=(0.40, 0.17, 0.075), density=630.0)
_EBONY = ag.material("walnut").with_(name="ebonised_beech", base_color=(0.034, 0.026, 0.021), density=720.0)
_OLIVE = ag.material("ash_flat_sawn").with_(name="olive_wood", base_color=(0.46, 0.28, 0.11), density=920.0)
WOODS: Weights = {"beech": 1.8, "walnut": 2.2, "oak": 1.2, "mahogany": 1.4, _CHERRY: 0.8, "maple": 0.9,
                  _EBONY: 1.4, _OLIVE: 1.0}  # fmt: skip

_COLORS = {"black": 2.6, "white": 2.2, "red": 1.5, "burgundy": 0.7, "graphite": 1.0, "navy": 0.8,
           "sage": 0.7, "mustard": 0.6, "cream": 0.7, "teal": 0.6, "orange": 0.5}  # fmt: skip
LACQUERS: Weights = {  # on beech
    each.with_(name=f"beech_{each.name}", density=690.0): weight
    for each, weight in colored_weights("lacquered_mdf", _COLORS).items()
}

_SHELLS = {"stainless": 3.0, "brushed_aluminium": 1.0, "copper": 0.7, "satin_brass": 0.5,
           "powder_coat_black": 1.0, "powder_coat_graphite": 0.6}  # fmt: skip
STEELS: Weights = {  # drawn shells of 0.7 mm; their density includes the mass of the liner
    ag.material(name).with_(name=f"drawn_{name}", density=760.0): weight for name, weight in _SHELLS.items()
}

_PLASTIC = ag.material("polycarbonate")
CLEAR: Weights = {
    _PLASTIC.with_(name="acrylic", base_color=(0.93, 0.95, 0.95), opacity=0.22): 0.8,
    _PLASTIC.with_(name="smoked_acrylic", base_color=(0.30, 0.30, 0.31), opacity=0.45): 0.2,
}

_METALS = {"stainless": 3.0, "chrome": 1.6, "satin_brass": 1.4, "copper": 0.4, "black_steel": 0.6}
METALS = {ag.material(name): weight for name, weight in _METALS.items()}

_LIGHT = 0.22  # mean color value above which dark print has more contrast
# places: run of the body and height over the radius for the maker, run and share of the height for the word
_PRINTS: dict[BodyForm, tuple[tuple[int, float], tuple[int, float]]] = {
    "classic": ((0, 0.15), (2, 0.40)),
    "baluster": ((0, 0.15), (2, 0.34)),
    "hourglass": ((1, 0.20), (1, 0.66)),
    "tower": ((0, 0.11), (2, 0.55)),
    "cone": ((1, 0.20), (1, 0.55)),
    "barrel": ((1, 0.30), (1, 0.50)),
    "spool": ((0, 0.15), (4, 0.72)),
    "ripple": ((0, 0.10), (2, 0.375)),
    "cylinder": ((1, 0.24), (3, 0.62)),
}


def maker_mark(maker: str, style: BodyForm, space: ag.Region, finish: ag.Material) -> ag.Body:
    """Print the maker's name around the foot of a body."""
    (run, level), _ = _PRINTS[style]
    mark = details.lettering((maker.upper(),), 0.072 * space.x.high, tracking=0.35, fineness="coarse")
    path = path_of(body_runs(style, space)[run])
    return details.wrapped(mark, path, level * space.x.high, material=_ink_on(finish))


def word_mark(word: str, style: BodyForm, space: ag.Region, finish: ag.Material) -> ag.Body:
    """Print the contents of a mill around its body, or around its clear tube."""
    _, (run, share) = _PRINTS[style]
    mark = details.lettering((word.upper(),), 0.15 * space.x.high, tracking=0.3)
    path = path_of(body_runs(style, space)[run])
    return details.wrapped(mark, path, share * space.z.high, material=_ink_on(finish), proud=0.0003)


def letter_mark(word: str, radius: ag.Scalar, top: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Print the first letter of the contents on the flat head of a mill, in front of the nut."""
    letter = ag.text(word[0].upper(), 0.24 * radius)
    return details.printed(letter, (0, -0.56 * radius, top), material=_ink_on(finish), facing=ag.Z, up=ag.Y)


def _ink_on(finish: ag.Material) -> ag.Material:
    """Return the material of print on a finish: burnt into light wood, light on dark materials."""
    mean = sum(finish.base_color) / 3
    return ag.colored("abs", "anthracite" if mean > _LIGHT else "silver")
