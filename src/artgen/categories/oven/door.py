"""The door of an oven: a front of steel or glass with its window, a handle, and springs that carry it."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.oven.space import LAP, SKIN, Space
from artgen.categories.shared.appliances.finish import DARK, filled
from artgen.categories.shared.controls.panels import ink_on
from artgen.categories.shared.finish import casting
from artgen.categories.shared.hardware.bar_handles import BarStyle, bar_handle

Window = Literal["none", "partial", "full"]
"""A solid front, one with a window in it, or one of glass all over."""

HandleKind = Literal["bar", "box"]
"""A rod on posts, or a broad bar with closed ends."""

BEHIND = 0.0085
"""How far a handle reaches out beyond its middle, at most [m]."""

_GRAVITY = 9.81
_HANDLE = 0.45  # what a handle weighs, about [kg]
_HALF = 0.016  # half the height of a handle, at most [m]
_DOWN = 0.045  # from the upper edge of the door to the middle of its handle [m]
_PANE = 0.004  # thickness of a pane [m]
_FRONT, _CORE = 700.0, 430.0  # what front and core weigh by their volume [kg/m3]
_BOX = (0.015, 0.026)  # depth and height of the bar of a box handle [m]


@dataclass(frozen=True)
class Door:
    """How a door looks."""

    space: Space  # the measures of the oven
    window: Window  # of its front
    across: ag.Scalar  # width of the window, as a share of that of the cavity
    tall: ag.Scalar  # height of the window, as a share of what there is room for
    handle: HandleKind  # the kind of the handle
    bar: BarStyle  # style of a bar
    length: ag.Scalar  # of the handle [m]
    projection: ag.Scalar  # from the front to the middle of a handle [m]
    girth: ag.Scalar  # half the thickness of a bar [m]
    finish: ag.Material  # of the front
    glass: ag.Material  # of a front of glass, and around a window
    metal: ag.Material  # of the handle
    maker: str  # whose name is on it; `""` for none

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
        """Half the width of the window, and its lower and upper edge [m]."""
        space = self.space
        low, high = space.floor + 0.012, self._handle_height - 0.042
        middle, half = (low + high) / 2.0, 0.5 * self.tall * (high - low)
        return (self.across * space.inside, (middle - half, middle + half))

    @cached_property
    def _solids(self) -> list[tuple[ag.Solid, ag.Material]]:
        """The front, the core behind it and the panes, with their materials."""
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
        # panes lie in the rims of their holes, the outer one level with the front
        half, (bottom, top) = self._view
        tinted = ag.material("tinted_glass").with_(
            name="oven_glass", base_color=(0.055, 0.055, 0.06), opacity=0.74
        )
        clear = ag.material("glass").with_(name="inner_glass", opacity=0.14)
        for deep, wide, glass in ((front + 0.0006, 0.002, tinted), (inner - _PANE - 0.0008, 0.009, clear)):
            x, z = (-half - wide, half + wide), (bottom - wide, top + wide)
            solids.append((ag.board(x, (deep, deep + _PANE), z), glass))
        return solids

    def _hole(self, wider: ag.Scalar) -> ag.Profile | None:
        """Return the opening of the window at its height, larger by some length all around [m]."""
        if self.window == "none":
            return None
        half, (low, high) = self._view
        return ag.rectangle(2.0 * (half + wider), high - low + 2.0 * wider).at(0.0, (low + high) / 2.0)

    @cached_property
    def handle_before(self) -> ag.Scalar:
        """How far the handle of the open door is before its axis [m]."""
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
        """Make what is seen on its inside: the frame of the inner pane, screws' covers, hinges."""
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
        """Make the joint of the door; springs carry its weight, friction holds it where it is left.

        The springs are linear and begin at the closed door, so that they lift most where its weight pulls
        most; the rest of m g r sin(q) is less than the friction of hinges and rollers, by which the door of
        an oven stays open by any angle, as for grilling.
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
