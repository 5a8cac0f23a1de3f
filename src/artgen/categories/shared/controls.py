"""Controls of appliances and lamps: push buttons, dials, panels with print, lamps and displays.

All are modeled about the origin on the plane y = 0, which is the face of their panel; they project to -y and
reach into the panel to +y. A finger is 18 mm thick: the distance between the middles of neighboring buttons
must be at least 10 mm plus half of a cap, and a cap must project by more than its travel.
"""

import math
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details
from artgen.nodes.details.dials import SWEEP
from artgen.nodes.details.displays import Color

ButtonShape = Literal["round", "square", "pill", "bar"]
"""Outline of a cap: a circle, a square with rounded corners, a bar with round ends, or a plain bar."""

PLAY = 0.0004
"""Gap between a cap and its hole, all around [m]."""

_BEFORE = 0.010  # length of the cutter of a hole in front of the face [m]
_BEVEL = 0.0007  # bevel of the rim of a cap [m]


def button_outline(shape: ButtonShape, width: ag.Scalar, height: ag.Scalar) -> ag.Profile:
    """Make the outline of a cap, x to the right and y upward."""
    if shape == "round":
        return ag.circle(width / 2)
    share = {"square": 0.2, "pill": 0.499, "bar": 0.12}[shape]
    return ag.rectangle(width, height, radius=share * ag.min_(width, height))


def push_button(
    *,
    finish: ag.Material,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    proud: ag.Scalar = 0.004,
    deep: ag.Scalar = 0.008,
    icon: str = "",
    ink: ag.Material | None = None,
    name: str = "button",
) -> ag.Body:
    """Make the cap of a button with its push frame; attach it by `button_press`."""
    high = width if height is None or shape == "round" else height
    length = proud + deep
    if shape == "round":
        cap = ag.cylinder(width / 2, length, axis=ag.Y, bevel=_BEVEL)
    else:
        cap = ag.extrude(button_outline(shape, width, high), length, axis=ag.Y, bevel=_BEVEL)
    cap = cap.at(0.0, (deep - proud) / 2, 0.0)
    body = ag.part(cap, "button", finish, name=name, push=ag.push_on(cap, direction=ag.Y))
    if not icon or ink is None:
        return body
    sign = details.icon(icon, 0.62 * ag.min_(width, high))
    return ag.weld(body, details.printed(sign, (0.0, -proud, 0.0), material=ink))


def button_press(
    name: str = "button_slide",
    *,
    travel: ag.Scalar = 0.003,
    preload: ag.Scalar = 0.6,
    force: ag.Scalar = 3.0,
    damping: ag.Scalar = 6.0,
    effort: ag.Scalar = 12.0,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
) -> ag.Joint:
    """Make the joint of a button with a return spring; positive moves it into its panel (+y).

    Keys of appliances close at 2-4 N, and start at a fifth of that or more, so that they do not rattle.
    """
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.1,  # friction of the cap in its guide
        armature=0.03,  # inertia of the switch; a lighter part would sink into its stop in MuJoCo
        effort=effort,
    )


def button_hole(
    width: ag.Scalar, height: ag.Scalar | None = None, *, through: ag.Scalar = 0.01, play: ag.Scalar = PLAY
) -> ag.Solid:
    """Make the cutter for the hole of a cap, rectangular for all shapes, so that it needs few colliders.

    A `button_plate` covers the corners that round caps leave open.
    """
    high = width if height is None else height
    hole = ag.box(width + 2 * play, _BEFORE + through, high + 2 * play)
    return hole.at(0.0, (through - _BEFORE) / 2, 0.0)


def button_plate(
    *,
    finish: ag.Material,
    shape: ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    border: ag.Scalar = 0.002,
    proud: ag.Scalar = 0.0006,
    label: str = "bezel",
) -> ag.Body:
    """Make the thin plate around a cap, with a hole of its shape, visual only."""
    high = width if height is None or shape == "round" else height
    hole = button_outline(shape, width + 2 * PLAY, high + 2 * PLAY)
    wide, tall = width + 2 * border, high + 2 * border
    soft = "square" if shape in ("round", "pill") else shape  # the plate has to cover the corners of the hole
    sheet = button_outline(soft, wide, tall) - hole
    solid = ag.extrude(sheet, proud + 0.001, axis=ag.Y).at(0.0, (0.001 - proud) / 2, 0.0)
    return ag.detail(solid, label, finish)


DialStyle = Literal["round", "fluted", "bar", "skirted", "capped"]
"""A plain cylinder, a fluted cylinder, a bar on a disc, a knob on a skirt, or a knob with a metal cap."""

GAP = 0.0006
"""Gap between a dial and its panel [m]."""

_FLUTES = 18
_FLUTE = 0.055  # depth of a flute, as a share of the radius
_CLEAR = 0.0012  # distance of finger tips from the panel [m]


def _fluted() -> ag.Profile:
    """Make the outline of a fluted knob of radius 1."""
    steps = 4 * _FLUTES
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 - _FLUTE * (0.5 - 0.5 * math.cos(_FLUTES * angle)) for angle in angles]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def _disc(radius: ag.Scalar, near: ag.Scalar, far: ag.Scalar, bevel: ag.Scalar) -> ag.Solid:
    """Make a disc between two distances from the panel [m]."""
    return ag.cylinder(radius, far - near, axis=ag.Y, bevel=bevel).at(0.0, -0.5 * (near + far), 0.0)


def dial(
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
    """Make a knob with its grasp frame, its mark upward; attach it by `dial_turn`."""
    step = GAP + 0.3 * (depth - GAP)  # start of the grip of a knob with a base
    bevel = 0.0012
    solids: list[ag.Solid]
    held: ag.Scalar = GAP
    front, reach = 1.0 * depth, 0.9 * radius
    match style:
        case "round" | "capped":
            solids = [_disc(radius, GAP, depth, bevel)]
        case "fluted":
            solids = [_disc((1.0 - _FLUTE) * radius, GAP, depth, bevel)]
        case "bar":
            held = step
            bar = ag.box(0.44 * radius, depth - GAP - 0.001, 1.94 * radius, bevel=0.0014)
            solids = [bar.at(0.0, -0.5 * (depth + GAP + 0.001), 0.0), _disc(radius, GAP, step, bevel)]
        case "skirted":
            held, reach = step, 0.68 * radius
            skirt = ag.frustum(radius, 0.84 * radius, step - GAP, axis=-ag.Y, bevel=0.0008)
            solids = [
                ag.frustum(0.76 * radius, 0.7 * radius, depth - GAP - 0.001, axis=-ag.Y, bevel=bevel).at(
                    0.0, -0.5 * (depth + GAP + 0.001), 0.0
                ),
                skirt.at(0.0, -0.5 * (step + GAP), 0.0),
            ]
    hold = ag.grasp_on(solids[0], approach=ag.Y, closing=ag.X, depth=front - held - _CLEAR)
    bodies = [ag.part(solids[0], label, finish, name=name, grasp=hold)]
    bodies += [ag.part(each, label, finish) for each in solids[1:]]
    if style == "fluted":  # its ribs are visual only, so that its collider is one cylinder
        ribs = ag.extrude(_fluted().scale(radius), depth - GAP - 0.0006, axis=ag.Y, bevel=0.0006)
        bodies.append(ag.detail(ribs.at(0.0, -0.5 * (depth + GAP - 0.0006), 0.0), label, finish))
    if style == "capped":
        plate = _disc(0.86 * radius, depth - 0.001, depth + 0.0008, 0.0005)
        bodies.append(ag.detail(plate, label, cap or finish))
        front = depth + 0.0008
        reach = 0.82 * radius
    if mark is not None:
        line = details.pointer(0.42 * reach, 0.97 * reach, 0.0015 if style == "bar" else 0.0019)
        bodies.append(details.printed(line, (0.0, -front, 0.0), material=mark))
    return ag.weld(*bodies)


def dial_turn(
    name: str = "knob_turn",
    *,
    low: ag.Scalar = -2.4,
    high: ag.Scalar = 2.4,
    friction: ag.Scalar = 0.045,
    damping: ag.Scalar = 0.003,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
    endless: bool = False,
) -> ag.Joint:
    """Make the joint of a dial; positive angles turn it clockwise, seen from the front.

    Rotary switches of appliances turn at 0.02-0.06 N m; friction represents their detents.
    """
    return ag.Revolute(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=None if endless else (low, high),
        friction=friction,
        damping=damping,
        armature=0.00002,  # inertia of the shaft and the wiper
        effort=0.6,  # two fingers at a radius of 15 mm, 20 N each
    )


def dial_print(
    radius: ag.Scalar,
    *,
    ink: ag.Material,
    style: Literal["numbers", "ticks", "band", "icons"] = "numbers",
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
            scale = details.dial_icons(icons, out + 1.2 * height, 2.0 * height, sweep=sweep, start=start)
    return details.printed(scale, (0.0, 0.0, 0.0), material=ink)


PANE = 0.0006
"""Height of an inlay above its face [m]."""

_LAMP = 0.0009  # radius of a lamp beside an icon [m]
_FILM = 0.0002  # height of print above its face [m]

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
    return [middle + (index - (count - 1) / 2.0) * pitch for index in range(count)]


def inlay(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    finish: ag.Material | None = None,
    radius: ag.Scalar = 0.003,
    holes: ag.Profile | None = None,
    proud: ag.Scalar = PANE,
    label: str = "panel",
) -> ag.Body:
    """Make a thin pane on the face, about the origin."""
    outline = ag.rectangle(width, height, radius=radius)
    if holes is None:
        solid = details.relief(outline, proud=proud, sunk=0.0006, bevel=0.0003)
    else:
        solid = ag.extrude(outline - holes, proud + 0.0006, axis=ag.Y).at(0.0, (0.0006 - proud) / 2.0, 0.0)
    return ag.detail(solid, label, finish or ag.MATERIALS["black_glass"])


def button_holes(
    shape: ButtonShape,
    width: ag.Scalar,
    height: ag.Scalar,
    at: Sequence[ag.Scalar],
    *,
    level: ag.Scalar = 0.0,
) -> ag.Profile:
    """Make the holes of a row of buttons with gaps around the caps, to be cut out of an `inlay`."""
    hole = button_outline(shape, width + 2.0 * PLAY, height + 2.0 * PLAY)
    holes = hole.at(at[0], level)
    for place in at[1:]:
        holes = holes | hole.at(place, level)
    return holes


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
    found = [
        details.icon(name, height).at(place, level) for name, place in zip(icons, at, strict=False) if name
    ]
    film = found[0]
    for one in found[1:]:
        film = film | one
    return details.printed(film, (0.0, -proud, 0.0), material=ink, proud=_FILM)


def lamp_row(
    at: Sequence[ag.Scalar],
    *,
    level: ag.Scalar = 0.0,
    lit: int = 0,
    color: Literal["white", "green", "blue", "amber", "red"] = "white",
    proud: ag.Scalar = PANE,
) -> ag.Body:
    """Make a row of small lamps; one of them is lit."""
    dark = ag.MATERIALS["abs"].with_(name="lamp_dark", base_color=(0.10, 0.10, 0.10), texture="", tile=None)
    groups = [
        ([place for index, place in enumerate(at) if (index == lit) == shines], each)
        for shines, each in ((True, ag.MATERIALS[f"led_{color}"]), (False, dark))
    ]
    bodies = []
    for found, finish in groups:
        if found:
            film = ag.circle(_LAMP).at(found[0], level)
            for place in found[1:]:
                film = film | ag.circle(_LAMP).at(place, level)
            solid = details.relief(film, (0.0, -proud, 0.0), proud=0.0003)
            bodies.append(ag.detail(solid, "print", finish))
    return ag.weld(*bodies)


def control_panel(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    icons: Sequence[str] = (),
    pitch: ag.Scalar = 0.022,
    icon_height: ag.Scalar = 0.008,
    show: str = "",
    screen: tuple[ag.Scalar, ag.Scalar] = (0.05, 0.018),
    color: Color = "white",
    upright: bool = False,
    finish: ag.Material | None = None,
    ink: ag.Material | None = None,
    radius: ag.Scalar = 0.004,
) -> ag.Body:
    """Make a touch panel about the origin: a pane with a display and a row of icons, each with a lamp.

    The display is in the middle with half of the icons at each side, or above the icons of a vertical panel.
    """
    face = finish or ag.MATERIALS["black_glass"]
    print_ = ink or ink_on(face)
    bodies = [inlay(width, height, finish=face, radius=radius)]
    if show:
        top = 0.5 * height - 0.9 * screen[1]
        at = (0.0, -PANE, top if upright and icons else 0.0)
        bodies.append(details.display(show, *screen, at=at, color=color))
    if icons and upright:
        bodies.append(_column(icons, pitch, icon_height, -0.5 * screen[1] if show else 0.0, print_))
    elif icons:
        aside = 0.5 * screen[0] + 0.4 * pitch if show else 0.0
        row = _beside(len(icons), pitch, aside) if show else places(len(icons), pitch)
        bodies.append(icon_row(icons, row, height=icon_height, ink=print_))
        bodies.append(lamp_row(row, level=-0.85 * icon_height))
    return ag.weld(*bodies)


def _beside(count: int, pitch: ag.Scalar, aside: ag.Scalar) -> list[ag.Scalar]:
    """Return positions at both sides of a display, at least `aside` from x = 0 [m]."""
    half = (count + 1) // 2
    left = [-aside - (half - index - 0.5) * pitch for index in range(half)]
    return [*left, *(aside + (index + 0.5) * pitch for index in range(count - half))]


def _column(
    icons: Sequence[str], pitch: ag.Scalar, height: ag.Scalar, middle: ag.Scalar, ink: ag.Material
) -> ag.Body:
    """Print a column of icons."""
    rows = [middle + ((len(icons) - 1) / 2.0 - index) * pitch for index in range(len(icons))]
    return ag.weld(
        *(
            icon_row([name], [0.0], height=height, level=level, ink=ink)
            for name, level in zip(icons, rows, strict=True)
        )
    )
