"""Mounts of faucets: on a deck with two valves, with a bridge, on one column, or in front of a wall.

A stand gives the position of the spout's axis, and those of the valves of two handles.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import corner_feet
from artgen.categories.shared.taps import drain
from artgen.categories.shared.taps.spouts import CORE

ROD_AT = 0.053
"""Distance of the rod of a drain behind the axis of the spout [m]."""

SIDE = 0.0185
"""Radius of a mixer at the side of a column [m]."""

_PADS = 0.004  # height of the rubber pads under a deck or a foot [m]
# density of solid metal, and of 1.5 mm of sheet folded around a board [kg/m^3]
_SOLID, _FOLDED = 5000.0, 1500.0
_HALF = 0.1016  # half the distance between two valves, 8 inches [m]
_BOTH: list[ag.VectorLike] = [(-_HALF, 0.0, 0.0), (_HALF, 0.0, 0.0)]
_FLANGE = 0.0265  # radius of the flange of a valve [m]
_PEDESTAL = 0.018  # height of the foot of a spout between two valves [m]
_RISERS = 0.050  # height of the bar of a bridge above the deck [m]
_BAR = 0.0125  # radius of the bar between two valves, and of the arms that carry it [m]
_BEHIND = 0.062  # distance from a wall to the bar in front of it [m]
_RAISED = 0.022  # height of the boss of a spout above the axis of a bar [m]
_SOCKET = 0.015  # height of the socket of a valve above the axis of a bar [m]
_COLUMN = 0.125  # height of the column under a tall spout [m]
_LEVER = 0.068  # height of the mixer at the side of a column [m]


@dataclass(frozen=True)
class Stand:
    """Fixed parts of a faucet."""

    body: ag.Body  # board with the fixed parts on it
    foot: ag.Vector  # foot of the spout, on its axis
    over: ag.Scalar  # height of the foot above the deck, or above the bar in front of a wall [m]
    valves: tuple[ag.Vector, ...] = ()  # positions of the valves for hot and cold
    least: float = 0.0  # least height of the end of the spout above its foot, to clear the handles [m]
    flanges: bool = False  # whether the valves cover holes of their own


@dataclass(frozen=True)
class Board:
    """Display board of a faucet."""

    margin: ag.Scalar  # margin around the parts on the board [m]
    thick: ag.Scalar  # thickness of the board [m]
    finish: ag.Material
    drain: ag.Scalar | None  # distance of a drain in front of the spout's axis; None for a plain deck [m]

    @property
    def top(self) -> ag.Scalar:
        """Height of the upper face of a deck [m]."""
        return _PADS + (self.thick if self.drain is None else drain.HANGS + 0.012)

    def deck(self, half: ag.Scalar, deep: ag.Scalar) -> ag.Body:
        """Make a deck on pads around parts of a half width and a half depth [m]."""
        wide, solid = half + self.margin, self.finish
        if solid.density >= _SOLID:  # the material has the weight of the whole deck
            solid = solid.with_(name=f"{solid.name}_on_board", density=_FOLDED)
        slab = ag.Region((-wide, wide), (-deep - self.margin, deep + self.margin), (_PADS, self.top))
        if self.drain is None:
            pads = corner_feet(slab.x.size, slab.y.size, inset=0.016, radius=0.008, height=_PADS)
            return ag.weld(ag.part(slab.box(bevel=0.003), "deck", solid), pads)
        # a piece of a vanity top with the holes of a drain and its rod, on two frames of flat steel
        ends = (-self.drain - drain.FLANGE - 0.6 * self.margin, ROD_AT + 0.6 * self.margin)
        slab = slab.with_(y=ends, z=(self.top - self.thick, self.top))
        hole, bore = ag.box(drain.HOLE, drain.HOLE, 2.0), ag.box(0.008, 0.008, 2.0)
        holes = hole.at(0.0, -self.drain) | bore.at(0.0, ROD_AT)
        x, bar = wide - 0.030, 0.006  # flat bars of 25 x 6 mm
        side = ag.Region((-x - 0.0125, -x + 0.0125), slab.y, (_PADS, slab.z.low + 0.0003)).shrink(y=0.020)
        inner = side.shrink(x=0.0002, y=0.0003, z=bar - 0.0003)
        rails = [rail.box(bevel=0.001) for rail in side.stack(bar, None, bar)[::2]]
        frame = ag.union(*rails, *(post.box() for post in inner.deep(bar, None, bar)[::2]))
        pads = corner_feet(2 * x + 0.025, side.y.size, inset=0.012, radius=0.008, height=_PADS)
        return ag.weld(
            ag.part(slab.box(bevel=0.003) - holes, "deck", solid),
            ag.part([frame, frame.mirror(ag.X)], "deck", ag.material("powder_coat_black")),
            pads.at(0.0, side.y.mid),
        )

    def wall(self, height: ag.Scalar) -> ag.Body:
        """Make a wall board, with its face on y = 0, on a steel foot; hands at handles clear its ends."""
        half, thick = _HALF + 0.05 + self.margin, self.thick
        panel = ag.Region((-half, half), (0.0, thick), (_PADS + 0.004, height))
        foot = ag.Region((-0.84 * half, 0.84 * half), (-0.19, thick + 0.03), (_PADS, _PADS + 0.008))
        steel = ag.material("steel").with_(name="foot_steel", density=_SOLID)
        pads = corner_feet(foot.x.size, foot.y.size, inset=0.016, radius=0.008, height=_PADS)
        bright, at = ag.material("stainless"), [(x, 0.0, height - 0.03) for x in (-0.9 * half, 0.9 * half)]
        return ag.weld(
            ag.part(panel.box(bevel=0.003), "deck", self.finish),
            ag.part(foot.box(bevel=0.002), "deck", steel),
            pads.at(0.0, foot.y.mid),
            *(details.screw(0.005, place, material=bright) for place in at),
        )


@dataclass(frozen=True)
class Ledge:
    """A flat place of a body, which carries a faucet about the origin of x and y instead of a board."""

    body: ag.Body
    top: ag.Scalar  # height of the place [m]

    def deck(self, half: ag.Scalar, deep: ag.Scalar) -> ag.Body:
        """Return the body; it has room for parts of any half width and half depth."""
        return self.body


def post(
    shaft: ag.Solid, flange: tuple[ag.Scalar, ag.Scalar, float], metal: ag.Material, label: str = "body"
) -> ag.Body:
    """Make a post on z = 0 with a flange of a radius below, a radius above and a height."""
    low, high, tall = flange
    plate = ag.frustum(low, high, tall, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
    return ag.weld(ag.part(plate, "escutcheon", metal), ag.part(shaft, label, metal))


def _column(radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a round column with its flange, from z = 0 up."""
    shaft = ag.cylinder(radius, height + 0.0004, bevel=0.0006).align((0.0, 0.0, height), z=1)
    return post(shaft, (radius + 0.0065, radius + 0.0045, 0.0065), casting(finish, 0.3))


def _bar(finish: ag.Material, *, below: bool = False) -> ag.Body:
    """Make the bar between two valves, along x at the origin, with sockets and the boss of a spout."""
    end = -1 if below else 1
    boss = ag.cylinder(0.0205, 0.039, bevel=0.001).align((0.0, 0.0, end * _RAISED), z=end)
    sockets = ag.array(ag.cylinder(0.0185, 0.034, bevel=0.0012).at(z=-0.002), at=_BOTH)
    bar = ag.union(ag.cylinder(_BAR, 2 * _HALF, axis=ag.X), boss, sockets)
    ring = ag.torus(_BAR + 0.0004, 0.0019, axis=ag.X)
    rings = [ring.at(side * near) for side in (-1, 1) for near in (0.026, _HALF - 0.024)]
    return ag.weld(ag.part(bar, "body", casting(finish, 0.35)), ag.detail(rings, "body", finish))


def _valves(y: float, z: ag.Scalar) -> tuple[ag.Vector, ag.Vector]:
    """Return the positions of the valves for hot and cold."""
    return (ag.vector(-_HALF, y, z), ag.vector(_HALF, y, z))


def _arms(arm: ag.Solid, finish: ag.Material) -> ag.Body:
    """Make the two arms or columns that carry a bar."""
    metal, arms = casting(finish, 0.35), ag.array(arm, at=_BOTH)
    return ag.part(arms, "body", metal, name="deck", separate="the bar joins them")


def widespread(board: Board | Ledge, girth: ag.Scalar, finish: ag.Material) -> Stand:
    """Make a deck with a pedestal for a spout, and positions of valves at its sides."""
    shaft = ag.frustum(girth + 0.0085, girth + 0.0065, _PEDESTAL, bevel=0.0008)
    shaft = shaft.align((0.0, 0.0, _PEDESTAL), z=1)
    foot = post(shaft, (girth + 0.0165, girth + 0.0135, 0.008), casting(finish, 0.45)).at(z=board.top)
    body = ag.weld(board.deck(_HALF + _FLANGE, _FLANGE), foot)
    top = ag.vector(0.0, 0.0, board.top + _PEDESTAL)
    return Stand(body, top, _PEDESTAL, _valves(0.0, board.top), least=0.078, flanges=True)


def bridge(board: Board, finish: ag.Material) -> Stand:
    """Make a deck with two risers and the bar between them."""
    level = board.top + _RISERS
    shaft = ag.cylinder(_BAR, _RISERS).at(z=_RISERS / 2)
    flange = ag.frustum(_FLANGE, _FLANGE - 0.003, 0.009, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
    nut = ag.cylinder(0.0165, 0.012, bevel=0.0015).at(z=0.016)
    risers = _arms(ag.union(shaft, nut, flange), finish).at(z=board.top)
    body = ag.weld(board.deck(_HALF + _FLANGE, _FLANGE), risers, _bar(finish).at(z=level))
    foot, valves = ag.vector(0.0, 0.0, level + _RAISED), _valves(0.0, level + _SOCKET)
    return Stand(body, foot, _RISERS + _RAISED, valves, least=0.092)


def before_wall(board: Board | None, finish: ag.Material, *, hangs: bool) -> Stand:
    """Make a bar in front of a board, or of the wall of a room, from which a spout rises or hangs."""
    level, raised = (0.20, -_RAISED) if hangs else (0.15, _RAISED)
    arm = ag.cylinder_between((0.0, 0.0005, 0.0), (0.0, -_BEHIND, 0.0), _BAR)
    rose = ag.frustum(0.030, 0.025, 0.011, axis=-ag.Y, bevel=0.0018).at(0.0, -0.0053)
    nut = ag.cylinder_between((0.0, -0.014, 0.0), (0.0, -0.026, 0.0), 0.0165, bevel=0.0015)
    elbows, bar = _arms(ag.union(arm, rose, nut), finish), _bar(finish, below=hangs)
    body = ag.weld(elbows.at(z=level), bar.at(0.0, -_BEHIND, level))
    if board is not None:
        body = ag.weld(board.wall(level + 0.025 + board.margin), body)
    foot, valves = ag.vector(0.0, -_BEHIND, level + raised), _valves(-_BEHIND, level + _SOCKET)
    return Stand(body, foot, raised, valves, least=0.092)


def topped_column(
    board: Board | Ledge,
    radius: ag.Scalar,
    height: ag.Scalar,
    ring: ag.Scalar,
    mixer: ag.Body,
    finish: ag.Material,
) -> Stand:
    """Make a column with a core for the ring of a straight spout, and the mixer on top of it."""
    foot = ag.vector(0.0, 0.0, board.top + height)
    core = ag.cylinder(CORE * radius, ring + 0.001).align(foot - ag.Z * 0.001, z=-1)
    body = ag.weld(
        board.deck(radius + 0.030, radius + 0.025),
        _column(radius, height, finish).at(z=board.top),
        ag.part(core, "body", casting(finish, 0.35)),
        mixer.at(foot + ag.Z * ring),
    )
    return Stand(body, foot, height)


def sided_column(
    board: Board | Ledge,
    radius: ag.Scalar,
    mixer: ag.Body,
    side: Literal["left", "right"],
    finish: ag.Material,
) -> Stand:
    """Make a column for a tall spout with a mixer at its side, its lever upright."""
    out = radius + 0.012
    boss = ag.cylinder_between((0.5 * radius, 0.0, 0.0), (out, 0.0, 0.0), SIDE, bevel=0.0006)
    lying = mixer.rotate(ag.Y, math.pi / 2).rotate(ag.X, -math.pi / 2).at(out)
    unit = ag.weld(ag.part(boss, "body", casting(finish, 0.35)), lying)
    unit = unit if side == "right" else unit.mirror(ag.X)
    column = _column(radius, _COLUMN, finish).at(z=board.top)
    body = ag.weld(board.deck(radius + 0.030, radius + 0.025), column, unit.at(z=board.top + _LEVER))
    return Stand(body, ag.vector(0.0, 0.0, board.top + _COLUMN), _COLUMN)
