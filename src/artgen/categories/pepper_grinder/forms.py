"""Silhouettes of pepper mills: turned bodies and heads with waves, coves, beads and sharp corners.

A form is a list of smooth runs that meet at sharp corners, in shares of the mill's radius and height.
"""

import math
from typing import Literal

import artgen as ag
from artgen.categories.shared.vessels import Drawn, Run, drawn

BodyForm = Literal[
    "classic", "baluster", "hourglass", "tower", "cone", "barrel", "spool", "ripple", "cylinder"
]
"""The outline of a mill's body."""

Top = Literal["bulb", "disc", "ball", "crank"]
"""The turning part: a turned bulb, a flat disc, a ball, or a crank on a domed cap."""

Form = list[list[Drawn]]

_FOOT: Form = [[(0.96, 0, 0), (1, 0, 0.10), (0.97, 0, 0.30)], [(0.89, 0, 0.30), (0.89, 0, 0.37)]]
_PLAIN: list[Drawn] = [(0.97, 0, 0), (1, 0, 0.05)]
# bead below the head
_COLLAR: list[Drawn] = [(0.74, 1, -0.21), (0.80, 1, -0.19), (0.83, 1, -0.10), (0.80, 1, 0)]
# radius and its narrowing over the height, and height, of the points of a ripple
_RIPPLE = ((0.86, 0.12, 0), (0.97, 0.11, 0.08), (0.97, 0.12, 0.16), (0.86, 0.12, 0.25))
_BODIES: dict[BodyForm, Form] = {
    "classic": [
        *_FOOT,
        [(0.93, 0, 0.37), (0.88, 0.06, 0.42), (0.68, 0.34, 0.20), (0.60, 0.56, 0.10), (0.62, 0.76, -0.02),
         (0.72, 1, -0.26)],
        _COLLAR,
    ],
    "baluster": [
        *_FOOT,
        [(0.72, 0, 0.40), (0.66, 0.05, 0.46), (0.78, 0.16, 0.42), (0.93, 0.32, 0.20), (0.86, 0.48, 0.08)],
        [(0.90, 0.48, 0.10), (0.92, 0.48, 0.18), (0.88, 0.48, 0.26)],
        [(0.80, 0.48, 0.29), (0.62, 0.62, 0.14), (0.58, 0.78, 0), (0.72, 1, -0.26)],
        _COLLAR,
    ],
    "hourglass": [
        _PLAIN,
        [(1, 0, 0.05), (0.97, 0.10, 0.05), (0.76, 0.36, 0), (0.68, 0.56, 0), (0.74, 0.78, 0), (0.88, 1, 0)],
    ],
    "tower": [
        [(1, 0, 0), (1, 0, 0.22)],
        [(0.92, 0, 0.22), (0.92, 0, 0.30), (0.86, 0, 0.44)],
        [(0.79, 0, 0.44), (0.70, 0.5, 0.1), (0.66, 1, -0.44)],
        [(0.74, 1, -0.44), (0.80, 1, -0.36), (0.74, 1, -0.28)],
        [(0.82, 1, -0.28), (0.88, 1, 0)],
    ],
    "cone": [_PLAIN, [(1, 0, 0.05), (0.78, 1, 0)]],
    "barrel": [
        [(0.80, 0, 0), (0.84, 0, 0.06)],
        [(0.86, 0, 0.06), (0.96, 0.2, 0.04), (1, 0.46, 0), (0.96, 0.74, 0), (0.84, 1, -0.08)],
        [(0.80, 1, -0.08), (0.80, 1, 0)],
    ],
    "spool": [
        *_FOOT,
        [(0.92, 0, 0.37), (0.72, 0.20, 0.20), (0.68, 0.32, 0.10), (0.82, 0.5, -0.10)],
        [(0.88, 0.5, -0.10), (0.93, 0.5, 0), (0.88, 0.5, 0.10)],
        [(0.82, 0.5, 0.10), (0.66, 0.68, -0.08), (0.64, 0.80, -0.08), (0.76, 1, -0.24)],
        _COLLAR,
    ],
    "ripple": [
        [(0.96, 0, 0), (1, 0, 0.08), (0.97, 0, 0.20)],
        *(
            [(wide - taper * low, low + up, 0.20 - 0.42 * (low + up)) for wide, taper, up in _RIPPLE]
            for low in (0, 0.25, 0.5, 0.75)
        ),
        _COLLAR,
    ],
    "cylinder": [
        _PLAIN,
        [(1, 0, 0.05), (1, 0, 0.42)],
        [(0.975, 0, 0.42), (0.975, 0, 0.46)],
        [(1, 0, 0.46), (1, 1, -0.04)],
        [(1, 1, -0.04), (0.97, 1, 0)],
    ],
}  # fmt: skip

_BALL = [math.radians(angle) for angle in (-52, -26, 0, 30, 60, 82)]
_HEADS: dict[Top, Form] = {
    "bulb": [
        [(0.78, 0, 0), (0.82, 0, 0.08), (0.78, 0, 0.17)],
        [(0.66, 0, 0.17), (0.50, 0, 0.32), (0.48, 0, 0.45), (0.54, 0, 0.55)],
        [(0.60, 0, 0.55), (0.78, 0.30, 0.42), (0.84, 0.60, 0.20), (0.70, 0.86, 0.04), (0.40, 0.98, 0),
         (0.20, 1, 0)],
    ],
    "disc": [
        [(0.94, 0, 0), (1, 0, 0.06)],
        [(1, 0, 0.06), (1, 1, -0.14)],
        [(1, 1, -0.14), (0.95, 1, -0.03), (0.80, 1, 0)],
    ],
    "ball": [
        [(0.76, 0, 0), (0.80, 0, 0.07), (0.76, 0, 0.14)],
        [(0.62, 0, 0.14), (0.52, 0, 0.22), (0.52, 0, 0.26)],
        [(0.90 * math.cos(turn), 1, -0.88 + 0.88 * math.sin(turn)) for turn in _BALL],
    ],
    "crank": [  # fixed cap under the crank
        [(0.88, 0, 0), (0.90, 0, 0.05), (0.88, 0, 0.12)],
        [(0.84, 0, 0.12), (0.74, 0.55, 0.06), (0.44, 0.92, 0), (0.26, 1, 0)],
    ],
}  # fmt: skip
_BASES = {"bulb": 0.80, "disc": 0.94, "ball": 0.78, "crank": 0.88}  # radii of the lower ends of heads

HEAD_HEIGHT = {"bulb": 1.75, "disc": 0.62, "ball": 1.92, "crank": 0.62}
"""Height of each head over the mill's radius; a straight body has a higher disc."""

WIDEST = {"bulb": 0.62, "disc": 0.5, "ball": 0.54}
"""Height of the widest part of a head, where hands hold it, as a share of the head's height."""


def end_radius(style: BodyForm) -> float:
    """Return the radius of the upper end of a body over the mill's radius."""
    return _BODIES[style][-1][-1][0]


def body_runs(style: BodyForm, space: ag.Region) -> list[Run]:
    """Return the outline of a body in its space."""
    return drawn(_BODIES[style], space.x.high, space.z.low, space.z.size)


def head_runs(top: Top, style: BodyForm, radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar) -> list[Run]:
    """Return the outline of a head, or of the cap under a crank, whose foot fits the end of a body."""
    narrow = end_radius(style) / _BASES[top]
    narrow = narrow if top in ("disc", "crank") else min(narrow, 1.06)
    form = [[(narrow * wide, share, rest) for wide, share, rest in run] for run in _HEADS[top]]
    return drawn(form, radius, low, height)
