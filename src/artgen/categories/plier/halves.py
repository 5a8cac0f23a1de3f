"""The halves of pliers: jaw, lapped joint and handle of one forging, with the pivot at the origin.

Jaws point to +y, and the pivot's axis is z. A half has its jaw at the right (x > 0) and its handle at the
left, and in the lap it has the lower half of the thickness. The other half is the same shape turned over,
rotated by pi about y, so that its jaw is at the left and its lap on top. It opens by turning about +z.

In the lap, each half is a plate of half the thickness; parts of full thickness stay outside the radius
`clear` about the pivot, and inside a sector that the other half does not sweep when it opens.
"""

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal, NamedTuple

import artgen as ag
from artgen._arrays import cached_property

Style = Literal["combination", "needle_nose", "cutter", "slip_joint"]

LAP_GAP = 0.00015
"""Half of the gap between the plates [m]."""

_OFF = 0.0006  # gap between a plate and the shoulders around it [m]
_STEPS = 3  # number of chords of a shoulder's arc
RECESSED = 0.00035  # depth of the face of a jaw under its teeth or edges, from the middle plane [m]
# factor and offset of the largest width of a bar beyond that of its neck, by its relative thickness [m]
_FLARE, _FLARE_LESS = 0.0122, 0.0050
_CLOSED = 0.0001  # distance of a cutting edge from the middle plane [m]


class Head(NamedTuple):
    """Proportions of a style, in shares of the whole length unless stated otherwise."""

    jaw: float  # distance from the pivot to the tip
    lap: float  # radius of the plates
    thick: float  # thickness at the pivot
    # sections of a jaw, from its root to its tip: share of its length, and half width in radii of the lap;
    # the thickness decreases with the width
    outline: tuple[tuple[float, float], ...]
    grips: tuple[float, float]  # range of the teeth on the jaw, in shares of its length
    # middle and half of the length of the round pipe grip; half of 0 for none
    pipe: tuple[float, float]
    cuts: tuple[float, float]  # range of the cutting edges on the jaw


HEADS: dict[Style, Head] = {
    # proportions of 180 mm combination, 200 mm long-nose, 160 mm diagonal and 200 mm slip-joint pliers
    "combination": Head(
        0.262,
        0.060,
        0.058,
        ((0.0, 1.07), (0.25, 1.07), (0.6, 0.92), (0.96, 0.66), (1.0, 0.58)),
        (0.595, 0.985),
        (0.47, 0.115),
        (0.02, 0.365),
    ),
    "needle_nose": Head(
        0.365,
        0.050,
        0.052,
        ((0.0, 1.07), (0.12, 1.02), (0.35, 0.72), (0.97, 0.21), (1.0, 0.16)),
        (0.33, 0.985),
        (0.0, 0.0),
        (0.02, 0.32),
    ),
    "cutter": Head(
        0.190,
        0.068,
        0.062,
        ((0.0, 1.07), (0.30, 1.07), (0.72, 0.78), (0.96, 0.44), (1.0, 0.34)),
        (0.0, 0.0),
        (0.0, 0.0),
        (0.05, 0.97),
    ),
    "slip_joint": Head(
        0.235,
        0.050,
        0.050,
        ((0.0, 1.30), (0.25, 1.28), (0.6, 1.02), (0.95, 0.72), (1.0, 0.62)),
        (0.62, 0.985),
        (0.36, 0.20),
        (0.0, 0.0),
    ),
}


@dataclass(frozen=True)
class Forging:
    """Dimensions of both halves."""

    style: Style  # style of the pliers
    length: ag.Float  # overall length [m]
    slip: ag.Scalar  # travel of the pivot of slip-joint pliers; 0 for others [m]
    spread: ag.Float  # half of the largest distance between the closed handles [m]

    @property
    def head(self) -> Head:
        """Proportions of the style."""
        return HEADS[self.style]

    @property
    def jaw(self) -> ag.Float:
        """Distance from the pivot to the tip [m]."""
        return self.head.jaw * self.length

    @property
    def lap(self) -> ag.Float:
        """Radius of the plates [m]."""
        return self.head.lap * self.length

    @property
    def thick(self) -> ag.Float:
        """Thickness at the pivot [m]."""
        return self.head.thick * self.length

    @property
    def rear(self) -> ag.Float:
        """Distance from the pivot to the end of the handles [m]."""
        return self.length - self.jaw

    @property
    def keen(self) -> bool:
        """Whether the whole jaw is a cutting edge."""
        return self.style == "cutter"

    @property
    def clear(self) -> ag.Float:
        """Radius about the pivot that the jaw's shoulder leaves free for the other plate [m]."""
        return self.lap + _OFF + 0.54 * self.slip

    @property
    def _tail(self) -> tuple[float, float]:
        """Angles of the ends of the handle's shoulder, clear of the other half [rad]."""
        degrees = (210.0, 252.0) if self.style == "slip_joint" else (204.0, 262.0)
        return math.radians(degrees[0]), math.radians(degrees[1])

    @property
    def clear_below(self) -> ag.Float:
        """Radius about the pivot that the handle's shoulder leaves free for the other, sliding plate [m]."""
        return self.lap + _OFF + 1.0 * self.slip

    @property
    def _root(self) -> float:
        """Angle of the start of the jaw's shoulder, outside the sweep of the other half [rad]."""
        return math.radians(20.0 if self.style != "slip_joint" else 30.0)

    def level(self, share: float) -> ag.Float:
        """Return the position of a share of the jaw, from its root, along y [m]."""
        start = self.clear
        return start + share * (self.jaw - start)

    def half_width(self, share: float) -> ag.Float:
        """Return the half width of the head at a share of the jaw [m]."""
        return self._width(share) * self.lap

    def height(self, share: float) -> ag.Float:
        """Return the thickness of a jaw at a share of its length [m]."""
        return self._thinned(self._width(share))

    def _thinned(self, width: float) -> ag.Float:
        """Return the thickness of a jaw at a half width in radii of the lap [m]."""
        return width / self.head.outline[0][1] * self.thick

    def _width(self, share: float) -> float:
        rows = self.head.outline
        for low, high in pairwise(rows):
            if share <= high[0]:
                along = (share - low[0]) / (high[0] - low[0])
                return low[1] + along * (high[1] - low[1])
        return rows[-1][1]

    def jaw_solid(self) -> ag.Solid:
        """Make the jaw in front of the lap, without the parts on its face."""
        sections = [
            _jaw_section(width * self.lap, self._thinned(width), keen=self.keen)
            for _, width in self.head.outline
        ]
        solid = ag.loft(sections, [self.level(high[0]) for high in self.head.outline], axis=ag.Y)
        middle, half = self.head.pipe
        if half == 0.0:
            return solid
        # three sides: the lining is round and carries the teeth
        long, deep, y = half * self.jaw, self.pipe_depth, self.level(middle)
        out = 0.60 * long
        left: list[tuple[ag.Scalar, ag.Scalar]] = [(-0.01, y + long), (-0.01, y - long), (0.0, y - long)]
        tool = ag.polygon([*left, (0.95 * deep, y - out), (0.95 * deep, y + out), (0.0, y + long)])
        return solid - ag.extrude(tool, 0.05, axis=ag.Z)

    @property
    def pipe_depth(self) -> ag.Float:
        """Depth of the round grip in a jaw [m]."""
        return 0.34 * self.half_width(self.head.pipe[0])

    def shoulders(self) -> list[ag.Solid]:
        """Make the full-thickness parts between the lap and jaw or handle, beside the other half's plate."""
        first, last = self._root, math.radians(90.0)
        outer = self.half_width(0.0)
        jaw = _arc(self.clear, first, last)
        # the face of the jaw continues down to the lap
        jaw[-1] = (RECESSED, self.clear)
        low = jaw[0][1]
        eased = 0.20 * self.lap
        top = self.level(0.02)
        jaw_root = ag.polygon([*reversed(jaw), (outer, low + eased), (outer, top), (RECESSED, top)])
        start, end = self._tail
        handle = _arc(self.clear_below, start, end)
        bottom = -self.clear_below - 0.35 * self.lap
        left, right = self.neck
        beside = ag.min_(-0.99 * outer, handle[0][0] - 0.0006)
        shoulder = (beside, handle[0][1] - eased)
        handle_root = ag.polygon([*handle, (right, bottom), (left, bottom), shoulder])
        return [ag.extrude(each, self.thick, axis=ag.Z) for each in (jaw_root, handle_root)]

    @property
    def neck(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Ends of the top of the handle below the lap along x, from left to right [m]."""
        return -0.92 * self.lap - 0.55 * self.slip, -0.10 * self.lap - 0.55 * self.slip

    def plate(self, hole: ag.Profile | None) -> ag.Solid:
        """Make the lower plate with a hole for the pivot, and its webs to the shoulders."""
        high = self.thick / 2.0 - LAP_GAP
        start, end = self._tail
        webs = [
            self._web(self.clear + 0.0012, self._root, math.radians(90.0), RECESSED),
            self._web(self.clear_below + 0.0012, start + 0.03, end - 0.03, None),
        ]
        disc = ag.circle(self.lap)
        if self.style == "slip_joint":
            outline = disc | ag.circle(0.78 * self.lap).at(-self.slip) | webs[0] | webs[1]
            flat = ag.extrude(outline if hole is None else outline - hole, high, axis=ag.Z)
        else:
            plate = ag.extrude(disc, high, axis=ag.Z)
            plate = plate if hole is None else plate - ag.extrude(hole, 2.0 * high, axis=ag.Z)
            flat = ag.union(plate, *(ag.extrude(web, high, axis=ag.Z) for web in webs))
        return flat.at(0.0, 0.0, -LAP_GAP - high / 2.0)

    def _web(self, radius: ag.Scalar, start: float, end: float, face: ag.Scalar | None) -> ag.Profile:
        """Make a web from the disc to a shoulder between two angles; webs of jaws end at their face."""
        points = _arc(radius, start, end)
        if face is not None:
            points[-1] = (face, radius)
        inner = 0.66 * self.lap
        corners = [(inner * math.cos(angle), inner * math.sin(angle)) for angle in (end, start)]
        return ag.polygon([*points, *corners])

    @cached_property
    def course(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Center line of the handle: y and x of its stations, from the lap down [m]."""
        top = -self.clear_below - 0.30 * self.lap
        left, right = self.neck
        start = (left + right) / 2.0
        long = self.rear + top  # remaining length below it
        shares = (0.0, 0.10, 0.22, 0.36, 0.50, 0.64, 0.78, 0.90, 1.0)
        # progress from the neck to the widest point: outward in an S, and a little back at the end
        outs = (0.0, 0.16, 0.46, 0.74, 0.91, 1.0, 1.0, 0.94, 0.86)
        ends = self.spread
        return [
            (top - share * long, start - out * (ends + start))
            for share, out in zip(shares, outs, strict=True)
        ]

    def handle_solid(self, width: ag.Scalar, thick: ag.Scalar, *, hidden: bool) -> ag.Solid:
        """Make the handle: a bar of rounded section."""
        left, right = self.neck
        bends = [bend for index, bend in enumerate(self.course) if not (hidden and index in (5, 7))]
        root = ag.rectangle(right - left, self.thick, radius=0.0015)
        # a thin bar much wider than the neck would twist the sides between them
        flare = right - left + _FLARE * thick / self.thick - _FLARE_LESS
        wide = [ag.min_(width, flare), *(width for _ in bends[2:])]
        bars = [ag.rectangle(each, thick, radius=ag.min_(0.0028, 0.49 * thick)) for each in wide]
        sections = [root.at(bends[0][1]), *(bar.at(x) for bar, (_, x) in zip(bars, bends[1:], strict=True))]
        return ag.loft(sections[::-1], [y for y, _ in reversed(bends)], axis=ag.Y)


def _arc(radius: ag.Scalar, start: float, end: float) -> list[tuple[ag.Scalar, ag.Scalar]]:
    """Return points with chords outside of a radius, counter-clockwise [m]."""
    step = (end - start) / _STEPS
    out = radius / math.cos(step / 2.0)
    return [
        (out * math.cos(start + step * index), out * math.sin(start + step * index))
        for index in range(_STEPS + 1)
    ]


_BACK = [
    (0.45 + 0.55 * math.cos(angle), math.sin(angle))
    for angle in (math.radians(22.5 * step) for step in range(-4, 5))
]
"""The round back of a jaw, for a width of 1 and a height of 2."""


def _jaw_section(width: ag.Scalar, high: ag.Scalar, *, keen: bool) -> ag.Profile:
    """Make the section of a jaw: flat or keen at its face, round on its back."""
    if keen:
        edge = [(0.12, 1.0), (0.0, 0.04), (0.0, -0.04), (0.12, -1.0)]
        return ag.polygon([*_BACK, *edge]).scale(width, high / 2.0).at(_CLOSED)
    return ag.polygon([*_BACK, (0.0, 1.0), (0.0, -1.0)]).scale(width, high / 2.0).at(RECESSED)
