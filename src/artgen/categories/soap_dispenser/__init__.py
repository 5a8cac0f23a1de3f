"""A soap dispenser: a bottle with a pump, on the sink or in a holder on the wall, or a box on the wall.

Links: `body`; `nozzle`, which moves down against the pump's spring and turns on its stem without limits, with
two joints between the same links; or `button` or `lever` of a box. Joints: `nozzle_slide`, `nozzle_turn`;
`button_slide`; `lever_hinge`. Springs return the pressed parts.

A wall dispenser comes with its wall tile. A pump needs 8 to 25 N and gives 1-2 ml per stroke of 12-20 mm.
Sizes are those of bathroom catalogs: 13-21 cm high with the pump, 62-90 mm wide, 0.2 to 0.45 l.
"""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.soap_dispenser.bottles import (
    LABELLED,
    PRINTED,
    WORDS,
    Content,
    Print,
    Shape,
    Sizes,
    clear,
    marks,
    opaque,
)
from artgen.categories.soap_dispenser.finish import (
    CERAMIC_WEIGHTS,
    CERAMICS,
    GLASS_WEIGHTS,
    GLASSES,
    METAL_WEIGHTS,
    METALS,
    PLASTIC_WEIGHTS,
    PLASTICS,
    PUMP_WEIGHTS,
    PUMPS,
    SOAPS,
    STEEL_WEIGHTS,
    STEELS,
    TILES,
    ink_on,
)
from artgen.categories.soap_dispenser.pump import (
    COLLAR,
    GAP,
    Nozzle,
    PumpLooks,
    collar,
    nozzle_body,
    nozzle_turn,
    pump_slide,
)
from artgen.categories.soap_dispenser.wall import TRAY, Press, holder, lever_hinge, panel, tile, wall_box

Build = Literal["clear", "ceramic", "plastic", "steel"]

_CLEAR: tuple[Shape, ...] = ("round", "square", "cube", "hexagonal", "cone", "bell", "apothecary")
_HELD: tuple[Shape, ...] = ("round", "apothecary")


@ag.category(
    labels=(
        "body",
        "collar",
        "stem",
        "nozzle",
        "cap",
        "pump",
        "dip_tube",
        "soap",
        "tile",
        "holder",
        "button",
        "lever",
        "window",
        "lock",
        "label",
        "screw",
        "print",
    ),
    joints=(1, 2),
)
def soap_dispenser(
    *,
    style: Literal["bottle", "holder", "box"] = ag.choice(
        "bottle", "holder", "box", weights=(0.76, 0.10, 0.14)
    ),
    shape: Shape = ag.by(
        "style",
        bottle=ag.choice(
            "round",
            "square",
            "cube",
            "oval",
            "hexagonal",
            "amphora",
            "cone",
            "bell",
            "apothecary",
            "ribbed",
            "beehive",
            weights=(0.15, 0.10, 0.08, 0.10, 0.08, 0.08, 0.08, 0.08, 0.12, 0.07, 0.06),
        ),
        holder=ag.choice(*_HELD),
        box="square",
    ),
    build: Build = ag.by(
        "style",
        bottle=ag.by(
            "shape",
            round=ag.choice("clear", "ceramic", "plastic", "steel", weights=(0.25, 0.30, 0.15, 0.30)),
            square=ag.choice("clear", "ceramic", "plastic", "steel", weights=(0.4, 0.25, 0.15, 0.2)),
            cube=ag.choice("clear", "ceramic", weights=(0.6, 0.4)),
            hexagonal=ag.choice("clear", "ceramic", "plastic", weights=(0.45, 0.4, 0.15)),
            oval=ag.choice("ceramic", "plastic", weights=(0.3, 0.7)),
            cone=ag.choice("clear", "ceramic", "plastic", "steel", weights=(0.3, 0.35, 0.15, 0.2)),
            bell=ag.choice("clear", "ceramic", weights=(0.35, 0.65)),
            apothecary=ag.choice("clear", "plastic", weights=(0.8, 0.2)),
            otherwise=ag.choice("ceramic", "plastic", weights=(0.85, 0.15)),
        ),
        holder=ag.choice("clear", "plastic", "steel", weights=(0.4, 0.3, 0.3)),
        box=ag.choice("plastic", "steel", weights=(0.6, 0.4)),
    ),
    nozzle: Nozzle = ag.by(
        "build",
        plastic=ag.choice("saddle", "beak", "foamer", "bar", weights=(0.45, 0.25, 0.2, 0.1)),
        clear=ag.choice(
            "saddle", "beak", "gooseneck", "bar", "swan", "foamer", weights=(0.22, 0.2, 0.2, 0.16, 0.14, 0.08)
        ),
        ceramic=ag.choice(
            "saddle", "beak", "gooseneck", "bar", "swan", weights=(0.14, 0.26, 0.24, 0.2, 0.16)
        ),
        steel=ag.choice("beak", "gooseneck", "bar", "swan"),
    ),
    press: Press = ag.choice("button", "lever", doc="pressed part of a box"),
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
        "build",
        clear=ag.shades(*GLASSES, weights=GLASS_WEIGHTS, color=0.03, roughness=0.0),
        ceramic=ag.shades(*CERAMICS, weights=CERAMIC_WEIGHTS, color=0.05),
        plastic=ag.shades(*PLASTICS, weights=PLASTIC_WEIGHTS, color=0.04),
        steel=ag.shades(*STEELS, weights=STEEL_WEIGHTS, color=0.03),
    ),
    pump: ag.Material = ag.by(
        "nozzle",
        saddle=ag.shades(*PUMPS, weights=PUMP_WEIGHTS, color=0.04),
        foamer=ag.shades(*PUMPS, weights=PUMP_WEIGHTS, color=0.04),
        beak=ag.shades(
            *METALS, *PUMPS, weights=(*METAL_WEIGHTS, *(1.2 * each for each in PUMP_WEIGHTS)), color=0.03
        ),
        otherwise=ag.shades(*METALS, weights=METAL_WEIGHTS, color=0.03),
    ),
    soap: ag.Material = ag.choice(*SOAPS, doc="contents of a clear bottle, or of the window of a box"),
    fill: ag.Float = ag.uniform(
        0.45, 0.78, doc="fill level of a clear bottle, as a share", within=(0.2, 0.8)
    ),
    wall: ag.Material = ag.shades(*TILES, color=0.03, doc="tile behind a wall dispenser"),
    content: Content = ag.choice("soap", "hand_wash", "lotion", "dish_soap", weights=(0.4, 0.25, 0.2, 0.15)),
    print_: Print = ag.by(
        "build",
        clear=ag.choice("none", "word", "icon", "label", weights=(0.35, 0.2, 0.1, 0.35)),
        plastic=ag.choice("none", "word", "icon", "label", weights=(0.2, 0.2, 0.2, 0.4)),
        otherwise=ag.choice("none", "word", "icon", weights=(0.5, 0.35, 0.15)),
        doc="print on a bottle without ribs",
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a soap dispenser, its pump up: a nozzle that slides and turns, or a button."""
    if style == "box":
        body = wall_box(
            box_width,
            box_depth,
            finish=finish,
            soap=soap,
            ink=ink_on(finish),
            fill=fill,
            maker=maker,
            word=" ".join(WORDS[content]),
        )
        body = ag.weld(body, tile(1.5 * box_width, wall))
        pressed = panel(box_width, box_depth, press=press, travel=travel, finish=finish, ink=ink_on(finish))
        if press == "button":
            return body.attach(
                pressed,
                pump_slide("button_slide", travel=travel, force=force, damping=damping, axis=(0.0, 1.0, 0.0)),
            )
        hinge = lever_hinge(box_depth, swing=swing, force=force, damping=0.0025 * damping)
        return body.attach(pressed, hinge)

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
    sizes = Sizes(width, depth, height)
    is_clear = build == "clear"
    if is_clear:
        body = clear(shape, sizes, finish, soap, fill=fill, plastic=ag.material("polypropylene"))
    else:
        body = opaque(shape, sizes, finish)
    shown = print_ if shape in PRINTED and (print_ != "label" or shape in LABELLED) else "none"
    body = ag.weld(
        body, *marks(shown, content, maker, shape=shape, sizes=sizes, ink=ink_on(finish), clear=is_clear)
    )

    is_metal = pump.base_metalness > 0.5
    looks = PumpLooks(
        pump,
        ag.material("chrome" if is_metal else "polypropylene"),
        ribbed=not is_metal,
        ink=None if is_metal else ink_on(pump),
    )
    head = nozzle_body(nozzle, reach=reach, travel=travel, looks=looks)
    body = ag.weld(body, collar(nozzle, height, looks))
    body = body.attach(
        head.at(0.0, 0.0, height + COLLAR + GAP + travel),
        nozzle_turn(turn_friction),
        pump_slide(travel=travel, force=force, damping=damping),
    )
    if style == "bottle":
        return body
    out = ag.max_(width / 2.0 + 0.016, reach + 0.010)
    # below the print, and below the level of the soap
    ring_at = TRAY + (0.13 if shape == "apothecary" else 0.22) * height
    hung = holder(width / 2.0, out, ring_at, ag.colored("powder_coat", "black") if not is_metal else pump)
    return ag.weld(body.at(0.0, 0.0, TRAY - 0.0002), ag.weld(hung, tile(0.11, wall)).at(0.0, out, 0.0))
