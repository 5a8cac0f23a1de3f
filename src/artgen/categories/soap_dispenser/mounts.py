"""Soap dispensers on a wall: their tile, the holder of a bottle, and a box with a button or lever.

The front of the tile is the plane y = 0; parts on it protrude to -y.
"""

from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.soap_dispenser.finish import ink_on

Press = Literal["button", "lever"]  # a panel that slides in, or a panel hinged at its upper edge

TRAY = 0.016  # height of the tray under a bottle [m]
_INTO = 0.0006  # depth of parts in the tile [m]
_RIM = 0.0022  # difference between the radii of a tray and its bottle [m]
_PUMP = 0.048  # height of the lower end of the block below a box [m]
_BLOCK = 0.030  # distance of the front of the block from the tile [m]
_CHEEK = 0.0040  # thickness of the cheeks beside a panel [m]
_PLAY = 0.0010  # gap between the panel and the cheeks [m]
_PANEL = 0.0060  # thickness of the panel [m]


def tile(wide: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the wall tile, from z = 0 up."""
    return ag.part(ag.Region((-wide / 2, wide / 2), (0, 0.009), (0, 0.205)).box(bevel=0.0012), "tile", finish)


def holder(radius: ag.Scalar, out: ag.Scalar, ring_at: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the holder of a bottle: a plate, a tray below it, and a ring around it."""
    plate = ag.Region((-0.014, 0.014), (-0.003, _INTO), (TRAY - 0.012, ring_at + 0.016))
    arm = ag.Region((-0.008, 0.008), (-out, -0.001), (TRAY - 0.0055, TRAY - 0.0015))
    strut = ag.Region((-0.006, 0.006), (radius - out, -0.001), (ring_at - 0.004, ring_at + 0.004))
    disc = ag.cylinder_between((0, -out, TRAY - 0.0035), (0, -out, TRAY), radius + _RIM, bevel=0.0010)
    line = ag.rectangle(_RIM + 0.0002, 0.010, radius=0.0008).at(radius + _RIM / 2 - 0.0001, ring_at)
    band = ag.bounding_collider(ag.revolve(line, sides=28)).at(y=-out)  # the bottle fills the band
    solids = [plate.box(bevel=0.001), arm.box(bevel=0.0008), disc, band, strut.box(bevel=0.0008)]
    screw = details.screw(0.0036, (0, -0.003, (TRAY + ring_at) / 2), material=metal, facing=-ag.Y)
    return ag.weld(ag.part(solids, "holder", metal), screw)


def case_of(width: ag.Scalar, depth: ag.Scalar) -> ag.Region:
    """Return the space of a box, whose back is in the tile."""
    return ag.Region((-width / 2, width / 2), (-depth, _INTO), (0.092, 0.196))


def box(
    case: ag.Region, finish: ag.Material, soap: ag.Material, fill: ag.Scalar, maker: str, word: str
) -> ag.Body:
    """Make a box full of soap with the pump's block below it: the link `body`."""
    front, low, high = case.y.low, case.z.low, case.z.high
    below = case.with_(z=(_PUMP, low + 0.008))
    block = below.with_(y=(-_BLOCK, _INTO))
    cheeks = below.shrink(front=0.009, back=_INTO + 0.010).across(_CHEEK, None, _CHEEK)[::2]
    shell = finish.with_(name=f"{finish.name}_case", density=720.0)  # a cartridge of soap in a shell of 2 mm
    solids = [case.box(bevel=0.0052), block.box(bevel=0.003), *(each.box(bevel=0.0012) for each in cheeks)]
    spout = ag.cylinder_between((0, -0.018, _PUMP - 0.008), (0, -0.018, _PUMP + 0.003), 0.0070, bevel=0.001)
    mouth = ag.cylinder_between((0, -0.018, _PUMP - 0.012), (0, -0.018, _PUMP - 0.007), 0.0042, bevel=0.0006)
    window = (
        ag.Region.centered(0.015, 0, 0.062).at(0, front, case.z.mid + 0.002).grow(front=0.0003, back=0.001)
    )
    well = window.shrink(x=0.0013, z=0.0013).grow(front=0.0002)
    seam = case.shrink(bottom=0.010, top=0.009).grow(x=0.00015).with_(y=(-0.0125, -0.0115))
    seen = soap.with_(name=f"{soap.name}_seen", opacity=1.0, transmission_weight=0.0)
    lock = ag.cylinder_between(
        (0, front / 2, high - 0.002), (0, front / 2, high + 0.0004), 0.0055, bevel=0.0003
    )
    dark, ink = ag.material("rubber"), ink_on(finish)
    name = details.logo(maker, 0.0034, tracking=0.2)
    label = details.lettering((word,), 0.0040, tracking=0.3, fineness="coarse")
    slot = ag.rectangle(0.0012, 0.0060)
    return ag.weld(
        ag.part(solids, "body", shell),
        ag.part(spout, "nozzle", finish),
        ag.part(mouth, "nozzle", dark),
        ag.detail(window.box(bevel=0.0002), "window", ag.colored("abs", "slate")),
        ag.detail(well.with_(z=(well.z.low, well.z.at(fill))).box(bevel=0.0002), "soap", seen),
        ag.detail(seam.box(), "body", ag.colored("abs", "graphite")),
        ag.detail(lock, "lock", ag.material("chrome")),
        details.printed(slot, (0, front / 2, high + 0.0004), material=dark, facing=ag.Z),
        details.printed(name, (0, front, window.z.low - 0.0075), material=ink),
        details.printed(label, (0, front, high - 0.0125), material=ink),
    )


def _sheet(case: ag.Region, press: Press) -> ag.Region:
    """Return the space of a panel, which is 1.5 mm behind the front of the box."""
    foot, gap = (_PUMP + 0.002, 0.0014) if press == "button" else (_PUMP - 0.020, 0.0022)
    front = case.y.low + 0.0015
    return case.shrink(x=_CHEEK + _PLAY).with_(y=(front, front + _PANEL), z=(foot, case.z.low - gap))


def panel(case: ag.Region, press: Press, finish: ag.Material, travel: ag.Scalar) -> ag.Body:
    """Make the panel that a hand presses: the link `button` or `lever`."""
    sheet = _sheet(case, press)
    slab, back, z = sheet.box(bevel=0.0022), sheet.y.high, case.z.low - 0.016
    push = ag.push_on(slab, direction=ag.Y, at=(0, 0, sheet.z.low + 0.016))
    # pressed home, the stub of a button is clear of the block of the pump
    out = ag.min_(0.009, -_BLOCK - 0.0002 - travel - back) if press == "button" else 0.009
    stub = ag.cylinder_between((0, back - 0.001, z), (0, back + out, z), 0.0050)
    sign = details.lettering(("PUSH",), 0.0060, tracking=0.3)
    return ag.weld(
        ag.part(slab, press, finish, push=push),
        ag.part(stub, press, ag.material("polypropylene")),
        details.printed(sign, (0, sheet.y.low, sheet.z.low + 0.030), material=ink_on(finish)),
    )


def lever_hinge(case: ag.Region, swing: ag.Scalar, force: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
    """Make the joint of a lever, about its upper edge; positive presses it in."""
    sheet = _sheet(case, "lever")
    torque = 0.050 * force  # a finger presses 50 mm below the edge
    pivot = (0, sheet.y.mid, sheet.z.high - _PANEL / 2)
    spring = ag.Spring(preload=0.35 * torque, force=torque)
    drag = feel.Feel(damping=damping, friction=0.02, armature=0.0001, effort=3.0)
    return ag.Revolute("lever_hinge", axis=ag.X, pivot=pivot, limits=(0.0, swing), spring=spring, feel=drag)
