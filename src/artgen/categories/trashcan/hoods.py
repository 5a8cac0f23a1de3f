"""Bins without a hinged lid: with a hood in which a lid turns, or open with a ring that holds a bag.

A swing lid tips about its middle and springs back; a disc turns in its rim; a ball (a half ball, closed
below) rolls under its collar. All three turn about an axis along x over the middle of the bin.
"""

from dataclasses import replace
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.trashcan import finish
from artgen.categories.trashcan.bins import UNDER, Design, pair, stand, with_bucket

Turning = Literal["swing", "disc", "ball"]

_SKIN = 0.003  # thickness of the skirt of a hood outside the gap [m]
_OVER = 0.0026  # gap between the rim and the skirt around it [m]
_ON = 0.0022  # gap between the rim and the part on it [m]
_EDGE = 0.0030  # gap between a lid and the edge of its opening [m]
_EAR = 0.020  # projection of the ears by which a hood is lifted [m]
_WIDEST = 0.425  # largest width of a round collar that collides as 32 pieces and not as 64 [m]
_TOO_WIDE = "the collar of so wide a round bin needs too many colliders: lower width"
_LEAN = 0.14  # share by which the top of a hood is smaller than its skirt
# of a lid in a hood: density with its inside [kg/m3]; stiffness [N m/rad], damping [N m s/rad] and friction
# [N m] of its axis
_LIDS = {"swing": (280.0, 0.16, 0.012, 0.003), "disc": (280.0, 0, 0.02, 0.05), "ball": (110.0, 0, 0.04, 0)}


class _Hood:
    """A hood over the rim of a bin, or a ring on it, which has no lid."""

    def __init__(self, design: Design, kind: Turning | Literal["ring"], material: ag.Material) -> None:
        can = design.can
        self.can, self.kind, self.material = can, kind, material
        self.label = "ring" if kind == "ring" else "hood"
        self.low = can.top + _ON  # height of the underside, just above the rim [m]
        rise = {"swing": 0.17 * can.width, "ring": 0.014}.get(kind, 0.024)
        self.top = self.low + rise  # height of the upper face [m]
        self.axis = self.top - (0.003 if kind == "ball" else 0.005)  # height of the axis of the lid [m]
        # width and depth of the opening [m]
        share = 1 - _LEAN
        self.across, self.along = can.width - 0.030, can.depth - 0.030
        if kind == "ball":
            self.across = self.along = can.width - 2 * (can.wall + 0.004)
        elif kind == "ring":
            self.across, self.along = can.width - 0.012, can.depth - 0.012
        elif kind == "swing" and can.plan == "round":
            self.along = 0.66 * share * can.width
            self.across = 1.06 * self.along
        elif kind == "swing":
            self.across, self.along = share * can.width - 0.042, share * can.depth - 0.042

    def hole(self, gap: ag.Scalar = 0.0) -> ag.Profile:
        """Make the opening, smaller by a gap all around."""
        if self.kind == "ball" or (self.kind != "swing" and self.can.plan == "round"):
            return ag.circle(self.across / 2 - gap)
        share = 1.0 if self.kind == "ring" else 1 - _LEAN
        radius = ag.max_(share * self.can.corner - (self.can.width - self.across) / 2, 0.006)
        if self.kind == "swing":
            radius = ag.min_(radius, 0.008)  # the lid has no round corners
        return ag.rectangle(self.across - 2 * gap, self.along - 2 * gap, radius=radius)

    def body(self) -> ag.Body:
        """Make the hood: the link `hood` or `ring`."""
        can, label, material = self.can, self.label, self.material
        out, high, middle = -(_OVER + _SKIN), self.top - self.low, (self.low + self.top) / 2
        if self.kind == "swing":
            ring, sheet = can.outline(out) - can.outline(0.0015), 0.003
            slope = ag.simplified_collider(ag.extrude(ring, high, taper=_LEAN), 0.0008)
            plate = ag.extrude(can.outline(out).scale(1 - _LEAN) - self.hole(), sheet, bevel=0.0006)
            plate = ag.simplified_collider(plate, 0.0005).at(z=self.top - sheet / 2 + 0.0008)
            solids = [slope.at(z=middle), plate]
        else:
            collar = ag.extrude(can.outline(out) - self.hole(), high, bevel=0.0010)
            if can.plan == "round":
                collar = collar.require(can.width < _WIDEST, _TOO_WIDE)
            solids = [ag.simplified_collider(collar, 0.0007).at(z=middle)]
        skirt = replace(can, taper=0.0).band(can.top - 0.014, self.low + 0.004, out, -_OVER)
        bodies = [ag.detail(skirt, label, material)]
        x, chrome = self.across / 2, ag.material("chrome")
        if self.kind == "ball":  # caps over its pins
            solids += pair(ag.box(0.010, 0.030, 0.018, bevel=0.003), x + 0.0052, z=self.top + 0.006)
            screw = ag.cylinder(0.0045, 0.003, axis=ag.X, bevel=0.0008)
            bodies.append(ag.detail(pair(screw, x + 0.0102, z=self.top + 0.006), "screw", chrome))
        elif self.kind != "ring":  # bearings under the plate beside the lid, with pins up to the lid
            solids += pair(ag.box(0.007, 0.016, 0.014, bevel=0.0012), x + 0.0036, z=self.top - 0.009)
            pin = ag.cylinder(0.003, 0.0063, axis=ag.X)
            bodies.append(ag.detail(pair(pin, x + 0.00035, z=self.axis), label, chrome))
        return ag.weld(ag.part(solids, label, material), *bodies, *self._ears())

    def _ears(self) -> list[ag.Body]:
        """Make the ears at both sides, for the hands that lift the hood."""
        x, z = self.can.width / 2 + _OVER + _SKIN, self.low + 0.0045
        ears = pair(ag.box(_EAR + 0.003, 0.055, 0.005, bevel=0.0016), x + _EAR / 2 - 0.0015, z=z)
        bodies = []
        for way, side, ear in zip((-1, 1), ("left", "right"), ears, strict=True):
            at = (way * (x + 0.012), 0, z)
            hold = ag.grasp_on(ear, approach=(-way, 0, 0), closing=ag.Z, at=at, depth=0.016)
            name = f"{self.label}_ear_{side}"
            bodies.append(ag.part(ear, self.label, self.material, name=name, grasp=hold))
        return bodies

    def lift(self, body: ag.Body, travel: ag.Scalar) -> ag.Joint:
        """Make the joint of a hood, which is lifted off."""
        # friction of the skirt on the rim
        drag = feel.Feel(friction=1.0, damping=4.0, effort=1.4 * body.weight() + 3.0)
        return ag.Prismatic(f"{self.label}_lift", axis=ag.Z, limits=(0.0, travel), feel=drag)

    def lid(self, material: ag.Material) -> ag.Body:
        """Make the turning part of the hood, about its axis: the link `lid`."""
        if self.kind == "ball":
            return self._ball(material)
        across, along = self.across, self.along
        if self.kind == "disc":
            lid = ag.extrude(self.hole(_EDGE), 0.006, bevel=0.0022)
            bottom = ag.extrude(self.hole(_EDGE + 0.006), 0.001).at(z=-0.003)
            push = [ag.push_on(lid, direction=-ag.Z, at=(0, y, 0)) for y in (-0.33 * along, 0.33 * along)]
        else:
            length, rise = along - 2 * _EDGE, 0.11 * along
            radius = (length * length / 4 + rise * rise) / (2 * rise)
            arc = ag.circle(radius).at(0, rise - radius)
            section = arc & ag.rectangle(length, rise + 0.004).at(0, rise / 2 - 0.002)
            lid = ag.extrude(section, across - 2 * _EDGE, axis=ag.X, bevel=0.0012)
            bottom = ag.box(across - 0.02, length - 0.014, 0.001).at(z=-0.004)
            push = []
            for y in (-0.33 * along, 0.33 * along):  # normal to the arch
                high = (radius * radius - y * y) ** 0.5
                at = (0, y, rise - radius + high - 0.004)
                push.append(ag.push_on(lid, direction=(0, -y, -high), at=at))
        return ag.weld(ag.part(lid, "lid", material, push=push), ag.detail(bottom, "lid", finish.BLACK))

    def _ball(self, material: ag.Material) -> ag.Body:
        radius = self.across / 2 - 0.0052  # its colliders are up to 2 mm off the surface
        bar = ag.box(0.090, 0.011, 0.009, bevel=0.003).at(z=radius + 0.026)
        # drop of the ball from its top to a point under a post
        drop = radius - ag.sqrt(radius * radius - 0.040**2)
        longer = ag.max_(drop - 0.0065, 0.0)
        post = ag.box(0.009, 0.011, 0.036 + longer, bevel=0.002)
        bars = [bar, *pair(post, 0.040, z=radius + 0.010 - longer / 2)]
        hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y)
        return ag.weld(
            ag.part(ag.dome(radius), "lid", material),
            ag.part(bars, "lid", finish.BLACK, grasp=hold),
            ag.detail(ag.cylinder(radius - 0.006, 0.001), "lid", finish.BLACK),
        )


def hooded_bin(design: Design, kind: Turning) -> ag.Body:
    """Make a bin with a lid that turns in a hood; the bag is in the bin itself."""
    can, opening = design.can, design.opening
    hood = _Hood(design, kind, design.lid)
    density, stiffness, damping, friction = _LIDS[kind]
    lid = hood.lid(finish.lid_of(design.lid, density))
    holds = 1.5 * lid.weight() * 0.45 * hood.across / 2 if kind == "ball" else friction
    drag = feel.Feel(friction=holds, damping=damping, armature=0.0003, effort=6.0)
    turn = ag.Revolute("lid_hinge", axis=ag.X, limits=(-opening, opening), stiffness=stiffness, feel=drag)
    top = hood.body().attach(lid, turn, at=(0, 0, hood.axis))
    body = stand(design, rim=False).attach(top, hood.lift(top, 0.4 * can.width))
    return body.require(
        hood.axis - 0.5 * hood.along * ag.sin(opening) > can.foot + 0.01,
        "the lid would turn down to the floor of the bin: raise height, or lower width or aspect",
    )


def open_bin(design: Design, *, bagged: bool) -> ag.Body:
    """Make an open bin: its liner, or the ring that holds its bag, lifts out."""
    can = design.can
    body = stand(design, rim=False)
    if design.carry != "none":
        rolled = can.band(can.top - 0.010, can.top + 0.0015, -0.0028, can.wall + 0.001)
        liner = can.inside(foot=can.foot + UNDER, top=can.top + 0.006)
        body = ag.weld(body, ag.detail(rolled, "rim", design.finish))
        return with_bucket(body, design, liner, liner.top - liner.foot)
    if bagged:  # the bag is folded over the rim
        film = ag.material("polypropylene").with_(
            name="bag_film", base_color=(0.78, 0.79, 0.80), specular_roughness=0.35, density=920.0
        )
        folded = can.band(can.top - 0.045, can.top + 0.0008, -0.0009, 0.0002)
        body = ag.weld(body, ag.detail(folded, "bag", film))
    ring = _Hood(design, "ring", design.trim)
    top = ring.body()
    return body.attach(top, ring.lift(top, 0.12))
