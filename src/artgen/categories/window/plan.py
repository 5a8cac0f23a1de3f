"""Common dimensions of windows: sections of frames and sashes, their finishes, and rings of these sections.

A window is modeled about the middle of its opening: x to the right, z up, and y = 0 in the front plane of the
frame, on the side to which sashes open (-y). `Section` corresponds to one line of a maker's catalog.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import artgen as ag
from artgen.categories.shared.finish import OUTDOORS, known, paints, weighing

Kind = Literal["wood", "pvc", "aluminium"]
"""Material of frames."""

SEAM = 0.00003
"""Gap between adjacent boards [m]."""

LIP = 0.0075
"""Overlap of the lip of a sash with the frame around it [m]."""

REBATE = 0.0115
"""Gap between the edge of a sash and its frame, for cams and keeps: 12 mm in the eurogroove [m]."""

SEALED = 0.0035
"""Gap between the lip of a sash and the frame, filled by a seal [m]."""


@dataclass(frozen=True)
class Section:
    """Sections of a window system."""

    frame: float  # width of the face of the frame [m]
    sash: float  # width of a sash, from its edge to the glass [m]
    depth: float  # distance from the front plane of the frame to the back of a sash in it [m]
    lip: float  # thickness of the lip of a sash, in front of the frame [m]
    slide: float  # thickness of a sliding sash [m]
    eased: float  # radius of edges [m]

    @property
    def stop(self) -> float:
        """Position of the front of the stop behind a closed sash, along y [m]."""
        return self.depth + 0.004

    @property
    def back(self) -> float:
        """Position of the back of the frame of hinged sashes, along y [m]."""
        return self.stop + 0.014


SECTIONS: dict[Kind, Section] = {
    "wood": Section(0.056, 0.054, 0.052, 0.0140, 0.042, 0.0025),  # 68 mm timber of IV68
    "pvc": Section(0.060, 0.056, 0.054, 0.0160, 0.044, 0.0035),  # 70 mm five-chamber systems
    "aluminium": Section(0.048, 0.046, 0.046, 0.0120, 0.036, 0.0010),  # slim systems with a thermal break
}
"""Sections by the material of the frame."""

STOP = 0.018
"""Projection of stops into an opening [m]."""


def _hollow(made: ag.Material, density: float) -> ag.Material:
    """Return a chambered profile: 2.0-2.4 kg/m of PVC with steel inside, 1.7 kg/m of aluminum."""
    return made.with_(name=f"{made.name}_profile", density=density)


_TIMBER = known("oak", "pine", "mahogany", "ash", "walnut")

WOODS = (*_TIMBER, *paints(500.0, "window_paint"))
"""Clear and painted timber."""

WOOD_WEIGHTS = (*(1.6,) * len(_TIMBER), *(0.7 * each for each in OUTDOORS))

PLASTICS = tuple(
    _hollow(ag.colored("abs", color), 560.0)
    for color in ("white", "cream", "anthracite", "light_grey", "brown")
)
"""White PVC, and PVC under a colored foil."""

PLASTIC_WEIGHTS = (4.0, 1.0, 1.6, 0.8, 1.0)

METALS = (
    *(
        _hollow(ag.colored("powder_coat", c), 640.0)
        for c in ("anthracite", "black", "white", "slate", "forest", "burgundy")
    ),
    _hollow(ag.material("brushed_aluminium"), 640.0),
    _hollow(ag.material("aged_bronze"), 640.0),
)
"""Coated or anodized aluminum."""

METAL_WEIGHTS = (4.0, 2.0, 1.5, 1.0, 0.5, 0.3, 1.5, 0.7)

_SHEETS = tuple(
    _hollow(ag.colored("powder_coat", color), 640.0) for color in ("silver", "white", "anthracite")
)

SILLS = (*weighing(known("granite", "marble"), 2700.0, "sill"), *_SHEETS)
"""Stone and folded sheet for sills."""

SILL_WEIGHTS = (1.0, 0.7, 1.2, 1.5, 1.0)


def ring_along(section: ag.Profile, width: ag.Scalar, height: ag.Scalar) -> ag.Solid:
    """Sweep a section around a rectangle about the origin, with mitered corners."""
    x, z = width / 2.0, height / 2.0
    course = ag.polyline([(-x, -z, 0.0), (x, -z, 0.0), (x, z, 0.0), (-x, z, 0.0)], closed=True)
    # swept on the floor, with the section's y up, then rotated upright: up becomes the front
    return ag.sweep(section, course).rotate(ag.X, math.pi / 2.0)


class Rect(NamedTuple):
    """A rectangle of a section, from the edge of a ring to its middle, and from the back to the front [m]."""

    outer: ag.Scalar
    inner: ag.Scalar
    back: ag.Scalar
    front: ag.Scalar


_THINNER = 0.0001  # difference in depth between rails and stiles [m]


def under(eased: float) -> float:
    """Return the depth of boards under the surface of a ring with edges rounded by a radius [m]."""
    return 0.3 * eased + 0.0002


def ring_of(
    section: ag.Profile,
    filled: Sequence[Rect],
    width: ag.Scalar,
    height: ag.Scalar,
    label: str,
    finish: ag.Material,
    *,
    eased: float,
    name: str | None = None,
    push: ag.Frame | None = None,
) -> ag.Body:
    """Make a visible mitered ring, over boards just under its surface that have the mass and collide."""
    inside = under(eased)
    boards = []
    for rect in filled:
        outer, inner = rect.outer + inside, rect.inner - inside
        back, front = -rect.back - inside, -rect.front + inside
        x, z = width / 2.0, height / 2.0
        # rails between the stiles are a little thinner: boards must not share corners
        stile = ag.Region.between((outer - x, front, outer - z), (inner - x, back, z - outer)).box()
        rail = ag.Region.between(
            (inner - x + SEAM, front + _THINNER, outer - z + _THINNER),
            (x - inner - SEAM, back - _THINNER, inner - z),
        ).box()
        boards += [stile, stile.mirror(ag.X), rail.mirror(ag.Z), rail]
    first = ag.part(boards[0], label, finish, name=name)
    rest = [ag.part(board, label, finish) for board in boards[1:-1]]
    last = ag.part(boards[-1], label, finish, push=() if push is None else push)
    return ag.weld(first, *rest, last, ag.detail(ring_along(section, width, height), label, finish))
