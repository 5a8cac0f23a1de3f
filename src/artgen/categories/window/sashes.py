"""Hinged and sliding sashes in their frames, modeled about the middle of the opening with the inside at +y.

Windows that open inwards are mirrored; awnings, and sashes that pass each other sideways, are turned by 90
degrees.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared.fronts import Opening, panes_in
from artgen.categories.window import frame, hardware
from artgen.categories.window.frame import SEALED, STOP, STRIP, Draft, ring_of
from artgen.categories.window.hardware import BARREL, LEVER_OUT, REBATE

PANE = 0.012
"""Modeled thickness of insulating glass, with the mass of its panes [m]."""

_LIP = 0.0075  # overlap of the lip of a sash with the frame around it [m]
_HOLDS = 1.15  # ratio of the friction of a stay to the load of a sash
_LIFTS = 52.0  # largest force of a hand that lifts an awning [N]
_HINGED = 0.288  # least side length of a sash with two hinges [m]
_LOCKED = 0.228  # least side length of a sash with two keeps and visual-only hinges [m]
_LIP_LONG, _HAND = 0.09, 0.034  # length of the lip of an outer sash, and half a hand over it [m]
_TRACK = 0.004  # gap between the edges of sliding sashes and the frame [m]
_BALANCE = 8.0  # stiffness of the springs of a hung sash [N/m]
_LET_IN = 0.0005  # depth of fitted parts in the face [m]
_LOCK = 0.045  # height of a sash lock above the meeting rail [m]
_ROOM = 0.006  # space beyond the ends of a pull for its flanges [m]

_LEVERS_MEET = (
    "the levers of two sashes that open towards each other would collide: lower swing or lever_length, "
    "raise width, or take hands=same"
)
_TOO_SHORT = (
    "a sash has no room for its hinges and for two keeps: raise height, or width of an awning, or upper of a "
    "cross"
)
_LEVER_LONG = (
    "the end of a lever would strike the frame as its sash opens outwards: lower lever_length, or raise "
    "height, or width of an awning, or upper of a cross"
)
_LEVER_NEAR = (
    "the lever of a narrow sash would strike the frame as it opens outwards: raise width, or height of an "
    "awning"
)
_LOCK_MEETS = (
    "the lock of a narrow sash would strike its keeps as it opens: raise width, or height of an awning"
)
_PULL_MEETS = "the pull has no room between its latch and the strip at the head: lower bar or raise height"
_HANDLE = feel.Feel(damping=0.05, armature=0.0008, effort=12)  # held by the detents of its gear


def _panes(draft: Draft, width: ag.Scalar, height: ag.Scalar, thickness: ag.Scalar) -> list[ag.Body]:
    opening = Opening(width, height, [(0.0, 0.0, 0.0)], 1, draft.finish, "pane")
    return panes_in(opening, thickness, draft.columns + 1, draft.rows + 1, draft.glass, pane=PANE)


def _lipped_sash(draft: Draft, width: ag.Scalar, height: ag.Scalar) -> ag.Body:
    """Make a sash that closes an opening about the origin: its lip is in front of the frame at y = 0."""
    section, face, depth = draft.section, draft.section.sash, draft.section.depth
    front, over, chamfer = SEALED + section.lip, REBATE + _LIP, 0.006
    outline = [
        (0, -depth), (face, -depth), (face, front - chamfer), (face - chamfer, front), (-over, front),
        (-over, SEALED), (0, SEALED),
    ]  # fmt: skip
    bands = [((-over, face - chamfer), (-front, -SEALED)), ((0, face), (chamfer - front, depth))]
    wide, high, eased = width - 2 * REBATE, height - 2 * REBATE, section.eased
    seen = ag.polygon(outline, radius=eased)
    ring = ring_of(bands, wide, high, "pane", draft.finish, eased=eased, outline=seen)
    panes = _panes(draft, wide - 2 * face, high - 2 * face, depth + front)
    return ag.weld(ring, *(each.at(y=(depth - front) / 2) for each in panes))


def _plain_sash(draft: Draft, place: ag.Region, push: ag.Frame | Sequence[ag.Frame] = ()) -> ag.Body:
    """Make a sash that slides in its track; `push` is given about its middle."""
    section, face, half = draft.section, draft.section.face, draft.section.slide / 2
    width, _, height = place.size
    bands = [((0, face), (-half, half))]
    ring = ring_of(bands, width, height, "pane", draft.finish, eased=section.eased, push=push)
    panes = _panes(draft, width - 2 * face, height - 2 * face, section.slide)
    return ag.weld(ring, *panes).at(place.center)


@dataclass(frozen=True)
class Swing:
    """Motion of hinged sashes and their levers."""

    limit: ag.Float  # opening angle of the sashes [rad]
    friction: ag.Float  # friction of the hinges of a casement [N m]
    damping: ag.Float  # damping of the hinges [N m s/rad]
    lever: hardware.LeverStyle  # style of the lever
    length: ag.Float  # length of the lever [m]
    turn: float  # range of the lever [rad]
    stay: Literal["friction", "none"]  # holder of an awning: a friction stay, or none
    # whether hinges and stops have mass and collide; with many leaves they are visual only, because
    # simulators test all pairs of close colliders
    solid: bool


def casement(
    draft: Draft, swing: Swing, hands: Sequence[int], shares: Sequence[ag.Scalar], *, inward: bool
) -> ag.Body:
    """Make side-hung casements beside and above each other."""
    section, opening, gap = draft.section, draft.opening, frame.MULLION
    wide = (opening.x.size - gap * (len(hands) - 1)) / len(hands)
    free = opening.z.size - gap * (len(shares) - 1)
    levels = opening.z.split(*(share * free for share in shares), gap=gap)
    rows = [opening.with_(z=level).columns(len(hands), gap=gap) for level in levels]
    body = frame.rebated_frame(draft, rows, solid=swing.solid)
    cells = [(cell, hand) for row in rows for cell, hand in zip(row, hands, strict=True)]
    for number, (cell, hand) in enumerate(cells):
        hung = _hung(draft, swing, wide, cell.z.size, inward=inward)
        hung = hung.mirror(ag.X) if hand < 0 else hung
        hung = hung.suffixed(f"_{number}") if len(cells) > 1 else hung
        body = ag.weld(body, hung.at(cell.center))
    if not inward:
        return body
    for (left, first), (right, second) in pairwise(cells[: len(hands)]):
        if first < second:  # both have their hinges on the post between them
            pin = _axis(section, wide)[0]
            reach = (wide - _seen(section, inward=True)) / 2 - pin - swing.length
            out = LEVER_OUT + section.lip / 2
            # past the axis, after a quarter turn towards it
            tip = out * ag.sin(swing.limit) - reach * ag.cos(swing.limit)
            body = body.require(tip <= (right.x.mid - left.x.mid) / 2 + pin - 0.001, _LEVERS_MEET)
    return body.mirror(ag.Y)


def awning(draft: Draft, swing: Swing) -> ag.Body:
    """Make one top-hung sash that opens to the outside."""
    body = frame.rebated_frame(draft, [[draft.opening]], solid=swing.solid)
    # a casement turned by 90 degrees: its left hinges become the top hinges
    side, turned = draft.opening, draft.turned()
    hung = _hung(turned, swing, side.z.size, side.x.size, inward=False, falls=True)
    return ag.weld(body, hung.rotate(ag.Y, math.pi / 2))


def _axis(section: frame.Section, width: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return x and y of the axis beside the lip of a sash in an opening of some width."""
    return -width / 2 - _LIP - 0.002 - BARREL, -SEALED - section.lip / 2


def _seen(section: frame.Section, *, inward: bool) -> ag.Scalar:
    """Return the visible width of the lock stile, with the lever in its middle [m]."""
    return REBATE + section.sash + (0 if inward else STOP)


def _hung(
    draft: Draft, swing: Swing, width: ag.Scalar, height: ag.Scalar, *, inward: bool, falls: bool = False
) -> ag.Body:
    """Make the parts of the frame with a sash in an opening about the origin, with hinges at its left.

    The lever is in front, where the sash opens to, or at the back; `falls` if hinges become horizontal.
    """
    section, metal = draft.section, draft.metal
    tall = ag.require(height, height > (_HINGED if swing.solid else _LOCKED), _TOO_SHORT)
    axis = x, y = _axis(section, width)
    levels = [(x, y, end * (tall / 2 - 0.11)) for end in (-1, 1)]
    on_frame, on_sash = hardware.barrel_hinges(
        tall=0.066, arm=0.002 + BARREL, foot=-y, at=levels, finish=metal, solid=swing.solid
    )
    # in the middle of the free part of the lock stile
    stile = (width - _seen(section, inward=inward)) / 2
    at = (stile, -SEALED - section.lip if inward else section.depth, 0.0)
    rose, lever = hardware.window_lever(
        -1 if inward else 1, style=swing.lever, length=swing.length, finish=metal
    )
    turn = ag.Revolute(
        "handle_turn", axis=ag.Y, limits=(0, swing.turn), friction=draft.friction, feel=_HANDLE
    )
    slide = ag.Prismatic("bolt_slide", axis=ag.Z, follows=hardware.CAM_TRAVEL * turn, damping=2)
    reach = ag.min_(0.30, tall / 2 - 0.09)
    rod, keeps, passed, clears = hardware.cam_lock(width / 2, axis, reach, finish=metal)
    sash = ag.weld(_lipped_sash(draft, width, tall), on_sash, rose.at(at))
    sash = sash.attach(lever, turn, at=at).attach(rod, slide)
    limit, friction = _falling(sash, swing, width, x) if falls else (swing.limit, swing.friction)
    free = (turn > hardware.RELEASED).until(passed)
    drag = feel.Feel(friction=friction, damping=swing.damping, velocity=6)
    hinge = ag.Revolute("pane_hinge", axis=-ag.Z, pivot=(x, y, 0.0), limits=(0, limit), feel=drag, needs=free)
    body = ag.weld(on_frame, keeps).attach(sash, hinge)
    if not inward:
        stop = STOP if swing.solid else 0.0
        body = body.require(swing.length <= tall / 2 - stop, _LEVER_LONG)
        # width and height of the lever's end or neck
        wide, out = (0.0111, 0.0420) if swing.lever == "tapered" else (0.0088, 0.0445)
        edge, behind = stile + wide, section.depth + out
        nears = hardware.swings_out(edge - x, behind - y, behind - section.stop)
        body = body.require(nears < width / 2 - stop - edge - 0.0002, _LEVER_NEAR)
    thick = section.depth + SEALED + section.lip / 2  # behind the axis
    return body.require(clears, _LOCK_MEETS).require(
        thick * thick / (2 * width) < REBATE - 0.001,
        "the far edge of the sash would strike the frame: raise width",
    )


def _falling(sash: ag.Body, swing: Swing, width: ag.Scalar, pin: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return limit and friction of a horizontal hinge: a friction stay holds the sash, or it falls shut."""
    load = sash.weight() * (sash.center_of_mass().x - pin)
    holds = swing.stay == "friction"
    # a hand at the lever lifts the weight against the friction of the stay
    sine = ag.min_(_LIFTS * (width - 0.05) / (load * (1 + _HOLDS if holds else 1)), 0.97)
    limit = ag.min_(swing.limit, ag.atan2(sine, ag.sqrt(1 - sine * sine)))
    return limit, _HOLDS * load * ag.sin(limit) if holds else 0.15


def sliding(draft: Draft, panels: int, *, bar: ag.Scalar, drag: ag.Scalar) -> ag.Body:
    """Make sashes that slide past fixed ones: one of two, or the middle two of four."""
    body, half = frame.tracked_frame(draft), draft.opening.x.size / 2
    if panels == 2:
        return ag.weld(body, _sliding_pair(draft, 2 * half, _TRACK, bar, drag).at(-half))
    right = _sliding_pair(draft, half, 0.002, bar, drag)  # the edges meet within 4 mm
    return ag.weld(body, right.mirror(ag.X).suffixed("_0"), right.suffixed("_1"))


def _sliding_pair(draft: Draft, long: ag.Scalar, start: float, bar: ag.Scalar, drag: ag.Scalar) -> ag.Body:
    """Make a sash in the inner track, from x = `start`, and the fixed sash behind it."""
    section, z = draft.section, draft.opening.z
    face, inside, middle = section.face, section.inner + section.slide / 2, long / 2
    stile = start + face / 2 + 0.004  # in the middle of the part that is clear of the strip at the jamb
    level, lock = _level(bar, z.size), z.low + STRIP + hardware.LATCH_UP
    level = ag.require(level, level - bar / 2 - _ROOM > lock + hardware.LATCH_TOP, _PULL_MEETS)
    pull = hardware.bow_pull(length=bar, girth=0.0052, finish=draft.metal)
    pull = pull.rotate(ag.Z, math.pi).at(stile, inside, level)
    case, slider, keep, lift = hardware.sliding_latch(friction=draft.friction, finish=draft.metal)
    at = (stile, inside, lock)
    # the fixed sash is screwed to the frame, with an overlap of half a millimeter
    place = ag.Region((start, middle + face / 2), (section.inner, section.inner), z).shrink(z=_TRACK)
    fixed = ag.Region((middle - face / 2, long), (section.outer, section.outer), z)
    sash = ag.weld(_plain_sash(draft, place), pull, case.at(at)).attach(slider.at(at), lift)
    limits = (0, middle - face / 2 - _TRACK - 0.002)
    free = (lift > hardware.LATCH_FREE).until(hardware.LATCH_PASSED)
    slide = ag.Prismatic("pane_slide", axis=ag.X, limits=limits, friction=drag, damping=8, needs=free)
    fixed = fixed.grow(right=_LET_IN, z=_LET_IN)
    return ag.weld(keep.at(at), _plain_sash(draft, fixed)).attach(sash, slide)


def _level(bar: ag.Scalar, height: ag.Scalar) -> ag.Scalar:
    """Return the height of the middle of a pull that ends below the strip at an opening's head [m]."""
    return ag.min_(0.06, height / 2 - STRIP - _ROOM - bar / 2)


def _passing(
    draft: Draft, gear: ag.Body, names: tuple[str, str], drag: ag.Scalar, *, balanced: bool
) -> ag.Body:
    """Make two sashes that pass each other, the inner one below with its gear, and a lock between them."""
    section, face, place = draft.section, draft.section.face, draft.opening.shrink(_TRACK)
    at = (0.0, section.inner - section.slide / 2 + 0.015, face / 2)
    base, cam, turn = hardware.sash_lock(friction=draft.friction, finish=draft.metal)
    keeper = hardware.lock_keeper(section.outer + section.slide / 2, face / 2, finish=draft.metal)
    inner = place.with_(y=(section.inner, section.inner), z=(place.z.low, face / 2))
    inside = ag.weld(_plain_sash(draft, inner), gear).suffixed(f"_{names[0]}")
    inside = ag.weld(inside, base.at(at)).attach(cam, turn, at=at)
    # a finger on the meeting rail of the outer sash, beside the glass, pushes it
    outer = place.with_(y=(section.outer, section.outer), z=(-face / 2, place.z.high))
    inset = min(0.0045, (section.slide - PANE) / 2 - 0.0095)  # distance of the finger from the face
    beside = {0: 0.25, 1: 0.25, 2: 1 / 3}.get(draft.columns, 0.125)  # between two bars
    rail = face - outer.z.size / 2 - frame.under(section.eased) - 0.00005
    finger = (beside * (outer.x.size - 2 * face), section.slide / 2 - inset, rail)
    press = ag.frame(finger, approach=-ag.Z, closing=ag.X)
    # inside, a finger over a lip on its far rail takes it along, until the hand meets the inner sash
    strip = ag.Region.centered(_LIP_LONG, 0.0, 0.005).with_(y=(-0.0005, 0.0125)).box(bevel=0.0008)
    lip = ag.part(strip, "handle", draft.metal)
    lip = lip.at(finger[0], section.outer + section.slide / 2, place.z.high - face + 0.004)
    outside = ag.weld(_plain_sash(draft, outer, press).suffixed(f"_{names[1]}"), keeper, lip)
    body, way = frame.tracked_frame(draft), place.z.size / 2 - face / 2 - 0.004
    # the lock stays within the frame
    for sash, name, up, travel in (
        (inside, names[0], 1, way - _LOCK),
        (outside, names[1], -1, way - face - _HAND),
    ):
        rest = up * sash.weight() / _BALANCE + travel / 2  # balance at half the travel
        slide = ag.Prismatic(
            f"pane_slide_{name}",
            axis=(0.0, 0.0, up),
            limits=(0, travel),
            spring=ag.Spring(stiffness=_BALANCE, rest=rest) if balanced else None,
            friction=drag,
            damping=10 if balanced else 8,
            effort=400 if balanced else 100,
            needs=turn > hardware.LOCK_FREE,
        )
        body = body.attach(sash, slide)
    return body


def double_hung(draft: Draft, *, lifts: int, drag: ag.Scalar) -> ag.Body:
    """Make two sashes that slide up and down, balanced by springs, with a lock at their meeting rails.

    Block-and-tackle and constant-force balances carry the weight of a sash at every height; brushes hold the
    remainder (ANSI/AAMA 902). A soft spring with a large extension has a nearly constant force.
    """
    section, place = draft.section, draft.opening.shrink(_TRACK)
    x = 0.26 * place.x.size
    gear = hardware.sash_lifts([0.0] if lifts == 1 else [-x, x], draft.metal)
    gear = gear.at(y=section.inner + section.slide / 2, z=place.z.low + 0.6 * section.face)
    return _passing(draft, gear, ("lower", "upper"), drag, balanced=True)


def sliding_both(draft: Draft, *, bar: ag.Scalar, drag: ag.Scalar) -> ag.Body:
    """Make two sashes that both slide, the inner sash from the left, with a lock at their meeting stiles."""
    # hung sashes turned by 90 degrees: the lower sash becomes the left one
    section, turned = draft.section, draft.turned()
    # in the middle of the part that is clear of the strip at the jamb
    stile = turned.opening.z.low + _TRACK + section.face / 2 + 0.004
    pull = hardware.bow_pull(length=bar, girth=0.0052, finish=draft.metal)
    pull = pull.rotate(ag.Z, math.pi).rotate(ag.Y, -math.pi / 2)
    pull = pull.at(-_level(bar, draft.opening.z.size), section.inner + section.slide / 2, stile)
    return _passing(turned, pull, ("0", "1"), drag, balanced=False).rotate(ag.Y, math.pi / 2)
