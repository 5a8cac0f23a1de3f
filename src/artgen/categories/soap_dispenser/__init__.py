"""A soap dispenser: a bottle with a pump, on the sink or in a holder on the wall, or a box on the wall.

Links: `body`; `nozzle`, which moves down against the pump's spring and turns on its stem without limits, with
two joints between the same links; or `button` or `lever` of a box. Joints: `nozzle_slide`, `nozzle_turn`;
`button_slide`; `lever_hinge`. Springs return the pressed parts.

A wall dispenser comes with its wall tile. A pump needs 8 to 25 N and gives 1-2 ml per stroke of 12-20 mm.
Sizes are those of bathroom catalogs: 13-21 cm high with the pump, 62-90 mm wide, 0.2 to 0.45 l.
"""

from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.soap_dispenser import bottles, finish, mounts, pumps

Build = Literal["clear", "ceramic", "plastic", "steel"]

_SHAPES = {"round": 0.15, "square": 0.10, "cube": 0.08, "oval": 0.10, "hexagonal": 0.08, "amphora": 0.08,
           "cone": 0.08, "bell": 0.08, "apothecary": 0.12, "ribbed": 0.07, "beehive": 0.06}  # fmt: skip
_CLEAR = ("round", "square", "cube", "hexagonal", "cone", "bell", "apothecary")
_HELD = ("round", "apothecary")


@ag.category(
    labels="body collar stem nozzle cap pump dip_tube soap tile holder button lever window lock label screw "
    "print",
    joints=(1, 2),
)
def soap_dispenser(
    *,
    style: Literal["bottle", "holder", "box"] = ag.choice({"bottle": 0.76, "holder": 0.10, "box": 0.14}),
    shape: bottles.Shape = ag.by("style", bottle=_SHAPES, holder=ag.choice(*_HELD), box="square"),
    build: Build = ag.by(
        "style",
        bottle=ag.by(
            "shape",
            round={"clear": 0.25, "ceramic": 0.30, "plastic": 0.15, "steel": 0.30},
            square={"clear": 0.4, "ceramic": 0.25, "plastic": 0.15, "steel": 0.2},
            cube={"clear": 0.6, "ceramic": 0.4},
            hexagonal={"clear": 0.45, "ceramic": 0.4, "plastic": 0.15},
            oval={"ceramic": 0.3, "plastic": 0.7},
            cone={"clear": 0.3, "ceramic": 0.35, "plastic": 0.15, "steel": 0.2},
            bell={"clear": 0.35, "ceramic": 0.65},
            apothecary={"clear": 0.8, "plastic": 0.2},
            otherwise={"ceramic": 0.85, "plastic": 0.15},
        ),
        holder={"clear": 0.4, "plastic": 0.3, "steel": 0.3},
        box={"plastic": 0.6, "steel": 0.4},
    ),
    nozzle: pumps.Nozzle = ag.by(
        "build",
        plastic={"saddle": 0.45, "beak": 0.25, "foamer": 0.2, "bar": 0.1},
        clear={"saddle": 0.22, "beak": 0.2, "gooseneck": 0.2, "bar": 0.16, "swan": 0.14, "foamer": 0.08},
        ceramic={"saddle": 0.14, "beak": 0.26, "gooseneck": 0.24, "bar": 0.2, "swan": 0.16},
        steel=ag.choice("beak", "gooseneck", "bar", "swan"),
    ),
    press: mounts.Press = ag.choice("button", "lever", doc="pressed part of a box"),
    width: ag.Float = ag.by(
        "shape",
        round=ag.uniform(0.064, 0.078),
        square=ag.uniform(0.060, 0.070),
        cube=ag.uniform(0.074, 0.082),
        oval=ag.uniform(0.076, 0.088),
        hexagonal=ag.uniform(0.070, 0.082),
        amphora=ag.uniform(0.074, 0.088),
        cone=ag.uniform(0.076, 0.090),
        bell=ag.uniform(0.072, 0.086),
        apothecary=ag.uniform(0.064, 0.074),
        otherwise=ag.uniform(0.068, 0.080),
        unit="m",
        within=(0.058, 0.095),
        doc="width of a bottle",
    ),
    depth: ag.Float = ag.by(
        "shape",
        oval=ag.uniform(0.56, 0.66),
        square=ag.by("style", box=1.0, otherwise=ag.uniform(0.86, 1.0)),
        otherwise=1.0,
        doc="depth of an oval or rectangular bottle, as a share of its width",
        within=(0.5, 1.0),
    ),
    height: ag.Float = ag.by(
        "shape",
        cube=ag.uniform(0.080, 0.088),
        otherwise=ag.by("style", holder=ag.uniform(0.098, 0.108), otherwise=ag.uniform(0.092, 0.124)),
        unit="m",
        doc="height of a bottle up to the collar of its pump",
        within=(0.075, 0.13),
    ),
    box_width: ag.Float = ag.uniform(0.074, 0.094, "m", doc="width of a box", within=(0.07, 0.11)),
    box_depth: ag.Float = ag.uniform(0.066, 0.078, "m", doc="depth of a box", within=(0.06, 0.09)),
    reach: ag.Float = ag.uniform(0.042, 0.054, "m", doc="reach of the spout", within=(0.038, 0.07)),
    travel: ag.Float = ag.uniform(0.012, 0.020, "m", doc="travel of the pump", within=(0.010, 0.0202)),
    swing: ag.Float = ag.uniform(0.20, 0.30, "rad", doc="angle of a pressed lever", within=(0.1, 0.35)),
    force: ag.Float = ag.uniform(9.0, 22.0, "N", doc="spring force of the pressed part", within=(5.0, 30.0)),
    damping: ag.Float = ag.uniform(6.0, 12.0, "N s/m", doc="damping of the soap that is drawn in"),
    turn_friction: ag.Float = ag.uniform(0.02, 0.05, "N m", doc="friction of the nozzle on its stem"),
    finish: ag.Material = ag.by(
        "build", clear=finish.GLASSES, ceramic=finish.CERAMICS, plastic=finish.PLASTICS, steel=finish.STEELS
    ),
    pump: ag.Material = ag.by(
        "nozzle",
        saddle=finish.MOLDED_PUMPS,
        foamer=finish.MOLDED_PUMPS,
        beak=finish.PUMPS,
        otherwise=finish.PLATED_PUMPS,
    ),
    soap: ag.Material = ag.choice(*finish.SOAPS, doc="contents of a clear bottle, or of the window of a box"),
    fill: ag.Float = ag.uniform(
        0.45, 0.78, doc="fill level of a clear bottle, as a share", within=(0.2, 0.8)
    ),
    wall: ag.Material = finish.TILES,
    content: bottles.Content = ag.choice({"soap": 0.4, "hand_wash": 0.25, "lotion": 0.2, "dish_soap": 0.15}),
    print_: bottles.Print = ag.by(
        "build",
        clear={"none": 0.35, "word": 0.2, "icon": 0.1, "label": 0.35},
        plastic={"none": 0.2, "word": 0.2, "icon": 0.2, "label": 0.4},
        otherwise={"none": 0.5, "word": 0.35, "icon": 0.15},
        doc="print on a bottle without ribs",
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a soap dispenser, its pump up: a nozzle that slides and turns, or a button."""
    if style == "box":
        case = mounts.case_of(box_width, box_depth)
        body = mounts.box(case, finish, soap, fill, maker, " ".join(bottles.WORDS[content]))
        body = ag.weld(body, mounts.tile(1.5 * box_width, wall))
        pressed = mounts.panel(case, press, finish, travel)
        if press == "button":
            moves = pumps.slide("button_slide", ag.Y, travel, force, damping)
        else:
            moves = mounts.lever_hinge(case, swing, force, 0.0025 * damping)
        return body.attach(pressed, moves).output("soap", _dose(moves), kind="flow")

    ag.require(
        build != "clear" or shape in _CLEAR,
        f"shape={shape} has no bottle of clear glass: shape must be {' or '.join(_CLEAR)}",
    )
    ag.require(
        style != "holder" or shape in _HELD,
        f"the ring of style=holder fits round bottles with upright sides: shape={shape} must be "
        f"{' or '.join(_HELD)}",
    )
    least = 0.28 if style == "holder" else 0.0
    fill = ag.require(
        fill,
        fill >= least,
        f"the holder grips the bottle below the level of the soap: fill must be >= {least:g}",
    )
    space = ag.Region.centered(width, width * depth, height).at(z=height / 2)
    if build == "clear":
        body = bottles.clear(shape, space, finish, soap, fill)
    else:
        body = bottles.opaque(shape, space, finish)
    if shape in bottles.UNPRINTED or (print_ == "label" and shape not in bottles.LABELED):
        print_ = "none"
    marks = bottles.marks(print_, content, maker, shape, space, finish, clear=build == "clear")
    body = ag.weld(body, *marks, pumps.collar(nozzle, pump).at(z=height))
    head = pumps.nozzle(nozzle, pump, reach, travel).at(z=height + pumps.COLLAR + pumps.GAP + travel)
    turn = ag.Revolute(
        "nozzle_turn", axis=ag.Z, friction=turn_friction, damping=0.001, armature=0.00001, effort=0.6
    )
    stroke = pumps.slide("nozzle_slide", -ag.Z, travel, force, damping)
    body = body.attach(head, turn, stroke).output("soap", _dose(stroke), kind="flow")
    if style == "bottle":
        return body
    out = ag.max_(width / 2 + 0.016, reach + 0.010)
    # below the print, and below the level of the soap
    ring_at = mounts.TRAY + (0.13 if shape == "apothecary" else 0.22) * height
    metal = pump if pump.base_metalness > 0.5 else ag.colored("powder_coat", "black")
    wall_part = ag.weld(mounts.holder(width / 2, out, ring_at, metal), mounts.tile(0.11, wall))
    return ag.weld(body.at(z=mounts.TRAY - 0.0002), wall_part.at(y=out))


def _dose(stroke: ag.Joint) -> signals.Signal:
    """Return the signal of the soap that a stroke of the pump gives."""
    return signals.timer(signals.pressed(stroke), 0.4)
