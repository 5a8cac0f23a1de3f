"""The inside of a refrigerator: cells with shelves and drawers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.refrigerator.case import Case, Cell
from artgen.categories.refrigerator.drawers import SLACK, Slot, drawer_front, rows
from artgen.categories.shared.appliances import DARK, LINER, filled
from artgen.categories.shared.shelves import LIP_REACH, egg_tray, glass_shelf, wire_shelf

ShelfKind = Literal["glass", "wire"]

DUCT = 0.014
"""Depth of the air duct on the rear of a cell [m]."""

ICE_SHELF = 0.024
"""Thickness of the floor of an ice box [m]."""

LIGHT = 0.15
"""Width of the light at the ceiling of a cell [m]."""

_FLAP = 0.016  # thickness of the flap of an ice box [m]
_FLAP_INSET = 0.062  # distance from the side of the cell to the hinge edge of the flap [m]


def shelf(
    cell: Cell,
    kind: ShelfKind,
    levels: Sequence[ag.Scalar],
    *,
    front: ag.Scalar,
    trim: ag.Material,
    glass: ag.Material,
) -> ag.Body:
    """Make shelves across the width of a cell."""
    rear = cell.rear - DUCT - 0.004
    deep = rear - front
    places = [(cell.middle, front + deep / 2, level) for level in levels]
    if kind == "glass":
        return glass_shelf(cell.width, deep, trim=trim, glass=glass, at=places)
    return wire_shelf(cell.width, deep, finish=trim, at=places)


def eggs(cell: Cell, level: ag.Scalar, *, front: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make an egg tray on a glass shelf, at the right in front."""
    wide = 0.22
    return egg_tray(wide, 0.098, finish=finish, columns=4).at(
        cell.right - wide / 2 - 0.05, front + 0.075, level - 0.0004
    )


def fittings(
    cell: Cell,
    *,
    front: ag.Scalar,
    low: ag.Scalar,
    high: ag.Scalar,
    control: Literal["dial", "touch", "none"],
    show: str,
    liner: ag.Material,
) -> list[ag.Body]:
    """Make light and control at the ceiling of a cell, and the air duct on its rear."""
    bodies = []
    wide = 0.34 * cell.width
    tall = ag.max_(high - low - 0.03, 0.02)  # the category reports a lack of space
    duct = ag.box(wide, DUCT + 0.001, tall, bevel=0.005)
    face = cell.rear - DUCT
    bodies.append(
        ag.part(
            duct.at(cell.middle, cell.rear - DUCT / 2 + 0.0005, low + tall / 2 + 0.01),
            "duct",
            filled(liner, 220.0),
        )
    )
    slots = details.vent_slots(0.6 * wide, 0.028, 4, slot=0.0035, direction="horizontal")
    vent = details.relief(slots, (0.0, 0.0, 0.0), proud=0.0002)
    places = [(cell.middle, face, low + share * tall) for share in (0.22, 0.55, 0.86)]
    bodies.append(ag.detail(ag.array(vent, at=places), "vent", DARK))
    housing = ag.box(LIGHT, 0.085, 0.022, bevel=0.005).at(cell.middle, front + 0.055, high - 0.0105)
    bodies.append(ag.part(housing, "light", filled(liner, 220.0)))
    lamp = ag.box(0.11, 0.045, 0.004, bevel=0.0015).at(cell.middle, front + 0.058, high - 0.0228)
    bodies.append(ag.detail(lamp, "light", ag.material("led_white")))
    panel = (cell.middle, front + 0.0125, high - 0.0105)
    if control == "dial":
        at = (cell.middle, front + 0.0080, high - 0.0105)
        knob = ag.cylinder(0.0085, 0.010, axis=ag.Y, bevel=0.0015).at(*at)
        mark = ag.box(0.0012, 0.0008, 0.006).at(cell.middle, front + 0.0030, high - 0.0085)
        bodies += [
            ag.detail(knob, "control", ag.material("abs")),
            ag.detail(mark, "control", ag.material("black_abs")),
        ]
        sign = details.icon("snowflake", 0.008).at(0.03, 0.0)
        bodies.append(details.printed(sign, panel, material=ag.material("black_abs"), label="control"))
    elif control == "touch":
        bodies.append(details.display(show, 0.05, 0.015, at=panel, color="white", label="control"))
    return bodies


def ice_box(cell: Cell, *, low: ag.Scalar, front: ag.Scalar, liner: ag.Material) -> list[ag.Body]:
    """Make the floor of an ice box under the ceiling of a cell, and the post for the hinges of its flap."""
    deep = cell.rear - front
    floor = ag.box(cell.width + 0.001, deep + 0.001, ICE_SHELF, bevel=0.004)
    plate = ag.box(cell.width - 0.01, deep - 0.06, 0.001)
    wide, high = _FLAP_INSET - 0.004, cell.high - low - ICE_SHELF
    post = ag.box(wide + 0.0005, 0.05, high + 0.001, bevel=0.004)
    return [
        ag.part(floor.at(cell.middle, front + deep / 2, low + ICE_SHELF / 2), "ice_box", liner),
        ag.part(
            post.at(cell.left + (wide - 0.0005) / 2, front + 0.025, cell.high - high / 2), "ice_box", liner
        ),
        ag.detail(
            plate.at(cell.middle, front + deep / 2 + 0.02, low + ICE_SHELF + 0.0002),
            "ice_box",
            ag.material("aluminium"),
        ),
    ]


def flap(cell: Cell, *, low: ag.Scalar, front: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the flap of an ice box, the link `freezer_door`, hinged at the left."""
    left, right = cell.left + _FLAP_INSET, cell.right - 0.012
    bottom, top = low + ICE_SHELF + 0.003, cell.high - 0.004
    board = ag.box(right - left, _FLAP, top - bottom, bevel=0.004)
    middle = ((left + right) / 2, front + _FLAP / 2, (bottom + top) / 2)
    level = bottom + 0.025
    lip = ag.box(right - left - 0.03, LIP_REACH + 0.0005, 0.009, bevel=0.003)
    lip = lip.at(middle[0] + 0.01, front - (LIP_REACH - 0.0005) / 2, level)
    hold = ag.frame((right - 0.11, front - 0.011, level), approach=(0.0, 1.0, 0.0), closing=(0.0, 0.0, 1.0))
    ink = ag.material("black_abs").with_(name="ice_ink", base_color=(0.10, 0.25, 0.42))
    sign = details.icon("snowflake", 0.03)
    return ag.weld(
        ag.part(lip, "freezer_door", finish, name="freezer_door", grasp=hold),
        ag.part(board.at(*middle), "freezer_door", finish),
        details.printed(sign, (middle[0], front, middle[2] + 0.012), material=ink),
    )


def flap_reach(cell: Cell) -> ag.Scalar:
    """Return the reach of the opening flap of an ice box to the left [m]."""
    return cell.left + _FLAP_INSET + _FLAP / 2 - LIP_REACH - _FLAP / 2 - 0.003


def flap_swing(
    cell: Cell, opened: ag.Condition, *, front: ag.Scalar, far: ag.Scalar, limit: ag.Scalar
) -> ag.Joint:
    """Make the hinge of an ice box flap, which the door in front blocks unless the door is open."""
    axis = cell.left + _FLAP_INSET + _FLAP / 2
    free = ag.atan2(SLACK, far - axis)
    return ag.Revolute(
        "freezer_door_hinge",
        pivot=(axis, front + _FLAP / 2, cell.high - 0.05),
        axis=(0.0, 0.0, -1.0),
        limits=(0.0, limit),
        friction=1.2,
        damping=0.1,
        effort=20.0,
        needs=opened.beyond(0.7 * free),
    )


_ICE_HIGH = 0.170  # height of an ice box, from the underside of its floor to the ceiling [m]
_SHELF_SHY = 0.008  # gap between the ridges of a door and the shelves [m]
_OVER = 0.014  # gap from one row of drawers to the next, or to the shelf above [m]
_BARE = 0.10  # additional height under the lowest shelf without drawers, above the even spacing [m]


@dataclass(frozen=True)
class Furniture:
    """Contents of a cell."""

    drawers: tuple[int, ...]  # numbers of drawers side by side in each row, from below
    drawer_height: ag.Scalar | None  # height of each drawer; None to fill the cell [m]
    shelves: int  # number of shelves above the drawers
    kind: ShelfKind  # kind of shelves
    trim: ag.Material  # finish of the strips or wires of shelves
    liner: ag.Material  # material of the cell and of the parts fixed to its walls
    ice_box: bool = False  # whether there is an ice box
    egg_tray: bool = False  # whether there is an egg tray
    control: Literal["dial", "touch", "none"] = "none"  # temperature control
    show: str = ""  # text of the display


@dataclass(frozen=True)
class Room:
    """A furnished cell."""

    bodies: tuple[ag.Body, ...]  # parts that are welded to the cabinet
    slots: tuple[Slot, ...]  # spaces of the drawers
    front: ag.Scalar  # position of the front of the drawers along y [m]
    ice: ag.Scalar  # height of the underside of the ice box's floor [m]
    spread: ag.Scalar  # distance from shelf to shelf [m]


def furnish(case: Case, cell: Cell, ridge: ag.Scalar | None, held: Furniture) -> Room:
    """Furnish a cell."""
    glass = ag.material("glass")
    front = drawer_front(case, ridge)
    shelf_front = case.mouth + 0.02 if ridge is None else case.face + ridge + _SHELF_SHY
    count = len(held.drawers)
    if held.drawer_height is None:
        pitch = cell.height / max(count, 1) - 0.004
        high: ag.Scalar = pitch - 0.012
        lip = 0.45 * high  # space for a hand between the door above and the floor
    else:
        high, pitch = held.drawer_height, held.drawer_height + _OVER
        lip = high - 0.034
    slots, bodies = rows(
        cell, held.drawers, low=cell.low, height=high, front=front, pitch=pitch, lip=lip, finish=held.liner
    )
    ceiling = cell.high
    ice = cell.high - _ICE_HIGH
    if held.ice_box:
        bodies += ice_box(cell, low=ice, front=front, liner=held.liner)
        ceiling = ice
    low = cell.low + _BARE
    if count and held.drawer_height is not None:
        low = cell.low + count * pitch + 0.008
        bodies.append(shelf(cell, "glass", [low], front=front - 0.012, trim=held.trim, glass=glass))
    spread = (ceiling - low) / (held.shelves + 1)
    levels = [low + (index + 1) * spread for index in range(held.shelves)]
    if levels:
        bodies.append(shelf(cell, held.kind, levels, front=shelf_front, trim=held.trim, glass=glass))
    if held.egg_tray and held.kind == "glass" and held.shelves:
        bodies.append(eggs(cell, low + held.shelves * spread + 0.004, front=shelf_front, finish=LINER))
    if held.drawer_height is not None or not count:
        bodies += fittings(
            cell,
            front=shelf_front,
            low=low + 0.02,
            high=ceiling,
            control=held.control,
            show=held.show,
            liner=held.liner,
        )
    return Room(tuple(bodies), tuple(slots), front, ice, spread)
