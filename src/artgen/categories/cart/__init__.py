"""A cart: service or drinks trolley, tool cart with drawers, platform with a folding handle, or hand truck.

Links: `body`; `caster_fork_0`, `caster_wheel_0`, ...; `wheel_right` and `wheel_left` of a drinks trolley or a
hand truck; `drawer_0`, ... of a tool cart, from the top; `handle` of a platform; `toe` of a hand truck.
Joints: `caster_swivel_0`, `caster_roll_0`, ...; `wheel_roll_right`, `wheel_roll_left`; `drawer_slide_0`, ...;
`handle_fold`; `toe_fold`.

A cart is pushed from the right, a hand truck from behind. Casters at the handle swivel, the others of tool
carts and platforms are fixed. The handle of a platform folds down onto it, the toe of a hand truck up.

Sizes are those of shops and catalogs: service trolleys are 0.70-0.95 m long, 0.42-0.60 m deep and 0.85-0.98 m
high, 9-25 kg; drinks trolleys 0.62-0.85 m, 0.42-0.55 m and 0.76-0.86 m, 8-26 kg, heavy ones with trays of
glass; tool cabinets with 3-6 drawers 0.68-0.85 m, 0.38-0.48 m and 0.84-0.98 m, 35-55 kg; platforms 0.75-0.96
m, 0.46-0.62 m and 0.85-0.97 m, 9-15 kg; hand trucks 0.42-0.56 m wide, 0.44-0.55 m deep and 1.05-1.25 m high,
5-15 kg. Casters are 75-125 mm across, large wheels 125-190 mm, those of hand trucks 200-260 mm.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, fixings, furniture, pulls, require_size
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["service", "drinks", "tool", "platform", "truck"]
"""A trolley with trays, one for drinks on two large wheels, a cabinet with drawers, a platform, a truck."""

_TUBE = 0.0125  # radius of the tubes of a frame [m]
_SLIM = 0.0095  # the same of a drinks trolley [m]
_BEND = 0.055  # radius of their bends [m]
_BLACK = ag.material("black_abs")
_RUBBER = ag.material("rubber")
_STEEL = ag.material("zinc")

_FRAMES = {
    "service": ag.shades("stainless", "chrome", *colors("powder_coat", "black white"), color=0.03),
    "drinks": ag.shades("satin_brass", "chrome", "powder_coat_black", weights=(3, 1, 2), color=0.03),
    "tool": ag.choice("chrome", "powder_coat_black"),
    "platform": ag.shades("zinc", *colors("powder_coat", "blue black graphite"), color=0.03),
    "truck": ag.shades("aluminium", *colors("powder_coat", "red blue black forest"), color=0.03),
}
_PANELS = {
    "service": ag.shades("stainless", "beech", *colors("polypropylene", "grey black white"), color=0.04),
    "drinks": ag.shades("walnut", "oak", "tinted_glass", "black_glass", color=0.04),
    "tool": ag.shades(*colors("powder_coat", "red blue graphite black orange"), color=0.04),
    "platform": ag.shades("plywood", *colors("polypropylene", "black grey blue"), color=0.04),
    "truck": ag.choice("aluminium", "black_steel"),
}


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a cart."""

    long: ag.Scalar  # from left to right, without the handle [m]
    deep: ag.Scalar  # [m]
    high: ag.Scalar  # of the handle [m]
    wheel: ag.Scalar  # radius of the wheels [m]
    frame: ag.Material
    panel: ag.Material
    maker: str

    @property
    def on(self) -> ag.Scalar:
        """Height of a face on casters [m]."""
        return 2 * self.wheel + 0.0155

    @property
    def tube(self) -> ag.Material:
        """Material of the tubes, which are hollow."""
        return casting(self.frame, 0.3)


_DEPTHS = {"service": (0.34, 0.7), "tool": (0.34, 0.7), "platform": (0.36, 0.7)}
"""Depths at which the casters swivel past each other [m]."""
_RADII = {"service": (0.03, 0.065), "tool": (0.03, 0.07), "platform": (0.03, 0.07)}
"""Radii of the wheels of casters [m]."""


@ag.category(
    labels="body frame tray handle caster wheel drawer front toe bracket axle bumper mat screw print",
    joints=(3, 12),
)
def cart(
    *,
    style: Style = ag.choice(
        {"service": 0.24, "tool": 0.22, "platform": 0.18, "drinks": 0.18, "truck": 0.18}
    ),
    long: ag.Float = ag.by(
        "style",
        service=ag.uniform(0.70, 0.92),
        drinks=ag.uniform(0.62, 0.78),
        tool=ag.uniform(0.62, 0.72),
        platform=ag.uniform(0.74, 0.92),
        truck=ag.uniform(0.40, 0.50),
        unit="m",
        within=(0.38, 1.1),
        doc="length of the body without its handle; width of a hand truck",
    ),
    deep: ag.Float = ag.by(
        "style",
        service=ag.uniform(0.42, 0.54),
        drinks=ag.uniform(0.36, 0.44),
        tool=ag.uniform(0.38, 0.46),
        platform=ag.uniform(0.46, 0.60),
        truck=ag.uniform(0.20, 0.28),
        unit="m",
        within=(0.18, 0.7),
        doc="depth of the body; length of the toe of a hand truck",
    ),
    high: ag.Float = ag.by(
        "style",
        service=ag.uniform(0.86, 0.97),
        drinks=ag.uniform(0.76, 0.85),
        tool=ag.uniform(0.84, 0.97),
        platform=ag.uniform(0.85, 0.95),
        truck=ag.uniform(1.06, 1.24),
        unit="m",
        within=(0.7, 1.3),
        doc="height of the handle; of the top of a tool cart",
    ),
    trays: int = ag.by("style", service={2: 1, 3: 2}, otherwise=2, doc="trays of a trolley"),
    rows: int = ag.by("style", tool=ag.count(3, 6), otherwise=3, doc="drawers of a tool cart"),
    wheel: ag.Float = ag.by(
        "style",
        service=ag.uniform(0.0375, 0.055),
        drinks=ag.uniform(0.062, 0.095),
        tool=ag.uniform(0.048, 0.0625),
        platform=ag.uniform(0.048, 0.0625),
        truck=ag.uniform(0.10, 0.13),
        unit="m",
        within=(0.03, 0.15),
        doc="radius of the wheels; of the large ones of a drinks trolley",
    ),
    friction: ag.Float = ag.uniform(2.0, 6.0, "N", doc="friction of drawers; in N m of a handle or toe"),
    frame: ag.Material = ag.by("style", _FRAMES, doc="tubes"),
    panel: ag.Material = ag.by("style", _PANELS, doc="trays, cabinet, platform or toe"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make an empty cart with closed drawers and an upright handle."""
    deep = require_size(deep, _DEPTHS.get(style, (0.18, 0.7)), f"depth of a {style} cart")
    wheel = require_size(wheel, _RADII.get(style, (0.03, 0.15)), f"radius of the wheels of a {style} cart")
    plan = _Plan(long, deep, high, wheel, frame, panel, maker)
    match style:
        case "service":
            return _service(plan, trays)
        case "drinks":
            return _drinks(plan)
        case "tool":
            return _tool(plan, rows, friction)
        case "platform":
            return _platform(plan, friction)
        case _:
            return _truck(plan, friction)


def _casters(body: ag.Body, plan: _Plan, level: ag.Scalar, *, fixed: bool) -> ag.Body:
    """Put a caster below each corner of a face at a height; those at the left may be fixed."""
    x, y = plan.long / 2 - 0.055, plan.deep / 2 - 0.050
    for number, (way, side) in enumerate(((1, -1), (1, 1), (-1, -1), (-1, 1))):
        caster = _caster(plan.wheel, swivel=way > 0 or not fixed)
        body = body.install(caster.suffixed(f"_{number}"), at=(way * x, side * y, level))
    return body


def _caster(radius: ag.Scalar, *, swivel: bool = True) -> Fitting:
    """Make a caster below the plane z = 0, which rolls along x."""
    made = fixings.caster(radius=radius, width=0.55 * radius, finish=_STEEL, swivel=swivel)
    return made.rotate(ag.X, math.pi / 2).rotate(ag.Z, math.pi / 2)


def _tray(plan: _Plan, level: ag.Scalar, *, rim: float) -> ag.Body:
    """Make a tray: a board with a rim around it."""
    area = ag.Region.centered(plan.long, plan.deep, 0.0)
    board = area.with_(z=(level, level + 0.012))
    edge = board.with_(z=(level, level + rim))
    inner = edge.shrink(0.010, bottom=0, top=0)
    sides = [
        edge.with_(x=(edge.x.low, inner.x.low)),
        edge.with_(x=(inner.x.high, edge.x.high)),
        edge.with_(x=(inner.x.low - 0.0003, inner.x.high + 0.0003), y=(edge.y.low, inner.y.low)),
        edge.with_(x=(inner.x.low - 0.0003, inner.x.high + 0.0003), y=(inner.y.high, edge.y.high)),
    ]
    floor = inner.with_(z=(level + 0.0003, level + 0.012)).grow(0.0003, bottom=0, top=0).box()
    return ag.part([floor, *(side.box(bevel=0.0015) for side in sides)], "tray", _sheet(plan.panel))


def _sheet(panel: ag.Material) -> ag.Material:
    """Return the material of boards 12 mm thick; those of sheet metal are hollow."""
    return casting(panel, 0.12) if panel.density > 2600.0 else panel


def _bow(
    plan: _Plan, x: ag.Scalar, y: ag.Scalar, low: ag.Scalar, radius: float = _TUBE
) -> tuple[list[ag.Solid], ag.Frame]:
    """Make two posts and the bar between their tops, in a plane across x, and the grasp of the bar."""
    corners = [(x, -y, low), (x, -y, plan.high), (x, y, plan.high), (x, y, low)]
    ways = [(0, 0, 1), (0, 1, 0), (0, 0, -1)]
    solids = pulls.bent_bar(ag.circle(radius), corners, ways, bend=_BEND, halves=True, run=pulls.rod(radius))
    hold = ag.grasp_on(solids[1], approach=-ag.X, closing=ag.Z, at=(x, 0, plan.high), depth=radius)
    return solids, hold


def _service(plan: _Plan, trays: int) -> ag.Body:
    """Make a trolley with trays between four posts, pushed by a bow at the right."""
    low, top = plan.on, plan.high - 0.085
    levels = [low + (top - low) * number / (trays - 1) for number in range(trays)]
    y, x = plan.deep / 2 + _TUBE - 0.0012, plan.long / 2 - 0.045
    bow, hold = _bow(plan, x, y, low + 0.002)
    post = ag.cylinder_between((-x, y, low + 0.002), (-x, y, top + 0.046), _TUBE, bevel=0.003)
    grip = ag.cylinder(_TUBE + 0.0035, 0.36 * plan.deep, axis=ag.Y, bevel=0.003).at(x, 0, plan.high)
    body = ag.weld(
        ag.part(
            [*bow, post, post.mirror(ag.Y)],
            "frame",
            plan.tube,
            name="body",
            grasp=hold,
            grasp_width=2 * _TUBE + 0.01,
        ),
        ag.detail(grip, "handle", _BLACK),
        *(_tray(plan, level, rim=0.034) for level in levels),
    )
    return _casters(body, plan, low, fixed=False)


def _big_wheel(plan: _Plan, width: float, spokes: int) -> ag.Body:
    """Make a wheel about the y axis: a tyre on a rim, with a hub, and spokes or a disc."""
    radius = plan.wheel
    flat = width - 0.006  # the visible tyre has round shoulders
    tyre = ag.bounding_collider(
        ag.tube(radius, 0.78 * radius, flat, axis=ag.Y, bevel=0.0005), ag.cylinder(radius, flat, axis=ag.Y)
    )
    round_tyre = ag.tube(radius, 0.77 * radius, width, axis=ag.Y, bevel=ag.min_(0.3 * width, 0.09 * radius))
    hub = ag.cylinder(0.020, width + 0.010, axis=ag.Y, bevel=0.002)
    ring = ag.tube(0.80 * radius, 0.72 * radius, 0.7 * width, axis=ag.Y, bevel=0.001)
    bars: list[ag.Solid] = [ag.cylinder(0.74 * radius, 0.004, axis=ag.Y)]
    if spokes:
        bar = ag.cylinder_between((0, 0, 0.010), (0, 0, 0.76 * radius), 0.0032)
        bars = [bar.rotate(ag.Y, number * math.tau / spokes) for number in range(spokes)]
    rim = plan.frame if spokes else ag.colored("polypropylene", "black")
    hold = ag.grasp_on(tyre, approach=ag.X, closing=ag.Y, at=(0.012 - radius, 0, 0), depth=0.012)
    light = _RUBBER.with_(name="tyre_rubber", density=800.0)
    return ag.weld(
        ag.part(tyre, "wheel", light, name="wheel", grasp=hold),
        ag.detail([ring, hub, *bars], "wheel", rim),
        ag.detail(round_tyre, "wheel", light),
    )


def _drinks(plan: _Plan) -> ag.Body:
    """Make a trolley with two trays and railings, on two large wheels at the left and two casters."""
    small, low, top = 0.03, 0.225, plan.high - 0.075
    on = 2 * small + 0.0155
    x, y = plan.long / 2 - 0.030, plan.deep / 2 + _SLIM - 0.001
    bow, hold = _bow(plan, x, y, on + 0.010, _SLIM)
    post = ag.cylinder_between((-x, y, plan.wheel - 0.012), (-x, y, top + 0.066), _SLIM, bevel=0.002)
    knob = ag.sphere(0.013).at(-x, y, top + 0.070)
    foot = ag.box(0.052, 0.052, 0.012, bevel=0.002).at(x, y, on + 0.006)
    axle = ag.cylinder(0.006, 2 * y + 0.019, axis=ag.Y).at(-x, 0, plan.wheel)
    rails = []
    for level in (low, top):
        for side in (-1, 1):
            end = (x, side * y, level + 0.046)
            rails.append(ag.cylinder_between((-x, side * y, level + 0.046), end, 0.0045))
        rails.append(ag.cylinder_between((-x, -y, level + 0.046), (-x, y, level + 0.046), 0.0045))
    solids = [*bow, post, post.mirror(ag.Y), foot, foot.mirror(ag.Y), axle, knob, knob.mirror(ag.Y)]
    area = ag.Region.centered(plan.long - 0.03, plan.deep, 0.0)
    boards = [area.with_(z=(level, level + 0.014)).box(bevel=0.003) for level in (low, top)]
    body = ag.weld(
        ag.part(
            [*solids, *rails],
            "frame",
            casting(plan.frame, 0.35),
            name="body",
            grasp=hold,
            grasp_width=2 * _TUBE + 0.01,
        ),
        ag.part(boards, "tray", plan.panel),
    )
    for number, side in enumerate((-1, 1)):
        body = body.install(_caster(small).suffixed(f"_{number}"), at=(x, side * y, on))
    wide = 0.018
    wheel = _big_wheel(plan, wide, 10).at(-x, y + 0.024, plan.wheel)
    roll = ag.Revolute("wheel_roll", axis=ag.Y, pivot=(-x, y, plan.wheel), feel=feel.CASTER)
    return body.attach_pair(wheel, roll, normal=ag.Y)


def _tool(plan: _Plan, rows: int, friction: ag.Scalar) -> ag.Body:
    """Make a cabinet with drawers under a tray, with a bar at its right."""
    low, high, wall = plan.on, plan.high, 0.020
    shell = ag.Region.centered(plan.long, plan.deep, 0.0).with_(z=(low, high - 0.030))
    bay = shell.shrink(wall, front=0.0, back=0.015, bottom=0.028, top=0.024)
    panels = [
        shell.with_(x=(shell.x.low, bay.x.low)).box(bevel=0.003),
        shell.with_(x=(bay.x.high, shell.x.high)).box(bevel=0.003),
        bay.with_(y=(bay.y.high, shell.y.high - 0.0003)).grow(x=0.001).box(),
        bay.with_(z=(shell.z.low + 0.0003, bay.z.low), y=(shell.y.low + 0.0004, bay.y.high + 0.001))
        .grow(x=0.001)
        .box(),
        bay.with_(z=(bay.z.high, shell.z.high - 0.0003), y=(shell.y.low + 0.0004, bay.y.high + 0.001))
        .grow(x=0.001)
        .box(),
    ]
    sheet = plan.panel.with_(name=f"{plan.panel.name}_sheet", density=620.0)
    lid = _tray(plan, high - 0.031, rim=0.031)
    mat = ag.Region.centered(plan.long, plan.deep, 0.0).shrink(0.014, bottom=0, top=0)
    z = high - 0.12
    corners = [
        (0, -0.4 * plan.deep, 0),
        (0.060, -0.4 * plan.deep, 0),
        (0.060, 0.4 * plan.deep, 0),
        (0, 0.4 * plan.deep, 0),
    ]
    ways = [(1, 0, 0), (0, 1, 0), (-1, 0, 0)]
    bar = pulls.bent_bar(ag.circle(_TUBE), corners, ways, bend=0.03, halves=True, run=pulls.rod(_TUBE))
    solids = [solid.at(plan.long / 2 - 0.0008, 0, z) for solid in bar]
    hold = ag.grasp_on(solids[1], approach=-ag.X, closing=ag.Z, depth=_TUBE)
    body = ag.weld(
        ag.part(panels, "body", sheet, name="body"),
        lid,
        ag.detail(mat.with_(z=(high - 0.0195, high - 0.0175)).box(), "mat", _RUBBER),
        ag.part(solids, "handle", plan.tube, grasp=hold, grasp_width=2 * _TUBE + 0.01),
    )
    flat = bay.z.size / (rows + 0.9)
    for number, cell in enumerate(bay.stack(*[flat] * (rows - 1), None)):
        drawer = _drawer(cell, plan, named=number == 0)
        drag = feel.Feel(friction=friction, damping=10.0, effort=90.0)
        slide = ag.Prismatic("drawer_slide", axis=-ag.Y, limits=(0, 0.86 * cell.y.size), feel=drag)
        body = body.install(Fitting.moving(drawer, slide).suffixed(f"_{number}"))
    return _casters(body, plan, low, fixed=True).at(x=-0.018)  # a quarter of what the bar stands out


def _drawer(cell: ag.Region, plan: _Plan, *, named: bool) -> ag.Body:
    """Make a drawer with a pull along its upper edge."""
    face = cell.shrink(FIT.reveal, front=-0.001, back=0.0).with_(y=(cell.y.low - 0.001, cell.y.low + 0.014))
    room = cell.shrink(left=0.012, right=0.012, bottom=0.004, top=0.012, front=0.0138, back=0.006)
    inner = room.shrink(0.0020, front=0.0, top=0.0)
    lip = face.with_(y=(face.y.low - 0.013, face.y.low + 0.0004), z=(face.z.high - 0.016, face.z.high)).box(
        bevel=0.003
    )
    hold = ag.grasp_on(lip, approach=ag.Y, closing=ag.Z, depth=0.010)
    body = ag.weld(
        ag.part(face.box(bevel=0.0015), "front", casting(plan.panel, 0.10), name="drawer"),
        ag.part(furniture.open_box(room, inner), "drawer", casting(_STEEL, 0.45)),
        ag.part(lip, "handle", casting(ag.material("aluminium"), 0.4), grasp=hold),
    )
    if not named:
        return body
    at = face.anchor(x=0.72, y=-1, z=-0.25)
    return ag.weld(
        body, details.printed(details.logo(plan.maker, 0.011), at, material=controls.ink_on(plan.panel))
    )


def _platform(plan: _Plan, friction: ag.Scalar) -> ag.Body:
    """Make a platform with a bumper around it, and the handle that folds down onto it."""
    low, top = plan.on, plan.on + 0.034
    bed = ag.Region.centered(plan.long, plan.deep, 0.0).with_(z=(low, top))
    edge = bed.shrink(0.0, bottom=0.006, top=0.006).grow(0.010, bottom=0.0, top=0.0)
    bumper = ag.extrude(
        edge.plan(radius=0.018) - bed.shrink(0.002, bottom=0.0, top=0.0).plan(), edge.z.size, bevel=0.003
    )
    x, y, z = plan.long / 2 - 0.040, plan.deep / 2 - 0.060, top + 0.026
    bow, hold = _bow(plan, x, y, z)
    eyes = [
        ag.cylinder(_TUBE + 0.0045, 2 * _TUBE, axis=ag.Y, bevel=0.002).at(x, side * y, z) for side in (-1, 1)
    ]
    grip = ag.cylinder(_TUBE + 0.0035, 0.40 * plan.deep, axis=ag.Y, bevel=0.003).at(x, 0, plan.high)
    handle = ag.weld(
        ag.part([*bow, *eyes], "handle", plan.tube, name="handle", grasp=hold, grasp_width=2 * _TUBE + 0.01),
        ag.detail(grip, "handle", _BLACK),
    )
    apart = _TUBE + FIT.running + 0.003
    cheek = ag.hull(
        ag.box(0.060, 0.006, 0.004).at(x, 0, top + 0.0015), ag.cylinder(0.014, 0.006, axis=ag.Y).at(x, 0, z)
    )
    cheeks = [cheek.at(y=side * y + way * apart) for side in (-1, 1) for way in (-1, 1)]
    board = plan.panel.with_(name=f"{plan.panel.name}_bed", density=480.0)
    body = ag.weld(
        ag.part(bed.box(bevel=0.004), "body", board, name="body"),
        ag.part(cheeks, "bracket", plan.frame),
        ag.detail(bumper.at(z=(low + top) / 2), "bumper", _RUBBER),
    )
    mark = details.logo(plan.maker, 0.024)
    ink = controls.ink_on(plan.panel)
    body = ag.weld(body, details.printed(mark, (-0.05, 0, top), facing=ag.Z, up=-ag.X, material=ink))
    fold = ag.Revolute(
        "handle_fold", axis=-ag.Y, pivot=(x, 0, z), limits=(0, math.pi / 2),
        feel=feel.Feel(friction=friction, damping=0.4, effort=80.0),
    )  # fmt: skip
    return _casters(body.attach(handle, fold), plan, low, fixed=True)


def _truck(plan: _Plan, friction: ag.Scalar) -> ag.Body:
    """Make an upright hand truck on its toe and two wheels behind it."""
    x, wide = plan.long / 2 - 0.055, 0.055
    behind = 0.72 * plan.wheel + 0.020  # of the axle
    corners = [(-x, 0, 0.022), (-x, 0, plan.high), (x, 0, plan.high), (x, 0, 0.022)]
    ways = [(0, 0, 1), (1, 0, 0), (0, 0, -1)]
    tube = 0.0150
    loop = pulls.bent_bar(ag.circle(tube), corners, ways, bend=0.05, halves=True, run=pulls.rod(tube))
    hold = ag.grasp_on(loop[1], approach=-ag.Z, closing=ag.Y, at=(0, 0, plan.high), depth=tube)
    bars = [
        ag.Region((-x, x), (-0.006, 0.006), (share * plan.high - 0.016, share * plan.high + 0.016)).box(
            bevel=0.003
        )
        for share in (0.06, 0.28, 0.50, 0.72)
    ]
    bars.append(
        ag.Region((-0.016, 0.016), (-0.0055, 0.0055), (0.05 * plan.high, 0.73 * plan.high)).box(bevel=0.002)
    )
    stay = ag.hull(
        ag.box(0.005, 0.006, 0.30).at(x, 0.010, 0.19),
        ag.cylinder(0.018, 0.005, axis=ag.X).at(x, behind, plan.wheel),
    )
    out = x + 0.019 + wide / 2
    axle = ag.cylinder(0.009, 2 * out - wide - 0.0012, axis=ag.X).at(0, behind, plan.wheel)
    pivot = (0, -0.0265, 0.012)
    barrels = [
        ag.cylinder(0.0085, 0.07, axis=ag.X, bevel=0.001).at(side * 0.62 * x, *pivot[1:]) for side in (-1, 1)
    ]
    arms = [
        ag.Region((-0.03, 0.03), (-0.020, 0.004), (0.008, 0.026)).box().at(x=side * 0.62 * x)
        for side in (-1, 1)
    ]
    foot = ag.Region((-x - tube, x + tube), (-0.012, 0.012), (0.0235, 0.0475)).box(bevel=0.002)
    grip = ag.cylinder(tube + 0.0035, 0.62 * plan.long, axis=ag.X, bevel=0.003).at(0, 0, plan.high)
    body = ag.weld(
        ag.part(
            [*loop, *bars, foot],
            "frame",
            casting(plan.frame, 0.32),
            name="body",
            grasp=hold,
            grasp_width=2 * tube + 0.012,
        ),
        ag.part([stay, stay.mirror(ag.X)], "bracket", plan.frame),
        ag.part([axle, *barrels, *arms], "axle", _STEEL),
        ag.detail(grip, "handle", _BLACK),
    )
    plate = ag.Region((-x - 0.02, x + 0.02), (-0.035 - plan.deep, -0.0365), (0.0, 0.006))
    middle = ag.cylinder(0.0085, 0.62 * x, axis=ag.X, bevel=0.001).at(*pivot)
    tongue = ag.Region((-0.29 * x, 0.29 * x), (-0.0375, -0.0265), (0.0035, 0.0115)).box()
    rib = ag.Region((-0.006, 0.006), (-0.03 - 0.9 * plan.deep, -0.055), (0.0055, 0.024)).box(bevel=0.002)
    pinch = ag.grasp_on(rib, approach=-ag.Z, closing=ag.X, depth=0.014)
    toe = ag.part(
        [plate.box(bevel=0.002), middle, tongue, rib],
        "toe",
        casting(plan.panel, 0.6),
        name="toe",
        grasp=pinch,
        grasp_width=0.022,
    )
    fold = ag.Revolute(
        "toe_fold", axis=-ag.X, pivot=pivot, limits=(0, 1.5),
        feel=feel.Feel(friction=0.3 * friction, damping=0.2, effort=60.0),
    )  # fmt: skip
    wheel = _big_wheel(plan, wide, 0).rotate(ag.Z, -math.pi / 2).at(out, behind, plan.wheel)
    roll = ag.Revolute("wheel_roll", axis=ag.X, pivot=(out, behind, plan.wheel), feel=feel.CASTER)
    return body.attach(toe, fold).attach_pair(wheel, roll)
