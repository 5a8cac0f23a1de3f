"""Casements and awnings in a rebated frame, and the common parts of all windows.

All windows are modeled about the middle of their opening. Sashes open to -y; windows that open inward are
mirrored.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen.categories.window.frame import cells, rebated_frame
from artgen.categories.window.hardware import (
    LEVER_OUT,
    RELEASED,
    CamLock,
    LeverStyle,
    Pin,
    barrel_hinges,
    cam_lock,
    lever_turn,
    swings_out,
    window_lever,
)
from artgen.categories.window.plan import LIP, REBATE, SEALED, STOP, Section
from artgen.categories.window.sashes import Glazing, lipped_sash

_GRAVITY = 9.81  # gravity [m/s^2]
_HOLDS = 1.15  # ratio of the friction of a stay to the load of a sash
_LIFTS = 52.0  # largest force of a hand that lifts an awning [N]
_LEVERS_MEET = (
    "the levers of two sashes that open towards each other would collide: lower swing or lever_length, "
    "raise width, or take hands=same"
)
_HINGED = 0.288  # least side length of a sash with two hinges [m]
_LOCKED = 0.228  # least side length of a sash with two keeps and visual-only hinges [m]
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


@dataclass(frozen=True)
class Draft:
    """Common data of windows."""

    width: ag.Float  # width of the opening in the frame [m]
    height: ag.Float  # height of the opening in the frame [m]
    section: Section  # sections of the window system
    glazing: Glazing  # filling of the sashes
    finish: ag.Material  # finish of the frame
    metal: ag.Material  # metal of levers, locks and hinges
    friction: ag.Float  # friction of the gear or detent of a lock [N m], or of a latch [N]


@dataclass(frozen=True)
class Swing:
    """Motion of hinged sashes and their levers."""

    limit: ag.Float  # opening angle of the sashes [rad]
    friction: ag.Float  # friction of the hinges of a casement [N m]
    damping: ag.Float  # damping of the hinges [N m s/rad]
    lever: LeverStyle  # style of the lever
    length: ag.Float  # length of the lever [m]
    turn: float  # range of the lever [rad]
    stay: Literal["friction", "none"]  # holder of an awning: a friction stay, or none
    # whether hinges and stops have mass and collide; with many leaves they are visual only, because
    # simulators test all pairs of close colliders
    solid: bool


def casement(
    draft: Draft, swing: Swing, hands: tuple[int, ...], rows: Sequence[ag.Scalar], *, inward: bool
) -> ag.Body:
    """Make side-hung casements beside and above each other."""
    places = cells(draft.width, draft.height, len(hands), rows)
    body = rebated_frame(draft.width, draft.height, places, draft.section, draft.finish, solid=swing.solid)
    for number, cell in enumerate(places):
        hung = _Hung(draft, swing, cell.width, cell.height, inward).body()
        hung = hung.mirror(ag.X) if hands[cell.column] < 0 else hung
        hung = hung.suffixed(f"_{number}") if len(places) > 1 else hung
        body = ag.weld(body, hung.at(cell.x, 0.0, cell.z))
    if inward:
        for left, right in pairwise(places[: len(hands)]):
            if hands[left.column] < hands[right.column]:  # both have their hinges on the post between them
                pin = Pin.beside(left.width, draft.section).x
                reach = left.width / 2.0 - _seen(draft.section, inward=True) / 2.0 - pin - swing.length
                out = LEVER_OUT + draft.section.lip / 2.0
                tip = out * ag.sin(swing.limit) - reach * ag.cos(
                    swing.limit
                )  # past the axis, after a quarter turn towards it
                body = body.require(tip <= (right.x - left.x) / 2.0 + pin - 0.001, _LEVERS_MEET)
    return body.mirror(ag.Y) if inward else body


def awning(draft: Draft, swing: Swing) -> ag.Body:
    """Make one top-hung sash that opens to the outside."""
    places = cells(draft.width, draft.height, 1, (1.0,))
    body = rebated_frame(draft.width, draft.height, places, draft.section, draft.finish, solid=swing.solid)
    glazing = replace(draft.glazing, columns=draft.glazing.rows, rows=draft.glazing.columns)
    # a casement turned by 90 degrees: its left hinges become the top hinges
    hung = _Hung(replace(draft, glazing=glazing), swing, draft.height, draft.width, False, falls=True)
    return ag.weld(body, hung.body().rotate(ag.Y, math.pi / 2.0))


def _seen(section: Section, *, inward: bool) -> ag.Scalar:
    """Return the visible width of the lock stile, with the lever in its middle [m]."""
    return REBATE + section.sash + (0.0 if inward else STOP)


@dataclass(frozen=True)
class _Hung:
    """A sash in an opening about the origin, with hinges at its left."""

    draft: Draft  # common data of the window
    swing: Swing  # motion of the sash and its lever
    width: ag.Scalar  # width of the opening [m]
    height: ag.Scalar  # height of the opening [m]
    inward: bool  # whether the lever is in front, on the opening side, or at the back
    falls: bool = False  # whether the hinges become horizontal

    def body(self) -> ag.Body:
        """Make the parts of the frame with the sash."""
        draft, swing, section, metal = self.draft, self.swing, self.draft.section, self.draft.metal
        pin = Pin.beside(self.width, section)
        tall = ag.require(self.height, self.height > (_HINGED if swing.solid else _LOCKED), _TOO_SHORT)
        low, high = -tall / 2.0 + 0.11, tall / 2.0 - 0.11
        on_frame, on_sash = barrel_hinges(
            pin,
            [low, high],
            tall=0.066,
            to=-self.width / 2.0 - LIP,
            face=0.0,
            finish=metal,
            solid=swing.solid,
        )
        face = -SEALED - section.lip if self.inward else section.depth
        # in the middle of the free part of the lock stile
        at = (self.width / 2.0 - _seen(section, inward=self.inward) / 2.0, face, 0.0)
        rose, lever = window_lever(
            at, side=-1 if self.inward else 1, style=swing.lever, length=swing.length, finish=metal
        )
        turn = lever_turn("handle_turn", pivot=at, limit=swing.turn, friction=draft.friction)
        lock = cam_lock(
            turn, pin, self.width, 0.0, ag.min_(0.30, tall / 2.0 - 0.09), name="bolt_slide", finish=metal
        )
        sash = lipped_sash(self.width, tall, section, draft.glazing)
        sash = ag.weld(sash, on_sash, rose).attach(lever, turn).attach(lock.rod, lock.slide)
        hinge = self._falling(sash, pin, turn, lock) if self.falls else self._upright(pin, turn, lock)
        thick = section.depth + SEALED + section.lip / 2.0  # behind the axis
        body = ag.weld(on_frame, lock.keeps).attach(sash, hinge)
        if not self.inward:
            body = self._lever_passes(body, at[0], tall)
        body = body.require(lock.nears < lock.room - 0.0001, _LOCK_MEETS)
        return body.require(
            thick * thick / (2.0 * self.width) < REBATE - 0.001,
            "the far edge of the sash would strike the frame: raise width",
        )

    def _lever_passes(self, body: ag.Body, x: ag.Scalar, tall: ag.Scalar) -> ag.Body:
        """Require that the lever at `x`, behind a sash of some height, clears the opening of the frame."""
        swing, section = self.swing, self.draft.section
        pin = Pin.beside(self.width, section)
        stop = STOP if swing.solid else 0.0
        body = body.require(swing.length <= tall / 2.0 - stop, _LEVER_LONG)
        # width and height of the lever's end or neck
        wide, out = (0.0111, 0.0420) if swing.lever == "tapered" else (0.0088, 0.0445)
        edge, behind = x + wide, section.depth + out
        nears = swings_out(edge - pin.x, behind - pin.y, behind - section.stop)
        return body.require(nears < self.width / 2.0 - stop - edge - 0.0002, _LEVER_NEAR)

    def _upright(self, pin: Pin, turn: ag.Joint, lock: CamLock) -> ag.Joint:
        swing = self.swing
        return self._joint(pin, turn, lock, swing.limit, swing.friction)

    def _falling(self, sash: ag.Body, pin: Pin, turn: ag.Joint, lock: CamLock) -> ag.Joint:
        """Make a horizontal hinge: a friction stay holds the sash, or it falls shut."""
        swing, weight = self.swing, _GRAVITY * sash.mass()
        arm = sash.center_of_mass().x - pin.x
        holds = swing.stay == "friction"
        # a hand at the lever lifts the weight against the friction of the stay
        most = _LIFTS * (self.width - 0.05) / (weight * arm * (1.0 + _HOLDS if holds else 1.0))
        sine = ag.min_(most, 0.97)
        limit = ag.min_(swing.limit, ag.atan2(sine, ag.sqrt(1.0 - sine * sine)))
        friction = _HOLDS * weight * arm * ag.sin(limit) if holds else 0.15
        return self._joint(pin, turn, lock, limit, friction)

    def _joint(
        self, pin: Pin, turn: ag.Joint, lock: CamLock, limit: ag.Scalar, friction: ag.Scalar
    ) -> ag.Joint:
        return ag.Revolute(
            "pane_hinge",
            axis=-ag.Z,
            pivot=(pin.x, pin.y, 0.0),
            limits=(0.0, limit),
            friction=friction,
            damping=self.swing.damping,
            effort=100.0,
            velocity=6.0,
            needs=(turn > RELEASED).until(lock.passed),
        )
