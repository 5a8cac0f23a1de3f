"""What is printed on soap dispensers: a word, a sign, or a label with maker, content and volume."""

import math
from typing import Literal, get_args

import artgen as ag
from artgen import details
from artgen.categories.shared.vessels.turned import path_of
from artgen.categories.soap_dispenser.bottles import Shape, Sizes, blown_path, bottle_runs

Content = Literal["soap", "hand_wash", "lotion", "dish_soap"]
"""What is in a dispenser."""

Print = Literal["none", "word", "icon", "label"]
"""What a bottle shows."""

WORDS: dict[Content, tuple[str, ...]] = {
    "soap": ("SOAP",),
    "hand_wash": ("HAND", "WASH"),
    "lotion": ("LOTION",),
    "dish_soap": ("DISH", "SOAP"),
}
"""How it is said."""

_ICONS: dict[Content, str] = {"soap": "drop", "hand_wash": "drop", "lotion": "leaf", "dish_soap": "dish"}
_RUN = {"round": 1, "amphora": 1, "cone": 1, "bell": 1, "apothecary": 1}  # of the outline, with the print
_LEVEL = {"apothecary": 0.33, "amphora": 0.60, "bell": 0.40}  # over the height; others in the middle
PRINTED: tuple[Shape, ...] = tuple(shape for shape in get_args(Shape) if shape not in ("ribbed", "beehive"))
"""Bottles that can be printed: not those with ribs."""

LABELLED: tuple[Shape, ...] = ("round", "square", "cube", "apothecary")
"""Bottles on which a label lies flat or around a straight wall."""


def _printed(
    profile: ag.Profile,
    shape: Shape,
    sizes: Sizes,
    ink: ag.Material,
    *,
    clear: bool,
    rise: ag.Scalar = 0.0,
    proud: float = 0.0003,
) -> ag.Body:
    """Print a profile on the front of a bottle."""
    level = _LEVEL.get(shape, 0.45) * sizes.height + rise
    half = sizes.width / 2.0
    if shape in _RUN:
        path = blown_path(shape, sizes) if clear else path_of(bottle_runs(shape, sizes)[_RUN[shape]])
        return details.wrapped(profile, path, level, material=ink, proud=proud)
    deep = half * sizes.depth
    if shape == "oval":  # as round as an ellipse is in front
        round_ = half * half / deep
        path = ag.line((round_, 0.0, 0.0), (round_, 0.0, sizes.height))
        film = details.wrap(profile, path, level, proud=proud).at(0.0, round_ - deep, 0.0)
        return ag.detail(film, "print", ink, reads=(1.0, 0.0, 0.0))
    front = half * math.cos(math.pi / 6.0) if shape == "hexagonal" else deep
    return details.printed(profile, (0.0, -front, level), material=ink, proud=proud)


def marks(
    kind: Print, content: Content, maker: str, *, shape: Shape, sizes: Sizes, ink: ag.Material, clear: bool
) -> list[ag.Body]:
    """Print a bottle."""
    words = WORDS[content]
    match kind:
        case "word":
            size = 0.0080 if max(map(len, words)) < 5 else 0.0066
            profile = details.lettering(words, size, tracking=0.25, leading=1.9)
            return [_printed(profile, shape, sizes, ink, clear=clear)]
        case "icon":
            small = details.lettering((" ".join(words),), 0.0032, tracking=0.3, fineness="coarse")
            return [
                _printed(details.icon(_ICONS[content], 0.018), shape, sizes, ink, clear=clear),
                _printed(small, shape, sizes, ink, clear=clear, rise=-0.0165),
            ]
        case "label":
            dark = ag.colored("abs", "anthracite")
            wide, high = 0.036, 0.044
            texts = (
                (details.logo(maker, 0.0026, tracking=0.2), 0.0155),
                (details.lettering(words, 0.0052, tracking=0.25, leading=1.8), 0.0030),
                (ag.rectangle(0.020, 0.0004), -0.0080),
                (details.lettering(("300 ML  10 FL OZ",), 0.0020, tracking=0.2, fineness="coarse"), -0.0150),
            )
            return [
                _paper(shape, sizes, wide, high),
                *(
                    _printed(profile, shape, sizes, dark, clear=clear, rise=rise, proud=0.0006)
                    for profile, rise in texts
                ),
            ]
        case _:
            return []


def _paper(shape: Shape, sizes: Sizes, wide: float, high: float) -> ag.Body:
    """Make the paper of a label, around a straight wall or on a flat one."""
    paper = ag.material("cardboard").with_(name="label_paper", base_color=(0.80, 0.78, 0.72), texture="")
    level, half = _LEVEL.get(shape, 0.45) * sizes.height, sizes.width / 2.0
    if shape in _RUN:
        angle = wide / half
        sheet = ag.revolve(ag.rectangle(0.0006, high).at(half, level), angle=angle)
        return ag.detail(sheet.rotate(ag.Z, -0.5 * (math.pi + angle)), "label", paper)
    front = half * sizes.depth
    sheet = ag.box_between(
        (-0.5 * wide, -front - 0.0003, level - 0.5 * high), (0.5 * wide, -front + 0.0003, level + 0.5 * high)
    )
    return ag.detail(sheet, "label", paper)
