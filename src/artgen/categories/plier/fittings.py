"""Parts of the halves of pliers: teeth and cutting edges, pivots, sleeves of handles, and springs."""

import math
from functools import reduce
from typing import Literal, NamedTuple

import artgen as ag
from artgen.categories.plier.halves import RECESSED, Forging
from artgen.categories.shared.pivots import leaf_spring

_PROUD = 0.0006  # height of the soft part above the sleeve [m]
_MESH = 0.00012  # distance from the middle line of the teeth to each row [m]
_BEHIND = RECESSED + 0.0004  # position of the back of teeth and edges along x [m]

ALIGNED = 0.47
"""Angle of slip-joint pliers at which the flats of their bolt are aligned with the neck of the slot [rad]."""

PASSES = 0.40
"""Least angle at which the bolt passes the neck [rad]."""

NUT = 0.0020
"""Height of the nut of a bolt [m]."""

WAY = 0.0290
"""Distance between the holes of a slot, as a share of the length: the neck is 6 mm for 200 mm."""

_BOLT = 0.0200  # radius of the bolt, as a share of the length
_FLATS = 0.0120  # half of the distance between the flats of the bolt, as a share of the length
RIVET = 0.36
"""Radius of a rivet, in radii of the lap."""


def jaw_parts(forging: Forging, count: int, steel: ag.Material, *, phase: int) -> list[ag.Body]:
    """Make the visible flat, pipe grip and cutting edge of a jaw.

    The `count` teeth fit between those of the other jaw, whose phase is 1 or -1.
    """
    head, bodies = forging.head, []
    low, high = head.grips
    if not forging.keen:
        steps, start, end = max(2 * count, 1), forging.level(low), forging.level(high)
        deep = 0.00020 if count else 0.0  # height of the teeth, limited by the recess of the face [m]
        points: list[tuple[ag.Scalar, ag.Scalar]] = [
            (_MESH + phase * deep * (1 if at % 2 else -1), start + (end - start) * at / steps)
            for at in range(steps + 1)
        ]
        strip = ag.extrude(ag.polygon([*points, (_BEHIND, end), (_BEHIND, start)]), 0.03, axis=ag.Z)
        # between the sides of the jaw
        sides = [ag.rectangle(0.02, 0.96 * forging.height(at)) for at in (low, high)]
        bodies.append(ag.detail(strip & ag.loft(sides, [start, end], axis=ag.Y), "teeth", steel))
    if head.pipe[1]:
        bodies.append(_pipe_lining(forging, steel))
    if head.cuts[1] and not forging.keen:
        start, end = forging.level(head.cuts[0]), forging.level(head.cuts[1])
        half = 0.2 * forging.height(head.cuts[1])
        section = ag.polygon([(0.0001, 0.0), (_BEHIND, half), (_BEHIND, -half)])
        edge = ag.extrude(section, end - start, axis=ag.Y).at(y=(start + end) / 2)
        bodies.append(ag.detail(edge, "edge", steel))
    return bodies


def _pipe_lining(forging: Forging, steel: ag.Material) -> ag.Body:
    """Make the coarse teeth of the round pipe grip."""
    middle, half = forging.head.pipe
    y, deep, long, count = forging.level(middle), forging.pipe_depth, half * forging.jaw, 6
    inner, outer = [], []
    for index in range(2 * count + 1):
        angle, share = math.radians(-78 + 156 * index / (2 * count)), 0.97 if index % 2 else 0.80
        across, along = math.cos(angle), math.sin(angle)
        inner.append((share * deep * across, y + share * long * along))
        outer.append((1.1 * deep * across, y + 1.04 * long * along))
    strip = ag.extrude(ag.polygon([*inner, *reversed(outer)]), 0.9 * forging.height(middle), axis=ag.Z)
    return ag.detail(strip, "teeth", steel)


def bolt_slot(forging: Forging) -> ag.Profile:
    """Make the outline of the slot of two holes for a keyed bolt, the second at -x."""
    # few sides, so that a collider cannot combine two of them and reach into the hole
    hole = ag.regular_polygon(14, (_BOLT * forging.length + 0.00019) / math.cos(math.pi / 14))
    return hole | hole.at(-forging.slip)


def bolt(forging: Forging, finish: ag.Material) -> ag.Body:
    """Make the bolt, fixed in the plate of one half, with a nut beyond the plate of the other half."""
    radius, flats, top = _BOLT * forging.length, _FLATS * forging.length, forging.thick / 2
    reach = ag.sqrt(radius * radius - flats * flats)  # where the flats meet the round sides
    side = [(radius * math.cos(at), radius * math.sin(at)) for at in (-0.39, -0.13, 0.13, 0.39)]
    half = [(reach, -flats), *side, (reach, flats)]
    outline = ag.polygon([*half, *((-x, -y) for x, y in half)]).rotate(ALIGNED)
    shank = ag.extrude(outline, forging.thick + NUT, axis=ag.Z).at(z=NUT / 2)
    nut = ag.extrude(ag.regular_polygon(6, 1.75 * radius), NUT - 0.0003, axis=ag.Z, bevel=0.0003)
    nut = nut.at(z=top + 0.0003 + (NUT - 0.0003) / 2)
    ends = (0.0, 0.0, 0.0004 - top), (0.0, 0.0, -top - 0.0016)
    head = ag.cylinder_between(*ends, 1.7 * radius, bevel=0.0006)
    return ag.part([shank | nut, head], "pivot", finish)


Grip = Literal["bare", "dipped", "two_component"]

_FAT: dict[Grip, float] = {"bare": 0.0, "dipped": 0.0016, "two_component": 0.0040}
"""Thickness of sleeves [m]."""

_SWELL = {"dipped": (1.0,) * 7, "two_component": (1.12, 1.0, 1.02, 1.05, 1.04, 0.98, 0.94)}
"""Relative thickness of a sleeve along its length, from its upper end."""

_ROUND = ((-0.0004, 0.97), (0.0002, 1.0), (0.0014, 0.94), (0.0028, 0.80), (0.0037, 0.56))
"""Sections of the round end of a sleeve: distance below its last section with steel [m], relative size."""

_SOFT = (0.30, 0.58, 0.66, 0.66, 0.60, 0.42, 0.20)
"""Width of the soft part of a sleeve along its length, as a share."""


class _Ring(NamedTuple):
    """A section of a sleeve."""

    y: ag.Scalar  # position along y [m]
    x: ag.Scalar  # position of its middle along x [m]
    wide: ag.Scalar  # size along x [m]
    tall: ag.Scalar  # size along z [m]

    def below(self, down: float, share: float) -> "_Ring":
        """Return a smaller section below this one."""
        return _Ring(self.y - down, self.x + down / 12, share * self.wide, share * self.tall)


def sleeve_thickness(style: Grip, thick: ag.Float) -> ag.Float:
    """Return the largest thickness of the sleeved handles of pliers, over bars of a thickness [m]."""
    return (thick + 2 * _FAT[style]) * max(_SWELL.get(style, (1.0,)))


def _rings(forging: Forging, style: Grip, width: ag.Scalar, thick: ag.Scalar) -> list[_Ring]:
    """Return the sections of a sleeve, from its upper end."""
    fat, lead = 2 * _FAT[style], 0.78 if style == "two_component" else 0.88
    stations = zip(forging.course[2:], _SWELL[style], strict=True)
    rings = [_Ring(y, x, (width + fat) * swell, (thick + fat) * swell) for (y, x), swell in stations]
    rings = rings if style == "two_component" else rings[1:]
    y, x, wide, tall = rings[0]
    return [_Ring(y + 0.0026, x + 0.0005, lead * wide, lead * tall), *rings, rings[-1].below(0.0036, 0.56)]


def _along(rings: list[_Ring]) -> ag.Solid:
    sections = [
        ag.rectangle(wide, tall, radius=0.40 * ag.min_(wide, tall)).at(x) for _, x, wide, tall in rings[::-1]
    ]
    return ag.loft(sections, [ring.y for ring in rings[::-1]], axis=ag.Y)


def off_middle(forging: Forging, style: Grip, width: ag.Scalar) -> ag.Scalar:
    """Return the least distance of the closed handles from the middle plane, near their upper ends [m]."""
    off = [-x - width / 2 for _, x in forging.course[1:3]]
    if style != "bare":
        off += [-ring.x - ring.wide / 2 for ring in _rings(forging, style, width, width)[:3]]
    return reduce(ag.min_, off)


class Sleeve:
    """The sleeve of a handle: dipped in PVC, or a thick sleeve of two plastics."""

    def __init__(self, forging: Forging, style: Grip, width: ag.Scalar, thick: ag.Scalar) -> None:
        self._rings = _rings(forging, style, width, thick)
        self.solid = _along(self._rings)

    def parts(
        self, finish: ag.Material, inlay: ag.Material | None, *, over: bool, grasp: ag.Frame
    ) -> ag.Body:
        """Make the sleeve with its visible round end over the cone, and its soft part."""
        end = _along([self._rings[-2].below(down, share) for down, share in _ROUND])
        name = "upper_grip" if over else "lower_grip"
        body = ag.part(self.solid, "grip", finish, name=name, grasp=grasp)
        body = ag.weld(body, ag.detail(end, "grip", finish))
        if inlay is None:
            return body
        rings = zip(_SOFT, self._rings[1:], strict=False)
        soft = _along([_Ring(y, x, share * wide, tall) for share, (y, x, wide, tall) in rings])
        return ag.weld(body, ag.detail(soft.at(z=-_PROUD if over else _PROUD), "grip", inlay))


def spring(forging: Forging, *, width: ag.Scalar) -> ag.Body:
    """Make the visible leaf spring of a handle."""
    y, x = forging.course[3]
    return leaf_spring((x + 0.42 * width, y), -forging.clear_below - 0.55 * forging.lap)
