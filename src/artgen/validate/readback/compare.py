"""Differences between an asset and the values that a reader found in a file."""

from collections.abc import Iterator

import numpy as np

from artgen._arrays import Array, cached_property
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.joint import DYNAMICS
from artgen.asset.report import CHANGED, Finding
from artgen.errors import ArtgenError
from artgen.export.frames import local
from artgen.validate.readback.mjcf_structure import moments_fault
from artgen.validate.readback.pieces import ReadCollider, expected_pieces, piece_findings
from artgen.validate.readback.reading import (
    Faces,
    Reading,
    expected_frames,
    expected_limits,
    sampled_positions,
    spelled_limits,
)

EXACT = 1e-6
"""What numbers may differ by [m, rad], and relative for masses, moments and gains."""

POSES = 5
"""Poses drawn at random in which frames are compared, beside the one in which the asset stands."""

_FACES = 1e-5  # [m] by which the bounds of visible faces may differ: files have 0.1 micrometre
_LIGHT = 1e-4  # relative, of the whole mass: bodies between joints and marks of grasps weigh a little
_STATED = {
    "urdf": ("damping", "friction", "effort", "velocity", "stiffness"),
    "mjcf": ("damping", "friction", "effort", "stiffness", "armature"),
    "usd": ("damping", "friction", "stiffness", "armature"),
}  # fmt: skip
_UNITS = {
    "stiffness": ("N m/rad", "N/m"),
    "damping": ("N m s/rad", "N s/m"),
    "friction": ("N m", "N"),
    "rest": ("rad", "m"),
    "armature": ("kg m^2", "kg"),
    "effort": ("N m", "N"),
    "velocity": ("rad/s", "m/s"),
}


class Expected:
    """The expected values of the files of an asset, computed once for all formats.

    Args:
        asset: The asset.
    """

    def __init__(self, asset: Asset) -> None:
        self.asset = asset

    @cached_property
    def pieces(self) -> dict[str, tuple[ReadCollider, ...]]:
        """The colliders of each link."""
        return expected_pieces(self.asset, capsules=True)

    @cached_property
    def pieces_without_capsules(self) -> dict[str, tuple[ReadCollider, ...]]:
        """The same, each capsule as a cylinder between two balls."""
        if all(item.convex.kind != "capsule" for link in self.asset.links for item in link.colliders):
            return self.pieces
        return expected_pieces(self.asset, capsules=False)

    @cached_property
    def faces(self) -> dict[str, tuple[Faces, ...]] | None:
        """The visible faces of each link; None where they are not stored."""
        result = {}
        try:
            for link in self.asset.links:
                origin = self.asset.origin(link.name)
                result[link.name] = tuple(
                    Faces(each.name, _bounds(each.mesh.vertices) - origin, len(each.mesh.triangles))
                    for each in link.surfaces
                )
        except (ArtgenError, ValueError):
            return None  # the check of solids tells which files are missing
        return result

    @cached_property
    def poses(self) -> list[tuple[dict[str, float], dict[str, float], dict[str, Array]]]:
        """Positions of the free joints, of all joints, and the frames of the links there."""
        drawn = sampled_positions(self.asset, POSES)
        return [(q, self.asset.positions(q), expected_frames(self.asset, q)) for q in drawn]


def _bounds(vertices: Array) -> Array:
    return np.array([vertices.min(axis=0), vertices.max(axis=0)])


def differences(check: str, expected: Expected, reading: Reading) -> Iterator[Finding]:
    """Yield how a file differs from the asset.

    Args:
        check: Name of the check: `urdf`, `mjcf` or `usd`.
        expected: What it should say.
        reading: What it says.
    """
    asset = expected.asset
    pieces = expected.pieces_without_capsules if check == "urdf" else expected.pieces
    yield from _whole_findings(check, asset, reading)
    for link in asset.links:
        yield from _mass_findings(check, asset, link, reading)
        if link.name in reading.colliders:
            found = reading.colliders[link.name]
            yield from piece_findings(check, link, reading.file, pieces[link.name], found)
        if expected.faces is not None and link.name in reading.faces:
            wanted = expected.faces[link.name]
            yield from _face_findings(check, link, reading.file, wanted, reading.faces[link.name])
    yield from _joint_findings(check, asset, reading)
    yield from _coupling_findings(check, asset, reading)
    yield from _hold_findings(check, asset, reading)
    yield from _pose_findings(check, expected, reading)


def _whole_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    base = asset.links[0].name
    if reading.base and reading.base != asset.base:
        yield Finding(
            check, f"the base is {reading.base} in {reading.file}, not {asset.base}", base, hint=CHANGED
        )
    wanted = sum(link.mass_properties.mass for link in asset.links)
    named = sum(found.mass for found in reading.inertials.values())
    if reading.mass is not None and not abs(reading.mass - named) <= _LIGHT * wanted:
        message = (
            f"bodies that are no links of the asset weigh {reading.mass - named:.4g} kg in {reading.file}"
        )
        yield Finding(check, message, value=reading.mass - named, unit="kg", hint=CHANGED)


def _mass_findings(check: str, asset: Asset, link: Link, reading: Reading) -> Iterator[Finding]:
    found, wanted, file = reading.inertials.get(link.name), link.mass_properties, reading.file
    if found is None:
        yield Finding(check, f"{file} has no such link with a mass", link.name, hint=CHANGED)
        return
    if not abs(found.mass - wanted.mass) <= EXACT * wanted.mass:
        message = f"its mass is {found.mass:.7g} kg in {file}, not {wanted.mass:.7g} kg"
        yield Finding(check, message, link.name, value=found.mass, unit="kg", hint=CHANGED)
    away = float(np.abs(found.center - (wanted.center - asset.origin(link.name))).max())
    if not away <= EXACT:
        message = f"its center of mass is {1e3 * away:.4g} mm away in {file}"
        yield Finding(check, message, link.name, value=away, unit="m", hint=CHANGED)
    scale = max(float(np.abs(wanted.inertia).max()), 1e-9)
    error = float(np.abs(found.inertia - wanted.inertia).max()) / scale
    if not error <= 2.0 * EXACT:
        message = f"its inertia differs by {100.0 * error:.4g} % in {file}"
        fault = moments_fault(np.linalg.eigvalsh(found.inertia)) if np.isfinite(found.inertia).all() else ""
        message = f"{message}; {fault}" if fault else message
        yield Finding(check, message, link.name, value=error, hint=CHANGED)


def _face_findings(
    check: str, link: Link, file: str, wanted: tuple[Faces, ...], found: tuple[Faces, ...]
) -> Iterator[Finding]:
    """Compare the visible faces of a link: each mesh must have its triangles where the asset has them."""
    remaining = list(found)
    for faces in wanted:
        if not remaining:
            break
        # two meshes of one part may have the same bounds, such as the faces and the edges of a board
        nearest = min(
            remaining, key=lambda each: (max(_apart(faces, each), _FACES), abs(faces.count - each.count))
        )
        remaining.remove(nearest)
        away = _apart(faces, nearest)
        if not away <= _FACES:
            message = f"its visible faces {nearest.name} are off by {1e3 * away:.4g} mm in {file}"
            yield Finding(check, message, link.name, value=away, unit="m", hint=CHANGED)
        elif nearest.count != faces.count:
            counts = f"{nearest.count} triangles in {file}, not {faces.count}"
            message = f"its visible faces {nearest.name} have {counts}"
            yield Finding(check, message, link.name, value=float(nearest.count), hint=CHANGED)
    if len(found) != len(wanted):
        message = f"it has {len(found)} meshes of visible faces in {file}, not {len(wanted)}"
        yield Finding(check, message, link.name, value=float(len(found)), hint=CHANGED)


def _apart(first: Faces, second: Faces) -> float:
    return float(np.nan_to_num(np.abs(first.bounds - second.bounds).max(), nan=1e9))


def _joint_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    moving = {joint.name: joint for joint in asset.joints if not joint.locked}
    for name in reading.kinds:
        if name not in moving:
            message = f"it can move in {reading.file}, but is no moving joint of the asset"
            yield Finding(check, message, joint=name, hint=CHANGED)
    for name, joint in moving.items():
        if name not in reading.kinds:
            yield Finding(check, f"{reading.file} has no such joint that can move", joint=name, hint=CHANGED)
            continue
        yield from _end_findings(check, asset, joint, reading)
        if reading.kinds[name] != joint.kind:
            message = f"it is {reading.kinds[name]} in {reading.file}, not {joint.kind}"
            yield Finding(check, message, joint=name, hint=CHANGED)
            continue
        if name in reading.axes:
            error = float(np.abs(reading.axes[name] - joint.axis).max())
            if not error <= EXACT:
                message = f"its axis differs by {error:.4g} in {reading.file}"
                yield Finding(check, message, joint=name, value=error, hint=CHANGED)
        yield from _limit_findings(check, joint, reading)
        yield from _dynamics_findings(check, joint, reading)


def _end_findings(check: str, asset: Asset, joint: AssetJoint, reading: Reading) -> Iterator[Finding]:
    """Compare the links that a joint joins; between the joints of one pair of links are bodies of no name."""
    links = {link.name for link in asset.links}
    alone = sum((each.parent, each.child) == (joint.parent, joint.child) for each in asset.joints) == 1
    found, wanted = reading.ends.get(joint.name), (joint.parent, joint.child)
    if found is None or found == wanted:
        return
    strange = any(end in links and end not in wanted for end in found)
    if alone or strange or found[0] == joint.child or found[1] == joint.parent:
        message = (
            f"it joins {found[1]!r} to {found[0]!r} in {reading.file}, not {wanted[1]!r} to {wanted[0]!r}"
        )
        yield Finding(check, message, joint=joint.name, hint=CHANGED)


def _limit_findings(check: str, joint: AssetJoint, reading: Reading) -> Iterator[Finding]:
    found, wanted = reading.limits[joint.name], expected_limits(check, joint)
    same = (found is None) == (wanted is None)
    error = None
    if found is not None and wanted is not None:
        error = float(np.abs(np.subtract(found, wanted)).max())
        same = error <= EXACT * max(1.0, *map(abs, wanted))
    if not same:
        unit = "rad" if joint.kind == "revolute" else "m"
        said, right = spelled_limits(found, unit), spelled_limits(wanted, unit)
        message = f"its limits are {said} in {reading.file}, not {right}"
        yield Finding(check, message, joint=joint.name, value=error, unit=unit, hint=CHANGED)


def _dynamics_findings(check: str, joint: AssetJoint, reading: Reading) -> Iterator[Finding]:
    """Compare springs, dampers, friction, effort and speed."""
    said = reading.dynamics.get(joint.name)
    if said is None:
        return
    missing = set(_STATED.get(check, ())) - {item.field for item in said}
    for field in DYNAMICS:
        wanted = float(getattr(joint, field))
        unit = _UNITS[field][joint.kind == "prismatic"]
        if field in missing and wanted != 0.0:
            message = f"{reading.file} does not say its {field}, which is {wanted:.7g} {unit}"
            yield Finding(check, message, joint=joint.name, value=0.0, unit=unit, hint=CHANGED)
        for item in said:
            if item.field != field or (field == "rest" and not joint.stiffness):
                continue  # without a spring it does not matter where it would be at ease
            if not abs(item.value - wanted) <= EXACT * max(abs(wanted), 1e-3):
                message = (
                    f"its {field} is {item.value:.7g} {unit} in {reading.file} ({item.source}), not "
                    f"{wanted:.7g} {unit}"
                )
                yield Finding(check, message, joint=joint.name, value=item.value, unit=unit, hint=CHANGED)


def _coupling_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    following = {joint.name for joint in asset.joints if joint.follows is not None and not joint.locked}
    told = {reading.file: reading.couplings}
    told |= {f"{reading.file} (for {name})": laws for name, laws in reading.more_couplings.items()}
    for file, laws in told.items():
        for name in sorted(following ^ set(laws)):
            message = (
                f"it follows another joint, but not in {file}"
                if name in following
                else f"it follows {laws[name][0]!r} in {file}, but not in the asset"
            )
            yield Finding(check, message, joint=name, hint=CHANGED)
        for name in sorted(following & set(laws)):
            yield from _law_findings(check, asset, name, laws[name], file)


def _law_findings(
    check: str, asset: Asset, name: str, found: tuple[str, float, float], file: str
) -> Iterator[Finding]:
    leader, ratio, offset = found
    wanted = _law(asset, name, leader) if leader in {joint.name for joint in asset.joints} else None
    if wanted is None:
        message = f"it follows {leader!r} in {file}, which does not lead it"
        yield Finding(check, message, joint=name, hint=CHANGED)
    elif not np.allclose((ratio, offset), wanted, rtol=EXACT, atol=EXACT):
        message = (
            f"it is {ratio:.7g} * {leader} + {offset:.7g} in {file}, "
            f"not {wanted[0]:.7g} * {leader} + {wanted[1]:.7g}"
        )
        yield Finding(check, message, joint=name, value=ratio, hint=CHANGED)


def _law(asset: Asset, name: str, leader: str) -> tuple[float, float] | None:
    """Return ratio and offset of a joint to a leader, near or far along its chain; None if it is none."""
    if name == leader:
        return 1.0, 0.0
    follows = asset.joint(name).follows
    above = None if follows is None else _law(asset, follows.leader, leader)
    if follows is None or above is None:
        return None
    return follows.ratio * above[0], follows.ratio * above[1] + follows.offset


def _hold_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    if reading.holds is None:
        return
    for hold in asset.affordances:
        found = reading.holds.get(hold.name)
        if found is None:
            message = f"{reading.file} has no frame of the {hold.kind} {hold.name!r}"
            yield Finding(check, message, hold.link, hint=CHANGED)
            continue
        link, frame = found
        away = float(np.abs(frame - local(asset, hold.link, hold.frame)).max())
        if link != hold.link or not away <= 2.0 * EXACT:
            off = f"is off by {away:.4g} (m or radians) on {link!r} in {reading.file}"
            message = f"its {hold.kind} {hold.name!r} {off}"
            yield Finding(check, message, hold.link, value=away, hint=CHANGED)


def _pose_findings(check: str, expected: Expected, reading: Reading) -> Iterator[Finding]:
    """Yield the links whose frames are elsewhere, each at the pose where it is worst."""
    worst: dict[str, tuple[float, dict[str, float]]] = {}
    lost: set[str] = set()
    for q, positions, wanted in expected.poses:
        found = reading.frames(positions)
        lost |= set(reading.inertials) & set(wanted) - set(found)
        for name, frame in found.items():
            error = float(np.abs(frame - wanted[name]).max())
            if not error <= worst.get(name, (2.0 * EXACT, {}))[0]:
                worst[name] = (error, q)
    for name, (error, q) in worst.items():
        message = f"its frame is off by {error:.4g} (m or radians) in {reading.file}"
        yield Finding(check, message, name, value=error, pose=q, hint=CHANGED)
    for name in sorted(lost):
        yield Finding(check, f"no joints lead to it from the base in {reading.file}", name, hint=CHANGED)
    _, _, standing = expected.poses[0]
    for name, frame in reading.standing.items():
        error = float(np.abs(frame - standing[name]).max())
        if not error <= 2.0 * EXACT:
            message = (
                f"its body stands {error:.4g} (m or radians) off in {reading.file}, wherever its joints lead"
            )
            yield Finding(check, message, name, value=error, hint=CHANGED)
