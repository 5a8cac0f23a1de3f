"""Lamps that point their light: which arms carry which shade."""

from artgen.categories.lamp.arc import arc_arm
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

POLE = 0.0095
"""Radius of the pole on which the arm of a reading lamp slides [m]."""


def pointed(style: str, head: Head, looks: ArmLooks, sizes: ArmSizes) -> Carried:
    """Make what moves on the base of a lamp with arms."""
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
