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
from artgen.categories.pepper_grinder import finish as looks
from artgen.categories.pepper_grinder import works
from artgen.categories.pepper_grinder.forms import HEAD_HEIGHT, BodyForm, Top

Build = Literal["wood", "lacquer", "steel", "clear"]

_STYLES = {"classic": 0.16, "baluster": 0.10, "hourglass": 0.12, "tower": 0.08, "cone": 0.09, "barrel": 0.07,
           "spool": 0.08, "ripple": 0.07, "cylinder": 0.23}  # fmt: skip
_RINGS = {"table": 9, "kitchen": 13, "restaurant": 19}  # rings of grains in a clear tube


@ag.category(
    labels="body mechanism ring cap peppercorns top shaft burr finial crank knob screw print", joints=(1, 2)
)
def pepper_grinder(
    *,
    style: BodyForm = ag.choice(_STYLES),
    top: Top = ag.by(
        "style",
        classic={"bulb": 0.7, "ball": 0.15, "crank": 0.15},
        baluster={"bulb": 0.45, "ball": 0.3, "crank": 0.25},
        hourglass={"bulb": 0.2, "disc": 0.6, "ball": 0.2},
        tower={"disc": 0.5, "ball": 0.3, "bulb": 0.2},
        cone={"disc": 0.45, "ball": 0.35, "crank": 0.2},
        barrel={"disc": 0.35, "crank": 0.65},
        cylinder={"disc": 0.6, "ball": 0.2, "crank": 0.2},
        otherwise={"bulb": 0.65, "ball": 0.35},
        doc="moving part: a head, or a crank on a cap",
    ),
    build: Build = ag.by(
        "style",
        cylinder={"wood": 0.12, "lacquer": 0.13, "steel": 0.20, "clear": 0.55},
        hourglass={"wood": 0.36, "lacquer": 0.36, "steel": 0.28},
        cone={"wood": 0.45, "lacquer": 0.25, "steel": 0.3},
        otherwise={"wood": 0.56, "lacquer": 0.44},
        doc="material of the body; a clear body shows its contents",
    ),
    size: Literal["table", "kitchen", "restaurant"] = ag.by(
        "top",
        crank="table",
        disc={"table": 0.45, "kitchen": 0.43, "restaurant": 0.12},
        otherwise={"table": 0.35, "kitchen": 0.45, "restaurant": 0.2},
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
        wood=ag.shades(looks.WOODS, color=0.12),
        lacquer=ag.shades(looks.LACQUERS, color=0.05),
        steel=ag.shades(looks.STEELS, color=0.02),
        clear=ag.shades(looks.CLEAR, color=0.0),
    ),
    ends: ag.Material = ag.by(
        "build",
        clear=ag.shades({**looks.WOODS, **looks.STEELS}, color=0.05),
        steel=ag.shades({**looks.STEELS, **looks.WOODS}, color=0.04),
        otherwise=ag.shades(*looks.WOODS, color=0.06),
        doc="finish of the head or knob, and of the foot and collar of a clear mill",
    ),
    metal: ag.Material = ag.choice(looks.METALS, doc="metal of nut, ring and crank"),
    finial: works.Finial = ag.choice({"nut": 0.4, "ball": 0.35, "cap": 0.25}),
    ringed: bool = ag.by("top", crank=False, otherwise={True: 0.45, False: 0.55}),
    crank_reach: ag.Float = ag.uniform(0.052, 0.068, "m", doc="length of the crank", within=(0.045, 0.09)),
    knob_radius: ag.Float = ag.uniform(0.0105, 0.0130, "m", within=(0.009, 0.016)),
    friction: ag.Float = ag.uniform(0.10, 0.40, "N m", doc="friction between the burrs", within=(0.02, 0.8)),
    knob_friction: ag.Float = ag.uniform(0.001, 0.003, "N m", doc="friction of a crank's knob on its pin"),
    content: works.Content = ag.by(
        "build", clear={"pepper": 0.6, "salt": 0.25, "mixed": 0.15}, otherwise={"pepper": 0.7, "salt": 0.3}
    ),
    mark: looks.Mark = ag.by(
        "top",
        disc={"none": 0.45, "letter": 0.35, "word": 0.2},
        otherwise=ag.by("build", wood="none", otherwise={"none": 0.7, "word": 0.3}),
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
    is_clear = build == "clear"
    ag.require(not is_clear or style == "cylinder", "build=clear has a straight tube: style must be cylinder")
    radius = diameter / 2
    crown = head_height * HEAD_HEIGHT[top] * radius
    tall = height - crown
    tall = ag.require(
        tall, tall > 1.2 * radius, "the body has no room below the head: raise height, or lower head_height"
    )
    space = ag.Region((-radius, radius), (-radius, radius), (0, tall))

    if is_clear:
        body = works.clear(space, finish, ends, content, _RINGS[size])
    else:
        body = works.wooden(style, space, finish)
    if ringed:
        body = ag.weld(body, works.ring(style, space, metal))
    body = ag.weld(body, looks.maker_mark(maker, style, space, ends if is_clear else finish))
    word = "salt" if content == "salt" else "pepper"
    if mark == "word":
        around = space.shrink(x=works.INSET) if is_clear else space
        body = ag.weld(body, looks.word_mark(word, style, around, finish))

    if top == "crank":
        body = ag.weld(body, works.cap(style, radius, tall, crown, metal))
        turning = works.crank(height, crank_reach, knob_radius, knob_friction, ends, metal, finial)
    else:
        wood = ends if build in ("clear", "steel") else finish
        turning = works.head(top, style, radius, tall, crown, wood, metal, finial)
        if mark == "letter":
            turning = ag.weld(turning, looks.letter_mark(word, radius, height + works.GAP, wood))
    name = "crank_turn" if top == "crank" else "top_turn"
    turn = ag.Revolute(name, axis=ag.Z, friction=friction, damping=0.01, armature=0.0002, effort=3.0)
    return body.attach(turning, turn)
