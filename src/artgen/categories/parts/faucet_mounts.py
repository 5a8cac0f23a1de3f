"""What faucets stand on: sample decks and wall boards, columns and bridges; and the rod of a drain."""

from artgen import (
    Body,
    Joint,
    Material,
    Prismatic,
    Scalar,
    Solid,
    VectorLike,
    X,
    Y,
    Z,
    array,
    box,
    box_between,
    cylinder,
    cylinder_between,
    detail,
    details,
    frustum,
    grasp_on,
    material,
    part,
    rectangle,
    revolve,
    sphere,
    torus,
    tube,
    union,
    vector,
    weld,
)
from artgen.categories.parts.feet import corner_feet
from artgen.categories.parts.finish import casting

PADS = 0.004
"""Height of the rubber pads under a deck or a foot [m]."""

BAR = 0.0125
"""Radius of the bar between two valves [m]."""

BEHIND = 0.062
"""From a wall to the bar before it [m]."""

ROD_TRAVEL = 0.028
"""How far the rod of a drain is lifted [m]."""

_ROD = 0.0030  # its radius [m]
_GUIDE = 0.012  # height of the collar that it passes [m]
_STANDS = 0.038  # how high its knob stands over the collar [m]
_PLAY = 0.0005  # around it [m]
_ROSE = 0.030  # radius of the flanges on a wall [m]


def deck(*, width: Scalar, depth: Scalar, thick: Scalar, finish: Material, rod_at: Scalar | None) -> Body:
    """Make a sample deck on pads, its upper face at `PADS + thick`.

    Args:
        width: [m].
        depth: [m].
        thick: [m].
        finish: Stone, wood or steel.
        rod_at: Where a hole for the rod of a drain is behind the middle [m].
    """
    board = box(width, depth, thick, bevel=0.003).at(0.0, 0.0, PADS + thick / 2)
    pads = corner_feet(width, depth, inset=0.016, radius=0.008, height=PADS)
    if rod_at is None:
        return weld(part(board, "deck", finish), pads)
    hole = box(0.008, 0.008, 0.1).at(0.0, rod_at, 0.0)
    return weld(part(board - hole, "deck", finish), pads)


def wall_board(*, width: Scalar, height: Scalar, thick: Scalar, finish: Material, metal: Material) -> Body:
    """Make a board that stands for a wall, its face on y = 0, on a foot of steel before it.

    Args:
        width: [m].
        height: [m].
        thick: [m].
        finish: Of the board.
        metal: Of the foot.
    """
    board = box_between((-0.5 * width, 0.0, PADS + 0.004), (0.5 * width, thick, height), bevel=0.003)
    foot = box_between((-0.42 * width, -0.19, PADS), (0.42 * width, thick + 0.03, PADS + 0.008), bevel=0.002)
    pads = corner_feet(0.84 * width, 0.22 + thick, inset=0.016, radius=0.008, height=PADS)
    steel = metal.with_(name="foot_steel", density=5000.0)
    screws = [
        details.screw(0.005, (side * 0.45 * width, 0.0, height - 0.03), material=material("stainless"))
        for side in (-1, 1)
    ]
    middle = 0.5 * (thick + 0.03 - 0.19)
    return weld(part(board, "deck", finish), part(foot, "deck", steel), pads.at(0.0, middle, 0.0), *screws)


def column(*, radius: Scalar, height: Scalar, finish: Material) -> Body:
    """Make a round column with its flange, on z = 0.

    Args:
        radius: [m].
        height: [m].
        finish: Its metal.
    """
    metal = casting(finish, 0.3)
    shaft = cylinder(radius, height + 0.0004, bevel=0.0006).align((0.0, 0.0, height), z=1)
    flange = frustum(radius + 0.0065, radius + 0.0045, 0.0065, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
    return weld(part(flange, "escutcheon", metal), part(shaft, "body", metal))


def pedestal(*, radius: Scalar, height: Scalar, finish: Material) -> Body:
    """Make the foot of a spout between two handles: a flange and a short column, on z = 0."""
    metal = casting(finish, 0.45)
    shaft = frustum(radius + 0.0085, radius + 0.0065, height, bevel=0.0008).align((0.0, 0.0, height), z=1)
    flange = frustum(radius + 0.0165, radius + 0.0135, 0.008, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
    return weld(part(flange, "escutcheon", metal), part(shaft, "body", metal))


def bar(*, half: Scalar, finish: Material, below: bool = False) -> Body:
    """Make the bar that joins two valves, along x at the origin, with the boss of the spout in its middle.

    The valves' axes are at `half` to either side; the boss reaches 22 mm up, and the sockets of valves 15 mm.

    Args:
        half: Half the distance of the valves [m].
        finish: Its metal.
        below: Whether the boss reaches down instead.
    """
    metal = casting(finish, 0.35)
    long = cylinder(BAR, 2.0 * half, axis=X)
    boss = cylinder(0.0205, 0.039, bevel=0.001).align(
        (0.0, 0.0, -0.022 if below else 0.022), z=-1 if below else 1
    )
    socket = cylinder(0.0185, 0.034, bevel=0.0012)
    sockets = array(socket.at(0.0, 0.0, -0.002), at=[(-half, 0.0, 0.0), (half, 0.0, 0.0)])
    rings: list[Body] = []
    for side in (-1, 1):
        for near in (0.026, half - 0.024):
            ring = torus(BAR + 0.0004, 0.0019, axis=X).at(side * near, 0.0, 0.0)
            rings.append(detail(ring, "body", finish))
    return weld(part(union(long, boss, sockets), "body", metal), *rings)


def risers(*, half: Scalar, height: Scalar, finish: Material) -> Body:
    """Make the two columns that carry a bar at a height over a deck on z = 0."""
    metal = casting(finish, 0.35)
    shaft = cylinder(0.0125, height).at(0.0, 0.0, 0.5 * height)
    flange = frustum(0.0265, 0.0235, 0.009, bevel=0.0015).align((0.0, 0.0, -0.0004), z=-1)
    nut = cylinder(0.0165, 0.012, bevel=0.0015).at(0.0, 0.0, 0.016)
    at: list[VectorLike] = [(-half, 0.0, 0.0), (half, 0.0, 0.0)]
    both = array(union(shaft, nut, flange), at=at)
    return part(both, "body", metal, separate="the bar joins them")


def elbows(*, half: Scalar, finish: Material) -> Body:
    """Make the two arms that carry a bar before a wall on y = 0: the bar is at y = -62 mm, on z = 0."""
    metal = casting(finish, 0.35)
    arm = cylinder_between((0.0, 0.0005, 0.0), (0.0, -BEHIND, 0.0), 0.0125)
    rose = frustum(_ROSE, _ROSE - 0.005, 0.011, axis=-Y, bevel=0.0018).at(0.0, -0.0053, 0.0)
    nut = cylinder_between((0.0, -0.014, 0.0), (0.0, -0.026, 0.0), 0.0165, bevel=0.0015)
    both = array(union(arm, rose, nut), at=[(-half, 0.0, 0.0), (half, 0.0, 0.0)])
    return part(both, "body", metal, separate="the bar joins them")


def lift_rod(
    body: Body,
    *,
    at: Scalar,
    top: Scalar,
    depth: Scalar,
    finish: Material,
    friction: Scalar,
) -> Body:
    """Attach the rod of a pop-up drain, in a collar behind the spout; lifted, it shuts the drain.

    Args:
        body: What has the collar.
        at: How far behind the middle it is [m].
        top: Height of the deck [m].
        depth: How deep it may reach into the deck [m].
        finish: Its metal.
        friction: Of the ball joint in the drain pipe [N].
    """
    inner, outer = (_ROD + _PLAY) / 0.966, 0.0082
    guide = revolve(
        rectangle(outer - 0.0005 - inner, _GUIDE).at(0.5 * (outer - 0.0005 + inner), 0.5 * _GUIDE), sides=12
    )
    skin = tube(outer, inner, _GUIDE + 0.0004, bevel=0.0008).at(0.0, 0.0, 0.5 * _GUIDE)
    place = vector(0.0, at, top)
    high = top + _GUIDE + _STANDS
    rod = cylinder_between((0.0, at, top - depth), (0.0, at, high), _ROD)
    knob: Solid = sphere(0.0068).at(0.0, at, high)
    metal = casting(finish, 0.9)
    held = part(union(rod, knob), "lift_rod", metal, grasp=grasp_on(knob, approach=-Y, closing=X))
    return weld(body, part(guide.at(place), "guide", metal), detail(skin.at(place), "guide", finish)).attach(
        held, _rod_slide(friction)
    )


def _rod_slide(friction: Scalar) -> Joint:
    return Prismatic(
        "lift_rod_slide",
        axis=Z,
        limits=(0.0, ROD_TRAVEL),
        friction=friction,
        damping=3.0,
        armature=0.02,
        effort=30.0,
    )
