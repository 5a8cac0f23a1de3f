"""Driving of joints in a simulation, for clients that move joints by torques and forces."""

import itertools
from typing import Any, Protocol

import numpy as np
from driver_protocol import ends, transform

_TICK = 0.004  # time between two changes of a force [s]
_MOST = 4.0  # time to one end [s]
_GROWTH = 6.0  # growth of a force while its joint hardly moves [1/s]
_LEAST = 1e-4  # share of the effort at the start
_SLOW, _FAST = 0.5, 2.5  # speeds between which a force is unchanged [ranges/s]
_NEAR = 0.02  # tolerance at the end, as a share of the range
_FIRM = 2.0  # factor of the force that holds a joint at its end
_FREED = 0.5  # share of the range beyond which a joint is not blocked any more
# most combinations of ends of other joints for a joint that they block: all ends of four joints
_COMBINATIONS = 16
_SETTLE = 1.0  # time before anything is driven [s]


class Simulation(Protocol):
    """Interface of a client for driving."""

    steps: int  # number of simulated steps
    finite: bool  # whether all positions were finite

    def position(self, name: str) -> float:
        """Return the position of a joint [rad or m]."""

    def push(self, forces: dict[str, float]) -> None:
        """Set the torques and forces of joints until the next call; all others get 0 [N m or N]."""

    def advance(self, seconds: float) -> None:
        """Simulate."""


def drive_all(simulation: Simulation, request: dict[str, Any]) -> dict[str, list[float]]:
    """Drive each free joint to both ends, blocked joints last."""
    simulation.advance(_SETTLE)
    joints = [joint for joint in request["joints"] if joint["follows"] is None]
    moved: dict[str, list[float]] = {}
    held: dict[str, list[float]] = {}
    for joint in joints:
        if not joint["blocked"]:
            low, high, forces = _drive(simulation, joint, {})
            moved[joint["name"]] = [low, high]
            held[joint["name"]] = forces
    for joint in joints:
        if joint["blocked"]:
            low, high = _drive_blocked(simulation, joint, held)
            if high - low > _FREED * (ends(joint)[1] - ends(joint)[0]):
                moved[joint["name"]] = [low, high]
    return moved


def _drive_blocked(
    simulation: Simulation, joint: dict[str, Any], held: dict[str, list[float]]
) -> list[float]:
    """Drive a joint while the others are held at their ends, in one combination after another."""
    lower, upper = ends(joint)
    reached = [simulation.position(joint["name"])] * 2
    combinations = itertools.product(*(reversed(each) for each in held.values()))
    for forces in itertools.islice(combinations, _COMBINATIONS):  # the first one opens everything
        others = dict(zip(held, forces, strict=True))
        simulation.push(others)
        simulation.advance(_SETTLE)
        low, high, _ = _drive(simulation, joint, others)
        reached = [min(reached[0], low), max(reached[1], high)]
        if reached[1] - reached[0] > _FREED * (upper - lower) or not simulation.finite:
            break
    return reached


def _drive(
    simulation: Simulation, joint: dict[str, Any], held: dict[str, float]
) -> tuple[float, float, list[float]]:
    """Push a joint to both sides by a force that grows until it moves."""
    name = joint["name"]
    lower, upper = ends(joint)
    span = upper - lower
    seen, most = [simulation.position(name)], _LEAST
    for side in (-1.0, 1.0):
        share = _LEAST
        for _ in range(round(_MOST / _TICK)):
            left = side * ((upper if side > 0.0 else lower) - seen[-1])
            if left <= _NEAR * span or not simulation.finite:
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


def posed(pose: Any) -> Any:
    """Return position and quaternion (x, y, z, w) as a frame, shape (4, 4)."""
    x, y, z, w = np.asarray(pose[3:], float) / np.linalg.norm(pose[3:])
    turn = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return transform(turn, pose[:3])


def in_base(frames: dict[str, Any], links: list[str]) -> dict[str, Any]:
    """Return the frames of links in the frame of the base, which is the first link."""
    base = np.linalg.inv(frames[links[0]])
    return {name: base @ frames[name] for name in links if name in frames}
