"""The door of a microwave oven, hinged at its left, with its latches."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.microwave.space import Space
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.controls import ink_on
from artgen.categories.shared.pulls import BarStyle, Grip, bar_handle, boards_around, recessed_grip

HandleKind = Literal["bar", "pocket", "none"]
"""A bar on the door, a recess with a blade in it, or none for a door with an opening button."""

FaceStyle = Literal["framed", "glass", "banded"]
"""A frame around dark glass, a glass front, or glass between two bands of the finish."""

PANE = 0.0008
"""Height of the front glass above the frame [m]."""

POCKET = 0.0275
"""Depth of a recessed grip [m]."""

POCKET_WIDTH = 0.050
"""Width of a recessed grip: 9 mm for fingers at each side of its blade [m]."""

_LAP = 0.0005
_UNDER = 0.0003  # distance from the faces of the frame to the boards under them [m]
_INSET = 0.0012  # distance from the edges of the frame to these boards [m]
_POCKET_HEIGHT = 0.098  # height of a recessed grip [m]
_SKIN = 0.014  # thickness of the outer frame [m]
# width, height and reach of a hook behind the face of the cavity's frame [m]
_HOOK = (0.0050, 0.0065, 0.0120)
_BARB = (0.0042, 0.0050)  # height and thickness of the barb of a hook [m]
_PLAY = 0.0006  # gap between pawl and hook [m]
_PAWL = (0.0030, 0.0090)  # thickness and height of a pawl [m]
_BEHIND = 0.0036  # distance from the face of the cavity's frame to the pawls [m]
_SLOT = 0.0016  # gap around a hook in its slot [m]
_LIFT = 1.22  # ratio of the lift of the pawls to the travel of the button
_SPARE = 0.0006  # gap between pawls and barbs at which the door may open [m]
_EDGE = 0.015  # width of the glass around the window of a framed front [m]
_RAMP = 0.030  # height of the bands above and below the glass of a banded front [m]


@dataclass(frozen=True)
class Latches:
    """Two hooks on the door, and the pawls in the case that hold them until a button lifts the pawls."""

    space: Space  # dimensions of the oven

    @cached_property
    def _levels(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Positions of the middles of the hooks along z [m]."""
        low, high = self.space.floor, self.space.ceiling
        return (low + 0.16 * (high - low), low + 0.80 * (high - low))

    @cached_property
    def slots(self) -> tuple[ag.Span, ag.Span]:
        """Heights of the lower and upper edges of their slots in the frame of the cavity [m]."""
        low, high = _HOOK[1] / 2.0 + _SLOT, _HOOK[1] / 2.0 + _BARB[0] + _SLOT
        first, second = self._levels
        return ((first - low, first + high), (second - low, second + high))

    def hooks(self) -> list[ag.Solid]:
        """Make the hooks, which are welded to the inside of the door."""
        space = self.space
        wide, high, reach = _HOOK
        front, end = space.inner - 0.004, space.mouth + reach
        solids = []
        for level in self._levels:
            x = (space.hook - wide / 2.0, space.hook + wide / 2.0)
            low = level - high / 2.0
            solids.append(ag.Region(x, (front, end), (low, low + high)).box(bevel=0.0008))
            barb = (end - _BARB[1], end - 0.0002)
            inside = (x[0] + 0.0002, x[1] - 0.0002)
            solids.append(ag.Region(inside, barb, (low + 0.002, low + high + _BARB[0])).box(bevel=0.0006))
        return solids

    def pawls(self) -> ag.Body:
        """Make the slide with two pawls: the link `latch`."""
        space = self.space
        y = (space.mouth + _BEHIND, space.mouth + _BEHIND + _PAWL[0])
        x = space.hook
        lows = [level + _HOOK[1] / 2.0 + _PLAY for level in self._levels]
        black = ag.colored("polypropylene", "ivory").with_(name="latch_plastic")
        spine = ag.Region((x + 0.0058, x + 0.0096), y, (lows[0], lows[1] + _PAWL[1])).box()
        fingers = [
            ag.Region(
                (x - 0.0042, x + 0.0060), (y[0] + 0.0002, y[1] - 0.0002), (low, low + _PAWL[1] - 0.0004)
            ).box()
            for low in lows
        ]
        return ag.weld(*(ag.part(each, "latch", black) for each in (spine, *fingers)))

    def slide(self, button: ag.Joint) -> ag.Joint:
        """Make the joint of the pawls, which follows the button."""
        return ag.Prismatic(
            "latch_slide", axis=ag.Z, follows=_LIFT * button, damping=2.0, friction=0.05, armature=0.02
        )

    def frees(self, button: ag.Joint) -> ag.Dependency:
        """Return the condition under which the hooks can pass the pawls."""
        lift = _BARB[0] - _PLAY + _SPARE
        passing = _HOOK[2] - _BEHIND + 0.004  # travel of the barbs below the pawls
        return (button > lift / _LIFT).until(passing / self.space.arm)


@dataclass(frozen=True)
class Door:
    """Layout and finish of a door."""

    space: Space  # dimensions of the oven
    face: FaceStyle  # style of the front
    handle: HandleKind  # kind of handle
    bar: BarStyle  # style of a bar
    finish: ag.Material  # finish of the frame
    glass: ag.Material  # material of the front glass
    metal: ag.Material  # metal of the handle
    inside: ag.Material  # finish of the inside
    # distances from the edges of the door to its window, at the left, the right, below and above [m]
    border: tuple[ag.Scalar, ag.Scalar, ag.Scalar, ag.Scalar]
    maker: str  # brand name; `""` for none

    @cached_property
    def _window(self) -> tuple[ag.Span, ag.Span]:
        """Edges of the window, along x and z [m]."""
        left, right, low, high = self.border
        x, z = self.space.door, self.space.tall
        return ((x[0] + left, x[1] - right), (z[0] + low, z[1] - high))

    @cached_property
    def _grip_at(self) -> ag.Scalar:
        """Position of a handle along x [m]."""
        return self.space.door[1] - (0.021 if self.handle == "bar" else POCKET_WIDTH / 2.0 + 0.009)

    @cached_property
    def _level(self) -> ag.Scalar:
        """Height of the middle of the door [m]."""
        low, high = self.space.tall
        return (low + high) / 2.0

    @cached_property
    def _grip(self) -> Grip | None:
        if self.handle != "pocket":
            return None
        lining = ag.colored("abs", "graphite").with_(name="grip_lining")
        grip = recessed_grip(
            _POCKET_HEIGHT, finish=self.metal, lining=lining, width=POCKET_WIDTH, deep=POCKET, thin=True
        )
        return grip.at(self._grip_at, self.space.front, self._level)

    def body(self, latches: Latches) -> ag.Body:
        """Make the door: the link `door`."""
        bodies = [*self._frame(), *self._panes(), *self._seen()]
        black = ag.colored("polypropylene", "graphite").with_(name="hook_plastic")
        bodies += [ag.part(each, "latch", black) for each in latches.hooks()]
        if self.handle == "bar":
            low, high = self.space.tall
            handle: ag.Body = bar_handle(
                length=0.74 * (high - low), finish=self.metal, style=self.bar, projection=0.034, girth=0.0072
            )
            bodies.append(handle.at(self._grip_at, self.space.front, self._level))
        elif self._grip is not None:
            bodies.append(self._grip.shell)
        return ag.weld(*bodies)

    def _frame(self) -> list[ag.Body]:
        """Make the frame in two layers: the front, and the microwave choke behind it.

        Both are visual only; boards under their surfaces have the mass and collide.
        """
        space = self.space
        front, inner = space.front, space.inner
        (left, right), (low, high) = space.door, space.tall
        (x0, x1), (z0, z1) = self._window
        x, z = (left + right) / 2.0, (low + high) / 2.0
        layers = (
            ((front, front + _SKIN), self.finish, 0.0, 0.0014),
            ((front + _SKIN - _LAP, inner), self.inside, 0.0009, 0.0),
        )
        bodies = []
        for (start, end), finish, inset, bevel in layers:
            outline = ag.rectangle(right - left - 2.0 * inset, high - low - 2.0 * inset)
            hole = ag.rectangle(x1 - x0 - inset, z1 - z0 - inset).at((x0 + x1) / 2.0 - x, (z0 + z1) / 2.0 - z)
            outline = outline - hole
            if self.handle == "pocket":
                across, tall = self._pocket
                outline = outline - ag.rectangle(across[1] - across[0], tall[1] - tall[0]).at(
                    self._grip_at - x
                )
            half, at = (end - start) / 2.0, (x, (start + end) / 2.0, z)
            frame = details.relief(outline, at, proud=half, sunk=half, bevel=bevel)
            bodies.append(ag.detail(frame, "door", finish))
        stuff = filled(self.finish, 670.0, "door")
        return [*(ag.part(each, "door", stuff) for each in self._boards()), *bodies]

    @cached_property
    def _pocket(self) -> tuple[ag.Span, ag.Span]:
        """Edges of the recess of a grip, along x and z [m]."""
        wide, tall = POCKET_WIDTH / 2.0, _POCKET_HEIGHT / 2.0
        return ((self._grip_at - wide, self._grip_at + wide), (self._level - tall, self._level + tall))

    def _boards(self) -> list[ag.Solid]:
        """Make the boards around the window, and around and behind the recess of a grip."""
        space = self.space
        y = (space.front + _UNDER, space.inner - _UNDER)
        (left, right), (low, high) = space.door, space.tall
        x, z = (left + _INSET, right - _INSET), (low + _INSET, high - _INSET)
        beside, other, *rest = boards_around(x, z, self._window, y)
        if self.handle != "pocket":
            return [beside, other, *rest]
        within = (self._window[0][1], x[1])
        across, tall = ((start - _LAP, end + _LAP) for start, end in self._pocket)
        behind = ag.Region(across, (space.front + POCKET, y[1] - 2.0 * _LAP), tall).box()
        return [beside, *rest, *boards_around(within, z, self._pocket, y), behind]

    def _panes(self) -> list[ag.Body]:
        """Make the panes of the window with the mesh between them, visual only."""
        (x0, x1), (z0, z1) = self._window
        front, inner = self.space.front, self.space.inner
        bite = 0.003
        x, z = (x0 - bite, x1 + bite), (z0 - bite, z1 + bite)
        tinted = ag.material("tinted_glass").with_(name="door_glass", opacity=0.5)
        # density with the mesh
        clear = ag.material("glass").with_(name="inner_film", opacity=0.12, density=1900.0)
        mesh = ag.material("perforated_steel").with_(name="window_mesh", opacity=0.72)
        return [
            ag.part(ag.Region(x, (front + 0.0012, front + 0.0042), z).box(), "window", tinted),
            ag.detail(ag.Region(x, (front + 0.018, front + 0.0186), z).box(), "mesh", mesh),
            ag.part(ag.Region(x, (inner - 0.0044, inner - 0.0032), z).box(), "window", clear),
        ]

    def _seen(self) -> list[ag.Body]:
        """Make the glass of the front, the edge of the mesh, the choke's cover, hinges and the name."""
        space = self.space
        (left, right), (low, high) = space.door, space.tall
        (x0, x1), (z0, z1) = self._window
        middle, level = (left + right) / 2.0, (low + high) / 2.0
        hole = ag.rectangle(x1 - x0 - 0.004, z1 - z0 - 0.004, radius=0.005).at(
            (x0 + x1) / 2.0 - middle, (z0 + z1) / 2.0 - level
        )
        pane = details.relief(self._pane(hole), (middle, space.front, level), proud=PANE, sunk=0.0006)
        bodies = [ag.detail(pane, "door", self.glass)]
        # on real panes, an edge of dots darkens to black; here the edge is a rim
        rim = ag.rectangle(x1 - x0 + 0.002, z1 - z0 + 0.002, radius=0.006)
        rim = rim - ag.rectangle(x1 - x0 - 0.012, z1 - z0 - 0.012, radius=0.010)
        at = ((x0 + x1) / 2.0, space.front + 0.0011, (z0 + z1) / 2.0)
        black = ag.material("black_glass").with_(name="window_rim", specular_roughness=0.25)
        bodies.append(ag.detail(details.relief(rim, at, proud=0.0002, sunk=0.0006), "door", black))
        a, b = space.across
        choke = ag.rectangle(b - a + 0.030, space.ceiling - space.floor + 0.022, radius=0.010)
        choke = choke - ag.rectangle(x1 - x0 + 0.006, z1 - z0 + 0.006, radius=0.008).at(
            -((x0 + x1) / 2.0 - (a + b) / 2.0), (z0 + z1) / 2.0 - (space.floor + space.ceiling) / 2.0
        )  # seen from behind, x is reversed
        cover = details.relief(
            choke,
            ((a + b) / 2.0 + 0.0, space.inner, (space.floor + space.ceiling) / 2.0),
            facing=(0.0, 1.0, 0.0),
            proud=0.0008,
            sunk=0.0006,
        )
        bodies.append(
            ag.detail(cover, "door", ag.colored("polypropylene", "slate").with_(name="choke_cover"))
        )
        pin_x, pin_y, _ = space.hinge
        pin = ag.cylinder(0.0030, 0.0016).at(pin_x, pin_y, 0.0)
        bodies.append(
            ag.detail(ag.array(pin, at=[(0.0, 0.0, z) for z in (low, high)]), "hinge", ag.material("zinc"))
        )
        if self.maker:
            bottom = {"framed": z0 - _EDGE, "glass": z0, "banded": low + _RAMP}[self.face]
            face, plane = (self.glass, PANE) if self.face == "glass" else (self.finish, 0.0)
            at = ((x0 + x1) / 2.0, space.front - plane, (low + bottom) / 2.0)
            bodies.append(details.printed(details.logo(self.maker, 0.0062), at, material=ink_on(face)))
        return bodies

    def _pane(self, hole: ag.Profile) -> ag.Profile:
        """Return the outline of the glass on the front about the middle of the door, without the window."""
        (left, right), (low, high) = self.space.door, self.space.tall
        wide, tall = right - left, high - low
        match self.face:
            case "framed":
                (x0, x1), (z0, z1) = self._window
                pane = ag.rectangle(x1 - x0 + 2.0 * _EDGE, z1 - z0 + 2.0 * _EDGE, radius=0.012)
                return pane.at((x0 + x1 - left - right) / 2.0, (z0 + z1 - low - high) / 2.0) - hole
            case "glass":
                pane = ag.rectangle(wide - 0.003, tall - 0.003, radius=0.003)
            case "banded":
                pane = ag.rectangle(wide - 0.0006, tall - 2.0 * _RAMP)
        pane = pane - hole
        if self._grip is not None:
            cut = ag.rectangle(POCKET_WIDTH + 0.0068, _POCKET_HEIGHT + 0.0068, radius=0.004)
            pane = pane - cut.at(self._grip_at - (left + right) / 2.0)
        return pane

    def hinge(
        self, *, swing: ag.Scalar, pull: ag.Scalar, needs: ag.Dependency | None, sprung: bool = False
    ) -> ag.Joint:
        """Make the joint of the door.

        Friction holds a door with a handle at any angle: 10-25 N at the handle release the hooks from their
        catches and move the door. A spring opens a door with a button to 0.3 rad, and friction holds it from
        there on.
        """
        space = self.space
        arm = space.arm
        axis, pivot = (0.0, 0.0, -1.0), space.hinge
        if not sprung:
            return ag.Revolute(
                "door_hinge",
                axis=axis,
                pivot=pivot,
                limits=(0.0, swing),
                friction=pull * arm,
                damping=0.25,
                effort=50.0 * arm,
                velocity=5.0,
                needs=needs,
            )
        # friction is the spring force at 0.8 rad, so that it holds the door from 0.3 rad to the end
        rest, held = 1.15, 0.85
        stiffness = pull * arm / rest
        return ag.Revolute(
            "door_hinge",
            axis=axis,
            pivot=pivot,
            limits=(0.0, swing),
            stiffness=stiffness,
            rest=rest,
            friction=held * stiffness,
            damping=0.12,
            effort=30.0 * arm,
            velocity=5.0,
            needs=needs,
            driven="its spring",
        )
