"""The control panel of a microwave oven: display, keypad, dials, and the button that opens the door."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.microwave.door import PANE, FaceStyle
from artgen.categories.microwave.space import EDGE, Space
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.controls import (
    PLAY,
    ButtonShape,
    DialStyle,
    button_outline,
    button_press,
    dial,
    dial_print,
    dial_turn,
    ink_on,
    push_button,
)
from artgen.nodes.details.displays import Color

Controls = Literal["keypad", "mixed", "dials"]
"""Keys, keys with one dial, or dials alone."""

_LAP = 0.0005
_UNDER = 0.0003  # distance from the visible face to the boards under it [m]
_FACE = 0.0165  # thickness of the face with the channels of the keys [m]
_DEEP = 0.0085  # depth of caps behind the face [m]
_MARGIN = 0.0105  # margin from the edges of the panel to its controls [m]
_BAND = 0.030  # height of the bands of finish at top and bottom of a banded front [m]
_PITCH = 0.0200  # pitch of the rows of keys [m]
_KEY = 0.0138  # height of a key [m]
_EJECT = 0.030  # height of the opening button [m]
_SCREEN = 0.026  # height of the display [m]
_APART = 0.011  # gap between display, controls and button [m]

_DIGITS = ("1", "2", "3", "4", "5", "6", "7", "8", "9", "stop", "0", "play")
_PROGRAMS = ("cup", "pizza", "fish", "chicken", "bread", "defrost", "carrot", "plate", "grill")
_STARTS = ("timer", "stop", "start_pause")


def key_names(count: int) -> tuple[str, ...]:
    """Return the labels of keys in rows of three: digits, if there are enough keys, and programs."""
    if count >= len(_DIGITS):
        return (*_PROGRAMS[: count - len(_DIGITS)], *_DIGITS)
    return (*_PROGRAMS[: count - len(_STARTS)], *_STARTS) if count else ()


@dataclass(frozen=True)
class Panel:
    """Layout and finish of a control panel."""

    space: Space  # dimensions of the oven
    face: FaceStyle  # style of the front
    finish: ag.Material  # finish of the front
    glass: ag.Material  # material of panes
    keys: int  # number of keys, in rows of three
    shape: ButtonShape  # shape of the key caps
    cap: ag.Material  # material of the keys and the button
    dials: int  # number of dials, one below the other
    dial: DialStyle  # style of the dials
    radius: ag.Scalar  # radius of the dials [m]
    knob: ag.Material  # material of dials
    metal: ag.Material  # metal of the caps of dials
    travel: ag.Scalar  # travel of keys [m]
    force: ag.Scalar  # force that presses a key home [N]
    eject: bool  # whether there is an opening button
    eject_travel: ag.Scalar  # travel of that button [m]
    eject_force: ag.Scalar  # force that presses the button home [N]
    show: str  # text of the display; `""` for none
    color: Color  # color of the figures of the display
    maker: str  # brand above the display; `""` for none

    @cached_property
    def _x(self) -> ag.Span:
        return (self.space.split, self.space.half - EDGE)

    @cached_property
    def _middle(self) -> ag.Scalar:
        return (self._x[0] + self._x[1]) / 2.0

    @cached_property
    def _wide(self) -> ag.Scalar:
        """Width of the controls on the panel [m]."""
        return self._x[1] - self._x[0] - 2.0 * _MARGIN

    @cached_property
    def _ends(self) -> ag.Span:
        """Lowest and highest positions of the controls on the panel along z [m]."""
        low, high = self.space.tall
        edge = _BAND + 0.004 if self.face == "banded" else _MARGIN
        return (low + edge, high - edge)

    @cached_property
    def _rows(self) -> int:
        return -(-self.keys // 3)

    @cached_property
    def _screen(self) -> ag.Scalar:
        """Position of the middle of the display along z [m]."""
        return self._ends[1] - (0.010 if self.maker else 0.0) - _SCREEN / 2.0

    @cached_property
    def _room(self) -> ag.Span:
        """Space between the display and the button along z [m]."""
        low, high = self._ends
        top = self._screen - _SCREEN / 2.0 - _APART if self.show else high - (0.012 if self.maker else 0.0)
        return (low + _EJECT + _APART if self.eject else low, top)

    @cached_property
    def _key(self) -> ag.Scalar:
        """Width of a key [m]."""
        return self._pitch - 0.0056

    @cached_property
    def _pitch(self) -> ag.Scalar:
        return self._wide / 3.0

    @cached_property
    def _grid(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Positions of the middles of the keys, x and z [m]."""
        low, high = self._room
        tall = (self._rows - 1) * _PITCH
        # keys alone are in the middle of the space; below a dial they are at the lower end
        last = low + _KEY / 2.0 if self.dials else (low + high - tall) / 2.0
        return [
            (self._middle + (index % 3 - 1) * self._pitch, last + (self._rows - 1 - index // 3) * _PITCH)
            for index in range(self.keys)
        ]

    @cached_property
    def _turned(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Positions of the middles of the dials, x and z [m]."""
        high, step = self._room[1], self._step
        return [(self._middle, high - (number + 0.5) * step) for number in range(self.dials)]

    @cached_property
    def _step(self) -> ag.Scalar:
        """Height available for each dial [m]."""
        low, high = self._room
        if self.keys:
            low = low + self._rows * _PITCH
        return (high - low) / max(self.dials, 1)

    @property
    def room(self) -> ag.Scalar:
        """Free height beside the dials; negative if the dials do not fit [m]."""
        return self._step - 2.0 * self.radius if self.dials else self._step

    @cached_property
    def _button(self) -> ag.Scalar:
        """Position of the middle of the button along z [m]."""
        return self._ends[0] + _EJECT / 2.0

    @cached_property
    def _fields(self) -> list[tuple[ag.Span, ag.Span]]:
        """Channels of the keys and the button, along x and z, from the lowest up [m]."""
        play = PLAY + 0.0006
        half = self._wide / 2.0 + play
        fields = []
        if self.eject:
            tall = _EJECT / 2.0 + play
            fields.append(
                ((self._middle - half, self._middle + half), (self._button - tall, self._button + tall))
            )
        if self.keys:
            beside = self._pitch + self._key / 2.0 + play
            tall = _KEY / 2.0 + play
            last, first = self._grid[-1][1], self._grid[0][1]
            fields.append(((self._middle - beside, self._middle + beside), (last - tall, first + tall)))
        return fields

    def _boards(self) -> list[ag.Solid]:
        """Make the boards around the channels, just under the visible face, and the back."""
        space, (left, right) = self.space, self._x
        low, high = space.tall
        y = (space.front + _UNDER, space.front + _FACE)
        inside = (y[0] + _UNDER, y[1] - _UNDER)
        x, z = (left + _UNDER, right - _UNDER), (low + _UNDER, high - _UNDER)
        solids = [
            ag.Region(
                (left + 0.001, right - 0.001), (y[1] - _LAP, space.mouth + _LAP), (low + 0.001, high - 0.001)
            ).box()
        ]
        if not self._fields:
            return [*solids, ag.Region(x, y, z).box()]
        between = self._fields[0][0]  # the widest channel is the lowest
        solids += [ag.Region((x[0], between[0]), y, z).box(), ag.Region((between[1], x[1]), y, z).box()]
        edges = [z[0] + _LAP, *(edge for _, field in self._fields for edge in field), z[1] - _LAP]
        across = (between[0] - _LAP, between[1] + _LAP)
        return solids + [
            ag.Region(across, inside, (edges[index], edges[index + 1])).box()
            for index in range(0, len(edges), 2)
        ]

    def _front(self) -> ag.Solid:
        """Make the visible face with its channels."""
        (left, right), (low, high) = self._x, self.space.tall
        x, z = (left + right) / 2.0, (low + high) / 2.0
        outline = ag.rectangle(right - left, high - low)
        for (x0, x1), (z0, z1) in self._fields:
            outline = outline - ag.rectangle(x1 - x0, z1 - z0).at((x0 + x1) / 2.0 - x, (z0 + z1) / 2.0 - z)
        middle = (x, self.space.front + _FACE / 2.0, z)
        return details.relief(outline, middle, proud=_FACE / 2.0, sunk=_FACE / 2.0, bevel=0.0014)

    def body(self) -> ag.Body:
        """Make the panel with its print, which is welded to the case."""
        stuff = filled(self.finish, 240.0, "panel")
        return ag.weld(
            *(ag.part(each, "panel", stuff) for each in self._boards()),
            ag.detail(self._front(), "panel", self.finish),
            *self._printed(),
        )

    @cached_property
    def _dark(self) -> ag.Material:
        """Return the material around the keys."""
        return self.finish if self.face == "framed" and not self.show else self.glass

    def _pane(self) -> ag.Profile:
        """Return the outline of the pane about the middle of the panel, with holes for keys and button."""
        low, high = self.space.tall
        level = (low + high) / 2.0
        wide = self._x[1] - self._x[0]
        match self.face:
            case "framed":
                pane = ag.rectangle(wide - 0.008, high - low - 0.008, radius=0.005)
            case "glass":
                pane = ag.rectangle(wide - 0.003, high - low - 0.003, radius=0.003)
            case "banded":
                pane = ag.rectangle(wide - 0.0006, high - low - 2.0 * _BAND)
        holes = [
            button_outline(self.shape, self._key + 2.0 * PLAY, _KEY + 2.0 * PLAY).at(
                x - self._middle, z - level
            )
            for x, z in self._grid
        ]
        if self.eject:
            hole = button_outline("bar", self._wide + 2.0 * PLAY, _EJECT + 2.0 * PLAY)
            holes.append(hole.at(0.0, self._button - level))
        for hole in holes:
            pane = pane - hole
        return pane

    def _printed(self) -> list[ag.Body]:
        """Make pane, display, scales of dials and the name, visual only."""
        space, bodies = self.space, []
        low, high = space.tall
        face = self._dark
        pane = details.relief(
            self._pane(), (self._middle, space.front, (low + high) / 2.0), proud=PANE, sunk=0.0006
        )
        bodies.append(ag.detail(pane, "panel", face))
        ink, plane = ink_on(face), space.front - PANE
        if self.show:
            bodies.append(
                details.display(
                    self.show, self._wide, _SCREEN, at=(self._middle, plane, self._screen), color=self.color
                )
            )
        if self.maker:
            word = details.logo(self.maker, 0.0042)
            bodies.append(details.printed(word, (self._middle, plane, self._ends[1] - 0.0035), material=ink))
        for number, (x, z) in enumerate(self._turned):
            style: Literal["numbers", "ticks", "band"] = ("band", "ticks", "numbers")[number % 3]
            scale = dial_print(self.radius, ink=ink, style=style, count=8)
            bodies.append(scale.at(x, plane, z))
            sign = details.icon(("microwave", "timer", "defrost")[number % 3], 0.0085)
            bodies.append(
                details.printed(
                    sign, (x - self._wide / 2.0 + 0.006, plane, z + self.radius + 0.006), material=ink
                )
            )
        return bodies

    def button(self) -> ag.Body:
        """Make the opening button: the link `button`."""
        at = (self._middle, self.space.front, self._button)
        cap = push_button(
            finish=self.cap,
            shape="bar",
            width=self._wide,
            height=_EJECT,
            proud=self.eject_travel + 0.0016,
            deep=_DEEP,
            name="button",
        )
        word = details.lettering(["OPEN"], 0.0052, tracking=0.25)
        out = -(self.eject_travel + 0.0016)
        return ag.weld(cap, details.printed(word, (0.0, out, 0.0), material=ink_on(self.cap))).at(*at)

    def press(self) -> ag.Joint:
        """Make the joint of the opening button, which lifts the latches against their springs."""
        at = (self._middle, self.space.front, self._button)
        return button_press(
            travel=self.eject_travel,
            preload=0.16 * self.eject_force,
            force=self.eject_force,
            damping=8.0,
            effort=30.0,
            pivot=at,
        )

    def joined(self, body: ag.Body) -> ag.Body:
        """Attach the keys and the dials to the body with the panel."""
        for number, ((x, z), name) in enumerate(zip(self._grid, key_names(self.keys), strict=True)):
            at = (x, self.space.front, z)
            proud = PANE + self.travel + 0.0006
            ink = ink_on(self.cap)
            cap = push_button(
                finish=self.cap,
                shape=self.shape,
                width=self._key,
                height=_KEY,
                proud=proud,
                deep=_DEEP,
                icon="" if name.isdigit() else name,
                ink=None if name.isdigit() else ink,
                name=f"key_{number}",
            )
            if name.isdigit():
                figure = details.lettering([name], 0.0058)
                cap = ag.weld(cap, details.printed(figure, (0.0, -proud, 0.0), material=ink))
            # the domes under the keys of a foil push only little at rest
            press = button_press(
                f"key_slide_{number}", travel=self.travel, preload=0.3, force=self.force, pivot=at
            )
            body = body.attach(cap.at(at), press)
        for number, (x, z) in enumerate(self._turned):
            tail = f"_{number}" if self.dials > 1 else ""
            at = (x, self.space.front - PANE, z)
            knob = dial(
                finish=self.knob,
                style=self.dial,
                radius=self.radius,
                depth=0.020,
                mark=ink_on(self.knob),
                cap=self.metal,
                name=f"dial{tail}",
                label="dial",
            )
            turn = dial_turn(f"dial_turn{tail}", endless=True, pivot=at)
            body = body.attach(knob.at(at), turn)
        return body
