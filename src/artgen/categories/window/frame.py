"""Frames of windows: rebated ones for hinged sashes, tracked ones for those that slide, sills and drip caps.

The opening's middle is the origin. Frames with rebates have their stops behind the sashes, which open to -y;
the outside is where `outside` says, -1 for -y.
"""

from collections.abc import Sequence
from typing import NamedTuple

from artgen import (
    Body,
    Material,
    Scalar,
    Solid,
    X,
    array,
    box,
    box_between,
    detail,
    extrude,
    material,
    part,
    polygon,
    rectangle,
    weld,
)
from artgen.categories.window.plan import SEALED, SEAM, STOP, Rect, Section, ring_along, ring_of

MULLION = 0.068
"""Face of the posts and transoms between two sashes [m]."""

SILL = 0.030
"""Thickness of the sill under a frame [m]."""

_OUT = 0.048  # how far a sill stands out of the frame [m]
_PLAY = 0.003  # between a sliding sash and its track, in depth [m]
_BEAD = 0.008  # between two tracks [m]
_STRIP = (0.010, 0.016)  # of tracks: how thick, and how far they stand out [m]

TRACK = 0.004
"""Between the edges of sliding sashes and the frame [m]."""


class Cell(NamedTuple):
    """The opening of one sash in a frame."""

    x: Scalar  # where its middle is [m]
    z: Scalar  # [m]
    width: Scalar  # [m]
    height: Scalar  # [m]
    column: int  # which it is, from the left


def cells(width: Scalar, height: Scalar, columns: int, rows: Sequence[Scalar]) -> list[Cell]:
    """Divide an opening by posts and transoms."""
    wide = (width - MULLION * (columns - 1)) / columns
    free = height - MULLION * (len(rows) - 1)
    found: list[Cell] = []
    level = -height / 2.0
    for share in rows:
        tall = free * share
        for column in range(columns):
            x = (column - (columns - 1) / 2.0) * (wide + MULLION)
            found.append(Cell(x, level + tall / 2.0, wide, tall, column))
        level = level + tall + MULLION
    return found


def rebated_frame(
    width: Scalar, height: Scalar, places: Sequence[Cell], section: Section, finish: Material, *, solid: bool
) -> Body:
    """Make the frame around hinged sashes: a mitred ring, posts and transoms, stops and seals."""
    deep, eased = section.back, section.eased
    outline = rectangle(section.frame, deep, radius=eased).at(-section.frame / 2.0, -deep / 2.0)
    around = Rect(-section.frame, 0.0, -deep, 0.0)
    bodies = [ring_of(outline, [around], width, height, "frame", finish, eased=eased)]
    bodies += [part(bar, "frame", finish) for bar in _bars(width, height, places, section)]
    soft = min(eased, 0.002)
    thick = deep - section.stop - 0.0004
    stop = rectangle(STOP, thick, radius=soft).at(STOP / 2.0, -section.stop - thick / 2.0)
    # a stop reaches 2 mm into what it stands on
    stands = Rect(-0.002, STOP, -section.stop - thick, -section.stop)
    seal = rectangle(0.0045, SEALED - 0.0008, radius=0.001).at(-0.0028, (SEALED - 0.0008) / 2.0)
    for cell in places:
        stops = (
            ring_of(stop, [stands], cell.width, cell.height, "frame", finish, eased=soft)
            if solid
            else detail(ring_along(stop, cell.width, cell.height), "frame", finish)
        )
        strip = detail(ring_along(seal, cell.width, cell.height), "seal", material("rubber"))
        bodies += [each.at(cell.x, 0.0, cell.z) for each in (stops, strip)]
    return weld(*bodies)


def _bars(width: Scalar, height: Scalar, places: Sequence[Cell], section: Section) -> list[Solid]:
    """Make the posts and transoms between the openings."""
    columns = 1 + max(cell.column for cell in places)
    rows = len(places) // columns
    middle, deep = section.back / 2.0, section.back - 0.0004
    first = places[0]
    bars = []
    for row in range(1, rows):
        below = places[row * columns - 1]
        z = below.z + (below.height + MULLION) / 2.0
        bars.append(box(width - SEAM, deep, MULLION, bevel=section.eased).at(0.0, middle, z))
    for row in range(rows):
        cell = places[row * columns]
        post = box(MULLION, deep, cell.height - SEAM, bevel=section.eased)
        for column in range(1, columns):
            x = first.x + (column - 0.5) * (first.width + MULLION)
            bars.append(post.at(x, middle, cell.z))
    return bars


class Tracks(NamedTuple):
    """Where sashes slide in a frame, along y."""

    outer: float  # middle of the outer sashes [m]
    inner: float  # middle of the inner sashes [m]
    back: float  # where the frame ends; it begins at 0 [m]

    @staticmethod
    def of(section: Section) -> "Tracks":
        """Lay two tracks for sashes of a system."""
        outer = _STRIP[0] + _PLAY + section.slide / 2.0
        inner = outer + section.slide + 2.0 * _PLAY + _BEAD
        return Tracks(outer, inner, inner + outer)


def tracked_frame(width: Scalar, height: Scalar, section: Section, finish: Material, *, head: Scalar) -> Body:
    """Make the frame around sliding sashes: a mitred ring with three strips that make two tracks."""
    tracks = Tracks.of(section)
    deep = tracks.back
    outline = rectangle(section.frame, deep, radius=section.eased).at(-section.frame / 2.0, -deep / 2.0)
    around = Rect(-section.frame, 0.0, -deep, 0.0)
    bodies = [ring_of(outline, [around], width, height, "frame", finish, eased=section.eased)]
    middle = (tracks.outer + tracks.inner) / 2.0
    thick, _ = _STRIP
    pile = material("rubber").with_(name="pile", base_color=(0.09, 0.09, 0.095), specular_roughness=0.95)
    for at, wide in ((thick / 2.0, thick), (middle, _BEAD), (deep - thick / 2.0, thick)):
        strip = rectangle(head, wide - 0.0004, radius=0.0012).at(head / 2.0, -at)
        stands = Rect(-0.002, head, -at - wide / 2.0, wide / 2.0 - at)
        bodies.append(ring_of(strip, [stands], width, height, "frame", finish, eased=0.0012))
        for side in (-1.0, 1.0):
            if 0.0 < at + side * wide / 2.0 < deep - 0.001 and (side > 0) == (at < middle + 0.001):
                brush = rectangle(0.006, 0.0012).at(head - 0.0045, -at - side * (wide / 2.0 + 0.0004))
                bodies.append(detail(ring_along(brush, width, height), "seal", pile))
    return weld(*bodies)


def sill_under(
    width: Scalar, front: Scalar, back: Scalar, top: Scalar, finish: Material, *, horns: Scalar
) -> Body:
    """Make the sill that the frame stands on; its top falls to the outside, its nose has a drip groove."""
    nose = front - _OUT
    low = top - SILL
    section = polygon(
        [
            (back, low),
            (back, top - SEAM),
            (front, top - SEAM),
            (nose, top - 0.008),
            (nose, low),
        ],
        radius=0.002,
    )
    solid = extrude(section, width + 2.0 * horns, axis=X, bevel=0.0015)
    groove = box(width, 0.005, 0.004).at(0.0, nose + 0.014, low + 0.0021)
    return weld(part(solid, "sill", finish), detail(groove, "sill", material("black_abs")))


def drip_cap(width: Scalar, front: Scalar, top: Scalar, finish: Material) -> Body:
    """Make the cap over the head that throws rain off, on the outside at y = front."""
    section = polygon(
        [(0.0, 0.0), (0.0, 0.016), (-0.026, 0.010), (-0.030, -0.003), (-0.0275, -0.003), (-0.024, 0.004)]
    )
    return part(extrude(section, width, axis=X).at(0.0, front + 0.0005, top - 0.018), "frame", finish)


def trickle_vent(x: Scalar, face: Scalar, z: Scalar, finish: Material, *, length: Scalar) -> Body:
    """Make a trickle vent on the inside of the head: a case with a row of slots and a slider."""
    case = box(length, 0.014, 0.020, bevel=0.004).at(x, face + 0.0068, z)
    slots = array(
        box(0.012, 0.002, 0.007, bevel=0.0008),
        at=[(x + (index - 5.5) * 0.018, face + 0.0132, z) for index in range(12)],
    )
    knob = box(0.024, 0.006, 0.006, bevel=0.0015).at(x + 0.5 * length - 0.022, face + 0.0155, z)
    return weld(
        part(case, "vent", finish),
        detail(slots, "vent", material("black_abs")),
        detail(knob, "vent", finish),
    )


def window_board(width: Scalar, back: Scalar, top: Scalar, finish: Material) -> Body:
    """Make the board on the inside of the wall under a window, level with the sill."""
    board = box_between(
        (-width / 2.0 - 0.03, back + SEAM, top - 0.022),
        (width / 2.0 + 0.03, back + 0.14, top - SEAM),
        bevel=0.003,
    )
    return part(board, "sill", finish)
