"""The kinds of windows: sashes that hang in a rebated frame, and sashes that slide in tracks.

All are drawn about the middle of their opening. Hinged sashes open to -y, so that those that open inwards
are mirrored; what slides has its inside at +y.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from artgen import (
    Body,
    Float,
    Joint,
    Material,
    Prismatic,
    Revolute,
    Scalar,
    X,
    Y,
    Z,
    atan2,
    center_of_mass,
    frame,
    mass,
    min_,
    sin,
    sqrt,
    weld,
)
from artgen.categories.parts.pulls import pull_handle
from artgen.categories.parts.sashes import PANE, Glazing, lipped_sash, plain_sash, slide_face
from artgen.categories.parts.window_frame import (
    TRACK,
    Tracks,
    cells,
    rebated_frame,
    tracked_frame,
)
from artgen.categories.parts.window_hardware import (
    RELEASED,
    CamLock,
    LeverStyle,
    Pin,
    barrel_hinges,
    cam_lock,
    lever_turn,
    window_lever,
)
from artgen.categories.parts.window_latches import SashLock, sash_lifts, sash_lock, sliding_latch
from artgen.categories.parts.window_plan import LIP, REBATE, SEALED, STOP, Section, under

_GRAVITY = 9.81  # [m/s^2]
_STRIP = 0.013  # how far the strips of tracks stand out into the opening [m]
_HOLDS = 1.15  # friction of a stay that holds a sash anywhere, over what its weight asks for
_LIFTS = 52.0  # what a hand lifts an awning with at most [N]
_BALANCE = 8.0  # stiffness of the springs of a hung sash [N/m]
_LET_IN = 0.0005  # [m]
_MEETING = 0.002  # from the middle of a window to the edges of two sashes that meet there [m]


@dataclass(frozen=True)
class Draft:
    """What every window has.

    Attributes:
        width: Of the opening in the frame [m].
        height: [m].
        section: Of the system.
        glazing: What fills the sashes.
        finish: Of the frame.
        metal: Of levers, locks and hinges.
        friction: Of the gear or detent of a lock [N m; N for a latch].
    """

    width: Float
    height: Float
    section: Section
    glazing: Glazing
    finish: Material
    metal: Material
    friction: Float


@dataclass(frozen=True)
class Swing:
    """How hinged sashes hang.

    Attributes:
        limit: How far they open [rad].
        friction: Of the hinges of a casement [N m].
        damping: [N m s/rad].
        lever: Style of the lever.
        length: Of the lever [m].
        turn: How far it turns [rad].
        stay: What holds an awning: a friction stay, or nothing.
    """

    limit: Float
    friction: Float
    damping: Float
    lever: LeverStyle
    length: Float
    turn: float
    stay: Literal["friction", "none"]


def casement(
    draft: Draft, swing: Swing, hands: tuple[int, ...], rows: Sequence[Scalar], *, inward: bool
) -> Body:
    """Make casements beside and above each other, hung at their sides.

    Args:
        draft: What every window has.
        swing: How they hang.
        hands: For each column from the left, 1 for hinges at the left and -1 at the right.
        rows: Shares of the height, from the bottom up.
        inward: Whether they open to the inside.
    """
    places = cells(draft.width, draft.height, len(hands), rows)
    body = rebated_frame(draft.width, draft.height, places, draft.section, draft.finish)
    for number, cell in enumerate(places):
        hung = _Hung(draft, swing, cell.width, cell.height, inward).body()
        hung = hung.mirror(X) if hands[cell.column] < 0 else hung
        hung = hung.suffixed(f"_{number}") if len(places) > 1 else hung
        body = weld(body, hung.at(cell.x, 0.0, cell.z))
    return body.mirror(Y) if inward else body


def awning(draft: Draft, swing: Swing) -> Body:
    """Make one sash that hangs at its top and opens to the outside."""
    places = cells(draft.width, draft.height, 1, (1.0,))
    body = rebated_frame(draft.width, draft.height, places, draft.section, draft.finish)
    glazing = replace(draft.glazing, columns=draft.glazing.rows, rows=draft.glazing.columns)
    # a casement laid on its side: its hinges at the left come to the top
    hung = _Hung(replace(draft, glazing=glazing), swing, draft.height, draft.width, False, falls=True)
    return weld(body, hung.body().rotate(Y, math.pi / 2.0))


@dataclass(frozen=True)
class _Hung:
    """A sash in an opening about the origin, with hinges at its left.

    Attributes:
        draft: What every window has.
        swing: How it hangs.
        width: Of the opening [m].
        height: [m].
        inward: Whether its lever is in front, where it opens to, or at its back.
        falls: Whether its hinges are to be level.
    """

    draft: Draft
    swing: Swing
    width: Scalar
    height: Scalar
    inward: bool
    falls: bool = False

    def body(self) -> Body:
        """Make what belongs to the frame, with the sash on it."""
        draft, swing, section, metal = self.draft, self.swing, self.draft.section, self.draft.metal
        pin = Pin.beside(self.width, section)
        low, high = -self.height / 2.0 + 0.11, self.height / 2.0 - 0.11
        on_frame, on_sash = barrel_hinges(
            pin, [low, high], tall=0.066, to=-self.width / 2.0 - LIP, face=0.0, finish=metal
        )
        face = -SEALED - section.lip if self.inward else section.depth
        # in the middle of what the stop leaves of the lock stile
        seen = REBATE + section.sash if self.inward else section.sash + REBATE + STOP
        at = (self.width / 2.0 - seen / 2.0, face, 0.0)
        rose, lever = window_lever(
            at, side=-1 if self.inward else 1, style=swing.lever, length=swing.length, finish=metal
        )
        turn = lever_turn("handle_turn", pivot=at, limit=swing.turn, friction=draft.friction)
        lock = cam_lock(
            turn, pin, self.width, 0.0, min_(0.30, self.height / 2.0 - 0.09), name="bolt_slide", finish=metal
        )
        sash = lipped_sash(self.width, self.height, section, draft.glazing)
        sash = weld(sash, on_sash, rose).attach(lever, turn).attach(lock.rod, lock.slide)
        hinge = self._falling(sash, pin, turn, lock) if self.falls else self._upright(pin, turn, lock)
        thick = section.depth + SEALED + section.lip / 2.0  # behind the axis
        body = weld(on_frame, lock.keeps).attach(sash, hinge)
        return body.require(
            thick * thick / (2.0 * self.width) < REBATE - 0.001,
            "the far edge of the sash would strike the frame",
        )

    def _upright(self, pin: Pin, turn: Joint, lock: CamLock) -> Joint:
        swing = self.swing
        return self._joint(pin, turn, lock, swing.limit, swing.friction)

    def _falling(self, sash: Body, pin: Pin, turn: Joint, lock: CamLock) -> Joint:
        """Make a level hinge, which a hand lifts: a friction stay holds the sash, or it falls shut."""
        swing, weight = self.swing, _GRAVITY * mass(sash)
        arm = center_of_mass(sash).x - pin.x
        holds = swing.stay == "friction"
        # a hand at the lever lifts the weight, and overcomes the friction that holds it
        most = _LIFTS * (self.width - 0.05) / (weight * arm * (1.0 + _HOLDS if holds else 1.0))
        sine = min_(most, 0.97)
        limit = min_(swing.limit, atan2(sine, sqrt(1.0 - sine * sine)))
        friction = _HOLDS * weight * arm * sin(limit) if holds else 0.15
        return self._joint(pin, turn, lock, limit, friction)

    def _joint(self, pin: Pin, turn: Joint, lock: CamLock, limit: Scalar, friction: Scalar) -> Joint:
        return Revolute(
            "pane_hinge",
            axis=-Z,
            pivot=(pin.x, pin.y, 0.0),
            limits=(0.0, limit),
            friction=friction,
            damping=self.swing.damping,
            effort=100.0,
            velocity=6.0,
            needs=(turn > RELEASED).until(lock.passed),
        )


def sliding(draft: Draft, panels: int, *, bar: Scalar, drag: Scalar) -> Body:
    """Make sashes that slide past fixed ones: one of two, or the middle ones of four.

    Args:
        draft: What every window has.
        panels: 2 or 4.
        bar: Length of the pulls [m].
        drag: Friction of rollers and brushes [N].
    """
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
    pull = _pull(bar, section.slide, draft.metal).at(stile, tracks.inner, 0.06)
    latch = sliding_latch(
        (stile, inside, floor + 0.048),
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


def _pull(length: Scalar, thickness: float, finish: Material) -> Body:
    """Make a bow on the face of a sash that looks to +y, upright, about the middle of the sash."""
    bow: Body = pull_handle(
        thickness=thickness,
        finish=finish,
        faces="front",
        style="U",
        length=length,
        projection=0.034,
        girth=0.0052,
    )
    return bow.rotate(Z, math.pi)


def double_hung(draft: Draft, *, lifts: int, drag: Scalar) -> Body:
    """Make two sashes that slide up and down, each balanced by springs, with a lock where they meet.

    Block-and-tackle and constant-force balances carry the weight of a sash at every height; brushes hold
    what is left (ANSI/AAMA 902). A soft spring that is drawn far out has a nearly constant force.

    Args:
        draft: What every window has.
        lifts: How many lifts the lower sash has.
        drag: Friction of brushes and balances [N].
    """
    section, tracks, metal = draft.section, Tracks.of(draft.section), draft.metal
    face, half = slide_face(section), draft.height / 2.0
    wide, tall = draft.width - 2.0 * TRACK, half + face / 2.0 - TRACK
    level = half - TRACK - tall / 2.0  # middle of the upper sash, over that of the opening
    lower_face, upper_face = tracks.inner - section.slide / 2.0, tracks.outer + section.slide / 2.0
    lock = sash_lock(0.0, lower_face, upper_face, face / 2.0, friction=draft.friction, finish=metal)

    places: list[Scalar] = [0.0] if lifts == 1 else [-0.26 * wide, 0.26 * wide]
    lift = sash_lifts(places, tracks.inner + section.slide / 2.0, 0.6 * face - tall / 2.0, metal)
    lower = weld(plain_sash(wide, tall, section, draft.glazing).at(0.0, tracks.inner, 0.0), lift)
    lower = weld(lower.at(0.0, 0.0, -level).suffixed("_lower"), lock.base).attach(lock.cam, lock.turn)
    # a finger on the meeting rail, beside the glass, pushes the upper sash down
    inset = min(0.0045, (section.slide - PANE) / 2.0 - 0.0095)  # of the finger from the face
    beside = {0: 0.25, 1: 0.25, 2: 1.0 / 3.0}.get(draft.glazing.columns, 0.125)  # between two bars
    rail = face - tall / 2.0 - under(section.eased) - 0.00005
    press = frame(
        (beside * (wide - 2.0 * face), upper_face - tracks.outer - inset, rail), approach=-Z, closing=X
    )
    upper = plain_sash(wide, tall, section, draft.glazing, push=press).at(0.0, tracks.outer, level)
    upper = weld(upper.suffixed("_upper"), lock.keeper)
    way = half - face / 2.0 - TRACK - 0.004
    body = tracked_frame(draft.width, draft.height, section, draft.finish, head=_STRIP)
    # the lock stays below the head
    up = _balanced("pane_slide_lower", lower, 1, way - 0.045, drag, lock)
    down = _balanced("pane_slide_upper", upper, -1, way, drag, lock)
    return body.attach(lower, up).attach(upper, down)


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
