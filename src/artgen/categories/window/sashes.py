"""Sashes with their glazing, and shutters."""

from dataclasses import dataclass
from typing import Literal, NamedTuple

import artgen as ag
from artgen.categories.shared.fronts import Opening, panes_in, slats_in
from artgen.categories.window.hardware import BARREL, Pin, barrel_hinges, bow_pull
from artgen.categories.window.plan import LIP, REBATE, SEALED, SEAM, Rect, Section, ring_of

PANE = 0.012
"""Modeled thickness of insulating glass, with the mass of its panes [m]."""

_SHEET = 0.004  # thickness of a sheet of glass [m]


@dataclass(frozen=True)
class Glazing:
    """Glass and bars of sashes."""

    glass: ag.Material  # material of the glass
    sheets: int  # number of sheets: 2 for insulating glass, 1 for a single sheet
    columns: int  # number of vertical bars on the glass
    rows: int  # number of horizontal bars on the glass
    finish: ag.Material  # finish of the ring, the beads and the bars

    def within(self, width: ag.Scalar, height: ag.Scalar, thickness: ag.Scalar) -> list[ag.Body]:
        """Fill a ring about the origin, with its middle plane at y = 0."""
        heavy = self.glass.density * _SHEET * self.sheets / PANE
        glass = self.glass.with_(name=f"{self.glass.name}_{self.sheets}_sheets", density=heavy)
        opening = Opening(width, height, [(0.0, 0.0, 0.0)], 1, self.finish, "pane")
        return panes_in(opening, thickness, self.columns + 1, self.rows + 1, glass, pane=PANE)


def lipped_sash(
    width: ag.Scalar, height: ag.Scalar, section: Section, glazing: Glazing, *, push: ag.Frame | None = None
) -> ag.Body:
    """Make a sash that closes an opening about the origin: its lip is in front of the frame at y = 0."""
    face, front = section.sash, SEALED + section.lip
    over = REBATE + LIP
    wide, high = width - 2.0 * REBATE, height - 2.0 * REBATE
    chamfer = 0.006
    outline = [
        (0.0, -section.depth),
        (face, -section.depth),
        (face, front - chamfer),
        (face - chamfer, front),
        (-over, front),
        (-over, SEALED),
        (0.0, SEALED),
    ]
    wide, high = width - 2.0 * REBATE, height - 2.0 * REBATE
    filled = [Rect(-over, face - chamfer, SEALED, front), Rect(0.0, face, -section.depth, front - chamfer)]
    thick = section.depth + front
    middle = (section.depth - front) / 2.0
    ring = ring_of(
        ag.polygon(outline, radius=section.eased),
        filled,
        wide,
        high,
        "pane",
        glazing.finish,
        eased=section.eased,
        push=push,
    )
    panes = glazing.within(wide - 2.0 * face, high - 2.0 * face, thick)
    return ag.weld(ring, *(each.at(0.0, middle, 0.0) for each in panes))


def plain_sash(
    width: ag.Scalar, height: ag.Scalar, section: Section, glazing: Glazing, *, push: ag.Frame | None = None
) -> ag.Body:
    """Make a sash that slides in its track, about the origin."""
    face, half = slide_face(section), section.slide / 2.0
    ring = ring_of(
        ag.rectangle(face, section.slide, radius=section.eased).at(face / 2.0),
        [Rect(0.0, face, -half, half)],
        width,
        height,
        "pane",
        glazing.finish,
        eased=section.eased,
        push=push,
    )
    return ag.weld(ring, *glazing.within(width - 2.0 * face, height - 2.0 * face, section.slide))


def slide_face(section: Section) -> float:
    """Return the width of the stiles and rails of a sliding sash, which are slimmer than hinged ones [m]."""
    return 0.92 * section.sash


ShutterStyle = Literal["none", "louvred", "boarded"]

_THICK = 0.032  # thickness of a leaf [m]
_OFF = 0.012  # gap from a leaf to the frame behind it [m]
_STILE, _RAIL = 0.048, 0.062  # widths of the boards [m]
_MEETING = 0.004  # gap between the widest points of two leaves [m]
_PIN_IN = 0.004  # distance from the face of a leaf to its pin [m]
_LEDGE = 0.016  # thickness of the ledges that hold boards together [m]


def _edge(reach: ag.Scalar) -> ag.Scalar:
    """Return the gap to the middle that lets a leaf's back corner swing past the other leaf [m]."""
    behind, free = _THICK - _PIN_IN, reach - 0.0003
    return ag.max_(_MEETING / 2.0, reach - ag.sqrt(free * free - behind * behind))


class Shutters(NamedTuple):
    """Style and motion of a pair of shutters."""

    style: ShutterStyle  # louvers, or boards on ledges
    finish: ag.Material  # paint of the shutters
    metal: ag.Material  # metal of the hinges and pulls
    slats: int  # number of louvers in each half of a leaf, or twice the number of boards
    swing: ag.Scalar  # opening angle of the shutters [rad]
    friction: ag.Scalar  # friction of the hinges of a leaf [N m]
    solid: bool  # whether the hinges have mass and collide, or are visual only

    def hung(
        self, body: ag.Body, *, front: ag.Scalar, width: ag.Scalar, low: ag.Scalar, high: ag.Scalar
    ) -> ag.Body:
        """Attach a pair in front of a frame."""
        pin = Pin(BARREL - width / 2.0, front - _OFF - _THICK + _PIN_IN)
        start = pin.x + BARREL + 0.002
        wide, tall = -_edge(-pin.x) - start, high - low
        levels = [low + 0.16 * tall, low + 0.84 * tall]
        on_frame, on_leaf = barrel_hinges(
            pin, levels, tall=0.075, to=start, face=front, finish=self.metal, solid=self.solid
        )
        middle = (start + wide / 2.0, front - _OFF - _THICK / 2.0, (low + high) / 2.0)
        pull = bow_pull(length=0.12, girth=0.0048, finish=self.metal, name="handle_front")
        boards = self._louvred(wide, tall) if self.style == "louvred" else self._boarded(wide, tall)
        leaf = ag.weld(*boards, pull.at((wide - _STILE) / 2.0, -_THICK / 2.0, 0.0)).at(middle)
        leaf = ag.weld(leaf, on_leaf)
        for side, name in ((1, "left"), (-1, "right")):
            hinge = self._hinge(f"shutter_hinge_{name}", pin, side)
            turned = leaf if side > 0 else leaf.mirror(ag.X)
            body = ag.weld(body, on_frame if side > 0 else on_frame.mirror(ag.X))
            body = body.attach(turned.suffixed(f"_{name}"), hinge)
        return body

    def _hinge(self, name: str, pin: Pin, side: int) -> ag.Joint:
        return ag.Revolute(
            name,
            axis=-side * ag.Z,
            pivot=(side * pin.x, pin.y, 0.0),
            limits=(0.0, self.swing),
            friction=self.friction,
            damping=0.4,
            effort=60.0,
            velocity=6.0,
        )

    def _louvred(self, wide: ag.Scalar, tall: ag.Scalar) -> list[ag.Body]:
        """Make stiles, three rails and two fields of louvers, about the origin."""
        inner = wide - 2.0 * _STILE
        free = (tall - 3.0 * _RAIL) / 2.0
        stile = ag.box(_STILE, _THICK, tall, bevel=0.0025)
        rail = ag.box(inner - SEAM, _THICK - 0.0004, _RAIL, bevel=0.0015)
        side, up = (wide - _STILE) / 2.0, (tall - _RAIL) / 2.0
        bodies = [
            ag.part(stile.at(-side, 0.0, 0.0), "shutter", self.finish, name="shutter"),
            ag.part(stile.at(side, 0.0, 0.0), "shutter", self.finish),
            *(ag.part(rail.at(0.0, 0.0, z), "shutter", self.finish) for z in (-up, 0.0, up)),
        ]
        for z in (-(free + _RAIL) / 2.0, (free + _RAIL) / 2.0):
            opening = Opening(inner + 0.002, free, [(0.0, 0.0, z)], 1, self.finish, "shutter")
            bodies += slats_in(opening, _THICK, self.slats, joined=True)
        return bodies

    def _boarded(self, wide: ag.Scalar, tall: ag.Scalar) -> list[ag.Body]:
        """Make vertical boards with a V at every joint, on two ledges behind them, about the origin."""
        boards = max(3, self.slats // 3)
        each = wide / boards
        thin = _THICK - _LEDGE
        board = ag.box(each, thin, tall, bevel=0.003)
        ledge = ag.box(wide - 0.030, _LEDGE + 0.0005, 0.085, bevel=0.003).at(
            0.0, (_THICK - _LEDGE) / 2.0, 0.0
        )
        bodies = [
            ag.part(
                board.at((index - (boards - 1) / 2.0) * each, (thin - _THICK) / 2.0, 0.0),
                "shutter",
                self.finish,
                name="shutter" if index == 0 else None,
            )
            for index in range(boards)
        ]
        ledges = ag.array(ledge, at=[(0.0, 0.0, -0.34 * tall), (0.0, 0.0, 0.34 * tall)])
        return [*bodies, ag.part(ag.union(ledges), "shutter", self.finish)]
