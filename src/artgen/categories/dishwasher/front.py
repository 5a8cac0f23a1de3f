"""The door of a dishwasher: its front with the handle, its console, its liner and the detergent dispenser."""

import functools
import math
import operator
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen._arrays import cached_property
from artgen.categories.dishwasher.tub import FRONT_RIM, Plan
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, filled
from artgen.categories.shared.controls import ButtonShape, DialStyle
from artgen.categories.shared.pulls import pocket_grip, recessed_grip
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import Fitting

Controls = Literal["front", "top"]
"""Position of the console: in the front, or hidden on the upper edge of the door."""

HandleKind = Literal["bar", "pocket", "recessed"]
"""A bar in front of the door, a pocket in the upper edge, or a recess in the front with a blade in it."""

_SKIN = 0.018  # thickness of the front with its core, and of a console [m]
_GAP = 0.0018  # gap between console and front [m]
_CONSOLE = 0.112  # height of a console in the front [m]
_DISH = 0.022  # depth of the middle of the liner behind its rim, for the grips of racks [m]
_RECESS = 0.0285  # depth of a recessed grip, whose back is in the liner [m]
_HALF_RECESS = 0.037  # half the height of a recessed grip [m]
_POCKET = 0.030  # depth of a pocket [m]
_BEFORE_POCKET = 0.0155  # thickness of the door before a pocket: the lip for the fingers [m]
_BEHIND_POCKET = 0.0376  # distance from the front to the back of a pocket [m]
_HANDLE = 0.35  # approximate mass of a handle [kg]
_DENSITY = 480.0  # density of a console with its electronics [kg/m3]
_LAP = 0.0005  # overlap of boards, so that they share no corners [m]
_ICONS = ("power", "wash", "timer", "leaf", "cup", "rinse", "drop", "start_pause")
_PITCH = 0.0205  # distance between buttons: a finger 18 mm wide does not touch the neighbors [m]
_LINING = ag.colored("abs", "graphite").with_(name="grip_lining")


class Front:
    """The regions of a door: its skin, its console and the place of its handle."""

    def __init__(self, plan: Plan, handle: HandleKind, length: ag.Scalar, *, upper: bool) -> None:
        leaf, front, pocket = plan.door, plan.door.y.low, handle == "pocket"
        self.plan, self.handle, self.length, self.upper = plan, handle, length, upper
        x, thick, _ = leaf.size
        depth = _BEFORE_POCKET if pocket and not upper else _SKIN
        # the console, about the origin
        self.console = ag.Region.centered(x, 0, thick if upper else _CONSOLE).grow(back=depth)
        top = leaf.z.high - (depth if upper else _CONSOLE) - _GAP
        self.skin = leaf.with_(y=(front, front + _SKIN), z=(leaf.z.low, top))
        self.grip = {  # height at which a hand pulls the door [m]
            "bar": top - 0.055,
            "pocket": leaf.z.high - 0.013,
            "recessed": top - 0.065 if upper else leaf.z.high - _CONSOLE / 2,
        }[handle]
        # opening of a recessed grip
        half = length / 2
        self.recess = ag.Region((-half, half), leaf.y, (self.grip - _HALF_RECESS, self.grip + _HALF_RECESS))
        self.console_hole = self.recess.at(z=-self.grip) if handle == "recessed" and not upper else None

    def place(self, console: ag.Body) -> ag.Body:
        """Move the console to its place, turned over on the upper edge."""
        leaf = self.plan.door
        if self.upper:
            return console.rotate(ag.X, -math.pi / 2).at(0, leaf.y.mid, leaf.z.high)
        return console.at(0, leaf.y.low, leaf.z.high - _CONSOLE / 2)

    def boards(self, finish: ag.Material, liner: ag.Material) -> list[tuple[ag.Solid, ag.Material]]:
        """Make the skin, and the boards of the liner around the grip, each with its material."""
        leaf, skin, hole = self.plan.door, self.skin.box(bevel=0.003), self.recess
        if self.handle == "recessed" and self.upper:
            skin = skin - hole.with_(y=(leaf.y.low - 0.010, leaf.y.low + _RECESS)).box()
        top = leaf.z.high - (self.console.y.size + 0.0002 if self.upper else 0)
        body = leaf.with_(y=(self.skin.y.high - 0.001, leaf.y.high), z=(leaf.z.low, top))
        core, rim = body.deep(None, _DISH)
        upper, _, lower = rim.stack(0.034, None, 0.058)
        solids = []
        match self.handle:
            case "bar":
                solids = [core.box(), upper.box(bevel=0.003)]
            case "recessed":
                above, between, below = core.stack(top - hole.z.high, None, hole.z.low - core.z.low)
                left, _, right = between.grow(z=_LAP).across(
                    hole.x.low - core.x.low, None, core.x.high - hole.x.high
                )
                plug = hole.with_(y=(leaf.y.low + _RECESS, core.y.high))
                solids = [each.box() for each in (above, below, left, right, plug)]
                solids.append(upper.box(bevel=0.003))
            case "pocket":
                bottom = top - _POCKET
                beside = body.shrink(front=_LAP).with_(z=(bottom - 2 * _LAP, top))
                left, _, right = beside.across(hole.x.low - body.x.low, None, body.x.high - hole.x.high)
                plug = body.with_(y=(leaf.y.low + _BEHIND_POCKET, body.y.high), z=(bottom - _LAP, top))
                blocks = (core.shrink(top=_POCKET), upper.shrink(top=_POCKET), left, right)
                solids = [each.box() for each in (*blocks, plug.with_(x=hole.grow(x=_LAP).x))]
        wide = rim.x.high - self.plan.tub.x.high + 0.034
        posts = rim.with_(z=(lower.z.high - 0.002, upper.z.low + 0.002)).across(wide, None, wide)[::2]
        solids += [each.box(bevel=0.003) for each in (lower, *posts)]
        wooden = finish.name.startswith(("oak", "walnut", "ash", "lacquered"))
        face, stuff = filled(finish, 380.0 if wooden else 290.0, "front"), filled(liner, 285.0, "liner")
        return [(skin, face), *((each, stuff) for each in solids)]

    def hollow_grip(self, metal: ag.Material) -> ag.Body:
        """Make the lining of a pocket or a recess with its grip."""
        leaf = self.plan.door
        if self.handle == "pocket":
            pocket = pocket_grip(self.length, finish=_LINING, lip=_BEFORE_POCKET, gap=0.022, deep=_POCKET)
            # the free edge of a door hinged at the left becomes the upper edge
            return pocket.body.rotate(ag.Y, -math.pi / 2).at(0, leaf.y.low, leaf.z.high)
        grip = recessed_grip(self.length, finish=metal, lining=_LINING, deep=_RECESS, level=True)
        return grip.body.at(0, leaf.y.low, self.grip)

    def trim(self, finish: ag.Material, maker: str, *, framed: bool) -> list[ag.Body]:
        """Make the frame of a wooden front, or the maker's name."""
        skin, face = self.skin, self.skin.y.low
        if framed:
            outline = skin.shrink(0.002).front(radius=0.002) - skin.shrink(0.067).front()
            frame = details.relief(outline, (0, face, 0), proud=0.0045, sunk=0.001, bevel=0.0012)
            return [ag.detail(frame, "door", finish)]
        if not maker:
            return []
        down = 0.105 if self.handle != "pocket" and self.upper else 0.032
        z = skin.z.low + 0.06 if self.handle == "bar" else skin.z.high - down
        return [details.printed(details.logo(maker, 0.0085), (0, face, z), material=controls.ink_on(finish))]

    def hinge(
        self, boards: list[tuple[ag.Solid, ag.Material]], console: list[ag.Solid], pull: ag.Float
    ) -> ag.Joint:
        """Make the joint of the door; springs carry its weight, and friction holds it at any angle.

        The spring torque is linear, and is greatest at the open end, as is the torque of the weight m g r
        sin(q). Both are equal at the open end; the difference in between is less than the friction.
        """
        plan, axle = self.plan, self.plan.hinge[2]
        moment: ag.Scalar = _HANDLE * (self.grip - axle)
        for solid, stuff in boards:
            moment = moment + stuff.density * solid.volume() * (solid.centroid().z - axle)
        for solid in console:
            moment = moment + _DENSITY * solid.volume() * (plan.door.z.high - axle - 0.03)
        stiffness = feel.GRAVITY * moment * ag.sin(plan.swing) / plan.swing
        # torque of 60 N at the handle
        drag = feel.Feel(friction=pull * (self.grip - axle), damping=2, effort=40, velocity=4)
        return ag.Revolute(
            "door_hinge", axis=ag.X, pivot=plan.hinge, limits=(0, plan.swing), stiffness=stiffness, feel=drag
        )


@dataclass(frozen=True)
class Console:
    """A console, modeled about the origin on the plane y = 0."""

    place: ag.Region  # its boards
    hole: ag.Region | None  # opening for a recessed grip
    upper: bool  # whether it is on the upper edge of the door, with little space for print
    finish: ag.Material  # finish of the face
    pane: bool  # whether a pane of black glass covers the face
    buttons: int  # number of buttons
    shape: ButtonShape  # shape of the caps
    cap: ag.Material  # finish of the caps
    dial: DialStyle | str  # style of the cycle dial; `""` for none

    @cached_property
    def _half(self) -> ag.Scalar:
        """Half the width of the machine [m]."""
        return self.place.x.high + 0.0015

    @cached_property
    def _far(self) -> ag.Scalar:
        """Middle of the dial along x [m]."""
        return 0.80 * self._half

    @cached_property
    def _radius(self) -> float:
        """Radius of the dial [m]."""
        return 0.015 if self.upper else 0.021

    @cached_property
    def _row(self) -> controls.ButtonRow:
        """Buttons, or the touch keys of a console without buttons."""
        return controls.ButtonRow(self.buttons or 5, self.shape, _PITCH, -0.54 * self._half)

    @cached_property
    def _icons(self) -> tuple[str, ...]:
        """Icons of the buttons or touch keys; every machine has the first and the last icon."""
        count = self.buttons or 5
        return (*_ICONS[: count - 1], _ICONS[-1]) if count > 1 else _ICONS[:1]

    @cached_property
    def boards(self) -> list[ag.Solid]:
        """Boards of the face, around the grip and around the channel of the buttons."""
        place, hole = self.place, self.hole
        if not self.buttons and hole is None:
            return [place.box(bevel=0.0015)]
        boards = []
        if hole is not None:
            _, middle, beside = place.across(hole.x.low - place.x.low, None, place.x.high - hole.x.high)
            middle = middle.grow(x=_LAP)
            above, _, below = middle.stack(place.z.high - hole.z.high, None, hole.z.low - place.z.low)
            boards = [beside, above, below]
            place = place.with_(x=(place.x.low, hole.x.low))
        if not self.buttons:
            return [each.box() for each in (*boards, place)]
        channel = self._row.channel(self.place)
        room = "the buttons have no room on the console: raise width, or lower buttons"
        left = ag.require(channel.x.low, channel.x.low > place.x.low, room)
        right = ag.require(channel.x.high, channel.x.high < place.x.high, room)
        level = place.with_(z=channel.z).grow(z=_LAP)
        boards += [
            place.with_(z=(channel.z.high, place.z.high)),
            place.with_(z=(place.z.low, channel.z.low)),
            level.with_(x=(place.x.low, left)),
            level.with_(x=(right, place.x.high)),
        ]
        return [each.box() for each in boards]

    def used(self, body: ag.Body) -> ag.Body:
        """Let the last button start the machine with a closed door, and the dial set the program."""
        if self.buttons:
            *others, start = (signals.pressed(f"button_slide_{n}") for n in range(self.buttons))
            runs = signals.toggle(start, unless=signals.pressed("door_hinge", (0.0, 0.06)))
            body = body.output("wash", runs, kind="motor", moves="spray_arm_spin_0", speed=4.0)
            body = body.output("heat", runs & signals.toggle(others[1]) if others[1:] else runs, kind="heat")
            body = body.output("beep", functools.reduce(operator.or_, others, start), kind="sound")
        if self.dial:
            body = body.output("program", signals.level("knob_turn", (-2.4, 2.4)), kind="display")
        return body

    def body(self, show: str, color: Color, *, travel: ag.Scalar, force: ag.Scalar) -> ag.Body:
        """Make the whole console with the text of its display, and the travel and force of its buttons."""
        stuff = filled(self.finish, _DENSITY, "panel")
        body = ag.weld(ag.part(self.boards, "panel", stuff), *self._seen(show, color))
        ink = controls.ink_on(self.cap)
        if self.buttons:
            icons = self._icons if self.upper else ()
            body = self._row.install(
                body,
                self.cap,
                proud=travel + 0.0012,
                travel=travel,
                force=force,
                preload=0.3,
                icons=icons,
                ink=ink if self.upper else None,
            )
        if self.dial:
            knob = controls.control_knob(
                finish=self.cap,
                style=self.dial,  # type: ignore[arg-type] # "" is none
                radius=self._radius,
                depth=0.018,
                mark=ink,
                cap=ag.material("aluminium"),
            )
            body = body.attach(knob, controls.dial_turn(), at=(self._far, 0, 0))
        return body

    def _seen(self, show: str, color: Color) -> list[ag.Body]:
        """Make the pane or the strip around the buttons, display, icons and lamps, visual only."""
        place, row, (_, high) = self.place, self._row, self._row.size
        face = ag.material("black_glass") if self.pane else self.finish
        ink, proud = controls.ink_on(face), controls.PANE if self.pane else 0.0001
        holes = row.holes if self.buttons else None
        bodies = []
        if self.pane:
            bodies.append(
                controls.inlay(place.x.size - 0.012, place.z.size - 0.010, holes=holes, radius=0.004)
            )
        elif holes is not None:
            length, around = row.channel(place).x.size + 0.010, holes.at(-row.middle)
            strip = controls.inlay(length, high + 0.011, finish=self.finish, holes=around, radius=0.003)
            bodies.append(strip.at(row.middle))
        # an upper console has its icons on the caps
        rise, low, tall = (
            (high / 2 + 0.0105, -high / 2 - 0.0080, 0.0088) if self.buttons else (0, -0.0105, 0.0105)
        )
        if not (self.buttons and self.upper):
            bodies += [
                controls.icon_row(self._icons, row.at, height=tall, level=rise, ink=ink, proud=proud),
                controls.lamp_row(row.at, level=low, lit=1, proud=proud),
            ]
        if show:
            x = self._half * (0.30 if self.hole is None else 0.60)
            size = (0.044, 0.014) if self.upper else (0.052, 0.020)
            bodies.append(details.display(show, *size, at=(x, -proud, 0), color=color))
        if self.dial:
            ring = controls.dial_print(self._radius, ink=ink, style="ticks", count=6)
            bodies.append(ring.at(self._far, -proud))
        return bodies


def liner_details(plan: Plan, x: ag.Scalar) -> list[ag.Body]:
    """Make the vent in the liner at a position along x [m], and the arms of the hinges beside it."""
    inner, z = plan.door.y.high, plan.door.z.high - 0.16
    floor = inner - _DISH
    vent = ag.cylinder(0.031, 0.006, axis=ag.Y, bevel=0.002).at(x, floor + 0.002, z)
    slots = details.vent_slots(0.044, 0.036, 7, slot=0.003, direction="horizontal")
    grille = details.relief(slots, (x, floor + 0.005, z), facing=ag.Y, proud=0.0003)
    arm = ag.box(0.005, 0.003, 0.055, bevel=0.001).at(0, inner + 0.001, plan.hinge[2] + 0.055)
    aside = plan.tub.x.high + 0.013
    return [
        ag.detail(vent, "vent", ag.colored("polypropylene", "grey")),
        ag.detail(grille, "vent", DARK),
        ag.detail([arm.at(-aside), arm.at(aside)], "hinge", ag.material("zinc")),
    ]


def dispenser(plan: Plan, x: ag.Scalar, hinge: ag.Joint) -> Fitting:
    """Make the dispenser on the liner at a position along x [m]: its flap slides while the door is open."""
    above, thick, tab_high = 0.0032, 0.0034, 0.011  # gap from the lower rack up to the tab of the flap [m]
    inner, rim = plan.door.y.high, plan.floors[0] + FRONT_RIM
    face = inner - 0.002  # depth behind the rim of the liner [m]
    center = x - 0.014
    low = rim + above
    housing = ag.Region((x - 0.058, x + 0.058), (inner - _DISH - 0.001, face), (rim - 0.042, rim + 0.075))
    cup = ag.rectangle(0.046, 0.036, radius=0.005)
    chamber = details.relief(cup, (center, face, low + 0.022), facing=ag.Y, proud=0.0003)
    cap_at = (x + 0.036, face, rim + 0.040)
    cap = ag.cylinder(0.017, 0.0014, axis=ag.Y, bevel=0.0006).at(y=0.0004).at(cap_at)
    guide = ag.Region((-0.0015, 0.0015), (face - 0.001, face + 0.0028), (rim - 0.040, low + 0.046))
    guides = [guide.at(center + side * 0.030).box(bevel=0.0006) for side in (-1, 1)]
    grey = ag.colored("abs", "light_grey").with_(name="dispenser_grey")
    dark = ag.colored("abs", "slate").with_(name="chamber_shade")
    drop = details.icon("drop", 0.014)
    fixed = ag.weld(
        ag.part(housing.box(bevel=0.004), "dispenser", grey),
        ag.detail(guides, "dispenser", grey),
        ag.detail(chamber, "dispenser", dark),
        ag.detail(cap, "rinse_cap", ag.colored("abs", "sky")),
        details.printed(drop, (x + 0.036, face + 0.0012, rim + 0.040), material=dark, facing=ag.Y),
    )
    near = face + 0.0006
    plate = ag.Region((center - 0.027, center + 0.027), (near, near + thick), (low, low + 0.044))
    tab = ag.Region((center - 0.017, center + 0.017), (near + 0.001, inner + tab_high), (low, low + 0.010))
    hold = ag.frame((center, inner + tab_high + 0.002, low + 0.005), approach=-ag.Y, closing=ag.Z)
    flap = ag.part(
        [plate.box(bevel=0.001), tab.box(bevel=0.002)],
        "detergent_flap",
        ag.colored("abs", "light_grey").with_(name="flap_grey"),
        grasp=hold,
        grasp_width=0.020,
    )
    slide = ag.Prismatic(
        "detergent_flap_slide",
        axis=-ag.Z,
        pivot=(x, inner, rim),
        limits=(0, 0.036),
        spring=ag.Spring(preload=1.2, force=4.0),  # force of a thumb
        damping=8,
        friction=0.2,
        armature=0.05,
        effort=8,
        needs=(hinge > 1.2).beyond(above - 0.0006),  # up to there the tab is above the lower rack
    )
    return Fitting.moving(flap, slide, fixed=fixed)
