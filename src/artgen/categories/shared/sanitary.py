"""Sanitary ware: its glazes, outlines of bowls, and a tiled wall that carries it."""

import functools
import math
import operator
from collections.abc import Iterable

import artgen as ag
from artgen import details

_CHINA = ag.material("ceramic").with_(name="china", base_color=(0.86, 0.86, 0.84), specular_roughness=0.08)
GLAZES = ag.choice(
    {
        _CHINA: 0.86,
        _CHINA.with_(name="china_cream", base_color=(0.83, 0.77, 0.65)): 0.08,
        _CHINA.with_(name="china_black", base_color=(0.03, 0.03, 0.03)): 0.06,
    }
)
"""Vitreous china, most of it white."""

TILE = ag.material("ceramic").with_(specular_roughness=0.25, density=700.0)
"""A wall with tiles, before it is given a color."""

TILES = ag.choice(
    *(
        TILE.with_(name=f"tile_{name}", base_color=color)
        for name, color in {
            "white": (0.78, 0.78, 0.76),
            "sand": (0.62, 0.55, 0.45),
            "slate": (0.20, 0.22, 0.24),
            "sage": (0.42, 0.50, 0.42),
            "sea": (0.25, 0.38, 0.45),
        }.items()
    )
)
"""Walls with tiles of one color."""

_GROUT = ag.material("ceramic").with_(name="grout", base_color=(0.52, 0.51, 0.49), specular_roughness=0.9)


def rounded(
    half: ag.Scalar, deep: ag.Scalar, power: float, angles: Iterable[float]
) -> list[tuple[ag.Scalar, ag.Scalar]]:
    """Return points about the origin, from the right to the front, of half a width and half a depth.

    The power of sine and cosine is 1 for an ellipse, and less for a squarer outline.
    """

    def bent(value: float) -> float:
        return math.copysign(abs(value) ** power, value)

    return [(half * bent(math.cos(a)), -deep * bent(math.sin(a))) for a in angles]


def tiled(
    wall: ag.Scalar,
    tile: ag.Scalar,
    tiles: ag.Material,
    *,
    half: float = 0.30,
    hole: ag.Profile | None = None,
) -> ag.Body:
    """Make a tiled wall with a ledge, with its front at y = `wall` [m].

    Its width is 2 * `half`, and that of a tile is `half` [m]; no grout is printed in the `hole`.
    """
    room = ag.Region((-half, half), (wall, wall + 0.13), (0, 1.14))
    ledge = room.with_(z=(1.14, 1.16)).grow(front=0.012).box(bevel=0.003)
    lines = [ag.rectangle(2 * half, 0.0025).at(0, 1.14 - tile * row) for row in range(1, 12)]
    for row in range(12):
        places = (-half / 2, half / 2) if row % 2 else (0.0,)
        lines += [ag.rectangle(0.0025, tile).at(x, 1.14 - tile * (row + 0.5)) for x in places]
    grid = functools.reduce(operator.or_, lines) & ag.rectangle(2 * half, 1.14).at(0, 0.57)
    grid = grid if hole is None else grid - hole
    joints = details.printed(grid, (0, wall, 0), material=_GROUT, label="tile")
    board = ag.part(ledge, "wall", ag.material("oak"))
    return ag.weld(ag.part(room.box(bevel=0.001), "wall", tiles), board, joints)
