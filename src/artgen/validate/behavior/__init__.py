"""Check of the behavior of an asset in MuJoCo: it stays, moves, springs back and blocks as declared."""

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from artgen._arrays import Array
from artgen._names import ByName
from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.asset.joint import joints_above
from artgen.asset.report import CheckResult, Finding
from artgen.validate.behavior.dependencies import block
from artgen.validate.behavior.drive import drive
from artgen.validate.behavior.model import (
    CHECK,
    Simulation,
    collected_warnings,
    fixed_model,
    joint_finding,
    owners_of,
    room_model,
    standing_model,
)
from artgen.validate.behavior.settle import settle

_CLEAR = 0.01  # distance within which assets of a room are neighbors [m]
_STEPS = 17  # positions of a joint in which a link is enclosed
_UNLIMITED = {"revolute": (0.0, math.tau), "prismatic": (-1.0, 1.0)}  # [rad or m]


def check_behavior(asset: Asset, directory: str | Path | None = None) -> CheckResult:
    """Simulate the MJCF of an asset in MuJoCo and compare its motion with the asset.

    The asset is released when it is closed, halfway open and open. Each free joint is driven from end to end
    by its own effort, in a room together with all assets that it may touch. Joints with springs are released
    at both ends, joints that close softly within the reach of their damper and behind it. Joints with
    dependencies are pushed while their condition does not hold. A free base stands on a floor while it
    settles, and is fixed while joints move; free bodies in a room are fixed to what carries them. Without the
    directory of an export, the asset is exported to a temporary directory.

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
            model = room_model(path, asset) if asset.is_room else fixed_model(path)
            simulation = Simulation(asset, model, warnings)
            standing = Simulation(asset, standing_model(path), warnings) if asset.base == "free" else None
        except (KeyError, ValueError) as error:
            # MuJoCo names the faulty element; a joint or link that is missing in the file is a KeyError
            reason = " ".join(str(error.args[0] if error.args else error).split())
            finding = Finding(CHECK, f"MuJoCo cannot use {path.name}: {reason}", hint="export it again")
            return CheckResult(CHECK, (finding,))
        wrong = tuple(_disagreements(simulation))
        return CheckResult(CHECK, wrong) if wrong else _simulate(simulation, standing, path)


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


def _simulate(simulation: Simulation, standing: Simulation | None, path: Path) -> CheckResult:
    settled = settle(standing or simulation, stands=standing is not None)
    findings = list(settled.findings.values())
    noticed = dict(standing.findings) if standing is not None else {}
    for names, part in neighborhoods(simulation.asset):
        near = simulation
        if part is not simulation.asset:
            near = Simulation(part, room_model(path, part), simulation.warnings)
        for motion in map(near.motions.__getitem__, names):
            findings += drive(near, motion)
            findings += block(near, motion)
        noticed = near.findings | noticed
    findings += (simulation.findings | noticed).values()
    motions = list(simulation.motions.values())
    counts = {
        "sprung back": sum(motion.stiffness > 0.0 for motion in motions),
        "closed softly": sum(motion.joint.closing is not None for motion in motions),
        "pushed while blocked": sum(any(each.needs for each in motion.members) for motion in motions),
        "couplings watched": sum(len(motion.members) - 1 for motion in motions),
    }
    parts = [f"released in {len(settled.poses)} poses", f"{len(motions)} joints driven"]
    parts += [f"{count} {text}" for text, count in counts.items() if count]
    if settled.movers:
        parts.append(f"moved by gravity or springs: {', '.join(sorted(settled.movers))}")
    return CheckResult(CHECK, tuple(findings), "; ".join(parts))


def neighborhoods(asset: Asset) -> Iterator[tuple[list[str], Asset]]:
    """Yield names of free joints, and the part of an asset with all that they may touch.

    A room is divided into the assets in it. Two are neighbors if their links come within 10 mm of each other
    in any positions of their joints, or if a joint of one depends on the other. An asset that is no room is
    not divided.
    """
    if not asset.is_room:
        yield [joint.name for joint in asset.free_joints], asset
        return
    owners, base = owners_of(asset), asset.links[0].name
    free: dict[str, list[str]] = {}
    for joint in asset.free_joints:
        free.setdefault(owners[joint.child], []).append(joint.name)
    boxes = {link.name: _reached(asset, link.name) for link in asset.links}
    for owner, names in free.items():
        own = [boxes[link] for link, of in owners.items() if of == owner]
        found = {base, owner}
        found |= {owners[link] for link, box in boxes.items() if any(_near(box, each) for each in own)}
        while more := _needed(asset, owners, found) - found:
            found |= more
        yield names, _part(asset, {link for link, of in owners.items() if of in found})


def _part(asset: Asset, links: set[str]) -> Asset:
    """Return the part of an asset that consists of some of its links."""
    return replace(
        asset,
        links=ByName(each for each in asset.links if each.name in links),
        joints=ByName(each for each in asset.joints if each.child in links),
        contacts=tuple(each for each in asset.contacts if links >= {*each.links}),
        loops=tuple(each for each in asset.loops if links >= {*each.links}),
        loose=tuple(each for each in asset.loose if each in links),
    )


def _needed(asset: Asset, owners: Mapping[str, str], found: Collection[str]) -> set[str]:
    """Return the owners of the joints on which joints of some owners depend."""
    needs = (each.needs for each in asset.joints if owners[each.child] in found)
    names = {name for each in needs if each is not None for name in each.condition.joints()}
    return {owners[asset.joint(name).child] for name in names}


def _near(first: Array, second: Array) -> bool:
    return bool((first[0] < second[1] + _CLEAR).all() and (second[0] < first[1] + _CLEAR).all())


def _reached(asset: Asset, link: str) -> Array:
    """Return a box around a link in all positions of the joints above it, shape (2, 3) [m]."""
    box = asset.link(link).bounds()
    for joint in joints_above(asset.joints, link):
        low, high = joint.limits or _UNLIMITED[joint.kind]
        corners = np.array(np.meshgrid(*box.T)).reshape(3, -1).T
        steps = np.linspace(low, high, _STEPS)
        moved = [corners @ motion[:3, :3].T + motion[:3, 3] for motion in map(joint.motion, steps.tolist())]
        box = np.array([np.min(moved, axis=(0, 1)), np.max(moved, axis=(0, 1))])
        if joint.kind == "revolute":  # between two steps an arc is farther out than both
            away = corners - joint.pivot
            radius = np.linalg.norm(away - np.outer(away @ joint.axis, joint.axis), axis=1).max()
            bow = radius * (1.0 - math.cos((high - low) / (_STEPS - 1) / 2.0))
            box += np.array([[-bow], [bow]])
    return box
