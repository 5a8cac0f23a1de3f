"""Door leaves: flush, boarded, paneled, glazed, louvered and half glazed.

A leaf is in the x-z plane, in place above the floor: it is centered in x, its faces are at y = -thickness / 2
and y = thickness / 2, its lock edge is at x = width / 2.
"""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import across, casting, known, recess
from artgen.categories.shared.fixings import screws
from artgen.categories.shared.fronts import (
    EASED,
    Blank,
    Fill,
    Fittings,
    Opening,
    Relief,
    Sticking,
    panels_in,
    panes_in,
    slats_in,
)

LETTER_PLATE = 0.30
"""Width of a letter plate [m]."""


def letter_plate(fittings: Fittings, face: ag.Scalar, height: ag.Scalar) -> list[ag.Body]:
    """Make a letter plate with its flap on the outer face, and the cover of its slot inside."""
    finish, wide, tall = fittings.finish, LETTER_PLATE, 0.076
    plate = ag.extrude(ag.rectangle(wide, tall, radius=0.006), 0.0075, axis=ag.Y, bevel=0.0018)
    flap = ag.extrude(ag.rectangle(wide - 0.062, 0.048, radius=0.003), 0.0036, axis=ag.Y, bevel=0.0012)
    gap = ag.extrude(ag.rectangle(wide - 0.059, 0.051, radius=0.0045), 0.0004, axis=ag.Y)
    pivot = ag.cylinder(0.0028, wide - 0.064, axis=(1.0, 0.0, 0.0), bevel=0.0006)
    out = face + 0.0070
    inside = ag.extrude(ag.rectangle(wide - 0.03, 0.062, radius=0.004), 0.0030, axis=ag.Y, bevel=0.0009)
    lid = ag.extrude(ag.rectangle(wide - 0.075, 0.040, radius=0.003), 0.0026, axis=ag.Y, bevel=0.0008)
    places = [(x * (wide / 2.0 - 0.0155), out, height) for x in (-1, 1)]
    return [
        ag.part(plate.at(0.0, face + 0.00325, height), "plate", casting(finish, 0.5)),
        ag.detail(gap.at(0.0, out, height), "plate", recess(finish)),
        ag.detail(flap.at(0.0, out + 0.0010, height), "plate", finish),
        ag.detail(pivot.at(0.0, out + 0.0004, height + 0.0215), "plate", finish),
        *screws(places, facing="+y", radius=0.0040, finish=finish, drive="slot", head="pan"),
        ag.detail(inside.at(0.0, -(face + 0.0010), height), "plate", finish),
        ag.detail(lid.at(0.0, -(face + 0.0030), height), "plate", finish),
    ]


def house_number(fittings: Fittings, face: ag.Scalar, height: ag.Scalar, tall: ag.Scalar) -> ag.Body:
    """Make the house number of cast figures on the outer face."""
    return details.raised(
        ag.text(fittings.number, tall),
        (0.0, face, height),
        facing=ag.Y,
        proud=0.004,
        bevel=0.0008,
        label="plate",
        material=fittings.finish,
    )


def viewer(fittings: Fittings, face: ag.Scalar, height: ag.Scalar) -> list[ag.Body]:
    """Make a door viewer: a lens in a sleeve through the leaf."""
    bodies: list[ag.Body] = []
    lens = fittings.finish.with_(
        name=f"{fittings.finish.name}_lens",
        base_color=(0.02, 0.025, 0.03),
        base_metalness=0.0,
        specular_roughness=0.05,
        texture="",
        variant=0,
        tile=None,
    )
    for side, outer in ((1, 0.0085), (-1, 0.0100)):
        sleeve = ag.cylinder(outer, 0.0040, axis=ag.Y, bevel=0.0009)
        glass = ag.dome(0.0048, height=0.0016, axis=(0.0, side, 0.0))
        bodies.append(ag.detail(sleeve.at(0.0, side * (face + 0.0012), height), "plate", fittings.finish))
        bodies.append(ag.detail(glass.at(0.0, side * (face + 0.0031), height), "plate", lens))
    return bodies


def kick_plate(fittings: Fittings, face: ag.Scalar, width: ag.Scalar, bottom: ag.Scalar) -> list[ag.Body]:
    """Make the sheet that protects the foot of the outer face."""
    wide, tall, middle = width - 0.064, 0.150, bottom + 0.092
    sheet = ag.extrude(ag.rectangle(wide, tall, radius=0.003), 0.0014, axis=ag.Y, bevel=0.0005)
    places = [
        (x * (wide / 2.0 - 0.010), face + 0.0010, middle + z * (tall / 2.0 - 0.010))
        for x in (-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0)
        for z in (-1, 1)
    ]
    return [
        ag.detail(sheet.at(0.0, face + 0.0003, middle), "plate", fittings.finish),
        *screws(places, facing="+y", radius=0.0036, finish=fittings.finish),
    ]


def sweep_seal(face: ag.Scalar, width: ag.Scalar, bottom: ag.Scalar) -> list[ag.Body]:
    """Make the brush and its rail on the inner face (-y), which close the gap to the floor."""
    finish, brush = (
        ag.material("aluminium"),
        ag.material("rubber").with_(name="bristles", base_color=(0.02, 0.02, 0.02)),
    )
    wide = width - 0.06
    rail = ag.extrude(ag.rectangle(wide, 0.032, radius=0.0015), 0.0050, axis=ag.Y, bevel=0.0012)
    bead = ag.box(wide, 0.0016, 0.0030, bevel=0.0006)
    hair = ag.box(wide - 0.002, 0.0028, 0.014)
    places = [(x * (wide / 2.0 - 0.05), -(face + 0.0045), bottom + 0.022) for x in (-1.0, -0.34, 0.34, 1.0)]
    return [
        ag.detail(rail.at(0.0, -(face + 0.0020), bottom + 0.0195), "seal", finish),
        ag.detail(bead.at(0.0, -(face + 0.0045), bottom + 0.0085), "seal", finish),
        ag.detail(hair.at(0.0, -(face + 0.0020), bottom - 0.0010), "seal", brush),
        *screws(places, facing="-y", radius=0.0030, finish=finish),
    ]


def fitted(
    fittings: Fittings,
    *,
    face: ag.Scalar,
    width: ag.Scalar,
    bottom: ag.Scalar,
    letters: ag.Scalar | None,
    number: ag.Scalar | None,
    looks_out: ag.Scalar | None,
) -> list[ag.Body]:
    """Make all fixed parts of a leaf besides its lock."""
    bodies: list[ag.Body] = []
    if fittings.letters and letters is not None:
        bodies += letter_plate(fittings, face, letters)
    if fittings.number and number is not None:
        bodies.append(house_number(fittings, face, number, 0.062))
    if fittings.viewer and looks_out is not None:
        bodies += viewer(fittings, face, looks_out)
    if fittings.kick:
        bodies += kick_plate(fittings, face, width, bottom)
    if fittings.sweep:
        bodies += sweep_seal(face, width, bottom)
    return bodies


_TOP_RAIL = 0.115  # height of the top rail [m]
_BOTTOM_RAIL = 0.200  # height of the kick rail, the highest rail [m]
_LOCK_RAIL = 0.120  # height of the rails between rows [m]
_MULLION = 0.085  # width of the mullions between columns [m]


class Row(NamedTuple):
    """A row of openings between two rails."""

    share: float  # share of the height between the rails
    columns: int  # number of openings side by side
    fill: Fill  # filling of the openings


def framed(blank: Blank, stile: ag.Float, rows: Sequence[Row]) -> ag.Body:
    """Make stiles, rails and their filling, with the fittings of an entrance."""
    upright = blank.board(stile, blank.upright)
    beside = (blank.width - stile) / 2.0
    lock_stile = ag.part(
        blank.carved(upright.at(beside, 0.0, blank.waist)), "door", blank.finish, push=blank.push
    )
    boards = [upright.at(-beside, 0.0, blank.waist)]
    if blank.arch is not None:
        boards.append(ag.extrude(blank.arch.segment(), blank.thickness, axis=ag.Y, bevel=EASED))
    inner = blank.width - 2.0 * stile
    free = blank.upright - _BOTTOM_RAIL - _TOP_RAIL - _LOCK_RAIL * (len(rows) - 1)
    level: ag.Scalar = blank.bottom
    fillings: list[ag.Body] = []
    looks_out: ag.Scalar | None = None
    for index, row in enumerate(rows):
        rail = _LOCK_RAIL if index else _BOTTOM_RAIL
        boards.append(blank.board(inner, rail).at(0.0, 0.0, level + rail / 2.0))
        level = level + rail
        tall = free * row.share
        opening, mullions = _columns(inner, tall, level + tall / 2.0, row.columns, blank)
        boards += mullions
        fillings += row.fill(opening, blank.thickness)
        if index == 1 and row.columns == 2:
            looks_out = level + 0.80 * tall  # height of the viewer in the mullion
        level = level + tall
    top = blank.straight - _TOP_RAIL / 2.0
    boards.append(blank.board(inner, _TOP_RAIL).at(0.0, 0.0, top))
    fittings = fitted(
        blank.fittings,
        face=blank.thickness / 2.0,
        width=blank.width,
        bottom=blank.bottom,
        letters=blank.bottom + _BOTTOM_RAIL + free * rows[0].share + _LOCK_RAIL / 2.0 if rows[1:] else None,
        number=top,
        looks_out=looks_out,
    )
    rest = (ag.part(board, "door", blank.finish) for board in boards)
    return ag.weld(lock_stile, *rest, *fillings, *fittings)


def _columns(
    inner: ag.Scalar, tall: ag.Scalar, middle: ag.Scalar, columns: int, blank: Blank
) -> tuple[Opening, list[ag.Solid]]:
    """Return the openings of a row between the stiles, and the mullions between them."""
    wide = (inner - _MULLION * (columns - 1)) / columns
    pitch = wide + _MULLION
    centers = [((at - (columns - 1) / 2.0) * pitch, 0.0, middle) for at in range(columns)]
    board = blank.board(_MULLION, tall)
    mullions = [board.at((at - columns / 2.0) * pitch, 0.0, middle) for at in range(1, columns)]
    return Opening(wide, tall, centers, columns, blank.finish), mullions


_GLASS = known("glass", "frosted_glass", "tinted_glass")
_LOCK_STRIP = 0.120  # distance from the lock edge to an upright inlay, clear of the lock [m]
_GLASS_WEIGHTS = (0.6, 0.3, 0.1)[: len(_GLASS)]


@ag.generator
def flush_leaf(
    *,
    blank: Blank,
    inlays: int = ag.choice(0, 3, 4, weights=(0.7, 0.15, 0.15)),
    grain: Literal["upright", "across"] = ag.choice("upright", "across", weights=(0.75, 0.25)),
) -> ag.Body:
    """Make a flush leaf: one smooth slab with a hollow or particle core."""
    finish = blank.finish if grain == "upright" else across(blank.finish)
    core = finish.with_(name=f"{finish.name}_faced", density=350.0)
    if blank.arch is None:
        slab = ag.box(blank.width, blank.thickness, blank.upright, bevel=0.0015).at(0.0, 0.0, blank.waist)
    else:
        outline = blank.arch.segment() | ag.rectangle(blank.width, blank.upright).at(0.0, blank.waist)
        slab = ag.extrude(outline, blank.thickness, axis=ag.Y, bevel=0.0015)
    body = ag.weld(ag.part(blank.carved(slab), "door", core, push=blank.push), *_fitted(blank))
    if not inlays:
        return body
    # horizontal inlays end at an upright inlay beside the lock
    long, out = blank.width - _LOCK_STRIP, blank.thickness / 2.0
    strip, line = ag.box(long, 0.0008, 0.008), ag.box(0.008, 0.0008, blank.upright - 0.004)
    levels = [blank.bottom + blank.upright * (at + 0.75) / (inlays + 0.5) for at in range(inlays)]
    places = [(-_LOCK_STRIP / 2.0 + 0.001, side * (out - 0.0001), z) for z in levels for side in (-1, 1)]
    beside = [(blank.width / 2.0 - _LOCK_STRIP, side * (out - 0.0001), blank.waist) for side in (-1, 1)]
    bars = (ag.array(strip, at=places), ag.array(line, at=beside))
    return ag.weld(body, *(ag.detail(bar, "door", ag.material("aluminium")) for bar in bars))


@ag.generator
def plank_leaf(
    *,
    blank: Blank,
    boards: int = ag.count(4, 7, weights=(1, 3, 3, 1)),
    joint: ag.Float = ag.uniform(0.0025, 0.0045, "m", doc="edge radius that makes the V between boards"),
) -> ag.Body:
    """Make a boarded leaf: upright tongue-and-groove boards with a V at every joint."""
    wide = blank.width / boards
    board = blank.board(wide, blank.upright, joint)
    bodies: list[ag.Body] = []
    for index in range(boards):
        placed = board.at((index - (boards - 1) / 2.0) * wide, 0.0, blank.waist)
        if index == boards - 1:  # beside the lock
            bodies.append(ag.part(blank.carved(placed), "door", blank.finish, push=blank.push))
        else:
            bodies.append(ag.part(placed, "door", blank.finish))
    if blank.arch is not None:
        head = ag.extrude(blank.arch.segment(), blank.thickness, axis=ag.Y, bevel=EASED)
        bodies.append(ag.part(head, "door", across(blank.finish)))
    return ag.weld(*bodies, *_fitted(blank))


def _fitted(blank: Blank) -> list[ag.Body]:
    """Make the fittings of an entrance on a flat leaf."""
    return fitted(
        blank.fittings,
        face=blank.thickness / 2.0,
        width=blank.width,
        bottom=blank.bottom,
        letters=blank.bottom + 0.36 * blank.upright,
        number=blank.bottom + 0.86 * blank.upright,
        looks_out=blank.bottom + 0.76 * blank.upright,
    )


_ROWS: dict[int, tuple[tuple[float, int], ...]] = {
    1: ((1.0, 1),),
    2: ((0.42, 1), (0.58, 1)),
    3: ((0.42, 2), (0.58, 1)),
    4: ((0.42, 2), (0.58, 2)),
    5: ((0.2, 1),) * 5,
    6: ((0.34, 2), (0.45, 2), (0.21, 2)),
    7: ((0.34, 2), (0.43, 2), (0.23, 3)),
    8: ((0.25, 2),) * 4,
}
"""Rows of panels from the bottom up: the share of the height and the number of columns of each row."""


@ag.generator
def panel_leaf(
    *,
    blank: Blank,
    panels: int = ag.count(1, 8, weights=(1, 3, 1, 3, 2, 4, 1, 1), doc="number of panels; 6 is colonial"),
    relief: Relief = ag.choice("raised", "recessed"),
    sticking: Sticking = ag.by(
        "relief",
        raised=ag.choice("ogee", "ovolo"),
        recessed=ag.choice("ogee", "ovolo", "square", weights=(0.25, 0.25, 0.5)),
        doc="molding around the panels; square is the shaker door",
    ),
    stile: ag.Float = ag.uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
    moulding: ag.Float = ag.uniform(0.010, 0.016, "m", doc="reach of the molding into a panel"),
) -> ag.Body:
    """Make a leaf of stiles and rails with panels between them."""

    def panel(opening: Opening, thickness: ag.Scalar) -> list[ag.Body]:
        return panels_in(opening, thickness, relief, moulding, sticking)

    rows = [Row(share, columns, panel) for share, columns in _ROWS[panels]]
    return framed(blank, stile, rows)


@ag.generator
def glazed_leaf(
    *,
    blank: Blank,
    columns: int = ag.choice(1, 2, 3, weights=(0.4, 0.3, 0.3)),
    lights: int = ag.choice(1, 4, 5, weights=(0.4, 0.3, 0.3), doc="number of panes, one above the other"),
    glass: ag.Material = ag.choice(*_GLASS, weights=_GLASS_WEIGHTS),
    stile: ag.Float = ag.uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> ag.Body:
    """Make a glazed leaf: one pane in beads, divided by muntins."""

    def pane(opening: Opening, thickness: ag.Scalar) -> list[ag.Body]:
        return panes_in(opening, thickness, columns, lights, glass)

    return framed(blank, stile, [Row(1.0, 1, pane)])


@ag.generator
def half_lite_leaf(
    *,
    blank: Blank,
    columns: int = ag.choice(1, 2, 3),
    lights: int = ag.choice(1, 2, 3),
    glass: ag.Material = ag.choice(*_GLASS, weights=_GLASS_WEIGHTS),
    panels: int = ag.choice(1, 2),
    stile: ag.Float = ag.uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> ag.Body:
    """Make a leaf with a window above and panels below."""

    def panel(opening: Opening, thickness: ag.Scalar) -> list[ag.Body]:
        return panels_in(opening, thickness, "raised", 0.012, "ogee")

    def pane(opening: Opening, thickness: ag.Scalar) -> list[ag.Body]:
        return panes_in(opening, thickness, columns, lights, glass)

    return framed(blank, stile, [Row(0.42, panels, panel), Row(0.58, 1, pane)])


@ag.generator
def louver_leaf(
    *,
    blank: Blank,
    below: Literal["louver", "panel"] = ag.choice("louver", "panel"),
    # each slat is a collider: two sections and the hardware of a leaf stay below 64
    slats: int = ag.by(
        "below",
        louver=ag.count(9, 10),
        panel=ag.count(15, 18),
        doc="number of slats of a section",
        within=(6, 24),
    ),
    stile: ag.Float = ag.uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> ag.Body:
    """Make a louvered leaf: slats tilted by about 40 degrees, which block the view."""

    def louver(opening: Opening, thickness: ag.Scalar) -> list[ag.Body]:
        return slats_in(opening, thickness, slats)

    def panel(opening: Opening, thickness: ag.Scalar) -> list[ag.Body]:
        return panels_in(opening, thickness, "recessed", 0.012, "ovolo")

    lower = louver if below == "louver" else panel
    return framed(blank, stile, [Row(0.45, 1, lower), Row(0.55, 1, louver)])
