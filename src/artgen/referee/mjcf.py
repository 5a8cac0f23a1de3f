"""Reading of MJCF through MuJoCo's compiler, which runs in a process of its own."""

import itertools
import math
import xml.etree.ElementTree as ET
from collections.abc import Callable, Collection, Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array, Indices, affine
from artgen.asset import AssetJoint
from artgen.asset.coupling import AssetCoupling
from artgen.asset.joint import JointKind
from artgen.colliders import Convex
from artgen.errors import AssetError
from artgen.referee.files import MOST_LENGTH, parse_xml, read_apart, safe_path, shown
from artgen.referee.meshes import Hulls
from artgen.referee.model import ForeignBody, ForeignGeom, ForeignModel, Meshes, counted, first_of

_FREE, _BALL, _SLIDE = 0, 1, 2  # mjtJoint
_PLANE, _HFIELD, _SPHERE, _CAPSULE, _ELLIPSOID, _CYLINDER, _BOX = range(7)  # mjtGeom
_CONNECT, _WELD, _JOINT, _TENDON = range(4)  # mjtEq
_WRAP_JOINT = 1  # mjtWrap
_NOT_JUDGED = {_PLANE: "plane", _HFIELD: "height field"}
_DIRS = ("meshdir", "texturedir", "assetdir")  # attributes of <compiler>
_GRAIN = 1e-5  # by which repaired limits are narrower, relative to their size
_LOCKED = 4e-7  # half the range of a locked joint, as MuJoCo knows no equal limits [rad or m]
_MOST_INCLUDES = 200
_SOME_MASS = 1e-6  # least mass and inertia of bodies that lack them [kg, kg m^2]
_LINEAR = 1e-9  # largest coefficient of a higher power in a linear coupling
_FIELDS = (
    *("body_parentid", "body_weldid", "body_jntadr", "body_jntnum", "body_geomadr", "body_geomnum"),
    *("body_mocapid", "jnt_type", "jnt_limited", "jnt_range", "jnt_qposadr", "qpos0"),
    *("geom_type", "geom_contype", "geom_conaffinity", "geom_size", "geom_dataid"),
    *("mesh_vertadr", "mesh_vertnum", "mesh_vert", "mesh_faceadr", "mesh_facenum", "mesh_face"),
    *("eq_type", "eq_obj1id", "eq_obj2id", "eq_objtype", "eq_data", "eq_active0", "exclude_signature"),
    *("pair_geom1", "pair_geom2", "tendon_adr", "tendon_num", "wrap_type", "wrap_objid"),
    "tendon_limited",
)
_MEASURES = (  # kind of element, array of MuJoCo, and its name in messages
    ("geom", "geom_xpos", "position"),
    ("geom", "geom_xmat", "orientation"),
    ("geom", "geom_size", "size"),
    ("joint", "xanchor", "position"),
    ("joint", "xaxis", "axis"),
    ("joint", "jnt_range", "range"),
    ("equality", "eq_data", "data"),
)


def read_mjcf(path: Path, *, meshes: Meshes = "hull", root: Path) -> ForeignModel:
    """Read the bodies, colliders and joints of an MJCF file; needs MuJoCo.

    Raises:
        AssetError: The file is damaged, MuJoCo does not compile it, or it reads files outside `root`.
    """
    _check_files(path, root)
    compiled: dict[str, Any] = read_apart(_compiled, str(path), f"{path}: MuJoCo does not compile it")
    if "error" in compiled:
        raise AssetError(f"{path}: {compiled['error']}")
    counted(path, bodies=len(compiled["names"]["body"]), geoms=len(compiled["names"]["geom"]))
    _check_numbers(path, compiled)
    return _Reading(path, compiled, meshes).model()


def _check_numbers(path: Path, compiled: Mapping[str, Any]) -> None:
    """Check the numbers of a compiled model, of which MuJoCo takes any."""
    for kind, field, what in _MEASURES:
        names = compiled["names"].get(kind) or [str(number) for number in range(len(compiled[field]))]
        for name, values in zip(names, compiled[field], strict=True):
            if not (np.abs(values) <= MOST_LENGTH).all():
                given = " ".join(f"{value:g}" for value in values)
                raise AssetError(
                    f"{path}: the {what} of {kind} {shown(name)} is {given}; give finite numbers from "
                    f"{-MOST_LENGTH:g} to {MOST_LENGTH:g}, also for the bodies that hold it"
                )


def _check_files(path: Path, root: Path) -> None:
    """Check the files that an MJCF file and its includes name, before the compiler opens one."""
    # the compiler's directories may stand in any of them: each name is tried in all, and the rest left to it
    trees = {path: parse_xml(path)}
    waiting, folders = [path], {""}
    while waiting:
        current = waiting.pop()
        tree = trees[current]
        if tree.tag not in ("mujoco", "mujocoinclude"):
            raise AssetError(f"{current}: its root is <{tree.tag}>; give a file with <mujoco>")
        counted(path, bodies=_count(tree, "body"), geoms=_count(tree, "geom"))
        folders |= {value for each in tree.iter("compiler") for key, value in each.items() if key in _DIRS}
        for each in (*tree.iter("include"), *tree.iter("model")):
            for found in _named(each, path, current, {""}, root):
                if found not in trees:
                    trees[found] = parse_xml(found)
                    waiting.append(found)
        if len(trees) > _MOST_INCLUDES:
            raise AssetError(f"{path}: it includes more than {_MOST_INCLUDES} files; join some")
    for current, tree in trees.items():
        for each in tree.iter():
            if each.tag not in ("include", "model", "plugin"):
                _named(each, path, current, folders, root)


def _named(each: ET.Element, path: Path, current: Path, folders: Collection[str], root: Path) -> list[Path]:
    """Return the files that an element may mean, which must lie below `root`."""
    names = [value for key, value in each.items() if key.startswith("file") and value]
    places = [Path(folder, name) for name in names for folder in folders for name in {name, Path(name).name}]
    return [
        safe_path(str(base / place), base, root, f"{current}: <{each.tag}>")
        for place in places
        for base in {path.parent, current.parent}
        if (base / place).exists()
    ]


def _count(element: ET.Element, kind: str) -> int:
    """Return the number of elements of a kind, with those that <replicate> and others make."""
    times = math.prod(int(each) for each in element.get("count", "1").split() if each.isdigit())
    inner: int = sum(_count(child, kind) for child in element)
    made = times if element.tag in ("composite", "flexcomp") else int(element.tag == kind)
    return (times if element.tag == "replicate" else 1) * inner + made


def _compiled(path: str) -> dict[str, Any]:
    """Compile a file and return the arrays of the model and of its pose at position 0."""
    try:
        import mujoco
    except ImportError:
        return {"error": "MJCF needs MuJoCo; install artgen[referee]"}
    try:
        model = mujoco.MjModel.from_xml_path(path)
    except (ValueError, MemoryError):
        try:
            model = _colliders_only(path)
        except (ValueError, MemoryError) as error:
            return {"error": f"MuJoCo does not compile it: {' '.join(str(error).split())}"}
    data = mujoco.MjData(model)
    moving = np.isin(model.jnt_type, (_FREE, _BALL), invert=True)
    data.qpos[model.jnt_qposadr[moving]] = 0.0
    mujoco.mj_kinematics(model, data)
    names = {
        kind: [getattr(model, kind)(number).name or f"{kind}_{number}" for number in range(count)]
        for kind, count in (
            ("body", model.nbody),
            ("joint", model.njnt),
            ("geom", model.ngeom),
            ("mesh", model.nmesh),
        )
    }
    found = {name: np.array(getattr(model, name)) for name in _FIELDS}
    found |= {name: np.array(getattr(data, name)) for name in ("xanchor", "xaxis", "geom_xpos", "geom_xmat")}
    disabled = bool(model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
    soft = [f"{count} {name}" for name, count in (("flexes", model.nflex), ("skins", model.nskin)) if count]
    return found | {"names": names, "parents_collide": disabled, "soft": soft}


def _colliders_only(path: str) -> Any:
    """Compile a file without what collisions do not depend on; numbers of unnamed geoms differ then."""
    import mujoco

    spec = mujoco.MjSpec.from_file(path)
    named = {geom.name for geom in spec.geoms}
    pairs = [{pair.geomname1, pair.geomname2} for pair in spec.pairs]
    paired = {name for pair in pairs if pair <= named for name in pair}
    unwanted = [*spec.sensors, *spec.actuators, *spec.keys, *spec.skins, *spec.textures, *spec.materials]
    if not any(equality.type == mujoco.mjtEq.mjEQ_TENDON for equality in spec.equalities):
        unwanted += [each for each in spec.tendons if each.limited == mujoco.mjtLimited.mjLIMITED_FALSE]
    unwanted += [each for each, names in zip(spec.pairs, pairs, strict=True) if not names <= named]
    for each in (*spec.geoms, *spec.sites):
        each.material = ""
    unwanted += [geom for geom in spec.geoms if not (geom.contype or geom.conaffinity or geom.name in paired)]
    for each in unwanted:
        spec.delete(each)
    used = {geom.meshname for geom in spec.geoms}
    for mesh in [mesh for mesh in spec.meshes if mesh.name not in used]:
        spec.delete(mesh)
    spec.compiler.boundmass = spec.compiler.boundinertia = _SOME_MASS
    spec.compiler.balanceinertia = True
    return spec.compile()


class _Reading:
    """The conversion of a compiled model."""

    def __init__(self, path: Path, compiled: Mapping[str, Any], meshes: Meshes) -> None:
        self.path, self.compiled, self.hulls = path, compiled, Hulls(meshes)
        self.names: dict[str, list[str]] = compiled["names"]
        self.notes = [f"{', '.join(compiled['soft'])} are not judged"] if compiled["soft"] else []
        self.restricted: dict[str, str] = {}
        # geoms that no mask and no pair lets collide are visuals
        self.paired = {*compiled["pair_geom1"].tolist(), *compiled["pair_geom2"].tolist()}

    def __getattr__(self, name: str) -> Any:
        return self.compiled[name]

    def model(self) -> ForeignModel:
        """Return the model."""
        geoms = self._geoms()
        follows = self._couplings()
        bodies = tuple(self._body(number, geoms, follows) for number in range(len(self.body_parentid)))
        excluded, exempt = self._exclusions(geoms)
        return ForeignModel(self.path, "mjcf", bodies, excluded, exempt, self.restricted, tuple(self.notes))

    def _body(
        self, number: int, geoms: Mapping[int, Iterable[ForeignGeom]], follows: Mapping[int, AssetCoupling]
    ) -> ForeignBody:
        first, count = int(self.body_jntadr[number]), int(self.body_jntnum[number])
        numbers = range(first, first + count)
        kinds = [int(self.jnt_type[each]) for each in numbers]
        apart = next(
            (
                f"{'free' if kind == _FREE else 'ball'} joint {self.names['joint'][each]!r}"
                for each, kind in zip(numbers, kinds, strict=True)
                if kind in (_FREE, _BALL)
            ),
            f"mocap body {self.names['body'][number]!r}" if self.body_mocapid[number] >= 0 else "",
        )
        joints = () if apart else tuple(self._joint(each, follows.get(each)) for each in numbers)
        owned = [geom for each in self._geoms_of(number) for geom in geoms.get(each, ())]
        parent = self.names["body"][self.body_parentid[number]] if number else ""
        return ForeignBody(self.names["body"][number], tuple(owned), parent, joints, apart)

    def _joint(self, number: int, follows: AssetCoupling | None) -> AssetJoint:
        kind: JointKind = "prismatic" if self.jnt_type[number] == _SLIDE else "revolute"
        low, high = self.jnt_range[number].tolist()
        return AssetJoint(
            self.names["joint"][number],
            kind,
            self.xaxis[number],
            self.xanchor[number],
            (low, high) if self.jnt_limited[number] else None,
            follows=follows,
        )

    def _geoms_of(self, body: int) -> range:
        return range(self.body_geomadr[body], self.body_geomadr[body] + self.body_geomnum[body])

    def _geoms(self) -> dict[int, list[ForeignGeom]]:
        """Return the convex pieces of each geom that can collide."""
        collides = (self.geom_contype | self.geom_conaffinity) != 0
        left: dict[str, list[str]] = {}
        result: dict[int, list[ForeignGeom]] = {}
        for number in range(len(collides)):
            if not collides[number] and number not in self.paired:
                continue
            name, kind = self.names["geom"][number], int(self.geom_type[number])
            if kind in _NOT_JUDGED:
                left.setdefault(f"{_NOT_JUDGED[kind]}s are not judged", []).append(name)
                continue
            try:
                pieces = self._convexes(number)
            except ValueError as error:
                left.setdefault(f"geoms without a volume are not judged ({error})", []).append(name)
                continue
            ends = [""] if len(pieces) == 1 else [f"/{piece}" for piece in range(len(pieces))]
            result[number] = [ForeignGeom(name + end, each) for end, each in zip(ends, pieces, strict=True)]
        self.notes += [f"{reason}: {first_of(names)}" for reason, names in left.items()] + self.hulls.notes()
        return result

    def _convexes(self, number: int) -> list[Convex]:
        pose = affine(self.geom_xmat[number].reshape(3, 3), self.geom_xpos[number])
        a, b, c = self.geom_size[number].tolist()
        primitives: dict[int, Callable[[], Convex]] = {
            _SPHERE: lambda: Convex.sphere(a, pose),
            _CAPSULE: lambda: Convex.capsule(a, 2.0 * b, pose),
            _ELLIPSOID: lambda: Convex.sphere(1.0).transformed(pose @ np.diag([a, b, c, 1.0])),
            _CYLINDER: lambda: Convex.cylinder(a, 2.0 * b, pose),
            _BOX: lambda: Convex.box((2.0 * a, 2.0 * b, 2.0 * c), pose),
        }
        if make := primitives.get(int(self.geom_type[number])):
            return [make()]
        mesh = int(self.geom_dataid[number])
        name = self.names["mesh"][mesh]
        return [
            piece.transformed(pose) for piece in self.hulls.pieces(mesh, name, lambda: [self._mesh(mesh)])
        ]

    def _mesh(self, mesh: int) -> tuple[Array, Indices]:
        """Return vertices and triangles of a mesh in its own frame."""
        start, first = int(self.mesh_vertadr[mesh]), int(self.mesh_faceadr[mesh])
        vertices = self.mesh_vert[start : start + int(self.mesh_vertnum[mesh])].astype(np.float64)
        triangles = self.mesh_face[first : first + int(self.mesh_facenum[mesh])].astype(np.int64)
        return vertices, triangles

    def _couplings(self) -> dict[int, AssetCoupling]:
        """Return the linear couplings of joints; other constraints go to `restricted`."""
        result: dict[int, AssetCoupling] = {}
        leaders: dict[int, int] = {}
        names = self.names["joint"]
        for number in np.flatnonzero(self.eq_active0).tolist():
            kind, first, second = (
                int(each[number]) for each in (self.eq_type, self.eq_obj1id, self.eq_obj2id)
            )
            if kind != _JOINT:
                self._restrict(number, kind, first, second)
                continue
            start, ratio, *rest = self.eq_data[number, :5].tolist()
            at = [float(self.qpos0[self.jnt_qposadr[each]]) if each >= 0 else 0.0 for each in (first, second)]
            follower, reached = second, {first}
            while follower >= 0 and follower not in reached:
                reached.add(follower)
                follower = leaders.get(follower, -1)
            if second < 0 or max(map(abs, rest)) > _LINEAR or first in leaders or follower >= 0:
                self.restricted[names[first]] = f"joint equality on {names[first]!r}"
                continue
            leaders[first] = second
            result[first] = AssetCoupling(names[second], ratio, at[0] + start - ratio * at[1])
        for tendon in np.flatnonzero(self.tendon_limited).tolist():
            self.restricted |= {names[each]: "range of a tendon" for each in sorted(self._pulled(tendon))}
        return result

    def _restrict(self, number: int, kind: int, first: int, second: int) -> None:
        """Name the joints that an equality of bodies or sites restricts."""
        of_bodies = kind in (_CONNECT, _WELD) and int(self.eq_objtype[number]) == 1  # mjOBJ_BODY
        label = {_CONNECT: "connect", _WELD: "weld"}.get(kind, "tendon or other")
        chains = []
        for body in (first, second):
            chain: set[int] = set()
            while of_bodies and body > 0:
                chain.update(range(self.body_jntadr[body], self.body_jntadr[body] + self.body_jntnum[body]))
                body = int(self.body_parentid[body])  # noqa: PLW2901
            chains.append(chain)
        if of_bodies and self._is_carried(number, first, second):
            return
        loop = chains[0] ^ chains[1] if of_bodies else set(range(len(self.jnt_type)))
        if kind == _TENDON:
            loop = self._pulled(first) | self._pulled(second)
        self.restricted |= {
            self.names["joint"][each]: f"{label} equality" for each in sorted(loop) if each >= 0
        }

    def _pulled(self, tendon: int) -> set[int]:
        """Return the joints in whose positions a tendon is linear; all joints if it is not linear."""
        start, count = (self.tendon_adr[tendon], self.tendon_num[tendon]) if tendon >= 0 else (0, 0)
        wraps = range(start, start + count)
        if all(self.wrap_type[each] == _WRAP_JOINT for each in wraps):
            return {int(self.wrap_objid[each]) for each in wraps}
        return set(range(len(self.jnt_type)))

    def _is_carried(self, number: int, first: int, second: int) -> bool:
        """Tell whether one of two bodies is free, and only this equality holds it: it follows the other."""
        free = [self._free_root(body) for body in (first, second)]
        if free[0] == free[1]:
            return False
        others = [
            self._free_root(int(each[other]))
            for other in np.flatnonzero(self.eq_active0).tolist()
            if other != number and int(self.eq_type[other]) in (_CONNECT, _WELD)
            for each in (self.eq_obj1id, self.eq_obj2id)
        ]
        return any(root and root not in others for root in free)

    def _free_root(self, body: int) -> int:
        """Return the body with a free joint, or the mocap body, that carries a body; 0 if none does."""
        while body > 0:
            joints = range(self.body_jntadr[body], self.body_jntadr[body] + self.body_jntnum[body])
            if self.body_mocapid[body] >= 0 or any(self.jnt_type[each] == _FREE for each in joints):
                return body
            body = int(self.body_parentid[body])
        return 0

    def _exclusions(
        self, geoms: Mapping[int, list[ForeignGeom]]
    ) -> tuple[dict[frozenset[str], str], frozenset[frozenset[str]]]:
        """Return the pairs of bodies, and of geoms of other bodies, that MuJoCo lets not collide."""
        names = self.names["body"]
        signatures = {(int(each) >> 16, int(each) & 0xFFFF) for each in self.exclude_signature}
        explicit = set(zip(self.pair_geom1.tolist(), self.pair_geom2.tolist(), strict=True))
        weld = self.body_weldid
        parent = weld[self.body_parentid[weld]]
        excluded: dict[frozenset[str], str] = {}
        exempt = []
        having = [body for body in range(len(names)) if any(each in geoms for each in self._geoms_of(body))]
        for a, b in itertools.combinations(having, 2):
            one, two = ([each for each in self._geoms_of(body) if each in geoms] for body in (a, b))
            related = weld[a] != 0 and weld[b] != 0 and (parent[a] == weld[b] or parent[b] == weld[a])
            pairs = list(itertools.product(one, two))
            free = [pair for pair in pairs if pair in explicit or pair[::-1] in explicit]
            reason = ""
            if (a, b) in signatures or (b, a) in signatures:
                reason = "<exclude>"
            elif related and not self.compiled["parents_collide"]:
                reason = "parent and child"
            else:
                meets = (self.geom_contype[one][:, None] & self.geom_conaffinity[two]) | (
                    self.geom_conaffinity[one][:, None] & self.geom_contype[two]
                )
                free += [pair for pair, mask in zip(pairs, meets.ravel().tolist(), strict=True) if mask]
            if not free:
                excluded[frozenset((names[a], names[b]))] = reason or "contype and conaffinity"
            elif len(set(free)) < len(pairs):
                exempt += [
                    frozenset((first.name, second.name))
                    for pair in set(pairs) - set(free)
                    for first, second in itertools.product(*(geoms[each] for each in pair))
                ]
        return excluded, frozenset(exempt)


def repaired_mjcf(path: Path, limits: Mapping[str, tuple[float, float]], out: Path) -> None:
    """Write a copy of an MJCF file, its includes inside, with other joint limits [rad or m]."""
    import mujoco

    spec = mujoco.MjSpec.from_file(str(path))
    spec.compile()
    for joint in spec.joints:
        if joint.name not in limits:
            continue
        low, high = limits[joint.name]
        grain = _GRAIN * max(1.0, abs(low), abs(high))  # the file is written with six digits
        if high - low > 4.0 * grain:
            low, high = low + grain, high - grain
        else:
            low, high = (low + high) / 2.0 - _LOCKED, (low + high) / 2.0 + _LOCKED
        turns = joint.type == mujoco.mjtJoint.mjJNT_HINGE and spec.compiler.degree
        joint.range = np.degrees((low, high)) if turns else (low, high)
        joint.limited = mujoco.mjtLimited.mjLIMITED_TRUE
    out.write_text(spec.to_xml(), encoding="utf-8")
