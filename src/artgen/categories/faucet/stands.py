"""How faucets are fixed: on a deck with two valves, with a bridge, on one column; or before a wall.

A stand gives where the spout turns, and where the valves of two handles are.
"""

import math
from dataclasses import dataclass, field
from typing import Literal

from artgen import (
    Body,
    Material,
    Scalar,
    Vector,
    X,
    Y,
    Z,
    cylinder,
    cylinder_between,
    material,
    part,
    vector,
    weld,
)
from artgen.categories.faucet.drain import FLANGE, HANGS
from artgen.categories.faucet.handles import LeverStyle, mixer
from artgen.categories.faucet.mounts import (
    BEHIND,
    PADS,
    bar,
    column,
    deck,
    elbows,
    pedestal,
    raised_deck,
    risers,
    wall_board,
)
from artgen.categories.faucet.spouts import core_radius
from artgen.categories.shared.finish import casting

ROD_AT = 0.053
"""The rod of a drain behind the axis of the spout [m]."""

_HALF = 0.1016  # half the distance of two valves: 8 inches [m]
_FLANGE = 0.0265  # radius of the flange of a valve [m]
_PEDESTAL = 0.018  # height of the foot of a spout between two valves [m]
_RISERS = 0.050  # height of the bar of a bridge over the deck [m]
_RAISED = 0.022  # the boss of a spout over the axis of a bar [m]
_SOCKET = 0.015  # the socket of a valve over it [m]
_COLUMN = 0.125  # height of the column under a tall spout [m]
_LEVER = 0.068  # height of the mixer at its side [m]
_SIDE = 0.0185  # radius of that mixer [m]
_RISE = 0.22  # of a lever over the plane of its collar while it is closed [rad]


@dataclass(frozen=True)
class Board:
    """What a faucet is shown on."""

    margin: Scalar  # around what stands on it [m]
    thick: Scalar  # its thickness [m]
    finish: Material  # its material
    drain: Scalar | None  # how far before the spout's axis its drain is [m]; none where it is a plain deck

    @property
    def top(self) -> Scalar:
        """Height of its upper face, where it is a deck [m]."""
        return PADS + (self.thick if self.drain is None else HANGS + 0.012)

    def body(self, half: Scalar, deep: Scalar) -> Body:
        """Make a deck around what takes up half a width and half a depth [m]."""
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
    """What stands still."""

    body: Body  # the board with what is fixed to it
    foot: Vector  # where the spout turns, on its axis
    over: Scalar  # height of that over the deck, or over the bar before a wall [m]
    valves: list[Vector] = field(default_factory=list)  # where the valves of two handles stand: hot and cold
    least: float = 0.0  # how high the end of the spout is over its foot, to pass the handles [m]
    flanges: bool = False  # whether the valves cover holes of their own


@dataclass(frozen=True)
class Lever:
    """The lever of a mixer."""

    style: LeverStyle  # its form
    length: Scalar  # from its axis to its tip [m]
    lift: Scalar  # how far it is lifted [rad]
    friction: Scalar  # of the cartridge [N m]
    side: Literal["left", "right"]  # at which side of a column it is

    def mixer(self, radius: Scalar, finish: Material) -> Body:
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


def widespread(board: Board, *, girth: Scalar, finish: Material) -> Stand:
    """Make a deck with a pedestal for a spout, and places for valves at its sides."""
    foot = pedestal(radius=girth, height=_PEDESTAL, finish=finish).at(0.0, 0.0, board.top)
    return Stand(
        weld(board.body(_HALF + _FLANGE, _FLANGE), foot),
        vector(0.0, 0.0, board.top + _PEDESTAL),
        _PEDESTAL,
        [vector(side * _HALF, 0.0, board.top) for side in (-1, 1)],
        least=0.078,
        flanges=True,
    )


def bridge(board: Board, *, finish: Material) -> Stand:
    """Make a deck with two risers and the bar between them."""
    level = board.top + _RISERS
    body = weld(
        board.body(_HALF + _FLANGE, _FLANGE),
        risers(half=_HALF, height=_RISERS, finish=finish).at(0.0, 0.0, board.top),
        bar(half=_HALF, finish=finish).at(0.0, 0.0, level),
    )
    valves = [vector(side * _HALF, 0.0, level + _SOCKET) for side in (-1, 1)]
    return Stand(body, vector(0.0, 0.0, level + _RAISED), _RISERS + _RAISED, valves, least=0.092)


def before_wall(board: Board, *, finish: Material, hangs: bool) -> Stand:
    """Make a board that stands for a wall, with a bar before it.

    It ends where a hand that turns the handles would strike it.
    """
    level = 0.20 if hangs else 0.15
    body = weld(
        wall_board(
            width=2.0 * (_HALF + 0.05 + board.margin),
            height=level + 0.025 + board.margin,
            thick=board.thick,
            finish=board.finish,
            metal=material("steel"),
        ),
        elbows(half=_HALF, finish=finish).at(0.0, 0.0, level),
        bar(half=_HALF, finish=finish, below=hangs).at(0.0, -BEHIND, level),
    )
    valves = [vector(side * _HALF, -BEHIND, level + _SOCKET) for side in (-1, 1)]
    raised = -_RAISED if hangs else _RAISED
    return Stand(body, vector(0.0, -BEHIND, level + raised), raised, valves, least=0.092)


def topped_column(
    board: Board, *, radius: Scalar, height: Scalar, ring: Scalar, lever: Lever, finish: Material
) -> Stand:
    """Make a column with a core for the ring of a straight spout, and the mixer on top of it."""
    foot = vector(0.0, 0.0, board.top + height)
    core = cylinder(core_radius(radius), ring + 0.001).align(foot - Z * 0.001, z=-1)
    body = weld(
        board.body(radius + 0.030, radius + 0.025),
        column(radius=radius, height=height, finish=finish).at(0.0, 0.0, board.top),
        part(core, "body", casting(finish, 0.35)),
        lever.mixer(radius, finish).at(foot + Z * ring),
    )
    return Stand(body, foot, 1.0 * height)


def sided_column(board: Board, *, radius: Scalar, lever: Lever, finish: Material) -> Stand:
    """Make a column for a tall spout with the mixer lying at its side, its lever upright."""
    out = radius + 0.012
    boss = cylinder_between((0.5 * radius, 0.0, 0.0), (out, 0.0, 0.0), _SIDE, bevel=0.0006)
    lying = lever.mixer(_SIDE, finish).rotate(Y, 0.5 * math.pi).rotate(X, -0.5 * math.pi)
    unit = weld(part(boss, "body", casting(finish, 0.35)), lying.at(out, 0.0, 0.0))
    unit = unit if lever.side == "right" else unit.mirror(X)
    body = weld(
        board.body(radius + 0.030, radius + 0.025),
        column(radius=radius, height=_COLUMN, finish=finish).at(0.0, 0.0, board.top),
        unit.at(0.0, 0.0, board.top + _LEVER),
    )
    return Stand(body, vector(0.0, 0.0, board.top + _COLUMN), _COLUMN)
