"""Push buttons: caps with return springs, their holes, and the plates around them.

A button is modeled about the origin on the plane y = 0, which is the face of its panel; it projects to -y and
reaches into the panel to +y. A finger is 18 mm thick: the distance between the middles of neighbors must be
at least 10 mm plus half of a cap, and a cap must project by more than its travel.
"""

from typing import Literal

import artgen as ag
from artgen import details

ButtonShape = Literal["round", "square", "pill", "bar"]
"""Outline of a cap: a circle, a square with rounded corners, a bar with round ends, or a plain bar."""

PLAY = 0.0004
"""Gap between a cap and its hole, all around [m]."""

_BEFORE = 0.010  # length of the cutter of a hole in front of the face [m]
_BEVEL = 0.0007  # bevel of the rim of a cap [m]


def button_outline(shape: ButtonShape, width: ag.Scalar, height: ag.Scalar) -> ag.Profile:
    """Make the outline of a cap, x to the right and y upward."""
    if shape == "round":
        return ag.circle(width / 2)
    share = {"square": 0.2, "pill": 0.499, "bar": 0.12}[shape]
    return ag.rectangle(width, height, radius=share * ag.min_(width, height))


def push_button(
    *,
    finish: ag.Material,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    proud: ag.Scalar = 0.004,
    deep: ag.Scalar = 0.008,
    icon: str = "",
    ink: ag.Material | None = None,
    name: str = "button",
) -> ag.Body:
    """Make the cap of a button with its push frame; attach it by `button_press`."""
    high = width if height is None or shape == "round" else height
    length = proud + deep
    if shape == "round":
        cap = ag.cylinder(width / 2, length, axis=ag.Y, bevel=_BEVEL)
    else:
        cap = ag.extrude(button_outline(shape, width, high), length, axis=ag.Y, bevel=_BEVEL)
    cap = cap.at(0.0, (deep - proud) / 2, 0.0)
    body = ag.part(cap, "button", finish, name=name, push=ag.push_on(cap, direction=ag.Y))
    if not icon or ink is None:
        return body
    sign = details.icon(icon, 0.62 * ag.min_(width, high))
    return ag.weld(body, details.printed(sign, (0.0, -proud, 0.0), material=ink))


def button_press(
    name: str = "button_slide",
    *,
    travel: ag.Scalar = 0.003,
    preload: ag.Scalar = 0.6,
    force: ag.Scalar = 3.0,
    damping: ag.Scalar = 6.0,
    effort: ag.Scalar = 12.0,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
) -> ag.Joint:
    """Make the joint of a button with a return spring; positive moves it into its panel (+y).

    Keys of appliances close at 2-4 N, and start at a fifth of that or more, so that they do not rattle.
    """
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.1,  # friction of the cap in its guide
        armature=0.03,  # inertia of the switch; a lighter part would sink into its stop in MuJoCo
        effort=effort,
    )


def button_hole(
    width: ag.Scalar, height: ag.Scalar | None = None, *, through: ag.Scalar = 0.01, play: ag.Scalar = PLAY
) -> ag.Solid:
    """Make the cutter for the hole of a cap, rectangular for all shapes, so that it needs few colliders.

    A `button_plate` covers the corners that round caps leave open.
    """
    high = width if height is None else height
    hole = ag.box(width + 2 * play, _BEFORE + through, high + 2 * play)
    return hole.at(0.0, (through - _BEFORE) / 2, 0.0)


def button_plate(
    *,
    finish: ag.Material,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    border: ag.Scalar = 0.002,
    proud: ag.Scalar = 0.0006,
    label: str = "bezel",
) -> ag.Body:
    """Make the thin plate around a cap, with a hole of its shape, visual only."""
    high = width if height is None or shape == "round" else height
    hole = button_outline(shape, width + 2 * PLAY, high + 2 * PLAY)
    wide, tall = width + 2 * border, high + 2 * border
    soft = "square" if shape in ("round", "pill") else shape  # the plate has to cover the corners of the hole
    sheet = button_outline(soft, wide, tall) - hole
    solid = ag.extrude(sheet, proud + 0.001, axis=ag.Y).at(0.0, (0.001 - proud) / 2, 0.0)
    return ag.detail(solid, label, finish)
