"""Eyeglasses that stand folded on a table: for reading, for the sun or for every day.

Links: `frame`, with the lenses, the bridge and the nose pads; `temple_left`, `temple_right`, as seen from the
front. Joints: `temple_hinge_left`, `temple_hinge_right`, folded at 0; positive turns open the temples.

The left temple folds first and lies behind the front; the right one lies on it at a small angle. So the left
one opens only after the right one. Folded and open, they stand on both rims and on the tips of the temples,
whose bend reaches the table. Friction of the screws holds the temples at any angle; spring hinges snap open
and folded, and give way beyond the open position.

Sizes are those of opticians (boxing system of ISO 8624, printed inside of a temple): lenses 46-58 mm wide,
bridges 15-22 mm, temples 135-150 mm along their bend, fronts 122-155 mm. Frames of acetate weigh 18-38 g with
lenses of polycarbonate, those of metal 18-34 g, rimless ones 13-24 g; a temple weighs 3-8 g. Hinges of
0.006-0.02 N m hold it in every pose (setting of opticians: a temple must not fall by its weight).
"""

import itertools
import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls

Style = Literal["acetate", "metal", "half_rim", "rimless"]
"""Frames by what holds the lenses: a front of acetate, rims of wire, rims above only, or screws."""

Shape = Literal["square", "round", "cat_eye", "aviator", "narrow"]
"""Outline of the lenses."""

# powers of the superellipse of a lens above and below its middle (2: an ellipse), how much wider its top is,
# how far its top rises towards the temple, and how far its lower half leans to the temple
_FORMS: dict[Shape, tuple[float, float, float, float, float]] = {
    "square": (3.8, 3.2, 0.06, 0.02, 0.0),
    "round": (2.15, 2.1, 0.01, 0.0, 0.0),
    "cat_eye": (3.0, 2.2, 0.10, 0.16, 0.04),
    "aviator": (3.0, 2.1, 0.16, -0.02, 0.10),
    "narrow": (3.0, 2.4, 0.04, 0.0, 0.0),
}
_CORNERS = 32  # points of an outline
# height of the end pieces, as a share of half of the height of a lens
_HIGH = {"square": 0.50, "round": 0.34, "cat_eye": 0.72, "aviator": 0.62, "narrow": 0.45}
# course of a temple: its way from hinge to end, and the share of its bend reached there
_COURSE = (
    (0.0, 0.0), (0.08, 0.0), (0.30, 0.0), (0.44, 0.0), (0.55, 0.0), (0.64, 0.08), (0.69, 0.28), (0.74, 0.60),
    (0.79, 0.88), (0.84, 1.0), (0.92, 1.0), (0.97, 1.0), (0.99, 1.0), (1.0, 1.0),
)  # fmt: skip
_ROUNDED = {0.99: 0.84, 1.0: 0.45}  # heights of the last sections, which round the end
_INSIDE = 0.0018  # from the axis of a hinge to the inner face of its temple [m]
_NEARLY = 0.06  # angle to the open position from which the right temple lets the left one pass [rad]
_BEHIND = 0.0023  # from the back of an end piece to the axis [m]
_BARREL = 0.0013  # radius of a hinge [m]
_KNUCKLE = 0.0018  # height of each of its three knuckles [m]
_BASE = 1.8  # radius of the outer face of a lens [m]
_SLEEVE = 0.0027  # thickness of the cover of a tip [m]
_LENS = 0.0020  # thickness of a lens [m]

_SHEEN = ag.material("glossy_plastic_black").with_(name="acetate", density=1290.0)
_ACETATES = (
    _SHEEN.with_(name="acetate_black"),
    _SHEEN.with_(name="acetate_havana", base_color=(0.150, 0.058, 0.016), texture="tortoise"),
    _SHEEN.with_(name="acetate_honey", base_color=(0.36, 0.165, 0.042), texture="tortoise", variant=1),
    _SHEEN.with_(name="acetate_navy", base_color=(0.020, 0.034, 0.095)),
    _SHEEN.with_(name="acetate_burgundy", base_color=(0.135, 0.012, 0.022)),
    _SHEEN.with_(name="acetate_forest", base_color=(0.022, 0.072, 0.042)),
    _SHEEN.with_(name="acetate_clear", base_color=(0.86, 0.85, 0.80), transmission_weight=0.8, opacity=0.5),
    _SHEEN.with_(name="acetate_smoke", base_color=(0.20, 0.21, 0.23), transmission_weight=0.6, opacity=0.72),
    _SHEEN.with_(name="acetate_amber", base_color=(0.52, 0.25, 0.07), transmission_weight=0.6, opacity=0.72),
)
_METALS = tuple(
    ag.material(name).with_(name=f"{name}_wire", density=8200.0)
    for name in ("satin_nickel", "chrome", "brass", "satin_brass", "black_steel", "copper")
)
_CLEAR = ag.material("glass").with_(
    name="lens_clear", base_color=(0.84, 0.91, 0.90), density=1200.0, opacity=0.24
)
_TINTS = tuple(
    _CLEAR.with_(name=f"lens_{name}", base_color=color, opacity=0.84)
    for name, color in {
        "grey": (0.035, 0.037, 0.040), "brown": (0.085, 0.036, 0.014), "green": (0.026, 0.050, 0.030),
        "blue": (0.020, 0.045, 0.110), "rose": (0.16, 0.050, 0.055),
    }.items()
)  # fmt: skip
_PAD = ag.material("silicone").with_(name="nose_pad", base_color=(0.80, 0.80, 0.76), opacity=0.7)


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of one pair of glasses, about the middle between both lenses."""

    style: Style
    shape: Shape
    wide: float  # of a lens [m]
    high: ag.Scalar  # of a lens [m]
    bridge: float  # between both lenses [m]
    rim: ag.Scalar  # height of a rim around a lens [m]
    wrap: ag.Scalar  # angle of each half to the front [rad]
    length: float  # of a temple [m]
    slant: ag.Scalar  # of a temple to the table [rad]
    broad: ag.Scalar  # height of a temple behind its hinge [m]
    metal: ag.Material
    finish: ag.Material

    @property
    def full(self) -> bool:
        """Whether the front is of acetate."""
        return self.style == "acetate"

    @property
    def thick(self) -> float:
        """Thickness of a temple and of an end piece [m]."""
        return 0.0036 if self.full else 0.0015

    @property
    def deep(self) -> float:
        """Thickness of the front [m]."""
        return 0.0035 if self.full else 0.0023

    @property
    def level(self) -> ag.Scalar:
        """Height of the hinges [m]."""
        return _HIGH[self.shape] * self.high / 2

    @property
    def lug(self) -> ag.Scalar:
        """Height of an end piece of acetate [m]."""
        return ag.min_(self.broad, 0.5 * self.high)

    @property
    def side(self) -> ag.Scalar:
        """Distance of the outer faces of the end pieces from the middle [m]."""
        return self.bridge / 2 + self.wide + self.rim + (0.0045 if self.full else 0.0040)

    @property
    def lean(self) -> ag.Scalar:
        """Angle of the folded right temple to the left one, on which it lies [rad]."""
        half = self.pivot.x
        overlap = _section(self, 0.45)[0] / 2 / ag.tan(self.slant)  # half of the width of their crossing
        return ag.atan2(
            self.thick + (-0.0004 if self.full else 0.0015),
            ag.max_(half - overlap, 2 * half - 0.70 * self.length),
        )

    @property
    def pivot(self) -> ag.Vector:
        """Middle of the right hinge [m]."""
        return ag.vector(self.side - self.thick - _INSIDE, self.back + _BEHIND, self.level)

    @property
    def back(self) -> ag.Scalar:
        """Position of the backs of the end pieces [m]."""
        return (self.side - 0.004) * ag.sin(self.wrap) + self.deep / 2 + (0.0014 if self.full else 0.0065)

    @property
    def corners(self) -> list[tuple[float, float]]:
        """Points of the outline of the right lens, as shares of its half width and half height."""
        above, below, widening, rising, leaning = _FORMS[self.shape]
        points = []
        for at in range(_CORNERS):
            turn = math.tau * at / _CORNERS
            cosine, sine = math.cos(turn), math.sin(turn)
            power = above if sine > 0 else below
            far = (abs(cosine) ** power + abs(sine) ** power) ** (-1 / power)
            x, y = far * cosine, far * sine
            points.append((x * (1 + widening * y) - leaning * min(y, 0.0), y + rising * x * max(y, 0.0)))
        (west, east), (south, north) = ((min(each), max(each)) for each in zip(*points, strict=True))
        return [
            (2 * (x - west) / (east - west) - 1, 2 * (y - south) / (north - south) - 1) for x, y in points
        ]

    def outline(self, grown: ag.Scalar) -> ag.Profile:
        """Make the outline of the right lens, and of what lies around it."""
        x, y = self.wide / 2, self.high / 2
        course = ag.spline([(a * x, b * y, 0.0) for a, b in self.corners], closed=True).profile()
        return course.offset(grown, join="miter").at(x + self.bridge / 2)

    def edge(self, level: float, side: int) -> float:
        """Return how far a lens reaches to the nose (-1) or the temple (1) at a level, as such shares."""
        points = self.corners
        ends = [
            x + (level - y) / (y1 - y) * (x1 - x)
            for (x, y), (x1, y1) in zip(points, (*points[1:], points[0]), strict=True)
            if min(y, y1) <= level <= max(y, y1) and y != y1
        ]
        return max(ends) if side > 0 else min(ends)

    def at(self, level: float, side: int) -> float:
        """Return the x of that place [m]."""
        return self.bridge / 2 + self.wide / 2 * (1 + self.edge(level, side))

    def both(self, half: ag.Solid) -> ag.Solid:
        """Turn the right half of a front to its angle, and join both halves in the middle."""
        turned = half.rotate(ag.Z, self.wrap).split(point=(0, 0, 0), normal=ag.X)
        return turned | turned.mirror(ag.X)

    def around(self, rim: ag.Solid) -> ag.Solid:
        """Let a rim collide like a plate, since its lens fills it."""
        plate = ag.extrude(self.outline(self.rim + 0.0003), self.deep + 0.0001, axis=ag.Y)
        return ag.bounding_collider(rim, ag.hull(plate))

    def pair(self, solid: ag.Solid) -> list[ag.Solid]:
        """Turn a part beside the nose to the angle of its half, and mirror it."""
        turned = solid.rotate(ag.Z, self.wrap)
        return [turned, turned.mirror(ag.X)]


@ag.category(
    labels="frame rim lens bridge nose_pad end_piece hinge screw temple tip thread rivet print", joints=(2, 2)
)
def eyeglasses(
    *,
    use: Literal["optical", "sun", "reading"] = ag.choice({"optical": 0.48, "sun": 0.32, "reading": 0.2}),
    style: Style = ag.by(
        "use",
        optical={"acetate": 0.40, "metal": 0.25, "half_rim": 0.17, "rimless": 0.18},
        sun={"acetate": 0.6, "metal": 0.4},
        reading={"acetate": 0.5, "metal": 0.15, "half_rim": 0.2, "rimless": 0.15},
    ),
    shape: Shape = ag.by(
        "use",
        optical={"square": 0.42, "round": 0.32, "cat_eye": 0.16, "aviator": 0.10},
        sun={"square": 0.27, "round": 0.20, "cat_eye": 0.23, "aviator": 0.30},
        reading={"narrow": 0.7, "round": 0.3},
    ),
    lens_width: int = ag.by(
        "use",
        optical=ag.count(47, 55),
        sun=ag.count(51, 58),
        reading=ag.count(46, 52),
        within=(46, 60),
        doc="width of a lens [mm]",
    ),
    aspect: ag.Float = ag.by(
        "shape",
        square=ag.uniform(0.68, 0.78),
        round=ag.uniform(0.86, 0.94),
        cat_eye=ag.uniform(0.70, 0.80),
        aviator=ag.uniform(0.82, 0.90),
        narrow=ag.uniform(0.50, 0.60),
        within=(0.48, 1.0),
        doc="height of a lens as a share of its width",
    ),
    bridge: int = ag.count(15, 22, within=(14, 24), doc="distance between both lenses [mm]"),
    temple_length: int = ag.choice(135, 140, 145, 150, doc="length of a temple along its bend [mm]"),
    rim: ag.Float = ag.by(
        "style",
        acetate=ag.uniform(0.0026, 0.0056),
        rimless=0.0004,
        otherwise=ag.uniform(0.0012, 0.0016),
        unit="m",
        within=(0.0004, 0.007),
        doc="height of the rim around a lens",
    ),
    wrap: ag.Float = ag.uniform(
        0.06, 0.10, "rad", within=(0.05, 0.12), doc="angle of each half to the front"
    ),
    slant: ag.Float = ag.uniform(0.07, 0.12, "rad", within=(0.05, 0.14), doc="angle of the temples"),
    broad: ag.Float = ag.by(
        "style",
        acetate=ag.uniform(0.0065, 0.0130),
        otherwise=ag.uniform(0.0030, 0.0042),
        unit="m",
        within=(0.0028, 0.016),
        doc="height of a temple behind its hinge",
    ),
    hinge: Literal["plain", "spring"] = ag.choice({"plain": 0.65, "spring": 0.35}),
    friction: ag.Float = ag.uniform(0.006, 0.020, "N m", doc="friction of a hinge"),
    acetate: ag.Material = ag.shades(
        *_ACETATES,
        weights=(2.2, 2.2, 1.2, 0.7, 0.6, 0.5, 0.9, 0.6, 0.5),
        color=0.05,
        doc="front and temples of acetate, or tips",
    ),
    metal: ag.Material = ag.shades(*_METALS, weights=(2, 1, 1.2, 1, 1.6, 0.6), color=0.05),
    tint: ag.Material = ag.by("use", sun=ag.choice(*_TINTS, weights=(3, 2, 2, 0.7, 0.5)), otherwise=_CLEAR),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make glasses that stand open on a table."""
    wide, between, length = lens_width / 1000, bridge / 1000, temple_length / 1000
    finish = acetate if style == "acetate" else metal
    # tips of low frames still bend down to the table
    slant = ag.min_(slant, 0.36 * (1 + _HIGH[shape]) * aspect * wide / 2 / length)
    plan = _Plan(style, shape, wide, aspect * wide, between, rim, wrap, length, slant, broad, metal, finish)
    spring = 0.15 if hinge == "spring" else 0.0
    x, y, z = plan.pivot.x, plan.pivot.y, plan.pivot.z

    def hinge_of(name: str, side: int, turn: ag.Scalar, needs: ag.Condition | None = None) -> ag.Joint:
        """Make the hinge of a temple that opens by an angle."""
        snaps = feel.detents((0.0, turn, turn + 1.1), 0.04) if spring else None
        return ag.Revolute(
            f"temple_hinge_{name}", axis=-side * ag.Z, pivot=(side * x, y, z), limits=(0.0, turn + spring),
            detents=snaps, friction=friction, damping=0.0015, armature=4e-5, effort=0.09, needs=needs,
        )  # fmt: skip

    opens = hinge_of("right", 1, math.pi / 2 - plan.lean)
    under = hinge_of("left", -1, math.pi / 2, opens > math.pi / 2 - plan.lean - _NEARLY)
    front, low = _front(plan, tint, (opens > 1.3) & (under > 1.3))
    left = _temple(plan, "left", low, spring, acetate, maker)
    right = _temple(plan, "right", low, spring, acetate, maker)
    body = front.attach(right, opens).attach(left, under)
    return body.at(0, 0, -low)


def _front(plan: _Plan, tint: ag.Material, when: ag.Condition) -> tuple[ag.Body, ag.Scalar]:
    """Make the front with its lenses and hinges, and return the height of its lowest place."""
    lens = plan.both(_lens(plan, plan.outline(0.0 if plan.style == "rimless" else 0.0004)))
    middle = (plan.bridge + plan.wide) / 2
    hold = ag.grasp_on(
        _acetate_solid(plan) if plan.full else lens,
        approach=-ag.Z,
        closing=ag.vector(-ag.sin(plan.wrap), ag.cos(plan.wrap)),
        at=(middle, middle * ag.sin(plan.wrap), plan.high / 2 - 0.002),
        depth=0.011,
    )
    glass = ag.part(
        lens, "lens", tint, grasp=() if plan.full else hold, when=None if plan.full else when,
        separate="lenses in both rims", name="frame",
    )  # fmt: skip
    bodies = _acetate(plan, hold, when) if plan.full else _wires(plan)
    x, y, z = plan.pivot.x, plan.pivot.y, plan.pivot.z
    knuckles, screws = [], []
    for side in (-1, 1):
        for up in (-1, 1):
            level = z + up * (_KNUCKLE + 0.0003)
            leaf = ag.box(2 * _BARREL - 0.0004, _BEHIND + 0.0006, _KNUCKLE)
            knuckles.append(ag.cylinder(_BARREL, _KNUCKLE).at(side * x, y, level))
            knuckles.append(leaf.at(side * x, y - _BEHIND / 2 - 0.0003, level))
        head = (side * x, y, z + 1.5 * _KNUCKLE + 0.0003)
        screws.append(details.screw(0.0011, head, material=plan.metal, facing=ag.Z, drive="slot"))
    hinges = ag.part(ag.union(*knuckles), "hinge", plan.metal, separate="hinges at both end pieces")
    grown = plan.rim if plan.style in ("acetate", "metal") else 0.0
    low = ag.extrude(plan.outline(grown), 0.001, axis=ag.Y).anchor(z=-1).z
    return ag.weld(glass, *bodies, hinges, *screws), ag.min_(lens.anchor(z=-1).z, low)


def _lens(plan: _Plan, outline: ag.Profile) -> ag.Solid:
    """Make the right lens, a bowl whose hollow side is behind."""
    steps = [0.005 * at for at in range(9)]
    sunk = 0.023**2 / 2 / _BASE  # the edges lie in the middle of the rim
    before = [(r, r * r / 2 / _BASE - sunk - _LENS / 2) for r in steps]
    behind = [(r, y + _LENS) for r, y in before]
    bowl = ag.revolve(ag.polygon([*before, *reversed(behind)]), axis=ag.Y, sides=96)
    x = (plan.bridge + plan.wide) / 2
    lens = bowl.at(x) & ag.extrude(outline, 0.02, axis=ag.Y)
    return ag.bounding_collider(lens)


def _acetate_solid(plan: _Plan) -> ag.Solid:
    """Make a front of acetate with its saddle."""
    half = plan.high / 2
    top, under = 0.60 * half, 0.12 * half
    inner = plan.bridge / 2 + 0.004
    arch = [(0.35, 0.0004), (0.62, 0.0016), (0.85, 0.0040), (1.0, 0.0075)]
    right = [(share * inner, under - down) for share, down in arch]
    left = [(-x, y) for x, y in reversed(right)]
    saddle = ag.polygon(
        [(-inner, top), (0.0, top - 0.0009), (inner, top), *reversed(right), (0.0, under), *left]
    )
    start, end = plan.at(_HIGH[plan.shape], 1) - 0.003, plan.side - 0.001
    tall = plan.lug / 2
    lug = ag.polygon(
        [
            (start, plan.level + tall + 0.0012),
            (end, plan.level + tall - 0.0004),
            (end, plan.level - tall + 0.0004),
            (start, plan.level - tall - 0.0040),
        ]
    )
    ring, middle, side = (
        ag.extrude(flat, plan.deep, axis=ag.Y, bevel=0.0006) for flat in (plan.outline(plan.rim), saddle, lug)
    )
    cut = ag.extrude(plan.outline(0.0), 0.02, axis=ag.Y)
    flat = plan.around(ring - cut) | (middle - cut) | (side - cut)
    return plan.both(flat)


def _acetate(plan: _Plan, hold: ag.Frame, when: ag.Condition) -> list[ag.Body]:
    """Make the parts of a front of acetate: pads and end pieces of the same sheet, and rivets."""
    tall = plan.lug / 2
    pads = plan.pair(
        ag.ellipsoid(0.0021, 0.0042, 0.0062)
        .rotate(ag.Y, -0.35)
        .rotate(ag.Z, -0.3)
        .at(plan.at(-0.15, -1) - 0.4 * plan.rim - 0.0004, 0.0026, -0.12 * plan.high / 2)
    )
    ends = []
    for side in (-1, 1):
        x0, x1 = plan.pivot.x - _INSIDE, plan.side
        room = ag.Region((x0, x1), (plan.back - 0.0046, plan.back), (plan.level - tall, plan.level + tall))
        block = room.box(bevel=0.0009)
        ends.append(block if side > 0 else block.mirror(ag.X))
    rivets = [
        details.rivet(
            0.0008, (side * (plan.side - 0.0030), plan.back - 0.0046, plan.level + up), facing=-ag.Y
        )
        for side in (-1, 1)
        for up in (-0.0016, 0.0016)
    ]
    return [
        ag.part(_acetate_solid(plan), "frame", plan.finish, name="frame", grasp=hold, when=when),
        ag.part(pads, "nose_pad", plan.finish),
        ag.part(ends, "end_piece", plan.finish, separate="end pieces of the front"),
        ag.detail(rivets, "rivet", plan.metal),
    ]


def _wires(plan: _Plan) -> list[ag.Body]:
    """Make a front of metal: rims, a bridge, pads on wires, and lugs with hinges behind the front."""
    half = plan.high / 2
    bodies = []
    level = 0.35 if plan.shape != "aviator" else 0.30
    nose = plan.at(level, -1)
    wire, inward = 0.0009, 0.0042 if plan.style == "rimless" else -0.3 * plan.rim
    arch = ag.spline(
        [
            (nose + inward, -0.0006, level * half),
            (0.62 * nose, -0.0008, level * half + 0.0012),
            (0.0, -0.0008, level * half + 0.0030),
            (-0.62 * nose, -0.0008, level * half + 0.0012),
            (-nose - inward, -0.0006, level * half),
        ]
    )
    bridge = ag.sweep(ag.circle(wire), arch).at(y=nose * 0.07)
    bodies.append(ag.part(bridge, "bridge", plan.metal))
    if plan.shape == "aviator":
        high = plan.at(0.86, -1)
        bar = ag.cylinder_between(
            (-high, 0, 0.86 * half + 0.5 * plan.rim), (high, 0, 0.86 * half + 0.5 * plan.rim), wire
        )
        bodies.append(ag.part(bar.at(y=0.07 * high), "bridge", plan.metal))
    if plan.style != "rimless":
        ring = plan.outline(plan.rim) - plan.outline(-0.0009)
        rim = ag.extrude(ring, plan.deep, axis=ag.Y, bevel=0.00025)
        if plan.style == "half_rim":
            rim &= ag.Region((0.0, 0.1), (-0.01, 0.01), (0.10 * half, 0.1)).box()
        bodies.append(ag.part(plan.both(plan.around(rim)), "rim", plan.metal, separate="two rims"))
    if plan.style == "half_rim":
        cord = plan.outline(0.0003) - plan.outline(-0.0004)
        cord &= ag.rectangle(0.2, 0.1).at(0.05, -0.05 + 0.13 * half)
        bodies.append(ag.detail(plan.both(ag.extrude(cord, 0.0007, axis=ag.Y)), "thread", _CLEAR))
    if plan.style == "rimless":
        spots = [(plan.at(_HIGH[plan.shape], 1) - 0.0045, plan.level), (nose + 0.0030, level * half)]
        for x, z in spots:
            head = details.screw_head(0.0012, (x, -0.0017, z), facing=-ag.Y, drive="slot", head="pan")
            bodies.append(ag.detail(plan.pair(head), "screw", plan.metal))
    bodies += _pads(plan)
    bodies += _lugs(plan)
    return bodies


def _pads(plan: _Plan) -> list[ag.Body]:
    """Make nose pads on bent wires."""
    level = -0.10 * plan.high / 2
    edge = plan.at(-0.10, -1)
    inward = 0.003 if plan.style == "rimless" else 0.0
    course = ag.spline(
        [
            (edge + inward, 0.0008, level + 0.003),
            (edge - 0.0004, 0.0045, level + 0.0045),
            (edge + 0.0006, 0.0068, level + 0.002),
            (edge - 0.0008, 0.0078, level),
        ]
    )
    arm = ag.sweep(ag.circle(0.00055), course)
    pad = ag.ellipsoid(0.0014, 0.0036, 0.0066).rotate(ag.Y, -0.35).rotate(ag.Z, -0.45)
    return [
        ag.part(plan.pair(arm), "nose_pad", plan.metal, separate="an arm at each side"),
        ag.part(plan.pair(pad.at(edge - 0.0016, 0.0082, level)), "nose_pad", _PAD, separate="two pads"),
    ]


def _lugs(plan: _Plan) -> list[ag.Body]:
    """Make the end pieces of metal, bent back to the hinges."""
    start = plan.at(_HIGH[plan.shape], 1) - (0.006 if plan.style == "rimless" else 0.0002)
    tall = 0.0042
    lugs = []
    y0 = start * ag.sin(plan.wrap) - (0.0010 if plan.style == "rimless" else 0.0)
    for side in (-1, 1):
        z = (plan.level - tall / 2, plan.level + tall / 2)
        outer = plan.side
        turn = outer * ag.sin(plan.wrap)
        across = ag.hull(
            ag.Region((start, start + 0.002), (y0 - 0.0008, y0 + 0.0006), z).box(bevel=0.0003),
            ag.Region((outer - 0.003, outer - 0.0012), (turn - 0.0008, turn + 0.0006), z).box(bevel=0.0003),
        )
        corner = ag.hull(
            ag.Region((outer - 0.003, outer - 0.0012), (turn - 0.0008, turn + 0.0006), z).box(bevel=0.0003),
            ag.Region((outer - plan.thick, outer), (turn + 0.0010, turn + 0.0024), z).box(bevel=0.0003),
        )
        arm = ag.Region((outer - plan.thick, outer), (turn + 0.0010, plan.back), z).box(bevel=0.0003)
        foot = ag.Region((plan.pivot.x - _BARREL, outer), (plan.back - 0.0012, plan.back), z).box(
            bevel=0.0002
        )
        lug = ag.union(across, corner, arm, foot)
        lugs.append(lug if side > 0 else lug.mirror(ag.X))
    return [ag.part(lugs, "end_piece", plan.metal, separate="end pieces of both lenses")]


def _temple(plan: _Plan, name: str, low: ag.Scalar, spring: float, cover: ag.Material, maker: str) -> ag.Body:
    """Make a folded temple, whose tip comes down to a level."""
    start = plan.back + 0.0002 + 2.8 * spring / 1000
    way, slope = plan.length - 0.0035, ag.tan(plan.slant)
    course = _course(plan, way, slope, low)
    solid = _drawn(plan, course, start, way, 0.0, 1.0 if plan.full else 0.69)
    tip = solid if plan.full else _drawn(plan, course, start, way, 0.44, 1.0, sleeve=True)
    face = plan.finish if plan.full else cover
    wide, share, tall = (plan.thick, 0.30, 0.0021) if plan.full else (_SLEEVE, 0.475, 0.0013)
    x, y, z = plan.pivot.x, plan.pivot.y, plan.pivot.z
    middle = ag.vector(plan.side - plan.thick / 2, start + share * way, z - share * way * slope)
    held = share if name == "left" else 0.52 if plan.full else 0.55  # beside the other temple
    at = middle + (held - share) * way * ag.vector(0.0, 1.0, -slope)
    across = ag.vector(0.0, ag.sin(plan.slant), ag.cos(plan.slant))
    hold = ag.grasp_on(tip, approach=-ag.X, closing=across, at=at, depth=wide)
    room = ag.Region((x, plan.side - plan.thick + 0.0004), (y - 0.0008, y + 0.0060), (z, z + _KNUCKLE))
    hinge = (ag.cylinder(_BARREL, _KNUCKLE).at(x, y, z + _KNUCKLE / 2) | room.box()).at(z=-_KNUCKLE / 2)
    sizes = f"{round(1000 * plan.wide)} {round(1000 * plan.bridge)} {round(1000 * plan.length)}"
    words = details.lettering((sizes if name == "right" else maker.upper(),), tall).rotate(plan.slant)
    inside, ink = middle - ag.vector(wide / 2), controls.ink_on(face)
    bodies = [
        ag.part(solid, "temple", plan.finish, name=f"temple_{name}", grasp=hold if plan.full else ()),
        ag.part(hinge, "hinge", plan.metal),
        details.printed(words, inside, facing=-ag.X, up=ag.Z, material=ink, proud=0.00008),
    ]
    if plan.full:
        mark = details.logo(maker, 0.0020).rotate(-plan.slant)
        spot = (plan.side, start + 0.17 * way, z - 0.17 * way * slope)
        bodies.append(details.printed(mark, spot, facing=ag.X, up=ag.Z, material=plan.metal, proud=0.0001))
    else:
        bodies.append(ag.part(tip, "tip", cover, name=f"tip_{name}", grasp=hold))
    fold = math.pi / 2 - (plan.lean if name == "right" else 0.0)
    body = ag.weld(*bodies).rotate(ag.Z, fold, about=(x, y, z))
    return body.mirror(ag.X) if name == "left" else body


def _course(
    plan: _Plan, way: float, slope: ag.Scalar, low: ag.Scalar
) -> list[tuple[float, ag.Scalar, ag.Scalar]]:
    """Return the middle of a temple: shares of its way with x and z; its end comes down to a level [m]."""
    rounded = len(_ROUNDED)
    turns = sum((b - a) * (u + v) / 2 for (a, u), (b, v) in itertools.pairwise(_COURSE[:-rounded]))
    drop = plan.level - low - _end(plan) / 2 - slope * way * _COURSE[-1 - rounded][0]
    z, course = plan.level, []
    for number, (at, turned) in enumerate(_COURSE):
        if 0 < number < len(_COURSE) - rounded:
            before, less = _COURSE[number - 1]
            z = z - (at - before) * (slope * way + drop / turns * (turned + less) / 2)
        sunk = (1.0 - _ROUNDED.get(at, 1.0)) * _end(plan) / 2  # the lower side of the end is flat
        course.append((at, plan.side - plan.thick / 2 - 0.004 * turned**2, z - sunk))
    return course


def _drawn(
    plan: _Plan,
    course: list[tuple[float, ag.Scalar, ag.Scalar]],
    start: ag.Scalar,
    way: float,
    first: float,
    last: float,
    *,
    sleeve: bool = False,
) -> ag.Solid:
    """Make a piece of a temple between two shares of its way."""
    profiles, places = [], []
    for at, x, z in course:
        if first <= at <= last:
            tall, thin = _section(plan, at, sleeve=sleeve)
            thin, cut = (0.5 * thin, 0.25 * thin) if at == 0.0 else (thin, 0.0)  # its outer corner is cut
            profiles.append(ag.rectangle(thin, tall, radius=0.30 * thin).at(x - cut, z))
            places.append(start + at * way)
    return ag.loft(profiles, places, axis=ag.Y)


def _end(plan: _Plan) -> float:
    """Return the height of the end of a temple [m]."""
    return 0.0062 if plan.full else 0.0048


def _section(plan: _Plan, at: float, *, sleeve: bool = False) -> tuple[ag.Scalar, float]:
    """Return height and thickness of a temple at a share of its way [m]."""
    bent = min(max((at - 0.64) / 0.2, 0.0), 1.0)
    last, thin = _ROUNDED.get(at, 1.0), 0.7 if at == 1.0 else 1.0
    if sleeve:
        return (0.0036 + bent * (_end(plan) - 0.0036)) * last, _SLEEVE * thin
    least = 0.0045 if plan.full else 0.0018
    if at <= 0.64 or not plan.full:
        return plan.broad + min(at / 0.64, 1.0) ** 0.8 * (least - plan.broad), plan.thick
    return (least + bent * (_end(plan) - least)) * last, plan.thick * thin
