"""Lampshades: metal heads for arms, shades of cloth or metal on a harp, and globes; sockets and bulbs."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.lamp.electrics import Chain
from artgen.categories.lamp.finish import GLOBE, spun
from artgen.categories.shared.finish import recess
from artgen.nodes.handles import Path

ShadeKind = Literal["cone", "drum", "dome", "curved", "globe"]  # a curved shade is a bell
Point = tuple[ag.Scalar, ag.Scalar]  # radius and height of a point of an outline, from the rim up [m]

SOCKET = 0.042  # length of a socket below its mouth [m]

BULB = ag.material("bulb").with_(density=420.0)  # an LED bulb weighs 60 g: thin shell, driver and heat sink
_NECK = 0.024  # radius of a metal shade at the opening for its housing [m]
_HOUSING = 0.0215  # radius of the housing on a metal shade, which holds the socket [m]
_HOUSING_TOP = 0.030  # height of the housing above the shade [m]
_WALL = 0.0015  # wall thickness of a straight metal shade [m]
_CLOTH = 0.0018  # thickness of laminated fabric [m]
_SIDES = 16  # number of sides of the collision shell of a curved shade
_ROUND = 28  # number of sides of a straight shade: 1.3 mm off a circle of 0.2 m
_SKIN = 0.0005  # thickness of the visible skins [m]
_UNDER = 0.0008  # least depth of the collision shell below the outer skin [m]
_SAG = 1 - math.cos(math.pi / _SIDES)  # sagitta of the facets, as a share of the radius
_ARCHED = 0.018  # bulge of a third of a dome's outline, as a share of the radius
_STUD = 0.0032  # radius of the stud for a spider [m]
_HUB = 0.006  # height of the hub of a spider [m]
_PLAY = 0.0004  # gap around the hub of a spider [m]
_SEAT = 0.0027  # height of the hub above the bar of a harp [m]
_BOW = 0.042  # half of the width of a harp [m]
_HANGS_LOW = (
    "the shade would touch the floor, the base or the switch on the cord: raise height, or lower "
    "shade_radius or shade_height"
)


def _bulb() -> ag.Body:
    """Make an upright bulb in a socket with its mouth in the plane z = 0: a cone tangent to a ball."""
    neck = ag.frustum(0.0135, 0.02885, 0.0538).at(z=0.0269)
    return ag.part([ag.sphere(0.030).at(z=0.062), neck], "bulb", BULB)


def _holder(finish: ag.Material) -> ag.Body:
    """Make an upright socket with its bulb, with the mouth of the socket in the plane z = 0."""
    sleeve = ag.cylinder(0.0160, SOCKET, bevel=0.0015).at(z=-SOCKET / 2)
    mouth = ag.cylinder(0.0185, 0.008, bevel=0.0012).at(z=-0.004)
    groove = ag.cylinder(0.0162, 0.0012).at(z=-0.011)
    socket = ag.part([sleeve, mouth], "socket", finish)
    return ag.weld(socket, ag.detail(groove, "socket", recess(finish)), _bulb())


def _path(points: Sequence[Point], *, smooth: bool = False) -> Path:
    line = [(r, 0, z) for r, z in points]
    return ag.spline(line) if smooth else ag.polyline(line)


def _dome(radius: ag.Scalar, top: float, height: ag.Scalar, steepest: float) -> list[Point]:
    """Return the outline of a dome from its rim at z = 0 up to an opening of radius `top` [m]."""
    flat = [(math.cos(steepest * step / 3), math.sin(steepest * step / 3)) for step in range(4)]
    last, high = flat[-1]
    return [(top + (radius - top) * (c - last) / (1 - last), height * s / high) for c, s in flat]


@dataclass(frozen=True)
class Head:
    """A metal shade with its housing, socket and bulb, which shines along -z."""

    body: ag.Body  # link `shade`; the top of its housing is the origin
    reach: ag.Float  # distance of its farthest point from the origin [m]
    # radius and depth below the origin of the points nearest to an arm behind the shade
    corners: tuple[Point, ...]

    def spread(self, above: ag.Scalar, beside: ag.Scalar) -> ag.Float:
        """Return the half angle of the shade as seen from a pivot above the origin [rad]."""
        widest: ag.Float = ag.sqrt(0.0)
        for radius, depth in self.corners:
            deep = depth + above
            far = radius * radius + deep * deep
            # angle to the corner, plus the angle for the half width of the arm
            angle = ag.atan2(radius, deep) + ag.atan2(beside, ag.sqrt(far - beside * beside))
            widest = ag.max_(widest, angle)
        return widest


def metal_head(
    kind: ShadeKind,
    radius: ag.Scalar,
    depth: ag.Scalar,
    finish: ag.Material,
    lining: ag.Material,
    trim: ag.Material,
) -> Head:
    """Make a metal shade, open below, with its bulb."""
    wide = radius - _NECK
    outlines: dict[str, list[Point]] = {
        "cone": [(radius, 0.0), (_NECK, depth)],
        "drum": [(radius, 0.0), (radius, depth)],
        # a bell, flared at the rim
        "curved": [
            (radius, 0.0),
            (_NECK + 0.72 * wide, 0.34 * depth),
            (_NECK + 0.46 * wide, 0.74 * depth),
            (_NECK, depth),
        ],
    }
    outline = outlines.get(kind) or _dome(radius, _NECK, depth, 1.20)
    points = [(r, z - depth - _HOUSING_TOP) for r, z in outline]
    metal = spun(finish)
    if kind in ("cone", "drum"):
        skins = _straight(points, metal, lining)
    else:
        hold = _rim_grasp(points[0], points[1], _SIDES, _UNDER)
        skins = _curved(points, metal, lining, hold, flared=kind == "curved")
    (rim, low), (opening, high) = points[0], points[-1]
    lid = ag.cylinder(opening, 0.0026, bevel=0.0010).at(z=high + 0.0003)
    plug = ag.cylinder(opening - 0.0016, 0.010, bevel=0.0010).at(z=high - 0.0045)
    housing = ag.cylinder_between((0, 0, -_HOUSING_TOP - 0.006), (0, 0, 0), _HOUSING, bevel=0.002)
    mouth = ag.cylinder(0.0180, 0.012, bevel=0.0012).at(z=-_HOUSING_TOP - 0.010)
    slot = ag.box(0.0030, 0.0030, 0.012, bevel=0.0012)
    slots = ag.array(slot, at=ag.ring_points((0, 0, -_HOUSING_TOP / 2), _HOUSING - 0.0011, count=10))
    body = ag.weld(
        skins,
        ag.part([lid] if kind == "drum" else [plug, lid], "shade", metal),
        ag.part(housing, "socket", trim.with_(name=f"{trim.name}_housing", density=1100.0)),
        ag.part(mouth, "socket", ag.material("black_abs")),
        _bulb().rotate(ag.X, math.pi).at(z=-_HOUSING_TOP - 0.014),
        ag.detail(slots, "socket", recess(trim)),  # slots that cool the bulb
    )
    corners = ((_HOUSING, 0.0), *((r, -z) for r, z in points))
    return Head(body, ag.vector(rim, 0, low).norm(), corners)


def _straight(points: list[Point], finish: ag.Material, lining: ag.Material) -> ag.Body:
    path, (radius, level) = _path(points), points[0]
    shell = ag.revolve(ag.half_section(path, wall=_WALL), sides=_ROUND)
    inside = ag.revolve(ag.half_section(path, wall=0.0003, inset=_WALL - 0.0001), sides=_ROUND)
    bead = ag.revolve(ag.rectangle(0.0030, 0.0026, radius=0.0012).at(radius - 0.0008, level + 0.0013))
    return ag.weld(
        ag.part(shell, "shade", finish, grasp=_rim_grasp(points[0], points[1], _ROUND, 0.0)),
        ag.detail(inside, "shade", lining),
        ag.detail(bead, "shade", finish),
    )


def _curved(
    points: list[Point],
    finish: ag.Material,
    lining: ag.Material,
    grasp: ag.Frame | tuple[()] = (),
    *,
    flared: bool = False,
) -> ag.Body:
    """Make a smooth shade: two visible skins, and the faceted collision shell between them."""
    smooth, (radius, level) = _path(points, smooth=True), points[0]
    deep = _UNDER + (0.010 * radius if flared else 0.0)
    thick = deep + 0.0016 + (_SAG + _ARCHED) * radius + 0.0004
    # a flared rim ends lower on the inside than on the outside
    low, tall = (-0.0028, 0.0062) if flared else (-0.0002, 0.0032)
    ring = ag.rectangle(thick + 0.001, tall, radius=0.0014).at(radius - thick / 2, level + low + tall / 2)
    shell = ag.revolve(ag.half_section(_path(points), wall=0.0016, inset=deep), sides=_SIDES)
    outside = ag.revolve(ag.half_section(smooth, wall=_SKIN))
    inside = ag.revolve(ag.half_section(smooth, wall=_SKIN, inset=thick))
    return ag.weld(
        ag.part(shell, "shade", finish, grasp=grasp),
        ag.detail([outside, ag.revolve(ring)], "shade", finish),
        ag.detail(inside, "shade", lining),
    )


def _rim_grasp(low: Point, high: Point, sides: int, under: ag.Scalar, *, upper: bool = False) -> ag.Frame:
    """Return the grasp of a rim in front, with one finger inside, from below or (`upper`) from above."""
    turn = math.pi * (1.5 + (0.0 if sides % 4 == 2 else 1 / sides))  # middle of a facet
    out = ag.vector(math.cos(turn), math.sin(turn))
    share = math.cos(math.pi / sides)
    across, rise = (high[0] - low[0]) * share, high[1] - low[1]
    length = ag.sqrt(across * across + rise * rise)
    up = (ag.Z * rise + out * across) / length
    closing = (ag.Z * across - out * rise) / length
    inward = -(under + 0.0008) if upper else under + 0.0008
    at = out * (low[0] * share) + ag.Z * low[1] + up * 0.006 + closing * inward
    return ag.frame(at, approach=up, closing=closing)


def _cloth(
    points: list[Point], finish: ag.Material, lining: ag.Material, *, sides: int, under: ag.Scalar
) -> ag.Body:
    """Make a cloth shade: visible skin and lining, the faceted shell between them, two bands."""
    sag = 1 - math.cos(math.pi / sides)
    within = [(r - (under + _CLOTH + 0.0005 + sag * r), z) for r, z in points]
    outside, inside = (
        ag.revolve(ag.half_section(_path(each, smooth=len(each) > 2), wall=_SKIN))
        for each in (points, within)
    )
    shell = ag.revolve(ag.half_section(_path(points), wall=_CLOTH, inset=under), sides=sides)
    bands = []  # folded over the rims, 9 mm high
    for end, beside in ((0, 1), (-1, -2)):
        (r, z), (r_far, z_far) = points[end], points[beside]
        share = 0.009 / ag.sqrt((r_far - r) * (r_far - r) + (z_far - z) * (z_far - z))
        ends = [points[end], (r + share * (r_far - r), z + share * (z_far - z))]
        wall = r - within[end][0] + _SKIN + 0.0014
        line = _path(ends[::-1] if end else ends)
        bands.append(ag.revolve(ag.half_section(line, wall=wall, inset=-0.0007)))
    grasp = _rim_grasp(points[-1], points[-2], sides, under, upper=True)
    return ag.weld(
        ag.part(shell, "shade", finish, grasp=grasp),
        ag.detail([outside, *bands], "shade", finish),
        ag.detail(inside, "shade", lining),
    )


@dataclass(frozen=True)
class Spider:
    """A shade on three spokes, which turns on a harp: a cone, a drum or a bell of cloth, or a metal dome."""

    kind: ShadeKind
    top: ag.Scalar  # radius of the upper rim [m]
    bottom: ag.Scalar  # radius of the lower rim [m]
    height: ag.Scalar  # [m]
    finish: ag.Material
    lining: ag.Material
    wire: ag.Material

    @property
    def drop(self) -> float:
        """Depth of the hub of a cloth shade, with space for a hand along the slant of a cone [m]."""
        return 0.020 if self.kind == "drum" else 0.030

    @property
    def rise(self) -> ag.Float:
        """Height of the harp above the mouth of its socket [m].

        A cloth shade hides the socket: its rim is about 34 mm below the mouth. A dome ends near the mouth.
        """
        below = 0.004 if self.kind == "dome" else self.drop + 0.037
        return ag.clamp(self.height - below, 0.112, 0.24)

    @property
    def crown(self) -> ag.Float:
        """Height of the finial above the mouth of the socket [m]."""
        return self.rise + 0.030

    def on(
        self, base: ag.Body, mouth: ag.Scalar, friction: ag.Scalar, over: ag.Scalar, chain: Chain | None
    ) -> ag.Body:
        """Put a socket with its bulb, a harp and this shade on a base.

        The shade rests on the harp and turns on its stud; friction under its weight and the finial holds it.
        """
        top = mouth + self.rise
        bodies = [base, _holder(self.wire).at(z=mouth), *self._harp(mouth - 0.005, top)]
        hub = self.height - (0.005 if self.kind == "dome" else self.drop)
        level = top + _SEAT + _PLAY - hub  # height of the lower rim
        if chain is not None:
            bodies.append(chain.beside(mouth, level, self.wire))
        turn = ag.Revolute(
            "shade_turn", axis=ag.Z, friction=friction, damping=0.01, armature=0.0002, effort=3.0
        )
        shade = self._domed(hub) if self.kind == "dome" else self._spoked(hub)
        return ag.weld(*bodies).attach(shade.at(z=level).require(level > over, _HANGS_LOW), turn)

    def _hub(self, level: ag.Scalar) -> ag.Solid:
        return ag.tube(_STUD + 0.0038, _STUD + _PLAY, _HUB, bevel=0.0006).at(z=level + _HUB / 2)

    def _domed(self, level: ag.Scalar) -> ag.Body:
        metal, height = spun(self.finish), self.height
        cap = ag.tube(0.0215, _STUD + _PLAY, 0.0026, bevel=0.0008).at(z=height - 0.0006)
        collar = ag.cylinder(0.0064, 0.007, bevel=0.0008).at(z=height + 0.0040)
        knob = ag.sphere(0.0095).at(z=height + 0.0145)
        hold = ag.grasp_on(knob, approach=-ag.Z, closing=ag.X)
        return ag.weld(
            _curved(_dome(self.bottom, 0.020, height, 1.35), metal, self.lining),
            ag.part(cap, "shade", metal),
            ag.part([knob, collar], "finial", self.wire, name="shade", grasp=hold),
            ag.part(self._hub(level), "shade", self.wire),
        )

    def _spoked(self, level: ag.Scalar) -> ag.Body:
        top, bottom, height = self.top, self.bottom, self.height
        points = [(bottom, 0.0), (top, height)]
        sides = _ROUND
        under: ag.Scalar = _UNDER
        reach = top + (bottom - top) * self.drop / height - under
        if self.kind == "curved":
            shares = ((0.52, 0.34), (0.17, 0.67))
            points[1:1] = [(top + share * (bottom - top), z * height) for share, z in shares]
            sides, under = _SIDES, _UNDER + 0.010 * bottom
            reach = top + 0.17 * (bottom - top) * self.drop / (0.33 * height) - under
        end = reach * math.cos(math.pi / sides) - 0.0008
        solids = [self._hub(level)]
        for turn in (math.pi / 2, math.pi * 7 / 6, math.pi * 11 / 6):  # none is at the grasp in front
            out, up = ag.vector(math.cos(turn), math.sin(turn)), ag.Z * (level + _HUB / 2)
            solids.append(ag.cylinder_between(out * (_STUD + 0.0025) + up, out * end + up, 0.0017))
        cloth = _cloth(points, self.finish, self.lining, sides=sides, under=under)
        return ag.weld(cloth, ag.part(solids, "shade", self.wire))

    def _harp(self, saddle: ag.Scalar, top: ag.Scalar) -> list[ag.Body]:
        """Make the wire bow that carries the shade around the bulb, with its stud and finial."""
        low, high = saddle + 0.30 * (top - saddle), saddle + 0.70 * (top - saddle)
        half = [(0.012, 0, top), (_BOW, 0, high), (_BOW, 0, low), (0.014, 0, saddle)]
        course = ag.polyline([*((-x, y, z) for x, y, z in reversed(half)), *half])
        stud = _HUB + _SEAT + 0.0003
        # a stud without a finial ends inside the hub
        pin = stud + (-0.003 if self.kind == "dome" else 0.004)
        solids = [
            ag.sweep(ag.circle(0.0019), course),
            ag.box(0.034, 0.010, 0.0030, bevel=0.0008).at(z=saddle),
            ag.cylinder(0.0085, 0.0030, bevel=0.0008).at(z=top + 0.0012),
            ag.cylinder(_STUD, pin).at(z=top + pin / 2),
        ]
        harp = ag.part(solids, "harp", self.wire)
        if self.kind == "dome":
            return [harp]
        collar = ag.cylinder(0.0062, 0.004, bevel=0.0008).at(z=top + stud + 0.0025)
        knob = ag.sphere(0.0085).at(z=top + stud + 0.0095)
        return [harp, ag.part([collar, knob], "finial", self.wire)]


def globed(base: ag.Body, top: ag.Scalar, radius: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Put a globe of opal glass on a base with its top at a height."""
    cup = ag.tube(0.030, 0.026, 0.016, bevel=0.0012).at(z=top + 0.008)
    floor = ag.cylinder(0.029, 0.004, bevel=0.0012).at(z=top + 0.002)
    sunk = 0.010 - 0.0045  # depth of a globe of 0.1 m in a ring of 26 mm
    globe = ag.sphere(radius).at(z=top + sunk + radius)
    return ag.weld(base, ag.part(globe, "shade", GLOBE), ag.part([cup, floor], "socket", metal))
