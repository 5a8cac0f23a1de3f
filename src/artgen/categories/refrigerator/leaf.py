"""Opening doors of a refrigerator: leaves, their hinges, and the angles that drawers need."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.refrigerator.case import SEAL_GAP, Case, Cell

_HAND = 60.0  # largest pull of a hand; 15-45 N open a refrigerator [N]


def door_swing(
    name: str,
    *,
    pivot: ag.VectorLike,
    way: int,
    limit: ag.Scalar,
    pull: ag.Scalar,
    arm: ag.Scalar,
    damping: ag.Scalar = 1.0,
) -> ag.Joint:
    """Make the vertical hinge of a door; friction holds the door at any angle.

    Opening a refrigerator needs 15-45 N at its handle against the gasket, and about 5 N further on; a joint
    has one friction over its range, so `pull` is the low end of the first force.
    """
    return ag.Revolute(
        name,
        pivot=pivot,
        axis=(0.0, 0.0, way),
        limits=(0.0, limit),
        friction=pull * arm,
        damping=damping,
        effort=_HAND * arm,
        velocity=4.0,
    )


def hinge_cover(
    *, finish: ag.Material, way: int, inset: ag.Scalar, reach: ag.Scalar = 0.11, high: ag.Scalar = 0.018
) -> ag.Body:
    """Make the cover of the upper hinge on top of a cabinet; the axis is the z axis, the top is z = 0.

    It projects over the door in front of it.
    """
    wide, lead = 0.052, 0.017  # width of the cover, and its reach in front of the axis [m]
    cap = ag.extrude(ag.rectangle(wide, reach + lead, radius=0.010), high, bevel=0.004)
    x = way * (inset - 0.004 - wide / 2)
    return ag.part(cap.at(x, (reach - lead) / 2, high / 2), "hinge", finish)


def hinge_bracket(
    *, finish: ag.Material, way: int, inset: ag.Scalar, back: ag.Scalar, thick: ag.Scalar = 0.0018
) -> ag.Body:
    """Make the visible bracket in the gap under a door: a plate with a pin through it, about z = 0."""
    wide = inset + 0.018
    plate = ag.box(wide, back + 0.012, thick, bevel=0.0005).at(
        way * (inset - wide / 2 - 0.002), (back - 0.010) / 2, 0.0
    )
    pin = ag.cylinder(0.0055, thick + 0.0012, axis=ag.Z)  # visible thickness between two fronts
    return ag.weld(ag.detail(plate, "hinge", finish), ag.detail(pin, "hinge", finish))


def door_gasket(
    width: ag.Scalar,
    height: ag.Scalar,
    *,
    rubber: ag.Material,
    deep: ag.Scalar,
    size: ag.Scalar = 0.014,
    label: str = "gasket",
) -> ag.Body:
    """Make the gasket of a door in the plane of x and z about the origin, from its foot at y = 0 to +y.

    It fills the gap of a closed door up to a clearance: 0.3-0.5 mm is invisible and prevents contact between
    door and cabinet. A gasket without clearance needs `allow_contact` of the caller.
    """
    bodies = [ag.part(bar, label, rubber) for bar in _ring(width, height, deep, size, 0.45 * deep)]
    # a flat ring is the root of the gasket in the door's groove
    inner = ag.rectangle(width - 2 * size - 0.006, height - 2 * size - 0.006)
    root = ag.rectangle(width + 0.006, height + 0.006, radius=0.006) - inner
    return ag.weld(*bodies, ag.detail(ag.extrude(root, 0.004, axis=ag.Y), label, rubber))


def _ring(
    width: ag.Scalar, height: ag.Scalar, deep: ag.Scalar, size: ag.Scalar, bevel: ag.Scalar
) -> list[ag.Solid]:
    less = 0.0002  # uprights end inside the horizontal bars, just below their faces
    level = ag.box(width, deep, size, bevel=bevel)
    upright = ag.box(size - less, deep - less, height - size, bevel=bevel)
    return [
        *(level.at(0.0, deep / 2, way * (height - size) / 2) for way in (-1, 1)),
        *(upright.at(way * (width - size) / 2, deep / 2 - less / 2, 0.0) for way in (-1, 1)),
    ]


PIN = 0.020
"""Distance of the axis of a hinge from the outer edge and the front of its door [m]."""

SEAL_INSET = 0.026
"""Distance from the hinge edge to the gasket: beyond the axis, so that it leaves the cabinet at once [m]."""

CHEEK = 0.040
"""Distance from the side of a cell to a drawer: the width of the rails there [m]."""

LINING_INSET = 0.004
"""Difference in width between lining and skin at the hinge edge [m]."""

_RIDGE_INSET = 0.055  # distance from the wall of the cell to the ridge near the hinges [m]
_SWINGS_PAST = 0.005  # clearance between the free ridge and the parts that it passes [m]
_CLEARS = 0.004  # clearance between an open door and a drawer [m]


@dataclass(frozen=True)
class Leaf:
    """A door with hinges at its left; a door hinged at the right is the mirror image."""

    label: str  # semantic label of the door
    name: str  # name of the link
    case: Case  # cabinet
    cell: Cell  # closed cell
    left: ag.Scalar  # position of the hinge edge along x [m]
    right: ag.Scalar  # position of the free edge along x [m]
    low: ag.Scalar  # height of the lower edge [m]
    high: ag.Scalar  # height of the upper edge [m]
    limit: ag.Scalar  # right limit of the parts on its inside: a wall, or another door [m]
    ridge: ag.Scalar | None  # depth of the ridges in the cell [m]; None for a flat inside
    bins: int  # number of bins between the ridges
    # whether the door is hinged at the right: all dimensions are then those of the mirror image
    mirrored: bool = False
    handle: Literal["low", "middle", "high"] = "middle"  # position of the handle
    meets: bool = False  # whether the free edge meets that of another door

    @cached_property
    def width(self) -> ag.Scalar:
        """Width from edge to edge [m]."""
        return self.right - self.left

    @cached_property
    def height(self) -> ag.Scalar:
        """Height from the lower to the upper edge [m]."""
        return self.high - self.low

    @cached_property
    def arm(self) -> ag.Scalar:
        """Distance from the axis to the handle [m]."""
        return self.width - PIN - 0.05

    @cached_property
    def pivot(self) -> ag.Vector:
        """Point on the axis of the hinge, mirrored for a door hinged at the right [m]."""
        side = -1.0 if self.mirrored else 1.0
        return ag.vector(side * (self.left + PIN), self.case.front + PIN, (self.low + self.high) / 2)

    @cached_property
    def joint(self) -> str:
        """Name of the hinge."""
        head, split, side = self.name.partition("_left")
        if not split:
            head, split, side = self.name.partition("_right")
        return f"{head}_hinge{split}{side}"

    @cached_property
    def reach(self) -> ag.Scalar:
        """Distance from the axis to the tips of the ridges, front to back [m]."""
        return self.case.thickness - PIN + (0.0 if self.ridge is None else self.ridge)

    @cached_property
    def ridges(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Outer sides of the ridges along x [m].

        The free ridge has the largest distance from the axis at which its tip passes the limit.
        """
        axis = self.left + PIN
        room = self.limit - axis - _SWINGS_PAST
        return self.cell.left + _RIDGE_INSET, axis + ag.sqrt(
            ag.max_(room * room - self.reach * self.reach, 0.0)
        )

    def clears(self, x: ag.Scalar) -> ag.Float:
        """Return the smallest angle at which the open door stays to the left of `x` [rad].

        A point at (u, v) from the axis, to the right and to the back, moves to x = u cos q + v sin q. This
        decreases from q = atan2(v, u), and reaches c after a further turn of acos(c / r).
        """
        axis = self.left + PIN
        room = x - axis - _CLEARS
        back = self.case.thickness - PIN
        points: list[tuple[ag.Scalar, ag.Scalar]] = [
            (LINING_INSET - PIN, back),
            (SEAL_INSET - PIN, back + SEAL_GAP),
        ]
        if self.ridge is not None:
            points.append((self.ridges[0] - axis, self.reach))
        angles = []
        for u, v in points:
            rest = ag.sqrt(ag.max_(u * u + v * v - room * room, 0.0))
            angles.append(ag.atan2(v, u) + ag.atan2(rest, room))
        return ag.max_(ag.max_(angles[0], angles[1]), angles[-1])

    def hinge(self, *, limit: ag.Scalar, pull: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
        """Make the hinge of the door."""
        return door_swing(
            self.joint,
            pivot=self.pivot,
            way=1 if self.mirrored else -1,
            limit=limit,
            pull=pull,
            arm=self.arm,
            damping=damping,
        )

    def frees(self, left: ag.Scalar, right: ag.Scalar) -> ag.Float:
        """Return the smallest opening angle that clears a drawer between two sides [rad]."""
        return self.clears(-right if self.mirrored else left)
