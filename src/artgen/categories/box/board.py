"""Corrugated board: sheets, the creases that hinge them, walls, hand holes and dividers."""

import functools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.box.finish import SHADE
from artgen.nodes.fitting import Fitting

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

AXIS = (0.0, -FOLD, FOLD)
"""A point on the axis of a crease, which runs along x, in the frame of its sheet [m]."""

Side = Literal["front", "back", "left", "right"]
# outward direction of each side, and the turn about z of a sheet that points inward from there [rad]
_SIDES: dict[Side, tuple[int, int, float]] = {
    "front": (0, -1, 0.0),
    "back": (0, 1, math.pi),
    "left": (-1, 0, -math.pi / 2),
    "right": (1, 0, math.pi / 2),
}
_GAP = 0.0002  # gap from a corner to the end of each sheet, along its face [m]
_BEAD = 0.00045  # radius of the bulge of the liner about the axis, less than that of the edges of sheets [m]
_FAR = 2.5  # length greater than any sheet [m]


@dataclass(frozen=True)
class Board:
    """Board of a box with the resistance, per meter, and the range of its creases."""

    flute: Flute
    outside: ag.Material  # liner of the outer face
    inside: ag.Material  # liner of the inner face
    stiffness: ag.Scalar  # spring of a fresh crease, which pulls to `rest` [N m/rad]
    rest: ag.Scalar  # angle to which a flap of a new box springs open [rad]
    friction: ag.Scalar  # moment of a bent crease, which holds flaps in place [N m]
    damping: ag.Scalar  # [N m s/rad]
    swing: ag.Scalar  # opening angle of flaps in free space [rad]
    opening: ag.Scalar  # opening angle of lids [rad]

    @property
    def thick(self) -> float:
        """Thickness [m]."""
        return THICK[self.flute]

    @property
    def edge(self) -> ag.Material:
        """Material of cut edges: liners with the wave between them, or the wrap of grayboard."""
        if self.flute == "grey":
            return self.outside
        tile = (self.thick / len(self.flute), 0.064)  # double walls have two waves
        return ag.material("cardboard_edge").with_(name=f"{self.flute}_flute_edge", tile=tile)

    def under(self, height: ag.Scalar) -> ag.Scalar:
        """Return the height of a sheet under a sheet at `height` [m]."""
        return height - self.thick - LAYER

    def sheet(self, outline: ag.Profile, *, relief: ag.Scalar | None = 0.0) -> ag.Solid:
        """Cut a sheet with its outer face at z = 0, mitered for a crease at y = `relief`."""
        t, wide, long = self.thick, (-_FAR - 0.1, _FAR + 0.1), (-_FAR, _FAR)  # texture runs along x
        core = ag.extrude(outline, 3 * t).at(z=-t / 2).paint(self.edge)
        upper = ag.Region(wide, long, (-2 * t, 0.0)).box().paint(self.outside)
        cut = core & (upper & ag.Region(wide, long, (-t, t)).box().paint(self.inside))
        return cut if relief is None else cut - self._miter().at(0.0, relief)

    def _miter(self) -> ag.Solid:
        """Make the cutter that frees the space of a crease, in the frame of the sheet."""
        t = self.thick
        wedge = ag.polygon([(_GAP - 2 * t, 2 * t), (_GAP + 3 * t, -3 * t), (_GAP - 2 * t, -3 * t)])
        return ag.extrude(wedge, 2 * _FAR, axis=ag.X).paint(self.inside)

    def crease(
        self,
        name: str,
        *,
        length: ag.Scalar,
        reach: ag.Scalar,
        opening: ag.Scalar,
        fresh: bool = False,
        needs: ag.Condition | ag.Dependency | None = None,
        holding: ag.Scalar = 0.0,
        damping: ag.Scalar | None = None,
    ) -> ag.Joint:
        """Make the joint of a crease; `holding` is the least friction [N m], `damping` that of a meter."""
        friction, spring = self.friction * length, self.stiffness if fresh else 0.0
        push = 1.6 * self.friction + 5.0 * spring + 16.0 * reach**2  # by a hand, per meter of crease [N m]
        return ag.Revolute(
            name,
            axis=ag.X,
            pivot=AXIS,
            limits=(0.0, opening),
            stiffness=spring * length,
            rest=self.rest if fresh else 0.0,
            friction=ag.max_(friction, holding),
            damping=length * (self.damping if damping is None else damping),
            armature=ag.max_(2e-5, 3e-4 * friction),  # contacts of lighter parts yield to a push
            effort=0.01 + length * push + 1.5 * holding,
            velocity=12.0,
            needs=needs,
        )

    def fold(
        self,
        sheet: ag.Body,
        crease: ag.Joint,
        on: ag.Region,
        side: Side,
        *,
        bead: ag.Scalar | None = None,
        label: str = "box",
        hangs: bool = False,
    ) -> Fitting:
        """Hinge a sheet at the upper edge of a region, over which it closes; or from which it `hangs`.

        The `bead` is the length of the bulge of the liner on the crease [m], its label that of the host.
        """
        x, y, turn = _SIDES[side]
        bulge = None
        if bead is not None:
            bulge = ag.detail(ag.cylinder(_BEAD, bead, axis=ag.X).at(AXIS), label, self.outside)
        miter = self._miter().mirror(ag.Y).rotate(ag.X, math.pi / 2)
        flap = Fitting.moving(sheet, crease, fixed=bulge, cut=miter)
        if hangs:
            flap, turn = flap.rotate(ag.X, -math.pi / 2), turn + math.pi
        return flap.rotate(ag.Z, turn).at(on.anchor(x=x, y=y, z=1))

    def lowered(self, case: ag.Region) -> ag.Solid:
        """Return what is cut off the side walls, on which flaps lie one layer lower."""
        low, t = self.under(case.z.high), 1.6 * self.thick
        above = case.grow(0.01).with_(z=(low, case.z.high + 0.01))
        return ag.union(
            *(above.with_(x=(x - t, x + t)).box().paint(self.edge) for x in (case.x.low, case.x.high))
        )


def together(*parts: Fitting | ag.Body, cuts: Sequence[ag.Solid] = ()) -> Fitting:
    """Join fittings and other parts to one fitting, whose cuts are made before any part is added."""
    bodies = [each.body if isinstance(each, Fitting) else each for each in parts]
    cuts = [*cuts, *(each.cut for each in parts if isinstance(each, Fitting) and each.cut is not None)]
    return Fitting(ag.weld(*bodies), ag.union(*cuts) if cuts else None)


def tongue(
    half: ag.Scalar, reach: ag.Scalar, *, tip: ag.Scalar, shoulder: ag.Scalar | None = None
) -> ag.Profile:
    """Make the outline of a flap that narrows from its crease, or its shoulder, to its tip."""
    corners = [(half, 0.0), *([] if shoulder is None else [(half, shoulder)]), (tip, reach)]
    return ag.polygon([*corners, *((-x, y) for x, y in reversed(corners))])


def walls(board: Board, case: ag.Region, *, floor: bool = True) -> ag.Solid:
    """Make four walls around a region, and the floor between them."""
    t = board.thick
    shell = case.grow(top=0.004).box(bevel=0.0018)  # upright edges are rounded at the scored liner
    above = case.grow(0.1).with_(z=(case.z.high, case.z.high + 0.01))
    shell = shell - above.box().paint(board.edge)
    inside = case.shrink(t, top=-0.01, bottom=t if floor else -0.01)
    return shell.paint(board.outside) - inside.box().paint(board.inside)


def bottom_flaps(board: Board, case: ag.Region) -> ag.Body:
    """Make the minor flaps of the bottom, inside on the major flaps, and the seam of the major flaps."""
    t, (width, depth, _) = board.thick, case.size
    reach = depth / 2 - SLIT / 2
    outline = ag.rectangle(reach - t, depth - 2 * (t + SLIT))
    sheet = board.sheet(outline, relief=None).rotate(ag.X, math.pi)  # the printed face is below
    out, high = width / 2 - t - 0.0004 - (reach - t) / 2, t - 0.0002
    free = width / 2 - reach - 0.004
    line = ag.Region((-free, free), (-0.0012, 0.0012), (high, t + 0.0001)).box()
    flaps = [sheet.at(side * out, 0.0, high) for side in (-1, 1)]
    return ag.weld(ag.part(flaps, "box", board.outside), ag.detail(line, "box", SHADE))


_HOLE = (0.082, 0.030)  # width and height of hand holes [m]
_RIM = 0.010  # least width of board around hand holes [m]
_NO_RIM = (
    "hand holes need a centimetre of board around them: take a larger width, aspect or height, or holes=False"
)


def hand_holes(board: Board, case: ag.Region, height: ag.Scalar, label: str = "box") -> Fitting:
    """Make square holes in both side walls, with slanted corners at a height in a region of free wall.

    The corners are visual only, so that a wall needs few collision boxes.
    """
    wide, tall = _HOLE
    x, y, over = wide / 2, tall / 2, 0.0003  # overlap with the wall
    rim = y + _RIM
    fits = (case.y.size / 2 - board.thick - _RIM >= x) & (height - rim >= case.z.low)
    hole = ag.box(0.05, wide, tall).require(fits & (height + rim <= case.z.high), _NO_RIM).paint(board.edge)
    corner = ag.polygon([(x, 0.4 * y), (x + over, 0.4 * y), (x + over, y + over), (x - 0.6 * y, y + over),
                      (x - 0.6 * y, y)])  # fmt: skip
    upper = corner | corner.mirror(1.0, 0.0)
    corners = ag.extrude(upper | upper.mirror(0.0, 1.0), board.thick - 0.0002, axis=ag.X)
    out = case.x.high - board.thick / 2
    filled = ag.detail([corners.at(side * out, 0.0, height) for side in (-1, 1)], label, board.outside)
    return Fitting(filled, ag.union(*(hole.at(side * case.x.high, 0.0, height) for side in (-1, 1))))


def dividers(board: Board, room: ag.Region, *, columns: int, rows: int) -> ag.Body:
    """Make the interlocking dividers of a box for bottles."""
    half, inner = 0.3 * board.thick, room.shrink(x=LAYER, y=LAYER)
    edges = [cell.x.low for cell in room.columns(columns)[1:]], [cell.y.low for cell in room.layers(rows)[1:]]
    sheets = [inner.with_(x=(x - half, x + half)) for x in edges[0]]
    sheets += [inner.with_(y=(y - half, y + half)) for y in edges[1]]
    whole = functools.reduce(operator.or_, (sheet.box() for sheet in sheets))
    loose = "they stand between the walls, a hair off them"
    return ag.part(whole, "divider", board.inside, separate=loose)
