"""A range hood: with a chimney, of curved glass, below a cabinet, telescopic, inclined, or over an island.

Links: `hood`; `filter_0`, ... with their catches `catch_0`, ...; `visor` of a telescopic hood; `flap` of one
below a cabinet; `panel` of an inclined one; `button_0`, ...; `slider_0`, ...; `dial`. Joints:
`filter_hinge_0`, `catch_slide_0`, ...; `visor_slide`; `flap_hinge`; `panel_hinge`; `button_slide_0`, ...;
`slider_slide_0`, ...; `dial_turn`.

A filter rests on a lip by its catch: a finger pushes the catch back, and the filter swings down by its
weight. Friction holds the flap and the panel at any angle, and the visor wherever it is. Hoods hang on a wall
or from a ceiling; here the lowest point is at z = 0, and the wall is at the back.

Sizes are those of shops: hoods with a chimney are 0.6 or 0.9 m wide, 0.45-0.52 m deep, 0.75-1.1 m high and
weigh 10-21 kg (Bosch DWB66BC50: 11.6 kg; DWB97: 16.5 kg), hoods of curved glass the same; hoods below a
cabinet 0.6 m wide, 0.48-0.52 m deep, 0.16-0.22 m high, 5-9 kg; telescopic hoods 0.6 m wide, 0.28-0.32 m deep,
0.35-0.40 m high, 7-11 kg (Bosch DFM064: 8.2 kg); inclined hoods 0.6-0.9 m wide, 0.34-0.45 m deep, 0.8-1.1 m
high with their chimney, 14-27 kg (Bosch DWK87: 20 kg); hoods over islands 0.9-1.0 m wide, 0.6-0.7 m deep,
0.7-1.1 m high, 22-36 kg (Bosch DIB97: 27 kg).
"""

from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.range_hood import fronts
from artgen.categories.range_hood.parts import (
    LAMP,
    TAB,
    Look,
    Mesh,
    duct,
    lamps,
    name_of,
    with_filters,
    with_keys,
)
from artgen.categories.shared import controls, require_size
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.finish import colors

Style = Literal["chimney", "glass", "cabinet", "telescopic", "inclined", "island"]
"""A canopy with a chimney on a wall, with a curved pane, a flat one below a cabinet, one with a visor, behind
an inclined pane, or over an island."""

_SPANS = {
    "chimney": ((0.5, 1.0), (0.40, 0.70), (0.50, 1.3)),
    "glass": ((0.55, 1.0), (0.42, 0.70), (0.40, 1.3)),
    "cabinet": ((0.45, 0.95), (0.40, 0.70), (0.15, 0.40)),
    "telescopic": ((0.45, 0.95), (0.26, 0.40), (0.30, 0.60)),
    "inclined": ((0.5, 1.0), (0.34, 0.60), (0.60, 1.3)),
    "island": ((0.75, 1.2), (0.50, 0.75), (0.50, 1.3)),
}
"""Possible widths, depths and heights of each style [m]."""

_STEEL = ag.material("stainless")
_DARK_STEEL = _STEEL.with_(name="black_stainless", base_color=(0.105, 0.105, 0.110))
_FINISHES = ag.by(
    "style",
    inclined=ag.shades("powder_coat_black", "powder_coat_white", "stainless", weights=(4, 2, 1), color=0.03),
    cabinet=ag.shades("enamel_white", "stainless", *colors("powder_coat", "graphite cream"),
                      weights=(3, 3, 1, 1), color=0.03),
    telescopic=ag.shades("stainless", "powder_coat_white", "powder_coat_black",
                         weights=(3, 1, 1), color=0.03),
    otherwise=ag.shades("stainless", "powder_coat_black", "powder_coat_white",
                        _DARK_STEEL,
                        ag.colored("powder_coat", "sage"), "copper", weights=(6, 2, 2, 2, 1, 1), color=0.03),
)  # fmt: skip
_GLASSES = ag.choice(
    ag.material("black_glass"),
    ag.material("black_glass").with_(name="white_glass", base_color=(0.75, 0.75, 0.74)),
    ag.material("black_glass").with_(name="grey_glass", base_color=(0.12, 0.125, 0.13)),
    weights=(4, 2, 1),
)


@ag.category(
    labels="hood chimney filter mesh catch lamp visor flap panel glass handle slider button bezel dial print",
    joints=(5, 11),
)
def range_hood(
    *,
    style: Style = ag.choice(
        {
            "chimney": 0.28,
            "glass": 0.14,
            "cabinet": 0.18,
            "telescopic": 0.14,
            "inclined": 0.16,
            "island": 0.10,
        }
    ),
    canopy: Literal["pyramid", "box"] = ag.by(
        "style",
        chimney={"pyramid": 0.6, "box": 0.4},
        island={"pyramid": 0.3, "box": 0.7},
        otherwise="box",
        doc="a pyramid or a flat box below the chimney",
    ),
    width: ag.Float = ag.by(
        "style",
        chimney=ag.choice(0.598, 0.698, 0.898),
        glass=ag.choice(0.598, 0.898),
        inclined=ag.choice(0.59, 0.79, 0.89),
        island=ag.choice(0.898, 0.998),
        otherwise=0.598,
        unit="m",
        within=(0.45, 1.2),
    ),
    depth: ag.Float = ag.by(
        "style",
        chimney=ag.uniform(0.46, 0.51),
        glass=ag.uniform(0.46, 0.50),
        cabinet=ag.uniform(0.47, 0.51),
        telescopic=ag.uniform(0.275, 0.30),
        inclined=ag.uniform(0.36, 0.41),
        island=ag.uniform(0.60, 0.68),
        unit="m",
        within=(0.26, 0.75),
    ),
    height: ag.Float = ag.by(
        "style",
        cabinet=ag.uniform(0.152, 0.190),
        telescopic=ag.uniform(0.35, 0.39),
        inclined=ag.uniform(0.80, 1.05),
        otherwise=ag.uniform(0.72, 1.05),
        unit="m",
        within=(0.14, 1.3),
        doc="height with the chimney",
    ),
    mesh: Mesh = ag.choice({"mesh": 0.5, "baffle": 0.3, "slots": 0.2}),
    knob: bool = ag.by(
        "style", chimney={True: 0.3, False: 0.7}, otherwise=False, doc="a dial instead of keys"
    ),
    friction: ag.Float = ag.uniform(1.15, 1.5, doc="friction of a flap or panel over its weight"),
    finish: ag.Material = _FINISHES,
    glass: ag.Material = _GLASSES,
    metal: ag.Material = ag.shades("stainless", "chrome", "black_anodised", weights=(3, 1, 1), color=0.03),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a hood with its filters up."""
    width, depth, height = (
        require_size(value, span, f"{name} of a {style} hood")
        for name, value, span in zip(
            ("width", "depth", "height"), (width, depth, height), _SPANS[style], strict=True
        )
    )
    look = Look(finish, metal, mesh, knob, maker)
    plan = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (TAB, TAB + height))
    match style:
        case "cabinet":
            return fronts.cabinet(plan, look, friction)
        case "telescopic":
            return fronts.telescopic(plan, look)
        case "inclined":
            return fronts.inclined(plan, look, glass, friction)
        case "glass":
            return fronts.curved(plan, look)
    return _chimney(plan, look, canopy, island=style == "island")


def _chimney(plan: ag.Region, look: Look, canopy: str, *, island: bool) -> ag.Body:
    """Make a canopy below a chimney, on a wall or over an island."""
    thick = 0.062 if canopy == "box" else 0.050
    slab = plan.with_(z=(plan.z.low, plan.z.low + thick))
    y = 0.0 if island else plan.y.high - 0.132
    deep = 0.28 if island else 0.262
    hood = ag.part(
        slab.box(bevel=0.002), "hood", filled(look.finish, 520.0 if island else 390.0, "canopy"), name="hood"
    )
    top = slab.z.high
    if canopy == "pyramid":
        crown = top + 0.19
        roof = ag.hull(
            slab.with_(z=(top - 0.002, top)).shrink(x=0.001, y=0.001).box(),
            ag.Region((-0.15, 0.15), (y - deep / 2 - 0.008, y + deep / 2), (crown - 0.004, crown)).box(),
        )
        hood = ag.weld(hood, ag.part(roof, "hood", filled(look.finish, 210.0, "roof")))
        top = crown
    hood = ag.weld(hood, duct(plan, look, top, y, deep))
    front = plan.y.low
    margin = 0.075 if not island else 0.095
    room = slab.shrink(x=0.035, front=margin, back=0.035 if not island else 0.095)
    hood = with_filters(hood, room, look, 3 if island else 2)
    spots = [(x * plan.x.high * 0.62, front + 0.55 * margin) for x in (-1, 1)]
    if island:
        spots += [(x, -y_) for x, y_ in spots]
    hood = ag.weld(hood, *lamps(spots, plan.z.low, look.metal))
    level = plan.z.low + 0.5 * thick
    if not look.knob:
        hood = with_keys(hood, look, (0.0, front, level))
        return ag.weld(hood, name_of(look, (-0.36 * plan.x.size, front, level)))
    turn = controls.dial_turn(
        "dial_turn", low=0.0, high=3.6, friction=0.02, clicks=[0.9 * n for n in range(5)], torque=0.05
    )
    scale = controls.dial_print(0.018, ink=look.ink, style="ticks", count=3, sweep=3.6, start=0.0)
    knob = controls.dial(turn, "capped", 0.018, look.metal, depth=0.020, cap=look.metal, scale=scale)
    hood = hood.install(knob, at=(0.06, front, level))
    light = controls.push_button(
        finish=look.metal,
        through=0.0125,
        width=0.016,
        icon="light",
        ink=controls.ink_on(look.metal),
        plate=look.metal,
    ).suffixed("_0")
    hood = hood.install(light, at=(-0.06, front, level))
    hood = hood.output("fan", signals.level(turn), kind="flow")
    shines = signals.toggle(signals.pressed("button_slide_0"))
    hood = hood.output("light", shines, kind="light", material=LAMP)
    return ag.weld(hood, name_of(look, (-0.36 * plan.x.size, front, level)))
