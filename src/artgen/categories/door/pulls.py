"""Pull handles: rigid bars on stand-offs."""

import math
from typing import Literal

from artgen import (
    Body,
    Float,
    Material,
    Scalar,
    Solid,
    X,
    Y,
    capsule,
    choice,
    circle,
    cylinder,
    frame,
    generator,
    given,
    part,
    rectangle,
    require,
    uniform,
    union,
    weld,
)
from artgen.categories.shared.finish import casting
from artgen.categories.shared.hardware.bars import bent_bar, rod
from artgen.categories.shared.hardware.roses import SIDES, Faces

_SUNK = 0.0005  # how deep feet are let into the leaf [m]
_BOW = 0.022  # radius of the bends of a bow [m]


@generator
def pull_handle(
    *,
    thickness: Float,
    finish: Material,
    faces: Faces = given("both"),
    room: Scalar = given(2.7),
    style: Literal["U", "T", "Z"] = choice("U", "T", "Z"),
    length: Float = uniform(0.22, 0.45, "m", doc="overall length of the grip", within=(0.10, 1.8)),
    projection: Float = uniform(0.045, 0.065, "m", doc="face of the leaf to the middle of the grip"),
    girth: Float = uniform(0.009, 0.0125, "m", doc="radius of the bar"),
) -> Body:
    """Make an upright pull on the faces of a leaf, to be welded to it; it has the label `handle`.

    The origin is in the middle of the grip's length, in the middle of the leaf.
    """
    length = require(
        length, length < room, "the pull is longer than there is room on the leaf: lower handle.length"
    )
    bodies: list[Body] = []
    makers = {"U": _bow, "T": _bar_on_posts, "Z": _offset_bar}
    foot, reach = thickness / 2 - _SUNK, thickness / 2 + projection
    back = union(*makers[style](foot, reach, length, girth))
    for side in SIDES[faces]:
        out = side * reach
        # hands pull it in front; at the back, behind the jamb, they push it
        press = frame((0.0, out + side * girth, 0.0), approach=(0.0, -side, 0.0))
        grasp = frame((0.0, out, 0.0), approach=(0.0, -side, 0.0), closing=(1.0, 0.0, 0.0))
        name = "handle_front" if side < 0 else "handle_back"
        bodies.append(
            part(
                back if side > 0 else back.rotate(X, math.pi),  # upper and lower half are alike
                "handle",
                casting(finish),
                name=name,
                grasp=grasp if side < 0 else (),
                push=press if side > 0 else (),
            )
        )
    return weld(*bodies)


def _feet(foot: Scalar, x: Scalar, half: Scalar, girth: Scalar) -> list[Solid]:
    """Make the round flanges under both ends."""
    flange = cylinder(girth + 0.004, 0.005, axis=Y, bevel=0.0012)
    return [flange.at(x, foot + 0.0025, end * half) for end in (-1, 1)]


def _bow(foot: Scalar, out: Scalar, length: Scalar, girth: Scalar) -> list[Solid]:
    half = length / 2 - girth
    corners = [(0.0, foot, -half), (0.0, out, -half), (0.0, out, half), (0.0, foot, half)]
    ways = [(0, 1, 0), (0, 0, 1), (0, -1, 0)]
    bow = bent_bar(circle(girth), corners, ways, bend=_BOW, halves=True, run=rod(girth))
    return [*bow, *_feet(foot, 0.0, half, girth)]


def _bar_on_posts(foot: Scalar, out: Scalar, length: Scalar, girth: Scalar) -> list[Solid]:
    half = 0.32 * length
    post = cylinder(0.7 * girth, out - foot, axis=Y)
    posts = [post.at(0.0, (foot + out) / 2, end * half) for end in (-1, 1)]
    bar = cylinder(girth, length, bevel=0.0015).at(0.0, out, 0.0)
    return [bar, *posts, *_feet(foot, 0.0, half, girth)]


def _offset_bar(foot: Scalar, out: Scalar, length: Scalar, girth: Scalar) -> list[Solid]:
    half = 0.32 * length
    aside = -0.03  # away from the lock edge, which a second leaf may overlap
    section = rectangle(1.2 * girth, 1.2 * girth, radius=0.002)
    corners = [(aside, foot, 0.0), (aside, out, 0.0), (0.0, out, 0.0)]
    arm = bent_bar(section, corners, [(0, 1, 0), (1, 0, 0)], bend=0.01, halves=False)
    arms = [solid.at(0.0, 0.0, end * half) for solid in arm for end in (-1, 1)]
    bar = capsule(girth, length).at(0.0, out, 0.0)
    return [bar, *arms, *_feet(foot, aside, half, girth)]
