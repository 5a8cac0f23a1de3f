"""The halves of pliers: jaw, lapped joint and handle of one forging, with the pivot at the origin.

Jaws point to +y, and the pivot's axis is z. A half has its jaw at the right (x > 0) and its handle at the
left, and in the lap it has the lower half of the thickness. The other half is the same shape turned over,
rotated by pi about y, so that its jaw is at the left and its lap on top. It opens by turning about +z.

In the lap, each half is a plate of half the thickness; parts of full thickness stay outside the radius
`clear` about the pivot, and inside a sector that the other half does not sweep when it opens.
"""

import math
from typing import Literal, NamedTuple

import numpy as np

import artgen as ag

Style = Literal["combination", "needle_nose", "cutter", "slip_joint"]

RECESSED = 0.00035
"""Depth of the face of a jaw under its teeth or edges, from the middle plane [m]."""

_LAP_GAP = 0.00015  # half of the gap between the plates [m]
_OFF = 0.0006  # gap between a plate and the shoulders around it [m]
_STEPS = 3  # number of chords of a shoulder's arc
# factor and offset of the largest width of a bar beyond that of its neck, by its relative thickness [m]
_FLARE, _FLARE_LESS = 0.0122, 0.0050
_CLOSED = 0.0001  # distance of a cutting edge from the middle plane [m]
_UP = math.pi / 2  # angle of the end of a jaw's shoulder, at its face [rad]


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
        0.262, 0.060, 0.058, ((0.0, 1.07), (0.25, 1.07), (0.6, 0.92), (0.96, 0.66), (1.0, 0.58)),
        (0.595, 0.985), (0.47, 0.115), (0.02, 0.365),
    ),
    "needle_nose": Head(
        0.365, 0.050, 0.052, ((0.0, 1.07), (0.12, 1.02), (0.35, 0.72), (0.97, 0.21), (1.0, 0.16)),
        (0.33, 0.985), (0.0, 0.0), (0.02, 0.32),
    ),
    "cutter": Head(
        0.190, 0.068, 0.062, ((0.0, 1.07), (0.30, 1.07), (0.72, 0.78), (0.96, 0.44), (1.0, 0.34)),
        (0.0, 0.0), (0.0, 0.0), (0.05, 0.97),
    ),
    "slip_joint": Head(
        0.235, 0.050, 0.050, ((0.0, 1.30), (0.25, 1.28), (0.6, 1.02), (0.95, 0.72), (1.0, 0.62)),
        (0.62, 0.985), (0.36, 0.20), (0.0, 0.0),
    ),
}  # fmt: skip

# the center line of a handle: shares of its length from the lap down, and progress from the neck to the
# widest point: outward in an S, and a little back at the end
_COURSE = (
    (0.0, 0.0), (0.10, 0.16), (0.22, 0.46), (0.36, 0.74), (0.50, 0.91), (0.64, 1.0), (0.78, 1.0),
    (0.90, 0.94), (1.0, 0.86),
)  # fmt: skip

Point = tuple[ag.Scalar, ag.Scalar]


class Forging:
    """Dimensions and solids of both halves.

    Args:
        style: Style of the pliers.
        length: Overall length [m].
        slip: Travel of the pivot of slip-joint pliers; 0 for others [m].
        spread: Half of the largest distance between the closed handles [m].
    """

    def __init__(self, style: Style, length: ag.Float, slip: ag.Scalar, spread: ag.Float) -> None:
        self.head, self.length, self.slip = HEADS[style], length, slip
        self.keen = style == "cutter"  # whether the whole jaw is a cutting edge
        self._slides = style == "slip_joint"  # whether the pivot slides
        self.jaw = self.head.jaw * length  # distance from the pivot to the tip [m]
        self.lap = self.head.lap * length  # radius of the plates [m]
        self.thick = self.head.thick * length  # thickness at the pivot [m]
        self.rear = length - self.jaw  # distance from the pivot to the end of the handles [m]
        # radius about the pivot that the shoulder of the jaw leaves free for the other plate, and that of the
        # handle for the plate that slides [m]
        self.clear, self.clear_below = self.lap + _OFF + 0.54 * slip, self.lap + _OFF + slip
        self.pipe_depth = 0.34 * self._width(self.head.pipe[0]) * self.lap  # depth of the round grip [m]
        # ends of the top of the handle below the lap along x [m]
        self.neck = -0.92 * self.lap - 0.55 * slip, -0.10 * self.lap - 0.55 * slip
        # angles of the start of the shoulder of a jaw and of both ends of that of a handle, outside the sweep
        # of the other half [rad]
        angles = (30.0, 210.0, 252.0) if self._slides else (20.0, 204.0, 262.0)
        self._root, self._start, self._end = map(math.radians, angles)
        top, start = -self.clear_below - 0.30 * self.lap, sum(self.neck) / 2
        # y and x of the center line of the handle [m]
        self.course: list[Point] = [
            (top - share * (self.rear + top), start - out * (spread + start)) for share, out in _COURSE
        ]

    def level(self, share: float) -> ag.Float:
        """Return the position of a share of the jaw, from its root, along y [m]."""
        return self.clear + share * (self.jaw - self.clear)

    def height(self, share: float) -> ag.Float:
        """Return the thickness of a jaw at a share of its length [m]."""
        return self._width(share) / self.head.outline[0][1] * self.thick

    def _width(self, share: float) -> float:
        """Return the half width of the head at a share of the jaw, in radii of the lap."""
        shares, widths = zip(*self.head.outline, strict=True)
        return float(np.interp(share, shares, widths))

    def jaw_solid(self) -> ag.Solid:
        """Make the jaw in front of the lap, without the parts on its face."""
        outline = self.head.outline
        sections = [
            _jaw_section(width * self.lap, self.height(share), keen=self.keen) for share, width in outline
        ]
        solid = ag.loft(sections, [self.level(share) for share, _ in outline], axis=ag.Y)
        middle, half = self.head.pipe
        if half == 0.0:
            return solid
        # three sides: the lining is round and carries the teeth
        long, deep, y = half * self.jaw, 0.95 * self.pipe_depth, self.level(middle)
        left: list[Point] = [(-0.01, y + long), (-0.01, y - long), (0.0, y - long)]
        tool = ag.polygon([*left, (deep, y - 0.60 * long), (deep, y + 0.60 * long), (0.0, y + long)])
        return solid - ag.extrude(tool, 0.05, axis=ag.Z)

    def shoulders(self) -> list[ag.Solid]:
        """Make the full-thickness parts between the lap and jaw or handle, beside the other half's plate."""
        outer, eased, top = self.head.outline[0][1] * self.lap, 0.20 * self.lap, self.level(0.02)
        jaw = _arc(self.clear, self._root, _UP)
        jaw[-1] = (RECESSED, self.clear)  # the face of the jaw continues down to the lap
        jaw_root = ag.polygon([*reversed(jaw), (outer, jaw[0][1] + eased), (outer, top), (RECESSED, top)])
        handle = _arc(self.clear_below, self._start, self._end)
        x, y = handle[0]
        bottom, (left, right) = -self.clear_below - 0.35 * self.lap, self.neck
        shoulder = (ag.min_(-0.99 * outer, x - 0.0006), y - eased)
        handle_root = ag.polygon([*handle, (right, bottom), (left, bottom), shoulder])
        return [ag.extrude(each, self.thick, axis=ag.Z) for each in (jaw_root, handle_root)]

    def plate(self, hole: ag.Profile | None) -> ag.Solid:
        """Make the lower plate with a hole for the pivot, and its webs to the shoulders."""
        high = self.thick / 2 - _LAP_GAP
        webs = [
            self._web(self.clear + 0.0012, self._root, _UP, RECESSED),
            self._web(self.clear_below + 0.0012, self._start + 0.03, self._end - 0.03, None),
        ]
        disc = ag.circle(self.lap)
        if self._slides:
            outline = disc | ag.circle(0.78 * self.lap).at(-self.slip) | webs[0] | webs[1]
            flat = ag.extrude(outline if hole is None else outline - hole, high, axis=ag.Z)
        else:
            plate = ag.extrude(disc, high, axis=ag.Z)
            plate = plate if hole is None else plate - ag.extrude(hole, 2 * high, axis=ag.Z)
            flat = ag.union(plate, *(ag.extrude(web, high, axis=ag.Z) for web in webs))
        return flat.at(z=-_LAP_GAP - high / 2)

    def _web(self, radius: ag.Scalar, start: float, end: float, face: ag.Scalar | None) -> ag.Profile:
        """Make a web from the disc to a shoulder between two angles; webs of jaws end at their face."""
        points = _arc(radius, start, end)
        if face is not None:
            points[-1] = (face, radius)
        inner = 0.66 * self.lap
        corners = [(inner * math.cos(angle), inner * math.sin(angle)) for angle in (end, start)]
        return ag.polygon([*points, *corners])

    def handle_solid(self, width: ag.Scalar, thick: ag.Scalar, *, hidden: bool) -> ag.Solid:
        """Make the handle: a bar of rounded section; under a sleeve it has fewer sections."""
        left, right = self.neck
        bends = [bend for index, bend in enumerate(self.course) if not (hidden and index in (5, 7))]
        root = ag.rectangle(right - left, self.thick, radius=0.0015)
        # a thin bar much wider than the neck would twist the sides between them
        flare = right - left + _FLARE * thick / self.thick - _FLARE_LESS
        wide = [ag.min_(width, flare), *(width for _ in bends[2:])]
        bars = [ag.rectangle(each, thick, radius=ag.min_(0.0028, 0.49 * thick)) for each in wide]
        sections = [root.at(bends[0][1]), *(bar.at(x) for bar, (_, x) in zip(bars, bends[1:], strict=True))]
        return ag.loft(sections[::-1], [y for y, _ in reversed(bends)], axis=ag.Y)


def _arc(radius: ag.Scalar, start: float, end: float) -> list[Point]:
    """Return points with chords outside of a radius, counter-clockwise [m]."""
    step = (end - start) / _STEPS
    out, angles = radius / math.cos(step / 2), [start + step * index for index in range(_STEPS + 1)]
    return [(out * math.cos(angle), out * math.sin(angle)) for angle in angles]


_BACK = [
    (0.45 + 0.55 * math.cos(angle), math.sin(angle))
    for angle in (math.radians(22.5 * step) for step in range(-4, 5))
]
"""The round back of a jaw, for a width of 1 and a height of 2."""


def _jaw_section(width: ag.Scalar, high: ag.Scalar, *, keen: bool) -> ag.Profile:
    """Make the section of a jaw: flat or keen at its face, round on its back."""
    if keen:
        edge = [(0.12, 1.0), (0.0, 0.04), (0.0, -0.04), (0.12, -1.0)]
        return ag.polygon([*_BACK, *edge]).scale(width, high / 2).at(_CLOSED)
    return ag.polygon([*_BACK, (0.0, 1.0), (0.0, -1.0)]).scale(width, high / 2).at(RECESSED)
