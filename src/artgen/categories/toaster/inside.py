"""The inside of a toaster: chamber, carriages and crumb tray."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen.categories.toaster.plan import Plan

GAP = 0.006
"""Half of the gap in the front wall for a carriage [m]."""

_MICA = 0.0085  # distance from the side of a slot to its sheet of mica [m]
_WALL = 0.0015  # thickness of the walls [m]
_GUIDE = 0.0009  # radius of the guide wires [m]
# height of the lower end of the chamber above the floor of the sleeve, over the crumb tray [m]
_CHAMBER_LOW = 0.014
_RIBBONS = 9


def _mica() -> ag.Material:
    """Return the material of the sheets for the heating wires: pressed mica with air gaps."""
    return ag.material("mdf").with_(
        name="mica", base_color=(0.36, 0.30, 0.21), specular_roughness=0.4, density=500.0, texture=""
    )


def _heating_wire() -> ag.Material:
    """Return the material of cold heating ribbons, oxidized by use."""
    return ag.material("steel").with_(
        name="heating_wire", base_color=(0.20, 0.11, 0.08), specular_roughness=0.45, texture=""
    )


def chamber(plan: Plan) -> ag.Body:
    """Make the chamber around the slots inside, which is welded to the shell."""
    begin, end = plan.chamber
    middle, long = 0.5 * (begin + end), end - begin
    low, high = plan.floor + _CHAMBER_LOW, plan.top - 0.002  # overlap with the sheet of the top
    tall, level = high - low, 0.5 * (low + high)
    sides = [(x, side) for x in plan.middles for side in (-1, 1)]

    outer = ag.box(0.001, long + 0.002, tall)
    inner = ag.box(plan.bridge - 2 * _MICA + 0.001, long + 0.002, tall)  # sheets of two slots, back to back
    edge = plan.span / 2 + _MICA
    between = [0.5 * (left + right) for left, right in pairwise(plan.middles)]
    sheets = [outer.at(side * edge, middle, level) for side in (-1, 1)]
    sheets += [inner.at(x, middle, level) for x in between]
    ribbon = ag.box(0.0006, long - 0.016, 0.0024).at(0.0, middle, low + 0.012)
    ribbons = ag.array(
        ribbon, at=ag.row((0.0, 0.0, 0.0), (0.0, 0.0, (tall - 0.030) / (_RIBBONS - 1)), _RIBBONS)
    )
    places = [(x + side * (plan.slot_width / 2 + _MICA - 0.0007), 0.0, 0.0) for x, side in sides]
    steel = ag.material("stainless")
    liner = ag.box(plan.width - 0.044, plan.length - plan.cap - 0.018, 0.0006).at(
        0.0, 0.0, plan.floor + 0.0001
    )
    return ag.weld(
        ag.part(_walls(plan, level, tall), "chamber", steel.with_(name="chamber_steel", density=3500.0)),
        ag.part(ag.union(*sheets), "heating_element", _mica()),
        ag.detail(ag.array(ribbons, at=places), "heating_element", _heating_wire()),
        *_guides(plan, level, tall, steel),
        ag.detail(liner, "chamber", steel.with_(name="liner", base_color=(0.33, 0.33, 0.33))),
    )


def _walls(plan: Plan, level: ag.Float, tall: ag.Float) -> ag.Solid:
    """Make the wall at the back, and the wall in front of the bay with a gap per slot for the carriages."""
    begin, end = plan.chamber
    half = plan.span / 2 + _MICA + 0.0006  # within the bevels of a classic body
    back = ag.box(2 * half, _WALL, tall).at(0.0, end + _WALL / 2, level)
    edges = [-half, *(x + side * GAP for x in plan.middles for side in (-1, 1)), half]
    boards = [
        ag.Region((left, right), (begin - _WALL, begin), (level - tall / 2, level + tall / 2)).box()
        for left, right in zip(edges[::2], edges[1::2], strict=True)
    ]
    return ag.union(back, *boards)


def _guides(plan: Plan, level: ag.Float, tall: ag.Float, steel: ag.Material) -> tuple[ag.Body, ag.Body]:
    """Make the guides at both sides of all slots: a rod along each, and vertical wires on it, visual only."""
    begin, end = plan.chamber
    count = 8 if plan.long else 5
    first, last = begin + 0.008, end - 0.008
    wire = ag.cylinder(_GUIDE, tall - 0.004).at(0.0, first, level + 0.002)
    wires = ag.array(wire, at=ag.row((0.0, 0.0, 0.0), (0.0, (last - first) / (count - 1), 0.0), count))
    low = level - 0.1 * tall
    rod = ag.cylinder_between((0.0, begin - 0.001, low), (0.0, end + 0.001, low), _GUIDE)
    at = [(x + side * (plan.slot_width / 2 + _GUIDE), 0.0, 0.0) for x in plan.middles for side in (-1, 1)]
    return ag.part(ag.array(rod, at=at), "guide_wire", steel), ag.detail(
        ag.array(wires, at=at), "guide_wire", steel
    )


LeverStyle = Literal["tab", "bar", "ball", "tee", "paddle"]
"""A flat tab, a round crossbar, a ball, a square bar on a neck, or a wide paddle."""

ARM = (0.003, 0.010)
"""Width and height of the arm between a lever and its carriage [m]."""

_PLAY = (0.0011, 0.0016)  # gaps between the arm and its slit, at the sides and at the ends [m]
_OUT = 0.0095  # distance from the panel to a lever, clear of the buttons [m]
_PRONGS = 0.016  # width of the prongs under the bread [m]
_STEEL = 0.0030  # thickness of the bars of a carriage [m]
_LOW = 0.0185  # height of a carriage above the floor of the sleeve, over the crumb tray [m]
_ENDS = 0.004  # distance from a carriage to the ends of its slot [m]


def slit(travel: ag.Scalar) -> ag.Profile:
    """Return the outline of the slit in the panel, about the arm at rest."""
    wide, tall = ARM[0] + 2 * _PLAY[0], travel + ARM[1] + 2 * _PLAY[1]
    return ag.rectangle(wide, tall, radius=0.0012).at(0.0, -0.5 * travel)


def lever_slide(name: str, *, travel: ag.Scalar, force: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
    """Make the joint of a lever; positive moves it down, and the spring returns it.

    The spring of a toaster lifts the carriage with bread (about 0.15 kg), and needs 10-25 N at the bottom.
    """
    preload = 0.42 * force  # 4-10 N, more than the weight of 1-3 N
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        name,
        axis=-ag.Z,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        damping=damping,
        friction=0.4,  # friction of the carriage on its guide rod
        armature=0.02,  # inertia of the spring
        effort=45.0,
    )


def lever(
    style: LeverStyle, *, finish: ag.Material, accent: ag.Material, slim: bool, name: str = "lever"
) -> ag.Body:
    """Make the grip that a hand presses down, about the arm, in front of the panel."""
    bodies: list[ag.Body] = []
    share = 0.62 if slim else 1.0
    match style:
        case "tab":
            held = ag.box(0.030 * (0.8 if slim else 1.0), 0.021, 0.0085, bevel=0.003)
            rest = [held.at(0.0, -_OUT - 0.0105, 0.0)]
            bodies += [_inlay(0.012, -_OUT - 0.021, 0.0024, accent)]
        case "bar":
            held = ag.cylinder(0.0068, 0.050 * share, axis=ag.X, bevel=0.0018)
            rest = [held.at(0.0, -_OUT - 0.0128, 0.0), _neck(0.010)]
            cuff = ag.cylinder(0.0071, 0.0022, axis=ag.X, bevel=0.0004)
            ends = [(side * (0.019 * share), -_OUT - 0.0128, 0.0) for side in (-1, 1)]
            bodies += [ag.detail(ag.array(cuff, at=ends), "lever", accent)]
        case "ball":
            held = ag.sphere(0.0118)
            rest = [held.at(0.0, -_OUT - 0.0135, 0.0), _neck(0.008)]
        case "tee":
            held = ag.box(0.048 * share, 0.0115, 0.0125, bevel=0.0028)
            rest = [held.at(0.0, -_OUT - 0.0155, 0.0), _neck(0.015)]
            bodies += [_inlay(0.030 * share, -_OUT - 0.02125, 0.0022, accent)]
        case "paddle":
            held = ag.box(0.062 * (0.56 if slim else 1.0), 0.0195, 0.0115, bevel=0.0042)
            rest = [held.at(0.0, -_OUT - 0.00975, 0.0)]
            bodies += [_inlay(0.026, -_OUT - 0.0195, 0.0018, accent)]
    hold: ag.Frame = ag.grasp_on(rest[0], approach=ag.Y, closing=ag.X)
    press: ag.Frame = ag.push_on(rest[0], direction=-ag.Z)
    parts = [ag.part(rest[0], "lever", finish, name=name, grasp=hold, push=press)]
    return ag.weld(*parts, *(ag.part(each, "lever", accent) for each in rest[1:]), *bodies)


def _neck(length: float) -> ag.Solid:
    """Make the round neck between the slit's plane and a lever."""
    return ag.cylinder(0.0042, length, axis=ag.Y, bevel=0.0008).at(0.0, -_OUT + 0.003 - length / 2, 0.0)


def _inlay(wide: float, face: float, tall: float, accent: ag.Material) -> ag.Body:
    """Make the bright line on the front of a lever."""
    return ag.detail(ag.box(wide, 0.0010, tall, bevel=0.0003).at(0.0, face, 0.0), "lever", accent)


def arm(reach: ag.Scalar) -> ag.Body:
    """Make the arm from a lever through its slit to y = `reach` behind the panel."""
    near = -_OUT - 0.0012  # clear of a finger on the middle of a flat lever
    wide, high = ARM[0] / 2, ARM[1] / 2
    bar = ag.Region((-wide, wide), (near, reach), (-high, high)).box(bevel=0.0008)
    return ag.part(bar, "carriage", ag.material("steel"))


def carriage(
    plan: Plan, middles: Sequence[ag.Float], *, post: ag.Scalar, height: ag.Scalar, travel: ag.Scalar
) -> ag.Body:
    """Make the carriage of one lever at rest, with the slots along y, which is welded to the lever."""
    level = plan.floor + _LOW + _STEEL / 2 + travel
    begin, end = plan.chamber
    front, back = plan.bay, end - _ENDS
    upright = ag.box(0.014, _STEEL, height - level + 0.010).at(post, front, 0.5 * (height + level) + 0.0035)
    left, right = ag.min_(middles[0], post) - 0.004, ag.max_(middles[-1], post) + 0.004
    thin, half = _STEEL / 2 - 0.0003, _STEEL / 2
    cross = ag.Region((left, right), (front - thin, front + thin), (level - 0.0012, level + 0.0062)).box()
    rail = ag.Region((-half, half), (front, back), (level - 0.0015, level + 0.0045)).box()
    count = 8 if plan.long else 5
    first, last = begin + _ENDS + 0.002, back - 0.002
    prong = ag.capsule(0.0012, _PRONGS, axis=ag.X).at(0.0, first, level + 0.0045)
    prongs = ag.array(prong, at=ag.row((0.0, 0.0, 0.0), (0.0, (last - first) / (count - 1), 0.0), count))
    places = [(x, 0.0, 0.0) for x in middles]
    steel = ag.material("steel")
    return ag.weld(
        ag.part(ag.union(upright, cross), "carriage", steel),
        ag.part(ag.array(rail, at=places), "carriage", steel),
        ag.part(ag.array(prongs, at=places), "carriage", steel),
    )


TrayWay = Literal["back", "side"]
"""Direction of the tray: out at the end of the slots, or across them."""

_SHEET = 0.0012  # thickness of the tray [m]
_RIM = 0.0075  # height of the rim of the tray [m]
_LIFT = 0.0012  # height of the tray above the floor of the sleeve [m]
_TRAY_PLAY = 0.0014  # gap around the tray in its opening [m]
_FACE = 0.003  # thickness of the face of the tray [m]
_TAB = (0.032, 0.024, 0.0046)  # width, length and thickness of the tab [m]


class Tray:
    """A crumb tray in the frame of its opening: it slides out along +y, before its rotation into place."""

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
            self._middle = -0.5 * (begin + end)  # rotated by 90 degrees: -y becomes x
            self._deep = plan.width / 2 + plan.span / 2 + 0.004
        self._low = plan.floor + _LIFT

    @property
    def direction(self) -> ag.Vector:
        """Direction in which the tray slides out."""
        return ag.vector(0.0, 1.0, 0.0) if self.way == "back" else ag.vector(1.0, 0.0, 0.0)

    def _turned(self, solid: ag.Solid) -> ag.Solid:
        return solid if self.way == "back" else solid.rotate((0.0, 0.0, 1.0), -1.5707963267948966)

    def opening(self) -> ag.Solid:
        """Return the cutter for the tray's opening."""
        low, high = self._plan.floor + 0.0002, self._low + _RIM + _TRAY_PLAY  # clear of the bottom
        hole = ag.box(self._wide + 2 * _TRAY_PLAY, 0.04, high - low)
        return self._turned(hole.at(self._middle, self._out, 0.5 * (low + high)))

    def body(self, finish: ag.Material) -> ag.Body:
        """Make the tray with its face and tab; its face has the finish."""
        deep = self._deep
        y, x = self._out - deep / 2, self._middle
        half, high = self._wide / 2, self._low + _RIM / 2
        # sheets end inside each other, so that no two faces are coplanar
        floor = ag.box(self._wide - _SHEET, deep - _SHEET, _SHEET).at(x, y, self._low + 0.7 * _SHEET)
        rims = [ag.box(_SHEET, deep, _RIM).at(x + side * (half - _SHEET / 2), y, high) for side in (-1, 1)]
        rear = ag.box(self._wide - _SHEET, _SHEET, _RIM - 0.0006)
        rims.append(rear.at(x, self._out - deep + 0.6 * _SHEET, high))
        at = self._out + 0.0010 + _FACE / 2
        bottom = self._plan.foot + 0.0005
        top = self._low + _RIM + 0.005
        face = ag.box(self._wide + 0.014, _FACE, top - bottom, bevel=0.0012).at(x, at, 0.5 * (bottom + top))
        # a web connects the face to the tray, through the opening
        web = ag.box(self._wide - 0.004, 0.004, _RIM - 0.001).at(x, self._out, high)
        wide, long, thick = _TAB
        level = 0.5 * (bottom + top)
        tab = ag.box(wide, long, thick, bevel=0.0018).at(x, at + long / 2, level)
        rib = ag.box(wide - 0.006, 0.0035, thick + 0.0035, bevel=0.0014).at(
            x, at + long - 0.0035, level + 0.001
        )
        point = self._turned(ag.box(0.001, 0.001, 0.001).at(x, at + long - 0.0062, level)).anchor()
        out = self.direction
        # a hand comes at 45 degrees from above, so that it stays above the counter
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
