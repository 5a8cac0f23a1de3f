"""Check of dependencies: while a condition does not hold, a part has to block the joint."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from artgen.asset import AssetCondition, AssetDependency, AssetJoint
from artgen.asset.report import Finding
from artgen.validate.behavior.drive import servos, step_held
from artgen.validate.behavior.model import DEPTH, JointMotion, Simulation, UnstableError, joint_finding
from artgen.validate.joints import force, isolated, length, place, state_for

_PUSHES = {"revolute": 20.0, "prismatic": 50.0}  # pushing force [N m or N]
_PUSH_TIME, _RAMP_TIME = 1.0, 0.25  # duration of a push, and of its growth [s]
_GIVES = 0.02  # share of the range by which a blocked joint may move
_PLAYS = {"revolute": math.radians(1.0), "prismatic": 0.003}  # play of every lock [rad or m]
_MOST_PLAY = 0.1  # share of the range that exceeds play


def block(simulation: Simulation, motion: JointMotion) -> Iterator[Finding]:
    """Push a joint and its followers wherever a part of its condition fails; yield the first faults."""
    for joint in motion.members:
        needs = joint.needs
        if needs is None:
            continue
        states = list(_states(simulation, motion, needs.condition))
        if not states:
            message = f"needs {needs.condition}, which holds wherever the other joints stand"
            yield joint_finding(joint, message, "leave the dependency out, or reverse its comparison")
        pushes = (_Push(simulation, motion, joint, needs, *state) for state in states)
        results = (push.run(sign) for push in pushes for sign in _directions(motion))
        found = next((result for result in results if result is not None), None)
        if found is not None:
            yield found


def _directions(motion: JointMotion) -> list[int]:
    """Return the directions in which a joint can leave its closed position."""
    closed, limits = motion.joint.closed, motion.joint.limits
    if limits is None:
        return [1, -1]
    return [sign for sign, room in ((1, limits[1] - closed), (-1, closed - limits[0])) if room > 1e-9]


def _states(
    simulation: Simulation, motion: JointMotion, condition: AssetCondition
) -> Iterator[tuple[dict[str, float], frozenset[str]]]:
    """Yield positions that break a condition, with the responsible joints: all closed, then part by part."""
    seen = []
    closed = simulation.asset.positions()
    if not condition.holds(closed):
        seen.append(closed)
        yield {}, frozenset(condition.joints())
    for comparison, region in isolated(condition):
        if comparison.joint in {member.name for member in motion.members}:
            continue
        state = state_for(simulation.asset, [region], ignore=motion.name, extreme=(comparison.joint,))
        if state is None:
            continue
        positions = simulation.asset.positions(state)
        if positions not in seen and not condition.holds(positions):
            seen.append(positions)
            yield state, frozenset({comparison.joint})


@dataclass(frozen=True)
class _Push:
    """One push at positions where a condition fails."""

    simulation: Simulation  # the asset
    motion: JointMotion  # the free joint that is pushed
    joint: AssetJoint  # the dependent joint: the same, or one that follows it
    needs: AssetDependency  # the dependency
    state: Mapping[str, float]  # positions of the other joints
    # joints for which the condition fails; nothing but the asset itself holds them
    broken: frozenset[str]

    def run(self, sign: int) -> Finding | None:
        """Push in one direction; return the motion of the joint if it is too large."""
        simulation, motions, allowed = self.simulation, self.simulation.motions, self._play()
        positions = simulation.asset.positions(self.state)
        # parts with springs have to hold by themselves; a part without a spring that yields is only a note
        loose = {
            name: positions[name]
            for name, other in motions.items()
            if self._breaks(other) and not self._returns(other, positions[name])
        }
        try:
            furthest, depth = self._pushed(sign, {})
            if furthest <= allowed or (self._elsewhere and depth <= DEPTH):
                return None
            moves = self._moves(furthest)
            touching = simulation.touching(self.motion)
            contact = f"{touching[0]} touch, and give way" if touching else "nothing touches it"
            message = f"{moves}, though it needs {self.needs}; {contact}"
            hint = "no file format knows dependencies: a part, such as a latch, has to stand in its way"
            fault = joint_finding(self.joint, message, hint, furthest, simulation.pose())
            along = [name for name, start in loose.items() if self._has_moved(motions[name], start)]
            if not along or self._pushed(sign, loose)[0] > allowed:
                return fault
        except UnstableError:
            return None
        others = " and ".join(along)
        message = f"is blocked only while a hand holds {others}: {moves}, and takes {others} along"
        hint = f"where they move together, {self.needs} does not hold and nothing is proven"
        return joint_finding(self.joint, message, hint, furthest, positions, "note")

    @property
    def _elsewhere(self) -> bool:
        """Whether the responsible joints belong to another asset of the room."""
        # their box is around the states of contact: the joint may move in a part, not into the other asset
        owners, asset = self.simulation.owners, self.simulation.asset
        own = owners[self.joint.child]
        return all(owners[asset.joint(name).child] != own for name in self.broken)

    def _returns(self, motion: JointMotion, position: float) -> bool:
        """Tell whether a spring returns a joint from its whole range; one that balances a weight does not."""
        if motion.stiffness == 0.0:
            return False
        low, high = motion.limits
        if abs(min(max(motion.rest, low), high) - position) > _GIVES * motion.range:
            return False  # it rests elsewhere, like a flap that springs half open
        far = high if high - position >= position - low else low
        for share in (0.5, 1.0):
            away = position + share * (far - position)
            self.simulation.begin({**self.state, motion.name: away}, "", jammed=True)
            pull = self.simulation.load(motion) * math.copysign(1.0, position - away)
            if pull <= motion.friction:
                return False
        return True

    def _breaks(self, motion: JointMotion) -> bool:
        return bool(self.broken & {member.name for member in motion.members})

    def _has_moved(self, motion: JointMotion, start: float) -> bool:
        distance = abs(self.simulation.position(motion) - start)
        return distance > min(_PLAYS[motion.joint.kind], 0.01 * motion.range)

    def _pushed(self, sign: int, loose: Mapping[str, float]) -> tuple[float, float]:
        """Return the largest motion of the joint [rad or m], and its depth in other assets [m]."""
        simulation, motions = self.simulation, self.simulation.motions
        begun = {**self.state, **self._end_of_slack(sign)}
        simulation.begin(begun, f"{self.joint.name} is pushed", jammed=True)
        fixed = {name: at for name, at in self.state.items() if not self._breaks(motions[name])}
        held = servos(simulation, {**fixed, **loose})
        at = simulation.model.joint(self.joint.name).qposadr[0]
        start, furthest, depth = float(simulation.data.qpos[at]), 0.0, 0.0
        # at the end of its slack, a joint may first fall back while the force grows
        sense = math.copysign(1.0, sign * float(self.motion.ratios[self.motion.members.index(self.joint)]))
        low, high = self.joint.limits or (-math.inf, math.inf)
        for _ in range(round(_PUSH_TIME / simulation.step_time)):
            grown = min(1.0, float(simulation.data.time) / _RAMP_TIME)
            simulation.applied[self.motion.dof] = sign * grown * self._force
            step_held(simulation, held)
            position = min(max(float(simulation.data.qpos[at]), low), high)
            furthest = max(furthest, sense * (position - start))
            depth = max(depth, simulation.depth(self.motion))
        return furthest, depth

    def _end_of_slack(self, sign: int) -> dict[str, float]:
        """Return the start of the push: the end of the free joint's slack, if it has some [rad or m]."""
        motion, slack = self.motion, self.needs.beyond
        if slack is None:
            return {}
        number = motion.members.index(self.joint)
        ratio, offset = float(motion.ratios[number]), float(motion.offsets[number])
        closed = motion.joint.closed
        ends = [sign * ((side * slack - offset) / ratio - closed) for side in (-1.0, 1.0)]
        low, high = motion.joint.limits or (-math.inf, math.inf)
        end = closed + sign * min((end for end in ends if end > 0.0), default=0.0)
        return {motion.name: min(max(end, low), high)}

    @property
    def _force(self) -> float:
        return min(self.motion.joint.effort, _PUSHES[self.motion.joint.kind])

    def _play(self) -> float:
        """Return the allowed motion of a blocked joint beyond the end of its slack [rad or m]."""
        joint = self.joint
        if joint.limits is None:
            return _PLAYS[joint.kind]
        most = joint.limits[1] - joint.limits[0]
        play = max(_GIVES * most, min(_PLAYS[joint.kind], _MOST_PLAY * most))
        if self.needs.until is None:
            return play
        return min(play, self.needs.until - (self.needs.beyond or 0.0))

    def _moves(self, furthest: float) -> str:
        states = ", ".join(f"{name} at {position:.4g}" for name, position in self.state.items())
        slack = self.needs.beyond
        start = "" if slack is None else f"from {place(self.joint, slack)} on "
        return (
            f"moves {start}by {length(self.joint, furthest)} under {force(self.motion.joint, self._force)} "
            f"with {states or 'all closed'}"
        )
