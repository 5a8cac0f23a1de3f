"""Assets whose links never collide, tight where the things themselves are, with knobs for faults."""

import math
from collections.abc import Callable

import numpy as np

from artgen import (
    Prismatic,
    Revolute,
    Screw,
    Solid,
    X,
    Y,
    Z,
    bore,
    box,
    circle,
    cylinder,
    frustum,
    helix,
    part,
    sweep,
    tube,
    union,
    weld,
)
from artgen.asset import Asset
from support.proof_fridges import (
    NOWHERE,
    STEEL,
    WHITE,
    Offset,
    block,
    carcass,
    evaluated,
    french_fridge,
    fridge,
    gasket_fridge,
    shifted,
)


def bearing_door(
    *, pivot: Offset = NOWHERE, wide: float = 0.0, limit: float = 1.0, ratio: float = 1.0, rule: bool = True
) -> Asset:
    """Make a door with a latch, a lever and three hinges: pins with 0.2 mm of play in bored knuckles.

    Args:
        pivot: By how much the hinge is misplaced [m].
        wide: How much too thick the pins are [m].
        limit: Factor on the limit of the hinge.
        ratio: Factor on how far the lever draws the bolt.
        rule: Whether the latch holds the door.
    """
    width, height, thick, gap, post = 0.8, 2.0, 0.04, 0.003, 0.06
    pin_x, pin_y, levels = -gap / 2, -thick - 0.008, (0.25, 1.0, 1.75)
    lock_x, lock_y, lock_z = width - post, -thick / 2, 1.0
    lever = Revolute("lever", pivot=(lock_x, lock_y, lock_z), axis=Y, limits=(0.0, 0.8), stiffness=1.0)
    hinge = Revolute(
        "hinge",
        pivot=shifted((pin_x, pin_y, 0.0), pivot),
        axis=-Z,
        limits=(0.0, 1.92 * limit),
        needs=(lever > 0.55).until(0.06) if rule else None,
    )
    jambs = [block((-post, -thick, 0.0), (-gap, 0.0, height + gap))]
    jambs.append(block((width + gap, -thick, 0.0), (width + gap + post, 0.0, height + gap)))
    jambs.append(block((-post, -thick, height + gap), (width + gap + post, 0.0, height + post)))
    jambs.append(block((-post, gap, 0.0), (0.01, gap + 0.02, height)))
    jambs.append(block((width - 0.01, gap, 0.0), (width + gap + post, gap + 0.02, height)))
    ties = [
        block((x, -0.001, 0.0), (x + 0.02, gap + 0.001, height)) for x in (-post, width + gap + post - 0.02)
    ]
    strike = block((width, lock_y - 0.007, 0.991), (width + 0.015, lock_y + 0.007, 1.009))
    knuckles, tabs, pins, pin_tabs = [], [], [], []
    for z in levels:
        knuckles.append(tube(0.005, 0.0033, 0.08).at(pin_x, pin_y, z) - bore(0.0032, 0.1).at(pin_x, pin_y, z))
        tabs.append(block((-0.03, pin_y - 0.002, z - 0.04), (pin_x - 0.0042, -thick, z + 0.04)))
        pins.append(cylinder(0.003 + wide / 2, 0.12).at(pin_x, pin_y, z))
        for end in (-0.0502, 0.0502):
            pins.append(cylinder(0.005, 0.0196).at(pin_x, pin_y, z + end))
            pin_tabs.append(block((pin_x, pin_y - 0.002, z + end - 0.0098), (0.03, -thick, z + end + 0.0098)))
    frame = part(union(*jambs, *ties, *knuckles, *tabs) - strike, "frame", WHITE)
    pocket = block((width - 0.051, lock_y - 0.0064, 0.9916), (width + 0.01, lock_y + 0.0064, 1.0084))
    panel = block((0.0, -thick, gap), (width, 0.0, height)) - pocket
    panel -= bore(0.0085, 0.1, axis=Y).at(lock_x, lock_y, lock_z)
    leaf = part(union(panel, *pins, *pin_tabs), "leaf", WHITE)
    grips = [cylinder(0.008, 0.14, axis=Y).at(lock_x, lock_y, lock_z)]
    grips += [box(0.13, 0.02, 0.02).at(lock_x - 0.05, lock_y + y, lock_z) for y in (-0.075, 0.075)]
    leaf = leaf.attach(part(union(*grips), "handle", STEEL), lever)
    bolt = block((width - 0.035, lock_y - 0.006, 0.992), (width + 0.011, lock_y + 0.006, 1.008))
    draw = Prismatic("bolt_slide", axis=-X, follows=0.019 * ratio * lever)
    leaf = leaf.attach(part(bolt, "bolt", STEEL), draw)
    return evaluated(frame.attach(leaf, hinge), "bearing_door")


def lamp(*, pivot: Offset = NOWHERE, wide: float = 0.0, limit: float = 1.0) -> Asset:
    """Make a desk lamp that turns on its base: two arms and a shade.

    Args:
        pivot: By how much the elbow is misplaced [m].
        wide: How much too thick the lower arm is [m].
        limit: Factor on the limits of the arms.
    """
    shoulder, length, reach = 0.08, 0.3, 0.28
    elbow, tip = shoulder + length, (reach, 0.0, shoulder + length)
    stalk = [cylinder(0.02, 0.0285).at(0.0, 0.0, 0.03575)]
    stalk += [box(0.03, 0.012, 0.06).at(0.0, y, 0.065) for y in (-0.014, 0.014)]
    arm = box(0.016, 0.01 + wide, length + 0.02).at(0.0, 0.0, shoulder + length / 2)
    fork = [box(reach + 0.02, 0.01, 0.014).at(reach / 2, y, elbow) for y in (-0.012, 0.012)]
    fork.append(box(0.02, 0.03, 0.01).at(reach / 2, 0.0, elbow))
    shade = frustum(0.073, 0.023, 0.085) - frustum(0.071, 0.0195, 0.0851)
    head = union(
        box(0.012, 0.011, 0.04).at(reach, 0.0, elbow - 0.015),
        cylinder(0.022, 0.005).at(reach, 0.0, elbow - 0.0375),
        shade.at(reach, 0.0, elbow - 0.0775),
    )
    joints = [
        Revolute("yaw", axis=Z, limits=(-math.pi, math.pi)),
        Revolute("lower", pivot=(0.0, 0.0, shoulder), axis=Y, limits=(-0.5 * limit, 0.5 * limit)),
        Revolute(
            "upper", pivot=shifted((0.0, 0.0, elbow), pivot), axis=Y, limits=(-0.6 * limit, 0.35 * limit)
        ),
        Revolute("tilt", pivot=tip, axis=Y, limits=(-0.7 * limit, 0.7 * limit)),
    ]
    chain = part(head, "shade", STEEL)
    links = ((union(*fork), "upper_arm"), (arm, "lower_arm"), (union(*stalk), "stalk"))
    for (solid, label), joint in zip(links, joints[:0:-1], strict=True):
        chain = part(solid, label, STEEL).attach(chain, joint)
    base = part(cylinder(0.09, 0.02).at(0.0, 0.0, 0.01), "base", STEEL)
    return evaluated(base.attach(chain, joints[0]), "lamp")


def dishwasher(*, pivot: Offset = NOWHERE, wide: float = 0.0, limit: float = 1.0, rule: bool = True) -> Asset:
    """Make a dishwasher: a door that falls open, a rack of 60 wires that needs it open.

    Args:
        pivot: By how much the door's hinge is misplaced [m].
        wide: How much too wide the rack is [m].
        limit: Factor on all limits.
        rule: Whether the rack needs the door.
    """
    width, depth, height, wall, radius = 0.6, 0.6, 0.7, 0.02, 0.002
    tub = carcass((0.0, 0.0, 0.0), (width, depth, height), wall)
    tub += [block((x, 0.02, 0.4), (x + 0.012, depth - wall, 0.412)) for x in (wall, width - wall - 0.012)]
    tub.append(cylinder(0.02, 0.04).at(width / 2, 0.3, 0.04))
    panel = [block((0.0, -0.05, 0.003), (width, -0.003, height))]
    panel.append(block((0.2, -0.004, 0.225), (0.4, 0.01, 0.375)))  # the dispenser
    panel.append(block((0.15, -0.08, 0.64), (0.45, -0.049, 0.66)))
    x0, x1 = wall + 0.003 - wide / 2, width - wall - 0.003 + wide / 2
    y0, y1, z0 = 0.03, depth - wall - 0.01, 0.1

    def along_y(x: float, z: float) -> Solid:
        return cylinder(radius, y1 - y0, axis=Y).at(x, (y0 + y1) / 2, z)

    def along_x(y: float, z: float) -> Solid:
        return cylinder(radius, x1 - x0, axis=X).at((x0 + x1) / 2, y, z)

    across = np.linspace(x0 + radius, x1 - radius, 16).tolist()
    wires = [along_y(x, z0) for x in across]
    wires += [along_x(y, z0 + radius) for y in np.linspace(y0 + radius, y1 - radius, 12).tolist()]
    for z in (0.17, 0.24, 0.3):
        wires += [along_y(x, z) for x in (x0 + radius, x1 - radius)]
        wires += [along_x(y, z + radius) for y in (y0 + radius, y1 - radius)]
    posts = [(x, y) for x in (across[0], across[-1]) for y in (y0 + radius, y1 - radius)]
    tines = [(x, y) for x in across[2:14:2] for y in (0.12, 0.3)]
    wires += [cylinder(radius, 0.2).at(x, y, z0 + 0.1) for x, y in posts]
    wires += [cylinder(radius, 0.12).at(x, y, z0 + 0.06) for x, y in tines]
    wires += [along_y(x, 0.29) for x in (0.2, 0.3, 0.4, 0.5)][: 60 - len(wires)]
    hinge = Revolute("hinge", pivot=shifted((0.0, -0.05, 0.003), pivot), axis=X, limits=(0.0, 1.5708 * limit))
    slide = Prismatic("slide", axis=-Y, limits=(0.0, 0.5 * limit), needs=hinge > 1.5 if rule else None)
    body = part(union(*tub), "tub", STEEL).attach(part(union(*panel), "door", STEEL), hinge)
    return evaluated(body.attach(part(union(*wires), "rack", STEEL), slide), "dishwasher")


def cooktop(*, pivot: Offset = NOWHERE, wide: float = 0.0) -> Asset:
    """Make a control panel with eleven dials, each turning on a post with 0.5 mm of play.

    Args:
        pivot: By how much the axes of the dials are misplaced [m].
        wide: How much too thick the posts are [m].
    """
    places = [(0.07 * (index - 5), 0.0, 0.0) for index in range(11)]
    posts = [cylinder(0.003 + wide / 2, 0.025).at(x, y, 0.02) for x, y, _ in places]
    panel = part(union(block((-0.4, -0.04, 0.0), (0.4, 0.04, 0.01)), *posts), "panel", STEEL)
    hob = block((-0.4, 0.04, 0.0), (0.4, 0.5, 0.01))
    knob = cylinder(0.022, 0.032).at(0.0, 0.0, 0.0265) - bore(0.0035, 0.0227).at(0.0, 0.0, 0.0216)
    knob = union(knob, block((-0.003, -0.02, 0.042), (0.003, 0.02, 0.05)))
    turn = Revolute("dial_turn", pivot=shifted((0.0, 0.0, 0.0105), pivot), axis=Z, limits=(-math.pi, math.pi))
    panel = panel.repeat(part(knob, "dial", WHITE), turn, at=places)
    return evaluated(weld(panel, part(hob, "hob", STEEL)), "cooktop")


def trash_can(*, pivot: Offset = NOWHERE, wide: float = 0.0, limit: float = 1.0, ratio: float = 1.0) -> Asset:
    """Make a can whose lid follows a pedal.

    Args:
        pivot: By how much the hinge of the lid is misplaced [m].
        wide: How much too wide the collar of the lid is [m].
        limit: Factor on the range of the pedal.
        ratio: Factor on how far the pedal takes the lid.
    """
    radius, height = 0.15, 0.4
    can = [tube(radius, radius - 0.003, height - 0.005).at(0.0, 0.0, (height + 0.005) / 2)]
    can.append(cylinder(radius + 0.01, 0.012).at(0.0, 0.0, 0.006))
    can.append(block((-0.03, radius - 0.002, height - 0.06), (0.03, radius + 0.024, height)))
    can += [block((x, -radius - 0.05, 0.0), (x + 0.006, -radius + 0.02, 0.03)) for x in (-0.053, 0.047)]
    can.append(block((-0.053, -radius - 0.09, 0.0), (0.053, -radius + 0.02, 0.01)))
    lid = [cylinder(radius + 0.002, 0.01).at(0.0, 0.0, height + 0.006)]
    lid.append(block((-0.025, radius - 0.01, height + 0.005), (0.025, radius + 0.027, height + 0.015)))
    collar = radius - 0.012 + wide / 2
    lid.append(tube(collar, collar - 0.003, 0.012).at(0.0, 0.0, height - 0.003))
    pedal = [block((-0.04, -radius - 0.1, 0.046), (0.04, -radius - 0.025, 0.052))]
    pedal.append(block((-0.03, -radius - 0.031, 0.032), (0.03, -radius - 0.025, 0.048)))
    push = Revolute("pedal", pivot=(0.0, -radius - 0.015, 0.036), axis=X, limits=(0.0, 0.3 * limit))
    swing = Revolute(
        "lid",
        pivot=shifted((0.0, radius + 0.027, height + 0.012), pivot),
        axis=-X,
        follows=4.0 * ratio * push,
    )
    body = part(union(*can), "can", STEEL)
    body = body.attach(part(union(*pedal), "pedal", STEEL), push)
    return evaluated(body.attach(part(union(*lid), "lid", STEEL), swing), "trash_can")


def sliding_gate(*, wide: float = 0.0, limit: float = 1.0, tilt: float = 0.0) -> Asset:
    """Make a gate of three panels, each in the channel of the one before, 0.5 mm apart all around.

    Args:
        wide: How much too thick the runners are [m].
        limit: Factor on all limits.
        tilt: Angle by which the slides are out of line [rad].
    """
    axis = (math.cos(tilt), 0.0, math.sin(tilt))

    def channel(y: float) -> list[Solid]:
        """A channel that is open downwards at y, with lips that hold what runs in it."""
        walls = [block((0.0, y - 0.02, 1.196), (1.0, y + 0.02, 1.2))]
        for side in (-1, 1):
            for near, far, low in ((0.016, 0.02, 1.16), (0.006, 0.02, 1.16)):
                y0, y1 = sorted((y + side * near, y + side * far))
                walls.append(block((0.0, y0, low), (1.0, y1, 1.197 if near > 0.01 else 1.164)))
        return walls

    def panel(index: int) -> list[Solid]:
        y = 0.05 * index
        runner = block((0.0, y - 0.0155 - wide / 2, 1.1645), (1.0, y + 0.0155 + wide / 2, 1.1955))
        return [runner, block((0.0, y - 0.0055, 0.05), (1.0, y + 0.0055, 1.17))]

    def carrier(index: int) -> list[Solid]:
        """The channel for the next panel on a bracket of this one."""
        y = 0.05 * index
        bracket = block((0.0, y - 0.0055, 1.12), (1.0, y + 0.03, 1.13))
        web = block((0.0, y + 0.0247, 1.12), (1.0, y + 0.0302, 1.2))
        return [bracket, web, *channel(y + 0.05)]

    posts = [block((x, -0.08, 0.0), (x + 0.05, -0.03, 1.26)) for x in (0.0, 0.95)]
    top = block((0.0, -0.08, 1.199), (1.0, 0.02, 1.26))
    chain = part(union(*panel(2)), "panel", STEEL, name="panel_2")
    for index in (1, 0):
        slide = Prismatic(f"slide_{index + 1}", axis=axis, limits=(0.0, 0.9 * limit))
        name = f"panel_{index}"
        chain = part(union(*panel(index), *carrier(index)), "panel", STEEL, name=name).attach(chain, slide)
    slide = Prismatic("slide_0", axis=axis, limits=(0.0, 0.9 * limit))
    return evaluated(
        part(union(top, *channel(0.0), *posts), "post", STEEL).attach(chain, slide), "sliding_gate"
    )


def threaded_cap(*, wide: float = 0.0, pitch: float = 1.0, sense: float = 1.0) -> Asset:
    """Make a cap that unscrews by one turn and a quarter: three lugs run between the turns of a thread.

    Args:
        wide: How much too high the lugs are [m].
        pitch: Factor on the advance of the cap.
        sense: 1 for the right-hand thread of the neck.
    """
    rise, radius, low, turns = 0.006, 0.02, 0.012, 2.75
    neck = cylinder(radius, 0.04).at(0.0, 0.0, 0.02)
    neck |= sweep(circle(0.0009), helix(radius, rise, turns)).at(0.0, 0.0, low + rise * turns / 2)
    height = rise - 2 * (0.0009 + 0.0004) + wide
    lugs = []
    for phi in (0.4, 0.5, 0.6):
        lug = box(0.002, 0.0015, height).at(radius + 0.0012, 0.0, low + rise * (phi / (2 * math.pi) + 0.5))
        lugs.append(lug.rotate(Z, phi))
    crown = (
        tube(radius + 0.003, radius + 0.002, 0.03) | cylinder(radius + 0.003, 0.002).at(0.0, 0.0, 0.016)
    ).at(0.0, 0.0, 0.0255)
    turn = Screw(
        "cap_turn",
        pitch=sense * pitch * rise,
        axis=Z,
        limits=(0.0, 2.5 * math.pi),
        friction=0.1,
        armature=1e-4,
        damping=0.01,
        effort=3.0,
    )
    cap = part(union(crown, *lugs), "cap", WHITE)
    return evaluated(part(neck, "neck", STEEL).attach(cap, turn), "threaded_cap")


PROOF_ASSETS: dict[str, Callable[..., Asset]] = {
    make.__name__: make
    for make in (
        bearing_door,
        fridge,
        french_fridge,
        lamp,
        dishwasher,
        cooktop,
        trash_can,
        sliding_gate,
        gasket_fridge,
        threaded_cap,
    )
}
"""Functions that make the assets, by name; without arguments they are free of faults."""
