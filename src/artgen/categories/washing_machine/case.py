"""The case of a washing machine or a dryer: sheets, base, console, drawer, filter flap and back."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.controls import ButtonShape, DialScale, DialStyle
from artgen.categories.shared.fixings import feet, screws
from artgen.nodes.details.dials import SWEEP
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import Fitting

SHEET = 0.004
"""Modeled thickness of sheet steel [m]."""

SKIN = 0.014
"""Thickness of the front panel with its folded edges [m]."""

LAP = 0.0005
"""Overlap of boards, so that no two faces coincide [m]."""

FOOT = 0.014
"""Height of the feet [m]."""

_REVEAL = 0.0016  # joint between front, console, drawer and kick plate [m]
_BEHIND = 0.030  # depth of the recess for hoses at the back [m]
_PITCH = 0.0215  # distance between buttons: a finger 18 mm wide does not touch the neighbors [m]
_DEEP = 0.009  # depth of caps behind the face [m]
_ZINC, _BLACK = ag.material("zinc"), ag.material("black_abs")
_GREY = ag.colored("polypropylene", "light_grey").with_(name="tray_plastic")
_HOSES = ((0.05, 0.36), (-0.04, 0.5))  # how far the hoses run aside, and their height [m]
_ICONS = ("power", "thermometer", "spin", "rinse", "timer", "child_lock", "leaf", "start_pause")
_PROGRAMS = ("shirt", "tumbler", "leaf", "timer", "heart", "snowflake", "drop", "spin", "star")
_DRYING = ("shirt", "sun", "leaf", "timer", "heart", "fan_heat", "moon", "tumbler", "star")


class Plan:
    """The regions of a machine that loads at the front.

    Args:
        outside: Space of the case, from the floor to the top.
        kick: Height of the kick plate's upper edge [m].
        console: Height of the console [m].
        top: Thickness of the worktop [m].
        drawer: Width of the drawer's front; 0 for none [m].
    """

    def __init__(
        self, outside: ag.Region, *, kick: ag.Scalar, console: ag.Scalar, top: float, drawer: ag.Scalar
    ) -> None:
        self.outside, self.case = outside, outside.shrink(bottom=FOOT)
        self.top = outside.with_(z=(outside.z.high - top, outside.z.high))
        front = outside.shrink(x=0.001).deep(SKIN, None)[0]
        upper, rest = front.shrink(top=top + _REVEAL).stack(console, None, gap=_REVEAL)
        self.panel, low = rest.stack(None, kick, gap=_REVEAL)
        self.kick = low.with_(z=(0.012, kick))
        self.tray, self.console = upper.across(drawer, None, gap=_REVEAL)
        self.center = self.panel.z.mid


def around_hole(region: ag.Region, radius: ag.Scalar, sides: int = 12) -> list[ag.Solid]:
    """Make convex pieces of a plate in the plane y = 0 with a round hole about the origin."""
    radius = 0.992 * radius  # inside the facets of a round hole
    hole = ag.Region.centered(2 * radius, 0, 2 * radius).with_(y=region.y)
    corners = []
    for turn in range(sides):
        start, end = (math.tau * (turn + step) / sides for step in (0, 1))
        outer = math.floor(4 * turn / sides) * math.pi / 2 + math.pi / 4
        x, z = math.copysign(1, math.cos(outer)), math.copysign(1, math.sin(outer))
        inner = [(radius * math.cos(a), radius * math.sin(a)) for a in (start, end)]
        beyond = radius + LAP
        corners.append(ag.polygon([(x * beyond, z * beyond), *inner]))
    plates = [
        details.relief(each, (0, region.y.mid, 0), proud=region.y.size / 2, sunk=region.y.size / 2)
        for each in corners
    ]
    return [*(each.box() for each in region.around(hole, lap=0)), *plates]


def sheets(plan: ag.Region, finish: ag.Material, *, front: ag.Scalar, high: ag.Scalar) -> ag.Body:
    """Make the sides from behind the front panel to the back, up to a height, and the back panel."""
    rear = plan.y.high
    whole = plan.with_(y=(front - LAP, rear), z=(0.022, high))
    left, _, right = whole.across(SHEET, None, SHEET)
    back = whole.shrink(x=SHEET - LAP).with_(y=(rear - _BEHIND - SHEET, rear - _BEHIND))
    grooves = ag.rectangle(whole.y.size - 0.10, 0.016, radius=0.0079)
    pressed = [
        details.relief(grooves, whole.at(z=up).anchor(x=way), facing=(way, 0, 0), proud=0.0014, bevel=0.0012)
        for way in (-1, 1)
        for up in (-0.24, 0.24)
    ]
    return ag.weld(
        ag.part([left.box(bevel=0.0012), right.box(bevel=0.0012)], "body", filled(finish, 2300.0, "sheet")),
        ag.part(back.box(), "body", filled(_ZINC, 1500.0, "back")),
        ag.detail(pressed, "body", finish),
    )


def base(plan: ag.Region, high: ag.Scalar, front: ag.Scalar, density: float) -> ag.Body:
    """Make the base with pump, motor and ballast up to a height, of a density [kg/m3], on four feet."""
    pan = plan.shrink(x=SHEET - LAP).with_(y=(front, plan.y.high - _BEHIND - 0.001), z=(FOOT, high))
    corners = plan.shrink(x=0.048, y=0.052)
    stand = [(x, y) for x in corners.x for y in corners.y]
    block = ag.part(pan.box(bevel=0.003), "base", _BLACK.with_(name="ballast", density=density))
    return ag.weld(block, feet(stand, radius=0.022, height=FOOT, finish=_BLACK))


def back(plan: ag.Region, maker: str, model: str, *, low: ag.Scalar, vented: bool) -> ag.Body:
    """Make hoses or the outlet of air, transport bolts, rating plate and cord on the back panel."""
    y, half = plan.y.high - _BEHIND, plan.x.high
    cover = ag.cylinder(0.14, 0.006, axis=ag.Y, bevel=0.002).at(0, y + 0.002, low + 0.30)
    heads = [(side * (half - 0.02), y, z) for side in (-1, 1) for z in (0.08, low + 0.3, plan.z.high - 0.08)]
    plate = (0.6 * half, y, low + 0.50)
    made = [
        cord_stub(height=low + 0.10, reach=0.026).at(-0.6 * half, y, low + 0.10),
        details.rating_plate(0.08, 0.05, (maker.upper(), model), at=plate, facing=ag.Y),
        ag.detail(cover, "body", _ZINC),
        *screws(heads, facing="+y", radius=0.0036, finish=_ZINC, head="pan"),
    ]
    if vented:
        pipe = ag.tube(0.051, 0.049, 0.018, axis=ag.Y).at(-0.1, y + 0.009, 0.13)
        return ag.weld(*made, ag.detail(pipe, "vent", _ZINC))
    valve = (0.72 * half, y, plan.z.high - 0.46)
    nut = ag.extrude(ag.regular_polygon(6, 0.015), 0.012, axis=ag.Y, bevel=0.001).at(y=0.006)
    paths = [
        [(0, 0.013 * out, 0) for out in (-0.3, 1)] + [(x, 0.013, 0.02), (x, 0.013, z)] for x, z in _HOSES
    ]
    inlet, drain = (ag.sweep(ag.circle(0.006), ag.polyline(each, fillet=0.011)) for each in paths)
    return ag.weld(
        *made,
        ag.detail(inlet.at(valve), "hose", ag.colored("abs", "light_grey")),
        ag.detail(nut.at(valve), "hose", ag.colored("abs", "sky")),
        ag.detail(drain.at(-0.3 * half, y, low + 0.02), "hose", _GREY),
    )


@dataclass(frozen=True)
class Console:
    """A console with its controls, modeled about the origin on the plane y = 0."""

    place: ag.Region  # its space, in the machine
    finish: ag.Material
    pane: ag.Material | None  # glass over the whole face; None for the finish alone
    dials: int
    dial_style: DialStyle
    radius: ag.Scalar  # of dials [m]
    knob: ag.Material
    scale: DialScale
    buttons: int
    shape: ButtonShape
    caps: ag.Material
    show: str  # text of the display; empty for none
    color: Color
    force: ag.Scalar  # force that presses a button home [N]
    drying: bool

    def body(self, maker: str) -> ag.Body:
        """Make the console with dials at the left, the display in the middle and buttons at the right."""
        place = self.place.at(-self.place.x.mid, -self.place.y.low, -self.place.z.mid)
        screen = 0.092 if self.show else 0.0
        wide, high = (0.0155, 0.0085) if self.shape in ("pill", "bar") else (0.0115, 0.0115)
        zones = place.shrink(x=0.014).across(0.096 * self.dials, screen, None, gap=0.006)
        dials, middle, right = zones
        row = controls.places(self.buttons, _PITCH, middle=right.x.mid)
        face, proud = (self.pane, controls.PANE) if self.pane else (self.finish, 0.0)
        ink = controls.ink_on(face)
        boards, holes = [place], None
        if self.buttons:
            half = (self.buttons - 1) * _PITCH / 2 + wide / 2 + 0.0012
            channel = place.with_(
                x=(right.x.mid - half, right.x.mid + half), z=(-high / 2 - 0.0012, high / 2 + 0.0012)
            )
            boards = list(place.around(channel, lap=LAP))
            boards.append(channel.grow(LAP).with_(y=(_DEEP + 0.0042, place.y.high)))
            holes = controls.button_holes(self.shape, wide, high, row)
        bodies = [ag.part([each.box() for each in boards], "panel", filled(self.finish, 420.0, "panel"))]
        if self.pane:
            bodies.append(
                controls.inlay(place.x.size - 0.006, place.z.size - 0.006, finish=self.pane, holes=holes)
            )
        else:
            outline = place.front(radius=0.002) if holes is None else place.front(radius=0.002) - holes
            bodies.append(ag.detail(details.relief(outline, proud=0.0004, sunk=0.0004), "panel", self.finish))
            proud = 0.0004
        if self.show:
            at = (middle.x.mid, -proud, 0.004)
            bodies.append(details.display(self.show, 0.080, 0.030, at=at, color=self.color))
        if self.buttons:
            names = (*_ICONS[: self.buttons - 1], _ICONS[-1]) if self.buttons > 1 else _ICONS[:1]
            bodies.append(
                controls.icon_row(names, row, height=0.009, level=high / 2 + 0.012, ink=ink, proud=proud)
            )
            bodies.append(controls.lamp_row(row, level=-high / 2 - 0.008, lit=1, proud=proud))
        if maker:
            spot = (right.x.mid, -proud, -0.30 * place.z.size)
            bodies.append(details.printed(details.logo(maker, 0.0075), spot, material=ink))
        made = ag.weld(*bodies)
        for index, x in enumerate(row):
            name = f"button_{index}"
            cap = controls.button_cap(
                finish=self.caps,
                shape=self.shape,
                width=wide,
                height=high,
                proud=proud + 0.0036,
                deep=_DEEP,
                name=name,
            )
            press = controls.button_press(
                f"button_slide_{index}", travel=0.0022, force=self.force, preload=0.5
            )
            made = made.attach(cap, press, at=(x, 0, 0))
        for index in range(self.dials):
            knob = controls.control_knob(
                finish=self.knob,
                style=self.dial_style,
                radius=self.radius,
                depth=0.022,
                mark=controls.ink_on(self.knob),
                cap=ag.material("chrome"),
                name="dial",
                label="dial",
            )
            turn = controls.dial_turn("dial_turn", endless=True, friction=0.06)
            programs = _DRYING if self.drying else _PROGRAMS
            print_ = controls.dial_print(
                self.radius, ink=ink, style=self.scale, count=9, icons=programs, start=-SWEEP / 2
            )
            dial = Fitting.moving(knob, turn, fixed=print_)
            at = (dials.x.at((index + 0.5) / self.dials), -proud, 0)
            made = made.install(dial.suffixed(f"_{index}") if self.dials > 1 else dial, at=at)
        return made

    def in_front(self, maker: str) -> ag.Body:
        """Make the console upright at its place."""
        return self.body(maker).at(self.place.x.mid, self.place.y.low, self.place.z.mid)


def drawer(plan: Plan, finish: ag.Material, *, tank: bool, friction: ag.Scalar) -> ag.Body:
    """Make the housing of the drawer, and the drawer in it: for detergent, or a tank for water."""
    front, long = plan.tray.shrink(back=0.0012), 0.46 * plan.outside.y.size
    inner = front.shrink(x=0.010, top=0.010, bottom=0.016).with_(y=(front.y.high - LAP, front.y.low + long))
    room = inner.grow(x=0.0020, z=0.0022).shrink(front=SKIN / 2, back=-0.012)
    shell = room.grow(x=0.003, bottom=0.003)
    left, _, right = shell.across(0.003, None, 0.003)
    shells = (
        shell.shrink(x=LAP, front=LAP, back=-LAP).stack(None, 0.003)[1],
        left,
        right,
        shell.shrink(x=0.001, bottom=LAP).with_(y=(room.y.high, room.y.high + 0.003)),
    )
    housing = ag.detail([each.box() for each in shells], "drawer_housing", _GREY)
    ridge = ag.Region.centered(front.x.size - 0.03, 0.021, 0.011).at(
        front.x.mid, front.y.low - 0.0095, front.z.low + 0.020
    )
    grip = ag.bounding_collider(ridge.box(bevel=0.0035), ridge.box())
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.Z, depth=0.0185)
    left, _, right = inner.across(0.003, None, 0.003)
    behind = inner.shrink(x=LAP, bottom=LAP).with_(y=(inner.y.high - 0.003, inner.y.high - LAP))
    walls = [inner.shrink(x=LAP, y=LAP).stack(None, 0.003)[1], left, right, behind]
    faces = ag.part(
        [front.box(bevel=0.002), grip],
        "drawer",
        filled(finish, 700.0, "front"),
        grasp=hold,
        grasp_width=0.021,
        name="drawer",
    )
    tray = _GREY.with_(name="drawer_plastic")
    bodies = [faces]
    if tank:
        lid = inner.with_(z=(inner.z.high - 0.003, inner.z.high))
        walls.append(lid.shrink(x=LAP))
        mouth = ag.cylinder(0.018, 0.004, bevel=0.001).at(inner.x.mid, inner.y.low + 0.05, inner.z.high)
        bodies.append(ag.detail(mouth, "drawer", ag.colored("abs", "slate")))
    else:
        for share in (0.36, 0.70):
            x = inner.x.at(share)
            walls.append(inner.shrink(top=0.006).with_(x=(x - 0.0012, x + 0.0012)))
        siphon = inner.with_(x=(inner.x.at(0.355), inner.x.at(0.705))).shrink(front=0.06, back=0.02)
        siphon = siphon.with_(z=(inner.z.high - 0.016, inner.z.high - 0.006))
        bodies.append(ag.detail(siphon.box(bevel=0.003), "drawer", ag.colored("abs", "sky")))
        signs = [
            details.lettering(["I"], 0.008),
            details.icon("star", 0.011),
            details.lettering(["II"], 0.008),
        ]
        ink = controls.ink_on(finish)
        for share, sign in zip((0.18, 0.5, 0.82), signs, strict=True):
            at = (front.x.at(share), front.y.low, front.z.at(0.62))
            bodies.append(details.printed(sign, at, material=ink))
    bodies.append(ag.part([each.box() for each in walls], "drawer", tray))
    slide = ag.Prismatic(
        "drawer_slide",
        axis=-ag.Y,
        pivot=front.anchor(),
        limits=(0, 0.80 * long),
        feel=feel.RUNNER,
        friction=friction,
    )
    return housing.attach(ag.weld(*bodies), slide)


def kick_plate(plan: Plan, finish: ag.Material, *, flap: bool, side: int) -> ag.Body:
    """Make the kick plate, and the flap before the filter of the pump, hinged at its lower edge."""
    plate = plan.kick.shrink(front=0.003)
    stuff = filled(finish, 900.0)
    if not flap:
        slots = details.vent_slots(0.6 * plate.x.size, 0.014, 16, slot=0.0035)
        vent = details.relief(slots, plate.anchor(y=-1), proud=0.0003)
        return ag.weld(ag.part(plate.box(bevel=0.002), "kick_plate", stuff), ag.detail(vent, "vent", DARK))
    x = side * (plate.x.high - 0.105)
    hole = plate.shrink(bottom=0.010, top=0.010).with_(x=(x - 0.070, x + 0.070))
    leaf = hole.shrink(x=0.0015, z=0.0022).deep(0.006, None)[0]
    ridge = ag.Region.centered(0.045, 0.013, 0.007).at(x, leaf.y.low - 0.0055, leaf.z.high - 0.011)
    grip = ridge.box(bevel=0.0025)
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.Z, depth=0.0115)
    door = ag.part(
        [leaf.box(bevel=0.0012), grip],
        "filter_flap",
        stuff,
        grasp=hold,
        grasp_width=0.017,
        name="filter_flap",
    )
    niche = hole.grow(LAP).with_(y=(plate.y.high - 0.001, plate.y.high + 0.002))
    y, z = plate.y.high, hole.z.mid
    cap = ag.cylinder(0.026, 0.006, axis=ag.Y, bevel=0.002).at(x + 0.012, y - 0.0005, z)
    bar = ag.box(0.042, 0.004, 0.008, bevel=0.001).at(x + 0.012, y - 0.0022, z)
    hose = ag.cylinder(0.007, 0.006, axis=ag.Y, bevel=0.001).at(x - 0.042, y - 0.001, z)
    frame = ag.part([each.box(bevel=0.0006) for each in plate.around(hole, lap=LAP)], "kick_plate", stuff)
    body = ag.weld(
        frame,
        ag.part(niche.box(), "kick_plate", DARK),
        ag.detail([cap, bar], "filter", _GREY),
        ag.detail(hose, "filter", _BLACK),
    )
    at = (x, leaf.y.mid, leaf.z.low + 0.004)
    return body.attach(
        door,
        ag.Revolute(
            "flap_hinge",
            axis=ag.X,
            pivot=at,
            limits=(0, 1.35),
            friction=0.03,
            damping=0.004,
            armature=1e-4,
            effort=2.0,
        ),
    )


def panel_with(
    region: ag.Region,
    hole: ag.Scalar,
    center: ag.Scalar,
    finish: ag.Material,
    slots: Sequence[ag.Region] = (),
) -> ag.Body:
    """Make the front panel with its porthole, and slots for hooks."""
    outline = region.front(radius=0.002) - ag.circle(hole).at(0, center)
    half = region.y.size / 2
    slab = details.relief(outline, (0, region.y.mid, 0), proud=half, sunk=half, bevel=0.0014)
    covers = [each.at(z=center) for each in around_hole(region.at(z=-center), hole)]
    for slot in slots:
        tool = slot.with_(y=(region.y.low - 0.01, region.y.high + 0.01)).box()
        slab, covers = slab - tool, [each - tool for each in covers]
    plate = ag.bounding_collider(slab, *covers)
    return ag.part(plate, "front", filled(finish, 1150.0, "front"))
