"""Kinds of bins, each assembled from stand, cover, mechanism and bucket."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.trashcan.bins import Can
from artgen.categories.trashcan.finish import bag, lid_of, plate, top_mark
from artgen.categories.trashcan.hoods import Flaps, Hood, Turning
from artgen.categories.trashcan.lids import (
    GAP,
    ROOM,
    SPARE,
    STEP,
    Catch,
    Grip,
    Hinge,
    LidStyle,
    lid_grip,
    lid_panel,
    sprung_lid,
)
from artgen.categories.trashcan.pedals import SLOT, Linkage
from artgen.categories.trashcan.shells import (
    Dress,
    Looks,
    bail_play,
    bucket,
    bucket_slide,
    rolled_rim,
    stand,
    with_bail,
)

Carry = Literal["none", "loop", "bail"]
"""Handle of an inner bucket; none for no bucket."""

THICK = 0.012
"""Thickness of lids [m]."""

_PLATE = 0.040  # length of the foot plate [m]
_UNDER = 0.0036  # distance from the floor's underside to the bucket: the floor and 0.6 mm [m]
_LOWER = 0.0003  # distance of a bucket's rim below that of the bin [m]
_FREE = 0.0036  # gap between a bucket and the wall [m]
_BUCKET = 0.0022  # thickness of the wall of a bucket [m]
_SPARE = 0.035  # opening angle of lids beyond the angle that buckets need [rad]
_UPRIGHT = 1.53  # least angle of an open lid that clears all parts [rad]
_TONGUE = 0.060  # distance from the front edge of a lid to the end of the catch on it [m]
_OVER = 0.03  # height of the foot of lifted buckets above the rim [m]
_SHORT = 0.055  # height of a hinge block without a rod in it [m]
_BEHIND = 0.005  # additional space for a bucket in front and behind [m]
_DAMPED = 0.08  # least damping of a lid with a damper beside its hinge [N m s/rad]
_STEEL = ag.material("steel")


@dataclass(frozen=True)
class Lid:
    """Style and motion of a lid."""

    style: LidStyle  # style of the lid
    opening: ag.Scalar  # opening angle of the lid [rad]
    friction: ag.Scalar  # friction of the hinge [N m]
    damping: float  # damping of the hinge, with a damper for soft closing [N m s/rad]


@dataclass(frozen=True)
class Foot:
    """Foot-operated mechanism."""

    crank: ag.Scalar  # length of the lid's crank [m]
    travel: ag.Scalar  # travel of the foot plate [m]
    width: ag.Scalar  # width of the foot plate [m]
    preload: ag.Scalar  # spring force at the foot plate at rest [N]
    force: ag.Scalar  # spring force at the end of the travel [N]


@dataclass(frozen=True)
class Draft:
    """Common data of bins of all kinds."""

    can: Can  # shell of the bin
    looks: Looks  # materials of the bin
    dress: Dress  # bands around the wall
    carry: Carry  # handle of the inner bucket
    inner: ag.Material  # material of the bucket
    maker: str  # brand name on the lid
    model: int  # model number

    def lift_out(
        self,
        body: ag.Body,
        can: Can,
        *,
        travel: ag.Scalar,
        needs: ag.Condition | None,
        above: ag.Scalar = GAP + _LOWER,
    ) -> ag.Body:
        """Put a bucket into a bin, with a joint to lift it out."""
        inside = bucket(can, finish=self.inner, loop=self.carry == "loop")
        if self.carry == "bail":
            raised: ag.Dependency | None = None if needs is None else needs.beyond(bail_play(can, above))
            inside = with_bail(inside, can, finish=_STEEL, needs=raised)
        return body.attach(inside, bucket_slide(inside, travel=travel, needs=needs))

    def linkage(self, *, opening: ag.Scalar, crank: ag.Scalar, travel: ag.Scalar, rod: ag.Scalar) -> Linkage:
        """Return the levers between a pedal in front and a rod behind."""
        return Linkage(opening, crank, travel, self.can.front - 0.008 - _PLATE / 2.0, rod)

    def step(self, body: ag.Body, linkage: Linkage, pedal: ag.Joint, *, width: ag.Scalar) -> ag.Body:
        """Attach a pedal under a bin."""
        metal = ag.material("stainless") if self.looks.finish.base_metalness > 0.5 else self.looks.trim
        metal = metal.with_(name=f"{metal.name}_pedal", density=2400.0)  # a pressing with ribs below
        return body.attach(linkage.pedal(finish=metal, width=width, deep=_PLATE), pedal)

    def cover(self, hinge: Hinge, lid: Lid) -> ag.Body:
        """Make a lid with its arm: the link `lid`."""
        can, looks, low = self.can, self.looks, self.can.top + GAP
        arm = (ag.part(each, "lid", looks.plastic) for each in hinge.arm(low, THICK))
        body = ag.weld(lid_panel(can, low=low, thick=THICK, style=lid.style, finish=looks.lid), *arm)
        if lid.style == "domed":
            return body
        y, top = can.front + 0.12 * can.depth, low + THICK + (STEP if lid.style == "stepped" else 0.0)
        return ag.weld(body, top_mark(self.maker, (0.0, y, top), looks.lid))

    def filled(
        self,
        body: ag.Body,
        hinge: Hinge,
        turn: ag.Joint,
        *,
        opening: ag.Scalar,
        floor: ag.Scalar,
        room: float = 0.0,
    ) -> ag.Body:
        """Put a bucket into a bin with a hinged lid; it lifts out as far as the open lid allows."""
        if self.carry == "none":
            return body
        can = self.can
        ahead = max(room, _BEHIND)
        inner = can.inside(_FREE, foot=floor + _UNDER, top=can.top - _LOWER, sheet=_BUCKET, behind=ahead)
        above = inner.top - hinge.axis[1]
        reach = can.wall + _FREE + ahead
        most = (hinge.behind + reach - SPARE) * ag.tan(ag.min_(opening - _SPARE, _UPRIGHT)) - above
        if room:  # the tongue projects from the open lid
            most = ag.min_(most, hinge.behind + can.depth - _TONGUE - above)
        travel = ag.min_(inner.top - inner.foot + _OVER, most)
        return self.lift_out(body, inner, travel=travel, needs=turn > hinge.clear(above + travel, reach))

    def sticker(self, at: ag.VectorLike) -> ag.Body:
        """Make the plate with type and maker on the back of a bin."""
        return plate(at, (self.maker.upper(), f"TYPE {self.model}"))

    def slot(self, linkage: Linkage) -> ag.Solid:
        """Make the cutter for the slots of the lever in the wall, in front and behind."""
        high = linkage.head - 0.001
        return ag.box(SLOT, self.can.depth + 0.1, high + 0.02).at(0.0, 0.0, (high - 0.02) / 2.0)


def open_bin(draft: Draft, *, bagged: bool) -> ag.Body:
    """Make an open bin: its liner, or the ring that holds its bag, lifts out."""
    can, looks = draft.can, draft.looks
    body = stand(can, looks, floor=can.foot, dress=draft.dress, rim=0.0)
    if draft.carry != "none":
        body = ag.weld(body, rolled_rim(can, looks.finish))
        liner = can.inside(_FREE, foot=can.foot + _UNDER, top=can.top + 0.006, sheet=_BUCKET)
        return draft.lift_out(body, liner, travel=liner.top - liner.foot, needs=None)
    ring = Hood(can, "ring", 0.014, 0.0, looks.trim)
    top = ring.body(looks.bright)
    return ag.weld(body, *([bag(can)] if bagged else ())).attach(top, ring.lift(top, travel=0.12))


def hooded_bin(draft: Draft, kind: Turning, *, opening: ag.Scalar, rise: ag.Scalar) -> ag.Body:
    """Make a bin with a lid that turns in a hood; the bag is in the bin itself."""
    can, looks = draft.can, draft.looks
    hood = Hood(can, kind, rise, 0.14, looks.lid)
    light = {"swing": 280.0, "disc": 280.0, "ball": 110.0}[kind]
    lid = hood.lid(finish=lid_of(looks.lid, light), dark=ag.material("black_abs"))
    top = hood.body(looks.bright).attach(lid, hood.turn(lid, opening=opening))
    body = stand(can, looks, floor=can.foot, dress=draft.dress, rim=0.0)
    body = body.attach(top, hood.lift(top, travel=0.4 * can.width))
    return body.require(
        hood.dip(opening) > can.foot + 0.01,
        "the lid would turn down to the floor of the bin: raise height, or lower width or aspect",
    )


def butterfly_bin(draft: Draft, lid: Lid, foot: Foot | None) -> ag.Body:
    """Make a bin with two flaps, opened by a pedal or by hands."""
    can, looks, opening = draft.can, draft.looks, lid.opening
    flaps = Flaps(can, opening)
    linkage = None
    if foot is not None:
        linkage = draft.linkage(opening=opening, crank=foot.crank, travel=foot.travel, rod=flaps.crank_y)
    floor = can.foot if linkage is None else linkage.head
    holes = None if linkage is None else draft.slot(linkage)
    body = stand(can, looks, floor=floor, dress=draft.dress, holes=holes)
    body = ag.weld(body, flaps.frame(looks.trim, linkage))
    pedal = None
    if linkage is not None and foot is not None:
        pedal = linkage.turn(preload=foot.preload, force=foot.force)
        body = ag.weld(body, linkage.bracket(floor=floor, depth=can.depth, finish=looks.plastic))
        body = draft.step(body, linkage, pedal, width=foot.width)
        rod = linkage.rod_body(axis=flaps.level, finish=_STEEL)
        rod = ag.weld(rod, flaps.crossbar(linkage, _STEEL))
        body = body.attach(rod, linkage.rod_slide(pedal))
    turns = [
        flaps.turn(side, linkage=linkage, pedal=pedal, friction=lid.friction, damping=lid.damping)
        for side in (-1, 1)
    ]
    for side, turn in zip((-1, 1), turns, strict=True):
        body = body.attach(flaps.flap(side, finish=looks.lid, dark=looks.plastic, linkage=linkage), turn)
    aside = 0.010 + flaps.reach / ag.tan(opening - _SPARE)
    inner = can.inside(
        _FREE,
        foot=floor + _UNDER,
        top=can.top - _LOWER,
        sheet=_BUCKET,
        beside=can.width / 2.0 - can.wall - _FREE - flaps.axis + aside,
        behind=0.015,
    )
    angle = flaps.clear(0.0, aside)
    return draft.lift_out(
        body, inner, travel=inner.top - inner.foot + _OVER, needs=(turns[0] > angle) & (turns[1] > angle)
    )


def pedal_bin(draft: Draft, lid: Lid, foot: Foot) -> ag.Body:
    """Make a bin with a lid that a pedal opens, through a rod behind the wall."""
    can, looks = draft.can, draft.looks
    hinge = Hinge(can, foot.crank + 0.007, 0.006)
    linkage = draft.linkage(
        opening=lid.opening, crank=foot.crank, travel=foot.travel, rod=hinge.axis[0] - 0.87 * foot.crank
    )
    floor = linkage.head
    body = ag.weld(
        stand(can, looks, floor=floor, dress=draft.dress, holes=draft.slot(linkage)),
        linkage.bracket(floor=floor, depth=can.depth, finish=looks.plastic),
        hinge.housing(looks.plastic, sill=False, damper=lid.damping > _DAMPED),
        draft.sticker((0.0, hinge.far, 0.45 * can.top)),
    )
    pedal = linkage.turn(preload=foot.preload, force=foot.force)
    body = draft.step(body, linkage, pedal, width=foot.width)
    rod = linkage.rod_body(axis=hinge.axis[1], finish=_STEEL)
    body = body.attach(rod, linkage.rod_slide(pedal))
    cranks = (ag.part(each, "lid", _STEEL) for each in linkage.cranks(axis=hinge.axis))
    turn = hinge.turn(linkage=linkage, pedal=pedal, friction=lid.friction, damping=lid.damping)
    body = body.attach(ag.weld(draft.cover(hinge, lid), *cranks), turn)
    return draft.filled(body, hinge, turn, opening=lid.opening, floor=floor)


def lift_bin(draft: Draft, lid: Lid, grip: Grip) -> ag.Body:
    """Make a bin with a lid that a hand lifts; it falls shut, or stays open if it leans back."""
    can, looks = draft.can, draft.looks
    hinge = Hinge(can, 0.016, can.top - _SHORT)
    solids, holds = lid_grip(can, low=can.top + GAP, thick=THICK, style=grip, lid=lid.style)
    held = [
        ag.part(each, "lid", looks.lid, grasp=() if index else holds) for index, each in enumerate(solids)
    ]
    body = ag.weld(stand(can, looks, floor=can.foot, dress=draft.dress), hinge.housing(looks.plastic))
    turn = hinge.turn(opening=lid.opening, friction=lid.friction, damping=lid.damping)
    body = body.attach(ag.weld(draft.cover(hinge, lid), *held), turn)
    return draft.filled(body, hinge, turn, opening=lid.opening, floor=can.foot)


def touch_bin(draft: Draft, lid: Lid) -> ag.Body:
    """Make a bin with a lid that springs open when its button is pressed."""
    can, looks = draft.can, draft.looks
    hinge, catch = Hinge(can, 0.016, can.top - _SHORT), Catch(can)
    body = stand(can, looks, floor=can.foot, dress=draft.dress, holes=catch.hole())
    body = ag.weld(body, hinge.housing(looks.plastic))
    press = catch.press()
    body = body.attach(catch.button(looks.trim, looks.plastic), press)
    tongue = (ag.part(each, "lid", looks.plastic) for each in catch.tongue(can.top + GAP))
    cover = ag.weld(draft.cover(hinge, lid), *tongue)
    turn = sprung_lid(hinge, cover, opening=lid.opening, needs=catch.frees(press), damping=lid.damping)
    return draft.filled(body.attach(cover, turn), hinge, turn, opening=lid.opening, floor=can.foot, room=ROOM)
