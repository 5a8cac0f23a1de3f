"""Arms of lamps: swivels on the base, bars between the hinges, and joints that hold their loads.

Hinges have their axis along y. Parts alternate between two lanes, so that parts at a hinge never touch at any
angle: the inner lane is 10 mm wide about y = 0, the outer lane has a pair of plates or rods beside it.
"""

import math
from typing import Literal

import artgen as ag

ArmStyle = Literal["rods", "tube", "flat"]
"""Thin round bars, a round tube or square bars, or flat bars."""

ARM_LABELS = ("swivel", "slider", "arm_lower", "arm_upper", "hinge", "spring")
"""Labels of arms and swivels."""

GRAVITY = 9.81
"""Gravity [m/s2]."""

INNER = 0.005
"""Half the width of the inner lane [m]."""

EYE = 0.0105
"""Radius of the round ends of arms about their hinges [m]."""

TURRET = 0.0006
"""Gap below a part that turns on the base [m]."""

_OUTER = 0.0075  # middle of the plates and rods of the outer lane [m]
_PLATE = 0.004  # thickness of the plates [m]
_HOLDS = 1.3  # ratio of the torque of a brake to its load
_SOFT = 0.2  # variation of the torque of a balancing spring over the range, as a share of the friction


def eyes(finish: ag.Material, *, label: str, outer: bool) -> list[ag.Body]:
    """Make the round end of an arm about the origin, in the inner or the outer lane."""
    if not outer:
        return [ag.part(ag.cylinder(EYE, 2.0 * INNER, axis=ag.Y, bevel=0.0008), label, finish)]
    plate = ag.cylinder(EYE, _PLATE, axis=ag.Y, bevel=0.0006)
    nut = ag.cylinder(0.0062, 0.0045, axis=ag.Y, bevel=0.001)
    return [
        ag.part(ag.array(plate, at=[(0.0, -_OUTER, 0.0), (0.0, _OUTER, 0.0)]), label, finish, separate=_PAIR),
        ag.detail(
            ag.array(nut, at=[(0.0, side * (_OUTER + 0.0038), 0.0) for side in (-1, 1)]), "hinge", finish
        ),
    ]


_PAIR = "the two plates of a pair are held by the bolts through them"


def arm_bar(style: ArmStyle, length: ag.Scalar, *, outer: bool) -> ag.Solid:
    """Make the bar or the pair of bars of an arm, up from its hinge at the origin to the next hinge."""
    width = _PLATE if outer else 2.0 * INNER
    match style:
        case "rods":
            bar = ag.cylinder(0.0020 if outer else 0.0042, length)
        case "tube":
            bar = (
                ag.box(_PLATE, 0.0085, length, bevel=0.0009).rotate(ag.Z, math.pi / 2)
                if outer
                else ag.cylinder(INNER, length)
            )
        case "flat":
            bar = ag.box(0.015, width - 0.0004, length, bevel=0.0012)
    if not outer:
        return bar.at(0.0, 0.0, length / 2.0)
    return ag.array(bar, at=[(0.0, side * _OUTER, length / 2.0) for side in (-1, 1)])


def arm(
    label: str,
    style: ArmStyle,
    length: ag.Scalar,
    *,
    finish: ag.Material,
    outer: bool,
    spring: ag.Material | None = None,
) -> ag.Body:
    """Make an arm, up from its hinge at the origin; its load turns in the other lane."""
    middle = ag.frame((0.0, 0.0, 0.5 * length), approach=ag.Y, closing=(1.0, 0.0, 0.0))
    bar = arm_bar(style, length, outer=outer)
    bodies = [ag.part(bar, label, finish, grasp=middle, separate=_PAIR if outer else "")]
    for level in (0.0, length):
        bodies += [each.at(0.0, 0.0, level) for each in eyes(finish, label=label, outer=outer)]
    if outer:  # spacers between the bars of the pair
        spacer = ag.cylinder(0.0040, 2.0 * _OUTER, axis=ag.Y)
        bodies += [ag.part(spacer.at(0.0, 0.0, share * length), label, finish) for share in (0.35, 0.72)]
    if spring is not None:
        bodies += _springs(style, length, spring, outer=outer)
    return ag.weld(*bodies)


def _springs(style: ArmStyle, length: ag.Scalar, metal: ag.Material, *, outer: bool) -> list[ag.Body]:
    """Make the springs beside an arm: between its bars, or at both sides of a single bar."""
    low, long = 0.16 * length, 0.40 * length
    radius = 0.0036
    coil = ag.sweep(ag.circle(0.0007), ag.helix(radius, long / 22.0, 22.0))
    wire = ag.cylinder(0.0007, 0.62 * length).at(0.0, 0.0, 0.37 * length)
    one = [coil.at(0.0, 0.0, low + long / 2.0), wire]
    if outer:
        return [ag.detail(each, "spring", metal) for each in one]
    aside = (0.0042 if style == "rods" else INNER) + radius - 0.0002
    pins = [
        ag.cylinder(0.0018, 2.0 * aside + 0.004, axis=ag.Y).at(0.0, 0.0, share * length)
        for share in (0.07, 0.68)
    ]
    return [
        *(
            ag.detail(ag.array(each, at=[(0.0, side * aside, 0.0) for side in (-1, 1)]), "spring", metal)
            for each in one
        ),
        *(ag.detail(pin, "spring", metal) for pin in pins),
    ]


def turret(finish: ag.Material, *, height: ag.Scalar, outer: bool, radius: ag.Scalar = 0.024) -> ag.Body:
    """Make a swivel on a base: a disc with a post, and an eye at the given height, the link `swivel`.

    The swivel is above the plane z = 0, the top of the base, with a gap of 0.6 mm.
    """
    disc = ag.cylinder(radius, 0.010, bevel=0.002).at(0.0, 0.0, TURRET + 0.005)
    bodies = [ag.part(disc, "swivel", finish)]
    start = TURRET + 0.006
    tall = height - start
    if outer:
        cheek = ag.box(0.018, _PLATE, tall, bevel=0.0008)
        pair = ag.array(cheek, at=[(0.0, side * _OUTER, start + tall / 2.0) for side in (-1, 1)])
        bodies.append(ag.part(pair, "swivel", finish, separate=_PAIR))
    else:
        post = ag.box(0.018, 2.0 * INNER, tall, bevel=0.0012).at(0.0, 0.0, start + tall / 2.0)
        bodies.append(ag.part(post, "swivel", finish))
    return ag.weld(
        *bodies, *(each.at(0.0, 0.0, height) for each in eyes(finish, label="swivel", outer=outer))
    )


def turret_turn(*, friction: ag.Scalar, name: str = "arm_swivel") -> ag.Joint:
    """Make the joint by which an arm turns on its base, without limits; friction holds it."""
    return ag.Revolute(name, axis=ag.Z, friction=friction, damping=0.02, armature=0.0005, effort=12.0)


def bracket(finish: ag.Material, *, length: ag.Scalar, label: str = "shade") -> list[ag.Body]:
    """Make the plates in the outer lane between a shade and an arm, from z = 0 to -length."""
    plate = ag.box(0.016, _PLATE, length + 0.004, bevel=0.0008).at(0.0, 0.0, -0.5 * (length + 0.004))
    pair = ag.array(plate, at=[(0.0, side * _OUTER, 0.0) for side in (-1, 1)])
    return [ag.part(pair, label, finish, separate=_PAIR), *eyes(finish, label=label, outer=True)]


class Load:
    """Gravity load of a hinge about y: a sum of weights on levers."""

    def __init__(self) -> None:
        """Start without weights."""
        self.low: ag.Scalar = 0.0
        self.high: ag.Scalar = 0.0

    def lever(self, weight: ag.Scalar, length: ag.Scalar, low: ag.Scalar, high: ag.Scalar) -> "Load":
        """Add a weight [N] on a lever [m] with a range of angles from the vertical [rad].

        Angles are between -pi/2 and pi, positive towards +x.
        """
        crest = 1.0  # sine at the horizontal, if the range includes it
        ends = (ag.sin(low), ag.sin(high))
        self.low = self.low + weight * length * ag.min_(*ends)
        top = ag.max_(*ends)
        # between low and high the sine is greatest at the angle nearest to a quarter turn
        level = ag.max_(0.0, ag.min_(1.0, 1e6 * (ag.min_(high, math.pi - low) - math.pi / 2.0)))
        self.high = self.high + weight * length * (level * crest + (1.0 - level) * top)
        return self

    def free(self, weight: ag.Scalar, length: ag.Scalar) -> "Load":
        """Add a weight [N] on a lever [m] of any direction."""
        self.low = self.low - weight * length
        self.high = self.high + weight * length
        return self


def braked_hinge(
    name: str,
    *,
    pivot: ag.VectorLike,
    limits: tuple[ag.Scalar, ag.Scalar],
    load: Load,
    feel: ag.Scalar,
    reach: ag.Scalar,
    sprung: bool = False,
    damping: ag.Scalar = 0.05,
) -> ag.Joint:
    """Make a hinge about y that holds any angle under every pose of the arms beyond it.

    A brake alone exceeds the greatest torque of gravity. With a spring, the spring carries the mean of this
    torque and the brake holds the rest; the spring is long and soft, with a nearly constant torque over the
    range.
    """
    least = feel * reach
    low, high = limits
    if not sprung:
        most = ag.max_(load.high, -load.low)
        friction = ag.max_(_HOLDS * ag.max_(most, 0.0), least)
        effort = friction + ag.max_(most, 0.0) + 20.0 * reach
        return ag.Revolute(
            name,
            axis=ag.Y,
            pivot=pivot,
            limits=limits,
            friction=friction,
            damping=damping,
            armature=0.0005,
            effort=effort,
        )
    middle, rest = (load.low + load.high) / 2.0, (load.high - load.low) / 2.0
    friction = ag.max_(_HOLDS * rest / (1.0 - 0.5 * _HOLDS * _SOFT), least)
    stiffness = _SOFT * friction / (high - low)
    return ag.Revolute(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=limits,
        stiffness=stiffness,
        rest=(low + high) / 2.0 - middle / stiffness,
        friction=friction,
        damping=damping,
        armature=0.0005,
        effort=friction + 2.0 * rest + 20.0 * reach,
    )


def head_hinge(
    body: ag.Body, *, pivot: ag.VectorLike, limits: tuple[ag.Scalar, ag.Scalar], name: str = "shade_hinge"
) -> ag.Joint:
    """Make the hinge of a shade; its friction holds the shade in every direction."""
    lever = (body.center_of_mass() - vector_of(pivot)).norm()
    load = Load().free(GRAVITY * body.mass(), lever)
    return braked_hinge(name, pivot=pivot, limits=limits, load=load, feel=4.0, reach=0.08, damping=0.01)


def vector_of(point: ag.VectorLike) -> ag.VectorLike:
    """Return a point unchanged, as a handle or a tuple."""
    return point


def collar(finish: ag.Material, *, bore: ag.Scalar, out: ag.Scalar, height: ag.Scalar = 0.055) -> ag.Body:
    """Make the clamp that slides on a pole along z and carries an arm at x = out: the link `slider`."""
    ring = ag.tube(bore + 0.009, bore + 0.0006, height, bevel=0.0015)
    start = bore + 0.006
    plate = ag.box(out - start, _PLATE, 0.018, bevel=0.0008)
    pair = ag.array(plate, at=[((start + out) / 2.0, side * _OUTER, 0.0) for side in (-1, 1)])
    knob = ag.cylinder(0.013, 0.014, axis=(1.0, 0.0, 0.0), bevel=0.002)
    shaft = ag.cylinder(0.004, 0.016, axis=(1.0, 0.0, 0.0))
    back = -(bore + 0.009)
    return ag.weld(
        ag.part(ring, "slider", finish),
        ag.part(pair, "slider", finish, separate=_PAIR),
        ag.part(shaft.at(back - 0.006, 0.0, 0.0), "slider", finish),
        ag.part(
            knob.at(back - 0.018, 0.0, 0.0),
            "slider",
            finish,
            grasp=ag.frame((back - 0.019, 0.0, 0.0), approach=(1.0, 0.0, 0.0), closing=ag.Y),
        ),
        *(each.at(out, 0.0, 0.0) for each in eyes(finish, label="slider", outer=True)),
    )


def collar_joints(load: ag.Body, *, travel: ag.Scalar, friction: ag.Scalar) -> tuple[ag.Joint, ag.Joint]:
    """Make the joints of a clamp on its pole: a slide up from its lowest place, and a turn without limits.

    The clamp holds 1.3 times its load, and a hand slides it with less than 60 N.
    """
    grip = _HOLDS * GRAVITY * load.mass()
    slide = ag.Prismatic(
        "height_slide",
        axis=ag.Z,
        limits=(0.0, travel),
        friction=grip,
        damping=8.0,
        effort=GRAVITY * load.mass() + grip + 15.0,
    )
    turn = ag.Revolute("arm_swivel", axis=ag.Z, friction=friction, damping=0.03, armature=0.0005, effort=12.0)
    return slide, turn
