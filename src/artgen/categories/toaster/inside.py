"""The inside of a toaster: chamber, carriages with their levers, and the crumb tray."""

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

import artgen as ag
from artgen import feel
from artgen.categories.toaster.plan import Plan
from artgen.nodes.fitting import Fitting

ARM = (0.003, 0.010)
"""Width and height of the arm between a lever and its carriage [m]."""

_MICA = 0.0085  # distance from the side of a slot to its sheet of mica [m]
_WALL = 0.0015  # thickness of the walls [m]
_GAP = 0.006  # half of the gap in the front wall for a carriage [m]
_GUIDE = 0.0009  # radius of the guide wires [m]
_RIBBONS = 9  # number of heating ribbons on a sheet
_STEEL = ag.material("steel")
_STAINLESS = ag.material("stainless")
_PRESSED_MICA = ag.material("mdf").with_(  # with air gaps
    name="mica", base_color=(0.36, 0.30, 0.21), specular_roughness=0.4, density=500.0, texture=""
)
OXIDIZED = _STEEL.with_(
    name="heating_wire", base_color=(0.20, 0.11, 0.08), specular_roughness=0.45, texture=""
)


def _along(solid: ag.Solid, count: int, length: ag.Scalar) -> ag.Solid:
    """Repeat a solid along the slots over a length."""
    return ag.array(solid, at=ag.row((0, 0, 0), (0, length / (count - 1), 0), count))


def _beside(wall: ag.Region, gaps: Sequence[ag.Span]) -> list[ag.Solid]:
    """Make the boards of a wall beside and between gaps along x."""
    edges = [wall.x.low, *(edge for gap in gaps for edge in gap), wall.x.high]
    return [wall.with_(x=span).box() for span in zip(edges[::2], edges[1::2], strict=True)]


def _at_sides(solid: ag.Solid, plan: Plan, distance: float) -> ag.Solid:
    """Repeat a solid at x = 0 at a distance from both sides of each slot."""
    return ag.array(solid, at=[(x, 0, 0) for slot in plan.slots for x in slot.grow(distance).x])


def chamber(plan: Plan) -> ag.Body:
    """Make the chamber around the slots, with the guides of the bread, which are visual but for a rod."""
    room, body = plan.chamber, plan.body
    low, tall = room.z.low, room.z.size
    channels = [slot.grow(_MICA - 0.0005).x for slot in plan.slots]
    mica = room.grow(y=0.001).with_(x=(channels[0].low - 0.001, channels[-1].high + 0.001))
    walls = room.grow(x=_MICA + 0.0006)  # within the bevels of a classic body
    back = walls.with_(y=(room.y.high, room.y.high + _WALL)).box()
    front = walls.with_(y=(room.y.low - _WALL, room.y.low))
    boards = _beside(front, [(slot.x.mid - _GAP, slot.x.mid + _GAP) for slot in plan.slots])
    ribbon = ag.box(0.0006, room.y.size - 0.016, 0.0024).at(0, room.y.mid, low + 0.012)
    ribbons = ag.array(ribbon, at=ag.row((0, 0, 0), (0, 0, (tall - 0.030) / (_RIBBONS - 1)), _RIBBONS))
    wire = ag.cylinder(_GUIDE, tall - 0.004).at(0, room.y.low + 0.008, room.z.mid + 0.002)
    level = room.z.at(0.4)
    rod = ag.cylinder_between((0, room.y.low - 0.001, level), (0, room.y.high + 0.001, level), _GUIDE)
    wires = _along(wire, plan.wires, room.y.size - 0.016)
    liner = ag.box(body.x.size - 0.044, body.y.size - plan.form.front - 0.018, 0.0006)
    return ag.weld(
        ag.part(ag.union(back, *boards), "chamber", _STAINLESS.with_(name="chamber_steel", density=3500.0)),
        ag.part(ag.union(*_beside(mica, channels)), "heating_element", _PRESSED_MICA),
        ag.detail(_at_sides(ribbons, plan, _MICA - 0.0007), "heating_element", OXIDIZED),
        ag.part(_at_sides(rod, plan, _GUIDE), "guide_wire", _STAINLESS),
        ag.detail(_at_sides(wires, plan, _GUIDE), "guide_wire", _STAINLESS),
        ag.detail(
            liner.at(z=plan.floor + 0.0001),
            "chamber",
            _STAINLESS.with_(name="liner", base_color=(0.33, 0.33, 0.33)),
        ),
    )


LeverStyle = Literal["tab", "bar", "ball", "tee", "paddle"]
"""A flat tab, a round crossbar, a ball, a square bar on a neck, or a wide paddle."""


class _Block(NamedTuple):
    """A lever of a block with a bright line on its front; lengths in m."""

    wide: tuple[float, float]  # width, and that of a slim lever
    deep: float  # depth
    high: float  # height
    bevel: float
    gap: float  # distance from the plane of the levers
    line: tuple[float, float]  # width of the line, and that of a slim lever
    thick: float  # height of the line


_BLOCKS: dict[LeverStyle, _Block] = {
    "tab": _Block((0.030, 0.024), 0.021, 0.0085, 0.003, 0.0, (0.012, 0.012), 0.0024),
    "tee": _Block((0.048, 0.02976), 0.0115, 0.0125, 0.0028, 0.00975, (0.030, 0.0186), 0.0022),
    "paddle": _Block((0.062, 0.03472), 0.0195, 0.0115, 0.0042, 0.0, (0.026, 0.026), 0.0018),
}
_NECKS: dict[LeverStyle, float] = {"bar": 0.010, "ball": 0.008, "tee": 0.015}  # lengths of round necks [m]
_OUT = 0.0095  # distance from the panel to a lever, clear of the buttons [m]
_PRONGS = 0.016  # width of the prongs under the bread [m]
_BAR = 0.0030  # thickness of the bars of a carriage [m]
_LOW = 0.0185  # height of a carriage above the floor of the sleeve, over the crumb tray [m]
_ENDS = 0.004  # distance from a carriage to the ends of its slot [m]


def lever(style: LeverStyle, finish: ag.Material, accent: ag.Material, *, slim: bool, name: str) -> ag.Body:
    """Make the grip that a hand presses down, about the arm, in front of the panel."""
    bodies: list[ag.Body] = []
    if style in _BLOCKS:
        block = _BLOCKS[style]
        front = -_OUT - block.gap - block.deep
        held = ag.box(block.wide[slim], block.deep, block.high, bevel=block.bevel)
        held = held.at(y=front + block.deep / 2)
        line = ag.box(block.line[slim], 0.0010, block.thick, bevel=0.0003).at(y=front)
        bodies.append(ag.detail(line, "lever", accent))
    elif style == "bar":
        long, y = (0.031 if slim else 0.050), -_OUT - 0.0128
        held = ag.cylinder(0.0068, long, axis=ag.X, bevel=0.0018).at(y=y)
        cuff = ag.cylinder(0.0071, 0.0022, axis=ag.X, bevel=0.0004)
        cuffs = ag.array(cuff, at=[(side * 0.38 * long, y, 0) for side in (-1, 1)])
        bodies.append(ag.detail(cuffs, "lever", accent))
    else:
        held = ag.sphere(0.0118).at(y=-_OUT - 0.0135)
    if style in _NECKS:
        length = _NECKS[style]
        neck = ag.cylinder(0.0042, length, axis=ag.Y, bevel=0.0008).at(y=0.003 - _OUT - length / 2)
        bodies.append(ag.part(neck, "lever", accent))
    hold, press = ag.grasp_on(held, approach=ag.Y, closing=ag.X), ag.push_on(held, direction=-ag.Z)
    return ag.weld(ag.part(held, "lever", finish, name=name, grasp=hold, push=press), *bodies)


def lever_slide(name: str, travel: ag.Scalar, force: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
    """Make the joint of a lever; positive moves it down, and the spring returns it.

    The spring of a toaster lifts the carriage with bread (about 0.15 kg), and needs 10-25 N at the bottom.
    """
    spring = ag.Spring(preload=0.42 * force, force=force)  # 4-10 N, more than the weight of 1-3 N
    # friction of the carriage on its guide rod, and inertia of the spring
    drag = feel.Feel(damping=damping, friction=0.4, armature=0.02, effort=45.0)
    return ag.Prismatic(name, axis=-ag.Z, limits=(0.0, travel), spring=spring, feel=drag)


def carriage(
    plan: Plan,
    slots: Sequence[ag.Region],
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar],
    travel: ag.Scalar,
    *,
    turned: bool,
) -> ag.Body:
    """Make the carriage of some slots at rest, and its arm through the panel at a point.

    With its panel on a broad side, the slots and the carriage are turned by 90 degrees, but not the arm.
    """
    x, plane, height = at
    begin, end = slots[0].y.low, slots[0].y.high - _ENDS
    post, reach = (slots[0].x.mid, slots[0].x.mid) if turned else (x, plan.bay)
    level = plan.floor + _LOW + _BAR / 2 + travel
    upright = ag.box(0.014, _BAR, height - level + 0.010)
    upright = upright.at(post, plan.bay, (height + level) / 2 + 0.0035)
    span = (ag.min_(slots[0].x.mid, post) - 0.004, ag.max_(slots[-1].x.mid, post) + 0.004)
    middle = (level - 0.0012, level + 0.0062)
    cross = ag.Region.centered(0, _BAR - 0.0006, 0).at(y=plan.bay).with_(x=span, z=middle).box()
    rail = ag.Region((-_BAR / 2, _BAR / 2), (plan.bay, end), (level - 0.0015, level + 0.0045)).box()
    first = begin + _ENDS + 0.002
    prong = ag.capsule(0.0012, _PRONGS, axis=ag.X).at(0, first, level + 0.0045)
    prongs = _along(prong, plan.wires, end - 0.002 - first)
    middles = [(slot.x.mid, 0, 0) for slot in slots]
    rack = ag.weld(
        ag.part(upright | cross, "carriage", _STEEL),
        ag.part(ag.array(rail, at=middles), "carriage", _STEEL),
        ag.part(ag.array(prongs, at=middles), "carriage", _STEEL),
    )
    near = plane - _OUT - 0.0012  # clear of a finger on the middle of a flat lever
    arm = ag.Region.centered(ARM[0], 0, ARM[1]).at(x, 0, height).with_(y=(near, reach))
    bar = ag.part(arm.box(bevel=0.0008), "carriage", _STEEL)
    return ag.weld(bar, rack.rotate(ag.Z, math.pi / 2) if turned else rack)


TrayWay = Literal["back", "side"]
"""Direction of the tray: out at the end of the slots, or across them."""

_SHEET = 0.0012  # thickness of the tray [m]
_RIM = 0.0075  # height of the rim of the tray [m]
_LIFT = 0.0012  # height of the tray above the floor of the sleeve [m]
_PLAY = 0.0014  # gap around the tray in its opening [m]
_FACE = 0.003  # thickness of the face of the tray [m]
_TAB = (0.032, 0.024, 0.0046)  # width, length and thickness of the tab [m]


def crumb_tray(plan: Plan, way: TrayWay, finish: ag.Material, friction: ag.Scalar) -> Fitting:
    """Make the crumb tray with its opening; positive pulls it out, along +y before its turn to the side."""
    room, low = plan.chamber, plan.floor + _LIFT
    space = room.grow(x=0.003).with_(y=(room.y.low + 0.004, plan.body.y.high))
    if way == "side":
        across = (0.004 - room.y.high, -0.004 - room.y.low)
        space = space.with_(x=across, y=(room.x.low - 0.004, plan.body.x.high))
    tray, out = space.with_(z=(low, low + _RIM)), space.y.high
    hole = tray.grow(x=_PLAY, top=_PLAY, bottom=_LIFT - 0.0002).with_(y=(out - 0.02, out + 0.02))
    # sheets end inside each other, so that no two faces are coplanar
    floor = tray.shrink(_SHEET / 2).with_(z=(low + 0.2 * _SHEET, low + 1.2 * _SHEET))
    rear = tray.shrink(x=_SHEET / 2, z=0.0003).with_(y=(tray.y.low + 0.1 * _SHEET, tray.y.low + 1.1 * _SHEET))
    left, _, right = tray.across(_SHEET, None, _SHEET)
    face = tray.grow(x=0.007).with_(
        y=(out + 0.001, out + 0.001 + _FACE), z=(plan.body.z.low + 0.0005, low + _RIM + 0.005)
    )
    # a web connects the face to the tray, through the opening
    web = tray.shrink(x=0.002, z=0.0005).with_(y=(out - 0.002, out + 0.002))
    wide, long, thick = _TAB
    tip = (tray.x.mid, face.y.mid + long, face.z.mid)
    tab = ag.box(*_TAB, bevel=0.0018).at(tip).at(y=-long / 2)
    rib = ag.box(wide - 0.006, 0.0035, thick + 0.0035, bevel=0.0014).at(tip).at(0, -0.0035, 0.001)
    # a hand comes at 45 degrees from above, so that it stays above the counter
    closing = ag.X if way == "back" else -ag.X  # turned to the side, this is +y
    hold = ag.frame((tip[0], tip[1] - 0.0062, tip[2]), approach=(0, -1, -1), closing=closing)
    tin = _STAINLESS.with_(name="tray_tin", density=4000.0)
    sheets = ag.union(*(each.box() for each in (floor, left, right, rear)))
    body = ag.weld(
        ag.part(sheets, "crumb_tray", tin, name="crumb_tray"),
        ag.part([web.box(), face.box(bevel=0.0012)], "crumb_tray", finish),
        ag.part(tab, "crumb_tray", finish, grasp=hold, name="crumb_tray"),
        ag.part(rib, "crumb_tray", finish),
    )
    drag = feel.Feel(friction=friction, damping=2.0, effort=20.0)
    slide = ag.Prismatic("crumb_tray_slide", axis=ag.Y, limits=(0.0, 0.8 * tray.y.size), feel=drag)
    fitting = Fitting.moving(body, slide, cut=hole.box())
    return fitting if way == "back" else fitting.rotate(ag.Z, -math.pi / 2)
