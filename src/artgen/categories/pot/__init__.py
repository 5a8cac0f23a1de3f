"""A pot with its lid: saucepan, stockpot, casserole, frying pan, pressure cooker or chafing dish.

Links: `pot`, `lid`; `handle_right` and `handle_left`, the side handles of a stockpot that swing; `lock` and
`valve` of a pressure cooker. Joints: `lid_lift` and `lid_turn`, or `lid_hinge` of a chafing dish;
`handle_swing_right` and `handle_swing_left`; `lock_slide`; `valve_lift`.

A lid turns and lifts off. That of a pressure cooker has a bayonet: the tongue of its lock slides out from
between two cheeks, the lid turns by half a radian, and only then it lifts. Friction holds an open chafing
dish.

Sizes are those of shops and catalogs: saucepans of 14-20 cm and 1-3 l weigh 0.8-1.8 kg with lid (Fissler,
WMF), stockpots of 22-28 cm and 5-14 l 2-5 kg, enameled casseroles of 22-28 cm and 3.3-6.7 l 4-7 kg (Le
Creuset 26 cm: 5.2 kg), frying pans of 24-30 cm 1.2-2.4 kg, pressure cookers of 22 cm and 4.5-6.5 l 2.4-3.8 kg
(WMF Perfect), round chafing dishes of 34-39 cm 4-7 kg. They are empty.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT

Style = Literal["saucepan", "stockpot", "casserole", "pan", "pressure", "chafer"]
"""A saucepan, a tall pot, an enameled casserole of cast iron, a frying pan, a pressure cooker, or a chafing
dish with a hinged lid."""

Cover = Literal["metal", "glass"]
"""Material of a lid."""

Knob = Literal["mushroom", "disc", "arch", "front"]
"""Grip of a lid: a knob or a bow in the middle, or a bar at the front of a lid with a hinge."""

_WALLS = {"casserole": 0.0036, "pan": 0.0030}  # thickness of walls, otherwise 2 mm [m]
_STEELS = ag.shades(
    ag.material("stainless").with_(name="stainless_round", turned=True),
    "stainless_blasted",
    "chrome",
    weights=(3, 2, 1),
)
_ENAMELS = ag.choice(*colors("enamel", "red orange sage teal navy cream burgundy black"))
_COATS = ag.choice(
    *(
        ag.colored("powder_coat", name).with_(name=f"coat_{name}", density=2700.0)
        for name in ("black", "graphite", "red", "sand", "forest")
    )
)
_GRIPS = ag.choice("black_abs", "stainless_blasted", "walnut", "beech", ag.colored("abs", "graphite"))
_LIDS = {"casserole": 1800.0, "pan": 700.0}  # density of the solid dome of a lid, otherwise 700 [kg/m3]
_GLASS = ag.material("glass").with_(name="lid_glass", opacity=0.16, density=900.0)
_SIDES = 32  # facets of the solid inside a wall
_SLOPES = 22  # the same of a sloping wall, which is thicker and takes longer to simulate
_EDGE = 0.004  # radius of the lower edge of a pot [m]
_LOCK = 0.010  # travel of the lock of a pressure cooker [m]
_TWIST = 0.52  # turn of its bayonet [rad]
_AHEAD = -math.pi / 2  # turn of a long handle from the right to the front [rad]


@ag.category(labels="pot rim base rivet lid knob handle lock valve hinge print", joints=(1, 4))
def pot(
    *,
    style: Style = ag.choice(
        {"saucepan": 0.22, "stockpot": 0.18, "casserole": 0.16, "pan": 0.15, "pressure": 0.16, "chafer": 0.10}
    ),
    width: ag.Float = ag.by(
        "style",
        saucepan=ag.uniform(0.147, 0.205),
        stockpot=ag.uniform(0.242, 0.285),
        casserole=ag.uniform(0.22, 0.28),
        pan=ag.uniform(0.24, 0.30),
        pressure=ag.uniform(0.217, 0.235),
        chafer=ag.uniform(0.34, 0.39),
        unit="m",
        within=(0.14, 0.40),
        doc="outer diameter at the rim",
    ),
    tall: ag.Float = ag.by(
        "style",
        saucepan=ag.uniform(0.46, 0.62),
        stockpot=ag.uniform(0.62, 0.92),
        casserole=ag.uniform(0.38, 0.48),
        pan=ag.uniform(0.19, 0.25),
        pressure=ag.uniform(0.56, 0.78),
        chafer=ag.uniform(0.20, 0.26),
        within=(0.15, 1.0),
        doc="height of the wall over the diameter",
    ),
    swings: bool = ag.by(
        "style",
        stockpot={True: 0.4, False: 0.6},
        otherwise=False,
        doc="side handles of a stockpot that swing",
    ),
    cover: Cover = ag.by(
        "style",
        saucepan={"metal": 0.5, "glass": 0.5},
        stockpot={"metal": 0.65, "glass": 0.35},
        pan={"metal": 0.15, "glass": 0.85},
        chafer={"metal": 0.6, "glass": 0.4},
        otherwise="metal",
        doc="lid",
    ),
    arch: ag.Float = ag.uniform(
        0.10, 0.17, doc="height of the dome of a lid over its diameter", within=(0.06, 0.2)
    ),
    knob: Knob = ag.by(
        "style",
        chafer="front",
        casserole={"mushroom": 0.5, "disc": 0.5},
        otherwise={"mushroom": 0.4, "disc": 0.25, "arch": 0.35},
        doc="grip of a lid",
    ),
    friction: ag.Float = ag.uniform(0.03, 0.08, "N m", doc="friction of handles that swing"),
    finish: ag.Material = ag.by("style", casserole=_ENAMELS, pan=_COATS, otherwise=_STEELS, doc="outside"),
    grip: ag.Material = ag.by(
        "style",
        casserole=ag.choice("stainless", "satin_brass", "black_abs"),
        stockpot=ag.choice("stainless", "chrome"),
        chafer=ag.choice("stainless", "chrome"),
        otherwise=_GRIPS,
        doc="handles and knob",
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a pot that stands closed."""
    if style == "pressure":
        width = ag.require(width, width >= 0.195, "width of a pressure cooker must be >= 0.195 m")
    radius, high = width / 2, tall * width
    wall = _WALLS.get(style, 0.002)
    body = _vessel(style, radius, high, wall, finish, maker)
    match style:
        case "saucepan" | "pan":
            low = "the lid meets the handle of a low pot: raise tall or width"
            high = ag.require(high, high >= 0.0455, low)
            side = (0.94 if style == "pan" else 1.0) * radius
            body = ag.weld(body, _long_handle(side, 0.72 * high, 0.165, 0.030, grip))
        case "stockpot" if swings:
            body = vessels.swinging_handles(body, radius, 0.80 * high, friction, grip)
        case "stockpot":
            body = ag.weld(body, *_loops(radius, 0.80 * high, 0.036, ag.regular_polygon(8, 0.0046), grip))
        case "casserole":
            section = ag.rectangle(0.016, 0.010, radius=0.004)
            body = ag.weld(body, *_loops(radius, 0.86 * high, 0.030, section, finish))
        case "pressure":
            return _pressure(body, radius, high, finish, grip).rotate(ag.Z, _AHEAD)
        case "chafer":
            body = ag.weld(body, *_loops(radius, 0.72 * high, 0.040, ag.regular_polygon(8, 0.0050), grip))
    lid = _lid(style, radius, 0.55 * arch * width, cover, knob, finish, grip)
    if style == "chafer":
        return _hinged(body, lid, radius, high, finish)
    lift = ag.Prismatic("lid_lift", axis=ag.Z, limits=(0, 0.15), effort=80.0, friction=0.1, damping=2.0)
    turn = ag.Revolute("lid_turn", axis=ag.Z, friction=0.02, damping=0.01, effort=5.0)
    body = body.attach(lid, lift, turn, at=(0, 0, high + FIT.running))
    return body.rotate(ag.Z, _AHEAD) if style in ("saucepan", "pan") else body


def _vessel(
    style: Style, radius: ag.Scalar, high: ag.Scalar, wall: float, finish: ag.Material, maker: str
) -> ag.Body:
    """Make the open pot on its base, with its rim and the name of its maker."""
    low = 0.022 if style == "chafer" else 0.003
    foot = 0.78 * radius if style == "pan" else radius
    stuff = finish if style in ("casserole", "pan") else casting(finish, 0.5)
    lean = 0.0017 if style == "pan" else 0.0  # the inner edge of a sloping wall is higher
    path = ag.polyline([(0.002, 0, 0), (foot, 0, 0), (radius, 0, high - low - lean)], fillet=_EDGE)
    skin = ag.detail(ag.revolve(ag.half_section(path, wall=wall)), "pot", finish).at(z=low)
    floor = ag.cylinder(foot - 0.0014, 0.0034).at(z=0.0019)
    ring = vessels.ring_wall(foot, radius, high - low, wall, _SLOPES if style == "pan" else _SIDES)
    body = ag.weld(ag.part([ring, floor], "pot", stuff).at(z=low), skin)
    brim = ag.tube(radius + 0.0012, radius - wall - 0.0004, 0.003, bevel=0.001).at(z=high - 0.0015)
    edge = ag.material("stainless") if style == "pan" else finish
    body = ag.weld(body, ag.detail(brim, "rim", edge))
    if style == "chafer":
        stand = ag.cylinder(0.86 * radius, low + 0.001, bevel=0.003).at(z=(low + 0.001) / 2)
        return ag.weld(
            body, ag.part(stand, "base", ag.material("black_abs").with_(name="stand", density=700.0))
        )
    plate = ag.cylinder(foot - _EDGE, low + 0.001, bevel=0.0012).at(z=(low + 0.001) / 2)
    under = ag.material("stainless").with_(name="sandwich_base", density=4200.0)
    side = ag.line((foot + 0.0002, 0, low), (radius + 0.0002, 0, high))
    size = 0.0075 if style == "stockpot" else 0.0055
    level = ag.max_(0.30 * high, low + size)
    mark = details.wrapped(details.logo(maker, size), side, level, material=controls.ink_on(finish))
    body = ag.weld(body, ag.part(plate, "base", finish if style == "casserole" else under))
    return body if style == "pan" else ag.weld(body, mark)


def _long_handle(
    radius: ag.Scalar, z: ag.Scalar, length: float, rise: float, grip: ag.Material, *, held: bool = True
) -> ag.Body:
    """Make a handle to the right, riveted to a wall at a height, with a loop at its end."""
    steel = ag.material("stainless")
    start, end = radius + 0.034, radius + length
    root = ag.box(0.0030, 0.024, 0.026, bevel=0.001).at(radius + 0.0002, 0, z)
    joint = ag.box(0.008, 0.018, 0.013, bevel=0.001).at(start, 0, z + 0.004)
    near = ag.box(0.014, 0.019, 0.015, bevel=0.005).at(start + 0.004, 0, z + 0.004)
    middle = ag.box(0.05, 0.026, 0.018, bevel=0.006).at((start + end) / 2, 0, z + 0.004 + 0.55 * rise)
    far = ag.box(0.014, 0.022, 0.015, bevel=0.006).at(end, 0, z + 0.004 + rise)
    bar = ag.hull(near, middle, far)
    loop = ag.tube(0.011, 0.0075, 0.004, bevel=0.0015).at(end + 0.013, 0, z + 0.004 + rise)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y)
    light = casting(grip, 0.3) if grip.base_metalness > 0.5 else grip
    rivets = [details.rivet(0.0028, (radius + 0.0017, y, z), facing=ag.X) for y in (-0.007, 0.007)]
    return ag.weld(
        ag.part(bar, "handle", light, grasp=[hold] if held else ()),
        ag.part(ag.hull(root, joint), "handle", steel),
        ag.detail(loop, "handle", steel),
        ag.detail(rivets, "rivet", steel),
    )


def _loops(
    radius: ag.Scalar, z: ag.Scalar, reach: float, section: ag.Profile, finish: ag.Material
) -> list[ag.Body]:
    """Make a handle at each side, bent of a bar."""
    out, half = radius + reach, 0.048
    root = ag.sqrt(radius * radius - half * half) - 0.0010
    line = [(root, -half, z), (out, -half, z + 0.004), (out, half, z + 0.004), (root, half, z)]
    bar = ag.sweep(section, ag.polyline(line, fillet=0.020))
    hold = ag.grasp_on(bar, approach=-ag.X, closing=ag.Z, at=(out, 0, z + 0.004), depth=0.008)
    right, left = (
        ag.part(bar, "handle", finish, name=f"handle_{side}", grasp=hold) for side in ("right", "left")
    )
    return [right, left.mirror(ag.X)]


def _lid(
    style: Style,
    radius: ag.Scalar,
    rise: ag.Scalar,
    cover: Cover,
    knob: Knob,
    finish: ag.Material,
    grip: ag.Material,
) -> ag.Body:
    """Make a domed lid over a rim at z = 0, with a skirt inside the rim, and a knob."""
    edge = radius + 0.0015
    glass = cover == "glass"
    shell = _GLASS if glass else finish.with_(name=f"{finish.name}_lid", density=_LIDS.get(style, 700.0))
    disc = ag.cylinder(edge, 0.0034, bevel=0.0012).at(z=0.0017)
    # the dome stays inside the wall and above the disc: sides of its pieces would turn a lid that falls
    dome = ag.dome(radius - _WALLS.get(style, 0.002) - 0.0012, height=rise - 0.0012).at(z=0.0034)
    lid = ag.weld(_knob(knob, radius, rise + 0.0022, grip), ag.part(disc | dome, "lid", shell))
    if glass:
        ring = ag.tube(edge + 0.0004, edge - 0.007, 0.0040, bevel=0.0014).at(z=0.0020)
        return ag.weld(lid, ag.detail(ring, "rim", ag.material("stainless")))
    inner = radius - 0.012 if style == "pan" else radius - 0.006
    skirt = ag.tube(inner, inner - 0.0016, 0.010).at(z=-0.004)
    return ag.weld(lid, ag.detail(skirt, "lid", finish)) if style != "chafer" else lid


def _knob(knob: Knob, out: ag.Scalar, top: ag.Scalar, grip: ag.Material) -> ag.Body:
    """Make the grip of a lid on its top: the link `lid`."""
    light = casting(grip, 0.4) if grip.base_metalness > 0.5 else grip
    if knob == "front":
        y, z = -out - 0.034, 0.006
        line = [
            (-0.050, -out + 0.010, z),
            (-0.050, y, z + 0.010),
            (0.050, y, z + 0.010),
            (0.050, -out + 0.010, z),
        ]
        bar = ag.sweep(ag.regular_polygon(8, 0.0050), ag.polyline(line, fillet=0.018))
        hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.Z, at=(0, y, z + 0.010), depth=0.008)
        return ag.part(bar, "handle", light, name="lid", grasp=hold)
    if knob == "arch":
        bow = [
            (-0.036, 0, top - 0.006),
            (-0.030, 0, top + 0.030),
            (0.030, 0, top + 0.030),
            (0.036, 0, top - 0.006),
        ]
        bar = ag.sweep(ag.rectangle(0.014, 0.007, radius=0.003), ag.polyline(bow, fillet=0.014))
        hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, at=(0, 0, top + 0.030), depth=0.012)
        return ag.part(bar, "knob", light, name="lid", grasp=hold)
    stem = ag.cylinder(0.0075, 0.016).at(z=top + 0.004)
    if knob == "disc":
        cap = ag.cylinder(0.0205, 0.014, bevel=0.004).at(z=top + 0.019)
    else:
        cap = ag.frustum(0.013, 0.018, 0.018, bevel=0.004).at(z=top + 0.020)
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.X, depth=0.012)
    return ag.part([cap, stem], "knob", light, name="lid", grasp=hold)


def _pressure(
    body: ag.Body, radius: ag.Scalar, high: ag.Scalar, finish: ag.Material, grip: ag.Material
) -> ag.Body:
    """Add the handles, and the lid on its bayonet with its lock and its valve."""
    edge = radius + 0.0125
    lugs, hooks = (each.mirror(ag.Z).at(z=high) for each in vessels.bayonet(radius))
    short = ag.box(0.050, 0.034, 0.018, bevel=0.006).at(-radius - 0.022, 0, high - 0.026)
    held = ag.grasp_on(short, approach=ag.X, closing=ag.Z, depth=0.02)
    body = ag.weld(
        body,
        ag.part(lugs, "rim", finish),
        _long_handle(radius, high - 0.030, 0.190, 0.0, grip, held=False),
        ag.part(short, "handle", grip, name="handle_left", grasp=held),
    )
    low, rise = high + FIT.running, 0.030
    cheek = ag.Region((radius + 0.036, radius + 0.044), (0.0045, 0.0095), (high - 0.023, high + 0.0050)).box()
    body = ag.weld(body, ag.part([cheek, cheek.mirror(ag.Y)], "lock", grip))
    plate = ag.cylinder(edge, 0.0034, bevel=0.0012).at(z=low + 0.0017)
    skirt = ag.tube(edge, edge - 0.0012, 0.0150).at(z=low - 0.0060)
    dome = ag.dome(radius - 0.006, height=rise).at(z=low + 0.0020)
    top = low + rise + 0.002
    z, start, end = low + 0.0160, radius - 0.020, radius + 0.190
    bar = ag.Region((start, end), (-0.013, 0.013), (z - 0.010, z + 0.010)).box(bevel=0.005)
    bar -= ag.Region((radius + 0.0358, radius + 0.0545), (-0.0038, 0.0038), (z - 0.03, z + 0.03)).box()
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, at=(radius + 0.120, 0, z), depth=0.018)
    pipe = ag.cylinder(0.0040, 0.020).at(z=top + 0.006)
    lid = ag.weld(
        ag.part(bar, "handle", grip, name="lid", grasp=hold),
        ag.part(plate | dome, "lid", finish.with_(name=f"{finish.name}_lid", density=1000.0)),
        ag.part(hooks, "lid", finish),
        ag.detail(skirt, "lid", finish),
        ag.part(pipe, "valve", ag.material("chrome")),
    )
    outline = ag.regular_polygon(12, 0.0115)
    weight = ag.extrude(outline - ag.rectangle(0.0092, 0.0092), 0.0180).at(z=top + 0.0105)
    weight |= ag.extrude(outline, 0.006, bevel=0.0015).at(z=top + 0.0220)
    pick = ag.grasp_on(weight, approach=-ag.Z, closing=ag.X, depth=0.015)
    valve = ag.part(
        weight, "valve", ag.material("black_abs").with_(name="valve_weight", density=6000.0), grasp=pick
    )
    blow = ag.Prismatic("valve_lift", axis=ag.Z, limits=(0, 0.04), friction=0.05, damping=0.5, effort=10.0)
    slider = ag.box(0.030, 0.016, 0.010, bevel=0.002).at(radius + 0.040, 0, z + 0.0156)
    tongue = ag.Region((radius + 0.037, radius + 0.043), (-0.003, 0.003), (z - 0.0170, z + 0.0120)).box()
    pinch = ag.grasp_on(slider, approach=-ag.Z, closing=ag.Y, depth=0.008)
    lock = ag.part([slider, tongue], "lock", ag.colored("abs", "red"), grasp=pinch)
    free = ag.Prismatic(
        "lock_slide", axis=ag.X, limits=(0, _LOCK), detents=feel.detents((0.0, _LOCK), 6.0),
        friction=1.0, damping=4.0, armature=0.03, effort=30.0,
    )  # fmt: skip
    turn = ag.Revolute(
        "lid_turn", axis=ag.Z, limits=(0, _TWIST), friction=0.4, damping=0.1, effort=20.0,
        needs=(free > 0.85 * _LOCK).beyond(0.006),
    )  # fmt: skip
    lift = ag.Prismatic(
        "lid_lift", axis=ag.Z, limits=(0, 0.15), friction=0.1, damping=2.0, effort=80.0,
        needs=(turn > _TWIST - 0.04).beyond(0.0008),
    )  # fmt: skip
    return body.attach(lid.attach(lock, free).attach(valve, blow), lift, turn)


def _hinged(body: ag.Body, lid: ag.Body, radius: ag.Scalar, high: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Add a lid on a hinge at the back that holds it open."""
    edge = radius + 0.0015
    axle, up, low = edge + 0.010, 0.0062, high + FIT.running
    barrel = ag.cylinder(0.0055, 0.034, axis=ag.X, bevel=0.0005).at(0, axle, up)
    tongue = ag.Region((-0.017, 0.017), (edge - 0.014, axle), (0.0022, 0.0085)).box()
    lid = ag.weld(lid, ag.part([barrel, tongue], "hinge", finish))
    block = ag.Region((-0.030, 0.030), (radius - 0.0030, axle + 0.006), (high - 0.034, high - 0.002)).box(
        bevel=0.002
    )
    ears = [
        ag.cylinder(0.0055, 0.010, axis=ag.X, bevel=0.0005).at(x, axle, low + up)
        | ag.box(0.010, 0.010, 0.012).align((x, axle, low + up), z=1)
        for x in (-0.0228, 0.0228)
    ]
    hold = 1.3 * lid.weight() * radius
    drag = feel.Feel(friction=hold, damping=0.3, effort=80.0)
    hinge = ag.Revolute("lid_hinge", axis=-ag.X, pivot=(0, axle, up), limits=(0, 1.45), feel=drag)
    return ag.weld(body, ag.part([block, *ears], "hinge", finish)).attach(lid, hinge, at=(0, 0, low))
