"""A waste bin: with a pedal, a lift-up lid, a lid that swings, rolls or flips, two flaps, a catch, or open.

Links: `body`; `lid`, or `lid_left` and `lid_right` of a butterfly bin; `pedal` and the `rod` that it lifts;
`button` of a touch bin; `hood` under a turning lid, which lifts off for a change of the bag; `bucket` with
its `handle`; the `ring` that holds the bag of an open bin. Joints: `lid_hinge` (with `_left` and `_right` for
two flaps), `pedal_hinge`, `rod_slide`, `button_slide`, `hood_lift`, `ring_lift`, `bucket_slide`,
`handle_hinge`.

A pedal turns the lid by levers from foot plate to pin, from pin to rod, and from rod to the lid's axis; their
lengths give the ratio of the coupling. A foot presses with 15 to 60 N, against the weight of the lid times
that ratio and a spring that keeps the pedal up. A bucket lifts out after the lid is open beyond the angle
that clears it, which follows from the hinge.

Sizes are those of household bins of 3 to 50 liters (EKO, Brabantia, simplehuman and Rotho catalogs):
0.17-0.21 m wide and 0.25-0.31 m high for 3-5 l, up to 0.34 m wide and 0.72 m high for 40-50 l.
"""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.trashcan.bins import Can, Plan
from artgen.categories.trashcan.finish import (
    BUCKET_WEIGHTS,
    BUCKETS,
    COATED,
    COATED_WEIGHTS,
    PLASTIC_WEIGHTS,
    PLASTICS,
    STEEL_WEIGHTS,
    STEELS,
    TRIMS,
    WALL,
    WEAVES,
    Sort,
    lid_of,
    maker_mark,
    sort_mark,
)
from artgen.categories.trashcan.kinds import (
    THICK,
    Carry,
    Draft,
    Foot,
    Lid,
    butterfly_bin,
    hooded_bin,
    lift_bin,
    open_bin,
    pedal_bin,
    touch_bin,
)
from artgen.categories.trashcan.lids import GAP, Grip, LidStyle
from artgen.categories.trashcan.shells import Dress, Looks

Style = Literal["pedal", "lift", "swing", "ball", "disc", "butterfly", "touch", "open"]

_TAPERED = ("lift", "swing", "disc", "open")
_PLANS: dict[str, tuple[str, ...]] = {
    "swing": ("round", "square", "rectangle"),
    "ball": ("round",),
    "disc": ("round", "square", "rectangle"),
    "butterfly": ("square", "rectangle"),  # flaps need straight sides for their hinges
    "open": ("round", "square", "rectangle"),
}
_DARK = ag.material("black_abs")


@ag.category(
    labels=(
        "body",
        "base",
        "rim",
        "foot",
        "hinge",
        "hood",
        "lid",
        "pedal",
        "rod",
        "button",
        "bucket",
        "handle",
        "ring",
        "bag",
        "screw",
        "print",
        "rating_plate",
    ),
    joints=(1, 5),
)
def trashcan(
    *,
    style: Style = ag.choice(
        "ball",
        "touch",
        "lift",
        "swing",
        "butterfly",
        "disc",
        "pedal",
        "open",
        weights=(0.06, 0.09, 0.13, 0.13, 0.11, 0.07, 0.28, 0.13),
    ),
    size: Literal["small", "medium", "large"] = ag.by(
        "style",
        pedal=ag.choice("small", "medium", "large", weights=(0.25, 0.35, 0.4)),
        lift=ag.choice("small", "medium", "large", weights=(0.3, 0.4, 0.3)),
        open=ag.choice("small", "medium", weights=(0.4, 0.6)),
        ball="large",
        otherwise=ag.choice("medium", "large", weights=(0.5, 0.5)),
        doc="volume class: 3-5, 10-20 or 30-50 liters",
    ),
    plan: Plan = ag.by(
        "style",
        pedal=ag.choice("round", "square", "rectangle", "half_round", weights=(0.4, 0.15, 0.25, 0.2)),
        lift=ag.choice("round", "square", "rectangle", "half_round", weights=(0.4, 0.2, 0.2, 0.2)),
        swing=ag.choice("round", "square", "rectangle", weights=(0.3, 0.3, 0.4)),
        ball="round",
        disc=ag.choice("round", "square", weights=(0.65, 0.35)),
        butterfly=ag.choice("square", "rectangle", weights=(0.3, 0.7)),
        touch=ag.choice("round", "square", "rectangle", weights=(0.55, 0.2, 0.25)),
        open=ag.choice("round", "square", "rectangle", weights=(0.55, 0.25, 0.2)),
    ),
    width: ag.Float = ag.by(
        "size",
        small=ag.uniform(0.175, 0.215),
        medium=ag.uniform(0.235, 0.285),
        large=ag.uniform(0.285, 0.330),
        unit="m",
        within=(0.15, 0.45),
        doc="width at the rim; a rectangular bin is narrower than others of its volume",
    ),
    aspect: ag.Float = ag.by(
        "plan",
        rectangle=ag.uniform(1.18, 1.36),
        half_round=ag.uniform(0.84, 0.96),
        otherwise=1.0,
        doc="depth, as a share of the width",
        within=(0.8, 1.6),
    ),
    height: ag.Float = ag.by(
        "size",
        small=ag.uniform(0.26, 0.32),
        medium=ag.uniform(0.36, 0.50),
        large=ag.uniform(0.58, 0.74),
        unit="m",
        doc="overall height of the closed bin",
        within=(0.24, 0.85),
    ),
    corner: ag.Float = ag.uniform(
        0.020, 0.045, "m", doc="radius of the plan's corners", within=(0.008, 0.06)
    ),
    taper: ag.Float = ag.by(
        "style",
        lift=ag.uniform(0.0, 0.12),
        swing=ag.uniform(0.04, 0.16),
        disc=ag.uniform(0.0, 0.12),
        open=ag.uniform(0.06, 0.24),
        otherwise=0.0,
        doc="share by which the foot of a tapered bin is smaller than the rim",
        within=(0.0, 0.35),
    ),
    skin: Literal["steel", "coated", "plastic", "wicker", "mesh"] = ag.by(
        "style",
        pedal=ag.choice("steel", "coated", "plastic", weights=(0.45, 0.38, 0.17)),
        lift=ag.choice("steel", "coated", "plastic", weights=(0.2, 0.4, 0.4)),
        swing=ag.choice("steel", "coated", "plastic", weights=(0.2, 0.2, 0.6)),
        ball=ag.choice("steel", "coated", weights=(0.5, 0.5)),
        disc=ag.choice("steel", "coated", "plastic", weights=(0.4, 0.35, 0.25)),
        butterfly=ag.choice("steel", "coated", weights=(0.7, 0.3)),
        touch=ag.choice("steel", "coated", weights=(0.5, 0.5)),
        open=ag.choice("coated", "plastic", "wicker", "mesh", weights=(0.2, 0.3, 0.25, 0.25)),
    ),
    finish: ag.Material = ag.by(
        "skin",
        steel=ag.shades(*STEELS, weights=STEEL_WEIGHTS, color=0.04),
        coated=ag.shades(*COATED, weights=COATED_WEIGHTS),
        plastic=ag.shades(*PLASTICS, weights=PLASTIC_WEIGHTS),
        wicker=ag.shades(*WEAVES[:2]),
        mesh=ag.shades(*WEAVES[2:], color=0.04),
    ),
    lid_finish: Literal["same", "plastic", "steel"] = ag.by(
        "skin",
        steel=ag.choice("same", "plastic", weights=(0.7, 0.3)),
        coated=ag.choice("same", "plastic", "steel", weights=(0.6, 0.15, 0.25)),
        otherwise=ag.choice("same", "plastic", weights=(0.7, 0.3)),
    ),
    trim: ag.Material = ag.choice(*TRIMS, weights=(0.55, 0.2, 0.1, 0.15)),
    dress: Dress = ag.choice("plain", "base_band", "beads", "ring", weights=(0.3, 0.35, 0.15, 0.2)),
    lid_style: LidStyle = ag.by(
        "plan",
        half_round=ag.choice("flat", "stepped"),
        otherwise=ag.choice("flat", "domed", "stepped", weights=(0.4, 0.35, 0.25)),
    ),
    lid_open: ag.Float = ag.by(
        "style",
        pedal=ag.uniform(1.46, 1.56),
        lift=ag.uniform(1.44, 1.62),
        swing=ag.uniform(1.05, 1.2),
        ball=ag.uniform(0.9, 1.0),
        disc=ag.uniform(1.45, 1.57),
        butterfly=ag.uniform(1.42, 1.5),
        touch=ag.uniform(1.44, 1.54),
        otherwise=0.0,
        unit="rad",
        doc="opening angle of the lid; a lid in a hood turns both ways",
    ),
    grip: Grip = ag.by(
        "style",
        lift=ag.by("lid_style", domed="lip", otherwise=ag.choice("lip", "bar", "knob")),
        otherwise="none",
    ),
    stepped_on: bool = ag.by("style", butterfly=ag.choice(False, True, weights=(0.3, 0.7)), otherwise=False),
    crank: ag.Float = ag.uniform(0.014, 0.018, "m", doc="length of the lid's crank", within=(0.013, 0.022)),
    pedal_travel: ag.Float = ag.uniform(0.034, 0.046, "m", doc="travel of foot plate", within=(0.025, 0.06)),
    pedal_width: ag.Float = ag.uniform(0.062, 0.092, "m", within=(0.045, 0.14)),
    pedal_preload: ag.Float = ag.uniform(9.5, 11.5, "N", doc="spring force at the foot plate at rest"),
    pedal_force: ag.Float = ag.uniform(13.0, 16.0, "N", doc="spring force at the pressed foot plate"),
    soft_close: bool = ag.choice(False, True),
    hinge_friction: ag.Float = ag.uniform(0.015, 0.04, "N m"),
    carry: Carry = ag.by(
        "style",
        pedal=ag.choice("loop", "bail", weights=(0.4, 0.6)),
        lift=ag.choice("none", "loop", "bail", weights=(0.2, 0.4, 0.4)),
        touch=ag.choice("loop", "bail"),
        butterfly="loop",
        open=ag.by("skin", wicker="bail", otherwise="none"),
        otherwise="none",
        doc="carrier of the inner bucket; none for no bucket",
    ),
    bucket_finish: ag.Material = ag.shades(*BUCKETS, weights=BUCKET_WEIGHTS),
    bagged: bool = ag.by(
        "style", open=ag.by("skin", wicker=False, otherwise=ag.choice(False, True)), otherwise=False
    ),
    sort: Sort = ag.by(
        "style",
        swing=ag.choice("none", "recycling", "paper", "plastic", "glass", weights=(0.5, 0.2, 0.1, 0.1, 0.1)),
        open=ag.choice("none", "recycling", "paper", weights=(0.6, 0.25, 0.15)),
        otherwise="none",
    ),
    maker: str = ag.choice(*details.BRANDS),
    model: int = ag.count(100, 989),
) -> ag.Body:
    """Make a waste bin: lid, flaps or none, pedal, button, inner bucket."""
    ag.require(
        plan in _PLANS.get(style, ("round", "square", "rectangle", "half_round")),
        f"plan={plan} is not allowed with style={style}: plan must be {' or '.join(_PLANS.get(style, ()))}",
    )
    across = width * 0.86 if plan == "rectangle" else width
    depth = across if plan == "round" else across * aspect
    crown: dict[str, ag.Scalar] = {
        "swing": 0.28 * across,
        "ball": 0.5 * across + 0.055,
        "disc": 0.026,
        "open": 0.016,
    }
    can = Can(
        plan,
        across,
        depth,
        height - crown.get(style, GAP + THICK),
        corner=ag.min_(corner, 0.4 * ag.min_(across, depth)),
        sheet=WALL,
        taper=taper if style in _TAPERED else 0.0,
    )
    ag.require(
        style != "butterfly" or carry != "bail",
        "the flaps of style=butterfly would strike a bail: carry must be loop",
    )
    plastic = _DARK if trim.base_metalness > 0.5 else trim
    shown = {"same": finish, "plastic": plastic, "steel": STEELS[0]}[lid_finish]
    looks = Looks(finish, lid_of(shown), trim, ag.material("chrome"), plastic)
    draft = Draft(can, looks, dress, carry, bucket_finish, maker, model)
    lid = Lid(lid_style, lid_open, hinge_friction, 0.16 if soft_close else 0.05)
    foot = Foot(crank, pedal_travel, pedal_width, pedal_preload, pedal_force)
    match style:
        case "pedal":
            body = pedal_bin(draft, lid, foot)
        case "lift":
            body = lift_bin(draft, lid, grip)
        case "touch":
            body = touch_bin(draft, lid)
        case "butterfly":
            body = butterfly_bin(draft, lid, foot if stepped_on else None)
        case "open":
            body = open_bin(draft, bagged=bagged)
        case _:
            body = hooded_bin(
                draft, style, opening=lid_open, rise=0.17 * across if style == "swing" else 0.024
            )
    marks = sort_mark(can, sort, z=0.55 * can.top, finish=finish)
    if skin not in ("wicker", "mesh"):
        marks.append(maker_mark(can, maker, z=0.09, finish=finish))
    return ag.weld(body, *marks)
