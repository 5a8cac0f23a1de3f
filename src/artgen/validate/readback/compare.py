"""Differences between an asset and the values that a reader found in a file or a simulator."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen._arrays import Array, cached_property
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.joint import DYNAMICS
from artgen.asset.report import CHANGED, Finding
from artgen.errors import ArtgenError
from artgen.export.frames import FAR, local
from artgen.validate.readback.pieces import ReadCollider, expected_pieces, piece_findings
from artgen.validate.readback.reading import Faces, Reading

EXACT = 1e-6
"""Tolerance of numbers [m, rad]; relative for masses, moments and gains."""

POSES = 5
"""Number of random poses in which frames are compared, in addition to the rest pose."""

_FACES = 1e-5  # tolerance of the bounds of visible faces [m]
_LIGHT = 1e-4  # share of the mass that bodies between joints and marks of grasps may add
_ROUNDING = 1e-6  # relative, of moments of inertia
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


def expected_frames(asset: Asset, q: Mapping[str, float]) -> dict[str, Array]:
    """Return the frame of each link, shape (4, 4), at positions of the free joints."""
    result = {}
    for name, displacement in asset.pose(q).items():
        result[name] = displacement.copy()
        result[name][:3, 3] += displacement[:3, :3] @ asset.origin(name)
    return result


def sampled_positions(asset: Asset, count: int) -> list[dict[str, float]]:
    """Return the rest pose and a number of random poses of the free joints."""
    draw = np.random.default_rng(0)
    spans = {joint.name: joint.limits or (-np.pi, np.pi) for joint in asset.free_joints}
    drawn = [{name: float(draw.uniform(*span)) for name, span in spans.items()} for _ in range(count)]
    return [{}, *drawn]


class Expected:
    """Expected values of the files of an asset, computed once for all formats.

    Args:
        asset: The asset.
        poses: Number of random poses.
    """

    def __init__(self, asset: Asset, poses: int = POSES) -> None:
        self.asset = asset
        self._count = poses

    @cached_property
    def pieces(self) -> dict[str, tuple[ReadCollider, ...]]:
        """The colliders of each link."""
        return expected_pieces(self.asset, capsules=True)

    @cached_property
    def pieces_without_capsules(self) -> dict[str, tuple[ReadCollider, ...]]:
        """The same, with a cylinder and two balls for each capsule."""
        if all(item.convex.kind != "capsule" for link in self.asset.links for item in link.colliders):
            return self.pieces
        return expected_pieces(self.asset, capsules=False)

    @cached_property
    def faces(self) -> dict[str, tuple[Faces, ...]] | None:
        """The visible faces of each link; None if they cannot be read, which the check of solids reports."""
        try:
            return {
                link.name: tuple(
                    Faces.of(
                        each.name, each.mesh.vertices - self.asset.origin(link.name), each.mesh.triangles
                    )
                    for each in link.surfaces
                )
                for link in self.asset.links
            }
        except (ArtgenError, ValueError):
            return None

    @cached_property
    def poses(self) -> list[tuple[dict[str, float], dict[str, float], dict[str, Array]]]:
        """Positions of the free joints, positions of all joints, and the frames of the links."""
        drawn = sampled_positions(self.asset, self._count)
        return [(q, self.asset.positions(q), expected_frames(self.asset, q)) for q in drawn]


def moments_fault(moments: Any) -> str:
    """Return why principal moments, shape (3,) [kg m^2], are impossible; empty if they are possible."""
    low, middle, high = sorted(moments)
    shown = ", ".join(f"{moment:.4g}" for moment in (low, middle, high))
    if not low > 0.0:
        return f"its principal moments {shown} kg m^2 are not all positive"
    if low + middle < high * (1.0 - _ROUNDING):
        return f"its principal moments {shown} kg m^2 violate the triangle inequality"
    return ""


@dataclass(frozen=True, eq=False)
class Comparison:
    """The comparison of an asset with the values of one reader."""

    check: str  # name of the check or of the simulator
    expected: Expected  # values of the asset
    reading: Reading  # values that were read
    form: str  # format of the file: `urdf`, `mjcf`, `usd` or `glb`
    length: float = EXACT  # tolerance of lengths and angles [m, rad]
    relative: float = EXACT  # relative tolerance of masses, moments and gains
    hint: str = CHANGED  # remedy of every difference

    def differences(self) -> Iterator[Finding]:
        """Yield all differences."""
        asset, reading = self.expected.asset, self.reading
        pieces = self.expected.pieces_without_capsules if self.form == "urdf" else self.expected.pieces
        yield from self._whole()
        for link in asset.links if "links" in reading.told else ():
            yield from self._mass(link)
            if link.name in reading.colliders:
                found = reading.colliders[link.name]
                yield from piece_findings(self.check, link, reading.file, pieces[link.name], found)
            if link.name in reading.faces and self.expected.faces is not None:
                yield from self._faces(link, self.expected.faces[link.name], reading.faces[link.name])
        if "joints" in reading.told:
            yield from self._joints()
        if "couplings" in reading.told:
            yield from self._couplings()
        yield from self._holds()
        if "poses" in reading.told:
            yield from self._poses()

    def _fault(self, message: str, **where: Any) -> Finding:
        return Finding(self.check, message, hint=self.hint, **where)

    @cached_property
    def _must(self) -> set[str]:
        """The links that the reader has to know: of a partial reading, those that joints move."""
        asset = self.expected.asset
        if not self.reading.partial:
            return {link.name for link in asset.links}
        return {child for _, child, joints in asset.pairs() if not joints[-1].locked}

    def _whole(self) -> Iterator[Finding]:
        asset, reading = self.expected.asset, self.reading
        if reading.base and reading.base != asset.base:
            message = f"the base is {reading.base} in {reading.file}, not {asset.base}"
            yield self._fault(message, link=asset.links[0].name)
        named = sum(found.mass for found in reading.inertials.values())
        if reading.mass is not None and not abs(reading.mass - named) <= _LIGHT * asset.mass:
            more = reading.mass - named
            message = f"bodies that are not links of the asset weigh {more:.4g} kg in {reading.file}"
            yield self._fault(message, value=more, unit="kg")

    def _mass(self, link: Link) -> Iterator[Finding]:
        found, wanted = self.reading.inertials.get(link.name), link.mass_properties
        file, name = self.reading.file, link.name
        if found is None:
            if name in self._must:
                yield self._fault(f"{file} has no such link with a mass", link=name)
            return
        if not abs(found.mass - wanted.mass) <= self.relative * wanted.mass:
            message = f"its mass is {found.mass:.7g} kg in {file}, not {wanted.mass:.7g} kg"
            yield self._fault(message, link=name, value=found.mass, unit="kg")
        if found.center is not None:
            center = wanted.center - self.expected.asset.origin(name)
            away = float(np.abs(found.center - center).max())
            if not away <= self.length:
                message = f"its center of mass is {1e3 * away:.4g} mm away in {file}"
                yield self._fault(message, link=name, value=away, unit="m")
        if found.inertia is not None:
            scale = max(float(np.abs(wanted.inertia).max()), 1e-9)
            error = float(np.abs(found.inertia - wanted.inertia).max()) / scale
            if not error <= 2.0 * self.relative:
                finite = np.isfinite(found.inertia).all()
                fault = moments_fault(np.linalg.eigvalsh(found.inertia)) if finite else ""
                message = f"its inertia differs by {100.0 * error:.4g} % in {file}"
                yield self._fault(f"{message}; {fault}" if fault else message, link=name, value=error)

    def _faces(self, link: Link, wanted: tuple[Faces, ...], found: tuple[Faces, ...]) -> Iterator[Finding]:
        """Compare the meshes of a link: each has to have its triangles in the place of the asset's."""
        remaining, file = list(found), self.reading.file
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
                yield self._fault(message, link=link.name, value=away, unit="m")
            elif nearest.count != faces.count:
                counts = f"{nearest.count} triangles in {file}, not {faces.count}"
                message = f"its visible faces {nearest.name} have {counts}"
                yield self._fault(message, link=link.name, value=float(nearest.count))
        if len(found) != len(wanted):
            message = f"it has {len(found)} meshes of visible faces in {file}, not {len(wanted)}"
            yield self._fault(message, link=link.name, value=float(len(found)))

    def _joints(self) -> Iterator[Finding]:
        reading = self.reading
        moving = {joint.name: joint for joint in self.expected.asset.joints if not joint.locked}
        for name in reading.kinds.keys() - moving.keys():
            message = f"it can move in {reading.file}, but is not a moving joint of the asset"
            yield self._fault(message, joint=name)
        for name, joint in moving.items():
            kind = reading.kinds.get(name)
            if kind is None:
                yield self._fault(f"{reading.file} has no such joint that can move", joint=name)
                continue
            yield from self._ends(joint)
            if kind != joint.kind:
                yield self._fault(f"it is {kind} in {reading.file}, not {joint.kind}", joint=name)
                continue
            if name in reading.axes:
                error = float(np.abs(reading.axes[name] - joint.axis).max())
                if not error <= self.length:
                    message = f"its axis differs by {error:.4g} in {reading.file}"
                    yield self._fault(message, joint=name, value=error)
            if name in reading.limits:
                yield from self._limits(joint, reading.limits[name])
            yield from self._dynamics(joint)

    def _ends(self, joint: AssetJoint) -> Iterator[Finding]:
        """Compare the links of a joint; between several joints of two links are bodies without a name."""
        asset = self.expected.asset
        links = {link.name for link in asset.links}
        alone = sum((each.parent, each.child) == (joint.parent, joint.child) for each in asset.joints) == 1
        found, wanted = self.reading.ends.get(joint.name), (joint.parent, joint.child)
        if found is None or found == wanted:
            return
        strange = any(end in links and end not in wanted for end in found)
        if alone or strange or found[0] == joint.child or found[1] == joint.parent:
            message = (
                f"it joins {found[1]!r} to {found[0]!r} in {self.reading.file}, "
                f"not {wanted[1]!r} to {wanted[0]!r}"
            )
            yield self._fault(message, joint=joint.name)

    def _limits(self, joint: AssetJoint, found: tuple[float, float] | None) -> Iterator[Finding]:
        wanted = joint.limits
        if self.form == "urdf" and joint.kind == "prismatic" and wanted is None:
            wanted = (-FAR, FAR)  # URDF requires limits of a prismatic joint
        error = None
        same = found is None and wanted is None
        if found is not None and wanted is not None:
            error = float(np.abs(np.subtract(found, wanted)).max())
            same = error <= self.length * max(1.0, *map(abs, wanted))
        if not same:
            unit = "rad" if joint.kind == "revolute" else "m"
            said, right = (
                "none" if limits is None else f"{limits[0]:.7g} to {limits[1]:.7g} {unit}"
                for limits in (found, wanted)
            )
            message = f"its limits are {said} in {self.reading.file}, not {right}"
            yield self._fault(message, joint=joint.name, value=error, unit=unit)

    def _dynamics(self, joint: AssetJoint) -> Iterator[Finding]:
        """Compare springs, dampers, friction, effort and speed."""
        said, file = self.reading.dynamics.get(joint.name), self.reading.file
        if said is None:
            return
        missing = set(_STATED.get(self.check, ())) - {item.field for item in said}
        for field in DYNAMICS:
            wanted = float(getattr(joint, field))
            unit = _UNITS[field][joint.kind == "prismatic"]
            if field in missing and wanted != 0.0:
                message = f"{file} does not say its {field}, which is {wanted:.7g} {unit}"
                yield self._fault(message, joint=joint.name, value=0.0, unit=unit)
            slack = self.relative * max(abs(wanted), 1e-3)
            if field == "rest":
                if not joint.stiffness:
                    continue  # without a spring, its rest position has no effect
                slack = self.length * max(1.0, abs(wanted))
            for item in said:
                if item.field == field and not abs(item.value - wanted) <= slack:
                    message = (
                        f"its {field} is {item.value:.7g} {unit} in {file} ({item.source}), not "
                        f"{wanted:.7g} {unit}"
                    )
                    yield self._fault(message, joint=joint.name, value=item.value, unit=unit)

    def _couplings(self) -> Iterator[Finding]:
        asset, reading = self.expected.asset, self.reading
        following = {joint.name for joint in asset.joints if joint.follows is not None and not joint.locked}
        told = {reading.file: reading.couplings}
        told |= {f"{reading.file} (for {name})": laws for name, laws in reading.more_couplings.items()}
        for file, laws in told.items():
            for name in sorted(following - laws.keys()):
                yield self._fault(f"it follows another joint, but not in {file}", joint=name)
            for name in sorted(laws.keys() - following):
                message = f"it follows {laws[name][0]!r} in {file}, but not in the asset"
                yield self._fault(message, joint=name)
            for name in sorted(following & laws.keys()):
                yield from self._law(name, laws[name], file)

    def _law(self, name: str, found: tuple[str, float, float], file: str) -> Iterator[Finding]:
        leader, ratio, offset = found
        wanted = law_to(self.expected.asset, name, leader)
        if wanted is None:
            yield self._fault(f"it follows {leader!r} in {file}, which does not lead it", joint=name)
        elif not np.allclose((ratio, offset), wanted, rtol=self.relative, atol=self.length):
            message = (
                f"it is {ratio:.7g} * {leader} + {offset:.7g} in {file}, "
                f"not {wanted[0]:.7g} * {leader} + {wanted[1]:.7g}"
            )
            yield self._fault(message, joint=name, value=ratio)

    def _holds(self) -> Iterator[Finding]:
        if self.reading.holds is None:
            return
        asset, file = self.expected.asset, self.reading.file
        for hold in asset.affordances:
            if hold.name not in self.reading.holds:
                yield self._fault(f"{file} has no frame of the {hold.kind} {hold.name!r}", link=hold.link)
                continue
            link, frame = self.reading.holds[hold.name]
            away = float(np.abs(frame - local(asset, hold.link, hold.frame)).max())
            if link != hold.link or not away <= 2.0 * self.length:
                off = f"is off by {away:.4g} (m or radians) on {link!r} in {file}"
                yield self._fault(f"its {hold.kind} {hold.name!r} {off}", link=hold.link, value=away)

    def _poses(self) -> Iterator[Finding]:
        """Yield the links whose frames differ, each at its worst pose."""
        reading, poses = self.reading, self.expected.poses
        tolerance = self.length if reading.partial else 2.0 * self.length
        worst: dict[str, tuple[float, dict[str, float]]] = {}
        lost: set[str] = set()
        for q, positions, wanted in poses:
            found = reading.frames(positions)
            lost |= (
                self._must & (wanted.keys() if reading.partial else reading.inertials.keys()) - found.keys()
            )
            for name in found.keys() - reading.misplaced:
                error = float(np.abs(found[name] - wanted[name]).max())
                if not error <= worst.get(name, (tolerance, {}))[0]:
                    worst[name] = (error, q)
        for name in sorted(worst):
            error, q = worst[name]
            message = f"its frame is off by {error:.4g} (m or radians) in {reading.file}"
            yield self._fault(message, link=name, value=error, pose=q)
        for name in sorted(lost):
            yield self._fault(f"no joints lead to it from the base in {reading.file}", link=name)
        for name, frame in reading.standing.items():
            error = float(np.abs(frame - poses[0][2][name]).max())
            if not error <= tolerance:
                message = (
                    f"its body stands {error:.4g} (m or radians) off in {reading.file}, "
                    "wherever its joints lead"
                )
                yield self._fault(message, link=name, value=error)


def _apart(first: Faces, second: Faces) -> float:
    return float(np.nan_to_num(np.abs(first.bounds - second.bounds).max(), nan=1e9))


def law_to(asset: Asset, name: str, leader: str) -> tuple[float, float] | None:
    """Return ratio and offset of a joint to a leader along its chain; None if that does not lead it."""
    if name == leader:
        return 1.0, 0.0
    follows = asset.joint(name).follows
    above = None if follows is None else law_to(asset, follows.leader, leader)
    if follows is None or above is None:
        return None
    return follows.ratio * above[0], follows.ratio * above[1] + follows.offset
