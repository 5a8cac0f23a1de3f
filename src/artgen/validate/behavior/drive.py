"""Check of driven joints: a bounded force moves each joint from end to end, and springs return it."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from artgen.asset.report import Finding, Severity
from artgen.validate.behavior.model import JointMotion, Simulation, UnstableError, joint_finding
from artgen.validate.behavior.settle import REST_SPEED, REST_TIME, SETTLE_TIME
from artgen.validate.joints import force, length, needed_conditions, place, state_for, unit

_TRAVEL_TIME = 1.5  # time for the whole range [s]
_SLOWEST = 60.0  # longest time for the whole range at the velocity limit of a joint [s]
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
_STIFF = 1.0  # largest product of time step and frequency with which simulators integrate a spring well
_BEYOND = {"revolute": math.radians(0.5), "prismatic": 0.0005}  # tolerance of a soft limit [rad or m]
_CLOSED = 0.03  # distance from the closed position at which a soft closing has ended, as a share of its reach
_INSIDE, _OUTSIDE = 0.9, 0.1  # places of the release, as shares of the reach and of the way behind it
_CLOSES = (0.5, 8.0)  # shortest and longest time of a soft closing [s]
_ARRIVES = {"revolute": 0.8, "prismatic": 0.1}  # greatest speed at its end [rad/s or m/s]
_STANDS = 1.0  # time in which a part that is farther open stays [s]
_MOST_BEYOND = 0.2  # the same, as a share of the range


class Servo:
    """Bounded force on a free joint that makes it move at a speed or hold its target.

    Attributes:
        motion: The joint.
        target: Position at which the joint is held, or to which it moves [rad or m].
        bound: Largest force [N m or N].
        force: Current force [N m or N].
    """

    def __init__(self, simulation: Simulation, motion: JointMotion, target: float) -> None:
        self.motion, self.target, self.bound = motion, target, motion.joint.effort
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
        """Return the growth of the force in a time step without motion [N m or N]."""
        # proportional to the force: else a small part would fly off once the force overcomes its friction
        motion, step = self.motion, self._simulation.step_time
        needed = motion.friction + self._inertia * abs(speed) / step
        least = max(needed, abs(self.force), _FAINT * self.bound)
        return min(least, self.bound) * step / _RAMP_TIME

    def hold(self) -> None:
        """Set the force of the next time step so that the joint stays at its target."""
        off = self.target - self._simulation.position(self.motion)
        most = self.motion.range / _TRAVEL_TIME
        # a joint in place needs no more force
        speed = max(-most, min(most, _HOLD_RATE * off)) if abs(off) > 1e-4 * self.motion.range else 0.0
        self.move(speed)

    def _bounded(self, amount: float) -> float:
        return max(-self.bound, min(self.bound, amount))


def servos(simulation: Simulation, q: Mapping[str, float]) -> list[Servo]:
    """Return servos that hold joints at positions."""
    return [Servo(simulation, simulation.motions[name], position) for name, position in q.items()]


def step_held(simulation: Simulation, held: Iterable[Servo]) -> None:
    """Make one time step in which servos hold their joints."""
    for servo in held:
        servo.hold()
    simulation.step()


def drive(simulation: Simulation, motion: JointMotion) -> Iterator[Finding]:
    """Drive a joint from its closed position to both ends by its own effort; release it if it has springs."""
    simulation.begin({}, f"{motion.name} is closed")
    light = _too_light(simulation, motion)
    if light:
        hint = "explicit springs swing up where they are fast; add that armature, or soften the spring"
        yield joint_finding(motion.joint, light, hint, severity="note")
    for finding in _driven(simulation, motion):
        yield replace(finding, hint=f"it {light}") if light and finding.severity == "fault" else finding


def _driven(simulation: Simulation, motion: JointMotion) -> Iterator[Finding]:
    conditions = needed_conditions(simulation.asset, motion.name)
    state = state_for(simulation.asset, conditions, ignore=motion.name)
    if state is None:
        needs = " and ".join(map(str, conditions))
        message = f"can never move: no position of the other joints satisfies {needs}"
        hint = "keep the condition within the limits of the joints that it names"
        yield joint_finding(motion.joint, message, hint)
        return
    slowest = motion.range / motion.joint.velocity
    if slowest > _SLOWEST:
        message = f"takes {slowest:.3g} s over its range at its velocity limit of {motion.joint.velocity:.3g}"
        yield joint_finding(motion.joint, message, f"give it a velocity= that takes {_SLOWEST:g} s at most")
        return
    closed = motion.joint.closed
    begin, start = True, state
    for end in sorted(motion.limits, key=lambda end: -abs(end - closed)):
        if begin:
            simulation.begin(start, f"{motion.name} is driven")
        try:
            found = _travel(simulation, motion, servos(simulation, state), end)
        except UnstableError:
            break
        begin = found is not None
        if found is not None:
            yield found
        elif motion.joint.limits is None:  # no stop catches it, so that it comes back from rest
            begin, start = True, {**state, motion.name: end}
    if motion.stiffness > 0.0:
        yield from _release(simulation, motion, state)
    if motion.joint.closing is not None:
        yield from _soft_closing(simulation, motion, state, motion.joint.closing.reach)


def _too_light(simulation: Simulation, motion: JointMotion) -> str:
    """Return a message if a joint is too light for its spring at the time step; empty if it is not."""
    inertia, step = simulation.inertia(motion), simulation.step_time
    needed = motion.stiffness * (step / _STIFF) ** 2
    if inertia >= needed:
        return ""
    armature = motion.joint.armature + needed - inertia
    least = f"{armature:.2g} {unit(motion.joint, 'armature')}"
    return f"is too light for its spring at {1e3 * step:g} ms: armature >= {least}"


def _travel(simulation: Simulation, motion: JointMotion, held: list[Servo], end: float) -> Finding | None:
    """Drive to one end; return the fault if the end is not reached."""
    servo = Servo(simulation, motion, end)
    begun = simulation.position(motion)
    speed = math.copysign(min(motion.range / _TRAVEL_TIME, motion.joint.velocity), end - begun)
    best, stuck = abs(end - begun), 0.0
    most = max(_MOST_TIME, 2.0 * motion.range / abs(speed))
    for _ in range(round(most / simulation.step_time)):
        left = abs(end - simulation.position(motion))
        if left <= _REACHED * motion.range:
            return None
        if left < best - _PROGRESS * motion.range:
            best, stuck = left, 0.0
        elif abs(servo.force) >= 0.999 * servo.bound:
            stuck += simulation.step_time
        if stuck > _STUCK_TIME:
            break
        servo.move(speed)
        step_held(simulation, held)
    return _travel_fault(simulation, motion, begun, end)


def _travel_fault(simulation: Simulation, motion: JointMotion, begun: float, end: float) -> Finding:
    joint, here = motion.joint, simulation.position(motion)
    message = (
        f"driven with {force(joint, joint.effort)} from {place(joint, begun)} to {place(joint, end)}, it "
    )
    if (here - end) * math.copysign(1.0, end - begun) > _REACHED * motion.range:
        message += f"flies through that limit to {place(joint, here)}"
        hint = (
            "give it a smaller effort=, about 60 N times the lever arm of a hand, or more armature: "
            "simulators yield where a force is large for what it moves"
        )
        return joint_finding(joint, message, hint, here, simulation.pose())
    way = abs(here - begun) if abs(end - here) < abs(end - begun) else 0.0
    message += f"stops at {place(joint, here)}, after {100 * way / abs(end - begun):.3g} % of the way, where "
    touching = simulation.touching(motion)
    if touching:
        message += f"contact holds it: {'; '.join(touching)}"
        hint = "make room between them, or say with needs= where other joints have to stand first"
    else:
        message += (
            f"gravity, springs and damping pull with {force(joint, simulation.load(motion))} "
            f"and friction holds with {force(joint, motion.friction)}"
        )
        hint = "give the joint more effort, or weaken its spring, friction or damping"
    return joint_finding(joint, message, hint, here, simulation.pose())


def _soft_closing(
    simulation: Simulation, motion: JointMotion, state: Mapping[str, float], reach: float
) -> Iterator[Finding]:
    """Release a joint within the reach of its soft closing and behind it: it closes slowly, or stays."""
    joint, way = motion.joint, reach - motion.joint.closed
    for start in (joint.closed + _INSIDE * way, reach + _OUTSIDE * (joint.opened - reach)):
        simulation.begin({**state, motion.name: start}, f"{motion.name} closes softly")
        held, load = servos(simulation, state), simulation.load(motion)
        falls = abs(load) > motion.friction
        inside = abs(start - joint.closed) < abs(way)
        time, speed = math.inf, 0.0
        try:
            for _ in range(round((_CLOSES[1] if inside or falls else _STANDS) / simulation.step_time)):
                step_held(simulation, held)
                speed = abs(simulation.speed(motion))
                if abs(simulation.position(motion) - joint.closed) <= _CLOSED * abs(way):
                    time = float(simulation.data.time)
                    break
        except UnstableError:
            continue
        here, hint = simulation.position(motion), ""
        message = f"released at {place(joint, start)}, "
        if inside and not _CLOSES[0] <= time <= _CLOSES[1]:
            message += "it is still open" if math.isinf(time) else f"it is closed after {time:.2g} s"
            message += f": a soft closing takes {_CLOSES[0]:g} to {_CLOSES[1]:g} s"
            hint = "its preload has to be more than friction; change its force or damping"
        elif speed > _ARRIVES[joint.kind] and math.isfinite(time):
            message += f"it closes with {speed:.2g} {unit(joint, 'velocity')}"
            hint = "give its soft closing more damping"
        elif not inside and not falls and abs(here - start) > _BEYOND[joint.kind]:
            message += f"behind the reach of its soft closing, it moves to {place(joint, here)}"
            hint = "export it again"
        if hint:
            yield joint_finding(joint, message, hint, here, simulation.pose())


def _release(simulation: Simulation, motion: JointMotion, state: Mapping[str, float]) -> Iterator[Finding]:
    """Release a sprung joint at both ends of its range and check that it returns."""
    quarter = math.pi / 2.0
    low, high = motion.joint.limits or (motion.rest - quarter, motion.rest + quarter)
    target = min(max(motion.rest, low), high)
    near, sticks = _RETURNED * (high - low), motion.friction / motion.stiffness
    ends = [end for end in (low, high) if abs(end - target) > near]
    # friction may hold the joint near the rest of its spring, but not at all ends from which it is released
    moves = any(abs(end - motion.rest) > sticks for end in ends)
    width = max(near, sticks) if moves else near
    for end in ends:
        simulation.begin({**state, motion.name: end}, f"{motion.name} springs back")
        try:
            swing = _swing(simulation, motion, servos(simulation, state))
        except UnstableError:
            continue
        moving = swing > _RETURNED * motion.range
        here = simulation.position(motion)
        soft = min(_BEYOND[motion.joint.kind], _MOST_BEYOND * motion.range)
        allowed = width if low <= here <= high else max(width, soft)  # limits yield to a spring that presses
        if moving or abs(here - target) > allowed:
            yield from _return_findings(simulation, motion, end, target, swing if moving else 0.0)


def _swing(simulation: Simulation, motion: JointMotion, held: list[Servo]) -> float:
    """Let a joint move until it is at rest; return its motion in the last half second [rad or m]."""
    quiet, low, high = 0.0, math.inf, -math.inf
    for _ in range(round(SETTLE_TIME / simulation.step_time)):
        step_held(simulation, held)
        if simulation.data.time > SETTLE_TIME - 0.5:
            here = simulation.position(motion)
            low, high = min(low, here), max(high, here)
        quiet = quiet + simulation.step_time if abs(simulation.speed(motion)) < REST_SPEED else 0.0
        if quiet >= REST_TIME:
            break
    return high - low


def _return_findings(
    simulation: Simulation, motion: JointMotion, end: float, target: float, swing: float
) -> Iterator[Finding]:
    """Yield the reason why a joint still swings, or has not returned to the target of its spring."""
    joint, here = motion.joint, simulation.position(motion)
    spring = motion.stiffness * (motion.rest - here)
    ratios = motion.ratios_at(here)
    weight = -float(ratios @ simulation.data.qfrc_bias[motion.speeds])  # the joint is nearly at rest
    sense = math.copysign(1.0, spring)
    if not swing and abs(spring + weight) <= motion.friction and -weight * sense > 0.5 * abs(spring):
        return  # the spring balances the weight, like that of a door that stays in place
    missing = (
        f"stands at {place(joint, here)} {SETTLE_TIME:g} s after its spring should have taken it "
        f"to {place(joint, target)}: "
    )
    severity: Severity = "fault"
    if swing:
        message = (
            f"still moves by {length(joint, swing)} in half a second, {SETTLE_TIME:g} s after its release"
        )
        slow = motion.damping**2 > 4.0 * motion.stiffness * simulation.inertia(motion)
        hint = "make the spring stiffer, or damp it less" if slow else "give it more damping"
    elif sense * (spring + weight) <= motion.friction + 0.02 * abs(spring) and abs(spring) > motion.friction:
        weights = f"{force(joint, weight)} against {force(joint, spring)} of the spring"
        message = f"{missing}its weight pulls with {weights}"
        hint, severity = "make the spring stiffer, if it is to lift the part", "note"
    elif touching := simulation.touching(motion):
        message, hint = f"{missing}{touching[0]} hold it", "make room between them"
    else:
        message = (
            f"{missing}{force(joint, spring)} of the spring against {force(joint, motion.friction)} "
            f"of friction and {joint.damping:.3g} of damping"
        )
        hint = "make the spring stiffer, or lower friction or damping"
    message = f"released at {place(joint, end)}, it {message}"
    yield joint_finding(joint, message, hint, here, simulation.pose(), severity)
