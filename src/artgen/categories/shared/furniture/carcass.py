"""Carcasses of furniture: boards, partitions, shelves on pins, worktops, legs and plinths.

A carcass is about the z axis with its open front facing -y. Boards that meet have a fine seam between them,
and ends overlap slightly with the faces that they abut.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.shared.furniture.finish import ZINC
from artgen.categories.shared.hardware.fixings import corner_feet

LegStyle = Literal["tapered", "splayed", "square", "turned", "metal"]
"""Round and tapered; tapered and leaning outward; square posts; a bun under a neck; a slim tube."""

Stand = Literal["plinth", "legs", "feet", "brackets"]
"""Support of a carcass: its sides with a board between them, legs, pads, or brackets on a wall."""

BACK = 0.006
"""Thickness of a back panel [m]."""

EASE = 0.0008
"""Radius of the rounded edges of boards [m]."""

_BITE = 0.0003  # overlap of the ends of boards with the faces that they abut [m]
_SEAM = 0.0004  # distance from the end of a board to the edge of its neighbor [m]
_BACK_INSET = 0.010  # distance from the rear of the sides to the back panel [m]
_PITCH = 0.032  # pitch of rows of holes: the 32 mm system [m]


@dataclass(frozen=True)
class Carcass:
    """A box of boards."""

    width: ag.Scalar  # width over the sides [m]
    low: ag.Scalar  # height of the underside of the bottom board above the floor [m]
    high: ag.Scalar  # height of the upper side of the top board above the floor [m]
    front: ag.Scalar  # position of the front edges along y [m]
    rear: ag.Scalar  # position of the rear end along y [m]
    thick: ag.Scalar  # thickness of the boards [m]
    finish: ag.Material  # finish of the boards
    inside: ag.Material  # finish of the back and the shelves
    # height of the lower ends of the sides [m]; by default the bottom board, or the floor with a plinth
    foot: ag.Scalar | None = None
    label: str = "body"  # semantic label of the boards

    @property
    def right(self) -> ag.Scalar:
        """Position of the inner face of the right side along x [m]."""
        return self.width / 2 - self.thick

    @property
    def floor(self) -> ag.Scalar:
        """Height of the upper face of the bottom board [m]."""
        return self.low + self.thick

    @property
    def ceiling(self) -> ag.Scalar:
        """Height of the lower face of the top board [m]."""
        return self.high - self.thick

    @property
    def behind(self) -> ag.Scalar:
        """Position of the front of the back panel along y [m]."""
        return self.rear - _BACK_INSET - BACK

    def bodies(self) -> list[ag.Body]:
        """Make sides, bottom, top and back; the first body starts the link `body`."""
        foot = self.low if self.foot is None else self.foot
        y, inner = (self.front, self.rear), self.right + _BITE
        shy = (self.front + _SEAM, self.rear - _SEAM)
        sides = [
            ag.Region(
                (
                    way * self.width / 2 - (self.thick if way > 0 else 0.0),
                    way * self.width / 2 + (0.0 if way > 0 else self.thick),
                ),
                y,
                (foot, self.high),
            ).box(bevel=EASE)
            for way in (-1, 1)
        ]
        bottom = ag.Region((-inner, inner), shy, (self.low + _SEAM, self.floor)).box(bevel=EASE)
        top = ag.Region((-inner, inner), shy, (self.ceiling, self.high - _SEAM)).box(bevel=EASE)
        groove = 0.004
        back = ag.Region(
            (-inner - groove, inner + groove),
            (self.behind, self.behind + BACK),
            (self.floor - groove, self.ceiling + groove),
        ).box()
        return [
            ag.part(sides[0], self.label, self.finish, name="body"),
            ag.part(sides[1], self.label, self.finish),
            ag.part(bottom, self.label, self.finish),
            ag.part(top, self.label, self.finish),
            ag.part(back, "back", self.inside),
        ]

    def partition(self, x: ag.Scalar, *, low: ag.Scalar | None = None) -> ag.Body:
        """Make a vertical board up to the top."""
        solid = ag.Region(
            (x - self.thick / 2, x + self.thick / 2),
            (self.front + _SEAM, self.behind + _BITE),
            ((self.floor if low is None else low) - _BITE, self.ceiling + _BITE),
        ).box(bevel=EASE)
        return ag.part(solid, self.label, self.finish)

    def deck(self, z: ag.Scalar) -> ag.Body:
        """Make a board across the full width, over an open compartment."""
        inner = self.right + _BITE
        solid = ag.Region(
            (-inner, inner), (self.front + _SEAM, self.behind + _BITE), (z - self.thick, z)
        ).box(bevel=EASE)
        return ag.part(solid, self.label, self.finish)

    def rail(
        self,
        left: ag.Scalar,
        right: ag.Scalar,
        z: ag.Scalar,
        *,
        high: ag.Scalar,
        deep: ag.Scalar = 0.06,
        solid: bool = True,
    ) -> ag.Body:
        """Make a rail between two uprights, behind the front edges."""
        made = ag.Region(
            (left - _BITE, right + _BITE),
            (self.front + _SEAM, self.front + deep),
            (z - high / 2, z + high / 2),
        ).box(bevel=EASE)
        make = ag.part if solid else ag.detail
        return make(made, self.label, self.finish)

    def shelves(
        self, levels: Sequence[ag.Scalar], *, thick: ag.Scalar, setback: ag.Scalar, finish: ag.Material
    ) -> list[ag.Body]:
        """Make shelves on pins, and the rows of holes for the pins."""
        if not levels:
            return []
        near, far = self.front + setback, self.behind - 0.002
        plank = ag.Region((-self.right + _SEAM, self.right - _SEAM), (near, far), (0.0, thick)).box(
            bevel=EASE
        )
        lines = (near + 0.035, far - 0.045)
        pins = [
            ag.cylinder_between(
                (way * (self.right + 0.002), y, -0.0026), (way * (self.right - 0.009), y, -0.0026), 0.0026
            )
            for way in (-1, 1)
            for y in lines
        ]
        at: list[ag.VectorLike] = [(0.0, 0.0, level) for level in levels]
        hole = ag.cylinder(0.0025, 0.0006, axis=(1.0, 0.0, 0.0))
        rows: list[ag.VectorLike] = [
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
            ag.part(ag.array(plank, at=at), "shelf", finish, separate="each shelf lies on its pins"),
            ag.detail(ag.array(ag.union(*pins), at=at), "pin", ZINC),
            ag.detail(ag.array(hole, at=rows), "pin", dark),
        ]

    def standing(
        self, stand: Stand, *, setback: ag.Scalar, leg: LegStyle, finish: ag.Material
    ) -> list[ag.Body]:
        """Make the stand: plinth, legs or feet."""
        match stand:
            case "plinth":
                return self.plinth(setback, self.finish)
            case "legs":
                return self.legs(leg, finish)
            case "feet":
                low = ag.require(self.low, self.low > 0.004, "stand_height of feet must be > 0.004 m")
                return [corner_feet(self.width, self.rear - self.front, inset=0.03, radius=0.014, height=low)]
            case _:
                x, y, z = self.right, self.behind, self.ceiling
                bracket = ag.Region(
                    (x - 0.016, x + _BITE), (y - 0.052, y + _BITE), (z - 0.058, z - 0.008)
                ).box(bevel=0.002)
                both = (bracket, bracket.mirror((1.0, 0.0, 0.0)))
                return [ag.part(each, "bracket", ag.material("abs")) for each in both]

    def plinth(self, setback: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
        """Make the board between the sides under the bottom board, and a stretcher at the back."""
        low = ag.require(self.low, self.low > 0.02, "stand_height of a plinth must be > 0.02 m")
        x = (-self.right - _BITE, self.right + _BITE)
        z = (_SEAM, low + 0.002)
        near = ag.Region(x, (self.front + setback, self.front + setback + 0.016), z).box(bevel=EASE)
        far = ag.Region(x, (self.rear - 0.032, self.rear - 0.016), (0.02, low + 0.002)).box(bevel=EASE)
        return [ag.part(near, "plinth", finish), ag.part(far, "plinth", finish)]

    def legs(self, style: LegStyle, finish: ag.Material, *, inset: ag.Scalar = 0.045) -> list[ag.Body]:
        """Make four legs under the corners of the bottom board."""
        low = ag.require(self.low, self.low > 0.05, "stand_height of legs must be > 0.05 m")
        core, skin = _leg(style, low + 0.0008)
        x, y = self.width / 2 - inset, (self.front + inset, self.rear - inset)
        corners = ((-1, 0), (1, 0), (-1, 1), (1, 1))

        def everywhere(solid: ag.Solid) -> list[ag.Solid]:
            made = []
            for way, end in corners:
                turned = solid.mirror((1.0, 0.0, 0.0)) if way > 0 else solid
                made.append((turned.mirror((0.0, 1.0, 0.0)) if end else turned).at(way * x, y[end], 0.0))
            return made

        return [
            *(ag.part(each, "leg", finish) for solid in core for each in everywhere(solid)),
            *(ag.detail(each, "leg", finish) for solid in skin for each in everywhere(solid)),
        ]

    def worktop(
        self,
        thick: ag.Scalar,
        finish: ag.Material,
        *,
        before: ag.Scalar,
        beside: ag.Scalar,
        bevel: ag.Scalar = 0.002,
    ) -> ag.Body:
        """Make the top on the carcass."""
        out = self.width / 2 + beside
        slab = ag.Region(
            (-out, out), (self.front - before, self.rear), (self.high - 0.0002, self.high + thick)
        ).box(bevel=bevel)
        return ag.part(slab, "top", finish)


def _leg(style: LegStyle, tall: ag.Scalar) -> tuple[list[ag.Solid], list[ag.Solid]]:
    """Make the left front leg with its upper end at the origin, and its parts without colliders."""
    plate = [ag.box(0.07, 0.07, 0.0024, bevel=0.0006).at(0.0, 0.0, tall - 0.002)]
    match style:
        case "square":
            return [ag.box(0.044, 0.044, tall, bevel=0.0015).at(0.0, 0.0, tall / 2)], []
        case "metal":
            tube = ag.box(0.022, 0.022, tall - 0.004, bevel=0.0015).at(0.0, 0.0, 0.004 + (tall - 0.004) / 2)
            return [tube, ag.cylinder(0.012, 0.0045, bevel=0.0008).at(0.0, 0.0, 0.00225)], plate
        case "turned":
            post = ag.cylinder(0.021, tall).at(0.0, 0.0, tall / 2)
            bun = ag.cylinder(0.032, tall - 0.030, bevel=0.013).at(0.0, 0.0, (tall - 0.030) / 2 + 0.001)
            bead = ag.cylinder(0.027, 0.010, bevel=0.004).at(0.0, 0.0, tall - 0.017)
            return [post], [bun, bead]
        case "splayed":
            lean = 0.18 * tall
            sole = ag.cylinder(0.011, 0.002, bevel=0.0008).at(-lean, -0.6 * lean, 0.001)
            head = ag.cylinder(0.019, 0.002).at(0.0, 0.0, tall - 0.001)
            return [ag.hull(sole, head)], plate
        case _:
            return [ag.frustum(0.013, 0.021, tall, bevel=0.001).at(0.0, 0.0, tall / 2)], plate
