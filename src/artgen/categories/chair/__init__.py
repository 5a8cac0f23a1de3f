"""A chair that moves: an office chair, a bar stool, a rolling stool, a folding chair or a recliner.

Links: `base`; `seat`; `back`, `lever`, and `caster_fork_0`, `caster_wheel_0`, ... of an office chair; `legs`
and `strut` of a folding chair; `footrest` of a recliner. Joints: `seat_lift` and `seat_swivel`, both between
base and seat; `back_tilt`; `lever_pull`; `caster_swivel_0` and `caster_roll_0`, ...; `seat_fold`, and
`legs_fold` and `strut_turn`, which follow it; `footrest_turn`, which follows `back_tilt`.

A gas spring lifts the seat while the lever below it is pulled; friction stands for its valve otherwise. The
seat of a folding chair is turned up, and its rear legs swing to the front ones: a four-bar of front legs,
seat, struts and rear legs.

Sizes are those of EN 1335-1 and of shops: seats of office chairs 400-520 mm high with a lift of 80-120 mm,
bases with five arms of 300-340 mm, 10-18 kg; bar stools 600-800 mm high with a base of 380-420 mm, 7-14 kg;
rolling stools 440-570 mm high, 5-10 kg; folding chairs with seats at 440-460 mm, 3-6 kg; recliners 750-900 mm
wide, 30-50 kg, those with arms of wood 620-760 mm and 24-40 kg. Backs of office chairs tilt by 20 degrees
against 15-40 N m, those of recliners by 35-45 degrees.
"""

import math
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared import fixings
from artgen.categories.shared.finish import casting, colors
from artgen.categories.shared.furniture import WOODS

Style = Literal["office", "bar", "rolling", "folding", "recliner"]
"""A chair on casters, a stool on a disc or on casters, a folding chair, or a recliner."""

Arms = Literal["none", "posts", "loops", "block", "rolled", "wood"]
"""Arms of an office chair: none, pads on posts, or closed loops; of a recliner: padded boxes with flat or
with round tops, or an open frame of wood."""

Form = Literal["padded", "tapered", "framed"]
"""Back of an office chair: a cushion, one that is narrow at its top, or a sheet in a frame."""

_ARMS: dict[str, tuple[Arms, ...]] = {
    "office": ("none", "posts", "loops"),
    "recliner": ("block", "rolled", "wood"),
}
_WHEEL = 0.025  # radius of a caster [m]
_ON = 2 * _WHEEL + 0.0155  # height of the arms on their casters [m]
_GRIP = 0.0145  # radius of the piston of a gas spring [m]
_TUBE = 0.011  # radius of the tubes of a folding chair [m]
_ASIDE = 0.205  # distance of its front legs from the middle [m]
_INNER = 0.1805  # distance of its rear legs from the middle [m]
_PRESSED = 0.2  # share of steel in arms of 52 x 29 mm with walls of 2 mm
# steel of a tube of 50 x 1.5 mm and of its cover of 61 x 1.2 mm, over the section of the column [kg/m3]
_COLUMN = 3000.0
# steel of a gas cylinder of 28 x 1.5 mm and of its rod of 10 mm, over the section of the piston [kg/m3]
_PISTON = 2500.0

_OFFICE = ag.choice(*colors("fabric", "graphite navy light_grey red teal"), "black_leather", "mesh")
_BOARDS = ag.choice(*WOODS[:5], *colors("abs", "white graphite red"))
_SOFT = ag.choice(
    "leather", "black_leather", "cream_leather", "velvet", "linen", *colors("fabric", "graphite sage sand")
)
_STOOLS = ag.choice("black_leather", "cream_leather", "leather", *colors("abs", "white sage red"))
_BASES = ag.choice("black_abs", "aluminium", *colors("abs", "white"))

_RANGES = {  # height and width of the seat and height of the back [m], and tilt [rad]
    "office": ((0.42, 0.47), (0.46, 0.52), (0.45, 0.65), (0.28, 0.38)),
    "bar": ((0.58, 0.66), (0.36, 0.42), (0.12, 0.28)),
    "rolling": ((0.44, 0.50), (0.34, 0.40)),
    "folding": ((0.44, 0.46), (0.34, 0.36)),
    "recliner": ((0.43, 0.47), (0.50, 0.60), (0.58, 0.70), (0.60, 0.78)),
}
_HEIGHTS, _WIDTHS, _BACKS, _TILTS = (
    {style: ag.uniform(*row[column]) for style, row in _RANGES.items() if column < len(row)}
    for column in range(4)
)


@ag.category(
    labels="base column foot caster wheel screw seat back frame arm lever footrest slat leg", joints=(2, 14)
)
def chair(
    *,
    style: Style = ag.choice(
        {"office": 0.32, "bar": 0.22, "rolling": 0.12, "folding": 0.18, "recliner": 0.16}
    ),
    height: ag.Float = ag.by("style", _HEIGHTS, unit="m", within=(0.38, 0.75), doc="height of the seat"),
    width: ag.Float = ag.by("style", _WIDTHS, unit="m", within=(0.32, 0.65), doc="width of the seat"),
    tall: ag.Float = ag.by(
        "style", _BACKS, otherwise=0.3, unit="m", within=(0.1, 0.8), doc="height of the back"
    ),
    travel: ag.Float = ag.uniform(0.08, 0.12, "m", within=(0.05, 0.13), doc="lift of the seat"),
    tilt: ag.Float = ag.by(
        "style", _TILTS, otherwise=0.3, unit="rad", within=(0.2, 0.85), doc="tilt of the back"
    ),
    torque: ag.Float = ag.uniform(18.0, 35.0, "N m", doc="that holds the back of an office chair"),
    arms: Arms = ag.by(
        "style",
        office={"posts": 0.4, "loops": 0.3, "none": 0.3},
        recliner={"block": 0.35, "rolled": 0.35, "wood": 0.3},
        otherwise="none",
    ),
    form: Form = ag.by("style", office=ag.choice("padded", "tapered", "framed"), otherwise="padded"),
    headrest: bool = ag.by("style", office=ag.choice({True: 0.3, False: 0.7}), otherwise=False),
    backed: bool = ag.by("style", bar=ag.choice(True, False), otherwise=False, doc="back of a stool"),
    cover: ag.Material = ag.by("style", office=_OFFICE, folding=_BOARDS, recliner=_SOFT, otherwise=_STOOLS),
    metal: ag.Material = ag.by(
        "style",
        folding=ag.shades("chrome", "powder_coat_black", "powder_coat_white", "powder_coat_graphite"),
        office=_BASES,
        recliner=ag.choice(*WOODS[:4]),
        otherwise=ag.shades("chrome", "stainless", "powder_coat_black", weights=(3, 2, 2)),
        doc="of the base or frame; the wood of the feet and arms of a recliner",
    ),
) -> ag.Body:
    """Make a chair that faces the front, its seat down and its back upright."""
    own = _ARMS.get(style, ("none",))
    ag.require(arms in own, f"arms={arms} are not for style={style}: arms must be {' or '.join(own)}")
    match style:
        case "folding":
            return _folding(ag.require(height, height <= 0.47, "height must be <= 0.47 m"), cover, metal)
        case "recliner":
            tall = ag.require(tall, tall >= 0.3, "tall of a recliner must be >= 0.3 m")
            return _recliner(height, width, tall, tilt, cover, metal, arms)
        case "office":
            tall = ag.require(tall, tall >= 0.32, "tall of an office chair must be >= 0.32 m")
            seat = _office_seat(height, width, cover, arms)
        case _:
            seat = _round_seat(height, width, tall if backed else None, cover, metal)
    base = _disc(height, metal) if style == "bar" else _star(style, metal)
    top = height - (0.085 if style == "office" else 0.075)  # underside of the plate below the seat
    low = 0.028 if style == "bar" else _ON + 0.030
    column = ag.Region.centered(0.046, 0.046, 0.0).with_(z=(low, top - 0.016))
    hollow = column.shrink(x=0.0075, y=0.0075).with_(z=(low + 0.02, top))
    skin = ag.tube(0.034, 0.0305, column.z.size - 0.012, bevel=0.001).at(z=column.z.mid + 0.006)
    dark = ag.material("black_steel") if style == "office" else metal
    base = ag.weld(
        base,
        ag.part(column.box() - hollow.box(), "column", dark.with_(name="column_steel", density=_COLUMN)),
        ag.detail(skin, "column", dark),
    )
    piston = ag.cylinder_between((0, 0, low + 0.025), (0, 0, top + 0.004), _GRIP)
    plate = ag.Region((-0.085, 0.085), (-0.105, 0.105), (top, top + 0.026)).box(bevel=0.004)
    seat = ag.weld(
        seat,
        ag.part(plate, "frame", ag.material("black_steel").with_(name="plate_steel", density=2500.0)),
        ag.part(piston, "column", ag.material("chrome").with_(name="piston", density=_PISTON)),
    )
    if style == "office":
        back = _back(form, width - 0.05, tall, cover, headrest=headrest)
        seat = _tilting(seat, back, height, tall, tilt, torque)
    seat = _levered(seat, ag.min_(width, 0.58 if style == "office" else 0.46), top)
    lift = ag.Prismatic(
        "seat_lift", axis=ag.Z, limits=(0, travel), damping=400.0, friction=1.5 * seat.weight(),
        effort=900.0, velocity=0.2, driven="a gas spring, while the lever is pulled",
    )  # fmt: skip
    swivel = ag.Revolute("seat_swivel", axis=ag.Z, damping=0.4, friction=0.6, effort=60.0)
    return base.attach(seat, lift, swivel)


def _star(style: Style, metal: ag.Material) -> ag.Body:
    """Make a base with five arms on casters: molded or cast for an office chair, or of pressed steel."""
    reach, share = (0.32, 0.6) if style == "office" else (0.27, _PRESSED)
    arm = ag.hull(
        ag.box(0.050, 0.02, 0.038, bevel=0.004).at(0, -0.03, _ON + 0.021),
        ag.box(0.054, 0.054, 0.020, bevel=0.004).at(0, -reach, _ON + 0.010),
    )
    turns = [math.tau * step / 5 for step in range(5)]
    hub = ag.cylinder(0.046, 0.044, bevel=0.004).at(z=_ON + 0.024)
    base = ag.part(ag.union(hub, *(arm.rotate(ag.Z, turn) for turn in turns)), "base", casting(metal, share))
    for number, turn in enumerate(turns):
        caster = fixings.caster(radius=_WHEEL, width=0.025, finish=ag.material("black_abs"))
        at = (reach * math.sin(turn), -reach * math.cos(turn), _ON)
        base = base.install(caster.rotate(ag.X, math.pi / 2).suffixed(f"_{number}"), at=at)
    return base


def _disc(height: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make a heavy disc with a ring for the feet."""
    line = [(0.200, 0.0, 0.002), (0.200, 0.0, 0.008), (0.10, 0.0, 0.022), (0.036, 0.0, 0.040)]
    disc = ag.cylinder(0.196, 0.012, bevel=0.003).at(z=0.008)
    cone = ag.revolve(ag.half_section(ag.polyline(line)), sides=48)
    pad = ag.cylinder(0.19, 0.003).at(z=0.0015)
    level = 0.42 * height
    turns = [math.pi / 2 + 0.35 + (math.tau - 0.7) * step / 12 for step in range(13)]
    bends = [(0.125 * math.cos(turn), 0.125 * math.sin(turn) - 0.09, level) for turn in turns]
    course = ag.arc((0, -0.09, level), 0.125, start=math.pi / 2 + 0.35, sweep=math.tau - 0.7)
    ring = ag.sweep(ag.regular_polygon(6, 0.0105), ag.polyline(bends))
    look = ag.sweep(ag.circle(0.011), course)
    clamp = ag.box(0.096, 0.096, 0.022, bevel=0.003) - ag.box(0.045, 0.045, 0.1)
    heavy = metal.with_(name=f"{metal.name}_disc", density=3000.0)
    return ag.weld(
        ag.part(disc, "base", heavy),
        ag.part(pad, "foot", ag.material("rubber")),
        ag.detail(cone, "base", metal),
        ag.part([clamp.at(z=level), ring], "footrest", casting(metal, 0.4)),
        ag.detail(look, "footrest", metal),
    )


def _office_seat(height: ag.Scalar, width: ag.Scalar, cover: ag.Material, arms: Arms) -> ag.Body:
    """Make the seat of an office chair with its arms."""
    soft = cover.with_(name=f"{cover.name}_cushion", density=140.0)
    shell = ag.Region.centered(width - 0.09, 0.38, 0.0).with_(z=(height - 0.060, height - 0.044))
    cushion = ag.box(width, 0.47, 0.050, bevel=0.018, crown=0.010).at(z=height - 0.025)
    hold = ag.grasp_on(cushion, approach=ag.Y, closing=ag.Z, depth=0.020)  # at its front edge, to turn it
    seat = ag.part(cushion, "seat", soft, name="seat", grasp=hold)
    seat = ag.weld(seat, ag.part(shell.box(bevel=0.006), "seat", ag.material("black_abs")))
    if arms == "none":
        return seat
    x = width / 2 + 0.035
    foot = ag.Region((width / 2 - 0.06, x + 0.016), (-0.03, 0.03), (height - 0.060, height - 0.046))
    post = ag.Region((x - 0.016, x + 0.016), (-0.03, 0.03), (height - 0.059, height + 0.200))
    if arms == "posts":
        pad = ag.Region((x - 0.042, x + 0.042), (-0.13, 0.12), (height + 0.196, height + 0.222))
        made = [foot.box(bevel=0.003) | post.box(bevel=0.006), pad.box(bevel=0.010)]
    else:
        loop = post.grow(y=0.10).with_(z=(height - 0.060, height + 0.215))
        hole = loop.shrink(y=0.028, z=0.028).grow(x=0.1)
        made = [foot.box(bevel=0.003), loop.box(bevel=0.006) - hole.box()]
    sides = [[each, each.mirror(ag.X)] for each in made]
    return ag.weld(seat, *(ag.part(each, "arm", ag.material("black_abs")) for each in sides))


def _round_seat(
    height: ag.Scalar, width: ag.Scalar, back: ag.Scalar | None, cover: ag.Material, metal: ag.Material
) -> ag.Body:
    """Make the seat of a stool, with a low back or without one."""
    hard = cover.name.startswith("abs")
    # hard ones are shells of two walls of 4 mm, soft ones foam [kg/m3]
    soft = cover.with_(name=f"{cover.name}_stool", density=300.0 if hard else 180.0)
    pads, frame = [], []
    if back is None:
        thick = 0.030 if hard else 0.052
        cushion = ag.cylinder(width / 2, thick, bevel=0.45 * thick).at(z=height - thick / 2)
        board = ag.cylinder(width / 2 - 0.03, 0.061 - thick).at(z=height - (0.061 + thick) / 2 + 0.002)
    else:
        thick = 0.045
        cushion = ag.box(width, width - 0.02, thick, bevel=0.016, crown=0.006).at(z=height - thick / 2)
        board = ag.box(width - 0.06, width - 0.08, 0.018, bevel=0.004).at(z=height - thick - 0.007)
        rest = ag.box(width - 0.02, 0.035, back, bevel=0.015)
        pads = [rest.rotate(ag.X, -0.12).at(y=width / 2 + 0.03, z=height + 0.10 + back / 2)]
        knot = ag.box(0.032, 0.010, 0.010)
        knee = knot.at(0, width / 2 + 0.022, height - thick - 0.006)
        post = ag.hull(ag.box(0.032, 0.02, 0.010).at(0, 0.3 * width, height - thick - 0.008), knee)
        rise = ag.hull(knee, knot.at(0, width / 2 + 0.030, height + 0.14))
        frame = [ag.part([post, rise], "frame", casting(metal, 0.5))]
    hold = ag.grasp_on(cushion, approach=ag.Y, closing=ag.Z, depth=0.020)
    seat = ag.part([cushion, *pads], "seat", soft, name="seat", grasp=hold)
    return ag.weld(seat, ag.part(board, "seat", ag.material("plywood")), *frame)


def _back(form: Form, wide: ag.Scalar, tall: ag.Scalar, cover: ag.Material, *, headrest: bool) -> ag.Body:
    """Make the back of an office chair about its middle, with its headrest."""
    soft = cover.with_(name=f"{cover.name}_back", density=110.0)
    black = casting(ag.material("black_abs"), 1.2)
    long, at = (tall - 0.14, -0.07) if headrest else (tall, 0.0)
    thick, bevel, crown = (0.026, 0.010, 0.0) if form == "framed" else (0.044, 0.018, 0.008)
    pad = ag.box(wide, thick, long, bevel=bevel, crown=crown).at(z=at)
    if form == "tapered":
        low = ag.box(wide, thick, 0.5 * long, bevel=0.016).at(z=at - 0.25 * long)
        pad = ag.hull(low, ag.box(0.72 * wide, 0.036, 0.09, bevel=0.016).at(z=at + long / 2 - 0.045))
    head = ag.box(0.27, 0.050, 0.11, bevel=0.018).at(z=tall / 2 - 0.055)
    hold = ag.grasp_on(head if headrest else pad, approach=-ag.Z, closing=ag.Y, depth=0.030)
    own = () if headrest else (hold,)
    if form == "framed":
        spine = ag.box(0.048, 0.018, long - 0.10, bevel=0.004).at(y=0.010, z=at)
        sheet = ag.box(wide - 0.066, 0.008, long - 0.066).at(z=at)
        ring = pad - ag.box(wide - 0.07, 0.1, long - 0.07).at(z=at)
        back = ag.part([ring, spine], "frame", black, name="back", grasp=own)
        back = ag.weld(back, ag.part(sheet, "back", soft))
    else:
        back = ag.part(pad, "back", soft, name="back", grasp=own)
    if headrest:
        stem = ag.box(0.050, 0.014, 0.10, bevel=0.003).at(y=0.004, z=tall / 2 - 0.12)
        back = ag.weld(back, ag.part(head, "back", soft, grasp=hold), ag.part(stem, "frame", black))
    return back


def _tilting(
    seat: ag.Body, back: ag.Body, height: ag.Scalar, tall: ag.Scalar, tilt: ag.Scalar, torque: ag.Scalar
) -> ag.Body:
    """Join a back to a seat that tilts about an axis under its rear, against a spring."""
    low, y = height - 0.105, 0.15  # of the axis
    black = ag.material("black_abs")
    bar = ag.Region((-0.030, 0.030), (y - 0.012, 0.300), (low - 0.011, low + 0.011))
    post = ag.hull(
        ag.box(0.060, 0.022, 0.022, bevel=0.004).at(0, 0.288, low),
        ag.box(0.050, 0.018, 0.022, bevel=0.004).at(0, 0.302, height + 0.16 + 0.45 * tall),
    )
    side = (y - 0.06, y + 0.014), (low - 0.012, height - 0.072)
    ears = [ag.Region((x - 0.006, x + 0.006), *side).box(bevel=0.002) for x in (-0.042, 0.042)]
    bridge = ag.Region((-0.06, 0.06), (0.09, y - 0.030), (height - 0.082, height - 0.059)).box(bevel=0.002)
    seat = ag.weld(seat, ag.part([*ears, bridge], "frame", black))
    support = ag.part([bar.box(bevel=0.004), post], "frame", casting(black, 1.2))
    back = ag.weld(back.rotate(ag.X, -0.06).at(y=0.278, z=height + 0.16 + tall / 2), support)
    turn = ag.Revolute(
        "back_tilt", axis=-ag.X, pivot=(0, y, low), limits=(0, tilt), damping=3.0, friction=0.5, effort=120.0,
        spring=ag.Spring(preload=0.4 * torque, force=torque),
    )  # fmt: skip
    return seat.attach(back, turn)


def _levered(seat: ag.Body, width: ag.Scalar, top: ag.Scalar) -> ag.Body:
    """Join the lever of the gas spring to a seat; its end is pulled up."""
    root, end, level = 0.0866, width / 2 - 0.005, top - 0.001
    rod = ag.cylinder_between((root, -0.03, level), (end, -0.03, level), 0.005)
    paddle = ag.Region((end - 0.055, end + 0.004), (-0.048, -0.012), (level - 0.006, level + 0.006))
    blade = paddle.box(bevel=0.004)
    pull = ag.push_on(blade, direction=ag.Z)
    lever = ag.part(rod | blade, "lever", ag.material("black_abs"), push=pull)
    turn = ag.Revolute(
        "lever_pull", axis=-ag.Y, pivot=(root, -0.03, level), limits=(0, 0.06),
        spring=ag.Spring(preload=0.25, force=0.9), feel=feel.LEVER, friction=0.03, effort=4.0,
    )  # fmt: skip
    return seat.attach(lever, turn)


def _folding(height: ag.Scalar, cover: ag.Material, metal: ag.Material) -> ag.Body:
    """Make a folding chair: seat and rear legs turn on the front legs, and struts join them."""
    slope, top = 1.05, 0.80
    way = ag.vector(0, math.cos(slope), math.sin(slope))
    across = ag.vector(0, math.sin(slope), -math.cos(slope))  # to the rear
    foot = ag.vector(0, -0.24, 0.012)

    def on(z: ag.Scalar, behind: float = 0.0) -> ag.Vector:
        return foot + way * ((z - 0.012) / math.sin(slope)) + across * behind

    def both(low: ag.Vector, high: ag.Vector, radius: float, x: float, end: float = 0.0) -> list[ag.Solid]:
        """Return bars on both sides; a pin runs from x to its end across the chair."""
        ends = [(-x, -(end or x)), (x, end or x)]
        return [ag.cylinder_between(low + ag.X * s, high + ag.X * e, radius) for s, e in ends]

    def plates(one: ag.Vector, other: ag.Vector, radius: float, low: float, high: float) -> list[ag.Solid]:
        disc = ag.cylinder(radius, high - low, axis=ag.X, bevel=0.0008)
        places = [ag.X * (s * (low + high) / 2) for s in (-1, 1)]
        return [ag.hull(disc.at(one + place), disc.at(other + place)) for place in places]

    steel, wood = casting(metal, 0.3), cover.with_(name=f"{cover.name}_board", density=600.0)
    rubber = ag.material("rubber")
    seat_at = on(height - 0.009)
    legs_at, back = seat_at - way * 0.096, ag.vector(0, 0.032, 0.004)
    seat_pin, legs_pin = seat_at + back, legs_at + ag.vector(0, 0.0476, -0.0131)
    rear = ag.vector(0, 0.235, 0.012)

    bar, stubs = on(0.16, -0.022), both(on(0.16, -0.022), on(0.16), 0.007, _ASIDE)
    rung = ag.cylinder_between(bar - ag.X * _ASIDE, bar + ag.X * _ASIDE, 0.008)
    slat = ag.box(2 * _ASIDE + 0.01, 0.012, 0.062, bevel=0.004).rotate(ag.X, slope - math.pi / 2)
    slats = [slat.at(on(z, 0.0165)) for z in (0.68, 0.765)]
    front = ag.weld(
        ag.part([*both(foot, on(top), _TUBE, _ASIDE), ag.union(rung, *stubs)], "frame", steel, name="base"),
        ag.part([ag.sphere(0.012).at(foot + ag.X * s) for s in (-_ASIDE, _ASIDE)], "foot", rubber),
        ag.part(slats, "slat", wood),
    )
    low = rear + (legs_at - rear) * 0.25
    beside = legs_at + (rear - legs_at) * 0.09
    bars = [*both(rear, legs_at, 0.010, _INNER), *both(legs_at, legs_at, 0.007, _INNER, 0.1935)]
    bars += [ag.cylinder_between(low - ag.X * _INNER, low + ag.X * _INNER, 0.008)]
    bars += both(legs_pin, legs_pin, 0.005, _INNER, 0.1690)
    bars += plates(beside, legs_pin, 0.008, _INNER - 0.003, _INNER + 0.003)
    legs = ag.weld(
        ag.part(bars, "leg", steel, name="legs"),
        ag.part([ag.sphere(0.012).at(rear + ag.X * s) for s in (-_INNER, _INNER)], "foot", rubber),
    )
    pairs = ((legs_pin, 0.1612, 0.1626), (seat_pin, 0.1684, 0.1699))
    rivets = [end for pin, low, high in pairs for end in both(pin, pin, 0.0055, low, high)]
    bars = plates(legs_pin, seat_pin, 0.008, 0.1625, 0.1685)
    strut = ag.weld(
        ag.part(bars, "leg", steel, name="strut", separate="a strut on either side"),
        ag.detail(rivets, "leg", steel),
    )
    half, center = 0.160, ag.vector(0, 0, 0)
    board = ag.Region((-half, half), (-0.345, 0.044), (-0.009, 0.009)).box(bevel=0.005)
    grip = ag.grasp_on(board, approach=ag.Y, closing=ag.Z, depth=0.03)
    pins = [*both(center, center, 0.006, half - 0.02, 0.1935), *both(back, back, 0.005, half - 0.02, 0.1620)]
    seat = ag.weld(ag.part(board, "seat", wood, grasp=grip, name="seat"), ag.part(pins, "seat", steel))
    fold = ag.Revolute(
        "seat_fold", axis=-ag.X, limits=(0, math.pi - slope - 0.12), damping=0.3, friction=0.6, effort=30.0
    )
    swing = ag.Revolute("legs_fold", axis=-ag.X, pivot=legs_at, damping=0.3)
    turn = ag.Revolute("strut_turn", axis=-ag.X, pivot=legs_pin, damping=0.01)
    body = front.attach(legs.attach(strut, turn), swing).attach(seat, fold, at=seat_at)
    return body.loop("strut", "seat", at=seat_pin, axis=ag.X, driver=fold)


def _recliner(
    height: ag.Scalar,
    width: ag.Scalar,
    tall: ag.Scalar,
    tilt: ag.Scalar,
    cover: ag.Material,
    wood: ag.Material,
    arms: Arms,
) -> ag.Body:
    """Make a recliner, whose footrest rises as its back tilts."""
    soft = cover.with_(name=f"{cover.name}_cushion", density=130.0)
    frame = cover.with_(name=f"{cover.name}_frame", density=160.0)
    half = width / 2
    box = ag.Region((-half - 0.01, half + 0.01), (-0.36, 0.30), (0.10, height - 0.16))
    cushion = ag.box(width, 0.60, 0.15, bevel=0.045, crown=0.02).at(0, -0.12, height - 0.085)
    arm = _recliner_arm(arms, half, height, wood if arms == "wood" else soft)
    base = ag.weld(
        ag.part(box.box(bevel=0.012), "frame", frame, name="base"),
        *(arm, arm.mirror(ag.X)),
        ag.part(cushion, "seat", soft),
    )
    if arms != "wood":  # the posts of its arms are its feet
        places = [(x, y, 0) for x in (-half - 0.08, half + 0.08) for y in (-0.37, 0.30)]
        feet = ag.array(ag.cylinder(0.024, 0.06, bevel=0.003).at(z=0.03), at=places)
        base = ag.weld(base, ag.part(feet, "foot", wood, separate="four feet"))
    # two cushions before a board, and a roll on top for the hand
    y, low = 0.275, height - 0.05
    whole, bottom = tall + 0.08, low - 0.03
    pillows = []
    for high, z in ((0.44 * whole, 0.22 * whole), (0.56 * whole + 0.012, 0.714 * whole)):
        pillow = ag.box(width - 0.012, high, 0.125, bevel=0.045, crown=0.022)
        pillows.append(pillow.rotate(ag.X, math.pi / 2).at(0, y + 0.008, bottom + z))
    shell = ag.box(width - 0.03, 0.05, whole - 0.03, bevel=0.02).at(0, y + 0.075, bottom + whole / 2)
    roll = ag.box(0.82 * width, 0.066, 0.085, bevel=0.03).at(0, y + 0.022, bottom + whole + 0.022)
    hold = ag.grasp_on(roll, approach=-ag.Z, closing=ag.Y, depth=0.03)
    back = ag.weld(
        ag.part([*pillows, roll], "back", soft, grasp=hold, name="back"), ag.part(shell, "back", frame)
    )
    recline = ag.Revolute(
        "back_tilt", axis=-ag.X, pivot=(0, y, low), limits=(0, tilt), damping=8.0, friction=14.0, effort=120.0
    )
    board = ag.Region((-half + 0.02, half - 0.02), (-0.475, -0.442), (0.12, height - 0.045))
    footrest = ag.part(board.box(bevel=0.014), "footrest", soft, name="footrest")
    rise = ag.Revolute(
        "footrest_turn", axis=-ag.X, pivot=(0, -0.444, height - 0.050), follows=1.8 * recline, damping=2.0
    )
    return base.attach(back, recline).attach(footrest, rise)


def _recliner_arm(style: Arms, half: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the right arm of a recliner."""
    wide = {"block": 0.146, "rolled": 0.120}.get(style, 0.045)
    arm = ag.Region((half + 0.004, half + 0.004 + wide), (-0.43, 0.36), (0.055, height + 0.16))
    match style:
        case "block":
            pad = arm.with_(z=(height + 0.15, height + 0.20)).grow(x=0.006, front=0.012).at(x=0.002)
            solids = [arm.box(bevel=0.03), pad.box(bevel=0.022)]
        case "rolled":
            roll = ag.cylinder(0.080, arm.y.size + 0.012, axis=ag.Y, bevel=0.022)
            solids = [arm.box(bevel=0.025), roll.at(half + 0.088, arm.y.mid - 0.006, height + 0.135)]
        case _:
            near, _, far = arm.with_(z=(0.0, height + 0.175)).deep(0.055, None, 0.055)
            pad = arm.with_(z=(height + 0.172, height + 0.200)).grow(x=0.010, y=0.012).at(x=0.009)
            rails = [arm.with_(z=(z, z + 0.085)) for z in (height - 0.26, height - 0.02)]
            solids = [near.box(bevel=0.006), far.box(bevel=0.006)]
            solids += [each.shrink(right=0.008, y=0.05).box(bevel=0.006) for each in rails]
            solids.append(pad.box(bevel=0.012))
    return ag.part(solids, "arm", finish)
