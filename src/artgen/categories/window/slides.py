"""Windows whose sashes slide: past fixed ones, past each other to the side, or up and down.

All are drawn about the middle of their opening, with their inside at +y.
"""

import math
from dataclasses import dataclass, replace

from artgen import (
    Body,
    Joint,
    Prismatic,
    Scalar,
    X,
    Y,
    Z,
    frame,
    mass,
    min_,
    require,
    weld,
)
from artgen.categories.window.frame import TRACK, Tracks, tracked_frame
from artgen.categories.window.hardware import bow_pull
from artgen.categories.window.kinds import Draft
from artgen.categories.window.latches import LATCH_TOP, SashLock, sash_lifts, sash_lock, sliding_latch
from artgen.categories.window.plan import under
from artgen.categories.window.sashes import PANE, plain_sash, slide_face

_GRAVITY = 9.81  # [m/s^2]
_STRIP = 0.013  # how far the strips of tracks stand out into the opening [m]
_BALANCE = 8.0  # stiffness of the springs of a hung sash [N/m]
_LET_IN = 0.0005  # [m]
_LOCK = 0.045  # how far a sash lock stands over the meeting rail [m]
_ROOM = 0.006  # beyond the ends of a pull, for its flanges [m]
_PULL_MEETS = (
    "the pull has no room between its latch and the strip at the head: take a shorter bar or raise height"
)
_MEETING = 0.002  # from the middle of a window to the edges of two sashes that meet there [m]


def sliding(draft: Draft, panels: int, *, bar: Scalar, drag: Scalar) -> Body:
    """Make sashes that slide past fixed ones: one of two, or the middle ones of four."""
    body = tracked_frame(draft.width, draft.height, draft.section, draft.finish, head=_STRIP)
    if panels == 2:
        return weld(body, _sliding_pair(draft, draft.width, TRACK, bar, drag).at(-draft.width / 2.0))
    right = _sliding_pair(draft, draft.width / 2.0, _MEETING, bar, drag)
    return weld(body, right.mirror(X).suffixed("_0"), right.suffixed("_1"))


def _sliding_pair(draft: Draft, long: Scalar, start: float, bar: Scalar, drag: Scalar) -> Body:
    """Make a sash in the inner track, from x = `start` on, and the fixed one that it slides past."""
    section, tracks = draft.section, Tracks.of(draft.section)
    face, high = slide_face(section), draft.height - 2.0 * TRACK
    middle, inside = long / 2.0, tracks.inner + section.slide / 2.0
    # the fixed sash is screwed to the frame, half a millimetre into it
    still, wide = middle + face / 2.0 + _LET_IN, middle + face / 2.0 - start
    stile = start + face / 2.0 + 0.004  # in the middle of what the strip at the jamb leaves of it
    floor = _STRIP - draft.height / 2.0
    pull = bow_pull(length=bar, girth=0.0052, finish=draft.metal, name="handle_front")
    level, lock = _level(bar, draft.height), floor + 0.048
    level = require(level, level - bar / 2.0 - _ROOM > lock + LATCH_TOP, _PULL_MEETS)
    pull = pull.rotate(Z, math.pi).at(stile, tracks.inner + section.slide / 2.0, level)
    latch = sliding_latch(
        (stile, inside, lock),
        floor,
        1,
        name="lock_slide",
        friction=draft.friction,
        finish=draft.metal,
    )
    sash = plain_sash(wide, high, section, draft.glazing).at(start + wide / 2.0, tracks.inner, 0.0)
    slide = Prismatic(
        "pane_slide",
        axis=X,
        limits=(0.0, middle - face / 2.0 - TRACK - 0.002),
        friction=drag,
        damping=8.0,
        needs=(latch.slide > latch.free).until(latch.passed),
    )
    fixed = plain_sash(still, draft.height + 2.0 * _LET_IN, section, draft.glazing)
    fixed = fixed.at(long + _LET_IN - still / 2.0, tracks.outer, 0.0)
    moving = weld(sash, pull, latch.case).attach(latch.slider, latch.slide)
    return weld(latch.keep, fixed).attach(moving, slide)


def _level(bar: Scalar, height: Scalar) -> Scalar:
    """Return where the middle of a pull is: it ends below the strip at the head of an opening [m]."""
    return min_(0.06, height / 2.0 - _STRIP - _ROOM - bar / 2.0)


@dataclass(frozen=True)
class _Passing:
    """Two sashes that pass each other, the inner one below the outer one, with a lock where they meet."""

    draft: Draft  # what every window has

    @property
    def face(self) -> float:
        """Face of their rails and stiles [m]."""
        return slide_face(self.draft.section)

    @property
    def wide(self) -> Scalar:
        """Width of both [m]."""
        return self.draft.width - 2.0 * TRACK

    @property
    def tall(self) -> Scalar:
        """Height of both [m]."""
        return self.draft.height / 2.0 + self.face / 2.0 - TRACK

    @property
    def way(self) -> Scalar:
        """How far each has room to slide [m]."""
        return self.draft.height / 2.0 - self.face / 2.0 - TRACK - 0.004

    @property
    def inside(self) -> float:
        """Where the inner sash ends towards the room, y [m]."""
        return Tracks.of(self.draft.section).inner + self.draft.section.slide / 2.0

    @property
    def lock(self) -> SashLock:
        """The lock on their meeting rails."""
        draft, tracks, half = self.draft, Tracks.of(self.draft.section), self.draft.section.slide / 2.0
        inner, outer = tracks.inner - half, tracks.outer + half
        return sash_lock(0.0, inner, outer, self.face / 2.0, friction=draft.friction, finish=draft.metal)

    def inner(self, gear: Body, name: str) -> Body:
        """Make the inner sash with the lock, and `gear` in the axes of the sash's middle."""
        draft, lock, y = self.draft, self.lock, Tracks.of(self.draft.section).inner
        sash = plain_sash(self.wide, self.tall, draft.section, draft.glazing).at(0.0, y, 0.0)
        level = (self.tall - self.face) / 2.0
        sash = weld(sash, gear).at(0.0, 0.0, -level).suffixed(name)
        return weld(sash, lock.base).attach(lock.cam, lock.turn)

    def outer(self, name: str) -> Body:
        """Make the outer sash with the keeper of the lock.

        A finger on its meeting rail, beside the glass, pushes it.
        """
        draft, section = self.draft, self.draft.section
        y = Tracks.of(section).outer
        inset = min(0.0045, (section.slide - PANE) / 2.0 - 0.0095)  # of the finger from the face
        beside = {0: 0.25, 1: 0.25, 2: 1.0 / 3.0}.get(draft.glazing.columns, 0.125)  # between two bars
        rail = self.face - self.tall / 2.0 - under(section.eased) - 0.00005
        at = (beside * (self.wide - 2.0 * self.face), section.slide / 2.0 - inset, rail)
        press = frame(at, approach=-Z, closing=X)
        sash = plain_sash(self.wide, self.tall, section, draft.glazing, push=press)
        sash = sash.at(0.0, y, (self.tall - self.face) / 2.0).suffixed(name)
        return weld(sash, self.lock.keeper)


def double_hung(draft: Draft, *, lifts: int, drag: Scalar) -> Body:
    """Make two sashes that slide up and down, each balanced by springs, with a lock where they meet.

    Block-and-tackle and constant-force balances carry the weight of a sash at every height; brushes hold
    what is left (ANSI/AAMA 902). A soft spring that is drawn far out has a nearly constant force.
    """
    pair = _Passing(draft)
    places: list[Scalar] = [0.0] if lifts == 1 else [-0.26 * pair.wide, 0.26 * pair.wide]
    gear = sash_lifts(places, pair.inside, 0.6 * pair.face - pair.tall / 2.0, draft.metal)
    lower, upper = pair.inner(gear, "_lower"), pair.outer("_upper")
    body = tracked_frame(draft.width, draft.height, draft.section, draft.finish, head=_STRIP)
    # the lock stays below the head
    up = _balanced("pane_slide_lower", lower, 1, pair.way - _LOCK, drag, pair.lock)
    down = _balanced("pane_slide_upper", upper, -1, pair.way, drag, pair.lock)
    return body.attach(lower, up).attach(upper, down)


def sliding_both(draft: Draft, *, bar: Scalar, drag: Scalar) -> Body:
    """Make two sashes that both slide, the inner one from the left, with a lock where they meet."""
    glazing = replace(draft.glazing, columns=draft.glazing.rows, rows=draft.glazing.columns)
    # hung sashes laid on their side: what is below comes to the left
    pair = _Passing(replace(draft, width=draft.height, height=draft.width, glazing=glazing))
    pull = bow_pull(length=bar, girth=0.0052, finish=draft.metal, name="handle_front")
    stile = pair.face / 2.0 + 0.004 - pair.tall / 2.0  # in the middle of what the strip at the jamb leaves
    level = _level(bar, draft.height)
    pull = pull.rotate(Z, math.pi).rotate(Y, -math.pi / 2.0).at(-level, pair.inside, stile)
    body = tracked_frame(draft.height, draft.width, draft.section, draft.finish, head=_STRIP)
    sashes = (pair.inner(pull, "_0"), pair.outer("_1"))
    # the lock stays before the jamb
    for number, (sash, way, travel) in enumerate(
        zip(sashes, (1, -1), (pair.way - _LOCK, pair.way), strict=True)
    ):
        slide = Prismatic(
            f"pane_slide_{number}",
            axis=(0.0, 0.0, way),
            limits=(0.0, travel),
            friction=drag,
            damping=8.0,
            needs=pair.lock.turn > pair.lock.free,
        )
        body = body.attach(sash, slide)
    return body.rotate(Y, math.pi / 2.0)


def _balanced(name: str, sash: Body, way: int, travel: Scalar, drag: Scalar, lock: SashLock) -> Joint:
    weight = _GRAVITY * mass(sash)
    return Prismatic(
        name,
        axis=(0.0, 0.0, way),
        limits=(0.0, travel),
        stiffness=_BALANCE,
        rest=way * weight / _BALANCE + travel / 2.0,  # in balance half way
        friction=drag,
        damping=10.0,
        effort=400.0,
        needs=lock.turn > lock.free,
    )
