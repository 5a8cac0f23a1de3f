"""The door of an oven, and the drawer below it."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.oven.body import FOOT, LOW
from artgen.categories.oven.space import LAP, SKIN, UNDER, Space
from artgen.categories.shared.appliances import DARK, filled
from artgen.categories.shared.controls import ink_on
from artgen.categories.shared.finish import casting
from artgen.categories.shared.pulls import BarStyle, Grip, bar_handle, boards_around, recessed_grip

_FACE = 0.030  # thickness of the front [m]
_POCKET = 0.0275  # depth of the grip [m]
_WIDE = 0.050  # height of the grip: 9 mm for fingers above and below its blade [m]
_SHEET = 0.003  # thickness of the sheet of the box [m]
_BESIDE = 0.0175  # distance from the box to the side of the range, for the runner [m]
_PLAY = 0.0016  # gap between box and runner [m]


@dataclass(frozen=True)
class Drawer:
    """Drawer below the oven of a range."""

    space: Space  # dimensions of the range
    finish: ag.Material  # finish of the front
    metal: ag.Material  # metal of the blade of the grip
    grip: ag.Scalar  # length of the grip [m]
    share: ag.Scalar  # travel, as a share of the depth
    friction: ag.Scalar  # friction of the runners [N]

    @cached_property
    def _tall(self) -> ag.Span:
        """Heights of the lower and upper edge of the front [m]."""
        return (FOOT + LOW, self.space.under_door)

    @cached_property
    def _box(self) -> tuple[ag.Scalar, ag.Span, ag.Span]:
        """Half the width of the box, and its positions along y and z [m]."""
        space = self.space
        low = self._tall[0]
        # below the slab of the cavity's floor, 24 mm thick
        top = space.floor - 0.024 - 0.012
        return (
            space.half - _BESIDE,
            (space.front + _FACE - LAP, space.rear - 0.10),
            (FOOT + LOW + 0.006, low + 0.62 * (top - low)),
        )

    @cached_property
    def _travel(self) -> ag.Scalar:
        """Travel of the drawer [m]."""
        _, (y0, y1), _ = self._box
        return self.share * (y1 - y0)

    @cached_property
    def before(self) -> ag.Scalar:
        """Reach of the open drawer's front in front of the axis of the door [m]."""
        return self._travel + self.space.hinge[1] - self.space.front

    def body(self) -> ag.Body:
        """Make the drawer: the link `drawer`."""
        space, half = self.space, self.space.half - 0.0015
        low, high = self._tall
        middle = (low + high) / 2.0 + 0.010
        lining = ag.colored("abs", "graphite").with_(name="grip_lining")
        grip: Grip = recessed_grip(
            self.grip,
            finish=self.metal,
            lining=lining,
            width=_WIDE,
            deep=_POCKET,
            level=True,
            name="drawer_grip",
            thin=True,
        ).at(0.0, space.front, middle)
        x, y, z = (-half, half), (space.front, space.front + _FACE), (low, high)
        # the visible front is a molding with soft edges over the boards around the grip
        opening = ag.rectangle(self.grip, _WIDE).at(0.0, middle - 0.5 * (low + high))
        outline = ag.rectangle(2.0 * half, high - low) - opening
        at = (0.0, 0.5 * (y[0] + y[1]), 0.5 * (low + high))
        skin = details.relief(outline, at, proud=0.5 * _FACE, sunk=0.5 * _FACE, bevel=0.0022)
        hole = ((-0.5 * self.grip, 0.5 * self.grip), (middle - 0.5 * _WIDE, middle + 0.5 * _WIDE))
        deep = (y[0] + UNDER, y[1] - UNDER)
        across, tall = ((start + UNDER, end - UNDER) for start, end in (x, z))
        front = boards_around(across, tall, hole, deep)
        front.append(
            ag.Region(
                (hole[0][0] - LAP, hole[0][1] + LAP),
                (y[0] + _POCKET, y[1] - 2.0 * UNDER),
                (hole[1][0] - LAP, hole[1][1] + LAP),
            ).box()
        )
        steel = ag.colored("powder_coat", "graphite").with_(name="drawer_sheet", density=1900.0)
        filling = filled(self.finish, 300.0, "front")
        *boards, before = self._boards()
        return ag.weld(
            *(ag.part(each, "drawer", filling) for each in front),
            ag.detail(skin, "drawer", self.finish),
            grip.shell,
            *(ag.part(each, "drawer", steel) for each in boards),
            ag.detail(before, "drawer", steel),
        )

    def _boards(self) -> list[ag.Solid]:
        x, (y0, y1), (z0, z1) = self._box
        less = 0.0004
        floor = ag.Region((less - x, x - less), (y0, y1 - less), (z0, z0 + _SHEET)).box()
        sides = [
            ag.Region((x - _SHEET, x) if way > 0 else (-x, _SHEET - x), (y0, y1), (z0 + less, z1)).box(
                bevel=0.0008
            )
            for way in (-1, 1)
        ]
        ends = [
            ag.Region((_SHEET - x - less, x - _SHEET + less), y, (z0 + less, z1 - less)).box()
            for y in ((y1 - _SHEET, y1 - less), (y0 + LAP, y0 + _SHEET))
        ]
        return [floor, *sides, *ends]

    def runners(self) -> ag.Body:
        """Make the runners at both sides of the bay, which are welded to the cabinet."""
        space = self.space
        x, (_, end), (z0, z1) = self._box
        z = (z0 + 0.45 * (z1 - z0), z0 + 0.45 * (z1 - z0) + 0.030)
        steel = ag.material("zinc")
        solids = [
            ag.Region(
                (x + _PLAY, space.half - 0.0025) if way > 0 else (0.0025 - space.half, -x - _PLAY),
                (space.mouth + 0.004, end - 0.01),
                z,
            ).box()
            for way in (-1, 1)
        ]
        return ag.weld(*(ag.detail(each, "rail", steel) for each in solids))

    def slide(self) -> ag.Joint:
        """Make the joint of the drawer, which slides out to the front."""
        return ag.Prismatic(
            "drawer_slide",
            axis=-ag.Y,
            limits=(0.0, self._travel),
            friction=self.friction,
            damping=10.0,
            effort=60.0,
            velocity=1.5,
        )


Window = Literal["none", "partial", "full"]
"""A solid front, a front with a window, or a glass front."""

HandleKind = Literal["bar", "box"]
"""A rod on posts, or a broad bar with closed ends."""

BEHIND = 0.0085
"""Largest reach of a handle beyond its middle [m]."""

_GRAVITY = 9.81
_HANDLE = 0.45  # approximate mass of a handle [kg]
_HALF = 0.016  # largest half height of a handle [m]
_DOWN = 0.045  # distance from the upper edge of the door to the middle of its handle [m]
_PANE = 0.004  # thickness of a pane [m]
_FRONT, _CORE = 700.0, 430.0  # density of front and core [kg/m3]
_BOX = (0.015, 0.026)  # depth and height of the bar of a box handle [m]


@dataclass(frozen=True)
class Door:
    """Layout and finish of a door."""

    space: Space  # dimensions of the oven
    window: Window  # window of the front
    across: ag.Scalar  # width of the window, as a share of that of the cavity
    tall: ag.Scalar  # height of the window, as a share of the available space
    handle: HandleKind  # kind of handle
    bar: BarStyle  # style of a bar
    length: ag.Scalar  # length of the handle [m]
    projection: ag.Scalar  # distance from the front to the middle of a handle [m]
    girth: ag.Scalar  # half the thickness of a bar [m]
    finish: ag.Material  # finish of the front
    glass: ag.Material  # material of a glass front, and of the glass around a window
    metal: ag.Material  # metal of the handle
    maker: str  # brand name; `""` for none

    @cached_property
    def _half(self) -> ag.Scalar:
        return self.space.half - 0.0015

    @cached_property
    def _handle_height(self) -> ag.Scalar:
        return self.space.door[1] - _DOWN

    @cached_property
    def _face(self) -> ag.Material:
        return self.glass if self.window == "full" else self.finish

    @cached_property
    def _view(self) -> tuple[ag.Scalar, ag.Span]:
        """Half the width of the window, and the heights of its lower and upper edge [m]."""
        space = self.space
        low, high = space.floor + 0.012, self._handle_height - 0.042
        middle, half = (low + high) / 2.0, 0.5 * self.tall * (high - low)
        return (self.across * space.inside, (middle - half, middle + half))

    @cached_property
    def _solids(self) -> list[tuple[ag.Solid, ag.Material]]:
        """Return the front, the core behind it and the panes, with their materials."""
        space, (low, high) = self.space, self.space.door
        front, inner = space.front, space.inner
        tall, level = high - low, (low + high) / 2.0
        lining = ag.colored("enamel", "anthracite").with_(name="door_lining", specular_roughness=0.4)
        layers = (
            ((front, front + SKIN), self._face, _FRONT, 0.0, 0.0022, 0.0),
            ((front + SKIN - LAP, inner), lining, _CORE, 0.004, 0.0018, 0.006),
        )
        solids = []
        for (start, end), finish, density, inset, bevel, wider in layers:
            outline = ag.rectangle(2.0 * (self._half - inset), tall - 2.0 * inset)
            hole = self._hole(wider)
            outline = outline if hole is None else outline - hole.at(0.0, -level)
            slab = ag.extrude(outline, end - start, axis=ag.Y, bevel=bevel)
            solids.append((slab.at(0.0, (start + end) / 2.0, level), filled(finish, density, "door")))
        if self.window == "none":
            return solids
        # panes lie in the rims of their holes, with the outer pane flush with the front
        half, (bottom, top) = self._view
        tinted = ag.material("tinted_glass").with_(
            name="oven_glass", base_color=(0.055, 0.055, 0.06), opacity=0.74
        )
        clear = ag.material("glass").with_(name="inner_glass", opacity=0.14)
        for deep, wide, glass in ((front + 0.0006, 0.002, tinted), (inner - _PANE - 0.0008, 0.009, clear)):
            x, z = (-half - wide, half + wide), (bottom - wide, top + wide)
            solids.append((ag.Region(x, (deep, deep + _PANE), z).box(), glass))
        return solids

    def _hole(self, wider: ag.Scalar) -> ag.Profile | None:
        """Return the opening of the window, enlarged by some length all around [m]."""
        if self.window == "none":
            return None
        half, (low, high) = self._view
        return ag.rectangle(2.0 * (half + wider), high - low + 2.0 * wider).at(0.0, (low + high) / 2.0)

    @cached_property
    def handle_before(self) -> ag.Scalar:
        """Reach of the handle of the open door in front of its axis [m]."""
        space = self.space
        return (self._handle_height - space.hinge_height - _HALF) * ag.sin(space.swing)

    def body(self) -> ag.Body:
        """Make the door: the link `door`."""
        bodies = [
            ag.part(solid, "window" if "glass" in stuff.name and index > 1 else "door", stuff)
            for index, (solid, stuff) in enumerate(self._solids)
        ]
        return ag.weld(*bodies, *self._front_details(), *self._inner_details(), self._grip())

    def _front_details(self) -> list[ag.Body]:
        """Make the dark rim of the window, its trim, and the name."""
        space, bodies = self.space, []
        low, high = space.door
        if self.window != "none":
            half, (bottom, top) = self._view
            level = (bottom + top) / 2.0
            wide, tall = 2.0 * half, top - bottom
            frit = ag.rectangle(wide + 0.001, tall + 0.001) - ag.rectangle(
                wide - 0.020, tall - 0.020, radius=0.012
            )
            black = ag.material("black_glass").with_(name="window_rim", specular_roughness=0.2)
            at = (0.0, space.front + 0.0006, level)
            bodies.append(ag.detail(details.relief(frit, at, proud=0.0003, sunk=0.0005), "window", black))
            if self.window == "partial":
                trim = ag.rectangle(wide + 0.014, tall + 0.014, radius=0.010)
                trim = trim - ag.rectangle(wide - 0.003, tall - 0.003, radius=0.005)
                solid = details.relief(trim, (0.0, space.front, level), proud=0.0012, bevel=0.0006)
                bodies.append(ag.detail(solid, "window", black))
        else:
            # a pressed field stiffens a front without a window
            wide, tall = 1.62 * self._half, 0.56 * (high - low)
            field = ag.rectangle(wide, tall, radius=0.024)
            bead = field - field.offset(-0.007)
            solid = details.relief(
                bead, (0.0, space.front, low + 0.42 * (high - low)), proud=0.0022, bevel=0.0020
            )
            bodies.append(ag.detail(solid, "door", self.finish))
        if self.maker:
            word = details.logo(self.maker, 0.0088)
            at = (0.0, space.front, low + 0.024)
            bodies.append(details.printed(word, at, material=ink_on(self._face)))
        return bodies

    def _inner_details(self) -> list[ag.Body]:
        """Make the visible parts of the inside: the frame of the inner pane, covers of screws, hinges."""
        space, high = self.space, self.space.door[1]
        inner = space.inner
        bodies = []
        backward = (0.0, 1.0, 0.0)
        half, (bottom, top) = self._view
        outline = ag.rectangle(2.0 * space.inside - 0.02, space.ceiling - space.floor - 0.012, radius=0.012)
        level = (space.ceiling + space.floor) / 2.0
        if self.window != "none":
            hole = ag.rectangle(2.0 * half + 0.010, top - bottom + 0.010, radius=0.008)
            outline = outline - hole.at(0.0, (bottom + top) / 2.0 - level)
        dark = ag.material("black_glass").with_(name="inner_frit", specular_roughness=0.12)
        face = details.relief(outline, (0.0, inner, level), facing=backward, proud=0.0006, sunk=0.0004)
        bodies.append(ag.detail(face, "door", dark))
        steel = ag.material("zinc")
        for side in (-1, 1):
            arm = ag.box(0.010, 0.0030, 0.052, bevel=0.0008).at(
                side * (space.inside + 0.016), inner + 0.0009, space.hinge_height + 0.040
            )
            bodies.append(ag.detail(arm, "hinge", steel))
        slots = details.vent_slots(1.2 * self._half, 0.007, 26, slot=0.0060)
        top_vent = details.relief(
            slots,
            (0.0, (space.front + inner) / 2.0 + 0.004, high - 0.0040),
            facing=(0.0, 0.0, 1.0),
            proud=0.0003,
        )
        bodies.append(ag.detail(top_vent, "vent", DARK))
        return bodies

    def _grip(self) -> ag.Body:
        at = (0.0, self.space.front, self._handle_height)
        if self.handle == "bar":
            bar: ag.Body = bar_handle(
                length=self.length,
                finish=self.metal,
                style=self.bar,
                level=True,
                projection=self.projection,
                girth=self.girth,
            )
            return bar.at(*at)
        return box_handle(self.length, self.projection, finish=self.metal).at(*at)

    def hinge(self, pull: ag.Scalar) -> ag.Joint:
        """Make the joint of the door; springs carry its weight, and friction holds it at any angle.

        The spring torque is linear, and is greatest at the open end, as is the torque of the weight m g r
        sin(q). The difference of both is less than the friction of hinges and rollers, which holds the door
        open at any angle, as for grilling.
        """
        space = self.space
        lever = self._handle_height - space.hinge_height
        moment: ag.Scalar = _HANDLE * lever
        for solid, stuff in self._solids:
            moment = moment + stuff.density * solid.volume() * (solid.centroid().z - space.hinge_height)
        return ag.Revolute(
            "door_hinge",
            axis=ag.X,
            pivot=space.hinge,
            limits=(0.0, space.swing),
            stiffness=_GRAVITY * moment * ag.sin(space.swing) / space.swing,
            friction=pull * lever,
            damping=2.5,
            effort=60.0 * lever,
            velocity=4.0,
        )


def box_handle(length: ag.Scalar, out: ag.Scalar, *, finish: ag.Material) -> ag.Body:
    """Make a broad bar with closed ends on the plane y = 0, along x about the origin."""
    deep, high = _BOX
    end = 0.030
    bar = ag.box(length - 0.004, deep, high, bevel=0.0045).at(0.0, -out, 0.0)
    block = ag.box(end, out + deep / 2.0 - 0.0004, high + 0.004, bevel=0.0045)
    ends = [block.at(way * (length - end) / 2.0, -0.5 * (out + deep / 2.0) + 0.0008, 0.0) for way in (-1, 1)]
    hold = ag.frame((0.0, -out, 0.0), approach=(0.0, 1.0, 0.0), closing=(0.0, 0.0, 1.0))
    hollow = casting(finish, 0.3)
    return ag.weld(
        ag.part(bar, "handle", hollow, name="handle", grasp=hold),
        *(ag.part(each, "handle", hollow) for each in ends),
    )
