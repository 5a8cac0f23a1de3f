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
from artgen.categories.trashcan import bins, finish, flaps, hoods, lids

Style = Literal["pedal", "lift", "swing", "ball", "disc", "butterfly", "touch", "open"]

_STYLES = {"ball": 0.06, "touch": 0.09, "lift": 0.13, "swing": 0.13, "butterfly": 0.11, "disc": 0.07,
           "pedal": 0.28, "open": 0.13}  # fmt: skip
_TAPERED = ("lift", "swing", "disc", "open")
_PLANS: dict[str, tuple[str, ...]] = {
    "swing": ("round", "square", "rectangle"),
    "ball": ("round",),
    "disc": ("round", "square", "rectangle"),
    "butterfly": ("square", "rectangle"),  # flaps need straight sides for their hinges
    "open": ("round", "square", "rectangle"),
}


@ag.category(
    labels="body base rim foot hinge hood lid pedal rod button bucket handle ring bag screw print "
    "rating_plate",
    joints=(1, 5),
)
def trashcan(
    *,
    style: Style = ag.choice(_STYLES),
    size: Literal["small", "medium", "large"] = ag.by(
        "style",
        pedal={"small": 0.25, "medium": 0.35, "large": 0.4},
        lift={"small": 0.3, "medium": 0.4, "large": 0.3},
        open={"small": 0.4, "medium": 0.6},
        ball="large",
        otherwise={"medium": 0.5, "large": 0.5},
        doc="volume class: 3-5, 10-20 or 30-50 liters",
    ),
    plan: bins.Plan = ag.by(
        "style",
        pedal={"round": 0.4, "square": 0.15, "rectangle": 0.25, "half_round": 0.2},
        lift={"round": 0.4, "square": 0.2, "rectangle": 0.2, "half_round": 0.2},
        swing={"round": 0.3, "square": 0.3, "rectangle": 0.4},
        ball="round",
        disc={"round": 0.65, "square": 0.35},
        butterfly={"square": 0.3, "rectangle": 0.7},
        touch={"round": 0.55, "square": 0.2, "rectangle": 0.25},
        open={"round": 0.55, "square": 0.25, "rectangle": 0.2},
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
        pedal={"steel": 0.45, "coated": 0.38, "plastic": 0.17},
        lift={"steel": 0.2, "coated": 0.4, "plastic": 0.4},
        swing={"steel": 0.2, "coated": 0.2, "plastic": 0.6},
        ball={"steel": 0.5, "coated": 0.5},
        disc={"steel": 0.4, "coated": 0.35, "plastic": 0.25},
        butterfly={"steel": 0.7, "coated": 0.3},
        touch={"steel": 0.5, "coated": 0.5},
        open={"coated": 0.2, "plastic": 0.3, "wicker": 0.25, "mesh": 0.25},
    ),
    finish: ag.Material = ag.by(
        "skin",
        steel=finish.STEELS,
        coated=finish.COATED,
        plastic=finish.PLASTICS,
        wicker=finish.WICKER,
        mesh=finish.MESH,
    ),
    lid_finish: Literal["same", "plastic", "steel"] = ag.by(
        "skin",
        steel={"same": 0.7, "plastic": 0.3},
        coated={"same": 0.6, "plastic": 0.15, "steel": 0.25},
        otherwise={"same": 0.7, "plastic": 0.3},
    ),
    trim: ag.Material = ag.choice(finish.TRIMS),
    dress: bins.Dress = ag.choice({"plain": 0.3, "base_band": 0.35, "beads": 0.15, "ring": 0.2}),
    lid_style: bins.LidStyle = ag.by(
        "plan",
        half_round=ag.choice("flat", "stepped"),
        otherwise={"flat": 0.4, "domed": 0.35, "stepped": 0.25},
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
    grip: lids.Grip = ag.by(
        "style",
        lift=ag.by("lid_style", domed="lip", otherwise=ag.choice("lip", "bar", "knob")),
        otherwise="none",
    ),
    stepped_on: bool = ag.by("style", butterfly={False: 0.3, True: 0.7}, otherwise=False),
    crank: ag.Float = ag.uniform(0.014, 0.018, "m", doc="length of the lid's crank", within=(0.013, 0.022)),
    pedal_travel: ag.Float = ag.uniform(0.034, 0.046, "m", doc="travel of foot plate", within=(0.025, 0.06)),
    pedal_width: ag.Float = ag.uniform(0.062, 0.092, "m", within=(0.045, 0.14)),
    pedal_preload: ag.Float = ag.uniform(9.5, 11.5, "N", doc="spring force at the foot plate at rest"),
    pedal_force: ag.Float = ag.uniform(13.0, 16.0, "N", doc="spring force at the pressed foot plate"),
    soft_close: bool = ag.choice(False, True),
    hinge_friction: ag.Float = ag.uniform(0.015, 0.04, "N m"),
    carry: bins.Carry = ag.by(
        "style",
        pedal={"loop": 0.4, "bail": 0.6},
        lift={"none": 0.2, "loop": 0.4, "bail": 0.4},
        touch=ag.choice("loop", "bail"),
        butterfly="loop",
        open=ag.by("skin", wicker="bail", otherwise="none"),
        otherwise="none",
        doc="carrier of the inner bucket; none for no bucket",
    ),
    bucket_finish: ag.Material = finish.BUCKETS,
    bagged: bool = ag.by(
        "style", open=ag.by("skin", wicker=False, otherwise=ag.choice(False, True)), otherwise=False
    ),
    sort: bins.Sort = ag.by(
        "style",
        swing={"none": 0.5, "recycling": 0.2, "paper": 0.1, "plastic": 0.1, "glass": 0.1},
        open={"none": 0.6, "recycling": 0.25, "paper": 0.15},
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
    ag.require(
        style != "butterfly" or carry != "bail",
        "the flaps of style=butterfly would strike a bail: carry must be loop",
    )
    across = width * 0.86 if plan == "rectangle" else width
    depth = across if plan == "round" else across * aspect
    crown: dict[str, ag.Scalar] = {  # height of the parts above the rim [m]
        "swing": 0.28 * across,
        "ball": 0.5 * across + 0.055,
        "disc": 0.026,
        "open": 0.016,
    }
    can = bins.Can(
        plan,
        across,
        depth,
        height - crown.get(style, bins.GAP + lids.THICK),
        corner=ag.min_(corner, 0.4 * ag.min_(across, depth)),
        taper=taper if style in _TAPERED else 0.0,
    )
    design = bins.Design(
        can=can,
        finish=finish,
        lid_finish=lid_finish,
        trim=trim,
        dress=dress,
        carry=carry,
        bucket=bucket_finish,
        maker=maker,
        model=model,
        lid_style=lid_style,
        opening=lid_open,
        friction=hinge_friction,
        damper=soft_close,
        crank=crank,
        travel=pedal_travel,
        pedal_width=pedal_width,
        preload=pedal_preload,
        force=pedal_force,
    )
    match style:
        case "pedal":
            body = lids.pedal_bin(design)
        case "lift":
            body = lids.lift_bin(design, grip)
        case "touch":
            body = lids.touch_bin(design)
        case "butterfly":
            body = flaps.butterfly_bin(design, stepped_on=stepped_on)
        case "open":
            body = hoods.open_bin(design, bagged=bagged)
        case _:
            body = hoods.hooded_bin(design, style)
    return ag.weld(body, *bins.prints(design, sort, named=skin not in ("wicker", "mesh")))
