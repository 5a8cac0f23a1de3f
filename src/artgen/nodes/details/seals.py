"""Seals and feet: gaskets around doors, feet under appliances."""

from __future__ import annotations

import math
from typing import Literal

from artgen.asset.shape import Outline
from artgen.graph import records
from artgen.graph.handle import check_options
from artgen.nodes import validators as inputs
from artgen.nodes.details.icons import drawing
from artgen.nodes.handles import Profile, Scalar, Solid
from artgen.nodes.path import polyline
from artgen.nodes.primitive import cylinder, frustum
from artgen.nodes.scalar import min_
from artgen.nodes.sweep import sweep

Seal = Literal["bulb", "lip", "bulb_lip", "half_round"]
"""The cross-section of a gasket."""


def _gasket_section(size: float, section: Seal) -> Outline:
    return drawing(f"gasket-{section}", 2.6, inputs.positive("size", size))


@records(_gasket_section)
def gasket_section(size: Scalar, section: Seal) -> Profile:
    """Make the cross-section of a gasket: the foot on y = 0, y outward from the face, a lip towards x > 0."""


def gasket(
    width: Scalar, height: Scalar, *, size: Scalar = 0.012, radius: Scalar = 0.02, section: Seal = "bulb"
) -> Solid:
    """Make a gasket around a door in the plane of X and Z about the origin; its foot on y = 0 faces -Y.

    Args:
        width: Distance between the center lines of its left and right side [m].
        height: Distance between the center lines of its lower and upper side [m].
        size: Width of its cross-section [m].
        radius: Radius of its corners, more than half of its size [m].
        section: Its cross-section; a lip points inward.

    Examples:
        >>> details.gasket(0.3, 0.2, size=0.02)
    """
    x, z = width / 2, height / 2
    # start at the center of a side, where the upward direction is known
    corners = [(0.0, 0.0, -z), (x, 0.0, -z), (x, 0.0, z), (-x, 0.0, z), (-x, 0.0, -z)]
    profile = gasket_section(size, section).rotate(math.pi / 2)
    return sweep(profile, polyline(corners, fillet=radius, closed=True))


def foot(radius: Scalar, height: Scalar, *, style: Literal["pad", "round", "levelling"] = "pad") -> Solid:
    """Make a foot on z = 0 about the Z axis.

    Args:
        radius: Radius at the floor [m].
        height: Height of the foot [m].
        style: A rubber pad, a rounded knob that narrows upward, or a disc on an adjustable stem.

    Examples:
        >>> details.foot(0.015, 0.02, style="levelling")
    """
    check_options(foot, locals())
    if style == "levelling":
        pad = cylinder(radius, 0.28 * height, bevel=0.09 * height).at(0.0, 0.0, 0.14 * height)
        return pad | cylinder(0.36 * radius, 0.8 * height).at(0.0, 0.0, 0.6 * height)
    slim, share = (0.94, 0.1) if style == "pad" else (0.84, 0.3)
    bevel = share * min_(radius, height)
    return frustum(radius, slim * radius, height, bevel=bevel).at(0.0, 0.0, height / 2)
