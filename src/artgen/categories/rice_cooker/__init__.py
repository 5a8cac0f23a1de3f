"""A rice cooker: with a hinged lid and a bail, upright with a lock, with a lever; a pressure or slow cooker.

Links: `body`, `pot`, `lid`; `open`, the button of a hinged lid, or `lock`, its handle that turns, and the
`latch` that they draw; `vent`, the cap of its vent, and `bail`; `lever`; `valve`, the outlet of a pressure
cooker; `dial`; `button_0`, .... Joints: `lid_hinge`, or `lid_lift` and `lid_turn`; `pot_lift`; `open_slide`,
`lock_turn`, `latch_slide`; `vent_lift`, `bail_swing`; `lever_slide`; `valve_turn`; `dial_turn`;
`button_slide_0`, ....

A hinged lid opens while its button is pressed, or after its lock is turned, which draws the latch; then it
stays where it is left. The bail swings up over it. A lid on a bayonet turns by half a radian, and then it
lifts. The pot lifts out below an open lid. A lever stays down while it cooks.

Sizes are those of shops. Cookers of 1.0 l with a hinged lid are 0.26-0.29 m wide, 0.31-0.39 m deep and
0.19-0.23 m high and weigh 3-4.7 kg (Zojirushi NS-ZCC10: 4.1 kg; Tiger JBV-A10: 3.1 kg); upright induction
cookers are 0.26-0.29 by 0.30-0.37 by 0.24-0.30 m, 4-7 kg (Cuckoo CRP-P0609: 5.7 kg). Simple ones with a lid
of glass are 0.19-0.28 m wide without handles, 0.20-0.29 m high, and weigh 1.3-3.2 kg (Zojirushi NHS-06 and
NHS-18); pressure cookers of 5.7 l are 0.30-0.37 m wide, 0.30-0.34 m high, 5-7 kg (Instant Pot Duo: 5.4 kg);
oval slow cookers of 3.5-6 l 0.38-0.46 by 0.27-0.33 by 0.21-0.28 m, 4-7 kg (Crock-Pot SCV600). They are empty.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.rice_cooker import hinged
from artgen.categories.rice_cooker.inside import (
    FEET,
    FLOOR,
    HAND,
    UP,
    Look,
    glass_lid,
    heater,
    inner_pot,
    lid_lift,
    lifts_out,
    side_handles,
    well,
)
from artgen.categories.rice_cooker.keys import FOUR, with_keys
from artgen.categories.shared import controls, require_size, vessels
from artgen.categories.shared.appliances import cord_stub, filled
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["hinged", "upright", "lever", "pressure", "slow"]
"""With a hinged lid and a bail, an upright induction cooker, with a lever, a pressure or a slow cooker."""

_AWAY = 0.20  # height of a lid above a pot that a hand reaches [m]
_LEVER = 0.009  # travel of a lever [m]
_TWIST = 0.52  # turn of a bayonet [rad]
_DIAL = 2.4  # turn of the dial of a slow cooker [rad]
_SPANS = {"hinged": (0.24, 0.29), "upright": (0.25, 0.30), "lever": (0.17, 0.30),
          "pressure": (0.27, 0.34), "slow": (0.30, 0.42)}  # fmt: skip
_BRUSHED = ag.material("stainless").with_(name="stainless_round", turned=True)
_STEEL = ag.material("stainless")
_RED = ag.colored("abs", "red")
_BLACK = ag.material("black_abs")
_STONE = ag.colored("enamel", "black").with_(name="stoneware", density=2250.0)
_FINISHES = ag.by(
    "style",
    hinged=ag.shades(*colors("glossy_plastic", "white cream red graphite black"), "stainless",
                     weights=(3, 1, 1, 1, 1, 2), color=0.03),
    upright=ag.shades(*colors("glossy_plastic", "white black graphite burgundy sand"),
                      weights=(2, 2, 1, 1, 1), color=0.03),
    lever=ag.shades(*colors("enamel", "white cream red mint sky"), _BRUSHED,
                    weights=(3, 1, 1, 1, 1, 2), color=0.03),
    otherwise=ag.shades(_BRUSHED, ag.colored("powder_coat", "red"), ag.colored("powder_coat", "black"),
                        ag.colored("powder_coat", "cream"), weights=(2, 1, 1, 1), color=0.03),
)  # fmt: skip
_GRIPS = ag.by(
    "style",
    hinged=ag.shades("black_abs", *colors("abs", "light_grey graphite"), color=0.03),
    upright=ag.shades("black_abs", ag.colored("abs", "graphite"), color=0.03),
    otherwise=ag.shades("black_abs", color=0.03),
    doc="keys, knobs and handles",
)


@ag.category(
    labels="body foot heater hinge latch trim lid gasket knob handle pot lever valve vent dial button "
    "display panel bezel cord rating_plate print",
    joints=(3, 12),
)
def rice_cooker(
    *,
    style: Style = ag.choice(
        {"lever": 0.34, "pressure": 0.15, "hinged": 0.19, "slow": 0.13, "upright": 0.19}
    ),
    width: ag.Float = ag.by(
        "style",
        hinged=ag.uniform(0.250, 0.270),
        upright=ag.uniform(0.262, 0.285),
        lever=ag.uniform(0.195, 0.270),
        pressure=ag.uniform(0.285, 0.315),
        slow=ag.uniform(0.320, 0.380),
        unit="m",
        within=(0.17, 0.42),
        doc="width of the case without handles",
    ),
    tall: ag.Float = ag.by(
        "style",
        hinged=ag.uniform(0.76, 0.83),
        upright=ag.uniform(0.90, 0.98),
        lever=ag.uniform(0.72, 0.86),
        pressure=ag.uniform(0.74, 0.84),
        slow=ag.uniform(0.47, 0.53),
        within=(0.45, 1.0),
        doc="height over the width: of a hinged cooker with its lid, otherwise up to the rim",
    ),
    slope: ag.Float = ag.by(
        "style",
        hinged=ag.uniform(0.035, 0.055),
        upright=ag.uniform(0.008, 0.018),
        otherwise=0.0,
        unit="m",
        within=(0.0, 0.07),
        doc="how far the front edge of a hinged cooker stands out at the table",
    ),
    finish: ag.Material = _FINISHES,
    trim: ag.Material = ag.shades("chrome", "stainless", "satin_brass", weights=(3, 3, 1), color=0.03),
    grip: ag.Material = _GRIPS,
    force: ag.Float = ag.uniform(3.0, 5.0, "N", doc="force at which a lever snaps"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed cooker with an empty pot."""
    width = require_size(width, _SPANS[style], f"width of a {style} cooker")
    look = Look(finish, trim, grip, maker)
    if style in ("hinged", "upright"):
        plan = hinged.Plan(width, tall * width, slope, look, upright=style == "upright")
        return hinged.hinged(plan)
    if style == "lever":
        return _simple(width / 2, tall * width, look, force)
    if style == "pressure":
        return _pressure(width / 2, tall * width, look)
    return _slow(width / 2, tall * width, look)


def _backed(body: ag.Body, look: Look, y: ag.Scalar, watts: int) -> ag.Body:
    """Add the cord and the rating plate at the back."""
    lines = (f"{look.maker.upper()} {watts} W", "220-240 V~ 50/60 Hz")
    return ag.weld(
        body,
        cord_stub(height=0.024).at(0, y - 0.002, 0.024),
        details.rating_plate(0.040, 0.016, lines, at=(0, y + 0.0006, 0.060), facing=ag.Y),
    )


def _level(share: float, deck: ag.Scalar) -> ag.Scalar:
    """Return the height of handles: at a share of a case, but above the table by half a hand."""
    return ag.max_(share * deck, ag.min_(0.106, deck - 0.014))


def _feet(radius: ag.Scalar, share: float = 1.0) -> ag.Body:
    """Make four feet on a circle, or on an oval."""
    foot = ag.cylinder(0.009, FEET + 0.001, bevel=0.001)
    turns = [math.pi / 4 + quarter * math.pi / 2 for quarter in range(4)]
    at = [(radius * math.cos(turn), share * radius * math.sin(turn), (FEET + 0.001) / 2) for turn in turns]
    return ag.part([foot.at(*each) for each in at], "foot", ag.material("rubber"))


def _simple(half: ag.Scalar, high: ag.Scalar, look: Look, force: ag.Scalar) -> ag.Body:
    """Make a round cooker with a lid of glass and a lever."""
    radius, deck = half - 0.018, high - UP
    case = ag.cylinder(half, deck - FEET, bevel=0.009).at(z=(deck + FEET) / 2)
    case -= well(radius, high, room=False)
    base = ag.cylinder(half + 0.0012, 0.016, bevel=0.002).at(z=FEET + 0.008)
    collar = ag.tube(radius + 0.010, radius + 0.0026, 0.003, bevel=0.001).at(z=deck)
    body = ag.weld(
        ag.part(case, "body", look.hollow(330.0), name="body"),
        side_handles(half + 0.005, _level(0.80, deck), (0.034, 0.076, 0.016), look.grip),
        ag.detail(base, "trim", _BLACK),
        ag.detail(collar, "trim", look.trim),
        heater(radius),
        _feet(half - 0.016),
    )
    body = _backed(_lever(body, half, look, force), look, half, 500)
    lid = glass_lid(radius + 0.0018, 0.030, look.grip)
    lift = lid_lift()
    turn = ag.Revolute("lid_turn", axis=ag.Z, friction=0.02, damping=0.01, effort=5.0)
    pot = inner_pot(radius, high - FLOOR - 0.0010, when=lift > _AWAY).at(z=FLOOR + 0.0006)
    pot = pot.attach(lid, lift, turn, at=(0, 0, high + 0.0002))
    return body.attach(pot, lifts_out(high - FLOOR + 0.02))


def _lever(body: ag.Body, half: ag.Scalar, look: Look, force: ag.Scalar) -> ag.Body:
    """Add the switch with its lever, which a finger pushes down to cook."""
    face, level = -half - 0.010, 0.054
    block = ag.Region((-0.034, 0.034), (face, 0.012 - half), (0.016, 0.094))
    slot = ag.Region((-0.0062, 0.0062), (face - 0.02, 0.004 - half), (level - 0.0146, level + 0.0056))
    box = ag.part(block.box(bevel=0.004), "panel", casting(look.grip, 0.5))
    stem = ag.Region((-0.0050, 0.0050), (face - 0.004, 0.0020 - half), (level - 0.0045, level + 0.0045)).box()
    tongue = ag.box(0.032, 0.020, 0.0095, bevel=0.003).at(0, face - 0.0116, level)
    push, hold = (
        ag.push_on(tongue, direction=-ag.Z),
        ag.grasp_on(tongue, approach=ag.Y, closing=ag.X, depth=0.012),
    )
    lever = ag.part([tongue, stem], "lever", _RED, name="lever", push=push, grasp=hold)
    slide = ag.Prismatic(
        "lever_slide", axis=-ag.Z, limits=(0, _LEVER), detents=feel.detents((0.0, _LEVER), force),
        friction=0.4, damping=4.0, armature=0.03, effort=20.0,
    )  # fmt: skip
    ink = controls.ink_on(look.grip)
    signs = []
    for word, z, lamp in (("WARM", 0.078, "led_amber"), ("COOK", 0.028, "led_red")):
        signs += [
            details.printed(details.lettering((word,), 0.0042), (0.004, face, z), material=ink),
            details.printed(ag.circle(0.0024), (-0.018, face, z), material=ag.material(lamp)),
        ]
    band = ag.line((half, 0, 0.10), (half, 0, 0.30))
    name = details.wrapped(details.logo(look.maker, 0.008), band, 0.118, material=look.ink)
    body = body.cut(slot.grow(0.001, front=0).box())
    body = ag.weld(body, box.cut(slot.box()), *signs, name).attach(lever, slide)
    return body.output("cook", signals.pressed(slide), kind="heat")


def _pressure(half: ag.Scalar, high: ag.Scalar, look: Look) -> ag.Body:
    """Make a pressure cooker, whose lid turns on its bayonet before it lifts."""
    high = ag.require(high, high >= 0.20, "height of a pressure cooker up to its rim must be >= 0.2 m")
    radius, neck, deck = half - 0.0425, half - 0.016, high - 0.0165
    lugs, hooks = (each.mirror(ag.Z).at(z=high) for each in vessels.bayonet(neck))
    case = ag.cylinder(half, deck - FEET, bevel=0.004).at(z=(deck + FEET) / 2)
    case -= well(radius, high, room=False)
    ring = vessels.hoop(neck, radius + HAND, high - deck + 0.004, 14).at(z=(high + deck - 0.004) / 2)
    brim = ag.tube(neck, radius + HAND, high - deck).at(z=(high + deck) / 2)
    base = ag.cylinder(half + 0.0012, 0.030, bevel=0.004).at(z=FEET + 0.015)
    crown = ag.tube(half + 0.0014, half - 0.004, 0.026, bevel=0.0024).at(z=deck - 0.0125)
    black = look.grip
    front = ag.Region((-0.064, 0.064), (-half - 0.012, 0.030 - half), (0.048, 0.168)).box(bevel=0.006)
    body = ag.weld(
        ag.part(case, "body", look.hollow(385.0), name="body"),
        ag.part(front, "panel", casting(black, 0.6)),
        ag.part([ring, lugs], "body", _STEEL),
        ag.detail(brim, "body", _STEEL),
        side_handles(half + 0.005, deck - 0.022, (0.038, 0.090, 0.020), black),
        ag.detail([base, crown], "trim", black),
        heater(radius),
        _feet(half - 0.02),
    )
    body = with_keys(
        body, look, FOUR, at=(0, -half - 0.012, 0.108), lean=0.0, size=(0.116, 0.104), text="0:25",
        color="cyan", dial=True,
    )  # fmt: skip
    body = _backed(body, look, half, 1000)
    turn = ag.Revolute("lid_turn", axis=ag.Z, limits=(0, _TWIST), friction=0.5, damping=0.1, effort=20.0)
    out = high - FLOOR + 0.02
    lift = ag.Prismatic(
        "lid_lift", axis=ag.Z, limits=(0, out + 0.25), friction=0.1, damping=2.0, effort=80.0,
        needs=(turn > _TWIST - 0.04).beyond(0.0008),
    )  # fmt: skip
    body = body.attach(_cap(neck, high + FIT.running, hooks, look), lift, turn)
    pot = inner_pot(radius, high - FLOOR - 0.0012).at(z=FLOOR + 0.0006)
    return body.attach(pot, lifts_out(out, (lift > out + _AWAY).beyond(0.0002)))


def _cap(neck: ag.Scalar, low: ag.Scalar, hooks: ag.Solid, look: Look) -> ag.Body:
    """Make the lid of a pressure cooker, with its handle and the valve that lets steam out."""
    edge, rise = neck + 0.0125, 0.036
    plate = ag.cylinder(edge, 0.0060, bevel=0.0012).at(z=low + 0.0030)
    dome = ag.frustum(edge - 0.004, 0.70 * edge, rise, bevel=0.007).at(z=low + 0.002 + rise / 2)
    skirt = ag.tube(edge, edge - 0.0012, 0.0150).at(z=low - 0.0060)
    ring = ag.tube(edge + 0.0004, edge - 0.002, 0.004, bevel=0.001).at(z=low + 0.0030)
    seal = ag.tube(neck - 0.006, neck - 0.014, 0.0008).at(z=low - 0.0001)
    top = low + 0.002 + rise
    bar = ag.box(0.124, 0.030, 0.020, bevel=0.008).at(z=top + 0.036)
    posts = [ag.box(0.026, 0.024, 0.034, bevel=0.005).at(side * 0.044, 0, top + 0.014) for side in (-1, 1)]
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, depth=0.017)
    pin = ag.cylinder(0.0034, 0.003, bevel=0.0008).at(-0.040, 0.048, top + 0.001)
    name = details.printed(
        details.logo(look.maker, 0.0075), (0, -0.046, top), material=controls.ink_on(look.grip), facing=ag.Z
    )
    lid = ag.weld(
        ag.part([bar, *posts], "handle", casting(look.grip, 0.7), name="lid", grasp=hold),
        ag.part([plate, ag.simplified_collider(dome, 0.001)], "lid", filled(look.grip, 620.0, "lid")),
        ag.part(hooks, "lid", look.grip),
        ag.detail(skirt, "lid", look.grip),
        ag.detail(ring, "trim", ag.material("stainless")),
        ag.detail(seal, "gasket", ag.material("silicone")),
        ag.detail(pin, "valve", ag.material("led_red")),
        name,
    )
    at = (0.0, 0.052, top + FIT.running)
    stem = ag.cylinder(0.0130, 0.010, bevel=0.002).at(z=0.005)
    wing = ag.box(0.012, 0.034, 0.016, bevel=0.004).at(z=0.017)
    pinch = ag.grasp_on(wing, approach=-ag.Z, closing=ag.X, depth=0.011)
    valve = ag.part([wing, stem], "valve", _BLACK, name="valve", grasp=pinch)
    swing = ag.Revolute(
        "valve_turn", axis=ag.Z, limits=(0, 0.8), detents=feel.detents((0.0, 0.8), 0.06), friction=0.02,
        damping=0.004, armature=2e-5, effort=0.8,
    )  # fmt: skip
    return lid.attach(valve, swing, at=at)


def _slow(half: ag.Scalar, high: ag.Scalar, look: Look) -> ag.Body:
    """Make an oval slow cooker with a pot of stoneware, a lid of glass and a dial."""
    share, deck = 0.76, high - 0.030
    far = half - 0.020
    deep = share * half
    case = ag.extrude(ag.ellipse(half, deep), deck - FEET, bevel=0.006).at(z=(deck + FEET) / 2)
    hole = ag.extrude(vessels.around(far + 0.003, 16), high).at(z=FLOOR + high / 2).scale(1, share, 1)
    case -= hole.paint(ag.material("aluminium"))
    base = ag.extrude(ag.ellipse(half + 0.0014, deep + 0.0014), 0.018, bevel=0.003).at(z=FEET + 0.009)
    rim = ag.ellipse(half + 0.0012, deep + 0.0012) - ag.ellipse(far + 0.004, share * far + 0.004)
    edge = ag.extrude(rim, 0.006, bevel=0.002).at(z=deck - 0.0018)
    front = ag.Region((-0.040, 0.040), (-deep - 0.009, 0.012 - deep), (0.028, 0.108)).box(bevel=0.006)
    body = ag.weld(
        ag.part(case, "body", look.hollow(480.0), name="body"),
        ag.part(front, "panel", casting(look.grip, 0.6)),
        side_handles(half + 0.007, _level(0.74, deck), (0.042, 0.096, 0.020), look.grip),
        ag.detail([base, edge], "trim", _BLACK),
        _feet(half - 0.03, share),
    )
    body = body.install(_switch(look), at=(0, -deep - 0.009, 0.064))
    body = _backed(body, look, deep, 240)
    lid = glass_lid(far - 0.001, 0.026, look.grip, share=share)
    lift = lid_lift()
    crock = _crock(far, high - FLOOR - 0.001, share, lift > _AWAY).at(z=FLOOR + 0.0006)
    crock = crock.attach(lid, lift, at=(0, 0, high + 0.0002))
    low, strong, warm = (
        signals.pressed("dial_turn", (_DIAL * step / 3, _DIAL * (step + 1) / 3)) for step in range(3)
    )
    heats = (0.5 * low | strong) & ~warm | 0.2 * warm
    return body.attach(crock, lifts_out(high - FLOOR + 0.015)).output("cook", heats, kind="heat")


def _switch(look: Look) -> Fitting:
    """Make the dial of a slow cooker with its words."""
    clicks = [_DIAL * step / 3 for step in range(4)]
    turn = controls.dial_turn("dial_turn", low=0.0, high=_DIAL, friction=0.02, clicks=clicks, torque=0.06)
    words = details.dial_scale(
        0.021,
        4,
        sweep=_DIAL,
        start=0.0,
        numbers=("OFF", "LOW", "HIGH", "WARM"),
        number_height=0.0034,
        width=0.0007,
    )
    scale = details.printed(words, material=controls.ink_on(look.grip))
    return controls.dial(turn, "bar", 0.019, look.grip, depth=0.019, cap=look.trim, scale=scale)


def _crock(far: ag.Scalar, tall: ag.Scalar, share: float, when: ag.Condition) -> ag.Body:
    """Make an oval pot of stoneware with a lug at each side, its floor at z = 0."""
    wall, foot = 0.009, 0.90 * far
    path = ag.polyline([(0.002, 0, 0), (foot, 0, 0), (far, 0, tall)], fillet=0.016)
    skin = ag.revolve(ag.half_section(path, wall=wall)).scale(1, share, 1)
    ring = vessels.ring_wall(foot, far, tall, wall, 16).scale(1, share, 1)
    floor = ag.extrude(ag.regular_polygon(16, foot - 0.012), 0.0092).at(z=0.0050).scale(1, share, 1)
    lug = ag.Region((far - 0.008, far + 0.022), (-0.029, 0.029), (tall - 0.018, tall - 0.002)).box(
        bevel=0.005
    )
    hold = ag.grasp_on(lug, approach=-ag.Z, closing=ag.Y, at=(far + 0.014, 0, tall - 0.010), depth=0.011)
    lugs = ag.part(lug, "pot", _STONE, name="pot", grasp=hold, when=when)
    other = ag.part(lug.mirror(ag.X), "pot", _STONE)
    return ag.weld(lugs, other, ag.part([ring, floor], "pot", _STONE), ag.detail(skin, "pot", _STONE))
