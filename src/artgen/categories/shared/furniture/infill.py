"""Fillings of the openings between stiles and rails: panels, panes and slats, with moldings.

All parts are made about the origin and copied to the openings, in the middle plane y = 0.
"""

import math
from collections.abc import Callable, Sequence
from typing import Literal, NamedTuple

import artgen as ag

_PANE = 0.005  # thickness of toughened glass [m]
_BOARDS = 3  # number of boards from which the slats of a section are cut
# thickness of a board behind slats, and of a board with the mass of the slats [m]
_CORE, _SLATS = 0.004, 0.009
_BEVEL = 0.055  # width of the bevels of a fielded panel, molding included [m]


Relief = Literal["raised", "recessed"]
"""Panels with raised fields, or flat panels in their grooves."""

Sticking = Literal["ogee", "ovolo", "square", "ramp"]
"""Molding around panels: an S, a quarter round, none, or a plain slope down to the panel."""


class Opening(NamedTuple):
    """The openings of a row, all of one size."""

    width: ag.Scalar  # width of an opening [m]
    height: ag.Scalar  # height of an opening [m]
    centers: Sequence[ag.VectorLike]  # centers of the openings [m]
    columns: int  # number of openings
    finish: ag.Material  # finish of the surrounding frame
    label: str = "door"  # semantic label of the leaf

    def everywhere(self, solid: ag.Solid) -> ag.Solid:
        """Return copies of a solid, made about the origin, in all openings."""
        return ag.array(solid, at=self.centers)


Fill = Callable[[Opening, ag.Scalar], list[ag.Body]]
"""A function that makes the filling of the openings of a row in a leaf of some thickness [m]."""


_SECTIONS: dict[str, tuple[tuple[float, float], ...]] = {
    # shares of the reach and of the depth of a molding, from the panel up to the face of the frame
    "ogee": (
        (1.0, 0.84), (0.93, 0.84), (0.90, 0.76), (0.80, 0.70), (0.69, 0.655), (0.58, 0.60), (0.48, 0.51),
        (0.40, 0.40), (0.33, 0.28), (0.26, 0.19), (0.17, 0.13), (0.10, 0.11), (0.10, 0.05),
    ),
    "ovolo": (
        (1.0, 0.80), (0.90, 0.80), (0.90, 0.72), (0.885, 0.58), (0.84, 0.45), (0.765, 0.33), (0.66, 0.23),
        (0.54, 0.16), (0.40, 0.12), (0.26, 0.11), (0.26, 0.05),
    ),
    "ramp": ((1.0, 0.93), (0.02, 0.05)),
    "bead": ((1.0, 0.55), (0.97, 0.47), (0.88, 0.40), (0.62, 0.30), (0.40, 0.17), (0.32, 0.09), (0.32, 0.05)),
}  # fmt: skip


def _sticking(
    opening: Opening, thickness: ag.Scalar, depth: ag.Scalar, reach: ag.Scalar, style: str
) -> list[ag.Body]:
    """Make the molding around the openings on both faces, down to the filling."""
    corners = [(out * reach, -down * depth) for out, down in _SECTIONS[style]]
    last = -_SECTIONS[style][-1][1] * depth
    # union with its foot: a union is smooth at obtuse corners
    foot = ag.rectangle(reach + 0.0005, 0.2 * depth).at(reach / 2.0 - 0.00025, -0.9 * depth)
    section = ag.polygon([(-0.0005, last), (-0.0005, -depth), (reach, -depth), *corners]) | foot
    x, z = opening.width / 2.0, opening.height / 2.0
    ring = ag.polyline([(-x, -z, 0.0), (x, -z, 0.0), (x, z, 0.0), (-x, z, 0.0)], closed=True)
    # swept on the floor, with the section's y up, then rotated upright: up becomes the front
    front = ag.sweep(section, ring).rotate(ag.X, math.pi / 2.0).at(0.0, -thickness / 2.0, 0.0)
    faces = (front, front.rotate(ag.Z, math.pi))
    return [ag.detail(opening.everywhere(face), opening.label, opening.finish) for face in faces]


def panels_in(
    opening: Opening, thickness: ag.Scalar, relief: Relief, moulding: ag.Scalar, sticking: Sticking
) -> list[ag.Body]:
    """Make the panels of a row with their moldings; each panel is a separate board."""
    width, height = opening.width - 0.0006, opening.height - 0.0006
    tongue = 0.25 * thickness  # 9-11 mm are in the groove
    panel = ag.box(width, tongue, height)
    if relief == "raised":
        # fielded on both faces: bevels rise from the groove to a field 4 mm below the faces of the leaf
        run = 2.0 * ag.min_(_BEVEL, 0.3 * ag.min_(width, height))
        field = ag.box(width - run, thickness - 0.008, height - run)
        panel = ag.hull(panel, field)
    bodies = [ag.part(panel.at(center), opening.label, opening.finish) for center in opening.centers]
    if sticking == "square":
        return bodies
    return bodies + _sticking(opening, thickness, (thickness - tongue) / 2.0, moulding, sticking)


def panes_in(
    opening: Opening,
    thickness: ag.Scalar,
    columns: int,
    lights: int,
    glass: ag.Material,
    *,
    pane: float = _PANE,
) -> list[ag.Body]:
    """Make a pane in its beads, and the muntins over it."""
    width, height = opening.width - 0.002, opening.height - 0.002
    bodies = [
        ag.part(opening.everywhere(ag.box(width, pane, height)), "glass", glass),
        *_sticking(opening, thickness, (thickness - pane) / 2.0, 0.013, "bead"),
    ]
    center = opening.centers[0]
    for number, across in ((columns, True), (lights, False)):
        if number < 2:
            continue
        pitch = (opening.width if across else opening.height) / number
        soft = ag.min_(0.005, 0.45 * (thickness - 0.009))  # doors of cabinets are thin
        bar = (
            ag.box(0.022, thickness - 0.008, opening.height, bevel=soft)
            if across
            else ag.box(opening.width, thickness - 0.009, 0.022, bevel=soft)
        )
        places = [
            ((at - number / 2.0) * pitch, 0.0, 0.0) if across else (0.0, 0.0, (at - number / 2.0) * pitch)
            for at in range(1, number)
        ]
        bodies.append(ag.part(ag.array(bar, at=places).at(center), opening.label, opening.finish))
    return bodies


def slats_in(opening: Opening, thickness: ag.Scalar, slats: int, *, joined: bool = False) -> list[ag.Body]:
    """Make overlapping slats: each begins at the height of the end of the last, which blocks the view."""
    pitch = opening.height / slats
    depth = thickness - 0.010
    rise = 0.98 * pitch
    plank = 0.008  # half-round edges, with the same reach at every tilt
    out, up = depth - plank, rise - plank
    slat = ag.box(opening.width, ag.sqrt(out * out + up * up) + plank, plank, bevel=plank / 2.0)
    places = [
        (0.0, 0.0, (at - (slats - 1) / 2.0) * (opening.height - rise) / (slats - 1)) for at in range(slats)
    ]
    # the outer edge is the lower one, against rain and view
    tilted = slat.rotate(ag.X, ag.atan2(up, out))
    if joined:
        core = ag.box(opening.width, _CORE, opening.height).at(opening.centers[0])
        finish = opening.finish
        heavy = finish.with_(name=f"{finish.name}_slats", density=_SLATS * finish.density / _CORE)
        field = ag.array(tilted, at=places).at(opening.centers[0])
        return [ag.part(core, opening.label, heavy), ag.detail(field, opening.label, finish)]
    # neighbors belong to different boards
    return [
        ag.part(
            ag.array(tilted, at=places[first::_BOARDS]).at(opening.centers[0]), opening.label, opening.finish
        )
        for first in range(_BOARDS)
    ]
