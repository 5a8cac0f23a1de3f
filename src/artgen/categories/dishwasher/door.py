"""The door of a dishwasher: front, console, handle, liner and detergent dispenser."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.dishwasher.console import LAP, Console
from artgen.categories.dishwasher.space import DISH, Controls, Space
from artgen.categories.shared.appliances import DARK, filled
from artgen.categories.shared.controls import ink_on
from artgen.categories.shared.pulls import BarStyle, bar_handle, pocket_grip, recessed_grip
from artgen.nodes.fitting import Fitting

FLAP_TRAVEL = 0.036
"""Travel of the detergent flap [m]."""

_TAB = 0.011  # height of the tab of the flap above the rim of the liner [m]
_ABOVE = 0.0032  # gap between the lower rack and the tab above it [m]
_FACE = 0.002  # depth of the dispenser behind the rim of the liner [m]
_PLATE = 0.0034  # thickness of the flap [m]


@dataclass(frozen=True)
class Dispenser:
    """A dispenser on the liner of the door."""

    space: Space  # dimensions of the machine
    rim: ag.Scalar  # height of the front rim of the lower rack [m]
    beside: ag.Scalar  # distance to the right of the middle [m]

    def housing(self) -> list[ag.Body]:
        """Make the housing of the flap, with the cap of the rinse aid."""
        space = self.space
        face, floor = space.inner - _FACE, space.inner - DISH
        x, low, high = self.beside, self.rim - 0.042, self.rim + 0.075
        grey = ag.colored("abs", "light_grey").with_(name="dispenser_grey")
        housing = ag.Region((x - 0.058, x + 0.058), (floor - 0.001, face), (low, high)).box(bevel=0.004)
        cup = ag.rectangle(0.046, 0.036, radius=0.005)
        chamber = details.relief(
            cup, (x - 0.014, face, self.rim + _ABOVE + 0.022), facing=(0.0, 1.0, 0.0), proud=0.0003
        )
        dark = ag.colored("abs", "slate").with_(name="chamber_shade")
        cap = ag.cylinder(0.017, 0.0014, axis=ag.Y, bevel=0.0006).at(
            x + 0.036, face + 0.0004, self.rim + 0.040
        )
        arrow = details.icon("drop", 0.014)
        print_ = details.printed(
            arrow, (x + 0.036, face + 0.0012, self.rim + 0.040), material=dark, facing=(0.0, 1.0, 0.0)
        )
        guides = [
            ag.detail(
                ag.Region(
                    (x - 0.014 + side * 0.030 - 0.0015, x - 0.014 + side * 0.030 + 0.0015),
                    (face - 0.001, face + 0.0028),
                    (low + 0.002, self.rim + _ABOVE + 0.046),
                ).box(bevel=0.0006),
                "dispenser",
                grey,
            )
            for side in (-1, 1)
        ]
        return [
            ag.part(housing, "dispenser", grey),
            ag.detail(chamber, "dispenser", dark),
            ag.detail(cap, "rinse_cap", ag.colored("abs", "sky")),
            print_,
            *guides,
        ]

    def flap(self) -> ag.Body:
        """Make the detergent flap: a plate with a tab for fingers."""
        space = self.space
        near = space.inner - _FACE + 0.0006
        x, low = self.beside - 0.014, self.rim + _ABOVE
        plate = ag.Region((x - 0.027, x + 0.027), (near, near + _PLATE), (low, low + 0.044)).box(bevel=0.001)
        tab = ag.Region((x - 0.017, x + 0.017), (near + 0.001, space.inner + _TAB), (low, low + 0.010)).box(
            bevel=0.002
        )
        hold: ag.Frame = ag.frame(
            (x, space.inner + _TAB + 0.002, low + 0.005), approach=(0.0, -1.0, 0.0), closing=ag.Z
        )
        blue = ag.colored("abs", "light_grey").with_(name="flap_grey")
        return ag.weld(
            ag.part(plate, "detergent_flap", blue, grasp=hold, grasp_width=0.020),
            ag.part(tab, "detergent_flap", blue),
        )

    def slide(self, needs: ag.Condition | ag.Dependency) -> ag.Joint:
        """Make the joint of the flap; a spring closes it."""
        preload, force = 1.2, 4.0  # force of a thumb
        stiffness = (force - preload) / FLAP_TRAVEL
        return ag.Prismatic(
            "detergent_flap_slide",
            axis=-ag.Z,
            pivot=(self.beside, self.space.inner, self.rim),
            limits=(0.0, FLAP_TRAVEL),
            stiffness=stiffness,
            rest=-preload / stiffness,
            damping=8.0,
            friction=0.2,
            armature=0.05,
            effort=8.0,
            needs=needs,
        )

    @cached_property
    def slack(self) -> float:
        """Return the travel of the flap until its tab strikes the lower rack [m]."""
        return _ABOVE - 0.0006


HandleKind = Literal["bar", "pocket", "recessed"]
"""A bar in front of the door, a pocket in the upper edge, or a recess in the front with a blade in it."""

SKIN = 0.018
"""Thickness of the front with its core [m]."""

PANEL = 480.0
"""Density of a console with its electronics [kg/m3]."""

_EDGE = 0.004  # gap between the door and the part above it [m]
_GAP = 0.0018  # gap between console and front [m]
_RIM = 0.034  # width of the upper rim of the dish [m]
_RECESS = 0.0285  # depth of a recessed grip, whose back is in the liner [m]
_HALF_RECESS = 0.037  # half the height of a recessed grip [m]
_POCKET = 0.030  # depth of a pocket [m]
_BEFORE_POCKET = 0.0155  # thickness of the door before a pocket: the lip for the fingers [m]
_BEHIND_POCKET = 0.0376  # distance from the front to the back of a pocket [m]
_GRAVITY = 9.81
_HANDLE = 0.35  # approximate mass of a handle [kg]


RECESS_HALF = _HALF_RECESS
"""Half the height of the opening for a recessed grip [m]."""

CONSOLE_BEFORE_POCKET = _BEFORE_POCKET
"""Thickness of a console before a pocket [m]."""


def _frame_of(half: ag.Scalar, y: ag.Span, z: ag.Span, wide: ag.Scalar, opening: ag.Span) -> list[ag.Solid]:
    """Make the four boards around an opening in the middle of a wall."""
    low, high = z
    return [
        ag.Region((-half, half), y, (low, opening[0])).box(),
        ag.Region((-half, half), y, (opening[1], high)).box(),
        ag.Region((-half, -wide), y, (opening[0] - LAP, opening[1] + LAP)).box(),
        ag.Region((wide, half), y, (opening[0] - LAP, opening[1] + LAP)).box(),
    ]


@dataclass(frozen=True)
class Front:
    """Layout and finish of a door."""

    space: Space  # dimensions of the machine
    worktop: bool  # whether a worktop is above the upper edge
    controls: Controls  # position of the console
    console: Console  # the console
    high: ag.Scalar  # height of a console in the front [m]
    handle: HandleKind  # kind of handle
    bar: BarStyle  # style of a bar
    length: ag.Scalar  # length of the handle [m]
    projection: ag.Scalar  # distance from the front to the middle of a bar [m]
    girth: ag.Scalar  # half the thickness of a bar [m]
    metal: ag.Material  # metal of the handle
    finish: ag.Material  # finish of the front
    framed: bool  # whether a wooden front has a raised frame
    liner: ag.Material  # material of the inside
    maker: str  # brand name; `""` for none
    dispenser: Dispenser  # dispenser on the inside

    @cached_property
    def top(self) -> ag.Float:
        """Height of the upper edge of the door [m]."""
        return self.space.height - (0.030 + _EDGE if self.worktop else _EDGE)

    @cached_property
    def _half(self) -> ag.Float:
        return self.space.width / 2.0 - 0.0015

    @cached_property
    def _skin_top(self) -> ag.Scalar:
        return self.top - (self.high + _GAP if self.controls == "front" else self.console.thickness + _GAP)

    @cached_property
    def handle_height(self) -> ag.Scalar:
        """Height at which a hand pulls the door [m]."""
        if self.handle == "pocket":
            return self.top - 0.013
        if self.handle == "bar":
            return self._skin_top - 0.055
        return self.top - self.high / 2.0 if self.controls == "front" else self._skin_top - 0.065

    @cached_property
    def _grip(self) -> Fitting | None:
        """Return the recessed or pocket grip in its place."""
        space = self.space
        if self.handle == "pocket":
            grip = pocket_grip(self.length, finish=self._lining, lip=_BEFORE_POCKET, gap=0.022, deep=_POCKET)
            # the free edge of a door hinged at the left becomes the upper edge
            turned = grip.rotate(ag.Y, -math.pi / 2.0)
            return turned.at(0.0, space.front, self.top)
        if self.handle == "recessed":
            grip = recessed_grip(
                self.length, finish=self.metal, lining=self._lining, deep=_RECESS, level=True
            )
            return grip.at(0.0, space.front, self.handle_height)
        return None

    @cached_property
    def _lining(self) -> ag.Material:
        return ag.colored("abs", "graphite").with_(name="grip_lining")

    @cached_property
    def _boards(self) -> list[tuple[ag.Solid, ag.Material]]:
        """Return the boards of the front and the liner with their materials, around the grip."""
        space, half, low = self.space, self._half, self.space.door_bottom
        front, inner, dish = space.front, space.inner, space.inner - DISH
        wooden = self.finish.name.startswith(("oak", "walnut", "ash", "lacquered"))
        skin = ag.Region((-half, half), (front, front + SKIN), (low, self._skin_top)).box(bevel=0.003)
        grip = self._grip
        if grip is not None and grip.cut is not None and self.handle == "recessed" and self.controls == "top":
            skin = skin - grip.cut
        top = self.top if self.controls == "front" else self.top - self.console.thickness - 0.0002
        core, behind = (front + SKIN - 0.001, dish), (dish, inner)
        level = top - _RIM
        solids = self._around_grip(core, behind, level, top)
        beside = space.inside - 0.034
        solids.append(ag.Region((-half, half), behind, (low, low + 0.058)).box(bevel=0.003))
        for x in ((beside, half), (-half, -beside)):
            solids.append(ag.Region(x, behind, (low + 0.056, level + 0.002)).box(bevel=0.003))
        stuff = filled(self.liner, 285.0, "liner")
        return [
            (skin, filled(self.finish, 380.0 if wooden else 290.0, "front")),
            *((each, stuff) for each in solids),
        ]

    def _around_grip(
        self, core: ag.Span, behind: ag.Span, level: ag.Scalar, top: ag.Scalar
    ) -> list[ag.Solid]:
        """Make the liner's wall and upper rim, with space for recesses of the front."""
        half, low, wide = self._half, self.space.door_bottom, 0.5 * self.length
        front, inner, dish = self.space.front, behind[1], behind[0]
        solids: list[ag.Solid] = []
        rim = ag.Region((-half, half), behind, (level, top)).box(bevel=0.003)
        match self.handle:
            case "bar":
                solids = [ag.Region((-half, half), core, (low, top)).box(), rim]
            case "recessed":
                z = self.handle_height
                solids = [
                    *_frame_of(half, core, (low, top), wide, (z - _HALF_RECESS, z + _HALF_RECESS)),
                    ag.Region(
                        (-wide, wide), (front + _RECESS, dish), (z - _HALF_RECESS, z + _HALF_RECESS)
                    ).box(),
                    rim,
                ]
            case "pocket":
                bottom = top - _POCKET
                solids = [
                    ag.Region((-half, half), core, (low, bottom)).box(),
                    ag.Region((-half, half), behind, (level, bottom)).box(),
                    ag.Region(
                        (-wide - LAP, wide + LAP), (front + _BEHIND_POCKET, inner), (bottom - LAP, top)
                    ).box(),
                    *(
                        ag.Region(
                            (wide, half) if side > 0 else (-half, -wide),
                            (front + SKIN - 0.001 + LAP, inner),
                            (bottom - 2.0 * LAP, top),
                        ).box()
                        for side in (-1, 1)
                    ),
                ]
        return solids

    def _console_at(self, body: ag.Body) -> ag.Body:
        """Move the console to its place, turned over on the upper edge."""
        space = self.space
        if self.controls == "front":
            return body.at(0.0, space.front, self.top - self.high / 2.0)
        return body.rotate(ag.X, -math.pi / 2.0).at(0.0, space.front + space.thickness / 2.0, self.top)

    def body(self) -> ag.Body:
        """Make the door with its console and dispenser: the link `door`."""
        boards = [ag.part(solid, "door", stuff) for solid, stuff in self._boards]
        bodies = [*boards, *self.dispenser.housing(), *self._liner_details(), *self._front_details()]
        bodies.append(self._bar() if self._grip is None else self._grip.body)
        return ag.weld(*bodies, self._console_body())

    def _console_body(self) -> ag.Body:
        console = self.console
        stuff = filled(console.finish, PANEL, "panel")
        faces = [ag.part(solid, "panel", stuff) for solid in console.boards()]
        body = console.joined(ag.weld(*faces, console.printed()))
        return self._console_at(body)

    def _bar(self) -> ag.Body:
        bar: ag.Body = bar_handle(
            length=self.length,
            finish=self.metal,
            style=self.bar,
            level=True,
            projection=self.projection,
            girth=self.girth,
        )
        return bar.at(0.0, self.space.front, self.handle_height)

    def _front_details(self) -> list[ag.Body]:
        """Make the frame of a wooden front and the maker's name."""
        space = self.space
        bodies: list[ag.Body] = []
        low, top = space.door_bottom, self._skin_top
        if self.framed:
            width, height = 2.0 * self._half - 0.004, top - low - 0.004
            outline = ag.rectangle(width, height, radius=0.002) - ag.rectangle(width - 0.13, height - 0.13)
            at = (0.0, space.front, (low + top) / 2.0)
            frame_ = details.relief(outline, at, proud=0.0045, sunk=0.001, bevel=0.0012)
            bodies.append(ag.detail(frame_, "door", self.finish))
        if self.maker and not self.framed:
            word = details.logo(self.maker, 0.0085)
            z = top - (0.105 if self.handle != "pocket" and self.controls == "top" else 0.032)
            level = z if self.handle != "bar" else low + 0.06
            bodies.append(details.printed(word, (0.0, space.front, level), material=ink_on(self.finish)))
        return bodies

    def _liner_details(self) -> list[ag.Body]:
        """Make the vent in the liner, and the arms of the hinges beside it."""
        space = self.space
        floor = space.inner - DISH
        vent = ag.cylinder(0.031, 0.006, axis=ag.Y, bevel=0.002).at(
            -self.dispenser.beside, floor + 0.002, self.top - 0.16
        )
        slots = details.vent_slots(0.044, 0.036, 7, slot=0.003, direction="horizontal")
        grille = details.relief(
            slots,
            (-self.dispenser.beside, floor + 0.005, self.top - 0.16),
            facing=(0.0, 1.0, 0.0),
            proud=0.0003,
        )
        bodies = [
            ag.detail(vent, "vent", ag.colored("polypropylene", "grey")),
            ag.detail(grille, "vent", DARK),
        ]
        steel = ag.material("zinc")
        for side in (-1, 1):
            x = side * (space.inside + 0.013)
            arm = ag.box(0.005, 0.003, 0.055, bevel=0.001).at(x, space.inner + 0.001, space.plinth + 0.055)
            bodies.append(ag.detail(arm, "hinge", steel))
        return bodies

    def hinge(self, pull: ag.Scalar) -> ag.Joint:
        """Make the joint of the door; springs carry its weight, and friction holds it at any angle.

        The spring torque is linear, and is greatest at the open end, as is the torque of the weight m g r
        sin(q). Both are equal at the open end; the difference in between is less than the friction.
        """
        space = self.space
        moment: ag.Scalar = _HANDLE * (self.handle_height - space.plinth)
        for solid, stuff in self._boards:
            moment = moment + stuff.density * solid.volume() * (solid.centroid().z - space.plinth)
        for solid in self.console.boards():
            moment = moment + PANEL * solid.volume() * (self.top - space.plinth - 0.03)
        return ag.Revolute(
            "door_hinge",
            axis=ag.X,
            pivot=space.hinge,
            limits=(0.0, space.swing),
            stiffness=_GRAVITY * moment * ag.sin(space.swing) / space.swing,
            friction=pull * (self.handle_height - space.plinth),
            damping=2.0,
            effort=40.0,  # torque of 60 N at the handle
            velocity=4.0,
        )
