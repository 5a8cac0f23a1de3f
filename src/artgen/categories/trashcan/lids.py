"""Bins with a hinged lid at the back: opened by a pedal, lifted by a hand, or sprung open by a button.

The hinge's axis runs along x behind the rim, below the underside of the lid: the parts of the lid in front of
and above the axis stay above it until the lid is upright.
"""

import math
from dataclasses import replace
from typing import Any, Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.finish import casting
from artgen.categories.trashcan import finish
from artgen.categories.trashcan.bins import (
    FREE,
    GAP,
    LOWER,
    STEEL,
    UNDER,
    Can,
    Design,
    pair,
    stand,
    with_bucket,
)
from artgen.categories.trashcan.pedals import PIN, Linkage

Grip = Literal["none", "lip", "bar", "knob"]  # a lip in front of the lid, a bar or a knob on it

THICK = 0.012  # thickness of lids [m]
_STEP = 0.006  # height of the middle of a stepped lid above its edge [m]
_OVERHANG = 0.0015  # reach of a lid beyond the wall [m]
_SOFT = 0.0032  # bevel of a slab [m]
_WITHIN = 0.0003  # depth of facets below the visible surface [m]
_LEAST_ROUND = 0.012  # least corner radius of a cushion [m]
_SLOPE = 2.25  # largest inward lean of a cushion over its rise: its lower edge can still be rounded
_LIP = 0.020  # length of a lip in front [m]

_HALF = 0.013  # half of the length of the hub [m]
_CHEEK = 0.0034  # thickness of the cheeks beside the hub [m]
_SHORT = 0.055  # height of a hinge block without a rod in it [m]

_SPARE = 0.004  # clearance between an open lid and the parts that rise in front of it [m]
_SPARE_ANGLE = 0.035  # opening angle of lids beyond the angle that buckets need [rad]
_UPRIGHT = 1.53  # least angle of an open lid that clears all parts [rad]
_BEHIND = 0.005  # additional space for a bucket in front and behind [m]

_ROOM = 0.027  # depth of the catch behind the front wall [m]
_TONGUE = 0.024  # width of the tongue [m]
_REACH = 0.034  # reach of the tongue below the rim [m]
_BACK = 0.015  # distance from the outer face of the wall to the middle of the tongue [m]
_THIN = 0.003  # thickness of the tongue and its foot [m]
_FOOT = 0.0045  # reach of the foot of the tongue inward [m]
_CAP = (0.050, 0.013, 0.016)  # width, depth and height of the button [m]
_FRICTION = 0.02  # friction of the hinge of a sprung lid [N m]


class Hinge:
    """The hinge behind the rim: distance of its axis from the wall, height of its lower end [m]."""

    def __init__(self, design: Design, behind: ag.Scalar, foot: ag.Scalar) -> None:
        self.design, self.behind, self.foot = design, behind, foot
        self.y, self.z = design.can.depth / 2 + behind, design.can.top - 0.006

    def housing(self, *, rod: bool = False) -> ag.Body:
        """Make the block behind the rim with the pin: two cheeks, a cover, and a sill where no rod is."""
        y, z, foot = self.y, self.z, self.foot
        half = _HALF + _CHEEK
        block = ag.Region((-half, half), (self.design.can.depth / 2 - 0.004, y + 0.008), (foot, z))
        cheeks = block.grow(x=0.0005).across(_CHEEK, None, _CHEEK)[::2]
        round_ = ag.cylinder(0.0082, _CHEEK, axis=ag.X, bevel=0.0012)
        cover = block.with_(y=(y + 0.0053, y + 0.0083)).shrink(top=0.010)
        solids = [each.box(bevel=0.0012) for each in (*cheeks, cover)]
        solids += pair(round_, _HALF + 0.0005 + _CHEEK / 2, y, z)
        if not rod:
            solids.append(block.with_(z=(foot, foot + 0.003)).box(bevel=0.001))
        head = ag.cylinder(0.0034, _CHEEK, axis=ag.X, bevel=0.0008)
        heads = pair(head, _HALF + _CHEEK / 2 + 0.0012, y, z)
        molding = casting(self.design.plastic, 0.4)  # walls of 1.3 mm
        body = ag.weld(ag.part(solids, "hinge", molding), ag.detail(heads, "screw", ag.material("stainless")))
        if not (rod and self.design.damper):
            return body
        disc = ag.cylinder(0.0075, 0.006, axis=ag.X, bevel=0.001).at(half + 0.003, y, z)
        return ag.weld(body, ag.detail(disc, "hinge", ag.material("glossy_plastic_black")))

    def lid(self) -> ag.Body:
        """Make the lid with its hub and the arm between them: the link `lid`."""
        design, y, z = self.design, self.y, self.z
        can, low = design.can, design.can.top + GAP
        hub = ag.cylinder(0.0062, 2 * _HALF, axis=ag.X, bevel=0.0008).at(0, y, z)
        top = low + 0.7 * THICK
        neck = ag.Region.between((-_HALF + 0.001, y - 0.0065, z), (_HALF - 0.001, y + 0.0035, top - 0.001))
        bridge = ag.Region((-_HALF, _HALF), (can.depth / 2 - 0.010, y + 0.004), (low, top))
        arm = [hub, neck.box(bevel=0.0015), bridge.box(bevel=0.0015)]
        body = ag.weld(*_panel(design), ag.part(arm, "lid", design.plastic))
        if design.lid_style == "domed":
            return body
        at = (0, 0.12 * can.depth - can.depth / 2, _surface(design))
        logo, ink = details.logo(design.maker, 0.0045, tracking=0.2), finish.ink_on(design.lid)
        return ag.weld(body, details.printed(logo, at, material=ink, facing=ag.Z, up=ag.Y))

    def turn(self, **options: Any) -> ag.Joint:
        """Make the joint of the lid; positive opens it."""
        # with the inertia of the rotor of the geared damper
        drag = feel.Feel(damping=self.design.damping, armature=0.001, effort=12.0, velocity=8.0)
        return ag.Revolute("lid_hinge", axis=-ag.X, pivot=(0, self.y, self.z), feel=drag, **options)

    def filled(self, body: ag.Body, turn: ag.Joint, floor: ag.Scalar, catch: float = 0.0) -> ag.Body:
        """Put a bucket into a bin; it lifts out as far as the open lid allows, with room for a catch [m]."""
        design, can = self.design, self.design.can
        if design.carry == "none":
            return body
        ahead = max(catch, _BEHIND)
        inner = can.inside(foot=floor + UNDER, top=can.top - LOWER, behind=ahead)
        above, reach = inner.top - self.z, self.behind + can.wall + FREE + ahead - _SPARE
        most = reach * ag.tan(ag.min_(design.opening - _SPARE_ANGLE, _UPRIGHT)) - above
        if catch:  # the tongue projects from the open lid, 60 mm from its front edge
            most = ag.min_(most, self.behind + can.depth - 0.060 - above)
        travel = ag.min_(inner.top - inner.foot + 0.03, most)
        return with_bucket(body, design, inner, travel, turn > ag.atan2(above + travel, reach))


def _surface(design: Design) -> ag.Scalar:
    """Return the height of the upper side of a flat or stepped lid [m]."""
    return design.can.top + GAP + THICK + (_STEP if design.lid_style == "stepped" else 0.0)


def _panel(design: Design) -> list[ag.Body]:
    """Make the panel of a lid."""
    can, low = design.can, design.can.top + GAP
    top = low + THICK
    radius = can.width / 2 + _OVERHANG
    slab = ag.extrude(can.outline(-_OVERHANG), THICK, bevel=_SOFT).at(z=low + THICK / 2)
    bodies = _faceted(slab, _disc(radius).at(z=low), design.lid, can)
    # sheet of 0.4 mm around air: 2-3 kg/m2 at a height of 25-35 mm
    hollow = design.lid.with_(name=f"{design.lid.name}_cushion", density=90.0)
    if design.lid_style == "domed" and can.plan == "round":
        radius, rise = radius - 0.004, 0.16 * can.width
        cushion = ag.dome(radius, height=rise).at(z=top - 0.001)
        bodies += _faceted(cushion, _cap(radius, rise).at(z=top - 0.001), hollow, can)
    elif design.lid_style == "domed":
        rise, soft = 0.016, replace(can, corner=ag.max_(can.corner, _LEAST_ROUND))
        taper = ag.min_(0.16, _SLOPE * rise / soft.diagonal)
        slope = ag.extrude(soft.outline(0.003 - _OVERHANG), rise, taper=taper, bevel=0.005)
        bodies.append(ag.part(slope.at(z=top - 0.002 + rise / 2), "lid", hollow))
    elif design.lid_style == "stepped":
        high, bevel = _STEP + 0.001, 0.0025
        if can.plan == "round":
            step = ag.cylinder(can.width / 2 - 0.014, high, bevel=bevel)
        else:
            step = ag.extrude(can.outline(0.014), high, bevel=bevel)
        bodies.append(ag.part(step.at(z=top + (_STEP - 0.001) / 2), "lid", design.lid))
    liner = ag.extrude(can.outline(can.wall + 0.006), 0.0016).at(z=low)
    return [*bodies, ag.detail(liner, "lid", finish.BLACK)]


def _faceted(seen: ag.Solid, core: ag.Solid, material: ag.Material, can: Can) -> list[ag.Body]:
    """Make one piece of a lid; a round piece has a skin without colliders over a core of few facets.

    A round slab would collide as four pieces of many vertices, a cushion as eight, and simulators find
    contacts with the flat side of so wide a cylinder only roughly.
    """
    if can.plan != "round":
        return [ag.part(seen, "lid", material)]
    return [ag.part(core, "lid", material), ag.detail(seen, "lid", material)]


def _disc(radius: ag.Scalar) -> ag.Solid:
    """Make a disc of few facets inside a slab with its underside at z = 0.

    It has four quarters, so that a lid touches a raised bucket at points all around.
    """
    wide, high = radius - 0.8 * _SOFT, THICK - 2 * _WITHIN
    section = ag.rectangle(wide, high).at(wide / 2, THICK / 2)
    quarter = ag.revolve(section, angle=math.pi / 2, sides=32)
    return ag.union(*(quarter.rotate(ag.Z, number * math.pi / 2) for number in range(4)))


def _cap(radius: ag.Scalar, rise: ag.Scalar) -> ag.Solid:
    """Make half of an ellipsoid of few facets inside a smooth one."""
    wide, high = radius - _WITHIN, rise - _WITHIN
    line = [(wide * math.cos(turn), high * math.sin(turn)) for turn in (0.0, 0.36, 0.78)]
    flat = [(0.22 * wide, 0.975 * high), (0.0, 0.975 * high)]
    return ag.revolve(ag.polygon([(0.0, 0.0), *line, *flat]), sides=15)


def _grip(design: Design, style: Grip) -> ag.Body:
    """Make the grip of a lid, as a part of it."""
    can, front = design.can, -design.can.depth / 2
    if style == "lip" or design.lid_style == "domed":
        z = can.top + GAP + THICK / 2
        lip = ag.box(0.34 * can.width, _LIP + 0.012, 0.008, bevel=0.003).at(0, front - _LIP / 2 + 0.006, z)
        hold = ag.grasp_on(lip, at=(0, front - _LIP + 0.008, z), depth=0.015)
        return ag.part(lip, "lid", design.lid, grasp=hold)
    y, top = front + 0.30 * can.depth, _surface(design)
    if style == "bar":
        bar = ag.box(0.10, 0.012, 0.008, bevel=0.003).at(0, y, top + 0.030)
        posts = pair(ag.box(0.010, 0.012, 0.032, bevel=0.002), 0.045, y, top + 0.015)
        hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y)
        return ag.part([bar, *posts], "lid", design.lid, grasp=hold)
    knob = ag.cylinder(0.017, 0.014, bevel=0.004).at(0, y, top + 0.024)
    post = ag.cylinder(0.007, 0.022).at(0, y, top + 0.008)
    hold = ag.grasp_on(knob, approach=-ag.Z, closing=ag.Y, depth=0.013)
    return ag.part([knob, post], "lid", design.lid, grasp=hold)


def pedal_bin(design: Design) -> ag.Body:
    """Make a bin with a lid that a pedal opens, through a rod behind the wall."""
    crank = design.crank
    hinge = Hinge(design, crank + 0.007, 0.006)
    linkage = Linkage(design, hinge.y - 0.87 * crank)
    body, pedal = linkage.stand(hinge.z)
    lines = (design.maker.upper(), f"TYPE {design.model}")
    at = (0, hinge.y + 0.0083, 0.45 * design.can.top)
    plate = details.rating_plate(0.026, 0.018, lines, at=at, facing=ag.Y, double_insulated=False)
    body = ag.weld(body, hinge.housing(rod=True), plate)
    # two plates and the pin between them, symmetric about the horizontal
    plates = pair(ag.box(0.0032, crank, 0.006, bevel=0.0008), 0.0066, -crank / 2)
    pin = ag.cylinder(PIN, 0.0164, axis=ag.X).at(y=-crank)
    cranks = [each.rotate(ag.X, design.opening / 2).at(0, hinge.y, hinge.z) for each in (*plates, pin)]
    turn = hinge.turn(follows=pedal * linkage.ratio, friction=design.friction)
    body = body.attach(ag.weld(hinge.lid(), ag.part(cranks, "lid", STEEL)), turn)
    return hinge.filled(body, turn, linkage.head)


def lift_bin(design: Design, grip: Grip) -> ag.Body:
    """Make a bin with a lid that a hand lifts; it falls shut, or stays open if it leans back."""
    hinge = Hinge(design, 0.016, design.can.top - _SHORT)
    body = ag.weld(stand(design), hinge.housing())
    turn = hinge.turn(limits=(0.0, design.opening), friction=design.friction)
    body = body.attach(ag.weld(hinge.lid(), _grip(design, grip)), turn)
    return hinge.filled(body, turn, design.can.foot)


def touch_bin(design: Design) -> ag.Body:
    """Make a bin with a lid that springs open when its button is pressed."""
    can, hinge = design.can, Hinge(design, 0.016, design.can.top - _SHORT)
    front, foot = -can.depth / 2, can.top - _REACH  # y of the wall, height of the tongue's lower end [m]
    bar = (
        foot + _THIN + 0.0005 + 0.002
    )  # height of the middle of the button and of its bar above the foot [m]
    wide, _, high = _CAP
    hole = ag.box(wide + 0.001, 0.04, high + 0.001).at(0, front, bar)
    body = ag.weld(stand(design, holes=hole), hinge.housing())
    spring = ag.Spring(preload=0.9, force=6.0)
    slide = ag.Prismatic("button_slide", axis=ag.Y, limits=(0.0, 0.0062), spring=spring, feel=feel.SWITCH)
    body = body.attach(_button(design), slide, at=(0, front, bar))
    y = front + _BACK
    blade = ag.Region.between(
        (-_TONGUE / 2, y - _THIN / 2, foot), (_TONGUE / 2, y + _THIN / 2, can.top + GAP + 0.004)
    )
    inward = ag.box(_TONGUE - 0.001, _FOOT + 0.001, _THIN, bevel=0.0006)
    inward = inward.at(0, y + _THIN / 2 + (_FOOT - 0.001) / 2, foot + _THIN / 2)
    tongue = ag.part([blade.box(bevel=0.0008), inward], "lid", design.plastic)
    lid = ag.weld(hinge.lid(), tongue)
    # an opening spring, a third stronger than the weight of the lid and the friction
    weight = lid.weight() * (hinge.y - lid.center_of_mass().y)
    # the foot passes the pressed bar after it has risen by the heights of both, with 3 mm to spare
    passed = (_THIN + 0.004 + 0.004) / (0.85 * can.depth)
    turn = hinge.turn(
        limits=(0.0, design.opening),
        spring=ag.Spring(preload=-1.35 * weight - _FRICTION, force=-0.45 * weight),
        friction=_FRICTION,
        needs=(slide > 0.0049).until(passed),
        driven="its spring",
    )
    return hinge.filled(body.attach(lid, turn), turn, can.foot, _ROOM)


def _button(design: Design) -> ag.Body:
    """Make the button with its bar, about the middle of its hole: the link `button`."""
    cap = ag.box(*_CAP, bevel=0.003).at(y=_CAP[1] / 2 - 0.009)  # 9 mm in front of the wall
    near, far = 0.001, _BACK + _THIN / 2 + 0.0008
    bar = ag.box(_TONGUE + 0.010, 0.004, 0.004, bevel=0.0006).at(y=far + 0.002)
    arms = pair(ag.box(0.003, far + 0.004 - near, 0.004), _TONGUE / 2 + 0.0032, (near + far + 0.004) / 2)
    push = ag.push_on(cap, direction=ag.Y)
    return ag.weld(
        ag.part(cap, "button", design.trim, push=push), ag.part([bar, *arms], "button", design.plastic)
    )
