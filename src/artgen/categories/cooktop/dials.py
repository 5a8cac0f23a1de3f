"""The dials of a cooktop: on rotary switches, or on gas taps that turn only after a push.

The stem of a gas tap has a disc under the plate. While the gas is off, a pin of the plate is in a notch of
the disc. Pushed in, the disc passes under the pin and turns; the pin then holds the dial in as long as the
gas is on, and the dial comes out again at the notch.
"""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.controls import DialStyle, control_knob, dial_print
from artgen.categories.shared.cooktops import SIGN, Plan

SWEEP = 4.7
"""Turn of a dial from off to its end [rad]."""

HOLE = 0.011
"""Width of the square hole in the plate for the stem of a tap [m]."""

ROOM = 0.012
"""Length of a tap below the plate's underside [m]."""

_STEM = 0.0042  # radius of the stem [m]
_DISC = 0.0100  # half the width of the disc under the plate [m]
_DISC_THICK = 0.003
_UNDER = 0.0005  # gap from the plate's underside to the disc [m]
_CLEAR = 0.0002  # gap between pin and disc while a dial is pushed in [m]
# half the width of the pin, and the distances of its start and end behind the axis [m]
_PIN = (0.0015, 0.0060, 0.0088)
_NOTCH = 0.0020  # half the width of the notch [m]
_FACE = -1.5707963267948966  # rotation that turns the front face up [rad]

Scale = Literal["numbers", "ticks", "band"]
"""Print around the dial of an electric burner."""


@dataclass(frozen=True)
class DialLooks:
    """Finish and print of dials."""

    style: DialStyle  # shape of the dials
    finish: ag.Material  # material of the dials
    mark: ag.Material  # material of their marks
    cap: ag.Material  # metal of caps and bezels
    ink: ag.Material  # material of print on the plate
    scale: Scale  # print around the dials


@dataclass(frozen=True)
class Push:
    """Push of a gas dial."""

    travel: ag.Scalar  # travel of the push [m]
    force: ag.Scalar  # spring force at the end of the push [N]


def dial_on(
    plan: Plan, looks: DialLooks, *, top: ag.Scalar, lift: ag.Scalar = 0.0, name: str, label: str
) -> ag.Body:
    """Make an upward-facing dial about the z axis, with its mark at the back."""
    one = control_knob(
        finish=looks.finish,
        style=looks.style,
        radius=plan.radius,
        depth=0.021,
        mark=looks.mark,
        cap=looks.cap,
        name=name,
        label=label,
    )
    return one.rotate(ag.X, _FACE).at(0.0, 0.0, top + lift)


def electric_turn(name: str, *, friction: ag.Scalar, pivot: ag.VectorLike = (0.0, 0.0, 0.0)) -> ag.Joint:
    """Make the joint of a dial on a rotary switch; positive turns it clockwise from off."""
    return ag.Revolute(
        name,
        axis=-ag.Z,
        pivot=pivot,
        limits=(0.0, SWEEP),
        friction=friction,
        damping=0.003,
        armature=0.00002,  # inertia of the shaft and the contacts
        effort=0.6,  # two fingers at a radius of 15-20 mm, 20 N each
    )


def tap_dial(plan: Plan, looks: DialLooks, push: Push, *, top: ag.Scalar, thick: ag.Scalar) -> ag.Body:
    """Make the dial of a gas tap with its stem and disc, about the z axis: the link `burner_dial`."""
    knob = dial_on(plan, looks, top=top, lift=push.travel, name="burner_dial", label="burner_dial")
    high = top - thick - _UNDER
    low = high - _DISC_THICK
    stem = ag.cylinder(_STEM, top + push.travel + 0.002 - low).align((0.0, 0.0, low), z=-1)
    inner, back = _PIN[1] - 0.0008, _DISC
    disc = ag.union(
        ag.Region.between((-_DISC, -_DISC, low), (_DISC, inner, high)).box(),
        ag.Region.between((-_DISC, inner, low), (-_NOTCH, back, high)).box(),
        ag.Region.between((_NOTCH, inner, low), (_DISC, back, high)).box(),
    )
    steel = looks.cap if looks.cap.base_metalness > 0.5 else looks.finish
    return ag.weld(knob, ag.part(ag.union(stem, disc), "burner_dial", steel))


def tap_joints(push: Push, *, friction: ag.Scalar) -> tuple[ag.Joint, ag.Joint]:
    """Make the joints of a gas dial: the push, then the turn, counterclockwise from off.

    The spring force is that of real taps, 2.5 N at rest and 8-14 N pushed in [EN 1106: a tap opens at no more
    than 0.4 N m and 20 N].
    """
    preload = 2.5
    stiffness = (push.force - preload) / push.travel
    down = ag.Prismatic(
        "burner_dial_push",
        axis=-ag.Z,
        limits=(0.0, push.travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=20.0,  # damping of grease: with less, the disc strikes the plate on its way out, and turns
        friction=0.4,
        # inertia of spindle and spring: with less, solvers push the light part through its limit
        armature=0.05,
        effort=30.0,
    )
    turn = ag.Revolute(
        "burner_dial_turn",
        axis=ag.Z,
        limits=(0.0, SWEEP),
        friction=friction,  # friction of the greased cone
        damping=0.004,
        armature=0.00002,
        effort=0.4,
        needs=down > push.travel - _CLEAR / 2.0,
    )
    return down, turn


def tap_pin(push: Push, *, top: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    """Make the pin that goes from the plate into the notch of the disc, about the z axis."""
    half, near, far = _PIN
    high = top - thick + 0.0005
    low = top - thick - _UNDER - push.travel + _CLEAR
    return ag.Region.between((-half, near, low), (half, far, high)).box()


def tap_hole(top: ag.Scalar) -> ag.Solid:
    """Make the cutter for the hole of a stem in the plate, about the z axis."""
    return ag.box(HOLE, HOLE, 0.05).at(0.0, 0.0, top)


def bezels(plan: Plan, looks: DialLooks, *, top: ag.Scalar) -> ag.Body:
    """Make the flat rings around the dials of gas taps, visual only."""
    flat = details.relief(
        ag.ring(plan.radius + 0.0022, 0.0078), (0.0, 0.0, top), facing=ag.Z, proud=0.0004, bevel=0.0002
    )
    at = [(x, y, 0.0) for x, y in plan.dial_places[: plan.burners]]
    return ag.detail(ag.array(flat, at=at), "bezel", looks.cap)


def signs(plan: Plan, looks: DialLooks, *, top: ag.Scalar, extras: tuple[str, ...]) -> ag.Body:
    """Print a sign beside each dial: rings for all burners with the dial's own one filled, or an icon."""
    left, right, front, back = plan.field
    middle = (0.5 * (left + right), 0.5 * (front + back))
    flat = plan.rows == 1
    scale = SIGN / (right - left)
    rise = 0.0 if flat else 0.6 * SIGN / (back - front)
    at = [((p.x - middle[0]) * scale, (p.y - middle[1]) * rise) for p in plan.places]
    size, step = 0.0017, plan.sign_step
    signs_at = [(x + step[0], y + step[1]) for x, y in plan.dial_places]
    rings = details.relief(ag.ring(size, size - 0.0005), (0.0, 0.0, top), facing=ag.Z, proud=0.0002)
    dot = details.relief(ag.circle(size), (0.0, 0.0, top), facing=ag.Z, proud=0.0003)
    own = [(x + i, y + j, 0.0) for (x, y), (i, j) in zip(signs_at, at, strict=False)]
    others = [
        (x + i, y + j, 0.0)
        for dial, (x, y) in enumerate(signs_at[: plan.burners])
        for burner, (i, j) in enumerate(at)
        if burner != dial
    ]
    icons = [
        details.printed(details.icon(name, 0.009), (x, y, top), material=looks.ink, facing=ag.Z)
        for name, (x, y) in zip(extras, signs_at[plan.burners :], strict=False)
    ]
    return ag.weld(
        *([ag.detail(ag.array(rings, at=others), "print", looks.ink)] if others else []),
        ag.detail(ag.array(dot, at=own), "print", looks.ink),
        *icons,
    )


def scales(plan: Plan, looks: DialLooks, *, top: ag.Scalar, gas: bool) -> ag.Body:
    """Print the scales around all dials."""
    radius = plan.radius
    bodies = []
    for number, (x, y) in enumerate(plan.dial_places):
        at = ag.vector(x, y, top)
        if gas and number < plan.burners:
            bodies.append(_flames(radius, looks.ink).at(at))
            continue
        style: Scale = looks.scale if number < plan.burners else "ticks"
        # nine steps; the space at off, the mark's position at rest, is free
        one = dial_print(
            radius,
            ink=looks.ink,
            style=style,
            count=9 if style == "numbers" else 6,
            sweep=SWEEP * 8.0 / 9.0,
            start=SWEEP / 9.0,
            height=0.0027,
        )
        zero = details.printed(
            ag.ring(0.0012, 0.0007).at(0.0, radius + 0.0042), (0.0, 0.0, 0.0), material=looks.ink
        )
        bodies.append(ag.weld(one, zero).rotate(ag.X, _FACE).at(at))
    return ag.weld(*bodies)


def _flames(radius: ag.Scalar, ink: ag.Material) -> ag.Body:
    """Print the scale of a tap: off at the back, a large flame at the left, a small one at the right."""
    off = ag.ring(0.0015, 0.0010).at(0.0, radius + 0.0048)
    large = details.icon("flame", 0.0062, weight="bold").at(-radius - 0.0052, 0.0)
    small = details.icon("flame", 0.0038).at(radius + 0.0050, 0.0)
    band = details.dial_band(radius + 0.0026, 0.0004, 0.0016, sweep=2.3, start=1.99)
    return details.printed(off | large | small | band, (0.0, 0.0, 0.0), material=ink, facing=ag.Z)
