"""Mounts of faucets: on a deck with two valves, with a bridge, on one column, or in front of a wall.

A stand gives the position of the spout's axis, and those of the valves of two handles.
"""

import math
from dataclasses import dataclass, field
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.faucet.drain import FLANGE, HANGS, HOLE
from artgen.categories.faucet.handles import LeverStyle, mixer
from artgen.categories.faucet.spouts import core_radius
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import corner_feet

PADS = 0.004
"""Height of the rubber pads under a deck or a foot [m]."""

BAR = 0.0125
"""Radius of the bar between two valves [m]."""

BEHIND = 0.062
"""Distance from a wall to the bar in front of it [m]."""

# density of solid metal, and of 1.5 mm of sheet folded around a board [kg/m^3]
_SOLID, _FOLDED = 5000.0, 1500.0
_ROSE = 0.030  # radius of the flanges on a wall [m]


def deck(*, width: ag.Scalar, depth: ag.Scalar, thick: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a sample deck on pads, with its upper face at `PADS + thick`."""
    slab = ag.box(width, depth, thick, bevel=0.003).at(0.0, 0.0, PADS + thick / 2)
    pads = corner_feet(width, depth, inset=0.016, radius=0.008, height=PADS)
    return ag.weld(ag.part(slab, "deck", _slab(finish)), pads)


def _slab(finish: ag.Material) -> ag.Material:
    """Return the material of a slab with the weight of the whole deck."""
    if finish.density < _SOLID:
        return finish
    return finish.with_(name=f"{finish.name}_on_board", density=_FOLDED)


def raised_deck(
    *,
    width: ag.Scalar,
    front: ag.Scalar,
    back: ag.Scalar,
    top: ag.Scalar,
    thick: ag.Scalar,
    finish: ag.Material,
    drain_at: ag.Scalar,
    rod_at: ag.Scalar,
) -> ag.Body:
    """Make a piece of a vanity top with the holes of a drain and its rod, on two frames of flat steel."""
    slab = ag.Region((-width / 2, width / 2), (front, back), (top - thick, top)).box(bevel=0.003)
    holes = ag.union(
        ag.box(HOLE, HOLE, 2.0).at(0.0, drain_at, 0.0), ag.box(0.008, 0.008, 2.0).at(0.0, rod_at, 0.0)
    )
    x, bar = width / 2 - 0.030, 0.006  # flat bars of 25 x 6 mm
    wide = (-x - 0.0125, -x + 0.0125)
    near, far, high = front + 0.020, back - 0.020, top - thick + 0.0003
    rails = [ag.Region(wide, (near, far), (low, low + bar)).box(bevel=0.001) for low in (PADS, high - bar)]
    posts = [
        ag.Region(
            (wide[0] + 0.0002, wide[1] - 0.0002), (y, y + bar), (PADS + bar - 0.0003, high - bar + 0.0003)
        ).box()
        for y in (near + 0.0003, far - bar - 0.0003)
    ]
    frame = ag.union(*rails, *posts)
    steel = ag.material("powder_coat_black")
    pads = corner_feet(2.0 * x + 0.025, far - near, inset=0.012, radius=0.008, height=PADS)
    return ag.weld(
        ag.part(slab - holes, "deck", _slab(finish)),
        ag.part(frame, "deck", steel),
        ag.part(frame.mirror(ag.X), "deck", steel),
        pads.at(0.0, 0.5 * (near + far), 0.0),
    )


def wall_board(
    *, width: ag.Scalar, height: ag.Scalar, thick: ag.Scalar, finish: ag.Material, metal: ag.Material
) -> ag.Body:
    """Make a wall board, with its face on y = 0, on a steel foot in front of it."""
    panel = ag.Region.between((-0.5 * width, 0.0, PADS + 0.004), (0.5 * width, thick, height)).box(
        bevel=0.003
    )
    foot = ag.Region.between((-0.42 * width, -0.19, PADS), (0.42 * width, thick + 0.03, PADS + 0.008)).box(
        bevel=0.002
    )
    pads = corner_feet(0.84 * width, 0.22 + thick, inset=0.016, radius=0.008, height=PADS)
    steel = metal.with_(name="foot_steel", density=5000.0)
    screws = [
        details.screw(0.005, (side * 0.45 * width, 0.0, height - 0.03), material=ag.material("stainless"))
        for side in (-1, 1)
    ]
    middle = 0.5 * (thick + 0.03 - 0.19)
    return ag.weld(
        ag.part(panel, "deck", finish), ag.part(foot, "deck", steel), pads.at(0.0, middle, 0.0), *screws
    )


def column(*, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a round column with its flange, from z = 0 up."""
    metal = casting(finish, 0.3)
    shaft = ag.cylinder(radius, height + 0.0004, bevel=0.0006).align((0.0, 0.0, height), z=1)
    flange = ag.frustum(radius + 0.0065, radius + 0.0045, 0.0065, bevel=0.0015).align(
        (0.0, 0.0, -0.0004), z=-1
    )
    return ag.weld(ag.part(flange, "escutcheon", metal), ag.part(shaft, "body", metal))


def pedestal(*, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the foot of a spout between two handles: a flange and a short column, from z = 0 up."""
    metal = casting(finish, 0.45)
    shaft = ag.frustum(radius + 0.0085, radius + 0.0065, height, bevel=0.0008).align((0.0, 0.0, height), z=1)
    flange = ag.frustum(radius + 0.0165, radius + 0.0135, 0.008, bevel=0.0015).align(
        (0.0, 0.0, -0.0004), z=-1
    )
    return ag.weld(ag.part(flange, "escutcheon", metal), ag.part(shaft, "body", metal))


def bar(*, half: ag.Scalar, finish: ag.Material, below: bool = False) -> ag.Body:
    """Make the bar between two valves, along x at the origin, with the boss of the spout in its middle.

    The axes of the valves are at `half` to each side; the boss rises 22 mm, and the sockets of valves 15 mm.
    """
    metal = casting(finish, 0.35)
    long = ag.cylinder(BAR, 2.0 * half, axis=ag.X)
    boss = ag.cylinder(0.0205, 0.039, bevel=0.001).align(
        (0.0, 0.0, -0.022 if below else 0.022), z=-1 if below else 1
    )
    socket = ag.cylinder(0.0185, 0.034, bevel=0.0012)
    sockets = ag.array(socket.at(0.0, 0.0, -0.002), at=[(-half, 0.0, 0.0), (half, 0.0, 0.0)])
    rings: list[ag.Body] = []
    for side in (-1, 1):
        for near in (0.026, half - 0.024):
            ring = ag.torus(BAR + 0.0004, 0.0019, axis=ag.X).at(side * near, 0.0, 0.0)
            rings.append(ag.detail(ring, "body", finish))
    return ag.weld(ag.part(ag.union(long, boss, sockets), "body", metal), *rings)


def risers(*, half: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the two columns that carry a bar above a deck at z = 0."""
    metal = casting(finish, 0.35)
    shaft = ag.cylinder(0.0125, height).at(0.0, 0.0, 0.5 * height)
    flange = ag.frustum(0.0265, 0.0235, 0.009, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
    nut = ag.cylinder(0.0165, 0.012, bevel=0.0015).at(0.0, 0.0, 0.016)
    at: list[ag.VectorLike] = [(-half, 0.0, 0.0), (half, 0.0, 0.0)]
    both = ag.array(ag.union(shaft, nut, flange), at=at)
    return ag.part(both, "body", metal, separate="the bar joins them")


def elbows(*, half: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the two arms that carry a bar in front of a wall at y = 0: the bar is at y = -62 mm, z = 0."""
    metal = casting(finish, 0.35)
    arm = ag.cylinder_between((0.0, 0.0005, 0.0), (0.0, -BEHIND, 0.0), 0.0125)
    rose = ag.frustum(_ROSE, _ROSE - 0.005, 0.011, axis=-ag.Y, bevel=0.0018).at(0.0, -0.0053, 0.0)
    nut = ag.cylinder_between((0.0, -0.014, 0.0), (0.0, -0.026, 0.0), 0.0165, bevel=0.0015)
    both = ag.array(ag.union(arm, rose, nut), at=[(-half, 0.0, 0.0), (half, 0.0, 0.0)])
    return ag.part(both, "body", metal, separate="the bar joins them")


ROD_AT = 0.053
"""Distance of the rod of a drain behind the axis of the spout [m]."""

_HALF = 0.1016  # half the distance between two valves, 8 inches [m]
_FLANGE = 0.0265  # radius of the flange of a valve [m]
_PEDESTAL = 0.018  # height of the foot of a spout between two valves [m]
_RISERS = 0.050  # height of the bar of a bridge above the deck [m]
_RAISED = 0.022  # height of the boss of a spout above the axis of a bar [m]
_SOCKET = 0.015  # height of the socket of a valve above the axis of a bar [m]
_COLUMN = 0.125  # height of the column under a tall spout [m]
_LEVER = 0.068  # height of the mixer at the side of a column [m]
_SIDE = 0.0185  # radius of that mixer [m]
_RISE = 0.22  # angle of a closed lever above the plane of its collar [rad]


@dataclass(frozen=True)
class Board:
    """Display board of a faucet."""

    margin: ag.Scalar  # margin around the parts on the board [m]
    thick: ag.Scalar  # thickness of the board [m]
    finish: ag.Material  # material of the board
    drain: ag.Scalar | None  # distance of a drain in front of the spout's axis; None for a plain deck [m]

    @property
    def top(self) -> ag.Scalar:
        """Height of the upper face of a deck [m]."""
        return PADS + (self.thick if self.drain is None else HANGS + 0.012)

    def body(self, half: ag.Scalar, deep: ag.Scalar) -> ag.Body:
        """Make a deck around parts of a half width and a half depth [m]."""
        width = 2.0 * (half + self.margin)
        if self.drain is None:
            return deck(width=width, depth=2.0 * (deep + self.margin), thick=self.thick, finish=self.finish)
        return raised_deck(
            width=width,
            front=-self.drain - FLANGE - 0.6 * self.margin,
            back=ROD_AT + 0.6 * self.margin,
            top=self.top,
            thick=self.thick,
            finish=self.finish,
            drain_at=-self.drain,
            rod_at=ROD_AT,
        )


@dataclass(frozen=True)
class Stand:
    """Fixed parts of a faucet."""

    body: ag.Body  # board with the fixed parts on it
    foot: ag.Vector  # foot of the spout, on its axis
    over: ag.Scalar  # height of the foot above the deck, or above the bar in front of a wall [m]
    valves: list[ag.Vector] = field(
        default_factory=list
    )  # positions of the valves of two handles: hot and cold
    least: float = 0.0  # least height of the end of the spout above its foot, to clear the handles [m]
    flanges: bool = False  # whether the valves cover holes of their own


@dataclass(frozen=True)
class Lever:
    """The lever of a mixer."""

    style: LeverStyle  # shape of the lever
    length: ag.Scalar  # length from the axis to the tip [m]
    lift: ag.Scalar  # angle of the lifted lever [rad]
    friction: ag.Scalar  # friction of the cartridge [N m]
    side: Literal["left", "right"]  # side of the lever on a column

    def mixer(self, radius: ag.Scalar, finish: ag.Material) -> ag.Body:
        """Make the mixer about the z axis, in a collar of some radius [m]."""
        return mixer(
            self.style,
            radius=radius,
            length=self.length,
            rise=_RISE,
            finish=finish,
            lift=self.lift,
            friction=self.friction,
        )


def widespread(board: Board, *, girth: ag.Scalar, finish: ag.Material) -> Stand:
    """Make a deck with a pedestal for a spout, and positions of valves at its sides."""
    foot = pedestal(radius=girth, height=_PEDESTAL, finish=finish).at(0.0, 0.0, board.top)
    return Stand(
        ag.weld(board.body(_HALF + _FLANGE, _FLANGE), foot),
        ag.vector(0.0, 0.0, board.top + _PEDESTAL),
        _PEDESTAL,
        [ag.vector(side * _HALF, 0.0, board.top) for side in (-1, 1)],
        least=0.078,
        flanges=True,
    )


def bridge(board: Board, *, finish: ag.Material) -> Stand:
    """Make a deck with two risers and the bar between them."""
    level = board.top + _RISERS
    body = ag.weld(
        board.body(_HALF + _FLANGE, _FLANGE),
        risers(half=_HALF, height=_RISERS, finish=finish).at(0.0, 0.0, board.top),
        bar(half=_HALF, finish=finish).at(0.0, 0.0, level),
    )
    valves = [ag.vector(side * _HALF, 0.0, level + _SOCKET) for side in (-1, 1)]
    return Stand(body, ag.vector(0.0, 0.0, level + _RAISED), _RISERS + _RAISED, valves, least=0.092)


def before_wall(board: Board, *, finish: ag.Material, hangs: bool) -> Stand:
    """Make a wall board with a bar in front of it.

    The board ends clear of a hand that turns the handles.
    """
    level = 0.20 if hangs else 0.15
    body = ag.weld(
        wall_board(
            width=2.0 * (_HALF + 0.05 + board.margin),
            height=level + 0.025 + board.margin,
            thick=board.thick,
            finish=board.finish,
            metal=ag.material("steel"),
        ),
        elbows(half=_HALF, finish=finish).at(0.0, 0.0, level),
        bar(half=_HALF, finish=finish, below=hangs).at(0.0, -BEHIND, level),
    )
    valves = [ag.vector(side * _HALF, -BEHIND, level + _SOCKET) for side in (-1, 1)]
    raised = -_RAISED if hangs else _RAISED
    return Stand(body, ag.vector(0.0, -BEHIND, level + raised), raised, valves, least=0.092)


def topped_column(
    board: Board, *, radius: ag.Scalar, height: ag.Scalar, ring: ag.Scalar, lever: Lever, finish: ag.Material
) -> Stand:
    """Make a column with a core for the ring of a straight spout, and the mixer on top of it."""
    foot = ag.vector(0.0, 0.0, board.top + height)
    core = ag.cylinder(core_radius(radius), ring + 0.001).align(foot - ag.Z * 0.001, z=-1)
    body = ag.weld(
        board.body(radius + 0.030, radius + 0.025),
        column(radius=radius, height=height, finish=finish).at(0.0, 0.0, board.top),
        ag.part(core, "body", casting(finish, 0.35)),
        lever.mixer(radius, finish).at(foot + ag.Z * ring),
    )
    return Stand(body, foot, 1.0 * height)


def sided_column(board: Board, *, radius: ag.Scalar, lever: Lever, finish: ag.Material) -> Stand:
    """Make a column for a tall spout with a mixer at its side, its lever upright."""
    out = radius + 0.012
    boss = ag.cylinder_between((0.5 * radius, 0.0, 0.0), (out, 0.0, 0.0), _SIDE, bevel=0.0006)
    lying = lever.mixer(_SIDE, finish).rotate(ag.Y, 0.5 * math.pi).rotate(ag.X, -0.5 * math.pi)
    unit = ag.weld(ag.part(boss, "body", casting(finish, 0.35)), lying.at(out, 0.0, 0.0))
    unit = unit if lever.side == "right" else unit.mirror(ag.X)
    body = ag.weld(
        board.body(radius + 0.030, radius + 0.025),
        column(radius=radius, height=_COLUMN, finish=finish).at(0.0, 0.0, board.top),
        unit.at(0.0, 0.0, board.top + _LEVER),
    )
    return Stand(body, ag.vector(0.0, 0.0, board.top + _COLUMN), _COLUMN)
