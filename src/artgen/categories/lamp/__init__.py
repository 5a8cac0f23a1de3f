"""A lamp with working parts: arms that hold any pose, shades that turn, and a switch.

Links: `base`; `swivel`, `arm_lower`, `arm_upper` and `slider` of lamps with arms; `shade`; and the switch:
`button`, `rocker`, `dial` or `pull_chain`. Joints: `arm_swivel` (without limits), `arm_lower_hinge`,
`arm_upper_hinge`, `shade_hinge`, `height_slide` on a reading lamp, `shade_turn` of a shade on a harp, and
`switch_slide`, `switch_rock`, `switch_turn` or `switch_pull`.

Arms swing in the plane y = 0. At rest the arms are raised and the shade points down, as in a shop. Springs
and brakes carry the loads; their torques are derived from the mass and the reach of the parts beyond them.
Limits of arms follow from their lengths: a shade never moves below the hinge of the lowest arm. The mass of
the base is enough for stability in every pose.

Sizes are those of shops: desk lamps with arms of 0.3-0.45 m, table lamps 0.35-0.7 m and floor lamps
1.2-1.85 m high; sockets are E27 (IEC 60061), shades of cloth 0.26-0.46 m wide.
"""

from typing import Literal

import artgen as ag
from artgen.categories.lamp import arms, electrics, finish, shades, stands
from artgen.categories.lamp.finish import GLOBE, plastic, weighted

Style = Literal["desk", "architect", "led_bar", "reading", "floor", "tripod", "arc", "table", "mushroom"]

_STYLES = {"desk": 0.12, "architect": 0.12, "led_bar": 0.11, "reading": 0.13, "floor": 0.12, "tripod": 0.10,
           "arc": 0.07, "table": 0.17, "mushroom": 0.06}  # fmt: skip
_STALK = 0.060  # radius of the foot of a mushroom lamp [m]
_COVERS = (
    "the body on the base would cover the switch in it: raise base_radius, lower body_radius, "
    "or take switch_on=cord"
)
_TOO_LOW = (
    "the arm would strike the base at the lowest position of its clamp: raise height, or lower travel or "
    "arm_length"
)
_ON_CASE = 0.020  # height of a dial above its case on the cord, plus 3 mm [m]
_STEM = 0.14  # height between the hub of a tripod and its socket, for a chain [m]


@ag.category(
    labels="base foot pole swivel slider arm_lower arm_upper hinge spring shade socket bulb harp finial "
    "switch button rocker dial pull_chain cord print",
    joints=(1, 5),
)
def lamp(
    *,
    style: Style = ag.choice(_STYLES),
    base_shape: stands.BaseShape = ag.by(
        "style",
        arc={"round": 0.6, "square": 0.3, "hexagonal": 0.1},
        mushroom={"round": 0.85, "hexagonal": 0.15},
        tripod="round",
        otherwise={"round": 0.6, "square": 0.25, "hexagonal": 0.15},
    ),
    base_radius: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.085, 0.110),
        architect=ag.uniform(0.090, 0.115),
        led_bar=ag.uniform(0.085, 0.110),
        reading=ag.uniform(0.125, 0.150),
        floor=ag.uniform(0.125, 0.160),
        arc=ag.uniform(0.155, 0.180),
        table=ag.uniform(0.080, 0.105),
        mushroom=ag.uniform(0.080, 0.100),
        otherwise=0.1,
        unit="m",
        within=(0.08, 0.18),
    ),
    base_height: ag.Float = ag.by(
        "style",
        arc=ag.uniform(0.026, 0.036),
        table=ag.uniform(0.018, 0.028),
        otherwise=ag.uniform(0.017, 0.024),
        unit="m",
        doc="least radius or width of the base; a lamp that would tip has a larger base",
        within=(0.016, 0.08),
    ),
    height: ag.Float = ag.by(
        "style",
        reading=ag.uniform(1.22, 1.45),
        floor=ag.uniform(1.40, 1.75),
        tripod=ag.uniform(1.35, 1.60),
        arc=ag.uniform(1.62, 1.84),
        table=ag.uniform(0.46, 0.69),
        mushroom=ag.uniform(0.36, 0.50),
        otherwise=0.5,
        unit="m",
        doc="height of a lamp without arms; that of a desk lamp follows from its arms",
        within=(0.34, 1.85),
    ),
    arm_style: arms.ArmStyle = ag.choice("rods", "tube", "flat"),
    arm_length: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.34, 0.42),
        architect=ag.uniform(0.32, 0.38),
        led_bar=ag.uniform(0.36, 0.45),
        reading=ag.uniform(0.37, 0.44),
        otherwise=0.4,
        unit="m",
        doc="length of the lower arm",
        within=(0.3, 0.6),
    ),
    upper_arm: ag.Float = ag.uniform(
        0.90, 1.02, doc="length of an upper arm, as a share of that of the lower arm", within=(0.8, 1.1)
    ),
    lean: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.05, 0.40),
        architect=ag.uniform(0.36, 0.50),
        led_bar=ag.uniform(0.08, 0.25),
        reading=ag.uniform(0.95, 1.25),
        otherwise=0.0,
        unit="rad",
        doc="rest angle of the lower arm: back, or forward for a single arm",
    ),
    rise: ag.Float = ag.uniform(0.82, 0.98, "rad", doc="rest angle of an upper arm from the vertical"),
    tilt: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.75, 0.95),
        otherwise=ag.uniform(0.20, 0.40),
        unit="rad",
        doc="least forward tilt of a metal shade at rest",
    ),
    reach: ag.Float = ag.uniform(0.46, 0.62, "m", doc="reach of the bow of an arc lamp", within=(0.3, 0.8)),
    travel: ag.Float = ag.uniform(
        0.25, 0.40, "m", doc="travel of the reading lamp's clamp", within=(0.1, 0.5)
    ),
    shade: shades.ShadeKind = ag.by(
        "style",
        floor=ag.choice("drum", "cone", "curved"),
        tripod={"drum": 0.7, "cone": 0.3},
        arc={"dome": 0.6, "cone": 0.2, "curved": 0.2},
        table=ag.choice("cone", "drum", "curved"),
        mushroom={"dome": 0.45, "globe": 0.55},
        led_bar="drum",
        otherwise=ag.choice("cone", "dome", "curved", "drum"),
    ),
    shade_radius: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.066, 0.084),
        architect=ag.uniform(0.070, 0.088),
        reading=ag.uniform(0.062, 0.080),
        floor=ag.uniform(0.17, 0.23),
        tripod=ag.uniform(0.18, 0.23),
        arc=ag.uniform(0.11, 0.15),
        table=ag.uniform(0.135, 0.185),
        mushroom=ag.uniform(0.105, 0.150),
        otherwise=0.08,
        unit="m",
        doc="radius of the rim of the shade",
        within=(0.06, 0.26),
    ),
    shade_height: ag.Float = ag.by(
        "style",
        floor=ag.uniform(1.05, 1.30),
        tripod=ag.uniform(1.00, 1.25),
        table=ag.uniform(1.15, 1.40),
        mushroom=ag.uniform(0.86, 1.00),
        arc=ag.uniform(0.85, 1.00),
        otherwise=ag.by(
            "shade",
            cone=ag.uniform(1.45, 1.80),
            drum=ag.uniform(1.40, 1.80),
            dome=ag.uniform(1.25, 1.45),
            otherwise=ag.uniform(1.45, 1.70),
        ),
        doc="height of the shade, as a share of the radius of its rim",
        within=(0.7, 2.2),
    ),
    shade_top: ag.Float = ag.by(  # radius of the upper rim
        "shade",
        drum=ag.uniform(0.94, 0.99),
        cone=ag.uniform(0.52, 0.78),
        otherwise=ag.uniform(0.48, 0.58),
        doc="radius of the upper rim of a cloth shade, as a share of that of the lower rim",
        within=(0.4, 1.0),
    ),
    body: stands.BodyForm = ag.by(
        "style",
        table=ag.choice("vase", "gourd", "bottle", "column", "turned"),
        otherwise="column",
        doc="shape of the body of a table lamp",
    ),
    body_radius: ag.Float = ag.by(
        "body",
        vase=ag.uniform(0.075, 0.100),
        gourd=ag.uniform(0.075, 0.095),
        bottle=ag.uniform(0.068, 0.090),
        otherwise=ag.uniform(0.046, 0.058),
        unit="m",
        within=(0.04, 0.11),
    ),
    switch: Literal["button", "rocker", "dial", "pull_chain"] = ag.by(
        "style",
        floor={"pull_chain": 0.5, "button": 0.25, "rocker": 0.1, "dial": 0.15},
        tripod={"pull_chain": 0.3, "button": 0.35, "rocker": 0.15, "dial": 0.2},
        table=ag.by(
            "body",
            column={"pull_chain": 0.7, "rocker": 0.15, "dial": 0.15},
            turned={"pull_chain": 0.7, "rocker": 0.15, "dial": 0.15},
            otherwise=ag.choice("rocker", "dial", "button"),
        ),
        otherwise=ag.choice("button", "rocker", "dial"),
    ),
    switch_on: Literal["base", "cord", "socket"] = ag.by(
        "switch",
        pull_chain="socket",
        dial="cord",  # clear of the arms for a turning hand
        otherwise=ag.by(
            "style",
            desk={"base": 0.75, "cord": 0.25},
            architect={"base": 0.7, "cord": 0.3},
            led_bar="base",
            reading=ag.choice("base", "cord"),
            otherwise="cord",
        ),
    ),
    chain_travel: ag.Float = ag.uniform(0.030, 0.060, "m", doc="travel of a pull chain", within=(0.02, 0.07)),
    chain_force: ag.Float = ag.uniform(
        3.0, 8.0, "N", doc="spring force of a pulled chain", within=(2.0, 12.0)
    ),
    swivel_friction: ag.Float = ag.by(
        "style",
        reading=ag.uniform(1.5, 2.6),
        arc=ag.uniform(2.0, 3.5),
        otherwise=ag.uniform(0.9, 1.7),
        unit="N m",
        doc="friction of an arm on the base: 3-6 N at its end",
        within=(0.1, 6.0),
    ),
    shade_friction: ag.Float = ag.by(
        "shade",
        dome=ag.uniform(0.04, 0.08),  # turned by its knob
        otherwise=ag.uniform(0.30, 0.70),
        unit="N m",
        doc="friction of a shade on its harp",
        within=(0.01, 2.0),
    ),
    metal: ag.Material = ag.by(
        "style",
        floor=finish.FITTINGS,
        tripod=finish.FITTINGS,
        table=finish.FITTINGS,
        arc=finish.FITTINGS,
        otherwise=finish.COATS,
        doc="finish of arms, poles and bases",
    ),
    finish: ag.Material = ag.by(
        "style",
        floor=finish.CLOTHS,
        tripod=finish.CLOTHS,
        table=finish.CLOTHS,
        otherwise=finish.COATS,
        doc="finish of the shade",
    ),
    matching: bool = ag.by(
        "style",
        desk={True: 0.8, False: 0.2},
        architect=True,
        led_bar=True,
        reading={True: 0.8, False: 0.2},
        mushroom=True,
        otherwise=False,
        doc="whether the shade has the finish of the arms or the base",
    ),
    lining: ag.Material = ag.by(
        "style",
        floor=finish.CLOTH_LININGS,
        tripod=finish.CLOTH_LININGS,
        table=finish.CLOTH_LININGS,
        otherwise=finish.LININGS,
        doc="finish of the inside of the shade",
    ),
    stuff: ag.Material = ag.by(
        "style",
        table=finish.BODIES,
        tripod=finish.LEGS,
        arc=finish.STONES,
        otherwise=ag.shades("glass"),
        doc="material of a table lamp's body, a tripod's legs or the stone under an arc lamp",
    ),
    plastics: Literal["black", "white"] = ag.choice(
        {"black": 0.65, "white": 0.35}, doc="color of switch and cord"
    ),
) -> ag.Body:
    """Make a lamp for a desk, a table or the floor: arms, shade, switch."""
    dark, ink = plastic(plastics)
    coat = metal if matching else finish
    deep = shade_radius * shade_height
    carried: arms.Carried | None = None
    if style in arms.MAKERS:
        carried = arms.MAKERS[style](
            arms.Arms(
                head=shades.metal_head(shade, shade_radius, deep, coat, lining, metal),
                style=arm_style,
                finish=metal,
                length=arm_length,
                upper=arm_length * upper_arm,
                lean=lean,
                rise=rise,
                tilt=tilt,
                reach=reach,
                travel=travel,
                height=height - base_height,
                friction=swivel_friction,
            )
        )
    cover = shades.Spider(shade, shade_top * shade_radius, shade_radius, deep, coat, lining, metal)
    mouth = height - cover.crown  # height of the mouth of the socket
    foot = mouth - shades.SOCKET

    # the mass of the base keeps the lamp stable with its arms stretched out; the cord leaves at the back
    switched = None if switch == "pull_chain" else electrics.switch(switch, dark, ink, on=switch_on)
    on_cord = switched if switch_on == "cord" else None
    top: ag.Scalar = base_height
    if style == "tripod":
        top = foot - _STEM
        base = stands.tripod(0.17 * top + 0.03, top, stuff, metal)
        base = ag.weld(base, electrics.cord(dark, 0.05, 0.36, top - 0.015, on_cord, stiff=0.10))
    else:
        stone = stuff if style == "arc" else weighted(metal, 2800.0 if style == "table" else 4600.0)
        if carried is not None:
            top = stands.steady_height(base_shape, base_radius, stone.density, base_height, carried)
        edge = stands.base_edge(base_shape, base_radius)
        base = stands.weighted_base(base_shape, base_radius, top, stone)
        if switched is not None and switch_on == "base":
            covered: dict[str, ag.Scalar] = {"table": body_radius, "mushroom": _STALK}
            near = 0.62 * edge - electrics.HALF[switch]
            base = base.install(switched, at=(0, -0.62 * edge, top))
            base = base.require(near > covered.get(style, 0.0) + 0.001, _COVERS)
        base = ag.weld(base, electrics.cord(dark, edge, edge + 0.11, top / 2 + 0.001, on_cord))

    if carried is not None:
        level = top
        if style == "reading":
            level = height - 0.11 - travel  # lowest height of the clamp
            rail = stands.pole(arms.POLE, top - 0.001, height - 0.03, metal, capped=True)
            base = ag.weld(base, rail).require(level > top + carried.hangs + 0.01, _TOO_LOW)
        return electrics.lit(
            base.attach(carried.body.at(z=level), *carried.joints),
            switch,
            arms.LED if style == "led_bar" else shades.BULB,
        )

    under: ag.Scalar = top  # under a chain
    if style == "table":
        stand = stands.turned_lamp(body, body_radius, top - 0.001, foot, stuff, metal)
        under = stands.wide_up_to(body, electrics.BESIDE, body_radius, top, foot - stands.FITTING)
    elif style == "mushroom":
        foot = foot if shade == "dome" else height - 2 * shade_radius - 0.006
        # under a dome, the shade hides the socket
        ends = foot + 0.002 if shade == "globe" else mouth - 0.006
        stand = stands.turned_body("stem", _STALK, top - 0.001, ends, weighted(metal, 900.0))
        under = stands.wide_up_to("stem", electrics.BESIDE, _STALK, top, ends)
    else:
        stand = stands.pole(0.0115, top - 0.001, foot + 0.003, metal)
    if shade == "globe":
        return electrics.lit(shades.globed(ag.weld(base, stand), foot, shade_radius, metal), switch, GLOBE)
    chain = electrics.Chain(chain_travel, chain_force, under) if switch == "pull_chain" else None
    low: ag.Scalar = 0.002 if style == "tripod" else top + 0.002  # the shade is above the base
    over = ag.max_(low, electrics.CASE[2] + _ON_CASE) if switch_on == "cord" else low
    return electrics.lit(
        cover.on(ag.weld(base, stand), mouth, shade_friction, over, chain), switch, shades.BULB, cloth=coat
    )
