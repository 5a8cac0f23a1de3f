"""Differences between an asset and the values that a reader found in a file or a simulator."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from artgen._arrays import Array, cached_property
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.joint import DYNAMICS
from artgen.asset.report import CHANGED, Finding
from artgen.colliders import Convex
from artgen.errors import ArtgenError
from artgen.export.frames import FAR, local, translation
from artgen.export.hulls import hulls
from artgen.export.urdf import primitives
from artgen.validate.joints import unit
from artgen.validate.readback.reading import UNLIMITED, Faces, Law, ReadCollider, Reading, ReadJoint, dent

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
_APART = 5e-6  # tolerance of bounds of colliders: some formats have single precision [m]
_VOLUME = 1e-3  # relative, for the same reason: pieces are thin
_INSIDE = 1e-6  # tolerance of vertices inside the hull of the others [m]
_SHOWN = 3  # most colliders of a link in findings


def expected_frames(asset: Asset, q: Mapping[str, float]) -> dict[str, Array]:
    """Return the frame of each link, shape (4, 4), at positions of the free joints."""
    return {name: moved @ translation(asset.origin(name)) for name, moved in asset.pose(q).items()}


class Expected:
    """Expected values of the files of an asset, computed once for all formats."""

    def __init__(self, asset: Asset, poses: int = POSES) -> None:
        self.asset = asset
        self._count = poses

    @cached_property
    def pieces(self) -> dict[str, tuple[ReadCollider, ...]]:
        """The colliders of each link."""
        return _expected_pieces(self.asset, capsules=True)

    @cached_property
    def pieces_without_capsules(self) -> dict[str, tuple[ReadCollider, ...]]:
        """The same, with a cylinder and two balls for each capsule."""
        kinds = {item.convex.kind for link in self.asset.links for item in link.colliders}
        return _expected_pieces(self.asset, capsules=False) if "capsule" in kinds else self.pieces

    @cached_property
    def faces(self) -> dict[str, tuple[Faces, ...]] | None:
        """The visible faces of each link; None if they cannot be read, which the check of solids reports."""
        result = {}
        try:
            for link in self.asset.links:
                origin = self.asset.origin(link.name)
                result[link.name] = tuple(
                    Faces.of(each.name, each.mesh.vertices - origin, each.mesh.triangles)
                    for each in link.surfaces
                )
        except (ArtgenError, ValueError):
            return None
        return result

    @cached_property
    def poses(self) -> list[tuple[dict[str, float], dict[str, float], dict[str, Array]]]:
        """Positions of free joints, positions of all joints, and frames of links: at rest, then random."""
        draw = np.random.default_rng(0)
        spans = {joint.name: joint.limits or (-np.pi, np.pi) for joint in self.asset.free_joints}
        drawn = [
            {name: float(draw.uniform(*span)) for name, span in spans.items()} for _ in range(self._count)
        ]
        return [(q, self.asset.positions(q), expected_frames(self.asset, q)) for q in ({}, *drawn)]


def _expected_pieces(asset: Asset, *, capsules: bool) -> dict[str, tuple[ReadCollider, ...]]:
    """Return the colliders that a file should have; without capsules, a cylinder between two balls each."""
    made = hulls(asset)
    result = {}
    for link in asset.links:
        away = translation(-asset.origin(link.name))
        pieces: list[ReadCollider] = []
        for number, collider in enumerate(link.colliders):
            convex, friction = collider.convex, collider.material.friction
            name = f"{number} ({convex.kind} of {collider.label!r})"
            if convex.kind == "hull":
                hull = made[link.name][number]
                pieces.append(ReadCollider.mesh(name, hull.placed, hull.triangles, friction))
                continue
            placed = Convex(convex.kind, away @ convex.pose, convex.size)
            split = [placed] if capsules else [piece for _, piece in primitives(placed)]
            pieces += [ReadCollider.primitive(name, each, friction) for each in split]
        result[link.name] = tuple(pieces)
    return result


def _moments_fault(inertia: Array) -> str:
    """Return why an inertia, shape (3, 3) [kg m^2], is impossible; empty if it is possible."""
    if not np.isfinite(inertia).all():
        return ""
    low, middle, high = np.linalg.eigvalsh(inertia)
    text = f"; its principal moments {low:.4g}, {middle:.4g}, {high:.4g} kg m^2"
    if not low > 0.0:
        return f"{text} are not all positive"
    return f"{text} violate the triangle inequality" if low + middle < high * (1.0 - _ROUNDING) else ""


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
        for link in asset.links if "links" in reading.parts else ():
            name = link.name
            yield from self._mass(link)
            if name in reading.colliders:
                yield from self._colliders(name, pieces[name], reading.colliders[name])
            if name in reading.faces and self.expected.faces is not None:
                yield from self._faces(name, self.expected.faces[name], reading.faces[name])
        if "joints" in reading.parts:
            yield from self._joints()
        if "couplings" in reading.parts:
            yield from self._couplings()
        yield from self._holds()
        if "poses" in reading.parts:
            yield from self._poses()

    def _fault(self, message: str, **where: Any) -> Finding:
        return Finding(self.check, message, hint=self.hint, **where)

    def _other(self, found: str, wanted: str, **where: Any) -> Finding:
        """Return the finding for a value that differs from that of the asset."""
        return self._fault(f"{found} in {self.reading.file}, not {wanted}", **where)

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
            yield self._other(f"the base is {reading.base}", asset.base, link=asset.links[0].name)
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
        fault = partial(self._fault, link=name)
        if not abs(found.mass - wanted.mass) <= self.relative * wanted.mass:
            texts = (f"its mass is {found.mass:.7g} kg", f"{wanted.mass:.7g} kg")
            yield self._other(*texts, link=name, value=found.mass, unit="kg")
        if found.center is not None:
            away = _error(found.center, wanted.center - self.expected.asset.origin(name))
            if not away <= self.length:
                yield fault(f"its center of mass is {1e3 * away:.4g} mm away in {file}", value=away, unit="m")
        if found.inertia is not None:
            scale = max(float(np.abs(wanted.inertia).max()), 1e-9)
            error = _error(found.inertia, wanted.inertia) / scale
            if not error <= 2.0 * self.relative:
                message = f"its inertia differs by {100.0 * error:.4g} % in {file}"
                yield fault(message + _moments_fault(found.inertia), value=error)

    def _colliders(
        self, link: str, wanted: Sequence[ReadCollider], found: Sequence[ReadCollider]
    ) -> Iterator[Finding]:
        """Compare the colliders of a link, paired so that they differ least."""
        from scipy.optimize import linear_sum_assignment

        file, count = self.reading.file, len(found)
        complaints: list[tuple[str, float | None]] = [
            (f"its collider {piece.name} {piece.flaw} in {file}", None) for piece in found if piece.flaw
        ]
        first, second = (
            np.array([[*piece.bounds.ravel(), *piece.middle] for piece in pieces]).reshape(-1, 9)
            for pieces in (wanted, found)
        )
        away = np.nan_to_num(np.abs(first[:, None] - second[None]).max(axis=2), nan=1e9, posinf=1e9)
        pairs = list(zip(*linear_sum_assignment(away), strict=True))
        if count != len(wanted):
            message = f"it has {count} colliders in {file}, not {len(wanted)}"
            same = [pair for pair in pairs if away[pair] <= _APART]
            for text, pieces, known in (
                ("without", wanted, {row for row, _ in same}),
                ("but also", found, {column for _, column in same}),
            ):
                names = [piece.name for number, piece in enumerate(pieces) if number not in known]
                message += f", {text} {', '.join(names[:_SHOWN])}" if names else ""
            yield self._fault(message, link=link, value=float(count))
        else:
            for pair in pairs:
                piece = found[pair[1]]
                if not piece.flaw:
                    complaints += _collider_differences(wanted[pair[0]], piece, float(away[pair]), file)
        for message, value in complaints[:_SHOWN]:
            yield self._fault(message, link=link, value=value)
        if len(complaints) > _SHOWN:
            message = f"{len(complaints) - _SHOWN} more of its colliders differ in {file}"
            yield self._fault(message, link=link, value=float(len(complaints)))

    def _faces(self, link: str, wanted: Sequence[Faces], found: Sequence[Faces]) -> Iterator[Finding]:
        """Compare the meshes of a link: each has to have its triangles in the place of the asset's."""
        remaining, file = list(found), self.reading.file
        for faces in wanted[: len(found)]:
            # two meshes of one part may have the same bounds, such as the faces and the edges of a board
            nearest = min(
                remaining, key=lambda each: (max(_apart(faces, each), _FACES), abs(faces.count - each.count))
            )
            remaining.remove(nearest)
            away = _apart(faces, nearest)
            name = f"its visible faces {nearest.name}"
            if not away <= _FACES:
                message = f"{name} are off by {1e3 * away:.4g} mm in {file}"
                yield self._fault(message, link=link, value=away, unit="m")
            elif nearest.count != faces.count:
                text = f"{name} have {nearest.count} triangles"
                yield self._other(text, str(faces.count), link=link, value=float(nearest.count))
        if len(found) != len(wanted):
            text = f"it has {len(found)} meshes of visible faces"
            yield self._other(text, str(len(wanted)), link=link, value=float(len(found)))

    def _joints(self) -> Iterator[Finding]:
        file, read = self.reading.file, self.reading.joints
        moving = {joint.name: joint for joint in self.expected.asset.joints if not joint.locked}
        for name in read.keys() - moving.keys():
            message = f"it can move in {file}, but is not a moving joint of the asset"
            yield self._fault(message, joint=name)
        for name, joint in moving.items():
            found = read.get(name)
            if found is None:
                yield self._fault(f"{file} has no such joint that can move", joint=name)
                continue
            yield from self._ends(joint, found.ends)
            if found.kind != joint.kind:
                yield self._other(f"it is {found.kind}", joint.kind, joint=name)
                continue
            if found.axis is not None:
                error = _error(found.axis, joint.axis)
                if not error <= self.length:
                    yield self._fault(f"its axis differs by {error:.4g} in {file}", joint=name, value=error)
            yield from self._limits(joint, found.limits)
            yield from self._dynamics(joint, found)

    def _ends(self, joint: AssetJoint, found: tuple[str, str] | None) -> Iterator[Finding]:
        """Compare the links of a joint; a body between two joints of one pair of links is not a link."""
        asset, wanted = self.expected.asset, (joint.parent, joint.child)
        if found is None or found == wanted:
            return
        alone = sum((each.parent, each.child) == wanted for each in asset.joints) == 1
        strange = {*found} & {link.name for link in asset.links} - {*wanted}
        if alone or strange or found[0] == joint.child or found[1] == joint.parent:
            texts = [f"{child!r} to {parent!r}" for parent, child in (found, wanted)]
            yield self._other(f"it joins {texts[0]}", texts[1], joint=joint.name)

    def _limits(self, joint: AssetJoint, found: tuple[float, float] | None) -> Iterator[Finding]:
        wanted = joint.limits or UNLIMITED
        if self.form == "urdf" and joint.kind == "prismatic" and joint.limits is None:
            wanted = (-FAR, FAR)  # URDF requires limits of a prismatic joint
        if found is None or found == wanted:
            return
        error = _error(found, wanted)
        if not error <= self.length * max(1.0, *map(abs, wanted)) or np.isinf(error):
            texts = [
                f"{low:.7g} to {high:.7g} {unit(joint)}" if np.isfinite([low, high]).any() else "none"
                for low, high in (found, wanted)
            ]
            value, text = error if np.isfinite(error) else None, f"its limits are {texts[0]}"
            yield self._other(text, texts[1], joint=joint.name, value=value, unit=unit(joint))

    def _dynamics(self, joint: AssetJoint, found: ReadJoint) -> Iterator[Finding]:
        """Compare springs, dampers, friction, effort and speed."""
        file = self.reading.file
        if found.dynamics is None:
            return
        missing = set(_STATED.get(self.check, ())) - {item.field for item in found.dynamics}
        for field in DYNAMICS:
            wanted = float(getattr(joint, field))
            name = unit(joint, field)
            fault = partial(self._fault, joint=joint.name, unit=name)
            if field in missing and wanted != 0.0:
                yield fault(f"{file} does not state its {field}, which is {wanted:.7g} {name}", value=0.0)
            slack = self.relative * max(abs(wanted), 1e-3)
            if field == "rest":
                if not joint.stiffness:
                    continue  # without a spring, its rest position has no effect
                slack = self.length * max(1.0, abs(wanted))
            for item in found.dynamics:
                if item.field == field and not abs(item.value - wanted) <= slack:
                    text = f"its {field} is {item.value:.7g} {name} in {file} ({item.source})"
                    yield fault(f"{text}, not {wanted:.7g} {name}", value=item.value)

    def _couplings(self) -> Iterator[Finding]:
        asset, reading = self.expected.asset, self.reading
        following = {
            joint.name
            for joint in asset.joints
            if joint.follows is not None and joint.follows.curve is None and not joint.locked
        }
        read = {reading.file: reading.couplings}
        read |= {f"{reading.file} (for {name})": laws for name, laws in reading.more_couplings.items()}
        for file, laws in read.items():
            for name in sorted(following | laws.keys()):
                if name not in laws:
                    yield self._fault(f"it follows another joint, but not in {file}", joint=name)
                elif name in following:
                    yield from self._law(name, laws[name], file)
                else:
                    message = f"it follows {laws[name][0]!r} in {file}, but not in the asset"
                    yield self._fault(message, joint=name)

    def _law(self, name: str, found: Law, file: str) -> Iterator[Finding]:
        leader, ratio, offset = found
        wanted = _law_to(self.expected.asset, name, leader)
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
            away = _error(frame, local(asset, hold.link, hold.frame))
            if link != hold.link or not away <= 2.0 * self.length:
                off = f"is off by {away:.4g} (m or radians) on {link!r} in {file}"
                yield self._fault(f"its {hold.kind} {hold.name!r} {off}", link=hold.link, value=away)

    def _poses(self) -> Iterator[Finding]:
        """Yield the links whose frames differ, each at its worst pose."""
        reading, poses = self.reading, self.expected.poses
        tolerance = self.length if reading.partial else 2.0 * self.length
        worst: dict[str, tuple[float, dict[str, float]]] = {}
        lost: set[str] = set()
        known = self._must if reading.partial else self._must & reading.inertials.keys()
        for q, positions, wanted in poses:
            found = reading.frames(positions)
            lost |= known - found.keys()
            for name in found.keys() - reading.misplaced:
                error = _error(found[name], wanted[name])
                if not error <= worst.get(name, (tolerance, {}))[0]:
                    worst[name] = (error, q)
        for name in sorted(worst):
            error, q = worst[name]
            message = f"its frame is off by {error:.4g} (m or radians) in {reading.file}"
            yield self._fault(message, link=name, value=error, pose=q)
        for name in sorted(lost):
            yield self._fault(f"no joints lead to it from the base in {reading.file}", link=name)
        for name, frame in reading.placements.items():
            error = _error(frame, poses[0][2][name])
            if not error <= tolerance:
                off = f"stands {error:.4g} (m or radians) off in {reading.file}"
                yield self._fault(f"its body {off}, wherever its joints lead", link=name, value=error)


def _collider_differences(
    wanted: ReadCollider, found: ReadCollider, away: float, file: str
) -> Iterator[tuple[str, float | None]]:
    name = f"its collider {found.name}"
    volumes = f"{1e6 * found.volume:.5g} cm^3 in {file}, not {1e6 * wanted.volume:.5g} cm^3"
    same_volume = abs(found.volume - wanted.volume) <= _VOLUME * wanted.volume
    same = away <= _APART and same_volume
    depth = None if same or not len(found.vertices) else dent(found.vertices)
    if depth is not None and depth > _INSIDE:
        yield f"{name} is not convex in {file}: a vertex lies {1e3 * depth:.4g} mm inside its hull", depth
    elif not away <= _APART:
        yield f"{name} is off by {1e3 * away:.4g} mm and has {volumes}", away
    elif not same_volume:
        yield f"{name} has {volumes}", found.volume
    if found.friction is None or wanted.friction is None:
        return
    if not abs(found.friction - wanted.friction) <= EXACT:
        yield f"{name} has friction {found.friction:.4g} in {file}, not {wanted.friction:.4g}", found.friction


def _error(found: Any, wanted: Any) -> float:
    """Return the largest difference of two arrays."""
    return float(np.abs(np.subtract(found, wanted)).max())


def _apart(first: Faces, second: Faces) -> float:
    return float(np.nan_to_num(_error(first.bounds, second.bounds), nan=1e9))


def _law_to(asset: Asset, name: str, leader: str) -> tuple[float, float] | None:
    """Return ratio and offset of a joint to a leader along its chain; None if that does not lead it."""
    if name == leader:
        return 1.0, 0.0
    follows = asset.joint(name).follows
    if follows is None or follows.curve is not None:
        return None
    above = _law_to(asset, follows.leader, leader)
    if above is None:
        return None
    return follows.ratio * above[0], follows.ratio * above[1] + follows.offset
