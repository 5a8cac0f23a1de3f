"""The front of an oven: its balanced door, the drawer below it, and the control panel above it."""

from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.oven.case import LAMP, LAP, SLAB, UNDER, Plan
from artgen.categories.oven.racks import TUBE
from artgen.categories.shared import controls, cooktops
from artgen.categories.shared.appliances import DARK, filled
from artgen.categories.shared.finish import casting
from artgen.categories.shared.pulls import recessed_grip
from artgen.nodes.details.displays import Color

Window = Literal["none", "partial", "full"]
"""A solid front, a front with a window, or a glass front."""

HandleKind = Literal["bar", "box"]
"""A rod on posts, or a broad bar with closed ends."""

BEHIND = 0.0085
"""Largest reach of a handle beyond its middle [m]."""

DOWN = 0.045
"""Distance from the upper edge of the door to the middle of its handle [m]."""

BLACK = ag.material("black_glass")
"""Glass of panes and fronts."""

SWEEP = 4.7
"""Turn of a dial from off to its end [rad]."""

_HANDLE, _HALF = 0.45, 0.016  # approximate mass of a handle [kg], and its largest half height [m]
_START = 0.45  # angle from off, at the top, to the first position of a scale [rad]
_FUNCTIONS = ("heat_both", "heat_bottom", "grill", "hot_air", "defrost", "oven_light")
_TOUCH = ("power", "minus", "timer", "clock", "plus", "child_lock")


def window_region(plan: Plan, across: ag.Scalar, tall: ag.Scalar) -> ag.Region:
    """Return the place of the window, by shares of the cavity's width and of the height below the handle."""
    field = plan.cavity.with_(z=(plan.cavity.z.low + 0.012, plan.door.z.high - DOWN - 0.042))
    x, _, z = field.size
    return field.shrink(x=(1 - across) * x / 2, z=(1 - tall) * z / 2)


def _slab(place: ag.Region, view: ag.Region | None, bevel: float, wider: float = 0.0) -> ag.Solid:
    """Make a board with soft edges and a hole for the window, wider all around by some length [m]."""
    outline = place.front() if view is None else place.front() - view.grow(wider).front()
    return ag.extrude(outline, place.y.size, axis=ag.Y, bevel=bevel).at(y=place.y.mid)


def door(
    plan: Plan,
    view: ag.Region | None,
    face: ag.Material,
    maker: str,
    *,
    trimmed: bool,
    swing: ag.Float,
    pull: ag.Float,
) -> tuple[ag.Body, ag.Joint]:
    """Make the door without its handle, around the place of its window, and its joint.

    Springs carry the door, and friction holds it at any angle. The spring torque is linear, and is greatest
    at the open end, as is the torque of the weight m g r sin(q). The difference of both is less than the
    friction of hinges and rollers, which holds the door open at any angle, as for grilling.
    """
    leaf = plan.door
    skin, core = leaf.deep(0.014, None)
    core = core.shrink(x=0.004, z=0.004, front=-LAP, back=0)
    lining = ag.colored("enamel", "anthracite").with_(name="door_lining", specular_roughness=0.4)
    pieces = [
        (_slab(skin, view, 0.0022), "door", filled(face, 700.0, "door")),
        (_slab(core, view, 0.0018, wider=0.006), "door", filled(lining, 430.0, "door")),
    ]
    if view is not None:
        # panes lie in the rims of their holes, with the outer pane flush with the front
        tinted = ag.material("tinted_glass").with_(
            name="oven_glass", base_color=(0.055, 0.055, 0.06), opacity=0.74
        )
        clear = ag.material("glass").with_(name="inner_glass", opacity=0.14)
        front, inner = leaf.y
        for y, lap, glass in ((front + 0.0006, 0.002, tinted), (inner - 0.0048, 0.009, clear)):
            pieces.append((view.grow(lap).with_(y=(y, y + 0.004)).box(), "window", glass))
    axle = plan.hinge[2]
    lever = leaf.z.high - DOWN - axle
    moment: ag.Scalar = _HANDLE * lever
    for solid, _, stuff in pieces:
        moment = moment + stuff.density * solid.volume() * (solid.centroid().z - axle)
    stiffness = feel.GRAVITY * moment * ag.sin(swing) / swing
    drag = feel.Feel(friction=pull * lever, damping=2.5, effort=60 * lever, velocity=4)
    hinge = ag.Revolute(
        "door_hinge", axis=ag.X, pivot=plan.hinge, limits=(0, swing), stiffness=stiffness, feel=drag
    )
    bodies = [ag.part(*piece) for piece in pieces]
    bodies.append(_face(leaf, face) if view is None else _window_rim(leaf, view, trimmed=trimmed))
    if maker:
        word, at = details.logo(maker, 0.0088), (0, leaf.y.low, leaf.z.low + 0.024)
        bodies.append(details.printed(word, at, material=controls.ink_on(face)))
    return ag.weld(*bodies, *_inside(plan, view)), hinge


def handle_reach(plan: Plan, swing: ag.Scalar) -> ag.Scalar:
    """Return the reach of the handle of the open door in front of its axis [m]."""
    return (plan.door.z.high - DOWN - plan.hinge[2] - _HALF) * ag.sin(swing)


def _face(leaf: ag.Region, face: ag.Material) -> ag.Body:
    """Make the pressed field that stiffens a front without a window."""
    x, _, z = leaf.size
    field = ag.rectangle(0.81 * x, 0.56 * z, radius=0.024)
    at = (0, leaf.y.low, leaf.z.at(0.42))
    bead = details.relief(field - field.offset(-0.007), at, proud=0.0022, bevel=0.0020)
    return ag.detail(bead, "door", face)


def _window_rim(leaf: ag.Region, view: ag.Region, *, trimmed: bool) -> ag.Body:
    """Make the dark rim of the window, and its trim."""
    black = BLACK.with_(name="window_rim", specular_roughness=0.2)
    front = leaf.y.low
    frit = view.grow(0.0005).front() - view.shrink(0.010).front(radius=0.012)
    solids = [details.relief(frit, (0, front + 0.0006, 0), proud=0.0003, sunk=0.0005)]
    if trimmed:
        trim = view.grow(0.007).front(radius=0.010) - view.shrink(0.0015).front(radius=0.005)
        solids.append(details.relief(trim, (0, front, 0), proud=0.0012, bevel=0.0006))
    return ag.detail(solids, "window", black)


def _inside(plan: Plan, view: ag.Region | None) -> list[ag.Body]:
    """Make the visible parts of the inside: the frame of the inner pane, hinges, and a vent on the edge."""
    leaf, room = plan.door, plan.cavity
    inner = leaf.y.high
    outline = room.shrink(x=0.010, z=0.006).front(radius=0.012)
    if view is not None:
        outline = outline - view.grow(0.005).front(radius=0.008)
    # the outline is symmetric, so that it may be seen from behind
    frit = details.relief(outline, (0, inner, 0), facing=ag.Y, proud=0.0006, sunk=0.0004)
    arm = ag.box(0.010, 0.0030, 0.052, bevel=0.0008)
    arms = ag.array(
        arm, at=[(side * (room.x.high + 0.016), inner + 0.0009, plan.hinge[2] + 0.040) for side in (-1, 1)]
    )
    slots = details.vent_slots(0.6 * leaf.x.size, 0.007, 26, slot=0.0060)
    vent = details.relief(slots, (0, leaf.y.mid + 0.004, leaf.z.high - 0.0040), facing=ag.Z, proud=0.0003)
    return [
        ag.detail(frit, "door", BLACK.with_(name="inner_frit", specular_roughness=0.12)),
        ag.detail(arms, "hinge", ag.material("zinc")),
        ag.detail(vent, "vent", DARK),
    ]


def box_handle(length: ag.Scalar, out: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a broad bar with closed ends on the plane y = 0, along x about the origin."""
    deep, high, end = 0.015, 0.026, 0.030
    bar = ag.box(length - 0.004, deep, high, bevel=0.0045).at(y=-out)
    block = ag.box(end, out + deep / 2 - 0.0004, high + 0.004, bevel=0.0045)
    ends = [block.at(way * (length - end) / 2, 0.0008 - (out + deep / 2) / 2) for way in (-1, 1)]
    return ag.part([bar, *ends], "handle", casting(finish, 0.3), grasp=ag.frame((0, -out, 0)))


class Drawer:
    """The drawer below the oven of a range."""

    def __init__(self, plan: Plan, share: ag.Scalar) -> None:
        self.front = plan.below.deep(0.030, None)[0]
        x, low = plan.outside.x.high - 0.0175, self.front.z.low  # there is space for runners at the sides
        top = plan.cavity.z.low - SLAB - 0.012
        y = (self.front.y.high - LAP, plan.outside.y.high - 0.10)
        self.box = ag.Region((-x, x), y, (low + 0.006, low + 0.62 * (top - low)))
        self.travel = share * self.box.y.size
        self.reach = self.travel + plan.hinge[1] - self.front.y.low  # in front of the axis of the door [m]

    def body(self, finish: ag.Material, metal: ag.Material, grip: ag.Scalar) -> ag.Body:
        """Make the drawer with a recessed grip of a length [m]: the link `drawer`."""
        front, middle = self.front, self.front.z.mid + 0.010
        deep, high = 0.0275, 0.050  # of the grip: 9 mm for fingers above and below its blade [m]
        lining = ag.colored("abs", "graphite").with_(name="grip_lining")
        handle = recessed_grip(
            grip,
            finish=metal,
            lining=lining,
            width=high,
            deep=deep,
            level=True,
            name="drawer_grip",
            thin=True,
        )
        hole = ag.Region((-grip / 2, grip / 2), front.y, (middle - high / 2, middle + high / 2))
        # the visible front is a molding with soft edges over the boards around the grip
        half = front.y.size / 2
        outline = front.front() - hole.front()
        skin = details.relief(outline, (0, front.y.mid, 0), proud=half, sunk=half, bevel=0.0022)
        core = front.shrink(UNDER)
        behind = hole.grow(x=LAP, z=LAP).shrink(front=deep, back=2 * UNDER)
        boards = [each.box() for each in (*core.around(hole, lap=LAP), behind)]
        steel = ag.colored("powder_coat", "graphite").with_(name="drawer_sheet", density=1900.0)
        sheet, less, box = 0.003, 0.0004, self.box
        floor = box.shrink(x=less, back=less).with_(z=(box.z.low, box.z.low + sheet))
        left, between, right = box.shrink(bottom=less).across(sheet, None, sheet)
        before, _, end = between.grow(x=less).shrink(top=less).deep(sheet, None, sheet)
        sides = [left.box(bevel=0.0008), right.box(bevel=0.0008)]
        return ag.weld(
            ag.part(boards, "drawer", filled(finish, 300.0, "front")),
            ag.detail(skin, "drawer", finish),
            handle.body.at(0, front.y.low, middle),
            ag.part([floor.box(), *sides, end.shrink(back=less).box()], "drawer", steel),
            ag.detail(before.shrink(front=LAP).box(), "drawer", steel),
        )

    def runners(self, plan: Plan) -> ag.Body:
        """Make the runners at both sides of the bay, visual only."""
        low, (x, end) = self.box.z.at(0.45), (plan.outside.x.high - 0.0025, self.box.y.high - 0.01)
        runner = ag.Region(
            (self.box.x.high + 0.0016, x), (plan.cavity.y.low + 0.004, end), (low, low + 0.030)
        )
        return ag.detail([runner.box(), runner.mirror().box()], "rail", ag.material("zinc"))

    def slide(self, friction: ag.Scalar) -> ag.Joint:
        """Make the joint of the drawer, which slides out to the front."""
        drag = feel.Feel(friction=friction, damping=10, effort=60, velocity=1.5)
        return ag.Prismatic("drawer_slide", axis=-ag.Y, limits=(0, self.travel), feel=drag)


def panel(
    plan: Plan, finish: ag.Material, maker: str, *, pane: bool, show: str, color: Color, touch: bool
) -> ag.Body:
    """Make the control panel with its print; it may have a pane, a display and touch keys."""
    place = plan.panel
    face, behind = place.deep(0.030, None)
    x, _, high = place.size
    surface = BLACK if pane else finish
    ink, proud = controls.ink_on(surface), controls.PANE if pane else 0.0
    seen = []
    if pane:
        seen.append(controls.inlay(x - 0.006, high - 0.008, finish=surface, radius=0.004))
    wide, tall = _screen(plan)
    if show:  # the display is above its three touch keys, on its own pane if the panel has none
        keys = controls.places(3, 0.30 * wide)
        light = controls.ink_on(BLACK)
        seen += [
            *([] if pane else [controls.inlay(wide + 0.012, 0.80 * high, radius=0.004)]),
            details.display(show, wide, tall, at=(0, -controls.PANE, 0.13 * high), color=color),
            controls.icon_row(("minus", "timer", "plus"), keys, height=0.0085, level=-0.24 * high, ink=light),
        ]
    if touch:
        for way, names in ((-1, _FUNCTIONS), (1, _TOUCH)):
            row = [way * (_aside(plan, show) + 0.030 + number * 0.038) for number in range(4)]
            seen.append(controls.icon_row(names[:4], row, height=0.0125, ink=ink, proud=proud))
            seen.append(controls.lamp_row(row, level=-0.016, lit=1 if way < 0 else 9, proud=proud))
    if maker:
        at = (0 if show else 0.055 - x / 2, -proud, 0.0105 - high / 2)
        seen.append(details.printed(details.logo(maker, 0.0058), at, material=ink))
    return ag.weld(
        ag.part(face.shrink(top=0.0006).box(bevel=0.0020), "panel", filled(finish, 260.0, "panel")),
        ag.part(
            behind.shrink(x=0.002, y=-LAP, z=0.001).box(),
            "panel",
            filled(ag.material("powder_coat_black"), 150.0, "panel"),
        ),
        *(each.at(place.anchor(y=-1)) for each in seen),
    )


def _screen(plan: Plan) -> tuple[ag.Scalar, ag.Scalar]:
    """Return width and height of the display [m]."""
    high = 0.30 * plan.panel.z.size
    return (2.9 * high, high)


def _aside(plan: Plan, show: str) -> ag.Scalar:
    """Return half the width of the display with its touch keys [m]."""
    return _screen(plan)[0] / 2 + 0.012 if show else 0.0


def dial_places(plan: Plan, count: int, radius: ag.Scalar, show: str) -> list[ag.Scalar]:
    """Return the middles of the dials along x, from left to right, at both sides of a display [m]."""
    end = plan.panel.x.high - 0.020 - radius
    if not show:
        return controls.places(count, 2 * end / max(count, 3))
    start = _aside(plan, show) + radius + 0.012
    row: list[ag.Scalar] = []
    for number, way in (((count + 1) // 2, -1), (count // 2, 1)):
        # one or two dials are in the middle of their side, more dials fill it
        step = (end - start) / max(number - 1, 2)
        row += [way * (start + end) / 2 + each for each in controls.places(number, step)]
    return row


def dial_kinds(count: int, burners: int) -> list[tuple[Literal["ticks", "band", "icons"], str]]:
    """Return the scale and the sign of each dial: those of burners, then functions, then temperatures."""
    kinds: list[tuple[Literal["ticks", "band", "icons"], str]] = [("band", "flame")] * burners
    if count - burners > 1:
        kinds.append(("icons", "oven" if burners else ""))
    return kinds + [("ticks", "oven" if burners else "thermometer")] * (count - len(kinds))


def used(
    body: ag.Body, burner: cooktops.BurnerKind, kinds: Sequence[tuple[Literal["ticks", "band", "icons"], str]]
) -> ag.Body:
    """Let the dials heat burners and the oven; the lamp is on in use and while the door is open."""
    names = (
        [f"dial_turn_{number}" for number in range(len(kinds))]
        if len(kinds) > 1
        else ["dial_turn"] * len(kinds)
    )
    ends = (0.0, SWEEP)
    scales = [kind for kind, _ in kinds]
    body = cooktops.heated(body, burner, names[: scales.count("band")], controls.ink_on(BLACK))
    opened = signals.pressed("door_hinge", (0.0, 0.03))
    others = list(zip(scales, names, strict=True))[scales.count("band") :]
    heats = [signals.level(name, ends) for kind, name in others if kind == "ticks"][:1]
    chosen = [signals.level(name, (0.0, 0.3)) for kind, name in others if kind == "icons"]
    if heats:
        works = heats[0] & chosen[0] if chosen else heats[0]
        body = body.output("oven", works, kind="heat", material=TUBE)
    for name in [name for kind, name in others if kind == "ticks"][1:2]:
        body = body.output("bell", signals.timer(~signals.pressed(name, ends), 1.0), kind="sound")
    lamp = opened | chosen[0] if chosen else opened
    return body.output("lamp", lamp, kind="light", material=LAMP)


CLICKS = (0, *(_START + (SWEEP - _START) * step / (len(_FUNCTIONS) - 1) for step in range(len(_FUNCTIONS))))
"""Angles at which the dial of the functions clicks: off, and each function [rad]."""


def scale(
    radius: ag.Scalar, style: Literal["ticks", "band", "icons"], sign: str, ink: ag.Material
) -> ag.Body:
    """Print the scale around a dial, from its mark at off, and a sign below it."""
    film = details.lettering(["0"], 0.0042).at(0, radius + 0.0052)
    if sign:
        film = film | details.icon(sign, 0.0085).at(0, -radius - 0.0115)
    steps = controls.dial_print(
        radius, ink=ink, style=style, icons=_FUNCTIONS, sweep=SWEEP - _START, start=_START
    )
    return ag.weld(details.printed(film, material=ink), steps)
