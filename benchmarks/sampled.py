"""The sampled protocol: overlaps of colliders at states of the joints, in MuJoCo.

The states are the rest state, 21 states of each joint alone, and 64 states of all joints from a Sobol
sequence. Joints that follow others are moved with them.
"""

import tempfile
import time
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.stats import qmc

Array = NDArray[np.float64]

OVERLAP = 1e-5
"""Depth from which colliders overlap [m]."""

EACH = 21
"""States of each joint alone."""

TOGETHER = 64
"""States of all joints together."""

_SLACK = 1e-6  # by which a follower may leave its own limits [rad or m]
_MEMORY = 1 << 29  # for contacts [bytes]
_COMPILER = {
    "strippath": "false",
    "fusestatic": "false",
    "balanceinertia": "true",
    "boundmass": "0.001",
    "boundinertia": "0.000001",
}


class NotLoadableError(Exception):
    """A file cannot be loaded alone."""


@dataclass(frozen=True)
class Deepest:
    """The deepest overlap of a protocol.

    Attributes:
        depth: Its depth; 0 if nothing overlaps [m].
        pair: The two geoms or bodies.
        state: Positions of the joints that are not at rest [rad or m].
    """

    depth: float = 0.0
    pair: tuple[str, str] = ("", "")
    state: Mapping[str, float] | None = None


@dataclass(frozen=True)
class Sampled:
    """The result for a file.

    Attributes:
        joints: Number of hinges and slides.
        states: Number of states that were examined; those that move a follower out of its limits are not.
        complete: Whether the time was enough for all states.
        as_filed: Deepest overlap of the pairs that the file lets collide.
        with_parents: The same with all pairs of colliders that move against each other.
    """

    joints: int
    states: int
    complete: bool
    as_filed: Deepest
    with_parents: Deepest


def sampled(path: Path, root: Path, *, seconds: float) -> Sampled:
    """Examine a file.

    Args:
        path: URDF or MJCF.
        root: Folder in which the packages that a URDF names are looked for.
        seconds: Time limit [s].

    Raises:
        NotLoadableError: MuJoCo does not compile the file alone.
    """
    return _protocol(path, root).run(seconds)


def deepest_at(path: Path, root: Path, pose: Mapping[str, float]) -> Deepest:
    """Return the deepest overlap at positions of joints, of all pairs that move against each other.

    Joints that are not named are at rest, or follow others.

    Raises:
        NotLoadableError: MuJoCo does not compile the file alone.
    """
    return _protocol(path, root).at(pose)


def _protocol(path: Path, root: Path) -> "_Protocol":
    robot = _robot(path)
    try:
        with tempfile.TemporaryDirectory() as folder:
            source = path if robot is None else _rewritten(robot, path, root, Path(folder))
            spec = mujoco.MjSpec.from_file(str(source))
            spec.memory = _MEMORY
            model = spec.compile()
    except (ValueError, OSError) as error:
        raise NotLoadableError(" ".join(str(error).split())[:300]) from None
    followers = _equalities(model) if robot is None else _mimics(model, robot)
    return _Protocol(model, followers, urdf=robot is not None)


def _robot(path: Path) -> ET.Element | None:
    """Return the element of a URDF, None if the file is an MJCF."""
    try:
        element = ET.parse(path).getroot()  # noqa: S314 - files of the packages that are measured
    except (ET.ParseError, OSError, ValueError) as error:
        raise NotLoadableError(f"it is not XML: {error}") from None
    return element if element.tag == "robot" else None


def _rewritten(robot: ET.Element, path: Path, root: Path, folder: Path) -> Path:
    """Write a URDF for MuJoCo: colliders only, all meshes as STL in one folder."""
    copies: dict[Path, str] = {}
    for link in robot.findall("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    for element in [*robot.findall("mujoco"), *robot.findall("transmission"), *robot.findall("gazebo")]:
        robot.remove(element)
    for mesh in robot.iter("mesh"):
        found = _resolved(mesh.get("filename", ""), path, root)
        if found not in copies:
            copies[found] = str(folder / f"mesh{len(copies)}.stl")
            try:
                trimesh.load(found, force="mesh").export(copies[found])
            except Exception as error:  # noqa: BLE001 - any error of a reader
                raise NotLoadableError(f"trimesh does not read {found.name}: {error}") from None
        mesh.set("filename", copies[found])
    ET.SubElement(ET.SubElement(robot, "mujoco"), "compiler", _COMPILER)
    out = folder / "robot.urdf"
    ET.ElementTree(robot).write(out)
    return out


def _resolved(name: str, path: Path, root: Path) -> Path:
    """Return the file that a URDF names: a package is a folder of that name, or the folder above."""
    bare = name.split("://", 1)[-1]
    tails = [bare, bare.partition("/")[2]] if "://" in name else [bare]
    for above in path.parents:
        for tail in filter(None, tails):
            if (above / tail).is_file():
                return above / tail
        if above == root or "://" not in name:
            break
    raise NotLoadableError(f"there is no mesh {name}")


Followers = Mapping[int, tuple[int, Array]]
"""Leader and polynomial of each joint that follows another one: q = sum(c[k] * leader ** k)."""


def _equalities(model: Any) -> Followers:
    found: dict[int, tuple[int, Array]] = {}
    for number in range(model.neq):
        first, second = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
        is_joint = model.eq_type[number] == mujoco.mjtEq.mjEQ_JOINT
        if is_joint and second >= 0 and model.eq_active0[number] and first not in found:
            found[first] = second, np.array(model.eq_data[number, :5])
    return found


def _mimics(model: Any, robot: ET.Element) -> Followers:
    found = {}
    for joint in robot.findall("joint"):
        mimic = joint.find("mimic")
        if mimic is None:
            continue
        numbers = [
            mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name or "")
            for name in (joint.get("name"), mimic.get("joint"))
        ]
        if min(numbers) >= 0:
            line = [float(mimic.get("offset", 0.0)), float(mimic.get("multiplier", 1.0)), 0.0, 0.0, 0.0]
            found[numbers[0]] = numbers[1], np.array(line)
    return found


class _Protocol:
    """States of a model, and its overlaps there."""

    def __init__(self, model: Any, followers: Followers, *, urdf: bool) -> None:
        self.model, self.followers, self.urdf = model, followers, urdf
        kinds = model.jnt_type
        moving = (kinds == mujoco.mjtJoint.mjJNT_HINGE) | (kinds == mujoco.mjtJoint.mjJNT_SLIDE)
        self.moving: list[int] = np.flatnonzero(moving).tolist()
        self.ranges = {number: self._range(number) for number in self.moving}
        self.groups = self._groups()
        self.kept = {mujoco.mjtGeom.mjGEOM_PLANE, mujoco.mjtGeom.mjGEOM_HFIELD}
        model.opt.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        model.geom_margin[:] = 0.0
        if model.npair:
            model.pair_margin[:] = 0.0

    def run(self, seconds: float) -> Sampled:
        """Examine all states, as far as the time suffices."""
        end = time.monotonic() + seconds
        states, complete = list(self._states()), True
        found = {}
        for opened in (False, True):
            if opened or self.urdf:
                self._open()
            found[opened], finished = self._deepest(states, end, parents=opened or not self.urdf)
            complete = complete and finished
        return Sampled(len(self.moving), len(states), complete, found[False], found[True])

    def at(self, pose: Mapping[str, float]) -> Deepest:
        """Examine the state with some positions of joints, limits and followers as they are given."""
        self._open()
        rest = self._rest()
        names = {self._name(number): number for number in self.moving}
        given = {names[name]: at for name, at in pose.items() if name in names}
        state = self._expanded(rest | given) or rest
        return self._deepest([rest, state | given], time.monotonic() + 60.0, parents=True, skipped=1)[0]

    def _range(self, number: int) -> tuple[float, float]:
        if self.model.jnt_limited[number]:
            low, high = self.model.jnt_range[number].tolist()
            return low, high
        turns = self.model.jnt_type[number] == mujoco.mjtJoint.mjJNT_HINGE
        return (-np.pi, np.pi) if turns else (0.0, 0.0)

    def _rest(self) -> dict[int, float]:
        rest = {}
        for number, (low, high) in self.ranges.items():
            rest[number] = min(max(self._zero(number), low), high)
        return rest

    def _zero(self, number: int) -> float:
        """Return the position of a joint at rest."""
        return float(self.model.qpos0[self.model.jnt_qposadr[number]])

    def _states(self) -> Iterator[dict[int, float]]:
        rest = self._rest()
        leaders = [number for number in self.moving if number not in self.followers]
        candidates = [rest]
        for number in leaders:
            candidates += [rest | {number: float(at)} for at in np.linspace(*self.ranges[number], EACH)]
        if leaders:
            low, high = np.array([self.ranges[number] for number in leaders]).T
            points = qmc.Sobol(len(leaders), seed=0).random(TOGETHER)
            for point in low + points * (high - low):
                candidates.append(rest | dict(zip(leaders, point.tolist(), strict=True)))
        for state in candidates:
            if (expanded := self._expanded(state)) is not None:
                yield expanded

    def _expanded(self, state: dict[int, float]) -> dict[int, float] | None:
        """Return a state with the followers moved; None if one leaves its limits."""
        state, waiting = dict(state), dict(self.followers)
        while waiting:
            ready = [number for number, (leader, _) in waiting.items() if leader not in waiting]
            if not ready:
                break
            for number in ready:
                leader, terms = waiting.pop(number)
                if number not in self.ranges or leader not in self.ranges:
                    continue
                zero = [0.0, 0.0]
                if not self.urdf:
                    zero = [
                        float(self.model.qpos0[self.model.jnt_qposadr[each]]) for each in (number, leader)
                    ]
                state[number] = zero[0] + float(np.polyval(terms[::-1], state[leader] - zero[1]))
                low, high = self.ranges[number]
                if not low - _SLACK <= state[number] <= high + _SLACK:
                    return None
        return state

    def _groups(self) -> list[int]:
        """Return for each body the body with a free or ball joint that carries it, or 0."""
        model = self.model
        groups = [0] * model.nbody
        for body in range(1, model.nbody):
            start = model.body_jntadr[body]
            kinds = model.jnt_type[start : start + model.body_jntnum[body]].tolist() if start >= 0 else []
            loose = model.body_mocapid[body] >= 0 or any(kind in (0, 1) for kind in kinds)
            groups[body] = body if loose else groups[model.body_parentid[body]]
        return groups

    def _open(self) -> None:
        """Let all colliders collide that move against each other."""
        model = self.model
        paired = {*model.pair_geom1.tolist(), *model.pair_geom2.tolist()}
        collides = (model.geom_contype | model.geom_conaffinity) != 0
        collides[list(paired)] = True
        collides &= ~np.isin(model.geom_type, [int(kind) for kind in self.kept])
        model.geom_contype[:] = model.geom_conaffinity[:] = collides
        model.body_contype[:] = model.body_conaffinity[:] = 1
        model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
        if model.nexclude:
            model.exclude_signature[:] = 0

    def _deepest(
        self, states: list[dict[int, float]], end: float, *, parents: bool, skipped: int = 0
    ) -> tuple[Deepest, bool]:
        model = self.model
        data = mujoco.MjData(model)
        deepest = Deepest()
        rest = states[0] if states else {}
        for state in states[skipped:]:
            if time.monotonic() > end:
                return deepest, False
            for number, at in state.items():
                data.qpos[model.jnt_qposadr[number]] = at
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_flex(model, data)
            mujoco.mj_collision(model, data)
            for one, two, depth in self._overlaps(data, parents=parents):
                if depth > deepest.depth:
                    moved = {self._name(each): at for each, at in state.items() if at != rest.get(each)}
                    deepest = Deepest(depth, (one, two), moved)
        return deepest, True

    def _overlaps(self, data: Any, *, parents: bool) -> Iterator[tuple[str, str, float]]:
        model = self.model
        if not data.ncon:
            return
        depths, geoms = -data.contact.dist, data.contact.geom
        for number in np.flatnonzero(depths > OVERLAP).tolist():
            first, second = geoms[number].tolist()
            if min(first, second) < 0 or {int(model.geom_type[each]) for each in (first, second)} & self.kept:
                continue
            bodies = [int(model.geom_bodyid[each]) for each in (first, second)]
            if self.groups[bodies[0]] != self.groups[bodies[1]]:
                continue
            one, two = (int(model.body_weldid[body]) for body in bodies)
            if one == two or (not parents and self._related(one, two)):
                continue
            names = sorted(
                (each, f"{model.body(body).name}/{model.geom(each).name or each}")
                for body, each in zip(bodies, (first, second), strict=True)
            )
            yield names[0][1], names[1][1], float(depths[number])

    def _related(self, one: int, two: int) -> bool:
        weld, parent = self.model.body_weldid, self.model.body_parentid
        return bool(weld[parent[one]] == two or weld[parent[two]] == one)

    def _name(self, number: int) -> str:
        return self.model.joint(number).name or f"joint_{number}"
