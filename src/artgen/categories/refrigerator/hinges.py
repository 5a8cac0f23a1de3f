"""Hinges of appliance doors: the joint with the friction of gasket and bearings, covers and brackets."""

import artgen as ag

_HAND = 60.0  # the most that a hand pulls with; 15-45 N open a refrigerator [N]


def door_swing(
    name: str,
    *,
    pivot: ag.VectorLike,
    way: int,
    limit: ag.Scalar,
    pull: ag.Scalar,
    arm: ag.Scalar,
    damping: ag.Scalar = 1.0,
) -> ag.Joint:
    """Make the upright hinge of a door that stays where it is left.

    Opening a refrigerator takes 15-45 N at its handle to break the gasket's hold and about 5 N further on;
    a joint has one friction for all of its swing, so `pull` is the low end of the first.
    """
    return ag.Revolute(
        name,
        pivot=pivot,
        axis=(0.0, 0.0, way),
        limits=(0.0, limit),
        friction=pull * arm,
        damping=damping,
        effort=_HAND * arm,
        velocity=4.0,
    )


def hinge_cover(
    *, finish: ag.Material, way: int, inset: ag.Scalar, reach: ag.Scalar = 0.11, high: ag.Scalar = 0.018
) -> ag.Body:
    """Make the cover of the upper hinge on top of a cabinet; the axis is the Z axis, the top is z = 0.

    It reaches over the door in front of it.
    """
    wide, lead = 0.052, 0.017  # its width, and how far it reaches before the axis [m]
    cap = ag.extrude(ag.rectangle(wide, reach + lead, radius=0.010), high, bevel=0.004)
    x = way * (inset - 0.004 - wide / 2)
    return ag.part(cap.at(x, (reach - lead) / 2, high / 2), "hinge", finish)


def hinge_bracket(
    *, finish: ag.Material, way: int, inset: ag.Scalar, back: ag.Scalar, thick: ag.Scalar = 0.0018
) -> ag.Body:
    """Make the bracket in the gap under a door, as it is seen: a plate with a pin through it, about z = 0."""
    wide = inset + 0.018
    plate = ag.box(wide, back + 0.012, thick, bevel=0.0005).at(
        way * (inset - wide / 2 - 0.002), (back - 0.010) / 2, 0.0
    )
    pin = ag.cylinder(0.0055, thick + 0.0012, axis=ag.Z)  # what is seen of it between two fronts
    return ag.weld(ag.detail(plate, "hinge", finish), ag.detail(pin, "hinge", finish))
