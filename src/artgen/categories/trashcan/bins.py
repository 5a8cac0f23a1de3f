"""Bins: the shells of round, square, rectangular and half-round containers, their stands and inner buckets.

A bin is about the z axis, with its front towards -y. Its plan is given at the rim; a tapered bin is smaller
at its foot, with the same proportions.

The visible wall is a smooth skin. The mass and the colliders are a wall of few facets inside it; the skin is
thicker than this wall by the distance of the facets from the curves. Facets, not edges, are at the front and
the back.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import recycling
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import feet
from artgen.categories.trashcan import finish

Plan = Literal["round", "square", "rectangle", "half_round"]  # the last has its flat side at the back
Dress = Literal["plain", "base_band", "beads", "ring"]  # bands around the wall; the ring is bright
Carry = Literal["none", "loop", "bail"]  # handle of an inner bucket; none for no bucket
LidStyle = Literal["flat", "domed", "stepped"]  # a slab, a cushion, or a slab with a smaller slab on it
Sort = Literal["none", "recycling", "paper", "plastic", "glass", "food"]  # kind of waste shown on a bin

GAP = 0.0023  # gap between the rim and the lid [m]
LOWER = 0.0003  # distance of a bucket's rim below that of the bin [m]
UNDER = 0.0036  # distance from the floor's underside to the bucket: the floor and 0.6 mm [m]
FREE = 0.0036  # gap between a bucket and the wall [m]
STEEL = ag.material("steel")
_BUCKET = 0.0022  # thickness of the wall of a bucket [m]
_BACK_CORNER = 0.022  # radius of the two corners of a half-round bin [m]
_LEAST_CORNER = 0.003  # least radius of corners [m]
_NO_SIDES = "the bucket has no room in a half-round bin: raise width or aspect"

_SIDES = 16  # facets of the collider of a round wall: 3 mm off a circle of 160 mm; more cost simulation time
_FRONT = 7  # number of facets of the round front of a half-round bin
_CORNER = 2  # number of facets of a corner
_HAIR = 0.0003  # depth of the edges of the collider below the visible surface [m]
_THIN = 0.00005  # depth of its loaded ends below the visible surface [m]

_WIRE = 0.0028  # radius of the bail [m]
_REACH = 0.62  # forward reach of the bail, as a share of half the bucket's depth
_BEHIND = 0.028  # distance from the wall to the middle of a loop, with space for a finger between them [m]


@dataclass(frozen=True)
class Can:
    """The shell of a bin."""

    plan: Plan  # plan shape
    width: ag.Scalar  # width at the rim [m]
    depth: ag.Scalar  # depth from front to back at the rim; the width for a round bin [m]
    top: ag.Scalar  # height of the rim above the floor [m]
    foot: ag.Scalar = 0.005  # height of the lower edge of the wall above the floor [m]
    corner: ag.Scalar = 0.03  # radius of the corners of a square or rectangular bin, at the rim [m]
    sheet: ag.Scalar = 0.003  # thickness of the wall that has mass and colliders [m]
    taper: ag.Scalar = 0.0  # share by which the foot is smaller than the rim

    @property
    def wall(self) -> ag.Scalar:
        """Thickness of the visible wall [m]."""
        turns = {"round": math.tau / _SIDES, "half_round": math.pi / _FRONT}
        radius = self.width / 2 if self.plan in turns else self.corner
        # height of a facet's arc above its chord, as a share of the radius
        off = 1 - math.cos(turns.get(self.plan, math.pi / 2 / _CORNER) / 2)
        return _HAIR + off * radius + self.sheet

    def outline(self, inset: ag.Scalar = 0.0) -> ag.Profile:
        """Make the outline at the rim, moved inward [m]."""
        radius, back = self.width / 2 - inset, self.depth / 2 - inset
        if self.plan == "round":
            return ag.circle(radius)
        if self.plan != "half_round":
            return ag.rectangle(2 * radius, 2 * back, radius=ag.max_(self.corner - inset, _LEAST_CORNER))
        corner = ag.max_(_BACK_CORNER - inset, _LEAST_CORNER)
        front = radius - back  # middle of the round front
        straight = ag.rectangle(2 * radius, back - front + corner, radius=corner)
        below = ag.rectangle(3 * radius, 2 * radius).at(0, front - radius + 0.001)  # both halves overlap
        return (ag.circle(radius).at(0, front) & below) | straight.at(0, (back + front - corner) / 2)

    def facets(self, inset: ag.Scalar) -> ag.Profile:
        """Make the outline of few facets, with its edges on the outline, moved inward [m]."""
        x, y = self.width / 2 - inset, self.depth / 2 - inset
        if self.plan == "round":
            start = math.pi / _SIDES
            return ag.polygon(_arc(0, 0, x, start, start + math.tau, _SIDES)[:-1])
        if self.plan == "half_round":
            corner = ag.max_(_BACK_CORNER - inset, _LEAST_CORNER)
            front = _arc(0, x - y, x, -math.pi, 0, _FRONT)
        else:
            corner = ag.max_(self.corner - inset, _LEAST_CORNER)
            front = [*_corner(-x, -y, corner, 2), *_corner(x, -y, corner, 3)]
        return ag.polygon([*front, *_corner(x, y, corner, 0), *_corner(-x, y, corner, 1)])

    def scale_at(self, z: ag.Scalar) -> ag.Scalar:
        """Return the scale of the plan at a height, relative to the rim."""
        return 1 - self.taper * (self.top - z) / (self.top - self.foot)

    def narrowing(self, low: ag.Scalar, high: ag.Scalar) -> ag.Scalar:
        """Return the taper of the part between two heights."""
        return 0.0 if _is_zero(self.taper) else 1 - self.scale_at(low) / self.scale_at(high)

    def drawn(self, section: ag.Profile, low: ag.Scalar, high: ag.Scalar) -> ag.Solid:
        """Make a solid between two heights from its section at the rim."""
        middle = (low + high) / 2
        if _is_zero(self.taper):
            return ag.extrude(section, high - low).at(z=middle)
        section, taper = section.scale(self.scale_at(high)), self.narrowing(low, high)
        return ag.extrude(section, high - low, axis=-ag.Z, taper=taper).at(z=middle)

    def band(
        self, low: ag.Scalar, high: ag.Scalar, outer: ag.Scalar = 0.0, inner: ag.Scalar | None = None
    ) -> ag.Solid:
        """Make a ring along the wall between two heights; `inner` is the depth of its inside [m]."""
        within = self.wall if inner is None else inner
        return self.drawn(self.outline(outer) - self.outline(within), low, high)

    def floor(self, low: ag.Scalar, high: ag.Scalar) -> ag.Solid:
        """Make a floor between two heights, with its edge in the wall."""
        return self.drawn(self.facets(2 * _HAIR), low, high)

    def shell(self, label: str, material: ag.Material, *, holes: ag.Solid | None = None) -> list[ag.Body]:
        """Make the wall from the foot to the rim: a core with mass and colliders, and its skin."""
        seen = self.band(self.foot, self.top)
        ring = self.facets(_HAIR) - self.facets(_HAIR + self.sheet)
        solid = self.drawn(ring, self.foot + _THIN, self.top - _THIN)
        if holes is not None:
            solid, seen = solid - holes, seen - holes
        return [ag.part(solid, label, material), ag.detail(seen, label, material)]

    def inside(
        self, *, foot: ag.Scalar, top: ag.Scalar, beside: ag.Scalar = 0.0, behind: ag.Scalar = 0.0
    ) -> "Can":
        """Return the inner bucket between two heights, with a gap all around."""
        less, share = 2 * (self.wall + FREE), self.scale_at(top)
        deep = self.depth * share - less - 2 * behind
        wide = deep if self.plan == "round" else self.width * share - less - 2 * beside
        if self.plan == "half_round":  # the sides are straight from the round front to the back corners
            deep = ag.require(deep, deep - wide / 2 > _BACK_CORNER + 0.001, _NO_SIDES)
        corner = ag.min_(self.corner * share - less / 2, 0.45 * ag.min_(wide, deep))
        corner = ag.max_(corner, _LEAST_CORNER)
        taper = self.narrowing(foot, top)
        return Can(self.plan, wide, deep, top, foot, corner, _BUCKET, taper)

    def half_across(self) -> ag.Scalar:
        """Return half the width of the space inside, through the middle of the plan [m]."""
        radius = self.width / 2 - self.wall
        if self.plan != "half_round":
            return radius
        # distance from the middle to the center of the front's circle, which is in front of it for a deep bin
        behind = ag.max_((self.width - self.depth) / 2, 0.0)
        return ag.sqrt(radius * radius - behind * behind)

    @property
    def diagonal(self) -> ag.Scalar:
        """Distance from the middle to the farthest point of a corner, for bins with corners [m]."""
        corner = _BACK_CORNER if self.plan == "half_round" else self.corner
        x, y = self.width / 2 - corner, self.depth / 2 - corner
        return ag.sqrt(x * x + y * y) + corner


def _arc(
    x: ag.Scalar, y: ag.Scalar, radius: ag.Scalar, start: float, end: float, facets: int
) -> list[tuple[ag.Scalar, ag.Scalar]]:
    turns = [start + (end - start) * number / facets for number in range(facets + 1)]
    return [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]


def _corner(x: ag.Scalar, y: ag.Scalar, radius: ag.Scalar, quarter: int) -> list[tuple[ag.Scalar, ag.Scalar]]:
    """Return the edges of a rounded corner in a quarter of the plan, numbered from +x, +y [m]."""
    right, behind = (1, -1, -1, 1)[quarter], (1, 1, -1, -1)[quarter]
    start = quarter * math.pi / 2
    return _arc(x - right * radius, y - behind * radius, radius, start, start + math.pi / 2, _CORNER)


def pair(solid: ag.Solid, x: ag.Scalar, y: ag.Scalar = 0.0, z: ag.Scalar = 0.0) -> list[ag.Solid]:
    """Place a solid at both sides, at -x and x."""
    return [solid.at(-x, y, z), solid.at(x, y, z)]


def _is_zero(value: ag.Scalar) -> bool:
    return isinstance(value, int | float) and value == 0


@dataclass(frozen=True, kw_only=True)
class Design:
    """Everything that the kinds of bins share: the shell, materials, equipment and mechanisms."""

    can: Can  # shell of the bin
    finish: ag.Material  # finish of the wall
    lid_finish: Literal["same", "plastic", "steel"]  # finish of the lid or hood
    trim: ag.Material  # material of rim, base and hinge
    dress: Dress  # bands around the wall
    carry: Carry  # handle of the inner bucket
    bucket: ag.Material  # material of the inner bucket
    maker: str  # brand name
    model: int  # model number
    lid_style: LidStyle  # shape of a hinged lid
    opening: ag.Scalar  # opening angle of the lid [rad]
    friction: ag.Scalar  # friction of the lid's hinge [N m]
    damper: bool  # whether the lid closes softly
    crank: ag.Scalar  # length of the lid's crank [m]
    travel: ag.Scalar  # travel of the foot plate [m]
    pedal_width: ag.Scalar  # width of the foot plate [m]
    preload: ag.Scalar  # spring force at the foot plate at rest [N]
    force: ag.Scalar  # spring force at the pressed foot plate [N]

    @property
    def plastic(self) -> ag.Material:
        """Material of hidden parts and of hinges."""
        return finish.BLACK if self.trim.base_metalness > 0.5 else self.trim

    @property
    def lid(self) -> ag.Material:
        """Material of a hollow lid: sheet of 0.4 mm over a thin liner, 3.7 kg/m2 at a thickness of 12 mm."""
        shown = {"same": self.finish, "plastic": self.plastic, "steel": finish.BARE}[self.lid_finish]
        return finish.lid_of(shown, 310.0)

    @property
    def damping(self) -> float:
        """Damping of the lid's hinge, with a damper for soft closing [N m s/rad]."""
        return 0.16 if self.damper else 0.05


def stand(
    design: Design, *, floor: ag.Scalar | None = None, holes: ag.Solid | None = None, rim: bool = True
) -> ag.Body:
    """Make the wall, floor, feet and trim of a bin: the link `body`."""
    can, trim = design.can, design.trim
    floor = can.foot if floor is None else floor
    has_corners = can.plan in ("square", "rectangle")
    share, inset = can.scale_at(can.foot), 0.024 + (0.3 * can.corner if has_corners else 0.0)
    x, y = share * can.width / 2 - inset, share * can.depth / 2 - inset
    front, back = {"round": (math.sqrt(0.5), math.sqrt(0.5)), "half_round": (0.62, 1)}.get(can.plan, (1, 1))
    places = [(-front * x, -front * y), (front * x, -front * y), (back * x, back * y), (-back * x, back * y)]
    bodies = [
        *can.shell("body", design.finish, holes=holes),
        ag.part(can.floor(floor, floor + 0.003), "base", trim),
        feet(places, height=floor, radius=0.008),
    ]
    if rim:
        edge = can.band(can.top - 0.014, can.top + 0.0006, -0.0012, can.wall + 0.0008)
        bodies.append(ag.detail(edge, "rim", trim))
    beads = [can.foot + part * (can.top - can.foot) for part in (0.30, 0.36)]
    bands, label, material = {
        "plain": ([], "body", trim),
        "base_band": ([can.band(can.foot - 0.001, can.foot + 0.020, -0.0012, 0.0008)], "base", trim),
        "beads": ([can.band(z, z + 0.005, -0.0014, 0.0010) for z in beads], "body", design.finish),
        "ring": ([can.band(can.top - 0.050, can.top - 0.044, -0.0018, 0.0010)], "rim", ag.material("chrome")),
    }[design.dress]
    if bands:
        bodies.append(ag.detail([each if holes is None else each - holes for each in bands], label, material))
    return ag.weld(*bodies)


def prints(design: Design, sort: Sort, *, named: bool) -> list[ag.Body]:
    """Print the kind of waste on the front, and the maker's name, small enough for a round front."""
    can, flat = design.can, design.can.plan in ("square", "rectangle")
    facing = (0, -1, -0.5 * can.depth * can.taper / (can.top - can.foot))  # a tapered front points down
    ink, bodies = finish.ink_on(design.finish, metal=False), []
    level, word = 0.55 * can.top, {"recycling": "", "food": "FOOD WASTE"}.get(sort, sort.upper())
    marks: list[tuple[ag.Profile, ag.Scalar, ag.Material, float]] = []
    if sort != "none":
        marks.append((recycling(0.075 if flat else 0.10 * can.width), level, ink, 0.0008))
        if word and flat:
            line = details.lettering((word,), 0.012, tracking=0.12, fineness="coarse")
            marks.append((line, level - 0.065, ink, 0.0008))
    if named:
        logo = details.logo(design.maker, 0.010 * can.width, tracking=0.15)
        marks.append((logo, 0.09, finish.ink_on(design.finish), 0.0006))
    for profile, z, material, proud in marks:
        at = (0, -can.scale_at(z) * can.depth / 2, z)
        bodies.append(details.printed(profile, at, material=material, facing=facing, proud=proud))
    return bodies


def with_bucket(
    body: ag.Body, design: Design, can: Can, travel: ag.Scalar, needs: ag.Condition | None = None
) -> ag.Body:
    """Put a bucket into a bin, which lifts out by its loop or bail: the link `bucket`."""
    material = design.bucket
    lip = can.band(can.top - 0.010, can.top, -0.0012, 0.0005)
    bucket = ag.weld(
        *can.shell("bucket", material),
        ag.part(can.floor(can.foot, can.foot + 0.0022), "bucket", material),
        ag.detail(lip, "bucket", material),
    )
    if design.carry == "loop":
        bucket = ag.weld(bucket, _loop(can, material))
    elif design.carry == "bail":
        bucket = _with_bail(bucket, can, needs)
    # friction at the wall: a lid that leans on the bucket must not hold it up; force of a hand that lifts
    # the bucket but cannot force the lid open
    drag = feel.Feel(friction=0.15, damping=2.0, effort=1.1 * bucket.weight() + 1.0)
    slide = ag.Prismatic("bucket_slide", axis=ag.Z, limits=(0.0, travel), feel=drag, needs=needs)
    return body.attach(bucket, slide)


def _loop(can: Can, material: ag.Material) -> ag.Body:
    """Make a horizontal bar inside the rim, on two ribs, for fingers behind it."""
    wall, z = 0.6 * can.wall - can.depth / 2, can.top - 0.006
    # shorter in a narrow bucket: its ribs are clear of the corners
    corner = can.corner if can.plan in ("square", "rectangle") else 0.0
    beside = ag.min_(0.028, can.width / 2 - 0.5 * corner - 0.003)
    bar = ag.box(2 * (beside + 0.004), 0.009, 0.011, bevel=0.003).at(0, wall + _BEHIND, z)
    rib = ag.box(0.006, _BEHIND, 0.009, bevel=0.0015)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, depth=0.010)
    solids = [bar, *pair(rib, beside, wall + _BEHIND / 2, z)]
    return ag.part(solids, "bucket", casting(material), grasp=hold)  # pressed of sheet, or molded hollow


def _with_bail(bucket: ag.Body, can: Can, needs: ag.Condition | None) -> ag.Body:
    """Attach a wire bail to a bucket, at rest level with the rim, to the front: the link `handle`."""
    # the sides of the front of a half-round bucket converge immediately
    half = can.half_across()
    x = half - (0.005 if can.plan == "half_round" else 0.0) - _WIRE - 0.0022
    y, z = -_REACH * can.depth / 2, can.top - _WIRE
    right = [(x, 0, z), (0.93 * x, 0.45 * y, z), (0.55 * x, 0.88 * y, z)]
    path = ag.spline([*right, (0, y, z), *((-x, y, z) for x, y, z in reversed(right))])
    wire = ag.simplified_collider(ag.sweep(ag.circle(_WIRE), path), 0.00075)
    grip = ag.cylinder(0.0058, 0.07, axis=ag.X, bevel=0.0015).at(0, y, z - 0.003)
    hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.Y)
    bail = ag.weld(ag.part(wire, "handle", STEEL), ag.part(grip, "handle", finish.BLACK, grasp=hold))
    inner, outer = x + _WIRE + 0.0005, half + 0.001
    eyes = pair(ag.cylinder(0.004, outer - inner, axis=ag.X), (inner + outer) / 2, z=z)
    weight = bail.weight() * -bail.center_of_mass().y
    strikes = 0.9 * (GAP + LOWER) / -y  # just below the angle at which the bail strikes a part above the rim
    free = None if needs is None else needs.beyond(strikes)
    # the bail stays up, as its bent ends grip the eyes; the effort raises it but cannot force the lid open
    drag = feel.Feel(
        friction=1.2 * weight, damping=0.01, armature=0.0002, effort=3.2 * weight + 0.01, velocity=8.0
    )
    hinge = ag.Revolute("handle_hinge", axis=-ag.X, pivot=(0, 0, z), limits=(0.0, 1.5), feel=drag, needs=free)
    return ag.weld(bucket, ag.detail(eyes, "bucket", STEEL)).attach(bail, hinge)
