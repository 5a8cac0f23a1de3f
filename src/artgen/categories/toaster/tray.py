"""The crumb tray of a toaster: a sheet with a rim that slides out at the back or at a side, by its tab."""

from typing import Literal

import artgen as ag
from artgen.categories.toaster.plan import Plan

TrayWay = Literal["back", "side"]
"""Whether the tray leaves at the end of the slots, or across them."""

_SHEET = 0.0012  # thickness of the tray [m]
_RIM = 0.0075  # its height [m]
_LIFT = 0.0012  # over the floor of the sleeve [m]
_PLAY = 0.0014  # around it in its opening [m]
_FACE = 0.003  # thickness of its face [m]
_TAB = (0.032, 0.024, 0.0046)  # width, length and thickness of its tab [m]


class Tray:
    """A crumb tray in the frame of its opening: it leaves along +y, and is turned to where it belongs."""

    def __init__(self, plan: Plan, way: TrayWay) -> None:
        begin, end = plan.chamber
        self.way = way
        self._plan = plan
        self._deep: ag.Scalar
        self._wide: ag.Scalar
        self._out: ag.Scalar
        self._middle: ag.Scalar
        if way == "back":
            self._wide, self._out, self._middle = plan.span + 0.006, plan.length / 2, 0.0
            self._deep = plan.length / 2 - begin - 0.004
        else:
            self._wide, self._out = end - begin - 0.008, plan.width / 2
            self._middle = -0.5 * (begin + end)  # turned by a quarter, x is what -y was
            self._deep = plan.width / 2 + plan.span / 2 + 0.004
        self._low = plan.floor + _LIFT

    @property
    def direction(self) -> ag.Vector:
        """The way out."""
        return ag.vector(0.0, 1.0, 0.0) if self.way == "back" else ag.vector(1.0, 0.0, 0.0)

    def _turned(self, solid: ag.Solid) -> ag.Solid:
        return solid if self.way == "back" else solid.rotate((0.0, 0.0, 1.0), -1.5707963267948966)

    def opening(self) -> ag.Solid:
        """Return the tool that cuts the tray's opening."""
        low, high = self._plan.floor + 0.0002, self._low + _RIM + _PLAY  # not into the bottom
        hole = ag.box(self._wide + 2 * _PLAY, 0.04, high - low)
        return self._turned(hole.at(self._middle, self._out, 0.5 * (low + high)))

    def body(self, finish: ag.Material) -> ag.Body:
        """Make the tray with its face and tab; its face is of the finish."""
        deep = self._deep
        y, x = self._out - deep / 2, self._middle
        half, high = self._wide / 2, self._low + _RIM / 2
        # sheets end within each other, so that no two have a face in one plane
        floor = ag.box(self._wide - _SHEET, deep - _SHEET, _SHEET).at(x, y, self._low + 0.7 * _SHEET)
        rims = [ag.box(_SHEET, deep, _RIM).at(x + side * (half - _SHEET / 2), y, high) for side in (-1, 1)]
        rear = ag.box(self._wide - _SHEET, _SHEET, _RIM - 0.0006)
        rims.append(rear.at(x, self._out - deep + 0.6 * _SHEET, high))
        at = self._out + 0.0010 + _FACE / 2
        bottom = self._plan.foot + 0.0005
        top = self._low + _RIM + 0.005
        face = ag.box(self._wide + 0.014, _FACE, top - bottom, bevel=0.0012).at(x, at, 0.5 * (bottom + top))
        # a web joins the face with the tray, through the opening
        web = ag.box(self._wide - 0.004, 0.004, _RIM - 0.001).at(x, self._out, high)
        wide, long, thick = _TAB
        level = 0.5 * (bottom + top)
        tab = ag.box(wide, long, thick, bevel=0.0018).at(x, at + long / 2, level)
        rib = ag.box(wide - 0.006, 0.0035, thick + 0.0035, bevel=0.0014).at(
            x, at + long - 0.0035, level + 0.001
        )
        point = self._turned(ag.box(0.001, 0.001, 0.001).at(x, at + long - 0.0062, level)).anchor()
        out = self.direction
        # a hand comes at 45 degrees from above, so that it stays over the counter
        hold = ag.frame(
            point, approach=-out + ag.vector(0.0, 0.0, -1.0), closing=ag.X if self.way == "back" else ag.Y
        )
        tin = ag.material("stainless").with_(name="tray_tin", density=4000.0)
        return ag.weld(
            ag.part(self._turned(ag.union(floor, *rims)), "crumb_tray", tin, name="crumb_tray"),
            ag.part(self._turned(web), "crumb_tray", finish),
            ag.part(self._turned(face), "crumb_tray", finish),
            ag.part(self._turned(tab), "crumb_tray", finish, grasp=hold, name="crumb_tray"),
            ag.part(self._turned(rib), "crumb_tray", finish),
        )

    def slide(self, friction: ag.Scalar) -> ag.Joint:
        """Make the joint of the tray; positive pulls it out."""
        return ag.Prismatic(
            "crumb_tray_slide",
            axis=self.direction,
            limits=(0.0, 0.8 * self._deep),
            friction=friction,
            damping=2.0,
            effort=20.0,
        )
