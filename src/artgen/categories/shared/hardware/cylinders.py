"""Key cylinders as they are seen: plugs with their keyways, and the ends of euro-profile cylinders."""

import math

from artgen import Body, Material, Scalar, Y, box, circle, detail, extrude, rectangle, ring, slot
from artgen.categories.shared.finish import recess

_PLUG = 0.0066  # radius of the plug of a euro-profile cylinder [m]
_OUT = 0.0018  # how far that cylinder stands out of its plate [m]


def plug(*, face: Scalar, side: int, finish: Material, radius: Scalar, below: Scalar = 0.0) -> list[Body]:
    """Make the plug of a cylinder with its keyway, 0.7 mm proud."""
    upright = slot(0.0080, 0.0017).rotate(math.pi / 2.0)
    keyway = upright | rectangle(0.0026, 0.0014).at(0.0004, 0.0012)  # a ward of its key
    disc = extrude(circle(radius) - keyway, 0.0012, axis=Y)
    dark = box(0.0034, 0.0004, 0.0084)
    groove = extrude(ring(radius + 0.0005, radius - 0.0004), 0.0003, axis=Y)
    return [
        detail(disc.at(0.0, side * (face + 0.0001), -below), "cylinder", finish),
        detail(
            (dark.at(0.0, side * (face - 0.0001), 0.0) | groove.at(0.0, side * face, 0.0)).at(
                0.0, 0.0, -below
            ),
            "cylinder",
            recess(finish),
        ),
    ]


def key_cylinder(*, face: Scalar, side: int, finish: Material, below: Scalar) -> list[Body]:
    """Make the end of a euro-profile cylinder in a plate, which is only seen."""
    profile = circle(0.0085) | rectangle(0.0100, 0.0245, radius=0.0045).at(0.0, -0.01225)
    body = extrude(profile, 2.0 * _OUT, axis=Y, bevel=0.0006)
    return [
        detail(body.at(0.0, side * face, -below), "cylinder", finish),
        *plug(face=face + _OUT, side=side, finish=finish, radius=_PLUG, below=below),
    ]
