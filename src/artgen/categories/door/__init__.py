"""A hinged door in its frame, with working hardware: the latch holds the door until the handle is turned.

The door is built once: hinges at the left, opening towards the viewer (-y). Doors with the other hand or that
open away are mirror images.

Links: `frame`; `door`, or `door_left` and `door_right`; `handle`, `latch`, `lock` and `deadbolt` if present;
`flush_bolt` in the inactive leaf of a double door. Joints: `door_hinge` (with `_left` and `_right` for two
leaves), `handle_turn` or `handle_push`, `latch_slide`, `lock_turn`, `deadbolt_slide`, `flush_bolt_slide`.

Visual parts such as screws, print, moldings and seals have neither mass nor collider. An entrance may have a
letter plate, a house number, a viewer and a kick plate on its outer face, and a brush under its inner face;
it opens inward.

Sizes are those of residential doors: leaves 24-42 in wide (28, 30, 32 and 36 in are stock), 6 ft 6 in to 8 ft
high, 1 3/8 to 1 3/4 in thick (ANSI/SDI A250.8, WDMA I.S. 1A); clearances 3 mm at the sides, 10-19 mm at the
floor.
"""

import math
from functools import partial
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.door.fittings import finger_plate, pull_handle, push_bar
from artgen.categories.door.frame import FrameKind, Hanging, Trim, door_frame
from artgen.categories.door.leaf import LEAVES
from artgen.categories.door.lockset import Lockset, united
from artgen.categories.door.pair import hung_pair
from artgen.categories.shared import HARDWARE_LABELS, require_suited
from artgen.categories.shared import finish as finishes
from artgen.categories.shared.door_handles import knob_handle, lever_handle
from artgen.categories.shared.finish import FINISH_WEIGHTS, FINISHES
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf
from artgen.categories.shared.fronts import Blank, Fittings
from artgen.categories.shared.locks import DEADBOLT, Fixing

_HANDLES = {
    "lever": lever_handle,
    "knob": knob_handle,
    "push_bar": push_bar,
    "pull": pull_handle,
    "none": finger_plate,
}
_ABOVE = 0.42  # distance from the handle up to the push point of a leaf, past a deadbolt [m]
_PAINTS = finishes.paints(480.0, "paint")  # paint over light softwood
_SOLID_PAINTS = finishes.paints(660.0, "exterior_paint")  # paint over hardwood
_WOODS = finishes.known("oak", "oak_flat_sawn", "walnut", "mahogany", "ash", "mahogany_flat_sawn")
_VENEERED = "oak oak_flat_sawn walnut walnut_flat_sawn beech maple ash pine_flat_sawn pine"
_VENEERS = finishes.weighing(finishes.known(*_VENEERED.split()), 480.0, "veneered")  # on light softwood
_INTERIOR = (*(5 / len(_VENEERS),) * len(_VENEERS), *(0.55 * each for each in finishes.INDOORS))
_EXTERIOR = (*(4.5 / len(_WOODS),) * len(_WOODS), *(0.55 * each for each in finishes.OUTDOORS))


@ag.category(
    labels=("frame", "seal", "threshold", "door", "glass", "plate", "flush_bolt", *HARDWARE_LABELS),
    joints=(1, 7),
)
def door(
    *,
    use: Literal["interior", "exterior"] = ag.choice(
        {"interior": 0.62, "exterior": 0.38},
        doc="construction of the leaf: hollow or light for rooms, solid for entrances",
    ),
    layout: Literal["single", "double"] = ag.choice({"single": 0.82, "double": 0.18}),
    hand: Literal["left", "right"] = ag.choice("left", "right", doc="hinge side of the (active) leaf"),
    opens: Literal["towards", "away"] = ag.choice(
        "towards", "away", doc="direction of opening as seen by the viewer"
    ),
    stock: Literal["standard", "made_to_measure"] = ag.choice("standard", "made_to_measure"),
    width: ag.Float = ag.by(  # 24, 28, 30, 32, 36 in
        "stock",
        standard=ag.by(
            "use", interior=ag.choice(0.610, 0.711, 0.762, 0.813), exterior={0.813: 0.4, 0.914: 0.6}
        ),
        made_to_measure=ag.by("use", interior=ag.uniform(0.64, 0.90), exterior=ag.uniform(0.80, 0.93)),
        unit="m",
        doc="width of one leaf",
        within=(0.60, 1.25),
    ),
    height: ag.Float = ag.by(
        "stock",
        standard=ag.choice(1.981, 2.032, 2.134, 2.438),  # 78, 80, 84, 96 in
        made_to_measure=ag.uniform(1.98, 2.44),
        unit="m",
        doc="height of a leaf",
        within=(1.8, 2.7),
    ),
    # 1 3/8 and 1 3/4 in
    thickness: ag.Float = ag.by(
        "use",
        interior=ag.uniform(0.035, 0.040),
        exterior=ag.uniform(0.042, 0.046),
        unit="m",
        within=(0.03, 0.06),
    ),
    side_gap: ag.Float = ag.uniform(0.003, 0.0036, "m", within=(0.0028, 0.006)),
    floor_gap: ag.Float = ag.uniform(0.010, 0.019, "m", within=(0.008, 0.03)),
    jamb_depth: ag.Float = ag.uniform(0.105, 0.145, "m", within=(0.08, 0.3)),
    frame: FrameKind = ag.by(
        "layout", single={"jambs": 0.25, "full": 0.6, "arched": 0.15}, double={"jambs": 0.3, "full": 0.7}
    ),
    casing: ag.Float = ag.uniform(0.055, 0.090, "m"),
    trim: Trim = ag.choice({"ogee": 0.4, "flat": 0.25, "stepped": 0.2, "bevelled": 0.15}),
    rise: ag.Float = ag.uniform(0.10, 0.20, doc="rise of an arch, as a share of the leaf's width"),
    leaf: ag.Generator = ag.by("use", LEAVES),
    finish: ag.Material = ag.by(
        "use",
        interior=ag.shades(*_VENEERS, *_PAINTS, weights=_INTERIOR, color=0.07, roughness=0.04),
        exterior=ag.shades(*_WOODS, *_SOLID_PAINTS, weights=_EXTERIOR, color=0.07, roughness=0.04),
    ),
    frame_finish: Literal["same", "white"] = ag.choice({"same": 0.7, "white": 0.3}),
    frame_paint: ag.Material = ag.shades(_PAINTS[0], color=0.03, roughness=0.05, doc="white frame paint"),
    sill: ag.Material = ag.by(
        "use",
        interior=ag.shades("aluminium", *_VENEERS[:1], "brass", weights=(0.6, 0.25, 0.15)),
        exterior=ag.shades("aluminium", "aged_bronze", weights=(0.8, 0.2)),
        doc="material of the threshold",
    ),
    metal: ag.Material = ag.shades(
        *FINISHES, weights=FINISH_WEIGHTS, color=0.03, roughness=0.03, doc="finish of all hardware"
    ),
    maker: str = ag.choice(*details.BRANDS, doc="brand on the lock"),
    letter_plate: bool = ag.by("use", interior=False, exterior=ag.choice(False, True)),
    number: str = ag.by(
        "use",
        interior="",
        exterior={"": 5, "3": 1, "8": 1, "12": 1, "27": 1, "46": 1, "51": 1, "109": 1},
        doc="number of the house",
    ),
    viewer: bool = ag.by("use", interior=False, exterior={False: 0.4, True: 0.6}),
    kick_plate: bool = ag.by("use", interior=False, exterior={False: 0.75, True: 0.25}),
    sweep: bool = ag.by(
        "use", interior=False, exterior={False: 1, True: 1}, doc="whether a brush seals the gap to the floor"
    ),
    opener: Literal["lever", "knob", "push_bar", "pull", "none"] = ag.by(
        "use",
        interior={"lever": 0.55, "knob": 0.24, "push_bar": 0.05, "pull": 0.09, "none": 0.07},
        exterior={"lever": 0.46, "knob": 0.16, "push_bar": 0.16, "pull": 0.18, "none": 0.04},
    ),
    handle: ag.Generator = ag.by("opener", _HANDLES),
    handle_height: ag.Float = ag.uniform(0.86, 1.12, "m", doc="height above the floor", within=(0.7, 1.4)),
    handle_range: ag.Float = ag.by(
        "opener",
        lever=ag.uniform(0.60, 1.05),
        knob=ag.uniform(0.72, 0.85),
        push_bar=ag.uniform(0.012, 0.018),
        otherwise=0.8,
        doc="travel of the handle [rad], or of a push bar [m]",
    ),
    spring: ag.Float = ag.uniform(1.1, 1.5, "N m", doc="torque that turns a handle fully"),
    backset: ag.Float = ag.uniform(0.060, 0.070, "m", doc="distance to the lock edge", within=(0.055, 0.09)),
    throw: ag.Float = ag.uniform(0.010, 0.012, "m", doc="travel of the latch", within=(0.009, 0.014)),
    rose: Literal["round", "square", "plate"] = ag.choice({"round": 0.5, "square": 0.3, "plate": 0.2}),
    rose_across: ag.Float = ag.by(
        "rose",
        round=ag.uniform(0.050, 0.060),
        square=ag.uniform(0.050, 0.058),
        plate=ag.uniform(0.042, 0.050),
        unit="m",
    ),
    rose_depth: ag.Float = ag.uniform(0.007, 0.011, "m"),
    fixing: Fixing = ag.by(
        "rose",
        plate=ag.choice("slot", "phillips"),
        otherwise={"hidden": 0.4, "slot": 0.3, "phillips": 0.3},
        doc="fixing of roses: hidden, or with two screws",
    ),
    keyed: bool = ag.by(
        "rose", plate=ag.choice(False, True), otherwise=False, doc="key cylinder in the plate"
    ),
    bolted: bool = ag.by(
        "opener",
        lever={False: 0.7, True: 0.3},
        knob={False: 0.5, True: 0.5},
        pull={False: 0.6, True: 0.4},
        otherwise=False,
        doc="whether there is a deadbolt with a thumb turn",
    ),
    hinges: int = ag.choice({2: 0.3, 3: 0.7}),
    hinge_height: ag.Float = ag.uniform(0.085, 0.102, "m"),
    hinge_radius: ag.Float = ag.uniform(0.005, 0.006, "m", within=(0.004, 0.008)),
    swing: ag.Float = ag.uniform(1.4, 2.0, "rad", within=(0.5, 2.0)),
    hinge_friction: ag.Float = ag.uniform(0.6, 1.5, "N m", doc="friction that holds an open door"),
    hinge_damping: ag.Float = ag.uniform(0.5, 2.0, "N m s/rad"),
) -> ag.Body:
    """Make a door of one or two leaves in its frame: hinges, handle, latch, locks."""
    require_suited(handle, "opener", opener, _HANDLES)
    single = layout == "single"
    ag.require(
        single or frame != "arched", "layout with two leaves has no arched frame: frame must be jambs or full"
    )
    meeting = side_gap if single else 1.25 * side_gap  # between the leaf and the parts that its bolts enter
    fittings = Fittings(metal, letter_plate, number, viewer, kick_plate, sweep)
    if opener == "push_bar":  # it is on the outer face
        fittings = fittings.bare()
    top, reach = floor_gap + height, handle_height + _ABOVE
    arched = width * rise if frame == "arched" else None
    blank = Blank(width, floor_gap, top, thickness, arched, None, finish, fittings, reach)

    spindle = ag.vector(width / 2 - backset, 0.0, handle_height)
    lockset = Lockset(spindle, backset, thickness, meeting, metal, throw, maker)
    above = 0.30 if opener in ("pull", "none") else 0.15  # the end of a pull or of a long plate
    if opener in ("lever", "knob"):
        roses = {"across": rose_across, "style": rose, "fixing": fixing, "keyed": keyed and not bolted}
        lockset.turning_handle(handle, handle_range, spring, rose_depth, **roses)
    elif opener == "push_bar":
        lockset.pushed_handle(handle, width, handle_range)
    else:
        over = blank.straight - handle_height
        over = ag.min_(over, above - 0.03) if bolted else over
        room = 2 * ag.min_(over, handle_height - floor_gap)  # for a pull on the leaf, below its bolt
        lockset.rigid_handle(partial(handle, room=room) if handle == pull_handle else handle)
    if bolted:
        lockset.dead_lock(above)

    opening = ag.Region.centered(width if single else 2 * width + meeting, 0.0, 0.0).grow(x=side_gap)
    opening = opening.with_(y=(-thickness / 2, jamb_depth - thickness / 2), z=(0, top + side_gap))
    arch = None if blank.arch is None else blank.arch.outset(side_gap)
    wood = frame_paint if frame_finish == "white" else finish
    surround = partial(door_frame, opening, arch, frame, wood, sill, floor_gap, casing, trim)
    sizes = (side_gap, hinge_height, hinge_radius)
    hanging = Hanging(blank, hinges, *sizes, metal, swing, hinge_friction, hinge_damping)
    # a bolt is out of the way after it has passed the casing in front of the jamb, with 2 mm to spare
    clear = 1.03 * (thickness / 2 + 0.015 + DEADBOLT.width / 2 + 0.002) / (width + side_gap / 2)
    needs = lockset.free(clear)
    if single:
        panel = lockset.leaf_with(leaf, blank, hanging.half(hinge_leaf), suffix="")
        cut = united(lockset.strike_cuts, metal)
        body = ag.weld(surround(jamb_cut=cut), hanging.half(hinge_frame), *lockset.strikes)
        body = body.attach(panel, hanging.joint("door_hinge", needs=needs))
    else:
        hands = (hand, "right" if hand == "left" else "left")
        body = hung_pair(surround, leaf, blank, hanging, lockset, needs=needs, hands=hands)
    body = body.require(
        hanging.turns_within_gap(),
        "the far corner of the leaf would strike the jamb: raise side_gap, or lower thickness",
    )
    # the door has its hinges at the left and opens towards the viewer
    if opens == "towards":
        return body.mirror(ag.X) if hand == "right" else body
    return body.rotate(ag.Z, math.pi) if hand == "right" else body.mirror(ag.Y)
