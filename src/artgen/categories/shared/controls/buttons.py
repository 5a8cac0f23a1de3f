"""Push buttons: the caps that springs return, the holes that they move in, and the plates around them.

A button is drawn about the origin on the plane y = 0, which is the face of its panel; it stands out to -y and
reaches into the panel to +y. A finger is 18 mm thick: the middles of neighbors belong at least 10 mm plus
half of a cap apart, and a cap that stands out by more than its travel can be pressed home.
"""

from typing import Literal

from artgen import (
    Body,
    Joint,
    Material,
    Prismatic,
    Profile,
    Scalar,
    Solid,
    VectorLike,
    Y,
    box,
    circle,
    cylinder,
    detail,
    details,
    extrude,
    min_,
    part,
    push_on,
    rectangle,
    weld,
)

ButtonShape = Literal["round", "square", "pill", "bar"]
"""The outline of a cap: a circle, a soft square, round ends, or a plain bar."""

PLAY = 0.0004
"""Gap between a cap and its hole, all round [m]."""

_BEFORE = 0.010  # how far the tool of a hole stands out of the face [m]
_BEVEL = 0.0007  # of the rim of a cap [m]


def button_outline(shape: ButtonShape, width: Scalar, height: Scalar) -> Profile:
    """Make the outline of a cap, x to the right and y upward."""
    if shape == "round":
        return circle(width / 2)
    share = {"square": 0.2, "pill": 0.499, "bar": 0.12}[shape]
    return rectangle(width, height, radius=share * min_(width, height))


def push_button(
    *,
    finish: Material,
    shape: ButtonShape = "round",
    width: Scalar = 0.012,
    height: Scalar | None = None,
    proud: Scalar = 0.004,
    deep: Scalar = 0.008,
    icon: str = "",
    ink: Material | None = None,
    name: str = "button",
) -> Body:
    """Make the cap of a button with its push frame; attach it by `button_press`."""
    high = width if height is None or shape == "round" else height
    length = proud + deep
    if shape == "round":
        cap = cylinder(width / 2, length, axis=Y, bevel=_BEVEL)
    else:
        cap = extrude(button_outline(shape, width, high), length, axis=Y, bevel=_BEVEL)
    cap = cap.at(0.0, (deep - proud) / 2, 0.0)
    body = part(cap, "button", finish, name=name, push=push_on(cap, direction=Y))
    if not icon or ink is None:
        return body
    sign = details.icon(icon, 0.62 * min_(width, high))
    return weld(body, details.printed(sign, (0.0, -proud, 0.0), material=ink))


def button_press(
    name: str = "button_slide",
    *,
    travel: Scalar = 0.003,
    preload: Scalar = 0.6,
    force: Scalar = 3.0,
    damping: Scalar = 6.0,
    effort: Scalar = 12.0,
    pivot: VectorLike = (0.0, 0.0, 0.0),
) -> Joint:
    """Make the joint of a button that a spring returns; positive moves it into its panel (+y).

    Keys of appliances close at 2-4 N, and start at a fifth of that or more, so that they do not rattle.
    """
    stiffness = (force - preload) / travel
    return Prismatic(
        name,
        axis=Y,
        pivot=pivot,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.1,  # of the cap in its guide
        armature=0.03,  # the slide of the switch; so light a thing would sink into its stop in MuJoCo
        effort=effort,
    )


def button_hole(
    width: Scalar, height: Scalar | None = None, *, through: Scalar = 0.01, play: Scalar = PLAY
) -> Solid:
    """Make the tool that cuts the hole of a cap; it is rectangular for all shapes, which colliders like.

    A `button_plate` covers the corners that round caps leave open.
    """
    high = width if height is None else height
    hole = box(width + 2 * play, _BEFORE + through, high + 2 * play)
    return hole.at(0.0, (through - _BEFORE) / 2, 0.0)


def button_plate(
    *,
    finish: Material,
    shape: ButtonShape = "round",
    width: Scalar = 0.012,
    height: Scalar | None = None,
    border: Scalar = 0.002,
    proud: Scalar = 0.0006,
    label: str = "bezel",
) -> Body:
    """Make the thin plate around a cap, with a hole of its shape; it is only seen."""
    high = width if height is None or shape == "round" else height
    hole = button_outline(shape, width + 2 * PLAY, high + 2 * PLAY)
    wide, tall = width + 2 * border, high + 2 * border
    soft = "square" if shape in ("round", "pill") else shape  # it has to cover the corners of the hole
    sheet = button_outline(soft, wide, tall) - hole
    solid = extrude(sheet, proud + 0.001, axis=Y).at(0.0, (0.001 - proud) / 2, 0.0)
    return detail(solid, label, finish)
