"""Check of settling: a released asset keeps its state unless gravity or a spring moves it."""

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import cached_property
from artgen.asset import Asset, AssetCondition
from artgen.asset.report import Finding, Severity
from artgen.validate.behavior.model import (
    CHECK,
    DEPTH,
    FLOOR,
    JointMotion,
    Pieces,
    Simulation,
    UnstableError,
    joint_finding,
    piece,
)
from artgen.validate.joints import force, length, state_for

SETTLE_TIME = 5.0
"""Duration of the observation after the release [s]."""

REST_SPEED = 1e-5
"""Speed below which nothing moves visibly within `SETTLE_TIME` [rad/s or m/s]."""

REST_TIME = 0.25
"""Time at rest after which the asset counts as settled [s]."""

_BEGUN = 0.05  # share of a drift that exceeds the compliance of contacts
_STILL = 1e-3  # speed below which an impact is over [rad/s or m/s]
_DRIFTS = {"revolute": math.radians(0.5), "prismatic": 0.0005}  # drift that needs a cause [rad or m]
_IMPACT_TIME = 0.05  # shorter deep contacts are impacts of falling parts [s]
_TILT = math.radians(2.0)  # drift of a base on the floor [m]
_LYING = 0.08  # height of an asset that settles on its side or rolls away, rather than tips over [m]


def settle(simulation: Simulation, *, stands: bool = False) -> "Settled":
    """Release an asset when it is closed, halfway open and open; `stands` if its base is free on a floor.

    A base that tips over is a fault if the asset is closed and more than 80 mm high, and a note otherwise:
    a chest with all drawers drawn out falls over, and a pen rolls.
    """
    result = Settled(simulation, stands)
    for q in start_poses(simulation.asset, simulation.motions):
        if q not in result.poses:
            result.poses.append(q)
            with suppress(UnstableError):
                result.watch(q)
    return result


def start_poses(asset: Asset, motions: Mapping[str, JointMotion]) -> Iterator[dict[str, float]]:
    """Yield the poses of the release: closed, halfway open and open.

    Joints that are blocked halfway or open stay closed; a further pose opens what they depend on, such as
    racks halfway out over an open door.
    """
    for share in (0.0, 0.5, 1.0):
        q = _start_pose(asset, motions, share, {})
        yield q
        stays = [motion for name, motion in motions.items() if q[name] == motion.joint.closed]
        freed = _freed(asset, stays) if share else {}
        if freed:
            yield _start_pose(asset, motions, share, freed)


def _freed(asset: Asset, motions: Sequence[JointMotion]) -> dict[str, float]:
    """Return positions of other joints at which as many of some joints as possible may leave 0."""
    found: dict[str, float] = {}
    conditions: list[AssetCondition] = []
    for member in (member for motion in motions for member in motion.members):
        if member.needs is not None:
            state = state_for(asset, [*conditions, member.needs.condition])
            if state is not None:
                conditions.append(member.needs.condition)
                found = state
    return found


def _start_pose(
    asset: Asset, motions: Mapping[str, JointMotion], share: float, given: Mapping[str, float]
) -> dict[str, float]:
    """Put each free joint at a share of its range from closed to open, except for blocked joints."""
    q = {}
    for name, motion in motions.items():
        low, high = motion.limits
        closed = motion.joint.closed
        far = high if high - closed >= closed - low else low
        q[name] = {0.0: closed, 0.5: (low + high) / 2.0, 1.0: far}[share]
    q |= given
    for _ in motions:
        blocked = set(asset.blocked(q))
        for name, motion in motions.items():
            if blocked & {member.name for member in motion.members}:
                q[name] = motion.joint.closed
    return q


@dataclass
class _Drift:
    """Drift of one joint."""

    motion: JointMotion  # the joint
    start: float  # position at the release [rad or m]
    causes: set[int]  # directions in which gravity or a spring moves it: -1 and 1
    why: str  # cause of its motion, or of its rest
    furthest: float = 0.0  # largest motion [rad or m]
    since: float | None = None  # time at which it had moved too far without a cause; None if it has not [s]
    # bodies in motion that have touched it since it was at rest: an impact may be over when the joint has
    # moved that far
    pushed: list[str] = field(default_factory=list)
    touching: list[str] = field(default_factory=list)  # bodies that press on it then


@dataclass
class Settled:
    """Observations while an asset settles."""

    simulation: Simulation  # the asset
    stands: bool  # whether the base is free on a floor
    findings: dict[tuple[str, ...], Finding] = field(default_factory=dict)  # the worst of each kind and place
    movers: set[str] = field(default_factory=set)  # joints that gravity or a spring moves
    poses: list[dict[str, float]] = field(default_factory=list)  # poses of the release, the present one last
    deep: dict[Pieces, float] = field(default_factory=dict)  # time since contacts are too deep [s]
    tipped: bool = False  # whether the base leans in the present pose

    def watch(self, q: dict[str, float]) -> None:
        """Release the asset at a pose, and step until everything is at rest or the time is over."""
        simulation = self.simulation
        simulation.begin(q, "it settles")
        if self.stands and self._opened and simulation.sinks():
            return  # folded like this, it does not stand on its base
        self.deep, self.tipped = {}, False
        drifts = [self._drift(motion) for motion in simulation.motions.values()]
        places = np.array([drift.motion.at for drift in drifts], int)
        starts = np.array([drift.start for drift in drifts])
        self._report_contacts()
        quiet = 0.0
        for _ in range(round(SETTLE_TIME / simulation.step_time)):
            simulation.step()
            self._report_contacts()
            if self.stands:
                self._report_tilt()
            self._follow_drifts(drifts, (simulation.data.qpos[places] - starts).tolist())
            speeds = simulation.data.qvel
            still = np.abs(speeds).max(initial=0.0) < REST_SPEED
            quiet = quiet + simulation.step_time if still else 0.0
            if quiet >= REST_TIME:
                break
        for drift in () if self.tipped else drifts:  # joints of a base that falls move with it
            if drift.since is not None:
                self._report_drift(drift)
            elif abs(drift.furthest) > _DRIFTS[drift.motion.joint.kind]:
                self.movers.add(drift.motion.name)

    def _add(self, finding: Finding, *kind: str) -> None:
        """Keep a finding if it is the worst of its kind and place."""
        known = self.findings.get(kind)
        if known is None or abs(finding.value or 0.0) > abs(known.value or 0.0):
            self.findings[kind] = finding

    def _drift(self, motion: JointMotion) -> _Drift:
        load = self.simulation.load(motion)
        why = f"gravity and springs pull with {force(motion.joint, load)}"
        if motion.friction:
            why += f" against {force(motion.joint, motion.friction)} of friction"
        return _Drift(motion, self.simulation.position(motion), self._directions(motion, load), why)

    def _directions(self, motion: JointMotion, load: float) -> set[int]:
        """Return the direction in which a load could move a joint farther than allowed without a cause."""
        excess = abs(load) - motion.friction
        if excess <= 0.0:
            return set()
        way = 0.5 * excess / self.simulation.inertia(motion) * SETTLE_TIME**2
        return {int(math.copysign(1, load))} if way > _DRIFTS[motion.joint.kind] else set()

    def _follow_drifts(self, drifts: list[_Drift], ways: list[float]) -> None:
        """Record which joints move without a cause; `ways` are their motions so far [rad or m]."""
        carried = any(drift.causes for drift in drifts)
        pulls: list[float] = []
        for number, (drift, way) in enumerate(zip(drifts, ways, strict=True)):
            motion = drift.motion
            if abs(way) > abs(drift.furthest):
                drift.furthest = way
            if drift.since is not None:
                continue
            if carried and len(drift.causes) < 2 and (not drift.causes or motion.friction):
                # other motion changes gravity on this joint, or carries it along
                pulls = pulls or self.simulation.pulls().tolist()
                pull = pulls[number]
                if abs(pull) > motion.friction and int(math.copysign(1, pull)) not in drift.causes:
                    drift.causes |= self._directions(motion, pull)
            if drift.pushed or abs(way) > _BEGUN * _DRIFTS[motion.joint.kind]:
                self._follow_drift(drift, drifts, way)

    def _follow_drift(self, drift: _Drift, drifts: list[_Drift], way: float) -> None:
        simulation, motion = self.simulation, drift.motion
        allowed = _DRIFTS[motion.joint.kind]
        if drift.pushed and abs(simulation.speed(motion)) < _STILL:
            drift.pushed = []  # later motion has another cause
        if abs(way) > _BEGUN * allowed and not drift.pushed and simulation.data.ncon:
            moving = simulation.moving(other.motion for other in drifts if other.causes)
            drift.pushed = simulation.touching(motion, moving)
        if abs(way) > allowed and int(math.copysign(1, way)) not in drift.causes:
            drift.since = float(simulation.data.time)
            drift.touching = simulation.touching(motion)

    def _report_drift(self, drift: _Drift) -> None:
        joint = drift.motion.joint
        message = f"moves by {length(joint, drift.furthest)} without a cause: {drift.why}"
        hint = ""
        rolls = self.stands and any(FLOOR in contact for contact in drift.touching)
        severity: Severity = "note" if drift.pushed or rolls else "fault"
        if rolls:
            message = f"moves by {length(joint, drift.furthest)} on the floor, as the base does"
        elif drift.pushed:
            message = (
                f"is pushed by {length(joint, drift.furthest)} by what gravity or a spring moves: "
                f"{drift.pushed[0]} touch"
            )
        elif drift.touching:
            hint = f"{drift.touching[0]} push each other apart: make room between them"
        elif drift.motion.friction:
            hint = "the file's friction creeps: write a harder solimpfriction and solreffriction"
        finding = joint_finding(joint, message, hint, drift.furthest, self.poses[-1], severity)
        self._add(finding, "drift", joint.name, severity)

    def _report_contacts(self) -> None:
        """Keep the deepest contacts that are too deep from the start or for longer than an impact."""
        simulation = self.simulation
        depths = -np.asarray(simulation.data.contact.dist) if simulation.data.ncon else np.zeros(0)
        if not self.deep and not (depths > DEPTH).any():
            return
        now = float(simulation.data.time)
        deep: dict[Pieces, float] = {}
        for number in np.flatnonzero(depths > DEPTH):
            pieces, depth = simulation.contact(int(number)), float(depths[number])
            if depth <= self._allowed(pieces) + DEPTH:
                continue
            since = deep[pieces] = self.deep.get(pieces, now)
            if since > 0.0 and now - since < _IMPACT_TIME:
                continue
            first, second = (piece(*each) for each in pieces)
            message = f"{first} and {second} press {1e3 * depth:.3g} mm into each other after {now:.2g} s"
            links = ", ".join(link for link, _ in pieces)
            hint = "make room between them, or declare the contact with allow_contact and its depth"
            finding = Finding(CHECK, message, links, "", depth, "m", simulation.pose(), hint)
            self._add(finding, "contact", first, second)
        self.deep = deep

    def _allowed(self, pieces: Pieces) -> float:
        """Return the allowed penetration of two pieces [m]."""
        depths = (
            contact.depth
            for contact in self.simulation.asset.contacts
            if tuple(zip(contact.links, contact.labels, strict=True)) in (pieces, pieces[::-1])
            and (contact.when is None or self.simulation.holds(contact.when))
        )
        return max(depths, default=0.0)

    @property
    def _opened(self) -> bool:
        """Whether the present pose is not the first one, in which all joints are closed."""
        return len(self.poses) > 1

    @cached_property
    def _lies(self) -> bool:
        """Whether the asset is so low that it settles or rolls rather than tips over."""
        return bool(np.ptp(self.simulation.asset.bounds()[:, 2]) < _LYING)

    def _report_tilt(self) -> None:
        simulation = self.simulation
        base = simulation.asset.links[0].name
        upright = float(simulation.data.body(base).xmat[8])
        if upright >= math.cos(_TILT):
            return
        self.tipped = True
        tilt = math.acos(max(-1.0, min(1.0, upright)))
        degrees = f"{math.degrees(tilt):.3g} degrees"
        message = f"tips over: after {simulation.data.time:.2g} s it leans by {degrees}"
        hint = "give it a wider or heavier base, or fix it to the world with base='fixed'"
        severity: Severity = "note" if self._opened or self._lies else "fault"
        finding = Finding(CHECK, message, base, "", tilt, "rad", self.poses[-1], hint, severity)
        self._add(finding, "tilt", severity)
