"""Printing on boxes: marks, addresses, labels, tape and patterns."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.box.finish import GOLD, contrast, ink
from artgen.categories.shared import recycling

_FILM = 0.00012  # height of print and labels above the surface [m]

TAPE = ag.material("polypropylene").with_(
    name="packing_tape", base_color=(0.34, 0.19, 0.075), specular_roughness=0.22, coat_weight=0.4
)
"""Brown packing tape."""

PAPER = ag.colored("abs", "white").with_(
    name="label_paper", texture="", specular_roughness=0.6, density=800.0
)
"""Paper of stickers."""


def pull_tab(tall: float = 0.021) -> ag.Solid:
    """Make the upright folded end of a tape at the edge of a flap, for a hand to pull."""
    return ag.Region.between((-0.014, -0.0007, -0.0006), (0.014, 0.0007, tall)).box(bevel=0.0005)


def arrows(size: ag.Scalar) -> ag.Profile:
    """Make the sign "this side up": two arrows on a bar."""
    arrow = ag.polygon(
        [(-0.07, -0.30), (0.07, -0.30), (0.07, 0.16), (0.19, 0.16), (0.0, 0.48), (-0.19, 0.16), (-0.07, 0.16)]
    )
    bar = ag.rectangle(0.92, 0.075).at(0.0, -0.44)
    return (arrow.at(-0.25) | arrow.at(0.25) | bar).scale(size)


def fragile(size: ag.Scalar) -> ag.Profile:
    """Make the sign "fragile": a glass with a crack."""
    bowl = ag.polygon(
        [(-0.26, 0.48), (0.26, 0.48), (0.24, 0.12), (0.13, -0.04),
         (0.045, -0.09), (-0.045, -0.09), (-0.13, -0.04), (-0.24, 0.12)]
    )  # fmt: skip
    crack = ag.polygon(
        [(0.05, 0.49), (0.12, 0.49), (0.05, 0.30), (0.13, 0.27), (-0.02, 0.08), (0.03, 0.24), (-0.05, 0.27)]
    )
    stem = ag.rectangle(0.075, 0.36).at(0.0, -0.24)
    foot = ag.rectangle(0.42, 0.07).at(0.0, -0.445)
    return ((bowl - crack) | stem | foot).scale(size)


def umbrella(size: ag.Scalar) -> ag.Profile:
    """Make the sign "keep dry": an umbrella."""
    dome = ag.circle(0.46) & ag.rectangle(1.0, 0.5).at(0.0, 0.25)
    scallops = [ag.circle(0.155).at(x, 0.0) for x in (-0.307, 0.0, 0.307)]
    for each in scallops:
        dome = dome - each
    stick = ag.rectangle(0.05, 0.56).at(0.0, -0.12)
    hook = (ag.circle(0.11) - ag.circle(0.06)) & ag.rectangle(0.3, 0.12).at(0.0, -0.06)
    return (dome | stick | hook.at(0.085, -0.38)).at(0.0, 0.02).scale(size)


def barcode(width: ag.Scalar, height: ag.Scalar, seed: int) -> ag.Profile:
    """Make the bars of a barcode; the digits of a number give widths and gaps."""
    bars: ag.Profile | None = None
    place, state = 0.0, seed * 2654435761 % 2**32
    while place < 0.97:
        state = (1103515245 * state + 12345) % 2**31
        wide = 0.012 * (1 + state // 65536 % 3)
        bar = ag.rectangle(wide, 1.0).at(place + wide / 2.0 - 0.5, 0.0)
        bars = bar if bars is None else bars | bar
        place += wide + 0.012 * (1 + state // 2**24 % 3)
    assert bars is not None
    return bars.scale(width, height)


@dataclass(frozen=True)
class Ink:
    """A printer with one ink on one face."""

    material: ag.Material  # the ink
    facing: ag.VectorLike = (0.0, -1.0, 0.0)  # direction out of the face
    # upward direction for the reader; None for up, or for the back on a top face
    up: ag.VectorLike | None = None

    def put(self, profile: ag.Profile, at: ag.VectorLike) -> ag.Body:
        """Print a profile at a point of the face."""
        return details.printed(
            profile, at, material=self.material, facing=self.facing, up=self.up, proud=_FILM
        )


def handling(signs: tuple[str, ...], size: ag.Scalar) -> ag.Profile:
    """Place handling signs in a row about the origin."""
    made = {"up": arrows, "fragile": fragile, "dry": umbrella, "recycle": recycling}
    row: ag.Profile | None = None
    for number, sign in enumerate(signs):
        frame = ag.rectangle(1.24 * size, 1.24 * size) - ag.rectangle(1.18 * size, 1.18 * size)
        each = (made[sign](size) | frame).at(1.42 * size * (number - (len(signs) - 1) / 2.0))
        row = each if row is None else row | each
    assert row is not None
    return row


def address_label(at: ag.VectorLike, *, facing: ag.VectorLike, size: ag.Scalar, number: int) -> list[ag.Body]:
    """Make the label of a parcel service on a face: lines of an address above a barcode."""
    black = ag.colored("abs", "graphite").with_(name="label_ink", texture="")
    paper = details.printed(
        ag.rectangle(size, 0.66 * size, radius=0.002),
        at,
        material=PAPER,
        facing=facing,
        label="label",
        proud=_FILM,
    )
    rows = [
        ag.rectangle(share * size, 0.022 * size).at((share - 0.86) * size / 2.0, y * size)
        for share, y in ((0.30, 0.26), (0.42, 0.20), (0.55, 0.08), (0.48, 0.02), (0.36, -0.04))
    ]
    code = barcode(0.84 * size, 0.17 * size, number).at(0.0, -0.20 * size)
    ink = rows[0] | rows[1] | rows[2] | rows[3] | rows[4] | code
    return [
        paper,
        details.printed(ink, at, material=black, facing=facing, label="label", proud=_FILM + 0.00008),
    ]


def seam(start: ag.VectorLike, end: ag.VectorLike) -> ag.Body:
    """Make the dark line between two sheets."""
    dark = ag.material("cardboard_edge").with_(name="seam_shade", base_color=(0.06, 0.04, 0.025), texture="")
    return ag.detail(ag.Region.between(start, end).box(), "box", dark)


Signs = Literal["none", "up", "pair", "full"]
"""Handling signs of a box."""

_ROWS: dict[str, tuple[str, ...]] = {
    "up": ("up",),
    "pair": ("fragile", "up"),
    "full": ("fragile", "up", "dry", "recycle"),
}
_BACK = (0.0, 1.0, 0.0)
_LEFT, _RIGHT = (-1.0, 0.0, 0.0), (1.0, 0.0, 0.0)
_FRONT = (0.0, -1.0, 0.0)


@dataclass(frozen=True)
class Look:
    """Prints of a box."""

    maker: str  # brand name
    model: int  # model number
    # sign next to the brand name
    emblem: Literal["leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"]
    tint: str  # color of the ink on light board
    signs: Signs  # handling signs
    label: bool  # whether there is a sticker with an address or the contents

    def ink(self, finish: ag.Material) -> ag.Material:
        """Return the ink with good contrast on a finish."""
        light = sum(finish.base_color) / 3.0 > 0.2
        return ink(self.tint) if light else contrast(finish)

    def mark(
        self, width: ag.Scalar, height: ag.Scalar, *, sign: bool = True, tracking: float = 0.2
    ) -> ag.Profile:
        """Make the word mark, within a width and a height [m]."""
        name = self.maker.upper()
        units = details.lettering_width(name, tracking) + (2.3 if sign else 0.0)
        size = ag.min_(height, width / units)
        return details.logo(self.maker, size, sign=self.emblem if sign else "none", tracking=tracking)


@dataclass(frozen=True)
class _Face:
    """A wall to print on."""

    facing: tuple[float, float, float]  # direction out of the wall
    wide: ag.Scalar  # width of the wall [m]
    out: ag.Scalar  # distance from the middle of the box [m]
    low: ag.Scalar  # height of the start of the free part [m]
    tall: ag.Scalar  # height of the free part [m]

    def at(self, share: float, aside: ag.Scalar = 0.0) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return the point at a share of the height, shifted to the reader's right [m]."""
        x, y, _ = self.facing
        return (self.out * x - aside * y, self.out * y + aside * x, self.low + share * self.tall)


def shipping_print(
    look: Look,
    width: ag.Scalar,
    depth: ag.Scalar,
    *,
    low: ag.Scalar,
    high: ag.Scalar,
    finish: ag.Material,
    sides: bool = True,
) -> list[ag.Body]:
    """Print the walls of a shipping box."""
    tall, color, made = high - low, look.ink(finish), []
    row = _ROWS.get(look.signs, ())
    for facing in (_FRONT, _BACK):
        face, printer = _Face(facing, width, depth / 2.0, low, tall), Ink(color, facing)
        made.append(printer.put(look.mark(0.74 * width, 0.12 * tall), face.at(0.70 if row else 0.60)))
        made += [Ink(color, facing).put(each, face.at(0.30)) for each in _lower(look, face, row)]
    for facing in (_LEFT, _RIGHT) if sides else ():
        face, printer = _Face(facing, depth, width / 2.0, low, tall), Ink(color, facing)
        if look.signs == "full":
            size = ag.min_(ag.min_(0.085, 0.24 * tall), 0.80 * depth / 2.84)
            made.append(printer.put(handling(row[:2], size), face.at(0.34)))
        code = barcode(ag.min_(0.11, 0.44 * depth), ag.min_(0.026, 0.09 * tall), look.model)
        made.append(printer.put(code, face.at(0.09)))
        number = f"NO. {look.model}-{look.model * 7 % 97:02d}"
        size = ag.max_(ag.min_(ag.min_(0.009, 0.035 * depth), 0.08 * tall), 0.0025)
        text = details.lettering((number,), size, fineness="coarse")
        made.append(printer.put(text, face.at(0.175)))
    return made


def _lower(look: Look, face: _Face, row: tuple[str, ...]) -> list[ag.Profile]:
    """Return the print below the name: handling signs, lines to write on, or bands."""
    wide, tall = face.wide, face.tall
    if row:
        return [handling(row, ag.min_(ag.min_(0.085, 0.24 * tall), 0.80 * wide / (1.42 * len(row))))]
    match look.model % 3:
        case 0:  # for moving boxes
            size = ag.min_(ag.min_(0.020, 0.07 * tall), 0.030 * wide)
            words = details.lettering(
                ("CONTENTS", "ROOM"), size, leading=2.6, align="left", fineness="coarse"
            )
            left = -0.36 * wide
            lines = [
                ag.rectangle(0.50 * wide, 0.0022).at(0.11 * wide, y * size - 0.0011) for y in (0.8, -1.8)
            ]
            return [words.at(left) | lines[0] | lines[1]]
        case 1:
            band = ag.rectangle(0.985 * wide, 0.035 * tall)
            return [band.at(0.0, 0.05 * tall) | ag.rectangle(0.985 * wide, 0.012 * tall)]
        case _:
            return []


def side_label(
    look: Look, width: ag.Scalar, depth: ag.Scalar, *, height: ag.Scalar, tall: ag.Scalar
) -> list[ag.Body]:
    """Make a label on the front."""
    size = ag.min_(ag.min_(0.105, 1.2 * tall), 0.5 * width)
    return address_label((-0.24 * width, -depth / 2.0, height), facing=_FRONT, size=size, number=look.model)


def pizza_print(look: Look, width: ag.Scalar, depth: ag.Scalar) -> list[ag.Body]:
    """Print the lid of a pizza box, in the frame of its sheet, with the crease at the back."""
    red, green = ink("red"), ink("forest")
    one, other = ((red, green), (green, red), (red, red), (ink("graphite"), ink("graphite")))[look.model % 4]
    up = (0.0, -1.0, 0.0)  # up for a reader at the free edge of the sheet
    first, second = Ink(one, ag.Z, up), Ink(other, ag.Z, up)
    name = second.put(look.mark(0.5 * depth, 0.034 * depth), (0.0, 0.90 * depth, 0.0))
    pattern = look.model // 4 % 3
    word = details.lettering(("PIZZA",), (0.085, 0.15, 0.11)[pattern] * depth, tracking=0.22)
    if pattern == 0:
        rings = ag.ring(0.335 * depth, 0.318 * depth) | ag.ring(0.305 * depth, 0.300 * depth)
        return [
            second.put(rings, (0.0, 0.47 * depth, 0.0)),
            first.put(details.icon("pizza", 0.30 * depth), (0.0, 0.40 * depth, 0.0)),
            first.put(word, (0.0, 0.63 * depth, 0.0)),
            name,
        ]
    if pattern == 1:
        return [
            first.put(word, (0.0, 0.50 * depth, 0.0)),
            second.put(
                details.lettering(("FRESH  HOT  TASTY",), 0.034 * depth, tracking=0.3),
                (0.0, 0.66 * depth, 0.0),
            ),
            *(second.put(_checks(width), (0.0, share * depth, 0.0)) for share in (0.13, 0.80)),
            name,
        ]
    return [
        first.put(details.icon("pizza", 0.62 * depth), (0.0, 0.42 * depth, 0.0)),
        second.put(details.icon("wheat", 0.12 * depth), (-0.36 * width, 0.20 * depth, 0.0)),
        second.put(details.icon("flame", 0.12 * depth), (0.36 * width, 0.20 * depth, 0.0)),
        name,
    ]


def pizza_front(look: Look, width: ag.Scalar, depth: ag.Scalar, height: ag.Scalar) -> ag.Body:
    """Print the front wall of a pizza box."""
    words = ("FRESH AND HOT", "BUON APPETITO", "HAND MADE", "ENJOY YOUR MEAL")[look.model % 4]
    size = ag.min_(0.34 * height, 0.98 * width / details.lettering_width(words, 0.25))
    text = details.lettering((words,), size, tracking=0.25)
    return Ink(ink("red" if look.model % 3 else "forest")).put(text, (0.0, -depth / 2.0, 0.5 * height))


def _checks(width: ag.Scalar) -> ag.Profile:
    """Make two rows of squares across a lid, as on a tablecloth."""
    side = 0.96 * width / 24.0
    squares: ag.Profile | None = None
    for number in range(24):
        square = ag.rectangle(0.98 * side, 0.98 * side).at((number - 11.5) * side, (number % 2 - 0.5) * side)
        squares = square if squares is None else squares | square
    assert squares is not None
    return squares


def mailer_print(
    look: Look, width: ag.Scalar, depth: ag.Scalar, *, finish: ag.Material, inner: ag.Material, thick: float
) -> list[ag.Body]:
    """Print the outside and the inside of a mailer lid, in the frame of its sheet."""
    up = (0.0, -1.0, 0.0)
    outer = Ink(look.ink(finish), ag.Z, up)
    made = [outer.put(look.mark(0.62 * width, 0.085 * depth), (0.0, 0.5 * depth, 0.0))]
    pattern = look.model % 4
    if pattern == 0:
        frame = ag.rectangle(0.90 * width, 0.86 * depth) - ag.rectangle(
            0.885 * width, 0.86 * depth - 0.015 * width
        )
        made.append(outer.put(frame, (0.0, 0.5 * depth, 0.0)))
    if pattern == 1:
        made.append(outer.put(details.emblem(look.emblem, 0.17 * depth), (0.0, 0.27 * depth, 0.0)))
    if pattern == 2:
        stripes = ag.rectangle(0.996 * width, 0.012 * depth).at(0.0, 0.035 * depth) | ag.rectangle(
            0.996 * width, 0.026 * depth
        )
        made.append(outer.put(stripes, (0.0, 0.80 * depth, 0.0)))
    if pattern == 3:
        dots = ag.circle(0.011 * depth)
        field = dots.at(-0.40 * width, 0.0)
        for number in range(1, 9):
            field = field | dots.at((0.1 * number - 0.40) * width, 0.0)
        made += [outer.put(field, (0.0, share * depth, 0.0)) for share in (0.22, 0.78)]
    # for a reader of the open lid, up is the free edge
    inside = Ink(look.ink(inner), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
    words = ("HELLO!", "THANK YOU", "ENJOY", "MADE FOR YOU")[look.model % 4]
    made.append(
        inside.put(
            details.lettering((words,), ag.min_(0.10 * depth, 0.07 * width), tracking=0.15),
            (0.0, 0.52 * depth, -thick),
        )
    )
    return made


def wine_print(
    look: Look, width: ag.Scalar, depth: ag.Scalar, height: ag.Scalar, *, bottles: int, finish: ag.Material
) -> list[ag.Body]:
    """Print a wine box at the front and at the back."""
    color = look.ink(finish)
    foil = GOLD if sum(finish.base_color) / 3.0 < 0.1 else color
    made = []
    for facing, side in ((_FRONT, -1.0), (_BACK, 1.0)):
        y = side * depth / 2.0
        printer = Ink(foil, facing)
        icon = details.icon("glass" if look.model % 2 else "bottle", ag.min_(0.24 * height, 0.42 * width))
        made.append(printer.put(icon, (0.0, y, 0.70 * height)))
        made.append(
            printer.put(
                look.mark(0.78 * width, 0.050 * height, sign=False, tracking=0.3), (0.0, y, 0.485 * height)
            )
        )
        words = details.lettering(
            (f"{bottles} x 75 CL",), ag.min_(0.024 * height, 0.09 * width), tracking=0.2
        )
        made.append(printer.put(words, (0.0, y, 0.385 * height)))
        lines = ag.rectangle(0.60 * width, 0.0016).at(0.0, 0.0035) | ag.rectangle(0.60 * width, 0.0008)
        made.append(printer.put(lines, (0.0, y, 0.435 * height)))
        if look.signs == "full":
            signs = handling(("fragile", "up"), ag.min_(0.045, 0.22 * width))
            made.append(Ink(color, facing).put(signs, (0.0, y, 0.20 * height)))
    return made


def name_on_lid(look: Look, width: ag.Scalar, depth: ag.Scalar) -> ag.Profile:
    """Make the small stamped name on a gift box."""
    return look.mark(0.42 * width, 0.045 * depth, sign=False, tracking=0.35)


def vents(radius: ag.Scalar) -> ag.Profile:
    """Make an octagonal vent hole."""
    return ag.regular_polygon(8, radius)
