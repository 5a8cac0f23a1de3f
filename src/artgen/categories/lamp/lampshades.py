"""Lampshades, with sockets and bulbs inside."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import recess

SOCKET = 0.042
"""Length of a socket below its mouth [m]."""

SOCKET_RADIUS = 0.0185
"""Radius of the ring at the mouth of a socket [m]."""

BULB = 0.092
"""Length of a bulb outside its socket [m]."""

BULB_RADIUS = 0.030
"""Radius of a bulb [m]."""

_LAMP = ag.material("bulb").with_(density=420.0)  # an LED bulb weighs 60 g: thin shell, driver and heat sink


def bulb() -> ag.Body:
    """Make an upright bulb in a socket with its mouth in the plane z = 0."""
    # a cone tangent to the ball
    neck = ag.frustum(0.0135, 0.02885, 0.0538).at(0.0, 0.0, 0.0269)
    ball = ag.sphere(BULB_RADIUS).at(0.0, 0.0, 0.062)
    return ag.weld(ag.part(ball, "bulb", _LAMP), ag.part(neck, "bulb", _LAMP))


def socket(finish: ag.Material, *, length: ag.Scalar = SOCKET) -> ag.Body:
    """Make a socket below its mouth in the plane z = 0, with a bulb in it."""
    sleeve = ag.cylinder(0.0160, length, bevel=0.0015).at(0.0, 0.0, -0.5 * length)
    mouth = ag.cylinder(SOCKET_RADIUS, 0.008, bevel=0.0012).at(0.0, 0.0, -0.004)
    groove = ag.cylinder(0.0162, 0.0012).at(0.0, 0.0, -0.011)
    return ag.weld(
        ag.part(sleeve, "socket", finish),
        ag.part(mouth, "socket", finish),
        ag.detail(groove, "socket", recess(finish)),
    )


def lamp_holder(finish: ag.Material, *, length: ag.Scalar = SOCKET) -> ag.Body:
    """Make an upright socket with its bulb, with the mouth of the socket in the plane z = 0."""
    return ag.weld(socket(finish, length=length), bulb())


def vents(
    radius: ag.Scalar, level: ag.Scalar, finish: ag.Material, *, count: int = 10, height: ag.Scalar = 0.012
) -> ag.Body:
    """Make the slots around a housing that cool a bulb, visual only."""
    slot = ag.box(0.0030, 0.0030, height, bevel=0.0012)
    places = ag.ring_points((0.0, 0.0, level), radius - 0.0011, count=count)
    return ag.detail(ag.array(slot, at=places), "socket", recess(finish))


ShadeKind = Literal["cone", "drum", "dome", "curved", "globe"]
"""Shape of a shade; a curved shade is a bell."""

Point = tuple[ag.Scalar, ag.Scalar]
"""Radius and height of a point of a shade's outline [m]."""

NECK = 0.024
"""Radius of a metal shade at the opening for its housing [m]."""

HOUSING = 0.0215
"""Radius of the housing on a metal shade, which holds the socket [m]."""

HOUSING_TOP = 0.030
"""Height of the housing above the shade [m]."""

_WALL = 0.0015  # wall thickness of a straight metal shade [m]
_CLOTH = 0.0018  # thickness of laminated fabric [m]
_SIDES = 16  # number of sides of the collision shell of a curved shade
_ROUND = 28  # number of sides of a straight shade: 1.3 mm off a circle of 0.2 m
_SKIN = 0.0005  # thickness of the visible skins [m]
_UNDER = 0.0008  # least depth of the collision shell below the outer skin [m]
_SAG = 1.0 - math.cos(math.pi / _SIDES)  # sagitta of the facets, as a share of the radius
_ARCHED = 0.018  # bulge of a third of a dome's outline, as a share of the radius


def spun(finish: ag.Material) -> ag.Material:
    """Return a finish on spun aluminum, the material of light metal shades."""
    return finish.with_(name=f"{finish.name}_spun", density=2700.0)


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
            widest = ag.max_(
                widest, ag.atan2(radius, deep) + ag.atan2(beside, ag.sqrt(far - beside * beside))
            )
        return widest


def metal_head(
    kind: ShadeKind,
    *,
    radius: ag.Scalar,
    depth: ag.Scalar,
    finish: ag.Material,
    lining: ag.Material,
    trim: ag.Material,
) -> Head:
    """Make a metal shade, open below, with its bulb."""
    top = -HOUSING_TOP
    points = [(r, top + z) for r, z in _metal_outline(kind, radius, depth)]
    low, high = points[0], points[-1]
    housing = ag.cylinder(HOUSING, HOUSING_TOP + 0.006, bevel=0.002).at(
        0.0, 0.0, -0.5 * (HOUSING_TOP + 0.006)
    )
    lid = ag.cylinder(high[0], 0.0026, bevel=0.0010).at(0.0, 0.0, high[1] + 0.0003)
    mouth = ag.cylinder(0.0180, 0.012, bevel=0.0012).at(0.0, 0.0, top - 0.010)
    if kind in ("cone", "drum"):
        skins = _straight(points, spun(finish), lining, _rim_grasp(points[0], points[1], _ROUND, 0.0))
    else:
        hold = _rim_grasp(points[0], points[1], _SIDES, _UNDER)
        skins = _curved(kind, points, spun(finish), lining, hold)
    plug = ag.cylinder(high[0] - 0.0016, 0.010, bevel=0.0010).at(0.0, 0.0, high[1] - 0.0045)
    body = ag.weld(
        *skins,
        *([] if kind == "drum" else [ag.part(plug, "shade", spun(finish))]),
        ag.part(lid, "shade", spun(finish)),
        ag.part(housing, "socket", trim.with_(name=f"{trim.name}_housing", density=1100.0)),
        ag.part(mouth, "socket", ag.material("black_abs")),
        bulb().rotate((1.0, 0.0, 0.0), math.pi).at(0.0, 0.0, top - 0.014),
        vents(HOUSING, -0.5 * HOUSING_TOP, trim),
    )
    reach = ag.vector(low[0], 0.0, low[1]).norm()
    corners = ((HOUSING, 0.0), *((r, -z) for r, z in points))
    return Head(body, reach, corners)


def _metal_outline(kind: str, radius: ag.Scalar, depth: ag.Scalar) -> list[Point]:
    """Return the outline from the rim up to the neck, with its top at 0."""
    match kind:
        case "cone":
            return [(radius, -depth), (NECK, 0.0)]
        case "drum":
            return [(radius, -depth), (radius, 0.0)]
        case "curved":  # a bell, flared at the rim
            inner = 0.62 * (radius - NECK) + NECK
            return [
                (radius, -depth),
                (inner + 0.10 * (radius - NECK), -0.66 * depth),
                (NECK + 0.46 * (radius - NECK), -0.26 * depth),
                (NECK, 0.0),
            ]
        case _:
            turns = (0.0, 0.40, 0.80, 1.20)
            flat = [(math.cos(turn), math.sin(turn)) for turn in turns]
            across, up = radius - NECK, depth / flat[-1][1]
            last = flat[-1][0]
            return [(NECK + across * (c - last) / (1.0 - last), up * s - depth) for c, s in flat]


def _line(points: list[Point]) -> list[tuple[ag.Scalar, float, ag.Scalar]]:
    return [(r, 0.0, z) for r, z in points]


def _straight(
    points: list[Point], finish: ag.Material, lining: ag.Material, grasp: ag.Frame
) -> list[ag.Body]:
    path = ag.polyline(_line(points))
    shell = ag.revolve(ag.half_section(path, wall=_WALL), sides=_ROUND)
    inside = ag.revolve(ag.half_section(path, wall=0.0003, inset=_WALL - 0.0001), sides=_ROUND)
    (radius, level), *_ = points
    bead = ag.revolve(ag.rectangle(0.0030, 0.0026, radius=0.0012).at(radius - 0.0008, level + 0.0013))
    return [
        ag.part(shell, "shade", finish, grasp=grasp),
        ag.detail(inside, "shade", lining),
        ag.detail(bead, "shade", finish),
    ]


def _curved(
    kind: ShadeKind,
    points: list[Point],
    finish: ag.Material,
    lining: ag.Material,
    grasp: ag.Frame | tuple[()],
) -> list[ag.Body]:
    """Make a smooth shade: two visible skins, and the faceted collision shell between them."""
    smooth, flat = ag.spline(_line(points)), ag.polyline(_line(points))
    radius, level = points[0]
    deep = _UNDER + (0.010 * radius if kind == "curved" else 0.0)
    thick = deep + 0.0016 + (_SAG + _ARCHED) * radius + 0.0004
    # a flared rim ends lower on the inside than on the outside
    low, tall = (-0.0028, 0.0062) if kind == "curved" else (-0.0002, 0.0032)
    ring = ag.rectangle(thick + 0.001, tall, radius=0.0014)
    bead = ag.revolve(ring.at(radius - thick / 2.0, level + low + tall / 2.0))
    return [
        ag.part(
            ag.revolve(ag.half_section(flat, wall=0.0016, inset=deep), sides=_SIDES),
            "shade",
            finish,
            grasp=grasp,
        ),
        ag.detail(ag.revolve(ag.half_section(smooth, wall=_SKIN)), "shade", finish),
        ag.detail(ag.revolve(ag.half_section(smooth, wall=_SKIN, inset=thick)), "shade", lining),
        ag.detail(bead, "shade", finish),
    ]


def _rim_grasp(low: Point, high: Point, sides: int, under: ag.Scalar, *, upper: bool = False) -> ag.Frame:
    """Return the grasp of a rim in front, with one finger inside, from below or (`upper`) from above."""
    turn = math.pi * (1.5 + (0.0 if sides % 4 == 2 else 1.0 / sides))  # middle of a facet
    out = ag.vector(math.cos(turn), math.sin(turn), 0.0)
    share = math.cos(math.pi / sides)
    along = ag.vector(0.0, 0.0, high[1] - low[1]) + out * ((high[0] - low[0]) * share)
    length = along.norm()
    up = along / length
    inward = under + 0.0008
    closing = ag.vector(0.0, 0.0, (high[0] - low[0]) * share / length) - out * ((high[1] - low[1]) / length)
    inside = closing * (-inward if upper else inward)
    at = out * (low[0] * share) + ag.vector(0.0, 0.0, low[1]) + up * 0.006 + inside
    return ag.frame(at, approach=up, closing=closing)


def dome_path(radius: ag.Scalar, height: ag.Scalar, top: ag.Scalar) -> list[Point]:
    """Return the outline of a dome from its rim at z = 0 up to a small opening of radius `top` [m]."""
    return [(r, z + height) for r, z in _scaled(radius, height, top)]


def _scaled(radius: ag.Scalar, height: ag.Scalar, top: ag.Scalar) -> list[Point]:
    flat = [(math.cos(turn), math.sin(turn)) for turn in (0.0, 0.45, 0.9, 1.35)]
    last, high = flat[-1]
    return [(top + (radius - top) * (c - last) / (1.0 - last), height * (s / high - 1.0)) for c, s in flat]


@dataclass(frozen=True)
class FabricShade:
    """A shade on a spider, which turns on a stud about the z axis."""

    body: ag.Body  # link `shade`; the middle of its lower rim is the origin
    hub: ag.Float  # height of the lower face of the spider's hub [m]
    kind: ShadeKind  # shape of the shade


STUD = 0.0032
"""Radius of the stud for a spider [m]."""

HUB = 0.006
"""Height of the hub of a spider [m]."""

_PLAY = 0.0004  # gap between the hub and its stud [m]


def drop_of(kind: ShadeKind) -> float:
    """Return the depth of the spider of a cloth shade below its upper rim [m].

    The depth leaves space at the finial for a hand along the slant of a cone.
    """
    return 0.020 if kind == "drum" else 0.030


def spider_shade(
    kind: ShadeKind,
    *,
    top: ag.Scalar,
    bottom: ag.Scalar,
    height: ag.Scalar,
    finish: ag.Material,
    lining: ag.Material,
    trim: ag.Material,
    wire: ag.Material,
) -> FabricShade:
    """Make a shade on three spokes: a cone, a drum or a bell of cloth, or a dome of metal."""
    drop = drop_of(kind)
    level: ag.Scalar = height - drop
    reach: ag.Scalar | None = None  # reach of the spokes; a dome needs none
    match kind:
        case "dome":
            points = dome_path(bottom, height, 0.020)
            bodies = _curved(kind, points, spun(finish), lining, ())
            cap = ag.tube(0.0215, STUD + _PLAY, 0.0026, bevel=0.0008).at(0.0, 0.0, height - 0.0006)
            knob = ag.sphere(0.0095).at(0.0, 0.0, height + 0.0145)
            collar = ag.cylinder(0.0064, 0.007, bevel=0.0008).at(0.0, 0.0, height + 0.0040)
            hold = ag.grasp_on(knob, approach=(0.0, 0.0, -1.0), closing=(1.0, 0.0, 0.0))
            bodies += [
                ag.part(cap, "shade", spun(finish)),
                ag.part(collar, "finial", wire),
                ag.part(knob, "finial", wire, name="shade", grasp=hold),
            ]
            level = height - 0.005
        case "curved":
            points = [
                (bottom, 0.0),
                (top + 0.52 * (bottom - top), 0.34 * height),
                (top + 0.17 * (bottom - top), 0.67 * height),
                (top, height),
            ]
            under = _UNDER + 0.010 * bottom
            bodies = _cloth(points, finish, lining, trim, sides=_SIDES, under=under)
            reach = top + 0.17 * (bottom - top) * drop / (0.33 * height)
            reach = (reach - under) * math.cos(math.pi / _SIDES)
        case _:
            points = [(bottom, 0.0), (top, height)]
            bodies = _cloth(points, finish, lining, trim, sides=_ROUND, under=_UNDER)
            reach = (top + (bottom - top) * drop / height - _UNDER) * math.cos(math.pi / _ROUND)
    spokes = [] if reach is None else _spokes(reach, level + HUB / 2.0, wire)
    hub = ag.tube(STUD + 0.0038, STUD + _PLAY, HUB, bevel=0.0006).at(0.0, 0.0, level + HUB / 2.0)
    return FabricShade(ag.weld(*bodies, ag.part(hub, "shade", wire), *spokes), ag.vector(z=level).z, kind)


def _spokes(reach: ag.Scalar, level: ag.Scalar, wire: ag.Material) -> list[ag.Body]:
    """Make three spokes from the hub to the shade; none is in front, at the grasp of the rim."""
    start, end = STUD + 0.0025, reach - 0.0008
    bodies = []
    for turn in (math.pi / 2.0, math.pi * 7.0 / 6.0, math.pi * 11.0 / 6.0):
        out = ag.vector(math.cos(turn), math.sin(turn), 0.0)
        spoke = ag.cylinder_between(out * start + ag.Z * level, out * end + ag.Z * level, 0.0017)
        bodies.append(ag.part(spoke, "shade", wire))
    return bodies


def _cloth(
    points: list[Point],
    finish: ag.Material,
    lining: ag.Material,
    trim: ag.Material,
    *,
    sides: int,
    under: ag.Scalar,
) -> list[ag.Body]:
    """Make a cloth shade: visible skin and lining, the faceted shell between them, two bands."""
    sag = 1.0 - math.cos(math.pi / sides)
    within = [(r - (under + _CLOTH + 0.0005 + sag * r), z) for r, z in points]
    outside, inside = (
        ag.spline(_line(each)) if len(each) > 2 else ag.polyline(_line(each)) for each in (points, within)
    )
    shell = ag.revolve(ag.half_section(ag.polyline(_line(points)), wall=_CLOTH, inset=under), sides=sides)
    grasp = _rim_grasp(points[-1], points[-2], sides, under, upper=True)
    bands = []
    for end, beside in ((0, 1), (-1, -2)):
        first, second = _rim(points[end], points[beside])
        thick = points[end][0] - within[end][0] + _SKIN
        bands.append(ag.detail(_band(*((second, first) if end else (first, second)), thick), "shade", trim))
    return [
        ag.part(shell, "shade", finish, grasp=grasp),
        ag.detail(ag.revolve(ag.half_section(outside, wall=_SKIN)), "shade", finish),
        ag.detail(ag.revolve(ag.half_section(inside, wall=_SKIN)), "shade", lining),
        *bands,
    ]


def _rim(start: Point, towards: Point, long: ag.Scalar = 0.009) -> tuple[Point, Point]:
    """Return the ends of the first 9 mm of an outline."""
    (r, z), (r_far, z_far) = start, towards
    share = long / ag.sqrt((r_far - r) * (r_far - r) + (z_far - z) * (z_far - z))
    return start, (r + share * (r_far - r), z + share * (z_far - z))


def _band(low: Point, high: Point, thick: ag.Scalar) -> ag.Solid:
    """Make a band folded over the rim of a shade of some thickness [m]."""
    return ag.revolve(ag.half_section(ag.polyline(_line([low, high])), wall=thick + 0.0014, inset=-0.0007))


def globe(radius: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a closed globe of opal glass: the link `shade` about the origin.

    Its mass is that of a globe of 3 mm glass.
    """
    # 3 mm of glass of 2500 kg/m3 at a radius of 0.1 m
    hollow = finish.with_(name=f"{finish.name}_globe", density=230.0)
    return ag.part(ag.sphere(radius), "shade", hollow)
