"""Valves of faucets with their handles: quarter-turn handles for hot and cold, and single levers for both.

Each is modeled about the z axis with its foot on z = 0; a single lever can be turned to any side.
"""

import math
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import polar
from artgen.categories.shared.finish import casting
from artgen.categories.shared.taps.stands import post

HandleStyle = Literal["lever", "blade", "cross", "knob"]
"""A round lever, a flat lever, a cross with balls, or a fluted knob."""

LeverStyle = Literal["rod", "blade", "paddle"]
"""The lever of a mixer: a round rod, a flat bar, or a widening blade."""

_QUARTER = 1.57  # turn of a ceramic disc from closed to open [rad]
_TURN = 0.9  # turn of a single lever to each side, to hot and to cold [rad]
_RISE = 0.22  # angle of a closed lever above the plane of its collar [rad]
_BONNET = 0.040  # height of the fixed part of a valve for one handle [m]
_DISC = feel.Feel(damping=0.03, armature=0.0002, effort=4.0)  # with the inertia of the spindle
_GAP = 0.0006  # gap between fixed and turning parts [m]
_RED = ag.material("enamel").with_(name="mark_red", base_color=(0.50, 0.02, 0.02), texture="")
_BLUE = ag.material("enamel").with_(name="mark_blue", base_color=(0.02, 0.07, 0.40), texture="")


def install_pair(
    body: ag.Body,
    valves: Sequence[ag.Vector],
    style: HandleStyle,
    length: ag.Scalar,
    finish: ag.Material,
    accent: ag.Material,
    friction: ag.Scalar,
    *,
    flange: bool,
    from_tip: bool,
    lean: float = 0.0,
) -> ag.Body:
    """Install valves for hot and cold with closed handles, which a hand turns from the tip or from above.

    Positive angles open them and move levers to the front. `lean` is the slope, to the front, of a hand from
    above, which clears a wall behind the valves.
    """
    for name, hot, at in zip(("left", "right"), (True, False), valves, strict=True):
        axis, limits = ag.Z if hot else -ag.Z, (0.0, _QUARTER)
        turn = ag.Revolute(f"handle_turn_{name}", axis=axis, limits=limits, feel=_DISC, friction=friction)
        one = _handle(style, length, finish, accent, hot=hot, from_tip=from_tip, lean=lean)
        body = ag.weld(body, _bonnet(finish, flange=flange).at(at)).attach(one, turn, at=at)
    return body


def _bonnet(finish: ag.Material, *, flange: bool) -> ag.Body:
    """Make the fixed part of a valve for one handle, which is welded to its base."""
    metal = casting(finish, 0.5)
    neck = ag.frustum(0.0185, 0.0165, _BONNET + 0.002, bevel=0.0008).align((0.0, 0.0, _BONNET), z=1)
    valve = post(neck, (0.0265, 0.0240, 0.008), metal, "valve") if flange else ag.part(neck, "valve", metal)
    ring, black = ag.ring(0.0169, 0.0150), ag.material("black_abs")
    groove = details.printed(
        ring, (0.0, 0.0, _BONNET), material=black, facing=ag.Z, label="valve", proud=0.0001
    )
    return ag.weld(valve, groove)


def _rod(length: ag.Scalar, thick: float) -> ag.Solid:
    """Make a slightly tapered round bar along x from the origin, with a round end."""
    shape = ((0.80, 0.0), (0.86, 0.5), (1.00, 0.88), (0.72, 0.985), (0.0, 1.0))
    outline = ag.spline([(radius * thick, 0.0, share * length) for radius, share in shape])
    return ag.revolve(ag.half_section(outline), axis=ag.X, sides=20)


def _handle(
    style: HandleStyle,
    length: ag.Scalar,
    finish: ag.Material,
    accent: ag.Material,
    *,
    hot: bool,
    from_tip: bool,
    lean: float,
) -> ag.Body:
    """Make a closed handle for one valve: a lever points to -x on the hot side, to x on the cold side."""
    low, side = _BONNET + _GAP, -1 if hot else 1
    foot, approach, closing = (0.0, 0.0, low), lean * ag.Y - ag.Z, ag.Y
    at: ag.VectorLike | None = None
    depth: float | None = None
    if style in ("lever", "blade"):
        tall = 0.020
        if style == "lever":
            arm = _rod(length, 0.0068).rotate(ag.Y, -0.13).at(z=low + 0.010)
        else:
            arm = ag.Region((0.0, length), (-0.0065, 0.0065), (0.007, 0.0145)).box(bevel=0.003).at(z=low)
        held = arm.rotate(ag.Z, math.pi if hot else 0.0)
        solids = [ag.cylinder(0.0165, tall, bevel=0.0035).align(foot, z=-1), held]
        if from_tip:
            approach, closing, depth = -side * ag.X, ag.Z, 0.028
        else:
            at = (0.74 * side * length, 0.0, low + 0.012)
    elif style == "cross":
        tall, reach, middle = 0.026, 0.54 * length, (0.0, 0.0, low + 0.015)
        held = ag.cylinder(0.0046, 2 * reach, axis=ag.X).at(middle)
        ends = [(reach, 0.0, 0.0), (-reach, 0.0, 0.0), (0.0, reach, 0.0), (0.0, -reach, 0.0)]
        balls = ag.array(ag.sphere(0.0066).at(middle), at=ends)
        hub = ag.frustum(0.0135, 0.0105, tall, bevel=0.002).align(foot, z=-1)
        solids = [hub, held, held.rotate(ag.Z, math.pi / 2), balls]
        at = (0.8 * side * reach, 0.0, low + 0.015)
    else:
        tall, depth = 0.031, 0.022
        held = ag.cylinder(0.0205, 0.026, bevel=0.005).align((0.0, 0.0, low + tall), z=1)
        solids = [held, ag.frustum(0.0155, 0.0185, 0.010).align(foot, z=-1)]
    name = "handle_left" if hot else "handle_right"
    hold = ag.grasp_on(held, approach=approach, closing=closing, at=at, depth=depth)
    body = ag.part(ag.union(*solids), "handle", casting(finish, 0.6), name=name, grasp=hold)
    high = low + tall
    if style == "knob":
        lobes = ag.extrude(_lobed(), 0.022, bevel=0.0012).align((0.0, 0.0, high - 0.002), z=1)
        body = ag.weld(body, ag.detail(lobes, "handle", finish))
    button = ag.cylinder(0.0088, 0.0022, bevel=0.0009).at(z=high + 0.0004)
    letter, ink = (ag.text("H", 0.0062), _RED) if hot else (ag.text("C", 0.0062), _BLUE)
    index = details.printed(letter, (0.0, -0.0031, high + 0.0015), material=ink, facing=ag.Z, label="index")
    return ag.weld(body, ag.detail(button, "index", accent), index)


def _lobed() -> ag.Profile:
    """Make the outline of a knob with eight lobes."""
    return polar([0.0217 + 0.0011 * math.cos(8 * math.tau * step / 64) for step in range(64)])


def running(body: ag.Body, *, pair: bool) -> ag.Body:
    """Let hot and cold water run as a pair of handles opens, or as the lever of a mixer is lifted.

    Turned to a side, the lever closes the other water.
    """
    if pair:
        hot, cold = signals.level("handle_turn_left"), signals.level("handle_turn_right")
    else:
        lift = signals.level("handle_lift")
        hot = lift & signals.level("handle_turn", (_TURN, 0.0))
        cold = lift & signals.level("handle_turn", (-_TURN, 0.0))
    return body.output("hot", hot, kind="flow").output("cold", cold, kind="flow")


def mixer(
    style: LeverStyle,
    length: ag.Scalar,
    finish: ag.Material,
    lift: ag.Scalar,
    friction: ag.Scalar,
    radius: ag.Scalar,
) -> ag.Body:
    """Make the top of a mixer with its lever: the seat, and the link `handle` with its two joints.

    The lever is on a ball, so that it can tilt and turn in a collar with an even gap. It points to the front;
    `handle_turn` turns it to each side for hot and cold, `handle_lift` lifts it to open.
    """
    ball = radius - 0.0026
    middle, start, metal = (0.0, 0.0, ball + _GAP), 0.55 * ball, casting(finish, 0.35)
    # the collar is visual only; the ball rises above the plane of the seat
    section = [(radius - 0.0018, -0.0010), (radius, -0.0010), (radius, 0.72 * ball),
               (radius - 0.0006, 0.76 * ball), (radius - 0.0018, 0.76 * ball)]  # fmt: skip
    collar = ag.revolve(ag.polygon(section))
    seat = ag.cylinder(radius - 0.0014, 0.0006).align((0.0, 0.0, 0.0), z=1)
    if style == "rod":
        arm = _rod(length - start, 0.0062).rotate(ag.Z, -math.pi / 2).at(0.0, -start)
    elif style == "blade":
        arm = ag.Region((-0.008, 0.008), (-length, -start), (-0.0035, 0.0035)).box(bevel=0.0028)
    else:
        outline = [(-0.0065, -start), (0.0065, -start), (0.0125, -length), (-0.0125, -length)]
        arm = ag.extrude(ag.polygon(outline, radius=0.004), 0.0065, bevel=0.0024)
    arm = arm.rotate(ag.X, -_RISE)
    out = ag.vector(0.0, -1.0, 0.0).rotate(ag.X, -_RISE)
    hold = ag.grasp_on(arm, approach=-ag.Z, closing=ag.X, at=out * (0.78 * length))
    tip, ring = (0.0, 0.0, ball - 0.0008), ag.ring(0.0030, 0.0014)
    dot = details.raised(ring, tip, material=_BLUE, facing=ag.Z, label="index", proud=0.0012)
    lever = ag.part(arm, "handle", casting(finish, 0.7), grasp=hold)
    body = ag.weld(lever, ag.part(ag.sphere(ball), "handle", metal), dot)
    fixed = ag.weld(ag.part(seat, "valve", metal), ag.detail(collar, "collar", finish))
    ball_joint = feel.Feel(damping=0.03, friction=friction, armature=0.0003, effort=4.0)
    turn = ag.Revolute("handle_turn", axis=ag.Z, limits=(-_TURN, _TURN), feel=ball_joint)
    tilt = ag.Revolute("handle_lift", axis=-ag.X, limits=(0.0, lift), feel=ball_joint)
    return fixed.attach(body, turn, tilt, at=middle)
