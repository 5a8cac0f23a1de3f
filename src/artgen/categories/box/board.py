"""Corrugated board: sheets, creases, and the walls of boxes with hand holes and dividers."""

import math
from dataclasses import dataclass
from typing import Literal, TypeVar

import artgen as ag
from artgen.categories.box.prints import seam

Flute = Literal["b", "c", "eb", "bc", "grey"]
"""B and C flute, the double walls EB and BC, and the solid grayboard of set-up boxes."""

THICK: dict[Flute, float] = {"b": 0.003, "c": 0.004, "eb": 0.005, "bc": 0.0068, "grey": 0.003}
"""Thickness of boards (FEFCO: B 2.5-3.1, C 3.6-4.4, EB 4.1-5.0, BC 6.1-7.0 mm) [m]."""

LAYER = 0.0009
"""Air between two sheets that lie on each other [m]."""

SLIT = 0.0025
"""Gap between the free edges of flaps, and between walls and the flaps that fold between them [m]."""

FOLD = 0.0003
"""Distance of a crease axis outside both outer faces: the liner stretches around the bend [m]."""

_GAP = 0.0002  # gap from a corner to the end of each sheet, along its face [m]
_BEAD = 0.00045  # radius of the bulge of the liner about the axis, less than that of the edges of sheets [m]
_WAVES: dict[Flute, int] = {"b": 1, "c": 1, "eb": 2, "bc": 2, "grey": 1}
_FAR = 2.5  # length greater than any sheet [m]

Thing = TypeVar("Thing", ag.Solid, ag.Body)


@dataclass(frozen=True)
class Feel:
    """Resistance of a crease, per meter of its length."""

    stiffness: ag.Scalar  # stiffness of the spring that pulls to `rest` [N m/rad per m]
    rest: ag.Scalar  # angle to which a flap of a new box springs open [rad]
    friction: ag.Scalar  # friction moment of a bent crease, which holds flaps in place [N m per m]
    damping: ag.Scalar  # damping [N m s/rad per m]


@dataclass(frozen=True)
class Board:
    """Corrugated board of a box."""

    flute: Flute  # kind of flute
    outside: ag.Material  # liner of the outer face
    inside: ag.Material  # liner of the inner face

    @property
    def thick(self) -> float:
        """Thickness of the board [m]."""
        return THICK[self.flute]

    @property
    def edge(self) -> ag.Material:
        """Material of cut edges: liners with the wave between them, or the wrap of grayboard."""
        if self.flute == "grey":
            return self.outside
        tile = (self.thick / _WAVES[self.flute], 0.064)
        return ag.material("cardboard_edge").with_(name=f"{self.flute}_flute_edge", tile=tile)

    def sheet(self, outline: ag.Profile, *, relief: ag.Scalar | None = 0.0) -> ag.Solid:
        """Cut a sheet with its outer face at z = 0."""
        core = ag.extrude(outline, 3.0 * self.thick).at(0.0, 0.0, -self.thick / 2.0).paint(self.edge)
        cut = core & self._slab()
        return cut if relief is None else cut - self._mitre().at(0.0, relief, 0.0)

    def creased(self, solid: ag.Solid, *creases: "Crease") -> ag.Solid:
        """Miter the edges at which creases join a sheet or a wall to others."""
        for crease in creases:
            solid = solid - crease.beside(self._mitre())
        return solid

    def _slab(self) -> ag.Solid:
        """Make a board larger than any sheet; its texture runs along x."""
        upper = ag.Region.between((-_FAR - 0.1, -_FAR, -2.0 * self.thick), (_FAR + 0.1, _FAR, 0.0)).box()
        lower = ag.Region.between((-_FAR - 0.1, -_FAR, -self.thick), (_FAR + 0.1, _FAR, self.thick)).box()
        return upper.paint(self.outside) & lower.paint(self.inside)

    def _mitre(self) -> ag.Solid:
        """Make the cutter that frees the space of a crease in a neighboring sheet."""
        t = self.thick
        wedge = ag.polygon(
            [(_GAP - 2.0 * t, 2.0 * t), (_GAP + 3.0 * t, -3.0 * t), (_GAP - 2.0 * t, -3.0 * t)]
        )
        return ag.extrude(wedge, 2.0 * _FAR, axis=ag.X).paint(self.inside)


@dataclass(frozen=True)
class Mouth:
    """Names of the sides of an opening in the frame of the asset; the default is an opening at the top."""

    front: str = "front"  # name of the side at -y of an opening at the top
    back: str = "back"  # name of the side at +y
    left: str = "left"  # name of the side at -x
    right: str = "right"  # name of the side at +x
    suffix: str = ""  # suffix of all names
    grounded: bool = False  # whether the flap of the side `front` opens down to the floor

    def link(self, kind: str, side: str | None = None) -> str:
        """Return the name of the part of a kind at a side, or of the only part of that kind."""
        return (kind if side is None else f"{kind}_{getattr(self, side)}") + self.suffix

    def hinge(self, kind: str, side: str | None = None) -> str:
        """Return the name of the joint of such a part."""
        return (f"{kind}_hinge" if side is None else f"{kind}_{getattr(self, side)}_hinge") + self.suffix


TOP = Mouth()
"""The opening at the top of an upright box."""


def tongue(half: ag.Scalar, reach: ag.Scalar, *, shoulder: ag.Scalar, tip: ag.Scalar) -> ag.Profile:
    """Make the outline of a flap that narrows from its shoulder to its tip."""
    corners = [(half, 0.0), (half, shoulder), (tip, reach)]
    return ag.polygon([*corners, *((-x, y) for x, y in reversed(corners))])


@dataclass(frozen=True)
class Crease:
    """Position of the crease between a sheet and its neighbor, in the neighbor's frame."""

    x: ag.Scalar  # middle of the crease along x, at the intersection of both outer faces [m]
    y: ag.Scalar  # middle of the crease along y [m]
    z: ag.Scalar = 0.0  # middle of the crease along z [m]
    turn: float = 0.0  # angle about z from the frame's y axis to the direction of the sheet [rad]
    # whether the sheet hangs down at rest, as it is joined to a sheet in the plane of the frame; otherwise it
    # closes a box whose wall is below the crease
    folded: bool = False
    lean: ag.Scalar | None = None  # additional fold angle [rad]

    def place(self, thing: Thing) -> Thing:
        """Move a part from the crease's own frame to its place at rest."""
        moved = thing
        if self.lean is not None:
            moved = moved.rotate(ag.X, -self.lean, about=(0.0, -FOLD, FOLD))
        if self.folded:
            moved = moved.rotate(ag.X, -math.pi / 2.0)
        return moved.rotate(ag.Z, self.turn).at(self.x, self.y, self.z)

    def beside(self, cutter: ag.Solid) -> ag.Solid:
        """Move a cutter for the sheet to the edge of the neighboring wall or sheet."""
        mirrored = cutter.mirror((0.0, 1.0, 0.0))
        if not self.folded:  # the wall goes down from the corner
            mirrored = mirrored.rotate(ag.X, math.pi / 2.0)
        return mirrored.rotate(ag.Z, self.turn).at(self.x, self.y, self.z)

    def bead(self, length: ag.Scalar, label: str, finish: ag.Material) -> ag.Body:
        """Make the liner that runs through the crease, in the frame of the neighboring wall or sheet."""
        bulge = ag.cylinder(_BEAD, length, axis=ag.X).at(0.0, FOLD if self.folded else -FOLD, FOLD)
        return ag.detail(bulge.rotate(ag.Z, self.turn).at(self.x, self.y, self.z), label, finish)

    def joint(
        self,
        name: str,
        *,
        feel: Feel,
        length: ag.Scalar,
        reach: ag.Scalar,
        opening: ag.Scalar,
        needs: ag.Condition | ag.Dependency | None = None,
        holding: ag.Scalar = 0.0,
    ) -> ag.Joint:
        """Make the hinge joint of a crease."""
        cosine, sine = math.cos(self.turn), math.sin(self.turn)
        across, up = (FOLD, FOLD) if self.folded else (-FOLD, FOLD)
        friction = feel.friction * length
        return ag.Revolute(
            name,
            axis=(cosine, sine, 0.0),
            pivot=(self.x - sine * across, self.y + cosine * across, self.z + up),
            limits=(0.0, opening),
            stiffness=feel.stiffness * length,
            rest=feel.rest,
            friction=ag.max_(friction, holding),
            damping=feel.damping * length,
            armature=ag.max_(2e-5, 3e-4 * friction),  # contacts of lighter parts yield to a push
            effort=0.01
            + length * (1.6 * feel.friction + 5.0 * feel.stiffness + 16.0 * reach**2)
            + 1.5 * holding,
            velocity=12.0,
            needs=needs,
        )


_ROUND = 0.0018  # radius of upright edges at the scored liner [m]
_HOLE = (0.082, 0.030)  # width and height of hand holes [m]
_RIM = 0.010  # least width of board around hand holes [m]
_NO_RIM = (
    "hand holes need a centimetre of board around them: take a larger width, aspect or height, or holes=False"
)


def walls(
    board: Board,
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    *,
    base: ag.Scalar = 0.0,
    floor: bool = True,
) -> ag.Solid:
    """Make four walls and the floor between them."""
    t = board.thick
    shell = ag.Region.between(
        (-width / 2.0, -depth / 2.0, base), (width / 2.0, depth / 2.0, height + 0.004)
    ).box(bevel=_ROUND)
    bottom = base + t if floor else base - 0.01
    shell = shell - ag.Region.between((-width, -depth, height), (width, depth, height + 0.01)).box().paint(
        board.edge
    )
    inside = ag.Region.between(
        (-width / 2.0 + t, -depth / 2.0 + t, bottom), (width / 2.0 - t, depth / 2.0 - t, height + 0.01)
    ).box()
    return shell.paint(board.outside) - inside.paint(board.inside)


def bottom_flaps(board: Board, width: ag.Scalar, depth: ag.Scalar, *, label: str = "box") -> ag.Body:
    """Make the minor flaps of the bottom, inside on the major flaps, and the seam of the major flaps."""
    t = board.thick
    reach, half = depth / 2.0 - SLIT / 2.0, depth / 2.0 - t - SLIT
    near = width / 2.0 - t - 0.0004
    sheets = []
    for side in (-1.0, 1.0):
        flap = board.sheet(ag.rectangle(reach - t, 2.0 * half), relief=None)
        # turned over: the printed face is below
        flap = flap.rotate(ag.X, math.pi).at(side * (near - (reach - t) / 2.0), 0.0, t - 0.0002)
        sheets.append(ag.part(flap, label, board.outside))
    free = width / 2.0 - reach - 0.004
    line = seam((-free, -0.0012, t - 0.0002), (free, 0.0012, t + 0.0001))
    return ag.weld(*sheets, line)


def hand_holes(
    solid: ag.Solid,
    width: ag.Scalar,
    height: ag.Scalar,
    board: Board,
    *,
    depth: ag.Scalar,
    span: tuple[ag.Scalar, ag.Scalar],
) -> ag.Solid:
    """Cut a square hand hole into each side wall; `hole_corners` fills its corners."""
    wide, tall = _HOLE
    beside, (low, high) = depth / 2.0 - board.thick - _RIM, span
    over = tall / 2.0 + _RIM
    fits = (beside >= wide / 2.0) & (height - over >= low) & (height + over <= high)
    solid = solid.require(fits, _NO_RIM)
    for side in (-1.0, 1.0):
        hole = ag.box(0.05, wide, tall).paint(board.edge)
        solid = solid - hole.at(side * width / 2.0, 0.0, height)
    return solid


def hole_corners(width: ag.Scalar, height: ag.Scalar, board: Board, *, label: str = "box") -> list[ag.Body]:
    """Make the slanted corners of hand holes, visual only, so that a wall needs few collision boxes."""
    x, y = _HOLE[0] / 2.0, _HOLE[1] / 2.0
    over = 0.0003  # overlap with the wall
    corner = ag.polygon([(x, 0.4 * y), (x + over, 0.4 * y), (x + over, y + over), (x - 0.6 * y, y + over),
                      (x - 0.6 * y, y)])  # fmt: skip
    upper = corner | corner.mirror(1.0, 0.0)
    corners = ag.extrude(upper | upper.mirror(0.0, 1.0), board.thick - 0.0002, axis=ag.X)
    out = (width - board.thick) / 2.0
    return [ag.detail(corners.at(side * out, 0.0, height), label, board.outside) for side in (-1.0, 1.0)]


def cells(
    board: Board,
    width: ag.Scalar,
    depth: ag.Scalar,
    *,
    columns: int,
    rows: int,
    low: ag.Scalar,
    high: ag.Scalar,
    finish: ag.Material | None = None,
) -> ag.Body | None:
    """Make the interlocking dividers of a box for bottles; none for a single cell."""
    thick = 0.6 * board.thick
    boards = []
    for number in range(1, columns):
        x = width * (number / columns - 0.5)
        boards.append(
            ag.Region.between(
                (x - thick / 2.0, -depth / 2.0 + LAYER, low), (x + thick / 2.0, depth / 2.0 - LAYER, high)
            ).box()
        )
    for number in range(1, rows):
        y = depth * (number / rows - 0.5)
        boards.append(
            ag.Region.between(
                (-width / 2.0 + LAYER, y - thick / 2.0, low), (width / 2.0 - LAYER, y + thick / 2.0, high)
            ).box()
        )
    if not boards:
        return None
    whole = boards[0]
    for each in boards[1:]:
        whole = whole | each
    return ag.part(
        whole, "divider", finish or board.inside, separate="they stand between the walls, a hair off them"
    )
