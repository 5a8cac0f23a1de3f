"""Bulbs and their sockets: the E27 socket with a standard bulb (IEC 60061: 27 mm screw, A60 glass)."""

from artgen import (
    Body,
    Material,
    Scalar,
    array,
    box,
    cylinder,
    detail,
    frustum,
    material,
    part,
    ring_points,
    sphere,
    weld,
)
from artgen.categories.shared.finish import recess

SOCKET = 0.042
"""Length of a socket below its mouth [m]."""

SOCKET_RADIUS = 0.0185
"""Radius of the ring at the mouth of a socket [m]."""

BULB = 0.092
"""How far a bulb stands out of its socket [m]."""

BULB_RADIUS = 0.030
"""Radius of a bulb [m]."""

_LAMP = material("bulb").with_(density=420.0)  # an LED bulb weighs 60 g: thin shell, driver and heat sink


def bulb() -> Body:
    """Make a bulb that stands upward in a socket whose mouth is the plane z = 0."""
    # a cone that meets the ball at a tangent
    neck = frustum(0.0135, 0.02885, 0.0538).at(0.0, 0.0, 0.0269)
    ball = sphere(BULB_RADIUS).at(0.0, 0.0, 0.062)
    return weld(part(ball, "bulb", _LAMP), part(neck, "bulb", _LAMP))


def socket(finish: Material, *, length: Scalar = SOCKET) -> Body:
    """Make a socket with its mouth in the plane z = 0, from which it reaches down; it holds a bulb."""
    sleeve = cylinder(0.0160, length, bevel=0.0015).at(0.0, 0.0, -0.5 * length)
    mouth = cylinder(SOCKET_RADIUS, 0.008, bevel=0.0012).at(0.0, 0.0, -0.004)
    groove = cylinder(0.0162, 0.0012).at(0.0, 0.0, -0.011)
    return weld(
        part(sleeve, "socket", finish),
        part(mouth, "socket", finish),
        detail(groove, "socket", recess(finish)),
    )


def lamp_holder(finish: Material, *, length: Scalar = SOCKET) -> Body:
    """Make a socket with its bulb upward, the mouth of the socket in the plane z = 0."""
    return weld(socket(finish, length=length), bulb())


def vents(
    radius: Scalar, level: Scalar, finish: Material, *, count: int = 10, height: Scalar = 0.012
) -> Body:
    """Make the slots around a housing through which a bulb is cooled; they only are seen."""
    slot = box(0.0030, 0.0030, height, bevel=0.0012)
    places = ring_points((0.0, 0.0, level), radius - 0.0011, count=count)
    return detail(array(slot, at=places), "socket", recess(finish))
