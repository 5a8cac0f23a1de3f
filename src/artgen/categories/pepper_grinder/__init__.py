"""A pepper mill: a turned body with a head or a crank that turns the burr in its foot.

Links: `body`; `top`, which is a bulb, a disc or a ball, or else `crank` with its `knob`. Joints: `top_turn`
or `crank_turn`, and `knob_spin` about the pin of a knob; none has limits. Shaft and male burr turn with the
head or crank; the burr is visible from below.

The grinding torque of 0.1 to 0.4 N m is modeled as dry friction: it acts only while the mill turns, and holds
the head at any angle. Sizes are those of household catalogs (Peugeot, Cole & Mason, Zassenhaus): 12-18 cm for
the table, up to 40 cm for restaurants, 50-72 mm wide; a beech mill of 18 cm weighs 0.25 kg.
"""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.pepper_grinder.finish import (
    CLEAR,
    LACQUER_WEIGHTS,
    LACQUERS,
    METAL_WEIGHTS,
    METALS,
    STEEL_WEIGHTS,
    STEELS,
    WOOD_WEIGHTS,
    WOODS,
    Mark,
    letter_mark,
    maker_mark,
    word_mark,
)
from artgen.categories.pepper_grinder.forms import HEAD_HEIGHT, BodyForm, Top, end_radius, fitting
from artgen.categories.pepper_grinder.works import (
    INSET,
    Content,
    Crank,
    Finial,
    HeadLooks,
    capped,
    clear,
    crank,
    head,
    head_turn,
    ring,
    wooden,
)

Build = Literal["wood", "lacquer", "steel", "clear"]

_STRAIGHT = ("cylinder",)  # finish of a clear tube
_RINGS = {"table": 9, "kitchen": 13, "restaurant": 19}


@ag.category(
    labels=(
        "body",
        "mechanism",
        "ring",
        "cap",
        "peppercorns",
        "top",
        "shaft",
        "burr",
        "finial",
        "crank",
        "knob",
        "screw",
        "print",
    ),
    joints=(1, 2),
)
def pepper_grinder(
    *,
    style: BodyForm = ag.choice(
        "classic",
        "baluster",
        "hourglass",
        "tower",
        "cone",
        "barrel",
        "spool",
        "ripple",
        "cylinder",
        weights=(0.16, 0.10, 0.12, 0.08, 0.09, 0.07, 0.08, 0.07, 0.23),
    ),
    top: Top = ag.by(
        "style",
        classic=ag.choice("bulb", "ball", "crank", weights=(0.7, 0.15, 0.15)),
        baluster=ag.choice("bulb", "ball", "crank", weights=(0.45, 0.3, 0.25)),
        hourglass=ag.choice("bulb", "disc", "ball", weights=(0.2, 0.6, 0.2)),
        tower=ag.choice("disc", "ball", "bulb", weights=(0.5, 0.3, 0.2)),
        cone=ag.choice("disc", "ball", "crank", weights=(0.45, 0.35, 0.2)),
        barrel=ag.choice("disc", "crank", weights=(0.35, 0.65)),
        cylinder=ag.choice("disc", "ball", "crank", weights=(0.6, 0.2, 0.2)),
        otherwise=ag.choice("bulb", "ball", weights=(0.65, 0.35)),
        doc="moving part: a head, or a crank on a cap",
    ),
    build: Build = ag.by(
        "style",
        cylinder=ag.choice("wood", "lacquer", "steel", "clear", weights=(0.12, 0.13, 0.20, 0.55)),
        hourglass=ag.choice("wood", "lacquer", "steel", weights=(0.36, 0.36, 0.28)),
        cone=ag.choice("wood", "lacquer", "steel", weights=(0.45, 0.25, 0.3)),
        otherwise=ag.choice("wood", "lacquer", weights=(0.56, 0.44)),
        doc="material of the body; a clear body shows its contents",
    ),
    size: Literal["table", "kitchen", "restaurant"] = ag.by(
        "top",
        crank="table",
        disc=ag.choice("table", "kitchen", "restaurant", weights=(0.45, 0.43, 0.12)),
        otherwise=ag.choice("table", "kitchen", "restaurant", weights=(0.35, 0.45, 0.2)),
    ),
    height: ag.Float = ag.by(
        "size",
        table=ag.uniform(0.125, 0.175),
        kitchen=ag.uniform(0.185, 0.26),
        restaurant=ag.uniform(0.29, 0.385),
        unit="m",
        within=(0.12, 0.40),
        doc="height to the top of the head, below its nut",
    ),
    diameter: ag.Float = ag.by(
        "size",
        table=ag.uniform(0.050, 0.060),
        kitchen=ag.uniform(0.053, 0.064),
        restaurant=ag.uniform(0.060, 0.072),
        unit="m",
        within=(0.05, 0.075),
    ),
    head_height: ag.Float = ag.by(
        "top",
        disc=ag.uniform(0.75, 1.5),
        crank=1.0,
        otherwise=ag.uniform(0.92, 1.12),
        doc="height added to the drawn form",
        within=(0.6, 1.8),
    ),
    finish: ag.Material = ag.by(
        "build",
        wood=ag.shades(*WOODS, weights=WOOD_WEIGHTS, color=0.12),
        lacquer=ag.shades(*LACQUERS, weights=LACQUER_WEIGHTS, color=0.05),
        steel=ag.shades(*STEELS, weights=STEEL_WEIGHTS, color=0.02),
        clear=ag.shades(*CLEAR, weights=(0.8, 0.2), color=0.0),
    ),
    ends: ag.Material = ag.by(
        "build",
        clear=ag.shades(*WOODS, *STEELS, weights=(*WOOD_WEIGHTS, *STEEL_WEIGHTS), color=0.05),
        steel=ag.shades(*STEELS, *WOODS, weights=(*STEEL_WEIGHTS, *WOOD_WEIGHTS), color=0.04),
        otherwise=ag.shades(*WOODS, color=0.06),
        doc="finish of the head or knob, and of the foot and collar of a clear mill",
    ),
    metal: ag.Material = ag.choice(*METALS, weights=METAL_WEIGHTS, doc="metal of nut, ring and crank"),
    finial: Finial = ag.choice("nut", "ball", "cap", weights=(0.4, 0.35, 0.25)),
    ringed: bool = ag.by("top", crank=False, otherwise=ag.choice(True, False, weights=(0.45, 0.55))),
    crank_reach: ag.Float = ag.uniform(0.052, 0.068, "m", doc="length of the crank", within=(0.045, 0.09)),
    knob_radius: ag.Float = ag.uniform(0.0105, 0.0130, "m", within=(0.009, 0.016)),
    friction: ag.Float = ag.uniform(0.10, 0.40, "N m", doc="friction between the burrs", within=(0.02, 0.8)),
    knob_friction: ag.Float = ag.uniform(0.001, 0.003, "N m", doc="friction of a crank's knob on its pin"),
    content: Content = ag.by(
        "build",
        clear=ag.choice("pepper", "salt", "mixed", weights=(0.6, 0.25, 0.15)),
        otherwise=ag.choice("pepper", "salt", weights=(0.7, 0.3)),
    ),
    mark: Mark = ag.by(
        "top",
        disc=ag.choice("none", "letter", "word", weights=(0.45, 0.35, 0.2)),
        otherwise=ag.by("build", wood="none", otherwise=ag.choice("none", "word", weights=(0.7, 0.3))),
        doc="mark of the contents",
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a pepper or salt mill: a head that turns, or a crank with its knob."""
    least = 0.91 if top == "ball" else 0.0
    head_height = ag.require(
        head_height, head_height >= least, f"head_height must be >= {least:g} (radii) with top=ball"
    )
    ag.require(
        mark != "letter" or top == "disc", f"mark=letter needs the flat head of top=disc, not top={top}"
    )
    ag.require(
        build != "clear" or style in _STRAIGHT, "build=clear has a straight tube: style must be cylinder"
    )
    radius = diameter / 2.0
    crown = head_height * HEAD_HEIGHT[top] * radius
    tall = height - crown  # height of the body
    tall = ag.require(
        tall, tall > 1.2 * radius, "the body has no room below the head: raise height, or lower head_height"
    )
    if build == "clear":
        body = clear(radius, tall, finish, ends, content=content, rings=_RINGS[size])
    else:
        body = wooden(style, radius, tall, finish)
    if ringed:
        body = ag.weld(body, ring(end_radius(style) * radius + 0.0004, tall - 0.0032, tall - 0.0006, metal))
    solid = ends if build == "clear" else finish
    body = ag.weld(body, maker_mark(maker, style, radius, tall, solid))
    word = "salt" if content == "salt" else "pepper"
    if mark == "word":
        around = radius - INSET if build == "clear" else radius
        body = ag.weld(body, word_mark(word, style, around, tall, finish))

    looks = HeadLooks(
        ends if build in ("clear", "steel") or top == "crank" else finish, metal, finial, fitting(style, top)
    )
    if top == "crank":
        body = capped(body, style, radius, tall, crown, metal)
        turning = crank(Crank(crank_reach, knob_radius, knob_friction), height, looks)
        return body.attach(turning, head_turn("crank_turn", friction))
    turning = head(top, radius, tall, crown, looks)
    if mark == "letter":
        turning = ag.weld(turning, letter_mark(word, radius, height, looks.finish))
    return body.attach(turning, head_turn("top_turn", friction))
