"""Bodies without joints that rooms have beside their assets: worktops, sinks, hoods, housings, sockets.

All are made in the coordinates of a wall: x along it, from its left end, y into it; the front is at -y.
"""

import artgen as ag
from artgen.materials import Material

Hole = tuple[float, float, float, float]
"""Sides of a hole in plan: lowest and highest x, lowest and highest y [m]."""

_STEEL, _WHITE = ag.material("stainless"), ag.material("abs")
_CERAMIC = ag.material("ceramic")


def worktop(
    outline: list[tuple[float, float]], low: float, high: float, finish: Material, holes: list[Hole]
) -> ag.Body:
    """Make a worktop of a convex outline between two heights, with holes."""
    slab = ag.extrude(ag.polygon(outline), high - low, bevel=0.002).at(z=(low + high) / 2)
    for x0, x1, y0, y1 in holes:
        slab = slab - ag.Region((x0, x1), (y0, y1), (low - 0.01, high + 0.01)).box()
    return ag.part(slab, "worktop", finish)


def basin(region: ag.Region, *, wall: float, finish: Material, rim: float = 0.0) -> ag.Body:
    """Make a sink that fills a region, with a drain in its floor; `rim` is the width of a flange on top."""
    cavity = region.shrink(x=wall, y=wall).with_(z=(region.z.low + 1.5 * wall, region.z.high + 0.01))
    shell = region.box(bevel=min(0.006, wall / 3)) - cavity.box(bevel=0.02)
    drain = ag.cylinder(0.035, 4 * wall).at(region.x.mid, region.y.mid, region.z.low + wall)
    parts = [ag.part(shell - drain, "basin", finish)]
    strainer = ag.cylinder(0.0345, 0.004, bevel=0.001).at(region.x.mid, region.y.mid, region.z.low + 0.002)
    parts.append(ag.part(strainer, "drain", _STEEL))
    if rim:
        over = region.grow(x=rim, y=rim).with_(z=(region.z.high, region.z.high + 0.002))
        parts.append(ag.part(over.box(bevel=0.0008) - cavity.grow(z=0.05).box(), "rim", finish))
    return ag.weld(*parts)


def hood(region: ag.Region, ceiling: float) -> ag.Body:
    """Make a hood: a canopy that fills a region, a filter below, and a chimney up to the ceiling."""
    middle, back = region.x.mid, region.y.high
    chimney = ag.Region((middle - 0.13, middle + 0.13), (back - 0.24, back), (region.z.high, ceiling))
    filter_ = region.shrink(x=0.04, y=0.05).with_(z=(region.z.low - 0.004, region.z.low))
    slots = [(region.x.mid, region.y.low, region.z.mid)]
    canopy = region.box(bevel=0.004)
    keys = [
        ag.cylinder(0.008, 0.004, axis=-ag.Y).at(x + 0.03 * key, y - 0.002, z)
        for x, y, z in slots
        for key in (-1, 0, 1)
    ]
    return ag.weld(
        ag.part(canopy, "hood", _STEEL),
        ag.part(chimney.box(bevel=0.002), "chimney", _STEEL),
        ag.part(filter_.box(bevel=0.001), "filter", ag.material("aluminium")),
        ag.part(keys, "key", ag.material("black_abs")),
    )


def socket(x: float, z: float) -> ag.Body:
    """Make a socket outlet on a wall, with its middle at x and z."""
    plate = ag.box(0.082, 0.009, 0.082, bevel=0.003).at(x, -0.0045, z)
    hole = ag.cylinder(0.0195, 0.02, axis=ag.Y).at(x, -0.006, z)
    pins = [ag.cylinder(0.0025, 0.02, axis=ag.Y).at(x + side * 0.0095, 0, z) for side in (-1, 1)]
    bottom = ag.cylinder(0.0193, 0.0022, axis=ag.Y).at(x, -0.0012, z)
    for pin in pins:
        bottom = bottom - pin
    return ag.weld(ag.part(plate - hole, "socket", _WHITE), ag.part(bottom, "socket", _WHITE))
