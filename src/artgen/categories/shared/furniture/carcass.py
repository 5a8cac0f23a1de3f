"""Carcasses of furniture: boards, partitions, shelves on pins, worktops, and what they stand on.

A carcass stands about the z axis with its open front facing -y. Boards that meet keep a hair of a seam, and
ends reach a hair into the faces that they abut.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from artgen import (
    Body,
    Material,
    Scalar,
    Solid,
    VectorLike,
    array,
    board,
    box,
    cylinder,
    cylinder_between,
    detail,
    frustum,
    hull,
    material,
    part,
    require,
    union,
)
from artgen.categories.shared.furniture.finish import ZINC
from artgen.categories.shared.hardware.fixings import corner_feet

LegStyle = Literal["tapered", "splayed", "square", "turned", "metal"]
"""Round and slimmer below; the same, leaning outward; square posts; a bun under a neck; a slim tube."""

Stand = Literal["plinth", "legs", "feet", "brackets"]
"""What carries a carcass: its sides with a board between them, legs, pads, or brackets on a wall."""

BACK = 0.006
"""Thickness of a back panel [m]."""

EASE = 0.0008
"""Edges of boards are eased to this radius [m]."""

_BITE = 0.0003  # how far ends of boards reach into the faces that they abut [m]
_SEAM = 0.0004  # by how much a board ends short of the edge of its neighbor [m]
_BACK_INSET = 0.010  # from the rear of the sides to the back panel [m]
_PITCH = 0.032  # of rows of holes: the 32 mm system [m]


@dataclass(frozen=True)
class Carcass:
    """A box of boards."""

    width: Scalar  # over its sides [m]
    low: Scalar  # underside of its bottom board above the floor [m]
    high: Scalar  # upper side of its top board [m]
    front: Scalar  # where its front edges are along y [m]
    rear: Scalar  # where it ends along y [m]
    thick: Scalar  # thickness of its boards [m]
    finish: Material  # of its boards
    inside: Material  # of its back and shelves
    # where its sides end below [m]; at its bottom board by default, on the floor with a plinth
    foot: Scalar | None = None
    label: str = "body"  # semantic label of its boards

    @property
    def right(self) -> Scalar:
        """The inner face of its right side along x [m]."""
        return self.width / 2 - self.thick

    @property
    def floor(self) -> Scalar:
        """The upper face of its bottom board [m]."""
        return self.low + self.thick

    @property
    def ceiling(self) -> Scalar:
        """The lower face of its top board [m]."""
        return self.high - self.thick

    @property
    def behind(self) -> Scalar:
        """The front of its back panel along y [m]."""
        return self.rear - _BACK_INSET - BACK

    def bodies(self) -> list[Body]:
        """Make sides, bottom, top and back; the first one begins the link `body`."""
        foot = self.low if self.foot is None else self.foot
        y, inner = (self.front, self.rear), self.right + _BITE
        shy = (self.front + _SEAM, self.rear - _SEAM)
        sides = [
            board(
                (
                    way * self.width / 2 - (self.thick if way > 0 else 0.0),
                    way * self.width / 2 + (0.0 if way > 0 else self.thick),
                ),
                y,
                (foot, self.high),
                bevel=EASE,
            )
            for way in (-1, 1)
        ]
        bottom = board((-inner, inner), shy, (self.low + _SEAM, self.floor), bevel=EASE)
        top = board((-inner, inner), shy, (self.ceiling, self.high - _SEAM), bevel=EASE)
        groove = 0.004
        back = board(
            (-inner - groove, inner + groove),
            (self.behind, self.behind + BACK),
            (self.floor - groove, self.ceiling + groove),
        )
        return [
            part(sides[0], self.label, self.finish, name="body"),
            part(sides[1], self.label, self.finish),
            part(bottom, self.label, self.finish),
            part(top, self.label, self.finish),
            part(back, "back", self.inside),
        ]

    def partition(self, x: Scalar, *, low: Scalar | None = None) -> Body:
        """Make an upright board up to the top."""
        solid = board(
            (x - self.thick / 2, x + self.thick / 2),
            (self.front + _SEAM, self.behind + _BITE),
            ((self.floor if low is None else low) - _BITE, self.ceiling + _BITE),
            bevel=EASE,
        )
        return part(solid, self.label, self.finish)

    def deck(self, z: Scalar) -> Body:
        """Make a board all across, over an open compartment."""
        inner = self.right + _BITE
        solid = board(
            (-inner, inner), (self.front + _SEAM, self.behind + _BITE), (z - self.thick, z), bevel=EASE
        )
        return part(solid, self.label, self.finish)

    def rail(
        self,
        left: Scalar,
        right: Scalar,
        z: Scalar,
        *,
        high: Scalar,
        deep: Scalar = 0.06,
        solid: bool = True,
    ) -> Body:
        """Make a rail between two uprights, behind the front edges."""
        made = board(
            (left - _BITE, right + _BITE),
            (self.front + _SEAM, self.front + deep),
            (z - high / 2, z + high / 2),
            bevel=EASE,
        )
        make = part if solid else detail
        return make(made, self.label, self.finish)

    def shelves(
        self, levels: Sequence[Scalar], *, thick: Scalar, setback: Scalar, finish: Material
    ) -> list[Body]:
        """Make shelves on pins, and the rows of holes that they can be put in."""
        if not levels:
            return []
        near, far = self.front + setback, self.behind - 0.002
        plank = board((-self.right + _SEAM, self.right - _SEAM), (near, far), (0.0, thick), bevel=EASE)
        lines = (near + 0.035, far - 0.045)
        pins = [
            cylinder_between(
                (way * (self.right + 0.002), y, -0.0026), (way * (self.right - 0.009), y, -0.0026), 0.0026
            )
            for way in (-1, 1)
            for y in lines
        ]
        at: list[VectorLike] = [(0.0, 0.0, level) for level in levels]
        hole = cylinder(0.0025, 0.0006, axis=(1.0, 0.0, 0.0))
        rows: list[VectorLike] = [
            (way * (self.right - 0.0001), y, level + step * _PITCH - 0.0026)
            for level in levels
            for step in (-2, -1, 1, 2)
            for way in (-1, 1)
            for y in lines
        ]
        dark = self.finish.with_(
            name="pin_hole",
            base_color=(0.03, 0.028, 0.025),
            texture="",
            coat_weight=0.0,
            specular_roughness=0.8,
        )
        return [
            part(array(plank, at=at), "shelf", finish, separate="each shelf lies on its pins"),
            detail(array(union(*pins), at=at), "pin", ZINC),
            detail(array(hole, at=rows), "pin", dark),
        ]

    def standing(self, stand: Stand, *, setback: Scalar, leg: LegStyle, finish: Material) -> list[Body]:
        """Make what carries it."""
        match stand:
            case "plinth":
                return self.plinth(setback, self.finish)
            case "legs":
                return self.legs(leg, finish)
            case "feet":
                low = require(self.low, self.low > 0.004, "feet are higher: stand_height over 0.004 m")
                return [corner_feet(self.width, self.rear - self.front, inset=0.03, radius=0.014, height=low)]
            case _:
                x, y, z = self.right, self.behind, self.ceiling
                bracket = board(
                    (x - 0.016, x + _BITE), (y - 0.052, y + _BITE), (z - 0.058, z - 0.008), bevel=0.002
                )
                both = (bracket, bracket.mirror((1.0, 0.0, 0.0)))
                return [part(each, "bracket", material("abs")) for each in both]

    def plinth(self, setback: Scalar, finish: Material) -> list[Body]:
        """Make the board between the sides under the bottom board, and a stretcher at the back."""
        low = require(
            self.low, self.low > 0.02, "a plinth is higher than its boards: stand_height over 0.02 m"
        )
        x = (-self.right - _BITE, self.right + _BITE)
        z = (_SEAM, low + 0.002)
        near = board(x, (self.front + setback, self.front + setback + 0.016), z, bevel=EASE)
        far = board(x, (self.rear - 0.032, self.rear - 0.016), (0.02, low + 0.002), bevel=EASE)
        return [part(near, "plinth", finish), part(far, "plinth", finish)]

    def legs(self, style: LegStyle, finish: Material, *, inset: Scalar = 0.045) -> list[Body]:
        """Make four legs under the corners of the bottom board."""
        low = require(self.low, self.low > 0.05, "legs are higher: stand_height over 0.05 m")
        core, skin = _leg(style, low + 0.0008)
        x, y = self.width / 2 - inset, (self.front + inset, self.rear - inset)
        corners = ((-1, 0), (1, 0), (-1, 1), (1, 1))

        def everywhere(solid: Solid) -> list[Solid]:
            made = []
            for way, end in corners:
                turned = solid.mirror((1.0, 0.0, 0.0)) if way > 0 else solid
                made.append((turned.mirror((0.0, 1.0, 0.0)) if end else turned).at(way * x, y[end], 0.0))
            return made

        return [
            *(part(each, "leg", finish) for solid in core for each in everywhere(solid)),
            *(detail(each, "leg", finish) for solid in skin for each in everywhere(solid)),
        ]

    def worktop(
        self, thick: Scalar, finish: Material, *, before: Scalar, beside: Scalar, bevel: Scalar = 0.002
    ) -> Body:
        """Make the top on the carcass."""
        out = self.width / 2 + beside
        slab = board(
            (-out, out),
            (self.front - before, self.rear),
            (self.high - 0.0002, self.high + thick),
            bevel=bevel,
        )
        return part(slab, "top", finish)


def _leg(style: LegStyle, tall: Scalar) -> tuple[list[Solid], list[Solid]]:
    """Make the leg at the left of the front, its upper end at the origin, and what only is seen of it."""
    plate = [box(0.07, 0.07, 0.0024, bevel=0.0006).at(0.0, 0.0, tall - 0.002)]
    match style:
        case "square":
            return [box(0.044, 0.044, tall, bevel=0.0015).at(0.0, 0.0, tall / 2)], []
        case "metal":
            tube = box(0.022, 0.022, tall - 0.004, bevel=0.0015).at(0.0, 0.0, 0.004 + (tall - 0.004) / 2)
            return [tube, cylinder(0.012, 0.0045, bevel=0.0008).at(0.0, 0.0, 0.00225)], plate
        case "turned":
            post = cylinder(0.021, tall).at(0.0, 0.0, tall / 2)
            bun = cylinder(0.032, tall - 0.030, bevel=0.013).at(0.0, 0.0, (tall - 0.030) / 2 + 0.001)
            bead = cylinder(0.027, 0.010, bevel=0.004).at(0.0, 0.0, tall - 0.017)
            return [post], [bun, bead]
        case "splayed":
            lean = 0.18 * tall
            sole = cylinder(0.011, 0.002, bevel=0.0008).at(-lean, -0.6 * lean, 0.001)
            head = cylinder(0.019, 0.002).at(0.0, 0.0, tall - 0.001)
            return [hull(sole, head)], plate
        case _:
            return [frustum(0.013, 0.021, tall, bevel=0.001).at(0.0, 0.0, tall / 2)], plate
