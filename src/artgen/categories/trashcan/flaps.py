"""Butterfly bins: two flaps in a frame, opened by a pedal or by hands."""

from typing import Any

import artgen as ag
from artgen import feel
from artgen.categories.trashcan.bins import FREE, LOWER, STEEL, UNDER, Design, pair, stand, with_bucket
from artgen.categories.trashcan.pedals import PIN, Linkage

_THICK = 0.009  # thickness of flaps [m]
_EDGE = 0.0055  # radius of the outer edge of flaps, about the axis [m]
_GAP = 0.0028  # gap around the flaps [m]
_BORDER = 0.017  # distance from the outside of the frame to its opening, at the sides and in front [m]
_SHAFT = 0.0038  # radius of the shafts of the cranks [m]
_DEEP = 0.026  # depth of the housing behind the rim [m]
_TAB = 0.014  # height of a tab above its flap [m]
_SPARE = 0.035  # opening angle of flaps beyond the angle that buckets need [rad]


class _Flaps:
    """Two flaps and their frame on a bin with straight sides."""

    def __init__(self, design: Design, *, stepped_on: bool) -> None:
        self.design, can = design, design.can
        self.opening = ag.Region(
            (_BORDER - can.width / 2, can.width / 2 - _BORDER),
            (_BORDER - can.depth / 2, can.depth / 2 - _BORDER),
            (can.top - 0.001, can.top + 0.010),
        )
        self.top = self.opening.z.high  # height of the frame's upper face [m]
        self.level = self.top - _EDGE  # height of both axes [m]
        self.axis = self.opening.x.high - _EDGE - _GAP  # distance from the middle to each axis [m]
        self.reach = self.axis - _GAP / 2  # distance from an axis to the tip of its flap [m]
        self.rod = can.depth / 2 + _DEEP / 2  # position of the cranks and the rod along y [m]
        self.linkage = Linkage(design, self.rod) if stepped_on else None

    def frame(self) -> ag.Body:
        """Make the frame, which is welded to the bin, and the housing behind it for a rod."""
        opening = self.opening
        ring = self.design.can.outline(-0.001) - opening.plan(radius=0.004)
        if self.linkage is not None:
            slot = ag.rectangle(2 * _SHAFT + 0.003, 0.1)
            for way in (-1, 1):
                ring = ring - slot.at(way * self.axis, opening.y.high + 0.049)
        solid = ag.simplified_collider(ag.extrude(ring, opening.z.size)).at(z=opening.z.mid)
        body = ag.part(solid, "rim", self.design.trim)
        return body if self.linkage is None else ag.weld(body, self._housing(self.linkage))

    def _housing(self, linkage: Linkage) -> ag.Body:
        """Make the box behind the rim around the cranks, open below for the rod."""
        back, half = self.design.can.depth / 2, self.axis + 0.014
        low, high = self.level - 0.034, self.level + linkage.lift / 2 + PIN + 0.005
        room = ag.Region((-half, half), (back - 0.003, back + _DEEP), (low, high))
        post = ag.Region((-0.022, 0.022), room.y, (0.006, low + 0.004))  # around the rod, down to the floor
        near, far = room.y
        # boards are a little smaller at their joints, so that no two faces are coplanar
        boards = [
            room.with_(z=(high - 0.003, high)),
            room.shrink(x=0.001).with_(
                y=(near + 0.0006, near + 0.0036), z=(self.top - 0.0006, high - 0.0006)
            ),
            room.shrink(x=0.0007, z=0.00035).with_(y=(far - 0.0036, far - 0.0006)),
            post.shrink(x=0.0008, z=0.0005).with_(y=(far - 0.0041, far - 0.0011)),
            *room.shrink(x=0.0003, y=0.0012, z=0.0006).across(0.003, None, 0.003)[::2],
            *post.shrink(y=0.0018).across(0.003, None, 0.003)[::2],
        ]
        start, end = self.opening.y.high + 0.001, near + 0.002
        strip = ag.box(0.024, end - start, 0.003, bevel=0.0008)  # over the slot of a shaft
        solids = [each.box(bevel=0.001) for each in boards]
        solids += pair(strip, self.axis, (start + end) / 2, self.top + 0.0012)
        return ag.part(solids, "hinge", self.design.trim)

    def flap(self, side: int) -> ag.Body:
        """Make one flap about its axis: the link `lid_left` (side -1) or `lid_right`."""
        design, reach = self.design, self.reach
        long = self.opening.y.size - 2 * _GAP
        slab = ag.box(reach, long, _THICK, bevel=0.0022).at(-side * reach / 2, 0, _EDGE - _THICK / 2)
        solids = [ag.cylinder(_EDGE, long - 0.001, axis=ag.Y, bevel=0.001), slab]
        hold: list[ag.Frame] = []
        if self.linkage is None:  # a tab about 0.55 of the way to the front, within the frame
            back = self.opening.y.high
            wide = ag.min_(0.060, 0.9 * back - 2 * _GAP - 0.002)
            tab = ag.box(0.007, wide, _TAB + 0.004, bevel=0.002)
            tab = tab.at(side * (0.022 - self.axis), -0.55 * back, _EDGE + _TAB / 2 - 0.002)
            hold = [ag.grasp_on(tab, approach=-ag.Z, closing=ag.X, depth=0.011)]
            solids.insert(0, tab)
        under = ag.box(reach - 0.020, long - 0.02, 0.001).at(-side * (reach / 2 + 0.003), 0, _EDGE - _THICK)
        name = "lid_left" if side < 0 else "lid_right"
        body = ag.weld(
            ag.part(solids, "lid", design.lid, name=name, grasp=hold), ag.detail(under, "lid", design.plastic)
        )
        if self.linkage is None:
            return body
        shaft = ag.cylinder_between((0, self.opening.y.high - 0.006, 0), (0, self.rod + 0.0062, 0), _SHAFT)
        plate = ag.box(design.crank, 0.0032, 0.006, bevel=0.0008).at(-side * design.crank / 2, 0.0046)
        pin = ag.cylinder(PIN, 0.0124, axis=ag.Y).at(-side * design.crank)
        crank = [each.rotate(ag.Y, -side * design.opening / 2).at(y=self.rod) for each in (plate, pin)]
        return ag.weld(body, ag.part([shaft, *crank], "lid", STEEL))

    def crossbar(self, linkage: Linkage) -> ag.Solid:
        """Make the crossbar that lifts both cranks."""
        z = self.level - linkage.lift / 2 - PIN - 0.0037
        half = self.axis - 0.6 * self.design.crank
        return ag.box(2 * half, 0.0055, 0.005, bevel=0.001).at(0, self.rod - 0.003, z)


def butterfly_bin(design: Design, *, stepped_on: bool) -> ag.Body:
    """Make a bin with two flaps, opened by a pedal or by hands."""
    can, opening = design.can, design.opening
    flaps = _Flaps(design, stepped_on=stepped_on)
    if flaps.linkage is None:
        floor, body = can.foot, stand(design)
        motion: dict[str, Any] = {"limits": (0.0, opening)}
    else:
        floor = flaps.linkage.head
        body, pedal = flaps.linkage.stand(flaps.level, [flaps.crossbar(flaps.linkage)])
        motion = {"follows": pedal * flaps.linkage.ratio}
    body = ag.weld(body, flaps.frame())
    drag = feel.Feel(
        friction=design.friction, damping=design.damping, armature=0.0003, effort=5.0, velocity=8.0
    )
    turns = []
    for side, name in ((-1, "left"), (1, "right")):
        turn = ag.Revolute(f"lid_hinge_{name}", axis=side * ag.Y, feel=drag, **motion)
        body = body.attach(flaps.flap(side), turn, at=(side * flaps.axis, 0, flaps.level))
        turns.append(turn)
    aside = 0.010 + flaps.reach / ag.tan(opening - _SPARE)  # distance from an axis to an open flap's tip [m]
    beside = can.width / 2 - can.wall - FREE - flaps.axis + aside
    inner = can.inside(foot=floor + UNDER, top=can.top - LOWER, beside=beside, behind=0.015)
    angle = ag.atan2(flaps.reach, aside - _THICK)  # both flaps clear the bucket, which rises between them
    clear = (turns[0] > angle) & (turns[1] > angle)
    return with_bucket(body, design, inner, inner.top - inner.foot + 0.03, clear)
