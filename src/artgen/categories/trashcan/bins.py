"""Bins: the shells of round, square, rectangular and half-round containers, and the bands around them.

A bin is about the z axis, with its front towards -y. Its plan is given at the rim; a tapered bin is smaller
at its foot, with the same proportions.

The visible wall is a smooth skin. The mass and the colliders are a wall of few facets inside it; the skin is
thicker than this wall by the distance of the facets from the curves. Facets, not edges, are at the front and
the back.
"""

import math
from dataclasses import dataclass, replace
from typing import Literal

import artgen as ag

Plan = Literal["round", "square", "rectangle", "half_round"]
"""Plan shape; a half-round bin has its flat side at the back, for a place at a wall."""

_BACK_CORNER = 0.022  # radius of the two corners of a half-round bin [m]
_OVERLAP = 0.001  # overlap of the two halves of a half-round bin [m]
_LEAST_CORNER = 0.003  # least radius of corners [m]
_NO_SIDES = "the bucket has no room in a half-round bin: raise width or aspect"

SIDES = 16
"""Facets of the collider of a round wall: 3 mm off a circle of 160 mm; more facets cost simulation time."""

_FRONT = 7  # number of facets of the round front of a half-round bin
_CORNER = 2  # number of facets of a corner

_HAIR = 0.0003  # depth of the edges of the collider below the visible surface [m]
_THIN = 0.00005  # depth of its loaded ends below the visible surface [m]


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
        match self.plan:
            case "round":
                off = _off(math.tau / SIDES) * self.width / 2.0
            case "half_round":
                off = _off(math.pi / _FRONT) * self.width / 2.0
            case _:
                off = _off(math.pi / 2.0 / _CORNER) * self.corner
        return _HAIR + off + self.sheet

    def outline(self, inset: ag.Scalar = 0.0) -> ag.Profile:
        """Make the outline at the rim, moved inward [m]."""
        if self.plan == "round":
            return ag.circle(self.width / 2.0 - inset)
        if self.plan == "half_round":
            return self._half_round(inset)
        across, along = self.width - 2.0 * inset, self.depth - 2.0 * inset
        return ag.rectangle(across, along, radius=ag.max_(self.corner - inset, _LEAST_CORNER))

    def facets(self, inset: ag.Scalar) -> ag.Profile:
        """Make the outline of few facets, with its edges on the outline, moved inward [m]."""
        x, y = self.width / 2.0 - inset, self.depth / 2.0 - inset
        if self.plan == "round":
            start = math.pi / SIDES
            return ag.polygon(_arc(0.0, 0.0, x, start, start + math.tau, SIDES)[:-1])
        if self.plan == "half_round":
            corner = ag.max_(_BACK_CORNER - inset, _LEAST_CORNER)
            front = _arc(0.0, x - y, x, -math.pi, 0.0, _FRONT)
        else:
            corner = ag.max_(self.corner - inset, _LEAST_CORNER)
            front = [*_corner(-x, -y, corner, 2), *_corner(x, -y, corner, 3)]
        return ag.polygon([*front, *_corner(x, y, corner, 0), *_corner(-x, y, corner, 1)])

    def _half_round(self, inset: ag.Scalar) -> ag.Profile:
        radius, corner = self.width / 2.0 - inset, ag.max_(_BACK_CORNER - inset, _LEAST_CORNER)
        back = self.depth / 2.0 - inset
        front = radius + inset - self.depth / 2.0  # middle of the round front
        straight = ag.rectangle(2.0 * radius, back - front + corner, radius=corner)
        below = ag.rectangle(3.0 * radius, 2.0 * radius).at(0.0, front - radius + _OVERLAP)
        half = ag.circle(radius).at(0.0, front) & below
        return half | straight.at(0.0, (back + front - corner) / 2.0)

    def scale_at(self, z: ag.Scalar) -> ag.Scalar:
        """Return the scale of the plan at a height, relative to the rim."""
        return 1.0 - self.taper * (self.top - z) / (self.top - self.foot)

    def band(
        self, low: ag.Scalar, high: ag.Scalar, *, outer: ag.Scalar = 0.0, inner: ag.Scalar | None = None
    ) -> ag.Solid:
        """Make a ring that follows the wall between two heights."""
        within = self.wall if inner is None else inner
        section = self.outline(outer) - self.outline(within)
        return self._drawn(section, low, high)

    def block(
        self, low: ag.Scalar, high: ag.Scalar, *, inset: ag.Scalar = 0.0, bevel: ag.Scalar = 0.0
    ) -> ag.Solid:
        """Make the filling of the plan between two heights, moved inward [m]."""
        if self.plan == "round" and _is_zero(self.taper):
            disc = ag.cylinder(self.width / 2.0 - inset, high - low, bevel=bevel)
            return disc.at(0.0, 0.0, (low + high) / 2.0)
        return self._drawn(self.outline(inset), low, high, bevel)

    def floor(self, low: ag.Scalar, high: ag.Scalar) -> ag.Solid:
        """Make a floor between two heights, with its edge in the wall."""
        return self._drawn(self.facets(2.0 * _HAIR), low, high)

    def _drawn(
        self, section: ag.Profile, low: ag.Scalar, high: ag.Scalar, bevel: ag.Scalar = 0.0
    ) -> ag.Solid:
        middle = (low + high) / 2.0
        if _is_zero(self.taper):
            return ag.extrude(section, high - low, bevel=bevel).at(0.0, 0.0, middle)
        share = self.scale_at(high)
        narrower = 1.0 - self.scale_at(low) / share
        drawn = ag.extrude(section.scale(share), high - low, axis=-ag.Z, taper=narrower, bevel=bevel)
        return drawn.at(0.0, 0.0, middle)

    def shell(
        self, label: str, finish: ag.Material, *, name: str | None = None, holes: ag.Solid | None = None
    ) -> list[ag.Body]:
        """Make the wall from the foot to the rim: a core with mass and colliders, and its skin."""
        seen = self.band(self.foot, self.top)
        ring = self.facets(_HAIR) - self.facets(_HAIR + self.sheet)
        solid = self._drawn(ring, self.foot + _THIN, self.top - _THIN)
        if holes is not None:
            solid, seen = solid - holes, seen - holes
        return [ag.part(solid, label, finish, name=name), ag.detail(seen, label, finish)]

    def inside(
        self,
        gap: ag.Scalar,
        *,
        foot: ag.Scalar,
        top: ag.Scalar,
        sheet: ag.Scalar,
        beside: ag.Scalar = 0.0,
        behind: ag.Scalar = 0.0,
    ) -> "Can":
        """Return the inner bucket, with a gap all around."""
        less = 2.0 * (self.wall + gap)
        share = self.scale_at(top)
        narrower = 1.0 - self.scale_at(foot) / share if not _is_zero(self.taper) else 0.0
        round_ = self.plan == "round"
        deep = self.depth * share - less - 2.0 * behind
        wide = deep if round_ else self.width * share - less - 2.0 * beside
        if self.plan == "half_round":  # the sides are straight from the round front to the back corners
            deep = ag.require(deep, deep - wide / 2.0 > _BACK_CORNER + 0.001, _NO_SIDES)
        corner = ag.min_(self.corner * share - less / 2.0, 0.45 * ag.min_(wide, deep))
        return replace(
            self,
            width=wide,
            depth=deep,
            corner=ag.max_(corner, _LEAST_CORNER),
            foot=foot,
            top=top,
            sheet=sheet,
            taper=narrower,
        )

    @property
    def front(self) -> ag.Scalar:
        """Position of the front wall at the rim, along y [m]."""
        return -self.depth / 2.0

    @property
    def back(self) -> ag.Scalar:
        """Position of the back wall at the rim, along y [m]."""
        return self.depth / 2.0

    def feet(self, inset: ag.Scalar = 0.016) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Return the positions of four feet at the corners of the foot [m]."""
        share = self.scale_at(self.foot)
        x, y = share * self.width / 2.0 - inset, share * self.depth / 2.0 - inset
        if self.plan == "round":
            x, y = math.sqrt(0.5) * x, math.sqrt(0.5) * y
            return [(-x, -y), (x, -y), (x, y), (-x, y)]
        if self.plan == "half_round":
            return [(-0.62 * x, -0.62 * y), (0.62 * x, -0.62 * y), (x, y), (-x, y)]
        near = 0.3 * self.corner
        x, y = x - near, y - near
        return [(-x, -y), (x, -y), (x, y), (-x, y)]

    def face(self, z: ag.Scalar) -> ag.Vector:
        """Return the middle point of the front at a height [m]."""
        return ag.vector(0.0, self.scale_at(z) * self.front, z)

    @property
    def facing(self) -> ag.VectorLike:
        """Direction of the front; a tapered front points slightly down."""
        return (0.0, -1.0, -0.5 * self.depth * self.taper / (self.top - self.foot))

    @property
    def diagonal(self) -> ag.Scalar:
        """Distance from the middle to the farthest point of a corner, for bins with corners [m]."""
        corner = _BACK_CORNER if self.plan == "half_round" else self.corner
        x, y = self.width / 2.0 - corner, self.depth / 2.0 - corner
        return ag.sqrt(x * x + y * y) + corner

    def half_across(self, inset: ag.Scalar = 0.0) -> ag.Scalar:
        """Return half the width through the middle of the plan [m]."""
        radius = self.width / 2.0 - inset
        if self.plan != "half_round":
            return radius
        # distance from the middle to the center of the front's circle, which is in front of it for a deep bin
        behind = ag.max_((self.width - self.depth) / 2.0, 0.0)
        return ag.sqrt(radius * radius - behind * behind)


def _off(turn: float) -> float:
    """Return the sagitta of a chord over an angle [rad], as a share of the radius."""
    return 1.0 - math.cos(turn / 2.0)


def _arc(
    x: ag.Scalar, y: ag.Scalar, radius: ag.Scalar, start: float, end: float, facets: int
) -> list[tuple[ag.Scalar, ag.Scalar]]:
    turns = [start + (end - start) * number / facets for number in range(facets + 1)]
    return [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]


def _corner(x: ag.Scalar, y: ag.Scalar, radius: ag.Scalar, quarter: int) -> list[tuple[ag.Scalar, ag.Scalar]]:
    """Return the edges of a rounded corner in a quarter of the plan, numbered from +x, +y [m]."""
    right, behind = (1.0, -1.0, -1.0, 1.0)[quarter], (1.0, 1.0, -1.0, -1.0)[quarter]
    start = quarter * math.pi / 2.0
    return _arc(x - right * radius, y - behind * radius, radius, start, start + math.pi / 2.0, _CORNER)


def _is_zero(value: ag.Scalar) -> bool:
    return isinstance(value, int | float) and value == 0.0
