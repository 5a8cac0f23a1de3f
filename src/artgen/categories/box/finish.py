"""Materials of boxes: kraft and white liners, prints in color, wrapping papers, ribbons and inks."""

import artgen as ag
from artgen.materials import COLORS

_KRAFT = ag.material("cardboard")
_GREYBOARD = 620.0  # density of the solid board of set-up boxes with its wrap [kg/m3]


def _liner(name: str, color: tuple[float, float, float], roughness: float = 0.7) -> ag.Material:
    return _KRAFT.with_(name=name, base_color=color, specular_roughness=roughness)


def _printed(color: str) -> ag.Material:
    return _liner(f"printed_{color}", COLORS[color], 0.5)


def _wrap(name: str, color: tuple[float, float, float], texture: str = "", rough: float = 0.5) -> ag.Material:
    return ag.material("abs").with_(
        name=f"cardboard_{name}",
        base_color=color,
        specular_roughness=rough,
        texture=texture,
        density=_GREYBOARD,
        friction=0.4,
    )


KRAFT = (_KRAFT, _liner("light_kraft", (0.56, 0.41, 0.25)), _liner("dark_kraft", (0.36, 0.235, 0.125)))
"""Brown liners."""

WHITE = _liner("white_liner", (0.76, 0.745, 0.71))
"""Bleached white liner."""

PRINTS = tuple(
    map(
        _printed,
        (
            "black",
            "navy",
            "teal",
            "forest",
            "sage",
            "blush",
            "coral",
            "mustard",
            "lavender",
            "sky",
            "burgundy",
        ),
    )
)
"""Fully printed boards of mailers and shoe boxes."""

COLORFUL = (0.8,) * len(PRINTS)
"""Weights of `PRINTS` in a random choice."""

WRAPS = (
    _wrap("wrap_black", COLORS["black"], rough=0.35),
    _wrap("wrap_white", COLORS["white"], rough=0.4),
    _wrap("wrap_ivory", COLORS["ivory"], "linen"),
    _wrap("wrap_navy", COLORS["navy"], "linen"),
    _wrap("wrap_burgundy", COLORS["burgundy"]),
    _wrap("wrap_red", COLORS["red"], rough=0.38),
    _wrap("wrap_forest", COLORS["forest"], "linen"),
    _wrap("wrap_blush", COLORS["blush"]),
    _wrap("wrap_sage", COLORS["sage"], "linen"),
    _wrap("wrap_sky", COLORS["sky"]),
    _wrap("wrap_lavender", COLORS["lavender"]),
    _wrap("wrap_taupe", COLORS["taupe"], "linen"),
    _wrap("wrap_mint", COLORS["mint"]),
)
"""Wrapping papers of set-up boxes."""

LININGS = (
    _wrap("lining_white", COLORS["white"]),
    _wrap("lining_black", COLORS["black"]),
    _wrap("lining_cream", COLORS["cream"]),
    _wrap("lining_grey", COLORS["light_grey"]),
)
"""Linings of set-up boxes."""


def _satin(color: str) -> ag.Material:
    return ag.material("abs").with_(
        name=f"satin_{color}",
        base_color=COLORS[color],
        specular_roughness=0.3,
        texture="",
        coat_weight=0.25,
        density=400.0,
    )


RIBBONS = (
    *map(_satin, ("red", "white", "navy", "burgundy", "forest", "blush", "black")),
    ag.material("abs").with_(
        name="satin_gold",
        base_color=(0.58, 0.38, 0.13),
        specular_roughness=0.28,
        texture="",
        base_metalness=0.35,
        density=400.0,
    ),
)
"""Satin ribbons."""

STRAPS = (
    ag.material("linen").with_(name="webbing", base_color=(0.50, 0.42, 0.31)),
    ag.material("linen").with_(name="dark_webbing", base_color=(0.05, 0.05, 0.055)),
    ag.material("leather_grain_abs").with_(name="leather", base_color=(0.20, 0.085, 0.035), density=900.0),
)
"""Webbing and leather of straps."""

GOLD = ag.material("satin_brass").with_(name="gold_foil", specular_roughness=0.25)
"""Gold hot-stamping foil."""


def ink(name: str) -> ag.Material:
    """Return a printing ink in a named color."""
    return ag.colored("abs", name).with_(name=f"ink_{name}", texture="", specular_roughness=0.6)


def contrast(finish: ag.Material) -> ag.Material:
    """Return the ink or foil with good contrast on a finish."""
    mean = sum(finish.base_color) / 3.0
    return ink("graphite") if mean > 0.2 else ink("white")


def foam(lining: ag.Material) -> ag.Material:
    """Return the foam of inserts in the color of a lining."""
    return ag.material("foam").with_(name="insert_foam", base_color=lining.base_color)
