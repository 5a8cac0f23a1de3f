"""A globe of the earth: on a half or a full meridian, in a frame that stands on the floor, or lit.

Links: `base`, the foot with the half meridian, or the frame with its horizon; `ball`; `meridian`, a full ring
that turns in its stand; `button` of a lit globe. Joints: `ball_spin`, without limits; `meridian_turn`, at 0
where the axis leans by 23.4 degrees, as that of the earth does; `button_slide`.

The axis leans to the right, in the plane of the meridian, which is that of the front. At 0 the Atlantic faces
the front. The ball runs on pins and spins on for some seconds after a push. Friction holds a full meridian,
from an upright axis to one that lies. A button springs back and switches the lamp.

Sizes are those of shops (Columbus, National Geographic, Räth): balls of desks are 0.15-0.33 m across and
weigh 0.3-3 kg with their foot, lit ones 0.12-0.30 m and 0.3-2 kg, floor globes 0.32-0.40 m, 0.9-1.1 m high
and 3.5-7 kg. Shells are 1.2-2.5 mm of plastic or of cardboard. The land is a rough outline by hand, of the
places of capes and bays in degrees.
"""

import math
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.shared import controls, vessels
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["half", "full", "floor", "lit"]
"""A half meridian on a foot, a full one in a stand, a frame with legs and a horizon, or a lit ball."""

TILT = math.radians(23.4)
"""Angle of the axis of the earth."""

# capes and bays of the land: latitude and longitude in degrees, to the north and to the east
_LAND = (
    ((71, -156), (70, -128), (68, -110), (72, -95), (63, -92), (58, -93), (52, -80), (62, -77), (60, -65),
     (52, -56), (46, -61), (44, -69), (36, -76), (30, -81), (25, -81), (30, -86), (29, -94), (22, -98),
     (18, -94), (21, -87), (15, -84), (9, -81), (14, -92), (19, -104), (23, -107), (31, -114), (35, -121),
     (48, -125), (58, -136), (60, -146), (55, -162), (62, -166)),
    ((12, -72), (10, -62), (5, -52), (-1, -48), (-5, -35), (-13, -39), (-23, -42), (-28, -49), (-35, -55),
     (-39, -62), (-47, -66), (-54, -68), (-51, -75), (-42, -74), (-30, -71), (-18, -70), (-6, -81),
     (1, -80), (8, -78)),
    ((35, -6), (37, 10), (32, 13), (31, 20), (31, 32), (22, 37), (12, 43), (11, 51), (2, 46), (-5, 39),
     (-15, 41), (-25, 33), (-34, 26), (-34, 18), (-22, 14), (-11, 14), (-1, 9), (4, 9), (6, 2), (4, -8),
     (11, -16), (15, -17), (21, -17), (29, -10)),
    ((36, -6), (43, -9), (48, -4), (53, 6), (57, 9), (54, 14), (60, 22), (65, 24), (63, 18), (56, 13),
     (58, 6), (62, 5), (70, 20), (71, 28), (66, 41), (69, 60), (47, 60), (37, 54), (41, 49), (43, 40),
     (37, 36), (37, 28), (41, 28), (37, 22), (45, 13), (38, 16), (44, 9), (43, 4), (38, 0)),
    ((69, 60), (73, 72), (77, 104), (73, 128), (71, 155), (69, 178), (62, 178), (60, 164), (52, 157),
     (59, 152), (54, 137), (43, 132), (39, 127), (35, 127), (39, 119), (30, 122), (22, 114), (20, 106),
     (10, 106), (14, 100), (2, 103), (9, 98), (17, 96), (22, 90), (16, 81), (8, 77), (20, 72), (25, 66),
     (26, 57), (30, 49), (24, 52), (22, 59), (13, 45), (28, 35), (37, 36), (41, 44), (41, 49), (37, 54),
     (47, 60)),
    ((-12, 131), (-12, 136), (-17, 140), (-11, 142), (-19, 147), (-28, 153), (-38, 150), (-38, 141),
     (-32, 133), (-34, 123), (-34, 115), (-26, 113), (-20, 119), (-14, 127)),
    ((60, -44), (67, -33), (71, -22), (81, -16), (83, -32), (80, -66), (76, -68), (70, -54), (64, -51)),
    ((-70, 0), (-66, 50), (-66, 90), (-66, 130), (-72, 170), (-78, 195), (-73, 250), (-65, 298),
     (-77, 320)),
)  # fmt: skip
_ISLES = (
    ((51, -5), (58, -6), (57, -2), (51, 1)),
    ((-12, 49), (-17, 50), (-25, 47), (-22, 43)),
    ((31, 130), (35, 140), (45, 142), (36, 136)),
    ((5, 96), (-2, 106), (-6, 105)),
    ((7, 117), (0, 118), (-4, 115), (1, 109)),
    ((-1, 131), (-5, 145), (-10, 150), (-8, 138)),
    ((-35, 173), (-41, 176), (-47, 168), (-41, 172)),
    ((66, -22), (65, -14), (63, -19)),
    ((23, -84), (20, -74), (22, -79)),
    ((74, -95), (73, -80), (63, -65), (68, -85)),
)  # fmt: skip
_HOLLOW = {
    "half": 66.0,
    "full": 50.0,
    "floor": 38.0,
    "lit": 72.0,
}  # mass of a ball by its whole volume [kg/m3]
_SIDES = 24  # facets of the solid inside a horizon
_PIN = 0.0035  # radius of the pins of the axis [m]
_GAP = 0.0060  # between a ball and its meridian [m]
_FILM = 0.0004  # height of land and lines above the sea [m]

_ABS = ag.material("glossy_plastic").with_(name="globe_sea", density=1050.0, specular_roughness=0.3)
_INK = ag.material("abs").with_(name="globe_land", texture="", tile=None, specular_roughness=0.4)
# colors of the sea, of the land, one for each part of the world, and of the lines
_SCHEMES: dict[str, tuple[tuple[float, float, float], tuple[tuple[float, float, float], ...], float]] = {
    "political": ((0.10, 0.30, 0.52), ((0.62, 0.50, 0.16), (0.25, 0.46, 0.16), (0.66, 0.30, 0.10),
                                       (0.55, 0.18, 0.20), (0.70, 0.58, 0.26), (0.46, 0.25, 0.40)), 0.75),
    "antique": ((0.60, 0.47, 0.27), ((0.36, 0.22, 0.09), (0.42, 0.28, 0.12), (0.33, 0.19, 0.08)), 0.30),
    "dark": ((0.022, 0.025, 0.030), ((0.62, 0.44, 0.19), (0.58, 0.41, 0.18)), 0.55),
    "white": ((0.78, 0.78, 0.76), ((0.16, 0.17, 0.18), (0.20, 0.21, 0.22)), 0.45),
}  # fmt: skip
_WOODS = ("walnut", "mahogany", "oak", "beech")
_METALS = ("satin_brass", "chrome", "black_steel", "brushed_aluminium", "satin_nickel")


@ag.category(
    labels="base foot pole meridian pin ball land line horizon leg stretcher button switch print",
    joints=(1, 2),
)
def globe(
    *,
    style: Style = ag.choice({"full": 0.32, "half": 0.30, "floor": 0.16, "lit": 0.22}),
    diameter: ag.Float = ag.by(
        "style",
        half=ag.uniform(0.15, 0.30),
        full=ag.uniform(0.22, 0.33),
        floor=ag.uniform(0.32, 0.40),
        lit=ag.uniform(0.14, 0.26),
        unit="m",
        within=(0.12, 0.42),
        doc="diameter of the ball",
    ),
    scheme: Literal["political", "antique", "dark", "white"] = ag.by(
        "style",
        floor={"antique": 0.75, "political": 0.25},
        lit={"political": 0.8, "white": 0.2},
        otherwise={"political": 0.42, "antique": 0.24, "dark": 0.24, "white": 0.10},
        doc="colors of the map",
    ),
    stand: ag.Float = ag.by(
        "style",
        floor=ag.uniform(0.52, 0.62),
        lit=ag.uniform(0.165, 0.24),
        otherwise=ag.uniform(0.10, 0.20),
        within=(0.08, 0.70),
        doc="height below the meridian, as a share of the diameter; of a floor globe in m",
    ),
    foot: Literal["round", "square"] = ag.by(
        "style", floor="round", otherwise={"round": 0.75, "square": 0.25}
    ),
    legs: int = ag.by("style", floor=ag.choice(3, 4), otherwise=4),
    wood: ag.Material = ag.shades(*_WOODS, color=0.05, doc="of a foot or of a frame"),
    metal: ag.Material = ag.shades(*_METALS, weights=(2, 1, 1.4, 1, 1), color=0.04, doc="of a meridian"),
    wooden: bool = ag.by(
        "style", floor=True, lit=False, otherwise={True: 0.5, False: 0.5}, doc="foot of wood"
    ),
    friction: ag.Float = ag.uniform(0.0015, 0.004, "N m", doc="friction of the pins of the ball"),
    shift: ag.Float = ag.uniform(-0.6, 0.6, "rad", doc="turn of the ball at rest", within=(-3.2, 3.2)),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a globe, its axis at the angle of that of the earth."""
    if style in ("lit", "full"):
        least = 0.0225 if style == "lit" else 0.0195
        what = f"below the meridian of a {style} globe must be >= {1e3 * least:g} mm"
        stand = ag.require(stand, stand * diameter >= least, what)
    radius = diameter / 2
    inner = radius + _GAP
    outer = inner + (0.010 if style == "floor" else 0.007)
    height = stand if style == "floor" else stand * diameter
    center = ag.vector(z=outer + height)
    lean = ag.vector(math.sin(TILT), 0.0, math.cos(TILT))
    ball = _ball(radius, scheme, style).rotate(ag.Z, shift).rotate(ag.Y, TILT).at(center)
    spin = ag.Revolute(
        "ball_spin", axis=lean, pivot=center, friction=friction, damping=2e-4, armature=1e-5, effort=0.5,
        driven="the friction of a finger that strokes the ball",
    )  # fmt: skip
    full = style in ("full", "floor")
    arm = _meridian(inner, outer, full=full).rotate(ag.Y, TILT).at(center)
    if style == "floor":
        body = _frame(outer, center, height, legs, wood)
    else:
        body = _foot(
            foot,
            0.62 * diameter,
            height,
            wood if wooden else metal,
            metal,
            maker,
            held=full,
            lit=style == "lit",
        )
    steel = metal.with_(name=f"{metal.name}_meridian", density=2700.0)
    if not full:
        side = center + ag.vector(outer)
        hold = ag.grasp_on(arm, approach=-ag.X, closing=ag.Y, at=side, depth=0.0065)
        post = ag.cylinder(0.006, height - 0.006).at(z=(height + 0.010) / 2)
        body = ag.weld(
            body, ag.part(post, "pole", metal), ag.part(arm, "meridian", steel, name="arm", grasp=hold)
        )
        return body.attach(ball, spin).at(-(outer - 0.62 * radius) / 2)  # the base in the middle
    ring = ag.part(arm, "meridian", steel, grasp=ag.grasp_on(arm, approach=-ag.Z, closing=ag.Y,
                   at=center + ag.vector(z=(inner + outer) / 2), depth=outer - inner))  # fmt: skip
    turn = ag.Revolute(
        "meridian_turn", axis=ag.Y, pivot=center, limits=(-TILT, math.pi / 2 - TILT),
        friction=0.6, damping=0.05, armature=1e-4, effort=6.0,
    )  # fmt: skip
    return body.attach(ring.attach(ball, spin), turn)


def _ball(radius: ag.Scalar, scheme: str, style: Style) -> ag.Body:
    """Make a ball about the origin with its map, its axis upright."""
    sea, lands, grey = _SCHEMES[scheme]
    lit = style == "lit"
    glow = tuple(0.35 * channel for channel in sea) if lit else (0.0, 0.0, 0.0)
    water = _ABS.with_(name=f"sea_{scheme}", base_color=sea, emission=glow, density=_HOLLOW[style])
    solid = ag.sphere(radius)
    hubs = [ag.cylinder(_PIN + 0.002, 0.004).at(z=side * (radius + 0.0002)) for side in (-1, 1)]
    bodies = [ag.part(solid, "ball", water), ag.part(hubs, "pin", ag.material("chrome"))]
    skin, paints = ag.sphere(radius + _FILM), dict[str, ag.Material]()
    for number, places in enumerate((*_LAND, *_ISLES)):
        color = lands[number % len(lands)]
        shine = tuple(0.35 * channel for channel in color) if lit else (0.0, 0.0, 0.0)
        paint = _INK.with_(name=f"land_{scheme}_{number % len(lands)}", base_color=color, emission=shine,
                           base_metalness=0.9 if scheme == "dark" else 0.0)  # fmt: skip
        paints[paint.name] = paint
        patch = _cone(places, radius) & skin
        bodies.append(ag.detail(patch, "land", paint))
    ink = _INK.with_(name="globe_lines", base_color=(grey, grey, grey))
    ring = ag.tube(radius + 0.0003, radius - 0.002, 0.0006)
    lines = [ring.rotate(ag.X, math.pi / 2).rotate(ag.Z, math.pi / 6 * at) for at in range(6)]
    for degrees in (-60, -30, 0, 30, 60):
        turn = math.radians(degrees)
        wide = radius * math.cos(turn) + 0.0003
        lines.append(ag.tube(wide, wide - 0.002, 0.0006).at(z=radius * math.sin(turn)))
    ball = ag.weld(*bodies, ag.detail(lines, "line", ink))
    return _lit(ball, [water, *paints.values()]) if lit else ball


def _lit(ball: ag.Body, maps: Sequence[ag.Material]) -> ag.Body:
    """Let the button switch the lamp in the ball, which is on at delivery: sea and lands shine."""
    on = ~signals.toggle(signals.pressed("button_slide"))
    for number, paint in enumerate(maps):
        name = f"land_{number - 1}" if number else "light"
        ball = ball.output(name, on, kind="light", material=paint, color=paint.emission)
    return ball


def _cone(places: Sequence[tuple[float, float]], radius: ag.Scalar) -> ag.Solid:
    """Make the cone from the middle of the ball through the outline of a land."""
    points = []
    for north, east in places:
        up, turn = math.radians(north), math.radians(east - 90 - 30)
        points.append((math.cos(up) * math.cos(turn), math.cos(up) * math.sin(turn), math.sin(up)))
    x, y, z = (sum(each) / len(points) for each in zip(*points, strict=True))
    length = math.sqrt(x * x + y * y + z * z)
    north, east = math.asin(z / length), math.atan2(y, x)
    flat = []
    for x, y, z in points:  # on the plane that touches the ball in the middle of the land
        ahead, aside = x * math.cos(east) + y * math.sin(east), y * math.cos(east) - x * math.sin(east)
        out, up = ahead * math.cos(north) + z * math.sin(north), z * math.cos(north) - ahead * math.sin(north)
        flat.append((-up / out, aside / out))
    low, high = 0.30, 1.02
    outline = ag.polygon([(u * low * radius, v * low * radius) for u, v in flat])
    cone = ag.extrude(outline, (high - low) * radius, taper=1.0 - high / low).at(z=(low + high) / 2 * radius)
    return cone.rotate(ag.Y, math.pi / 2 - north).rotate(ag.Z, east)


def _meridian(inner: ag.Scalar, outer: ag.Scalar, *, full: bool) -> ag.Solid:
    """Make a meridian about the origin with its two pins, its axis upright."""
    wide = 0.010 if full else 0.012
    turn = math.tau if full else math.pi + 0.12
    if full:
        band = ag.tube(outer, inner, wide, axis=ag.Y, bevel=0.001)
    else:
        section = ag.rectangle(outer - inner, wide, radius=0.002)
        band = ag.sweep(
            section, ag.arc((0, 0, 0), (inner + outer) / 2, start=-turn / 2, sweep=turn, axis=-ag.Y)
        )
    pins = [
        ag.cylinder(_PIN, _GAP - 0.0017).at(z=side * (inner - (_GAP - 0.0017) / 2 + 0.001))
        for side in (-1, 1)
    ]
    return ag.union(band, *pins)


def _foot(
    shape: str, wide: ag.Scalar, height: ag.Scalar, finish: ag.Material, metal: ag.Material, maker: str,
    *, held: bool, lit: bool,
) -> ag.Body:  # fmt: skip
    """Make a foot; a cradle holds a meridian that turns."""
    thick = 0.034 if lit else 0.018
    if shape == "square":
        plate = ag.Region.centered(wide, wide, 1.0).with_(z=(0.0, thick)).box(bevel=0.004)
    else:
        plate = ag.cylinder(wide / 2, thick, bevel=0.004).at(z=thick / 2)
    density = max(finish.density, 700.0) if finish.density < 2600.0 else 900.0 if lit else 2200.0
    body = ag.part(plate, "base", finish.with_(name=f"{finish.name}_foot", density=density))
    mark = details.printed(
        details.logo(maker, 0.006), (0, -0.36 * wide, thick), facing=ag.Z, up=ag.Y, material=metal
    )
    body = ag.weld(body, mark)
    if held:
        body = ag.weld(body, *_cradle(height, thick - 0.001, metal))
    if lit:
        body = body.install(_switch(), at=(0, -wide / 2, 0.017))
    return body


def _switch() -> Fitting:
    """Make the button of a lamp."""
    return controls.push_button(
        finish=ag.material("black_abs"), through=0.012, width=0.016, icon="power", ink=controls.LIGHT_INK
    )


def _cradle(height: ag.Scalar, low: float, metal: ag.Material) -> list[ag.Body]:
    """Make the post and the fork in which a meridian turns: its lowest place is at a height [m]."""
    post = ag.cylinder(0.008, height - FIT.running - low).at(z=(height - FIT.running + low) / 2)
    block = ag.Region((-0.016, 0.016), (-0.011, 0.011), (height - 0.012, height - FIT.running)).box(
        bevel=0.001
    )
    cheeks = [
        ag.Region((-0.016, 0.016), (y - 0.002, y + 0.002), (height - 0.011, height + 0.006)).box(bevel=0.0008)
        for y in (-0.005 - FIT.running - 0.002, 0.005 + FIT.running + 0.002)
    ]
    return [ag.part(ag.union(post, block, *cheeks), "pole", metal)]


def _frame(outer: ag.Scalar, center: ag.Vector, height: ag.Scalar, legs: int, wood: ag.Material) -> ag.Body:
    """Make a frame of wood: legs with a stretcher, a cradle, and a horizon around the meridian."""
    inner, wide = outer + 0.006, 0.052
    board = ag.tube(inner + wide, inner - 0.0004, 0.018, bevel=0.002).at(z=center.z)
    core = vessels.hoop(inner + wide - 0.0004, inner, 0.0174, _SIDES).at(z=center.z)
    places = [math.pi / 4 + math.tau * at / legs for at in range(legs)]
    far = inner + wide - 0.024
    posts, bars = [], []
    knots = (
        (0.0, 0.013),
        (0.06, 0.017),
        (0.12, 0.014),
        (0.30, 0.019),
        (0.62, 0.014),
        (0.86, 0.020),
        (1.0, 0.020),
    )
    tall = center.z - 0.008
    turned = ag.revolve(
        ag.half_section(ag.polyline([(r, 0.0, share * tall) for share, r in knots], fillet=0.02))
    )
    for turn in places:
        x, y = far * math.cos(turn), far * math.sin(turn)
        posts.append(turned.at(x, y))
        bars.append(ag.cylinder_between((x, y, 0.12 * tall), (0.0, 0.0, 0.12 * tall), 0.011))
    hub = ag.cylinder(0.034, 0.036, bevel=0.004).at(z=0.12 * tall)
    made = [
        ag.part(hub, "base", wood, name="base"),
        ag.part(bars, "stretcher", wood),
        ag.part(posts, "leg", wood),
        ag.part(core, "horizon", wood),
    ]
    scale = ag.tube(inner + wide - 0.006, inner + 0.006, 0.0004).at(z=center.z + 0.0090)
    paper = ag.material("abs").with_(
        name="horizon_paper", base_color=(0.62, 0.50, 0.30), texture="", tile=None
    )
    return ag.weld(
        *made,
        ag.detail(board, "horizon", wood),
        ag.detail(scale, "print", paper),
        *_cradle(height, 0.12 * 0.5, wood),
    )
