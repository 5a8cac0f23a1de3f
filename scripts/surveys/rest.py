"""One second of an asset that is let go, in MuJoCo: whatever is not at rest then has to have a cause."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Joint
from artgen.validate.behavior.model import Simulation, collected_warnings, fixed_model
from artgen.validate.behavior.settle import settle
from surveys.speed import STEP

TIME = 1.0
"""How long it is simulated [s]."""

FASTEST = 5.0
"""Speed that no point of a part reaches when an asset is let go [m/s]."""

TURNING = 20.0
"""A part that turns slower may be as long as it likes [rad/s]."""

BEYOND = {"revolute": 0.05, "prismatic": 0.005}
"""How far limits may give [rad or m]; more where a spring drives a part against them."""

_RISE = 1e-3  # of the energy, by rounding and the give of contacts [J]
_RISE_SHARE = 0.01  # of the largest kinetic energy, by the length of time steps


Oddity = tuple[str, str]
"""Kind and message of what is odd."""


@dataclass(frozen=True)
class _Course:
    """What was recorded, a row for each time step.

    Attributes:
        positions: Of the joints, shape (steps, n) [rad or m].
        speeds: Of the joints, shape (steps, n) [rad/s or m/s].
        energies: Potential and kinetic energy, shape (steps, 2) [J].
    """

    positions: Array
    speeds: Array
    energies: Array


def oddities(asset: Asset, mjcf: Path, urdf: Path) -> Iterator[Oddity]:
    """Yield what is odd when MuJoCo reads the files of an asset, lets it go and watches it for a second.

    Args:
        asset: The asset, with its base fixed to the world.
        mjcf: Its MJCF, which is simulated.
        urdf: Its URDF, which is only read.
    """
    import mujoco

    with collected_warnings() as warnings:
        mujoco.MjModel.from_xml_path(str(urdf))
        model = fixed_model(mjcf)
        settled = settle(Simulation(asset, model, warnings))
        for finding in settled.findings.values():
            if finding.severity == "fault":
                yield "settling", str(finding)
        model.opt.timestep = STEP
        model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        yield from _judged(asset, model, _run(model))
        for text in dict.fromkeys(each.split(" Time =")[0].strip() for each in warnings):
            yield "warning", f"MuJoCo warns: {text}"


def _run(model: Any) -> _Course:
    """Let go of everything at the model's own positions, and record how it goes on."""
    import mujoco

    data = mujoco.MjData(model)
    steps = round(TIME / STEP)
    positions, speeds = np.zeros((steps, model.nq)), np.zeros((steps, model.nv))
    energies = np.zeros((steps, 2))
    qpos, qvel, energy = data.qpos, data.qvel, data.energy  # views, which stay
    for step in range(steps):
        mujoco.mj_step(model, data)
        positions[step], speeds[step], energies[step] = qpos, qvel, energy
    return _Course(positions, speeds, energies)


def _judged(asset: Asset, model: Any, course: _Course) -> Iterator[Oddity]:
    """Yield what is odd of a course."""
    arrays = (course.positions, course.speeds, course.energies)
    if not all(np.isfinite(each).all() for each in arrays):
        yield "not finite", "positions, speeds or energies are not finite"
        return
    whole = course.energies.sum(axis=1)
    rise = float(whole.max() - whole[0])
    if rise > _RISE + _RISE_SHARE * float(course.energies[:, 1].max()):
        yield (
            "energy",
            f"the energy grows by {rise:.3g} J from {whole[0]:.6g} J though nothing pushes",
        )
    for joint in asset.joints:
        if joint.locked:
            continue
        found = model.joint(joint.name)
        turns = "rad" if joint.kind == "revolute" else "m"
        fastest = float(np.abs(course.speeds[:, found.dofadr[0]]).max())
        if _absurd(asset, joint, fastest):
            yield "speed", f"joint {joint.name}: moves at {fastest:.3g} {turns}/s when it is let go"
        if joint.limits is None:
            continue
        low, high = joint.limits
        way = course.positions[:, found.qposadr[0]]
        beyond = max(low - float(way.min()), float(way.max()) - high)
        if beyond > max(BEYOND[joint.kind], _give(model.jnt_solref[found.id], fastest)):
            yield "limits", f"joint {joint.name}: goes {beyond:.3g} {turns} beyond its limits"


def _give(stop: Array, speed: float) -> float:
    """Return how far a limit gives, at most, where it is struck at a speed [rad or m].

    Args:
        stop: The time constant of the spring that it is [s], and its damping, 1 where that is critical.
        speed: Of the joint [rad/s or m/s].
    """
    time, ratio = stop
    return float(time * ratio * speed / math.e)


def _absurd(asset: Asset, joint: Joint, speed: float) -> bool:
    """Tell whether a part that is let go cannot be as fast: small ones on a spring turn quickly."""
    if joint.kind == "prismatic":
        return speed > FASTEST
    corners = np.array(list(itertools.product(*asset.link(joint.child).bounds().T)))
    reach = float(np.linalg.norm(np.cross(corners - joint.pivot, joint.axis), axis=1).max())
    return speed > TURNING and speed * reach > FASTEST
