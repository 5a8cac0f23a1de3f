"""A knife for a pocket or a tool bag: folding, hunter's, with a ring, multi-tool, cutter or utility knife.

Links: `handle`, `blade`; a knife with a ring has the `ring`, a multi-tool the `opener` and the `lifter`, a
cutter with a screw the `lock`. Joints: `blade_hinge`, `opener_hinge`, `lifter_hinge`; `blade_slide` of
cutters and utility knives; `ring_turn`, `lock_turn`. At 0 the blade is in its handle, the ring lets it pass,
and the screw is tight. No file format lets a screw change the friction of a slide: it is that of a screw half
loosened.

Folding knives stand on the back of their handle, so that fingers reach the back of a blade; cutters lie. A
back spring holds a blade closed and open: it snaps over between both. Friction holds a blade with a ring; the
ring turns only while that blade is at one of its ends, and holds it there. The blade of a cutter clicks in
steps of 5 mm, or is held by a screw; that of a utility knife has four positions.

Sizes are those of Buck, Spyderco, Opinel, Victorinox, Olfa and Stanley catalogs. Folding knives are
104-126 mm long closed, with blades of 80-100 mm and 2.9 mm; they weigh 110-160 g, and 170-215 g with bolsters
of brass. Knives with a ring No. 7-10 have blades of 75-100 mm and 35-75 g; multi-tools of 84-93 mm weigh
50-80 g. Cutters have blades of 9 by 0.4 mm or 18 by 0.5 mm, 130-170 mm and 20-110 g; utility knives 150-166
mm and 120-220 g with blades of 61 by 19 by 0.6 mm. A blade turns over with 0.12-0.35 N m: 3-8 N at a nail
nick 40 mm from its pivot.
"""

import math
from functools import reduce
from operator import or_
from typing import Literal

import numpy as np

import artgen as ag
from artgen import details, feel
from artgen.categories.knife.folding import (
    BLADE,
    STEEL,
    Point,
    multi_tool,
    pocket_knife,
    print_mark,
    ringed_knife,
)  # fmt: skip
from artgen.categories.shared import polar, require_size
from artgen.categories.shared.finish import casting, colors, recess
from artgen.nodes.fitting import FIT

Style = Literal["folding", "hunter", "ring", "multi", "cutter", "utility"]
"""A folding knife with a clip, a hunter's one with bolsters, one with a locking ring, a multi-tool with
openers, a cutter with blades to snap off, or a utility knife with a trapezoid blade."""

_GROUND = ag.material("chrome").with_(name="ground_edge", specular_roughness=0.22, density=7800.0)
_G10 = ag.material("black_abs").with_(name="g10", density=1850.0)
_CELLIDOR = ag.colored("glossy_plastic", "red").with_(name="cellidor_red", base_color=(0.42, 0.012, 0.014))
_SLIDE = feel.Feel(friction=1.0, damping=4.0, armature=0.03, effort=25.0)
_LOCK = feel.Feel(friction=0.05, damping=0.002, armature=1e-5, effort=0.5)
_G10S = (
    _G10,
    *(
        made.with_(name=f"g10_{made.name}", density=1850.0)
        for made in colors("abs", "olive sand orange navy slate")
    ),
)
_FINISHES = {
    "folding": ag.shades(*_G10S, "black_anodised", "aluminium", color=0.04),
    "hunter": ag.shades("walnut", "mahogany", "oak", "beech", color=0.08),
    "ring": ag.shades("beech", "oak", "walnut", "maple", color=0.08),
    "multi": ag.shades(
        _CELLIDOR, *colors("glossy_plastic", "black navy forest"), "aluminium", weights=(5, 1, 1, 1, 1),
        color=0.03,
    ),
    "cutter": ag.shades(*colors("abs", "yellow black orange sky red graphite"), color=0.04),
    "utility": ag.shades(*colors("powder_coat", "silver graphite yellow orange blue red"), color=0.04),
}  # fmt: skip
_TRIMS = {
    "hunter": ag.choice("brass", "satin_nickel"),
    "cutter": ag.choice(*colors("abs", "black graphite red")),
    "utility": ag.choice(*colors("abs", "black yellow red")),
}

_LEAST = {"folding": 0.095, "hunter": 0.095, "ring": 0.09, "utility": 0.145}
"""Least length of a handle by style [m]."""


@ag.category(
    labels="handle liner bolster blade edge pivot lock slider clip spring opener lifter ring cap print screw",
    joints=(1, 3),
)
def knife(
    *,
    style: Style = ag.choice(
        {"folding": 0.22, "hunter": 0.15, "ring": 0.15, "multi": 0.16, "cutter": 0.18, "utility": 0.14}
    ),
    length: ag.Float = ag.by(
        "style",
        folding=ag.uniform(0.104, 0.124),
        hunter=ag.uniform(0.104, 0.126),
        ring=ag.uniform(0.094, 0.128),
        multi=ag.uniform(0.084, 0.093),
        cutter=ag.by("wide", {9: ag.uniform(0.130, 0.160), 18: ag.uniform(0.148, 0.170)}),
        utility=ag.uniform(0.150, 0.166),
        unit="m",
        within=(0.08, 0.20),
        doc="length of the handle",
    ),
    point: Point = ag.by(
        "style",
        folding={"drop": 0.4, "tanto": 0.25, "clip": 0.2, "sheepsfoot": 0.15},
        hunter={"clip": 0.7, "drop": 0.3},
        ring={"clip": 0.8, "drop": 0.2},
        otherwise="drop",
    ),
    opened: Literal["stud", "nail"] = ag.by(
        "style", folding={"stud": 0.75, "nail": 0.25}, otherwise="nail", doc="what a thumb opens"
    ),
    wide: Literal[9, 18] = ag.by(
        "style",
        cutter={9: 0.45, 18: 0.55},
        otherwise=18,
        doc="width of the blade of a cutter, in millimetres",
    ),
    lock: Literal["ratchet", "screw"] = ag.by(
        "style",
        cutter=ag.by("wide", {18: {"ratchet": 0.6, "screw": 0.4}, 9: "ratchet"}),
        otherwise="ratchet",
        doc="what holds the blade of a cutter",
    ),
    torque: ag.Float = ag.uniform(
        0.12, 0.35, "N m", within=(0.05, 0.6), doc="torque that turns a blade over"
    ),
    click: ag.Float = ag.uniform(4.0, 9.0, "N", within=(2.0, 15.0), doc="force of a click of a slider"),
    coated: bool = ag.by("style", folding={True: 0.3, False: 0.7}, otherwise=False, doc="a black blade"),
    finish: ag.Material = ag.by("style", _FINISHES),
    trim: ag.Material = ag.by("style", _TRIMS, otherwise=STEEL, doc="bolsters, or slider and cap"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a knife whose blade is in its handle."""
    length = require_size(length, (_LEAST.get(style, 0.08), 0.20), f"length of a {style} knife")
    match style:
        case "cutter":
            least = 0.128 if wide == 9 else 0.148
            length = ag.require(length, length >= least, f"a cutter of {wide} mm must be {least:g} m long")
            return _cutter(length, wide, click, finish, trim, maker, screwed=lock == "screw")
        case "utility":
            return _utility(length, click, finish, trim, maker)
        case "ring":
            return ringed_knife(length, point, torque, finish, maker)
        case "multi":
            return multi_tool(length, torque, finish, maker)
    return pocket_knife(
        length, point, opened, torque, finish, trim if style == "hunter" else None, maker, coated=coated
    )


def _cutter(
    length: ag.Scalar,
    wide: int,
    click: ag.Scalar,
    finish: ag.Material,
    trim: ag.Material,
    maker: str,
    *,
    screwed: bool,
) -> ag.Body:
    """Make a cutter that lies: its blade of segments slides to the right, with a slider on top."""
    small = wide == 9
    broad, tall = (0.0185, 0.0105) if small else (0.0290, 0.0150)
    long, travel, pitch, sheet = (0.080, 0.045, 0.0050, 0.0004) if small else (0.100, 0.060, 0.0100, 0.0005)
    mid, top = 0.55 * tall, tall  # height of the blade, and of the upper face [m]
    front = length / 2  # of the nose
    steel = 1e-3 * wide
    grip = front - (0.016 if small else 0.020)
    body_line = [
        (-front, -0.42 * broad), (-front, 0.42 * broad), (-front + 0.006, broad / 2),
        (grip - 0.022, broad / 2), (grip, 0.40 * broad), (grip, -0.40 * broad),
        (grip - 0.018, -broad / 2), (-front + 0.006, -broad / 2),
    ]  # fmt: skip
    case = ag.extrude(ag.polygon(body_line, radius=0.0022), tall, bevel=0.0014).at(z=tall / 2)
    nose_half = steel / 2 + 0.0014
    nose_line = [
        (grip - 0.012, -nose_half),
        (front, -nose_half),
        (front - 0.55 * steel, nose_half),
        (grip - 0.012, nose_half),
    ]
    nose = ag.extrude(ag.polygon(nose_line), 0.0044, bevel=0.0004).at(z=mid)
    channel = ag.Region(
        (-front + 0.010, front + 0.01),
        (-steel / 2 - 0.0004, steel / 2 + 0.0004),
        (mid - 0.0008, mid + 0.0008),
    )
    start = front - 0.002 - long + 0.006  # of the neck of the slider along x [m]
    neck = 0.0022 if small else 0.0030
    slit = ag.Region(
        (start - 0.0068, start + travel + 0.0068), (-neck - 0.0004, neck + 0.0004), (mid, top + 0.01)
    )
    cut = channel.box() | slit.box()
    light = casting(finish, 0.72)
    steps = [grip - 0.026 - 0.0032 * number for number in range(7)]
    grooves = [
        ag.box(0.0012, 0.0003, 0.55 * tall).at(x, side * broad / 2, tall / 2)
        for x in steps
        for side in (-1, 1)
    ]
    cap = ag.Region(
        (-front - 0.0030, -front + 0.009), (-0.40 * broad, 0.40 * broad), (0.0010, top - 0.0010)
    ).box(bevel=0.0012)
    body = ag.weld(
        ag.part(case - cut, "handle", light, name="handle"),
        ag.part(nose - cut, "bolster", STEEL),
        ag.part(cap, "cap", trim),
        print_mark(
            maker, ((start - 0.003 - front) / 2, 0, top), (start + front - 0.034, 0.0046), finish
        ).rotate(ag.X, -math.pi / 2, about=(0, 0, top)),
        ag.detail(grooves, "handle", recess(finish)),
    )
    tip, lean = front - 0.002, 0.58 * steel
    flat = [(tip - long, -steel / 2), (tip, -steel / 2), (tip - lean, steel / 2), (tip - long, steel / 2)]
    blade = ag.extrude(ag.polygon(flat), sheet).at(z=mid)
    count = int(long / pitch) - 2
    line = [(0.0, -steel / 2), (0.0003, -steel / 2), (0.0003 - lean, steel / 2), (-lean, steel / 2)]
    scores = reduce(or_, (ag.polygon(line).at(tip - (number + 1) * pitch) for number in range(count)))
    lines = details.engraved(
        scores, (0, 0, mid + sheet / 2), material=BLADE, facing=ag.Z, up=ag.Y, label="edge"
    )
    pad = 0.0165 if small else 0.0220
    thumb = ag.Region(
        (start - pad / 2, start + pad / 2), (-0.30 * broad, 0.30 * broad), (top + FIT.sliding, top + 0.0050)
    )
    stem = ag.Region((start - 0.0060, start + 0.0060), (-neck, neck), (mid - 0.0004, top + 0.0010)).box()
    hold = ag.grasp_on(thumb.box(), approach=-ag.Z, closing=ag.Y, depth=0.0040)
    ribs = [
        ag.box(0.0008, 0.50 * broad, 0.0008).at(start + (n - 2.5) * 0.0022, 0, top + 0.0052) for n in range(6)
    ]
    slider = [ag.part([thumb.box(bevel=0.0010), stem], "slider", trim, name="blade", grasp=hold)]
    if not screwed:
        slider.append(ag.detail(ribs, "slider", trim))
    sliding = ag.weld(*slider, ag.part(blade, "blade", BLADE), lines)
    clicks = feel.detents(tuple(np.arange(0.0, travel + 1e-6, 0.005)), click)
    if not screwed:
        slide = ag.Prismatic("blade_slide", axis=ag.X, limits=(0, travel), detents=clicks, feel=_SLIDE)
        return body.attach(sliding, slide).at(0.0015)
    turn = ag.Revolute("lock_turn", axis=ag.Z, pivot=(start, 0, 0), limits=(0, 1.5), feel=_LOCK)
    slide = ag.Prismatic("blade_slide", axis=ag.X, limits=(0, travel), friction=8.0, feel=_SLIDE)
    wheel = ag.cylinder(0.0078, 0.0064, bevel=0.0008).at(start, 0, top + 0.0050 + FIT.sliding + 0.0032)
    squeeze = ag.grasp_on(wheel, approach=-ag.Z, closing=ag.Y, depth=0.0055)
    knurl = ag.extrude(_star(24, 0.0082, 0.0006), 0.0040).at(start, 0, top + 0.0050 + FIT.sliding + 0.0032)
    knob = ag.weld(ag.part(wheel, "lock", trim, name="lock", grasp=squeeze), ag.detail(knurl, "lock", trim))
    return body.attach(sliding.attach(knob, turn), slide).at(0.0015)


def _star(count: int, radius: float, deep: float) -> ag.Profile:
    """Make the outline of a knurled wheel."""
    return polar([radius, radius - deep] * count)


def _utility(
    length: ag.Scalar, click: ag.Scalar, finish: ag.Material, trim: ag.Material, maker: str
) -> ag.Body:
    """Make a utility knife of cast zinc that stands on its belly: its blade slides to the right."""
    half, thick, travel = length / 2, 0.0215, 0.021
    line = [
        (-half, 0.0070), (-half + 0.004, 0.0016), (-half + 0.018, 0.0), (-0.030, 0.0012), (-0.004, 0.0042),
        (0.018, 0.0042), (half - 0.032, 0.0016), (half - 0.006, 0.0020), (half, 0.0050),
        (half - 0.003, 0.0262), (half - 0.018, 0.0290), (half - 0.024, 0.0310), (-0.010, 0.0310),
        (-half + 0.020, 0.0300), (-half + 0.004, 0.0265), (-half, 0.0220),
    ]  # fmt: skip
    outline = ag.polygon(line, radius=0.0050)
    plan = [(-half - 0.01, -thick), (half - 0.026, -thick), (half + 0.002, -0.0068)]
    narrow = ag.extrude(ag.polygon([*plan, *((x, -y) for x, y in reversed(plan))]), 0.1)
    case = ag.extrude(outline, thick, axis=ag.Y, bevel=0.0040) & narrow
    low, high = 0.0042, 0.0232  # of the blade [m]
    tip = half - 0.0012
    top = 0.0310
    at = half - 0.050  # of the neck of the slider [m]
    room = ag.Region((tip - 0.064, half + 0.01), (-0.0009, 0.0009), (low - 0.0004, high + 0.0004)).box()
    neck = 0.0022
    slit = ag.Region(
        (at - 0.0066, at + travel + 0.0066), (-neck - 0.0004, neck + 0.0004), (high - 0.0030, top + 0.01)
    )
    cut = room | slit.box()
    mark = print_mark(maker, (-0.25 * length, -thick / 2, 0.0160), (0.36 * length, 0.0052), finish)
    grooves = [
        ag.box(0.0012, 0.0004, 0.0130)
        .rotate(ag.Y, -0.25)
        .at(half - 0.036 - 0.0042 * n, side * thick / 2, 0.0150)
        for n in range(6)
        for side in (-1, 1)
    ]
    heads = [
        details.screw(0.0034, (0.0060, -thick / 2, 0.0165), material=STEEL, drive="slot"),
        details.screw(0.0034, (0.0060, thick / 2, 0.0165), material=STEEL, facing=ag.Y, drive="slot"),
    ]
    seam = ag.extrude(outline.offset(0.0001) - outline.offset(-0.0004), 0.0004, axis=ag.Y)
    body = ag.weld(
        ag.part(case - cut, "handle", casting(finish.with_(density=6600.0), 0.30), name="handle"),
        ag.detail(seam - slit.grow(z=0.01).box() - room, "handle", recess(finish)),
        mark,
        mark.rotate(ag.Z, math.pi).at(-0.50 * length),
        ag.detail(grooves, "handle", recess(finish)),
        *heads,
    )
    flat = ag.polygon([(tip - 0.061, low), (tip, low), (tip - 0.0125, high), (tip - 0.0485, high)])
    blade = ag.extrude(flat, 0.0006, axis=ag.Y)
    ground = ag.Region((tip - 0.058, tip - 0.003), (-0.0004, 0.0004), (low, low + 0.0022)).box()
    thumb = ag.Region((at - 0.0100, at + 0.0100), (-0.0055, 0.0055), (top + FIT.sliding, top + 0.0056))
    stem = ag.Region((at - 0.0060, at + 0.0060), (-neck, neck), (high - 0.0026, top + 0.0010)).box()
    hold = ag.grasp_on(thumb.box(), approach=-ag.Z, closing=ag.Y, depth=0.0044)
    ribs = [ag.box(0.0010, 0.0100, 0.0010).at(at + (n - 2) * 0.0032, 0, top + 0.0057) for n in range(5)]
    sliding = ag.weld(
        ag.part([thumb.box(bevel=0.0012), stem], "slider", trim, name="blade", grasp=hold),
        ag.part(blade, "blade", BLADE),
        ag.detail(ribs, "slider", trim),
        ag.detail(ground, "edge", _GROUND),
    )
    clicks = feel.detents((0.0, 0.007, 0.014, travel), click)
    slide = ag.Prismatic("blade_slide", axis=ag.X, limits=(0, travel), detents=clicks, feel=_SLIDE)
    return body.attach(sliding, slide).at(z=-seam.anchor(z=-1).z)
