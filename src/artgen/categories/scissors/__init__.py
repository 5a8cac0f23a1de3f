"""Scissors on a table: household, tailor's, kitchen or craft scissors, sprung snips, or kitchen tongs.

Links: `body`, the half with the rivet, and `blade`, the other half; tongs have `body`, `arm`, and `ring`, the
loop that locks them. Joints: `blade_hinge` or `arm_hinge`, closed at 0, and `ring_slide`: at 0 the ring is
behind the hinge, at its end it holds the closed arms.

The points are at the back (+y), the handles at the front. In the lap the blades lie on each other. A spring
opens snips and tongs; the others hold any angle by the friction of their joint.

Sizes are those of Fiskars, WMF, Zwilling and OXO catalogs: household 160-215 mm and 50-110 g, tailor's
200-260 mm and 120-380 g, kitchen 200-225 mm and 90-180 g, craft scissors of children 125-140 mm and 20-45 g,
snips 150-185 mm and 60-130 g, tongs 230-310 mm and 90-190 g. Friction of 0.01-0.05 N m is 0.15-0.6 N at the
bows: scissors close under their weight if the joint is looser (setting by the drop test of cutlers). Springs
of snips take 4-8 N at the middle of the handles, those of tongs 3-6 N.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import pivots
from artgen.categories.shared.finish import colors

Style = Literal["household", "tailor", "kitchen", "craft", "snips", "tongs"]
"""Scissors by their use; snips have bars as handles and a spring, tongs have arms hinged at their end."""

# distance from the pivot to the tip and radius of the lap, as shares of the length; thickness of a blade and
# of the handles [m]
_SIZES = {
    "household": (0.57, 0.058, 0.0020, 0.0095),
    "tailor": (0.56, 0.068, 0.0032, 0.0105),
    "kitchen": (0.48, 0.066, 0.0024, 0.0120),
    "craft": (0.53, 0.075, 0.0014, 0.0085),
    "snips": (0.34, 0.062, 0.0024, 0.0130),
}

# half width and half length of the hole of a bow, for the thumb and for fingers [m]
_HOLES = {
    "household": ((0.0125, 0.0170), (0.0135, 0.0270)),
    "tailor": ((0.0135, 0.0185), (0.0155, 0.0370)),
    "kitchen": ((0.0145, 0.0250), (0.0150, 0.0300)),
    "craft": ((0.0110, 0.0135), (0.0115, 0.0190)),
}
_LAP = 0.00015  # half of the gap between the blades [m]
_APART = 0.0009  # distance of a handle from the middle plane [m]
_PROUD = 0.0004  # height of a soft part above the bar around it [m]
_PLASTICS = colors("abs", "red orange teal navy black forest graphite sky")
_BRIGHT = colors("abs", "red sky mint blush mustard orange")
_SOFT = colors("rubber", "light_grey black red mint")
_RING = feel.Feel(friction=1.2, damping=4.0, armature=0.05, effort=8.0)


@ag.category(labels="body blade edge pivot handle grip teeth spring print arm tip ring", joints=(1, 2))
def scissors(
    *,
    style: Style = ag.choice(
        {"household": 0.24, "tailor": 0.16, "kitchen": 0.2, "craft": 0.12, "snips": 0.13, "tongs": 0.15}
    ),
    length: ag.Float = ag.by(
        "style",
        household=ag.uniform(0.160, 0.215),
        tailor=ag.uniform(0.205, 0.260),
        kitchen=ag.uniform(0.200, 0.225),
        craft=ag.uniform(0.125, 0.140),
        snips=ag.uniform(0.150, 0.185),
        tongs=ag.uniform(0.230, 0.310),
        unit="m",
        within=(0.12, 0.33),
    ),
    tip: Literal["pointed", "blunt", "round"] = ag.by(
        "style",
        household={"pointed": 0.6, "blunt": 0.4},
        kitchen={"blunt": 0.6, "pointed": 0.4},
        craft="round",
        tongs="round",
        otherwise="pointed",
    ),
    bows: Literal["equal", "offset"] = ag.by(
        "style",
        tailor="offset",
        kitchen={"equal": 0.4, "offset": 0.6},
        household={"equal": 0.4, "offset": 0.6},
        otherwise="equal",
        doc="bows of one size, or a long one for fingers",
    ),
    bend: ag.Float = ag.by(
        "style",
        tailor=ag.uniform(0.10, 0.24),
        otherwise=0.0,
        unit="rad",
        within=(0.0, 0.26),
        doc="angle between blades and handles, which keeps the lower blade on the table",
    ),
    opening: ag.Float = ag.by(
        "style",
        tongs=ag.uniform(0.26, 0.36),
        snips=ag.uniform(0.45, 0.60),
        otherwise=ag.uniform(0.75, 1.0),
        unit="rad",
        within=(0.2, 1.1),
    ),
    friction: ag.Float = ag.uniform(0.01, 0.05, "N m", doc="friction of the joint"),
    squeeze: ag.Float = ag.by(
        "style",
        tongs=ag.uniform(3.0, 6.0),
        otherwise=ag.uniform(4.0, 8.0),
        unit="N",
        within=(2.0, 12.0),
        doc="force at the middle of the handles that closes sprung ones",
    ),
    forged: bool = ag.by("style", tailor={True: 0.55, False: 0.45}, otherwise=False, doc="handles of steel"),
    soft: bool = ag.by(
        "style", craft=False, otherwise=ag.choice(True, False), doc="soft parts in the handles"
    ),
    handle: ag.Material = ag.by(
        "style", craft=ag.shades(*_BRIGHT, color=0.05), otherwise=ag.shades(*_PLASTICS, color=0.05)
    ),
    accent: ag.Material = ag.choice(*_SOFT),
    steel: ag.Material = ag.shades(
        "stainless", "satin_nickel", "chrome", "black_steel", weights=(4, 1.5, 1, 0.7), color=0.04
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make closed scissors or tongs that lie on a table."""
    if style == "tongs":
        return _tongs(length, opening, squeeze, steel, handle if soft else None, accent)
    least = {"household": 0.14, "tailor": 0.15}.get(style, 0.12)
    length = ag.require(length, length >= least, f"length of {style} scissors must be >= {least:g} m")
    share, wide, plate, tall = _SIZES[style]
    reach, radius = share * length, wide * length
    bars, inlay = style == "snips", accent if soft else None
    coat = ag.material("powder_coat_black").with_(name="forged_handle", density=7850.0) if forged else handle
    rear = length - reach  # distance from the pivot to the end of the handles [m]
    bodies, solids = [], []
    for side, turn in enumerate((bend, -bend)):
        flat, blade_solid = _flat(style, tip, reach, radius, plate, steel, turn, drilled=side == 1)
        up, name = (ag.Z, "upper_handle") if side else (-ag.Z, "lower_handle")
        if bars:
            grip, solid = _bar(radius, rear, tall, coat, inlay, up=up, name=name)
            foot = (-_APART - 0.25 * rear, -radius - 0.50 * rear)
            grip = ag.weld(grip, pivots.leaf_spring(foot, -radius - 0.012))
        else:
            long = bows == "offset" and side == 0
            hole = _HOLES[style][long] if bows == "offset" else _HOLES[style][style == "kitchen"]
            grip, solid = _bow(hole, radius, rear, tall, coat, inlay, up=up, name=name)
            if style == "kitchen":
                grip = ag.weld(grip, _cracker(radius, tall))
        bodies.append(ag.weld(flat, grip))
        solids += [blade_solid, solid]
    body, blade = bodies
    half = plate + _LAP
    body = ag.weld(body, pivots.rivet(0.32 * radius, half, steel))
    blade = blade.rotate(ag.Y, math.pi)
    mark = details.engraved(
        details.logo(maker, 0.16 * radius).rotate(math.pi / 2 + (bend if style == "tailor" else 0.0)),
        (-0.5 * radius - bend * 1.6 * radius, 1.7 * radius, half),
        material=steel,
        facing=ag.Z,
        up=ag.Y,
    )
    blade = ag.weld(blade, mark)
    lever = 0.55 * rear if bars else rear
    hinge = ag.Revolute(
        "blade_hinge", axis=ag.Z, limits=(0, opening),
        spring=pivots.opened_by_spring(squeeze * lever, 0.4 * squeeze * lever, opening) if bars else None,
        friction=0.2 * friction if bars else friction, damping=0.008 if bars else 0.002, armature=0.00002,
        effort=6.0,
    )  # fmt: skip
    # the middle of the lower half
    left, right = solids[1].anchor(x=-1).x, ag.max_(solids[0].anchor(x=1).x, solids[1].anchor(x=1).x)
    left = ag.min_(left, solids[0].anchor(x=-1).x)
    under = _PROUD if bars and soft else 0.0
    return body.attach(blade, hinge).at(-(left + right) / 2, (rear - reach) / 2, tall / 2 + under)


def _flat(
    style: Style,
    tip: str,
    reach: ag.Scalar,
    radius: ag.Scalar,
    plate: float,
    steel: ag.Material,
    bend: ag.Scalar,
    *,
    drilled: bool,
) -> tuple[ag.Body, ag.Solid]:
    """Make the blade with its lap and tang: its edge is at the left, its back at the right."""
    end = {"pointed": 0.0014, "blunt": 0.0042, "round": 0.0060}[tip]
    lap = 0.30 * radius  # of the edges over each other at the root
    low = -plate / 2 - _LAP
    edge = [(-lap, 0.9 * radius), (-0.4 * end, reach - 0.5 * end)]
    point = [(0.25 * end, reach), (0.8 * end, reach - 0.25 * end), (1.1 * end, reach - 1.2 * end)]
    back = [(0.62 * radius, 0.70 * reach) if style != "snips" else (0.5 * radius, 0.6 * reach)]
    back += [(0.93 * radius, 0.30 * reach), (0.95 * radius, 0.25 * radius)]
    root: list[tuple[ag.Scalar, ag.Scalar]] = [(-0.6 * radius, 0.5 * radius), (0.0, -0.3 * radius)]
    lapped = ag.extrude(ag.regular_polygon(20, radius), plate)
    if drilled:
        lapped -= ag.extrude(pivots.rivet_hole(0.32 * radius), 0.02)
        # the blade begins beside the hole
        root = [(-0.6 * radius, 0.55 * radius), (0.6 * radius, 0.5 * radius)]
    outline = ag.polygon([root[0], *edge, *point, *back, root[1]])
    wing = radius + 0.0015
    tang = [(-0.90 * radius, -0.30 * radius), (-_APART - 0.0075, -wing), (-_APART - 0.0065, -wing - 0.014)]
    tang += [(-_APART - 0.0010, -wing - 0.014), (-_APART - 0.0004, -wing), (0.10 * radius, -0.70 * radius)]
    tang.append((-0.2 * radius, -0.5 * radius))
    made = ag.union(
        lapped, ag.extrude(outline, plate).rotate(ag.Z, bend), ag.extrude(ag.polygon(tang), 0.94 * plate)
    )
    # the ground face along the edge, on the outer side
    start, stop = edge
    ground = ag.polygon([start, stop, (stop[0] + 0.9 * end, stop[1] - 2.5 * end), (0.12 * radius, start[1])])
    bright = ag.extrude(ground, 0.0002).at(z=-plate / 2).rotate(ag.Z, bend)
    bodies = [
        ag.part(made.at(z=low), "blade" if drilled else "body", steel),
        ag.detail(
            bright.at(z=low), "edge", ag.material("chrome").with_(name="ground_edge", specular_roughness=0.2)
        ),
    ]
    return ag.weld(*bodies), made


def _bow(
    hole: tuple[float, float],
    radius: ag.Scalar,
    rear: ag.Scalar,
    tall: float,
    finish: ag.Material,
    inlay: ag.Material | None,
    *,
    name: str,
    up: ag.Vector,
) -> tuple[ag.Body, ag.Solid]:
    """Make the left handle: a shank beside the middle plane that ends in a bow around a hole."""
    wall = 0.19 * tall + 0.0034
    long = ag.min_(hole[1], (rear - radius - 0.016) / 2 - wall)  # half of the hole, below a shank [m]
    wide, deep = hole[0] + wall, long + wall
    x, y, top = -_APART - wide, deep - rear, -radius - 0.0015
    shank = ag.polygon(
        [
            (-_APART, top),
            (-_APART - 0.0092, top),
            (-_APART - 0.0100, 0.5 * top + 0.5 * (y + deep)),
            (x - 0.5 * wide, y + deep - 0.3 * wall),
            (x, y + 0.5 * deep),
            (-_APART, y + 0.1 * deep),
        ]
    )
    inside = ag.rectangle(2 * hole[0], 2 * long, radius=0.72 * hole[0]).at(x, y)
    ring = ag.rectangle(2 * wide, 2 * deep, radius=0.72 * hole[0] + wall).at(x, y) - inside
    neck = ag.extrude(shank, tall - 0.0006, bevel=0.0012) - ag.extrude(inside.offset(0.0003), 2 * tall)
    solid = ag.extrude(ring, tall, bevel=0.0014) | neck
    outer = ag.box(wall, 0.020, tall).at(x - hole[0] - wall / 2, y)
    hold = ag.grasp_on(outer, approach=up, closing=ag.X, depth=0.8 * tall)
    body = ag.part(solid, "handle", finish, name=name, grasp=hold, grasp_width=wall + 0.0105)
    if inlay is None:
        return body, solid
    lining = ag.extrude(inside.offset(0.0004) - inside.offset(-0.0007), 0.7 * tall, bevel=0.0003)
    return ag.weld(body, ag.detail(lining, "grip", inlay)), solid


def _cracker(radius: ag.Scalar, tall: float) -> ag.Body:
    """Make the visible teeth for nuts and caps at the inner side of the left shank."""
    steps, start, pitch = 14, -radius - 0.006, 0.0018
    comb = [(-_APART + (0.0005 if at % 2 else -0.0003), start - at * pitch) for at in range(steps + 1)]
    back = -_APART - 0.0020
    strip = ag.polygon([(back, start), *comb, (back, start - steps * pitch)])
    return ag.detail(ag.extrude(strip, 0.7 * tall), "teeth", ag.material("stainless"))


def _bar(
    radius: ag.Scalar,
    rear: ag.Scalar,
    tall: float,
    finish: ag.Material,
    inlay: ag.Material | None,
    *,
    name: str,
    up: ag.Vector,
) -> tuple[ag.Body, ag.Solid]:
    """Make the left handle of snips: a bar that swings out from the lap."""
    top = -radius - 0.0015
    line = [
        (-_APART - 0.0050, top),
        (-_APART - 0.0090, top - 0.10 * rear),
        (-_APART - 0.17 * rear, top - 0.35 * rear),
        (-_APART - 0.235 * rear, -0.72 * rear),
        (-_APART - 0.20 * rear, -rear),
    ]
    widths = (0.0095, 0.0110, 0.0120, 0.0125, 0.0095)
    sections = [
        ag.rectangle(wide, tall, radius=0.0035).at(x)
        for (x, _), wide in zip(reversed(line), reversed(widths), strict=True)
    ]
    solid = ag.loft(sections, [y for _, y in reversed(line)], axis=ag.Y)
    x, y = line[3]
    hold = ag.grasp_on(solid, approach=up, closing=ag.X, at=(x, y, 0.0), depth=0.8 * tall)
    body = ag.part(solid, "handle", finish, name=name, grasp=hold)
    if inlay is None:
        return body, solid
    soft = ag.loft(
        [
            ag.rectangle(0.62 * wide, tall + 2 * _PROUD, radius=0.0024).at(x)
            for (x, _), wide in zip(reversed(line[1:]), reversed(widths[1:]), strict=True)
        ],
        [y + (0.006 if i == 0 else 0.0) for i, (_, y) in enumerate(reversed(line[1:]))],
        axis=ag.Y,
    )
    return ag.weld(body, ag.detail(soft, "grip", inlay)), solid


def _tongs(
    length: ag.Scalar,
    opening: ag.Scalar,
    squeeze: ag.Scalar,
    steel: ag.Material,
    cover: ag.Material | None,
    tips: ag.Material,
) -> ag.Body:
    """Make closed tongs with their ring behind the hinge: the hinge is at the origin, the tips at +y."""
    tall, sheet, flank = 0.017, 0.0028, 0.0075  # height and thickness of an arm, and its outer side [m]
    rear = 0.030  # of the block behind the hinge [m]
    high, straight = tall / 2, 0.066
    free = length - rear - straight
    thin = steel.with_(name=f"{steel.name}_channel", density=3000.0)  # a channel of sheet
    cover = cover or thin
    out, start, stop = flank + 0.040 * length, straight + 0.24 * free, straight + 0.62 * free
    line = [(flank, straight), (out, start), (out, stop), (0.0115, straight + 0.86 * free)]
    middle, deep = (start + stop) / 2, 0.42 * (stop - start)
    end = straight + free

    def arm(label: str, up: ag.Vector) -> ag.Body:
        """Make the right arm before its hinge, with its tip and its cover."""
        course = ag.polyline([(x - sheet / 2, y, 0.0) for x, y in line], fillet=0.018)
        flat = ag.Region((flank - sheet, flank), (0.0098, straight + 0.001), (-high, high)).box()
        pad = ag.Region(
            (out - sheet - 0.0008, out + 0.0045),
            (middle - deep, middle + deep),
            (-high - 0.002, high + 0.002),
        ).box(bevel=0.002)
        hold = ag.grasp_on(pad, approach=up, closing=ag.X, depth=0.8 * tall)
        head = ag.hull(
            ag.box(0.003, 0.010, 0.015, bevel=0.001).at(0.0100, straight + 0.855 * free),
            ag.box(0.004, 0.012, 0.036, bevel=0.0015).at(0.0024, end - 0.022),
            ag.box(0.003, 0.004, 0.022, bevel=0.001).at(0.0019, end - 0.002),
        )
        return ag.weld(
            ag.part(flat | ag.sweep(ag.rectangle(sheet, tall), course), label, thin),
            ag.part(pad, "handle", cover, name=f"{label}_handle", grasp=hold),
            ag.part(head, "tip", tips.with_(name=f"{tips.name}_tip", density=1400.0)),
        )

    eye = ag.cylinder(0.0068, 0.0074) | ag.Region((0.0, flank), (-0.0012, 0.0105), (-0.0037, 0.0037)).box()
    right = ag.weld(arm("arm", ag.Z), ag.part(eye - ag.bore(0.0026, 0.02), "arm", steel))
    plates = [ag.cylinder(0.0068, 0.0044).at(z=z) for z in (-0.0063, 0.0063)]
    cheeks = [
        ag.Region((-flank, end), (-0.010, y), (z - 0.0022, z + 0.0022)).box()
        for z in (-0.0063, 0.0063)
        for end, y in ((-0.0004, 0.0116), (0.0048, 0.0003))
    ]
    block = ag.Region((-flank, flank), (-rear, -0.0078), (-high, high)).box(bevel=0.001)
    stop_plate = ag.Region(
        (-flank - 0.0022, flank + 0.0022), (-rear - 0.004, -rear + 0.001), (-high - 0.003, high + 0.003)
    ).box(bevel=0.0015)
    body = ag.weld(
        arm("body", -ag.Z).rotate(ag.Y, math.pi),
        ag.part(ag.union(*plates, *cheeks, block), "body", thin),
        ag.part(ag.cylinder(0.002, tall - 0.0002), "pivot", steel),
        ag.part(stop_plate, "body", cover),
    )
    inner = ag.rectangle(2 * flank + 0.0020, tall + 0.0020)
    band = ag.rectangle(2 * flank + 0.0090, tall + 0.0060) - inner
    broad, front = 0.010, 0.051  # of the ring, and its front edge where it locks
    travel = front - broad + rear - 0.0016
    loop = ag.extrude(band, broad, axis=ag.Y, bevel=0.0008).at(y=front - broad / 2 - travel)
    hold = ag.grasp_on(loop, approach=-ag.Z, closing=ag.X, depth=0.018)
    cosine, sine = ag.cos(opening), ag.sin(opening)
    # position of the ring where it meets the open arm [m]
    met = (flank + 0.0010 - flank * cosine) / sine * cosine - flank * sine - (front - travel)
    hinge = ag.Revolute(
        "arm_hinge", axis=-ag.Z, limits=(0, opening),
        spring=pivots.opened_by_spring(squeeze * middle, 0.4 * squeeze * middle, opening), friction=0.01,
        damping=0.01, armature=0.00005, effort=6.0,
    )  # fmt: skip
    # 0.4 mm is the play of the arm in the ring
    slide = ag.Prismatic(
        "ring_slide", axis=ag.Y, limits=(0, travel), feel=_RING, needs=(hinge < 0.0150).beyond(met - 0.0004)
    )
    body = body.attach(right, hinge).attach(ag.part(loop, "ring", cover, grasp=hold), slide)
    before, behind = out + 0.0045, flank + 0.0022
    return body.at((before - behind) / 2, rear - length / 2, 0.018)  # on the edges of its tips
