"""Furniture: its materials, and carcasses with boards, shelves on pins, worktops, legs and plinths.

A category first draws a look; the finish of fronts and carcass depends on it:

    look: BoardLook = choice("wood", "lacquer", "melamine", "decor", weights=(...))
    finish: Material = boards()

A carcass is about the z axis with its open front facing -y. Boards that meet have a fine seam between them,
and ends overlap slightly with the faces that they abut.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import artgen as ag
from artgen.categories.shared.finish import casting, known, weighing
from artgen.categories.shared.fixings import corner_feet
from artgen.categories.shared.vessels import around

BoardLook = Literal["wood", "lacquer", "melamine", "decor"]
"""Veneered or solid wood; sprayed MDF; board with a plain foil, or with a printed wood grain."""

CaseLook = Literal["wood", "lacquer", "melamine", "decor", "steel"]
"""The same looks, or folded sheet steel."""

_WOODS: dict[str, float] = {
    "oak": 2.0, "oak_flat_sawn": 1.2, "walnut": 1.4, "walnut_flat_sawn": 0.8, "beech": 0.9,
    "maple": 0.6, "ash": 0.8, "pine_flat_sawn": 0.9, "mahogany": 0.7,
}  # fmt: skip
# density of wood between pine and oak, glued up or on board [kg/m3]
WOODS = weighing(known(*_WOODS), 650.0, "furniture")
"""Woods of furniture."""

_LACQUERS: dict[str, float] = {
    "white": 2.2, "ivory": 1.0, "sage": 1.2, "navy": 1.0, "graphite": 1.0, "taupe": 0.6, "forest": 0.7,
    "light_grey": 0.9, "sky": 0.5, "blush": 0.5, "black": 0.6, "mustard": 0.3, "burgundy": 0.3,
}  # fmt: skip
LACQUERS = tuple(ag.colored("lacquered_mdf", color) for color in _LACQUERS)
"""Sprayed MDF, 750 kg/m3."""

# foil on chipboard
_FOIL: dict[str, Any] = {"specular_roughness": 0.42, "coat_weight": 0.0, "density": 660.0}
_MELAMINES: dict[str, float] = {"cool_white": 2.4, "light_grey": 1.0, "sand": 0.7, "graphite": 0.8}
MELAMINES = tuple(
    ag.colored("lacquered_mdf", color).with_(name=f"melamine_{color}", **_FOIL) for color in _MELAMINES
)
"""Chipboard with a foil of one color."""

_DECORS: dict[str, float] = {"oak": 1.4, "walnut": 0.8, "ash": 1.0, "beech": 0.6}
DECORS = tuple(
    ag.material(name).with_(name=f"decor_{name}", **_FOIL | {"specular_roughness": 0.5}) for name in _DECORS
)
"""Chipboard with a foil with a printed wood grain."""

_STEELS: dict[str, float] = {
    "light_grey": 2.0, "white": 1.4, "graphite": 1.2, "black": 1.2, "sand": 0.8,
    "sage": 0.5, "red": 0.4, "mustard": 0.3, "navy": 0.4,
}  # fmt: skip
# walls are two sheets of 0.8 mm with air between them: 1.6 of some 14 mm are steel, and less in single walls
STEELS = weighing([ag.colored("powder_coat", color) for color in _STEELS], 620.0, "sheet")
"""Folded sheet steel, painted."""

WHITE_BOARD = ag.colored("lacquered_mdf", "cool_white").with_(name="melamine_inside", **_FOIL)
"""White melamine for the insides of kitchen cabinets."""

PLY = ag.material("plywood").with_(name="birch_ply", base_color=(0.70, 0.55, 0.37))
"""Birch plywood: backs, and the bottoms and sides of drawers."""

HARDBOARD = ag.colored("lacquered_mdf", "cool_white").with_(name="hardboard_white", density=850.0)
"""Hardboard with a white face: thin backs and bottoms."""

ZINC = ag.material("zinc").with_(name="zinc_plated", base_color=(0.66, 0.67, 0.69), density=7850.0)
"""Zinc-plated steel of runners, hinges and pins."""

GREY_STEEL = ag.colored("powder_coat", "light_grey").with_(name="grey_steel_walls", density=700.0)
"""Hollow sides of drawers of folded sheet steel."""

CREAM_STEEL = ag.colored("powder_coat", "ivory").with_(name="cream_steel")
"""Epoxy-coated steel of roller runners."""

CLEAR_RUBBER = ag.material("polycarbonate").with_(name="clear_rubber", density=1150.0, friction=0.9)
"""Bumpers behind doors."""

_STONES = {"granite": 1.0, "black_granite": 1.0, "marble": 0.8}
_TOPS = (
    *weighing(known("oak", "beech", "walnut"), 680.0, "butcher_block"),
    *(
        ag.colored("lacquered_mdf", color).with_(name=f"laminate_{color}", **_FOIL)
        for color in ("graphite", "white", "sand")
    ),
    *known(*_STONES),
)
_TOP_WEIGHTS = (1.6, 1.2, 0.7, 0.9, 0.8, 0.4, *_STONES.values())

HARDWARE: dict[str, float] = {
    "satin_nickel": 1.8, "stainless": 1.4, "chrome": 0.9, "satin_brass": 1.6,
    "brass": 0.6, "aged_bronze": 0.8, "powder_coat_black": 1.6, "black_steel": 0.5,
}  # fmt: skip
"""Metals of furniture handles, with their weights in a random choice."""


_STOCK: dict[CaseLook, tuple[Sequence[ag.Material], dict[str, float]]] = {
    "wood": (WOODS, _WOODS),
    "lacquer": (LACQUERS, _LACQUERS),
    "melamine": (MELAMINES, _MELAMINES),
    "decor": (DECORS, _DECORS),
    "steel": (STEELS, _STEELS),
}


def _draw(look: CaseLook, count: int | None = None) -> Any:
    """Draw one of the first materials of a look."""
    stock, weights = _STOCK[look]
    shares = tuple(weights.values())[:count]
    return ag.shades(*stock[:count], weights=shares, color=0.05, roughness=0.04)


def boards(*looks: CaseLook) -> Any:
    """Draw the material of fronts and carcass by the parameter `look`."""
    return ag.by("look", {look: _draw(look) for look in looks}, doc="finish of fronts and carcass")


def accents() -> Any:
    """Draw the material of fronts with another finish than the carcass, by the parameter `fronts`."""
    doc = "finish of fronts that differ from the carcass"
    return ag.by("fronts", wood=_draw("wood", 5), otherwise=_draw("lacquer"), doc=doc)


def worktops() -> Any:
    """Draw the material of a worktop: glued wood, laminate or stone."""
    return ag.shades(*_TOPS, weights=_TOP_WEIGHTS, color=0.05, roughness=0.03, doc="material of the worktop")


def hardware() -> Any:
    """Draw the metal of handles."""
    weights = tuple(HARDWARE.values())
    return ag.shades(*HARDWARE, weights=weights, color=0.03, roughness=0.03, doc="metal of handles")


def leg_finishes() -> Any:
    """Draw the material of legs by the parameter `leg`: wood, or the metal of a tube."""
    metals, black = ("powder_coat_black", "satin_brass", "stainless"), ag.colored("painted_wood", "black")
    metal = ag.shades(*metals, weights=(3.0, 1.0, 1.0), color=0.03)
    wood = ag.shades(*WOODS[:4], black, weights=(2.0, 1.0, 2.0, 1.0, 1.0), color=0.05)
    return ag.by("leg", metal=metal, otherwise=wood, doc="material of legs")


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
_RAIL = 0.030  # width of the rails of a unit under a sink [m]
_BACK_INSET = 0.010  # distance from the rear of the sides to the back panel [m]
_PITCH = 0.032  # pitch of rows of holes: the 32 mm system [m]
_TUBE = 0.25  # share of steel in a square tube of 22 mm with walls of 1.5 mm
_SIDES = 16  # sides of the collider of a round leg: MJX reads faces of at most 20 corners


def open_box(room: ag.Region, inner: ag.Region) -> list[ag.Solid]:
    """Make the sides, the back and the floor of a drawer between two regions; its front is another part."""
    wide = (inner.x.low - 0.0002, inner.x.high + 0.0002)
    walls = (
        room.with_(x=(room.x.low, inner.x.low)),
        room.with_(x=(inner.x.high, room.x.high)),
        room.with_(x=wide, y=(inner.y.high, room.y.high)),
        room.with_(x=wide, z=(room.z.low, inner.z.low)),
    )
    return [wall.box() for wall in walls]


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

    @property
    def _shy(self) -> ag.Span:
        """Extent along y of boards that end at the back panel [m]."""
        return (self.front + _SEAM, self.behind + _BITE)

    def bodies(self, *, for_sink: bool = False) -> list[ag.Body]:
        """Make sides, bottom, top and back; the first body starts the link `body`.

        For a sink there are two rails instead of the top, and no back.
        """
        foot, inner = self.low if self.foot is None else self.foot, self.right + _BITE
        x, shy = (-inner, inner), (self.front + _SEAM, self.rear - _SEAM)
        half, y = self.width / 2, (self.front, self.rear)
        right = ag.Region((half - self.thick, half), y, (foot, self.high))
        bottom = ag.Region(x, shy, (self.low + _SEAM, self.floor)).box(bevel=EASE)
        top = ag.Region(x, shy, (self.ceiling, self.high - _SEAM))
        sides = [each.box(bevel=EASE) for each in (right.mirror(), right)]
        if for_sink:
            rails = [each.box(bevel=EASE) for each in top.deep(_RAIL, None, _RAIL)[::2]]
            return [ag.part([*sides, bottom, *rails], self.label, self.finish, name="body")]
        groove = ag.Region(x, (self.behind, self.behind + BACK), (self.floor, self.ceiling)).grow(0.004, y=0)
        return [
            ag.part([*sides, bottom, top.box(bevel=EASE)], self.label, self.finish, name="body"),
            ag.part(groove.box(), "back", self.inside),
        ]

    def partition(self, x: ag.Scalar, *, low: ag.Scalar | None = None) -> ag.Body:
        """Make a vertical board up to the top."""
        z = ((self.floor if low is None else low) - _BITE, self.ceiling + _BITE)
        solid = ag.Region((x - self.thick / 2, x + self.thick / 2), self._shy, z).box(bevel=EASE)
        return ag.part(solid, self.label, self.finish)

    def deck(self, z: ag.Scalar) -> ag.Body:
        """Make a board across the full width, over an open compartment."""
        inner = self.right + _BITE
        solid = ag.Region((-inner, inner), self._shy, (z - self.thick, z)).box(bevel=EASE)
        return ag.part(solid, self.label, self.finish)

    def rail(
        self, left: ag.Scalar, right: ag.Scalar, z: ag.Scalar, *, high: ag.Scalar, solid: bool = True
    ) -> ag.Body:
        """Make a rail between two uprights, behind the front edges."""
        y = (self.front + _SEAM, self.front + 0.06)
        made = ag.Region((left - _BITE, right + _BITE), y, (z - high / 2, z + high / 2)).box(bevel=EASE)
        return (ag.part if solid else ag.detail)(made, self.label, self.finish)

    def shelves(
        self, levels: Sequence[ag.Scalar], *, thick: ag.Scalar, setback: ag.Scalar, finish: ag.Material
    ) -> list[ag.Body]:
        """Make shelves on pins, and the rows of holes for the pins."""
        if not levels:
            return []
        inner, near, far = self.right, self.front + setback, self.behind - 0.002
        plank = ag.Region((_SEAM - inner, inner - _SEAM), (near, far), (0.0, thick)).box(bevel=EASE)
        lines = [(way, y) for y in (near + 0.035, far - 0.045) for way in (-1, 1)]
        pins = [
            ag.cylinder_between(
                (way * (inner + 0.002), y, -0.0026), (way * (inner - 0.009), y, -0.0026), 0.0026
            )
            for way, y in lines
        ]
        rows = [
            (way * (inner - 0.0001), y, level + step * _PITCH - 0.0026)
            for level in levels
            for step in (-2, -1, 1, 2)
            for way, y in lines
        ]
        at, hole = [(0.0, 0.0, level) for level in levels], ag.cylinder(0.0025, 0.0006, axis=ag.X)
        dark = {
            "base_color": (0.03, 0.028, 0.025),
            "texture": "",
            "coat_weight": 0.0,
            "specular_roughness": 0.8,
        }
        return [
            ag.part(ag.array(plank, at=at), "shelf", finish, separate="each shelf lies on its pins"),
            ag.detail(ag.array(ag.union(*pins), at=at), "pin", ZINC),
            ag.detail(ag.array(hole, at=rows), "pin", self.finish.with_(name="pin_hole", **dark)),
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
                one = ag.Region((x - 0.016, x + _BITE), (y - 0.052, y + _BITE), (z - 0.058, z - 0.008))
                both = [each.box(bevel=0.002) for each in (one, one.mirror())]
                return [ag.part(both, "bracket", ag.material("abs"))]

    def plinth(self, setback: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
        """Make the board between the sides under the bottom board, and a stretcher at the back."""
        low = ag.require(self.low, self.low > 0.02, "stand_height of a plinth must be > 0.02 m")
        x = (-self.right - _BITE, self.right + _BITE)
        z = (_SEAM, low + 0.002)
        near = ag.Region(x, (self.front + setback, self.front + setback + 0.016), z).box(bevel=EASE)
        far = ag.Region(x, (self.rear - 0.032, self.rear - 0.016), (0.02, low + 0.002)).box(bevel=EASE)
        return [ag.part([near, far], "plinth", finish)]

    def legs(self, style: LegStyle, finish: ag.Material) -> list[ag.Body]:
        """Make four legs under the corners of the bottom board."""
        low = ag.require(self.low, self.low > 0.05, "stand_height of legs must be > 0.05 m")
        core, skin = _leg(style, low + 0.0008)
        finish = casting(finish, _TUBE) if style == "metal" else finish
        x, y = self.width / 2 - 0.045, (self.front + 0.045, self.rear - 0.045)

        def everywhere(solids: list[ag.Solid]) -> list[ag.Solid]:
            made = []
            for way, end in ((-1, 0), (1, 0), (-1, 1), (1, 1)):
                for solid in solids:
                    turned = solid.mirror(ag.X) if way > 0 else solid
                    made.append((turned.mirror(ag.Y) if end else turned).at(way * x, y[end], 0.0))
            return made

        solid = ag.part(everywhere(core), "leg", finish)
        return [solid, ag.detail(everywhere(skin), "leg", finish)] if skin else [solid]

    def worktop(
        self, thick: ag.Scalar, finish: ag.Material, *, before: ag.Scalar, beside: ag.Scalar
    ) -> ag.Body:
        """Make the top on the carcass."""
        out = self.width / 2 + beside
        y, z = (self.front - before, self.rear), (self.high - 0.0002, self.high + thick)
        return ag.part(ag.Region((-out, out), y, z).box(bevel=0.002), "top", finish)


def _leg(style: LegStyle, tall: ag.Scalar) -> tuple[list[ag.Solid], list[ag.Solid]]:
    """Make the left front leg on the origin, up to a height, and its parts without colliders."""
    plate = [ag.box(0.07, 0.07, 0.0024, bevel=0.0006).at(z=tall - 0.002)]
    match style:
        case "square":
            return [ag.box(0.044, 0.044, tall, bevel=0.0015).at(z=tall / 2)], []
        case "metal":
            tube = ag.box(0.022, 0.022, tall - 0.004, bevel=0.0015).at(z=tall / 2 + 0.002)
            return [tube, ag.cylinder(0.012, 0.0045, bevel=0.0008).at(z=0.00225)], plate
        case "turned":
            bun = ag.cylinder(0.032, tall - 0.030, bevel=0.013).at(z=tall / 2 - 0.014)
            bead = ag.cylinder(0.027, 0.010, bevel=0.004).at(z=tall - 0.017)
            return [ag.cylinder(0.021, tall).at(z=tall / 2)], [bun, bead]
        case "splayed":
            lean = ag.min_(0.18 * tall, 0.050)  # tall ones stand out no farther than a top
            foot = (-lean, -0.6 * lean, 0.001)
            sole = ag.cylinder(0.011, 0.002, bevel=0.0008).at(*foot)
            solid = ag.hull(sole, ag.cylinder(0.019, 0.002).at(z=tall - 0.001))
            ends = [ag.extrude(around(radius, _SIDES), 0.002) for radius in (0.011, 0.019)]
            cover = ag.hull(ends[0].at(*foot), ends[1].at(z=tall - 0.001))
        case _:
            solid = ag.frustum(0.013, 0.021, tall, bevel=0.001).at(z=tall / 2)
            cover = ag.loft([around(radius, _SIDES) for radius in (0.013, 0.021)], (0, tall))
    return [ag.bounding_collider(solid, cover)], plate
