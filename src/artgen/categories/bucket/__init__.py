"""A bucket with a bail: of plastic, zinc or wood, a cooler for bottles, a pail with a lid, or a can of paint.

Links: `bucket`; `bail`, or `handle_right` and `handle_left` of a cooler or a pail, which has a `lid`. Joints:
`bail_swing`, or `handle_swing_right` and `handle_swing_left`; `lid_lift`.

At 0 the bail lies in front, a little below its pivots; it swings over to the back. The handles of a cooler
or a pail hang, and swing up. The lid of a pail lifts off. A can of paint is full and closed.

Sizes are those of shops, by capacity: household buckets of 5-12 l are 22-31 cm wide and 0.25-0.8 kg, those
of builders of 12-20 l 31-36 cm and 0.7-1.4 kg, galvanized ones of 8-15 l 27-33 cm and 1.1-2.2 kg, wooden
pails of 5-10 l 25-31 cm and 1.2-3 kg, coolers for one bottle 18-22 cm and 1-1.6 kg, pails of 3-8 l for ash or
compost 16-22 cm and 1-2.4 kg, cans of 1-10 l of paint 11-26 cm, with 1.35 kg for each liter.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT

Style = Literal["household", "builder", "zinc", "wood", "cooler", "pail", "paint"]
"""A bucket of a household or of builders, of galvanized steel or of staves, a cooler, a pail with a
lid for ash or compost, or a can of paint."""

_WALLS = {
    "household": 0.0026, "builder": 0.0034, "zinc": 0.0014, "wood": 0.015, "cooler": 0.0016,
    "pail": 0.001, "paint": 0.001,
}  # fmt: skip
"""Thickness of the walls [m]."""
_SHARES = {"household": 0.95, "builder": 1.1, "zinc": 0.40, "cooler": 0.42, "pail": 0.3, "paint": 0.20}
"""Share of the core in the mass of a solid wall of that thickness."""
_STAVES = 18  # number of staves of a wooden pail
_SIDES = 24  # facets of the solid inside a wall
_CORE = 0.0036  # thickness of that solid, for the simulator [m]
_SOFT = 0.006  # radius of the lower edge [m]
_DROOP = 0.24  # angle of a lying bail below the level [rad]
_WIRES = {"household": 0.0024, "builder": 0.0030, "zinc": 0.0030, "wood": 0.0034, "paint": 0.002}
"""Radius of the wire of a bail [m]."""
_ZINC = ag.material("zinc").with_(name="galvanized", specular_roughness=0.42)
_TIN = ag.material("chrome").with_(name="tinplate", specular_roughness=0.26, density=7850.0)
_STEEL = ag.material("steel").with_(name="wire_steel", specular_roughness=0.3)
_FINISHES = {
    "household": ag.shades(
        *colors("polypropylene", "red blue sky yellow sage white grey orange"), color=0.05
    ),
    "builder": ag.shades(
        *colors("polypropylene", "black graphite orange yellow"), weights=(3, 2, 1, 1), color=0.03
    ),
    "zinc": ag.shades(_ZINC, *colors("powder_coat", "sage navy cream"), weights=(4, 1, 1, 1), color=0.04),
    "wood": ag.shades("pine", "oak", "ash", color=0.06),
    "cooler": ag.choice("stainless", "chrome", "stainless_blasted", "copper", "satin_brass"),
    "pail": ag.choice("stainless_blasted", "copper", *colors("powder_coat", "white black graphite sage")),
    "paint": ag.choice(_TIN, *colors("powder_coat", "white cream")),
}
_TRIMS = {
    "household": ag.choice(*colors("polypropylene", "black white grey graphite")),
    "builder": ag.choice(*colors("polypropylene", "black red")),
    "zinc": ag.choice("beech", "oak", ag.colored("polypropylene", "black")),
    "wood": ag.choice("zinc", "black_steel", "satin_brass"),
    "cooler": ag.fixed(ag.material("stainless")),
    "pail": ag.choice("beech", "walnut", ag.colored("abs", "black")),
    "paint": ag.choice(*colors("polypropylene", "black white")),
}
_ACCENTS = colors("powder_coat", "red teal navy orange sage yellow")


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a bucket."""

    style: Style
    rim: ag.Scalar  # outer radius at the rim [m]
    foot: ag.Scalar  # outer radius at the floor [m]
    high: ag.Scalar  # [m]
    finish: ag.Material
    trim: ag.Material

    @property
    def wall(self) -> float:
        """Thickness of the wall [m]."""
        return _WALLS[self.style]

    def at(self, level: ag.Scalar) -> ag.Scalar:
        """Return the outer radius at a height [m]."""
        return self.foot + (self.rim - self.foot) * level / self.high

    def band(self, low: ag.Scalar, high: ag.Scalar, proud: float, bevel: float = 0.0) -> ag.Solid:
        """Make a ring around the wall between two heights."""
        wide, deep = self.at((low + high) / 2) + proud, self.at(low) - self.wall
        return ag.tube(wide, deep, high - low, bevel=bevel).at(z=(low + high) / 2)


@ag.category(labels="bucket rim bail grip ear handle hinge stave hoop lid knob print", joints=(1, 3))
def bucket(
    *,
    style: Style = ag.choice(
        {
            "household": 0.26,
            "builder": 0.16,
            "zinc": 0.2,
            "wood": 0.12,
            "cooler": 0.1,
            "pail": 0.1,
            "paint": 0.12,
        }
    ),
    litres: int = ag.by(
        "style",
        household={5: 1, 8: 1, 10: 2, 12: 1},
        builder={12: 2, 20: 1},
        zinc={8: 1, 10: 2, 12: 2, 15: 1},
        wood={5: 1, 8: 1, 10: 1},
        cooler={4: 1, 5: 1},
        pail={3: 1, 5: 2, 8: 1},
        paint={1: 1, 3: 2, 5: 2, 10: 1},
        unit="l",
        doc="capacity to the brim",
    ),
    tall: ag.Float = ag.by(
        "style",
        wood=ag.uniform(0.86, 1.02),
        cooler=ag.uniform(0.96, 1.10),
        pail=ag.uniform(0.95, 1.2),
        paint=ag.uniform(0.88, 1.14),
        otherwise=ag.uniform(0.84, 0.96),
        within=(0.7, 1.3),
        doc="height over the diameter at the rim",
    ),
    taper: ag.Float = ag.by(
        "style",
        household=ag.uniform(0.66, 0.76),
        builder=ag.uniform(0.72, 0.80),
        zinc=ag.uniform(0.62, 0.72),
        wood=ag.uniform(0.84, 0.93),
        cooler=ag.uniform(0.70, 0.82),
        pail=ag.uniform(0.9, 0.97),
        paint=1.0,
        within=(0.6, 1.0),
        doc="diameter at the floor over that at the rim",
    ),
    rings: int = ag.by(
        "style",
        household={0: 2, 1: 2, 2: 1},
        builder={1: 1, 2: 1},
        zinc={1: 1, 2: 2},
        wood={2: 2, 3: 1},
        cooler={0: 2, 1: 1},
        pail={0: 1, 1: 1},
        paint={1: 1, 2: 1},
        doc="rings around the wall; hoops of a pail",
    ),
    bail: Literal["wire", "strap"] = ag.by(
        "style",
        household={"wire": 0.5, "strap": 0.5},
        otherwise="wire",
        doc="wire with a grip, or strap of plastic",
    ),
    arch: ag.Float = ag.uniform(1.06, 1.22, doc="height of the bail over half its width", within=(1.02, 1.3)),
    friction: ag.Float = ag.by(
        "style",
        {each: ag.uniform(0.0005, 0.002) for each in ("cooler", "pail", "paint")},
        otherwise=ag.uniform(0.006, 0.02),
        unit="N m",
        doc="friction of the bail or of a handle",
    ),
    finish: ag.Material = ag.by("style", _FINISHES),
    trim: ag.Material = ag.by("style", _TRIMS, doc="grip of the bail; hoops of a pail"),
    accent: ag.Material = ag.choice(*_ACCENTS, doc="color on the label of a can"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a bucket with its bail down."""
    least = {"wood": 0.8, "paint": 0.96}.get(style, 0.6)
    taper = ag.require(taper, taper >= least, f"taper of a {style} bucket must be >= {least:g}")
    volume = 0.00106 * litres  # with the part above the mark [m3]
    wide = (12 * volume / (math.pi * tall * (1 + taper + taper * taper))) ** (1 / 3)
    extra = 2 * _WALLS[style] if style == "wood" else 0.0
    rim = (wide + extra) / 2
    plan = _Plan(style, rim, taper * rim, tall * wide, finish, trim)
    body = _staved(plan, rings) if style == "wood" else _vessel(plan, rings)
    if style == "paint":
        body = ag.weld(body, _filling(plan), *_label(plan, litres, accent, maker))
    elif style not in ("wood", "pail"):
        mark = details.logo(maker, 0.05 * rim)
        side = ag.line((plan.foot, 0, 0), (rim, 0, plan.high))
        ink = controls.ink_on(finish)
        body = ag.weld(body, details.wrapped(mark, side, 0.62 * plan.high, material=ink))
    if style in ("cooler", "pail"):
        level = (0.84 if style == "cooler" else 0.72) * plan.high
        metal = finish if style == "cooler" else _STEEL
        body = vessels.swinging_handles(
            body, plan.at(level), level, friction, metal, half=0.034, drop=0.036, sunk=0.004
        )
        return _lidded(body, plan) if style == "pail" else body
    return _with_bail(body, plan, bail, arch * (plan.rim + 0.02), friction)


def _vessel(plan: _Plan, rings: int) -> ag.Body:
    """Make the open vessel with its rim, foot and rings."""
    style, high = plan.style, plan.high
    wall = max(plan.wall, _CORE + 0.0003)  # the skin covers the core
    path = ag.polyline([(0.002, 0, 0), (plan.foot, 0, 0), (plan.rim, 0, high)], fillet=_SOFT)
    skin = ag.detail(ag.revolve(ag.half_section(path, wall=wall)), "bucket", plan.finish)
    stuff = casting(plan.finish, _SHARES[style])
    low = _SOFT - 0.0022
    ring = vessels.ring_wall(plan.at(low), plan.rim, high - low, _CORE, _SIDES).at(z=low)
    floor = ag.frustum(plan.foot - 0.0045, plan.foot - 0.0012, 0.0062).at(z=0.0036)
    body = ag.weld(ag.part([ring, floor], "bucket", stuff, name="bucket"), skin)
    levels = [high * (0.30 + 0.36 * (number + 0.5) / rings) for number in range(rings)]
    if style in ("household", "builder"):
        lip = 0.0045 if style == "household" else 0.007
        tall = 0.008 if style == "household" else 0.016
        edge = vessels.hoop(plan.rim + lip - 0.0003, plan.rim - wall, tall, _SIDES).at(z=high - tall / 2)
        seen = ag.tube(plan.rim + lip, plan.rim - wall - 0.0003, tall + 0.001, bevel=0.0022)
        body = ag.weld(
            body, ag.part(edge, "rim", plan.finish), ag.detail(seen.at(z=high - tall / 2), "rim", plan.finish)
        )
        bands = [plan.band(z, z + 0.006, 0.0016, 0.0012) for z in levels]
        foot = plan.band(0.0, 0.007, 0.0012, 0.001)
        if style == "builder":
            fin = ag.box(0.008, 0.0026, 0.030, bevel=0.001).at(plan.rim + 0.0022, 0, high - 0.030)
            turns = [number * math.tau / 24 for number in range(24)]
            bands += [fin.rotate(ag.Z, turn) for turn in turns if abs(math.sin(turn)) > 0.2]
        return ag.weld(body, ag.detail([foot, *bands], "bucket", plan.finish))
    bead = 0.0032 if style == "zinc" else 0.0020
    roll = ag.torus(plan.rim, bead).at(z=high - 0.001)
    body = ag.weld(body, ag.detail(roll, "rim", plan.finish))
    swages = [ag.torus(plan.at(z) - 0.0008, 0.0026).at(z=z) for z in levels]
    if style == "zinc":
        swages.append(plan.band(0.0, 0.014, 0.0014, 0.0005))
        seam = ag.box(0.004, 0.004, 1.0, bevel=0.001).at(z=0.5)  # the lock seam at the back
        lean = ag.atan2(plan.rim - plan.foot, high)
        strip = (
            seam.split(point=(0, 0, 0.92 * high), normal=-ag.Z)
            .rotate(ag.X, -lean)
            .at(0, plan.foot + 0.0006, 0.0005)
        )
        swages.append(strip)
    return ag.weld(body, ag.detail(swages, "bucket", plan.finish)) if swages else body


def _staved(plan: _Plan, hoops: int) -> ag.Body:
    """Make a pail of staves with hoops; two staves are longer and carry the bail."""
    half, high, wall = math.pi / _STAVES - 0.002, plan.high, plan.wall

    def stave(top: ag.Scalar) -> ag.Solid:
        """Make the stave at +x between the floor and a height."""
        ends = []
        for level in (0.0002, top - 0.0002):  # half the height of a plate from the ends
            out, inside = plan.at(level), plan.at(level) - wall
            right = [(r * math.cos(half), r * math.sin(half)) for r in (inside, out)]
            outline = ag.polygon([*((x, -y) for x, y in right), (out, 0), *reversed(right)])
            ends.append(ag.extrude(outline, 0.0004).at(z=level))
        return ag.hull(*ends)

    short, long = stave(high), stave(high + 0.062)
    staves = [
        (long if number % (_STAVES // 2) == 0 else short).rotate(ag.Z, number * math.tau / _STAVES)
        for number in range(_STAVES)
    ]
    inner = ag.cylinder(plan.at(0.02) - wall - 0.0002, 0.012).at(z=0.024)
    body = ag.part([*staves, inner], "stave", plan.finish, name="bucket")
    ag.require(hoops in (2, 3), f"a pail of staves must have 2 or 3 hoops, got rings={hoops}")
    levels = {2: (0.12, 0.74), 3: (0.10, 0.44, 0.80)}[hoops]
    rings = []
    for share in levels:
        low, tall = share * high, 0.022
        ends = [plan.at(low) + 0.0008, plan.at(low + tall) + 0.0008]
        ring = ag.half_section(ag.line((ends[0], 0, low), (ends[1], 0, low + tall)), wall=0.0014)
        rings.append(ag.revolve(ring))
    return ag.weld(body, ag.detail(rings, "hoop", plan.trim))


def _filling(plan: _Plan) -> ag.Body:
    """Make the paint in a can, and the lid pressed into its rim."""
    inner = plan.rim - _CORE
    paint = ag.material("rubber").with_(name="paint", density=1350.0)
    room = ag.cylinder(inner, 0.92 * plan.high).at(z=0.48 * plan.high)
    plate = ag.cylinder(inner + 0.0006, 0.0016, bevel=0.0004).at(z=plan.high - 0.0030)
    ridges = [ag.torus(inner - inset, 0.0013).at(z=plan.high - 0.0022) for inset in (0.002, 0.012)]
    return ag.weld(
        ag.part(room, "bucket", paint), ag.part(plate, "lid", _TIN), ag.detail(ridges, "lid", _TIN)
    )


def _label(plan: _Plan, litres: int, accent: ag.Material, maker: str) -> list[ag.Body]:
    """Print the label of a can: a colored band, the maker and the capacity."""
    radius, high = plan.rim, plan.high
    side = ag.line((radius, 0, 0), (radius, 0, high))
    paper = ag.material("powder_coat_white").with_(name="label_paper", specular_roughness=0.6)
    sheet = ag.tube(radius + 0.00025, radius - 0.0002, 0.62 * high).at(z=0.46 * high)
    stripe = ag.tube(radius + 0.0004, radius - 0.0002, 0.20 * high).at(z=0.30 * high)
    ink = ag.material("powder_coat_black").with_(name="label_ink", specular_roughness=0.6)
    name = details.wrapped(details.logo(maker, 0.125 * radius), side, 0.60 * high, material=ink, proud=0.0006)
    words = details.lettering((f"{litres} L",), 0.12 * radius, fineness="coarse")
    size = details.wrapped(words, side, 0.30 * high, material=paper, proud=0.0006)
    return [ag.detail(sheet, "print", paper), ag.detail(stripe, "print", accent), name, size]


def _with_bail(body: ag.Body, plan: _Plan, kind: str, tall: ag.Scalar, friction: ag.Scalar) -> ag.Body:
    """Add the ears and the bail."""
    style, strap = plan.style, kind == "strap"
    wire = 0.0030 if strap else _WIRES[style]
    level = plan.high + 0.034 if style == "wood" else (0.78 if style == "paint" else 0.955) * plan.high
    beside = plan.at(level)  # where the ears begin
    reach = {"household": 0.0110, "builder": 0.0130, "zinc": 0.0080, "wood": 0.0050}.get(style, 0.0070)
    boss = ag.cylinder(0.0070 if style == "paint" else 0.0090, reach + 0.002, axis=ag.X, bevel=0.001)
    ear = boss.at(beside + reach / 2 - 0.001, 0, level)
    if style == "zinc":
        ear |= ag.box(0.003, 0.034, 0.040, bevel=0.0012).at(beside + 0.0006, 0, level - 0.008)
    stuff = {"wood": _STEEL, "paint": _TIN}.get(style, plan.finish)
    fixed = ag.part([ear, ear.mirror(ag.X)], "ear", stuff)
    x = beside + reach + FIT.running + 1.2 * wire
    ends, bend, top = (x, 0, 0), (x, 0, 0.3 * tall), (0.52 * x, 0, tall)
    right = [ends, bend, top]
    line = [*((-a, b, c) for a, b, c in right), *reversed(right)]
    bow = ag.polyline(line, fillet=0.30 * tall)
    section = ag.rectangle(2 * wire, 0.013, radius=0.002) if strap else ag.regular_polygon(8, wire)
    bar = ag.simplified_collider(ag.sweep(section, bow), 0.0004)
    eye = ag.cylinder(0.0080 if strap else 0.0052, 2.4 * wire, axis=ag.X, bevel=0.0008)
    eyes = [eye.at(side * x) for side in (-1, 1)]
    grip = ag.cylinder(0.0125, 0.098, axis=ag.X, bevel=0.003).at(z=tall)
    if style == "paint":
        grip = ag.cylinder(0.0065, 0.55 * plan.rim, axis=ag.X, bevel=0.002).at(z=tall)
    hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.Y, depth=0.014)
    stuff = ag.material("beech") if style == "wood" else casting(plan.trim, 0.5)
    if strap:
        grip = ag.box(0.070, 0.016, 0.009, bevel=0.003).at(z=tall)
        hold, stuff = ag.grasp_on(grip, approach=-ag.Z, closing=ag.Y, depth=0.008), plan.trim
    bail = ag.weld(
        ag.part(ag.union(bar, *eyes), "bail", plan.trim if strap else _STEEL, name="bail"),
        ag.part(grip, "grip", stuff, grasp=hold),
    )
    bail = bail.rotate(ag.X, math.pi / 2 + _DROOP)
    swing = ag.Revolute(
        "bail_swing",
        axis=-ag.X,
        pivot=(0, 0, level),
        limits=(0, math.pi + 2 * _DROOP),
        feel=feel.Feel(friction=friction, damping=0.002, armature=1e-4, effort=10.0),
    )
    return ag.weld(body, fixed).attach(bail.at(z=level), swing)


def _lidded(body: ag.Body, plan: _Plan) -> ag.Body:
    """Add the lid of a pail with its knob."""
    disc = ag.cylinder(plan.rim + 0.0030, 0.0030, bevel=0.001).at(z=0.0015)
    dome = ag.dome(plan.rim - 0.005, height=0.016).at(z=0.0028)
    plug = ag.cylinder(plan.rim - 0.008, 0.010, bevel=0.001).at(z=-0.0046)
    stem = ag.cylinder(0.007, 0.012).at(z=0.0225)
    cap = ag.frustum(0.011, 0.016, 0.018, bevel=0.004).at(z=0.035)
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.X, depth=0.012)
    lid = ag.weld(
        ag.part([disc, dome, plug], "lid", casting(plan.finish, 0.12), name="lid"),
        ag.part([cap, stem], "knob", casting(plan.trim, 0.6), grasp=hold),
    )
    lift = ag.Prismatic("lid_lift", axis=ag.Z, limits=(0, 0.12), friction=0.4, damping=4.0, effort=80.0)
    return body.attach(lid, lift, at=(0, 0, plan.high + 0.001 + FIT.running))
