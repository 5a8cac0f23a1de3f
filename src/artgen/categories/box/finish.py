"""Materials of boxes: liners, printed boards, wrapping papers, ribbons, tape and inks."""

import artgen as ag
from artgen.materials import COLORS

_KRAFT, _PLASTIC = ag.material("cardboard"), ag.material("abs")
_GREYBOARD = 620.0  # density of the solid board of set-up boxes with its wrap [kg/m3]


def _liner(name: str, color: tuple[float, float, float], roughness: float = 0.7) -> ag.Material:
    return _KRAFT.with_(name=name, base_color=color, specular_roughness=roughness)


def _wrap(name: str, color: str, *, texture: str = "", rough: float = 0.5) -> ag.Material:
    look = _PLASTIC.with_(name=f"cardboard_{name}_{color}", base_color=COLORS[color], texture=texture)
    return look.with_(specular_roughness=rough, density=_GREYBOARD, friction=0.4)


KRAFT = (_KRAFT, _liner("light_kraft", (0.56, 0.41, 0.25)), _liner("dark_kraft", (0.36, 0.235, 0.125)))
"""Brown liners."""

WHITE = _liner("white_liner", (0.76, 0.745, 0.71))
"""Bleached white liner."""

_PRINTED = "black navy teal forest sage blush coral mustard lavender sky burgundy"
PRINTS = tuple(_liner(f"printed_{color}", COLORS[color], 0.5) for color in _PRINTED.split())
"""Fully printed boards of mailers and shoe boxes."""

COLORFUL = (0.8,) * len(PRINTS)
"""Weights of `PRINTS` in a random choice."""

_ROUGHNESS = {"black": 0.35, "white": 0.4, "red": 0.38}
_LINEN = ("ivory", "navy", "forest", "sage", "taupe")  # wraps with a linen texture
_WRAPS = "black white ivory navy burgundy red forest blush sage sky lavender taupe mint"
WRAPS = tuple(
    _wrap("wrap", color, texture="linen" if color in _LINEN else "", rough=_ROUGHNESS.get(color, 0.5))
    for color in _WRAPS.split()
)
"""Wrapping papers of set-up boxes."""

_GREY = _wrap("lining", "light_grey").with_(name="cardboard_lining_grey")
LININGS = (*(_wrap("lining", color) for color in ("white", "black", "cream")), _GREY)
"""Linings of set-up boxes."""

_SATIN = _PLASTIC.with_(texture="", density=400.0)
_SATINS = tuple(
    _SATIN.with_(name=f"satin_{color}", base_color=COLORS[color], specular_roughness=0.3, coat_weight=0.25)
    for color in ("red", "white", "navy", "burgundy", "forest", "blush", "black")
)
_GOLD = {"base_color": (0.58, 0.38, 0.13), "specular_roughness": 0.28, "base_metalness": 0.35}
RIBBONS = (*_SATINS, _SATIN.with_(name="satin_gold", **_GOLD))
"""Satin ribbons."""

STRAPS = (
    ag.material("linen").with_(name="webbing", base_color=(0.50, 0.42, 0.31)),
    ag.material("linen").with_(name="dark_webbing", base_color=(0.05, 0.05, 0.055)),
    ag.material("leather_grain_abs").with_(name="leather", base_color=(0.20, 0.085, 0.035), density=900.0),
)
"""Webbing and leather of straps."""

GOLD = ag.material("satin_brass").with_(name="gold_foil", specular_roughness=0.25)
"""Gold hot-stamping foil."""

TAPE = ag.material("polypropylene").with_(
    name="packing_tape", base_color=(0.34, 0.19, 0.075), specular_roughness=0.22, coat_weight=0.4
)
"""Brown packing tape."""

PAPER = ag.colored("abs", "white").with_(
    name="label_paper", texture="", specular_roughness=0.6, density=800.0
)
"""Paper of stickers."""

LABEL_INK = ag.colored("abs", "graphite").with_(name="label_ink", texture="")
"""Ink on stickers."""

SHADE = ag.material("cardboard_edge").with_(name="seam_shade", base_color=(0.06, 0.04, 0.025), texture="")
"""The dark line between two sheets."""


def ink(name: str) -> ag.Material:
    """Return a printing ink in a named color."""
    return ag.colored("abs", name).with_(name=f"ink_{name}", texture="", specular_roughness=0.6)


def foam(lining: ag.Material) -> ag.Material:
    """Return the foam of inserts in the color of a lining."""
    return ag.material("foam").with_(name="insert_foam", base_color=lining.base_color)
