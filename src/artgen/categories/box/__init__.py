"""A cardboard box: slotted, half-slotted, mailer, pizza, tuck-end or wine box, tray with a lid or gift box.

Links: `box`; the flaps of slotted tops `flap_front`, `flap_back` (major), `flap_left`, `flap_right` (minor,
below them); the `sleeve` of a half-slotted cover, which lifts off its tray; the `lid` of a mailer, a pizza or
a tall wine box with `tuck_front`, `tuck_left`, `tuck_right` and the ears `ear_left`, `ear_right` of the tuck;
the `lid` of a tray or a gift box, or the `drawer` of one; `bottle_0`, ... in the cells of a wine box.
Slotted boxes that lie open at both ends, of four flaps each: `flap_upper_left`, `flap_lower_left` (major),
`flap_front_left`, `flap_back_left` and so on at the right. The ends of a tuck-end box have `lid_left`,
`tuck_lower_left`, the ears `ear_front_left`, `ear_back_left`, the dust flaps `flap_front_left`,
`flap_back_left` under the lid and on them the lips `lip_front_left`, `lip_back_left`: sixteen in all.
Joints: the name of a flap or a hinged lid with `_hinge`, before the end's name; `lid_lift`, `sleeve_lift`,
`drawer_slide`, `bottle_lift_0`, ...

The order in which a box is closed is its dependencies: minor flaps fold in while the major ones stand up or
hang down, and hang down themselves where they are free; tucks, ears and dust flaps move once their lid is up;
a bottle comes out where the flaps over it are open. The lower flap of an end comes to lie on the floor.

Constructions are those of FEFCO's code: 0201 slotted, 0200 half-slotted on a tray, 0427 mailer, 0426 pizza
box, 0211 with tucked ends, 0215 tall carton, 0320 tray with a lid. How creases resist is estimated, for each
metre: a board of 0.7 kg/m2 weighs 0.14 N m at the crease of a flap of 0.2 m, which a crease that was worked
holds (0.2-0.6 N m); fresh ones hold less and spring back to 30-60 degrees, a few newtons at the edge.
"""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.box.board import Board, Feel, Flute
from artgen.categories.box.ends import open_ended_box, tuck_end_box
from artgen.categories.box.finish import (
    COLORFUL,
    KRAFT,
    LININGS,
    PRINTS,
    RIBBONS,
    STRAPS,
    WHITE,
    WRAPS,
)
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

_LEAST_WIDTH: dict[Style, float] = {"tray": 0.14, "mailer": 0.15}  # [m]


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
        doc="where it opens; one with open ends lies",
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
        doc="cells for them",
    ),
    wine: Literal["none", "red", "white", "rose"] = ag.by(
        "style",
        wine=ag.choice("none", "red", "white", "rose", weights=(0.3, 0.36, 0.2, 0.14)),
        otherwise="none",
        doc="contents of the cells",
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
        doc="whether the tuck is locked by ears at its ends",
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
        doc="along the front; of a cell in a wine box",
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
        doc="depth over width",
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
        doc="closed",
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
        doc="of the board: 3 to 6.8 mm thick",
    ),
    skirt: ag.Float = ag.by(
        "style",
        tray=ag.uniform(0.25, 0.9),
        gift=ag.uniform(0.28, 0.75),
        otherwise=0.5,
        within=(0.2, 0.95),
        doc="how far a lid or a front flap reaches down, as a share of the height",
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
        doc="the inner face",
    ),
    taped: bool = ag.by(
        "style",
        slotted=ag.choice(True, False, weights=(0.72, 0.28)),
        half_slotted=ag.choice(True, False),
        wine=ag.choice(True, False),
        otherwise=False,
        doc="tape along the seam, slit open",
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
        doc="hand holes",
    ),
    ribbon: ag.Material = ag.by("style", gift=ag.shades(*RIBBONS, color=0.05), otherwise=RIBBONS[0]),
    ribbon_width: ag.Float = ag.uniform(0.014, 0.026, "m"),
    crossed: bool = ag.by(
        "style", gift=ag.choice(False, True), otherwise=False, doc="ribbon both ways around a gift box"
    ),
    hollow: Hollow = ag.by(
        "closure",
        lift="none",
        otherwise=ag.choice("none", "square", "round", weights=(0.3, 0.4, 0.3)),
        doc="in the foam of a gift box, if there is some",
    ),
    rounded: bool = ag.by(
        "closure", flap=ag.choice(False, True), otherwise=False, doc="corners of a magnetic flap"
    ),
    strap: ag.Material = ag.by("style", tray=ag.shades(*STRAPS, color=0.05), otherwise=STRAPS[0]),
    crease: Literal["fresh", "worked"] = ag.by(
        "style",
        slotted=ag.choice("fresh", "worked", weights=(0.4, 0.6)),
        half_slotted=ag.choice("fresh", "worked", weights=(0.4, 0.6)),
        otherwise="worked",
        doc="whether major flaps spring up again",
    ),
    springback: ag.Float = ag.uniform(0.52, 1.05, "rad", doc="where fresh flaps come to rest"),
    stiffness: ag.Float = ag.uniform(0.4, 1.2, "N m/rad", doc="of a metre of fresh crease"),
    friction: ag.Float = ag.by(
        "crease",
        fresh=ag.uniform(0.06, 0.16),
        worked=ag.uniform(0.2, 0.6),
        unit="N m",
        doc="of a metre of crease",
    ),
    damping: ag.Float = ag.by(
        "crease",
        fresh=ag.uniform(0.03, 0.06),
        worked=ag.uniform(0.02, 0.05),
        unit="N m s/rad",
        doc="of a metre of crease",
    ),
    rub: ag.Float = ag.uniform(0.25, 0.8, doc="friction of sliding parts, as a share of their weight"),
    swing: ag.Float = ag.uniform(3.5, 4.62, "rad", doc="how far flaps open where they have room"),
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
        doc="an address, or the contents",
    ),
    emblem: Literal["leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"] = ag.choice(
        "leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"
    ),
    tint: Literal["graphite", "brown", "blue", "red", "forest"] = ag.choice(
        "graphite", "brown", "blue", "red", "forest", weights=(0.45, 0.2, 0.12, 0.12, 0.11), doc="of the ink"
    ),
    maker: str = ag.choice(*details.BRANDS),
    model: int = ag.count(100, 989),
) -> ag.Body:
    """Make a cardboard or gift box, closed: flaps, tucks, ears, lid, drawer, bottles."""
    if style == "half_slotted" or (style == "slotted" and mouth == "top"):
        free = width * (1.0 - aspect)  # between the minor flaps of the bottom
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
    """Return how high a box has to be for flaps at its ends, or for print below those at its top [m]."""
    if style == "tuck_end":
        return 0.1
    return 0.06 if style == "slotted" else 0.0
