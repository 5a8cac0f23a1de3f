"""Fittings of a leaf without a lock: pull handles, push bars and finger plates."""

import math
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import casting, recess
from artgen.categories.shared.fixings import Way, screws
from artgen.categories.shared.fronts import Blank
from artgen.categories.shared.locks import SIDES, Faces
from artgen.categories.shared.pulls import bent_bar, rod

ASTRAGAL_GAP = 0.002
"""Gap between the active leaf and the strip behind it [m]."""


@ag.generator
def finger_plate(
    *, thickness: ag.Float, finish: ag.Material, height: ag.Float = ag.uniform(0.28, 0.38, "m")
) -> ag.Body:
    """Make the push plates on both faces of a leaf without a handle; weld them to it.

    They show which face to push, and which to pull (the front, to which the leaf opens).
    """
    plate = ag.extrude(ag.rectangle(0.075, height, radius=0.004), 0.0016, axis=ag.Y, bevel=0.0006)
    face = thickness / 2.0 + 0.0012
    bodies: list[ag.Body] = []
    for side, word in ((-1, "PULL"), (1, "PUSH")):
        bodies.append(ag.part(plate.at(0.0, side * (face - 0.0008), 0.0), "plate", finish))
        places = [(x * 0.030, side * face, z * (height / 2.0 - 0.008)) for x in (-1, 1) for z in (-1, 1)]
        facing: Way = "-y" if side < 0 else "+y"
        bodies += screws(places, facing=facing, radius=0.0034, finish=finish, drive="slot")
        bodies.append(
            details.engraved(
                ag.text(word, 0.0125),
                (0.0, side * face, height / 2.0 - 0.045),
                facing=(0.0, side, 0.0),
                label="plate",
                material=finish,
            )
        )
    return ag.weld(*bodies)


def astragal(blank: Blank, gap: ag.Scalar) -> ag.Body:
    """Make the strip on the back of the inactive leaf, against which the active leaf closes."""
    wide, deep = 0.040, 0.012
    strip = ag.box(wide, deep - ASTRAGAL_GAP, blank.upright - 0.06, bevel=0.002)
    foot = ag.box(wide / 2.0 - gap / 2.0 - 0.002, ASTRAGAL_GAP + 0.002, blank.upright - 0.07)
    back = blank.thickness / 2.0
    edge = blank.width / 2.0
    strip = strip.align((edge + gap / 2.0, back + ASTRAGAL_GAP, blank.waist), y=-1.0)
    foot = foot.align((edge, back - 0.001, blank.waist), x=1.0, y=-1.0)
    return ag.weld(ag.part(strip, "door", blank.finish), ag.part(foot, "door", blank.finish))


_SUNK = 0.0005  # depth of the feet in the leaf [m]
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
    bodies: list[ag.Body] = []
    makers = {"U": _bow, "T": _bar_on_posts, "Z": _offset_bar}
    foot, reach = thickness / 2 - _SUNK, thickness / 2 + projection
    back = ag.union(*makers[style](foot, reach, length, girth))
    for side in SIDES[faces]:
        out = side * reach
        # hands pull in front; at the back, behind the jamb, they push
        press = ag.frame((0.0, out + side * girth, 0.0), approach=(0.0, -side, 0.0))
        grasp = ag.frame((0.0, out, 0.0), approach=(0.0, -side, 0.0), closing=(1.0, 0.0, 0.0))
        name = "handle_front" if side < 0 else "handle_back"
        bodies.append(
            ag.part(
                back if side > 0 else back.rotate(ag.X, math.pi),  # the upper and lower halves are alike
                "handle",
                casting(finish),
                name=name,
                grasp=grasp if side < 0 else (),
                push=press if side > 0 else (),
            )
        )
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
    bar = ag.cylinder(girth, length, bevel=0.0015).at(0.0, out, 0.0)
    return [bar, *posts, *_feet(foot, 0.0, half, girth)]


def _offset_bar(foot: ag.Scalar, out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    half = 0.32 * length
    aside = -0.03  # away from the lock edge, which a second leaf may overlap
    section = ag.rectangle(1.2 * girth, 1.2 * girth, radius=0.002)
    corners = [(aside, foot, 0.0), (aside, out, 0.0), (0.0, out, 0.0)]
    arm = bent_bar(section, corners, [(0, 1, 0), (1, 0, 0)], bend=0.01, halves=False)
    arms = [solid.at(0.0, 0.0, end * half) for solid in arm for end in (-1, 1)]
    bar = ag.capsule(girth, length).at(0.0, out, 0.0)
    return [bar, *arms, *_feet(foot, aside, half, girth)]


_CHANNEL_DEPTH = 0.028  # height of the flanges of the rail above the leaf [m]
_SHEET = 0.0028  # thickness of the rail [m]
_BAR_HEIGHT = 0.046
_BAR_REACH = 0.048  # distance from the face of the leaf to the front of the bar at rest [m]
_PLAY = 0.0008  # gap between the bar and the flanges above and below it [m]
_CASE_DEPTH = 0.052
_CASE_HEIGHT = 0.070
_CASE_LENGTH = 0.085  # length of a full case: half of it is behind the lock; the far case is half as long [m]
# distance from the lock to the end of its case, behind the overlap of a second leaf [m]
_CASE_TO_EDGE = 0.027
_END_GAP = 0.0015  # gap between the bar and its cases [m]
_FULL = 0.2  # density of hollow cases and bars of sheet metal, as a share of that of solid ones
_BOTTOM = 0.002  # gap between the bar at its innermost position and the rail [m]


def _bar_span(length: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return the middle and the length of the touch bar along x."""
    near = _CASE_LENGTH / 2 + _END_GAP  # the case over the lock is centered on the axis of the lock
    far = length - _CASE_LENGTH - _END_GAP
    return -(near + far) / 2, far - near


def push_slide(
    name: str = "handle_push",
    *,
    travel: ag.Scalar,
    side: int = 1,
    preload: ag.Scalar = 15.0,
    force: ag.Scalar = 45.0,
    damping: ag.Scalar = 40.0,
    friction: ag.Scalar = 1.0,
) -> ag.Joint:
    """Make the joint of a push bar with its spring; positive moves it towards the leaf."""
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=(0.0, -side, 0.0),
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=friction,
        effort=200.0,
    )


@ag.generator
def push_bar(
    *, thickness: ag.Float, length: ag.Float, travel: ag.Float, finish: ag.Material, side: int = ag.given(1)
) -> ag.Body:
    """Make the touch bar, the link `handle`, for `push_slide` and for a `push_bar_case` on the leaf."""
    middle, span = _bar_span(length)
    back = thickness / 2 + _SHEET + _BOTTOM + travel
    front = thickness / 2 + _BAR_REACH
    bar = ag.box(span, front - back, _BAR_HEIGHT, bevel=0.004).align((middle, side * front, 0.0), y=side)
    at = (middle + 0.25 * span, side * front, 0.0)  # nearer to the lock: far from the hinges
    return ag.part(
        bar, "handle", casting(finish, _FULL), push=ag.push_on(bar, direction=(0.0, -side, 0.0), at=at)
    )


def push_bar_case(*, thickness: ag.Scalar, length: ag.Scalar, finish: ag.Material, side: int = 1) -> ag.Body:
    """Make the rail and the cases of a push bar, which are welded to the leaf, with the label `rose`."""
    face = thickness / 2 - 0.0005
    middle, span = _bar_span(length)
    inner = _BAR_HEIGHT / 2 + _PLAY
    back = ag.box(span + 0.004, _SHEET + 0.0005, 2 * inner + 0.002)
    flange = ag.box(span + 0.004, _CHANNEL_DEPTH + 0.0005, _SHEET, bevel=0.001)
    flanges = [
        flange.at(middle, side * (face + _CHANNEL_DEPTH / 2), end * (inner + _SHEET / 2)) for end in (-1, 1)
    ]
    low, high = -_CASE_LENGTH / 2, _CASE_TO_EDGE
    near = ag.box(high - low, _CASE_DEPTH, _CASE_HEIGHT, bevel=0.005)
    far = ag.box(_CASE_LENGTH / 2, _CASE_DEPTH, _CASE_HEIGHT, bevel=0.005)
    far_middle = _CASE_LENGTH * 0.75 - length
    dark = recess(finish)
    plate = ag.box(0.034, 0.0004, 0.007).at(0.0, side * (face + _CASE_DEPTH), 0.014)
    return ag.weld(
        ag.part(
            near.at((low + high) / 2, side * (face + _CASE_DEPTH / 2), 0.0), "rose", casting(finish, _FULL)
        ),
        ag.part(far.at(far_middle, side * (face + _CASE_DEPTH / 2), 0.0), "rose", casting(finish, _FULL)),
        ag.part(back.at(middle, side * (face + _SHEET / 2), 0.0), "rose", finish),
        *(ag.part(each, "rose", finish) for each in flanges),
        ag.detail(plate, "screw", dark),
    )
