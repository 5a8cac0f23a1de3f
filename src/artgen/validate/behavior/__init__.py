"""Check of the behavior of an asset in MuJoCo: it stays, moves, springs back and blocks as declared."""

import math
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.asset.report import CheckResult, Finding
from artgen.validate.behavior.dependencies import block
from artgen.validate.behavior.drive import drive
from artgen.validate.behavior.model import (
    CHECK,
    Simulation,
    collected_warnings,
    fixed_model,
    joint_finding,
    standing_model,
)
from artgen.validate.behavior.settle import settle


def check_behavior(asset: Asset, directory: str | Path | None = None) -> CheckResult:
    """Simulate the MJCF of an asset in MuJoCo and compare its motion with the asset.

    The asset is released when it is closed, halfway open and open. Each free joint is driven from end to end
    by its own effort. Joints with springs are released at both ends. Joints with dependencies are pushed
    while their condition does not hold. A free base stands on a floor while it settles, and is fixed while
    joints move. Without the directory of an export, the asset is exported to a temporary directory.

    Returns:
        The findings; skipped if MuJoCo is not installed or the directory has no MJCF.
    """
    try:
        import mujoco  # noqa: F401 - only whether it is there
    except ImportError:
        return CheckResult(CHECK, skipped="needs artgen[sim]")
    if directory is None:
        with TemporaryDirectory() as folder:
            return _check(asset, asset.export(Path(folder) / asset.name, formats=("mjcf",)))
    return _check(asset, Path(directory))


def _check(asset: Asset, directory: Path) -> CheckResult:
    path = main_files(directory).get("mjcf")
    if path is None:
        return CheckResult(CHECK, skipped="there is no MJCF; export with 'mjcf' among the formats")
    with collected_warnings() as warnings:
        try:
            simulation = Simulation(asset, fixed_model(path), warnings)
            standing = Simulation(asset, standing_model(path), warnings) if asset.base == "free" else None
        except (KeyError, ValueError) as error:
            # MuJoCo names the faulty element; a joint or link that is missing in the file is a KeyError
            reason = " ".join(str(error.args[0] if error.args else error).split())
            finding = Finding(CHECK, f"MuJoCo cannot use {path.name}: {reason}", hint="export it again")
            return CheckResult(CHECK, (finding,))
        wrong = tuple(_disagreements(simulation))
        return CheckResult(CHECK, wrong) if wrong else _simulate(simulation, standing)


def _disagreements(simulation: Simulation) -> Iterator[Finding]:
    """Yield the joints whose limits differ between the file and the asset."""
    model, unlimited = simulation.model, (-math.inf, math.inf)
    for joint in simulation.asset.joints:
        if joint.locked:
            continue
        number = model.joint(joint.name).id
        found = model.jnt_range[number] if model.jnt_limited[number] else unlimited
        expected = joint.limits or unlimited
        if not np.allclose(found, expected, rtol=1e-6, atol=1e-9):
            spans = ["{:.6g} to {:.6g}".format(*limits) for limits in (found, expected)]
            message = f"has the range {spans[0]} in the file, and {spans[1]} in the asset"
            yield joint_finding(joint, message, "export it again")


def _simulate(simulation: Simulation, standing: Simulation | None) -> CheckResult:
    settled = settle(standing or simulation, stands=standing is not None)
    findings = list(settled.findings.values())
    for motion in simulation.motions.values():
        findings += drive(simulation, motion)
        findings += block(simulation, motion)
    for each in (simulation, standing):
        findings += each.findings.values() if each is not None else ()
    motions = list(simulation.motions.values())
    counts = {
        "sprung back": sum(motion.stiffness > 0.0 for motion in motions),
        "pushed while blocked": sum(any(each.needs for each in motion.members) for motion in motions),
        "couplings watched": sum(len(motion.members) - 1 for motion in motions),
    }
    parts = [f"released in {len(settled.poses)} poses", f"{len(motions)} joints driven"]
    parts += [f"{count} {text}" for text, count in counts.items() if count]
    if settled.movers:
        parts.append(f"moved by gravity or springs: {', '.join(sorted(settled.movers))}")
    return CheckResult(CHECK, tuple(findings), "; ".join(parts))
