"""Lamps with arms: desk lamps with one or two arms, an LED bar on an arm, and a reading lamp on its pole.

Arms swing in the plane y = 0. Angles are from the vertical, positive towards +x.
"""

import math
from dataclasses import dataclass

import artgen as ag
from artgen.categories.lamp.arms import (
    GRAVITY,
    ArmStyle,
    Load,
    arm,
    bracket,
    braked_hinge,
    collar,
    collar_joints,
    eyes,
    head_hinge,
    turret,
    turret_turn,
)
from artgen.categories.lamp.lampshades import Head

POST = 0.050
"""Height of the hinge of a lower arm above the base [m]."""

_HANG = 0.024  # distance from the hinge of a shade to the top of its housing [m]
_BESIDE = 0.0095  # half of the width of an arm plus 2 mm [m]
_OVER = 0.020  # least height of a shade above the hinge of the lowest arm [m]
_SPRING = ag.material("chrome")
_LIGHT = ag.material("led_white")
_BACK = 0.26  # least backward turn of a shade [rad]
_UP = -1.25  # angle of a shade turned up [rad]


@dataclass(frozen=True)
class Carried:
    """Moving parts of a lamp, above its base."""

    body: ag.Body  # link that moves on the base, with all that it carries, from z = 0 up
    moment: ag.Float  # mass times the farthest reach of the parts [kg m]
    joints: tuple[ag.Joint, ...]  # joints between this link and the base
    hangs: ag.Scalar = 0.0  # distance below z = 0 that an arm of a reading lamp reaches with its shade [m]


@dataclass(frozen=True)
class ArmLooks:
    """Style and friction of arms."""

    style: ArmStyle  # shape of the bars
    finish: ag.Material  # material of the bars
    swivel_friction: ag.Scalar  # friction of the turn on the base [N m]

    def turn(self) -> tuple[ag.Joint, ...]:
        """Make the joint between the arms and the base."""
        return (turret_turn(friction=self.swivel_friction),)


@dataclass(frozen=True)
class ArmSizes:
    """Sizes of arms; each lamp uses the sizes that apply to it."""

    length: ag.Scalar  # length of the lower or only arm [m]
    upper: ag.Scalar  # length of the upper arm, or of an LED bar [m]
    lean: ag.Scalar  # angle of the lower arm at rest [rad]
    rise: ag.Scalar  # angle of the upper arm at rest, from the vertical [rad]
    tilt: ag.Scalar  # forward tilt of a shade at rest [rad]
    reach: ag.Scalar  # reach of a bow [m]
    travel: ag.Scalar  # travel of a clamp on its pole [m]
    height: ag.Scalar  # height of a bow above the base [m]


def _steepest(cosine: ag.Scalar) -> ag.Float:
    """Return the angle with a given cosine [rad]."""
    held = ag.max_(-0.99, ag.min_(0.99, cosine))
    return ag.atan2(ag.sqrt(1.0 - held * held), held)


def _hung(head: Head, looks: ArmLooks) -> ag.Body:
    """Return a head with its bracket, with its hinge at the origin."""
    return ag.weld(head.body.at(0.0, 0.0, -_HANG), *bracket(looks.finish, length=_HANG))


def _tip(length: ag.Scalar, angle: ag.Scalar) -> tuple[ag.Scalar, float, ag.Scalar]:
    return (length * ag.sin(angle), 0.0, length * ag.cos(angle))


def _headed(
    body: ag.Body, hung: ag.Body, head: Head, *, at: ag.Vector, lean: ag.Scalar, tilt: ag.Scalar
) -> ag.Body:
    """Attach a head to the end of an arm with a lean angle; the head points down and a little forward."""
    filled = head.spread(_HANG, _BESIDE) + 0.03 - lean
    looks = ag.max_(tilt, filled + _BACK)  # a wide shade points farther forward, away from its arm
    placed = hung.rotate(ag.Y, -looks).at(at)
    return body.attach(placed, head_hinge(placed, pivot=at, limits=(_UP, ag.min_(looks - filled, 1.1))))


def one_arm(head: Head, looks: ArmLooks, *, length: ag.Scalar, lean: ag.Scalar, tilt: ag.Scalar) -> Carried:
    """Make an arm on a turret with a shade at its end."""
    hung = _hung(head, looks)
    weight, heavy = GRAVITY * hung.mass(), hung.center_of_mass().norm()
    reach = head.reach + _HANG
    lowest = _steepest((reach + _OVER) / length)
    back = -ag.min_(0.6, lowest)
    bar = arm("arm_lower", looks.style, length, finish=looks.finish, outer=False)
    own = bar.mass()
    placed = bar.rotate(ag.Y, lean).at(0.0, 0.0, POST)
    end = ag.vector(*_tip(length, lean)) + (0.0, 0.0, POST)
    placed = _headed(placed, hung, head, at=end, lean=lean, tilt=tilt)
    load = Load().lever(GRAVITY * own, length / 2.0, back, lowest).lever(weight, length, back, lowest)
    hinge = braked_hinge(
        "arm_lower_hinge",
        pivot=(0.0, 0.0, POST),
        limits=(back - lean, lowest - lean),
        load=load.free(weight, heavy),
        feel=5.0,
        reach=length,
    )
    body = turret(looks.finish, height=POST, outer=True).attach(placed, hinge)
    far = ag.sin(lowest) * length
    moment = own * far / 2.0 + hung.mass() * (far + heavy)
    return Carried(
        body.require(
            lowest - lean > 0.2, "the arm has no range forward: change height, arm_length or shade_radius"
        ),
        1.0 * moment,
        looks.turn(),
    )


def two_arms(
    head: Head,
    looks: ArmLooks,
    *,
    lower: ag.Scalar,
    upper: ag.Scalar,
    lean: ag.Scalar,
    rise: ag.Scalar,
    tilt: ag.Scalar,
) -> Carried:
    """Make two arms on a turret, balanced by springs, with a shade at their end."""
    hung = _hung(head, looks)
    weight, heavy = GRAVITY * hung.mass(), hung.center_of_mass().norm()
    reach = head.reach + _HANG
    first = arm("arm_lower", looks.style, lower, finish=looks.finish, outer=True, spring=_SPRING)
    second = arm("arm_upper", looks.style, upper, finish=looks.finish, outer=False, spring=_SPRING)
    own, beyond = GRAVITY * first.mass(), GRAVITY * second.mass()
    low, high = -lean - 0.42, 0.16
    folded = _steepest(
        (reach + _OVER - lower * math.cos(high)) / upper
    )  # largest angle of the upper arm, with the lower arm at its limit
    bent = folded - high  # angle between the arms
    straight = 0.45
    elbow = ag.vector(*_tip(lower, -lean)) + (0.0, 0.0, POST)
    end = elbow + ag.vector(*_tip(upper, rise))
    turned = second.rotate(ag.Y, rise).at(elbow)
    turned = _headed(turned, hung, head, at=end, lean=rise, tilt=tilt)
    between = rise + lean
    ends = (low + straight, ag.max_(high + bent, 1.6))
    above = Load().lever(beyond, upper / 2.0, *ends).lever(weight, upper, *ends).free(weight, heavy)
    bend = braked_hinge(
        "arm_upper_hinge",
        pivot=elbow,
        limits=(straight - between, bent - between),
        load=above,
        feel=5.0,
        reach=upper,
        sprung=True,
    )
    below = Load().lever(own, lower / 2.0, low, high).lever(beyond + weight, lower, low, high)
    below = below.lever(beyond, upper / 2.0, *ends).lever(weight, upper, *ends).free(weight, heavy)
    swing = braked_hinge(
        "arm_lower_hinge",
        pivot=(0.0, 0.0, POST),
        limits=(low + lean, high + lean),
        load=below,
        feel=5.0,
        reach=lower,
        sprung=True,
        damping=0.1,
    )
    chain = first.rotate(ag.Y, -lean).at(0.0, 0.0, POST).attach(turned, bend)
    body = turret(looks.finish, height=POST, outer=False).attach(chain, swing)
    far = lower * math.sin(high)
    moment = (own * far / 2.0 + beyond * (far + upper / 2.0) + weight * (far + upper + heavy)) / GRAVITY
    return Carried(
        body.require(
            bent - between > 0.1,
            "the upper arm has no range downward: change height, arm_length or shade_radius",
        ),
        1.0 * moment,
        looks.turn(),
    )


def light_bar(looks: ArmLooks, *, length: ag.Scalar, bar: ag.Scalar, lean: ag.Scalar) -> Carried:
    """Make an LED bar on an arm."""
    first = arm("arm_lower", looks.style, length, finish=looks.finish, outer=True)
    shade = _bar(looks.finish, bar)
    own, weight, heavy = GRAVITY * first.mass(), GRAVITY * shade.mass(), shade.center_of_mass().norm()
    low, high = -lean - 0.45, 0.40
    folded = _steepest((0.045 - length * math.cos(high)) / bar)
    bent = ag.min_(folded - high, 2.2)
    top = ag.vector(*_tip(length, -lean)) + (0.0, 0.0, POST)
    between = math.pi / 2.0 + lean
    straight = 0.35
    ends = (low + straight, ag.max_(high + bent, 1.6))
    hinge = braked_hinge(
        "shade_hinge",
        pivot=top,
        limits=(straight - between, bent - between),
        load=Load().lever(weight, heavy, *ends),
        feel=4.0,
        reach=bar,
    )
    below = Load().lever(own, length / 2.0, low, high).lever(weight, length, low, high)
    swing = braked_hinge(
        "arm_lower_hinge",
        pivot=(0.0, 0.0, POST),
        limits=(low + lean, high + lean),
        load=below.lever(weight, heavy, *ends),
        feel=5.0,
        reach=length,
    )
    chain = first.rotate(ag.Y, -lean).at(0.0, 0.0, POST)
    chain = chain.attach(shade.rotate(ag.Y, math.pi / 2.0).at(top), hinge)
    body = turret(looks.finish, height=POST, outer=False).attach(chain, swing)
    far = length * math.sin(0.40)
    moment = (own * far / 2.0 + weight * (far + heavy)) / GRAVITY
    return Carried(
        body.require(
            bent - between > 0.15, "the bar has no range downward: change height, arm_length or shade_radius"
        ),
        1.0 * moment,
        looks.turn(),
    )


def _bar(finish: ag.Material, length: ag.Scalar) -> ag.Body:
    """Make the bar, up from its hinge; its light shines to +x, which is down when the bar is horizontal."""
    start, thick, width = 0.045, 0.011, 0.026
    long = length - start
    middle = start + long / 2.0
    grip = ag.frame((0.0, 0.0, middle), approach=ag.Y, closing=(1.0, 0.0, 0.0))
    case = ag.box(thick, width, long, bevel=0.003).at(0.0, 0.0, middle)
    neck = ag.cylinder(0.0042, start + 0.004).at(0.0, 0.0, (start + 0.004) / 2.0)
    glow = ag.box(0.0016, width - 0.007, long - 0.016, bevel=0.0006).at(thick / 2.0 + 0.0002, 0.0, middle)
    return ag.weld(
        ag.part(case, "shade", finish.with_(name=f"{finish.name}_bar", density=900.0), grasp=grip),
        ag.part(neck, "shade", finish),
        ag.detail(glow, "bulb", _LIGHT),
        *eyes(finish, label="shade", outer=False),
    )


def reading_arm(
    head: Head,
    looks: ArmLooks,
    *,
    length: ag.Scalar,
    lean: ag.Scalar,
    tilt: ag.Scalar,
    bore: ag.Scalar,
    travel: ag.Scalar,
) -> Carried:
    """Make an arm on a clamp that slides and turns on a pole about z, with the clamp at z = 0."""
    hung = _hung(head, looks)
    weight, heavy = GRAVITY * hung.mass(), hung.center_of_mass().norm()
    reach = head.reach + _HANG
    out = bore + 0.036
    bar = arm("arm_lower", looks.style, length, finish=looks.finish, outer=False)
    own = bar.mass()
    # an upright arm would strike the pole with the shade: the hinge stays farther out than the shade's reach
    sine = (reach + bore + 0.012 - out) / length
    sine = ag.require(
        sine, sine < 0.95, "the shade strikes the pole: lower shade_radius, or raise arm_length or height"
    )
    low = ag.atan2(sine, ag.sqrt(1.0 - sine * sine))
    high = 2.0
    end = ag.vector(*_tip(length, lean)) + (out, 0.0, 0.0)
    placed = bar.rotate(ag.Y, lean).at(out, 0.0, 0.0)
    placed = _headed(placed, hung, head, at=end, lean=lean, tilt=tilt)
    load = Load().lever(GRAVITY * own, length / 2.0, low, high).lever(weight, length, low, high)
    hinge = braked_hinge(
        "arm_lower_hinge",
        pivot=(out, 0.0, 0.0),
        limits=(low - lean, high - lean),
        load=load.free(weight, heavy),
        feel=5.0,
        reach=length,
    )
    body = collar(looks.finish, bore=bore, out=out).attach(placed, hinge)
    body = body.require(
        lean - low > 0.15, "the arm has no range upward: change height, arm_length or shade_radius"
    )
    moment = own * (out + length / 2.0) + hung.mass() * (out + length + heavy)
    joints = collar_joints(body, travel=travel, friction=looks.swivel_friction)
    return Carried(body, 1.0 * moment, joints, reach - length * math.cos(high))
