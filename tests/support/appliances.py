"""Mock appliances with parts behind doors: hands open them, and the parts need the doors open."""

from artgen import (
    Body,
    Prismatic,
    Revolute,
    Solid,
    X,
    Y,
    Z,
    bounding_collider,
    box,
    cylinder,
    grasp_on,
    material,
    part,
    push_on,
    union,
    weld,
)
from support.proof_fridges import block, carcass

WHITE, GLASS, STEEL, RUBBER = (material(name) for name in ("polypropylene", "glass", "stainless", "rubber"))


def bar(low: float, high: float, y: float, z: float) -> tuple[Solid, Solid]:
    """Return a level bar handle before the plane at y, and its two posts [m]."""
    tube = cylinder(0.008, high - low, axis=X).at((low + high) / 2, y - 0.045, z)
    posts = [cylinder(0.006, 0.05, axis=Y).at(x, y - 0.022, z) for x in (low + 0.02, high - 0.02)]
    return tube, union(*posts)


def tray(low: tuple[float, float, float], high: tuple[float, float, float], wall: float = 0.004) -> Solid:
    """Return a box of boards that is open at the top [m]."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    return union(
        block(low, (x1, y1, z0 + wall)),
        block(low, (x0 + wall, y1, z1)),
        block((x1 - wall, y0, z0), high),
        block(low, (x1, y0 + wall, z1)),
        block((x0, y1 - wall, z0), high),
    )


def fridge(
    *,
    slack: float | None = 0.03,
    needs: bool = True,
    angle: float = 1.7,
    friction: float = 25.0,
    ghost: bool = False,
) -> Body:
    """Return a refrigerator: a door with a handle, and two drawers behind it that need it open.

    Args:
        slack: How far the drawers come forward before they need the door; 35 mm lie between them. None lets
            them need it from 0 on.
        needs: Whether the drawers need the door.
        angle: The angle of the door beyond which it is out of the drawers' way [rad].
        friction: Of the door's hinge [N m].
        ghost: Whether the lower half of the door is missing, so that nothing stops the lower drawer.
    """
    width, depth, height, wall, thick = 0.6, 0.6, 0.9, 0.04, 0.05
    front, side = 0.0, width / 2
    shell = union(*carcass((-side, front, 0.0), (side, front + depth, height), wall))
    low = height / 2 if ghost else 0.0
    leaf = block((-side, front - 0.004 - thick, low), (side, front - 0.004, height))
    grip, posts = bar(-0.26, -0.06, front - 0.004 - thick, 0.6)
    door = weld(
        part(leaf, "door", WHITE, name="door"),
        part(union(grip, posts), "handle", STEEL, grasp=grasp_on(grip, at=(-0.16, -0.1, 0.6))),
    )
    hinge = Revolute(
        "door_hinge",
        axis=Z,
        pivot=(side, front - 0.004 - thick, 0.0),
        limits=(0.0, 2.0),
        friction=friction,
        damping=1.0,
        effort=60.0 * 0.45,
    )
    body = part(shell, "body", WHITE).attach(door, hinge)
    condition = hinge > angle
    need = (condition if slack is None else condition.beyond(slack)) if needs else None
    for number, bottom in enumerate((0.06, 0.34)):
        near, inset = front + 0.031, 0.06
        lip = block((-0.1, near, bottom + 0.15), (0.1, near + 0.026, bottom + 0.158))
        drawer = part(
            union(tray((-side + inset, near + 0.025, bottom), (side - inset, 0.45, bottom + 0.2)), lip),
            "inner_drawer",
            GLASS,
            name=f"inner_drawer_{number}",
            grasp=grasp_on(lip),
        )
        slide = Prismatic(
            f"drawer_slide_{number}",
            axis=-Y,
            limits=(0.0, 0.35),
            needs=need,
            friction=5.0,
            damping=8.0,
            effort=60.0,
        )
        body = body.attach(drawer, slide)
    return body


def washer(*, racks: int = 3, buttons: int = 8, arms: int = 2, slack: float | None = 0.022) -> Body:
    """Return a dishwasher: a door hinged at the bottom, racks behind it, buttons on top, arms that spin."""
    width, depth, height, wall, thick = 0.6, 0.55, 0.82, 0.03, 0.05
    side, front, plinth = width / 2, 0.0, 0.1
    shell = union(
        *carcass((-side, front, plinth), (side, front + depth, height - 0.06), wall),
        block((-side, front, height - 0.062), (side, front + depth, height)),
        block((-side + 0.02, front + 0.06, 0.0), (side - 0.02, front + depth, plinth + 0.001)),
    )
    leaf = block((-side + 0.003, front - 0.004 - thick, plinth + 0.004), (side - 0.003, front - 0.004, 0.75))
    grip, posts = bar(-0.2, 0.2, front - 0.004 - thick, 0.68)
    door = weld(part(leaf, "door", WHITE), part(union(grip, posts), "handle", STEEL, grasp=grasp_on(grip)))
    hinge = Revolute(
        "door_hinge",
        axis=X,
        pivot=(0.0, front - 0.004 - thick / 2, plinth + 0.012),
        limits=(0.0, 1.5),
        stiffness=37.0,
        friction=12.0,
        damping=2.0,
        effort=60.0 * 0.6,
    )
    places = [-0.21 + 0.06 * number for number in range(buttons)]
    holes = union(*(block((x - 0.0105, front - 0.01, 0.7645), (x + 0.0105, 0.02, 0.7855)) for x in places))
    body = part(shell - holes if buttons else shell, "body", STEEL, name="body")
    body = body.attach(door, hinge)
    for number, x in enumerate(places):
        knob = box(0.02, 0.02, 0.02).at(x, front + 0.004, 0.775)
        press = Prismatic(
            f"button_press_{number}", axis=Y, limits=(0.0, 0.003), stiffness=800.0, rest=-0.001, damping=2.0,
            armature=0.05, effort=10.0,
        )  # fmt: skip
        body = body.attach(part(knob, "button", RUBBER, name=f"button_{number}", push=push_on(knob)), press)
    for number in range(racks):
        body = body.attach(_rack(number, front), _rack_slide(number, hinge, slack))
    for number in range(arms):
        z = 0.15 + 0.19 * number
        arm = union(block((-0.2, 0.26, z), (0.2, 0.29, z + 0.012)), cylinder(0.015, 0.02).at(0.0, 0.275, z))
        spin = Revolute(
            f"spray_arm_{number}", axis=Z, pivot=(0.0, 0.275, z), damping=0.01, friction=0.01, driven="water"
        )
        body = body.attach(part(arm, "spray_arm", WHITE, name=f"spray_arm_{number}"), spin)
    return body


def _rack(number: int, front: float) -> Body:
    bottom = 0.2 + 0.19 * number
    low, high = (-0.25, front + 0.045, bottom), (0.25, 0.5, bottom + 0.09)
    rows = [0.05 + 0.04 * row for row in range(12)]
    wires = [block((-0.25, y, bottom), (0.25, y + 0.004, bottom + 0.004)) for y in rows]
    walls = union(
        bounding_collider(union(*wires)),
        block(low, (0.25, low[1] + 0.004, high[2])),
        block((-0.25, high[1] - 0.004, bottom), high),
        block(low, (-0.246, high[1], high[2])),
        block((0.246, low[1], bottom), high),
    )
    tines = [
        cylinder(0.002, 0.05).at(-0.15 + 0.1 * (index % 4), 0.1 + 0.08 * (index // 4), bottom + 0.026)
        for index in range(16)
    ]
    lip = block((-0.06, low[1] - 0.025, bottom + 0.07), (0.06, low[1] + 0.002, bottom + 0.078))
    return part(union(walls, *tines, lip), "rack", STEEL, name=f"rack_{number}", grasp=grasp_on(lip))


def _rack_slide(number: int, hinge: Revolute, slack: float | None) -> Prismatic:
    condition = hinge > 1.45
    return Prismatic(
        f"rack_slide_{number}",
        axis=-Y,
        limits=(0.0, 0.42),
        needs=condition if slack is None else condition.beyond(slack),
        friction=5.0,
        damping=10.0,
        effort=60.0,
    )
