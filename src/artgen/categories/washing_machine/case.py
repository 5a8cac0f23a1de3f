"""The case of a washing machine or a dryer: sheets, base, back, console, drawer and kick plate."""

from collections.abc import Sequence

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, cord_stub, drain_hose, filled, inlet_hose
from artgen.categories.shared.fixings import feet, screws
from artgen.categories.shared.shelves import open_box
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import FIT, Fitting

SKIN = 0.014
"""Thickness of the front panel with its folded edges [m]."""

LAP = FIT.lap
ZINC = ag.material("zinc")
GREY = ag.colored("polypropylene", "light_grey")

_SHEET = 0.004  # modeled thickness of sheet steel [m]
_FOOT = 0.014  # height of the feet [m]
_REVEAL = 0.0016  # joint between front, console, drawer and kick plate [m]
_BEHIND = 0.030  # depth of the recess for hoses at the back [m]
_PITCH = 0.0215  # distance between buttons: a finger 18 mm wide does not touch the neighbors [m]
_CROWDED = "dials, display and buttons need a wider console: fewer dials or buttons, or show=''"
_ICONS = ("power", "thermometer", "spin", "rinse", "timer", "child_lock", "leaf", "start_pause")
_BLACK = ag.material("black_abs")
_TRAY = GREY.with_(name="tray_plastic")
_FLAP = feel.Feel(damping=0.004, friction=0.03, armature=1e-4, effort=2.0)


class Plan:
    """The regions of a machine that loads at the front; without a drawer, its width is 0."""

    def __init__(self, outside: ag.Region, *, console: ag.Scalar, top: float, drawer: float) -> None:
        kick = 0.100  # height of the upper edge of the kick plate [m]
        self.outside = outside
        self.top = outside.with_(z=(outside.z.high - top, outside.z.high))
        front = outside.shrink(x=0.001).deep(SKIN, None)[0]
        upper, rest = front.shrink(top=top + _REVEAL).stack(console, None, gap=_REVEAL)
        self.panel, low = rest.stack(None, kick, gap=_REVEAL)
        self.kick = low.with_(z=(0.012, kick))
        self.tray, self.console = upper.across(drawer, None, gap=_REVEAL)
        self.center = self.panel.z.mid


def sheets(plan: ag.Region, finish: ag.Material, *, front: ag.Scalar, high: ag.Scalar) -> ag.Body:
    """Make the sides from behind the front panel to the back, up to a height, and the back panel."""
    rear = plan.y.high
    whole = plan.with_(y=(front - LAP, rear), z=(0.022, high))
    left, _, right = whole.across(_SHEET, None, _SHEET)
    back = whole.shrink(x=_SHEET - LAP).with_(y=(rear - _BEHIND - _SHEET, rear - _BEHIND))
    return ag.weld(
        ag.part([left.box(bevel=0.0012), right.box(bevel=0.0012)], "body", filled(finish, 2300.0, "sheet")),
        ag.part(back.box(), "body", filled(ZINC, 1500.0, "back")),
    )


def base(plan: ag.Region, high: ag.Scalar, front: ag.Scalar, density: float) -> ag.Body:
    """Make the base with pump, motor and ballast up to a height, of a density [kg/m3], on four feet."""
    pan = plan.shrink(x=_SHEET - LAP).with_(y=(front, plan.y.high - _BEHIND - 0.001), z=(_FOOT, high))
    at = [(x, y) for x in plan.shrink(0.048).x for y in plan.shrink(0.052).y]
    block = ag.part(pan.box(bevel=0.003), "base", _BLACK.with_(name="ballast", density=density))
    return ag.weld(block, feet(at, radius=0.022, height=_FOOT, finish=_BLACK))


def back(plan: ag.Region, maker: str, model: str, *, low: ag.Scalar, vented: bool) -> ag.Body:
    """Make hoses or the outlet of air, transport bolts, rating plate and cord on the back panel."""
    y, half = plan.y.high - _BEHIND, plan.x.high
    cover = ag.cylinder(0.10, 0.006, axis=ag.Y, bevel=0.002).at(0, y + 0.002, low + 0.30)
    heads = [(side * (half - 0.02), y, z) for side in (-1, 1) for z in (0.08, low + 0.3, plan.z.high - 0.08)]
    plate = (0.6 * half, y, ag.min_(low + 0.50, plan.z.high - 0.075))
    made = [
        cord_stub(height=low + 0.10, reach=0.026).at(-0.6 * half, y, low + 0.10),
        details.rating_plate(0.08, 0.05, (maker.upper(), model), at=plate, facing=ag.Y),
        ag.detail(cover, "body", ZINC),
        *screws(heads, facing="+y", radius=0.0036, finish=ZINC, head="pan"),
    ]
    if vented:
        pipe = ag.tube(0.051, 0.049, 0.018, axis=ag.Y).at(-0.1, y + 0.009, 0.13)
        return ag.weld(*made, ag.detail(pipe, "vent", ZINC))
    return ag.weld(
        *made,
        inlet_hose().at(0.72 * half, y, plan.z.high - 0.46),
        drain_hose().at(-0.3 * half, y, low + 0.02),
    )


def console(
    place: ag.Region,
    finish: ag.Material,
    pane: ag.Material | None,
    dials: Sequence[Fitting],
    keys: tuple[int, controls.ButtonShape, ag.Material, ag.Scalar],
    screen: tuple[str, Color],
    maker: str,
) -> ag.Body:
    """Make the console about the middle of its face: dials, display, buttons of count, shape, cap, force."""
    place = place.at(-place.x.mid, -place.y.low, -place.z.mid)
    (show, color), (count, shape, cap, force) = screen, keys
    zones = place.shrink(x=0.014).across(0.096 * len(dials), 0.092 if show else 0.0, None, gap=0.006)
    left, middle, right = (each.x for each in zones)
    # at most 12 mm of a row stand out at either end of its zone, before they reach the display or the side
    fits = right.size + 0.024 > (count - 1) * _PITCH + 0.0155
    row = controls.ButtonRow(count, shape, _PITCH, ag.require(right.mid, fits, _CROWDED))
    ink = controls.ink_on(pane or finish)
    channel, high, over = row.channel(place), row.size[1], -controls.PANE
    behind = channel.grow(LAP).with_(y=(controls.CAP_DEEP + 0.0042, place.y.high))
    boards = [each.box() for each in (*place.around(channel, lap=LAP), behind)]
    face, icons = place.shrink(0.003 if pane else 0.0), (*_ICONS[: count - 1], _ICONS[-1])
    body = ag.weld(
        ag.part(boards, "panel", finish.with_(name=f"{finish.name}_panel", density=420.0)),
        controls.inlay(face.x.size, face.z.size, finish=pane or finish, holes=row.holes),
        controls.icon_row(icons, row.at, height=0.009, level=high / 2 + 0.012, ink=ink),
        controls.lamp_row(row.at, level=-high / 2 - 0.008, lit=1),
    )
    if show:
        body = ag.weld(body, details.display(show, 0.080, 0.030, at=(middle.mid, over, 0.004), color=color))
    if maker:
        at = (right.mid, over, -0.30 * place.z.size)
        body = ag.weld(body, details.printed(details.logo(maker, 0.0075), at, material=ink))
    body = row.install(body, cap, proud=0.0042, travel=0.0022, force=force, preload=0.5)
    for number, dial in enumerate(dials):
        at = (left.at((number + 0.5) / len(dials)), over, 0)
        body = body.install(dial.suffixed(f"_{number}") if len(dials) > 1 else dial, at=at)
    return body


def _gripped(
    name: str, front: ag.Region, ridge: ag.Region, finish: ag.Material, depth: float, *, upright: bool = False
) -> ag.Body:
    """Make the front of a drawer or a flap with a ridge as its grip, level or upright."""
    grip = ag.bounding_collider(ridge.box(bevel=0.0025), ridge.box())
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X if upright else ag.Z, depth=depth)
    boards, width = [front.box(bevel=0.0015), grip], (ridge.x if upright else ridge.z).size + 0.010
    return ag.part(boards, name, finish, grasp=hold, grasp_width=width, name=name)


def drawer(plan: Plan, finish: ag.Material, *, tank: bool, friction: ag.Scalar) -> ag.Body:
    """Make the housing of the drawer, and the drawer in it: for detergent, or a tank for water."""
    front, long = plan.tray.shrink(back=0.0012), 0.46 * plan.outside.y.size
    inner = front.shrink(x=0.010, top=0.010, bottom=0.016).with_(y=(front.y.high - LAP, front.y.low + long))
    room = inner.grow(x=0.0075, bottom=0.0052, top=0.0022, back=0.015).shrink(front=SKIN / 2)
    housing = ag.detail(open_box(*room.size, wall=0.003)[1:], "drawer_housing", _TRAY)
    housing = housing.at(room.x.mid, room.y.low, room.z.low)
    ridge = ag.Region.centered(front.x.size - 0.03, 0.021, 0.011)
    ridge = ridge.at(front.x.mid, front.y.low - 0.0095, front.z.low + 0.020)
    bodies = [_gripped("drawer", front, ridge, filled(finish, 700.0, "front"), 0.0185)]
    walls = []
    if tank:
        walls.append(inner.shrink(x=LAP).with_(z=(inner.z.high - 0.003, inner.z.high)))
        mouth = ag.cylinder(0.018, 0.004, bevel=0.001).at(inner.x.mid, inner.y.low + 0.05, inner.z.high)
        bodies.append(ag.detail(mouth, "drawer", ag.colored("abs", "slate")))
    else:
        x = [inner.x.at(share) for share in (0.36, 0.70)]
        walls += [inner.shrink(top=0.006).with_(x=(each - 0.0012, each + 0.0012)) for each in x]
        siphon = inner.shrink(front=0.06, back=0.02).with_(x=(x[0] - 0.001, x[1] + 0.001))
        siphon = siphon.with_(z=(inner.z.high - 0.016, inner.z.high - 0.006))
        bodies.append(ag.detail(siphon.box(bevel=0.003), "drawer", ag.colored("abs", "sky")))
        signs = [
            details.lettering(["I"], 0.008),
            details.icon("star", 0.011),
            details.lettering(["II"], 0.008),
        ]
        for share, sign in zip((0.18, 0.5, 0.82), signs, strict=True):
            at = (front.x.at(share), front.y.low, front.z.at(0.62))
            bodies.append(details.printed(sign, at, material=controls.ink_on(finish)))
    box = [each.at(inner.x.mid, inner.y.low, inner.z.low) for each in open_box(*inner.size, wall=0.003)]
    box += [each.box() for each in walls]
    bodies.append(ag.part(box, "drawer", _TRAY.with_(name="drawer_plastic")))
    slide = ag.Prismatic(
        "drawer_slide", axis=-ag.Y, limits=(0, 0.80 * long), feel=feel.RUNNER, friction=friction
    )
    return housing.attach(ag.weld(*bodies), slide)


def kick_plate(plan: Plan, finish: ag.Material, flap: str) -> ag.Body:
    """Make the kick plate, and the flap before the filter of the pump, hinged at its lower edge."""
    plate, stuff = plan.kick.shrink(front=0.003), filled(finish, 900.0)
    if not flap:
        slots = details.vent_slots(0.6 * plate.x.size, 0.014, 16, slot=0.0035)
        vent = details.relief(slots, plate.anchor(y=-1), proud=0.0003)
        return ag.weld(ag.part(plate.box(bevel=0.002), "kick_plate", stuff), ag.detail(vent, "vent", DARK))
    x = (plate.x.high - 0.105) * (1 if flap == "right" else -1)
    hole = plate.shrink(z=0.010).with_(x=(x - 0.070, x + 0.070))
    leaf = hole.shrink(x=0.0015, z=0.0022).deep(0.006, None)[0]
    ridge = ag.Region.centered(0.008, 0.013, 0.034).at(x, leaf.y.low - 0.0055, leaf.z.high - 0.024)
    niche = hole.grow(LAP).with_(y=(plate.y.high - 0.001, plate.y.high + 0.002))
    y, z = plate.y.high, hole.z.mid
    cap = ag.cylinder(0.026, 0.006, axis=ag.Y, bevel=0.002).at(x + 0.012, y - 0.0005, z)
    bar = ag.box(0.042, 0.004, 0.008, bevel=0.001).at(x + 0.012, y - 0.0022, z)
    hose = ag.cylinder(0.007, 0.006, axis=ag.Y, bevel=0.001).at(x - 0.042, y - 0.001, z)
    body = ag.weld(
        ag.part([each.box(bevel=0.0006) for each in plate.around(hole, lap=LAP)], "kick_plate", stuff),
        ag.part(niche.box(), "kick_plate", DARK),
        ag.detail([cap, bar], "filter", _TRAY),
        ag.detail(hose, "filter", _BLACK),
    )
    at = (x, leaf.y.mid, leaf.z.low + 0.004)
    hinge = ag.Revolute("flap_hinge", axis=ag.X, pivot=at, limits=(0, 1.35), feel=_FLAP)
    # a hand at an upright grip is clear of the floor
    return body.attach(_gripped("filter_flap", leaf, ridge, stuff, 0.0115, upright=True), hinge)
