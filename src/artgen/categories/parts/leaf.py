"""Door leaves: flush, panelled, glazed, louvred and half glazed.

A leaf stands in the X-Z plane, in place above the floor: it is centred in x, its faces are at
y = -thickness / 2 and y = thickness / 2, its lock edge is at x = width / 2. Framed leaves are made as joiners
make them, of stiles that run through and rails between them; each board has its own grain.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from artgen import (
    Body,
    Float,
    Material,
    Solid,
    Y,
    Z,
    array,
    box,
    by,
    choice,
    count,
    cylinder,
    detail,
    extrude,
    generator,
    material,
    part,
    rectangle,
    uniform,
    weld,
)
from artgen.categories.parts.arch import Arch
from artgen.categories.parts.infill import Fill, Opening, panels_in, panes_in, slats_in
from artgen.nodes.handles import Scalar

EASED = 0.0008
"""Edges of boards are sanded to this radius [m]: joints show as a fine line."""

_TOP_RAIL = 0.115  # [m]
_BOTTOM_RAIL = 0.200  # the kick rail is the widest [m]
_LOCK_RAIL = 0.120  # between rows [m]
_MULLION = 0.085  # between columns [m]

_GLASS = (material("glass"), material("frosted_glass"))

ASTRAGAL_GAP = 0.002
"""Between the active leaf and the strip behind it [m]."""


@dataclass(frozen=True)
class Blank:
    """What every leaf has in common.

    Attributes:
        width: [m].
        bottom: Height of its bottom above the floor [m].
        top: Height of its top above the floor, of the crown of an arch [m].
        thickness: [m].
        rise: Rise of an arched top over its ends [m]; None for a straight one.
        cut: What the hardware needs taken out of the lock stile; None for nothing.
        finish: What the leaf is made of.
    """

    width: Float
    bottom: Float
    top: Float
    thickness: Float
    rise: Float | None
    cut: Solid | None
    finish: Material

    @property
    def straight(self) -> Scalar:
        """The height above the floor to which its edges are straight [m]."""
        return self.top if self.rise is None else self.top - self.rise

    @property
    def arch(self) -> Arch | None:
        """The arch of its top, if any."""
        return None if self.rise is None else Arch.over(self.width, spring=self.straight, rise=self.rise)

    @property
    def upright(self) -> Scalar:
        """The length of its edges [m]."""
        return self.straight - self.bottom

    @property
    def waist(self) -> Scalar:
        """The height of the middle of its edges above the floor [m]."""
        return (self.straight + self.bottom) / 2.0

    def carved(self, solid: Solid) -> Solid:
        """Return a solid without what the hardware needs."""
        return solid if self.cut is None else solid - self.cut

    def board(self, x: Scalar, z: Scalar) -> Solid:
        """Make a board as thick as the leaf about the origin."""
        return box(x, self.thickness, z, bevel=EASED)


class Row(NamedTuple):
    """A row of openings between two rails.

    Attributes:
        share: Its part of the height that the rails leave.
        columns: Openings side by side.
        fill: What fills them.
    """

    share: float
    columns: int
    fill: Fill


@generator
def flush_leaf(*, blank: Blank, inlays: int = choice(0, 3, 4, weights=(0.7, 0.15, 0.15))) -> Body:
    """Make a flush leaf: one smooth slab with a hollow or particle core.

    Args:
        blank: Its measures.
        inlays: Strips of aluminium across the faces.
    """
    core = blank.finish.with_(name=f"{blank.finish.name}_faced", density=350.0)
    if blank.arch is None:
        slab = box(blank.width, blank.thickness, blank.upright, bevel=0.0015).at(0.0, 0.0, blank.waist)
    else:
        outline = blank.arch.segment() | rectangle(blank.width, blank.upright).at(0.0, blank.waist)
        slab = extrude(outline, blank.thickness, axis=Y, bevel=0.0015)
    body = part(blank.carved(slab), "door", core)
    if not inlays:
        return body
    strip = box(blank.width - 0.004, blank.thickness + 0.0004, 0.008)
    shares = [(index + 0.75) / (inlays + 0.5) for index in range(inlays)]
    levels = [(0.0, 0.0, blank.bottom + blank.upright * share) for share in shares]
    return weld(body, detail(array(strip, at=levels), "door", material("aluminium")))


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
"""Rows of panels from the bottom up, with their share of the height and their columns."""


@generator
def panel_leaf(
    *,
    blank: Blank,
    panels: int = count(1, 8, weights=(1, 3, 1, 3, 2, 4, 1, 1), doc="6 is the colonial door"),
    relief: Literal["raised", "recessed"] = choice("raised", "recessed"),
    stile: Float = uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
    moulding: Float = uniform(0.010, 0.016, "m", doc="how far the sticking reaches into a panel"),
) -> Body:
    """Make a leaf of stiles and rails with panels between them.

    Args:
        blank: Its measures.
        panels: How many panels.
        relief: Whether the panels' fields stand out of their grooves or lie flat in them.
        stile: Width of the stiles [m].
        moulding: Width of the moulding around the panels [m].
    """

    def panel(opening: Opening, thickness: Scalar) -> list[Body]:
        return panels_in(opening, thickness, relief, moulding)

    rows = [Row(share, columns, panel) for share, columns in _ROWS[panels]]
    return _framed(blank, stile, rows)


@generator
def glazed_leaf(
    *,
    blank: Blank,
    columns: int = choice(1, 2, 3, weights=(0.4, 0.3, 0.3)),
    lights: int = choice(1, 4, 5, weights=(0.4, 0.3, 0.3), doc="panes above each other"),
    glass: Material = choice(*_GLASS, weights=(0.7, 0.3)),
    stile: Float = uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> Body:
    """Make a glazed leaf: one pane in beads, divided by muntins.

    Args:
        blank: Its measures.
        columns: Panes side by side.
        lights: Panes above each other.
        glass: Clear or frosted glass.
        stile: Width of the stiles [m].
    """

    def pane(opening: Opening, thickness: Scalar) -> list[Body]:
        return panes_in(opening, thickness, columns, lights, glass)

    return _framed(blank, stile, [Row(1.0, 1, pane)])


@generator
def half_lite_leaf(
    *,
    blank: Blank,
    columns: int = choice(1, 2, 3),
    lights: int = choice(1, 2, 3),
    glass: Material = choice(*_GLASS, weights=(0.7, 0.3)),
    panels: int = choice(1, 2),
    stile: Float = uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> Body:
    """Make a leaf with a window above and panels below.

    Args:
        blank: Its measures.
        columns: Panes side by side.
        lights: Panes above each other.
        glass: Clear or frosted glass.
        panels: Panels side by side below.
        stile: Width of the stiles [m].
    """

    def panel(opening: Opening, thickness: Scalar) -> list[Body]:
        return panels_in(opening, thickness, "raised", 0.012)

    def pane(opening: Opening, thickness: Scalar) -> list[Body]:
        return panes_in(opening, thickness, columns, lights, glass)

    return _framed(blank, stile, [Row(0.42, panels, panel), Row(0.58, 1, pane)])


@generator
def louver_leaf(
    *,
    blank: Blank,
    below: Literal["louver", "panel"] = choice("louver", "panel"),
    # each slat is a collider: two sections and a leaf's hardware stay below 64
    slats: int = by("below", louver=count(9, 10), panel=count(15, 18), doc="in one section", within=(6, 24)),
    stile: Float = uniform(0.106, 0.115, "m", within=(0.1, 0.16)),
) -> Body:
    """Make a louvred leaf: slats tilted by about 40 degrees that hide what is behind.

    Args:
        blank: Its measures.
        below: What fills the lower section.
        slats: Slats in each section.
        stile: Width of the stiles [m].
    """

    def louver(opening: Opening, thickness: Scalar) -> list[Body]:
        return slats_in(opening, thickness, slats)

    def panel(opening: Opening, thickness: Scalar) -> list[Body]:
        return panels_in(opening, thickness, "recessed", 0.012)

    lower = louver if below == "louver" else panel
    return _framed(blank, stile, [Row(0.45, 1, lower), Row(0.55, 1, louver)])


def _framed(blank: Blank, stile: Float, rows: Sequence[Row]) -> Body:
    """Make stiles and rails, and fill what is between them; rows count from the bottom."""
    straight, finish = blank.straight, blank.finish
    upright = blank.board(stile, blank.upright)
    beside = (blank.width - stile) / 2.0
    bodies = [
        part(blank.carved(upright.at(beside, 0.0, blank.waist)), "door", finish),
        part(upright.at(-beside, 0.0, blank.waist), "door", finish),
    ]
    inner = blank.width - 2.0 * stile
    if blank.arch is not None:
        head = extrude(blank.arch.segment(), blank.thickness, axis=Y, bevel=EASED)
        bodies.append(part(head, "door", finish))
    free = blank.upright - _BOTTOM_RAIL - _TOP_RAIL - _LOCK_RAIL * (len(rows) - 1)
    level: Scalar = blank.bottom
    fillings: list[Body] = []
    for index, row in enumerate(rows):
        rail = _LOCK_RAIL if index else _BOTTOM_RAIL
        bodies.append(part(blank.board(inner, rail).at(0.0, 0.0, level + rail / 2.0), "door", finish))
        level = level + rail
        tall = free * row.share
        opening = _columns(inner, tall, level + tall / 2.0, row.columns, finish)
        if row.columns > 1:
            pitch = opening.width + _MULLION
            places = [
                ((at - row.columns / 2.0) * pitch, 0.0, level + tall / 2.0) for at in range(1, row.columns)
            ]
            bodies.append(part(array(blank.board(_MULLION, tall), at=places), "door", finish))
        fillings += row.fill(opening, blank.thickness)
        level = level + tall
    bodies.append(
        part(blank.board(inner, _TOP_RAIL).at(0.0, 0.0, straight - _TOP_RAIL / 2.0), "door", finish)
    )
    return weld(*bodies, *fillings)


def _columns(inner: Scalar, tall: Scalar, middle: Scalar, columns: int, finish: Material) -> Opening:
    """Return the openings of a row between the stiles."""
    wide = (inner - _MULLION * (columns - 1)) / columns
    pitch = wide + _MULLION
    centers = [((at - (columns - 1) / 2.0) * pitch, 0.0, middle) for at in range(columns)]
    return Opening(wide, tall, centers, columns, finish)


@generator
def finger_plate(*, thickness: Float, finish: Material, height: Float = uniform(0.28, 0.38, "m")) -> Body:
    """Make the plates on both faces of a leaf without a handle, where hands push it; weld them to it.

    Args:
        thickness: Thickness of the leaf [m].
        finish: Their metal.
        height: Height of a plate [m].
    """
    plate = box(0.075, 0.0016, height, bevel=0.0006).at(0.0, thickness / 2.0 + 0.0004, 0.0)
    screws = [
        detail(
            cylinder(0.0032, 0.0008, axis=Y, bevel=0.0002).at(
                x * 0.030, side * (thickness / 2.0 + 0.0012), z * (height / 2.0 - 0.008)
            ),
            "screw",
            finish,
        )
        for side in (-1, 1)
        for x in (-1, 1)
        for z in (-1, 1)
    ]
    return weld(part(plate, "plate", finish), part(plate.rotate(Z, math.pi), "plate", finish), *screws)


def astragal(blank: Blank, gap: Scalar) -> Body:
    """Make the strip on the back of the inactive leaf that the active one closes against.

    Args:
        blank: The inactive leaf; its meeting edge is at x = width / 2.
        gap: Between the leaves [m].
    """
    wide, deep = 0.040, 0.012
    strip = box(wide, deep - ASTRAGAL_GAP, blank.upright - 0.06, bevel=0.002)
    foot = box(wide / 2.0 - gap / 2.0 - 0.002, ASTRAGAL_GAP + 0.002, blank.upright - 0.07)
    back = blank.thickness / 2.0
    edge = blank.width / 2.0
    strip = strip.align((edge + gap / 2.0, back + ASTRAGAL_GAP, blank.waist), y=-1.0)
    foot = foot.align((edge, back - 0.001, blank.waist), x=1.0, y=-1.0)
    return weld(part(strip, "door", blank.finish), part(foot, "door", blank.finish))
