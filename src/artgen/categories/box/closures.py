"""Closures of boxes: slotted tops of four flaps, and lids with tucks, ears, side flaps and dust flaps.

Each is a fitting for the walls around a region; its cut lowers them and miters them at the creases.
"""

import math
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.box import prints
from artgen.categories.box.board import AXIS, FOLD, SLIT, Board, Side, together, tongue
from artgen.categories.box.finish import TAPE
from artgen.nodes.fitting import Fitting

Mouth = Literal["", "_left", "_right"]
"""The opening at the top of a box, or at an end of a box on its side: the suffix of its names."""

_NAMES: dict[Mouth, dict[Side, str]] = {
    "": {"front": "front", "back": "back", "left": "left", "right": "right"},
    "_left": {"front": "lower", "back": "upper", "left": "back", "right": "front"},  # upside down
    "_right": {"front": "lower", "back": "upper", "left": "front", "right": "back"},
}
_MAJOR: tuple[Side, ...] = ("front", "back")
_MINOR: tuple[Side, ...] = ("left", "right")
_CLEAR = 1.60  # least angle of a flap that leaves the space above the box free [rad]
_HANGING = 3.40  # least angle of a flap that is below the flaps that close over the box [rad]
_LYING = 0.03  # angle before the open end at which a flap already lies on the floor [rad]
_SHORT = 0.012  # height of the pull tab of a flap that opens to the floor [m]
_MAJORS_MEET = (
    "the short flaps of thick board would collide as they open: raise width or aspect, or take a "
    "thinner flute"
)
_MINORS_MEET = "the flaps of a square box meet: aspect must be <= 0.96"


def flap_reach(case: ag.Region) -> ag.Scalar:
    """Return the length of the flaps of a slotted top from their creases to their free edges [m]."""
    return case.y.size / 2 - SLIT / 2


def slotted_top(
    board: Board,
    case: ag.Region,
    *,
    taped: bool,
    printed: Sequence[ag.Body] = (),
    mouth: Mouth = "",
    label: str = "box",
    ground: ag.Scalar = 0.0,
    beside: ag.Scalar = 0.0,
) -> tuple[Fitting, list[ag.Condition]]:
    """Make four flaps of equal length; the major ones, in front and behind, meet above the minor ones.

    Return also the conditions that the flap in front, behind, at the left and at the right is open. `printed`
    is on the front flap, `ground` the least height of hanging flaps, and `beside` the distance from the
    middle of a minor flap to the point at which a hand pushes it up [m].
    """
    (width, depth, _), t, names = case.size, board.thick, _NAMES[mouth]
    reach, low = flap_reach(case), board.under(case.z.high)
    down = math.pi + 0.9 * (low - ground) / reach  # before flaps meet the floor
    against = 1.5 * math.pi - 0.028 / reach  # before their tabs meet the walls
    opening = ag.min_(ag.min_(board.swing, down), against)
    shy = (_SHORT + 0.0015) / reach  # angle by which the tab below a flap keeps it above the floor [rad]
    thick, free = t + FOLD, SLIT / 2 - 0.0002  # the lower edge swings out less
    meet = reach >= (thick**2 - free**2) / (2 * free)
    folds, opened = [], []
    for side in _MAJOR:
        stem, lying = f"flap_{names[side]}", mouth != "" and side == "front"
        wide, tall = width - 0.003, _SHORT if lying else 0.021
        # each tab to the right of its flap: a hand has space beside the other tab
        tab = prints.pull_tab(f"tab_{names[side]}{mouth}", tall=tall, depth=0.76 * tall).at(
            0.2 * width, reach - 0.0035
        )
        sheet = board.sheet(ag.rectangle(wide, reach).at(0.0, reach / 2)).require(meet, _MAJORS_MEET)
        flap = ag.weld(ag.part(sheet, "flap_major", board.outside, name=f"{stem}{mouth}"), tab)
        if taped:
            lap = (reach - prints.TAPE_WIDE / 2, reach - 0.0002)
            strip = ag.Region((0.001 - wide / 2, wide / 2 - 0.001), lap, (-0.0001, 0.00012))
            flap = ag.weld(flap, ag.detail(strip.box(), "tape", TAPE))
        if side == "front":
            flap = ag.weld(flap, *printed)
        most = math.pi / 2 - shy if lying else opening
        turn = board.crease(f"{stem}_hinge{mouth}", length=width, reach=reach, opening=most, fresh=True)
        folds.append(board.fold(flap, turn, case, side, bead=None if lying else wide, label=label))
        opened.append(turn > (most - _LYING if lying else _CLEAR))
    wide = depth - 2 * (t + SLIT)
    narrower = 1.15 * (shy + _LYING) * reach if mouth else 0.0  # clears a flap on the floor
    for side in _MINOR:
        sheet = board.sheet(tongue(wide / 2, reach, tip=wide / 2 - narrower))
        sheet = sheet if mouth else sheet.require(width - depth > 0.006, _MINORS_MEET)
        below = ag.push_on(sheet, direction=ag.Z, at=(beside, 0.52 * reach, 0.0))
        stem, needs = f"flap_{names[side]}", (opened[0] & opened[1]).until(_HANGING)
        flap = ag.part(sheet, "flap_minor", board.outside, name=f"{stem}{mouth}", push=below)
        turn = board.crease(f"{stem}_hinge{mouth}", length=depth, reach=reach, opening=opening, needs=needs)
        lower = case.with_(z=(case.z.low, low))
        folds.append(board.fold(flap, turn, lower, side, bead=depth - 0.003, label=label))
        opened.append(turn > _CLEAR)
    ends = [prints.tape_ends(case.with_(z=(low - 0.065, low - 0.001)))] if taped else []
    return together(*folds, *ends, cuts=[board.lowered(case)]), opened


Sides = Literal["over", "tucked"]
"""Whether the sides of a lid lie on the walls, or each has a flap that goes between the walls."""

_SLACK = 0.020  # play of the tuck while its lid is closed [rad]
_PLAY = 0.043  # additional angle until the tuck touches the wall [rad]
_TIP = 0.0004  # gap from the tip of an upright tuck to the wall [m]
_BESIDE = 0.0012  # gap from ears and side flaps to the walls [m]
# label of the sheet above a flap, depth of a grasp at its edge, and by how much its bead is shorter [m]
_TONGUES = {"tuck": ("lid", 0.016, 0.0), "ear": ("tuck", 0.014, 0.002), "lip": ("flap_minor", 0.014, 0.004)}
_RISEN = 1.66  # least angle of a lid that leaves the space above the box free [rad]
_AWAY = 2.0  # least angle of a lid whose tuck leaves this space free as well [rad]
_NO_WINGS = (
    "the side flaps of a lid have no room between its crease and its tuck: raise width or "
    "aspect, ears=False or sides=over"
)


class Lid:
    """A lid hinged at the back: a flap tucks in at the front, ears or side flaps lock it.

    When the lid rises, the tuck swings out by its reach squared over twice the depth of the lid. Therefore
    the tuck leans inward a little, as does the inner layer of the rolled front wall, which holds its tip.

    Ears at the tuck go in beside the walls, before a second layer of them that starts at `lined`; `dust` is
    the reach of dust flaps at the walls under the lid, which may end in lips that are folded down; `grip` is
    the distance from the tuck to the tab that opens the lid [m].
    """

    def __init__(
        self,
        board: Board,
        case: ag.Region,
        *,
        sides: Sides = "over",
        ears: bool = False,
        dust: ag.Scalar | None = None,
        lips: bool = False,
        lined: ag.Scalar | None = None,
        grip: ag.Scalar = 0.006,
        mouth: Mouth = "",
    ) -> None:
        (width, depth, height), t = case.size, board.thick
        self.board, self.case, self.ears, self.dust, self.lips = board, case, ears, dust, lips
        self.lined, self.grip, self.mouth = lined, grip, mouth
        self.tucked, self.names = sides == "tucked", _NAMES[mouth]
        self.tuck = ag.min_(0.15 * depth + 0.005, 0.72 * height)  # reach of the tuck [m]
        out = self.tuck / (2 * (depth - 2 * t - 0.003))  # outward swing of the tuck [rad]
        self.gap = ag.max_(0.0015, 2 * _TIP + self.tuck * (out - _PLAY))  # from the lid to the front wall [m]
        self.reach = depth - 2 * t - self.gap  # from the crease of the lid to that of its tuck [m]
        self.low = height if self.tucked else board.under(height)  # height of the side walls [m]
        self.inner = width / 2 - (2 if ears else 1) * t  # half of the width between the side walls [m]
        self.half = self.inner - _BESIDE if self.tucked else width / 2 - 0.0012  # half of the lid's width [m]
        self.top = ag.Region((-self.half, self.half), (0.0, self.reach), (-t, 0.0))  # the lid's sheet
        self.ear = ag.min_(0.056, ag.max_(0.24 * self.reach, 0.034))  # reach of ears back from the tuck [m]
        length = 2 * self.half
        mass = 1.2 * board.outside.density * t * length * self.reach
        # the damping of a fresh crease takes energy out of a lid, which otherwise slams shut
        calm = 2 * ag.sqrt(board.stiffness * length * 0.45 * mass * self.reach**2) / length
        self.turn = board.crease(
            f"lid_hinge{mouth}",
            length=length,
            reach=self.reach,
            opening=board.opening,
            fresh=True,
            holding=feel.GRAVITY * mass * 0.62 * self.reach,  # an open lid with its flaps out stays up
            damping=ag.max_(board.damping, calm),
        )
        self.away = self.turn > _AWAY  # the condition that the space above the box is free

    def fitting(self, printed: Sequence[ag.Body] = ()) -> Fitting:
        """Make the lid with its flaps and prints, and the second layers of the walls."""
        lid = self.board.fold(self._lid(printed), self.turn, self.case, "back", bead=2 * self.half)
        dust = [] if self.dust is None else [self._dust_flap(side, self.dust) for side in _MINOR]
        cuts = [] if self.tucked else [self.board.lowered(self.case)]
        return together(self._rims(), lid, *dust, cuts=cuts)

    def _rims(self) -> ag.Body:
        """Make the lip of the front wall, and the second layer of the walls that holds the ears."""
        t, front, half, height = self.board.thick, self.case.y.low, self.inner - 0.0003, self.case.z.high
        layer, tip, inward = front + 2 * t, height - self.tuck, self.gap - _TIP
        high, low = height - 0.5 * self.tuck, 0.85 * tip
        wedge = [(layer - 0.6 * t, high), (layer, high), (layer + inward, tip), (layer + inward, low),
                 (layer - 0.6 * t, low)]  # fmt: skip
        bar = ag.Region((-half, half), (front + t - 0.0003, layer), (0.8 * tip, height - 0.0002))
        rims = [bar.box(bevel=0.0008) | ag.extrude(ag.polygon(wedge), 2 * half - 0.001, axis=ag.X)]
        if self.ears:
            top = self.low - 0.0002 if self.dust is None else self.board.under(self.low)
            start = t - 0.0002 if self.lined is None else self.lined
            inside = self.case.shrink(y=t + 0.0006).with_(z=(start, top))
            right = inside.with_(x=(self.inner, self.inner + t + 0.0003))
            rims += [side.box(bevel=0.0008) for side in (right.mirror(), right)]
        return ag.part(rims, "box", self.board.outside)

    def _lid(self, printed: Sequence[ag.Body]) -> ag.Body:
        """Make the lid with its flaps, in the frame of its sheet."""
        board, reach, tuck, half = self.board, self.reach, self.tuck, self.inner - _BESIDE
        far = ag.sqrt(tuck**2 + self.ear**2) if self.ears else tuck
        clear = 1.13 * (far + 0.008) / reach  # least angle at which the tuck clears the box in any pose [rad]
        cut = 0.30 * tuck
        outline = tongue(half, tuck, shoulder=tuck - cut, tip=half - cut)
        ears = []
        if self.ears:
            outline = ag.rectangle(2 * half, tuck).at(0.0, tuck / 2)
            above = ag.max_(ag.atan2(tuck + 0.012, reach - self.ear), clear)  # ears are above the walls [rad]
            on = ag.Region((-half, half), (board.thick + 0.004, tuck - 0.003), (0.0, 0.0))
            long, deep = on.y.size, self.ear
            bend = board.sheet(tongue(long / 2, deep, shoulder=0.6 * deep, tip=long / 4))
            needs = (self.turn > above).beyond(0.35 * _BESIDE / deep)
            ears = [
                self._tongue("ear", side, bend, on, side, long, deep, opening=1.5, needs=needs)
                for side in _MINOR
            ]
        sheet, size, bead = board.sheet(outline, relief=0.0005), (2 * half, tuck), 2 * self.half - 0.004
        needs, lean = (self.turn > clear).beyond(_SLACK), _PLAY - _TIP / tuck + _SLACK
        front = self._tongue(
            "tuck", "front", sheet, self.top, "back", *size, needs=needs, bead=bead, lean=lean, ears=ears
        )
        wings = []
        top = board.sheet(self.top.plan())
        if self.tucked:
            behind = self.ear + 0.004 if self.ears else 0.0  # the tuck and its ears
            end = reach - behind - 0.014 - 0.05 * tuck - board.thick
            on = self.top.with_(y=(0.30 * reach, end))
            long, deep = on.y.size, 0.8 * tuck
            top = top.require(long >= 0.6 * deep + 0.006, _NO_WINGS)
            bend = board.sheet(tongue(long / 2, deep, shoulder=0.5 * deep, tip=long / 2 - 0.3 * deep))
            needs = (self.turn > ag.atan2(deep + 0.010, on.y.low)).beyond(0.4 * _BESIDE / deep)
            wings = [
                self._tongue("tuck", side, bend, on, side, long, deep, opening=2.6, needs=needs)
                for side in _MINOR
            ]
        edge = reach - self.grip
        tab = prints.pull_tab(f"tab{self.mouth}")
        seal = []
        if self.grip > 0.01:  # tape goes over the edge, and near the floor a hand has space beside the tab
            tab = tab.rotate(ag.Z, -math.pi / 2)
            strip = ag.Region((-0.024, 0.024), (edge - 0.012, reach - 0.0005), (-0.0001, 0.00012))
            seal = [ag.detail(strip.box(), "tape", TAPE)]
        lid = ag.part(top, "lid", board.outside, name=f"lid{self.mouth}").install(together(front, *wings))
        return ag.weld(lid, tab.at(0.0, edge), *seal, *printed)

    def _tongue(
        self,
        kind: Literal["tuck", "ear", "lip"],
        name: Side,
        sheet: ag.Solid,
        on: ag.Region,
        side: Side,
        length: ag.Scalar,
        reach: ag.Scalar,
        *,
        opening: float = 3.05,
        needs: ag.Dependency | None = None,
        bead: ag.Scalar | None = None,
        lean: ag.Scalar = 0.0,
        ears: Sequence[Fitting] = (),
    ) -> Fitting:
        """Hinge a flap, which is tucked in and grasped at its edge, at a side of the sheet above it."""
        label, deepest, shorter = _TONGUES[kind]
        stem = f"{kind}_{self.names[name]}"
        hold = ag.grasp_on(sheet, approach=-ag.Y, closing=ag.Z, depth=ag.min_(deepest, 0.55 * reach))
        flap = ag.part(sheet, "tuck", self.board.outside, name=f"{stem}{self.mouth}", grasp=hold)
        flap = (flap.install(together(*ears)) if ears else flap).rotate(ag.X, -lean, about=AXIS)
        joint = f"{stem}_hinge{self.mouth}"
        turn = self.board.crease(joint, length=length, reach=reach, opening=opening, needs=needs)
        bead = length - shorter if bead is None else bead
        return self.board.fold(flap, turn, on, side, bead=bead, label=label, hangs=True)

    def _dust_flap(self, side: Side, reach: ag.Scalar) -> Fitting:
        """Make a flap under the lid, behind the tuck and its ears, with or without a lip."""
        front = 3 * self.board.thick + self.gap + 0.003 + 0.07 * self.tuck
        front = front + self.ear + 0.004 if self.ears else front
        on = self.case.shrink(front=front, back=3 * self.board.thick).with_(z=(0.0, self.low))
        wide = on.y.size
        far = wide / 2 - 0.006
        sheet = self.board.sheet(tongue(wide / 2, reach, tip=far))
        beside = ag.push_on(sheet, direction=ag.Z, at=(0.33 * wide, 0.48 * reach, 0.0))  # the layer below
        stem = f"flap_{self.names[side]}"
        flap = ag.part(sheet, "flap_minor", self.board.outside, name=f"{stem}{self.mouth}", push=beside)
        if self.lips:
            deep, end = 0.3 * reach, ag.Region((-far, far), (0.0, reach), (0.0, 0.0))
            bend = self.board.sheet(tongue(far - 0.001, deep, shoulder=0.4 * deep, tip=far - 0.4 * deep))
            flap = flap.install(self._tongue("lip", side, bend, end, "back", 2 * far, deep, opening=1.5))
        turn = self.board.crease(
            f"{stem}_hinge{self.mouth}",
            length=wide,
            reach=reach,
            opening=ag.min_(self.board.swing, math.pi + 0.9 * self.low / reach),
            needs=(self.turn > _RISEN).until(_HANGING),
        )
        return self.board.fold(flap, turn, on, side, bead=wide)
