"""Linkages: bodies with a closed chain, in layers of 6 mm along y."""

from collections.abc import Mapping, Sequence

import numpy as np

from artgen.asset import Asset
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import part, weld
from artgen.nodes.csg import hull
from artgen.nodes.handles import Body, Scalar, Solid
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box, cylinder
from artgen.nodes.vector import X, Y

Place = tuple[float, float]

PLACES: tuple[Place, ...] = ((0.0, 0.0), (0.0, 0.03), (0.1, 0.07), (0.12, 0.0))
"""Pivots of a four-bar whose crank turns endlessly, in the plane of x and z [m]."""


def bar(name: str, start: Place, end: Place, layer: int) -> Body:
    """Return a bar of steel between two places of the plane of x and z."""
    disc = cylinder(0.008, 0.005, axis=Y)
    ends = [disc.at(x, -0.006 * layer, z) for x, z in (start, end)]
    return part(hull(*ends), name, material("steel"))


def turn(name: str, at: Place, **options: object) -> Revolute:
    """Return a joint about y."""
    return Revolute(name, axis=Y, pivot=(at[0], 0, at[1]), **options)


def open_chain(
    places: Sequence[Place] = PLACES,
    limits: tuple[Scalar, Scalar] | None = None,
    layers: Mapping[str, int] | None = None,
    pin: Body | None = None,
    hole: Solid | None = None,
    **options: object,
) -> Body:
    """Return ground, crank, rod (with a pin) and rocker (with a hole); `options` are of the crank's joint."""
    layer = {"ground": 0, "crank": 1, "rod": 2, "rocker": 1} | dict(layers or {})
    o, a, b, c = places
    crank_turn = turn("crank_turn", o, limits=limits, **options)
    rod, rocker = bar("rod", a, b, layer["rod"]), bar("rocker", c, b, layer["rocker"])
    rod, rocker = rod if pin is None else weld(rod, pin), rocker if hole is None else rocker.cut(hole)
    crank = bar("crank", o, a, layer["crank"]).attach(rod, turn("rod_turn", a))
    body = bar("ground", o, c, layer["ground"]).attach(crank, crank_turn)
    return body.attach(rocker, turn("rocker_turn", c))


def four_bar(places: Sequence[Place] = PLACES, **options: object) -> Body:
    """Return an open chain with its pin."""
    x, z = places[2]
    chain = open_chain(places, **options)
    return chain.loop("rod", "rocker", at=(x, 0, z), axis=Y, driver=turn("crank_turn", places[0]))


def slider_crank(crank: float = 0.03, rod: float = 0.1) -> Body:
    """Return a crank that turns endlessly about y and moves a slider along x by a rod."""
    pin, end = (crank, 0.0), (crank + rod, 0.0)
    crank_turn = turn("crank_turn", (0, 0))
    arm = bar("crank", (0, 0), pin, 1).attach(bar("rod", pin, end, 2), turn("rod_turn", pin))
    block = part(box(0.02, 0.005, 0.02).at(end[0], -0.018, 0), "slider", material("brass"))
    body = bar("ground", (0, 0), (0.05, 0), 0).attach(arm, crank_turn)
    body = body.attach(block, Prismatic("slide", axis=X))
    return body.loop("slider", "rod", at=(end[0], 0, 0), axis=Y, driver=crank_turn)


def made(body: Body, **parameters: float) -> Asset:
    """Return the asset of a body."""
    return Asset.from_tree(evaluate(body, parameters).value, "made", "test")


def gap(asset: Asset, q: Mapping[str, float]) -> float:
    """Return the largest gap at the pins of an asset at a pose [m]."""
    pose = asset.pose(q)
    points = [np.array([*loop.point, 1.0]) for loop in asset.loops]
    ends = [
        [pose[name] @ point for name in loop.links] for loop, point in zip(asset.loops, points, strict=True)
    ]
    return max(float(np.abs(first - second).max()) for first, second in ends)
