"""A toilet: close-coupled, in one piece, or hung on a wall, with a seat and a lid that close slowly.

Links: `bowl`, with its cistern or the wall that carries it; `seat`; `lid`; `flush`, a lever or a button, or
`flush_half` and `flush_full`, the two keys of a water-saving cistern. Joints: `seat_hinge`, `lid_hinge` and
the slides or the turn of the flush. The seat rises only under an open lid, which stands in its way else.

Sizes are those of EN 997 and of shops: bowls 350-380 mm wide, rims 390-430 mm high, 650-720 mm from the wall
to the front with a cistern and 480-560 mm on a wall, seats 360-380 mm wide and 430-470 mm long with hinges
155 mm apart. A bowl of vitreous china weighs 14-20 kg, a cistern 9-13 kg, with 4.5-6 l of water. A lid and a
seat of urea weigh 1-2 kg each; dampers let them fall in 3-8 s, and brake most below 70 degrees, from which
they are tested (TOK TD129: 3-4 N m). Keys of a cistern go 6-12 mm at 8-20 N, and plates on a wall are 246 by
164 mm (catalogs of concealed cisterns).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, sanitary
from artgen.categories.shared.finish import casting
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["coupled", "one_piece", "hung"]
"""A cistern on the bowl, a bowl with its cistern and closed sides in one piece, or a bowl on a wall."""

Shape = Literal["oval", "square"]
"""Outline of bowl, seat and lid from above; a square one has a cistern with sharper edges."""

Flush = Literal["lever", "button", "keys"]
"""A lever at the front of the cistern, one button on its lid, or two keys."""

_HINGE_Z = 0.019  # height of the hinges above the rim [m]
_OVERHANG = 0.024  # reach of the lid before the bowl, so that fingers come below it [m]
_HOLE = 0.06  # distance of the openings of bowl and seat from the hinges [m]
_BRIM = 0.055  # height of the upright part of the bowl below its rim [m]
_EDGE = ((0.98, 1.0), (0.98, 1.0), (0.95, 0.975))  # shares of width and length of the rounded rim
_DAMPED = 1.22  # angle below which dampers brake fully [rad]
_TRAVEL = 0.006  # travel of a key [m]
_DENSITY = {"coupled": 480.0, "one_piece": 330.0, "hung": 480.0}
"""Density of a hollow bowl, by style [kg/m3]."""
_UREA = ag.material("glossy_plastic_white").with_(name="seat_plastic", density=1500.0)
_WATER = ag.material("glass").with_(name="bowl_water", base_color=(0.72, 0.80, 0.82), opacity=0.45)
_METALS = ag.shades("chrome", "satin_nickel", "satin_brass", "powder_coat_black", weights=(5, 2, 1, 1))
_FLUSH = feel.Feel(damping=0.01, friction=0.03, armature=2e-4, effort=4.0)


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of one toilet, with the hinges at the origin of x and y."""

    style: Style
    power: float  # of sine and cosine in a round outline: 1 makes an ellipse, less a squarer outline
    half: ag.Scalar  # half of the width [m]
    tip: ag.Scalar  # length of the round front [m]
    length: ag.Scalar  # from the hinges to the front of the lid [m]
    rim: ag.Scalar  # height of the rim [m]
    wall: ag.Scalar  # from the hinges to the front of the cistern or of the wall [m]
    deep: ag.Scalar  # depth of the cistern [m]
    glaze: ag.Material
    metal: ag.Material

    def outline(
        self, wide: ag.Scalar, tip: ag.Scalar, length: ag.Scalar, back: ag.Scalar, rear: float = 0.86
    ) -> ag.Profile:
        """Make an outline from above: a round front, and sides that narrow to the back."""
        front = sanitary.rounded(wide, tip, self.power, (math.pi * step / 18 for step in range(19)))
        ends = [(0.03, 0.0), (0.009, 0.009), (0.0, 0.03)]
        right = [(rear * wide - x, back - y) for x, y in ends]
        sides = [(x, tip - length + y) for x, y in front]
        return ag.polygon([*right, *sides, *((-x, y) for x, y in reversed(right))])

    def ring(self, wide: float, long: float, back: ag.Scalar, rear: float) -> ag.Profile:
        """Make an outline of the bowl by its shares of the width and of the length."""
        tip, front = self.tip - _OVERHANG, self.length - _OVERHANG
        return self.outline(wide * self.half, wide * tip, long * front, back, rear)

    def pan(
        self,
        shares: Sequence[tuple[float, float]],
        heights: Sequence[ag.Scalar],
        back: ag.Scalar,
        rear: float,
    ) -> ag.Solid:
        """Make the outside of the bowl from its sections below the rounded rim, which is one convex piece."""
        edge = [self.ring(*share, back, rear) for share in _EDGE]
        brim = ag.hull(ag.loft(edge, [self.rim - _BRIM, self.rim - 0.011, self.rim]))
        below = [*(self.ring(*share, back, rear) for share in shares), edge[0]]
        return ag.loft(below, [*heights, self.rim - _BRIM]) | brim

    def hole(self, share: float, length: ag.Scalar, brim: float, steps: int) -> ag.Profile:
        """Make the outline of an opening that leaves a brim at the sides and at the front."""
        long = (length - _HOLE - brim) / 2
        angles = (math.tau * (step + 0.5) / steps for step in range(steps))
        points = sanitary.rounded(share * (self.half - brim), share * long, self.power, angles)
        return ag.polygon([(x, y - _HOLE - long) for x, y in points])


@ag.category(labels="bowl cistern hinge water seat lid button lever plate wall tile print", joints=(3, 4))
def toilet(
    *,
    style: Style = ag.choice({"coupled": 0.42, "one_piece": 0.26, "hung": 0.32}),
    shape: Shape = ag.choice({"oval": 0.65, "square": 0.35}),
    flush: Flush = ag.by(
        "style",
        coupled={"lever": 0.4, "button": 0.2, "keys": 0.4},
        one_piece={"button": 0.4, "keys": 0.6},
        hung="keys",
    ),
    width: ag.Float = ag.uniform(0.350, 0.380, "m", within=(0.34, 0.40), doc="width of the bowl"),
    length: ag.Float = ag.uniform(0.405, 0.450, "m", within=(0.39, 0.48), doc="from the hinges to the front"),
    rim: ag.Float = ag.uniform(0.390, 0.430, "m", within=(0.36, 0.47), doc="height of the rim"),
    blunt: ag.Float = ag.by(
        "shape",
        oval=ag.uniform(0.52, 0.64),
        square=ag.uniform(0.34, 0.44),
        within=(0.3, 0.7),
        doc="length of the round front over the length",
    ),
    cistern: ag.Float = ag.uniform(0.330, 0.390, "m", within=(0.30, 0.42), doc="height of the cistern"),
    deep: ag.Float = ag.uniform(0.160, 0.190, "m", within=(0.15, 0.22), doc="depth of the cistern"),
    broad: ag.Float = ag.uniform(0.90, 1.08, within=(0.88, 1.15), doc="width of the cistern over the bowl"),
    lean: ag.Float = ag.uniform(
        0.07, 0.13, "rad", within=(0.04, 0.16), doc="angle of an open lid past upright"
    ),
    slow: bool = ag.choice({True: 0.65, False: 0.35}, doc="dampers let lid and seat close slowly"),
    glaze: ag.Material = sanitary.GLAZES,
    seat: ag.Material = ag.choice({_UREA: 0.72, "oak": 0.12, "walnut": 0.08, "glossy_plastic_black": 0.08}),
    metal: ag.Material = _METALS,
    tiles: ag.Material = ag.by("style", hung=sanitary.TILES, otherwise=sanitary.TILE),
    tile: ag.Float = ag.uniform(0.14, 0.32, "m", within=(0.1, 0.4), doc="height of the tiles of a wall"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed toilet; it stands against a wall behind it."""
    wall = (length + 0.03) * ag.sin(lean) + 0.045  # it clears the open lid
    power = 1.0 if shape == "oval" else 0.62
    plan = _Plan(style, power, width / 2, blunt * length, length, rim, wall, deep, glaze, metal)
    body = ag.weld(_bowl(plan), _posts(plan))
    if style == "hung":
        keys = ag.rectangle(0.24, 0.16).at(0, 1.0)
        body = ag.weld(body, sanitary.tiled(wall, tile, tiles, hole=keys)).install(
            _plate(metal), at=(0, wall, 1.0)
        )
    else:
        body = _cistern(body, plan, flush, broad * width / 2, cistern, maker)
    opened, place = math.pi / 2 + lean, (0, 0, rim + _HINGE_Z)
    leaf = glaze.with_(name="seat_plastic", density=1500.0) if seat.name == _UREA.name else seat
    hinge = feel.Feel(damping=2.0 if slow else 0.15, friction=0.05, effort=15.0)
    lid, ring = _lid(plan, leaf), _seat(plan, leaf)
    # a damper for the weight: both close in four to seven seconds, of wood as of heavier resin
    brakes = [
        feel.soft_closing(_DAMPED, damping=1.3 * each.weight() * length) if slow else None
        for each in (lid, ring)
    ]
    lift = ag.Revolute("lid_hinge", axis=-ag.X, limits=(0, opened), feel=hinge, closing=brakes[0])
    top = opened - 0.03
    rise = ag.Revolute(
        "seat_hinge", axis=-ag.X, limits=(0, top), feel=hinge, needs=lift > top, closing=brakes[1]
    )
    return (
        _flushed(body, "keys" if style == "hung" else flush)
        .attach(lid, lift, at=place)
        .attach(ring, rise, at=place)
    )


def _flushed(body: ag.Body, flush: Flush) -> ag.Body:
    """Let water run when a lever or a key is used: 3 l for a half flush, else 6 l."""
    name = "flush_turn" if flush == "lever" else "flush_slide_full" if flush == "keys" else "flush_slide"
    water = signals.timer(signals.pressed(name), 5.0)
    if flush == "keys":
        water = water | signals.timer(signals.pressed("flush_slide_half"), 2.5)
    return body.output("flush", water, kind="flow")


def _bowl(plan: _Plan) -> ag.Body:
    """Make the bowl with its foot, open above, with water in it."""
    rim, half, end = plan.rim, plan.half, plan.wall
    match plan.style:
        case "coupled":
            end = plan.wall + plan.deep - 0.02
            pan = plan.pan([(0.58, 0.70), (0.88, 0.92)], [rim - 0.23, rim - 0.12], 0.035, 0.86)
            shares = ((0.70, 0.68), (0.625, 0.63), (0.55, 0.58), (0.50, 0.55))
            foot = [plan.ring(*share, end - 0.05, 0.9) for share in shares]
            stem = ag.loft(foot[:3], [0, 0.04, 0.08]) | ag.loft(foot[2:], [0.08, rim - 0.20])
            under = ag.box(0.9 * half, end - 0.06, 0.02, bevel=0.009).align((0, 0, rim - 0.21), y=-1)
            shelf = ag.Region((-0.72 * half, 0.72 * half), (-0.02, end), (rim - 0.06, rim - 0.003))
            rest = [stem, ag.hull(shelf.box(bevel=0.012), under)]
        case "one_piece":
            end = plan.wall + plan.deep - 0.02
            pan, rest = plan.pan([(0.86, 0.84)], [0.0], end, 0.95), []
        case "hung":
            pan, rest = plan.pan([(0.66, 0.70), (0.92, 0.95)], [rim - 0.33, rim - 0.2], end, 0.93), []
    length = plan.length - _OVERHANG
    bends = [plan.hole(share, length, 0.047, 16) for share in (0.42, 0.86, 1.0, 1.0)]
    hollow = ag.loft(bends, [rim - 0.19, rim - 0.12, rim - _BRIM, rim + 0.01])
    pool = [plan.hole(share, length, 0.047, 24) for share in (0.42, 0.60)]
    china = plan.glaze.with_(name=f"{plan.glaze.name}_bowl", density=_DENSITY[plan.style])
    return ag.weld(
        ag.part(ag.union(pan - hollow, *rest), "bowl", china),
        ag.detail(ag.loft(pool, [rim - 0.19, rim - 0.158]), "water", _WATER),
    )


def _posts(plan: _Plan) -> ag.Body:
    """Make the two posts between the barrels of seat and lid."""
    barrel = ag.cylinder(0.009, 0.018, axis=ag.X, bevel=0.0008).at(0.0775, 0, plan.rim + _HINGE_Z)
    foot = ag.box(0.018, 0.016, 0.006).align((0.0775, 0, plan.rim), z=-1)
    post = ag.hull(barrel, foot)
    return ag.part([post, post.mirror(ag.X)], "hinge", plan.metal)


def _leaf(plate: ag.Solid, label: str, finish: ag.Material, inner: float, low: float, top: float) -> ag.Body:
    """Make a seat or a lid about its hinge, with its two barrels beside those of the bowl."""
    room = ag.Region((inner, inner + 0.020), (-0.030, 0.002), (low, top))
    knuckle = ag.cylinder(0.0085, 0.020, axis=ag.X, bevel=0.0008).at(inner + 0.010)
    barrel = room.box(bevel=0.001) | knuckle
    hold = ag.grasp_on(plate, approach=ag.Y, closing=ag.Z, depth=0.0095)
    return ag.part(ag.union(plate, barrel, barrel.mirror(ag.X)), label, finish, grasp=hold, name=label)


def _seat(plan: _Plan, finish: ag.Material) -> ag.Body:
    """Make the ring of the seat about its hinge."""
    reach = plan.length - 0.5 * _OVERHANG
    outline = plan.outline(plan.half + 0.002, plan.tip - 0.5 * _OVERHANG, reach, -0.022)
    plate = ag.extrude(outline - plan.hole(1.0, reach, 0.068, 24), 0.016, bevel=0.005)
    return _leaf(plate.at(z=-0.006), "seat", finish, 0.0875, -0.007, 0.0)


def _lid(plan: _Plan, finish: ag.Material) -> ag.Body:
    """Make the lid about its hinge."""
    plate = ag.extrude(plan.outline(plan.half + 0.004, plan.tip, plan.length, -0.016), 0.013, bevel=0.004)
    return _leaf(plate.at(z=0.0108), "lid", finish, 0.0475, 0.0032, 0.009)


def _cistern(
    body: ag.Body, plan: _Plan, flush: Flush, wide: ag.Scalar, high: ag.Scalar, maker: str
) -> ag.Body:
    """Add the cistern with its lid and its flush."""
    soft = 0.026 if plan.power == 1.0 else 0.009
    top, front = plan.rim + high, plan.wall
    room = ag.Region((-wide, wide), (front, front + plan.deep), (plan.rim - 0.004, top))
    cover = room.with_(z=(top - 0.004, top + 0.032)).grow(front=0.006, left=0.006, right=0.006)
    china = plan.glaze.with_(name=f"{plan.glaze.name}_cistern", density=820.0)
    tank = ag.part([room.box(bevel=soft), cover.box(bevel=0.4 * soft)], "cistern", china)
    mark = details.printed(
        details.logo(maker, 0.007), (0, front, plan.rim + 0.75 * high), material=plan.metal
    )
    body = ag.weld(body, tank, mark)
    if flush == "lever":
        return body.install(_lever(plan.metal), at=(-0.68 * wide, front, top - 0.055))
    keys = _keys(flush, plan.metal).rotate(ag.X, -math.pi / 2)
    return body.install(keys, at=(0, front + plan.deep / 2, top + 0.032))


def _lever(metal: ag.Material) -> Fitting:
    """Make a lever before the cistern, which a spring returns; its free end is pressed down."""
    boss = ag.part(ag.cylinder(0.013, 0.006, axis=ag.Y, bevel=0.001).at(y=-0.003), "plate", metal)
    hub = ag.cylinder(0.0095, 0.012, axis=ag.Y, bevel=0.001).at(y=-0.0126)
    arm = ag.hull(
        ag.cylinder(0.008, 0.007, axis=ag.Y, bevel=0.001),
        ag.cylinder(0.0055, 0.007, axis=ag.Y, bevel=0.001).at(0.075),
    )
    blade = arm.at(y=-0.0155)
    press = ag.push_on(blade, direction=-ag.Z, at=(0.066, -0.0155, 0.005))
    lever = ag.part(hub | blade, "lever", metal, push=press, name="flush")
    turn = ag.Revolute(
        "flush_turn", axis=ag.Y, limits=(0, 0.45), spring=ag.Spring(preload=0.25, force=0.7), feel=_FLUSH
    )
    return Fitting.moving(lever, turn, fixed=boss)


def _key(cap: ag.Solid, metal: ag.Material) -> Fitting:
    """Make a key that a spring returns, pressed along y."""
    made = ag.part(cap, "button", casting(metal, 0.2), push=ag.push_on(cap, direction=ag.Y), name="flush")
    return Fitting.moving(made, controls.button_press("flush_slide", travel=_TRAVEL, preload=4.0, force=12.0))


def _keys(flush: Flush, metal: ag.Material) -> Fitting:
    """Make one round button, or two half discs, in a rim; pressed, they sink into the cistern."""
    radius, proud, deep = 0.023, _TRAVEL + 0.003, 0.014
    half = ag.circle(radius) & ag.rectangle(radius, 2 * radius).at(radius / 2 + 0.0005)
    outlines = {"": ag.circle(radius)} if flush == "button" else {"_half": half.mirror(), "_full": half}
    ring = ag.extrude(ag.ring(1.46 * radius, radius + FIT.sliding), 0.003, axis=ag.Y, bevel=0.001).at(
        y=-0.001
    )
    fixed = ag.detail(ring, "plate", metal)
    for suffix, outline in outlines.items():
        cap = ag.extrude(outline, proud + deep, axis=ag.Y, bevel=0.001).at(y=(deep - proud) / 2)
        fixed = fixed.install(_key(cap, metal).suffixed(suffix))
    return Fitting(fixed, controls.button_hole(2 * radius, through=deep + _TRAVEL + 0.002))


def _plate(metal: ag.Material) -> Fitting:
    """Make the plate of a concealed cistern with two keys."""
    plate, thick, deep = ag.Region.centered(0.246, 0.0, 0.164), 0.008, 0.004
    fixed = ag.part(plate.grow(front=thick).box(bevel=0.003), "plate", metal)
    for suffix, x, wide in (("_half", -0.066, 0.060), ("_full", 0.032, 0.110)):
        cap = (
            ag.Region.centered(wide, 0.0, 0.110)
            .grow(front=thick + _TRAVEL + 0.002, back=deep)
            .box(bevel=0.002)
        )
        hole = controls.button_hole(wide, 0.110)
        fixed = fixed.install(Fitting(_key(cap, metal).body, hole).suffixed(suffix).at(x))
    niche = ag.Region.centered(0.20, 0.0, 0.13).grow(front=0.001, back=deep + _TRAVEL + 0.004)
    return Fitting(fixed, niche.box())
