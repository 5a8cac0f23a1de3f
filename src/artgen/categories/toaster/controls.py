"""The control panel of a toaster: a plate with slits for levers, holes for buttons, and dials on it.

The panel is modeled in its final pose and faces -y. Heights and x from its middle give the positions of its
controls.
"""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.shared.controls import (
    PLAY,
    ButtonShape,
    DialStyle,
    button_cap,
    button_plate,
    button_press,
    control_knob,
    dial_print,
    dial_turn,
)
from artgen.categories.shared.finish import recess
from artgen.categories.toaster.inside import ARM, slit
from artgen.categories.toaster.plan import Plan

Layout = Literal["beside", "below"]
"""Arrangement: dials and buttons beside the lever, or dials below levers with buttons around them."""

Scale = Literal["numbers", "ticks", "band"]
"""Print around a dial."""

_RECESS = 0.001  # depth of the panel behind the face of the shell [m]
_CAP = 0.012  # width of a button [m]
_TRAVEL = 0.003  # travel of a button [m]
_THICK = 0.005  # thickness of the panel [m]
_LAP = 0.001  # overlap of the rim with the shell [m]
_PITCH = 0.0168  # pitch of buttons: a finger of 18 mm is clear of the next button [m]
_OVER = 0.012  # distance from the lower edge to a dial, for its print [m]
_UNDER = 0.014  # distance from the upper edge to the arm of a lever at rest [m]
_FINGERS = 0.020  # space for fingers around a dial [m]
_NEAREST = 0.045  # largest distance from the middle to a lever with controls beside it [m]
_BESIDE = 0.045  # gap between the arm of a lever and its neighbor [m]
_ICONS = ("cross", "bagel", "defrost", "steam")  # cancel, one side only, frozen bread, reheat


@dataclass(frozen=True)
class Site:
    """Position and arrangement of a panel."""

    middle: ag.Scalar  # position of the middle along x [m]
    plane: ag.Scalar  # position of the face along y [m]
    low: ag.Scalar  # height of the lower edge [m]
    high: ag.Scalar  # height of the upper edge [m]
    half: ag.Scalar  # half of the width [m]
    deep: ag.Scalar  # depth of the opening in the shell [m]
    layout: Layout  # arrangement of the controls
    levers: tuple[ag.Scalar, ...]  # positions of the arms of levers along x, from the middle of the panel [m]
    lean: int  # 1 for a neighbor to the right of the lever, -1 for a neighbor to the left

    @cached_property
    def rest(self) -> ag.Scalar:
        """Height of the arms of levers at rest [m]."""
        return self.high - _UNDER

    @cached_property
    def arms(self) -> list[ag.Vector]:
        """Positions at which the arms of levers pass through the face [m]."""
        return [ag.vector(self.middle + x, self.plane, self.rest) for x in self.levers]


def end_site(plan: Plan, levers: int, layout: Layout, lean: int) -> Site:
    """Place the panel on a narrow end."""
    half = plan.width / 2 - plan.border
    at: tuple[ag.Scalar, ...] = (0.0,)
    if levers > 1:
        aside = plan.pitch * plan.slots / 4
        at = (-aside, aside)
    elif layout == "beside":
        half = ag.min_(half, _NEAREST + 0.030)
        at = (-lean * ag.min_(half - 0.022, _NEAREST),)
    return Site(
        middle=0.0,
        plane=_RECESS - plan.length / 2,
        low=plan.foot + plan.under_panel,
        high=plan.height - plan.over_panel,
        half=half,
        deep=plan.cap + 0.002,
        layout=layout,
        levers=at,
        lean=lean,
    )


def side_site(plan: Plan) -> Site:
    """Place the panel on a broad side, with its lever, on the right, in front of the bay."""
    half = 0.060
    lever = half - 0.022
    return Site(
        middle=-plan.bay - lever,
        plane=_RECESS + plan.inset - plan.width / 2,
        low=plan.foot + 0.021,  # between the rounded corners of the sleeve
        high=plan.height - 0.021,
        half=half,
        deep=0.005,
        layout="beside",
        levers=(lever,),
        lean=-1,
    )


@dataclass(frozen=True)
class PanelLooks:
    """Materials and styles of the panel and its controls."""

    plate: ag.Material  # material of the panel
    ink: ag.Material  # print on the panel
    button: ag.Material  # material of the buttons
    button_ink: ag.Material  # print on the buttons
    dial: ag.Material  # material of the dials
    mark: ag.Material  # material of the marks of dials
    metal: ag.Material  # metal of caps of dials and plates around buttons
    shape: ButtonShape  # shape of the buttons
    style: DialStyle  # shape of the dials
    scale: Scale  # print around the dials
    maker: str  # brand name on the panel


@dataclass(frozen=True)
class Panel:
    """A control panel."""

    site: Site  # position and arrangement of the panel
    travel: ag.Scalar  # travel of the levers [m]
    knobs: int  # number of dials
    buttons: int  # number of buttons
    radius: ag.Scalar  # radius of the dials [m]
    looks: PanelLooks  # materials and styles

    @cached_property
    def _aside(self) -> ag.Scalar:
        """Position of dials and buttons beside a lever, along x [m]."""
        return self.site.lean * (ag.min_(self.site.half, _NEAREST + 0.030) - self.radius - 0.010)

    @cached_property
    def _dial(self) -> ag.Scalar:
        """Height of the dials [m]."""
        return self.site.low + self.radius + _OVER

    def _dials(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Return the positions of the dials, or of the display that replaces them."""
        if self.site.layout == "beside":
            return [(self._aside, self._dial)]
        return [(x, self._dial) for x in self.site.levers]

    @cached_property
    def _keys(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Return the positions of the buttons."""
        numbers = range(self.buttons)
        if self.site.layout == "beside":
            first = self._dial + self.radius + _FINGERS
            return [(self._aside, first + number * _PITCH) for number in numbers]
        if len(self.site.levers) > 1:  # a column between the levers
            first = self._dial + 0.030
            return [(0.0, first + number * _PITCH) for number in numbers]
        aside = self.radius + 0.022  # at both sides of the dial
        rows = [self._dial + row * (_PITCH + 0.001) for row in (0, 1)]
        return [((2 * (number % 2) - 1) * aside, rows[number // 2]) for number in numbers]

    def fits(self) -> ag.Bool | bool:
        """Return whether buttons are below the upper edge, within the sides, and clear of a lever."""
        site, top = self.site, self._keys[-1][1] if self._keys else self._dial
        below = top + _CAP / 2 < site.high
        if site.layout != "beside":
            out = -self._keys[0][0] if self._keys else 0.0  # the first button is at the left
            return below & (out + _CAP / 2 + PLAY < site.half)
        return below & (site.lean * (self._aside - site.levers[0]) > _BESIDE)

    def _at(self, place: tuple[ag.Scalar, ag.Scalar]) -> ag.Vector:
        return ag.vector(self.site.middle + place[0], self.site.plane, place[1])

    def opening(self) -> ag.Solid:
        """Return the cutter for the panel's opening in the shell."""
        site = self.site
        front, back = site.plane - 0.005, site.plane + site.deep
        tool = ag.box(2 * site.half, back - front, site.high - site.low)
        return tool.at(site.middle, 0.5 * (front + back), 0.5 * (site.low + site.high))

    def _outline(self) -> ag.Profile:
        """Return the outline of the plate, about its middle in x, at its heights."""
        site = self.site
        tall = site.high - site.low + 2 * _LAP
        plate = ag.rectangle(2 * (site.half + _LAP), tall).at(0.0, 0.5 * (site.low + site.high))
        for x in site.levers:
            plate = plate - slit(self.travel).at(x, site.rest)
        hole = ag.rectangle(_CAP + 2 * PLAY, _CAP + 2 * PLAY)
        for x, z in self._keys:
            plate = plate - hole.at(x, z)
        return plate

    def plate(self) -> ag.Body:
        """Make the panel with its print, which is welded to the shell."""
        looks, site = self.looks, self.site
        at = ag.vector(site.middle, site.plane + _THICK / 2, 0.0)
        solid = details.relief(self._outline(), at, proud=_THICK / 2, sunk=_THICK / 2)
        bodies = [ag.part(solid, "control_panel", looks.plate), self._shields()]
        for key in self._keys:
            rim = button_plate(finish=looks.metal, shape=looks.shape, width=_CAP, height=_CAP)
            bodies.append(rim.at(self._at(key)))
        if self.knobs:
            for place in self._dials():
                scale = dial_print(self.radius, ink=looks.ink, style=looks.scale, sweep=4.8, height=0.0030)
                bodies.append(scale.at(self._at(place)))
        else:
            shown = self._dials()[0] if len(site.levers) == 1 else (0.0, self._dial)
            bodies.append(details.display("3", 0.024, 0.017, at=self._at(shown), color="amber"))
        if site.layout == "beside" and self.buttons < 4:
            name = details.logo(self.looks.maker.upper(), 0.0036, tracking=0.2)
            bodies.append(
                details.printed(name, self._at((self._aside, site.high - 0.010)), material=looks.ink)
            )
        return ag.weld(*bodies)

    def _shields(self) -> ag.Body:
        """Make the dark brushes behind slits, at both sides of the passing arms, visual only."""
        wide = 0.0063
        strip = ag.box(wide, 0.001, self.travel + 0.022)
        level, out = self.site.rest - self.travel / 2, ARM[0] / 2 + 0.0002 + wide / 2
        at = [
            (self.site.middle + x + side * out, self.site.plane + _THICK, level)
            for x in self.site.levers
            for side in (-1, 1)
        ]
        return ag.detail(ag.array(strip, at=at), "control_panel", recess(self.looks.plate))

    def attached(self, body: ag.Body, force: ag.Scalar, friction: ag.Scalar) -> ag.Body:
        """Attach buttons and dials to the body with the panel."""
        looks = self.looks
        for number, key in enumerate(self._keys):
            tail, at = f"_{number}" if self.buttons > 1 else "", self._at(key)
            cap = button_cap(
                finish=looks.button,
                shape=looks.shape,
                width=_CAP,
                height=_CAP,
                icon=_ICONS[number],
                ink=looks.button_ink,
                name=f"button{tail}",
            )
            slide = button_press(f"button_slide{tail}", travel=_TRAVEL, force=force, pivot=at)
            body = body.attach(cap.at(at), slide)
        tails = ("_left", "_right") if self.knobs > 1 else ("",)
        for tail, place in zip(tails, self._dials() if self.knobs else [], strict=False):
            at = self._at(place)
            knob = control_knob(
                finish=looks.dial,
                style=looks.style,
                radius=self.radius,
                mark=looks.mark,
                cap=looks.metal,
                name=f"knob{tail}",
            )
            body = body.attach(knob.at(at), dial_turn(f"knob_turn{tail}", friction=friction, pivot=at))
        return body
