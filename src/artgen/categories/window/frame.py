"""Frames of windows: rebated for hinged sashes, tracked for sliding sashes; sills and drip caps.

The middle of the opening is the origin. Rebated frames have their stops behind the sashes, which open to -y;
`outside` gives the direction of the outside, -1 for -y.
"""

from collections.abc import Sequence
from typing import NamedTuple

import artgen as ag
from artgen.categories.window.plan import SEALED, SEAM, STOP, Rect, Section, ring_along, ring_of

MULLION = 0.068
"""Width of the posts and transoms between two sashes [m]."""

SILL = 0.030
"""Thickness of the sill under a frame [m]."""

_OUT = 0.048  # projection of a sill from the frame [m]
_PLAY = 0.003  # gap between a sliding sash and its track, in depth [m]
_BEAD = 0.008  # gap between two tracks [m]
_STRIP = (0.010, 0.016)  # thickness and projection of the strips of tracks [m]

TRACK = 0.004
"""Gap between the edges of sliding sashes and the frame [m]."""


class Cell(NamedTuple):
    """The opening of one sash in a frame."""

    x: ag.Scalar  # position of the middle along x [m]
    z: ag.Scalar  # position of the middle along z [m]
    width: ag.Scalar  # width of the opening [m]
    height: ag.Scalar  # height of the opening [m]
    column: int  # index of the column, from the left


def cells(width: ag.Scalar, height: ag.Scalar, columns: int, rows: Sequence[ag.Scalar]) -> list[Cell]:
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
    width: ag.Scalar,
    height: ag.Scalar,
    places: Sequence[Cell],
    section: Section,
    finish: ag.Material,
    *,
    solid: bool,
) -> ag.Body:
    """Make the frame around hinged sashes: a mitered ring, posts and transoms, stops and seals."""
    deep, eased = section.back, section.eased
    outline = ag.rectangle(section.frame, deep, radius=eased).at(-section.frame / 2.0, -deep / 2.0)
    around = Rect(-section.frame, 0.0, -deep, 0.0)
    bodies = [ring_of(outline, [around], width, height, "frame", finish, eased=eased)]
    bodies += [ag.part(bar, "frame", finish) for bar in _bars(width, height, places, section)]
    soft = min(eased, 0.002)
    thick = deep - section.stop - 0.0004
    stop = ag.rectangle(STOP, thick, radius=soft).at(STOP / 2.0, -section.stop - thick / 2.0)
    # a stop reaches 2 mm into its base
    stands = Rect(-0.002, STOP, -section.stop - thick, -section.stop)
    seal = ag.rectangle(0.0045, SEALED - 0.0008, radius=0.001).at(-0.0028, (SEALED - 0.0008) / 2.0)
    for cell in places:
        stops = (
            ring_of(stop, [stands], cell.width, cell.height, "frame", finish, eased=soft)
            if solid
            else ag.detail(ring_along(stop, cell.width, cell.height), "frame", finish)
        )
        strip = ag.detail(ring_along(seal, cell.width, cell.height), "seal", ag.material("rubber"))
        bodies += [each.at(cell.x, 0.0, cell.z) for each in (stops, strip)]
    return ag.weld(*bodies)


def _bars(width: ag.Scalar, height: ag.Scalar, places: Sequence[Cell], section: Section) -> list[ag.Solid]:
    """Make the posts and transoms between the openings."""
    columns = 1 + max(cell.column for cell in places)
    rows = len(places) // columns
    middle, deep = section.back / 2.0, section.back - 0.0004
    first = places[0]
    bars = []
    for row in range(1, rows):
        below = places[row * columns - 1]
        z = below.z + (below.height + MULLION) / 2.0
        bars.append(ag.box(width - SEAM, deep, MULLION, bevel=section.eased).at(0.0, middle, z))
    for row in range(rows):
        cell = places[row * columns]
        post = ag.box(MULLION, deep, cell.height - SEAM, bevel=section.eased)
        for column in range(1, columns):
            x = first.x + (column - 0.5) * (first.width + MULLION)
            bars.append(post.at(x, middle, cell.z))
    return bars


class Tracks(NamedTuple):
    """Positions of the tracks of sliding sashes along y."""

    outer: float  # middle of the outer sashes [m]
    inner: float  # middle of the inner sashes [m]
    back: float  # rear end of the frame; its front is at 0 [m]

    @staticmethod
    def of(section: Section) -> "Tracks":
        """Return two tracks for sashes of a system."""
        outer = _STRIP[0] + _PLAY + section.slide / 2.0
        inner = outer + section.slide + 2.0 * _PLAY + _BEAD
        return Tracks(outer, inner, inner + outer)


def tracked_frame(
    width: ag.Scalar, height: ag.Scalar, section: Section, finish: ag.Material, *, head: ag.Scalar
) -> ag.Body:
    """Make the frame around sliding sashes: a mitered ring with three strips that form two tracks."""
    tracks = Tracks.of(section)
    deep = tracks.back
    outline = ag.rectangle(section.frame, deep, radius=section.eased).at(-section.frame / 2.0, -deep / 2.0)
    around = Rect(-section.frame, 0.0, -deep, 0.0)
    bodies = [ring_of(outline, [around], width, height, "frame", finish, eased=section.eased)]
    middle = (tracks.outer + tracks.inner) / 2.0
    thick, _ = _STRIP
    pile = ag.material("rubber").with_(name="pile", base_color=(0.09, 0.09, 0.095), specular_roughness=0.95)
    for at, wide in ((thick / 2.0, thick), (middle, _BEAD), (deep - thick / 2.0, thick)):
        strip = ag.rectangle(head, wide - 0.0004, radius=0.0012).at(head / 2.0, -at)
        stands = Rect(-0.002, head, -at - wide / 2.0, wide / 2.0 - at)
        bodies.append(ring_of(strip, [stands], width, height, "frame", finish, eased=0.0012))
        for side in (-1.0, 1.0):
            if 0.0 < at + side * wide / 2.0 < deep - 0.001 and (side > 0) == (at < middle + 0.001):
                brush = ag.rectangle(0.006, 0.0012).at(head - 0.0045, -at - side * (wide / 2.0 + 0.0004))
                bodies.append(ag.detail(ring_along(brush, width, height), "seal", pile))
    return ag.weld(*bodies)


def sill_under(
    width: ag.Scalar,
    front: ag.Scalar,
    back: ag.Scalar,
    top: ag.Scalar,
    finish: ag.Material,
    *,
    horns: ag.Scalar,
) -> ag.Body:
    """Make the sill under the frame; its top slopes down to the outside, its nose has a drip groove."""
    nose = front - _OUT
    low = top - SILL
    section = ag.polygon(
        [(back, low), (back, top - SEAM), (front, top - SEAM), (nose, top - 0.008), (nose, low)], radius=0.002
    )
    solid = ag.extrude(section, width + 2.0 * horns, axis=ag.X, bevel=0.0015)
    groove = ag.box(width, 0.005, 0.004).at(0.0, nose + 0.014, low + 0.0021)
    return ag.weld(ag.part(solid, "sill", finish), ag.detail(groove, "sill", ag.material("black_abs")))


def drip_cap(width: ag.Scalar, front: ag.Scalar, top: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the drip cap over the head, on the outside at y = front."""
    section = ag.polygon(
        [(0.0, 0.0), (0.0, 0.016), (-0.026, 0.010), (-0.030, -0.003), (-0.0275, -0.003), (-0.024, 0.004)]
    )
    return ag.part(
        ag.extrude(section, width, axis=ag.X).at(0.0, front + 0.0005, top - 0.018), "frame", finish
    )


def trickle_vent(
    x: ag.Scalar, face: ag.Scalar, z: ag.Scalar, finish: ag.Material, *, length: ag.Scalar
) -> ag.Body:
    """Make a trickle vent on the inside of the head: a case with a row of slots and a slider."""
    case = ag.box(length, 0.014, 0.020, bevel=0.004).at(x, face + 0.0068, z)
    slots = ag.array(
        ag.box(0.012, 0.002, 0.007, bevel=0.0008),
        at=[(x + (index - 5.5) * 0.018, face + 0.0132, z) for index in range(12)],
    )
    knob = ag.box(0.024, 0.006, 0.006, bevel=0.0015).at(x + 0.5 * length - 0.022, face + 0.0155, z)
    return ag.weld(
        ag.part(case, "vent", finish),
        ag.detail(slots, "vent", ag.material("black_abs")),
        ag.detail(knob, "vent", finish),
    )


def window_board(width: ag.Scalar, back: ag.Scalar, top: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the board on the inside of the wall under a window, level with the sill."""
    board = ag.Region.between(
        (-width / 2.0 - 0.03, back + SEAM, top - 0.022), (width / 2.0 + 0.03, back + 0.14, top - SEAM)
    ).box(bevel=0.003)
    return ag.part(board, "sill", finish)
