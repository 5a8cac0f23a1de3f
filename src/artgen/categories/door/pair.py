"""Pairs of leaves: the inactive leaf has a flush bolt, and a strip against which the active leaf closes."""

from collections.abc import Callable
from dataclasses import replace

import artgen as ag
from artgen.categories.door.frame import Hanging
from artgen.categories.door.lockset import Lockset, united
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf
from artgen.categories.shared.fronts import Blank

_ROD = 0.010  # width of the square bolt [m]
_PLAY = 0.0004  # gap around the bolt in the leaf [m]
_STEM = (0.006, 0.012)  # width and height of the link between a bolt and its slide [m]
_BELOW = 0.420  # distance of the slide below the top of the leaf, within reach of a hand [m]
_GRASP = 0.012  # engagement of the bolt in the head [m]
_PLATE = (0.024, 0.0018, 0.075)  # width, thickness and height of the cover around the slide [m]
_HALF_OPEN = 0.42  # opening angle of either leaf beyond which both clear each other [rad]
_STRIP_GAP = 0.002  # gap between the active leaf and the strip behind it [m]


def _flush_bolt(
    thickness: ag.Scalar, gap: ag.Scalar, finish: ag.Material
) -> tuple[ag.Body, ag.Body, ag.Solid, ag.Solid]:
    """Make a bolt at the top of a leaf, z = 0: the link `flush_bolt`, its cover, cutters of leaf and head."""
    throw, out = gap + _GRASP, thickness / 2 + _PLATE[1]
    long = _BELOW + 0.012 + throw
    rod = ag.box(_ROD, _ROD, long, bevel=0.001).at(z=throw - long / 2)
    stem = ag.box(_STEM[0], out + 0.002, _STEM[1]).at(y=-(out + 0.002) / 2, z=-_BELOW)
    thumb = ag.box(0.018, 0.010, 0.024, bevel=0.003).at(y=-out - 0.0055, z=-_BELOW)
    hold = ag.grasp_on(thumb, approach=ag.Y, closing=ag.X, depth=0.009)  # 1 mm less than its height
    bolt = ag.part(ag.union(rod, stem, thumb), "flush_bolt", finish, grasp=hold)

    slot = ag.box(_STEM[0] + 2 * _PLAY, thickness / 2 + 0.004, _STEM[1] + throw + 0.003)
    slot = slot.align((0.0, 0.0, -_BELOW + _STEM[1] / 2 + 0.001), y=1.0, z=1.0)
    wide, deep = _ROD + 2 * _PLAY, long + 0.007  # 4 mm out of the leaf, 2 mm below the drawn bolt
    channel = ag.box(wide, wide, deep).at(z=0.004 - deep / 2) | slot
    # the leaf has a play of 0.7 mm
    pocket = ag.box(_ROD + 0.004, _ROD + 0.0027, _GRASP + 0.006)
    pocket = pocket.align((0.0, -_ROD / 2 - 0.0007, throw + 0.004), y=-1.0, z=1.0)

    wide, thick, tall = _PLATE
    middle, face = -_BELOW - throw / 2, thickness / 2 - 0.0004
    plate = ag.box(wide, thick, tall, bevel=0.0004).at(y=-face - thick / 2, z=middle) - slot
    screw = ag.cylinder(0.003, 0.0008, axis=ag.Y, bevel=0.0002).at(y=-face - thick)
    screws = [screw.at(z=middle + end * (tall / 2 - 0.006)) for end in (-1, 1)]
    # thin, behind the slide
    cover = ag.weld(ag.detail(plate, "faceplate", finish), ag.detail(screws, "screw", finish))
    return bolt, cover, channel, pocket


def _astragal(blank: Blank, gap: ag.Scalar) -> ag.Body:
    """Make the strip on the back of the inactive leaf, against which the active leaf closes."""
    wide, back, edge = 0.040, blank.thickness / 2, blank.width / 2
    strip = ag.box(wide, 0.012 - _STRIP_GAP, blank.upright - 0.06, bevel=0.002)
    foot = ag.box(wide / 2 - gap / 2 - 0.002, _STRIP_GAP + 0.002, blank.upright - 0.07)
    strip = strip.align((edge + gap / 2, back + _STRIP_GAP, blank.waist), y=-1.0)
    foot = foot.align((edge, back - 0.001, blank.waist), x=1.0, y=-1.0)
    return ag.part([strip, foot], "door", blank.finish)


def hung_pair(
    frame: Callable[..., ag.Body],
    leaf: Callable[..., ag.Body],
    blank: Blank,
    hanging: Hanging,
    lockset: Lockset,
    *,
    needs: ag.Dependency | None,
    hands: tuple[str, str],
) -> ag.Body:
    """Hang the active leaf at the left, and the inactive leaf, modeled likewise and mirrored into place."""
    gap, finish = lockset.gap, lockset.finish
    wide, middle = blank.width + gap, (blank.width + gap) / 2
    # the flush bolt has the same gap to the head as the leaf to the jambs
    bolt, cover, channel, pocket = _flush_bolt(blank.thickness, hanging.gap, finish)
    rod = (blank.width / 2 - 0.05, 0.0, blank.top)  # in the middle of a stile, behind the strikes
    throw = hanging.gap + _GRASP  # friction carries the weight; it is drawn to 1 mm beyond flush
    slide = ag.Prismatic("flush_bolt_slide", axis=-ag.Z, limits=(0, throw + 0.001), friction=12, damping=20)
    # the inactive leaf can open after the active leaf has cleared it
    first = hanging.joint(f"door_hinge_{hands[0]}", needs=needs)
    free = ((slide > throw) & (first > _HALF_OPEN)).until(_HALF_OPEN)
    second = hanging.joint(f"door_hinge_{hands[1]}", side=-1, needs=free)

    active = lockset.leaf_with(leaf, blank, hanging.half(hinge_leaf), suffix=f"_{hands[0]}")
    strikes = [body.mirror(ag.X).at(wide) for body in lockset.strikes]
    pockets = united([solid.mirror(ag.X).at(wide) for solid in lockset.strike_cuts], finish)
    cut = channel.at(rod) if pockets is None else channel.at(rod) | pockets
    inactive = leaf(blank=replace(blank, fittings=blank.fittings.bare(), cut=cut))
    fixed = (hanging.half(hinge_leaf), cover.at(rod), _astragal(blank, gap), *strikes)
    inactive = ag.weld(inactive, *fixed).suffixed(f"_{hands[1]}").attach(bolt.at(rod), slide).mirror(ag.X)
    hinges = hanging.half(hinge_frame).at(-middle)
    body = ag.weld(frame(head_cut=pocket.at(middle - rod[0], 0.0, blank.top)), hinges, hinges.mirror(ag.X))
    return body.attach(active, first, at=(-middle, 0.0, 0.0)).attach(inactive, second, at=(middle, 0.0, 0.0))
