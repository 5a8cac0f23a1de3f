"""Closed chains of links with one input: planar linkages such as four-bars and slider-cranks.

A chain is declared on a tree of links: a pin holds a point of two links together. Two joints of the chain are
then determined by its input. They are solved along the motion, from rest, where the chain is closed. The two
ways to assemble such a chain differ in the sign of a determinant, which is 0 at dead points; so the branch is
followed if the sign stays.
"""

import math
from bisect import bisect
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import AssetCoupling, AssetCurve, AssetJoint, AssetLoop, Tree
from artgen.asset.joint import joints_above, positions_of_followers
from artgen.asset.record import significant
from artgen.errors import nearest
from artgen.graph import kernel
from artgen.nodes.handles import Array3
from artgen.nodes.vector import unit

_PARALLEL = 1e-9  # tolerance of directions of axes
_LEAST_SINE = 0.02  # sine of the angle between the motions of the pin by both joints, at least (1.1 degrees)
_PATH = 0.02  # largest steps along which the branch is followed, as a share of a radian
_STEPS = 64  # least number of these steps
_CLOSED = 1e-12  # largest gap of a closed chain, as a share of its size
_ITERATIONS = 30
_BISECTIONS = 40
_EXACT = 2.5e-10  # largest error of a curve between its samples [rad or m]
_FEWEST, _MOST = 16, 512  # terms of a series
_LEAST_TERM = 1e-13  # smaller terms at the end of a series are left out [rad or m]
_DIGITS = 12  # of the numbers of a curve
_STILL = 1e-9  # motion below which a joint counts as locked, and curvature below which a law is straight


class _DeadError(Exception):
    """The chain does not close, or is at a dead point."""


@dataclass(frozen=True)
class _Step:
    """A joint of the chain in the plane of its motion, as complex numbers."""

    name: str
    turn: float  # 1 or -1 for a rotation about the direction of the pin or against it, 0 for a slide
    place: complex  # pivot [m], or direction of the slide


class _Chain:
    """A chain of links that a pin closes."""

    def __init__(self, sides: Sequence[Sequence[AssetJoint]], point: Array, axis: Array) -> None:
        first = np.cross(axis, np.eye(3)[int(np.argmin(np.round(np.abs(axis), 6)))])
        first = first / math.sqrt(float((first * first).sum()))
        plane = np.array([first, np.cross(axis, first)])

        def complex_of(vector: Array) -> complex:
            x, y = (plane * vector).sum(axis=1).tolist()
            return complex(x, y)

        self.sides = [[self._step(joint, axis, complex_of) for joint in side] for side in sides]
        self.point = complex_of(point)
        places = [step.place for side in self.sides for step in side if step.turn] + [self.point]
        self.size = max(1e-3, *(abs(a - b) for a in places for b in places))

    @staticmethod
    def _step(joint: AssetJoint, axis: Array, complex_of: Callable[[Array], complex]) -> _Step:
        along = float((joint.axis * axis).sum())
        if joint.kind == "revolute":
            if abs(abs(along) - 1.0) > _PARALLEL:
                raise ValueError(
                    f"joint {joint.name!r} turns about another direction than the pin of the loop; all "
                    "joints of a closed chain turn about parallel axes, or slide across them"
                )
            return _Step(joint.name, math.copysign(1.0, along), complex_of(joint.pivot))
        if abs(along) > _PARALLEL:
            raise ValueError(
                f"joint {joint.name!r} slides along the pin of the loop; joints of a closed chain slide "
                "across it"
            )
        return _Step(joint.name, 0.0, complex_of(joint.axis))

    def gap(self, q: dict[str, float]) -> tuple[complex, dict[str, complex]]:
        """Return the gap at the pin [m], and its speed per speed of each joint."""
        gap, speeds = 0j, {}
        for sign, side in zip((1.0, -1.0), self.sides, strict=True):
            turn, shift = 1 + 0j, 0j
            moved = []
            for step in side:
                before = turn * step.place
                if step.turn:
                    moved.append((step, before + shift))
                    angle = step.turn * q[step.name]
                    turned = turn * complex(math.cos(angle), math.sin(angle))
                    shift += before - turned * step.place
                    turn = turned
                else:
                    moved.append((step, before))
                    shift += before * q[step.name]
            end = turn * self.point + shift
            gap += sign * end
            for step, place in moved:
                speeds[step.name] = sign * (1j * step.turn * (end - place) if step.turn else place)
        return gap, speeds


@dataclass(frozen=True)
class _State:
    """The chain at one position of its input."""

    at: float  # position of the input [rad or m]
    found: tuple[float, float]  # positions of both dependent joints
    slopes: tuple[float, float]  # their speeds per speed of the input
    sense: float  # sine of the angle between the motions of the pin by both joints; its sign is the branch


class _Solver:
    """The motion of a chain along its input."""

    def __init__(self, chain: _Chain, joints: dict[str, AssetJoint], driver: AssetJoint) -> None:
        self.chain, self.joints, self.driver = chain, joints, driver
        names = [step.name for side in chain.sides for step in side]
        led = {name: _law(joints, name) for name in names}
        self.known = {name: law for name, law in led.items() if law.leader in ("", driver.name)}
        self.unknown = [name for name in names if name not in self.known]
        others = {law.leader for name, law in led.items() if name in self.unknown and law.leader != name}
        if others:
            raise ValueError(f"the chain of the loop also moves with {min(others)!r}; it has one input")
        if driver.name not in names and not any(law.leader for law in self.known.values()):
            raise ValueError(
                f"the input {driver.name!r} moves no joint of the chain, which has {', '.join(names)}"
            )
        if len(self.unknown) != 2:
            free = " and ".join(map(repr, self.unknown)) or "none"
            remedy = "close the others by pins that are declared before"
            if len(self.unknown) < 2:
                remedy = "without this pin, let the joint follow another one, as in follows=-1.0 * crank"
            raise ValueError(
                "a pin determines two joints of a closed chain beside its input; "
                f"this one has {free}: {remedy}"
            )
        for name in self.unknown:
            if joints[name].limits is not None:
                raise ValueError(f"joint {name!r} gets its range from the loop; leave its limits out")
        off = [name for name, law in self.known.items() if abs(law.at(0.0)) > _STILL]
        if off:
            raise ValueError(f"joint {off[0]!r} is not at 0 at rest, where the loop is closed")
        self.states: list[_State] = []  # along the branch
        self.places: list[float] = []  # position of the input in each state [rad or m]

    def solved(self, at: float, start: _State | None) -> _State:
        """Return the state at a position of the input, from a state near it."""
        guess = [0.0, 0.0]
        if start is not None:
            guess = [q + slope * (at - start.at) for q, slope in zip(start.found, start.slopes, strict=True)]
        known = {name: law.at(at) for name, law in self.known.items()}
        first, second = self.unknown
        for _ in range(_ITERATIONS):
            gap, speeds = self.chain.gap({**known, first: guess[0], second: guess[1]})
            a, b = speeds[first], speeds[second]
            determinant, size = _cross(a, b), abs(a) * abs(b)
            sense = determinant / size if size else 0.0
            if abs(sense) < _LEAST_SINE or (start is not None and sense * start.sense < 0.0):
                raise _DeadError
            if abs(gap) <= _CLOSED * self.chain.size:
                input_speed = sum((speeds[name] * law.slope(at) for name, law in self.known.items()), 0j)
                slopes = (-_cross(input_speed, b) / determinant, -_cross(a, input_speed) / determinant)
                return _State(at, (guess[0], guess[1]), slopes, sense)
            guess = [guess[0] - _cross(gap, b) / determinant, guess[1] - _cross(a, gap) / determinant]
        raise _DeadError

    def follow(self, low: float, high: float, length: float) -> None:
        """Follow the branch from rest to both ends of the input."""
        rest = self._checked(0.0, None)
        ways = []
        for end in (low, high):
            way = [rest]
            stations = [0.0, min(max(0.0, low), high), end]
            for begin, target in pairwise(stations):
                share = abs(target - begin)
                count = math.ceil(share * max(_STEPS / (high - low), 1.0 / length))
                for number in range(1, count + 1):
                    way.append(self._checked(begin + (target - begin) * number / count, way[-1]))
            ways.append(way)
        states = {state.at: state for way in ways for state in way}
        self.places = sorted(states)
        self.states = [states[at] for at in self.places]

    def _checked(self, at: float, start: _State | None) -> _State:
        try:
            return self.solved(at, start)
        except _DeadError:
            pass
        name, kind = self.driver.name, "rad" if self.driver.kind == "revolute" else "m"
        joints = " and ".join(map(repr, self.unknown))
        if start is None:
            raise ValueError(f"the loop is at a dead point at rest: there, {joints} do not determine the pin")
        good = start
        for _ in range(_BISECTIONS):
            middle = (good.at + at) / 2.0
            try:
                good = self.solved(middle, good)
            except _DeadError:
                at = middle
        raise ValueError(
            f"the loop does not close beyond {name} = {good.at:.4g} {kind}: {joints} come to a dead point, "
            f"where they are in line; give {name!r} limits that end before it, or take another input"
        )

    def near(self, at: float) -> _State:
        """Return the state at a position of the input, from the nearest state on the path."""
        after = bisect(self.places, at)
        near = min(self.states[max(after - 1, 0) : after + 1], key=lambda state: abs(state.at - at))
        return self.solved(at, near)

    def laws(self, low: float, high: float) -> list[AssetCoupling]:
        """Return the laws of both dependent joints, exact to `_EXACT`."""
        low, high = (significant(end, _DIGITS) for end in (low, high))
        count = _FEWEST
        while True:
            angles = math.pi * (np.arange(2 * count + 1) / 2.0) / count  # extremes and, between them, nodes
            states = [self.near((low + high + (high - low) * each) / 2.0) for each in _portable.cos(angles)]
            laws = [self._law(number, (low, high), states[1::2]) for number in (0, 1)]
            at, found = np.array([each.at for each in states]), np.array([each.found for each in states]).T
            errors = [np.abs(law.positions(at) - each).max() for law, each in zip(laws, found, strict=True)]
            if max(errors) <= _EXACT:
                return laws
            count *= 2
            if count > _MOST:
                raise ValueError(
                    f"the loop comes too near to a dead point between {self.driver.name} = {low:.4g} and "
                    f"{high:.4g}; narrow the limits of {self.driver.name!r}"
                )

    def _law(self, number: int, ends: tuple[float, float], nodes: Sequence[_State]) -> AssetCoupling:
        """Return the law of a dependent joint from states at the nodes of a Chebyshev series."""
        name, ratio = self.unknown[number], nodes[0].slopes[number]
        found = [state.found[number] for state in nodes]
        straight = [ratio * state.at - position for state, position in zip(nodes, found, strict=True)]
        if max(found) - min(found) < _STILL:
            raise ValueError(f"joint {name!r} does not move in the loop; leave it out")
        if max(map(abs, straight)) < _STILL and max(abs(s.slopes[number] - ratio) for s in nodes) < _STILL:
            return AssetCoupling(self.driver.name, significant(ratio, _DIGITS))
        angles = math.pi * (np.arange(len(nodes)) + 0.5) / len(nodes)
        waves = _portable.cos(np.arange(len(nodes))[:, None] * angles)
        terms = (2.0 / len(nodes)) * _portable.product(waves, np.array(found))
        terms[0] /= 2.0
        last = int(np.flatnonzero(np.abs(terms) > _LEAST_TERM)[-1])
        kept = tuple(significant(round(term, 15), _DIGITS) for term in terms[: last + 1].tolist())
        return AssetCoupling(self.driver.name, 1.0, 0.0, AssetCurve(ends, kept, self.driver.limits is None))


def _cross(a: complex, b: complex) -> float:
    return a.real * b.imag - a.imag * b.real


def _law(joints: dict[str, AssetJoint], name: str) -> AssetCoupling:
    """Return the law of a joint to the joint at the head of its chain; no leader for a locked one."""
    law, head = AssetCoupling(name, 1.0), joints[name]
    while head.follows is not None:
        law = head.follows.then(law.ratio, law.offset)
        if law.leader not in joints:
            raise ValueError(f"joint {head.name!r} follows {law.leader!r}, which is not attached yet")
        head = joints[law.leader]
    return AssetCoupling("", 0.0, law.at(head.closed)) if head.locked else law


@kernel
def _loop(body: Tree, a: str, b: str, at: Array3, axis: Array3, driver: str) -> Tree:
    joints, links = {joint.name: joint for joint in body.joints()}, [link.name for link in body.links()]
    for name in (a, b):
        if name not in links:
            raise ValueError(f"the loop joins {name!r}, which is no link of this body.{nearest(name, links)}")
    if driver not in joints:
        raise ValueError(f"the input {driver!r} of the loop is not attached yet.{nearest(driver, joints)}")
    lead = joints[driver]
    if lead.follows is not None or lead.locked:
        raise ValueError(f"the input {driver!r} of the loop must move by itself, but it is coupled or locked")
    if lead.limits is None and lead.kind == "prismatic":
        raise ValueError(f"the input {driver!r} of the loop slides without limits; give it limits")
    up, down = (joints_above(joints.values(), name)[::-1] for name in (a, b))
    shared = sum(one is other for one, other in zip(up, down, strict=False))
    chain = _Chain((up[shared:], down[shared:]), at, unit(axis))
    solver = _Solver(chain, joints, lead)
    low, high = lead.limits or (-math.pi, math.pi)
    solver.follow(low, high, _PATH * (1.0 if lead.kind == "revolute" else chain.size))
    laws = dict(zip(solver.unknown, solver.laws(low, high), strict=True))
    positions_of_followers(joints, {name: 0.0 for name, each in joints.items() if each.follows is None})
    made = body.with_joints({name: replace(joints[name], follows=law) for name, law in laws.items()})
    if not any(law.curve for law in laws.values()):
        return made  # plain couplings hold the chain closed
    return replace(made, loops=(*body.loops, AssetLoop((a, b), at, unit(axis), driver)))
