"""Feet of appliances: sets of them under the corners, on z = 0."""

from collections.abc import Sequence
from typing import Literal

from artgen import Body, Material, Scalar, VectorLike, array, cylinder, details, enclosed, material, part

FootStyle = Literal["pad", "round", "levelling"]
"""A rubber pad, a rounded knob, or a disc on a screw by which an appliance is levelled."""

_SUNK = 0.001  # how deep feet reach into what stands on them [m]


def feet(
    at: Sequence[tuple[Scalar, Scalar]],
    *,
    radius: Scalar = 0.009,
    height: Scalar = 0.008,
    style: FootStyle = "pad",
    finish: Material | None = None,
    label: str = "foot",
) -> Body:
    """Make feet at places of the floor, z = 0; weld them to what stands `height` above it."""
    tall = height + _SUNK
    if style == "pad":  # a cylinder is one collider
        one = cylinder(radius, tall, bevel=0.0009).at(0.0, 0.0, tall / 2)
    else:
        one = enclosed(details.foot(radius, tall, style=style))
    places: list[VectorLike] = [(x, y, 0.0) for x, y in at]
    solid = array(one, at=places)
    return part(
        solid,
        label,
        material("rubber") if finish is None else finish,
        separate="each foot is fixed to what stands on it",
    )


def corner_feet(
    width: Scalar,
    depth: Scalar,
    *,
    inset: Scalar = 0.02,
    radius: Scalar = 0.009,
    height: Scalar = 0.008,
    style: FootStyle = "pad",
    finish: Material | None = None,
    label: str = "foot",
) -> Body:
    """Make four feet under the corners of a rectangle about the origin."""
    x, y = width / 2 - inset, depth / 2 - inset
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    return feet(corners, radius=radius, height=height, style=style, finish=finish, label=label)
