"""Printing on boxes: marks, signs, labels and patterns; and packing tape."""

import functools
import operator
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.box.finish import GOLD, LABEL_INK, PAPER, TAPE, ink
from artgen.categories.shared import recycling

_FILM = 0.00012  # height of print and labels above the surface [m]
Facing = tuple[float, float, float]
FRONT, BACK, LEFT, RIGHT = (0.0, -1.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (1.0, 0.0, 0.0)

TAPE_WIDE = 0.048
"""Width of packing tape, half of it on each flap after it is slit [m]."""


def pull_tab(
    name: str, *, label: str = "tape", material: ag.Material = TAPE, tall: float = 0.021, depth: float = 0.016
) -> ag.Body:
    """Make the upright folded end of a tape at the origin, along x, for a hand to pull."""
    tab = ag.Region((-0.014, 0.014), (-0.0007, 0.0007), (-0.0006, tall)).box(bevel=0.0005)
    hold = ag.grasp_on(tab, approach=-ag.Z, closing=ag.Y, depth=depth)
    return ag.part(tab, label, material, name=name, grasp=hold)


def tape_ends(span: ag.Region) -> ag.Body:
    """Make the ends of the tape on the side walls of a region."""
    strip = span.with_(y=(-TAPE_WIDE / 2, TAPE_WIDE / 2))
    ends = [strip.with_(x=(x - 0.00012, x + 0.00012)).box() for x in span.x]
    return ag.detail(ends, "tape", TAPE)


def put(
    profile: ag.Profile,
    at: ag.VectorLike,
    material: ag.Material,
    facing: ag.VectorLike = FRONT,
    up: ag.VectorLike | None = None,
) -> ag.Body:
    """Print a profile at a point of a face."""
    return details.printed(profile, at, material=material, facing=facing, up=up, proud=_FILM)


def _merged(profiles: Iterable[ag.Profile]) -> ag.Profile:
    return functools.reduce(operator.or_, profiles)


def _arrows() -> ag.Profile:
    """Make the sign "this side up": two arrows on a bar."""
    arrow = ag.polygon(
        [(-0.07, -0.30), (0.07, -0.30), (0.07, 0.16), (0.19, 0.16), (0.0, 0.48), (-0.19, 0.16), (-0.07, 0.16)]
    )
    return arrow.at(-0.25) | arrow.at(0.25) | ag.rectangle(0.92, 0.075).at(0.0, -0.44)


def _glass() -> ag.Profile:
    """Make the sign "fragile": a glass with a crack."""
    bowl = ag.polygon(
        [(-0.26, 0.48), (0.26, 0.48), (0.24, 0.12), (0.13, -0.04),
         (0.045, -0.09), (-0.045, -0.09), (-0.13, -0.04), (-0.24, 0.12)]
    )  # fmt: skip
    crack = ag.polygon(
        [(0.05, 0.49), (0.12, 0.49), (0.05, 0.30), (0.13, 0.27), (-0.02, 0.08), (0.03, 0.24), (-0.05, 0.27)]
    )
    stem, foot = ag.rectangle(0.075, 0.36).at(0.0, -0.24), ag.rectangle(0.42, 0.07).at(0.0, -0.445)
    return (bowl - crack) | stem | foot


def _umbrella() -> ag.Profile:
    """Make the sign "keep dry"."""
    dome = ag.circle(0.46) & ag.rectangle(1.0, 0.5).at(0.0, 0.25)
    for x in (-0.307, 0.0, 0.307):
        dome = dome - ag.circle(0.155).at(x)
    stick = ag.rectangle(0.05, 0.56).at(0.0, -0.12)
    hook = (ag.circle(0.11) - ag.circle(0.06)) & ag.rectangle(0.3, 0.12).at(0.0, -0.06)
    return (dome | stick | hook.at(0.085, -0.38)).at(0.0, 0.02)


def _signs(names: Sequence[str], size: ag.Scalar) -> ag.Profile:
    """Place handling signs in frames in a row about the origin."""
    frame = ag.rectangle(1.24, 1.24) - ag.rectangle(1.18, 1.18)
    made = {"up": _arrows(), "fragile": _glass(), "dry": _umbrella(), "recycle": recycling(1.0)}
    first = -0.71 * (len(names) - 1)
    row = ((made[name] | frame).at(first + 1.42 * number) for number, name in enumerate(names))
    return _merged(row).scale(size)


def _barcode(width: ag.Scalar, height: ag.Scalar, seed: int) -> ag.Profile:
    """Make the bars of a barcode; a number gives widths and gaps."""
    bars, place, state = [], 0.0, seed * 2654435761 % 2**32
    while place < 0.97:
        state = (1103515245 * state + 12345) % 2**31
        wide = 0.012 * (1 + state // 65536 % 3)
        bars.append(ag.rectangle(wide, 1.0).at(place + wide / 2 - 0.5))
        place += wide + 0.012 * (1 + state // 2**24 % 3)
    return _merged(bars).scale(width, height)


Signs = Literal["none", "up", "pair", "full"]
"""Handling signs of a box."""

_ROWS: dict[Signs, tuple[str, ...]] = {
    "none": (),
    "up": ("up",),
    "pair": ("fragile", "up"),
    "full": ("fragile", "up", "dry", "recycle"),
}
Emblem = Literal["leaf", "hexagon", "waves", "peak", "sun", "diamond", "quarters", "ring"]


@dataclass(frozen=True)
class Look:
    """Prints of a box."""

    maker: str  # brand name
    model: int  # model number, which also selects words and patterns
    emblem: Emblem  # sign next to the brand name
    tint: str  # color of the ink on light board
    signs: Signs  # handling signs
    label: bool  # whether there is a sticker with an address or the contents

    def ink(self, face: ag.Material) -> ag.Material:
        """Return the ink with good contrast on a face."""
        return ink(self.tint if sum(face.base_color) > 0.6 else "white")

    def mark(
        self, width: ag.Scalar, height: ag.Scalar, *, sign: bool = True, tracking: float = 0.2
    ) -> ag.Profile:
        """Make the word mark, within a width and a height [m]."""
        units = details.lettering_width(self.maker.upper(), tracking) + (2.3 if sign else 0.0)
        size = ag.min_(height, width / units)
        return details.logo(self.maker, size, sign=self.emblem if sign else "none", tracking=tracking)

    def stamp(self, case: ag.Region) -> ag.Profile:
        """Make the small stamped name on a gift box."""
        return self.mark(0.42 * case.x.size, 0.045 * case.y.size, sign=False, tracking=0.35)

    def address(self, at: ag.VectorLike, size: ag.Scalar, facing: ag.VectorLike = ag.Z) -> list[ag.Body]:
        """Make the label of a parcel service: lines of an address above a barcode; or none without label."""
        if not self.label:
            return []
        paper = ag.rectangle(size, 0.66 * size, radius=0.002)
        lines = [
            ag.rectangle(share * size, 0.022 * size).at((share - 0.86) * size / 2, y * size)
            for share, y in ((0.30, 0.26), (0.42, 0.20), (0.55, 0.08), (0.48, 0.02), (0.36, -0.04))
        ]
        code = _barcode(0.84 * size, 0.17 * size, self.model).at(0.0, -0.20 * size)
        layers = ((paper, PAPER, _FILM), (_merged([*lines, code]), LABEL_INK, _FILM + 0.00008))
        return [
            details.printed(profile, at, material=material, facing=facing, label="label", proud=proud)
            for profile, material, proud in layers
        ]


def _on_walls(
    panel: ag.Region, facings: Sequence[Facing], rows: Sequence[tuple[ag.Profile, float]], color: ag.Material
) -> list[ag.Body]:
    """Print profiles, each at a share of the height, on the walls that face some directions."""
    middles = [(facing, panel.anchor(x=facing[0], y=facing[1])) for facing in facings]
    return [
        put(profile, (x, y, panel.z.at(share)), color, facing)
        for facing, (x, y, _) in middles
        for profile, share in rows
    ]


def shipping(look: Look, panel: ag.Region, face: ag.Material, *, sides: bool = True) -> list[ag.Body]:
    """Print the free height of the walls of a shipping box."""
    (wide, deep, tall), row, color = panel.size, _ROWS[look.signs], look.ink(face)
    size = ag.min_(0.085, 0.24 * tall)
    ends = [(look.mark(0.74 * wide, 0.12 * tall), 0.70 if row else 0.60)]
    if row:
        ends.append((_signs(row, ag.min_(size, 0.80 * wide / (1.42 * len(row)))), 0.30))
    elif look.model % 3 == 0:  # lines to write on, for moving boxes
        high = ag.min_(ag.min_(0.020, 0.07 * tall), 0.030 * wide)
        words = details.lettering(("CONTENTS", "ROOM"), high, leading=2.6, align="left", fineness="coarse")
        line = ag.rectangle(0.50 * wide, 0.0022)
        lines = [line.at(0.11 * wide, y * high - 0.0011) for y in (0.8, -1.8)]
        ends.append((_merged([words.at(-0.36 * wide), *lines]), 0.30))
    elif look.model % 3 == 1:
        band = ag.rectangle(0.985 * wide, 0.035 * tall).at(0.0, 0.05 * tall)
        ends.append((band | ag.rectangle(0.985 * wide, 0.012 * tall), 0.30))
    made = _on_walls(panel, (FRONT, BACK), ends, color)
    if not sides:
        return made
    high = ag.max_(ag.min_(ag.min_(0.009, 0.035 * deep), 0.08 * tall), 0.0025)
    number = f"NO. {look.model}-{look.model * 7 % 97:02d}"
    beside = [
        (_barcode(ag.min_(0.11, 0.44 * deep), ag.min_(0.026, 0.09 * tall), look.model), 0.09),
        (details.lettering((number,), high, fineness="coarse"), 0.175),
    ]
    if look.signs == "full":
        beside.append((_signs(row[:2], ag.min_(size, 0.80 * deep / 2.84)), 0.34))
    return made + _on_walls(panel, (LEFT, RIGHT), beside, color)


def wine(look: Look, case: ag.Region, face: ag.Material, *, bottles: int) -> list[ag.Body]:
    """Print a wine box in front and behind."""
    (width, _, height), color = case.size, look.ink(face)
    icon = "glass" if look.model % 2 else "bottle"
    words = (f"{bottles} x 75 CL",)
    line = ag.rectangle(0.60 * width, 0.0016).at(0.0, 0.0035) | ag.rectangle(0.60 * width, 0.0008)
    rows = [
        (details.icon(icon, ag.min_(0.24 * height, 0.42 * width)), 0.70),
        (look.mark(0.78 * width, 0.050 * height, sign=False, tracking=0.3), 0.485),
        (line, 0.435),
        (details.lettering(words, ag.min_(0.024 * height, 0.09 * width), tracking=0.2), 0.385),
    ]
    made = _on_walls(case, (FRONT, BACK), rows, GOLD if sum(face.base_color) < 0.3 else color)
    if look.signs == "full":
        signs = _signs(("fragile", "up"), ag.min_(0.045, 0.22 * width))
        made += _on_walls(case, (FRONT, BACK), [(signs, 0.20)], color)
    return made


_FREE_EDGE = (0.0, -1.0, 0.0)  # up for a reader at the free edge of a lid, in the frame of its sheet


def pizza(look: Look, lid: ag.Region) -> list[ag.Body]:
    """Print the lid of a pizza box, in the frame of its sheet, with the crease at the back."""
    wide, deep, _ = lid.size
    names = (("red", "forest"), ("forest", "red"), ("red", "red"), ("graphite", "graphite"))
    first, second = map(ink, names[look.model % 4])
    pattern = look.model // 4 % 3
    word = details.lettering(("PIZZA",), (0.085, 0.15, 0.11)[pattern] * deep, tracking=0.22)
    rows = [(look.mark(0.38 * deep, 0.034 * deep), 0.27, 0.90, second)]  # beside the tab of the lid
    if pattern == 0:
        rings = ag.ring(0.335 * deep, 0.318 * deep) | ag.ring(0.305 * deep, 0.300 * deep)
        rows += [(rings, 0.0, 0.47, second), (details.icon("pizza", 0.30 * deep), 0.0, 0.40, first),
                 (word, 0.0, 0.63, first)]  # fmt: skip
    elif pattern == 1:
        words = details.lettering(("FRESH  HOT  TASTY",), 0.034 * deep, tracking=0.3)
        side = 0.96 * wide / 24  # two rows of squares as on a tablecloth
        square = ag.rectangle(0.98 * side, 0.98 * side)
        checks = _merged(square.at((n - 11.5) * side, (n % 2 - 0.5) * side) for n in range(24))
        rows += [(word, 0.0, 0.50, first), (words, 0.0, 0.66, second), (checks, 0.0, 0.13, second),
                 (checks, 0.0, 0.80, second)]  # fmt: skip
    else:
        rows += [(details.icon("pizza", 0.62 * deep), 0.0, 0.42, first),
                 (details.icon("wheat", 0.12 * deep), -0.36, 0.20, second),
                 (details.icon("flame", 0.12 * deep), 0.36, 0.20, second)]  # fmt: skip
    return [
        put(profile, (x * wide, lid.y.at(y), 0.0), color, ag.Z, _FREE_EDGE) for profile, x, y, color in rows
    ]


def pizza_front(look: Look, case: ag.Region) -> list[ag.Body]:
    """Print the front wall of a pizza box."""
    words = ("FRESH AND HOT", "BUON APPETITO", "HAND MADE", "ENJOY YOUR MEAL")[look.model % 4]
    size = ag.min_(0.34 * case.z.size, 0.98 * case.x.size / details.lettering_width(words, 0.25))
    text = details.lettering((words,), size, tracking=0.25)
    return _on_walls(case, (FRONT,), [(text, 0.5)], ink("red" if look.model % 3 else "forest"))


def mailer(look: Look, lid: ag.Region, outside: ag.Material, inside: ag.Material) -> list[ag.Body]:
    """Print the outside and the inside of a mailer lid, in the frame of its sheet."""
    wide, deep, _ = lid.size
    rows = [(look.mark(0.62 * wide, 0.085 * deep), 0.5)]
    pattern = look.model % 4
    if pattern == 0:
        inner = ag.rectangle(0.885 * wide, 0.86 * deep - 0.015 * wide)
        rows.append((ag.rectangle(0.90 * wide, 0.86 * deep) - inner, 0.5))
    elif pattern == 1:
        rows.append((details.emblem(look.emblem, 0.17 * deep), 0.27))
    elif pattern == 2:
        thin = ag.rectangle(0.996 * wide, 0.012 * deep).at(0.0, 0.035 * deep)
        rows.append((thin | ag.rectangle(0.996 * wide, 0.026 * deep), 0.80))
    else:
        dot = ag.circle(0.011 * deep)
        dots = _merged(dot.at((0.1 * n - 0.40) * wide) for n in range(9))
        rows += [(dots, 0.22), (dots, 0.78)]
    color = look.ink(outside)
    made = [put(profile, (0.0, lid.y.at(y), 0.0), color, ag.Z, _FREE_EDGE) for profile, y in rows]
    # for a reader of the open lid, up is the free edge
    words = ("HELLO!", "THANK YOU", "ENJOY", "MADE FOR YOU")[pattern]
    text = details.lettering((words,), ag.min_(0.10 * deep, 0.07 * wide), tracking=0.15)
    below = (0.0, lid.y.at(0.52), lid.z.low)
    return [*made, put(text, below, look.ink(inside), -ag.Z, ag.Y)]
