"""Joints of hand tools that cross, pliers and scissors: rivets in a lap, and leaf springs of handles.

The axis of the pivot is z through the origin. In the lap each half is a plate: the lower plate carries the
rivet, the upper plate has its hole. Jaws or blades point to +y, handles to -y.
"""

import math

import artgen as ag

_PLAY = 0.0003  # gap between a rivet and its hole, all around [m]


def rivet_hole(radius: ag.Scalar) -> ag.Profile:
    """Make the outline of the hole for a rivet of a radius [m]; four sides, hidden by the heads."""
    return ag.regular_polygon(4, (radius + _PLAY) / math.cos(math.pi / 4))


def rivet(radius: ag.Scalar, top: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a rivet that is fixed in the lower plate, passes the upper plate, and has a head above it.

    Args:
        radius: Radius of its shaft [m].
        top: Height of the upper face of the lap over its middle; the lower face is as far below [m].
        finish: Material; its ground head is stainless.
    """

    def turned(start: ag.Scalar, end: float, share: float, bevel: float = 0.0) -> ag.Solid:
        ends = (0.0, 0.0, start), (0.0, 0.0, top + end)
        return ag.cylinder_between(*ends, share * radius, bevel=bevel)

    solid = turned(0.0004 - top, 0.0008, 1.0) | turned(top + 0.0002, 0.0012, 1.55, 0.0004)
    ground = turned(top + 0.0008, 0.00125, 1.05, 0.0002)
    return ag.weld(ag.part(solid, "pivot", finish), ag.detail(ground, "pivot", ag.material("stainless")))


def leaf_spring(foot: tuple[ag.Scalar, ag.Scalar], end: ag.Scalar) -> ag.Body:
    """Make the visible leaf spring of the left handle; the springs of both handles touch in the middle.

    Args:
        foot: Position of its foot at the inner side of the handle, along x and y [m].
        end: Position of its free end along y [m].
    """
    inside, y = foot
    bends = (
        (inside, y - 0.006),
        (inside + 0.0008, y + 0.002),
        (-0.0022, (y + end) / 2 + 0.002),
        (-0.0010, end),
    )
    course = ag.polyline([(*bend, 0.0) for bend in bends], fillet=0.006)
    return ag.detail(ag.sweep(ag.rectangle(0.0009, 0.0045), course), "spring", ag.material("stainless"))


def opened_by_spring(squeeze: ag.Scalar, preload: ag.Scalar, opening: ag.Scalar) -> ag.Spring:
    """Make a spring that opens a joint, closed at 0.

    Args:
        squeeze: Torque that holds it closed [N m].
        preload: Torque of the spring where it is open [N m].
        opening: Angle of the open joint [rad].
    """
    stiffness = (squeeze - preload) / opening
    return ag.Spring(stiffness=stiffness, rest=squeeze / stiffness)
