"""Pieces of boxes that slide on each other: lids over trays, their straps, and sleeves of drawers."""

import math

import artgen as ag
from artgen import details
from artgen.categories.box.board import Board
from artgen.categories.box.bodies import walls

PLAY = 0.0012
"""Between what slides on each other, at either side [m]."""

_GRAVITY = 9.81  # [m/s2]


def lift(name: str, moved: ag.Body, *, travel: ag.Scalar, rub: ag.Scalar) -> ag.Joint:
    """Make the way of what is lifted off."""
    weight = _GRAVITY * moved.mass()
    return ag.Prismatic(
        name,
        axis=ag.Z,
        limits=(0.0, travel),
        friction=rub * weight,
        damping=4.0,  # air that is drawn in through the slit
        effort=4.0 * weight + 4.0,
        velocity=1.0,
    )


def cap(board: Board, width: ag.Scalar, depth: ag.Scalar, *, top: ag.Scalar, skirt: ag.Scalar) -> ag.Solid:
    """Make a tray upside down, as a lid."""
    return walls(board, width, depth, skirt).rotate(ag.X, math.pi).at(0.0, 0.0, top)


def strap(at: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Rivet a strap of webbing onto a lid, to lift it by: a flat arch along x."""
    outline = ag.polygon(
        [(-0.064, 0.0), (-0.049, 0.0), (-0.037, 0.020), (0.037, 0.020), (0.049, 0.0), (0.064, 0.0),
         (0.064, 0.0026), (0.0505, 0.0026), (0.0385, 0.0226),
         (-0.0385, 0.0226), (-0.0505, 0.0026), (-0.064, 0.0026)]
    )  # fmt: skip
    band = ag.extrude(outline, 0.022, axis=ag.Y).at(0.0, 0.0, at - 0.0002)
    hold = ag.grasp_on(band, approach=-ag.Z, closing=ag.Y, at=(0.0, 0.0, at + 0.021), depth=0.010)
    steel = ag.material("satin_nickel")
    rivets = [
        ag.detail(details.rivet(0.0045, (x, 0.0, at + 0.0022), facing=ag.Z), "handle", steel)
        for x in (-0.0572, 0.0572)
    ]
    return ag.weld(ag.part(band, "handle", finish, name="strap", grasp=hold), *rivets)


def drawer_case(board: Board, width: ag.Scalar, depth: ag.Scalar, height: ag.Scalar) -> ag.Solid:
    """Make a sleeve that is open at the front."""
    t = board.thick
    shell = ag.box_between(
        (-width / 2.0, -depth / 2.0 - 0.01, 0.0), (width / 2.0, depth / 2.0, height), bevel=0.0012
    ).paint(board.outside)
    ahead = ag.box_between((-width, -depth, -0.01), (width, -depth / 2.0, height + 0.01)).paint(board.outside)
    inside = ag.box_between((-width / 2.0 + t, -depth, t), (width / 2.0 - t, depth / 2.0 - t, height - t))
    return shell - ahead - inside.paint(board.outside)
