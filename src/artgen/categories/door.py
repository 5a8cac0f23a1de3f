"""A hinged door in its frame, with hardware that works: the latch holds it until the handle is turned.

The door is built once: hinges at the left, opening towards the viewer (-y). Other hands and doors that open
away are mirror images.

Links: `frame`; `door`, or `door_left` and `door_right`; `handle` and `latch`, `lock` and `deadbolt` where
there are such; `flush_bolt` in the inactive leaf of a double door. Joints: `door_hinge` (with `_left` and
`_right` for two leaves), `handle_turn` or `handle_push`, `latch_slide`, `lock_turn`, `deadbolt_slide`,
`flush_bolt_slide`.

Sizes are those of residential doors: leaves 24-42 in wide (28, 30, 32 and 36 in are stock), 6 ft 6 in to 8 ft
high, 1 3/8 to 1 3/4 in thick (ANSI/SDI A250.8, WDMA I.S. 1A); clearances 3 mm at the sides, 10-19 mm at the
floor.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial, reduce
from operator import and_
from typing import Literal

from artgen import (
    Body,
    Dependency,
    Float,
    Generator,
    Material,
    X,
    Y,
    Z,
    by,
    category,
    choice,
    material,
    one_of,
    uniform,
    union,
    vector,
    weld,
)
from artgen.categories.parts import HARDWARE_LABELS
from artgen.categories.parts import flush_bolt as bolts
from artgen.categories.parts.frame import Doorway, FrameKind, door_frame
from artgen.categories.parts.hanging import Hanging
from artgen.categories.parts.knobs import knob_handle
from artgen.categories.parts.latch import DEADBOLT
from artgen.categories.parts.leaf import (
    Blank,
    astragal,
    finger_plate,
    flush_leaf,
    glazed_leaf,
    half_lite_leaf,
    louver_leaf,
    panel_leaf,
)
from artgen.categories.parts.levers import lever_handle
from artgen.categories.parts.lockset import (
    Lockset,
    Site,
    dead_lock,
    pushed_handle,
    rigid_handle,
    turning_handle,
)
from artgen.categories.parts.pulls import pull_handle
from artgen.categories.parts.push_bar import push_bar

_COLORS = {
    "white": (0.80, 0.79, 0.76),
    "ivory": (0.74, 0.69, 0.58),
    "grey": (0.30, 0.31, 0.31),
    "graphite": (0.055, 0.058, 0.062),
    "sage": (0.30, 0.36, 0.27),
    "navy": (0.035, 0.060, 0.12),
    "red": (0.30, 0.035, 0.030),
}


def _painted(density: float, name: str) -> tuple[Material, ...]:
    """Return the paints over a wood of some density [kg/m3]."""
    return tuple(
        material("painted_wood").with_(name=f"{name}_{color}", base_color=rgb, density=density)
        for color, rgb in _COLORS.items()
    )


_PAINTS = _painted(480.0, "paint")  # over light softwood
_SOLID_PAINTS = _painted(660.0, "exterior_paint")  # over hardwood
_WOODS = tuple(material(name) for name in ("oak", "walnut", "mahogany"))
_LIGHT_WOODS = (  # veneer on light softwood
    *(material(name).with_(name=f"{name}_veneer", density=480.0) for name in ("oak", "walnut")),
    material("pine").with_(density=480.0),
)

_METALS = tuple(
    material(name) for name in ("satin_nickel", "stainless", "chrome", "brass", "aged_bronze", "black_steel")
)

_HALF_OPEN = 0.42
"""Two leaves are out of each other's way when either stands further open than this [rad]."""


@category(labels=("frame", "seal", "threshold", "door", "glass", "plate", "flush_bolt", *HARDWARE_LABELS))
def door(
    *,
    use: Literal["interior", "exterior"] = choice(
        "interior",
        "exterior",
        weights=(0.62, 0.38),
        doc="rooms have hollow or light leaves, entrances solid ones",
    ),
    layout: Literal["single", "double"] = choice("single", "double", weights=(0.82, 0.18)),
    hand: Literal["left", "right"] = choice("left", "right", doc="side of the hinges of the (active) leaf"),
    opens: Literal["towards", "away"] = choice(
        "towards", "away", doc="seen by the viewer, who pulls or pushes"
    ),
    stock: Literal["standard", "made_to_measure"] = choice("standard", "made_to_measure"),
    width: Float = by(
        "stock",
        standard=by(  # 24, 28, 30, 32, 36 in
            "use",
            interior=choice(0.610, 0.711, 0.762, 0.813),
            exterior=choice(0.813, 0.914, weights=(0.4, 0.6)),
        ),
        made_to_measure=by("use", interior=uniform(0.64, 0.90), exterior=uniform(0.80, 0.93)),
        unit="m",
        doc="of one leaf",
        within=(0.60, 1.25),
    ),
    height: Float = by(
        "stock",
        standard=choice(1.981, 2.032, 2.134, 2.438),  # 78, 80, 84, 96 in
        made_to_measure=uniform(1.98, 2.44),
        unit="m",
        doc="of a leaf",
        within=(1.8, 2.7),
    ),
    thickness: Float = by(  # 1 3/8 and 1 3/4 in
        "use",
        interior=uniform(0.035, 0.040),
        exterior=uniform(0.042, 0.046),
        unit="m",
        within=(0.03, 0.06),
    ),
    side_gap: Float = uniform(0.003, 0.0036, "m", within=(0.0028, 0.006)),
    floor_gap: Float = uniform(0.010, 0.019, "m", within=(0.008, 0.03)),
    jamb_depth: Float = uniform(0.105, 0.145, "m", within=(0.08, 0.3)),
    frame: FrameKind = by(
        "layout",
        single=choice("jambs", "full", "arched", weights=(0.25, 0.6, 0.15)),
        double=choice("jambs", "full", weights=(0.3, 0.7)),
    ),
    casing: Float = uniform(0.055, 0.090, "m"),
    rise: Float = uniform(0.10, 0.20, doc="of an arch, as a share of the leaf's width"),
    leaf: Generator = by(
        "use",
        interior=one_of(flush_leaf, panel_leaf, louver_leaf, weights=(0.4, 0.4, 0.2)),
        exterior=one_of(panel_leaf, glazed_leaf, half_lite_leaf, weights=(0.3, 0.35, 0.35)),
    ),
    finish: Material = by(
        "use",
        interior=choice(*_LIGHT_WOODS, *_PAINTS, weights=(1.0, 1.0, 1.0, 4.0, 1.5, 1.5, 0.7, 1.0, 0.7, 0.4)),
        exterior=choice(*_WOODS, *_SOLID_PAINTS, weights=(2.0, 1.5, 1.0, 2.0, 0.7, 0.7, 1.0, 1.0, 1.0, 1.0)),
    ),
    frame_finish: Literal["same", "white"] = choice("same", "white", weights=(0.7, 0.3)),
    metal: Material = choice(*_METALS, doc="of all hardware"),
    opener: Literal["lever", "knob", "push_bar", "pull", "none"] = choice(
        "lever", "knob", "push_bar", "pull", "none", weights=(0.50, 0.20, 0.12, 0.12, 0.06)
    ),
    handle: Generator = by(
        "opener", lever=lever_handle, knob=knob_handle, push_bar=push_bar, pull=pull_handle, none=finger_plate
    ),
    handle_height: Float = uniform(0.86, 1.12, "m", doc="above the floor", within=(0.7, 1.4)),
    handle_range: Float = by(
        "opener",
        lever=uniform(0.60, 1.05),
        knob=uniform(0.72, 0.85),
        push_bar=uniform(0.012, 0.018),
        otherwise=0.8,
        doc="how far it moves; rad, or m for a push bar",
    ),
    spring: Float = uniform(1.1, 1.5, "N m", doc="torque that turns a handle fully"),
    backset: Float = uniform(0.060, 0.070, "m", doc="lock edge to spindle", within=(0.055, 0.09)),
    throw: Float = uniform(0.010, 0.012, "m", doc="of the latch", within=(0.009, 0.014)),
    rose: Literal["round", "square", "plate"] = choice("round", "square", "plate", weights=(0.5, 0.3, 0.2)),
    rose_across: Float = by(
        "rose",
        round=uniform(0.050, 0.060),
        square=uniform(0.050, 0.058),
        plate=uniform(0.042, 0.050),
        unit="m",
    ),
    rose_depth: Float = uniform(0.007, 0.011, "m"),
    bolted: bool = by(
        "opener",
        lever=choice(False, True, weights=(0.7, 0.3)),
        knob=choice(False, True, weights=(0.5, 0.5)),
        pull=choice(False, True, weights=(0.6, 0.4)),
        otherwise=False,
        doc="whether there is a deadbolt with a thumb turn",
    ),
    hinges: int = choice(2, 3, weights=(0.3, 0.7)),
    hinge_height: Float = uniform(0.085, 0.102, "m"),
    hinge_radius: Float = uniform(0.005, 0.006, "m", within=(0.004, 0.008)),
    swing: Float = uniform(1.4, 2.0, "rad", within=(0.5, 2.0)),
    hinge_friction: Float = uniform(0.6, 1.5, "N m", doc="keeps an open door where it is left"),
    hinge_damping: Float = uniform(0.5, 2.0, "N m s/rad"),
) -> Body:
    """Make a door with its frame, hinges, handle, latch and locks."""
    meeting = 1.25 * side_gap if layout == "double" else side_gap  # between the leaf and what its bolts enter
    arched = width * rise if frame == "arched" else None
    blank = Blank(width, floor_gap, floor_gap + height, thickness, arched, None, finish)
    spindle = vector(width / 2.0 - backset, 0.0, handle_height)
    site = Site(spindle, backset, thickness, meeting, metal)
    match opener:
        case "lever" | "knob":
            lockset = turning_handle(
                site,
                handle,
                limit=handle_range,
                torque=spring,
                throw=throw,
                rose_style=rose,
                rose_across=rose_across,
                rose_depth=rose_depth,
            )
        case "push_bar":
            lockset = pushed_handle(site, handle, width=width, travel=handle_range, throw=throw)
        case "pull" | "none":
            lockset = rigid_handle(site, handle)
    if bolted:
        above = 0.30 if opener in ("pull", "none") else 0.15  # past the end of a pull, or of a long plate
        lockset = lockset + dead_lock(replace(site, spindle=spindle + (0.0, 0.0, above)))

    hanging = Hanging(
        blank, hinges, side_gap, hinge_height, hinge_radius, metal, swing, hinge_friction, hinge_damping
    )
    total = (2.0 * width + meeting if layout == "double" else width) + 2.0 * side_gap
    arch = None if blank.arch is None else blank.arch.outset(side_gap)
    surround = partial(
        door_frame,
        Doorway(total, blank.top + side_gap, thickness, jamb_depth, arch, floor_gap),
        frame,
        finish=_PAINTS[0] if frame_finish == "white" else finish,
        sill=material("aluminium"),
        casing=casing,
    )
    # a bolt is out of the way when it has passed the casing in front of the jamb, 2 mm to spare
    clear = 1.03 * (thickness / 2.0 + 0.015 + DEADBOLT.width / 2.0 + 0.002) / (width + side_gap / 2.0)
    needs = reduce(and_, lockset.free).until(clear) if lockset.free else None
    if layout == "single":
        body = _single(surround, leaf, blank, hanging, lockset, needs)
    else:
        body = _double(surround, leaf, blank, hanging, lockset, needs, site, hand)
    body = body.require(hanging.turns_within_gap(), "the far corner of the leaf would strike the jamb")
    return _handed(body, hand, opens)


def _handed(body: Body, hand: str, opens: str) -> Body:
    """Turn or mirror the door with hinges at the left that opens towards the viewer into another one."""
    if opens == "towards":
        return body.mirror(X) if hand == "right" else body
    return body.rotate(Z, math.pi) if hand == "right" else body.mirror(Y)


def _single(
    surround: Callable[..., Body],
    leaf: Callable[..., Body],
    blank: Blank,
    hanging: Hanging,
    lockset: Lockset,
    needs: Dependency | None,
) -> Body:
    """Hang one leaf in its frame."""
    cut = union(*lockset.strike_cuts) if lockset.strike_cuts else None
    frame = weld(surround(jamb_cut=cut), hanging.on_frame(), *lockset.strikes)
    panel = _moving(_leaf(leaf, blank, hanging, lockset), lockset)
    return frame.attach(panel, hanging.joint("door_hinge", needs=needs))


def _double(
    surround: Callable[..., Body],
    leaf: Callable[..., Body],
    blank: Blank,
    hanging: Hanging,
    lockset: Lockset,
    needs: Dependency | None,
    site: Site,
    hand: str,
) -> Body:
    """Hang the active leaf at the left and the inactive one, which a flush bolt holds, at the right."""
    other = "right" if hand == "left" else "left"
    thickness, gap = blank.thickness, hanging.gap  # the flush bolt's gap to the head is that to the jambs
    middle = (blank.width + site.gap) / 2.0
    active = _moving(_leaf(leaf, blank, hanging, lockset).suffixed(f"_{hand}"), lockset)

    # seen from the inactive leaf, which is drawn like the active one and mirrored into place
    opposite = [body.mirror(X).at(blank.width + site.gap, 0.0, 0.0) for body in lockset.strikes]
    pockets = [solid.mirror(X).at(blank.width + site.gap, 0.0, 0.0) for solid in lockset.strike_cuts]
    rod = (blank.width / 2.0 - 0.05, 0.0, blank.top)  # in the middle of a stile, behind the strikes
    slide = bolts.flush_bolt_slide(gap)
    held = Lockset(
        cuts=(bolts.flush_bolt_channel(thickness, gap).at(rod), *pockets),
        fixed=(
            bolts.flush_bolt_plate(thickness=thickness, gap=gap, finish=site.finish).at(rod),
            astragal(blank, site.gap),
            *opposite,
        ),
        moving=((bolts.flush_bolt(thickness=thickness, gap=gap, finish=site.finish).at(rod), slide),),
    )
    inactive = _moving(_leaf(leaf, blank, hanging, held).suffixed(f"_{other}"), held).mirror(X)

    in_head = (middle - rod[0], 0.0, blank.top)
    hung = hanging.on_frame().at(-middle)
    frame = weld(surround(head_cut=bolts.flush_bolt_pocket(gap).at(in_head)), hung, hung.mirror(X))
    first = hanging.joint(f"door_hinge_{hand}", middle=-middle, needs=needs)
    # the inactive leaf follows once the active one is out of its way
    free = ((slide > bolts.throw(gap)) & (first > _HALF_OPEN)).until(_HALF_OPEN)
    second = hanging.joint(f"door_hinge_{other}", middle=middle, side=-1, needs=free)
    frame = frame.attach(active.at(-middle), first)
    return frame.attach(inactive.at(middle), second)


def _leaf(leaf: Callable[..., Body], blank: Blank, hanging: Hanging, lockset: Lockset) -> Body:
    """Make a leaf with everything that is fixed on it."""
    cut = union(*lockset.cuts) if lockset.cuts else None
    return weld(leaf(blank=replace(blank, cut=cut)), hanging.on_leaf(), *lockset.fixed)


def _moving(panel: Body, lockset: Lockset) -> Body:
    """Attach what moves on a leaf."""
    for body, joint in lockset.moving:
        panel = panel.attach(body, joint)
    return panel
