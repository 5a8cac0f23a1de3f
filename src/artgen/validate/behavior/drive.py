"""Check of driven joints: a bounded force moves each joint from end to end, and springs return it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from artgen.asset import AssetCondition
from artgen.asset.report import Finding
from artgen.validate.behavior.conditions import state_for
from artgen.validate.behavior.model import CHECK, Simulation, UnstableError
from artgen.validate.behavior.motion import JointMotion, force, length, place, unit
from artgen.validate.behavior.settle import REST_SPEED, REST_TIME, SETTLE_TIME

_TRAVEL_TIME = 1.5  # time for the whole range [s]
_STUCK_TIME = 0.4  # time without progress at full force before giving up [s]
_MOST_TIME = 12.0  # time for the whole range of strongly damped joints [s]
_RAMP_TIME = 0.4  # time in which the force on a stuck joint doubles [s]
_FAINT = 1e-3  # least growth of a force in that time, as a share of its bound
_REACHED = 0.01  # tolerance of an end, as a share of the range
_RETURNED = 0.02  # tolerance of a spring's rest position, as a share of the range
_PROGRESS = 0.002  # share of the range that counts as progress
_HOLD_RATE = 10.0  # rate at which a held joint returns to its position [1/s]
_FIRM, _QUICK = 0.1, 0.6  # gains of the servo on the speed error and its derivative
_REFRESH = 50  # steps between two computations of the inertia


class Servo:
    """Bounded force on a free joint that makes it move at a speed or hold a position.

    Attributes:
        motion: The joint.
        bound: Largest force [N m or N].
        force: Current force [N m or N].
    """

    def __init__(self, simulation: Simulation, motion: JointMotion, bound: float) -> None:
        self.motion, self.bound = motion, bound
        self._simulation = simulation
        self._load = simulation.load(motion)
        self.force = self._bounded(-self._load)
        self._error = 0.0
        self._inertia, self._steps = 0.0, 0

    def move(self, speed: float) -> None:
        """Set the force of the next time step so that the joint approaches a speed [rad/s or m/s]."""
        simulation, motion = self._simulation, self.motion
        if self._steps % _REFRESH == 0:
            self._inertia = simulation.inertia(motion)
        self._steps += 1
        moving = simulation.speed(motion)
        error = speed - moving
        change = _FIRM * error + _QUICK * (error - self._error)
        change *= self._inertia / simulation.step_time
        if abs(moving) < 0.05 * abs(speed):
            change = math.copysign(max(abs(change), self._growth(speed)), speed)
        self._error = error
        # the known change of springs and gravity is fed forward; light joints would wait long for the gains
        load = simulation.load(motion)
        change, self._load = change + self._load - load, load
        self.force = self._bounded(self.force + change)
        simulation.applied[motion.dof] = self.force

    def _growth(self, speed: float) -> float:
        """Return the growth of the force in a time step without motion [N m or N].

        The growth is proportional to the force: with constant growth, a small part would fly off once the
        force overcomes its friction.
        """
        motion, step = self.motion, self._simulation.step_time
        needed = motion.friction + self._inertia * abs(speed) / step
        least = max(needed, abs(self.force), _FAINT * self.bound)
        return min(least, self.bound) * step / _RAMP_TIME

    def hold(self, position: float) -> None:
        """Set the force of the next time step so that the joint stays at a position [rad or m]."""
        off = position - self._simulation.position(self.motion)
        most = self.motion.range / _TRAVEL_TIME
        # a joint in place needs no more force
        speed = max(-most, min(most, _HOLD_RATE * off)) if abs(off) > 1e-4 * self.motion.range else 0.0
        self.move(speed)

    def _bounded(self, amount: float) -> float:
        return max(-self.bound, min(self.bound, amount))


class Held:
    """Joints that are held where the conditions of another joint are satisfied."""

    def __init__(self, simulation: Simulation, q: Mapping[str, float]) -> None:
        self._servos = [
            (Servo(simulation, simulation.motions[name], simulation.motions[name].joint.effort), position)
            for name, position in q.items()
        ]

    def step(self) -> None:
        """Set the forces of the next time step."""
        for servo, position in self._servos:
            servo.hold(position)


def needed_state(simulation: Simulation, motion: JointMotion) -> dict[str, float] | None:
    """Find positions of other joints at which a joint may move; None if there are none."""
    return state_for(simulation.asset, conditions(motion), ignore=motion.name)


def conditions(motion: JointMotion) -> list[AssetCondition]:
    """Return the conditions for the motion of a joint and its followers."""
    return [member.needs.condition for member in motion.members if member.needs is not None]


def drive(simulation: Simulation, motion: JointMotion) -> list[Finding]:
    """Drive a joint from its closed position to both ends by its own effort."""
    state = needed_state(simulation, motion)
    if state is None:
        needs = " and ".join(str(condition) for condition in conditions(motion))
        return [
            _finding(
                motion,
                f"can never move: no position of the other joints satisfies {needs}",
                "keep the condition within the limits of the joints that it names",
            )
        ]
    closed = motion.joint.closed
    ends = sorted(motion.limits, key=lambda end: -abs(end - closed))
    findings: list[Finding] = []
    begin = True
    for end in ends:
        if begin:
            simulation.begin(state, f"{motion.name} is driven")
        try:
            found = _Travel(simulation, motion, Held(simulation, state), end).run()
        except UnstableError:
            break
        begin = found is not None
        findings += [found] if found is not None else []
    return findings


@dataclass
class _Travel:
    """Motion to one end."""

    simulation: Simulation
    motion: JointMotion
    held: Held
    end: float

    def run(self) -> Finding | None:
        """Drive to the end; return the fault if the end is not reached."""
        simulation, motion = self.simulation, self.motion
        joint = motion.joint
        servo = Servo(simulation, motion, joint.effort)
        begun = simulation.position(motion)
        speed = math.copysign(min(motion.range / _TRAVEL_TIME, joint.velocity), self.end - begun)
        best, stuck = abs(self.end - begun), 0.0
        most = max(_MOST_TIME, 2.0 * motion.range / abs(speed))
        for _ in range(round(most / simulation.step_time)):
            left = abs(self.end - simulation.position(motion))
            if left <= _REACHED * motion.range:
                return None
            if left < best - _PROGRESS * motion.range:
                best, stuck = left, 0.0
            elif abs(servo.force) >= 0.999 * servo.bound:
                stuck += simulation.step_time
            if stuck > _STUCK_TIME:
                break
            self.held.step()
            servo.move(speed)
            simulation.step()
        return self._fault(begun)

    def _fault(self, begun: float) -> Finding:
        simulation, motion = self.simulation, self.motion
        joint, here = motion.joint, simulation.position(motion)
        beyond = (here - self.end) * math.copysign(1.0, self.end - begun)
        if beyond > _REACHED * motion.range:
            return self._overspeed(here, begun)
        touching = simulation.touching(motion)
        way = abs(here - begun) if abs(self.end - here) < abs(self.end - begun) else 0.0
        message = (
            f"driven with {force(joint, joint.effort)} from {place(joint, begun)} to "
            f"{place(joint, self.end)}, it stops at {place(joint, here)}, "
            f"after {100 * way / abs(self.end - begun):.3g} % of the way"
        )
        if touching:
            message += f", where contact holds it: {'; '.join(touching)}"
            hint = "make room between them, or say with needs= where other joints have to stand first"
        else:
            load = simulation.load(motion)
            message += (
                f", where gravity, springs and damping pull with {force(joint, load)} "
                f"and friction holds with {force(joint, motion.friction)}"
            )
            hint = "give the joint more effort, or weaken its spring, friction or damping"
        return _finding(motion, message, hint, value=here, pose=simulation.pose())

    def _overspeed(self, here: float, begun: float) -> Finding:
        joint = self.motion.joint
        message = (
            f"driven with {force(joint, joint.effort)} from {place(joint, begun)} to "
            f"{place(joint, self.end)}, it flies through that limit to {place(joint, here)}"
        )
        hint = (
            "give it a smaller effort=, about 60 N times the lever arm of a hand, or more armature: "
            "simulators yield where a force is large for what it moves"
        )
        return _finding(self.motion, message, hint, value=here, pose=self.simulation.pose())


def release(simulation: Simulation, motion: JointMotion) -> list[Finding]:
    """Release a sprung joint at both ends of its range and check that it returns."""
    state = needed_state(simulation, motion)
    if motion.stiffness <= 0.0 or state is None:
        return []
    low, high = motion.limits if motion.joint.limits is not None else _around(motion.rest)
    target = min(max(motion.rest, low), high)
    width = max(_RETURNED * (high - low), motion.friction / motion.stiffness)
    findings = []
    for end in (low, high):
        if abs(end - target) <= width:
            continue
        simulation.begin({**state, motion.name: end}, f"{motion.name} springs back")
        try:
            found = _Return(simulation, motion, Held(simulation, state), end, target, width).run()
        except UnstableError:
            continue
        findings += [found] if found is not None else []
    return findings


def _around(rest: float) -> tuple[float, float]:
    return rest - math.pi / 2.0, rest + math.pi / 2.0


@dataclass
class _Return:
    """Return to the rest position of a spring."""

    simulation: Simulation
    motion: JointMotion
    held: Held
    end: float
    target: float
    width: float

    def run(self) -> Finding | None:
        """Release at the end of the range; return the contact that blocks the return."""
        simulation, motion = self.simulation, self.motion
        quiet, latest = 0.0, [math.inf, -math.inf]
        for _ in range(round(SETTLE_TIME / simulation.step_time)):
            self.held.step()
            simulation.step()
            if simulation.data.time > SETTLE_TIME - 0.5:
                here = simulation.position(motion)
                latest = [min(latest[0], here), max(latest[1], here)]
            quiet = quiet + simulation.step_time if abs(simulation.speed(motion)) < REST_SPEED else 0.0
            if quiet >= REST_TIME:
                break
        here = simulation.position(motion)
        swing = latest[1] - latest[0]
        if swing > _RETURNED * motion.range:
            slow = motion.damping**2 > 4.0 * motion.stiffness * simulation.inertia(motion)
            return self._finding(
                here,
                f"still moves by {length(motion.joint, swing)} in half a second, "
                f"{SETTLE_TIME:g} s after it was let go",
                "make the spring stiffer, or damp it less" if slow else "give it more damping",
            )
        if abs(here - self.target) <= self.width:
            return None
        return self._stopped(here)

    def _stopped(self, here: float) -> Finding | None:
        simulation, motion = self.simulation, self.motion
        joint = motion.joint
        missing = f"stands at {place(joint, here)} {SETTLE_TIME:g} s after its spring should have taken it "
        missing += f"to {place(joint, self.target)}"
        spring = motion.stiffness * (motion.rest - here)
        weight = simulation.weight(motion)
        carried = -weight * math.copysign(1.0, spring)
        if abs(spring + weight) <= motion.friction and carried > 0.5 * abs(spring):
            return None  # the spring balances the weight, like that of a door that stays in place
        towards = math.copysign(1.0, spring) * (spring + weight)
        if towards <= motion.friction + 0.02 * abs(spring) and abs(spring) > motion.friction:
            finding = self._finding(
                here,
                f"{missing}: its weight pulls with {force(joint, weight)} against {force(joint, spring)} "
                "of the spring",
                "make the spring stiffer, if it is to lift the part",
            )
            return Finding(**{**vars(finding), "severity": "note"})
        touching = simulation.touching(motion)
        if touching:
            return self._finding(here, f"{missing}: {touching[0]} hold it", "make room between them")
        return self._finding(
            here,
            f"{missing}: {force(joint, spring)} of the spring against {force(joint, motion.friction)} "
            f"of friction and {motion.joint.damping:.3g} of damping",
            "make the spring stiffer, or lower friction or damping",
        )

    def _finding(self, here: float, message: str, hint: str) -> Finding:
        return _finding(
            self.motion,
            f"let go at {place(self.motion.joint, self.end)}, it {message}",
            hint,
            value=here,
            pose=self.simulation.pose(),
        )


def _finding(
    motion: JointMotion,
    message: str,
    hint: str,
    *,
    value: float | None = None,
    pose: Mapping[str, float] | None = None,
) -> Finding:
    return Finding(
        CHECK,
        message,
        link=motion.joint.child,
        joint=motion.name,
        value=value,
        unit="" if value is None else unit(motion.joint),
        pose=pose or {},
        hint=hint,
    )
