"""Seals and feet: gaskets around doors, seams between panels, feet under appliances."""

import math
from typing import Literal

import numpy as np

from artgen._arrays import cached
from artgen.asset.shape import Outline
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.contours import moved_outline
from artgen.nodes.details.ink import drawing
from artgen.nodes.details.pen import SQUARE, Mark, disc, fill, stroke
from artgen.nodes.handles import Profile, Scalar, Solid
from artgen.nodes.path import polyline
from artgen.nodes.primitive import cylinder, frustum
from artgen.nodes.profile import rectangle
from artgen.nodes.scalar import max_, min_
from artgen.nodes.sweep import sweep

Seal = Literal["bulb", "lip", "bulb_lip", "half_round"]
"""The cross-section of a gasket."""

_BASE = fill("M-9,0 H9 V3.6 H-9 Z")
_LIP = stroke("M-6.4,3 C-4.4,9.6 0.4,13.8 7.4,16")
_SECTIONS: dict[str, tuple[Mark, ...]] = {
    "bulb": (*_BASE, *disc(0, 8.4, 6.4)),
    "lip": (*_BASE, *_LIP),
    "bulb_lip": (*_BASE, *disc(3.6, 8, 5.2), *stroke("M-6.4,3 C-7.2,8 -7.4,12 -6,17.4")),
    "half_round": fill("M-9,0 H9 A9 -9,0 Z"),
}


@cached(8)
def _seal(section: str) -> Outline:
    return drawing(_SECTIONS[section], 2.6, f"the section {section!r}")


@kernel
def _gasket_section(size: float, section: Seal) -> Outline:
    inputs.positive("size", size)
    return moved_outline(_seal(section), np.eye(2) * (size / SQUARE), np.zeros(2))


def gasket_section(size: Scalar, section: Seal = "bulb") -> Profile:
    """Make the cross-section of a gasket: the foot on y = 0, y outward from the face, a lip towards x > 0.

    Args:
        size: 1.1 times the width of its foot [m]; the height is at most the size.
        section: Form of the section; known while building.

    Examples:
        >>> details.gasket_section(0.012, "bulb_lip")
    """
    return Profile.record(_gasket_section, size=size, section=section)


def gasket(
    width: Scalar,
    height: Scalar,
    *,
    size: Scalar = 0.012,
    radius: Scalar = 0.02,
    section: Seal = "bulb",
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


def seam(width: Scalar, height: Scalar, *, gap: Scalar = 0.0006, radius: Scalar = 0.0) -> Profile:
    """Make the seam between panels, to be printed dark: a ring inside a rectangle.

    Args:
        width: Outer width [m].
        height: Outer height [m].
        gap: Width of the seam [m].
        radius: Radius of the outer corners; for round corners, more than the gap [m].

    Examples:
        >>> details.seam(0.06, 0.04, gap=0.001, radius=0.005)
    """
    inner = rectangle(width - 2 * gap, height - 2 * gap, radius=max_(radius - gap, 0.0))
    return rectangle(width, height, radius=radius) - inner


def foot(radius: Scalar, height: Scalar, *, style: Literal["pad", "round", "levelling"] = "pad") -> Solid:
    """Make a foot on z = 0 about the Z axis.

    Args:
        radius: Radius at the floor [m].
        height: Height of the foot [m].
        style: A rubber pad, a rounded knob that narrows upward, or a disc on an adjustable stem.

    Examples:
        >>> details.foot(0.015, 0.02, style="levelling")
    """
    if style == "levelling":
        pad = cylinder(radius, 0.28 * height, bevel=0.09 * height).at(0.0, 0.0, 0.14 * height)
        return pad | cylinder(0.36 * radius, 0.8 * height).at(0.0, 0.0, 0.6 * height)
    slim, share = (0.94, 0.1) if style == "pad" else (0.84, 0.3)
    bevel = share * min_(radius, height)
    return frustum(radius, slim * radius, height, bevel=bevel).at(0.0, 0.0, height / 2)
