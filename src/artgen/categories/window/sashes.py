"""Sashes: rings of a real section with their glass, glazing beads and bars; a ring has the label `pane`."""

from dataclasses import dataclass

import artgen as ag
from artgen.categories.shared.furniture.infill import Opening, panes_in
from artgen.categories.window.plan import LIP, REBATE, SEALED, Rect, Section, ring_of

PANE = 0.012
"""Thickness of an insulating glass as it is built [m]; it weighs what its panes do."""

_SHEET = 0.004  # thickness of a sheet of glass [m]


@dataclass(frozen=True)
class Glazing:
    """What fills sashes."""

    glass: ag.Material  # its looks
    sheets: int  # 2 for insulating glass, 1 for a single sheet
    columns: int  # bars that stand upright on it
    rows: int  # bars that lie across it
    finish: ag.Material  # of the ring, the beads and the bars

    def within(self, width: ag.Scalar, height: ag.Scalar, thickness: ag.Scalar) -> list[ag.Body]:
        """Fill a ring about the origin, whose middle plane is y = 0."""
        heavy = self.glass.density * _SHEET * self.sheets / PANE
        glass = self.glass.with_(name=f"{self.glass.name}_{self.sheets}_sheets", density=heavy)
        opening = Opening(width, height, [(0.0, 0.0, 0.0)], 1, self.finish, "pane")
        return panes_in(opening, thickness, self.columns + 1, self.rows + 1, glass, pane=PANE)


def lipped_sash(
    width: ag.Scalar,
    height: ag.Scalar,
    section: Section,
    glazing: Glazing,
    *,
    push: ag.Frame | None = None,
) -> ag.Body:
    """Make a sash that closes an opening about the origin: its lip stands in front of the frame at y = 0."""
    face, front = section.sash, SEALED + section.lip
    over = REBATE + LIP
    wide, high = width - 2.0 * REBATE, height - 2.0 * REBATE
    chamfer = 0.006
    outline = [
        (0.0, -section.depth),
        (face, -section.depth),
        (face, front - chamfer),
        (face - chamfer, front),
        (-over, front),
        (-over, SEALED),
        (0.0, SEALED),
    ]
    wide, high = width - 2.0 * REBATE, height - 2.0 * REBATE
    filled = [
        Rect(-over, face - chamfer, SEALED, front),
        Rect(0.0, face, -section.depth, front - chamfer),
    ]
    thick = section.depth + front
    middle = (section.depth - front) / 2.0
    ring = ring_of(
        ag.polygon(outline, radius=section.eased),
        filled,
        wide,
        high,
        "pane",
        glazing.finish,
        eased=section.eased,
        push=push,
    )
    panes = glazing.within(wide - 2.0 * face, high - 2.0 * face, thick)
    return ag.weld(ring, *(each.at(0.0, middle, 0.0) for each in panes))


def plain_sash(
    width: ag.Scalar,
    height: ag.Scalar,
    section: Section,
    glazing: Glazing,
    *,
    push: ag.Frame | None = None,
) -> ag.Body:
    """Make a sash that slides in its track, about the origin."""
    face, half = slide_face(section), section.slide / 2.0
    ring = ring_of(
        ag.rectangle(face, section.slide, radius=section.eased).at(face / 2.0),
        [Rect(0.0, face, -half, half)],
        width,
        height,
        "pane",
        glazing.finish,
        eased=section.eased,
        push=push,
    )
    return ag.weld(ring, *glazing.within(width - 2.0 * face, height - 2.0 * face, section.slide))


def slide_face(section: Section) -> float:
    """Return the face of stiles and rails of a sash that slides, slimmer than that of a hinged one [m]."""
    return 0.92 * section.sash
