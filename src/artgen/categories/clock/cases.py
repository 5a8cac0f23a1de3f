"""Wooden cases of clocks: their boards and moldings, glazed doors on butt hinges, and pendulums.

A case stands on z = 0 with the faces of its doors on y = 0 and its boards behind them. Doors are between the
sides, hinged at the left.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.clock.faces import REACH, Face
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf, hinge_offset
from artgen.nodes.fitting import FIT

Top = Literal["flat", "arch", "gable"]
"""Above the cornice: nothing, an arch, or a gable."""

_BOARD = 0.014  # thickness of sides, top and bottom [m]
_BACK = 0.006  # thickness of the back [m]
_DOOR = 0.015  # thickness of a door [m]
_REVEAL = 0.0016  # gap around a door [m]
_KNUCKLE, _TALL = 0.0030, 0.034  # radius and height of a hinge [m]
_CROWN = 0.030  # height of a cornice [m]
_LEVEL = _DOOR + 0.004 + REACH  # position of a dial along y [m]
_GLASS = ag.material("glass")
_HOLD = feel.Feel(friction=0.04, damping=0.02, armature=1e-4, effort=8.0)


@dataclass(frozen=True)
class Case:
    """Sizes and materials of a wooden clock."""

    wide: ag.Scalar  # over its sides [m]
    high: ag.Scalar  # to the top of its cornice [m]
    deep: ag.Scalar  # [m]
    wood: ag.Material
    metal: ag.Material
    top: Top
    face: Face

    def room(self, low: ag.Scalar, high: ag.Scalar, *, narrower: ag.Scalar = 0.0) -> ag.Region:
        """Return the outside of a box of boards."""
        half = self.wide / 2 - narrower
        return ag.Region((-half, half), (0.0, self.deep), (low, high))

    def inside(self, room: ag.Region) -> ag.Region:
        """Return the inside of a box, from the plane of the dial to the back."""
        return room.shrink(x=_BOARD, top=_BOARD, bottom=_BOARD, back=_BACK, front=_LEVEL)


def small(case: Case, *, hung: bool) -> ag.Body:
    """Make a clock with one door before its dial and its pendulum, for a shelf or for a wall."""
    foot = 0.045 if hung else 0.034
    room = case.room(foot, case.high - _CROWN)
    inner = case.inside(room)
    center = (0.0, _LEVEL, inner.z.high - case.face.radius - 0.012)
    moldings = [*_below(room, case, hung=hung), *_above(room, case)]
    body = ag.weld(*_boards(room, case), *moldings, *_movement(case, center, inner))
    body = case.face.with_hands(body, center)
    hang = center[2] - 0.55 * case.face.radius
    body = body.attach(*_pendulum(case, hang, hang - inner.z.low - 0.012, inner))
    return _with_door(body, case, room, "door")


def longcase(case: Case) -> ag.Body:
    """Make a clock that stands on the floor: a base, a trunk with a pendulum and weights, and a hood."""
    slim = 0.17 * case.wide
    base = case.room(0.070, 0.26 * case.high)
    trunk = case.room(base.z.high + 0.022, case.high - _CROWN - 1.30 * case.wide, narrower=slim)
    hood = case.room(trunk.z.high + 0.022, case.high - _CROWN)
    inner = case.inside(hood)
    center = (0.0, _LEVEL, inner.z.mid)
    shelf = case.room(0.0, 0.0).grow(x=0.012, front=0.012)
    ledges = [
        shelf.with_(z=(room.z.high - FIT.lap, room.z.high + 0.022 + FIT.lap)).box(bevel=0.005)
        for room in (base, trunk)
    ]
    front = base.with_(y=(0.0, 0.012)).shrink(x=_BOARD - 0.001, z=_BOARD - 0.001)
    panel = front.shrink(x=0.045, z=0.045).with_(y=(-0.008, 0.001))
    body = ag.weld(
        *_boards(base, case),
        ag.part([front.box(), *ledges], "case", case.wood),
        ag.detail(panel.box(bevel=0.003), "molding", case.wood),
        *_below(base, case, hung=False, tall=0.070),
        *_boards(trunk, case),
        *_boards(hood, case),
        *_above(hood, case),
        *_movement(case, center, inner),
    )
    body = case.face.with_hands(body, center)
    below = case.inside(trunk)
    body = ag.weld(body, *_weights(case, below))
    body = body.attach(*_pendulum(case, below.z.high - 0.020, 0.80 * below.z.size, below))
    return _with_door(_with_door(body, case, trunk, "trunk_door"), case, hood, "hood_door")


def _boards(room: ag.Region, case: Case) -> list[ag.Body]:
    """Make sides, top, bottom and back of a box that is open in front."""
    level = room.shrink(x=_BOARD - 0.0005)
    boards = [
        room.with_(x=(room.x.low, room.x.low + _BOARD)).box(bevel=0.0012),
        room.with_(x=(room.x.high - _BOARD, room.x.high)).box(bevel=0.0012),
        level.with_(z=(room.z.low, room.z.low + _BOARD)).box(),
        level.with_(z=(room.z.high - _BOARD, room.z.high)).box(),
        level.shrink(z=_BOARD - 0.0005).with_(y=(room.y.high - _BACK, room.y.high - 0.0002)).box(),
    ]
    return [ag.part(boards, "case", case.wood, name="case")]


def _below(room: ag.Region, case: Case, *, hung: bool, tall: float = 0.034) -> list[ag.Body]:
    """Make the plinth of a clock that stands, or the bracket below one on a wall."""
    low = room.z.low
    if hung:
        drops = [
            room.shrink(x=inset, front=inset)
            .with_(z=(low - drop - 0.018, low - drop + 0.0005))
            .box(bevel=0.004)
            for inset, drop in ((0.0, 0.0), (0.022, 0.0175))
        ]
        drops.append(room.shrink(x=0.045, front=0.045).with_(z=(low - 0.045, low - 0.035)).box(bevel=0.003))
        return [ag.part(drops, "molding", case.wood)]
    wide = room.grow(x=0.014, front=0.014)
    slab = wide.with_(z=(low - tall + 0.006, low - 0.010)).box(bevel=0.002)
    cove = wide.shrink(x=0.005, front=0.005).with_(z=(low - 0.0105, low + 0.0005)).box(bevel=0.004)
    x, front, back = wide.x.high - 0.016, wide.y.low + 0.016, wide.y.high - 0.016
    feet = [
        ag.cylinder(0.012, 0.007, bevel=0.002).at(side * x, y, low - tall + 0.0035)
        for side in (-1, 1)
        for y in (front, back)
    ]
    return [ag.part([slab, cove], "molding", case.wood), ag.part(feet, "foot", case.metal)]


def _above(room: ag.Region, case: Case) -> list[ag.Body]:
    """Make the cornice in two steps, with an arch or a gable on it."""
    high = room.z.high
    steps = [
        room.grow(x=out, front=out).with_(z=(high + low - 0.0005, high + end)).box(bevel=0.003)
        for out, low, end in ((0.007, 0.0, 0.014), (0.018, 0.0135, _CROWN))
    ]
    wide, deep = room.x.size + 0.020, 0.022
    if case.top == "arch":
        bow = ag.ellipse(wide / 2, 0.20 * wide) & ag.rectangle(wide, wide).at(0, wide / 2)
        steps.append(
            ag.extrude(bow, deep, axis=ag.Y, bevel=0.002).at(0, deep / 2 - 0.012, high + _CROWN - 0.001)
        )
    elif case.top == "gable":
        bow = ag.polygon(
            [(-wide / 2, 0), (wide / 2, 0), (wide / 2, 0.006), (0, 0.20 * wide), (-wide / 2, 0.006)]
        )
        steps.append(
            ag.extrude(bow, deep, axis=ag.Y, bevel=0.002).at(0, deep / 2 - 0.012, high + _CROWN - 0.001)
        )
    return [ag.part(steps, "molding", case.wood)]


def _movement(case: Case, center: tuple[ag.Scalar, ag.Scalar, ag.Scalar], inner: ag.Region) -> list[ag.Body]:
    """Make the dial with its bezel, and the works that carry it on the back."""
    radius = case.face.radius
    disc = case.face.disc(1.06 * radius)
    ring = ag.tube(1.14 * radius, 1.045 * radius, 0.007, axis=ag.Y, bevel=0.002).at(y=-0.0015)
    high = ag.min_(0.7 * radius, inner.z.high - center[2] - 0.004)
    works = ag.Region(
        (-0.55 * radius, 0.55 * radius), (0.0018, inner.y.high - _LEVEL + 0.001), (-0.45 * radius, high)
    )
    stuff = ag.material("brass").with_(name="brass_works", density=900.0)
    made = [
        disc,
        ag.detail(ring, "dial", case.metal),
        *case.face.printed(),
        ag.part(works.box(), "case", stuff),
    ]
    return [each.at(*center) for each in made]


def _pendulum(case: Case, top: ag.Scalar, reach: ag.Scalar, inner: ag.Region) -> tuple[ag.Body, ag.Joint]:
    """Make a pendulum that hangs from a height, with its joint; its bob ends a reach below."""
    y = _LEVEL + 0.030
    bob = ag.min_(0.17 * inner.x.size, 0.062)
    low = top - reach + bob
    rod = ag.cylinder_between((0, y, top - 0.004), (0, y, low), 0.0025)
    disc = ag.cylinder(bob, 0.010, axis=ag.Y, bevel=0.003).at(0, y, low)
    boss = ag.dome(0.7 * bob, height=0.005, axis=-ag.Y).at(0, y - 0.0045, low)
    nut = ag.cylinder(0.005, 0.006).at(0, y, low - bob - 0.002)
    body = ag.weld(
        ag.part([disc, boss, nut], "bob", casting(case.metal, 0.8), name="pendulum"),
        ag.part(rod, "pendulum", case.metal),
    )
    most = ag.min_(0.5 * (inner.x.high - bob - 0.004) / reach, 0.10)
    swing = ag.Revolute(
        "pendulum_swing", axis=ag.Y, pivot=(0, y, top), limits=(-most, most),
        friction=1e-4, damping=2e-4, effort=0.5, driven="the escapement",
    )  # fmt: skip
    return body, swing


def _weights(case: Case, inner: ag.Region) -> list[ag.Body]:
    """Make two weights on their lines behind the pendulum."""
    y = inner.y.high - 0.030
    x, radius, tall = 0.27 * inner.x.size, 0.022, 0.16
    made = []
    for side, share in ((-1, 0.50), (1, 0.56)):
        low = inner.z.low + share * inner.z.size
        drum = ag.cylinder(radius, tall, bevel=0.003).at(side * x, y, low + tall / 2)
        line = ag.cylinder_between(
            (side * x, y, low + tall - 0.002), (side * x, y, inner.z.high + 0.002), 0.0013
        )
        made += [ag.part(drum, "weight", case.metal), ag.part(line, "line", ag.material("steel"))]
    return made


def _with_door(body: ag.Body, case: Case, room: ag.Region, name: str) -> ag.Body:
    """Add a glazed door to a box, with its knob and hinges."""
    hole = room.shrink(x=_BOARD, z=_BOARD).with_(y=(0.0, _DOOR))
    leaf = hole.shrink(x=_REVEAL, z=_REVEAL)
    rail = 0.10 * room.x.size + 0.004
    pane = leaf.shrink(x=rail, z=rail)
    left, right, below, above = leaf.around(pane, lap=FIT.lap)
    frame = [each.box(bevel=0.0012) for each in (left, right, below, above)]
    glass = pane.grow(x=0.004, z=0.004).with_(y=(0.006, 0.009)).box()
    stem = ag.cylinder(0.0035, 0.010, axis=ag.Y).at(y=-0.0045)
    knob = ag.cylinder(0.0085, 0.014, axis=ag.Y, bevel=0.003).at(y=-0.0155)
    hold = ag.grasp_on(knob, approach=ag.Y, closing=ag.X, depth=0.011)
    ends = (leaf.z.low + 0.16 * leaf.z.size, leaf.z.high - 0.16 * leaf.z.size)
    axis = (leaf.x.low - _REVEAL / 2, -hinge_offset(_KNUCKLE))

    def half(make: Callable[..., ag.Body]) -> ag.Body:
        made = make(
            height=_TALL,
            radius=_KNUCKLE,
            depth=_DOOR - 0.004,
            knuckles=3,
            sheets=False,
            levels=ends,
            finish=case.metal,
        )
        return made.at(*axis)

    door = ag.weld(
        ag.part(frame, "door", case.wood, name=name),
        ag.part(glass, "glass", _GLASS),
        ag.part(
            [stem, knob], "knob", case.metal, name=name.replace("door", "knob"), grasp=hold, grasp_width=0.027
        ).at(right.x.mid, 0, leaf.z.mid),
        half(hinge_leaf),
    )
    body = ag.weld(body, half(hinge_frame))
    turn = ag.Revolute(f"{name}_hinge", axis=-ag.Z, pivot=(*axis, leaf.z.mid), limits=(0, 1.9), feel=_HOLD)
    return body.attach(door, turn)
