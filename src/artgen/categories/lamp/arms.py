"""Lamps with arms: one or two arms with a shade, an LED bar, an arm on a pole, and a bow; hinges with brakes.

Arms swing in the plane y = 0, from z = 0 up; angles are from the vertical, positive towards +x. Hinges have
their axis along y. Parts alternate between two lanes, so that parts at a hinge never touch at any angle: the
inner lane is 10 mm wide about y = 0, the outer lane has a pair of plates or rods beside it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.lamp.finish import hollow
from artgen.categories.lamp.shades import Head

ArmStyle = Literal["rods", "tube", "flat"]  # thin round bars, a round tube or square bars, or flat bars

LED = ag.material("led_white")  # strip of a bar
POLE = 0.0095  # radius of the pole for the arm of a reading lamp [m]

_INNER = 0.005  # half the width of the inner lane [m]
_EYE = 0.0105  # radius of the round ends of arms about their hinges [m]
_TURRET = 0.0006  # gap below a part that turns on the base [m]
_OUTER = 0.0075  # middle of the plates and rods of the outer lane [m]
_PLATE = 0.004  # thickness of the plates [m]
_PAIR = "the two plates of a pair are held by the bolts through them"
_HOLDS = 1.3  # ratio of the torque of a brake to its load
_SOFT = 0.2  # variation of the torque of a balancing spring over the range, as a share of the friction
_POST = 0.050  # height of the hinge of a lower arm above the base [m]
_HANG = 0.024  # distance from the hinge of a shade to the top of its housing [m]
_BESIDE = 0.0095  # half of the width of an arm plus 2 mm [m]
_OVER = 0.020  # least height of a shade above the hinge of the lowest arm [m]
_BACK = 0.26  # least backward turn of a shade [rad]
_UP = -1.25  # angle of a shade turned up [rad]
_TUBE = 0.0105  # radius of a bow [m]
_SWING = 0.6  # swing of the shade of a bow to each side, if the bow allows it [rad]
_LEAST_SWING = 0.1  # least swing of the shade of a bow to each side [rad]
_OFF = 0.004  # distance of a shade from its bow [m]
_TURN = 2.595  # angle along the ellipse of a bow, from its side [rad]
_STEPS = 9  # number of steps along the ellipse
_NO_RANGE = "has no range {}: change height, arm_length or shade_radius"


@dataclass(frozen=True)
class Arms:
    """Shade, style and sizes of arms; each lamp uses the sizes that apply to it."""

    head: Head
    style: ArmStyle
    finish: ag.Material
    length: ag.Scalar  # length of the lower or only arm [m]
    upper: ag.Scalar  # length of the upper arm, or of an LED bar [m]
    lean: ag.Scalar  # angle of the lower arm at rest [rad]
    rise: ag.Scalar  # angle of the upper arm at rest, from the vertical [rad]
    tilt: ag.Scalar  # forward tilt of a shade at rest [rad]
    reach: ag.Scalar  # reach of a bow [m]
    travel: ag.Scalar  # travel of a clamp on its pole [m]
    height: ag.Scalar  # height of a bow above the base [m]
    friction: ag.Scalar  # friction of the turn on the base [N m]

    def turn(self, damping: float = 0.02) -> ag.Joint:
        """Make the joint by which an arm turns on its base, without limits; friction holds it."""
        return ag.Revolute(
            "arm_swivel", axis=ag.Z, friction=self.friction, damping=damping, armature=0.0005, effort=12.0
        )

    def hung(self) -> tuple[ag.Body, ag.Float, ag.Float]:
        """Return the shade on its bracket about its hinge, its mass [kg] and its center's distance [m]."""
        long = _HANG + 0.004
        plates = _pair(ag.box(0.016, _PLATE, long, bevel=0.0008).at(z=-long / 2))
        bracket = _link("shade", self.finish, [plates], (0, 0, 0), outer=True)
        hung = ag.weld(self.head.body.at(z=-_HANG), bracket)
        return hung, hung.mass(), hung.center_of_mass().norm()


@dataclass(frozen=True)
class Carried:
    """Moving parts of a lamp, above its base."""

    body: ag.Body  # link that moves on the base, with all that it carries, from z = 0 up
    moment: ag.Scalar  # mass times the farthest reach of the parts [kg m]
    joints: tuple[ag.Joint, ...]  # joints between this link and the base
    hangs: ag.Scalar = 0.0  # distance below z = 0 that an arm of a reading lamp reaches with its shade [m]


class Load:
    """Gravity load of a hinge about y: a sum of weights on levers."""

    def __init__(self) -> None:
        """Start without weights."""
        self.low: ag.Scalar = 0.0
        self.high: ag.Scalar = 0.0

    def lever(self, weight: ag.Scalar, length: ag.Scalar, low: ag.Scalar, high: ag.Scalar) -> "Load":
        """Add a weight [N] on a lever [m] with a range of angles from the vertical, -pi/2 to pi [rad]."""
        ends = (ag.sin(low), ag.sin(high))
        self.low = self.low + weight * length * ag.min_(*ends)
        # between low and high the sine is greatest at the angle nearest to a quarter turn
        level = ag.max_(0.0, ag.min_(1.0, 1e6 * (ag.min_(high, math.pi - low) - math.pi / 2)))
        self.high = self.high + weight * length * (level + (1 - level) * ag.max_(*ends))
        return self

    def free(self, weight: ag.Scalar, length: ag.Scalar) -> "Load":
        """Add a weight [N] on a lever [m] of any direction."""
        self.low = self.low - weight * length
        self.high = self.high + weight * length
        return self

    def hinge(
        self,
        name: str,
        limits: tuple[ag.Scalar, ag.Scalar],
        *,
        force: float,
        reach: ag.Scalar,
        sprung: bool = False,
        damping: float = 0.05,
    ) -> ag.Joint:
        """Make a hinge about y that holds any angle; it needs a least `force` [N] at its `reach` [m].

        A brake alone exceeds the greatest torque of gravity. With a spring, the spring carries the mean of
        this torque and the brake holds the rest; the spring is long and soft, with a nearly constant torque.
        """
        low, high = limits
        stiffness: ag.Scalar = 0.0
        rest: ag.Scalar = 0.0
        if sprung:
            middle, half = (self.low + self.high) / 2, (self.high - self.low) / 2
            friction = ag.max_(_HOLDS * half / (1 - _HOLDS * _SOFT / 2), force * reach)
            stiffness = _SOFT * friction / (high - low)
            rest = (low + high) / 2 - middle / stiffness
            effort = friction + 2 * half + 20 * reach
        else:
            most = ag.max_(ag.max_(self.high, -self.low), 0.0)
            friction = ag.max_(_HOLDS * most, force * reach)
            effort = friction + most + 20 * reach
        drag = feel.Feel(friction=friction, damping=damping, armature=0.0005, effort=effort)
        return ag.Revolute(name, axis=ag.Y, limits=limits, stiffness=stiffness, rest=rest, feel=drag)


def _pair(solid: ag.Solid, out: float = _OUTER) -> ag.Solid:
    return ag.array(solid, at=[(0, -out, 0), (0, out, 0)])


def _link(
    label: str,
    finish: ag.Material,
    solids: Sequence[ag.Solid],
    *hinges: ag.VectorLike,
    outer: bool,
    grasp: ag.Frame | tuple[()] = (),
) -> ag.Body:
    """Make a part with round ends about its hinges, in the inner or the outer lane."""
    wide, bevel = (_PLATE, 0.0006) if outer else (2 * _INNER, 0.0008)
    eye = ag.cylinder(_EYE, wide, axis=ag.Y, bevel=bevel)
    eyes = [(_pair(eye) if outer else eye).at(each) for each in hinges]
    body = ag.part([*solids, *eyes], label, finish, grasp=grasp, separate=_PAIR if outer else "")
    if not outer:
        return body
    nuts = _pair(ag.cylinder(0.0062, 0.0045, axis=ag.Y, bevel=0.001), _OUTER + 0.0038)
    return ag.weld(body, ag.detail([nuts.at(each) for each in hinges], "hinge", finish))


def _arm(
    label: str, arms: Arms, length: ag.Scalar, *, outer: bool, spring: ag.Material | None = None
) -> ag.Body:
    """Make an arm, up from its hinge at the origin; its load turns in the other lane."""
    width = _PLATE if outer else 2 * _INNER
    if arms.style == "flat":
        bar = ag.box(0.015, width - 0.0004, length, bevel=0.0012)
    elif arms.style == "tube" and outer:
        bar = ag.box(_PLATE, 0.0085, length, bevel=0.0009).rotate(ag.Z, math.pi / 2)
    else:
        bar = ag.cylinder(_INNER if arms.style == "tube" else 0.0020 if outer else 0.0042, length)
    solids = [(_pair(bar) if outer else bar).at(z=length / 2)]
    if outer:  # spacers between the bars of the pair
        spacer = ag.cylinder(0.0040, 2 * _OUTER, axis=ag.Y)
        solids += [spacer.at(z=share * length) for share in (0.35, 0.72)]
    grip = ag.frame((0, 0, length / 2), approach=ag.Y, closing=ag.X)
    body = _link(label, arms.finish, solids, (0, 0, 0), (0, 0, length), outer=outer, grasp=grip)
    if spring is None:
        return body
    # springs are between the bars of a pair, or at both sides of a single bar
    radius, long = 0.0036, 0.40 * length
    coil = ag.sweep(ag.circle(0.0007), ag.helix(radius, long / 22, 22.0)).at(z=0.16 * length + long / 2)
    springs = [coil, ag.cylinder(0.0007, 0.62 * length).at(z=0.37 * length)]
    if not outer:
        aside = (0.0042 if arms.style == "rods" else _INNER) + radius - 0.0002
        pin = ag.cylinder(0.0018, 2 * aside + 0.004, axis=ag.Y)
        springs = [_pair(each, aside) for each in springs]
        springs += [pin.at(z=share * length) for share in (0.07, 0.68)]
    return ag.weld(body, ag.detail(springs, "spring", spring))


def _turret(finish: ag.Material, *, outer: bool) -> ag.Body:
    """Make a swivel above the plane z = 0, the top of the base: a disc with a post up to the hinge."""
    disc = ag.cylinder(0.024, 0.010, bevel=0.002).at(z=_TURRET + 0.005)
    start = _TURRET + 0.006
    wide, bevel = (_PLATE, 0.0008) if outer else (2 * _INNER, 0.0012)
    post = ag.box(0.018, wide, _POST - start, bevel=bevel).at(z=(start + _POST) / 2)
    return _link("swivel", finish, [disc, _pair(post) if outer else post], (0, 0, _POST), outer=outer)


def _steepest(cosine: ag.Scalar) -> ag.Float:
    """Return the angle with a given cosine [rad]."""
    held = ag.max_(-0.99, ag.min_(0.99, cosine))
    return ag.atan2(ag.sqrt(1 - held * held), held)


def _tip(length: ag.Scalar, angle: ag.Scalar) -> ag.Vector:
    return ag.vector(length * ag.sin(angle), 0, length * ag.cos(angle))


def _headed(arm: ag.Body, arms: Arms, at: ag.Vector, lean: ag.Scalar) -> ag.Body:
    """Attach a shade to the end of an arm with a lean angle; the shade points down and a little forward."""
    hung, mass, far = arms.hung()
    filled = arms.head.spread(_HANG, _BESIDE) + 0.03 - lean
    forward = ag.max_(arms.tilt, filled + _BACK)  # a wide shade points farther forward, away from its arm
    limits = (_UP, ag.min_(forward - filled, 1.1))
    load = Load().free(feel.GRAVITY * mass, far)
    hinge = load.hinge("shade_hinge", limits, force=4, reach=0.08, damping=0.01)
    return arm.attach(hung.rotate(ag.Y, -forward), hinge, at=at)


def _single(arms: Arms, low: ag.Scalar, high: ag.Scalar) -> tuple[ag.Body, ag.Joint, ag.Float]:
    """Make one arm with its shade about its hinge, with its joint and its mass without the shade."""
    _, mass, far = arms.hung()
    bar = _arm("arm_lower", arms, arms.length, outer=False)
    own, weight = bar.mass(), feel.GRAVITY * mass
    load = Load().lever(feel.GRAVITY * own, arms.length / 2, low, high).lever(weight, arms.length, low, high)
    limits = (low - arms.lean, high - arms.lean)
    hinge = load.free(weight, far).hinge("arm_lower_hinge", limits, force=5, reach=arms.length)
    body = _headed(bar.rotate(ag.Y, arms.lean), arms, _tip(arms.length, arms.lean), arms.lean)
    return body, hinge, own


def one_arm(arms: Arms) -> Carried:
    """Make an arm on a turret with a shade at its end."""
    _, mass, heavy = arms.hung()
    lowest = _steepest((arms.head.reach + _HANG + _OVER) / arms.length)
    arm, hinge, own = _single(arms, -ag.min_(0.6, lowest), lowest)
    body = _turret(arms.finish, outer=True).attach(arm, hinge, at=(0, 0, _POST))
    body = body.require(lowest - arms.lean > 0.2, "the arm " + _NO_RANGE.format("forward"))
    far = ag.sin(lowest) * arms.length
    return Carried(body, own * far / 2 + mass * (far + heavy), (arms.turn(),))


def two_arms(arms: Arms) -> Carried:
    """Make two arms on a turret, balanced by springs, with a shade at their end."""
    _, mass, heavy = arms.hung()
    lower, upper, lean = arms.length, arms.upper, arms.lean
    chrome = ag.material("chrome")
    first = _arm("arm_lower", arms, lower, outer=True, spring=chrome)
    second = _arm("arm_upper", arms, upper, outer=False, spring=chrome)
    own, beyond, weight = first.weight(), second.weight(), feel.GRAVITY * mass
    low, high = -lean - 0.42, 0.16
    # largest angle of the upper arm, with the lower arm at its limit
    folded = _steepest((arms.head.reach + _HANG + _OVER - lower * math.cos(high)) / upper)
    straight, bent, between = 0.45, folded - high, arms.rise + lean  # angles between the arms
    bent = ag.require(bent, bent - between > 0.1, "the upper arm " + _NO_RANGE.format("downward"))
    ends = (low + straight, ag.max_(high + bent, 1.6))
    above, below = Load(), Load().lever(own, lower / 2, low, high).lever(beyond + weight, lower, low, high)
    for load in (above, below):
        load.lever(beyond, upper / 2, *ends).lever(weight, upper, *ends).free(weight, heavy)
    limits: tuple[ag.Scalar, ag.Scalar] = (straight - between, bent - between)
    bend = above.hinge("arm_upper_hinge", limits, force=5, reach=upper, sprung=True)
    limits = (low + lean, high + lean)
    swing = below.hinge("arm_lower_hinge", limits, force=5, reach=lower, sprung=True, damping=0.1)
    second = _headed(second.rotate(ag.Y, arms.rise), arms, _tip(upper, arms.rise), arms.rise)
    chain = first.rotate(ag.Y, -lean).attach(second, bend, at=_tip(lower, -lean))
    body = _turret(arms.finish, outer=False).attach(chain, swing, at=(0, 0, _POST))
    far = lower * math.sin(high)
    moment = (own * far / 2 + beyond * (far + upper / 2) + weight * (far + upper + heavy)) / feel.GRAVITY
    return Carried(body, moment, (arms.turn(),))


def light_bar(arms: Arms) -> Carried:
    """Make an LED bar on an arm."""
    length, bar, lean = arms.length, arms.upper, arms.lean
    first, shade = _arm("arm_lower", arms, length, outer=True), _bar(arms.finish, bar)
    own, weight, heavy = first.weight(), shade.weight(), shade.center_of_mass().norm()
    low, high = -lean - 0.45, 0.40
    bent = ag.min_(_steepest((0.045 - length * math.cos(high)) / bar) - high, 2.2)
    straight, between = 0.35, math.pi / 2 + lean  # angles between the arm and the bar
    ends = (low + straight, ag.max_(high + bent, 1.6))
    limits: tuple[ag.Scalar, ag.Scalar] = (straight - between, bent - between)
    hinge = Load().lever(weight, heavy, *ends).hinge("shade_hinge", limits, force=4, reach=bar)
    below = Load().lever(own, length / 2, low, high).lever(weight, length, low, high)
    limits = (low + lean, high + lean)
    swing = below.lever(weight, heavy, *ends).hinge("arm_lower_hinge", limits, force=5, reach=length)
    chain = first.rotate(ag.Y, -lean)
    chain = chain.attach(shade.rotate(ag.Y, math.pi / 2), hinge, at=_tip(length, -lean))
    body = _turret(arms.finish, outer=False).attach(chain, swing, at=(0, 0, _POST))
    body = body.require(bent - between > 0.15, "the bar " + _NO_RANGE.format("downward"))
    far = length * math.sin(high)
    return Carried(body, (own * far / 2 + weight * (far + heavy)) / feel.GRAVITY, (arms.turn(),))


def _bar(finish: ag.Material, length: ag.Scalar) -> ag.Body:
    """Make the bar, up from its hinge; its light shines to +x, which is down when the bar is horizontal."""
    case = ag.Region.centered(0.011, 0.026, 0.0).with_(z=(0.045, length))
    neck = ag.cylinder_between((0, 0, 0), (0, 0, 0.049), 0.0042)
    glow = case.shrink(y=0.0035, z=0.008).with_(x=(case.x.high - 0.0006, case.x.high + 0.0010))
    grip = ag.frame(case.center, approach=ag.Y, closing=ag.X)
    light = finish.with_(name=f"{finish.name}_bar", density=900.0)
    return ag.weld(
        ag.part(case.box(bevel=0.003), "shade", light, grasp=grip),
        _link("shade", finish, [neck], (0, 0, 0), outer=False),
        ag.detail(glow.box(bevel=0.0006), "bulb", LED),
    )


def reading_arm(arms: Arms) -> Carried:
    """Make an arm on a clamp that slides and turns on a pole about z, with the clamp at z = 0."""
    _, mass, heavy = arms.hung()
    length, reach, out = arms.length, arms.head.reach + _HANG, POLE + 0.036
    # an upright arm would strike the pole with the shade: the hinge stays farther out than the shade's reach
    sine = (reach + POLE + 0.012 - out) / length
    strikes = "the shade strikes the pole: lower shade_radius, or raise arm_length or height"
    sine = ag.require(sine, sine < 0.95, strikes)
    low, high = ag.atan2(sine, ag.sqrt(1 - sine * sine)), 2.0
    arm, hinge, own = _single(arms, low, high)
    body = _clamp(arms.finish, out).attach(arm, hinge, at=(out, 0, 0))
    body = body.require(arms.lean - low > 0.15, "the arm " + _NO_RANGE.format("upward"))
    weight = body.weight()
    # a hand slides it with less than 60 N
    drag = feel.Feel(friction=_HOLDS * weight, damping=8.0, effort=(1 + _HOLDS) * weight + 15)
    slide = ag.Prismatic("height_slide", axis=ag.Z, limits=(0.0, arms.travel), feel=drag)
    moment = own * (out + length / 2) + mass * (out + length + heavy)
    return Carried(body, moment, (slide, arms.turn(0.03)), reach - length * math.cos(high))


def _clamp(finish: ag.Material, out: float) -> ag.Body:
    """Make the clamp that slides on a pole and carries an arm at x = out: the link `slider`."""
    start, back = POLE + 0.006, -(POLE + 0.009)
    plate = ag.box(out - start, _PLATE, 0.018, bevel=0.0008).at((start + out) / 2)
    solids = [
        ag.cylinder(0.013, 0.014, axis=ag.X, bevel=0.002).at(back - 0.018),  # knob
        ag.tube(-back, POLE + 0.0006, 0.055, bevel=0.0015),
        _pair(plate),
        ag.cylinder(0.004, 0.016, axis=ag.X).at(back - 0.006),
    ]
    grip = ag.frame((back - 0.019, 0, 0), approach=ag.X, closing=ag.Y)
    return _link("slider", finish, solids, (out, 0, 0), outer=True, grasp=grip)


def arc_arm(arms: Arms) -> Carried:
    """Make a bow with its shade: straight up, then more than a quarter of an ellipse."""
    reach, rise = arms.reach, 0.50 * arms.height
    wide, high = reach / (1 - math.cos(_TURN)), arms.height - rise
    turns = [_TURN * step / _STEPS for step in range(_STEPS + 1)]
    bend = [(wide * (1 - math.cos(turn)), 0, rise + high * math.sin(turn)) for turn in turns]
    end, before = ag.vector(*bend[-1]), ag.vector(*bend[-2])
    # the bow is in the inner lane beyond this point
    last = end + (before - end) * (0.034 / (before - end).norm())
    course = ag.spline([(0, 0, 0.018), (0, 0, 0.84 * rise), *bend[:-1], last])
    foot = ag.cylinder(2.3 * _TUBE, 0.022, bevel=0.003).at(z=_TURRET + 0.011)
    neck = ag.cylinder(0.0048, 0.040, axis=end - last).at((end + last) * 0.5)
    grip = ag.frame((0, 0, rise / 2), approach=ag.Y, closing=ag.X)
    bow = ag.weld(
        ag.part(ag.sweep(ag.circle(_TUBE), course), "arm_lower", hollow(arms.finish), grasp=grip),
        _link("arm_lower", arms.finish, [foot, neck], end, outer=False),
    )
    towards: ag.Scalar = _SWING  # swing of the shade to the bow
    for corner, below in arms.head.corners:
        deep = below + _HANG
        # position of the corner after the upward swing, and the position of the bow at this height
        level = end.z - deep * math.cos(_SWING) + corner * math.sin(_SWING)
        share = ag.clamp((level - rise) / high, 0.0, 1.0)
        room = reach - wide * (1 - ag.sqrt(1 - share * share)) - _TUBE - _OFF
        far = ag.sqrt(corner * corner + deep * deep)
        sine = ag.clamp(room / far, 0.0, 1.0)
        meets = ag.atan2(sine, ag.sqrt(1 - sine * sine)) - ag.atan2(corner, deep)
        towards = ag.min_(towards, ag.switch(room < far, meets, _SWING))
    strikes = "the shade would strike the bow: raise reach, or lower shade_radius or shade_height"
    limits = (-_SWING, ag.require(towards, towards > _LEAST_SWING, strikes))
    shade, mass, lever = arms.hung()
    load = Load().free(feel.GRAVITY * mass, lever)
    swing = load.hinge("shade_hinge", limits, force=4, reach=0.12, damping=0.02)
    moment = bow.mass() * 0.45 * reach + mass * (reach + lever)
    return Carried(bow.attach(shade, swing, at=end), moment, (arms.turn(),))


# the moving parts of each style with a metal head or an LED bar
MAKERS = {
    "desk": one_arm,
    "architect": two_arms,
    "led_bar": light_bar,
    "reading": reading_arm,
    "arc": arc_arm,
}
