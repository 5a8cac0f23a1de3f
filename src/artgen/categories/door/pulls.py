"""Pull handles: rigid bars on stand-offs."""

import math
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.categories.shared.hardware.bars import bent_bar, rod
from artgen.categories.shared.hardware.roses import SIDES, Faces

_SUNK = 0.0005  # how deep feet are let into the leaf [m]
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
    projection: ag.Float = ag.uniform(0.045, 0.065, "m", doc="face of the leaf to the middle of the grip"),
    girth: ag.Float = ag.uniform(0.009, 0.0125, "m", doc="radius of the bar"),
) -> ag.Body:
    """Make an upright pull on the faces of a leaf, to be welded to it; it has the label `handle`.

    The origin is in the middle of the grip's length, in the middle of the leaf.
    """
    length = ag.require(
        length, length < room, "the pull is longer than there is room on the leaf: lower handle.length"
    )
    bodies: list[ag.Body] = []
    makers = {"U": _bow, "T": _bar_on_posts, "Z": _offset_bar}
    foot, reach = thickness / 2 - _SUNK, thickness / 2 + projection
    back = ag.union(*makers[style](foot, reach, length, girth))
    for side in SIDES[faces]:
        out = side * reach
        # hands pull it in front; at the back, behind the jamb, they push it
        press = ag.frame((0.0, out + side * girth, 0.0), approach=(0.0, -side, 0.0))
        grasp = ag.frame((0.0, out, 0.0), approach=(0.0, -side, 0.0), closing=(1.0, 0.0, 0.0))
        name = "handle_front" if side < 0 else "handle_back"
        bodies.append(
            ag.part(
                back if side > 0 else back.rotate(ag.X, math.pi),  # upper and lower half are alike
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
