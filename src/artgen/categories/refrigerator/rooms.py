"""A cell of a refrigerator with all that is in it: drawers below, shelves above, an ice box at the top."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.refrigerator.case import Case, Cell
from artgen.categories.refrigerator.drawers import Slot, drawer_front, rows
from artgen.categories.refrigerator.inside import ShelfKind, eggs, fittings, ice_box, shelf
from artgen.categories.shared.appliances.finish import LINER

_ICE_HIGH = 0.170  # of an ice box, from the underside of its floor to the ceiling [m]
_SHELF_SHY = 0.008  # between the ridges of a door and the shelves [m]
_OVER = 0.014  # from one row of drawers to the next, or to the shelf above [m]
_BARE = 0.10  # under the lowest shelf where there are no drawers, above the even spacing [m]


@dataclass(frozen=True)
class Furniture:
    """What a cell holds."""

    drawers: tuple[int, ...]  # how many drawers stand side by side in each row, from below
    drawer_height: ag.Scalar | None  # of each; None lets them fill the cell [m]
    shelves: int  # how many there are above the drawers
    kind: ShelfKind  # of the shelves
    trim: ag.Material  # of their strips, or wires
    liner: ag.Material  # of the cell, and of what is fixed to its walls
    ice_box: bool = False  # whether there is one
    egg_tray: bool = False  # whether there is one
    control: Literal["dial", "touch", "none"] = "none"  # what sets the temperature
    show: str = ""  # what a display shows


@dataclass(frozen=True)
class Room:
    """A furnished cell."""

    bodies: tuple[ag.Body, ...]  # what is to be welded to the cabinet
    slots: tuple[Slot, ...]  # the places of its drawers
    front: ag.Scalar  # the front of its drawers along y [m]
    ice: ag.Scalar  # underside of the floor of its ice box [m]
    spread: ag.Scalar  # from shelf to shelf [m]


def furnish(case: Case, cell: Cell, ridge: ag.Scalar | None, held: Furniture) -> Room:
    """Furnish a cell."""
    glass = ag.material("glass")
    front = drawer_front(case, ridge)
    shelf_front = case.mouth + 0.02 if ridge is None else case.face + ridge + _SHELF_SHY
    count = len(held.drawers)
    if held.drawer_height is None:
        pitch = cell.height / max(count, 1) - 0.004
        high: ag.Scalar = pitch - 0.012
        lip = 0.45 * high  # hands come between the door above and the floor
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
