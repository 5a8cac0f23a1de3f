"""Simulate a released asset for one second in MuJoCo: any motion has to have a cause."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.validate.behavior.model import Simulation, collected_warnings, fixed_model
from artgen.validate.behavior.settle import settle
from surveys.speed import STEP

TIME = 1.0
"""Simulated time [s]."""

FASTEST = 5.0
"""Speed that no point of a released asset reaches [m/s]."""

TURNING = 20.0
"""Angular velocity below which a part of any length is plausible [rad/s]."""

BEYOND = {"revolute": 0.05, "prismatic": 0.005}
"""Allowed violation of limits [rad or m]; more for a part on a spring."""

_RISE = 1e-3  # allowed rise of the energy by rounding and soft contacts [J]
_RISE_SHARE = 0.01  # allowed rise by the time step, over the largest kinetic energy


Oddity = tuple[str, str]
"""Kind and message of an anomaly."""


@dataclass(frozen=True)
class _Course:
    """The recorded motion, a row for each time step."""

    positions: Array  # positions of the joints, shape (steps, n) [rad or m]
    speeds: Array  # speeds of the joints, shape (steps, n) [rad/s or m/s]
    energies: Array  # potential and kinetic energy, shape (steps, 2) [J]


def oddities(asset: Asset, mjcf: Path, urdf: Path) -> Iterator[Oddity]:
    """Yield the anomalies when MuJoCo reads the files of an asset and simulates it for a second."""
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
    """Release all joints at the positions of the model, and record the motion."""
    import mujoco

    data = mujoco.MjData(model)
    steps = round(TIME / STEP)
    positions, speeds = np.zeros((steps, model.nq)), np.zeros((steps, model.nv))
    energies = np.zeros((steps, 2))
    qpos, qvel, energy = data.qpos, data.qvel, data.energy  # permanent views
    for step in range(steps):
        mujoco.mj_step(model, data)
        positions[step], speeds[step], energies[step] = qpos, qvel, energy
    return _Course(positions, speeds, energies)


def _judged(asset: Asset, model: Any, course: _Course) -> Iterator[Oddity]:
    """Yield the anomalies of a motion."""
    arrays = (course.positions, course.speeds, course.energies)
    if not all(np.isfinite(each).all() for each in arrays):
        yield "not finite", "positions, speeds or energies are not finite"
        return
    whole = course.energies.sum(axis=1)
    rise = float(whole.max() - whole[0])
    if rise > _RISE + _RISE_SHARE * float(course.energies[:, 1].max()):
        yield ("energy", f"the energy grows by {rise:.3g} J from {whole[0]:.6g} J though nothing pushes")
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
        path = course.positions[:, found.qposadr[0]]
        beyond = max(low - float(path.min()), float(path.max()) - high)
        if beyond > max(BEYOND[joint.kind], _give(model.jnt_solref[found.id], fastest)):
            yield "limits", f"joint {joint.name}: goes {beyond:.3g} {turns} beyond its limits"


def _give(stop: Array, speed: float) -> float:
    """Return the largest violation of a limit that is struck at a speed [rad or m]."""
    time, ratio = stop
    return float(time * ratio * speed / math.e)


def _absurd(asset: Asset, joint: AssetJoint, speed: float) -> bool:
    """Tell whether a released part is too fast: small parts on a spring turn quickly."""
    if joint.kind == "prismatic":
        return speed > FASTEST
    corners = np.array(list(itertools.product(*asset.link(joint.child).bounds().T)))
    reach = float(np.linalg.norm(np.cross(corners - joint.pivot, joint.axis), axis=1).max())
    return speed > TURNING and speed * reach > FASTEST
