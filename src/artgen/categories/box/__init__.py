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

from typing import Any, Literal

import artgen as ag
from artgen import details
from artgen.categories.box import gifts, kinds
from artgen.categories.box.board import Board, Flute
from artgen.categories.box.closures import Sides
from artgen.categories.box.finish import COLORFUL, KRAFT, LININGS, PRINTS, RIBBONS, STRAPS, WHITE, WRAPS
from artgen.categories.box.prints import Emblem, Look, Signs

Style = Literal["slotted", "half_slotted", "mailer", "pizza", "tuck_end", "wine", "tray", "gift"]

# flaps of ends, print on a front, and straps, tucks and ears need room: least width and height by style [m]
_LEAST = {"slotted": (0.0, 0.06), "mailer": (0.15, 0.0), "tuck_end": (0.0, 0.1), "tray": (0.14, 0.0)}
_STYLES = {"slotted": 0.24, "half_slotted": 0.08, "mailer": 0.15, "pizza": 0.10, "tuck_end": 0.10,
           "wine": 0.12, "tray": 0.10, "gift": 0.11}  # fmt: skip
_TINTS = {"graphite": 0.45, "brown": 0.2, "blue": 0.12, "red": 0.12, "forest": 0.11}


def _by_size(**spans: tuple[float, float]) -> Any:
    """Draw evenly from a span for each size."""
    return ag.by("size", **{size: ag.uniform(*span) for size, span in spans.items()})


_MAYBE = {False: 1.0, True: 1.0}
_LIKELY = {True: 1.0, False: 1.0}  # as likely; the order decides which draw gives which option
_CREASES = {"fresh": 0.4, "worked": 0.6}
_FRICTION = {"fresh": ag.uniform(0.06, 0.16), "worked": ag.uniform(0.2, 0.6)}
_DAMPING = {"fresh": ag.uniform(0.03, 0.06), "worked": ag.uniform(0.02, 0.05)}
_SIZES = {"small": 0.3, "medium": 0.4, "large": 0.3}
_WIDTHS = {
    "slotted": _by_size(small=(0.20, 0.30), medium=(0.32, 0.46), large=(0.50, 0.74)),
    "half_slotted": _by_size(medium=(0.32, 0.46), otherwise=(0.46, 0.62)),
    "mailer": _by_size(small=(0.19, 0.26), medium=(0.25, 0.36), large=(0.30, 0.40)),
    "pizza": _by_size(small=(0.25, 0.31), otherwise=(0.32, 0.41)),
    "tuck_end": _by_size(small=(0.24, 0.32), otherwise=(0.32, 0.46)),
    "tray": _by_size(small=(0.24, 0.32), otherwise=(0.32, 0.42)),
    "gift": _by_size(small=(0.16, 0.21), otherwise=(0.21, 0.30)),
    "otherwise": ag.uniform(0.086, 0.093),
}
_HEIGHTS = {
    "slotted": ag.by(
        "mouth",
        top=_by_size(small=(0.14, 0.22), medium=(0.20, 0.36), large=(0.34, 0.55)),
        # less than the depth: minor flaps do not meet
        ends=_by_size(small=(0.10, 0.12), medium=(0.13, 0.19), large=(0.19, 0.29)),
    ),
    "half_slotted": _by_size(medium=(0.32, 0.46), otherwise=(0.44, 0.62)),
    "mailer": _by_size(small=(0.055, 0.085), medium=(0.07, 0.11), large=(0.125, 0.17)),
    "pizza": ag.uniform(0.042, 0.050),
    "tuck_end": _by_size(small=(0.105, 0.13), otherwise=(0.125, 0.19)),
    "wine": ag.uniform(0.322, 0.338),
    "tray": _by_size(small=(0.10, 0.14), otherwise=(0.11, 0.26)),
    "otherwise": ag.uniform(0.075, 0.14),
}


@ag.category(
    labels="box flap_major flap_minor lid tuck sleeve drawer divider bottle handle insert ribbon tape label "
    "print",
    joints=(1, 16),
)
def box(
    *,
    style: Style = ag.choice(_STYLES),
    mouth: Literal["top", "ends"] = ag.by(
        "style",
        slotted={"ends": 0.26, "top": 0.74},
        tuck_end="ends",
        otherwise="top",
        doc="position of the opening; a box with open ends lies on its side",
    ),
    size: Literal["small", "medium", "large"] = ag.by(
        "style",
        slotted=_SIZES,
        half_slotted={"medium": 1, "large": 1},
        wine="medium",
        mailer=_SIZES,
        otherwise={"small": 0.4, "medium": 0.6},
    ),
    bottles: int = ag.by(
        "style", wine={2: 0.25, 3: 0.2, 6: 0.35, 12: 0.2}, otherwise=0, doc="number of cells for bottles"
    ),
    wine: kinds.Wine = ag.by(
        "style",
        wine={"none": 0.3, "red": 0.36, "white": 0.2, "rose": 0.14},
        otherwise="none",
        doc="contents of the cells of a wine box",
    ),
    sides: Sides = ag.by("style", mailer={"over": 0.7, "tucked": 0.3}, pizza="tucked", otherwise="over"),
    ears: bool = ag.by(
        "style",
        mailer={True: 0.75, False: 0.25},
        pizza={True: 0.4, False: 0.6},
        tuck_end={True: 0.6, False: 0.4},
        otherwise=False,
        doc="whether ears at the ends of the tuck lock it",
    ),
    dusted: bool = ag.by(
        "sides",
        over=ag.by("style", mailer=ag.by("size", large=_LIKELY, otherwise=False), otherwise=False),
        tucked=False,
        doc="whether a deep mailer has dust flaps under its lid",
    ),
    lips: bool = ag.by(
        "style",
        tuck_end=_LIKELY,
        otherwise=False,
        doc="whether dust flaps end in lips, which seal the corners",
    ),
    closure: gifts.Closure = ag.by(
        "style", gift={"lift": 0.5, "flap": 0.28, "drawer": 0.22}, otherwise="lift"
    ),
    width: ag.Float = ag.by(
        "style",
        _WIDTHS,
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
        "style", _HEIGHTS, unit="m", within=(0.04, 0.80), doc="height of the closed box"
    ),
    flute: Flute = ag.by(
        "style",
        slotted=ag.by(
            "size",
            small={"b": 1, "c": 1},
            medium={"b": 0.25, "c": 0.5, "eb": 0.25},
            large={"c": 0.3, "eb": 0.3, "bc": 0.4},
        ),
        half_slotted={"c": 1, "eb": 1, "bc": 1},
        wine={"b": 1, "c": 1},
        tray={"b": 0.7, "c": 0.3},
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
        slotted={True: 0.72, False: 0.28},
        half_slotted=_LIKELY,
        wine=_LIKELY,
        otherwise=False,
        doc="whether slit tape lies along the seam",
    ),
    holes: bool = ag.by(
        "style",
        slotted=ag.by(
            "mouth", top=ag.by("size", small=False, medium=_MAYBE, large={False: 0.3, True: 0.7}), ends=False
        ),
        half_slotted=_MAYBE,
        otherwise=False,
        doc="whether the sides have hand holes",
    ),
    ribbon: ag.Material = ag.by("style", gift=ag.shades(*RIBBONS, color=0.05), otherwise=RIBBONS[0]),
    ribbon_width: ag.Float = ag.uniform(0.014, 0.026, "m"),
    crossed: bool = ag.by(
        "style", gift=_MAYBE, otherwise=False, doc="whether two ribbons cross on a gift box"
    ),
    hollow: gifts.Hollow = ag.by(
        "closure",
        lift="none",
        otherwise={"none": 0.3, "square": 0.4, "round": 0.3},
        doc="shape of the hollow in the foam of a gift box",
    ),
    rounded: bool = ag.by(
        "closure", flap=_MAYBE, otherwise=False, doc="whether a magnetic flap has cut corners"
    ),
    strap: ag.Material = ag.by("style", tray=ag.shades(*STRAPS, color=0.05), otherwise=STRAPS[0]),
    crease: Literal["fresh", "worked"] = ag.by(
        "style",
        slotted=_CREASES,
        half_slotted=_CREASES,
        otherwise="worked",
        doc="whether major flaps spring open",
    ),
    springback: ag.Float = ag.uniform(0.52, 1.05, "rad", doc="rest angle of fresh flaps"),
    stiffness: ag.Float = ag.uniform(0.4, 1.2, "N m/rad", doc="stiffness of a meter of fresh crease"),
    friction: ag.Float = ag.by("crease", _FRICTION, unit="N m", doc="friction of a meter of crease"),
    damping: ag.Float = ag.by("crease", _DAMPING, unit="N m s/rad", doc="damping of a meter of crease"),
    rub: ag.Float = ag.uniform(0.25, 0.8, doc="friction of sliding parts, as a share of their weight"),
    swing: ag.Float = ag.uniform(3.5, 4.62, "rad", doc="opening angle of flaps in free space"),
    lid_open: ag.Float = ag.by(
        "style", wine=ag.uniform(2.2, 3.4), otherwise=ag.uniform(1.95, 2.85), unit="rad"
    ),
    signs: Signs = ag.by(
        "style",
        slotted={"none": 0.22, "up": 0.2, "pair": 0.28, "full": 0.3},
        half_slotted={"none": 1, "up": 1, "pair": 1, "full": 1},
        wine={"pair": 1, "full": 1},
        otherwise="none",
    ),
    label: bool = ag.by(
        "style",
        slotted=_MAYBE,
        mailer={False: 0.7, True: 0.3},
        tuck_end={False: 0.7, True: 0.3},
        tray=_MAYBE,
        otherwise=False,
        doc="whether a label shows an address or the contents",
    ),
    emblem: Emblem = ag.choice("leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"),
    tint: Literal["graphite", "brown", "blue", "red", "forest"] = ag.choice(_TINTS, doc="ink color"),
    maker: str = ag.choice(*details.BRANDS),
    model: int = ag.count(100, 989),
) -> ag.Body:
    """Make a cardboard or gift box, closed: flaps, tucks, ears, lid, drawer, bottles."""
    wide, tall = _LEAST.get(style, (0.0, 0.0))
    height = ag.require(height, height >= tall, f"flaps and print need room: height must be >= {tall:g} m")
    width = ag.require(width, width >= wide, f"strap, tucks and ears need room: width must be >= {wide:g} m")
    stiff, rest = (stiffness, springback) if crease == "fresh" else (0.0, 0.0)
    board = Board(flute, outside, lining, stiff, rest, friction, damping, swing, lid_open)
    case = ag.Region.centered(width, width * aspect, 0.0).with_(z=(0.0, height))
    look = Look(maker, model, emblem, tint, signs, label)
    plan = (board, case, look)
    match style:
        case "slotted" if mouth == "top":
            body = kinds.slotted_box(*plan, taped=taped, holes=holes)
        case "slotted":
            body = kinds.open_ended_box(*plan, taped=taped)
        case "tuck_end":
            body = kinds.tuck_end_box(*plan, ears=ears, lips=lips)
        case "half_slotted":
            body = kinds.slotted_box(*plan, taped=taped, holes=holes, rub=rub)
        case "mailer" | "pizza":
            body = kinds.lidded_box(*plan, pizza=style == "pizza", sides=sides, ears=ears, dusted=dusted)
        case "wine":
            body = kinds.wine_box(board, width, height, look, bottles=bottles, wine=wine, taped=taped)
        case "tray":
            body = kinds.tray_box(*plan, skirt=skirt, rub=rub, strap=gifts.strap(strap))
        case _ if closure == "lift":
            bow = (ribbon, ribbon_width)
            body = gifts.lifted(board, case, *bow, crossed=crossed, skirt=skirt * height, rub=rub)
        case _ if closure == "drawer":
            body = gifts.drawn(*plan, ribbon, hollow, friction=1 + 3 * rub)
        case _:
            reach = (0.45 + 0.55 * skirt) * height
            body = gifts.flapped(*plan, ribbon, hollow, reach=reach, rounded=rounded)
    return body
