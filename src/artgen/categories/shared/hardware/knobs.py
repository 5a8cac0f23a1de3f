"""Door knobs."""

import math
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.categories.shared.hardware.locks import with_button
from artgen.categories.shared.hardware.roses import NECK_GAP, PIN, SIDES, Faces, spindle

_PIN_DEPTH = 0.012  # depth of the hole of a privacy pin in a knob [m]
_PAST_JAMB = 0.8  # at the back a hand comes from the side of the hinges, past the jamb [rad]
_LEAN = (math.sin(0.25), 0.0, math.cos(0.25))
_CLOSING = {"ball": _LEAN, "flat": _LEAN, "tulip": _LEAN, "egg": (0.0, 0.0, 1.0)}
"""A hand turns a knob from leaning to one side to leaning to the other, where the knob is round."""


@ag.generator
def knob_handle(
    *,
    thickness: ag.Float,
    rose_depth: ag.Float,
    finish: ag.Material,
    faces: Faces = ag.given("both"),
    lock: Literal["none", "turn", "push"] = ag.given("none"),
    lock_side: int = ag.given(-1),
    style: Literal["ball", "flat", "tulip", "egg"] = ag.choice("ball", "flat", "tulip", "egg"),
    radius: ag.Float = ag.uniform(0.025, 0.0285, "m", doc="radius of the knob", within=(0.02, 0.04)),
    projection: ag.Float = ag.uniform(0.060, 0.068, "m", doc="face of the leaf to the end of the knob"),
) -> ag.Body:
    """Make a knob on each face of the leaf, joined by the spindle: the link `handle`.

    Attach it by `spring_turn`. A privacy lock is attached to it as the link `lock`.
    """
    solids: list[ag.Solid] = []
    grasps: list[ag.Frame] = []
    start, end = thickness / 2 + rose_depth + NECK_GAP, thickness / 2 + projection
    deep = ag.min_(0.74 * radius, 0.48 * (end - start))  # half the depth of a ball, which the rose clears
    back = _one_knob(style, start, end, radius, deep)
    for side in SIDES[faces]:
        solids += back if side > 0 else [solid.rotate(ag.X, math.pi) for solid in back]
        middle = (0.0, side * (end - _girth(style, deep)), 0.0)
        lean = _PAST_JAMB if side > 0 else 0.0
        towards = (math.sin(lean), -side * math.cos(lean), 0.0)
        grasps.append(ag.frame(middle, approach=towards, closing=_CLOSING[style]))
    solids.append(spindle(thickness, rose_depth, faces))
    solid = ag.union(*solids)
    if lock == "none":
        return ag.part(solid, "handle", casting(finish), grasp=grasps)
    face = thickness / 2 + projection
    hole = ag.bore(PIN + 0.0004, 2 * _PIN_DEPTH, axis=ag.Y).at(0.0, lock_side * face, 0.0)
    body = ag.part(solid - hole, "handle", casting(finish), grasp=grasps)
    return with_button(body, lock, face=face, depth=_PIN_DEPTH, finish=finish, side=lock_side)


def _girth(style: str, deep: ag.Scalar) -> ag.Scalar:
    """Return how far behind its end a knob is widest, or flat [m]."""
    return {"ball": deep, "egg": deep, "flat": 0.011, "tulip": 0.009}[style]


def _one_knob(
    style: str, start: ag.Scalar, end: ag.Scalar, radius: ag.Scalar, deep: ag.Scalar
) -> list[ag.Solid]:
    """Make a knob from y = start, in front of the rose, to y = end; `deep` is half the depth of a ball."""
    neck = ag.cylinder(0.0115, (end - start) * 0.7, axis=ag.Y)
    collar = ag.cylinder(0.016, 0.0045, axis=ag.Y, bevel=0.0015)
    solids = [neck.at(0.0, start + 0.35 * (end - start), 0.0), collar.at(0.0, start + 0.00225, 0.0)]
    if style == "ball":
        solids.append(ag.ellipsoid(radius, deep, radius).at(0.0, end - deep, 0.0))
    elif style == "egg":
        solids.append(ag.ellipsoid(1.15 * radius, deep, 0.85 * radius).at(0.0, end - deep, 0.0))
    elif style == "flat":
        rim = ag.min_(0.0028, 0.12 * radius)
        solids.append(ag.cylinder(radius, 0.022, axis=ag.Y, bevel=rim).at(0.0, end - 0.011, 0.0))
    else:
        cup = ag.frustum(0.5 * radius, radius, 0.026, axis=ag.Y, bevel=0.003)
        solids.append(cup.at(0.0, end - 0.016, 0.0))
        solids.append(ag.cylinder(0.8 * radius, 0.008, axis=ag.Y, bevel=0.0015).at(0.0, end - 0.004, 0.0))
    return solids
