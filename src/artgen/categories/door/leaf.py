"""Door leaves: flush, boarded, paneled, glazed, louvered and half glazed.

A leaf is in the x-z plane, in place above the floor: it is centered in x, its faces are at y = -thickness / 2
and y = thickness / 2, its lock edge is at x = width / 2.
"""

from collections.abc import Sequence
from functools import partial
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import fronts
from artgen.categories.shared.finish import across, casting, known, recess
from artgen.categories.shared.fixings import screws
from artgen.categories.shared.fronts import EASED, Blank, Opening


def _sheet(
    wide: ag.Scalar, tall: float, thick: float, *, radius: float = 0.003, bevel: float = 0.0
) -> ag.Solid:
    """Make an upright sheet with rounded corners about the origin."""
    return ag.extrude(ag.rectangle(wide, tall, radius=radius), thick, axis=ag.Y, bevel=bevel)


def _letter_plate(face: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a letter plate with its flap on the outer face, and the cover of its slot inside."""
    wide, out = 0.30, face + 0.0070
    plate = _sheet(wide, 0.076, 0.0075, radius=0.006, bevel=0.0018).at(y=face + 0.00325)
    gap = _sheet(wide - 0.059, 0.051, 0.0004, radius=0.0045).at(y=out)
    pivot = ag.cylinder(0.0028, wide - 0.064, axis=ag.X, bevel=0.0006)
    seen = [
        _sheet(wide - 0.062, 0.048, 0.0036, bevel=0.0012).at(y=out + 0.0010),
        pivot.at(y=out + 0.0004, z=0.0215),
        _sheet(wide - 0.03, 0.062, 0.0030, radius=0.004, bevel=0.0009).at(y=-face - 0.0010),
        _sheet(wide - 0.075, 0.040, 0.0026, bevel=0.0008).at(y=-face - 0.0030),
    ]
    at = [(x * (wide / 2 - 0.0155), out, 0.0) for x in (-1, 1)]
    heads = screws(at, facing="+y", radius=0.0040, finish=finish, drive="slot", head="pan")
    solid = ag.part(plate, "plate", casting(finish, 0.5))
    dark = ag.detail(gap, "plate", recess(finish))
    return ag.weld(solid, dark, ag.detail(seen, "plate", finish), *heads).at(z=height)


def _viewer(face: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Make a door viewer: a lens in a sleeve through the leaf."""
    lens = recess(finish).with_(
        name=f"{finish.name}_lens", base_color=(0.02, 0.025, 0.03), specular_roughness=0.05
    )
    bodies: list[ag.Body] = []
    for side, outer in ((1, 0.0085), (-1, 0.0100)):
        sleeve = ag.cylinder(outer, 0.0040, axis=ag.Y, bevel=0.0009).at(y=side * (face + 0.0012))
        glass = ag.dome(0.0048, height=0.0016, axis=(0.0, side, 0.0)).at(y=side * (face + 0.0031))
        bodies += [ag.detail(sleeve, "plate", finish), ag.detail(glass, "plate", lens)]
    return [each.at(z=height) for each in bodies]


def _kick_plate(face: ag.Scalar, width: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the sheet that protects the foot of the outer face, above z = 0."""
    wide, tall, middle = width - 0.064, 0.150, 0.092
    sheet = _sheet(wide, tall, 0.0014, bevel=0.0005).at(y=face + 0.0003, z=middle)
    x, z = wide / 2 - 0.010, tall / 2 - 0.010
    places = [(x * share, face + 0.0010, middle + end) for share in (-1, -1 / 3, 1 / 3, 1) for end in (-z, z)]
    return ag.weld(
        ag.detail(sheet, "plate", finish), *screws(places, facing="+y", radius=0.0036, finish=finish)
    )


def _sweep_seal(face: ag.Scalar, width: ag.Scalar) -> ag.Body:
    """Make the brush and its rail on the inner face (-y), which close the gap below z = 0."""
    finish, wide = ag.material("aluminium"), width - 0.06
    brush = ag.material("rubber").with_(name="bristles", base_color=(0.02, 0.02, 0.02))
    rail = _sheet(wide, 0.032, 0.0050, radius=0.0015, bevel=0.0012).at(y=-face - 0.0020, z=0.0195)
    bead = ag.box(wide, 0.0016, 0.0030, bevel=0.0006).at(y=-face - 0.0045, z=0.0085)
    hair = ag.box(wide - 0.002, 0.0028, 0.014).at(y=-face - 0.0020, z=-0.0010)
    places = [(x * (wide / 2 - 0.05), -face - 0.0045, 0.022) for x in (-1, -0.34, 0.34, 1)]
    return ag.weld(
        ag.detail([rail, bead], "seal", finish),
        ag.detail(hair, "seal", brush),
        *screws(places, facing="-y", radius=0.0030, finish=finish),
    )


_Level = ag.Scalar | None  # height of a fitting; None where a leaf has no room for it [m]


def _fitted(blank: Blank, letters: _Level, number: ag.Scalar, looks_out: _Level) -> list[ag.Body]:
    """Make the wanted fittings of an entrance besides its lock."""
    fittings, face, bodies = blank.fittings, blank.thickness / 2, []
    if fittings.letters and letters is not None:
        bodies.append(_letter_plate(face, letters, fittings.finish))
    if fittings.number:
        figures, at = ag.text(fittings.number, 0.062), (0.0, face, number)
        raised = partial(details.raised, facing=ag.Y, proud=0.004, bevel=0.0008, label="plate")
        bodies.append(raised(figures, at, material=fittings.finish))
    if fittings.viewer and looks_out is not None:
        bodies += _viewer(face, looks_out, fittings.finish)
    if fittings.kick:
        bodies.append(_kick_plate(face, blank.width, fittings.finish).at(z=blank.bottom))
    if fittings.sweep:
        bodies.append(_sweep_seal(face, blank.width).at(z=blank.bottom))
    return bodies


_TOP_RAIL = 0.115  # height of the top rail [m]
_BOTTOM_RAIL = 0.200  # height of the kick rail, the highest rail [m]
_LOCK_RAIL = 0.120  # height of the rails between rows [m]
_MULLION = 0.085  # width of the mullions between columns [m]

Row = tuple[float, int, fronts.Fill]
"""Row of openings: its share of the height between the rails, the number of its columns, their filling."""


def _upright(blank: Blank) -> ag.Region:
    """Return the region of a leaf without its arch."""
    width, thick = blank.width, blank.thickness
    return ag.Region.centered(width, thick, 0.0).with_(z=(blank.bottom, blank.straight))


def _framed(blank: Blank, stile: ag.Float, rows: Sequence[Row]) -> ag.Body:
    """Make stiles, rails and rows of filling from the bottom up, with the fittings of an entrance."""
    hinged, inner, locked = _upright(blank).across(stile, None, stile)
    free = inner.z.size - _BOTTOM_RAIL - _TOP_RAIL - _LOCK_RAIL * (len(rows) - 1)
    heights: list[ag.Scalar] = [_BOTTOM_RAIL]
    for share, _, _ in rows:
        heights += [free * share, _LOCK_RAIL]
    levels = [inner.with_(z=level) for level in inner.z.split(*heights[:-1], _TOP_RAIL)]
    boards = [each.box(bevel=EASED) for each in (hinged, *levels[::2])]
    if blank.arch is not None:
        boards.append(ag.extrude(blank.arch.segment(), blank.thickness, axis=ag.Y, bevel=EASED))
    fillings: list[ag.Body] = []
    for level, (_, columns, fill) in zip(levels[1::2], rows, strict=True):
        cells = level.columns(columns, gap=_MULLION)
        boards += [a.with_(x=(a.x.high, b.x.low)).box(bevel=EASED) for a, b in pairwise(cells)]
        centers = [cell.center for cell in cells]
        opening = Opening(cells[0].x.size, level.z.size, centers, columns, blank.finish)
        fillings += fill(opening, blank.thickness)
    lock_stile = ag.part(blank.carved(locked.box(bevel=EASED)), "door", blank.finish, push=blank.push)
    letters = levels[2].z.mid if rows[1:] else None
    looks_out = levels[3].z.at(0.80) if rows[1:] and rows[1][1] == 2 else None  # in the mullion
    fittings = _fitted(blank, letters, levels[-1].z.mid, looks_out)
    return ag.weld(lock_stile, ag.part(boards, "door", blank.finish), *fillings, *fittings)


def _plain(blank: Blank) -> list[ag.Body]:
    """Make the fittings of an entrance on a flat leaf."""
    height = _upright(blank).z
    return _fitted(blank, height.at(0.36), height.at(0.86), height.at(0.76))


_GLASS = known("glass", "frosted_glass", "tinted_glass")
_LOCK_STRIP = 0.120  # distance from the lock edge to an upright inlay, clear of the lock [m]
_GLASS_WEIGHTS = (0.6, 0.3, 0.1)[: len(_GLASS)]


@ag.generator
def flush_leaf(
    *,
    blank: Blank,
    inlays: int = ag.choice({0: 0.7, 3: 0.15, 4: 0.15}),
    grain: Literal["upright", "across"] = ag.choice({"upright": 0.75, "across": 0.25}),
) -> ag.Body:
    """Make a flush leaf: one smooth slab with a hollow or particle core."""
    finish = blank.finish if grain == "upright" else across(blank.finish)
    core = finish.with_(name=f"{finish.name}_faced", density=350.0)
    whole, out = _upright(blank), blank.thickness / 2 - 0.0001
    if blank.arch is None:
        slab = whole.box(bevel=0.0015)
    else:
        outline = blank.arch.segment() | whole.front()
        slab = ag.extrude(outline, blank.thickness, axis=ag.Y, bevel=0.0015)
    body = ag.weld(ag.part(blank.carved(slab), "door", core, push=blank.push), *_plain(blank))
    if not inlays:
        return body
    # horizontal inlays end at an upright inlay beside the lock
    long = blank.width - _LOCK_STRIP
    strip, line = ag.box(long, 0.0008, 0.008), ag.box(0.008, 0.0008, blank.upright - 0.004)
    levels = [whole.z.at((at + 0.75) / (inlays + 0.5)) for at in range(inlays)]
    places = [(-_LOCK_STRIP / 2 + 0.001, side * out, z) for z in levels for side in (-1, 1)]
    beside = [(blank.width / 2 - _LOCK_STRIP, side * out, blank.waist) for side in (-1, 1)]
    bars = [ag.array(strip, at=places), ag.array(line, at=beside)]
    return ag.weld(body, ag.detail(bars, "door", ag.material("aluminium")))


@ag.generator
def plank_leaf(
    *,
    blank: Blank,
    boards: int = ag.choice({4: 1, 5: 3, 6: 3, 7: 1}),
    joint: ag.Float = ag.uniform(0.0025, 0.0045, "m", doc="edge radius that makes the V between boards"),
) -> ag.Body:
    """Make a boarded leaf: upright tongue-and-groove boards with a V at every joint."""
    *rest, beside = (each.box(bevel=joint) for each in _upright(blank).columns(boards))
    lock_board = ag.part(blank.carved(beside), "door", blank.finish, push=blank.push)
    bodies = [ag.part(rest, "door", blank.finish), lock_board]
    if blank.arch is not None:
        head = ag.extrude(blank.arch.segment(), blank.thickness, axis=ag.Y, bevel=EASED)
        bodies.append(ag.part(head, "door", across(blank.finish)))
    return ag.weld(*bodies, *_plain(blank))


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
    relief: fronts.Relief = ag.choice("raised", "recessed"),
    sticking: fronts.Sticking = ag.by(
        "relief",
        raised=ag.choice("ogee", "ovolo"),
        recessed={"ogee": 0.25, "ovolo": 0.25, "square": 0.5},
        doc="molding around the panels; square is the shaker door",
    ),
    stile: ag.Float = ag.uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
    moulding: ag.Float = ag.uniform(0.010, 0.016, "m", doc="reach of the molding into a panel"),
) -> ag.Body:
    """Make a leaf of stiles and rails with panels between them."""
    panel = partial(fronts.panels_in, relief=relief, moulding=moulding, sticking=sticking)
    return _framed(blank, stile, [(share, columns, panel) for share, columns in _ROWS[panels]])


@ag.generator
def glazed_leaf(
    *,
    blank: Blank,
    columns: int = ag.choice({1: 0.4, 2: 0.3, 3: 0.3}),
    lights: int = ag.choice({1: 0.4, 4: 0.3, 5: 0.3}, doc="number of panes, one above the other"),
    glass: ag.Material = ag.choice(*_GLASS, weights=_GLASS_WEIGHTS),
    stile: ag.Float = ag.uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> ag.Body:
    """Make a glazed leaf: one pane in beads, divided by muntins."""
    pane = partial(fronts.panes_in, columns=columns, lights=lights, glass=glass)
    return _framed(blank, stile, [(1.0, 1, pane)])


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
    panel = partial(fronts.panels_in, relief="raised", moulding=0.012, sticking="ogee")
    pane = partial(fronts.panes_in, columns=columns, lights=lights, glass=glass)
    return _framed(blank, stile, [(0.42, panels, panel), (0.58, 1, pane)])


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
    louver = partial(fronts.slats_in, slats=slats)
    panel = partial(fronts.panels_in, relief="recessed", moulding=0.012, sticking="ovolo")
    return _framed(blank, stile, [(0.45, 1, louver if below == "louver" else panel), (0.55, 1, louver)])


LEAVES = {
    "interior": ag.one_of(flush_leaf, panel_leaf, louver_leaf, plank_leaf, weights=(0.3, 0.42, 0.16, 0.12)),
    "exterior": ag.one_of(
        panel_leaf, glazed_leaf, half_lite_leaf, plank_leaf, weights=(0.32, 0.25, 0.28, 0.15)
    ),
}
"""Leaves by the use of a door."""
