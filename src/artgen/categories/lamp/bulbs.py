"""Bulbs and their sockets: the E27 socket with a standard bulb (IEC 60061: 27 mm screw, A60 glass)."""

import artgen as ag
from artgen.categories.shared.finish import recess

SOCKET = 0.042
"""Length of a socket below its mouth [m]."""

SOCKET_RADIUS = 0.0185
"""Radius of the ring at the mouth of a socket [m]."""

BULB = 0.092
"""How far a bulb stands out of its socket [m]."""

BULB_RADIUS = 0.030
"""Radius of a bulb [m]."""

_LAMP = ag.material("bulb").with_(density=420.0)  # an LED bulb weighs 60 g: thin shell, driver and heat sink


def bulb() -> ag.Body:
    """Make a bulb that stands upward in a socket whose mouth is the plane z = 0."""
    # a cone that meets the ball at a tangent
    neck = ag.frustum(0.0135, 0.02885, 0.0538).at(0.0, 0.0, 0.0269)
    ball = ag.sphere(BULB_RADIUS).at(0.0, 0.0, 0.062)
    return ag.weld(ag.part(ball, "bulb", _LAMP), ag.part(neck, "bulb", _LAMP))


def socket(finish: ag.Material, *, length: ag.Scalar = SOCKET) -> ag.Body:
    """Make a socket with its mouth in the plane z = 0, from which it reaches down; it holds a bulb."""
    sleeve = ag.cylinder(0.0160, length, bevel=0.0015).at(0.0, 0.0, -0.5 * length)
    mouth = ag.cylinder(SOCKET_RADIUS, 0.008, bevel=0.0012).at(0.0, 0.0, -0.004)
    groove = ag.cylinder(0.0162, 0.0012).at(0.0, 0.0, -0.011)
    return ag.weld(
        ag.part(sleeve, "socket", finish),
        ag.part(mouth, "socket", finish),
        ag.detail(groove, "socket", recess(finish)),
    )


def lamp_holder(finish: ag.Material, *, length: ag.Scalar = SOCKET) -> ag.Body:
    """Make a socket with its bulb upward, the mouth of the socket in the plane z = 0."""
    return ag.weld(socket(finish, length=length), bulb())


def vents(
    radius: ag.Scalar, level: ag.Scalar, finish: ag.Material, *, count: int = 10, height: ag.Scalar = 0.012
) -> ag.Body:
    """Make the slots around a housing through which a bulb is cooled; they only are seen."""
    slot = ag.box(0.0030, 0.0030, height, bevel=0.0012)
    places = ag.ring_points((0.0, 0.0, level), radius - 0.0011, count=count)
    return ag.detail(ag.array(slot, at=places), "socket", recess(finish))
