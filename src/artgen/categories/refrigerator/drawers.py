"""Drawers of refrigerators: drawers behind doors, and freezer drawers with their own fronts."""

from collections.abc import Sequence
from dataclasses import dataclass

import artgen as ag
from artgen.categories.refrigerator.case import HUMP_DEEP, HUMP_HIGH, SEAL_GAP, Case, Cell
from artgen.categories.refrigerator.doors import Dress, framing, lining, slab
from artgen.categories.refrigerator.leaf import CHEEK, door_gasket
from artgen.categories.shared.appliances import filled
from artgen.categories.shared.pulls import bar_handle, recessed_grip
from artgen.categories.shared.shelves import LIP_REACH, drawer_box, open_box

SLACK = 0.012
"""Travel of a drawer until it strikes the ridges or the flat inside of its closed door [m]."""

_PLAY = 0.003  # gap around a drawer [m]
_FLOOR = 0.004  # gap under a drawer [m]
_NO_MORE = 0.002  # difference between this travel and the declared free travel of a drawer [m]
_FOAM = 190.0  # density of fronts, equal to that of doors [kg/m3]
_HAND = 60.0  # largest pull of a hand [N]


@dataclass(frozen=True)
class Slot:
    """Space of a drawer behind a door."""

    left: ag.Scalar  # position of the left side along x [m]
    right: ag.Scalar  # position of the right side along x [m]
    low: ag.Scalar  # height of the underside [m]
    height: ag.Scalar  # height of the drawer [m]
    front: ag.Scalar  # position of the front along y [m]
    rear: ag.Scalar  # rearmost position along y [m]
    lip: ag.Scalar  # height of the lip above the underside [m]
    # the halves of the cell that contain the drawer: -1 the left half, 1 the right half
    sides: tuple[int, ...] = (-1, 1)


def drawer_front(case: Case, ridge: ag.Scalar | None) -> ag.Scalar:
    """Return the position of the fronts of drawers along y, behind ridges or a flat inside of a door [m]."""
    return case.face + SLACK + LIP_REACH + (0.0 if ridge is None else ridge)


def rows(
    cell: Cell,
    counts: Sequence[int],
    *,
    low: ag.Scalar,
    height: ag.Scalar,
    front: ag.Scalar,
    pitch: ag.Scalar,
    lip: ag.Scalar,
    finish: ag.Material,
) -> tuple[list[Slot], list[ag.Body]]:
    """Place drawers in rows from below, and make the rails at both sides of them."""
    slots: list[Slot] = []
    rails: list[ag.Body] = []
    hollow = filled(finish, 160.0)
    for number, count in enumerate(counts):
        base = low + number * pitch + _FLOOR
        behind = ag.switch(base < cell.low + HUMP_HIGH, HUMP_DEEP, 0.0) if cell.humped else 0.0
        rear = cell.rear - behind - 0.012
        room = cell.width - 2 * CHEEK
        wide = (room - (count - 1) * 0.008) / count
        for place in range(count):
            left = cell.left + CHEEK + place * (wide + 0.008)
            sides = (-1, 1) if count == 1 else (-1,) if place == 0 else (1,)
            slots.append(Slot(left, left + wide, base, height, front, rear, lip, sides))
        deep = rear - front - 0.02
        cheek = ag.box(CHEEK - _PLAY + 0.0005, deep, height - 0.006, bevel=0.002)
        aside = (CHEEK - _PLAY - 0.0005) / 2
        rails += [
            ag.part(cheek.at(x, front + 0.02 + deep / 2, base + height / 2), "rail", hollow)
            for x in (cell.left + aside, cell.right - aside)
        ]
    return slots, rails


def inner_drawer(
    slot: Slot, number: int, *, finish: ag.Material, front: ag.Material, lip: ag.Material
) -> ag.Body:
    """Make a drawer behind a door: the link `inner_drawer_<number>`."""
    made = drawer_box(
        slot.right - slot.left,
        slot.rear - slot.front,
        slot.height,
        label="inner_drawer",
        name=f"inner_drawer_{number}",
        finish=finish,
        front=front,
        lip=lip,
        lip_at=slot.lip,
    )
    return made.at((slot.left + slot.right) / 2, slot.front, slot.low)


def inner_slide(
    slot: Slot, number: int, opened: ag.Condition, *, share: ag.Scalar, friction: ag.Scalar
) -> ag.Joint:
    """Make the slide of a drawer behind a door, which blocks the drawer unless the door is open."""
    return ag.Prismatic(
        f"inner_drawer_slide_{number}",
        axis=(0.0, -1.0, 0.0),
        pivot=((slot.left + slot.right) / 2, slot.front, slot.low),
        limits=(0.0, share * (slot.rear - slot.front)),
        friction=friction,
        damping=4.0,
        effort=_HAND,
        needs=opened.beyond(SLACK - _NO_MORE),
    )


@dataclass(frozen=True)
class Front:
    """Front of a freezer drawer."""

    cell: Cell  # closed cell
    left: ag.Scalar  # position of the left edge along x [m]
    right: ag.Scalar  # position of the right edge along x [m]
    low: ag.Scalar  # height of the lower edge [m]
    high: ag.Scalar  # height of the upper edge [m]


def outer_drawer(case: Case, front: Front, number: int, dress: Dress, *, finish: ag.Material) -> ag.Body:
    """Make a freezer drawer with its front, gasket, handle and basket: the link `outer_drawer_<number>`."""
    left, right, low, high = front.left, front.right, front.low, front.high
    middle, upward = (left + right) / 2, (low + high) / 2
    skin = slab(case, dress, left, right, low, high)
    inner = lining(case, left + 0.005, right - 0.005, low + 0.005, high - 0.005, thick=0.028)
    if dress.grip == "bar":
        aside = 0.031 if dress.front == "framed" else 0.055
        length = ag.min_(ag.max_(0.62 * (right - left), 0.2), (right - left) - 0.1)
        feet = dress.rise((length - 0.02) / (right - left)) - (0.0008 if dress.front == "bowed" else 0.0)
        # in front of the middle, the highest point of the bow
        out = 0.040 + 1.4 * dress.girth + (dress.rise(0.0) - feet)
        handle = bar_handle(
            length=length,
            finish=dress.metal,
            style=dress.bar,
            level=True,
            name=f"outer_drawer_{number}_handle",
            projection=out,
            girth=dress.girth,
        ).at(middle, case.front - feet, high - aside)
    else:
        grip = recessed_grip(
            0.26,
            finish=dress.metal,
            lining=ag.material("black_abs"),
            level=True,
            name=f"outer_drawer_{number}_handle",
        )
        grip = grip.at(middle, case.front, high - 0.062)
        skin, inner, handle = skin - grip.cut, inner - grip.cut, grip.shell
    seal = door_gasket(
        right - left - 0.024, high - low - 0.016, rubber=dress.seal, deep=SEAL_GAP - 0.0004, size=0.014
    )
    return ag.weld(
        ag.part(skin, "outer_drawer", filled(dress.finish, _FOAM), name=f"outer_drawer_{number}"),
        ag.part(inner, "liner", filled(dress.liner, _FOAM)),
        *framing(case, dress, left, right, low, high),
        handle,
        seal.at(middle, case.face, upward),
        *_basket(case, front.cell, finish),
    )


def basket_depth(case: Case, cell: Cell) -> ag.Scalar:
    """Return the depth of the basket of a freezer drawer [m]."""
    return cell.rear - (HUMP_DEEP if cell.humped else 0.0) - 0.015 - case.face


def _basket(case: Case, cell: Cell, finish: ag.Material) -> list[ag.Body]:
    deep, wide = basket_depth(case, cell), cell.width - 2 * 0.022
    tall = 0.62 * cell.height
    boards = open_box(wide, deep + 0.002, tall, wall=0.004, front=0.004)
    rail = ag.box(0.010, deep - 0.02, 0.022, bevel=0.002)
    at = (cell.middle, case.face - 0.002, cell.low + 0.012)
    return [
        *(ag.part(board.at(*at), "basket", finish) for board in boards),
        *(
            ag.detail(
                rail.at(cell.middle + way * (wide / 2 + 0.003), case.face + deep / 2, cell.low + 0.7 * tall),
                "rail",
                ag.material("zinc"),
            )
            for way in (-1, 1)
        ),
    ]


def outer_slide(case: Case, front: Front, number: int, *, share: ag.Scalar, pull: ag.Scalar) -> ag.Joint:
    """Make the slide of a freezer drawer on its runners."""
    return ag.Prismatic(
        f"outer_drawer_slide_{number}",
        axis=(0.0, -1.0, 0.0),
        pivot=((front.left + front.right) / 2, case.front, (front.low + front.high) / 2),
        limits=(0.0, share * basket_depth(case, front.cell)),
        friction=pull,
        damping=12.0,
        effort=_HAND,
    )
