"""Posing of joints, and driving of joints in a simulation by torques and forces."""

from collections.abc import Callable
from typing import Any

import numpy as np
from driver_protocol import ends, in_base

_TICK = 0.004  # time between two changes of a force [s]
_MOST = 4.0  # time to one end [s]
_GROWTH = 6.0  # growth of a force while its joint hardly moves [1/s]
_LEAST = 1e-4  # share of the effort at the start
_SLOW, _FAST = 0.5, 2.5  # speeds between which a force is unchanged [ranges/s]
_NEAR = 0.02  # tolerance at the end, as a share of the range
_FIRM = 2.0  # factor of the force that holds a joint at its end
_FREED = 0.5  # share of the range beyond which a joint is not blocked any more
_SETTLE = 1.0  # time before anything is driven [s]
_LOOK = 0.1  # interval between two looks at a room at rest [s]
_FOLLOWED = 0.01  # largest lag of a coupled joint, as a share of the range


class Simulation:
    """Base class of the simulations of clients, which define the methods that are only annotated here."""

    place: Callable[[dict[str, float]], None]  # puts the joints to their positions [rad or m]
    frames: Callable[[], dict[str, Any]]  # returns the frame of each link, shape (4, 4) [m]
    positions: Callable[[], Any]  # returns the positions of all joints [rad or m]
    # sets the torques and forces of joints until the next call; all others get 0 [N m or N]
    push: Callable[[dict[str, float]], None]
    step: Callable[[int], None]  # simulates a number of steps
    time_step = 0.002  # [s]

    def __init__(self, places: dict[str, int], degrees: dict[str, int]) -> None:
        self.places, self.degrees = places, degrees  # indices of joints among positions and among forces
        self.steps, self.finite = 0, True  # number of steps, and whether all positions were finite

    def position(self, name: str) -> float:
        """Return the position of a joint [rad or m]."""
        return float(self.positions()[self.places[name]])

    def advance(self, seconds: float) -> None:
        """Simulate for a time."""
        count = max(1, round(seconds / self.time_step))
        self.step(count)
        self.steps += count
        self.finite = self.finite and bool(np.isfinite(self.positions()).all())

    def in_order(self, values: dict[str, float], result: Any) -> Any:
        """Return an array in the order of forces, in which the values of joints are set."""
        for name in values.keys() & self.degrees:
            result[self.degrees[name]] = values[name]
        return result

    def poses(self, request: dict[str, Any]) -> list[dict[str, Any]]:
        """Return the frames of links at the poses of a request."""
        found = []
        for pose in request["poses"]:
            self.place(pose)
            found.append(in_base(self.frames(), request["links"]))
        return found

    def unrest(self, request: dict[str, Any]) -> list[str]:
        """Return messages about free bodies and joints that move by themselves after a room settled."""
        settle, watch, way, share = request["rest"]
        self.advance(settle)
        start, places = self.positions(), self._free_places(request)
        moved, gone = 0.0 * np.asarray(start), 0.0 * places
        for _ in range(round(watch / _LOOK)):
            self.advance(_LOOK)
            moved = np.maximum(moved, np.abs(self.positions() - start))
            gone = np.maximum(gone, np.abs(self._free_places(request) - places))
        said = [
            f"{name} moves by {1e3 * most:.3g} mm by itself"
            for name, most in zip(request["free_links"], gone.max(axis=1), strict=True)
            if not most <= way
        ]
        for joint in request["joints"]:
            low, high = joint["limits"] or (-np.pi, np.pi)
            name = joint["name"]
            if name in self.places and not (most := moved[self.places[name]]) <= share * (high - low):
                said.append(f"{name} moves by {most:.4g} by itself")
        return said

    def _free_places(self, request: dict[str, Any]) -> Any:
        """Return the positions of the links of free bodies, shape (n, 3) [m]."""
        frames = self.frames()
        return np.array([frames[name][:3, 3] for name in request["free_links"]]).reshape(-1, 3)


def pose_and_drive(simulation: Simulation, request: dict[str, Any]) -> dict[str, Any]:
    """Return the poses and the motion for a response; the motion starts at the first pose."""
    poses = simulation.poses(request)
    simulation.place(request["poses"][0])
    return {"poses": poses, **drive_all(simulation, request)}


def drive_all(simulation: Simulation, request: dict[str, Any]) -> dict[str, Any]:
    """Drive each free joint to both ends, blocked joints last, and return the motion for a response.

    A room is watched at rest instead: each of its assets is driven alone.
    """
    if request.get("rest"):
        said = simulation.unrest(request)
        return {"moved": {}, "steps": simulation.steps, "finite": simulation.finite, "said": said}
    simulation.advance(_SETTLE)
    joints = [joint for joint in request["joints"] if joint["follows"] is None]
    moved: dict[str, list[float]] = {}
    held: dict[str, list[float]] = {}
    for joint in sorted(joints, key=lambda joint: joint["blocked"]):
        others: dict[str, float] = {}
        if joint["blocked"]:
            others = {name: held[name][side] for name, side in joint["freed"].items() if name in held}
            simulation.push(others)
            simulation.advance(_SETTLE)
        low, high, held[joint["name"]] = _drive(simulation, joint, others)
        if not joint["blocked"] or high - low > _FREED * (ends(joint)[1] - ends(joint)[0]):
            moved[joint["name"]] = [low, high]
    return {"moved": moved, "steps": simulation.steps, "finite": simulation.finite}


def _drive(
    simulation: Simulation, joint: dict[str, Any], held: dict[str, float]
) -> tuple[float, float, list[float]]:
    """Push a joint to both sides by a force that grows until it moves."""
    name = joint["name"]
    lower, upper = ends(joint)
    span = upper - lower
    seen, most = [simulation.position(name)], _LEAST
    for side, end in ((-1.0, lower), (1.0, upper)):
        share = _LEAST
        for _ in range(round(_MOST / _TICK)):
            if side * (end - seen[-1]) <= _NEAR * span or not simulation.finite:
                break
            simulation.push({**held, name: side * share * joint["effort"]})
            simulation.advance(_TICK)
            seen.append(simulation.position(name))
            speed = side * (seen[-1] - seen[-2]) / (span * _TICK)
            if speed < _SLOW:
                share = min(1.0, share * (1.0 + _GROWTH * _TICK))
            elif speed > _FAST:
                share = max(_LEAST, 0.5 * share)
        most = max(most, share)
    simulation.push({})
    hold = min(1.0, _FIRM * most) * joint["effort"]
    return min(seen), max(seen), [-hold, hold]


def lags(request: dict[str, Any], track: dict[str, Any]) -> list[str]:
    """Return messages about coupled joints that left their leaders; `track` has the positions of joints.

    Joints of a closed chain are left out where the format has no pins.
    """
    said = []
    for joint in request["joints"]:
        name, leader = joint["name"], joint["follows"]
        if leader not in track or name not in track or joint["curve"] == []:
            continue
        poses = request["poses"]
        if joint["curve"]:
            wanted = np.interp(track[leader], *joint["curve"])
        else:
            ratio, offset = np.polyfit([q[leader] for q in poses], [q[name] for q in poses], 1)
            wanted = ratio * track[leader] + offset
        error = float(np.abs(track[name] - wanted).max())
        span = max(1e-9, float(np.ptp([q[name] for q in poses])))
        if not error <= _FOLLOWED * span:
            said.append(f"{name} does not follow {leader}: it is off by {error:.4g}")
    return said
