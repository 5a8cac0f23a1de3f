"""Check of outputs: each one follows its controls, and the material that it lights up is on the asset."""

from collections.abc import Iterator

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.report import CheckResult, Finding
from artgen.asset.signals import AssetOutput
from artgen.export.frames import leader_of

_STATES = 400  # steps in which the controls are used
_PAUSE = 0.5  # seconds between two steps
_TURN = 2.0  # position of a control without limits [rad or m]


def check_outputs(asset: Asset) -> CheckResult:
    """Check the outputs of an asset: its controls are used at random, at the ends of their ranges.

    Returns:
        A fault for each output that has the same value whatever its controls do, or a material that no
        part has, or that moves a joint that is not free or not that fast. With independent limits, which
        lock joints, values are not judged.
    """
    values = used(asset, asset.outputs)
    findings = [
        Finding(
            "outputs",
            f"output {output.name!r} stays {seen[0]:g}, whatever its controls {_listed(output)} do",
            hint="look at its signal: may the controls reach it, and does `unless` leave it a chance?",
        )
        for output, seen in zip(asset.outputs, values.T, strict=True)
        if len(values) and asset.limits == "full" and np.ptp(seen) < 0.01
    ]
    findings += _dark(asset)  # coarser levels leave lamps out that are only seen
    findings += _held(asset)
    controls = {name for output in asset.outputs for name in output.signal.joints()}
    return CheckResult(
        "outputs", tuple(findings), f"{len(asset.outputs)} outputs of {len(controls)} controls"
    )


def used(asset: Asset, outputs: tuple[AssetOutput, ...], seed: int = 0) -> Array:
    """Return the values of outputs while their controls are used, shape (steps, outputs).

    Each control, and each joint on which a control depends, goes from one end of its range to the other or
    stays, at random.
    """
    if not outputs:
        return np.zeros((0, 0))
    random, names = np.random.default_rng(seed), set[str]()
    for name in (name for output in outputs for name in output.signal.joints()):
        joint = asset.joint(name)
        needs = () if joint.needs is None else joint.needs.condition.joints()
        names |= {leader_of(asset, asset.joint(each))[0] for each in (name, *needs)}
    dofs, columns = asset.dof_names, []
    for name in dofs:
        joint = asset.joint(name)
        ends = [joint.closed, joint.opened, *(joint.limits or (_TURN, -_TURN))]
        columns.append(random.choice(ends, _STATES) if name in names else np.full(_STATES, joint.closed))
    controller = asset.controller()
    rows = asset.project(np.stack(columns, axis=-1))
    seen = [controller.step(row, _PAUSE) for row in (asset.project(np.zeros(len(dofs))), *rows)]
    return np.array([[values[output.name][0] for output in outputs] for values in seen])


def _listed(output: AssetOutput) -> str:
    return ", ".join(output.signal.joints())


def _dark(asset: Asset) -> Iterator[Finding]:
    """Yield a fault for each material of an output that no part has."""
    seen = {each.name for each in asset.materials}
    for output in asset.outputs:
        if output.material is not None and output.material not in seen and asset.detail == "full":
            yield Finding(
                "outputs",
                f"output {output.name!r} lights up the material {output.material!r}, which no part has",
                hint="give it the material of the part that shines",
            )


def _held(asset: Asset) -> Iterator[Finding]:
    """Yield a fault for each motor of a joint that is not free, or not that fast."""
    free = {joint.name: joint for joint in asset.free_joints}
    for output in (each for each in asset.outputs if each.joint is not None):
        joint = free.get(output.joint or "")
        if joint is None:
            yield Finding(
                "outputs",
                f"output {output.name!r} moves joint {output.joint!r}, which is locked or follows another",
                joint=output.joint or "",
                hint="name the joint that leads",
            )
        elif abs(output.speed or 0.0) > joint.velocity:
            yield Finding(
                "outputs",
                f"output {output.name!r} moves joint {joint.name!r} at {output.speed:g}, beyond its velocity "
                f"of {joint.velocity:g}",
                joint=joint.name,
                hint="give the joint that velocity",
            )
