"""The lever of a toaster and the carriage that rides with it: one rigid link, pushed down against a spring.

The lever is drawn about the axis of its arm on the plane y = 0, which is the face of the control panel.
"""

from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen.categories.toaster.plan import Plan

LeverStyle = Literal["tab", "bar", "ball", "tee", "paddle"]
"""A flat tab, a round bar across, a ball, a square bar on a neck, or a wide paddle."""

ARM = (0.003, 0.010)
"""Width and height of the arm between a lever and its carriage [m]."""

_PLAY = (0.0011, 0.0016)  # between the arm and its slit, to the sides and at the ends [m]
_OUT = 0.0095  # from the panel to a lever, so that buttons stay clear of it [m]
_PRONGS = 0.016  # width of the prongs under the bread [m]
_STEEL = 0.0030  # thickness of the bars of a carriage [m]
_LOW = 0.0185  # how far over the floor of the sleeve a carriage ends, over the crumb tray [m]
_ENDS = 0.004  # from a carriage to the ends of its slot [m]


def slit(travel: ag.Scalar) -> ag.Profile:
    """Return the outline of the slit in the panel, about the arm at rest."""
    wide, tall = ARM[0] + 2 * _PLAY[0], travel + ARM[1] + 2 * _PLAY[1]
    return ag.rectangle(wide, tall, radius=0.0012).at(0.0, -0.5 * travel)


def lever_slide(name: str, *, travel: ag.Scalar, force: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
    """Make the joint of a lever; positive moves it down, where no magnet holds it without power.

    The spring of a toaster lifts the carriage with bread (about 0.15 kg), and takes 10-25 N at the bottom.
    """
    preload = 0.42 * force  # 4-10 N, over its own weight of 1-3 N
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=-ag.Z,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.4,  # of the carriage on its guide rod
        armature=0.02,  # the spring
        effort=45.0,
    )


def lever(
    style: LeverStyle, *, finish: ag.Material, accent: ag.Material, slim: bool, name: str = "lever"
) -> ag.Body:
    """Make what a hand presses down, about the arm, in front of the panel."""
    bodies: list[ag.Body] = []
    share = 0.62 if slim else 1.0
    match style:
        case "tab":
            held = ag.box(0.030 * (0.8 if slim else 1.0), 0.021, 0.0085, bevel=0.003)
            rest = [held.at(0.0, -_OUT - 0.0105, 0.0)]
            bodies += [_inlay(0.012, -_OUT - 0.021, 0.0024, accent)]
        case "bar":
            held = ag.cylinder(0.0068, 0.050 * share, axis=ag.X, bevel=0.0018)
            rest = [held.at(0.0, -_OUT - 0.0128, 0.0), _neck(0.010)]
            cuff = ag.cylinder(0.0071, 0.0022, axis=ag.X, bevel=0.0004)
            ends = [(side * (0.019 * share), -_OUT - 0.0128, 0.0) for side in (-1, 1)]
            bodies += [ag.detail(ag.array(cuff, at=ends), "lever", accent)]
        case "ball":
            held = ag.sphere(0.0118)
            rest = [held.at(0.0, -_OUT - 0.0135, 0.0), _neck(0.008)]
        case "tee":
            held = ag.box(0.048 * share, 0.0115, 0.0125, bevel=0.0028)
            rest = [held.at(0.0, -_OUT - 0.0155, 0.0), _neck(0.015)]
            bodies += [_inlay(0.030 * share, -_OUT - 0.02125, 0.0022, accent)]
        case "paddle":
            held = ag.box(0.062 * (0.56 if slim else 1.0), 0.0195, 0.0115, bevel=0.0042)
            rest = [held.at(0.0, -_OUT - 0.00975, 0.0)]
            bodies += [_inlay(0.026, -_OUT - 0.0195, 0.0018, accent)]
    hold: ag.Frame = ag.grasp_on(rest[0], approach=ag.Y, closing=ag.X)
    press: ag.Frame = ag.push_on(rest[0], direction=-ag.Z)
    parts = [ag.part(rest[0], "lever", finish, name=name, grasp=hold, push=press)]
    return ag.weld(*parts, *(ag.part(each, "lever", accent) for each in rest[1:]), *bodies)


def _neck(length: float) -> ag.Solid:
    """Make the round neck between the slit's plane and a lever."""
    return ag.cylinder(0.0042, length, axis=ag.Y, bevel=0.0008).at(0.0, -_OUT + 0.003 - length / 2, 0.0)


def _inlay(wide: float, face: float, tall: float, accent: ag.Material) -> ag.Body:
    """Make the bright line on the front of a lever."""
    return ag.detail(ag.box(wide, 0.0010, tall, bevel=0.0003).at(0.0, face, 0.0), "lever", accent)


def arm(reach: ag.Scalar) -> ag.Body:
    """Make the arm that goes from a lever through its slit to y = `reach` behind the panel."""
    near = -_OUT - 0.0012  # not under a finger that presses the middle of a flat lever
    wide, high = ARM[0] / 2, ARM[1] / 2
    bar = ag.board((-wide, wide), (near, reach), (-high, high), bevel=0.0008)
    return ag.part(bar, "carriage", ag.material("steel"))


def carriage(
    plan: Plan, middles: Sequence[ag.Float], *, post: ag.Scalar, height: ag.Scalar, travel: ag.Scalar
) -> ag.Body:
    """Make the carriage of one lever at rest, with the slots along y, to be welded to the lever."""
    level = plan.floor + _LOW + _STEEL / 2 + travel
    begin, end = plan.chamber
    front, back = plan.bay, end - _ENDS
    upright = ag.box(0.014, _STEEL, height - level + 0.010).at(post, front, 0.5 * (height + level) + 0.0035)
    left, right = ag.min_(middles[0], post) - 0.004, ag.max_(middles[-1], post) + 0.004
    thin, half = _STEEL / 2 - 0.0003, _STEEL / 2
    cross = ag.board((left, right), (front - thin, front + thin), (level - 0.0012, level + 0.0062))
    rail = ag.board((-half, half), (front, back), (level - 0.0015, level + 0.0045))
    count = 8 if plan.long else 5
    first, last = begin + _ENDS + 0.002, back - 0.002
    prong = ag.capsule(0.0012, _PRONGS, axis=ag.X).at(0.0, first, level + 0.0045)
    prongs = ag.array(prong, at=ag.row((0.0, 0.0, 0.0), (0.0, (last - first) / (count - 1), 0.0), count))
    places = [(x, 0.0, 0.0) for x in middles]
    steel = ag.material("steel")
    return ag.weld(
        ag.part(ag.union(upright, cross), "carriage", steel),
        ag.part(ag.array(rail, at=places), "carriage", steel),
        ag.part(ag.array(prongs, at=places), "carriage", steel),
    )
