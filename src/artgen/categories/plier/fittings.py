"""Halves of pliers: forged shape, jaws, cutters, grips and springs."""

import math
from dataclasses import dataclass
from functools import reduce
from typing import Literal, NamedTuple

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.plier.halves import RECESSED, Forging

Grip = Literal["bare", "dipped", "two_component"]

_PROUD = 0.0006  # height of the soft part above the sleeve [m]
_MESH = 0.00012  # distance from the middle line of the teeth to each row [m]
_SIDES = 4  # number of sides of holes for pivots, hidden by the heads

ALIGNED = 0.47
"""Angle of slip-joint pliers at which the flats of their bolt are aligned with the neck of the slot [rad]."""

PASSES = 0.40
"""Least angle at which the bolt passes the neck [rad]."""


def jaw_face(forging: Forging, count: int, finish: ag.Material, *, phase: int) -> ag.Body:
    """Make the visible flat of a jaw; its teeth fit between those of the other jaw."""
    low, high = forging.head.grips
    start, end = forging.level(low), forging.level(high)
    steps = max(2 * count, 1)
    deep = 0.00020 if count else 0.0  # height of the teeth, limited by the recess of the face [m]
    points = [
        (_MESH + phase * deep * (1.0 if index % 2 else -1.0), start + (end - start) * index / steps)
        for index in range(steps + 1)
    ]
    back = RECESSED + 0.0004
    strip = ag.extrude(ag.polygon([*points, (back, end), (back, start)]), 0.03, axis=ag.Z)
    return ag.detail(strip & _between(forging, low, high, 0.96), "teeth", finish)


def _between(forging: Forging, low: float, high: float, share: float) -> ag.Solid:
    """Make the space between the sides of a jaw, for the parts on its face."""
    sections = [ag.rectangle(0.02, share * forging.height(at)) for at in (low, high)]
    return ag.loft(sections, [forging.level(low), forging.level(high)], axis=ag.Y)


def cutting_edge(forging: Forging, finish: ag.Material) -> ag.Body:
    """Make the visible ground edge of a cutting jaw."""
    low, high = forging.level(forging.head.cuts[0]), forging.level(forging.head.cuts[1])
    half, back = 0.2 * forging.height(forging.head.cuts[1]), RECESSED + 0.0004
    section = ag.polygon([(0.0001, 0.0), (back, half), (back, -half)])
    edge = ag.extrude(section, high - low, axis=ag.Y).at(0.0, (low + high) / 2.0, 0.0)
    return ag.detail(edge, "edge", finish)


def pipe_lining(forging: Forging, finish: ag.Material) -> ag.Body:
    """Make the visible coarse teeth of the round pipe grip."""
    middle, half = forging.head.pipe
    y, deep, long = forging.level(middle), forging.pipe_depth, half * forging.jaw
    count = 6
    inner, outer = [], []
    for index in range(2 * count + 1):
        angle = math.radians(-78.0 + 156.0 * index / (2 * count))
        share = 0.97 if index % 2 else 0.80
        inner.append((share * deep * math.cos(angle), y + share * long * math.sin(angle)))
        outer.append((1.1 * deep * math.cos(angle), y + 1.04 * long * math.sin(angle)))
    strip = ag.extrude(ag.polygon([*inner, *reversed(outer)]), 0.9 * forging.height(middle), axis=ag.Z)
    return ag.detail(strip, "teeth", finish)


def pivot_hole(radius: ag.Scalar) -> ag.Profile:
    """Make the outline of the hole for a rivet, with its sides outside the radius [m]."""
    return ag.regular_polygon(_SIDES, radius / math.cos(math.pi / _SIDES))


def rivet(forging: Forging, radius: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Make a rivet: it is fixed in the lower plate, passes the upper plate, and has a head above it."""
    top, bottom = forging.thick / 2.0, -forging.thick / 2.0
    shank = ag.cylinder_between((0.0, 0.0, bottom + 0.0004), (0.0, 0.0, top + 0.0008), radius)
    head = ag.cylinder_between(
        (0.0, 0.0, top + 0.0002), (0.0, 0.0, top + 0.0012), 1.55 * radius, bevel=0.0004
    )
    ground = ag.cylinder_between(
        (0.0, 0.0, top + 0.0008), (0.0, 0.0, top + 0.00125), 1.05 * radius, bevel=0.0002
    )
    return [
        ag.part(ag.union(shank, head), "pivot", finish),
        ag.detail(ground, "pivot", ag.material("stainless")),
    ]


class Key(NamedTuple):
    """The keyed bolt of a slip joint and the slot of two holes that it passes when it is aligned."""

    radius: ag.Scalar  # radius of the bolt [m]
    flats: ag.Scalar  # half of the distance between the flats of the bolt [m]
    hole: ag.Scalar  # radius of both holes [m]
    way: ag.Scalar  # distance from one hole to the other [m]

    @staticmethod
    def of(length: ag.Scalar) -> "Key":
        """Size a bolt for pliers of a length [m]; the neck between the holes is 6 mm for 200 mm."""
        return Key(0.0200 * length, 0.0120 * length, 0.0200 * length + 0.00019, 0.0290 * length)

    def slot(self) -> ag.Profile:
        """Make the outline of the slot: the second hole is at -x."""
        # few sides, so that a collider cannot combine two of them and reach into the hole
        hole = ag.regular_polygon(14, self.hole / math.cos(math.pi / 14.0))
        return hole | hole.at(-self.way)

    def bolt(self, forging: Forging, finish: ag.Material) -> list[ag.Body]:
        """Make the bolt, fixed in the plate of one half, with a nut beyond the plate of the other half."""
        top, bottom = forging.thick / 2.0, -forging.thick / 2.0
        # angle at which the flats meet the round sides
        reach = ag.sqrt(self.radius * self.radius - self.flats * self.flats)
        side = [(self.radius * math.cos(at), self.radius * math.sin(at)) for at in (-0.39, -0.13, 0.13, 0.39)]
        half = [(reach, -self.flats), *side, (reach, self.flats)]
        outline = ag.polygon([*half, *((-x, -y) for x, y in half)]).rotate(ALIGNED)
        nut = 0.0020
        shank = ag.extrude(outline, forging.thick + nut, axis=ag.Z).at(0.0, 0.0, nut / 2.0)
        plate = ag.extrude(ag.regular_polygon(6, 1.75 * self.radius), nut - 0.0003, axis=ag.Z, bevel=0.0003)
        head = ag.cylinder_between(
            (0.0, 0.0, bottom + 0.0004), (0.0, 0.0, bottom - 0.0016), 1.7 * self.radius, bevel=0.0006
        )
        return [
            ag.part(
                ag.union(shank, plate.at(0.0, 0.0, top + 0.0003 + (nut - 0.0003) / 2.0)), "pivot", finish
            ),
            ag.part(head, "pivot", finish),
        ]


_FAT: dict[Grip, float] = {"bare": 0.0, "dipped": 0.0016, "two_component": 0.0040}
"""Thickness of sleeves [m]."""

_SWELL = {"dipped": (1.0,) * 7, "two_component": (1.12, 1.0, 1.02, 1.05, 1.04, 0.98, 0.94)}
"""Relative thickness of a sleeve along its length, from its upper end."""


def sleeve_thickness(style: Grip, thick: ag.Float) -> ag.Float:
    """Return the largest thickness of the sleeved handles of pliers, over bars of a thickness [m]."""
    return (thick + 2.0 * _FAT[style]) * max(_SWELL.get(style, (1.0,)))


class _Ring(NamedTuple):
    """A section of a sleeve: its position and size."""

    y: ag.Scalar
    x: ag.Scalar
    wide: ag.Scalar
    tall: ag.Scalar


def _rings(forging: Forging, style: Grip, width: ag.Scalar, thick: ag.Scalar) -> list[_Ring]:
    """Return the sections of a sleeve, from its upper end."""
    fat = 2.0 * _FAT[style]
    first = 0 if style == "two_component" else 1
    rings = [
        _Ring(y, x, (width + fat) * swell, (thick + fat) * swell)
        for (y, x), swell in zip(forging.course[2:], _SWELL[style], strict=True)
    ][first:]
    y, x, wide, tall = rings[0]
    lead = 0.78 if style == "two_component" else 0.88
    upper = _Ring(y + 0.0026, x + 0.0005, lead * wide, lead * tall)
    return [upper, *rings, _below(rings[-1], 0.0036, 0.56)]


def off_middle(forging: Forging, style: Grip, width: ag.Scalar) -> ag.Scalar:
    """Return the least distance of the closed handles from the middle plane, near their upper ends [m]."""
    off = [-x - width / 2.0 for _, x in forging.course[1:3]]
    if style != "bare":
        off += [-ring.x - ring.wide / 2.0 for ring in _rings(forging, style, width, width)[:3]]
    return reduce(ag.min_, off)


def _below(ring: _Ring, down: float, share: float) -> _Ring:
    """Return a smaller section below the last section that contains steel."""
    return _Ring(ring.y - down, ring.x + down / 12.0, share * ring.wide, share * ring.tall)


def sleeved(forging: Forging, style: Grip, width: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    """Make the sleeve of a handle: dipped in PVC, or a thick sleeve of two plastics."""
    return _along(_rings(forging, style, width, thick))


def sleeve_end(
    forging: Forging, style: Grip, width: ag.Scalar, thick: ag.Scalar, finish: ag.Material
) -> ag.Body:
    """Make the visible round end of a sleeve, over the colliding cone; see `sleeved`."""
    last = _rings(forging, style, width, thick)[-2]
    steps = ((-0.0004, 0.97), (0.0002, 1.0), (0.0014, 0.94), (0.0028, 0.80), (0.0037, 0.56))
    return ag.detail(_along([_below(last, down, share) for down, share in steps]), "grip", finish)


def grip_inlay(
    forging: Forging, width: ag.Scalar, thick: ag.Scalar, finish: ag.Material, *, over: bool
) -> ag.Body:
    """Make the soft part of a two-plastic sleeve, visible from above; see `hold_on`."""
    shares = (0.30, 0.58, 0.66, 0.66, 0.60, 0.42, 0.20)
    rings = _rings(forging, "two_component", width, thick)[1:]
    soft = [_Ring(y, x, share * wide, tall) for share, (y, x, wide, tall) in zip(shares, rings, strict=False)]
    return ag.detail(_along(soft).at(0.0, 0.0, -_PROUD if over else _PROUD), "grip", finish)


def hold_on(forging: Forging, solid: ag.Solid, thick: ag.Scalar, *, over: bool) -> ag.Frame:
    """Return the grasp of a handle from above, near its widest place."""
    y, x = forging.course[5]
    return ag.grasp_on(
        solid, approach=ag.Z if over else -ag.Z, closing=ag.X, at=(x, y, 0.0), depth=0.8 * thick
    )


def _along(rings: list[_Ring]) -> ag.Solid:
    sections = [
        ag.rectangle(ring.wide, ring.tall, radius=0.40 * ag.min_(ring.wide, ring.tall)).at(ring.x)
        for ring in reversed(rings)
    ]
    return ag.loft(sections, [ring.y for ring in reversed(rings)], axis=ag.Y)


def leaf_spring(forging: Forging, finish: ag.Material, *, width: ag.Scalar) -> ag.Body:
    """Make the visible leaf spring of a handle; both springs touch in the middle."""
    stations = forging.course
    foot_y, foot_x = stations[3]
    inside = foot_x + 0.42 * width
    end = -forging.clear_below - 0.55 * forging.lap
    course = ag.polyline(
        [
            (inside, foot_y - 0.006, 0.0),
            (inside + 0.0008, foot_y + 0.002, 0.0),
            (-0.0022, (foot_y + end) / 2.0 + 0.002, 0.0),
            (-0.0010, end, 0.0),
        ],
        fillet=0.006,
    )
    return ag.detail(ag.sweep(ag.rectangle(0.0009, 0.0045), course), "spring", finish)


_RIVET = 0.36  # radius of a rivet, in radii of the lap
_PLAY = 0.0003  # gap between a rivet and its hole [m]


@dataclass(frozen=True)
class Make:
    """Dimensions and finish of pliers."""

    forging: Forging  # dimensions of the halves
    teeth: int  # number of teeth on the flat of a jaw; 0 for plain jaws
    steel: ag.Material  # steel of the halves
    grip: Grip  # style of the sleeves of the handles
    sleeve: ag.Material  # material of the sleeves
    inlay: ag.Material  # material of the soft parts of the sleeves
    width: ag.Scalar  # width of the bars of the handles, in the plane of the tool [m]
    thick: ag.Float  # thickness of these bars [m]
    sprung: bool  # whether a leaf spring opens the pliers
    key: Key | None  # the keyed bolt of slip-joint pliers; None for a rivet

    def lower(self) -> ag.Body:
        """Make the half with the right jaw and the lower plate: the link `body`."""
        pivot = [] if self.key else rivet(self.forging, _RIVET * self.forging.lap, self.steel)
        return ag.weld(self._half("body", over=False), *pivot)

    def upper(self) -> ag.Body:
        """Make the half with the left jaw and the upper plate: the link `jaw`."""
        pivot = self.key.bolt(self.forging, self.steel) if self.key else []
        return ag.weld(self._half("jaw", over=True), *pivot).rotate(ag.Y, math.pi)

    def rests(self) -> ag.Float:
        """Return the height of the middle of the tool above the table [m]."""
        nut = 0.0020 if self.key else 0.0
        return ag.max_(sleeve_thickness(self.grip, self.thick) / 2.0, self.forging.thick / 2.0 + nut)

    def middle(self) -> ag.Float:
        """Return the middle of the lower half, x [m]."""
        left, right = self._lower.anchor(x=-1.0).x, self._lower.anchor(x=1.0).x
        if self.grip != "bare":
            left = ag.min_(left, self._sleeve.anchor(x=-1.0).x)
        return (left + right) / 2.0

    @cached_property
    def _bar(self) -> ag.Solid:
        """Make the steel of a handle."""
        return self.forging.handle_solid(self.width, self.thick, hidden=self.grip != "bare")

    @cached_property
    def _sleeve(self) -> ag.Solid:
        """Make the sleeve of a handle."""
        return sleeved(self.forging, self.grip, self.width, self.thick)

    @cached_property
    def _sleeve_end(self) -> ag.Body:
        """Make the visible round end of a sleeve."""
        return sleeve_end(self.forging, self.grip, self.width, self.thick, self.sleeve)

    @cached_property
    def _forged(self) -> ag.Solid:
        """Return the common options of both halves."""
        return ag.union(self.forging.jaw_solid(), *self.forging.shoulders(), self._bar)

    @cached_property
    def _lower(self) -> ag.Solid:
        """Make the steel of the lower half."""
        return self._forged | self.forging.plate(self.key.slot() if self.key else None)

    @cached_property
    def _upper(self) -> ag.Solid:
        """Make the steel of the other half, before it is turned over."""
        hole = None if self.key else pivot_hole(_RIVET * self.forging.lap + _PLAY)
        return self._forged | self.forging.plate(hole)

    def _half(self, label: str, *, over: bool) -> ag.Body:
        """Make a half in its drawn pose, with its jaw at the right, without its pivot."""
        forging, solid = self.forging, self._upper if over else self._lower
        if self.grip == "bare":
            hold = hold_on(forging, self._bar, self.thick, over=over)
            bodies = [ag.part(solid, label, self.steel, grasp=hold)]
        else:
            tall = sleeve_thickness(self.grip, self.thick)
            hold = hold_on(forging, self._sleeve, tall, over=over)
            name = "upper_grip" if over else "lower_grip"
            bodies = [
                ag.part(solid, label, self.steel),
                ag.part(self._sleeve, "grip", self.sleeve, name=name, grasp=hold),
                self._sleeve_end,
            ]
        if self.grip == "two_component":
            bodies.append(grip_inlay(forging, self.width, self.thick, self.inlay, over=over))
        if not forging.keen:
            bodies.append(jaw_face(forging, self.teeth, self.steel, phase=-1 if over else 1))
        if forging.head.pipe[1]:
            bodies.append(pipe_lining(forging, self.steel))
        if forging.head.cuts[1] and not forging.keen:
            bodies.append(cutting_edge(forging, self.steel))
        if self.sprung:
            bodies.append(leaf_spring(forging, ag.material("stainless"), width=self.width))
        return ag.weld(*bodies)
