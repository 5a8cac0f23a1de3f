"""Boxes that lie on a side and open at both ends, with slotted flaps or tucked lids.

Each end is made as the top of an upright box: the first end is closed, the box is turned over, the second end
is closed, and the box is laid down. The front of each top is then on the floor, its back at the top, and its
left and right sides are the front and the back of the box.
"""

import math
from collections.abc import Callable
from dataclasses import replace

import artgen as ag
from artgen.categories.box.board import Mouth, Thing, walls
from artgen.categories.box.flaps import Top
from artgen.categories.box.kinds import Draft
from artgen.categories.box.lids import Lidded
from artgen.categories.box.prints import Ink, address_label, shipping_print

# the left end is closed first and then turned over, which swaps its left and right
_LEFT = Mouth("lower", "upper", "back", "front", "_left", grounded=True)
_RIGHT = Mouth("lower", "upper", "front", "back", "_right", grounded=True)
_SIDES_MEET = (
    "the side flaps of an open end, half the height long, would collide: lower height, or raise "
    "width or aspect"
)


def open_ended_box(draft: Draft, *, taped: bool) -> ag.Body:
    """Make a slotted box with four flaps at each end."""
    board, wide, tall, long = draft.board, draft.depth, draft.height, draft.width
    tall = ag.require(tall, tall <= wide, _SIDES_MEET)
    left, right = (Top(board, wide, tall, long, draft.swing, taped, mouth=mouth) for mouth in (_LEFT, _RIGHT))
    body = ag.weld(
        ag.part(_both_ends(left.creased, _tube(draft), long), "box", board.outside),
        *(_turned(each, long) for each in left.tape_ends()),
        *right.tape_ends(),
    )
    body = right.attached(_turned(left.attached(body, draft.feel), long), draft.feel)
    marks = shipping_print(draft.look, long, wide, low=0.0, high=tall, finish=board.outside, sides=False)
    return ag.weld(_laid(body, long, tall), *marks, _on_top(draft), *_label(draft))


def tuck_end_box(draft: Draft, *, ears: bool, lips: bool, opening: ag.Scalar) -> ag.Body:
    """Make a carton with a lid at each end, hinged at the upper edge, with side flaps under the lid."""
    board, wide, tall, long = draft.board, draft.depth, draft.height, draft.width
    left = Lidded(
        board,
        wide,
        tall,
        long,
        sides="over",
        ears=ears,
        dust=ag.min_(0.42 * tall, 0.30 * wide),
        opening=opening,
        lips=lips,
        lined=0.7 * long,
        grip=0.05,
        mouth=_LEFT,
    )
    right = replace(left, mouth=_RIGHT)
    body = ag.weld(
        ag.part(_both_ends(left.creased, _tube(draft), long), "box", board.outside),
        *(_turned(each, long) for each in left.rims()),
        *right.rims(),
    )
    for each in (left, right):
        body = each.attached(_turned(body, long), draft.feel, printed=[], swing=draft.swing)
    ink = Ink(draft.look.ink(board.outside))
    name = draft.look.mark(0.62 * long, 0.17 * tall)
    marks = [ink.put(name, (0.0, -wide / 2.0, 0.52 * tall))]
    return ag.weld(_laid(body, long, tall), *marks, _on_top(draft), *_label(draft))


def _tube(draft: Draft) -> ag.Solid:
    """Make the four walls of an upright box without ends."""
    wide, tall = draft.depth, draft.height
    tube = walls(draft.board, wide, tall, draft.width, base=-0.004, floor=False)
    return tube - ag.Region.between((-wide, -tall, -0.01), (wide, tall, 0.0)).box().paint(draft.board.edge)


def _both_ends(cut: Callable[[ag.Solid], ag.Solid], tube: ag.Solid, long: ag.Scalar) -> ag.Solid:
    """Cut both ends of a tube in the same way as its top."""
    return cut(_turned(cut(tube), long))


def _turned(thing: Thing, long: ag.Scalar) -> Thing:
    """Turn an upright box over about x: the top goes to the bottom, the front stays in front."""
    return thing.rotate(ag.Y, math.pi, about=(0.0, 0.0, long / 2.0))


def _laid(body: ag.Body, long: ag.Scalar, tall: ag.Scalar) -> ag.Body:
    """Lay an upright box down: the top goes to the right, the front to the floor."""
    return body.rotate(ag.Z, math.pi / 2.0).rotate(ag.Y, math.pi / 2.0).at(-long / 2.0, 0.0, tall / 2.0)


def _on_top(draft: Draft) -> ag.Body:
    """Print the name on the upper wall."""
    name = draft.look.mark(0.55 * draft.width, 0.16 * draft.depth)
    return Ink(draft.look.ink(draft.board.outside), ag.Z).put(name, (0.0, 0.0, draft.height))


def _label(draft: Draft) -> list[ag.Body]:
    """Return the address label on the upper wall, in front of the name, or nothing."""
    if not draft.look.label:
        return []
    at = (-0.27 * draft.width, -0.30 * draft.depth, draft.height)
    size = ag.min_(0.105, 0.45 * draft.depth)
    return address_label(at, facing=ag.Z, size=size, number=draft.look.model)
