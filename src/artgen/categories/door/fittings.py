"""Fittings that serve as handles of a leaf: pulls, push bars and finger plates."""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.finish import casting, recess
from artgen.categories.shared.fixings import Way, screws
from artgen.categories.shared.locks import SIDES, Faces
from artgen.categories.shared.pulls import bent_bar, rod

_PUSH = feel.Feel(damping=40, friction=1, effort=200)


@ag.generator
def finger_plate(
    *, thickness: ag.Float, finish: ag.Material, height: ag.Float = ag.uniform(0.28, 0.38, "m")
) -> ag.Body:
    """Make the push plates on both faces of a leaf without a handle; weld them to it.

    They show which face to push, and which to pull (the front, to which the leaf opens).
    """
    plate = ag.extrude(ag.rectangle(0.075, height, radius=0.004), 0.0016, axis=ag.Y, bevel=0.0006)
    face, x, z = thickness / 2 + 0.0012, 0.030, height / 2 - 0.008
    solids, seen = [], []
    sides: tuple[tuple[int, Way, str], ...] = ((-1, "-y", "PULL"), (1, "+y", "PUSH"))
    for side, facing, word in sides:
        y = side * face
        solids.append(plate.at(y=side * (face - 0.0008)))
        corners = [(-x, y, -z), (-x, y, z), (x, y, -z), (x, y, z)]
        seen += screws(corners, facing=facing, radius=0.0034, finish=finish, drive="slot")
        name, at = ag.text(word, 0.0125), (0.0, y, height / 2 - 0.045)
        seen.append(details.engraved(name, at, facing=(0.0, side, 0.0), label="plate", material=finish))
    return ag.weld(ag.part(solids, "plate", finish), *seen)


_SUNK = 0.0005  # depth of fittings in the leaf [m]
_BOW = 0.022  # radius of the bends of a bow [m]


@ag.generator
def pull_handle(
    *,
    thickness: ag.Float,
    finish: ag.Material,
    faces: Faces = ag.given("both"),
    room: ag.Scalar = ag.given(2.7),
    style: Literal["U", "T", "Z"] = ag.choice("U", "T", "Z"),
    length: ag.Float = ag.uniform(0.22, 0.45, "m", doc="overall length of the grip", within=(0.10, 1.8)),
    projection: ag.Float = ag.uniform(
        0.045, 0.065, "m", doc="distance from the leaf to the middle of the grip"
    ),
    girth: ag.Float = ag.uniform(0.009, 0.0125, "m", doc="radius of the bar"),
) -> ag.Body:
    """Make an upright pull on the faces of a leaf, which is welded to it, with the label `handle`.

    The origin is at half the length of the grip, in the middle plane of the leaf.
    """
    length = ag.require(
        length, length < room, "the pull is longer than the free part of the leaf: lower handle.length"
    )
    makers = {"U": _bow, "T": _bar_on_posts, "Z": _offset_bar}
    out = thickness / 2 + projection
    solid = ag.union(*makers[style](thickness / 2 - _SUNK, out, length, girth))
    metal, bodies = casting(finish), []
    if -1 in SIDES[faces]:
        grasp = ag.frame((0.0, -out, 0.0), approach=ag.Y, closing=ag.X)
        front = solid.rotate(ag.X, math.pi)  # the upper and lower halves are alike
        bodies.append(ag.part(front, "handle", metal, name="handle_front", grasp=grasp))
    if 1 in SIDES[faces]:  # hands pull in front; at the back, behind the jamb, they push
        press = ag.frame((0.0, out + girth, 0.0), approach=-ag.Y)
        bodies.append(ag.part(solid, "handle", metal, name="handle_back", push=press))
    return ag.weld(*bodies)


def _feet(foot: ag.Scalar, x: ag.Scalar, half: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    """Make the round flanges under both ends."""
    flange = ag.cylinder(girth + 0.004, 0.005, axis=ag.Y, bevel=0.0012)
    return [flange.at(x, foot + 0.0025, end * half) for end in (-1, 1)]


def _bow(foot: ag.Scalar, out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    half = length / 2 - girth
    corners = [(0.0, foot, -half), (0.0, out, -half), (0.0, out, half), (0.0, foot, half)]
    ways = [(0, 1, 0), (0, 0, 1), (0, -1, 0)]
    bow = bent_bar(ag.circle(girth), corners, ways, bend=_BOW, halves=True, run=rod(girth))
    return [*bow, *_feet(foot, 0.0, half, girth)]


def _bar_on_posts(foot: ag.Scalar, out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    half = 0.32 * length
    post = ag.cylinder(0.7 * girth, out - foot, axis=ag.Y)
    posts = [post.at(0.0, (foot + out) / 2, end * half) for end in (-1, 1)]
    bar = ag.cylinder(girth, length, bevel=0.0015).at(y=out)
    return [bar, *posts, *_feet(foot, 0.0, half, girth)]


def _offset_bar(foot: ag.Scalar, out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    half, aside = 0.32 * length, -0.03  # away from the lock edge, which a second leaf may overlap
    section = ag.rectangle(1.2 * girth, 1.2 * girth, radius=0.002)
    corners = [(aside, foot, 0.0), (aside, out, 0.0), (0.0, out, 0.0)]
    arm = bent_bar(section, corners, [(0, 1, 0), (1, 0, 0)], bend=0.01, halves=False)
    arms = [solid.at(z=end * half) for solid in arm for end in (-1, 1)]
    return [ag.capsule(girth, length).at(y=out), *arms, *_feet(foot, aside, half, girth)]


_CHANNEL = 0.028  # height of the flanges of the rail above the leaf [m]
_SHEET = 0.0028  # thickness of the rail [m]
_BAR = 0.046  # height of the bar along z [m]
_REACH = 0.048  # distance from the face of the leaf to the front of the bar at rest [m]
_PLAY = 0.0008  # gap between the bar and the flanges above and below it [m]
_CASE = (0.085, 0.052, 0.070)  # length, depth and height of a full case [m]
_TO_EDGE = 0.027  # from the lock to the end of its case, behind the overlap of a second leaf [m]
_END_GAP = 0.0015  # gap between the bar and its cases [m]
_FULL = 0.2  # density of hollow cases and bars of sheet metal, as a share of that of solid ones


def _bar_span(length: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return the middle and the length of the touch bar along x; half a case is at its far end."""
    near = _CASE[0] / 2 + _END_GAP  # the case over the lock is centered on the axis of the lock
    far = length - _CASE[0] - _END_GAP
    return -(near + far) / 2, far - near


def push_slide(*, travel: ag.Scalar, side: int = 1) -> ag.Joint:
    """Make the joint of a push bar with its spring; positive moves it towards the leaf."""
    spring = ag.Spring(preload=15.0, force=45.0)
    return ag.Prismatic("handle_push", axis=(0.0, -side, 0.0), limits=(0, travel), spring=spring, feel=_PUSH)


@ag.generator
def push_bar(
    *, thickness: ag.Float, length: ag.Float, travel: ag.Float, finish: ag.Material, side: int = ag.given(1)
) -> ag.Body:
    """Make the touch bar, the link `handle`, for `push_slide` and for a `push_bar_case` on the leaf."""
    middle, span = _bar_span(length)
    back = thickness / 2 + _SHEET + 0.002 + travel  # at its innermost position 2 mm from the rail
    front = thickness / 2 + _REACH
    bar = ag.box(span, front - back, _BAR, bevel=0.004).align((middle, side * front, 0.0), y=side)
    at = (middle + 0.25 * span, side * front, 0.0)  # nearer to the lock: far from the hinges
    press = ag.push_on(bar, direction=(0.0, -side, 0.0), at=at)
    return ag.part(bar, "handle", casting(finish, _FULL), push=press)


def push_bar_case(*, thickness: ag.Scalar, length: ag.Scalar, finish: ag.Material, side: int = 1) -> ag.Body:
    """Make the rail and the cases of a push bar, which are welded to the leaf, with the label `rose`."""
    face, (middle, span), inner = thickness / 2 - _SUNK, _bar_span(length), _BAR / 2 + _PLAY
    back = ag.box(span + 0.004, _SHEET + 0.0005, 2 * inner + 0.002).at(middle, side * (face + _SHEET / 2))
    flange = ag.box(span + 0.004, _CHANNEL + 0.0005, _SHEET, bevel=0.001)
    flange = flange.at(middle, side * (face + _CHANNEL / 2), inner + _SHEET / 2)
    long, deep, tall = _CASE
    y = side * (face + deep / 2)
    near = ag.box(_TO_EDGE + long / 2, deep, tall, bevel=0.005).at((_TO_EDGE - long / 2) / 2, y)
    far = ag.box(long / 2, deep, tall, bevel=0.005).at(0.75 * long - length, y)
    plate = ag.box(0.034, 0.0004, 0.007).at(0.0, side * (face + deep), 0.014)
    return ag.weld(
        ag.part([near, far], "rose", casting(finish, _FULL)),
        ag.part([back, flange, flange.mirror(ag.Z)], "rose", finish),
        ag.detail(plate, "screw", recess(finish)),
    )
