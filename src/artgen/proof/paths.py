"""Joint paths: the joints between pairs of links, and the space of their positions.

Coupled joints are replaced by their leaders; locked joints have one position. Dependencies cut the joint
space of a pair into boxes. Dependencies that would cut it into very many boxes are left out, which can only
enlarge the space.
"""

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from artgen._arrays import Array, cached, cached_property
from artgen.asset import Asset, AssetJoint
from artgen.asset.coupling import AssetCoupling, AssetLoop
from artgen.asset.joint import AllowedContact, AssetCondition, joints_above
from artgen.errors import AssetError

Interval = tuple[float, float]
Box = Mapping[str, Interval]
# a box of the joint space, and the contacts that are allowed everywhere in it
_Part = tuple[Box, tuple[AllowedContact, ...]]

FULL_TURN = (-math.pi, math.pi)  # range in which an unlimited rotation is proven [rad]
FULL_SLIDE = (-1000.0, 1000.0)  # the same for an unlimited slide, as its limits in URDF [m]
_CLOSED = 1e-9  # tolerance of a closed position [rad or m]
_MOST_BOXES = 128  # dependencies that would cut a space into more boxes are left out
_GAPING = 2e-9  # gap at the pin of a closed chain that the margin of the proof, 10 nm, contains [m]
_GAPS = 257  # positions at which it is measured
_ROUNDING = 1e-12  # tolerance of a box that was cut at a threshold [rad or m]


@dataclass(frozen=True, eq=False)
class JointPath:
    """The joints between two links."""

    links: tuple[str, str]  # names of the links, A and B
    steps: tuple[AssetJoint, ...]  # the joints on the path from A to B
    signs: tuple[int, ...]  # 1 for a joint that leads away from the root, -1 for one that leads towards it
    # position of each joint as a function of a variable, its leader; no leader for a joint that never moves
    followers: tuple[AssetCoupling, ...]
    variables: tuple[str, ...]  # names of the free joints that move them
    _cut: Callable[[], Iterable[_Part]]  # makes the parts of the joint space

    @cached_property
    def _parts(self) -> tuple[_Part, ...]:
        return tuple(self._cut())

    @cached_property
    def boxes(self) -> tuple[Array, ...]:
        """The joint space: lowest and highest position of each variable, each shape (v, 2) [rad or m]."""
        found = ([box[name] for name in self.variables] for box, _ in self._parts)
        return tuple(np.array(ends).reshape(-1, 2) for ends in found)

    @cached_property
    def allowed(self) -> tuple[tuple[AllowedContact, ...], ...]:
        """The contacts that are allowed everywhere in each box."""
        return tuple(contacts for _, contacts in self._parts)

    @cached_property
    def key(self) -> tuple[Any, ...]:
        """The input of a proof without the pieces: equal for paths with the same motions and contacts."""
        motions = [(each.kind, each.axis.tobytes(), each.pivot.tobytes()) for each in self.steps]
        boxes = [box.tobytes() for box in self.boxes]
        return (self.links, motions, self.signs, self.followers, self.variables, boxes, self.allowed)


class Space:
    """The joint space of an asset, for all its pairs of links."""

    def __init__(self, asset: Asset) -> None:
        self.asset = asset
        self._chains = {link.name: joints_above(asset.joints, link.name)[::-1] for link in asset.links}
        self.followers: dict[str, AssetCoupling] = {}
        self.ranges: dict[str, Interval] = {}
        self._boxes: dict[tuple[str, ...], list[Box]] = {}  # by variables, which many pairs share
        for joint in asset.joints:
            self._resolve(joint)

    def joint_paths(self, only: Callable[[JointPath], bool] | None = None) -> list[JointPath]:
        """Return the joint path between each pair of links that can move against each other.

        Links that fill empty slots have none: their colliders lie inside other links, see `outside`.

        Args:
            only: Selects joint paths; by default all.
        """
        chosen = self._joint_paths if only is None else filter(only, self._joint_paths)
        return [joint_path for joint_path in chosen if joint_path.boxes]

    @cached_property
    def _joint_paths(self) -> tuple[JointPath, ...]:
        names = [link.name for link in self.asset.links if not link.absent]
        found = (self.joint_path(a, b) for a, b in itertools.combinations(names, 2))
        return tuple(joint_path for joint_path in found if joint_path.variables)

    def check(self) -> None:
        """Raise AssetError for dependencies that cannot be satisfied.

        Raises:
            AssetError: A joint could never move, or no position of all joints is allowed.
        """
        for joint in self.asset.joints:
            if joint.needs is None or any(each is not None for each in self._terms(joint.needs.condition)):
                continue
            spans = []
            for name in joint.needs.condition.joints():
                follower = self.followers[name]
                low, high = sorted(map(follower.at, self.ranges.get(follower.leader, (0.0, 0.0))))
                spans.append(f"{name} ranges from {low:.6g} to {high:.6g}")
            raise AssetError(
                f"joint {joint.name!r} needs {joint.needs.condition}, but {', '.join(spans)}: it could never "
                "move; reverse the comparison or correct its value",
                joint=joint.name,
            )
        if not self.boxes(list(self.ranges)):
            raise AssetError(
                f"the dependencies of asset {self.asset.name!r} contradict each other: they forbid every "
                "position of its joints; let the joints that need others reach 0, or drop a condition"
            )

    def joint_path(self, a: str, b: str) -> JointPath:
        """Return the joint path from one link to another."""
        up, down = self._chains[a], self._chains[b]
        shared = sum(one is other for one, other in zip(up, down, strict=False))
        pins = (loop for loop in self.asset.loops if {*loop.links} == {a, b})
        for pin in pins:
            if (law := self._law_at(pin, up[shared:], down[shared:])) is not None:
                last = (*up[shared:], *down[shared:])[-1]  # a joint of the chain, moved to the pin
                step = replace(last, kind="revolute", axis=pin.axis, pivot=pin.point)
                cut = partial(self._parts, a, b, (pin.joint,))
                return JointPath((a, b), (step,), (1,), (law,), (pin.joint,), cut)
        steps = (*reversed(up[shared:]), *down[shared:])
        signs = (-1,) * (len(up) - shared) + (1,) * (len(down) - shared)
        followers = tuple(self.followers[joint.name] for joint in steps)
        variables = tuple(dict.fromkeys(each.leader for each in followers if each.leader))
        return JointPath((a, b), steps, signs, followers, variables, partial(self._parts, a, b, variables))

    def _law_at(
        self, pin: AssetLoop, up: Sequence[AssetJoint], down: Sequence[AssetJoint]
    ) -> AssetCoupling | None:
        """Return the angle of the second link to the first at a pin; None where the pin gapes."""
        turns = [(-1.0, each) for each in up] + [(1.0, each) for each in down]
        laws = [
            (side * float(np.sign((joint.axis * pin.axis).sum())), self.followers[joint.name])
            for side, joint in turns
            if joint.kind == "revolute"
        ]
        curves = [law.curve for _, law in laws if law.curve is not None]
        if not curves or any(law.leader not in ("", pin.joint) for _, law in laws):
            return None
        low, high = curves[0].range
        if any(curve.range != (low, high) for curve in curves) or self._widest_gap(pin) > _GAPING:
            return None
        terms = np.zeros(max(2, *(len(curve.terms) for curve in curves)))
        for sense, law in laws:
            own = ((low + high) / 2.0, (high - low) / 2.0) if law.curve is None else law.curve.terms
            terms[: len(own)] += sense * law.ratio * np.array(own)
            terms[0] += sense * law.offset
        curve = replace(curves[0], terms=tuple(terms.tolist()))
        return AssetCoupling(pin.joint, 1.0, 0.0, curve)

    def _widest_gap(self, pin: AssetLoop) -> float:
        """Return the widest gap at a pin in many positions of its input [m]."""
        asset, dofs = self.asset, list(self.asset.valid_states.dofs)
        states = np.tile([asset.joint(name).closed for name in dofs], (_GAPS, 1))
        states[:, dofs.index(pin.joint)] = np.linspace(*self.ranges[pin.joint], _GAPS)
        poses, names = asset.fk(states), list(asset.links.by_name)
        ends = [
            poses[:, names.index(name), :3, 3]
            + np.einsum("nij,j->ni", poses[:, names.index(name), :3, :3], pin.point - asset.origin(name))
            for name in pin.links
        ]
        return float(np.abs(ends[0] - ends[1]).max())

    def _parts(self, a: str, b: str, variables: Sequence[str]) -> Iterator[_Part]:
        """Yield the boxes of the joint space of two links, and the contacts that are allowed in each."""
        contacts = [each for each in self.asset.contacts if set(each.links) == {a, b}]
        for whole in self.boxes(variables):
            for box in self._split(whole, contacts):
                holds = partial(self._holds, box)
                yield box, tuple(each for each in contacts if each.when is None or each.when.combined(holds))

    def boxes(self, variables: Sequence[str]) -> list[Box]:
        """Return boxes that together contain all positions of variables that dependencies allow.

        The boxes are cut in the space of these variables and of all variables that they depend on, and then
        projected.
        """
        known = self._boxes.get(tuple(variables))
        if known is None:
            known = self._boxes[tuple(variables)] = self._cut(variables)
        return known

    def _cut(self, variables: Sequence[str]) -> list[Box]:
        needed = list(variables)
        for variable in needed:  # grows: the variables that joints depend on are appended
            for joint, _ in self._alternatives:
                assert joint.needs is not None
                if self.followers[joint.name].leader == variable:
                    needs = (self.followers[name].leader for name in joint.needs.condition.joints())
                    needed += [name for name in dict.fromkeys(needs) if name and name not in needed]
        boxes: list[Box] = [{name: self.ranges[name] for name in needed}]
        for _, alternatives in self._alternatives:
            clauses = [
                {name: ends for name, ends in clause.items() if name in needed} for clause in alternatives
            ]
            if not all(clauses) or len(boxes) * len(clauses) > _MOST_BOXES:
                continue
            cut = [_common(box, clause) for box in boxes for clause in clauses]
            boxes = _largest([box for box in cut if box is not None])
        return _largest([{name: box[name] for name in variables} for box in boxes])

    def _resolve(self, joint: AssetJoint) -> None:
        """Find the variable of a joint's position."""
        ratio, offset, leader, curve = 1.0, 0.0, joint, None
        while leader.follows is not None:
            offset += ratio * leader.follows.offset
            ratio *= leader.follows.ratio
            curve = leader.follows.curve  # the leader of a closed chain is free
            leader = self.asset.joint(leader.follows.leader)
        law = AssetCoupling(leader.name, ratio, offset, curve)
        if leader.locked:
            assert leader.limits is not None
            self.followers[joint.name] = AssetCoupling("", 0.0, law.at(leader.limits[0]))
            return
        turns = leader.kind == "revolute" and law.comes_round(joint.kind)
        if leader.limits is None and joint is not leader and not turns:
            # over several turns of the leader, the follower may be anywhere
            leader, law = joint, AssetCoupling(joint.name, 1.0)
        full = FULL_TURN if leader.kind == "revolute" else FULL_SLIDE
        self.followers[joint.name] = law
        self.ranges[leader.name] = full if leader.limits is None else leader.limits

    @cached_property
    def _alternatives(self) -> tuple[tuple[AssetJoint, list[Box]], ...]:
        """The joints with a dependency, each with boxes one of which it requires."""
        result = []
        for joint in self.asset.joints:
            if joint.needs is not None:
                free = joint.needs.beyond or _CLOSED
                ranges = [(-free, free)]
                if joint.needs.until is not None:
                    ranges += [(joint.needs.until, math.inf), (-math.inf, -joint.needs.until)]
                alternatives = [self._where(joint.name, *each) for each in ranges]
                alternatives += self._terms(joint.needs.condition)
                result.append((joint, [each for each in alternatives if each is not None]))
        return tuple(result)

    def _where(self, joint: str, low: float, high: float) -> Box | None:
        """Return the positions of a joint within an interval; None if there are none."""
        follower = self.followers[joint]
        if not follower.leader:
            return {} if low <= follower.offset <= high else None
        name, limits = follower.leader, self.ranges[follower.leader]
        if self.asset.joint(name).limits is None:
            return {}  # positions of unlimited joints are known up to full turns only
        ends = sorted((end - follower.offset) / follower.ratio for end in (low, high))
        low, high = max(ends[0], limits[0]), min(ends[1], limits[1])
        return {name: (low, high)} if low <= high else None

    def _terms(self, condition: AssetCondition) -> Iterator[Box | None]:
        """Yield boxes whose union is the region of a condition."""
        if condition.kind == "above":
            yield self._where(condition.joint, condition.value, math.inf)
        elif condition.kind == "below":
            yield self._where(condition.joint, -math.inf, condition.value)
        elif condition.kind == "any":
            for term in condition.terms:
                yield from self._terms(term)
        else:
            for terms in itertools.product(*(list(self._terms(term)) for term in condition.terms)):
                clause: Box | None = {}
                for box in terms:
                    clause = None if clause is None or box is None else _common(clause, box)
                yield clause

    def _split(self, box: Box, contacts: Sequence[AllowedContact]) -> list[Box]:
        """Cut a box at the thresholds of the conditions of contacts."""
        boxes = [box]
        terms = [term for each in contacts if each.when is not None for term in each.when.comparisons()]
        for term in terms:
            follower = self.followers[term.joint]
            name = follower.leader
            if name in box and self.asset.joint(name).limits is not None:
                value = (term.value - follower.offset) / follower.ratio
                boxes = [part for each in boxes for part in _halves(each, name, value)]
        return boxes

    def _holds(self, box: Box, term: AssetCondition) -> bool:
        """Tell whether a comparison holds everywhere in a box."""
        follower = self.followers[term.joint]
        if follower.leader and self.asset.joint(follower.leader).limits is None:
            return False  # it holds within one turn, but perhaps not in the next
        interval = box.get(follower.leader, self.ranges.get(follower.leader, (0.0, 0.0)))
        ends = [follower.at(end) for end in interval]
        if term.kind == "above":
            return min(ends) >= term.value - _ROUNDING
        return max(ends) <= term.value + _ROUNDING


@cached(1)
def space_of(asset: Asset) -> Space:
    """Return the joint space of an asset, the last one again: some callers prove one pair after another."""
    return Space(asset)


def _common(first: Box, second: Box) -> Box | None:
    """Return the intersection of two boxes, None if it is empty; unnamed joints are free."""
    result = dict(first)
    for name, (low, high) in second.items():
        lowest, highest = result.get(name, (-math.inf, math.inf))
        result[name] = (max(low, lowest), min(high, highest))
        if result[name][0] > result[name][1]:
            return None
    return result


def _largest(boxes: Sequence[Box]) -> list[Box]:
    """Return the boxes that no other box contains."""
    result: list[Box] = []
    for index, box in enumerate(boxes):
        others = [*result, *boxes[index + 1 :]]
        if not any(all(o[n][0] <= low and high <= o[n][1] for n, (low, high) in box.items()) for o in others):
            result.append(box)
    return result


def _halves(box: Box, name: str, value: float) -> list[Box]:
    low, high = box[name]
    if not low < value < high:
        return [box]
    return [{**box, name: (low, value)}, {**box, name: (value, high)}]
