"""A box with a hinged lid: a starter for your own category.

Change it, and look at the result with `artgen view src/my_category.py`.
"""

from typing import Literal

from artgen import Body, Float, Revolute, X, box, category, choice, grasp_on, material, part, uniform, weld


@category(labels=("box", "lid", "handle"), joints=(1, 1))
def my_category(
    *,
    width: Float = uniform(0.15, 0.40, "m", doc="outside, along x", within=(0.05, 1.0)),
    depth: Float = uniform(0.10, 0.30, "m", doc="outside, along y", within=(0.05, 1.0)),
    height: Float = uniform(0.06, 0.20, "m", doc="with the lid"),
    wall: Float = uniform(0.006, 0.010, "m", doc="thickness of the boards"),
    swing: Float = uniform(1.5, 2.0, "rad", doc="how far the lid opens"),
    wood: Literal["oak", "walnut"] = choice("oak", "walnut"),
) -> Body:
    """Make a closed wooden box with a lid that is hinged at the back."""
    # A drawn value is a `Float` here: use it like a number; its value is known only later. A `Literal`, an
    # `int` or a `bool` is known now: plain `if`, `for` and `match` work.
    gap = 0.001  # gap between the box and its lid, so that they never touch
    boards = material(wood)

    outside = box(width, depth, height - wall - gap, bevel=0.001).align((0, 0, 0), z=-1)
    inside = box(width - 2 * wall, depth - 2 * wall, height).align((0, 0, wall), z=-1)
    body = part(outside - inside, "box", boards)

    board = box(width, depth, wall, bevel=0.001).align((0, 0, height), z=1)
    lip = box(0.04, 0.012, wall, bevel=0.001).align(board.anchor(y=-1), y=1)
    lid = weld(part(board, "lid", boards), part(lip, "handle", boards, grasp=grasp_on(lip, depth=0.010)))

    hinge = Revolute(
        "lid_hinge", axis=-X, pivot=board.anchor(y=1, z=-1), limits=(0, swing), friction=0.05, damping=0.01
    )
    return body.attach(lid, hinge)
