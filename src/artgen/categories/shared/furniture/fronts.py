"""Fronts of furniture: flat, shaker, ramped or glazed, as doors of cabinets and as fronts of drawers."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.shared.furniture.door_slab import EASED
from artgen.categories.shared.furniture.infill import Opening, Sticking, panels_in, panes_in

FrontStyle = Literal["flat", "beaded", "shaker", "ramped", "fielded", "glazed"]
"""A flat slab; a slab with a bead around it; a frame around a flat panel, plain or molded; a frame that
slopes down to the panel; a panel with a raised field; a frame around a pane."""


@dataclass(frozen=True)
class FrontLook:
    """Style and dimensions of fronts."""

    style: FrontStyle  # style of the front
    finish: ag.Material  # material of the front
    rail: ag.Scalar  # width of stiles and rails [m]
    moulding: Sticking  # molding at the edge of the frame around a shaker panel
    slope: ag.Scalar  # width of the slope of a ramped front [m]
    glass: ag.Material  # material of the pane of a glazed front
    panes: tuple[int, int] = (1, 1)  # numbers of panes side by side, and one above the other

    @property
    def framed(self) -> bool:
        """Whether handles are on a panel that lies behind rails and stiles."""
        return self.style in ("shaker", "ramped")

    def sunk(self, thickness: ag.Scalar) -> ag.Scalar:
        """Return the depth of the middle of a front behind its face, at the base of handles [m]."""
        return 0.375 * thickness if self.framed else 0.0


def front(
    look: FrontLook,
    width: ag.Scalar,
    height: ag.Scalar,
    thickness: ag.Scalar,
    *,
    label: str,
    name: str | None = None,
) -> list[ag.Body]:
    """Make a front in the x-z plane, with the origin in its middle."""
    if look.style in ("flat", "beaded"):
        slab = ag.part(ag.box(width, thickness, height, bevel=0.0014), label, look.finish, name=name)
        return (
            [slab, ag.detail(_bead(width, height, thickness), label, look.finish)]
            if look.style == "beaded"
            else [slab]
        )
    rail = look.rail
    narrow = ag.min_(rail, 0.27 * height)  # rails of a low drawer leave space for its panel
    stile = ag.box(rail, thickness, height, bevel=EASED)
    beam = ag.box(width - 2 * rail, thickness, narrow, bevel=EASED)
    boards: list[ag.Solid] = [
        *(stile.at(way * (width - rail) / 2, 0.0, 0.0) for way in (-1, 1)),
        *(beam.at(0.0, 0.0, way * (height - narrow) / 2) for way in (-1, 1)),
    ]
    first, *others = boards
    opening = Opening(width - 2 * rail, height - 2 * narrow, [(0.0, 0.0, 0.0)], 1, look.finish, label)
    match look.style:
        case "glazed":
            filling = panes_in(opening, thickness, *look.panes, look.glass)
        case "ramped":
            slope = ag.min_(look.slope, 0.3 * ag.min_(opening.width, opening.height))
            filling = panels_in(opening, thickness, "recessed", slope, "ramp")
        case "fielded":
            filling = panels_in(opening, thickness, "raised", 0.008, "ovolo")
        case _:
            filling = panels_in(opening, thickness, "recessed", 0.009, look.moulding)
    return [
        ag.part(first, label, look.finish, name=name),
        *(ag.part(each, label, look.finish) for each in others),
        *filling,
    ]


def _bead(width: ag.Scalar, height: ag.Scalar, thickness: ag.Scalar) -> ag.Solid:
    """Make a half-round bead around the face of a slab, with a height of 2 mm."""
    ring = ag.rectangle(width - 0.004, height - 0.004) - ag.rectangle(width - 0.018, height - 0.018)
    return ag.extrude(ring, 0.006, axis=ag.Y, bevel=0.0028).at(0.0, 0.001 - thickness / 2, 0.0)
