"""Cooktops: the layout of burners and dials, burners, zones and grates.

View from above: x to the right, y to the back, the origin in the middle of the plate.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Literal, get_args

import artgen as ag
from artgen import details, signals
from artgen._arrays import cached_property

BurnerKind = Literal["gas", "radiant", "coil", "induction"]
"""Gas flames, radiant heaters under glass, steel tubes, or induction coils under glass."""

DialSide = Literal["front", "left", "right", "back"]
"""Border of the plate with the dials."""

BurnerSize = Literal["small", "medium", "large", "wok"]
"""Sizes of burners; in shops: simmer, standard, rapid, wok."""

EDGE = 0.013
"""Distance from the edge of the plate to the print around a dial [m]."""

PRINT = 0.009
"""Width of the print around a dial [m]."""

SIGN = 0.014
"""Size of the sign beside a dial that shows its burner [m]."""

_MARGIN = 0.016  # distance from the edge of the plate to the field of the burners [m]
_END = 0.030  # distance from the edge of the plate to the rim of the first dial of a row [m]

# sizes of the burners by their number and that of the rows: columns from left to right, each from the front
_SIZES: dict[tuple[int, int], tuple[tuple[BurnerSize, ...], ...]] = {
    (2, 1): (("large",), ("medium",)),
    (3, 1): (("medium",), ("wok",), ("small",)),
    (3, 2): (("small", "medium"), ("wok",)),
    (4, 1): (("medium",), ("large",), ("medium",), ("small",)),
    (4, 2): (("large", "medium"), ("small", "medium")),
    (5, 2): (("medium", "large"), ("wok",), ("small", "medium")),
    (6, 2): (("large", "medium"), ("small", "medium"), ("medium", "large")),
}

COLUMNS = {grid: tuple(map(len, sizes)) for grid, sizes in _SIZES.items()}
"""Number of burners in each column, from left to right, by the numbers of burners and of rows."""


@dataclass(frozen=True)
class Place:
    """Position and size of a burner."""

    x: ag.Scalar  # position of the middle along x [m]
    y: ag.Scalar  # position of the middle along y [m]
    size: BurnerSize  # size of the burner
    reach: ag.Scalar  # half the width of the square reserved for the burner [m]


@dataclass(frozen=True)
class Column:
    """A column of burners, from front to back."""

    x: ag.Scalar  # middle of the column [m]
    width: ag.Scalar  # width of the column [m]
    depth: ag.Scalar  # depth of the column [m]
    burners: tuple[Place, ...]  # burners, from the front to the back


@dataclass(frozen=True)
class Plan:
    """The plan of a cooktop."""

    burners: int  # number of burners
    rows: int  # number of rows
    dials: int  # number of dials, first those of the burners
    side: DialSide  # border of the plate with the dials
    width: ag.Scalar  # width of the plate [m]
    depth: ag.Scalar  # depth of the plate [m]
    radius: ag.Scalar  # radius of the dials [m]
    pitch: ag.Scalar  # distance between dials, if there is space for it [m]
    mirrored: bool  # whether the large burners are on the right

    @cached_property
    def strip(self) -> ag.Scalar:
        """Width of the strip with the dials and their print [m]."""
        return EDGE + 2.0 * (self.radius + PRINT) + SIGN + 0.003

    @cached_property
    def field(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar, ag.Scalar]:
        """Positions of the left, right, front and back of the field of the burners [m]."""
        inset = {side: self.strip if side == self.side else _MARGIN for side in get_args(DialSide)}
        x, y = self.width / 2, self.depth / 2
        return (inset["left"] - x, x - inset["right"], inset["front"] - y, y - inset["back"])

    @cached_property
    def columns(self) -> list[Column]:
        """Columns of burners, from left to right."""
        left, right, front, back = self.field
        sizes = _SIZES[self.burners, self.rows]
        # a wok's column is wider than its neighbors
        shares = [1.12 if len(each) == 1 and self.rows > 1 else 1.0 for each in sizes]
        found: list[Column] = []
        start = 0.0
        for column, share in zip(sizes, shares, strict=True):
            width, tall = (right - left) * (share / sum(shares)), (back - front) / len(column)
            x = left + (right - left) * ((start + share / 2) / sum(shares))
            start += share
            x = left + right - x if self.mirrored else x
            reach = 0.5 * ag.min_(width, tall)
            burners = tuple(
                Place(x, front + tall * (row + 0.5), size, reach) for row, size in enumerate(column)
            )
            found.append(Column(x, width, back - front, burners))
        return found[::-1] if self.mirrored else found

    @cached_property
    def places(self) -> list[Place]:
        """Positions of the burners, column by column from left to right, each from front to back."""
        return [place for column in self.columns for place in column.burners]

    @cached_property
    def spaced(self) -> ag.Float:
        """Distance between dials [m]."""
        span = (self.width if self.side in ("front", "back") else self.depth) - 2.0 * (self.radius + _END)
        return ag.min_(self.pitch, span / max(self.dials - 1, 1))

    @cached_property
    def dial_places(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Positions of the dials, from left to right or from front to back [m]."""
        across = self.side in ("front", "back")
        inset = EDGE + PRINT + self.radius
        level = (self.depth if across else self.width) / 2 - inset
        level = -level if self.side in ("front", "left") else level
        row = [(number - (self.dials - 1) / 2.0) * self.spaced for number in range(self.dials)]
        return [(along, level) if across else (level, along) for along in row]

    @cached_property
    def sign_step(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Offset from a dial to the sign of its burner [m]."""
        away = self.radius + PRINT + SIGN / 2.0
        x, y = {"front": (0, 1), "back": (0, -1), "left": (1, 0), "right": (-1, 0)}[self.side]
        return (x * away, y * away)


GAS_RADIUS: dict[BurnerSize, float] = {"small": 0.025, "medium": 0.034, "large": 0.045, "wok": 0.060}
"""Radius of a spreader: burners of 1.0, 1.75, 3.0 and 4-5 kW [m]."""

GAS_TOP = 0.0235
"""Height of a gas burner with its cap [m]."""

ZONE_RADIUS: dict[BurnerSize, float] = {"small": 0.0725, "medium": 0.090, "large": 0.105, "wok": 0.135}
"""Radius of zones with nominal diameters of 145, 180, 210 and 270 mm [m]."""

COIL_RADIUS: dict[BurnerSize, float] = {"small": 0.076, "medium": 0.076, "large": 0.1015, "wok": 0.1015}
"""Radius of coils of 6 and 8 inches [m]."""

COIL_TOP = 0.006
"""Height of a coil above its plate [m]."""

BOWL = 0.011
"""Depth of a drip bowl in the plate [m]."""

# castings of cups and spreaders are hollow
ALUMINIUM = ag.material("aluminium").with_(
    name="burner_aluminium", base_color=(0.56, 0.55, 0.53), specular_roughness=0.45, density=1300.0
)
BRASS = ag.material("brass").with_(name="burner_brass", specular_roughness=0.35, density=3200.0)
_SOOT = ag.material("cast_iron").with_(name="burner_slots", base_color=(0.03, 0.028, 0.026), density=2000.0)
_ELEMENT = ag.material("black_steel").with_(
    name="heating_tube", base_color=(0.045, 0.043, 0.042), specular_roughness=0.55
)
_FOOT = (0.0, 0.0, -0.0005)  # middle of the underside of castings [m]
_TEETH = 24
_RUN = math.tau / 20.0  # angle between two points of a spiral [rad]
_GAP = 0.0045  # gap between two turns of a coil [m]
_TUBE = 0.0042  # half the width of the flattened tube of a coil [m]


@cache
def _toothed() -> ag.Profile:
    """Make the outline of a spreader of radius 1: teeth with flame slots between them."""
    points = []
    for tooth in range(_TEETH):
        for turn, share in ((0.0, 1.0), (0.62, 1.0), (0.62, 0.9), (1.0, 0.9)):
            angle = math.tau * (tooth + turn) / _TEETH
            points.append((share * math.cos(angle), share * math.sin(angle)))
    return ag.polygon(points)


def gas_burner(size: BurnerSize, *, spreader: ag.Material = ALUMINIUM, cap: ag.Material) -> ag.Body:
    """Make a gas burner: cup, slotted spreader, cap, igniter and thermocouple."""
    radius = GAS_RADIUS[size]
    edge = 1.34 * radius
    well = ag.revolve(ag.polygon([(0.0, -0.0004), (edge, -0.0004), (edge - 0.0015, 0.0009), (0.0, 0.0012)]))
    bodies = [ag.detail(well, "burner", ALUMINIUM)]
    # a dark drum between the teeth has the mass of the cup, spreader and cap, which are visual only
    heavy = _drum_density(spreader, cap)
    dark = _SOOT.with_(
        name=f"{_SOOT.name}_{size}_{spreader.name}",
        density=round(heavy * (GAS_RADIUS["medium"] / radius) ** 2),
    )
    if size == "wok":
        drum = ag.cylinder(0.90 * radius, 0.017).align(_FOOT, z=-1)
        inner = ag.cylinder(0.021, 0.0070).align((0.0, 0.0, 0.0155), z=-1)
        cup = ag.cylinder(radius, 0.0125, bevel=0.001).align(_FOOT, z=-1)
        rim = ag.revolve(ag.rectangle(0.021, 0.0035, radius=0.0014).at(0.8 * radius, 0.018))
        bodies += [ag.part(drum, "burner", dark), ag.part(inner, "burner", spreader)]
        bodies += [ag.detail([cup, _teeth(0.98 * radius, 0.012, 0.0165)], "burner", spreader)]
        bodies += [ag.detail([rim, *_cap(0.024, 0.0185, GAS_TOP)], "burner_cap", cap)]
    else:
        high = GAS_TOP - 0.001
        drum = ag.cylinder(0.92 * radius, high - 0.0005).align(_FOOT, z=-1)
        cup = ag.frustum(1.14 * radius, 0.97 * radius, 0.0105, bevel=0.0008).align(_FOOT, z=-1)
        bodies.append(ag.part(drum, "burner", dark))
        bodies.append(ag.detail([cup, _teeth(radius, 0.0095, 0.0165)], "burner", spreader))
        bodies.append(ag.detail(_cap(0.93 * radius, 0.016, high), "burner_cap", cap))
    pin, tip = ag.cylinder(0.0026, 0.0125, bevel=0.0008), ag.cylinder(0.0009, 0.004)
    couple = ag.cylinder(0.0021, 0.015, bevel=0.001)
    x, y = 0.74 * 1 * 1.24 * radius, -0.68 * 1.24 * radius
    return ag.weld(
        *bodies,
        ag.detail(pin.at(x, y, 0.006), "igniter", ag.material("ceramic")),
        ag.detail(tip.at(x, y, 0.0138), "igniter", ag.material("steel")),
        ag.detail(couple.at(-x, y, 0.0072), "igniter", ag.material("copper")),
    )


def _drum_density(spreader: ag.Material, cap: ag.Material) -> float:
    """Return the density of the drum of a medium burner that gives it the mass of the visible parts [kg/m3].

    The factors are the volumes of the spreader with cup and of the cap, relative to the drum, which is 22 mm
    high. Other sizes have the same mass, because larger castings are thinner: equal masses at the left and
    right keep the principal axes of the top along its edges, and simulators align their boxes with these
    axes.
    """
    return round(700.0 + 0.6 * spreader.density + 0.3 * cap.density)


def _teeth(radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar) -> ag.Solid:
    """Make the teeth between the flame slots, from one height to another."""
    return ag.extrude(_toothed().scale(radius), high - low).align((0.0, 0.0, low), z=-1)


def _cap(radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar) -> list[ag.Solid]:
    """Make a cap between two heights, slightly domed."""
    edge = ag.cylinder(radius, high - low, bevel=0.0018).align((0.0, 0.0, low), z=-1)
    dome = [(0.86 * radius, 0.0, high - 0.0006), (0.5 * radius, 0.0, high + 0.0007), (0.0, 0.0, high + 0.001)]
    return [edge, ag.revolve(ag.half_section(ag.spline(dome)))]


def coil_hole(radius: ag.Scalar) -> ag.Profile:
    """Return the outline of the hole for the drip bowl of a coil: an octagon under the lip of the bowl."""
    corners = [math.tau * (side + 0.5) / 8.0 for side in range(8)]
    wide = (radius + 0.008) / math.cos(math.pi / 8.0)
    return ag.polygon([(math.cos(turn), math.sin(turn)) for turn in corners]).scale(wide)


def glowing(burner: BurnerKind, number: int, ink: ag.Material) -> ag.Material:
    """Return the material of the coil or the radiant zone of a burner, which glows alone; `ink` of others."""
    if burner == "coil":
        return _ELEMENT.with_(name=f"{_ELEMENT.name}_{number}")
    return ink.with_(name=f"zone_{number}") if burner == "radiant" else ink


def heated(body: ag.Body, burner: BurnerKind, dials: Sequence[str], ink: ag.Material) -> ag.Body:
    """Let each of several joints heat its burner: the outputs `burner_0`, ..."""
    for number, dial in enumerate(dials):
        glows = glowing(burner, number, ink) if burner in ("coil", "radiant") else None
        body = body.output(f"burner_{number}", signals.level(dial), kind="heat", material=glows)
    return body


def coil_burner(radius: float, *, bowl: ag.Material, coil: ag.Material, turn: float = 0.0) -> ag.Body:
    """Make a coil on three bars in its drip bowl, which reaches 11 mm down into the plate.

    The bars carry a pot; the coil, half a millimeter higher, is visual only.
    """
    lip = radius + 0.008
    # radii as shares of the lip, and heights
    line = ((0.30, -BOWL + 0.0008), (0.86, -0.006), (0.98, 0.0012), (1.065, 0.0016), (1.08, 0.0002))
    points = [(0.012, 0.0, -BOWL + 0.0006), *((share * lip, 0.0, height) for share, height in line)]
    dish = ag.revolve(ag.half_section(ag.spline(points), wall=0.0007))
    hole = ag.cylinder(0.0125, 0.0008).at(z=-BOWL + 0.0002)
    thin, low, high = (-0.0012, 0.0012), -BOWL - 0.0005, COIL_TOP - 0.0085
    bar = ag.Region((0.010, 0.97 * radius), thin, (low, high)).box()
    tread = ag.Region((0.012, 0.99 * radius), thin, (high - 0.0005, COIL_TOP - 0.0005)).box()
    spokes = [each.rotate(ag.Z, turn + math.tau * arm / 3) for arm in range(3) for each in (bar, tread)]
    boss = ag.cylinder(0.0115, COIL_TOP + BOWL - 0.0012, bevel=0.0008).align((0.0, 0.0, -BOWL - 0.0004), z=-1)
    steel = ag.material("stainless").with_(name="coil_bars", specular_roughness=0.4)
    return ag.weld(
        ag.part([*spokes, boss], "burner", steel),
        ag.detail(_spiral(radius).rotate(ag.Z, turn), "coil", coil),
        ag.detail(dish, "drip_bowl", bowl),
        ag.detail(hole, "drip_bowl", _SOOT),
    )


def _spiral(radius: float) -> ag.Solid:
    """Make a flattened tube in a spiral, with the tail that goes down into the bowl."""
    first, last = 0.019, radius - _TUBE
    pitch = 2.0 * _TUBE + _GAP
    sweep_ = math.tau * (last - first) / pitch
    steps = round(sweep_ / _RUN)
    level = COIL_TOP - 0.003
    # its ends go down into the bowl
    course = [(-0.9, first, -0.006), (-0.45, first, -0.0015)]
    for step in range(steps + 1):
        angle = sweep_ * step / steps
        course.append((angle, first + pitch * angle / math.tau, 0.0))
    course += [(sweep_ + 0.22, last, -0.0015), (sweep_ + 0.40, last, -0.006)]
    points: list[ag.VectorLike] = [
        (out * math.cos(angle), out * math.sin(angle), level + drop) for angle, out, drop in course
    ]
    return ag.sweep(ag.ellipse(_TUBE, 0.003), ag.spline(points))


def _radiant_zone(radius: ag.Scalar, *, dual: bool) -> ag.Profile:
    """Make the print over a radiant heater: a fine circle, its band, and an inner circle on dual heaters."""
    zone = ag.ring(radius, radius - 0.0011) | ag.ring(radius - 0.0030, radius - 0.0036)
    if dual:
        zone = zone | ag.ring(0.62 * radius, 0.62 * radius - 0.0011)
    return zone


def _induction_zone(radius: ag.Scalar, style: str) -> ag.Profile:
    """Make the print over an induction coil."""
    arm = ag.rectangle(0.030, 0.0011) | ag.rectangle(0.0011, 0.030)
    if style == "cross":
        gap = ag.rectangle(3.0 * radius, 0.55 * radius) | ag.rectangle(0.55 * radius, 3.0 * radius)
        return arm | (ag.ring(radius, radius - 0.0011) - gap.rotate(math.pi / 4.0))
    side = 0.93 * radius
    if style == "corners":
        outer = ag.rectangle(2 * side, 2 * side, radius=0.006)
        outer = outer - ag.rectangle(2 * side - 0.0022, 2 * side - 0.0022, radius=0.005)
        gap = ag.rectangle(3.0 * side, 1.3 * side) | ag.rectangle(1.3 * side, 3.0 * side)
        return (outer - gap) | arm.scale(0.5)
    dots = arm.scale(0.6)
    for step in range(12):
        angle = math.tau * step / 12.0
        dots = dots | ag.circle(0.0016).at(radius * math.cos(angle), radius * math.sin(angle))
    return dots


def printed_zones(
    places: Sequence[Place],
    burner: BurnerKind,
    top: ag.Scalar,
    ink: ag.Material,
    *,
    share: float,
    style: str = "cross",
) -> ag.Body:
    """Print radiant or induction zones on a glass with its upper face at a height.

    Neighbors keep a gap: a radius is at most a share of the reach of its place.
    """
    films = []
    for number, place in enumerate(places):
        radius = ag.min_(ZONE_RADIUS[place.size], share * place.reach)
        if burner == "radiant":
            film = _radiant_zone(radius, dual=place.size in ("large", "wok"))
        else:
            film = _induction_zone(radius, style)
        at = (place.x, place.y, top)
        glows = glowing(burner, number, ink)
        films.append(details.printed(film, at, material=glows, facing=ag.Z, label="zone"))
    return ag.weld(*films)


GrateStyle = Literal["continuous", "single", "diagonal"]
"""One grate per column of burners, one per burner, or one per column with fingers from the corners."""

TOP = 0.043
"""Height of the support of pots above the plate [m]."""

LIFT = 0.10
"""Travel of a lifted grate [m]."""

_WIDE, _HIGH = 0.0095, 0.0115  # width and height of a bar [m]
_SLIM = 0.84  # width of a finger, as a share of that of a bar
_APART = 0.003  # gap from a grate to the border of its field [m]
_BARE = 0.020  # radius around the middle of a burner without fingers [m]
_REST = 0.0003  # gap between the feet and the plate, held by the joint's limit [m]
_SOFT = 0.0022  # radius of the edges [m]


def _bars(
    size: tuple[ag.Scalar, ag.Scalar], at: list[tuple[ag.Scalar, ag.Scalar]], top: ag.Scalar
) -> ag.Solid:
    """Make horizontal bars of one length along x and y, with their middles at given positions [m]."""
    bar = ag.Region.centered(*size, _HIGH).at(z=top - _HIGH / 2).box(bevel=_SOFT)
    return ag.array(bar, at=[(i, j, 0.0) for i, j in at])


def _fingers(
    burners: Sequence[Place], half: tuple[ag.Scalar, ag.Scalar], *, diagonal: bool, top: ag.Scalar
) -> list[ag.Solid]:
    """Make four fingers from the frame around each burner towards its middle."""
    wide, deep = half
    middles = [(place.x, place.y) for place in burners]
    slim, low = _SLIM * _WIDE, top - 0.04 * _HIGH
    if not diagonal:
        x, y = 0.5 * (wide + _BARE), 0.5 * (deep + _BARE)
        beside = [(i + way * x, j) for i, j in middles for way in (-1, 1)]
        before = [(i, j + way * y) for i, j in middles for way in (-1, 1)]
        return [_bars((wide - _BARE, slim), beside, low), _bars((slim, deep - _BARE), before, low)]
    inner = 0.71 * _BARE
    x, y = wide - inner, deep - inner
    made = []
    for way in (-1, 1):  # two fingers in a line have one direction
        start = ag.Region((0.0, ag.sqrt(x * x + y * y)), (-slim / 2, slim / 2), (low - _HIGH, low))
        finger = start.box(bevel=_SOFT).rotate(ag.Z, ag.atan2(way * y, x))
        first = [(i + inner, j + way * inner) for i, j in middles]
        second = [(i - wide, j - way * deep) for i, j in middles]
        made.append(ag.array(finger, at=[(i, j, 0.0) for i, j in (*first, *second)]))
    return made


def grate(
    name: str,
    burners: Sequence[Place],
    *,
    half: tuple[ag.Scalar, ag.Scalar],
    plate: ag.Scalar,
    style: GrateStyle,
    iron: ag.Material,
    feet: ag.Material,
) -> ag.Body:
    """Make a grate over one burner, or over a column of burners."""
    top = plate + TOP
    wide, deep = half
    first, last = burners[0], burners[-1]
    x, front, back = first.x, first.y - deep, last.y + deep
    levels = [front, *(0.5 * (a.y + b.y) for a, b in pairwise(burners)), back]
    across = _bars((2.0 * wide + _WIDE, _WIDE), [(x, y) for y in levels], top)
    ends = [(x + way * wide, 0.5 * (front + back)) for way in (-1, 1)]
    sides = _bars((_WIDE, back - front), ends, top - 0.0002)
    inner = _fingers(burners, half, diagonal=style == "diagonal", top=top)
    # legs under the corners, with rubber around their ends
    corners = [ag.vector(x + i * wide, y, 0.0) for i in (-1, 1) for y in (front, back)]
    foot = ag.Region.centered(0.0092, 0.0092, 0.0)
    leg = foot.with_(z=(plate + _REST, top - 0.004)).box(bevel=_SOFT)
    pad = foot.grow(0.0006).with_(z=(plate + _REST, plate + 0.006)).box(bevel=0.0015)
    # grasp on a finger without a neighboring grate; the finger tips of a gripper reach 10 mm down
    slim, grip = _SLIM * _WIDE, top - 0.04 * _HIGH - 0.001
    if style == "diagonal":
        start, share = 0.71 * _BARE, 0.5
        run, rise = wide - start, deep - start
        at = (first.x - start - share * run, first.y + start + share * rise, grip)
        hold = ag.frame(at, approach=-ag.Z, closing=ag.vector(rise, run, 0.0))
    else:
        hold = ag.frame((first.x - 0.5 * (wide + _BARE), first.y, grip), approach=-ag.Z, closing=ag.Y)
    apart = "each bar is cast onto the others"
    solids = [*inner, across, sides, ag.array(leg, at=corners)]
    body = ag.part(solids, "grate", iron, name=name, grasp=hold, grasp_width=slim + 0.010, separate=apart)
    return ag.weld(body, ag.detail(ag.array(pad, at=corners), "grate", feet))


def grate_lift(name: str) -> ag.Joint:
    """Make the joint of a grate, which is lifted off the plate; its weight returns it."""
    return ag.Prismatic(name, axis=ag.Z, limits=(0.0, LIFT), damping=4.0, effort=60.0)


def grates(
    columns: Sequence[Column], *, plate: ag.Scalar, style: GrateStyle, iron: ag.Material, feet: ag.Material
) -> list[tuple[ag.Body, ag.Joint]]:
    """Make all grates of a cooktop with their joints."""
    inset = _APART + _WIDE / 2
    groups: list[tuple[Sequence[Place], tuple[ag.Scalar, ag.Scalar]]] = []
    for column in columns:
        deep = 0.5 * column.depth / len(column.burners)
        if style == "continuous":
            groups.append((column.burners, (0.5 * column.width - inset, deep - inset)))
        else:
            most = 1.3 * column.burners[0].reach
            around = (ag.min_(0.5 * column.width, most) - inset, ag.min_(deep, most) - inset)
            groups += [((burner,), around) for burner in column.burners]
    made = []
    for number, (burners, half) in enumerate(groups):
        name = f"grate_{number}"
        body = grate(name, burners, half=half, plate=plate, style=style, iron=iron, feet=feet)
        made.append((body, grate_lift(f"grate_lift_{number}")))
    return made
