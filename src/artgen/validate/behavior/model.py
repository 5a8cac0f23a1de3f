"""An exported asset in MuJoCo: loading, joints with their followers, couplings, contacts."""

import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array, Indices, Mask, affine, cached_property
from artgen.asset import Asset, AssetCondition, AssetCoupling, AssetJoint
from artgen.asset.report import Finding, Severity
from artgen.errors import AssetError
from artgen.export.frames import quaternion
from artgen.export.names import read_names
from artgen.validate.joints import led_by, length, unit


@contextmanager
def collected_warnings() -> Iterator[list[str]]:
    """Collect the warnings of MuJoCo, which it would print and write to a file."""
    import mujoco

    before = mujoco.get_mju_user_warning()
    found: list[str] = []
    mujoco.set_mju_user_warning(found.append)
    try:
        yield found
    finally:
        mujoco.set_mju_user_warning(before)


_STEP = 0.002  # time step; with that of the file, a check may take for ever [s]
_MOST_ELEMENTS = 50_000
_NAMING = ("joint", "joint1", "joint2", "body1", "body2", "site", "site1", "site2")
_MAKING = ("include", "replicate", "composite", "flexcomp", "hfield", "model", "attach", "plugin")


def check_loadable(path: Path) -> None:
    """Check that a file reads no files outside its folder, and makes no more than it has elements.

    Raises:
        AssetError: It does; MuJoCo should not open it.
    """
    from lxml import etree

    root, folder = etree.parse(path).getroot(), os.path.realpath(path.parent)
    count = sum(1 for _ in root.iter())
    if count > _MOST_ELEMENTS:
        raise AssetError(f"it has {count} elements; at most {_MOST_ELEMENTS} are read")
    for element in root.iter(etree.Element):
        if element.tag in _MAKING:
            raise AssetError(f"it has <{element.tag}>, which is not loaded, as artgen never writes it")
        for key, value in element.items():
            away = element.tag == "compiler" and key.endswith("dir")
            if key.startswith("file"):
                away = not Path(os.path.realpath(path.parent / value)).is_relative_to(folder)
            if away:
                raise AssetError(f"its <{element.tag}> names {value!r:.80}, which is outside its folder")


def load_spec(path: Path) -> Any:
    """Return the MjSpec of a file, with the asset's names if the layout has others."""
    import mujoco

    check_loadable(path)
    spec, names = mujoco.MjSpec.from_file(str(path)), read_names(path.parent)
    joints = {name: own for name, (own, _) in names.joints.items() if name != own}
    for body in spec.bodies:
        body.name = names.links.get(body.name, body.name)
    for joint in spec.joints:
        joint.name = joints.get(joint.name, joint.name)
    for equality in spec.equalities if joints else ():
        equality.name1 = joints.get(equality.name1, equality.name1)
        equality.name2 = joints.get(equality.name2, equality.name2)
    for each in list(spec.tuples) if joints else ():
        spec.delete(each)  # they name joints, and nothing is read from them
    return spec


def _spec(path: Path, *, looks: bool = False) -> Any:
    spec = load_spec(path)
    spec.option.timestep = _STEP
    spec.compiler.discardvisual = not looks
    return spec


def fixed_model(path: Path, *, looks: bool = False) -> Any:
    """Load a file with the base fixed to the world; `looks` for the visual meshes as well."""
    import mujoco

    spec = _spec(path, looks=looks)
    for joint in list(spec.joints):
        if joint.type == mujoco.mjtJoint.mjJNT_FREE:
            for key in list(spec.keys):  # their positions include those of the joint
                spec.delete(key)
            spec.delete(joint)
    return spec.compile()


def room_model(path: Path, asset: Asset) -> Any:
    """Load the file of a room with each free body fixed to what carries it, which may be a drawer that moves.

    Of a room that is a part of that in the file, only the links of the part are loaded.
    """
    import mujoco
    from lxml import etree

    check_loadable(path)
    root = etree.parse(path).getroot()
    bodies = {str(each.get("name")): each for each in root.iter("body")}
    closed = [asset.joint(name).closed for name in asset.dof_names]
    poses = dict(zip(asset.links.by_name, asset.fk(np.array(closed)), strict=True))
    for joint in asset.joints:
        if joint.child in asset.loose:
            body = bodies[joint.child]
            for free in body.findall("freejoint"):
                body.remove(free)
            turn = np.zeros(9)
            mujoco.mju_quat2Mat(turn, np.array(_numbers(body, "quat", (1.0, 0.0, 0.0, 0.0))))
            placed = affine(turn.reshape(3, 3), _numbers(body, "pos", (0.0, 0.0, 0.0)))
            placed = np.linalg.inv(poses[joint.parent]) @ placed
            body.set("pos", " ".join(map(repr, placed[:3, 3].tolist())))
            body.set("quat", " ".join(map(repr, quaternion(placed).tolist())))
            bodies[joint.parent].append(body)
    _prune(root, [body for name, body in bodies.items() if name not in asset.links.by_name])
    spec = mujoco.MjSpec.from_string(etree.tostring(root, encoding="unicode"))
    spec.modelfiledir, spec.option.timestep = str(path.parent), _STEP
    spec.compiler.discardvisual = True
    return spec.compile()


def _numbers(element: Any, name: str, default: Sequence[float]) -> list[float]:
    return [float(each) for each in element.get(name, "").split()] or list(default)


def _prune(root: Any, bodies: Iterable[Any]) -> None:
    """Remove bodies from an MJCF file, with all that names them, and the keyframes, which have all joints."""
    for body in bodies:
        if body.getparent() is not None:
            body.getparent().remove(body)
    world = root.find("worldbody")
    names, meshes = {each.get("name") for each in world.iter()}, {each.get("mesh") for each in world.iter()}
    for mesh in list(root.iterfind("asset/mesh")):
        if mesh.get("name") not in meshes:
            mesh.getparent().remove(mesh)
    for section in root:
        if section.tag in ("keyframe", "custom"):
            section.clear()
        elif section.tag in ("equality", "tendon", "contact"):
            for each in list(section):
                named = (part.get(key) for part in each.iter() for key in _NAMING)
                if any(name is not None and name not in names for name in named):
                    section.remove(each)


def standing_model(path: Path) -> Any:
    """Load a file with a floor under its base, as hard as the colliders."""
    import mujoco

    spec = _spec(path)
    colliders = [geom for geom in spec.geoms if geom.contype or geom.conaffinity]
    floor = spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0.0, 0.0, 1.0])
    if colliders:
        floor.solref, floor.solimp = colliders[0].solref, colliders[0].solimp
    return spec.compile()


CHECK = "behavior"

Pieces = tuple[tuple[str, str], tuple[str, str]]
"""Link and label of the two pieces of a contact."""

_COUPLING_FLOOR = {"revolute": 2e-4, "prismatic": 2e-5}  # smaller deviations are allowed [rad or m]
_COUPLING_SHARE = 0.01  # tolerance of a follower, as a share of its range
_BRIEF = 0.05  # duration of impacts, during which the tolerance is larger [s]
_BLOW = 5.0  # factor of the tolerance during impacts
DEPTH = 0.0005
"""Depth of contacts beyond what the asset allows [m]."""

FLOOR = "the floor"
_TRAVEL = 1.0  # examined length of a slide without limits [m]


def joint_finding(
    joint: AssetJoint,
    message: str,
    hint: str = "",
    value: float | None = None,
    pose: Mapping[str, float] | None = None,
    severity: Severity = "fault",
) -> Finding:
    """Return a finding about a joint; the value is a position of the joint [rad or m]."""
    name = "" if value is None else unit(joint)
    return Finding(CHECK, message, joint.child, joint.name, value, name, pose or {}, hint, severity)


@dataclass(frozen=True, eq=False)
class JointMotion:
    """A free joint with its followers."""

    joint: AssetJoint  # the free joint
    members: tuple[AssetJoint, ...]  # the joint itself and those that follow it
    laws: tuple[AssetCoupling, ...]  # law of each member
    ratios: Array  # motion of each member per motion of the joint, at its closed position, shape (n,)
    offsets: Array  # position of each member while the joint is at 0, on the tangent there, shape (n,)
    positions: Indices  # indices of the members in MuJoCo's positions, shape (n,)
    speeds: Indices  # indices of the members in MuJoCo's velocities and forces, shape (n,)
    bodies: frozenset[int]  # MuJoCo's bodies that move with the joint
    friction: float  # dry friction of all members, felt at the joint [N m or N]
    stiffness: float  # stiffness of all springs, felt at the joint [N m/rad or N/m]
    damping: float  # damping of all members, felt at the joint [N m s/rad or N s/m]
    rest: float  # rest position of the springs, if there are springs [rad or m]
    limits: tuple[float, float]  # examined range: without limits, a full turn or one metre [rad or m]
    at: int  # index of the free joint in MuJoCo's positions
    dof: int  # index of the free joint in MuJoCo's velocities and forces

    @property
    def name(self) -> str:
        """Name of the free joint."""
        return self.joint.name

    @cached_property
    def bent(self) -> bool:
        """Whether a member belongs to a closed chain, so that its ratio changes."""
        return any(law.curve is not None for law in self.laws)

    def ratios_at(self, position: float) -> Array:
        """Return the motion of each member per motion of the joint at its position, shape (n,)."""
        return np.array([law.slope(position) for law in self.laws]) if self.bent else self.ratios

    @cached_property
    def range(self) -> float:
        """Length of the examined range [rad or m]."""
        return self.limits[1] - self.limits[0]


def owners_of(asset: Asset) -> dict[str, str]:
    """Return for each link of a room the base of the asset that it belongs to, with all that it carries."""
    base, place = asset.links[0].name, {joint.child: joint for joint in asset.joints}
    owners = {base: base}
    for link in asset.links[1:]:  # parents come before their children
        joint = place[link.name]
        owners[link.name] = link.name if joint.locked and joint.parent == base else owners[joint.parent]
    return owners


def motions_of(asset: Asset, model: Any) -> dict[str, JointMotion]:
    """Return the free joints of an asset by name, with their indices in MuJoCo's model."""
    for link in asset.links:
        model.body(link.name)  # raises KeyError for a missing link
    result = {}
    for joint in asset.free_joints:
        members, laws = zip(*led_by(asset, joint), strict=True)
        at = joint.closed
        ratios = np.array([law.slope(at) for law in laws])
        offsets = [law.offset if law.curve is None else law.at(at) - law.slope(at) * at for law in laws]
        friction, damping, springs, rests = np.array(
            [(each.friction, each.damping, each.stiffness, each.rest) for each in members]
        ).T
        stiffness = float(ratios**2 @ springs)
        found = [model.joint(member.name) for member in members]
        bodies = {int(model.body(member.child).id) for member in members}
        for body in range(model.nbody):  # parents come before their children
            if int(model.body_parentid[body]) in bodies:
                bodies.add(body)
        result[joint.name] = JointMotion(
            joint,
            members,
            laws,
            ratios,
            np.array(offsets),
            positions=np.array([each.qposadr[0] for each in found]),
            speeds=np.array([each.dofadr[0] for each in found]),
            bodies=frozenset(bodies),
            friction=float(np.abs(ratios) @ friction),
            stiffness=stiffness,
            damping=float(ratios**2 @ damping),
            rest=float(ratios @ (springs * (rests - offsets))) / stiffness if stiffness else 0.0,
            limits=joint.limits or (0.0, 2.0 * math.pi if joint.kind == "revolute" else _TRAVEL),
            at=int(found[0].qposadr[0]),
            dof=int(found[0].dofadr[0]),
        )
    return result


class UnstableError(Exception):
    """The simulation became unstable; the findings so far are kept."""


class Simulation:
    """A model of an asset with its state, and the findings during its motion.

    Attributes:
        asset: The asset.
        model: MuJoCo's model.
        data: MuJoCo's state.
        motions: The free joints by name.
        owners: The base of the asset in a room that each link belongs to; empty in an asset that is no room.
        doing: Description of the current test, for messages.
        step_time: Length of a time step [s].
        applied: Forces that act in the next time step, shape (nv,) [N m or N].
        findings: Findings about warnings and loose couplings, by kind and place.
        warnings: Warnings of MuJoCo since `collected_warnings` began.
    """

    def __init__(self, asset: Asset, model: Any, warnings: list[str]) -> None:
        import mujoco

        self.asset, self.model, self.data = asset, model, mujoco.MjData(model)
        self.doing = ""
        self.warnings = warnings
        self.motions = motions_of(asset, model)
        self._step = mujoco.mj_step
        self._mujoco = mujoco
        self.step_time = float(model.opt.timestep)
        # views of the state: accessing them takes as long as a time step of a small asset
        self._qpos, self._qvel = self.data.qpos, self.data.qvel
        self._passive, self._bias = self.data.qfrc_passive, self.data.qfrc_bias
        self.applied = self.data.qfrc_applied
        self._warned = self.data.warning.number
        self._qacc = self.data.qacc
        # inertia of all degrees of freedom when it was last needed, shape (nv, nv)
        self._inertias = np.zeros((model.nv, model.nv))
        # motion of each degree of freedom per motion of each free joint, and whether it belongs to the joint
        self._ratios = np.zeros((len(self.motions), model.nv))
        self._own = np.zeros(self._ratios.shape, bool)
        # bodies that move with each free joint, and the row of each joint
        self._moved = np.zeros((len(self.motions), model.nbody), bool)
        self._rows = {name: row for row, name in enumerate(self.motions)}
        for row, motion in enumerate(self.motions.values()):
            self._ratios[row, motion.speeds], self._own[row, motion.speeds] = motion.ratios, True
            self._moved[row, list(motion.bodies)] = True
        # number of the asset of a room that each body belongs to
        self.owners = owners_of(asset) if asset.is_room else dict.fromkeys(asset.links.by_name, "")
        bases = list(dict.fromkeys(self.owners.values()))
        self._owners = np.zeros(model.nbody, int)
        for link, owner in self.owners.items():
            self._owners[model.body(link).id] = bases.index(owner)
        self._places = {
            joint.name: int(model.joint(joint.name).qposadr[0]) for joint in asset.joints if not joint.locked
        }
        self._labels = {
            f"{link.name}_collider_{number}": collider.label
            for link in asset.links
            for number, collider in enumerate(link.colliders)
        }
        self._followers = _Followers(self.motions.values())
        self._watching = True
        self._noticed = 0
        self.findings: dict[tuple[str, str], Finding] = {}
        self._start: dict[str, float] = {}

    def sinks(self) -> bool:
        """Tell whether a part is in the floor, as deep as no contact may be."""
        deep = np.flatnonzero(np.asarray(self.data.contact.dist) < -DEPTH).tolist() if self.data.ncon else []
        return any(link == FLOOR for number in deep for link, _ in self.contact(number))

    def begin(self, q: Mapping[str, float], doing: str, *, jammed: bool = False) -> None:
        """Set all joints to rest at positions of free joints; joints without a position are closed.

        For intentionally jammed parts, couplings are not checked: one of them may give way.
        """
        self._watching = not jammed
        self._noticed = len(self.warnings)  # earlier ones belong to other motions, maybe of another model
        self._mujoco.mj_resetData(self.model, self.data)
        for name, position in self.asset.positions(q).items():
            if name in self._places:
                self.data.qpos[self._places[name]] = position
        self.doing = doing
        self._followers.lasting[:] = 0.0
        self._start = self.pose()
        self._mujoco.mj_forward(self.model, self.data)

    def step(self) -> None:
        """Make one time step.

        Raises:
            UnstableError: The state is no longer finite.
        """
        self._step(self.model, self.data)
        if len(self.warnings) > self._noticed or np.count_nonzero(self._warned):
            self._notice_warnings()
        followers = self._followers
        if followers.joints and self._watching:
            qpos = self._qpos
            off = np.abs(qpos[followers.at] - followers.wanted(qpos))
            beyond = off > followers.allowed
            if not np.count_nonzero(beyond):
                followers.lasting[:] = 0.0
                return
            followers.lasting = np.where(beyond, followers.lasting + self.step_time, 0.0)
            loose = beyond & ((followers.lasting >= _BRIEF) | (off > _BLOW * followers.allowed))
            worse = loose & (off > followers.worst)
            if worse.any():
                followers.worst[worse] = off[worse]
                self._notice_couplings(off, worse)

    def position(self, motion: JointMotion) -> float:
        """Return the position of a free joint [rad or m]."""
        return float(self._qpos[motion.at])

    def speed(self, motion: JointMotion) -> float:
        """Return the speed of a free joint [rad/s or m/s]."""
        return float(self._qvel[motion.dof])

    def pose(self) -> dict[str, float]:
        """Return the positions of the free joints [rad or m]."""
        return {name: self.position(motion) for name, motion in self.motions.items()}

    def holds(self, condition: AssetCondition) -> bool:
        """Tell whether the joint positions lie in a region."""
        locked = {joint.name: joint.closed for joint in self.asset.joints if joint.locked}
        return condition.holds({name: float(self._qpos[at]) for name, at in self._places.items()} | locked)

    def load(self, motion: JointMotion) -> float:
        """Return the force of gravity, springs and damping at a free joint, without friction [N m or N]."""
        if len(motion.members) == 1:
            return float(self._passive[motion.dof] - self._bias[motion.dof])
        ratios = motion.ratios_at(self.position(motion))
        return float(ratios @ (self._passive - self._bias)[motion.speeds])

    def pulls(self) -> Array:
        """Return `load` of each free joint and what accelerations of others add, shape (n,) [N m or N]."""
        ratios = self._present_ratios()
        self._mujoco.mj_fullM(self.model, self.data, self._inertias)
        felt = np.where(self._own, 0.0, ratios @ self._inertias)
        return np.asarray(ratios @ (self._passive - self._bias) - felt @ self._qacc)

    def inertia(self, motion: JointMotion) -> float:
        """Return the inertia of a free joint while all others are free [kg m^2 or kg]."""
        others = np.eye(self.model.nv)[~self._own.any(axis=0)]  # degrees of freedom of no free joint
        columns = np.column_stack([*self._present_ratios(), *others])
        self._mujoco.mj_fullM(self.model, self.data, self._inertias)
        index = self._rows[motion.name]
        alone = np.eye(columns.shape[1])[index]
        return 1.0 / float(np.linalg.solve(columns.T @ self._inertias @ columns, alone)[index])

    def _present_ratios(self) -> Array:
        """Return the motion of each degree of freedom per motion of each free joint, shape (n, nv)."""
        for row, motion in enumerate(self.motions.values()):
            if motion.bent:
                self._ratios[row, motion.speeds] = motion.ratios_at(self.position(motion))
        return self._ratios

    def contact(self, number: int) -> Pieces:
        """Return link and label of the two pieces of a contact; unknown labels are empty."""
        first, second = (self._piece(int(geom)) for geom in self.data.contact[number].geom)
        return first, second

    def _piece(self, geom: int) -> tuple[str, str]:
        body = int(self.model.geom_bodyid[geom])
        if body == 0:
            return FLOOR, ""
        return self.model.body(body).name, self._labels.get(self.model.geom(geom).name, "")

    def moving(self, motions: Iterable[JointMotion]) -> Mask:
        """Return the bodies that move with some of the joints, shape (nbody,)."""
        found: Mask = np.any(self._moved[[self._rows[motion.name] for motion in motions]], axis=0)
        return found

    def touching(self, motion: JointMotion, others: Mask | None = None) -> list[str]:
        """Return the pieces that press on the links of a joint, the strongest contact first.

        With `others`, shape (nbody,), only contacts with these bodies count.
        """
        if not self.data.ncon:
            return []
        bodies = self.model.geom_bodyid[self.data.contact.geom]
        inside = self._moved[self._rows[motion.name]][bodies]
        pressing = inside[:, 0] != inside[:, 1]
        if others is not None:
            pressing &= (others[bodies] & ~inside).any(axis=1)
        forces: dict[str, float] = {}
        for number in np.flatnonzero(pressing).tolist():
            wrench = np.zeros(6)
            self._mujoco.mj_contactForce(self.model, self.data, number, wrench)
            if wrench[0] > 0.0:
                text = " and ".join(piece(*each) for each in self.contact(number))
                forces[text] = forces.get(text, 0.0) + float(wrench[0])
        return sorted(forces, key=lambda text: -forces[text])[:3]

    def depth(self, motion: JointMotion) -> float:
        """Return how deep the links of a joint press into other assets of a room [m]."""
        if not self.data.ncon:
            return 0.0
        bodies = self.model.geom_bodyid[self.data.contact.geom]
        own = self._moved[self._rows[motion.name]][bodies].any(axis=1)
        others = own & (self._owners[bodies[:, 0]] != self._owners[bodies[:, 1]])
        return -float(self.data.contact.dist[others].min(initial=0.0))

    def _notice_warnings(self) -> None:
        new, self._noticed = self.warnings[self._noticed :], len(self.warnings)
        for text in new:
            kind = text.split(" at DOF")[0].split(" Time =")[0]
            message = f"MuJoCo warns while {self.doing}: {text.strip()}"
            hint = "look for parts that overlap there, or for a mass or an armature that is too small"
            finding = Finding(CHECK, message, pose=self._start, hint=hint)
            self.findings.setdefault(("warning", kind), finding)
        kinds = self._mujoco.mjtWarning
        bad = (kinds.mjWARN_BADQPOS, kinds.mjWARN_BADQVEL, kinds.mjWARN_BADQACC)
        if any(self._warned[int(kind)] for kind in bad):
            raise UnstableError

    def _notice_couplings(self, off: Array, loose: Array) -> None:
        followers = self._followers
        for number in np.flatnonzero(loose):
            joint = followers.joints[number]
            assert joint.follows is not None
            error = float(off[number])
            share = 100.0 * error / float(followers.ranges[number])
            message = (
                f"is {length(joint, error)} or {share:.2g} % of its range off the position that "
                f"{joint.follows.leader} gives it, while {self.doing}"
            )
            hint = (
                "a coupling gives way where a part stands in its way, or where what it moves is much "
                "heavier than what leads it; make room, or add armature to the leader"
            )
            finding = joint_finding(joint, message, hint, error, self.pose())
            self.findings["coupling", joint.name] = finding


class _Followers:
    """The coupled joints as arrays, one row each."""

    def __init__(self, motions: Iterable[JointMotion]) -> None:
        rows = [(motion, number) for motion in motions for number in range(1, len(motion.members))]
        self.joints = [motion.members[number] for motion, number in rows]
        self.at = np.array([motion.positions[number] for motion, number in rows], int)
        self.leaders = np.array([motion.at for motion, _ in rows], int)
        self.ratios = np.array([motion.ratios[number] for motion, number in rows])
        self.offsets = np.array([motion.offsets[number] for motion, number in rows])
        self.ranges = np.abs(self.ratios) * [motion.range for motion, _ in rows]
        laws = ((row, motion, motion.laws[number]) for row, (motion, number) in enumerate(rows))
        self._curved = [(row, law) for row, _, law in laws if law.curve is not None]
        for row, law in self._curved:
            low, high = law.span(*rows[row][0].limits)
            self.ranges[row] = high - low
        least = [_COUPLING_FLOOR[joint.kind] for joint in self.joints]
        self.allowed = np.maximum(_COUPLING_SHARE * self.ranges, least)
        self.worst, self.lasting = np.zeros(len(rows)), np.zeros(len(rows))

    def wanted(self, qpos: Array) -> Array:
        """Return the positions of the coupled joints that follow from those of their leaders."""
        result = self.ratios * qpos[self.leaders] + self.offsets
        for row, law in self._curved:
            result[row] = law.at(float(qpos[self.leaders[row]]))
        return np.asarray(result)


def piece(link: str, label: str) -> str:
    """Format a piece by its link and label."""
    return f"{link}/{label}" if label else link
