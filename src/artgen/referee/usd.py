"""Reading of UsdPhysics through OpenUSD, which runs in a process of its own."""

import itertools
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, cast

import numpy as np
from pxr import Ar, Sdf, Tf, Usd, UsdGeom, UsdPhysics, UsdUtils
from scipy.cluster.hierarchy import DisjointSet

from artgen._arrays import Array
from artgen.asset import AssetJoint
from artgen.asset.coupling import AssetCoupling
from artgen.asset.joint import JointKind
from artgen.errors import AssetError, ExportError, nearest
from artgen.referee.files import MOST_LENGTH, check_file, read_apart, safe_path, shown
from artgen.referee.meshes import Hulls
from artgen.referee.model import ForeignBody, ForeignGeom, ForeignModel, Meshes, counted, first_of
from artgen.referee.usd_prims import (
    EVEN,
    START,
    WORLD,
    StageJoint,
    applied,
    convexes,
    fault,
    get,
    joint_frame,
    named,
    targets,
)

_MOST_LAYERS = 1_000
_MOST_PRIMS = 300_000  # instances count as often as they are used
_SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:|`")  # of a URI, or an expression with variables
_SOFT = re.compile(r"Deformable|Particle|Cloth")  # in the names of schemas
_UNKNOWN_JOINT = re.compile(r"Physx\w*Joint")
_Z_UP = {"Z": np.eye(3), "Y": np.eye(3)[:, [0, 2, 1]] * np.array([[1.0], [-1.0], [1.0]])}
_TRIGGERS = frozenset(("PhysxTriggerAPI", "PhysxTriggerStateAPI"))
_ROUND = ("Sphere", "Cylinder", "Capsule")
_SELF = ("physxArticulation:enabledSelfCollisions", "newton:selfCollisionEnabled")


def read_usd(path: Path, *, meshes: Meshes = "hull", root: Path) -> ForeignModel:
    """Read the rigid bodies, colliders and joints of a USD file, with the layers that it composes.

    Raises:
        AssetError: The file is damaged, or it composes layers outside `root`.
    """
    found = read_apart(_task, (path, meshes, root), f"{path}: OpenUSD does not read it")
    if isinstance(found, str):
        raise AssetError(found)
    return cast("ForeignModel", found)


def _task(task: tuple[Path, Meshes, Path]) -> ForeignModel | str:
    """Return the model of a file, or the error."""
    try:
        return model_of(*task)
    except AssetError as error:
        return str(error)


def model_of(path: Path, meshes: Meshes, root: Path) -> ForeignModel:
    """Read a USD file in this process; raise AssetError as `read_usd`."""
    diagnostics = UsdUtils.CoalescingDiagnosticDelegate()  # keeps warnings off the terminal
    try:
        check_file(path, path.name)
        layers = _layers(path, root)
        stage = Usd.Stage.Open(layers[0])
        return _Reading(path, stage, meshes).model()
    except AssetError:
        raise
    except Tf.ErrorException as error:
        raise AssetError(f"{path}: OpenUSD does not read it: {_line(error)}") from None
    except (TypeError, ValueError) as error:  # an attribute that is declared with a type of its own
        fault = f"an attribute has a value of a wrong type ({_line(error)}); export it again"
        raise AssetError(f"{path.name}: {fault}") from None
    finally:
        diagnostics.TakeUncoalescedDiagnostics()


def _line(error: object) -> str:
    """Return a message of OpenUSD in one line."""
    return " ".join(str(error).split())[:160]


def _layers(path: Path, root: Path) -> list[Any]:
    """Open a file and all layers that it composes, each after a check of its place."""
    found: dict[str, Any] = {}
    waiting = [str(path.absolute())]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        if len(found) >= _MOST_LAYERS:
            raise AssetError(f"{path.name}: it composes more than {_MOST_LAYERS} layers; flatten it")
        layer = None
        with suppress(Tf.ErrorException):
            opened = Sdf.Layer.FindOrOpen(name)
            layer = opened if opened and opened.Reload(force=True) else None  # an open one may be older
        file = Path(name.partition("[")[0])
        if layer is None:
            raise AssetError(f"{path.name}: {shown(file.name)} cannot be read as USD; export it again")
        found[name] = layer
        for asset in filter(None, layer.GetCompositionAssetDependencies()):  # none for the layer itself
            where = f"{path.name}: the layer {shown(asset)} of {shown(file.name)}"
            target = Sdf.Layer.SplitIdentifier(asset)[0]
            if _SCHEME.match(target):
                raise AssetError(f"{where} is no path of a file; copy it to one")
            resolved = Ar.GetResolver().Resolve(Sdf.ComputeAssetPathRelativeToLayer(layer, target))
            package, _ = Ar.SplitPackageRelativePathOuter(str(resolved))
            checked = safe_path(package or target, file.parent, root, where)
            # links stay: OpenUSD finds the layers of a layer beside the link, not beside its target
            waiting.append(str(resolved) or str(checked))
        layer.Traverse(Sdf.Path.absoluteRootPath, partial(_refuse_clips, layer))
    return list(found.values())


def _refuse_clips(layer: Any, path: Any) -> None:
    if (path.IsPrimPath() or path.IsPrimVariantSelectionPath()) and layer.GetObjectAtPath(path).HasInfo(
        "clips"
    ):
        raise AssetError(f"{layer.GetDisplayName()}: {path} has value clips, which are not read; flatten it")


class _Reading:
    """The conversion of a stage."""

    def __init__(self, path: Path, stage: Any, meshes: Meshes = "hull") -> None:
        self.path, self.stage, self.hulls = path, stage, Hulls(meshes)
        self.left: dict[str, list[str]] = {}  # what is not judged, by the reason
        self.restricted: dict[str, str] = {}
        self.excluded: dict[frozenset[str], str] = {}
        self.exempt: set[frozenset[str]] = set()
        self.length, up = UsdGeom.GetStageMetersPerUnit(stage), str(UsdGeom.GetStageUpAxis(stage))
        if not 0.0 < self.length < np.inf:
            raise AssetError(f"{path.name}: metersPerUnit is {self.length:g}; give a positive number")
        if up not in _Z_UP:
            raise AssetError(f"{path.name}: upAxis is {shown(up)}; give Y or Z")
        self.base = np.eye(4)
        self.base[:3, :3] = self.length * _Z_UP[up]
        self.cache = UsdGeom.XformCache(START)
        self.prims = list(self._visited())
        having = [prim for prim in self.prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
        having = [prim for prim in having if get(prim, "physics:rigidBodyEnabled", True)]
        self.colliding = [prim for prim in self.prims if self._collides(prim)]
        counted(path.name, bodies=len(having), geoms=len(self.colliding))
        self.bodies = named(having)
        fixed = (prim for prim in having if get(prim, "physics:kinematicEnabled", False))
        self.fixed = [WORLD, *(self.bodies[prim.GetPath()] for prim in fixed)]
        self.owner: dict[Any, str] = {}  # the body of each prim
        for place in (prim.GetPath() for prim in self.prims):
            self.owner[place] = self.bodies.get(place) or self.owner.get(place.GetParentPath(), WORLD)
        joints = named(prim for prim in self.prims if prim.IsA(UsdPhysics.Joint))
        each = [(stage.GetPrimAtPath(place), name) for place, name in joints.items()]
        self.joints = [self._joint(*one) for one in each if get(one[0], "physics:jointEnabled", True)]

    def _visited(self) -> Iterator[Any]:
        """Yield the prims of the stage, and note those of unknown types."""
        prims = iter(Usd.PrimRange(self.stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()))
        for number, prim in enumerate(prims):
            if number >= _MOST_PRIMS:
                raise AssetError(
                    f"{self.path.name}: with its instances, it has more than {_MOST_PRIMS} prims"
                )
            if prim.IsA(UsdGeom.PointInstancer):
                self._leave("point instancers are not judged", prim.GetName())
                prims.PruneChildren()
                continue
            if _UNKNOWN_JOINT.fullmatch(prim.GetTypeName()) and not prim.IsA(UsdPhysics.Joint):
                self._leave("joints of types that OpenUSD does not know are not judged", prim.GetName())
            yield prim

    def _collides(self, prim: Any) -> bool:
        if any(_SOFT.search(schema) for schema in applied(prim)):
            self._leave("soft bodies and particles are not judged", prim.GetName())
            return False
        if not _TRIGGERS.isdisjoint(applied(prim)):
            self._leave("trigger volumes, which nothing touches, are not judged", prim.GetName())
            return False
        return bool(prim.HasAPI(UsdPhysics.CollisionAPI) and get(prim, "physics:collisionEnabled", True))

    def _leave(self, reason: str, name: str) -> None:
        self.left.setdefault(reason, []).append(name)

    def _placed(self, prim: Any) -> Array:
        """Return the transform of a prim to the world, with z up, shape (4, 4) [m]."""
        matrix: Array = self.base @ np.array(self.cache.GetLocalToWorldTransform(prim)).T
        if not np.isfinite(matrix).all():
            raise fault(prim, "its transform has numbers that are not finite; correct its xformOps")
        return matrix

    def _joint(self, prim: Any, name: str) -> StageJoint:
        places: list[Any] = []
        frames = []
        for end in (0, 1):
            found = targets(prim, f"physics:body{end}")
            if len(found) > 1:
                raise fault(prim, f"its body{end} names {len(found)} prims; give one")
            if found and found[0] not in self.owner:
                raise fault(prim, f"its body{end} is {found[0]}, which is no prim of the stage; name a body")
            matrix = self._placed(self.stage.GetPrimAtPath(found[0])) if found else self.base
            places.append(found[0] if found else None)
            frames.append(joint_frame(prim, end, matrix))
        return StageJoint(prim, name, (places[0], places[1]), (frames[0], frames[1]), self.length)

    def _ends(self, joint: StageJoint) -> tuple[str, str]:
        """Return the bodies that a joint connects."""
        one, two = (WORLD if place is None else self.owner[place] for place in joint.targets)
        return one, two

    def _grow(self) -> None:
        """Choose the joints of the trees, and how each body moves from its authored pose to 0."""
        names = dict.fromkeys((*self.bodies.values(), *self.fixed))
        groups = DisjointSet(names)
        for name in self.fixed:
            groups.merge(WORLD, name)
        self.at: dict[str, list[StageJoint]] = {name: [] for name in names}
        closing = []
        for joint in sorted(self.joints, key=_rank):
            ends = self._ends(joint)
            if groups.connected(*ends) or joint.motion == "distance":
                closing.append(joint)
                continue
            groups.merge(*ends)
            for name in ends:
                self.at[name].append(joint)
        self.group = {name: groups[name] for name in names}
        self.above: dict[str, tuple[str, StageJoint]] = {}  # parent and joint of each body
        self.moves = {name: np.eye(4) for name in self.fixed}
        self._span(self.fixed)
        self.free: list[str] = []  # roots of trees that are free
        for name in self._candidates():
            if name not in self.moves:
                self.free.append(name)
                self.moves[name] = np.eye(4)
                self._span([name])
        for joint in closing:
            self._close(joint)

    def _candidates(self) -> Iterator[str]:
        """Yield all bodies, first those that are the root of an articulation or no joint's second body."""
        for place, name in self.bodies.items():
            if self.stage.GetPrimAtPath(place).HasAPI(UsdPhysics.ArticulationRootAPI):
                yield name
        second = {self._ends(joint)[1] for joint in self.joints}
        yield from sorted(self.bodies.values(), key=lambda name: name in second)

    def _span(self, found: Iterable[str]) -> None:
        """Place the bodies that joints connect to those that are found, at position 0."""
        waiting = list(found)
        for name in waiting:
            for joint in self.at[name]:
                ends = self._ends(joint)
                way = 1 if ends[0] == name else -1
                other = ends[way > 0]
                if other in self.moves:
                    continue
                before, after = joint.frames[::way]
                step = before @ np.linalg.inv(after)
                if joint.motion == "apart" or np.abs(step - np.eye(4)).max() <= EVEN:
                    step = np.eye(4)
                elif not joint.meets():
                    self._leave("bodies are placed where the frames of their joints meet", other)
                self.above[other] = name, joint
                self.moves[other] = self.moves[name] @ step
                waiting.append(other)

    def _close(self, joint: StageJoint) -> None:
        """Name the joints of the loop that a joint closes."""
        ends = self._ends(joint)
        loop: set[StageJoint] = set()
        for name in ends if self.group[ends[0]] == self.group[ends[1]] else ():
            while name in self.above:
                name, step = self.above[name]  # noqa: PLW2901
                loop ^= {step}
        moving = sorted(each.name for each in loop if each.moves)
        distance = joint.motion == "distance"
        label = f"distance joint {joint.name!r}" if distance else f"loop that joint {joint.name!r} closes"
        self.restricted |= dict.fromkeys(moving, label)
        reason = "joints close loops and are not judged; poses that they forbid are" if moving else ""
        reason = reason or "joints between bodies that are fixed to each other are ignored"
        self._leave("distance joints are not judged" if distance else reason, joint.name)

    def model(self) -> ForeignModel:
        """Return the model."""
        self._grow()
        self._shape()
        follows = self._couplings()
        order = [*self.fixed, *self.free, *self.above]
        bodies = [self._body(name, follows) for name in order if name != WORLD or WORLD in self.geoms]
        self._exclude()
        self._exclude_groups()
        excluded = {pair: reason for pair, reason in self.excluded.items() if len(pair) == 2}
        notes = self.hulls.notes()
        for reason, names in self.left.items():
            notes.append(f"{reason} ({len(names)}): {first_of(names)}")
        faults = self.stage.GetCompositionErrors()
        if faults:
            notes.append(f"OpenUSD composes it with {len(faults)} errors: {_line(faults[0])}")
        exempt = frozenset(self.exempt)
        return ForeignModel(self.path, "usd", tuple(bodies), excluded, exempt, self.restricted, tuple(notes))

    def _body(self, name: str, follows: Mapping[str, AssetCoupling]) -> ForeignBody:
        geoms = tuple(self.geoms.get(name, ()))
        if name not in self.above:
            return ForeignBody(name, geoms, apart=f"free body {name!r}" if name in self.free else "")
        above, joint = self.above[name]
        parent = "" if above == WORLD else above
        if not joint.moves:
            return ForeignBody(name, geoms, parent, apart=joint.why)
        way = 1 if self._ends(joint)[0] == above else -1
        frame = self.moves[above] @ joint.frames[::way][0]
        axis, kind = way * frame[:3, joint.column], cast("JointKind", joint.motion)
        known = np.isfinite(joint.limits())
        if known.any() and not known.all():
            self._leave("joints with one limit only are judged without limits", joint.name)
        limits = joint.limits() if known.all() else None
        step = AssetJoint(joint.name, kind, axis, frame[:3, 3], limits, follows=follows.get(joint.name))
        return ForeignBody(name, geoms, parent, (step,))

    def _couplings(self) -> dict[str, AssetCoupling]:
        """Return the couplings of joints; those that cannot be said go to `restricted`."""
        moving = {joint.prim.GetPath(): joint for _, joint in self.above.values() if joint.moves}
        result: dict[str, AssetCoupling] = {}
        for joint in moving.values():
            for target, ratio, offset in itertools.islice(joint.laws(moving), 1):
                leader = moving[target].name if target in moving else ""
                reached = leader
                while reached != joint.name and reached in result:
                    reached = result[reached].leader
                if leader and reached != joint.name and np.isfinite((ratio, offset)).all():
                    result[joint.name] = AssetCoupling(leader, ratio, offset)
                else:
                    self.restricted[joint.name] = f"coupling to {target.name!r}"
        return result

    def _shape(self) -> None:
        """Make the convex pieces of each collider."""
        self.geoms: dict[str, list[ForeignGeom]] = {}
        self.pieces: dict[Any, list[str]] = {}  # names of the geoms of each collider
        for place, name in named(self.colliding).items():
            prim, owner = self.stage.GetPrimAtPath(place), self.owner[place]
            try:
                pieces = convexes(prim, self.moves[owner] @ self._placed(prim), self.hulls)
            except AssetError:
                raise
            except ValueError as error:
                self._leave(f"colliders without a volume are not judged ({error})", name)
                continue
            if not pieces:
                self._leave(f"colliders of the type {prim.GetTypeName() or 'unknown'} are not judged", name)
            if prim.GetTypeName() in _ROUND and any(piece.kind == "hull" for piece in pieces):
                reason = "round colliders are judged as their uneven scales stretch them; many simulators"
                self._leave(f"{reason} keep them round, with the largest scale", name)
            if any(not np.abs(piece.bounds()).max() <= MOST_LENGTH for piece in pieces):
                raise fault(prim, f"it reaches beyond {MOST_LENGTH:g} m; reduce it")
            ends = [""] if len(pieces) == 1 else [f"/{number}" for number in range(len(pieces))]
            found = [ForeignGeom(name + end, each) for end, each in zip(ends, pieces, strict=True)]
            self.geoms.setdefault(owner, []).extend(found)
            self.pieces[place] = [geom.name for geom in found]
        counted(self.path.name, geoms=sum(map(len, self.pieces.values())))
        seen = {self.owner[prim.GetPath()] for prim in self.prims if prim.IsA(UsdGeom.Gprim)}
        for name in self.bodies.values():
            if name in seen and not self.geoms.get(name):
                self._leave("bodies without a collider are not judged", name)

    def _exclude(self) -> None:
        """Find what joints, filtered pairs and articulations keep from colliding."""
        for joint in self.joints:
            if get(joint.prim, "physics:collisionEnabled", False) or None in joint.targets:
                continue
            reason = f"joint {joint.name!r} disables collision between its bodies"
            self._separate(joint.targets, self._ends(joint), reason)
        for prim in self.prims:
            if prim.HasAPI(UsdPhysics.FilteredPairsAPI):
                for target in targets(prim, "physics:filteredPairs"):
                    ends = prim.GetPath(), target
                    reason = f"filtered pairs of {prim.GetName()!r}"
                    self._separate(ends, [self.bodies.get(each, "") for each in ends], reason)
            if prim.HasAPI(UsdPhysics.ArticulationRootAPI) and not all(
                get(prim, each, True) for each in _SELF
            ):
                self._separate_articulation(prim)

    def _separate(self, places: Iterable[Any], names: Iterable[str], reason: str) -> None:
        """Exclude two bodies; or, of the world and prims that are no body, the colliders below the prims."""
        pair = frozenset(names)
        if pair.isdisjoint((WORLD, "")):
            self.excluded.setdefault(pair, reason)
            return
        self._exempt(*(self._within(place, name) for place, name in zip(places, names, strict=True)))

    def _within(self, place: Any, name: str) -> list[tuple[str, str]]:
        """Return body and geom of the colliders of a body; of those below a prim for the world or no body."""
        return [
            (self.owner[each], geom)
            for each, geoms in self.pieces.items()
            if name in ("", self.owner[each]) and (name not in ("", WORLD) or each.HasPrefix(place))
            for geom in geoms
        ]

    def _exempt(self, one: Iterable[tuple[str, str]], two: Iterable[tuple[str, str]]) -> None:
        self.exempt |= {frozenset((a[1], b[1])) for a, b in itertools.product(one, two) if a[0] != b[0]}

    def _separate_articulation(self, root: Any) -> None:
        """Exclude the pairs of bodies of an articulation that does not collide with itself."""
        place, reason = root.GetPath(), f"articulation {root.GetName()!r} has no self-collisions"
        inside = {name for each, name in self.bodies.items() if each.HasPrefix(place)}
        inside |= {name for joint in self.joints if joint.prim == root for name in self._ends(joint)}
        groups = {self.group[name] for name in inside}
        bodies = [name for name in self.geoms if name != WORLD and self.group[name] in groups]
        for pair in itertools.combinations(bodies, 2):
            if self.group[pair[0]] == self.group[pair[1]]:
                self.excluded.setdefault(frozenset(pair), reason)

    def _exclude_groups(self) -> None:
        """Find the pairs that collision groups keep from colliding."""
        groups = [
            UsdPhysics.CollisionGroup(prim) for prim in self.prims if prim.IsA(UsdPhysics.CollisionGroup)
        ]
        queries = {
            group.GetPath(): group.GetCollidersCollectionAPI().ComputeMembershipQuery() for group in groups
        }
        having: dict[str, dict[tuple[Any, ...], list[tuple[str, str]]]] = {}  # geoms by body and their groups
        for place, geoms in self.pieces.items() if groups else ():
            inside = tuple(group for group, query in queries.items() if query.IsPathIncluded(place))
            kept = having.setdefault(self.owner[place], {}).setdefault(inside, [])
            kept += [(self.owner[place], geom) for geom in geoms]
        table = UsdPhysics.CollisionGroup.ComputeCollisionGroupTable(self.stage)
        for one, two in itertools.combinations(having, 2):
            pairs = list(itertools.product(having[one], having[two]))
            apart = [
                each
                for each in pairs
                if not all(table.IsCollisionEnabled(a, b) for a, b in itertools.product(*each))
            ]
            if len(apart) == len(pairs):
                self.excluded.setdefault(frozenset((one, two)), "collision groups")
                continue
            for a, b in apart:
                self._exempt(having[one][a], having[two][b])


def _rank(joint: StageJoint) -> tuple[bool, bool, bool]:
    """Return the key by which joints become part of a tree: fixed ones first, they leave fewer loops."""
    excluded = bool(get(joint.prim, "physics:excludeFromArticulation", False))
    return excluded, joint.motion == "apart", joint.moves


def repaired_usd(path: Path, limits: Mapping[str, tuple[float, float]], out: Path) -> None:
    """Write a layer over a USD file that has other joint limits [rad or m].

    Raises:
        AssetError: A joint is unknown or has no limits, limits are inverted, or the layer is the file itself,
            in another folder, or named .usdz, which cannot hold it.
        ExportError: The layer cannot be written.
    """
    if out.resolve().parent != path.resolve().parent or out.resolve() == path.resolve():
        raise AssetError(f"{out} must be another file in the folder of {path}, which it lies over")
    if out.suffix.lower() == ".usdz":
        raise AssetError(f"cannot write {out}: a layer over another file is no package; name it .usda")
    stage = Usd.Stage.Open(str(path))
    stage.Reload()  # open layers may be older than the files
    below, layer = stage.GetRootLayer(), Sdf.Layer.CreateAnonymous(".usda")
    for key in below.pseudoRoot.ListInfoKeys():  # a stage takes its units from its first layer only
        if not key.startswith("subLayer"):
            layer.pseudoRoot.SetInfo(key, below.pseudoRoot.GetInfo(key))
    relative = Path(os.path.relpath(path.absolute(), out.absolute().parent))
    layer.subLayerPaths.append(f"./{relative.as_posix()}")
    joints = {joint.name: joint for joint in _Reading(path, stage).joints if joint.ends}
    for name, (low, high) in limits.items():
        joint = _limited(path, joints, name, low, high)
        for place in joint.prim.GetPath().GetPrefixes():
            if stage.GetPrimAtPath(place).IsInstance():  # overrides do not reach into instances
                Sdf.CreatePrimInLayer(layer, place).instanceable = False
        prim = Sdf.CreatePrimInLayer(layer, joint.prim.GetPath())
        for end, value in zip(joint.ends, _single(low / joint.unit, high / joint.unit), strict=True):
            Sdf.AttributeSpec(prim, end, Sdf.ValueTypeNames.Float).default = value
    _write(layer, out)


def _write(layer: Any, out: Path) -> None:
    try:
        if out.suffix.lower() == ".usdc":
            layer.Export(str(out))
        else:
            out.write_text(layer.ExportToString(), encoding="utf-8")
    except (OSError, Tf.ErrorException) as error:
        raise ExportError(f"cannot write {out}: {_line(error)}") from None


def _limited(path: Path, joints: Mapping[str, StageJoint], name: str, low: float, high: float) -> StageJoint:
    """Return the joint that gets other limits, after a check of them."""
    if name not in joints:
        raise AssetError(f"{path.name} has no joint {shown(name)} with limits.{nearest(name, joints)}")
    if not -np.inf < low <= high < np.inf:
        raise AssetError(f"joint {shown(name)} cannot have the limits {low:g}, {high:g}: low before high")
    return joints[name]


def _single(low: float, high: float) -> tuple[float, float]:
    """Return limits in single precision, within the given ones where the numbers permit it."""
    one, two = float(np.float32(low)), float(np.float32(high))
    first = float(np.nextafter(np.float32(one), np.float32(np.inf))) if one < low else one
    last = float(np.nextafter(np.float32(two), np.float32(-np.inf))) if two > high else two
    return (first, last) if first <= last else (one, two)
