"""A table: a desk or a side table with drawers, a drop-leaf table, or a desk whose top rises on columns.

Links: `body`; `drawer_0` and so on from the left; `leaf_right` and `leaf_left` with `support_right` and
`support_left`; `top` with `key_up` and `key_down`. Joints: `drawer_slide_0`; `leaf_hinge_right`,
`support_slide_right` and so on; `top_lift`, `key_press_up`.

A leaf hangs at rest; raised, it lies on a support that is drawn out of the frame under it. Friction holds a
drawer anywhere. Motors move the top of a standing desk and hold it.

Sizes are those of EN 527-1, EN 12521 and of shops: desks 1.0-1.6 m by 0.55-0.75 m and 0.72-0.76 m high, side
tables 0.40-0.60 m wide and 0.45-0.62 m high, drop-leaf tables 0.72-0.76 m high with leaves of 0.24-0.36 m,
standing desks from 0.65-0.72 m to 1.10-1.25 m with 30-38 mm/s.
"""

import math
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared import controls, furniture, require_suited
from artgen.categories.shared.finish import colors
from artgen.categories.shared.pulls import bar_pull, cup_pull, knob_pull
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["desk", "side", "leaf", "lift"]
"""A desk with drawers, a side table with a drawer, a drop-leaf table, or a standing desk."""

_HANDLES = {"knob": knob_pull, "bar": bar_pull, "cup": cup_pull}
_FINISH = furniture.boards("wood", "lacquer", "melamine", "decor")
_LEG, _METAL = furniture.leg_finishes(), furniture.hardware()
_EASE = furniture.EASE
_BAY = 0.115  # height of the case of drawers [m]
_APRON = 0.105  # height of the frame under a drop-leaf top [m]
_REST = 0.0012  # distance of a raised leaf from its supports [m]
_STEEL = ag.shades(*colors("powder_coat", "black white light_grey graphite"), color=0.03)
_LEAF = feel.Feel(damping=0.3, friction=0.2, effort=20.0)
_SUPPORT = feel.Feel(friction=3.0, damping=5.0, effort=60.0)


@ag.category(
    labels="body back top leg drawer front handle frame hinge leaf support column foot button case print",
    joints=(1, 4),
)
def table(
    *,
    style: Style = ag.choice({"desk": 0.35, "side": 0.2, "leaf": 0.2, "lift": 0.25}),
    columns: int = ag.by("style", desk={1: 0.3, 2: 0.35, 3: 0.35}, otherwise=1, doc="drawers side by side"),
    width: ag.Float = ag.by(
        "style",
        desk=ag.uniform(1.05, 1.45),
        side=ag.uniform(0.40, 0.58),
        leaf=ag.uniform(0.46, 0.72),
        lift=ag.uniform(1.15, 1.60),
        unit="m",
        within=(0.38, 1.8),
        doc="width of the top without leaves",
    ),
    depth: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.55, 0.68),
        side=ag.uniform(0.36, 0.46),
        leaf=ag.uniform(0.72, 0.90),
        lift=ag.uniform(0.62, 0.78),
        unit="m",
        within=(0.33, 1.0),
    ),
    height: ag.Float = ag.by(
        "style",
        side=ag.uniform(0.46, 0.62),
        lift=ag.uniform(0.66, 0.72),
        otherwise=ag.uniform(0.725, 0.760),
        unit="m",
        within=(0.40, 0.80),
        doc="height of the top, lowered",
    ),
    thick: ag.Float = ag.uniform(0.020, 0.028, "m", within=(0.018, 0.04), doc="thickness of the top"),
    leaf: ag.Float = ag.uniform(0.24, 0.34, "m", within=(0.2, 0.4), doc="width of a leaf"),
    travel: ag.Float = ag.uniform(0.42, 0.50, "m", within=(0.2, 0.52), doc="travel of a standing desk"),
    share: ag.Float = ag.uniform(0.55, 0.68, within=(0.3, 0.7), doc="travel of a drawer over its depth"),
    friction: ag.Float = ag.uniform(4.0, 8.0, "N", doc="friction of a drawer"),
    look: furniture.BoardLook = ag.choice("wood", "lacquer", "melamine", "decor", weights=(5, 2, 1, 2)),
    finish: ag.Material = _FINISH,
    leg: furniture.LegStyle = ag.choice("tapered", "splayed", "square", "metal"),
    leg_finish: ag.Material = _LEG,
    steel: ag.Material = _STEEL,
    metal: ag.Material = _METAL,
    grip: Literal["knob", "bar", "cup"] = ag.choice("knob", "bar", "cup"),
    handle: ag.Generator = ag.by("grip", _HANDLES),
) -> ag.Body:
    """Make a table with its drawers shut, its leaves down, or its top lowered."""
    require_suited(handle, "grip", grip, _HANDLES)
    if style == "lift":
        width = ag.require(width, width >= 0.6, "width of a standing desk must be >= 0.6 m")
        return _standing(width, depth, height, thick, travel, finish, steel)
    if style == "leaf":
        return _drop_leaf(width, depth, height, thick, leaf, finish)
    case = furniture.Carcass(
        width=width - 0.03,
        low=height - thick - _BAY,
        high=height - thick,
        front=-depth / 2 + 0.022,
        rear=depth / 2,
        thick=0.016,
        finish=finish,
        inside=finish,
    )
    spread = [
        -case.right + (2 * case.right + 0.016) * place / columns - 0.016 for place in range(columns + 1)
    ]
    walls = [case.partition(x + 0.008) for x in spread[1:-1]]
    body = ag.weld(
        *case.bodies(),
        *walls,
        *case.legs(leg, leg_finish),
        case.worktop(thick, finish, before=0.022, beside=0.015),
    )
    for column in range(columns):
        left, right = spread[column] + 0.016, spread[column + 1]
        bay = ag.Region((left, right), (case.front, case.behind), (case.floor, case.ceiling))
        pull = handle(finish=metal, name="drawer_handle", **({"room": right - left} if grip == "bar" else {}))
        drag = feel.Feel(friction=friction, damping=8.0, effort=80.0)
        slide = ag.Prismatic("drawer_slide", axis=-ag.Y, limits=(0, share * bay.y.size), feel=drag)
        body = body.install(Fitting.moving(_drawer(bay, finish, pull), slide).suffixed(f"_{column}"))
    return body


def _drawer(bay: ag.Region, finish: ag.Material, pull: ag.Body) -> ag.Body:
    """Make a drawer in its bay: its front, flush with the case, a box of thin boards, and its handle."""
    face = bay.shrink(FIT.reveal, front=0, back=0).with_(y=(bay.y.low, bay.y.low + 0.018))
    room = bay.shrink(left=0.008, right=0.008, bottom=0.006, top=0.022, front=0.0175, back=0.012)
    inner = room.shrink(0.0097, front=0.0, bottom=0.0, top=0.0)
    walls = [
        room.with_(x=(room.x.low, room.x.low + 0.010)),
        room.with_(x=(room.x.high - 0.010, room.x.high)),
        inner.with_(y=(inner.y.high, room.y.high - 0.0004)),
        inner.with_(z=(room.z.low + 0.0004, room.z.low + 0.006)).grow(back=0.0003),
    ]
    middle = face.anchor(y=-1)
    front = ag.part(face.box(bevel=_EASE), "front", finish, name="drawer")
    box = ag.part([wall.box() for wall in walls], "drawer", furniture.PLY)
    return ag.weld(front, box, pull.at(middle))


def _drop_leaf(
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    thick: ag.Scalar,
    leaf: ag.Scalar,
    finish: ag.Material,
) -> ag.Body:
    """Make a table with two hanging leaves, and the supports in its frame."""
    top, side, half = height - thick, width / 2 - 0.030, depth / 2 - 0.07
    board = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (top, height)).box(bevel=0.003)
    rails = ag.Region((side - 0.020, side), (-half + 0.002, half - 0.002), (top - _APRON, top + 0.0003))
    ends = ag.Region((-side + 0.001, side - 0.001), (half - 0.020, half), (top - _APRON, top + 0.0002))
    bar = ag.Region((0.02, side), (-0.016, 0.016), (top - _REST - 0.075, top - _REST))
    hole = bar.grow(FIT.running, top=0.01, right=0.01).box()
    rail = rails.box(bevel=_EASE) - hole
    legs = [
        ag.Region((x - 0.024, x + 0.024), (y - 0.024, y + 0.024), (0, top + 0.0005)).box(bevel=0.003)
        for x in (-side + 0.012, side - 0.012)
        for y in (-half + 0.012, half - 0.012)
    ]
    end = ends.box(bevel=_EASE)
    body = ag.weld(
        ag.part(board, "top", finish, name="body"),
        ag.part([rail, rail.mirror(ag.X), end, end.mirror(ag.Y)], "frame", finish),
        ag.part(legs, "leg", finish),
    )
    axle = ag.vector(width / 2 + 0.001, 0, top - 0.004)
    pin = ag.cylinder(0.0032, 0.05, axis=ag.Y, bevel=0.0006) | ag.box(0.008, 0.05, 0.0045).at(
        -0.0045, 0, 0.0018
    )
    pins = [pin.at(axle.x, y, axle.z) for y in (-0.3 * depth, 0.0, 0.3 * depth)]
    pins += [each.mirror(ag.X) for each in pins]
    body = ag.weld(body, ag.detail(pins, "hinge", ag.material("brass")))
    x, low = width / 2 + 0.005, top - 0.005
    flap = ag.Region((x, x + thick), (-depth / 2, depth / 2), (low - leaf, low)).box(bevel=0.003)
    knob = ag.cylinder(0.010, 0.020, axis=ag.X, bevel=0.003).at(side + 0.009, 0, bar.z.low + 0.016)
    tongue, raised = bar.box(bevel=_EASE), math.pi / 2
    for way, name in ((1, "right"), (-1, "left")):
        board, grip, inner = (each if way > 0 else each.mirror(ag.X) for each in (flap, knob, tongue))
        hold = ag.grasp_on(board, approach=ag.Z, closing=ag.X, depth=0.025)
        pivot = (way * axle.x, 0, axle.z)
        turn = ag.Revolute(
            f"leaf_hinge_{name}", axis=-way * ag.Y, pivot=pivot, limits=(0, raised), feel=_LEAF
        )
        body = body.attach(ag.part(board, "leaf", finish, name=f"leaf_{name}", grasp=hold), turn)
        draw = ag.grasp_on(grip, approach=-way * ag.X, closing=ag.Y, depth=0.014)
        support = ag.weld(
            ag.part(
                grip, "handle", ag.material("brass"), name=f"support_{name}", grasp=draw, when=turn > 1.55
            ),
            ag.part(inner, "support", ag.material("beech")),
        )
        limits = (0, ag.min_(0.62 * bar.x.size, 0.30))
        free = (turn > raised - 0.004).beyond(0.0155)
        slide = ag.Prismatic(
            f"support_slide_{name}", axis=way * ag.X, limits=limits, feel=_SUPPORT, needs=free
        )
        body = body.attach(support, slide)
    return body


def _standing(
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    thick: ag.Scalar,
    travel: ag.Scalar,
    finish: ag.Material,
    steel: ag.Material,
) -> ag.Body:
    """Make a desk whose top rises on two telescopic columns, with its two keys."""
    x, low = width / 2 - 0.20, height - thick - 0.030  # of the columns, and of the frame under the top
    feet, tubes, rods = [], [], []
    for side in (-1, 1):
        feet.append(
            ag.Region(
                (side * x - 0.035, side * x + 0.035), (-0.42 * depth, 0.42 * depth), (0.008, 0.034)
            ).box(bevel=0.006)
        )
        outer = ag.Region((side * x - 0.040, side * x + 0.040), (-0.030, 0.030), (0.033, low - 0.012))
        hollow = outer.shrink(0.0032, bottom=0.0, top=0.0).grow(top=0.01)
        tubes.append(outer.box(bevel=0.002) - hollow.shrink(bottom=0.03).box())
        rods.append(hollow.shrink(0.0012, bottom=0.035, top=0.0).with_(z=(0.075, low + 0.001)).box())
    pads = [
        ag.cylinder(0.016, 0.009, bevel=0.001).at(side * x, y * 0.38 * depth, 0.0045)
        for side in (-1, 1)
        for y in (-1, 1)
    ]
    beam = ag.Region((-x, x), (0.026, 0.046), (low - 0.16, low - 0.10)).box(bevel=0.002)
    base = ag.weld(
        ag.part(
            [*feet, *tubes, beam],
            "column",
            steel.with_(name=f"{steel.name}_column", density=2600.0),
            name="body",
        ),
        ag.part(pads, "foot", ag.material("rubber")),
    )
    board = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (height - thick, height)).box(
        bevel=0.003
    )
    rails = [
        ag.Region(
            (side * x - 0.036, side * x + 0.036),
            (-0.36 * depth, 0.36 * depth),
            (low, height - thick + 0.0002),
        ).box(bevel=0.002)
        for side in (-1, 1)
    ]
    long = ag.Region((-x, x), (-0.02, 0.02), (low + 0.004, height - thick - 0.002)).box()
    light = steel.with_(name=f"{steel.name}_inner", density=1500.0)
    top = ag.weld(ag.part(board, "top", finish, name="top"), ag.part([*rails, long, *rods], "frame", light))
    box = ag.Region(
        (width / 2 - 0.26, width / 2 - 0.14),
        (-depth / 2 + 0.004, -depth / 2 + 0.05),
        (height - thick - 0.026, height - thick + 0.0002),
    )
    top = ag.weld(top, ag.part(box.box(bevel=0.002), "case", ag.material("black_abs")))
    ink = controls.LIGHT_INK
    for name, place in (("down", -0.024), ("up", 0.024)):
        cap = controls.button_cap(
            finish=ag.material("black_abs"),
            shape="square",
            width=0.013,
            proud=0.0045,
            deep=0.006,
            icon=f"arrow_{name}",
            ink=ink,
            name="key",
        )
        key = Fitting.moving(
            cap,
            controls.button_press("key_press", travel=0.0025),
            cut=controls.button_hole(0.013, through=0.012),
        )
        top = top.install(
            key.suffixed(f"_{name}"),
            at=(width / 2 - 0.20 + place, -depth / 2 + 0.004, height - thick - 0.013),
        )
    drag = feel.Feel(damping=400.0, friction=1.5 * top.weight(), effort=1200.0, velocity=0.038)
    lift = ag.Prismatic("top_lift", axis=ag.Z, limits=(0, travel), feel=drag, driven="two motors")
    return base.attach(top, lift)
