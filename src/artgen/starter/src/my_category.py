"""A box with a hinged lid: a starter for your own category.

Change it, check it with `artgen check src/my_category.py`, and look at it with `artgen view`.
"""

from typing import Literal

import artgen as ag


@ag.category(labels="box lid handle", joints=(1, 1))
def my_category(
    *,
    width: ag.Float = ag.uniform(0.15, 0.40, "m", doc="outside, along x", within=(0.05, 1.0)),
    depth: ag.Float = ag.uniform(0.10, 0.30, "m", doc="outside, along y", within=(0.05, 1.0)),
    height: ag.Float = ag.uniform(0.06, 0.20, "m", doc="with the lid"),
    wall: ag.Float = ag.uniform(0.006, 0.010, "m", doc="thickness of the boards"),
    swing: ag.Float = ag.uniform(1.5, 2.0, "rad", doc="how far the lid opens"),
    wood: Literal["oak", "walnut"] = ag.choice({"oak": 0.6, "walnut": 0.4}),
) -> ag.Body:
    """Make a closed wooden box with a lid that is hinged at the back."""
    # A drawn value is a `Float` here: use it like a number; its value is known only later. A `Literal`, an
    # `int` or a `bool` is known now: plain `if`, `for` and `match` work. A region is planned space: it gives
    # parts their sizes and places.
    gap = 0.001  # between the box and its lid, so that they never touch
    boards = ag.material(wood)
    whole = ag.Region.centered(width, depth, height).at(z=height / 2)
    board, outside = whole.stack(wall, None, gap=gap)

    inside = outside.shrink(wall, top=-0.01)  # open at the top
    body = ag.part(outside.box(bevel=0.001) - inside.box(), "box", boards)

    lip = ag.box(0.04, 0.012, wall, bevel=0.001).align(board.anchor(y=-1), y=1)
    handle = ag.part(lip, "handle", boards, grasp=ag.grasp_on(lip, depth=0.010))
    lid = ag.weld(ag.part(board.box(bevel=0.001), "lid", boards), handle)

    pivot = board.anchor(y=1, z=-1)
    hinge = ag.Revolute("lid_hinge", axis=-ag.X, pivot=pivot, limits=(0, swing), friction=0.05, damping=0.01)
    return body.attach(lid, hinge)
