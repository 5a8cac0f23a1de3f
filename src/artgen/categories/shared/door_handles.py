"""Lever handles and knobs of doors."""

import math
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared.finish import casting
from artgen.categories.shared.locks import NECK_GAP, PIN, SIDES, Faces, spindle, with_button

_FLATNESS = 0.6  # thickness of a flat or oval grip, as a share of its height
_BEND = 0.018  # radius of the bends of a bar [m]
_HOLD = 0.62  # position of the hand on a bar, as a share of its length
_PAST_JAMB = 0.5  # approach angle of a hand at the back, past the jamb [rad]
_RETURN = 0.031  # reach of the tip of a bent lever back towards the leaf, so that no sleeve catches [m]


def spring_turn(
    name: str = "handle_turn",
    *,
    limit: ag.Scalar,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
    preload: ag.Scalar = 0.7,
    torque: ag.Scalar = 1.3,
    damping: ag.Scalar = 0.06,
) -> ag.Joint:
    """Make the joint of a lever or knob with a return spring; positive moves the free end down."""
    spring = ag.Spring(preload=preload, force=torque)
    # with the inertia of the follower and the springs in the lock case
    case = feel.Feel(damping=damping, friction=0.02, armature=0.0005, effort=20.0)
    # the axis moves a lever that points to -x down
    return ag.Revolute(name, axis=-ag.Y, pivot=pivot, limits=(0.0, limit), spring=spring, feel=case)


@ag.generator
def lever_handle(
    *,
    thickness: ag.Float,
    rose_depth: ag.Float,
    finish: ag.Material,
    faces: Faces = ag.given("both"),
    style: Literal["straight", "bent", "wave"] = ag.choice("straight", "bent", "wave"),
    section: Literal["round", "flat"] = ag.choice("round", "flat"),
    length: ag.Float = ag.uniform(0.115, 0.145, "m", doc="distance from spindle to tip", within=(0.08, 0.25)),
    projection: ag.Float = ag.uniform(
        0.046, 0.056, "m", doc="distance from the leaf to the middle of the lever"
    ),
    girth: ag.Float = ag.uniform(0.0085, 0.0105, "m", doc="half the height of the grip"),
) -> ag.Body:
    """Make a lever on each face of the leaf, joined by the spindle: the link `handle`.

    Attach it by `spring_turn`.
    """
    solids: list[ag.Solid] = []
    grasps: list[ag.Frame] = []
    collar = ag.cylinder(girth + 0.002, 0.010, axis=ag.Y, bevel=0.0012)
    start, out = thickness / 2 + rose_depth + NECK_GAP, thickness / 2 + projection
    # the upper and lower halves are alike: turned over, the lever fits the other face
    level = style != "wave"
    for side in SIDES[faces]:
        sense = 1 if level else side
        solid = [collar.at(0.0, sense * (start + 0.005), 0.0)]
        if level:
            solid += _bar(style, section, start, out, length, girth)
        else:
            solid += _wave(side * start, side * out, side, length, girth)
        solids += [each.rotate(ag.X, math.pi) for each in solid] if side < sense else solid
        lean = _PAST_JAMB if side > 0 else 0.0
        towards = (math.sin(lean), -side * math.cos(lean), 0.0)
        if level:
            grasps.append(ag.frame((-_HOLD * length, side * out, 0.0), approach=towards))
        else:
            # on the last third of the wave, which slopes gently; the fingers close normal to it
            reach = _FLATNESS * girth - length
            at, closing = (0.84 * reach, side * out, -0.35 * girth), (-0.20 * girth, 0.0, -0.32 * reach)
            grasps.append(ag.grasp_on(solid[-2], approach=towards, closing=closing, at=at))
    solids.append(spindle(thickness, rose_depth, faces))
    return ag.part(ag.union(*solids), "handle", finish, grasp=grasps)


def _bar(
    style: str, section: str, start: ag.Scalar, out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar
) -> list[ag.Solid]:
    """Make a bent bar from its neck at y = start to its tip, which is slightly domed."""
    thin = girth if section == "round" else _FLATNESS * girth
    corners: list[ag.VectorLike] = [(0.0, start, 0.0), (0.0, out, 0.0)]
    if style == "bent":
        reach = thin - length
        corners += [(reach, out, 0.0), (reach, out - _RETURN, 0.0)]
    else:
        corners += [(0.002 - length, out, 0.0)]
    bar = ag.sweep(_section(section, girth), ag.polyline(corners, fillet=_BEND))
    # an end piece rounds the tip: it is 2 mm long and 0.2 mm smaller all around
    if section == "round":
        tip = ag.cylinder(girth - 0.0002, 0.004, axis=ag.Y if style == "bent" else ag.X, bevel=0.0018)
    else:
        wide, high = 2 * thin - 0.0004, 2 * girth - 0.0004
        sizes = (wide, 0.004, high) if style == "bent" else (0.004, wide, high)
        tip = ag.box(*sizes, bevel=0.0016)
    return [bar, tip.at(corners[-1])]


def _section(section: str, girth: ag.Scalar) -> ag.Profile:
    if section == "round":
        return ag.circle(girth)
    return ag.rectangle(2 * _FLATNESS * girth, 2 * girth, radius=0.003)


def _wave(start: ag.Scalar, out: ag.Scalar, side: int, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    """Make a hub and an oval arm that rises, dips and becomes horizontal."""
    thin = _FLATNESS * girth
    face = out + side * (thin + 0.001)  # the hub ends 1 mm in front of the arm
    hub = ag.cylinder(girth + 0.0015, side * (face - start), axis=ag.Y, bevel=0.002)
    reach = thin - length
    # heights as shares of the girth: a gentle S, as in cast levers
    rises = ((0.0, 0.0), (0.30, 0.45), (0.68, -0.25), (1.0, -0.45))
    course = ag.spline([(along * reach, out, rise * girth) for along, rise in rises])
    tip = ag.ellipsoid(thin, thin - 0.0002, girth - 0.0002).at(reach, out, -0.45 * girth)
    return [hub.at(0.0, (start + face) / 2, 0.0), ag.sweep(ag.ellipse(thin, girth), course), tip]


_PIN_DEPTH = 0.012  # depth of the hole of a privacy pin in a knob [m]
_KNOB_PAST_JAMB = 0.8  # approach angle of a hand at the back, past the jamb [rad]
_LEAN = (math.sin(0.25), 0.0, math.cos(0.25))
_CLOSING = {"ball": _LEAN, "flat": _LEAN, "tulip": _LEAN, "egg": (0.0, 0.0, 1.0)}
"""Range of closing directions: a hand turns a round knob from a lean to one side to a lean to the other."""


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
    projection: ag.Float = ag.uniform(0.060, 0.068, "m", doc="distance from the leaf to the end of the knob"),
) -> ag.Body:
    """Make a knob on each face of the leaf, joined by the spindle: the link `handle`.

    Attach it by `spring_turn`. A privacy lock is attached to it as the link `lock`.
    """
    solids: list[ag.Solid] = []
    grasps: list[ag.Frame] = []
    start, end = thickness / 2 + rose_depth + NECK_GAP, thickness / 2 + projection
    deep = ag.min_(0.74 * radius, 0.48 * (end - start))  # half the depth of a ball, clear of the rose
    widest = {"flat": 0.011, "tulip": 0.009}.get(style, deep)  # distance of its widest part from the end [m]
    back = _one_knob(style, start, end, radius, deep)
    for side in SIDES[faces]:
        solids += back if side > 0 else [solid.rotate(ag.X, math.pi) for solid in back]
        middle = (0.0, side * (end - widest), 0.0)
        lean = _KNOB_PAST_JAMB if side > 0 else 0.0
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


def _one_knob(
    style: str, start: ag.Scalar, end: ag.Scalar, radius: ag.Scalar, deep: ag.Scalar
) -> list[ag.Solid]:
    """Make a knob from y = start, in front of the rose, to y = end; `deep` is half the depth of a ball."""
    collar = ag.cylinder(0.016, 0.0045, axis=ag.Y, bevel=0.0015).at(y=start + 0.00225)
    neck = ag.cylinder(0.0115, (end - start) * 0.7, axis=ag.Y).at(y=start + 0.35 * (end - start))
    match style:
        case "ball" | "egg":
            wide, high = (radius, radius) if style == "ball" else (1.15 * radius, 0.85 * radius)
            head = [ag.ellipsoid(wide, deep, high).at(y=end - deep)]
        case "flat":
            rim = ag.min_(0.0028, 0.12 * radius)
            head = [ag.cylinder(radius, 0.022, axis=ag.Y, bevel=rim).at(y=end - 0.011)]
        case _:
            cup = ag.frustum(0.5 * radius, radius, 0.026, axis=ag.Y, bevel=0.003).at(y=end - 0.016)
            head = [cup, ag.cylinder(0.8 * radius, 0.008, axis=ag.Y, bevel=0.0015).at(y=end - 0.004)]
    return [neck, collar, *head]
