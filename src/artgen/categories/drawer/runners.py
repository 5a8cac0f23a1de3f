"""Runners of drawers: a member on the carcass and one on the drawer, at each side, 12.5 mm of side play.

Roller runners are folded steel, coated, and let a drawer come out three quarters: a nylon roller at the front
of the carcass's member, another at the rear of the drawer's. Ball runners are zinc-plated channels.
"""

from typing import Literal

import artgen as ag
from artgen.categories.shared.furniture.finish import CREAM_STEEL, ZINC
from artgen.categories.shared.hardware.fixings import screws

SIDE_PLAY = 0.0125
"""From the side of a drawer to the face beside it [m]."""

RunnerStyle = Literal["roller", "ball"]
"""Coated angles with rollers, or telescopes with balls."""

_MEMBER = 0.0052  # thickness of either member: 2.1 mm are left between them [m]

_HIGH: dict[RunnerStyle, float] = {"roller": 0.030, "ball": 0.042}


def steel_of(style: RunnerStyle) -> ag.Material:
    """Return the steel of runners."""
    return CREAM_STEEL if style == "roller" else ZINC


def fixed_member(
    style: RunnerStyle, *, face: ag.Scalar, z: ag.Scalar, front: ag.Scalar, length: ag.Scalar, solid: bool
) -> list[ag.Body]:
    """Make the member on the carcass, at the right of a drawer."""
    high, steel = _HIGH[style], steel_of(style)
    rail = ag.board(
        (face - _MEMBER, face + 0.0003), (front, front + length), (z - high / 2, z + high / 2), bevel=0.0008
    )
    # lips fold over the drawer's member
    lip = ag.board(
        (face - _MEMBER - 0.0018, face - _MEMBER + 0.0005),
        (front + 0.001, front + length - 0.001),
        (-0.0015, 0.0015),
    )
    edge = high / 2 - 0.0015
    at: list[ag.VectorLike] = [(0.0, 0.0, z + end * edge) for end in ((-1, 1) if style == "ball" else (-1,))]
    bodies = [_steel(rail, steel, solid=solid), ag.detail(ag.array(lip, at=at), "runner", steel)]
    if style == "roller":
        wheel = ag.cylinder(0.010, 0.0022, axis=ag.X, bevel=0.0006)
        bodies.append(
            ag.detail(wheel.at(face - _MEMBER - 0.0006, front + 0.014, z), "runner", ag.material("abs"))
        )
    return bodies


def moving_member(
    style: RunnerStyle, *, side: ag.Scalar, z: ag.Scalar, front: ag.Scalar, length: ag.Scalar, solid: bool
) -> list[ag.Body]:
    """Make the member on the right side of a drawer."""
    high, steel = _HIGH[style] - 0.010, steel_of(style)
    rail = ag.board(
        (side - 0.0003, side + _MEMBER), (front, front + length), (z - high / 2, z + high / 2), bevel=0.0008
    )
    heads = [(side + _MEMBER, front + share * length, z) for share in (0.12, 0.5, 0.88)]
    return [
        _steel(rail, steel, solid=solid),
        *screws(heads, facing="+x", radius=0.0032, finish=steel, sunk=0.0008),
    ]


def _steel(rail: ag.Solid, steel: ag.Material, *, solid: bool) -> ag.Body:
    return ag.part(rail, "runner", steel) if solid else ag.detail(rail, "runner", steel)
