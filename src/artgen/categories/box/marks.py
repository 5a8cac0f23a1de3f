"""What is printed and stuck on boxes: handling signs, codes, names, labels and tape."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen.categories.shared import recycling

_FILM = 0.00012  # by which print and labels stand out [m]

TAPE = ag.material("polypropylene").with_(
    name="packing_tape", base_color=(0.34, 0.19, 0.075), specular_roughness=0.22, coat_weight=0.4
)
"""Brown packing tape."""

PAPER = ag.colored("abs", "white").with_(
    name="label_paper", texture="", specular_roughness=0.6, density=800.0
)
"""Stickers."""


def pull_tab(tall: float = 0.021) -> ag.Solid:
    """Make the end of a tape, folded on itself: it stands up at the edge of what it opens, and is pulled."""
    return ag.box_between((-0.014, -0.0007, -0.0006), (0.014, 0.0007, tall), bevel=0.0005)


def arrows(size: ag.Scalar) -> ag.Profile:
    """Make the sign for this side up: two arrows on a bar."""
    arrow = ag.polygon(
        [(-0.07, -0.30), (0.07, -0.30), (0.07, 0.16), (0.19, 0.16), (0.0, 0.48), (-0.19, 0.16), (-0.07, 0.16)]
    )
    bar = ag.rectangle(0.92, 0.075).at(0.0, -0.44)
    return (arrow.at(-0.25) | arrow.at(0.25) | bar).scale(size)


def fragile(size: ag.Scalar) -> ag.Profile:
    """Make the sign for fragile goods: a glass with a crack."""
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
    """Make the sign for keeping dry: an umbrella."""
    dome = ag.circle(0.46) & ag.rectangle(1.0, 0.5).at(0.0, 0.25)
    scallops = [ag.circle(0.155).at(x, 0.0) for x in (-0.307, 0.0, 0.307)]
    for each in scallops:
        dome = dome - each
    stick = ag.rectangle(0.05, 0.56).at(0.0, -0.12)
    hook = (ag.circle(0.11) - ag.circle(0.06)) & ag.rectangle(0.3, 0.12).at(0.0, -0.06)
    return (dome | stick | hook.at(0.085, -0.38)).at(0.0, 0.02).scale(size)


def barcode(width: ag.Scalar, height: ag.Scalar, seed: int) -> ag.Profile:
    """Make bars of a code, as wide and as far apart as a number says."""
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
    """A printer of one color on one face."""

    material: ag.Material  # the ink
    facing: ag.VectorLike = (0.0, -1.0, 0.0)  # out of the face
    up: ag.VectorLike | None = None  # upward for the reader; None is up, or to the back on a top

    def put(self, profile: ag.Profile, at: ag.VectorLike) -> ag.Body:
        """Print a profile about a point of the face."""
        return details.printed(
            profile, at, material=self.material, facing=self.facing, up=self.up, proud=_FILM
        )


def handling(signs: tuple[str, ...], size: ag.Scalar) -> ag.Profile:
    """Set handling signs in a row about the origin."""
    made = {"up": arrows, "fragile": fragile, "dry": umbrella, "recycle": recycling}
    row: ag.Profile | None = None
    for number, sign in enumerate(signs):
        frame = ag.rectangle(1.24 * size, 1.24 * size) - ag.rectangle(1.18 * size, 1.18 * size)
        each = (made[sign](size) | frame).at(1.42 * size * (number - (len(signs) - 1) / 2.0))
        row = each if row is None else row | each
    assert row is not None
    return row


def address_label(at: ag.VectorLike, *, facing: ag.VectorLike, size: ag.Scalar, number: int) -> list[ag.Body]:
    """Stick the label of a parcel service on a face: lines of an address and a code below them."""
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
    """Make the dark line where two sheets meet."""
    dark = ag.material("cardboard_edge").with_(name="seam_shade", base_color=(0.06, 0.04, 0.025), texture="")
    return ag.detail(ag.box_between(start, end), "box", dark)
