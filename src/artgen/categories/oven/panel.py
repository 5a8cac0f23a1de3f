"""The control panel of an oven: a display and touch keys between dials, each with its scale."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.oven.space import LAP, Space
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.controls import (
    PANE,
    DialStyle,
    dial,
    dial_print,
    dial_turn,
    icon_row,
    ink_on,
    inlay,
    lamp_row,
    places,
)
from artgen.nodes.details.displays import Color

SWEEP = 4.7
"""Turn of a dial from off to its end [rad]."""

_START = 0.45  # angle from off, at the top, to the first position of a scale [rad]
_DEEP = 0.030  # thickness of the panel [m]
_FUNCTIONS = ("heat_both", "heat_bottom", "grill", "hot_air", "defrost", "oven_light")
_BLACK = ag.material("black_glass")
_TOUCH = ("power", "minus", "timer", "clock", "plus", "child_lock")


@dataclass(frozen=True)
class Panel:
    """Layout and finish of a panel."""

    space: Space  # dimensions of the oven
    finish: ag.Material  # finish of the face
    pane: bool  # whether a pane of black glass covers the face
    dials: int  # number of dials
    burners: int  # number of the dials that belong to burners
    style: DialStyle  # style of the dials
    radius: ag.Scalar  # radius of the dials [m]
    knob: ag.Material  # material of dials
    metal: ag.Material  # metal of the caps of dials
    friction: ag.Scalar  # friction of the dials [N m]
    show: str  # text of the display; `""` for none
    color: Color  # color of the figures of the display
    maker: str  # brand name; `""` for none

    @cached_property
    def _level(self) -> ag.Scalar:
        """Position of the middle of the panel along z [m]."""
        return (self.space.panel_low + self.space.panel_high) / 2.0

    @cached_property
    def _half(self) -> ag.Scalar:
        return self.space.half - (0.0015 if self.space.build == "range" else 0.0)

    @cached_property
    def _screen(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Width and height of the display [m]."""
        high = 0.30 * self.space.panel
        return (2.9 * high, high)

    @cached_property
    def _aside(self) -> ag.Scalar:
        """Half the width of the display with its touch keys [m]."""
        if not self.show:
            return 0.0 * self.space.width
        return self._screen[0] / 2.0 + 0.012

    @cached_property
    def _at(self) -> list[ag.Scalar]:
        """Positions of the middles of the dials along x, from left to right [m]."""
        if not self.dials:
            return []
        end = self._half - 0.020 - self.radius
        if not self.show:
            step = 2.0 * end / max(self.dials, 3)
            return places(self.dials, step)
        left = (self.dials + 1) // 2
        right = self.dials - left
        start = self._aside + self.radius + 0.012
        room = end - start
        row = []
        for count, way in ((left, -1), (right, 1)):
            # one or two dials are in the middle of their side, more dials fill it
            step = room / max(count - 1, 2)
            first = start + (room - (count - 1) * step) / 2.0
            found = [way * (first + number * step) for number in range(count)]
            row += found[::-1] if way < 0 else found
        return row

    def body(self) -> ag.Body:
        """Make the panel with its print, which is welded to the cabinet."""
        space, half = self.space, self._half
        front = space.front
        face = ag.Region(
            (-half, half), (front, front + _DEEP), (space.panel_low, space.panel_high - 0.0006)
        ).box(bevel=0.0020)
        behind = ag.Region(
            (0.002 - half, half - 0.002),
            (front + _DEEP - LAP, space.mouth + LAP),
            (space.panel_low + 0.001, space.panel_high - 0.001),
        ).box()
        return ag.weld(
            ag.part(face, "panel", filled(self.finish, 260.0, "panel")),
            ag.part(behind, "panel", filled(ag.material("powder_coat_black"), 150.0, "panel")),
            *(each.at(0.0, front, self._level) for each in self._printed()),
        )

    def _printed(self) -> list[ag.Body]:
        """Make pane, display, touch keys, scales and the name on the plane y = 0, about the middle."""
        bodies = []
        high = self.space.panel
        face = _BLACK if self.pane else self.finish
        proud: ag.Scalar = PANE if self.pane else 0.0
        if self.pane:
            bodies.append(inlay(2.0 * self._half - 0.006, high - 0.008, finish=face, radius=0.004))
        ink = ink_on(face)
        if self.show:
            bodies += self._display(high)
        if not self.dials:
            # a panel without dials has touch signs at both sides
            for way, names in ((-1, _FUNCTIONS), (1, _TOUCH)):
                row = [way * (self._aside + 0.030 + number * 0.038) for number in range(4)]
                bodies.append(icon_row(names[:4], row, height=0.0125, ink=ink, proud=proud))
                bodies.append(lamp_row(row, level=-0.016, lit=1 if way < 0 else 9, proud=proud))
        for number, x in enumerate(self._at):
            bodies.append(self._scale(number, ink).at(x, -proud, 0.0))
        if self.maker:
            bodies.append(self._name(ink, proud))
        return bodies

    def _display(self, high: ag.Scalar) -> list[ag.Body]:
        """Make the display above its three touch keys, on its own pane if the panel has none."""
        wide, tall = self._screen
        keys = places(3, 0.30 * wide)
        names = ("minus", "timer", "plus")
        return [
            *([] if self.pane else [inlay(wide + 0.012, 0.80 * high, radius=0.004)]),
            details.display(self.show, wide, tall, at=(0.0, -PANE, 0.13 * high), color=self.color),
            icon_row(names, keys, height=0.0085, level=-0.24 * high, ink=ink_on(_BLACK), proud=PANE),
        ]

    def _scale(self, number: int, ink: ag.Material) -> ag.Body:
        """Print the scale of a dial: fan signs for the oven's first dial, temperatures, or burner levels."""
        last = self.dials - self.burners
        sweep = SWEEP - _START
        of_oven = number >= self.burners
        off = details.lettering(["0"], 0.0042)
        up = self.radius + 0.0052
        bodies = [details.printed(off.at(0.0, up), (0.0, 0.0, 0.0), material=ink)]
        style: Literal["numbers", "ticks", "band", "icons"] = "band"
        if of_oven:
            style = "icons" if number == self.burners and last > 1 else "ticks"
        if style == "icons":
            scale = dial_print(
                self.radius,
                ink=ink,
                style="icons",
                icons=_FUNCTIONS,
                sweep=sweep,
                start=_START,
                height=0.0034,
            )
        else:
            scale = dial_print(self.radius, ink=ink, style=style, count=6, sweep=sweep, start=_START)
        bodies.append(scale)
        sign = "oven" if of_oven and self.burners else ("" if of_oven else "flame")
        if of_oven and not self.burners and style == "ticks":
            sign = "thermometer"
        if sign:
            mark = details.icon(sign, 0.0085).at(0.0, -self.radius - 0.0115)
            bodies.append(details.printed(mark, (0.0, 0.0, 0.0), material=ink))
        return ag.weld(*bodies)

    def _name(self, ink: ag.Material, proud: ag.Scalar) -> ag.Body:
        """Print the maker's name at the right end, or in the middle if there is no display."""
        word = details.logo(self.maker, 0.0058)
        tall = 0.5 * self.space.panel - 0.0105
        x = 0.0 if self.show else -self._half + 0.055
        return details.printed(word, (x, -proud, -tall), material=ink)

    def joined(self, body: ag.Body) -> ag.Body:
        """Attach the dials to the body with the panel."""
        proud: ag.Scalar = PANE if self.pane else 0.0
        for number, x in enumerate(self._at):
            tail = f"_{number}" if self.dials > 1 else ""
            at = (x, self.space.front - proud, self._level)
            knob = dial(
                finish=self.knob,
                style=self.style,
                radius=self.radius,
                depth=0.022,
                mark=ink_on(self.knob),
                cap=self.metal,
                name=f"dial{tail}",
                label="dial",
            )
            body = body.attach(knob.at(at), self._turn(f"dial_turn{tail}", at))
        return body

    def _turn(self, name: str, at: tuple[ag.Scalar, ag.Scalar, ag.Scalar]) -> ag.Joint:
        return dial_turn(name, low=0.0, high=SWEEP, friction=self.friction, pivot=at)
