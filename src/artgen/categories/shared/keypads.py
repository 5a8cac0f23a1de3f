"""Keys of hand-held devices and keyboards: caps on springs in a hollow of a face that looks up, with print.

A finger is 18 mm thick: the distance between the middles of neighboring keys of equal height must be at least
9 mm plus half of a cap.
"""

import functools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass

import artgen as ag
from artgen import details, feel
from artgen.nodes.fitting import FIT, Fitting

COVER = 0.0006
"""Thickness of a cover plate around keys [m]."""

LETTERS: tuple[tuple[tuple[str, float], ...], ...] = (
    (*((key, 1.0) for key in "`1234567890-="), ("bksp", 2.0)),
    (("tab", 1.5), *((key, 1.0) for key in "QWERTYUIOP[]"), ("\\", 1.5)),
    (("caps", 1.75), *((key, 1.0) for key in "ASDFGHJKL;'"), ("enter", 2.25)),
    (("shift", 2.25), *((key, 1.0) for key in "ZXCVBNM,./"), ("shift", 2.75)),
)
"""Legend and width in pitches of each key in the rows of letters of a keyboard, from the back."""

_FILM = 0.0001  # height of print above a cap [m]


@dataclass(frozen=True)
class Stroke:
    """Travel and forces of a key."""

    travel: ag.Scalar = 0.0010  # [m]
    preload: ag.Scalar = 0.25  # [N]
    force: ag.Scalar = 0.6  # at the end of the travel [N]
    friction: ag.Scalar = 0.02  # [N]
    effort: ag.Scalar = 3.0  # [N]


def key(
    cap: ag.Solid,
    finish: ag.Material,
    stroke: Stroke,
    *,
    top: ag.Scalar,
    sign: ag.Profile | None = None,
    ink: ag.Material | None = None,
    at: ag.VectorLike | None = None,
    when: ag.Condition | None = None,
    name: str = "key",
    label: str = "key",
) -> Fitting:
    """Make a key that is pressed down, with its print at the height `top` about the origin.

    Args:
        cap: The cap, released.
        finish: Material of the cap.
        stroke: Travel and forces.
        top: Height of the print [m].
        sign: Print about the origin.
        ink: Material of the print.
        at: Place at which a finger pushes; by default the middle [m].
        when: Condition under which a finger reaches the key.
        name: Name of the link; the joint is `{name}_press`.
        label: Label of the cap.
    """
    push = ag.push_on(cap, direction=-ag.Z, at=at)
    made = ag.part(cap, label, finish, name=name, push=push, when=when)
    if sign is not None and ink is not None:
        made = ag.weld(made, details.printed(sign, (0, 0, top), material=ink, facing=ag.Z, proud=_FILM))
    press = ag.Prismatic(
        f"{name}_press",
        axis=-ag.Z,
        limits=(0, stroke.travel),
        spring=ag.Spring(preload=stroke.preload, force=stroke.force),
        feel=feel.SWITCH,
        friction=stroke.friction,
        effort=stroke.effort,
    )
    return Fitting.moving(made, press)


@dataclass(frozen=True)
class Cap:
    """A key of a pad, with its place and the outline of its cap about the origin."""

    at: tuple[ag.Scalar, ag.Scalar]  # [m]
    outline: ag.Profile
    finish: ag.Material
    sign: ag.Profile | None = None
    ink: ag.Material | None = None
    proud: ag.Scalar = 0.0015  # height above the face [m]
    push: tuple[ag.Scalar, ag.Scalar] = (0.0, 0.0)  # where a finger pushes, from its place [m]
    sign_at: tuple[ag.Scalar, ag.Scalar] = (0.0, 0.0)  # middle of the print, from its place [m]
    bevel: float = 0.0005  # [m]


@dataclass(frozen=True)
class Pad:
    """A field of keys in one hollow of a face, below a cover plate with holes that is only seen."""

    room: ag.Region  # hollow below the face; its top is the face
    stroke: Stroke
    cover: ag.Material
    corner: float = 0.002  # of the cover plate [m]
    when: ag.Condition | None = None

    def install(self, host: ag.Body, caps: Sequence[Cap], first: int = 0) -> ag.Body:
        """Cut the hollow and put the keys into it as `key_0`, ..., or from another number."""
        room, face = self.room, self.room.z.high
        sheet = room.grow(0.0003 + 0.3 * self.corner, z=0).plan(radius=self.corner)
        holes = [cap.outline.offset(FIT.sliding).at(*cap.at) for cap in caps]
        sheet -= functools.reduce(operator.or_, holes)
        plate = ag.extrude(sheet, COVER).at(z=face + 0.0002 - COVER / 2)
        body = ag.weld(host.cut(room.grow(top=0.01).box()), ag.detail(plate, "panel", self.cover))
        for number, cap in enumerate(caps, first):
            high = cap.proud + 0.0014
            solid = ag.extrude(cap.outline, high, bevel=cap.bevel).at(z=cap.proud - high / 2)
            made = key(
                solid, cap.finish, self.stroke, top=cap.proud, ink=cap.ink, when=self.when,
                sign=None if cap.sign is None else cap.sign.at(*cap.sign_at), at=(*cap.push, 0),
            )  # fmt: skip
            body = body.install(made.suffixed(f"_{number}"), at=(*cap.at, face))
        return body


def sector(inner: ag.Scalar, outer: ag.Scalar, turn: float, gap: float = 0.0006) -> ag.Profile:
    """Make a quarter of a ring about the origin, to the right before it is turned [rad]."""
    far = 1.5 * outer
    wedge = ag.polygon([(gap, 0), (far + gap, far), (far + gap, -far)])
    return (ag.ring(outer, inner) & wedge).rotate(turn)


def ring_places(radius: ag.Scalar) -> list[tuple[float, tuple[ag.Scalar, ag.Scalar]]]:
    """Return the angles of the four keys of a ring, and their places at a radius [rad, m]."""
    quarter = math.pi / 2
    ways = ((1, 0), (0, 1), (-1, 0), (0, -1))
    return [(quarter * number, (x * radius, y * radius)) for number, (x, y) in enumerate(ways)]


def word(text: str, height: ag.Scalar) -> ag.Profile:
    """Make a short legend of few vertices."""
    return details.lettering((text,), height, fineness="coarse")
