"""Lamps with a directed light: arms with shades, and arc lamps."""

import math

import artgen as ag
from artgen.categories.lamp.arms import GRAVITY, TURRET, Load, bracket, braked_hinge, eyes
from artgen.categories.lamp.bases import hollow
from artgen.categories.lamp.jointed import (
    ArmLooks,
    ArmSizes,
    Carried,
    light_bar,
    one_arm,
    reading_arm,
    two_arms,
)
from artgen.categories.lamp.lampshades import Head

_HANG = 0.024  # distance from the hinge of the shade to the top of its housing [m]
_TUBE = 0.0105  # radius of the bow [m]
_SWING = 0.6  # swing of the shade to each side, if the bow allows it [rad]
_LEAST_SWING = 0.1  # least swing of the shade to each side [rad]
_OFF = 0.004  # distance of a shade from the bow [m]
_MEETS_BOW = "the shade would strike the bow: raise reach, or lower shade_radius or shade_height"
_TURN = 2.595  # angle along the ellipse of the bow, from its side [rad]
_STEPS = 9  # number of points on the ellipse


def arc_arm(head: Head, *, height: ag.Scalar, reach: ag.Scalar, looks: ArmLooks) -> Carried:
    """Make the bow with its shade; it turns about z on the plane z = 0."""
    finish = looks.finish
    foot = ag.cylinder(2.3 * _TUBE, 0.022, bevel=0.003).at(0.0, 0.0, TURRET + 0.011)
    # straight up, then more than a quarter of an ellipse
    rise = 0.50 * height
    wide, high = reach / (1.0 - math.cos(_TURN)), height - rise
    bend = [
        (wide * (1.0 - math.cos(turn)), 0.0, rise + high * math.sin(turn))
        for turn in (_TURN * step / _STEPS for step in range(_STEPS + 1))
    ]
    end, before = ag.vector(*bend[-1]), ag.vector(*bend[-2])
    # the bow is in the inner lane beyond this point
    last = end + (before - end) * (0.034 / (before - end).norm())
    course = ag.spline([(0.0, 0.0, 0.018), (0.0, 0.0, 0.84 * rise), *bend[:-1], last])
    neck = ag.cylinder(0.0048, 0.040, axis=end - last).at((end + last) * 0.5)
    grip = ag.frame((0.0, 0.0, 0.5 * rise), approach=ag.Y, closing=(1.0, 0.0, 0.0))
    towards: ag.Scalar = _SWING  # swing of the shade to the bow
    for corner, below in head.corners:
        deep = below + _HANG
        # position of the corner after the upward swing, and the position of the bow at this height
        level = end.z - deep * math.cos(_SWING) + corner * math.sin(_SWING)
        share = ag.clamp((level - rise) / high, 0.0, 1.0)
        room = reach - wide * (1.0 - ag.sqrt(1.0 - share * share)) - _TUBE - _OFF
        far = ag.sqrt(corner * corner + deep * deep)
        sine = ag.clamp(room / far, 0.0, 1.0)
        meets = ag.atan2(sine, ag.sqrt(1.0 - sine * sine)) - ag.atan2(corner, deep)
        towards = ag.min_(towards, ag.switch(room < far, meets, _SWING))
    bow = ag.weld(
        ag.part(ag.sweep(ag.circle(_TUBE), course), "arm_lower", hollow(finish), grasp=grip),
        ag.part(foot, "arm_lower", finish),
        ag.part(neck, "arm_lower", finish),
        *(each.at(end) for each in eyes(finish, label="arm_lower", outer=False)),
    )
    shade = ag.weld(head.body.at(0.0, 0.0, -_HANG), *bracket(finish, length=_HANG)).at(end)
    lever = (shade.center_of_mass() - end).norm()
    hinge = braked_hinge(
        "shade_hinge",
        pivot=end,
        limits=(-_SWING, ag.require(towards, towards > _LEAST_SWING, _MEETS_BOW)),
        load=Load().free(GRAVITY * shade.mass(), lever),
        feel=4.0,
        reach=0.12,
        damping=0.02,
    )
    moment = bow.mass() * 0.45 * reach + shade.mass() * (reach + lever)
    return Carried(bow.attach(shade, hinge), 1.0 * moment, looks.turn())


POLE = 0.0095
"""Radius of the pole for the arm of a reading lamp [m]."""


def pointed(style: str, head: Head, looks: ArmLooks, sizes: ArmSizes) -> Carried:
    """Make the moving parts on the base of a lamp with arms."""
    match style:
        case "desk":
            return one_arm(head, looks, length=sizes.length, lean=sizes.lean, tilt=sizes.tilt)
        case "architect":
            return two_arms(
                head,
                looks,
                lower=sizes.length,
                upper=sizes.upper,
                lean=sizes.lean,
                rise=sizes.rise,
                tilt=sizes.tilt,
            )
        case "led_bar":
            return light_bar(looks, length=sizes.length, bar=sizes.upper, lean=sizes.lean)
        case "reading":
            return reading_arm(
                head,
                looks,
                length=sizes.length,
                lean=sizes.lean,
                tilt=sizes.tilt,
                bore=POLE,
                travel=sizes.travel,
            )
    return arc_arm(head, height=sizes.height, reach=sizes.reach, looks=looks)
