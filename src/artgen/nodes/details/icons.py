"""Icons for buttons, knobs and lamps, all drawn with the same line weight."""

from typing import Literal

import numpy as np

from artgen._arrays import cached
from artgen.asset.shape import Outline
from artgen.errors import BuildError, nearest
from artgen.graph import kernel
from artgen.graph.node import authors_line
from artgen.nodes import validators as inputs
from artgen.nodes.contours import moved_outline
from artgen.nodes.details.ink import drawing
from artgen.nodes.details.pen import (
    SQUARE,
    Mark,
    arc,
    circle,
    disc,
    fill,
    flipped,
    gap,
    mirrored,
    placed,
    stroke,
    turned,
)
from artgen.nodes.handles import Profile, Scalar

_ARROW = stroke("M0,-8.6 V8.6 M-5.8,2.8 L0,8.6 L5.8,2.8")
_CHEVRON = stroke("M-8,-4 L0,4 L8,-4")
_BODY = fill("M-7,1 A-1.4 -5.6,2.2 H5.6 A-1.4 7,0.8 V-8 A-1.4 5.6,-9.4 H-5.6 A-1.4 -7,-8 Z")
_SHACKLE = stroke("M-4.2,1.5 V4.6 A-4.2 0,8.8 A-4.2 4.2,4.6 V1.5")
_OPENED = stroke("M-4.2,1.5 V5.4 A-4.2 0,9.4 A-4.2 4.2,5.4 V4.8")
_KEYHOLE = (*circle(0, -2.6, 1.5, "cut"), *gap("M0,-2.6 V-6", 0.8))
_FACE = (
    *mirrored(circle(2.4, -1.6, 1.0, "cut")),
    *gap("M-3.6,-4.8 A4.4 3.6,-4.8", 0.75),
)
_FLAKE = turned(6, stroke("M0,0 V9.2 M-2.7,8.4 L0,5.7 L2.7,8.4"))
_DROP = stroke(
    "M0,9.4 C-2.2,5.6 -6.4,1.4 -6.4,-3 C-6.4,-6.8 -3.6,-9.2 0,-9.2 C3.6,-9.2 6.4,-6.8 6.4,-3 "
    "C6.4,1.4 2.2,5.6 0,9.4 Z"
)
_BLADE = fill("M-0.7,1.9 C-3.2,4.2 -3.4,9.4 1.8,9.4 C6,9.4 7,6.2 5.2,4.6 C4,3.6 2.5,3.4 1.5,1.4 Z")
FAN = (*turned(3, _BLADE), *circle(0, 0, 2.5, "cut"), *disc(0, 0, 1.6))
WAVE = stroke("M0,-9 C-3.8,-5.6 -3.8,-3.4 0,0 C3.8,3.4 3.8,5.6 0,9")
_BULB = (
    *arc(0, 3, 6.2, -56, 292),
    *stroke("M3.47,-2.14 C2.9,-3 2.8,-3.6 2.8,-4.8 H-2.8 C-2.8,-3.6 -2.9,-3 -3.47,-2.14"),
    *stroke("M-2.4,-7.1 H2.4 M-1,-9.3 H1"),
)
_SPEAKER = fill("M-9.4,3 H-5.6 L-0.6,7.6 V-7.6 L-5.6,-3 H-9.4 Z")

SIGNS: dict[str, tuple[Mark, ...]] = {
    # switching
    "power": (*arc(0, -0.8, 8.2, 122, 296), *stroke("M0,9.2 V0.6")),
    "plus": stroke("M-8,0 H8 M0,-8 V8"),
    "minus": stroke("M-8,0 H8"),
    "check": stroke("M-8.6,0.4 L-2.8,-5.8 L8.8,6.4"),
    "cross": stroke("M-7,-7 L7,7 M-7,7 L7,-7"),
    "play": (*fill("M-5.6,8.2 V-8.2 L8.4,0 Z"), *stroke("M-5.6,8.2 V-8.2 L8.4,0 Z", 0.7)),
    "pause": mirrored(fill("M2.2,8.6 V-8.6 H6.6 V8.6 Z")),
    "stop": (*fill("M-7,-7 H7 V7 H-7 Z"), *stroke("M-7,-7 H7 V7 H-7 Z", 0.7)),
    "start_pause": (
        *fill("M-9.2,7.6 V-7.6 L1.4,0 Z"),
        *fill("M3.4,7.6 V-7.6 H5.6 V7.6 Z M7.2,7.6 V-7.6 H9.4 V7.6 Z"),
    ),
    "eject": (*fill("M0,8.4 L-8.6,-2 H8.6 Z"), *fill("M-8.6,-5 H8.6 V-8.4 H-8.6 Z")),
    "menu": stroke("M-8.4,6 H8.4 M-8.4,0 H8.4 M-8.4,-6 H8.4"),
    "settings": (
        *turned(8, fill("M-2,5.4 L-1.4,9.4 H1.4 L2,5.4 Z")),
        *disc(0, 0, 7),
        *circle(0, 0, 3.2, "cut"),
    ),
    "dots": (*disc(-6.6, 0, 1.9), *disc(0, 0, 1.9), *disc(6.6, 0, 1.9)),
    # time and sound
    "clock": (*circle(0, 0, 9), *stroke("M0,5.4 V0 L3.9,-2.6")),
    "timer": (
        *circle(0, -1.5, 7.7),
        *stroke("M-2.6,9.4 H2.6 M0,9.4 V6.2 M0,-1.5 L3.2,1.7 M5.6,5 L7.2,6.6"),
    ),
    "delay": (*arc(0, 0, 8.8, 60, 300), *stroke("M0,5.2 V0 L3.8,-2.4 M4.4,8.9 V5.2 H8.4")),
    "hourglass": (
        *stroke("M-6,9.2 H6 M-6,-9.2 H6"),
        *mirrored(stroke("M4.6,9 V6.4 C4.6,3.4 1,2 1,0 C1,-2 4.6,-3.4 4.6,-6.4 V-9")),
    ),
    "bell": (
        *stroke(
            "M-7.8,-5.2 C-5.6,-3.4 -5.8,-0.6 -5.8,1.6 A-5.8 0,7.2 A-5.8 5.8,1.6 C5.8,-0.6 5.6,-3.4 7.8,-5.2 Z"
        ),
        *stroke("M0,7.2 V9.3"),
        *fill("M-2.5,-7.4 A2.5 2.5,-7.4 Z"),
    ),
    "sound": (*_SPEAKER, *arc(-0.6, 0, 4.2, -46, 92), *arc(-0.6, 0, 8.4, -46, 92)),
    "mute": (*_SPEAKER, *stroke("M3.4,-3 L9.2,3 M3.4,3 L9.2,-3")),
    # safety
    "lock": (*_BODY, *_SHACKLE, *_KEYHOLE),
    "unlock": (*_BODY, *_OPENED, *_KEYHOLE),
    "child_lock": (*_BODY, *_SHACKLE, *_FACE),
    "key": (*circle(-5.4, 0, 3.7), *stroke("M-1.7,0 H9.2 V-3.6 M5.2,0 V-2.8")),
    "warning": (*stroke("M0,8.2 L-9,-7.6 H9 Z"), *stroke("M0,3.2 V-1.6"), *disc(0, -4.7, 1.1)),
    "info": (*circle(0, 0, 9), *stroke("M0,0.9 V-4.8"), *disc(0, 4.5, 1.2)),
    "bolt": fill("M2.2,9.6 L-6.4,-1.4 H-0.8 L-2.4,-9.6 L6.4,1.8 H0.7 Z"),
    "plug": (
        *stroke("M-6.4,3.4 H6.4 V0.6 C6.4,-3 3.6,-5 0,-5 C-3.6,-5 -6.4,-3 -6.4,0.6 Z M0,-5 V-9.2"),
        *stroke("M-3,8.9 V3.4 M3,8.9 V3.4"),
    ),
    # directions
    "arrow_up": _ARROW,
    "arrow_left": turned(1, _ARROW, start=90),
    "arrow_down": flipped(_ARROW),
    "arrow_right": turned(1, _ARROW, start=-90),
    "chevron_up": _CHEVRON,
    "chevron_left": turned(1, _CHEVRON, start=90),
    "chevron_down": flipped(_CHEVRON),
    "chevron_right": turned(1, _CHEVRON, start=-90),
    "return": stroke("M-4.4,8.2 L-8.8,3.8 L-4.4,-0.6 M-8.8,3.8 H2.8 A-5.8 2.8,-7.8 H-5"),
    "repeat": (*arc(0, 0, 8, 68, 292), *stroke("M0.6,9.6 L2.9,7.4 L0.8,4.4")),
    # air, light, water, weather
    "fan": FAN,
    "light": _BULB,
    "light_on": (*placed(0.72, 0, -2.2, _BULB), *turned(5, stroke("M0,7.3 V8.8"), start=-72)),
    "sun": (*circle(0, 0, 4), *turned(8, stroke("M0,7.2 V9.1"))),
    "moon": (*disc(-0.6, 0, 9), *circle(3.9, 3.1, 7.7, "cut")),
    "snowflake": _FLAKE,
    "flame": stroke(
        "M0.6,9.2 C1,5.6 6.4,3.2 6.4,-2.6 C6.4,-6.6 3.6,-9.2 0,-9.2 C-3.6,-9.2 -6.4,-6.6 -6.4,-2.8 "
        "C-6.4,0 -5,1.8 -3.8,3.6 C-3.1,2.8 -2.5,2 -2.3,0.8 C-0.3,3 1,5.8 0.6,9.2 Z"
    ),
    "drop": (*_DROP, *arc(0, -3, 3.4, 185, 75)),
    "steam": (*placed(1, -6.2, 0, WAVE), *WAVE, *placed(1, 6.2, 0, WAVE)),
    "defrost": (*placed(0.66, -3.2, 3.2, _FLAKE), *placed(0.42, 6.2, -5.2, _DROP)),
    "thermometer": (
        *stroke("M-2.4,-2.7 V6.8 A-2.4 0,9.2 A-2.4 2.4,6.8 V-2.7"),
        *arc(0, -5.3, 3.55, 132.5, 275),
        *disc(0, -5.3, 1.7),
        *stroke("M0,-5.3 V3.4"),
    ),
    "wifi": (
        *disc(0, -6.6, 1.7),
        *arc(0, -7, 5.2, 46, 88),
        *arc(0, -7, 9.3, 46, 88),
        *arc(0, -7, 13.4, 46, 88),
    ),
    "leaf": stroke(
        "M-6.6,-6.4 C-9.4,2.6 -2.6,8.8 8.8,8.6 C9.2,-3.4 2.4,-9.6 -6.6,-6.4 Z M-9,-9 C-5.6,-4 -1.6,-0.4 3,2.4"
    ),
    "spin": stroke(
        "M0.2,-0.2 C0.9,1.5 -1.2,2.5 -2.3,1.1 C-3.8,-0.9 -2.4,-3.9 0.6,-4 C4.4,-4.1 6.1,-0.2 4.7,3 "
        "C2.9,6.8 -2.6,7.4 -5.7,4 C-9.2,0 -7.2,-6.6 -1.8,-8.4 C2.6,-9.7 7.2,-7.6 8.8,-3.6"
    ),
    "home": (
        *stroke("M-9.2,0.2 L0,8.8 L9.2,0.2"),
        *stroke("M-6.4,2.6 V-8.8 H6.4 V2.6"),
        *stroke("M0,-8.8 V-3.4"),
    ),
    "heart": stroke(
        "M0,-8.4 C-4,-5 -9,-1.4 -9,3.2 C-9,6.2 -6.8,8 -4.6,8 C-2.6,8 -1,7 0,5 C1,7 2.6,8 4.6,8 "
        "C6.8,8 9,6.2 9,3.2 C9,-1.4 4,-5 0,-8.4 Z"
    ),
    "star": stroke("M0,9 L2.6,3.2 L9,2.6 L4.2,-1.6 L5.6,-8 L0,-4.6 L-5.6,-8 L-4.2,-1.6 L-9,2.6 L-2.6,3.2 Z"),
}
"""General icons by name."""


_OVEN = stroke("M-9,-7.4 A1.6 -7.4,-9 H7.4 A1.6 9,-7.4 V7.4 A1.6 7.4,9 H-7.4 A1.6 -9,7.4 Z")
_TOP = stroke("M-5.2,5.4 H5.2")
_BOTTOM = stroke("M-5.2,-5.4 H5.2")
_GRILL = stroke("M-5.6,3 L-3.36,5.6 L-1.12,3 L1.12,5.6 L3.36,3 L5.6,5.6")
_FORK = stroke("M-9,8.8 V4.8 C-9,2 -5,2 -5,4.8 V8.8 M-7,2.7 V-8.8")
_KNIFE = (*fill("M7,9.4 C9.6,6.8 9.8,2.2 9.2,-1.2 H7 Z"), *stroke("M7,8.8 V-8.8"))
_TUB = stroke("M-9,6.4 L-7.2,-7.2 H7.2 L9,6.4")
_WATER = stroke("M-8.2,2.6 C-6.2,0.8 -4.2,0.8 -2.7,2.2 C-1.2,3.6 1.2,3.6 2.7,2.2 C4.2,0.8 6.2,0.8 8.2,2.6")
_CUBE = stroke("M-5,-5 H5 V5 H-5 Z")
_FLAT_WAVE = turned(1, WAVE, start=90)

KITCHEN: dict[str, tuple[Mark, ...]] = {
    # oven
    "oven": _OVEN,
    "heat_top": (*_OVEN, *_TOP),
    "heat_bottom": (*_OVEN, *_BOTTOM),
    "heat_both": (*_OVEN, *_TOP, *_BOTTOM),
    "grill": (*_OVEN, *_GRILL),
    "grill_fan": (*_OVEN, *placed(0.88, 0, 1, _GRILL), *placed(0.46, 0, -3.4, FAN)),
    "convection": (*_OVEN, *placed(0.6, 0, -0.4, FAN)),
    "hot_air": (*_OVEN, *circle(0, 0, 6), *placed(0.42, 0, -0.2, FAN)),
    "fan_heat": (
        *_OVEN,
        *placed(0.86, 0, 1.4, _TOP),
        *placed(0.86, 0, -1.4, _BOTTOM),
        *placed(0.38, 0, 0, FAN),
    ),
    "microwave": tuple(mark for y in (-6, 0, 6) for mark in placed(1, 0, y, _FLAT_WAVE)),
    "oven_light": (
        *_OVEN,
        *arc(0, 1.2, 3.6, -58, 296),
        *stroke("M-1.7,-4.6 H1.7"),
    ),
    "burner": (*circle(0, 0, 9), *circle(0, 0, 4.6), *disc(0, 0, 1.3)),
    # food
    "bread": stroke(
        "M-6.4,-7.6 A1.2 -5.2,-8.8 H5.2 A1.2 6.4,-7.6 V0.8 C9.8,2.6 9.6,8.6 4.6,8.6 H-4.6 "
        "C-9.6,8.6 -9.8,2.6 -6.4,0.8 Z"
    ),
    "bagel": (*circle(0, 0, 9), *circle(0, 0, 3)),
    "pizza": (
        *stroke("M-8.6,5.8 C-3.2,9.4 3.2,9.4 8.6,5.8 L0,-9.2 Z M-6.9,2.9 C-2.5,5.6 2.5,5.6 6.9,2.9"),
        *disc(-2, 0.7, 1.25),
        *disc(2.3, -0.3, 1.25),
        *disc(-0.1, -3.7, 1.25),
    ),
    "chicken": (
        *stroke("M-2.4,-1.8 C-3.4,3.6 -0.6,9 4.2,9 C8.4,9 9.8,5.2 9,2 C8,-1.6 3.6,-4.2 -0.4,-3.8 Z"),
        *stroke("M-1.6,-2.9 L-5.8,-7.1"),
        *disc(-7.3, -6.4, 1.7),
        *disc(-6.3, -8.1, 1.7),
    ),
    "fish": (
        *stroke("M-9.2,0 C-5.6,5.8 1.2,6 5,0.7 L9.2,4.4 V-4.4 L5,-0.7 C1.2,-6 -5.6,-5.8 -9.2,0 Z"),
        *disc(-4.8, 1.2, 1.2),
    ),
    "cake": (
        *stroke("M-7,0.6 H7 L5.2,-9 H-5.2 Z"),
        *stroke("M-7.6,0.8 C-9.6,5 -5.2,6.6 -4.4,5.6 C-3.6,9.8 3.6,9.8 4.4,5.6 C5.2,6.6 9.6,5 7.6,0.8"),
    ),
    "egg": stroke(
        "M0,9 C-3.8,9 -7,3.2 -7,-1.8 C-7,-6.2 -3.9,-9 0,-9 C3.9,-9 7,-6.2 7,-1.8 C7,3.2 3.8,9 0,9 Z"
    ),
    "carrot": (
        *stroke("M-9,-9 C-6.6,-1.6 -3.6,3.4 -0.6,4.6 C3,5.8 5.8,3 4.6,-0.6 C3.4,-3.6 -1.6,-6.6 -9,-9 Z"),
        *stroke("M3.8,3.8 L9,9 M3.8,3.8 L4.2,9.2 M3.8,3.8 L9.2,4.2"),
    ),
    "wheat": (
        *stroke("M0,-9.2 V8.8"),
        *mirrored(
            stroke("M0,3.4 C0.6,6.2 2.6,7.2 4.8,7.2 C4.8,5 3.2,3.4 0,3.4 Z"),
            stroke("M0,-1.4 C0.6,1.4 2.6,2.4 4.8,2.4 C4.8,0.2 3.2,-1.4 0,-1.4 Z"),
            stroke("M0,-6.2 C0.6,-3.4 2.6,-2.4 4.8,-2.4 C4.8,-4.6 3.2,-6.2 0,-6.2 Z"),
        ),
    ),
    # tableware
    "plate": (*_FORK, *circle(0.4, 0, 3.9), *placed(1, 0.4, 0, _KNIFE)),
    "cutlery": (*placed(1, 2.4, 0, _FORK), *placed(1, -2.4, 0, _KNIFE)),
    "glass": stroke("M-5,9 H5 C6.2,2 3.6,-1 0,-1 C-3.6,-1 -6.2,2 -5,9 Z M0,-1 V-9 M-4.2,-9 H4.2"),
    "tumbler": stroke("M-6.4,8.8 L-4.8,-8.8 H4.8 L6.4,8.8 M-6,4 H6"),
    "cup": (
        *stroke("M-8.4,3.4 H5 V-3.6 C5,-6.6 3.2,-8.2 0.6,-8.2 H-4 C-6.6,-8.2 -8.4,-6.6 -8.4,-3.6 Z"),
        *stroke("M5,2 C9.8,3 9.8,-4 4.8,-4.2"),
        *stroke("M-5,6.4 V9 M-1.7,6.4 V9 M1.6,6.4 V9"),
    ),
    "pot": (
        *stroke("M-6.6,2 V-6.4 C-6.6,-8 -5.8,-8.8 -4.4,-8.8 H4.4 C5.8,-8.8 6.6,-8 6.6,-6.4 V2 Z"),
        *stroke("M-9.2,0 H-6.6 M9.2,0 H6.6"),
        *stroke("M-6.2,4.8 C-4,6.6 4,6.6 6.2,4.8 M0,6.2 V8.6"),
    ),
    "bottle": stroke(
        "M-1.8,9 H1.8 V4.6 C1.8,2.4 4.6,2.4 4.6,-0.6 V-7.6 A-1.4 3.2,-9 H-3.2 A-1.4 -4.6,-7.6 V-0.6 "
        "C-4.6,2.4 -1.8,2.4 -1.8,4.6 Z M-4.6,-2 H4.6"
    ),
    # cold and water
    "ice": (
        *placed(0.72, -4.6, -4, turned(1, _CUBE, start=8)),
        *placed(0.72, 4.2, 3.4, turned(1, _CUBE, start=-16)),
    ),
    "dispenser": (
        *stroke("M-5.4,-0.6 L-4.2,-9 H4.2 L5.4,-0.6"),
        *stroke("M-7.6,9 H2 C4,9 4.6,8 4.6,6.4"),
        *fill("M0,5.6 C-0.9,4 -1.9,3 -1.9,1.6 A1.9 1.9,1.6 C1.9,3 0.9,4 0,5.6 Z"),
    ),
    "fridge": stroke("M-6,9 H6 V-9 H-6 Z M-6,2.6 H6 M-3,6.9 V4.9 M-3,0.4 V-3"),
    # washing
    "wash": (*_TUB, *_WATER),
    "rinse": (*_TUB, *stroke("M-3.4,8.4 V0.4 M0,9 V-2.6 M3.4,8.4 V0.4")),
    "drain": (*_TUB, *stroke("M0,8.4 V-2.6 M-3,0.4 L0,-2.6 L3,0.4")),
    "shirt": stroke("M-3.4,8.4 C-2,6 2,6 3.4,8.4 L9.2,5 L7,0.4 L4.8,1.6 V-8.8 H-4.8 V1.6 L-7,0.4 L-9.2,5 Z"),
    "dish": (*circle(0, 0, 9), *circle(0, 0, 5.2)),
    "filter": stroke("M-8.6,8.4 H8.6 L2,0.2 V-8.6 L-2,-5.6 V0.2 Z"),
    "bin": (
        *stroke("M-6.4,5.4 L-5.2,-9 H5.2 L6.4,5.4 M-8.6,5.6 H8.6 M-2.8,5.6 V8.6 H2.8 V5.6"),
        *stroke("M-2,1.8 V-5.2 M2,1.8 V-5.2"),
    ),
    "pedal": (
        *stroke("M-8.6,-6.6 L7.4,1.4"),
        *stroke("M1.6,8.8 V3.6 M-0.8,5.6 L1.6,3.2 L4,5.6"),
        *disc(8, 1.7, 1.6),
    ),
}
"""Household icons by name."""


Weight = Literal["light", "regular", "bold"]
"""Line weight of an icon."""

_WIDTHS: dict[str, float] = {"light": 1.1, "regular": 1.5, "bold": 1.9}  # in units of the square

_DRAWINGS = SIGNS | KITCHEN

ICONS: tuple[str, ...] = tuple(sorted(_DRAWINGS))
"""The names of all icons."""


def checked_icon(name: str) -> str:
    """Return the name of an icon."""
    if name not in _DRAWINGS:
        raise ValueError(f"there is no icon {name!r}.{nearest(name, ICONS)} artgen.ICONS lists all")
    return name


@cached(512)
def icon_outline(name: str, weight: str) -> Outline:
    """Return an icon in units of its square."""
    return drawing(_DRAWINGS[checked_icon(name)], _WIDTHS[weight], f"the icon {name!r}")


@kernel
def _icon(name: str, height: float, weight: Weight) -> Outline:
    inputs.positive("height", height)
    return moved_outline(icon_outline(name, weight), np.eye(2) * (height / SQUARE), np.zeros(2))


def icon(name: str, height: Scalar, *, weight: Weight = "regular") -> Profile:
    """Make an icon such as `"power"`, `"timer"` or `"child_lock"`; `ICONS` lists them.

    Icons of equal height match: all are drawn on the same square with the same line width.

    Args:
        name: Name of the icon; known while building.
        height: Side of the square about the origin that the icon fills approximately [m].
        weight: Line weight.

    Raises:
        BuildError: There is no such icon; the message suggests the nearest name.

    Examples:
        >>> details.icon("power", 0.01)
    """
    try:
        checked_icon(name)
    except ValueError as error:
        raise BuildError(f"{error}\n  at {authors_line()}") from None
    return Profile.record(_icon, name=name, height=height, weight=weight)
