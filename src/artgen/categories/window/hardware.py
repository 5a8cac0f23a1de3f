"""Hardware of windows: barrel hinges, levers with cams in the edge of a sash, locks, latches and pulls.

Parts are made about their pivot, or about the middle of their base on the sash, towards the inside at +y;
levers go to either side.
"""

import math
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.pulls import bar_pull

BARREL = 0.0065
"""Radius of hinges [m]."""

REBATE = 0.0115
"""Gap between the edge of a sash and its frame, for cams and keeps: 12 mm in the eurogroove [m]."""

RELEASED = 1.30
"""Angle of a lever at which its cams are out of their keeps [rad]."""

LEVER_OUT = 0.046
"""Height of a lever above its face [m]."""

CAM_TRAVEL = 0.016 / 1.57
"""Travel of the cams over the angle of their lever [m/rad]."""

_PLAY = 0.0009  # play of a closed window [m]
_EDGE_GAP = 0.0003  # gap between a sash and the rod of its cams [m]

LeverStyle = Literal["straight", "tapered", "bent"]


def barrel_hinges(
    *,
    tall: float,
    arm: ag.Scalar,
    foot: ag.Scalar,
    at: Sequence[ag.VectorLike],
    finish: ag.Material,
    solid: bool,
) -> list[ag.Body]:
    """Make hinges on an axis: their lower halves on the frame, their upper halves on the sash at the right.

    `arm` and `foot` are the distances from the axis to the sash (x) and to the frame (y).
    """
    half, gap = tall / 2 - 0.0005, 0.0005  # the halves are 1 mm apart
    barrel = ag.cylinder(BARREL, half, axis=ag.Z, bevel=0.001)
    tip = ag.cylinder(0.55 * BARREL, 0.003, axis=ag.Z, bevel=0.001)
    # a post inside the barrel collides, in one piece with the arm or the foot
    core = ag.extrude(ag.regular_polygon(8, BARREL - 0.0001), half - 0.0002)
    z = (-0.4 * half, 0.4 * half)
    on_frame = ag.Region((-0.004, 0.004), (0, foot + 0.001), z).box()
    on_sash = ag.Region((0, arm + 0.001), (-0.0025, 0.0025), z).box()
    halves = []
    for end, holds in ((-1, on_frame), (1, on_sash)):
        middle = end * (gap + half / 2)
        skin = ag.array((barrel | tip.at(z=end * (half / 2 + 0.001))).at(z=middle), at=at)
        bones = ag.array(ag.hull(core, holds).at(z=middle), at=at)
        body = (ag.part if solid else ag.detail)(bones, "hinge", finish)
        halves.append(ag.weld(body, ag.detail(skin, "hinge", finish)))
    return halves


def window_lever(
    side: int, *, style: LeverStyle, length: ag.Scalar, finish: ag.Material
) -> tuple[ag.Body, ag.Body]:
    """Make the rose and the lever of a stile with the face y = 0, towards side * y; it points down."""
    rose = ag.box(0.028, 0.0115, 0.066, bevel=0.0045).at(y=side * 0.0055)
    facing = (0.0, side, 0.0)
    caps = [
        details.screw(0.0032, (0.0, side * 0.0112, z), facing=facing, material=finish)
        for z in (-0.022, 0.022)
    ]
    out, low = side * (LEVER_OUT - 0.006), -length
    neck = ag.cylinder_between((0.0, side * 0.0117, 0.0), (0.0, side * LEVER_OUT, 0.0), 0.0088, bevel=0.0015)
    solids, seen = [], []
    if style == "straight":
        grip = ag.box(0.018, 0.012, length - 0.004, bevel=0.0045).at(0.0, out, low / 2 + 0.002)
    elif style == "tapered":
        top = ag.box(0.014, 0.010, 0.012, bevel=0.004).at(0.0, out, -0.002)
        end = ag.box(0.023, 0.011, 0.014, bevel=0.005).at(0.0, out, low + 0.007)
        seen.append(ag.hull(top, end))
        # collider with few corners, just under the visible surface
        upper = _octagonal(0.0136, 0.0096, 0.0060, cut=0.0026).at(0.0, out, -0.002)
        grip = ag.hull(upper, _octagonal(0.0222, 0.0104, 0.0090, cut=0.0032).at(0.0, out, low + 0.007))
    else:
        turned = out - side * 0.016
        corners = [(0.0, out, -0.001), (0.0, out, low + 0.006), (0.0, turned, low + 0.006)]
        course = ag.polyline(corners, fillet=0.009)
        seen.append(ag.sweep(ag.rectangle(0.017, 0.011, radius=0.004), course))
        # inside that surface: a bar, and a piece for the bend
        bar = ag.Region((-0.008, 0.008), (out - 0.005, out + 0.005), (low + 0.0145, -0.0015))
        grip, start = bar.box(), bar.shrink(x=0.0002).stack(None, 0.001)[1].box()
        end = ag.box(0.0156, 0.0067, 0.0070).at(0.0, out - side * 0.01235, low + 0.0045)
        solids.append(ag.hull(start, end))
    hold = ag.grasp_on(grip, approach=(0.0, -side, 0.0), closing=ag.X, at=(0.0, out, -0.62 * length))
    lever = ag.part([neck | grip, *solids], "handle", finish, grasp=hold)
    if seen:
        lever = ag.weld(lever, ag.detail(seen, "handle", finish))
    return ag.weld(ag.part(rose, "handle", finish), *caps), lever


def _octagonal(wide: float, deep: float, tall: float, *, cut: float) -> ag.Solid:
    """Make a vertical bar about the origin with chamfered edges."""
    x, y = wide / 2, deep / 2
    right = [(x, cut - y), (x, y - cut), (x - cut, y)]
    corners = [(x - cut, -y), *right, *((-a, -b) for a, b in [(x - cut, -y), *right])]
    return ag.extrude(ag.polygon(corners), tall)


def bow_pull(*, length: ag.Scalar, girth: float, finish: ag.Material) -> ag.Body:
    """Make a vertical bow on the face y = 0, towards -y, with round flanges under its ends."""
    bow: ag.Body = bar_pull(
        finish=finish,
        name="handle_front",
        level=False,
        style="bow",
        length=length,
        projection=0.034,
        girth=girth,
    )
    flange = ag.cylinder(girth + 0.004, 0.005, axis=ag.Y, bevel=0.0012)
    ends = [(0.0, -0.002, end * (length / 2 - girth)) for end in (-1, 1)]
    return ag.weld(bow, ag.detail(ag.array(flange, at=ends), "handle", finish))


def swings_out(arm: ag.Scalar, back: ag.Scalar, past: ag.Scalar) -> ag.Scalar:
    """Return the distance of a corner from the axis of a sash that clears a part beside it [m]."""
    return past * (back - past / 2) / arm


def cam_lock(
    x: ag.Scalar, axis: tuple[ag.Scalar, ag.Scalar], reach: ag.Scalar, *, finish: ag.Material
) -> tuple[ag.Body, ag.Body, ag.Scalar, ag.Bool | bool]:
    """Make a rod of cams in the groove at the edge of a sash, and keeps on the frame at `x`.

    Also return the angle of the sash at which the cams clear the keeps [rad], and whether the rod, as the
    sash swings about its axis, clears them.
    """
    edge, middle, wide, thick = x - REBATE, 0.029, 0.006, _EDGE_GAP + 0.0022
    heights = [-reach, reach]
    cam = ag.Region(
        (edge + _EDGE_GAP, edge + REBATE - 0.0034), (middle - 0.004, middle + 0.004), (-0.005, 0.005)
    )
    rail = cam.with_(
        x=(cam.x.low, edge + thick), y=(middle - wide, middle + wide), z=(-reach - 0.012, reach + 0.012)
    )
    solid = cam.box(bevel=0.0012)
    rod = ag.part(ag.union(rail.box(), *(solid.at(z=z) for z in heights)), "lock", finish, name="bolt")
    room, bevel = 0.0066, 0.0015  # height of keeps above the frame, and their bevels [m]
    front = cam.y.low - _PLAY
    keep = ag.Region((x - room, x + 0.001), (front - 0.009, front), (-0.006, 0.006))
    plate = ag.box(0.0012, 0.024, 0.046, bevel=0.0004).at(x - 0.0005, middle - 0.004)
    places = [(0.0, 0.0, z) for z in heights]
    keeps = ag.weld(
        ag.part(ag.array(keep.box(bevel=bevel), at=places), "keep", finish),
        ag.detail(ag.array(plate, at=places), "keep", finish),
    )
    # until the back of the cam has passed the front of the keep
    passed = 1.05 * (cam.y.size + _PLAY + keep.y.size + 0.003) / (edge - axis[0])
    past = rail.y.high - (keep.y.low + bevel)
    nears = swings_out(rail.x.high - axis[0], rail.y.high - axis[1], past)
    return rod, keeps, passed, nears < REBATE - thick - room - 0.0001


LOCK_FREE = 1.35
"""Angle at which the cam of a sash lock has left the upper sash [rad]."""


def sash_lock(*, friction: ag.Scalar, finish: ag.Material) -> tuple[ag.Body, ag.Body, ag.Joint]:
    """Make a lock about its axis on the rail z = 0 of the inner sash: base, cam, and joint of the cam.

    The cam turns under the keeper on the rail of the outer sash, 14 mm before the face of the inner one.
    """
    base = ag.hull(
        ag.box(0.056, 0.024, 0.004, bevel=0.0015).at(y=0.001, z=0.0015),
        ag.box(0.030, 0.018, 0.004, bevel=0.0015).at(z=0.0105),
    )
    screws = [
        details.screw(0.0028, (x, 0.0, 0.0042), facing=ag.Z, material=finish) for x in (-0.0235, 0.0235)
    ]
    face = -0.029  # of the outer sash
    hub = ag.cylinder_between((0.0, 0.0, 0.0129), (0.0, 0.0, 0.0335), 0.0085, bevel=0.001)
    root = ag.Region((-0.007, 0.007), (-0.002, 0), (0.0145, 0.0195))
    tip = root.with_(x=(-0.004, 0.004), y=(face - 0.0033, face + 0.0007))  # bars on the glass are 4 mm behind
    arm = ag.box(0.052, 0.011, 0.0055, bevel=0.0022).at(-0.026, 0.0, 0.0305)
    hold = ag.grasp_on(arm, approach=(0.0, -1.0, 0.0), closing=ag.Z, at=(-0.040, 0.0, 0.0305))
    tongue = ag.hull(root.box(), tip.box())
    cam = ag.part(ag.union(hub, tongue, arm), "lock", finish, name="lock", grasp=hold)
    # moves the arm from the left, above the inside, to the right
    drag = feel.Feel(friction=friction, damping=0.02, armature=0.0002, effort=5)
    turn = ag.Revolute("lock_turn", axis=-ag.Z, limits=(0, math.pi), feel=drag)
    return ag.weld(ag.part(base, "lock", finish), *screws), cam, turn


def lock_keeper(face: ag.Scalar, top: ag.Scalar, *, finish: ag.Material) -> ag.Body:
    """Make the keeper on the rail of the outer sash, which ends at y = face and z = top."""
    wall = ag.Region((-0.020, 0.020), (face - 0.0135, face - 0.0098), (top - 0.0005, top + 0.0262))
    roof = ag.Region(wall.x, (face - 0.0135, face - 0.0006), (top + 0.0212, top + 0.0262))
    return ag.part(wall.box(bevel=0.0008) | roof.box(bevel=0.0012), "keep", finish)


def sash_lifts(places: list[ag.Scalar], finish: ag.Material) -> ag.Body:
    """Make hook lifts at some places along x on the face y = 0 of a bottom rail."""
    plate = ag.box(0.054, 0.0035, 0.026, bevel=0.0014).at(y=0.0012)
    hook = ag.Region((-0.023, 0.023), (0.001, 0.020), (0.001, 0.0065)).box(bevel=0.0022)
    lip = ag.Region((-0.023, 0.023), (0.016, 0.020), (0.001, 0.0125)).box(bevel=0.0018)
    holds = [ag.grasp_on(hook.at(x), approach=(0.0, -1.0, 0.0), closing=ag.X, depth=0.0145) for x in places]
    lifts = ag.array(ag.union(plate, hook, lip), at=[(x, 0.0, 0.0) for x in places])
    screws = [
        details.screw(0.0026, (x + side * 0.018, 0.0029, -0.006), facing=ag.Y, material=finish)
        for x in places
        for side in (-1, 1)
    ]
    return ag.weld(ag.part(lifts, "handle", finish, grasp=holds), *screws)


LATCH_TOP = 0.044
"""Distance from the middle of a latch to its top [m]."""

LATCH_UP = 0.048
"""Height of the middle of a latch above the floor of its track [m]."""

LATCH_FREE = 0.0155
"""Travel of the slider of a latch that clears its keep [m]."""

LATCH_PASSED = 0.026
"""Travel of a sash at which its latch has passed the keep [m]."""


def sliding_latch(*, friction: ag.Scalar, finish: ag.Material) -> tuple[ag.Body, ag.Body, ag.Body, ag.Joint]:
    """Make a latch on a sash, with the keep on the track beside it: case, slider, keep, and joint."""
    slider = ag.Region((-0.005, 0.005), (0.003, 0.0105), (0.0015 - LATCH_UP, 0.020)).box(bevel=0.001)
    nub = ag.Region((-0.009, 0.009), (0.0092, 0.026), (-0.008, 0.008)).box(bevel=0.003)
    hold = ag.grasp_on(nub, approach=(0.0, -1.0, 0.0), closing=ag.X, depth=0.013)
    body = ag.part(slider | nub, "lock", finish, name="lock", grasp=hold)
    # the slider runs between two cheeks on a plate
    plate = ag.Region((-0.013, 0.013), (-0.0005, 0.0024), (-0.0255, LATCH_TOP))
    cheek = plate.with_(x=(0.006, 0.013), y=(0.0, 0.0085)).box(bevel=0.0015)
    case = ag.part([plate.box(bevel=0.0008), cheek.mirror(ag.X), cheek], "lock", finish)
    beside = ag.Region((0.0062, 0.0162), (0.0040, 0.0125), (-0.0485, 0.014 - LATCH_UP))
    keep = ag.part(beside.box(bevel=0.0012), "keep", finish)
    slide = ag.Prismatic(
        "lock_slide", axis=ag.Z, limits=(0, 0.018), friction=friction, damping=1, armature=0.02, effort=30
    )
    return case, body, keep, slide
