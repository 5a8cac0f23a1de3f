"""What fills the openings between the stiles and rails of a leaf: panels, panes and slats, with mouldings.

Everything is made about the origin and copied to the openings, whose middle plane is y = 0.
"""

import math
from collections.abc import Callable, Sequence
from typing import Literal, NamedTuple

from artgen import (
    Body,
    Material,
    Solid,
    X,
    Y,
    Z,
    array,
    atan2,
    box,
    detail,
    extrude,
    min_,
    part,
    polygon,
    polyline,
    sqrt,
    sweep,
)
from artgen.nodes.handles import Scalar, VectorLike

_PANE = 0.005  # toughened glass [m]
_BEVEL = 0.055  # width of the bevels of a fielded panel, moulding included [m]


class Opening(NamedTuple):
    """The openings of a row, all of one size.

    Attributes:
        width: [m].
        height: [m].
        centers: Where their centres are [m].
        columns: How many there are.
        finish: What surrounds them.
    """

    width: Scalar
    height: Scalar
    centers: Sequence[VectorLike]
    columns: int
    finish: Material

    def everywhere(self, solid: Solid) -> Solid:
        """Return copies of a solid, made about the origin, in all openings."""
        return array(solid, at=self.centers)


Fill = Callable[[Opening, Scalar], list[Body]]
"""Makes what fills the openings of a row in a leaf of some thickness [m]."""


def _sticking(opening: Opening, thickness: Scalar, depth: Scalar, reach: Scalar) -> Body:
    """Make the moulding around the openings on both faces: a fillet, a cove and a bead down to the filling.

    Args:
        opening: What it surrounds.
        thickness: Of the leaf [m].
        depth: How far below the face the filling lies [m].
        reach: How far the moulding covers the filling [m].
    """
    section = polygon(
        [
            (-0.0005, -depth),
            (reach, -depth),
            (reach, -0.80 * depth),
            (0.80 * reach, -0.66 * depth),
            (0.58 * reach, -0.58 * depth),
            (0.40 * reach, -0.42 * depth),
            (0.30 * reach, -0.16 * depth),
            (0.24 * reach, -0.08 * depth),
            (-0.0005, -0.08 * depth),
        ]
    )
    x, z = opening.width / 2.0, opening.height / 2.0
    ring = polyline([(-x, -z, 0.0), (x, -z, 0.0), (x, z, 0.0), (-x, z, 0.0)], closed=True)
    # swept on the floor, where the section's y is up, then stood up: up becomes the front
    front = sweep(section, ring).rotate(X, math.pi / 2.0).at(0.0, -thickness / 2.0, 0.0)
    return detail(opening.everywhere(front | front.rotate(Z, math.pi)), "door", opening.finish)


def panels_in(
    opening: Opening, thickness: Scalar, relief: Literal["raised", "recessed"], moulding: Scalar
) -> list[Body]:
    """Make the panels of a row with their mouldings."""
    width, height = opening.width - 0.001, opening.height - 0.001
    tongue = 0.25 * thickness  # 9-11 mm stand in the groove
    if relief == "raised":
        # fielded on both faces: bevels rise from the groove to a field 4 mm below the faces of the leaf
        run = min_(_BEVEL, 0.3 * min_(width, height))
        field = thickness - 0.008
        panel = _fielded(width, height, tongue, field, run) & _fielded(
            height, width, tongue, field, run
        ).rotate(Y, math.pi / 2.0)
    else:
        panel = box(width, tongue, height)
    return [
        part(opening.everywhere(panel), "door", opening.finish),
        _sticking(opening, thickness, (thickness - tongue) / 2.0, moulding),
    ]


def _fielded(width: Scalar, length: Scalar, edge: Scalar, field: Scalar, run: Scalar) -> Solid:
    """Make a board along Z whose section, of a width along X, has bevels from its edges to its field."""
    x, inner, y, out = width / 2.0, width / 2.0 - run, edge / 2.0, field / 2.0
    corners = [(x, -y), (x, y), (inner, out), (-inner, out), (-x, y), (-x, -y), (-inner, -out), (inner, -out)]
    return extrude(polygon(corners), length, axis=Z)


def panes_in(opening: Opening, thickness: Scalar, columns: int, lights: int, glass: Material) -> list[Body]:
    """Make a pane in its beads, and the muntins over it."""
    width, height = opening.width - 0.002, opening.height - 0.002
    bodies = [
        part(opening.everywhere(box(width, _PANE, height)), "glass", glass),
        _sticking(opening, thickness, (thickness - _PANE) / 2.0, 0.013),
    ]
    center = opening.centers[0]
    for number, across in ((columns, True), (lights, False)):
        if number < 2:
            continue
        pitch = (opening.width if across else opening.height) / number
        bar = (
            box(0.022, thickness - 0.008, opening.height, bevel=0.005)
            if across
            else box(opening.width, thickness - 0.009, 0.022, bevel=0.005)
        )
        places = [
            ((at - number / 2.0) * pitch, 0.0, 0.0) if across else (0.0, 0.0, (at - number / 2.0) * pitch)
            for at in range(1, number)
        ]
        bodies.append(part(array(bar, at=places).at(center), "door", opening.finish))
    return bodies


def slats_in(opening: Opening, thickness: Scalar, slats: int) -> list[Body]:
    """Make slats of which each begins in height where the last one ends, so that nobody sees through."""
    pitch = opening.height / slats
    depth = thickness - 0.010
    rise = 0.98 * pitch
    plank = 0.008  # its edges are half round, so that they stick out as far at every tilt
    out, up = depth - plank, rise - plank
    slat = box(opening.width, sqrt(out * out + up * up) + plank, plank, bevel=plank / 2.0)
    places = [
        (0.0, 0.0, (at - (slats - 1) / 2.0) * (opening.height - rise) / (slats - 1)) for at in range(slats)
    ]
    # the outer edge hangs down, so that rain and eyes stay out
    solid = array(slat.rotate(X, atan2(up, out)), at=places).at(opening.centers[0])
    return [part(solid, "door", opening.finish)]
