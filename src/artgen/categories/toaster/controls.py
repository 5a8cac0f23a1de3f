"""The control panel of a toaster: a plate with slits for levers, holes for buttons, and dials on it.

The panel is modeled in its final pose and faces -y.
"""

from functools import reduce
from operator import or_
from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.shared.controls import PLAY, ButtonShape, button_cap, button_plate, button_press
from artgen.categories.shared.finish import recess
from artgen.categories.toaster.finish import hollow, ink_on
from artgen.categories.toaster.inside import ARM, OXIDIZED
from artgen.categories.toaster.plan import Plan
from artgen.nodes.fitting import Fitting

Layout = Literal["beside", "below"]
"""Arrangement: dials and buttons beside the lever, or dials below levers with buttons around them."""

Place = tuple[ag.Scalar, ag.Scalar, ag.Scalar]
"""A point on the panel [m]."""

_RECESS = 0.001  # depth of the panel behind the face of the shell [m]
_CAP = 0.012  # width of a button [m]
_THICK = 0.005  # thickness of the panel [m]
_LAP = 0.001  # overlap of the rim with the shell [m]
_PITCH = 0.0168  # pitch of buttons: a finger of 18 mm is clear of the next button [m]
_OVER = 0.012  # distance from the lower edge to a dial, for its print [m]
_UNDER = 0.014  # distance from the upper edge to the arm of a lever at rest [m]
_FINGERS = 0.020  # space for fingers around a dial [m]
_NEAREST = 0.045  # largest distance from the middle to a lever with controls beside it [m]
_BESIDE = 0.045  # gap between the arm of a lever and its neighbor [m]
_SLIT = (0.0011, 0.0016)  # gaps between the arm and its slit, at the sides and at the ends [m]
_BRUSH = 0.0063  # width of a brush behind a slit [m]
_ICONS = ("cross", "bagel", "defrost", "steam")  # cancel, one side only, frozen bread, reheat


class Panel:
    """Places of the controls; `hand` is the side of a lever beside dials of this radius [m]."""

    def __init__(
        self,
        plan: Plan,
        controls: str,
        layout: Layout,
        hand: str,
        levers: int,
        radius: ag.Scalar,
        buttons: int,
    ) -> None:
        form, body = plan.form, plan.body
        lean = 1 if hand == "left" else -1  # side of the lever at which its neighbors are
        self.beside = controls == "side" or layout == "beside"
        arms: list[ag.Scalar]  # positions of the arms of the levers along x [m]
        if controls == "side":  # the lever is at the right, in front of the bay
            arms, lean = [-plan.bay], -1
            face, deep = plan.sleeve.x.low + _RECESS, 0.005
            # between the rounded corners of the sleeve
            field = body.shrink(z=0.021).with_(x=(arms[0] - 0.098, arms[0] + 0.022))
        else:
            arms = [half.x.mid for half in plan.chamber.columns(levers, gap=plan.bridge)]
            face, deep = body.y.low + _RECESS, form.front + 0.002
            field = body.shrink(x=form.border, bottom=form.under, top=form.over)
            if self.beside and levers == 1:
                half = ag.min_(field.x.high, _NEAREST + 0.030)
                field = field.with_(x=(-half, half))
                arms = [-lean * ag.min_(half - 0.022, _NEAREST)]
        self.face, self.field = face, field.with_(y=(face, face + deep))
        self.arms: list[Place] = [(x, face, field.z.high - _UNDER) for x in arms]
        aside = field.x.mid + lean * (ag.min_(field.x.size / 2, _NEAREST + 0.030) - radius - 0.010)
        level = field.z.low + radius + _OVER  # height of the dials [m]
        xs = [aside] if self.beside else arms
        self.dials: list[Place] = [(x, face, level) for x in xs]
        numbers = range(buttons)
        self.keys: list[Place]
        if self.beside:
            self.keys = [(aside, face, level + radius + _FINGERS + number * _PITCH) for number in numbers]
        elif levers > 1:  # a column between the levers
            self.keys = [(0.0, face, level + 0.030 + number * _PITCH) for number in numbers]
        else:  # at both sides of the dial
            x, pitch = radius + 0.022, _PITCH + 0.001
            self.keys = [((2 * (n % 2) - 1) * x, face, level + n // 2 * pitch) for n in numbers]
        # buttons are below the upper edge, within the sides, and clear of a lever
        top = self.keys[-1][2] if self.keys else level
        out = -self.keys[0][0] if self.keys else 0.0  # the first button is at the left
        room = lean * (aside - arms[0]) > _BESIDE if self.beside else out + _CAP / 2 + PLAY < field.x.size / 2
        self.fits = (top + _CAP / 2 < field.z.high) & room

    def plate(self, finish: ag.Material, travel: ag.Scalar, *, dials: bool, maker: str) -> ag.Body:
        """Make the plate with its print, which is welded to the shell; without dials it has a display."""
        outline = self.field.grow(_LAP).front()
        slit = ag.rectangle(ARM[0] + 2 * _SLIT[0], travel + ARM[1] + 2 * _SLIT[1], radius=0.0012)
        brush = ag.box(_BRUSH, 0.001, travel + 0.022)  # dark brushes hide the inside at both sides of an arm
        apart = ARM[0] / 2 + 0.0002 + _BRUSH / 2
        brushes: list[Place] = []
        for x, _, z in self.arms:
            outline = outline - slit.at(x, z - travel / 2)
            brushes += [(x + side * apart, self.face + _THICK, z - travel / 2) for side in (-1, 1)]
        for x, _, z in self.keys:
            outline = outline - ag.rectangle(_CAP + 2 * PLAY, _CAP + 2 * PLAY).at(x, z)
        middle = (0.0, self.face + _THICK / 2, 0.0)
        board = details.relief(outline, middle, proud=_THICK / 2, sunk=_THICK / 2)
        bodies = [
            ag.part(board, "control_panel", hollow(finish)),
            ag.detail(ag.array(brush, at=brushes), "control_panel", recess(hollow(finish))),
        ]
        if not dials:
            x, y, z = self.dials[0]
            shown = (x if len(self.arms) == 1 else 0.0, y, z)
            bodies.append(details.display("3", 0.024, 0.017, at=shown, color="amber"))
        if self.beside and len(self.keys) < 4:
            name = details.logo(maker.upper(), 0.0036, tracking=0.2)
            at = (self.dials[0][0], self.face, self.field.z.high - 0.010)
            bodies.append(details.printed(name, at, material=ink_on(finish)))
        return ag.weld(*bodies)


def toasting(body: ag.Body, levers: int, knobs: int, buttons: int) -> ag.Body:
    """Let a lever that is down heat its slots, as hot as its knob says; a key cancels, others heat less."""
    names = [f"button_slide_{number}" for number in range(buttons)] if buttons > 1 else ["button_slide"]
    keys = [signals.pressed(name) for name in names[:buttons]]
    heats = []
    for number in range(levers):
        heat = signals.pressed("lever_slide" + (("_left", "_right")[number] if levers > 1 else ""))
        if knobs:  # from half the heat up
            knob = "knob_turn" + (("_left", "_right")[number] if knobs > 1 else "")
            heat = heat & ~(0.5 * signals.level(knob, (2.4, -2.4)))
        heats.append(heat)
    power = reduce(or_, heats)
    if keys:
        power = power & ~keys[0]
    if len(keys) > 1:
        power = power & ~signals.latest(keys[1:], (0.5, 0.0, 0.6)[: len(keys) - 1])
    return body.output("heat", power, kind="heat", material=OXIDIZED)


def button(
    number: int, tail: str, shape: ButtonShape, force: ag.Scalar, finish: ag.Material, metal: ag.Material
) -> Fitting:
    """Make a button in a metal plate, for a panel that has its hole."""
    cap = button_cap(
        finish=finish, shape=shape, width=_CAP, icon=_ICONS[number], ink=ink_on(finish), name=f"button{tail}"
    )
    slide = button_press(f"button_slide{tail}", force=force)
    return Fitting.moving(cap, slide, fixed=button_plate(finish=metal, shape=shape, width=_CAP))
