"""Windows with sliding sashes: past fixed sashes, past each other sideways, or up and down.

All windows are modeled about the middle of their opening, with their inside at +y.
"""

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import artgen as ag
from artgen import details
from artgen.categories.window.frame import TRACK, Tracks, tracked_frame
from artgen.categories.window.hardware import bow_pull
from artgen.categories.window.kinds import Draft
from artgen.categories.window.plan import under
from artgen.categories.window.sashes import PANE, plain_sash, slide_face

LATCH_TOP = 0.044
"""Distance from the middle of a latch on the stile of a sliding sash to its top [m]."""


class SashLock(NamedTuple):
    """A cam on the lower meeting rail that turns under a keeper on the upper rail."""

    base: ag.Body  # base, which is welded to the lower sash
    cam: ag.Body  # turning part: the link `lock`
    keeper: ag.Body  # keeper, which is welded to the upper sash
    turn: ag.Joint  # joint of the cam
    free: float  # angle at which the cam has left the upper sash [rad]


def sash_lock(
    x: ag.Scalar,
    lower: ag.Scalar,
    upper: ag.Scalar,
    top: ag.Scalar,
    *,
    friction: ag.Scalar,
    finish: ag.Material,
) -> SashLock:
    """Make the lock of a double-hung window."""
    axis = lower + 0.015
    base = ag.hull(
        ag.box(0.056, 0.024, 0.004, bevel=0.0015).at(x, axis + 0.001, top + 0.0015),
        ag.box(0.030, 0.018, 0.004, bevel=0.0015).at(x, axis, top + 0.0105),
    )
    screws = [
        details.screw(
            0.0028, (x + side * 0.0235, axis, top + 0.0042), facing=ag.Z, material=finish, label="screw"
        )
        for side in (-1, 1)
    ]
    hub = ag.cylinder_between((x, axis, top + 0.0129), (x, axis, top + 0.0335), 0.0085, bevel=0.001)
    tip = upper - 0.0033  # bars on the glass start 4 mm behind that face
    tongue = ag.hull(
        ag.Region.between((x - 0.007, axis - 0.002, top + 0.0145), (x + 0.007, axis, top + 0.0195)).box(),
        ag.Region.between((x - 0.004, tip, top + 0.0145), (x + 0.004, tip + 0.004, top + 0.0195)).box(),
    )
    arm = ag.box(0.052, 0.011, 0.0055, bevel=0.0022).at(x - 0.026, axis, top + 0.0305)
    hold = ag.grasp_on(arm, approach=(0.0, -1.0, 0.0), closing=ag.Z, at=(x - 0.040, axis, top + 0.0305))
    cam = ag.part(ag.union(hub, tongue, arm), "lock", finish, name="lock", grasp=hold)
    wall = ag.Region.between(
        (x - 0.020, upper - 0.0135, top - 0.0005), (x + 0.020, upper - 0.0098, top + 0.0262)
    ).box(bevel=0.0008)
    roof = ag.Region.between(
        (x - 0.020, upper - 0.0135, top + 0.0212), (x + 0.020, upper - 0.0006, top + 0.0262)
    ).box(bevel=0.0012)
    turn = ag.Revolute(
        "lock_turn",
        axis=-ag.Z,  # moves the lever from the left, above the inside, to the right
        pivot=(x, axis, top),
        limits=(0.0, math.pi),
        friction=friction,
        damping=0.02,
        armature=0.0002,
        effort=5.0,
    )
    return SashLock(
        ag.weld(ag.part(base, "lock", finish), *screws),
        cam,
        ag.part(ag.union(wall, roof), "keep", finish),
        turn,
        1.35,
    )


def sash_lifts(places: list[ag.Scalar], face: ag.Scalar, z: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make hook lifts on the bottom rail of a sash with its face to +y."""
    plate = ag.box(0.054, 0.0035, 0.026, bevel=0.0014).at(0.0, face + 0.0012, z)
    hook = ag.Region.between((-0.023, face + 0.001, z + 0.001), (0.023, face + 0.020, z + 0.0065)).box(
        bevel=0.0022
    )
    lip = ag.Region.between((-0.023, face + 0.016, z + 0.001), (0.023, face + 0.020, z + 0.0125)).box(
        bevel=0.0018
    )
    lift = ag.union(plate, hook, lip)
    holds = [
        ag.grasp_on(hook.at(x, 0.0, 0.0), approach=(0.0, -1.0, 0.0), closing=ag.X, depth=0.0145)
        for x in places
    ]
    screws = [
        details.screw(
            0.0026, (x + side * 0.018, face + 0.0029, z - 0.006), facing=ag.Y, material=finish, label="screw"
        )
        for x in places
        for side in (-1, 1)
    ]
    return ag.weld(
        ag.part(ag.array(lift, at=[(x, 0.0, 0.0) for x in places]), "handle", finish, grasp=holds), *screws
    )


class Latch(NamedTuple):
    """A latch on the stile of a sliding sash that drops behind a keep on the frame."""

    case: ag.Body  # case, which is welded to the sash
    slider: ag.Body  # lifted part: the link `lock`
    keep: ag.Body  # keep, which is welded to the frame
    slide: ag.Joint  # joint of the slider
    free: float  # height at which the slider clears the keep [m]
    passed: float  # travel of the sash at which it has passed the keep [m]


def sliding_latch(
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar],
    floor: ag.Scalar,
    way: int,
    *,
    name: str,
    friction: ag.Scalar,
    finish: ag.Material,
) -> Latch:
    """Make a latch on the face of a sash at +y."""
    x, face, z = at
    tall, wide = 0.014, 0.010  # sizes of the keep, and of the part that drops beside it [m]
    bottom = floor + 0.0015
    slider = ag.Region.between(
        (x - wide / 2.0, face + 0.003, bottom), (x + wide / 2.0, face + 0.0105, z + 0.020)
    ).box(bevel=0.001)
    nub = ag.Region.between((x - 0.009, face + 0.0092, z - 0.008), (x + 0.009, face + 0.026, z + 0.008)).box(
        bevel=0.003
    )
    hold = ag.grasp_on(nub, approach=(0.0, -1.0, 0.0), closing=ag.X, depth=0.013)
    body = ag.part(ag.union(slider, nub), "lock", finish, name="lock", grasp=hold)
    # the slider runs between two cheeks on a plate
    low, high = floor + 0.0185 + 0.004, z + LATCH_TOP
    plate = ag.Region.between((x - 0.013, face - 0.0005, low), (x + 0.013, face + 0.0024, high)).box(
        bevel=0.0008
    )
    cheeks = [
        ag.Region.between(
            (x + side * 0.0095 - 0.0035, face, low), (x + side * 0.0095 + 0.0035, face + 0.0085, high)
        ).box(bevel=0.0015)
        for side in (-1, 1)
    ]
    keep = ag.Region.between(
        (x + way * (wide / 2.0 + 0.0012 + 0.005) - 0.005, face + 0.0040, floor - 0.0005),
        (x + way * (wide / 2.0 + 0.0012 + 0.005) + 0.005, face + 0.0125, floor + tall),
    ).box(bevel=0.0012)
    slide = ag.Prismatic(
        name, axis=ag.Z, limits=(0.0, 0.018), friction=friction, damping=1.0, armature=0.02, effort=30.0
    )
    case = ag.weld(*(ag.part(each, "lock", finish) for each in (plate, *cheeks)))
    return Latch(case, body, ag.part(keep, "keep", finish), slide, tall + 0.0015, 2.0 * wide + 0.006)


_GRAVITY = 9.81  # gravity [m/s^2]
_STRIP = 0.013  # projection of the strips of tracks into the opening [m]
_BALANCE = 8.0  # stiffness of the springs of a hung sash [N/m]
_LET_IN = 0.0005  # depth of fitted parts in the face [m]
_LOCK = 0.045  # height of a sash lock above the meeting rail [m]
_ROOM = 0.006  # space beyond the ends of a pull for its flanges [m]
_PULL_MEETS = "the pull has no room between its latch and the strip at the head: lower bar or raise height"
_MEETING = 0.002  # distance from the middle of a window to the edges of two sashes that meet there [m]


def sliding(draft: Draft, panels: int, *, bar: ag.Scalar, drag: ag.Scalar) -> ag.Body:
    """Make sashes that slide past fixed ones: one of two, or the middle two of four."""
    body = tracked_frame(draft.width, draft.height, draft.section, draft.finish, head=_STRIP)
    if panels == 2:
        return ag.weld(body, _sliding_pair(draft, draft.width, TRACK, bar, drag).at(-draft.width / 2.0))
    right = _sliding_pair(draft, draft.width / 2.0, _MEETING, bar, drag)
    return ag.weld(body, right.mirror(ag.X).suffixed("_0"), right.suffixed("_1"))


def _sliding_pair(draft: Draft, long: ag.Scalar, start: float, bar: ag.Scalar, drag: ag.Scalar) -> ag.Body:
    """Make a sash in the inner track, from x = `start`, and the fixed sash behind it."""
    section, tracks = draft.section, Tracks.of(draft.section)
    face, high = slide_face(section), draft.height - 2.0 * TRACK
    middle, inside = long / 2.0, tracks.inner + section.slide / 2.0
    # the fixed sash is screwed to the frame, with an overlap of half a millimeter
    still, wide = middle + face / 2.0 + _LET_IN, middle + face / 2.0 - start
    stile = start + face / 2.0 + 0.004  # in the middle of the part that is clear of the strip at the jamb
    floor = _STRIP - draft.height / 2.0
    pull = bow_pull(length=bar, girth=0.0052, finish=draft.metal, name="handle_front")
    level, lock = _level(bar, draft.height), floor + 0.048
    level = ag.require(level, level - bar / 2.0 - _ROOM > lock + LATCH_TOP, _PULL_MEETS)
    pull = pull.rotate(ag.Z, math.pi).at(stile, tracks.inner + section.slide / 2.0, level)
    latch = sliding_latch(
        (stile, inside, lock), floor, 1, name="lock_slide", friction=draft.friction, finish=draft.metal
    )
    sash = plain_sash(wide, high, section, draft.glazing).at(start + wide / 2.0, tracks.inner, 0.0)
    slide = ag.Prismatic(
        "pane_slide",
        axis=ag.X,
        limits=(0.0, middle - face / 2.0 - TRACK - 0.002),
        friction=drag,
        damping=8.0,
        needs=(latch.slide > latch.free).until(latch.passed),
    )
    fixed = plain_sash(still, draft.height + 2.0 * _LET_IN, section, draft.glazing)
    fixed = fixed.at(long + _LET_IN - still / 2.0, tracks.outer, 0.0)
    moving = ag.weld(sash, pull, latch.case).attach(latch.slider, latch.slide)
    return ag.weld(latch.keep, fixed).attach(moving, slide)


def _level(bar: ag.Scalar, height: ag.Scalar) -> ag.Scalar:
    """Return the height of the middle of a pull that ends below the strip at an opening's head [m]."""
    return ag.min_(0.06, height / 2.0 - _STRIP - _ROOM - bar / 2.0)


@dataclass(frozen=True)
class _Passing:
    """Two sashes that pass each other, the inner sash below the outer one, with a lock between them."""

    draft: Draft  # common data of the window

    @property
    def face(self) -> float:
        """Width of the rails and stiles [m]."""
        return slide_face(self.draft.section)

    @property
    def wide(self) -> ag.Scalar:
        """Width of both sashes [m]."""
        return self.draft.width - 2.0 * TRACK

    @property
    def tall(self) -> ag.Scalar:
        """Height of both sashes [m]."""
        return self.draft.height / 2.0 + self.face / 2.0 - TRACK

    @property
    def way(self) -> ag.Scalar:
        """Available travel of each sash [m]."""
        return self.draft.height / 2.0 - self.face / 2.0 - TRACK - 0.004

    @property
    def inside(self) -> float:
        """Position of the inside face of the inner sash along y [m]."""
        return Tracks.of(self.draft.section).inner + self.draft.section.slide / 2.0

    @property
    def lock(self) -> SashLock:
        """Return the lock on the meeting rails."""
        draft, tracks, half = self.draft, Tracks.of(self.draft.section), self.draft.section.slide / 2.0
        inner, outer = tracks.inner - half, tracks.outer + half
        return sash_lock(0.0, inner, outer, self.face / 2.0, friction=draft.friction, finish=draft.metal)

    def inner(self, gear: ag.Body, name: str) -> ag.Body:
        """Make the inner sash with the lock, and `gear` in the frame of the sash's middle."""
        draft, lock, y = self.draft, self.lock, Tracks.of(self.draft.section).inner
        sash = plain_sash(self.wide, self.tall, draft.section, draft.glazing).at(0.0, y, 0.0)
        level = (self.tall - self.face) / 2.0
        sash = ag.weld(sash, gear).at(0.0, 0.0, -level).suffixed(name)
        return ag.weld(sash, lock.base).attach(lock.cam, lock.turn)

    def outer(self, name: str) -> ag.Body:
        """Make the outer sash with the keeper of the lock.

        A finger on its meeting rail, beside the glass, pushes it.
        """
        draft, section = self.draft, self.draft.section
        y = Tracks.of(section).outer
        inset = min(0.0045, (section.slide - PANE) / 2.0 - 0.0095)  # distance of the finger from the face
        beside = {0: 0.25, 1: 0.25, 2: 1.0 / 3.0}.get(draft.glazing.columns, 0.125)  # between two bars
        rail = self.face - self.tall / 2.0 - under(section.eased) - 0.00005
        at = (beside * (self.wide - 2.0 * self.face), section.slide / 2.0 - inset, rail)
        press = ag.frame(at, approach=-ag.Z, closing=ag.X)
        sash = plain_sash(self.wide, self.tall, section, draft.glazing, push=press)
        sash = sash.at(0.0, y, (self.tall - self.face) / 2.0).suffixed(name)
        return ag.weld(sash, self.lock.keeper)


def double_hung(draft: Draft, *, lifts: int, drag: ag.Scalar) -> ag.Body:
    """Make two sashes that slide up and down, balanced by springs, with a lock at their meeting rails.

    Block-and-tackle and constant-force balances carry the weight of a sash at every height; brushes hold the
    remainder (ANSI/AAMA 902). A soft spring with a large extension has a nearly constant force.
    """
    pair = _Passing(draft)
    places: list[ag.Scalar] = [0.0] if lifts == 1 else [-0.26 * pair.wide, 0.26 * pair.wide]
    gear = sash_lifts(places, pair.inside, 0.6 * pair.face - pair.tall / 2.0, draft.metal)
    lower, upper = pair.inner(gear, "_lower"), pair.outer("_upper")
    body = tracked_frame(draft.width, draft.height, draft.section, draft.finish, head=_STRIP)
    # the lock stays below the head
    up = _balanced("pane_slide_lower", lower, 1, pair.way - _LOCK, drag, pair.lock)
    down = _balanced("pane_slide_upper", upper, -1, pair.way, drag, pair.lock)
    return body.attach(lower, up).attach(upper, down)


def sliding_both(draft: Draft, *, bar: ag.Scalar, drag: ag.Scalar) -> ag.Body:
    """Make two sashes that both slide, the inner sash from the left, with a lock at their meeting stiles."""
    glazing = replace(draft.glazing, columns=draft.glazing.rows, rows=draft.glazing.columns)
    # hung sashes turned by 90 degrees: the lower sash becomes the left one
    pair = _Passing(replace(draft, width=draft.height, height=draft.width, glazing=glazing))
    pull = bow_pull(length=bar, girth=0.0052, finish=draft.metal, name="handle_front")
    stile = (
        pair.face / 2.0 + 0.004 - pair.tall / 2.0
    )  # in the middle of the part that is clear of the strip at the jamb
    level = _level(bar, draft.height)
    pull = pull.rotate(ag.Z, math.pi).rotate(ag.Y, -math.pi / 2.0).at(-level, pair.inside, stile)
    body = tracked_frame(draft.height, draft.width, draft.section, draft.finish, head=_STRIP)
    sashes = (pair.inner(pull, "_0"), pair.outer("_1"))
    # the lock stays in front of the jamb
    for number, (sash, way, travel) in enumerate(
        zip(sashes, (1, -1), (pair.way - _LOCK, pair.way), strict=True)
    ):
        slide = ag.Prismatic(
            f"pane_slide_{number}",
            axis=(0.0, 0.0, way),
            limits=(0.0, travel),
            friction=drag,
            damping=8.0,
            needs=pair.lock.turn > pair.lock.free,
        )
        body = body.attach(sash, slide)
    return body.rotate(ag.Y, math.pi / 2.0)


def _balanced(
    name: str, sash: ag.Body, way: int, travel: ag.Scalar, drag: ag.Scalar, lock: SashLock
) -> ag.Joint:
    weight = _GRAVITY * sash.mass()
    return ag.Prismatic(
        name,
        axis=(0.0, 0.0, way),
        limits=(0.0, travel),
        stiffness=_BALANCE,
        rest=way * weight / _BALANCE + travel / 2.0,  # balance at half the travel
        friction=drag,
        damping=10.0,
        effort=400.0,
        needs=lock.turn > lock.free,
    )
