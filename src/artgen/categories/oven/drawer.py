"""The drawer under the oven of a range: for pans, on runners, with a grip let into its front."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.oven.body import FOOT, LOW
from artgen.categories.oven.space import LAP, UNDER, Space
from artgen.categories.shared.appliances.finish import filled
from artgen.categories.shared.hardware.bar_handles import Grip, boards_around, recessed_grip

_FACE = 0.030  # thickness of the front [m]
_POCKET = 0.0275  # depth of the grip [m]
_WIDE = 0.050  # height of the grip: a finger of 9 mm above and below its blade [m]
_SHEET = 0.003  # of the box [m]
_BESIDE = 0.0175  # from the box to the side of the range, for the runner [m]
_PLAY = 0.0016  # between box and runner [m]


@dataclass(frozen=True)
class Drawer:
    """A drawer."""

    space: Space  # the measures of the range
    finish: ag.Material  # of its front
    metal: ag.Material  # of the blade of its grip
    grip: ag.Scalar  # length of the grip [m]
    share: ag.Scalar  # how far it comes out, as a share of its depth
    friction: ag.Scalar  # of its runners [N]

    @cached_property
    def _tall(self) -> ag.Span:
        """The lower and upper edge of the front [m]."""
        return (FOOT + LOW, self.space.under_door)

    @cached_property
    def _box(self) -> tuple[ag.Scalar, ag.Span, ag.Span]:
        """Half the width of the box, and where it is along y and z [m]."""
        space = self.space
        low = self._tall[0]
        # the slab of the cavity's floor, 24 mm thick, is above it
        top = space.floor - 0.024 - 0.012
        return (
            space.half - _BESIDE,
            (space.front + _FACE - LAP, space.rear - 0.10),
            (FOOT + LOW + 0.006, low + 0.62 * (top - low)),
        )

    @cached_property
    def _travel(self) -> ag.Scalar:
        """How far it comes out [m]."""
        _, (y0, y1), _ = self._box
        return self.share * (y1 - y0)

    @cached_property
    def before(self) -> ag.Scalar:
        """How far its front comes before the axis of the door [m]."""
        return self._travel + self.space.hinge[1] - self.space.front

    def body(self) -> ag.Body:
        """Make the drawer: the link `drawer`."""
        space, half = self.space, self.space.half - 0.0015
        low, high = self._tall
        middle = (low + high) / 2.0 + 0.010
        lining = ag.colored("abs", "graphite").with_(name="grip_lining")
        grip: Grip = recessed_grip(
            self.grip,
            finish=self.metal,
            lining=lining,
            width=_WIDE,
            deep=_POCKET,
            level=True,
            name="drawer_grip",
            thin=True,
        ).at(0.0, space.front, middle)
        x, y, z = (-half, half), (space.front, space.front + _FACE), (low, high)
        # it is seen as a moulding with soft edges, over the boards around the grip
        opening = ag.rectangle(self.grip, _WIDE).at(0.0, middle - 0.5 * (low + high))
        outline = ag.rectangle(2.0 * half, high - low) - opening
        at = (0.0, 0.5 * (y[0] + y[1]), 0.5 * (low + high))
        skin = details.relief(outline, at, proud=0.5 * _FACE, sunk=0.5 * _FACE, bevel=0.0022)
        hole = ((-0.5 * self.grip, 0.5 * self.grip), (middle - 0.5 * _WIDE, middle + 0.5 * _WIDE))
        deep = (y[0] + UNDER, y[1] - UNDER)
        across, tall = ((start + UNDER, end - UNDER) for start, end in (x, z))
        front = boards_around(across, tall, hole, deep)
        front.append(
            ag.board(
                (hole[0][0] - LAP, hole[0][1] + LAP),
                (y[0] + _POCKET, y[1] - 2.0 * UNDER),
                (hole[1][0] - LAP, hole[1][1] + LAP),
            )
        )
        steel = ag.colored("powder_coat", "graphite").with_(name="drawer_sheet", density=1900.0)
        filling = filled(self.finish, 300.0, "front")
        *boards, before = self._boards()
        return ag.weld(
            *(ag.part(each, "drawer", filling) for each in front),
            ag.detail(skin, "drawer", self.finish),
            grip.shell,
            *(ag.part(each, "drawer", steel) for each in boards),
            ag.detail(before, "drawer", steel),
        )

    def _boards(self) -> list[ag.Solid]:
        x, (y0, y1), (z0, z1) = self._box
        less = 0.0004
        floor = ag.board((less - x, x - less), (y0, y1 - less), (z0, z0 + _SHEET))
        sides = [
            ag.board(
                (x - _SHEET, x) if way > 0 else (-x, _SHEET - x),
                (y0, y1),
                (z0 + less, z1),
                bevel=0.0008,
            )
            for way in (-1, 1)
        ]
        ends = [
            ag.board((_SHEET - x - less, x - _SHEET + less), y, (z0 + less, z1 - less))
            for y in ((y1 - _SHEET, y1 - less), (y0 + LAP, y0 + _SHEET))
        ]
        return [floor, *sides, *ends]

    def runners(self) -> ag.Body:
        """Make the runners at both sides of the bay, to be welded to the cabinet."""
        space = self.space
        x, (_, end), (z0, z1) = self._box
        z = (z0 + 0.45 * (z1 - z0), z0 + 0.45 * (z1 - z0) + 0.030)
        steel = ag.material("zinc")
        solids = [
            ag.board(
                (x + _PLAY, space.half - 0.0025) if way > 0 else (0.0025 - space.half, -x - _PLAY),
                (space.mouth + 0.004, end - 0.01),
                z,
            )
            for way in (-1, 1)
        ]
        return ag.weld(*(ag.detail(each, "rail", steel) for each in solids))

    def slide(self) -> ag.Joint:
        """Make the joint by which it is drawn out, to the front."""
        return ag.Prismatic(
            "drawer_slide",
            axis=-ag.Y,
            limits=(0.0, self._travel),
            friction=self.friction,
            damping=10.0,
            effort=60.0,
            velocity=1.5,
        )
