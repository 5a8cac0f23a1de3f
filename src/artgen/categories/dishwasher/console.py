"""The console of a dishwasher: buttons, a dial, a display, icons and the maker's name.

The console is modeled about the origin on the plane y = 0 and faces -y; a console on the upper edge of a door
is then turned over.
"""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.shared.controls import (
    PANE,
    ButtonShape,
    DialStyle,
    button_cap,
    button_holes,
    button_press,
    control_knob,
    dial_print,
    dial_turn,
    icon_row,
    ink_on,
    inlay,
    lamp_row,
    places,
)
from artgen.nodes.details.displays import Color

ICONS = ("power", "wash", "timer", "leaf", "cup", "rinse", "drop", "start_pause")
"""Icons of the buttons; every machine has the first and the last icon."""

LAP = 0.0005
"""Overlap of boards, so that they share no corners [m]."""

_DEEP = 0.009  # depth of caps behind the face [m]
_ROOM = 0.0025  # space behind a cap that is pressed home [m]


@dataclass(frozen=True)
class Console:
    """Layout and finish of a console."""

    width: ag.Scalar  # width of the face [m]
    height: ag.Scalar  # height of the face [m]
    finish: ag.Material  # finish of the face
    pane: bool  # whether a pane of black glass covers the face
    buttons: int  # number of buttons
    shape: ButtonShape  # shape of the caps
    cap: ag.Material  # finish of the caps
    travel: ag.Scalar  # travel of the buttons [m]
    force: ag.Scalar  # force that presses the buttons home [N]
    dial: DialStyle | str  # style of the cycle dial; `""` for none
    show: str  # text of the display; `""` for none
    color: Color  # color of the figures of the display
    middle: ag.Scalar  # middle of the buttons along x [m]
    aside: ag.Scalar  # middle of the display along x [m]
    far: ag.Scalar  # position of the dial along x [m]
    upper: bool = False  # whether the console is on the upper edge of the door, with little space for print
    # half the length and half the height of the opening for a recessed grip in the middle [m]; both are 0
    # without a grip
    opening: tuple[float, float] = (0.0, 0.0)
    thickness: float = 0.018  # thickness of the console's boards [m]

    @cached_property
    def pitch(self) -> float:
        """Distance between buttons: a finger 18 mm wide does not touch the neighbors [m]."""
        return 0.0205

    @cached_property
    def _cap_width(self) -> float:
        return 0.0155 if self.shape in ("pill", "bar") else 0.0115

    @cached_property
    def _cap_height(self) -> float:
        return 0.0085 if self.shape in ("pill", "bar") else 0.0115

    @cached_property
    def _at(self) -> list[ag.Scalar]:
        return places(self.buttons, self.pitch, middle=self.middle)

    @cached_property
    def _face(self) -> ag.Material:
        return ag.material("black_glass") if self.pane else self.finish

    @cached_property
    def _names(self) -> tuple[str, ...]:
        """Return the icons of the buttons, or of the touch keys of a console without buttons."""
        count = self.buttons or 5
        return (*ICONS[: count - 1], ICONS[-1]) if count > 1 else ICONS[:1]

    def boards(self) -> list[ag.Solid]:
        """Make the boards of the face, around the channel of the buttons."""
        x, z = 0.5 * self.width, 0.5 * self.height
        y: ag.Span = (0.0, self.thickness)
        wide, tall = self.opening
        if not self.buttons and not wide:
            return [ag.Region((-x, x), y, (-z, z)).box(bevel=0.0015)]
        end = -wide if wide else x  # end of the remaining opening
        boards = []
        if wide:
            boards += [
                ag.Region((wide, x), y, (-z, z)).box(),
                ag.Region((-wide - LAP, wide + LAP), y, (tall, z)).box(),
                ag.Region((-wide - LAP, wide + LAP), y, (-z, -tall)).box(),
            ]
        if not self.buttons:
            return [*boards, ag.Region((-x, end), y, (-z, z)).box()]
        left, right = self._channel
        room = "the buttons have no room on the console: raise width, or lower buttons"
        left, right = ag.require(left, left > -x, room), ag.require(right, right < end, room)
        half = 0.5 * self._cap_height + 0.0012
        return [
            *boards,
            ag.Region((-x, end), y, (half, z)).box(),
            ag.Region((-x, end), y, (-z, -half)).box(),
            ag.Region((-x, left), y, (-half - LAP, half + LAP)).box(),
            ag.Region((right, end), y, (-half - LAP, half + LAP)).box(),
        ]

    @cached_property
    def _channel(self) -> ag.Span:
        half = 0.5 * ((self.buttons - 1) * self.pitch + self._cap_width) + 0.0012
        return (self.middle - half, self.middle + half)

    def printed(self) -> ag.Body:
        """Make the pane, the strip around the buttons, display, icons and lamps, visual only."""
        face, bodies = self._face, []
        ink = ink_on(face)
        holes = None
        if self.buttons:
            holes = button_holes(self.shape, self._cap_width, self._cap_height, self._at)
        if self.pane or holes is not None:
            high = self.height - 0.010 if self.pane else self._cap_height + 0.011
            if self.pane:
                wide: ag.Scalar = self.width - 0.012
                bodies.append(inlay(wide, high, holes=holes, radius=0.004))
            else:
                left, right = self._channel
                wide = right - left + 0.010
                moved = button_holes(
                    self.shape, self._cap_width, self._cap_height, places(self.buttons, self.pitch)
                )
                strip = inlay(wide, high, finish=self.finish, holes=moved, radius=0.003)
                bodies.append(strip.at(self.middle, 0.0, 0.0))
        proud = PANE if self.pane else 0.0001
        at = self._at if self.buttons else places(5, self.pitch, middle=self.middle)
        tall = not self.upper
        if self.buttons:
            if tall:
                rise = 0.5 * self._cap_height + 0.0105
                bodies.append(icon_row(self._names, at, height=0.0088, level=rise, ink=ink, proud=proud))
                bodies.append(lamp_row(at, level=-0.5 * self._cap_height - 0.0080, lit=1, proud=proud))
        else:
            bodies.append(icon_row(self._names, at, height=0.0105, ink=ink, proud=proud))
            bodies.append(lamp_row(at, level=-0.0105, lit=1, proud=proud))
        if self.show:
            size = (0.052, 0.020) if tall else (0.044, 0.014)
            screen = details.display(self.show, *size, at=(self.aside, -proud, 0.0), color=self.color)
            bodies.append(screen)
        if self.dial:
            ring = dial_print(0.021 if tall else 0.015, ink=ink, style="ticks", count=6)
            bodies.append(ring.at(self.far, -proud, 0.0))
        if not bodies:
            bodies.append(lamp_row([self.aside], proud=proud))
        return ag.weld(*bodies)

    def joined(self, body: ag.Body) -> ag.Body:
        """Attach the buttons and the dial to a body with the console."""
        ink = ink_on(self.cap)
        for index, place in enumerate(self._at):
            cap = button_cap(
                finish=self.cap,
                shape=self.shape,
                width=self._cap_width,
                height=self._cap_height,
                proud=self.travel + 0.0012,
                deep=_DEEP,
                icon=self._names[index] if self.upper else "",
                ink=ink if self.upper else None,
                name=f"button_{index}",
            )
            press = button_press(
                f"button_slide_{index}",
                travel=self.travel,
                force=self.force,
                preload=0.3,
                pivot=(place, 0.0, 0.0),
            )
            body = body.attach(cap.at(place, 0.0, 0.0), press)
        if self.dial:
            small = self.upper
            knob = control_knob(
                finish=self.cap,
                style=self.dial,  # type: ignore[arg-type] # "" is none
                radius=0.015 if small else 0.021,
                depth=0.018,
                mark=ink,
                cap=ag.material("aluminium"),
            )
            turn = dial_turn(pivot=(self.far, 0.0, 0.0))
            body = body.attach(knob.at(self.far, 0.0, 0.0), turn)
        return body

    def body(self, label: str = "panel") -> ag.Body:
        """Make the whole console: boards, print, buttons and dial."""
        solid = ag.weld(*(ag.part(each, label, self.finish) for each in self.boards()), self.printed())
        return self.joined(solid)
