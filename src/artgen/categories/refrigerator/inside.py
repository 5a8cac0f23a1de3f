"""The inside of a refrigerator: cells with shelves and drawers, light and control, and an ice box."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details, feel
from artgen.categories.refrigerator.doors import Finish
from artgen.categories.refrigerator.plan import CHEEK, HAND, HUMP_DEEP, HUMP_HIGH, LIGHT, Cell, Leaf
from artgen.categories.shared.appliances import CLEAR, DARK, FROSTED, LINER, filled
from artgen.categories.shared.shelves import LIP_REACH, drawer_box, egg_tray, glass_shelf, wire_shelf
from artgen.nodes.fitting import Fitting

ShelfKind = Literal["glass", "wire"]

_SLACK = 0.012  # travel of a drawer until it strikes the ridges or the flat inside of its closed door [m]
_NO_MORE = 0.002  # difference between this travel and the declared free travel of a drawer [m]
_PLAY = 0.003  # gap around a drawer [m]
_FLOOR = 0.004  # gap under a drawer [m]
_OVER = 0.014  # gap from one row of drawers to the next, or to the shelf above [m]
_BARE = 0.10  # additional height under the lowest shelf without drawers, above the even spacing [m]
_SHELF_SHY = 0.008  # gap between the ridges of a door and the shelves [m]
_DUCT = 0.014  # depth of the air duct on the rear of a cell [m]
_HOLLOW = 220.0  # density of the duct and the housing of the light [kg/m3]
_ICE_HIGH = 0.170  # height of an ice box, from the underside of its floor to the ceiling [m]
_ICE_FLOOR = 0.024  # thickness of its floor [m]
_FLAP = 0.016  # thickness of its flap [m]
_FLAP_INSET = 0.062  # distance from the side of the cell to the hinge edge of the flap [m]
_HINGE = feel.Feel(friction=1.2, damping=0.1, effort=20)


class Slot(NamedTuple):
    """Space of a drawer behind a door."""

    space: ag.Region
    lip: ag.Scalar  # height of the lip above the underside [m]
    sides: tuple[int, ...]  # the halves of the cell that contain the drawer: -1 the left half, 1 the right
    finish: ag.Material


class Room(NamedTuple):
    """A furnished cell."""

    bodies: list[ag.Body]  # parts that are welded to the cabinet
    slots: list[Slot]  # spaces of the drawers
    front: ag.Scalar  # position of the front of the drawers along y [m]
    spread: ag.Scalar  # distance from shelf to shelf [m]
    lamp: ag.Material | None  # lens of its lamp


def furnish(
    cell: Cell,
    leaf: Leaf,  # a door in front of it
    finish: Finish,
    drawers: Sequence[int],  # numbers of drawers side by side in each row, from below
    drawer_height: ag.Scalar | None,  # height of each drawer; None to fill the cell [m]
    shelves: int,  # number of shelves above the drawers
    kind: ShelfKind,
    *,
    iced: bool = False,
    eggs: bool = False,
    control: Literal["dial", "touch", "none"] = "none",
    show: str = "",
) -> Room:
    """Furnish a cell with drawers, shelves, an ice box, an egg tray, and a control with a display."""
    face, ridge, trim, liner = leaf.board.y.high, leaf.ridge, finish.trim, finish.liner
    front = face + _SLACK + LIP_REACH + (0 if ridge is None else ridge)
    shelf_front = cell.y.low + 0.02 if ridge is None else face + ridge + _SHELF_SHY
    high, low = cell.z.high, cell.z.low + _BARE
    if drawer_height is None:
        pitch = cell.z.size / max(len(drawers), 1) - 0.004
        height = pitch - 0.012
        lip = 0.45 * height  # space for a hand between the door above and the floor
    else:
        height, pitch, lip = drawer_height, drawer_height + _OVER, drawer_height - 0.034
    clear = FROSTED if leaf.label == "freezer_door" else CLEAR
    slots, rails = [], []
    for number, count in enumerate(drawers):
        base = cell.z.low + number * pitch + _FLOOR
        row = cell.with_(y=(front, cell.y.high - 0.012), z=(base, base + height))
        found, cheeks = _row(cell, row, count, lip, clear)
        slots += found
        rails += cheeks
    bodies = [ag.part(rails, "rail", filled(liner, 160))] if rails else []
    if iced:
        bodies += _ice_box(cell, front, liner)
        high = high - _ICE_HIGH
    if drawers and drawer_height is not None:
        low = cell.z.low + len(drawers) * pitch + 0.008
        bodies.append(_shelves(cell, "glass", [low], front - 0.012, trim))
    spread = (high - low) / (shelves + 1)
    if shelves:
        levels = [low + (index + 1) * spread for index in range(shelves)]
        bodies.append(_shelves(cell, kind, levels, shelf_front, trim))
        if eggs and kind == "glass":
            tray = egg_tray(0.22, 0.098, finish=LINER, columns=4)
            bodies.append(tray.at(cell.x.high - 0.16, shelf_front + 0.075, levels[-1] + 0.0036))
    lamp = None
    if drawer_height is not None or not drawers:
        lamp = ag.material("led_white").with_(name=f"{leaf.label}_lamp")
        bodies += _climate(cell.with_(y=(shelf_front, cell.y.high), z=(low + 0.02, high)), liner, lamp)
        bodies += _control((cell.x.mid, shelf_front, high - 0.0105), control, show)
    return Room(bodies, slots, front, spread, lamp)


def _row(
    cell: Cell, row: ag.Region, count: int, lip: ag.Scalar, finish: ag.Material
) -> tuple[list[Slot], list[ag.Solid]]:
    """Return the drawers of a row, and the rails at both sides of them."""
    if cell.humped:
        behind = ag.switch(row.z.low < cell.z.low + HUMP_HIGH, HUMP_DEEP, 0)
        row = row.shrink(0, back=behind)
    slots = []
    for place, space in enumerate(row.shrink(0, x=CHEEK).columns(count, 0.008)):
        sides = (-1, 1) if count == 1 else (-1,) if place == 0 else (1,)
        slots.append(Slot(space, lip, sides, finish))
    beside = row.shrink(0, front=0.02, z=0.003).grow(0, x=0.0005)
    wide = CHEEK - _PLAY + 0.0005
    return slots, [each.box(bevel=0.002) for each in beside.across(wide, None, wide)[::2]]


def _shelves(
    cell: Cell, kind: ShelfKind, levels: Sequence[ag.Scalar], front: ag.Scalar, trim: ag.Material
) -> ag.Body:
    """Make shelves across the width of a cell."""
    space = cell.with_(y=(front, cell.y.high - _DUCT - 0.004))
    places = [(space.x.mid, space.y.mid, level) for level in levels]
    if kind == "glass":
        return glass_shelf(space.x.size, space.y.size, trim=trim, at=places)
    return wire_shelf(space.x.size, space.y.size, finish=trim, at=places)


def _climate(room: ag.Region, liner: ag.Material, shines: ag.Material) -> list[ag.Body]:
    """Make the light at the ceiling of a cell, and the air duct on its rear."""
    x, high, rear, wide = room.x.mid, room.z.high, room.y.high, 0.34 * room.x.size
    tall = ag.max_(room.z.size - 0.03, 0.02)  # the category reports a lack of space
    duct = ag.box(wide, _DUCT + 0.001, tall, bevel=0.005)
    duct = duct.at(x, rear - _DUCT / 2 + 0.0005, room.z.low + tall / 2 + 0.01)
    slots = details.vent_slots(0.6 * wide, 0.028, 4, slot=0.0035, direction="horizontal")
    places = [(x, rear - _DUCT, room.z.low + share * tall) for share in (0.22, 0.55, 0.86)]
    housing = ag.box(LIGHT, 0.085, 0.022, bevel=0.005).at(x, room.y.low + 0.055, high - 0.0105)
    lamp = ag.box(0.11, 0.045, 0.004, bevel=0.0015).at(x, room.y.low + 0.058, high - 0.0228)
    hollow = filled(liner, _HOLLOW)
    return [
        ag.part(duct, "duct", hollow),
        ag.detail(ag.array(details.relief(slots, proud=0.0002), at=places), "vent", DARK),
        ag.part(housing, "light", hollow),
        ag.detail(lamp, "light", shines),
    ]


def _control(
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar], kind: Literal["dial", "touch", "none"], show: str
) -> list[ag.Body]:
    """Make the temperature control on the housing of the light."""
    x, y, z = at
    face, black = (x, y + 0.0125, z), ag.material("black_abs")
    if kind == "touch":
        return [details.display(show, 0.05, 0.015, at=face, color="white", label="control")]
    if kind == "none":
        return []
    knob = ag.cylinder(0.0085, 0.010, axis=ag.Y, bevel=0.0015).at(x, y + 0.008, z)
    mark = ag.box(0.0012, 0.0008, 0.006).at(x, y + 0.003, z + 0.002)
    sign = details.icon("snowflake", 0.008).at(0.03)
    return [
        ag.detail(knob, "control", ag.material("abs")),
        ag.detail(mark, "control", black),
        details.printed(sign, face, material=black, label="control"),
    ]


def inner_drawer(
    slot: Slot, number: int, needs: ag.Condition, trim: ag.Material, *, share: ag.Scalar, friction: ag.Scalar
) -> Fitting:
    """Make a drawer that the door in front blocks unless it is open; `share` of its depth is its travel."""
    wide, deep, high = slot.space.size
    finishes = {"finish": slot.finish, "front": slot.finish, "lip": trim}
    name = f"inner_drawer_{number}"
    made = drawer_box(wide, deep, high, label="inner_drawer", name=name, lip_at=slot.lip, **finishes)
    free = needs.beyond(_SLACK - _NO_MORE)
    drag = feel.Feel(friction=friction, damping=4, effort=HAND)
    slide = ag.Prismatic(
        f"inner_drawer_slide_{number}", axis=-ag.Y, limits=(0, share * deep), feel=drag, needs=free
    )
    return Fitting.moving(made, slide).at(slot.space.anchor(y=-1, z=-1))


def _ice_box(cell: Cell, front: ag.Scalar, liner: ag.Material) -> list[ag.Body]:
    """Make the floor of an ice box under the ceiling of a cell, and the post for the hinges of its flap."""
    low = cell.z.high - _ICE_HIGH
    space = cell.with_(y=(front, cell.y.high), z=(low + _ICE_FLOOR, cell.z.high))
    floor = space.grow(y=0.0005, x=0.0005).with_(z=(low, space.z.low))
    post = space.grow(0, top=0.0005, bottom=0.0005).across(_FLAP_INSET - 0.004, None)[0].grow(0, left=0.0005)
    plate = space.shrink(0, x=0.005, front=0.05, back=0.01)
    plate = plate.with_(z=(space.z.low - 0.0003, space.z.low + 0.0007))
    return [
        ag.part([floor.box(bevel=0.004), post.deep(0.05, None)[0].box(bevel=0.004)], "ice_box", liner),
        ag.detail(plate.box(), "ice_box", ag.material("aluminium")),
    ]


def flap_reach(cell: Cell) -> ag.Scalar:
    """Return the reach of the opening flap of an ice box to the left [m]."""
    return cell.x.low + _FLAP_INSET - LIP_REACH - 0.003


def flap(cell: Cell, front: ag.Scalar, opened: ag.Condition, *, far: ag.Scalar, limit: ag.Scalar) -> Fitting:
    """Make the flap of an ice box, the link `freezer_door`, which the door in front blocks unless it is open.

    `far` is the outer side of the free ridge of the door along x [m].
    """
    board = ag.Region(
        (cell.x.low + _FLAP_INSET, cell.x.high - 0.012),
        (front, front + _FLAP),
        (cell.z.high - _ICE_HIGH + _ICE_FLOOR + 0.003, cell.z.high - 0.004),
    )
    level = board.z.low + 0.025
    lip = board.shrink(left=0.025, right=0.005)
    lip = lip.with_(y=(front - LIP_REACH, front + 0.0005), z=(level - 0.0045, level + 0.0045))
    hold = ag.frame((cell.x.high - 0.122, front - 0.011, level), approach=ag.Y, closing=ag.Z)
    ink = ag.material("black_abs").with_(name="ice_ink", base_color=(0.10, 0.25, 0.42))
    at = (board.x.mid, front, board.z.mid + 0.012)
    body = ag.weld(
        ag.part(lip.box(bevel=0.003), "freezer_door", FROSTED, grasp=hold),
        ag.part(board.box(bevel=0.004), "freezer_door", FROSTED),
        details.printed(details.icon("snowflake", 0.03), at, material=ink),
    )
    axis = board.x.low + _FLAP / 2
    pivot = (axis, front + _FLAP / 2, cell.z.high - 0.05)
    free = opened.beyond(0.7 * ag.atan2(_SLACK, far - axis))
    swing = ag.Revolute(
        "freezer_door_hinge", pivot=pivot, axis=-ag.Z, limits=(0, limit), feel=_HINGE, needs=free
    )
    return Fitting.moving(body, swing)
