"""Visible screws in rows, and feet of furniture and appliances."""

from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import recess

FootStyle = Literal["pad", "round", "levelling"]
"""A rubber pad, a rounded knob, or a disc on a leveling screw of an appliance."""

_SUNK = 0.001  # depth of feet in the part above them [m]


def feet(
    at: Sequence[tuple[ag.Scalar, ag.Scalar]],
    *,
    radius: ag.Scalar = 0.009,
    height: ag.Scalar = 0.008,
    style: FootStyle = "pad",
    finish: ag.Material | None = None,
    label: str = "foot",
) -> ag.Body:
    """Make feet at positions on the floor, z = 0; weld them to the part at the height `height`."""
    tall = height + _SUNK
    if style == "pad":  # a cylinder is one collider
        one = ag.cylinder(radius, tall, bevel=0.0009).at(0.0, 0.0, tall / 2)
    else:
        one = ag.bounding_collider(details.foot(radius, tall, style=style))
    places: list[ag.VectorLike] = [(x, y, 0.0) for x, y in at]
    solid = ag.array(one, at=places)
    return ag.part(
        solid,
        label,
        ag.material("rubber") if finish is None else finish,
        separate="each foot is fixed to what stands on it",
    )


def corner_feet(
    width: ag.Scalar,
    depth: ag.Scalar,
    *,
    inset: ag.Scalar = 0.02,
    radius: ag.Scalar = 0.009,
    height: ag.Scalar = 0.008,
    style: FootStyle = "pad",
    finish: ag.Material | None = None,
    label: str = "foot",
) -> ag.Body:
    """Make four feet under the corners of a rectangle about the origin."""
    x, y = width / 2 - inset, depth / 2 - inset
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    return feet(corners, radius=radius, height=height, style=style, finish=finish, label=label)


Drive = Literal["slot", "phillips", "hex"]
"""Drive of a screw."""

Head = Literal["pan", "countersunk"]
"""A low dome on a face, or a disc flush with it."""

Way = Literal["+x", "-x", "+y", "-y"]
"""Direction of the normal of a face."""

FACING: dict[Way, tuple[float, float, float]] = {
    "+x": (1.0, 0.0, 0.0),
    "-x": (-1.0, 0.0, 0.0),
    "+y": (0.0, 1.0, 0.0),
    "-y": (0.0, -1.0, 0.0),
}
"""Unit vectors of the directions."""

_TURN = 0.5  # rotation of the recesses [rad]
_FLOOR = {"pan": (0.54, 0.26), "countersunk": (0.60, 0.09)}  # radius and height of the dark part, in radii


def screws(
    at: Sequence[ag.VectorLike],
    *,
    facing: Way,
    radius: ag.Scalar,
    finish: ag.Material,
    drive: Drive = "phillips",
    head: Head = "countersunk",
    sunk: ag.Scalar = 0.0,
) -> list[ag.Body]:
    """Make heads of screws on a face, each with a dark recess."""
    out = FACING[facing]
    seat = tuple(-sunk * each for each in out)
    reach, high = _FLOOR[head]
    solid = details.screw_head(radius, seat, facing=out, drive=drive, head=head, turn=_TURN)
    bottom = details.drive_recess(reach * radius, drive).rotate(_TURN)
    floor = details.relief(bottom, seat, facing=out, proud=high * radius, sunk=0.02 * radius)
    return [
        ag.detail(ag.array(solid, at=at), "screw", finish),
        ag.detail(ag.array(floor, at=at), "screw", recess(finish)),
    ]
