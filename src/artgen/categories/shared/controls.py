"""Controls of appliances and lamps: push buttons, dials, panels with print, lamps and displays.

All are modeled about the origin on the plane y = 0, which is the face of their panel; they project to -y and
reach into the panel to +y. A finger is 18 mm thick: the distance between the middles of neighboring buttons
must be at least 10 mm plus half of a cap, and a cap must project by more than its travel.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import or_
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen._arrays import cached_property
from artgen.categories.shared import polar
from artgen.nodes.details.dials import SWEEP
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import FIT, Fitting

ButtonShape = Literal["round", "square", "pill", "bar"]
"""Outline of a cap: a circle, a square with rounded corners, a bar with round ends, or a plain bar."""

DialStyle = Literal["round", "fluted", "bar", "skirted", "capped"]
"""A plain cylinder, a fluted cylinder, a bar on a disc, a knob on a skirt, or a knob with a metal cap."""

DialScale = Literal["numbers", "ticks", "band", "icons"]
"""Print around a dial."""

PLAY = FIT.sliding
"""Gap between a cap and its hole, all around [m]."""

GAP = FIT.running
"""Gap between a dial and its panel [m]."""

PANE = 0.0006
"""Height of an inlay above its face [m]."""

CAP_DEEP = 0.009
"""Depth of the caps of a row behind the face [m]."""

_BESIDE = 0.0012  # gap between the caps of a row and their channel [m]
_BEFORE = 0.010  # length of the cutter of a hole in front of the face [m]
_FLUTES = 18
_FLUTE = 0.055  # depth of a flute, as a share of the radius
_CLEAR = 0.0012  # distance of finger tips from the panel [m]
_LAMP = 0.0009  # radius of a lamp beside an icon [m]
_DARK = ag.MATERIALS["abs"].with_(name="lamp_dark", base_color=(0.10, 0.10, 0.10), texture="", tile=None)

LIGHT_INK = ag.colored("abs", "light_grey").with_(name="light_ink", texture="", tile=None)
"""Print on dark faces."""

DARK_INK = ag.colored("abs", "graphite").with_(name="dark_ink", texture="", tile=None)
"""Print on bright faces."""


def ink_on(face: ag.Material) -> ag.Material:
    """Return the print with good contrast on a face."""
    luminance = sum(share * one for share, one in zip((0.21, 0.72, 0.07), face.base_color, strict=True))
    return DARK_INK if luminance > 0.12 else LIGHT_INK


def places(count: int, pitch: ag.Scalar, *, middle: ag.Scalar = 0.0) -> list[ag.Scalar]:
    """Return the centers of a row of parts along x [m]."""
    return [middle + (index - (count - 1) / 2) * pitch for index in range(count)]


def _united(profiles: Iterable[ag.Profile]) -> ag.Profile:
    return reduce(or_, profiles)


def button_outline(shape: ButtonShape, width: ag.Scalar, height: ag.Scalar) -> ag.Profile:
    """Make the outline of a cap, x to the right and y upward."""
    if shape == "round":
        return ag.circle(width / 2)
    share = {"square": 0.2, "pill": 0.499, "bar": 0.12}[shape]
    return ag.rectangle(width, height, radius=share * ag.min_(width, height))


def button_cap(
    *,
    finish: ag.Material,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    proud: ag.Scalar = 0.004,
    deep: ag.Scalar = 0.008,
    icon: str | ag.Profile = "",
    ink: ag.Material | None = None,
    name: str = "button",
) -> ag.Body:
    """Make the cap of a button with its push frame; attach it by `button_press`."""
    high = width if height is None or shape == "round" else height
    length, bevel = proud + deep, 0.0007
    if shape == "round":
        cap = ag.cylinder(width / 2, length, axis=ag.Y, bevel=bevel)
    else:
        cap = ag.extrude(button_outline(shape, width, high), length, axis=ag.Y, bevel=bevel)
    cap = cap.at(y=(deep - proud) / 2)
    body = ag.part(cap, "button", finish, name=name, push=ag.push_on(cap, direction=ag.Y))
    if ink is None or (isinstance(icon, str) and not icon):
        return body
    sign = details.icon(icon, 0.62 * ag.min_(width, high)) if isinstance(icon, str) else icon
    return ag.weld(body, details.printed(sign, (0, -proud, 0), material=ink))


def button_press(
    name: str = "button_slide",
    *,
    travel: ag.Scalar = 0.003,
    preload: ag.Scalar = 0.6,
    force: ag.Scalar = 3.0,
    damping: ag.Scalar | None = None,
    effort: ag.Scalar | None = None,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
) -> ag.Joint:
    """Make the joint of a button with a return spring; positive moves it into its panel (+y).

    Keys of appliances close at 2-4 N, and start at a fifth of that or more, so that they do not rattle.
    """
    return ag.Prismatic(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=(0.0, travel),
        spring=ag.Spring(preload=preload, force=force),
        feel=feel.SWITCH,
        damping=damping,
        effort=effort,
    )


def any_pressed(names: Iterable[str]) -> signals.Signal:
    """Return a signal that is 1 while any of these joints is pressed."""
    return reduce(or_, map(signals.pressed, names))


def button_hole(width: ag.Scalar, height: ag.Scalar | None = None, *, through: ag.Scalar = 0.01) -> ag.Solid:
    """Make the cutter for the hole of a cap, rectangular for all shapes, so that it needs few colliders.

    A `button_plate` covers the corners that round caps leave open.
    """
    high = width if height is None else height
    return ag.Region.centered(width + 2 * PLAY, 0.0, high + 2 * PLAY).grow(front=_BEFORE, back=through).box()


def button_plate(
    *,
    finish: ag.Material,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
) -> ag.Body:
    """Make the thin plate around a cap, with a hole of its shape, visual only."""
    high = width if height is None or shape == "round" else height
    hole = button_outline(shape, width + 2 * PLAY, high + 2 * PLAY)
    soft: ButtonShape = "bar" if shape == "bar" else "square"  # it has to cover the corners of the hole
    sheet = button_outline(soft, width + 0.004, high + 0.004) - hole  # with a border of 2 mm
    return ag.detail(ag.extrude(sheet, 0.0016, axis=ag.Y).at(y=0.0002), "bezel", finish)


def push_button(
    *,
    finish: ag.Material,
    through: ag.Scalar,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    proud: ag.Scalar = 0.004,
    deep: ag.Scalar = 0.008,
    travel: ag.Scalar = 0.003,
    preload: ag.Scalar = 0.6,
    force: ag.Scalar = 3.0,
    damping: ag.Scalar | None = None,
    effort: ag.Scalar | None = None,
    icon: str | ag.Profile = "",
    ink: ag.Material | None = None,
    plate: ag.Material | None = None,
    name: str = "button",
) -> Fitting:
    """Make a button with its joint `{name}_slide`, in a hole of depth `through` [m], perhaps with a plate."""
    cap = button_cap(
        finish=finish,
        shape=shape,
        width=width,
        height=height,
        proud=proud,
        deep=deep,
        icon=icon,
        ink=ink,
        name=name,
    )
    press = button_press(
        f"{name}_slide", travel=travel, preload=preload, force=force, damping=damping, effort=effort
    )
    around = None if plate is None else button_plate(finish=plate, shape=shape, width=width, height=height)
    high = None if shape == "round" else height
    return Fitting.moving(cap, press, fixed=around, cut=button_hole(width, high, through=through))


def _fluted() -> ag.Profile:
    """Make the outline of a fluted knob of radius 1."""
    angles = [math.tau * step / (4 * _FLUTES) for step in range(4 * _FLUTES)]
    return polar([1 - _FLUTE * (0.5 - 0.5 * math.cos(_FLUTES * angle)) for angle in angles])


def _disc(radius: ag.Scalar, near: ag.Scalar, far: ag.Scalar, bevel: ag.Scalar) -> ag.Solid:
    """Make a disc between two distances from the panel [m]."""
    return ag.cylinder(radius, far - near, axis=ag.Y, bevel=bevel).at(y=-(near + far) / 2)


def control_knob(
    *,
    finish: ag.Material,
    style: DialStyle = "round",
    radius: ag.Scalar = 0.016,
    depth: ag.Scalar = 0.016,
    mark: ag.Material | None = None,
    cap: ag.Material | None = None,
    name: str = "knob",
    label: str = "knob",
) -> ag.Body:
    """Make the knob of a dial with its grasp frame, its mark upward; attach it by `dial_turn`."""
    step = GAP + 0.3 * (depth - GAP)  # start of the grip of a knob with a base
    held: ag.Scalar = GAP
    front, reach = 1.0 * depth, 0.9 * radius
    inner, grip = depth - GAP - 0.001, -(depth + GAP + 0.001) / 2
    seen: list[ag.Body] = []
    solids: list[ag.Solid]
    match style:
        case "round" | "capped":
            solids = [_disc(radius, GAP, depth, 0.0012)]
        case "fluted":  # its ribs are visual only, so that its collider is one cylinder
            solids = [_disc((1 - _FLUTE) * radius, GAP, depth, 0.0012)]
            ribs = ag.extrude(_fluted().scale(radius), inner + 0.0004, axis=ag.Y, bevel=0.0006)
            seen = [ag.detail(ribs.at(y=grip + 0.0008), label, finish)]
        case "bar":
            bar = ag.box(0.44 * radius, inner, 1.94 * radius, bevel=0.0014).at(y=grip)
            solids, held = [bar, _disc(radius, GAP, step, 0.0012)], step
        case "skirted":
            skirt = ag.frustum(radius, 0.84 * radius, step - GAP, axis=-ag.Y, bevel=0.0008)
            core = ag.frustum(0.76 * radius, 0.7 * radius, inner, axis=-ag.Y, bevel=0.0012)
            solids, held, reach = [core.at(y=grip), skirt.at(y=-(step + GAP) / 2)], step, 0.68 * radius
    hold = ag.grasp_on(solids[0], approach=ag.Y, closing=ag.X, depth=front - held - _CLEAR)
    if style == "capped":
        front, reach = depth + 0.0008, 0.82 * radius
        seen = [ag.detail(_disc(0.86 * radius, depth - 0.001, front, 0.0005), label, cap or finish)]
    if mark is not None:
        line = details.pointer(0.42 * reach, 0.97 * reach, 0.0015 if style == "bar" else 0.0019)
        seen.append(details.printed(line, (0, -front, 0), material=mark))
    return ag.weld(ag.part(solids, label, finish, name=name, grasp=hold), *seen)


def dial_turn(
    name: str = "knob_turn",
    *,
    low: ag.Scalar = -2.4,
    high: ag.Scalar = 2.4,
    friction: ag.Scalar | None = None,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
    endless: bool = False,
    clicks: Sequence[ag.Scalar] = (),
    torque: ag.Scalar = 0.03,
) -> ag.Joint:
    """Make the joint of a dial; positive angles turn it clockwise, seen from the front.

    Its clicks are the angles of its detents [rad], with their greatest torque [N m].
    """
    limits = None if endless else (low, high)
    detents = feel.detents(clicks, torque) if clicks else None
    return ag.Revolute(
        name, axis=ag.Y, pivot=pivot, limits=limits, feel=feel.DIAL, friction=friction, detents=detents
    )


def dial_print(
    radius: ag.Scalar,
    *,
    ink: ag.Material,
    style: DialScale = "numbers",
    count: int = 6,
    icons: tuple[str, ...] = (),
    sweep: ag.Scalar = SWEEP,
    start: ag.Scalar | None = None,
    height: ag.Scalar = 0.0034,
) -> ag.Body:
    """Print the scale around a dial on the face y = 0."""
    out = radius + 0.002
    match style:
        case "numbers":
            numbers = [str(number + 1) for number in range(count)]
            scale = details.dial_scale(
                out, count, sweep=sweep, start=start, numbers=numbers, number_height=height, width=0.0005
            )
        case "ticks":
            scale = details.dial_scale(
                out, 2 * count - 1, sweep=sweep, start=start, major_every=2, major_length=0.0032, width=0.0005
            )
        case "band":
            scale = details.dial_band(out, 0.0004, 0.0034, sweep=sweep, start=start)
        case "icons":
            scale = details.dial_icons(icons, out + 1.2 * height, 2 * height, sweep=sweep, start=start)
    return details.printed(scale, material=ink)


def dial(
    turn: ag.Joint,
    style: DialStyle,
    radius: ag.Scalar,
    finish: ag.Material,
    *,
    depth: ag.Scalar,
    cap: ag.Material | None = None,
    scale: ag.Body | None = None,
    name: str = "dial",
) -> Fitting:
    """Make a knob, the link `name`, on its joint, and the print of its scale on the panel."""
    ink = ink_on(finish)
    knob = control_knob(
        finish=finish, style=style, radius=radius, depth=depth, mark=ink, cap=cap, name=name, label="dial"
    )
    return Fitting.moving(knob, turn, fixed=scale)


def inlay(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    finish: ag.Material = ag.MATERIALS["black_glass"],
    radius: ag.Scalar = 0.003,
    holes: ag.Profile | None = None,
) -> ag.Body:
    """Make a thin pane on the face, about the origin."""
    outline = ag.rectangle(width, height, radius=radius)
    if holes is None:
        solid = details.relief(outline, proud=PANE, sunk=0.0006, bevel=0.0003)
    else:
        solid = ag.extrude(outline - holes, PANE + 0.0006, axis=ag.Y).at(y=(0.0006 - PANE) / 2)
    return ag.detail(solid, "panel", finish)


@dataclass(frozen=True)
class ButtonRow:
    """Equal push buttons in a row along x on the plane y = 0, in one channel of their panel."""

    count: int
    shape: ButtonShape
    pitch: float  # distance between their middles [m]
    middle: ag.Scalar  # of the row along x [m]

    @cached_property
    def size(self) -> tuple[float, float]:
        """Width and height of a cap [m]."""
        return (0.0155, 0.0085) if self.shape in ("pill", "bar") else (0.0115, 0.0115)

    @cached_property
    def at(self) -> list[ag.Scalar]:
        """Positions along x [m]."""
        return places(self.count, self.pitch, middle=self.middle)

    @cached_property
    def holes(self) -> ag.Profile:
        """Holes of the caps, to be cut out of an `inlay`."""
        wide, high = self.size
        hole = button_outline(self.shape, wide + 2 * PLAY, high + 2 * PLAY)
        return _united(hole.at(place) for place in self.at)

    def channel(self, panel: ag.Region) -> ag.Region:
        """Return the channel of the buttons through a panel."""
        wide, high = self.size
        half = ((self.count - 1) * self.pitch + wide) / 2 + _BESIDE
        z = high / 2 + _BESIDE
        return panel.with_(x=(self.middle - half, self.middle + half), z=(-z, z))

    def install(
        self,
        panel: ag.Body,
        finish: ag.Material,
        *,
        proud: ag.Scalar,
        travel: ag.Scalar,
        force: ag.Scalar,
        preload: float,
        icons: Sequence[str] = (),
        ink: ag.Material | None = None,
    ) -> ag.Body:
        """Attach the caps to their panel as `button_0`, ..., with their travel and force at the end."""
        wide, high = self.size
        for index, x in enumerate(self.at):
            cap = button_cap(
                finish=finish,
                shape=self.shape,
                width=wide,
                height=high,
                proud=proud,
                deep=CAP_DEEP,
                icon=icons[index] if icons else "",
                ink=ink,
                name=f"button_{index}",
            )
            press = button_press(f"button_slide_{index}", travel=travel, force=force, preload=preload)
            panel = panel.attach(cap, press, at=(x, 0, 0))
        return panel


def icon_row(
    icons: Sequence[str],
    at: Sequence[ag.Scalar],
    *,
    height: ag.Scalar = 0.007,
    level: ag.Scalar = 0.0,
    ink: ag.Material = LIGHT_INK,
    proud: ag.Scalar = PANE,
) -> ag.Body:
    """Print a row of icons as one film."""
    row = zip(icons, at, strict=False)
    film = _united(details.icon(name, height).at(place, level) for name, place in row if name)
    return details.printed(film, (0, -proud, 0), material=ink)


def lamp_row(
    at: Sequence[ag.Scalar], *, level: ag.Scalar = 0.0, lit: int = 0, proud: ag.Scalar = PANE
) -> ag.Body:
    """Make a row of small lamps; one of them is lit."""
    bodies = []
    for shines, finish in ((True, ag.MATERIALS["led_white"]), (False, _DARK)):
        lamps = [ag.circle(_LAMP).at(x, level) for index, x in enumerate(at) if (index == lit) == shines]
        if lamps:
            solid = details.relief(_united(lamps), (0, -proud, 0), proud=0.0003)
            bodies.append(ag.detail(solid, "print", finish))
    return ag.weld(*bodies)


def control_panel(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    icons: Sequence[str] = (),
    pitch: ag.Scalar = 0.022,
    show: str = "",
    screen: tuple[ag.Scalar, ag.Scalar] = (0.05, 0.018),
    color: Color = "white",
) -> ag.Body:
    """Make a touch panel of black glass about the origin, with a display and a row of icons with lamps.

    The display is in the middle with half of the icons at each side.
    """
    bodies, tall = [inlay(width, height, radius=0.004)], 0.008
    if show:
        bodies.append(details.display(show, *screen, at=(0.0, -PANE, 0.0), color=color))
    if icons:
        row = places(len(icons), pitch)
        if show:
            half, aside = (len(icons) + 1) // 2, screen[0] / 2 + 0.4 * pitch
            row = [-aside - (half - index - 0.5) * pitch for index in range(half)]
            row += [aside + (index + 0.5) * pitch for index in range(len(icons) - half)]
        bodies.append(icon_row(icons, row, height=tall))
        bodies.append(lamp_row(row, level=-0.85 * tall))
    return ag.weld(*bodies)
