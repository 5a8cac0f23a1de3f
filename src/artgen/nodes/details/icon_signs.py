"""The drawings of general icons, controls, directions, states and weather: y up, within 20 units."""

from artgen.nodes.details.pen import (
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
