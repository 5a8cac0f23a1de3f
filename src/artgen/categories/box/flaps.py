"""Slotted tops: four flaps at the walls; the major flaps meet in the middle above the minor ones."""

import math
from dataclasses import dataclass

import artgen as ag
from artgen.categories.box.board import FOLD, LAYER, SLIT, TOP, Board, Crease, Feel, Mouth
from artgen.categories.box.bottles import Bottles
from artgen.categories.box.prints import TAPE, pull_tab

_UPRIGHT = 1.60  # least angle of a flap that leaves the space above the box free [rad]
_HANGING = 3.40  # least angle of a flap that is below the flaps that close over the box [rad]
_LYING = 0.03  # angle before the open end at which a flap already lies on the floor [rad]
_SHORT = 0.012  # height of the pull tab of a flap that opens to the floor [m]
_MAJORS_MEET = (
    "the short flaps of thick board would collide as they open: raise width or aspect, or take a "
    "thinner flute"
)
_TAPE_WIDE = 0.048  # width of packing tape, half of it on each flap after it is slit [m]


@dataclass(frozen=True)
class Top:
    """Four flaps of equal length at the top of a box, the major ones at the front and the back."""

    board: Board  # board of the box
    width: ag.Scalar  # outer width of the box along x [m]
    depth: ag.Scalar  # outer depth of the box along y [m]
    height: ag.Scalar  # height of the closed box [m]
    swing: ag.Scalar  # opening angle of flaps without obstacles [rad]
    taped: bool  # whether slit tape lies along the seam
    ground: ag.Scalar = 0.0  # least height at which flaps can hang down freely [m]
    # distance from the middle of a minor flap to the point at which a hand pushes it up [m]
    beside: ag.Scalar = 0.0
    mouth: Mouth = TOP  # names of the sides, and whether the front flap opens to the floor

    @property
    def reach(self) -> ag.Scalar:
        """Length of a flap from its crease to its free edge [m]."""
        return self.depth / 2.0 - SLIT / 2.0

    @property
    def low(self) -> ag.Scalar:
        """Height of the walls with minor flaps, one layer lower [m]."""
        return self.height - self.board.thick - LAYER

    @property
    def opening(self) -> ag.Float:
        """Opening angle of flaps: they stop before the floor and before their tabs meet the walls [rad]."""
        down = math.pi + 0.9 * (self.low - self.ground) / self.reach
        return ag.min_(ag.min_(self.swing, down), 1.5 * math.pi - 0.028 / self.reach)

    @property
    def _shy(self) -> ag.Scalar:
        """Angle by which a flap stays above the floor because of the tab below it [rad]."""
        return (_SHORT + 0.0015) / self.reach

    @property
    def _taper(self) -> ag.Scalar:
        """Narrowing of a minor flap at each side of its tip, to clear a flap on the floor [m]."""
        return 1.15 * (self._shy + _LYING) * self.reach if self.mouth.grounded else 0.0

    def majors(self) -> dict[str, Crease]:
        """Return the creases of the front and the back wall."""
        return {
            "front": Crease(0.0, -self.depth / 2.0, self.height),
            "back": Crease(0.0, self.depth / 2.0, self.height, turn=math.pi),
        }

    def minors(self) -> dict[str, Crease]:
        """Return the creases of the side walls."""
        return {
            "left": Crease(-self.width / 2.0, 0.0, self.low, turn=-math.pi / 2.0),
            "right": Crease(self.width / 2.0, 0.0, self.low, turn=math.pi / 2.0),
        }

    def creased(self, walls: ag.Solid) -> ag.Solid:
        """Cut the upper edges of walls of full height for their creases."""
        t = self.board.thick
        lowered = walls
        for side in (-1.0, 1.0):
            low = (side * self.width / 2.0 - 1.6 * t, -self.depth / 2.0 - 0.01, self.low)
            high = (side * self.width / 2.0 + 1.6 * t, self.depth / 2.0 + 0.01, self.height + 0.01)
            lowered = lowered - ag.Region.between(low, high).box().paint(self.board.edge)
        return self.board.creased(lowered, *self.majors().values(), *self.minors().values())

    def attached(
        self,
        body: ag.Body,
        feel: Feel,
        *,
        printed: dict[str, list[ag.Body]] | None = None,
        label: str = "box",
        bottles: Bottles | None = None,
    ) -> ag.Body:
        """Join the four flaps to a box."""
        turns: list[ag.Joint] = []
        marks = printed or {}
        thick, free = self.board.thick + FOLD, SLIT / 2.0 - 0.0002  # the lower edge swings out less
        body = body.require(self.reach >= (thick**2 - free**2) / (2.0 * free), _MAJORS_MEET)
        for side, crease in self.majors().items():
            lying = self.mouth.grounded and side == "front"
            turn = crease.joint(
                self.mouth.hinge("flap", side),
                feel=feel,
                length=self.width,
                reach=self.reach,
                opening=math.pi / 2.0 - self._shy if lying else self.opening,
            )
            if not lying:
                body = ag.weld(body, crease.bead(self.width - 0.003, label, self.board.outside))
            body = body.attach(crease.place(self._major(side, marks.get(side, []))), turn)
            turns.append(turn)
        resting = Feel(0.0, 0.0, feel.friction, feel.damping)
        down = math.pi / 2.0 - self._shy - _LYING if self.mouth.grounded else _UPRIGHT
        wide = (turns[0] > down) & (turns[1] > _UPRIGHT)
        for side, crease in self.minors().items():
            turn = crease.joint(
                self.mouth.hinge("flap", side),
                feel=resting,
                length=self.depth,
                reach=self.reach,
                opening=self.opening,
                needs=wide.until(_HANGING),
            )
            turns.append(turn)
            body = ag.weld(body, crease.bead(self.depth - 0.003, label, self.board.outside))
            body = body.attach(crease.place(self._minor(side)), turn)
        if bottles is None:
            return body
        return bottles.below(turns, _UPRIGHT, body)

    def _major(self, side: str, marks: list[ag.Body]) -> ag.Body:
        wide = self.width - 0.003
        sheet = self.board.sheet(ag.rectangle(wide, self.reach).at(0.0, self.reach / 2.0))
        aside = 0.2 * self.width  # each tab to the right of its flap: a hand has space beside the other tab
        tall = _SHORT if self.mouth.grounded and side == "front" else 0.021
        tab = pull_tab(tall).at(aside, self.reach - 0.0035, 0.0)
        hold = ag.grasp_on(tab, approach=-ag.Z, closing=(0.0, 1.0, 0.0), depth=0.76 * tall)
        bodies = [
            ag.part(sheet, "flap_major", self.board.outside, name=self.mouth.link("flap", side)),
            ag.part(tab, "tape", TAPE, name=self.mouth.link("tab", side), grasp=hold),
        ]
        if self.taped:
            low = (-wide / 2.0 + 0.001, self.reach - _TAPE_WIDE / 2.0, -0.0001)
            strip = ag.Region.between(low, (wide / 2.0 - 0.001, self.reach - 0.0002, 0.00012)).box()
            bodies.append(ag.detail(strip, "tape", TAPE))
        return ag.weld(*bodies, *marks)

    def _minor(self, side: str) -> ag.Body:
        wide = self.depth - 2.0 * self.board.thick - 2.0 * SLIT
        outline = ag.rectangle(wide, self.reach).at(0.0, self.reach / 2.0)
        if self.mouth.grounded:
            near, far = wide / 2.0, wide / 2.0 - self._taper
            outline = ag.polygon([(-near, 0.0), (near, 0.0), (far, self.reach), (-far, self.reach)])
        sheet = self.board.sheet(outline)
        below = ag.push_on(sheet, direction=ag.Z, at=(self.beside, 0.52 * self.reach, 0.0))
        name = self.mouth.link("flap", side)
        return ag.part(sheet, "flap_minor", self.board.outside, name=name, push=below)

    def tape_ends(self) -> list[ag.Body]:
        """Make the ends of the tape on the side walls, or nothing without tape."""
        if not self.taped:
            return []
        ends = []
        for side in (-1.0, 1.0):
            face, half = side * self.width / 2.0, _TAPE_WIDE / 2.0
            low = (face - 0.00012, -half, self.low - 0.065)
            ends.append(
                ag.detail(
                    ag.Region.between(low, (face + 0.00012, half, self.low - 0.001)).box(), "tape", TAPE
                )
            )
        return ends
