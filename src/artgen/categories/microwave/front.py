"""The front of a microwave oven: the door with its latches, and the control panel."""

from dataclasses import dataclass
from functools import partial, reduce
from operator import or_
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.microwave.case import BARB, HOOK, LAMP, LAP, Plan, gaps_between
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.controls import (
    PLAY,
    ButtonShape,
    button_cap,
    button_outline,
    dial_print,
    ink_on,
)
from artgen.categories.shared.pulls import BarStyle, bar_handle, recessed_grip
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import Fitting
from artgen.nodes.region import Extent

HandleKind = Literal["bar", "pocket", "none"]
"""A bar on the door, a recess with a blade in it, or none for a door with an opening button."""

FaceStyle = Literal["framed", "glass", "banded"]
"""A frame around dark glass, a glass front, or glass between two bands of the finish."""

PANE = 0.0008
"""Height of the front glass above the frame [m]."""

GIRTH, PROJECTION = 0.0072, 0.034
"""Half of the thickness of a bar, and the distance of its middle from the door [m]."""

_UNDER = 0.0003  # distance from visible faces to the boards under them [m]
_BAND = 0.030  # height of the bands above and below the glass of a banded front [m]
_EDGE = 0.015  # width of the glass around the window of a framed front [m]
_SKIN = 0.014  # thickness of the outer frame of the door [m]
_POCKET = (0.050, 0.0275, 0.098)  # width, depth and height of a recess: 9 mm for fingers beside its blade [m]

_GAP = 0.0006  # gap between pawl and hook [m]
_PAWL = (0.0030, 0.0090)  # thickness and height of a pawl [m]
_BEHIND = 0.0036  # distance from the face of the cavity's frame to the pawls [m]
_LIFT = 1.22  # ratio of the lift of the pawls to the travel of the button
_SPARE = 0.0006  # gap between pawls and barbs at which the door may open [m]


def latch(plan: Plan, button: ag.Joint) -> Fitting:
    """Make the slide with two pawls, the link `latch`, which the button lifts."""
    low, high = plan.hooks
    start = plan.cavity.y.low + _BEHIND
    spine = ag.Region(
        (low.x.mid + 0.0058, low.x.mid + 0.0096),
        (start, start + _PAWL[0]),
        (low.z.high + _GAP, high.z.high + _GAP + _PAWL[1]),
    )
    across = spine.shrink(y=0.0002).with_(x=(low.x.mid - 0.0042, low.x.mid + 0.0060))
    fingers = [
        across.with_(z=(hook.z.high + _GAP, hook.z.high + _GAP + _PAWL[1] - 0.0004)) for hook in (low, high)
    ]
    plastic = ag.colored("polypropylene", "ivory").with_(name="latch_plastic")
    slide = ag.Prismatic(
        "latch_slide", axis=ag.Z, follows=_LIFT * button, damping=2, friction=0.05, armature=0.02
    )
    return Fitting.moving(ag.part([each.box() for each in (spine, *fingers)], "latch", plastic), slide)


def hinge(plan: Plan, swing: ag.Scalar, force: ag.Scalar, button: ag.Joint | None) -> ag.Joint:
    """Make the joint of the door, which a button, if there is one, unlocks.

    Friction holds a door with a handle at any angle: 10-25 N at the handle release the hooks from their
    catches and move the door. A spring opens a door with a button to 0.3 rad, and friction holds it from
    there on.
    """
    arm, torque = plan.arm, force * plan.arm
    if button is None:
        drag = feel.Feel(friction=torque, damping=0.25, effort=50 * arm, velocity=5)
        return ag.Revolute("door_hinge", axis=-ag.Z, pivot=plan.pivot, limits=(0, swing), feel=drag)
    passing = HOOK[2] - _BEHIND + 0.004  # travel of the barbs below the pawls [m]
    # friction is the spring force at 0.8 rad, so that it holds the door from 0.3 rad to the end
    rest, held = 1.15, 0.85
    return ag.Revolute(
        "door_hinge",
        axis=-ag.Z,
        pivot=plan.pivot,
        limits=(0, swing),
        stiffness=torque / rest,
        rest=rest,
        friction=held * torque / rest,
        damping=0.12,
        effort=30 * arm,
        velocity=5,
        needs=(button > (BARB[0] - _GAP + _SPARE) / _LIFT).until(passing / arm),
        driven="its spring",
    )


def _slab(outline: ag.Profile, y: Extent, bevel: float = 0.0) -> ag.Solid:
    """Make a plate of an outline, with a bevel at the front only."""
    return details.relief(outline, (0, y.mid, 0), proud=y.size / 2, sunk=y.size / 2, bevel=bevel)


@dataclass(frozen=True)
class Finish:
    """Style and materials of the front."""

    face: FaceStyle
    front: ag.Material  # frame of the door, and face of the panel
    glass: ag.Material  # panes
    around: ag.Material  # around the controls
    metal: ag.Material  # handle
    lining: ag.Material  # inside of the door
    caps: ag.Material  # keys and button


def _glass(face: FaceStyle, front: ag.Region) -> ag.Profile:
    """Return the outline of the glass of a front that has no frame around it."""
    if face == "banded":
        return front.shrink(x=0.0003, z=_BAND).front()
    return front.shrink(0.0015).front(radius=0.003)


def door(
    plan: Plan, finish: Finish, handle: HandleKind, bar: BarStyle, *, border: ag.Scalar, maker: str
) -> ag.Body:
    """Make the door; `border` is the height of its frame above and below the window [m]."""
    leaf, room = plan.door, plan.cavity
    pocket = ag.Region.centered(*_POCKET).at(leaf.x.high - _POCKET[0] / 2 - 0.009, 0, leaf.z.mid)
    recess = pocket if handle == "pocket" else None
    right = room.x.high - (0.046 if recess else 0.010)
    view = leaf.shrink(z=border).with_(x=(room.x.low + 0.008, right))
    pane = view.grow(_EDGE).front(radius=0.012) if finish.face == "framed" else _glass(finish.face, leaf)
    pane = pane - view.shrink(0.002).front(radius=0.005)
    if recess and finish.face != "framed":
        pane = pane - recess.grow(0.0034).front(radius=0.004)
    plastic = ag.colored("polypropylene", "graphite").with_(name="hook_plastic")
    bodies = [
        ag.part(_boards(plan, view, recess), "door", filled(finish.front, 670, "door")),
        *_frame(leaf, view, recess, finish),
        *_window(leaf, view),
        *_cover(plan, view),
        ag.part(_barbed_hooks(plan), "latch", plastic),
        _pane(pane, leaf, "door", finish.glass),
    ]
    width, deep, length = _POCKET
    if handle == "bar":
        made: ag.Body = bar_handle(
            length=0.74 * leaf.z.size, finish=finish.metal, style=bar, projection=PROJECTION, girth=GIRTH
        )
        bodies.append(made.at(leaf.x.high - 0.021, leaf.y.low, leaf.z.mid))
    if recess:
        lining = ag.colored("abs", "graphite").with_(name="grip_lining")
        grip = recessed_grip(length, finish=finish.metal, lining=lining, width=width, deep=deep, thin=True)
        bodies.append(grip.body.at(recess.x.mid, leaf.y.low, recess.z.mid))
    if maker:
        under, proud = (finish.glass, PANE) if finish.face == "glass" else (finish.front, 0)
        top = {"framed": view.z.low - _EDGE, "glass": view.z.low, "banded": leaf.z.low + _BAND}[finish.face]
        at = (view.x.mid, leaf.y.low - proud, (leaf.z.low + top) / 2)
        bodies.append(details.printed(details.logo(maker, 0.0062), at, material=ink_on(under)))
    return ag.weld(*bodies)


def _pane(outline: ag.Profile, front: ag.Region, label: str, glass: ag.Material) -> ag.Body:
    return ag.detail(details.relief(outline, (0, front.y.low, 0), proud=PANE, sunk=0.0006), label, glass)


def _barbed_hooks(plan: Plan) -> list[ag.Solid]:
    solids = []
    for hook in plan.hooks:
        barb = hook.deep(None, BARB[1])[1].shrink(0.0002, front=0, bottom=0.002, top=-BARB[0])
        solids += [hook.box(bevel=0.0008), barb.box(bevel=0.0006)]
    return solids


def _boards(plan: Plan, view: ag.Region, pocket: ag.Region | None) -> list[ag.Solid]:
    """Make the boards of the door around the window, and around and behind a recess."""
    core = plan.door.shrink(0.0012, y=_UNDER)
    left, right, below, above = core.around(view, lap=LAP)
    boards = [left, below, above, right]
    if pocket:
        behind = pocket.grow(LAP).with_(y=(plan.door.y.low + _POCKET[1], core.y.high - 2 * LAP))
        boards[3:] = [*right.around(pocket, lap=LAP), behind]
    return [each.box() for each in boards]


def _frame(leaf: ag.Region, view: ag.Region, pocket: ag.Region | None, finish: Finish) -> list[ag.Body]:
    """Make the visible frame in two layers: the front, and the microwave choke behind it."""
    skin, choke = leaf.deep(_SKIN, None)
    bodies = []
    for layer, material, inset, bevel in (
        (skin, finish.front, 0.0, 0.0014),
        (choke.shrink(front=-LAP, back=0, x=0.0009, z=0.0009), finish.lining, 0.0009, 0.0),
    ):
        outline = layer.front() - view.shrink(inset / 2).front()
        if pocket:
            outline = outline - pocket.front()
        bodies.append(ag.detail(_slab(outline, layer.y, bevel), "door", material))
    return bodies


def _window(leaf: ag.Region, view: ag.Region) -> list[ag.Body]:
    """Make the panes of the window with the mesh between them and the dark rim in front."""
    whole = view.grow(0.003).with_(y=leaf.y)
    outer = whole.shrink(0, front=0.0012).deep(0.0030, None)[0]
    mesh = whole.shrink(0, front=0.018).deep(0.0006, None)[0]
    inner = whole.shrink(0, back=0.0032).deep(None, 0.0012)[1]
    tinted = ag.material("tinted_glass").with_(name="door_glass", opacity=0.5)
    clear = ag.material("glass").with_(name="inner_film", opacity=0.12, density=1900)  # density with the mesh
    steel = ag.material("perforated_steel").with_(name="window_mesh", opacity=0.72)
    # on real panes, an edge of dots darkens to black; here the edge is a rim
    rim = view.grow(0.001).front(radius=0.006) - view.shrink(0.006).front(radius=0.010)
    black = ag.material("black_glass").with_(name="window_rim", specular_roughness=0.25)
    return [
        ag.part(outer.box(), "window", tinted),
        ag.detail(mesh.box(), "mesh", steel),
        ag.part(inner.box(), "window", clear),
        ag.detail(details.relief(rim, (0, leaf.y.low + 0.0011, 0), proud=0.0002, sunk=0.0006), "door", black),
    ]


def _cover(plan: Plan, view: ag.Region) -> list[ag.Body]:
    """Make the cover of the choke on the inside of the door, and the pins of the hinge."""
    x, y, _ = plan.pivot
    outline = plan.cavity.grow(x=0.015, z=0.011).front(radius=0.010) - view.grow(0.003).front(radius=0.008)
    # seen from behind, x is reversed
    cover = details.relief(outline.mirror(), (0, plan.door.y.high, 0), facing=ag.Y, proud=0.0008, sunk=0.0006)
    pin = ag.cylinder(0.0030, 0.0016)
    return [
        ag.detail(cover, "door", ag.colored("polypropylene", "slate").with_(name="choke_cover")),
        ag.detail([pin.at(x, y, z) for z in plan.door.z], "hinge", ag.material("zinc")),
    ]


_FACE = 0.0165  # thickness of the face with the channels of the keys [m]
_DEEP = 0.0085  # depth of caps behind the face [m]
_MARGIN = 0.0105  # margin from the edges of the panel to its controls [m]
_PITCH, _KEY = 0.0200, 0.0138  # pitch of the rows of keys, and height of a key [m]
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


def cooks(body: ag.Body, keys: int, dials: int) -> ag.Body:
    """Let keys or the dial of the time start the oven, which works while its door is closed."""
    pressed = {sign: signals.pressed(f"key_slide_{number}") for number, sign in enumerate(key_names(keys))}
    opened = signals.pressed("door_hinge", (0.0, 0.03))
    starts = [each for sign, each in pressed.items() if sign != "stop" and not sign.isdigit()]
    runs = [signals.timer(each, 30.0, unless=opened | pressed["stop"]) for each in starts]
    knobs = [f"dial_turn_{number}" for number in range(dials)] if dials > 1 else ["dial_turn"] * dials
    if knobs[1:] or not runs:  # the dial of the time
        runs += [signals.pressed(knob, (0.0, 0.3)) & ~opened for knob in (knobs[1:] or knobs)[:1]]
    if not runs:
        return body.output("light", opened, kind="light", material=LAMP)
    power = [
        0.7 * signals.level(knob, (0.0, 4.7)) for number, knob in enumerate(knobs) if number != (dials > 1)
    ]
    works = reduce(or_, runs)
    heats = works & ~reduce(or_, power) if power else works
    if pressed:
        body = body.output("beep", reduce(or_, pressed.values()), kind="sound")
    body = body.output("heat", heats, kind="heat").output(
        "light", works | opened, kind="light", material=LAMP
    )
    return body.output("turntable", works, kind="motor", moves="plate_spin", speed=0.6)


Size = tuple[ag.Scalar, ag.Scalar]
"""Width and height of a cap [m]."""


class Layout(NamedTuple):
    """Places of the controls on the panel."""

    field: ag.Region  # panel within its margins
    screen: ag.Region  # display, below the name
    dials: list[ag.Region]  # heights available for the dials
    keys: list[ag.Region]  # cells of the keys
    key: Size  # width and height of a key [m]
    button: ag.Region | None  # cap of the opening button
    channels: list[ag.Region]  # free space behind button and keys, from below


def layout(
    plan: Plan, face: FaceStyle, *, keys: int, dials: int, eject: bool, show: str, maker: str
) -> Layout:
    """Place name, display, dials, keys and opening button from the top to the bottom."""
    field = plan.panel.shrink(_MARGIN, y=0, z=_BAND + 0.004 if face == "banded" else _MARGIN)
    screen, rest = field.shrink(top=0.010 if maker else 0).stack(_SCREEN, None, gap=_APART)
    if not show:
        rest = field.shrink(top=0.012 if maker else 0)
    button = None
    if eject:
        rest, button = rest.stack(None, _EJECT, gap=_APART)
    rows, between = -(-keys // 3), (_PITCH - _KEY) / 2
    upper, lower = rest.stack(None, rows * _PITCH)
    # keys alone are in the middle of the space; below a dial they are at the lower end
    block = lower.at(z=-between if dials else rest.z.mid - lower.z.mid)
    cells = block.grid(3, rows) if keys else []
    behind = [button] if button else []
    behind += [block.shrink(x=0.0028, z=between)] if keys else []
    channels = [each.grow(PLAY + 0.0006) for each in behind]
    upward = upper.rows(max(dials, 1))
    return Layout(field, screen, upward[::-1], cells, (field.x.size / 3 - 0.0056, _KEY), button, channels)


def _hole(shape: ButtonShape, width: ag.Scalar, height: ag.Scalar) -> ag.Profile:
    return button_outline(shape, width + 2 * PLAY, height + 2 * PLAY)


def panel(
    plan: Plan, finish: Finish, places: Layout, shape: ButtonShape, *, show: str, color: Color, maker: str
) -> ag.Body:
    """Make the panel with its pane, display and name, which is welded to the case."""
    front = plan.panel
    pane = front.shrink(0.004).front(radius=0.005) if finish.face == "framed" else _glass(finish.face, front)
    if places.keys:
        hole = _hole(shape, *places.key)
        for key in places.keys:
            pane = pane - hole.at(key.x.mid, key.z.mid)
    if places.button:
        hole = _hole("bar", places.button.x.size, places.button.z.size)
        pane = pane - hole.at(places.button.x.mid, places.button.z.mid)
    outline = front.front()
    for channel in places.channels:
        outline = outline - channel.front()
    thick, behind = front.deep(_FACE, None)
    core = thick.shrink(_UNDER, back=0)
    boards = [behind.shrink(0.001, front=-LAP, back=-LAP)]
    if places.channels:
        widest = places.channels[0].x  # the lowest
        between = core.shrink(y=_UNDER, z=LAP).with_(x=(widest.low - LAP, widest.high + LAP))
        boards += [core.with_(x=(core.x.low, widest.low)), core.with_(x=(widest.high, core.x.high))]
        boards += gaps_between(between, [channel.z for channel in places.channels])
    else:
        boards.append(core)
    bodies = [
        ag.part([each.box() for each in boards], "panel", filled(finish.front, 240, "panel")),
        ag.detail(_slab(outline, thick.y, 0.0014), "panel", finish.front),
        _pane(pane, front, "panel", finish.around),
    ]
    y, x = front.y.low - PANE, front.x.mid
    if show:
        at = (x, y, places.screen.z.mid)
        bodies.append(details.display(show, places.field.x.size, _SCREEN, at=at, color=color))
    if maker:
        at = (x, y, places.field.z.high - 0.0035)
        bodies.append(details.printed(details.logo(maker, 0.0042), at, material=ink_on(finish.around)))
    return ag.weld(*bodies)


def cap(
    size: Size, name: str, shape: ButtonShape, finish: ag.Material, *, proud: ag.Scalar, sign: str
) -> ag.Body:
    """Make the cap of a key or a button about the origin, with a word, a digit or an icon on it."""
    width, height = size
    written, ink = sign.isdigit() or sign.isupper(), ink_on(finish)
    high, tracking = (0.0058, 0) if sign.isdigit() else (0.0052, 0.25)
    key = partial(button_cap, finish=finish, shape=shape, width=width, height=height, proud=proud, deep=_DEEP)
    if not written:
        return key(name=name, icon=sign, ink=ink)
    word = details.lettering([sign], high, tracking=tracking)
    return ag.weld(key(name=name), details.printed(word, (0, -proud, 0), material=ink))


def scale(number: int, radius: ag.Scalar, width: ag.Scalar, ink: ag.Material) -> ag.Body:
    """Make the print around a dial, with an icon at the left end of the panel's width."""
    style: Literal["numbers", "ticks", "band"] = ("band", "ticks", "numbers")[number % 3]
    icon = details.icon(("microwave", "timer", "defrost")[number % 3], 0.0085)
    return ag.weld(
        dial_print(radius, ink=ink, style=style, count=8),
        details.printed(icon, (0.006 - width / 2, 0, radius + 0.006), material=ink),
    )
