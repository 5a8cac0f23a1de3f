"""Valves of faucets with their handles: quarter-turn handles for hot and cold, and single levers for both.

Each is modeled about the z axis with its foot on z = 0; a single lever can be turned to any side.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import casting

HandleStyle = Literal["lever", "blade", "cross", "knob"]
"""A round lever, a flat lever, a cross with balls, or a fluted knob."""

LeverStyle = Literal["rod", "blade", "paddle"]
"""The lever of a mixer: a round rod, a flat bar, or a widening blade."""

QUARTER = 1.57
"""Turn of a ceramic disc from closed to open [rad]."""

TURN = 0.9
"""Turn of a single lever to each side, to hot and to cold [rad]."""

BONNET = 0.040
"""Height of the fixed part of a valve for one handle [m]."""

_GAP = 0.0006  # gap between fixed and turning parts [m]
_RED = ag.material("enamel").with_(name="mark_red", base_color=(0.50, 0.02, 0.02), texture="")
_BLUE = ag.material("enamel").with_(name="mark_blue", base_color=(0.02, 0.07, 0.40), texture="")


def bonnet(finish: ag.Material, *, flange: bool = True) -> ag.Body:
    """Make the fixed part of a valve for one handle, which is welded to its base."""
    metal = casting(finish, 0.5)
    neck = ag.frustum(0.0185, 0.0165, BONNET + 0.002, bevel=0.0008).align((0.0, 0.0, BONNET), z=1)
    bodies = [ag.part(neck, "valve", metal)]
    if flange:
        plate = ag.frustum(0.0265, 0.0240, 0.008, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
        bodies.insert(0, ag.part(plate, "escutcheon", metal))
    groove = ag.ring(0.0169, 0.0150)
    return ag.weld(
        *bodies,
        details.printed(
            groove,
            (0.0, 0.0, BONNET),
            material=ag.material("black_abs"),
            facing=ag.Z,
            label="valve",
            proud=0.0001,
        ),
    )


def _rod(length: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    """Make a slightly tapered round bar along x from the origin, with a round end."""
    outline = ag.spline(
        [
            (0.80 * thick, 0.0, 0.0),
            (0.86 * thick, 0.0, 0.5 * length),
            (1.00 * thick, 0.0, 0.88 * length),
            (0.72 * thick, 0.0, 0.985 * length),
            (0.0, 0.0, length),
        ]
    )
    return ag.revolve(ag.half_section(outline), axis=ag.X, sides=20)


def turning_handle(
    style: HandleStyle,
    *,
    finish: ag.Material,
    accent: ag.Material,
    length: ag.Scalar,
    hot: bool,
    name: str,
    from_tip: bool = False,
) -> ag.Body:
    """Make a closed handle for one valve: a lever points to -x on the hot side, to x on the cold side."""
    low = BONNET + _GAP
    metal = casting(finish, 0.6)
    side = -1 if hot else 1
    turned = math.pi if hot else 0.0
    high: ag.Scalar
    hub: ag.Solid
    arms: list[ag.Solid] = []
    match style:
        case "lever" | "blade":
            high = low + 0.020
            hub = ag.cylinder(0.0165, 0.020, bevel=0.0035).align((0.0, 0.0, low), z=-1)
            if style == "lever":
                arm = _rod(length, 0.0068).rotate(ag.Y, -0.13).at(0.0, 0.0, low + 0.010)
            else:
                arm = (
                    ag.Region.between((0.0, -0.0065, 0.007), (length, 0.0065, 0.0145))
                    .box(bevel=0.003)
                    .at(0, 0, low)
                )
            arm = arm.rotate(ag.Z, turned)
            arms = [arm]
            if from_tip:
                hold = ag.grasp_on(arm, approach=-side * ag.X, closing=ag.Z, depth=0.028)
            else:
                at = ag.vector(0.74 * side * length, 0.0, low + 0.012)
                hold = ag.grasp_on(arm, approach=-ag.Z, closing=ag.Y, at=at)
        case "cross":
            high = low + 0.026
            hub = ag.frustum(0.0135, 0.0105, 0.026, bevel=0.002).align((0.0, 0.0, low), z=-1)
            reach = 0.54 * length
            bar = ag.cylinder(0.0046, 2 * reach, axis=ag.X)
            arms = [bar.at(0.0, 0.0, low + 0.015), bar.rotate(ag.Z, 0.5 * math.pi).at(0.0, 0.0, low + 0.015)]
            ends: list[ag.VectorLike] = [
                (reach, 0.0, 0.0),
                (-reach, 0.0, 0.0),
                (0.0, reach, 0.0),
                (0.0, -reach, 0.0),
            ]
            arms.append(ag.array(ag.sphere(0.0066).at(0.0, 0.0, low + 0.015), at=ends))
            at = ag.vector(0.8 * side * reach, 0.0, low + 0.015)
            hold = ag.grasp_on(arms[0], approach=-ag.Z, closing=ag.Y, at=at)
        case "knob":
            high = low + 0.031
            hub = ag.cylinder(0.0205, 0.026, bevel=0.005).align((0.0, 0.0, high), z=1)
            arms = [ag.frustum(0.0155, 0.0185, 0.010).align((0.0, 0.0, low), z=-1)]
            hold = ag.grasp_on(hub, approach=-ag.Z, closing=ag.Y, depth=0.022)
    bodies = [ag.part(ag.union(hub, *arms), "handle", metal, name=name, grasp=hold)]
    if style == "knob":
        lobes = ag.extrude(_lobed(), 0.022, bevel=0.0012).align((0.0, 0.0, high - 0.002), z=1)
        bodies.append(ag.detail(lobes, "handle", finish))
    button = ag.cylinder(0.0088, 0.0022, bevel=0.0009).at(0.0, 0.0, high + 0.0004)
    letter = ag.text("H" if hot else "C", 0.0062)
    bodies.append(ag.detail(button, "index", accent))
    bodies.append(
        details.printed(
            letter, (0.0, -0.0031, high + 0.0015), material=_RED if hot else _BLUE, facing=ag.Z, label="index"
        )
    )
    return ag.weld(*bodies)


def _lobed() -> ag.Profile:
    """Make the outline of a knob with eight lobes."""
    angles = [math.tau * step / 64.0 for step in range(64)]
    radii = [0.0217 + 0.0011 * math.cos(8.0 * angle) for angle in angles]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def quarter_turn(
    name: str, *, hot: bool, friction: ag.Scalar, pivot: ag.VectorLike = (0.0, 0.0, 0.0)
) -> ag.Joint:
    """Make the joint of a handle; positive opens it and moves a lever to the front."""
    return ag.Revolute(
        name,
        axis=ag.Z if hot else -ag.Z,
        pivot=pivot,
        limits=(0.0, QUARTER),
        friction=friction,
        damping=0.03,
        armature=0.0002,  # inertia of the spindle and the disc
        effort=4.0,
    )


def mixer(
    style: LeverStyle,
    *,
    radius: ag.Scalar,
    length: ag.Scalar,
    rise: ag.Scalar,
    finish: ag.Material,
    lift: ag.Scalar,
    friction: ag.Scalar,
) -> ag.Body:
    """Make the top of a mixer with its lever: the seat, and the link `handle` with its two joints.

    The lever is on a ball, so that it can tilt and turn in a collar with an even gap. It points to the front;
    `handle_turn` turns it to each side for hot and cold, `handle_lift` lifts it to open.
    """
    ball = radius - 0.0026
    middle = ball + _GAP
    metal = casting(finish, 0.35)
    # the collar is visual only; the ball rises above the plane of the seat
    collar = ag.revolve(
        ag.polygon(
            [
                (radius - 0.0018, -0.0010),
                (radius, -0.0010),
                (radius, 0.72 * ball),
                (radius - 0.0006, 0.76 * ball),
                (radius - 0.0018, 0.76 * ball),
            ]
        )
    )
    seat = ag.cylinder(radius - 0.0014, 0.0006).align((0.0, 0.0, 0.0), z=1)
    start = 0.55 * ball
    match style:
        case "rod":
            arm = _rod(length - start, 0.0062).rotate(ag.Z, -0.5 * math.pi).at(0.0, -start, 0.0)
        case "blade":
            arm = ag.Region.between((-0.008, -length, -0.0035), (0.008, -start, 0.0035)).box(bevel=0.0028)
        case "paddle":
            outline = ag.polygon(
                [(-0.0065, -start), (0.0065, -start), (0.0125, -length), (-0.0125, -length)], radius=0.004
            )
            arm = ag.extrude(outline, 0.0065, bevel=0.0024)
    arm = arm.rotate(ag.X, -rise).at(0.0, 0.0, middle)
    out = ag.vector(0.0, -1.0, 0.0).rotate(ag.X, -rise)
    at = ag.vector(0.0, 0.0, middle) + out * (0.78 * length)
    hold = ag.grasp_on(arm, approach=-ag.Z, closing=ag.X, at=at)
    body = ag.weld(
        ag.part(arm, "handle", casting(finish, 0.7), grasp=hold),
        ag.part(ag.sphere(ball).at(0.0, 0.0, middle), "handle", metal),
        details.raised(
            ag.ring(0.0030, 0.0014),
            (0.0, 0.0, middle + ball - 0.0008),
            material=_BLUE,
            facing=ag.Z,
            label="index",
            proud=0.0012,
        ),
    )
    pivot = ag.vector(0.0, 0.0, middle)
    turn = ag.Revolute(
        "handle_turn",
        axis=ag.Z,
        pivot=pivot,
        limits=(-TURN, TURN),
        friction=friction,
        damping=0.03,
        armature=0.0003,
        effort=4.0,
    )
    raise_ = ag.Revolute(
        "handle_lift",
        axis=-ag.X,
        pivot=pivot,
        limits=(0.0, lift),
        friction=friction,
        damping=0.03,
        armature=0.0003,
        effort=4.0,
    )
    fixed = ag.weld(ag.part(seat, "valve", metal), ag.detail(collar, "collar", finish))
    return fixed.attach(body, turn, raise_)
