"""Hardware of hinged sashes: barrel hinges, and levers that move cams in the edge of a sash.

Hinged sashes are modeled about the middle of their opening with their hinges at the left; they open to -y.
The front plane of the frame is y = 0.
"""

from typing import Literal, NamedTuple

import artgen as ag
from artgen import details
from artgen.categories.shared.pulls import bar_pull
from artgen.categories.window.plan import LIP, REBATE, SEALED, Section

BARREL = 0.0065
"""Radius of hinges [m]."""

_BESIDE = 0.0020  # gap from a barrel to the lip beside it [m]
_APART = 0.0005  # gap between the halves of a hinge [m]

_TRAVEL = 0.016  # travel of the cams for a quarter turn of the lever [m]
QUARTER = 1.57
RELEASED = 1.30
"""Angle of the lever at which the cams are out of their keeps [rad]."""

_CAM = (0.008, 0.010)  # size of a cam along y and z [m]
_KEEP = (0.009, 0.012)
_KEEP_OUT, _KEEP_BEVEL = 0.0066, 0.0015  # height of keeps above the frame, and their bevels [m]
_PLAY = 0.0009  # play of a closed window [m]
_EDGE_GAP = 0.0003

LEVER_OUT = 0.046
"""Height of a lever above its face [m]."""

LeverStyle = Literal["straight", "tapered", "bent"]


class Pin(NamedTuple):
    """The axis of the hinges of a sash, parallel to z."""

    x: ag.Scalar  # position of the axis along x [m]
    y: ag.Scalar  # position of the axis along y [m]

    @staticmethod
    def beside(width: ag.Scalar, section: Section) -> "Pin":
        """Return the axis beside the lip of a sash in an opening of some width."""
        return Pin(-width / 2.0 - LIP - _BESIDE - BARREL, -SEALED - section.lip / 2.0)


def barrel_hinges(
    pin: Pin,
    levels: list[ag.Scalar],
    *,
    tall: float,
    to: ag.Scalar,
    face: ag.Scalar,
    finish: ag.Material,
    solid: bool = True,
) -> tuple[ag.Body, ag.Body]:
    """Make barrel hinges: the upper half turns with the sash, the lower half is on the frame."""
    half = tall / 2.0 - _APART
    up, down = _APART + half / 2.0, -_APART - half / 2.0
    barrel = ag.cylinder(BARREL, half, axis=ag.Z, bevel=0.001)
    # a post inside the barrel collides, in one piece with the arm or the foot
    core = ag.extrude(ag.regular_polygon(8, BARREL - 0.0001), half - 0.0002)
    arm = ag.Region.between((0.0, -0.0025, -0.4 * half), (to - pin.x + 0.001, 0.0025, 0.4 * half)).box()
    foot = ag.Region.between((-0.004, 0.0, -0.4 * half), (0.004, face - pin.y + 0.001, 0.4 * half)).box()
    tip = ag.cylinder(0.55 * BARREL, 0.003, axis=ag.Z, bevel=0.001)
    places = [(pin.x, pin.y, level) for level in levels]
    made = []
    for middle, holds, end in ((down, foot, -1.0), (up, arm, 1.0)):
        seen = ag.union(barrel, tip.at(0.0, 0.0, end * (half / 2.0 + 0.001))).at(0.0, 0.0, middle)
        met = ag.array(ag.hull(core, holds).at(0.0, 0.0, middle), at=places)
        skin = ag.detail(ag.array(seen, at=places), "hinge", finish)
        made.append(
            ag.weld(ag.part(met, "hinge", finish) if solid else ag.detail(met, "hinge", finish), skin)
        )
    return made[0], made[1]


def lever_turn(
    name: str, *, pivot: tuple[ag.Scalar, ag.Scalar, ag.Scalar], limit: ag.Scalar, friction: ag.Scalar
) -> ag.Joint:
    """Make the joint of a lever that points down while locked, held by the detents of its gear."""
    return ag.Revolute(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=(0.0, limit),
        friction=friction,
        damping=0.05,
        armature=0.0008,
        effort=12.0,
    )


def window_lever(
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar],
    *,
    side: int,
    style: LeverStyle,
    length: ag.Scalar,
    finish: ag.Material,
) -> tuple[ag.Body, ag.Body]:
    """Make a lever and its rose on a stile."""
    x, face, z = at
    rose = ag.box(0.028, 0.0115, 0.066, bevel=0.0045).at(x, face + side * 0.0055, z)
    caps = [
        details.screw(
            0.0032, (x, face + side * 0.0112, z + up), facing=(0.0, side, 0.0), material=finish, label="screw"
        )
        for up in (-0.022, 0.022)
    ]
    start, out = face + side * 0.0117, face + side * (LEVER_OUT - 0.006)
    neck = ag.cylinder_between((x, start, z), (x, face + side * LEVER_OUT, z), 0.0088, bevel=0.0015)
    low = z - length
    seen: list[ag.Body] = []
    match style:
        case "straight":
            grip = ag.box(0.018, 0.012, length - 0.004, bevel=0.0045).at(x, out, (z + low) / 2.0 + 0.002)
        case "tapered":
            top = ag.box(0.014, 0.010, 0.012, bevel=0.004).at(x, out, z - 0.002)
            end = ag.box(0.023, 0.011, 0.014, bevel=0.005).at(x, out, low + 0.007)
            seen.append(ag.detail(ag.hull(top, end), "handle", finish))
            # collider with few corners, just under the visible surface
            upper = _octagonal(0.0136, 0.0096, 0.0060, cut=0.0026).at(x, out, z - 0.002)
            lower = _octagonal(0.0222, 0.0104, 0.0090, cut=0.0032).at(x, out, low + 0.007)
            grip = ag.hull(upper, lower)
        case "bent":
            course = ag.polyline(
                [(x, out, z - 0.001), (x, out, low + 0.006), (x, out - side * 0.016, low + 0.006)],
                fillet=0.009,
            )
            seen.append(
                ag.detail(ag.sweep(ag.rectangle(0.017, 0.011, radius=0.004), course), "handle", finish)
            )
            # inside that surface: a bar, and a piece for the bend
            grip = ag.Region(
                (x - 0.008, x + 0.008), (out - 0.005, out + 0.005), (low + 0.0145, z - 0.0015)
            ).box()
            end = ag.box(0.0156, 0.0067, 0.0070).at(x, out - side * 0.01235, low + 0.0045)
            bend = ag.Region(
                (x - 0.0078, x + 0.0078), (out - 0.005, out + 0.005), (low + 0.0145, low + 0.0155)
            ).box()
            seen.append(ag.part(ag.hull(bend, end), "handle", finish))
    hold = ag.grasp_on(grip, approach=(0.0, -side, 0.0), closing=ag.X, at=(x, out, z - 0.62 * length))
    lever = ag.weld(ag.part(ag.union(neck, grip), "handle", finish, grasp=hold), *seen)
    return ag.weld(ag.part(rose, "handle", finish), *caps), lever


def _octagonal(wide: float, deep: float, tall: float, *, cut: float) -> ag.Solid:
    """Make a vertical bar about the origin with chamfered edges."""
    x, y = wide / 2.0, deep / 2.0
    right = [(x, cut - y), (x, y - cut), (x - cut, y)]
    corners = [(x - cut, -y), *right, *((-a, -b) for a, b in [(x - cut, -y), *right])]
    return ag.extrude(ag.polygon(corners), tall)


def bow_pull(*, length: ag.Scalar, girth: float, finish: ag.Material, name: str) -> ag.Body:
    """Make a vertical bow on the face y = 0, towards -y, with round flanges under its ends."""
    bow: ag.Body = bar_pull(
        finish=finish, name=name, level=False, style="bow", length=length, projection=0.034, girth=girth
    )
    flange = ag.cylinder(girth + 0.004, 0.005, axis=ag.Y, bevel=0.0012)
    ends = [(0.0, -0.002, end * (length / 2.0 - girth)) for end in (-1, 1)]
    return ag.weld(bow, ag.detail(ag.array(flange, at=ends), "handle", finish))


def swings_out(arm: ag.Scalar, back: ag.Scalar, past: ag.Scalar) -> ag.Scalar:
    """Return the distance of a corner from the axis of a sash that clears a part beside it [m]."""
    return past * (back - past / 2.0) / arm


class CamLock(NamedTuple):
    """Cams in the edge of a sash; a lever slides them behind keeps on the frame."""

    rod: ag.Body  # sliding part: the link `bolt`
    keeps: ag.Body  # keeps, which are welded to the frame
    slide: ag.Joint  # joint of the rod
    passed: ag.Float | ag.Scalar  # angle of the pane at which the cams clear the keeps [rad]
    nears: ag.Scalar  # swing of a rod towards the keeps before it passes them [m]
    room: float  # gap from the rod to the keeps [m]


def cam_lock(
    turn: ag.Joint,
    pin: Pin,
    width: ag.Scalar,
    level: ag.Scalar,
    reach: ag.Scalar,
    *,
    name: str,
    finish: ag.Material,
) -> CamLock:
    """Make cams at the lock edge of a sash, in the groove between it and the frame."""
    edge = width / 2.0 - REBATE
    middle = 0.029  # depth of the middle of the cams [m]
    deep, tall = _CAM
    out = REBATE - 0.0034
    cam = ag.Region.between(
        (edge + _EDGE_GAP, middle - deep / 2.0, -tall / 2.0), (edge + out, middle + deep / 2.0, tall / 2.0)
    ).box(bevel=0.0012)
    wide, thick = 0.006, _EDGE_GAP + 0.0022
    rail = ag.Region.between(
        (edge + _EDGE_GAP, middle - wide, level - reach - 0.012),
        (edge + thick, middle + wide, level + reach + 0.012),
    ).box()
    heights = [level - reach, level + reach]
    rod = ag.part(ag.union(rail, *(cam.at(0.0, 0.0, z) for z in heights)), "lock", finish, name="bolt")
    front = middle - deep / 2.0 - _PLAY
    keep = ag.Region.between(
        (width / 2.0 - _KEEP_OUT, front - _KEEP[0], -_KEEP[1] / 2.0),
        (width / 2.0 + 0.001, front, _KEEP[1] / 2.0),
    ).box(bevel=_KEEP_BEVEL)
    plate = ag.box(0.0012, 0.024, 0.046, bevel=0.0004).at(width / 2.0 - 0.0005, middle - 0.004, 0.0)
    places = [(0.0, 0.0, z) for z in heights]
    keeps = ag.weld(
        ag.part(ag.array(keep, at=places), "keep", finish),
        ag.detail(ag.array(plate, at=places), "keep", finish),
    )
    slide = ag.Prismatic(name, axis=ag.Z, follows=(_TRAVEL / QUARTER) * turn, damping=2.0)
    # until the back of the cam has passed the front of the keep
    passed = 1.05 * (deep + _PLAY + _KEEP[0] + 0.003) / (edge - pin.x)
    past = middle + wide - (front - _KEEP[0] + _KEEP_BEVEL)
    nears = swings_out(edge + thick - pin.x, middle + wide - pin.y, past)
    return CamLock(rod, keeps, slide, passed, nears, REBATE - thick - _KEEP_OUT)
