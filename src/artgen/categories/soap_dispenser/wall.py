"""Soap dispensers on a wall: their tile, a bottle in a holder, or a box with a button or lever.

The front of the tile is the plane y = 0; parts on it protrude to -y.
"""

from typing import Literal

import artgen as ag
from artgen import details

Press = Literal["button", "lever"]
"""Pressed part of a box: a panel that slides in, or a panel hinged at its upper edge."""

TILE = 0.009
"""Thickness of the tile [m]."""

_HIGH = 0.205  # height of the tile [m]
_RIM = 0.0022  # difference between the radii of a tray and its bottle [m]
TRAY = 0.016
"""Height of the tray under a bottle [m]."""

_BOX = (0.092, 0.196)  # heights of the lower and upper end of the box [m]
_PUMP = 0.048  # height of the lower end of the block below the box [m]
_BLOCK = 0.030  # distance of the front of the block from the tile [m]
_CHEEK = 0.0040
_PLAY = 0.0010  # gap between the panel and the cheeks [m]
_THICK = 0.0060  # thickness of the panel [m]


def tile(wide: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the wall tile, from z = 0 up."""
    slab = ag.Region.between((-0.5 * wide, 0.0, 0.0), (0.5 * wide, TILE, _HIGH)).box(bevel=0.0012)
    return ag.part(slab, "tile", finish)


def holder(radius: ag.Scalar, out: ag.Scalar, ring_at: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the holder of a bottle: a plate, a tray below it, and a ring around it."""
    plate = ag.Region.between((-0.014, -0.003, TRAY - 0.012), (0.014, 0.0006, ring_at + 0.016)).box(
        bevel=0.001
    )
    arm = ag.Region.between((-0.008, -out, TRAY - 0.0055), (0.008, -0.001, TRAY - 0.0015)).box(bevel=0.0008)
    disc = ag.cylinder_between((0.0, -out, TRAY - 0.0035), (0.0, -out, TRAY), radius + _RIM, bevel=0.0010)
    line = ag.rectangle(_RIM + 0.0002, 0.010, radius=0.0008).at(radius + 0.5 * _RIM - 0.0001, ring_at)
    band = ag.bounding_collider(ag.revolve(line, sides=28)).at(0.0, -out, 0.0)  # the bottle fills the band
    strut = ag.Region.between((-0.006, radius - out, ring_at - 0.004), (0.006, -0.001, ring_at + 0.004)).box(
        bevel=0.0008
    )
    screws = [
        details.screw(0.0036, (0.0, -0.003, height), material=metal, facing=(0.0, -1.0, 0.0))
        for height in (0.5 * (TRAY + ring_at),)
    ]
    return ag.weld(
        ag.part(plate, "holder", metal),
        ag.part(arm, "holder", metal),
        ag.part(disc, "holder", metal),
        ag.part(band, "holder", metal),
        ag.part(strut, "holder", metal),
        *screws,
    )


def wall_box(
    wide: ag.Scalar,
    deep: ag.Scalar,
    *,
    finish: ag.Material,
    soap: ag.Material,
    ink: ag.Material,
    fill: ag.Scalar,
    maker: str,
    word: str,
) -> ag.Body:
    """Make a box full of soap with the pump's block below it: the link `body`."""
    low, high = _BOX
    half = 0.5 * wide
    shell = finish.with_(name=f"{finish.name}_case", density=720.0)  # a cartridge of soap in a shell of 2 mm
    case = ag.Region.between((-half, -deep, low), (half, 0.0006, high)).box(bevel=0.0052)
    block = ag.Region.between((-half, -_BLOCK, _PUMP), (half, 0.0006, low + 0.008)).box(bevel=0.0030)
    cheeks = [
        ag.Region.between(
            (side * (half - _CHEEK / 2.0) - _CHEEK / 2.0, 0.009 - deep, _PUMP),
            (side * (half - _CHEEK / 2.0) + _CHEEK / 2.0, -0.010, low + 0.008),
        ).box(bevel=0.0012)
        for side in (-1, 1)
    ]
    spout = ag.cylinder_between(
        (0.0, -0.018, _PUMP - 0.008), (0.0, -0.018, _PUMP + 0.003), 0.0070, bevel=0.001
    )
    dark = ag.material("rubber")
    mouth = ag.cylinder_between(
        (0.0, -0.018, _PUMP - 0.012), (0.0, -0.018, _PUMP - 0.007), 0.0042, bevel=0.0006
    )
    tall = 0.062
    middle = 0.5 * (low + high) + 0.002
    front = -deep
    frame = ag.Region.between(
        (-0.0075, front - 0.0003, middle - 0.5 * tall), (0.0075, front + 0.001, middle + 0.5 * tall)
    ).box(bevel=0.0002)
    column = ag.Region.between(
        (-0.0062, front - 0.0005, middle - 0.5 * tall + 0.0013),
        (0.0062, front + 0.001, middle - 0.5 * tall + 0.0013 + fill * (tall - 0.0026)),
    ).box(bevel=0.0002)
    seam = ag.Region.between(
        (-half - 0.00015, -0.0125, low + 0.010), (half + 0.00015, -0.0115, high - 0.009)
    ).box()
    lock = ag.cylinder_between(
        (0.0, -0.5 * deep, high - 0.002), (0.0, -0.5 * deep, high + 0.0004), 0.0055, bevel=0.0003
    )
    slot = details.printed(
        ag.rectangle(0.0012, 0.0060), (0.0, -0.5 * deep, high + 0.0004), material=dark, facing=(0.0, 0.0, 1.0)
    )
    name = details.logo(maker, 0.0034, tracking=0.2)
    label = details.lettering((word,), 0.0040, tracking=0.3, fineness="coarse")
    return ag.weld(
        ag.part(case, "body", shell),
        ag.part(block, "body", shell),
        *(ag.part(cheek, "body", shell) for cheek in cheeks),
        ag.part(spout, "nozzle", finish),
        ag.part(mouth, "nozzle", dark),
        ag.detail(frame, "window", ag.colored("abs", "slate")),
        ag.detail(column, "soap", soap.with_(name=f"{soap.name}_seen", opacity=1.0, transmission_weight=0.0)),
        ag.detail(seam, "body", ag.colored("abs", "graphite")),
        ag.detail(lock, "lock", ag.material("chrome")),
        slot,
        details.printed(name, (0.0, front, middle - 0.5 * tall - 0.0075), material=ink),
        details.printed(label, (0.0, front, high - 0.0125), material=ink),
    )


def panel(
    wide: ag.Scalar,
    deep: ag.Scalar,
    *,
    press: Press,
    travel: ag.Scalar,
    finish: ag.Material,
    ink: ag.Material,
) -> ag.Body:
    """Make the panel that a hand presses: the link `button` or `lever`."""
    low, _ = _BOX
    half = 0.5 * wide - _CHEEK - _PLAY
    front = 0.0015 - deep
    foot = _PUMP + 0.002 if press == "button" else _PUMP - 0.020
    sheet = ag.Region.between((-half, front, foot), (half, front + _THICK, high_of(press))).box(bevel=0.0022)
    bodies = [
        ag.part(sheet, press, finish, push=ag.push_on(sheet, direction=ag.Y, at=(0.0, 0.0, foot + 0.016)))
    ]
    back = front + _THICK
    # pressed home, the stub of a button is clear of the block of the pump
    out = ag.min_(0.009, -_BLOCK - 0.0002 - travel - back) if press == "button" else 0.009
    stub = ag.cylinder_between((0.0, back - 0.001, low - 0.016), (0.0, back + out, low - 0.016), 0.0050)
    bodies.append(ag.part(stub, press, ag.material("polypropylene")))
    sign = details.lettering(("PUSH",), 0.0060, tracking=0.3)
    bodies.append(details.printed(sign, (0.0, front, foot + 0.030), material=ink))
    return ag.weld(*bodies)


def high_of(press: Press) -> float:
    """Return the height of the upper edge of a panel [m]."""
    return _BOX[0] - (0.0014 if press == "button" else 0.0022)


def lever_hinge(deep: ag.Scalar, *, swing: ag.Scalar, force: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
    """Make the joint of a lever, about its upper edge; positive presses it in."""
    torque = 0.050 * force
    preload = 0.35 * torque
    stiffness = (torque - preload) / swing
    return ag.Revolute(
        "lever_hinge",
        axis=ag.X,
        pivot=(0.0, 0.0015 - deep + 0.5 * _THICK, high_of("lever") - 0.5 * _THICK),
        limits=(0.0, swing),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.02,
        armature=0.0001,
        effort=3.0,
    )
