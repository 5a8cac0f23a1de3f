"""Bodies of mills, and their grinding works, heads and cranks.

A mill stands on the table at z = 0, about the z axis; its body fills a region.
"""

import math
from typing import Literal

import artgen as ag
from artgen.categories.pepper_grinder.forms import WIDEST, BodyForm, Top, body_runs, end_radius, head_runs
from artgen.categories.shared import polar
from artgen.categories.shared.vessels import Drawn, Run, core, drawn, skin, turned

Content = Literal["pepper", "salt", "mixed"]
"""Contents of a mill: black peppercorns, salt, or peppercorns of four colors."""

Finial = Literal["nut", "ball", "cap"]
"""Fixing of a head on its shaft: a knurled nut, a ball, or a low cap."""

INSET = 0.0016
"""Depth of a clear tube behind its foot and collar [m]."""

_STEEL = ag.material("stainless")
_BURR = ag.material("steel")
_STORE = 0.0108  # half the width of the store of peppercorns in a turned body [m]
_ROOM = 0.0036  # half the width of holes for the shaft [m]
GAP = 0.0004  # gap between a head and its body, and between the knob and its pin [m]
_LOW, _HIGH = 0.0022, 0.0152  # lower and upper end of the grinding works [m]
_RING = 0.0090  # radius of the hole of the female burr [m]
_TEETH = 14
_PIN = 0.0019  # radius of the pin of a crank's knob [m]
_ARM = 0.0030  # thickness of the arm of a crank [m]
_WALL = 0.0028  # wall thickness of a clear tube [m]
_AROUND = 20  # number of grains in a ring behind the clear wall

_TURNS = [math.radians(angle) for angle in (-55, -20, 15, 50, 80)]
_FINIALS: dict[Finial, list[Run]] = {  # outlines above the face of a head [m]
    "nut": [
        [(0.0072, 0), (0.0072, 0.0018)],
        [(0.0058, 0.0018), (0.0062, 0.0070)],
        [(0.0062, 0.0070), (0.0046, 0.0088), (0.0014, 0.0096)],
    ],
    "ball": [
        [(0.0066, 0), (0.0066, 0.0016)],
        [(0.0066 * math.cos(turn), 0.0086 + 0.0066 * math.sin(turn)) for turn in _TURNS],
    ],
    "cap": [[(0.0100, 0), (0.0100, 0.0016)], [(0.0100, 0.0016), (0.0070, 0.0036), (0.0012, 0.0043)]],
}
# pear-shaped knob, 1.9 radii high
_KNOB: list[Drawn] = [(0.62, 0, 0), (0.66, 0, 0.16), (0.94, 0, 0.86), (1, 0, 1.22), (0.84, 0, 1.66),
                      (0.46, 0, 1.90)]  # fmt: skip
_GRAINS = {  # color of most grains, color of the others, and radius of a grain [m]
    "pepper": ((0.060, 0.036, 0.022), (0.105, 0.066, 0.042), 0.0024),
    "salt": ((0.82, 0.80, 0.78), (0.88, 0.86, 0.84), 0.0021),
    "mixed": ((0.070, 0.042, 0.026), (0.28, 0.05, 0.03), 0.0024),
}


def wooden(style: BodyForm, space: ag.Region, finish: ag.Material) -> ag.Body:
    """Make a one-piece turned body, with its store and works: the link `body`."""
    hole = _hole(_STORE, space.z)
    return ag.weld(turned(body_runs(style, space), "body", finish, hole=hole, bore=_STORE), _female_burr())


def clear(space: ag.Region, finish: ag.Material, ends: ag.Material, content: Content, rings: int) -> ag.Body:
    """Make a clear tube with its contents between a foot and a collar: the link `body`."""
    radius = space.x.high
    collar, room, foot = space.stack(0.010, None, 0.020 + 0.10 * radius)
    below = _band(radius, foot.z, 0.0012, 0.03 * radius, 0.0016)
    above = _band(radius, collar.z, 0.0010)
    outer = radius - INSET
    side = ag.line((outer, 0, room.z.low - 0.001), (outer, 0, room.z.high + 0.001))
    tube = ag.simplified_collider(ag.revolve(ag.half_section(side, wall=_WALL)))
    return ag.weld(
        turned(below, "body", ends, hole=_hole(_STORE, foot.z), bore=_STORE),
        turned(above, "body", ends, hole=_hole(_STORE, collar.z), bore=_STORE),
        ag.part(tube, "body", finish.with_(name="clear_tube", density=1180.0)),
        _filling(content, outer - _WALL, (room.z.low, room.z.at(0.82)), rings),
        _female_burr(),
    )


def _filling(content: Content, inner: ag.Scalar, z: ag.Span, rings: int) -> ag.Body:
    """Make the peppercorns in a tube: a core with their mass, and the visible grains at the wall."""
    color, other, size = _GRAINS[content]
    stuff = ag.material("polypropylene").with_(  # with the bulk density of peppercorns
        name=f"grains_{content}", base_color=color, density=560.0, texture="", specular_roughness=0.8
    )
    low, high = z
    wide = inner - 1.6 * size
    heap = ag.polygon([(0, low - 0.0005), (wide, low - 0.0005), (wide, high), (0, high)])
    outline = ag.polygon([(0, -1), (0.85, -0.55), (1, 0.15), (0.7, 0.8), (0, 1)])
    grain = ag.revolve(outline, sides=6).scale(size)
    bodies = [ag.part(ag.revolve(heap, sides=16) - _hole(_ROOM, z), "peppercorns", stuff)]
    step = (high - low - 2 * size) / (2 * rings - 1)
    others = stuff.with_(name=f"grains_{content}_light", base_color=other)
    for index, grains in enumerate((stuff, others)):
        middle, turn = (0, 0, low + size + index * step), index * math.pi / _AROUND
        circle = ag.ring_points(middle, inner - 1.15 * size, count=_AROUND, start=turn)
        column = ag.row((0, 0, 0), (0, 0, 2 * step), rings)
        bodies.append(ag.detail(ag.array(ag.array(grain, at=circle), at=column), "peppercorns", grains))
    lid = ag.array(grain, at=ag.ring_points((0, 0, high), 0.62 * inner, count=11))
    return ag.weld(*bodies, ag.detail(lid, "peppercorns", stuff))


def ring(style: BodyForm, space: ag.Region, metal: ag.Material) -> ag.Body:
    """Make the thin band of metal around the upper end of a body, visual only."""
    radius = end_radius(style) * space.x.high + 0.0004
    band = _band(radius, (space.z.high - 0.0032, space.z.high - 0.0006), 0.0004)
    return ag.detail(skin(band, bore=radius - 0.002), "ring", metal)


def cap(style: BodyForm, radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the domed cap on the body of a mill with a crank."""
    # a little lower, so that it shares no corners with the body
    runs = head_runs("crank", style, radius, low - 0.0002, height + 0.0002)
    return turned(runs, "cap", metal, hole=_hole(_ROOM, (low, low + height)), bore=_ROOM)


def head(
    top: Top,
    style: BodyForm,
    radius: ag.Scalar,
    low: ag.Scalar,
    height: ag.Scalar,
    wood: ag.Material,
    metal: ag.Material,
    finial: Finial,
) -> ag.Body:
    """Make the turning head, with shaft, burr and nut: the link `top`."""
    runs = head_runs(top, style, radius, low + GAP, height)
    high = low + GAP + height
    solid = core(runs)
    # fingers of 45 mm reach 27.5 mm down a head before the hand touches the nut on it
    deep = ag.min_((1 - WIDEST[top]) * height + 0.007, 0.0275)
    hold = ag.grasp_on(solid, approach=-ag.Z, closing=ag.X, depth=deep)
    tenon = _rod(low - 0.008, low + 0.002, _STORE - 0.0012)
    return ag.weld(
        ag.part([solid, tenon], "top", wood, grasp=hold),
        ag.detail(skin(runs), "top", wood),
        _shaft(high),
        turned(_FINIALS[finial], "finial", metal, sides=16).at(z=high - 0.0004),
    )


def crank(
    low: ag.Scalar,
    reach: ag.Scalar,
    radius: ag.Scalar,  # of the knob
    friction: ag.Scalar,  # of the knob on its pin
    wood: ag.Material,
    metal: ag.Material,
    finial: Finial,
) -> ag.Body:
    """Make a crank on a cap with its shaft and burr, the link `crank`, and its knob on a pin, `knob`."""
    level = low + 0.0052 + _ARM / 2  # height of the middle of the arm
    face = level + _ARM / 2
    end = face + 0.009  # the arm rises to its outer end
    # side view: horizontal over the cap, then up in a bend to the knob, which points to the front
    bend = [(0, -0.35 * reach, level + 0.0005), (0, -0.72 * reach, end - 0.004), (0, -reach, end)]
    line = ag.spline([(0, 0.006, level), *bend, (0, -reach - 0.006, end)])
    arm = ag.sweep(ag.rectangle(0.0105, _ARM, radius=0.0012), line)
    hub = _rod(low + GAP, face, 0.0085, bevel=0.001)
    eye = _rod(end - 0.0022, end + 0.0026, 0.0076, bevel=0.0008)
    seat = end + 0.0026 + GAP
    top = seat + 1.9 * radius
    pin = _rod(end, top + GAP + 0.0008, _PIN)
    stop = _rod(top + GAP, top + GAP + 0.0016, 0.0042, bevel=0.0006)
    nut = _FINIALS["nut" if finial == "ball" else finial]
    turning = ag.weld(
        ag.part([arm, hub], "crank", metal),
        ag.part([eye, pin, stop], "crank", metal).at(0, -reach),
        _shaft(face),
        turned(nut, "finial", metal, sides=16).at(z=face - 0.0003),
    )
    runs = drawn([_KNOB], radius, seat, 0)
    bore, hole = _PIN + GAP, _hole(_PIN + GAP, (seat, top))
    hold = ag.grasp_on(core(runs), approach=-ag.Z, closing=ag.X, depth=1.25 * radius)
    knob = turned(runs, "knob", wood, hole=hole, spare=0.0003, bore=bore, sides=16, grasp=hold)
    spin = ag.Revolute("knob_spin", axis=ag.Z, friction=friction, damping=0.0002, armature=1e-5, effort=0.3)
    return turning.attach(knob, spin, at=(0, -reach, 0))


def _female_burr() -> ag.Body:
    """Make the burr in the foot of a mill, visible from below: a ring with teeth around its hole."""
    reach = _STORE + 0.0006  # overlap with the wood around it
    space = ag.Region((-reach, reach), (-reach, reach), (_LOW, _HIGH))
    frame = space.box() - _hole(_RING, space.z)
    plate = skin([[(reach, _LOW - 0.0003), (reach, _LOW + 0.0012)]], bore=_RING)
    return ag.weld(
        ag.part(frame, "mechanism", _STEEL.with_(name="burr_steel", density=5000.0)),
        ag.detail(plate, "mechanism", _STEEL),
    )


def _shaft(high: ag.Scalar) -> ag.Body:
    """Make the shaft with the male burr at its lower end, up to a height."""
    low = _LOW + 0.0006
    burr = ag.revolve(ag.polygon([(0, low), (0.0078, low), (0.0050, _HIGH), (0, _HIGH)]), sides=16)
    star = polar([0.0084, 0.0084, 0.84 * 0.0084, 0.84 * 0.0084] * _TEETH)
    teeth = ag.extrude(star, 0.010, taper=0.3, twist=0.5).at(z=_LOW + 0.0056)
    return ag.weld(
        ag.part(_rod(_LOW + 0.002, high, 0.0026), "shaft", _STEEL),
        ag.part(burr, "burr", _BURR),
        ag.detail(teeth, "burr", _BURR),
        ag.detail(_rod(_LOW - 0.0008, _LOW + 0.0023, 0.0034, bevel=0.0006), "screw", _STEEL),
    )


def _band(radius: ag.Scalar, z: ag.Span, edge: float, *foot: ag.Scalar) -> list[Run]:
    """Return the outline of a beveled band; its foot may have a bevel of its own width and height."""
    low, high = z
    inset, rise = foot or (edge, edge)
    return [
        [(radius - inset, low), (radius, low + rise)],
        [(radius, low + rise), (radius, high - edge)],
        [(radius, high - edge), (radius - edge, high)],
    ]


def _rod(low: ag.Scalar, high: ag.Scalar, radius: float, bevel: float = 0.0) -> ag.Solid:
    """Make a cylinder about the z axis."""
    return ag.cylinder_between((0, 0, low), (0, 0, high), radius, bevel=bevel)


def _hole(half: float, z: ag.Span) -> ag.Solid:
    """Make the cutter of a through hole; it is square, so that the body needs few colliders."""
    return ag.Region((-half, half), (-half, half), z).grow(z=0.001).box()
