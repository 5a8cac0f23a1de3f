"""A cardboard box: slotted, half-slotted, mailer, pizza, tuck-end, wine, tray with a lid, or gift box.

Links: `box`. Slotted tops have `flap_front`, `flap_back` (major) and `flap_left`, `flap_right` (minor, below
them). A half-slotted cover is the `sleeve`, which lifts off its tray. A mailer, a pizza box or a tall wine
box has a `lid` with `tuck_front`, `tuck_left`, `tuck_right` and the ears `ear_left`, `ear_right` of the tuck.
A tray or a gift box has a `lid` or a `drawer`. Bottles of a wine box are `bottle_0`, ....
A slotted box that opens at both ends has four flaps at each end: `flap_upper_left`, `flap_lower_left`
(major), `flap_front_left`, `flap_back_left` (minor), and the same with `_right`. Each end of a tuck-end box
has `lid_left`, `tuck_lower_left`, the ears `ear_front_left`, `ear_back_left`, the dust flaps
`flap_front_left`, `flap_back_left` under the lid and the lips `lip_front_left`, `lip_back_left` of these:
sixteen links in all.
Joints: the name of a flap or a hinged lid with `_hinge` (before the suffix of an end); `lid_lift`,
`sleeve_lift`, `drawer_slide`, `bottle_lift_0`, ....

Dependencies of the joints encode the order of closing. Minor flaps fold in only while the major flaps are
upright or hang down; they hang down only if there is free space. Tucks, ears and dust flaps move after the
lid is open. A bottle lifts out after the flaps above it are open. The lower flap of an end rests on the floor
when open.

Constructions are those of the FEFCO code: 0201 slotted, 0200 half-slotted on a tray, 0427 mailer, 0426 pizza
box, 0211 with tucked ends, 0215 tall carton, 0320 tray with a lid. The resistance of creases is an estimate
per meter of length: the weight of a flap 0.2 m long of 0.7 kg/m2 board loads its crease with 0.14 N m; a
worked crease holds this load (0.2-0.6 N m); a fresh crease holds less and springs back to 30-60 degrees.
"""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.box.board import Board, Feel, Flute
from artgen.categories.box.ends import open_ended_box, tuck_end_box
from artgen.categories.box.finish import COLORFUL, KRAFT, LININGS, PRINTS, RIBBONS, STRAPS, WHITE, WRAPS
from artgen.categories.box.gifts import Closure, Hollow
from artgen.categories.box.kinds import (
    Draft,
    gift_box,
    half_slotted_box,
    lidded_box,
    slotted_box,
    tray_box,
    wine_box,
)
from artgen.categories.box.lids import Sides
from artgen.categories.box.prints import Look, Signs

Style = Literal["slotted", "half_slotted", "mailer", "pizza", "tuck_end", "wine", "tray", "gift"]

_LEAST_WIDTH: dict[Style, float] = {"tray": 0.14, "mailer": 0.15}  # least width of boxes of these styles [m]


@ag.category(
    labels=(
        "box",
        "flap_major",
        "flap_minor",
        "lid",
        "tuck",
        "sleeve",
        "drawer",
        "divider",
        "bottle",
        "handle",
        "insert",
        "ribbon",
        "tape",
        "label",
        "print",
    ),
    joints=(1, 16),
)
def box(
    *,
    style: Style = ag.choice(
        "slotted",
        "half_slotted",
        "mailer",
        "pizza",
        "tuck_end",
        "wine",
        "tray",
        "gift",
        weights=(0.24, 0.08, 0.15, 0.10, 0.10, 0.12, 0.10, 0.11),
    ),
    mouth: Literal["top", "ends"] = ag.by(
        "style",
        slotted=ag.choice("ends", "top", weights=(0.26, 0.74)),
        tuck_end="ends",
        otherwise="top",
        doc="position of the opening; a box with open ends lies on its side",
    ),
    size: Literal["small", "medium", "large"] = ag.by(
        "style",
        slotted=ag.choice("small", "medium", "large", weights=(0.3, 0.4, 0.3)),
        half_slotted=ag.choice("medium", "large"),
        wine="medium",
        mailer=ag.choice("small", "medium", "large", weights=(0.3, 0.4, 0.3)),
        otherwise=ag.choice("small", "medium", weights=(0.4, 0.6)),
    ),
    bottles: int = ag.by(
        "style",
        wine=ag.choice(2, 3, 6, 12, weights=(0.25, 0.2, 0.35, 0.2)),
        otherwise=0,
        doc="number of cells for bottles",
    ),
    wine: Literal["none", "red", "white", "rose"] = ag.by(
        "style",
        wine=ag.choice("none", "red", "white", "rose", weights=(0.3, 0.36, 0.2, 0.14)),
        otherwise="none",
        doc="contents of the cells of a wine box",
    ),
    sides: Sides = ag.by(
        "style", mailer=ag.choice("over", "tucked", weights=(0.7, 0.3)), pizza="tucked", otherwise="over"
    ),
    ears: bool = ag.by(
        "style",
        mailer=ag.choice(True, False, weights=(0.75, 0.25)),
        pizza=ag.choice(True, False, weights=(0.4, 0.6)),
        tuck_end=ag.choice(True, False, weights=(0.6, 0.4)),
        otherwise=False,
        doc="whether ears at the ends of the tuck lock it",
    ),
    dusted: bool = ag.by(
        "sides",
        over=ag.by(
            "style", mailer=ag.by("size", large=ag.choice(True, False), otherwise=False), otherwise=False
        ),
        tucked=False,
        doc="whether a deep mailer has dust flaps under its lid",
    ),
    lips: bool = ag.by(
        "style",
        tuck_end=ag.choice(True, False),
        otherwise=False,
        doc="whether dust flaps end in lips, which seal the corners",
    ),
    closure: Closure = ag.by(
        "style", gift=ag.choice("lift", "flap", "drawer", weights=(0.5, 0.28, 0.22)), otherwise="lift"
    ),
    width: ag.Float = ag.by(
        "style",
        slotted=ag.by(
            "size", small=ag.uniform(0.20, 0.30), medium=ag.uniform(0.32, 0.46), large=ag.uniform(0.50, 0.74)
        ),
        half_slotted=ag.by("size", medium=ag.uniform(0.32, 0.46), otherwise=ag.uniform(0.46, 0.62)),
        mailer=ag.by(
            "size", small=ag.uniform(0.19, 0.26), medium=ag.uniform(0.25, 0.36), large=ag.uniform(0.30, 0.40)
        ),
        pizza=ag.by("size", small=ag.uniform(0.25, 0.31), otherwise=ag.uniform(0.32, 0.41)),
        tuck_end=ag.by("size", small=ag.uniform(0.24, 0.32), otherwise=ag.uniform(0.32, 0.46)),
        tray=ag.by("size", small=ag.uniform(0.24, 0.32), otherwise=ag.uniform(0.32, 0.42)),
        gift=ag.by("size", small=ag.uniform(0.16, 0.21), otherwise=ag.uniform(0.21, 0.30)),
        otherwise=ag.uniform(0.086, 0.093),
        unit="m",
        within=(0.08, 0.80),
        doc="width of the front; in a wine box, width of a cell",
    ),
    aspect: ag.Float = ag.by(
        "style",
        slotted=ag.uniform(0.60, 0.96),
        half_slotted=ag.uniform(0.62, 0.92),
        mailer=ag.uniform(0.66, 0.84),
        tuck_end=ag.uniform(0.55, 0.75),
        tray=ag.uniform(0.60, 0.74),
        gift=ag.uniform(0.66, 1.0),
        otherwise=1.0,
        doc="depth as a share of the width",
        within=(0.5, 1.0),
    ),
    height: ag.Float = ag.by(
        "style",
        slotted=ag.by(
            "mouth",
            top=ag.by(
                "size",
                small=ag.uniform(0.14, 0.22),
                medium=ag.uniform(0.20, 0.36),
                large=ag.uniform(0.34, 0.55),
            ),
            ends=ag.by(  # less than the depth: minor flaps do not meet
                "size",
                small=ag.uniform(0.10, 0.12),
                medium=ag.uniform(0.13, 0.19),
                large=ag.uniform(0.19, 0.29),
            ),
        ),
        half_slotted=ag.by("size", medium=ag.uniform(0.32, 0.46), otherwise=ag.uniform(0.44, 0.62)),
        mailer=ag.by(
            "size",
            small=ag.uniform(0.055, 0.085),
            medium=ag.uniform(0.07, 0.11),
            large=ag.uniform(0.125, 0.17),
        ),
        pizza=ag.uniform(0.042, 0.050),
        tuck_end=ag.by("size", small=ag.uniform(0.105, 0.13), otherwise=ag.uniform(0.125, 0.19)),
        wine=ag.uniform(0.322, 0.338),
        tray=ag.by("size", small=ag.uniform(0.10, 0.14), otherwise=ag.uniform(0.11, 0.26)),
        otherwise=ag.uniform(0.075, 0.14),
        unit="m",
        within=(0.04, 0.80),
        doc="height of the closed box",
    ),
    flute: Flute = ag.by(
        "style",
        slotted=ag.by(
            "size",
            small=ag.choice("b", "c"),
            medium=ag.choice("b", "c", "eb", weights=(0.25, 0.5, 0.25)),
            large=ag.choice("c", "eb", "bc", weights=(0.3, 0.3, 0.4)),
        ),
        half_slotted=ag.choice("c", "eb", "bc"),
        wine=ag.choice("b", "c"),
        tray=ag.choice("b", "c", weights=(0.7, 0.3)),
        gift="grey",
        otherwise="b",
        doc="flute of the board, which is 3 to 6.8 mm thick",
    ),
    skirt: ag.Float = ag.by(
        "style",
        tray=ag.uniform(0.25, 0.9),
        gift=ag.uniform(0.28, 0.75),
        otherwise=0.5,
        within=(0.2, 0.95),
        doc="reach of a lid or a front flap downward, as a share of the height",
    ),
    outside: ag.Material = ag.by(
        "style",
        mailer=ag.shades(*KRAFT, WHITE, *PRINTS, weights=(3, 2, 1, 4, *COLORFUL), color=0.05),
        pizza=ag.shades(KRAFT[0], KRAFT[1], WHITE, weights=(1.0, 0.8, 1.8), color=0.04),
        tuck_end=ag.shades(*KRAFT, WHITE, *PRINTS, weights=(2, 1.5, 0.7, 3, *COLORFUL), color=0.05),
        wine=ag.shades(*KRAFT, WHITE, PRINTS[0], PRINTS[10], weights=(3, 1, 1, 3, 0.8, 0.8), color=0.04),
        tray=ag.shades(KRAFT[0], KRAFT[1], WHITE, *PRINTS, weights=(1.5, 1, 2, *COLORFUL), color=0.05),
        gift=ag.shades(*WRAPS, color=0.06),
        otherwise=ag.shades(*KRAFT, WHITE, weights=(4, 2, 1, 1.6), color=0.07),
    ),
    lining: ag.Material = ag.by(
        "style",
        gift=ag.shades(*LININGS, color=0.04),
        mailer=ag.shades(*KRAFT[:2], WHITE, *PRINTS, weights=(5, 3, 4, *COLORFUL), color=0.04),
        otherwise=ag.shades(*KRAFT, weights=(4, 2, 1), color=0.05),
        doc="material of the inner faces",
    ),
    taped: bool = ag.by(
        "style",
        slotted=ag.choice(True, False, weights=(0.72, 0.28)),
        half_slotted=ag.choice(True, False),
        wine=ag.choice(True, False),
        otherwise=False,
        doc="whether slit tape lies along the seam",
    ),
    holes: bool = ag.by(
        "style",
        slotted=ag.by(
            "mouth",
            top=ag.by(
                "size",
                small=False,
                medium=ag.choice(False, True),
                large=ag.choice(False, True, weights=(0.3, 0.7)),
            ),
            ends=False,
        ),
        half_slotted=ag.choice(False, True),
        otherwise=False,
        doc="whether the sides have hand holes",
    ),
    ribbon: ag.Material = ag.by("style", gift=ag.shades(*RIBBONS, color=0.05), otherwise=RIBBONS[0]),
    ribbon_width: ag.Float = ag.uniform(0.014, 0.026, "m"),
    crossed: bool = ag.by(
        "style", gift=ag.choice(False, True), otherwise=False, doc="whether two ribbons cross on a gift box"
    ),
    hollow: Hollow = ag.by(
        "closure",
        lift="none",
        otherwise=ag.choice("none", "square", "round", weights=(0.3, 0.4, 0.3)),
        doc="shape of the hollow in the foam of a gift box",
    ),
    rounded: bool = ag.by(
        "closure", flap=ag.choice(False, True), otherwise=False, doc="whether a magnetic flap has cut corners"
    ),
    strap: ag.Material = ag.by("style", tray=ag.shades(*STRAPS, color=0.05), otherwise=STRAPS[0]),
    crease: Literal["fresh", "worked"] = ag.by(
        "style",
        slotted=ag.choice("fresh", "worked", weights=(0.4, 0.6)),
        half_slotted=ag.choice("fresh", "worked", weights=(0.4, 0.6)),
        otherwise="worked",
        doc="whether major flaps spring open",
    ),
    springback: ag.Float = ag.uniform(0.52, 1.05, "rad", doc="rest angle of fresh flaps"),
    stiffness: ag.Float = ag.uniform(0.4, 1.2, "N m/rad", doc="stiffness of a meter of fresh crease"),
    friction: ag.Float = ag.by(
        "crease",
        fresh=ag.uniform(0.06, 0.16),
        worked=ag.uniform(0.2, 0.6),
        unit="N m",
        doc="friction of a meter of crease",
    ),
    damping: ag.Float = ag.by(
        "crease",
        fresh=ag.uniform(0.03, 0.06),
        worked=ag.uniform(0.02, 0.05),
        unit="N m s/rad",
        doc="damping of a meter of crease",
    ),
    rub: ag.Float = ag.uniform(0.25, 0.8, doc="friction of sliding parts, as a share of their weight"),
    swing: ag.Float = ag.uniform(3.5, 4.62, "rad", doc="opening angle of flaps in free space"),
    lid_open: ag.Float = ag.by(
        "style", wine=ag.uniform(2.2, 3.4), otherwise=ag.uniform(1.95, 2.85), unit="rad"
    ),
    signs: Signs = ag.by(
        "style",
        slotted=ag.choice("none", "up", "pair", "full", weights=(0.22, 0.2, 0.28, 0.3)),
        half_slotted=ag.choice("none", "up", "pair", "full"),
        wine=ag.choice("pair", "full"),
        otherwise="none",
    ),
    label: bool = ag.by(
        "style",
        slotted=ag.choice(False, True),
        mailer=ag.choice(False, True, weights=(0.7, 0.3)),
        tuck_end=ag.choice(False, True, weights=(0.7, 0.3)),
        tray=ag.choice(False, True),
        otherwise=False,
        doc="whether a label shows an address or the contents",
    ),
    emblem: Literal["leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"] = ag.choice(
        "leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"
    ),
    tint: Literal["graphite", "brown", "blue", "red", "forest"] = ag.choice(
        "graphite", "brown", "blue", "red", "forest", weights=(0.45, 0.2, 0.12, 0.12, 0.11), doc="ink color"
    ),
    maker: str = ag.choice(*details.BRANDS),
    model: int = ag.count(100, 989),
) -> ag.Body:
    """Make a cardboard or gift box, closed: flaps, tucks, ears, lid, drawer, bottles."""
    if style == "half_slotted" or (style == "slotted" and mouth == "top"):
        free = width * (1.0 - aspect)  # free space between the minor flaps of the bottom
        width = ag.require(width, free > 0.006, "the flaps of a square box meet: aspect must be <= 0.96")
    least = _least_height(style)
    height = ag.require(height, height >= least, f"flaps and print need room: height must be >= {least:g} m")
    least = _LEAST_WIDTH.get(style, 0.0)
    width = ag.require(
        width, width >= least, f"strap, tucks and ears need room: width must be >= {least:g} m"
    )
    fresh = crease == "fresh"
    feel = Feel(stiffness if fresh else 0.0, springback if fresh else 0.0, friction, damping)
    draft = Draft(
        Board(flute, outside, lining),
        width,
        width * aspect,
        height,
        feel,
        swing,
        Look(maker, model, emblem, tint, signs, label),
    )
    match style:
        case "slotted" if mouth == "top":
            return slotted_box(draft, taped=taped, holes=holes)
        case "slotted":
            return open_ended_box(draft, taped=taped)
        case "tuck_end":
            return tuck_end_box(draft, ears=ears, lips=lips, opening=lid_open)
        case "half_slotted":
            return half_slotted_box(draft, taped=taped, holes=holes, rub=rub)
        case "mailer" | "pizza":
            return lidded_box(
                draft, pizza=style == "pizza", sides=sides, ears=ears, dusted=dusted, opening=lid_open
            )
        case "wine":
            filled = None if wine == "none" else wine
            return wine_box(draft, bottles=bottles, wine=filled, opening=lid_open, taped=taped)
        case "tray":
            return tray_box(draft, skirt=skirt, rub=rub, strapping=strap)
        case "gift":
            return gift_box(
                draft,
                closure,
                satin=ribbon,
                wide=ribbon_width,
                crossed=crossed,
                hollow=hollow,
                rounded=rounded,
                skirt=skirt,
                rub=rub,
                opening=lid_open,
            )


def _least_height(style: Style) -> float:
    """Return the least height of a box with space for the flaps of its ends or for print on its front [m]."""
    if style == "tuck_end":
        return 0.1
    return 0.06 if style == "slotted" else 0.0
