"""The dials of a cooktop: on rotary switches, or on gas taps that turn only after a push.

The stem of a gas tap has a disc under the plate. While the gas is off, a pin of the plate is in a notch of
the disc. Pushed in, the disc passes under the pin and turns; the pin then holds the dial in as long as the
gas is on, and the dial comes out again at the notch.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.controls import DialStyle, control_knob, dial_print, ink_on
from artgen.categories.shared.cooktops import SIGN, Plan

SWEEP = 4.7
"""Turn of a dial from off to its end [rad]."""

Scale = Literal["numbers", "ticks", "band"]
"""Print around the dial of an electric burner."""

_DISC, _DISC_THICK = 0.0100, 0.003  # half the width of the disc under the plate, and its thickness [m]
_UNDER = 0.0005  # gap from the plate's underside to the disc [m]
_CLEAR = 0.0002  # gap between pin and disc while a dial is pushed in [m]
_PIN = 0.0060  # distance of the pin behind the axis [m]
# damping of grease: with less, the disc strikes the plate on its way out, and turns; inertia of spindle and
# spring: with less, solvers push the light part through its limit
_PUSH = feel.Feel(damping=20, friction=0.4, armature=0.05, effort=30)


@dataclass(frozen=True)
class Dials:
    """The dials of a cooktop, their print, and the height of the plate that carries them."""

    plan: Plan  # their places
    top: ag.Scalar  # height of the plate's upper face [m]
    style: DialStyle  # shape of the dials
    finish: ag.Material  # material of the dials
    cap: ag.Material  # metal of caps and bezels
    ink: ag.Material  # material of print on the plate
    scale: Scale  # print around the dials

    def knob(self, name: str, *, label: str = "burner_dial", lift: ag.Scalar = 0.0) -> ag.Body:
        """Make an upward-facing dial about the z axis, with its mark at the back."""
        one = control_knob(
            finish=self.finish,
            style=self.style,
            radius=self.plan.radius,
            depth=0.021,
            mark=ink_on(self.finish),
            cap=self.cap,
            name=name,
            label=label,
        )
        return one.rotate(ag.X, -math.pi / 2).at(z=self.top + lift)

    def tap(self, travel: ag.Scalar, under: ag.Scalar) -> ag.Body:
        """Make the dial of a gas tap with its stem, and its disc under the plate: the link `burner_dial`."""
        high = under - _UNDER
        low = high - _DISC_THICK
        stem = ag.cylinder(0.0042, self.top + travel + 0.002 - low).align((0, 0, low), z=-1)
        disc = ag.Region((-_DISC, _DISC), (-_DISC, _DISC), (low, high))
        front, back = disc.deep(_DISC + _PIN - 0.0008, None)
        left, _, right = back.across(None, 0.0040, _DISC - 0.0020)  # beside the notch for the pin
        steel = self.cap if self.cap.base_metalness > 0.5 else self.finish
        solid = ag.union(stem, *(each.box() for each in (front, left, right)))
        knob = self.knob("burner_dial", lift=travel)
        return ag.weld(knob, ag.part(solid, "burner_dial", steel))

    def bezels(self) -> ag.Body:
        """Make the flat rings around the dials of gas taps, visual only."""
        flat = ag.ring(self.plan.radius + 0.0022, 0.0078)
        ring = details.relief(flat, (0, 0, self.top), facing=ag.Z, proud=0.0004, bevel=0.0002)
        at = [(x, y, 0) for x, y in self.plan.dial_places[: self.plan.burners]]
        return ag.detail(ag.array(ring, at=at), "bezel", self.cap)

    def signs(self, extras: tuple[str, ...]) -> ag.Body:
        """Print a sign beside each dial: rings for all burners with the dial's own one filled, or an icon."""
        plan, size = self.plan, 0.0017
        left, right, front, back = plan.field
        across = SIGN / (right - left)
        along = 0.0 if plan.rows == 1 else 0.6 * SIGN / (back - front)
        dots = [
            ((p.x - (left + right) / 2) * across, (p.y - (front + back) / 2) * along) for p in plan.places
        ]
        i, j = plan.sign_step
        signs = [(x + i, y + j) for x, y in plan.dial_places]
        own: list[ag.VectorLike] = []
        others: list[ag.VectorLike] = []
        for dial, (x, y) in enumerate(signs[: plan.burners]):
            for burner, (i, j) in enumerate(dots):
                (own if burner == dial else others).append((x + i, y + j, 0))
        ring = details.relief(ag.ring(size, size - 0.0005), (0, 0, self.top), facing=ag.Z, proud=0.0002)
        dot = details.relief(ag.circle(size), (0, 0, self.top), facing=ag.Z, proud=0.0003)
        icons = [
            details.printed(details.icon(name, 0.009), (x, y, self.top), material=self.ink, facing=ag.Z)
            for name, (x, y) in zip(extras, signs[plan.burners :], strict=False)
        ]
        films = [ag.array(dot, at=own), ag.array(ring, at=others)]
        return ag.weld(ag.detail(films, "print", self.ink), *icons)

    def scales(self, *, gas: bool) -> ag.Body:
        """Print the scales around all dials."""
        plan = self.plan
        kinds: list[Scale | None] = [None if gas else self.scale] * plan.burners
        kinds += ["ticks"] * (plan.dials - plan.burners)
        prints = {kind: self._steps(kind) if kind else self._flames() for kind in dict.fromkeys(kinds)}
        turned = {kind: film.rotate(ag.X, -math.pi / 2) for kind, film in prints.items()}
        return ag.weld(
            *(turned[kind].at(x, y, self.top) for kind, (x, y) in zip(kinds, plan.dial_places, strict=True))
        )

    def _steps(self, style: Scale) -> ag.Body:
        """Print nine steps; the space at off, the mark's position at rest, is free."""
        radius, count = self.plan.radius, 9 if style == "numbers" else 6
        sweep, start = SWEEP * 8 / 9, SWEEP / 9
        steps = dial_print(
            radius, ink=self.ink, style=style, count=count, sweep=sweep, start=start, height=0.0027
        )
        zero = ag.ring(0.0012, 0.0007).at(0, radius + 0.0042)
        return ag.weld(steps, details.printed(zero, material=self.ink))

    def _flames(self) -> ag.Body:
        """Print the scale of a tap: off at the back, a large flame at the left, a small one at the right."""
        radius = self.plan.radius
        off = ag.ring(0.0015, 0.0010).at(0, radius + 0.0048)
        large = details.icon("flame", 0.0062, weight="bold").at(-radius - 0.0052)
        small = details.icon("flame", 0.0038).at(radius + 0.0050)
        band = details.dial_band(radius + 0.0026, 0.0004, 0.0016, sweep=2.3, start=1.99)
        return details.printed(off | large | small | band, material=self.ink)


def electric_turn(name: str, friction: ag.Scalar) -> ag.Joint:
    """Make the joint of a dial on a rotary switch; positive turns it clockwise from off."""
    return ag.Revolute(name, axis=-ag.Z, limits=(0, SWEEP), feel=feel.DIAL, friction=friction)


def tap_joints(travel: ag.Scalar, force: ag.Scalar, friction: ag.Scalar) -> tuple[ag.Joint, ag.Joint]:
    """Make the joints of a gas dial: the push, then the turn, counterclockwise from off.

    The spring force is that of real taps, 2.5 N at rest and 8-14 N pushed in [EN 1106: a tap opens at no more
    than 0.4 N m and 20 N].
    """
    spring = ag.Spring(preload=2.5, force=force)
    down = ag.Prismatic("burner_dial_push", axis=-ag.Z, limits=(0, travel), spring=spring, feel=_PUSH)
    # friction of the greased cone
    cone = feel.Feel(friction=friction, damping=0.004, armature=0.00002, effort=0.4)
    turn = ag.Revolute(
        "burner_dial_turn", axis=ag.Z, limits=(0, SWEEP), feel=cone, needs=down > travel - _CLEAR / 2
    )
    return down, turn


def tap_pin(travel: ag.Scalar, under: ag.Scalar) -> ag.Solid:
    """Make the pin that goes from the plate into the notch of the disc, about the z axis."""
    z = (under - _UNDER - travel + _CLEAR, under + 0.0005)
    return ag.Region((-0.0015, 0.0015), (_PIN, _PIN + 0.0028), z).box()
