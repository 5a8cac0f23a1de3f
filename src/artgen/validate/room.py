"""Check of a room of assets: exact solids in random states, rest in MuJoCo, and the forces of hands."""

import math
from collections.abc import Iterator, Mapping

import numpy as np

from artgen.asset import Asset
from artgen.asset.report import CheckResult, Finding, Severity
from artgen.proof.overlap import link_overlap
from artgen.proof.paths import space_of
from artgen.validate.hands.motion import MOST_FORCE, hand_forces
from artgen.validate.joints import force, length

CHECK = "room"

SETTLE_TIME, WATCH_TIME = 1.0, 3.0
"""Time to settle, and time of the observation after it, as in MolmoSpaces with the two bounds below [s]."""

MOST_WAY = 0.05
"""Largest motion of a free body during the observation [m]."""

MOST_SHARE = 0.1
"""Largest motion of a joint during the observation, as a share of its range."""

LIGHT_FORCE = 20.0
"""Force at a handle above which a joint has a note [N]."""

_STATES = 200  # random states
_STEPS = 50  # steps between two looks at the simulation


def check_room(asset: Asset) -> CheckResult:
    """Check a room: no solids overlap in 200 random states, it stays at rest, and hands can open its joints.

    The states are valid ones. Free objects are where they were placed; in simulation they are free.

    Returns:
        A fault for each pair of links that overlap, for each body or joint that moves by itself, and for each
        joint that needs more than 60 N; a note for a joint that needs more than 20 N. The part about rest is
        left out if MuJoCo is not installed.
    """
    forces = hand_forces(asset)
    findings = [*overlaps(asset, _STATES), *_forces(asset, forces)]
    parts = [f"exact solids in {_STATES} states", f"{len(forces)} joints opened by hands"]
    try:
        import mujoco  # noqa: F401 - only whether it is there
    except ImportError:
        parts.append("not simulated: needs artgen[sim]")
    else:
        findings += motions_at_rest(asset)
        parts.append(f"watched for {WATCH_TIME:g} s")
    return CheckResult(CHECK, tuple(findings), "; ".join(parts))


def overlaps(asset: Asset, count: int) -> Iterator[Finding]:
    """Yield the pairs of links whose exact solids overlap in one of several random valid states.

    Args:
        asset: The asset; the boxes around its links select the pairs, and no proof is used.
        count: Number of states.
    """
    paths = space_of(asset).joint_paths()
    names = list(asset.links.by_name)
    ends = np.array([[names.index(link) for link in path.links] for path in paths]).reshape(-1, 2)
    corners = np.array(
        [np.stack(np.meshgrid(*link.bounds().T), axis=-1).reshape(-1, 3) for link in asset.links]
    )
    found: set[tuple[str, str]] = set()
    for row in asset.sample_states(count):
        q = dict(zip(asset.dof_names, row.tolist(), strict=True))
        positions, poses = asset.positions(q), asset.pose(q)
        placed = np.array([poses[name] for name in names])
        moved = np.einsum("nij,nkj->nki", placed[:, :3, :3], corners) + placed[:, None, :3, 3]
        low, high = moved.min(axis=1), moved.max(axis=1)
        first, second = ends.T
        near = (low[first] < high[second]).all(axis=1) & (high[first] > low[second]).all(axis=1)
        for path in (paths[number] for number in np.flatnonzero(near)):
            if path.links in found:
                continue
            overlap = link_overlap(asset, path, np.array([positions[name] for name in path.variables]))
            if overlap is not None:
                found.add(path.links)
                a, b = overlap.labels
                yield Finding(
                    CHECK,
                    f"{a} and {b} overlap by {1e9 * overlap.volume:.3g} mm3",
                    ", ".join(path.links),
                    value=overlap.volume,
                    unit="m3",
                    pose={name: positions[name] for name in path.variables},
                    hint="place the assets farther apart and build the room again",
                )


def motions_at_rest(asset: Asset) -> Iterator[Finding]:
    """Yield the free bodies and joints that move while a room is simulated for 3 s, after 1 s to settle.

    The room is simulated in MuJoCo, closed. Needs artgen[sim].
    """
    import mujoco

    model = asset.to_mjspec(textures=0).compile()
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=round(SETTLE_TIME / model.opt.timestep))
    bodies = {name: data.body(name).xpos for name in asset.loose}
    joints = {joint.name: data.joint(joint.name).qpos for joint in asset.joints if not joint.locked}
    start = {name: value.copy() for name, value in (bodies | joints).items()}
    most = dict.fromkeys(start, 0.0)
    for _ in range(math.ceil(WATCH_TIME / (_STEPS * model.opt.timestep))):
        mujoco.mj_step(model, data, nstep=_STEPS)
        for name, value in (bodies | joints).items():
            most[name] = max(most[name], float(np.abs(value - start[name]).max()))
    for name in asset.loose:
        if not most[name] <= MOST_WAY:
            message = f"moves by {1e3 * most[name]:.3g} mm in {WATCH_TIME:g} s, though nothing pushes it"
            yield Finding(CHECK, message, name, value=most[name], unit="m", hint="give it a better place")
    for joint in map(asset.joint, joints):
        low, high = joint.limits or (-math.pi, math.pi)
        if not most[joint.name] <= MOST_SHARE * (high - low):
            message = f"moves by {length(joint, most[joint.name])} in {WATCH_TIME:g} s by itself"
            yield Finding(CHECK, message, joint.child, joint.name, most[joint.name])


def _forces(asset: Asset, forces: Mapping[str, float]) -> Iterator[Finding]:
    for name, most in forces.items():
        if most > LIGHT_FORCE:
            joint = asset.joint(name)
            message = f"needs {most:.3g} N at its handle, against {force(joint, joint.friction)} of friction"
            severity: Severity = "fault" if most > MOST_FORCE else "note"
            yield Finding(CHECK, message, joint.child, name, most, "N", severity=severity)
