"""The panel of a cooker: a pane with a display, keys at its sides, and perhaps a dial."""

import functools
import math
import operator
from collections.abc import Sequence

import artgen as ag
from artgen import details, signals
from artgen.categories.rice_cooker.inside import Look
from artgen.categories.shared import controls
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import Fitting

_WIDE, _HIGH = 0.018, 0.012  # of a cap [m]
_PLAY = 0.0010  # gap between the caps of a pair and their channel [m]
_STEPS = 20  # clicks of a dial per turn

Key = tuple[str, float, float]
"""Icon of a key, and its place on the panel [m]; two that follow each other share a channel."""

SIX: Sequence[Key] = (
    ("stop", -0.050, -0.016), ("timer", -0.050, 0.016), ("menu", 0.050, 0.016), ("play", 0.050, -0.016),
    ("minus", -0.017, -0.020), ("plus", 0.017, -0.020),
)  # fmt: skip
"""Keys at the sides of a display and below it."""

FOUR: Sequence[Key] = (
    ("stop", -0.042, -0.032), ("timer", -0.042, -0.004), ("menu", 0.042, -0.004), ("play", 0.042, -0.032),
)  # fmt: skip
"""Keys at the sides of a dial below a display."""


def with_keys(
    body: ag.Body,
    look: Look,
    keys: Sequence[Key],
    *,
    at: ag.VectorLike,
    lean: ag.Scalar,
    size: tuple[float, float],
    text: str,
    color: Color,
    dial: bool,
) -> ag.Body:
    """Put a panel on the front of a body.

    Args:
        body: The case.
        look: Materials of the cooker.
        keys: The keys.
        at: Middle of the panel [m].
        lean: Angle by which the front leans back [rad].
        size: Width and height of the pane [m].
        text: Figures of the display.
        color: Their color.
        dial: Whether there is a dial below the display.
    """
    hole = controls.button_outline("pill", _WIDE + 2 * controls.PLAY, _HIGH + 2 * controls.PLAY)
    holes = functools.reduce(operator.or_, [hole.at(x, z) for _, x, z in keys])
    pane = controls.inlay(*size, radius=0.010, holes=holes)
    figures = details.display(
        text, 0.058, 0.028, at=(0, -controls.PANE, 0.027 if dial else 0.012), color=color
    )
    for pair in (keys[first : first + 2] for first in range(0, len(keys), 2)):
        (_, left, low), (_, right, high) = pair
        channel = ag.box(abs(right - left) + _WIDE + 2 * _PLAY, 0.02, abs(high - low) + _HIGH + 2 * _PLAY)
        channel = channel.at((left + right) / 2, 0.0085 - 0.01, (low + high) / 2)
        body = body.cut(channel.rotate(ag.X, -lean).at(at))
    body = ag.weld(body, ag.weld(pane, figures).rotate(ag.X, -lean).at(at))
    for number, (icon, x, z) in enumerate(keys):
        stuff = look.trim if icon == "play" else look.grip
        cap = controls.button_cap(
            finish=stuff, shape="pill", width=_WIDE, height=_HIGH, proud=0.0034, deep=0.0065, icon=icon,
            ink=controls.ink_on(stuff),
        )  # fmt: skip
        key = Fitting.moving(cap, controls.button_press(travel=0.0015)).suffixed(f"_{number}").at(x, 0, z)
        body = body.install(key.rotate(ag.X, -lean), at=at)
    names = {icon: signals.pressed(f"button_slide_{number}") for number, (icon, _, _) in enumerate(keys)}
    body = body.output("cook", signals.latest([names["play"], names["stop"]], [1.0, 0.0]), kind="heat")
    beep = controls.any_pressed(f"button_slide_{number}" for number in range(len(keys)))
    body = body.output("beep", beep, kind="sound")
    if not dial:
        return body
    body = body.output("time", signals.level("dial_turn", (0.0, math.tau)), kind="display")
    clicks = [math.tau * step / _STEPS for step in range(_STEPS)]
    turn = controls.dial_turn("dial_turn", endless=True, friction=0.01, clicks=clicks, torque=0.02)
    knob = controls.dial(turn, "capped", 0.017, look.grip, depth=0.017, cap=look.trim)
    return body.install(knob.at(0, 0, -0.022).rotate(ag.X, -lean), at=at)
