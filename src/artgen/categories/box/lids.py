"""Lids hinged at the back: a flap tucks in at the front, ears or side flaps lock it.

When the lid rises, the tuck swings out by its reach squared over twice the depth of the lid. Therefore the
tuck leans inward a little, as does the inner layer of the rolled front wall, which holds its tip.
"""

import math
from dataclasses import dataclass, replace
from typing import Literal

import artgen as ag
from artgen.categories.box.board import LAYER, TOP, Board, Crease, Feel, Mouth, tongue
from artgen.categories.box.bottles import Bottles
from artgen.categories.box.prints import TAPE, pull_tab

Sides = Literal["over", "tucked"]
"""Whether the sides of a lid lie on the walls, or each has a flap that goes between the walls."""

_SLACK = 0.020  # play of the tuck while its lid is closed [rad]
_PLAY = 0.043  # additional angle until the tuck touches the wall [rad]
_TIP = 0.0004  # gap from the tip of an upright tuck to the wall [m]
_BESIDE = 0.0012  # gap from ears and side flaps to the walls [m]
_UPRIGHT = 1.66  # least angle of a lid that leaves the space above the box free [rad]
_AWAY = 2.0  # least angle of a lid whose tuck leaves this space free as well [rad]
_HANGING = 3.40  # least angle of a dust flap that is below the lid that closes over it [rad]
_NO_WINGS = (
    "the side flaps of a lid have no room between its crease and its tuck: raise width or "
    "aspect, ears=False or sides=over"
)


@dataclass(frozen=True)
class Lidded:
    """A box with a lid hinged at its back wall."""

    board: Board  # board of the box
    width: ag.Scalar  # outer width along x [m]
    depth: ag.Scalar  # outer depth along y [m]
    height: ag.Scalar  # height of the closed box [m]
    sides: Sides  # position of the sides of the lid
    ears: bool  # whether the tuck has ears, which go in beside the walls
    dust: ag.Scalar | None  # reach of the dust flaps at the walls under the lid; None for none [m]
    opening: ag.Scalar  # opening angle of the lid [rad]
    lips: bool = False  # whether flaps under the lid end in lips, which are folded down
    # start of the second layer of the walls, which holds the ears; None for the floor [m]
    lined: ag.Scalar | None = None
    grip: float = 0.006  # distance from the tuck to the tab that opens the lid [m]
    mouth: Mouth = TOP  # names of the sides

    @property
    def tuck(self) -> ag.Float:
        """Reach of the tuck [m]."""
        return ag.min_(0.15 * self.depth + 0.005, 0.72 * self.height)

    @property
    def gap(self) -> ag.Float:
        """Gap from the front edge of the lid to the wall, for the outward swing of the tuck [m]."""
        swing = self.tuck / (2.0 * (self.depth - 2.0 * self.board.thick - 0.003))
        return ag.max_(0.0015, 2.0 * _TIP + self.tuck * (swing - _PLAY))

    @property
    def reach(self) -> ag.Scalar:
        """Distance from the crease of the lid to the crease of its tuck [m]."""
        return self.depth - 2.0 * self.board.thick - self.gap

    @property
    def low(self) -> ag.Scalar:
        """Height of the side walls [m]."""
        return self.height if self.sides == "tucked" else self.height - self.board.thick - LAYER

    @property
    def inner(self) -> ag.Scalar:
        """Half of the width between the side walls [m]."""
        return self.width / 2.0 - (2.0 if self.ears else 1.0) * self.board.thick

    @property
    def half(self) -> ag.Scalar:
        """Half of the width of the lid [m]."""
        return self.inner - _BESIDE if self.sides == "tucked" else self.width / 2.0 - 0.0012

    @property
    def hinge(self) -> Crease:
        """Return the crease at the back."""
        return Crease(0.0, self.depth / 2.0, self.height, turn=math.pi)

    def dust_creases(self) -> dict[str, Crease]:
        """Return the creases of the dust flaps, or none."""
        if self.dust is None:
            return {}
        return {
            "left": Crease(-self.width / 2.0, self._dust_middle, self.low, turn=-math.pi / 2.0),
            "right": Crease(self.width / 2.0, self._dust_middle, self.low, turn=math.pi / 2.0),
        }

    @property
    def _dust_ends(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Ends of the dust flaps along y: behind the tuck and its ears, in front of the back wall [m]."""
        front = 3.0 * self.board.thick + self.gap + 0.003 + 0.07 * self.tuck
        if self.ears:
            front = front + self.ear + 0.004
        return front - self.depth / 2.0, self.depth / 2.0 - 3.0 * self.board.thick

    @property
    def _dust_middle(self) -> ag.Scalar:
        start, end = self._dust_ends
        return (start + end) / 2.0

    def creased(self, walls: ag.Solid) -> ag.Solid:
        """Cut the upper edges of walls of full height to the height of the lid."""
        t, lowered = self.board.thick, walls
        if self.sides == "over":
            for side in (-1.0, 1.0):
                low = (side * self.width / 2.0 - 1.6 * t, -self.depth / 2.0 - 0.01, self.low)
                high = (side * self.width / 2.0 + 1.6 * t, self.depth / 2.0 + 0.01, self.height + 0.01)
                lowered = lowered - ag.Region.between(low, high).box().paint(self.board.edge)
        return self.board.creased(lowered, self.hinge, *self.dust_creases().values())

    def rims(self, label: str = "box") -> list[ag.Body]:
        """Make the lip of the front wall, and the second layer of the walls that holds the ears."""
        t, front, half = self.board.thick, -self.depth / 2.0, self.inner - 0.0003
        layer, tip = front + 2.0 * t, self.height - self.tuck
        wedge = ag.polygon(
            [
                (layer - 0.6 * t, self.height - 0.5 * self.tuck),
                (layer, self.height - 0.5 * self.tuck),
                (layer + self.gap - _TIP, tip),
                (layer + self.gap - _TIP, 0.85 * tip),
                (layer - 0.6 * t, 0.85 * tip),
            ]
        )
        bar = ag.Region((-half, half), (front + t - 0.0003, layer), (0.8 * tip, self.height - 0.0002)).box(
            bevel=0.0008
        )
        made = [bar | ag.extrude(wedge, 2.0 * half - 0.001, axis=ag.X)]
        if self.ears:
            top = self.low - 0.0002 if self.dust is None else self.low - t - LAYER
            start = t - 0.0002 if self.lined is None else self.lined
            for side in (-1.0, 1.0):
                x = _span(side, self.inner, self.inner + t + 0.0003)
                y = (front + t + 0.0006, self.depth / 2.0 - t - 0.0006)
                made.append(ag.Region(x, y, (start, top)).box(bevel=0.0008))
        return [ag.part(each, label, self.board.outside) for each in made]

    def attached(
        self,
        body: ag.Body,
        feel: Feel,
        *,
        printed: list[ag.Body],
        swing: ag.Scalar,
        bottles: Bottles | None = None,
    ) -> ag.Body:
        """Join the lid with all its flaps."""
        weight = 9.81 * 1.2 * self.board.outside.density * self.board.thick * 2.0 * self.half * self.reach
        # the damping of a fresh crease takes energy out of a lid, which otherwise slams shut
        mass, length = weight / 9.81, 2.0 * self.half
        calm = 2.0 * ag.sqrt(feel.stiffness * length * 0.45 * mass * self.reach**2) / length
        turn = self.hinge.joint(
            self.mouth.hinge("lid"),
            feel=replace(feel, damping=ag.max_(feel.damping, calm)),
            length=2.0 * self.half,
            reach=self.reach,
            opening=self.opening,
            holding=weight * 0.62 * self.reach,  # an open lid with its flaps out stays up
        )
        body = ag.weld(body, self.hinge.bead(2.0 * self.half, "box", self.board.outside))
        resting = Feel(0.0, 0.0, feel.friction, feel.damping)
        body = body.attach(self.hinge.place(self._lid(resting, turn, printed)), turn)
        if bottles is not None:
            body = bottles.under(turn, _AWAY, body)
        if self.dust is None:
            return body
        opening = ag.min_(swing, math.pi + 0.9 * self.low / self.dust)
        start, end = self._dust_ends
        for side, crease in self.dust_creases().items():
            hinge = crease.joint(
                self.mouth.hinge("flap", side),
                feel=resting,
                length=end - start,
                reach=self.dust,
                opening=opening,
                needs=(turn > _UPRIGHT).until(_HANGING),
            )
            body = ag.weld(body, crease.bead(end - start, "box", self.board.outside))
            body = body.attach(crease.place(self._dust_flap(side, end - start, self.dust, resting)), hinge)
        return body

    def _dust_flap(self, side: str, wide: ag.Scalar, reach: ag.Scalar, feel: Feel) -> ag.Body:
        """Make a flap under the lid, with or without a lip, in its own frame."""
        far = wide / 2.0 - 0.006
        sheet = self.board.sheet(
            ag.polygon([(-wide / 2.0, 0.0), (wide / 2.0, 0.0), (far, reach), (-far, reach)])
        )
        below = ag.push_on(
            sheet, direction=ag.Z, at=(0.33 * wide, 0.48 * reach, 0.0)
        )  # beside the layer below
        name = self.mouth.link("flap", side)
        if not self.lips:
            return ag.part(sheet, "flap_minor", self.board.outside, name=name, push=below)
        crease, deep = Crease(0.0, reach, folded=True), 0.3 * reach
        flap = ag.part(
            self.board.creased(sheet, crease), "flap_minor", self.board.outside, name=name, push=below
        )
        lip = self.board.sheet(tongue(far - 0.001, deep, shoulder=0.4 * deep, tip=far - 0.4 * deep))
        hold = ag.grasp_on(lip, approach=(0.0, -1.0, 0.0), closing=ag.Z, depth=ag.min_(0.014, 0.55 * deep))
        joint = crease.joint(
            self.mouth.hinge("lip", side), feel=feel, length=2.0 * far, reach=deep, opening=1.5
        )
        body = ag.part(lip, "tuck", self.board.outside, name=self.mouth.link("lip", side), grasp=hold)
        flap = ag.weld(flap, crease.bead(2.0 * far - 0.004, "flap_minor", self.board.outside))
        return flap.attach(crease.place(body), joint)

    def _lid(self, feel: Feel, turn: ag.Joint, printed: list[ag.Body]) -> ag.Body:
        """Make the lid with its flaps, in its own frame."""
        front = Crease(0.0, self.reach, folded=True, lean=_PLAY - _TIP / self.tuck + _SLACK)
        sides = self._side_creases()
        sheet = self.board.sheet(ag.rectangle(2.0 * self.half, self.reach).at(0.0, self.reach / 2.0))
        if sides:  # side flaps narrow to a tip
            long = self._wing_end - self._wing_start
            sheet = sheet.require(long >= 0.6 * self._wing_reach + 0.006, _NO_WINGS)
        sheet = self.board.creased(sheet, front, *sides.values())
        tab, across = pull_tab(), ag.Y
        if self._sealed:  # near the floor a hand has space beside the tab
            tab, across = tab.rotate(ag.Z, math.pi / 2.0), ag.X
        tab = tab.at(0.0, self.reach - self.grip, 0.0)
        hold = ag.grasp_on(tab, approach=-ag.Z, closing=across, depth=0.016)
        lid = ag.weld(
            ag.part(sheet, "lid", self.board.outside, name=self.mouth.link("lid")),
            ag.part(tab, "tape", TAPE, name=self.mouth.link("tab"), grasp=hold),
            *self._seal(),
            front.bead(2.0 * self.half - 0.004, "lid", self.board.outside),
            *(
                each.bead(self._wing_end - self._wing_start, "lid", self.board.outside)
                for each in sides.values()
            ),
            *printed,
        )
        free = (turn > self._clear).beyond(_SLACK)
        width = 2.0 * (self.inner - _BESIDE)
        lid = lid.attach(
            front.place(self._tuck(feel, turn, width)),
            front.joint(
                self.mouth.hinge("tuck", "front"),
                feel=feel,
                length=width,
                reach=self.tuck,
                opening=3.05,
                needs=free,
            ),
        )
        for side, crease in sides.items():
            lid = lid.attach(crease.place(self._wing(side)), self._wing_joint(side, crease, feel, turn))
        return lid

    @property
    def _sealed(self) -> bool:
        """Whether tape goes over the edge of the lid, so that the tab is elsewhere."""
        return self.grip > 0.01

    def _seal(self) -> list[ag.Body]:
        """Make the slit tape at the edge of the lid, or nothing."""
        if not self._sealed:
            return []
        low, high = (-0.024, self.reach - self.grip - 0.012, -0.0001), (0.024, self.reach - 0.0005, 0.00012)
        return [ag.detail(ag.Region.between(low, high).box(), "tape", TAPE)]

    @property
    def ear(self) -> ag.Float:
        """Reach of an ear backward from the tuck [m]."""
        return ag.min_(0.056, ag.max_(0.24 * self.reach, 0.034))

    @property
    def _clear(self) -> ag.Scalar:
        """Smallest angle of the lid at which the tuck clears the box in every position [rad]."""
        far = ag.sqrt(self.tuck**2 + self.ear**2) if self.ears else self.tuck
        return 1.13 * (far + 0.008) / self.reach

    def _tuck(self, feel: Feel, turn: ag.Joint, width: ag.Scalar) -> ag.Body:
        """Make the tuck with its ears, in its own frame."""
        half, cut = width / 2.0, 0.30 * self.tuck
        outline = tongue(half, self.tuck, shoulder=self.tuck - cut, tip=half - cut)
        creases: dict[str, Crease] = {}
        start, long = self.board.thick + 0.004, self.tuck - cut - self.board.thick - 0.008
        if self.ears:
            outline = ag.rectangle(width, self.tuck).at(0.0, self.tuck / 2.0)
            long = self.tuck - start - 0.003
            middle = start + long / 2.0
            creases = {
                "left": Crease(-half, middle, turn=math.pi / 2.0, folded=True),
                "right": Crease(half, middle, turn=-math.pi / 2.0, folded=True),
            }
        sheet = self.board.creased(self.board.sheet(outline, relief=0.0005), *creases.values())
        edge = ag.grasp_on(
            sheet,
            approach=(0.0, -1.0, 0.0),
            closing=ag.Z,
            at=(0.0, self.tuck / 2.0, 0.0),
            depth=ag.min_(0.016, 0.55 * self.tuck),
        )
        tuck = ag.part(sheet, "tuck", self.board.outside, name=self.mouth.link("tuck", "front"), grasp=edge)
        for side, crease in creases.items():
            bend = tongue(long / 2.0, self.ear, shoulder=0.6 * self.ear, tip=long / 4.0)
            ear = self.board.sheet(bend)
            grip = ag.grasp_on(ear, approach=(0.0, -1.0, 0.0), closing=ag.Z, depth=0.014)
            joint = crease.joint(
                self.mouth.hinge("ear", side),
                feel=feel,
                length=long,
                reach=self.ear,
                opening=1.5,
                needs=(turn > self._ears_clear).beyond(0.35 * _BESIDE / self.ear),
            )
            body = ag.part(ear, "tuck", self.board.outside, name=self.mouth.link("ear", side), grasp=grip)
            tuck = ag.weld(tuck, crease.bead(long - 0.002, "tuck", self.board.outside))
            tuck = tuck.attach(crease.place(body), joint)
        return tuck

    @property
    def _ears_clear(self) -> ag.Scalar:
        """Smallest angle of the lid at which the ears are above the walls [rad]."""
        return ag.max_(ag.atan2(self.tuck + 0.012, self.reach - self.ear), self._clear)

    def _side_creases(self) -> dict[str, Crease]:
        """Return the creases of the side flaps of the lid, or none."""
        if self.sides == "over":
            return {}
        middle = (self._wing_start + self._wing_end) / 2.0
        return {
            "left": Crease(-self.half, middle, turn=math.pi / 2.0, folded=True),
            "right": Crease(self.half, middle, turn=-math.pi / 2.0, folded=True),
        }

    @property
    def _wing_start(self) -> ag.Scalar:
        """Distance from the crease of the lid to the start of the side flaps [m]."""
        return 0.30 * self.reach

    @property
    def _wing_end(self) -> ag.Scalar:
        """Distance to the end of the side flaps, behind the tuck and its ears [m]."""
        ears = self.ear + 0.004 if self.ears else 0.0
        return self.reach - ears - 0.014 - 0.05 * self.tuck - self.board.thick

    @property
    def _wing_reach(self) -> ag.Scalar:
        """Reach of the side flaps downward [m]."""
        return 0.8 * self.tuck

    def _wing(self, side: str) -> ag.Body:
        """Make a side flap of the lid, in its own frame."""
        half, deep = (self._wing_end - self._wing_start) / 2.0, self._wing_reach
        outline = tongue(half, deep, shoulder=0.5 * deep, tip=half - 0.3 * deep)
        sheet = self.board.sheet(outline)
        grip = ag.grasp_on(sheet, approach=(0.0, -1.0, 0.0), closing=ag.Z, depth=ag.min_(0.016, 0.55 * deep))
        return ag.part(sheet, "tuck", self.board.outside, name=self.mouth.link("tuck", side), grasp=grip)

    def _wing_joint(self, side: str, crease: Crease, feel: Feel, turn: ag.Joint) -> ag.Joint:
        clear = ag.atan2(self._wing_reach + 0.010, self._wing_start)
        return crease.joint(
            self.mouth.hinge("tuck", side),
            feel=feel,
            length=self._wing_end - self._wing_start,
            reach=self._wing_reach,
            opening=2.6,
            needs=(turn > clear).beyond(0.4 * _BESIDE / self._wing_reach),
        )


def _span(side: float, near: ag.Scalar, far: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return a span at one side of the middle, in ascending order."""
    return (near, far) if side > 0.0 else (-far, -near)
