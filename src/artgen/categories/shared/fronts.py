"""Leaves of doors and fronts of furniture: their common data, frames, panels, panes, slats and moldings.

Fillings are made about the origin and copied to the openings, in the middle plane y = 0.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import artgen as ag

_STEPS = 24
"""Number of sides of an arch: 0.3 mm between chord and arc at a radius of 0.9 m."""


@dataclass(frozen=True)
class Arch:
    """An arch over the middle of the asset."""

    half: ag.Float  # half of the span [m]
    radius: ag.Float  # radius of the circle [m]
    center: ag.Float  # height of the center of the circle [m]

    @staticmethod
    def over(span: ag.Float, *, spring: ag.Scalar, rise: ag.Float) -> "Arch":
        """Return the arch over a span, from the height `spring` up by `rise` [m]."""
        half = span / 2.0
        radius = (half * half + rise * rise) / (2.0 * rise)
        return Arch(half, radius, spring + rise - radius)

    def outset(self, distance: ag.Scalar) -> "Arch":
        """Return the concentric arch over a span that is wider by `distance` on each side [m]."""
        return Arch(self.half + distance, self.radius + distance, self.center)

    @property
    def angle(self) -> ag.Float:
        """Half of the angle of the arch [rad]."""
        return ag.atan2(self.half, ag.sqrt(self.radius * self.radius - self.half * self.half))

    @property
    def spring(self) -> ag.Float:
        """Height of the ends of the arch [m]."""
        return self.center + ag.sqrt(self.radius * self.radius - self.half * self.half)

    @property
    def crown(self) -> ag.Float:
        """Height of the top of the arch [m]."""
        return self.center + self.radius

    def segment(self) -> ag.Profile:
        """Make the region between the arch and its chord, x to the right and y up [m]."""
        angles = [self.angle * (1 - 2 * step / _STEPS) for step in range(_STEPS + 1)]
        radius = self.radius
        return ag.polygon([(radius * ag.sin(a), self.center + radius * ag.cos(a)) for a in angles])

    def bands(self, width: ag.Scalar, *, count: int = 1, beyond: ag.Scalar = 0.0) -> list[ag.Profile]:
        """Make the band of a width outside the arch, in equal lengths from right to left."""
        whole = 2.0 * (self.angle + beyond / self.radius)
        middle, sweep = self.radius + width / 2.0, whole / count
        starts = [(math.pi - whole) / 2.0 + index * sweep for index in range(count)]
        return [ag.bow(middle, width, start=start, sweep=sweep).at(0.0, self.center) for start in starts]


EASED = 0.0008
"""Radius of the sanded edges of boards [m]: joints show as a fine line."""

_FROM_EDGE = 0.094  # distance from the lock edge to the push point: beside a pull, still on a stile [m]


@dataclass(frozen=True)
class Fittings:
    """Fittings of a leaf besides its lock."""

    finish: ag.Material  # metal of the fittings
    letters: bool = False  # whether there is a letter plate
    number: str = ""  # house number; empty for none
    viewer: bool = False  # whether there is a door viewer
    kick: bool = False  # whether a kick plate protects the foot
    sweep: bool = False  # whether a brush seals the gap to the floor

    def bare(self) -> "Fittings":
        """Return the fittings of an interior leaf: none."""
        return Fittings(self.finish, kick=self.kick, sweep=self.sweep)


@dataclass(frozen=True)
class Blank:
    """Common data of door leaves."""

    width: ag.Float  # width of the leaf [m]
    bottom: ag.Float  # height of the bottom above the floor [m]
    top: ag.Float  # height of the top (of the crown of an arch) above the floor [m]
    thickness: ag.Float  # thickness of the leaf [m]
    rise: ag.Float | None  # rise of an arched top over its ends; None for a straight top [m]
    cut: ag.Solid | None  # cutter of the hardware in the lock stile; None for none
    finish: ag.Material  # material of the leaf
    fittings: Fittings  # fittings of an entrance besides its lock
    reach: ag.Float  # height above the floor at which hands push the leaf [m]

    @property
    def straight(self) -> ag.Scalar:
        """Height above the floor up to which the edges are straight [m]."""
        return self.top if self.rise is None else self.top - self.rise

    @property
    def arch(self) -> Arch | None:
        """Arch of the top, or None."""
        return None if self.rise is None else Arch.over(self.width, spring=self.straight, rise=self.rise)

    @property
    def upright(self) -> ag.Scalar:
        """Length of the side edges [m]."""
        return self.straight - self.bottom

    @property
    def waist(self) -> ag.Scalar:
        """Height of the middle of the side edges above the floor [m]."""
        return (self.straight + self.bottom) / 2.0

    @property
    def push(self) -> ag.Frame:
        """Return the push frame of a hand: on the back, which faces +y, near the lock edge."""
        at = (self.width / 2.0 - _FROM_EDGE, self.thickness / 2.0, self.reach)
        return ag.frame(at, approach=(0.0, -1.0, 0.0), closing=(1.0, 0.0, 0.0))

    def carved(self, solid: ag.Solid) -> ag.Solid:
        """Return a solid without the cutouts of the hardware."""
        return solid if self.cut is None else solid - self.cut

    def board(self, x: ag.Scalar, z: ag.Scalar, bevel: ag.Scalar = EASED) -> ag.Solid:
        """Make a board about the origin with the thickness of the leaf."""
        return ag.box(x, self.thickness, z, bevel=bevel)


_PANE = 0.005  # thickness of toughened glass [m]
_BOARDS = 3  # number of boards from which the slats of a section are cut
# thickness of a board behind slats, and of a board with the mass of the slats [m]
_CORE, _SLATS = 0.004, 0.009
_BEVEL = 0.055  # width of the bevels of a fielded panel, molding included [m]


Relief = Literal["raised", "recessed"]
"""Panels with raised fields, or flat panels in their grooves."""

Sticking = Literal["ogee", "ovolo", "square", "ramp"]
"""Molding around panels: an S, a quarter round, none, or a plain slope down to the panel."""


class Opening(NamedTuple):
    """The openings of a row, all of one size."""

    width: ag.Scalar  # width of an opening [m]
    height: ag.Scalar  # height of an opening [m]
    centers: Sequence[ag.VectorLike]  # centers of the openings [m]
    columns: int  # number of openings
    finish: ag.Material  # finish of the surrounding frame
    label: str = "door"  # semantic label of the leaf

    def everywhere(self, solid: ag.Solid) -> ag.Solid:
        """Return copies of a solid, made about the origin, in all openings."""
        return ag.array(solid, at=self.centers)


Fill = Callable[[Opening, ag.Scalar], list[ag.Body]]
"""A function that makes the filling of the openings of a row in a leaf of some thickness [m]."""


_SECTIONS: dict[str, tuple[tuple[float, float], ...]] = {
    # shares of the reach and of the depth of a molding, from the panel up to the face of the frame
    "ogee": (
        (1.0, 0.84), (0.93, 0.84), (0.90, 0.76), (0.80, 0.70), (0.69, 0.655), (0.58, 0.60), (0.48, 0.51),
        (0.40, 0.40), (0.33, 0.28), (0.26, 0.19), (0.17, 0.13), (0.10, 0.11), (0.10, 0.05),
    ),
    "ovolo": (
        (1.0, 0.80), (0.90, 0.80), (0.90, 0.72), (0.885, 0.58), (0.84, 0.45), (0.765, 0.33), (0.66, 0.23),
        (0.54, 0.16), (0.40, 0.12), (0.26, 0.11), (0.26, 0.05),
    ),
    "ramp": ((1.0, 0.93), (0.02, 0.05)),
    "bead": ((1.0, 0.55), (0.97, 0.47), (0.88, 0.40), (0.62, 0.30), (0.40, 0.17), (0.32, 0.09), (0.32, 0.05)),
}  # fmt: skip


def _sticking(
    opening: Opening, thickness: ag.Scalar, depth: ag.Scalar, reach: ag.Scalar, style: str
) -> list[ag.Body]:
    """Make the molding around the openings on both faces, down to the filling."""
    corners = [(out * reach, -down * depth) for out, down in _SECTIONS[style]]
    last = -_SECTIONS[style][-1][1] * depth
    # union with its foot: a union is smooth at obtuse corners
    foot = ag.rectangle(reach + 0.0005, 0.2 * depth).at(reach / 2.0 - 0.00025, -0.9 * depth)
    section = ag.polygon([(-0.0005, last), (-0.0005, -depth), (reach, -depth), *corners]) | foot
    x, z = opening.width / 2.0, opening.height / 2.0
    ring = ag.polyline([(-x, -z, 0.0), (x, -z, 0.0), (x, z, 0.0), (-x, z, 0.0)], closed=True)
    # swept on the floor, with the section's y up, then rotated upright: up becomes the front
    front = ag.sweep(section, ring).rotate(ag.X, math.pi / 2.0).at(0.0, -thickness / 2.0, 0.0)
    faces = [opening.everywhere(face) for face in (front, front.rotate(ag.Z, math.pi))]
    return [ag.detail(faces, opening.label, opening.finish)]


def panels_in(
    opening: Opening, thickness: ag.Scalar, relief: Relief, moulding: ag.Scalar, sticking: Sticking
) -> list[ag.Body]:
    """Make the panels of a row with their moldings; each panel is a separate board."""
    width, height = opening.width - 0.0006, opening.height - 0.0006
    tongue = 0.25 * thickness  # 9-11 mm are in the groove
    panel = ag.box(width, tongue, height)
    if relief == "raised":
        # fielded on both faces: bevels rise from the groove to a field 4 mm below the faces of the leaf
        run = 2.0 * ag.min_(_BEVEL, 0.3 * ag.min_(width, height))
        field = ag.box(width - run, thickness - 0.008, height - run)
        panel = ag.hull(panel, field)
    panels = [panel.at(center) for center in opening.centers]
    bodies = [ag.part(panels, opening.label, opening.finish)]
    if sticking == "square":
        return bodies
    return bodies + _sticking(opening, thickness, (thickness - tongue) / 2.0, moulding, sticking)


def panes_in(
    opening: Opening,
    thickness: ag.Scalar,
    columns: int,
    lights: int,
    glass: ag.Material,
    *,
    pane: float = _PANE,
) -> list[ag.Body]:
    """Make a pane in its beads, and the muntins over it."""
    width, height = opening.width - 0.002, opening.height - 0.002
    bodies = [
        ag.part(opening.everywhere(ag.box(width, pane, height)), "glass", glass),
        *_sticking(opening, thickness, (thickness - pane) / 2.0, 0.013, "bead"),
    ]
    center = opening.centers[0]
    soft = ag.min_(0.005, 0.45 * (thickness - 0.009))  # doors of cabinets are thin
    post = ag.box(0.022, thickness - 0.008, opening.height, bevel=soft)
    beam = ag.box(opening.width, thickness - 0.009, 0.022, bevel=soft)
    for number, bar, step in (
        (columns, post, ag.X * (opening.width / columns)),
        (lights, beam, ag.Z * (opening.height / lights)),
    ):
        if number > 1:
            bars = [bar.at(step * (at - number / 2)).at(center) for at in range(1, number)]
            bodies.append(ag.part(ag.union(*bars), opening.label, opening.finish))
    return bodies


def slats_in(opening: Opening, thickness: ag.Scalar, slats: int, *, joined: bool = False) -> list[ag.Body]:
    """Make overlapping slats: each begins at the height of the end of the last, which blocks the view."""
    pitch = opening.height / slats
    depth = thickness - 0.010
    rise = 0.98 * pitch
    plank = 0.008  # half-round edges, with the same reach at every tilt
    out, up = depth - plank, rise - plank
    slat = ag.box(opening.width, ag.sqrt(out * out + up * up) + plank, plank, bevel=plank / 2.0)
    step = (opening.height - rise) / (slats - 1)
    places = [(0.0, 0.0, (at - (slats - 1) / 2) * step) for at in range(slats)]
    # the outer edge is the lower one, against rain and view
    tilted = slat.rotate(ag.X, ag.atan2(up, out))
    label, finish, center = opening.label, opening.finish, opening.centers[0]
    if joined:
        core = ag.box(opening.width, _CORE, opening.height).at(center)
        heavy = finish.with_(name=f"{finish.name}_slats", density=_SLATS * finish.density / _CORE)
        return [ag.part(core, label, heavy), ag.detail(ag.array(tilted, at=places).at(center), label, finish)]
    # neighbors belong to different boards
    boards = [ag.array(tilted, at=places[first::_BOARDS]).at(center) for first in range(_BOARDS)]
    return [ag.part(boards, label, finish)]


FrontStyle = Literal["flat", "beaded", "shaker", "ramped", "fielded", "glazed"]
"""A flat slab; a slab with a bead around it; a frame around a flat panel, plain or molded; a frame that
slopes down to the panel; a panel with a raised field; a frame around a pane."""


@dataclass(frozen=True)
class FrontLook:
    """Style and dimensions of fronts."""

    style: FrontStyle  # style of the front
    finish: ag.Material  # material of the front
    rail: ag.Scalar  # width of stiles and rails [m]
    moulding: Sticking  # molding at the edge of the frame around a shaker panel
    slope: ag.Scalar  # width of the slope of a ramped front [m]
    glass: ag.Material  # material of the pane of a glazed front
    panes: tuple[int, int] = (1, 1)  # numbers of panes side by side, and one above the other

    @property
    def framed(self) -> bool:
        """Whether handles are on a panel that lies behind rails and stiles."""
        return self.style in ("shaker", "ramped")

    def sunk(self, thickness: ag.Scalar) -> ag.Scalar:
        """Return the depth of the middle of a front behind its face, at the base of handles [m]."""
        return 0.375 * thickness if self.framed else 0.0


def front(
    look: FrontLook,
    width: ag.Scalar,
    height: ag.Scalar,
    thickness: ag.Scalar,
    *,
    label: str,
    name: str | None = None,
) -> list[ag.Body]:
    """Make a front in the x-z plane, with the origin in its middle."""
    if look.style in ("flat", "beaded"):
        slab = ag.part(ag.box(width, thickness, height, bevel=0.0014), label, look.finish, name=name)
        if look.style == "flat":
            return [slab]
        # a half-round bead around the face, with a height of 2 mm
        ring = ag.rectangle(width - 0.004, height - 0.004) - ag.rectangle(width - 0.018, height - 0.018)
        bead = ag.extrude(ring, 0.006, axis=ag.Y, bevel=0.0028).at(y=0.001 - thickness / 2)
        return [slab, ag.detail(bead, label, look.finish)]
    rail = look.rail
    narrow = ag.min_(rail, 0.27 * height)  # rails of a low drawer leave space for its panel
    stile = ag.box(rail, thickness, height, bevel=EASED)
    beam = ag.box(width - 2 * rail, thickness, narrow, bevel=EASED)
    boards = [stile.at(way * (width - rail) / 2) for way in (-1, 1)]
    boards += [beam.at(z=way * (height - narrow) / 2) for way in (-1, 1)]
    opening = Opening(width - 2 * rail, height - 2 * narrow, [(0.0, 0.0, 0.0)], 1, look.finish, label)
    match look.style:
        case "glazed":
            filling = panes_in(opening, thickness, *look.panes, look.glass)
        case "ramped":
            slope = ag.min_(look.slope, 0.3 * ag.min_(opening.width, opening.height))
            filling = panels_in(opening, thickness, "recessed", slope, "ramp")
        case "fielded":
            filling = panels_in(opening, thickness, "raised", 0.008, "ovolo")
        case _:
            filling = panels_in(opening, thickness, "recessed", 0.009, look.moulding)
    return [ag.part(boards, label, look.finish, name=name), *filling]
